"""The processes that are asked: who may be sent what and when, what has been silent for too long, what a lost
connection means.

At most connections.IN_FLIGHT requests are on their way to a process, any number to a name server; of those
that may wait for other processes connections.ASKING_OTHERS, after all others. After the first silence of a
process, the rest is not asked.
"""

from _collections import deque  # as in net/loop.py
from _functools import partial
from struct import error as StructError

from rtshell_lite import errors
from rtshell_lite.corba import session
from rtshell_lite.corba.iiop import calls, connections
from rtshell_lite.giop import allowance, messages
from rtshell_lite.net import loop

LOOK = 0.005  # seconds between looks at whether the address of a host has been found
# times that a question is asked again as a connection was lost by which others were answered
MOST_RETRIED = 2
NAMING = "IDL:omg.org/CosNaming/"  # interfaces of name servers begin so


async def invoke(call):
    """The result of an orb.Call; raises what orb.call raises."""
    here = loop.current()
    peers = here.peers
    if peers is None:
        peers = here.peers = Peers(here)
    wait = loop.Wait()
    request = calls.Request(call, wait.end, peers.session.timeout)
    if not request.endpoint[1] and not request.others():
        raise errors.Unspoken(str(call.where), " or ".join(request.transports()))
    peers.submit(request)
    if here.has_nothing_else():
        peers.ask_alone(request.endpoint)
    try:
        return await wait
    finally:
        if not wait.is_over:
            peers.withdraw(request)


def repeated(call, otherwise):
    """A coroutine function that makes an orb.Call, of a Schema, again each time; `otherwise` is one, too, for
    what is not as usual.
    """
    return _Repeated(call, otherwise).ask


class _Repeated:
    """A call that is made again and again: its request is made into octets once for a connection. As long as
    nothing else is to be done, and each reply comes at once, whole and without an exception, nothing else
    knows of it.
    """

    def __init__(self, call, otherwise):
        self._call = call
        self._otherwise = otherwise
        self._read = call.operation.operation.results[messages.LITTLE]
        self._loop = loop.current()
        self._peer = None  # type: _Peer
        self._connection = None  # type: connections.TcpConnection  # that the octets are for
        self._octets = None

    async def ask(self):
        """Its result; raises what `invoke` raises."""
        if not self._is_ready():
            value = await self._otherwise()
            self._prepare()
            return value
        begun = loop.now()
        number, data = self._connection.exchange(self._octets)
        offset = messages.plain_reply(data, number)
        if offset:
            allowance.begin()
            try:
                value, end = self._read(data, offset)
                calls.check_end(data, end)
                self._connection.has_taken()
                return value
            except calls.GARBLED:
                pass  # it is read again, and what is wrong is said, as for any other request
        wait = loop.Wait()
        peers = self._loop.peers
        request = calls.Request(self._call, wait.end, peers.session.timeout)
        request.sent = begun
        peers.take_over(self._peer, number, request)
        try:
            return await wait
        finally:
            if not wait.is_over:
                peers.withdraw(request)

    def _is_ready(self):
        connection = self._connection
        if connection is None or connection is not self._peer.connection:
            return False
        if connection.requests or not connection.is_quiet:
            return False
        return self._loop.is_one_awaited() and self._loop.has_nothing_else()

    def _prepare(self):
        """Make the octets for the connection that there is, if it speaks GIOP 1.2 and stays."""
        peers = self._loop.peers
        request = calls.Request(self._call, None, peers.session.timeout)
        self._peer = peers.peer(request.endpoint)
        self._connection = None
        connection = self._peer.connection
        if connection is None or request.is_oneway or request.endpoint in peers.session.memory.of_one_reply:
            return
        octets = connection.octets(request, 0)
        if messages.is_newest(octets):
            self._octets = octets
            self._connection = connection


class _Peer:
    """One process: what is asked of it, and the connection with it."""

    def __init__(self, endpoint, memory):
        self.endpoint = endpoint
        self._memory = memory
        self.heard = loop.now()
        self.moved_on = 0.0  # when the request that had waited for longest was answered
        # calls.Requests that are not on their way, and those that wait for others
        self.waiting = deque()  # type: deque
        self.waiting_for_others = deque()  # type: deque
        # what the loop looks for
        self.connection = None  # type: connections.TcpConnection
        self.watched = (None, 0)

    def add(self, request):
        """Have a request wait until it may be sent."""
        (self.waiting_for_others if request.asks_others else self.waiting).append(request)

    def remove(self, request):
        """Take back a request that waits; False if it does not."""
        for queue in (self.waiting, self.waiting_for_others):
            if request in queue:
                queue.remove(request)
                return True
        return False

    def take_all(self):
        """All requests that wait, which wait no more."""
        taken = [*self.waiting, *self.waiting_for_others]
        self.waiting.clear()
        self.waiting_for_others.clear()
        return taken

    def next_queue(self):
        """The queue whose first request is to be sent next; an empty one for none."""
        if self.waiting or not self.waiting_for_others:
            return self.waiting
        if self.connection is None:
            return self.waiting_for_others
        asking = sum(request.asks_others for request in self.connection.requests.values())
        return self.waiting_for_others if asking < connections.ASKING_OTHERS else self.waiting

    def may_send(self, request):
        """Whether a request may be sent now.

        At each answer, not two at every second one: a peer without TCP_NODELAY sends the second when the
        first is acknowledged, by the next request or 40 ms later.
        """
        if self.endpoint in self._memory.of_one_reply:
            return not self.connection.requests
        return len(self.connection.requests) < connections.IN_FLIGHT or _is_naming(request)

    def needs_connection(self, request):
        """Whether a request must not be lost again with a connection that the peer may close after its reply.
        """
        if self.connection is None or self.endpoint not in self._memory.of_one_reply:
            return False
        is_used_up = self.connection.has_answered and not self.connection.requests
        return is_used_up and (not request.is_idempotent or request.retried > 1)

    def overdue(self, now):
        """Give up the requests that have waited too long, and return them.

        A name server gets many at once, so each of its answers restarts the clock of all. Another process may
        do one request after the other: the clock of the next one starts when the one before is answered.
        """
        def is_late(request):
            begun = self.heard if _is_naming(request) else self.moved_on
            return now - max(request.sent, begun) > request.seconds

        late = [number for number, request in self.connection.requests.items() if is_late(request)]
        return [self.connection.give_up(number) for number in late]

    def unanswered(self, found_silent, timeout):
        """Give up the questions that were on their way when it was found silent, and return them: they would
        cost one more timeout.

        A request that changes something keeps its time, and so does one that may take longer than others.
        """
        vain = [
            number
            for number, request in self.connection.requests.items()
            if request.sent < found_silent and request.is_idempotent and request.seconds <= timeout
        ]
        return [self.connection.give_up(number) for number in vain]


def _is_naming(request):
    return request.ref.interface.startswith(NAMING)


class Peers:
    """What one loop has under way with the processes that are asked by it.

    All is sent just before the loop waits, in one piece for each process.
    """

    def __init__(self, of):
        self.loop = of
        self.session = session.current()
        self.known = {}
        # dicts of peers alone, as sets have no order: to which requests may be sent; with requests under way
        self._changed = {}  # type: dict
        self._asked = {}  # type: dict
        self._watches = 0  # connections that the loop watches
        self._checking = None  # the Timer of the next look for what has waited too long
        self._tick = min(session.TICK, self.session.timeout / 10)
        of.before_waiting.append(self._send_all)
        of.at_end.append(self._leave_all)
        of.on_return = self._restart_clocks

    def peer(self, endpoint):
        """The _Peer of a process."""
        peer = self.known.get(endpoint)
        if peer is None:
            peer = self.known[endpoint] = _Peer(endpoint, self.session.memory)
        return peer

    def submit(self, request):
        peer = self.peer(request.endpoint)
        if request.asks_others and peer.connection is not None and peer.connection.spares(request.ref):
            request.silent(f"no answer to {connections.MOST_OWED} earlier questions")
            return
        peer.add(request)
        self._changed[peer] = True

    def withdraw(self, request):
        """Nobody waits for the result of a request any more; it is not sent, if it has not been."""
        peer = self.peer(request.endpoint)
        if peer.remove(request) or peer.connection is None:
            return
        for number, other in list(peer.connection.requests.items()):
            if other is request:
                peer.connection.give_up(number)
                self._changed[peer] = True
        if not peer.connection.requests:
            self._asked.pop(peer, None)

    # ---- sending ----

    def ask_alone(self, endpoint):
        """Send the one request that there is, and wait for its reply for a moment, without letting go on
        other tasks: that takes half of the time of a call.
        """
        peer = self.known[endpoint]
        connection = peer.connection
        if self._asked or len(peer.waiting) + len(peer.waiting_for_others) != 1:
            return
        if connection is None or not connection.is_quiet:
            return
        if endpoint in self.session.memory.of_one_reply or not self.loop.is_one_awaited():
            return
        self._asked[peer] = True
        try:
            connection.send(peer.next_queue().popleft())
            connection.flush()
        except OSError as e:
            self._lose(peer, e)
            return
        self._begin_checking()
        if connection.is_quiet and connection.requests:
            self._changed.pop(peer, None)
            self._take(peer, True)

    def take_over(self, peer, number, request):
        """Go on with a request that `exchange` of its connection has sent."""
        peer.connection.requests[number] = request
        self._asked[peer] = True
        self._changed[peer] = True
        self._begin_checking()
        self._take(peer, False)

    def _send_all(self):
        while self._changed:
            peer, _ = self._changed.popitem()
            self._send(peer)
        self.loop.alone = None
        self.loop.idle = self._watches - 1
        if len(self._asked) == 1:
            (peer,) = self._asked
            if peer.connection is not None and peer.connection.is_quiet:
                self.loop.alone = partial(self._take, peer, True)

    def _send(self, peer):
        try:
            queue = peer.next_queue()
            while queue:
                if peer.needs_connection(queue[0]):
                    self._unwatch(peer)
                    peer.connection.close()
                    peer.connection = None
                if peer.connection is None:
                    self._connect(peer, queue[0])
                if not peer.may_send(queue[0]):
                    break
                self._asked[peer] = True
                peer.connection.send(queue.popleft())
                queue = peer.next_queue()
            if peer.connection is not None:
                peer.connection.flush()
                self._watch(peer)
        except OSError as e:
            self._lose(peer, e)
        if self._asked:
            self._begin_checking()

    def _connect(self, peer, request):
        peer.connection = connections.kept(self.session.memory, peer.endpoint)
        if peer.connection is None:
            peer.connection = connections.TcpConnection(peer.endpoint, request.others)
            self._go_on_connecting(peer)

    def _go_on_connecting(self, peer):
        connection = peer.connection
        connection.go_on()
        if connection.waits_for == "address":
            self.loop.call_later(LOOK, lambda: self._look_for_address(peer, connection))

    def _look_for_address(self, peer, connection):
        if peer.connection is connection and connection.waits_for == "address":
            self._take(peer, False)

    def _watch(self, peer):
        watched = peer.connection.wanted()
        if watched == peer.watched:
            return
        self._unwatch(peer)
        fd, events = watched
        if fd is not None:
            self.loop.watch(fd, events, partial(self._take, peer, False))
            self._watches += peer.watched[0] is None
            peer.watched = watched

    def _unwatch(self, peer):
        fd, _ = peer.watched
        if fd is not None:
            self.loop.unwatch(fd)
            self._watches -= 1
        peer.watched = (None, 0)

    # ---- what comes ----

    def _take(self, peer, may_wait):
        connection = peer.connection
        if connection is None:  # lost a moment ago
            return
        try:
            if connection.waits_for:
                self._unwatch(peer)  # that socket may be closed, and the next one get its number
                self._go_on_connecting(peer)
            else:
                for data in connection.replies(may_wait):
                    self._reply(peer, data)
                if connection.end:
                    raise connection.end
                # nobody waits for this reply, and it may have no end
                if not connection.requests and connection.has_begun():
                    self._drop(peer)
                    return
                connection.flush()
            self._watch(peer)
        except (OSError, connections.Closed, ValueError, StructError) as e:
            self._lose(peer, e)

    def _reply(self, peer, data):
        """Take a whole reply. Raises Garbled, struct.error."""
        number, status, little, offset = messages.reply(data)
        if peer.connection.is_stray(number):
            return
        peer.heard = loop.now()
        self.session.has_answered(peer.endpoint, peer.heard)
        if number == next(iter(peer.connection.requests), None):
            peer.moved_on = peer.heard
        if peer.connection.ends_sparing(number):
            for tell in self.session.on_late:
                tell(peer.endpoint)
        request = peer.connection.answered(number)
        if not peer.connection.requests:
            self._asked.pop(peer, None)
        self._changed[peer] = True
        if request is None or not request.answered(status, data, offset, little):
            return
        failure = None
        if request.endpoint != peer.endpoint:  # it has been forwarded
            failure = self.session.why_not_asked(request.call.where, request.endpoint)
        if failure:
            request.unanswered(failure)
        else:
            self.submit(request)

    def _lose(self, peer, e):
        """A connection has failed, or was never made:
        what was asked by it is asked again, where that does no harm, or fails.
        """
        connection = self._drop(peer)
        lost = list(connection.requests.values())
        if connection.waits_for:
            lost += peer.take_all()
        is_cut = isinstance(e, (connections.Closed, ConnectionResetError, BrokenPipeError))
        not_started = connection.not_started() if getattr(e, "not_started", False) else ()
        if is_cut:
            # the others are no better, where the peer has been started again
            connections.forget(self.session.memory, peer.endpoint)
            if connection.has_answered and not not_started:
                self.session.memory.of_one_reply.add(peer.endpoint)
        is_older = connection.may_speak_older(e)
        for request in lost:
            if is_older and request.is_idempotent:
                peer.add(request)
            elif is_cut and connection.has_answered and self._may_repeat(request, request in not_started):
                peer.add(request)
            else:
                request.failed(connections.Closed() if is_cut else e)
        if connection.has_answered:
            for tell in self.session.on_end:
                tell(peer.endpoint)
        if not peer.waiting and not peer.waiting_for_others:  # a loop that runs for long meets many
            self.known.pop(peer.endpoint, None)

    def _drop(self, peer):
        connection = peer.connection
        peer.connection = None
        self._unwatch(peer)
        connection.close()
        self._asked.pop(peer, None)
        self._changed[peer] = True
        return connection

    @staticmethod
    def _may_repeat(request, is_not_started):
        """Whether a request whose connection was lost may be sent again;
        a change may not, unless the peer says that it has not begun.
        """
        if request.is_once:
            return False
        if is_not_started:
            return True
        request.retried += 1
        return request.is_idempotent and request.retried <= MOST_RETRIED

    # ---- what does not come ----

    def _begin_checking(self):
        if self._checking is None:
            self._checking = self.loop.call_later(self._tick, self._check)

    def _check(self):
        """Fail what has waited too long."""
        self._checking = None
        now = loop.now()
        for peer in list(self._asked):
            self._check_one(peer, now)
        if self._asked:
            self._begin_checking()

    def _check_one(self, peer, now):
        if self.session.is_over():
            for request in peer.connection.give_up_all():
                request.unanswered(errors.NoTime(str(request.call.where), session.NO_TIME))
        for request in peer.overdue(now):
            silence = session.no_answer(request.seconds)
            if not request.is_once:  # which may take longer than its caller waits
                self.session.fall_silent(peer.endpoint, silence, request.sent, request.asks_others)
            request.silent(silence)
        self._fail_rest(peer)
        if not peer.connection.requests:
            self._asked.pop(peer, None)
        self._changed[peer] = True

    def _fail_rest(self, peer):
        """End what is not to be asked now, by what has been found of the process."""
        now = self.session
        if not (now.silent or now.stalled or now.is_over()):
            return
        if now.silence(peer.endpoint):
            found_silent, why = now.silent[peer.endpoint]
            for request in peer.unanswered(found_silent, now.timeout):
                request.silent(why)
        for request in peer.take_all():
            failure = now.why_not_asked(request.call.where, peer.endpoint, request.asks_others)
            if failure:
                request.unanswered(failure)
            else:
                peer.add(request)

    def _restart_clocks(self, seconds):
        """We were away for so long: nobody was silent meanwhile. What was sent at the end of that waits from
        now on.
        """
        now = loop.now()
        for peer in self._asked:
            peer.heard = min(peer.heard + seconds, now)
            peer.moved_on = min(peer.moved_on + seconds, now)
            for request in peer.connection.requests.values():
                request.sent = min(request.sent + seconds, now)

    def _leave_all(self):
        """End the connections, or leave them for later calls."""
        for peer in self.known.values():
            if peer.connection is not None:
                peer.connection.leave()
