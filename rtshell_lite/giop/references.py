"""References to objects: what they say, from text and to text; no call."""

import struct

from rtshell_lite.giop import ior
from rtshell_lite.giop import messages

_LENGTH = struct.Struct("<I")
_PAIR = struct.Struct("<II")


class Reference:
    """A reference: the repository id that it names (octets), its profiles, (tag, octets) each, and the id of
    the interface that it is used as.
    """

    __slots__ = ("type_id", "profiles", "interface", "_address")

    def __init__(self, type_id, profiles, interface=""):
        self.type_id = type_id
        self.profiles = profiles
        self.interface = interface
        self._address = None

    @property
    def address(self):
        """What it says, an ior.Address."""
        if self._address is None:
            self._address = ior.parsed(self.type_id, self.profiles)
        return self._address

    def narrowed(self, interface):
        """The same reference, used as that of another interface."""
        other = Reference(self.type_id, self.profiles, interface)
        other._address = self._address
        return other

    def _at(self, via):
        """(number, profile, key) for who is asked at an endpoint:
        of the profile with that, or else of the first with IIOP.
        """
        first = None
        for number, (tag, profile) in enumerate(self.profiles):
            if tag == ior.IIOP:
                address = ior.parsed(b"", [(tag, profile)])
                asked = number, profile, address.key
                if address[1:3] == via:
                    return asked
                first = first or asked
        return first

    def target(self, mode=messages.KEY, via=None):
        """(GIOP version, mode, octets that name the object in that mode, for who is asked at the endpoint
        `via`).

        Raises OSError where it has no IIOP profile.
        """
        _, host, port, key = self.address
        if not host:
            raise OSError(0, "no address of IIOP in its reference")
        tag, profile = self.profiles[0]
        number = 0
        if tag != ior.IIOP or via is not None and via != (host, port):  # few have more than one profile
            number, profile, key = self._at(via)
        if mode == messages.KEY:
            octets = _LENGTH.pack(len(key)) + key
        elif mode == messages.PROFILE:
            octets = _PAIR.pack(ior.IIOP, len(profile)) + profile
        else:
            octets = _LENGTH.pack(number) + self.octets()
        return (1, min(profile[2], 2)), mode, octets

    def octets(self):
        """It as little-endian CDR. Raises ior.BadReference."""
        return ior.octets(self.type_id + b"\0", self.profiles)

    def text(self):
        """The stringified IOR. Raises ior.BadReference."""
        return "IOR:" + (b"\1\0\0\0" + self.octets()).hex()


def make_reference(host, port, key, minor=2, type_id=b"", components=()):
    """A reference to an object by its address and key, as a corbaloc gives it (CORBA 3.0, 13.6);
    GIOP 1.`minor` is spoken. `components`: (tag, octets) of its profile.
    """

    def number(body, value):
        return body + b"\0" * (-len(body) % 4) + struct.pack("<I", value)

    body = number(b"\1\1" + bytes([minor]), len(host.encode("utf-8", "surrogateescape")) + 1)
    body += host.encode("utf-8", "surrogateescape") + b"\0"
    body += b"\0" * (-len(body) % 2) + struct.pack("<H", port)
    body = number(body, len(key)) + key
    if minor:
        body = number(body, len(components))
    for tag, data in components:
        body = number(number(body, tag), len(data)) + data
    return Reference(type_id, ((ior.IIOP, body),))


def from_text(text):
    """The reference in a stringified IOR that ior.checked has passed."""
    return Reference(*ior.parts(text))
