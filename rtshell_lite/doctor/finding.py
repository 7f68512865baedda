"""What an examination finds, each in one line."""

import collections
import re

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.doctor import addresses
from rtshell_lite.text import printable

LEVELS = ("fail", "warn", "ok")
# warnings that are joined, and paths that are named in one line
MANY = 3
SHOWN = 3

HERE = "here"  # in the place of a path: this host and this shell

# `level` is ok, warn or fail; `check` the kind of check; `path` the object, spelt for the terminal, or HERE;
# `remedy` a command that can be pasted, or words, see remedies; '' where nothing is wrong; `cause` HOST:PORT
# of the process whose silence explains it, '' where none is known to.
Finding = collections.namedtuple("Finding", "level check path message remedy cause")


def ok(check, path, message):
    """A Finding that all is well."""
    return Finding("ok", check, path, message, "", "")


def warn(check, path, message, remedy, cause=None):
    """A Finding that may be the trouble; `remedy` is a remedies.Remedy, `cause` (host, port) of a process."""
    return Finding("warn", check, path, message, remedy.text, _process(cause))


def fail(check, path, message, remedy, cause=None):
    """A Finding that something does not work; `remedy` is a remedies.Remedy, `cause` (host, port) of a
    process.
    """
    return Finding("fail", check, path, message, remedy.text, _process(cause))


def _process(endpoint):
    return "" if endpoint is None else f"{printable(endpoint[0])}:{endpoint[1]}"


async def published(ref):
    """The addresses that a reference publishes, decoded from its IOR:
    `192.0.2.1:4000, robot1:4000 (192.0.2.1)`.
    """
    return (
        ", ".join([f"{printable(host)}:{port}" + await meaning_of(host) for host, port in orb.addresses(ref)])
        or "no TCP address"
    )


def sorted_by_level(findings):
    """The Findings, failures first, then warnings, each in their order."""
    return sorted(findings, key=lambda finding: LEVELS.index(finding.level))


def explained(findings):
    """The Findings without those that the silence of a process explains, from MANY on: (Findings, how many
    were left out). The first that fails of each such process stays, and has their number; it comes first.
    """
    causes = collections.OrderedDict()
    for finding in sorted_by_level(findings):
        if finding.cause:
            causes.setdefault(finding.cause, []).append(finding)
    heads = []
    folded = set()
    for effects in causes.values():
        head, *others = effects
        if len(effects) >= MANY and head.level == "fail":
            more = f"; this explains {len(others)} more findings (-v shows them)"
            heads.append(head._replace(message=head.message + more))
            folded.update(map(id, effects))
    rest = [finding for finding in findings if id(finding) not in folded]
    return heads + rest, len(folded) - len(heads)


def grouped(findings):
    """The Findings, failures first, then warnings; warnings that are alike but for numbers, from MANY on, are
    one with their paths.

    Commands are not grouped: each is to be pasted.
    """
    groups = collections.OrderedDict()
    for number, finding in enumerate(sorted_by_level(findings)):
        if finding.level != "warn" or finding.remedy.startswith(("rt", "unset")):
            key = number  # it stays alone
        else:
            key = (finding.check, re.sub("[0-9]+", "0", finding.message))
        groups.setdefault(key, []).append(finding)
    for group in groups.values():
        if len(group) < MANY:
            yield from group
        else:
            yield _joined(group)


def _joined(group):
    first, *others = group
    return first._replace(
        message=f"{first.message}; the same with {listed(finding.path for finding in others)}"
    )


def listed(paths):
    """`a`, `a and b`, `a, b, c and 7 more`."""
    paths = list(paths)
    shown = paths[:SHOWN]
    rest = paths[SHOWN:]
    if rest:
        return f"{', '.join(shown)} and {len(rest)} more"
    if len(shown) < 2:
        return "".join(shown)
    return f"{', '.join(shown[:-1])} and {shown[-1]}"


async def meaning_of(host):
    """What the name of a host means here: ` (192.0.2.1)`, ` (127.0.1.1, this host)`;
    empty for IP addresses and localhost.
    """
    if host == "localhost" or addresses.is_numeric(host):
        return ""
    try:
        numbers = await addresses.resolve(host)
    except errors.Error:
        return ""
    here = ", this host" if any(addresses.is_own(address) for address in numbers) else ""
    return f" ({', '.join(numbers)}{here})"


def reason(e):
    """The reason in an errors.Error, without its object, or in an OSError."""
    return e.why if isinstance(e, errors.Error) else str(e)
