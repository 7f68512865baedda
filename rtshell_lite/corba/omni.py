"""omniORB, as orb.py needs it: its settings, references, calls with a deadline, CORBA exceptions as errors."""
import os
import sys
import threading

from rtshell_lite import errors
from rtshell_lite.corba import answers, failures, lanes, stubs
from rtshell_lite.giop import idl, ior
from rtshell_lite.text import from_wire, printable, to_wire

PROBING = 4  # a host has a quarter of the timeout to refuse a connection
CONNECTIONS = 5  # omniORB opens at most so many to one process (maxGIOPConnectionPerServer)

loop = None  # calls of omniORB cannot be interrupted: threads make them

HEEDED = None  # all settings of omniORB

shared = False  # True: others in this process may use the ORB, too; deadlines are set for our references only
_own = set()  # type: set  # (host, port) at which this process itself serves objects, once one of them has been asked
_of_one_reply = set()  # type: set  # (host, port) of processes that have closed connections of ours after a reply
_started = None  # the ORB, once there is one
_deadline = None  # s, the deadline that it was given
_starting = threading.RLock()


# ---- the ORB --------------------------------------------------------------------------------------------------

def start():
    """The ORB of this process, made at the first call. Raises MissingOmniORB, Usage (bad RTCTREE_ORB_ARGS)."""
    global _started, _deadline
    with _starting:
        if _started is None:
            _started = _make_orb()
            _deadline = lanes.session.timeout
        elif _deadline != lanes.session.timeout and not shared:  # another command of rtsh, with a --timeout of its own
            _deadline = lanes.session.timeout
            _set_deadline()
    return _started


def _make_orb():
    CORBA = stubs.import_omniorb()
    stubs.register()
    arguments = ["rtshell_lite", "-ORBtraceLevel", "0", "-ORBverifyObjectExistsAndType", "0",
                 "-ORBgiopMaxMsgSize", str(32 << 20)]
    if not shared:
        arguments += ["-ORBclientCallTimeOutPeriod", _milliseconds(lanes.session.timeout),
                      "-ORBclientConnectTimeOutPeriod", _milliseconds(lanes.session.timeout)]
    own = [a for a in os.environ.get("RTCTREE_ORB_ARGS", "").split(";") if a]
    try:
        return CORBA.ORB_init(arguments + own, CORBA.ORB_ID)
    except CORBA.SystemException as e:
        where = "RTCTREE_ORB_ARGS: " + printable(";".join(own)) if own else "omniORB.cfg, or a variable ORB…"
        raise errors.Usage(f"{where}: not understood by omniORB ({_label(e)})")


def version():
    """The version of omniORBpy. Raises MissingOmniORB."""
    stubs.import_omniorb()
    import omniORB
    return "omniORBpy " + omniORB.__version__


def _set_deadline():
    import omniORB
    omniORB.setClientCallTimeout(int(_milliseconds(lanes.session.timeout)))
    omniORB.setClientConnectTimeout(int(_milliseconds(lanes.session.timeout)))


def _milliseconds(seconds):
    return str(max(1, int(seconds * 1000)))


# ---- references -----------------------------------------------------------------------------------------------

def from_url(where, url):
    """The reference of a corbaloc or the like; contacts nobody. Raises BadPath."""
    orb = start()
    from omniORB import CORBA
    try:
        return orb.string_to_object(to_wire(url))
    except CORBA.SystemException as e:
        raise errors.BadPath(where, f"not an address ({_label(e)})")


def from_text(where, text):
    """The reference in a stringified IOR that a peer has sent. Raises Unreachable where the text is no reference."""
    orb = start()
    from omniORB import CORBA
    try:
        return orb.string_to_object(ior.checked(text))
    except ValueError as e:
        raise errors.Unreachable(where, str(e))
    except CORBA.SystemException as e:
        raise errors.Unreachable(where, f"not a reference ({_label(e)})")


def to_text(ref):
    """The stringified IOR of a reference."""
    return start().object_to_string(ref)


def address(ref):
    """What the IOR of a reference says, an ior.Address."""
    return ior.address(start().object_to_string(ref))


def narrow(ref, interface):
    """`ref` as a reference of an interface by its name, on trust."""
    type_id = idl.id_of(interface)
    if type(ref)._NP_RepositoryId == type_id:
        return ref  # narrowing again takes 30 us
    return ref._unchecked_narrow(stubs.interface(type_id))


def same(one, other):
    """True if two references denote one object, as far as can be known without a remote call."""
    return bool(one._is_equivalent(other))


# ---- calls ----------------------------------------------------------------------------------------------------

def invoke(call):
    """The result of an orb.Call, with a deadline of its `seconds` where that is more than the timeout."""
    from omniORB import CORBA
    where, ref, operation, args, seconds = call.where, call.ref, call.operation, call.args, call.seconds
    longer = seconds if seconds and seconds > lanes.session.timeout else None
    if longer or shared:
        import omniORB
        omniORB.setClientCallTimeout(ref, int(_milliseconds(longer or lanes.session.timeout)))
    try:
        if not failures.may_repeat(operation) and address(ref)[1:3] in _of_one_reply:
            _use_up_connections(ref)
        try:
            return _answer(where, ref, operation, args)
        except CORBA.COMM_FAILURE as e:
            if lanes.in_lane() and not lanes.has_answered():
                _check_version(str(where), address(ref)[1:3])
            return _asked_again(e, where, ref, operation, args)
    except CORBA.Exception as e:
        raise _error(str(where), e, max(seconds or 0, lanes.session.timeout), ref)


def _answer(where, ref, operation, args):
    """The checked answer; from an object of this very process, which omniORB calls without octets, the plain one."""
    from omniORB import CORBA
    if _own and address(ref)[1:3] in _own:
        return getattr(ref, operation)(*args)
    try:
        return answers.invoke(where, ref, operation, args)
    except CORBA.BAD_PARAM as e:  # a peer may say that, too
        if not (shared and _label(e) == "BAD_PARAM_WrongPythonType" and failures.may_repeat(operation) and _is_own(ref)):
            raise
    _own.add(address(ref)[1:3])
    return getattr(ref, operation)(*args)


def _is_own(ref):
    """Whether a reference leads to where this process listens."""
    from omniORB import CORBA
    try:
        poa = start().resolve_initial_references("RootPOA")
        own = address(poa.create_reference(CORBA.Object._NP_RepositoryId))
    except CORBA.SystemException:  # it cannot listen
        return False
    return bool(own.host) and own[1:3] == address(ref)[1:3]


def _asked_again(failure, where, ref, operation, args):
    """The result of a question whose answer was lost: it is asked again, once for each connection that may be an old one.

    rtsh keeps connections. When a process ends, or is restarted at the same port, all of them are lost, and each shows it only
    when it is next used. Changes are not repeated: they may have been made.
    """
    from omniORB import CORBA
    for _ in range(CONNECTIONS if failures.may_repeat(operation) and lanes.has_answered() else 0):
        try:
            answer = answers.invoke(where, ref, operation, args)
        except CORBA.COMM_FAILURE as e:
            failure = e
        else:
            _of_one_reply.add(address(ref)[1:3])
            return answer
    raise failure


def _use_up_connections(ref):
    """Have omniORB notice that all connections to a process have been closed: a change must not be sent by one of these."""
    from omniORB import CORBA
    is_last = False  # of which we know that there is no other, as omniORB has made a new one
    for _ in range(2 * CONNECTIONS):
        try:
            ref._non_existent()
            is_last = True
        except CORBA.COMM_FAILURE:
            if is_last:
                return


def _check_version(where, endpoint):
    """Raise Unreachable if a process that has closed the connection to omniORB answers in GIOP 1.0 or 1.1 only."""
    import socket

    from rtshell_lite.giop import messages
    for minor in (2, 1, 0):
        try:
            with socket.create_connection(endpoint, lanes.session.timeout / PROBING) as probe:
                probe.sendall(messages.request(1, (1, minor), messages.KEY, b"\1\0\0\0?", "_non_existent", ()))
                head = probe.recv(messages.HEADER)
        except (OSError, ValueError):
            return
        if head[:6] != b"GIOP\1" + bytes([minor]) or head[7:8] != bytes([messages.REPLY]):
            continue
        if minor < 2:
            raise errors.Unreachable(where, f"speaks GIOP 1.{minor} only, which omniORB does not try; set RTSHELL_ORB=builtin")
        return


def _error(where, e, seconds, ref):
    """The errors.Error for a CORBA exception that a call to `ref` raised."""
    from omniORB import CORBA
    label = _label(e)
    if isinstance(e, CORBA.TIMEOUT):
        return errors.Silent(where, lanes.no_answer(seconds))
    if isinstance(e, CORBA.TRANSIENT) and label.endswith("ConnectFailed"):
        return _not_connected(where, address(ref)[1:3])
    if isinstance(e, CORBA.TRANSIENT) and label.endswith("NoUsableProfile"):
        return errors.Unreachable(where, errors.NO_USABLE_ADDRESS)
    if isinstance(e, CORBA.SystemException):
        return failures.system(where, type(e).__name__, label)
    return failures.user(where, label, getattr(e, "description", ""))


def _not_connected(where, endpoint):
    """The errors.Error for a connection that could not be made: omniORB does not say why, so the kernel is asked.

    Only a refusal shows that the process is gone. Where its host cannot be reached, it may well live.
    """
    import socket
    try:
        socket.create_connection(endpoint, lanes.session.timeout / PROBING).close()
    except ConnectionRefusedError:
        pass
    except (OSError, ValueError) as e:  # the latter: no name of a host
        if isinstance(e, OSError):
            lanes.note_shortage(e, endpoint[0])
        why = getattr(e, "strerror", None)
        return errors.Unreachable(where, "cannot be reached" + (f" ({why})" if why else ""))
    return errors.ConnectionRefused(where)


def _label(e):
    """Short name of a CORBA exception: the minor code's where there is one."""
    import omniORB
    from omniORB import CORBA
    if isinstance(e, CORBA.SystemException):
        minor = omniORB.minorCodeToString(e)
        return sys.intern(str(minor) if minor else f"CORBA.{type(e).__name__}")
    return type(e).__name__


# ---- servants -------------------------------------------------------------------------------------------------

def serve(servant):
    """Let others call a servant: the stringified reference to it, and a function that ends that. Raises Usage."""
    orb = start()
    from omniORB import CORBA
    try:
        poa = orb.resolve_initial_references("RootPOA")
    except CORBA.INITIALIZE:  # only now omniORB begins to listen
        raise errors.Usage(errors.BAD_ENDPOINT)
    made = stubs.skeleton(servant.interface)()
    vars(made).update((operation, getattr(servant, operation)) for operation in made._omni_op_d)
    number = poa.activate_object(made)
    poa._get_the_POAManager().activate()
    return orb.object_to_string(poa.id_to_reference(number)), lambda: poa.deactivate_object(number)


# ---- values ---------------------------------------------------------------------------------------------------

def properties(nvlist, only=None):
    """An SDOPackage::NVList as a list of (name, value) texts in its order; other values are converted to text.

    `only`: those of this name.
    """
    from omniORB import CORBA
    string = CORBA.tk_string  # almost all are; `is`, because == of these takes as long as all the rest
    return [(sys.intern(from_wire(nv.name)), from_wire(nv.value.value()) if nv.value.typecode().kind() is string
             else _as_text(nv.value, CORBA)) for nv in nvlist if not only or nv.name == only]


def _as_text(value, CORBA):
    typecode, value = value.typecode(), value.value()
    kind = typecode.kind()
    if kind in (CORBA.tk_struct, CORBA.tk_union, CORBA.tk_except):  # the data_value of 1.1, a TimedLong of zeros
        return f"<{from_wire(typecode.id())}>"
    if kind == CORBA.tk_objref:
        return start().object_to_string(value)
    return str(value) if value is not None else ""


def descriptor(type_id):
    """The type descriptor that a user's stubs registered with omniORB for a repository id, or None."""
    import omniORB
    return omniORB.typeMapping.get(type_id)


def descriptor_in(nvlist, name):
    """The descriptor of the type of the value with this name in an SDOPackage::NVList, or None."""
    return next((nv.value.typecode()._d for nv in nvlist if nv.name == name), None)


def nvlist(pairs):
    """(name, value) texts as an SDOPackage::NVList of strings, the one type that every implementation accepts."""
    from omniORB import CORBA
    NameValue = idl.struct("SDOPackage.NameValue")
    return [NameValue(to_wire(n), CORBA.Any(CORBA.TC_string, to_wire(v))) for n, v in pairs]
