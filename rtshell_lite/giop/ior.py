"""Object references as octets: their addresses, and whether they can be trusted, before omniORB makes objects
of them.

omniORBpy ends the whole process (SIGSEGV) on a reference whose repository id is not UTF-8. So answers of
peers are read with descriptors (see descriptors.py) in which a reference is what it is on the wire, a struct
of octets (CORBA 3.0, 13.6.2):

    struct Reference { sequence<octet> type_id; sequence<struct { unsigned long tag; sequence<octet> data; }>
    profiles; };

omniORBpy still reads references and TypeCodes inside an `any`, whose types only the peer knows.
"""

import struct
import sys

from rtshell_lite.giop import descriptors
from rtshell_lite.records import cached, item

IIOP = 0  # the tag of a profile, TAG_INTERNET_IOP
ALTERNATE = 3  # the tag of a component of a profile, TAG_ALTERNATE_IIOP_ADDRESS (CORBA 3.0, 13.6.6.8)
# Other transports by the tag of such a component: TAG_SSL_SEC_TRANS and TAG_CSI_SEC_MECH_LIST (CORBA 3.0,
# 13.6.7), TAG_OMNIORB_UNIX_TRANS (IOP.h of omniORB 4.2). The IIOP profile has port 0 if there is no other.
TRANSPORTS = {20: "TLS", 33: "TLS", 0x41545402: "UNIX sockets"}
OTHER = "another transport"
MOST_PROFILES = 64  # real references have one to three, for each address of the host at most one
LARGEST = 1 << 14  # octets of a reference; real ones have less than 1,000
LONGEST_TYPE = 1024  # octets of a repository id


class Address(tuple):
    """What an IOR says: text, text, int, bytes."""

    __slots__ = ()
    type_id, host, port, key = [item(index) for index in range(4)]


class BadReference(ValueError):
    """A reference that must not be used; why is its text."""


# ---- what a reference says ----


@cached(1024)
def address(text):
    """What a stringified IOR says, an Address; without an IIOP profile, host is '' and port 0."""
    try:
        return parsed(*parts(text))
    except (IndexError, struct.error):
        return Address(("", "", 0, b""))


def parts(text):
    """(type id, ((tag, octets), …) of its profiles) of a stringified IOR, all octets.
    Raises IndexError, struct.error.
    """
    reader = _Cdr(_unhexed(text))
    type_id = reader.octets()[:-1]
    return type_id, tuple((reader.ulong(), reader.octets()) for _ in range(reader.ulong()))


def parsed(type_id, profiles):
    """What a reference says, given as its parts."""
    type_id = sys.intern(type_id.decode("latin-1"))  # one text for all 20,000
    without_tcp = None
    try:
        for tag, profile in profiles:
            if tag == IIOP:
                ulong, ushort = _LITTLE if profile[0] & 1 else _BIG
                end = 8 + ulong(profile, 4)[0]  # of the host, after the version
                if end > len(profile):  # no place for unpack on a 32-bit system
                    raise IndexError
                offset = (end + 3 & ~1) + 3 & ~3  # after the port
                size = ulong(profile, offset)[0]
                if offset + 4 + size > len(profile):
                    raise IndexError
                host = profile[8 : end - 1].decode("utf-8", "surrogateescape")
                port = ushort(profile, end + 1 & ~1)[0]
                key = profile[offset + 4 : offset + 4 + size]
                if not port:  # it has no TCP, or names that as an alternative
                    without_tcp = without_tcp or Address((type_id, host, 0, key))
                    host, port = next(iter(_with_port(_of_profile(profile)[0])), ("", 0))
                if port:
                    return Address((type_id, sys.intern(host), port, key))
    except (IndexError, struct.error):
        return Address(("", "", 0, b""))
    return without_tcp or Address((type_id, "", 0, b""))


def _unhexed(text):
    """The octets of a stringified IOR. Raises IndexError where there are none."""
    try:
        data = bytes.fromhex(text[4:])
    except ValueError:
        raise IndexError
    if 2 * len(data) != len(text) - 4:  # there were blanks
        raise IndexError
    return data


def addresses(text):
    """Every (host, port) that a stringified IOR offers, in its order:
    IIOP profiles and the alternatives named in them; not those without a port, see `transports`.
    """
    return _with_port(_offered(text)[0])


def _with_port(offered):
    return [address for address in offered if address[1]]


def transports(text):
    """In words, how else than with TCP the object of a stringified IOR can be called: ["TLS"]; [] if no other
    way is known.
    """
    offered, others = _offered(text)
    if not others and any(not port for _, port in offered):
        return [OTHER]
    return others


def _offered(text):
    """(every (host, port), transports in words) that a stringified IOR offers, each once."""
    offered = []
    others = []
    try:
        reader = _Cdr(_unhexed(text))
        reader.octets()  # the type id
        for _ in range(reader.ulong()):
            tag = reader.ulong()
            profile = reader.octets()
            if tag != IIOP:
                others.append(OTHER)
                continue
            addresses_there, others_there = _of_profile(profile)
            offered += addresses_there
            others += others_there
    except (IndexError, struct.error):
        pass  # keep what came before the garbage
    return list(dict.fromkeys(offered)), list(dict.fromkeys(others))


def _of_profile(profile):
    """([(host, port)], [transport in words]) that an IIOP profile offers."""
    offered = []
    others = []
    try:
        body = _Cdr(profile)
        minor = profile[2]
        body.at = body.at + 2
        offered.append(body.host_and_port())
        body.octets()  # the object key
        for _ in range(body.ulong() if minor else 0):
            component = body.ulong()
            data = body.octets()
            if component == ALTERNATE:
                offered.append(_Cdr(data).host_and_port())
            elif component in TRANSPORTS:
                others.append(TRANSPORTS[component])
    except (IndexError, struct.error):
        pass  # keep what came before the garbage
    return offered, others


_LITTLE, _BIG = [
    (struct.Struct(order + "L").unpack_from, struct.Struct(order + "H").unpack_from) for order in "<>"
]


class _Cdr:
    """Reads a CDR encapsulation: a byte that gives the byte order, then aligned values."""

    def __init__(self, data):
        self.data = data
        self.at = 1
        self._ulong, self._ushort = _LITTLE if data[0] & 1 else _BIG

    def ulong(self):
        start = self.at + 3 & ~3
        self.at = start + 4
        return self._ulong(self.data, start)[0]

    def ushort(self):
        start = self.at + 1 & ~1
        self.at = start + 2
        return self._ushort(self.data, start)[0]

    def octets(self):
        size = self.ulong()
        self.at += size
        if self.at > len(self.data):
            raise IndexError
        return self.data[self.at - size : self.at]

    def host_and_port(self):
        return self.octets()[:-1].decode("utf-8", "surrogateescape"), self.ushort()


# ---- from octets to a reference ----

_pack = struct.Struct("<LL").pack
_pack_one = struct.Struct("<LLL").pack
_PADDING = [b"", b"\0\0\0", b"\0\0", b"\0"]


def octets(type_id, profiles):
    """A reference, given as bytes and (tag, bytes) pairs, as little-endian CDR; b"" for nil.

    Raises BadReference for one that must not reach omniORB.
    """
    start = check(type_id, profiles)
    if len(profiles) == 1:  # almost all, and there are many
        ((tag, profile),) = profiles
        return start + _pack_one(1, tag, len(profile)) + profile
    if not profiles:
        return b""
    parts = [_pack(tag, len(profile)) + profile + _PADDING[len(profile) & 3] for tag, profile in profiles]
    return start + struct.pack("<L", len(profiles)) + b"".join(parts)


def check(type_id, profiles):
    """Raise BadReference if a reference, given in the same form, must not reach omniORB;
    returns how its octets start.
    """
    if len(profiles) > MOST_PROFILES:
        raise BadReference(f"a reference of {len(profiles)} profiles")
    size = sum([len(profile) for _, profile in profiles])
    if size > LARGEST:
        raise BadReference("a reference of %d octets" % size)
    return _start(type_id) if profiles else b""


@cached(64)
def _start(type_id):
    """The repository id as a reference begins with it. Raises BadReference if it is not one."""
    size = len(type_id)
    ends = type_id.find(b"\0")
    try:
        # of the empty one, without even a NUL, as some ORBs write it, both are -1
        if size > LONGEST_TYPE or ends != size - 1:
            raise ValueError
        type_id.decode("utf-8")
    except ValueError:
        raise BadReference("a reference whose type is not text")
    return struct.pack("<L", size) + type_id + _PADDING[size & 3]


def checked(said):
    """A stringified IOR that a peer has sent as text. Raises BadReference for one that must not reach
    omniORB.

    Other forms, such as corbaname:, would let the peer choose whom omniORB calls.
    """
    if said[:4].upper() != "IOR:" or len(said) > 3 * LARGEST:
        raise BadReference("not a reference (no IOR, or too long)")
    try:
        reader = _Cdr(_unhexed(said))
        type_id = reader.octets()
        count = reader.ulong()
        octets(type_id, [(reader.ulong(), reader.octets()) for _ in range(min(count, MOST_PROFILES + 1))])
    except (struct.error, IndexError):
        raise BadReference("not a reference (its octets make no sense)")
    if not count:
        raise BadReference("not a reference (it is nil)")
    return said


# ---- descriptors ----


def _pair(*parts):
    return parts


_OCTETS = (descriptors.SEQUENCE, descriptors.OCTET, 0)
_PROFILE = (descriptors.STRUCT, _pair, "", "", "tag", descriptors.ULONG, "data", _OCTETS)
_PROFILES = (descriptors.SEQUENCE, _PROFILE, 0)


def guarded(descriptor, taker, holder):
    """A descriptor by which omniORB, while it reads an answer, shows us all that must be checked.

    References are read as octets: `taker(repository id)` returns a function that makes a reference of them.
    `holder(class)` replaces the class of a struct that has an `any`. Returns `descriptor` itself where it has
    neither.
    """
    sort = descriptors.kind(descriptor)
    if sort == descriptors.OBJECT:
        members = ("type_id", _OCTETS, "profiles", _PROFILES)
        return (descriptors.STRUCT, taker(descriptor[1]), descriptor[1], "") + members
    indexes = {descriptors.SEQUENCE: [1], descriptors.ARRAY: [1], descriptors.ALIAS: [3]}.get(sort, [])
    if sort in (descriptors.STRUCT, descriptors.EXCEPTION):
        indexes = list(range(5, len(descriptor), 2))
    if not indexes:
        return descriptor
    parts = list(descriptor)
    for index in indexes:  # no union in our IDL has references, and no type contains itself
        parts[index] = guarded(descriptor[index], taker, holder)
    if sort == descriptors.STRUCT and descriptors.ANY in parts[5::2]:
        parts[1] = holder(parts[1])
    if all(new is old for new, old in zip(parts, descriptor)):
        return descriptor
    return tuple(parts)
