"""Statistics of the values of a port: rate, gaps, bytes, and what their timestamps say."""

import collections
import math

from rtshell_lite.net import loop

# times the usual gap between timestamps: in a longer one cycles are absent, a shorter one makes up for one
LONG = 1.5
SHORT = 0.5
PAUSE = 20  # a gap this many times the usual one, and of at least 1 s, is a pause
PAUSE_LEAST = 10**9  # the usual gap is then found anew
FIRST = 10  # gaps from which the usual one is found


class Spread:
    """Minimum, mean, maximum and standard deviation of numbers, which are not kept."""

    def __init__(self):
        self.count = 0
        self.least = self.mean = self.most = None
        self._squares = 0.0

    def add(self, number):
        """Welford's method, which avoids cancellation."""
        self.count += 1
        if self.count == 1:
            self.least = self.mean = self.most = number
            return
        self.least = min(self.least, number)
        self.most = max(self.most, number)
        step = number - self.mean
        self.mean += step / self.count
        self._squares += step * (number - self.mean)

    def deviation(self):
        return math.sqrt(self._squares / self.count) if self.count else None


class Stretch:
    """The figures of a stretch of time."""

    def __init__(self):
        self.count = self.bytes = self.absent = self.disordered = self.repeated = 0
        self.gaps = Spread()
        self.ages = Spread()

    def summary(self, seconds, dropped):
        """A dict of figures: seconds, values, bytes; None for what is not known. `dropped` values came, but
        were not counted.

        rate        values a second, from the gaps between them
        gap_…       seconds between two values; jitter is the standard deviation
        age_…       seconds from a value's own timestamp to its arrival (negative where clocks differ)
        missing     values known to be lost: those dropped here. Timestamps cannot show losses: a source that
                    overslept leaves the same gap
        absent      values that would fill the long gaps between timestamps, less those that came close after;
                    for ports that send at regular intervals
        disordered  values with an earlier timestamp than the value before; repeated: with the same one, or
                    the same value again, which no other figure counts
        """
        gaps = self.gaps
        ages = self.ages
        rate = bytes_per_second = absent = disordered = repeated = None
        if gaps.mean:
            rate = 1 / gaps.mean
        if seconds > 0:
            bytes_per_second = self.bytes / seconds
        if ages.count:
            absent = self.absent
            disordered = self.disordered
            repeated = self.repeated
        return {
            "seconds": seconds,
            "values": self.count,
            "bytes": self.bytes,
            "rate": rate,
            "gap_min": gaps.least,
            "gap_mean": gaps.mean,
            "gap_max": gaps.most,
            "jitter": gaps.deviation(),
            "bytes_per_second": bytes_per_second,
            "age_mean": ages.mean,
            "age_max": ages.most,
            "missing": dropped,
            "dropped": dropped,
            "absent": absent,
            "disordered": disordered,
            "repeated": repeated,
        }


class Flow:
    """The values of one port: those since the last look, and all."""

    def __init__(self):
        self.total = Stretch()
        self.recent = Stretch()
        self.last = self.stamp = None  # the last arrival and the last timestamp, ns
        self.data = None  # bytes of the last value
        self.stamps = self.since = 0  # number and sum of the gaps between timestamps since a pause

    def add(self, received, data, stamp):
        """Count a value, bytes, that came at `received` with a timestamp or None; both in ns since 1970.

        One that comes twice in a row is counted as repeated only: OpenRTM-aist 2.1 repeats a `put` whose
        answer was lost.
        """
        if stamp and stamp == self.stamp and data == self.data:
            self._count("repeated", 1)
            return
        self.data = data
        size = len(data)
        if self.last is not None:
            self._both("gaps", (received - self.last) / 1e9)
        self.last = received
        for stretch in (self.total, self.recent):
            stretch.count += 1
            stretch.bytes += size
        if stamp:  # 0 in values of components that set no timestamps
            self._both("ages", (received - stamp) / 1e9)
            self._order(stamp)

    def take_recent(self):
        """The Stretch since the last look."""
        recent = self.recent
        self.recent = Stretch()
        return recent

    def _both(self, what, number):
        getattr(self.total, what).add(number)
        getattr(self.recent, what).add(number)

    def _order(self, stamp):
        gap = stamp - self.stamp if self.stamp else None
        self.stamp = stamp
        if gap is None:
            return
        if gap < 0:
            self._count("disordered", 1)
        elif gap == 0:
            self._count("repeated", 1)
        else:
            self._gap(gap)

    def _gap(self, gap):
        usual = self.since / self.stamps if self.stamps else gap
        if gap > max(PAUSE * usual, PAUSE_LEAST):
            self.stamps = self.since = 0
            return
        if self.stamps >= FIRST and gap > LONG * usual:
            self._count("absent", round(gap / usual) - 1)
        elif gap < SHORT * usual:
            self._count("absent", -1)
        self.stamps += 1
        self.since += gap

    def _count(self, what, number):
        for stretch in (self.total, self.recent):
            setattr(stretch, what, max(0, getattr(stretch, what) + number))


SPANS = 4096  # of Counts, at most


class Counts:
    """How many values came when: `spans` is {number of a span of time: values}. Spans are `width` ns long,
    and twice as long whenever there are more than SPANS with values.
    """

    def __init__(self):
        self.width = 10**6
        self.spans = {}

    def add(self, moment):
        """Count a value that came at a moment, in ns since 1970."""
        span = moment // self.width
        self.spans[span] = self.spans.get(span, 0) + 1
        if len(self.spans) > SPANS:
            self._double()

    def _double(self):
        self.width *= 2
        before = self.spans
        self.spans = {}
        for span, count in before.items():
            self.spans[span // 2] = self.spans.get(span // 2, 0) + count


# ---- the rate of the last seconds ----

WINDOW = 2.0  # seconds over which a rate is measured
LEAST = 0.2  # seconds after which there is a first rate

# Values and bytes a second, None while not known; `path` is the port's, `failure` an errors.Error or None.
Rate = collections.namedtuple("Rate", "path values bytes failure")


class Meter:
    """Counts the values of the port at a path; `reader` is a reading.Reader that delivers to `take`."""

    def __init__(self, path, failure=None):
        self.path = path
        self.failure = failure
        self.reader = None
        self._values = self._bytes = 0
        self._looks = collections.deque()  # (when, values, bytes)

    def take(self, message):
        """Count a reading.Message, on a thread of the ORB."""
        self._values += 1
        self._bytes += len(message.data)

    def rate(self):
        """The Rate over the looks of the last WINDOW seconds."""
        now = loop.now()
        while len(self._looks) > 1 and now - self._looks[1][0] >= WINDOW:
            self._looks.popleft()
        self._looks.append((now, self._values, self._bytes))
        failure = self.failure or self.reader and self.reader.failure
        since, values, size = self._looks[0]
        if failure or now - since < LEAST:
            return Rate(self.path, None, None, failure)
        return Rate(
            self.path, (self._values - values) / (now - since), (self._bytes - size) / (now - since), None
        )
