"""Types of an IDL file as descriptors: the words for basic ones, sequences, structs, unions and enums."""

from rtshell_lite import errors
from rtshell_lite.giop import descriptors
from rtshell_lite.giop.descriptors import FIXED, INDIRECT, OBJECT, SEQUENCE, STRING, VALUE, WSTRING
from rtshell_lite.data.idl import constants
from rtshell_lite.data.idl.scopes import DEEPEST, Entry, Scope

BASIC = {
    words: kind for kind, words in descriptors.NAMES.items() if kind > 1 and kind != descriptors.PRINCIPAL
}
MOST_DIGITS = 31  # of a number of type fixed
WORDS = ("unsigned", "short", "long", "float", "double", "char", "wchar", "boolean", "octet", "any")


def declarator(parser, descriptor, what):
    """(token, name, descriptor) of a name with its array bounds."""
    token = parser.token
    name = parser.name(what)
    lengths = []
    if _incomplete(parser, descriptor):
        raise parser.fault("of a type that is declared, but not defined yet", token)
    while parser.accept("["):
        lengths.append(_positive(parser))
        parser.take("]")
    for length in reversed(lengths):
        try:
            descriptor = parser.weigh(descriptors.array(descriptor, length), *parser.weight(descriptor))
        except errors.BadType as e:
            raise parser.fault(str(e), token)
    return token, name, descriptor


def _positive(parser):
    return _within(parser, 1, 2**32 - 1, "above 0")


def _within(parser, least, most, words):
    """The whole number that comes next. Raises BadIdl for one out of range, which `words` name."""
    token = parser.token
    value = constants.expression(parser)
    if not constants.is_whole(value) or not least <= value <= most:
        raise parser.fault("expected a number " + words, token)
    return value


# ---- types ----


def type_spec(parser, depth):
    """The descriptor of the type that comes next."""
    if depth > DEEPEST:
        raise parser.fault("nested too deep")
    token = parser.token
    if parser.is_word("struct", "union", "enum"):
        return constructed(parser, depth + 1)
    if parser.is_word("sequence"):
        return _sequence(parser, depth + 1)
    if parser.is_word("string", "wstring"):
        bound = _bound(parser) if parser.advance() and parser.is_mark("<") else 0
        return (STRING if token.word == "string" else WSTRING, bound)
    if parser.is_word("fixed"):
        return _fixed(parser)
    if parser.is_word(*WORDS):
        return _basic(parser)
    if parser.accept("Object"):
        return (OBJECT, "", token.word)  # without an id, as in stubs
    if parser.accept("ValueBase"):
        return (VALUE, "", token.word)
    return _named(parser)


def _basic(parser):
    words = parser.advance().word
    while words.split()[-1] in ("unsigned", "long") and parser.is_word("long", "short", "double"):
        longer = f"{words} {parser.token.word}"
        if longer not in BASIC and longer != "unsigned long long":
            break
        parser.advance()
        words = longer
    if words not in BASIC:
        raise parser.fault(f"not a type: {words}")
    return BASIC[words]


def _named(parser):
    token = parser.token
    if parser.names_corba():
        return _of_corba(parser)
    entry = parser.look_up()
    if entry.sort in ("struct", "type"):
        return entry.what
    if entry.sort == "interface" and entry.what.interface.kind:
        return (VALUE, entry.type_id, entry.name)
    if entry.sort == "interface":
        return (OBJECT, entry.type_id, entry.name)
    if entry.sort == "unknown":
        return (VALUE, entry.type_id or parser.new_id(entry.name), entry.name)
    raise parser.fault(f"not a type: {entry.name}", token)


def _of_corba(parser):
    """CORBA::TypeCode and the like, which no file declares."""
    parser.accept("::")
    parser.advance()
    parser.take("::")
    name = parser.plain()
    if name == "TypeCode":
        return descriptors.TYPECODE
    return (OBJECT, f"IDL:omg.org/CORBA/{name}:1.0", name)


def _bound(parser):
    """A bound with the bracket after it; `>>` is a shift there, as in omniidl."""
    parser.advance()
    value = _positive(parser)
    parser.take(">")
    return value


def _sequence(parser, depth):
    parser.advance()
    parser.take("<")
    element = type_spec(parser, depth)
    bound = 0
    if parser.is_mark(","):
        bound = _bound(parser)
    else:
        parser.take(">")
    return parser.weigh((SEQUENCE, element, bound), *parser.weight(element))


def _fixed(parser):
    """fixed<digits, scale>; omniidl has the same limits."""
    parser.advance()
    parser.take("<")
    digits = _within(parser, 1, MOST_DIGITS, "from 1 to %d" % MOST_DIGITS)
    parser.take(",")
    scale = _within(parser, 0, digits, "from 0 to %d" % digits)
    parser.take(">")
    return (FIXED, digits, scale)


# ---- structs, unions, enums ----


def constructed(parser, depth):
    """A struct, union or enum: its descriptor, None for one that is only announced."""
    if depth > DEEPEST:
        raise parser.fault("nested too deep")
    word = parser.advance().word
    token = parser.token
    if word == "enum":
        return _enum(parser, parser.name("an enum"), token)
    name = parser.name(f"a {word}")
    entry = _announced(parser, name, token)
    if parser.is_mark(";"):
        return None
    if entry.sort == "type":
        raise parser.twice(name, entry, token)
    if word == "struct" or not parser.is_word("switch"):
        parser.take("{")
    read = _struct if word == "struct" else _union
    descriptor = within(parser, entry, lambda: read(parser, entry, name, depth))
    parser.take("}")
    entry.sort = "type"
    entry.what = descriptor
    entry.hole[0] = descriptor
    parser.made[id(entry)] = (descriptors.type_id(descriptor), descriptor)
    return descriptor


def _announced(parser, name, token):
    """The Entry of a struct or union, made when it is first seen, with the id that it has then."""
    entry = parser.scope.names.get(name.lower())
    if entry is None or entry.name != name or entry.sort not in ("struct", "type") or entry.hole is None:
        hole = [None]
        entry = parser.declare(Entry(name, "struct", None, parser.new_id(name), hole, token), token)
        entry.what = (INDIRECT, hole)
        parser.announced.append(entry)
    return entry


def within(parser, entry, parse):
    """The result of parse() inside a scope of this name."""
    outer = parser.scope
    parser.scope = Scope(entry.name, outer, outer.inner_prefix(entry.name))
    entry.members = parser.scope
    try:
        return parse()
    finally:
        parser.scope = outer


def _struct(parser, entry, name, depth):
    pairs = members(parser, depth)
    if not pairs:
        raise parser.fault(f"a struct without members: {name}", entry.token)
    return parser.weighed(descriptors.struct(entry.type_id, name, pairs), [inner for _, inner in pairs])


def members(parser, depth):
    """Read the members of a struct up to its closing brace: [(name, descriptor)]. Raises BadIdl."""
    pairs = []
    names = set()
    while not parser.is_mark("}"):
        descriptor = type_spec(parser, depth + 1)
        while True:
            token, name, whole = declarator(parser, descriptor, "a member")
            _one_more(parser, name, names, token)
            pairs.append((name, whole))
            if not parser.accept(","):
                break
        parser.take(";")
    return pairs


def _one_more(parser, name, names, token):
    """Add a member's name to the set `names`. Raises BadIdl if it is there, in whatever case."""
    if name.lower() in names:
        raise parser.fault(f"a second member of the name {name}", token)
    names.add(name.lower())


def _union(parser, entry, name, depth):
    parser.take("switch")
    parser.take("(")
    token = parser.token
    switch = type_spec(parser, depth + 1)
    if descriptors.kind(descriptors.target(switch)) not in descriptors.LABELS:
        raise parser.fault(f"a union cannot be switched by {descriptors.words(switch)}", token)
    parser.take(")")
    parser.take("{")
    cases = []
    default = -1
    labels = set()
    names = set()
    while not parser.is_mark("}"):
        case_labels = _labels(parser, switch, labels)
        descriptor = type_spec(parser, depth + 1)
        token, member, whole = declarator(parser, descriptor, "a member")
        _one_more(parser, member, names, token)
        parser.take(";")
        for label in case_labels:
            if label is None:
                default = len(cases)
            cases.append((label, member, whole))
    if not cases:
        raise parser.fault(f"a union without members: {name}", entry.token)
    if default >= 0:
        _, member, whole = cases[default]
        cases[default] = (_unused(parser, switch, labels, entry.token), member, whole)
    union = descriptors.union(entry.type_id, name, switch, cases, default)
    return parser.weighed(union, [switch] + [whole for _, _, whole in cases])


def _labels(parser, switch, labels):
    """The labels before a member of a union, None for default; adds them to the set `labels`."""
    new_labels = []
    while parser.is_word("case", "default"):
        token = parser.advance()
        label = None
        if token.word == "case":
            label = constants.check(parser, switch, _label(parser, switch), token)
        if label in labels:
            raise parser.fault("the same case twice", token)
        new_labels.append(label)
        labels.add(label)
        parser.take(":")
    if not new_labels:
        raise parser.unexpected("case or default")
    return new_labels


def _label(parser, switch):
    """The value of a case label; items of the switch's enum need no scope."""
    inner = descriptors.target(switch)
    items = ()
    if descriptors.kind(inner) == descriptors.ENUM:
        items = descriptors.items(inner)
    if parser.token.kind == "name" and parser.scope.find(parser.token.word) is None:
        for item in items:
            if item._n == parser.token.word:
                parser.advance()
                return item
    return constants.expression(parser)


def _unused(parser, switch, labels, token):
    """The lowest label that no case has, for the default, as in omniidl."""
    inner = descriptors.target(switch)
    kind = descriptors.kind(inner)
    if kind in descriptors.RANGES:
        low, high = descriptors.RANGES[kind]
        candidates = range(low, high + 1)
    elif kind == descriptors.ENUM:
        candidates = descriptors.items(inner)
    elif kind == descriptors.BOOLEAN:
        candidates = (False, True)
    else:
        candidates = map(chr, range(256))
    for candidate in candidates:
        if candidate not in labels:
            return candidate
    raise parser.fault("a default that no value is left for", token)


def _enum(parser, name, token):
    parser.take("{")
    items = []
    tokens = []
    while True:
        tokens.append(parser.token)
        items.append(parser.name("an item"))
        if not parser.accept(",") or parser.is_mark("}"):  # a comma too many
            break
    parser.take("}")
    descriptor = parser.weigh(descriptors.enum(parser.new_id(name), name, items), 1, 1)
    parser.define(descriptor, name, token)
    for item, where in zip(descriptors.items(descriptor), tokens):
        parser.declare(Entry(item._n, "item", item), where)
    return descriptor


def _incomplete(parser, descriptor):
    descriptor = descriptors.plain(descriptor)
    return descriptors.kind(descriptor) == INDIRECT and descriptors.around(descriptor) is None
