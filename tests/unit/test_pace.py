"""When the entries of a log come that is played: if this fails, a recording is replayed at another speed."""

import unittest
from unittest import mock

from peers import Calls
from rtshell_lite.datalog import pace, play, records
from rtshell_lite.net import loop

START = 1700000000 * 10**9


def entries(count, step):
    """So many Entries, one each `step` nanoseconds."""
    return [records.Entry(number, START + number * step, 0, True, b"", None) for number in range(count)]


def range_of(listed):
    """A Range that gives these."""
    return mock.Mock(entries=lambda log, first=None: iter(listed))


class Times(Calls):
    def times(self, coming):
        """When each comes, in seconds."""

        async def main():
            begun = loop.now()
            return [loop.now() - begun async for _ in coming]

        return self.wait_for(main())

    def test_they_come_when_they_are_due(self):
        """`seconds` end them."""
        listed = entries(4, 10**8)
        chosen = range_of(listed)
        for coming, expected in (
            (pace.Pace(None, chosen, 2).entries(), [0, 0.05, 0.1, 0.15]),
            (pace.Pace(None, chosen, 1, 0.15).entries(), [0, 0.15, 0.3, 0.3]),
            (pace.Pace(None, chosen, 1, None, 0.15).entries(), [0, 0.1]),
            (pace.Pace(None, chosen, 10, None, 0.105, True).entries(), [0, 0.01, 0.02, 0.03, 0.1]),
            (play.portions(listed, 3, 0.1), [0, 0, 0, 0.1]),
        ):
            times = self.times(coming)
            self.assertEqual(len(times), len(expected))
            for taken, due in zip(times, expected):
                self.assertAlmostEqual(taken, due, 3)

    def test_the_end_comes_in_time_where_playing_falls_behind(self):
        """Ports that take a value in 50 ms are played 1,000 that came within a second, for 0.3 s."""
        listed = entries(1000, 10**6)
        paced = pace.Pace(None, range_of(listed), 1, None, 0.3)

        async def play_slowly(coming):
            async for _ in coming:
                await loop.sleep(0.05)

        for coming in (paced.entries(), play.portions(listed, 1, 0.001, 0.3)):
            spent, _ = self.seconds(play_slowly(coming))
            self.assertLess(spent, 0.3 + pace.GRACE + 0.06)
        self.assertGreater(paced.behind, 0.3)

    def test_a_moment_again_and_again(self):
        """It takes some time, and others go on."""
        beats = []

        async def beat():
            while True:
                beats.append(1)
                await loop.sleep(0.001)

        async def main():
            async with loop.background(beat()):
                paced = pace.Pace(None, range_of(entries(1, 0) * 40), 1, None, 0.15, True)
                return len([entry async for entry in paced.entries()])

        self.assertEqual(self.wait_for(main()), 80)
        self.assertGreater(len(beats), 4)


if __name__ == "__main__":
    unittest.main()
