"""How far long work is: a line on the terminal, gone when the work ends or something else is said."""

import os
import sys

from rtshell_lite import text
from rtshell_lite.net import loop

FIRST = 0.7  # seconds until it is shown
AGAIN = 0.1  # seconds between two lines, at least
WAITING = 0.5  # seconds between two lines while nothing gets done
STILL = 1.0  # seconds in which nothing gets done, after which nobody knows how long it takes

_ERASED = "\r\x1b[K"


class Line:
    """The line of one notes.Work; `name` stands before it."""

    def __init__(self, work, name):
        self.work = work
        self._name = name
        self._begun = loop.now()
        self._due = self._begun + FIRST
        self._done = 0
        self._reached = self._begun  # when that was done
        self._is_on_screen = False
        here = loop.current()
        self._timer = here and here.call_later(FIRST, self._draw_again)

    def end(self):
        """The work is over."""
        self.erase()
        if self._timer is not None:
            self._timer.cancel()

    def _draw_again(self):
        self.draw()
        self._timer = loop.current().call_later(WAITING, self._draw_again)

    def draw(self):
        """Show how far the work is, unless it is too early for that, or there is no terminal for it."""
        now = loop.now()
        if self.work.done != self._done:
            self._done = self.work.done
            self._reached = now
        if now < self._due:
            return
        self._due = now + AGAIN
        columns = _columns()
        if columns > 1:
            self._is_on_screen = True
            _write(_ERASED + self._words(now)[: columns - 1])

    def erase(self):
        """Leave the terminal as it was."""
        if self._is_on_screen:
            self._is_on_screen = False
            _write(_ERASED)

    def _words(self, now):
        work = self.work
        words = f"{self._name}: {_amount(work)}"
        if now - self._reached >= STILL:
            return f"{words}, waiting for {_span(now - self._reached)}"
        if not work.even or not work.done or work.done >= work.total:
            return words
        return f"{words}, about {_span((now - self._begun) / work.done * (work.total - work.done))} left"


def _amount(work):
    if work.noun == "octets":
        return f"{work.done / 1e6:.0f} of {work.total / 1e6:.0f} MB"
    return f"{work.done} of {work.total} {text.safe(work.noun)}"


def _span(seconds):
    if seconds < 100:
        return f"{max(1, round(seconds))} s"
    if seconds < 6000:
        return f"{round(seconds / 60)} min"
    return f"{round(seconds / 3600)} h"


def _columns():
    """How wide the terminal is to which stderr leads; 0 where there is none, it cannot erase, or another
    program has it just now.
    """
    if os.environ.get("TERM", "dumb") == "dumb" or sys.stderr is None:
        return 0
    try:
        if os.tcgetpgrp(sys.stderr.fileno()) != os.getpgrp():
            return 0
        return os.get_terminal_size(sys.stderr.fileno()).columns
    except OSError:
        return 0


def _write(words):
    try:
        sys.stderr.write(words)
        sys.stderr.flush()
    except OSError:
        pass  # nobody is left to read it
