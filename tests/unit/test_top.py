"""What rttop shows, without a network: if this fails, it is silent about what it has not seen."""
import types
import unittest
from unittest import mock

from rtshell_lite import errors, path
from rtshell_lite.corba import orb
from rtshell_lite.live import observer, times
from rtshell_lite.net import loop
from rtshell_lite.top import model


class GiveUp(unittest.TestCase):
    def test_what_has_not_been_listed_in_time_is_reported(self):
        """A name server that is too slow is no empty one."""
        slow, empty = path.parse("/slow"), path.parse("/empty")
        looking = model.Top([slow, empty], 1.0)
        looking._found[empty] = {}  # as the task that walks there does
        looking._failed[empty] = {}
        looking.give_up()
        (row,) = looking.rows()
        self.assertEqual((row.path, row.kind), ("/slow", "unknown"))
        self.assertIsInstance(row.failure, errors.Silent)


class Rest(unittest.TestCase):
    """What a large system costs while nothing happens."""

    def setUp(self):
        patch = mock.patch.object(orb, "identity", lambda ref: ref)
        patch.start()
        self.addCleanup(patch.stop)
        node = types.SimpleNamespace(path=path.parse("/a:1/x.rtc"), ref="x", name="x.rtc", endpoint=("a", 2))
        self.looking = model.Top([], 0.5)
        self.entry = model.Entry(
            node, self.looking._leaders, self.looking._hurried, self.looking._changed
        )
        self.looking._found, self.looking._failed = {"top": {"/a:1/x.rtc": "x"}}, {"top": {}}
        self.looking._entries = {"x": self.entry}

    def test_a_row_is_made_again_only_if_it_may_be_another_one(self):
        (row,) = self.looking.rows()
        self.assertIs(self.looking.rows()[0], row)
        self.entry.fail("silent", errors.Silent("x", "no answer"))
        self.assertEqual(self.looking.rows()[0].state, "?")
        self.entry.keep_measured({"out": 5.0})
        self.assertEqual(self.looking.rows()[0].flow, {"out": 5.0})

    def test_components_are_looked_through_when_one_is_due_or_has_reported(self):
        looked = []
        pauses = []
        sleep = loop.sleep

        async def pause(seconds):
            pauses.append(seconds)
            await sleep(0)

        async def look(due, entries):
            looked.extend(due)
            for entry in due:
                entry.asked = loop.now()
            return True

        async def main():
            self.looking._look = look
            self.looking._entries = dict.fromkeys(range(model.FEW + 1), self.entry)
            self.looking.shown = set()
            self.looking._groups = {self.entry.group: [self.entry]}
            async with loop.background(self.looking._look_after(self.entry.group)):
                while len(pauses) < 20:
                    await sleep(0)
                before = len(looked)
                self.entry.hear(observer.Event(0.0, "RTC_STATUS", "0", "ERROR"))
                while len(pauses) < 40:
                    await sleep(0)
            return before, len(looked)
        with mock.patch.object(loop, "sleep", pause):
            self.assertEqual(loop.run(main()), (1, 2))

    def test_who_cannot_call_us_loses_its_observer(self):
        sleep = loop.sleep
        now = loop.now()

        async def pause(seconds):
            nonlocal now
            now += seconds
            await sleep(0)

        async def answer():
            """It does as it is told."""

        async def wait(seconds):
            begun = now
            while now < begun + seconds:
                await sleep(0)

        async def main(is_heard, is_stopped):
            self.looking._tasks = loop.Group()
            self.entry.subscription = mock.Mock(attach=answer, detach=answer, is_led=False)
            self.entry.takes_none = False
            self.looking._leaders.take(self.entry)
            self.entry.heard = float(is_heard)
            async with self.looking._tasks, loop.background(self.looking._keep_observers()):
                if is_stopped:  # and goes on before a heartbeat is due
                    self.entry.fail("silent", errors.Silent("x", "no answer"))
                    await wait(2 * times.LATE)
                    self.entry._become("component", "INACTIVE", None)
                    await wait(times.BEAT)
                else:
                    await wait(2 * times.LATE)
                self.looking._tasks.cancel()
            return self.entry.takes_none, self.entry.subscription is None
        with mock.patch.object(loop, "sleep", pause), mock.patch.object(loop, "now", lambda: now):
            for is_heard, is_stopped in ((True, False), (False, False), (False, True)):
                is_lost = not is_heard and not is_stopped
                self.assertEqual(loop.run(main(is_heard, is_stopped)), (is_lost, is_lost))
            dead = mock.Mock(node=self.entry.node, heard=0.0, is_hung=True, kind="zombie", subscription=None)
            self.looking._entries["z"] = dead
            self.assertEqual(loop.run(main(False, False)), (True, True))

    def test_what_no_name_leads_to_any_more_keeps_no_observer(self):
        """Also where it is just being lent one."""
        taken_back = []

        async def take_back(entries):
            taken_back.extend(entries)

        async def main():
            self.looking._tasks = loop.Group()
            async with self.looking._tasks:
                self.entry.asked = loop.now()
                self.looking._take("top", {})
                await self.entry._be_heard()
                await loop.sleep(0)
                self.entry.subscription = "that was on its way"
            await self.looking._take_back_unbound()
        with mock.patch.object(model.hear, "take_all_back", take_back):
            loop.run(main())
        self.assertEqual(taken_back, [self.entry, self.entry])
        self.assertEqual(self.looking._entries, {})


if __name__ == "__main__":
    unittest.main()
