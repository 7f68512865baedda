"""Every example in docstrings (and so in --help and the manual pages), in README.md and docs/ does what it says.

Each line is run by sh in a directory with robot.rtsys in it, on a robot of mock components, fresh for each
command that may change it. What is special about those of a command is stated in its transcript, as in
tests/support/invocations.py:

  examples: asking        they only ask: they share a robot whose system runs, with those of other such commands, and are quick
  examples: endless       they are run at the same time, and some end with Ctrl-C
  prepared: SHELL         what is done before them; `world WORDS` starts that world instead of the robot
  example: LINE <- SHELL  what is done before this one; `world` alone starts the robot anew
  example: LINE -> 1      its exit status
"""  # noqa: E501

import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

import invocations
import mounts
import processes
import transcripts
import worlds
from worlds import Server, World

from rtshell_lite.corba import orb
from rtshell_lite.data import datatypes, values

ONCE = "each example is run by the tests of its command on all Pythons, in other words"
LONG = "it plays every example"

ROBOT = [
    "ConsoleIn:ConsoleIn0",
    "ConsoleOut:ConsoleOut0",
    "Sensor:Sensor0",
    "Controller:Controller0",
    "Motor:Motor0",
    "ConfigSample:ConfigSample0",
    "MyServiceProvider:MyServiceProvider0",
    "MyServiceConsumer:MyServiceConsumer0",
    "SequenceOutComponent:SequenceOutComponent0",
    "Microwave:Microwave0",
    "Source:Source0",
]
CONTEXT = "robot.host_cxt"
SYSTEM = "rtresurrect robot.rtsys && rtstart -q robot.rtsys >/dev/null"

FRESH = ("these",) + tuple(ROBOT)
STATED = [
    re.match("(.*) (<-|->) (.*)$", words).groups()
    for lines in invocations.stated("example").values()
    for words in lines
]
# What is done before the examples of a command, or before one line.
PREPARED = {command: lines[0] for command, lines in invocations.stated("prepared").items()}
PREPARED.update({line: what for line, arrow, what in STATED if arrow == "<-"})
# in docs/scripts.md
PREPARED['rtfind -q --wait 60 --state active / -n Motor0.rtc || echo "Motor0 is not Active"'] = (
    "rtact Motor0.rtc"
)
# Things that mocks do not have, and what replaces them. All hosts are this one.
NAMES = [
    ("--map robot=localhost --only '*Image*'", "--only '*Console*'"),
    ("--serve 2809 --loop", "--serve @FREE@ -t 1"),
    ("--listen -l", "--listen @FREE@ -l"),
    ("--listen 0.0.0.0:24224 --from", "--listen 0.0.0.0:@FREE@ --from"),
    ("--when-connected replay.host_cxt", "-t 1 replay.host_cxt"),
    ("arm.host_cxt", CONTEXT),
    ("old.host_cxt=robot2.host_cxt", "%s=%s" % (CONTEXT, CONTEXT)),
    ("localhost=robot2:2810", "localhost:@PORT@=localhost:@PORT@"),
    ("--manager robot", "--manager /localhost:@PORT@/robot"),
    ("corbaloc:iiop:robot:2810", "corbaloc:iiop:localhost:@MANAGER@"),
    ("Camera.so:CameraInit -c Camera", "Hokuyo_AIST.py:Hokuyo_AISTInit -c Hokuyo_AIST"),
    (r"(rtvlog.*) Arm0.rtc", r"\1"),
    ("Arm0.rtc:status", "Source0.rtc:number"),
    ("Arm0.rtc:joints", "Source0.rtc:number"),
    ("Hand0.rtc:force", "Source0.rtc:number"),
    ("Viewer0.rtc:in", "ConsoleOut0.rtc:in"),
    ("rtlog record -f run.mcap -t 60", "rtlog record -f run.mcap -t 5"),  # a busy machine takes long to begin
    ("run.mcap -i -e 1000", "run.mcap -i -e 250"),
    ("-s 100 -e 200", "-s 100 -e 106"),  # what the buffer of a port has room for, on a busy machine
    ("rtlog ring", "rtlog ring -t 5"),
    ("rtlog record --rotate", "rtlog record -t 5 --rotate"),
    ("-t 5 ConsoleOut0", "-t 1 ConsoleOut0"),
    (r"(rtprint.*) ConsoleIn0.rtc:out", r"\1 Source0.rtc:number"),
    (r"/(localhost|robot1)(?=[/ \"']|$)", "/localhost:@PORT@"),
    ("/robot1:2809", "/localhost:@PORT@"),
    (r"(?<![\w/.:@=])(localhost|robot1:2809|robot1|robot2:2810)(?=[ ;]|$)", "/localhost:@PORT@"),
]
# Statuses other than 0.
STATUS = {line: int(what) for line, arrow, what in STATED if arrow == "->"}
STATUS["rtstodot --text --live --broken"] = 1  # nothing is
# they are not connected
STATUS["rttrace Sensor0.rtc:out --to Motor0.rtc:in"] = STATUS["rttrace -u Motor0.rtc:in -t 10 --plot"] = 1
ENDLESS, ASKING = ([command for command, lines in invocations.stated("examples").items() if word in lines]
                   for word in ("endless", "asking"))
ELSEWHERE = {  # run by other tests
    "eval": "test_completion", "rtcwd --shell": "test_completion", "rtkeep status": "rtkeep-steering.t",
}
FIRST_WORDS = ("until", "while", "for", "if", "echo", "eval")
# Other indented lines of papers: a path, what rtdoctor says, values (test_values), the tour (test_tour),
# and what runs this.
NO_COMMANDS = (
    "/localhost/", "fail  ", "RTC.", '{"data"',
    "mock_components/tour ", "tests/run ", "pip install ",
)
PATIENCE = 3.0   # seconds after which Ctrl-C is pressed
LIMIT = 90.0
TOP = tempfile.gettempdir()


def setUpModule():
    global TOP
    worlds.start_name_server()
    TOP = tempfile.mkdtemp()
    with open(os.path.join(TOP, "dot"), "w") as file:  # Graphviz, as far as it matters here
        file.write("#!/bin/sh\nexec cat\n")
    os.chmod(os.path.join(TOP, "dot"), 0o755)
    Server.root.bind_new_context(orb.naming_name([("old", "host_cxt")]))
    robot = Robot(FRESH)
    try:
        robot.prepare("rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in && rtcon Sensor0.rtc:out "
                      "Controller0.rtc:in && rtcryo -o ../robot.rtsys")
    finally:
        robot.close()


def tearDownModule():
    Server.stop()
    mounts.take_away(TOP)
    shutil.rmtree(TOP)


def read(*path):
    with open(os.path.join(processes.ROOT, *path), encoding="utf-8") as file:
        return file.read()


def commands():
    return invocations.all_commands()


def examples(command):
    """The lines of the examples of a command and of its verbs, without the remarks beside them."""
    helps = transcripts.helps(read("bin", command))
    lines = [line for text in helps for line in text.partition("\nexamples:\n")[2].split("\n")]
    found = [re.split(r" {2,}", line.strip())[0] for line in lines if line.strip()]
    return list(dict.fromkeys(found))  # what the help of a verb has, too


class Robot:
    """Mock components as the examples have them, and a directory to run them in."""

    def __init__(self, world):
        self.enter()
        self.begin(world)

    def enter(self):
        """Go to a new directory, with nothing but robot.rtsys in it."""
        self.directory = tempfile.mkdtemp(dir=TOP)
        if os.path.exists(os.path.join(TOP, "robot.rtsys")):
            shutil.copy(os.path.join(TOP, "robot.rtsys"), self.directory)

    def begin(self, world):
        self.worlds = [World("--context", CONTEXT + "/%n.rtc", *world)]
        self.manager = None

    def close(self):
        """End it, and take its names away: the next robot has some of the same."""
        for world in self.worlds:
            world.close()
        context = Server.root.resolve(orb.naming_name([CONTEXT.split(".")]))
        for bound in context.list(1000)[0]:
            try:
                context.unbind(bound.binding_name)
            except worlds.CosNaming.NamingContext.NotFound:
                pass  # slaves end after their master, and in good order

    def here(self, line):
        """The same with the names and ports of this machine."""
        for name, ours in NAMES:
            line = re.sub(name, ours, line) if "(" in name else line.replace(name, ours)
        line = line.replace("@PORT@", str(Server.port)).replace(
            "@FREE@", str(processes.nameserver.free_port())
        )
        return line.replace("@MANAGER@", self.manager_port() if "manager" in line else "")

    def manager_port(self):
        """The TCP port of its manager, which is started when an example speaks of one."""
        if self.manager is None:
            self.manager = World("--context", CONTEXT + "/%n.rtc", "manager", "Mock?instance_name=Spare0")
            self.worlds.append(self.manager)
        return self.manager.ready.split()[-1]

    def prepare(self, what):
        if what and what.split()[0] == "world":
            self.close()
            self.begin(what.split()[1:] or FRESH)
        elif what:
            status, said = self.run(what)
            if status:
                raise AssertionError("%s\n%s" % (what, said))

    def start(self, line, words=("sh", "-c")):
        """A process of a shell that runs something here."""
        environment = dict(
            worlds.ENVIRONMENT,
            PATH=os.pathsep.join([TOP, worlds.COMMANDS, os.environ["PATH"]]),
            LC_ALL="C.UTF-8",
            RTCTREE_NAMESERVERS="localhost:%d" % Server.port,
            RTCSH_CWD="/localhost:%d/%s" % (Server.port, CONTEXT),
            PYTHONDONTWRITEBYTECODE="1",
            ROBOT=str(self.worlds[0].process.pid),
        )
        return subprocess.Popen(
            list(words) + [line],
            cwd=self.directory,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )

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
        self.robot = Robot(FRESH)
        self.addCleanup(self.robot.close)

    def check(self, lines):
        """Run lines one by one."""
        for line in lines:
            with self.subTest(line):
                self.robot.prepare(PREPARED.get(line))
                self.judge(line, self.robot.start(self.robot.here(line)))

    def check_together(self, lines):
        """Run lines at the same time."""
        for line in lines:
            self.robot.prepare(PREPARED.get(line))
        processes = [(line, self.robot.start(self.robot.here(line))) for line in lines]
        for line, process in processes:
            with self.subTest(line):
                self.judge(line, process)

    def judge(self, line, process):
        """Wait until the process of a line ends."""
        endless = line.partition(" ")[0] in ENDLESS
        status, said = self.robot.outcome(process, endless)
        statuses = (STATUS.get(line, 0),)
        if endless:
            statuses = (0, 130, -signal.SIGINT)
        elif "its buffer is full (BUFFER_FULL)" in said:  # a component on a busy machine reads late
            statuses += (5,)
        self.assertIn(status, statuses, said)
        self.assertNotIn("internal error", said[-1000:])


class Asking(Case):
    """One test a command, made below, all on one robot."""

    @classmethod
    def setUpClass(cls):
        cls.robot = Robot(FRESH)
        cls.robot.prepare(SYSTEM + " && rtact Source0.rtc")

    @classmethod
    def tearDownClass(cls):
        cls.robot.close()

    def setUp(self):
        self.robot.enter()


class Changing(Case):
    """One test a command, made below, each on a robot of its own."""


def _test(command):
    def test(self):
        lines = examples(command)
        self.assertTrue(lines)
        if command == "rtmount" and mounts.refused():
            self.skipTest("nothing can be mounted here: " + mounts.refused())
        self.robot.prepare(PREPARED.get(command))
        check = self.check_together if command in ASKING + ENDLESS else self.check
        check([line for line in lines if not line.startswith(tuple(ELSEWHERE))])
    return test


for _command in commands():
    setattr(Asking if _command in ASKING else Changing, "test_" + _command, _test(_command))


def indented():
    """The indented lines of README.md and docs/*.md, outside of scripts."""
    pages = sorted(name for name in os.listdir(os.path.join(processes.ROOT, "docs")) if name.endswith(".md"))
    text = "".join([read("README.md")] + [read("docs", name) for name in pages])
    return re.findall(r"^    (\S.*)$", re.sub(r"```(?:.*\n)*?```", "", text), re.MULTILINE)


def paper_lines():
    """What is to be typed in papers, outside of blocks with `$`, which test_papers plays."""
    return [line for line in indented() if line.split()[0] in commands() + list(FIRST_WORDS)]


class Special(unittest.TestCase):
    def test_nothing_is_special_that_is_gone(self):
        known = set(commands() + paper_lines()).union(*map(examples, commands()))
        self.assertEqual([line for line in list(PREPARED) + list(STATUS) if line not in known], [])

    def test_nothing_is_overlooked(self):
        self.assertEqual(
            [line for line in indented() if line not in paper_lines() and not line.startswith(NO_COMMANDS)],
            [],
        )

    def test_values(self):
        """The values in docs/reference.md can be sent, as values of the types that they name."""
        types = datatypes.Types().load()
        lines = [re.split("  +", line) for line in indented() if line.startswith(("RTC.", "{"))]
        found = [word for words in lines for word in words[:-1 if len(words) > 1 else None]]
        self.assertGreater(len(found), 5)
        for word in found:
            with self.subTest(word):
                name = re.match(r"RTC\.\w+|", word).group() or "RTC.TimedLong"
                self.assertTrue(
                    types.named(name).encode(values.Expression(word, types, types.named(name)).value(0))
                )


class Papers(Case):
    """README.md and docs/; test_documentation compares the Japanese ones with them."""

    def test_lines(self):
        self.robot.prepare(SYSTEM + " && mkdir robot")
        mounted = () if mounts.refused() else ("robot/",)
        self.check([line for line in paper_lines() if not line.startswith(tuple(ELSEWHERE))
                    and (mounted or "robot/" not in line and "rtmount" not in line)])

    def test_library(self):
        program = re.findall(r"```python\n((?:.*\n)*?)```", read("docs", "library.md"))[0]
        self.robot.prepare("rtact Sensor0.rtc Motor0.rtc")
        status, said = self.robot.run(
            program.replace('"/localhost', '"/localhost:%d' % Server.port), words=(sys.executable, "-c")
        )
        self.assertEqual(status, 0, said)
        self.assertRegex(said, r"\AActive\nRTC\.TimedLong\(.*data=\d+\)\n\Z")

    def script(self, name):
        """One of the scripts: the file that it is in, and both shells to run it."""
        (found,) = [
            block
            for block in re.findall(r"```sh\n((?:.*\n)*?)```", read("docs", "scripts.md"))
            if "\n# " + name + " " in block + " " or "\n# " + name + "\n" in block
        ]
        path = os.path.join(self.robot.directory, name)
        with open(path, "w") as file:
            file.write(found)
        return path

    def in_shells(self, name, arguments, before, after):
        """Run a script in both shells, between a preparation and a check; returns its output."""
        path = self.script(name)
        outputs = []
        for shell in "dash", "busybox ash":
            if shutil.which(shell.split()[0]):
                with self.subTest(shell):
                    self.robot.prepare(before)
                    status, said = self.robot.run("%s -eu %s %s" % (shell, path, arguments))
                    self.assertEqual(status, 0, said)
                    self.assertEqual(self.robot.run(after)[0], 0, said)
                    outputs.append(said)
        return outputs

    def test_log_port(self):
        """It ends when the disk is full: here after two files, because of our `df`."""
        with open(os.path.join(TOP, "df"), "w") as file:
            file.write("#!/bin/sh\necho; if [ $(ls logs | wc -l) -lt 2 ]; then echo a b c 999999; else "
                       "echo a b c 10; fi\n")
        os.chmod(os.path.join(TOP, "df"), 0o755)
        self.addCleanup(os.remove, os.path.join(TOP, "df"))
        self.in_shells("log-port", "Source0.rtc:number logs 1.2", "rm -rf logs; mkdir logs; rtact "
                                                                  "Source0.rtc",
                       "test $(ls logs | wc -l) = 2 && rtlog -d -f logs/$(ls logs | head -n 1)")


if __name__ == "__main__":
    unittest.main()
