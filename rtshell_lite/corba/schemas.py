"""Operations of a user's IDL (operations.Schema), as omniORBpy makes them: with values and descriptors of its
own kind.

Its strings are Latin-1, its references and `any` are objects of its own; see giop/operations.py for ours.
"""

import functools

from rtshell_lite import errors
from rtshell_lite.corba import answers
from rtshell_lite.giop import descriptors, ior, rare, references
from rtshell_lite.giop.descriptors import (
    ALIAS, ANY, ARRAY, CHAR, EXCEPTION, FIXED, INDIRECT, OBJECT, OCTET, SEQUENCE, STRING, STRUCT, TYPECODE,
    ULONGLONG, UNION,
)
from rtshell_lite.giop.marshal import Any, TypeCode
from rtshell_lite.text import from_wire, to_wire

MANY = 256  # schemas whose descriptors are kept


def invoke(orb, where, ref, schema, args):
    """The result of an operation, one value or a tuple of several, None for none.
    Raises CORBA exceptions, errors.Raised for one of the schema, Garbled.
    """
    from omniORB import CORBA

    given, returned, raised = _described(schema)
    try:
        values = tuple(_sent(orb, descriptor, value) for descriptor, value in zip(schema.given, args))
    except OverflowError as e:
        raise errors.Refused(where, f"cannot be asked: {e}", name="BAD_PARAM")
    answers.begin()
    try:
        result = ref._obj.invoke(schema.name, (given, returned, raised), values)
    except CORBA.UserException as e:
        descriptor = schema.raised[e._NP_RepositoryId]
        raise errors.Raised(where, descriptor[3], _received(orb, descriptor, e))
    answers.check(where)
    if len(schema.returned or ()) < 2:
        result = [result]
    try:
        values = [
            _received(orb, descriptor, value) for descriptor, value in zip(schema.returned or (), result)
        ]
    except RecursionError:
        raise errors.Garbled(where, "nested too deep")
    if len(values) == 1:
        return values[0]
    return tuple(values) or None


@functools.lru_cache(maxsize=MANY)
def _described(schema):
    """The descriptors that omniORBpy takes for a schema."""
    given = tuple(_Described().of(descriptor) for descriptor in schema.given)
    if schema.is_oneway:
        returned = None
    else:
        returned = tuple(_Described(is_guarded=True).of(descriptor) for descriptor in schema.returned)
    raised = {
        type_id: _Described(is_guarded=True).exception(descriptor)
        for type_id, descriptor in schema.raised.items()
    }
    return given, returned, raised or None


class _Described:
    """Makes descriptors for omniORBpy; in those of an answer (`is_guarded`) references are read as octets,
    which are checked before omniORB makes objects of them.
    """

    def __init__(self, is_guarded=False):
        self.is_guarded = is_guarded
        self.holes = {}  # identity of a struct or union → [its descriptor, once it is made]

    def of(self, descriptor):
        kind = descriptors.kind(descriptor)
        if kind in (SEQUENCE, ARRAY):
            return (kind, self.of(descriptors.element(descriptor)), descriptors.length(descriptor))
        if kind == ALIAS:
            return descriptor[:3] + (self.of(descriptors.aliased(descriptor)),)
        if kind == OBJECT and self.is_guarded:
            return ior.guarded(descriptor, _taker, None)
        if kind == INDIRECT:
            descriptor = descriptors.around(descriptor)
            kind = descriptors.kind(descriptor)
        hole = self.holes.get(id(descriptor))
        if hole:
            return hole[0] or (INDIRECT, hole)
        if kind == STRUCT:
            return self._within(descriptor, lambda: (STRUCT,) + descriptor[1:4] + self._members(descriptor))
        if kind == UNION:
            return self._within(descriptor, lambda: self._union(descriptor))
        return descriptor

    def exception(self, descriptor):
        from omniORB import CORBA

        kind, plain, type_id, name = descriptor[:4]
        made = type(name, (plain, CORBA.UserException), {"_NP_RepositoryId": type_id})
        return (kind, made, type_id, name) + self._members(descriptor)

    def _within(self, descriptor, make):
        hole = self.holes[id(descriptor)] = [None]
        hole[0] = make()
        return hole[0]

    def _members(self, descriptor):
        return tuple(
            part for name, inner in descriptors.members(descriptor) for part in (name, self.of(inner))
        )

    def _union(self, descriptor):
        given = tuple((case.label, case.member, self.of(case.type)) for case in descriptors.cases(descriptor))
        default = descriptors.default_index(descriptor)
        other = given[default] if default >= 0 else None
        by_label = {case[0]: case for case in given if case is not other}
        return descriptor[:6] + (given, other, by_label)


def _taker(type_id):
    """A function that makes a Reference of its octets, nil in place of a bad one."""

    def take(own_id, profiles):
        try:
            if not profiles:
                return None
            ior.check(own_id, profiles)
            return references.Reference(own_id[:-1], tuple(profiles), type_id)
        except ValueError as e:
            answers.fault(str(e))
            return None

    return take


def _is_plain(element):
    """Whether elements of a type are the same for both."""
    return not isinstance(descriptors.target(element), tuple) and descriptors.kind(element) not in (
        ANY, TYPECODE
    )


def _sent(orb, descriptor, value):
    """A value of ours as omniORBpy takes it."""
    descriptor = descriptors.target(descriptor)
    kind = descriptors.kind(descriptor)
    if kind == STRING:
        return to_wire(value)
    if kind == OBJECT:
        return value and orb.string_to_object(value.text())
    if kind == ANY:
        from omniORB import CORBA

        inner = value.descriptor
        return CORBA.Any(_typecode(inner), _sent(orb, inner, value.content))
    if kind == TYPECODE:
        return _typecode(value.descriptor)
    if kind == FIXED:
        from omniORB import CORBA

        return CORBA.fixed(descriptor[1], descriptor[2], int(value.replace(".", "")))
    if kind in (SEQUENCE, ARRAY):
        _check_numbers(descriptors.element(descriptor), value)
    return _each_part(functools.partial(_sent, orb), descriptor, value)


def _check_numbers(element, value):
    """Raise OverflowError for numbers in a sequence that omniORBpy (4.3) sends as others."""
    if descriptors.target(element) == ULONGLONG and any(number >> 63 for number in value):
        raise OverflowError("omniORBpy sends no such numbers in sequences; set RTSHELL_ORB=builtin")


def _typecode(descriptor):
    from omniORB import tcInternal

    return tcInternal.createTypeCode(_Described().of(descriptor))


def _received(orb, descriptor, value):
    """A value that omniORBpy has read, as ours."""
    descriptor = descriptors.target(descriptor)
    kind = descriptors.kind(descriptor)
    if kind == STRING:
        return from_wire(value)
    if kind == OBJECT and value is not None and not isinstance(value, references.Reference):
        return references.from_text(orb.object_to_string(value))
    if kind == ANY:
        inner = descriptors.adopted(value.typecode()._d)
        return Any(inner, _received(orb, inner, value.value()))
    if kind == TYPECODE:
        return TypeCode(descriptors.adopted(value._d))
    if kind == FIXED:
        return rare.fixed(str(value), *descriptor[1:])
    return _each_part(functools.partial(_received, orb), descriptor, value)


def _each_part(convert, descriptor, value):
    kind = descriptors.kind(descriptor)
    if kind in (STRUCT, EXCEPTION):
        parts = [convert(inner, getattr(value, name)) for name, inner in descriptors.members(descriptor)]
        return descriptors.factory(descriptor)(*parts)
    if kind == UNION:
        case = descriptors.cases_by_label(descriptor).get(value._d, descriptors.default_case(descriptor))
        if case is None:
            return value
        return descriptors.factory(descriptor)(value._d, convert(case.type, value._v))
    if kind in (SEQUENCE, ARRAY):
        element = descriptors.element(descriptor)
        if descriptors.kind(descriptors.target(element)) in (OCTET, CHAR):
            return value
        if _is_plain(element):
            return value
        return [convert(element, part) for part in value]
    return value
