"""What an examination finds, each in one line."""
import collections

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.text import printable

HERE = "here"  # in the place of a path: this host and this shell

# `level` is ok, warn or fail; `check` the kind of check; `path` the object, spelt for the terminal, or HERE; `remedy` a command
# that can be pasted, or words, see remedies; '' where nothing is wrong.
Finding = collections.namedtuple("Finding", "level check path message remedy")


def ok(check, path, message):
    """A Finding that all is well."""
    return Finding("ok", check, path, message, "")


def warn(check, path, message, remedy):
    """A Finding that may be the trouble; `remedy` is a remedies.Remedy."""
    return Finding("warn", check, path, message, remedy.text)


def fail(check, path, message, remedy):
    """A Finding that something does not work; `remedy` is a remedies.Remedy."""
    return Finding("fail", check, path, message, remedy.text)


def published(ref):
    """The addresses that a reference publishes, decoded from its IOR: `192.0.2.1:4000, 127.0.0.1:4000`."""
    return ", ".join(f"{printable(host)}:{port}" for host, port in orb.addresses(ref)) or "no TCP address"


def counted(number, noun):
    """`1 port`, `2 ports`."""
    return f"{number} {noun}{'' if number == 1 else 's'}"


def reason(e):
    """The reason in an errors.Error, without its object, or in an OSError."""
    return e.why if isinstance(e, errors.Error) else str(e)
