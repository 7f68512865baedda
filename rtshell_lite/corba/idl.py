"""The interfaces and types of OpenRTM's IDL, from the tables that are generated from it (see idl_stubs/generate.py)."""
import functools

from rtshell_lite.corba import descriptors
from rtshell_lite.corba.descriptors import ALIAS, ARRAY, ENUM, OBJECT, SEQUENCE, STRING, UNION, WSTRING
from rtshell_lite.idl_stubs.tables import INTERFACES, MINORS, TYPES  # noqa: F401: iiop/client.py reads MINORS here


def known(type_id):
    """The descriptor of a type by its repository id, or None."""
    return _named(type_id) if type_id in TYPES else None


def descriptor(word):
    """The descriptor of a type as the tables write it."""
    if isinstance(word, str):
        return _named(word)
    if isinstance(word, tuple):
        return (word[0], descriptor(word[1])) + word[2:] if word[0] in (SEQUENCE, ARRAY) else word
    return (word, 0) if word in (STRING, WSTRING) else (OBJECT, "", "Object") if word == OBJECT else word


@functools.lru_cache(maxsize=None)
def _named(type_id):
    if type_id in INTERFACES:
        return (OBJECT, type_id, INTERFACES[type_id][0])
    sort, name, *rest = TYPES[type_id]
    if sort == ALIAS:
        return (ALIAS, type_id, name, descriptor(rest[0]))
    if sort == ENUM:
        return descriptors.enum(type_id, name, rest)
    if sort == UNION:
        switch = descriptor(rest[0])
        return descriptors.union(type_id, name, switch, [
            (descriptors.label(switch, label), member, descriptor(word)) for label, member, word in rest[2:]], rest[1])
    made = descriptors.struct(type_id, name, list(zip(rest[::2], map(descriptor, rest[1::2]))))
    return (sort,) + made[1:]


def ancestry(interface):
    """The repository ids of an interface and of those that it inherits, the nearest first. Raises KeyError."""
    yield interface
    for base in INTERFACES[interface][1]:
        yield from ancestry(base)


@functools.lru_cache(maxsize=None)
def id_of(name):
    """The repository id of an interface or a type by its name in the stubs: component.RTC.PortService, CosNaming.NameComponent."""
    tail = "/" + "/".join(name.split(".")[-2:]) + ":"
    return next(type_id for table in (INTERFACES, TYPES) for type_id in table if tail in "/" + type_id.partition(":")[2])
