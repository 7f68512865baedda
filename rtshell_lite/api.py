"""rtshell_lite for programs: launch scripts, test suites, analysers of data. docs/library.md compares it with
rtctree and rtsprofile.

    from rtshell_lite import api

    motor = api.component("/localhost/robot.host_cxt/Motor0.rtc", wait=30)
    with api.connected("/localhost/robot.host_cxt/Sensor0.rtc:out", motor.path + ":in"):
        motor.activate(wait=5)
        print(api.next_value(motor.path + ":out", timeout=2).data)

What is defined here keeps its names, arguments and meanings; more may be added. All other modules may change
with any version.

Paths are those of the commands; relative ones start at RTCSH_CWD. A profile is what `capture` and
`load_profile` return, or the name of a file with one. Failures are errors.Error, with `where`
(the object) and `why`; every remote call has a deadline (`set_timeout`). Functions may be called from any
thread, also in a program that is a component itself: its ORB, signals and threads are left alone. Rare
remarks go to stderr, such as that a peer's answer was too long.
"""

import collections
import contextlib
import functools
import math
import os
from _thread import allocate_lock

from rtshell_lite import errors, notes, path as paths, text
from rtshell_lite.corba import orb
from rtshell_lite.corba.session import Session
from rtshell_lite.errors import Error
from rtshell_lite.net import loop, real

__all__ = [
    "Component", "Connection", "Context", "Error", "Event", "Finding", "Manager", "Port", "Service", "Stream",
    "call", "capture", "check", "component", "components", "connect", "connected", "connections",
    "disconnect", "dump_profile", "examine", "find", "keep", "load_profile", "log", "manager", "next_value",
    "recording", "restore", "send", "service", "set_timeout", "start", "stop", "values", "values_of", "watch",
    "zombies",
]

POLL = 0.2  # seconds between two looks
LOOK = 2.0  # seconds between questions to a process whose components report nothing, see rtkeep

# An execution context: its number, kind (Periodic …), rate in Hz, whether it is running, the state of the
# component there, the instance names of its owner and of those that take part.
Context = collections.namedtuple("Context", "number kind rate running state owner participants")
# What has happened to a component: its path, seconds since 1970, and what rtwatch prints of it.
Event = collections.namedtuple("Event", "path time kind subject event")
# What rtdoctor says: `level` is fail, warn or ok; `check` the kind of the check; `path` the object, or "here"
# for this host; a message; what mends it, a command or words, or "".
Finding = collections.namedtuple("Finding", "level check path message remedy cause")
# A port: its path, its type (DataInPort, DataOutPort, CorbaPort, Port), a dict, and the ids of its
# connections.
Port = collections.namedtuple("Port", "path type properties connections")

_session = Session()


def _report(kind, what):
    """The listener of notes.py; unless the program says otherwise,
    Python prints what is logged so on stderr.
    """
    if kind != notes.DETAIL:
        import logging

        logging.getLogger("rtshell_lite").warning("%s", text.safe(str(what)))


notes.listener = notes.listener or _report


def _plain(function):
    """A coroutine function as a plain one, which runs on a loop of its own."""

    @functools.wraps(function)
    def run(*args, **more):
        try:
            return loop.run(function(*args, **more), _signals(), _session, as_guest=True)
        except Error as e:
            raise _at_caller(e) from None

    return run


def _at_caller(error):
    """A failure without our frames, and without what led to it, so that a program's traceback ends where it
    called. With RTSHELL_DEBUG they stay.
    """
    return error if os.environ.get("RTSHELL_DEBUG") else error.with_traceback(None)


def _signals():
    """What the program's own handlers of signals raise, see loop.run:
    they run, but never in the middle of a call.
    """
    return {
        number: functools.partial(_raised, number, handler)
        for number, handler in real.handlers().items()
        if callable(handler)
    }


def _raised(number, handler):
    try:
        handler(number, None)
    except BaseException as e:
        return e
    return None


def set_timeout(seconds):
    """Give up after `seconds` without an answer (default: 3). Raises ValueError."""
    if not 0 < seconds < math.inf:
        raise ValueError(f"not a number of seconds above 0: {seconds!r}")
    _session.timeout = float(seconds)


async def _path(word):
    """The Path that a text means, by the rule of all commands; see robot/lookup.py."""
    from rtshell_lite.robot import lookup

    (path,) = await lookup.paths([word])
    return path


# ---- components ----


class Component:
    """The component at a path. Each use looks it up, so that it may be restarted meanwhile."""

    def __init__(self, path):
        if not isinstance(path, paths.Path):
            path = paths.parse(path)
        self.path = str(path)

    def __repr__(self):
        return f"Component({self.path!r})"

    async def _node(self):
        from rtshell_lite.robot import tree

        return await tree.component(self.path)

    @property
    @_plain
    async def state(self):
        """Created, Inactive, Active, Error or Unknown."""
        from rtshell_lite.robot import component

        return await component.state(await self._node())

    @_plain
    async def activate(self, wait=None, context=None):
        """Activate it, as rtact does; `wait`: how many seconds to wait at most until it is Active;
        `context`: as -e of rtact.
        """
        await self._change("ACTIVATE", wait, context)

    @_plain
    async def deactivate(self, wait=None, context=None):
        """Deactivate it, as rtdeact does: in all its execution contexts,
        or in the one with the number `context`.
        """
        await self._change("DEACTIVATE", wait, context)

    @_plain
    async def reset(self, wait=None, context=None):
        """Take it from Error to Inactive."""
        await self._change("RESET", wait, context)

    async def _change(self, name, wait, context):
        from rtshell_lite.robot import transitions

        await transitions.change(await self._node(), getattr(transitions, name), context, wait)

    @_plain
    async def configuration(self, set_id=None):
        """The values of a configuration set (default: the active one), a dict of texts."""
        return dict((await self._configuration()).set(set_id, with_hidden=True).values)

    @_plain
    async def configure(self, values, set_id=None):
        """Set values (a dict of texts) in a configuration set (default: the active one)."""
        configuration = await self._configuration()
        texts = {name: str(value) for name, value in values.items()}
        await configuration.store(texts, configuration.set(set_id, with_hidden=True))

    @_plain
    async def activate_set(self, set_id):
        """Make a configuration set the active one."""
        await (await self._configuration()).activate(set_id)

    async def _configuration(self):
        from rtshell_lite.robot import configuration

        return await configuration.of(await self._node())

    @_plain
    async def ports(self):
        """Its Ports, a list."""
        from rtshell_lite.robot import ports

        listed = []
        for port in await ports.ports(await self._node()):
            ids = [connector.id for connector in port.connectors]
            listed.append(Port(ports.label(port), port.type, dict(port.properties), ids))
        return listed

    @_plain
    async def profile(self):
        """Its profile, a dict: instance_name, type_name, description, version, vendor and category, texts,
        and properties, a dict of texts.
        """
        from rtshell_lite.robot import component, ports

        node = await self._node()
        await ports.refs(node)  # first, see `component.profile`
        profile = await component.profile(node)
        fields = {name: getattr(profile, name) for name in component.FACTS}
        fields["properties"] = dict(profile.properties)
        return fields

    def connections(self):
        """The Connections of its ports, a list."""
        return connections(self.path)

    @_plain
    async def exit(self, wait=None):
        """Make it exit, as rtexit does; `wait`: how many seconds its name may take to go."""
        from rtshell_lite.robot import exiting

        errors.raise_first(await exiting.exit_all([paths.parse(self.path)], wait))

    # ---- its execution contexts, counted from 0 over its own, then those of others ----

    @_plain
    async def contexts(self):
        """Its Contexts, a list."""
        from rtshell_lite.robot import contexts

        return [_context(entry) for entry in await contexts.entries(await self._node())]

    @_plain
    async def set_rate(self, rate, context=0):
        """Set the rate (Hz) of an execution context."""
        from rtshell_lite.robot import contexts

        await contexts.set_rate(await self._node(), context, rate)

    @_plain
    async def start(self, context=0):
        """Start an execution context."""
        from rtshell_lite.robot import contexts

        await contexts.start(await self._node(), context)

    @_plain
    async def stop(self, context=0):
        """Stop an execution context: its components keep their states, and none of them is executed."""
        from rtshell_lite.robot import contexts

        await contexts.stop(await self._node(), context)

    @_plain
    async def attach(self, other, context=0):
        """Let the Component `other` take part in an execution context of this one."""
        from rtshell_lite.robot import contexts

        await contexts.attach(await self._node(), context, await other._node())

    @_plain
    async def detach(self, other, context=0):
        """Let the Component `other` leave an execution context of this one."""
        from rtshell_lite.robot import contexts

        await contexts.detach(await self._node(), context, await other._node())


def _context(entry):
    context = entry.context
    if context is None:  # of another component, which does not answer
        return Context(entry.index, None, None, None, entry.state, "", [])
    described = entry.index, context.kind, context.rate, bool(context.running)
    return Context(*described, entry.state, entry.owner, entry.participants)


@_plain
async def component(path, wait=0.0):
    """The Component at a path, once it is there and alive, for which it has `wait` seconds."""
    from rtshell_lite.robot import tree

    component = Component(await _path(path))
    end = loop.now() + wait
    while True:
        (node,) = await tree.components([paths.parse(component.path)])
        if not isinstance(node, Error):
            (node,) = await tree.check_alive([node])
            node = node.error or node
        if not isinstance(node, Error):
            return component
        if loop.now() >= end or not isinstance(node, (errors.NotFound, errors.Unreachable)):
            raise node
        await loop.sleep(POLL)


@_plain
async def components(top="/"):
    """The Components at and below a path, a list.
    What is dead or does not answer is left out; if that leaves none, the first failure is raised.
    """
    from rtshell_lite.robot import search, tree

    nodes, _, failures, _ = await search.components([await _path(top)])
    nodes = await tree.check_alive(nodes)
    living = [node for node in nodes if node.kind == "component"]
    failures += [node.error for node in nodes if node.kind != "component"]
    if failures and not living:
        raise failures[0]
    return [Component(str(node.path)) for node in living]


# ---- connections ----


async def _found(*words):
    from rtshell_lite.robot import ports

    paths = [await _path(word) for word in words]
    for path in paths:
        if path.port is None:
            raise errors.BadPath(path, "no port specified")
    return errors.raise_first(await ports.find(paths))


def _properties(given):
    from rtshell_lite.robot import connector_properties

    texts = {name if "." in name else "dataport." + name: str(value) for name, value in given.items()}
    return connector_properties.complete(texts)


@_plain
async def connect(one, other, **properties):
    """Connect two ports and return the id of the connection.
    Properties without a dot belong to `dataport`: data_type="…". Raises BadValue for one that is misspelt.
    """
    from rtshell_lite.robot import connectors

    return (await connectors.connect(await _found(one, other), given=_properties(properties))).id


@_plain
async def disconnect(one, other=None):
    """Remove the connections of two ports, or all of one; returns how many there were. Raises the failure of
    the first that stays, when all others are removed.
    """
    from rtshell_lite.robot import connectors, ports

    ends = await _found(*[path for path in (one, other) if path is not None])
    joining = ports.joining(ends) if other is not None else ends[0].connectors
    errors.raise_first(await connectors.disconnect_all([(ends[0], connector) for connector in joining]))
    return len(joining)


@contextlib.contextmanager
def connected(one, other, **properties):
    """Two ports connected for the time of a `with` statement, which gets the id of the connection."""
    port, connector = _connect(one, other, properties)
    try:
        yield connector.id
    finally:
        _disconnect(port, connector)


@_plain
async def _connect(port, other, properties):
    """The `port` and its connector with the other, which does not stay if Ctrl-C strikes meanwhile."""
    from rtshell_lite.robot import connectors

    ends = await _found(port, other)
    results = []

    async def connect():
        results.append(await connectors.connect(ends, given=_properties(properties)))

    try:
        await loop.finish(connect())
    except BaseException:
        for connector in results:
            await connectors.disconnect(ends[0], connector)
        raise
    return ends[0], results[0]


@_plain
async def _disconnect(port, connector):
    from rtshell_lite.robot import connectors

    await loop.finish(connectors.disconnect(port, connector))


class Connection:
    """A connection of two or more ports.

    id, name    texts
    ports       the paths of its ports; Unknown (…) for one that does not answer or has no name
    properties  a dict of texts
    """

    def __init__(self, port, connector, ends):
        self._port = str(port.node.path.with_port(port.name))
        self.id = connector.id
        self.name = connector.name
        self.ports = ends
        self.properties = dict(connector.properties)

    def __repr__(self):
        return f"Connection({self.id!r}, {self.ports!r})"

    @_plain
    async def remove(self):
        """Remove it. Raises errors.NoSuch if it is not there."""
        from rtshell_lite.robot import connectors

        (port,) = await _found(self._port)
        for connector in port.connectors:
            if connector.id == self.id:
                return await connectors.disconnect(port, connector)
        raise errors.NoSuch(self._port, "connection with id", text.printable(self.id))


@_plain
async def connections(path):
    """The Connections of a port, or of all ports of a component: a list, each once."""
    from rtshell_lite.robot import places, ports, tree

    where = await _path(path)
    is_port = where.port is not None
    near = await _found(path) if is_port else await ports.ports(await tree.component(where))
    name_of = await places.far_names(near)
    own = {orb.identity(port.ref): ports.label(port) for port in near}
    connections = {}
    for port in near:
        for connector in port.connectors:
            ends = [name_of(ref) or own[orb.identity(ref)] for ref in connector.ports]
            connections.setdefault(connector.id, Connection(port, connector, ends))
    return list(connections.values())


# ---- data ----


async def _type(port, idl):
    from rtshell_lite.data import datatypes

    return await datatypes.Types(idl=idl).load().of_port(port)


def values(port, timeout=None, idl=(), **properties):
    """A Stream of the values that an out port sends, from its connection at the first one on; the end of the
    Stream removes that.

    A value has its IDL members as attributes: value.tm.sec, value.data. Raises errors.Unreachable when none
    comes for `timeout` seconds. `idl` are files with types that are not standard ones.
    """
    given = _properties(properties)
    return Stream(lambda: _Values([port], idl, given, lambda name, value: value), timeout)


def values_of(ports, timeout=None, idl=(), **properties):
    """A Stream of (port, value) for what several out ports send, in the order in which it came; `port` is one
    of `ports`, as it is spelt there. Ends when the first connection is lost; otherwise as `values`.
    """
    names = list(ports)
    given = _properties(properties)
    return Stream(lambda: _Values(names, idl, given, lambda *pair: pair), timeout)


def next_value(port, timeout=5.0, idl=(), **properties):
    """The next value that an out port sends; see `values`."""
    with contextlib.closing(values(port, timeout, idl, **properties)) as coming:
        return next(coming)


class Stream:
    """What comes one after the other: `for value in stream:`, or under asyncio `async for value in stream:`.

    It begins with the first one, each `async for` anew. It ends with `close()`, or when nobody has it any
    more; what `async for` leaves ends soon after.
    """

    def __init__(self, make_feed, timeout):
        """`make_feed` makes the _Feed of all that comes in one `for`."""
        self._make_feed = make_feed
        self._timeout = None if timeout == math.inf else timeout
        self._coming = make_feed().stream(self._timeout)

    def __iter__(self):
        return self

    def __next__(self):
        try:
            return next(self._coming)
        except Error as e:
            raise _at_caller(e) from None

    def close(self):
        """End it, and wait for that."""
        self._coming.close()

    def __aiter__(self):
        return self._make_feed().stream_async(self._timeout)


class _Feed:
    """What comes for a Stream, on a thread of its own, so that the components need not wait for the program;
    `_receive(*words)` is what runs there.
    """

    session = _session

    def __init__(self, *words):
        self._words = words
        self._loop = self._task = self._failure = None
        self._is_ending = self._is_over = False
        self._news = allocate_lock()  # released when something has come, or the end; acquired by the program
        self._news.acquire()
        self._tell_more = None  # of asyncio

    def stream(self, timeout):
        """Yield what comes."""
        try:
            self.begin()
            while True:
                self._want()
                yield from self._taken(self._wait(timeout), timeout)
        finally:
            self.end()

    async def stream_async(self, timeout):
        """The same, on the loop of asyncio."""
        import asyncio

        came = asyncio.Event()
        self._tell_more = functools.partial(asyncio.get_event_loop().call_soon_threadsafe, came.set)

        async def wait(seconds):
            end = seconds and loop.now() + seconds
            while not self._news.acquire(False):
                try:
                    await asyncio.wait_for(came.wait(), seconds and max(0, end - loop.now()))
                except asyncio.TimeoutError:
                    return False
                came.clear()
            self.check()
            return True

        try:
            self._start()
            await wait(None)
            while True:
                self._want()
                for item in self._taken(await wait(timeout), timeout):
                    yield item
        finally:
            if self._cancel():
                while not self._is_over:
                    await came.wait()
                    came.clear()

    def begin(self):
        """Connect. Raises what that raises."""
        self._start()
        self._wait(None)

    def end(self):
        """Disconnect."""
        if self._cancel():
            while not self._is_over:
                self._news.acquire()

    def check(self):
        """Raise what its thread has raised."""
        if isinstance(self._failure, Error):
            raise _at_caller(self._failure) from None
        if self._failure is not None:
            raise self._failure

    def _start(self):
        loop.world().start_thread(self._run)

    def _want(self):
        """Have the thread say when something has come: here it always does."""

    def _taken(self, has_come, timeout):
        """Yield what has come, if anything has in time."""
        raise NotImplementedError

    def _cancel(self):
        """Have the thread disconnect: whether that takes time; one that has not begun yet ends at once."""
        self._is_ending = True
        if self._loop is not None:
            self._loop.post(self._task.cancel)
        return self._loop is not None

    def _wait(self, seconds):
        """Wait until something has come: whether it has."""
        has_come = self._news.acquire(timeout=-1 if seconds is None else max(seconds, 0))
        self.check()
        return has_come

    # ---- on its thread ----

    def _run(self):
        try:
            loop.run(self._begun(), session=self.session)
        except loop.Cancelled:
            pass
        except BaseException as e:
            self._failure = e
        self._is_over = True
        self._tell()

    async def _begun(self):
        here = loop.current()
        here.make_bell()
        self._task = here.running
        self._loop = here
        if not self._is_ending:
            await self._receive(*self._words)

    def _tell(self):
        if self._news.locked():
            self._news.release()
        if self._tell_more is not None:
            with contextlib.suppress(RuntimeError):  # the loop of asyncio has been closed
                self._tell_more()


class _Values(_Feed):
    """The values of out ports; form(port, value) makes of each what comes."""

    def __init__(self, names, idl, properties, form):
        super().__init__(names, idl, properties)
        self._form = form
        self._wanted = loop.Bell()  # rings when the program wants values
        self._ports = self._types = self._batch = self._where = None

    def _want(self):
        self._loop.post(self._wanted.ring)

    def _taken(self, has_come, timeout):
        if not has_come:
            raise errors.Unreachable(self._where, f"no value within {timeout:g}s")
        for number, message in self._batch:
            value = self._types[number].decode(message.data, message.little)
            yield self._form(self._ports[number], value)

    async def _receive(self, names, idl, properties):
        from rtshell_lite.data import connection, inbox, reading

        ports = await _found(*names)
        self._ports = names
        self._types = [await _type(port, idl) for port in ports]
        box = inbox.Inbox()
        readers = [
            reading.Reader(port, box.taker(key), properties=properties) for key, port in enumerate(ports)
        ]
        self._where = ", ".join(reader.where for reader in readers)
        async with connection.Connections(readers):
            _check(readers)
            self._tell()
            while await self._wanted.wait():
                self._batch = await _values_in(box, readers)
                self._tell()


async def _values_in(box, readers):
    """What has come into an Inbox, once there is anything."""
    while True:
        batch = await box.get(POLL)
        if batch:
            return batch
        _check(readers)


def _check(readers):
    """Raise the first failure of Readers."""
    for reader in readers:
        if reader.failure:
            raise reader.failure


@contextlib.contextmanager
def recording(name, ports, idl=(), **properties):
    """Record what out ports send into a log (MCAP, see `log`) for the time of a `with` statement, which
    begins once all are connected. A channel has the path of its port as its name; an existing file is
    replaced.

    At the end it raises OSError if the file could not be written, errors.Unreachable if a port was lost,
    errors.Failed if values were dropped; what came before is in the file.
    """
    feed = _Recording(name, list(ports), idl, _properties(properties))
    try:
        feed.begin()
        yield
    except BaseException:
        feed.end()
        raise
    feed.end()
    feed.check()


class _Recording(_Feed):
    """A log that is written, on a thread of its own."""

    def __init__(self, *words):
        super().__init__(*words)
        self.readers = []

    async def _receive(self, name, names, idl, properties):
        from rtshell_lite.data import connection, datatypes, reading
        from rtshell_lite.datalog import recorder, recording as records
        from rtshell_lite.robot import ports

        channels = recorder.Channels(datatypes.Types(idl=idl).load())
        work = recorder.Recorder(channels)
        for port in await _found(*names):
            number = await channels.add(port, ports.label(port))
            self.readers.append(reading.Reader(port, work.box.taker(number), properties=properties))
        try:
            async with connection.Connections(self.readers):
                _check(self.readers)
                await work.begin(records.File(name, "mcap", False), int(loop.wall() * 1e9))
                self._tell()
                await work.run()
        finally:
            await loop.finish(work.close())
            _check(self.readers)
            dropped = sum(work.box.dropped.values())
            if dropped:
                raise errors.Failed(text.printable(name), f"{dropped} values dropped")


@_plain
async def send(port, value, idl=(), anyway=False):
    """Send a value to an in port and wait until the component can have read it. A member `tm` that is left
    out is the present.

    The value is one of its type, a dict of its members, or what its member `data` is to be: 42. Raises
    errors.Failed for a component that does not read now (unless `anyway`), errors.Unread when it stops doing
    so, BadValue.
    """
    from rtshell_lite.data import values as data_values, writing

    (end,) = await _found(port)
    type = await _type(end, idl)
    now = divmod(int(loop.wall() * 1e9), 10**9)
    built = data_values.build(type.descriptor, value, type.name, now=now)
    async with writing.Writer(end, {}, "rtshell_lite", anyway) as writer:
        await writer.put(type.encode(built, writer.little), writer.little)
        await writing.linger([writer], None)
    if writer.failure:
        raise writer.failure


# ---- services ----

LIMIT = 60.0  # seconds that an operation may take


@_plain
async def call(path, operation, *args, idl=(), limit=LIMIT):
    """Call an operation of a service port, PATH:PORT or PATH:PORT.INSTANCE, or of a component itself, PATH:
    what it returns, a tuple where that is several values. An attribute `speed` is read as _get_speed, set as
    _set_speed.

    `args` are values of their types, or dicts of their members. `idl` are IDL files; more are found by
    RTSHELL_IDL. It is sent once, never again. Raises errors.Raised for an exception of the IDL, with its
    `name` and its `value`, errors.MayBeDone after `limit` seconds, errors.Refused for a component that is not
    Active, BadValue.
    """
    return await _call(await _provider(path, operation, idl), operation, args, {}, limit)


async def _provider(path, name, idl):
    from rtshell_lite.data import calling, datatypes

    return await calling.find(await _path(path), datatypes.Types(idl=idl), name)


async def _call(provider, name, args, named, limit):
    from rtshell_lite.data import call_values

    operation = provider.operation(name)
    values = call_values.of_values(operation, args, named, provider.find_type)
    return await provider.call(operation, values, limit)


class Service:
    """What a service port, or a component itself, serves; its attributes are the operations:

        arm = api.service("/localhost/Arm0.rtc:manip")
        arm.moveLinear(goal, speed=0.5)

    An attribute `speed` of the IDL is read by _get_speed() and set by _set_speed(3.5). After a failure that
    shows that its process has ended, the next use looks it up again.
    """

    def __init__(self, path, idl, limit):
        self._path = path
        self._idl = idl
        self._limit = limit
        self._provider = None

    def __repr__(self):
        return f"Service({self._path!r})"

    def __dir__(self):
        return list(self._found().operations())

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        operations = self._found().operations()
        if name not in operations:
            words = text.candidates(name, operations)
            raise AttributeError(f"{self._path}: no such operation: {name}{words}")
        return functools.partial(self._call, name)

    @_plain
    async def _find(self):
        from rtshell_lite.data import calling, datatypes

        return await calling.single(await _path(self._path), datatypes.Types(idl=self._idl))

    def _found(self):
        if self._provider is None:
            self._provider = self._find()
        return self._provider

    def _call(self, name, *args, **named):
        """Call an operation. Raises what `call` raises."""
        provider = self._found()
        try:
            return self._call_of(provider, name, args, named)
        except errors.Unreachable:
            self._provider = None
            raise

    @_plain
    async def _call_of(self, provider, name, args, named):
        return await _call(provider, name, args, named, self._limit)


def service(path, idl=(), limit=LIMIT):
    """The Service at PATH:PORT, PATH:PORT.INSTANCE or PATH; see `call`. Raises errors.Error."""
    service = Service(path, idl, limit)
    dir(service)
    return service


# ---- systems ----


@_plain
async def capture(*tops, unconnected=False):
    """The RtsProfile of what runs below these paths (default: all name servers), as rtcryo saves it:
    components without connections only if `unconnected`. Raises the first failure.
    """
    from rtshell_lite.system import capture as capturing

    system = await capturing.capture([await _path(top) for top in tops], all_components=unconnected)
    errors.raise_first(system.failures)
    return system.profile


@_plain
async def restore(profile, create=False, manager=None, rollback=False):
    """Bring the running system to a profile, as rtresurrect does; raises the first failure of what the
    profile requires.

    `create`: let managers create what is missing, that at the path `manager` where the profile names none.
    """
    from rtshell_lite.system import apply, restore as restoring

    outcomes = await restoring.restoring(_profile(profile), restoring.Options(create, manager, False))
    await apply.carry_out(outcomes, rollback)
    for outcome in outcomes:
        if outcome.failed and outcome.step.required:
            raise outcome.error


@_plain
async def check(profile, state="Active", extra=False):
    """How the running system differs from a profile, as lines of text; [] where it does not. See rtcheck.
    Raises ValueError.
    """
    from rtshell_lite.robot import component
    from rtshell_lite.system import compare

    if state not in component.STATES:
        raise ValueError(f"not one of {', '.join(component.STATES)}: {state!r}")
    result = await compare.compare(_profile(profile), state, extra=extra)
    errors.raise_first(result.failures)
    return [difference.message for difference in result.differences if difference.required]


def keep(profile, timeout=None, create=False, manager=None, strict=False):
    """Keep the running system as a profile says, as rtkeep does: a Stream of what happens, time, object,
    seen, done, seconds, error of each. Ends with the Stream, and leaves the components as they are.

    With a `timeout`, it has None where nothing has happened within `timeout` seconds. `create`, `manager` as
    in `restore`; `strict` undoes what a person does, too. Raises errors.Failed for a profile that cannot be
    meant.
    """
    described = _profile(profile)
    return Stream(lambda: _Happenings(described, create, manager, strict), timeout)


class _Happenings(_Feed):
    """What happens to a system that is kept, on a thread of its own."""

    def __init__(self, *words):
        super().__init__(*words)
        self.session = Session(_session.timeout, _session.memory)
        self._batch = collections.deque()

    def _taken(self, has_come, timeout):
        if not has_come:
            yield None
        while self._batch:
            yield self._batch.popleft()

    async def _receive(self, profile, create, manager, strict):
        from rtshell_lite.system import keep as keeping, plan, policy

        planned = plan.make(profile, "activation", "the profile")
        how = keeping.Options(create, manager, False, strict, LOOK, True, policy.USUAL)
        async with keeping.Keeper(profile, planned, how, self._take) as keeper:
            self._tell()
            await keeper.follow()

    def _take(self, happening):
        self._batch.append(happening)
        self._tell()


@_plain
async def start(profile, wait=None):
    """Activate the components of a profile by its plan, as rtstart does; raises the first failure of those
    that the profile requires. `wait`: how many seconds a component may take (default: the timeout).
    """
    await _carry_out(profile, "activation", "ACTIVATE", wait)


@_plain
async def stop(profile, wait=None):
    """Deactivate the components of a profile by its plan, as rtstop does; see `start`."""
    await _carry_out(profile, "deactivation", "DEACTIVATE", wait)


async def _carry_out(profile, kind, transition, wait):
    from rtshell_lite.robot import transitions
    from rtshell_lite.system import plan, run_plan

    profile = _profile(profile)
    planned = plan.make(profile, kind, "the profile")
    progress = run_plan.Progress()
    carried = run_plan.Run(planned.actions, getattr(transitions, transition), progress, wait)
    if await carried.check(profile):
        carried.refuse()
    else:
        await carried.carry_out()
    for result in progress.results:
        if result.error is not None and result.action.component.is_required:
            raise result.error


def watch(*components, timeout=None):
    """A Stream of an Event for what happens to the components at these paths, as rtwatch prints it: states,
    ports, connections, configuration, death and return. The end of the Stream removes the observers.

    With a `timeout`, it has None where nothing has happened within `timeout` seconds. Raises the first
    failure.
    """
    return Stream(lambda: _Watching(components), timeout)


class _Watching(_Happenings):
    """What happens to components, on a thread of its own."""

    async def _receive(self, words):
        from rtshell_lite.live import watch

        async with watch.Watch(watch.Events(watch.KINDS)) as watching:
            errors.raise_first(await watching.add([await _path(word) for word in words]))
            self._tell()
            async for batch in watching.follow(-1, math.inf):
                for watched, event in batch:
                    self._take(Event(watched.where, *event))


@_plain
async def examine(*tops, profile=None, state="Active", measure=0.0):
    """What rtdoctor finds out about what is at and below these paths (default: all name servers): a list of
    Findings, failures first.

    profile  what the system should be like, and `state` the state that its components should be in
    measure  for how many seconds to connect to out ports, and measure rates; 0: do not connect
    """
    from rtshell_lite.doctor import examination, finding

    compare = None
    if profile is not None:
        # in the commands that mend it
        file = text.shell_word(profile) if isinstance(profile, str) else "FILE"
        compare = _profile(profile), file, state
    all_findings = []
    async for findings in examination.examine([await _path(top) for top in tops], compare, measure):
        all_findings += findings
    return [Finding(*fields) for fields in finding.sorted_by_level(all_findings)]


# ---- the RTC Tree ----


@_plain
async def find(pattern, top="/"):
    """The paths of what is called like a pattern (Motor*.rtc), at and below a path: a list, in the order of
    the tree. Names of what is dead or silent are in it. Directories that do not answer are left out; if that
    leaves nothing, the first failure is raised.
    """
    from rtshell_lite.robot import search

    criteria = search.Wanted(search.patterns([pattern], []), set(), set(), None)
    nodes, failures, _ = await search.find([await _path(top)], criteria)
    if failures and not nodes:
        raise failures[0]
    return [str(node.path) for node in nodes]


@_plain
async def zombies(top="/"):
    """The names, as paths, at and below a path whose components are dead. Raises the first failure."""
    from rtshell_lite.robot import naming, tree

    nodes, failed = await naming.zombies(await tree.resolve(await _path(top)))
    if failed:
        raise failed[0].error
    return [str(node.path) for node in nodes if node.kind == "zombie"]


class Manager:
    """The manager at a path, or at corbaloc:iiop:HOST[:PORT][/KEY]. Each use looks it up."""

    def __init__(self, path):
        self.path = path

    def __repr__(self):
        return f"Manager({self.path!r})"

    async def _node(self):
        from rtshell_lite.robot import manager

        return await manager.find(self.path)

    @_plain
    async def load(self, file, function):
        """Load a module; `function` is its initialisation function."""
        from rtshell_lite.robot import manager

        await manager.load(await self._node(), file, function)

    @_plain
    async def unload(self, file):
        """Unload a module."""
        from rtshell_lite.robot import manager

        await manager.unload(await self._node(), file)

    @_plain
    async def create(self, module, wait=5.0, **properties):
        """Create a component and return it, once it is ready, for which it has `wait` seconds:
        create("Motor", instance_name="left").
        """
        from rtshell_lite.robot import manager

        pairs = "&".join(f"{key}={value}" for key, value in properties.items())
        argument = module + "?" * bool(pairs) + pairs
        manager.check_argument(argument)
        node = await self._node()
        name = await manager.create(node, argument, wait)
        return Component(node.path.child(paths.Name(name, "rtc")))

    @_plain
    async def delete(self, instance_name):
        """Delete the component with this instance name."""
        from rtshell_lite.robot import manager

        await manager.delete(await self._node(), instance_name)

    @_plain
    async def components(self):
        """Its live Components, a list; those of its slaves, too."""
        from rtshell_lite.robot import manager

        return [Component(child.path) for _, child in await manager.components(await self._node())]

    @_plain
    async def modules(self):
        """What it can create: a list of dicts of texts, implementation_id, type_name, category …"""
        from rtshell_lite.robot import manager

        return await manager.modules(await self._node(), "get_factory_profiles")

    @_plain
    async def shutdown(self, wait=None):
        """End its process, those of its slaves first; `wait`: how many seconds each may take."""
        from rtshell_lite.robot import manager

        errors.raise_first(await manager.shut_down(await self._node(), wait))


def manager(path):
    """The Manager at a path. Raises errors.Error if there is no manager."""
    manager = Manager(path)
    _plain(manager._node)()
    return manager


# ---- files ----


def log(name, idl=()):
    """Yield the entries of a log (MCAP, or of rtshell's rtlog), dicts as `rtlog export --json` prints them:
    number, received (seconds since 1970), port, type, value. Raises OSError, errors.Failed.
    """
    from rtshell_lite.data import datatypes
    from rtshell_lite.datalog import decode, logfile

    types = datatypes.Types(idl=idl).load()
    with logfile.load(name, types.scopes()) as opened:
        decoder = decode.Decoder(opened, types)
        for entry in opened.entries():
            yield decoder.record(entry)


def _profile(given):
    """The profile that a program means by a profile, or by the name of a file with one."""
    return given if hasattr(given, "components") else load_profile(given)


def load_profile(name):
    """The RtsProfile (xmlprofile.model.RtsProfile) in a file, XML or YAML.
    Raises errors.BadProfile, OSError.
    """
    from rtshell_lite.system import capture as capturing

    return capturing.read(name)


def dump_profile(profile, name, form="xml"):
    """Write a profile to a file, as xml or yaml, whole or not at all. Raises OSError, ValueError."""
    from rtshell_lite import files
    from rtshell_lite.xmlprofile import rtsprofile

    if form not in (rtsprofile.XML, rtsprofile.YAML):
        raise ValueError(f"not xml or yaml: {form!r}")
    files.write(name, rtsprofile.dump(profile, form))
