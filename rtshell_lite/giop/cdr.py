"""CDR, the form in which values travel (CORBA 3.0, 15.3), read and written by descriptors; needs no ORB.

omniORB's cdrUnmarshal cannot read a wchar, accepts nothing after a value, overflows the stack on a recursive
type that is nested deep enough, and ends the process on a descriptor that it does not like. Here, hostile
bytes take memory in proportion to their number. Strings are UTF-8; invalid bytes become surrogate escapes.
"""

import struct

from rtshell_lite.giop.descriptors import (
    BOOLEAN, CHAR, DOUBLE, FLOAT, FORMS, LONG, LONGLONG, OCTET, SHORT, ULONG, ULONGLONG, USHORT, bound,
    cases_by_label, default_case, discriminator, element, factory, kind, length, members, target,
)
from rtshell_lite.giop.fixed_size import CODES, SIZES, Fault, Forms, fixed, least

NUMBERS = (SHORT, LONG, USHORT, ULONG, FLOAT, DOUBLE, BOOLEAN, LONGLONG, ULONGLONG)


def codec(descriptor, little):
    """(read, write) for a checked descriptor and a byte order, for any number of values.

    `read(data, at)` gives (value, where it ends), or raises Fault, struct.error, RecursionError. `write(out,
    value)` appends to the bytearray `out`, or raises anything for a value of another type;
    `build_value.build` then says what is wrong.
    """
    maker = Maker("<" if little else ">")
    return maker.reader(descriptor), maker.writer(descriptor)


# ---- readers and writers ----


class Maker:
    """Makes readers and writers of one byte order, by a method for each form (descriptors.FORMS) whose size
    varies; a recursive type finds its own by its identity.
    """

    def __init__(self, order):
        self.order = order
        self.count = struct.Struct(order + "I")
        self.readers = {}
        self.writers = {}

    def reader(self, descriptor):
        return self._made(descriptor, self.readers, "read")

    def writer(self, descriptor):
        return self._made(descriptor, self.writers, "write")

    def _made(self, descriptor, functions, verb):
        descriptor = target(descriptor)
        if id(descriptor) in functions:
            hole = functions[id(descriptor)]
            return hole[0] or (lambda first, second: hole[0](first, second))
        hole = functions[id(descriptor)] = [None, descriptor]  # kept, so that its id stays its own
        try:
            hole[0] = self._new(descriptor, verb)
        finally:
            if hole[0] is None:  # Ctrl-C, say: forget what is half made
                functions.clear()
        return hole[0]

    def _new(self, descriptor, verb):
        form = fixed(descriptor)
        if form:
            return getattr(self, verb + "_sized")(form)
        make = getattr(self, f"{verb}_{FORMS.get(kind(descriptor))}", None)
        if make is None:
            raise Fault(f"a value of kind {kind(descriptor)}")
        return make(descriptor)

    def read_sized(self, form):
        forms = Forms(self.order, form.codes)
        make = form.make

        def read(data, offset):
            layout = forms[offset & 7]
            leaves = layout.unpack_from(data, offset)
            return make(leaves, 0) if make else leaves[0], offset + layout.size

        return read

    def write_sized(self, form):
        forms = Forms(self.order, form.codes)
        flatten = form.flatten

        def write(out, value):
            out += forms[len(out) & 7].pack(*flatten(value))

        return write

    def read_struct(self, descriptor):
        readers = [self.reader(inner) for _, inner in members(descriptor)]
        return self.row_reader(readers, factory(descriptor))

    @staticmethod
    def row_reader(readers, make):
        """read(data, at) of values in a row, by their readers: make(*values)."""

        def read(data, offset):
            values = []
            for member in readers:
                value, offset = member(data, offset)
                values.append(value)
            return make(*values), offset

        return read

    def write_struct(self, descriptor):
        writers = [(name, self.writer(inner)) for name, inner in members(descriptor)]

        def write(out, value):
            for name, member in writers:
                member(out, getattr(value, name))

        return write

    @staticmethod
    def _of_cases(descriptor, make):
        """make(type) for the cases of a union: a dict by label, and that of the default case or None."""
        default = default_case(descriptor)
        by_label = {label: make(case.type) for label, case in cases_by_label(descriptor).items()}
        return by_label, default and make(default.type)

    def read_union(self, descriptor):
        make = factory(descriptor)
        switch = self.reader(discriminator(descriptor))
        by_label, default = self._of_cases(descriptor, self.reader)

        def read(data, offset):
            label, offset = switch(data, offset)
            member = by_label.get(label, default)
            if member is None:
                return make(label, None), offset
            value, offset = member(data, offset)
            return make(label, value), offset

        return read

    def write_union(self, descriptor):
        switch = self.writer(discriminator(descriptor))
        by_label, default = self._of_cases(descriptor, self.writer)

        def write(out, value):
            switch(out, value._d)
            member = by_label.get(value._d, default)
            if member:
                member(out, value._v)

        return write

    def _size(self, data, offset, most, smallest):
        """The count at `offset`, compared with the bytes that are left, and where it ends."""
        offset += -offset & 3
        (size,) = self.count.unpack_from(data, offset)
        if most and size > most:
            raise Fault(f"{size} elements where {most} may be")
        if size * smallest > len(data) - offset - 4:
            raise Fault(f"{size} elements are announced, but {len(data) - offset - 4} bytes are left")
        return size, offset + 4

    def _count(self, out, value, most):
        if most and len(value) > most:
            raise Fault(f"{len(value)} elements where {most} may be")
        out += b"\0" * (-len(out) & 3) + self.count.pack(len(value))

    def read_sequence(self, descriptor):
        most = length(descriptor)
        smallest = least(element(descriptor))
        elements = self._elements_reader(element(descriptor))

        def read(data, offset):
            size, offset = self._size(data, offset, most, smallest)
            return elements(data, offset, size)

        return read

    def write_sequence(self, descriptor):
        most = length(descriptor)
        elements = self._elements_writer(element(descriptor))

        def write(out, value):
            self._count(out, value, most)
            elements(out, value)

        return write

    def read_array(self, descriptor):
        size = length(descriptor)
        smallest = least(descriptor)
        elements = self._elements_reader(element(descriptor))

        def read(data, offset):
            if smallest > len(data) - offset:
                raise Fault("ends within an array")
            return elements(data, offset, size)

        return read

    def write_array(self, descriptor):
        size = length(descriptor)
        elements = self._elements_writer(element(descriptor))

        def write(out, value):
            if len(value) != size:
                raise Fault(f"an array of {len(value)} elements")
            elements(out, value)

        return write

    def _elements_reader(self, element):
        """read(data, at, size) for that many elements in a row."""
        sort = kind(target(element))
        order = self.order
        if sort == OCTET:
            return lambda data, offset, size: (data[offset : offset + size], offset + size)
        if sort == CHAR:
            return lambda data, offset, size: (data[offset : offset + size].decode("latin-1"), offset + size)
        if sort in NUMBERS:
            code = CODES[sort]
            width = SIZES[CODES[sort]]

            def read_numbers(data, offset, size):
                if size:
                    offset += -offset % width
                numbers = struct.unpack_from("%s%d%s" % (order, size, code), data, offset)
                return list(numbers), offset + size * width

            return read_numbers
        read_element = self.reader(element)

        def read(data, offset, size):
            values = []
            for _ in range(size):
                value, offset = read_element(data, offset)
                values.append(value)
            return values, offset

        return read

    def _elements_writer(self, element):
        """write(out, values) for elements in a row."""
        sort = kind(target(element))
        order = self.order
        if sort in (OCTET, CHAR):
            return _write_octets if sort == OCTET else _write_chars
        if sort in NUMBERS:
            code = CODES[sort]
            width = SIZES[CODES[sort]]

            def numbers(out, values):
                if len(values):
                    out += b"\0" * (-len(out) % width) + struct.pack(f"{order}{len(values)}{code}", *values)

            return numbers
        write_element = self.writer(element)

        def write(out, values):
            for value in values:
                write_element(out, value)

        return write

    def read_string(self, descriptor):
        most = bound(descriptor)

        def read(data, offset):
            size, offset = self._size(data, offset, most and most + 1, 1)
            if size == 0:  # what some ORBs send for an empty one
                return "", offset
            if data[offset + size - 1]:
                raise Fault("a string without its end")
            return data[offset : offset + size - 1].decode("utf-8", "surrogateescape"), offset + size

        return read

    def write_string(self, descriptor):
        most = bound(descriptor)

        def write(out, value):
            octets = value.encode("utf-8", "surrogateescape")
            if b"\0" in octets:
                raise Fault("a NUL in a string")
            self._count(out, octets + b"\0", most and most + 1)
            out += octets + b"\0"

        return write

    def read_wstring(self, descriptor):
        most = bound(descriptor)

        def read(data, offset):
            size, offset = self._size(data, offset, 0, 1)
            text = _utf16(data[offset : offset + size])
            if most and len(text) > most:
                raise Fault(f"{len(text)} characters where {most} may be")
            return text, offset + size

        return read

    def write_wstring(self, descriptor):
        most = bound(descriptor)

        def write(out, value):
            if most and len(value) > most:
                raise Fault(f"{len(value)} characters where {most} may be")
            if "\0" in value:
                raise Fault("a NUL in a string")
            # as omniORB does
            units = b"\xff\xfe" + value.encode("utf-16-le", "surrogatepass") if value else b""
            self._count(out, units, 0)
            out += units

        return write

    def read_wchar(self, _):
        def read(data, offset):
            if offset >= len(data) or data[offset] not in (2, 4) or offset + 1 + data[offset] > len(data):
                raise Fault("a wide character without its size")
            text = _utf16(data[offset + 1 : offset + 1 + data[offset]])
            end = offset + 1 + data[offset]
            if len(text) != 1 or text > "\uffff":
                raise Fault("not one UTF-16 unit")
            return text, end

        return read

    def write_wchar(self, _):
        def write(out, value):
            unit = value.encode("utf-16-be", "surrogatepass")
            if len(unit) != 2:
                raise Fault("not one UTF-16 unit")
            out += b"\2" + unit  # big endian where no mark says otherwise (CORBA 3.0, 15.3.1.6)

        return write


def _utf16(units):
    """Text of UTF-16 bytes, with or without their byte order mark."""
    if len(units) % 2:
        raise Fault("half a wide character")
    if units[:2] == b"\xff\xfe":
        return units[2:].decode("utf-16-le", "surrogatepass")
    return (units[2:] if units[:2] == b"\xfe\xff" else units).decode("utf-16-be", "surrogatepass")


def _write_octets(out, value):
    # bytes(n) would make n zeros; a number is refused
    out += value if isinstance(value, int) else bytes(value)


def _write_chars(out, value):
    out += value.encode("latin-1")
