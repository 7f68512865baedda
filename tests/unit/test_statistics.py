"""The figures of rtprint --stats, for fixed sequences of values."""
import math
import unittest
from unittest import mock

from rtshell_lite import errors
from rtshell_lite.data import statistics
from rtshell_lite.net import loop
from rtshell_lite.views import printing

MS = 10**6  # ns
BEGIN = 1500000000 * 10**9
PERIOD = 10 * MS


def figures(arrivals, stamps, size=8, dropped=0):
    """The summary of values that came at these times, with these timestamps (ms after BEGIN; None: without).
    """
    found = statistics.Flow()
    for number, (arrival, stamp) in enumerate(zip(arrivals, stamps)):
        found.add(
            BEGIN + int(arrival * MS),
            b"%0*d" % (size, number),
            None if stamp is None else BEGIN + int(stamp * MS),
        )
    return found.total.summary(2.0, dropped)


def cycles(*numbers):
    """Timestamps in ms of these cycles of 10 ms."""
    return [10 * number for number in numbers]


class Checked(unittest.TestCase):
    def check(self, found, **expected):
        for name, value in expected.items():
            if isinstance(value, float):
                self.assertAlmostEqual(found[name], value, 9, name)
            else:
                self.assertEqual(found[name], value, name)


class Counts(unittest.TestCase):
    def test_no_value_is_lost_and_little_is_kept(self):
        counts = statistics.Counts()
        for number in range(20000):
            counts.add(BEGIN + number * 10 * MS)
        self.assertEqual(sum(counts.spans.values()), 20000)
        self.assertLessEqual(len(counts.spans), statistics.SPANS)
        self.assertEqual(min(counts.spans), BEGIN // counts.width)
        self.assertEqual(max(counts.spans), (BEGIN + 199990 * MS) // counts.width)


class Figures(Checked):
    def test_all_figures(self):
        found = figures([0, 10, 40, 50], [-1, 9, 37, 50], 6)
        self.check(
            found,
            seconds=2.0,
            values=4,
            bytes=24,
            rate=60.0,
            gap_min=0.01,
            gap_mean=0.05 / 3,
            gap_max=0.03,
            jitter=math.sqrt(2 * (0.02 / 3) ** 2 / 3 + (0.04 / 3) ** 2 / 3),
            bytes_per_second=12.0,
            age_mean=0.00125,
            age_max=0.003,
            absent=0,
            missing=0,
            disordered=0,
            repeated=0,
            dropped=0,
        )
        self.assertEqual(len(found), 16)

    def test_extremes_are_neither_first_nor_last(self):
        self.check(
            figures([0, 10, 12, 42, 52], [None] * 5),
            gap_min=0.002,
            gap_max=0.03,
            gap_mean=0.013,
            rate=1 / 0.013,
        )

    def test_no_value_and_one(self):
        self.check(
            figures([], []),
            values=0,
            bytes=0,
            rate=None,
            gap_min=None,
            gap_mean=None,
            gap_max=None,
            jitter=None,
            bytes_per_second=0.0,
            age_mean=None,
            age_max=None,
            absent=None,
            missing=0,
            disordered=None,
            repeated=None,
        )
        self.check(
            figures([0], [0]),
            values=1,
            rate=None,
            jitter=None,
            age_mean=0.0,
            absent=0,
            disordered=0,
            repeated=0,
        )

    def test_no_time_at_all(self):
        self.assertIsNone(statistics.Stretch().summary(0, 0)["bytes_per_second"])

    def test_zero_is_no_timestamp(self):
        found = statistics.Flow()
        for number in range(3):
            found.add(BEGIN + number * PERIOD, bytes(8), 0)
        self.check(
            found.total.summary(1, 0), values=3, age_mean=None, absent=None, disordered=None, repeated=None
        )

    def test_clocks_that_differ(self):
        self.check(figures([0, 10], [5, 15]), age_mean=-0.005, age_max=-0.005)


class Cycles(Checked):
    """Figures from timestamps, which do not distinguish a source that overslept from values that were lost.
    """

    def test_regular(self):
        self.check(
            figures(range(0, 300, 10), cycles(*range(30))),
            absent=0,
            disordered=0,
            repeated=0,
            rate=100.0,
            jitter=0.0,
        )

    def test_a_source_that_overslept_has_lost_nothing(self):
        stamps = cycles(*range(20)) + [10 * number + 17 for number in range(20, 40)]
        self.check(figures(stamps, stamps), values=40, absent=2, missing=0)

    def test_in_words(self):
        stamps = cycles(*range(20)) + [220, 230, 260, 260, 270, 265]
        line = printing.figure_line(figures(range(0, 260, 10), stamps, dropped=2))
        self.assertEqual(line.partition("age ")[2].partition(", ")[2], "4 cycles did not come, "
                                                                       "disordered 1, repeated 1, "
                                                                       "dropped 2")
        self.assertNotIn("missing", line)
        stamps = cycles(*range(20)) + [210]
        self.assertIn(", 1 cycle did not come", printing.figure_line(figures(stamps, stamps)))

    def test_a_gap_of_whole_cycles_is_not_known_to_be_a_loss_either(self):
        stamps = cycles(*[n for n in range(40) if n not in (20, 21, 22)])
        self.check(figures(stamps, stamps), absent=3, missing=0)

    def test_gaps_below_one_and_a_half_periods_are_jitter(self):
        stamps = cycles(*range(20)) + [204, 214, 224]
        self.check(figures(stamps, stamps), absent=0)

    def test_values_close_after_a_gap_make_up_for_it(self):
        stamps = cycles(*range(20)) + [220, 222, 230]
        self.check(figures(stamps, stamps), absent=1)
        stamps = cycles(*range(20)) + [220, 222, 224, 226, 230]
        self.check(figures(stamps, stamps), absent=0)

    def test_a_gap_needs_a_known_usual_interval(self):
        few = cycles(*range(statistics.FIRST)) + [130, 140]
        self.check(figures(few, few), absent=0)
        enough = cycles(*range(statistics.FIRST + 1)) + [140, 150]
        self.check(figures(enough, enough), absent=3)

    def test_a_pause_is_no_gap(self):
        stamps = cycles(*range(20)) + [2000 + 10 * number for number in range(20)]
        self.check(figures(stamps, stamps), absent=0)
        stamps = cycles(*range(500)) + [5790 + 10 * number for number in range(20)]  # less than a second
        self.check(figures(stamps, stamps), absent=79)

    def test_another_rate_after_a_pause_is_the_usual_one_then(self):
        stamps = cycles(*range(20)) + [2000 + 100 * number for number in range(20)] + [4100]
        self.check(figures(stamps, stamps), absent=1)

    def test_disordered_and_repeated(self):
        stamps = cycles(0, 1, 3, 2, 4, 4, 4, 5)
        self.check(figures(cycles(*range(8)), stamps), disordered=1, repeated=2, absent=0)

    def test_the_same_value_twice(self):
        """OpenRTM-aist 2.1 repeats a value whose answer was lost: that is no value of the port's, early or
        late.
        """
        found = statistics.Flow()
        for number in range(30):
            for delay in (0, 1) if number % 10 == 5 else (0,):
                found.add(BEGIN + number * PERIOD + delay * MS, b"%d" % number, BEGIN + number * PERIOD)
        self.check(found.total.summary(0.3, 0), values=30, repeated=3, jitter=0.0, absent=0, disordered=0)

    def test_values_dropped_here_count_as_lost(self):
        self.check(figures([0, 10], [0, 10], dropped=7), dropped=7, missing=7, absent=0)


class Looks(Checked):
    def test_a_look_begins_a_new_stretch_and_gaps_reach_over_it(self):
        found = statistics.Flow()
        for number in range(20):
            found.add(BEGIN + number * PERIOD, bytes(4), BEGIN + number * PERIOD)
        self.check(found.take_recent().summary(1.0, 0), values=20, bytes=80, absent=0, rate=100.0)
        for number in (22, 23):
            found.add(BEGIN + number * PERIOD, bytes(4), BEGIN + number * PERIOD)
        self.check(
            found.take_recent().summary(1.0, 0), values=2, bytes=8, absent=2, gap_max=0.03, gap_min=0.01
        )
        self.check(found.take_recent().summary(1.0, 0), values=0, absent=None)
        self.check(found.total.summary(2.0, 0), values=22, bytes=88, absent=2)


class Meters(unittest.TestCase):
    def rates(self, *looks, failure=None, reader=None):
        """The Rates of a meter at these looks: (when, octets of each value that has come since the last one).
        """
        meter = statistics.Meter("a.rtc:out", failure)
        found = []
        meter.reader = reader
        for when, sizes in looks:
            for size in sizes:
                meter.take(mock.Mock(data=b"x" * size))
            with mock.patch.object(loop, "now", lambda when=when: when):
                found.append(meter.rate()[1:])
        return found

    def test_the_last_two_seconds(self):
        self.assertEqual(
            self.rates((10, [8]), (10.125, [8]), (11, [8, 8, 8]), (12, []), (13, [4] * 6), (14, [])),
            [
                (None, None, None),
                (None, None, None),
                (4, 32, None),
                (2, 16, None),
                (3, 12, None),
                (3, 12, None),
            ],
        )

    def test_a_failed_port_has_no_rate(self):
        gone = errors.Gone("a.rtc")
        lost = errors.Unreachable("a.rtc", "lost")
        self.assertEqual(
            self.rates((1, []), (2, [8]), failure=gone, reader=mock.Mock(failure=lost)),
            [(None, None, gone)] * 2,
        )
        self.assertEqual(
            self.rates((1, []), (2, [8]), reader=mock.Mock(failure=lost)), [(None, None, lost)] * 2
        )


if __name__ == "__main__":
    unittest.main()
