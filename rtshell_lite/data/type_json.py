"""A data type as JSON, for log files: read without IDL or ORB, and checked, for files may be hostile.

"long"  "string"  ["string", bound]  ["sequence", type, bound]  ["array", type, length]  ["alias", id, name,
        type]
["struct", id, name, [[member, type], …]]  ["enum", id, name, [item, …]]
["union", id, name, type, index of the default or -1, [[label, member, type], …]]   an enum's label is its
item's number
["object", id, name]  ["fixed", digits, scale]   of which no values are read
["see", id]  a struct, union or enum that came before or encloses this
"""

from rtshell_lite import errors
from rtshell_lite.giop import descriptors
from rtshell_lite.giop.descriptors import (
    ALIAS, ARRAY, ENUM, FIXED, FORMS, INDIRECT, OBJECT, SEQUENCE, STRING, STRUCT, UNION, WSTRING, Visitor,
    kind,
)

LARGEST = 1 << 20  # bytes of the JSON
_KINDS = {words: kind for kind, words in descriptors.NAMES.items()}


def plain(descriptor):
    """A descriptor as lists, texts and numbers."""
    return _Plain().visit(descriptor)


class _Plain(Visitor):
    def __init__(self):
        self.seen = set()  # ids of the structs, unions and enums that have been described

    def visit(self, descriptor):
        identifier = descriptors.type_id(descriptor)
        if kind(descriptor) in (STRUCT, UNION, ENUM, INDIRECT) and identifier in self.seen:
            return ["see", identifier]
        if kind(descriptor) in (STRUCT, UNION, ENUM):
            self.seen.add(identifier)
        return super().visit(descriptor)

    def other(self, descriptor):
        return descriptors.NAMES[descriptor]

    def string(self, descriptor):
        return [FORMS[kind(descriptor)], *descriptor[1:]]

    wstring = fixed = string

    def reference(self, descriptor):
        return ["object", *descriptor[1:]]

    value = reference

    def sequence(self, descriptor):
        elements = self.visit(descriptors.element(descriptor))
        return [FORMS[kind(descriptor)], elements, descriptors.length(descriptor)]

    array = sequence

    def alias(self, descriptor):
        return ["alias", *descriptor[1:3], self.visit(descriptors.aliased(descriptor))]

    def enum(self, descriptor):
        return ["enum", *descriptor[1:3], [item._n for item in descriptors.items(descriptor)]]

    def struct(self, descriptor):
        members = [[name, self.visit(inner)] for name, inner in descriptors.members(descriptor)]
        return ["struct", *descriptor[2:4], members]

    def union(self, descriptor):
        switch = self.visit(descriptors.discriminator(descriptor))
        cases = [
            [getattr(case.label, "_v", case.label), case.member, self.visit(case.type)]
            for case in descriptors.cases(descriptor)
        ]
        return ["union", *descriptor[2:4], switch, descriptors.default_index(descriptor), cases]


def descriptor(data):
    """The descriptor for the JSON of what `plain` returned, as bytes. Raises BadType."""
    if len(data) > LARGEST:
        raise errors.BadType(f"a type of {len(data)} bytes", "too large")
    import json  # which Debian's python3-minimal lacks

    try:
        return descriptors.adopted(_raw(json.loads(data.decode("ascii")), {}))
    except errors.BadType as e:
        raise errors.BadType("a type in a file", e.why)
    except (ValueError, TypeError, KeyError, IndexError, RecursionError) as e:
        raise errors.BadType("a type in a file", f"garbled ({type(e).__name__})")


def _raw(part, types):
    """A descriptor, of which only the kinds of parts are checked. `types` collects complete structs, unions
    and enums.

    A type within itself becomes an indirection by its id.
    """
    if isinstance(part, str):
        return _KINDS[part]
    word, *rest = part
    return _FORMS[word](types, *rest)


def _string(sort):
    def form(types, bound):
        descriptors.check_length(SEQUENCE, bound)
        return (sort, bound)

    return form


def _alias(types, identifier, name, target):
    return (ALIAS, _text(identifier), _text(name), _raw(target, types))


def _enum(types, identifier, name, items):
    types[identifier] = descriptors.enum(
        _text(identifier), descriptors.check_identifier(name), list(map(_text, items))
    )
    return types[identifier]


def _struct(types, identifier, name, members):
    types.pop(_text(identifier), None)
    parts = [part for member, inner in members for part in (_text(member), _raw(inner, types))]
    types[identifier] = (STRUCT, None, identifier, _text(name), *parts)
    return types[identifier]


def _union(types, identifier, name, discriminator, default, cases):
    if not isinstance(default, int) or not -1 <= default < len(cases):
        raise ValueError("default")
    types.pop(_text(identifier), None)
    switch = _raw(discriminator, types)
    raw = tuple((label, _text(member), _raw(inner, types)) for label, member, inner in cases)
    types[identifier] = (UNION, None, identifier, _text(name), switch, default, raw)
    return types[identifier]


def _fixed(types, digits, scale):
    if not isinstance(digits, int) or not isinstance(scale, int):
        raise ValueError("not a number")
    return (FIXED, digits, scale)


_FORMS = {
    "string": _string(STRING),
    "wstring": _string(WSTRING),
    "alias": _alias,
    "enum": _enum,
    "struct": _struct,
    "union": _union,
    "sequence": lambda types, element, bound: (SEQUENCE, _raw(element, types), bound),
    "array": lambda types, element, length: (ARRAY, _raw(element, types), length),
    "object": lambda types, identifier, name: (OBJECT, _text(identifier), _text(name)),
    "fixed": _fixed,
    "see": lambda types, identifier: types.get(_text(identifier)) or (INDIRECT, [identifier]),
}


def _text(word):
    if not isinstance(word, str):
        raise ValueError("not a text")
    return word
