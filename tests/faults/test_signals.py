"""Ctrl-C, SIGTERM and SIGHUP at random moments of every command: it ends at once and leaves nothing behind.

If one of these fails, an operator who gives up on a command leaves observers, half connections or half a file
on the robot.
"""
import fcntl
import os
import pty
import queue
import random
import re
import signal
import struct
import subprocess
import sys
import tempfile
import termios
import threading
import time
import unittest

import invocations
import running
import tools
import worlds
from rtshell_lite import errors
from rtshell_lite.datalog import logfile
from rtshell_lite.xmlprofile import rtsprofile

ONCE = "signals are the same for every Python"
BOTH = "each ORB is interrupted in its own way"
ALONE = "it measures times"

try:
    import omniORB  # noqa: F401: the commands need it
except ImportError:
    raise unittest.SkipTest("needs omniORBpy")

LIMIT = 0.3             # seconds from the signal to the end
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
LANES = 4
TIMES = 30 if running.THOROUGH else 3   # how often each command is interrupted
PORTS = ("ConsoleIn0:out", "ConsoleOut0:in", "Motor0:in", "Motor0:out", "Mock0:in", "Mock0:out")
COMPONENTS = ("ConsoleIn0", "ConsoleOut0", "Microwave0", "Motor0", "Mock0")  # that may have observers
FATAL = set(invocations.stated("fatal"))
# what Python says of a Ctrl-C before any line of ours: it ends with status 1 or, after the last one, goes on
PYTHON_ITSELF = re.compile(
    rb"Failed to import the site module|Fatal Python error: init_|\AKeyboardInterrupt\s*\Z|"
    rb"Failed checking if argv\[0\] is an import path entry"
)
# of what comes after start.py, which makes Ctrl-C quiet; line 0 is before the first line of a module
OUR_TRACEBACK = re.compile(rb'Traceback[^$]*rtshell_lite/(?!start\.py)\w+\.py", line [1-9]')


class Lane:
    """A world for one command at a time."""

    def __init__(self, number):
        self.place = "lane%d.host_cxt" % number
        self.begin()
        home = server + "/%s/" % self.place
        self.meant = {
            "SERVER": server + "/" + self.place,
            "A": home + "ConsoleIn0.rtc",
            "B": home + "ConsoleOut0.rtc",
            "OUT": ("out"),
            "MGR": home + "manager.mgr",
            "LOG": log,
        }
        self.meant["FILE"] = around.profile(
            text, "lane%d.yaml" % number, server, self.meant["A"], self.meant["B"]
        )

    def begin(self):
        self.world = around.world(server, "observed", "--context", self.place + "/%n.rtc")

    def waits(self, command):
        """{who: seconds that it has waited for a processor so far}: a command, given by its process, this
        thread, which hears of its end, and the threads of the world that it asks.
        """
        world = running.processes.find(self.world).pid
        threads = os.listdir("/proc/%d/task" % world)
        known = [command, "thread-self"] + ["%d/task/%s" % (world, thread) for thread in threads]
        return {who: tools.waited_for_processor(who) for who in known}

    def waited(self, command, before):
        """Seconds that were waited for a processor since there were the waits `before`."""
        found = self.waits(command)
        own, ours, *asked = [max(0, found[who] - before.get(who, 0)) for who in found]
        return own + ours + max(asked)

    def connections(self):
        """{port: [connector id and name]}"""
        return {port: around.ctl(self.world, "connectors", port) for port in PORTS}

    def left_behind(self):
        """What must not be left: services of tools, and connections that do not have exactly two ends."""
        for component in COMPONENTS:
            if around.ctl(self.world, "observers", component):
                yield "observers of " + component
        found = self.connections()
        ends = [connection for connections in found.values() for connection in connections]
        if any(ends.count(connection) != 2 for connection in ends):
            yield "connections: %s" % found

    def tidy(self):
        """Remove all connections."""
        for port in PORTS:
            around.ctl(self.world, "forget", port)

    def renew(self):
        running.processes.end(self.world)
        self.begin()


def setUpModule():
    global around, server, text, log, lanes
    around = running.Surroundings()
    server = around.name_server()
    around.world(server, "linked")
    text, log = around.files(server)
    lanes = queue.Queue()
    for number in range(LANES):
        lanes.put(Lane(number))


def tearDownModule():
    around.close()


# seconds within which a busy mock has taken what a command has sent before it ended: it does not wait for
# each answer
TAKEN_BACK = 5.0


class Case:
    """A command that is interrupted at some moment between its start and `span` seconds later."""

    def __init__(self, number, command, line, span, which):
        dice = random.Random(number)
        self.command = command
        self.line = line
        self.which = which
        self.moment = dice.uniform(0.02, span)

    def __str__(self):
        return "%s %s: %s after %.3f s" % (self.command, self.line, self.which.name, self.moment)

    def run(self):
        lane = lanes.get()
        try:
            self.try_in(lane)
        finally:
            lanes.put(lane)
        return self

    def try_in(self, lane):
        words = [self.command] + invocations.words(self.line, lane.meant)
        with tempfile.TemporaryDirectory(dir=around.top) as where, tempfile.TemporaryFile() as output:
            process = running.start(
                words,
                where,
                {"RTCTREE_NAMESERVERS": server[1:]},
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=output,
            )
            time.sleep(self.moment)
            before = lane.waits(process.pid)
            begun = time.monotonic()
            os.kill(process.pid, self.which)  # also when it has ended: nobody has waited for it
            killer = threading.Timer(running.LIMIT, process.kill)  # where the signal was lost
            killer.start()
            os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOWAIT)
            self.seconds = time.monotonic() - begun
            killer.cancel()
            self.seconds = max(0, self.seconds - lane.waited(process.pid, before))
            status = process.wait()
            self.status = 128 - status if status < 0 else status
            output.seek(0)
            self.said = output.read()
            self.files = list(wrong_files(where, self.command))
            self.disk = seconds_to_sync(where)
        begun = time.monotonic()
        self.left = list(lane.left_behind()) if self.command not in FATAL else []
        # how long a mock takes to say something while all this goes on
        self.answer = (time.monotonic() - begun) / len(COMPONENTS + PORTS)
        end = time.monotonic() + TAKEN_BACK
        while self.left and time.monotonic() < end:
            time.sleep(0.05)
            self.left = list(lane.left_behind())
        lane.renew() if self.command in FATAL else lane.tidy()

    def was_too_early(self):
        """Whether Python itself took the signal, or lost it, before any line of ours."""
        return self.status in (1, 128 + signal.SIGKILL) and bool(PYTHON_ITSELF.search(self.said))

    def problems(self):
        yield from self.left + self.files
        if self.was_too_early():
            return
        if self.status == 128 + self.which:
            if self.seconds > LIMIT + 4 * (self.answer + self.disk):
                waited = self.seconds, self.answer, self.disk
                yield "gone after %.2f s (a mock answers within %.3f s, a disk within %.3f s)" % waited
        elif self.status not in range(7):
            yield "status %d" % self.status
        if b"internal error" in self.said or OUR_TRACEBACK.search(self.said):
            yield "a traceback"


def seconds_to_sync(where):
    """How long the disk of a directory takes just now to keep a file: those who write one wait for that."""
    begun = time.monotonic()
    with tempfile.TemporaryFile(dir=where) as file:
        file.write(bytes(1 << 16))
        file.flush()
        os.fsync(file.fileno())
    return time.monotonic() - begun


def wrong_files(where, command):
    """Temporary and half-written files in a directory."""
    for name in os.listdir(where):
        path = os.path.join(where, name)
        try:
            if name.endswith(".tmp"):
                yield "left: " + name
            elif command == "rtcryo":
                with open(path, "rb") as file:
                    rtsprofile.load(file.read().decode(), name)
            elif command == "rtlog":
                with logfile.load(path) as found:
                    if found.torn:
                        yield "torn: " + name
        except errors.Error as e:
            yield str(e)


def cases():
    found = []
    dice = random.Random(7)
    for command, lines in sorted(invocations.stated("invocation").items()):
        found += [(command, dice.choice(lines), 0.4) for _ in range(TIMES)]
    for command, lines in sorted(invocations.stated("lasting").items()):
        found += [(command, line, 1.0) for line in lines for _ in range(TIMES)]
    return [Case(number, *(each + (SIGNALS[number % 3],))) for number, each in enumerate(found)]


def striking():
    """Cases of rtinject, which would go on moving the component: a signal in each of the first 400 ms, in the
    short form in some.
    """
    line = "--anyway -n -1 -r 100 -c 1 B:in"
    step = 1 if running.THOROUGH else 16
    found = [
        Case(1000 + moment, "rtinject", line, 1.0, SIGNALS[moment // step % 3])
        for moment in range(0, 400, step)
    ]
    for case, moment in zip(found, range(0, 400, step)):
        case.moment = moment / 1000
    return found


class Screen:
    """A command on a terminal that outlives it."""

    def __init__(self, words):
        self.master, self.slave = pty.openpty()
        fcntl.ioctl(self.master, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
        self.before = termios.tcgetattr(self.slave)
        self.process = subprocess.Popen(
            [sys.executable, os.path.join(worlds.COMMANDS, words[0])] + words[1:],
            cwd=around.top,
            preexec_fn=self.take,
            env=running.environment(RTCTREE_NAMESERVERS=server[1:], HOME=around.top),
            stdin=self.slave,
            stdout=self.slave,
            stderr=self.slave,
        )
        self.said = b""
        self.listener = threading.Thread(target=self.listen, daemon=True)
        self.listener.start()

    def take(self):
        os.setsid()
        fcntl.ioctl(0, termios.TIOCSCTTY, 0)
        signal.signal(signal.SIGINT, signal.SIG_DFL)

    def listen(self):
        while True:
            try:
                self.said += os.read(self.master, 65536)
            except OSError:
                return


class Signals(unittest.TestCase):
    def test_the_terminal_is_as_it_was(self):
        """Also after commands that take it over, ended at any moment; Ctrl-C is typed."""
        dice = random.Random(11)
        for words in ["rttop"], ["rtsh"]:
            for which in ("\x03", signal.SIGTERM, signal.SIGHUP) * (10 if running.THOROUGH else 2):
                if (words[0], which) == ("rtsh", "\x03"):
                    which = "\x04"  # Ctrl-C ends a line only
                screen = Screen(words)
                moment = dice.uniform(0.05, 0.8)
                with self.subTest(words=words, which=which, moment=moment):
                    time.sleep(moment)
                    if isinstance(which, str):
                        worlds.eventually(lambda: screen.said, "a prompt, which takes what is typed")
                        os.write(screen.master, which.encode())
                    else:
                        screen.process.send_signal(which)
                    screen.process.wait(running.LIMIT)
                    self.assertEqual(termios.tcgetattr(screen.slave), screen.before, screen.said)
                    os.close(screen.slave)
                    screen.listener.join(running.LIMIT)  # all that was said has been heard
                    self.assertEqual(
                        screen.said.count(b"\x1b[?1049h"), screen.said.count(b"\x1b[?1049l"), screen.said
                    )
                    self.assertEqual(
                        screen.said.count(b"\x1b[?25l") > 0, b"\x1b[?25h" in screen.said, screen.said
                    )
                    self.assertNotRegex(screen.said, rb"rtshell_lite/\w+\.py")
                os.close(screen.master)

    def test_none_is_lost(self):
        """Not in any of the first 400 ms: neither while Python starts nor while modules are imported."""
        for case in running.together(Case.run, striking(), LANES):
            if case.was_too_early():
                continue
            with self.subTest(str(case)):
                self.assertEqual(case.status, 128 + case.which, case.said.decode("utf-8", "replace"))
                self.assertEqual(list(case.problems()), [], case.said.decode("utf-8", "replace"))

    def test_every_command_goes_at_once_and_leaves_nothing(self):
        done = running.together(Case.run, cases(), LANES)
        caught = [case.seconds for case in done if case.status == 128 + case.which]
        self.assertGreater(len(caught), len(done) / 8, "most commands had ended before the signal: this "
                                                       "proves little")
        print(
            "figures: %d commands got a signal, %d of them before they had ended; these were gone within "
            "%.2f s at most, %.3f s in the mean" % (len(done), len(caught), max(caught), sum(caught) / len(caught))  # noqa: E501
        )
        for case in done:
            with self.subTest(str(case)):
                self.assertEqual(
                    list(case.problems()),
                    [],
                    "status %d: %s" % (case.status, case.said.decode("utf-8", "replace")),
                )


if __name__ == "__main__":
    unittest.main()
