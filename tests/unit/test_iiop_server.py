"""Our own ORB as a server: every message is answered as CORBA demands, and no caller harms the others, whatever it sends."""
import os
import socket
import struct
import threading
import time
import unittest
from unittest import mock

try:
    import omniORB
except ImportError:
    omniORB = None

from rtshell_lite import errors
from rtshell_lite.corba import descriptors, idl, ior, lanes, orb
from rtshell_lite.corba.iiop import client, giop, references, requests, server

LIMIT = 60.0  # seconds that anything may take on a busy machine
PORT_OK = descriptors.items(idl.descriptor("IDL:OpenRTM/PortStatus:1.0"))[0]
CLOSE, ERROR = requests.word(giop.CLOSE, 2), requests.word(giop.ERROR, 2)


class Port:
    """A servant that keeps what it is given."""

    interface = "dataport.OpenRTM.InPortCdr"

    def __init__(self):
        self.taken, self.came = [], threading.Semaphore(0)

    def put(self, data):
        if data == b"raise":
            raise LookupError("a fault of ours")
        self.taken.append(data)
        self.came.release()
        return PORT_OK


class Observer:
    """A servant of an interface that inherits, with an operation that is oneway."""

    interface = "observer.OpenRTM.ComponentObserver"

    def __init__(self):
        self.heard = []

    def update_status(self, kind, hint):
        self.heard.append((kind._n, hint))


def request(key, operation, body=b"", number=1, minor=2, order="<", is_answered=True, contexts=b"", kind=requests.REQUEST):
    """A Request, or a LocateRequest, as octets. `contexts`: octets of one service context, which is ignored."""
    def aligned(data, size):
        return data + b"\xee" * (-len(data) % size)  # padding is what happens to be in memory

    def octets(data):
        return struct.pack(order + "I", len(data)) + data

    known = struct.pack(order + "II", 1, 7) + octets(contexts) if contexts else struct.pack(order + "I", 0)
    asks = kind == requests.REQUEST
    head = bytes(12)
    if minor < 2:
        head = aligned(head + known, 4) if asks else head
        head += struct.pack(order + "I", number) + (bytes([is_answered]) + b"\xee" * (3 if minor else 0) if asks else b"")
        head = aligned(head, 4) + octets(key)
        if asks:
            head = aligned(aligned(head, 4) + octets(operation.encode() + b"\0"), 4) + octets(b"who")
    else:
        head += struct.pack(order + "I", number) + (bytes([3 if is_answered else 0]) + b"\xee" * 3 if asks else b"")
        head += struct.pack(order + "H", 0) + b"\xee\xee" + octets(key)
        if asks:
            head = aligned(aligned(head, 4) + octets(operation.encode() + b"\0"), 4) + known
            head = aligned(head, 8) if body else head
    if minor < 2 and body:
        head = aligned(head, 4)
    return whole(kind, head[12:] + body, minor, order)


def whole(kind, payload, minor=2, order="<", more=False):
    return b"GIOP\1" + bytes([minor, (order == "<") | more << 1, kind]) + struct.pack(order + "I", len(payload)) + payload


def block(data, order="<"):
    return struct.pack(order + "I", len(data)) + data


def text(words, order="<"):
    return block(words.encode() + b"\0", order)


def fragments(message, *cuts):
    """A message as one with fragments, cut at these places."""
    order, minor = ("<" if message[6] & 1 else ">"), message[5]
    parts = [message[a:b] for a, b in zip((12,) + cuts, cuts + (len(message),))]
    ahead = message[12:16] if minor == 2 else b""
    return [whole(message[7] if i == 0 else giop.FRAGMENT, (b"" if i == 0 else ahead) + part, minor, order, i < len(parts) - 1)
            for i, part in enumerate(parts)]


class Client:
    """A connection to our server."""

    def __init__(self, port):
        self.socket = socket.create_connection(("127.0.0.1", port), LIMIT)
        self.data = b""

    def send(self, *messages):
        self.socket.sendall(b"".join(messages))

    def answer(self):
        """The next message, or b"" at the end."""
        while len(self.data) < 12 or len(self.data) < 12 + giop.size(self.data):
            piece = self.socket.recv(65536)
            if not piece:
                return b""
            self.data += piece
        size = 12 + giop.size(self.data)
        found, self.data = self.data[:size], self.data[size:]
        return found

    def ask(self, *messages):
        self.send(*messages)
        return self.answer()

    def last_words(self):
        """All that still comes until the connection is closed."""
        found = self.data
        while True:
            try:
                piece = self.socket.recv(65536)
            except ConnectionResetError:  # closed while we were sending
                return found
            if not piece:
                return found
            found += piece

    def close(self):
        self.socket.close()


def result(message):
    """What a reply says: the octets of its results, or the name of the system exception and whether it was completed."""
    number, status, little, at = giop.reply(message)
    if status == giop.NO_EXCEPTION:
        return message[at:]
    assert status == giop.SYSTEM_EXCEPTION, message
    size, = struct.unpack_from("<I", message, at)
    name = message[at + 4:at + 3 + size].decode()
    completed = struct.unpack_from("<I", message, len(message) - 4)[0]
    return name[len("IDL:omg.org/CORBA/"):-len(":1.0")], completed


class Served(unittest.TestCase):
    """Base: servants, and clients of them."""

    def setUp(self):
        self.port, self.observer = Port(), Observer()
        self.key, self.withdraw = self.serve(self.port)
        self.observed, _ = self.serve(self.observer)

    def serve(self, servant):
        found, withdraw = server.serve(servant)
        self.addCleanup(withdraw)
        address = ior.address(found)
        self.at = address.port
        return address.key, withdraw

    def client(self):
        made = Client(self.at)
        self.addCleanup(made.close)
        return made

    def ask(self, *arguments, **keywords):
        return result(self.client().ask(request(*arguments, **keywords)))

    def still_served(self):
        self.assertEqual(self.ask(self.key, "_non_existent"), b"\0")


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
        messages = [request(self.key, "put", block(b"%d" % i), number=i) for i in range(2000)]
        threading.Thread(target=here.send, args=messages, daemon=True).start()
        self.assertEqual([giop.reply(here.answer())[0] for _ in messages], list(range(2000)))
        self.assertEqual(self.port.taken, [b"%d" % i for i in range(2000)])
        self.assertIs(type(self.port.taken[0]), bytes)

    def test_blocks(self):
        here = self.client()
        for size in (0, 1, 4000, 65536, 1000000, 3000001, 17):
            data = os.urandom(size)
            self.assertEqual(result(here.ask(request(self.key, "put", block(data)))), bytes(4))
            self.assertTrue(self.port.taken.pop() == data, size)

    def test_what_any_object_is_asked(self):
        for name, wanted in (("IDL:OpenRTM/ComponentObserver:1.0", 1), ("IDL:org.omg/SDOPackage/SDOService:1.0", 1),
                             ("IDL:omg.org/CORBA/Object:1.0", 1), ("IDL:OpenRTM/Logger:1.0", 0)):
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
            self.assertEqual(result(here.ask(request(self.key, operation, text("x")))), ("OBJECT_NOT_EXIST", requests.NO))

    def test_garbled_arguments(self):
        for body in (b"", b"\0\0\0", struct.pack("<I", 5) + b"1234", b"\xff" * 8, struct.pack("<I", 0x7fffffff)):
            self.assertEqual(self.ask(self.key, "put", body), ("MARSHAL", requests.NO), body)
        good = struct.pack("<I", 1) + text("ACTIVE:0")
        for cut in list(range(len(good))):
            self.assertEqual(self.ask(self.observed, "update_status", good[:cut]), ("MARSHAL", requests.NO), cut)
        self.assertEqual(self.ask(self.observed, "update_status", struct.pack("<I", 77) + text("x")), ("MARSHAL", requests.NO))
        self.assertEqual(self.ask(self.observed, "update_status", good), b"")
        self.assertEqual(self.observer.heard, [("RTC_STATUS", "ACTIVE:0")])

    def test_oneway(self):
        here = self.client()
        for minor in (0, 1, 2):
            body = struct.pack("<I", 5) + text("%d" % minor)
            here.send(request(self.observed, "update_status", body, minor=minor, is_answered=False))
            here.send(request(self.observed, "nonsense", minor=minor, is_answered=False), request(b"none", "x", is_answered=False))
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
                self.assertEqual(struct.unpack_from("<II", found, 12), (1, requests.NEEDS_KEY))
                self.assertEqual(found[-2:], b"\0\0")
                self.assertEqual(giop.size(found), len(found) - 12)


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
        self.assertEqual(result(self.client().ask(*fragments(message, *range(8192, len(message), 8192)))), bytes(4))
        self.assertTrue(self.port.taken.pop() == data)

    def test_of_several_requests_at_once(self):
        here = self.client()
        one, other = [fragments(request(self.key, "put", block(b"%d" % i * 50), number=i), 50, 70) for i in (1, 2)]
        locate = fragments(request(self.key, "", number=3, kind=requests.LOCATE), 24)
        here.send(one[0], other[0], locate[0], other[1], request(self.key, "_non_existent", number=4), one[1], other[2], locate[1], one[2])
        self.assertEqual([struct.unpack_from("<I", here.answer(), 12)[0] for _ in range(4)], [4, 2, 3, 1])
        self.assertEqual(self.port.taken, [b"2" * 50, b"1" * 50])

    def test_cancelled(self):
        here = self.client()
        first = fragments(request(self.key, "put", block(b"x" * 50)), 50)[0]
        self.assertEqual(result(here.ask(first, whole(requests.CANCEL, struct.pack("<I", 1)), request(self.key, "_non_existent"))), b"\0")
        self.assertEqual(here.ask(fragments(request(self.key, "put", block(b"x" * 50)), 50)[1]), ERROR)  # of nothing, now
        self.assertEqual(self.port.taken, [])


class Hostile(Served):
    def assertRefused(self, *messages):
        here = self.client()
        try:
            here.send(*messages)
        except (BrokenPipeError, ConnectionResetError):
            pass
        self.assertIn(here.last_words(), (ERROR[:5] + b"\0" + ERROR[6:], ERROR, b""))
        self.still_served()

    def test_what_is_no_request(self):
        put = request(self.key, "put", block(b""))
        for data in (b"GET / HTTP/1.1\r\n\r\n", b"GIOP\1\3" + put[6:], b"GIOP\2" + put[5:], whole(giop.REPLY, bytes(12)),
                     whole(requests.LOCATED, bytes(8)), whole(giop.FRAGMENT, bytes(8)), whole(9, b""), whole(0, b""),
                     whole(0, b"\xff" * 8 + bytes(4) + b"\xff" * 40),
                     whole(3, b"\0"), whole(0, b"\xff" * 40, 0), put[:40] + b"\xff" * 40, whole(0, put[12:40] + b"\xff" * 8),
                     whole(giop.FRAGMENT, b"", more=True), whole(0, b"", more=True), whole(0, b"12", 0, more=True),
                     struct.pack("<4s4BI", b"GIOP", 1, 2, 1, 0, giop.LARGEST + 1), b"GIOP\1\2\1\0\xff\xff\xff\xff"):
            self.assertRefused(data)

    def test_service_contexts_without_number(self):
        """Millions of empty ones would take seconds, during which nobody else were served."""
        head = request(self.key, "put")[:-4]
        self.assertRefused(whole(0, head[12:] + struct.pack("<I", 1 << 20) + bytes(8 << 20)))

    def test_the_other_side_ends(self):
        for kind in (giop.CLOSE, giop.ERROR):
            here = self.client()
            here.send(whole(kind, b""))
            self.assertEqual(here.last_words()[7:8], bytes([giop.CLOSE]))

    def test_half_messages_block_nobody(self):
        put = request(self.key, "put", block(b"x" * 100))
        for cut in range(1, len(put), 7):
            self.client().send(put[:cut])
        self.still_served()
        slow = self.client()
        for octet in put:
            slow.send(bytes([octet]))
        self.assertEqual(result(slow.answer()), bytes(4))

    def test_nothing_is_allocated_for_what_is_announced(self):
        callers = [self.client() for _ in range(30)]
        for each in callers:
            each.send(struct.pack("<4s4BI", b"GIOP", 1, 2, 1, 0, giop.LARGEST), b"x" * 100)
        self.still_served()
        self.assertLess(max(caller.held() for caller in list(server._server.callers)), 64 * server.ROOM)

    def test_endless_fragments(self):
        first, rest = fragments(request(self.key, "put", block(b"x" * 2000000)), 1000000)
        more = whole(giop.FRAGMENT, rest[12:], more=True)
        self.assertRefused(first, *[more] * (giop.LARGEST // 1000000 + 5))
        self.assertRefused(*[fragments(request(self.key, "put", number=i, body=bytes(40)), 50)[0] for i in range(20)])
        self.assertRefused(fragments(request(self.key, "put", bytes(40), minor=0), 50)[0])

    def test_much_that_is_never_complete(self):
        """Who has waited for longest gives way to others."""
        with mock.patch.object(server, "MOST_OCTETS", 8 << 20):
            callers = [self.client() for _ in range(12)]
            for each in callers:
                each.send(struct.pack("<4s4BI", b"GIOP", 1, 2, 1, 0, giop.LARGEST), bytes(1 << 20))
            end = time.monotonic() + LIMIT
            self.still_served()
            data = os.urandom(3 << 20)
            self.assertEqual(self.ask(self.key, "put", block(data)), bytes(4))
            self.assertTrue(self.port.taken.pop() == data)
            while sum(caller.held() for caller in list(server._server.callers)) > 8 << 20:
                self.assertLess(time.monotonic(), end)

    def test_answers_that_nobody_reads(self):
        here, ask = self.client(), request(self.key, "_non_existent")
        here.socket.settimeout(1)
        with self.assertRaises(socket.timeout):
            while True:
                here.socket.sendall(ask * 1000)
        self.still_served()
        self.assertLess(max(len(caller.out) for caller in list(server._server.callers)), 1000)

    def test_a_thousand_connections(self):
        with mock.patch.object(server, "MOST", 40):
            kept = self.client()
            self.assertEqual(result(kept.ask(request(self.key, "_non_existent"))), b"\0")
            first = self.client()
            for _ in range(1000):
                socket.create_connection(("127.0.0.1", self.at), LIMIT).close()
            for _ in range(60):
                self.client()
                self.assertEqual(result(kept.ask(request(self.key, "_non_existent"))), b"\0")  # it is used: it stays
            self.assertIn(first.last_words()[7:8], (bytes([giop.CLOSE]), b""))

    def test_idle_and_unfinished_connections_end(self):
        idle, half = self.client(), self.client()
        for each in (idle, half):
            self.assertEqual(result(each.ask(request(self.key, "_non_existent"))), b"\0")
        half.send(b"GIOP")
        busy, now = self.client(), time.monotonic()
        with mock.patch.object(server, "UNFINISHED", 0.5), mock.patch.object(server, "SWEEP", 0.1):
            while time.monotonic() < now + 0.2:
                self.assertEqual(result(busy.ask(request(self.key, "_non_existent"))), b"\0")
            self.still_served()
            self.assertEqual(half.last_words()[7:8], bytes([giop.CLOSE]))
            with mock.patch.object(server, "IDLE", 0.5):
                self.assertEqual(idle.last_words(), CLOSE)
        self.still_served()

    def test_out_of_files(self):
        """Somebody who is idle gives way, and the thread does not end."""
        idle = self.client()
        self.assertEqual(result(idle.ask(request(self.key, "_non_existent"))), b"\0")
        true, failures = server._server.listening, [OSError(24, "Too many open files")]

        class Listening:
            def accept(self):
                if failures:
                    raise failures.pop()
                return true.accept()
        with mock.patch.object(server._server, "listening", Listening()):
            self.still_served()


class Places(unittest.TestCase):
    """Where we listen, and what the references say."""

    def setting(self, words="", **variables):
        names = {name: value for name, value in os.environ.items() if not name.startswith("ORB")}
        with mock.patch.dict(os.environ, dict(names, RTCTREE_ORB_ARGS=words, **variables), clear=True):
            return server._setting("endPoint"), server._setting("endPointPublish")

    def test_settings_of_omniorb(self):
        none = ("", 0)
        self.assertEqual(self.setting(), (none, none))
        self.assertEqual(self.setting("-ORBendPoint;giop:tcp:10.0.0.1:2810;-ORBtraceLevel;0"), (("10.0.0.1", 2810), none))
        self.assertEqual(self.setting("-ORBendPoint;giop:tcp::;-ORBendPointPublish;giop:tcp:robot:"), (none, ("robot", 0)))
        self.assertEqual(self.setting(ORBendPoint="giop:tcp:[::1]:", ORBendPointPublish="giop:tcp:a:1,giop:tcp:b:2"),
                         (("::1", 0), ("a", 1)))
        for ignored in ("giop:unix:/tmp/x", "addr", "all(addr)", "giop:tcp:", "", "nonsense"):
            self.assertEqual(self.setting(ORBendPoint=ignored, ORBendPointPublish=ignored), (none, none), ignored)
        self.assertEqual(self.setting("-ORBendPoint"), (none, none))

    def test_listening(self):
        for host, port in (("", 0), ("127.0.0.1", 0), ("localhost", 0)):
            made = server._listening(host, port)
            self.addCleanup(made.close)
            socket.create_connection(("127.0.0.1", made.getsockname()[1]), LIMIT).close()
        for host, port in (("192.0.2.222", 0), ("no.such.host.invalid", 0), ("127.0.0.1", 99999), ("a..b", 0)):
            with self.assertRaises(errors.Usage, msg=(host, port)):
                server._listening(host, port)
        with self.assertRaises(errors.Usage):
            server._listening("127.0.0.1", made.getsockname()[1])


class Callers(Served):
    """Called by real ORBs."""

    def setUp(self):
        super().setUp()
        before = lanes.session
        lanes.session = lanes.Session(LIMIT)
        self.addCleanup(setattr, lanes, "session", before)
        profiles = references.at("127.0.0.1", self.at, self.key).profiles
        self.text = references.Reference(b"IDL:OpenRTM/InPortCdr:1.0", profiles).text()

    def test_our_own(self):
        ref = client.narrow(client.from_text("w", self.text), "dataport.OpenRTM.InPortCdr")
        for size in (0, 5, 1000000):
            self.assertEqual(client.invoke(orb.Call("w", ref, "put", b"x" * size)), PORT_OK)
            self.assertEqual(len(self.port.taken.pop()), size)

    @unittest.skipIf(omniORB is None, "needs omniORBpy")
    def test_omniorb(self):
        from rtshell_lite.corba import omni
        from rtshell_lite.idl_stubs.dataport import OpenRTM
        ref = omni.narrow(omni.from_text("w", self.text), "dataport.OpenRTM.InPortCdr")
        self.assertTrue(ref._is_a("IDL:OpenRTM/InPortCdr:1.0"))
        self.assertFalse(ref._non_existent())
        for size in (0, 5, 8100, 8192, 8300, 20000, 1000000, 5000000):
            data = os.urandom(size)
            self.assertEqual(ref.put(data), OpenRTM.PORT_OK)
            self.assertTrue(self.port.taken.pop() == data, size)
        with self.assertRaises(errors.Refused) as caught:
            omni.invoke(orb.Call("w", ref, "put", b"raise"))
        self.assertEqual(caught.exception.name, "UNKNOWN")
        self.withdraw()
        with self.assertRaises(errors.Gone):
            omni.invoke(orb.Call("w", ref, "put", b""))


if __name__ == "__main__":
    unittest.main()
