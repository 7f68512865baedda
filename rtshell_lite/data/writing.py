"""Data to in ports of components.

    async with connection.Connections([Writer(port), …]) as opened:
        await writer.put(data, writer.little)
        await linger(opened.live(), seconds)

A value that a port accepts waits in its buffer. The component reads it in a later cycle, while it is Active
and the port has a connector; values left unread when the last connector goes are read at the next connection,
of any program. The port has one buffer for all its connectors, and keeps the length and policy that the last
one asked for; asking for a length empties it. (Seen with C++ 2.1 and Python 2.1: InPort::isNew,
RingBuffer::length.)
"""

import collections
import math

from rtshell_lite import errors, notes
from rtshell_lite.corba import orb, session
from rtshell_lite.data.connection import PortConnection
from rtshell_lite.net import loop
from rtshell_lite.robot import component, connectors, ports, tree
from rtshell_lite.text import shell_word

LENGTH = 8  # values that a port's buffer holds unless a connector has asked for more
ROOM = 4  # values in the short buffer that several values are sent through
# the fraction by which components may execute less often than they claim, where more is not known
SLACK = 0.25
SETTLE = 0.1  # seconds to add to a cycle
UNKNOWN = 1.0  # seconds to wait for a component whose contexts have no rate, but are triggered
USUAL = 50.0  # Hz, assumed of a component whose rate is not asked for
READING = 0.02  # seconds that a component may take to read a value
REST = 0.2  # seconds that an interrupted command waits, at most, until the last value has been read
LONGEST = 60.0  # seconds to linger at most, unless the user says otherwise
ANNOUNCED = 2.0  # seconds: a longer wait is announced, with its reason
TICK = 0.1  # seconds between two looks whether it is worth lingering
MOMENT = 0.001  # seconds that are too few to sleep
BUSIEST = 10.0  # seconds that lingering may take longer, at most, on a busy computer
# seconds for which a value that a full buffer has refused is offered again, unless it is to wait for the
# reader
LATE = 1.0
STUCK = 5.0  # seconds, and cycles, without any value taken after which a component does not read its port
PAUSES = 0.001, 0.05  # seconds between two offers of a value, at least and at most

REFUSALS = {
    "BUFFER_FULL": "its buffer is full",
    "BUFFER_TIMEOUT": "its buffer stayed full",
    "PORT_ERROR": "it reports an error of the port",
    "UNKNOWN_ERROR": "it reports an unknown error",
}

# An execution context of a component: `index` as in -e, its reference, the component's state in it, whether
# it runs.
Cycle = collections.namedtuple("Cycle", "index ref state running")


# ---- who reads ----


class Audience:
    """The component that reads a port: `rate` (Hz) is how often, None where its contexts have none."""

    def __init__(self, node, where):
        self.node = node
        self.where = where
        self.rate = None

    async def why_not_reading(self):
        """None when the component reads the port; else (why it does not, the commands that change it).
        Raises errors.Error.
        """
        cycles = await self._cycles()
        reading = [cycle for cycle in cycles if cycle.state == "Active" and cycle.running]
        if not reading:
            return _why_not(self.node, cycles)
        rates = [await self._rate(cycle.ref) for cycle in reading]
        self.rate = max((rate for rate in rates if rate), default=None)
        return None

    async def _cycles(self):
        owned, participating = await component.context_refs(self.node)
        refs = owned + participating
        running = [
            await component.or_default(self.node, ref, orb.call(self.node.path, ref, "is_running"), False)
            for ref in refs
        ]
        return [
            Cycle(*fields)
            for fields in zip(range(len(refs)), refs, await component.states(self.node, refs), running)
        ]

    async def _rate(self, ref):
        rate = await component.or_default(self.node, ref, orb.call(self.node.path, ref, "get_rate"), 0)
        return rate if 0 < rate < math.inf else None


def _why_not(node, cycles):
    """(why a component with these Cycles reads nothing, the commands that change it)"""
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


async def _do_any_write(ref, others):
    """Whether any of these Connectors of the in port `ref` may bring values into its buffer: those of tools
    may, and those of components that may be Active; values that the port fetches wait elsewhere.
    """
    for connector in others:
        properties = dict(connector.properties)
        if properties.get("dataport.dataflow_type", "").lower() == "pull":
            continue
        sources = [other for other in connector.ports if other is not None and not orb.same(other, ref)]
        if not sources:
            return True
        for source in sources:
            if await _does_write(source):
                return True
    return False


async def _does_write(ref):
    """Whether a port may send values."""
    path = orb.at_address(ref)
    try:
        port = await ports.port(tree.Node(path, "component", ref), ref)
        if port.type != "DataOutPort":
            return False
        state = await component.state(tree.Node(path, "component", port.owner))
    except errors.Gone:
        return False
    except errors.Error:
        return True
    return state not in ("Inactive", "Error", "Created")


class Backlog:
    """How many values wait in a buffer of this `length` that is read at `rate` (Hz; None where nothing is
    known).

    `refuses`: a full buffer refuses values instead of losing the oldest ones. Then all but the last `length`
    values that it took have been read for certain, and each time that it is full says how fast: the rate that
    a context claims is only where `rate` begins (1,000 Hz was 470 on a busy computer).
    """

    def __init__(self, rate, length, refuses=False):
        self.rate = rate
        self.length = length
        self.refuses = refuses
        self.waiting = self.lost = self.delay = self._at = 0.0
        # the last two: (moment, values taken) after reads that it was full before
        self.taken = 0
        self._first = None
        self._last = None
        self.longest = 0.0  # seconds between two reads, at most, while it was full

    def add(self, now, delay=0.0):
        """The port took a value at `now` (seconds), `delay` after it was sent.

        `delay` is added to what reading takes: a computer that is too busy to answer at once is too busy to
        read at once.
        """
        self.drain(now)
        self.delay = max(self.delay, delay)
        self.taken += 1
        self.waiting += 1
        excess = max(0.0, self.waiting - self.length)
        self.waiting -= excess
        if not self.refuses:
            self.lost += excess

    def fill(self, now):
        """The buffer refused a value at `now`, because it was full."""
        self._at = now
        self.waiting = min(self.length, self.taken)
        if self._last is None:
            self._last = None, self.taken
        moment, taken = self._last
        if self.taken == taken:
            return
        self._last = now, self.taken
        if moment is None:
            self._first = self._last
            return
        self.longest = max(self.longest, (now - moment) / (self.taken - taken))
        begun, before = self._first
        self.rate = (self.taken - before) / (now - begun)

    def measured(self):
        """Whether `rate` is that of the reader, and not only what its context claims."""
        return self._first is not None and self._last != self._first

    def drain(self, now):
        """Subtract the values that have been read by `now`."""
        if self.rate:
            self.waiting = max(0.0, self.waiting - (now - self._at) * self.rate)
        self._at = now

    def seconds(self):
        """How long it takes to read all values, with SLACK and the longest delay; the rate must be known."""
        waiting = min(self.length, self.waiting + SLACK * self.taken)
        return (waiting + 1) / self.rate + SETTLE + self.delay + self.longest


def _hertz(rate):
    return "%g Hz" % float("%.3g" % rate)


# ---- sending ----


class Writer(PortConnection):
    """A connector to a DataInPort; `put` sends it values. `little` is the byte order that it expects.

    `anyway`: even if the component will not read the values. `several`: more than one value is coming. Then,
    where nobody else is connected and the user asks for no other, the port is asked for a short buffer that
    refuses what it has no room for; it gets its usual one back, empty, when the Writer is closed.
    """

    kind = "DataInPort"
    side = "inport"
    dataflow = "push"
    flows = ("push",)
    hint = ", or --anyway"  # for the user, where the component does not read the port

    def __init__(self, port, properties=None, name="rtshell_lite", anyway=False, several=False):
        super().__init__(port, name, properties)
        self.audience = None if anyway else Audience(port.node, self.where)
        self.taken = self.refused = 0
        self.was_connected = self.lingered = self.hurried = False
        self.alone = not port.connectors
        self.is_short = bool(several and self.alone and self.audience and not self._chosen())
        self.backlog = self._new_backlog(None)
        self.unanswered = False  # whether the component may still be taking the last value
        self.last = 0.0  # when the last value was taken

    def _chosen(self):
        """The user's properties of the buffer: length, write.full_policy and the like."""
        return {
            key.partition("buffer.")[2]: value
            for part in ("dataport.buffer.", "dataport.inport.buffer.")
            for key, value in self.user.items()
            if key.startswith(part)
        }

    def _new_backlog(self, rate):
        if self.is_short:
            return Backlog(rate, ROOM, refuses=True)
        chosen = self._chosen()
        length = chosen.get("length", "")
        refuses = self.alone and chosen.get("write.full_policy") == "do_nothing"
        if length.isdigit() and int(length):
            return Backlog(rate, int(length), refuses)
        return Backlog(rate, LENGTH, refuses)

    async def defaults(self):
        defaults = {"dataport.subscription_type": "flush"}
        if self.is_short:
            defaults.update(
                {"dataport.buffer.length": str(ROOM), "dataport.buffer.write.full_policy": "do_nothing"}
            )
        return defaults

    async def open(self):
        if self.audience:
            why = await self.audience.why_not_reading()
            if why:
                raise errors.Failed(
                    self.where,
                    "%s and would read the values at some later connection; %s first" % why + self.hint,
                )
            self.backlog = self._new_backlog(self.audience.rate)
        await super().open()
        self.was_connected = True
        self.last = loop.now()
        self.sink = self.remote({"corba_cdr": "OpenRTM.InPortCdr", "data_service": "RTC.DataPushService"})
        self.operation = "put" if self.interface == "corba_cdr" else "push"

    async def put(self, data, little=True):
        """Send CDR bytes. Raises Refused (buffer full, bad data, wrong byte order), Unreachable, Silent."""
        if little != self.little:
            order = "little" if self.little else "big"
            raise errors.Refused(self.where, f"wants {order}-endian data")
        if self.unanswered:  # by a component that may hang: nobody waits for it after Ctrl-C
            await self._put(data)
        else:
            await loop.finish(self._put(data))

    async def _put(self, data):
        begun = loop.now()
        self.unanswered = True
        try:
            status = str(await orb.call(self.where, self.sink, self.operation, data))
        except errors.Error as e:
            self.unanswered = isinstance(e, errors.Silent)
            if isinstance(e, errors.Gone):
                raise errors.Unreachable(self.where, self.lost())
            if isinstance(e, errors.ConnectionRefused):
                raise self.component_ended(e)
            raise
        self.unanswered = False
        now = loop.now()
        if status == "PORT_OK":
            self.taken = self.taken + 1
            self.last = now
            self.backlog.add(now, now - begun)
            if self.backlog.lost >= 1:
                self._hurry("it executes")
            return
        if status == "BUFFER_FULL" and self.backlog.refuses:
            self.backlog.fill(now)
        raise errors.Refused(
            self.where, f"{REFUSALS.get(status, 'it did not take the value')} ({status})", name=status
        )

    def _hurry(self, how):
        """Remark, once, that values come faster than they are read."""
        if self.backlog.rate and not self.hurried:
            self.hurried = True
            self.remark = f"values come faster than {how} ({_hertz(self.backlog.rate)})"

    def waits_for_room(self, refusal, until):
        """Whether a value that was answered by this errors.Error is to be offered again, before `until`."""
        if not self.is_short or self.failure or getattr(refusal, "name", None) != "BUFFER_FULL":
            return False
        now = loop.now()
        patience = max(STUCK, STUCK / (self.backlog.rate or USUAL))
        if now - self.last > patience:
            self.failure = errors.Unread(
                self.where, f"it has read nothing for {now - self.last:.1f} s; {self.unread_words()}"
            )
        return not self.failure and now < until

    def refuse(self, refusal):
        """Count a value that the port has refused for good;
        returns the errors.Error to report now, or None.
        """
        self.refused += 1
        if self.failure:
            return None
        if self.is_short and refusal.name == "BUFFER_FULL" and self.backlog.measured():
            self._hurry("it reads them")
            return None
        return refusal

    def refusals(self):
        """The errors.Unread that says how many of several values were refused, or None."""
        if not self.refused or self.refused + self.taken == 1:
            return None
        why = ""
        if self.backlog.measured():
            why = f": they came faster than it reads them ({_hertz(self.backlog.rate)})"
        return errors.Unread(
            self.where, f"it refused {self.refused} of {self.refused + self.taken} values{why}"
        )

    async def is_at_rest(self):
        """Wait until the component is not using the connector; False if it goes on using it.

        Removing a connector ends a C++ component that is taking a value from us, and may end one that is
        reading one (2 of 31 interrupted rtinjects, at 50 values a second; InPort::read uses the connector
        without its lock).
        """
        if self.taken and not self.unanswered:
            now = loop.now()
            rate = self.backlog.rate or USUAL
            self.backlog.drain(now)
            waiting = self.backlog.waiting if self.backlog.rate else 0
            await loop.sleep(min(max(self.last + 1.5 / rate - now, waiting / rate) + READING, REST))
        return not self.unanswered

    def is_due(self):
        return isinstance(self.failure, errors.Unanswered) or self.audience is not None

    async def check(self):
        if isinstance(self.failure, errors.Unanswered):
            await super().check()
        try:
            why = self.audience and self.connector and await self.audience.why_not_reading()
        except (errors.Gone, errors.ConnectionRefused) as e:
            raise self.component_ended(e)
        if why:
            raise errors.Unread(self.where, f"{why[0]} now; {self.unread_words()}")
        if self.audience and not self.backlog.measured():
            self.backlog.drain(loop.now())  # at the old rate
            self.backlog.rate = self.audience.rate

    def unread(self):
        """errors.Unread where the component, at its rate, cannot have read all values; else None."""
        if self.audience is None or self.backlog.rate is None:
            return None
        self.backlog.drain(loop.now())
        if not self.backlog.waiting and self.backlog.lost < 1:
            return None
        does = "reads" if self.backlog.measured() else "executes"
        rate = _hertz(self.backlog.rate)
        return errors.Unread(self.where, f"it {does} at {rate}; {self.unread_words()}")

    def unread_words(self):
        """The message that says how many values were read, and where the rest is."""
        self.backlog.drain(loop.now())
        arrived = round(self.taken - self.backlog.lost)
        read = max(0, arrived - math.ceil(self.backlog.waiting))
        if self.alone:
            return f"it has read about {read} of {self.taken} values; the rest is dropped"
        return (
            f"it has probably read about {read} of {self.taken} values; the rest is in its buffer, or "
            "overwritten"
        )

    async def judge(self, own):
        """Look, in the end, whether all values have been read; `own`: ids of the connectors of this command.
        Raises errors.Unread, and what check() raises.
        """
        if not self.taken:
            return
        await self.check()
        if self.audience and await self._do_others_write(own):
            what = "it was" if self.taken == 1 else f"the {self.taken} values were"
            raise errors.Unread(
                self.where, f"sent; others write to this port, so whether {what} read is not known"
            )
        unread = self.unread()
        if unread:
            raise unread
        if self.audience and not self.alone:
            what = "the value" if self.taken == 1 else f"the {self.taken} values"
            self.remark = f"it has probably read {what}: others are connected, and share its buffer"
        self.lingered = True

    async def _do_others_write(self, own):
        """Whether another connector that the port has, or had at first, may have brought values; those with
        `own` ids are no others.
        """
        connected = (await ports.port(self.port.node, self.port.ref)).connectors
        others = {connector.id: connector for connector in [*self.port.connectors, *connected]}
        others.pop(self.connector.id, None)
        self.alone = self.alone and not others
        strange = [connector for connector in others.values() if connector.id not in own]
        return await _do_any_write(self.port.ref, strange)

    async def release(self):
        """Give the port its usual buffer back, empty: unread values would be read at some later connection.

        If somebody else has connected meanwhile, only change the policy back: the values may be theirs.
        """
        unread = self.taken and self.alone and self.audience and (self.failure or not self.lingered)
        if self.left or not self.was_connected or not (self.is_short or unread):
            return
        if self.failure is None and not self.lingered and self.unread():  # interrupted while lingering
            notes.fail(self.unread())
        self.is_short = self.was_connected = False
        usual = dict(await self.requested(), **{"dataport.buffer.write.full_policy": "overwrite"})
        try:
            if not (await ports.port(self.port.node, self.port.ref)).connectors:
                usual["dataport.buffer.length"] = str(LENGTH)
            await self.remove(await connectors.connect_alone(self.port, self.name, usual))
        except (errors.Gone, errors.ConnectionRefused):
            pass  # the port is gone, and its buffer with it
        except (errors.Unreachable, errors.Refused) as e:
            self.failure = self.failure or e


async def offer(values, until):
    """Send each of `values`, (Writer, CDR bytes), all at the same time: the failures to report, [(Writer,
    errors.Error)].

    What a short buffer has no room for is offered again until `until` (by loop.now(), math.inf: as long
    as the component reads), at half the component's period.
    """
    failures = []
    while values:
        answers = await session.each(values, _put, lambda value: (value[0].endpoint, value[0].where))
        waiting = []
        for (writer, data), answer in zip(values, answers):
            if writer.waits_for_room(answer, until):
                waiting.append((writer, data))
                continue
            failure = writer.refuse(answer) if isinstance(answer, errors.Refused) else answer
            if isinstance(failure, errors.Error):
                failures.append((writer, failure))
        values = waiting
        if values:
            fastest = max(writer.backlog.rate or USUAL for writer, _ in values)
            await loop.sleep(min(max(0.5 / fastest, PAUSES[0]), PAUSES[1]))
    return failures


async def _put(value):
    writer, data = value
    await writer.put(data, writer.little)


async def linger(writers, seconds):
    """Wait until the components can have read what these Writers sent, or for `seconds` (None: as long as it
    takes).

    A computer that wakes us late may let components read late, too: the wait then takes longer, by BUSIEST at
    most.

    The failure of those that cannot have read all, have refused some, or have stopped reading, becomes
    errors.Unread.
    """
    needed = [_needed(writer, seconds) for writer in writers]
    if max(needed, default=0) > ANNOUNCED:
        slowest = writers[needed.index(max(needed))]
        notes.note(
            f"{slowest.where}: waiting {max(needed):.1f} s until it has read the values (--linger limits it)"
        )
    limit = max(needed, default=0) + BUSIEST
    if seconds is not None:
        limit = min(limit, seconds)
    end = loop.now() + limit
    slept = 0.0
    while True:
        left = min(_longest_needed(writers, needed) - slept, end - loop.now())
        if left < MOMENT:
            break
        pause = min(TICK, left)
        await loop.sleep(pause)
        slept += pause
    own = {writer.connector.id for writer in writers if writer.connector}
    results = await session.each(
        writers, lambda writer: writer.judge(own), lambda writer: (writer.endpoint, writer.where)
    )
    for writer, result in zip(writers, results):
        if isinstance(result, errors.Error):
            writer.failure = writer.failure or result
        refused = writer.refusals()
        if refused and writer.is_short and writer.failure is None:
            writer.failure = refused
        elif refused:
            notes.fail(refused)


def _longest_needed(writers, needed):
    """The longest of the times `needed` by Writers, without those that have failed other than by silence."""
    return max(
        (
            seconds
            for writer, seconds in zip(writers, needed)
            if writer.failure is None or isinstance(writer.failure, errors.Unanswered)
        ),
        default=0,
    )


def _needed(writer, seconds):
    """How long (seconds) to linger for a Writer."""
    if not writer.taken:
        return 0
    if writer.backlog.rate is None:
        if seconds is not None:
            return seconds
        if writer.audience:
            return UNKNOWN
        return 0
    writer.backlog.drain(loop.now())
    longest = seconds if seconds is not None else LONGEST
    return min(writer.backlog.seconds(), longest)
