"""What logs are sent in: the part of MessagePack that senders of logs use, read within limits.

    end = Scan().end(data)           where the first value in `data` ends; None while it has not all come
    found, at = value(data, 0)       the value, and where the next one begins

Texts are str, octets bytes, and a time of fluentd (extension 0) is a float; other extensions are None.
Malformed is raised for anything else, for values inside more than DEEPEST values, and for more values than a
Budget has: one octet may be a value, which takes a hundred octets of memory.
"""

import struct

DEEPEST = 16  # values inside one another
MOST = 1000000  # values in a message that is read piece by piece
MOST_AT_ONCE = 1000  # values in a value that is read as a whole; a record of OpenRTM has 17

# By the first octet: the form of the number after it. The number is the value, the length, or the count.
_NUMBERS = {
    0xCA: ">f",
    0xCB: ">d",
    0xCC: ">B",
    0xCD: ">H",
    0xCE: ">L",
    0xCF: ">Q",
    0xD0: ">b",
    0xD1: ">h",
    0xD2: ">l",
    0xD3: ">q",
}
_OCTETS = {0xC4: ">B", 0xC5: ">H", 0xC6: ">L"}
_TEXTS = {0xD9: ">B", 0xDA: ">H", 0xDB: ">L"}
_EXTENSIONS = {0xC7: ">B", 0xC8: ">H", 0xC9: ">L"}
_FIXED_EXTENSIONS = {0xD4: 1, 0xD5: 2, 0xD6: 4, 0xD7: 8, 0xD8: 16}
_ARRAYS = {0xDC: ">H", 0xDD: ">L"}
_MAPS = {0xDE: ">H", 0xDF: ">L"}
_CONSTANTS = {0xC0: None, 0xC2: False, 0xC3: True}

NUMBER, OCTETS, TEXT, EXTENSION, ARRAY, MAP, CONSTANT = range(7)


class Malformed(Exception):
    """Octets that are not MessagePack, or too much of it."""


def _read(form, data, offset):
    (number,) = struct.unpack_from(form, data, offset)
    return number, offset + struct.calcsize(form)


def head(data, offset):
    """(kind, number, where what comes after begins) of the value at `offset`: the number is the value itself,
    how many octets or values it has. Raises struct.error or IndexError where the head has not all come,
    Malformed.
    """
    first = data[offset]
    offset += 1
    if first < 0x80 or first >= 0xE0:
        if first >= 0x80:
            first -= 0x100
        return NUMBER, first, offset
    if first < 0x90:
        return MAP, first & 0x0F, offset
    if first < 0xA0:
        return ARRAY, first & 0x0F, offset
    if first < 0xC0:
        return TEXT, first & 0x1F, offset
    if first in _CONSTANTS:
        return CONSTANT, _CONSTANTS[first], offset
    if first in _FIXED_EXTENSIONS:
        return EXTENSION, _FIXED_EXTENSIONS[first], offset
    for kind, forms in (
        (NUMBER, _NUMBERS),
        (TEXT, _TEXTS),
        (OCTETS, _OCTETS),
        (ARRAY, _ARRAYS),
        (MAP, _MAPS),
        (EXTENSION, _EXTENSIONS),
    ):
        if first in forms:
            number, offset = _read(forms[first], data, offset)
            return kind, number, offset
    raise Malformed("octet 0x%02x" % first)


class Scan:
    """Finds the end of the value with which `data` begins, without looking at any octet of it twice, however
    it comes; `seen` is how many values there are in it.
    """

    def __init__(self):
        self._at = 0
        self._wanted = 1  # values that are to come
        self.seen = 0

    def end(self, data):
        """Where the value ends; None while it has not all come. Raises Malformed."""
        while self._wanted:
            try:
                kind, number, offset = head(data, self._at)
            except (struct.error, IndexError):
                return None
            if kind in (TEXT, OCTETS):
                offset += number
            elif kind == EXTENSION:
                offset += 1 + number
            if offset > len(data):
                return None
            self._at = offset
            self._wanted -= 1
            self.seen += 1
            if kind in (ARRAY, MAP):
                if kind == MAP:
                    number *= 2
                self._wanted += number
            if self.seen + self._wanted > MOST:
                raise Malformed("more than %d values" % MOST)
        return self._at


class Budget:
    """How many values may still come, of `most`."""

    def __init__(self, most=MOST_AT_ONCE):
        self._most = most
        self._left = most

    @property
    def spent(self):
        """How many values have come."""
        return self._most - self._left

    def spend(self, number=1):
        """Note values. Raises Malformed where there are too many."""
        self._left -= number
        if self._left < 0:
            raise Malformed("more than %d values" % self._most)


def value(data, offset, depth=0, budget=None):
    """(the value at `offset`, where the next begins). Raises Malformed, and struct.error or IndexError where
    `data` ends in it. It may have as many values as are left in a Budget, MOST_AT_ONCE without one.
    """
    if depth > DEEPEST:
        raise Malformed("more than %d values inside one another" % DEEPEST)
    if budget is None:
        budget = Budget()
    budget.spend()
    kind, number, offset = head(data, offset)
    if kind in (NUMBER, CONSTANT):
        return number, offset
    if kind == ARRAY:
        values = []
        for _ in range(number):
            item, offset = value(data, offset, depth + 1, budget)
            values.append(item)
        return values, offset
    if kind == MAP:
        fields = {}
        for _ in range(number):
            key, offset = value(data, offset, depth + 1, budget)
            item, offset = value(data, offset, depth + 1, budget)
            if isinstance(key, (str, bytes, int, float)):
                fields[key] = item
        return fields, offset
    if kind == EXTENSION:
        return _extension(data, offset, number), offset + 1 + number
    octets = bytes(data[offset : offset + number])
    if len(octets) < number:
        raise IndexError(offset)
    if kind == TEXT:
        return octets.decode("utf-8", "surrogateescape"), offset + number
    return octets, offset + number


def _extension(data, offset, number):
    if number != 8 or data[offset] != 0:
        return None
    seconds, nanoseconds = struct.unpack_from(">LL", data, offset + 1)
    return seconds + nanoseconds / 1e9


def text(octets):
    """A short text as MessagePack; `octets` are at most 255."""
    return b"\xd9" + struct.pack(">B", len(octets)) + octets
