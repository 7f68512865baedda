"""Every command against real components of OpenRTM-aist: `tests/run --real DIR … [--rounds N]`.

After each step every process lives, and every port has the connectors that it had before; after what
connects, all parts are Active, too. Each loop prints what it counted.
"""
import collections
import concurrent.futures
import glob
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import real
import worlds
from loops import wait_for
from rtshell_lite.data import reading
from rtshell_lite.robot import component, ports

DIRECTORIES = [each for each in os.environ.get("RTSHELL_REAL", "").split(os.pathsep) if each]
ROUNDS = int(os.environ.get("RTSHELL_ROUNDS", "100"))
LIMIT = 180.0  # seconds for one command
SAYING = 5.0  # seconds from reading a value to printing it, on a busy machine
SIGNALS = (None, signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
ENDED = {None: (0,), signal.SIGINT: (130, -2), signal.SIGTERM: (143, -15), signal.SIGHUP: (129, -1)}
RATES = (100, 1000)  # Hz, of C++; Python keeps the first

# What connects, injects and measures: words that end by themselves, and words that are ended by a signal.
# OUT is an out port that something is written to, IN an in port that is read, PART a component that writes.
LOOPS = {
    "rtprint": ("rtprint -n 2 OUT", "rtprint OUT"),
    "rtprint --pull": ("rtprint --pull -n 2 OUT", "rtprint --pull OUT"),
    "rtlog": ("rtlog -q -i -e 2 -f LOG OUT", "rtlog -q -f LOG OUT"),
    "rtlog --pull": ("rtlog -q --pull -i -e 2 -f LOG OUT", "rtlog -q --pull -f LOG OUT"),
    "rtinject": ("rtinject -c 1 IN", "rtinject -c 1 -n -1 -r 50 IN"),
    "rtec --measure": ("rtec --measure 0.2 PART", "rtec --measure 20 PART"),
    "rtdoctor --measure": ("rtdoctor -q --measure 0.2 PART", "rtdoctor -q --measure 20 PART"),
}
# Each command once: what it is to answer with besides 0.
ONCE = [
    ("rtls -lR HOME", ()),
    ("rtls --json -l HOME", ()),
    ("rtcat -ll PART CONFIG", ()),
    ("rtcat --json PROVIDER OUT", ()),
    ("rtfind HOME --state active", ()),
    ("rtfind HOME -t c -0", ()),
    ("rtconf CONFIG list", ()),
    ("rtconf CONFIG get int_param0", ()),
    ("rtconf CONFIG set int_param0 7", ()),
    ("rtconf CONFIG act default", ()),
    ("rtdoc PART", ()),
    ("rtec PART", ()),
    ("rtec --json PART", ()),
    ("rtcryo -o FILE HOME", ()),
    ("rtcheck -s Active FILE", (1,)),
    ("rtstodot --live --text FILE", ()),
    ("rtresurrect FILE", ()),
    ("rtdoctor HOME", (1,)),
    ("rtdoctor --measure 0.3 HOME", (1,)),
    ("rttop -n 2 HOME", ()),
    ("rtwatch -t 1 PART", (6,)),
    ("rtvlog -t 1 PART", (6,)),
    ("rtcon PROVIDER:MyService CONSUMER:MyService", ()),
    ("rtdis PROVIDER:MyService", ()),
    ("rtdeact PART", ()),
    ("rtact --wait PART", ()),
    ("rtstop FILE", ()),
    ("rtstart FILE", ()),
    ("rtsh -c ls", ()),
    ("rtprint --stats -t 1 OUT", ()),
    ("rtinject --dry-run -c 1 IN", ()),
    ("rtdel -z", ()),
]

SERVICE = "called.idl"  # in `top`
LONGEST_ECHO = 12.0  # seconds: an echo of the examples takes 10

robots = []
top = None


def setUpModule():
    global top
    if not DIRECTORIES:
        raise unittest.SkipTest("needs --real DIR")
    worlds.start_name_server()
    top = tempfile.mkdtemp(prefix="rt-real-")
    try:
        for implementation in real.implementations(DIRECTORIES):
            for rate in RATES if implementation.name == "C++" else RATES[:1]:
                robots.append(
                    real.Robot(
                        implementation,
                        "%s%d" % (implementation.name[0].lower(), rate),
                        rate,
                        worlds.Server.port,
                    )
                )
        if not robots:
            raise AssertionError("no built examples in " + ", ".join(DIRECTORIES))
        for robot in robots:
            prepare(robot)
    except BaseException:
        tearDownModule()  # nobody else calls it then
        raise


def tearDownModule():
    for robot in robots:
        if robot.feeder:
            robot.feeder.kill()
            ended(robot.feeder)
        robot.close()
    worlds.Server.stop()
    shutil.rmtree(top, ignore_errors=True)


def prepare(robot):
    """Values go through it, from Sensor to Controller to Motor, 100 a second."""
    path = robot.path
    for one, other in (("Sensor", "Controller"), ("Controller", "Motor")):
        done(["rtcon", path(one) + ":out", path(other) + ":in"])
    active = [
        part
        for part in ("Sensor", "Controller", "Motor", "ConsoleOut", "SeqOut", "SeqIn", "ConfigSample")
        if part in robot.nodes
    ]
    done(["rtact", "--wait", "10"] + [path(part) for part in active])
    robot.feeder = start(["rtinject", "--anyway", "-n", "-1", "-r", "100", "-c", "1", path("Sensor") + ":in"])
    done(["rtprint", "-n", "1", "-t", "30", path("Sensor") + ":out"])
    robot.connected = robot.connectors()
    robot.active = active


def start(words, stdin=subprocess.DEVNULL):
    command = [sys.executable, os.path.join(worlds.COMMANDS, words[0])] + words[1:]
    return subprocess.Popen(
        command,
        cwd=top,
        stdin=stdin,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        preexec_fn=lambda: [signal.signal(number, signal.SIG_DFL) for number in SIGNALS if number],
        env=dict(
            os.environ,
            RTCTREE_NAMESERVERS="127.0.0.1:%d" % worlds.Server.port,
            LC_ALL="C.UTF-8",
            PYTHONDONTWRITEBYTECODE="1",
        ),
    )


def read_values(said):
    """The numbers that a ConsoleOut has read, by what it said.

    Python prints the whole structure that it has read. C++ prints a number that arrives twice, by its
    listeners, and twice more as it is read, from several threads at the same time: only the numbers
    themselves are never torn apart.
    """
    whole = re.findall(r"data=(-?\d+)\)", said)
    said = re.sub(r"([0-9a-f]{8}(?:-[0-9a-f]{4}){3}-[0-9a-f]{12}|-{10,}|\d+\[n?s\])", "\n", said)
    printed = collections.Counter(re.findall(r"-?\d+", said))
    return set(whole).union(number for number, count in printed.items() if count > 2)


def says(robot, value):
    """Whether ConsoleOut says within seconds that it has read a value: it says so after it has read it."""
    end = time.monotonic() + SAYING
    while value not in read_values(robot.said("ConsoleOut")):
        if time.monotonic() > end:
            return False
        time.sleep(0.01)
    return True


def asks(process):
    """Whether a command has a socket."""
    try:
        return any(
            os.readlink(link).startswith("socket:") for link in glob.glob("/proc/%d/fd/*" % process.pid)
        )
    except OSError:
        return False


def ended(process, given=None):
    """Its status and what it said."""
    killer = threading.Timer(LIMIT, process.kill)
    killer.start()
    out, err = process.communicate(given)
    killer.cancel()
    return process.returncode, (out[-1000:] + err[-1000:]).decode("utf-8", "replace")


def done(words, also=()):
    status, said = ended(start(words))
    if status != 0 and status not in also:
        raise AssertionError("%s: status %s\n%s" % (" ".join(words), status, said))


def words(line, robot, number=0):
    """The words of a line of the tables, for one robot."""
    places = {"HOME": robot.home, "PART": robot.path("Sensor"), "OUT": robot.path("Sensor") + ":out",
              "IN": robot.path("ConsoleOut") + ":in", "CONFIG": robot.path("ConfigSample"),
              "PROVIDER": robot.path("MyServiceProvider"), "CONSUMER": robot.path("MyServiceConsumer"),
              "LOG": "%s-%d.rtlog" % (robot.label, number), "FILE": robot.label + ".rtsys"}
    return re.sub(r"\b(%s)\b" % "|".join(places), lambda found: places[found.group()], line).split()


async def _states(node):
    owned, participating = await component.context_refs(node)
    return await component.states(node, owned + participating)


async def _read(port):
    async with reading.Reader(port, lambda message: None):
        pass


class Real(unittest.TestCase):
    def each_robot(self, function):
        """Call function(robot, …) for all robots at the same time; each returns a line of figures."""
        with concurrent.futures.ThreadPoolExecutor(len(robots)) as pool:
            futures = [(robot, pool.submit(function, robot)) for robot in robots if not robot.harm]
            for robot, future in futures:
                with self.subTest(robot.label):
                    print("figures: %s: %s" % (robot.label, future.result()))
        if not futures:
            self.skipTest("all robots have been harmed before")

    def unharmed(self, robot, after, also=list):
        wrong = robot.wrong() or also()
        if wrong:
            robot.harm = "after %s: %s" % (after, "; ".join(wrong))
            raise AssertionError(robot.harm)

    def test_1_every_command(self):
        def commands(robot):
            for line, also in ONCE:
                done(words(line, robot), also)
                if not line.startswith("rtcon"):  # a line that takes the connection away follows
                    self.unharmed(robot, line)
            return "%d commands" % len(ONCE)
        self.each_robot(commands)

    def test_2_one_value_is_read(self):
        """rtinject of one value, at each rate: all are read."""
        def inject(robot):
            read = collections.Counter()
            for hz in (1000, 100, 10, 2):  # the last cycle of a slower rate may be longer
                done(["rtec", robot.path("ConsoleOut"), "rate", str(hz)])
                for number in range(50 if ROUNDS >= 50 else ROUNDS):
                    value = "%d" % (hz * 1000 + 500000 + number)
                    done(["rtinject", "-q", "-c", value, robot.path("ConsoleOut") + ":in"])
                    read[hz] += says(robot, value)
                self.unharmed(robot, "rtinject at %d Hz" % hz)
            # early, because it takes effect late: see test_7
            done(["rtec", robot.path("ConsoleOut"), "rate", "%d" % robot.rate])
            if set(read.values()) != {50 if ROUNDS >= 50 else ROUNDS}:
                raise AssertionError("read: %s" % dict(read))
            return "values read at 2, 10, 100, 1000 Hz: %s" % sorted(read.items())
        self.each_robot(inject)

    def test_3_loops(self):
        """What connects, again and again, ended by itself or by a signal."""
        def loop(robot):
            counts = collections.Counter()
            for number in range(ROUNDS):
                for name, (short, endless) in LOOPS.items():
                    self.round(robot, name, short, endless, number)
                    counts[name] += 1
            return "rounds without harm: %s" % dict(counts)
        self.each_robot(loop)

    def round(self, robot, name, short, endless, number):
        ending = SIGNALS[number % len(SIGNALS)]
        process = start(words(endless if ending else short, robot, number % 7))
        if ending:
            while process.poll() is None and not asks(process):  # not while Python itself starts
                time.sleep(0.05)
            time.sleep(random.uniform(0, 0.5))
            process.send_signal(ending)
        status, said = ended(process)
        if status not in ENDED[ending] + ((1,) if name.startswith("rtdoctor") else ()):
            raise AssertionError("%s: status %s\n%s" % (name, status, said))
        self.unharmed(robot, "%s, round %d, signal %s" % (name, number, ending), robot.fallen)

    def test_4_states(self):
        def change(robot):
            for number in range(ROUNDS):
                part = robot.path("SeqIn")
                done(["rtdeact", "--wait", "5", part])
                done(["rtact", "--wait", "5", part])
                done(["rtcon", robot.path("SeqOut") + ":Long", part + ":Long"])
                done(["rtdis", robot.path("SeqOut") + ":Long", part + ":Long"])
                self.unharmed(robot, "states, round %d" % number)
            return "%d rounds of rtdeact, rtact, rtcon, rtdis" % ROUNDS
        self.each_robot(change)

    def test_5_contexts(self):
        """A component in the execution context of another one: Active in one of them, Inactive in all."""
        def share(robot):
            owner = robot.path("Sensor")
            part = robot.path("MyServiceProvider")
            for number in range(ROUNDS):
                done(["rtec", owner, "attach", part])
                if number % 2:  # as hrpsys does
                    done(["rtec", part, "stop"])
                    done(["rtact", "--wait", "5", part])
                else:
                    done(["rtact", "-e", "1", "--wait", "5", part])
                    done(["rtact", part])
                self.has_states(robot, "MyServiceProvider", ["Inactive", "Active"])
                done(["rtdeact", "--wait", "5", part])
                self.has_states(robot, "MyServiceProvider", ["Inactive", "Inactive"])
                if number % 2:
                    done(["rtec", part, "start"])
                done(["rtec", owner, "detach", part])
                self.has_states(robot, "MyServiceProvider", ["Inactive"])
                self.unharmed(robot, "contexts, round %d" % number, robot.fallen)
            return "%d rounds of rtec attach, rtact, rtdeact, rtec detach" % ROUNDS
        self.each_robot(share)

    def has_states(self, robot, part, wanted):
        """That a part has these states in its execution contexts, in the order of -e."""
        states = wait_for(_states(robot.nodes[part]))
        if states != wanted:
            raise AssertionError("%s %s: %s, not %s" % (robot.label, part, states, wanted))

    def test_5_operations(self):
        """Operations of a service port, interrupted at random: nothing is done twice, and no connector stays.
        """
        def call(robot):
            provider = robot.path("MyServiceProvider")
            done(["rtact", "--wait", "5", provider])
            statuses = collections.Counter()
            for number in range(ROUNDS):
                process = start(
                    ["rtcall", provider + ":MyService", "echo", "round %d" % number, "--idl", SERVICE]
                )
                while process.poll() is None and not asks(process):
                    time.sleep(0.01)
                time.sleep(random.uniform(0, 0.3))
                process.send_signal(signal.SIGINT)
                status, said = ended(process)
                if status not in ENDED[signal.SIGINT]:
                    raise AssertionError("rtcall: status %s\n%s" % (status, said))
                statuses["it may have been done" in said] += 1
                self.unharmed(robot, "rtcall, round %d" % number)
            time.sleep(LONGEST_ECHO)
            status, said = ended(
                start(["rtcall", "--json", provider + ":MyService", "get_echo_history", "--idl", SERVICE])
            )
            effects = collections.Counter(re.findall(r"round \d+", said))
            if status or not effects or max(effects.values()) > 1 or len(effects) > statuses[True]:
                raise AssertionError("%s %s: %d were called\n%s" % (status, effects, statuses[True], said))
            done(["rtdeact", "--wait", "5", provider])
            return "%d of %d calls were under way, %d were done, none twice" % (
                statuses[True],
                ROUNDS,
                len(effects),
            )
        with open(os.path.join(top, SERVICE), "w") as file:
            file.write("module SimpleService { typedef sequence<string> Echoes; interface MyService { "
                       "string echo(in string msg); Echoes get_echo_history(); }; };")
        self.each_robot(call)

    def test_6_bare_calls(self):
        """The same connections from one process, one after the other, while values go through."""
        def bare(robot):
            (port,) = [
                each for each in wait_for(ports.ports(robot.nodes["Sensor"])) if each.name.endswith("out")
            ]
            for number in range(ROUNDS):
                wait_for(_read(port))
                self.unharmed(robot, "%d bare push connections" % (number + 1))
            return "%d bare push connections without harm, near misses until now: %d" % (
                ROUNDS,
                robot.near_misses(),
            )
        self.each_robot(bare)

    def test_7_a_log_is_read(self):
        """5,000 entries played into a reader that claims the same rate: all that it takes are read, all
        others are counted; into a slower one: the truth.
        """
        def play(robot):
            reader = robot.path("ConsoleOut") + ":in"
            count = min(5000, 50 * ROUNDS)
            source = worlds.World(
                "senders", "%d" % robot.rate, "10", "--context", robot.label + "-log.host_cxt/%n.rtc"
            )
            try:
                done(["rtlog", "-q", "-i", "-e", str(count), "-f", robot.label + "-play.rtlog",
                      "/127.0.0.1:%d/%s-log.host_cxt/Source0.rtc:number" % (worlds.Server.port, robot.label)])
            finally:
                source.close()
            done(["rtec", robot.path("ConsoleOut"), "rate", "%d" % robot.rate])
            before = robot.reads()
            status, words = ended(start(["rtlog", "-q", "-p", "-f", robot.label + "-play.rtlog", reader]))
            read = robot.reads() - before
            refused = sum(map(int, re.findall(r"it refused (\d+) of", words)))
            self.unharmed(robot, "rtlog -p")
            if status != (5 if refused else 0) or read + refused != count:
                raise AssertionError(
                    "%d of %d entries were read, status %s\n%s" % (read, count, status, words)
                )
            done(["rtec", robot.path("ConsoleOut"), "rate", "10"])
            status, words = ended(
                start(["rtlog", "-p", "-f", robot.label + "-play.rtlog", "--linger", "1", reader])
            )
            if status != 5 or "they came faster than it reads them" not in words:
                raise AssertionError("rtlog -p into a slower reader: status %s\n%s" % (status, words))
            return "%d entries, %d refused, %d read; into a slower reader: %s" % (
                count, refused, read, re.search(r"it refused \d+ of \d+.*", words).group())
        self.each_robot(play)

    def test_8_what_was_sent_has_been_read(self):
        """rtinject -r 0 of bursts, at the full rate that the context claims: all have been read when it ends
        with status 0.
        """
        def burst(robot):
            read = collections.Counter()
            done(["rtec", robot.path("ConsoleOut"), "rate", "%d" % max(RATES)])
            for number in range(max(1, ROUNDS // 10)):
                before = robot.reads()
                values = "".join("%d\n" % (number * 1000 + i) for i in range(300))
                process = start(
                    ["rtinject", "-r", "0", robot.path("ConsoleOut") + ":in"], stdin=subprocess.PIPE
                )
                status, words = ended(process, values.encode())
                if status or robot.reads() - before != 300:
                    raise AssertionError(
                        "status %s, %d of 300 read\n%s" % (status, robot.reads() - before, words)
                    )
                read["bursts"] += 1
            self.unharmed(robot, "rtinject -r 0")
            done(["rtec", robot.path("ConsoleOut"), "rate", "%d" % robot.rate])
            return "%d bursts of 300 values, all read" % read["bursts"]
        self.each_robot(burst)

    def test_9_connections_of_one_port(self):
        """A port that another transport connects alone, as in ROS: made, kept, missed, restored and removed.
        """
        def connect(robot):
            if robot.implementation.name != "Python":
                return "no transport that connects one port"
            file = robot.label + "-alone.rtsys"
            ends = [robot.path("SeqOut") + ":Short", robot.path("SeqIn") + ":Short"]
            for number in range(ROUNDS):
                for end in ends:
                    done(["rtcon", "-n", "alone", "-p", "dataport.interface_type=ssm", end])
                done(["rtcryo", "-q", "-o", file, robot.home])
                self.lacks(file, 0, ends)
                for end in ends:
                    done(["rtdis", end])
                self.unharmed(robot, "connections of one port, round %d" % number, robot.fallen)
                self.lacks(file, 2, ends)
                done(["rtresurrect", "-q", file])
                self.lacks(file, 0, ends)
                done(["rtprint", "-q", "-n", "1", "-t", "5", ends[0]])
                for end in ends:
                    done(["rtdis", end])
                self.unharmed(robot, "connections of one port, round %d" % number, robot.fallen)
            return "%d rounds of rtcon, rtcryo, rtcheck, rtdis, rtresurrect with one port" % ROUNDS
        self.each_robot(connect)

    def lacks(self, file, count, ends):
        """Assert that rtcheck finds `count` of the connections of these ports missing."""
        status, said = ended(start(["rtcheck", "-s", "Active", file]))
        found = [end for end in ends if "No connection of %s by ssm" % end in said]
        if status not in (0, 1) or len(found) != count:
            raise AssertionError("rtcheck: status %s, %d connections missing, not %d\n%s" % (
                status, len(found), count, said))


if __name__ == "__main__":
    unittest.main()
