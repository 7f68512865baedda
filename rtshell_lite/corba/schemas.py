"""Operations of a user's IDL (operations.Schema), as omniORBpy makes them: with values and descriptors of its
own kind.

Its strings are Latin-1, its references and `any` are objects of its own; see giop/operations.py for ours.
"""

import functools

from rtshell_lite import errors
from rtshell_lite.corba import answers
from rtshell_lite.giop import descriptors, ior, rare, references
from rtshell_lite.giop.descriptors import ANY, INDIRECT, TYPECODE, ULONGLONG, Visitor
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
        values = tuple(map(_Sent(orb).visit, schema.given, args))
    except OverflowError as e:
        raise errors.Refused(where, f"cannot be asked: {e}", name="BAD_PARAM")
    answers.begin()
    try:
        result = ref._obj.invoke(schema.name, (given, returned, raised), values)
    except CORBA.UserException as e:
        descriptor = schema.raised[e._NP_RepositoryId]
        raise errors.Raised(where, descriptor[3], _Received(orb).visit(descriptor, e))
    answers.check(where)
    if len(schema.returned or ()) < 2:
        result = [result]
    try:
        values = list(map(_Received(orb).visit, schema.returned or (), result))
    except RecursionError:
        raise errors.Garbled(where, "nested too deep")
    if len(values) == 1:
        return values[0]
    return tuple(values) or None


@functools.lru_cache(maxsize=MANY)
def _described(schema):
    """The descriptors that omniORBpy takes for a schema."""
    given = tuple(_Described().visit(descriptor) for descriptor in schema.given)
    returned = None
    if not schema.is_oneway:
        returned = tuple(_Described(is_guarded=True).visit(descriptor) for descriptor in schema.returned)
    raised = {
        type_id: _Described(is_guarded=True).exception(descriptor)
        for type_id, descriptor in schema.raised.items()
    }
    return given, returned, raised or None


class _Described(Visitor):
    """Makes descriptors for omniORBpy; in those of an answer (`is_guarded`) references are read as octets,
    which are checked before omniORB makes objects of them.
    """

    def __init__(self, is_guarded=False):
        self.is_guarded = is_guarded
        self.holes = {}  # identity of a struct or union → [its descriptor, once it is made]

    def other(self, descriptor):
        return descriptor

    def sequence(self, descriptor):
        return (descriptor[0], self.visit(descriptors.element(descriptor)), descriptors.length(descriptor))

    array = sequence

    def alias(self, descriptor):
        return descriptor[:3] + (self.visit(descriptors.aliased(descriptor)),)

    def reference(self, descriptor):
        return ior.guarded(descriptor, _taker, None) if self.is_guarded else descriptor

    def struct(self, descriptor):
        return self._once(descriptor, lambda: descriptor[:4] + self._members(descriptor))

    def exception(self, descriptor):
        from omniORB import CORBA

        kind, plain, type_id, name = descriptor[:4]
        new_class = type(name, (plain, CORBA.UserException), {"_NP_RepositoryId": type_id})
        return (kind, new_class, type_id, name) + self._members(descriptor)

    def _once(self, descriptor, make):
        hole = self.holes.get(id(descriptor))
        if hole:
            return hole[0] or (INDIRECT, hole)
        hole = self.holes[id(descriptor)] = [None]
        hole[0] = make()
        return hole[0]

    def _members(self, descriptor):
        return tuple(
            part for name, inner in descriptors.members(descriptor) for part in (name, self.visit(inner))
        )

    def union(self, descriptor):
        return self._once(descriptor, lambda: self._union(descriptor))

    def _union(self, descriptor):
        given = tuple(
            (case.label, case.member, self.visit(case.type)) for case in descriptors.cases(descriptor)
        )
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


class _Converter(Visitor):
    """Values of a type, for an ORB of omniORBpy, as others: visit(descriptor, value)."""

    def __init__(self, orb):
        self.orb = orb

    def other(self, descriptor, value):
        return value

    def struct(self, descriptor, value):
        parts = [self.visit(inner, getattr(value, name)) for name, inner in descriptors.members(descriptor)]
        return descriptors.factory(descriptor)(*parts)

    exception = struct

    def union(self, descriptor, value):
        case = descriptors.cases_by_label(descriptor).get(value._d, descriptors.default_case(descriptor))
        if case is None:
            return value
        return descriptors.factory(descriptor)(value._d, self.visit(case.type, value._v))

    def sequence(self, descriptor, value):
        element = descriptors.target(descriptors.element(descriptor))
        if not isinstance(element, tuple) and element not in (ANY, TYPECODE):
            return value  # the same for both
        return [self.visit(element, part) for part in value]

    array = sequence


class _Sent(_Converter):
    """Values of ours as omniORBpy takes them."""

    def string(self, descriptor, value):
        return to_wire(value)

    def reference(self, descriptor, value):
        return value and self.orb.string_to_object(value.text())

    def any(self, descriptor, value):
        from omniORB import CORBA

        return CORBA.Any(_typecode(value.descriptor), self.visit(value.descriptor, value.content))

    def typecode(self, descriptor, value):
        return _typecode(value.descriptor)

    def fixed(self, descriptor, value):
        from omniORB import CORBA

        return CORBA.fixed(descriptor[1], descriptor[2], int(value.replace(".", "")))

    def sequence(self, descriptor, value):
        is_long = descriptors.target(descriptors.element(descriptor)) == ULONGLONG
        if is_long and any(number >> 63 for number in value):  # which omniORBpy (4.3) sends as others
            raise OverflowError("omniORBpy sends no such numbers in sequences; set RTSHELL_ORB=builtin")
        return super().sequence(descriptor, value)

    array = sequence


def _typecode(descriptor):
    from omniORB import tcInternal

    return tcInternal.createTypeCode(_Described().visit(descriptor))


class _Received(_Converter):
    """Values that omniORBpy has read as ours."""

    def string(self, descriptor, value):
        return from_wire(value)

    def reference(self, descriptor, value):
        if value is None or isinstance(value, references.Reference):
            return value
        return references.from_text(self.orb.object_to_string(value))

    def any(self, descriptor, value):
        inner = descriptors.adopted(value.typecode()._d)
        return Any(inner, self.visit(inner, value.value()))

    def typecode(self, descriptor, value):
        return TypeCode(descriptors.adopted(value._d))

    def fixed(self, descriptor, value):
        return rare.fixed(str(value), *descriptor[1:])
