"""What is missing in a recording: from when until when, of which channels, how many values, and why. A log
has a Metadata record for each such gap.
"""

import collections

from rtshell_lite.datalog import records
from rtshell_lite.text import printable

NAME = "missing"  # of the Metadata records
MOST = 1000  # of a log that are read
NAMED = 5  # channels of a gap that are named in words
QUIET = 1.0  # seconds without a loss, after which a gap has ended
LONGEST = 5.0  # seconds of a gap that is written as it goes on: what a kill -9 costs
DROPPED = "they came faster than they could be written"

# From `first` to `last` (ns since the epoch) values are missing of the channels in `counts`, {name of a
# channel: how many, or None where nobody knows}; `why`: in words.
Gap = collections.namedtuple("Gap", "first last counts why")


def to_texts(gap):
    """The texts of a Gap's Metadata record, by name."""
    import json  # which Debian's python3-minimal lacks, and a live plot does not need

    counts = json.dumps(gap.counts, sort_keys=True)
    return {"first": str(gap.first), "last": str(gap.last), "counts": counts, "why": gap.why}


def from_texts(texts):
    """The Gap that the texts of a Metadata record describe; None where they describe none."""
    import json

    try:
        first = int(texts["first"][:20])
        last = int(texts["last"][:20])
        counts = json.loads(texts["counts"])
        why = texts["why"]
    except (KeyError, ValueError, RecursionError):
        return None
    if not isinstance(counts, dict) or not (records.is_moment(first) and records.is_moment(last)):
        return None
    numbers = {name: count for name, count in counts.items() if count is None or type(count) is int}
    return Gap(first, last, numbers, why)


def as_dict(gap):
    """A Gap as fields for JSON; times are seconds since the epoch."""
    return {"first": gap.first / 1e9, "last": gap.last / 1e9, "counts": gap.counts, "why": gap.why}


def words(gap):
    """Of which channels how much is missing, and why."""
    named = [_of_channel(*item) for item in sorted(gap.counts.items())[:NAMED]]
    more = len(gap.counts) - len(named)
    if more:
        named.append(f"of {more} more channels")
    return f"{', '.join(named)}: {printable(gap.why)}"


def _of_channel(name, count):
    if count is None:
        return f"perhaps values of {printable(name)}"
    return f"{count} values of {printable(name)}"


class Losses:
    """Values that are lost one by one, which become Gaps."""

    def __init__(self):
        self._counts = collections.Counter()  # by key
        self._first = self._last = 0

    def add(self, key, moment):
        """A value that arrived at `moment` (ns) is lost."""
        if not self._counts:
            self._first = moment
        self._counts[key] += 1
        self._last = moment

    def take(self, now, is_end=False):
        """(first, last, {key: values}) of a gap that has ended by `now` (ns), or has gone on for LONGEST;
        None without any. At the end of a recording, all.
        """
        is_over = now - self._last > QUIET * 1e9 or now - self._first > LONGEST * 1e9
        if not self._counts or not (is_over or is_end):
            return None
        taken = self._first, self._last, dict(self._counts)
        self._counts.clear()
        return taken
