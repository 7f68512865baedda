"""The line on a terminal that says how far long work is. If one of these fails, people wait without knowing
for what, or files and pipes get what is for a terminal.
"""
import io
import os
import pty
import tempfile
import termios
import unittest
from unittest import mock

from rtshell_lite import api, cli, notes, progress
from rtshell_lite.net import loop, real

ERASED = "\r\x1b[K"


class Terminal(io.StringIO):
    """What is written to a terminal, or to a pipe."""

    def __init__(self, is_terminal=True):
        super().__init__()
        self.is_terminal = is_terminal

    def isatty(self):
        return self.is_terminal

    def fileno(self):
        return 2


class Far(unittest.TestCase):
    def setUp(self):
        self.now = 100.0
        self.stderr = Terminal()
        self.stdout = Terminal()
        self.columns = 80
        self.is_read_elsewhere = False
        self.takes = True
        for target, name, value in (
            (loop, "now", lambda: self.now),
            (progress, "_columns", lambda: self.columns),
            (progress, "_is_read_elsewhere", lambda prints: self.is_read_elsewhere or prints),
            (real, "takes", lambda descriptor: self.takes),
            (notes, "listener", cli._hear),
            (notes, "on_work", cli._show_work),
            (cli, "_lines", None),
            (cli.sys, "stderr", self.stderr),
            (cli.sys, "stdout", self.stdout),
            (cli.sys, "argv", ["/opt/bin/rtcryo"]),
        ):
            patched = mock.patch.object(target, name, value)
            patched.start()
            self.addCleanup(patched.stop)

    def work(self, seconds, steps=10, **more):
        """Work of 100 steps, of which `steps` are done in some seconds."""
        with notes.Work("components", 100, **more) as work:
            for _ in range(steps):
                self.now += seconds / steps
                work.count()
            return self.said()

    def said(self):
        return self.stderr.getvalue()

    def lines(self):
        return [line for line in self.said().split(ERASED) if line]

    def test_short_work_shows_nothing(self):
        self.work(0.6)
        self.assertEqual(self.said(), "")

    def test_long_work_says_how_far_it_is_and_how_long_still_and_is_gone_at_its_end(self):
        self.work(2.0)
        self.assertEqual(self.lines()[0], "rtcryo: 4 of 100 components, about 19 s left")
        self.assertEqual(self.lines()[-1], "rtcryo: 10 of 100 components, about 18 s left")
        self.assertTrue(self.said().endswith(ERASED))

    def test_what_waits_for_something_that_hangs_says_so(self):
        async def main():
            with mock.patch.object(progress, "WAITING", 0.001):
                with notes.Work("components", 3) as work:
                    work.count()
                    for second in "23":
                        self.now += {"2": 2.0, "3": 1.0}[second]
                        while f"1 of 3 components, waiting for {second} s" not in self.said():
                            await loop.sleep(0.001)
        loop.run(main())
        self.assertTrue(self.said().endswith(ERASED))

    def test_ten_lines_a_second_at_most(self):
        self.work(2.0, 100)
        self.assertLessEqual(len(self.lines()), 13)

    def test_it_is_gone_when_the_work_fails(self):
        with self.assertRaises(ZeroDivisionError), notes.Work("components", 3) as work:
            self.now += 1
            work.count()
            1 / 0
        self.assertTrue(self.said().endswith("left" + ERASED))

    def test_what_is_said_meanwhile_stands_on_a_line_of_its_own(self):
        with notes.Work("components", 3) as work:
            self.now += 1
            work.count()
            notes.note("Arm0.rtc: zombie, left out")
            self.now += 1
            work.count()
        first, second = self.lines()[:2]
        self.assertEqual(first, "rtcryo: 1 of 3 components, about 2 s left")
        self.assertEqual(second, "rtcryo: Arm0.rtc: zombie, left out\n")

    def test_of_work_that_is_part_of_another_that_is_shown_which_takes_long(self):
        with notes.Work("steps", 10, even=False) as whole:
            with notes.Work("components", 10) as part:
                self.now += 1
                part.count()
            self.assertEqual(self.lines()[0], "rtcryo: 1 of 10 components, about 9 s left")
            with notes.Work("s", 10) as part:
                self.now += 0.5
                part.count()
            self.now += 0.1
            whole.count()
        self.assertEqual(self.lines()[1:], ["rtcryo: 0 of 10 steps", "rtcryo: 1 of 10 steps"])

    def test_a_pipe_and_quiet_get_nothing(self):
        self.stderr.is_terminal = False
        self.assertEqual(self.work(5.0), "")
        self.stderr.is_terminal = True
        with mock.patch.object(cli, "_quiet", True):
            self.assertEqual(self.work(5.0), "")

    def test_where_something_is_printed_or_another_program_reads_it_there_is_nothing(self):
        self.assertEqual(self.work(5.0, prints=True), "")
        self.is_read_elsewhere = True
        self.assertEqual(self.work(5.0), "")

    def test_a_terminal_that_takes_nothing_is_not_waited_for(self):
        self.takes = False
        self.assertEqual(self.work(5.0), "")

    def test_it_is_as_wide_as_the_terminal_at_most(self):
        self.columns = 20
        self.work(2.0)
        self.assertEqual(self.lines()[0], "rtcryo: 4 of 100 co")

    def test_octets_are_megabytes_and_long_spans_minutes_and_hours(self):
        for done, seconds, words in (
            (10**9, 40, "1000 of 4000 MB, about 2 min left"), (10**8, 300, "100 of 4000 MB, about 3 h left"),
        ):
            with notes.Work("octets", 4 * 10**9) as work:
                for _ in range(seconds):
                    self.now += 1.0
                    work.reach(done)
            self.assertEqual(self.lines()[-1], "rtcryo: " + words)

    def test_of_uneven_steps_nobody_knows_how_long_the_rest_takes(self):
        self.work(2.0, even=False)
        self.assertEqual(self.lines()[-1], "rtcryo: 10 of 100 components")

    def test_a_pause_does_not_count_for_the_rest(self):
        with notes.Work("components", 4) as work:
            self.now += 30.0
            work.count()
            self.now += 1.0
            work.count()
        self.assertEqual(self.lines()[-1], "rtcryo: 2 of 4 components, about 1 s left")

    def test_what_counts_for_a_task_counts_failures_too(self):
        async def fail(item):
            raise ValueError(item)

        async def main():
            with notes.Work("components", 2) as work:
                for _ in range(2):
                    with self.assertRaises(ValueError):
                        await work.counting(fail)("it")
                return work.done
        self.assertEqual(loop.run(main()), 2)


class InPrograms(unittest.TestCase):
    def test_long_work_is_nothing_to_be_logged(self):
        with mock.patch.object(notes, "listener", api._report), mock.patch("logging.getLogger") as logged:
            with notes.Work("components", 2) as work:
                work.count()
        self.assertFalse(logged.called)


class Elsewhere(unittest.TestCase):
    def check(self, descriptor, prints):
        with os.fdopen(descriptor, "w") as file, mock.patch.object(progress.sys, "stdout", file):
            return progress._is_read_elsewhere(prints)

    def test_a_pipe_leads_to_another_program_a_file_does_not(self):
        read, write = os.pipe()
        self.addCleanup(os.close, read)
        self.assertTrue(self.check(write, False))
        with tempfile.TemporaryFile() as file:
            self.assertFalse(self.check(os.dup(file.fileno()), True))
        self.assertFalse(self.check(os.open(os.devnull, os.O_WRONLY), True))

    def test_a_terminal_is_read_by_a_person(self):
        ours, theirs = pty.openpty()
        self.addCleanup(os.close, ours)
        self.assertTrue(self.check(os.dup(theirs), True))
        self.assertFalse(self.check(theirs, False))


class Paused(unittest.TestCase):
    def test_a_paused_terminal_takes_nothing(self):
        ours, theirs = pty.openpty()
        self.addCleanup(os.close, ours)
        self.addCleanup(os.close, theirs)
        self.assertTrue(real.takes(theirs))
        termios.tcflow(theirs, termios.TCOOFF)
        self.assertFalse(real.takes(theirs))


class Columns(unittest.TestCase):
    def test_without_a_terminal_that_can_erase_there_are_none(self):
        for term in ("dumb", None):
            with mock.patch.dict(os.environ):
                os.environ.pop("TERM", None)
                if term:
                    os.environ["TERM"] = term
                self.assertEqual(progress._columns(), 0)

    def test_another_program_in_the_foreground_keeps_its_terminal(self):
        with mock.patch.dict(os.environ, TERM="xterm"), mock.patch.object(os, "tcgetpgrp", lambda fd: 1):
            self.assertEqual(progress._columns(), 0)


if __name__ == "__main__":
    unittest.main()
