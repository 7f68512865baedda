"""What libraries remark; cli.py, rtmount or a program decides what becomes of it.

notes.note("…")      a remark
notes.detail("…")    what was done, for --verbose
notes.progress("…")  what begins now
notes.Work(…)        long work, of which a terminal shows how far it is
notes.fail(e)        a failure, an errors.Error, an OSError or a line; returns its exit status
"""

import sys

from rtshell_lite import errors

NOTE = "note"
DETAIL = "detail"
PROGRESS = "progress"
FAILED_ACTION = "failed action"
FAILURE = "failure"

listener = None  # function(kind, what), or None: nobody listens
on_work = None  # function(Work), called when it begins, goes on, and is over; None: nobody shows it
_left_out = set()  # type: set  # lines already reported by left_out()


def note(line):
    """Remark something that is not a failure."""
    _tell(NOTE, line)


def detail(line):
    """Remark what was done."""
    _tell(DETAIL, line)


def progress(line):
    """Remark what begins now, in the words of rtshell: without the name of the command."""
    _tell(PROGRESS, line)


class Work:
    """Long work: `with notes.Work("components", 300) as work: …`.

    noun    what is counted; octets are shown as MB
    done    how many of `total` are done
    prints  whether something is printed on stdout meanwhile
    even    whether each takes about as long as the others: then it is shown how long the rest will take
    """

    def __init__(self, noun, total, prints=False, even=True):
        self.noun = noun
        self.total = total
        self.prints = prints
        self.even = even
        self.done = 0
        self.is_over = False

    def __enter__(self):
        self._show()
        return self

    def __exit__(self, *_):
        self.is_over = True
        self._show()

    def reach(self, done):
        """Note how many are done."""
        self.done = done
        self._show()

    def _show(self):
        if on_work is not None:
            on_work(self)

    def count(self):
        """One more is done."""
        self.reach(self.done + 1)

    def counting(self, function):
        """A coroutine function that awaits function(item), and counts it as done."""

        async def counted(item):
            try:
                return await function(item)
            finally:
                self.count()

        return counted


def action_failed(error):
    """Report the failure of an action that is not required, in the words of rtshell."""
    _tell(FAILED_ACTION, error)


def reading(name, what):
    """Remark that a command waits for what the user types,
    if it reads the file `name` from a terminal (`-`).
    """
    if name == "-" and sys.stdin is not None and sys.stdin.isatty():
        note(f"reading {what} from standard input; Ctrl-D ends it")


def fail(what):
    """Report a failure; returns its exit status."""
    _tell(FAILURE, what)
    return getattr(what, "status", 1)


def _tell(kind, what):
    if listener is not None:
        listener(kind, what)


def begin():
    """Another command begins: nothing has been left out yet."""
    _left_out.clear()


def left_out(line):
    """Report, once, how much of an excessive answer was left out; the command ends with status 5 at best."""
    if line not in _left_out:
        _left_out.add(line)
        fail(line)


def is_complete():
    """Whether nothing was left out."""
    return not _left_out


def first(most, items, where, what):
    """The first `most` of a list that a peer has sent; what is left out is reported."""
    if len(items) > most:
        left_out(f"{where}: {len(items) - most} of {len(items)} {what} are left out")
    return items[:most]


class Tally:
    """Results for several objects: failures are reported at once, the exit status sums them up."""

    def __init__(self):
        self.done = 0
        self.statuses = set()
        self.reported = set()

    def add(self, value):
        """Count one result: an errors.Error is reported and counted as failed, anything else as done.
        Returns True if done.
        """
        if isinstance(value, errors.Error):
            if str(value) not in self.reported:  # a name server that is down fails all paths alike
                fail(value)
            self.reported.add(str(value))
            self.statuses.add(value.status)
            return False
        self.done += 1
        return True

    def fail(self, error):
        """Count a failure that has been reported elsewhere."""
        self.statuses.add(error.status)

    def status(self):
        """0 when nothing failed, the failures' own status when all failed alike, else 5."""
        if not self.statuses:
            return 0
        if not self.done and len(self.statuses) == 1:
            return next(iter(self.statuses))
        return errors.Partial.status
