"""Logs in MessagePack, from anybody: whatever is sent, memory and time are bounded, and the next sender is
served.
"""
import gzip
import os
import random
import socket
import struct
import time
import tracemalloc
import unittest
from unittest import mock

import fluent
from rtshell_lite import errors, notes
from rtshell_lite.live import forward, msgpack
from rtshell_lite.net import loop

PAIR = [1795247382.25, fluent.record("INFO", "Motor0", "warm")]


class Messages(unittest.TestCase):
    def records(self, octets):
        tag, pairs, options = forward.pairs(octets)
        return [forward.record_of(tag, when, fields, "10.0.0.1") for when, fields in pairs], options

    def test_values(self):
        for octets, wanted in (
            (b"\x7f", 127),
            (b"\xff", -1),
            (b"\xcc\xff", 255),
            (b"\xcd\1\0", 256),
            (b"\xce\0\0\1\0", 256),
            (b"\xcf" + b"\xff" * 8, 2**64 - 1),
            (b"\xd0\x80", -128),
            (b"\xd1\x80\0", -32768),
            (b"\xd2\x80\0\0\0", -(2**31)),
            (b"\xd3" + b"\xff" * 8, -1),
            (b"\xca\x3f\x80\0\0", 1.0),
            (b"\xcb" + struct.pack(">d", 0.1), 0.1),
            (b"\xc0", None),
            (b"\xc2", False),
            (b"\xc3", True),
            (b"\xa3abc", "abc"),
            (b"\xd9\1a", "a"),
            (b"\xda\0\1\xff", "\udcff"),
            (b"\xc4\1a", b"a"),
            (b"\xc5\0\1a", b"a"),
            (b"\xdc\0\1\1", [1]),
            (b"\x92\1\2", [1, 2]),
            (b"\x81\xa1a\1", {"a": 1}),
            (b"\xde\0\1\xa1a\1", {"a": 1}),
            (b"\xd7\0\0\0\0\1\x1d\xcd\x65\0", 1.5),
            (b"\xc7\x08\0\0\0\0\1\x1d\xcd\x65\0", 1.5),
            (b"\xd4\5a", None),
            (b"\xc8\0\1\5a", None),
        ):
            with self.subTest(octets):
                self.assertEqual(msgpack.value(octets, 0), (wanted, len(octets)))
                scan = msgpack.Scan()
                for size in range(len(octets)):
                    self.assertIsNone(scan.end(octets[:size]))
                self.assertEqual(scan.end(octets + b"\xc1"), len(octets))

    def test_modes(self):
        for mode in ("message", "forward", "packed", "gzip"):
            records, options = self.records(fluent.message(mode, [PAIR], {"chunk": "x"}))
            self.assertEqual(options["chunk"], "x", mode)
            self.assertEqual(records, [(forward.Source("robot1/manager", "robot1/manager"),
                                        (1795247382.25, "Motor0", "INFO", "warm"))])

    def test_records_of_others(self):
        for fields, wanted in (({"log": (
            "hot"
        )}, "hot"), ({"a": 1, "b": None}, "a=1 b=None"), ("hot", "hot"), ({}, "")):
            ((source, record),), _ = self.records(fluent.message("message", [[17, fields]]))
            self.assertEqual((source.where, record), ("10.0.0.1", (17, "rtclog", "NORMAL", wanted)))
        ((_, record),), _ = self.records(fluent.message("forward", [[[17.5, {}], {"log": "hot"}]]))
        self.assertEqual(record.time, 17.5)
        ((_, record),), _ = self.records(fluent.message("message", [[None, {"log": "hot"}]]))
        self.assertLess(abs(record.time - time.time()), 60)

    def test_malformed(self):
        deep = b"\x91" * 100 + b"\1"
        bomb = fluent.pack(["t", __import__("gzip").compress(b"\0" * (40 << 20)), {"compressed": "gzip"}])
        for octets in (
            b"\xc1",
            b"\1",
            b"\x91\1",
            fluent.pack(["t", 1, {}, {}, 1]),
            deep,
            fluent.pack(["t", [1]]),
            fluent.pack(["t", [[1, 2, 3]]]),
            fluent.pack(["t", b"\x91"]),
            fluent.pack(["t", b"x", {"compressed": ("gzip")}]),
            bomb,
        ):
            with self.subTest(octets[:20]), self.assertRaises((msgpack.Malformed, struct.error, IndexError)):
                self.records(octets)
        with self.assertRaises(msgpack.Malformed):
            msgpack.Scan().end(b"\xdd\xff\xff\xff\xff")

    def test_a_record_has_few_values(self):
        """30 kB that unpack to 32 MB of values took 1.5 GB."""
        bomb = b"\x92\1\xdd\x00\x70\0\0" + b"\x80" * 0x700000
        for octets in (
            fluent.pack(["t", gzip.compress(bomb), {"compressed": "gzip"}]),
            fluent.pack(["t", bomb]),
            b"\x92\xa1t\x91" + bomb,
            b"\x92" + bomb[2:] + b"\x90",
        ):
            with self.subTest(octets[:20]):
                tracemalloc.start()
                try:
                    with self.assertRaises(msgpack.Malformed):
                        self.records(octets)
                    self.assertLess(tracemalloc.get_traced_memory()[1], 20 << 20)
                finally:
                    tracemalloc.stop()

    def test_parts_compressed_one_by_one(self):
        """As fluentd joins them; only the first was taken."""
        body = b"".join(gzip.compress(fluent.pack(PAIR)) for _ in range(3))
        records, _ = self.records(fluent.pack(["t", body, {"compressed": "gzip"}]))
        self.assertEqual(len(records), 3)
        with self.assertRaises(msgpack.Malformed):
            self.records(fluent.pack(["t", gzip.compress(b"") * 200, {"compressed": "gzip"}]))

    def test_a_long_message_is_cut(self):
        """7 MB of controls took 567 MB to print."""
        for fields in ({"message": "\1" * 7000000}, "\1" * 7000000, {"a": "\1" * 7000000}):
            ((source, record),), _ = self.records(fluent.message("message", [[17, fields]]))
            self.assertLess(len(record.message), 66000)
            self.assertIn("… (70000", record.message)
        fields = dict.fromkeys(("host", "manager", "name", "level"), "x" * 100000)
        ((source, record),), _ = self.records(fluent.message("message", [[17, fields]]))
        self.assertLess(len(source.where + record.logger + record.level), 20000)

    def test_any_octets(self):
        chance = random.Random(int(os.environ.get("RTSHELL_SEED", 1)))
        whole = [fluent.message(mode, [PAIR, PAIR]) for mode in ("message", "forward", "packed", "gzip")]
        for _ in range(2000):
            octets = bytearray(chance.choice(whole))
            for _ in range(chance.randrange(1, 6)):
                octets[chance.randrange(len(octets))] = chance.randrange(256)
            try:
                end = msgpack.Scan().end(octets)
                if end is not None:
                    self.records(bytes(octets[:end]))
            except (msgpack.Malformed, struct.error, IndexError):
                pass


class Doors(unittest.TestCase):
    def served(self, work, wanted, allowed=(), has_room=lambda: True):
        """Run work(port) on a thread beside a Door, until `wanted` records have come: (those, what was
        reported).
        """
        records = []
        reported = []

        async def main():
            door = forward.Door(("127.0.0.1", 0), allowed)
            bell = loop.Bell()

            def take(_, record):
                records.append(record.message)
                bell.ring()
            async with loop.background(door.serve(take, has_room)):
                result = await loop.on_thread(work, door.port)
                while len(records) < wanted:
                    self.assertTrue(await bell.wait(fluent.LIMIT))
                return result
        with mock.patch.object(notes, "note", reported.append):
            result = loop.run(main())
        return records, reported[1:], result

    def test_messages_come_in_pieces_and_are_answered(self):
        octets = fluent.message("packed", [PAIR] * 3, {"chunk": "abc"})

        def work(port):
            with socket.create_connection(("127.0.0.1", port), fluent.LIMIT) as connection:
                for at in range(0, len(octets), 50):
                    connection.sendall(octets[at:at + 50])
                return connection.recv(100)
        self.assertEqual(self.served(work, 3), (["warm"] * 3, [], b"\x81\xd9\3ack\xd9\3abc"))

    def test_one_that_sends_too_much_ends_alone(self):
        def work(port):
            with socket.create_connection(("127.0.0.1", port), fluent.LIMIT) as connection:
                try:
                    connection.sendall(b"\xdb\x7f\0\0\0" + b"x" * (forward.LARGEST + (1 << 20)))
                    connection.recv(1)
                except ConnectionError:
                    pass
            fluent.send(port, fluent.message("message", [PAIR]))
        records, reported, _ = self.served(work, 1)
        self.assertEqual((records, len(reported)), (["warm"], 1))
        self.assertIn("8 MB", reported[0])

    def test_silent_ones_give_way(self):
        def work(port):
            idle = [
                socket.create_connection(("127.0.0.1", port), fluent.LIMIT)
                for _ in range(forward.MOST_SENDERS)
            ]
            fluent.send(port, fluent.message("message", [PAIR]))
            self.assertEqual(idle[0].recv(1), b"")
            for connection in idle:
                connection.close()
        self.assertEqual(self.served(work, 1)[0], ["warm"])

    def test_records_without_end_blind_nobody(self):
        """One that sends more than its share waits, and others do not."""
        flood = fluent.pack(["t", gzip.compress(b"\x92\1\x80" * 300000), {"compressed": "gzip"}])

        def work(port):
            with socket.create_connection(("127.0.0.1", port), fluent.LIMIT) as hostile:
                hostile.sendall(flood)
                hostile.setblocking(False)
                try:
                    for _ in range(10000):
                        hostile.send(flood)
                except OSError:
                    pass  # it is not read any more
                with socket.socket() as other:
                    other.bind(("127.0.0.2", 0))
                    other.connect(("127.0.0.1", port))
                    other.sendall(fluent.message("message", [PAIR], {"chunk": "x"}))
                    other.settimeout(fluent.LIMIT)
                    other.recv(100)
        with mock.patch.object(forward, "VALUES", 1000):
            records, _, _ = self.served(work, 1)
        self.assertIn("warm", records)
        self.assertLess(len(records), 20000)

    def test_nothing_is_read_while_there_is_no_room(self):
        taken = []

        def has_room():
            taken.append(0)
            return len(taken) > 20

        def work(port):
            fluent.send(port, fluent.message("message", [PAIR]))
        with mock.patch.object(forward, "PAUSE", 0.01):
            self.assertEqual(self.served(work, 1, has_room=has_room)[0], ["warm"])

    def test_one_address_turns_itself_away(self):
        """Others keep their place, however long they were silent."""
        def work(port):
            with socket.socket() as other:
                other.bind(("127.0.0.2", 0))
                other.connect(("127.0.0.1", port))
                idle = [
                    socket.create_connection(("127.0.0.1", port), fluent.LIMIT)
                    for _ in range(forward.MOST_SENDERS + 5)
                ]
                self.assertEqual(idle[0].recv(1), b"")
                other.sendall(fluent.message("message", [PAIR]))
                for connection in idle:
                    connection.close()
        self.assertEqual(self.served(work, 1)[0], ["warm"])

    def test_messages_that_never_end(self):
        def work(port):
            with socket.create_connection(("127.0.0.1", port), fluent.LIMIT) as connection:
                connection.sendall(b"\x92")
                return connection.recv(1)
        with mock.patch.object(forward, "UNFINISHED", 0.2):
            _, reported, received = self.served(work, 0)
        self.assertEqual((len(reported), received), (1, b""))

    def test_addresses(self):
        octets = fluent.message("message", [PAIR])
        records, reported, _ = self.served(lambda port: fluent.send(port, octets), 1, ["127.0.0.1"])
        self.assertEqual((records, reported), (["warm"], []))

    def test_a_port_that_is_taken(self):
        with socket.socket() as other:
            other.bind(("", 0))
            other.listen(1)
            with self.assertRaises(errors.Failed):
                forward.Door(("0.0.0.0", other.getsockname()[1]))


if __name__ == "__main__":
    unittest.main()
