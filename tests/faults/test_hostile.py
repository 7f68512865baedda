"""Peers all of whose text is hostile, and real shells: they understand what is printed, and run nothing else.
With omniORB, which reads names in its own way, nothing harmful is printed, either.

tests/sim/test_wicked.py has that of our own ORB, and completions. If one fails, anybody who can start a
component, or reach a name server, can type into the terminal of the operator.
"""
import glob
import os
import re
import shutil
import subprocess
import sys
import unittest

import invocations
import running
import tools

try:
    from mock_components import wicked  # noqa: F401: hostile has it
except ImportError:
    raise unittest.SkipTest("needs omniORBpy")
import hostile

ONCE = "what is printed does not depend on the Python"
BOTH = "each ORB reads names in its own way"

IS_BUILTIN = os.environ.get("RTSHELL_ORB") != "omniorb"
ON_TERMINAL = [sys.executable, "-I", "-S", tools.__file__, "terminal", "80"]


def setUpModule():
    global around, server, place
    around = running.Surroundings()
    server = around.name_server()
    around.world(server, "wicked")
    place = hostile.Place(server + "/test.host_cxt", os.path.join(around.top, "wicked.yaml"))
    around.done(["rtcryo", "-q", "-y", "-o", place.profile, server])


def tearDownModule():
    around.close()


class Case:
    """A command line, and the string whose component it is about."""

    def __init__(self, number, command, line, key):
        self.number = number
        self.command = command
        self.line = line
        self.key = key
        self.on_terminal = number % 2 == 0

    def __str__(self):
        where = " on a terminal" if self.on_terminal else ""
        return "%s %s: %s%s" % (self.command, self.line, self.key, where)

    def run(self):
        where = around.directory("run%d" % self.number)
        inside = ON_TERMINAL if self.on_terminal else ()
        words = [self.command] + place.words(self.line, self.key)
        self.ran = running.run(words, where, inside, RTCTREE_NAMESERVERS=server[1:])
        return self

    def problems(self):
        out, err = [said.decode("utf-8", "backslashreplace") for said in (self.ran.out, self.ran.err)]
        if self.on_terminal:
            out, err = out.replace("\r\n", "\n"), err.replace("\r\n", "\n")
        return list(hostile.problems(self.command, self.line, self.on_terminal, self.ran.status, out, err))


def cases():
    """What each command does first, about one component, or with --long about all."""
    first = [(command, lines[0]) for command, lines in hostile.lines()]
    chosen = [(command, line, key) for number, (command, line) in enumerate(first)
              for key in running.sample(hostile.KEYS, 1, number)]
    return [Case(number, *some) for number, some in enumerate(chosen)]


def canaries():
    return [
        name for name in glob.glob(os.path.join(glob.escape(around.top), "**", "canary*"), recursive=True)
    ]


class Hostile(unittest.TestCase):
    def test_1_commands_that_are_printed_do_what_they_say(self):
        """Shells in which only stand-ins of our commands exist understand each line, and run nothing else."""
        tools = around.directory("tools")
        os.symlink(shutil.which("printf"), os.path.join(tools, "printf"))  # mksh has none of its own
        for name in invocations.all_commands():
            with open(os.path.join(tools, name), "w") as file:
                file.write("#!/bin/sh\nexit 0\n")
            os.chmod(os.path.join(tools, name), 0o755)

        def dry(command, *words):
            ran = running.run([command, "--dry-run"] + list(words), around.top)
            self.assertIn(ran.status, (0, 5), ran)
            return ran.out
        printed = dry("rtdis", str(place.component("substitution")))
        printed += dry("rtdis", str(place.component("quotes")))
        printed += dry("rtcon", place.port("substitution", "out"), place.port("path", "in")) + dry(
            "rtcon", place.port("lines", "out"), place.port("bidi", "in")
        )
        printed += dry("rtdel", "--recursive", str(place.home)) + dry("rtteardown", place.profile)
        running.run(["rtteardown", "-q", place.profile], around.top)
        printed += dry("rtresurrect", place.profile)
        running.run(["rtresurrect", "-q", place.profile], around.top)
        counts = {
            name: len(re.findall(b"(?m)^%s " % name.encode(), printed))
            for name in ("rtcon", "rtdis", "rtdel")
        }
        self.assertTrue(min(counts.values()) >= len(hostile.KEYS) - 2, counts)
        for shell in hostile.SHELLS:
            ran = subprocess.run(
                shell, input=printed, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env={"PATH": tools},
                cwd=around.directory("shell"), executable=shutil.which(shell[0]))
            # two long names in one word
            said = [line for line in ran.stderr.splitlines() if b"rgument list too long" not in line]
            self.assertEqual((ran.stdout, said), (b"", []), shell)
        self.assertEqual(canaries(), [])

    @unittest.skipIf(IS_BUILTIN, "tests/sim/test_wicked.py has that of our own ORB")
    def test_2_nothing_harmful_is_printed(self):
        chosen = cases()
        gentle = [case for case in chosen if case.command not in hostile.FATAL]
        fatal = [case for case in chosen if case.command in hostile.FATAL]
        for case in running.together(Case.run, gentle) + running.together(Case.run, fatal):
            with self.subTest(str(case)):
                self.assertEqual(case.problems(), [], str(case.ran)[:3000].encode("unicode_escape"))
        self.assertEqual(canaries(), [])
        print("figures: %d command lines about %d kinds of hostile text, %d of them on a terminal"
              % (len(chosen), len(hostile.KEYS), sum(case.on_terminal for case in chosen)))


if __name__ == "__main__":
    unittest.main()
