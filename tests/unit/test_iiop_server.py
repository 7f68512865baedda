"""Our own ORB as a server: every message is answered as CORBA demands."""
import os
import socket
import struct
import threading
import unittest
from unittest import mock

try:
    import omniORB
except ImportError:
    omniORB = None

from giop_client import PORT_OK, block, fragments, request, text
from served import ERROR, LIMIT, Served, result
from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.corba.iiop import client, server
from rtshell_lite.giop import messages, references, requests
from rtshell_lite.net import loop, tcp

whole = messages.whole


class Answers(Served):
    def test_all_versions_and_byte_orders(self):
        for order in "<>":
            for minor in (0, 1, 2):
                for contexts in (b"", b"x", b"12345678"):
                    body = block(b"data %d" % minor, order)
                    found = self.ask(self.key, "put", body, minor=minor, order=order, contexts=contexts)
                    self.assertEqual((found, self.port.taken.pop()), (bytes(4), b"data %d" % minor))

    def test_one_connection_many_calls(self):
        here = self.client()
        sent = [request(self.key, "put", block(b"%d" % i), number=i) for i in range(2000)]
        threading.Thread(target=here.send, args=sent, daemon=True).start()
        self.assertEqual([messages.reply(here.answer())[0] for _ in sent], list(range(2000)))
        self.assertEqual(self.port.taken, [b"%d" % i for i in range(2000)])
        self.assertIs(type(self.port.taken[0]), bytes)

    def test_the_same_enumerator_again_is_not_written_again(self):
        here = self.client()
        with mock.patch.object(requests, "answer", wraps=requests.answer) as answer:
            for number in range(100):
                asked = request(self.key, "put", block(b"x"), number=number)
                found = here.ask(asked)
                self.assertEqual((messages.reply(found)[0], result(found)), (number, bytes(4)))
        self.assertLess(answer.call_count, 5)

    def test_blocks(self):
        here = self.client()
        for size in (0, 1, 4000, 65536, 1000000, 3000001, 17):
            data = os.urandom(size)
            self.assertEqual(result(here.ask(request(self.key, "put", block(data)))), bytes(4))
            self.assertTrue(self.port.taken.pop() == data, size)

    def test_operations_that_every_object_has(self):
        for name, wanted in (
            ("IDL:OpenRTM/ComponentObserver:1.0", 1),
            ("IDL:org.omg/SDOPackage/SDOService:1.0", 1),
            ("IDL:omg.org/CORBA/Object:1.0", 1),
            ("IDL:OpenRTM/Logger:1.0", 0),
        ):
            self.assertEqual(self.ask(self.observed, "_is_a", text(name)), bytes([wanted]))
        self.assertEqual(self.ask(self.observed, "_non_existent"), b"\0")

    def test_exceptions(self):
        self.assertEqual(self.ask(self.key, "get"), ("BAD_OPERATION", requests.NO))
        self.assertEqual(self.ask(self.key, "_interface"), ("BAD_OPERATION", requests.NO))
        self.assertEqual(self.ask(b"nobody", "put", block(b"")), ("OBJECT_NOT_EXIST", requests.NO))
        self.assertEqual(self.ask(self.key, "put", block(b"raise")), ("UNKNOWN", requests.MAYBE))
        with mock.patch.object(self.port, "put", lambda data: "no status", create=True):
            self.assertEqual(self.ask(self.key, "put", block(b"")), ("UNKNOWN", requests.MAYBE))
        here = self.client()
        self.assertEqual(result(here.ask(request(self.key, "_non_existent"))), b"\0")
        self.withdraw()
        for operation in ("put", "_non_existent", "_is_a"):
            self.assertEqual(
                result(here.ask(request(self.key, operation, text("x")))), ("OBJECT_NOT_EXIST", requests.NO)
            )

    def test_garbled_arguments(self):
        for body in (
            b"",
            b"\0\0\0",
            struct.pack("<I", 5) + b"1234",
            b"\xff" * 8,
            struct.pack("<I", 0x7FFFFFFF),
        ):
            self.assertEqual(self.ask(self.key, "put", body), ("MARSHAL", requests.NO), body)
        good = struct.pack("<I", 1) + text("ACTIVE:0")
        for cut in list(range(len(good))):
            self.assertEqual(
                self.ask(self.observed, "update_status", good[:cut]), ("MARSHAL", requests.NO), cut
            )
        self.assertEqual(
            self.ask(self.observed, "update_status", struct.pack("<I", 77) + text("x")),
            ("MARSHAL", requests.NO),
        )
        self.assertEqual(self.ask(self.observed, "update_status", good), b"")
        self.assertEqual(self.observer.heard, [("RTC_STATUS", "ACTIVE:0")])

    def test_oneway(self):
        here = self.client()
        for minor in (0, 1, 2):
            body = struct.pack("<I", 5) + text("%d" % minor)
            here.send(request(self.observed, "update_status", body, minor=minor, is_answered=False))
            here.send(
                request(self.observed, "nonsense", minor=minor, is_answered=False),
                request(b"none", "x", is_answered=False),
            )
            self.assertEqual(result(here.ask(request(self.key, "_non_existent", number=2))), b"\0")
        self.assertEqual(self.observer.heard, [("HEARTBEAT", "%d" % minor) for minor in (0, 1, 2)])

    def test_locating(self):
        for minor in (0, 1, 2):
            for key, status in ((self.key, 1), (b"nobody", 0)):
                found = self.client().ask(request(key, "", number=7, minor=minor, kind=requests.LOCATE))
                self.assertEqual(found, whole(requests.LOCATED, struct.pack("<II", 7, status), minor))

    def test_objects_named_otherwise(self):
        """By a profile or a reference: the caller is asked for the key."""
        for kind, operation in ((requests.REQUEST, "put"), (requests.LOCATE, "")):
            for way in (1, 2):
                message = bytearray(request(self.key, operation, kind=kind))
                message[20 if operation else 16] = way
                found = self.client().ask(bytes(message))
                self.assertEqual(found[7], messages.REPLY if operation else requests.LOCATED)
                self.assertEqual(struct.unpack_from("<II", found, 12), (1, messages.NEEDS_ADDRESSING_MODE))
                self.assertEqual(found[-2:], b"\0\0")
                self.assertEqual(messages.size(found), len(found) - 12)


class Fragments(Served):
    def test_any_size(self):
        message = request(self.key, "put", block(b"0123456789"))
        for first in range(16, len(message)):
            here = self.client()
            for second in (first, (first + len(message)) // 2):
                self.assertEqual(result(here.ask(*fragments(message, first, second))), bytes(4))
                self.assertEqual(self.port.taken.pop(), b"0123456789")

    def test_older_and_big_endian(self):
        for minor, order in ((1, "<"), (1, ">"), (2, ">")):
            message = request(self.key, "put", block(b"0123456789", order), minor=minor, order=order)
            self.assertEqual(result(self.client().ask(*fragments(message, 40, 60))), bytes(4))
            self.assertEqual(self.port.taken.pop(), b"0123456789")

    def test_large(self):
        data = os.urandom(1000000)
        message = request(self.key, "put", block(data))
        self.assertEqual(
            result(self.client().ask(*fragments(message, *range(8192, len(message), 8192)))), bytes(4)
        )
        self.assertTrue(self.port.taken.pop() == data)

    def test_of_several_requests_at_once(self):
        here = self.client()
        one, other = [
            fragments(request(self.key, "put", block(b"%d" % i * 50), number=i), 50, 70) for i in (1, 2)
        ]
        locate = fragments(request(self.key, "", number=3, kind=requests.LOCATE), 24)
        here.send(
            one[0],
            other[0],
            locate[0],
            other[1],
            request(self.key, "_non_existent", number=4),
            one[1],
            other[2],
            locate[1],
            one[2],
        )
        self.assertEqual([struct.unpack_from("<I", here.answer(), 12)[0] for _ in range(4)], [4, 2, 3, 1])
        self.assertEqual(self.port.taken, [b"2" * 50, b"1" * 50])

    def test_cancelled(self):
        here = self.client()
        first = fragments(request(self.key, "put", block(b"x" * 50)), 50)[0]
        self.assertEqual(
            result(
                here.ask(
                    first, whole(requests.CANCEL, struct.pack("<I", 1)), request(self.key, "_non_existent")
                )
            ),
            b"\0",
        )
        # of nothing, now
        self.assertEqual(here.ask(fragments(request(self.key, "put", block(b"x" * 50)), 50)[1]), ERROR)
        self.assertEqual(self.port.taken, [])


class Places(unittest.TestCase):
    """Where we listen, and what the references say."""

    def setting(self, words="", **variables):
        names = {name: value for name, value in os.environ.items() if not name.startswith("ORB")}
        with mock.patch.dict(os.environ, dict(names, RTCTREE_ORB_ARGS=words, **variables), clear=True):
            return server._setting("endPoint"), server._setting("endPointPublish")

    def test_settings_of_omniorb(self):
        none = ("", 0)
        self.assertEqual(self.setting(), (none, none))
        self.assertEqual(
            self.setting("-ORBendPoint;giop:tcp:10.0.0.1:2810;-ORBtraceLevel;0"), (("10.0.0.1", 2810), none)
        )
        self.assertEqual(
            self.setting("-ORBendPoint;giop:tcp::;-ORBendPointPublish;giop:tcp:robot:"), (none, ("robot", 0))
        )
        self.assertEqual(
            self.setting(ORBendPoint="giop:tcp:[::1]:", ORBendPointPublish="giop:tcp:a:1,giop:tcp:b:2"),
            (("::1", 0), ("a", 1)),
        )
        for ignored in ("giop:unix:/tmp/x", "addr", "all(addr)", "giop:tcp:", "", "nonsense"):
            self.assertEqual(
                self.setting(ORBendPoint=ignored, ORBendPointPublish=ignored), (none, none), ignored
            )
        self.assertEqual(self.setting("-ORBendPoint"), (none, none))

    def test_listening(self):
        for host, port in (("", 0), ("127.0.0.1", 0), ("localhost", 0)):
            made = tcp.listen(host, port)
            self.addCleanup(made.close)
            socket.create_connection(("127.0.0.1", made.getsockname()[1]), LIMIT).close()
        for host, port in (("192.0.2.222", 0), ("no.such.host.invalid", 0), ("127.0.0.1", 99999), ("a..b", 0),
                           ("127.0.0.1", made.getsockname()[1])):
            self.assertIsNone(tcp.listen(host, port), (host, port))


class Callers(Served):
    """Called by real ORBs."""

    def setUp(self):
        super().setUp()
        profiles = references.make_reference("127.0.0.1", self.at, self.key).profiles
        self.text = references.Reference(b"IDL:OpenRTM/InPortCdr:1.0", profiles).text()

    def asked(self, which, ref, data):
        """What `put` returns, called by an ORB."""
        with mock.patch.object(orb, "_orb", which):
            return loop.run(orb.call("w", ref, "put", data), session=session.Session(LIMIT))

    def test_our_own(self):
        ref = client.narrow(client.from_text("w", self.text), "OpenRTM.InPortCdr")
        for size in (0, 5, 1000000):
            self.assertEqual(self.asked(client, ref, b"x" * size), PORT_OK)
            self.assertEqual(len(self.port.taken.pop()), size)

    @unittest.skipIf(omniORB is None, "needs omniORBpy")
    def test_omniorb(self):
        from rtshell_lite.corba import omniorb
        from mock_components.idl import OpenRTM
        ref = omniorb.narrow(omniorb.from_text("w", self.text), "OpenRTM.InPortCdr")
        self.assertTrue(ref._is_a("IDL:OpenRTM/InPortCdr:1.0"))
        self.assertFalse(ref._non_existent())
        for size in (0, 5, 8100, 8192, 8300, 20000, 1000000, 5000000):
            data = os.urandom(size)
            self.assertEqual(ref.put(data), OpenRTM.PORT_OK)
            self.assertTrue(self.port.taken.pop() == data, size)
        with self.assertRaises(errors.Refused) as caught:
            self.asked(omniorb, ref, b"raise")
        self.assertEqual(caught.exception.name, "UNKNOWN")
        self.withdraw()
        with self.assertRaises(errors.Gone):
            self.asked(omniorb, ref, b"")


if __name__ == "__main__":
    unittest.main()
