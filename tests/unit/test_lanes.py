"""Many calls at once: hung peers cost one timeout together, live ones do not wait for them, and the order is kept."""
import threading
import time
import unittest
from unittest import mock

from rtshell_lite import errors
from rtshell_lite.corba import lanes, pool


class Crowd:
    """Counts the threads that are within its `with`: `now`, and at `most`."""

    def __init__(self):
        self.now = self.most = 0
        self._lock = threading.Lock()

    def __enter__(self):
        with self._lock:
            self.now += 1
            self.most = max(self.most, self.now)

    def __exit__(self, *_):
        with self._lock:
            self.now -= 1


class Gather(unittest.TestCase):
    def setUp(self):
        self.before, lanes.session.timeout = lanes.session.timeout, 0.4
        self.release = threading.Event()
        lanes.session.silent.clear()
        lanes._answered.clear()

    def tearDown(self):
        self.release.set()
        lanes.session.timeout = self.before

    def job(self, endpoint, call):
        return lanes.Job(endpoint, str(endpoint), call)

    def test_values_come_in_the_order_of_the_jobs(self):
        jobs = [self.job(i % 3, lambda i=i: i) for i in range(100)]
        self.assertEqual(lanes.gather(jobs), list(range(100)))

    def test_what_is_apart_never_runs_on_this_thread(self):
        """Where the ORB needs no threads, too: otherwise Ctrl-C leaves a connector behind that is just being made."""
        with mock.patch.object(lanes, "loop", list):
            here, = lanes.each(["p"], lambda item: threading.get_ident(), lambda item: (item, item))
            apart, = lanes.each(["p"], lambda item: threading.get_ident(), lambda item: (item, item), apart=True)
        self.assertEqual(here, threading.get_ident())
        self.assertNotEqual(apart, threading.get_ident())

    def test_no_jobs(self):
        self.assertEqual(lanes.gather([]), [])

    def test_in_turn_values_come_before_the_last_one_is_there(self):
        def late():
            self.release.wait()
            return "late"
        values = lanes.in_turn([self.job("a", lambda: "early"), self.job("b", late), self.job("a", lambda: "behind")])
        self.assertEqual(next(values), "early")
        self.assertFalse(self.release.is_set())
        self.release.set()
        self.assertEqual(list(values), ["late", "behind"])

    def test_in_turn_nothing_more_is_begun_for_who_takes_no_more(self):
        asked = []

        def slow():
            asked.append(1)
            self.release.wait(0.05)
        values = lanes.in_turn([self.job("p", lambda: "first")] + [self.job("p", slow) for _ in range(200)])
        self.assertEqual(next(values), "first")
        values.close()
        begun = len(asked)
        self.release.wait(0.2)
        self.assertLessEqual(len(asked), begun + lanes.LANES)

    def test_live_peers_answer_beside_hung_and_dead_ones(self):
        def dead():
            raise errors.ConnectionRefused("x")
        jobs = [self.job("hung", self.release.wait) for _ in range(200)]
        jobs += [self.job("dead", dead) for _ in range(50)]
        jobs += [self.job(("live", i), lambda i=i: i) for i in range(30)]
        start = time.monotonic()
        values = lanes.gather(jobs)
        spent = time.monotonic() - start
        self.assertTrue(all(isinstance(v, errors.Silent) for v in values[:200]))
        self.assertTrue(all(isinstance(v, errors.ConnectionRefused) for v in values[200:250]))
        self.assertEqual(values[250:], list(range(30)))
        self.assertGreaterEqual(spent, 0.4)
        self.assertLess(spent, 5)  # one timeout; it would be 20 s with one for each lane of hung calls

    def test_the_first_silence_fails_the_rest_of_its_process(self):
        asked = []

        def silent():
            asked.append(1)
            raise errors.Silent("x", "no answer")
        values = lanes.gather([self.job("p", silent) for _ in range(50)])
        self.assertTrue(all(isinstance(v, errors.Silent) for v in values))
        self.assertLessEqual(len(asked), lanes.LANES)

    def test_at_most_four_calls_are_in_flight_to_one_process(self):
        crowd = Crowd()

        def call():
            with crowd:
                self.release.wait(0.002)
        lanes.gather([self.job("p", call) for _ in range(60)])
        self.assertLessEqual(crowd.most, 4)

    def test_answers_restart_the_clock(self):
        def slow():
            for _ in range(4):
                self.release.wait(0.2)
                lanes.alive()
            return "done"
        self.assertEqual(lanes.gather([self.job("p", slow)]), ["done"])  # 0.8 s in all, with a timeout of 0.4

    def test_who_waits_for_another_process_is_not_silent(self):
        end = time.monotonic() + 2 * lanes.session.timeout

        def slow():
            while time.monotonic() < end:
                self.release.wait(0.02)
                lanes.answered()
            return "done"
        self.assertEqual(lanes.gather([self.job("p", lambda: lanes.ask("other", "other", slow))]), ["done"])

    def test_silence_elsewhere_is_not_held_against_this_process(self):
        def outer():
            return lanes.ask("other", "other", lambda: self.release.wait())
        values = lanes.gather([self.job("p", outer), self.job("p", lambda: 1), self.job("p", outer), self.job("p", lambda: 2)])
        self.assertEqual([values[1], values[3]], [1, 2])
        self.assertTrue(all(type(values[i]) is errors.Unreachable for i in (0, 2)))

    def test_a_silent_process_is_not_asked_again_at_once(self):
        lanes.gather([self.job("p", self.release.wait)])
        start = time.monotonic()
        value, = lanes.gather([self.job("p", lambda: 1)])
        self.assertIsInstance(value, errors.Silent)
        while time.monotonic() - start < 0.45:
            self.release.wait(0.05)
        self.assertEqual(lanes.gather([self.job("p", lambda: 1)]), [1])  # but later, when it may be back

    def test_a_process_that_answers_others_is_not_silent(self):
        def hung():
            self.release.wait(lanes.session.timeout)
            raise errors.Silent("p", "no answer")

        def answering():
            self.release.wait(0.1)
            lanes.answered()
            return 1
        values = lanes.gather([self.job("p", hung)] + [self.job("p", answering) for _ in range(2)])
        self.assertEqual(values[1:], [1, 1])
        self.assertIsInstance(values[0], errors.Silent)
        self.assertEqual(lanes.gather([self.job("p", lambda: 1)]), [1])  # at once

    def test_who_has_answered_all_is_not_silent_because_another_hangs(self):
        lanes.gather([self.job("fast", lambda: 1), self.job("hung", self.release.wait)])
        self.assertEqual(lanes.ask("fast", "fast", lambda: 2), 2)

    def test_to_wait_for_a_slot_is_no_silence(self):
        slots = lanes.Slots(1)

        def call():
            with slots:
                return "done"
        slots.__enter__()
        threading.Timer(lanes.session.timeout + 3 * lanes.GRACE, slots.__exit__).start()
        self.assertEqual(lanes.gather([self.job("p", call), self.job("q", call)]), ["done", "done"])

    def test_at_most_so_many_calls_are_in_slots(self):
        slots, crowd = lanes.Slots(2), Crowd()

        def call():
            with slots, crowd:
                self.release.wait(0.002)
        lanes.gather([self.job(number % 5, call) for number in range(60)])
        self.assertEqual((crowd.most, crowd.now), (2, 0))

    def test_many_that_ask_one_silent_process_wait_once(self):
        asked = []

        def silent():
            asked.append(1)
            self.release.wait()
        lanes.gather([self.job("p", lambda: lanes.ask("other", "other", silent)) for _ in range(12)])
        self.assertLessEqual(len(asked), lanes.LANES)

    def test_a_bug_is_not_taken_for_a_failure_of_the_peer(self):
        with self.assertRaises(KeyError):
            lanes.gather([self.job("p", lambda: {}["x"])])

    def test_nobody_is_asked_when_all_time_is_up(self):
        """If this fails, commands with a limit in time exceed it when peers are slow but answer."""
        def slow():
            for _ in range(20):
                time.sleep(0.05)
                lanes.answered()
        start = time.monotonic()
        lanes.session.end = start + 0.3
        self.addCleanup(setattr, lanes.session, "end", None)
        values = lanes.gather([self.job("slow", slow) for _ in range(20)] + [self.job("quick", lambda: "done")])
        self.assertLess(time.monotonic() - start, 3)  # without the limit it would be 5 s
        self.assertEqual([str(value) for value in values], ["slow: " + lanes.NO_TIME] * 20 + ["done"])

    def test_ask_raises(self):
        def refused():
            raise errors.Refused("x", "no")
        self.assertEqual(lanes.ask("p", "p", lambda: 3), 3)
        with self.assertRaises(errors.Refused):
            lanes.ask("p", "p", refused)


class Calls(unittest.TestCase):
    def ended(self, function):
        calls = pool.Calls()
        calls.start("p", "key", function)
        return calls.ended(5)

    def test_what_they_return_or_raise(self):
        refused = errors.Refused("x", "no")

        def refuse():
            raise refused
        self.assertEqual(self.ended(lambda: 1), ("key", 1))
        self.assertEqual(self.ended(refuse), ("key", refused))
        with self.assertRaises(KeyError):
            self.ended(lambda: {}["x"])
        self.assertIsNone(pool.Calls().ended(0))


if __name__ == "__main__":
    unittest.main()
