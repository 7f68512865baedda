"""The conditions of #if: numbers, defined(NAME), macros, ! && || comparisons and brackets."""

from rtshell_lite.data.idl import scanner
from rtshell_lite.text import printable

DEEPEST = 40  # conditions within conditions, brackets within brackets
MOST_WORDS = 200
_DOUBLE_MARKS = ("&&", "||", "==", "!=", "<=", ">=")
_MARKS = "!()<>+-"
_COMPARED = {
    "==": lambda a, b: a == b,
    "!=": lambda a, b: a != b,
    "<=": lambda a, b: a <= b,
    ">=": lambda a, b: a >= b,
    "<": lambda a, b: a < b,
    ">": lambda a, b: a > b,
}


class Open:
    """An #if whose #endif has not come: whether what follows is taken, whether a part has been taken or none
    may be, the line of the #if, and whether its #else has come.
    """

    def __init__(self, is_taken, is_decided, line):
        self.is_taken = is_taken
        self.is_decided = is_decided
        self.line = line
        self.has_else = False


def value(text, macros):
    """The number that a condition means, with macros, {name: tokens.Macro}.
    Raises ValueError with words for the user.
    """
    try:
        return _Condition(_words(text), macros).value()
    except (ValueError, IndexError):
        raise ValueError(f"a condition that cannot be read: #if {printable(text[:60])}")


def _words(text):
    """The names, numbers and marks of a condition."""
    words = []
    start = scanner.run(text, 0, scanner.BLANKS)
    while start < len(text) and len(words) <= MOST_WORDS:
        if text[start] in scanner.WORD:
            end = scanner.run(text, start, scanner.WORD)
        elif text.startswith(_DOUBLE_MARKS, start):
            end = start + 2
        elif text[start] in _MARKS:
            end = start + 1
        else:
            raise ValueError(text[start])
        words.append(text[start:end])
        start = scanner.run(text, end, scanner.BLANKS)
    if len(words) > MOST_WORDS:
        raise ValueError("too long")
    return words


class _Condition:
    """Works a condition out. Raises ValueError, IndexError for what cannot be."""

    def __init__(self, words, macros):
        self.words = words[::-1]
        self.macros = macros

    def value(self):
        value = self._either(0)
        if self.words:
            raise ValueError(self.words[-1])
        return value

    def _next(self, *marks):
        """The word that comes next if it is one of the marks, else None."""
        if self.words and self.words[-1] in marks:
            return self.words.pop()
        return None

    def _either(self, depth):
        value = self._both(depth)
        while self._next("||"):
            value = int(bool(self._both(depth)) or bool(value))
        return value

    def _both(self, depth):
        value = self._comparison(depth)
        while self._next("&&"):
            value = int(bool(self._comparison(depth)) and bool(value))
        return value

    def _comparison(self, depth):
        value = self._one(depth)
        mark = self._next(*_COMPARED)
        if mark is None:
            return value
        return int(_COMPARED[mark](value, self._one(depth)))

    def _one(self, depth):
        if depth > DEEPEST:
            raise ValueError("nested too deep")
        word = self.words.pop()
        if word == "(":
            value = self._either(depth + 1)
            self._close()
            return value
        if word == "!":
            return int(not self._one(depth + 1))
        if word == "-":
            return -self._one(depth + 1)
        if word == "+":
            return self._one(depth + 1)
        if word == "defined":
            return self._defined()
        if word[0] in scanner.LETTERS:
            return _of_macro(self.macros.get(word))
        return scanner.whole(word.rstrip("uUlL"))

    def _defined(self):
        bracket = self._next("(")
        name = self.words.pop()
        if bracket:
            self._close()
        return int(name in self.macros)

    def _close(self):
        if not self._next(")"):
            raise ValueError("without its )")


def _of_macro(macro):
    """The number that a macro means in a condition; 0, as in C, for anything else. Raises ValueError."""
    if macro is None or len(macro.body) != 1:
        return 0
    _, word = macro.body[0]
    return scanner.whole(word) if scanner.is_whole(word) else 0
