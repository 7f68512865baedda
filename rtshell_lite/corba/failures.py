"""What exceptions that peers raise mean: an errors.Error for each, whichever ORB received it."""

from rtshell_lite import errors
from rtshell_lite.text import from_wire, printable


def may_repeat(operation):
    """Whether an operation changes nothing, so that it can be asked again when its answer is lost;
    of a Schema that is not known.
    """
    if not isinstance(operation, str):
        return False
    return operation.startswith(("get_", "is_", "_")) or operation in ("list", "resolve")


# Operations that a component, port or manager may answer only when others have answered it: a port asks the
# far ends of its connections, a component its ports, a master its slaves.
_ASKING_OTHERS = frozenset((
    "get_port_profile", "get_connector_profiles", "get_connector_profile", "get_component_profile",
    "get_component_profiles", "get_components", "get_components_by_name", "get_factory_profiles",
    "get_loadable_modules",
))


def asks_others(operation):
    """Whether an operation of OpenRTM's IDL may wait for other processes, so that its silence says nothing
    about the process that is asked.
    """
    return isinstance(operation, str) and operation in _ASKING_OTHERS


def unreachable(where, e):
    """The errors.Unreachable for an exception, in most cases an OSError, of a connection."""
    why = getattr(e, "strerror", None)
    return errors.Unreachable(where, f"cannot be reached ({why})" if why else "cannot be reached")


def system(where, name, label):
    """The errors.Error for a CORBA system exception; `label` is the name of its minor code, or its own."""
    if name == "TIMEOUT":
        return errors.Silent(where, label)
    if name == "OBJECT_NOT_EXIST":
        return errors.Gone(where)
    if name == "TRANSIENT":
        return errors.Unreachable(where, f"cannot be reached now ({label})")
    if name == "COMM_FAILURE":
        return errors.ConnectionLost(where)
    if name in ("MARSHAL", "INV_OBJREF"):
        return errors.Unreachable(where, f"garbled answer ({label})")
    return errors.Refused(where, label, name=name)


def user(where, name, description):
    """The errors.Error for an exception of the IDL; `description` is its member of that name, or ''."""
    label = name
    if description:
        label += ": " + printable(from_wire(description))
    return errors.Refused(where, label, name=name)
