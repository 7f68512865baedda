"""Every example in docstrings (and so in --help and the manual pages) and in README.md does what it says.

Each line is run by sh in a directory with robot.rtsys in it, on a robot of mock components, fresh for each command. A new
command's examples are run without a word here, unless they need something special: see PREPARED, NAMES, STATUS, ENDLESS.
"""
import ast
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

import mocks
import peers
from mocks import Server, World

from rtshell_lite import orb

ONCE = "each example is run by the tests of its command on all Pythons, in other words"

ROBOT = ["ConsoleIn:ConsoleIn0", "ConsoleOut:ConsoleOut0", "Sensor:Sensor0", "Controller:Controller0", "Motor:Motor0",
         "ConfigSample:ConfigSample0", "MyServiceProvider:MyServiceProvider0", "MyServiceConsumer:MyServiceConsumer0",
         "SequenceOutComponent:SequenceOutComponent0", "Microwave:Microwave0", "Source:Source0"]
CONTEXT = "robot.host_cxt"
SYSTEM = "rtresurrect robot.rtsys && rtstart -q robot.rtsys >/dev/null"

# What is done before the examples of a command, or before one line; a tuple is the world that is there instead, from the start.
FRESH = ("these",) + tuple(ROBOT)
PREPARED = {
    "rtcheck": SYSTEM, "rtcryo": SYSTEM, "rtdoctor": SYSTEM, "rtstodot": SYSTEM, "rtteardown": SYSTEM,
    "rtcheck -s Inactive robot.rtsys": "rtstop -q robot.rtsys >/dev/null",
    "rtcon -p dataport.subscription_type=flush ConsoleIn0.rtc:out ConsoleOut0.rtc:in": "rtdis ConsoleIn0.rtc",
    "rtcryo | rtteardown": SYSTEM,
    "rtdis": "rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in",
    "rtdis -i 68f0a2bc-e582-11f1-9d6a-e5443183122b ConsoleIn0.rtc:out":
        "rtcon -i 68f0a2bc-e582-11f1-9d6a-e5443183122b ConsoleIn0.rtc:out ConsoleOut0.rtc:in",
    "rtdel -z Motor0.rtc": "kill -9 $ROBOT; until rtfind / -t z -q; do sleep 0.1; done",
    "rtexit --wait Motor0.rtc Sensor0.rtc": FRESH,
    "rtlog": "rtact Source0.rtc", "rtprint": "rtact Source0.rtc",
    "rtlog --json -f run.rtlog | grep force": "rtlog -f run.rtlog -t 1 Source0.rtc:number.force",
    "rtprint --idl arm.idl Arm0.rtc:status": "echo 'module Arm { struct Status { long error; }; };' >arm.idl",
    "rtvlog": ("observed",),
    "until rtfind -q --state active / -n Motor0.rtc; do sleep 1; done": "rtact Motor0.rtc",
}
# Things that mocks do not have, and what stands for them. All hosts are this one.
NAMES = [
    ("arm.host_cxt", CONTEXT), ("old.host_cxt=robot2.host_cxt", "%s=%s" % (CONTEXT, CONTEXT)),
    ("localhost=robot2:2810", "localhost:@PORT@=localhost:@PORT@"), ("--manager robot", "--manager /localhost:@PORT@/robot"),
    ("corbaloc:iiop:robot:2810", "corbaloc:iiop:localhost:@MANAGER@"),
    ("Camera.so:CameraInit -c Camera", "Hokuyo_AIST.py:Hokuyo_AISTInit -c Hokuyo_AIST"),
    (r"(rtvlog.*) Arm0.rtc", r"\1"),
    ("Arm0.rtc:status", "Source0.rtc:number"),
    ("Arm0.rtc:joints", "Source0.rtc:number"), ("Hand0.rtc:force", "Source0.rtc:number"), ("Viewer0.rtc:in", "ConsoleOut0.rtc:in"),
    ("rtlog -f run.rtlog -t 60", "rtlog -f run.rtlog -t 1"), ("-t 5 ConsoleOut0", "-t 1 ConsoleOut0"),
    (r"(rtprint.*) ConsoleIn0.rtc:out", r"\1 Source0.rtc:number"),
    (r"/(localhost|robot1)(?=[/ \"']|$)", "/localhost:@PORT@"),
    (r"(?<![\w/.:@=])(localhost|robot1|robot2:2810)(?=[ ;]|$)", "/localhost:@PORT@"),
]
# Statuses other than 0.
STATUS = {
    """rtls -l | while read -r state ports in out svc name; do [ "$state" = Error ] && rtreset "$name"; done""": 1,  # no Error
}
ENDLESS = ("rtprint", "rtvlog", "rtwatch", "rttop")  # some of whose examples end with Ctrl-C
ELSEWHERE = {  # run by other tests
    "eval": "test_completion", "rtcwd --shell": "test_completion",
}
FIRST_WORDS = ("until", "while", "for", "if", "echo", "eval")
PATIENCE = 3.0   # seconds after which Ctrl-C is pressed
LIMIT = 30.0
TOP = tempfile.gettempdir()


def setUpModule():
    global TOP
    mocks.start_name_server()
    TOP = tempfile.mkdtemp()
    with open(os.path.join(TOP, "dot"), "w") as file:  # Graphviz, as far as it matters here
        file.write("#!/bin/sh\nexec cat\n")
    os.chmod(os.path.join(TOP, "dot"), 0o755)
    Server.root.bind_new_context(orb.naming_name([("old", "host_cxt")]))
    robot = Robot(TOP)
    try:
        status, said = robot.run("rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in && rtcon Sensor0.rtc:out Controller0.rtc:in && "
                                 "rtcryo -o %s/robot.rtsys" % TOP)
    finally:
        robot.close()
    if status:
        raise AssertionError(said)


def tearDownModule():
    Server.stop()
    shutil.rmtree(TOP)


def read(*path):
    with open(os.path.join(peers.ROOT, *path), encoding="utf-8") as file:
        return file.read()


def commands():
    return sorted(name for name in os.listdir(os.path.join(peers.ROOT, "bin")) if name.startswith("rt"))


def examples(command):
    """The lines of a docstring's examples, without the remarks beside them."""
    doc = ast.get_docstring(ast.parse(read("bin", command)))
    lines = doc.partition("\nexamples:\n")[2].split("\n")
    return [re.split(r" {2,}", line.strip())[0] for line in lines if line.strip()]


class Robot:
    """Mock components as the examples have them, and a directory to run them in."""

    def __init__(self, top):
        self.directory = tempfile.mkdtemp(dir=top)
        if os.path.exists(os.path.join(top, "robot.rtsys")):
            shutil.copy(os.path.join(top, "robot.rtsys"), self.directory)
        self.begin(FRESH)

    def begin(self, world):
        self.world = World("--context", CONTEXT + "/%n.rtc", *world)
        self.manager = World("--context", CONTEXT + "/%n.rtc", "manager", "Mock?instance_name=Spare0")

    def close(self):
        self.world.close()
        self.manager.close()

    def here(self, line):
        """The same with the names of this machine, where no name server has a port to be proud of."""
        for name, ours in NAMES:
            line = re.sub(name, ours, line) if "(" in name else line.replace(name, ours)
        return line.replace("@PORT@", str(Server.port)).replace("@MANAGER@", self.manager.ready.split()[-1])

    def prepare(self, what):
        if isinstance(what, tuple):
            self.close()
            self.begin(what)
        elif what:
            status, said = self.run(what)
            if status:
                raise AssertionError("%s\n%s" % (what, said))

    def start(self, line, words=("sh", "-c")):
        """A process of a shell that runs something here."""
        environment = dict(
            mocks.ENVIRONMENT, PATH=os.pathsep.join([TOP, mocks.COMMANDS, os.environ["PATH"]]), LC_ALL="C.UTF-8",
            RTCTREE_NAMESERVERS="localhost:%d" % Server.port, RTCSH_CWD="/localhost:%d/%s" % (Server.port, CONTEXT),
            PYTHONDONTWRITEBYTECODE="1", ROBOT=str(self.world.process.pid))
        return subprocess.Popen(list(words) + [line], cwd=self.directory, env=environment, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True)

    def run(self, line, endless=False, words=("sh", "-c")):
        """Status and output of what a shell runs."""
        return self.outcome(self.start(line, words), endless)

    def outcome(self, process, endless=False):
        try:
            out = process.communicate(timeout=PATIENCE if endless else LIMIT)[0]
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGINT if endless else signal.SIGKILL)
            out = process.communicate(timeout=LIMIT)[0]
        return process.returncode, out.decode("utf-8", "replace")


class Case(unittest.TestCase):
    def setUp(self):
        self.robot = Robot(TOP)
        self.addCleanup(self.robot.close)

    def check(self, line):
        command = line.partition(" ")[0]
        if any(line.startswith(start) for start in ELSEWHERE):
            return
        with self.subTest(line):
            self.robot.prepare(PREPARED.get(line))
            status, said = self.robot.run(self.robot.here(line), command in ENDLESS)
            allowed = (0, 130, -signal.SIGINT) if command in ENDLESS else (STATUS.get(line, 0),)
            self.assertIn(status, allowed, said)
            self.assertNotIn("internal error", said)


class Docstrings(Case):
    """One test a command, made below."""


def _test(command):
    def test(self):
        self.assertTrue(examples(command))
        self.robot.prepare(PREPARED.get(command))
        for line in examples(command):
            self.check(line)
    return test


for _command in commands():
    setattr(Docstrings, "test_" + _command, _test(_command))


def readme_lines():
    """What is to be typed in README.md; its other indented lines are drawings and tables."""
    lines = re.findall(r"^    (\S.*)$", re.sub(r"```(?:.*\n)*?```", "", read("README.md")), re.MULTILINE)
    return [line for line in lines if line.split()[0] in commands() + list(FIRST_WORDS)]


class Special(unittest.TestCase):
    def test_nothing_is_special_that_is_gone(self):
        known = set(commands() + readme_lines()).union(*map(examples, commands()))
        self.assertEqual([line for line in list(PREPARED) + list(STATUS) if line not in known], [])


class Readme(Case):
    """README.md; test_manpages compares the Japanese one with it."""

    def test_lines(self):
        for line in readme_lines():
            self.check(line)

    def test_library(self):
        program, = re.findall(r"```python\n((?:.*\n)*?)```", read("README.md"))
        self.robot.prepare("rtact Motor0.rtc")
        status, said = self.robot.run(program.replace('"/localhost', '"/localhost:%d' % Server.port), words=(sys.executable, "-c"))
        self.assertEqual(status, 0, said)
        self.assertIn("\nActive\n", said)

    def script(self, name):
        """One of the scripts: the file that it is in, and both shells to run it."""
        found, = [block for block in re.findall(r"```sh\n((?:.*\n)*?)```", read("README.md")) if "\n# " + name + " " in block + " "
                  or "\n# " + name + "\n" in block]
        path = os.path.join(self.robot.directory, name)
        with open(path, "w") as file:
            file.write(found)
        return path

    def in_shells(self, name, arguments, before, after):
        """Run a script in both shells, between a preparation and a check; returns what it says."""
        path, outputs = self.script(name), []
        for shell in "dash", "busybox ash":
            if shutil.which(shell.split()[0]):
                with self.subTest(shell):
                    self.robot.prepare(before)
                    status, said = self.robot.run("%s -eu %s %s" % (shell, path, arguments))
                    self.assertEqual(status, 0, said)
                    self.assertEqual(self.robot.run(after)[0], 0, said)
                    outputs.append(said)
        return outputs

    def test_start_robot(self):
        self.in_shells("start-robot", "Sensor0.rtc Motor0.rtc", "rtdeact --wait 5 Sensor0.rtc Motor0.rtc",
                       "rtfind / --state active -n Sensor0.rtc -q && rtfind / --state active -n Motor0.rtc -q")

    def test_start_robot_waits(self):
        """It is started before the components, as at boot."""
        self.robot.close()
        self.robot.run("rtdel -z")
        process = self.robot.start("dash %s Motor0.rtc" % self.script("start-robot"))
        self.robot.begin(FRESH)
        self.assertEqual(self.robot.outcome(process)[0], 0)
        self.assertEqual(self.robot.run("rtfind / --state active -n Motor0.rtc -q")[0], 0)

    def test_restart_failed(self):
        world = World("--context", CONTEXT + "/%n.rtc", "error")
        self.addCleanup(world.close)
        said = self.in_shells("restart-failed", "", None, "rtls -q")
        self.assertIn("Broken0.rtc was in Error", said[0])

    def test_keep_robot(self):
        self.in_shells("keep-robot", "save saved.rtsys", SYSTEM, "cmp -s saved.rtsys robot.rtsys || rtcheck saved.rtsys")
        self.in_shells("keep-robot", "restore robot.rtsys", "rtstop robot.rtsys && rtteardown robot.rtsys", "rtcheck robot.rtsys")

    def test_log_port(self):
        """It ends when the disk is full: here after two files, because of our `df`."""
        with open(os.path.join(TOP, "df"), "w") as file:
            file.write("#!/bin/sh\necho; if [ $(ls logs | wc -l) -lt 2 ]; then echo a b c 999999; else echo a b c 10; fi\n")
        os.chmod(os.path.join(TOP, "df"), 0o755)
        self.addCleanup(os.remove, os.path.join(TOP, "df"))
        self.in_shells("log-port", "Source0.rtc:number logs 1.2", "rm -rf logs; mkdir logs; rtact Source0.rtc",
                       "test $(ls logs | wc -l) = 2 && rtlog -d -f logs/$(ls logs | head -n 1)")


if __name__ == "__main__":
    unittest.main()
