"""Characters that XML cannot hold, spelt _xHHHH_ and read back: a name off the wire may be any bytes.

XML has no way to write most control characters and lone surrogates. This spelling is known from other formats that are
kept as XML; text without such characters is written as it is, unless it looks like such a spelling by accident.
"""
import re

from rtshell_lite.text import is_plain, judged

_ILLEGAL = "\x00-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffe\uffff"
_SPELT = "(?:00(?:0[0-8BCEF]|1[0-9A-F]|5F)|D[89A-F][0-9A-F]{2}|FFF[EF])"
# An underscore that would begin such a spelling is spelt itself; what is illegal begins with one once it is spelt.
_TO_SPELL = re.compile(f"[{_ILLEGAL}]|_(?=x{_SPELT}[_{_ILLEGAL}])")
_TO_READ = re.compile(f"_x({_SPELT})_")
_ILLEGAL_ONE = re.compile(f"[{_ILLEGAL}]")
_INVISIBLE = "\x7f-\x9f\xad\u061c\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufff9-\ufffb\U000e0000-\U000e0fff"
_MARKUP = re.compile(f"[&<>\"\t\n\r{_INVISIBLE}]")


def quoted(text):
    """`text` as it is written in an attribute between double quotes, or as the content of an element."""
    if text.isalnum() and is_plain(text):  # most are
        return text
    if _TO_SPELL.search(text):
        text = _TO_SPELL.sub(lambda found: f"_x{ord(found.group()):04X}_", text)
    return marked(text)


def marked(text):
    """`text`, which XML can hold, with references for what would be markup, read as a blank, or do something to a terminal."""
    text = _MARKUP.sub(_reference, text) if _MARKUP.search(text) else text
    if is_plain(text):
        return text
    return "".join(c if plain or c < "\u0300" else "&#%d;" % ord(c) for c, plain in judged(text))


def is_legal(text):
    """True for text that XML can hold as it is."""
    return not _ILLEGAL_ONE.search(text)


_NAMED = {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"}


def _reference(found):
    return _NAMED.get(found.group()) or "&#%d;" % ord(found.group())


def unspelt(text):
    """Read back what `quoted` spelt; the XML parser has read the references before."""
    return _TO_READ.sub(lambda found: chr(int(found.group(1), 16)), text) if "_x" in text else text
