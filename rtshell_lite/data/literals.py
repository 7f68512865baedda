"""Values as people write them on a command line: `RTC.TimedLong({time}, 42)` as for rtshell, or JSON. Nothing
is evaluated.

rtshell passes such text to eval. Here a parser of our own reads names, calls, literals, lists and dicts;
Python's parser (ast) reads single literals only, for deeply nested text may crash it.

    value  = name "(" [argument {"," argument}] ")" | name | literal
           | "[" … "]" | "(" … ")" | "{" literal ":" value … "}"
    argument = [identifier "="] value
    literal = number | string | b"bytes" | True | False | NaN | Infinity | null
"""

import re

from rtshell_lite import errors
from rtshell_lite.data import build_value
from rtshell_lite.data.build_value import Call, Word
from rtshell_lite.net import loop
from rtshell_lite.text import literal, printable

DEEPEST = build_value.DEEPEST
LONGEST_NUMBER = 400  # digits
TIME = Word("{time}")
CLOSING = {"[": "]", "(": ")", "{": "}", "{{": "}}"}
LITERALS = {"True": True, "False": False, "true": True, "false": False, "None": None, "null": None}

_TOKEN = r"""\s*(?:
    (?P<string>[bBuUrR]{0,2}(?:"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*'))
  | (?P<time>\{time\})
  | (?P<number>[-+]?\s*(?:0[xX][0-9a-fA-F]+|(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?))(?![\w.])
  | (?P<name>-?[A-Za-z_]\w*(?:(?:\.|::)[A-Za-z_]\w*)*)
  | (?P<mark>\{\{|\}\}|[][(){},=:])
  | (?P<end>\Z))"""
_CALL = r"\s*[A-Za-z_][\w.:]*\s*\("


class Expression:
    """A value that a user wrote, for a type; `value(now)` makes it.

    `text` is the constructor form or JSON. `types` are the Types that names are looked up in; `type` is the
    Type that is wanted, None for the one that the text names. Raises BadValue, NoSuch.
    """

    def __init__(self, text, types, type=None):
        self.written, self.json = parse(text)
        called = isinstance(self.written, Call) and types is not None
        if type is None:
            if not called:
                raise errors.BadValue(
                    _short(text), "its type is not known; write it as RTC.TimedLong({time}, 42)"
                )
            type = types.named(self.written.name)
        elif called and not build_value.fits(self.written.name, build_value.target(type.descriptor)):
            raise errors.BadValue(
                types.named(self.written.name).name, f"not the type that is wanted, {type.name}"
            )
        self.type = type
        self.value(0)

    def value(self, now=None):
        """A new value; `now`, seconds since the epoch, replaces {time} and a time that was left out (None:
        the present).
        """
        if now is None:
            now = loop.wall()
        stamp = (int(now), int(now % 1 * 1e9))
        return build_value.build(self.type.descriptor, self.written, self.type.name, self.json, stamp)


def parse(text):
    """(what a text says, for `build_value.build`; whether it is JSON). Raises BadValue."""
    if not re.match(_CALL, text, re.ASCII):
        try:
            import json

            written = json.loads(
                text, parse_constant=lambda word: build_value.NUMBERS[word], parse_float=build_value.real,
                parse_int=_whole,
            )
            return written, True
        except ImportError:  # Debian's python3-minimal lacks it; numbers and the constructor form need none
            pass
        except (ValueError, RecursionError):
            if text.lstrip()[:1] == "{" and not text.lstrip().startswith("{time}"):
                raise errors.BadValue(_short(text), f"not JSON ({_fault_of(text)})")
    parser = _Parser(text)
    written = parser.value(DEEPEST)
    parser.take("end")
    return written, False


def _whole(word):
    if len(word) > LONGEST_NUMBER:
        raise ValueError(f"a number of {len(word)} digits")
    return int(word)


def _fault_of(text):
    import json

    try:
        json.loads(text, parse_int=_whole)
    except ValueError as e:
        return str(e)
    except RecursionError:
        return "nested too deep"


def _short(text):
    if len(text) > 60:
        text = text[:60] + "…"
    return printable(text) or "''"


class _Parser:
    def __init__(self, text):
        self.text = text
        self.at = 0
        # here, as rtprint need not pay for it
        self.match = re.compile(_TOKEN, re.VERBOSE | re.ASCII | re.DOTALL).match
        self.advance()

    def advance(self):
        """Go to the next token: set its kind, its word, and where it starts."""
        token = self.match(self.text, self.at)
        if token is None:
            self.kind = "error"
            self.word = ""
            rest = self.text[self.at :]
            self.start = self.at + len(rest) - len(rest.lstrip())
            raise self.fault("cannot be read")
        self.kind = token.lastgroup
        self.word = token.group(token.lastgroup)
        self.start = token.start(token.lastgroup)
        self.at = token.end()

    def fault(self, why):
        if self.text[self.start :].strip():
            there = _short(self.text[self.start : self.start + 20])
        else:
            there = "the end"
        return errors.BadValue(_short(self.text), f"column {self.start + 1}: {why}: {there}")

    def is_mark(self, *marks):
        return self.kind == "mark" and self.word in marks

    def take(self, *marks):
        """Skip one of the marks, or the end. Raises BadValue when something else is there."""
        is_end = self.kind == "end"
        if is_end and marks == ("end",):
            return
        if not self.is_mark(*marks) and marks[0] == "end":
            raise self.fault("expected the end")
        if not self.is_mark(*marks):
            raise self.fault(f"expected {marks[0]}")
        if not is_end:
            self.advance()

    def value(self, depth):
        if depth < 0:
            raise self.fault("nested too deep")
        kind = self.kind
        word = self.word
        if kind == "name":
            return self.named(depth)
        if kind in ("number", "string", "time"):
            if kind == "time":
                value = TIME
            elif kind == "number":
                value = self.number()
            else:
                value = self.string()
            self.advance()
            # as in "a" "b"
            while kind == "string" and self.kind == "string" and isinstance(value, type(self.string())):
                value += self.string()
                self.advance()
            return value
        if self.is_mark("[", "("):
            self.advance()
            return self.listed(CLOSING[word], depth)
        if self.is_mark("{", "{{"):
            return self.mapping(CLOSING[word], depth)
        raise self.fault("expected a value")

    def number(self):
        word = "".join(self.word.split())
        if len(word) > LONGEST_NUMBER:
            raise self.fault(f"a number of {len(word)} digits")
        try:
            return int(word, 0)
        except ValueError:
            return int(word) if word.lstrip("+-").isdigit() else build_value.real(word)

    def string(self):
        try:
            return literal(self.word)
        except ValueError as e:
            raise self.fault(str(e))

    def named(self, depth):
        name = self.word
        self.advance()
        if self.is_mark("("):
            self.advance()
            return self.call(name, depth)
        if name in LITERALS:
            return LITERALS[name]
        return Word({"inf": "Infinity", "nan": "NaN", "-inf": "-Infinity"}.get(name, name))

    def call(self, name, depth):
        positional = []
        keywords = {}
        while not self.is_mark(")"):
            start = self.at
            kind = self.kind
            word = self.word
            if kind == "name" and self.text[start:].lstrip()[:1] == "=":
                self.advance()
                self.take("=")
                if word in keywords:
                    raise self.fault(f"{word} is given twice")
                keywords[word] = self.value(depth - 1)
            elif keywords:
                raise self.fault("a value without a name after one with a name")
            else:
                positional.append(self.value(depth - 1))
            if not self.is_mark(")"):
                self.take(",")
        self.advance()
        return Call(name, positional, keywords)

    def listed(self, end, depth):
        values = []
        while not self.is_mark(end):
            values.append(self.value(depth - 1))
            if not self.is_mark(end):
                self.take(",")
        self.advance()
        return values

    def mapping(self, end, depth):
        members = {}
        self.advance()
        while not self.is_mark(end):
            if self.kind != "string":
                raise self.fault("expected the name of a member in quotes")
            name = self.string()
            self.advance()
            self.take(":")
            members[name] = self.value(depth - 1)
            if not self.is_mark(end):
                self.take(",")
        self.advance()
        return members
