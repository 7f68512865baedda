"""How transcripts are read and compared: if it fails, a command may be broken and its transcript still pass.

How they are played is in tests/waiting/test_sessions.py.
"""
import os
import re
import shutil
import subprocess
import unittest

import processes
import tools
import transcripts


COLUMNS = 110
# So many steps are wider, or have more than two commands: limits to be lowered, never raised.
WIDE, MANY = 38, 2


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


class Files(unittest.TestCase):
    def test_no_number_may_be_a_port(self):
        """Where a name server happened to get it, it would be shown as $PORT."""
        for path, _ in transcripts.cases(shells=["dash"]):
            shown = "\n".join(
                line for step in transcripts.steps(transcripts.parse(read(path))) for line in step.expected
            )
            numbers = {int(number) for number in re.findall(r"(?<![0-9])[0-9]{5}(?![0-9])", shown)}
            self.assertFalse(
                [number for number in numbers if processes.nameserver.PORTS < number < 32000], path
            )


def has_many_commands(step):
    """Are there more than two in a line? Those in quotes, brackets, loops and conditions do not count."""
    line = re.sub(r"""'[^']*'|"(\\.|[^"\\])*\"""", "", step.command[0])
    for part in (r"\([^()]*\)", r"\{[^{}]*\}") * 3 + (r"\b(for|while|until|if) .*?; *(done|fi)\b",):
        line = re.sub(part, "", line)
    return len(step.command) == 1 and line.rstrip("; ").count(";") > 1


class Steps(unittest.TestCase):
    """What a reader takes in at one look: few commands, and none that is wider than a page."""

    def test_their_number_goes_down(self):
        steps = [
            step
            for path, _ in transcripts.cases(shells=["dash"])
            for step in transcripts.steps(transcripts.parse(read(path)))
        ]
        wide = [step for step in steps if max(map(len, step.lines([])), default=0) > COLUMNS]
        self.assertLessEqual(len(wide), WIDE, "lower the limit, or break lines after | and &&")
        many = [step for step in steps if has_many_commands(step)]
        self.assertLessEqual(len(many), MANY, "lower the limit, or make two steps of one")


class Helpers(unittest.TestCase):
    def test_they_stand_in_one_place(self):
        helpers = read(os.path.join(transcripts.jobs.HERE, "helpers.sh"))
        names = re.findall(r"^(\w+)\(\)", helpers, re.MULTILINE)
        defined = re.compile(r"\b(%s)\(\)" % "|".join(names))
        for path, _ in transcripts.cases(shells=["dash"]):
            for step in transcripts.steps(transcripts.parse(read(path))):
                self.assertIsNone(defined.search("\n".join(step.command)), "%s: %s" % (path, step.command))

    @unittest.skipUnless(shutil.which("busybox"), "busybox is not installed")
    def test_none_has_the_name_of_an_applet(self):
        """A BusyBox that prefers its applets, as Debian's busybox-static, would play them instead."""
        applets = subprocess.check_output(["busybox", "--list"]).decode().split()
        self.assertEqual(set(tools.NAMES) & set(applets + ["resume"]), set())


class Reading(unittest.TestCase):
    def test_steps_and_prose(self):
        items = transcripts.parse("prose\n\n  $ a \\\n  > b\n  one\n\n  two\n  [3]\n\nmore\n")
        step = transcripts.steps(items)[0]
        self.assertEqual(step.command, ["a \\", "b"])
        self.assertEqual(step.expected, ["one", "", "two", "[3]"])

    def test_transcripts_are_written_back_unchanged(self):
        text = "prose\n\n  $ a\n\n  one\n\n\n  $ b\n  > \n  > c\n\n    deep\n\nworld: two\n\n\n"
        items = transcripts.parse(text)
        outputs = [step.expected for step in transcripts.steps(items)]
        self.assertEqual(transcripts.render(items, outputs), text.replace("  > \n", "  >\n"))

    def test_directives_stand_at_the_margin(self):
        items = transcripts.parse("world: many 200\nfaulty: silent\n\n  $ echo\n  world: no\n")
        self.assertEqual(transcripts.directives(items), [("world", "many 200"), ("faulty", "silent")])

    def test_output_without_command(self):
        self.assertRaises(transcripts.Malformed, transcripts.parse, "prose\n  lost\n")


class Spelling(unittest.TestCase):
    def test_plain(self):
        self.assertEqual(transcripts.spell("ä \\x".encode(), []), "ä \\x")

    def test_controls_and_bytes(self):
        self.assertEqual(transcripts.spell(b"a\\\x1b[1m\t\xff", []), "a\\\\\\x1b[1m\\t\\xff (esc)")

    def test_trailing_blanks_are_seen(self):
        self.assertEqual(transcripts.spell(b"a  ", []), "a\\x20\\x20 (esc)")

    def test_output_that_looks_like_syntax_is_escaped(self):
        for raw in b"$ a", b"> a", b"[3]", b"a (re)", b"a (esc)", b">":
            self.assertNotEqual(transcripts.spell(raw, []), raw.decode())

    def test_names_for_what_varies(self):
        self.assertEqual(transcripts.spell(b"at 12345, 112345", [("(?<![0-9])12345(?![0-9])", "$PORT")]),
                         "at $PORT, 112345")


class Comparing(unittest.TestCase):
    def test_patterns(self):
        self.assertTrue(transcripts.matches("[0-9]+ ms (re)", "12 ms"))
        self.assertFalse(transcripts.matches("[0-9]+ (re)", "12 ms"))
        self.assertTrue(transcripts.matches("took * (s) \\* (glob)", "took 3 (s) *"))
        self.assertFalse(transcripts.matches("a? (glob)", "a"))
        self.assertFalse(transcripts.matches("a.c", "abc"))

    def test_merging_keeps_patterns(self):
        self.assertEqual(
            transcripts.merge(["a", "[0-9] (re)", "z"], ["b", "7", "y"]), ["b", "[0-9] (re)", "y"]
        )

    def test_merging_sees_missing_and_extra_lines(self):
        self.assertEqual(transcripts.merge(["a", "b"], ["a"]), ["a"])
        self.assertEqual(transcripts.merge(["a"], ["a", "b"]), ["a", "b"])
        self.assertEqual(transcripts.merge(["a", "b", "c"], ["a", "c"]), ["a", "c"])


if __name__ == "__main__":
    unittest.main()
