"""How many values wait unread in a port, by what is known: if this fails, rtinject leaves too early, or says
what is not so.
"""
import unittest
from unittest import mock

from rtshell_lite.data import writing
from rtshell_lite.data.writing import SETTLE, Audience, Backlog, Cycle
from rtshell_lite.net import loop


class Filling(unittest.TestCase):
    def sent(self, rate, length, count, every):
        """A Backlog that `count` values have come to, one every `every` seconds."""
        backlog = Backlog(rate, length)
        for number in range(count):
            backlog.add(number * every)
        return backlog

    def test_one_value_is_read_a_period_later(self):
        backlog = self.sent(10.0, 8, 1, 0)
        self.assertEqual(backlog.waiting, 1)
        backlog.drain(0.05)
        self.assertAlmostEqual(backlog.waiting, 0.5)
        backlog.drain(0.2)
        self.assertEqual(backlog.waiting, 0)

    def test_at_the_rate_of_the_reader_none_is_lost(self):
        backlog = self.sent(100.0, 8, 10000, 0.01)
        self.assertLess(backlog.waiting, 1.01)
        self.assertEqual(backlog.lost, 0)

    def test_faster_than_the_reader(self):
        """A second at 1 kHz into 100 Hz: a buffer of 8 has lost all but 8 and the 100 that were read, one of
        1,000 none.
        """
        backlog = self.sent(100.0, 8, 1000, 0.001)
        self.assertAlmostEqual(backlog.lost, 892, delta=1)
        self.assertEqual(backlog.waiting, 8)
        backlog = self.sent(100.0, 1000, 1000, 0.001)
        self.assertEqual(backlog.lost, 0)
        self.assertAlmostEqual(backlog.waiting, 900, delta=1)

    def test_a_full_buffer_shows_how_fast_it_is_read(self):
        """It claims 1,000 Hz and reads 100 times a second: 40 values of which four wait, and ten times as
        long for those.
        """
        backlog = Backlog(1000.0, 4, refuses=True)
        for number in range(4):
            backlog.add(0.0)
        for number in range(36):
            backlog.fill(0.01 * number + 0.005)
            backlog.add(0.01 * (number + 1))
        backlog.fill(0.365)
        self.assertTrue(backlog.measured())
        self.assertAlmostEqual(backlog.rate, 100.0)
        self.assertEqual((backlog.taken, backlog.waiting, backlog.lost), (40, 4, 0))
        self.assertGreater(backlog.seconds(), (4 + 1) / 100 + SETTLE)

    def test_that_it_is_full_says_nothing_before_it_is_read(self):
        backlog = Backlog(1000.0, 4, refuses=True)
        for moment in (0.0, 0.1, 0.2):
            backlog.fill(moment)
        self.assertFalse(backlog.measured())
        self.assertEqual((backlog.rate, backlog.waiting), (1000.0, 0))

    def test_all_but_the_last_have_been_read(self):
        """Though it seems to have read all: at a quarter less than it claims it has not."""
        backlog = Backlog(100.0, 4, refuses=True)
        for number in range(100):
            backlog.add(number * 0.01)
        self.assertAlmostEqual(backlog.seconds(), (4 + 1) / 100 + SETTLE)

    def test_a_reader_that_never_reads(self):
        backlog = self.sent(None, 8, 10, 1.0)
        self.assertEqual((backlog.waiting, backlog.lost), (8, 2))

    def test_a_reader_that_takes_values_late_may_read_them_late(self):
        backlog = Backlog(100.0, 8)
        usual = backlog.seconds()
        backlog.add(1.0, delay=0.3)
        backlog.add(1.1, delay=0.001)
        backlog.drain(2.0)
        self.assertAlmostEqual(backlog.seconds(), usual + 0.3 + 0.25 * 2 / 100)

    def test_how_long_reading_takes(self):
        """What waits, what a slower clock may have left, and a cycle."""
        self.assertAlmostEqual(self.sent(2.0, 8, 1, 0).seconds(), (1 + 0.25 + 1) / 2 + SETTLE)
        self.assertAlmostEqual(self.sent(1000.0, 5000, 1000, 0).seconds(), (1000 + 250 + 1) / 1000 + SETTLE)
        self.assertAlmostEqual(self.sent(100.0, 8, 1000, 0.01).seconds(), (8 + 1) / 100 + SETTLE, delta=0.001)


class Rest(unittest.TestCase):
    """Components of C++ may end when a connector is removed while they read from it."""

    def slept(self, rate, waiting=0.0, since=0.0, taken=1):
        """How long a writer waits that has written `since` seconds ago, while values wait in the buffer."""
        writer = mock.Mock(
            unanswered=0, taken=taken, last=100.0 - since, backlog=mock.Mock(rate=rate, waiting=waiting)
        )
        slept = []

        async def sleep(seconds):
            slept.append(seconds)
        with mock.patch.object(writing.loop, "now", lambda: 100.0), mock.patch.object(
            writing.loop, "sleep", sleep
        ):
            with self.assertRaises(StopIteration) as ended:  # it awaits nothing else
                writing.Writer.is_at_rest(writer).send(None)
        self.assertTrue(ended.exception.value)
        return sum(slept)

    def test_until_the_reader_has_read(self):
        for expected, found in (
            (0.15, self.slept(10.0)),
            (0.05, self.slept(10.0, since=0.1)),
            (0.03, self.slept(100.0, 3.0)),
            (0.0, self.slept(10.0, since=5.0)),
            (1.5 / writing.USUAL, self.slept(None, 3.0)),
        ):
            self.assertAlmostEqual(found, expected + writing.READING)

    def test_it_has_an_end(self):
        self.assertEqual((self.slept(0.1), self.slept(10.0, taken=0)), (writing.REST, 0))


class Lingering(unittest.TestCase):
    def lingered(self, seconds, late):
        """How long a value that is read within 0.35 s is waited for; each sleep takes `late` seconds longer.
        """
        now = [100.0]
        writer = mock.Mock(
            taken=1,
            backlog=mock.Mock(rate=10.0, seconds=lambda: 0.35),
            failure=None,
            judge=mock.Mock(),
            refusals=lambda: None,
        )

        async def sleep(pause):
            now[0] += pause + late

        async def each(writers, *_):
            return [None] * len(writers)

        with mock.patch.object(writing.loop, "now", lambda: now[0]), mock.patch.object(
            writing.loop, "sleep", sleep
        ), mock.patch.object(writing.session, "each", each):
            run_at_once(writing.linger([writer], seconds))
        return now[0] - 100.0

    def test_as_long_as_reading_takes(self):
        self.assertAlmostEqual(self.lingered(None, 0.0), 0.35, 2)

    def test_longer_on_a_computer_that_wakes_us_late(self):
        self.assertAlmostEqual(self.lingered(None, 0.5), 0.35 + 4 * 0.5, 2)
        self.assertAlmostEqual(self.lingered(5.0, 0.5), 0.35 + 4 * 0.5, 2)

    def test_that_delay_has_a_limit(self):
        self.assertAlmostEqual(self.lingered(None, 10.0), 20.2, 2)  # two sleeps

    def test_no_longer_than_the_user_wants(self):
        self.assertAlmostEqual(self.lingered(0.2, 0.0), 0.2, 2)
        self.assertAlmostEqual(self.lingered(0.2, 0.3), 0.4, 2)  # one sleep


def run_at_once(coroutine):
    """Run a coroutine that awaits nothing of a loop."""
    try:
        coroutine.send(None)
    except StopIteration:
        return
    raise AssertionError("it waits")


class Readers(unittest.TestCase):
    def reading(self, *cycles):
        """(why a component does not read, at which rate it does) with these contexts: (state, running, rate).
        """
        audience = Audience(mock.Mock(path="/localhost/a.rtc"), "/localhost/a.rtc:in")

        async def known():
            return [Cycle(index, rate, state, running) for index, (state, running, rate) in enumerate(cycles)]

        async def rate_of(ref):
            return ref
        audience._cycles = known
        audience._rate = rate_of
        return loop.run(audience.why_not_reading()), audience.rate

    def test_an_active_one_reads_in_the_fastest_context_that_runs(self):
        self.assertEqual(
            self.reading(("Active", True, 100.0), ("Active", True, 500.0), ("Active", True, None)),
            (None, 500.0),
        )
        self.assertEqual(
            self.reading(("Active", True, 100.0), ("Inactive", True, 500.0), ("Active", False, 1000.0)),
            (None, 100.0),
        )

    def test_others_do_not(self):
        for state, running, words in (
            ("Inactive", True, "rtact /localhost/a.rtc"),
            ("Active", False, "rtec /localhost/a.rtc start"),
            ("Inactive", False, "rtec /localhost/a.rtc start"),
        ):
            why, rate = self.reading((state, running, 100.0))
            self.assertIn(words, str(why))
            self.assertIsNone(rate)


if __name__ == "__main__":
    unittest.main()
