"""What every command shares: how it starts and ends, its exit status, its lines on stderr.

Libraries print nothing: what they remark (notes.py) is printed here.
"""

import errno
import io
import os
import sys
from _thread import allocate_lock

from rtshell_lite import errors, notes, options, text
from rtshell_lite.corba.session import Session
from rtshell_lite.net import loop, real
from rtshell_lite.notes import Tally  # noqa: F401: commands use it as cli.Tally

FLUSH_LIMIT = 1.0  # seconds for flushing the output after a signal: its reader may have stopped

# Variables by the names that manuals of rtshell give them, and their real ones
MISNAMED = {"RTCSH_NAMESERVERS": "RTCTREE_NAMESERVERS", "RTSH_CWD": "RTCSH_CWD"}

STRUCK = 70  # statuses from here on: an internal error, or a signal, is not hidden by what comes after it

_quiet = _verbose = False
_reported = set()  # type: set  # OSErrors in words, as stdout fails again at the end
_lines = None  # the progress.Lines of a command that does long work


# ---- running a command ----


def main(arguments, run, doc, argv=None):
    """Run one command and exit: `arguments(parser)` declares its options, `run(args)` does the work and
    returns the exit status.

    `run` is a coroutine function where it asks peers: then Ctrl-C, SIGTERM and SIGHUP arrive at what it
    awaits.
    """
    _prepare_streams()
    notes.listener = _hear
    notes.on_work = _show_work
    try:
        if real.handler(real.SIGINT) != real.IGNORED:
            real.handle(real.SIGINT, real.interrupt)
        _leave(command(arguments, run, doc, sys.argv[1:] if argv is None else argv))
    except KeyboardInterrupt:
        _leave_soon(130)
    except Ended as e:
        _leave_soon(e.args[0])


def installed(name):
    """Run a command of an installation and exit."""
    module = getattr(__import__("rtshell_lite.commands." + name).commands, name)
    main(module.arguments, module.run, module.__doc__)


class Ended(BaseException):
    """SIGTERM or SIGHUP, raised so that `finally` clauses run; its argument is the exit status."""


def command(arguments, run, doc, argv, memory=None):
    """Run one command in this process, named by sys.argv[0], and return its exit status. `memory`: the Memory
    that it shares with others. Raises KeyboardInterrupt, Ended.
    """
    before = _quiet, _verbose
    try:
        args = options.parser(arguments, doc, os.path.basename(sys.argv[0])).parse_args(argv)
        _settle(args.quiet, args.verbose)
        for name in MISNAMED.keys() & os.environ.keys():
            del os.environ[name]  # rtsh reports it once
            note(f"{name} is not read; the variable is {MISNAMED[name]}")
        status = run(args)
        if hasattr(status, "send"):
            status = loop.run(status, SIGNALS, Session(args.timeout, memory))
        if status or notes.is_complete():
            return status or 0
        return errors.Partial.status
    except errors.Error as e:
        return complain(e)
    except BrokenPipeError:  # the reader went away: not our error
        return 141
    except OSError as e:
        complain(e)
        return 1
    except ModuleNotFoundError as e:
        if (e.name or "").startswith(("xml", "pyexpat")):
            return complain(errors.NoXml(e.name))
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


SIGNALS = {  # type: dict
    real.SIGINT: KeyboardInterrupt,
    real.SIGTERM: lambda: Ended(128 + real.SIGTERM),
}
if real.SIGHUP is not None:
    SIGNALS[real.SIGHUP] = lambda: Ended(128 + real.SIGHUP)


def unwind_when_ended():
    """Let SIGTERM and SIGHUP run the `finally` clauses of plain code, as Ctrl-C does. Within loop.run they do
    without this.

    Only the first counts: a closing terminal and systemd send both.
    """

    def end(number, frame):
        for other in SIGNALS.keys() - {real.SIGINT}:
            world.handle(other, real.IGNORED)
        raise SIGNALS[number]()

    world = loop.world()
    for number in SIGNALS.keys() - {real.SIGINT}:
        if world.handler(number) == real.DEFAULT:  # nohup ignores SIGHUP
            world.handle(number, end)


def _settle(quiet, verbose):
    global _quiet, _verbose, _lines
    _lines = None
    _quiet = quiet
    _verbose = verbose
    notes.begin()


class _Closed(io.TextIOBase):
    """stdout of a command that was started without one: writing is an error, as it is for cat."""

    buffer = property(lambda self: self)

    def write(self, s):
        self.fileno()

    def fileno(self):
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
        sys.stdout = io.TextIOWrapper(
            sys.stdout.buffer, "utf-8", "backslashreplace", line_buffering=sys.stdout.isatty()
        )
    if sys.stderr is not None:
        sys.stderr = io.TextIOWrapper(sys.stderr.buffer, "utf-8", "backslashreplace", line_buffering=True)


def _opened_nothing():
    try:
        return os.open(os.devnull, os.O_RDWR)
    except OSError:  # a chroot without /dev
        return os.open(os.sep, os.O_RDONLY)


def _leave(status):
    """Exit at once: a thread that waits for a hung peer must not keep the process alive (and the ORB's
    shutdown takes 6 ms).
    """
    os._exit(_flushed(status))


def _leave_soon(status):
    """Exit because of a signal, whether or not anybody reads the rest of the output."""
    for number in SIGNALS:
        real.handle(number, real.IGNORED)
    done = allocate_lock()
    done.acquire()
    statuses = []

    def flush():
        statuses.append(_flushed(status))
        done.release()

    loop.world().start_thread(flush)
    done.acquire(timeout=FLUSH_LIMIT)
    os._exit(statuses[0] if statuses else status)


def _flushed(status):
    try:
        sys.stdout.flush()
    except BrokenPipeError:
        return status if status >= STRUCK else 141
    except OSError as e:
        if _shown(e) in _reported:  # by a command that failed for it
            return status or 1
        said = complain(e)
        return status if status >= STRUCK else said
    return status


# ---- output that others must not wait for ----


async def write(output):
    """Print a text while other tasks go on: its reader may be slow, or have stopped."""
    await loop.on_thread(write_here, output)


def write_here(output):
    """Print a text on a thread of its own:
    past sys.stdout, as the lock of its buffer must not be held when the command ends.
    """
    fd = sys.stdout.fileno()
    rest = memoryview(output.encode("utf-8", "backslashreplace"))
    while rest:
        rest = rest[os.write(fd, rest) :]


async def reader_leaves():
    """Raise BrokenPipeError as soon as nobody reads the output: for loop.background."""
    try:
        output = sys.stdout.fileno()
    except OSError:  # no such descriptor
        return
    await loop.ready(output, 0)
    if real.SIGHUP is not None:
        # that of a closed terminal would interrupt the clean-up
        loop.world().handle(real.SIGHUP, lambda *_: None)
    raise BrokenPipeError(errno.EPIPE, "nobody reads the output")


# ---- talking on stderr ----


def complain(what):
    """Print a failure as one line on stderr; returns its exit status."""
    line = str(what)
    if isinstance(what, OSError):
        line = _shown(what)
        _reported.add(line)
    _say(line)
    return getattr(what, "status", 1)


def _shown(error):
    """An OSError in words."""
    why = error.strerror or str(error)  # a timeout has no strerror
    return f"{text.printable(str(error.filename))}: {why}" if error.filename else why


def note(line):
    """Print a remark that is not a failure on stderr, unless --quiet is given."""
    if not _quiet:
        _say(line)


def detail(line):
    """Print what was done on stderr, with --verbose only; a command may have newlines in its quotes."""
    if not _verbose:
        return
    first, *others = line.split("\n")
    _say(first)
    for other in others:
        say(other)


def _say(line):
    say(f"{os.path.basename(sys.argv[0])}: {line}")


def say(line):
    """Print a line on stderr without the command's name before it."""
    try:
        sys.stdout.flush()  # so that `2>&1` keeps the order
    except OSError:
        pass  # the last flush will report it
    if _lines is not None:
        _lines.erase()
    if sys.stderr is not None:
        try:
            sys.stderr.write(text.cut(text.safe(line)) + "\n")
        except OSError:
            pass  # nobody is left to read it


def _hear(kind, what):
    """The listener of notes.py."""
    _PRINTERS[kind](what)


def _progress(line):
    if not _quiet:
        say(line)


def _show_work(work):
    """Show on a terminal how far a notes.Work is."""
    global _lines
    if _lines is None:
        if _quiet or not (sys.stderr and sys.stderr.isatty()):
            return
        from rtshell_lite import progress

        _lines = progress.Lines(os.path.basename(sys.argv[0]))
    _lines.take(work)


def _failed_action(error):
    say(f"Action failed: {error}")


_PRINTERS = {
    notes.NOTE: note,
    notes.DETAIL: detail,
    notes.PROGRESS: _progress,
    notes.FAILED_ACTION: _failed_action,
    notes.FAILURE: complain,
}


def report(args, results, shown=False):
    """Report the results of changes, each an errors.Error or a line; returns the exit status.

    A line says what was done, for --verbose, or for stdout if it is to be `shown`; with --dry-run it is the
    command that would do it, for stdout.
    """
    tally = Tally()
    for result in results:
        if tally.add(result) and result:
            if args.dry_run or shown:
                print(result)
            else:
                detail(result)
    return tally.status()
