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
