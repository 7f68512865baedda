"""What a mock notes about the calls that it receives, and the faults it is to show."""
import collections
import os
import threading
import time

from omniORB import CORBA

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
        self.lock = threading.Condition()
        self.local = threading.local()
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
            time.sleep(delay)
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
                time.sleep(FOR_EVER)

    def fail(self, operation, nth=1, kind="TRANSIENT"):
        """Let the nth next call of the operation end badly."""
        if kind not in ("HANG", "DIE", "LOST") and not hasattr(CORBA, kind):
            raise ValueError("no such failure: " + kind)
        with self.lock:
            self.faults.append([operation, nth, kind])

    def hang(self, owner, seconds):
        """Let all calls of one component wait; 0 lets them go."""
        with self.lock:
            self.holds[owner] = time.monotonic() + seconds
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
            self.lock.wait_for(lambda: time.monotonic() >= self.holds.get(owner, 0),
                               max(0, self.holds.get(owner, 0) - time.monotonic()))

    def _fail(self, kind):
        if kind == "HANG":
            time.sleep(FOR_EVER)
        if kind == "DIE":
            os._exit(1)
        raise getattr(CORBA, kind)(MINORS.get(kind, 0), CORBA.COMPLETED_MAYBE)


def stand_in(servant, ledger, owner):
    """A servant that notes each call and passes it on, for object adapters that know nothing of the ledger.
    """
    def passed_on(operation):
        def call(self, *args):
            suffer = ledger.begin(owner, operation)
            try:
                if suffer:
                    suffer()
                return getattr(servant, operation)(*args)
            finally:
                ledger.end()
        return call
    return _like(servant, passed_on)


def suffering(servant, suffer):
    """A servant that passes calls on after `suffer`.

    A locator that waited would keep omniORB from reading the next call on the connection; a servant that
    waits does not.
    """
    def passed_on(operation):
        def call(self, *args):
            suffer()
            return getattr(servant, operation)(*args)
        return call
    return _like(servant, passed_on)


def _like(servant, passed_on):
    lineage = type(servant).__mro__
    skeleton = next(kind for kind in lineage if "_omni_op_d" in vars(kind))
    operations = {name for kind in lineage for name in vars(kind).get("_omni_op_d", ())}
    return type("StandIn", (skeleton,), {name: passed_on(name) for name in operations})()
