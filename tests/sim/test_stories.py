"""Stories (tests/sim/stories): if one fails, a command says something else than it should, or takes another
time, where something hangs, dies or comes late. `python3 tests/sim/stories.py --accept NAME` takes what is
said now.
"""
import os
import subprocess
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))

ONCE = "a story is the same on every Python"
LONG = "all of them take a minute"


class Stories(unittest.TestCase):
    """A test for each file: test_rtls_faults of rtls-faults.t."""

    def play(self, name):
        """Play it in a process of its own, which leaves no threads behind."""
        done = subprocess.run(
            [sys.executable, os.path.join(HERE, "stories.py"), name],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            universal_newlines=True,
        )
        self.assertEqual((done.returncode, done.stdout), (0, f"ok {name}\n"), done.stdout)


def test_of(name):
    return lambda self: self.play(name)


for each in sorted(os.listdir(os.path.join(HERE, "stories"))):
    if each.endswith(".t"):
        setattr(Stories, "test_" + each[:-2].replace("-", "_"), test_of(each))


if __name__ == "__main__":
    unittest.main()
