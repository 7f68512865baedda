"""Files of a mounted RTC Tree that connect while they are open: values in and out of ports, events and logs of components."""
import collections
import functools
import math
import stat
import threading

from rtshell_lite import errors
from rtshell_lite.data import datatypes, reading, sender, values, writing
from rtshell_lite.mount.nodes import File
from rtshell_lite.mount.opened import Opened
from rtshell_lite.robot import ports
from rtshell_lite.text import printable

NAME = "rtmount"  # of our connectors
ROOM = 1 << 22  # bytes of lines that wait for a slow reader; the oldest are dropped


def data_type(port):
    """The datatypes.Type of a port's values. Raises Unsupported where it is not known."""
    try:
        return datatypes.Types().of_port(port)
    except errors.NoSuch:
        name = printable(port.properties.get("dataport.data_type", "")) or "no type"
        raise errors.Unsupported(ports.label(port), f"{name} is no standard data type; rtprint and rtinject take others (--idl)")


# ---- out of components ----------------------------------------------------------------------------------------

class Feed:
    """Lines that come from a component while anybody reads them. All readers share what `begin` makes.

    begin(publish) connects and returns an object with `failure()`, the errors.Error that ended it or None, and `close()`;
    publish(make) is then called, on any thread, for each line that make() returns.
    """

    def __init__(self, mount, where, begin):
        self._mount, self._where, self._begin = mount, where, begin
        self._lock, self._readers, self._made = threading.Lock(), set(), None
        self._heard = None  # what marks the lines that readers get: those of an earlier connection would leave a gap
        self._closing = threading.Lock()

    def attach(self, reader):
        """Give lines to a Reading from now on."""
        with self._lock:
            self._readers.add(reader)
        self._mount.changes.start(("feed", self._where), self._settle, most=1)

    def detach(self, reader):
        """Stop that."""
        with self._lock:
            self._readers.discard(reader)
        self._mount.changes.start(("feed", self._where), self._settle, most=1)

    def _settle(self):
        """Connect, or disconnect, as there are readers or none."""
        with self._lock:
            if not self._readers:
                self._heard = None
            elif self._made is None:
                self._heard = object()
            heard = self._heard
        if heard is None:
            self.close()
        elif self._made is None:
            try:
                self._made = self._begin(functools.partial(self._publish, heard))
                self._mount.streams.add(self)
            except Exception as e:  # a bug of ours must not leave readers waiting
                self._end(e)

    def _publish(self, mark, make):
        with self._lock:
            wanting = [reader for reader in self._readers if reader.wants_more()] if mark is self._heard else []
        if not wanting:
            return
        try:
            text = make()
        except errors.Error as e:
            return self._end(e)
        for reader in wanting:
            reader.put(text)

    def _end(self, error):
        with self._lock:
            readers = list(self._readers)
        for reader in readers:
            reader.end(error)

    def look(self):
        """See whether it has ended; to be called about once a second."""
        made = self._made
        failure = made and made.failure()
        if failure:
            self._end(failure)

    def close(self):
        """Disconnect. At the end of the mount, wait for a thread that does so already."""
        with self._closing:
            made, self._made = self._made, None
            if made is not None:
                made.close()
            self._mount.streams.discard(self)


class Reading:
    """An open stream: lines wait here for the reader, or the reader for a line. `limit`: how many lines it gets, None for all."""

    def __init__(self, mount, feed, where, limit=None):
        self._mount, self._feed, self._where, self._left = mount, feed, where, limit
        self._lock, self._waiting = threading.Lock(), collections.deque()  # of (server, request, size)
        self._lines, self._size, self._error, self._dropped = collections.deque(), 0, None, False
        feed.attach(self)

    def wants_more(self):
        return self._left is None or self._left > 0

    def put(self, text):
        """Add a line."""
        data = (text + "\n").encode("utf-8", "backslashreplace")
        with self._lock:
            if not self.wants_more():
                return
            self._left = self._left and self._left - 1
            self._lines.append(data)
            self._size += len(data)
            dropped = self._size > ROOM and len(self._lines) > 1 and not self._dropped
            while self._size > ROOM and len(self._lines) > 1:
                self._size -= len(self._lines.popleft())
            self._dropped |= dropped
        if dropped:
            self._mount.complain(f"{self._where}: lines are dropped: they come faster than they are read")
        self._serve()

    def end(self, error):
        """There will be no more lines; reads fail from now on."""
        with self._lock:
            self._error = self._error or error
        self._serve()

    def read(self, server, request, offset, size):
        with self._lock:
            self._waiting.append((server, request, size))
        self._serve()

    def _serve(self):
        while True:
            with self._lock:
                if not self._waiting or not (self._lines or self._error or not self.wants_more()):
                    return
                server, request, size = self._waiting.popleft()
                data = self._taken(size)
            if not data and self._error and self.wants_more():
                server.fail(request, self._error)
            else:
                server.reply(request, data)

    def _taken(self, size):
        """The next bytes, at most `size`, of one line: programs read in pieces, shells byte by byte."""
        if not self._lines:
            return b""
        line = self._lines.popleft()
        if len(line) > size:
            self._lines.appendleft(line[size:])
        self._size -= min(size, len(line))
        return line[:size]

    def interrupt(self, unique):
        with self._lock:
            self._waiting = collections.deque(item for item in self._waiting if item[1].unique != unique)

    def close(self):
        self._feed.detach(self)


class PortStream(File):
    """The values of an out port; `limit`: how many of them."""

    __slots__ = ("_limit",)

    def __init__(self, above, name, limit):
        super().__init__(above, name)
        self._limit = limit

    def open(self):
        if self.above.stream is None:
            self.above.stream = Feed(self.mount, self.above.where, lambda publish: Values(self.above.fresh(), publish))
        return Reading(self.mount, self.above.stream, self.where, self._limit)


class Values:
    """A connection to an out port."""

    def __init__(self, port, publish):
        self._type, self._publish = data_type(port), publish
        self._reader = reading.Reader(port, self._deliver, name=NAME)
        self._reader.__enter__()

    def _deliver(self, message):
        self._publish(lambda: values.text(self._type.decode(message.data, message.little), None))

    def failure(self):
        return None if self._reader.opened.live() else self._reader.failure

    def close(self):
        self._reader.__exit__()


class WatchStream(File):
    """The events, or the log, of a component: `make_watch(note)` gives the watch.Watch, `show(item)` a line."""

    __slots__ = ("_make_watch", "_show", "_feed")

    def __init__(self, above, name, make_watch, show):
        super().__init__(above, name)
        self._make_watch, self._show = make_watch, show
        self._feed = Feed(self.mount, self.where, lambda publish: Following(self, publish))

    def begin(self):
        """A Watch of its component, begun. Raises what that raises."""
        watching = self._make_watch(self.mount.complain)
        result, = watching.start([self.above.node.path])
        if isinstance(result, errors.Error):
            watching.close()
            raise result
        return watching

    def line(self, item):
        return self._show(item)

    def open(self):
        return Reading(self.mount, self._feed, self.where)


class Ended(Exception):
    """Nobody reads a WatchStream any more."""


class Following:
    """A watched component whose events go to a Feed."""

    def __init__(self, stream, publish):
        self._stream, self._publish, self._ended = stream, publish, threading.Event()
        self._watching = stream.begin()
        self._thread = threading.Thread(target=self._follow, daemon=True)
        self._thread.start()

    def _follow(self):
        try:
            for _, item in self._watching.follow(-1, math.inf, self._check):
                self._publish(lambda item=item: self._stream.line(item))
        except Ended:
            pass

    def _check(self):
        if self._ended.is_set():
            raise Ended

    def failure(self):
        """A component that dies is watched for its return."""

    def close(self):
        self._ended.set()
        self._thread.join()
        self._watching.close()


# ---- into components ------------------------------------------------------------------------------------------

class SendingHandle(Opened):
    """An open file of a Sending: whole lines need not wait."""

    def parted(self, begun):
        whole, newline, rest = begun.rpartition(b"\n")
        return whole + newline, rest

    def close(self):
        self.node.leave()


class Sending(File):
    """What is written to it is sent to an in port. All who write to a port share a connection, while any has the file open."""

    __slots__ = ("_open", "_made", "_closing")
    is_part = False
    mode = stat.S_IFREG | 0o200

    def __init__(self, above, name):
        super().__init__(above, name)
        self._open, self._made, self._closing = 0, None, threading.Lock()

    def content(self):
        raise errors.Unsupported(self.where, "values can only be written to an in port")

    def open(self):
        self._open += 1
        return SendingHandle(self)

    def store(self, text):
        """Send each line, and return when all have been read. Raises what rtinject reports."""
        for line in text.split("\n"):
            if line.strip():
                self._send(line.strip())

    def _send(self, line):
        writer, kind = self._connected(line)
        injection = sender.Injection([writer], [kind], datatypes.Types())
        for error in injection.run(sender.Constant(line), 1, math.inf, math.inf, lambda: None):
            raise error
        writing.linger([writer], None, lambda: None)
        if writer.failure:
            self.close()
            raise writer.failure

    def _connected(self, line):
        """(Writer, Type), connected once the first line fits."""
        if self._made is None:
            port = self.above.fresh()
            kind = data_type(port)
            values.Expression(line, datatypes.Types(), kind)
            writer = writing.Writer(port, name=NAME)
            writer.hint = ""
            writer.__enter__()
            self._made = writer, kind
            self.mount.streams.add(self)
        return self._made

    def look(self):
        """Its failures are those of the next write."""

    def leave(self):
        """An open file of it is closed."""
        self._open -= 1
        if not self._open:
            self.mount.changes.start(("change", self.where), self._closed, most=1)

    def _closed(self):
        if not self._open:
            self.close()

    def close(self):
        """Disconnect. At the end of the mount, wait for a thread that does so already."""
        with self._closing:
            made, self._made = self._made, None
            if made:
                made[0].__exit__()
            self.mount.streams.discard(self)
