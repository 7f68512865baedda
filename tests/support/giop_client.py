"""What others than our own ORB send: GIOP by hand, right and wrong; and servants of ours that receive it."""
import struct

from rtshell_lite.giop import descriptors, idl, messages, requests

PORT_OK = descriptors.items(idl.descriptor("IDL:OpenRTM/PortStatus:1.0"))[0]


class Port:
    """A servant that keeps what it is given."""

    interface = "OpenRTM.InPortCdr"

    def __init__(self):
        self.taken = []

    def put(self, data):
        if data == b"raise":
            raise LookupError("a fault of ours")
        self.taken.append(data)
        return PORT_OK


class Observer:
    """A servant of an interface that inherits, with an operation that is oneway."""

    interface = "OpenRTM.ComponentObserver"

    def __init__(self):
        self.heard = []

    def update_status(self, kind, hint):
        self.heard.append((kind._n, hint))


def request(key, operation, body=b"", number=1, minor=2, order="<", is_answered=True, contexts=b"",
            kind=requests.REQUEST):
    """A Request, or a LocateRequest, as octets. `contexts`: octets of one service context, which is ignored.
    """
    out = bytearray(messages.HEADER)

    def align(size):
        out.extend(b"\xee" * (-len(out) % size))  # padding is what happens to be in memory

    def put(value):
        align(4)
        out.extend(struct.pack(order + "I", value))

    def put_octets(data):
        put(len(data))
        out.extend(data)

    def put_contexts():
        put(bool(contexts))
        if contexts:
            put(7)
            put_octets(contexts)

    asks = kind == requests.REQUEST
    if asks and minor < 2:
        put_contexts()
    put(number)
    if asks:
        out.append(3 * is_answered if minor == 2 else is_answered)
    if minor == 2:
        align(4)
        out.extend(struct.pack(order + "H", 0))
    put_octets(key)
    if asks:
        put_octets(operation.encode() + b"\0")
    if asks and minor < 2:
        put_octets(b"who")
    elif asks:
        put_contexts()
    if body:
        align(4 if minor < 2 or not asks else 8)
    return messages.whole(kind, bytes(out[messages.HEADER:]) + body, minor, order)


def block(data, order="<"):
    return struct.pack(order + "I", len(data)) + data


def text(words, order="<"):
    return block(words.encode() + b"\0", order)


def answer(number, body=b"\0", status=0, minor=2, order="<"):
    """A reply, whole."""
    head = struct.pack(order + "II", number, status)
    head = head + bytes(4) if minor == 2 else bytes(4) + head
    return messages.whole(messages.REPLY, head + body, minor, order)


def fragments(message, *cuts):
    """A message as one with fragments, cut at these places."""
    order = "<" if message[6] & 1 else ">"
    minor = message[5]
    number = message[12:16] if minor == 2 else b""
    first, *others = [message[a:b] for a, b in zip((12,) + cuts, cuts + (len(message),))]
    found = [messages.whole(message[7], first, minor, order, bool(others))]
    for left, part in zip(reversed(range(len(others))), others):
        found.append(messages.whole(messages.FRAGMENT, number + part, minor, order, left > 0))
    return found
