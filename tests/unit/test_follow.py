"""When followers of components look whether these are late. If one of these fails, a component that hangs is
noticed late, or 1,000 that are well cost much of a core.
"""
import unittest
from unittest import mock

from rtshell_lite import path
from rtshell_lite.live import follow, times
from rtshell_lite.net import loop


class Ended(Exception):
    """The time of a test is over."""


class Component(follow.Followed):
    beat = times.BEAT_SHOWN
    endpoint = "a", 1

    def __init__(self):
        super().__init__(path.parse("/a/b.rtc"))
        self.shown = self.subscription = mock.Mock(is_led=False)
        self.looked = 0

    @property
    def late_at(self):
        self.looked += 1
        return super().late_at


class Late(unittest.TestCase):
    def setUp(self):
        self.now = 100.0
        self.component = Component()
        self.presence = follow.Presence([self.component], 0.2)
        self.suspected = []
        self.presence.suspect = lambda endpoint: self.suspected.append(self.now)
        self.presence.lend_again = lambda each: None

    def look(self, seconds, is_heard=True):
        """Look around for some seconds, in which it calls us every second, or not at all."""
        end = self.now + seconds

        async def wait(pause):
            self.now += pause
            if is_heard:
                self.component.heard = int(self.now)
            if self.now > end:
                raise Ended
        bell = self.presence._alarm
        with mock.patch.object(loop, "now", lambda: self.now), mock.patch.object(bell, "wait", wait):
            with self.assertRaises(Ended):
                loop.run(self.presence._look_around())

    def test_one_that_calls_is_hardly_looked_at(self):
        self.component.heard = self.now
        self.look(60)
        self.assertLess(self.component.looked, 80)
        self.assertEqual(self.suspected, [])

    def test_one_that_is_late_is_suspected_at_once(self):
        self.component.heard = self.now
        self.look(10)
        since = self.component.heard
        self.look(3, is_heard=False)
        self.assertAlmostEqual(self.suspected[0], since + 1.5, delta=0.11)

    def test_so_is_a_new_one(self):
        self.component.heard = self.now
        self.component.subscription = None
        self.look(10.0, is_heard=False)
        self.component.subscription = mock.Mock(is_led=False)
        since = self.component.lived = self.now
        self.look(3, is_heard=False)
        self.assertAlmostEqual(self.suspected[0], since + 1.5, delta=0.11)


if __name__ == "__main__":
    unittest.main()
