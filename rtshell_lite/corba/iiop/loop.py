"""Many calls at once on one thread: tasks that await orb.Call, and one connection for each process that they ask.

At most lanes.LANES requests are on their way to a process, any number to a name server.
"""
import collections
import select
import time
from struct import error as StructError

from rtshell_lite import errors
from rtshell_lite.corba import lanes, tasks
from rtshell_lite.corba.iiop import calls, connections
from rtshell_lite.giop import messages

LOOK = 0.005  # seconds between looks at whether the address of a host has been found
AWAY = 3  # ticks between two looks for what has waited too long; after more of them we, not others, were away: stopped, say
MOST = 64  # jobs of one process under way at a time, most of which wait for their turn
MOST_AGAIN = 2  # times that a question is asked again as a connection was lost by which others were answered
NAMING = "IDL:omg.org/CosNaming/"  # interfaces of name servers begin so


def in_turn(jobs):
    """lanes.in_turn for jobs whose `call` makes a coroutine."""
    loop = _Loop()
    try:
        loop.add(jobs)
        for i in range(len(jobs)):
            while loop.values[i] is _TO_COME:
                loop.step()
            value, loop.values[i] = loop.values[i], None
            yield lanes.value_of(value)
    finally:
        loop.close()


def invoke(call):
    """The result of an orb.Call, made on this thread; raises what the Call raises."""
    loop = _Loop()
    result = []
    request = calls.Request(call, lambda *outcome: result.append(outcome))
    endpoint = request.endpoint
    try:
        loop.submit(request)
        while not result:
            loop.step()
    finally:
        loop.close()
    (value, error), = result
    if error is not None:
        raise loop.judged(error, request, endpoint)
    return value


_TO_COME = object()  # in place of a value


class _Peer(lanes.Peer):
    """One process: what is asked of it, and the connection with it."""

    def __init__(self, endpoint):
        super().__init__(endpoint)
        self.running, self.watched = 0, (None, 0)  # jobs; what the poll looks for
        self.waiting = collections.deque()  # calls.Requests that are not on their way
        self.connection = None
        self.moved_on = 0.0  # when the request that had waited for longest was answered

    def may_send(self):
        """Whether the first that waits may be sent now.

        At each answer, not two at every second one: a peer without TCP_NODELAY sends the second when the first is acknowledged, by the
        next request or 40 ms later.
        """
        if self.endpoint in connections.of_one_reply:
            return not self.connection.requests
        return len(self.connection.requests) < lanes.LANES or _is_naming(self.waiting[0])

    def needs_connection(self):
        """Whether the first that waits must not be lost again with a connection that the peer may close after its reply."""
        if self.connection is None or self.endpoint not in connections.of_one_reply:
            return False
        request = self.waiting[0]
        return self.connection.has_answered and not self.connection.requests and (not request.asks or request.again > 1)

    def overdue(self, now):
        """Give up the requests that have waited too long, and return them.

        A name server gets many at once, so each of its answers restarts the clock of all. Another process may do
        one request after the other: the clock of the next one starts when the one before is answered.
        """
        late = []
        for number, request in self.connection.requests.items():
            begun = self.heard if _is_naming(request) else self.moved_on
            if now - max(request.sent, begun) > request.seconds:
                late.append(number)
        return [self.connection.give_up(number) for number in late]

    def unanswered(self):
        """Give up the questions that were on their way when it was found silent, and return them: they would cost one more timeout.

        A request that changes something keeps its time, and so does one that may take longer than others.
        """
        since, _ = lanes.session.silent.get(self.endpoint, (0, None))
        vain = [number for number, request in self.connection.requests.items()
                if request.sent < since and request.asks and request.seconds <= lanes.session.timeout]
        return [self.connection.give_up(number) for number in vain]


def _is_naming(request):
    return request.ref.interface.startswith(NAMING)


class _Task:
    """A job that has begun."""

    def __init__(self, loop, peer, number, coroutine):
        self.loop, self.peer, self.number, self.coroutine = loop, peer, number, coroutine
        self.begun, self.request = time.monotonic(), None  # the latter is its last call

    def go_on(self, value=None, error=None):
        """Run it up to its next call, or its end."""
        while True:
            try:
                awaited = self.coroutine.send(value) if error is None else self.coroutine.throw(error)
            except StopIteration as end:
                return self._end(end.value)
            except Exception as e:
                self._judge(e)
                return self._end(lanes.alone(e))
            if isinstance(awaited, tasks.Sleep):
                return self.loop.wake(self, awaited.seconds)
            if lanes.is_over():
                value, error = None, errors.Silent(str(awaited.where), lanes.NO_TIME)
                continue
            self.request = calls.Request(awaited, self._answered)
            silence = self.loop.silence(self.request, self.peer.endpoint)
            if not silence:
                return self.loop.submit(self.request)
            value, error = None, errors.Unreachable(str(awaited.where), silence)

    def _answered(self, value, error):
        self.go_on(value, self.loop.judged(error, self.request, self.peer.endpoint))

    def _judge(self, e):
        """Note that its process is silent: so it is found by what was sent to it, not by what waits for its turn."""
        since = self.request.sent if self.request else self.begun
        if isinstance(e, errors.Silent) and e.why != lanes.NO_TIME and since:
            self.peer.fall_silent(e.why, since)

    def _end(self, value):
        self.loop.values[self.number] = value
        self.peer.running -= 1
        self.loop.have_changed.add(self.peer)


class _Loop:
    """What is under way on this thread.

    values        of the jobs, _TO_COME for those that have not ended
    have_changed  peers that may have jobs to begin, or requests to send
    """

    def __init__(self):
        self.values, self.peers, self.have_changed = [], {}, set()
        self._jobs, self._sleeping = [], {}  # the latter: when each task goes on
        self._asked = set()  # peers with requests under way
        self._poll, self._watched = None, {}  # {file descriptor: peer}
        self._checked, self._was_away = time.monotonic(), False
        self._tick = min(lanes.TICK, lanes.session.timeout / 10)

    def peer(self, endpoint):
        """The _Peer of a process."""
        return self.peers.get(endpoint) or self.peers.setdefault(endpoint, _Peer(endpoint))

    def add(self, jobs):
        """Note jobs to be done."""
        self._jobs, self.values = jobs, [_TO_COME] * len(jobs)
        for number, job in enumerate(jobs):
            self.peer(job.endpoint).todo.append(number)
        self.have_changed.update(self.peers.values())

    def submit(self, request):
        """Have a request sent."""
        request.sent = None
        peer = self.peer(request.endpoint)
        peer.waiting.append(request)
        self.have_changed.add(peer)

    def silence(self, request, endpoint):
        """Why the process that a request goes to is not to be asked, or None; never that of `endpoint`, whose jobs have begun."""
        return None if request.endpoint == endpoint else self.peer(request.endpoint).silence

    def judged(self, error, request, endpoint):
        """The error of a request, for who asks the process at `endpoint`: the silence of another one says nothing about it."""
        if not isinstance(error, errors.Silent) or request.endpoint == endpoint:
            return error
        if error.why != lanes.NO_TIME and request.sent:
            self.peer(request.endpoint).fall_silent(error.why, request.sent)
        return errors.Unreachable(*error.args)

    def wake(self, task, seconds):
        """Let a task go on in so many seconds."""
        self._sleeping[task] = time.monotonic() + seconds

    def close(self):
        """End the connections, or leave them for later calls."""
        for peer in self.peers.values():
            if peer.connection is not None:
                peer.connection.leave()

    # ---- one round ----

    def step(self):
        """Begin and send what can be, then take what has come; waits for a moment where nothing has."""
        while self.have_changed:
            peer = self.have_changed.pop()
            self._begin(peer)
            self._send(peer)
        ready, looked = self._ready(), time.monotonic()
        for peer, may_wait in ready:
            self._take(peer, may_wait)
        now = time.monotonic()
        for task in [task for task, when in self._sleeping.items() if when <= now]:
            del self._sleeping[task]
            task.go_on()
        since = looked - self._checked
        if since >= self._tick:
            self._checked, self._was_away = looked, since > AWAY * self._tick and not self._was_away
            if not self._was_away:
                self._give_up(looked)
        lanes.still_waiting()

    def _begin(self, peer):
        """Begin jobs of a process, up to their first calls."""
        while peer.todo and peer.running < MOST:
            number = peer.todo.popleft()
            job = self._jobs[number]
            if peer.silence or lanes.is_over():
                self.values[number] = errors.Silent(str(job.where), peer.silence or lanes.NO_TIME)
                continue
            peer.running += 1
            _Task(self, peer, number, job.call()).go_on()

    def _send(self, peer):
        """Send requests to a process, as many as it may get."""
        try:
            while peer.waiting:
                if peer.needs_connection():
                    self._unwatch(peer)
                    peer.connection.close()
                    peer.connection = None
                if peer.connection is None:
                    self._connect(peer)
                if not peer.may_send():
                    break
                self._asked.add(peer)
                peer.connection.send(peer.waiting.popleft())
            if peer.connection is not None:
                peer.connection.flush()
                self._watch(peer)
        except OSError as e:
            self._lost(peer, e)

    def _connect(self, peer):
        peer.connection = connections.kept(peer.endpoint)
        if peer.connection is None:
            peer.connection = connections.Connection(peer.endpoint, peer.waiting[0].others)
            peer.connection.go_on()

    def _ready(self):
        """(peer, whether its connection may wait) for each where something may have come."""
        if len(self._asked) == 1 and not self._sleeping and self._tick == lanes.TICK:
            peer, = self._asked
            if peer.connection.is_quiet:
                return [(peer, True)]  # without asking the kernel twice
        if not self._asked and not self._sleeping:
            return []
        if self._poll is None:
            self._poll = select.poll()
            for peer in self._asked:
                self._watch(peer)
        seconds = self._tick
        looking_up = [peer for peer in self._asked if peer.connection.waits_for == "address"]
        if looking_up:
            seconds = LOOK
        if self._sleeping:
            seconds = max(0, min(seconds, min(self._sleeping.values()) - time.monotonic()))
        ready = [self._watched[fd] for fd, _ in self._poll.poll(seconds * 1000)]
        return [(peer, False) for peer in ready + looking_up]

    def _watch(self, peer):
        """Have the poll tell when the connection of a peer can go on."""
        fd, events = peer.connection.wanted()
        if self._poll is None or (fd, events) == peer.watched:
            return
        self._unwatch(peer)
        if fd is not None:
            self._poll.register(fd, events)
            self._watched[fd], peer.watched = peer, (fd, events)

    def _unwatch(self, peer):
        fd, _ = peer.watched
        if fd is not None and self._watched.pop(fd, None) is not None:
            self._poll.unregister(fd)
        peer.watched = (None, 0)

    # ---- what comes ----

    def _take(self, peer, may_wait):
        connection = peer.connection
        if connection is None:  # lost a moment ago
            return
        try:
            if connection.waits_for:
                connection.go_on()
            else:
                for data in connection.replies(may_wait):
                    self._reply(peer, data)
                if connection.end:
                    raise connection.end
                connection.flush()
            self._watch(peer)
        except (OSError, connections.Closed, ValueError, StructError) as e:
            self._lost(peer, e)

    def _reply(self, peer, data):
        """Take a whole reply. Raises Garbled, struct.error."""
        number, status, little, at = messages.reply(data)
        if peer.connection.is_stray(number):
            return
        if number == next(iter(peer.connection.requests), None):
            peer.moved_on = time.monotonic()
        request = peer.connection.answered(number)
        if not peer.connection.requests:
            self._asked.discard(peer)
        peer.has_answered()
        self.have_changed.add(peer)
        if request is None or not request.answered(status, data, at, little):
            return
        silence = self.silence(request, peer.endpoint)
        if silence:  # of who it has been forwarded to
            request.resume(None, errors.Silent(str(request.call.where), silence))
        else:
            self.submit(request)

    def _lost(self, peer, e):
        """A connection has failed, or was never made: what was asked by it is asked again, where that does no harm, or fails."""
        connection, peer.connection = peer.connection, None
        self._unwatch(peer)
        connection.close()
        self._asked.discard(peer)
        self.have_changed.add(peer)
        lost = list(connection.requests.values())
        if connection.waits_for:
            lost += peer.waiting
            peer.waiting.clear()
        is_cut = isinstance(e, (connections.Closed, ConnectionResetError, BrokenPipeError))
        untouched = connection.untouched() if getattr(e, "untouched", False) else ()
        if is_cut:
            connections.forget(peer.endpoint)  # the others are no better, where the peer has been started again
            if connection.has_answered and not untouched:
                connections.of_one_reply.add(peer.endpoint)
        is_older = connection.may_speak_older(e)
        for request in lost:
            is_untouched = request in untouched
            if is_older and request.asks:
                peer.waiting.append(request)
            elif is_cut and connection.has_answered and (is_untouched or request.asks and request.again < MOST_AGAIN):
                request.again += not is_untouched
                peer.waiting.append(request)
            else:
                request.failed(connections.Closed() if is_cut else e)

    # ---- what does not come ----

    def _give_up(self, now):
        """Fail what has waited too long."""
        for peer in list(self._asked):
            if lanes.is_over():
                failed, why = peer.connection.give_up_all(), lanes.NO_TIME
            else:
                failed, why = peer.overdue(now), None
            for request in failed:
                request.resume(None, errors.Silent(str(request.call.where), why or lanes.no_answer(request.seconds)))
            if peer.silence or lanes.is_over():  # as those may have shown
                failed, peer.waiting = peer.unanswered() + list(peer.waiting), collections.deque()
                for request in failed:
                    request.resume(None, errors.Silent(str(request.call.where), peer.silence or lanes.NO_TIME))
            if not peer.connection.requests:
                self._asked.discard(peer)
            self.have_changed.add(peer)
