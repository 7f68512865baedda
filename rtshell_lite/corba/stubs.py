"""omniORB, and the classes that it needs for OpenRTM's IDL, made of the tables: nothing outside corba/
imports them.

All that a command uses is made when it is first asked for; classes of references are made at the start, as
omniORB looks them up.
"""

import functools
import sys
import types

from rtshell_lite import errors, start
from rtshell_lite.giop import descriptors, idl

STANDARD = (
    "Time_idl", "BasicDataType_idl", "ExtendedDataTypes_idl", "InterfaceDataTypes_idl",
    "CameraCommonInterface_idl",
)


def import_omniorb():
    """Import omniORB without `tempfile`, before any other module does; returns its module CORBA. Raises
    MissingOmniORB.

    Of 18 ms for `import omniORB`, 9 ms are `tempfile`, which only importIDLString uses; we never call that.
    The empty stand-in leaves sys.modules again, so that others import the real one.
    """
    start.find_installed()
    stand_in = sys.modules.setdefault("tempfile", types.ModuleType("tempfile"))
    try:
        from omniORB import CORBA
    except ImportError:
        raise errors.MissingOmniORB()
    finally:
        if not hasattr(stand_in, "mkstemp"):
            del sys.modules["tempfile"]
    return CORBA


# ---- interfaces ----


def register():
    """Let omniORB make references of the interfaces of the tables;
    those that it knows from elsewhere stay.
    """
    import omniORB

    for type_id in idl.INTERFACES:
        omniORB.objrefMapping.setdefault(type_id, interface(type_id))


@functools.lru_cache(maxsize=None)
def interface(type_id):
    """The class of references to an interface; it has a method for each operation."""
    from omniORB import CORBA

    bases, operations = idl.INTERFACES[type_id]
    methods = {name: _method(type_id, name) for name in operations}
    return type(
        idl.name(type_id), tuple(map(interface, bases)) or (CORBA.Object,),
        {"_NP_RepositoryId": type_id, **methods},
    )


def _method(type_id, name):
    return lambda self, *args: self._obj.invoke(name, operation(type_id, name), args)


@functools.lru_cache(maxsize=None)
def operation(type_id, name):
    """How omniORB calls an operation of an interface or of those that it inherits: descriptors of its
    arguments, of its results (None for oneway), of its exceptions by their ids (None for no exceptions).
    Raises KeyError.
    """
    given, returned, raised = idl.operation(type_id, name)
    arguments = tuple(map(idl.descriptor, given))
    results = None if returned is None else tuple(map(idl.descriptor, returned))
    exceptions = {type_id: _exception(type_id) for type_id in raised}
    return arguments, results, exceptions or None


@functools.lru_cache(maxsize=None)
def _exception(type_id):
    from omniORB import CORBA

    kind, plain, type_id, name, *members = idl.known(type_id)
    return (kind, type(name, (plain, CORBA.UserException), {}), type_id, name, *members)


def skeleton(name):
    """A class to derive servants of an interface from, by its name."""
    return _skeleton(idl.id_of(name))


@functools.lru_cache(maxsize=None)
def _skeleton(type_id):
    import omniORB
    from omniORB import PortableServer

    operations = {
        name: operation(type_id, name) for above in idl.ancestry(type_id) for name in idl.INTERFACES[above][1]
    }
    skeleton = type(
        idl.name(type_id), tuple(map(_skeleton, idl.INTERFACES[type_id][0])) or (PortableServer.Servant,),
        {"_NP_RepositoryId": type_id, "_omni_op_d": operations},
    )
    setattr(skeleton, "_omni_skeleton", skeleton)
    omniORB.registerSkeleton(type_id, skeleton)
    return skeleton


# ---- stubs ----


def contents(scope):
    """What stubs of a module of the IDL hold: {name: class, descriptor (_d_…), TypeCode (_tc_…) or item of an
    enum}.

    `scope` is how their repository ids begin: IDL:RTC/. omniORB gets to know the types.
    """
    import omniORB

    names = {}  # type: dict
    for type_id in [name for name in (*idl.TYPES, *idl.INTERFACES) if name.startswith(scope)]:
        descriptor = idl.descriptor(type_id)
        name = idl.name(type_id)
        kind = descriptors.kind(descriptor)
        if kind == descriptors.EXCEPTION:
            descriptor = _exception(type_id)
        if kind == descriptors.ENUM:
            names.update((item._n, item) for item in descriptors.items(descriptor))
        typecode = omniORB.tcInternal.createTypeCode(descriptor)
        names.update({name: _class(descriptor, type_id), "_d_" + name: descriptor, "_tc_" + name: typecode})
        omniORB.registerType(type_id, descriptor, typecode)
    return names


def _class(descriptor, type_id):
    """What bears the name of a type in stubs."""
    import omniORB

    kind = descriptors.kind(descriptor)
    if kind == descriptors.OBJECT:
        return interface(type_id)
    if kind == descriptors.ENUM:
        return omniORB.Enum(type_id, descriptors.items(descriptor))
    if kind == descriptors.ALIAS:
        return type("Alias", (), {"_NP_RepositoryId": type_id})
    return descriptors.factory(descriptor)


def lend_standard():
    """Let a user's stubs import the stubs of the standard IDL files:
    OpenRTM-aist-Python's if installed, else stand-ins.
    """
    import importlib.util  # takes long

    try:
        import omniORB
    except ImportError:
        return  # the user's stubs will miss it
    missing = [
        name for name in STANDARD if name not in sys.modules and importlib.util.find_spec(name) is None
    ]
    for name in missing:
        sys.modules[name] = types.ModuleType(name)
    if not missing:
        return
    for module in ("RTC", "Img"):
        vars(omniORB.openModule(module)).update(contents(f"IDL:{module}/"))
