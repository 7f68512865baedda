"""Functions that make remote calls, started one by one while others run: for commands whose next step depends on what has come."""
import collections
from _thread import allocate_lock

from rtshell_lite import interrupts
from rtshell_lite.corba import lanes


class Calls:
    """Functions that make remote calls, started one by one while others run; at most lanes.LANES at a time for one process.

    Each runs on a thread of its own, where `ask` and `gather` may be used. `ended` gives what it returned or raised.
    """

    def __init__(self):
        self._events = interrupts.Mailbox()
        self._lock = allocate_lock()
        self._waiting = {}  # by endpoint
        self._threads = collections.Counter()  # by endpoint
        self._begun = set()
        self._closed = False

    def start(self, endpoint, key, function):
        """Call function() as soon as there is a lane to the process at `endpoint`; `ended` gives its result with `key`."""
        with self._lock:
            self._waiting.setdefault(endpoint, collections.deque()).append((key, function))
            if self._threads[endpoint] == lanes.LANES:
                return
            self._threads[endpoint] += 1
        lanes.start(self._run, endpoint)

    def _run(self, endpoint):
        while True:
            with self._lock:
                if self._closed or not self._waiting[endpoint]:
                    self._threads[endpoint] -= 1
                    return
                key, function = self._waiting[endpoint].popleft()
                self._begun.add(key)
            try:
                value = function()
            except Exception as e:
                value = e
            self.post(key, value)

    def post(self, key, value):
        """Make `ended` return (key, value): a function may do so to report its progress."""
        self._events.put((key, value))

    def ended(self, seconds):
        """The next (key, value), where value is an errors.Error if the function failed; None after so many seconds."""
        found = self._events.get(seconds)
        if found is None:
            return None
        key, value = found
        return key, lanes.value_of(value)

    def close(self):
        """Start no more functions; returns the keys of those that were begun."""
        with self._lock:
            self._closed = True
            return set(self._begun)
