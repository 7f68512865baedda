"""Keeping the processes of a robot: started in order, each when what it needs is ready; started again when it
ends, by its policy; ended in reverse.
"""

import os

from rtshell_lite import errors
from rtshell_lite.corba import orb, refusals
from rtshell_lite.net import children, loop, real
from rtshell_lite.robot import tree
from rtshell_lite.system import output, policy

TICK = 0.1  # seconds between looks whether one is ready
SEEK = 1.0  # seconds between looks whether one that somebody else has started is still there
PATIENCE = 5.0  # seconds after which it is reported that one is not ready yet, and looked at less often
# names, by number: of several the first; some of real time have none
_SIGNALS = {number: name for name, number in sorted(real.signals().items(), reverse=True)}
ANSWERS = "answers already"
HANGS = "does not answer, but is not gone"
UNKNOWN = "cannot be looked for: its name server does not answer"
# variables by which a service manager informs us alone
OURS = ("NOTIFY_SOCKET", "WATCHDOG_USEC", "WATCHDOG_PID")


class Process:
    """One process: its `spec`, `state` (waiting, running, ready, foreign, stopped), `pid` or None, `since`,
    `restarts`, its `output`.
    """

    def __init__(self, spec, output):
        self.spec = spec
        self.name = spec.name
        self.trial = policy.Trial(spec.policy)
        self.state = "waiting"
        self.pid = self.status = None
        self.since = loop.wall()
        self.restarts = 0
        self.output = output
        self.is_wanted = True
        self.is_stopping = False
        self.has_finished = False
        self.changed = []  # Waits of those who want to know

    def become(self, state):
        """Note its state, and let those know who wait for that."""
        if state != self.state:
            self.state = state
            self.since = loop.wall()
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
            "lines": list(self.output.lines),
            "given_up": self.trial.given_up,
        }

    @property
    def is_settled(self):
        """Whether it is as its Procfile says: it is ready, or has ended and is not to be started again."""
        return self.is_ready or self.has_finished

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
        self.all = [Process(spec, output.Output(spec.name, wrote, log)) for spec in specs]
        self.happened = happened
        self._by_pid = {}
        self._children = children.of_world()
        self._guardian = self._children.Guardian()
        self._group = None

    async def __aenter__(self):
        self._children.reap(self._reaped)
        self._group = loop.Group()
        for process in self.all:
            self._group.start(self._keep(process))
        return self

    async def __aexit__(self, kind, error, traceback):
        self._group.cancel()
        await self._group.__aexit__(kind, error, traceback)
        for pid in self._by_pid:
            self._children.kill(pid, real.SIGKILL)
        self._by_pid = {}
        self._guardian.close()

    def listening_ports(self):
        """The TCP ports at which processes of it listen, a set."""
        return self._children.listening_ports(self._by_pid)

    def named(self, name):
        """The Processes of a name: one at most."""
        return [process for process in self.all if process.name == name]

    # ---- the life of one ----

    async def _keep(self, process):
        while True:
            await process.until(lambda: process.is_wanted)
            for other in [other for name in process.spec.after for other in self.named(name)]:
                await other.until(lambda: other.is_ready)
            if not process.is_wanted or await self._is_foreign(process) or not process.is_wanted:
                continue
            begun = loop.now()
            try:
                self._spawn(process)
            except OSError as e:
                await self._ended(process, f"cannot be started: {os.strerror(e.errno)}", True)
                continue
            self.happened(process.name, "", f"started, pid {process.pid}", begun)
            has_ended = process.until(lambda: process.pid is None)
            await loop.race(self._until_ready(process, begun), has_ended)
            await process.until(lambda: process.pid is None)
            await self._ended(process, _in_words(process.status), process.status != 0)

    async def _is_foreign(self, process):
        """Whether somebody else has started it, or may have: then wait until that one is gone. One that hangs
        lives: a second one would take its name.
        """
        told = None
        while True:
            seen = await _seen(process)
            if seen is None:
                break
            if seen != told:
                self.happened(process.name, f"{process.spec.ready} {seen}", "not started")
                process.become("foreign" if seen == ANSWERS else "waiting")
                told = seen
            await loop.sleep(SEEK)
        process.become("waiting")
        return told is not None

    async def _until_ready(self, process, begun):
        process.become("running")
        if process.spec.ready is not None:
            is_late = False
            while await _seen(process) != ANSWERS:
                if not is_late and loop.now() - begun > PATIENCE:
                    is_late = True
                    self.happened(process.name, f"{process.spec.ready} does not answer yet", "waits")
                await loop.sleep(SEEK if is_late else TICK)
            self.happened(process.name, f"{process.spec.ready} answers", "ready", begun)
        process.become("ready")

    async def _ended(self, process, seen, has_failed):
        """It has ended: wait until it may be started again."""
        process.become("stopped")
        restart = process.spec.policy.restart
        process.trial.fail()
        if not process.is_wanted:
            why = "as it was told"
        elif process.trial.given_up:
            why = process.trial.why_given_up()
        elif restart == "no" or restart == "on-error" and not has_failed:
            why = "not started again"
            process.has_finished = not has_failed
        else:
            why = ""
        self.happened(process.name, seen, why)
        if why:
            process.is_wanted = False
            return
        process.restarts += 1
        pause = loop.sleep(max(0, process.trial.until - loop.now()))
        await loop.race(pause, process.until(lambda: not process.trial.failures))

    # ---- the operating system ----

    def _spawn(self, process):
        inherited = {name: value for name, value in os.environ.items() if name not in OURS}
        child = loop.world().start_process(
            process.spec.command, stdin=real.NOTHING, stdout=real.PIPE, stderr=real.SAME,
            cwd=process.spec.cwd, env=dict(inherited, **process.spec.env), start_new_session=True,
            preexec_fn=self._guardian.enter, bufsize=0,
        )
        child.returncode = 0  # it is reaped here
        process.pid = child.pid
        process.status = None
        process.has_finished = False
        self._by_pid[child.pid] = process
        process.output.follow(self._children.output_of(child))

    def _reaped(self, pid, status):
        process = self._by_pid.pop(pid, None)
        if pid == self._guardian.pid:
            self._guardian.begin(self._by_pid)
        elif process is not None:
            self._children.kill(pid, real.SIGKILL)  # what is left of its group
            self._guardian.leave(pid)
            process.pid = None
            process.status = status
            process.become("stopped")

    # ---- ending ----

    def resume(self, process):
        """Start one again that was stopped or given up."""
        process.trial.begin_again()
        process.is_wanted = True
        process.become(process.state)

    def begin_to_stop(self, process):
        """Stop one while others go on, and the files are read again."""
        self._group.start(self.stop([process]))

    async def stop(self, stopped=None):
        """End some processes (default: all), each when those after it have ended."""
        stopped = self.all if stopped is None else stopped
        for process in stopped:
            process.is_wanted = False
            process.is_stopping = True
        try:
            await loop.each(stopped, self._stop)
        finally:
            for process in stopped:
                process.is_stopping = False

    async def _stop(self, process):
        for other in self.all:
            if process.name in other.spec.after and other.is_stopping:  # one that is paused runs on
                await other.until(lambda: other.pid is None)
        number, seconds = process.spec.stop
        begun = loop.now()
        for last in (number, real.SIGKILL):
            if process.pid is None:
                return
            self._children.kill(process.pid, last)
            await loop.race(process.until(lambda: process.pid is None), loop.sleep(seconds))
        self.happened(process.name, f"does not end within {seconds:g}s", "killed", begun)


async def _seen(process):
    """ANSWERS, HANGS, UNKNOWN, or None: what is at the path that shows that a process is ready."""
    node = None
    if process.spec.ready is None:
        return None
    try:
        node = await tree.resolve(process.spec.ready)
        await orb.is_alive(node.path, node.ref)
        return ANSWERS
    except errors.Unanswered:
        if node is None:
            return UNKNOWN
        # where it once was another host, or this one with another address, nothing hangs
        if await refusals.is_this_host(node.endpoint[0]):
            return HANGS
    except errors.Error:
        pass
    return None


def _in_words(status):
    if os.WIFSIGNALED(status):
        number = os.WTERMSIG(status)
        return "ended by " + _SIGNALS.get(number, "signal %d" % number)
    return "ended with status %d" % os.WEXITSTATUS(status)
