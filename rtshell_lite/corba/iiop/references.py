"""References to objects: what they say, from text and to text; no call."""
import binascii
import struct

from rtshell_lite.corba import ior


class Reference:
    """A reference: the repository id that it names (octets), its profiles, (tag, octets) each, and the id of the interface that
    it is used as.
    """

    __slots__ = ("type_id", "profiles", "interface")

    def __init__(self, type_id, profiles, interface=""):
        self.type_id, self.profiles, self.interface = type_id, profiles, interface

    @property
    def address(self):
        """What it says, an ior.Address."""
        return ior.parsed(self.type_id, self.profiles)

    @property
    def target(self):
        """(GIOP version, endpoint, object key) to ask. Raises OSError where it has no IIOP profile."""
        profile = next((data for tag, data in self.profiles if tag == ior.IIOP), None)
        if profile is None:
            raise OSError(0, "no address of IIOP in its reference")
        address = self.address
        return (1, min(profile[2], 2)), address[1:3], address.key

    def text(self):
        """The stringified IOR."""
        return "IOR:" + binascii.hexlify(b"\1\0\0\0" + ior.octets(self.type_id + b"\0", self.profiles)).decode()


def at(host, port, key, minor=2):
    """A reference to an object by its address and key alone, as a corbaloc gives it; GIOP 1.`minor` is spoken."""
    def octets(body, data):
        return body + b"\0" * (-len(body) % 4) + struct.pack("<I", len(data)) + data

    body = octets(b"\1\1" + bytes([minor]) + b"\0", host.encode("utf-8", "surrogateescape") + b"\0")
    body = octets(body + b"\0" * (-len(body) % 2) + struct.pack("<H", port), key)
    if minor:
        body += b"\0" * (-len(body) % 4) + bytes(4)  # no components
    return Reference(b"", ((ior.IIOP, body),))


def from_text(text):
    """The reference in a stringified IOR that ior.checked has passed."""
    return Reference(*ior.parts(text))
