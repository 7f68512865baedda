"""Sending values to in ports at a rate."""

import math
import sys

from rtshell_lite import errors
from rtshell_lite.data import values, writing
from rtshell_lite.net import loop

HURRY = 2  # times the rate, at most, while catching up: no bursts


class Constant:
    """The same value, repeated."""

    def __init__(self, text):
        self.text = text

    async def next(self, seconds):
        """(text of a value, None)"""
        return self.text, None


class Lines:
    """The values on stdin. Lines after the last one that was asked for are left there:
    in rtsh they may be commands.
    """

    def __init__(self):
        if sys.stdin is None:
            raise errors.Usage("no -c VALUE, and stdin is closed")
        self._file = sys.stdin.buffer
        self._number = 0  # of the line that was read last
        self._begun = b""  # the beginning of the next one
        self._at_hand = 0  # octets that can be read without waiting

    async def next(self, seconds):
        """(text of the next value, its line); None when none has come within `seconds`.
        Raises EOFError, OSError.
        """
        end = loop.now() + seconds
        while True:
            line = await self._next_line(end)
            if line is None:
                return None
            self._number += 1
            text = line.decode("utf-8", "surrogateescape").strip()
            if text and not text.startswith("#"):
                return text, "line %d" % self._number

    async def _next_line(self, end):
        while not self._begun.endswith(b"\n"):
            if not self._at_hand and not await self._is_ready(end - loop.now()):
                return None
            ahead = self._file.peek()  # type: ignore  # it is a BufferedReader
            if not ahead:
                break
            part = self._file.read(ahead.find(b"\n") + 1 or len(ahead))
            self._begun += part
            self._at_hand = len(ahead) - len(part)
        line = self._begun
        self._begun = b""
        if not line:
            raise EOFError
        return line

    async def _is_ready(self, seconds):
        """Wait until there is something to read, or the end."""
        here = loop.current()
        bell = loop.Bell()
        here.watch(self._file.fileno(), loop.READ, bell.ring)
        try:
            return await bell.wait(seconds)
        finally:
            here.unwatch(self._file.fileno())


class Injection:
    """Writers, each with the Type of its port; `sent` counts values."""

    def __init__(self, writers, kinds, types):
        self.writers = writers
        self.kinds = kinds
        self.types = types
        self.sent = 0
        self.begun = 0.0
        self.ended = 0.0
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

    async def run(self, source, number, rate, seconds):
        """Send what `source` gives, `number` values (-1: all), `rate` Hz, for `seconds`; yields each put's
        error.

        Ends early when no port is left.
        """
        due = loop.now()
        end = due + seconds
        while self.sent != number and self.live():
            try:
                given = await source.next(end - loop.now())
            except EOFError:
                return
            if given is None:
                return
            expressions = self.checked(*given)
            if due >= end:
                return
            left = max(due, self.ended + 1 / rate / HURRY) - loop.now()
            if left > 0:
                await loop.sleep(left)
            until = math.inf if rate == math.inf else due + writing.LATE
            for failure in await self._send(expressions, min(until, end)):
                yield failure
            now = loop.now()
            due = now if rate == math.inf else due + 1 / rate
            due = max(due, now - writing.LATE)

    def live(self):
        """[(Writer, its index)] to send to: those without a failure, else silent ones,
        which would delay the others.
        """
        healthy = [(writer, i) for i, writer in enumerate(self.writers) if writer.failure is None]
        return healthy or [
            (writer, i)
            for i, writer in enumerate(self.writers)
            if writer.connector and isinstance(writer.failure, errors.Unanswered)
        ]

    async def _send(self, expressions, until):
        """Send a value to all ports, with the same time, as writing.offer does; returns the errors."""
        now = loop.wall()
        live = self.live()
        self.ended = loop.now()
        self.begun = self.begun or self.ended
        self.sent += 1
        octets = [
            (writer, expressions[i].type.encode(expressions[i].value(now), writer.little))
            for writer, i in live
        ]
        failures = await writing.offer(octets, until)
        failed = dict(failures)
        for writer, _ in live:
            if isinstance(failed.get(writer), errors.Unreachable):
                writer.failure = failed[writer]
            elif isinstance(writer.failure, errors.Unanswered):
                writer.failure = None
        return [failure for _, failure in failures]

    def useless(self):
        """The Writers that were given values and took none."""
        return [writer for writer in self.writers if self.sent and not writer.taken]

    def rate(self):
        """The rate that was kept, in Hz; None with fewer than two values."""
        if self.sent > 1 and self.ended > self.begun:
            return (self.sent - 1) / (self.ended - self.begun)
        return None
