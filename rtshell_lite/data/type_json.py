"""A data type as JSON, for log files: read without any IDL or ORB, and nothing in it is believed unchecked.

    "long"  "string"  ["string", bound]  ["sequence", type, bound]  ["array", type, length]  ["alias", id, name, type]
    ["struct", id, name, [[member, type], …]]  ["enum", id, name, [item, …]]
    ["union", id, name, type, index of the default or -1, [[label, member, type], …]]   an enum's label is its item's number
    ["object", id, name]  ["fixed", digits, scale]   of which no values are read
    ["see", id]  a struct, union or enum that stands before or around
"""
import json

from rtshell_lite import errors
from rtshell_lite.corba import descriptors
from rtshell_lite.corba.descriptors import ALIAS, ARRAY, ENUM, FIXED, INDIRECT, OBJECT, SEQUENCE, STRING, STRUCT, WSTRING, kind

LARGEST = 1 << 20  # bytes of a type
_KINDS = {words: kind for kind, words in descriptors.NAMES.items()}


def plain(descriptor, seen=None):
    """A descriptor as lists, texts and numbers."""
    seen = set() if seen is None else seen
    sort = kind(descriptor)
    if not isinstance(descriptor, tuple):
        return descriptors.NAMES[descriptor]
    if sort in (STRING, WSTRING):
        return ["string" if sort == STRING else "wstring", descriptor[1]]
    if sort in (SEQUENCE, ARRAY):
        return ["sequence" if sort == SEQUENCE else "array", plain(descriptor[1], seen), descriptor[2]]
    if sort == ALIAS:
        return ["alias", descriptor[1], descriptor[2], plain(descriptor[3], seen)]
    if sort in (OBJECT, FIXED):
        return ["object" if sort == OBJECT else "fixed", descriptor[1], descriptor[2]]
    identifier = descriptors.type_id(descriptor)
    if identifier in seen:
        return ["see", identifier]
    if sort == INDIRECT:
        return plain(descriptor[1][0], seen)
    seen.add(identifier)
    if sort == ENUM:
        return ["enum", identifier, descriptor[2], [item._n for item in descriptor[3]]]
    if sort == STRUCT:
        return ["struct", identifier, descriptor[3], [[name, plain(inner, seen)] for name, inner in descriptors.members(descriptor)]]
    return ["union", identifier, descriptor[3], plain(descriptor[4], seen), descriptor[5],
            [[getattr(label, "_v", label), name, plain(inner, seen)] for label, name, inner in descriptor[6]]]


def descriptor(data):
    """The descriptor for the JSON bytes of `plain`'s answer. Raises BadType."""
    if len(data) > LARGEST:
        raise errors.BadType("a type of %d bytes" % len(data), "is too large")
    try:
        lists = json.loads(data.decode("ascii"))
        return _Reading().take(lists, descriptors.DEEPEST)
    except (ValueError, TypeError, KeyError, IndexError, RecursionError) as e:
        raise errors.BadType("a type in a file", "garbled (%s)" % type(e).__name__)


class _Reading:
    def __init__(self):
        self.left, self.known = descriptors.LARGEST, {}  # with the weight of each: a small text may mean a large type
        self.sequences, self.open = 0, {}  # sequences around this place; around the beginning of each open struct or union

    def take(self, part, depth):
        self.left -= 1
        if depth < 0 or self.left < 0:
            raise errors.BadType("a type in a file", "is nested too deep or too large")
        if isinstance(part, str):
            return _KINDS[part]
        return getattr(self, "_" + part[0] if part[0] in _WORDS else "_unknown")(depth - 1, *part[1:])

    def _unknown(self, *_):
        raise ValueError("word")

    def _string(self, depth, bound):
        descriptors.check_length(SEQUENCE, bound)
        return (STRING, bound)

    def _wstring(self, depth, bound):
        descriptors.check_length(SEQUENCE, bound)
        return (WSTRING, bound)

    def _sequence(self, depth, element, bound):
        descriptors.check_length(SEQUENCE, bound)
        self.sequences += 1
        taken = self.take(element, depth)
        self.sequences -= 1
        return (SEQUENCE, taken, bound)

    def _array(self, depth, element, length):
        descriptors.check_length(ARRAY, length)
        return descriptors.array(self.take(element, depth), length)

    def _object(self, depth, identifier, name):
        return (OBJECT, _text(identifier), _text(name))

    def _fixed(self, depth, digits, scale):
        if not all(isinstance(each, int) for each in (digits, scale)):
            raise ValueError("not a number")
        return (FIXED, digits, scale)

    def _alias(self, depth, identifier, name, target):
        return (ALIAS, _text(identifier), _text(name), self.take(target, depth))

    def _enum(self, depth, identifier, name, items):
        made = descriptors.enum(_text(identifier), descriptors.check_identifier(name),
                                [descriptors.check_identifier(item) for item in items])
        return self._known(identifier, made, self.left)

    def _struct(self, depth, identifier, name, members):
        left, hole = self.left, self._open(identifier)
        made = descriptors.struct(_text(identifier), descriptors.check_identifier(name), [
            (descriptors.check_identifier(member), self.take(inner, depth)) for member, inner in members])
        descriptors.check_members(made)
        hole[0] = made
        return self._known(identifier, made, left)

    def _union(self, depth, identifier, name, discriminator, default, cases):
        left, hole = self.left, self._open(identifier)
        switch = self.take(discriminator, depth)
        if not isinstance(default, int) or not -1 <= default < len(cases):
            raise ValueError("default")
        made = descriptors.union(_text(identifier), descriptors.check_identifier(name), switch, [
            (descriptors.label(switch, value), descriptors.check_identifier(member), self.take(inner, depth))
            for value, member, inner in cases], default)
        hole[0] = made
        return self._known(identifier, made, left)

    def _open(self, identifier):
        hole = [None]
        self.known[_text(identifier)] = ((INDIRECT, hole), 1)
        self.open[identifier] = self.sequences
        return hole

    def _known(self, identifier, made, left):
        self.known[identifier] = (made, left - self.left)
        self.open.pop(identifier, None)
        return made

    def _see(self, depth, identifier):
        found, weight = self.known[identifier]
        self.left -= weight
        if self.left < 0 or self.open.get(identifier) == self.sequences:
            raise errors.BadType("a type in a file", "is too large, or contains itself")
        return found


_WORDS = ("string", "wstring", "sequence", "array", "alias", "enum", "struct", "union", "see", "object", "fixed")


def _text(word):
    if not isinstance(word, str):
        raise ValueError("not a text")
    return word
