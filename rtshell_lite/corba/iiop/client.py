"""Our own ORB, as orb.py needs it: references, calls with a deadline, exceptions of peers as errors. server.py has servants.

A call is made on the thread that asks, on a connection that nobody else uses meanwhile.
"""
import collections
import re
import socket
import sys
import threading
import time
from struct import error as StructError

from rtshell_lite import errors
from rtshell_lite.corba import descriptors, idl, ior, lanes
from rtshell_lite.corba.iiop import connections, giop, marshal, operations, references
from rtshell_lite.text import from_wire, printable, to_wire

FORWARDS = 8  # at most, from one object to another
_CORBALOC = re.compile(r"corbaloc:(?:iiop)?:(?:1\.([0-2])@)?(\[[^]]*\]|[^:/]*):(\d+)/(.*)\Z", re.DOTALL)
_ASKING = ("get_", "is_", "_")  # operations that change nothing begin so

_OBJECT = (descriptors.OBJECT, "", "Object")

_idle = collections.defaultdict(list)  # by endpoint: connections for the next calls, at most one for each lane
_lock = threading.Lock()


def start():
    """Nothing has to be started."""


def version():
    """What `rtdoctor` calls it."""
    return "builtin ORB"


# ---- references -----------------------------------------------------------------------------------------------

def from_url(where, url):
    """The reference of a corbaloc; contacts nobody. Raises BadPath."""
    match = _CORBALOC.match(url)
    if not match or int(match.group(3)) > 65535:
        raise errors.BadPath(f"{where}: not an address (the builtin ORB speaks IIOP only)")
    minor, host, port, key = match.groups()
    key = re.sub(b"%([0-9a-fA-F]{2})", lambda found: bytes([int(found.group(1), 16)]), key.encode("utf-8", "surrogateescape"))
    return references.at(host.strip("[]"), int(port), key, int(minor or 2))


def from_text(where, text):
    """The reference in a stringified IOR that a peer has sent. Raises Unreachable where the text is no reference."""
    try:
        return references.from_text(ior.checked(text))
    except ValueError as e:
        raise errors.Unreachable(where, str(e))


def to_text(ref):
    """The stringified IOR of a reference."""
    return ref.text()


def address(ref):
    """What a reference says, an ior.Address."""
    return ref.address


def narrow(ref, interface):
    """`ref` as a reference of an interface by its name in the stubs, on trust."""
    type_id = idl.id_of(interface)
    return ref if ref.interface == type_id else references.Reference(ref.type_id, ref.profiles, type_id)


def same(one, other):
    """True if two references denote one object, as far as can be known without a remote call."""
    return one.address[1:] == other.address[1:] if one.address.host else one.profiles == other.profiles


# ---- calls ----------------------------------------------------------------------------------------------------

def invoke(where, ref, operation, args, seconds):
    """The result of an operation, with a deadline of so many seconds where that is more than the timeout."""
    seconds = max(seconds or 0, lanes.session.timeout)
    end = time.monotonic() + seconds
    op = operations.operation(ref.interface, operation)
    try:
        return _result(where, ref, operation, op, args, end)
    except socket.timeout:
        raise errors.Silent(str(where), lanes.no_answer(seconds))
    except connections.Closed:
        raise errors.Unreachable(str(where), "connection lost")
    except (ValueError, StructError, IndexError, RecursionError) as e:
        raise errors.Garbled(str(where), str(e))
    except ConnectionRefusedError:
        raise errors.ConnectionRefused(str(where))
    except OSError as e:
        lanes.note_shortage(e, ref.address.host)
        if isinstance(e, socket.gaierror):
            raise errors.Unreachable(str(where), errors.NO_USABLE_ADDRESS)
        raise errors.Unreachable(str(where), "cannot be reached" + (f" ({e.strerror})" if e.strerror else ""))


def _result(where, ref, operation, op, args, end):
    interface = ref.interface
    for _ in range(FORWARDS):
        data = _asked(ref, operation, op, args, end)
        _, status, little, at = giop.reply(data)
        if status == giop.NO_EXCEPTION:
            return _values(op.results[little], data, at)
        if status in (giop.FORWARD, giop.FORWARD_PERM):
            ref, _ = operations.reader(idl.descriptor(interface) if interface else _OBJECT, little)(data, at)
            if ref is None:
                raise ValueError("forwarded to nobody")
        elif status == giop.SYSTEM_EXCEPTION:
            raise _system_exception(str(where), data, at, little)
        elif status == giop.USER_EXCEPTION:
            raise _user_exception(str(where), op, data, at, little)
        else:
            raise ValueError(f"a reply of status {status}")
    raise ValueError("forwarded again and again")


def _values(readers, data, at):
    values = []
    for read in readers:
        value, at = read(data, at)
        values.append(value)
    return values[0] if len(values) == 1 else tuple(values) or None


def _asked(ref, operation, op, args, end):
    """The reply, as octets. A question is asked again, once, where an old connection is lost: it may have been so before."""
    version, endpoint, key = ref.target
    asks = operation.startswith(_ASKING) or operation in ("list", "resolve")
    with _lock:
        old = _idle[endpoint].pop() if _idle[endpoint] else None
    for connection in [old, None] if old else [None]:
        reply = None
        try:
            connection = connection or _connected(ref, endpoint, end)
            connection.number += 1
            connection.send(_request(connection.number, version, key, operation, op, args), end)
            reply = connection.reply(end)
            return reply
        except (connections.Closed, ConnectionResetError, BrokenPipeError) as e:
            if connection is not old or not (asks or getattr(e, "untouched", False)):
                raise connections.Closed()
        finally:
            if connection is not None:
                _keep(connection, endpoint, reply is not None)
    raise connections.Closed()


def _request(number, version, key, operation, op, args):
    """A request as octets. Raises TypeError for arguments that are of another type: that is no fault of the peer."""
    try:
        return giop.request(number, version, key, operation, list(zip(op.arguments, args)))
    except (ValueError, StructError) as e:
        raise TypeError(f"{operation}: {e}")


def _connected(ref, endpoint, end):
    """A connection with the process of a reference, at the first of its addresses where somebody listens."""
    try:
        return connections.Connection(endpoint, end)
    except OSError:
        for address in ior.addresses(ref.text())[1:]:
            try:
                return connections.Connection(address, end)
            except OSError:
                continue
        raise


def _keep(connection, endpoint, is_usable):
    """Keep a connection for the next call to its process, or close it."""
    with _lock:
        if is_usable and len(_idle[endpoint]) < lanes.LANES:
            _idle[endpoint].append(connection)
            return
    connection.close()


def _system_exception(where, data, at, little):
    """The errors.Error for a system exception: its id, its minor code, and whether the operation was completed."""
    name, at = operations.reader(marshal.TEXT, little)(data, at)
    minor, at = operations.reader(descriptors.ULONG, little)(data, at)
    name = name.split(":")[1].rpartition("/")[2] if name.count(":") == 2 else "UNKNOWN"
    label = idl.MINORS.get(name, {}).get(minor) or "CORBA." + printable(name)
    if name == "TIMEOUT":
        return errors.Silent(where, label)
    if name == "OBJECT_NOT_EXIST":
        return errors.Gone(where)
    if name == "TRANSIENT":
        return errors.Unreachable(where, f"cannot be reached now ({label})")
    if name == "COMM_FAILURE":
        return errors.Unreachable(where, "connection lost")
    if name in ("MARSHAL", "INV_OBJREF"):
        return errors.Unreachable(where, f"garbled answer ({label})")
    return errors.Refused(where, label, name=name)


def _user_exception(where, op, data, at, little):
    """The errors.Error for an exception of the IDL."""
    type_id, start = operations.reader(marshal.TEXT, little)(data, at)
    if type_id not in op.raised:
        return errors.Refused(where, "CORBA.UNKNOWN", name="UNKNOWN")
    raised, _ = operations.reader(idl.descriptor(type_id), little)(data, start)
    detail = getattr(raised, "description", "")
    name = type_id.split(":")[1].rpartition("/")[2]
    return errors.Refused(where, name + (": " + printable(from_wire(detail)) if detail else ""), name=name)


def serve(servant):
    """Let others call a servant: the stringified reference to it, and a function that ends that. Raises Usage."""
    from rtshell_lite.corba.iiop import server
    return server.serve(servant)


# ---- values ---------------------------------------------------------------------------------------------------

def struct(name):
    """The class of a struct of the IDL by its name in the stubs."""
    return descriptors.factory(idl.descriptor(idl.id_of(name)))


def items(name):
    """The items of an enum of the IDL by its name in the stubs, in their order."""
    return descriptors.items(idl.descriptor(idl.id_of(name)))


def properties(nvlist):
    """An SDOPackage::NVList as a list of (name, value) texts in its order; other values are converted to text."""
    return [(sys.intern(from_wire(item.name)), _as_text(item.value.content, item.value.descriptor)) for item in nvlist]


def _as_text(value, descriptor):
    if type(value) is str:
        return from_wire(value)
    kind = descriptors.kind(descriptors.plain(descriptor))
    if kind in (descriptors.STRUCT, descriptors.UNION, descriptors.EXCEPTION):
        return f"<{from_wire(descriptors.type_id(descriptor))}>"
    if kind == descriptors.OBJECT:
        return "" if value is None else value.text()
    return str(value) if value is not None else ""


descriptor = idl.known


def descriptor_of(value):
    """The descriptor of the type of the value in an any."""
    return value.descriptor


def nvlist(pairs):
    """(name, value) texts as an SDOPackage::NVList of strings."""
    made = struct("component.SDOPackage.NameValue")
    return [made(to_wire(name), marshal.Any(marshal.TEXT, to_wire(value))) for name, value in pairs]
