"""The YAML reader and writer: a subset of YAML 1.1 with PyYAML's meaning; the rest is refused.

A file NAME.yaml in tests/data/valid with a NAME.json beside it must be read as the JSON says.
test_xmlprofile.py reads the documents in tests/data/invalid, which must be refused.
"""
import glob
import json
import os
import random
import unittest

import random_profiles
from rtshell_lite import errors
from rtshell_lite.xmlprofile import fields
from rtshell_lite.xmlprofile.yaml import reader, scalars, writer

DATA = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "data")


def read(text):
    return scalars.plain(reader.parse(text, "a.yaml")[1])


class Reading(unittest.TestCase):
    def test_files_are_read_as_their_json_says(self):
        paths = glob.glob(os.path.join(glob.escape(DATA), "valid", "*.json"))
        self.assertTrue(paths)
        for path in paths:
            with open(path, encoding="utf-8") as file:
                wanted = json.load(file)
            with open(path[:-5] + ".yaml", "rb") as file:
                got = read(file.read())
            for key in sorted(set(wanted) | set(got)):
                self.assertEqual(
                    repr(got.get(key)), repr(wanted.get(key)), "%s: %s" % (os.path.basename(path), key)
                )

    def test_ends_of_lines(self):
        for end in ("\n", "\r\n", "\r", "\x85"):
            self.assertEqual(read(end.join(["a: |", "  b", "  c", "d: 'e", "  f'", ""])), {"a": (
                "b\nc\n"
            ), "d": "e f"})
        self.assertEqual(
            read("'a\u2028 b\u2029\u2029c\n\u2028d'"), "a\u2028b\u2029\u2029c\u2028d", "these are kept"
        )

    def test_ends_of_documents(self):
        for text in ("a: 1", "a: 1\n", "--- \na: 1\n...\n", "---\na: 1\n...\n...\n# end", "--- {a: 1}\n",
                     "\ufeffa: 1"):
            self.assertEqual(read(text), {"a": 1}, text)
        for text in ("", "---", "# nothing\n", "---\n...\n"):
            self.assertIsNone(read(text), text)

    def test_the_last_line_of_a_text(self):
        self.assertEqual(
            [read("|\n a"), read("|\n a\n"), read("|+\n a\n\n"), read("|-\n a\n"), read(">\n a\n b\n\n")],
            ["a", "a\n", "a\n\n", "a", "a b\n"],
        )
        for text, expected in (
            ("|\n  x\n  ", "x\n"),
            ("|\n  ", ""),
            ("|\n\n  ", ""),
            (">\n  x\n  ", "x\n"),
            ("|+\n  x\n  ", "x\n"),
            ("|-\n  x\n  ", "x"),
            ("|\n  x\n   ", "x\n "),
        ):
            self.assertEqual(read("a: " + text), {"a": expected}, text)

    def test_an_alias_is_the_same_value(self):
        self.assertEqual(read("- &x {a: &y 1}\n- *x\n- *y\n- &z 2\n- *z\n"), [{"a": 1}, {"a": 1}, 1, 2, 2])
        self.assertEqual(read("- &a k\n- *a : v\n"), ["k", {"k": "v"}])

    def test_an_anchor_belongs_to_the_key_or_to_what_is_below(self):
        self.assertEqual(read("&a k: v\nx: *a\n"), {"k": "v", "x": "k"})
        self.assertEqual(read("m: &a\n  k: v\nx: *a\n"), {"m": {"k": "v"}, "x": {"k": "v"}})
        self.assertEqual(read("- &a k: v\n- *a\n- &b\n  k: w\n- *b\n"), [{"k": (
            "v"
        )}, "k", {"k": "w"}, {"k": "w"}])

    def test_the_place_of_an_error(self):
        for text, place in (
            ("a: b\nc: [d\n", (2, 4)),
            ("a: b: c", (1, 5)),
            ("日本: 'x", (1, 5)),
            ("a:\r\n\tb", (2, 1)),
            ("a: \u2028\n  - b\n c", (3, 2)),
            ('x: "a\n  \\q"', (2, 3)),
        ):
            with self.assertRaises(errors.BadProfile) as caught:
                read(text)
            self.assertEqual(caught.exception.args[1:3], place, (text, str(caught.exception)))

    def test_one_anchor_and_one_tag(self):
        """On lines of their own, too; there may be thousands of such lines, and Python's stack holds few
        calls.
        """
        self.assertEqual(read("a:\n  &x\n  !!str\n  1\nb: *x"), {"a": "1", "b": "1"})
        self.assertEqual(read("a: !!map\n  &x\n  &y k: *y\n".replace("*y", "1")), {"a": {"k": 1}})
        for lines in (
            ["&x", "!!str", "&y"],
            ["!!str", "&x", "!!str"],
            ["&x !!str", "&y"],
            ["&%s", "!!str"] * 2000,
        ):
            text = "".join("  %s\n" % line.replace("%s", str(number)) for number, line in enumerate(lines))
            with self.assertRaises(errors.BadProfile) as caught:
                read("a:\n" + text + "  1\n")
            self.assertIn("a second anchor or tag", str(caught.exception))

    def test_tags_must_fit(self):
        for text in ("!!int x", "!!float x", "!!bool x", "!!null x", "!!binary 'a'", "!!int ''",
                     "!!float 0x" + "f" * 298):
            with self.assertRaises(ValueError):
                read(text)
        self.assertEqual(read("!!binary 'AP8='"), b"\x00\xff")

    def test_keys_after_question_marks_are_refused(self):
        for text in ("? a\n: b\n", "- ? a\n", "{? a: b}", "a: ? b\n"):
            with self.assertRaises(errors.BadProfile):
                read(text)

    def test_nothing_is_made_by_name(self):
        for tag in (
            "!!python/name:os.system",
            "!!python/object/apply:os.system [x]",
            "!!set {a}",
            "!!omap []",
            "!x a",
            "!<x> a",
        ):
            with self.assertRaises(errors.BadProfile):
                read(tag)


class Writing(unittest.TestCase):
    def check(self, data):
        text = writer.write(data)
        text.encode("ascii")
        self.assertTrue(fields.same(read(text), data), (data, text))

    def test_everything_comes_back(self):
        maker = random_profiles.Maker(3)
        for _ in range(3000):
            self.check(maker.data())

    def test_every_character_comes_back(self):
        for first in range(0, 0x110000, 997):
            self.check({"".join(chr(first % 0x10FF00 + i) for i in range(40)): [chr(first)]})
        for code in range(0x300):
            self.check([chr(code), "a%sb" % chr(code), "a %s" % chr(code), "%s b" % chr(code)])

    def test_the_style_is_pyyaml_s(self):
        data = {"b": [1, 1.0, True, None, [], {}], "a": {"x::y": ["a", ["b", {"c": "d", "e": "f"}]]},
                "": (
                    "0.2"
                ), "t": "it's", "q": "it's: x", "n": "a\nb\xe9", "f": [1e20, 1e-7, float("inf"), -0.0]}
        self.assertEqual(writer.write(data), """\
'': '0.2'
a:
  x::y:
  - a
  - - b
    - c: d
      e: f
b:
- 1
- 1.0
- true
- null
- []
- {}
f:
- 1.0e+20
- 1.0e-07
- .inf
- -0.0
n: "a\\nb\\xE9"
q: 'it''s: x'
t: it's
""")

    def test_long_keys(self):
        self.check({"k" * 2000: {"a": 1}, "l" * 2000: [1], "m" * 2000: 2})

    def test_numbers_of_base_60_of_pyyaml_are_quoted_text(self):
        self.assertEqual(read("a: 1:30"), {"a": "1:30"})
        self.assertEqual(writer.write(["1:30", "-1:30.5", "1:90"]), "- '1:30'\n- '-1:30.5'\n- 1:90\n")


class Mutations(unittest.TestCase):
    def test_only_the_declared_errors(self):
        rng = random.Random(4)
        maker = random_profiles.Maker(5)
        pieces = list("\n\n  -?:,[]{}#&*!|>'\"%@\\~\t") + [
            "- ", ": ", "\n  ", " #", "|\n ", ">-\n", "---\n", "...", "&a ", "*a", "!!str "]
        for _ in range(3000):
            text = writer.write(maker.data())
            for _ in range(rng.randint(1, 5)):
                at = rng.randint(0, len(text))
                text = (
                    text[:at]
                    + (rng.choice(pieces) if rng.random() < 0.7 else "")
                    + text[at + rng.randint(0, 2) :]
                )
            try:
                data = read(text)
            except (errors.BadProfile, ValueError):
                continue
            self.assertTrue(fields.same(read(writer.write(data)), data), text)


if __name__ == "__main__":
    unittest.main()
