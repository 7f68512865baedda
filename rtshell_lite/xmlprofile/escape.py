"""Characters that XML cannot hold, most controls and lone surrogates, are spelt _xHHHH_: names of peers may
hold any bytes.

Other formats in XML have the same spelling. Other text stays as it is, unless it looks like such a spelling.
"""

import re

from rtshell_lite.text import is_ascii, is_plain, printable_flags

_ILLEGAL = "\x00-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffe\uffff"
_SPELT = "(?:00(?:0[0-8BCEF]|1[0-9A-F]|5F)|D[89A-F][0-9A-F]{2}|FFF[EF])"
# These are compiled when a file needs them: that takes longer than writing a small one.
# An underscore that would begin such a spelling is spelt, too.
_TO_SPELL = f"[{_ILLEGAL}]|_(?=x{_SPELT}[_{_ILLEGAL}])"
_TO_READ = f"_x({_SPELT})_"
_ILLEGAL_ONE = f"[{_ILLEGAL}]"
_INVISIBLE = (
    "\x7f-\x9f\xad\u061c\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufff9-\ufffb\U000e0000-\U000e0fff"
)
_MEANS_MORE = re.compile('[&<>"]|_x')
_MARKUP = f'[&<>"\t\n\r{_INVISIBLE}]'


def _is_simple(text):
    return is_ascii(text) and text.isprintable() and not _MEANS_MORE.search(text)


def quoted(text):
    """`text` for an attribute in double quotes, or for the content of an element."""
    if _is_simple(text):  # most are
        return text
    text = re.sub(_TO_SPELL, lambda character: f"_x{ord(character.group()):04X}_", text)
    return marked(text)


def marked(text):
    """`text`, which XML can hold, with references for markup, tabs and line ends,
    and what is not printable.
    """
    if _is_simple(text):
        return text
    text = re.sub(_MARKUP, _reference, text)
    if is_plain(text):
        return text
    return "".join(c if plain or c < "\u0300" else "&#%d;" % ord(c) for c, plain in printable_flags(text))


def is_legal(text):
    """True for text that XML can hold as it is."""
    return not re.search(_ILLEGAL_ONE, text)


_NAMED = {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"}


def _reference(character):
    return _NAMED.get(character.group()) or f"&#{ord(character.group())};"


def unspelt(text):
    """The reverse of `quoted`, after the XML parser has replaced references."""
    if "_x" in text:
        return re.sub(_TO_READ, lambda spelling: chr(int(spelling.group(1), 16)), text)
    return text
