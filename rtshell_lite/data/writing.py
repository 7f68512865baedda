"""Values to in ports, until the component has read them.

    with connection.Opened([Writer(port), …]) as opened:
        writer.put(data, writer.little)
        linger(opened.live(), seconds, look)

What a port has taken waits in its buffer. The component reads it in a cycle of its own, while it is Active and while the port
has a connector; what is left when the last connector goes is read at the next connection of anybody. The port has one buffer
for all its connectors, and keeps the length and the policy that the last one asked for; to ask for a length empties it.
(Seen with C++ 2.1 and Python 2.1: InPort::isNew, RingBuffer::length.)
"""
import collections
import math
import threading
import time

from rtshell_lite import cli, errors
from rtshell_lite.corba import lanes, orb
from rtshell_lite.data.connection import GRACE, Connection
from rtshell_lite.robot import component, connectors, ports
from rtshell_lite.text import shell_word

LENGTH = 8  # values that a port's buffer holds unless a connector has asked for more
ROOM, ROOM_BYTES = 5000, 16 << 20  # the longest buffer that is asked for, in values and bytes
BURST = 5.0  # seconds: what comes within them may have to wait
TYPICAL_SIZE = 4096  # bytes of a value whose size is not known before
SLACK = 0.25  # the part by which components execute less often than they claim: 0.11 was seen (a 1 kHz context of C++)
SETTLE = 0.1  # seconds more than a cycle may take
UNKNOWN = 1.0  # seconds that a component may need whose contexts have no rate: they wait for triggers
USUAL = 50.0  # Hz, of a component whose rate is not asked for
READING = 0.02  # seconds that a component may take to read a value
REST = 0.2  # seconds at most that an interrupted command waits until the last value has been read
LONGEST = 60.0  # seconds to linger, unless the user says otherwise
WORTH_A_WORD = 2.0  # seconds: a longer wait is announced, with its reason
TICK = 0.1  # seconds between two looks while lingering

REFUSALS = {"BUFFER_FULL": "its buffer is full", "BUFFER_TIMEOUT": "its buffer stayed full",
            "PORT_ERROR": "it reports an error of the port", "UNKNOWN_ERROR": "it reports an unknown error"}

# One execution context of a component: `index` as -e counts, its reference, the component's state in it, whether it runs.
Cycle = collections.namedtuple("Cycle", "index ref state running")


# ---- who reads ------------------------------------------------------------------------------------------------

class Audience:
    """The component of a port, as far as it reads: `rate` (Hz) is how often, None where its contexts do not say."""

    def __init__(self, node, where):
        self.node, self.where = node, where
        self.rate = None

    def look(self):
        """See whether the component reads what the port is given; returns why it does not, with what helps, or None.

        Raises errors.Error where it cannot be asked.
        """
        cycles = self._cycles()
        reading = [cycle for cycle in cycles if cycle.state == "Active" and cycle.running]
        if not reading:
            return _why_not(self.node, cycles)
        rates = [self._rate(cycle.ref) for cycle in reading]
        self.rate = max((rate for rate in rates if rate), default=None)
        return None

    def _cycles(self):
        owned, participating = component.context_refs(self.node)
        refs = owned + participating
        running = [component.elsewhere(self.node, ref, lambda ref=ref: orb.call(self.node.path, ref, "is_running"), False)
                   for ref in refs]
        return [Cycle(*fields) for fields in zip(range(len(refs)), refs, component.states(self.node, refs), running)]

    def _rate(self, ref):
        rate = component.elsewhere(self.node, ref, lambda: orb.call(self.node.path, ref, "get_rate"), 0)
        return rate if 0 < rate < math.inf else None


def _why_not(node, cycles):
    """Why a component with these Cycles reads nothing, and the commands that change it."""
    path = shell_word(str(node.path))
    state = component.merged([cycle.state for cycle in cycles])
    able = next((cycle for cycle in cycles if cycle.running), None)
    if state == "Active" or able is None:
        index = next((cycle.index for cycle in cycles if cycle.state == "Active"), 0)
        return "its execution context is stopped", f"rtec{_option(index)} {path} start"
    remedy = f"rtact{_option(able.index)} {path}"
    if state == "Error":
        return "it is in Error", f"rtreset{_option(able.index)} {path}, then {remedy}"
    return "it is " + state, remedy


def _option(index):
    return " -e %d" % index if index else ""


class Backlog:
    """How many values wait in a buffer, by what is known: `rate` (Hz) at which they are read, and its `length`.

    `refuses`: when it is full it takes no value, and loses none.
    """

    def __init__(self, rate, length, refuses=False):
        self.rate, self.length, self.refuses = rate, length, refuses
        self.waiting = self.lost = self._at = 0.0

    def add(self, now):
        """A value was taken at `now` (seconds); a full buffer that refuses none has lost its oldest for it."""
        self.drain(now)
        self.waiting += 1
        excess = max(0.0, self.waiting - self.length)
        self.waiting -= excess
        self.lost += 0 if self.refuses else excess

    def drain(self, now):
        """What has been read by `now` waits no more."""
        if self.rate:
            self.waiting = max(0.0, self.waiting - (now - self._at) * self.rate)
        self._at = now

    def seconds(self, taken):
        """How long it takes until all of `taken` values are read: rates, which must be known, are not kept to the letter."""
        return (self.waiting + min(self.length, SLACK * taken) + 1) / self.rate + SETTLE


# ---- sending --------------------------------------------------------------------------------------------------

class Writer(Connection):
    """A connector to a DataInPort; `put` gives it values. `little` is the byte order that it expects.

    `anyway`: whether or not the component is going to read the values.
    """

    kind, side, dataflow, flows = "DataInPort", "inport", "push", ("push",)

    def __init__(self, port, properties=None, name="rtshell_lite", anyway=False):
        super().__init__(port, name, properties)
        self.audience = None if anyway else Audience(port.node, self.where)
        self.taken = self.refused = 0
        self.backlog = Backlog(None, LENGTH)
        self.was_connected = False
        self.read_by = 0.0  # when all that was taken is read, by the clock; infinite where the component has no rate
        self.alone = not port.connectors
        self.room = None  # the length of buffer that the port is asked for
        self.idle, self.unanswered = threading.Event(), False  # set when no put is under way; whether the last one is unanswered
        self.idle.set()
        self.last = 0.0  # when the last value was taken
        self.hurried = False

    def expect(self, values, size):
        """So many values, of `size` bytes each, may come before the component has read the first.

        Where nobody else is connected, the port is asked for a buffer that holds them and that refuses what does not fit; it has
        its usual one, empty, when the Writer is closed.
        """
        room = min(values, ROOM, ROOM_BYTES // max(1, size))
        if room > LENGTH and self.alone and self.audience and not self._chosen():
            self.room = room

    def _chosen(self):
        """What the user asks of the buffer, as a dict: length, write.full_policy and the like."""
        return {key.partition("buffer.")[2]: value for part in ("dataport.buffer.", "dataport.inport.buffer.")
                for key, value in self.given.items() if key.startswith(part)}

    def _new_backlog(self):
        chosen = self._chosen()
        length = chosen.get("length", "")
        refuses = bool(self.room) or chosen.get("write.full_policy", "overwrite") != "overwrite"
        return Backlog(self.audience.rate, self.room or (int(length) if length.isdigit() and int(length) else LENGTH), refuses)

    def wishes(self):
        found = {"dataport.subscription_type": "flush"}
        if self.room:
            found.update({"dataport.buffer.length": str(self.room), "dataport.buffer.write.full_policy": "do_nothing"})
        return found

    def _open(self):
        if self.audience:
            why = self.audience.look()
            if why:
                raise errors.Failed(self.where, "%s and would read the values at some later connection; %s first, or --anyway" % why)
            self.backlog = self._new_backlog()
        super()._open()
        self.was_connected = True
        self.sink = self.remote({"corba_cdr": "dataport.OpenRTM.InPortCdr", "data_service": "dataport.RTC.DataPushService"})
        self.operation = "put" if self.interface == "corba_cdr" else "push"

    def put(self, data, little=True):
        """Send CDR bytes. Raises Refused (buffer full, bad data, wrong byte order), Unreachable, Silent."""
        if little != self.little:
            raise errors.Refused(self.where, f"wants {'little' if self.little else 'big'}-endian data")
        self.idle.clear()
        try:
            self._put(data)
            self.unanswered = False
        except errors.Error as e:
            self.unanswered = isinstance(e, errors.Silent)
            raise
        finally:
            self.idle.set()

    def _put(self, data):
        try:
            status = str(orb.call(self.where, self.sink, self.operation, data))
        except errors.Gone:
            raise errors.Unreachable(self.where, self.lost())
        except errors.Refused:
            self.refused += 1
            raise
        self._compare_rates(status == "BUFFER_FULL")
        if status != "PORT_OK":
            self.refused += 1
            raise errors.Refused(self.where, f"{REFUSALS.get(status, 'it did not take the value')} ({status})", name=status)
        self.taken, self.last = self.taken + 1, time.monotonic()
        self.backlog.add(self.last)
        self.read_by = self.last + self.backlog.seconds(self.taken) if self.backlog.rate else math.inf

    def is_at_rest(self):
        """Wait for a moment in which the component does nothing with the connector; False where there is none.

        A C++ component ends when a connector is removed while it takes a value from us, and may end when it is removed while it
        reads one (2 of 31 rtinjects that Ctrl-C ended, at 50 values a second; InPort::read uses the connector without its lock).
        """
        if not self.idle.wait(0 if self.unanswered else lanes.session.timeout + GRACE):
            return False
        if self.taken:
            now, rate = time.monotonic(), self.backlog.rate or USUAL
            self.backlog.drain(now)
            waiting = self.backlog.waiting if self.backlog.rate else 0
            time.sleep(max(0.0, min(max(self.last + 1.5 / rate - now, waiting / rate) + READING, REST)))
        return not self.unanswered

    def _compare_rates(self, full):
        """Remark once that values come faster than they are read."""
        self.backlog.drain(time.monotonic())
        if self.backlog.rate and (self.backlog.lost >= 1 or full and self.room) and not self.hurried:
            self.hurried = True
            self.remark = f"values come faster than it executes ({self.backlog.rate:g} Hz)"

    def due(self):
        return isinstance(self.failure, errors.Silent) or self.audience is not None

    def look(self):
        if isinstance(self.failure, errors.Silent):
            super().look()
        try:
            why = self.audience and self.connector and self.audience.look()
        except (errors.Gone, errors.ConnectionRefused) as e:
            raise self.component_ended(e)
        if why:
            raise errors.Unread(self.where, f"{why[0]} now; {self.unread_words()}")
        if self.audience:
            self.backlog.drain(time.monotonic())  # at the rate of until now
            self.backlog.rate = self.audience.rate

    def unread(self):
        """errors.Unread where the component cannot have read all that its port took, by its rate; else None."""
        if self.audience is None or self.audience.rate is None:
            return None
        self.backlog.drain(time.monotonic())
        if not self.backlog.waiting and self.backlog.lost < 1:
            return None
        return errors.Unread(self.where, f"it executes at {self.audience.rate:g} Hz; {self.unread_words()}")

    def unread_words(self):
        """What became of the values, as far as it is known."""
        self.backlog.drain(time.monotonic())
        read = max(0, round(self.taken - self.backlog.lost) - math.ceil(self.backlog.waiting))
        rest = "dropped" if self.alone else "in its buffer, or overwritten"
        return "it has read about %d of %d values; the rest is %s" % (read, self.taken, rest)

    def release(self):
        """Give the port its usual buffer again, emptied of what may be unread: it would be read at some later connection.

        Where somebody else has connected to it meanwhile, only no value shall be refused any more: the rest may be that one's.
        """
        unread = self.taken and (self.failure or time.monotonic() < self.read_by - SETTLE / 2)  # which leaves linger's rounding
        if self.left or not self.was_connected or not self.room and not (self.alone and self.audience and unread):
            return
        if self.failure is None and self.unread():  # interrupted while lingering
            cli.complain(self.unread())
        self.room, self.was_connected = None, False
        usual = dict(self.asked(), **{"dataport.buffer.write.full_policy": "overwrite"})
        try:
            if not ports.port(self.port.node, self.port.ref).connectors:
                usual["dataport.buffer.length"] = str(LENGTH)
            connectors.disconnect(self.port, connectors.connect_alone(self.port, self.name, usual))
        except (errors.Silent, errors.Refused) as e:
            self.failure = self.failure or e
        except errors.Unreachable:
            pass  # and its buffer with it


def linger(writers, seconds, look):
    """Wait until the components can have read what these Writers have put, or for `seconds` (None: as long as it takes).

    Who cannot have read it all, or reads no more, has errors.Unread as its failure. look() is called every TICK.
    """
    for writer in writers:
        if writer.refused and writer.refused + writer.taken > 1:
            cli.complain("%s: it refused %d of %d values" % (writer.where, writer.refused, writer.refused + writer.taken))
    writers = [writer for writer in writers if writer.taken]
    needed = [_needed(writer, seconds) for writer in writers]
    if not writers:
        return
    if max(needed) > WORTH_A_WORD:
        slowest = writers[needed.index(max(needed))]
        cli.note(f"{slowest.where}: waiting {max(needed):.1f} s until it has read the values (--linger limits it)")
    begun = time.monotonic()
    _wait(begun, writers, needed, look)
    results = lanes.each(writers, lambda writer: writer.look())
    for writer, result in zip(writers, results):
        writer.failure = writer.failure or (result if isinstance(result, errors.Error) else writer.unread())


def _wait(begun, writers, needed, look):
    """Wait until the last of the Writers that have not failed meanwhile has had the seconds that it needs, from `begun` on."""
    while True:
        left = begun - time.monotonic() + max(
            (seconds for writer, seconds in zip(writers, needed)
             if writer.failure is None or isinstance(writer.failure, errors.Silent)), default=0)
        if left <= 0:
            return
        look()
        time.sleep(min(TICK, left))


def _needed(writer, seconds):
    """How long (seconds) to linger for a Writer."""
    if writer.audience is None or writer.audience.rate is None:
        return seconds if seconds is not None else UNKNOWN if writer.audience else 0
    writer.backlog.drain(time.monotonic())
    return min(writer.backlog.seconds(writer.taken), LONGEST if seconds is None else seconds)
