"""Where one connector follows another: if this fails, a recording has a hole, or values twice, after rtlog
was late.
"""
import random
import struct
import unittest
from unittest import mock

from rtshell_lite.data import clocks, reading, seam
from rtshell_lite.datalog import lateness
from rtshell_lite.net import loop


def stamped(number):
    return reading.Message(number, struct.pack("<LLl", 1700000000, number, 0), True)


def unstamped(number):
    """A value without a time: all are alike."""
    return reading.Message(number, struct.pack("<LLl", 0, 0, 7), True)


class Joint(unittest.TestCase):
    def setUp(self):
        self.delivered = []
        self.joint = seam.Seam(self.delivered.append, clocks.seconds)

    def numbers(self):
        return [message.received for message in self.delivered]

    def join(self, make, old, sure, held, late):
        """`old` values come by the old connector, `sure` of them before the new one is made; the new one
        brings `held` before the old one ends, `late` afterwards.
        """
        for number in range(old):
            if number == sure:
                self.joint.connected()
            self.joint.take_old(make(number))
        if old <= sure:
            self.joint.connected()
        for number in held:
            self.joint.take_new(make(number))
        self.joint.end()
        for number in late:
            self.joint.take(make(number))

    def test_each_value_is_delivered_once(self):
        for seed in range(300):
            chance = random.Random(seed)
            self.setUp()
            old = chance.randrange(0, 30)
            begun = chance.randrange(0, old + 1)  # the first value that is sent through both
            split = chance.randrange(begun, 41)
            sure = min(old, begun + chance.randrange(2))
            self.join(stamped, old, sure, range(begun, split), range(split, 40))
            self.assertEqual(self.numbers(), list(range(40)), seed)
            self.assertIsNone(self.joint.gap)

    def test_values_without_a_time_are_not_lost(self):
        """Where they cannot be told apart, rather twice than never."""
        self.join(unstamped, 10, 6, range(6, 8), range(8, 20))
        self.assertEqual(len(self.delivered), 20)
        self.setUp()
        self.join(unstamped, 10, 7, range(6, 8), range(8, 20))
        self.assertEqual(len(self.delivered), 21)

    def test_what_neither_has_brought_is_noticed(self):
        """The buffer of the new connector was too short: 5 to 9 came by the old one, 10 to 14 are
        overwritten.
        """
        self.join(stamped, 10, 5, range(15, 18), range(18, 20))
        self.assertEqual(self.numbers(), [*range(10), *range(15, 20)])
        self.assertEqual(self.joint.gap, (9, 15))

    def test_what_has_waited_since_before_the_new_one_was_made_proves_nothing(self):
        """With omniORB values wait for the loop: 5 to 9 came before the new connector was made."""
        waiting = [stamped(number) for number in range(5, 10)]

        def pass_on():
            while waiting:
                self.joint.take_old(waiting.pop(0))

        self.joint = seam.Seam(self.delivered.append, clocks.seconds, pass_on)
        self.join(stamped, 5, 5, range(10, 12), range(12, 14))
        self.assertEqual(self.numbers(), list(range(14)))
        self.assertIsNone(self.joint.gap)

    def test_what_the_new_one_lacks_may_have_come_by_the_old_one(self):
        self.join(stamped, 10, 5, range(8, 12), range(12, 14))
        self.assertEqual(self.numbers(), list(range(14)))
        self.assertIsNone(self.joint.gap)

    def test_memory_is_bounded(self):
        with mock.patch.object(seam, "MOST_BYTES", 10 * (12 + seam.EACH)):
            for number in range(1000):
                self.joint.take_old(stamped(number))
        self.assertLessEqual(len(self.joint._old), 10)


class Reader:
    """A reading.Reader of 100 values a second, whose port can queue `room` of them."""

    def __init__(self, room):
        self.room = room
        self.count = 1000
        self.connector = object()
        self.missed = []

    def rate(self):
        return 100.0

    def miss(self, *what):
        self.missed.append(what)


class StoodStill(unittest.TestCase):
    """rtlog stands still for 4 s: a port that can queue 256 values loses about 150 of 400, and is reported.
    """

    def missed(self, room, lost, pauses=((1, 4 * 10 ** 9),)):
        reader = Reader(room)
        clock = mock.Mock(return_value=0.0)

        async def sleep(seconds):
            clock.return_value += seconds
            reader.count += round(100 * seconds)

        with mock.patch.object(loop, "now", clock), mock.patch.object(loop, "sleep", sleep):
            buffered = lateness._Buffered(reader)
            clock.return_value = 5.0
            reader.count += 500 - lost
            coroutine = lateness._report_missing([buffered], list(pauses))
            with self.assertRaises(StopIteration):
                coroutine.send(None)
        return reader.missed

    def test_a_gap_is_reported(self):
        (first, last, count, why), = self.missed(256, 150)
        self.assertEqual((first, last, count), (1, 4 * 10 ** 9, 150))

    def test_nothing_is_missing(self):
        self.assertEqual(self.missed(256, 0), [])
        self.assertEqual(self.missed(4096, 0), [])

    def test_a_component_that_sends_less_at_times_is_not_said_to_lose(self):
        self.assertEqual(self.missed(4096, 150), [])


if __name__ == "__main__":
    unittest.main()
