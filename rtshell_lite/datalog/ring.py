"""Logs of several files, which a flight recorder writes: parts that follow one another, a ring of which the
oldest are removed, and what a trigger keeps of the ring.
"""

import collections
import errno
import os
import re
import time

from rtshell_lite import errors, files, notes, text
from rtshell_lite.datalog import logfile, writer

PARTS = 4  # files of a ring, besides the one that is being written
SPACE = 1.0  # seconds between two looks at the free space
SLICE = 2 << 20  # octets that are copied at a time, for messages come meanwhile
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
    """Writes one log after another, with the methods of writer.Writer: NAME-000001.mcap …, or NAME where
    there is but one.
    """

    def __init__(self, name, channels, begun, limits, append=False):
        """Begin the first part. Raises OSError, errors.Failed."""
        self.name = name
        self.limits = limits
        self.protected = None  # the moment (ns) from which on nothing may be removed, or None
        self.channels = list(channels)
        self.attached = {}  # the last attachment of each media type: each file has them
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
        found = sorted(
            (int(match.group(1)), match.string) for match in map(form.match, os.listdir(folder)) if match
        )
        for number, name in found:
            path = os.path.join(folder, name)
            status = os.stat(path)
            self._parts.append(Part(path, status.st_size, int(status.st_mtime * 1e9)))
            self._number = number
        if self._parts:
            with open(self._parts[-1].name, "rb") as last:
                writer.lock(last, self.name)  # nobody else goes on with it

    def _begin(self, begun, append=False):
        self._number += 1
        name = self.name
        if not self._is_single:
            name = self._part_name(self._number)
        self._due = time.monotonic() + (self.limits.seconds or 0)
        self._writer = writer.Writer(name, self.channels, begun, append)

    def add(self, channel):
        self.channels.append(channel)
        self._writer.add(channel)

    def attach(self, moment, name, media_type, data):
        self.attached[media_type] = (moment, name, media_type, data)
        self._writer.attach(moment, name, media_type, data)

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
        is_old = self.limits.seconds is not None and time.monotonic() >= self._due
        is_large = self.limits.octets is not None and self._writer.end >= self.limits.octets
        if is_old or is_large:
            self._next()
        if not self._is_single:
            self._remove_old()

    def _next(self):
        now = int(time.time() * 1e9)
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
            is_old = limits.span is not None and oldest.ended < time.time() * 1e9 - limits.span * 1e9
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
        if not self.limits.leave or time.monotonic() < self._looked + SPACE:
            return
        self._looked = time.monotonic()
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
        known = {(channel.name, channel.type_id): number for number, channel in enumerate(self.channels)}
        try:
            log = logfile.load(name)
        except FileNotFoundError:
            notes.note(f"{text.printable(name)}: it is gone, and so is what the ring held in it")
            return
        with log:
            numbers = [known.get(channel[:2]) for channel in log.channels]
            start = log.since(first)
            if start is None:
                return
            for channel, received, little, data in log.octets(start):
                if received > last + SECOND:  # they come nearly in their order
                    return
                if numbers[channel] is not None and first <= received <= last:
                    yield numbers[channel], received, little, data


class Memory:
    """A ring in memory, with the methods of a Writer: nothing is written until a trigger comes."""

    protected = None

    def __init__(self, channels, span, size):
        self.channels = list(channels)
        self.attached = {}  # the last attachment of each media type
        self._span = span
        self._size = size
        self._messages = collections.deque()
        self._octets = 0

    def add(self, channel):
        self.channels.append(channel)

    def attach(self, moment, name, media_type, data):
        self.attached[media_type] = (moment, name, media_type, data)

    sync = close = lambda self: None

    def write(self, messages):
        for message in messages:
            self._messages.append(message)
            self._octets += len(message[3]) + EACH
        oldest = time.time() * 1e9 - self._span * 1e9
        if self.protected is not None:
            oldest = min(oldest, self.protected)
        while self._messages and (self._messages[0][1] < oldest or self._octets > self._size):
            self._octets -= len(self._messages.popleft()[3]) + EACH

    def past(self, first, last):
        return iter([message for message in self._messages if first <= message[1] <= last])


# ---- triggers ----


class Incident:
    """What is kept of the ring: from `first` to `last` (ns since the epoch), and why: `causes`, (moment,
    words).
    """

    def __init__(self, first, last, cause):
        self.first = first
        self.last = last
        self.causes = [cause]
        self.name = None
        self.messages = None
        self.writer = None


class Incidents:
    """Makes files of the ring when something has happened: `before` seconds of the past and `after` of the
    future.

    trigger() is called anywhere; protect(), step() and finish() on the thread that writes: protect() before
    the ring may drop what is old, step() afterwards.
    """

    def __init__(self, name, before, after, done):
        """`name`: that of the log; done(name of a file): called when it is complete."""
        self._name = name
        self._before = int(before * 1e9)
        self._after = int(after * 1e9)
        self._done = done
        self._begun = int(time.time() * 1e9)
        self._pending = []

    def trigger(self, words, moment=None):
        """Something has happened, now or at a moment; within the future of another incident it is one more
        cause of that.
        """
        if moment is None:
            moment = int(time.time() * 1e9)
        for incident in self._pending:
            if incident.messages is None and moment <= incident.last:
                incident.causes.append((moment, words))
                return
        self._pending.append(Incident(moment - self._before, moment + self._after, (moment, words)))

    def protect(self, ring):
        """Have the ring keep what is pending."""
        ring.protected = min((incident.first for incident in self._pending), default=None)

    def step(self, ring, written):
        """Copy a slice of what is due: all that came before `written` (ns) is in the ring. Raises OSError,
        errors.Failed.
        """
        for incident in self._pending[:1]:
            if incident.last < written:
                self._copy(incident, ring)

    def is_busy(self):
        """Whether something is due."""
        return bool(self._pending) and self._pending[0].last < time.time() * 1e9

    def finish(self, ring):
        """Write all that is pending, as far as it has come."""
        while self._pending:
            self._copy(self._pending[0], ring)

    def _copy(self, incident, ring):
        """Copy a slice of what is kept, or the rest."""
        if incident.writer is None:
            incident.name = self._free_name(incident)
            incident.writer = writer.Writer(incident.name, ring.channels, max(incident.first, self._begun))
            incident.writer.describe("trigger", _described(incident))
            for attachment in ring.attached.values():
                incident.writer.attach(*attachment)
            incident.messages = ring.past(incident.first, incident.last)
        taken = []
        size = 0
        for message in incident.messages:
            taken.append(message)
            size += len(message[3]) + EACH
            if size >= SLICE:
                incident.writer.write(taken)
                return
        incident.writer.write(taken)
        self._pending.remove(incident)
        try:
            incident.writer.close()
        except errors.Failed as e:
            notes.fail(e)
            return
        self._done(incident.name)

    def _free_name(self, incident):
        """A name with the time and the cause, which no file has."""
        moment, words = incident.causes[0]
        stem, dot = os.path.splitext(self._name)
        when = time.strftime("%Y%m%d-%H%M%S", time.localtime(moment / 1e9))
        cause = re.sub(r"[^A-Za-z0-9.]+", "-", words)[:60].strip("-.") or "trigger"
        for number in range(1, 10000):
            name = "%s-%s-%s%s%s" % (stem, when, cause, "-%d" % number if number > 1 else "", dot or ".mcap")
            if not os.path.lexists(name):
                return name
        raise errors.Failed(text.printable(self._name), "too many files of one second")


def _described(incident):
    """What has happened, for a Metadata record."""
    texts = {"cause": incident.causes[0][1], "time": str(incident.causes[0][0])}
    for number, (moment, words) in enumerate(incident.causes[1:100], 2):
        texts["cause %d" % number] = words
        texts["time %d" % number] = str(moment)
    return texts


class Hook:
    """What is done with the file of a trigger: it is reported, and a command is run with its name."""

    def __init__(self, command):
        """`command`: words for the shell, or None."""
        self._command = command
        self._processes = []

    def report(self, name):
        """Such a file is complete."""
        notes.note("kept " + text.printable(name))
        if self._command is None:
            return
        import subprocess

        self._processes = [process for process in self._processes if process.poll() is None]
        words = ["/bin/sh", "-c", self._command + ' "$1"', "sh", name]
        try:
            self._processes.append(subprocess.Popen(words, stdin=subprocess.DEVNULL))
        except OSError as e:
            notes.fail(e)


# ---- from another command ----


class Mailbox:
    """A file beside a log, NAME.trigger, in which `rtlog --trigger-now NAME` leaves a word; it is ours while
    we record.
    """

    def __init__(self, name):
        """Raises OSError, errors.Failed."""
        self._path = name + ".trigger"
        target = files.destination(self._path)
        try:
            fd = os.open(target, os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW | os.O_CLOEXEC, 0o666)
        except OSError as e:
            e.filename = name  # the one that the user knows
            raise
        self._file = os.fdopen(fd, "r+b", 0)
        try:
            writer.lock(self._file, name)
        except errors.Failed:
            self._file.close()
            raise
        self._file.truncate(0)

    def take(self):
        """Whether somebody has left a word, which is taken."""
        if os.fstat(self._file.fileno()).st_size == 0:
            return False
        self._file.truncate(0)
        return True

    def close(self):
        try:
            os.remove(self._path)
        except OSError:
            pass
        self._file.close()


def trigger_now(name):
    """Have the rtlog that records to a ring of that name keep what has happened. Raises Failed where there is
    none.
    """
    import fcntl

    try:
        fd = os.open(name + ".trigger", os.O_WRONLY | os.O_APPEND | os.O_NOFOLLOW | os.O_CLOEXEC)
    except FileNotFoundError:
        raise errors.Failed(text.printable(name), "no rtlog records a ring of that name")
    with os.fdopen(fd, "ab", 0) as file:
        try:
            fcntl.flock(file.fileno(), fcntl.LOCK_SH | fcntl.LOCK_NB)
        except BlockingIOError:
            file.write(b"now\n")
            return
    raise errors.Failed(text.printable(name), "no rtlog records a ring of that name any more")
