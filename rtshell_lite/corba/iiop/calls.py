"""One call: its request as octets, what its reply says, and what its failure means."""

from struct import error as StructError

from rtshell_lite import errors
from rtshell_lite.corba import failures, session
from rtshell_lite.giop import descriptors, idl, ior
from rtshell_lite.corba.iiop import connections
from rtshell_lite.giop import allowance, marshal, messages, operations
from rtshell_lite.net import loop, real
from rtshell_lite.text import printable

PADDING = 7  # octets that an ORB may leave at the end of a reply
FORWARDS = 8  # at most, from one object to another
LONGEST_NAME = 60  # characters of the name of a system exception; the longest of CORBA 3.0 has 23
GARBLED = (ValueError, StructError, IndexError, RecursionError)  # what reading values raises
_OBJECT = (descriptors.OBJECT, "", "Object")


class Request:
    """An orb.Call on its way; in the end, resume(value, None) or resume(None, error) is called.

    ref        whom it is sent to: another object than at first where that has forwarded it
    endpoint   (host, port) of the process that is asked
    name       of its operation
    is_oneway  nobody answers it
    is_once    it is an operation of a Schema, and must not be sent twice, whatever happens
    asks_others  it may wait for other processes, see failures.asks_others
    seconds    how long its answer may take
    sent       loop.now() when it was sent
    retried    how often it has been sent again, as a connection was lost, here or by the peer, that may have
               begun it
    """

    __slots__ = (
        "call", "resume", "ref", "endpoint", "name", "operation", "is_oneway", "is_once", "asks_others",
        "seconds", "sent", "retried", "_forwards", "_spent", "_mode",
    )

    def __init__(self, call, resume, timeout):
        self.call = call
        self.resume = resume
        self.ref = call.ref
        self.endpoint = call.endpoint
        if isinstance(call.operation, operations.Schema):
            self._of_schema(call, timeout)
        else:
            self.name = call.operation
            self.operation = operations.operation(call.ref.interface, self.name)
            self.is_oneway = self.is_once = False
            self.seconds = max(call.seconds or 0, timeout)
        self.asks_others = failures.asks_others(call.operation)
        self.sent = None  # type: float
        self.retried = 0
        self._forwards = 0
        self._spent = 0.0
        self._mode = messages.KEY

    def _of_schema(self, call, timeout):
        self.name = call.operation.name
        self.operation = call.operation.operation
        self.is_oneway = call.operation.is_oneway
        self.is_once = True
        self.seconds = call.seconds or timeout

    @property
    def is_idempotent(self):
        """Whether it changes nothing, as far as its name shows."""
        return not self.is_once and failures.may_repeat(self.name)

    @property
    def max_reply(self):
        """Octets that its reply may have."""
        if self.operation.carries_data or self.operation.takes_values:
            return messages.HEADER + messages.LARGEST
        return messages.LARGE

    def others(self):
        """Further endpoints of the object."""
        return ior.addresses(self.ref.text())

    def transports(self):
        """In words, how else than with TCP the object can be called."""
        return ior.transports(self.ref.text()) or [ior.OTHER]

    def octets(self, number, latest, via):
        """The request, in the version of GIOP that its reference names, or in the `latest` that the peer
        understands; `via` is the endpoint that it is sent to.

        Raises OSError where the reference has no address, Refused for what CORBA cannot send, TypeError for
        arguments of another type.
        """
        version, mode, target = self.ref.target(self._mode, via)
        version = min(version, latest)
        arguments = list(zip(self.operation.arguments, self.call.args))
        try:
            return messages.request(number, version, mode, target, self.name, arguments, self.is_oneway)
        except marshal.Unsendable as e:
            raise errors.Refused(str(self.call.where), f"cannot be asked: {e}", name="BAD_PARAM")
        except (ValueError, StructError) as e:
            raise TypeError(f"{self.name}: {e}")

    def answered(self, status, data, start, little):
        """Take the reply; True if the request is to be sent again, to `ref`,
        which has forwarded it or wants another form.
        """
        value = error = None
        allowance.begin()
        try:
            if len(data) > messages.LARGE and len(data) > self.max_reply:
                raise ValueError(f"more than {self.max_reply} octets")
            if status == messages.NO_EXCEPTION:
                part = self.call.part
                readers = self.operation.results if part is None else self.operation.of_part(part)
                value, end = readers[little](data, start)
                if self.is_once:
                    check_end(data, end)
            elif status == messages.SYSTEM_EXCEPTION:
                name, label, completed = _system_exception(data, start, little)
                # the peer has lost a connection of its own
                if name == "COMM_FAILURE" and self.is_idempotent and not self.retried:
                    self.retried = 1
                    return True
                error = failures.system(str(self.call.where), name, label)
                if self.is_once:
                    error.exception = name, completed
            elif status == messages.USER_EXCEPTION:
                error = self._user_exception(data, start, little)
            else:
                self._forward(status, data, start, little)
                return True
        except GARBLED as e:
            error = self._error(e)
            if self.is_once and status == messages.NO_EXCEPTION:
                error.exception = "MARSHAL", 0
        self.resume(value, error)
        return False

    def _forward(self, status, data, start, little):
        if self._forwards:  # the first answer may have waited for those before it
            self._spent += loop.now() - self.sent
        self._forwards += 1
        if self._forwards > FORWARDS or self._spent > self.seconds:
            raise ValueError("forwarded again and again")
        if status == messages.NEEDS_ADDRESSING_MODE:
            self._mode, _ = operations.reader(descriptors.SHORT, little)(data, start)
            if self._mode not in (messages.KEY, messages.PROFILE, messages.REFERENCE):
                raise ValueError(f"addressing mode {self._mode}")
            return
        if status not in (messages.FORWARD, messages.FORWARD_PERM):
            raise ValueError(f"a reply of status {status}")
        interface = self.call.ref.interface
        descriptor = idl.descriptor(interface) if interface else _OBJECT
        self.ref, _ = operations.reader(descriptor, little)(data, start)
        if self.ref is None:
            raise ValueError("forwarded to nobody")
        self.endpoint = self.ref.address[1:3]

    def _user_exception(self, data, offset, little):
        """The errors.Error for an exception of the IDL."""
        type_id, start = operations.reader(marshal.TEXT, little)(data, offset)
        if type_id not in self.operation.raised:
            return failures.system(str(self.call.where), "UNKNOWN", "CORBA.UNKNOWN")
        raised, _ = self.operation.exception_reader(type_id, little)(data, start)
        where = str(self.call.where)
        name = type_id.split(":")[1].rpartition("/")[2]
        if self.is_once:
            return errors.Raised(where, name, raised)
        return failures.user(where, name, getattr(raised, "description", ""))

    def silent(self, why):
        """It ends, as the process did not answer it."""
        self.unanswered(errors.Silent(str(self.call.where), why))

    def unanswered(self, error):
        """It ends with an errors.Unanswered. When it was forwarded, that says nothing about the process that
        was asked first.
        """
        if self.endpoint != self.call.endpoint:
            error = errors.Unreachable(error.where, error.why)
        self.resume(None, error)

    def failed(self, e):
        """It ends with an errors.Error for an exception."""
        if isinstance(e, GARBLED + (OSError, connections.Closed)):
            e = self._error(e)
        self.resume(None, e)

    def _error(self, e):
        where = str(self.call.where)
        if isinstance(e, connections.Closed):
            return errors.ConnectionLost(where)
        if isinstance(e, ConnectionRefusedError):
            return errors.ConnectionRefused(where)
        if isinstance(e, real.NoSuchHost):
            return errors.Unreachable(where, errors.NO_USABLE_ADDRESS)
        if isinstance(e, OSError):
            session.current().note_shortage(e, self.ref.address.host)
            return failures.unreachable(where, e)
        # the answer can be read; it costs what the reference is bound to, not who sent it
        if isinstance(e, ior.BadReference):
            return errors.Garbled(where, str(e))
        return errors.Unreachable(where, f"garbled answer ({_words(e)})")


def _words(e):
    """What is wrong with an answer, by what reading it raised."""
    if isinstance(e, RecursionError):
        return "nested too deep"
    if isinstance(e, (StructError, IndexError)):
        return "it ends too early"
    return e


def _system_exception(data, offset, little):
    """(name, label, whether the operation was completed) of a system exception, which is sent as its id, its
    minor code, and that: 0 for yes, 1 for no, 2 for maybe.
    """
    name, offset = operations.reader(marshal.TEXT, little)(data, offset)
    minor, offset = operations.reader(descriptors.ULONG, little)(data, offset)
    completed, offset = operations.reader(descriptors.ULONG, little)(data, offset)
    name = name.split(":")[1].rpartition("/")[2] if name.count(":") == 2 else "UNKNOWN"
    meaning = idl.MINORS.get(name, {}).get(minor)
    if meaning:
        return name, f"{name}_{meaning}", completed
    return name, "CORBA." + printable(name[:LONGEST_NAME]), completed


def check_end(data, end):
    """Raise ValueError if there are more octets in a reply than its results, which stop at `end`."""
    if len(data) - end > PADDING:
        raise ValueError(f"{len(data) - end} octets more than it should have")
