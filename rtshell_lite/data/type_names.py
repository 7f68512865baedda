"""Types by the names that {"_type": name, "_value": …} gives them: the words of a basic type, the repository
id of one that has any, string<bound>, fixed<digits, scale>, and sequence<…> of these.
"""

import re

from rtshell_lite.giop import descriptors
from rtshell_lite.giop.descriptors import (
    ANY, FIXED, LONGDOUBLE, OBJECT, SEQUENCE, STRING, TYPECODE, VALUES, WSTRING
)

DEEPEST = 64  # sequences of sequences
_BASIC = {"string": (STRING, 0), "wstring": (WSTRING, 0), "Object": (OBJECT, "", "Object")}  # type: dict
_BASIC.update((descriptors.NAMES[kind], kind) for kind in VALUES + (0, 1, ANY, TYPECODE, LONGDOUBLE))
_SEQUENCE = r"sequence<(.+?)\s*(?:,\s*(\d{1,9})\s*)?>\Z"
_BOUNDED = r"(w?string)<\s*(\d{1,9})\s*>\Z"
_FIXED = r"fixed<\s*(\d{1,2})\s*,\s*(\d{1,2})\s*>\Z"


def name(descriptor):
    """The name of a type, for `descriptor` below."""
    kind = descriptors.kind(descriptor)
    if kind == OBJECT:  # the reference says which interface
        return "Object"
    if kind == SEQUENCE and not descriptors.length(descriptor):
        return f"sequence<{name(descriptors.element(descriptor))}>"
    if kind == SEQUENCE:
        return "sequence<%s, %d>" % (name(descriptors.element(descriptor)), descriptors.length(descriptor))
    if kind == FIXED:
        return "fixed<%d, %d>" % descriptor[1:]
    return descriptors.type_id(descriptor) or descriptors.words(descriptor)


def descriptor(name, find, depth=DEEPEST):
    """The descriptor for the name of a type; find(name) gives that of a named one. Raises what
    `find` raises.
    """
    name = name.strip()
    if name in _BASIC:
        return _BASIC[name]
    listed = re.match(_SEQUENCE, name, re.DOTALL)
    if listed and depth:
        elements = descriptor(listed.group(1), find, depth - 1)
        return (SEQUENCE, elements, int(listed.group(2) or 0))
    bounded = re.match(_BOUNDED, name)
    if bounded:
        return (_BASIC[bounded.group(1)][0], int(bounded.group(2)))
    decimal = re.match(_FIXED, name)
    if decimal:
        digits = int(decimal.group(1))
        scale = int(decimal.group(2))
        if scale <= digits <= 31:
            return (FIXED, digits, scale)
    return find(name)
