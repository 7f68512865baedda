"""omniORB, and the stubs of OpenRTM's IDL for it by name: nothing outside corba/ imports them.

Each package of stubs is imported when first asked for: a command pays only for those that it uses.
"""
import functools
import sys
import types

from rtshell_lite import errors

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
    full = name if name == "CosNaming" else "rtshell_lite.idl_stubs." + name
    __import__(full)  # importlib takes long to import, and rtls needs nothing else of it
    return sys.modules[full]


@functools.lru_cache(maxsize=None)
def named(name):
    """A class of stubs by package, IDL module and name: `component.RTC.PortService`, `observer.OpenRTM__POA.Logger`."""
    where, _, last = name.rpartition(".")
    return getattr(module(where), last)


def lend_standard():
    """Let a user's stubs import the stubs of the standard IDL files: OpenRTM-aist-Python's if installed, else ours."""
    import importlib.util  # takes long
    for name in STANDARD:
        if name not in sys.modules and importlib.util.find_spec(name) is None:
            sys.modules[name] = module("data." + name)
