"""A robot that speaks another GIOP than ours: relays that say the same in another version, byte order, or in
fragments.
"""
import re

import giop_client
import relay
from rtshell_lite.giop import descriptors, idl
from rtshell_lite.giop import marshal, messages, operations

ROOT = "IDL:omg.org/CosNaming/NamingContext:1.0"
# how an IIOP profile begins: its version
PROFILE = re.compile(rb"(\x01\x01)[\0-\x02](\0\x0a\0\0\x00127\.0\.0\.1\0)")


class Dialect(relay.Relay):
    """`minor`: the GIOP 1.x that all speak; `order`: "<" or ">" of all answers; `piece`: octets of a
    fragment, or None for no fragments. `strict`: later versions are answered with MessageError.
    """

    def __init__(self, minor, order="<", piece=None, strict=False):
        super().__init__()
        self.minor = minor
        self.order = order
        self.piece = piece
        self.strict = strict
        self.types = {}  # {key of an object: its repository id}
        self.reader = _Reader("<", self.types)
        self.writer = marshal.Maker(order)
        self.translated, self.untranslated = set(), set()  # operations; a robot may mix byte orders

    def refused(self, message):
        """MessageError to what is later than our version."""
        return (
            messages.whole(messages.ERROR, b"", self.minor)
            if self.strict and message[5] > self.minor
            else None
        )

    def asked(self, message):
        return _in_version(2, message)

    def passed(self, request, reply):
        reply = _in_version(self.minor, reply)
        if self.order == ">":
            reply = self._translated(request, reply)
        cuts = range(messages.HEADER + self.piece, len(reply), self.piece) if self.piece and reply[5] else ()
        return b"".join(giop_client.fragments(reply, *cuts))

    def _translated(self, request, reply):
        """The reply in our byte order."""
        try:
            number, status, _, at = messages.reply(reply)
            body = bytearray()  # which begins at a multiple of 8, as it does in the reply
            for descriptor in self._types(request, status, reply, at):
                value, at = self.reader.reader(descriptor)(reply, at)
                self.writer.writer(descriptor)(body, value)
        except marshal.Fault:  # an any that holds no text: we never write those
            self.untranslated.add(request.operation)
            return reply
        self.translated.add(request.operation)
        return giop_client.answer(number, bytes(body), status, reply[5], self.order)

    def _types(self, request, status, reply, at):
        """The descriptors of what a reply holds."""
        if status == messages.SYSTEM_EXCEPTION:
            return marshal.TEXT, descriptors.ULONG, descriptors.ULONG
        if status == messages.USER_EXCEPTION:
            type_id, _ = self.reader.reader(marshal.TEXT)(reply, at)
            return marshal.TEXT, idl.descriptor(type_id)
        interface = self.types.get(request.key, ROOT) or ROOT
        _, returned, _ = operations._COMMON.get(request.operation) or idl.operation(
            interface, request.operation
        )
        return [idl.descriptor(word) for word in returned or ()]


def _in_version(minor, message):
    """A message with all references in it for GIOP 1.`minor`; those for 1.0 keep their components, which
    older ORBs send, too.
    """
    return PROFILE.sub(lambda found: found.group(1) + bytes([minor]) + found.group(2), message)


class _Reader(marshal.Maker):
    """Notes the types of the objects whose references it reads."""

    def __init__(self, order, types):
        super().__init__(order)
        self.types = types

    def read_reference(self, descriptor):
        read = super().read_reference(descriptor)

        def noted(data, at):
            ref, at = read(data, at)
            if ref is not None:
                self.types[bytes(ref.address.key)] = ref.type_id.decode()
            return ref, at
        return noted
