"""What tests/run chooses: if it fails, a run passes that has not tried what it is believed to have tried."""
import argparse
import collections
import os
import unittest
from unittest import mock

import invocations
import processes
import runner
import tools
import transcripts


def asked(*words):
    return argparse.Namespace(pattern=list(words), daily=not words)


class Chosen(unittest.TestCase):
    def test_pure_modules_always_whole(self):
        for words in ((), ("unit",), ("faults", "unit")):
            self.assertEqual(runner.words_for("unit", asked(*words)), [], words)

    def test_what_waits_only_where_it_is_named(self):
        self.assertIsNone(runner.words_for("waiting", asked()))
        self.assertIsNone(runner.words_for("waiting", asked("unit")))
        self.assertEqual(runner.words_for("waiting", asked("unit", "rtls")), ["rtls"])
        self.assertEqual(runner.words_for("waiting", asked("rtls", "waiting")), [])

    def test_each_command_has_its_own_transcript_once(self):
        played = collections.Counter()
        for path, shell in transcripts.cases():
            for orb in (None, "omniorb"):
                played[os.path.basename(path)] += runner.has_its_day(path, shell, orb)
        once = {name: 1 for name in played if played[name]}
        self.assertEqual(once, {command + ".t": 1 for command in invocations.all_commands()})

    def test_the_last_lines_count_what_is_left_out(self):
        self.assertRegex(
            runner.left_out(),
            r"^\d{2,3} transcripts, \d{2,} tests of waiting/, \d{2,} tests of mocks/, .*, other Pythons,",
        )


class Rules(unittest.TestCase):
    def test_a_pure_module_starts_no_peers(self):
        with mock.patch.dict(os.environ, RTSHELL_PURE="1"), self.assertRaises(tools.Failed):
            processes.start("nobody", ["true"])

    def test_the_same_seed_every_day(self):
        with mock.patch("sys.argv", ["tests/run", "--all"]):
            self.assertEqual(str(runner.options().seed), runner.SEED)
        with open(os.path.join(processes.ROOT, ".ci", "run"), encoding="utf-8") as file:
            self.assertNotIn("RTSHELL_SEED", file.read())


if __name__ == "__main__":
    unittest.main()
