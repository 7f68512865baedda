"""Observers that are lent: if one of these fails, reports are trusted that cannot come, or some are left
behind.
"""
import unittest
from unittest import mock

from rtshell_lite import errors, path
from rtshell_lite.live import follow, hear, observer, times
from rtshell_lite.net import loop

TAKES = {"sdo.service.consumer.available_services": observer.OBSERVER}


class Subscription:
    """Notes what it was asked for."""

    log = []  # type: list
    refuses = False
    is_led = False
    reference = "a reference"
    where = "x"

    def __init__(self, node, interface, properties, heard, beats):
        self.endpoint = node.endpoint
        self.heard = heard

    async def attach(self):
        self.log.append("quiet" if self.is_led else "beating")
        if self.refuses:
            raise errors.Refused("x", "no")

    async def detach(self):
        self.log.append("detached")

    def forget(self):
        """Nothing more comes."""


class Component(follow.Followed):
    def __init__(self, leaders, endpoint):
        super().__init__(path.parse("/a/b.rtc"))
        self.shown = mock.Mock()
        self.shown.node.endpoint = endpoint
        self.leaders = leaders


class Leaders(unittest.TestCase):
    """One component of each process sends heartbeats."""

    def setUp(self):
        Subscription.log = []
        Subscription.refuses = False
        self.now = 1000.0
        for where, name, value in (
            (observer, "Subscription", Subscription),
            (loop, "now", lambda: self.now),
        ):
            patched = mock.patch.object(where, name, value)
            patched.start()
            self.addCleanup(patched.stop)
        self.leaders = hear.Leaders(self.of_process)
        self.components = [Component(self.leaders, ("h", 1)) for _ in range(4)]
        self.components.append(Component(self.leaders, ("h", 2)))
        self.lend(*self.components)
        self.look()

    def of_process(self, endpoint):
        return [entry for entry in self.components if entry.endpoint == endpoint]

    @property
    def log(self):
        return Subscription.log

    def lend(self, *components):
        async def run():
            for entry in components:
                await entry.observe(TAKES)

        loop.run(run())

    def look(self, seconds=0.0):
        self.now += seconds
        return self.leaders.look(self.now)

    def led(self):
        return [entry.is_led for entry in self.components]

    def test_the_first_sends_heartbeats(self):
        self.assertEqual(self.led(), [False, True, True, True, False])
        self.assertEqual(self.log, ["beating", "quiet", "quiet", "quiet", "beating"])

    def test_reports_are_trusted_while_the_process_calls(self):
        self.assertFalse(self.leaders.hears(("h", 1)), "nobody knows yet whether it can call")
        self.components[0].hear(observer.Event(0.0, "HEARTBEAT", "", "HEARTBEAT"))
        self.assertTrue(self.leaders.hears(("h", 1)))
        self.assertFalse(self.leaders.hears(("h", 2)))
        self.now += times.LATE + 1
        self.assertFalse(self.leaders.hears(("h", 1)))

    def test_the_others_are_lent_their_observers_again_by_turns(self):
        for entry in self.components:
            entry.heard = self.now + 1000
        self.assertEqual(self.look(1.0), [])
        again = [entry for _ in range(3) for entry in self.look(times.BEAT)]
        self.assertEqual(len(again), 3)
        self.assertEqual(set(again), set(self.components[1:4]))
        self.assertEqual(self.led(), [False, True, True, True, False])

    def test_another_one_leads_where_the_first_has_ended_or_hangs(self):
        self.components[0].is_hung = True
        (second,) = self.look(1.0)
        self.assertTrue(self.components[0].is_led)
        self.assertFalse(second.is_led)
        second.forget()
        (third,) = self.look(1.0)
        self.assertIsNot(third, second)
        self.assertFalse(third.is_led)
        self.assertEqual(self.look(1.0), [])

    def test_another_one_leads_where_the_first_is_late(self):
        self.now += times.LATE + 1
        self.assertEqual(self.leaders.late(self.now), [self.components[0], self.components[4]])
        second, alone = self.look()
        self.assertTrue(self.components[0].is_led and not second.is_led)
        self.assertIs(alone, self.components[4], "there is no other one")
        self.assertFalse(alone.is_led)
        self.assertEqual(self.leaders.late(self.now), [])

    def test_where_all_hang_nobody_else_leads(self):
        for entry in self.components[:4]:
            entry.is_hung = True
        self.assertEqual(self.look(), [], "all hang")
        self.assertEqual(self.led(), [False, True, True, True, False])

    def test_a_process_that_is_gone_has_none(self):
        self.components[4].forget()
        self.look()
        self.components.append(Component(self.leaders, ("h", 2)))
        self.lend(self.components[5], self.components[4])
        self.assertEqual((self.components[5].is_led, self.components[4].is_led), (False, True))

    def test_who_refuses_has_none(self):
        Subscription.refuses = True
        self.components[1].forget()
        self.lend(self.components[1])
        self.assertIsNone(self.components[1].subscription)

    def test_all_are_taken_back(self):
        del self.log[:]
        loop.run(hear.take_all_back(self.components))
        self.assertEqual(self.log, ["detached"] * 5)
        self.assertEqual([entry.subscription for entry in self.components], [None] * 5)


if __name__ == "__main__":
    unittest.main()
