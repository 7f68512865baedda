"""Operations and attributes in the body of an interface (CORBA 3.0, 3.12, 3.13), from tokens to
interfaces.py.

One that cannot be read, as it names what is not declared, fails itself and not its file: what is wrong is
its `fault`.
"""

from rtshell_lite import errors
from rtshell_lite.data.idl import constants, types
from rtshell_lite.data.idl.interfaces import Attribute, Operation, Parameter

DIRECTIONS = ("in", "out", "inout")
CLAUSES = ("raises", "getraises", "setraises")
VOID = 1  # the TCKind of what has no type


def export(parser, interface, depth):
    """Read one operation, or one line of attributes, without its semicolon."""
    start = parser.state()
    is_attribute = parser.is_word("attribute", "readonly")
    try:
        if is_attribute:
            _attributes(parser, interface, depth)
        else:
            interface.operations.append(_operation(parser, depth))
        if not parser.is_mark(";"):
            raise parser.unexpected(";")
    except errors.BadIdl as e:
        parser.go_back(start)
        _unreadable(parser, interface, is_attribute, str(e))


def _unreadable(parser, interface, is_attribute, fault):
    """Skip what could not be read; only its name is kept, or its names."""
    skipped = parser.skip()
    for name in _names(skipped):
        if is_attribute:
            members = interface.attributes
            member = Attribute(name, VOID, skipped[0].word == "readonly")
        else:
            members = interface.operations
            member = Operation(name)
        member.fault = fault
        members[:] = [other for other in members if other.name != name] + [member]


def _names(tokens):
    """The names that an operation or a line of attributes declares: those before a comma or its end."""
    names = []
    name = ""
    depth = 0
    for token in tokens:
        if token.word in CLAUSES or token.kind == "mark" and token.word in "(;":
            return names + [name]
        if token.kind == "name":
            name = token.word.lstrip("_")
        elif token.word == "," and not depth:
            names.append(name)
        depth += (token.word == "<") - (token.word == ">")
    return names


def _operation(parser, depth):
    oneway = parser.accept("oneway")
    result = None if parser.accept("void") else types.type_spec(parser, depth)
    operation = Operation(parser.name("an operation"), result, oneway=oneway)
    parser.take("(")
    while not parser.is_mark(")"):
        operation.parameters.append(_parameter(parser, operation, depth))
        if not parser.is_mark(")"):
            parser.take(",")
    parser.take(")")
    operation.raises = _raised(parser, "raises")
    if parser.accept("context"):
        operation.contexts = _texts(parser)
    return operation


def _parameter(parser, operation, depth):
    if not parser.is_word(*DIRECTIONS):
        raise parser.unexpected("in, out or inout")
    direction = parser.advance().word
    descriptor = types.type_spec(parser, depth)
    token = parser.token
    name = parser.name("a parameter")
    if name.lower() in [parameter.name.lower() for parameter in operation.parameters]:
        raise parser.fault(f"a second parameter of the name {name}", token)
    return Parameter(direction, name, descriptor)


def _attributes(parser, interface, depth):
    readonly = parser.accept("readonly")
    parser.take("attribute")
    descriptor = types.type_spec(parser, depth)
    names = [parser.name("an attribute")]
    while parser.accept(","):
        names.append(parser.name("an attribute"))
    raises = _raised(parser, "raises" if readonly else "getraises")
    set_raises = [] if readonly else _raised(parser, "setraises")
    for name in names:
        interface.attributes.append(Attribute(name, descriptor, readonly, raises, set_raises))


def _raised(parser, word):
    """The types of the exceptions in a clause that begins with `word`, if it comes next."""
    exceptions = []
    if not parser.accept(word):
        return exceptions
    parser.take("(")
    while True:
        token = parser.token
        entry = parser.look_up()
        if entry.sort != "exception":
            raise parser.fault(f"not an exception: {entry.name}", token)
        exceptions.append(entry.what)
        if not parser.accept(","):
            break
    parser.take(")")
    return exceptions


def _texts(parser):
    parser.take("(")
    texts = []
    while not parser.is_mark(")"):
        if parser.token.kind != "string":
            raise parser.fault("expected a text in quotes")
        texts.append(constants.text(parser, parser.advance()))
        if not parser.is_mark(")"):
            parser.take(",")
    parser.take(")")
    return texts
