"""Numbers over time: what is drawn, where its values come from, and what the axes say. plot_text.py and
plot_svg.py draw.
"""

import math
import re
import sys

from rtshell_lite import errors
from rtshell_lite.net import calendar
from rtshell_lite.text import cells, printable

COLUMNS = 2000  # places on the time axis that a long series is thinned to
MOST = 64  # series of one plot
GAP = 10  # times the usual distance of its values, after which a series has a gap
USUAL = 0.1  # share of each distance in the usual one
LONGEST = 8  # characters of a number at an axis
_STEP = re.compile(r"\.?([A-Za-z_]\w*)|\[(\d{1,9})(?::(\d{1,9}))?\]", re.ASCII)
_TICKS = (1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1200, 1800, 3600, 7200, 10800, 21600, 43200, 86400)  # s


# ---- fields ----


class Field:
    """A part of values that is plotted: `data`, `data.position.x`, `joints[0:3]`; '' is all numbers but the
    timestamp.
    """

    def __init__(self, path):
        """Raises BadPath."""
        self.path = path
        self._steps = []
        end = 0
        while end < len(path):
            step = _STEP.match(path, end)
            if step is None:
                raise errors.BadPath(printable(path), "not a field; one is written data.joints[0:3]")
            self._steps.append(step.groups())
            end = step.end()

    def numbers(self, value):
        """[(name, number, name of the enumerator or None)] in a value, which may be one of JSON. Raises
        NoSuch.
        """
        numbers = []
        self._take(value, "", 0, numbers)
        return numbers[:MOST]

    def _take(self, value, name, index, numbers):
        if value is None:  # a union that holds another member now
            return
        if index == len(self._steps):
            _leaves(value, name, numbers, not self._steps)
            return
        member, start, end = self._steps[index]
        if member is not None:
            inner = self._member(value, member)
            self._take(inner, f"{name}.{member}" if name else member, index + 1, numbers)
            return
        first = int(start)
        last = int(end) if end is not None else first + 1
        if not isinstance(value, (list, tuple, bytes)):
            raise errors.NoSuch(self.path, "field", f"[{first}] (it is not a sequence)")
        for number, element in enumerate(value[first:last], first):
            self._take(element, f"{name}[{number}]", index + 1, numbers)

    def _member(self, value, member):
        members = value if isinstance(value, dict) else getattr(value, "__dict__", {})
        if member in members:
            return members[member]
        if "_d" in members and "_v" in members:  # a union, which may hold it at other times
            cases = getattr(type(value), "_d_to_m", {})
            default = getattr(type(value), "_def_m", None)
            members = [*cases.values(), *filter(None, [default])]
            if member in members:
                return value._v if cases.get(value._d, default) == member else None
        names = ", ".join(sorted(map(printable, members))) or "none"
        raise errors.NoSuch(self.path, "field", f"{member} (there are: {names})")


def _leaves(value, name, numbers, is_all):
    """Append (name, number, enumerator) for all numbers in a value."""
    if len(numbers) > MOST:
        return
    if isinstance(value, (int, float)):
        numbers.append((name, value, None))
    elif isinstance(value, (list, tuple, bytes)):
        for number, element in enumerate(value[:MOST]):
            _leaves(element, f"{name}[{number}]", numbers, is_all)
    elif hasattr(value, "_n") and hasattr(value, "_v"):
        numbers.append((name, value._v, value._n))
    elif not isinstance(value, str) and value is not None:
        members = value if isinstance(value, dict) else vars(value)
        for member, inner in members.items():
            if member != "tm" or not is_all:
                _leaves(inner, f"{name}.{member}" if name else member, numbers, is_all)


# ---- series ----


class Series:
    """Values over time: `points`, each (ns since the epoch, number, whether a gap is before it).

    `least`, `greatest`, `last` are of all values, also of those that were thinned out. `names` are those of
    an enum's numbers; a series with `is_step` keeps its value until the next one, and one that `lasts` has no
    gap however long that takes.
    """

    lasts = False

    def __init__(self, name, between=None):
        """`between`: (first, last) ns, over which its values will be thinned; None: all are kept."""
        self.name = name
        self.points = []
        self.names = {}
        self.is_step = False
        self.least = self.greatest = self.last = None
        self._between = between
        self._column = None
        self._kept = []  # of this column: the first, the least, the greatest, the last point
        self._usual = None
        self._moment = None

    def add(self, moment, value, name=None):
        if name is not None:
            self.names[value] = name
        self.is_step = self.is_step or name is not None or isinstance(value, bool)
        try:
            value = float(value)
        except OverflowError:  # an integer of hundreds of digits
            value = math.inf
        is_first = self._is_after_gap(moment)
        self._moment = moment
        if not math.isfinite(value):
            self._usual = None  # what comes next is after a gap
            self._moment = None
            return
        if self.last is None:
            self.least = self.greatest = value
        self.least = min(self.least, value)
        self.greatest = max(self.greatest, value)
        self.last = value
        self.keep((moment, value, is_first))

    def _is_after_gap(self, moment):
        if self._moment is None:
            return True
        if self.lasts:
            return False
        distance = moment - self._moment
        if self._usual is None:
            self._usual = distance
            return False
        if distance > GAP * self._usual and distance > 0:
            return True
        self._usual += USUAL * (distance - self._usual)
        return False

    def interrupt(self):
        """Values are missing: what comes next is after a gap."""
        self._moment = None

    def keep(self, point):
        """Add a point as it is, which may be thinned out."""
        if self._between is None:
            self.points.append(point)
            return
        first, last = self._between
        column = (point[0] - first) * COLUMNS // max(last - first, 1)
        if column != self._column:
            self.flush()
            self._column = column
        if not self._kept:
            self._kept = [point] * 4
            return
        if point[1] < self._kept[1][1]:
            self._kept[1] = point
        if point[1] > self._kept[2][1]:
            self._kept[2] = point
        self._kept[3] = point
        if point[2]:  # a gap within a column begins another one
            self.flush()
            self._kept = [point] * 4

    def flush(self):
        """All that was added is in `points`."""
        kept = sorted(set(self._kept))
        if kept and self.points and kept[0] is self.points[-1]:
            del kept[0]
        self.points += kept
        self._kept = []

    def forget(self, moment):
        """Drop the points before `moment`, but one, from which the line comes."""
        count = 0
        while count + 1 < len(self.points) and self.points[count + 1][0] < moment:
            count += 1
        if count > len(self.points) // 4:
            del self.points[:count]

    def said(self, value):
        """A value in words: the name of an enumerator, else the number."""
        return printable(self.names[value]) if value in self.names else number(value)


class Rate:
    """How many values come a second: counted in spans of `width` ns, also of those without any."""

    def __init__(self, series, width=10**9):
        self.series = series
        self._width = width
        self._begin = None
        self._count = 0

    def add(self, moment, count=1):
        """Count values that came at a moment; the first call begins the first span."""
        if self._begin is None:
            self._begin = moment
        self.advance(moment)
        self._count += count

    def advance(self, moment):
        """No more values come before `moment`."""
        while self._begin is not None and moment >= self._begin + self._width:
            self.series.add(self._begin + self._width, self._count * 1e9 / self._width)
            self._count = 0
            self._begin += self._width
            if moment - self._begin > 10000 * self._width:
                self._begin = moment


class Panel:
    """Series that are drawn over one another."""

    def __init__(self, title, axis=None):
        """`axis`: (least, greatest) of its axis, None: as its points need."""
        self.title = title
        self.axis = axis
        self.series = {}  # by name

    def add(self, moment, field, value, between=None):
        """Add the numbers in a value that has come; field is a Field. Raises NoSuch."""
        for name, number, enumerator in field.numbers(value):
            self.named(name, between).add(moment, number, enumerator)

    def named(self, name, between=None):
        if name not in self.series:
            self.series[name] = Series(name, between)
        return self.series[name]

    def is_of_states(self):
        """Whether all its values are booleans or have names: they are shown as bands."""
        return bool(self.series) and all(
            series.is_step and set(series.names or (0.0, 1.0)).issuperset(point[1] for point in series.points)
            for series in self.series.values()
        )

    def bounds(self):
        """(least, greatest) of the axis, or of the points of all series, apart; None without any."""
        if self.axis is not None:
            return self.axis
        heights = [point[1] for series in self.series.values() for point in series.points]
        if not heights:
            return None
        low, high = min(heights), max(heights)
        if low == high:
            more = abs(low) * 0.1 or 1.0
            return max(low - more, -sys.float_info.max), min(high + more, sys.float_info.max)
        return low, high


class Picture:
    """What is drawn: `panels` below one another, over the same time, `first` to `last` (ns since the epoch);
    `marks`: (moment, words) of what happened.
    """

    def __init__(self, panels):
        self.panels = panels
        self.marks = []
        self.first = self.last = None

    def fit(self):
        """Show the time from the first to the last value."""
        for panel in self.panels:
            for series in panel.series.values():
                series.flush()
        moments = [
            point[0] for panel in self.panels for series in panel.series.values() for point in series.points
        ]
        if moments:
            self.first = min(moments)
            self.last = max(moments)
            if self.first == self.last:
                self.last += 10**9

    def is_empty(self):
        return not any(series.points for panel in self.panels for series in panel.series.values())


# ---- axes ----


def number(value):
    """A number in few characters."""
    if abs(value) < 1e15 and value == int(value):
        return "%d" % value
    if 1000 <= abs(value) < 1e12:
        return "%.1f" % value
    return "%.4g" % value


def ticks(low, high, most):
    """[(value, words)]: at most about `most` round values between two bounds."""
    if not high > low or not math.isfinite(high - low):
        return [(low, number(low))]
    rough = (high - low) / max(most, 1)
    if rough < sys.float_info.min:  # numbers so small have no powers of ten between them
        return [(low, number(low))]
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(factor * power for factor in (1, 2, 5, 10) if factor * power >= rough * 0.999)
    digits = max(0, -int(math.floor(math.log10(step) + 1e-9)))
    ticks = []
    for multiple in range(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1):
        value = multiple * step
        words = "%.10g" % value if abs(value) >= 1e15 or digits > 5 else "%.*f" % (digits, value + 0.0)
        ticks.append((value, words))
    return ticks


def share(value, low, high):
    """Where a value is between two bounds, 0 to 1. Their difference may be more than a float."""
    if math.isinf(high - low):
        return (value / 4 - low / 4) / (high / 4 - low / 4)
    return (value - low) / (high - low)


def scale(low, high, most):
    """(ticks, words at the head of the axis, which count for all ticks): where the ticks of two bounds would
    have many digits, the head has what they share, `742 105 000 +`, and their power of ten, `x 1e9`.
    """
    marks = ticks(low, high, most)
    if max((cells(words) for _, words in marks), default=0) <= LONGEST or not math.isfinite(high - low):
        return marks, ""
    if high - low < sys.float_info.min:
        return marks, ""
    head = ""
    shared = _shared(low, high)
    if shared:
        head = _grouped(shared, high - low) + " +"
    power = 0
    marks = ticks(low - shared, high - shared, most)
    if max(cells(words) for _, words in marks) > LONGEST - 2:
        power = 3 * math.floor(math.log10(max(abs(low - shared), abs(high - shared))) / 3)
        factor = 10.0**power
        marks = [
            (value * factor, words)
            for value, words in ticks((low - shared) / factor, (high - shared) / factor, most)
        ]
        head = f"{head} x 1e{power}".strip()
    return [(value + shared, words) for value, words in marks], head


def _shared(low, high):
    """What is at the beginning of all numbers between two bounds; 0 where that is little."""
    step = 10.0 ** math.ceil(math.log10(high - low))
    shared = math.floor(low / step) * step
    return shared if abs(shared) >= 100 * step else 0


def _grouped(value, span):
    """A number with all digits that count beside a span, in groups of three."""
    digits = max(0, -math.ceil(math.log10(span)))
    return f"{value:,.{digits}f}".replace(",", " ")


def time_ticks(first, last, most):
    """([(moment, words)], unit): round times between two moments (ns), counted from the first."""
    span = (last - first) / 1e9
    for unit, scale, limit in (("µs", 1e6, 0.002), ("ms", 1e3, 2), ("s", 1, 120)):
        if span < limit:
            return [
                (first + int(value / scale * 1e9), words) for value, words in ticks(0, span * scale, most)
            ], unit
    step = next((step for step in _TICKS if span / step <= most), 86400 * math.ceil(span / 86400 / most))
    unit, parts = ("min:s", 1) if span < 7200 else ("h:min", 60)
    marks = range(int(span // step) + 1)
    return [
        (first + mark * step * 10**9, "%d:%02d" % divmod(mark * step // parts, 60)) for mark in marks
    ], unit


def elapsed(picture, moment):
    """How long after the begin of a picture a moment is, in words."""
    return "%+.3f s" % ((moment - picture.first) / 1e9)


def date(moment):
    """A moment (ns since the epoch) in local time, with milliseconds."""
    seconds, rest = divmod(moment, 10**9)
    return calendar.local("%Y-%m-%d %H:%M:%S", seconds) + ".%03d" % (rest // 10**6)
