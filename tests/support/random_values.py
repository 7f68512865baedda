"""Random values of any data type, and their comparison."""
import math
import struct

from rtshell_lite.giop import descriptors, marshal, rare, references

LETTERS = "ab'\"\\{}\n\x1b é日本\u202e"
# types that a TypeCode names, and those of what an any holds
CODES = (2, (descriptors.STRING, 0), (descriptors.SEQUENCE, (descriptors.SEQUENCE, 3, 0), 4))
CONTENTS = (3, descriptors.DOUBLE, (descriptors.STRING, 0), (descriptors.WSTRING, 0),
            (descriptors.SEQUENCE, descriptors.BOOLEAN, 0), (descriptors.SEQUENCE, descriptors.ANY, 0),
            (descriptors.FIXED, 4, 2))


def value(rng, descriptor, depth=4):
    """A value of a type; sequences run dry with the depth."""
    descriptor = descriptors.target(descriptor)
    sort = descriptors.kind(descriptor)
    if sort in descriptors.RANGES:
        low, high = descriptors.RANGES[sort]
        return rng.choice((low, high, 0, rng.randint(low, high)))
    if sort in (descriptors.FLOAT, descriptors.DOUBLE):
        number = rng.choice((0.0, -1.5, float("inf"), float("-inf"), float("nan"), 0.1,
                             rng.uniform(-1e9, 1e9), 1e-30))
        return struct.unpack("<f", struct.pack("<f", number))[0] if sort == descriptors.FLOAT else number
    if sort == descriptors.BOOLEAN:
        return rng.random() < 0.5
    if sort == descriptors.CHAR:
        return rng.choice("aZ'\\\x00\xe9\xff")
    if sort == descriptors.WCHAR:
        return rng.choice("aé日'\\")
    if sort in (descriptors.STRING, descriptors.WSTRING):
        text = "".join(rng.choice(LETTERS) for _ in range(rng.randrange(6)))
        if not descriptor[1]:
            return text
        octets = 1 if sort == descriptors.WSTRING else 4  # at most, of a letter
        return text[:descriptor[1] // octets]
    if sort == descriptors.ENUM:
        return rng.choice(descriptor[3])
    if sort in (descriptors.SEQUENCE, descriptors.ARRAY):
        return _elements(rng, descriptor, depth)
    if sort == descriptors.STRUCT:
        return descriptor[1](*[value(rng, inner, depth - 1) for _, inner in descriptors.members(descriptor)])
    if sort == descriptors.FIXED:
        digits, places = descriptor[1:]
        sign = rng.choice(("", "-"))
        whole = rng.randrange(10 ** (digits - places))
        text = "%s%d.%0*d" % (sign, whole, places, rng.randrange(10 ** places))
        return rare.fixed(text, digits, places)
    if sort == descriptors.OBJECT:
        return rng.choice((None, references.make_reference("127.0.0.1", 1, b"key")))
    if sort == descriptors.TYPECODE:
        return marshal.TypeCode(rng.choice(CODES))
    if sort == descriptors.ANY:
        inner = rng.choice(CONTENTS)
        return marshal.Any(inner, value(rng, inner, depth - 1))
    assert sort == descriptors.UNION
    label = rng.choice([case[0] for case in descriptor[6]] + [value(rng, descriptor[4])])
    case = descriptor[8].get(label, descriptor[7])
    return descriptor[1](label, value(rng, case[2], depth - 1) if case else None)


def _elements(rng, descriptor, depth):
    """The value of a sequence or an array."""
    if descriptors.kind(descriptor) == descriptors.ARRAY:
        size = descriptor[2]
    elif depth > 0:
        size = rng.randrange(min(descriptor[2] or 5, 5) + 1)
    else:
        size = 0
    values = [value(rng, descriptor[1], depth - 1) for _ in range(size)]
    inner = descriptors.kind(descriptors.target(descriptor[1]))
    if inner == descriptors.OCTET:
        return bytes(values)
    if inner == descriptors.CHAR:
        return "".join(values)
    return values


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
