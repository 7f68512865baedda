"""rtkeep on real components of OpenRTM-aist, in rounds: `tests/run --real DIR … [--rounds N] test_real_keep`.

Each round kills a process and starts it again, stops one for a while, cuts a connection, or does what a
person may do. After it all is as the file says but for what the person did, and nothing was done to what had
only stopped.
"""
import json
import os
import random
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

import real
import running
import worlds
from loops import wait_for
from rtshell_lite import path as paths
from rtshell_lite.robot import connectors, ports
from rtshell_lite.system import compare, relocate

DIRECTORIES = [each for each in os.environ.get("RTSHELL_REAL", "").split(os.pathsep) if each]
ROUNDS = int(os.environ.get("RTSHELL_ROUNDS", "100"))
SEED = os.environ.get("RTSHELL_SEED", "1")
LIMIT = 90.0  # seconds until all is as the file says
STOPPED = 2.0  # seconds; after 10 their neighbours would drop connections
PARTS = ("Sensor", "Controller", "Motor", "ConfigSample", "SeqOut", "SeqIn")


def setUpModule():
    if not DIRECTORIES:
        raise unittest.SkipTest("needs --real DIR")
    worlds.start_name_server()


def tearDownModule():
    worlds.Server.stop()


class Keeping(unittest.TestCase):
    def test_rounds(self):
        for implementation in real.implementations(DIRECTORIES):
            with self.subTest(implementation.name):
                self.keep(implementation)

    def keep(self, implementation):
        self.directory = tempfile.mkdtemp()
        self.robot = real.Robot(
            implementation, implementation.name[0].lower(), 100, worlds.Server.port, PARTS
        )
        self.random = random.Random(SEED)
        self.hands = set()
        self.taken = []
        try:
            self.rounds()
        finally:
            self.keeping.kill()
            self.keeping.wait()
            self.robot.close()
            shutil.rmtree(self.directory)

    def rounds(self):
        path = self.robot.path
        self.run_well("rtcon", "-i", "first", path("Sensor") + ":out", path("Controller") + ":in")
        self.run_well("rtcon", "-i", "second", path("Controller") + ":out", path("Motor") + ":in")
        self.run_well("rtcon", "-i", "long", path("SeqOut") + ":Long", path("SeqIn") + ":Long")
        self.run_well("rtcryo", "--all", "-o", "robot.rtsys", self.robot.home)
        self.profile = relocate.read(os.path.join(self.directory, "robot.rtsys"))
        with open(os.path.join(self.directory, "said"), "wb") as said:
            self.keeping = running.start(
                [
                    "rtkeep",
                    "--burst",
                    "1000/60",
                    "--delay",
                    "0.2-0.5",
                    "--leave",
                    "--events",
                    "events",
                    "robot.rtsys",
                ],
                self.directory,
                {"XDG_RUNTIME_DIR": self.directory},
                stdin=subprocess.DEVNULL,
                stdout=said,
                stderr=said,
            )
        self.calm("at the start")
        for number in range(ROUNDS):
            step = self.random.choice(
                [self.kill, self.kill, self.stop, self.cut, self.deactivate, self.configure]
            )
            begun = time.time()
            what = step()
            self.calm("round %d: %s" % (number, what))
            self.taken.append((step.__name__, time.time() - begun))
        print(
            "%s: %d rounds: %s"
            % (
                self.robot.implementation.name,
                ROUNDS,
                ", ".join(
                    "%s %d, most %.1f s" % (name, len(times), max(times))
                    for name, times in sorted(self.by_name().items())
                ),
            )
        )

    def by_name(self):
        found = {}
        for name, seconds in self.taken:
            found.setdefault(name, []).append(seconds)
        return found

    def run_well(self, *words):
        done = running.run(list(words), self.directory)
        self.assertEqual(done.status, 0, done)

    def events(self):
        with open(os.path.join(self.directory, "events")) as file:
            return [json.loads(line) for line in file.read().split("\n")[:-1]]

    def differences(self):
        found = wait_for(compare.compare(self.profile, "Active"), 5.0)
        self.assertEqual(found.failures, [])
        return {(each.path, each.check) for each in found.differences if each.check != compare.OTHER_ID}

    def calm(self, what):
        """Wait until all is as the file says, but for what a person has done."""
        end = time.monotonic() + LIMIT
        while True:
            self.assertIsNone(self.keeping.poll(), what)
            try:
                found = self.differences()
            except Exception as e:
                found = {("", str(e))}
            if found == self.hands and self.is_settled():
                return
            if time.monotonic() > end:
                with open(os.path.join(self.directory, "said")) as said:
                    self.fail(
                        "%s: %s, but a person did %s\n%s" % (what, found, self.hands, said.read()[-3000:])
                    )
            time.sleep(0.2)

    def is_settled(self):
        """Whether rtkeep knows it, too."""
        done = running.run(["rtkeep", "status", "--json"], self.directory, XDG_RUNTIME_DIR=self.directory)
        return b'"settled": true' in done.out

    # ---- what happens ----

    def part(self):
        return self.random.choice([part for part in PARTS if part in self.robot.processes])

    def kill(self):
        part = self.part()
        process = self.robot.processes[part]
        process.kill()
        process.wait()
        process.stdin.close()
        shutil.rmtree(os.path.join(self.robot.directory.name, part))
        self.robot.processes[part] = self.robot._start(part, worlds.Server.port)
        self.hands -= {(self.robot.path(part), check) for check in ("state", "configuration")}
        return "killed " + part

    def stop(self):
        """A process is stopped for a while: nothing is done to it, nor to its neighbours."""
        part = self.part()
        before = len(self.events())
        process = self.robot.processes[part]
        process.send_signal(signal.SIGSTOP)
        time.sleep(STOPPED)
        process.send_signal(signal.SIGCONT)
        done = [event for event in self.events()[before:] if event["done"] not in ("", "left alone")]
        self.assertEqual(done, [])
        return "stopped " + part

    def cut(self):
        number = self.random.randrange(3)
        connector_id, part, port = [
            ("first", "Sensor", "out"),
            ("second", "Controller", "out"),
            ("long", "SeqOut", "Long"),
        ][number]

        async def disconnect():
            found, = await ports.find([paths.parse(self.robot.path(part) + ":" + port)])
            for connector in found.connectors:
                if connector.id == connector_id:
                    await connectors.disconnect(found, connector)

        wait_for(disconnect(), 5.0)
        return "cut " + connector_id

    def deactivate(self):
        where = self.robot.path(self.part())
        if (where, "state") in self.hands:
            self.run_well("rtact", "--wait", "5", where)
            self.hands.remove((where, "state"))
            return "activated " + where
        self.run_well("rtdeact", "--wait", "5", where)
        self.hands.add((where, "state"))
        return "deactivated " + where

    def configure(self):
        where = self.robot.path("ConfigSample")
        self.run_well("rtconf", where, "set", "int_param0=%d" % self.random.randrange(1000, 2000))
        self.hands.add((where, "configuration"))
        return "configured"


if __name__ == "__main__":
    unittest.main()
