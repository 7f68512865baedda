"""What the commands share that stay with ports for a while: their options, and telling which ports fail meanwhile."""
import argparse
import errno
import math
import select
import sys

from rtshell_lite import cli, errors, text


# ---- options --------------------------------------------------------------------------------------------------

def duration(parser, help):
    """-t/--timeout SECONDS as with rtshell: args.duration, infinite where not given or negative.

    How long a peer may stay silent is then said by RTSHELL_TIMEOUT alone.
    """
    parser.add_argument("-t", "--timeout", dest="duration", type=_duration, default=math.inf, metavar="SECONDS", help=help)


def limits(parser, what):
    """-n and -t: args.number, below 0 where not given, and args.duration, infinite where not given."""
    parser.add_argument("-n", "--number", type=int, default=-1, metavar="N", help="end after N %s (default: never)" % what)
    parser.add_argument("-t", dest="duration", type=_duration, default=math.inf, metavar="SECONDS",
                        help="end after so long; status 1 when there were not N %s by then" % what)


def _duration(value):
    try:
        if float(value) < 0:
            return math.inf
    except ValueError:
        pass
    return cli.seconds(value)


def hertz(value):
    """A positive rate in Hz: a type of options."""
    return _positive(value, "a number of Hz above 0")


def factor(value):
    """A positive number: a type of options."""
    return _positive(value, "a number above 0")


def _positive(value, wanted):
    try:
        number = float(value)
    except ValueError:
        number = 0.0
    if not 0 < number < math.inf:
        raise argparse.ArgumentTypeError("not %s: %s" % (wanted, text.printable(value)))
    return number


def types(parser, *path_options):
    """Where data types come from: args.modules, args.python_path, args.idl, args.include; all lists."""
    parser.add_argument("-m", "--mod", action="append", default=[], dest="modules", metavar="MODULE",
                        help="Python module with data types, made by omniidl; may be repeated")
    parser.add_argument(*path_options, action="append", default=[], dest="python_path", metavar="DIR",
                        help="where Python modules are; may be repeated")
    parser.add_argument("--idl", action="append", default=[], metavar="FILE", help="IDL file with data types; may be repeated")
    parser.add_argument("-I", "--include", action="append", default=[], metavar="DIR",
                        help="where #include of IDL files looks; may be repeated")


def properties(parser):
    """--property KEY=VALUE: args.properties, a list of words for `pairs`."""
    parser.add_argument("--property", action="append", default=[], metavar="KEY=VALUE", dest="properties",
                        help="a property of the connection, as with rtcon -p; may be repeated")


def delivery(parser):
    """--linger and --anyway: args.linger, seconds or None, and args.anyway."""
    parser.add_argument("--linger", type=_linger, metavar="SECONDS",
                        help="stay connected at most so long after the last value (default: until the component can have read all)")
    parser.add_argument("--anyway", action="store_true", help="send to a component that is not going to read the values now, too")


def _linger(value):
    return 0.0 if value == "0" else cli.seconds(value)


def pairs(words):
    """KEY=VALUE words as a dict. Raises Usage."""
    for word in words:
        if not word.partition("=")[0] or "=" not in word:
            raise errors.Usage("not KEY=VALUE: %s" % text.printable(word))
    return dict((key, value) for key, _, value in (word.partition("=") for word in words))


# ---- meanwhile ------------------------------------------------------------------------------------------------

class Watcher:
    """Reports on stderr when a connection fails and, after silence, when it goes on; ends us when nobody reads our output."""

    def __init__(self, connections):
        self.connections, self.told = connections, {}
        self.output = select.poll()
        try:
            self.output.register(sys.stdout.fileno(), 0)
        except OSError:
            pass  # there is none

    def look(self):
        """To be called a few times a second. Raises BrokenPipeError."""
        for each in self.connections:
            if each.remark:
                cli.note("%s: %s" % (each.where, each.remark))
                each.remark = None
            before = self.told.get(each)
            if each.failure is not None and str(each.failure) != str(before):
                cli.complain(each.failure)
            elif each.failure is None and before is not None:
                cli.note("%s: answers again" % each.where)
            self.told[each] = each.failure
        if any(events & (select.POLLERR | select.POLLHUP) for _, events in self.output.poll(0)):
            cli.ignore_hangup()
            raise BrokenPipeError(errno.EPIPE, "nobody reads the output")

    def skip(self):
        """What is wrong now has been told otherwise."""
        self.told.update({each: each.failure for each in self.connections if each.failure is not None})

    def count(self, tally, of_no_use=()):
        """Add each connection's failure or success to a Tally; what was told before is not told again.

        Those in `of_no_use` are well, but all that came from them has been counted as failed.
        """
        for each in self.connections:
            tally.told.add(str(self.told.get(each)))
            if each.failure or each not in of_no_use:
                tally.add(each.failure)
