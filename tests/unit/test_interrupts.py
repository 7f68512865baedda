"""Signals at the worst of moments: if one of these fails, Ctrl-C brings an internal error, or leaves a connection in a robot."""
import dis
import io
import os
import random
import signal
import sys
import threading
import time
import unittest
from unittest import mock

from rtshell_lite import errors, interrupts
from rtshell_lite.corba import lanes
from rtshell_lite.data import writing
from rtshell_lite.data.connection import Opened
from rtshell_lite.data.inbox import Inbox
from rtshell_lite.data.reading import Message
from rtshell_lite.robot import node
from rtshell_lite.system import run_plan

LIMIT = 10.0  # seconds that anything may take


class Striking(unittest.TestCase):
    """With handlers of its own, which are put back."""

    handler = staticmethod(signal.default_int_handler)

    def setUp(self):
        self.addCleanup(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, self.handler))
        interrupts.begin()


class Struck(list):
    """A list whose append sends two signals, with a pause after each."""

    def append(self, item):
        list.append(self, item)
        for _ in range(2):
            os.kill(os.getpid(), signal.SIGINT)
            time.sleep(0.1)


class Bounded(unittest.TestCase):
    def test_what_is_being_written_takes_memory_too(self):
        """rtlog at full flood held 144 MiB, though 64 may wait: what it was writing did not count."""
        box = Inbox(most_bytes=1000)
        for _ in range(2):
            box.put(0, Message(0, b"x" * 400, True))
        self.assertEqual(len(box.get(0)), 2)
        for _ in range(3):
            box.put(0, Message(0, b"x" * 400, True))
        self.assertEqual((len(box.waiting), box.dropped[0]), (1, 2))
        box.get(0)
        box.get(0)
        box.put(0, Message(0, b"x" * 400, True))
        self.assertEqual(len(box.waiting), 1)


class Waiting(Striking):
    def test_what_has_come_is_taken_again_after_ctrl_c_amid_a_put(self):
        """With a Condition, either side raised: release unlocked lock."""
        box, broken = Inbox(), []
        box.waiting = Struck()

        def put():
            try:
                box.put(0, Message(0, b"", True))
            except RuntimeError as e:
                broken.append(e)
        putter = threading.Timer(0.1, put)
        putter.start()
        try:
            self.assertRaises(KeyboardInterrupt, box.get, LIMIT)
            while True:  # see interrupts
                if not putter.is_alive():  # until the second one
                    break
                time.sleep(0.01)
        except KeyboardInterrupt:
            pass
        putter.join()
        self.assertEqual(broken, [])
        box.waiting = list(box.waiting)
        box.put(0, Message(1, b"", True))
        self.assertEqual([message.received for _, message in box.get(0)], [0, 1])

    def test_a_mailbox_keeps_the_order_and_has_an_end(self):
        box = interrupts.Mailbox(2)
        self.assertEqual([box.put(each) for each in "abc"], [True, True, False])
        self.assertEqual([box.get(0), box.get(0), box.get(0)], ["a", "b", None])
        threading.Timer(0.05, box.put, "d").start()
        self.assertEqual(box.get(LIMIT), "d")
        self.assertIsNone(box.get(0.01))

    def test_a_flag_can_be_waited_for_whatever_strikes(self):
        """With an Event, 44 of 19,460 signals at a random moment ended in: release unlocked lock; and so did an rtlog of 2,000."""
        dice, end = random.Random(1), time.monotonic() + 1
        self.addCleanup(signal.signal, signal.SIGALRM, signal.signal(signal.SIGALRM, signal.default_int_handler))
        while time.monotonic() < end:
            flag = interrupts.Flag()
            try:  # a context manager could be struck itself
                signal.setitimer(signal.ITIMER_REAL, dice.uniform(1e-5, 2e-4))
                while True:  # see interrupts
                    if flag.wait(5e-5):
                        break
            except KeyboardInterrupt:
                pass
        flag.set()
        self.assertTrue(flag.wait(0) and flag.wait(LIMIT) and flag.is_set())

    def test_a_bell_rings_once_however_often_it_was_rung(self):
        bell = interrupts.Bell()
        bell.ring()
        bell.ring()
        self.assertEqual([bell.wait(0), bell.wait(0)], [True, False])


class Loops(unittest.TestCase):
    @unittest.skipIf(sys.version_info < (3, 11), "needs tables of what is caught")
    def test_no_jump_back_is_outside_of_the_try_around_the_loop(self):
        for function in lanes._in_lanes, node._batches, run_plan.Run.carry_out:
            code, before = dis.Bytecode(function), None
            for instruction in code:
                if instruction.opname == "JUMP_BACKWARD":
                    lost = handlers(code, before.offset) & handlers(code, instruction.argval) - handlers(code, instruction.offset)
                    self.assertEqual(lost, set(), function)
                before = instruction


def handlers(code, offset):
    """Where an exception that is raised at this offset is handled."""
    return {entry.target for entry in code.exception_entries if entry.start <= offset < entry.end}


class Putting(Striking):
    handler = staticmethod(interrupts.ctrl_c)

    def test_a_value_that_is_on_its_way_is_waited_for(self):
        """Struck inside of Event.set(), one rtinject in 2,500 left its connection."""
        writer, taken = writing.Writer.__new__(writing.Writer), []
        writer.little, writer.idle, writer.unanswered = True, threading.Event(), True

        def put(data):
            os.kill(os.getpid(), signal.SIGINT)
            time.sleep(0.01)
            taken.append(data)
        with mock.patch.object(writer, "_put", put), self.assertRaises(KeyboardInterrupt):
            writer.put(b"data")
        self.assertEqual((taken, writer.idle.is_set(), writer.unanswered), ([b"data"], True, False))


class Held(Striking):
    handler = staticmethod(interrupts.ctrl_c)

    def strike(self):
        os.kill(os.getpid(), signal.SIGINT)

    def test_comes_afterwards(self):
        done = []
        with self.assertRaises(KeyboardInterrupt):
            with interrupts.held():
                with interrupts.held():
                    self.strike()
                done.append("within")
            done.append("never")
        self.assertEqual(done, ["within"])

    def test_comes_at_once_where_nothing_holds_it(self):
        with mock.patch.object(interrupts, "time") as clock:
            clock.monotonic.return_value = 100.0
            self.assertRaises(KeyboardInterrupt, self.strike)
            self.strike()  # the same key press
            interrupts.begin()
            self.assertRaises(KeyboardInterrupt, self.strike)
            clock.monotonic.return_value += 2 * interrupts.BOUNCE
            self.assertRaises(KeyboardInterrupt, self.strike)

    def test_other_threads_hold_nothing(self):
        holding, over = threading.Event(), threading.Event()

        def hold():
            with interrupts.held():
                holding.set()
                over.wait(LIMIT)
        thread = threading.Thread(target=hold)
        thread.start()
        holding.wait(LIMIT)
        self.assertRaises(KeyboardInterrupt, self.strike)
        over.set()
        thread.join()


class Dying:
    """Ctrl-C comes while this is deleted, where Python ignores exceptions."""

    def __del__(self):
        os.kill(os.getpid(), signal.SIGINT)
        time.sleep(0.01)


@unittest.skipIf(sys.version_info < (3, 8), "this Python has no sys.unraisablehook")
class Lost(Striking):
    handler = staticmethod(interrupts.ctrl_c)

    def setUp(self):
        Striking.setUp(self)
        sys.unraisablehook = interrupts.lost
        self.addCleanup(setattr, sys, "unraisablehook", sys.__unraisablehook__)

    def test_comes_again(self):
        with self.assertRaises(KeyboardInterrupt):
            Dying()
            time.sleep(LIMIT)


class Silent(io.RawIOBase):
    """Ctrl-C comes while this file is closed because nobody has it any more, where Python drops exceptions without a word."""

    def close(self):
        os.kill(os.getpid(), signal.SIGINT)
        time.sleep(0.01)


class Swallowed(Striking):
    handler = staticmethod(interrupts.ctrl_c)

    def test_comes_again(self):
        with self.assertRaises(KeyboardInterrupt):
            Silent()
            time.sleep(LIMIT)

    def test_cleaning_up_is_not_disturbed(self):
        with self.assertRaises(KeyboardInterrupt) as caught:
            try:
                os.kill(os.getpid(), signal.SIGINT)
                time.sleep(LIMIT)
            finally:
                time.sleep(3 * interrupts.CHECK)
        interrupts.arrived()
        self.assertIsNone(caught.exception.__context__)
        time.sleep(2 * interrupts.CHECK)


class Connection:
    """Replaces a connection.Connection; signals come while it is opened or closed."""

    def __init__(self, strikes=()):
        self.strikes, self.endpoint, self.where = strikes, ("here", 1), "/a.rtc:out"
        self.failure = self.connector = None
        self.begun, self.settled, self.closing, self.looking = False, threading.Event(), threading.Event(), threading.Event()

    def strike(self, step):
        if step in self.strikes:
            os.kill(os.getpid(), signal.SIGINT)
            time.sleep(0.1)

    def open(self):
        self.begun = True
        self.strike("open")
        self.connector = "made"
        self.strike("opened")
        self.settled.set()

    def close(self):
        self.closing.set()
        self.strike("close")
        self.connector = None

    def look(self):
        self.looking.set()
        self.closing.wait(LIMIT)
        raise errors.Unreachable(self.where, "the connection has been removed")

    def due(self):
        return False

    def stop(self):
        """It does nothing that had to end before."""

    def report(self, known, unwound):
        """It never stays."""


class Connections(Striking):
    handler = staticmethod(interrupts.ctrl_c)

    def test_none_is_left_whenever_ctrl_c_comes(self):
        for strikes in (["open"], ["opened"], ["close"], ["open", "close"], ["opened", "close"]):
            for others in (0, 6):  # more than there are lanes
                with self.subTest(strikes=strikes, others=others):
                    interrupts.begin()
                    every = [Connection() for _ in range(others)] + [Connection(strikes)]
                    with self.assertRaises(KeyboardInterrupt):
                        with Opened(every):
                            time.sleep(LIMIT if "close" not in strikes[:1] else 0)
                    self.assertEqual([each.connector for each in every], [None] * len(every))

    def test_what_we_have_removed_ourselves_is_no_failure(self):
        connection = Connection()
        with Opened([connection]) as opened:
            thread = threading.Thread(target=opened._in_lanes, args=("look",))
            thread.start()
            connection.looking.wait(LIMIT)
        thread.join()
        self.assertIsNone(connection.failure)

    def test_one_that_was_silent_when_it_was_to_connect_is_not_connected(self):
        connection = Connection()
        connection.failure = errors.Silent(connection.where, "no answer")
        self.assertEqual(Opened([connection]).live(), [])
        connection.connector = "made"
        self.assertEqual(Opened([connection]).live(), [connection])


if __name__ == "__main__":
    unittest.main()
