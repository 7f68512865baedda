"""The value of each type to begin with: zeros, empty texts and sequences, the first item of an enum, of a
union its first member with a label, and so a template of an operation's arguments.
"""

from rtshell_lite import errors
from rtshell_lite.data import values
from rtshell_lite.giop import descriptors, marshal, rare

MOST = 100000  # parts of a value: arrays of arrays are soon too large for anybody


def template(parameters):
    """{name: value for json.dumps} of the interfaces.Parameters that a caller sends, in their order.
    Raises BadType.
    """
    return {each.name: values.json(value(each.type)) for each in parameters}


def value(descriptor):
    """The value of a type to begin with. Raises BadType for a type that has none, or a very large one."""
    return _Default(descriptor).of(descriptor)


class _Default:
    def __init__(self, whole):
        self.whole = whole
        self.left = MOST

    def of(self, descriptor):
        self.left -= 1
        if self.left < 0:
            raise errors.BadType(descriptors.name(self.whole), "too large to be written down")
        descriptor = descriptors.target(descriptor)
        sort = descriptors.kind(descriptor)
        if sort in descriptors.RANGES:
            return 0
        if sort in _PLAIN:
            return _PLAIN[sort]
        if sort == descriptors.FIXED:
            return rare.fixed("0", *descriptor[1:])
        if sort == descriptors.ENUM:
            return descriptors.items(descriptor)[0]
        if sort == descriptors.SEQUENCE:
            return self.elements(descriptors.element(descriptor), 0)
        if sort == descriptors.ARRAY:
            return self.elements(descriptors.element(descriptor), descriptors.length(descriptor))
        if sort == descriptors.STRUCT:
            return descriptors.factory(descriptor)(
                *[self.of(inner) for _, inner in descriptors.members(descriptor)]
            )
        if sort == descriptors.UNION:
            return self.union(descriptor)
        if sort == descriptors.ANY:
            return marshal.Any((descriptors.STRING, 0), "")
        if sort == descriptors.TYPECODE:
            return marshal.TypeCode((descriptors.STRING, 0))
        raise errors.BadType(
            descriptors.name(self.whole), f"no value of {descriptors.words(descriptor)} can be written down"
        )

    def elements(self, inner, count):
        sort = descriptors.kind(descriptors.target(inner))
        self.left -= count
        if self.left < 0:
            count = 0
            self.of(inner)
        if sort == descriptors.OCTET:
            return bytes(count)
        if sort == descriptors.CHAR:
            return " " * count
        return [self.of(inner) for _ in range(count)]

    def union(self, descriptor):
        case = next(
            iter(descriptors.cases_by_label(descriptor).values()), descriptors.default_case(descriptor)
        )
        return descriptors.factory(descriptor)(case.label, self.of(case.type))


# a blank, because a NUL cannot be seen
_PLAIN = {
    descriptors.FLOAT: 0.0,
    descriptors.DOUBLE: 0.0,
    descriptors.LONGDOUBLE: 0.0,
    descriptors.BOOLEAN: False,
    descriptors.CHAR: " ",
    descriptors.WCHAR: " ",
    descriptors.STRING: "",
    descriptors.WSTRING: "",
    descriptors.OBJECT: None,
}
