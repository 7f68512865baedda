"""Targets of fuzz.py that need no robot: what callers send to our servants, replies that our own ORB reads,
and what rtcall prints of them.
"""
import os
import select
import socket
import struct

import fuzz_replies
import giop_client
from fuzz import ROOT, Crash, Refused, Target, spoilt
from rtshell_lite import errors, text
from rtshell_lite.corba.iiop import calls, server
from rtshell_lite.data import call_values, defaults
from rtshell_lite.data.idl import parser
from rtshell_lite.giop import allowance, descriptors, marshal, messages, operations, requests
from rtshell_lite.net import loop

WORDS = fuzz_replies.WORDS + [
    bytes([1, minor, flags, kind]) for minor in (0, 1, 2) for flags in (0, 1, 3) for kind in range(8)
]
KEYS = {b"p" * 24: giop_client.Port, b"o" * 24: giop_client.Observer}


class Requests(Target):
    """Octets of callers: each is answered or refused, and the next caller is served."""

    name = "requests"
    words = WORDS + [b"_is_a\0", b"put\0", b"update_status\0", b"_non_existent\0"]

    def prepare(self):
        self.server = server.Server(loop.Loop(loop.world()), "127.0.0.1", 0)
        for key, kind in KEYS.items():
            servant = kind()
            self.server.objects[key] = servant, server.idl.id_of(servant.interface)
        self.seeds = []
        for minor, order in ((0, "<"), (1, ">"), (2, "<"), (2, ">")):
            for key, operation, body in (
                (b"p" * 24, "put", giop_client.block(b"12345678" * 5, order)),
                (
                    b"o" * 24,
                    "update_status",
                    struct.pack(order + "I", 1) + giop_client.text("ACTIVE:0", order),
                ),
                (b"o" * 24, "_is_a", giop_client.text("IDL:OpenRTM/Logger:1.0", order)),
                (b"x", "_non_existent", b""),
            ):
                message = giop_client.request(
                    key, operation, body, minor=minor, order=order, contexts=b"code sets"
                )
                self.seeds += [message, message * 2] + (
                    [b"".join(giop_client.fragments(message, 40, 56))] if minor else []
                )
        self.seeds += [
            giop_client.request(b"p" * 24, "", kind=requests.LOCATE),
            messages.whole(requests.CANCEL, b"\1\0\0\0"),
        ]
        self.good = giop_client.request(b"p" * 24, "_non_existent")

    def done(self):
        for caller in list(self.server.callers):
            self.server.close(caller)
        self.server.listening.close()

    def make(self, rng):
        message = spoilt(rng, rng.choice(self.seeds), self.words, self.seeds)
        if rng.random() < 0.7 and len(message) >= 12:  # a wrong length shows little
            message = (
                message[:8] + struct.pack("<I" if message[6] & 1 else ">I", len(message) - 12) + message[12:]
            )
        return message + rng.choice([b"", self.good])

    def check(self, data):
        if not self._sent(data):
            raise Refused("closed")
        if self._sent(self.good)[-1:] != b"\0":
            raise Crash("the next caller is not served")

    def _sent(self, data):
        """What a caller gets who sends these octets; b"" if it was refused."""
        here, there = socket.socketpair()
        with here:
            there.setblocking(False)
            here.setblocking(False)
            caller = server.Caller(there, "")
            self.server.callers[caller] = True
            here.sendall(data)
            found = b""
            while caller in self.server.callers and select.select([there], [], [], 0)[0]:
                self.server.attend(caller, False)
                found += self._come(here)
            is_open = caller in self.server.callers
            if is_open:
                self.server.close(caller)
            found += self._come(here)
        self._examine(found)
        return found if is_open else b""

    @staticmethod
    def _come(here):
        try:
            return here.recv(1 << 20)
        except BlockingIOError:
            return b""
        except ConnectionResetError:  # we closed it before we had read all
            return b""

    @staticmethod
    def _examine(found):
        """What we send is GIOP."""
        while found:
            size = messages.HEADER + messages.size(found)
            if len(found) < size or found[7] not in (
                messages.REPLY,
                requests.LOCATED,
                messages.CLOSE,
                messages.ERROR,
            ):
                raise Crash("not an answer: %r" % found)
            found = found[size:]


class Answers(Target):
    """Replies as our own ORB reads them: a value, or a declared error."""

    name = "answers"
    words = WORDS

    def prepare(self):
        self.recorded = [(name, message) for _, name, _, message in fuzz_replies.load()]
        self.operations = {
            name: operations.operation(
                next(
                    (interface for interface, (_, own) in operations.idl.INTERFACES.items() if name in own),
                    "",
                ),
                name,
            )
            for name, _ in self.recorded
        }
        self.seeds = [message for _, message in self.recorded]

    def make(self, rng):
        name, message = rng.choice(self.recorded)
        head = messages.HEADER + rng.choice((0, 12, 12, 12))
        return name.encode() + b"\n" + message[:head] + spoilt(rng, message[head:], self.words, self.seeds)

    def check(self, data):
        name, _, message = data.partition(b"\n")
        try:
            _, status, little, at = messages.reply(message)
            if status == messages.NO_EXCEPTION:
                self.operations[name.decode()].results[little](message, at)
            elif status == messages.SYSTEM_EXCEPTION:
                calls._system_exception(message, at, little)
        except calls.GARBLED as e:
            raise Refused(str(e))


class Results(Target):
    """What operations of a user's IDL return: values that can be printed, or a declared error."""

    name = "results"
    words = (
        WORDS
        + [struct.pack("<I", kind) for kind in range(1, 30)]
        + [b"IDL:Mock/Step:1.0\0", b"\0\0\0\0\1\0\0\0"]
    )

    def prepare(self):
        file = parser.read_file(os.path.join(ROOT, "mock_components", "robot.idl"))
        named = file.interfaces["IDL:Mock/Robot:1.0"].all_operations()
        self.operations = [
            (name, each, each.schema()) for name, each in sorted(named.items()) if each.schema().returned
        ]
        self.seeds = []
        for number, (name, each, schema) in enumerate(self.operations):
            out = bytearray(messages.HEADER + 12)
            for descriptor in schema.returned:
                marshal.ValueMaker("<").writer(descriptor)(out, self._value(descriptor, file))
            self.seeds.append(bytes([number]) + bytes(out[messages.HEADER + 12:]))

    @staticmethod
    def _value(descriptor, file):
        """A value of a type; one in an any that has parts."""
        value = defaults.value(descriptor)
        if isinstance(value, marshal.Any):
            step = file.types["IDL:Mock/Steps:1.0"]
            return marshal.Any(step, [defaults.value(descriptors.element(descriptors.target(step)))])
        return value

    def check(self, data):
        _, operation, schema = self.operations[data[0] % len(self.operations) if data else 0]
        octets = bytes(messages.HEADER + 12) + data[1:]
        allowance.begin()
        try:
            value, _ = schema.operation.results[1](octets, messages.HEADER + 12)
        except calls.GARBLED as e:
            raise Refused(str(e))
        try:
            shown = [
                text.json_line(call_values.as_dict(operation, value)),
                call_values.as_text(operation, value),
            ]
        except errors.BadValue as e:  # nested too deep
            raise Refused(str(e))
        for line in shown:
            if not text.safe(line or "").isprintable():
                raise Crash("not printable: %r" % line)


TARGETS = [Requests, Answers, Results]
