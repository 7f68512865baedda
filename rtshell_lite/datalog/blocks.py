"""The blocks of a log file: kind, length, checksum, body. The package's docstring describes the format."""

import struct
import zlib

MAGIC = b"\x89RTLOG\r\n"  # like PNG's: not text, and changed by whatever translates line ends
HEADER = b"H"
RECORD = b"R"
INDEX = b"I"
BLOCK = struct.Struct("<cII")  # kind, length of the body, CRC-32 of both and of the body
ENTRY = struct.Struct("<QqHB")  # number, time of arrival (ns since the epoch), channel, flags
FOOTER = struct.Struct("<Q8s")  # where the index begins, _END
LITTLE = 1  # flag: the data is little-endian
LARGEST = 256 << 20  # octets of a message; longer ones are not written, and a greater length is damage
WORDS = 4 << 20  # octets of a header or an index

_START = struct.Struct("<cI")
_END = b"rtlogend"


class Damaged(Exception):
    """There is no whole block at this place of a file."""


class Unsound(Damaged):
    """A record whose checksum is wrong; args[0] is the block's length, which may be wrong, too."""


def frame(kind, *body):
    """A block as a list of bytes, which are not joined: messages may be long."""
    length = sum(map(len, body))
    crc = zlib.crc32(_START.pack(kind, length))
    for part in body:
        crc = zlib.crc32(part, crc)
    return [BLOCK.pack(kind, length, crc)] + list(body)


def entry(number, received, channel, little, data):
    """The block of a message, a list of bytes."""
    return frame(RECORD, ENTRY.pack(number, received, channel, LITTLE if little else 0), data)


def text(kind, value, footer_at=None):
    """A block whose body is JSON; that of the index ends with the offset at which the block begins."""
    import json  # which Debian's python3-minimal lacks

    body = [json.dumps(value, sort_keys=True).encode("ascii")]
    if footer_at is not None:
        body.append(FOOTER.pack(footer_at, _END))
    return b"".join(frame(kind, *body))


def read(file, left):
    """Read a block of at most `left` octets at the file's position: (kind, body). Raises Damaged."""
    kind, length, crc = _head(file, left)
    body = file.read(length)
    if len(body) < length:
        raise Damaged("no whole block")
    if zlib.crc32(body, zlib.crc32(_START.pack(kind, length))) != crc:
        raise Unsound(BLOCK.size + length) if kind == RECORD else Damaged("no sound block")
    if kind == RECORD and length < ENTRY.size:
        raise Damaged("a record without a head")
    return kind, body


def read_number(file, left):
    """The number of the record at the file's position; the rest of it is not checked. Raises Damaged."""
    kind, length, _ = _head(file, left)
    if kind != RECORD or length < ENTRY.size:
        raise Damaged("no record")
    return ENTRY.unpack(file.read(ENTRY.size))[0]


def _head(file, left):
    head = file.read(BLOCK.size)
    if len(head) < BLOCK.size:
        raise Damaged("no whole block")
    kind, length, crc = BLOCK.unpack(head)
    most = {RECORD: ENTRY.size + LARGEST, HEADER: WORDS, INDEX: WORDS}.get(kind, -1)
    if length > min(most, left - BLOCK.size):
        raise Damaged("no block")
    return kind, length, crc


def index_position(file, size):
    """Where a file of `size` octets says that its index begins, or None."""
    if size < len(MAGIC) + BLOCK.size + FOOTER.size:
        return None
    file.seek(size - FOOTER.size)
    position, end = FOOTER.unpack(file.read(FOOTER.size))
    if end == _END and position < size:
        return position
    return None


def parsed(body, footer=False):
    """The JSON value of a block's body. Raises Damaged, also for hostile nesting."""
    import json

    try:
        return json.loads((body[: -FOOTER.size] if footer else body).decode("ascii"))
    except (ValueError, RecursionError):
        raise Damaged("no JSON in a block of text")
