"""An operation of a user's IDL is sent once, whatever its provider does; what is not known is not claimed."""
import struct
import unittest
from unittest import mock

from giop_client import answer
from peers import CLOSE, Calls, forward
from rtshell_lite import errors, notes
from rtshell_lite.corba import orb
from rtshell_lite.corba.iiop import client
from rtshell_lite.giop import descriptors, messages
from rtshell_lite.data import call_values
from rtshell_lite.giop.operations import Schema
from rtshell_lite.net import loop
from rtshell_lite.views import services

MOVE = Schema("move", [descriptors.DOUBLE], [descriptors.LONG], {})
STOP = Schema("stop", [(descriptors.STRING, 0)], None, {})
LONG = struct.pack("<i", 42)


def exception(name, completed, minor=0):
    """The body of a reply that raises a system exception."""
    type_id = b"IDL:omg.org/CORBA/%s:1.0\0" % name.encode()
    body = struct.pack("<I", len(type_id)) + type_id
    return body + b"\0" * (-len(body) % 4) + struct.pack("<II", minor, completed)


class Repeated(unittest.TestCase):
    """Calls again and again end when the provider does, and say so, also where others had failed before."""

    def said(self, number, outcomes, is_each_shown=False):
        coming = iter(outcomes)

        async def call():
            outcome = next(coming)
            if outcome is not None:
                raise outcome

        provider = mock.Mock(where="/a.rtc:svc", repeated=lambda *_: call)
        said = []

        async def main():
            calls = services.Repeated(provider, None, True, is_each_shown)
            async for _ in calls.run([], None, 0.0, number):
                pass

        with mock.patch.object(notes, "fail", said.append), mock.patch.object(
            call_values, "as_dict", lambda *_: {}
        ):
            loop.run(main())
        return [str(what) for what in said]

    def test_why_it_ended(self):
        gone = errors.Unreachable("/a.rtc:svc go", "connection refused")
        refused = errors.Refused("/a.rtc:svc go", "no")
        self.assertEqual(
            self.said(9, [None, refused, None, gone]),
            [str(refused), "/a.rtc:svc go: connection refused; ended after 4 of 9 calls"],
        )
        self.assertEqual(self.said(9, [None, gone]), [str(gone), "/a.rtc:svc: ended after 2 of 9 calls"])
        self.assertEqual(self.said(None, [None, gone]), [str(gone), "/a.rtc:svc: ended after 2 calls"])
        self.assertEqual(self.said(9, [None, gone], True), ["/a.rtc:svc: ended after 2 of 9 calls"])
        self.assertEqual(self.said(2, [None, gone]), [str(gone)])
        self.assertEqual(self.said(2, [None, None]), [])


class Once(Calls):
    """Calls of a provider that misbehaves; it counts what it is asked."""

    def provider(self, *answers):
        peer = self.peer(*answers)
        return peer, peer.ref

    def failure(self, *answers, schema=MOVE, seconds=30.0):
        """(the errors.Error of a call, how often the provider was asked)"""
        peer, ref = self.provider(*answers)
        with self.assertRaises(errors.Error) as caught:
            self.wait_for(orb.call("w", ref, schema, 1.5, seconds=seconds))
        return caught.exception, peer.asked

    def test_it_is_answered(self):
        peer, ref = self.provider(answer(1, LONG))
        self.assertEqual((self.wait_for(orb.call("w", ref, MOVE, 1.5, seconds=2)), peer.asked), (42, 1))
        self.assertEqual(struct.unpack("<d", peer.last[-8:]), (1.5,))

    def test_a_lost_connection(self):
        error, asked = self.failure(None, answer(1, LONG))
        self.assertEqual((type(error), error.exception, asked), (errors.ConnectionLost, None, 1))

    def test_a_connection_that_has_answered_before(self):
        """A question is asked again there, as components are started again: a call never."""
        peer, ref = self.provider(answer(1, b"\0"), None, answer(1, LONG), answer(2, LONG))

        async def ask():
            await orb.call("w", ref, "_non_existent")
            await orb.call("w", ref, MOVE, 1.5, seconds=2)
        with self.assertRaises(errors.ConnectionLost):
            self.wait_for(ask())
        self.assertEqual(peer.asked, 2)

    def test_a_connection_that_is_closed_in_order(self):
        """The provider says that it has not begun; it may be wrong."""
        peer, ref = self.provider(answer(1, b"\0"), CLOSE, answer(1, LONG), answer(2, LONG))

        async def ask():
            await orb.call("w", ref, "_non_existent")
            await orb.call("w", ref, MOVE, 1.5, seconds=2)
        with self.assertRaises(errors.ConnectionLost):
            self.wait_for(ask())
        self.assertEqual(peer.asked, 2)

    def test_an_older_giop_is_not_tried_with_it(self):
        error, asked = self.failure(messages.whole(messages.ERROR, minor=0), answer(1, LONG, minor=0))
        self.assertEqual(asked, 1, error)

    def test_system_exceptions(self):
        for name, completed in (
            ("COMM_FAILURE", 2),
            ("TRANSIENT", 1),
            ("OBJECT_NOT_EXIST", 1),
            ("BAD_OPERATION", 1),
            ("UNKNOWN", 0),
            ("NO_RESOURCES", 2),
        ):
            with self.subTest(name):
                error, asked = self.failure(answer(1, exception(name, completed), 2), answer(2, LONG))
                self.assertEqual((error.exception, asked), ((name, completed), 1))

    def test_silence(self):
        error, asked = self.failure(b"", seconds=0.3)
        self.assertEqual((type(error), error.why, asked), (errors.Silent, "no answer within 0.3s", 1))
        self.assertEqual(self.session.silent, {}, "it may take longer than its caller waits: others are "
                                                  "asked all the same")

    def test_its_limit_may_be_shorter_than_the_timeout_and_longer(self):
        self.session.timeout = 0.2
        peer, ref = self.provider(b"")
        with self.assertRaises(errors.Silent) as caught:
            self.wait_for(orb.call("w", ref, MOVE, 1.5, seconds=0.7))
        self.assertEqual((caught.exception.why, peer.asked), ("no answer within 0.7s", 1))

    def test_an_answer_that_cannot_be_read_shows_that_it_was_done(self):
        error, asked = self.failure(answer(1, b"\1"))
        self.assertEqual((error.exception, asked), (("MARSHAL", 0), 1))

    def test_it_goes_to_whom_it_is_forwarded(self):
        other, there = self.provider(answer(1, LONG))
        peer, ref = self.provider(forward(there, 1))
        self.assertEqual(self.wait_for(orb.call("w", ref, MOVE, 1.5, seconds=2)), 42)
        self.assertEqual((peer.asked, other.asked), (1, 1))

    def test_oneway_waits_for_nobody(self):
        peer = self.script(lambda pending: answer(2) if len(pending) == 2 else None)

        async def ask():
            self.assertIsNone(await orb.call("w", peer.ref, STOP, "now", seconds=2))
            await orb.call("w", peer.ref, "_non_existent")
        self.wait_for(ask())
        self.assertEqual((peer.most, len(peer.connections)), (2, 1))

    def test_oneway_asks_for_no_reply(self):
        for minor in (0, 1, 2):
            octets = messages.request(
                1, (1, minor), messages.KEY, struct.pack("<I", 1) + b"x", "stop", (), True
            )
            flags = octets[messages.HEADER + (4 if minor == 2 else 8)]
            self.assertEqual(flags, 0, minor)

    def test_oneway_to_nobody(self):
        ref = client.from_url("w", "corbaloc::127.0.0.1:1/x")
        with self.assertRaises(errors.ConnectionRefused):
            self.wait_for(orb.call("w", ref, STOP, "now", seconds=2))


if __name__ == "__main__":
    unittest.main()
