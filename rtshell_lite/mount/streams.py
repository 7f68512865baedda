"""Files of a mounted RTC Tree that connect while they are open:
values of ports, events and logs of components.
"""

import collections
import functools
import math
import stat

from rtshell_lite import errors
from rtshell_lite.data import connection, datatypes, reading, sender, values, writing
from rtshell_lite.mount.attempt import attempt
from rtshell_lite.mount.nodes import File
from rtshell_lite.mount.openfile import OpenFile
from rtshell_lite.net import loop
from rtshell_lite.robot import ports
from rtshell_lite.text import printable

NAME = "rtmount"  # of our connectors
ROOM = 1 << 22  # bytes of lines that wait for a slow reader; the oldest are dropped
LOOK = 1.0  # seconds between two looks whether a connection has ended


async def data_type(port):
    """The datatypes.Type of a port's values. Raises Unsupported where it is not known."""
    try:
        return await datatypes.Types().of_port(port)
    except errors.NoSuch:
        name = printable(port.properties.get("dataport.data_type", "")) or "no type"
        raise errors.Unsupported(
            ports.label(port), f"{name} is not a standard data type; rtprint and rtinject take others (--idl)"
        )


# ---- out of components ----


class Feed:
    """Lines that come from a component while anybody reads them. All readers share a connection.

    follow(publish), a coroutine function, connects until it is cancelled, or raises the errors.Error that
    ends it. It calls publish(make) for each line, which make() returns.
    """

    def __init__(self, mount, follow):
        self._mount = mount
        self._follow = follow
        # it rings when one of them has left
        self._readers = set()
        self._left = loop.Bell()
        self._is_running = self._is_ending = False

    def attach(self, reader):
        """Give lines to a StreamFile from now on."""
        self._readers.add(reader)
        if not self._is_running:
            self._is_running = True
            self._mount.tasks.start(self._run())

    def detach(self, reader):
        self._readers.discard(reader)
        self._left.ring()

    async def _run(self):
        while self._readers:
            self._is_ending = False
            _, error = await attempt(loop.race(self._follow(self._publish), self._all_left()))
            if error is not None:
                self._end(error)
        self._is_running = False

    async def _all_left(self):
        while self._readers:
            await self._left.wait()
        self._is_ending = True  # readers that come now get the lines of the next connection, without a gap

    def _publish(self, make):
        wanting = [reader for reader in self._readers if reader.wants_more()]
        if not wanting or self._is_ending:
            return
        try:
            text = make()
        except errors.Error as e:
            self._end(e)
            return
        for reader in wanting:
            reader.put(text)

    def _end(self, error):
        readers = self._readers
        self._readers = set()
        for reader in readers:
            reader.end(error)
        self._left.ring()


class StreamFile:
    """An open stream: lines wait here for requests to read, or these for a line.

    limit  how many lines there are; None for no end
    """

    def __init__(self, mount, feed, where, limit=None):
        self._mount = mount
        self._feed = feed
        self._where = where
        self._left = limit
        self._waiting = set()  # Waits of requests to read
        self._lines = collections.deque()
        self._size = 0
        self._error = None
        self._has_dropped = False
        feed.attach(self)

    def wants_more(self):
        """Whether another line will be read."""
        return self._left is None or self._left > 0

    def put(self, text):
        """Add a line."""
        data = (text + "\n").encode("utf-8", "backslashreplace")
        if self._left is not None:
            self._left -= 1
        self._lines.append(data)
        self._size += len(data)
        while self._size > ROOM and len(self._lines) > 1:
            self._size -= len(self._lines.popleft())
            if not self._has_dropped:
                self._has_dropped = True
                self._mount.complain(f"{self._where}: lines are dropped: they come faster than they are read")
        self._wake()

    def end(self, error):
        """There will be no more lines; reads fail from now on."""
        self._error = error
        self._wake()

    def _wake(self):
        for wait in self._waiting:
            wait.done()

    async def read(self, offset, size):
        """The next bytes of one line, at most `size`: programs read in pieces, shells byte by byte.
        No offset counts.
        """
        while not self._lines and self.wants_more():
            if self._error is not None:
                raise self._error
            await self._next_line()
        if not self._lines:
            return b""
        line = self._lines.popleft()
        if len(line) > size:
            self._lines.appendleft(line[size:])
        self._size -= min(size, len(line))
        return line[:size]

    async def _next_line(self):
        wait = loop.Wait()
        self._waiting.add(wait)
        try:
            await wait
        finally:
            self._waiting.discard(wait)

    def close(self):
        """The last descriptor is closed."""
        self._feed.detach(self)


class PortStream(File):
    """The values of an out port; `limit`: how many of them."""

    __slots__ = ("_limit",)

    def __init__(self, above, name, limit):
        super().__init__(above, name)
        self._limit = limit

    def open(self):
        if self.above.stream is None:
            self.above.stream = Feed(self.mount, functools.partial(_follow_port, self.above))
        return StreamFile(self.mount, self.above.stream, self.where, self._limit)


async def _follow_port(directory, publish):
    port = await directory.fresh()
    kind = await data_type(port)

    def take(message):
        publish(lambda: values.text(kind.decode(message.data, message.little), None))

    reader = reading.Reader(port, take, name=NAME)
    async with connection.Connections([reader]) as opened:
        while opened.live():
            await loop.sleep(LOOK)
        failure = reader.failure
    raise failure


class WatchStream(File):
    """The events, or the log, of a component: `make_watch()` gives the watch.Watch, `show(item)` a line."""

    __slots__ = ("_make_watch", "_show", "_feed")

    def __init__(self, above, name, make_watch, show):
        super().__init__(above, name)
        self._make_watch = make_watch
        self._show = show
        self._feed = Feed(self.mount, self._follow)

    async def _follow(self, publish):
        async with self._make_watch() as watching:
            (result,) = await watching.add([self.above.node.path])
            if isinstance(result, errors.Error):
                raise result
            async for batch in watching.follow(-1, math.inf):
                for _, item in batch:
                    publish(functools.partial(self._show, item))

    def open(self):
        return StreamFile(self.mount, self._feed, self.where)


# ---- into components ----


class SendingFile(OpenFile):
    """An open file of a Sending: whole lines need not wait."""

    def split(self, begun):
        whole, newline, rest = begun.rpartition(b"\n")
        return whole + newline, rest

    def close(self):
        self.node.leave()


class Sending(File):
    """What is written to it is sent to an in port.
    All writers share a connection, while any has the file open.
    """

    __slots__ = ("_open", "_writer", "_type", "_unused", "_closed")
    is_part = False
    mode = stat.S_IFREG | 0o200

    def __init__(self, above, name):
        super().__init__(above, name)
        self._open = 0
        self._writer = None
        self._type = None
        self._unused = self._closed = None  # a Bell that ends the connection; a Wait for its end

    async def content(self):
        raise errors.Unsupported(self.where, "values can only be written to an in port")

    def open(self):
        self._open += 1
        return SendingFile(self)

    def leave(self):
        """An open file of it is closed."""
        self._open -= 1
        if not self._open:
            self.mount.change(self.where, self._close_if_unused)

    async def _close_if_unused(self):
        if not self._open:
            await self._close()

    async def store(self, text):
        """Send each line, and return when all have been read. Raises what rtinject reports."""
        for line in text.split("\n"):
            if line.strip():
                await self._send(line.strip())

    async def _send(self, line):
        if self._writer is None:
            await self._connect(line)
        writer = self._writer
        injection = sender.Injection([writer], [self._type], datatypes.Types())
        failures = [failure async for failure in injection.run(sender.Constant(line), 1, math.inf, math.inf)]
        if failures:
            raise failures[0]
        await writing.linger([writer], None)
        if writer.failure:
            await self._close()
            raise writer.failure

    async def _connect(self, line):
        """Connect, once the first line fits."""
        port = await self.above.fresh()
        kind = await data_type(port)
        values.Expression(line, datatypes.Types(), kind)
        writer = writing.Writer(port, name=NAME)
        writer.hint = ""
        opened = loop.Wait()
        self._unused = loop.Bell()
        self._closed = loop.Wait()
        self.mount.tasks.start(self._stay_connected(writer, opened))
        await opened
        self._writer = writer
        self._type = kind

    async def _stay_connected(self, writer, opened):
        _, error = await attempt(self._connection(writer, opened))
        if error is not None and opened.is_over:
            self.mount.fail(error)
        opened.end(None, error)
        self._closed.done()

    async def _connection(self, writer, opened):
        async with writer:
            opened.done()
            await self._unused.wait()

    async def _close(self):
        if self._writer is not None:
            self._writer = None
            self._unused.ring()
            await self._closed
