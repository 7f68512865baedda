"""What has happened to a component or a process that is kept, and what was done about it: for people, logs,
programs.
"""

import collections
import os

from rtshell_lite import files, notes
from rtshell_lite.net import calendar, loop
from rtshell_lite.text import json_line


class Happening(collections.namedtuple("Happening", "time object seen done seconds error")):
    """What has happened: when (seconds since 1970), to which object, what was seen, what was done about it
    ("" for nothing), how many seconds that took, and the errors.Error that says why it failed, or None.
    """

    __slots__ = ()

    def as_dict(self):
        """For JSON."""
        values = dict(self._asdict())
        if self.error:
            values["error"] = str(self.error)
        return values

    def words(self):
        """What was seen and done."""
        return ": ".join(filter(None, (self.seen, self.done)))

    def line(self):
        """For people."""
        clock = calendar.local("%H:%M:%S", self.time)
        return f"[{clock}] {self.object}: {self.words()}"


def now(where, seen, done="", begun=None, error=None):
    """A Happening of this moment; `begun` by loop.now()."""
    seconds = 0.0 if begun is None else loop.now() - begun
    return Happening(loop.wall(), where, seen, done, seconds, error)


class Log:
    """A file to which Happenings are appended as lines of JSON; none where its name is None.
    Raises OSError, errors.Failed for a link that somebody else has put into a directory for all.
    """

    def __init__(self, name):
        self._file = None
        if name is None:
            return
        try:
            self._file = _opened(files.destination(name))
        except OSError as e:
            e.filename = name
            raise

    def add(self, happening):
        """Append one."""
        if self._file is None:
            return
        try:
            self._file.write(json_line(happening.as_dict()).encode("ascii") + b"\n")
            self._file.flush()
        except OSError as e:  # a full disk is no reason to leave a robot alone
            self._file = None
            notes.fail(f"nothing more goes to the log of events: {e.strerror}")


def _opened(target):
    if files.is_special(target):
        return open(target, "ab", opener=_open_at_once)
    return files.append(target)


def _open_at_once(name, flags):
    """As open does, but a FIFO that nobody reads is refused, not waited for."""
    return os.open(name, flags | os.O_NONBLOCK, 0o666)
