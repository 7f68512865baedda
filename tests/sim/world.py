"""A world in one process of Python: hosts, their network, programs on them, and a clock that jumps to what
comes next. What happens in it is drawn from one seed.

Each program has a thread of its own, of which one runs at a time: the others wait in the poll of their loop.
So the code of commands and components is what runs on a robot; only net/real.py is another.
"""

import _socket
import collections
import errno
import heapq
import io
import itertools
import os
import random
import signal
import sys
import tempfile
import threading

import children
import disk as disks
import fuse
from disk import Killed

from rtshell_lite import cli, notes
from rtshell_lite.corba import failures
from rtshell_lite.net import loop, real

BEGIN = 1800000000.0  # seconds since 1970 when a world begins
FIRST = 1000.0  # what a clock that is never set shows then
AGAIN = 0.2  # seconds until what was lost is sent again, doubled each time
LONGEST_AGAIN = 3.0
GIVEN_UP = 120.0  # seconds until a host gives up a connection
ROOM = 1 << 18  # octets that wait in a socket at most
BUSY = 1e-5  # seconds that a program takes before it looks again
MOST_AT_ONCE = 200000  # turns of programs without any time passing: one of them never waits
FIRST_FD = 100000  # beyond real ones
MOST_VAIN = 10000  # polls that find something with which a program then does nothing: it spins
LOOK_UP = 20.0  # seconds that one takes of which a name server has not answered
NOBODY = 0  # a port at which nobody listens
# of GIOP: octets of the head of a message, its kinds
HEADER = 12
BODY = 200  # in which the name of the operation is
REQUEST = 0
REPLY = 1
CLOSE = b"GIOP\1\2\1\5\0\0\0\0"  # the whole message
OFTEN = 0.6  # of the questions after the first come to one who closes connections
LOOPBACK = "127.0.0.1"
ASKING_OTHERS = [operation.encode() + b"\0" for operation in failures._ASKING_OTHERS]


class Stuck(Exception):
    """A program has something to do again and again, and no time passes, or it does nothing about it."""


class Blocked(BaseException):
    """Raised by what is run on a thread, and waits longer."""


class World:
    """`time`: seconds since it began; `random`: from the seed; `story`: (time, line) of what has happened."""

    def __init__(self, seed):
        self.seed = seed
        self.random = random.Random(seed)
        self.time = 0.0
        self.hosts = {}
        self.programs = []
        self.rules = []  # of firewalls: function(host, other, port, size) returns DROP, REJECT or None
        self.story = []
        self.delays = {}  # {host: seconds more to it}
        self._events = []
        self._numbers = itertools.count()
        self.ready = collections.deque()
        self._turn = threading.Lock()
        self._turn.acquire()
        self._turns = 0
        self.fds = itertools.count(FIRST_FD)
        self.pids = itertools.count(1)
        self.executables = {}  # {word: function(host, *words), which starts a Program}

    def tell(self, line):
        """Add a line to the story."""
        self.story.append((self.time, line))

    def host(self, name, address):
        made = self.hosts[name] = Host(self, name, address)
        return made

    def host_at(self, address):
        for host in self.hosts.values():
            if address in (host.address, host.other_address):
                return host
        return None

    # ---- time ----

    def at(self, seconds, function, *args):
        """Call function(*args) after this time (seconds)."""
        heapq.heappush(self._events, (self.time + seconds, next(self._numbers), function, args))

    def run(self, until, is_over=lambda: False):
        """Let things happen until a time, or until is_over()."""
        while not is_over():
            if self.ready:
                self._turns += 1
                if self._turns > MOST_AT_ONCE:
                    raise Stuck(f"{self.ready[0].name} never waits")
                program = self.ready.popleft()
                program.take_turn()
                if program.vain > MOST_VAIN:
                    raise Stuck(f"{program.name} finds something to do again and again, and does not do it")
                continue
            if not self._events or self._events[0][0] > until:
                self.time = max(self.time, until)
                return
            when, _, function, args = heapq.heappop(self._events)
            if when > self.time:
                self._turns = 0
            self.time = max(self.time, when)
            function(*args)

    def give_back(self):
        """Let the world go on; called on the thread of a program."""
        self._turn.release()

    def wait_for_turn(self):
        self._turn.acquire()

    def end(self):
        """End all programs, and their threads."""
        for program in list(self.programs):
            program.kill()

    # ---- the network ----

    def latency(self, one, other):
        if one is other:
            return 2e-5 + self.random.random() * 2e-5
        more = self.delays.get(one.name, 0) + self.delays.get(other.name, 0)
        return 2e-4 + self.random.random() * 2e-4 + more

    def verdict(self, one, other, port, size):
        """What happens to a packet of so many octets, or BEGIN_OF_ONE of a connection, to a port: None, DROP,
        REJECT.
        """
        if one is not other and not (one.is_on and other.is_on):
            return DROP
        for rule in self.rules:
            found = rule(one, other, port, size)
            if found:
                return found
        return None


BEGIN_OF_ONE = 0
ACKNOWLEDGED = 1  # octets of a packet without any
DROP = "drop"
REJECT = "reject"


class Host:
    """A computer with one address: `listeners` by port; `is_on`. Its name may lead to an `other_address` at
    which nobody listens, too. `has_doubts`: of its look-ups of names, every other one takes long.
    """

    def __init__(self, world, name, address):
        self.world = world
        self.name = name
        self.address = address
        self.listeners = {}  # {port, or path of a UNIX socket: Socket}
        self.disk = disks.Disk(self)
        self.mounts = {}  # {directory: fuse.Mount}
        self.mount_changes = 0
        self.is_on = True
        self.ahead = 0.0  # seconds by which its clock is ahead
        self.other_address = None
        self.has_doubts = False
        self._looked_up = 0
        self._port = 40000 + 2000 * len(world.hosts)  # a firewall knows a port by its number

    def free_port(self):
        self._port += 1
        return self._port

    def look_up(self, name):
        """The addresses of a host. Raises Blocked."""
        self._looked_up += 1
        if self.has_doubts and not self._looked_up % 2:
            raise Blocked
        found = self.world.hosts[name]
        return [each for each in (found.other_address, found.address) if each]

    def lose_power(self):
        """All its programs end at once, and what is not on its disk is lost."""
        self.is_on = False
        for program in [each for each in self.world.programs if each.host is self]:
            sockets = list(program.sockets.values())
            program.kill()
            for each in sockets:
                each.say_no_more()
        self.disk.lose_power()


class Program:
    """A process on a host: it runs main(), on a thread of its own, and is an object like net/real.py for it.

    status  what main() has returned, None before
    """

    NoSuchHost = _socket.gaierror
    FUSE = os.curdir  # which is there

    def __init__(self, host, name, main, argv=(), environment=None, output=None):
        """`output`: the class of stdout and stderr; Output, or Terminal."""
        output = output or Output
        self.host = host
        self.world = host.world
        self.name = name
        self.argv = [name, *argv]
        self.environment = environment or {}
        self.sockets = {}  # by file descriptor
        self._free = []  # descriptors of sockets that are closed
        self.polls = []  # Polls of its loops
        self.looking_up = {}
        self.is_ending = False  # by a signal: what it has asked it gives up, and takes back what it has lent
        self.most_asked = {}  # {name of a program: how many requests it had to answer for us at a time}
        self.most_waiting = {}  # the same of those that may wait for others
        # all others are to be answered by it alone
        self.silences = {}  # {name: the longest time, in seconds, in which it has answered none of them}
        self.unheard = {}  # {name: when it was asked the first of them since it has answered}
        self.vain = 0  # polls that have found something, since something was done with a socket
        self.status = None
        self.is_over = False
        self.has_crashed = False
        self.is_stopped = False
        self.stops = []  # [[from, until or None]]
        self.begun = self.world.time
        self.ended = None  # when
        self.out = output()
        self.error = output()
        self.loop = None
        self.failure = None  # what main() has raised
        self.lag = 0.0  # seconds that its answers take longer
        self.spoil = None  # function(octets) that spoils its answers
        self.closes_often = False  # whether it closes connections that have been used
        self.strikes = None  # function(socket, octets) of what comes; True where nobody is to read it
        self.at_end = None  # function, called when it ends
        # of one that another has started, and of one that has started others
        self.group = None  # the process group, but of those that people start
        self.ignores = ()  # signals
        self.killed_by = real.SIGKILL  # where it has no status
        self.forked = None  # the process that it has started last
        self.ended_children = []  # (pid, status as of os.waitpid) of those that nobody has asked for
        self.hears_of_children = False
        self._main = main
        self._is_killed = False
        self._is_ready = False
        self._waits = 0
        self._left_out = set()
        self.pid = next(self.world.pids)
        self._settings = (False, False)
        self._listener = notes.listener
        self._turn = threading.Lock()
        self._turn.acquire()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()
        self.world.programs.append(self)
        self.wake()

    # ---- turns ----

    def wake(self):
        """It has something to do."""
        if not (self._is_ready or self.is_stopped or self.is_over):
            self._is_ready = True
            self.world.ready.append(self)

    def _wake_from(self, wait):
        """The time of a wait has passed, which may be over."""
        if wait == self._waits:
            self.wake()

    def take_turn(self):
        """Let it run until it waits, or ends."""
        self._is_ready = False
        if self.is_over or self.is_stopped and not self._is_killed:
            return
        before = sys.stdout, sys.stderr, sys.argv, os.environ, cli._quiet, cli._verbose, notes._left_out
        listener = notes.listener
        sys.stdout, sys.stderr, sys.argv, os.environ = self.out, self.error, self.argv, self.environment
        cli._quiet, cli._verbose = self._settings
        notes._left_out = self._left_out
        notes.listener = self._listener
        self._turn.release()
        self.world.wait_for_turn()
        self._settings = cli._quiet, cli._verbose
        self._listener = notes.listener
        notes.listener = listener
        self.argv = sys.argv  # rtsh has another for each command
        sys.stdout, sys.stderr, sys.argv, os.environ, cli._quiet, cli._verbose, notes._left_out = before

    def _run(self):
        self._turn.acquire()
        loop.inhabit(self)
        try:
            self.status = self._main()
        except Killed:
            pass
        except BaseException as e:
            self.note_failure(e)
        finally:
            self._is_killed = True
            self.is_over = True
            self.ended = self.world.time
            for name in list(self.unheard):
                self.hear(name)
            self.close_all()
            if self.at_end is not None:
                self.at_end()
            if self in self.world.programs:
                self.world.programs.remove(self)
            self.world.give_back()

    def wait(self, seconds):
        """Wait until it is woken, or a time has passed; on its own thread."""
        if self._is_killed:
            raise Killed
        self._waits += 1
        self.world.at(seconds, self._wake_from, self._waits)
        self.world.give_back()
        self._turn.acquire()
        if self._is_killed:
            raise Killed

    def compute(self, seconds):
        """Do nothing else for a time; on its own thread."""
        done = self.world.time + seconds
        while self.world.time < done:
            self.wait(done - self.world.time)

    def hear(self, name):
        """A program of this name has answered it, or does so no more."""
        if name in self.unheard:
            _raise_to(self.silences, name, self.world.time - self.unheard.pop(name))

    # ---- what is done to it ----

    def note_failure(self, exception):
        """It has raised what it should not; that it is killed may show as anything, where it cleans up."""
        if not self._is_killed:
            self.failure = exception

    def kill(self):
        """SIGKILL."""
        if self.is_over:
            return
        self._is_killed = True
        self.is_stopped = False
        self.close_all()
        self._is_ready = False
        self.take_turn()

    def die(self):
        """It crashes, as soon as it waits."""
        self.has_crashed = True
        self._is_killed = True
        self.close_all()

    def stop(self):
        """SIGSTOP: the kernel of its host goes on."""
        self.is_stopped = True
        self.stops.append([self.world.time, None])

    def go_on(self):
        """SIGCONT."""
        self.is_stopped = False
        self.stops[-1][1] = self.world.time
        self.wake()

    def strike(self, number):
        """A signal that it hears."""
        if self.loop is not None and not self.is_over:
            self.is_ending = self.is_ending or number in (signal.SIGINT, signal.SIGTERM)
            self.loop.strike(number)
            self.wake()

    def close_all(self):
        for each in list(self.sockets.values()):
            each.close()

    # ---- what net/real.py has ----

    def now(self):
        return FIRST + self.world.time

    def wall(self):
        return BEGIN + self.world.time + self.host.ahead

    def handler(self, number):
        return real.DEFAULT

    def handle(self, number, handler):
        """What comes is struck; see `strike`."""

    def own_pid(self):
        return self.pid

    def own_user(self):
        return 0

    def mounts(self):
        return fuse.Table(self)

    def open_fuse(self):
        return fuse.Device(self).fd

    def system_call(self, name, *args):
        fuse.CALLS[name](self.host, *args)

    def read_into(self, descriptor, buffer):
        return self.sockets[descriptor].read_into(buffer)

    def write_to(self, descriptor, data):
        self.sockets[descriptor].write_to(data)

    def takes(self, descriptor):
        """Whether what reads it is not slow."""
        return True

    def lock(self, directory):
        """Nobody waits for it."""

    def start_process(self, words, **more):
        if "preexec_fn" in more:
            return children.start(self, words, more["preexec_fn"])
        return Child()

    @property
    def children(self):
        return children.Children(self)

    def local(self):
        return LocalSocket(self)

    def tell(self, place, data):
        """Nobody has a NOTIFY_SOCKET."""

    def file(self, descriptor, mode, buffering=-1):
        return self.host.disk.file(descriptor, mode, buffering)

    def sync(self, descriptor):
        self.host.disk.sync(descriptor)

    def replace(self, path, target):
        self.host.disk.replace(path, target)

    def octets(self, number):
        return bytes(self.world.random.randrange(256) for _ in range(number))

    def poll(self):
        poll = Poll(self)
        self.polls.append(poll)
        return poll

    def descriptor(self):
        """The number of a new socket: the one that was closed last, if any was."""
        if self._free:
            return self._free.pop()
        return next(self.world.fds)

    def forget(self, descriptor):
        """A socket is closed: it is watched no more, and another one may get its number."""
        self.sockets.pop(descriptor, None)
        for poll in self.polls:
            poll.forget(descriptor)
        self._free.append(descriptor)

    def start_thread(self, function, *args):
        here = loop.current()
        self.world.at(self.world.latency(self.host, self.host), self._post, here, function, args)

    def _post(self, here, function, args):
        if not self.is_over:
            here.post(self._do, here, function, args)
            self.wake()

    def _do(self, here, function, args):
        """What a function does on a thread; later, where it waits for a look-up."""
        try:
            if function is loop._end_with:  # which would take it for its end
                wait, function, args = args
                value, error = loop._outcome(function, args)
                if isinstance(error, Blocked):
                    function, args = loop._end_with, (wait, function, args)
                    raise error
                wait.end(value, error)
            else:
                function(*args)
        except Blocked:
            self.world.at(LOOK_UP, self._post, here, function, args)

    def stream(self, family, protocol=0):
        return Socket(self)

    def listen(self, family, place, only_v6=True):
        made = Socket(self)
        made.listen_at(place[1])
        return made

    def bind(self, host, port):
        if port in self.host.listeners:
            raise OSError(errno.EADDRINUSE, os.strerror(errno.EADDRINUSE))

    def unacknowledged(self, connection):
        return connection.unacknowledged()

    def resolve(self, host, port=None, family=0, flags=0):
        if isinstance(host, bytes):
            host = host.decode()
        if host is None:
            found = ["0.0.0.0"]
        elif host == "localhost":
            found = [LOOPBACK]
        elif not host.strip("0123456789."):
            found = [host]
        elif host in self.world.hosts and not flags:
            found = self.host.look_up(host)
        else:
            raise self.NoSuchHost(_socket.EAI_NONAME, "Name or service not known")
        return [(_socket.AF_INET, _socket.SOCK_STREAM, 6, "", (each, port or 0)) for each in found]

    def scheduled(self):
        """Nobody waits for a processor."""
        return 0.0, 0.0

    def host_name(self):
        return self.host.name

    def is_own(self, address):
        return address in (LOOPBACK, self.host.address, self.host.other_address)

    def own_address(self, host, port):
        *_, (address, _) = self.resolve(host)[-1]
        if address == LOOPBACK:
            return LOOPBACK
        return self.host.address

    def interfaces(self):
        return [("lo", LOOPBACK, "255.0.0.0"), ("eth0", self.host.address, "255.255.255.0")]


class Output(io.TextIOWrapper):
    """stdout or stderr of a program: a file without a name, which nobody is slow to read."""

    def __init__(self):
        file = tempfile.TemporaryFile()
        super().__init__(file, "utf-8", "backslashreplace", newline="\n", write_through=True)

    def text(self):
        """All that was printed; it is the end of the file."""
        self.flush()
        os.lseek(self.fileno(), 0, os.SEEK_SET)
        with open(os.dup(self.fileno()), encoding="utf-8", errors="backslashreplace", newline="") as file:
            return file.read()


class Terminal(Output):
    """A terminal, which only shows what is written to it."""

    def isatty(self):
        return True


def _check_terminal():
    """Raises OSError if the program that runs now is not on a Terminal."""
    if not isinstance(sys.stderr, Terminal):
        raise OSError(errno.ENOTTY, os.strerror(errno.ENOTTY))


def _terminal_size(descriptor):
    _check_terminal()
    return os.terminal_size((80, 24))


def _terminal_group(descriptor):
    _check_terminal()
    return os.getpgrp()


os.get_terminal_size = _terminal_size
os.tcgetpgrp = _terminal_group


class Child:
    """A process that a program has started; it ends at once."""

    returncode = 0

    def poll(self):
        return self.returncode


class Poll:
    """As net/real.py has it, of the sockets of a program."""

    def __init__(self, program):
        self._program = program
        self._watched = {}
        program.loop = loop.current() or program.loop

    def register(self, fd, events):
        self._watched[fd] = events

    def unregister(self, fd):
        self._watched.pop(fd, None)

    def forget(self, fd):
        self._watched.pop(fd, None)

    def poll(self, milliseconds):
        program = self._program
        program.loop = loop.current() or program.loop
        found = self._ready()
        program.vain = program.vain + 1 if found else 0
        if found or milliseconds <= 0:
            program.wait(BUSY)
            return found or self._ready()
        program.wait(milliseconds / 1000)
        return self._ready()

    def _ready(self):
        found = []
        sockets = self._program.sockets
        for fd, events in self._watched.items():
            if fd in sockets:
                come = sockets[fd].events(events)
                if come:
                    found.append((fd, come))
        return found


class Scan:
    """The GIOP messages in a stream of octets."""

    def __init__(self):
        self._head = b""
        self._rest = 0  # octets to come of the message that has begun

    def messages(self, data):
        """[(kind, number of the request, the first octets of its body)] of those that begin in it."""
        found = []
        at = 0
        while at < len(data):
            if self._rest:
                taken = min(self._rest, len(data) - at)
                self._rest -= taken
                at += taken
                continue
            taken = HEADER - len(self._head)
            self._head += data[at : at + taken]
            at += taken
            if len(self._head) == HEADER:
                order = "little" if self._head[6] & 1 else "big"
                self._rest = int.from_bytes(self._head[8:], order)
                body = data[at : at + min(self._rest, BODY)]
                found.append((self._head[7], int.from_bytes(body[:4], order), body))
                self._head = b""
        return found


def _raise_to(most, name, number):
    most[name] = max(most.get(name, 0), number)


class Socket:
    """A socket of TCP of a program."""

    def __init__(self, program):
        self.program = program
        self.world = program.world
        self.host = program.host
        self.fd = program.descriptor()
        program.sockets[self.fd] = self
        self.peer = None  # the Socket at the other end
        self.address = None  # of the other end, (address, port)
        self.port = None
        self.incoming = bytearray()
        self.is_at_end = False  # the other end sends no more
        self.error = 0
        self.backlog = None  # connections that wait to be accepted, of one that listens
        self.is_connected = False
        self.is_of_client = False
        self.is_closed = False
        self.is_abrupt = False  # its end is RST
        self._under_way = 0  # octets that have been sent, and have not arrived
        self._sent = collections.deque()  # (when it arrives, function, arguments), the oldest first
        self._is_repeating = False  # what was lost is sent again
        self.scan = Scan()
        self.asked = 0  # GIOP requests that have been sent here, and not been answered
        self.has_answered = False
        self.is_closing = False  # it takes no more requests
        self.waiting = set()  # those of them that may wait for other processes, by their numbers

    # ---- as _socket.socket ----

    def fileno(self):
        return -1 if self.is_closed else self.fd

    def setblocking(self, flag):
        pass

    def setsockopt(self, level, option, value):
        self.is_abrupt = self.is_abrupt or option == _socket.SO_LINGER

    def getsockopt(self, level, option):
        code = self.error
        self.error = 0
        return code

    def getsockname(self):
        return self.host.address, self.port

    def connect_ex(self, place):
        address, port = place
        self.program.vain = 0
        self.address = place
        self.port = self.host.free_port()
        self.is_of_client = True
        if self.program.is_own(address):
            other = self.host
        else:
            other = self.world.host_at(address)
        if other is None:
            return errno.ENETUNREACH
        if address == other.other_address:
            port = NOBODY
        self._try(other, port, AGAIN, GIVEN_UP)
        return errno.EINPROGRESS

    def listen_at(self, port):
        if port in self.host.listeners:
            self.close()
            raise OSError(errno.EADDRINUSE, os.strerror(errno.EADDRINUSE))
        self.port = port or self.host.free_port()
        self.host.listeners[self.port] = self
        self.backlog = collections.deque()

    def accept(self):
        if not self.backlog:
            raise BlockingIOError(errno.EAGAIN, "nobody")
        made = self.backlog.popleft()
        self.program.vain = 0
        return made, made.address

    def send(self, data, flags=0):
        self._check()
        if self.error:
            raise OSError(self.error, os.strerror(self.error))
        room = ROOM - self._under_way - len(self.peer.incoming)
        if room <= 0:
            raise BlockingIOError(errno.EAGAIN, "full")
        self.program.vain = 0
        data = bytes(data[:room])
        self._count(data)
        if self.program.spoil is not None and not self.is_of_client:
            data = self.program.spoil(data)
            if not data:  # it breaks off
                self.close()
                raise OSError(errno.ECONNRESET, os.strerror(errno.ECONNRESET))
        self._under_way += len(data)
        self._travel(self.peer.take, data)
        return len(data)

    def sendall(self, data):
        self.send(data)

    def recv(self, most, flags=0):
        self._check()
        if self.incoming:
            data = bytes(self.incoming[:most])
            if not flags & _socket.MSG_PEEK:
                self.program.vain = 0
                del self.incoming[:most]
                if self.peer is not None:
                    self.peer.program.wake()
            return data
        if self.error:
            raise OSError(self.error, os.strerror(self.error))
        if self.is_at_end:
            return b""
        raise BlockingIOError(errno.EAGAIN, "nothing")

    def recv_into(self, buffer):
        data = self.recv(len(buffer))
        buffer[: len(data)] = data
        return len(data)

    def shutdown(self, how):
        self._check()
        self._travel(self.peer.come_to_end)

    def close(self):
        if self.is_closed:
            return
        self.is_closed = True
        self.program.vain = 0
        self.program.forget(self.fd)
        if self.backlog is not None:
            if self.host.listeners.get(self.port) is self:
                del self.host.listeners[self.port]
            for each in self.backlog:
                each.close()
        elif self.peer is not None:
            is_abrupt = self.is_abrupt or self.incoming
            self._travel(self.peer.break_off if is_abrupt else self.peer.come_to_end)

    # ---- what its kernel does ----

    def say_no_more(self):
        """Its host has no power: what was to be sent is lost, as is the news that it is closed."""
        self._sent.clear()

    def events(self, wanted):
        """Those of the wanted events that a poll finds."""
        found = 0
        if wanted & loop.READ and (self.backlog or self.incoming or self.is_at_end or self.error):
            found = loop.READ
        if wanted & loop.WRITE and (self.error or self._has_room()):
            found |= loop.WRITE
        return found

    def _has_room(self):
        return self.is_connected and len(self.peer.incoming) + self._under_way < ROOM

    def unacknowledged(self):
        return self._under_way

    def _check(self):
        if self.is_closed:
            raise OSError(errno.EBADF, os.strerror(errno.EBADF))
        if self.peer is None and not self.error:
            raise OSError(errno.ENOTCONN, os.strerror(errno.ENOTCONN))

    def _try(self, other, port, pause, left):
        """Ask a host for a connection, again and again while nothing answers."""
        if self.is_closed:
            return
        verdict = self.world.verdict(self.host, other, port, BEGIN_OF_ONE)
        if verdict is None:  # what answers may be lost
            verdict = self.world.verdict(other, self.host, self.port, ACKNOWLEDGED)
        there_and_back = 2 * self.world.latency(self.host, other)
        if verdict == DROP:
            if left <= 0:
                self._fail(errno.ETIMEDOUT)
            else:
                self.world.at(pause, self._try, other, port, min(2 * pause, LONGEST_AGAIN), left - pause)
        elif verdict == REJECT:
            self.world.at(there_and_back, self._fail, errno.ECONNREFUSED)
        else:
            self.world.at(there_and_back, self._arrive, other, port)

    def _arrive(self, other, port):
        if self.is_closed:
            return
        listener = other.listeners.get(port)
        if listener is None:
            return self._fail(errno.ECONNREFUSED)
        theirs = type(self)(listener.program)
        theirs.peer = self
        theirs.is_connected = True
        theirs.port = port
        theirs.address = (self.host.address, self.port)
        self.peer = theirs
        self.is_connected = True
        listener.backlog.append(theirs)
        listener.program.wake()
        self.program.wake()

    def _fail(self, code):
        self.error = code
        self.program.wake()

    def _travel(self, function, *args):
        """Have something arrive at the other end, after what was sent before."""
        pause = self.world.latency(self.host, self.peer.host)
        if not self.is_of_client:
            pause += self.program.lag
        arrives = self.world.time + pause
        if self._sent:
            arrives = max(arrives, self._sent[-1][0])
        self._sent.append((arrives, function, args))
        self.world.at(arrives - self.world.time, self._deliver)

    def _deliver(self):
        if not self._is_repeating:
            self._repeat(AGAIN)

    def _repeat(self, pause):
        """Have all arrive that should have; again after a pause while it is lost."""
        self._is_repeating = False
        while self._sent and self._sent[0][0] <= self.world.time:
            _, _, args = self._sent[0]
            size = len(args[0]) if args else ACKNOWLEDGED
            if self.world.verdict(self.host, self.peer.host, self.served_port(), size) == DROP:
                if self.world.time - self._sent[0][0] > GIVEN_UP:
                    self._sent.clear()
                    return self._fail(errno.ETIMEDOUT)
                self._is_repeating = True
                self.world.at(pause, self._repeat, min(2 * pause, LONGEST_AGAIN))
                return
            _, function, args = self._sent.popleft()
            function(*args)

    def served_port(self):
        """The port of the end that has listened."""
        return self.peer.port if self.is_of_client else self.port

    def _count(self, data):
        """Count GIOP requests and replies that are sent."""
        for kind, number, head in self.scan.messages(data):
            if kind == REQUEST and self.is_of_client:
                self.asked += 1
                name = self.peer.program.name
                if any(operation in head for operation in ASKING_OTHERS):
                    self.waiting.add(number)
                else:
                    self.program.unheard.setdefault(name, self.world.time)
                if self.program.is_ending:
                    continue
                there = [each for each in self.program.sockets.values() if each.address == self.address]
                _raise_to(self.program.most_asked, name, sum(each.asked for each in there))
                _raise_to(self.program.most_waiting, name, sum(len(each.waiting) for each in there))
            elif kind == REPLY and not self.is_of_client:
                self.has_answered = True
                self.peer.asked -= 1
                self.peer.waiting.discard(number)
                self.peer.program.hear(self.program.name)

    def take(self, data):
        """Octets have arrived."""
        self.peer._under_way -= len(data)
        if self.is_closed:
            if not self.peer.is_closed:
                self._travel(self.peer.break_off)
            return
        if self.is_closing:
            return
        if self.program.strikes is not None and self.program.strikes(self, data):
            return
        if self.program.closes_often and self._closes(data):
            self.is_closing = True
            try:
                self.send(CLOSE)
            except ConnectionResetError:
                pass  # the other side has gone meanwhile
            return self.come_to_end()
        self.incoming += data
        self.program.wake()

    def _closes(self, data):
        """Whether it closes instead of beginning what it is asked, with nothing else to do for this peer."""
        begins = [kind for kind, *_ in Scan().messages(data)]
        if not self.has_answered or self.incoming or begins != [REQUEST] * self.peer.asked:
            return False
        return self.world.random.random() < OFTEN

    def come_to_end(self):
        self.is_at_end = True
        self.program.wake()

    def break_off(self):
        """RST."""
        if not self.is_closed:
            self._fail(errno.ECONNRESET)


class LocalSocket(Socket):
    """A UNIX socket of a program; its `port` is its path."""

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def bind(self, path):
        with open(path, "x"):
            self.port = path

    def listen(self, backlog):
        self.backlog = collections.deque()
        self.host.listeners[self.port] = self

    def connect(self, path):
        self.is_of_client = True
        if path not in self.host.listeners or not os.path.exists(path):
            raise ConnectionRefusedError(errno.ECONNREFUSED, os.strerror(errno.ECONNREFUSED))
        self._arrive(self.host, path)
