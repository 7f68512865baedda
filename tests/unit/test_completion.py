"""What TAB offers before anything is asked of a robot; shells on terminals are tried in tests/commands."""
import unittest

from rtshell_lite.net import loop
from rtshell_lite.shell import completion


class Commands(unittest.TestCase):
    def offered(self, line):
        return list(loop.run(completion.answers("bash", line, line)))

    def test_names_of_commands(self):
        self.assertEqual(self.offered("rtpw"), ["rtpwd "])
        self.assertEqual(self.offered("nothing"), [])

    def test_nothing_is_offered_on_an_empty_line(self):
        for line in ("", "  ", "'", "''"):
            self.assertEqual(self.offered(line), [], line)

    def test_options(self):
        self.assertEqual(self.offered("rtpwd --vers"), ["rtpwd --version "])


if __name__ == "__main__":
    unittest.main()
