"""How far long work is: a line on the terminal, gone when the work ends or something else is said.

Nothing waits for that terminal: where it takes nothing, as after Ctrl-S, the line is left out.
"""

import os
import sys

from rtshell_lite import text
from rtshell_lite.net import loop

FIRST = 0.7  # seconds until it is shown
AGAIN = 0.1  # seconds between two lines, at least
WAITING = 0.5  # seconds between two lines while nothing gets done
STILL = 2.0  # seconds without anything done, after which the line says how long it has waited
FORETOLD = 0.02  # the part that has to be done before the line says how long the rest takes

_ERASED = "\r\x1b[K"
_KIND = 0o170000  # of a file, in its mode
_REGULAR = 0o100000
_DEVICE = 0o020000


class Lines:
    """The works that go on; of the newest that takes long the line is shown. `name` stands before it."""

    def __init__(self, name):
        self._name = name
        self._lines = []
        self._due = 0.0  # when the next one may be written
        self._is_on_screen = False
        self._timer = None

    def take(self, work):
        """Show how far a notes.Work is that begins, goes on or is over."""
        line = next((line for line in self._lines if line.work is work), None)
        if work.is_over:
            self._end(line)
        elif line is not None:
            line.reach()
            self._draw()
        elif not _is_read_elsewhere(work.prints):
            self._lines.append(_Line(work))
            if self._timer is None and loop.current() is not None:
                self._wait()

    def erase(self):
        """Leave the terminal as it was."""
        if self._is_on_screen and _columns():
            self._is_on_screen = not _write(_ERASED)

    def _end(self, line):
        if line is None:
            return
        self._lines.remove(line)
        self.erase()
        if not self._lines and self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def _wait(self):
        self._timer = loop.current().call_later(WAITING, self._draw_again)

    def _draw_again(self):
        self._draw()
        self._wait()

    def _draw(self):
        now = loop.now()
        shown = [line for line in self._lines if now >= line.begun + FIRST]
        if not shown or now < self._due:
            return
        self._due = now + AGAIN
        columns = _columns()
        if columns > 1 and _write(_ERASED + f"{self._name}: {shown[-1].words(now)}"[: columns - 1]):
            self._is_on_screen = True


class _Line:
    """That of one notes.Work."""

    def __init__(self, work):
        self.work = work
        self.begun = self._since = self._reached = loop.now()

    def reach(self):
        """Something has got done."""
        now = loop.now()
        if now - self._reached >= STILL:
            self._since += now - self._reached  # a pause does not say how long the rest takes
        self._reached = now

    def words(self, now):
        """What it says."""
        work = self.work
        words = _amount(work)
        if now - self._reached >= STILL:
            return f"{words}, waiting for {_span(now - self._reached)}"
        rest = work.total - work.done
        if not work.even or rest <= 0 or work.done < FORETOLD * work.total:
            return words
        return f"{words}, about {_span((now - self._since) / work.done * rest)} left"


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


def _is_read_elsewhere(prints):
    """Whether stdout leads to another program, which may show it on the same terminal; or to that itself,
    where the work prints.
    """
    try:
        kind = os.fstat(sys.stdout.fileno()).st_mode & _KIND
        return kind not in (_REGULAR, _DEVICE) or prints and sys.stdout.isatty()
    except OSError:  # stdout is closed
        return False


def _columns():
    """How wide the terminal of stderr is; 0 where stderr is no terminal, the terminal cannot erase, or a
    program other than this one has it now.
    """
    if os.environ.get("TERM", "dumb") == "dumb" or sys.stderr is None:
        return 0
    try:
        if os.tcgetpgrp(sys.stderr.fileno()) != os.getpgrp():
            return 0
        return os.get_terminal_size(sys.stderr.fileno()).columns
    except (OSError, AttributeError):  # not all systems have process groups
        return 0


def _write(words):
    """Whether the terminal has taken this."""
    try:
        if not loop.world().takes(sys.stderr.fileno()):
            return False
        sys.stderr.write(words)
        sys.stderr.flush()
    except OSError:
        pass  # nobody is left to read it
    return True
