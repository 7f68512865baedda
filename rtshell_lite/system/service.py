"""rtkeep as a service: a system and its processes, kept until a signal, steered by others, logged."""

import os

from rtshell_lite import errors, notes
from rtshell_lite.corba import refusals
from rtshell_lite.net import children, loop, real
from rtshell_lite.system import happening, keep, plan, restore, steering
from rtshell_lite.system.kept import KeptComponent
from rtshell_lite.text import safe
from rtshell_lite.xmlprofile import model

LOOK = 0.5  # seconds between looks whether all is as the file says, at the start


class Nothing:
    """In the place of Processes where there is no Procfile."""

    all = ()

    async def __aenter__(self):
        if os.getpid() == 1:  # of a container, where others leave theirs with us
            children.of_world().reap(lambda pid, status: None)
        return self

    async def __aexit__(self, *_):
        return None

    def listening_ports(self):
        """None."""
        return set()

    def named(self, name):
        """None."""
        return []

    async def stop(self, stopped=None):
        """Nothing."""


class Service:
    """Keeps what is read: `await Service(…).run(processes)` returns the exit status.

    name       the file that is kept, for the lock
    read       function that returns (profile, its Plan of starting, its Plan of stopping), for `reload`
    options    keep.Options
    show       called with each Happening
    log        the happening.Log to which each goes
    """

    def __init__(self, name, read, options, show, log):
        self.name = name
        self._read = read
        self._options = options
        self.processes = Nothing()  # type: object
        self._show = show
        self._log = log
        self.keeper = None
        self.since = loop.wall()
        self._files = None  # what was read last
        self._wanted = None  # reload, stop, or the number of a signal
        self._bell = loop.Bell()
        self._second = loop.Bell()
        self._is_hurried = False  # a second signal has come
        # whether all components are deactivated at the end, and not only those of the processes that we have
        # started; `is_leaving`: not even these
        self.is_stopping_all = False
        self.is_leaving = False
        self.has_teardown = False

    def report(self, event):
        self._show(event)
        steering.notify(STATUS=safe(event.line()))
        self._log.add(event)

    def process_happened(self, name, seen, done="", begun=None):
        """Report what happens to a process; `begun` by loop.now()."""
        self.report(happening.now(name, seen, done, begun))

    async def run(self, processes):
        """Keep it, and Processes or Nothing, until a signal or a request ends that; a second signal ends it
        at once.
        """
        self.processes = processes
        here = loop.current()
        for number in (real.SIGTERM, real.SIGINT):
            here.hear(number, lambda number=number: self._signalled(number))
        if not _has_terminal():
            here.hear(real.SIGHUP, self._hang_up)
        elif loop.world().handler(real.SIGHUP) is not real.IGNORED:  # nohup
            here.hear(real.SIGHUP, self._closed)
        self._load()
        async with steering.Door(self.name, self.answer), self.processes:
            while self._wanted in (None, "reload"):
                self._wanted = None
                await self._keep(*self._files)
            await loop.race(self.processes.stop(), self._second.wait())
        return 128 + self._wanted if self._is_hurried else 0

    async def _keep(self, profile, starting, stopping):
        before = self.keeper
        async with keep.Keeper(profile, starting, self._options, self.report, before) as self.keeper:
            async with loop.background(self._report()):
                await self._bell.wait()
            if self._wanted != "reload":
                steering.notify(STOPPING=1)
            if self._wanted != "reload" and not self.is_leaving:
                await loop.race(self._stop_components(profile, stopping), self._second.wait())

    async def _stop_components(self, profile, stopping):
        """Deactivate the components that end with us by the plan of stopping."""
        if not self.is_stopping_all and self._wanted != "stop":
            own = await self._own_endpoints()
            await self.keeper.stop(stopping, lambda kept: kept.endpoint in own)
            return
        await self.keeper.stop(stopping, lambda kept: True)
        if self.has_teardown:
            await restore.tear_down(profile, restore.Options(False, None, self._options.strict_path))

    async def _own_endpoints(self):
        """The endpoints of components in the processes that we have started."""
        ports = self.processes.listening_ports()
        own = set()
        for endpoint in {kept.endpoint for kept in self.keeper.followed if kept.is_there}:
            if endpoint[1] in ports and await refusals.is_this_host(endpoint[0]):
                own.add(endpoint)
        return own

    async def _report(self):
        """Tell the service manager when all is so, and that we live."""
        every = steering.watchdog()
        is_ready = False
        while True:
            if every is not None:
                steering.notify(WATCHDOG=1)
            if not is_ready and self.is_settled():
                is_ready = steering.notify(READY=1)
            if is_ready and every is None:
                return
            await loop.sleep(LOOK if every is None else min(LOOK, every))

    def is_settled(self):
        """Whether all is as the files say, as far as is known."""
        return self.keeper.is_settled() and all(process.is_settled for process in self.processes.all)

    def _load(self):
        """Read the files. Raises what is wrong with them; then nothing changes."""
        files = self._read()
        keep.Keeper(files[0], files[1], self._options, self.report)  # raises what else is wrong
        self._files = files

    def _reload(self):
        self._load()
        if not self._is_ending:
            self._want("reload")

    def _hang_up(self):
        try:
            self._reload()
        except (errors.Error, OSError) as e:
            notes.fail(e)

    def _closed(self):
        """The terminal has been closed; the shell and the kernel may both say so."""
        if not self._is_ending:
            self._want(real.SIGHUP)

    @property
    def _is_ending(self):
        return isinstance(self._wanted, int) or self._wanted == "stop"

    def _want(self, what):
        self._wanted = what
        self._bell.ring()

    def _signalled(self, number):
        if self._is_ending:
            self._is_hurried = True
            self._wanted = number
            self._second.ring()
        else:
            self._want(number)

    # ---- requests ----

    def answer(self, request):
        """The lines of the answer to a request of `rtkeep COMMAND NAME …`. Raises NoSuch."""
        command = request["command"]
        if self._is_ending and command in ("reload", "resume"):
            raise errors.Failed(self.name, "its rtkeep is ending")
        if command == "status":
            all_kept = [*self.keeper.followed, *self.processes.all]
            return [self.as_dict()] + [kept.as_dict() for kept in all_kept]
        if command == "reload":
            self._reload()
        elif command == "stop" and not request["names"]:
            self._want("stop")
        elif command in ("pause", "resume", "stop"):
            for kept in self._named(request["names"]):
                getattr(self, "_" + command)(kept)
        else:
            raise errors.Usage(f"no such command: {command}")
        return []

    def as_dict(self):
        """For `rtkeep status`."""
        return {
            "kind": "rtkeep",
            "object": self.name,
            "pid": loop.world().own_pid(),
            "since": self.since,
            "settled": self.is_settled(),
        }

    def _named(self, names):
        """KeptComponents and Processes; all where there are no names."""
        if not names:
            return [*self.keeper.followed, *self.processes.all]
        all_kept = []
        for name in names:
            meant = self.keeper.named(name) + self.processes.named(name)
            if not meant:
                raise errors.NoSuch(self.name, "component or process in it", name)
            if len(meant) > 1:
                paths = ", ".join(kept.as_dict()["object"] for kept in meant)
                raise errors.Ambiguous(name, paths)
            all_kept += meant
        return all_kept

    def _pause(self, kept):
        if isinstance(kept, KeptComponent):
            kept.is_paused = True
        else:
            kept.is_wanted = False

    def _resume(self, kept):
        if isinstance(kept, KeptComponent):
            kept.take_back()
        else:
            self.processes.resume(kept)

    def _stop(self, kept):
        if isinstance(kept, KeptComponent):
            kept.is_paused = True
            self.keeper.start(self.keeper.stop_one(kept))
        else:
            self.processes.begin_to_stop(kept)


def _has_terminal():
    """Whether this process has a terminal that may be closed."""
    try:
        os.close(os.open(os.ctermid(), os.O_RDWR | os.O_NOCTTY))
    except OSError:
        return False
    return True


def empty():
    """The profile where only processes are kept."""
    return model.RtsProfile(components=[])


def plans(profile, name):
    """(profile, its Plan of starting, its Plan of stopping). Raises Failed."""
    return profile, plan.make(profile, "activation", name), plan.make(profile, "deactivation", name, False)
