"""Scalars of YAML: how text is quoted, folded and escaped, and what plain text means (YAML 1.1, as in
PyYAML).

The functions take a Document and a position and return where the value ends and its text.
"""

import binascii
import re

BREAK = "\n\u2028\u2029"
LONGEST_TEXT = 4 << 20
LONGEST_NUMBER = 300  # characters: long ones take quadratic time
TAB = "a tab; blanks are needed here"
TAGS = {"!", "str", "int", "float", "bool", "null", "binary", "timestamp", "map", "seq"}

_NOT_FIRST = re.compile("[\t %s\0,\\[\\]{}#&*!|>'\"%%@`]|[-?:](?=[\t %s\0])" % (BREAK, BREAK))
_NOT_FIRST_IN_FLOW = re.compile("[\t %s\0,\\[\\]{}#&*!|>'\"%%@`?:]|-(?=[\t %s\0])" % (BREAK, BREAK))
_STOP = re.compile(f":(?=[\t {BREAK}\x00])| #|[\t{BREAK}\x00]")
_STOP_IN_FLOW = re.compile(":(?=[\t %s\0,\\[\\]{}])| #|[\t%s\0,\\[\\]{}]" % (BREAK, BREAK))
_SPACE = re.compile(f"[ {BREAK}]*")
_MARKER = re.compile(rf"[{BREAK}](?:---|\.\.\.)(?=[ \0{BREAK}])")
_ALIAS = re.compile(r"\*[\w-]+", re.ASCII)


# ---- text without quotes ----


def key_end(doc, pos):
    """Where text that may be a key ends on this line; None if it cannot be a key."""
    c = doc.text[pos]
    if c in "'\"":
        end = _closing(doc, pos)
        return None if _has_break(doc.text[pos:end]) else end
    if c == "*":
        alias = _ALIAS.match(doc.text, pos)
        return alias and alias.end()
    if _NOT_FIRST.match(doc.text, pos):
        return None
    return _STOP.search(doc.text, pos).start()


def bare(doc, pos, indent, flow, key):
    """Plain text. Unless it is a key, it continues on lines that are indented by more than `indent`."""
    text = doc.text
    stop, not_first = (_STOP_IN_FLOW, _NOT_FIRST_IN_FLOW) if flow else (_STOP, _NOT_FIRST)
    if not_first.match(text, pos):
        if text[pos] == "\t":
            doc.fail(pos, TAB)
        if text[pos] in ",]}\0":
            doc.fail(pos, "a value is needed here")
        doc.fail(pos, "a value cannot begin like this; put quotes around it")
    piece = text[pos : stop.search(text, pos).start()].rstrip(" ")
    pieces = [piece]
    end = pos + len(piece)
    while not key:
        start = _SPACE.match(text, end).end()
        fold = text[end:start]
        if not _has_break(fold) or text[start] == "#" or _MARKER.match(text, start - 1):
            break
        if not flow and doc.column(start) <= indent:
            break
        piece = text[start : stop.search(text, start).start()].rstrip(" ")
        if not piece:
            break
        pieces += [folded(fold), piece]
        end = start + len(piece)
        _check_length(doc, pos, end)
    return end, "".join(pieces)


def _has_break(text):
    return "\n" in text or "\u2028" in text or "\u2029" in text


def folded(space):
    """The meaning of blanks and line ends inside a text:
    a single line end is a blank, each further one an empty line.
    """
    breaks = "".join(c for c in space if c in BREAK)
    if breaks[0] != "\n":
        return breaks
    return breaks[1:] or " "


def _check_length(doc, pos, end):
    if end - pos > LONGEST_TEXT:
        doc.fail(pos, "a text of more than %d MiB" % (LONGEST_TEXT >> 20))


# ---- text in quotes ----

_ANY_SPACE = re.compile(f"[ \t{BREAK}]+")
_ESCAPE = re.compile(
    r"\\(?:x([0-9A-Fa-f]{2})|u([0-9A-Fa-f]{4})|U([0-9A-Fa-f]{8})|([%s])([ \t%s]*)|(.))|[ \t%s]+"
    % (BREAK, BREAK, BREAK),
    re.DOTALL,
)
_ESCAPED = {
    "0": "\0",
    "a": "\a",
    "b": "\b",
    "t": "\t",
    "\t": "\t",
    "n": "\n",
    "v": "\v",
    "f": "\f",
    "r": "\r",
    "e": "\x1b",
    " ": " ",
    '"': '"',
    "\\": "\\",
    "/": "/",
    "N": "\x85",
    "_": "\xa0",
    "L": "\u2028",
    "P": "\u2029",
}


def quoted(doc, pos):
    """Text in single or double quotes."""
    end = _closing(doc, pos)
    raw = doc.text[pos + 1 : end - 1]
    if _has_break(raw) and _MARKER.search(doc.text, pos, end):
        doc.fail(_MARKER.search(doc.text, pos, end).start() + 1, "the end of the document inside quotes")
    if doc.text[pos] == "'":
        raw = raw.replace("''", "'")
        if _has_break(raw):
            raw = _ANY_SPACE.sub(_meant_space, raw)
        return end, raw
    if "\\" not in raw and not _has_break(raw):
        return end, raw

    def meant(match):
        byte, short, long, line, lines, letter = match.groups()
        number = int(byte or short or long or "0", 16)
        if letter in _ESCAPED:
            return _ESCAPED[letter]
        if letter or number > 0x10FFFF:
            doc.fail(pos + 1 + match.start(), "an escape that does not exist")
        if line:  # an escaped line end is dropped
            return "".join(c for c in lines if c in BREAK)
        if byte or short or long:
            return chr(number)
        return _meant_space(match)

    return end, _ESCAPE.sub(meant, raw)


def _meant_space(match):
    space = match.group()
    return folded(space) if _has_break(space) else space


def _closing(doc, pos):
    """The position after the quote that closes the one at `pos`."""
    quote = doc.text[pos]
    text = doc.text
    end = pos
    while True:
        end = text.find(quote, end + 1)
        if end < 0:
            doc.fail(pos, "this quote is never closed")
        _check_length(doc, pos, end)
        if quote == "'" and text[end + 1] == "'":
            end += 1
            continue
        start = end
        while quote == '"' and text[start - 1] == "\\":
            start -= 1
        if (end - start) % 2 == 0:
            return end + 1


# ---- literal and folded text ----

_HEADER = re.compile(rf"([|>])(?:([-+])([1-9])?|([1-9])([-+])?)?(?: +#[^{BREAK}\0]*| *)(?=[{BREAK}\0])")
_LINE = re.compile(f"[^{BREAK}\x00]*")


def block(doc, pos, indent):
    """Lines after | or >, in a collection at column `indent`; the algorithm is PyYAML's."""
    header = _HEADER.match(doc.text, pos)
    if not header:
        doc.fail(pos, f"only digits, + and - may follow {doc.text[pos]}")
    text = doc.text
    folds = header.group(1) == ">"
    keep = header.group(2) or header.group(5)
    digit = header.group(3) or header.group(4)
    start = pos
    pos = header.end()
    pos += text[pos] != "\0"
    width = max(indent + 1, 1)
    if digit:
        width += int(digit) - 1
    else:
        blanks = _SPACE.match(text, pos).group()
        lines = re.split(f"[{BREAK}]", blanks)
        width = max([width] + list(map(len, lines)))
    pos, empty, here = _empty_lines(text, pos, width)
    pieces = []
    ending = ""
    while here == width and text[pos] != "\0":
        pieces += empty
        more = text[pos] not in " \t"
        line = _LINE.match(text, pos)
        pieces.append(line.group())
        pos = line.end()
        ending = "" if text[pos] == "\0" else text[pos]
        pos, empty, here = _empty_lines(text, pos + len(ending), width)
        _check_length(doc, start, pos)
        if here != width or text[pos] == "\0":
            break
        if folds and ending == "\n" and more and text[pos] not in " \t":
            pieces.append("" if empty else " ")
        else:
            pieces.append(ending)
    if keep != "-":
        pieces.append(ending)
    if keep == "+":
        pieces += empty
    if text[pos] == "\t" and here < width:
        doc.fail(pos, TAB)
    return pos, "".join(pieces)


def _empty_lines(text, pos, width):
    """Skip empty lines: (where text begins, the line ends, its column, at most `width`)."""
    breaks = []
    while True:
        blanks = 0
        while blanks < width and text[pos] == " ":
            pos += 1
            blanks += 1
        if text[pos] not in BREAK:
            return pos, breaks, blanks
        breaks.append(text[pos])
        pos += 1


# ---- what text means ----

_BOOLEAN = re.compile(r"(?:(yes|Yes|YES|true|True|TRUE|on|On|ON)|no|No|NO|false|False|FALSE|off|Off|OFF)\Z")
NULLS = ("", "~", "null", "Null", "NULL")
_INTEGER = re.compile(
    r"[-+]?(?:(?P<two>0b[01_]+)|(?P<eight>0[0-7_]+)|0|[1-9][0-9_]*|(?P<sixteen>0x[0-9a-fA-F_]+))\Z"
)
_FLOAT = re.compile(
    r"""(?:[-+]?[0-9][0-9_]*\.[0-9_]*(?:[eE][-+][0-9]+)?
                    |\.[0-9][0-9_]*(?:[eE][-+][0-9]+)?
                    |(?P<sign>[-+]?)\.(?:inf|Inf|INF)
                    |(?P<nan>\.(?:nan|NaN|NAN)))\Z""",
    re.VERBOSE,
)
# 1:30, a number for PyYAML, but text here
_BASE_60 = re.compile(r"[-+]?[0-9][0-9_]*(?::[0-5]?[0-9])+(?:\.[0-9_]*)?\Z")
_DATE = re.compile(
    r"""[0-9]{4}-(?:[0-9]{2}-[0-9]{2}|[0-9]{1,2}-[0-9]{1,2}(?:[Tt]|[ \t]+)[0-9]{1,2}:[0-9]{2}:[0-9]{2}
                   (?:\.[0-9]*)?(?:[ \t]*(?:Z|[-+][0-9]{1,2}(?::[0-9]{2})?))?)\Z""",
    re.VERBOSE,
)


def is_text(text):
    """Whether plain text is text for every reader of YAML 1.1:
    not a number, date, boolean, null and the like.
    """
    if len(text) > LONGEST_NUMBER:
        return text[0] not in "-+.0123456789"
    return text not in NULLS + ("=", "<<") and not any(
        pattern.match(text) for pattern in (_BOOLEAN, _INTEGER, _FLOAT, _BASE_60, _DATE)
    )


def plain(node):
    """The data of a node: None, bool, int, float, str (also for keys and dates), bytes, list, dict.
    Raises ValueError.
    """
    value = node.value
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, list):
        return [plain(item) for item in value]
    if node.tag:
        return _TAGGED[node.tag](value)
    if value in NULLS:
        return None
    for pattern, meaning in ((_BOOLEAN, _boolean), (_INTEGER, _integer), (_FLOAT, _float)):
        if len(value) <= LONGEST_NUMBER and pattern.match(value):
            return meaning(value)
    return value


def _matched(pattern, text, what):
    match = len(text) <= LONGEST_NUMBER and pattern.match(text)
    if not match:
        raise ValueError(f"not a {what}")
    return match


def _boolean(text):
    return bool(_matched(_BOOLEAN, text, "boolean").group(1))


def _null(text):
    if text not in NULLS:
        raise ValueError("not a null")


def _integer(text):
    groups = _matched(_INTEGER, text, "whole number").groupdict()
    sign = -1 if text[0] == "-" else 1
    if groups["two"]:
        base = 2
    elif groups["eight"]:
        base = 8
    elif groups["sixteen"]:
        base = 16
    else:
        base = 10
    return sign * int(text.lstrip("-+").replace("_", ""), base)  # int() accepts 0b and 0x


def _float(text):
    match = _matched(_FLOAT, text, "number")
    if match.group("nan"):
        return float("nan")
    if match.group("sign") is not None:
        return float(match.group("sign") + "inf")
    return float(text.replace("_", ""))


def as_float(number):
    """The float for an int. Raises ValueError when it is too large."""
    try:
        return float(number)
    except OverflowError:
        raise ValueError("too large a number")


def _number(text):
    if len(text) <= LONGEST_NUMBER and _INTEGER.match(text):
        return as_float(_integer(text))
    return _float(text)


def _bytes(text):
    try:
        return binascii.a2b_base64(text.encode("ascii"))
    except ValueError:  # also binascii.Error and UnicodeError
        raise ValueError("not base64")


_TAGGED = {
    "str": str,
    "timestamp": str,
    "int": _integer,
    "float": _number,
    "bool": _boolean,
    "null": _null,
    "binary": _bytes,
}  # type: dict
