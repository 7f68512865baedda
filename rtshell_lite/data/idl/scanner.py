"""IDL text in pieces: blanks, comments, directives, names, numbers, texts, characters and marks.

It goes from character to character: the module re takes longer to import than most files take to read.
"""

LONGEST_NUMBER = 100  # characters: long ones take quadratic time
LONGEST_CHAR = 9  # characters between quotes, as in '\x00000041'

DIGITS = frozenset("0123456789")
LETTERS = frozenset("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_")
WORD = LETTERS | DIGITS
_NUMBER = WORD | {"."}
_HEXADECIMAL = DIGITS | frozenset("ABCDEFabcdef")
BLANKS = frozenset(" \t\r\f\v\n\x1a")
_SINGLE_MARKS = frozenset("][(){},;=+-*%|&^~")
_OTHER_MARKS = frozenset("<>:/")  # which may begin others
_DOUBLE_MARKS = ("::", "<<", ">>")
_CONTINUED = ("\\\n", "\\\r\n")  # a line goes on in the next one


def piece(text, start):
    """(kind, end) of the piece that begins at `start`: space, comment, directive, string, char, number,
    name or mark; None and `start` for what cannot be read.
    """
    first = text[start]
    if first in BLANKS:
        return "space", run(text, start, BLANKS)
    if first in LETTERS:
        end = run(text, start, WORD)
        if text[start:end] == "L" and text[end : end + 1] in ('"', "'"):
            return _quoted(text, end)
        return "name", end
    if first in _SINGLE_MARKS:
        return "mark", start + 1
    if first in DIGITS or first == ".":
        return _number(text, start)
    if first in "\"'":
        return _quoted(text, start)
    if first == "#":
        return "directive", _directive_end(text, start)
    if text.startswith(_CONTINUED, start):
        return "space", text.index("\n", start) + 1
    if text.startswith(("//", "/*"), start):
        return _comment(text, start)
    if text.startswith(_DOUBLE_MARKS, start):
        return "mark", start + 2
    if first in _OTHER_MARKS:
        return "mark", start + 1
    return None, start


def skipped(text, start):
    """The same where a condition leaves the text out: space, comment, directive, string, and other for a
    single character, a quote without its end included.
    """
    first = text[start]
    if first == "#":
        return "directive", _directive_end(text, start)
    if text.startswith(("//", "/*"), start):
        return _comment(text, start)
    if first == '"' and _string_end(text, start):
        return _quoted(text, start)
    if first in BLANKS:
        return "space", run(text, start, BLANKS)
    return "other", start + 1


def words(text, start):
    """(kind, word, end) of each piece from `start` on that is no blank and no comment; the last has the kind
    None where what follows cannot be read.
    """
    while start < len(text):
        kind, end = piece(text, start)
        if kind not in ("space", "comment"):
            yield kind, text[start:end], end
        if kind is None:
            return
        start = end


def run(text, start, characters):
    """Where a run of some characters ends that begins at `start`."""
    for end in range(start, len(text)):
        if text[end] not in characters:
            return end
    return len(text)


def _comment(text, start):
    if text[start + 1] == "/":
        end = text.find("\n", start)
        if end < 0:
            end = len(text)
        return "comment", end
    end = text.find("*/", start + 2)
    if end < 0:
        return None, start
    return "comment", end + 2


def _quoted(text, start):
    """The string or char whose quote is at `start`."""
    if text[start] == '"':
        kind = "string"
        end = _string_end(text, start)
    else:
        kind = "char"
        end = _char_end(text, start)
    if end is None:
        return None, start
    return kind, end


def _string_end(text, start):
    end = start + 1
    while text[end : end + 1] not in ("", "\n"):
        if text[end] == '"':
            return end + 1
        if text[end] == "\\":
            end += 1
        end += 1
    return None


def _char_end(text, start):
    inner = start + 1
    if text[inner : inner + 1] == "\\":
        inner += 1
    end = text.find("'", inner + 1, inner + 1 + LONGEST_CHAR)
    if end < 0 or "\n" in text[start:end] or text[inner] == "'" and inner == start + 1:
        return None
    return end + 1


def _number(text, start):
    end = run(text, start, _NUMBER)
    has_exponent = text[end - 1] in "eE" and text[start : start + 2] not in ("0x", "0X")
    if has_exponent and text[end : end + 1] in ("+", "-"):
        end = run(text, end + 1, _NUMBER)
    if not _is_number(text[start:end]):
        return None, start
    return "number", end


def _is_number(word):
    if len(word) > LONGEST_NUMBER:
        return True  # which is refused where its value is wanted
    if word[:2] in ("0x", "0X"):
        return len(word) > 2 and _HEXADECIMAL.issuperset(word[2:])
    if word[-1] in "dD":  # a fixed-point number
        word = word[:-1]
    try:
        float(word)
    except ValueError:
        return False
    return "_" not in word


def _directive_end(text, start):
    """Where a # and its line end, which goes on in the next one after a backslash and within a comment."""
    end = start + 1
    while text[end : end + 1] not in ("", "\n"):
        if text.startswith("//", end):
            return end
        if text.startswith("/*", end):
            kind, after = _comment(text, end)
            if kind is None:
                return end
            end = after
        elif text.startswith(_CONTINUED, end):
            end = text.index("\n", end) + 1
        else:
            end += 1
    return end


def one_line(directive):
    """A directive without its comments and ends of lines."""
    for end in _CONTINUED:
        directive = directive.replace(end, " ")
    first, *commented = directive.split("/*")
    return " ".join([first] + [part.partition("*/")[2] for part in commented])


def leading_name(text):
    """The name that a text begins with, "" where it begins with none."""
    if text[:1] not in LETTERS:
        return ""
    return text[: run(text, 0, WORD)]


def is_whole(word):
    """Whether a word spells a whole number."""
    return word[:2] in ("0x", "0X") or word.isdigit()


def whole(word):
    """The whole number that a word spells as in C: 10, 0x0a, 012. Raises ValueError."""
    if len(word) > LONGEST_NUMBER:
        raise ValueError("too long a number")
    if word[:2] in ("0x", "0X"):
        return int(word, 16)
    if word[:1] == "0":
        return int(word, 8)
    return int(word)
