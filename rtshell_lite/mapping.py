"""--map OLD=NEW: where the components of a profile are now, when they are elsewhere than they were."""
import re

from rtshell_lite import errors, path, system
from rtshell_lite.text import printable
from rtshell_lite.xmlprofile import model

MANAGER = "MANAGER"  # an extended property of a component: path of the manager that can create it
PATHS = (system.PATH_ID, MANAGER)  # extended properties that hold a path
TARGETS = (model.TargetComponent, model.TargetPort, model.TargetExecutionContext)


def read(name, form=None, words=()):
    """The profile in a file (`-`: stdin), its components where the `words` OLD=NEW have them.

    Raises Usage for what is no such word, or fits nothing in the file, OSError, BadPath, BadProfile.
    """
    maps = [Map(word) for word in words]
    profile = system.read(name, form)
    if maps:
        _move(profile, maps)
    for each in maps:
        if not each.used:
            raise errors.Usage("--map %s: nothing in the file is there" % printable(each.word))
    return profile


def _move(profile, maps):
    """Change paths, and the names of instances that are bound under another name now, wherever the profile has them."""
    locate = system.locator(profile)
    renamed = {}  # id of a component: the names of its instance, before and now
    targets = [(each, locate(each)) for each in _elements(profile) if isinstance(each, TARGETS)]
    for each in profile.components:
        before, each.path_uri = path_in(each.path_uri), _moved(each.path_uri, maps)
        now = path_in(each.path_uri)
        if before.names and now.names and now.names[-1] != before.names[-1] and before.names[-1].id == each.instance_name:
            renamed[id(each)] = (each.instance_name, now.names[-1].id)
            _rename([each] + each.data_ports + each.service_ports, *renamed[id(each)])
    for target, component in targets:
        if id(component) in renamed:
            _rename([target], *renamed[id(component)])
    for each in _elements(profile):
        if isinstance(each, model.Property) and each.name in PATHS and each.value:
            each.value = _moved(each.value, maps)


def _elements(element):
    """An element of a profile and all below it."""
    yield element
    for field in element.FIELDS:
        value = getattr(element, field.name)
        for each in value if isinstance(value, list) else [value]:
            if isinstance(each, model.Element):
                yield from _elements(each)


def _rename(elements, old, new):
    """Elements that have the name of an instance, or ports that begin with it."""
    for each in elements:
        if getattr(each, "instance_name", None) == old:
            each.instance_name = new
        for field in ("name", "port_name"):
            port = getattr(each, field, None)
            if port is not None and port.startswith(old + "."):
                setattr(each, field, new + port[len(old):])


def _moved(text, maps):
    """A path of a profile, without the first slash as they are there, as the Maps have it; what is no path stays."""
    where = path_in(text)
    if where.server is None or text.startswith("corbaloc:"):
        return text
    now = mapped(where, maps)
    return text if now == where else str(now)[1:]


def path_in(text):
    """The Path that a text of a profile stands for, which has no slash in front there; the root where it is none."""
    try:
        return path.parse("/" + text.lstrip("/"))
    except errors.BadPath:
        return path.ROOT


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
