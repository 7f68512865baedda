"""Our own ORB: what it writes is what omniORB reads, and the other way round; nothing that a peer sends costs
more than one line.
"""
import gc
import struct
import unittest

import peers
from giop_client import answer
from peers import CLOSE, forward
from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.giop import descriptors, fixed_size
from rtshell_lite.corba.iiop import calls, client, connections
from rtshell_lite.giop import marshal, messages, operations, references

NOBODY = 1  # a port at which nobody listens


class Messages(unittest.TestCase):
    """GIOP as octets."""

    def test_request(self):
        found = bytes(messages.request(7, (1, 2), messages.KEY, b"\3\0\0\0key", "op", []))
        self.assertEqual(
            found,
            b"GIOP\1\2\1\0"
            + struct.pack("<I", len(found) - 12)
            + struct.pack("<I", 7)
            + b"\3\0\0\0"
            + bytes(4)
            + b"\3\0\0\0key\0"
            + b"\3\0\0\0op\0\0"
            + struct.pack("<IIIBxxxII", 1, 1, 12, 1, 0x00010001, 0x00010109),
        )

    def test_arguments_begin_at_a_multiple_of_8(self):
        written = []
        messages.request(
            1, (1, 2), messages.KEY, b"k" * 5, "op", [(lambda out, value: written.append(len(out) % 8), None)]
        )
        self.assertEqual(written, [0])

    def test_versions(self):
        for minor, principal in ((0, 4), (1, 4)):
            found = bytes(messages.request(9, (1, minor), messages.KEY, b"\4\0\0\0key!", "op", []))
            self.assertEqual(found[4:6], bytes([1, minor]))
            self.assertEqual(struct.unpack_from("<II", found, 12), (0, 9))
            self.assertEqual(found[-principal:], bytes(principal))

    def test_replies(self):
        for order, flag in (("<", 1), (">", 0)):
            head = b"GIOP\1\2" + bytes([flag, 1]) + struct.pack(order + "I", 16)
            self.assertEqual(messages.reply(head + struct.pack(order + "IIII", 5, 0, 0, 0)), (5, 0, flag, 24))
            old = b"GIOP\1\0" + bytes([flag, 1]) + struct.pack(order + "I", 28)
            contexts = struct.pack(order + "III", 1, 77, 3) + b"abc\0"
            self.assertEqual(
                messages.reply(old + contexts + struct.pack(order + "II", 5, 2)), (5, 2, flag, 36)
            )

    def test_garbage(self):
        for data in (
            b"HTTP/1.1 200",
            b"GIOP\2\0\1\1\0\0\0\0",
            b"GIOP\1\3\1\1\0\0\0\0",
            b"GIOP\1\2\1\x09\0\0\0\0",
            b"GIOP\1\2\1\1\xff\xff\xff\x7f",
        ):
            with self.assertRaises(messages.Garbled, msg=data):
                messages.size(data)
        with self.assertRaises((messages.Garbled, struct.error)):
            messages.reply(b"GIOP\1\2\1\1" + bytes(12) + struct.pack("<III", 1, 1, 0xfffffff0))


class References(unittest.TestCase):
    def test_addresses(self):
        for url, wanted in (
            ("corbaloc:iiop:1.2@host:2809/Name%20Service", ("host", 2809, b"Name Service")),
            ("corbaloc:iiop:1.0@[::1]:1/x", ("::1", 1, b"x")),
            ("corbaloc::a:5/", ("a", 5, b"")),
        ):
            ref = client.from_url("w", url)
            self.assertEqual(ref.address[1:], wanted)
            again = references.from_text(ref.text())
            self.assertEqual((again.address, again.target()), (ref.address, ref.target()))
        self.assertEqual(client.from_url("w", "corbaloc:iiop:1.0@a:1/x").target()[0], (1, 0))
        for url in (
            "corbaloc:shmiop:x/y",
            "https://a/b#c",
            "corbaloc:iiop:a",
            "corbaloc:iiop:1.3@a/x",
            "corbaloc:iiop:a:70000/x",
        ):
            with self.assertRaises(errors.BadPath):
                client.from_url("w", url)

    def test_identity(self):
        one, other = [client.from_url("w", f"corbaloc::a:5/{key}") for key in "xy"]
        self.assertTrue(client.same(one, client.from_url("w", "corbaloc:iiop:1.0@a:5/x")))
        self.assertFalse(client.same(one, other))
        self.assertIs(client.narrow(one, "RTM.Manager").profiles, one.profiles)


class Calls(peers.Calls):
    """_non_existent of an object at a peer that does this and that."""

    def ask(self, *answers, times=1):
        self.answering = self.peer(*answers)
        for _ in range(times):
            found = self.wait_for(orb.call("w", self.answering.ref, "_non_existent"))
        return found

    def hang_up(self):
        """Have the process that answers close its last connection."""
        self.answering.connections[-1].shutdown(None)
        self.world.run(self.world.time + 1)

    def test_answers(self):
        for order in "<>":
            for minor in (0, 1, 2):
                self.assertIs(self.ask(answer(1, b"\1", minor=minor, order=order)), True)

    def test_fragments(self):
        whole = answer(1, b"\1")
        for cut in (24, 25):
            first = whole[:6] + b"\3\1" + struct.pack("<I", cut - 12) + whole[12:cut]
            rest = (
                b"GIOP\1\2\1\7" + struct.pack("<I", 4 + len(whole) - cut) + struct.pack("<I", 1) + whole[cut:]
            )
            self.assertIs(self.ask(first + rest), True)

    def test_connections_that_are_closed(self):
        self.assertIs(self.ask(answer(1), None, answer(1, b"\1"), times=2), True)  # an old one: asked again
        self.assertIs(self.ask(answer(1) + CLOSE, answer(1, b"\1"), times=2), True)
        for answers in ((None,) * 3, (CLOSE,)):  # thrice, as it may speak an older GIOP
            with self.assertRaises(errors.Unreachable) as caught:
                self.ask(*answers)
            self.assertEqual(caught.exception.why, "connection lost")

    def test_several_profiles(self):
        """Where nobody listens at the first address, the next one is asked, for the key that the object has
        there.
        """
        peer = self.peer(answer(1), answer(2))
        profiles = [
            references.make_reference("127.0.0.1", port, key).profiles[0]
            for port, key in ((NOBODY, b"here"), (peer.port, b"there"))
        ]
        for _ in range(2):
            self.wait_for(orb.call("w", references.Reference(b"", tuple(profiles)), "_non_existent"))
            self.assertIn(b"there", peer.last)

    def test_a_process_that_was_started_again(self):
        """What changes something is not sent into the connection that has ended, and cannot be sent twice."""
        self.answering = self.peer(answer(1, bytes(4)), answer(1, bytes(4)))
        ref = client.narrow(self.answering.ref, "RTC.RTObject")
        self.wait_for(orb.call("w", ref, "exit"))
        self.hang_up()
        self.assertEqual(str(self.wait_for(orb.call("w", ref, "exit"))), "RTC_OK")

    def test_connections_that_peers_have_closed_are_not_kept(self):
        self.ask(answer(1))
        endpoint = ("127.0.0.1", self.answering.port)

        async def sweep():
            connections.sweep(self.session.memory)

        self.wait_for(sweep())
        connection, = self.session.memory.idle[endpoint]
        self.hang_up()
        self.wait_for(sweep())
        self.assertNotIn(endpoint, self.session.memory.idle)
        self.assertIsNone(connection.wanted()[0])

    def test_garbage(self):
        for bad, why in (
            (b"HTTP/1.1 400 Bad Request\r\n\r\n", "not GIOP"),
            (answer(2) * 101, "replies to other requests"),
            (answer(1, b""), "it ends too early"),
            (b"GIOP\1\2\1\6" + bytes(4), "the peer did not understand us"),
            (answer(1, status=9), "a reply of status 9"),
            (b"GIOP\1\2\1\7" + bytes(4), "it ends too early"),
            (b"GIOP\1\2\1\1\xff\xff\xff\xff", "a message of 4294967295 octets"),
        ):
            with self.assertRaises(errors.Unreachable, msg=bad) as caught:
                self.ask(bad)
            self.assertEqual(caught.exception.why, f"garbled answer ({why})")

    def test_a_reply_of_many_small_parts(self):
        with self.assertRaises(errors.Unreachable) as caught:
            self.ask(answer(1, bytes(5 << 20)))
        self.assertEqual(caught.exception.why, "garbled answer (more than 4194304 octets)")

    def test_exceptions(self):
        def system(number, name, minor):
            type_id = f"IDL:omg.org/CORBA/{name}:1.0".encode() + b"\0"
            return answer(
                number,
                struct.pack("<I", len(type_id))
                + type_id
                + bytes(-len(type_id) % 4)
                + struct.pack("<II", minor, 1),
                2,
            )

        for name, minor, kind, why in (
            ("OBJECT_NOT_EXIST", 0, errors.Gone, ""),
            ("TRANSIENT", 1, errors.Unreachable, "cannot be reached now"),
            ("MARSHAL", 0, errors.Unreachable, "garbled answer"),
            ("COMM_FAILURE", 0, errors.Unreachable, "lost"),
            ("BAD_PARAM", 0x41540015, errors.Refused, "BAD_PARAM_IndexOutOfRange"),
            ("NO_PERMISSION", 0, errors.Refused, "CORBA.NO_PERMISSION"),
            ("TIMEOUT", 0, errors.Silent, ""),
            ("N" * 100, 0, errors.Refused, "CORBA." + "N" * 60),
        ):
            with self.assertRaises(kind, msg=name) as caught:
                self.ask(*[system(number, name, minor) for number in (1, 2)])  # some are asked once more
            self.assertIn(why, str(caught.exception))
            self.assertLess(len(str(caught.exception)), 100)

    def test_forwards(self):
        target = self.peer(answer(1, b"\1"))
        self.assertIs(self.ask(forward(target.ref, 1)), True)
        self.assertEqual(target.asked, 1)

    def test_deadlines(self):
        with self.assertRaises(errors.Silent):
            self.ask(b"GIOP")
        self.assertTrue(self.session.timeout <= self.world.time < self.session.timeout + 0.2)

    def test_addressing_modes(self):
        """A peer may want the profile, or the whole reference, instead of the key."""
        for mode in (messages.PROFILE, messages.REFERENCE):
            peer = self.peer(
                answer(1, struct.pack("<h", mode), messages.NEEDS_ADDRESSING_MODE), answer(2, b"\1")
            )
            self.assertIs(self.wait_for(orb.call("w", peer.ref, "_non_existent")), True)
            self.assertEqual(peer.last[20:24], struct.pack("<HH", mode, 0))
            profile = peer.ref.profiles[0][1]
            # after the index, the empty type, the count
            where = 24 if mode == messages.PROFILE else 24 + 4 + 8 + 4
            self.assertEqual(
                peer.last[where : where + 8 + len(profile)], struct.pack("<II", 0, len(profile)) + profile
            )

    def test_other_addresses_of_a_reference(self):
        """The first is of another network, say."""
        first = client.from_url("w", f"corbaloc::127.0.0.1:{NOBODY}/x")
        both = references.Reference(b"", first.profiles + self.peer(answer(1, b"\1")).ref.profiles)
        self.assertIs(self.wait_for(orb.call("w", both, "_non_existent")), True)

    def test_hostile_references(self):
        """Such that other ORBs end from are not taken, let alone sent on."""
        for type_id in (b"IDL:\xff\xfe:1.0\0", b"x" * 2000 + b"\0"):
            data = (
                struct.pack("<I", len(type_id))
                + type_id
                + bytes(-len(type_id) % 4)
                + struct.pack("<III", 1, 0, 4)
                + b"\1\1\2\0"
            )
            with self.assertRaises(ValueError):
                marshal.Maker("<").reader((descriptors.OBJECT, "", ""))(data, 0)

    def test_sizes_that_a_32_bit_system_cannot_add_to_a_place(self):
        """There, unpack_from raises OverflowError for a place beyond 2 GiB, as it does beyond 8 EiB here."""
        read = marshal.Maker("<").reader((descriptors.OBJECT, "", ""))
        for words in ((0xfffffff0, 1, 0, 4), (1, 0, 2, 0, 0xfffffff0, 0, 4)):
            with self.assertRaises(fixed_size.Fault):
                read(struct.pack("<%dI" % len(words), *words), 0)

    def test_nothing_is_kept_of_a_failure(self):
        type_id = b"IDL:omg.org/CORBA/NO_PERMISSION:1.0\0"
        refusal = (
            struct.pack("<I", len(type_id)) + type_id + bytes(-len(type_id) % 4) + struct.pack("<II", 0, 1)
        )
        kept = []
        for number in range(3):
            with self.assertRaises(errors.Refused):
                self.ask(answer(1, refusal, 2))
            kept.append(len(operations._MAKERS[1].readers))
        self.assertEqual(kept[1], kept[2])

    def test_nothing_is_kept_of_an_answer(self):
        """A connection that is kept for later does not hold the request that it was made for."""
        def requests():
            gc.collect()
            return sum(isinstance(each, calls.Request) for each in gc.get_objects())
        before = requests()
        self.ask(answer(1))
        self.assertIn(("127.0.0.1", self.answering.port), self.session.memory.idle)
        self.assertEqual(requests(), before)

    def test_nobody_listens(self):
        ref = client.from_url("w", f"corbaloc::127.0.0.1:{NOBODY}/x")
        with self.assertRaises(errors.ConnectionRefused):
            self.wait_for(orb.call("w", ref, "_non_existent"))


if __name__ == "__main__":
    unittest.main()
