"""Data types as descriptors, the tuples that omniORBpy marshals by (omniORB.tcInternal): their parts, their
words, their limits.

a number                                    a basic type, its CORBA::TCKind
(STRING | WSTRING, bound)                   0: unbounded
(SEQUENCE, element, bound)
(ARRAY, element, length)                    arrays of arrays for more dimensions
(ALIAS, id, name, target)
(STRUCT, class, id, name, member, type, …)  the class is called with the members
(ENUM, id, name, items)                     items with _n, the name, and _v, the number
(UNION, class, id, name, discriminator type, index of the default or -1, cases, default case or None, {label:
                                            case}) a case is (label, member, type); the class is called with
                                            label and value
(INDIRECT, [struct or union])               a type inside itself
(EXCEPTION, class, id, name, member, type, …)
(FIXED, digits, scale)
(OBJECT, id, name)                          a reference to an object of this interface
(VALUE, id, name)                           a valuetype, native, abstract or local interface: never sent
"""

from rtshell_lite import errors, records
from rtshell_lite.text import is_identifier

(
    SHORT, LONG, USHORT, ULONG, FLOAT, DOUBLE, BOOLEAN, CHAR, OCTET, ANY, TYPECODE, PRINCIPAL, OBJECT,
    STRUCT, UNION, ENUM, STRING, SEQUENCE, ARRAY, ALIAS, EXCEPTION, LONGLONG, ULONGLONG, LONGDOUBLE, WCHAR,
    WSTRING, FIXED,
) = range(2, 29)
VALUE = 29
INDIRECT = -1
_INDIRECT = 0xFFFFFFFF  # the same in TypeCodes that omniORBpy has read

NAMES = {
    SHORT: "short",
    LONG: "long",
    USHORT: "unsigned short",
    ULONG: "unsigned long",
    FLOAT: "float",
    DOUBLE: "double",
    BOOLEAN: "boolean",
    CHAR: "char",
    OCTET: "octet",
    LONGLONG: "long long",
    ULONGLONG: "unsigned long long",
    WCHAR: "wchar",
    ANY: "any",
    TYPECODE: "TypeCode",
    PRINCIPAL: "Principal",
    LONGDOUBLE: "long double",
    0: "null",
    1: "void",
}
# what we encode
VALUES = (SHORT, LONG, USHORT, ULONG, FLOAT, DOUBLE, BOOLEAN, CHAR, OCTET, LONGLONG, ULONGLONG, WCHAR)
RANGES = {
    SHORT: (-(2**15), 2**15 - 1),
    USHORT: (0, 2**16 - 1),
    LONG: (-(2**31), 2**31 - 1),
    ULONG: (0, 2**32 - 1),
    LONGLONG: (-(2**63), 2**63 - 1),
    ULONGLONG: (0, 2**64 - 1),
    OCTET: (0, 255),
}
# and what we encode of others
BUILT = (STRUCT, UNION, ENUM, STRING, WSTRING, SEQUENCE, ARRAY, ALIAS, INDIRECT)
# what a union may be switched by
LABELS = (SHORT, USHORT, LONG, ULONG, LONGLONG, ULONGLONG, BOOLEAN, CHAR, ENUM)
# What the methods for each kind are called: those of a Visitor, and of cdr.Maker behind read_ and write_.
FORMS = {
    **dict.fromkeys(RANGES, "integer"),
    FLOAT: "real",
    DOUBLE: "real",
    LONGDOUBLE: "longdouble",
    BOOLEAN: "boolean",
    CHAR: "char",
    WCHAR: "wchar",
    STRING: "string",
    WSTRING: "wstring",
    FIXED: "fixed",
    ENUM: "enum",
    SEQUENCE: "sequence",
    ARRAY: "array",
    STRUCT: "struct",
    EXCEPTION: "exception",
    UNION: "union",
    ALIAS: "alias",
    INDIRECT: "indirect",
    OBJECT: "reference",
    ANY: "any",
    TYPECODE: "typecode",
    PRINCIPAL: "principal",
    VALUE: "value",
}
# where the id of a type is; its name comes after it
_ID = {STRUCT: 2, UNION: 2, EXCEPTION: 2, ALIAS: 1, ENUM: 1, OBJECT: 1, VALUE: 1}

DEEPEST = 64  # types inside types
LARGEST = 20000  # types within a type
LONGEST = 1 << 24  # elements of an array, all dimensions together


# ---- values ----


class Struct:
    """A value of a struct whose class no stub gives: an attribute for each member."""

    _members = ()  # type: tuple
    _NP_RepositoryId = ""

    def __init__(self, *values):
        if len(values) != len(self._members):
            raise TypeError(f"{type(self).__name__} takes {len(self._members)} members")
        self.__dict__.update(zip(self._members, values))

    def __repr__(self):
        members = ", ".join(f"{name}={getattr(self, name)!r}" for name in self._members)
        return f"{dotted(self._NP_RepositoryId)}({members})"


class Union:
    """A value of a union whose class no stub gives: its discriminator `_d` and its value `_v`."""

    def __init__(self, label, value):
        self._d = label
        self._v = value


class Case(tuple):
    """A case of a union: its label, the member's name and type."""

    __slots__ = ()
    label, member, type = [records.item(index) for index in range(3)]


class Item:
    """A value of an enum that no stub gives: its name `_n`, its number `_v`, the id of its enum."""

    def __init__(self, name, number, parent):
        self._n = name
        self._v = number
        self._parent_id = parent

    def __str__(self):
        return self._n

    __repr__ = __str__

    def __eq__(self, other):
        return getattr(other, "_parent_id", None) == self._parent_id and other._v == self._v

    def __hash__(self):
        return hash((self._parent_id, self._v))


# ---- making ----


def struct(type_id, name, members):
    """The descriptor of a struct with a class of its own; `members`: (name, descriptor) pairs."""
    names = tuple(member for member, _ in members)
    new_class = type(name, (Struct,), {"_NP_RepositoryId": type_id, "_members": names})
    return (STRUCT, new_class, type_id, name) + tuple(part for member in members for part in member)


def exception(type_id, name, members):
    """The descriptor of an exception, as that of a struct; it may have no members."""
    return (EXCEPTION,) + struct(type_id, name, members)[1:]


def union(type_id, name, switched_by, given, default=-1):
    """The descriptor of a union with a class of its own;
    `given`: (label, member, descriptor) triples, `default` an index.
    """
    given = tuple(Case(case) for case in given)
    other = given[default] if default >= 0 else None
    by_label = {case.label: case for case in given if case is not other}
    members = {label: case.member for label, case in by_label.items()}
    attributes = {"_NP_RepositoryId": type_id, "_def_m": other and other.member, "_d_to_m": members}
    new_class = type(name, (Union,), attributes)
    return (UNION, new_class, type_id, name, switched_by, default, given, other, by_label)


def enum(type_id, name, items):
    """The descriptor of an enum; `items`: names in their order."""
    return (ENUM, type_id, name, tuple(Item(item, number, type_id) for number, item in enumerate(items)))


def renamed(descriptor, type_id):
    """The same type by another repository id: a struct, exception, union, enum or alias."""
    if kind(descriptor) == EXCEPTION:
        return exception(type_id, descriptor[3], members(descriptor))
    if kind(descriptor) == STRUCT:
        return struct(type_id, descriptor[3], members(descriptor))
    if kind(descriptor) == UNION:
        given = cases(descriptor)
        return union(type_id, descriptor[3], discriminator(descriptor), given, default_index(descriptor))
    # the items of an enum keep the id that they were made with
    return (descriptor[0], type_id) + descriptor[2:]


# ---- reading ----


def kind(descriptor):
    """The TCKind of a descriptor."""
    return descriptor[0] if isinstance(descriptor, tuple) else descriptor


def element(descriptor):
    """The type of the elements of a sequence or an array."""
    return descriptor[1]


def length(descriptor):
    """How many elements an array has, or a sequence may have (0: any number)."""
    return descriptor[2]


def bound(descriptor):
    """How many octets of UTF-8 a string, or characters a wstring, may have; 0: any number."""
    return descriptor[1]


def factory(descriptor):
    """The class of the values of a struct or a union: called with the members, or with label and value."""
    return descriptor[1]


def items(descriptor):
    """The items of an enum, in their order."""
    return descriptor[3]


def aliased(descriptor):
    """What an alias is another name of."""
    return descriptor[3]


def around(descriptor):
    """The struct or union around an indirection;
    None while it is still being made, text (its id) in a peer's TypeCode.
    """
    return descriptor[1][0]


def discriminator(descriptor):
    """The type that a union is switched by."""
    return descriptor[4]


def default_index(descriptor):
    """Which case of a union is its default; -1: none."""
    return descriptor[5]


def cases(descriptor):
    """The Cases of a union."""
    return [Case(case) for case in descriptor[6]]


def default_case(descriptor):
    """The Case for labels that have none of their own, or None."""
    return descriptor[7] and Case(descriptor[7])


def cases_by_label(descriptor):
    """{label: Case} of a union, without its default."""
    return {label: Case(case) for label, case in descriptor[8].items()}


def target(descriptor):
    """The type that a descriptor means, without its aliases and indirections."""
    while kind(descriptor) in (ALIAS, INDIRECT):
        descriptor = aliased(descriptor) if kind(descriptor) == ALIAS else around(descriptor)
    return descriptor


def plain(descriptor):
    """The type that a descriptor means, without its aliases."""
    while kind(descriptor) == ALIAS:
        descriptor = aliased(descriptor)
    return descriptor


def members(descriptor):
    """The members of a struct: (name, descriptor) pairs."""
    return list(zip(descriptor[4::2], descriptor[5::2]))


def type_id(descriptor):
    """The repository id of a named type, '' for others."""
    if kind(descriptor) == INDIRECT:
        descriptor = around(descriptor)
    return descriptor[_ID[kind(descriptor)]] if kind(descriptor) in _ID else ""


def name(descriptor):
    """The name by which people know a type: RTC.TimedLong, or words for one without a name."""
    return dotted(type_id(descriptor)) if type_id(descriptor) else words(descriptor)


def dotted(identifier):
    """RTC.TimedLong of IDL:RTC/TimedLong:1.0."""
    parts = identifier.split(":")
    if len(parts) > 2 and parts[0] == "IDL":
        return parts[1].replace("/", ".")
    return identifier


def words(descriptor):
    """The IDL spelling of a type inside its module."""
    if not isinstance(descriptor, tuple):
        return NAMES.get(descriptor, f"type {descriptor}")
    sort = descriptor[0]
    if sort in (STRING, WSTRING):
        name = "string" if sort == STRING else "wstring"
        return "%s<%d>" % (name, bound(descriptor)) if bound(descriptor) else name
    if sort == SEQUENCE:
        limit = ", %d" % length(descriptor) if length(descriptor) else ""
        return f"sequence<{words(element(descriptor))}{limit}>"
    if sort == ARRAY:
        return _array_words(descriptor)
    if sort in _ID:
        return descriptor[_ID[sort] + 1]
    if sort == INDIRECT:
        return words(around(descriptor))
    if sort == FIXED:
        return "fixed"
    return "type %d" % sort


def _array_words(descriptor):
    lengths = ""
    while kind(descriptor) == ARRAY:
        lengths += "[%d]" % length(descriptor)
        descriptor = element(descriptor)
    return words(descriptor) + lengths


def walk(descriptor, where):
    """All types within a type, each with its place: (RTC.TimedLong.data, LONG)."""
    todo = [(where, descriptor)]
    seen = set()
    while todo:
        where, inner = todo.pop()
        yield where, inner
        if isinstance(inner, tuple) and id(inner) not in seen:
            seen.add(id(inner))
            todo += _within(inner, where)


def _within(descriptor, where):
    sort = descriptor[0]
    if sort in (SEQUENCE, ARRAY):
        return [(where + "[]", element(descriptor))]
    if sort == ALIAS:
        return [(where, aliased(descriptor))]
    if sort in (STRUCT, EXCEPTION):
        return [(f"{where}.{member}", inner) for member, inner in members(descriptor)]
    if sort == UNION:
        inner = [(f"{where}.{case.member}", case.type) for case in cases(descriptor)]
        return [(where, discriminator(descriptor))] + inner
    return []


class Visitor:
    """Does something for each kind of types: a class has a method for each form that it knows, by its name
    in FORMS, and `other` for the rest. Aliases and indirections are followed.
    """

    def visit(self, descriptor, *args):
        """What the method for this descriptor, called with it and with `args`, returns."""
        return self.method(descriptor)(descriptor, *args)

    def method(self, descriptor):
        """What visits this descriptor."""
        sort = descriptor[0] if isinstance(descriptor, tuple) else descriptor
        return getattr(self, FORMS.get(sort, "other"), None) or self.other

    def other(self, descriptor, *args):
        raise NotImplementedError

    def alias(self, descriptor, *args):
        return self.visit(target(descriptor), *args)

    indirect = alias


# ---- taking what others made ----


def adopted(descriptor, find=None, classes=False):
    """A descriptor from elsewhere (a TypeCode of a peer, stubs of a user), checked.

    `find` gives the descriptor for a repository id that an indirection names. With `classes`, those of the
    stubs are kept; the one that omniORB knows for an id may not have the members that a peer's TypeCode says.
    Raises BadType.
    """
    return Adoption(find, classes).take(descriptor, DEEPEST)


class Adoption:
    # `most`: types and items; each struct and union counts as `weight`
    def __init__(self, find=None, classes=False, most=LARGEST, weight=1):
        self.find = find
        self.classes = classes
        self.most = most
        self.weight = weight
        self.count = 0
        self.sequences = 0
        self.taking = set()  # identities of the structs and unions around this place
        self.open = {}  # id of each struct or union around this place → its hole, and the sequences around it

    def take(self, descriptor, depth):
        sort = kind(descriptor)
        if sort == _INDIRECT:
            sort = INDIRECT
        if sort == ENUM:
            self.count += len(items(descriptor))
        elif sort in (STRUCT, UNION):
            self.count += self.weight
        else:
            self.count += 1
        if depth < 0 or self.count > self.most:
            raise errors.BadType(name(descriptor), "is nested too deep or too large")
        if not isinstance(descriptor, tuple):
            return descriptor
        if sort in (STRING, WSTRING, OBJECT, FIXED):
            return tuple(descriptor)
        if sort == ARRAY:
            check_length(sort, length(descriptor))
            return array(self.take(element(descriptor), depth - 1), length(descriptor))
        if sort == SEQUENCE:
            check_length(sort, length(descriptor))
            self.sequences += 1
            inner = self.take(element(descriptor), depth - 1)
            self.sequences -= 1
            return (SEQUENCE, inner, length(descriptor))
        if sort == ALIAS:
            return (ALIAS, descriptor[1], descriptor[2], self.take(aliased(descriptor), depth - 1))
        if sort == ENUM:
            return self.enumeration(descriptor)
        if sort == INDIRECT:
            return self.indirection(around(descriptor), depth)
        if sort not in (STRUCT, UNION):
            raise errors.BadType(words(descriptor), "no type for data")
        if id(descriptor) in self.taking:  # by way of an alias or a sequence that an indirection names
            return self.indirection(descriptor, depth)
        self.taking.add(id(descriptor))
        hole = [None]
        before = self.open.get(descriptor[2])
        self.open[descriptor[2]] = hole, self.sequences
        hole[0] = self.structure(descriptor, depth) if sort == STRUCT else self.choice(descriptor, depth)
        self.open[descriptor[2]] = before  # of another one of that id, around this one
        self.taking.discard(id(descriptor))
        return hole[0]

    def structure(self, descriptor, depth):
        given = [
            (check_identifier(member), self.take(inner, depth - 1)) for member, inner in members(descriptor)
        ]
        check_members(descriptor)
        if self.classes:
            return (STRUCT,) + descriptor[1:4] + tuple(part for member in given for part in member)
        return struct(descriptor[2], check_identifier(descriptor[3]), given)

    def choice(self, descriptor, depth):
        switch = self.take(discriminator(descriptor), depth - 1)
        taken = [
            (
                label(switch, getattr(case.label, "_v", case.label)),
                check_identifier(case.member),
                self.take(case.type, depth - 1),
            )
            for case in cases(descriptor)
        ]
        return union(descriptor[2], check_identifier(descriptor[3]), switch, taken, default_index(descriptor))

    def enumeration(self, descriptor):
        taken = tuple(items(descriptor))
        if not taken or any(item._v != number for number, item in enumerate(taken)):
            raise errors.BadType(name(descriptor), "an enum needs items")
        for item in taken:
            check_identifier(item._n)
        return (ENUM, descriptor[1], descriptor[2], taken)

    def indirection(self, inner, depth):
        if kind(inner) in (ALIAS, SEQUENCE, ARRAY):
            return self.take(inner, depth - 1)
        name = inner if isinstance(inner, str) else None
        if isinstance(inner, tuple) and len(inner) > 2:
            name = inner[2]
        if self.open.get(name):
            hole, sequences = self.open[name]
            if sequences == self.sequences:
                raise errors.BadType(dotted(name), "contains itself")
            return (INDIRECT, hole)
        descriptor = inner if isinstance(inner, tuple) else None
        if descriptor is None and self.find and name:
            descriptor = self.find(name)
        if descriptor is None or kind(descriptor) == INDIRECT:
            raise errors.BadType(dotted(str(name)), "is used, but nowhere defined")
        return self.take(descriptor, depth - 1)


def check_identifier(word):
    """`word` when it can name a member. Raises BadType."""
    # these distinguish unions and items
    if not isinstance(word, str) or not _is_identifier(word) or word in ("_d", "_n", "_v"):
        raise errors.BadType(repr(word), "not an identifier")
    return word


def _is_identifier(word):
    """Whether a word is an identifier of IDL, or one with the _ that marks a keyword."""
    if word.startswith("_"):
        word = word[1:]
    return is_identifier(word) and not word.startswith("_")


def check_members(descriptor):
    """Raise BadType when the members of a struct are none, or two have one name."""
    names = [member for member, _ in members(descriptor)]
    if not names or len(set(names)) < len(names):
        raise errors.BadType(name(descriptor), "a struct needs members, each with a name of its own")


def label(switched_by, value):
    """A label of a union as values have it, from a number or a character. Raises BadType."""
    switch = target(switched_by)
    if kind(switch) not in LABELS:
        raise errors.BadType("a union", f"cannot be switched by {words(switched_by)}")
    if kind(switch) == CHAR:
        if isinstance(value, str) and len(value) == 1:
            return value
    elif isinstance(value, int) and kind(switch) != ENUM:
        return value
    elif isinstance(value, int) and 0 <= value < len(items(switch)):
        return items(switch)[value]
    raise errors.BadType("a union", f"no label: {value!r}")


def check_length(sort, count):
    """Raise BadType for what cannot be the length of an ARRAY, or the bound of a SEQUENCE (0: none)."""
    if not isinstance(count, int) or not 0 <= count < 2**32 or sort == ARRAY and not 0 < count <= LONGEST:
        what = "sequence" if sort == SEQUENCE else "array"
        raise errors.BadType(f"a {what} of {count!r} elements", "out of bounds")


def array(elements, count):
    """The descriptor of an array. Raises BadType for one that no memory holds."""
    total = count
    inner = target(elements)
    while kind(inner) == ARRAY:
        total = total * length(inner)
        inner = target(element(inner))
    if not 0 < total <= LONGEST:
        raise errors.BadType("an array of %d elements" % total, "out of bounds")
    return (ARRAY, elements, count)
