"""Profiles against PyYAML and the real rtsprofile: each reads what the other writes.

`tests/run --compat` runs this, in an environment of its own with both packages from the package index.
"""
import glob
import os
import random
import re
import sys
import unittest

TESTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path[:0] = [os.path.dirname(TESTS), os.path.join(TESTS, "support")]

try:
    import yaml as pyyaml
    from rtsprofile.rts_profile import RtsProfile
except ImportError:
    raise unittest.SkipTest("needs PyYAML and rtsprofile-aist; see tests/run --compat")

import random_profiles  # noqa: E402
from rtshell_lite import errors  # noqa: E402
from rtshell_lite.xmlprofile import fields, model, rtsprofile  # noqa: E402
from rtshell_lite.xmlprofile.yaml import reader, scalars, writer  # noqa: E402

COUNT = int(os.environ.get("RTSHELL_FUZZ", 1500))
# what rtsprofile-aist reads and does not keep
UNKNOWN = ("groups", "participants", "version_up_logs", "systems", "further_ends", "one_port_connectors")


class Loader(pyyaml.SafeLoader):
    """PyYAML, but dates are text."""


Loader.yaml_implicit_resolvers = {
    first: [pair for pair in pairs if pair[0] != "tag:yaml.org,2002:timestamp"]
    for first, pairs in pyyaml.SafeLoader.yaml_implicit_resolvers.items()}
Loader.add_constructor("tag:yaml.org,2002:timestamp", lambda loader, node: node.value)


def theirs(text):
    return pyyaml.load(text, Loader)


def ours(text):
    return scalars.plain(reader.parse(text, "a.yaml")[1])


def styles(rng):
    """Options for PyYAML's writer."""
    return dict(
        default_flow_style=rng.choice([False, True, None]),
        default_style=rng.choice([None, None, '"', "'", "|", ">"]),
        allow_unicode=rng.random() < 0.5,
        width=rng.choice([None, 10, 80, 1000]),
        indent=rng.choice([None, 2, 4, 7]),
        explicit_start=rng.random() < 0.2 or None,
        explicit_end=rng.random() < 0.2 or None,
        line_break=rng.choice([None, "\r\n", "\r"]),
    )


PIECES = [
    "a",
    "b",
    ": ",
    ":",
    "- ",
    "-",
    "\n",
    "\n  ",
    "\n    ",
    " ",
    "'",
    '"',
    "#",
    " #",
    "|\n",
    ">-\n",
    "&a ",
    "*a",
    "!!str ",
    "? ",
    "1",
    "~",
    "\\",
]


class PyYAML(unittest.TestCase):
    def test_files_that_it_writes_are_read(self):
        rng = random.Random(1)
        maker = random_profiles.Maker(1)
        compared = 0
        for _ in range(COUNT):
            data = maker.data()
            if rng.random() < 0.2:
                shared = [{"a": 1}, ["b"]]
                data = {"x": data, "y": shared, "z": shared[0], "w": [shared[1], shared[1]]}
            style = styles(rng)
            text = pyyaml.safe_dump(data, **style)
            # keys of several lines, and long ones: not in profiles
            if not re.search(r"(^|[\n\r\x85\u2028\u2029{,])[ -]*\? ", text):
                compared += 1
                self.assertTrue(fields.same(ours(text), theirs(text)), (style, text))
        self.assertGreater(compared, COUNT / 2)

    def test_it_reads_files_that_we_write(self):
        maker = random_profiles.Maker(2)
        for _ in range(COUNT):
            data = maker.data()
            text = writer.write(data)
            self.assertTrue(fields.same(theirs(text), data), text)

    def test_files_mean_the_same_to_it(self):
        for path in glob.glob(os.path.join(glob.escape(TESTS), "data", "valid", "*.yaml")):
            with open(path, "rb") as file:
                data = file.read()
            self.assertTrue(fields.same(ours(data), theirs(data)), path)

    def test_blocks_that_it_refuses_are_refused(self):
        """In flow style we read a few things that PyYAML refuses, such as a question mark inside a word."""
        rng = random.Random(3)
        for _ in range(COUNT):
            text = "".join(rng.choice(PIECES) for _ in range(rng.randint(1, 14)))
            try:
                data = ours(text)
            except (errors.BadProfile, ValueError):
                continue
            with self.subTest(text):
                wanted = theirs(text)
                # keys and numbers of base 60 are text here
                if "\n: " not in text and not re.search(r"\d:\d", text):
                    self.assertTrue(fields.same(data, keyed_by_text(wanted)), (data, wanted))


def keyed_by_text(data):
    if isinstance(data, dict):
        return {"~" if key is None else str(key): keyed_by_text(value) for key, value in data.items()}
    return [keyed_by_text(item) for item in data] if isinstance(data, list) else data


class Modest(random_profiles.Maker):
    """Profiles that rtsprofile can hold; it loses the rest, or fails."""

    def text(self):
        text = random_profiles.Maker.text(self)
        text = "".join(c for c in text if c.isprintable())
        return text.replace("_", "").strip() or "x"

    def date(self):
        return "%04d-03-05T14:07:09" % self.random.randint(1990, 2030)

    def foreign(self, cls):
        return None

    def value(self, field):
        if field.choices:
            return field.default  # it writes every composite type as None
        return random_profiles.Maker.value(self, field)

    def element(self, cls, most=2):
        element = random_profiles.Maker.element(self, cls, most)
        for field in cls.FIELDS:
            value = getattr(element, field.name)
            if value == "" and (field.always or field.kind == fields.DATE):
                setattr(element, field.name, self.value(field))
            if field.name in UNKNOWN:
                setattr(element, field.name, [])
            if field.name in ("initializing", "finalizing"):
                setattr(element, field.name, None)
        for number, item in enumerate(getattr(element, "properties", [])):
            item.name = "%d %s" % (number, item.name)  # it keeps one of those with the same name
        if isinstance(element, model.Component):
            element.location = element.location or self.element(model.Location)
        if isinstance(element, model.Connector):
            element.source = element.source or self.element(model.TargetPort)
            element.target = element.target or self.element(model.TargetPort)
        if isinstance(element, model.Preceding):
            element.sending_timing = "SYNC"
        if isinstance(element, (model.Condition, model.TargetExecutionContext, model.TargetComponent)):
            element.properties = []
        if isinstance(element, model.Condition) and element.wait_time:
            element.preceding = None
        return element


class Rtsprofile(unittest.TestCase):
    def check(self, profile):
        xml, text = (rtsprofile.dump(profile, form) for form in (rtsprofile.XML, rtsprofile.YAML))
        real = RtsProfile(xml_spec=xml)
        self.assertEqual(rtsprofile.load(real.save_to_xml(), "theirs.xml"), profile)
        self.assertEqual(rtsprofile.load(real.save_to_yaml(), "theirs.yaml"), profile)
        self.assertEqual(rtsprofile.load(RtsProfile(yaml_spec=text).save_to_xml(), "theirs.xml"), profile)

    def test_both_directions(self):
        for seed in range(COUNT // 10):
            self.check(Modest(seed).profile())

    def test_more_than_two_ends_do_not_disturb_it(self):
        maker = Modest(1)
        connector = maker.element(model.DataPortConnector)
        connector.further_ends = [maker.element(model.TargetPort)]
        profile = model.RtsProfile(id="a", creation_date=maker.date(), update_date=maker.date())
        profile.data_port_connectors = [connector]
        for form, keyword in ((rtsprofile.XML, "xml_spec"), (rtsprofile.YAML, "yaml_spec")):
            real = RtsProfile(**{keyword: rtsprofile.dump(profile, form)})
            self.assertEqual(
                real.data_port_connectors[0].target_data_port.port_name, connector.target.port_name
            )

    def test_foreign_parts_do_not_disturb_it(self):
        for seed in range(COUNT // 10):
            profile = Modest(seed).profile()
            profile.foreign = random_profiles.Maker(seed).foreign(model.RtsProfile) or None
            self.assertEqual(RtsProfile(xml_spec=rtsprofile.dump(profile, rtsprofile.XML)).id, profile.id)
            self.assertEqual(RtsProfile(yaml_spec=rtsprofile.dump(profile, rtsprofile.YAML)).id, profile.id)

    def test_dates_with_fraction_and_zone_do_not_disturb_it(self):
        profile = model.RtsProfile(
            id="a", creation_date="2008-12-19T19:44:06.450+09:00", update_date="2008-12-19T19:44:06Z"
        )
        self.assertEqual(RtsProfile(yaml_spec=rtsprofile.dump(profile, rtsprofile.YAML)).id, "a")


if __name__ == "__main__":
    unittest.main()
