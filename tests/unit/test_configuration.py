"""Configuration as text: if this fails, a dumped configuration does not come back as it was, or a typo is
swallowed.
"""
import collections
import random
import unittest

from rtshell_lite import errors
from rtshell_lite.robot import configuration

ODD = list("ab =#[]\\.:\n\r\t\0\x1b\x7f\x85\u2028\u202e") + [
    "日",
    "é",
    "\udcff",
    "\udc80",
    "\U0001f916",
    "\ufeff",
    " active",
    "\\x20",
]


class Sets:
    """What `dumped`, `steps` and `differences` need of a Configuration."""

    where = "/localhost/a.rtc"

    def __init__(self, values, active=""):
        self.values = values
        self.active = active

    def sets(self, with_hidden=False):
        return [
            configuration.Set(set_id, "", self.values[set_id], set_id == self.active)
            for set_id in sorted(self.values)
            if with_hidden or not configuration.hidden(set_id)
        ]


def random_text(dice):
    return "".join(dice.choice(ODD) for _ in range(dice.randrange(6)))


def random_sets(dice):
    return Sets(
        {
            random_text(dice): collections.OrderedDict(
                (random_text(dice), random_text(dice)) for _ in range(dice.randrange(4))
            )
            for _ in range(dice.randrange(4))
        }
    )


def parsed(text):
    return configuration.parsed(text.split("\n"), "x.conf")


class Text(unittest.TestCase):
    def test_random_sets_come_back(self):
        dice = random.Random(1)
        for _ in range(3000):
            sets = random_sets(dice)
            sets.active = dice.choice(sorted(sets.values) + [""])
            lines = configuration.dumped(sets, with_hidden=True)
            self.assertEqual(
                configuration.parsed("\n".join(lines).split("\n"), ""), (sets.values, sets.active), lines
            )

    def test_lines_are_printable_and_survive_editors(self):
        """No control character reaches a terminal; stripping blanks from the ends of lines changes nothing.
        """
        dice = random.Random(2)
        for _ in range(1000):
            sets = random_sets(dice)
            lines = configuration.dumped(sets, with_hidden=True)
            self.assertTrue(all(line.isprintable() for line in lines), lines)
            self.assertEqual(
                configuration.parsed([line.rstrip() + "\r" for line in lines], "")[0], sets.values
            )

    def test_written_by_hand(self):
        self.assertEqual(parsed("# a\n\n  \n[a] active  \nx=1\r\ny==#\n[b]\n[a]\nz= \n"),
                         ({"a": {"x": "1", "y": "=#", "z": " "}, "b": {}}, "a"))

    def test_errors_have_line_numbers(self):
        for text, complaint in (("a=1", "x.conf:1: name=value before any [set]"),
                                ("[a]\n\nb", "x.conf:3: neither [set] nor name=value"),
                                ("[a", "x.conf:1: not [set] or [set] active"),
                                ("[a=b]c", "x.conf:1: not [set] or [set] active"),
                                ("[a]b=c", "x.conf:1: not [set] or [set] active"),
                                ("[a]\nb=\\", "x.conf:2: bad escape \\"),
                                ("[\\q]", "x.conf:1: bad escape \\q"),
                                ("[a]\nb=\\U00110000", "x.conf:2:"),
                                ("[a]\nb=1\nb=1", "x.conf:3: b has a value already"),
                                ("[a] active\n[b] active", "x.conf:2: a second active set")):
            with self.assertRaises(errors.Failed) as caught:
                parsed(text)
            self.assertTrue(str(caught.exception).startswith(complaint), str(caught.exception))

    def test_nothing(self):
        self.assertEqual(parsed(""), ({}, ""))


class Differences(unittest.TestCase):
    def test_rows(self):
        left = Sets({"a": {"x": "1", "y": "2"}, "b": {"z": ""}, "__m__": {"x": "1"}}, "a")
        right = Sets({"a": {"x": "1", "y": "3", "w": ""}, "__m__": {"x": "2"}}, "")
        rows = [("a", "w", None, ""), ("a", "y", "2", "3"), ("b", "z", "", None), (None, None, "a", None)]
        self.assertEqual(configuration.differences(left, right), rows)
        self.assertEqual(configuration.differences(left, right, True), [("__m__", "x", "1", "2")] + rows)
        self.assertEqual(configuration.differences(left, left, True), [])


class Hidden(unittest.TestCase):
    def test_both_ends_count(self):
        for set_id, hidden in (
            ("__widget__", True),
            ("__x", False),
            ("x__", False),
            ("_x_", False),
            ("default", False),
        ):
            self.assertIs(configuration.hidden(set_id), hidden, set_id)


if __name__ == "__main__":
    unittest.main()
