"""--map OLD=NEW: where the components of a profile are now, when they are elsewhere than they were."""

import re

from rtshell_lite import errors, path
from rtshell_lite.robot import composites
from rtshell_lite.system import capture
from rtshell_lite.text import printable
from rtshell_lite.xmlprofile import model

PATHS = (capture.PATH_ID, capture.MANAGER)  # extended properties that hold a path
# parameters of composites that list names of instances and of their ports
LISTS = ("members", composites.EXPORTED)
_WORD = re.compile(r"[^,\s](?:[^,]*[^,\s])?")  # in such a list
TARGETS = (model.TargetComponent, model.TargetPort, model.TargetExecutionContext)


def read(name, form=None, words=()):
    """The profile in a file (`-`: stdin), its components where the `words` OLD=NEW have them.

    Raises Usage for a word that is not OLD=NEW or fits nothing in the file, OSError, BadPath, BadProfile.
    """
    maps = [Map(word) for word in words]
    profile = capture.read(name, form)
    if maps:
        move(profile, maps)
    refuse_unused(maps)
    return profile


def refuse_unused(maps):
    """Raise Usage for a Map that has fitted nothing."""
    for mapping in maps:
        if not mapping.used:
            raise errors.Usage(f"--map {printable(mapping.word)}: nothing in the file is there")


def move(profile, maps):
    """Change paths, and the names of instances that are bound under another name now,
    wherever the profile has them. Raises Failed where that is not clear.
    """
    locate = capture.locator(profile)
    targets = [(element, locate(element)) for element in _elements(profile) if isinstance(element, TARGETS)]
    members = {
        id(component): [locate(participant.component) for participant in component.participants]
        for component in profile.components
    }
    before = [component.path_uri for component in profile.components]
    names = _move_components(profile.components, maps)
    for component, path_uri in zip(profile.components, before):
        if component.path_uri != path_uri:  # another object
            component.properties = [item for item in component.properties if item.name != capture.REFERENCE]
    _refuse_unclear(targets, profile.components, names)
    within = {
        key: dict(names[id(member)] for member in some if member is not None) for key, some in members.items()
    }
    for component in profile.components:
        elements = [component] + component.data_ports + component.service_ports
        _rename(elements, names[id(component)], within[id(component)])
        if within[id(component)]:
            _rename_lists(component, within[id(component)])
    for target, component in targets:
        if component is not None:
            _rename([target], names[id(component)], within[id(component)])
    for element in _elements(profile):
        if isinstance(element, model.Property) and element.name in PATHS and element.value:
            element.value = _moved(element.value, maps)


def _move_components(components, maps):
    """Change their paths; returns {id of a component: the names of its instance, before and now}.
    Raises Failed: two at one place.
    """
    names = {}
    taken = {}
    for component in components:
        before = path_in(component.path_uri)
        component.path_uri = _moved(component.path_uri, maps)
        now = path_in(component.path_uri)
        if now.names and taken.setdefault(now, before) != before:
            raise errors.Failed(str(now), "the file has two components here")
        last = component.instance_name
        if before.names and now.names and before.names[-1].id == last:
            last = now.names[-1].id
        names[id(component)] = component.instance_name, last
    return names


def _refuse_unclear(targets, components, names):
    """Raise Failed for a target that may mean several components of which only some have been renamed."""
    called = {}  # what a target says of a component: the names that those have now
    for component in components:
        key = component.id, component.instance_name
        called.setdefault(key, set()).add(names[id(component)][1])
    for target, _ in targets:
        key = target.component_id, target.instance_name
        if not target.property(capture.PATH_ID) and len(called.get(key, ())) > 1:
            decides = f"the property {capture.PATH_ID} decides which is meant"
            why = f"there are several, of which --map renames some ({decides})"
            raise errors.Failed(f"{printable(key[1])} ({printable(key[0])})", why)


def _elements(element):
    """An element of a profile and all below it."""
    yield element
    for field in element.FIELDS:
        value = getattr(element, field.name)
        for child in value if isinstance(value, list) else [value]:
            if isinstance(child, model.Element):
                yield from _elements(child)


def _rename(elements, own, within):
    """Elements that have the name of an instance, or ports that begin with it: `own` is that name, before and
    now.

    `within` {before: now} are the names of a composite's members, with which the ports begin that it exports.
    """
    old, new = own
    for element in elements:
        if getattr(element, "instance_name", None) == old:
            element.instance_name = new
        for field in ("name", "port_name"):
            port = getattr(element, field, None)
            if port is None:
                continue
            if port.startswith(old + "."):
                rest = _renamed(port[len(old) + 1 :], within)
                setattr(element, field, new + "." + rest)
            else:
                setattr(element, field, _renamed(port, within))


def _rename_lists(composite, within):
    """Rename members in the configuration of a composite:
    with their former names it would lose the ports that it exports.
    """
    for one_set in composite.configuration_sets:
        for item in one_set.configuration_data:
            if item.name in LISTS and item.data:
                item.data = _WORD.sub(lambda match: _renamed(match.group(), within), item.data)


def _renamed(word, names):
    """The name of an instance, or of its port INSTANCE.port, with the name that `names` {before:
    now} have for it.
    """
    # names and ports may have dots
    for name, dot, rest in ((word, "", ""), word.partition("."), word.rpartition(".")):
        if name and name in names:
            return names[name] + dot + rest
    return word


def _moved(text, maps):
    """A path in a profile (without the first slash) after the Maps;
    text that is not a path stays as it is.
    """
    where = path_in(text)
    if where.server is None or text.startswith("corbaloc:"):
        return text
    now = mapped(where, maps)
    return text if now == where else str(now).lstrip("/")


def path_in(text):
    """The Path that a text in a profile (without the first slash) means;
    the root for text that is not a path.
    """
    try:
        return path.parse("/" + text.lstrip("/"))
    except errors.BadPath:
        return path.ROOT


class Map:
    """OLD=NEW: whole elements of paths and what replaces them; anywhere, or, with a slash before OLD, at the
    start.

    Raises Usage for a word that is not OLD=NEW, BadPath.
    """

    def __init__(self, word):
        match = re.match(r"((?:[^=\\]|\\.)+)=(.+)\Z", word, re.DOTALL)
        if not match or not all(side.strip("/") for side in match.groups()):
            raise errors.Usage(f"not OLD=NEW: {printable(word)}")
        self.word = word
        self.used = False
        old, new = match.groups()
        self.anchored = old.startswith("/")
        self.top, self.names = self._elements(old)
        self.new_top, self.new_names = self._elements(new)

    @staticmethod
    def _elements(word):
        """The Path of a word as the start of a path, and its names as the rest of one,
        None where it can only be the start.
        """
        word = word.strip("/")
        top = path.parse("/" + word)
        if top.server is None:
            raise errors.Usage(f"--map does not accept . or ..: {printable(word)}")
        if top.port is not None:
            raise errors.Usage(f"--map does not accept ports: {printable(word)}")
        try:
            below = path.parse("/x/" + word)
        except errors.BadPath:
            below = top  # a server with a port
        if below.port is None and below.server == "x":
            return top.object(), below.names
        return top.object(), None

    def at_start(self, where):
        """How many names after the server of a Path it replaces; None if it does not fit there."""
        count = len(self.top.names)
        same = path.split_address(self.top.server) == path.split_address(where.server)
        return count if same and where.names[:count] == self.top.names else None

    def fits(self, names):
        """True if it replaces the first of these names."""
        if self.anchored or self.names is None or self.new_names is None:
            return False
        return names[: len(self.names)] == self.names


def mapped(where, maps):
    """A Path after the Maps: each element is replaced once, by the longest Map that fits."""
    if where.server is None:
        return where
    tails = [where.names[index:] for index in range(len(where.names))]
    for map in maps:
        if map.at_start(where) is not None or any(map.fits(tail) for tail in tails):
            map.used = True
    fitting = [(map.at_start(where), map) for map in maps if map.at_start(where) is not None]
    server = where.server
    index = 0
    names = ()
    if fitting:
        index, first = max(fitting, key=lambda pair: pair[0])
        server = first.new_top.server
        names = first.new_top.names
    while index < len(where.names):
        fitting = [map for map in maps if map.fits(where.names[index:])]
        if not fitting:
            names = names + where.names[index : index + 1]
            index = index + 1
            continue
        longest = max(fitting, key=lambda map: len(map.names))
        names = names + longest.new_names
        index = index + len(longest.names)
    return where._replace(server=server, names=names)
