"""The processes that rtkeep keeps: if this fails, some of a robot outlive it, fill the table of
processes, or cannot be ended.

tests/commands/rtkeep-processes.t has the common cases, tests/sim/stories/rtkeep-processes.t what takes time.
"""

import json
import os
import shutil
import signal
import socket
import subprocess
import tempfile
import unittest
from unittest import mock

import running
import worlds
from rtshell_lite import cli
from rtshell_lite.net import loop
from rtshell_lite.shell import installation

LONG = 30.0  # seconds; more than ending at once takes on a busy machine
STUBBORN = "sh -c 'trap \"\" TERM INT; echo ready; while :; do sleep 0.1; done'"
IN_NAMESPACE = ["unshare", "--pid", "--fork", "--mount-proc", "--kill-child"]


def has_namespaces():
    """Whether we may make a process the first of its own namespace."""
    if not shutil.which("unshare"):
        return False
    return subprocess.call(IN_NAMESPACE + ["true"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) == 0


def children(pid):
    """{pid: state} of the children of a process."""
    with open("/proc/%d/task/%d/children" % (pid, pid)) as file:
        found = file.read().split()
    states = {}
    for child in map(int, found):
        try:
            with open("/proc/%d/stat" % child) as file:
                states[child] = file.read().rpartition(")")[2].split()[0]
        except (FileNotFoundError, ProcessLookupError):  # it has ended meanwhile
            pass
    return states


def is_there(pid):
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True


def only(found):
    """A list of the one thing that there is, or None."""
    return list(found) if len(found) == 1 else None


class Processes(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.directory, True)

    def keep(self, procfile, inside=(), **more):
        with open(os.path.join(self.directory, "Procfile"), "w") as file:
            file.write(procfile)
        with open(os.path.join(self.directory, "said"), "ab") as said:
            self.process = running.start(
                ["rtkeep", "-v", "--json", "--processes", "Procfile"],
                self.directory,
                dict(more, XDG_RUNTIME_DIR=self.directory),
                inside,
                stdin=subprocess.DEVNULL,
                stdout=said,
                stderr=said,
            )
        self.addCleanup(self.process.wait)
        self.addCleanup(self.process.kill)

    def said(self):
        with open(os.path.join(self.directory, "said")) as file:
            return file.read()

    def until(self, text, count=1):
        worlds.eventually(lambda: self.said().count(text) >= count or self.process.poll() is not None, text)
        self.assertGreaterEqual(self.said().count(text), count, self.said())

    def events(self):
        return [json.loads(line) for line in self.said().splitlines() if line.startswith('{"done')]

    def pids(self, name):
        return [
            int(event["done"].rpartition(" ")[2])
            for event in self.events()
            if event["object"] == name and event["done"].startswith("started")
        ]

    def test_second_signal(self):
        """A second signal ends it at once, with all processes, however long these may take."""
        self.keep("a: %s\na.stop: TERM 1000\n" % STUBBORN)
        self.until('"wrote": "ready"')
        self.process.send_signal(signal.SIGINT)
        self.process.terminate()
        self.assertEqual(self.process.wait(LONG), 128 + signal.SIGTERM)
        worlds.eventually(lambda: not is_there(self.pids("a")[-1]), "the process ends, too")

    def test_a_killed_guardian_is_replaced(self):
        """Then another one does: rtkeep goes on, and nothing outlives it."""
        self.keep("a: sh -c 'sleep 1000 & wait'\nb: sleep 0.3\nb.delay: 0.1-0.1\nb.burst: 1000/60\n")
        self.until("started, pid", 2)
        (watching,) = worlds.eventually(  # a b that has just begun is not told yet
            lambda: only(set(children(self.process.pid)) - set(self.pids("a") + self.pids("b"))),
            "what watches over them is known"
        )
        (a,) = self.pids("a")
        os.kill(watching, signal.SIGKILL)
        worlds.eventually(lambda: len(self.pids("b")) > 3, "processes are started again")
        (sleeping,) = worlds.eventually(lambda: only(children(a)), "it has begun to sleep")
        self.process.kill()
        worlds.eventually(lambda: not is_there(a) and not is_there(sleeping), "the whole group ends")

    def test_signal_without_a_name(self):
        self.keep("a: sh -c 'kill -40 $$'\na.restart: no\n")
        self.until("ended by signal 40")
        self.assertIsNone(self.process.poll())

    def test_service_manager_that_stands_still(self):
        """A robot is kept though nobody reads what is sent to the service manager."""
        with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as manager:
            manager.bind(os.path.join(self.directory, "notify"))
            self.keep(
                "a: false\na.delay: 0.01-0.01\na.burst: 20/60\n",
                NOTIFY_SOCKET=os.path.join(self.directory, "notify"),
            )
            self.until("given up")
            self.process.terminate()
            self.assertEqual(self.process.wait(LONG), 0)

    def test_directory_that_was_cleaned(self):
        self.keep("a: sleep 1000\n")
        self.until("started, pid")
        shutil.rmtree(os.path.join(self.directory, "rtkeep"))
        self.process.terminate()
        self.assertEqual(self.process.wait(LONG), 0, self.said())

    def test_processes_get_nothing_of_the_service_manager(self):
        """A process that took the messages of the service manager for its own would speak for rtkeep."""
        self.keep("a: env\na.restart: no\n", NOTIFY_SOCKET="/nowhere", WATCHDOG_USEC="5000000", OTHER="here")
        self.until("not started again")
        self.assertIn("OTHER=here", self.said())
        self.assertNotIn("NOTIFY_SOCKET", self.said())
        self.assertNotIn("WATCHDOG", self.said())

    @unittest.skipUnless(has_namespaces(), "no namespaces of processes here: unshare does not work")
    def test_first_process_of_a_container(self):
        """As process 1 it reaps what others have left, hears signals, and takes all with it."""
        orphans = (
            "sh -c 'for n in 1 2 3 4 5; do sh -c \"setsid sleep 0.2 &\"; done; echo left; exec sleep 1000'"
        )
        self.keep("a: %s\n" % orphans, inside=IN_NAMESPACE)
        self.until('"wrote": "left"')
        (first,) = children(self.process.pid)
        with open("/proc/%d/status" % first) as file:
            self.assertRegex(file.read(), r"NSpid:\t\d+\t1\n")
        worlds.eventually(
            lambda: len(children(first)) == 2, "orphans end: only the process and what watches over it stay"
        )
        self.assertNotIn("Z", children(first).values())
        os.kill(first, signal.SIGTERM)
        self.assertEqual(self.process.wait(LONG), 0)
        self.assertIn("as it was told", self.said())

    @unittest.skipUnless(has_namespaces(), "no namespaces of processes here: unshare does not work")
    def test_first_process_without_processes_of_its_own(self):
        """It reaps then, too: `docker exec` leaves orphans with it."""
        with open(os.path.join(self.directory, "a.rtsys"), "w") as file:
            file.write(
                '<rts:RtsProfile rts:version="0.2" rts:id="RTSystem:a:b:1" '
                'xmlns:rts="http://www.openrtp.org/namespaces/rts"/>'
            )
        script = 'sh -c "setsid sleep 0.2 &"; exec "$@"'  # its orphan becomes that of rtkeep
        with open(os.path.join(self.directory, "said"), "ab") as said:
            self.process = running.start(
                ["rtkeep", "a.rtsys"],
                self.directory,
                dict(XDG_RUNTIME_DIR=self.directory),
                IN_NAMESPACE + ["sh", "-c", script, "sh"],
                stdin=subprocess.DEVNULL,
                stdout=said,
                stderr=said,
            )
        self.addCleanup(self.process.wait)
        self.addCleanup(self.process.kill)

        def is_kept():
            return any(name.endswith(".socket") for _, _, names in os.walk(self.directory) for name in names)

        worlds.eventually(is_kept, "it runs")
        (first,) = children(self.process.pid)
        worlds.eventually(lambda: not children(first), "no zombie stays")
        os.kill(first, signal.SIGTERM)
        self.assertEqual(self.process.wait(LONG), 0, self.said())


class Printing(unittest.TestCase):
    """What rtkeep prints before it ends, on a terminal that takes its time."""

    def printed(self, pause):
        """What is printed of a line that comes `pause` seconds (or None: at once) before rtkeep ends."""
        printed = []

        async def write(text):
            await loop.sleep(0.1)
            printed.append(text)

        async def leave():
            printer = installation.load(installation.commands()["rtkeep"], "keep")._Printer()
            async with loop.background(printer.run()):
                printer.add("ended")
                if pause is not None:
                    await loop.sleep(pause)
                await printer.until_printed()

        with mock.patch.object(cli, "write", write):
            loop.run(leave())
        return printed

    def test_a_line_that_has_just_come(self):
        self.assertEqual(self.printed(None), ["ended\n"])

    def test_a_line_that_is_being_printed(self):
        self.assertEqual(self.printed(0.01), ["ended\n"])


if __name__ == "__main__":
    unittest.main()
