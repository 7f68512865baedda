"""Data ports as rtprint, rtinject and rtlog name them: PATH:PORT[.NAME][#FORMATTER]."""

import collections
import re

from rtshell_lite import errors, path as paths
from rtshell_lite.robot import lookup, ports, tree
from rtshell_lite.text import printable

# A port as typed, `word`: NAME is still part of the port in `path`; `label` is printable.
Target = collections.namedtuple("Target", "word path formatter label")
# The Port, and the NAME given or None.
NamedPort = collections.namedtuple("NamedPort", "port name formatter label")


def parse(words, formatters=False):
    """A list of Target for what the user typed; nothing is contacted. Raises BadPath."""
    targets = []
    for word in words:
        formatter = re.search(r"(?<!\\)#([\w.]+)\Z", word) if formatters else None
        text = word[: formatter.start()] if formatter else word
        path = paths.parse(text)
        targets.append(Target(text, path, formatter and formatter.group(1), printable(text)))
    return targets


async def find(targets, kind):
    """A NamedPort, or an errors.Error, for each Target, in parallel. Raises what `need_ports` raises.

    A port's name may contain a dot, and NAME follows a dot: the longer port name is tried first.
    """
    meant = await lookup.paths([target.word for target in targets])
    await need_ports(meant, kind)
    targets = [target._replace(path=path) for target, path in zip(targets, meant)]
    listed = await tree.on_components([target.path.object() for target in targets], ports.ports)
    return [
        answer if isinstance(answer, errors.Error) else _named(target, answer)
        for target, answer in zip(targets, listed)
    ]


async def need_ports(meant, kind):
    """Raise Usage for a component without a port, which lists those of the `kind` (DataInPort or
    DataOutPort); what prevents asking, if it cannot be asked.
    """
    for path in meant:
        if path.port is None:
            (listed,) = await tree.on_components([path], ports.ports)
            if isinstance(listed, errors.Error):
                raise listed
            there = [
                ports.label(port) for port in listed if isinstance(port, ports.Port) and port.type == kind
            ]
            has = ports.choices("it has", there or [f"no {kind}"])
            raise errors.Usage(f"{path!s}: no port specified{has}")


def _named(target, listed):
    port = ports.named(target.path, listed)
    name = None
    if isinstance(port, errors.Error):
        shorter, dot, rest = target.path.port.rpartition(".")
        if dot and re.match(r"\w+\Z", rest):
            port = ports.named(target.path.with_port(shorter), listed)
            name = rest
    if isinstance(port, errors.Error):
        return ports.named(target.path, listed)
    return NamedPort(port, name, target.formatter, name or target.label)
