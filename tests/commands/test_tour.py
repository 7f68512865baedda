"""mock_components/tour, without its installation: if this fails, the first thing that a newcomer tries does.
"""
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
import unittest

import mounts
import processes
import tools
import worlds

import rtshell_lite

ONCE = "it runs commands that other tests run on all Pythons"

# A Python whose installation of packages does nothing, and one that cannot make environments
FOUND = '#!/bin/sh\n[ "$1 $2" = "-m pip" ] || exec "%s" "$@"\n'
BROKEN = '#!/bin/sh\n[ "$1 $2" != "-m venv" ] || { echo "no venv" >&2; exit 1; }\nexec "%s" "$@"\n'


class Tour(unittest.TestCase):
    def setUp(self):
        self.top = os.path.realpath(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.top, ignore_errors=True)
        os.makedirs(os.path.join(self.top, ".venv-tour", "bin"))
        self.program(os.path.join(".venv-tour", "bin", "python"), FOUND)
        self.made_from(sys.base_prefix, *sys.version_info[:3])
        os.symlink(worlds.COMMANDS, os.path.join(self.top, "bin"))
        for package in os.path.join(processes.ROOT, "mock_components"), os.path.dirname(
            rtshell_lite.__file__
        ):
            os.symlink(package, os.path.join(self.top, os.path.basename(package)))
        self.words = ["sh", os.path.join(self.top, "mock_components", "tour")]
        self.environment = dict(
            worlds.ENVIRONMENT,
            PATH=worlds.COMMANDS + os.pathsep + os.environ["PATH"],
            PYTHON=sys.executable,
            PYTHONDONTWRITEBYTECODE="1",
            LC_ALL="C.UTF-8",
            TMPDIR=self.top,
        )

    def program(self, name, text):
        path = os.path.join(self.top, name)
        with open(path, "w") as file:
            file.write(text % sys.executable)
        os.chmod(path, 0o755)
        return path

    def made_from(self, *words):
        with open(os.path.join(self.top, ".venv-tour", "made-from"), "w") as file:
            print(*words, file=file)

    def run_it(self, *words, before=(), **environment):
        """Status and output, without a terminal."""
        done = subprocess.run(
            list(before) + self.words + list(words),
            env=dict(self.environment, **environment),
            timeout=300,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
        )
        return done.returncode, done.stdout.decode("utf-8", "replace")

    def needs_omninames(self):
        if not processes.nameserver.binary():
            self.skipTest("needs omniORBpy and omniNames")

    def test_it_runs_and_does_what_it_says(self):
        self.needs_omninames()
        status, said = self.run_it()
        self.assertEqual(status, 0, said)
        self.assertEqual(
            re.findall(r"\$ (.*)\n(?:[^$\n].*\n)*\(exit status (\d+)\)", said),
            [
                ("rtcon ConsoleIn0.rtc:out MyServiceProvider0.rtc:MyService", "2"),
                ("rtact Broken0.rtc", "6"),
                ("rtdoctor -q Broken0.rtc", "1"),
                ("rtcall Robot0.rtc:svc sey hello", "3"),
                ("rtcall Robot0.rtc:svc say hello", "6"),
                ("rtcall Robot0.rtc:svc move_to 'Point(30, 4)' seconds=0", "6"),
                ("rttrace -t 1 Link0.rtc:out", "1"),
            ]
            + [("echo nonsense | tee ConsoleIn0.rtc/state", "1")] * (not mounts.refused()),
            said,
        )
        self.assertNotIn("Enter goes on", said, "it waits on terminals only")
        self.assertRegex(said, r"(?m)^fail  \S+/Broken0.rtc: in Error; try: rtreset ")
        self.assertNotIn("grep: ", said)
        self.assertRegex(said, r"(?m)^/localhost:\d+/line.host_cxt/Link1.rtc: it is Inactive \(certain\)$")
        self.assertRegex(said, r"\$ rtprint -n 3 Link1.rtc:out\n(\[[\d.]+\] \d+\n){3}\n")
        contents = re.findall(r"^  (\d  [A-Z]\w+( \w+)?)  ", said, re.MULTILINE)
        self.assertEqual([line for line, _ in contents], re.findall(r"^\d  [A-Z].*$", said, re.MULTILINE))

    def check_demo(self, said):
        """The tour was played on the robot of the demo."""
        self.assertEqual(
            re.findall(r"\$ (.*)\n(?:[^$\n].*\n)*\(exit status (\d+)\)", said),
            [
                ("rtcon Planner0.rtc:grip ../base.host_cxt/Laser0.rtc:pose", "2"),
                ("rtact Gripper0.rtc", "6"),
                ("rtdoctor -q", "1"),
                ("rtcall Camera0.rtc:capture.camera tak_one_frame", "3"),
                ("rttrace -t 1 Planner0.rtc:grip", "1"),
            ]
            + [("echo nonsense | tee Planner0.rtc/state", "1")] * (not mounts.refused()),
            said,
        )
        self.assertRegex(said, r"(?m)^fail  \S+/Gripper0.rtc: in Error; try: rtreset ")
        self.assertRegex(said, r"(?m)^\S+/Gripper0.rtc: it is Inactive \(certain\)$")
        self.assertRegex(said, r"restored connection")
        self.assertRegex(said, r"\$ rtprint -n 3 Shoulder0.rtc:angle\n(\[[\d.]+\] -?[\de.-]+\n){3}\n")
        for shown in "rtstodot --live --html", "rttop -n 1", "rtplot -f":
            self.assertIn("$ " + shown, said)
        contents = re.findall(r"^  (\d  [A-Z]\w+( \w+)?)  ", said, re.MULTILINE)
        self.assertEqual([line for line, _ in contents], re.findall(r"^\d  [A-Z].*$", said, re.MULTILINE))
        self.assertEqual(sorted(os.listdir(self.top)), self.lasting())

    def lasting(self):
        """What is there before the tour, and after it."""
        return [".venv-tour", "bin", "mock_components", "rtshell_lite"]

    def test_on_the_demo(self):
        """It needs no omniORBpy, runs on Python 3.6, and leaves no process."""
        status, said = self.run_it("--demo")
        self.assertEqual(status, 0, said)
        self.check_demo(said)

    def test_it_looks_into_files_that_may_not_be_there_yet(self):
        """Those of commands in the background: grep -s says nothing of it."""
        with open(self.words[1], encoding="utf-8") as file:
            looks = re.findall(r'soon "(grep .*)"', file.read())
        self.assertEqual(len(looks), 3)
        for look in " && ".join(looks).split(" && "):
            self.assertTrue(look.startswith("grep -qs "), look)

    def test_chapters_wait_for_enter_on_a_terminal(self):
        """Ctrl-C ends the tour, and leaves the terminal as it was, and no file."""
        self.needs_omninames()
        waits = "Enter goes on"
        looking = "m1  Looking\x1b"
        connecting = "m2  Connecting\x1b"
        for words, talk in ([], [(waits, b"\n"), (looking, b""), (waits, b"\3")]), (
            ["--no-pause"],
            [(looking, b""), (connecting, b"\3")],
        ):
            with self.subTest(words):
                child, terminal = pty.fork()
                if child == 0:
                    signal.signal(signal.SIGINT, signal.SIG_DFL)
                    os.execvpe("sh", self.words + words, self.environment)
                before = termios.tcgetattr(terminal)
                said = ""
                for data in tools.printed_on(terminal):
                    said += data.decode("utf-8", "replace")
                    while talk and talk[0][0] in said:
                        (heard, key), *talk = talk
                        said = said.partition(heard)[2]
                        os.write(terminal, key)
                status = os.waitpid(child, 0)[1]
                self.assertEqual((talk, os.WIFEXITED(status) and os.WEXITSTATUS(status)), ([], 130), said)
                self.assertEqual(termios.tcgetattr(terminal), before)
                os.close(terminal)
                self.assertEqual(
                    sorted(os.listdir(self.top)), [".venv-tour", "bin", "mock_components", "rtshell_lite"]
                )

    def test_a_shell_to_play_in(self):
        """rtcwd changes its directory; in bash and zsh, TAB completes."""
        self.needs_omninames()
        for shell, typed in ("bash", b"rtls Brok\t"), ("zsh", b"rtls Brok\t"), ("dash", b"rtls Broken0.rtc "):
            if not shutil.which(shell):
                continue
            environment = dict(self.environment, SHELL=shutil.which(shell), HOME=self.top, TERM="dumb")
            child, terminal = pty.fork()
            if child == 0:
                os.execvpe("sh", self.words + ["--shell"], environment)
            talk = [
                ("Leave with exit", b"rtcwd ../plant.host_cxt && rtpwd | tr a-z A-Z\n"),
                ("PLANT.HOST_CXT", b"rtcwd ../test.host_cxt\n" + typed + b"| tr a-z A-Z\n"),
                ("BROKEN0.RTC", b"exit\n"),
            ]
            said = ""
            while select.select([terminal], [], [], worlds.LIMIT)[0]:
                try:
                    said += os.read(terminal, 10000).decode("utf-8", "replace")
                except OSError:
                    break
                if talk and talk[0][0] in said:
                    (heard, keys), *talk = talk
                    said = said.partition(heard)[2]
                    os.write(terminal, keys)
            os.close(terminal)
            os.waitpid(child, 0)
            self.assertEqual(talk, [], (shell, said))

    @unittest.skipUnless((3, 7) <= sys.version_info[:2] <= (3, 13), "no omniORBpy for this Python")
    def test_another_python_means_another_environment(self):
        """One that cannot be made has the tour played on the demo."""
        self.made_from(sys.base_prefix, 3, 1, 4)
        status, said = self.run_it(PYTHON=self.program("broken", BROKEN))
        self.assertEqual(
            (status, said.splitlines()[:3]),
            (
                0,
                [
                    "Installing omniORBpy into a private environment, once ...",
                    "no venv",
                    "Mock components need omniORBpy, which cannot be had here; the tour is played on the "
                    "robot of rtshell_lite demo.",
                ],
            ),
        )
        self.assertFalse(os.path.exists(os.path.join(self.top, ".venv-tour", "made-from")))
        self.assertIn("$ rtls -l\nActive  0/0  0/0  0/0  0/0  Arm0.rtc\n", said)

    def test_pythons_that_will_not_do(self):
        self.assertEqual(self.run_it(PYTHON="/no/python"),
                         (1, "tour: /no/python not found; name a Python 3.6 or later with PYTHON=...\n"))
        self.assertEqual(self.run_it(PYTHON="false"), (1, "tour: false is not Python 3.6 or later; name "
                                                          "one with PYTHON=...\n"))
        self.words = [os.path.join(processes.ROOT, "tests", "run")]
        self.assertEqual(self.run_it(PYTHON="/no/python"), (1, "tests/run: /no/python not found; it "
                                                               "needs Python 3.6 or later\n"))
        self.assertEqual(self.run_it(PYTHON="false"), (1, "tests/run: false is too old; it needs Python "
                                                          "3.6 or later\n"))

    def test_a_network_without_loopback(self):
        """One line, at once, from the tour and from tests/run."""
        alone = ["unshare", "--map-root-user", "--net"]
        if not shutil.which("unshare") or subprocess.call(alone + ["true"], stderr=subprocess.DEVNULL):
            self.skipTest("no network namespace can be made")
        needed = (
            "127.0.0.1 does not work here (Network is unreachable); in a new network namespace: ip link "
            "set lo up\n"
        )
        if processes.nameserver.binary():
            self.assertEqual(
                self.run_it(before=alone), (1, "tour: nameserver does not start: nameserver: " + needed)
            )
        self.words = [os.path.join(processes.ROOT, "tests", "run")]
        self.assertEqual(self.run_it("rtpwd", before=alone), (1, "tests/run: " + needed))

    def test_unknown_words(self):
        usage = "usage: mock_components/tour [--demo] [--no-pause | --shell]\n"
        self.assertEqual(self.run_it("--pause"), (2, usage))


class Mocks(unittest.TestCase):
    """What can be tried without omniORBpy: -S leaves out what is installed."""

    def run_it(self, *words):
        done = subprocess.run(
            [sys.executable, "-S", "-m"] + list(words),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            env=dict(os.environ, PYTHONPATH=processes.ROOT),
            cwd="/",
        )
        return done.returncode, done.stdout.decode(), done.stderr.decode()

    def test_list_of_worlds(self):
        status, said, failures = self.run_it("mock_components", "--list")
        self.assertEqual((status, failures), (0, ""))
        self.assertRegex(said, r"(?m)^two +ConsoleIn0 and ConsoleOut0, not connected$")

    def test_nobody_reads_the_list(self):
        nowhere, end = os.pipe()
        os.close(nowhere)
        self.addCleanup(os.close, end)
        done = subprocess.run(
            [sys.executable, "-m", "mock_components", "--list"],
            stdin=subprocess.DEVNULL,
            stdout=end,
            stderr=subprocess.PIPE,
            env=dict(os.environ, PYTHONPATH=processes.ROOT),
            cwd="/",
        )
        self.assertEqual((done.returncode, done.stderr), (-signal.SIGPIPE, b""))

    def test_no_omniorb(self):
        status, said, failures = self.run_it("mock_components", "two")
        self.assertEqual((status, said), (2, ""))
        self.assertRegex(
            failures, r"mock_components: error: needs omniORBpy \(for Python 3\.7 to 3\.13\)\n\Z"
        )

    def test_no_name_server(self):
        status, said, failures = self.run_it("mock_components.nameserver")
        self.assertEqual((status, said), (1, ""))
        self.assertRegex(failures, r"\Anameserver: omniNames is not here; .*\n\Z")


if __name__ == "__main__":
    unittest.main()
