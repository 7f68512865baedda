"""Data types by name, and their values as bytes.

A type is looked up among the standard types, in the IDL files and compiled stubs that the user names, in IDL
files in known directories (idl/library.py), and in the component.
"""

import struct
import sys

from rtshell_lite import errors, start
from rtshell_lite.corba import orb
from rtshell_lite.giop import descriptors, idl
from rtshell_lite.text import printable

STANDARD = ("RTC", "Img")  # modules of the IDL
SOURCES = "name its IDL file (--idl FILE) or compiled stubs (-m MODULE -p DIR)"
REMEDY = SOURCES + ", or look at the bytes (--raw)"


class Type:
    """A data type: `id` (IDL:RTC/TimedLong:1.0), `name` (RTC.TimedLong) and `descriptor`."""

    def __init__(self, descriptor):
        self.descriptor = descriptor
        self.id = descriptors.type_id(descriptor)
        self.name = descriptors.name(descriptor)
        self._codecs = {}

    def _codec(self, little):
        little = bool(little)
        if little not in self._codecs:
            from rtshell_lite.giop import cdr  # here and below: rtcall, which needs no octets, starts sooner

            check(self.descriptor, self.name)
            self._codecs[little] = cdr.codec(self.descriptor, little)
        return self._codecs[little]

    def decode(self, data, little=True):
        """The value that bytes of a data port hold (CDR from byte 0); bytes after it are ignored.
        Raises BadData.
        """
        return self.decode_part(data, little)[0]

    def decode_part(self, data, little=True):
        """(value, number of bytes that it takes).
        More bytes mean another type, or another version of this one.
        """
        read, _ = self._codec(little)
        try:
            return read(data, 0)
        except struct.error:
            raise errors.BadData(self.name, f"the data end too early, after {len(data)} bytes")
        except RecursionError:
            raise errors.BadData(self.name, "values are nested too deep")
        except ValueError as e:  # cdr.Fault, UnicodeError
            raise errors.BadData(self.name, str(e))

    def encode(self, value, little=True):
        """The bytes of a value for a data port. Raises BadValue, which names the field that does not fit."""
        _, write = self._codec(little)
        out = bytearray()
        try:
            write(out, value)
        except (struct.error, ValueError, TypeError, AttributeError, RecursionError) as e:
            from rtshell_lite.data import build_value

            build_value.build(self.descriptor, value, self.name)
            raise errors.BadValue(self.name, printable(str(e)))
        return bytes(out)

    def to_bytes(self):
        """The type as bytes, for files that are read without IDL; the reverse of `from_bytes`."""
        import json  # which Debian's python3-minimal lacks, and most commands do not need
        from rtshell_lite.data import type_json

        return json.dumps(type_json.plain(self.descriptor), separators=(",", ":")).encode("ascii")


def from_bytes(data):
    """The Type that `to_bytes` wrote. Raises BadType for anything else."""
    from rtshell_lite.data import type_json

    return Type(type_json.descriptor(data))


def check(descriptor, name):
    """Raise BadType for a type whose values cannot be read: one that contains an any or a reference."""
    for where, inner in descriptors.walk(descriptor, name):
        kind = descriptors.kind(inner)
        if kind not in descriptors.VALUES + descriptors.BUILT:
            raise errors.BadType(
                where, f"values of {descriptors.words(inner)} cannot be read; look at the bytes (--raw)"
            )


# ---- looking types up ----


class Types:
    """The standard types, and those of the user.

    `modules` are names of stubs to import, `path` directories to look in first, `idl` IDL files, `include`
    directories of files that these include. They are read when a type is not a standard one, and IDL files in
    any case: what they define counts before the standard type of that name. What none of them has is looked
    for in the known directories.
    """

    def __init__(self, modules=(), path=(), idl=(), include=()):
        self.modules = list(modules)
        self.path = list(path)
        self.idl = list(idl)
        self.include = list(include)
        self._known = {}
        self._users = None
        self._interfaces = {}
        self._library = None

    def load(self):
        """Read the user's files now, so that faults in them are reported first. Raises BadIdl, NoSuch."""
        if self._users is None:
            self._users = {}
            if self.idl:
                from rtshell_lite.data.idl import parser

                for file in self.idl:
                    contents = parser.read_file(file, self.include)
                    self._users.update(contents.types)
                    self._interfaces.update(contents.interfaces)
            for name in self.modules:
                self._users.update(_of_module(_imported(name, self.path)))
        return self

    def scopes(self):
        """Names of the Python modules in which omniidl puts the user's types, as far as they have been read:
        Arm, Arm.Joint.
        """
        return sorted({".".join(_parts(type_id)[:-1]) or "_GlobalIDL" for type_id in self._users or ()})

    def named(self, name):
        """The Type of a name: TimedLong, RTC.TimedLong, RTC::TimedLong, IDL:RTC/TimedLong:1.0.
        Raises NoSuch, BadIdl.
        """
        type = self._find(name)
        if type is None:
            raise errors.NoSuch(printable(name) or "''", "data type", self._with_fault(REMEDY))
        return type

    def interface(self, type_id):
        """The idl.interfaces.Interface of a repository id: in the user's IDL files, among OpenRTM's own, in
        the known directories; None where it is not known. Raises BadIdl, NoSuch.
        """
        self.load()
        if type_id in self._interfaces:
            return self._interfaces[type_id]
        if type_id in idl.INTERFACES:
            from rtshell_lite.data.idl import standard

            return standard.interface(type_id)
        return self.library.interface(type_id)

    @property
    def library(self):
        """The idl.library.Library of the known directories."""
        if self._library is None:
            from rtshell_lite.data.idl import library

            self._library = library.Library(library.roots() + [""], self.include)
        return self._library

    def _with_fault(self, remedy):
        """A remedy for what is not known, with what is wrong with an IDL file that may declare it."""
        if self._library and self._library.faults:
            return f"{self._library.faults[0]}; {remedy}"
        return remedy

    async def of_port(self, port):
        """The Type of a data Port: by its name, else as the component itself describes it.

        C++ 1.1 and Java publish a value of the type as the property dataport.data_value.
        Raises NoSuch, BadIdl, BadType, Unreachable.
        """
        name = port.properties.get("dataport.data_type", "")
        type = self._find(name)
        if type is None and "dataport.data_value" in port.properties:
            type = await _offered(port)
        if type is None:
            from rtshell_lite.robot import ports

            remedy = self._with_fault(SOURCES) if port.type == "DataInPort" else self._with_fault(REMEDY)
            why = f"{printable(name) or 'none given'}; {remedy}"
            raise errors.NoSuch(ports.label(port), "data type known", why)
        return type

    def _find(self, name):
        if name not in self._known:
            descriptor = standard(name)
            if descriptor is None or self.idl:
                self.load()
                if descriptor:
                    own = self._users.get(descriptors.type_id(descriptor))
                else:
                    own = _best(self._users, name)
                descriptor = own or descriptor or self._in_library(name)
            self._known[name] = descriptor and Type(descriptor)
        return self._known[name]

    def _in_library(self, name):
        if name.startswith("IDL:"):
            return self.library.type(name)
        parts = _parts(name)
        return _best(self.library.types(parts[-1]), name) if parts else None


def _parts(name):
    """The parts of a type's name in any of its spellings: ['RTC', 'TimedLong']."""
    if name.startswith("IDL:"):
        name = name[4:].rpartition(":")[0]
    return [part for part in name.replace("::", ".").replace("/", ".").split(".") if part]


def standard(name):
    """The descriptor of a standard type by any spelling of its name, or None."""
    parts = _parts(name)
    if not parts or len(parts) > 2 or len(parts) == 2 and parts[0] not in STANDARD:
        return None
    return next(
        filter(None, [idl.known(f"IDL:{module}/{parts[-1]}:1.0") for module in parts[:-1] or STANDARD]), None
    )


def _best(types, name):
    """The descriptor for a name among `types`, {id: descriptor}:
    that of the id, or of the only id that ends with the name.
    """
    if name in types:
        return types[name]
    parts = _parts(name)
    ids = [key for key in types if parts and _parts(key)[-len(parts) :] == parts]
    same = [key for key in ids if _parts(key) == parts]
    if len(ids) > 1 and len(same) != 1:
        raise errors.NoSuch(
            printable(name), "data type for certain", "it may be " + " or ".join(map(printable, sorted(ids)))
        )
    if ids:
        return types[(same or ids)[0]]
    return None


def _imported(name, path):
    """The module of stubs that the user named. Raises NoSuch when it cannot be imported."""
    import importlib
    from rtshell_lite.corba import stubs

    orb.start()
    start.find_installed()
    own = list(sys.path)
    sys.path[:0] = path
    try:
        stubs.lend_standard()
        return importlib.import_module(name)
    except (ImportError, SyntaxError, ValueError) as e:
        where = " in " + ", ".join(map(printable, path)) if path else ""
        raise errors.NoSuch(printable(name), "module" + where, printable(str(e)))
    finally:
        sys.path[:] = own


def _may_have_types(value, module):
    """Whether a value in a module of stubs is an interface or a module within it."""
    if isinstance(value, type):
        return hasattr(value, "_NP_RepositoryId")
    return getattr(value, "__name__", "").startswith(module.__name__ + ".")


def _of_module(module):
    """{id: descriptor} of the types in a module of stubs, those within its interfaces and modules too."""
    types = {}
    scopes = [module]
    seen = set()
    while scopes:
        scope = scopes.pop()
        seen.add(id(scope))
        for name, value in list(vars(scope).items()):
            if name.startswith(("_d_", "_ad_")) and isinstance(value, tuple) and descriptors.type_id(value):
                types.setdefault(descriptors.type_id(value), value)
            elif id(value) not in seen and _may_have_types(value, module):
                scopes.append(value)
    return {
        key: descriptors.adopted(
            value, lambda type_id: types.get(type_id) or orb.descriptor(type_id), classes=True
        )
        for key, value in types.items()
        if descriptors.kind(value) not in (descriptors.OBJECT, descriptors.EXCEPTION)
    }


async def _offered(port):
    """The Type of the value in a port's profile, or None; one more call."""
    from rtshell_lite.robot import ports

    profile = await orb.call(ports.label(port), port.ref, "get_port_profile")
    descriptor = orb.descriptor_in(profile.properties, "dataport.data_value")
    if isinstance(descriptor, tuple):
        return Type(descriptors.adopted(descriptor, orb.descriptor))
    return None


def members(type_id):
    """[(name, type in words)] of the members of a standard type (`IDL:RTC/TimedLong:1.0`),
    None for an unknown one.
    """
    descriptor = standard(type_id)
    if descriptor is None or descriptors.kind(descriptor) != descriptors.STRUCT:
        return None
    return [(name, descriptors.words(inner)) for name, inner in descriptors.members(descriptor)]


def has_fixed_size(port):
    """Whether all values of a data port have one, small size; False where its type is not a standard one."""
    fields = members(port.properties.get("dataport.data_type", "")) or [("", "any")]
    return not any(words.startswith(("sequence", "string", "any")) for _, words in fields)
