"""Connections to processes. Nothing here waits, but `replies`, for a moment, if asked to;
what comes is bounded.
"""

import errno
import itertools
import os
import struct
from _functools import partial  # as in net/loop.py

from rtshell_lite import errors
from rtshell_lite.corba import session
from rtshell_lite.giop import messages
from rtshell_lite.net import hosts, loop, real

PIECE = 16384  # octets received at a time: buffers of more are slow to allocate
AT_A_TIME = 64  # pieces of one connection; then others have their turn, too
# calls to a process at a time: real-time threads keep their period, and omniORB has 5 connections
IN_FLIGHT = 4
# of these, calls that may wait for other processes (failures.asks_others): the others show that it lives
ASKING_OTHERS = 2
# answers that an object may owe us until it is asked nothing more that waits for others: a command that runs
# for days beside a process that hangs would take thread after thread of its neighbours (docs/protocol.md 1.7)
MOST_OWED = 3
SPARED = 900.0  # seconds until it is asked once more all the same, as answers may have been lost
MOST_STRAYS = 100  # replies of one connection that nobody waits for
SWEEP = 10.0  # seconds between two looks for idle connections that the peer has closed


class Closed(Exception):
    """The peer has closed the connection; `not_started`:
    it says that it has begun nothing of what it was asked.
    """

    def __init__(self, not_started=False):
        super().__init__()
        self.not_started = not_started


def kept(memory, endpoint):
    """A connection that an earlier call has left and the peer has not closed, or None."""
    waiting = memory.idle.get(endpoint)
    try:
        while waiting:
            connection = waiting.pop()
            if connection.is_idle():
                return connection
            connection.close()
    except IndexError:  # another thread was faster
        pass
    return None


def forget(memory, *endpoints):
    """Close the idle connections to these processes; True if there were any."""
    has_closed = False
    for waiting in [memory.idle.pop(endpoint, []) for endpoint in endpoints]:
        try:
            while True:
                waiting.pop().close()  # one by one: `kept`, on another thread, may take some of them
                has_closed = True
        except IndexError:
            pass
    return has_closed


def sweep(memory):
    """Close what the peers have closed: a process that is started again has another port,
    and this one is never asked for again.
    """
    memory.swept = loop.now()
    for endpoint in list(memory.idle):
        still_open = list(iter(partial(kept, memory, endpoint), None))
        if still_open:
            memory.idle[endpoint] = still_open
        else:
            memory.idle.pop(endpoint, None)


class TcpConnection:
    """A connection with the process at `endpoint`, (host, port).

    requests   what waits for a reply, by number
    has_answered
    waits_for  "address" of the host, "peer" to accept, "" when connected
    end        the exception that ends it, when the replies before that have been given out; None before
    """

    def __init__(self, endpoint, others=tuple):
        """`others()` gives further endpoints, for where nobody listens at the first."""
        self.endpoint = endpoint
        self.requests = {}
        self.has_answered = False
        self.waits_for = "address"
        self.end = None
        self._number = 0
        # replies to come that nobody waits for: {number: key of an object that may wait for others, or None}
        self._given_up = {}  # type: dict
        self._spared = {}  # {key of an object that is not asked, as it owes too many of these: until when}
        self._strays = 0
        self._memory = session.current().memory
        self._version = (1, self._memory.spoken.get(endpoint, 2))  # the latest GIOP to speak
        self._via = endpoint  # where it is connected
        self._socket = None  # type: real.Stream
        self._candidates = self._all_candidates(others)
        self._error = None  # type: OSError
        self._out = bytearray()  # what is to be sent
        self._not_begun = {}  # requests until there is a connection, by number
        self._oneway = []  # numbers of those that are over when they have been sent
        self._early = b""  # the first of what came, as `exchange` has received it
        self._pieces = []
        self._have = 0
        self._need = messages.HEADER
        self._to_discard = 0  # octets to come, the rest of a message that is too long
        self._fragments = messages.Fragments()

    @property
    def is_quiet(self):
        """True if there is nothing to do but to wait for replies."""
        return not self.waits_for and not self._out

    def wanted(self):
        """(file descriptor or None, events that a poll is to look for)."""
        if self._socket is None:
            return None, 0
        if self.waits_for:
            return self._socket.fileno(), loop.WRITE
        return self._socket.fileno(), loop.READ | (loop.WRITE if self._out else 0)

    # ---- connecting ----

    def _all_candidates(self, others):
        """The places to connect with, as of getaddrinfo, one after the other;
        None while a name is looked up.
        """
        for host, port in itertools.chain([self.endpoint], _lazily(others)):
            if not port:  # it listens with another transport there
                continue
            look_up = hosts.LookUp(host)
            while look_up.found is None:
                look_up.begin()
                yield None
            if isinstance(look_up.found, OSError):
                self._error = self._error or look_up.found
                continue
            self._via = host, port
            for *way, address in look_up.found:
                yield (*way, address[:1] + (port,) + address[2:])

    def go_on(self):
        """Take the next step towards a connection.
        Raises OSError, that of the first place, when there is no way left.
        """
        if self.waits_for == "peer":
            code = real.failure(self._socket)
            if not code:
                return self._connected()
            self._failed(code)
        for way in self._candidates:
            if way is None:
                return
            code = self._begun_with(*way)
            if code == 0:
                return self._connected()
            if code == errno.EINPROGRESS:
                self.waits_for = "peer"
                return
            self._failed(code)
        raise self._error or OSError(0, "no address of IIOP in its reference")

    def _begun_with(self, family, kind, protocol, _, address):
        """Begin to connect with a place: its error number."""
        try:
            self._socket = loop.world().stream(family, protocol)
            real.send_at_once(self._socket)
            self._socket.setblocking(False)
            return self._socket.connect_ex(address)
        except OSError as e:
            if e.errno in (errno.EMFILE, errno.ENFILE) and forget(self._memory, *list(self._memory.idle)):
                return self._begun_with(family, kind, protocol, None, address)
            return e.errno

    def _failed(self, code):
        self._error = self._error or OSError(code, os.strerror(code))
        self.close()
        self.waits_for = "address"

    def _connected(self):
        self._socket.setblocking(True)
        real.limit(self._socket, session.TICK)
        self.waits_for = ""
        self._candidates = None  # it holds the first request, and so its answer
        if self._via != self.endpoint:  # where objects may have other keys
            self._not_begun = {
                number: self.requests[number].octets(number, self._version, self._via)
                for number in self._not_begun
            }
        self._out += b"".join(self._not_begun.values())
        self._not_begun.clear()
        self.flush()

    # ---- sending ----

    def send(self, request):
        """Add a request to what is to be sent, see `flush`; its callback gets the error."""
        self._number += 1
        try:
            octets = self.octets(request, self._number)
        except (OSError, TypeError, errors.Refused) as e:
            return request.failed(e)
        request.sent = loop.now()
        self.requests[self._number] = request
        if request.is_oneway:
            self._oneway.append(self._number)
        if self.waits_for:
            self._not_begun[self._number] = octets
        else:
            self._out += octets

    def octets(self, request, number):
        """A request as it is sent here. Raises what calls.Request.octets raises."""
        return request.octets(number, self._version, self._via)

    def flush(self):
        """Send what can be sent at once. Raises OSError."""
        if self.waits_for or not self._out:
            return
        try:
            sent = self._socket.send(self._out, real.AT_ONCE)
        except BlockingIOError:
            return
        del self._out[:sent]
        while self._oneway and not self._out:
            request = self.requests.pop(self._oneway.pop(), None)
            if request is not None:
                request.resume(None, None)

    def exchange(self, octets):
        """Send a request to a peer that is asked nothing else, and wait for a moment: its number, which is
        put into the octets, and what has come, b"" for nothing. What is left to do is found out by `flush`
        and `replies`, errors included.
        """
        self._number += 1
        messages.renumber(octets, self._number)
        try:
            sent = self._socket.send(octets, real.AT_ONCE)
        except OSError:
            sent = 0
        if sent < len(octets):
            self._out += octets[sent:]
            return self._number, b""
        try:
            self._early = self._socket.recv(PIECE)
        except OSError:
            pass
        return self._number, self._early

    def has_taken(self):
        """What `exchange` returned was the whole reply."""
        self._early = b""

    def is_stray(self, number):
        """Whether nobody waits, or has waited, for a reply with this number: some peers repeat replies.

        Raises Garbled at too many.
        """
        if number in self.requests or number in self._given_up:
            return False
        self._strays += 1
        if self._strays > MOST_STRAYS:
            raise messages.Garbled("replies to other requests")
        return True

    def answered(self, number):
        """The request with this number, which has its reply; None if it was given up."""
        if self.has_answered:
            self._memory.of_one_reply.discard(self.endpoint)
        self.has_answered = True
        self._given_up.pop(number, None)
        request = self.requests.pop(number, None)
        if self._spared and request is not None and request.asks_others:
            self._forgive(request.ref.address.key)
        return request

    def _forgive(self, key):
        """An object that was spared has answered such a question in time: what it owes is lost."""
        if self._spared.pop(key, None) is not None:
            for number in [number for number, owing in self._given_up.items() if owing == key]:
                self._given_up[number] = None

    def give_up(self, number):
        """The request with this number, whose reply is not to be waited for;
        it is not sent any more if it has not been.
        """
        request = self.requests.pop(number)
        if self._not_begun.pop(number, None) is None:
            self._given_up[number] = request.ref.address.key if request.asks_others else None
        return request

    def spares(self, ref):
        """Whether an object that waits for others is not to be asked now, as it owes MOST_OWED answers to
        questions that were given up.
        """
        key = ref.address.key
        if list(self._given_up.values()).count(key) < MOST_OWED:
            return False
        now = loop.now()
        if now < self._spared.setdefault(key, now + SPARED):
            return True
        self._spared[key] = now + SPARED
        return False

    def ends_sparing(self, number):
        """Whether a reply with this number is the first late one of an object that was not asked any more. A
        late reply of another object shows nothing: it may be late each time.
        """
        return self._spared.pop(self._given_up.get(number), None) is not None

    def give_up_all(self):
        """Give up all requests that wait for replies, and return them."""
        return [self.give_up(number) for number in list(self.requests)]

    def not_started(self):
        """The requests that the peer has not begun, when it says so as it closes:
        none whose reply has begun to come.
        """
        begun = self._fragments.begun
        if None in begun:
            return set()
        return {request for number, request in self.requests.items() if number not in begun}

    def may_speak_older(self, end):
        """Whether a peer that has ended this connection before any reply, with an exception, may understand
        an older GIOP.

        If so, that is spoken with it from now on. Some say which; omniORB that is limited to GIOP 1.1 just
        closes.
        """
        _, minor = self._version
        is_closed = isinstance(end, Closed) and not end.not_started and not self._pieces
        if isinstance(end, messages.Misunderstood):
            older = end.minor
        elif is_closed and self.endpoint not in self._memory.answered:
            older = minor - 1
        else:
            return False
        if older < 0:  # it was not that
            self._memory.spoken.pop(self.endpoint, None)
        if self.has_answered or not 0 <= older < minor:
            return False
        self._memory.spoken[self.endpoint] = older
        return True

    # ---- receiving ----

    def replies(self, may_wait):
        """The whole replies that have come, as octets; may wait for session.TICK.
        What ends the connection is noted in `end`.
        """
        replies = []  # type: list
        try:
            for _ in range(AT_A_TIME):
                piece = self._early or self._socket.recv(PIECE, 0 if may_wait else real.AT_ONCE)
                self._early = b""
                if not piece:
                    raise Closed()
                self._take(piece, replies)
                if replies or len(piece) < PIECE:
                    break
                may_wait = False
        except BlockingIOError:
            pass
        except (OSError, Closed, ValueError, struct.error) as e:
            self.end = e
        return replies

    def _take(self, piece, replies):
        """Add what has come to what there is, and put the replies that are whole now into `replies`.

        Of one that is longer than any that is waited for, no more is taken than shows that.
        """
        if self._to_discard:
            piece = self._wanted(piece)
            if not piece:
                return
        self._pieces.append(piece)
        self._have += len(piece)
        if self._have < self._need:
            return
        data = b"".join(self._pieces)
        self._pieces = []
        start = 0
        self._need = messages.HEADER
        while self._have >= self._need:
            whole = messages.HEADER + messages.size(data, start)
            size = min(whole, 1 + self._most()) if whole > messages.LARGE else whole
            if self._have < size:
                self._need = size
                break
            message = data[start : start + size]
            start += size
            self._have -= size
            self._to_discard = whole - size
            if self._to_discard:
                data = self._wanted(data[start:])
                start = 0
                self._have = len(data)
            if message[7] == messages.REPLY and not message[6] & messages.MORE:  # most are whole
                replies.append(message)
            else:
                self._other_message(message, replies)
        if self._have:
            self._pieces = [data[start:]]

    def _wanted(self, octets):
        """These octets, but those that are unwanted."""
        dropped = min(self._to_discard, len(octets))
        self._to_discard -= dropped
        return octets[dropped:]

    def _most(self, number=None):
        """Octets that the reply to a request may have; None is any request.
        Raises Garbled where there was none.
        """
        if number is None:
            return max((request.max_reply for request in self.requests.values()), default=messages.LARGE)
        if number in self.requests:
            return self.requests[number].max_reply
        if number not in self._given_up:
            raise messages.Garbled("a reply to another request")
        return messages.LARGE

    def _other_message(self, data, replies):
        """Take what is not a whole reply."""
        kind = data[7]
        if kind == messages.CLOSE:
            raise Closed(not_started=True)
        if kind == messages.ERROR:
            raise messages.Misunderstood(data[5])
        if kind not in (messages.REPLY, messages.FRAGMENT):
            raise messages.Garbled(f"a message of kind {kind}")
        whole = self._fragments.joined(data, self._most)
        if whole is not None:
            replies.append(whole)

    def has_begun(self):
        """Whether a reply has begun to come that is not whole yet."""
        return bool(self._early or self._pieces or self._to_discard or self._fragments.begun)

    # ---- ending ----

    def is_idle(self):
        """True while nothing has come that nobody asked for, such as the end:
        then what is sent would be lost.
        """
        try:
            self._socket.recv(1, real.AT_ONCE | real.PEEK)
        except BlockingIOError:
            return True
        except OSError:
            pass
        return False

    def leave(self):
        """Keep it for the next call to its process, or close it."""
        waiting = self._memory.idle.setdefault(self.endpoint, [])
        is_clean = not (self.end or self.requests or self._given_up or self._out or self.has_begun())
        if self.has_answered and is_clean and len(waiting) < IN_FLIGHT:
            waiting.append(self)
        else:
            self.close()
        if loop.now() - self._memory.swept > SWEEP:
            sweep(self._memory)

    def close(self):
        self.end = None  # its traceback leads back here: what has come would stay until a collection
        if self._socket is not None:
            self._socket.close()
            self._socket = None


def _lazily(function):
    yield from function()
