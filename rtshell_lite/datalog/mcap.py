"""The format MCAP: octets to records, and records to octets. Nothing here reads or writes a file.

A file is a magic word, records, the same magic word. A record: opcode (1 octet), length (uint64), body. All
numbers are little-endian. The names are those of MCAP's specification.
"""

import collections
import struct
import zlib

MAGIC = b"\x89MCAP0\r\n"
HEADER, FOOTER, SCHEMA, CHANNEL, MESSAGE, CHUNK, MESSAGE_INDEX, CHUNK_INDEX = range(1, 9)
ATTACHMENT, ATTACHMENT_INDEX, STATISTICS, METADATA, METADATA_INDEX, SUMMARY_OFFSET, DATA_END = range(9, 16)

HEAD = struct.Struct("<BQ")  # opcode, length of the body
MESSAGE_HEAD = struct.Struct("<BQHIQQ")  # with its HEAD: channel, sequence, log time, publish time
CHUNK_HEAD = struct.Struct("<QQQI")  # earliest and latest log time, size and CRC-32 of the records
FOOT = struct.Struct("<BQQQI8s")  # Footer with its HEAD: start of the summary, of its offsets, CRC-32; MAGIC
UNCHECKED = 12  # octets at the end of a file that the CRC-32 of its summary does not count
BEGINNING = 80  # octets of a chunk that are enough for its HEAD and CHUNK_HEAD and the name of a compression
CHUNK_SIZE = 1 << 20  # octets of messages in a chunk
LARGEST = 256 << 20  # octets of a message or a chunk; longer ones are not written, and not read
LITTLE = b"\0\1\0\0"  # in front of plain CDR
BIG = b"\0\0\0\0"
PREFIXES = {True: LITTLE, False: BIG}
NEVER = (1 << 64) - 1
LATEST = (1 << 63) - 1  # of times that are believed, ns

_TIMES = struct.Struct("<QQ")
_NUMBER = struct.Struct("<Q")
_SHORT = struct.Struct("<H")
_LENGTH = struct.Struct("<I")
_COUNTS = struct.Struct("<QHIIIIQQ")
_CHUNK_PLACE = struct.Struct("<QQQQ")


class Damaged(Exception):
    """These octets are not a whole record of their kind."""


# ---- octets to records ----


class Fields:
    """The fields of a record's body, in their order. All methods raise Damaged where the body ends
    too early.
    """

    def __init__(self, body):
        self.body = body
        self.at = 0

    def octets(self, length):
        end = self.at + length
        if end > len(self.body):
            raise Damaged("a record ends too early")
        taken = self.body[self.at : end]
        self.at = end
        return taken

    def unpack(self, layout):
        """The numbers of a struct.Struct."""
        return layout.unpack(self.octets(layout.size))

    def number(self):
        return self.unpack(_NUMBER)[0]

    def short(self):
        return self.unpack(_SHORT)[0]

    def blob(self):
        """Octets with their length (uint32) in front."""
        return self.octets(self.unpack(_LENGTH)[0])

    def string(self):
        """Text, with whatever is not UTF-8 as surrogate escapes."""
        return self.blob().decode("utf-8", "surrogateescape")

    def texts(self):
        """A map of texts."""
        return self._map(Fields.string, Fields.string)

    def numbers(self):
        """A map of uint16 to uint64."""
        return self._map(Fields.short, Fields.number)

    def _map(self, key, value):
        inner = Fields(self.blob())
        pairs = {}
        while inner.at < len(inner.body):
            name = key(inner)
            pairs[name] = value(inner)
        return pairs


class Chunk:
    """What a chunk says of itself: `first` and `last` log time, `size` and `crc` of its records (0: none),
    their `compression`, and how many octets they take `within` the record, `place` octets after its begin.
    """

    def __init__(self, start):
        """`start`: octets of the record from its HEAD on, BEGINNING or all. Raises Damaged."""
        fields = Fields(start)
        fields.octets(HEAD.size)
        self.first, self.last, self.size, self.crc = fields.unpack(CHUNK_HEAD)
        self.compression = fields.string()
        self.within = fields.number()
        self.start = fields.at


def schema(body):
    """(id, (name, encoding, data)) of a Schema's body. Raises Damaged."""
    fields = Fields(body)
    return fields.short(), (fields.string(), fields.string(), bytes(fields.blob()))


def channel(body):
    """(id, schema's id or 0, topic, encoding of its messages, metadata) of a Channel's body. Raises
    Damaged.
    """
    fields = Fields(body)
    return fields.short(), fields.short(), fields.string(), fields.string(), fields.texts()


def metadata(body):
    """(name, texts) of a Metadata's body. Raises Damaged."""
    fields = Fields(body)
    return fields.string(), fields.texts()


def attachment(body):
    """(log time, name, media type, place of the data in the body, its length) of an Attachment. Raises
    Damaged.
    """
    fields = Fields(body)
    logged, _ = fields.unpack(_TIMES)
    name = fields.string()
    kind = fields.string()
    size = fields.number()
    return logged, name, kind, fields.at, size


def statistics(body):
    """(messages, {channel's id: messages}) of Statistics. Raises Damaged."""
    fields = Fields(body)
    return fields.unpack(_COUNTS)[0], fields.numbers()


def chunk_index(body):
    """(offset of the chunk, its length, {channel's id: offset of its MessageIndex}, length of all these).
    Raises Damaged.
    """
    fields = Fields(body)
    _, _, offset, length = fields.unpack(_CHUNK_PLACE)
    offsets = fields.numbers()
    return offset, length, offsets, fields.number()


def footer(end):
    """(where the summary of a file begins, its CRC-32 or 0); `end`: its last FOOT.size octets. Raises
    Damaged.
    """
    if len(end) < FOOT.size:
        raise Damaged("no footer")
    kind, length, start, _, crc, magic = FOOT.unpack(end)
    if kind != FOOTER or length != 20 or magic != MAGIC:
        raise Damaged("no footer")
    return start, crc


def messages_indexed(count, length):
    """How many messages a chunk has whose MessageIndex records, of which there are `count`, take `length`
    octets.
    """
    return (length - (HEAD.size + 6) * count) // 16


def walk(octets):
    """(opcode, begin of the record, begin of its body, end) of the records in a chunk. Raises Damaged."""
    offset = 0
    size = len(octets)
    unpack = HEAD.unpack_from
    head = HEAD.size
    while offset < size:
        if offset + head > size:
            raise Damaged("a record ends too early")
        kind, length = unpack(octets, offset)
        end = offset + head + length
        if end > size:
            raise Damaged("a record ends too early")
        yield kind, offset, offset + head, end
        offset = end


# ---- records to octets ----


def record(kind, *parts):
    """A record of these parts of a body."""
    body = b"".join(parts)
    return HEAD.pack(kind, len(body)) + body


def blob(data):
    return _LENGTH.pack(len(data)) + data


def string(text):
    return blob(text.encode("utf-8", "surrogateescape"))


def texts(values):
    """A map of texts."""
    return blob(b"".join(string(name) + string(values[name]) for name in sorted(values)))


def _numbers(values):
    return blob(b"".join(_SHORT.pack(name) + _NUMBER.pack(values[name]) for name in sorted(values)))


def header(library):
    return record(HEADER, string(""), string(library))


def schema_record(number, name, encoding, data):
    return record(SCHEMA, _SHORT.pack(number), string(name), string(encoding), blob(data))


def channel_record(number, schema_number, topic, encoding, values):
    return record(
        CHANNEL, _SHORT.pack(number), _SHORT.pack(schema_number), string(topic), string(encoding),
        texts(values),
    )


def metadata_record(name, values):
    return record(METADATA, string(name), texts(values))


def attachment_record(moment, name, kind, data):
    body = _TIMES.pack(moment, moment) + string(name) + string(kind) + _NUMBER.pack(len(data)) + data
    return record(ATTACHMENT, body, _LENGTH.pack(zlib.crc32(body)))


def attachment_index(moment, name, kind, size, offset, length):
    """The AttachmentIndex of an attachment of `size` octets, whose record is at `offset` and takes
    `length`.
    """
    numbers = struct.pack("<QQQQQ", offset, length, moment, moment, size)
    return record(ATTACHMENT_INDEX, numbers, string(name), string(kind))


class Packer:
    """Messages that become a chunk: `size` octets so far."""

    compression = ""
    within = property(lambda self: self.size)

    def __init__(self):
        self.parts = []
        self.size = 0
        self.first = NEVER
        self.last = 0
        self.times = {}  # by channel's id: [log time, offset, log time, offset, …]

    def add(self, channel, sequence, moment, published, prefix, data):
        """Add a message, whose data are `prefix` and `data`."""
        length = 22 + len(prefix) + len(data)
        head = MESSAGE_HEAD.pack(MESSAGE, length, channel, sequence & 0xFFFFFFFF, moment, published)
        self.parts += (head + prefix, data)
        if channel in self.times:
            self.times[channel] += (moment, self.size)
        else:
            self.times[channel] = [moment, self.size]
        self.size += HEAD.size + length
        if moment < self.first:
            self.first = moment
        if moment > self.last:
            self.last = moment

    def records(self, pieces, offset):
        """(the chunk at `offset` and its message indexes as a list of octets, the ChunkIndex for it).

        `pieces` are the parts, the small ones joined.
        """
        crc = 0
        for piece in pieces:
            crc = zlib.crc32(piece, crc)
        within = CHUNK_HEAD.pack(self.first, self.last, self.size, crc) + string("") + _NUMBER.pack(self.size)
        length = HEAD.size + len(within) + self.size
        indexes, offsets = message_indexes(self.times, offset + length)
        octets = [HEAD.pack(CHUNK, len(within) + self.size) + within] + pieces + [indexes]
        return octets, chunk_index_record(self, offset, length, offsets, len(indexes))


def counts(times):
    """{channel's id: messages} of {channel's id: [log time, offset, log time, offset, …]}."""
    return {channel: len(flat) // 2 for channel, flat in times.items()}


def message_indexes(times, offset):
    """(the MessageIndex records at `offset` for the messages of a chunk, {channel's id: where its record
    is}); `times`: {channel's id: [log time, offset in the chunk, log time, …]}
    """
    indexes = []
    offsets = {}
    for channel in sorted(times):
        flat = times[channel]
        indexes.append(
            record(MESSAGE_INDEX, struct.pack("<HI%dQ" % len(flat), channel, 8 * len(flat), *flat))
        )
        offsets[channel] = offset
        offset += len(indexes[-1])
    return b"".join(indexes), offsets


def chunk_index_record(chunk, offset, length, offsets, indexes):
    """The ChunkIndex of a Chunk or Packer that is at `offset` and takes `length` octets; its MessageIndex
    records are at `offsets`, by channel's id, and take `indexes` octets.
    """
    return record(
        CHUNK_INDEX, _CHUNK_PLACE.pack(chunk.first, chunk.last, offset, length), _numbers(offsets),
        _NUMBER.pack(indexes), string(chunk.compression), _TIMES.pack(chunk.within, chunk.size),
    )


class Contents:
    """What a file holds, for the summary at its end: records by opcode, and counts."""

    def __init__(self):
        self.records = {SCHEMA: [], CHANNEL: [], ATTACHMENT_INDEX: [], METADATA_INDEX: []}
        self.counts = collections.Counter()  # messages by channel's id
        self.chunks = 0
        self.first = NEVER
        self.last = 0

    def add_metadata(self, offset, length, name):
        self.records[METADATA_INDEX].append(record(METADATA_INDEX, _TIMES.pack(offset, length), string(name)))

    def add_chunk(self, first, last, counts):
        """Count a chunk with these numbers of messages by channel."""
        self.chunks += 1
        self.first = min(self.first, first)
        self.last = max(self.last, last)
        self.counts.update(counts)

    def statistics(self):
        messages = sum(self.counts.values())
        sizes = [len(self.records[kind]) for kind in (SCHEMA, CHANNEL, ATTACHMENT_INDEX, METADATA_INDEX)]
        times = (self.first, self.last) if messages else (0, 0)
        return record(STATISTICS, _COUNTS.pack(messages, *sizes, self.chunks, *times), _numbers(self.counts))


class Closing:
    """The records that end a file, from `offset` on, in portions: `begin`, the ChunkIndex records, `end`."""

    def __init__(self, contents, offset):
        self._groups = []
        data_end = record(DATA_END, _LENGTH.pack(0))
        self._summary = offset + len(data_end)
        self._crc = 0
        self._at = self._summary
        kept = contents.records
        portions = [self._group(kind, b"".join(kept[kind])) for kind in (SCHEMA, CHANNEL)]
        portions.append(self._group(STATISTICS, contents.statistics()))
        portions += [self._group(kind, b"".join(kept[kind])) for kind in (ATTACHMENT_INDEX, METADATA_INDEX)]
        self.begin = data_end + b"".join(portions)
        self._chunks_at = self._at

    def _group(self, kind, data):
        if data:
            self._groups.append((kind, self._at, len(data)))
        return self._take(data)

    def _take(self, data):
        self._crc = zlib.crc32(data, self._crc)
        self._at += len(data)
        return data

    chunk_indexes = _take

    def end(self):
        """The rest, after the ChunkIndex records have gone through `chunk_indexes`."""
        if self._at > self._chunks_at:
            self._groups.append((CHUNK_INDEX, self._chunks_at, self._at - self._chunks_at))
        offsets_at = self._at
        offsets = b"".join(record(SUMMARY_OFFSET, struct.pack("<BQQ", *group)) for group in self._groups)
        start = HEAD.pack(FOOTER, 20) + _TIMES.pack(self._summary, offsets_at)
        self._take(offsets + start)
        return offsets + start + _LENGTH.pack(self._crc) + MAGIC
