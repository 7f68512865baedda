"""What an examination finds: one line each."""
import collections

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.text import printable

HERE = "here"  # takes the place of a path for what concerns this host and this shell

# `level` is ok, warn or fail; `check` what kind of check found it; `path` the object, spelt for the terminal, or HERE;
# `message` what is the case; `remedy` a command that can be pasted, or words, see remedies; '' where nothing is wrong.
Finding = collections.namedtuple("Finding", "level check path message remedy")


def ok(check, path, message):
    """A Finding that all is well."""
    return Finding("ok", check, path, message, "")


def warn(check, path, message, remedy):
    """A Finding that may or may not be the trouble; `remedy` is a remedies.Remedy."""
    return Finding("warn", check, path, message, remedy.text)


def fail(check, path, message, remedy):
    """A Finding that something does not work; `remedy` is a remedies.Remedy."""
    return Finding("fail", check, path, message, remedy.text)


def published(ref):
    """The addresses that a reference publishes, decoded from its IOR: `192.0.2.1:4000, 127.0.0.1:4000`."""
    return ", ".join("%s:%d" % (printable(host), port) for host, port in orb.addresses(ref)) or "no TCP address"


def counted(number, noun):
    """`1 port`, `2 ports`."""
    return "%d %s%s" % (number, noun, "" if number == 1 else "s")


def reason(e):
    """Why something failed: what an errors.Error says of its object, or an OSError."""
    return e.why if isinstance(e, errors.Error) else str(e)
