"""TypeCodes as descriptors (CORBA 3.0, 15.3.5.1), read from what a peer sends, where every part is bounded,
and written.

What is read first has no classes for its values; descriptors.adopted checks it, and makes them.
"""

import struct

from rtshell_lite import errors
from rtshell_lite.giop import descriptors
from rtshell_lite.giop.descriptors import (
    ALIAS, ARRAY, ENUM, EXCEPTION, FIXED, INDIRECT, OBJECT, SEQUENCE, STRING, STRUCT, UNION, WSTRING
)
from rtshell_lite.giop.fixed_size import Fault
from rtshell_lite.giop import allowance

INDIRECTION = 0xFFFFFFFF
_ANY_OBJECT = "IDL:omg.org/CORBA/Object:1.0"
# those of which the kind says all: null to Principal, long long to wchar
PLAIN = tuple(range(OBJECT)) + (23, 24, 25, 26)
# how the labels of a union are written, by the kind of its discriminator
LABELS = {
    descriptors.SHORT: "h",
    descriptors.USHORT: "H",
    descriptors.LONG: "i",
    descriptors.ULONG: "I",
    ENUM: "I",
    descriptors.LONGLONG: "q",
    descriptors.ULONGLONG: "Q",
    descriptors.BOOLEAN: "B",
    descriptors.CHAR: "B",
}


def read(data, start, order):
    """(descriptor, where it ends) of the TypeCode at `start`. Raises Fault, struct.error, IndexError."""
    reader = _Reader(data, start, order, 0)
    adoption = descriptors.Adoption(most=allowance.spend(0), weight=allowance.CLASS)
    try:
        return adoption.take(reader.typecode({}, descriptors.DEEPEST), descriptors.DEEPEST), reader.at
    except errors.BadType as e:
        raise Fault(str(e))
    finally:
        allowance.spend(adoption.count)


class _Reader:
    """Reads from a place on; `base` is where alignment counts from:
    the message, or the encapsulation around.
    """

    def __init__(self, data, start, order, base):
        self.data = data
        self.at = start
        self.order = order
        self.base = base

    def number(self, code="I"):
        form = struct.Struct(self.order + code)
        self.at += -(self.at - self.base) % form.size
        self.at += form.size
        return form.unpack_from(self.data, self.at - form.size)[0]

    def octets(self):
        size = self.number()
        self.at += size
        if self.at > len(self.data):
            raise Fault("octets without an end")
        return self.data[self.at - size : self.at]

    def text(self):
        return bytes(self.octets()[:-1]).decode("latin-1")

    def count(self):
        """A count of parts, each of at least four octets."""
        count = self.number()
        if count * 4 > len(self.data) - self.at:
            raise Fault("%d parts are announced, but %d octets are left" % (count, len(self.data) - self.at))
        allowance.spend(count)
        return count

    def inside(self):
        """A reader of the encapsulation that begins here, which is passed over."""
        size = self.number()
        start = self.at
        self.at += size
        if size == 0 or self.at > len(self.data):
            raise Fault("an encapsulation without an end")
        return _Reader(self.data, start + 1, "<" if self.data[start] & 1 else ">", start)

    def typecode(self, by_offset, depth):
        """The descriptor here; `by_offset` {where a TypeCode begins:
        descriptor, or the list that will hold it} is for indirections to it.
        """
        if depth < 0:
            raise Fault("types inside types, deeper than %d" % descriptors.DEEPEST)
        kind = self.number()
        start = self.at - 4
        if kind == INDIRECTION:
            offset = self.number("i")
            descriptor = by_offset.get(self.at - 4 + offset)
            if descriptor is None:
                raise Fault("an indirection to nowhere")
            return (INDIRECT, descriptor) if isinstance(descriptor, list) else descriptor
        if kind in PLAIN:
            return kind
        if kind in (STRING, WSTRING):
            descriptor = (kind, self.number())
        elif kind == FIXED:
            descriptor = (kind, self.number("H"), self.number("h"))
        else:
            hole = by_offset[start] = [None]
            hole[0] = descriptor = self.inside().parts(kind, by_offset, depth - 1)
        by_offset[start] = descriptor
        return descriptor

    def parts(self, kind, by_offset, depth):
        """The descriptor of a type whose parts are in this encapsulation."""
        if kind in (SEQUENCE, ARRAY):
            return kind, self.typecode(by_offset, depth), self.number()
        type_id = self.text()
        name = self.text()
        if kind == OBJECT:
            return kind, type_id, name
        if kind == ALIAS:
            return kind, type_id, name, self.typecode(by_offset, depth)
        if kind == ENUM:
            return descriptors.enum(type_id, name, [self.text() for _ in range(self.count())])
        if kind in (STRUCT, EXCEPTION):
            members = [(self.text(), self.typecode(by_offset, depth)) for _ in range(self.count())]
            if kind == EXCEPTION:  # whose value begins with its id
                members.insert(0, ("_id", (STRING, 0)))
            return (STRUCT, None, type_id, name) + tuple(part for member in members for part in member)
        if kind == UNION:
            return self.union(type_id, name, by_offset, depth)
        raise Fault(f"a type of kind {kind}")

    def union(self, type_id, name, by_offset, depth):
        switch = self.typecode(by_offset, depth)
        default = self.number("i")
        sort = descriptors.kind(descriptors.plain(switch))
        code = LABELS.get(sort)
        if code is None:
            raise Fault("a union that is switched by what cannot switch one")
        cases = []
        for number in range(self.count()):
            label = self.number(code)
            if sort == descriptors.CHAR:
                label = chr(label)
            if number == default and sort != descriptors.CHAR:
                label = 0
            cases.append((descriptors.label(switch, label), self.text(), self.typecode(by_offset, depth)))
        if not -1 <= default < len(cases):
            raise Fault("a union whose default is not one of its cases")
        described = tuple(descriptors.Case(case) for case in cases)
        other = described[default] if default >= 0 else None
        return (UNION, None, type_id, name, switch, default, described, other, None)


# ---- writing ----


def write(out, descriptor, order):
    """Append the TypeCode of a checked descriptor to a message. Raises Fault for what has none."""
    _Writer(out, order, 0, {}).typecode(descriptor)


class _Writer:
    """Appends to `out`; `base` is where alignment counts from, `offsets` {identity of a struct or union:
    where its TypeCode begins} is for types inside themselves.
    """

    def __init__(self, out, order, base, offsets):
        self.out = out
        self.order = order
        self.base = base
        self.offsets = offsets

    def number(self, value, code="I"):
        form = struct.Struct(self.order + code)
        self.out += b"\0" * (-(len(self.out) - self.base) % form.size) + form.pack(value)

    def text(self, value):
        octets = value.encode("latin-1") + b"\0"
        self.number(len(octets))
        self.out += octets

    def typecode(self, descriptor):
        kind = descriptors.kind(descriptor)
        if kind == INDIRECT:
            descriptor = descriptors.around(descriptor)
            kind = descriptors.kind(descriptor)
        if id(descriptor) in self.offsets:
            self.number(INDIRECTION)
            self.number(self.offsets[id(descriptor)] - len(self.out), "i")
            return
        self.number(kind)
        if kind in (STRING, WSTRING):
            self.number(descriptors.bound(descriptor))
        elif kind == FIXED:
            self.number(descriptor[1], "H")
            self.number(descriptor[2], "h")
        elif kind not in PLAIN:
            self.encapsulated(descriptor, len(self.out) - 4)

    def encapsulated(self, descriptor, offset):
        self.number(0)
        start = len(self.out)
        self.out += b"\1" if self.order == "<" else b"\0"
        inner = _Writer(self.out, self.order, start, self.offsets)
        if descriptors.kind(descriptor) in (STRUCT, UNION):
            self.offsets[id(descriptor)] = offset
        inner.parts(descriptor)
        self.offsets.pop(id(descriptor), None)
        struct.pack_into(self.order + "I", self.out, start - 4, len(self.out) - start)

    def parts(self, descriptor):
        kind = descriptors.kind(descriptor)
        if kind in (SEQUENCE, ARRAY):
            self.typecode(descriptors.element(descriptor))
            return self.number(descriptors.length(descriptor))
        self.text(descriptors.type_id(descriptor) or _ANY_OBJECT)  # only Object has no id
        self.text(descriptors.words(descriptor))
        if kind == ALIAS:
            self.typecode(descriptors.aliased(descriptor))
        elif kind == ENUM:
            self.number(len(descriptors.items(descriptor)))
            for item in descriptors.items(descriptor):
                self.text(item._n)
        elif kind == STRUCT:
            self.number(len(descriptors.members(descriptor)))
            for name, inner in descriptors.members(descriptor):
                self.text(name)
                self.typecode(inner)
        elif kind == UNION:
            self.union(descriptor)
        elif kind != OBJECT:
            raise Fault(f"a type of kind {kind}")

    def union(self, descriptor):
        switch = descriptors.discriminator(descriptor)
        code = LABELS[descriptors.kind(descriptors.target(switch))]
        self.typecode(switch)
        self.number(descriptors.default_index(descriptor), "i")
        self.number(len(descriptors.cases(descriptor)))
        for case in descriptors.cases(descriptor):
            self.number(_label_number(case.label), code)
            self.text(case.member)
            self.typecode(case.type)


def _label_number(label):
    return ord(label) if isinstance(label, str) else int(getattr(label, "_v", label))
