"""The values of fields as text, and back. Raises ValueError with a message for users."""

import re

from rtshell_lite.xmlprofile import fields

_WHOLE = re.compile(r"[-+]?[0-9]{1,18}\Z")
_LONGEST_NUMBER = 100  # characters: long ones take quadratic time


def from_text(field, text):
    """The value of a field for its text in a file."""
    if field.kind == fields.TEXT:
        return _choice(field, text) if field.choices else text
    if field.kind == fields.DATE:
        return text
    word = text.strip()
    if not word:
        return field.default
    if field.kind == fields.BOOLEAN:
        return _boolean(word)
    if field.kind == fields.INTEGER:
        if not _WHOLE.match(word):
            raise ValueError(f"{shown(text)}: not a whole number")
        return int(word)
    return _number(word)


def _choice(field, text):
    word = text.strip().lower()
    return field.choices.get(word, text) if word else field.default


def _boolean(word):
    if word.lower() in ("true", "1", "yes", "on"):
        return True
    if word.lower() in ("false", "0", "no", "off"):
        return False
    raise ValueError(f"{shown(word)}: neither true nor false")


def _number(word):
    try:
        if len(word) <= _LONGEST_NUMBER:
            return float(word)
    except ValueError:
        pass
    raise ValueError(f"{shown(word)}: not a number")


def from_number(field, value):
    """The value of a field for a bool, int or float from YAML."""
    if field.kind == fields.BOOLEAN:
        return _boolean(str(value))
    if isinstance(value, bool):
        raise ValueError(f"{str(value).lower()}: not a number")
    if field.kind == fields.NUMBER:
        from rtshell_lite.xmlprofile.yaml import scalars  # loaded where a file is YAML

        return scalars.as_float(value)
    if value != value or abs(value) >= 10**18 or value != int(value):
        raise ValueError(f"{value}: not a whole number")
    return int(value)


def to_text(field, value):
    """The text of a value in XML."""
    if field.kind == fields.BOOLEAN:
        return "true" if value else "false"
    if field.kind == fields.NUMBER:
        return _SPECIAL.get(repr(float(value)), repr(float(value)))
    return str(value)


_SPECIAL = {"inf": "INF", "-inf": "-INF", "nan": "NaN"}


def shown(text):
    """A piece of a file for a message, shortened."""
    text = str(text)
    if len(text) > 40:
        text = text[:37] + "..."
    return f'"{text}"'
