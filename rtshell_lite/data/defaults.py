"""The value of each type to begin with: zeros, empty texts and sequences, the first item of an enum, of a
union its first member with a label, and so a template of an operation's arguments.
"""

from rtshell_lite import errors
from rtshell_lite.data import values
from rtshell_lite.giop import marshal, rare
from rtshell_lite.giop.descriptors import (
    ANY,
    ARRAY,
    BOOLEAN,
    CHAR,
    DOUBLE,
    ENUM,
    FIXED,
    FLOAT,
    LONGDOUBLE,
    OBJECT,
    OCTET,
    RANGES,
    SEQUENCE,
    STRING,
    STRUCT,
    TYPECODE,
    UNION,
    WCHAR,
    WSTRING,
    cases_by_label,
    default_case,
    element,
    factory,
    items,
    kind,
    length,
    members,
    name,
    target,
    words,
)

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
            raise errors.BadType(name(self.whole), "too large to be written down")
        descriptor = target(descriptor)
        sort = kind(descriptor)
        if sort in RANGES:
            return 0
        if sort in _PLAIN:
            return _PLAIN[sort]
        if sort == FIXED:
            return rare.fixed("0", *descriptor[1:])
        if sort == ENUM:
            return items(descriptor)[0]
        if sort == SEQUENCE:
            return self.elements(element(descriptor), 0)
        if sort == ARRAY:
            return self.elements(element(descriptor), length(descriptor))
        if sort == STRUCT:
            return factory(descriptor)(*[self.of(inner) for _, inner in members(descriptor)])
        if sort == UNION:
            return self.union(descriptor)
        if sort == ANY:
            return marshal.Any((STRING, 0), "")
        if sort == TYPECODE:
            return marshal.TypeCode((STRING, 0))
        raise errors.BadType(name(self.whole), f"no value of {words(descriptor)} can be written down")

    def elements(self, inner, count):
        sort = kind(target(inner))
        self.left -= count
        if self.left < 0:
            count = 0
            self.of(inner)
        if sort == OCTET:
            return bytes(count)
        if sort == CHAR:
            return " " * count
        return [self.of(inner) for _ in range(count)]

    def union(self, descriptor):
        case = next(iter(cases_by_label(descriptor).values()), default_case(descriptor))
        return factory(descriptor)(case.label, self.of(case.type))


# a blank, because a NUL cannot be seen
_PLAIN = {
    FLOAT: 0.0,
    DOUBLE: 0.0,
    LONGDOUBLE: 0.0,
    BOOLEAN: False,
    CHAR: " ",
    WCHAR: " ",
    STRING: "",
    WSTRING: "",
    OBJECT: None,
}
