"""What has happened to a component or a process that is kept, and what was done about it: for people, logs,
programs.
"""

import collections
import time


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
        clock = time.strftime("%H:%M:%S", time.localtime(self.time))
        return f"[{clock}] {self.object}: {self.words()}"


def now(where, seen, done="", begun=None, error=None):
    """A Happening of this moment; `begun` by time.monotonic()."""
    seconds = 0.0
    if begun is not None:
        seconds = time.monotonic() - begun
    return Happening(time.time(), where, seen, done, seconds, error)
