"""GIOP messages as octets (CORBA 3.0, 15.4): requests to send, replies taken apart."""

import struct

from rtshell_lite.records import cached

# kinds of messages; a request is 0
REPLY = 1
CLOSE = 5
ERROR = 6
FRAGMENT = 7
# what a reply says
NO_EXCEPTION, USER_EXCEPTION, SYSTEM_EXCEPTION, FORWARD, FORWARD_PERM, NEEDS_ADDRESSING_MODE = range(6)
ANSWERED = 3  # response flags of a request whose reply is waited for (CORBA 3.0, 15.4.2.1)
KEY, PROFILE, REFERENCE = range(3)  # how a request names its object
HEADER = 12  # octets
LARGEST = 32 << 20  # octets of a message, as we let omniORB take
# of a reply without data; 10,000 long names take half of it, and a million empty values 4 s of CPU
LARGE = 4 << 20
MOST_CONTEXTS = 64  # service contexts of a message; real ones have up to four
# flags of a message
MORE = 2
LITTLE = 1
# The service context without which peers send no wide text: ISO 8859-1, so that octets stay as they are, and
# UTF-16.
_CODE_SETS = struct.pack("<IIIIII", 1, 1, 12, 1, 0x00010001, 0x00010109)
_LENGTH = struct.Struct("<I")
_START = struct.Struct("<8sIIIHH")
_PLAIN = b"GIOP\1\2\1\1"
_PLAIN_HEAD = struct.Struct("<8sIIII")
_PADDING = [b"", b"\0\0\0", b"\0\0", b"\0"]
_ORDERS = [tuple(struct.Struct(order + count * "I") for count in (1, 2, 3)) for order in "><"]
_HEADERS = [struct.Struct(order + "5s3BI") for order in "><"]


class Garbled(ValueError):
    """Octets that are no GIOP."""


class Misunderstood(Garbled):
    """The peer says that it did not understand us; it speaks GIOP 1.`minor`."""

    def __init__(self, minor):
        super().__init__("the peer did not understand us")
        self.minor = minor


def aligned(data, size):
    """`data` with zeros up to a multiple of `size`."""
    return data + b"\0" * (-len(data) % size)


@cached(256)
def _named(operation, is_new):
    """The name of an operation, and what follows:
    service contexts, or that there is no principal, before GIOP 1.2.
    """
    name = aligned(_LENGTH.pack(len(operation) + 1) + operation.encode("latin-1") + b"\0", 4)
    return name + (_CODE_SETS if is_new else bytes(4))


def request(number, version, mode, target, operation, arguments, is_oneway=False):
    """A request as a bytearray, to a `target` in the octets of that mode; before GIOP 1.2, the mode is KEY.

    `arguments`: (function that appends to it in little endian, value) pairs. Of `is_oneway` no reply comes.
    """
    is_new = version >= (1, 2)
    if is_new:
        flags = 0 if is_oneway else ANSWERED
        out = bytearray(_START.pack(b"GIOP\1\2\1\0", 0, number, flags, mode, 0))
    else:
        is_answered = b"\0\0\0\0" if is_oneway else b"\1\0\0\0"
        out = bytearray(b"GIOP" + bytes(version) + b"\1\0" + bytes(8) + _LENGTH.pack(number) + is_answered)
    out += target + _PADDING[len(target) & 3] + _named(operation, is_new)
    if arguments:
        if is_new:
            out += b"\0" * (-len(out) % 8)
        for write, value in arguments:
            write(out, value)
    _LENGTH.pack_into(out, 8, len(out) - HEADER)
    return out


def is_newest(request):
    """Whether a request is of GIOP 1.2."""
    return request[5] == 2


def renumber(request, number):
    """Put another number into a request of GIOP 1.2."""
    _LENGTH.pack_into(request, HEADER, number)


def plain_reply(data, number):
    """Where the results begin if `data` are just the reply to a request, whole, in little endian, without an
    exception or contexts, as almost all are; else 0.
    """
    if len(data) < _PLAIN_HEAD.size:
        return 0
    if _PLAIN_HEAD.unpack_from(data) != (_PLAIN, len(data) - HEADER, number, NO_EXCEPTION, 0):
        return 0
    return _PLAIN_HEAD.size


def whole(kind, payload=b"", minor=2, order="<", more=False):
    """A message of GIOP 1.`minor` in a byte order; `more`: fragments of it follow."""
    flags = LITTLE if order == "<" else 0
    if more:
        flags |= MORE
    return b"GIOP\1" + bytes([minor, flags, kind]) + struct.pack(order + "I", len(payload)) + payload


def size(data, start=0):
    """How many octets follow the header at a place of `data`. Raises Garbled."""
    magic, minor, _, kind, octets = _HEADERS[data[start + 6] & LITTLE].unpack_from(data, start)
    if magic != b"GIOP\1" or minor > 2 or kind > FRAGMENT:
        raise Garbled("not GIOP")
    if octets > LARGEST:
        raise Garbled(f"a message of {octets} octets")
    return octets


def number(data):
    """The request id of a message of GIOP 1.2. Raises struct.error."""
    return _ORDERS[data[6] & LITTLE][0].unpack_from(data, HEADER)[0]


def reply(data):
    """(request id, status, little endian, where its body begins) of a reply, given whole.
    Raises Garbled, struct.error.
    """
    little = data[6] & LITTLE
    ulong, two, three = _ORDERS[little]
    if data[5] < 2:
        offset = after_contexts(data, HEADER, ulong)
        number, status = two.unpack_from(data, offset)
        return number, status, little, offset + 8
    number, status, contexts = three.unpack_from(data, HEADER)
    if not contexts:
        return number, status, little, HEADER + 12  # which is a multiple of 8
    offset = after_contexts(data, HEADER + 8, ulong)
    return number, status, little, offset + -offset % 8


def after_contexts(data, offset, ulong):
    """Where the service contexts at `offset` end; `ulong` reads a number in their byte order.
    Raises Garbled, struct.error.
    """
    offset += -offset % 4
    (count,) = ulong.unpack_from(data, offset)
    if count > MOST_CONTEXTS:
        raise Garbled(f"{count} service contexts")
    offset += 4
    for _ in range(count):
        (size,) = ulong.unpack_from(data, offset + 4 + -offset % 4)
        offset += -offset % 4 + 8 + size
        if offset > len(data):
            raise Garbled("service contexts without an end")
    return offset + -offset % 4


class Fragments:
    """Messages that come in parts.

    begun   the parts of each so far, by request id; None is the id before GIOP 1.2
    size    octets of them all
    """

    def __init__(self):
        self.begun = {}
        self.size = 0

    def joined(self, data, most):
        """A message, whole; None while parts of it must come. Raises Garbled, struct.error.

        `most(id)` gives how many octets a message may have, of a longer one no more is kept than shows that;
        or raises Garbled.
        """
        is_first = data[7] != FRAGMENT
        more = data[6] & MORE
        if is_first and not more:
            return data
        is_numbered = data[5] == 2
        # without numbers, parts follow at once
        number_of_it = number(data) if is_numbered else None
        if is_first == (number_of_it in self.begun) or data[5] == 0:
            raise Garbled("fragments that make no message")
        begun = self.begun.setdefault(number_of_it, bytearray())
        part = data if is_first else data[HEADER + 4 * is_numbered :]
        part = part[: max(0, most(number_of_it) + 1 - len(begun))]
        begun += part
        self.size += len(part)
        if self.size > LARGEST:
            raise Garbled(f"more than {LARGEST} octets")
        if more:
            return None
        self.forget(number_of_it)
        return bytes(begun)

    def forget(self, number):
        """No more parts will come."""
        self.size -= len(self.begun.pop(number, b""))
