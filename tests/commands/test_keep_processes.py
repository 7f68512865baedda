"""A robot of 12 processes, its name server among them, from nothing to running, as the README has it.

If this fails, a robot does not start at boot.
"""
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

import running
import worlds
from mock_components import nameserver

ONCE = "what rtkeep does does not depend on the Python"


class Nothing(unittest.TestCase):

    def setUp(self):
        self.directory = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.directory, True)
        self.port = nameserver.free_port()
        self.home = "/127.0.0.1:%d/test.host_cxt/" % self.port
        os.mkfifo(os.path.join(self.directory, "fifo"))  # mocks end with their input
        os.mkdir(os.path.join(self.directory, "names"))
        server = nameserver.command(self.port, os.path.join(self.directory, "names"))
        lines = [
            "names: " + " ".join(map(shlex.quote, server)),
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
