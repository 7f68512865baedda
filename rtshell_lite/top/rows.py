"""What rttop shows of a system, as lines and as JSON; sorting and filtering its rows."""

import collections
import functools
import os

from rtshell_lite import path, text
from rtshell_lite.net import loop
from rtshell_lite.views.listing import MARKS

SORTS = ("name", "state", "rate", "connections", "trouble")
GROUPS = ("none", "directory", "host")
# the order by state: trouble first
STATES = ("Error", "?", "~", "-", "Active", "Inactive", "Created", "Unknown", None)

# One component. `name` is its own, or the path where two have the same; `kind` is component, zombie, silent
# or unasked, or unknown: a part of the tree that cannot be listed. `state` is ? for what does not answer, ~
# for what was not asked and - for a zombie; `rate` in Hz, of the first context that runs, else of the first
# one; `running` whether any does; `ports` and `connections` are counts. None is unknown (yet). `failure` is
# an errors.Error or None. `since` is when it became so, by loop.now(), None if that is longer ago than it
# has been looked at; `event` is what was seen to change last, in words; `flow` {port: values that are written
# a second}, {} unless measured.
Row = collections.namedtuple(
    "Row", "path name kind state rate running ports connections failure since event flow"
)

HEAD = "STATE         RATE  CONN  COMPONENT"
WIDE_HEAD = "STATE         RATE  MEASURED  VALUES/S  CONN  COMPONENT"
WIDE = 110  # columns from which on there is room for more
_NAMES = 36  # columns at most for names, and for directories


def arranged(rows, sort="name", pattern=""):
    """The Rows that match all words of `pattern`, in the order of one of SORTS.

    A word, in any case, matches part of a path, or a whole state.
    """
    for word in pattern.lower().split():
        rows = [row for row in rows if word in row.path.lower() or word == (row.state or "").lower()]
    keys = {
        "name": lambda row: 0,
        "state": lambda row: STATES.index(row.state),
        "rate": lambda row: -(row.rate or 0),
        "connections": lambda row: -(row.connections or 0),
        "trouble": lambda row: min(STATES.index(row.state), STATES.index("Active")),
    }
    return sorted(rows, key=keys[sort])


def shortened(shown):
    """(the Rows, the directory in which all those are whose names are paths): it is left out of these names.
    "" for Rows with names of their own.
    """
    paths = [row.path for row in shown if row.name == row.path]
    common = os.path.commonprefix(paths)
    common = common[: common.rfind("/") + 1]
    if len(paths) < 2 or common == "/":
        return shown, ""
    short = []
    for row in shown:
        if row.name == row.path:
            row = row._replace(name=row.name[len(common) :])
        short.append(row)
    return short, common


def common_directory(listed):
    """What the directories of these Rows begin with, if there are several rows: "/robot1:2809/"; "" for
    nothing.
    """
    common = os.path.commonprefix([row.path for row in listed])
    common = common[: common.rfind("/") + 1]
    return common if len(listed) > 1 and common != "/" else ""


natural = functools.lru_cache(maxsize=4096)(text.natural)  # for all rows at each look


def group(row, kind):
    """The group of GROUPS that a Row is in: the directory or the host of its path."""
    return _group(row.path, kind)


@functools.lru_cache(maxsize=4096)
def _group(words, kind):
    where = path.parse(words)
    if kind == "directory":
        return str(where.parent())
    hosts = [text.printable(name.id) for name in where.names if name.kind == "host_cxt"]
    return (hosts + [text.printable(where.server or "")])[0]


def grouped(shown, kind):
    """The Rows with a line before those of each group: [Row or text]; groups with trouble come first."""
    if kind == "none":
        return list(shown)
    groups = collections.OrderedDict()
    for row in shown:
        groups.setdefault(group(row, kind), []).append(row)
    lines = []
    for name, members in groups.items():
        lines.append(f"{name}: {summary(members)}")
        lines += members
    return lines


def summary(rows):
    """How many components there are in which states: 3 components: 1 Error, 2 Active."""
    counts = collections.Counter(row.state for row in rows if row.kind != "unknown")
    total = sum(counts.values())
    words = {"-": "zombie", "?": "silent", "~": "not asked", None: "not asked yet"}
    states = ", ".join(f"{counts[state]} {words.get(state, state)}" for state in STATES if counts[state])
    number = text.counted(total, "component")
    if states:
        return f"{number}: {states}"
    return number


def line(row):
    """A Row as a line below HEAD; it begins with the state."""
    why = ": " + reason(row.path, row.failure) if row.failure else ""
    return "%-8s  %8s  %4s  %s" % (row.state or "", _rate(row), _connections(row), _name(row) + why)


def _rate(row):
    if row.rate is None:
        return "-"
    if row.running is False:
        return "stopped"
    return f"{row.rate:g}"


def _connections(row):
    if row.connections is None:
        return "-"
    return str(row.connections)


def _name(row):
    return MARKS.get(row.kind, "") + row.name


def _wide_line(row):
    """A Row as a line below WIDE_HEAD. What writes in each cycle shows the rate at which it is executed."""
    measured = values = "-"
    if row.flow:
        measured = f"{max(row.flow.values()):.1f}"
        values = f"{sum(row.flow.values()):.1f}"
    figures = (row.state or "", _rate(row), measured, values, _connections(row))
    return "%-8s  %8s  %8s  %8s  %4s  " % figures + _name(row)


def wide_head(shown):
    """WIDE_HEAD with the columns that `wide_lines` adds, for these Rows."""
    names, directories, _ = _widths(shown)
    return "%s  %s  %5s  %s  %s" % (
        WIDE_HEAD[: -len("COMPONENT")] + text.padded("COMPONENT", names),
        text.padded("DIRECTORY", directories),
        "SINCE",
        "",
        "LAST EVENT",
    )


def wide_lines(shown, listed):
    """Yield a line for each Row of `shown`, which are some of those `listed`, below their `wide_head`."""
    names, directories, common = _widths(listed)
    for row in shown:
        why = reason(row.path, row.failure) if row.failure else row.event
        yield "%s  %s  %5s    %s" % (
            text.padded(_wide_line(row), len(WIDE_HEAD) - len("COMPONENT") + names),
            text.padded(_directory(row, common), directories),
            _duration(row.since and loop.now() - row.since),
            why,
        )


def _widths(shown):
    """Columns for names and for directories, and the directory that is left out of directories."""
    common = common_directory(shown)
    names = [text.cells(row.name) + 1 for row in shown]
    directories = [text.cells(_directory(row, common)) for row in shown]
    return min(max(names + [9]), _NAMES), min(max(directories + [9]), _NAMES), common


def _directory(row, common):
    """The directory of a Row below a common one."""
    return group(row, "directory")[len(common) :] or "."


def _duration(seconds):
    """`12s`, `5m`, `3h`, `2d`; `-` for None."""
    if seconds is None:
        return "-"
    for unit, length in (("d", 86400), ("h", 3600), ("m", 60)):
        if seconds >= length:
            return f"{int(seconds // length)}{unit}"
    return f"{int(seconds)}s"


def rate_line(rate):
    """A statistics.Rate as a line."""
    if rate.failure:
        return "%8s Hz  %11s  %s" % ("?", "?", text.safe(str(rate.failure)))
    if rate.values is None:
        return "%8s Hz  %11s  %s" % ("-", "-", rate.path)
    return "%8.1f Hz  %11s  %s" % (rate.values, _size(rate.bytes), rate.path)


def _size(bytes_per_second):
    for factor, unit in ((1e9, "GB/s"), (1e6, "MB/s"), (1e3, "kB/s")):
        if bytes_per_second >= factor:
            return f"{bytes_per_second / factor:.1f} {unit}"
    return f"{bytes_per_second:.0f} B/s"


def reason(path, failure):
    """Why something failed, in one line for the terminal, without the path before it."""
    return text.safe(failure.why if failure.where == path else str(failure))


def as_dict(row, now):
    """The JSON object of a Row; `now` in seconds since 1970."""
    fields = {
        "time": now,
        "path": row.path,
        "name": row.name,
        "kind": row.kind,
        "state": row.state,
        "rate": row.rate,
        "running": row.running,
        "ports": row.ports,
        "connections": row.connections,
    }
    if row.failure:
        return dict(fields, error=str(row.failure))
    return fields


def rate_as_dict(rate, now):
    """The JSON object of a statistics.Rate."""
    fields = {
        "time": now,
        "path": rate.path,
        "kind": "port",
        "values_per_second": rate.values and round(rate.values, 3),
        "bytes_per_second": rate.bytes and round(rate.bytes, 1),
    }
    if rate.failure:
        return dict(fields, error=str(rate.failure))
    return fields
