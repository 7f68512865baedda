"""Our own ORB, many calls at once on one thread: each gets its own answer, whatever becomes of the others."""
import functools
import gc
import struct
import tracemalloc
import unittest

from giop_client import answer
from peers import CLOSE, Calls, compute
from world import Blocked
from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.corba.iiop import calls, client, connections
from rtshell_lite.giop import descriptors, messages, operations
from rtshell_lite.net import loop


class Loop(Calls):
    """Many calls at once on this thread."""

    def test_four_at_a_time_in_any_order(self):
        def play(pending):
            if len(pending) < min(4, 10 - len(done)):
                return None
            replies = b"".join(answer(number, bytes([number % 2])) for number, _ in reversed(pending))
            done.extend(pending)
            pending.clear()
            return replies

        done = []
        peer = self.script(play)

        async def ask():
            return await orb.call("w", peer.ref, "_non_existent")

        values = self.run_tasks(*[(peer.ref, ask)] * 10)
        self.assertEqual(values, [True, False] * 5)
        self.assertEqual((peer.most, len(peer.connections)), (4, 1))

    def test_any_number_to_a_name_server(self):
        def play(pending):
            if len(pending) < 30:
                return None
            replies = b"".join(answer(number) for number, _ in pending)
            pending.clear()
            return replies

        peer = self.script(play)
        context = client.narrow(peer.ref, "CosNaming.NamingContext")

        async def ask():
            return await orb.call("w", context, "_non_existent")

        self.assertEqual(self.run_tasks(*[(peer.ref, ask)] * 30), [False] * 30)

    def test_fragments_of_several_replies(self):
        """They may be mixed, in GIOP 1.2."""
        def cut(whole):
            number = whole[12:16]
            first = whole[:6] + b"\3\1" + struct.pack("<I", 12) + whole[12:24]
            rest = b"GIOP\1\2\1\7" + struct.pack("<I", 4 + len(whole) - 24) + number + whole[24:]
            return first, rest

        def play(pending):
            if len(pending) < 2:
                return None
            (one, one_end), (other, other_end) = [
                cut(answer(number, bytes([number == 2]))) for number, _ in pending
            ]
            pending.clear()
            return one + other + one_end + other_end

        peer = self.script(play)

        async def ask():
            return await orb.call("w", peer.ref, "_non_existent")

        self.assertEqual(self.run_tasks(*[(peer.ref, ask)] * 2), [False, True])

    def outcomes(self, replies, *calls):
        """What calls of one process, (interface, operation) each, come to; the replies are sent together."""
        peer = self.script(lambda pending: b"".join(replies) if len(pending) == len(calls) else None)

        async def outcome(interface, operation):
            try:
                return await orb.call("w", client.narrow(peer.ref, interface), operation)
            except errors.Unreachable as e:
                return e.why

        found = self.run_tasks(*[(peer.ref, functools.partial(outcome, *call)) for call in calls])
        self.assertEqual(len(peer.connections), 1)
        return found

    def test_an_answer_that_is_too_long(self):
        """No more of it is taken than shows that; those before and after it on the same connection arrive."""
        replies = [answer(1), answer(2, bytes(7 * messages.LARGE + 5)), answer(3, b"\1")]
        tracemalloc.start()
        self.addCleanup(tracemalloc.stop)
        found = self.outcomes(replies, *[("RTC.RTObject", "_non_existent")] * 3)
        self.assertEqual(found, [False, "garbled answer (more than 4194304 octets)", True])
        joined = 2 * sum(map(len, replies))  # by the peer, which is in this process, and by the network
        self.assertLess(tracemalloc.get_traced_memory()[1], joined + 4 * messages.LARGE)

    def test_a_long_answer_of_data_beside_one_that_is_too_long(self):
        data = bytes(range(256)) * (messages.LARGE // 128)
        replies = [answer(2, struct.pack("<II", 0, len(data)) + data), answer(1, data), answer(3)]
        found = self.outcomes(
            replies,
            ("RTC.RTObject", "_non_existent"),
            ("OpenRTM.OutPortCdr", "get"),
            ("RTC.RTObject", "_non_existent"),
        )
        self.assertEqual(found[0], "garbled answer (more than 4194304 octets)")
        self.assertEqual((str(found[1][0]), found[1][1] == data), ("PORT_OK", True))
        self.assertIs(found[2], False)

    def test_replies_that_nobody_waits_for(self):
        """Some peers repeat a reply: those that are waited for count."""
        ask = ("RTC.RTObject", "_non_existent")
        replies = [
            answer(1, b"\1"),
            answer(1),
            answer(7),
            answer(1),
            answer(2, b"\1"),
            answer(2),
            answer(3, b"\1"),
        ]
        self.assertEqual(self.outcomes(replies, ask, ask, ask), [True, True, True])

    def test_fragments_that_nobody_asked_for(self):
        replies = [answer(1)[:6] + b"\3" + answer(number)[7:] for number in range(1000, 3000)]
        self.assertEqual(
            self.outcomes(replies, ("RTC.RTObject", "_non_existent")),
            ["garbled answer (a reply to another request)"],
        )

    def test_an_answer_in_fragments_that_is_too_long(self):
        """No more of it is kept than of one in a piece; the next one arrives."""
        first = answer(1)[:6] + b"\3" + answer(1)[7:]
        rest = b"GIOP\1\2\3\7" + struct.pack("<II", 4 + (1 << 20), 1) + bytes(1 << 20)
        last = b"GIOP\1\2\1\7" + struct.pack("<II", 4, 1)
        replies = [first] + [rest] * 20 + [last, answer(2)]
        tracemalloc.start()
        self.addCleanup(tracemalloc.stop)
        found = self.outcomes(replies, *[("RTC.RTObject", "_non_existent")] * 2)
        self.assertEqual(found, ["garbled answer (more than 4194304 octets)", False])
        self.assertLess(tracemalloc.get_traced_memory()[1], sum(map(len, replies)) + 4 * messages.LARGE)

    def test_answers_before_the_end_of_a_connection_count(self):
        """Answers count, and what ends it shows at once, whatever else is under way: a last word, garbage,
        half a fragment.
        """
        def before(octets):
            def play(pending):
                if len(pending) < 2 and len(peer.connections) == 1 or not pending:
                    return None
                number, _ = pending[0]
                pending.clear()
                return answer(number, bytes(4)) + octets
            peer = self.script(play)
            return peer

        slow = self.script(
            lambda pending: compute(0.5) or b"".join(answer(pending.pop()[0]) for _ in pending[:]) or None
        )
        for octets in (CLOSE, b"HTTP/1.1 400 Bad", b"GIOP\1\2\1\7" + bytes(4)):
            peer = before(octets)
            begun = self.world.time
            ended = []

            async def ask():
                try:
                    return await orb.call("w", client.narrow(peer.ref, "RTC.RTObject"), "exit")
                finally:
                    ended.append(self.world.time - begun)

            self.run_tasks((peer.ref, ask), (peer.ref, ask), self.asking(slow.ref))
            self.assertLess(max(ended), 0.1, octets)

    def test_octets_of_ended_connections_are_freed(self):
        """It goes at once, without a collection."""
        half = answer(1)[:8] + struct.pack("<I", 1 << 20) + bytes(1 << 19) + CLOSE
        refs = [self.peer(half).ref for _ in range(20)]
        gc.disable()
        self.addCleanup(gc.enable)
        tracemalloc.start()
        self.addCleanup(tracemalloc.stop)
        values = self.run_tasks(*map(self.asking, refs))
        self.assertEqual([str(value.why) for value in values], ["connection lost"] * 20)
        self.assertLess(tracemalloc.get_traced_memory()[0], 4 << 20)

    def test_requests_that_the_peer_has_not_begun_are_sent_again(self):
        """However often it closes: here after each answer."""
        def play(pending):
            return answer(pending[0][0], bytes(4)) + CLOSE if pending else None

        peer = self.script(play)
        ref = client.narrow(peer.ref, "RTC.RTObject")
        values = self.run_tasks(*[self.asking(ref, "exit")] * 6)
        self.assertEqual([str(value) for value in values], ["RTC_OK"] * 6)
        self.assertEqual(len(peer.connections), 6)

    def test_requests_that_the_peer_has_begun_to_answer_are_not_sent_again(self):
        def play(pending):
            if not pending:
                return None
            number, _ = pending.pop()
            whole = answer(number, bytes(4))
            if number == 1:
                return whole
            asked.append(number)
            return whole[:6] + b"\3" + whole[7:] + CLOSE

        asked = []
        peer = self.script(play)
        ref = client.narrow(peer.ref, "RTC.RTObject")

        async def twice():
            await orb.call("w", ref, "exit")
            return await orb.call("w", ref, "exit")

        value, = self.run_tasks((ref, twice))
        self.assertEqual((value.why, asked), ("connection lost", [2]))

    def test_a_call_that_is_repeated(self):
        """Each gets its own answer, in whatever form it comes; an exception and a silence end only theirs."""
        def reply(number):
            whole = answer(number, struct.pack("<i", number))
            if number == 3:  # a stray before it
                return answer(1, struct.pack("<i", 77)) + whole
            if number == 4:  # in fragments
                return whole[:6] + b"\3" + whole[7:8] + struct.pack("<I", 12) + whole[12:24] + (
                    b"GIOP\1\2\1\7" + struct.pack("<I", 8) + whole[12:16] + whole[24:])
            if number == 5:
                name = b"IDL:omg.org/CORBA/NO_PERMISSION:1.0\0"
                return answer(number, struct.pack("<I", len(name)) + name + struct.pack("<II", 0, 1), 2)
            if number == 6:  # with octets too many
                return answer(number, bytes(64))
            if number == 7:
                return answer(number, struct.pack(">i", number), order=">")
            if number == 9:  # nothing for now
                return b""
            if number == 10:
                return answer(9, bytes(4)) + whole
            return whole

        def play(pending):
            octets = b"".join(reply(number) for number, _ in pending)
            pending.clear()
            return octets or None

        peer = self.script(play)
        get = operations.Schema("get", [], [descriptors.LONG], {})
        call = None

        async def repeat():
            nonlocal call
            call = orb.repeated("w", peer.ref, get, seconds=0.3)
            return [await outcome() for _ in range(12)]

        async def outcome():
            try:
                return await call()
            except errors.Error as e:
                return e.why

        self.assertEqual(self.wait_for(repeat()), [
            1, 2, 3, 4, "CORBA.NO_PERMISSION", "garbled answer (60 octets more than it should have)", 7,
            8, "no answer within 0.3s", 10, 11, 12])
        self.assertEqual(len(peer.connections), 1)

    def test_a_call_that_is_repeated_is_never_sent_twice(self):
        def play(pending):
            asked.extend(pending)
            octets = b"".join(answer(number, bytes(4)) for number, _ in pending)
            pending.clear()
            if len(asked) == 3:
                return b""
            return octets or None

        asked = []
        peer = self.script(play)
        get = operations.Schema("get", [], [descriptors.LONG], {})

        async def repeat():
            call = orb.repeated("w", peer.ref, get, seconds=1)
            found = []
            for _ in range(4):
                try:
                    found.append(await call())
                except errors.ConnectionLost:
                    found.append("lost")
            return found

        self.assertEqual(self.wait_for(repeat()), [0, 0, "lost", 0])
        self.assertEqual((len(asked), len(peer.connections)), (4, 2))

    def test_requests_given_up_before_there_was_a_connection_are_not_sent(self):
        port = self.script_of(answer).port

        async def exchange():
            connection = connections.TcpConnection(("127.0.0.1", port))
            request = calls.Request(
                orb.Call("w", client.from_url("w", "corbaloc::127.0.0.1:1/x"), "_non_existent", (), None),
                None,
                3,
            )
            connection.send(request)
            connection.give_up(1)
            connection.send(request)
            while connection.waits_for:
                await loop.sleep(0.01)
                connection.go_on()
            connection.flush()
            replies = []
            while not replies:
                await loop.sleep(0.01)
                replies = connection.replies(True)
            connection.close()
            return [messages.number(reply) for reply in replies]

        self.assertEqual(self.wait_for(exchange()), [2])

    def test_an_unsendable_request_costs_only_itself(self):
        peer = self.script(lambda pending: answer(pending.pop(0)[0]) if pending else None)

        async def ask(operation, *args):
            return await orb.call("w", peer.ref, operation, *args)
        wrong, right = self.run_tasks(
            (peer.ref, lambda: ask("_is_a", "a\0b")), (peer.ref, lambda: ask("_non_existent"))
        )
        self.assertIsInstance(wrong, errors.Refused)
        self.assertIs(right, False)

    def test_a_connection_lost_among_several_questions(self):
        """What was asked by it is asked again, once."""
        def play(pending):
            replies = b"".join(answer(number) for number, _ in pending[:1])
            lost = len(pending) > 1 and not losses
            if lost:
                losses.append(len(pending))
            elif len(pending) == 1 or losses:
                replies = b"".join(answer(number) for number, _ in pending)
            pending.clear()
            return b"" if lost else replies or None

        losses = []
        peer = self.script(play)

        async def ask():
            return await orb.call("w", peer.ref, "_non_existent")

        self.assertEqual(self.run_tasks((peer.ref, ask)), [False])
        self.assertEqual(self.run_tasks(*[(peer.ref, ask)] * 3), [False] * 3)
        self.assertEqual(len(peer.connections), 2)

    def test_bugs_are_not_failures_of_the_peer(self):
        async def spoilt():
            raise KeyError("x")

        with self.assertRaises(KeyError):
            self.run_tasks((client.from_url("w", "corbaloc::127.0.0.1:1/x"), spoilt))

    def test_names_of_hosts(self):
        """They are looked up by a thread; one that takes long costs only itself."""
        peer = self.script(lambda pending: answer(pending[-1][0]) if pending else None)
        self.world.host("slow", "10.0.0.2")

        def hang(name):
            raise Blocked

        self.host.look_up = hang
        slow, here = [
            client.from_url("w", f"corbaloc::{host}:{peer.port}/x") for host in ("slow", "localhost")
        ]
        values = self.run_tasks(self.asking(slow), self.asking(here))
        self.assertIsInstance(values[0], errors.Silent)
        self.assertIs(values[1], False)


if __name__ == "__main__":
    unittest.main()
