"""What every command shares: how it starts and ends, its exit status, its lines on stderr.

system/reports.py reports many steps or actions, each with its own result.
"""
import _signal  # see start.py
import errno
import io
import os
import sys

from rtshell_lite import errors, interrupts, options, text
from rtshell_lite.corba import lanes

FLUSH_LIMIT = 1.0  # seconds for flushing the output after a signal: its reader may have stopped

# Variables by the names that manuals of rtshell give them, and their real ones
MISNAMED = {"RTCSH_NAMESERVERS": "RTCTREE_NAMESERVERS", "RTSH_CWD": "RTCSH_CWD"}

_quiet = _verbose = False
_left_out = set()  # type: set  # lines already printed by left_out()


# ---- running a command ----------------------------------------------------------------------------------------

def main(arguments, run, doc, argv=None):
    """Run one command and exit: `arguments(parser)` declares its options, `run(args)` does the work and returns the exit status."""
    _prepare_streams()
    try:
        if _signal.getsignal(_signal.SIGINT) != _signal.SIG_IGN:
            _signal.signal(_signal.SIGINT, interrupts.ctrl_c)
        sys.unraisablehook = interrupts.lost  # from Python 3.8 on
        _leave(command(arguments, run, doc, sys.argv[1:] if argv is None else argv))
    except KeyboardInterrupt:
        _leave_soon(130)
    except Ended as e:
        _leave_soon(e.args[0])


class Ended(BaseException):
    """SIGTERM or SIGHUP, raised so that `finally` clauses run; its argument is the exit status."""


def command(arguments, run, doc, argv):
    """Run one command in this process, named by sys.argv[0], and return its exit status. Raises KeyboardInterrupt, Ended."""
    before = _quiet, _verbose, lanes.session
    interrupts.begin()
    try:
        args = options.parser(arguments, doc, os.path.basename(sys.argv[0])).parse_args(argv)
        _settle(args.quiet, args.verbose, lanes.Session(args.timeout))
        for name in MISNAMED.keys() & os.environ.keys():
            del os.environ[name]  # rtsh reports it once
            note(f"{name} is not read; the variable is {MISNAMED[name]}")
        return run(args) or (errors.Partial.status if _left_out else 0)
    except errors.Error as e:
        return complain(e)
    except BrokenPipeError:  # the reader went away: not our error
        return 141
    except OSError as e:
        complain(e)
        return 1
    except ModuleNotFoundError as e:
        return complain(errors.IncompletePython(e.name))
    except SystemExit as e:  # argparse after --help or --version
        return e.code or 0
    except Exception as e:
        if os.environ.get("RTSHELL_DEBUG"):
            import traceback
            traceback.print_exc()
        complain(f"internal error: {type(e).__name__}: {e} (RTSHELL_DEBUG=1 shows where)")
        return 70
    finally:
        _settle(*before)  # the settings of rtsh, if it runs this command


def unwind_when_ended():
    """Let SIGTERM and SIGHUP run `finally` clauses, as Ctrl-C does: the command has put something into a component.

    Only the first counts: a closing terminal and systemd send both.
    """
    for number in (_signal.SIGTERM, _signal.SIGHUP):
        if _signal.getsignal(number) == _signal.SIG_DFL:  # nohup ignores SIGHUP
            _signal.signal(number, lambda number, frame: interrupts.strike(Ended(128 + number), ends=True))


def ignore_hangup():
    """After the terminal is gone: its SIGHUP, which reaches the shell first, must not interrupt the clean-up."""
    _signal.signal(_signal.SIGHUP, lambda *_: None)


def _settle(quiet, verbose, session):
    global _quiet, _verbose
    _quiet, _verbose, lanes.session = quiet, verbose, session
    _left_out.clear()


class _Closed(io.TextIOBase):
    """stdout of a command that was started without one: writing is an error, as it is for cat."""

    buffer = property(lambda self: self)

    def write(self, s):
        raise OSError(errno.EBADF, "cannot write the output: " + os.strerror(errno.EBADF))


def _prepare_streams():
    """UTF-8 whatever the locale; descriptors 0 to 2 open, so that no socket gets their number."""
    fd = _opened_nothing()
    while fd <= 2:
        fd = _opened_nothing()
    os.close(fd)
    if sys.stdout is None:
        sys.stdout = _Closed()
    else:
        sys.stdout = io.TextIOWrapper(sys.stdout.buffer, "utf-8", "backslashreplace", line_buffering=sys.stdout.isatty())
    if sys.stderr is not None:
        sys.stderr = io.TextIOWrapper(sys.stderr.buffer, "utf-8", "backslashreplace", line_buffering=True)


def _opened_nothing():
    try:
        return os.open(os.devnull, os.O_RDWR)
    except OSError:  # a chroot without /dev
        return os.open(os.sep, os.O_RDONLY)


def _leave(status):
    """Exit at once: a thread that waits for a hung peer must not keep the process alive (and the ORB's shutdown takes 6 ms)."""
    os._exit(_flushed(status))


def _leave_soon(status):
    """Exit because of a signal, whether or not anybody reads the rest of the output."""
    with interrupts.held():
        box = interrupts.Mailbox()
        lanes.start(lambda: box.put(_flushed(status)))
        os._exit(box.get(FLUSH_LIMIT) or status)


def _flushed(status):
    try:
        sys.stdout.flush()
    except BrokenPipeError:
        return 141
    except OSError as e:
        return status or complain(e)  # a failed command has reported it
    return status


# ---- talking on stderr ----------------------------------------------------------------------------------------

def complain(what):
    """Print a failure as one line on stderr; returns its exit status."""
    status = getattr(what, "status", 1)
    if isinstance(what, OSError):
        why = what.strerror or str(what)  # a timeout has no strerror
        what = f"{text.printable(str(what.filename))}: {why}" if what.filename else why
    _say(str(what))
    return status


def left_out(line):
    """Report, once, how much of an excessive answer was left out; the command ends with status 5 at best."""
    if line not in _left_out:
        _left_out.add(line)
        complain(line)


def first(most, items, where, what):
    """The first `most` of a list that a peer has sent; what is left out is reported."""
    if len(items) > most:
        left_out(f"{where}: {len(items) - most} of {len(items)} {what} are left out")
    return items[:most]


def note(line):
    """Print a remark that is not a failure on stderr, unless --quiet is given."""
    if not is_quiet():
        _say(line)


def reading(name, what):
    """Say that a command waits for what the user types, if it reads the file `name` from a terminal (`-`)."""
    if name == "-" and sys.stdin is not None and sys.stdin.isatty():
        note(f"reading {what} from standard input; Ctrl-D ends it")


def is_quiet():
    """Whether the user wants to see failures only."""
    return _quiet


def detail(line):
    """Print what was done on stderr, with --verbose only."""
    if _verbose:
        _say(line)


def _say(line):
    say(f"{os.path.basename(sys.argv[0])}: {line}")


def say(line):
    """Print a line on stderr without the command's name before it."""
    try:
        sys.stdout.flush()  # so that `2>&1` keeps the order
    except OSError:
        pass  # the last flush will report it
    if sys.stderr is not None:
        try:
            sys.stderr.write(text.cut(text.safe(line)) + "\n")
        except OSError:
            pass  # nobody is left to read it


class Tally:
    """Results for several objects: failures are reported at once, the exit status sums them up."""

    def __init__(self):
        self.done, self.statuses, self.reported = 0, set(), set()

    def add(self, value):
        """Count one result: an errors.Error is reported and counted as failed, anything else as done. Returns True if done."""
        if isinstance(value, errors.Error):
            if str(value) not in self.reported:  # a name server that is down fails all paths alike
                complain(value)
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
        return self.statuses.pop() if not self.done and len(self.statuses) == 1 else errors.Partial.status


def report(args, results):
    """Report the results of changes, each an errors.Error or a line; returns the exit status.

    A line says what was done, for --verbose; with --dry-run it is the command that would do it, for stdout.
    """
    tally = Tally()
    for result in results:
        if tally.add(result) and result:
            (print if args.dry_run else detail)(result)
    return tally.status()
