"""Many remote calls at once, and none that can hang the command.

The main thread never makes a CORBA call, so Ctrl-C always works. Calls are grouped by the process that answers them (its
endpoint): each gets a few lanes, and the first silence from it fails the rest of its calls, so that one hung robot process
costs one timeout however many components it holds. Every answer restarts the clock of its process: a big system on a slow
link may take longer than the timeout, a silent one may not.
"""
import collections
import queue
import threading
import time

from rtshell_lite import errors

LANES = 4  # calls in flight per process: kind to real-time processes, and below omniORB's 5 connections
GRACE = 0.2  # the ORB's own deadline comes first and knows more; ours is for what it does not bound (name look-ups)
TICK = 0.1

timeout = 3.0  # seconds a peer may stay silent; set once by cli from --timeout

Job = collections.namedtuple("Job", "endpoint where call")  # (host, port) or anything hashable; path text; function()


# When which process was found silent, and the words for it. For as long as the timeout it is not asked again: what comes
# next in a command, or another component's question about it, must not cost one more timeout.
silent = {}
_answered = {}  # when which process answered last


class _Peer:
    """One remote process while it is being asked."""

    def __init__(self, endpoint):
        self.endpoint = endpoint
        self.todo = collections.deque()
        self.open = set()
        self.heard = time.monotonic()
        self.limit = timeout
        since, why = silent.get(endpoint, (0, None))
        self.silence = why if time.monotonic() - since < timeout else None  # why the rest of its calls fail

    def fall_silent(self, why):
        """Fail the rest of its calls, unless it has answered others meanwhile: one object may hang while its process does not."""
        if time.monotonic() - _answered.get(self.endpoint, 0) < self.limit:
            return
        self.silence = why
        silent[self.endpoint] = time.monotonic(), why


_lane = threading.local()


def in_lane():
    """True on a thread that may make remote calls."""
    return hasattr(_lane, "peer")


def lane_of(endpoint):
    """True on a thread that makes the calls to the process at `endpoint`."""
    return in_lane() and _lane.peer.endpoint == endpoint


def become_lane(endpoint):
    """Make the current thread, not the main one, a lane of its own to the process at `endpoint`: for one that goes on asking."""
    _lane.peer = _Peer(endpoint)


def alive(limit=None):
    """Start the clock of the peer of this lane: its next answer may take `limit` seconds (default: the timeout)."""
    peer = getattr(_lane, "peer", None)
    if peer:
        peer.heard = time.monotonic()
        peer.limit = limit or timeout


def answered():
    """Say that the peer of this lane has answered a call."""
    alive()
    if in_lane():
        _answered[_lane.peer.endpoint] = time.monotonic()


def ask(endpoint, where, call):
    """Run one call and return its value or raise its error.

    From a lane of another process, silence is raised as Unreachable: it says nothing about the process of that lane.
    """
    value, = gather([Job(endpoint, where, call)])
    if isinstance(value, errors.Silent) and in_lane():
        raise errors.Unreachable(*value.args)
    if isinstance(value, Exception):
        raise value
    return value


def gather(jobs):
    """Run all `jobs` (iterable of Job) and return their values in order; a failed job's value is its errors.Error."""
    jobs = list(jobs)
    values, peers, done = [None] * len(jobs), {}, queue.Queue()
    for i, job in enumerate(jobs):
        peer = peers.get(job.endpoint) or peers.setdefault(job.endpoint, _Peer(job.endpoint))
        peer.todo.append((i, job))
        peer.open.add(i)
    for peer in peers.values():
        for _ in range(min(LANES, len(peer.todo))):
            threading.Thread(target=_work, args=(peer, done), daemon=True).start()
    waiting = len(jobs)
    while waiting:
        alive()  # for a gather inside a lane
        try:
            peer, i, value = done.get(timeout=TICK)
        except queue.Empty:
            waiting -= _give_up(peers.values(), jobs, values)
            continue
        if i in peer.open:  # not given up before
            peer.open.remove(i)
            values[i] = value
            waiting -= 1
    for value in values:
        if isinstance(value, Exception) and not isinstance(value, errors.Error):
            raise value  # a bug of ours, not a failure of the peer
    return values


def _work(peer, done):
    _lane.peer = peer
    while True:
        try:
            i, job = peer.todo.popleft()
        except IndexError:
            return
        if peer.silence:
            done.put((peer, i, errors.Silent(job.where, peer.silence)))
            continue
        alive()
        try:
            value = job.call()
        except errors.Silent as e:
            value = e
            peer.fall_silent(e.args[1])
        except Exception as e:
            value = e
        done.put((peer, i, value))


def _give_up(peers, jobs, values):
    """Fail the open jobs of peers that stayed silent too long; returns how many."""
    count, now = 0, time.monotonic()
    for peer in peers:
        if peer.open and now - peer.heard > peer.limit + GRACE:
            why = peer.silence or no_answer(peer.limit)
            peer.fall_silent(why)
            peer.todo.clear()
            for i in peer.open:
                values[i] = errors.Silent(jobs[i].where, why)
            count += len(peer.open)
            peer.open.clear()
    return count


def no_answer(seconds):
    """The reason given for silence."""
    return "no answer within %gs" % seconds
