"""Rings and triggers without any port: what a ring holds, what is kept of it, and which conditions hold."""
import glob
import os
import struct
import time
import types
import unittest
from unittest import mock

from rtshell_lite import errors
from rtshell_lite.data import datatypes, reading
from rtshell_lite.datalog import gaps, incidents, logfile, recorder, ring, triggers
from rtshell_lite.net import loop
from test_datalog import CHANNELS, START, Case

SECOND = 10 ** 9


class Clock:
    """A time that passes when a test says so, in the place of loop.wall and loop.now."""

    def __init__(self):
        self.now = START / 1e9

    def __call__(self):
        return self.now


class Ring(Case):
    def setUp(self):
        Case.setUp(self)
        self.clock = Clock()
        self.number = 0
        self.kept = []
        for name in ("wall", "now"):
            patch = mock.patch.object(loop, name, self.clock)
            patch.start()
            self.addCleanup(patch.stop)

    def parts(self, span=4, size=None, leave=0):
        made = ring.Parts(self.name + ".mcap", CHANNELS, START, ring.ring_limits(span, size, leave))
        self.addCleanup(made.close)
        return made

    def memory(self, span=4, size=1 << 20):
        return ring.Memory(CHANNELS, span, size)

    def incidents(self, before=4, after=2):
        return incidents.Incidents(self.name + ".mcap", before, after, self.kept.append)

    def run_for(self, seconds, made, incidents=None, step=0.1):
        """Write a message every `step` seconds, and let the Incidents do their work."""
        for _ in range(round(seconds / step)):
            self.clock.now += step
            if incidents:
                incidents.protect(made)
            made.write([(0, int(self.clock.now * 1e9), True, b"%08d" % self.number)])
            self.number += 1
            if incidents:
                incidents.step(made, self.clock.now * 1e9)

    @staticmethod
    def numbers(name):
        with logfile.load(name) as log:
            return [int(entry.data) for entry in log.entries()]

    def test_a_ring_is_bounded(self):
        made = self.parts()
        self.run_for(60, made)
        names = glob.glob(self.name + "-*")
        self.assertLessEqual(len(names), ring.PARTS + 3)
        held = sorted(number for name in names for number in self.numbers(name))
        self.assertEqual(held, list(range(held[0], self.number)))
        self.assertGreaterEqual(len(held), 40)

    def test_a_ring_of_octets_is_bounded(self):
        made = self.parts(None, 100000)
        self.run_for(600, made)
        self.assertLess(sum(map(os.path.getsize, glob.glob(self.name + "-*"))), 130000)

    def test_a_trigger_keeps_before_and_after(self):
        for make in (self.parts, self.memory):
            self.kept.clear()
            made = make()
            incidents = self.incidents()
            for wait in (10, 3, 17.3):
                self.run_for(wait, made, incidents)
                at = self.number - 1
                incidents.trigger("cause")
                self.run_for(4, made, incidents)
                numbers = self.numbers(self.kept[-1])
                self.assertEqual(numbers, list(range(numbers[0], numbers[-1] + 1)))
                self.assertTrue(abs(numbers[0] - max(0, at - 40)) <= 1 or wait == 3, (numbers[0], at))
                self.assertLessEqual(abs(numbers[-1] - at - 20), 1)
            self.assertEqual(len(self.kept), 3)

    def test_what_is_missing_is_kept(self):
        for make in (self.parts, self.memory):
            made = make()
            incidents = self.incidents()
            self.run_for(10, made, incidents)
            for before in (9, 2):
                moment = int((self.clock.now - before) * 1e9)
                made.put_gap(gaps.Gap(moment, moment, {"a": before}, "lost"))
            incidents.trigger("cause")
            self.run_for(4, made, incidents)
            with logfile.load(self.kept[-1]) as log:
                self.assertEqual([gap.counts for gap in log.gaps], [{"a": 2}])

    def test_a_death_is_noticed_late(self):
        """A ring of 4 s has 4 s before the death, which happened up to a second before somebody noticed."""
        for make in (lambda: self.parts(), lambda: self.memory(4 + ring.LATE)):
            self.kept.clear()
            made = make()
            incidents = self.incidents()
            self.run_for(20, made, incidents)
            conditions = triggers.parse(["death"])
            with mock.patch.object(triggers, "SIGNAL", None):
                seen = triggers.Triggers(conditions, incidents, mock.Mock(take=lambda: False))
            seen.hear({"event": "DIED", "path": "/x.rtc"})
            died = self.number - 10
            for words, delay in seen._causes():
                incidents.trigger(words, delay=delay)
            self.run_for(4, made, incidents)
            self.assertLessEqual(self.numbers(self.kept[0])[0], died - 40)

    def test_triggers_during_an_incident_are_further_causes(self):
        made = self.memory()
        incidents = self.incidents()
        self.run_for(5, made, incidents)
        for words in ("first", "second", "third"):
            incidents.trigger(words)
            self.run_for(0.5, made, incidents)
        self.run_for(5, made, incidents)
        self.assertEqual(len(self.kept), 1)
        with open(self.kept[0], "rb") as file:
            data = file.read()
        for words in (b"first", b"second", b"third"):
            self.assertIn(words, data)

    def test_names_are_never_taken_twice(self):
        made = self.memory()
        incidents = self.incidents(1, 0)
        for _ in range(3):
            incidents.trigger("../../x y\x1b", START)
            self.run_for(1, made, incidents)
        self.assertEqual(len(set(self.kept)), 3)
        self.assertEqual({os.path.dirname(name) for name in self.kept}, {self.directory.name})

    def test_pending_parts_are_not_removed(self):
        """Even if it is copied slowly."""
        made = self.parts()
        incidents = self.incidents(4, 2)
        self.run_for(10, made, incidents)
        incidents.trigger("x")
        at = self.number
        with mock.patch("rtshell_lite.datalog.incidents.SLICE", 200):
            self.run_for(30, made, incidents)
        numbers = self.numbers(self.kept[0])
        self.assertEqual(numbers, list(range(numbers[0], numbers[-1] + 1)))
        self.assertLessEqual(abs(numbers[0] - at + 40), 1)

    def test_a_part_that_somebody_has_taken_is_all_that_is_lost(self):
        made = self.parts()
        incidents = self.incidents()
        self.run_for(5, made, incidents)
        taken = sorted(glob.glob(self.name + "-0*"))[1:]  # the last is being written
        self.assertGreater(len(taken), 1)
        lost = [number for name in taken for number in self.numbers(name)]
        for name in taken:
            os.remove(name)
        last = self.number
        incidents.trigger("x")
        self.run_for(4, made, incidents)
        numbers = self.numbers(self.kept[0])
        self.assertFalse(set(numbers) & set(lost))
        later = [number for number in numbers if number >= last + 15]  # in the part that follows
        self.assertEqual(later, list(range(last + 15, last + 15 + len(later))))
        self.assertGreater(len(later), 3)
        self.assertLess(numbers[0], lost[0])

    def test_nobody_else_goes_on_with_a_ring(self):
        made = self.parts()
        self.run_for(3, made)
        with self.assertRaisesRegex(errors.Failed, "another rtlog"):
            self.parts()
        self.run_for(1, made)
        made.close()
        self.parts()

    def test_late_triggers_and_values_are_kept(self):
        """A busy machine learns late of what has happened, and writes late what has come."""
        for make in (lambda: self.parts(), lambda: self.memory(4 + ring.LATE)):
            self.kept.clear()
            made = make()
            incidents = self.incidents(4, 2)
            self.run_for(20, made, incidents)
            incidents.trigger("x", int((self.clock.now - 1.5) * 1e9))
            at = self.number - 15
            waiting = []
            for _ in range(30):
                self.clock.now += 0.1
                waiting.append((0, int(self.clock.now * 1e9), True, b"%08d" % self.number))
                self.number += 1
            incidents.step(made, (self.clock.now - 3) * 1e9)
            self.assertEqual(self.kept, [])
            incidents.protect(made)
            made.write(waiting)
            incidents.step(made, self.clock.now * 1e9)
            numbers = self.numbers(self.kept[0])
            self.assertEqual(numbers, list(range(numbers[0], numbers[-1] + 1)))
            self.assertLessEqual(max(abs(numbers[0] - at + 40), abs(numbers[-1] - at - 20)), 1)

    def test_a_writer_that_stood_still_removes_nothing_that_is_pending(self):
        for make in (self.parts, self.memory):
            made = make()
            incidents = self.incidents(4, 2)
            self.run_for(20, made, incidents)
            incidents.trigger("x")
            at = self.number
            self.clock.now += 30
            self.run_for(0.2, made, incidents)
            self.assertEqual(self.numbers(self.kept[-1]), list(range(at - 41, at)))

    def test_values_that_came_before_a_part_was_begun_are_found(self):
        """It is in that part, though it came before."""
        made = self.parts()
        self.run_for(3, made)
        came = int(self.clock.now * 1e9)
        self.clock.now += 1
        made._next()
        made.write([(0, came, True, b"%08d" % self.number)])
        made._next()
        self.assertIn(self.number, [int(data) for _, _, _, data in made.past(came - SECOND, came)])

    def test_an_end_keeps_what_there_is(self):
        made = self.memory()
        incidents = self.incidents(4, 100)
        self.run_for(3, made, incidents)
        incidents.trigger("x")
        self.run_for(1, made, incidents)
        incidents.finish(made)
        self.assertEqual(self.numbers(self.kept[0]), list(range(40)))

    def test_a_disk_that_is_nearly_full(self):
        made = self.parts(40, None, 1)
        self.run_for(40, made)
        count = len(glob.glob(self.name + "-*"))
        free = iter([0, 0, 5] + [5] * 1000)
        with mock.patch.object(ring.Parts, "_free", lambda self: next(free)):
            self.run_for(1.2, made)
        self.assertLess(len(glob.glob(self.name + "-*")), count)
        with mock.patch.object(ring.Parts, "_free", lambda self: 0), self.assertRaisesRegex(
            OSError, "nearly full"
        ):
            self.run_for(1.2, made)


class Taking(unittest.TestCase):
    def test_all_that_came_before_it_was_taken_is_written(self):
        """Or a trigger's file could lack its end."""
        work = recorder.Recorder(recorder.Channels(None))
        sent = []
        written = []
        work._append = lambda batch, taken: written.append(
            (taken, [message.received for _, message in batch])
        )

        async def send():
            for _ in range(300):
                sent.append(int(time.time() * 1e9))
                work.box.put(0, reading.Message(sent[-1], b"", True))
                await loop.sleep(0)

        async def main():
            async with loop.background(work.run()):
                for _ in range(10):
                    await send()
                    await loop.sleep(0.02)

        with mock.patch.object(work.box, "gather", 0.001):
            loop.run(main())
        found = 0
        self.assertGreater(len(written), 3)
        for taken, batch in written:
            found += len(batch)
            self.assertGreaterEqual(found, sum(moment < taken for moment in sent))


class Conditions(unittest.TestCase):
    def test_wrong_ones(self):
        for words in ("", "errors", "silent x", "x.y > 5", "silent a:b x", "a:b", "a:b.c ="):
            with self.assertRaises(errors.Usage):
                triggers.parse([words])

    def happened(self, words, numbers, name="/h/c/A.rtc:out"):
        """How many times a condition held for TimedLongs of these numbers."""
        (condition,) = triggers.parse([words])
        type = datatypes.Types().named("TimedLong")
        taken = []
        count = 0
        take = condition.wrap((name,), type, taken.append)
        for number in numbers:
            take(types.SimpleNamespace(data=struct.pack("<IIi", 0, 0, number), little=True))
            count += len(list(condition.causes()))
        self.assertEqual(len(taken), len(numbers))
        return count

    def test_comparisons(self):
        for words, count in (
            ("A.rtc:out.data > 5", 2),
            ("/h/c/A.rtc:out.data>5", 2),
            ("A.rtc:out.data == 9", 1),
            ("A.rtc:out.data <= -1.5", 0),
            ("B.rtc:out.data > 5", 0),
            ("A.rtc:out.nothing > 5", 0),
            ("A.rtc:out.tm > 5", 0),
            ("A.rtc:out.data == x", 0),
            ("A.rtc:out.data != x", 1),
            ("A.rtc:out.tm.sec == 0", 1),
        ):
            self.assertEqual(self.happened(words, [1, 6, 7, 2, 9]), count, words)

    def test_one_that_can_never_be_true_is_reported(self):
        for words, why in (
            ("A.rtc:out.data > 5", None),
            ("B.rtc:out.data > 5", "no port has this name yet"),
            ("A.rtc:out.nothing > 5", "nothing: no such field"),
            ("silent A.rtc:out 5", None),
            ("silent B.rtc:out 5", "no port has this name yet"),
        ):
            (condition,) = triggers.parse([words])
            type = datatypes.Types().named("TimedLong")
            take = condition.wrap(("/h/c/A.rtc:out",), type, lambda message: None)
            take(types.SimpleNamespace(data=struct.pack("<IIi", 0, 0, 1), little=True))
            if why is None:
                self.assertIsNone(condition.remark)
            else:
                self.assertIn(why, condition.remark)

    def test_events(self):
        (condition,) = triggers.parse(["error"])
        condition.hear({"event": "ACTIVE", "path": "/h/A.rtc"})
        self.assertEqual(list(condition.causes()), [])
        condition.hear({"event": "ERROR", "path": "/h/A.rtc"})
        self.assertEqual((list(condition.causes()), list(condition.causes())), (["error A.rtc"], []))

    def test_silence_is_noticed_once(self):
        clock = Clock()
        with mock.patch.object(loop, "now", clock):
            (condition,) = triggers.parse(["silent A.rtc:out 0.5"])
            take = condition.wrap(("/h/A.rtc:out",), None, lambda message: None)
            clock.now += 9
            self.assertEqual(list(condition.causes()), [])  # nothing has come at all
            take(None)
            found = []
            for _ in range(5):
                clock.now += 0.3
                found.append(len(list(condition.causes())))
            take(None)
            clock.now += 1
            found.append(len(list(condition.causes())))
        self.assertEqual(found, [0, 1, 0, 0, 0, 1])


if __name__ == "__main__":
    unittest.main()
