"""Receiving logs as fluentd does: OpenRTM-aist 2 sends its log through Fluent Bit, whose output `forward`
connects to a TCP port.

In rtc.conf, where its logger FluentBit is loaded (HOST is the host of this program):

    logger.logstream.fluentd.output.plugin: forward
    logger.logstream.fluentd.output.conf.host: HOST
    logger.logstream.fluentd.output.conf.port: 24224

A message is an array: [tag, time, record], [tag, [[time, record], …]], or [tag, octets] with such pairs one
after the other, perhaps compressed by gzip; after these, perhaps, a map of options. `chunk` in it asks for an
answer.

Anybody may send anything: 30 kB of gzip may be 32 MB of records, and each octet of these a value. So a sender
has a budget of octets and values, counted unpacked, for each second. One that has used it up, or sends more
records than are read, is not read for a while: it waits, others do not.
"""

import collections
import ipaddress
import struct

from rtshell_lite import errors, notes
from rtshell_lite.live import msgpack
from rtshell_lite.live.observer import Record
from rtshell_lite.net import loop, real, tcp
from rtshell_lite.text import printable

MOST_SENDERS = 64  # connections; one more takes the place of one of the address that has most
LARGEST = 8 << 20  # octets of a message, unpacked
MOST_OCTETS = 64 << 20  # of all messages that have not all come
MOST_PARTS = 100  # parts of a message that were compressed one by one
UNFINISHED = 30.0  # seconds that a message may take to come
PIECE = 1 << 16
LONGEST = 4096  # characters of a name
LONGEST_MESSAGE = 1 << 16  # characters of a record's message; of longer ones, the beginning is taken
SLICE = 100  # records that are taken before other tasks go on
# what a sender may send in a second, and for how many seconds at once; a full buffer of Fluent Bit has 2 MB
# and 200,000 values
OCTETS = 8 << 20
VALUES = 200000
AHEAD = 5.0
MOST_KNOWN = 1000  # addresses whose budget is remembered
PAUSE = 0.05  # seconds between two looks whether there is room for more

# Who has written a record, as far as it says: `name` is shown in lines, `where` is its path.
Source = collections.namedtuple("Source", "where name")


# ---- messages ----


def pairs(data, spend=lambda octets, values: None):
    """The tag of a message, octets that begin with it, and (time, record) one after the other; the last item
    is the map of options. Raises Malformed, struct.error, IndexError.

    spend(octets, values) is called with what was in octets: all that was unpacked, then what is in each pair.
    """
    kind, count, offset = msgpack.head(data, 0)
    if kind != msgpack.ARRAY or not 2 <= count <= 4:
        raise msgpack.Malformed("not an event")
    tag, offset = msgpack.value(data, offset)
    kind, number, inner = msgpack.head(data, offset)
    if kind == msgpack.ARRAY and count < 4:
        options = _options(data, _skipped(data, offset), count > 2)
        return tag, _listed(data, inner, number), options
    body, offset = msgpack.value(data, offset)
    if isinstance(body, (bytes, str)):
        options = _options(data, offset, count > 2)
        if isinstance(body, str):
            body = body.encode("utf-8", "surrogateescape")
        return tag, _packed(body, options, spend), options
    record, offset = msgpack.value(data, offset)
    return tag, iter([(body, record)]), _options(data, offset, count > 3)


def _skipped(data, offset):
    """Where the value after the one at `offset` begins."""
    end = msgpack.Scan().end(memoryview(data)[offset:])
    if end is None:
        raise IndexError(offset)
    return offset + end


def _options(data, offset, has_any):
    if not has_any:
        return {}
    options, _ = msgpack.value(data, offset)
    return options if isinstance(options, dict) else {}


def _listed(data, offset, number):
    for _ in range(number):
        pair, offset, _ = _pair(data, offset)
        yield pair


def _packed(body, options, spend):
    if options.get("compressed") == "gzip":
        body = _unpacked(body)
        spend(len(body), 0)
    offset = 0
    budget = msgpack.Budget(msgpack.MOST)
    while offset < len(body):
        pair, offset, values = _pair(body, offset)
        budget.spend(values)
        spend(0, values)
        yield pair


def _unpacked(body):
    """What was compressed, in one part or in several. Raises Malformed."""
    import zlib

    octets = b""
    for _ in range(MOST_PARTS):
        stream = zlib.decompressobj(31)
        try:
            octets += stream.decompress(body, LARGEST - len(octets) + 1)
        except zlib.error as e:
            raise msgpack.Malformed(str(e))
        if len(octets) > LARGEST:
            raise msgpack.Malformed("unpacks to more than %d MB" % (LARGEST >> 20))
        if not stream.eof:
            raise msgpack.Malformed("torn")
        body = stream.unused_data
        if not body:
            return octets
    raise msgpack.Malformed("more than %d compressed parts" % MOST_PARTS)


def _pair(data, offset):
    """((time, record) at `offset`, where the next pair begins, how many values it has)"""
    budget = msgpack.Budget()
    pair, offset = msgpack.value(data, offset, budget=budget)
    if not isinstance(pair, list) or len(pair) != 2:
        raise msgpack.Malformed("not [time, record]")
    return pair, offset, budget.spent


def record_of(tag, when, fields, address):
    """(Source, Record) of a pair. OpenRTM's fields are name, level, host, manager, pid, time and message;
    those of others are shown as they are.
    """
    if isinstance(when, list) and when:  # [time, metadata]
        when = when[0]
    if not isinstance(when, (int, float)) or not abs(when) < 1e12:  # not a number is neither
        when = loop.wall()
    if not isinstance(fields, dict):
        fields = {"message": fields}
    texts = {}
    for key, value in fields.items():
        if isinstance(key, str):
            texts[key] = _text(value)
    host = texts.get("host") or address
    manager = texts.get("manager")
    where = f"{host}/{manager}" if manager else host
    message = texts.get("message", texts.get("log"))
    if message is None:
        message = " ".join("%s=%s" % item for item in texts.items())
    level = texts.get("level", "").strip().upper() or "NORMAL"
    name = texts.get("name") or _text(tag)
    where = where[:LONGEST]
    return Source(where, where), Record(when, name[:LONGEST], level[:LONGEST], _beginning(message))


def _beginning(message):
    """A message, or the beginning of one that is too long, with its length."""
    if len(message) <= LONGEST_MESSAGE:
        return message
    return f"{message[:LONGEST_MESSAGE]}… ({len(message)} characters)"


def _text(value):
    if isinstance(value, bytes):
        value = value.decode("utf-8", "surrogateescape")
    return str(value)


# ---- connections ----


class _Sender:
    """One connection: what has come of its next message."""

    def __init__(self, connection, address, account):
        self.connection = connection
        self.address = address
        self.account = account
        self.data = bytearray()
        self.scan = msgpack.Scan()
        self.heard = loop.now()
        self.begun = None  # when the message that has not all come began
        self.is_closed = False

    def close(self):
        """End the connection; the task that reads it ends, too."""
        self.is_closed = True
        try:
            self.connection.shutdown(real.ALL)
        except OSError:
            pass


class _Account:
    """What an address has sent: from when on it may send more."""

    def __init__(self):
        self._due = 0.0  # by loop.now(), if it had nothing ahead

    def spend(self, octets, values):
        self._due = max(self._due, loop.now() - AHEAD) + octets / OCTETS + values / VALUES

    def is_spent(self):
        """Whether it has to wait."""
        return self._due > loop.now()

    def is_idle(self):
        """Whether nothing is to be remembered of it."""
        return self._due < loop.now() - AHEAD


class Door:
    """Receives logs at a TCP port: `await door.serve(take)`, where take(Source, Record) gets each record.

    place     (host, port) where it listens, port 0 for any; then `port` is the one taken
    allowed   addresses of those who may send; empty: anybody who reaches it
    Raises Failed where it cannot listen. `close` it in the end.
    """

    def __init__(self, place, allowed=()):
        host, port = place
        self._allowed = set(allowed)
        if host == "0.0.0.0":
            host = ""  # IPv6, too
        self._socket = tcp.listen(host, port)
        if self._socket is None:
            where = printable(place[0])
            why = "is in use or needs a privilege, or this host has no such address"
            raise errors.Failed("--listen", f"TCP port {port} of {where} {why}")
        self.port = self._socket.getsockname()[1]
        notes.note(f"receiving logs at {printable(place[0])}, TCP port {self.port}")
        self._senders = set()
        self._refused = set()  # whose refusal has been reported
        self._accounts = {}  # by address

    def close(self):
        """Receive no more."""
        self._socket.close()

    async def serve(self, take, has_room=lambda: True):
        """Receive until the task is cancelled, and read on only while has_room()."""
        group = loop.Group()
        group.start(self._sweep())
        try:
            async with group:
                while True:
                    await loop.ready(self._socket.fileno(), loop.READ)
                    self._accept(group, take, has_room)
        finally:
            self.close()

    def _accept(self, group, take, has_room):
        try:
            connection, (address, *_) = self._socket.accept()
        except OSError:
            return
        address = address.replace("::ffff:", "", 1)
        if self._allowed and address not in self._allowed:
            connection.close()
            self._report(address, "may not send (--from)")
            return
        if len(self._senders) >= MOST_SENDERS:
            self._turn_away(self._senders)
        connection.setblocking(False)
        sender = _Sender(connection, address, self._account(address))
        self._senders.add(sender)
        group.start(self._receive(sender, take, has_room))

    def _account(self, address):
        if len(self._accounts) >= MOST_KNOWN:
            busy = [item for item in self._accounts.items() if not item[1].is_idle()]
            self._accounts = dict(busy)
        key = address
        if ":" in address:  # one host may have all addresses of a /64
            key = ipaddress.ip_address(address.partition("%")[0]).exploded[:19]
        return self._accounts.setdefault(key, _Account())

    def _turn_away(self, senders):
        """Close, of some senders, the one that has been silent longest, of the address that has most."""
        counts = collections.Counter(sender.address for sender in senders)
        longest = min(senders, key=lambda sender: (-counts[sender.address], sender.heard))
        self._report(longest.address, "turned away: more connections or octets than there is room for")
        self._senders.discard(longest)
        longest.close()

    def _report(self, address, why):
        if (address, why) not in self._refused and len(self._refused) < MOST_SENDERS:
            self._refused.add((address, why))
            notes.note(f"{address}: {why}")

    async def _receive(self, sender, take, has_room):
        async def pause():
            """Let others go on, and wait until there is room, and the sender may send more."""
            await loop.sleep(0)
            begun = sender.begun
            sender.begun = None  # it does not keep us waiting, but we it
            while not sender.is_closed and (sender.account.is_spent() or not has_room()):
                await loop.sleep(PAUSE)
            if sender.is_closed:
                raise EOFError
            if begun is not None:
                sender.begun = loop.now()

        with sender.connection:
            try:
                await self._read(sender, take, pause)
            except (msgpack.Malformed, struct.error, IndexError, UnicodeError) as e:
                self._report(sender.address, f"does not send logs as fluentd takes them ({e})")
            except (OSError, EOFError):
                pass
        self._senders.discard(sender)

    async def _read(self, sender, take, pause):
        while True:
            await pause()
            await loop.ready(sender.connection.fileno(), loop.READ)
            try:
                piece = sender.connection.recv(PIECE)
            except BlockingIOError:
                continue
            if not piece:
                return
            sender.account.spend(len(piece), 0)
            sender.heard = loop.now()
            if sender.begun is None:
                sender.begun = sender.heard
            sender.data += piece
            await self._take_messages(sender, take, pause)
            if len(sender.data) > LARGEST:
                raise msgpack.Malformed("a message of more than %d MB" % (LARGEST >> 20))
            if sum(len(other.data) for other in self._senders) > MOST_OCTETS:
                self._turn_away([other for other in self._senders if other.data])

    async def _take_messages(self, sender, take, pause):
        end = sender.scan.end(sender.data)
        while end is not None:
            sender.account.spend(0, sender.scan.seen)
            message = bytes(sender.data[:end])
            del sender.data[:end]
            sender.scan = msgpack.Scan()
            sender.begun = sender.heard if sender.data else None
            tag, records, options = pairs(message, sender.account.spend)
            for number, (when, fields) in enumerate(records, 1):
                take(*record_of(tag, when, fields, sender.address))
                if number % SLICE == 0:
                    await pause()
            await pause()
            _answer(sender.connection, options.get("chunk"))
            end = sender.scan.end(sender.data)

    async def _sweep(self):
        """Close the connections whose message does not come to its end."""
        while True:
            await loop.sleep(UNFINISHED / 10)
            now = loop.now()
            for sender in list(self._senders):
                if sender.begun is not None and now - sender.begun > UNFINISHED:
                    self._report(sender.address, "turned away: its message does not come to an end")
                    sender.close()


def _answer(connection, chunk):
    """Tell a sender that asks for it that a message has come; one that does not read that is not
    waited for.
    """
    if isinstance(chunk, str):
        chunk = chunk.encode("utf-8", "surrogateescape")
    if isinstance(chunk, bytes) and len(chunk) < 256:
        connection.send(b"\x81" + msgpack.text(b"ack") + msgpack.text(chunk))
