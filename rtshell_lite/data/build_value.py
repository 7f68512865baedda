"""Turns what a person or a program wrote into a value of a type; errors name the part that does not fit.

What is written consists of numbers, texts, bytes, True and False, lists, dicts (of JSON), a Call
(`RTC.Time(1, 2)`), a Word (an item of an enum), and values of the type itself.
"""

import math
import struct

from rtshell_lite import errors
from rtshell_lite.giop.descriptors import (
    CHAR, FLOAT, OCTET, RANGES, SEQUENCE, STRUCT, WCHAR, WSTRING, Visitor, bound, cases, cases_by_label,
    default_case, discriminator, dotted, element, factory, items, kind, length, members, target, type_id,
    words,
)
from rtshell_lite.records import record
from rtshell_lite.text import printable

# RTC.Time(1, nsec=2); positional a list, keywords a dict
Call = record("Call", "name positional keywords")
Word = record("Word", "name")  # RTC.GRIPPER_STATE_OPEN

DEEPEST = 100  # values inside values
MOST_LISTED = 20  # members of a struct, items of an enum that an error names
NUMBERS = {"NaN": float("nan"), "Infinity": float("inf"), "-Infinity": float("-inf")}  # not numbers in JSON


def real(word):
    """The number that a word with a point or an exponent says. Raises BadValue for one that no double holds:
    Infinity has to be meant.
    """
    number = float(word)
    if math.isinf(number):
        raise errors.BadValue(printable(word[:60]), "larger than any number; write Infinity if that is meant")
    return number


def build(descriptor, written, where, json=False, now=None, find=None):
    """The value of a type for what was `written`; `where` names it in errors: RTC.TimedLong.

    A text for octets is base64 with `json`, else text in UTF-8. `now`, (seconds, nanoseconds), is used for a
    timestamp that was left out or is the Word {time}; None is 0. An `any` is written {"_type": …, "_value":
    …}, where find(name) gives the descriptor of its type, a reference as an IOR or {"_ior": …}, nil as None.
    Raises BadValue, and what `find` raises.
    """
    builder = _Builder if find is None else _CallBuilder
    return builder(json, now or (0, 0), find).visit(descriptor, written, where, DEEPEST)


def timed(descriptor):
    """True for the standard timed types: a struct of `tm`, with sec and nsec, and `data`."""
    return (
        kind(descriptor) == STRUCT
        and [name for name, _ in members(descriptor)] == ["tm", "data"]
        and is_time(members(descriptor)[0][1])
    )


def is_time(descriptor):
    """True for a struct of sec and nsec."""
    descriptor = target(descriptor)
    if kind(descriptor) != STRUCT:
        return False
    return [name for name, _ in members(descriptor)] == ["sec", "nsec"]


class _Builder(Visitor):
    """Values that data ports have."""

    def __init__(self, json, now, find):
        self.json = json
        self.now = now
        self.find = find

    def visit(self, descriptor, written, where, depth):
        if depth < 0:
            raise errors.BadValue(where, "is nested too deep")
        return self.method(descriptor)(descriptor, written, where, depth)

    def other(self, descriptor, written, where, _):
        raise errors.BadValue(where, f"values of {words(descriptor)} cannot be made")

    def boolean(self, descriptor, written, where, _):
        if isinstance(written, int) and written in (0, 1):
            return bool(written)
        return _unfit(descriptor, written, where)

    def integer(self, descriptor, written, where, _):
        if kind(descriptor) == OCTET and isinstance(written, bytes) and len(written) == 1:
            return written[0]
        if isinstance(written, bool) or not isinstance(written, int):
            _unfit(descriptor, written, where)
        low, high = RANGES[kind(descriptor)]
        if not low <= written <= high:
            raise errors.BadValue(
                where, "out of range for %s (%d to %d): %s" % (_a(descriptor), low, high, _shown(written))
            )
        return written

    def real(self, descriptor, written, where, _):
        if isinstance(written, Word):
            written = NUMBERS.get(written.name, written)
        elif isinstance(written, str) and self.json:
            written = NUMBERS.get(written, written)
        if isinstance(written, bool) or not isinstance(written, (int, float)):
            _unfit(descriptor, written, where)
        try:
            number = float(written)
            if kind(descriptor) == FLOAT:
                struct.pack("<f", number)
        except OverflowError:
            raise errors.BadValue(where, f"out of range for {_a(descriptor)}: {_shown(written)}")
        return number

    longdouble = real

    def fixed(self, descriptor, written, where, _):
        """A number, or a text for one with many digits."""
        if isinstance(written, bool) or not isinstance(written, (int, float, str)):
            _unfit(descriptor, written, where)
        from rtshell_lite.giop import rare

        try:
            return rare.fixed(str(written), *descriptor[1:])
        except ValueError as e:
            raise errors.BadValue(where, f"{e}: {_shown(written)}")

    def char(self, descriptor, written, where, _):
        highest = "\xff" if kind(descriptor) == CHAR else "\uffff"
        if not isinstance(written, str) or len(written) != 1 or written > highest:
            _unfit(descriptor, written, where)
        return written

    wchar = char

    def string(self, descriptor, written, where, _):
        wide = kind(descriptor) == WSTRING
        if not isinstance(written, str):
            _unfit(descriptor, written, where)
        try:
            size = len(written) if wide else len(written.encode("utf-8", "surrogateescape"))
        except UnicodeEncodeError:
            _unfit(descriptor, written, where)
        if "\0" in written:
            raise errors.BadValue(where, f"a {words(descriptor)} holds no NUL")
        most = bound(descriptor)
        if most and size > most and wide:
            raise errors.BadValue(where, f"longer than {most} characters")
        if most and size > most:
            raise errors.BadValue(where, f"longer than {most} bytes of UTF-8")
        return written

    wstring = string

    def enum(self, descriptor, written, where, _):
        enumerators = items(descriptor)
        name = getattr(written, "_n", None)
        if not name and isinstance(written, Word):
            name = written.name
        elif not name:
            name = written
        for item in enumerators:
            if isinstance(name, str) and item._n == name.rpartition(".")[2]:
                return item
        is_number = isinstance(name, int) and not isinstance(name, bool)
        if is_number and 0 <= name < len(enumerators):
            return enumerators[name]
        shown = f"{_shown(written)} (they are {_listed([item._n for item in enumerators])})"
        raise errors.BadValue(where, f"no {words(descriptor)}: {shown}")

    def sequence(self, descriptor, written, where, depth):
        sort = kind(target(element(descriptor)))
        if sort == OCTET and isinstance(written, (str, bytes)):
            written = self._octets(written, where)
        elif isinstance(written, str) and sort == CHAR and all(c <= "\xff" for c in written):
            pass
        elif isinstance(written, str) and sort == WCHAR:
            written = list(written)
        elif not isinstance(written, (list, tuple)) or isinstance(written, (Call, Word)):
            _unfit(descriptor, written, where)
        count = length(descriptor)
        size = len(written)
        if count and kind(descriptor) == SEQUENCE and size > count:
            raise errors.BadValue(where, f"{size} elements, not up to {count}")
        if count and kind(descriptor) != SEQUENCE and size != count:
            raise errors.BadValue(where, f"{size} elements, not {count}")
        if isinstance(written, (str, bytes)):
            return written
        values = [
            self.visit(element(descriptor), part, f"{where}[{i}]", depth - 1)
            for i, part in enumerate(written)
        ]
        if sort == OCTET:
            return bytes(values)
        if sort == CHAR:
            return "".join(values)
        return values

    array = sequence

    def _octets(self, written, where):
        if isinstance(written, bytes):
            return written
        import base64  # few values have octets, and it takes long

        try:
            if self.json:
                return base64.b64decode(written.encode("ascii"), validate=True)
            return written.encode("utf-8", "surrogateescape")
        except ValueError:
            raise errors.BadValue(
                where, f"octets are written as a list of numbers or in base64: {_shown(written)}"
            )

    def struct(self, descriptor, written, where, depth):
        if is_time(descriptor) and written == Word("{time}"):
            return factory(descriptor)(*self.now)
        given = self._given(descriptor, written, where)
        if given is None and timed(descriptor):
            given = {"data": written}
        if given is None and is_time(descriptor):
            _unfit(descriptor, written, where, "; {time} is the present")
        if given is None:
            _unfit(descriptor, written, where, _members(descriptor))
        values = []
        for name, inner in members(descriptor):
            if name == "tm" and name not in given and is_time(inner):
                given[name] = Word("{time}")
            if name not in given:
                raise errors.BadValue(where, f"{name} is missing")
            member = f"{where}: {name}" if " " not in where else f"{where}.{name}"
            values.append(self.visit(inner, given[name], member, depth - 1))
        return factory(descriptor)(*values)

    def _given(self, descriptor, written, where):
        """{member: what was written for it} of a struct; None when what was written cannot be a struct."""
        names = [name for name, _ in members(descriptor)]
        if isinstance(written, dict):
            given = dict(written)
        elif isinstance(written, Call):
            if not fits(written.name, descriptor):
                raise errors.BadValue(where, f"not {_a(descriptor)}: {printable(written.name)}")
            given = self._arguments(names, written, where)
        elif hasattr(written, "__dict__") and not hasattr(written, "_n"):
            given = dict(vars(written))
        else:
            return None
        given = {_member(names, name): value for name, value in given.items()}
        unknown = sorted(str(name) for name in given if name not in names)
        if unknown:
            raise errors.BadValue(where, f"no member {printable(unknown[0])}{_members(descriptor)}")
        return given

    def _arguments(self, names, call, where):
        positional = call.positional
        if len(positional) > len(names):
            raise errors.BadValue(
                where, f"takes {len(names)} values ({', '.join(names)}), not {len(positional)}"
            )
        given = dict(zip(names, positional))
        for name, value in call.keywords.items():
            if _member(names, name) in given:
                raise errors.BadValue(where, f"{printable(name)} is given twice")
            given[_member(names, name)] = value
        return given

    def union(self, descriptor, written, where, depth):
        make = factory(descriptor)
        all_cases = cases(descriptor)
        if isinstance(written, Call):
            if not fits(written.name, descriptor):
                raise errors.BadValue(where, f"not {_a(descriptor)}: {printable(written.name)}")
            written = dict(written.keywords, **dict(zip(("_d", "_v"), written.positional)))
        elif not isinstance(written, dict):
            written = {name: getattr(written, name) for name in ("_d", "_v") if hasattr(written, name)}
        names = [case.member for case in all_cases]
        given = [name for name in written if name != "_d"]
        unknown = [name for name in given if name not in names and name != "_v"]
        if len(given) > 1 or unknown or not written:
            raise errors.BadValue(where, f"a {words(descriptor)} is one of {', '.join(names)}")
        if "_d" in written:
            label = self.visit(discriminator(descriptor), written["_d"], where + " discriminator", depth - 1)
        else:
            label = next((case.label for case in all_cases if case.member == given[0]), None)
        case = cases_by_label(descriptor).get(label, default_case(descriptor))
        if case is None:
            return make(label, None)
        if not given or given[0] not in (case.member, "_v"):
            raise errors.BadValue(where, f"with discriminator {label} it holds {case.member}")
        content = self.visit(case.type, written[given[0]], f"{where}.{case.member}", depth - 1)
        return make(label, content)


class _CallBuilder(_Builder):
    """Those, and what only calls have."""

    def any(self, descriptor, written, where, depth):
        from rtshell_lite.data import type_names
        from rtshell_lite.giop.marshal import Any

        if isinstance(written, Any):
            return written
        if not isinstance(written, dict) or set(written) != {"_type", "_value"}:
            _unfit(descriptor, written, where, ': write {"_type": "long", "_value": 42}')
        if not isinstance(written["_type"], str):
            _unfit(descriptor, written["_type"], where + " _type")
        inner = type_names.descriptor(written["_type"], self.find)
        if inner in (0, 1):
            return Any(inner, None)
        return Any(inner, self.visit(inner, written["_value"], where, depth - 1))

    def typecode(self, descriptor, written, where, _):
        from rtshell_lite.data import type_names
        from rtshell_lite.giop.marshal import TypeCode

        if isinstance(written, TypeCode):
            return written
        if isinstance(written, Word):
            written = written.name
        if not isinstance(written, str):
            _unfit(descriptor, written, where, ": the name of a type is wanted")
        return TypeCode(type_names.descriptor(written, self.find))

    def reference(self, descriptor, written, where, _):
        from rtshell_lite.giop import ior, references

        if isinstance(written, references.Reference) or written is None:
            return written
        if isinstance(written, dict) and "_ior" in written:
            written = written["_ior"]
        if isinstance(written, Word):
            written = written.name
        if not isinstance(written, str):
            _unfit(descriptor, written, where, ": an IOR is wanted")
        try:
            return references.from_text(ior.checked(written.strip()))
        except ior.BadReference as e:
            raise errors.BadValue(where, str(e))


def fits(name, descriptor):
    """Whether a name, with or without its modules, can mean this struct or union."""
    parts = [part for part in name.replace("::", ".").split(".") if part]
    if not parts:
        return False
    return dotted(type_id(descriptor)).split(".")[-len(parts) :] == parts


def _member(names, name):
    """The member that a name means; one that is a keyword of Python may begin with _, as in stubs."""
    if name in names or not isinstance(name, str):
        return name
    if name[:1] == "_" and name[1:] in names:
        return name[1:]
    if "_" + name in names:
        return "_" + name
    return name


def _unfit(descriptor, written, where, hint=""):
    raise errors.BadValue(where, f"not {_a(descriptor)}: {_shown(written)}{hint}")


def _members(descriptor):
    return f" (its members: {printable(_listed([name for name, _ in members(descriptor)]))})"


def _listed(names):
    return ", ".join(names[:MOST_LISTED]) + (", …" if len(names) > MOST_LISTED else "")


def _a(descriptor):
    name = words(descriptor)
    if name[0] in "aeioAEIO" or name.startswith("unsigned"):
        return "an " + name
    return "a " + name


def _shown(written):
    """What was written, shortened for an error line."""
    if isinstance(written, (Call, Word)):
        return printable(written.name)
    if isinstance(written, float) and not math.isfinite(written):
        return str(written)
    if isinstance(written, dict) or hasattr(written, "__dict__") and not hasattr(written, "_n"):
        shown = "{…}"
    else:
        if isinstance(written, (list, str, bytes)):
            written = written[:10]
        shown = repr(written)
    if len(shown) > 60:
        shown = shown[:60] + "…"
    return printable(shown)
