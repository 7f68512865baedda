"""Every block with `$` in README.md and docs/ prints what it shows, on the robot of `rtshell_lite demo`.

All blocks are typed into one bash, on a terminal that is `dumb`: with the heads of columns, without colours.

  - What follows a command must be printed, and nothing else; nothing at all where nothing follows.
  - Where only a remark (`  # …`) says what a command prints, it may print anything.
  - `…` is any text, alone on a line any lines. Fractions, times, process numbers and TCP ports vary.
  - `cat FILE` shows what is in it: the file is made so.
"""

import difflib
import os
import pty
import re
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import termios
import time
import unittest

import processes
import worlds

LONG = "it types every block"
BOTH = "commands ask the demo by each ORB"

# numbers that differ each time
VARIES = re.compile(r"(127\.0\.0\.1:\d+|-?\d+\.\d+|\d\d:\d\d:\d\d|pid \d+|…)")
# what rtdoctor says of this machine, not of the robot
HERE = re.compile(r"^(?:warn|fail)  here: .*\n", re.MULTILINE)
HOT = "rtconf arm.host_cxt/Gripper0.rtc set limit 25 && rtfind -q --wait 60 --state error ."
COOL = HOT.replace("25", "1000").replace("error .", "active . -n Gripper0.rtc")
SETTLED = "until rtkeep status 2>&1 | grep -q 'all is as the file says'; do sleep 0.1; done"
# What is done before a command, and statuses other than 0.
PREPARED = {
    'rtdoctor -q                       # a minute later: the hand is hot': HOT,
    'eval "$(python3 -m rtshell_lite --unpack ~/rtshell_lite)"  # the commands, on PATH': "unset RTCSH_CWD",
    "rtcryo --all -o robot.rtsys": COOL,
    "rtdis arm.host_cxt/Planner0.rtc:elbow arm.host_cxt/Elbow0.rtc:target": SETTLED,
    "rtstodot --live --text --around arm.host_cxt/Gripper0.rtc": "rtstart robot.rtsys && " + HOT,
}
STATUS = {"rtdoctor -q": 1}
DEMO = "python3 -m rtshell_lite demo"
STARTING = (DEMO, "rtkeep --processes robot.procs &")  # the demo, which needs our own ORB
PORT = "15005"  # of docs/keeping.md; another one here
SHELL = """\
while IFS= read -r _file <&3; do
    . "$_file"
    printf '%s%s\\n' '-- status ' $?
done
"""


def read(*path):
    with open(os.path.join(processes.ROOT, *path), encoding="utf-8") as file:
        return file.read()


def papers():
    """Names of the papers, README.md first, in which the demo is started."""
    pages = sorted(name for name in os.listdir(os.path.join(processes.ROOT, "docs")) if name.endswith(".md"))
    return ["README.md"] + [os.path.join("docs", name) for name in pages]


def blocks(paper):
    """The blocks of a paper: each [(a command, the text that it prints, or None for any)]."""
    for block in re.findall(r"^```.*\n((?:.*\n)*?)```$", read(paper), re.MULTILINE):
        steps = [step.partition("\n") for step in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]]
        if steps:
            yield [(typed, shown if shown or "  # " not in typed else None) for typed, _, shown in steps]


def commands():
    """All that is typed."""
    return [command for paper in papers() for block in blocks(paper) for command, _ in block]


def pattern(shown):
    """The pattern of what is printed where a paper shows this text."""
    return "".join("(?:.*\n)*" if line == "…\n" else _line(line) for line in shown.splitlines(True))


def _line(shown):
    words = [re.escape(word) for word in VARIES.split(shown)]
    for at in range(1, len(words), 2):  # what varies
        word = words[at].replace("\\", "").lstrip("-").replace(".", "\\.")
        words[at] = ".*" if word == "…" else "-?" + re.sub(r"\d+", r"\\d+", word)
    return "".join(words)


class Terminal:
    """A bash on a terminal, which runs files one by one."""

    def __init__(self, directory):
        self.directory = directory
        self.number = 0
        programs = os.path.join(directory, "programs")
        os.mkdir(programs)
        self.program(programs, "python3", '"%s"' % sys.executable)
        ours = "env RTSHELL_ORB=builtin"  # what the demo needs
        self.program(programs, "rtshell_lite", '%s "%s" -m rtshell_lite' % (ours, sys.executable))
        # the timeout: what is silent is no subject of papers, and a busy machine is slow
        environment = dict(
            worlds.ENVIRONMENT, HOME=directory, TERM="dumb", LC_ALL="C.UTF-8", PYTHONDONTWRITEBYTECODE="1",
            RTSHELL_TIMEOUT="15", PATH=os.pathsep.join([programs, worlds.COMMANDS, os.environ["PATH"]]),
        )
        for name in "RTCTREE_NAMESERVERS", "RTCSH_CWD", "COLUMNS", "NO_COLOR":
            environment.pop(name, None)
        self.screen, terminal = pty.openpty()
        settings = termios.tcgetattr(terminal)
        settings[1] &= ~termios.OPOST  # lines end as they are printed
        settings[3] &= ~termios.ECHO
        termios.tcsetattr(terminal, termios.TCSANOW, settings)
        files, self.files = os.pipe()
        self.process = subprocess.Popen(
            ["bash", "--norc", "-c", "exec 3<&%d\n%s" % (files, SHELL)], stdin=terminal, stdout=terminal,
            stderr=terminal, pass_fds=[files], cwd=directory, env=environment, start_new_session=True,
        )
        os.close(terminal)
        os.close(files)

    def program(self, directory, name, command):
        path = os.path.join(directory, name)
        with open(path, "w") as file:
            file.write('#!/bin/sh\nexec %s "$@"\n' % command)
        os.chmod(path, 0o755)

    def type(self, line, is_enough):
        """Run a line, until it has ended and is_enough(printed), LIMIT at most; returns what was
        printed, and its status, None if it did not end.
        """
        self.number += 1
        path = os.path.join(self.directory, "line-%d" % self.number)
        with open(path, "w", encoding="utf-8") as file:
            file.write(line + "\n")
        os.write(self.files, (path + "\n").encode())
        printed, status = b"", None
        end = time.monotonic() + worlds.LIMIT
        while time.monotonic() < end:
            if select.select([self.screen], [], [], 0.1)[0]:
                printed += os.read(self.screen, 65536)
            ended = re.search(rb"^-- status (\d+)\n", printed, re.MULTILINE)
            if ended:
                status = int(ended.group(1))
                printed = printed[: ended.start()] + printed[ended.end() :]
            text = printed.decode("utf-8", "replace")
            if status is not None and is_enough(text):
                break
        return printed.decode("utf-8", "replace"), status

    def close(self):
        try:
            os.killpg(self.process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        self.process.wait()
        os.close(self.files)
        os.close(self.screen)


@unittest.skipUnless(shutil.which("bash"), "bash is not installed")
class Papers(unittest.TestCase):
    def setUp(self):
        directory = tempfile.mkdtemp(prefix="rt-")
        self.addCleanup(shutil.rmtree, directory, ignore_errors=True)
        self.terminal = Terminal(directory)
        self.addCleanup(self.terminal.close)
        self.port = PORT

    def prepare(self, line):
        """Run a line that no paper shows."""
        printed, status = self.terminal.type(line, lambda printed: True)
        self.assertEqual(status, 0, "%s\n%s" % (line, printed))

    def test_blocks(self):
        for paper, block in [(paper, block) for paper in papers() for block in blocks(paper)]:
            if paper != "README.md":
                self.prepare("export RTCSH_CWD=/$RTCTREE_NAMESERVERS")
            for command, shown in block:
                self.play(paper, command, shown)
            self.prepare("for job in $(jobs -p | tail -n +2); do wait $job; done || true")  # all but the demo

    def play(self, paper, command, shown):
        """Run a command of a paper, and compare what it prints."""
        if command.startswith("cat "):
            self.port = str(processes.nameserver.free_port())  # not earlier: others look for one, too
            with open(os.path.join(self.terminal.directory, command[4:]), "w") as file:
                file.write(shown.replace(PORT, self.port))
        if command in PREPARED:
            self.prepare(PREPARED[command])
        expected = re.compile(pattern("" if shown is None else shown))

        def fits(printed):
            return shown is None or expected.fullmatch(HERE.sub("", printed).replace(self.port, PORT))

        line = "RTSHELL_ORB=builtin " + command if command in STARTING else command
        line += " &" if command == DEMO else ""
        printed, status = self.terminal.type(line, fits)
        if not fits(printed):
            lines = difflib.unified_diff(shown.splitlines(), printed.splitlines(), paper, "here", lineterm="")
            self.fail("$ %s\n%s" % (command, "\n".join(lines)))
        said = "%s: $ %s\n%s" % (paper, command, printed)
        self.assertEqual(status, STATUS.get(re.sub("  +#.*", "", command), 0), said)
        if command == DEMO:
            self.prepare(re.search("export .*", printed).group())

    def test_there_are_some(self):
        self.assertGreater(len(commands()), 15)
        self.assertEqual(commands()[0], DEMO)

    def test_nothing_is_prepared_that_is_gone(self):
        self.assertEqual(sorted(set(PREPARED) - set(commands())), [])


class Patterns(unittest.TestCase):
    def fits(self, shown, printed):
        return bool(re.fullmatch(pattern(shown), printed))

    def test_what_varies(self):
        self.assertTrue(self.fits("[1795826720.734976291] -0.4771\n", "[1895826720.134976291] 0.5\n"))
        self.assertTrue(self.fits("[1795826720.734976291] 0.4771\n", "[1895826720.134976291] -1.5\n"))
        self.assertTrue(self.fits("[14:02:14] /127.0.0.1:1/A: is\n", "[04:32:19] /127.0.0.1:47011/A: is\n"))
        self.assertTrue(self.fits("a …\n…\n", "a b\nc\n\n"))
        self.assertTrue(self.fits("", ""))

    def test_what_does_not(self):
        self.assertFalse(self.fits("Active  2/2\n", "Active  2/1\n"))
        self.assertFalse(self.fits("a\n", "a\nb\n"))
        self.assertFalse(self.fits("", "a\n"))
        self.assertFalse(self.fits("a …\n", "b c\n"))


if __name__ == "__main__":
    unittest.main()
