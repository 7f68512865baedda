"""Values of data types: as text, as JSON, as columns; their fields and timestamps; and how a person writes
one.

A value is what stubs make: structs have attributes, unions _d and _v, items of enums _n and _v; sequences are
lists, or bytes (of octets) or text (of characters).
"""

import base64
import math
import re
import struct
import sys

from rtshell_lite import errors
from rtshell_lite.data import build_value, literals, type_names
from rtshell_lite.giop import marshal, references
from rtshell_lite.text import printable_flags, printable

Expression = literals.Expression
build = build_value.build

SCALARS = ((1, "B", "octet"), (2, "h", "short"), (4, "i", "long"), (4, "f", "float"), (8, "d", "double"))
SHOWN = 64  # characters of a guessed string


# ---- parts of a value ----


_SORTS = {marshal.Any: "any", marshal.TypeCode: "typecode", references.Reference: "reference"}


def _sort(value):
    if isinstance(value, (str, int, float, bytes)) or value is None:
        return "scalar"
    if isinstance(value, (list, tuple)):
        return "list"
    if isinstance(value, dict):
        return "dict"
    if isinstance(value, (marshal.Any, marshal.TypeCode, references.Reference)):
        return _SORTS[type(value)]
    members = vars(value)
    if "_n" in members:
        return "enum"
    if "_d" in members:
        return "union"
    return "struct"


def _case(union):
    """The name of the member that a union holds, or None."""
    members = getattr(type(union), "_d_to_m", {})
    return members.get(union._d) or getattr(type(union), "_def_m", None)


def timestamp(value):
    """(seconds, nanoseconds) of a value's member `tm`; None when it has none."""
    members = getattr(getattr(value, "tm", None), "__dict__", None)
    if not members or list(members) != ["sec", "nsec"]:
        return None
    stamp = members["sec"], members["nsec"]
    if isinstance(stamp[0], int) and isinstance(stamp[1], int):
        return stamp
    return None


def with_timestamp(value, sec, nsec):
    """A copy of a value with another time in its member `tm`; the value itself when it has none."""
    if timestamp(value) is None:
        return value
    time = type(value.tm)(sec + nsec // 1000000000, nsec % 1000000000)
    members = dict(vars(value), tm=time)
    copy = object.__new__(type(value))
    copy.__dict__.update(members)
    return copy


def _bounded(function, *args):
    """The result of a recursive function. Raises BadValue for a value that is nested too deep for Python's
    stack.
    """
    try:
        return function(*args)
    except RecursionError:
        raise errors.BadValue("the value", "nested too deep to show")


# ---- as text ----


def text(value, limit=None):
    """One line for people: `[SEC.NSEC] DATA` for a value with a time, as the rtshell manual promises.

    Of a sequence, at most `limit` elements are shown, and the number of the others; None shows all.
    """
    return _bounded(_line, value, limit)


def _line(value, limit):
    if _sort(value) != "struct":
        return printable(value) if isinstance(value, str) else _text(value, limit)
    members = vars(value)
    stamp = timestamp(value)
    if stamp is None:
        return _text(value, limit)
    if len(members) == 2 and "data" in members:
        data = members["data"]
        shown = printable(data) if isinstance(data, str) else _text(data, limit)
    else:
        parts = [f"{name}={_text(inner, limit)}" for name, inner in members.items() if name != "tm"]
        shown = " ".join(parts)
    return "[%d.%09d] %s" % (stamp + (shown,))


def _text(value, limit):
    if isinstance(value, (int, float)):
        return str(value)
    if isinstance(value, str):
        return "'%s'" % printable(value).replace("'", "\\'")
    if isinstance(value, bytes):
        return f"<{_shortened(_hex(value[:limit]), value, limit, ' ')}>"
    sort = _sort(value)
    if sort == "list":
        elements = ", ".join(_text(element, limit) for element in value[:limit])
        return f"[{_shortened(elements, value, limit, ', ')}]"
    if sort == "struct":
        return "(%s)" % ", ".join(
            "%s=%s" % (name, _text(inner, limit)) for name, inner in vars(value).items()
        )
    if sort == "union":
        case = _case(value)
        if case:
            return f"({case}={_text(value._v, limit)})"
        return f"(_d={_text(value._d, limit)})"
    if sort == "enum":
        return value._n
    if sort == "any":
        return f"({type_names.name(value.descriptor)}={_text(value.content, limit)})"
    if sort == "typecode":
        return type_names.name(value.descriptor)
    if sort == "reference":
        return value.text()
    return "None"


def _shortened(shown, value, limit, between):
    """What is shown of a value, and how many elements more it has."""
    more = len(value) - len(value[:limit])
    if not more:
        return shown
    if not shown:
        return f"… {more} more"
    return f"{shown}{between}… {more} more"


def _hex(data):
    if sys.version_info >= (3, 8):
        return data.hex(" ")
    return " ".join(f"{byte:02x}" for byte in data)


def constructor(value):
    """A value in the form that rtinject reads, RTC.TimedLong(tm=RTC.Time(sec=1, nsec=2), data=42):
    `Expression` reads it back.
    """
    return _bounded(_constructor, value)


def _constructor(value):
    sort = _sort(value)
    if isinstance(value, float) and not math.isfinite(value):
        return _not_finite(value)
    if isinstance(value, str):
        pieces = []
        for c, is_plain in printable_flags(value):
            if is_plain and c not in "\\'{}":
                pieces.append(c)
            else:
                pieces.append(_escaped(c))
        return f"'{''.join(pieces)}'"
    if sort == "scalar":
        return repr(value)
    if sort == "list":
        return f"[{', '.join(map(_constructor, value))}]"
    if sort == "enum":
        return value._n
    called = build_value.dotted(type(value)._NP_RepositoryId)
    if sort == "union":
        parts = [_constructor(value._d)]
        if _case(value):
            parts.append(_constructor(value._v))
        return f"{called}({', '.join(parts)})"
    return "%s(%s)" % (
        called, ", ".join("%s=%s" % (name, _constructor(inner)) for name, inner in vars(value).items()),
    )


def _not_finite(number):
    """The word for NaN or an infinity; build_value.NUMBERS has the reverse."""
    if math.isnan(number):
        return "NaN"
    return "Infinity" if number > 0 else "-Infinity"


def _escaped(c):
    n = ord(c)
    if n < 256:
        return f"\\x{n:02x}"
    if n < 65536:
        return f"\\u{n:04x}"
    return f"\\U{n:08x}"


# ---- as JSON and in tables ----


def json(value):
    """The value for json.dumps: structs as objects, enums by name, octets in base64, unions as {"_d": label,
    member: value}, an `any` as {"_type": name, "_value": value}, a TypeCode as the name of a type, a
    reference as {"_ior": text, "_type": its repository id}, nil as None.

    NaN and the infinities, which JSON lacks, are "NaN", "Infinity" and "-Infinity".
    """
    return _bounded(_json, value)


def _json(value):
    if isinstance(value, float) and not math.isfinite(value):
        return _not_finite(value)
    if isinstance(value, bytes):
        return base64.b64encode(value).decode("ascii")
    sort = _sort(value)
    if sort == "list":
        plain = value and (
            isinstance(value[0], (int, str)) or isinstance(value[0], float) and all(map(math.isfinite, value))
        )
        if plain:
            return value
        return [_json(element) for element in value]
    if sort == "struct":
        return {name: _json(inner) for name, inner in vars(value).items()}
    if sort == "union":
        case = _case(value)
        if case:
            return {"_d": _json(value._d), case: _json(value._v)}
        return {"_d": _json(value._d)}
    if sort == "enum":
        return value._n
    if sort == "any":
        return {"_type": type_names.name(value.descriptor), "_value": _json(value.content)}
    if sort == "typecode":
        return type_names.name(value.descriptor)
    if sort == "reference":
        return {"_type": value.address.type_id, "_ior": value.text()}
    return value


def flat(value):
    """[(column, scalar)] for a table: tm.sec, data[0], data.x;
    octets in hex, enums by name, a union's label as _d.
    """
    return _bounded(_flat, value, "")


def _flat(value, column):
    sort = _sort(value)
    if isinstance(value, bytes):
        return [(column, value.hex())]
    if sort == "list":
        return [cell for i, element in enumerate(value) for cell in _flat(element, f"{column}[{i}]")]
    if sort in ("struct", "union", "dict"):
        if sort == "dict":
            members = value
        elif sort == "struct":
            members = vars(value)
        else:
            members = {"_d": value._d}
        if sort == "union" and _case(value):
            members[_case(value)] = value._v
        start = column + "." if column else ""
        return [cell for name, inner in members.items() for cell in _flat(inner, start + name)]
    if sort == "enum":
        return [(column, value._n)]
    return [(column, value)]


_STEP = re.compile(r"\.?([A-Za-z_]\w*)|\[(\d{1,9})\]", re.ASCII)


def field(value, path):
    """A part of a value: field(value, "data.points[0].x").
    Raises NoSuch, which lists the fields, and BadPath.
    """
    end = 0
    part = value
    while end < len(path):
        step = _STEP.match(path, end)
        if step is None:
            raise errors.BadPath(printable(path), "not a field; one is written data.points[0].x")
        part = _step(part, step, path)
        end = step.end()
    return part


def _step(value, step, path):
    name, index = step.groups()
    sort = "list" if isinstance(value, (bytes, str)) else _sort(value)
    if index is not None:
        if sort == "list" and int(index) < len(value):
            return value[int(index)]
        there = f"{len(value)} elements" if sort == "list" else "it is not a sequence"
    elif sort == "struct":
        if name in vars(value):
            return vars(value)[name]
        there = "there are " + ", ".join(vars(value))
    elif sort == "union":
        if name == "_d" or name == _case(value):
            return value._d if name == "_d" else value._v
        there = f"it holds {_case(value)} now"
    elif sort == "list":
        there = "a sequence has no fields"
    else:
        there = "a plain value has no fields"
    name = step.group().lstrip(".")
    raise errors.NoSuch(printable(path), "field", f"{name} ({there})")


# ---- bytes of an unknown type ----


def raw(data, little=True, limit=None):
    """Lines about bytes of an unknown type: their number, a hex dump, and guesses at what they are."""
    lines = [f"{len(data)} bytes"]
    shown = data[:limit]
    for offset in range(0, len(shown), 16):
        row = shown[offset : offset + 16]
        characters = "".join(map(_character, row))
        lines.append(f"{offset:08x}  {_hex(row):48} {characters}")
    if len(shown) < len(data):
        lines.append("… %d more" % (len(data) - len(shown)))
    guesses = _guesses(data, "<") if little else _guesses(data, ">")
    return lines + ["maybe: " + guess for guess in guesses]


def _character(byte):
    return chr(byte) if 32 <= byte < 127 else "."


def _guesses(data, order):
    """Guesses: a time at the start, then numbers of one kind, or text."""
    guesses = []
    start = 0
    if len(data) >= 8:
        sec, nsec = struct.unpack_from(order + "II", data)
        is_of_our_time = 946684800 <= sec < 4102444800 or sec == nsec == 0  # the years 2000 to 2099
        if nsec < 1000000000 and is_of_our_time:
            guesses.append("time %d.%09d" % (sec, nsec))
            start = 8
    size = len(data) - start
    for width, code, words in SCALARS:
        if size != width:
            continue
        (number,) = struct.unpack_from(order + code, data, start)
        if isinstance(number, int) or number == 0 or 1e-9 < abs(number) < 1e12:
            guesses.append(f"{words} {number!r}")
    if size >= 5:
        (count,) = struct.unpack_from(order + "I", data, start)
        if count == size - 4 and data[-1:] == b"\0":
            shown = data[start + 4 : -1].decode("utf-8", "surrogateescape")
            guesses.append(f"string '{printable(shown[:SHOWN])}'")
        for width, words in ((1, "octets"), (2, "shorts"), (4, "longs or floats"), (8, "doubles")):
            head = start + 4 + (-(start + 4) % width)
            if count and len(data) == head + count * width:
                guesses.append("sequence of %d %s" % (count, words))
    return guesses
