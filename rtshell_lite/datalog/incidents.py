"""What a flight recorder keeps of its ring when something has happened, and how that is reported."""

import os
import re
import stat

from rtshell_lite import errors, files, notes, text
from rtshell_lite.datalog import writer
from rtshell_lite.datalog.ring import EACH
from rtshell_lite.net import calendar, loop, real

HEAD = b"rtlog --trigger\n"  # how the file begins by which another command triggers
WORD = b"now\n"  # what that command appends
SLICE = 2 << 20  # octets that are copied at a time, for messages come meanwhile


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
        self._begun = int(loop.wall() * 1e9)
        self._pending = []

    def trigger(self, words, moment=None, delay=0.0):
        """Something has happened, now or at a moment, or up to `delay` seconds before; within the future of
        another incident it is one more cause of that.
        """
        if moment is None:
            moment = int(loop.wall() * 1e9)
        for incident in self._pending:
            if incident.messages is None and moment <= incident.last:
                incident.causes.append((moment, words))
                return
        first = moment - self._before - int(delay * 1e9)
        self._pending.append(Incident(first, moment + self._after, (moment, words)))

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
        return bool(self._pending) and self._pending[0].last < loop.wall() * 1e9

    def finish(self, ring):
        """Write all that is pending, as far as it has come."""
        while self._pending:
            self._copy(self._pending[0], ring)

    def _copy(self, incident, ring):
        """Copy a slice of what is kept, or the rest."""
        if incident.writer is None:
            incident.name = self._free_name(incident)
            incident.writer = writer.LogWriter(incident.name, ring.channels, max(incident.first, self._begun))
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
        for gap in ring.gaps:
            if gap.last >= incident.first and gap.first <= incident.last:
                incident.writer.put_gap(gap)
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
        when = calendar.local("%Y%m%d-%H%M%S", moment / 1e9)
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
        self._processes = [process for process in self._processes if process.poll() is None]
        words = ["/bin/sh", "-c", self._command + ' "$1"', "sh", name]
        try:
            self._processes.append(loop.world().start_process(words, stdin=real.NOTHING))
        except OSError as e:
            notes.fail(e)


# ---- from another command ----


class Mailbox:
    """A file beside a log, NAME.trigger, in which `rtlog ring --trigger-now NAME` leaves a word; it is ours
    while we record. A file of that name that does not begin with HEAD is the user's.
    """

    def __init__(self, name):
        """Raises OSError, errors.Failed."""
        self._path = name + ".trigger"
        target = files.destination(self._path)
        flags = os.O_RDWR | os.O_NOFOLLOW | os.O_CLOEXEC | os.O_NONBLOCK
        is_new = True
        try:
            try:
                fd = os.open(target, flags | os.O_CREAT | os.O_EXCL, 0o666)
            except FileExistsError:
                is_new = False
                fd = os.open(target, flags)
        except OSError as e:
            e.filename = name  # the one that the user knows
            raise
        self._file = os.fdopen(fd, "r+b", 0)
        try:
            writer.lock(self._file, name)
            if is_new:
                self._file.write(HEAD)
            elif not _is_ours(fd):  # else another rtlog's, which was killed
                where = text.printable(self._path)
                raise errors.Failed(where, "exists, and is not rtlog's, which needs this name for triggers")
        except (errors.Failed, OSError):
            self._file.close()
            raise
        self._file.truncate(len(HEAD))

    def take(self):
        """Whether somebody has left a word, which is taken."""
        if os.fstat(self._file.fileno()).st_size <= len(HEAD):
            return False
        self._file.truncate(len(HEAD))
        return True

    def close(self):
        try:
            if os.path.samestat(os.fstat(self._file.fileno()), os.lstat(self._path)):
                os.remove(self._path)
        except OSError:
            pass
        self._file.close()


def _is_ours(fd):
    """Whether an open file is that of a Mailbox."""
    return stat.S_ISREG(os.fstat(fd).st_mode) and os.read(fd, len(HEAD)) == HEAD


def trigger_now(name):
    """Have the rtlog that records to a ring of that name keep what has happened. Raises Failed where there is
    none.
    """
    import fcntl

    try:
        flags = os.O_RDWR | os.O_APPEND | os.O_NOFOLLOW | os.O_CLOEXEC | os.O_NONBLOCK
        fd = os.open(name + ".trigger", flags)
    except FileNotFoundError:
        raise errors.Failed(text.printable(name), "no rtlog records a ring of that name")
    with os.fdopen(fd, "r+b", 0) as file:
        if not _is_ours(fd):
            raise errors.Failed(text.printable(name), "no rtlog records a ring of that name")
        try:
            fcntl.flock(file.fileno(), fcntl.LOCK_SH | fcntl.LOCK_NB)
        except BlockingIOError:
            file.write(WORD)
            return
    raise errors.Failed(text.printable(name), "no rtlog records a ring of that name any more")
