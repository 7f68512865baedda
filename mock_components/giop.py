"""GIOP and CDR by hand, for peers that misbehave in ways that no ORB supports."""
import collections
import struct

from rtshell_lite.giop import messages, references, requests

COMPONENT = "IDL:openrtm.aist.go.jp/OpenRTM/DataFlowComponent:1.0"
MANAGER = "IDL:RTM/Manager:1.0"
CONTEXT = "IDL:omg.org/CosNaming/NamingContext:1.0"

REQUEST, REPLY, LOCATE_REQUEST, LOCATE_REPLY, FRAGMENT = 0, 1, 3, 4, 7
LITTLE, MORE = 1, 2  # flags of a message
NO_EXCEPTION, SYSTEM_EXCEPTION = 0, 2

Request = collections.namedtuple("Request", "version type id expects_reply key operation arguments")


class Reader:
    """Takes CDR values out of bytes; positions count from the start of the GIOP message, as alignment does.
    """

    def __init__(self, data, little, position=12):
        self.data = data
        self.order = "<" if little else ">"
        self.position = position

    def number(self, code="I"):
        size = struct.calcsize(code)
        self.position += -self.position % size
        value, = struct.unpack_from(self.order + code, self.data, self.position)
        self.position += size
        return value

    def octets(self):
        size = self.number()
        self.position += size
        return self.data[self.position - size:self.position]

    def string(self):
        return self.octets()[:-1]


def cdr(*values):
    """Little endian CDR of numbers (unsigned long), bytes (string) and Raw (already marshalled, aligned to
    4).
    """
    data = bytearray()
    for value in values:
        data += b"\0" * (-len(data) % 4)
        if isinstance(value, int):
            data += struct.pack("<I", value)
        elif isinstance(value, Raw):
            data += value
        else:
            data += struct.pack("<I", len(value) + 1) + value + b"\0"
    return bytes(data)


class Raw(bytes):
    """Bytes that cdr() leaves unchanged."""


def receive(connection, size):
    """Exactly size bytes; EOFError if the client leaves before."""
    data = b""
    while len(data) < size:
        piece = connection.recv(size - len(data))
        if not piece:
            raise EOFError
        data += piece
    return data


def read_message(connection):
    """Header and payload of the next message."""
    header = receive(connection, 12)
    size, = struct.unpack("<I" if header[6] & 1 else ">I", header[8:])
    return header, receive(connection, size)


def read_request(connection):
    """The next message that needs an answer, assembled from its fragments."""
    while True:
        header, payload = read_message(connection)
        more = header[6] & 2
        while more:
            following, piece = read_message(connection)
            more = following[6] & 2
            payload += piece[4:]        # each begins with the request's number
        if header[7] in (REQUEST, LOCATE_REQUEST):
            return parse_request(header + payload)


def parse_request(data):
    """A Request from a whole GIOP 1.0, 1.1 or 1.2 message."""
    found = requests.Request(data)
    arguments = Reader(data, found.little, found.at or messages.HEADER)
    return Request(found.minor, data[7], found.id, found.is_answered, found.key, found.operation, arguments)


def reply(request, body, status=NO_EXCEPTION, wrong_id=0):
    """A reply; its header has 12 bytes in every version, so that the body begins at a multiple of 8."""
    number = request.id ^ wrong_id
    header = (number, status, 0) if request.version >= 2 else (0, number, status)
    return messages.whole(REPLY, struct.pack("<III", *header) + body, request.version)


def bad_operation(request):
    """The answer to an operation that the object does not have."""
    return reply(request, cdr(b"IDL:omg.org/CORBA/BAD_OPERATION:1.0", 0, 1), SYSTEM_EXCEPTION)


def reference(port, type_id=COMPONENT, key=b"faulty", components=()):
    """An object reference (CDR of an IOR) to a port of this host; `components` are (tag, octets)."""
    return _reference(port, type_id, key, components).octets()


def _reference(port, type_id, key, components=()):
    more = {"type_id": type_id.encode(), "components": components}
    return references.make_reference("127.0.0.1", port, key, **more)


def sequence(octets):
    """A sequence<octet>, its length first."""
    return Raw(struct.pack("<I", len(octets)) + octets)


def stringified(port, type_id=COMPONENT, key=b"faulty", components=()):
    """The same as text: IOR:..."""
    return _reference(port, type_id, key, components).text()


def bindings(names):
    """The result of NamingContext.list(): all bindings and no iterator, however many were asked for."""
    values = [len(names)]
    for id_, kind in names:
        values += [1, id_, kind, int(kind != b"rtc")]
    return cdr(*values + [b"", 0])


def component_profile(text):
    """A ComponentProfile with the same text in all six fields, and no ports."""
    return cdr(text, text, text, text, text, text, 0, b"", 0, 0)


def harmless_answer(request):
    """The answer to _is_a (yes) and _non_existent (no), or None for other operations."""
    if request.type == LOCATE_REQUEST:
        return messages.whole(LOCATE_REPLY, struct.pack("<II", request.id, 1), request.version)
    if request.operation == "_is_a":
        return reply(request, b"\1")
    if request.operation in ("_non_existent", "_not_existent"):
        return reply(request, b"\0")
    return None
