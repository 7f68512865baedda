"""Commands that only ask work where there is no SIGHUP, fcntl, geteuid or termios: if these fail, rtls does
not run on Windows. The others say in one line what they need.
"""
import os
import subprocess
import sys
import tempfile
import unittest

import invocations
import processes
import worlds

BIN = os.path.join(processes.ROOT, "bin")

# What such a Python lacks; then the command that is named, in the same process
HIDING = """
import _signal, os, runpy, signal, sys
for module in _signal, signal:
    for name in "SIGHUP", "SIGUSR1", "SIGUSR2", "SIGWINCH", "SIGTSTP", "SIGCONT":
        if hasattr(module, name):
            delattr(module, name)
for name in "geteuid", "getuid", "getegid", "getgid", "fork", "getpgrp", "tcgetpgrp":
    delattr(os, name)
for name in "fcntl", "termios", "tty", "pty", "pwd", "grp", "resource":
    sys.modules[name] = None
sys.argv[:] = sys.argv[1:]
runpy.run_path(sys.argv[0], run_name="__main__")
"""


class Elsewhere(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        worlds.start_name_server()
        cls.world = worlds.World("two")
        cls.server = "localhost:%d" % worlds.Server.port
        cls.home = "/%s/test.host_cxt/" % cls.server

    @classmethod
    def tearDownClass(cls):
        cls.world.close()
        worlds.Server.stop()

    def run_command(self, name, *words):
        environment = dict(
            worlds.ENVIRONMENT, RTCTREE_NAMESERVERS=self.server, RTSHELL_DEBUG="1", PYTHONPATH=processes.ROOT
        )
        with tempfile.TemporaryDirectory() as directory:
            done = subprocess.run(
                [sys.executable, "-c", HIDING, os.path.join(BIN, name)] + list(words),
                env=environment,
                cwd=directory,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                timeout=worlds.LIMIT,
            )
        return done.returncode, done.stdout.decode(), done.stderr.decode()

    def check(self, expected, name, *words, status=0):
        answer = self.run_command(name, *words)
        self.assertEqual(answer[0], status, answer)
        self.assertIn(expected, answer[1] + answer[2])
        self.assertNotIn("Traceback", answer[2])

    def test_commands_that_look(self):
        self.check("ConsoleIn0.rtc", "rtls", "-l", self.home)
        self.check("DataOutPort: out", "rtcat", "-ll", self.home + "ConsoleIn0.rtc")
        self.check("ConsoleOut0.rtc", "rtfind", "/", "-t", "c")
        self.check("ConsoleIn0", "rtcryo", "--all", self.server)
        self.check("ok    /" + self.server, "rtdoctor", "/" + self.server)
        self.check("1000", "rtec", self.home + "ConsoleIn0.rtc")
        self.check("usage: rtls", "rtls", "--help")

    def test_files_are_compared(self):
        with tempfile.TemporaryDirectory() as directory:
            name = os.path.join(directory, "robot.rtsys")
            self.check("", "rtcryo", "--all", "-o", name, self.server)
            self.check("", "rtcheck", "-s", "Inactive", name)

    def test_values_come(self):
        port = self.home + "ConsoleIn0.rtc:out"
        self.check("0 of 1 values came", "rtprint", "-n", "1", "-t", "0.2", port, status=1)
        with tempfile.TemporaryDirectory() as directory:
            name = os.path.join(directory, "log.mcap")
            self.check("Recording", "rtlog", "-f", name, "-t", "0.3", port)
            self.check("", "rtlog", "-f", name, "-d")

    def test_commands_that_change_work_or_name_their_need(self):
        self.check("", "rtact", "--wait", "10", self.home + "ConsoleIn0.rtc")
        self.check("", "rtdeact", "--wait", "10", self.home + "ConsoleIn0.rtc")
        for name in invocations.all_commands():
            if name.startswith("rt"):
                self.check("usage: " + name, name, "--help")
        status, _, said = self.run_command("rtmount", "tree")
        self.assertEqual((status, said.count("\n")), (1, 1), said)
        self.assertIn("rtmount needs Linux", said)


if __name__ == "__main__":
    unittest.main()
