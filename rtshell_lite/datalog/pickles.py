"""Reading pickles from untrusted files: this machine makes plain values and records, and calls nothing.

Python's own Unpickler, even with another find_class, calls what it finds, sets attributes, and believes
lengths. This one knows the opcodes that data needs. A class is only a name; an object is a Record of that
name with its attributes. Lengths are compared with the file. An opcode of one octet may make an object of a
hundred: so the objects have a limit that depends on what is read, and the opcodes have one, too.
"""

import codecs
import struct

from rtshell_lite.text import printable

LONGEST_LINE = 4096  # octets of a number or name that is written as a line (protocol 0)
LONGEST_NUMBER = 256  # octets of an integer
LARGEST = 256 << 20  # octets of one pickle
# opcodes that make a container: FEW, and one more for each SHARE octets, which those of data have, up to MOST
FEW = 50000
SHARE = 5
MOST = 2000000
MOST_OPCODES = 5000000


class Refused(Exception):
    """The pickle is damaged, or asks for what data does not need."""


class Class:
    """A class that is only a name, `module.name`."""

    def __init__(self, module, name):
        self.module = module
        self.name = name

    def __str__(self):
        return f"{self.module}.{self.name}"


class Record:
    """An object: its Class, and its attributes in `fields`."""

    __slots__ = ("type", "fields")

    def __init__(self, type):
        self.type = type
        self.fields = _NO_FIELDS


_NO_FIELDS = {}  # type: dict  # never changed; one for each of millions of objects would take much memory
_MARK = object()
# What protocols 0 and 1 write for an object, by its names in Python 2; see PickleMachine.reduce.
_RECONSTRUCTOR = Class("copy_reg", "_reconstructor")
_OBJECT = Class("__builtin__", "object")
_HELPERS = {
    ("copy_reg", "_reconstructor"): _RECONSTRUCTOR,
    ("copyreg", "_reconstructor"): _RECONSTRUCTOR,
    ("__builtin__", "object"): _OBJECT,
    ("builtins", "object"): _OBJECT,
}


class PickleMachine:
    """Reads successive pickles from a file of `size` octets;
    `is_known(module, name)` says which classes may appear.
    """

    def __init__(self, file, size, is_known):
        self._file = file
        self._size = size
        self._is_known = is_known
        self.position = 0  # where the next pickle begins

    def load(self):
        """The value of the pickle at `position`, which moves past it.
        Raises Refused; EOFError at the end of the file.
        """
        if self.position >= self._size:
            raise EOFError
        self._stack = []
        self._memo = []  # values in the order of their numbers, which costs less than a dictionary
        self._others = {}  # by number, where that is not the next one
        self._limit = min(self._size, self.position + LARGEST)
        self._file.seek(self.position)
        begin = self.position
        opcodes = 0
        count = 0
        try:
            code = self._read(1)
            while code != b".":
                opcodes += 1
                if code in _MAKING:
                    count += 1
                    if count > min(MOST, FEW + (self.position - begin) // SHARE):
                        raise Refused("too many values in few octets")
                if opcodes > MOST_OPCODES:
                    raise Refused("too many values")
                operation = _OPERATIONS.get(code)
                if operation is None:
                    raise Refused(f"opcode {code!r}")
                operation(self)
                code = self._read(1)
            value = self._pop()
            if self._stack:
                raise Refused("the opcodes do not fit")
        except (IndexError, KeyError, TypeError, ValueError, AttributeError, struct.error):
            raise Refused("the opcodes do not fit")
        return value

    # ---- octets ----

    def _read(self, count):
        if not 0 <= count <= self._limit - self.position:
            raise Refused("it does not end")
        data = self._file.read(count)
        self.position += len(data)
        if len(data) < count:  # the file has become shorter
            raise Refused("it does not end")
        return data

    def _number(self, form):
        return struct.unpack(form, self._read(struct.calcsize(form)))[0]

    def _line(self):
        line = self._file.readline(LONGEST_LINE)
        self.position += len(line)
        if not line.endswith(b"\n") or self.position > self._limit:
            raise Refused("a line without an end")
        return line[:-1].decode("latin-1")

    # ---- the stack ----

    def push(self, value):
        self._stack.append(value)

    def _pop(self):
        value = self._stack.pop()
        if value is _MARK:
            raise Refused("the opcodes do not fit")
        return value

    def _top(self):
        return self._stack[-1]

    def _to_mark(self):
        """Take all values above the last mark, and the mark."""
        for i in range(len(self._stack) - 1, -1, -1):
            if self._stack[i] is _MARK:
                values = self._stack[i + 1 :]
                del self._stack[i:]
                return values
        raise Refused("the opcodes do not fit")

    # ---- values ----

    def integer_line(self):
        line = self._line().rstrip("L")
        if len(line) > LONGEST_NUMBER:
            raise Refused("a number that cannot be")
        self.push({"00": False, "01": True}[line] if line in ("00", "01") else int(line))

    def long(self, form):
        count = self._number(form)
        if count > LONGEST_NUMBER:
            raise Refused("a number that cannot be")
        self.push(int.from_bytes(self._read(count), "little", signed=True))

    def string_line(self):
        """A string of protocol 0 is written as Python 2 would write it."""
        line = self._line()
        if len(line) < 2 or line[0] not in "'\"" or line[-1] != line[0]:
            raise Refused("no string")
        self.push(codecs.escape_decode(line[1:-1].encode("latin-1"))[0].decode("latin-1"))

    def unicode_line(self):
        self.push(self._line().encode("latin-1").decode("raw_unicode_escape"))

    def text(self, form):
        self.push(self._read(self._number(form)).decode("utf-8", "surrogatepass"))

    def old_string(self, form):
        """A string of Python 2, which does not distinguish text from octets;
        read as Latin-1 it is what omniORB calls text.
        """
        self.push(self._read(self._number(form)).decode("latin-1"))

    def octets(self, form):
        self.push(self._read(self._number(form)))

    # ---- containers ----

    def append(self, values):
        target = self._top()
        if not isinstance(target, list):
            raise Refused("no list")
        target.extend(values)

    def set(self, pairs):
        target = self._top()
        if not isinstance(target, dict):
            raise Refused("no dictionary")
        _fill(target, pairs)

    def make_tuple(self, count):
        self.push(tuple(reversed([self._pop() for _ in range(count)])))

    def make_dict(self, pairs):
        self.push(_fill({}, pairs))

    # ---- objects ----

    def find(self, module, name):
        """Push a class, which must be known."""
        if (module, name) in _HELPERS:
            self.push(_HELPERS[module, name])
        elif self._is_known(module, name):
            self.push(Class(module, name))
        else:
            raise Refused(
                f"{printable(module)}.{printable(name)} is not a class that a log holds; "
                "-m MODULE names a module of your own"
            )

    def find_on_stack(self):
        name = self._pop()
        module = self._pop()
        if type(name) is not str or type(module) is not str:
            raise Refused("a class without a name")
        self.find(module, name)

    def make(self, type, arguments):
        """Push an object of a class; there must be no arguments, for attributes come later."""
        if not isinstance(type, Class) or type in (_RECONSTRUCTOR, _OBJECT) or len(arguments):
            raise Refused("an object that is not made from a class alone")
        self.push(Record(type))

    def reduce(self):
        """Call the function with which protocols 0 and 1 make objects, and no other."""
        arguments = self._pop()
        function = self._pop()
        if function is not _RECONSTRUCTOR:
            raise Refused("a call")
        type, above, state = arguments
        if above is not _OBJECT or state is not None:
            raise Refused("a call")
        self.make(type, ())

    def build(self):
        """Set the attributes of an object."""
        state = self._pop()
        target = self._top()
        if not isinstance(target, Record) or not isinstance(state, dict) or target.fields:
            raise Refused("attributes without an object")
        target.fields = state  # not copied: a small pickle could ask for many copies


def _fill(target, values):
    if len(values) % 2:
        raise Refused("a key without a value")
    for key, value in zip(values[::2], values[1::2]):
        if type(key) is not str:  # anything else could be made to hash for ever
            raise Refused("a key that is not text")
        target[key] = value
    return target


def _instance(machine):
    module = machine._line()
    name = machine._line()
    machine.find(module, name)
    type = machine._pop()
    machine.make(type, machine._to_mark())


def _old_instance(machine):
    values = machine._to_mark()
    machine.make(values[0], values[1:])


def _new_instance(machine):
    arguments = machine._pop()
    type = machine._pop()
    machine.make(type, arguments)


def _frame(machine):
    if machine._number("<Q") > machine._limit - machine.position:
        raise Refused("it does not end")


def _protocol(machine):
    if machine._number("B") > 5:
        raise Refused("a later protocol of pickles")


def _remember(index):
    def remember(machine):
        number = index(machine)
        if number == len(machine._memo):
            machine._memo.append(machine._top())
        elif 0 <= number < len(machine._memo):
            machine._memo[number] = machine._top()
        else:
            machine._others[number] = machine._top()

    return remember


def _recall(index):
    def recall(machine):
        number = index(machine)
        if 0 <= number < len(machine._memo):
            machine.push(machine._memo[number])
        else:
            machine.push(machine._others[number])

    return recall


_OPERATIONS = {
    b"\x80": _protocol,
    b"\x95": _frame,
    b"(": lambda m: m.push(_MARK),
    b"0": lambda m: m._stack.pop(),
    b"1": lambda m: m._to_mark() and None,
    b"2": lambda m: m.push(m._top()),
    b"N": lambda m: m.push(None),
    b"\x88": lambda m: m.push(True),
    b"\x89": lambda m: m.push(False),
    b"I": PickleMachine.integer_line,
    b"L": PickleMachine.integer_line,
    b"J": lambda m: m.push(m._number("<i")),
    b"K": lambda m: m.push(m._number("<B")),
    b"M": lambda m: m.push(m._number("<H")),
    b"\x8a": lambda m: m.long("<B"),
    b"\x8b": lambda m: m.long("<I"),
    b"F": lambda m: m.push(float(m._line())),
    b"G": lambda m: m.push(m._number(">d")),
    b"S": PickleMachine.string_line,
    b"V": PickleMachine.unicode_line,
    b"U": lambda m: m.old_string("<B"),
    b"T": lambda m: m.old_string("<i"),
    b"X": lambda m: m.text("<I"),
    b"\x8c": lambda m: m.text("<B"),
    b"\x8d": lambda m: m.text("<Q"),
    b"C": lambda m: m.octets("<B"),
    b"B": lambda m: m.octets("<I"),
    b"\x8e": lambda m: m.octets("<Q"),
    b"\x96": lambda m: m.octets("<Q"),
    b"]": lambda m: m.push([]),
    b"l": lambda m: m.push(m._to_mark()),
    b"a": lambda m: m.append([m._pop()]),
    b"e": lambda m: m.append(m._to_mark()),
    b")": lambda m: m.push(()),
    b"t": lambda m: m.push(tuple(m._to_mark())),
    b"\x85": lambda m: m.make_tuple(1),
    b"\x86": lambda m: m.make_tuple(2),
    b"\x87": lambda m: m.make_tuple(3),
    b"}": lambda m: m.push({}),
    b"d": lambda m: m.make_dict(m._to_mark()),
    b"s": lambda m: m.set([m._pop(), m._pop()][::-1]),
    b"u": lambda m: m.set(m._to_mark()),
    b"p": _remember(lambda m: int(m._line())),
    b"q": _remember(lambda m: m._number("<B")),
    b"r": _remember(lambda m: m._number("<I")),
    b"\x94": _remember(lambda m: len(m._memo) + len(m._others)),
    b"g": _recall(lambda m: int(m._line())),
    b"h": _recall(lambda m: m._number("<B")),
    b"j": _recall(lambda m: m._number("<I")),
    b"c": lambda m: m.find(m._line(), m._line()),
    b"\x93": PickleMachine.find_on_stack,
    b"i": _instance,
    b"o": _old_instance,
    b"\x81": _new_instance,
    b"R": PickleMachine.reduce,
    b"b": PickleMachine.build,
}

# Those that make an object larger than a number.
_MAKING = frozenset(bytes((code,)) for code in b"]}ltdoiR\x81\x85\x86\x87")
