"""The kernel of a simulated host as it starts the processes of a program, and sends signals to their groups:
in the place of net/children.py.
"""

import errno
import os

from fuse import Descriptor

from rtshell_lite.net import loop, real

SENT = 1e-4  # seconds until a signal arrives
LATER = 0.05  # seconds after which one that is stopped is asked again whether it goes on
CRASH = 11  # the number of the signal


class Children:
    """What a Program has of net/children.py."""

    def __init__(self, program):
        self._program = program

    def Guardian(self):
        return Guardian(self._program)

    def reap(self, ended):
        program = self._program

        def take():
            while program.ended_children:
                ended(*program.ended_children.pop(0))

        loop.current().hear(real.SIGCHLD, take)
        program.hears_of_children = True
        take()

    def output_of(self, child):
        return child.stdout

    def kill(self, group, number):
        world = self._program.world
        world.at(SENT, lambda: [strike(each, number) for each in of_groups(self._program.host, [group])])

    def listening_ports(self, groups):
        host = self._program.host
        members = of_groups(host, groups)
        return {port for port, each in host.listeners.items() if each.program in members}


class Guardian(Descriptor):
    """The pipe at whose end all groups are killed that were entered, and not left."""

    pid = None  # it never ends

    def __init__(self, program):
        super().__init__(program)
        self._groups = []

    def enter(self):
        """Called by a child that is about to begin."""
        self._groups.append(self.program.forked)

    def leave(self, group):
        if group in self._groups:
            self._groups.remove(group)

    def events(self, wanted):
        return 0

    def close(self):
        super().close()
        for group in self._groups:
            Children(self.program).kill(group, real.SIGKILL)
        self._groups = []


class Pipe(Descriptor):
    """What a group prints, as its parent reads it."""

    def __init__(self, program):
        super().__init__(program)
        self._data = b""
        self._writers = []

    def events(self, wanted):
        return loop.READ if wanted & loop.READ and (self._data or not self._writers) else 0

    def read(self, most):
        self.program.vain = 0
        data = self._data[:most]
        self._data = self._data[most:]
        return data if data or not self._writers else None

    def connect(self, program):
        """Take what a Program prints from now on."""
        self._writers.append(program)
        program.out = program.error = self

    def let_go(self, program):
        self._writers.remove(program)
        self.program.wake()

    # ---- as a file ----

    def write(self, text):
        self._data += text if isinstance(text, bytes) else text.encode()
        self.program.wake()

    def flush(self):
        """All is written at once."""


class Child:
    """As subprocess.Popen."""

    def __init__(self, program):
        self.pid = program.pid
        self.stdout = program.out


def start(parent, words, enter):
    """Start a program of `world.executables` in a group of its own. Raises OSError."""
    make = parent.world.executables.get(words[0])
    if make is None:
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), words[0])
    made = make(parent.host, *words[1:])
    parent.forked = made.group = made.pid
    enter()
    Pipe(parent).connect(made)
    made.at_end = lambda: _end(parent, made)
    return Child(made)


def _end(parent, program):
    program.out.let_go(program)
    parent.ended_children.append((program.pid, wait_status(program)))
    if parent.hears_of_children:
        parent.strike(real.SIGCHLD)


def wait_status(program):
    """How a Program has ended, as of os.waitpid."""
    if program.status is not None:
        return program.status << 8
    return CRASH if program.has_crashed else program.killed_by


def join(program, leader):
    """Have a Program be one of the group of another, as what that has started."""
    program.group = leader.group
    leader.out.connect(program)
    program.at_end = lambda: program.out.let_go(program)


def of_groups(host, groups):
    """The Programs of some groups that run on a host."""
    return [each for each in host.world.programs if each.host is host and each.group in groups]


def strike(program, number):
    """A signal arrives."""
    if program.is_over or number in program.ignores:
        return
    if program.is_stopped and number != real.SIGKILL:
        program.world.at(LATER, strike, program, number)
        return
    program.killed_by = number
    program.kill()
