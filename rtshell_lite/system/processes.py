"""Keeping the processes of a robot: started in order, each when what it needs is ready; started again when it
ends, by its policy; ended in reverse.
"""

import collections
import os
import select
import signal
import time

from rtshell_lite import errors, notes
from rtshell_lite.corba import orb
from rtshell_lite.net import loop
from rtshell_lite.robot import tree
from rtshell_lite.system import policy

LINES = 200  # of output that are kept of each
LONGEST = 4096  # characters of a line
LOG = 4 << 20  # octets of a log file, after which it becomes NAME.log.1
TICK = 0.1  # seconds between looks whether one is ready
SEEK = 1.0  # seconds between looks whether one that somebody else has started is still there
PR_SET_PDEATHSIG = 1  # of prctl(2)


class Process:
    """One process: its `spec`, `state` (waiting, running, ready, foreign, stopped), `pid` or None, `since`,
    `restarts`, the last `lines` that it wrote.
    """

    def __init__(self, spec):
        self.spec = spec
        self.name = spec.name
        self.trial = policy.Trial(spec.policy)
        self.state = "waiting"
        self.pid = self.status = None
        self.since = time.time()
        self.restarts = 0
        self.lines = collections.deque(maxlen=LINES)
        self.is_wanted = True
        self.changed = []  # Waits of those who want to know

    def become(self, state):
        """Note its state, and let those know who wait for that."""
        if state != self.state:
            self.state = state
            self.since = time.time()
        waiting = self.changed
        self.changed = []
        for wait in waiting:
            wait.done()

    async def until(self, reached):
        """Wait until reached()."""
        while not reached():
            wait = loop.Wait()
            self.changed.append(wait)
            await wait

    def as_dict(self):
        """For `rtkeep status`."""
        return {
            "kind": "process",
            "object": self.name,
            "wanted": "running" if self.is_wanted else "stopped",
            "state": self.state,
            "pid": self.pid,
            "since": self.since,
            "restarts": self.restarts,
            "lines": list(self.lines),
            "given_up": self.trial.given_up,
        }

    @property
    def is_ready(self):
        """Whether those after it may start."""
        return self.state in ("ready", "foreign")


class Processes:
    """The processes of Specs: `async with processes: …` starts and keeps them, and ends them at its end.

    happened(name, seen, done)  called with what happens
    wrote(name, line)           called with each line that one writes
    log                         directory for logs, or None
    """

    def __init__(self, specs, happened, wrote, log=None):
        self.all = [Process(spec) for spec in specs]
        self.happened = happened
        self._wrote = wrote
        self._log = log
        self._by_pid = {}
        self._guard = _guardian()
        self._group = None

    async def __aenter__(self):
        loop.current().hear(signal.SIGCHLD, self._reap)
        self._group = loop.Group()
        for process in self.all:
            self._group.start(self._keep(process))
        return self

    async def __aexit__(self, kind, error, traceback):
        self._group.cancel()
        await self._group.__aexit__(kind, error, traceback)
        for process in self.all:
            if process.pid is not None:
                _kill(process.pid, signal.SIGKILL)
        os.close(self._guard)

    def named(self, name):
        """The Process of a name, or None."""
        return next((process for process in self.all if process.name == name), None)

    # ---- the life of one ----

    async def _keep(self, process):
        while True:
            await process.until(lambda: process.is_wanted)
            for other in [self.named(name) for name in process.spec.after]:
                await other.until(lambda: other.is_ready)
            if await self._is_foreign(process):
                continue
            begun = time.monotonic()
            try:
                self._spawn(process)
            except OSError as e:
                await self._ended(process, f"cannot be started: {os.strerror(e.errno)}", True)
                continue
            self.happened(process.name, "", f"started, pid {process.pid}", begun)
            await loop.race(self._until_ready(process, begun), process.until(lambda: process.pid is None))
            await process.until(lambda: process.pid is None)
            await self._ended(process, _in_words(process.status), process.status != 0)

    async def _is_foreign(self, process):
        """Whether somebody else has started it: then wait until that one is gone."""
        if not await self._answers(process):
            return False
        self.happened(process.name, f"{process.spec.ready} answers already", "not started", None)
        process.become("foreign")
        while await self._answers(process):
            await loop.sleep(SEEK)
        process.become("waiting")
        return True

    @staticmethod
    async def _answers(process):
        """Whether what shows that it is ready answers."""
        if process.spec.ready is None:
            return False
        try:
            node = await tree.resolve(process.spec.ready)
            await orb.is_alive(node.path, node.ref)
            return True
        except errors.Error:
            return False

    async def _until_ready(self, process, begun):
        process.become("running")
        while process.spec.ready is not None and not await self._answers(process):
            await loop.sleep(TICK)
        process.become("ready")
        if process.spec.ready is not None:
            self.happened(process.name, f"{process.spec.ready} answers", "ready", begun)

    async def _ended(self, process, seen, has_failed):
        """It has ended: wait until it may be started again."""
        process.become("stopped")
        is_restarted = process.spec.policy.restart == "always"
        is_restarted = is_restarted or process.spec.policy.restart == "on-error" and has_failed
        if not process.is_wanted:
            self.happened(process.name, seen, "as it was told", None)
            return
        process.trial.fail()
        if process.trial.given_up or not is_restarted:
            why = process.trial.why_given_up() if process.trial.given_up else "not started again"
            self.happened(process.name, seen, why, None)
            process.is_wanted = False
            return
        self.happened(process.name, seen, "", None)
        process.restarts += 1
        await loop.sleep(max(0, process.trial.until - time.monotonic()))

    # ---- the operating system ----

    def _spawn(self, process):
        import subprocess

        die_with_parent = _pdeathsig()
        guard = self._guard

        def prepare():
            die_with_parent()
            os.write(guard, b"+%d\n" % os.getpid())

        child = subprocess.Popen(
            process.spec.command,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            cwd=process.spec.cwd,
            env=dict(os.environ, **process.spec.env),
            start_new_session=True,
            preexec_fn=prepare,
        )
        child.returncode = 0  # it is reaped here
        process.pid = child.pid
        process.status = None
        self._by_pid[child.pid] = process
        output = os.dup(child.stdout.fileno())
        child.stdout.close()
        os.set_blocking(output, False)
        rest = [b""]
        loop.current().watch(output, select.POLLIN, lambda: self._read(process, output, rest))

    def _read(self, process, output, rest):
        """Take what a process writes; `rest` holds the beginning of a line."""
        try:
            data = os.read(output, 1 << 16)
        except BlockingIOError:
            return
        lines = (rest[0] + data).split(b"\n")
        if data and len(lines[-1]) < LONGEST:
            rest[0] = lines.pop()
        else:
            rest[0] = b""
        for line in filter(None, lines) if not data else lines:
            text = line[:LONGEST].decode("utf-8", "replace").rstrip("\r")
            process.lines.append(text)
            self._wrote(process.name, text)
            self._write_log(process.name, text)
        if not data:
            loop.current().unwatch(output)
            os.close(output)

    def _write_log(self, name, line):
        if self._log is None:
            return
        target = os.path.join(self._log, name + ".log")
        try:
            with open(target, "a", encoding="utf-8") as file:
                file.write(time.strftime("%Y-%m-%dT%H:%M:%S ") + line + "\n")
                is_full = file.tell() > LOG
            if is_full:
                os.replace(target, target + ".1")
        except OSError as e:  # a full disk is no reason to leave a robot alone
            self._log = None
            notes.fail(f"nothing more goes to the logs: {e.strerror}")

    def _reap(self):
        """Take the status of processes that have ended, as PID 1 of those of others, too."""
        while True:
            try:
                pid, status = os.waitpid(-1, os.WNOHANG)
            except ChildProcessError:
                return
            if pid == 0:
                return
            process = self._by_pid.pop(pid, None)
            if process is not None:
                _kill(pid, signal.SIGKILL)  # what is left of its group
                os.write(self._guard, b"-%d\n" % pid)
                process.pid = None
                process.status = status
                process.become("stopped")

    # ---- ending ----

    def resume(self, process):
        """Start one again that was stopped or given up."""
        process.trial.begin_again()
        process.is_wanted = True
        process.become(process.state)

    async def stop(self, stopped=None):
        """End some processes (default: all), each when those after it have ended."""
        stopped = self.all if stopped is None else stopped
        for process in stopped:
            process.is_wanted = False
        await loop.each(stopped, self._stop)

    async def _stop(self, process):
        for other in self.all:
            if process.name in other.spec.after and not other.is_wanted:
                await other.until(lambda: other.pid is None)
        number, seconds = process.spec.stop
        begun = time.monotonic()
        for last in (number, signal.SIGKILL):
            if process.pid is None:
                return
            _kill(process.pid, last)
            await loop.race(process.until(lambda: process.pid is None), loop.sleep(seconds))
        self.happened(process.name, f"does not end within {seconds:g}s", "killed", begun)


def _kill(pid, number):
    """Send a signal to the group of a process."""
    try:
        os.killpg(pid, number)
    except (ProcessLookupError, PermissionError):
        pass


def _in_words(status):
    if os.WIFSIGNALED(status):
        return "ended by " + signal.Signals(os.WTERMSIG(status)).name
    return "ended with status %d" % os.WEXITSTATUS(status)


def _pdeathsig():
    """A function for the child that has the kernel kill it when this process ends, where that can be done."""
    try:
        import ctypes

        prctl = ctypes.CDLL(None).prctl
    except (ImportError, OSError, AttributeError):
        return lambda: None
    return lambda: prctl(PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)


def _guardian():
    """The end of a pipe: groups of processes that are written there as +PID, and not as -PID, are killed by a
    process of its own as soon as this one is gone, even by kill -9.
    """
    reading, writing = os.pipe()
    if os.fork():
        os.close(reading)
        os.set_inheritable(writing, False)
        return writing
    try:
        _watch_over(reading)
    finally:
        os._exit(0)


def _watch_over(reading):
    os.setsid()
    for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)
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
        _kill(group, signal.SIGKILL)
