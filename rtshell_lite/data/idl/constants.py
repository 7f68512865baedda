"""Constant expressions of IDL (CORBA 3.0, 3.10.2): numbers, texts and items of enums worked out with nothing evaluated."""
from rtshell_lite.corba import descriptors
from rtshell_lite.corba.descriptors import BOOLEAN, CHAR, DOUBLE, ENUM, FLOAT, RANGES, STRING, WCHAR, WSTRING, kind
from rtshell_lite.data.idl import tokens
from rtshell_lite.text import literal

DEEPEST = 50  # brackets within brackets
WIDEST = 128  # bits of a number on the way
LEVELS = (("|",), ("^",), ("&",), ("<<", ">>"), ("+", "-"), ("*", "/", "%"))


def expression(parser, depth=0, level=0):
    """The value of the expression that comes next: an int, float, bool, str or item. Raises BadIdl."""
    if level == len(LEVELS):
        return _unary(parser, depth)
    found = expression(parser, depth, level + 1)
    while parser.is_mark(*LEVELS[level]):
        token = parser.advance()
        found = _worked_out(parser, token, found, expression(parser, depth, level + 1))
    return found


def _worked_out(parser, token, one, other):
    whole = is_whole(one) and is_whole(other)
    if not whole and not (all(is_whole(n) or isinstance(n, float) for n in (one, other)) and token.word in "+-*/"):
        raise parser.fault(f"{token.word} does not go with these", token)
    try:
        found = {"|": _or, "^": _xor, "&": _and, "<<": _left, ">>": _right, "+": _sum, "-": _difference, "*": _product,
                 "/": _quotient, "%": _rest}[token.word](one, other)
    except (ZeroDivisionError, OverflowError, ValueError):
        raise parser.fault("cannot be worked out", token)
    if whole and abs(found) >> WIDEST:
        raise parser.fault("too large a number", token)
    return found


def is_whole(value):
    """True for a whole number; TRUE and FALSE are none."""
    return isinstance(value, int) and not isinstance(value, bool)


def _or(a, b):
    return a | b


def _xor(a, b):
    return a ^ b


def _and(a, b):
    return a & b


def _left(a, b):
    if not 0 <= b < 64:
        raise ValueError(b)
    return a << b


def _right(a, b):
    if not 0 <= b < 64:
        raise ValueError(b)
    return a >> b


def _sum(a, b):
    return a + b


def _difference(a, b):
    return a - b


def _product(a, b):
    return a * b


def _quotient(a, b):
    """As C divides: towards zero."""
    if isinstance(a, float) or isinstance(b, float):
        return a / b
    return abs(a) // abs(b) * (1 if (a < 0) == (b < 0) else -1)


def _rest(a, b):
    return a - b * _quotient(a, b)


def _unary(parser, depth):
    if depth > DEEPEST:
        raise parser.fault("nested too deep")
    if parser.is_mark("-", "+", "~"):
        token = parser.advance()
        found = _unary(parser, depth + 1)
        if not (is_whole(found) or isinstance(found, float) and token.word != "~"):
            raise parser.fault(f"{token.word} does not go with this", token)
        return -found if token.word == "-" else ~found if token.word == "~" else found
    if parser.is_mark("("):
        parser.advance()
        found = expression(parser, depth + 1)
        parser.take(")")
        return found
    return _literal(parser)


def _literal(parser):
    token = parser.token
    if token.kind == "number":
        parser.advance()
        return _number(parser, token)
    if token.kind == "string":
        found = ""
        while parser.token.kind == "string":
            found += text(parser, parser.advance())
        return found
    if token.kind == "char":
        parser.advance()
        found = text(parser, token)
        if len(found) != 1:
            raise parser.fault("not one character", token)
        return found
    if token.kind == "name" and token.word in ("TRUE", "FALSE"):
        parser.advance()
        return token.word == "TRUE"
    if token.kind == "name" or parser.is_mark("::"):
        found = parser.look_up()
        if found.sort not in ("constant", "item"):
            raise parser.fault(f"not a constant: {token.word}", token)
        return found.what
    raise parser.fault("expected a constant")


def _number(parser, token):
    word = token.word
    if len(word) > tokens.LONGEST_NUMBER:
        raise parser.fault("too long a number", token)
    try:
        return tokens.whole(word) if tokens.is_whole(word) else float(word.rstrip("dD"))
    except ValueError:
        raise parser.fault(f"not a number: {word}", token)


def text(parser, token):
    """What a literal of text says; IDL spells it as C does, and so, but for a few escapes, does Python."""
    word = token.word[1:] if token.word[0] == "L" else token.word
    try:
        return literal(word.replace("\\?", "?"))
    except ValueError as e:
        raise parser.fault(str(e), token)


def check(parser, descriptor, value, token):
    """The value of a constant of this type. Raises BadIdl when it does not fit."""
    switch = descriptors.target(descriptor)
    sort = kind(switch)
    if sort in RANGES and is_whole(value):
        low, high = RANGES[sort]
        if value < low and value + 2 * (high + 1) > high and low == 0:  # ~0 for an unsigned one
            value += high + 1
        if low <= value <= high:
            return value
        raise parser.fault("out of range for %s: %d" % (descriptors.words(descriptor), value), token)
    if sort in (FLOAT, DOUBLE) and (isinstance(value, float) or is_whole(value)):
        return float(value)
    if sort == BOOLEAN and isinstance(value, bool):
        return value
    if sort in (CHAR, WCHAR) and isinstance(value, str) and len(value) == 1 or sort in (STRING, WSTRING) and isinstance(value, str):
        return value
    if sort == ENUM and value in descriptors.items(switch):
        return value
    raise parser.fault(f"not a constant of type {descriptors.words(descriptor)}", token)
