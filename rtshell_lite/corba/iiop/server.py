"""Our objects that components call, with our own ORB: the loop serves all who connect, and none of them can
block it.

Who connects may send anything. So a message takes memory as it comes, not as it is announced; who never
completes one, asks for nothing, or takes no answers, is closed after a while, or as soon as others need the
room. A connection that has called a servant keeps its place, and is served first; of others there is a limit
for each address, for a second, and for what they may ask.
"""

import binascii
import contextlib
import os
import re
import struct

from rtshell_lite import errors
from rtshell_lite.corba import session
from rtshell_lite.giop import allowance, descriptors, idl, messages, operations, references, requests
from rtshell_lite.net import loop, real, tcp

MOST = 500  # connections
MOST_OF_ADDRESS = 200  # of them that have called no servant yet
MOST_NEW = 200  # connections that are accepted in a second; others wait
# questions that need no servant, such as _non_existent, of a connection that has called none
MOST_ASKED = 500
MOST_TASKS = 200  # answers that are awaited, as they need answers of others
MOST_PARTS = 8  # messages of a connection whose fragments are still coming
MOST_OCTETS = 2 * messages.LARGEST  # of all messages that are still coming
# octets before its arguments up to which a request is kept, to compare later ones with; real ones have 150
LONGEST_KEPT = 512
MOST_KEPT = 64  # of a connection, which may carry the calls of a whole process
ROOM = 4096  # octets that a connection can receive before it has sent any
UNFINISHED = 60.0  # seconds until a connection is closed within a message, or between two
IDLE = 180.0  # omniORB's is the same
SWEEP = 5.0  # seconds between two looks for those
# seconds until connections are accepted again, where too many have come, or there are no files left
PAUSE = 1.0
_ENDPOINT = re.compile(r"giop:tcp:(\[[^]]*\]|[^:,]*):(\d{0,5})(?:,|\Z)")


def serve(servant, host="", key=None):
    """Let others call a servant while the loop of this thread runs: the Reference to it, and a function that
    ends that.

    The reference has this `host`, unless the user has set one; `key`: octets that others know it by. Raises
    Usage.
    """
    here = loop.current()
    if here.server is None:
        here.server = Server(here, *_setting("endPoint"))
    server = here.server
    key = key or binascii.hexlify(loop.world().octets(12))
    type_id = idl.id_of(servant.interface)
    server.objects[key] = servant, type_id
    own_host, _ = _setting("endPoint")
    published, port = _setting("endPointPublish")
    profiles = references.make_reference(published or own_host or host, port or server.port, key).profiles
    return references.Reference(type_id.encode(), profiles, type_id), lambda: server.objects.pop(key, None)


def listen(host, port):
    """Serve at this address, "" for all of this host, 0 for any port, before anything is served; returns the
    port. Raises Usage.
    """
    here = loop.current()
    here.server = Server(here, host, port)
    return here.server.port


def servant(ref):
    """The servant of ours that a reference denotes, or None."""
    server = loop.current().server
    if server is None or ref is None:
        return None
    servant, _ = server.objects.get(ref.address.key, (None, None))
    own = getattr(servant, "reference", None)
    return servant if own is not None and own.address[1:] == ref.address[1:] else None


def _setting(name):
    """(host or "", port or 0) of a setting of omniORB: in RTCTREE_ORB_ARGS, or in a variable.
    Others than giop:tcp: are ignored.
    """
    words = os.environ.get("RTCTREE_ORB_ARGS", "").split(";")
    option = "-ORB" + name
    text = words[words.index(option) + 1] if option in words[:-1] else os.environ.get("ORB" + name, "")
    match = _ENDPOINT.match(text)
    if not match:
        return "", 0
    return match.group(1).strip("[]"), int(match.group(2) or 0)


# ---- connections ----


class Caller:
    """A connection that somebody has made to us:
    what came of its messages, and answers that have not left yet.
    """

    def __init__(self, connection, host):
        self.socket = connection
        self.host = host
        self.minor = 0
        self.kept = {}  # Requests by their heads
        self.longest = 0  # octets before the arguments of the last one
        self.has_called = False  # a servant
        self.asked = 0  # how often it has asked what needs none
        # data[begin:end] has come; data never shrinks while it is in use
        self.data = bytearray()
        self.begin = 0
        self.end = 0
        self.fragments = messages.Fragments()
        self.out = bytearray()
        self.awaited = 0  # answers that servants still wait for
        self.since = loop.now()  # when the last message was complete, or the last such answer was there

    def held(self):
        """How much memory its messages take."""
        return len(self.data) + self.fragments.size

    def is_unfinished(self):
        """True within a message, or while answers cannot leave."""
        return bool(self.end > self.begin or self.fragments.begun or self.out)

    def receive(self):
        """Take what has come. Raises OSError, EOFError."""
        left = self.end - self.begin
        if self.begin and left:
            self.data[:left] = self.data[self.begin : self.end]
        self.begin = 0
        self.end = left
        if self.end == len(self.data):
            size = messages.HEADER + messages.size(self.data) if self.end else 0
            grown = bytearray(max(ROOM, min(size, 2 * self.end)))
            grown[: self.end] = self.data
            self.data = grown
        got = self.socket.recv_into(memoryview(self.data)[self.end :])
        if not got:
            raise EOFError
        self.end += got

    def message(self):
        """The next message that is complete, to be used at once, or None. Raises Garbled."""
        while self.end - self.begin >= messages.HEADER:
            data = memoryview(self.data)[self.begin : self.end]
            size = messages.HEADER + messages.size(data)
            if len(data) < size:
                return None
            self.begin += size
            self.minor = data[5]
            whole = self.fragments.joined(data[:size], self.largest)
            if whole is not None:
                self.since = loop.now()
                return whole
        return None

    def largest(self, _):
        """Octets that a message in fragments may have. Raises Garbled where too many have begun."""
        if len(self.fragments.begun) > MOST_PARTS:
            raise messages.Garbled("too many messages at once")
        return messages.LARGEST

    def request(self, data):
        """The Request in a message; most differ from an earlier one only in their ids and arguments.
        Raises as Request does.
        """
        request = self.kept.get(requests.head(data, self.longest))
        if request is not None:
            request.take_on(data)
            return request
        request = requests.Request(data)
        if self.has_called and request.at and request.minor == 2 and request.at <= LONGEST_KEPT:
            self.longest = request.at
            if len(self.kept) >= MOST_KEPT:
                self.kept.clear()
            self.kept[requests.head(data, request.at)] = request
        return request

    def send(self, data=b""):
        """Send an answer, and those before it, as far as the caller takes them. Raises OSError."""
        self.out += data
        try:
            del self.out[: self.socket.send(self.out)]
        except BlockingIOError:
            pass


class Server:
    """Listens, and serves `objects`, {key: (servant, id of its interface)}.
    Raises Usage where it cannot listen.
    """

    def __init__(self, of, host, port):
        self.loop = of
        self.session = session.current()
        self.objects = {}
        self.callers = {}  # type: dict  # of them alone: a set has no order
        self.second = loop.now()  # since when new connections are counted
        self.new = 0  # how many
        self.tasks = set()  # type: set  # of servants that ask others before they answer
        self.listening = tcp.listen(host, port)
        if self.listening is None:
            raise errors.Usage(errors.BAD_ENDPOINT)
        self.port = self.listening.getsockname()[1]
        self._listen()
        of.call_later(SWEEP, self.sweep)
        of.at_end.append(self.end)

    def end(self):
        """Take no calls any more."""
        for task in list(self.tasks):
            task.close()
        for caller in list(self.callers):
            self.close(caller)
        self.listening.close()

    def _listen(self):
        self.loop.watch(self.listening.fileno(), loop.READ, self.accept)

    def _pause(self):
        """Accept no connections for a moment."""
        self.loop.unwatch(self.listening.fileno())
        self.loop.call_later(PAUSE, self._listen)

    def accept(self):
        """Take a new connection. Where there is no room, one that has called no servant is closed, or else
        the new one.
        """
        now = loop.now()
        if now - self.second >= 1:
            self.second = now
            self.new = 0
        self.new += 1
        if self.new > MOST_NEW:
            self._pause()
            return
        try:
            connection, (host, *_) = self.listening.accept()
        except (BlockingIOError, ConnectionError):
            return  # gone already
        except OSError:  # out of files
            if not self.turn_away(self.strangers()):
                self._pause()
            return
        beside = self.strangers(host)
        if len(beside) >= MOST_OF_ADDRESS:
            self.turn_away(beside)
        elif len(self.callers) >= MOST and not self.turn_away(self.strangers()):
            self.turn_away([Caller(connection, host)])
            return
        connection.setblocking(False)
        with contextlib.suppress(OSError):  # on macOS, where it has ended already
            real.send_at_once(connection)
        caller = Caller(connection, host)
        self.callers[caller] = True
        self._watch(caller)

    def _watch(self, caller):
        """Have the loop call when a connection can go on:
        those that have called a servant are attended first.
        """
        may_send = bool(caller.out)

        def go_on():
            if caller.has_called:
                self.attend(caller, may_send)
            else:
                self.loop.post(self.attend, caller, may_send)

        self.loop.unwatch(caller.socket.fileno())
        self.loop.watch(caller.socket.fileno(), loop.WRITE if may_send else loop.READ, go_on)

    def attend(self, caller, may_send):
        """Read from a connection or write to it, and answer what is complete while answers can leave."""
        if caller not in self.callers:  # closed a moment ago
            return
        try:
            if may_send:
                caller.send()
            else:
                caller.receive()
                if caller.fragments.begun or len(caller.data) > 16 * ROOM:
                    self.make_room()
            while caller in self.callers and not caller.out:
                data = caller.message()
                if data is None:
                    break
                answer = self.answered(caller, data)
                if answer:
                    caller.send(answer)
                if not caller.has_called and caller.asked > MOST_ASKED:
                    self.close(caller)
        except BlockingIOError:
            return
        except (messages.Garbled, struct.error, IndexError):
            return self.close(caller, messages.ERROR)
        except (OSError, EOFError, MemoryError):
            return self.close(caller)
        if caller in self.callers and may_send != bool(caller.out):
            self._watch(caller)

    def make_room(self):
        """Take memory from who does not use it, and close who has not completed a message for longest,
        until all is within the limit.
        """
        while sum(caller.held() for caller in self.callers) > MOST_OCTETS:
            unused = [caller for caller in self.callers if caller.data and caller.begin == caller.end]
            for caller in unused:
                caller.data = bytearray()
                caller.begin = caller.end = 0
            if not unused:
                holding = list(filter(Caller.held, self.callers))
                self.turn_away([caller for caller in holding if not caller.has_called] or holding)

    def strangers(self, host=None):
        """The connections, of a host or of all, that have called no servant."""
        return [caller for caller in self.callers if not caller.has_called and host in (None, caller.host)]

    def turn_away(self, callers):
        """Close the one of some connections that has completed no message for longest;
        False if there are none.
        """
        if not callers:
            return False
        self.session.turned_away += 1
        self.close(min(callers, key=lambda caller: caller.since))
        return True

    def sweep(self):
        """Close the connections that nobody uses, and those that somebody abuses."""
        self.loop.call_later(SWEEP, self.sweep)
        now = loop.now()
        for caller in list(self.callers):
            is_unfinished = caller.is_unfinished()
            limit = UNFINISHED if is_unfinished else IDLE
            if (is_unfinished or not caller.awaited) and now - caller.since > limit:
                self.close(caller)

    def close(self, caller, last=messages.CLOSE):
        """Close a connection with a last word:
        that what has not been answered has not been begun, or was not understood.
        """
        if caller in self.callers:
            self.callers.pop(caller, None)
            self.loop.unwatch(caller.socket.fileno())
        with contextlib.suppress(OSError):
            if not caller.out:
                caller.socket.send(messages.whole(last, minor=caller.minor))
        caller.socket.close()

    # ---- requests ----

    def answered(self, caller, data):
        """The answer to a message, octets, or None.
        Raises Garbled, struct.error, IndexError, EOFError at the last message.
        """
        kind = data[7]
        if kind == requests.CANCEL:
            caller.fragments.forget(messages.number(data))
            return None
        if kind in (messages.CLOSE, messages.ERROR):
            raise EOFError
        if kind not in (requests.REQUEST, requests.LOCATE):
            raise messages.Garbled("not for a server")
        request = caller.request(data)
        if request.key is None:
            answer = requests.needs_key(request)
        elif kind == requests.LOCATE:
            answer = requests.located(request, int(request.key in self.objects))
        else:
            answer = self.called(caller, request)
            caller.has_called |= request.key in self.objects and request.operation not in _ASKED
        caller.asked += 1
        request.data = None  # its caller keeps the request
        return answer if request.is_answered else None

    def called(self, caller, request):
        """Call the servant: the answer, or None where that is to come."""
        servant, interface = self.objects.get(request.key, (None, None))
        if servant is None:
            return requests.failed(request, "OBJECT_NOT_EXIST")
        try:
            readers, writers, octets = operations.served(interface, request.operation)
        except KeyError:
            return requests.failed(request, "BAD_OPERATION")
        if not octets and len(request.data) > messages.LARGE:
            return requests.failed(request, "IMP_LIMIT")
        if octets:
            data = request.data
        else:
            allowance.begin()
            data = bytes(request.data)
        arguments = []
        offset = request.at
        try:
            for read in readers[request.little]:
                value, offset = read(data, offset)
                arguments.append(bytes(value) if octets else value)
        except (ValueError, struct.error, IndexError, RecursionError):
            return requests.failed(request, "MARSHAL")
        try:
            result = _result(servant, interface, request.operation, arguments)
            if not hasattr(result, "send"):
                return _written(request, writers, result)
        except Exception as e:
            return _raised(request, interface, e)
        if len(self.tasks) >= MOST_TASKS:
            result.close()
            return requests.failed(request, "NO_RESOURCES")
        caller.kept.clear()  # the task keeps the request
        caller.awaited += 1
        self.tasks.add(
            loop.Task(self.loop, self._answer_later(caller, request, interface, writers, result), self, None)
        )
        return None

    async def _answer_later(self, caller, request, interface, writers, coroutine):
        """Send the answer of a servant that has to ask others for it."""
        try:
            answer = _written(request, writers, await coroutine)
        except Exception as e:
            answer = _raised(request, interface, e)
        finally:
            caller.awaited -= 1
        caller.since = loop.now()
        if caller not in self.callers or not request.is_answered:
            return
        try:
            caller.send(answer)
        except OSError:
            return self.close(caller)
        if caller.out:
            self._watch(caller)

    def ended(self, task):
        """A task of a servant has ended; called by it."""
        self.tasks.discard(task)


_ASKED = ("_is_a", "_non_existent")  # which need no servant


def _result(servant, interface, operation, arguments):
    if operation == "_is_a":
        return arguments[0] in idl.ancestry(interface) or arguments[0] == "IDL:omg.org/CORBA/Object:1.0"
    if operation == "_non_existent":
        return False
    return getattr(servant, operation)(*arguments)


def _written(request, writers, result):
    if result is not None and result is request.result:
        return requests.repeated(request)
    out = requests.answer(request)
    values = [result] if len(writers) < 2 else result
    for write, value in zip(writers, values):
        write(out, value)
    requests.sized(out)
    if isinstance(result, descriptors.Item) and request.minor == 2:
        request.result = result
        request.reply = bytes(out)
    return out


def _raised(request, interface, exception):
    with contextlib.suppress(ValueError, struct.error, KeyError):  # members of another type
        if isinstance(exception, requests.Thrown):
            return requests.thrown(request, interface, exception)
    return requests.failed(request, "UNKNOWN", requests.MAYBE)
