"""Reading logs in MCAP, ours and those of others: nothing in them is trusted, and everything that is whole is
read.
"""

import bisect
import collections
import json
import os
import zlib

from rtshell_lite import errors
from rtshell_lite.datalog import compression, gaps, mcap, schemas
from rtshell_lite.datalog.mcap import HEAD, LARGEST
from rtshell_lite.datalog.records import Channel, Entry

MOST = 1000  # sources of a channel: more are hostile
RUN = 1 << 20  # octets that are read at a time
LONGEST_NUMBER = 300  # digits of an integer
WORDS = 16 << 20  # octets of a schema, a channel or the like

# Where messages are: the offset of a chunk and the one after it, earliest and latest log time, the number of
# its first message, how many there are. `is_chunk` is False for messages that are in no chunk.
Stretch = collections.namedtuple("Stretch", "offset end first last number count is_chunk")


class Log:
    """An open log, to be used in a `with` statement.

    `channels`; `started` (ns since the epoch), `count`, `first` and `last` (the earliest and the latest
    arrival, or None), `counts` (by channel's name), `attachments` (log time, name, media type, offset of the
    data, size), `gaps` (gaps.Gaps), `torn` (octets of half a record at the end), `closed` (False: recording
    was killed, or goes on), and `damaged` (messages left out), which may grow while entries are read.
    """

    form = "mcap"
    work = None  # the notes.Work that counts the octets that have been read

    def __init__(self, file, where, size):
        """Find the channels and the messages. Raises errors.Failed."""
        self.where = where
        self.size = size
        self._file = file
        self._damaged = {}  # by offset: messages left out
        self._unread = {}  # by number: the encodings of messages whose CDR is not plain
        self.closed = False
        self._parses = True  # JSON
        self.started = None
        self.end = 0  # offset after the last whole record before the summary
        head = self._head(len(mcap.MAGIC))
        if head is None or head[0] != mcap.HEADER:
            raise errors.Failed(where, "its header is damaged, nothing can be read")
        summary = self._read_summary()
        if summary is None or not self._find_records(*summary):
            self._find_records({}, None, [])
        if self._compressed:
            raise errors.Failed(self.where, compression.refusal(self._compressed))
        if self.started is None:
            self.started = self.first or 0
        self.torn = 0 if self.closed else size - self.end
        self.gaps = self._find_gaps()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._file.close()

    first = property(
        lambda self: min((stretch.first for stretch in self._stretches if stretch.count), default=None)
    )
    last = property(
        lambda self: max((stretch.last for stretch in self._stretches if stretch.count), default=None)
    )
    damaged = property(lambda self: sum(self._damaged.values()))

    @property
    def counts(self):
        named = collections.Counter()
        for number, count in self._counts.items():
            if number in self._numbers:
                named[self.channels[self._numbers[number]].name] += count
        return dict(named)

    @property
    def count(self):
        if self._stretches:
            return self._stretches[-1].number + self._stretches[-1].count
        return 0

    def entries(self, start=0):
        """The entries from number `start` on, one by one."""
        index = bisect.bisect_right([stretch.number for stretch in self._stretches], start) - 1
        for stretch in self._stretches[max(index, 0) :]:
            self._reach(stretch.offset)
            for entry in self._messages(stretch):
                if entry.number >= start:
                    yield entry

    def _reach(self, offset):
        if self.work is not None:
            self.work.reach(offset)

    def octets(self, start=0):
        """The messages from number `start` on, for a LogWriter: (channel, received, little, data)."""
        self._parses = False
        try:
            for entry in self.entries(start):
                yield entry.channel, entry.received, entry.little, entry.data
        finally:
            self._parses = True

    def since(self, moment):
        """The number of the first entry that arrived at `moment` (ns) or later, or None."""
        for stretch in self._stretches:
            if stretch.last >= moment:
                for entry in self._messages(stretch):
                    if entry.received >= moment:
                        return entry.number
        return None

    def attached(self, attachment):
        """The data of one of `attachments`."""
        return self._octets(attachment[3], attachment[4])

    def notes(self):
        """What is wrong with the file, in words."""
        if self.torn:
            yield "the last %d octets are not a whole record and are left out" % self.torn
        elif not self.closed:
            yield "recording has not ended regularly, or goes on"
        if self.damaged:
            yield "%d damaged records are left out" % self.damaged
        for encoding, count in sorted(collections.Counter(self._unread.values()).items()):
            yield f"{count} messages are left out: their encoding {encoding} is not read"

    def _find_gaps(self):
        listed = []
        for kind, offset, end in self._others:
            if kind != mcap.METADATA or len(listed) >= gaps.MOST:
                continue
            try:
                name, texts = mcap.metadata(self._body(offset, end))
            except mcap.Damaged:
                continue
            if name == gaps.NAME:
                listed.append(gaps.from_texts(texts))
        return [gap for gap in listed if gap is not None]

    def contents(self):
        """(mcap.Contents, {schema: its id}, {(topic, schema, encoding, metadata): id of a channel}, the
        ChunkIndex records) of the file, to go on with it.
        """
        contents = mcap.Contents()
        for kind, offset, end in self._others:
            octets = self._octets(offset, end - offset)
            if kind == mcap.METADATA:
                contents.add_metadata(offset, end - offset, mcap.metadata(octets[HEAD.size :])[0])
            elif kind == mcap.ATTACHMENT:
                logged, name, media, _, size = mcap.attachment(octets[HEAD.size :])
                index = mcap.attachment_index(logged, name, media, size, offset, end - offset)
                contents.records[mcap.ATTACHMENT_INDEX].append(index)
        for (kind, _), body in sorted(self._defined.items()):
            contents.records[kind].append(mcap.record(kind, body))
        indexes = [self._index(stretch, contents) for stretch in self._stretches]
        ids = {schema: number for number, schema in self._schemas.items()}
        return contents, ids, dict(self._ids), indexes

    def sound_records(self):
        """The octets of all records up to `end`, one by one, without chunks that are damaged, and their
        indexes.
        """
        stretches = {stretch.offset: stretch for stretch in self._stretches}
        yield self._octets(0, len(mcap.MAGIC))
        offset = len(mcap.MAGIC)
        while offset < self.end:
            self._reach(offset)
            kind, end = self._head(offset) or (None, offset)
            if kind is None or end > self.end:  # what the summary says is not so
                self._damaged[offset] = 1
                offset = min((start for start in stretches if start > offset), default=self.end)
                continue
            if kind == mcap.CHUNK and not self._is_sound(offset, stretches):
                offset = self._indexes(end)[2]
                continue
            yield self._octets(offset, end - offset)
            offset = end

    def _is_sound(self, offset, stretches):
        """Whether the chunk at an offset is whole."""
        if offset in stretches:
            return self._records(stretches[offset]) is not None
        self._damaged[offset] = 1
        return False

    # ---- finding what is where ----

    def _octets(self, offset, length):
        if hasattr(os, "pread"):
            return os.pread(self._file.fileno(), length, offset)
        self._file.seek(offset)
        return self._file.read(length)

    def _head(self, offset):
        """(opcode, offset after the record) of the record at `offset`; None when there is no whole one."""
        octets = self._octets(offset, HEAD.size)
        if len(octets) < HEAD.size:
            return None
        kind, length = HEAD.unpack(octets)
        end = offset + HEAD.size + length
        if kind == 0 or end > self.size:
            return None
        return kind, end

    def _read_summary(self):
        """({offset of a chunk: (its length, messages, length of their indexes)}, {channel's id: messages},
        bodies of schemas and channels with their opcodes) as the end of the file says; None where it says
        nothing sound.
        """
        chunks = {}
        counted = None
        defined = []
        try:
            position = self._check_summary()
            while position < self.size - mcap.FOOT.size:
                kind, end = self._head(position) or (None, self.size)
                if kind == mcap.CHUNK_INDEX:
                    offset, length, indexes, size = mcap.chunk_index(self._body(position, end))
                    chunks[offset] = length, mcap.messages_indexed(len(indexes), size), size
                elif kind == mcap.STATISTICS:
                    counted = mcap.statistics(self._body(position, end))[1]
                elif kind in (mcap.SCHEMA, mcap.CHANNEL):
                    defined.append((kind, self._body(position, end)))
                position = end
        except mcap.Damaged:
            return None
        self.closed = True
        return chunks, counted, defined

    def _check_summary(self):
        """Where the summary begins, whose checksum is right. Raises Damaged."""
        start, expected = mcap.footer(self._octets(max(0, self.size - mcap.FOOT.size), mcap.FOOT.size))
        if start == 0:
            return self.size
        end = self.size - mcap.UNCHECKED
        crc = 0
        for offset in range(start, end, RUN):
            crc = zlib.crc32(self._octets(offset, min(RUN, end - offset)), crc)
        if start > end or expected and crc != expected:
            raise mcap.Damaged("a summary whose checksum is wrong")
        return start

    def _body(self, offset, end):
        if end - offset > WORDS:
            raise mcap.Damaged("a long record")
        return self._octets(offset + HEAD.size, end - offset - HEAD.size)

    def _find_records(self, chunks, counted, defined):
        """Find all records up to the end of the data, with the help of what _read_summary has returned; False
        when that is not so.
        """
        self.channels = []
        self.attachments = []
        self.started = None
        self._schemas = {}
        self._ids = {}
        self._defined = {}  # Schema and Channel records, in chunks or not: bodies by (opcode, id)
        self._numbers = {}  # our number of a channel, by its id
        self._indexes_by_type = {}  # the same, by its name and type
        self._counts = collections.Counter(counted)
        self._stretches = []
        self._others = []  # (opcode, begin, end) of Metadata and Attachment records
        self._compressed = None
        self.end = len(mcap.MAGIC)
        for kind, body in defined:
            self._define(kind, body)
        is_known = counted is not None
        kind = None
        while kind != mcap.DATA_END and not self._compressed:
            head = self._head(self.end)
            if head is None:
                break
            kind, end = head
            if kind == mcap.CHUNK:
                end = self._take_chunk(end, chunks.get(self.end), is_known)
            elif kind == mcap.MESSAGE:
                end = self._take_loose(end)
            elif kind != mcap.DATA_END:
                self._take_other(kind, end)
            if kind != mcap.DATA_END:
                self.end = end
        if kind != mcap.DATA_END:
            self._without_end()
        if is_known:
            return kind == mcap.DATA_END and sum(self._counts.values()) == self.count
        return True

    def _without_end(self):
        """The file ends in the middle. A last chunk that is damaged is what a power failure leaves; the
        messages of a sound one are counted, for its indexes may be cut off.
        """
        self.closed = False
        if not self._stretches or self._compressed:
            return
        last = self._stretches[-1]
        if self._records(last) is None:
            self._damaged.clear()
            self.end = last.offset
            self._stretches.pop()
            return
        counts = mcap.counts(self._times(last))
        if last.is_chunk and sum(counts.values()) != last.count:
            self._counts.subtract(self._indexes(last.end)[0])
            self._counts.update(counts)
            self._stretches[-1] = last._replace(count=sum(counts.values()))

    def _take_chunk(self, end, index, is_known):
        """Note the chunk at self.end; returns the offset after it and its indexes."""
        try:
            chunk = mcap.Chunk(self._octets(self.end, min(mcap.BEGINNING, end - self.end)))
        except mcap.Damaged:
            return end
        if chunk.compression and not compression.is_read(chunk.compression):
            self._compressed = chunk.compression
            return end
        is_sound = index is not None and index[0] == end - self.end and index[1] > 0
        if is_known and is_sound and end + index[2] <= self.size:
            self._add(end, chunk.first, chunk.last, index[1], True)
            return end + index[2]
        counts, _, after = self._indexes(end)
        if not counts or not set(counts) <= set(self._numbers):
            counts = self._look_inside(end, counts)
        if not is_known:
            self._counts.update(counts)
        self._add(end, chunk.first, chunk.last, sum(counts.values()), True)
        return after

    def _add(self, end, first, last, count, is_chunk):
        self._stretches.append(Stretch(self.end, end, first, last, self.count, count, is_chunk))

    def _indexes(self, offset):
        """({channel's id: messages} as the MessageIndex records at `offset` say, {id: their offsets}, the
        offset after them)
        """
        counts = collections.Counter()
        offsets = {}
        while True:
            head = self._head(offset)
            if head is None or head[0] != mcap.MESSAGE_INDEX or head[1] < offset + HEAD.size + 6:
                return counts, offsets, offset
            fields = self._octets(offset + HEAD.size, 6)
            channel = int.from_bytes(fields[:2], "little")
            counts[channel] += int.from_bytes(fields[2:], "little") // 16
            offsets[channel] = offset
            offset = head[1]

    def _look_inside(self, end, counts):
        """Take the schemas and channels within the chunk at self.end; returns its messages by
        channel's id.
        """
        octets = self._records(Stretch(self.end, end, 0, 0, 0, 0, True))
        if octets is None:
            return counts
        counts = collections.Counter()
        for kind, _, body, after in _walk(octets):
            if kind in (mcap.SCHEMA, mcap.CHANNEL):
                self._define(kind, octets[body:after])
            elif kind == mcap.MESSAGE:
                counts[int.from_bytes(octets[body : body + 2], "little")] += 1
        return counts

    def _take_loose(self, end):
        """Note the messages at self.end that are in no chunk; returns the offset after them."""
        times = []
        offset = self.end
        while offset - self.end < RUN:
            octets = self._octets(offset, mcap.MESSAGE_HEAD.size)
            if len(octets) < mcap.MESSAGE_HEAD.size:
                break
            kind, length, channel, _, moment, _ = mcap.MESSAGE_HEAD.unpack(octets)
            after = offset + HEAD.size + length
            if kind != mcap.MESSAGE or after > self.size or offset + mcap.MESSAGE_HEAD.size > after:
                break
            self._counts[channel] += 1
            times.append(moment)
            offset = after
        if not times:
            return end
        self._add(offset, min(times), max(times), len(times), False)
        return offset

    def _take_other(self, kind, end):
        """Take what a record outside of chunks says."""
        try:
            if kind in (mcap.SCHEMA, mcap.CHANNEL):
                self._define(kind, self._body(self.end, end))
                return
            if kind == mcap.METADATA:
                self._take_metadata(self._body(self.end, end))
            elif kind == mcap.ATTACHMENT:
                body = self._octets(self.end + HEAD.size, min(end - self.end, WORDS))
                logged, name, media, start, size = mcap.attachment(body)
                if start + size > end - self.end:
                    return
                self.attachments.append((logged, name, media, self.end + HEAD.size + start, size))
            else:
                return
            self._others.append((kind, self.end, end))
        except mcap.Damaged:
            pass

    def _take_metadata(self, body):
        name, texts = mcap.metadata(body)
        created = texts.get("created", "")
        if name == "rtlog" and self.started is None and created.isdecimal() and len(created) < 20:
            self.started = min(int(created), mcap.LATEST)

    def _define(self, kind, body):
        if kind == mcap.SCHEMA:
            number, schema = mcap.schema(body)
            if number == 0:  # a channel without a schema says so with it
                return
            self._schemas.setdefault(number, schema)
            self._defined.setdefault((kind, number), body)
            return
        number, schema_number, topic, encoding, about = mcap.channel(body)
        self._defined.setdefault((kind, number), body)
        if number in self._numbers:
            return
        schema = self._schemas.get(schema_number)
        self._ids.setdefault((topic, schema, encoding, tuple(sorted(about.items()))), number)
        channel = _make_channel(topic, schema, encoding, about)
        index = self._indexes_by_type.setdefault(channel[:2], len(self.channels))
        self._numbers[number] = index
        if index == len(self.channels):
            self.channels.append(channel)
            return
        other = self.channels[index]
        if other.sources != channel.sources and len(other.sources) < MOST:
            more = tuple(dict.fromkeys(other.sources + channel.sources))
            self.channels[index] = other._replace(sources=more[:MOST])

    # ---- messages ----

    def _records(self, stretch):
        """The octets of the records in a Stretch; None, which is counted, where they are damaged."""
        octets = None
        if stretch.end - stretch.offset <= LARGEST + (1 << 20):
            octets = self._octets(stretch.offset, stretch.end - stretch.offset)
        if octets is not None and stretch.is_chunk:
            octets = self._unpack(octets)
        if octets is None:
            self._damaged[stretch.offset] = max(stretch.count, 1)
        return octets

    def _unpack(self, octets):
        try:
            chunk = mcap.Chunk(octets)
        except mcap.Damaged:
            return None
        inner = memoryview(octets)[chunk.start : chunk.start + chunk.within]
        if len(inner) < chunk.within:
            return None
        if chunk.compression:  # by what is read, or the file is refused
            inner = compression.expand(inner, min(chunk.size, LARGEST))
        if inner is None or chunk.crc and zlib.crc32(inner) != chunk.crc:
            return None
        return bytes(inner)

    def _messages(self, stretch):
        octets = self._records(stretch)
        if octets is None:
            return
        number = stretch.number
        unpack = mcap.MESSAGE_HEAD.unpack_from
        start = mcap.MESSAGE_HEAD.size
        for kind, offset, _, end in _walk(octets):
            if kind != mcap.MESSAGE:
                continue
            if end - offset < start:
                self._damaged[-1 - number] = 1
                continue
            _, _, channel, _, moment, _ = unpack(octets, offset)
            entry = self._entry(number, moment, channel, octets[offset + start : end])
            number += 1
            if entry:
                yield entry

    def _entry(self, number, moment, channel, data):
        ours = self._numbers.get(channel)
        if ours is None or moment > mcap.LATEST:
            self._damaged[-1 - number] = 1
            return None
        encoding = self.channels[ours].encoding
        if encoding == "json" and self._parses:
            return self._parse(number, moment, ours, data)
        if encoding != "cdr":
            return Entry(number, moment, ours, True, data, None)
        prefix = data[:4]
        if prefix[:2] not in (b"\0\0", b"\0\1"):
            self._unread[number] = prefix[:2].hex() or "none"
            return None
        return Entry(number, moment, ours, prefix[1] == 1, data[4:], None)

    def _parse(self, number, moment, ours, data):
        try:
            value = json.loads(data.decode("utf-8"), parse_int=_integer)
            return Entry(number, moment, ours, None, None, value)
        except (ValueError, RecursionError):
            self._damaged[-1 - number] = 1
            return None

    def _index(self, stretch, contents):
        """The ChunkIndex of a Stretch, which is counted in `contents`; b"" for messages in no chunk."""
        counts, offsets, after = self._indexes(stretch.end)
        if not stretch.is_chunk or sum(counts.values()) != stretch.count:
            counts = mcap.counts(self._times(stretch))
            offsets = {}
            after = stretch.end
        contents.add_chunk(stretch.first, stretch.last, counts)
        if not stretch.is_chunk:
            contents.chunks -= 1
            return b""
        chunk = mcap.Chunk(self._octets(stretch.offset, min(mcap.BEGINNING, stretch.end - stretch.offset)))
        length = stretch.end - stretch.offset
        return mcap.chunk_index_record(chunk, stretch.offset, length, offsets, after - stretch.end)

    def _times(self, stretch):
        """{channel's id: [log time, offset in the chunk, log time, …]} of the messages in a Stretch"""
        octets = self._records(stretch) or b""
        times = {}
        for kind, offset, _, end in _walk(octets):
            if kind == mcap.MESSAGE and end - offset >= mcap.MESSAGE_HEAD.size:
                _, _, channel, _, moment, _ = mcap.MESSAGE_HEAD.unpack_from(octets, offset)
                times.setdefault(channel, []).extend((moment, offset))
        return times

    def lacking(self):
        """(offset, octets) of the MessageIndex records of the last chunk, which has not all of its own; None:
        it has.
        """
        if not self._stretches or not self._stretches[-1].is_chunk:
            return None
        stretch = self._stretches[-1]
        if sum(self._indexes(stretch.end)[0].values()) == stretch.count:
            return None
        return stretch.end, mcap.message_indexes(self._times(stretch), stretch.end)[0]


def _integer(digits):
    """An integer of JSON; a longer one takes long to read, and no number of a message is one."""
    if len(digits) > LONGEST_NUMBER:
        raise ValueError("a number that cannot be")
    return int(digits)


def _walk(octets):
    """The records of a chunk as mcap.walk gives them, as far as they are whole."""
    try:
        yield from mcap.walk(octets)
    except mcap.Damaged:
        pass


def _make_channel(topic, schema, encoding, about):
    """The Channel for what a file says; one that we wrote describes its type, and where it comes from."""
    description = about.get("description", "").encode("ascii", "replace")
    try:
        sources = json.loads(about.get("sources", "[]"))
    except (ValueError, RecursionError):
        sources = []
    if not isinstance(sources, list):
        sources = []
    sources = tuple(source for source in sources[:MOST] if isinstance(source, str))
    more = tuple(sorted((k, v) for k, v in about.items() if k not in ("type", "description", "sources")))
    if "type" in about:
        return Channel(topic, about["type"], description, sources, encoding, None, more)
    if schema is None:
        return Channel(topic, "", b"", sources, encoding, None, more)
    identifier = schemas.type_id(schema[0]) if encoding == "cdr" else schema[0]
    return Channel(topic, identifier, b"", sources, encoding, schema, more)
