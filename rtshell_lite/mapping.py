"""--map OLD=NEW: where the components of a profile are now, when they are elsewhere than they were."""
import re

from rtshell_lite import errors, path
from rtshell_lite.text import printable


class Map:
    """OLD=NEW: whole elements of paths and what stands for them here; anywhere, or, with a slash before OLD, at the start.

    Raises Usage for what is no such thing, BadPath.
    """

    def __init__(self, word):
        found = re.match(r"((?:[^=\\]|\\.)+)=(.+)\Z", word, re.DOTALL)
        if not found or not all(side.strip("/") for side in found.groups()):
            raise errors.Usage("not OLD=NEW: %s" % printable(word))
        self.word, self.used = word, False
        old, new = found.groups()
        self.anchored = old.startswith("/")
        self.top, self.names = self._elements(old)
        self.new_top, self.new_names = self._elements(new)

    @staticmethod
    def _elements(word):
        """(server, names) for the start of a path, and names, or None where it cannot stand elsewhere."""
        word = word.strip("/")
        top = path.parse("/" + word)
        if top.port is not None:
            raise errors.Usage("a map knows no ports: %s" % printable(word))
        try:
            below = path.parse("/x/" + word)
        except errors.BadPath:
            below = top  # a server with a port
        return top.object(), below.names if below.port is None and below.server == "x" else None

    def at_start(self, where):
        """How many names behind the server of a Path it replaces; None where it does not fit."""
        count = len(self.top.names)
        same = path.split_address(self.top.server) == path.split_address(where.server)
        return count if same and where.names[:count] == self.top.names else None

    def fits(self, names):
        """True where it replaces the first of these names."""
        return not self.anchored and self.names is not None and self.new_names is not None \
            and names[:len(self.names)] == self.names


def mapped(where, maps):
    """A Path as the Maps have it: each element is replaced once, by the longest that fits."""
    if where.server is None:
        return where
    for each in maps:
        each.used = each.used or each.at_start(where) is not None or any(each.fits(where.names[i:]) for i in range(len(where.names)))
    fitting = [(each.at_start(where), each) for each in maps if each.at_start(where) is not None]
    server, at, names = where.server, 0, ()
    if fitting:
        at, first = max(fitting, key=lambda pair: pair[0])
        server, names = first.new_top.server, first.new_top.names
    while at < len(where.names):
        fitting = [each for each in maps if each.fits(where.names[at:])]
        if not fitting:
            names, at = names + where.names[at:at + 1], at + 1
            continue
        one = max(fitting, key=lambda each: len(each.names))
        names, at = names + one.new_names, at + len(one.names)
    return where._replace(server=server, names=names)
