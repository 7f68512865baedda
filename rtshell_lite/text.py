"""Text as people see it: off the wire and back, terminal-safe and reversible, in columns, in colour,
as JSON.
"""

import itertools
import os
import sys

from rtshell_lite import errors

# ---- the wire ----

is_ascii = getattr(str, "isascii", lambda s: all(c < "\x80" for c in s))  # missing in Python 3.6


def is_identifier(word):
    """Whether a word is an identifier of IDL."""
    return word.isidentifier() and is_ascii(word)


def from_wire(s):
    """Turn a string that a peer sent into text.

    Almost every ORB declares its UTF-8 bytes to be Latin-1. Bytes that are not UTF-8 become surrogate
    escapes, which `to_wire` turns back. Text beyond Latin-1 has been decoded by the ORB.
    """
    if is_ascii(s):
        return s
    try:
        return s.encode("latin-1").decode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        return s


def typed(s):
    """A word of a command line as text. Before Python 3.7, the C locale leaves it bytes,
    as surrogate escapes.
    """
    try:
        if is_ascii(s):
            return s
        return s.encode("utf-8", "surrogateescape").decode("utf-8", "surrogateescape")
    except UnicodeEncodeError:  # other surrogates, which no command line has
        return s


def to_wire(s):
    """Turn text into the string that a peer expects: the reverse of `from_wire`.
    Raises Usage for a lone surrogate.
    """
    if is_ascii(s):
        return s
    try:
        return s.encode("utf-8", "surrogateescape").decode("latin-1")
    except UnicodeEncodeError:
        raise errors.Usage(f"{printable(s)}: not text that can be sent")


# ---- the terminal ----

MARKS = 4  # combining marks that may follow one another: Vietnamese has 2, Hebrew and Tibetan 3 or 4
# Invisible characters that Python calls printable: fillers of Hangul, Braille, music, Khmer and Khitan,
# joiners of marks, and variation selectors.
_BLANK = (
    "[\u034f\u115f\u1160\u17b4\u17b5\u180b-\u180f\u2800\u3164\ufe00-\ufe0f\uffa0\U00016fe4\U0001d159"
    "\U000e0000-\U000e0fff]"
)


def printable(s):
    """`s` with everything escaped that harms a terminal or is invisible; `unescaped` reads it back.

    That is: controls, characters that draw nothing, marks without a base character, and more than MARKS on
    one character.
    """
    if is_plain(s) and "\\" not in s:
        return s
    return "".join(c if plain and c != "\\" else _escape(c) for c, plain in printable_flags(s))


def safe(s):
    """`s` with the same characters escaped except backslashes:
    for lines with parts that are printable already.
    """
    if is_plain(s):
        return s
    return "".join(c if plain else _escape(c) for c, plain in printable_flags(s))


def counted(number, noun):
    """`1 port`, `2 ports`."""
    return f"1 {noun}" if number == 1 else f"{number} {noun}s"


def is_plain(s):
    """True where nothing in `s` but backslashes has to be escaped."""
    if not s.isprintable():
        return False
    return is_ascii(s) or max(s) < "\u0300" or all(plain for _, plain in printable_flags(s))


def printable_flags(s):
    """Each character of `s`, and whether it can be printed as it is."""
    import re
    from unicodedata import category

    # no base character yet
    marks = MARKS
    base = ""
    for c in s:
        kind = category(c) if c >= "\u0300" else ""
        if c in "\ufe0e\ufe0f" and base and not marks and category(base)[0] == "S":
            # a symbol shown as an emoji, or as text
            marks = 1
            plain = True
        elif not c.isprintable() or re.match(_BLANK, c):
            marks = MARKS
            plain = False
            base = ""
        elif kind in ("Mn", "Me"):
            plain = marks < MARKS
            marks += 1
        else:
            marks = 0 if c != " " else MARKS
            plain = True
            base = c
        yield c, plain


LONGEST = 1 << 17  # characters of a word on a command line, at most
CHOICES = 12  # words offered in place of a wrong one
MOST_NAMED = 10  # things that a message names; of more, their number
BEGINNING = 1000  # characters that are shown of a longer text


def cut(s):
    """`s`, or the beginning of one that is too long to read or type, and how much is left out."""
    return s if len(s) <= LONGEST else f"{s[:BEGINNING]}… ({len(s) - BEGINNING} more characters)"


def near(word, words):
    """What a message about a wrong word ends with: the one of the `words` that resembles it;
    '' if none does.
    """
    close = closest(word, words)
    return f"; did you mean {printable(close)}?" if close is not None else ""


def closest(word, words, least=0.6):
    """The one of the `words` that resembles a word, by `least` of 1; None if none does."""
    try:
        import difflib
    except ImportError:  # Debian's python3-minimal has none
        return None
    return next(iter(difflib.get_close_matches(word, words, 1, least)), None)


def candidates(word, words):
    """What a message about a wrong word ends with:
    the one of the `words` that resembles it, else the first CHOICES.
    """
    words = list(words)
    choices = ", ".join(map(printable, words[:CHOICES]))
    if len(words) > CHOICES:
        choices += ", …"
    return near(word, words) or f" (there are: {choices or 'none'})"


def listed(words):
    """Some of the printable words, with commas, and how many more there are."""
    shown = ", ".join(words[:MOST_NAMED])
    more = len(words) - MOST_NAMED
    return f"{shown} and {more} more" if more > 0 else shown


def _escape(c):
    n = ord(c)
    if c == "\\":
        return "\\\\"
    if 0xDC80 <= n <= 0xDCFF:  # a byte that is not UTF-8
        return f"\\x{n - 0xDC00:02x}"
    if n < 0x80:
        return f"\\x{n:02x}"
    if n < 0x10000:
        return f"\\u{n:04x}"
    return f"\\U{n:08x}"


_ESCAPE = r"(?s)\\(?:x([0-9a-fA-F]{2})|u([0-9a-fA-F]{4})|U([0-9a-fA-F]{8})|(.)|$)"


def unescaped(s):
    """The reverse of `printable`; a backslash before punctuation is dropped.
    Raises ValueError for a bad escape.
    """
    if "\\" not in s:
        return s
    import re

    return re.sub(_ESCAPE, _meant, s)


def _meant(escape):
    byte, short, long, literal = escape.groups()
    if literal and not literal.isalnum():
        return literal
    digits = byte or short or long
    if not digits or int(digits, 16) > sys.maxunicode:
        raise ValueError("bad escape " + escape.group())
    n = int(digits, 16)
    if byte and n >= 0x80:
        n += 0xDC00
    return chr(n)


_ESCAPES = (
    r"""\\(?:[\\'"abfnrtv\n]|[0-3][0-7]{0,2}|[4-7][0-7]?(?![0-7])"""
    r"""|x[0-9a-fA-F]{2}|u[0-9a-fA-F]{4}|U[0-9a-fA-F]{8})"""
)


def literal(word):
    """The str or bytes of a Python literal.
    Raises ValueError, also for bad escapes, of which Python itself only warns.
    """
    import ast
    import re

    prefix = word[: min(word.index(quote) for quote in "'\"" if quote in word)].lower()
    is_bad = "r" not in prefix and "\\" in re.sub(_ESCAPES, "", word)
    if is_bad or "b" in prefix and re.search(r"\\[uU]", word):
        raise ValueError("bad escape")
    try:
        return ast.literal_eval(word)
    except SyntaxError:
        raise ValueError("not a text")


def shell_word(s):
    """`s` as one word of a POSIX shell command, printable except newlines,
    which $(printf) would drop at an end.
    """
    if _is_one_word(s):
        return s
    grouped = itertools.groupby(printable_flags(s), lambda pair: pair[1] or pair[0] == "\n")
    pieces = [(plain, "".join(c for c, _ in piece)) for plain, piece in grouped]
    return "".join(_quoted(piece) if plain else _by_printf(piece) for plain, piece in pieces) or "''"


def quoted(s):
    """`s` as one word of a POSIX shell command, raw. (shlex is not in Debian's python3-minimal.)"""
    return s if _is_one_word(s) else _quoted(s)


def _is_one_word(s):
    """Whether `s` means itself in a shell."""
    import re

    return re.match(r"[\w@%+=:,./-]+\Z", s, re.ASCII) is not None


def _quoted(s):
    return "'" + s.replace("'", "'\"'\"'") + "'"


def _by_printf(s):
    return "\"$(printf '%s')\"" % "".join("\\%03o" % byte for byte in s.encode("utf-8", "surrogateescape"))


def width():
    """Columns of the terminal, else $COLUMNS, else 80 (shutil, which can say this, is slow to import)."""
    for fd in (1, 2, 0):
        try:
            columns = os.get_terminal_size(fd).columns
        except (OSError, ValueError, AttributeError):
            continue
        if columns > 0:
            return columns
    try:
        return max(int(os.environ.get("COLUMNS", 80)), 1)
    except ValueError:
        return 80


def cells(s):
    """How many columns of a terminal `s` fills: East Asian wide characters take two, combining ones none."""
    if "\x1b" in s:  # our own colour: other text is escaped
        import re

        s = re.sub("\x1b\\[[0-9;]*m", "", s)
    if not s or max(s) < "\u0300":
        return len(s)
    import unicodedata

    total = 0
    for c in s:
        if unicodedata.east_asian_width(c) in "WF":
            total += 2
        elif unicodedata.category(c) not in ("Mn", "Me"):
            total += 1
    return total


def padded(s, size):
    """`s` with blanks after it up to `size` columns."""
    return s + " " * (size - cells(s))


def columns(words, total, shown=None):
    """Lay `words` out row by row like ls -x: a list of lines no wider than `total`, one word a line at worst.

    `shown` is a list of what is printed for each word (coloured, say); the widths are those of `words`.
    """
    shown = shown or words
    sizes = [cells(w) for w in words]
    for count in range(min(len(words), max(total // 3, 1)), 1, -1):
        wide = [max(sizes[i::count]) for i in range(count)]
        if sum(wide) + 2 * (count - 1) <= total:
            break
    else:
        return list(shown)
    lines = []
    for start in range(0, len(words), count):
        row = range(start, min(start + count, len(words)))
        padding = [" " * (wide[i - start] - sizes[i]) for i in row[:-1]] + [""]
        lines.append("  ".join(shown[i] + blanks for i, blanks in zip(row, padding)))
    return lines


def table(rows):
    """Yield lines of `rows` (sequences of str of one length) in left-aligned columns two blanks apart,
    the last one ragged.
    """
    if not rows:
        return
    sizes = [max(cells(row[i]) for row in rows) for i in range(len(rows[0]) - 1)]
    for row in rows:
        shown = [padded(cell, size) for cell, size in zip(row, sizes)]
        yield "  ".join(shown + [row[-1]])


def pairs(items, indent=""):
    """Lines `name  value` of (name, value) pairs, the values aligned two blanks after the longest name."""
    items = list(items)
    size = max([cells(name) for name, _ in items] or [0])
    return [indent + padded(name, size) + "  " + value for name, value in items]


def natural(name):
    """A key to sort names by, in which Filter2 comes before Filter10."""
    parts = []
    for is_number, letters in itertools.groupby(name, "0123456789".__contains__):
        part = "".join(letters)
        if is_number:
            part = part.lstrip("0")
        parts.append((not is_number, is_number and len(part), part))
    return parts


# ---- colour ----

# States of a component; Unknown where its context does not say.
STATES = ("Active", "Inactive", "Error", "Created", "Unknown")

COLOURS = {
    "Inactive": "01;34",
    "Active": "01;32",
    "Error": "01;37;41",
    "Unknown": "01;31",
    "?": "01;31",
    "Running": "01;32",
    "directory": "01;34",
    "zombie": "02;37",
    "bold": "01",
    "active set": "01;32",
    # of lines in plots
    "series 0": "36",
    "series 1": "33",
    "series 2": "35",
    "series 3": "32",
    "series 4": "31",
    "series 5": "34",
}


def colour_wanted():
    """True when stdout is a terminal that wants colour (https://no-color.org, TERM=dumb)."""
    is_wanted = not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"
    return bool(sys.stdout and sys.stdout.isatty() and is_wanted)


def painter():
    """A function paint(word, role=word) that gives `word` the colour of its role,
    or none where colours are not wanted.
    """
    if not colour_wanted():
        return lambda word, role=None: word

    def paint(word, role=None):
        code = COLOURS.get(role or word)
        return f"\x1b[{code}m{word}\x1b[00m" if code else word

    return paint


# ---- JSON ----


def json_line(value):
    """One object as one line: ASCII, sorted keys. Undecodable bytes are \\udcXX, Python's surrogate escapes.

    NaN and infinities, which a peer may send but JSON lacks, become null.
    """
    import json

    try:
        return json.dumps(value, sort_keys=True, ensure_ascii=True, allow_nan=False)
    except ValueError:
        tame = json.loads(json.dumps(value), parse_constant=lambda word: None)
        return json.dumps(tame, sort_keys=True, ensure_ascii=True)
