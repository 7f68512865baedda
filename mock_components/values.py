"""Values of the basic data types and of a user's own, and their CDR form."""
import os

from . import arm, carrier
from .idl import RTC
from .properties import get

# seconds that the clock of this host is ahead of the true time
CLOCK = float(os.environ.get("MOCK_CLOCK", 0))
LENGTH = 10             # of the sequences that the sequence examples send


def typecode(type_name):
    """The CORBA type code of a type: its name without module."""
    return arm.TYPE_CODE if type_name == arm.NAME else getattr(RTC, "_tc_" + type_name)


def make(type_name, number, stamped=False):
    """The value of a type for a number; a sequence holds numbers from there on."""
    now = carrier.wall() + CLOCK
    tm = RTC.Time(int(now), int(now % 1 * 1e9)) if stamped else RTC.Time(0, 0)
    if type_name == arm.NAME:
        return arm.make(tm, number)
    kind = type_name[len("Timed"):]
    if kind.endswith("Seq"):
        numbers = [_one(kind[:-3], number + i) for i in range(LENGTH)]
        if kind == "OctetSeq":
            data = bytes(numbers)
        elif kind == "CharSeq":
            data = "".join(numbers)
        else:
            data = numbers
    else:
        data = _one(kind, number)
    return getattr(RTC, type_name)(tm, data)


def _one(kind, number):
    number = float(number) if kind in ("Float", "Double") else int(number)
    if kind == "Octet":
        return number % 256
    if kind == "Char":
        return chr(ord("A") + number % 26)
    if kind in ("String", "WString"):
        return str(number)
    if kind == "Boolean":
        return bool(number % 2)
    return number


def encode(type_name, value, little):
    """The CDR bytes of a value."""
    return carrier.marshal(typecode(type_name), value, little)


def decode(type_name, data, little):
    """The value in CDR bytes."""
    return carrier.unmarshal(typecode(type_name), data, little)


def little_endian(profile):
    """The byte order of a connector: its first usable word; None if there is none."""
    words = [
        word.strip()
        for word in get(profile.properties, "dataport.serializer.cdr.endian", "little").split(",")
    ]
    usable = [word for word in words if word in ("little", "big")]
    return usable[0] == "little" if usable else None
