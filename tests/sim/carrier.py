"""What carries the behaviour of mock_components in the bottle, with the names of mock_components/carrier.py:
simulated programs, their time, and our own ORB.

What a mock does runs on a Strand: a task of its program's loop that is no coroutine but has a thread, so that
it may wait within any function. A call that it receives is answered at once if it waits for nothing.
"""

import functools
import sys
import threading
import types

import mock_components
import world as worlds

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.corba.iiop import client
from rtshell_lite.giop import cdr, descriptors, idl, ior, marshal as values, references, requests
from rtshell_lite.net import loop

PID = 1
TICK = 1e-4  # seconds that a wait takes at least: time would stand still
_FACTORIES = (descriptors.STRUCT, descriptors.UNION)


# ---- strands ----


class Worker:
    """A thread that runs Strands of any program, one at a time, while who lets it run waits."""

    idle = []  # type: list

    def __init__(self):
        self._mine = threading.Lock()
        self._others = threading.Lock()
        self._mine.acquire()
        self._others.acquire()
        self.strand = None
        threading.Thread(target=self._run, daemon=True).start()

    def run(self):
        """Let it run until its strand waits or ends; called by others."""
        self._mine.release()
        self._others.acquire()

    def give_back(self):
        """Let who has called `run` go on, and wait for the next; called by its strand."""
        self._others.release()
        self._mine.acquire()

    def _run(self):
        self._mine.acquire()
        while True:
            strand = self.strand
            loop.inhabit(strand.program)
            loop._here.loop = strand.loop
            _here.strand = strand
            strand.do()
            self.strand = strand = None
            self.idle.append(self)
            self.give_back()


class Here(threading.local):
    """What is of a thread."""

    strand = None


_here = Here()


class Strand(loop.Task):
    """A function that runs as a Task of a program, and ends with it: `result`, `error`; `over` is a Wait for
    its end.
    """

    def __init__(self, process, function, *args):
        self.process = process
        self.program = process.program
        self.function = function
        self.args = args
        self.own = {}  # what Locals hold
        self.over = None
        self.loop = process.loop
        self.coroutine = self.group = self.place = self.awaited = self.thrown = None
        self.result = self.error = None
        self.is_over = False
        self._worker = None

    def begin(self):
        """Have the loop run it."""
        self.loop.ready.append(self)

    def go_on(self):
        """Let it run until it waits or ends; called on the thread of its program."""
        if self._worker is None:
            self._worker = Worker.idle.pop() if Worker.idle else Worker()
            self._worker.strand = self
            self.process.strands[self] = True
        before = self.loop.running
        self.loop.running = self
        self._worker.run()
        self.loop.running = before

    def do(self):
        """What its Worker runs."""
        try:
            self.result = self.function(*self.args)
        except worlds.Killed:
            self.error = failure("COMM_FAILURE")  # nobody hears of it
        except Raised as e:
            self.error = e
        except Exception as e:
            self.process.program.note_failure(e)
            self.error = failure("UNKNOWN")
        self.is_over = True
        self.process.strands.pop(self, None)
        if self.over is not None:
            self.over.done()

    def wait_for(self, coroutine):
        """The result of a coroutine; called on its own thread."""
        send = functools.partial(coroutine.send, None)
        while True:
            try:
                awaited = send()
            except StopIteration as end:
                return end.value
            awaited.task = self
            self.awaited = awaited
            self._worker.give_back()
            if self.process.is_ended:
                coroutine.close()
                raise worlds.Killed
            exception = self.thrown
            self.thrown = None
            send = functools.partial(coroutine.send, None)
            if exception is not None:
                send = functools.partial(coroutine.throw, exception)


def await_it(coroutine):
    """The result of a coroutine, for which this strand waits."""
    return _here.strand.wait_for(coroutine)


# ---- time and threads ----

now = loop.now
wall = loop.wall


def sleep(seconds):
    await_it(loop.sleep(max(seconds, TICK)))


class Lock:
    """Strands change places only where they wait, so there is nothing to lock."""

    def __enter__(self):
        return self

    def __exit__(self, *exception):
        pass


class Condition(Lock):
    """As threading.Condition."""

    def __init__(self):
        self._waits = []

    def wait_for(self, is_so, seconds=None):
        end = seconds is not None and now() + max(seconds, TICK)
        while not is_so():
            left = loop.FOREVER if seconds is None else end - now()
            if left <= 0:
                return is_so()
            await_it(self._wait(left))
        return True

    async def _wait(self, seconds):
        wait = loop.Wait()
        self._waits.append(wait)
        timer = loop.current().call_later(seconds, wait.done)
        await wait
        timer.cancel()

    def notify_all(self):
        for wait in self._waits:
            wait.done()
        self._waits = []


class Event(Condition):
    """As threading.Event."""

    _is_set = False

    def set(self):
        self._is_set = True
        self.notify_all()

    def is_set(self):
        return self._is_set

    def wait(self, seconds=None):
        return self.wait_for(self.is_set, seconds)


class Local:
    """As threading.local."""

    def __getattr__(self, name):
        try:
            return _here.strand.own[self, name]
        except KeyError:
            raise AttributeError(name)

    def __setattr__(self, name, value):
        _here.strand.own[self, name] = value


def die():
    """End the process at once, as a crash does."""
    _here.strand.process.die()


def unique_id(by_time):
    digits = loop.world().octets(16).hex()
    return "-".join((digits[:8], digits[8:12], digits[12:16], digits[16:20], digits[20:]))


# ---- exceptions ----


class Raised(requests.Thrown):
    """Whatever a call raises."""


class SystemException(Raised):
    pass


class Garbled(SystemException):
    pass


class UserException(Raised):
    name = None  # type: str

    def __init__(self, *members):
        super().__init__(self.name, *members)


FAILURES = (
    "BAD_OPERATION",
    "BAD_PARAM",
    "COMM_FAILURE",
    "MARSHAL",
    "NO_IMPLEMENT",
    "NO_PERMISSION",
    "OBJECT_NOT_EXIST",
    "TIMEOUT",
    "TRANSIENT",
    "UNKNOWN",
)
_NAMES = [
    (errors.Silent, "TIMEOUT"),
    (errors.Gone, "OBJECT_NOT_EXIST"),
    (errors.ConnectionLost, "COMM_FAILURE"),
]
_users = {}  # type: dict  # {last part of its name: class} of the exceptions of the IDL


def failure(name, minor=0, may_be_done=True):
    """The system exception of that name."""
    if name not in FAILURES:
        raise AttributeError(name)
    return SystemException(name)


def _raised(error):
    """What a mock catches in place of an errors.Error."""
    name = getattr(error, "name", "")
    if name in _users:
        return _users[name]()
    for kind, word in _NAMES:
        if isinstance(error, kind):
            return failure(word)
    return failure(name if name in FAILURES else "TRANSIENT")


# ---- types and values ----


class Any:
    """A value with the descriptor of its type, as omniORB has it; one that is a text is written as that."""

    def __init__(self, descriptor, content):
        self._descriptor = descriptor
        self._content = content

    def typecode(self):
        return self._descriptor

    def value(self):
        return self._content


class NameValue:
    """Of a list of properties: a name, and an Any."""

    def __init__(self, name, value):
        self.name = name
        self.value = value

    def __iter__(self):
        """As our own ORB writes and reads it: octets."""
        return iter((self.name.encode("latin-1"), self.value.value().encode("latin-1")))


TEXT = values.TEXT
REFERENCE = (descriptors.OBJECT, "IDL:omg.org/CORBA/Object:1.0", "Object")
NULL = 0


def typecode(descriptor):
    return descriptor


def to_any(value):
    """What can be sent in a list of properties by our own ORB, which writes texts there."""
    return Any(TEXT, str(value))


def is_of(value, kind):
    return descriptors.kind(value.typecode()) == descriptors.kind(kind)


_codec = functools.lru_cache(maxsize=None)(cdr.codec)


def marshal(descriptor, value, little):
    out = bytearray()
    _codec(descriptor, bool(little))[1](out, value)
    return bytes(out)


def unmarshal(descriptor, data, little):
    try:
        return _codec(descriptor, bool(little))[0](data, 0)[0]
    except (ValueError, cdr.struct.error, IndexError):
        raise Garbled("MARSHAL")


def contents(scope):
    """As corba/stubs.contents."""
    found = {}
    for type_id in [each for each in (*idl.TYPES, *idl.INTERFACES) if each.startswith(scope)]:
        descriptor = idl.descriptor(type_id)
        name = idl.name(type_id)
        kind = descriptors.kind(descriptor)
        found["_tc_" + name] = descriptor
        if kind == descriptors.ENUM:
            found.update((item._n, item) for item in descriptors.items(descriptor))
        elif kind == descriptors.EXCEPTION:
            found[name] = _users[name] = type(name, (UserException,), {"name": _dotted(type_id)})
        elif kind == descriptors.OBJECT:
            found[name] = type(name, (), {"_NP_RepositoryId": type_id})
        elif kind in _FACTORIES:
            found[name] = descriptors.factory(descriptor)
    if scope == "IDL:org.omg/SDOPackage/":
        found["NameValue"] = NameValue
    return found


def _dotted(type_id):
    """SDOPackage.InternalError of IDL:org.omg/SDOPackage/InternalError:1.0."""
    return ".".join(part for part in type_id.split(":")[1].split("/") if "." not in part)


def _taken(value):
    """What has come, as mocks take it: references that can be called, properties with names."""
    kind = type(value)
    if kind is references.Reference:
        return Remote(value)
    if kind is list and value:
        if type(value[0]) is tuple:
            return [NameValue(name.decode("latin-1"), _any(content)) for name, content in value]
        return [_taken(each) for each in value]
    if kind is tuple:
        return tuple(map(_taken, value))
    if isinstance(value, descriptors.Struct):
        for name, member in list(vars(value).items()):
            setattr(value, name, _taken(member))
    return value


def _any(content):
    if type(content) is bytes:
        return Any(TEXT, content.decode("latin-1"))
    return Any(content.descriptor, _taken(content.content))


# ---- references and servants ----


class Remote(references.Reference):
    """A reference with a method for each operation, which waits for the answer."""

    __slots__ = ("seconds",)

    def __init__(self, reference, interface=None):
        type_id = reference.type_id.decode("latin-1")
        if interface is None:
            interface = type_id if type_id in idl.INTERFACES else reference.interface
        super().__init__(reference.type_id, reference.profiles, interface)
        self.seconds = None

    def __getattr__(self, operation):
        if operation != "_non_existent":
            try:
                idl.operation(self.interface, operation)
            except KeyError:
                raise AttributeError(operation)
        return functools.partial(_ask, self, operation)

    def _is_equivalent(self, other):
        return other is not None and orb.same(self, other)

    def _unchecked_narrow(self, kind):
        return Remote(self, kind._NP_RepositoryId)

    _narrow = _unchecked_narrow  # on trust


def _ask(reference, operation, *args):
    own = orb.own_servant(reference)
    if own is not None and operation[0] != "_":
        return getattr(own.servant, operation)(*args)
    call = orb.call(orb.at_address(reference), reference, operation, *args)
    if reference.seconds is not None:
        call = loop.within(reference.seconds, call, errors.Silent("", ""))
    try:
        return _taken(await_it(call))
    except errors.Error as e:
        raise _raised(e)


def set_timeout(reference, milliseconds):
    reference.seconds = milliseconds / 1000


def skeleton(name):
    return type(name, (), {"_NP_RepositoryId": idl.id_of(name)})


def servant(type_id, operations):
    """A class of servants. Its interface is known to all in the world, as if they had its IDL."""
    described = {}
    for name, (given, returned) in operations.items():
        described[name] = given, returned, (), " ".join(f"arg{number}" for number in range(len(given)))
    idl.INTERFACES.setdefault(type_id, ((), described))
    return type("Servant", (), {"_NP_RepositoryId": type_id})


class Served:
    """What the ORB calls in place of a servant: each operation on a Strand."""

    def __init__(self, process, servant, owner, exists):
        self.process = process
        self.servant = servant
        self.interface = _dotted(servant._NP_RepositoryId)
        self.owner = owner
        self.exists = exists
        self.reference = None

    def __getattr__(self, operation):
        return functools.partial(self._call, operation)

    def _call(self, operation, *args):
        strand = Strand(self.process, self._answer, operation, args)
        strand.go_on()
        if strand.is_over:
            return _outcome(strand)
        strand.over = loop.Wait()
        return _later(strand)

    def _answer(self, operation, args):
        if not self.exists():
            raise failure("OBJECT_NOT_EXIST")
        ledger = self.process.ledger
        suffer = ledger.begin(self.owner, operation)
        try:
            if suffer is not None:
                suffer()
            return getattr(self.servant, operation)(*map(_taken, args))
        finally:
            ledger.end()


def _outcome(strand):
    if strand.error is not None:
        raise strand.error
    return strand.result


async def _later(strand):
    await strand.over
    return _outcome(strand)


class Process:
    """As mock_components/process.py has it: the objects of a Program."""

    def __init__(self, program):
        from mock_components import counting

        self.program = program
        self.host = None
        self.loop = None
        self.ledger = counting.Ledger()
        self.near_misses = 0
        self.arrived = Condition()
        self.components = {}
        self.strands = {}
        self.is_ended = False
        self._withdrawals = {}
        self.endpoint = None

    def start(self, host):
        """Serve at the address of this host, which may be given as its name, on the loop that runs here."""
        self.host = host
        self.loop = loop.current()
        self.endpoint = f"{host}:{orb.listen(self.program.host.address, 0)}"

    def serve(self, servant, owner, exists=lambda: True, key=None):
        served = Served(self, servant, owner, exists)
        withdraw = orb.publish(served, self.host, key)
        self._withdrawals[key or servant] = withdraw
        return Remote(served.reference)

    def withdraw(self, servant):
        self._withdrawals.pop(servant, lambda: None)()

    def ghost(self, type_id):
        _, port = self.endpoint.split(":")
        nothing = references.make_reference(self.host, int(port), loop.world().octets(12))
        return Remote(references.Reference(type_id.encode(), nothing.profiles), type_id)

    def serve_key(self, servant, key, owner):
        octets = key.encode("latin-1")
        if octets in self._withdrawals:
            return None
        return self.serve(servant, owner, key=octets)

    def withdraw_key(self, key):
        self.withdraw(key.encode("latin-1"))

    def local_servant(self, reference):
        own = orb.own_servant(reference)
        return own and own.servant

    def text(self, reference):
        return reference.text()

    def reference(self, text):
        try:
            if text.startswith("corbaloc:"):
                return Remote(client.from_url("", text))
            return Remote(references.from_text(ior.checked(text)))
        except (ValueError, errors.Error):
            raise failure("BAD_PARAM")

    def address(self, reference):
        return orb.at_address(reference)

    def thread(self, function, *args):
        def run():
            self.ledger.own_thread()
            function(*args)

        strand = Strand(self, run)
        strand.begin()
        return strand

    def later(self, seconds, function, *args):
        self.loop.call_later(seconds, lambda: self.thread(function, *args))

    def die(self):
        self.program.die()
        raise worlds.Killed

    def end(self):
        """The program has ended: end all strands."""
        self.is_ended = True
        while self.strands:
            for strand in list(self.strands):
                strand.go_on()


# ---- in place of the carrier with omniORB ----

sys.modules["mock_components.carrier"] = mock_components.carrier = sys.modules[__name__]
CosNaming = types.SimpleNamespace(**contents("IDL:omg.org/CosNaming/"))
CosNaming.NamingContext.NotFound = CosNaming.NotFound
CosNaming.NamingContext.AlreadyBound = CosNaming.AlreadyBound
