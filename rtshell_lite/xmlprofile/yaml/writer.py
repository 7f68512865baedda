"""Writes plain data as YAML in PyYAML's default style: block style, keys sorted, ASCII;
but lines are not folded.
"""

import binascii
import re

from rtshell_lite.xmlprofile.yaml import scalars

_PLAIN = re.compile(r"(?=[!-~])(?:[^-?:,\[\]{}#&*!|>'\"%@`]|[-?:](?=[!-~]))[ -~]*\Z")
_UNSAFE = re.compile(r": | #|:\Z| \Z|\A(?:---|\.\.\.)")
_DOUBLE = re.compile(r"[^ !#-\[\]-~]")
_ESCAPES = {
    "\0": "0",
    "\a": "a",
    "\b": "b",
    "\t": "t",
    "\n": "n",
    "\v": "v",
    "\f": "f",
    "\r": "r",
    "\x1b": "e",
    '"': '"',
    "\\": "\\",
    "\x85": "N",
    "\xa0": "_",
    "\u2028": "L",
    "\u2029": "P",
}


def write(data):
    """The text of a YAML document."""
    lines = []
    _node(lines, "", "", data)
    return "\n".join(lines) + "\n"


def _node(lines, head, indent, data):
    """Append a value: `head` is what comes before it on its first line, `indent` on the others."""
    if isinstance(data, dict) and data:
        for key in sorted(data):
            _pair(lines, head + scalar(key), indent, data[key])
            head = indent
    elif isinstance(data, list) and data:
        for item in data:
            _node(lines, head + "- ", indent + "  ", item)
            head = indent
    else:
        lines.append(head + scalar(data))


def _pair(lines, name, indent, value):
    if isinstance(value, dict) and value:
        lines.append(name + ":")
        _node(lines, indent + "  ", indent + "  ", value)
    elif isinstance(value, list) and value:
        lines.append(name + ":")
        _node(lines, indent, indent, value)
    else:
        lines.append(f"{name}: {scalar(value)}")


def scalar(value):
    """The text of a value on one line."""
    if value is None:
        return "null"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return _float(value)
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, bytes):
        return f"!!binary \"{binascii.b2a_base64(value).decode('ascii').strip()}\""
    if isinstance(value, int):
        digits = str(value)
        # it was read like that
        return digits if len(digits) <= scalars.LONGEST_NUMBER else hex(value)
    if isinstance(value, dict):
        return "{}"
    return "[]"


def _float(value):
    text = {"inf": ".inf", "-inf": "-.inf", "nan": ".nan"}.get(repr(value), repr(value))
    # 1e20 would be text
    if "e" in text and "." not in text:
        return text.replace("e", ".0e", 1)
    return text


def _text(value):
    if _PLAIN.match(value) and not _UNSAFE.search(value) and scalars.is_text(value):
        return value
    if value.isprintable() and all(c < "\x7f" for c in value):
        return "'" + value.replace("'", "''") + "'"
    return '"' + _DOUBLE.sub(_escape, value) + '"'


def _escape(match):
    c = match.group()
    n = ord(c)
    if c in _ESCAPES:
        return "\\" + _ESCAPES[c]
    if n < 0x100:
        return f"\\x{n:02X}"
    if n < 0x10000:
        return f"\\u{n:04X}"
    return f"\\U{n:08X}"
