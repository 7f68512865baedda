"""The loop: tasks end with what began them, nothing is lost, and signals arrive at an `await`."""
import os
import select
import signal
import subprocess
import sys
import threading
import time
import unittest

from rtshell_lite import errors
from rtshell_lite.net import loop

ONCE = "what Python does with coroutines is the same in all versions, which the commands show"


async def after(seconds, value):
    await loop.sleep(seconds)
    return value


async def fail(seconds, error):
    await loop.sleep(seconds)
    raise error


class Case(unittest.TestCase):
    def setUp(self):
        self.heard = []

    async def mourn(self, seconds, name):
        """Sleep; note how that ended."""
        try:
            await loop.sleep(seconds)
            self.heard.append(name)
        except loop.Cancelled:
            self.heard.append("no " + name)
            raise


async def gather(items, function, key=None):
    return await loop.each(items, function, key)


class Tasks(Case):
    def test_results_come_in_order(self):
        begun = time.monotonic()
        found = loop.run(gather([0.3, 0.1, 0.2], lambda seconds: after(seconds, seconds)))
        self.assertEqual(found, [0.3, 0.1, 0.2])
        self.assertGreaterEqual(time.monotonic() - begun, 0.29)

    def test_failures_are_values(self):
        async def ask(number):
            if number == 1:
                raise errors.Silent("here", "no answer")
            return number
        found = loop.run(gather(range(3), ask))
        self.assertEqual((found[0], type(found[1]), found[2]), (0, errors.Silent, 2))
        self.assertIsNone(found[1].__traceback__)

    def test_a_bug_cancels_the_others(self):
        async def ask(name):
            await (fail(0.01, KeyError("x")) if name == "bug" else self.mourn(100, name))
        begun = time.monotonic()
        with self.assertRaises(KeyError):
            loop.run(gather(["a", "bug"], ask))
        self.assertEqual(self.heard, ["no a"])
        self.assertLess(time.monotonic() - begun, 50)

    def test_few_of_one_key_run_at_a_time(self):
        now = {"a": 0, "b": 0}
        most = {"a": 0, "b": 0}

        async def ask(key):
            now[key] += 1
            most[key] = max(most[key], now[key])
            await loop.sleep(0.001)
            now[key] -= 1
        loop.run(gather(["a"] * 200 + ["b"], ask, key=str))
        self.assertEqual(most, {"a": loop.MOST, "b": 1})

    def test_the_first_of_a_race(self):
        self.assertEqual(loop.run(loop.race(after(10, "late"), after(0.01, "first"))), "first")
        with self.assertRaises(KeyError):
            loop.run(loop.race(after(10, "late"), fail(0.01, KeyError("x"))))

    def test_the_losers_of_a_race_clean_up(self):
        loop.run(loop.race(self.mourn(10, "loser"), after(0.01, "first")))
        self.assertEqual(self.heard, ["no loser"])

    def test_a_finishing_task_is_not_cancelled(self):
        """Its caller is, afterwards; what the change has failed with is lost then."""
        async def change():
            await loop.sleep(0.05)
            self.heard.append("changed")
            return "result"

        async def main():
            self.assertEqual(await loop.finish(change()), "result")
            with self.assertRaises(KeyError):
                await loop.finish(fail(0, KeyError("x")))
            async with loop.background(loop.finish(change())) as task:
                await loop.sleep(0.01)
                task.cancel()
                await loop.sleep(0.01)
                task.cancel()
            self.assertIsInstance(task.error, loop.Cancelled)
        loop.run(main())
        self.assertEqual(self.heard, ["changed", "changed"])

    def test_background(self):
        async def main():
            async with loop.background(self.mourn(10, "background")):
                await loop.sleep(0.01)
            return "done"
        self.assertEqual(loop.run(main()), "done")
        self.assertEqual(self.heard, ["no background"])

    def test_a_background_that_fails_ends_the_block(self):
        async def main():
            async with loop.background(fail(0.01, KeyError("x"))):
                await self.mourn(10, "block")
        with self.assertRaises(KeyError):
            loop.run(main())
        self.assertEqual(self.heard, ["no block"])

    def test_a_task_may_await_while_it_cleans_up(self):
        async def tidy():
            try:
                await loop.sleep(10)
            finally:
                await loop.sleep(0.01)
                self.heard.append("tidied")

        async def main():
            async with loop.background(tidy()):
                await loop.sleep(0.01)
        loop.run(main())
        self.assertEqual(self.heard, ["tidied"])

    def test_a_stream_yields_before_the_last_has_come(self):
        async def first():
            async for value in loop.each([0, 100], lambda seconds: after(seconds, seconds)):
                return value
        begun = time.monotonic()
        self.assertEqual(loop.run(first()), 0)
        self.assertLess(time.monotonic() - begun, 50)

    def test_a_bug_ends_a_stream(self):
        async def main():
            async for _ in loop.each([0, 0.01], lambda seconds: fail(seconds, KeyError("x"))):
                pass
        with self.assertRaises(KeyError):
            loop.run(main())

    def test_loops_inside_each_other(self):
        """As what still blocks does inside of a task."""
        async def main():
            return loop.run(after(0.01, "inner")) + await after(0.01, " outer")
        self.assertEqual(loop.run(main()), "inner outer")
        self.assertIsNone(loop.current())


class Waiting(Case):
    def test_descriptors(self):
        ours, theirs = os.pipe()

        async def main():
            async with loop.background(self.write(theirs)):
                await loop.ready(ours, select.POLLIN)
                return os.read(ours, 10)
        self.assertEqual(loop.run(main()), b"x")
        os.close(ours)
        os.close(theirs)

    def test_a_task_that_outlives_its_loop_ends_without_a_failure(self):
        """As one does that has not cleaned up in time after a signal."""
        ours, theirs = os.pipe()
        left = []

        async def main():
            left.append(loop.Task(loop.current(), loop.ready(ours, loop.READ), None, None))
            await loop.sleep(0)
        loop.run(main())
        left[0].close()
        os.close(ours)
        os.close(theirs)

    async def write(self, fd):
        await loop.sleep(0.01)
        os.write(fd, b"x")

    def test_threads(self):
        self.assertEqual(loop.run(loop.on_thread(threading.get_ident)) == threading.get_ident(), False)
        with self.assertRaises(KeyError):
            loop.run(loop.on_thread({}.__getitem__, "x"))

    def test_a_thread_that_hangs_is_not_waited_for(self):
        release = threading.Event()
        self.addCleanup(release.set)
        self.assertEqual(loop.run(loop.race(loop.on_thread(release.wait), after(0.01, "first"))), "first")

    def test_many_threads_at_once(self):
        found = loop.run(gather(range(50), lambda number: loop.on_thread(int, str(number))))
        self.assertEqual(found, list(range(50)))

    def test_time_away_is_no_silence(self):
        """What comes late because we were busy is no silence of others."""
        away = []

        async def main():
            loop.current().on_return = away.append
            await loop.sleep(0)
            time.sleep(0.5)  # as a stop of the process does
            await loop.sleep(0.01)
        loop.run(main())
        self.assertGreaterEqual(max(away), 0.5)  # a busy machine may have stopped it, too

    def test_timers_that_are_cancelled_are_not_kept(self):
        """What waits for ever is woken again and again for days."""
        async def main():
            bell = loop.Bell()
            for _ in range(5000):
                loop.current().call_later(0, bell.ring)
                self.assertTrue(await bell.wait(float("inf")))
            return len(loop.current()._timers)
        self.assertLess(loop.run(main()), 2 * loop.FEW_TIMERS)

    def test_nothing_stays_open(self):
        before = len(os.listdir("/proc/self/fd"))
        for _ in range(20):
            loop.run(loop.on_thread(int))
        self.assertEqual(len(os.listdir("/proc/self/fd")), before)


class Struck(Exception):
    pass


# A process that says how it ended: see Signals. {body} awaits, {between} is plain code.
CHILD = """
import ctypes, os, signal, sys, time, weakref
from rtshell_lite.net import loop
loop.PATIENCE, loop.BOUNCE = %s
class Struck(Exception):
    pass
async def main():
    try:
        print("ready", flush=True)
        %s
    finally:
        await loop.sleep(%s)
        print("cleaned up", flush=True)
try:
    loop.run(main(), {signal.SIGINT: Struck})
except Struck:
    print("struck", flush=True)
print(signal.getsignal(signal.SIGINT) is signal.default_int_handler, flush=True)
"""


class Signals(Case):
    def child(self, body, cleaning=0.0, patience=0.2, bounce=loop.BOUNCE):
        program = CHILD % ((patience, bounce), body, cleaning)
        child = subprocess.Popen(
            [sys.executable, "-c", program],
            stdout=subprocess.PIPE,
            universal_newlines=True,
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
        )
        self.addCleanup(child.stdout.close)
        self.addCleanup(child.kill)
        self.assertEqual(child.stdout.readline(), "ready\n")
        return child

    def test_they_arrive_at_an_await(self):
        child = self.child("await loop.sleep(60)")
        begun = time.monotonic()
        child.send_signal(signal.SIGINT)
        self.assertEqual(child.communicate()[0], "cleaned up\nstruck\nTrue\n")
        self.assertLess(time.monotonic() - begun, 10)

    def test_plain_code_is_not_torn(self):
        child = self.child("time.sleep(0.5); print('whole', flush=True); await loop.sleep(60)", patience=60)
        child.send_signal(signal.SIGINT)
        self.assertEqual(child.communicate()[0], "whole\ncleaned up\nstruck\nTrue\n")

    def assert_strikes_again(self, lines):
        child = self.child("; ".join(lines + ["await loop.sleep(60)"]))
        child.send_signal(signal.SIGINT)
        self.assertEqual(child.communicate()[0], "cleaned up\nstruck\nTrue\n")

    def test_an_exception_that_c_code_prints_strikes_again(self):
        """As a callback of the import system has it."""
        self.assert_strikes_again([
            "referent = type('Referent', (), {})()",
            "reference = weakref.ref(referent, lambda _: time.sleep(1))",
            "del referent",
        ])

    def test_an_exception_that_c_code_clears_strikes_again(self):
        self.assert_strikes_again([
            "answer = lambda self, name: time.sleep(1)",
            "slow = type('Slow', (), {'__getattr__': answer})()",
            "ctypes.pythonapi.PyObject_HasAttr(ctypes.py_object(slow), ctypes.py_object('name'))",
        ])

    def test_a_task_that_never_awaits_is_struck(self):
        """It computes for long, or writes to who does not read."""
        child = self.child("time.sleep(60)")
        begun = time.monotonic()
        child.send_signal(signal.SIGINT)
        self.assertEqual(child.communicate()[0], "cleaned up\nstruck\nTrue\n")
        self.assertLess(time.monotonic() - begun, 20)

    def test_tasks_that_run_beside_are_cancelled(self):
        child = self.child("await loop.each([60, 60], loop.sleep)")
        child.send_signal(signal.SIGINT)
        self.assertEqual(child.communicate()[0], "cleaned up\nstruck\nTrue\n")

    def test_the_same_key_press_twice(self):
        child = self.child("await loop.sleep(60)", 1, bounce=60)  # a busy machine may hold up this process
        child.send_signal(signal.SIGINT)
        child.send_signal(signal.SIGINT)
        self.assertEqual(child.communicate()[0], "cleaned up\nstruck\nTrue\n")

    def test_cleaning_up_has_a_deadline(self):
        child = self.child("await loop.sleep(60)", 60)
        begun = time.monotonic()
        child.send_signal(signal.SIGINT)
        self.assertEqual(child.communicate()[0], "struck\nTrue\n")
        self.assertLess(time.monotonic() - begun, 40)

    def test_no_other_thread_hears_them(self):
        """A loop on another thread leaves the handlers as they are."""
        found = []
        before = signal.getsignal(signal.SIGINT)
        thread = threading.Thread(
            target=lambda: found.append(loop.run(after(0.01, "x"), {signal.SIGINT: Struck}))
        )
        thread.start()
        thread.join()
        self.assertEqual(found, ["x"])
        self.assertIs(signal.getsignal(signal.SIGINT), before)


if __name__ == "__main__":
    unittest.main()
