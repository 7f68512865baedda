"""Commands that run for long do not grow in memory, threads or open files.

30 seconds, or 10 minutes with `tests/run --long`. If this fails, a monitor that runs for a week ends the
robot it watches.
"""
import fcntl
import io
import os
import pty
import struct
import subprocess
import termios
import threading
import time
import unittest

import running

ONCE = "what grows does so under every Python"
BOTH = "each ORB keeps things of its own"

try:
    import omniORB  # noqa: F401: the commands need it
except ImportError:
    raise unittest.SkipTest("needs omniORBpy")

SECONDS = 600 if running.THOROUGH else 30
GROWTH = 1024           # kB that the memory may grow in the second half
# connections that omniORB may open late, when calls overlap; a leak at each refresh opens more
OVERLAP = 4
LINES = (
    "ls -l HOME; cat -l A; conf -l C; act A; deact A; con D:out E:in; dis D:out E:in; print -n 1 "
    "A:number; cat HOME/none.rtc\n"
)


class Watched:
    """A process, and how large it was at which time; with `terminal`, it has one of its own."""

    def __init__(self, name, words, feed=None, terminal=False):
        self.name = name
        self.feed = feed
        stdin = subprocess.DEVNULL
        if terminal:
            self.output, inside = terminal_pair()
            stdin = inside
        else:
            self.output = inside = open(os.path.join(around.top, name + ".out"), "w+b")
        if feed:
            stdin = subprocess.PIPE
        self.process = running.start(
            words,
            around.directory(name),
            {"RTCTREE_NAMESERVERS": server[1:]},
            stdout=inside,
            stdin=stdin,
            stderr=subprocess.STDOUT,
        )
        self.seen = []
        if terminal:
            inside.close()
            threading.Thread(target=drain, args=(self.output,), daemon=True).start()

    def measure(self):
        """Record its size; give it more input, and discard its output."""
        proc = "/proc/%d/" % self.process.pid
        with open(proc + "statm") as file:
            memory = int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") // 1024
        self.seen.append((memory, len(os.listdir(proc + "task")), len(os.listdir(proc + "fd"))))
        if self.feed:
            self.process.stdin.write(self.feed)
            self.process.stdin.flush()

    def halves(self):
        """(most memory, least threads, least files) in the second quarter of the time, and in the last.

        Threads and connections of the ORB come and go; what leaks stays.
        """
        quarter = len(self.seen) // 4
        parts = [list(zip(*part)) for part in (self.seen[quarter:2 * quarter], self.seen[3 * quarter:])]
        return [(max(memory), min(threads), min(files)) for memory, threads, files in parts]

    def end(self):
        self.process.terminate()
        if self.feed:
            self.process.stdin.close()
        self.process.wait(running.LIMIT)
        if not isinstance(self.output, io.FileIO):
            self.output.close()


def terminal_pair():
    """A terminal: the file that its user has, and that of its programs."""
    outside, inside = pty.openpty()
    fcntl.ioctl(inside, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
    return os.fdopen(outside, "r+b", 0), os.fdopen(inside, "r+b", 0)


def drain(file):
    """Read the output, and close the file at its end."""
    with file:
        try:
            while file.read(65536):
                pass
        except OSError:  # how Linux says that the other side is closed
            pass


def setUpModule():
    global around, server
    around = running.Surroundings()
    server = around.name_server()
    around.world(server, "senders", "100", "1000")
    around.world(server, "observed")
    around.world(server, "config")


def tearDownModule():
    around.close()


class LongRuns(unittest.TestCase):
    def test_nothing_grows(self):
        home = server + "/test.host_cxt"
        source = home + "/Source0.rtc"
        feed = LINES.replace("HOME", home)
        for letter, name in (
            ("A", "Source0"),
            ("C", "ConfigSample0"),
            ("D", "ConsoleIn0"),
            ("E", "ConsoleOut0"),
        ):
            feed = feed.replace(" %s:" % letter, " %s/%s.rtc:" % (home, name)).replace(
                " %s;" % letter, " %s/%s.rtc;" % (home, name)
            )
        wanted = [
            ("rtprint", ["rtprint", source + ":number"]),
            ("rtprint-stats", ["rtprint", "--stats", source + ":block"]),
            ("rtlog", ["rtlog", "-f", "log", source + ":number", source + ":block"]),
            ("rtwatch", ["rtwatch", home + "/ConsoleIn0.rtc", source]),
            ("rtvlog", ["rtvlog", home + "/Motor0.rtc"]),
        ]
        watched = [Watched(name, words) for name, words in wanted]
        watched += [
            Watched("rttop", ["rttop", home], terminal=True),
            Watched("rtsh", ["rtsh"], feed.encode()),
        ]
        end = time.monotonic() + SECONDS
        while time.monotonic() < end:
            time.sleep(SECONDS / 60)  # a period, not a wait for something
            around.ctl("observed", "log", "Motor0", "ERROR", "motor", "hot")
            for each in watched:
                each.measure()
        said = []
        for each in watched:
            before, after = each.halves()
            said.append("%s %d to %d kB, %d threads, %d files" % ((each.name, before[0]) + after))
            with self.subTest(each.name):
                self.assertIsNone(each.process.poll(), "it has ended")
                self.assertLess(after[0], before[0] + GROWTH, each.seen)
                self.assertLessEqual(after[1], before[1] + 1, each.seen)
                self.assertLessEqual(after[2], before[2] + OVERLAP, each.seen)
                self.assertLess(after[0], running.RESIDENT)
            each.end()
        print("figures: %d s side by side: %s" % (SECONDS, "; ".join(said)))


if __name__ == "__main__":
    unittest.main()
