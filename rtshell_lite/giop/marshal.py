"""Values that only an ORB sends: references, `any`, TypeCodes, exceptions;
beside those of cdr.py, and with text as Latin-1.
"""

import struct
from _thread import RLock

from rtshell_lite.giop import cdr, descriptors, ior
from rtshell_lite.giop.descriptors import ANY, CHAR, OCTET, STRING
from rtshell_lite.giop.fixed_size import Fault
from rtshell_lite.giop import allowance
from rtshell_lite.giop.references import Reference

TEXT = (STRING, 0)
_NAME_VALUE = "IDL:org.omg/SDOPackage/NameValue:1.0"


def _is_nvlist(descriptor):
    element = descriptors.plain(descriptors.element(descriptor))
    return descriptors.kind(element) == descriptors.STRUCT and descriptors.type_id(element) == _NAME_VALUE


class Unsendable(Fault):
    """A text that CORBA cannot send, of a user or of a peer."""


class Any:
    """A value with the descriptor of its type."""

    __slots__ = ("descriptor", "content")

    def __init__(self, descriptor, content):
        self.descriptor = descriptor
        self.content = content

    def __repr__(self):  # shown where a property has an any in an any; the same each time
        return str(self.content)


class TypeCode:
    """A type as a value: its descriptor."""

    __slots__ = ("descriptor",)

    def __init__(self, descriptor):
        self.descriptor = descriptor


class Maker(cdr.Maker):
    """Readers and writers of one byte order, for the operations of the tables; `depth` counts the values
    around, each in an any.
    """

    read_exception = cdr.Maker.read_struct
    write_exception = cdr.Maker.write_struct

    def __init__(self, order, depth=0):
        super().__init__(order)
        self.depth = depth
        self._lock = RLock()

    def reader(self, descriptor):
        with self._lock:  # threads share a Maker, and what one has half made is not for others
            return super().reader(descriptor)

    def writer(self, descriptor):
        with self._lock:
            return super().writer(descriptor)

    def _elements_reader(self, element):
        read = super()._elements_reader(element)
        if descriptors.kind(descriptors.target(element)) in cdr.NUMBERS + (OCTET, CHAR):
            return read

        def counted(data, offset, size):
            allowance.spend(size)
            return read(data, offset, size)

        return counted

    def read_sequence(self, descriptor):
        if _is_nvlist(descriptor):
            return self._pairs_reader()
        return super().read_sequence(descriptor)

    def write_sequence(self, descriptor):
        if _is_nvlist(descriptor):
            return self._pairs_writer()
        return super().write_sequence(descriptor)

    def results_reader(self, types):
        """read(data, at) of what an operation returns: None, one value, or a tuple of them."""
        readers = [self.reader(descriptor) for descriptor in types]
        return readers[0] if len(readers) == 1 else self.row_reader(readers, lambda *values: values or None)

    def read_part(self, structure, part):
        """Read a part of a structure, as in orb.call."""
        inner = [member for _, member in descriptors.members(structure)]
        if isinstance(part, int):
            readers = [self.reader(member) for member in inner[:part]]
        else:
            readers = [self.reader(member) for member in inner[:-1]] + [self._pair_reader(part.encode())]
        rest = [None] * (len(inner) - len(readers))
        make = descriptors.factory(structure)
        return self.row_reader(readers, lambda *values: make(*values, *rest))

    def _pair_reader(self, name):
        """Of an NVList at the end, the pair with this name, or the first pair for b"": [], or one pair."""
        if not name:
            first = self._pairs_reader(most=1)
            return lambda data, offset: (first(data, offset)[0], len(data))
        mark = self.count.pack(len(name) + 1) + name + b"\0"
        start = struct.Struct(self.order + "III")
        whole = self._pairs_reader()

        def read(data, offset):
            begin = data.find(mark, offset)
            if begin < 0 or begin & 3:
                return [pair for pair in whole(data, offset)[0] if pair[0] == name], len(data)
            begin += len(mark)
            begin += -begin & 3
            kind, bound, length = start.unpack_from(data, begin)
            end = begin + start.size + length
            if kind != STRING or bound or data[end - 1]:
                return whole(data, offset)
            return [(name, data[begin + start.size : end - 1])], end

        return read

    def _pairs_reader(self, most=None):
        """An NVList as (octets of the name, octets of the value or an Any) pairs:
        profiles are full of them. It stops after `most` pairs, of a list at the end of an answer.
        """
        unpack = self.count.unpack_from
        start = struct.Struct(self.order + "III")
        others = self.reader(ANY)

        def read(data, offset):
            size, offset = self._size(data, offset, 0, 8)
            allowance.spend(size)
            pairs = []
            last = len(data) - start.size
            for _ in range(size)[:most]:
                offset += 4 + (-offset & 3)
                end = offset + unpack(data, offset - 4)[0]
                name = data[offset : end - 1]
                if data[end - 1]:
                    raise Fault("a string without its end")
                offset = end + (-end & 3)
                if offset <= last:
                    kind, bound, length = start.unpack_from(data, offset)
                    if kind == STRING and not bound:  # almost all are
                        end = offset + start.size + length
                        pairs.append((name, data[offset + start.size : end - 1]))
                        if data[end - 1]:
                            raise Fault("a string without its end")
                        offset = end
                        continue
                value, offset = others(data, offset)
                pairs.append((name, value))
            return pairs, offset

        return read

    def _pairs_writer(self):
        pack = self.count.pack

        def octets(out, value):
            if b"\0" in value:
                raise Unsendable("a NUL in a string")
            out += b"\0" * (-len(out) & 3) + pack(len(value) + 1) + value + b"\0"

        def write(out, values):
            out += b"\0" * (-len(out) & 3) + pack(len(values))
            for name, value in values:
                octets(out, name)
                if type(value) is not bytes:
                    raise Fault("an any of another type than string")  # others come, but are never sent
                out += b"\0" * (-len(out) & 3) + pack(STRING) + pack(0)
                octets(out, value)

        return write

    def read_string(self, descriptor):
        most = descriptors.bound(descriptor)
        unpack = self.count.unpack_from

        def read(data, offset):
            offset += -offset & 3
            (size,) = unpack(data, offset)
            end = offset + 4 + size
            if end > len(data) or most and size > most + 1:
                raise Fault("a string longer than it can be")
            if size and data[end - 1]:
                raise Fault("a string without its end")
            return data[offset + 4 : end - 1].decode("latin-1") if size else "", end

        return read

    def write_string(self, descriptor):
        pack = self.count.pack

        def write(out, value):
            octets = value.encode("latin-1") + b"\0"
            if octets.find(b"\0") < len(octets) - 1:
                raise Unsendable("a NUL in a string")
            out += b"\0" * (-len(out) & 3) + pack(len(octets)) + octets

        return write

    def read_reference(self, descriptor):
        unpack = self.count.unpack_from
        pair = struct.Struct(self.order + "II").unpack_from
        interface = descriptor[1]

        def read(data, offset):
            offset += -offset & 3
            start = offset + 4
            end = offset + 4 + unpack(data, offset)[0]
            if end > len(data):  # no place for unpack on a 32-bit system
                raise Fault("a reference longer than it can be")
            offset = end + (-end & 3)
            type_id = data[start:end]
            count = unpack(data, offset)[0]
            offset = offset + 4
            if count > ior.MOST_PROFILES:
                raise ior.BadReference(f"a reference of {count} profiles")
            profiles = []
            for _ in range(count):
                offset += -offset & 3
                tag, size = pair(data, offset)
                offset += 8 + size
                if offset > len(data):
                    raise Fault("a reference longer than it can be")
                profiles.append((tag, data[offset - size : offset]))
            if not profiles:
                return None, offset
            ior.check(type_id, profiles)  # other ORBs may end from what it refuses, if that were sent on
            ref = Reference(type_id[:-1], tuple(profiles), interface)
            # what a name is bound to
            if not interface and not ref.address.host and ior.IIOP in dict(profiles):
                raise ior.BadReference("an unusable reference")
            return ref, offset

        return read

    def write_reference(self, _):
        pack = self.count.pack
        pair = struct.Struct(self.order + "II").pack

        def write(out, ref):
            if ref is None:
                type_id = b"\0"
                profiles = ()  # type: tuple
            else:
                type_id = ref.type_id + b"\0"
                profiles = ref.profiles
            out += b"\0" * (-len(out) & 3) + pack(len(type_id)) + type_id
            out += b"\0" * (-len(out) & 3) + pack(len(profiles))
            for tag, data in profiles:
                out += b"\0" * (-len(out) & 3) + pair(tag, len(data)) + data

        return write

    def read_any(self, _):
        unpack = self.count.unpack_from
        text = self.reader(TEXT)
        order = self.order

        def read(data, offset):
            offset += -offset & 3
            if unpack(data, offset)[0] == STRING and unpack(data, offset + 4)[0] == 0:  # almost all are
                value, offset = text(data, offset + 8)
                return Any(TEXT, value), offset
            from rtshell_lite.giop import typecodes

            descriptor, offset = typecodes.read(data, offset, order)
            if descriptor in (0, 1):  # null, void
                return Any(descriptor, None), offset
            if self.depth == descriptors.DEEPEST:
                raise Fault("values inside values, deeper than %d" % descriptors.DEEPEST)
            value, offset = type(self)(order, self.depth + 1).reader(descriptor)(data, offset)
            return Any(descriptor, value), offset

        return read

    def write_any(self, _):
        order = self.order
        kind = type(self)

        def write(out, value):
            from rtshell_lite.giop import typecodes

            if self.depth == descriptors.DEEPEST:
                raise Fault("values inside values, deeper than %d" % descriptors.DEEPEST)
            typecodes.write(out, value.descriptor, order)
            if value.descriptor not in (0, 1):
                kind(order, self.depth + 1).writer(value.descriptor)(out, value.content)

        return write

    def read_typecode(self, _):
        order = self.order

        def read(data, offset):
            from rtshell_lite.giop import typecodes

            descriptor, offset = typecodes.read(data, offset, order)
            return TypeCode(descriptor), offset

        return read

    def write_typecode(self, _):
        order = self.order

        def write(out, value):
            from rtshell_lite.giop import typecodes

            typecodes.write(out, value.descriptor, order)

        return write

    def read_fixed(self, descriptor):
        from rtshell_lite.giop import rare

        return rare.reader(descriptor, self.order)

    def write_fixed(self, descriptor):
        from rtshell_lite.giop import rare

        return rare.writer(descriptor, self.order)

    read_longdouble = read_principal = read_fixed
    write_longdouble = write_principal = write_fixed


class ValueMaker(Maker):
    """Readers and writers for operations of a user's IDL: values as data ports have them, with text
    in UTF-8.
    """

    read_string = cdr.Maker.read_string
    write_string = cdr.Maker.write_string
    read_sequence = cdr.Maker.read_sequence
    write_sequence = cdr.Maker.write_sequence
