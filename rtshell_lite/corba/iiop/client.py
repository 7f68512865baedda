"""Our own ORB, as orb.py needs it: references, and values as texts;
peers.py makes the calls, server.py has servants.
"""

import sys

from rtshell_lite import errors
from rtshell_lite.giop import descriptors, idl, ior, references
from rtshell_lite.corba.iiop.peers import invoke, repeated  # noqa: F401: orb.py calls them
from rtshell_lite.path import split_address
from rtshell_lite.text import from_wire, to_wire

HEEDED = ("endPoint", "endPointPublish")  # settings of omniORB
ANSWERS_AT_ONCE = True  # see orb.answers_at_once
_STRUCTURES = (descriptors.STRUCT, descriptors.UNION, descriptors.EXCEPTION)
_MINORS = {"": 2, "1.0": 0, "1.1": 1, "1.2": 2}  # of GIOP, by the version in a corbaloc


def start():
    """Nothing has to be started."""


def version():
    """What `rtdoctor` calls it."""
    return "builtin ORB"


# ---- references ----


def from_url(where, url):
    """The reference of a corbaloc; contacts nobody. Raises BadPath."""
    corbaloc, protocol, rest = (url.split(":", 2) + ["", ""])[:3]
    address, slash, key = rest.partition("/")
    version, _, address = address.rpartition("@")
    host, port = split_address(address)
    is_of_iiop = corbaloc == "corbaloc" and protocol in ("", "iiop") and version in _MINORS
    if not is_of_iiop or not slash or port is None:
        raise errors.BadPath(where, "not an address (the builtin ORB speaks IIOP only)")
    key = key.encode("utf-8", "surrogateescape")
    if b"%" in key:
        import re

        key = re.sub(b"%([0-9a-fA-F]{2})", lambda octet: bytes.fromhex(octet.group(1).decode()), key)
    return references.make_reference(host.strip("[]"), port, key, _MINORS[version])


def from_text(where, text):
    """The reference in a stringified IOR that a peer has sent.
    Raises Unreachable where the text is no reference.
    """
    try:
        return references.from_text(ior.checked(text))
    except ValueError as e:
        raise errors.Unreachable(where, str(e))


def to_text(ref):
    """The stringified IOR of a reference."""
    return ref.text()


def address(ref):
    """What a reference says, an ior.Address."""
    return ref.address


def narrow(ref, interface):
    """`ref` as a reference of an interface by its name, on trust."""
    type_id = idl.id_of(interface)
    return ref if ref.interface == type_id else ref.narrowed(type_id)


def same(ref, other):
    """True if two references denote one object, as far as can be known without a remote call."""
    return ref.profiles == other.profiles or bool(ref.address.host) and ref.address[1:] == other.address[1:]


# ---- servants ----


def serve(servant):
    """Let others call a servant: the stringified reference to it, and a function that ends that.
    Raises Usage.
    """
    from rtshell_lite.corba.iiop import server

    reference, withdraw = server.serve(servant)
    return reference.text(), withdraw


# ---- values ----


def properties(nvlist, only=None):
    """An SDOPackage::NVList as a list of (name, value) texts in its order; other values are converted to
    text.

    `only`: those of this name.
    """
    only = only and only.encode()
    pairs = []
    for name, value in nvlist:
        if only and name != only:
            continue
        text = _text(value) if type(value) is bytes else _as_text(value.content, value.descriptor)
        pairs.append((sys.intern(_text(name)), text))
    return pairs


def _text(octets):
    return octets.decode("utf-8", "surrogateescape")


def _as_text(value, descriptor):
    if type(value) is str:
        return from_wire(value)
    kind = descriptors.kind(descriptors.plain(descriptor))
    if kind in _STRUCTURES:
        return f"<{from_wire(descriptors.type_id(descriptor))}>"
    if kind == descriptors.OBJECT:
        return "" if value is None else value.text()
    if any(descriptors.kind(inner) in _STRUCTURES for _, inner in descriptors.walk(descriptor, "")):
        # their texts may be a thousand times as long as they, or without end
        return f"<{from_wire(descriptors.words(descriptor))}>"
    return "" if value is None else str(value)


descriptor = idl.known


def descriptor_in(nvlist, name):
    """The descriptor of the type of the value with this name in an SDOPackage::NVList, or None."""
    others = [value for key, value in nvlist if key == name.encode() and type(value) is not bytes]
    return others[0].descriptor if others else None


def nvlist(pairs):
    """(name, value) texts as an SDOPackage::NVList of strings."""
    return [(to_wire(name).encode("latin-1"), to_wire(value).encode("latin-1")) for name, value in pairs]
