"""Characters that XML cannot hold, most controls and lone surrogates, are spelt _xHHHH_: names of peers may
hold any bytes.

Other formats in XML have the same spelling. Other text stays as it is, unless it looks like such a spelling.
"""

import re

from rtshell_lite.text import is_plain, printable_flags

_ILLEGAL = "\x00-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffe\uffff"
_SPELT = "(?:00(?:0[0-8BCEF]|1[0-9A-F]|5F)|D[89A-F][0-9A-F]{2}|FFF[EF])"
# An underscore that would begin such a spelling is spelt, too.
_TO_SPELL = re.compile(f"[{_ILLEGAL}]|_(?=x{_SPELT}[_{_ILLEGAL}])")
_TO_READ = re.compile(f"_x({_SPELT})_")
_ILLEGAL_ONE = re.compile(f"[{_ILLEGAL}]")
_INVISIBLE = (
    "\x7f-\x9f\xad\u061c\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufff9-\ufffb\U000e0000-\U000e0fff"
)
_MARKUP = re.compile(f'[&<>"\t\n\r{_INVISIBLE}]')


def quoted(text):
    """`text` for an attribute in double quotes, or for the content of an element."""
    if text.isalnum() and is_plain(text):  # most are
        return text
    if _TO_SPELL.search(text):
        text = _TO_SPELL.sub(lambda character: f"_x{ord(character.group()):04X}_", text)
    return marked(text)


def marked(text):
    """`text`, which XML can hold, with references for markup, tabs and line ends,
    and what is not printable.
    """
    if _MARKUP.search(text):
        text = _MARKUP.sub(_reference, text)
    if is_plain(text):
        return text
    return "".join(c if plain or c < "\u0300" else "&#%d;" % ord(c) for c, plain in printable_flags(text))


def is_legal(text):
    """True for text that XML can hold as it is."""
    return not _ILLEGAL_ONE.search(text)


_NAMED = {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"}


def _reference(character):
    return _NAMED.get(character.group()) or f"&#{ord(character.group())};"


def unspelt(text):
    """The reverse of `quoted`, after the XML parser has replaced references."""
    if "_x" in text:
        return _TO_READ.sub(lambda spelling: chr(int(spelling.group(1), 16)), text)
    return text
