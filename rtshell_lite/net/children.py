"""What ends the processes that rtkeep has started when it is gone itself, even by kill -9: a small process
that watches it, and on Linux the kernel.
"""

import contextlib
import os
import sys

from rtshell_lite.net import loop, real

PR_SET_PDEATHSIG = 1  # of prctl(2)
LISTENING = "0A"  # the state of a socket in /proc/net/tcp


def of_world():
    """What has the names of this module in the world of this thread: this module, or what a test has instead.
    """
    return getattr(loop.world(), "children", sys.modules[__name__])


class Guardian:
    """Kills the process groups that were `enter`ed, and did not `leave`, as soon as this process is gone."""

    def __init__(self):
        self._prctl = _prctl()
        self._writing = None  # type: int
        self.begin([])

    def begin(self, groups):
        """Watch over some groups: at first, and when `pid`, the process that did, has been killed."""
        if self._writing is not None:
            os.close(self._writing)
        reading, self._writing = os.pipe()
        self.pid = os.fork()
        if self.pid:
            os.close(reading)
            for group in groups:
                self._write("+%d" % group)
            return
        try:
            _watch_over(reading)
        finally:
            os._exit(0)

    def enter(self):
        """To be called by a child between fork and exec."""
        if self._prctl is not None:
            self._prctl(PR_SET_PDEATHSIG, real.SIGKILL, 0, 0, 0)
        self._write("+%d" % os.getpid())

    def leave(self, pid):
        """The group of a process that has ended is gone."""
        self._write("-%d" % pid)

    def _write(self, line):
        with contextlib.suppress(BrokenPipeError):  # it has been killed; `begin` will be called
            os.write(self._writing, line.encode() + b"\n")

    def close(self):
        """Kill what is left."""
        self.pid = None
        os.close(self._writing)


def reap(ended):
    """Take the status of processes that end, and call ended(pid, status); as process 1 also of those of
    others.
    """

    def take():
        with contextlib.suppress(ChildProcessError):
            pid, status = os.waitpid(-1, os.WNOHANG)
            while pid:
                ended(pid, status)
                pid, status = os.waitpid(-1, os.WNOHANG)

    loop.current().hear(real.SIGCHLD, take)
    take()  # those that have ended before


def output_of(child):
    """What a subprocess.Popen prints: a file without a buffer, which does not wait."""
    os.set_blocking(child.stdout.fileno(), False)
    return child.stdout


def kill(pid, number):
    """Send a signal to the group of a process."""
    with contextlib.suppress(ProcessLookupError, PermissionError):
        os.killpg(pid, number)


def listening_ports(groups):
    """The TCP ports, a set, at which processes of these groups listen, as far as Linux's /proc shows that."""
    inodes = set()
    for pid in filter(str.isdigit, _names("/proc")):
        try:
            if os.getpgid(int(pid)) in groups:
                inodes.update(_sockets(f"/proc/{pid}/fd"))
        except OSError:  # it has ended
            continue
    ports = set()
    for table in ("/proc/net/tcp", "/proc/net/tcp6"):
        try:
            with open(table) as file:
                rows = [row.split() for row in list(file)[1:]]
        except OSError:
            continue
        own = [row[1] for row in rows if row[3] == LISTENING and row[9] in inodes]
        ports.update(int(address.rpartition(":")[2], 16) for address in own)
    return ports


def _sockets(folder):
    """The inodes, as text, of the sockets among the open files of a process."""
    for name in _names(folder):
        try:
            link = os.readlink(f"{folder}/{name}")
        except OSError:
            continue
        if link.startswith("socket:["):
            yield link[len("socket:[") : -1]


def _names(folder):
    try:
        return os.listdir(folder)
    except OSError:
        return []


def _prctl():
    """prctl(2), None where the system lacks it."""
    try:
        import ctypes

        return ctypes.CDLL(None).prctl
    except (ImportError, OSError, AttributeError):
        return None


def _watch_over(reading):
    os.setsid()
    for number in (real.SIGTERM, real.SIGINT, real.SIGHUP):
        real.handle(number, real.IGNORED)
    os.dup2(os.open(os.devnull, os.O_RDWR), 0)
    for fd in (1, 2):
        os.dup2(0, fd)
    os.dup2(reading, 3)
    os.closerange(4, 1024)
    groups = set()
    with open(3, "rb") as lines:
        for line in lines:
            if line.startswith(b"+"):
                groups.add(int(line))
            else:
                groups.discard(-int(line))
    for group in groups:
        kill(group, real.SIGKILL)
