"""An operation called again and again, and the latency of the calls."""

import collections
import math

from rtshell_lite import errors
from rtshell_lite.net import loop
from rtshell_lite.text import counted

FINE = 200  # steps of a histogram within a factor of e: half a percent


class Latencies:
    """The seconds that calls took, which are not kept: the median and the 99 % are right to half a
    percent.
    """

    def __init__(self):
        self.count = self.failed = 0
        self.least = math.inf
        self.most = 0.0
        self.statuses = set()
        self._begun = loop.now()
        self._steps = collections.Counter()

    def add(self, seconds, error):
        """Count a call; `error` is its errors.Error or None."""
        self.count += 1
        if error is not None:
            self.failed += 1
            self.statuses.add(error.status)
            return
        self.least = min(self.least, seconds)
        self.most = max(self.most, seconds)
        self._steps[round(math.log(max(seconds, 1e-9)) * FINE)] += 1

    def _share(self, share):
        """The time within which this share of the calls was answered, None if none was."""
        left = math.ceil(share * sum(self._steps.values()))
        for step in sorted(self._steps):
            left -= self._steps[step]
            if left <= 0:
                return min(max(math.exp(step / FINE), self.least), self.most)
        return None

    def summary(self):
        """A dict of figures: calls, failed, seconds in all, and of the answered calls min, median, p99, max,
        in seconds, None where none was answered.
        """
        figures = {"calls": self.count, "failed": self.failed, "seconds": loop.now() - self._begun}
        figures.update(min=None, median=self._share(0.5), p99=self._share(0.99), max=None)
        if self._steps:
            figures.update(min=self.least, max=self.most)
        return figures

    def line(self):
        """The figures as a line for people."""
        figures = self.summary()
        seconds = f"{figures['seconds']:.3f} s"
        shown = f"{counted(self.count, 'call')}, {self.failed} failed, in {seconds}"
        if figures["median"] is None:
            return shown
        times = ["%s %.3f ms" % (words, 1e3 * figures[key]) for words, key in SHOWN]
        return f"{shown}: {', '.join(times)}"

    def status(self):
        """The exit status: 0, that of the failures where all failed alike, else 5."""
        if not self.failed:
            return 0
        if self.failed == self.count and len(self.statuses) == 1:
            return next(iter(self.statuses))
        return errors.Partial.status


SHOWN = (("min", "min"), ("median", "median"), ("99 %", "p99"), ("max", "max"))


async def calls(call, rate=0.0, number=None):
    """Yield (seconds, result, errors.Error or None) of each of `number` calls, None for any number: call()
    makes one, `rate` times a second, 0 for one after the other. What is late is not made up for.

    Ends with the first failure that shows that no more will succeed: it may have been done, or cannot be
    reached.
    """
    due = loop.now()
    while number is None or number > 0:
        begun = loop.now()
        result = error = None
        try:
            result = await call()
        except errors.Error as e:
            error = e
        yield loop.now() - begun, result, error
        if isinstance(error, errors.Unreachable):
            return
        if number is not None:
            number -= 1
        if rate:
            due = max(due + 1 / rate, loop.now() - 1 / rate)
            await loop.sleep(max(0.0, due - loop.now()))
