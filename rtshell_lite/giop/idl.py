"""The interfaces and types of OpenRTM's IDL,
from the tables that are generated from it (see tools/stubs.py).
"""

from rtshell_lite.giop import descriptors
from rtshell_lite.giop.descriptors import ALIAS, ARRAY, ENUM, OBJECT, SEQUENCE, STRING, UNION, WSTRING
from rtshell_lite.idl_stubs.tables import FILES, INTERFACES, MINORS, TYPES  # noqa: F401: others read them
from rtshell_lite.records import cached

MOST_NAMED = 4096  # more than there are


def known(type_id):
    """The descriptor of a type by its repository id, or None."""
    return _named(type_id) if type_id in TYPES else None


def descriptor(word):
    """The descriptor of a type as the tables write it."""
    if isinstance(word, str):
        return _named(word)
    if isinstance(word, tuple):
        if word[0] in (SEQUENCE, ARRAY):
            return (word[0], descriptor(word[1])) + word[2:]
        return word
    if word in (STRING, WSTRING):
        return (word, 0)
    if word == OBJECT:
        return (OBJECT, "", "Object")
    return word


@cached(MOST_NAMED)
def _named(type_id):
    if type_id in INTERFACES:
        return (OBJECT, type_id, name(type_id))
    sort, *rest = TYPES[type_id]
    if sort == ALIAS:
        return (ALIAS, type_id, name(type_id), descriptor(rest[0]))
    if sort == ENUM:
        return descriptors.enum(type_id, name(type_id), rest)
    if sort == UNION:
        switch, default = descriptor(rest[0]), rest[1]
        given = [
            (descriptors.label(switch, label), member, descriptor(word)) for label, member, word in rest[2:]
        ]
        return descriptors.union(type_id, name(type_id), switch, given, default)
    structure = descriptors.struct(type_id, name(type_id), list(zip(rest[::2], map(descriptor, rest[1::2]))))
    return (sort,) + structure[1:]


def name(type_id):
    """The name of a type or an interface in its module."""
    return type_id.rpartition("/")[2].partition(":")[0]


def ancestry(interface):
    """The repository ids of an interface and of those that it inherits, the nearest first.
    Raises KeyError.
    """
    yield interface
    for base in INTERFACES[interface][0]:
        yield from ancestry(base)


def operation(interface, name):
    """(types of its arguments, types of its results or None for oneway, ids of its exceptions) of an
    operation of an interface, or of one of those that it inherits, as the tables have them. Raises KeyError.
    """
    for type_id in ancestry(interface):
        own = INTERFACES[type_id][1]
        if name in own:
            return own[name][:3]
    raise KeyError(name)


@cached(MOST_NAMED)
def id_of(name):
    """The repository id of an interface or a type by its name: RTC.PortService, CosNaming.NameComponent."""
    tail = "/" + name.replace(".", "/") + ":"
    ids = (*INTERFACES, *TYPES)
    return next(type_id for type_id in ids if tail in "/" + type_id.partition(":")[2])


@cached(MOST_NAMED)
def struct(name):
    """The class of a struct by its name (RTC.ConnectorProfile), called with its members."""
    return descriptors.factory(_named(id_of(name)))


def items(name):
    """The items of an enum by its name (OpenRTM.PortStatus), in their order:
    each with a name `_n` and a number `_v`.
    """
    return descriptors.items(_named(id_of(name)))


def enumerator(name, word):
    """The item of an enum (OpenRTM.PortStatus) that is called so (PORT_OK)."""
    return next(item for item in items(name) if item._n == word)
