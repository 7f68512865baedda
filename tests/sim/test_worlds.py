"""Simulated worlds (tests/sim): if this fails, a command does not end, says what was not so, or does harm;
`tests/simulate --seed N -v` tells how.
"""
import os
import subprocess
import sys
import unittest

import mutants

TESTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
WORLDS = 500

ONCE = "a seed has one story on every Python"
LONG = "500 worlds take minutes"


def simulate(*words):
    """(status, what tests/simulate prints)"""
    done = subprocess.run(
        [sys.executable, os.path.join(TESTS, "simulate"), *words],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        universal_newlines=True,
    )
    return done.returncode, done.stdout


class Worlds(unittest.TestCase):
    def test_worlds(self):
        status, said = simulate("--seed", "1", "--worlds", str(WORLDS))
        self.assertEqual(status, 0, said)
        self.assertRegex(said, f"{WORLDS} worlds, [0-9]+ commands, 0 failed")

    def test_worlds_that_have_found_a_bug(self):
        status, said = simulate("--kept")
        self.assertEqual(status, 0, said)
        self.assertNotIn("\n0 worlds", "\n" + said)

    def test_a_seed_has_one_story(self):
        (_, one), (_, other) = [simulate("--seed", "77", "--worlds", "20", "-v") for _ in range(2)]
        self.assertGreater(len(one), 1000)
        self.assertEqual(one, other)


class Mutants(unittest.TestCase):
    def test_what_is_to_be_broken_is_there(self):
        """Else mutants.py would not break it, and say at its end that the worlds notice less."""
        for name, old, new in mutants.read():
            with open(os.path.join(mutants.ROOT, name), encoding="utf-8") as file:
                self.assertIn(old, file.read(), name)
            self.assertNotEqual(old, new, name)


if __name__ == "__main__":
    unittest.main()
