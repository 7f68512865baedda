"""Data types in the words of MCAP: as `ros2msg`, which everything reads, else as `omgidl`; and the reverse.

ros2msg: the fields, one a line; then for each type that they use a line of 80 `=`, `MSG: package/Name`, its
fields. It has no unions, no wide text, no sequences of sequences, and names that begin in lower case.
"""

import re

from rtshell_lite import errors
from rtshell_lite.giop import descriptors
from rtshell_lite.giop.descriptors import (
    ALIAS, ARRAY, CHAR, ENUM, INDIRECT, OCTET, SEQUENCE, STRING, STRUCT, UNION, kind
)
from rtshell_lite.data import datatypes
from rtshell_lite.text import printable

LINE = "=" * 80
LONGEST = 1 << 20  # characters of a schema
_BASIC = {
    descriptors.SHORT: "int16",
    descriptors.LONG: "int32",
    descriptors.USHORT: "uint16",
    descriptors.ULONG: "uint32",
    descriptors.FLOAT: "float32",
    descriptors.DOUBLE: "float64",
    descriptors.BOOLEAN: "bool",
    CHAR: "uint8",
    OCTET: "uint8",
    descriptors.LONGLONG: "int64",
    descriptors.ULONGLONG: "uint64",
}
# no type of IDL has a sign and 8 bits
_KINDS = dict({word: sort for sort, word in _BASIC.items()}, uint8=OCTET, byte=OCTET, char=OCTET)
_STRING = (STRING, 0)
_PACKAGE = re.compile(r"(?!.*__)(?!.*_\Z)[a-z][a-z0-9_]*\Z")
_MESSAGE = re.compile(r"[A-Z][A-Za-z0-9]*\Z")
_FIELD = re.compile(
    r"(?P<type>[A-Za-z][\w/]*)(?:<=(?P<bound>\d{1,9}))?(?P<many>\[(?:<=)?\d{0,9}\])?"
    r"\s+(?P<name>[A-Za-z]\w*)(?P<rest>\s*=.*|.*)\Z",
    re.ASCII,
)
# which everybody's reader knows, and their files do not describe
_BUILT_IN = {
    "builtin_interfaces/Time": ("int32 sec", "uint32 nanosec"),
    "builtin_interfaces/Duration": ("int32 sec", "uint32 nanosec"),
}


EVENT = "rtlog.Event"  # the type of what happens to a robot, whose `mark` plots show


def of_json(name, fields):
    """(name, encoding, data) for messages of JSON; `fields`: {name: type}."""
    import json

    properties = {field: {"type": kind} for field, kind in fields.items()}
    described = {"title": name, "type": "object", "properties": properties}
    return name, "jsonschema", json.dumps(described, sort_keys=True).encode("ascii")


def of_events():
    return of_json(EVENT, dict.fromkeys(("path", "kind", "subject", "event", "mark"), "string"))


class _NotExpressible(Exception):
    """A type that this language has no words for."""


def of_type(type):
    """(name, encoding, data) for a datatypes.Type; None where neither language has words for it."""
    for make in (_ros2msg, _omgidl):
        try:
            return make(type.descriptor)
        except (_NotExpressible, RecursionError):
            pass
    return None


# ---- ros2msg ----


def _ros2msg(descriptor):
    if kind(descriptors.target(descriptor)) != STRUCT:
        raise _NotExpressible
    messages = {}  # name: (repository id, lines), in the order of their use
    root = _message(descriptors.target(descriptor), messages)
    parts = ["\n".join(messages[root][1])]
    parts += [
        "%s\nMSG: %s\n%s" % (LINE, name, "\n".join(lines))
        for name, (_, lines) in messages.items()
        if name != root
    ]
    return root, "ros2msg", ("\n".join(parts) + "\n").encode("ascii")


def _message(descriptor, messages):
    """The name of a struct, which is put into `messages` with those that it uses."""
    type_id = descriptors.type_id(descriptor)
    module, dot, last = descriptors.dotted(type_id).rpartition(".")
    package = module.replace(".", "_").lower()
    name = f"{package}/{last}"
    if not _PACKAGE.match(package) or not _MESSAGE.match(last):
        raise _NotExpressible
    if name in messages:
        if messages[name][0] != type_id:
            raise _NotExpressible
        return name
    messages[name] = (type_id, [])
    for member, inner in descriptors.members(descriptor):
        if not _PACKAGE.match(member):  # the rule for names of fields, too
            raise _NotExpressible
        messages[name][1].append(f"{_words(inner, messages)} {member}")
    return name


def _words(descriptor, messages):
    """The type of a field."""
    inner = descriptors.plain(descriptor)
    sort = kind(inner)
    if sort == SEQUENCE:
        most = descriptors.length(inner)
        if most:
            return "%s[<=%d]" % (_single(descriptors.element(inner), messages), most)
        return _single(descriptors.element(inner), messages) + "[]"
    if sort == ARRAY:
        return "%s[%d]" % (_single(descriptors.element(inner), messages), descriptors.length(inner))
    return _single(inner, messages)


def _single(descriptor, messages):
    inner = descriptors.plain(descriptor)
    sort = kind(inner)
    if sort == STRUCT:
        return _message(inner, messages)
    if sort == ENUM:
        return "uint32"
    if sort == STRING:
        if descriptors.bound(inner):
            raise _NotExpressible
        return "string"
    if sort not in _BASIC:
        raise _NotExpressible
    return _BASIC[sort]


# ---- omgidl ----


def _omgidl(descriptor):
    if kind(descriptors.target(descriptor)) not in (STRUCT, UNION):
        raise _NotExpressible
    definitions = {}  # repository id: definition
    root = _reference(descriptors.target(descriptor), definitions)
    return root, "omgidl", "\n".join(definitions.values()).encode("ascii")


def _reference(descriptor, definitions):
    """The word for a type; those with a name are defined first."""
    sort = kind(descriptor)
    if sort == INDIRECT:
        raise _NotExpressible
    if sort in (STRUCT, UNION, ENUM, ALIAS):
        type_id = descriptors.type_id(descriptor)
        if type_id not in definitions:
            definitions[type_id] = _inside_modules(
                descriptors.dotted(type_id), _definition(descriptor, definitions)
            )
        return descriptors.dotted(type_id).replace(".", "::")
    if sort == SEQUENCE:
        most = descriptors.length(descriptor)
        return "sequence<%s%s>" % (
            _reference(descriptors.element(descriptor), definitions), ", %d" % most if most else "",
        )
    if sort not in descriptors.VALUES + (STRING, descriptors.WSTRING):
        raise _NotExpressible
    return descriptors.words(descriptor)


def _inside_modules(name, definition):
    modules = name.split(".")[:-1]
    if not all(re.match(r"[A-Za-z]\w*\Z", module, re.ASCII) for module in modules):
        raise _NotExpressible
    return "".join(f"module {module} {{ " for module in modules) + definition + " };" * len(modules)


def _definition(descriptor, definitions):
    sort = kind(descriptor)
    if sort == ENUM:
        return "enum %s { %s };" % (
            descriptor[2], ", ".join(item._n for item in descriptors.items(descriptor)),
        )
    if sort == ALIAS:
        return "typedef %s;" % _declared(descriptors.aliased(descriptor), descriptor[2], definitions)
    if sort == STRUCT:
        members = [
            _declared(inner, member, definitions) + "; " for member, inner in descriptors.members(descriptor)
        ]
        return "struct %s { %s};" % (descriptor[3], "".join(members))
    switch = descriptors.discriminator(descriptor)
    cases = [
        "%s: %s; " % (_label(descriptor, index, case), _declared(case.type, case.member, definitions))
        for index, case in enumerate(descriptors.cases(descriptor))
    ]
    return "union %s switch (%s) { %s};" % (descriptor[3], _reference(switch, definitions), "".join(cases))


def _declared(descriptor, name, definitions):
    lengths = ""
    while kind(descriptor) == ARRAY:
        lengths += "[%d]" % descriptors.length(descriptor)
        descriptor = descriptors.element(descriptor)
    return f"{_reference(descriptor, definitions)} {name}{lengths}"


def _label(descriptor, index, case):
    if index == descriptors.default_index(descriptor):
        return "default"
    switch = descriptors.target(descriptors.discriminator(descriptor))
    if kind(switch) == ENUM:
        return f"case {case.label._n}"  # in the scope of its enum, where readers look for it
    if isinstance(case.label, bool):
        return "case " + str(case.label).upper()
    if isinstance(case.label, str):
        raise _NotExpressible
    return "case %d" % case.label


# ---- the reverse ----


def type_id(name):
    """The repository id for the name of a schema: that of a standard type where there is one."""
    parts = [part for part in re.split(r"::|/|\.", name) if part]
    if len(parts) == 3 and parts[1] == "msg":
        del parts[1]
    if len(parts) == 2:
        for module in datatypes.STANDARD:
            if module.lower() == parts[0].lower() and datatypes.standard(f"{module}.{parts[1]}"):
                parts[0] = module
    return "IDL:%s:1.0" % "/".join(parts)


def to_type(schema):
    """The datatypes.Type that a schema (name, encoding, data) describes. Raises BadType, BadIdl."""
    name, encoding, data = schema
    if len(data) > LONGEST:
        raise errors.BadType(printable(name), "too large")
    text = data.decode("utf-8", "replace")
    if encoding == "ros2msg":
        return datatypes.Type(descriptors.adopted(_of_ros2msg(name, text)))
    if encoding == "omgidl":
        return datatypes.Type(_of_idl(name, text))
    raise errors.BadType(printable(name), f"described in {printable(encoding)}, which is not read")


def _of_idl(name, text):
    from rtshell_lite.data.idl import parser

    types = parser.parse_text(text, printable(name))
    names = [part for part in re.split(r"::|/|\.", name) if part]
    for identifier, descriptor in types.items():
        if descriptors.dotted(identifier).split(".") == names:
            return descriptor
    raise errors.BadType(printable(name), "is not described")


def _of_ros2msg(name, text):
    sections = re.split(r"^=+\s*$", text, flags=re.MULTILINE)
    described = {_short(built_in): lines for built_in, lines in _BUILT_IN.items()}
    described[_short(name)] = sections[0].splitlines()
    for section in sections[1:]:
        head, _, rest = section.strip().partition("\n")
        if head.startswith("MSG:"):
            described[_short(head[4:].strip())] = rest.splitlines()
    return _struct(_short(name), described, {}, ())


def _short(name):
    """package/Name of package/msg/Name"""
    return name.replace("/msg/", "/")


def _struct(name, described, structs, around):
    if name in structs:
        return structs[name]
    if name not in described or name in around or len(around) > descriptors.DEEPEST:
        raise errors.BadType(printable(name), "is not described, or contains itself")
    members = []
    for line in described[name]:
        line = line.partition("#")[0].strip()
        if line:
            members += _members(line, name, described, structs, around + (name,))
    structs[name] = descriptors.struct(type_id(name), name.rpartition("/")[2], members)
    return structs[name]


def _members(line, name, described, structs, around):
    """[(name, type)] of a line; none for a constant."""
    match = _FIELD.match(line)
    if not match:
        raise errors.BadType(printable(name), f"a line that is not read: {printable(line)}")
    if match.group("rest").strip().startswith("="):
        return []
    word = match.group("type")
    if word == "string":
        inner = _STRING
    elif word in _KINDS:
        inner = _KINDS[word]
    else:
        if "/" not in word:
            word = name.rpartition("/")[0] + "/" + word
        inner = _struct(_short(word), described, structs, around)
    many = match.group("many")
    if many is None:
        return [(match.group("name"), inner)]
    if many == "[]":
        return [(match.group("name"), (SEQUENCE, inner, 0))]
    length = int(many.strip("[]<=") or 0)
    if "<" in many:
        return [(match.group("name"), (SEQUENCE, inner, length))]
    return [(match.group("name"), descriptors.array(inner, length))]
