"""Types whose values have a fixed size: they are read and written by one call of the module struct."""

import struct

from rtshell_lite.giop.descriptors import (
    ARRAY, BOOLEAN, CHAR, DOUBLE, ENUM, FLOAT, LONG, LONGLONG, OCTET, SEQUENCE, SHORT, STRING, STRUCT, ULONG,
    ULONGLONG, USHORT, WSTRING, element, factory, items, kind, length, members, plain, target,
)

# of the module struct
CODES = {
    SHORT: "h",
    LONG: "i",
    USHORT: "H",
    ULONG: "I",
    FLOAT: "f",
    DOUBLE: "d",
    BOOLEAN: "?",
    CHAR: "c",
    OCTET: "B",
    LONGLONG: "q",
    ULONGLONG: "Q",
    ENUM: "I",
}
SIZES = {code: struct.calcsize("<" + code) for code in CODES.values()}
FEW = 64  # leaves, at most, of a type that is read like that


class Fault(ValueError):
    """Bytes that are not a value of the type, or the other way round."""


def least(descriptor):
    """The fewest bytes that a value of a type takes, at least 1:
    a count is compared with the bytes that are left.
    """
    descriptor = plain(descriptor)
    sort = kind(descriptor)
    if sort in CODES:
        return SIZES[CODES[sort]]
    if sort in (STRING, WSTRING, SEQUENCE):
        return 4
    if sort == STRUCT:
        return sum(least(inner) for _, inner in members(descriptor))
    if sort == ARRAY:
        return length(descriptor) * least(element(descriptor))
    return 1


class Fixed:
    """A type of fixed size: the codes of its leaves,
    and functions that turn their flat list into a value and back.
    """

    def __init__(self, codes, make, flatten):
        # make(leaves, index) → value; flatten(value) → leaves
        self.codes = codes
        self.make = make
        self.flatten = flatten


def fixed(descriptor):
    """The Fixed form of a type; None when its size varies or it has many leaves."""
    descriptor = plain(descriptor)  # recursive types have no size
    sort = kind(descriptor)
    if sort == ENUM:
        enumerators = items(descriptor)
        return Fixed(["I"], lambda leaves, i: _item(enumerators, leaves[i]), lambda value: (value._v,))
    if sort == CHAR:
        return Fixed(
            ["c"], lambda leaves, i: leaves[i].decode("latin-1"), lambda value: (value.encode("latin-1"),)
        )
    if sort in CODES:
        return Fixed([CODES[sort]], None, lambda value: (value,))
    if sort == STRUCT:
        return _fixed_struct(descriptor)
    if sort == ARRAY:
        return _fixed_array(descriptor)
    return None


def _item(enumerators, number):
    if number >= len(enumerators):
        raise Fault(f"enum item number {number} of {len(enumerators)}")
    return enumerators[number]


def _fixed_struct(descriptor):
    parts = [fixed(inner) for _, inner in members(descriptor)]
    if None in parts or sum(len(part.codes) for part in parts) > FEW:
        return None
    make_struct = factory(descriptor)
    names = [name for name, _ in members(descriptor)]
    codes = [code for part in parts for code in part.codes]
    if all(part.make is None for part in parts):
        size = len(parts)
        return Fixed(
            codes, lambda leaves, i: make_struct(*leaves[i : i + size]),
            lambda value: [getattr(value, n) for n in names],
        )
    makers = []
    index = 0
    for part in parts:
        makers.append((part.make, index))
        index += len(part.codes)

    def make(leaves, i):
        return make_struct(
            *[inner(leaves, i + index) if inner else leaves[i + index] for inner, index in makers]
        )

    def flatten(value):
        return [leaf for part, name in zip(parts, names) for leaf in part.flatten(getattr(value, name))]

    return Fixed(codes, make, flatten)


def _fixed_array(descriptor):
    part = fixed(element(descriptor))
    count = length(descriptor)
    if part is None or len(part.codes) * count > FEW:
        return None
    if kind(target(element(descriptor))) in (OCTET, CHAR):
        return None
    size = len(part.codes)

    def make(leaves, i):
        if part.make is None:
            return list(leaves[i : i + count])
        return [part.make(leaves, index) for index in range(i, i + count * size, size)]

    def flatten(value):
        if len(value) != count:
            raise Fault(f"an array of {len(value)} elements")
        return [leaf for element in value for leaf in part.flatten(element)]

    return Fixed(part.codes * count, make, flatten)


class Forms(dict):
    """The struct.Struct of a list of codes, by the offset modulo 8 at which it begins:
    padding depends on that.
    """

    def __init__(self, order, codes):
        super().__init__()
        self.order = order
        self.codes = codes

    def __missing__(self, start):
        text = self.order
        offset = start
        for code in self.codes:
            padding = -offset % SIZES[code]
            text += "x" * padding + code
            offset += padding + SIZES[code]
        self[start] = form = struct.Struct(text)
        return form
