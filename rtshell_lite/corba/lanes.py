"""Many remote calls at once, none of which can hang the command.

Calls are grouped by the process that answers them (its endpoint): each gets a few lanes, and the first silence from it fails the
rest of its calls, so that one hung robot process costs one timeout however many components it holds. Every answer restarts the
clock of its process: a big system on a slow link may take longer than the timeout in all, but no single answer may.

With omniORB a lane is a thread, and the main thread never makes a CORBA call, so Ctrl-C always works. An ORB whose calls can be
interrupted sets `loop`: what asks one process stays on its thread, and tasks (see tasks.py) share one.
"""
import collections
import errno
import functools
import operator
import os
import time
from _thread import _local as Local, allocate_lock  # which `threading` is made of: it takes long to import, and most need no thread

from rtshell_lite import errors, interrupts
from rtshell_lite.corba import tasks

LANES = 4  # calls in flight per process: real-time threads keep their period, and omniORB has 5 connections
GRACE = 0.2  # s after the ORB's own deadline, which knows more; ours is for what it does not bound (name look-ups)
TICK = 0.1

NO_TIME = "there was no time left to ask it"


class Job:
    """A remote call to make: `endpoint` of the process that answers, (host, port) or anything hashable; `where`, the path of the
    object, or a text, for errors; `call`, a function without arguments.
    """

    __slots__ = ("endpoint", "where", "call")

    def __init__(self, endpoint, where, call):
        self.endpoint, self.where, self.call = endpoint, where, call


loop = None  # function(jobs), `in_turn` on one thread where Job.call makes a coroutine; None with an ORB that needs threads

_answered = {}  # {endpoint: when it last answered}
name_servers = set()  # endpoints of name servers, which firewalls often let through


class Peer:
    """One remote process while it is being asked."""

    def __init__(self, endpoint):
        self.endpoint = endpoint
        self.todo = collections.deque()  # numbers of the jobs that no lane has begun
        self.open = {}  # jobs without a value yet, by number
        self.heard = time.monotonic()
        self.limit = session.timeout
        since, why = session.silent.get(endpoint, (0, None))
        self.silence = why if time.monotonic() - since < session.timeout else None  # why the rest of its calls fail

    def has_answered(self):
        """Restart its clock."""
        self.heard = _answered[self.endpoint] = time.monotonic()

    def fall_silent(self, why, since):
        """Fail the rest of its calls, unless it has answered others `since`: one object may hang though its process does not."""
        if _answered.get(self.endpoint, 0) > since:
            return
        self.silence = why
        session.silent[self.endpoint] = time.monotonic(), why


_lane = Local()


class Slots:
    """At most `most` remote calls in flight to all processes together; None for as many as there are lanes.

    Each call is made inside `with session.slots:`. Waiting there does not count as silence of the peer.
    """

    def __init__(self, most=None):
        self._free = _semaphore(most) if most else None

    @property
    def are_unlimited(self):
        """True if calls need not wait for one another."""
        return self._free is None

    def __enter__(self):
        while self._free and not self._free.acquire(timeout=TICK):
            alive()

    def __exit__(self, *_):
        if self._free:
            self._free.release()


def _semaphore(most):
    import threading
    return threading.Semaphore(most)


class Session:
    """How one command asks, and what it has learnt of the processes that it asked.

    timeout   seconds that a peer may stay silent, from --timeout
    end       time.monotonic() after which no call is begun, or None: set by a command that promises to end in time
    slots     the Slots that its calls take
    shortage  the errors.Shortage that made a connection fail on this host, or None: the peer is not to blame
    silent    {endpoint: (when it was found silent, the words for it)}: it is not asked again for the length of a timeout, so that
              the next step of a command, or a question about another component, does not cost one more
    """

    def __init__(self, timeout=3.0):
        self.timeout, self.end, self.slots = timeout, None, Slots()
        self.shortage, self.silent, self.turned_away = None, {}, 0


session = Session()  # of the command that runs: rtsh runs several, see cli.command


def in_lane():
    """True on a thread that may make remote calls."""
    return hasattr(_lane, "peer")


def become_lane(endpoint):
    """Make the current thread, not the main one, a lane to the process at `endpoint`: for threads that keep asking."""
    _lane.peer = Peer(endpoint)


def alive(limit=None):
    """Start the clock of the peer of this lane: its next answer may take `limit` seconds (default: the timeout)."""
    peer = getattr(_lane, "peer", None)
    if peer:
        peer.heard = _lane.since = time.monotonic()
        peer.limit = limit or session.timeout


def still_waiting():
    """Keep others from giving up the peer of this lane: what is under way on this thread has deadlines of its own."""
    peer = getattr(_lane, "peer", None)
    if peer:
        peer.heard = time.monotonic()


def answered():
    """Note that the peer of this lane has answered a call."""
    peer = getattr(_lane, "peer", None)
    if peer:
        peer.has_answered()
        peer.limit = session.timeout


def has_answered():
    """True if the peer of this lane has ever answered a call."""
    return in_lane() and _lane.peer.endpoint in _answered


def last_answers():
    """{endpoint: when it last answered a call}, by time.monotonic()."""
    return _answered


def note_shortage(e, host):
    """Note an OSError of a connection to `host` that means that this host, not the other, lacks something."""
    what = _SCARCE.get(e.errno)
    if what and not (what == "ports" and ":" in host):  # a host without IPv6 has no address for it, either
        session.shortage = errors.Shortage(what, os.strerror(e.errno))


_SCARCE = {errno.EMFILE: "files", errno.ENFILE: "files", errno.EADDRNOTAVAIL: "ports", errno.ENOBUFS: "memory",
           errno.ENOMEM: "memory"}


def ask(endpoint, where, call):
    """Run call() in a lane of the process at `endpoint`, which may be this thread, and return its value or raise its error.

    From a lane of another process, silence is raised as Unreachable: it says nothing about the process of that lane.
    """
    if in_lane() and _lane.peer.endpoint == endpoint:
        return call()
    return _raised(*gather([Job(endpoint, where, call)]))


def aside(key, where, call):
    """`ask` for what cannot be interrupted and is no remote call, such as the look-up of a name: always on a thread of its own."""
    return _raised(*gather([Job(key, where, call)], apart=True))


def _raised(value):
    """The value of a job; an exception is raised."""
    if isinstance(value, errors.Silent) and in_lane():
        raise errors.Unreachable(*value.args)
    if isinstance(value, Exception):
        raise value
    return value


def each(items, function, place=operator.attrgetter("endpoint", "where"), apart=False):
    """Call function(item), which may be a task, for each item, in parallel: the values in order, an errors.Error for what failed.

    `place(item)` gives (endpoint, where), see Job. `apart`: never on this thread, so that what has begun goes on after Ctrl-C.
    """
    if apart:
        places = zip(items, map(place, items))
        return gather([Job(endpoint, where, functools.partial(function, item)) for item, (endpoint, where) in places], apart)
    return list(each_in_turn(items, function, place))


def each_in_turn(items, function, place):
    """`each`, but yields the values as `in_turn` does."""
    places = [place(item) for item in items]  # which may start the ORB
    task = tasks.of(function) if loop and session.slots.are_unlimited else None
    jobs = [Job(endpoint, where, functools.partial(task or function, item)) for item, (endpoint, where) in zip(items, places)]
    return loop(jobs) if task else in_turn(jobs)


def gather(jobs, apart=False):
    """Run all `jobs` (iterable of Job) and return their values in order; a failed job's value is its errors.Error."""
    return list((_in_lanes if apart else in_turn)(list(jobs)))


def in_turn(jobs):
    """`gather`, but yields each value as soon as those before it have come, and keeps none: thousands take much memory.

    The jobs go on meanwhile, so the caller must not make remote calls before the last value.
    """
    can_stay = loop and len(jobs) == 1 and getattr(_lane, "is_unwatched", True)  # a lane is watched by who waits for it
    return _here(jobs[0]) if can_stay else _in_lanes(jobs)


def _here(job):
    """`in_turn` for one job, on this thread."""
    before, _lane.peer = getattr(_lane, "peer", None), Peer(job.endpoint)
    try:
        value = _value(_lane.peer, job)
    finally:
        if before:
            _lane.peer = before
        else:
            del _lane.peer
    yield value_of(value)


def _in_lanes(jobs):
    values, peers = [_TO_COME] * len(jobs), {}
    for i, job in enumerate(jobs):
        peer = peers.get(job.endpoint) or peers.setdefault(job.endpoint, Peer(job.endpoint))
        peer.todo.append(i)
        peer.open[i] = job
    results = _Results(len(values))
    try:
        for peer in peers.values():
            for _ in range(min(LANES, len(peer.todo))):
                start(_work, peer, values, results)
        for i in range(len(values)):
            while True:  # see interrupts
                if values[i] is not _TO_COME:
                    break
                if not results.complete.wait(TICK):
                    alive()  # for a gather inside a lane
                    _give_up(peers.values(), values, results)
            value, values[i] = values[i], None
            yield value_of(value)
    finally:
        for peer in peers.values():  # after Ctrl-C nothing more is begun
            peer.todo.clear()


def value_of(value):
    """The value of a job, also where it is an errors.Error; another exception is a bug of ours, and raised."""
    if isinstance(value, Exception) and not isinstance(value, errors.Error):
        raise value
    return value


def start(function, *args):
    """Run function(*args) on a thread of its own. Raises Shortage."""
    import threading
    with interrupts.held():
        try:
            threading.Thread(target=function, args=args, daemon=True).start()
        except RuntimeError as e:
            raise errors.Shortage("threads", str(e))


_TO_COME = object()  # in place of a value


class _Results:
    """How many values are still to come.

    The waiting thread is woken once, after the last: waking it for each of 1,000 values cost as much as the calls.
    """

    def __init__(self, count):
        self.lock, self.left, self.complete = allocate_lock(), count, interrupts.Bell()
        self.came(0)

    def came(self, count):
        """Note that so many values have come; the lock is held."""
        self.left -= count
        if not self.left:
            self.complete.ring()


def _work(peer, values, results):
    _lane.peer, _lane.is_unwatched = peer, False
    while True:
        try:
            i = peer.todo.popleft()
            job = peer.open[i]
        except LookupError:
            return
        value = _value(peer, job)
        with results.lock:
            if peer.open.pop(i, None):  # not given up before
                values[i] = value
                results.came(1)


def _value(peer, job):
    """The value of a job, or the exception that it raises."""
    if peer.silence or is_over():
        return errors.Silent(str(job.where), peer.silence or NO_TIME)
    alive()
    try:
        return job.call()
    except errors.Silent as e:
        peer.fall_silent(e.why, _lane.since)
        return alone(e)
    except Exception as e:
        return alone(e)


def alone(e):
    """A failure without its traceback: the frames of 20,000 failures took 140 MB. A bug of ours keeps its own."""
    if isinstance(e, errors.Error):
        e.__traceback__ = e.__context__ = None
    return e


def _give_up(peers, values, results):
    """Fail the open jobs of peers that have been silent too long."""
    now = time.monotonic()
    for peer in peers:
        silent_too_long = now - peer.heard > peer.limit + GRACE
        if peer.open and (silent_too_long or is_over()):
            why = peer.silence or (no_answer(peer.limit) if silent_too_long else NO_TIME)
            if silent_too_long:
                peer.fall_silent(why, peer.heard)
            peer.todo.clear()
            with results.lock:
                for i, job in peer.open.items():
                    values[i] = errors.Silent(str(job.where), why)
                results.came(len(peer.open))
                peer.open.clear()


def is_over():
    """True when the session's `end` has passed."""
    return session.end is not None and time.monotonic() > session.end


def no_answer(seconds):
    """The reason given for silence."""
    return f"no answer within {seconds:g}s"
