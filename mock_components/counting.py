"""What a mock notes about the calls that it receives, and the faults it is to show."""
import collections

from . import carrier

FOR_EVER = 3600
# the minor codes with which omniORB itself raises these
MINORS = {
    "TRANSIENT": 0x41540002,
    "COMM_FAILURE": 0x41540007,
    "TIMEOUT": 0x41540008,
    "OBJECT_NOT_EXIST": 0x4F4D0001,
}


class Ledger:
    """Calls by owner and operation, calls in flight, and the faults still to come."""

    def __init__(self):
        self.lock = carrier.Condition()
        self.local = carrier.Local()
        self.calls = collections.Counter()      # (owner, operation) -> calls
        self.in_flight = 0
        self.highwater = 0
        self.faults = []                        # [operation, calls to go, kind]
        self.holds = {}                         # owner -> time until which its calls wait
        self.delays = {}                        # operation -> seconds that each call of it takes

    def own_thread(self):
        """Calls made by this thread come from the mock itself: they are not counted."""
        self.local.depth = 1

    def begin(self, owner, operation):
        """A call has arrived: count it. Returns a function that lets it hang or fail if that was asked for,
        else None.
        """
        depth = getattr(self.local, "depth", 0)
        self.local.depth = depth + 1
        if depth:
            return None
        with self.lock:
            self.calls[owner, operation] += 1
            self.in_flight += 1
            self.highwater = max(self.highwater, self.in_flight)
            kind = self._fault(operation)
            delay = self.delays.get(operation, 0)
            if not (kind or delay or owner in self.holds):
                return None

        def suffer():
            carrier.sleep(delay)
            self._hold(owner)
            if kind == "LOST":
                self.local.lost = True
            elif kind:
                self._fail(kind)
        return suffer

    def end(self):
        self.local.depth -= 1
        if not self.local.depth:
            with self.lock:
                self.in_flight -= 1
            if getattr(self.local, "lost", False):
                self.local.lost = False
                carrier.sleep(FOR_EVER)

    def fail(self, operation, nth=1, kind="TRANSIENT"):
        """Let the nth next call of the operation end badly. Raises AttributeError for an unknown kind."""
        if kind not in ("HANG", "DIE", "LOST"):
            carrier.failure(kind)
        with self.lock:
            self.faults.append([operation, nth, kind])

    def hang(self, owner, seconds):
        """Let all calls of one component wait; 0 lets them go."""
        with self.lock:
            self.holds[owner] = carrier.now() + seconds
            self.lock.notify_all()

    def delay(self, operation, seconds):
        """Let every call of an operation take that long."""
        with self.lock:
            self.delays[operation] = seconds

    def reset(self):
        with self.lock:
            self.calls.clear()
            self.faults = []
            self.holds.clear()
            self.delays.clear()
            self.highwater = self.in_flight
            self.lock.notify_all()

    def report(self, owner=None):
        """Sorted `count operation` lines, of one component or of all."""
        totals = collections.Counter()
        with self.lock:
            for (who, operation), count in self.calls.items():
                if owner is None or who == owner:
                    totals[operation] += count
        return ["%d %s" % (totals[operation], operation) for operation in sorted(totals)]

    def _fault(self, operation):
        for fault in self.faults:
            if fault[0] == operation:
                fault[1] -= 1
        due = [fault for fault in self.faults if fault[1] <= 0]
        self.faults = [fault for fault in self.faults if fault[1] > 0]
        return due[0][2] if due else None

    def _hold(self, owner):
        with self.lock:
            self.lock.wait_for(lambda: carrier.now() >= self.holds.get(owner, 0),
                               max(0, self.holds.get(owner, 0) - carrier.now()))

    def _fail(self, kind):
        if kind == "HANG":
            carrier.sleep(FOR_EVER)
        if kind == "DIE":
            carrier.die()
        raise carrier.failure(kind, MINORS.get(kind, 0))
