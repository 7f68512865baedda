"""rtkeep in a storm: 30 components in 10 processes that are killed, stopped, disconnected, changed and in
Error, by seed.

If this fails, a robot that is kept is not as its file says, or a person's work is undone. 3 rounds, or 10
minutes with `tests/run --long test_keep`; RTSHELL_SEED chooses another storm. Prints how long repairs took.
"""
import collections
import json
import os
import random
import shlex
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import time
import unittest

import running
import worlds
from loops import wait_for
from mock_components import nameserver
from rtshell_lite import errors, path
from rtshell_lite.robot import connectors, ports
from rtshell_lite.system import compare, relocate

ONCE = "what rtkeep does does not depend on the Python"
LONG = "a storm takes its time"

PROCESSES = 10
POLLED = 3  # of them are of components that take no observers
ACTIONS = 8  # in a round
SECONDS = 600 if running.THOROUGH else 45
CALM = 60.0  # seconds after which all must be as the file says, on a busy machine
SEED = os.environ.get("RTSHELL_SEED", "1")

Action = collections.namedtuple("Action", "kind object begun")


def setUpModule():
    worlds.start_name_server()


def tearDownModule():
    worlds.Server.stop()


def name(kind, number):
    return "/127.0.0.1:%d/test.host_cxt/%s%d.rtc" % (worlds.Server.port, kind, number)


def ask(coroutine, seconds=3.0):
    return wait_for(coroutine, seconds)


class Robot:
    """The mocks, by process, and the file that says how they are to be."""

    def __init__(self, directory):
        self.worlds = [self.start(number) for number in range(PROCESSES)]
        self.stopped = set()
        self.file = os.path.join(directory, "robot.rtsys")
        for number in range(PROCESSES):
            self.connect(number, number, "straight%d" % number)
            self.connect(number, (number + 1) % PROCESSES, "across%d" % number)
        server = "127.0.0.1:%d" % worlds.Server.port
        done = running.run(["rtcryo", "--all", "-o", self.file, server], directory)
        assert done.status == 0, done
        self.profile = relocate.read(self.file)

    @staticmethod
    def start(number):
        words = [
            "these",
            "ConsoleIn:In%d" % number,
            "ConsoleOut:Out%d" % number,
            "ConfigSample:Set%d" % number,
        ]
        return worlds.World(*words, "--flavour", "py2" if number < PROCESSES - POLLED else "cpp2")

    @staticmethod
    def ends(one, other):
        return [path.parse(name("In", one) + ":out"), path.parse(name("Out", other) + ":in")]

    def connect(self, one, other, connector_id):
        async def connect():
            return await connectors.connect(
                await ports.find(self.ends(one, other)), connector_id=connector_id
            )
        ask(connect())

    def disconnect(self, connector_id):
        number = int(connector_id.lstrip("straightcos"))

        async def disconnect():
            port, = await ports.find(self.ends(number, number)[:1])
            for connector in port.connectors:
                if connector.id == connector_id:
                    await connectors.disconnect(port, connector)
        ask(disconnect())

    def kill(self, number):
        self.worlds[number].close()

    def stop(self, number):
        self.worlds[number].process.send_signal(signal.SIGSTOP)
        self.stopped.add(number)

    def go_on(self):
        for number in self.stopped:
            self.worlds[number].process.send_signal(signal.SIGCONT)
        self.stopped.clear()

    def close(self):
        for world in self.worlds:
            world.close()

    def differences(self):
        """[(path, check)] of what is not as the file says, and the failures."""
        found = ask(compare.compare(self.profile, "Active"), 5.0)
        return {
            (each.path, each.check) for each in found.differences if each.check != compare.OTHER_ID
        }, found.failures


class Keeping:
    """A running rtkeep, and what it has reported."""

    def __init__(self, file, *words):
        self.directory = os.path.dirname(file)
        self.log = os.path.join(self.directory, "events.json")
        self.words = [
            "rtkeep",
            "--look",
            "0.3",
            "--burst",
            "1000/60",
            "--delay",
            "0.2-0.5",
            "--leave",
            "--events",
            self.log,
        ]
        self.file = file
        self.start()

    def start(self):
        with open(os.path.join(self.directory, "said"), "ab") as said:
            self.process = running.start(
                self.words + [self.file],
                self.directory,
                {"XDG_RUNTIME_DIR": self.directory},
                stdin=subprocess.DEVNULL,
                stdout=said,
                stderr=said,
            )

    def kill(self):
        self.process.kill()
        self.process.wait()

    def end(self):
        self.process.terminate()
        return self.process.wait(30)

    def events(self):
        if not os.path.exists(self.log):
            return []
        with open(self.log) as file:
            lines = file.read().split("\n")
        return [json.loads(line) for line in lines[:-1]]

    def said(self):
        with open(os.path.join(self.directory, "said")) as file:
            return file.read()[-6000:]


class Storm(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.directory, True)
        self.robot = Robot(self.directory)
        self.addCleanup(self.robot.close)
        self.random = random.Random(SEED)
        self.actions = []
        self.stops = []  # [begin, end] of times when a process stood still
        self.hands = set()  # (path, check) of what a person has done

    def keep(self):
        self.keeping = Keeping(self.robot.file)
        self.addCleanup(self.keeping.kill)

    def calm(self):
        """Wait until all is as the file says, but for what a person has done."""
        end = time.monotonic() + CALM
        while True:
            try:
                found, failures = self.robot.differences()
            except errors.Error as e:
                found = {("", str(e))}
                failures = []
            if found == self.hands and not failures:
                return
            if time.monotonic() > end:
                self.fail("not as the file says: %s\na person did: %s\n%s\n%s" % (
                    sorted(found - self.hands), sorted(self.hands - found), failures, self.keeping.said()))
            time.sleep(0.2)

    def note(self, kind, where):
        """Note what is to be mended."""
        if int(where[-5]) >= PROCESSES - POLLED:
            kind += ", polled"
        self.actions.append(Action(kind, where, time.time()))

    # ---- what a person does, while all is calm ----

    def person(self):
        number = self.random.randrange(PROCESSES)
        before = len(self.reported_by_hand())
        if self.random.random() < 0.5:
            where = name("Out", number)
            check = "state"
            if (where, check) in self.hands:
                return
            self.ctl_state(where, "rtdeact")
        else:
            where = name("Set", number)
            check = "configuration"
            if (where, check) in self.hands:
                return
            done = running.run(
                ["rtconf", where, "-s", "mode1", "set", "int_param0=%d" % self.random.randrange(1, 99)],
                self.directory,
            )
            self.assertEqual(done.status, 0, done)
        self.hands.add((where, check))
        worlds.eventually(
            lambda: len(self.reported_by_hand()) > before,
            "%s by hand is reported; %s" % (where, self.keeping.said()),
        )

    def ctl_state(self, where, command):
        done = running.run([command, "--wait", "5", where], self.directory)
        self.assertEqual(done.status, 0, done)

    def reported_by_hand(self):
        return [event for event in self.keeping.events() if "by hand" in event["seen"]]

    # ---- what the storm does ----

    def living(self):
        return [number for number in range(PROCESSES) if number not in self.robot.stopped]

    def kill(self):
        number = self.random.choice(self.living())
        self.robot.kill(number)
        time.sleep(self.random.random())
        self.robot.worlds[number] = self.robot.start(number)
        self.hands -= {
            (name(kind, number), check) for kind in ("Out", "Set") for check in ("state", "configuration")
        }
        for kind in ("In", "Out", "Set"):
            self.note("restart", name(kind, number))

    def hang(self):
        if len(self.robot.stopped) < 2:
            self.stops.append([time.time(), float("inf")])
            self.robot.stop(self.random.choice(self.living()))

    def go_on(self):
        self.robot.go_on()
        for stop in self.stops:
            stop[1] = min(stop[1], time.time())

    def disconnect(self):
        number = self.random.randrange(PROCESSES)
        if {number, (number + 1) % PROCESSES} & self.robot.stopped:
            return
        self.robot.disconnect(self.random.choice(["straight", "across"]) + str(number))
        self.note("disconnect", name("In", number))

    def error(self):
        number = self.random.choice(self.living())
        kind = self.random.choice(["In", "Out", "Set"])
        where = name(kind, number)
        if (where, "state") in self.hands:
            return
        self.robot.worlds[number].ctl("error", "%s%d" % (kind, number))
        self.note("error", where)

    def wait(self):
        time.sleep(self.random.random())

    def test_storm(self):
        self.keep()
        self.calm()
        end = time.monotonic() + SECONDS
        rounds = 0
        while time.monotonic() < end:
            self.person()
            for _ in range(ACTIONS):
                self.random.choice(
                    [
                        self.kill,
                        self.hang,
                        self.go_on,
                        self.disconnect,
                        self.disconnect,
                        self.error,
                        self.error,
                        self.wait,
                    ]
                )()
            self.go_on()
            self.calm()
            rounds += 1
        self.assertIsNone(self.keeping.process.poll(), self.keeping.said())
        self.report(rounds)
        self.assertEqual(self.keeping.end(), 0)

    def report(self, rounds):
        """Print how long repairs took since they were possible; nothing was mended that was not broken. `held
        up`: some process stood still meanwhile.
        """
        events = self.keeping.events()
        taken = collections.defaultdict(list)
        for action in self.actions:
            wanted = "restored connection" if action.kind.startswith("disconnect") else "Active"
            times = [
                event["time"] - action.begun
                for event in events
                if event["object"] == action.object
                and event["done"].startswith(wanted)
                and event["time"] > action.begun
            ]
            if times:
                end = action.begun + min(times)
                is_held_up = any(begin < end and action.begun < until for begin, until in self.stops)
                taken[action.kind + is_held_up * ", held up"].append(min(times))
        everything = sorted(time for kind, times in taken.items() for time in times if "," not in kind)
        if everything:
            print(
                "figures: %d rounds, %d repairs: median %.2f s, 95 %% %.2f s, most %.2f s; %s"
                % (
                    rounds,
                    len(everything),
                    statistics.median(everything),
                    everything[int(len(everything) * 0.95)],
                    everything[-1],
                    ", ".join(
                        "%s %d: median %.2f, most %.2f"
                        % (kind, len(times), statistics.median(times), max(times))
                        for kind, times in sorted(taken.items())
                    ),
                )
            )
        resets = collections.Counter(event["object"] for event in events if event["done"] == "reset")
        errors_made = collections.Counter(
            action.object for action in self.actions if action.kind.startswith("error")
        )
        self.assertEqual(resets - errors_made, collections.Counter(), "reset without an Error")


class Nothing(unittest.TestCase):
    """A robot of 12 processes, its name server among them, from nothing to running, as the README has it."""

    def setUp(self):
        self.directory = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.directory, True)
        self.port = nameserver.free_port()
        self.home = "/127.0.0.1:%d/test.host_cxt/" % self.port
        os.mkfifo(os.path.join(self.directory, "fifo"))  # mocks end with their input
        os.mkdir(os.path.join(self.directory, "names"))
        lines = [
            "names: "
            + " ".join(
                map(shlex.quote, nameserver.command(self.port, os.path.join(self.directory, "names")))
            ),
            "names.ready: 127.0.0.1:%d" % self.port,
        ]
        for number in range(11):
            mock = "%s -m mock_components these %s:Part%d --nameserver 127.0.0.1:%d --control control%d" % (
                sys.executable, "ConsoleOut" if number % 2 else "ConsoleIn", number, self.port, number)
            lines += [
                "part%d: sh -c 'exec 0<>fifo; exec %s'" % (number, mock),
                "part%d.after: names" % number,
                "part%d.ready: %s" % (number, self.part(number)),
                "part%d.env: PYTHONPATH=%s" % (number, running.MODULES),
            ]
        with open(os.path.join(self.directory, "robot.procs"), "w") as file:
            file.write("\n".join(lines) + "\n")

    def part(self, number):
        return "%sPart%d.rtc" % (self.home, number)

    def keep(self, *words):
        self.process = running.start(
            ["rtkeep", "--processes", "robot.procs", *words],
            self.directory,
            {"XDG_RUNTIME_DIR": self.directory},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
        )
        self.addCleanup(self.process.wait)
        self.addCleanup(self.process.kill)

    def status(self):
        return running.run(["rtkeep", "status", "--json"], self.directory, XDG_RUNTIME_DIR=self.directory).out

    def well(self, *words):
        done = running.run(list(words), self.directory)
        self.assertEqual(done.status, 0, done)

    def end(self):
        self.process.terminate()
        self.assertEqual(self.process.wait(worlds.LIMIT), 0)
        self.assertFalse(nameserver.answers(self.port), "nothing is left")

    def test_robot(self):
        self.keep()
        worlds.eventually(lambda: self.status().count(b'"state": "ready"') == 12, "all processes are ready")
        for number in range(0, 10, 2):
            self.well(
                "rtcon", "-i", "id%d" % number, self.part(number) + ":out", self.part(number + 1) + ":in"
            )
        self.well("rtcryo", "--all", "-o", "robot.rtsys", "127.0.0.1:%d" % self.port)
        self.end()
        begun = time.monotonic()
        self.keep("robot.rtsys")
        worlds.eventually(lambda: b'"settled": true' in self.status(), "all is as the file says")
        print("figures: 12 processes from nothing to running: %.1f s" % (time.monotonic() - begun))
        self.well("rtcheck", "-s", "Active", "robot.rtsys")
        self.end()


if __name__ == "__main__":
    unittest.main()
