"""omniORB, as orb.py needs it: its settings, references, calls with a deadline, CORBA exceptions as errors.

Its calls cannot be interrupted: threads make them, and wake the loop.
"""

import collections
import os
import sys
import threading

from rtshell_lite import errors
from rtshell_lite.corba import answers, failures, session, stubs
from rtshell_lite.giop import idl, ior
from rtshell_lite.giop.operations import Schema
from rtshell_lite.net import loop, real
from rtshell_lite.text import from_wire, printable, to_wire

PROBING = 4  # a host has a quarter of the timeout to refuse a connection
CONNECTIONS = 5  # the most that omniORB opens to one process (maxGIOPConnectionPerServer)
IN_FLIGHT = 4  # calls to a process at a time, each on a thread
ASKING_OTHERS = 2  # of these, calls that may wait for other processes, see corba/iiop/connections.py
HANDOVER = 5.0  # s that a caller of a servant waits at most for the loop
GATHER = 0.01  # s until the loop looks again for values, while they come
# values that may wait for the loop, and octets of the largest of them
MOST_WAITING = 256
LARGEST_WAITING = 1 << 14

HEEDED = None  # all settings of omniORB
ANSWERS_AT_ONCE = False

_started = None  # the ORB, once there is one
_memory = session.Memory()  # of all commands of this process, as omniORB keeps its connections for all
_deadline = 0.0  # s, the deadline that it was given
_session = None  # the Session of the command that runs
_starting = threading.RLock()


# ---- the ORB ----


def start():
    """The ORB of this process, made at the first call.
    Raises MissingOmniORB, Usage (bad RTCTREE_ORB_ARGS).
    """
    global _started, _deadline, _session
    if loop.current() is None and _started is not None:  # a thread of ours asks for it
        return _started
    with _starting:
        _session = session.current()
        _session.memory = _memory
        if _started is None:
            _started = _make_orb()
            _deadline = session.current().timeout
        elif _deadline != session.current().timeout:  # another command of rtsh, with a --timeout of its own
            _deadline = session.current().timeout
            _set_deadline()
    return _started


def is_installed():
    """Whether omniORBpy can be imported."""
    try:
        stubs.import_omniorb()
    except errors.MissingOmniORB:
        return False
    return True


def _make_orb():
    CORBA = stubs.import_omniorb()
    stubs.register()
    timeout = _milliseconds(session.current().timeout)
    settings = {
        "traceLevel": "0",
        "verifyObjectExistsAndType": "0",
        "giopMaxMsgSize": str(32 << 20),
        "clientCallTimeOutPeriod": timeout,
        "clientConnectTimeOutPeriod": timeout,
    }
    arguments = ["rtshell_lite"] + [word for key, value in settings.items() for word in ("-ORB" + key, value)]
    own = [a for a in os.environ.get("RTCTREE_ORB_ARGS", "").split(";") if a]
    try:
        return CORBA.ORB_init(arguments + own, CORBA.ORB_ID)
    except CORBA.SystemException as e:
        given = "RTCTREE_ORB_ARGS: " + printable(";".join(own))
        where = given if own else "omniORB.cfg, or a variable ORB…"
        raise errors.Usage(f"{where}: not understood by omniORB ({_label(e)})")


def version():
    """The version of omniORBpy. Raises MissingOmniORB."""
    stubs.import_omniorb()
    import omniORB

    return "omniORBpy " + omniORB.__version__


def _set_deadline():
    import omniORB

    omniORB.setClientCallTimeout(int(_milliseconds(_deadline)))
    omniORB.setClientConnectTimeout(int(_milliseconds(_deadline)))


def _milliseconds(seconds):
    return str(max(1, int(seconds * 1000)))


# ---- references ----


def from_url(where, url):
    """The reference of a corbaloc or the like; contacts nobody. Raises BadPath."""
    orb = start()
    from omniORB import CORBA

    try:
        return orb.string_to_object(to_wire(url))
    except CORBA.SystemException as e:
        raise errors.BadPath(where, f"not an address ({_label(e)})")


def from_text(where, text):
    """The reference in a stringified IOR that a peer has sent.
    Raises Unreachable where the text is no reference.
    """
    orb = start()
    from omniORB import CORBA

    try:
        return orb.string_to_object(ior.checked(text))
    except ValueError as e:
        raise errors.Unreachable(where, str(e))
    except CORBA.SystemException as e:
        raise errors.Unreachable(where, f"not a reference ({_label(e)})")


def to_text(ref):
    """The stringified IOR of a reference, on any thread."""
    return (_started or start()).object_to_string(ref)


def address(ref):
    """What the IOR of a reference says, an ior.Address."""
    return ior.address(to_text(ref))


def narrow(ref, interface):
    """`ref` as a reference of an interface by its name, on trust."""
    type_id = idl.id_of(interface)
    if type(ref)._NP_RepositoryId == type_id:
        return ref  # narrowing again takes 30 us
    return ref._unchecked_narrow(stubs.interface(type_id))


def same(ref, other):
    """True if two references denote one object, as far as can be known without a remote call."""
    return bool(ref._is_equivalent(other))


# ---- calls ----


def repeated(call, otherwise):
    """See corba/iiop/peers.py; here, calls are made one by one."""
    return otherwise


async def invoke(call):
    """The result of an orb.Call; raises what orb.call raises."""
    here = loop.current()
    queues = here.peers
    if queues is None:
        here.make_bell()
        queues = here.peers = {}
    if not call.endpoint[1]:
        _check_spoken(call)
    queue = queues.get(call.endpoint)
    if queue is None:
        queue = queues[call.endpoint] = _Queue(here, call.endpoint)
    item = _Item(call, queue)
    queue.add(item)
    try:
        return await item.wait
    finally:
        if not item.wait.is_over:
            queue.withdraw(item)


def _check_spoken(call):
    """Raise Unspoken for a call of an object without TCP, unless omniORB speaks its transport."""
    others = ior.transports(to_text(call.ref)) or [ior.OTHER]
    if "UNIX sockets" not in others:
        raise errors.Unspoken(str(call.where), " or ".join(others))


class _Item:
    """An orb.Call on its way: `queue` of its process, `begun` (loop.now()) when a thread has taken it,
    and `wait` for its outcome.
    """

    __slots__ = ("call", "seconds", "queue", "begun", "wait", "is_withdrawn", "may_take_long", "asks_others")

    def __init__(self, call, queue):
        self.call = call
        self.queue = queue
        self.seconds = max(call.seconds or 0, queue.session.timeout)
        self.is_withdrawn = False
        # of a user's IDL: it may take longer than its caller waits, which is no silence of the process
        self.may_take_long = isinstance(call.operation, Schema)
        if call.seconds and self.may_take_long:
            self.seconds = call.seconds
        self.asks_others = failures.asks_others(call.operation)
        self.begun = None
        self.wait = loop.Wait()


class _Queue:
    """What one process is asked, by IN_FLIGHT threads at most. After the first silence, the rest is not
    asked.
    """

    def __init__(self, of, endpoint):
        self.loop = of
        self.session = session.current()
        self.endpoint = endpoint
        self.waiting = collections.deque()  # type: collections.deque
        self.waiting_for_others = collections.deque()  # type: collections.deque
        # one for each thread that may make a call that waits for others: threads take them, and put them back
        self._turns = collections.deque(ASKING_OTHERS * [None])
        self.open = set()
        self.has_answered = False  # set by threads, too: another may wait for what the loop has not heard yet
        self._threads = 0
        self._checking = None

    def add(self, item):
        """Have a call made. Raises Shortage where there is no thread for it."""
        self.has_answered = self.has_answered or self.endpoint in self.session.memory.answered
        (self.waiting_for_others if item.asks_others else self.waiting).append(item)
        self.open.add(item)
        self._start()
        if self._checking is None:
            self._checking = self.loop.call_later(session.TICK, self._check)

    def withdraw(self, item):
        """Nobody waits for the result of a call any more; it is not made, if it has not been begun."""
        self.open.discard(item)
        item.is_withdrawn = True

    def _start(self):
        may_go_on = self.waiting or self.waiting_for_others and self._turns
        if may_go_on and self._threads < IN_FLIGHT:
            self._threads += 1
            loop.begun_on_thread(self.work)

    def work(self):
        """Make calls until none waits; on a thread."""
        while True:
            item = self._next()
            if item is None:
                break
            value = error = None
            try:
                value = self._made(item)
            except BaseException as e:
                error = e
            finally:
                if item.asks_others:
                    self._turns.append(None)
            if item.begun is None:  # withdrawn
                continue
            self.loop.post(self._end, item, value, error)
            if isinstance(error, errors.Silent):  # the loop decides whether the others are to be asked
                break
        self.loop.post(self._leave)

    def _next(self):
        """An _Item to make now, None for none; on a thread."""
        try:
            return self.waiting.popleft()
        except IndexError:
            pass
        try:
            self._turns.popleft()
        except IndexError:
            return None
        try:
            return self.waiting_for_others.popleft()
        except IndexError:
            self._turns.append(None)
        return None

    def _made(self, item):
        """The result of a call, made on this thread; None where nobody waits for it."""
        if item.is_withdrawn:
            return None
        item.begun = loop.now()
        value = _made(item)
        self.has_answered = True
        return value

    def _leave(self):
        self._threads -= 1
        self._start()

    def _end(self, item, value, error):
        self.open.discard(item)
        if item.wait.is_over:  # given up before
            return
        if isinstance(error, errors.Silent) and not item.may_take_long:
            self.session.fall_silent(self.endpoint, error.why, item.begun, item.asks_others)
            self._check_rest()
        elif error is None or isinstance(error, errors.Refused):
            self.session.has_answered(self.endpoint, loop.now())
        item.wait.end(value, error)

    # ---- what does not come ----

    def _check(self):
        """Give up what omniORB does not, such as the look-up of a name."""
        self._checking = None
        now = loop.now()
        is_over = self.session.is_over()
        for item in list(self.open):
            if item.begun is None:
                continue
            where = str(item.call.where)
            if is_over:
                self._give_up(item, errors.NoTime(where, session.NO_TIME))
            elif now - item.begun > item.seconds + session.GRACE:
                why = session.no_answer(item.seconds)
                if not item.may_take_long:
                    self.session.fall_silent(self.endpoint, why, item.begun, item.asks_others)
                self._give_up(item, errors.Silent(where, why))
        self._check_rest()
        if self.open:
            self._checking = self.loop.call_later(session.TICK, self._check)

    def _check_rest(self):
        """End what is not to be asked now, by what has been found of the process."""
        for queue, asks_others in ((self.waiting, False), (self.waiting_for_others, True)):
            failure = self.session.why_not_asked("", self.endpoint, asks_others)
            while failure is not None:
                try:
                    item = queue.popleft()  # threads take some, too
                except IndexError:
                    break
                self._give_up(item, type(failure)(str(item.call.where), failure.args[-1]))

    def _give_up(self, item, failure):
        self.open.discard(item)
        item.wait.failed(failure)


def _made(item):
    """The result of a call, made on this thread,
    with a deadline of its `seconds` where that is not the timeout.
    """
    from omniORB import CORBA

    call = item.call
    where = call.where
    ref = call.ref
    operation = call.operation
    args = call.args
    if item.seconds != _deadline:
        import omniORB

        omniORB.setClientCallTimeout(ref, int(_milliseconds(item.seconds)))
    try:
        if not failures.may_repeat(operation) and call.endpoint in item.queue.session.memory.of_one_reply:
            _use_up_connections(ref)
        if isinstance(operation, Schema):
            return _by_schema(item)
        try:
            return answers.invoke(where, ref, operation, args)
        except CORBA.COMM_FAILURE as e:
            if not item.queue.has_answered:
                _check_version(str(where), call.endpoint)
            return _asked_again(e, item)
    except CORBA.Exception as e:
        error = _error(str(where), e, item.seconds, ref)
        if isinstance(operation, Schema):
            error.exception = _raised_by_peer(e)
        raise error


def _raised_by_peer(e):
    """(name, whether it was completed) of a system exception that a peer has raised, for errors.Error; None
    for one that may be omniORB's own. Results that cannot be read are a MARSHAL.
    """
    from omniORB import CORBA

    if isinstance(e, CORBA.COMM_FAILURE) and e.completed == CORBA.COMPLETED_YES:
        return "MARSHAL", CORBA.COMPLETED_YES._v
    if isinstance(e, (CORBA.COMM_FAILURE, CORBA.TRANSIENT, CORBA.TIMEOUT, CORBA.UserException)):
        return None
    return type(e).__name__, e.completed._v


def _by_schema(item):
    """The result of a call of an operation that a user's IDL describes; it is made once."""
    import omniORB
    from rtshell_lite.corba import schemas

    call = item.call
    try:
        return schemas.invoke(start(), str(call.where), call.ref, call.operation, call.args)
    finally:
        omniORB.setClientCallTimeout(call.ref, 0)  # as all other calls have it


def _asked_again(failure, item):
    """The result of a question whose answer was lost: it is asked again, once for each connection that may be
    an old one.

    rtsh keeps connections. When a process ends, or is restarted at the same port, all of them are lost, and
    each shows it only when it is next used. Changes are not repeated: they may have been made.
    """
    from omniORB import CORBA

    call = item.call
    if not failures.may_repeat(call.operation) or not item.queue.has_answered:
        raise failure
    for _ in range(CONNECTIONS):
        try:
            answer = answers.invoke(call.where, call.ref, call.operation, call.args)
        except CORBA.COMM_FAILURE as e:
            failure = e
        else:
            item.queue.session.memory.of_one_reply.add(call.endpoint)
            return answer
    raise failure


def _use_up_connections(ref):
    """Have omniORB notice that all connections to a process have been closed:
    a change must not be sent by one of these.
    """
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
    """Raise Unreachable if a process that has closed the connection to omniORB answers in GIOP 1.0 or 1.1
    only.
    """
    from rtshell_lite.giop import messages

    for minor in (2, 1, 0):
        try:
            with real.connected(endpoint, _deadline / PROBING) as probe:
                request = messages.request(1, (1, minor), messages.KEY, b"\1\0\0\0?", "_non_existent", ())
                probe.sendall(request)
                head = probe.recv(messages.HEADER)
        except (OSError, ValueError):
            return
        if head[:6] != b"GIOP\1" + bytes([minor]) or head[7:8] != bytes([messages.REPLY]):
            continue
        if minor < 2:
            why = f"speaks GIOP 1.{minor} only, which omniORB does not try; set RTSHELL_ORB=builtin"
            raise errors.Unreachable(where, why)
        return


def _error(where, e, seconds, ref):
    """The errors.Error for a CORBA exception that a call to `ref` raised."""
    from omniORB import CORBA

    label = _label(e)
    if isinstance(e, CORBA.TIMEOUT):
        return errors.Silent(where, session.no_answer(seconds))
    if isinstance(e, CORBA.TRANSIENT) and label.endswith(("ConnectFailed", "NoUsableProfile")):
        if not address(ref).port:
            return errors.Unspoken(where, " or ".join(ior.transports(to_text(ref)) or [ior.OTHER]))
        if label.endswith("ConnectFailed"):
            return _not_connected(where, address(ref)[1:3])
        return errors.Unreachable(where, errors.NO_USABLE_ADDRESS)
    if isinstance(e, CORBA.SystemException):
        return failures.system(where, type(e).__name__, label)
    return failures.user(where, label, getattr(e, "description", ""))


def _not_connected(where, endpoint):
    """The errors.Error for a connection that could not be made: omniORB does not say why, so the kernel is
    asked.

    Only a refusal shows that the process is gone. Where its host cannot be reached, it may well live.
    """
    try:
        real.connected(endpoint, _deadline / PROBING).close()
    except ConnectionRefusedError:
        pass
    except (OSError, ValueError) as e:  # ValueError: not a host name
        if isinstance(e, OSError) and _session is not None:
            _session.note_shortage(e, endpoint[0])
        return failures.unreachable(where, e)
    return errors.ConnectionRefused(where)


def _label(e):
    """Short name of a CORBA exception: the minor code's where there is one."""
    import omniORB
    from omniORB import CORBA

    if isinstance(e, CORBA.SystemException):
        minor = omniORB.minorCodeToString(e)
        return sys.intern(str(minor)) if minor else sys.intern(f"CORBA.{type(e).__name__}")
    return type(e).__name__


# ---- servants ----


def serve(servant):
    """Let others call a servant: the stringified reference to it, and a function that ends that.
    Raises Usage.
    """
    orb = start()
    from omniORB import CORBA

    try:
        poa = orb.resolve_initial_references("RootPOA")
    except CORBA.INITIALIZE:  # only now omniORB begins to listen
        raise errors.Usage(errors.BAD_ENDPOINT)
    skeleton = stubs.skeleton(servant.interface)()
    here = loop.current()
    here.make_bell()
    handover = None
    if hasattr(servant, "take"):
        handover = _Handover(here, servant.take)
        servant.take = handover.take
        servant.pass_on = handover.pass_on
        servant.hurry = handover.hurry
    for operation in skeleton._omni_op_d:
        method = getattr(servant, operation)
        if handover is None:
            method = _on_loop(here, method)
        setattr(skeleton, operation, method)
    number = poa.activate_object(skeleton)
    poa._get_the_POAManager().activate()

    def withdraw():
        poa.deactivate_object(number)
        if handover is not None:
            handover.hurry()

    return orb.object_to_string(poa.id_to_reference(number)), withdraw


def _on_loop(of, method):
    """A function for threads of omniORB that has the loop call a method of a servant,
    and waits for what that returns.
    """

    def called(*args):
        box = []
        done = threading.Lock()
        done.acquire()
        _check_open(of)

        def call():
            try:
                box.append(method(*args))
            finally:
                done.release()

        of.post(call)
        if not done.acquire(timeout=HANDOVER) or not box:
            from omniORB import CORBA

            raise CORBA.UNKNOWN(0, CORBA.COMPLETED_MAYBE)
        return box[0]

    return called


def _check_open(of):
    """Raise OBJECT_NOT_EXIST, to a caller of ours, where the loop has ended."""
    if of.is_closed:
        from omniORB import CORBA

        raise CORBA.OBJECT_NOT_EXIST(0, CORBA.COMPLETED_NO)


class _Handover:
    """Passes values from threads of omniORB, which answer their senders, to the loop, many at a time: waking
    the loop for each value costs more than all the rest. Where many wait, for large values, and after
    `hurry`, the thread waits for the loop, and the sender with it.
    """

    def __init__(self, of, take):
        """The loop calls take(received, data) for each value."""
        self._loop = of
        self._take = take
        self._take_now = _on_loop(of, self._take_last)
        self._waiting = collections.deque()  # type: collections.deque
        self._is_coming = False  # the loop will look for values: it is called, or has a timer
        self._is_hurried = False
        self._timer = loop.Timer(0, 0, None)  # of the next look; this one is never due

    def take(self, received, data):
        """Take a value, on any thread. Raises what the functions of _on_loop raise."""
        if self._is_hurried or len(data) > LARGEST_WAITING or len(self._waiting) >= MOST_WAITING:
            self._take_now(received, data)
            return
        _check_open(self._loop)
        self._waiting.append((received, data))
        if not self._is_coming:
            self._is_coming = True
            self._loop.post(self.pass_on)

    def pass_on(self):
        """Take what waits, and look again after GATHER seconds. After a look that finds nothing, the next
        value calls the loop.
        """
        self._timer.cancel()
        self._is_coming = False  # before the look at what waits: what comes after it calls the loop
        if not self._waiting:
            return
        while self._waiting:
            self._take(*self._waiting.popleft())
        if self._is_hurried:
            return
        self._timer = self._loop.call_later(GATHER, self.pass_on)
        self._is_coming = True

    def hurry(self):
        """See servants.InPortCdr; on the loop."""
        self._is_hurried = True
        self.pass_on()

    def _take_last(self, received, data):
        self.pass_on()
        self._take(received, data)


# ---- values ----


def properties(nvlist, only=None):
    """An SDOPackage::NVList as a list of (name, value) texts in its order; other values are converted to
    text.

    `only`: those of this name.
    """
    from omniORB import CORBA

    string = CORBA.tk_string  # almost all are; `is`, because == of these takes as long as all the rest
    texts = []
    for nv in nvlist:
        if only and nv.name != only:
            continue
        if nv.value.typecode().kind() is string:
            value = from_wire(nv.value.value())
        else:
            value = _as_text(nv.value, CORBA)
        texts.append((sys.intern(from_wire(nv.name)), value))
    return texts


def _as_text(value, CORBA):
    typecode = value.typecode()
    value = value.value()
    kind = typecode.kind()
    # the data_value of 1.1, a TimedLong of zeros
    if kind in (CORBA.tk_struct, CORBA.tk_union, CORBA.tk_except):
        return f"<{from_wire(typecode.id())}>"
    if kind == CORBA.tk_objref:
        return start().object_to_string(value)
    return "" if value is None else str(value)


def descriptor(type_id):
    """The type descriptor that a user's stubs registered with omniORB for a repository id, or None."""
    import omniORB

    return omniORB.typeMapping.get(type_id)


def descriptor_in(nvlist, name):
    """The descriptor of the type of the value with this name in an SDOPackage::NVList, or None."""
    return next((nv.value.typecode()._d for nv in nvlist if nv.name == name), None)


def nvlist(pairs):
    """(name, value) texts as an SDOPackage::NVList of strings,
    the one type that every implementation accepts.
    """
    from omniORB import CORBA

    NameValue = idl.struct("SDOPackage.NameValue")
    return [NameValue(to_wire(n), CORBA.Any(CORBA.TC_string, to_wire(v))) for n, v in pairs]
