"""The value of each type to begin with: zeros, empty texts and sequences, the first item of an enum, of a
union its first member with a label, and so a template of an operation's arguments.
"""

from rtshell_lite import errors
from rtshell_lite.data import values
from rtshell_lite.giop import descriptors, marshal, rare
from rtshell_lite.giop.descriptors import Visitor

MOST = 100000  # parts of a value: arrays of arrays are soon too large for anybody


def template(parameters):
    """{name: value for json.dumps} of the interfaces.Parameters that a caller sends, in their order.
    Raises BadType.
    """
    return {parameter.name: values.json(value(parameter.type)) for parameter in parameters}


def value(descriptor):
    """The value of a type to begin with. Raises BadType for a type that has none, or a very large one."""
    return _Default(descriptor).visit(descriptor)


class _Default(Visitor):
    def __init__(self, whole):
        self.whole = whole
        self.left = MOST

    def visit(self, descriptor):
        self.left -= 1
        if self.left < 0:
            raise errors.BadType(descriptors.name(self.whole), "too large to be written down")
        return super().visit(descriptors.target(descriptor))

    def other(self, descriptor):
        form = descriptors.FORMS.get(descriptors.kind(descriptor))
        if form in _PLAIN:
            return _PLAIN[form]
        raise errors.BadType(
            descriptors.name(self.whole), f"no value of {descriptors.words(descriptor)} can be written down"
        )

    def fixed(self, descriptor):
        return rare.fixed("0", *descriptor[1:])

    def enum(self, descriptor):
        return descriptors.items(descriptor)[0]

    def sequence(self, descriptor):
        return self._elements(descriptors.element(descriptor), 0)

    def array(self, descriptor):
        return self._elements(descriptors.element(descriptor), descriptors.length(descriptor))

    def _elements(self, inner, count):
        sort = descriptors.kind(descriptors.target(inner))
        self.left -= count
        if self.left < 0:
            count = 0
            self.visit(inner)
        if sort == descriptors.OCTET:
            return bytes(count)
        if sort == descriptors.CHAR:
            return " " * count
        return [self.visit(inner) for _ in range(count)]

    def struct(self, descriptor):
        parts = [self.visit(inner) for _, inner in descriptors.members(descriptor)]
        return descriptors.factory(descriptor)(*parts)

    def union(self, descriptor):
        case = next(
            iter(descriptors.cases_by_label(descriptor).values()), descriptors.default_case(descriptor)
        )
        return descriptors.factory(descriptor)(case.label, self.visit(case.type))

    def any(self, descriptor):
        return marshal.Any(marshal.TEXT, "")

    def typecode(self, descriptor):
        return marshal.TypeCode(marshal.TEXT)


# a blank, because a NUL cannot be seen
_PLAIN = {
    "integer": 0,
    "real": 0.0,
    "longdouble": 0.0,
    "boolean": False,
    "char": " ",
    "wchar": " ",
    "string": "",
    "wstring": "",
    "reference": None,
}
