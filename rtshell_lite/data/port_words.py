"""Data ports as rtprint, rtinject and rtlog name them: PATH:PORT[.NAME][#FORMATTER]."""
import collections
import re

from rtshell_lite import errors, path as paths
from rtshell_lite.robot import ports, tree
from rtshell_lite.text import printable

# `path` as parsed, NAME included in its port; `name` None where no NAME can be; `label` says which port it is, printable.
Target = collections.namedtuple("Target", "path formatter label")
# `name` is the NAME given, or None.
Found = collections.namedtuple("Found", "port name formatter label")


def parse(words, formatters=False):
    """What the user typed as a list of Target, before anything is contacted. Raises Usage, BadPath."""
    targets = []
    for word in words:
        formatter = re.search(r"(?<!\\)#([\w.]+)\Z", word) if formatters else None
        text = word[:formatter.start()] if formatter else word
        path = paths.parse(text)
        if path.port is None:
            raise errors.Usage(f"{path!s}: no port specified")
        targets.append(Target(path, formatter and formatter.group(1), printable(text)))
    return targets


def find(targets):
    """A Found for each Target, in parallel; an errors.Error in the place of what failed.

    A port may have a dot in its name, and NAME follows a dot: the longer port name is tried first.
    """
    listed = tree.on_components([target.path.object() for target in targets], ports.ports)
    return [there if isinstance(there, errors.Error) else _named(target, there) for target, there in zip(targets, listed)]


def _named(target, there):
    found = ports.named(target.path, there)
    name = None
    if isinstance(found, errors.Error):
        shorter, dot, rest = target.path.port.rpartition(".")
        if dot and re.match(r"\w+\Z", rest):
            found, name = ports.named(target.path.with_port(shorter), there), rest
    if isinstance(found, errors.Error):
        return ports.named(target.path, there)
    return Found(found, name, target.formatter, name or target.label)
