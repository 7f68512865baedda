"""Sending values to in ports at a rate."""
import math
import select
import sys
import threading
import time

from rtshell_lite import errors, interrupts
from rtshell_lite.corba import lanes
from rtshell_lite.data import values, writing

TICK = 0.2  # seconds between two calls of look()
HURRY = 2  # times the rate, at most, while catching up: no bursts


class Constant:
    """The same value, repeated."""

    def __init__(self, text):
        self.text = text

    def next(self, seconds):
        """(text of a value, None)"""
        return self.text, None

    def close(self):
        """Do nothing."""


class Lines:
    """The values on stdin. A thread reads a line when one is asked for, so that others can wait with a time limit."""

    def __init__(self):
        if sys.stdin is None:
            raise errors.Usage("no -c VALUE, and stdin is closed")
        self.number, self.waiting, self.closed = 0, False, threading.Event()
        self.asked, self.read = interrupts.Mailbox(), interrupts.Mailbox()
        lanes.start(self._read)

    def next(self, seconds):
        """(text of the next value, its line); None when none has come within `seconds`. Raises EOFError, OSError."""
        if not self.waiting:
            self.waiting = True
            self.asked.put(True)
        result = self.read.get(seconds)
        if result is None:
            return None
        self.waiting = False
        if isinstance(result, Exception):
            raise result
        return result

    def _read(self):
        while self.asked.get(float("inf")):
            try:
                self.read.put(self._line())
            except (EOFError, OSError) as e:
                self.read.put(e)

    def close(self):
        """Stop reading: what is typed from now on is for the prompt of rtsh."""
        self.closed.set()

    def _line(self):
        for line in iter(self._raw_line, b""):
            self.number += 1
            text = line.decode("utf-8", "surrogateescape").strip()
            if text and not text.startswith("#"):
                return text, "line %d" % self.number
        raise EOFError()

    def _raw_line(self):
        while sys.stdin.isatty() and not select.select([sys.stdin], [], [], TICK)[0] and not self.closed.is_set():
            pass
        return b"" if self.closed.is_set() else sys.stdin.buffer.readline()


class Injection:
    """Writers, each with the Type of its port; `sent` counts values."""

    def __init__(self, writers, kinds, types):
        self.writers, self.kinds, self.types = writers, kinds, types
        self.sent, self.begun, self.ended = 0, 0.0, 0.0
        self._ready = {}

    def checked(self, text, where=None):
        """The values.Expression of `text` for each port. Raises BadValue, NoSuch."""
        if where is None and text in self._ready:
            return self._ready[text]
        try:
            expressions = [values.Expression(text, self.types, kind) for kind in self.kinds]
        except errors.BadValue as e:
            if where is None:
                raise
            raise errors.BadValue(f"{where}: {e.where}", e.why)
        if where is None:
            self._ready[text] = expressions
        return expressions

    def run(self, source, number, rate, seconds, look):
        """Send what `source` gives, `number` values (-1: all), `rate` Hz, for `seconds`; yields each put's error.

        look() is called every TICK. Ends early when no port is left.
        """
        end, due = time.monotonic() + seconds, time.monotonic()
        looked = due
        while self.sent != number and self.live():
            found = self._next(source, end, look)
            if found is None:
                return
            expressions = self.checked(*found)
            if due >= end:
                return
            self._wait(max(due, self.ended + 1 / rate / HURRY), look)
            until = math.inf if rate == math.inf else due + writing.LATE
            yield from self._send(expressions, min(until, end), look)
            now = time.monotonic()
            if now - looked >= TICK:
                looked = now
                look()
            due = now if rate == math.inf else due + 1 / rate
            due = max(due, now - writing.LATE)

    def live(self):
        """[(Writer, its index)] to send to: those without a failure, else silent ones, which would delay the others."""
        healthy = [(writer, i) for i, writer in enumerate(self.writers) if writer.failure is None]
        return healthy or [(writer, i) for i, writer in enumerate(self.writers)
                           if writer.connector and isinstance(writer.failure, errors.Silent)]

    def _next(self, source, end, look):
        while time.monotonic() < end:
            try:
                value = source.next(max(0, min(TICK, end - time.monotonic())))
            except EOFError:
                return None
            if value:
                return value
            look()
        return None

    def _wait(self, due, look):
        while True:
            left = due - time.monotonic()
            if left <= 0:
                return
            time.sleep(min(TICK, left))
            if left > TICK:
                look()

    def _send(self, expressions, until, look):
        """Send a value to all ports, with the same time, as writing.offer does; returns the errors."""
        now = time.time()
        self.ended = time.monotonic()
        self.begun = self.begun or self.ended
        self.sent += 1
        live = self.live()
        failures = writing.offer([(writer, expressions[i].type.encode(expressions[i].value(now), writer.little))
                                  for writer, i in live], until, look)
        failed = dict(failures)
        for writer, _ in live:
            if isinstance(failed.get(writer), errors.Unreachable):
                writer.failure = failed[writer]
            elif isinstance(writer.failure, errors.Silent):
                writer.failure = None
        return [failure for _, failure in failures]

    def useless(self):
        """The Writers that were given values and took none."""
        return [writer for writer in self.writers if self.sent and not writer.taken]

    def rate(self):
        """The rate that was kept, in Hz; None with fewer than two values."""
        return (self.sent - 1) / (self.ended - self.begun) if self.sent > 1 and self.ended > self.begun else None
