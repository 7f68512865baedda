"""Each command has its parts: a transcript, examples in its help, how tests run it."""
import ast
import os
import subprocess
import sys
import tempfile
import unittest

import invocations
import transcripts

BIN = invocations.COMMANDS
COMMANDS = invocations.all_commands()


class Checkout(unittest.TestCase):
    """bin/ and tests/commands/ have the same commands; each command has the required parts."""

    def test_every_command_has_a_transcript(self):
        """rtls.t, and rtls-names.t for a topic of its own; those of `rtshell_lite` are all of a topic."""
        names = {os.path.basename(path)[:-2].partition("-")[0] for path, _ in transcripts.cases()}
        self.assertEqual(
            sorted(names - {"rtshell_lite"}),
            COMMANDS,
            "a command NAME has a transcript tests/commands/NAME.t",
        )

    def test_every_command_says_how_it_is_run(self):
        """By the tests that run all commands."""
        stated = set(invocations.stated("invocation")) | set(invocations.stated("local"))
        self.assertEqual(
            sorted(set(COMMANDS) - stated),
            [],
            "to be stated in tests/commands/NAME.t by a line such as "
            "'invocation: A' or 'local: it contacts nobody': see tests/support/invocations.py",
        )

    def test_commands_of_a_clone_know_where_they_are(self):
        """Without PYTHONPATH, and by a link."""
        with tempfile.TemporaryDirectory() as directory:
            link = os.path.join(directory, "mine")
            os.symlink(os.path.join(BIN, "rtpwd"), link)
            for command in os.path.join(BIN, "rtpwd"), link:
                printed = subprocess.check_output([sys.executable, "-SB", command], env={}, cwd=directory)
                self.assertEqual(printed, b"/\n")

    def test_commands_can_be_read_and_run(self):
        for name in COMMANDS:
            with self.subTest(name):
                path = os.path.join(BIN, name)
                with open(path, encoding="utf-8") as file:
                    text = file.read()
                self.assertTrue(text.startswith("#!/usr/bin/env python3\n"))
                self.assertTrue(os.access(path, os.X_OK))
                tree = ast.parse(text)
                summary, _, details = ast.get_docstring(tree).partition("\n\n")
                self.assertRegex(summary, r"^[A-Z].*\.$")
                self.assertIn("examples:\n  " + name, details)
                self.assertTrue(
                    text.endswith('\n\nif __name__ == "__main__":\n    cli.main(arguments, run, __doc__)\n')
                )
                self.assertEqual(
                    [f.name for f in tree.body if isinstance(f, ast.FunctionDef)][:1], ["arguments"]
                )


if __name__ == "__main__":
    unittest.main()
