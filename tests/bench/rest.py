"""What followers of many components cost while nothing happens: CPU of each, and the calls that it makes.

    python3 tests/bench/rest.py [-n COMPONENTS] [-t SECONDS] [--polled] [--beats] [rttop rtwatch rtlog rtkeep]

Components are connected in pairs, and take observers; with `--polled` they take none. Heartbeats are kept
out: observers are asked for them so rarely that none comes meanwhile; with --beats they come as they do to
users. rttop is a live page on a terminal of 80 by 24, and keeps its heartbeat of each process in 20 s, as it
trusts in nothing else.
"""
import argparse
import collections
import fcntl
import os
import pty
import signal
import subprocess
import sys
import tempfile
import termios
import threading
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path[:0] = [ROOT, os.path.join(ROOT, "tests", "support")]
import worlds  # noqa: E402: the path first

FOLLOWERS = {
    "rttop": "rttop .",
    "rtwatch": "rtwatch {all}",
    "rtlog": "rtlog record --events -q -f log.mcap -e -1 .",
    "rtkeep": "rtkeep keep -q robot.rtsys",
}
QUIET = 60.0  # seconds without a lent observer
# runs a command with hardly any heartbeats
RARELY = """
import runpy, sys
from rtshell_lite.live import times
times.BEAT = times.BEAT_SHOWN = 3600.0
sys.argv[:] = sys.argv[1:]
runpy.run_path(sys.argv[0], run_name="__main__")
"""


class Follower:
    """A command that runs on a terminal of its own."""

    def __init__(self, words, environment, directory, beats):
        master, slave = pty.openpty()
        fcntl.ioctl(slave, termios.TIOCSWINSZ, b"\x18\0\x50\0\0\0\0\0")
        run = [sys.executable] if beats else [sys.executable, "-c", RARELY]
        command = run + [os.path.join(ROOT, "bin", words[0])] + words[1:]
        self.process = subprocess.Popen(
            command, stdin=slave, stdout=slave, stderr=slave, cwd=directory, env=environment,
            start_new_session=True,
        )
        os.close(slave)
        self.said = collections.deque(maxlen=20)
        threading.Thread(target=self._read, args=(master,), daemon=True).start()

    def _read(self, master):
        while True:
            try:
                self.said.append(os.read(master, 65536))
            except OSError:
                return

    def cpu(self):
        """Seconds of CPU that it has used."""
        if self.process.poll() is not None:
            raise SystemExit("it has ended: %s" % b"".join(self.said).decode(errors="replace"))
        with open("/proc/%d/stat" % self.process.pid) as file:
            fields = file.read().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def end(self):
        self.process.terminate()
        self.process.wait()


def calls(world):
    """{operation: how often the components have been asked it}"""
    listed = [line.split() for line in world.ctl("calls").splitlines()]
    return {operation: int(count) for count, operation in listed}


def wait_until_at_rest(world):
    """Wait until nobody has been lent an observer for a while, as those of many components take minutes on a
    busy machine.
    """
    lent = -1
    while calls(world).get("add_service_profile", 0) != lent:
        lent = calls(world).get("add_service_profile", 0)
        time.sleep(QUIET)


def measure(name, world, words, environment, directory, args):
    beats = args.beats or name == "rttop"
    follower = Follower(words, environment, directory, beats)
    try:
        wait_until_at_rest(world)
        world.ctl("reset")
        before, begun = follower.cpu(), time.monotonic()
        time.sleep(args.t)
        used, seconds = follower.cpu() - before, time.monotonic() - begun
        asked = calls(world)
    finally:
        follower.end()
    most = sorted(asked.items(), key=lambda item: -item[1])[:4]
    print(
        "%-8s %6.2f %% of a core  %8.2f calls/s  %s" % (
            name, 100 * used / seconds, sum(asked.values()) / seconds,
            ", ".join("%.2f %s" % (count / seconds, operation) for operation, count in most),
        ),
        flush=True,
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("-n", type=int, default=1000)
    parser.add_argument("-t", type=float, default=60.0)
    parser.add_argument("--polled", action="store_true")
    parser.add_argument("--beats", action="store_true")
    parser.add_argument("followers", nargs="*", metavar="COMMAND")
    args = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # the follower is to end, too
    worlds.start_name_server()
    world = worlds.World("many", str(args.n), *["--flavour", "java"] * args.polled)
    place = "localhost:%d" % worlds.Server.port
    environment = dict(
        worlds.ENVIRONMENT, TERM="xterm", RTSHELL_ORB="builtin", RTCTREE_NAMESERVERS=place,
        RTCSH_CWD="/%s/test.host_cxt" % place, PYTHONPATH=ROOT,
    )
    names = ["Mock%d.rtc" % number for number in range(args.n)]
    try:
        with tempfile.TemporaryDirectory() as directory:
            environment["XDG_RUNTIME_DIR"] = directory
            lines = ["rtcon %s:out %s:in" % pair for pair in zip(names[::2], names[1::2])]
            lines += ["rtact " + name for name in names] + ["rtcryo --all -o robot.rtsys ."]
            subprocess.run(
                [sys.executable, os.path.join(ROOT, "bin", "rtsh"), "-c", "; ".join(lines)],
                cwd=directory, env=environment, check=True, stdout=subprocess.DEVNULL,
            )
            for name in args.followers or FOLLOWERS:
                words = []
                for word in FOLLOWERS[name].split():
                    words += names if word == "{all}" else [word]
                measure(name, world, words, environment, directory, args)
    finally:
        world.close()
        worlds.Server.stop()


if __name__ == "__main__":
    main()
