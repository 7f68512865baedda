"""GIOP as a server reads and writes it (CORBA 3.0, 15.4): requests taken apart, answers as octets;
no socket.
"""

import struct

from rtshell_lite.giop import idl, marshal, messages, operations

# kinds of messages; messages.py has the others
REQUEST = 0
CANCEL = 2
LOCATE = 3
LOCATED = 4
# whether what raised an exception was completed
NO = 1
MAYBE = 2
_ANSWER = struct.Struct("<4s4BIIII")
_LOCATED = struct.Struct("<4s4BIII")
_ORDERS = [(struct.Struct(order + "I"), struct.Struct(order + "H")) for order in "><"]


class Thrown(Exception):
    """An exception that an operation of ours raises: one of its IDL by its name
    (CosNaming.NamingContext.NotFound) and its members, or one of CORBA by its name alone (BAD_PARAM).
    """

    def __init__(self, name, *members):
        super().__init__(name)
        self.name = name
        self.members = members


def head(data, start):
    """What two messages of GIOP 1.2 have in common that differ only in their ids and in their arguments,
    which begin at `start`.
    """
    return bytes(data[4:8]) + bytes(data[16:start])


class Request:
    """A Request (it `is_request`) or LocateRequest, given whole: its id, its operation, the key of its object
    (None where the caller names it otherwise), where the arguments begin in `data`. Raises Garbled,
    struct.error, IndexError.

    result, reply   an enumerator that such a request was answered with, and that answer;
                    most get the same again
    """

    def __init__(self, data):
        self.result = None
        self.reply = b""
        self.data = data
        self.at = None
        self.minor = data[5]
        self.little = data[6] & messages.LITTLE
        self.one, short = _ORDERS[self.little]
        self.is_request = data[7] == REQUEST
        self.operation = ""
        self.is_answered = True
        offset = messages.HEADER
        if self.is_request and self.minor < 2:
            offset = messages.after_contexts(data, offset, self.one)
        (self.id,) = self.one.unpack_from(data, offset)
        offset += 4
        if self.is_request:
            self.is_answered = bool(data[offset] & 1)
            offset += 4 if self.minor else 1
        if self.minor == 2:
            self.key = None
            if short.unpack_from(data, offset)[0]:
                return
            offset += 2
        self.key, offset = self._octets(offset)
        if self.is_request:
            name, offset = self._octets(offset)
            self.operation = name[:-1].decode("latin-1")
            self.at = self._arguments(offset)

    def take_on(self, data):
        """Take on a message with the same head."""
        self.data = data
        (self.id,) = self.one.unpack_from(data, messages.HEADER)

    def _arguments(self, offset):
        if self.minor < 2:
            return self._octets(offset)[1]  # the principal
        offset = messages.after_contexts(self.data, offset, self.one)
        return offset + -offset % 8

    def _octets(self, offset):
        offset += -offset % 4
        (size,) = self.one.unpack_from(self.data, offset)
        offset += 4 + size
        if offset > len(self.data):
            raise messages.Garbled("octets without an end")
        return bytes(self.data[offset - size : offset]), offset


# ---- answers, in little endian ----


def answer(request, status=messages.NO_EXCEPTION):
    """A Reply as a bytearray, up to its results; `sized` ends it."""
    # 0: no service contexts
    words = (request.id, status, 0) if request.minor == 2 else (0, request.id, status)
    return bytearray(_ANSWER.pack(b"GIOP", 1, request.minor, messages.LITTLE, messages.REPLY, 0, *words))


def repeated(request):
    """The last answer to a Request that was taken on `again`, with its id."""
    out = bytearray(request.reply)
    _ORDERS[messages.LITTLE][0].pack_into(out, messages.HEADER, request.id)
    return out


def sized(out):
    """A message that is complete: its size is put into its header."""
    struct.pack_into("<I", out, 8, len(out) - messages.HEADER)
    return out


def failed(request, name, completed=NO):
    """A Reply that raises a system exception."""
    out = answer(request, messages.SYSTEM_EXCEPTION)
    operations.writer(marshal.TEXT)(out, f"IDL:omg.org/CORBA/{name}:1.0")
    return sized(out + b"\0" * (-len(out) % 4) + struct.pack("<II", 0, completed))


def thrown(request, interface, exception):
    """A Reply with a Thrown."""
    if "." not in exception.name:
        return failed(request, exception.name)
    type_id = idl.id_of(exception.name)
    _, _, raised = idl.operation(interface, request.operation)
    if type_id not in raised:
        return failed(request, "UNKNOWN", MAYBE)
    out = answer(request, messages.USER_EXCEPTION)
    operations.writer(marshal.TEXT)(out, type_id)
    operations.writer(idl.known(type_id))(out, idl.struct(exception.name)(*exception.members))
    return sized(out)


def needs_key(request):
    """The answer to who names an object by a profile or a reference."""
    begin = answer if request.is_request else located
    out = begin(request, messages.NEEDS_ADDRESSING_MODE)
    return sized(out + struct.pack("<H", messages.KEY))


def located(request, status):
    """A LocateReply; status 0: no such object, 1: it is here."""
    return bytearray(
        _LOCATED.pack(b"GIOP", 1, request.minor, messages.LITTLE, LOCATED, 8, request.id, status)
    )
