"""Constant expressions of IDL (CORBA 3.0, 3.10.2): numbers, texts and items of enums."""

from rtshell_lite.giop import descriptors
from rtshell_lite.giop.descriptors import (
    BOOLEAN, CHAR, DOUBLE, ENUM, FLOAT, RANGES, STRING, WCHAR, WSTRING, kind
)
from rtshell_lite.data.idl import scanner
from rtshell_lite.text import literal

_ESCAPE = r"\\(?:x([0-9a-fA-F]{1,2})|.)"
DEEPEST = 50  # brackets within brackets
WIDEST = 128  # bits of an intermediate number
LEVELS = (("|",), ("^",), ("&",), ("<<", ">>"), ("+", "-"), ("*", "/", "%"))


def expression(parser, depth=0, level=0):
    """The value of the expression that comes next: an int, float, bool, str or item. Raises BadIdl."""
    if level == len(LEVELS):
        return _unary(parser, depth)
    value = expression(parser, depth, level + 1)
    while parser.is_mark(*LEVELS[level]):
        token = parser.advance()
        value = _operated(parser, token, value, expression(parser, depth, level + 1))
    return value


def _operated(parser, token, left, right):
    whole = is_whole(left) and is_whole(right)
    if not whole and not (
        all(is_whole(n) or isinstance(n, float) for n in (left, right)) and token.word in "+-*/"
    ):
        raise parser.fault(f"{token.word} does not go with these", token)
    try:
        value = OPERATORS[token.word](left, right)
    except (ZeroDivisionError, OverflowError, ValueError):
        raise parser.fault("cannot be worked out", token)
    if whole and abs(value) >> WIDEST:
        raise parser.fault("too large a number", token)
    return value


def is_whole(value):
    """Whether a value is a whole number; TRUE and FALSE are not."""
    return isinstance(value, int) and not isinstance(value, bool)


def _shift(shift):
    def shifted(a, b):
        if not 0 <= b < 64:
            raise ValueError(b)
        return shift(a, b)

    return shifted


def _quotient(a, b):
    """As C divides: towards zero."""
    if isinstance(a, float) or isinstance(b, float):
        return a / b
    return abs(a) // abs(b) * (1 if (a < 0) == (b < 0) else -1)


OPERATORS = {
    "|": lambda a, b: a | b,
    "^": lambda a, b: a ^ b,
    "&": lambda a, b: a & b,
    "<<": _shift(lambda a, b: a << b),
    ">>": _shift(lambda a, b: a >> b),
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": _quotient,
    "%": lambda a, b: a - b * _quotient(a, b),
}


def _unary(parser, depth):
    if depth > DEEPEST:
        raise parser.fault("nested too deep")
    if parser.is_mark("-", "+", "~"):
        token = parser.advance()
        value = _unary(parser, depth + 1)
        if not (is_whole(value) or isinstance(value, float) and token.word != "~"):
            raise parser.fault(f"{token.word} does not go with this", token)
        if token.word == "-":
            return -value
        if token.word == "~":
            return ~value
        return value
    if parser.accept("("):
        value = expression(parser, depth + 1)
        parser.take(")")
        return value
    return _literal(parser)


def _literal(parser):
    token = parser.token
    if token.kind == "number":
        parser.advance()
        return _number(parser, token)
    if token.kind == "string":
        words = ""
        while parser.token.kind == "string":
            words += text(parser, parser.advance())
        return words
    if token.kind == "char":
        parser.advance()
        character = text(parser, token)
        if len(character) != 1:
            raise parser.fault("not one character", token)
        return character
    if token.kind == "name" and token.word in ("TRUE", "FALSE"):
        parser.advance()
        return token.word == "TRUE"
    if token.kind == "name" or parser.is_mark("::"):
        entry = parser.look_up()
        if entry.sort not in ("constant", "item"):
            raise parser.fault(f"not a constant: {token.word}", token)
        return entry.what
    raise parser.fault("expected a constant")


def _number(parser, token):
    word = token.word
    if len(word) > scanner.LONGEST_NUMBER:
        raise parser.fault("too long a number", token)
    try:
        if scanner.is_whole(word):
            return scanner.whole(word)
        return float(word.rstrip("dD"))
    except ValueError:
        raise parser.fault(f"not a number: {word}", token)


def text(parser, token):
    """The text of a literal; apart from a few escapes, Python spells it as C and IDL do."""
    word = token.word[1:] if token.word[0] == "L" else token.word
    try:
        return literal(_of_python(word))
    except ValueError as e:
        raise parser.fault(str(e), token)


def _of_python(word):
    """A literal with escapes of C as Python spells it."""
    if "\\" not in word:
        return word
    import re  # few have an escape, and it takes long

    return re.sub(_ESCAPE, _python_escape, word, flags=re.DOTALL)


def _python_escape(match):
    """An escape of C as Python spells it: it has no \\?, and needs two digits after \\x."""
    if match.group() == "\\?":
        return "?"
    if match.group(1):
        return f"\\x{int(match.group(1), 16):02x}"
    return match.group()


def check(parser, descriptor, value, token):
    """The value of a constant of this type. Raises BadIdl when it does not fit."""
    switch = descriptors.target(descriptor)
    sort = kind(switch)
    if sort in RANGES and is_whole(value):
        low, high = RANGES[sort]
        if value < low and value + 2 * (high + 1) > high and low == 0:  # ~0 for an unsigned type
            value += high + 1
        if low <= value <= high:
            return value
        raise parser.fault("out of range for %s: %d" % (descriptors.words(descriptor), value), token)
    if sort in (FLOAT, DOUBLE) and (isinstance(value, float) or is_whole(value)):
        return float(value)
    if sort == BOOLEAN and isinstance(value, bool):
        return value
    is_character = sort in (CHAR, WCHAR) and isinstance(value, str) and len(value) == 1
    if is_character or sort in (STRING, WSTRING) and isinstance(value, str):
        return value
    if sort == ENUM and value in descriptors.items(switch):
        return value
    raise parser.fault(f"not a constant of type {descriptors.words(descriptor)}", token)
