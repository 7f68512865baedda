"""Our own ORB as a server: no caller harms the others, or us, whatever it sends."""
import gc
import os
import socket
import struct
import time
import tracemalloc
import unittest
from unittest import mock

from giop_client import Port, block, fragments, request
from served import CLOSE, ERROR, LIMIT, Served, result
from rtshell_lite.corba.iiop import server
from rtshell_lite.giop import messages, requests
from rtshell_lite.net import loop

whole = messages.whole


class Hostile(Served):
    def assertRefused(self, *messages):
        here = self.client()
        try:
            here.send(*messages)
        except (BrokenPipeError, ConnectionResetError):
            pass
        self.assertIn(here.last_words(), (ERROR[:5] + b"\0" + ERROR[6:], ERROR, b""))
        self.still_served()

    def test_other_messages_are_no_requests(self):
        put = request(self.key, "put", block(b""))
        for data in (
            b"GET / HTTP/1.1\r\n\r\n",
            b"GIOP\1\3" + put[6:],
            b"GIOP\2" + put[5:],
            whole(messages.REPLY, bytes(12)),
            whole(requests.LOCATED, bytes(8)),
            whole(messages.FRAGMENT, bytes(8)),
            whole(9, b""),
            whole(0, b""),
            whole(0, b"\xff" * 8 + bytes(4) + b"\xff" * 40),
            whole(3, b"\0"),
            whole(0, b"\xff" * 40, 0),
            put[:40] + b"\xff" * 40,
            whole(0, put[12:40] + b"\xff" * 8),
            whole(messages.FRAGMENT, b"", more=True),
            whole(0, b"", more=True),
            whole(0, b"12", 0, more=True),
            struct.pack("<4s4BI", b"GIOP", 1, 2, 1, 0, messages.LARGEST + 1),
            b"GIOP\1\2\1\0\xff\xff\xff\xff",
        ):
            self.assertRefused(data)

    def test_service_contexts_without_number(self):
        """Millions of empty ones would take seconds, during which nobody else were served."""
        head = request(self.key, "put")[:-4]
        self.assertRefused(whole(0, head[12:] + struct.pack("<I", 1 << 20) + bytes(8 << 20)))

    def test_heads_without_measure(self):
        """Each caller's last one is kept, but not one this long."""
        much = "x" * 65536
        remembered = self.remembered()
        clients = []
        for message in (
            request(self.key, much),
            request(much.encode(), "put"),
            request(much.encode(), "", kind=requests.LOCATE),
            request(self.key, "put", block(b""), contexts=much.encode()),
            request(self.key, "put", block(b""), contexts=much.encode(), minor=0),
        ):
            for _ in range(20):
                clients.append(self.client())
                self.assertTrue(clients[-1].ask(message))
        self.assertLess(remembered(), 150 * len(much))  # of which the buffers of 100 callers are two thirds

    def test_long_texts(self):
        """Only data may take megabytes: each text would wait to be printed."""
        hint = struct.pack("<I", 0) + block(b"x" * (5 << 20) + b"\0")
        self.assertEqual(self.ask(self.observed, "update_status", hint), ("IMP_LIMIT", requests.NO))
        self.assertEqual(self.observer.heard, [])

    def test_the_other_side_ends(self):
        for kind in (messages.CLOSE, messages.ERROR):
            here = self.client()
            here.send(whole(kind, b""))
            self.assertEqual(here.last_words()[7:8], bytes([messages.CLOSE]))

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
            each.send(struct.pack("<4s4BI", b"GIOP", 1, 2, 1, 0, messages.LARGEST), b"x" * 100)
        self.still_served()
        self.assertLess(max(caller.held() for caller in list(self.server.callers)), 64 * server.ROOM)

    def test_endless_fragments(self):
        first, rest = fragments(request(self.key, "put", block(b"x" * 2000000)), 1000000)
        more = whole(messages.FRAGMENT, rest[12:], more=True)
        self.assertRefused(first, *[more] * (messages.LARGEST // 1000000 + 5))
        self.assertRefused(
            *[fragments(request(self.key, "put", number=i, body=bytes(40)), 50)[0] for i in range(20)]
        )
        self.assertRefused(fragments(request(self.key, "put", bytes(40), minor=0), 50)[0])

    def test_much_that_is_never_complete(self):
        """Who has waited for longest gives way to others."""
        with mock.patch.object(server, "MOST_OCTETS", 8 << 20):
            callers = [self.client() for _ in range(12)]
            for each in callers:
                each.send(struct.pack("<4s4BI", b"GIOP", 1, 2, 1, 0, messages.LARGEST), bytes(1 << 20))
            end = time.monotonic() + LIMIT
            self.still_served()
            data = os.urandom(3 << 20)
            self.assertEqual(self.ask(self.key, "put", block(data)), bytes(4))
            self.assertTrue(self.port.taken.pop() == data)
            while sum(caller.held() for caller in list(self.server.callers)) > 8 << 20:
                self.assertLess(time.monotonic(), end)

    def remembered(self):
        """A function that gives the octets of memory that have been taken since, and not given back."""
        gc.disable()  # what is dropped is to go at once
        tracemalloc.start()
        self.addCleanup(gc.enable)
        self.addCleanup(tracemalloc.stop)
        before, _ = tracemalloc.get_traced_memory()
        return lambda: tracemalloc.get_traced_memory()[0] - before

    def test_messages_that_have_been_answered(self):
        """They are not kept, however many callers there are."""
        put = request(self.key, "put", block(bytes(4 << 20)))
        remembered = self.remembered()
        with mock.patch.object(server, "MOST_OCTETS", 8 << 20):
            for sent in ([put], fragments(put, 1 << 20, 2 << 20)):
                for _ in range(12):
                    self.assertEqual(result(self.client().ask(*sent)), bytes(4))
                    self.port.taken.clear()
        self.assertLess(remembered(), 16 << 20)

    def test_messages_of_who_was_closed(self):
        """They are not kept, either."""
        half = struct.pack("<4s4BI", b"GIOP", 1, 2, 1, 0, messages.LARGEST) + bytes(4 << 20)
        remembered = self.remembered()
        with mock.patch.object(server, "MOST_OCTETS", 8 << 20):
            for _ in range(24):
                self.client().send(half)
            self.still_served()
        self.assertLess(remembered(), 32 << 20)

    def test_answers_that_nobody_reads(self):
        here = self.client()
        ask = request(self.key, "_non_existent")
        here.socket.settimeout(1)
        with self.assertRaises((socket.timeout, ConnectionError)):  # ConnectionError: it has asked too much
            while True:
                here.socket.sendall(ask * 1000)
        self.still_served()
        self.assertLess(max(len(caller.out) for caller in list(self.server.callers)), 1000)

    def test_a_caller_that_has_delivered_keeps_its_place(self):
        """Others, who ask and ask, are turned away, which is noted."""
        component, ask, before = (
            self.client(),
            request(self.key, "_non_existent"),
            self.server.session.turned_away,
        )
        self.assertEqual(result(component.ask(request(self.key, "put", block(b"1")))), bytes(4))
        with mock.patch.object(server, "MOST", 40), mock.patch.object(server, "MOST_OF_ADDRESS", 20):
            for _ in range(60):
                self.assertEqual(result(self.client().ask(ask)), b"\0")
            self.assertEqual(result(component.ask(request(self.key, "put", block(b"2")))), bytes(4))
        self.assertEqual(self.port.taken, [b"1", b"2"])
        self.assertGreaterEqual(self.server.session.turned_away - before, 40)

    def test_a_caller_that_only_asks_is_limited(self):
        """A connection that delivers nothing may not ask without end."""
        here = self.client()
        ask = request(self.key, "_non_existent")
        with mock.patch.object(server, "MOST_ASKED", 20):
            for _ in range(20):
                self.assertEqual(result(here.ask(ask)), b"\0")
            here.send(ask * 2)
            self.assertIn(CLOSE, here.last_words())
        self.still_served()

    def test_a_thousand_connections(self):
        with mock.patch.object(server, "MOST", 40):
            kept = self.client()
            self.assertEqual(result(kept.ask(request(self.key, "_non_existent"))), b"\0")
            first = self.client()
            for number in range(1000):
                socket.create_connection(("127.0.0.1", self.at), LIMIT).close()
                # or a server that is behind closes it: it was not used for longer than they
                if number % 10 == 0:
                    self.assertEqual(result(kept.ask(request(self.key, "_non_existent"))), b"\0")
            for _ in range(60):
                # the server is not behind
                self.assertEqual(result(self.client().ask(request(self.key, "_non_existent"))), b"\0")
                # it is used: it stays
                self.assertEqual(result(kept.ask(request(self.key, "_non_existent"))), b"\0")
            self.assertIn(first.last_words()[7:8], (bytes([messages.CLOSE]), b""))

    def test_idle_and_unfinished_connections_end(self):
        idle = self.client()
        half = self.client()
        for each in (idle, half):
            self.assertEqual(result(each.ask(request(self.key, "_non_existent"))), b"\0")
        half.send(b"GIOP")
        busy = self.client()
        now = time.monotonic()
        with mock.patch.object(server, "UNFINISHED", 0.5), mock.patch.object(server, "SWEEP", 0.1), \
                mock.patch.object(server, "MOST_ASKED", 10**6):
            while time.monotonic() < now + 0.2:
                self.assertEqual(result(busy.ask(request(self.key, "_non_existent"))), b"\0")
            self.still_served()
            self.assertEqual(half.last_words()[7:8], bytes([messages.CLOSE]))
            with mock.patch.object(server, "IDLE", 0.5):
                self.assertEqual(idle.last_words(), CLOSE)
        self.still_served()

    def test_who_waits_for_an_answer_is_not_idle(self):
        class Late(Port):
            async def put(port, data):
                self.server.sweep()
                await loop.sleep(0)
                return Port.put(port, data)

        key, _ = self.serve(Late())
        with mock.patch.object(server, "IDLE", -1.0):  # every connection, but for this reason
            self.assertEqual(self.ask(key, "put", block(b"x")), self.ask(self.key, "put", block(b"x")))

    def test_out_of_files(self):
        """Somebody who is idle gives way, and the thread does not end."""
        idle = self.client()
        self.assertEqual(result(idle.ask(request(self.key, "_non_existent"))), b"\0")
        true = self.server.listening
        failures = [OSError(24, "Too many open files")]

        class Listening:
            def accept(self):
                if failures:
                    raise failures.pop()
                return true.accept()
        with mock.patch.object(self.server, "listening", Listening()):
            self.still_served()


if __name__ == "__main__":
    unittest.main()
