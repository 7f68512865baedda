"""Remote questions on behalf of many requests: shared by those who wait for the same answer, on a bounded number of threads."""
import collections
import re
import threading
import time

from rtshell_lite import errors
from rtshell_lite.corba import lanes

MOST = 256  # threads that ask, at most
IDLE = 5.0  # seconds that a thread waits for more to do
NOTHING = object()  # in place of a key; None is the key of what has no address
NUMERIC = re.compile(r"[0-9.]+\Z|.*:")  # an address; to look a name up may take longer than any deadline of the ORB


class Crew:
    """Threads that run jobs, functions without arguments; at most `most` at a time with the same key, in their order.

    report(exception) is called when a job fails, which is a bug of ours.
    """

    def __init__(self, report):
        self._report = report
        self._changed = threading.Condition(threading.Lock())
        self._waiting = {}  # by key: a deque of jobs
        self._running = collections.Counter()  # by key; what is `_ready` is counted
        self._ready = collections.deque()  # keys of which a job can be run
        self._threads = self._idle = 0

    def start(self, key, job, most=lanes.LANES):
        """Run job() as soon as its turn has come."""
        with self._changed:
            self._waiting.setdefault(key, collections.deque()).append(job)
            if self._running[key] >= most:
                return
            self._running[key] += 1
            self._ready.append(key)
            if self._idle >= len(self._ready):
                self._changed.notify()
                return
            if self._threads >= MOST:
                return
            self._threads += 1
        try:
            lanes.start(self._work)
        except errors.Shortage:
            with self._changed:
                self._threads -= 1
                if not self._threads:  # nobody will ever do it
                    raise

    def _work(self):
        key = self._next(NOTHING)
        while key is not NOTHING:
            with self._changed:
                job = self._waiting[key].popleft() if self._waiting[key] else None  # another thread has done it
            try:
                if job is not None:
                    job()
            except Exception as e:  # the thread has more to do
                self._report(e)
            key = self._next(key)

    def _next(self, done):
        """The key of the job to run after one with the key `done`; NOTHING if the thread is needed no longer."""
        with self._changed:
            if done is not NOTHING and self._waiting[done]:
                self._ready.append(done)
            elif done is not NOTHING:
                self._running[done] -= 1
                if not self._running[done]:
                    del self._running[done], self._waiting[done]
            self._idle += 1
            has_work = self._changed.wait_for(lambda: self._ready, IDLE)
            self._idle -= 1
            if has_work:
                return self._ready.popleft()
            self._threads -= 1
            return NOTHING


class Kept:
    """The Sources with a value, which is to be freed when it is believed no longer.

    changes   how often something has been changed: nothing is believed that was asked before the last time
    """

    def __init__(self):
        self._lock, self._sources, self.changes = threading.Lock(), [], 0

    def expire(self):
        """Something has been changed."""
        with self._lock:
            self.changes += 1

    def add(self, source):
        """Note that a Source has a value."""
        with self._lock:
            self._sources.append(source)

    def sweep(self):
        """Free the values that are believed no longer."""
        with self._lock:
            sources, self._sources = self._sources, []
        sources = [source for source in sources if source.drop()]
        with self._lock:
            self._sources += sources


def _asked(endpoint, where, ask):
    """ask() or its errors.Error, on this thread, which becomes a lane of the peer."""
    if endpoint and not NUMERIC.match(endpoint[0]):
        answer, = lanes.gather([lanes.Job(endpoint, where, ask)])
        return answer
    lanes.become_lane(endpoint)
    peer, begun = lanes.Peer(endpoint), time.monotonic()
    if peer.silence:
        return errors.Silent(str(where), peer.silence)
    try:
        return ask()
    except errors.Error as e:
        if isinstance(e, errors.Silent):
            peer.fall_silent(e.why, begun)
        return lanes.alone(e)


class Source:
    """The answer to a remote question, believed for some `seconds`; 0: each request wants one that was asked for after it came.

    `place()` gives (endpoint, where) of the peer, `ask()` the value, on a lane of the peer.
    """

    __slots__ = ("_crew", "_kept", "place", "ask", "seconds", "value", "_until", "_changes", "_asked", "_coming", "_flight", "_lock")

    def __init__(self, crew, kept, place, ask, seconds):
        self._crew, self._kept, self.place, self.ask, self.seconds = crew, kept, place, ask, seconds
        self.value, self._until, self._lock = None, 0.0, threading.Lock()
        self._changes = self._asked = 0  # `Kept.changes` when the value was asked for; when the question in flight was asked
        self._coming = self._flight = None  # those who wait for a question that has not been asked yet; that has been

    def is_fresh(self):
        """Whether `value` can be believed."""
        return self._until > time.monotonic() and self._changes == self._kept.changes

    def now(self):
        """The value if it can be believed, else None."""
        value = self.value  # first: it is freed as soon as it is not believed
        return value if self.is_fresh() else None

    def expire(self):
        """Believe nothing that was asked before now."""
        with self._lock:
            self._until, self._flight = 0.0, None

    def drop(self):
        """Free a value that is believed no longer. Returns whether there is one that is."""
        with self._lock:
            if not self.is_fresh():
                self.value = None
            return self.value is not None

    def want(self, waiter):
        """Have waiter(value) called, or waiter(error), when it has been answered; on a thread that asks."""
        with self._lock:
            if self.seconds and self._flight is not None and self._asked == self._kept.changes:
                self._flight.append(waiter)
                return
            if self._coming is not None:
                self._coming.append(waiter)
                return
            self._coming = [waiter]
        self._crew.start(self.place()[0], self._run)

    def _run(self):
        with self._lock:
            waiters, self._coming = self._coming, None
            self._flight, changes = waiters, self._kept.changes
            self._asked = changes
        answer = self._answer()
        with self._lock:
            if self._flight is waiters:  # nothing has changed since it was asked
                self._flight = None
                self._keep(answer, changes)
        for waiter in waiters:
            waiter(answer)

    def _answer(self):
        value = self.now()
        if value is not None:
            return value
        try:
            endpoint, where = self.place()
            return _asked(endpoint, where, self.ask)
        except Exception as e:  # a bug of ours must not leave anybody waiting
            return e

    def _keep(self, answer, changes):
        if self.seconds and changes == self._kept.changes and answer is not None and not isinstance(answer, Exception):
            if self.value is None:
                self._kept.add(self)
            self.value, self._until, self._changes = answer, time.monotonic() + self.seconds, changes

    def get(self):
        """The value, asked for on this thread if need be. Raises what `ask` raises."""
        value = self.now()
        if value is not None:
            return value
        changes = self._kept.changes
        value = self.ask()
        with self._lock:
            self._keep(value, changes)
        return value


class Given(Source):
    """A value that needs no asking."""

    __slots__ = ()

    def __init__(self, value):
        super().__init__(None, None, None, None, 0)
        self.value = value

    def is_fresh(self):
        return True

    def get(self):
        return self.value
