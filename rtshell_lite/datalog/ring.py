"""Logs of several files, which a flight recorder writes: parts that follow one another, and a ring of which
the oldest are removed. incidents.py keeps what a trigger wants of it.
"""

import collections
import errno
import os
import re

from rtshell_lite import errors, notes, text
from rtshell_lite.datalog import gaps, logfile, writer
from rtshell_lite.net import loop

PARTS = 4  # files of a ring, besides the one that is being written
SPACE = 1.0  # seconds between two looks at the free space
LATE = 2.0  # seconds that a ring holds beyond its own: a busy machine learns late of what has happened
SECOND = 10**9
EACH = 150  # octets that a message takes in memory besides its own

# When a part ends (seconds, octets), how many are kept (None: all), what a ring holds (seconds, octets;
# None: no ring), octets of the disk that stay free.
Limits = collections.namedtuple("Limits", "seconds octets keep span size leave")
# A part that is complete: its name, its octets, when it ended (ns since the epoch).
Part = collections.namedtuple("Part", "name octets ended")


def ring_limits(span, size, leave):
    """The Limits of a ring of `span` seconds and `size` octets, of which one may be None."""
    if span:
        span += LATE
    return Limits(span and max(span / PARTS, 0.5), size and size // (PARTS + 1), None, span, size, leave)


class Parts:
    """Writes one log after another, with the methods of writer.LogWriter: NAME-000001.mcap …, or NAME where
    there is but one.
    """

    def __init__(self, name, channels, begun, limits, append=False):
        """Begin the first part. Raises OSError, errors.Failed."""
        self.name = name
        self.limits = limits
        self.protected = None  # the moment (ns) from which on nothing may be removed, or None
        self.channels = list(channels)
        self.attached = {}  # the last attachment of each media type: each file has them
        self.gaps = collections.deque(maxlen=gaps.MOST)  # the last gaps.Gaps, in whichever part
        self._parts = collections.deque()
        self._is_single = limits.seconds is None and limits.octets is None
        self._looked = 0.0
        self._is_said = False
        self._number = 0
        if not self._is_single:
            self._take_over()
        self._begin(begun, append)

    def _part_name(self, number):
        stem, dot = os.path.splitext(self.name)
        return "%s-%06d%s" % (stem, number, dot or ".mcap")

    def _take_over(self):
        """The parts of an earlier recording of that name belong to the ring."""
        stem, dot = os.path.splitext(os.path.basename(self.name))
        form = re.compile(re.escape(stem) + r"-(\d{6,9})" + re.escape(dot or ".mcap") + r"\Z")
        folder = os.path.dirname(self.name) or "."
        earlier = sorted(
            (int(match.group(1)), match.string) for match in map(form.match, os.listdir(folder)) if match
        )
        for number, name in earlier:
            path = os.path.join(folder, name)
            status = os.stat(path)
            self._parts.append(Part(path, status.st_size, int(status.st_mtime * 1e9)))
            self._number = number
        if self._parts:
            with open(self._parts[-1].name, "rb") as last:
                writer.lock(last, self.name)  # nobody else goes on with it

    def _begin(self, begun, append=False):
        self._number += 1
        name = self.name if self._is_single else self._part_name(self._number)
        self._due = loop.now() + (self.limits.seconds or 0)
        self._writer = writer.LogWriter(name, self.channels, begun, append)

    def add(self, channel):
        self.channels.append(channel)
        self._writer.add(channel)

    def attach(self, moment, name, media_type, data):
        self.attached[media_type] = (moment, name, media_type, data)
        self._writer.attach(moment, name, media_type, data)

    def put_gap(self, gap):
        self.gaps.append(gap)
        self._writer.put_gap(gap)

    def sync(self):
        self._writer.sync()

    def close(self):
        self._writer.close()

    def write(self, messages):
        """Append messages; begin another part where this one is full. Raises OSError, also when the disk is
        nearly full.
        """
        self._leave_space()
        self._writer.write(messages)
        is_old = self.limits.seconds is not None and loop.now() >= self._due
        is_large = self.limits.octets is not None and self._writer.end >= self.limits.octets
        if is_old or is_large:
            self._next()
        if not self._is_single:
            self._remove_old()

    def _next(self):
        now = int(loop.wall() * 1e9)
        name = self._writer.name
        try:
            self._writer.close()
            self._parts.append(Part(name, os.path.getsize(name), now))
        except (errors.Failed, FileNotFoundError) as e:
            notes.note(e)  # somebody has taken it
        self._begin(now)
        for attachment in self.attached.values():
            self._writer.attach(*attachment)

    def _remove_old(self):
        """Remove the parts that a ring need not hold, or that are more than are to be kept."""
        limits = self.limits
        total = sum(part.octets for part in self._parts) + self._writer.end
        while self._parts:
            oldest = self._parts[0]
            is_old = limits.span is not None and oldest.ended < loop.wall() * 1e9 - limits.span * 1e9
            is_large = limits.size is not None and total > limits.size
            is_more = limits.keep is not None and len(self._parts) >= limits.keep
            if self._is_protected(oldest) or not (is_old or is_large or is_more):
                return
            total -= oldest.octets
            self._remove(oldest)

    def _is_protected(self, part):
        return self.protected is not None and part.ended >= self.protected

    def _remove(self, part):
        self._parts.popleft()
        try:
            os.remove(part.name)
        except FileNotFoundError:
            pass  # somebody has taken it

    def _leave_space(self):
        """Remove parts where the disk is nearly full. Raises OSError where that does not help."""
        if not self.limits.leave or loop.now() < self._looked + SPACE:
            return
        self._looked = loop.now()
        while self._free() < self.limits.leave:
            may_remove = self.limits.span or self.limits.size or self.limits.keep
            if not may_remove or not self._parts or self._is_protected(self._parts[0]):
                raise OSError(
                    errno.ENOSPC, "stopped, as the disk is nearly full (--leave)", self._writer.name
                )
            if not self._is_said:
                notes.note(
                    f"{text.printable(self.name)}: the disk is nearly full: older parts are removed (--leave)"
                )
                self._is_said = True
            self._remove(self._parts[0])

    def _free(self):
        status = os.statvfs(os.path.dirname(self.name) or ".")
        return status.f_bavail * status.f_frsize

    def past(self, first, last):
        """The messages that arrived between two moments (ns): (number of the channel, received, little,
        data).
        """
        # a part also has what came before it began, while the one before it was written
        names = [part.name for part in self._parts if part.ended >= first]
        for name in names + [self._writer.name]:
            yield from self._of(name, first, last)

    def _of(self, name, first, last):
        number_of = {(channel.name, channel.type_id): number for number, channel in enumerate(self.channels)}
        try:
            log = logfile.load(name)
        except FileNotFoundError:
            notes.note(f"{text.printable(name)}: it is gone, and so is what the ring held in it")
            return
        with log:
            numbers = [number_of.get(channel[:2]) for channel in log.channels]
            start = log.since(first)
            if start is None:
                return
            for channel, received, little, data in log.octets(start):
                if received > last + SECOND:  # they come nearly in their order
                    return
                if numbers[channel] is not None and first <= received <= last:
                    yield numbers[channel], received, little, data


class Memory:
    """A ring in memory, with the methods of a LogWriter: nothing is written until a trigger comes."""

    protected = None

    def __init__(self, channels, span, size):
        self.channels = list(channels)
        self.attached = {}  # the last attachment of each media type
        self.gaps = collections.deque(maxlen=gaps.MOST)  # the last gaps.Gaps
        self._span = span
        self._size = size
        self._messages = collections.deque()
        self._octets = 0

    def add(self, channel):
        self.channels.append(channel)

    def attach(self, moment, name, media_type, data):
        self.attached[media_type] = (moment, name, media_type, data)

    def put_gap(self, gap):
        self.gaps.append(gap)

    sync = close = lambda self: None

    def write(self, messages):
        for message in messages:
            self._messages.append(message)
            self._octets += len(message[3]) + EACH
        oldest = loop.wall() * 1e9 - self._span * 1e9
        if self.protected is not None:
            oldest = min(oldest, self.protected)
        while self._messages and (self._messages[0][1] < oldest or self._octets > self._size):
            self._octets -= len(self._messages.popleft()[3]) + EACH

    def past(self, first, last):
        return iter([message for message in self._messages if first <= message[1] <= last])
