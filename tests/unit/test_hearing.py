"""Observers that rttop lends: if one of these fails, it trusts in reports that cannot come, or leaves some
behind.
"""
import unittest
from unittest import mock

from rtshell_lite import errors
from rtshell_lite.live import hear, observer, times
from rtshell_lite.net import loop

C = observer.OBSERVER


class Node:
    def __init__(self, endpoint):
        self.endpoint = endpoint


class Entry:
    subscription = None
    takes_none = is_in_doubt = False

    def __init__(self, path, endpoint=("h", 1), offered=C):
        self.path = path
        self.node = Node(endpoint)
        self.offered = offered
        self.events = []

    def hear(self, event):
        self.events.append(event)


class Subscription:
    """Notes in its entry's process what it was asked for."""

    log = []  # type: list
    refuses = False

    reference = "a reference"
    where = "x"

    def __init__(self, node, interface, properties, heard):
        self.endpoint = node.endpoint
        self.interface = interface
        self.properties = properties
        self.heard = heard

    async def attach(self):
        self.log.append("beating" if "heartbeat.enable" in dict(self.properties) else "quiet")
        if self.refuses:
            raise errors.Refused("x", "no")

    async def detach(self):
        self.log.append("detached")

    def forget(self):
        pass


class Hearing(unittest.TestCase):
    def setUp(self):
        Subscription.log = []
        Subscription.refuses = False
        self.now = 1000.0
        self.hearing = hear.Hearing()

        async def profile(node):
            self.log.append("profile")
            return mock.Mock(properties=[("sdo.service.consumer.available_services", node.offered)])

        for where, name, value in (
            (hear.component, "profile", profile),
            (hear.observer, "Subscription", Subscription),
            (hear.loop, "now", lambda: self.now),
        ):
            patched = mock.patch.object(where, name, value)
            patched.start()
            self.addCleanup(patched.stop)

    @property
    def log(self):
        return Subscription.log

    def lend(self, *entries):
        async def run():
            for entry in entries:
                entry.node.offered = entry.offered
                await self.hearing.lend(entry)

        loop.run(run())

    def test_one_of_a_process_beats(self):
        one, two, other = Entry("a"), Entry("b"), Entry("c", ("h", 2))
        self.lend(one, two, other, one)
        self.assertEqual(self.log, ["profile", "beating", "profile", "quiet", "profile", "beating"])

    def test_reports_are_trusted_while_the_process_calls(self):
        one, two = Entry("a"), Entry("b")
        self.lend(one, two)
        self.assertFalse(self.hearing.reports(two), "nobody knows yet whether it can call")
        one.subscription.heard("event")
        self.assertEqual(one.events, ["event"])
        self.assertTrue(self.hearing.reports(one) and self.hearing.reports(two))
        self.now += times.LATE + 1
        self.assertFalse(self.hearing.reports(two))
        self.lend(two, one)
        self.assertEqual(self.log[4:], ["beating"], "another one is to beat, as the first may be gone")

    def test_who_cannot_call_loses_them(self):
        one, two = Entry("a"), Entry("b")
        self.lend(one, two)
        self.now += times.LATE + 1
        self.lend(two, one)
        self.assertEqual(self.log[4:], ["detached", "detached"])
        self.assertIsNone(one.subscription)
        self.assertIsNone(two.subscription)

    def test_one_that_did_not_report_gets_it_again(self):
        one, two = Entry("a"), Entry("b")
        self.lend(one, two)
        one.subscription.heard("event")
        two.is_in_doubt = True
        self.lend(one, two)
        self.assertEqual(self.log[4:], ["quiet"])

    def test_who_takes_none_is_asked_once(self):
        one = Entry("a", offered="")
        self.lend(one, one)
        self.assertEqual(self.log, ["profile"])
        Subscription.refuses = True
        two = Entry("b")
        self.lend(two, two)
        self.assertEqual(self.log[1:], ["profile", "beating"])
        self.assertFalse(self.hearing.reports(two))

    def test_the_end_of_the_one_that_beats(self):
        one, two = Entry("a"), Entry("b")
        self.lend(one, two)
        one.subscription.heard("event")
        self.hearing.forget(one)
        self.assertFalse(self.hearing.reports(two))
        self.lend(two)
        self.assertEqual(self.log[4:], ["beating"])

    def test_all_are_taken_back(self):
        entries = [Entry("a"), Entry("b"), Entry("c", ("h", 2))]
        self.lend(*entries)
        loop.run(self.hearing.take_all_back())
        self.assertEqual(self.log.count("detached"), 3)
        self.assertEqual([entry.subscription for entry in entries], [None] * 3)


if __name__ == "__main__":
    unittest.main()
