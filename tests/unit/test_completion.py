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

    def test_verbs_and_their_options(self):
        """A verb offers its own options only, also where a flag means it."""
        for line, wanted in [
            ("rtlog se", ["serve"]),
            ("rtlog r", ["record", "ring"]),
            ("rtlog play --r", ["--rate"]),
            ("rtlog -p --r", ["--rate"]),
            ("rtlog ring --r", ["--ring", "--ring-size"]),
            ("rtlog show --r", []),
            ("rtlog show --as", []),
            ("rtlog --as", ["--as-components"]),
            ("rtlog record --logger=t", ["--logger=text"]),
            ("rtlog play --nonsense --r", []),
            ("rtlog --help --r", []),
        ]:
            start = line[:line.rindex(" ") + 1]
            self.assertEqual(self.offered(line), [f"{start}{word} " for word in wanted], line)


if __name__ == "__main__":
    unittest.main()
