"""What components report to observers, and what we make of it: if this fails, rtwatch shows words of the
wire, or the wrong ones.
"""
import time
import unittest
from unittest import mock

from rtshell_lite import errors, path
from rtshell_lite.corba.session import Session
from rtshell_lite.live import follow, observer, watch
from rtshell_lite.live.observer import Record, event
from rtshell_lite.net import loop


class Hints(unittest.TestCase):
    """As C++ and Python 2.x send them (protocol of observers)."""

    def check(self, status, hint, *expected):
        self.assertEqual(tuple(event(1.0, status, hint)), (1.0,) + expected)

    def test_status(self):
        self.check("RTC_STATUS", "ACTIVE:0", "RTC_STATUS", "0", "ACTIVE")
        self.check("RTC_STATUS", "FINALIZE:1000", "RTC_STATUS", "1000", "FINALIZE")
        self.check("EC_STATUS", "RATE_CHANGED:0", "EC_EVENT", "0", "EC_RATE_CHANGED")

    def test_ports(self):
        """A port's name may hold colons."""
        self.check("PORT_PROFILE", "CONNECT:a:b.out", "PORT_EVENT", "a:b.out", "PORT_CONNECT")
        self.check("PORT_PROFILE", "SEND:OutPort:ConsoleIn0.out", "PORT_EVENT", "ConsoleIn0.out", "PORT_SEND")
        self.check("PORT_PROFILE", "RECEIVE:InPort:A.in", "PORT_EVENT", "A.in", "PORT_RECEIVE")

    def test_configuration(self):
        """With a blank, and words of its own."""
        for word, ours in (
            ("UPDATE_CONFIG_SET", "UPDATE_SET"),
            ("UPDATE_CONFIG_PARAM", "UPDATE_PARAM"),
            ("SET_CONFIG_SET", "SET_SET"),
            ("ADD_CONFIG_SET", "ADD_SET"),
            ("REMOVE_CONFIG_SET", "REMOVE_SET"),
            ("ACTIVATE_CONFIG_SET", "ACTIVATE_SET"),
        ):
            self.check("CONFIGURATION", word + ": default", "CONFIG_EVENT", "default", "CFG_" + ours)
        self.check("CONFIGURATION", "NEWS: x", "CONFIG_EVENT", "x", "NEWS")

    def test_others(self):
        self.check("COMPONENT_PROFILE", "a,b", "COMPONENT_PROFILE", "", "a,b")
        self.check("HEARTBEAT", "", "HEARTBEAT", "", "HEARTBEAT")
        self.check("EC_HEARTBEAT", "HEARTBEAT:0", "HEARTBEAT", "", "EC_HEARTBEAT")
        self.check("FSM_STATUS", "closed PRE_ON_EXIT", "FSM_EVENT", "FSM_STATUS", "closed PRE_ON_EXIT")
        self.check("RTC_STATUS", "", "RTC_STATUS", "", "")
        self.check("STATUS_KIND_NUM", "?", "STATUS_KIND_NUM", "", "?")


class Names(unittest.TestCase):
    def names(self, *paths):
        """What lines of these components begin with; None for one that is not there."""
        async def on_components(wanted, begin):
            return [
                (
                    await begin(mock.Mock(path=each, endpoint=("h", 1)))
                    if each.names
                    else errors.NotFound(str(each))
                )
                for each in wanted
            ]

        async def begin(watched):
            watched.is_begun = True

        async def start():
            async with watch.Watch(watch.Events(watch.KINDS)) as watching:
                return await watching.add([path.parse(each) for each in paths])
        with mock.patch.object(watch.tree, "on_components", on_components), mock.patch.object(
            watch.Watched, "begin", begin
        ):
            return [getattr(result, "name", None) for result in loop.run(start())]

    def test_those_that_share_one_are_called_by_their_paths(self):
        self.assertEqual(self.names("/h/a.cxt/Arm0.rtc", "/h", "/h/b.cxt/Arm0.rtc", "/h/b.cxt/Hand0.rtc"),
                         ["/h/a.cxt/Arm0.rtc", None, "/h/b.cxt/Arm0.rtc", "Hand0.rtc"])


class Waiting(unittest.TestCase):
    def test_lines_that_wait_to_be_printed_have_few_megabytes(self):
        """Who reads may have stopped, and records may be long."""
        said = []

        async def fill():
            watching = watch.Watch(watch.Records("NORMAL", []), said.append)
            watching.followed = [mock.Mock()]
            for _ in range(3):
                watching.put(watching.followed[0], Record(1.0, "arm", "INFO", "x" * 1000))
            self.assertEqual([len(batch) async for batch in watching.follow(2, 5)], [2])
            watching.put(watching.followed[0], Record(2.0, "arm", "INFO", "x" * 2000))
            return [record.time async for batch in watching.follow(1, 5) for _, record in batch]
        with mock.patch.object(watch, "MOST_CHARACTERS", 3000):
            self.assertEqual(loop.run(fill()), [2.0])
        self.assertIn("1 lines dropped", said[0])

    def test_no_more_are_taken_than_wanted_and_none_after_the_end(self):
        async def follow():
            watching = watch.Watch(watch.Records("NORMAL", []), self.fail)
            watching.followed = [mock.Mock(where="/h")]
            for number in range(3):
                watching.put(watching.followed[0], Record(number, "arm", "INFO", ""))
            numbers = [record.time async for batch in watching.follow(1, 5) for _, record in batch]
            with self.assertRaisesRegex(errors.Failed, "2 of 9 within 0.1s"):
                async for batch in watching.follow(9, 0.1):
                    numbers += [record.time for _, record in batch]
            return numbers
        self.assertEqual(loop.run(follow()), [0, 1, 2])


class Ending(unittest.TestCase):
    def end(self, detach, endpoints, silent=()):
        """End a watch of components in these processes, of which some are known to be silent, as Ctrl-C does;
        returns what is noted.
        """
        notes = []
        session = Session(60)
        session.silent.update((endpoint, (time.monotonic(), "no answer within 60s")) for endpoint in silent)

        async def watched():
            async with watch.Watch(watch.Events(watch.KINDS), notes.append) as watching:
                for endpoint in endpoints:
                    node = mock.Mock(endpoint=endpoint)
                    watching.left.append(
                        mock.Mock(endpoint=endpoint, where="/h", detach=lambda node=node: detach(node))
                    )
                raise KeyboardInterrupt
        with self.assertRaises(KeyboardInterrupt):
            loop.run(watched(), session=session)
        return notes

    def test_each_component_is_asked_to_forget_us_however_little_time_there_is(self):
        asked = []

        async def detach(node):
            asked.append(node.endpoint)
            await loop.sleep(0.01)
        with mock.patch.object(watch.times, "HURRY_SHOWN", 0):
            self.end(detach, range(100))
        self.assertEqual(sorted(asked), list(range(100)))

    def test_one_that_is_slow_is_not_waited_for(self):
        """Nor are those of a process that is silent, which are not asked."""
        asked = []

        async def detach(node):
            asked.append(node.endpoint)
            await loop.sleep(40)
        begun = time.monotonic()
        self.end(detach, ["slow", "silent"] + 20 * ["slow"], ["silent"])
        self.assertLess(time.monotonic() - begun, 30)
        self.assertEqual(set(asked), {"slow"})


class Meanwhile(unittest.TestCase):
    """What happens to a component while something is being done about it."""

    def run_with(self, number, play):
        """Run play(watching, some Watched in one process) in a Watch that does not look around."""
        async def look_around(watching):
            """Nothing."""

        async def main():
            async with watch.Watch(watch.Events(watch.KINDS), self.notes.append) as watching:
                for each in range(number):
                    node = mock.Mock(path=path.parse("/h/Arm%d.rtc" % each), endpoint=("h", 1))
                    watching.followed.append(watch.Watched(watching, node))
                await play(watching, *watching.followed)
        self.notes = []
        with mock.patch.object(watch.Watch, "_look_around", look_around), mock.patch.object(
            follow.orb, "identity", id
        ):
            loop.run(main(), session=Session(60))

    def test_a_task_that_begins_when_it_has_ended_does_nothing(self):
        async def play(watching, arm):
            arm.shown = None
            watching.start(watching._put(arm, "RTC_STATUS", self.fail))
            watching.start(arm._have_heard())
            await loop.sleep(0)
            self.assertIsNone(arm.seen)
        self.run_with(1, play)

    def test_one_that_is_slow_to_take_an_observer_is_not_late_with_heartbeats(self):
        async def play(watching, arm):
            arm.subscription = mock.Mock(interface=observer.OBSERVER, reference=None, is_led=False)
            arm.lives()
            self.assertEqual(watching.taken(), [])
            arm.is_begun = True
            arm.lives()
            self.assertEqual([event.event for _, event in watching.taken()], ["NO_HEARTBEAT"])
            arm.subscription = None
        self.run_with(1, play)

    def test_one_task_at_a_time_lends_it_an_observer(self):
        async def play(watching, arm):
            attached = loop.Wait()

            async def attach():
                await attached

            async def lend(node, hear):
                return mock.Mock(attach=attach, reference=None)
            watching.what.subscription = lend
            arm.appeared()
            await loop.sleep(0)
            watching.failed(arm, errors.ProcessGone(arm.where))
            self.assertFalse(arm.is_there or arm.is_sought)
            attached.failed(errors.ConnectionLost(arm.where))
            await loop.sleep(0)
            self.assertTrue(arm.is_sought)
        self.run_with(1, play)

    def test_one_that_has_not_answered_gets_the_same_observer_again(self):
        """It may have it: of two it would report each event twice."""
        made = []

        async def attach():
            if len(made) < 2:
                raise errors.Silent("/h/Arm0.rtc", "no answer within 3s")

        async def lend(node, hear):
            made.append(mock.Mock(node=node, attach=attach, reference="IOR:", remark="", detach=detach))
            return made[-1]

        async def detach():
            """It takes it back."""

        async def play(watching, arm):
            watching.what.subscription = lend
            shown = arm.shown
            for _ in range(2):
                arm.shown = shown
                arm.appeared()
                await loop.sleep(0)
            self.assertIs(arm.subscription, made[0])
            self.assertEqual(watching.left, [])
        self.run_with(1, play)

    def test_all_that_are_late_are_asked_at_once_whether_they_live(self):
        asked = []

        async def alive(each):
            asked.append(each)
            await loop.sleep(3600)

        async def play(watching, *arms):
            for arm in arms:
                arm.subscription = mock.Mock(reference=None, is_led=False)
            watching.suspect(("h", 1))
            await loop.sleep(0)
            self.assertEqual(len(asked), len(arms))
        with mock.patch.object(follow, "_alive", alive):
            self.run_with(3, play)


if __name__ == "__main__":
    unittest.main()
