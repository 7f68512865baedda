"""omniORB, and the stubs of OpenRTM's IDL for it by name: nothing outside corba/ imports them.

Each package of stubs is imported when first asked for: a command pays only for those that it uses.
"""
import functools
import sys
import types

from rtshell_lite import errors

_PREFIX = "rtshell_lite.idl_stubs."
STANDARD = ("Time_idl", "BasicDataType_idl", "ExtendedDataTypes_idl", "InterfaceDataTypes_idl", "CameraCommonInterface_idl")


def import_omniorb():
    """Import omniORB without `tempfile`, before any of our stubs do; returns its module CORBA. Raises MissingOmniORB.

    Of 18 ms for `import omniORB`, 9 ms are `tempfile`, which only importIDLString uses; we never call that. The empty
    stand-in leaves sys.modules again, so that others import the real one.
    """
    stand_in = sys.modules.setdefault("tempfile", types.ModuleType("tempfile"))
    try:
        from omniORB import CORBA
    except ImportError:
        raise errors.MissingOmniORB()
    finally:
        if not hasattr(stand_in, "mkstemp"):
            del sys.modules["tempfile"]
    return CORBA


def module(name):
    """A module of stubs: `data.RTC` of idl_stubs, or omniORB's own `CosNaming`."""
    full = name if name == "CosNaming" else _PREFIX + name
    __import__(full)  # importlib takes long to import, and rtls needs nothing else of it
    return sys.modules[full]


@functools.lru_cache(maxsize=None)
def named(name):
    """A class of stubs by package, IDL module and name: `component.RTC.PortService`."""
    where, _, last = name.rpartition(".")
    return getattr(module(where), last)


@functools.lru_cache(maxsize=None)
def skeleton(name):
    """A class to derive servants of an interface from: what omniidl writes for that, made of the stub."""
    import omniORB
    from omniORB import PortableServer
    where, _, last = name.rpartition(".")
    interface, references = named(name), named(f"{where}._objref_{last}")
    above = [f"{base.__module__[len(_PREFIX):]}.{base.__name__[len('_objref_'):]}" for base in references.__bases__
             if base.__module__.startswith(_PREFIX)]
    bases = tuple(map(skeleton, above)) or (PortableServer.Servant,)
    operations = {key[3:]: value for key, value in vars(interface).items() if key.startswith("_d_")}
    for base in map(skeleton, above):
        operations.update(base._omni_op_d)
    made = type(last, bases, {"_NP_RepositoryId": interface._NP_RepositoryId, "_omni_op_d": operations})
    made._omni_skeleton = made
    omniORB.registerSkeleton(made._NP_RepositoryId, made)
    return made


def lend_standard():
    """Let a user's stubs import the stubs of the standard IDL files: OpenRTM-aist-Python's if installed, else ours."""
    import importlib.util  # takes long
    if importlib.util.find_spec("omniORB") is None:
        return  # the user's stubs will miss it
    for name in STANDARD:
        if name not in sys.modules and importlib.util.find_spec(name) is None:
            sys.modules[name] = module("data." + name)
