"""What an #include of one of OpenRTM's own IDL files declares, from the tables (giop/idl.py)."""

from rtshell_lite.data.idl import standard
from rtshell_lite.data.idl.interfaces import scoped
from rtshell_lite.data.idl.scopes import Entry, Scope
from rtshell_lite.data.idl.tokens import Token
from rtshell_lite.giop import descriptors, idl

DEPTH = 8  # none of the types is deeper


def declare(parser, file, token):
    """Declare in a Parser what a file, and those that it includes, declare; `token` is that of the #include.
    Raises BadIdl for a name that is declared already.
    """
    if file in parser.included:
        return
    parser.included.add(file)
    words = idl.FILES[file].split()
    ids = [word for word in words if word not in idl.FILES]
    for word in words:
        if word in idl.FILES:
            declare(parser, word, token)
    scopes = [_declare(parser, type_id, file, token) for type_id in ids]
    for type_id, scope in zip(ids, scopes):
        if type_id in idl.INTERFACES:
            scope.bases = [_inner(parser, base) for base in idl.INTERFACES[type_id][0]]


def _inner(parser, type_id):
    scope = parser.file_scope
    for name in scoped(type_id).split("::"):
        scope = scope.names[name.lower()].what
    return scope


def _declare(parser, type_id, file, token):
    """Declare a type, an exception or an interface; returns the Scope of an interface."""
    scope = parser.file_scope
    *around, name = scoped(type_id).split("::")
    own = Token("name", name, f"OpenRTM's {file}", 0, 0)
    for outer in around:
        if outer.lower() not in scope.names:
            module = Entry(outer, "module", Scope(outer, scope), f"IDL:{outer}:1.0", token=own)
            _add(parser, scope, module, token)
        module_entry = scope.names[outer.lower()]
        if not isinstance(module_entry.what, Scope):
            raise parser.twice(outer, module_entry, token)
        scope = module_entry.what
    descriptor = idl.descriptor(type_id)
    kind = descriptors.kind(descriptor)
    if kind == descriptors.OBJECT:
        inner = Scope(name, scope)
        inner.interface = standard.interface(type_id)
        entry = Entry(name, "interface", inner, type_id, token=own)
        parser.interfaces[id(entry)] = entry
        _add(parser, scope, entry, token)
        return inner
    if kind == descriptors.EXCEPTION:
        entry = Entry(name, "exception", descriptor, type_id, token=own)
        _add(parser, scope, entry, token)
        return None
    entry = Entry(name, "type", descriptor, type_id, [descriptor], own)
    types = list(descriptors.walk(descriptor, ""))
    parser.weigh(descriptor, len(types), DEPTH)
    parser.made[id(entry)] = type_id, descriptor
    _add(parser, scope, entry, token)
    if kind == descriptors.ENUM:
        for item in descriptors.items(descriptor):
            _add(parser, scope, Entry(item._n, "item", item, token=own), token)
    return None


def _add(parser, scope, entry, token):
    name = entry.name.lower()
    if name in scope.names:
        raise parser.twice(entry.name, scope.names[name], token)
    scope.names[name] = entry
    parser.kept.append(entry)
