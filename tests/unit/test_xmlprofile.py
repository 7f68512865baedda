"""RtsProfile files: what others write is read, nothing is lost on the way, what is broken is refused with its
place.

A file dropped into tests/data/valid is read and must come back the same from both forms; with another of the
same name and the other form beside it, both must say the same. One dropped into tests/data/invalid must be
refused, with the message in NAME.error if there is one. Real files are taken from $RTSHELL_PROFILES or from
shared/data/profiles beside the repository.
"""
import copy
import gc
import glob
import os
import re
import sys
import unittest

import random_profiles
from rtshell_lite import errors
from rtshell_lite.xmlprofile import escape, fields, model, names, rtsprofile

TESTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DATA = os.path.join(TESTS, "data")
FORMS = (rtsprofile.XML, rtsprofile.YAML)
NAMESPACES = " ".join('xmlns:%s="%s"' % pair for pair in sorted(names.NAMESPACES.items()))


def files(kind):
    return sorted(
        path
        for path in glob.glob(os.path.join(glob.escape(DATA), kind, "*"))
        if path.endswith((".xml", ".yaml"))
    )


def real_files():
    """Profiles of real systems; none where the folder is missing."""
    places = [os.environ["RTSHELL_PROFILES"]] if os.environ.get("RTSHELL_PROFILES") else []
    above = TESTS
    while above != os.path.dirname(above):
        above = os.path.dirname(above)
        places.append(os.path.join(above, "shared", "data", "profiles"))
    found = [place for place in places if os.path.isdir(place)]
    return sorted(glob.glob(os.path.join(glob.escape(found[0]), "*.*"))) if found else []


def content(path):
    with open(path, "rb") as file:
        return file.read()


def load(path, form=None):
    return rtsprofile.load(content(path), os.path.basename(path), form)


def read_xml(inside, attributes=""):
    return rtsprofile.load(
        '<rts:RtsProfile %s rts:id="a" %s>%s</rts:RtsProfile>' % (NAMESPACES, attributes, inside), "a.xml"
    )


class Files(unittest.TestCase):
    def check_round_trips(self, profile, name):
        for form in FORMS:
            text = rtsprofile.dump(profile, form)
            again = rtsprofile.load(text, "%s written as %s" % (name, form))
            self.assertEqual(again, profile)
            for other in FORMS:
                wanted = rtsprofile.dump(profile, other)
                if form == rtsprofile.YAML:  # which has no place for the comments of XML
                    wanted = re.sub("\n *<!--.*?-->", "", wanted, flags=re.DOTALL)
                self.assertEqual(rtsprofile.dump(again, other), wanted, "the same bytes")

    def test_valid_files_come_back_from_both_forms(self):
        for path in files("valid"):
            if not os.path.exists(os.path.splitext(path)[0] + ".json"):  # those are test_yaml's
                with self.subTest(os.path.basename(path)):
                    self.check_round_trips(load(path), path)

    def test_files_of_one_name_say_the_same(self):
        pairs = [(path, path[:-4] + ".yaml") for path in files("valid") if path.endswith(".xml")]
        pairs = [pair for pair in pairs if os.path.exists(pair[1])]
        self.assertTrue(pairs)
        for one, other in pairs:
            with self.subTest(os.path.basename(one)):
                self.assertEqual(load(one), load(other))

    def test_invalid_files_are_refused_with_their_place(self):
        for path in files("invalid"):
            with self.subTest(os.path.basename(path)):
                with self.assertRaises(errors.BadProfile) as caught:
                    load(path)
                name, line, column, reason = caught.exception.args
                self.assertEqual(
                    (name, line > 0, column > 0, bool(reason)), (os.path.basename(path), True, True, True)
                )
                if os.path.exists(path + ".error"):
                    self.assertEqual(str(caught.exception) + "\n", content(path + ".error").decode())

    def test_real_files_come_back_from_both_forms(self):
        if not real_files():
            self.skipTest("no real profiles: RTSHELL_PROFILES is not set and no shared/data/profiles is near")
        for path in real_files():
            with self.subTest(os.path.basename(path)):
                profile = load(path)
                self.check_round_trips(profile, path)
                self.assertIsNone(profile.foreign, "the schema knows all that real files hold")
                self.assertEqual(profile.version, "0.2")

    def test_a_profile_cut_anywhere_is_refused(self):
        data = content(os.path.join(DATA, "valid", "as-rtcryo-writes.xml"))
        for end in range(len(data.rstrip())):
            with self.assertRaises(errors.BadProfile):
                rtsprofile.load(data[:end], "cut", rtsprofile.XML)


class Random(unittest.TestCase):
    def test_every_profile_comes_back_from_both_forms(self):
        for seed in range(250):
            profile = random_profiles.Maker(seed).profile()
            written = {form: rtsprofile.dump(profile, form) for form in FORMS}
            for form in FORMS:
                again = rtsprofile.load(written[form], form)
                self.assertEqual(again, profile, "seed %d, %s" % (seed, form))
                self.assertEqual(
                    {other: rtsprofile.dump(again, other) for other in FORMS}, written, "seed %d" % seed
                )

    def test_every_field_matters_to_equality(self):
        maker = random_profiles.Maker(1)
        for cls in [
            value
            for value in vars(model).values()
            if isinstance(value, type) and issubclass(value, fields.Element)
        ]:
            for field in cls.FIELDS:
                one = maker.element(cls)
                other = copy.deepcopy(one)
                self.assertEqual(one, other)
                setattr(other, field.name, "another")
                self.assertNotEqual(one, other, "%s.%s" % (cls.__name__, field.name))


class Meaning(unittest.TestCase):
    def test_files_of_rtcryo(self):
        profile = load(os.path.join(DATA, "valid", "as-rtcryo-writes.xml"))
        component, valve = profile.components
        self.assertEqual(
            (component.path_uri, component.is_required), ("localhost:2810/Hygrometer0.rtc", True)
        )
        self.assertEqual(component.location, model.Location())
        self.assertEqual([(d.name, d.data) for d in component.configuration_sets[0].configuration_data],
                         [("interval", "0.5"), ("note", "")])
        self.assertEqual((component.property("IOR"), component.property("none")), ("IOR:0100", None))
        wire, = profile.data_port_connectors
        self.assertEqual([end.port_name for end in wire.ends], ["Hygrometer0.out", "Valve0.in"])
        self.assertEqual(
            (wire.push_interval, wire.properties), (10.0, [model.Property(name="dataport.outport")])
        )
        condition, = profile.activation.targets
        self.assertEqual(
            (condition.sequence, condition.wait_time.wait_time, condition.preceding), (1, 250, None)
        )
        self.assertEqual((profile.start_up, valve.service_ports[0].visible), (None, True))

    def test_files_of_systemeditor(self):
        profile = load(os.path.join(DATA, "valid", "as-systemeditor-writes.xml"))
        pair, = profile.components
        self.assertEqual((pair.composite_type, pair.location.direction), ("PeriodicECShared", "RIGHT"))
        self.assertEqual([p.component.instance_name for p in pair.participants], ["Valve0", "Hygrometer0"])
        member, = pair.execution_contexts[0].participants
        self.assertEqual(member.property("COMPONENT_PATH_ID"), "localhost/a.host_cxt/Valve0.rtc")
        self.assertEqual(profile.start_up.targets[0].target.id, "")
        preceding = profile.resetting.targets[0].preceding
        self.assertEqual(
            (preceding.timeout, preceding.sending_timing, len(preceding.preceding_components)),
            (3000, "SYNC", 1),
        )
        self.assertEqual(profile.version_up_logs, ["first", "second & last"])
        self.assertEqual(profile.creation_date, "2025-04-01T06:30:00.125+09:00")

    def test_names_in_the_wrong_namespace_or_in_none(self):
        profile = load(os.path.join(DATA, "valid", "other-prefixes.xml"))
        self.assertIsNone(profile.foreign)
        component, = profile.components
        self.assertEqual((component.composite_type, component.visible), ("Grouping", False))
        self.assertEqual(component.location.direction, "LEFT")
        self.assertEqual(component.property("place"), "1 < 2")
        self.assertEqual(profile.groups[0].group_id, "g")

    def test_foreign_parts_are_kept(self):
        profile = load(os.path.join(DATA, "valid", "foreign.xml"))
        self.assertEqual(profile.foreign.attributes["{%s}lang" % names.XML], "ja")
        component, = profile.components
        self.assertEqual((component.id, component.foreign.attributes["id"]), ("RTC:A:b:C:1", "another"))
        shape, brand, plain = component.foreign.elements
        self.assertEqual(
            (shape.tag, shape.content[1], plain.content), ("{http://example.org/x}Shape", " and ", [" "])
        )
        self.assertEqual(brand.attributes, {"name": "none"})

    def test_comments_stay_beside_what_they_stand_beside(self):
        text = """<?xml version="1.0"?>
<!-- of the file
     on two lines --><rts:RtsProfile %s rts:id="a" rts:version="0.2" rts:abstract="">
    <!-- the arm --><!-- twice -->
    <rts:Components rts:id="RTC:a:b:c:1" rts:pathUri="h/a.rtc" rts:instanceName="a" rts:isRequired="true">
        <!-- no ports ‮ -->
    </rts:Components>
    <rts:Components rts:id="RTC:a:b:c:1" rts:pathUri="h/b.rtc" rts:instanceName="b" rts:isRequired="true"/>
    <!-- the end -->
</rts:RtsProfile>
<!-- after it -->""" % NAMESPACES
        written = rtsprofile.dump(rtsprofile.load(text, "a.xml"), rtsprofile.XML)
        self.assertEqual(rtsprofile.dump(rtsprofile.load(written, "b.xml"), rtsprofile.XML), written)
        order = [
            "of the file\n     on two lines",
            "<rts:RtsProfile",
            "the arm",
            "twice",
            "h/a.rtc",
            r"<!-- no ports \u202e -->",
            "h/b.rtc",
            "the end",
            "after it",
            "</rts:RtsProfile>",
        ]
        self.assertEqual(sorted(order, key=written.index), order)

    def test_a_connection_may_have_any_number_of_ends(self):
        ports = [model.TargetPort(component_id="i", instance_name="n%d" % i, port_name="p") for i in range(4)]
        for count in range(1, 5):
            connector = model.DataPortConnector(connector_id="c")
            connector.ends = ports[:count]
            profile = model.RtsProfile(data_port_connectors=[connector])
            for form in FORMS:
                again, = rtsprofile.load(rtsprofile.dump(profile, form), "a").data_port_connectors
                self.assertEqual(again.ends, ports[:count])

    def test_times_of_version_0_1(self):
        profile = load(os.path.join(DATA, "valid", "version-0.1.xml"))
        self.assertEqual(
            [c.wait_time and c.wait_time.wait_time for c in profile.start_up.targets], [1500, None, None]
        )
        for form in FORMS:  # what is written is of 0.2
            self.assertEqual(load(os.path.join(DATA, "valid", "version-0.1." + form)).version, "0.2")

    def test_boolean_and_number_spellings(self):
        for text, value in (
            ("true", True),
            ("TRUE", True),
            ("1", True),
            ("0", False),
            ("False", False),
            ("", False),
        ):
            profile = read_xml('<rts:Components rts:id="" rts:pathUri="" rts:instanceName="" '
                               'rts:isRequired="%s"/>' % text)
            self.assertIs(profile.components[0].is_required, value)
        for text, value in ((" 10 ", 10.0), ("1e3", 1000.0), ("INF", float("inf")), ("", 0.0)):
            profile = read_xml('<rts:DataPortConnectors rts:pushInterval="%s"><rts:sourceDataPort '
                               'rts:componentId="" rts:instanceName="" '
                               'rts:portName=""/></rts:DataPortConnectors>' % text)
            self.assertEqual(profile.data_port_connectors[0].push_interval, value)

    def test_an_unknown_field_is_a_mistake_of_the_program(self):
        with self.assertRaises(TypeError):
            model.Property(nam="a")

    def test_repr_of_an_element(self):
        self.assertEqual(repr(model.Component(id="a", properties=[model.Property(name="b")])),
                         "Component(id='a', properties=[Property(name='b')])")

    def test_reading_leaves_the_collector_as_it_was(self):
        self.addCleanup(gc.enable)
        for switch, is_on in ((gc.enable, True), (gc.disable, False)):
            switch()
            read_xml("")
            self.assertIs(gc.isenabled(), is_on)


class Forms(unittest.TestCase):
    def test_the_form_is_told_by_the_content(self):
        for path in files("valid"):
            self.assertEqual(rtsprofile.form_of(content(path)), path.rpartition(".")[2])
        self.assertEqual(rtsprofile.form_of(b" \r\n\t<a/>"), rtsprofile.XML)

    def test_a_form_can_be_forced(self):
        for name, form in (("as-rtcryo-writes.xml", rtsprofile.YAML), ("by-hand.yaml", rtsprofile.XML)):
            with self.assertRaises(errors.BadProfile):
                load(os.path.join(DATA, "valid", name), form)

    def test_text_that_was_read_with_surrogate_escapes_is_taken(self):
        for name in ("shift-jis.xml", "utf-16.xml", "byte-order-mark.xml"):
            data = content(os.path.join(DATA, "valid", name))
            self.assertEqual(
                rtsprofile.load(data.decode("utf-8-sig", "surrogateescape"), name),
                rtsprofile.load(data, name),
            )
        with self.assertRaises(errors.BadProfile):
            rtsprofile.load("\ud800", "a")

    def test_written_files_are_what_old_readers_take(self):
        profile = load(os.path.join(DATA, "valid", "as-rtcryo-writes.xml"))
        text = rtsprofile.dump(profile, rtsprofile.YAML)
        text.encode("ascii")
        for line in ("  version: '0.2'", "    - condition:", "          waitTime: 250", "    minute: 30",
                     "    rtsExt::visible: true"):
            self.assertIn(line + "\n", text)
        order = model.Condition(target=model.TargetExecutionContext())
        plain = model.RtsProfile(activation=model.MessageSending(targets=[order]))
        self.assertIn("- condition: {}\n", rtsprofile.dump(plain, rtsprofile.YAML))
        head = '<?xml version="1.0" encoding="UTF-8"?>\n<rts:RtsProfile xmlns:rts='
        self.assertTrue(rtsprofile.dump(plain, rtsprofile.XML).startswith(head))

    def test_characters_that_xml_cannot_hold(self):
        for text in (
            "\x1b",
            "_x001B_",
            "_x001B\x1b",
            "\ud800\udfff",
            "_x005F_x001B_",
            "_x0041_",
            "a_b",
            "\uffff_",
        ):
            written = escape.quoted(text)
            self.assertEqual(escape.unspelt(written), text)
        self.assertEqual((escape.quoted("_x0041_"), escape.quoted("\x1b[0m")), ("_x0041_", "_x001B_[0m"))
        self.assertEqual(
            (escape.quoted("\u3164"), escape.quoted("e" + "\u0301" * 5)),
            ("&#12644;", "e" + "\u0301" * 4 + "&#769;"),
        )

    def test_the_standard_library_is_not_hidden(self):
        from rtshell_lite.xmlprofile import xml
        self.assertTrue(xml.expat.__name__.startswith("xml.parsers"))
        self.assertNotIn("yaml", sys.modules)


if __name__ == "__main__":
    unittest.main()
