"""Random values of any data type, and their comparison."""
import math
import struct

from rtshell_lite.giop import descriptors, marshal, rare, references
from rtshell_lite.giop.descriptors import (
    ANY,
    ARRAY,
    BOOLEAN,
    CHAR,
    DOUBLE,
    ENUM,
    FIXED,
    FLOAT,
    OBJECT,
    OCTET,
    RANGES,
    SEQUENCE,
    STRING,
    STRUCT,
    TYPECODE,
    UNION,
    WCHAR,
    WSTRING,
    kind,
    target,
)

LETTERS = "ab'\"\\{}\n\x1b é日本\u202e"


def value(rng, descriptor, depth=4):
    """A value of a type; sequences run dry with the depth."""
    descriptor = target(descriptor)
    sort = kind(descriptor)
    if sort in RANGES:
        low, high = RANGES[sort]
        return rng.choice((low, high, 0, rng.randint(low, high)))
    if sort in (FLOAT, DOUBLE):
        number = rng.choice(
            (0.0, -1.5, float("inf"), float("-inf"), float("nan"), 0.1, rng.uniform(-1e9, 1e9), 1e-30)
        )
        return struct.unpack("<f", struct.pack("<f", number))[0] if sort == FLOAT else number
    if sort == BOOLEAN:
        return rng.random() < 0.5
    if sort == CHAR:
        return rng.choice("aZ'\\\x00\xe9\xff")
    if sort == WCHAR:
        return rng.choice("aé日'\\")
    if sort in (STRING, WSTRING):
        text = "".join(rng.choice(LETTERS) for _ in range(rng.randrange(6)))
        if not descriptor[1]:
            return text
        octets = 1 if sort == WSTRING else 4  # at most, of a letter
        return text[:descriptor[1] // octets]
    if sort == ENUM:
        return rng.choice(descriptor[3])
    if sort in (SEQUENCE, ARRAY):
        if sort == ARRAY:
            size = descriptor[2]
        elif depth > 0:
            size = rng.randrange(min(descriptor[2] or 5, 5) + 1)
        else:
            size = 0
        values = [value(rng, descriptor[1], depth - 1) for _ in range(size)]
        inner = kind(target(descriptor[1]))
        if inner == OCTET:
            return bytes(values)
        if inner == CHAR:
            return "".join(values)
        return values
    if sort == STRUCT:
        return descriptor[1](*[value(rng, inner, depth - 1) for _, inner in descriptors.members(descriptor)])
    if sort == FIXED:
        return rare.fixed(
            "%s%d.%s"
            % (
                rng.choice(("", "-")),
                rng.randrange(10 ** (descriptor[1] - descriptor[2])),
                "%0*d" % (descriptor[2], rng.randrange(10 ** descriptor[2])),
            ),
            *descriptor[1:]
        )
    if sort == OBJECT:
        return rng.choice((None, references.make_reference("127.0.0.1", 1, b"key")))
    if sort == TYPECODE:
        return marshal.TypeCode(rng.choice((2, (STRING, 0), (SEQUENCE, (SEQUENCE, 3, 0), 4))))
    if sort == ANY:
        inner = rng.choice(
            (3, DOUBLE, (STRING, 0), (WSTRING, 0), (SEQUENCE, BOOLEAN, 0), (SEQUENCE, ANY, 0), (FIXED, 4, 2))
        )
        return marshal.Any(inner, value(rng, inner, depth - 1))
    assert sort == UNION
    label = rng.choice([case[0] for case in descriptor[6]] + [value(rng, descriptor[4])])
    case = descriptor[8].get(label, descriptor[7])
    return descriptor[1](label, value(rng, case[2], depth - 1) if case else None)


def plain(found):
    """A value in a form in which equal ones compare equal, with NaN equal to itself."""
    if isinstance(found, float):
        return "NaN" if math.isnan(found) else found
    if isinstance(found, (str, int, bytes)) or found is None:
        return found
    if isinstance(found, (list, tuple)):
        return [plain(each) for each in found]
    if hasattr(found, "_n"):
        return found._n
    return {name: plain(inner) for name, inner in vars(found).items()}
