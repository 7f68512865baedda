"""Many calls at once by omniORB's threads: hung peers cost one timeout together, live ones do not wait for
them.
"""
import threading
import time
import types
import unittest
from unittest import mock

import tools
from rtshell_lite import errors
from rtshell_lite.corba import omniorb, orb, session
from rtshell_lite.net import loop

TIMEOUT = 0.4


class Calls(unittest.TestCase):
    """Calls of references that are pairs of an endpoint and a function, which a thread calls in place of
    omniORB.
    """

    def setUp(self):
        self.session = session.Session(TIMEOUT)
        self.release = threading.Event()
        self.addCleanup(self.release.set)
        for name, fake in (
            ("_made", lambda item: item.call.ref[1]()),
            ("address", lambda ref: ("", ref[0], 1, b"")),
        ):
            patched = mock.patch.object(omniorb, name, fake)
            patched.start()
            self.addCleanup(patched.stop)
        orbs = mock.patch.object(
            orb, "_orb", types.SimpleNamespace(invoke=omniorb.invoke, address=omniorb.address)
        )
        orbs.start()
        self.addCleanup(orbs.stop)

    def gather(self, *refs):
        """What calls of all these come to, each in the task of its process."""
        async def ask(ref):
            return await orb.call(ref[0], ref, "get")
        return self.each(refs, ask)

    def each(self, refs, function):
        async def main():
            return await session.each(refs, function, orb.at_object)
        return loop.run(main(), session=self.session)

    def ask(self, ref):
        return loop.run(orb.call(ref[0], ref, "get"), session=self.session)

    def silent(self):
        """A function of a process that does not answer until the test ends."""
        self.release.wait(30)
        raise errors.Silent("x", "no answer")

    def test_values_come_in_order(self):
        self.assertEqual(self.gather(*[(f"p{i % 3}", lambda i=i: i) for i in range(100)]), list(range(100)))

    def test_no_calls(self):
        self.assertEqual(self.gather(), [])

    def test_live_peers_answer_beside_hung_and_dead_ones(self):
        def refuse():
            raise errors.ConnectionRefused("x")
        refs = (
            [("hung", self.silent)] * 200
            + [("dead", refuse)] * 50
            + [(f"live{i}", lambda i=i: i) for i in range(30)]
        )
        watch = tools.Stopwatch()
        start = time.monotonic()
        values = self.gather(*refs)
        spent = time.monotonic() - start
        kinds = [type(value) for value in values[:200]]
        self.assertEqual(kinds.count(errors.NotAsked), 200 - kinds.count(errors.Silent))
        self.assertTrue(0 < kinds.count(errors.Silent) <= omniorb.IN_FLIGHT)
        self.assertEqual({type(value) for value in values[200:250]}, {errors.ConnectionRefused})
        self.assertEqual(values[250:], list(range(30)))
        self.assertGreaterEqual(spent, TIMEOUT)
        # one timeout; it would be 20 s with one for each thread of hung calls
        self.assertLess(watch.seconds(), 5)

    def test_the_first_silence_fails_the_rest_of_its_process(self):
        asked = []

        def fall_silent():
            asked.append(1)
            raise errors.Silent("x", "no answer")
        values = self.gather(*[("p", fall_silent)] * 50)
        kinds = [type(value) for value in values]
        self.assertEqual(kinds.count(errors.Silent), len(asked))
        self.assertEqual(kinds.count(errors.NotAsked), 50 - len(asked))
        self.assertLessEqual(len(asked), omniorb.IN_FLIGHT)

    def test_at_most_four_calls_are_in_flight_to_one_process(self):
        under_way = []
        most = []

        def call():
            under_way.append(1)
            most.append(len(under_way))
            self.release.wait(0.002)
            under_way.pop()
        self.gather(*[("p", call)] * 60)
        self.assertLessEqual(max(most), 4)

    def test_a_silent_process_is_not_asked_again_at_once(self):
        self.gather(("p", self.silent))
        start = time.monotonic()
        self.session.timeout = 60  # a busy machine may hold up this process for longer than TIMEOUT
        self.assertIsInstance(self.gather(("p", lambda: 1))[0], errors.NotAsked)
        self.session.timeout = TIMEOUT
        while time.monotonic() - start < TIMEOUT + 0.05:
            self.release.wait(0.05)
        self.assertEqual(self.gather(("p", lambda: 1)), [1])  # but later, when it may be back

    def test_silence_elsewhere_is_not_held_against_this_process(self):
        async def outer(ref):
            return await orb.call("other", ("other", self.silent), "get")
        values = self.each([("p", None)], outer)
        self.assertIs(type(values[0]), errors.Unreachable)
        self.assertEqual(self.ask(("p", lambda: 1)), 1)

    def test_a_process_that_answers_others_is_not_silent(self):
        def answer():
            self.release.wait(TIMEOUT / 2)
            return 1
        self.session.timeout = 3  # in which these answer on a busy machine, too
        values = self.gather(("p", self.silent), *[("p", answer)] * 3)
        self.assertEqual(values[1:], [1, 1, 1])
        self.assertIsInstance(values[0], errors.Silent)
        self.assertEqual(self.session.silent, {})

    def test_a_bug_is_not_taken_for_a_failure_of_the_peer(self):
        with self.assertRaises(KeyError):
            self.gather(("p", lambda: {}["x"]))

    def test_nobody_is_asked_when_all_time_is_up(self):
        """If this fails, commands with a limit in time exceed it when peers are slow but answer."""
        self.session.end = time.monotonic() + 0.2
        watch = tools.Stopwatch()
        values = self.gather(*[("slow", lambda: self.release.wait(0.1))] * 200)
        self.assertLess(watch.seconds(), 3)  # without the limit it would be 5 s
        self.assertEqual(values[-1].why, session.NO_TIME)

    def test_calls_that_nobody_waits_for_are_not_begun(self):
        begun = []

        async def main():
            async with loop.Group() as group:
                for number in range(20):
                    group.start(
                        orb.call("p", ("p", lambda: begun.append(1) or self.release.wait(0.2)), "get")
                    )
                await loop.sleep(0.05)
                group.cancel()
        loop.run(main(), session=self.session)
        self.release.wait(0.5)
        self.assertLessEqual(len(begun), omniorb.IN_FLIGHT)


class LookUps(unittest.TestCase):
    def test_one_that_was_cut_short_is_not_called_slow(self):
        """A command may be given more time, as rtdoctor is for a profile, and look it up again."""
        release = threading.Event()
        self.addCleanup(release.set)

        async def main():
            here = session.current()
            here.end = loop.now()
            with self.assertRaises(errors.NoTime):
                await session.on_thread("arm.local", lambda: release.wait(60))
            await loop.sleep(0.01)
            with self.assertRaises(errors.NoTime):
                await session.on_thread("arm.local", lambda: 1)
            here.end = loop.now() + 60
            return await session.on_thread("arm.local", lambda: 1)
        self.assertEqual(loop.run(main(), session=session.Session(TIMEOUT)), 1)


class Servants(unittest.TestCase):
    def test_they_are_called_on_the_loop(self):
        """And a fault of theirs costs the one call."""
        def method(value):
            called.append(threading.current_thread())
            return 10 // value
        called = []

        async def main():
            here = loop.current()
            here.make_bell()
            function = omniorb._on_loop(here, method)
            return await loop.on_thread(function, 5)
        self.assertEqual(loop.run(main()), 2)
        self.assertEqual(called, [threading.main_thread()])


class Handover(unittest.TestCase):
    """Values on their way from threads to the loop."""

    def setUp(self):
        self.taken = []
        self.takers = set()

    def take(self, received, data):
        self.taken.append((received, data))
        self.takers.add(threading.current_thread())

    def send(self, *senders):
        """Let each function send values on a thread, take(number, data); return when all is taken."""
        async def main():
            here = loop.current()
            here.make_bell()
            handover = omniorb._Handover(here, self.take)
            await loop.each(senders, lambda sender: loop.on_thread(sender, handover.take))
            handover.pass_on()
        loop.run(main())

    def test_nothing_is_lost_and_all_is_in_order(self):
        def sender(name):
            def send(take):
                for number in range(1000):
                    take(number, name * (1 + number % 7))  # some wait for the loop, as they are large
            return send
        with mock.patch.object(omniorb, "LARGEST_WAITING", 6), mock.patch.object(omniorb, "MOST_WAITING", 20):
            self.send(*map(sender, (b"a", b"b", b"c")))
        self.assertEqual(self.takers, {threading.main_thread()})
        self.assertEqual(len(self.taken), 3000)
        for name in b"abc":
            numbers = [number for number, data in self.taken if data[0] == name]
            self.assertEqual(numbers, list(range(1000)))

    def test_the_loop_takes_many_at_a_time(self):
        """And takes them without more than the one call."""
        posted = []

        async def main():
            handover = omniorb._Handover(loop.current(), self.take)
            with mock.patch.object(loop.current(), "post", posted.append):
                for number in range(50):
                    handover.take(number, b"x")
            self.assertEqual((len(posted), self.taken), (1, []))
            posted[0]()
            self.assertEqual(len(self.taken), 50)
            handover.take(50, b"x")
            while len(self.taken) < 51:
                await loop.sleep(omniorb.GATHER)
        loop.run(main())
        self.assertEqual(len(posted), 1)

    def test_few_wait(self):
        """A sender that is faster than the loop waits for it; large values always do."""
        sent = []

        def send(take):
            for data in (b"x", b"x", b"x", b"x" * 100):
                take(0, data)
                sent.append(data)

        async def main():
            here = loop.current()
            here.make_bell()
            handover = omniorb._Handover(here, self.take)
            thread = threading.Thread(target=send, args=(handover.take,))
            thread.start()
            while len(here._posted) < 2:  # and the loop does not come
                time.sleep(0.001)
            self.assertEqual((len(sent), self.taken), (2, []))
            await loop.on_thread(thread.join)
        with mock.patch.object(omniorb, "MOST_WAITING", 2), mock.patch.object(omniorb, "LARGEST_WAITING", 50):
            loop.run(main())
        self.assertEqual([len(data) for _, data in self.taken], [1, 1, 1, 100])

    def test_a_reader_that_leaves_is_given_each_value_before_its_sender_is_answered(self):
        """A connector is removed while a value is answered: elsewhere that can end a component."""
        seen = []

        def send(take):
            take(2, b"y")
            seen.append([number for number, _ in self.taken])

        async def main():
            here = loop.current()
            here.make_bell()
            handover = omniorb._Handover(here, self.take)
            with mock.patch.object(here, "post"):  # the loop does not come
                handover.take(1, b"x")
            self.assertEqual(self.taken, [])
            handover.hurry()
            self.assertEqual(self.taken, [(1, b"x")])
            await loop.on_thread(send, handover.take)
        loop.run(main())
        self.assertEqual(seen, [[1, 2]])

    @unittest.skipUnless(omniorb.is_installed(), "needs omniORBpy")
    def test_a_loop_that_has_ended_takes_nothing(self):
        """Nobody gets PORT_OK for a value that is lost."""
        from omniORB import CORBA

        async def main():
            return omniorb._Handover(loop.current(), self.take)
        handover = loop.run(main())
        with self.assertRaises(CORBA.OBJECT_NOT_EXIST):
            handover.take(0, b"x")


if __name__ == "__main__":
    unittest.main()
