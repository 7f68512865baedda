"""Peers all of whose text is hostile: it reaches no terminal and no reader of JSON unescaped.

If this fails, anybody who can start a component, or reach a name server, can type into the terminal of the
operator. tests/faults/test_hostile.py has what needs commands as processes, and omniORB.
"""

import contextlib
import gc
import io
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import stories  # noqa: E402: the path first
import world as worlds  # noqa: E402

import hostile  # noqa: E402: the carrier first

from rtshell_lite import cli, notes, text  # noqa: E402
from rtshell_lite.play import nameserver  # noqa: E402

ONCE = "what is printed does not depend on the Python"
HOME = "/robot/test.host_cxt"
LONGEST = 100.0  # seconds of the world, in which each command ends
LONGEST_NAME = 1 << 17  # octets that the name server takes, as omniNames takes any
LONGEST_WORD = 60000  # octets that all shells take
CHANGING = hostile.FATAL | {"rtdis", "rtteardown"}  # after each line of these the robot is another
EACH = 13  # of so many cases of a line one is tried, another one by another seed; with --long all
SEED = int(os.environ.get("RTSHELL_SEED", "1"))
IS_THOROUGH = bool(os.environ.get("RTSHELL_FAULTS"))


class Robot:
    """A new robot with the components."""

    def __init__(self):
        self.player = stories.Player([("world", "wicked")])

    def run(self, words, on_terminal=False):
        """The program of a command; it has ended then."""
        environment = dict(self.player.environment, TERM="xterm")
        output = worlds.Terminal if on_terminal else worlds.Output
        command = stories.Command(self.player.seat, words, environment, 0.0, output)
        here = self.player.world
        here.run(here.time + LONGEST, lambda: command.program.is_over)
        return command.program

    def end(self):
        """Raises what the process of the components has failed by."""
        self.player.end()
        with contextlib.redirect_stderr(io.StringIO()):  # coroutines of what was killed complain
            gc.collect()


class Case:
    """A command line, the string whose component it is about, and whether it is typed on a terminal."""

    def __init__(self, command, line, key, on_terminal):
        self.command = command
        self.line = line
        self.key = key
        self.on_terminal = on_terminal

    def __str__(self):
        place = " on a terminal" if self.on_terminal else ""
        return f"{self.command} {self.line}: {self.key}{place}"

    def problems(self, robot, place):
        """What is wrong with what it prints."""
        program = robot.run([self.command, *place.words(self.line, self.key)], self.on_terminal)
        if program.failure is not None:
            return [repr(program.failure)]
        if not program.is_over:
            program.kill()
            return ["it does not end"]
        self.status = program.status
        self.out = program.out.text()
        self.err = program.error.text()
        lost = "no such path" in self.err and self.command not in hostile.FATAL
        if lost and hostile.is_about_one(self.line):
            return ["it does not find the component"]
        rules = hostile.problems(
            self.command, self.line, self.on_terminal, self.status, self.out, self.err
        )
        return list(rules)


def cases(command, line):
    """All Cases of a line."""
    keys = hostile.KEYS if hostile.is_about_one(line) else hostile.KEYS[:1]
    return [Case(command, line, key, how) for key in keys for how in (False, True)]


def share(some, number):
    """Those of the Cases of a line, the one of this number, that are tried."""
    if IS_THOROUGH:
        return some
    first = (SEED + number) % min(EACH, len(some))
    return some[first::EACH]


def plan():
    """[[Case] that have one robot]"""
    number = 0
    for command, lines in hostile.lines():
        together = []
        for line in lines:
            tried = share(cases(command, line), number)
            number += 1
            if command in CHANGING:
                yield tried
            else:
                together += tried
        yield together


class Wicked(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        notes.listener = cli._hear
        nameserver.LONGEST = LONGEST_NAME
        gc.disable()  # see Robot.end
        cls.before = os.getcwd(), sys.stdin
        sys.stdin = open(os.devnull)
        cls.top = tempfile.mkdtemp()
        os.chdir(cls.top)
        cls.robot = Robot()
        cls.place = hostile.Place(HOME, os.path.join(cls.top, "profile"), os.path.join(cls.top, "log"))
        recorded = [cls.place.port(key, "out") for key in ("lines", "c1")]
        cls.do(["rtcryo", "-q", "-y", "-o", cls.place.profile, "/robot"])
        cls.do(["rtlog", "-q", "-f", cls.place.log, "-i", "-e", "4", *recorded])

    @classmethod
    def tearDownClass(cls):
        cls.robot.end()
        gc.enable()
        sys.stdin.close()
        place, sys.stdin = cls.before
        os.chdir(place)
        shutil.rmtree(cls.top)

    @classmethod
    def do(cls, words):
        """What a command prints, which has to succeed and to say nothing."""
        program = cls.robot.run(words)
        assert (program.status, program.error.text()) == (0, ""), (words[0], program.error.text())
        return program.out.text()

    def tearDown(self):
        created = [name for _, _, names in os.walk(self.top) for name in names]
        self.assertEqual([name for name in created if name.startswith("canary")], [])

    def test_paths_that_are_printed_can_be_typed(self):
        listed = self.do(["rtfind", HOME]).splitlines()
        self.assertGreater(len(listed), 2 * len(hostile.KEYS))
        self.do(["rtls", "-l", *listed])
        components = [line for line in listed if line.endswith(".rtc")]
        # some have two names, and the manager has them, too
        self.assertEqual(len(components), 2 * len(hostile.KEYS))
        ports = []
        for line in self.do(["rtcat", "--json", *components]).splitlines():
            ports += [port["path"] for port in json.loads(line)["ports"]]
        self.assertEqual(len(ports), 4 * len(components))
        self.do(["rtcat", *ports])

    def test_completions_are_single_words(self):
        quoted = text.shell_word(str(self.place.component("quotes")))
        for line in ("rtcat /robot/", f"rtcat {HOME}/", f"rtconf {quoted} set "):
            offered = self.do(["rtcwd", "--shell=bash", f"--line={line}", "--word="]).splitlines()
            short = [words for words in offered if len(words) < LONGEST_WORD]
            self.assertTrue(short, line)
            script = "".join(f"set -- {words}; echo $#\n" for words in short)
            for shell in hostile.SHELLS:
                ran = subprocess.run(
                    shell, input=script.encode(), stdout=subprocess.PIPE, stderr=subprocess.PIPE
                )
                self.assertEqual((ran.stdout, ran.stderr), (b"1\n" * len(short), b""), (shell, script))

    def test_nothing_harmful_is_printed(self):
        tried = []
        for some in plan():
            robot = Robot()
            for case in some:
                os.chdir(tempfile.mkdtemp(dir=self.top))
                with self.subTest(str(case)):
                    self.assertEqual(case.problems(robot, self.place), [], getattr(case, "err", ""))
            robot.end()
            tried += some
        on_terminal = [case for case in tried if case.on_terminal]
        shown = [case for case in on_terminal if hostile.OWN.search(getattr(case, "out", ""))]
        self.assertTrue(shown)  # commands take it for a terminal
        print(
            f"figures: {len(tried)} command lines about {len(hostile.KEYS)} kinds of hostile text, "
            f"{len(on_terminal)} of them on a terminal"
        )


if __name__ == "__main__":
    unittest.main()
