"""Where a signal stops: follows the connections of data ports through components, measures every out port on
the way at the same time, and finds the first stage that stops, holds, thins, delays or disorders the values.

Harmless as rtprint is: one connector a port, made and left by its rules.
"""

import collections
import struct
import time

from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.data import clocks, reading, statistics
from rtshell_lite.doctor import buffers
from rtshell_lite.net import loop
from rtshell_lite.robot import component, places, ports, snapshot, tree

MOST = 300  # components that are followed
KEPT = 4096  # times of values of a port that are kept to find delays
STAMP = 8  # octets of the time that values begin with
THINNED = 0.7  # a stage that passes on fewer of its values than this thins them
FEW = 4  # values from which on it is known whether they change
MANY = 20  # values from which on it is known whether a stage thins them
LATE = 0.15  # seconds, beside CYCLES of its context, that a stage may take with a value
CYCLES = 3
LEAST = 0.5  # seconds that a component is waited for, and for which a port's silence means something
SHORTEST = (
    1 / 3
)  # of the seconds asked for, in which all ports are measured, however long it took to find them
LONGEST = 2  # times those seconds, in which they have to be found
UNANSWERED = "it has not answered in this time"
BUSY = 4  # times what other stages take, before it is the one that is late
MOST_SLOWER = 3  # times: what a busy host is allowed

# (policy, what a buffer that is full does by it), the one that matters most first
BUFFERS = (("block", "blocks"), ("do_nothing", "refuses"), ("", "replaces"))
FULL = "full"

CERTAIN = "certain"
PROBABLE = "probable"

# What is wrong at a Stage: in words; CERTAIN or PROBABLE; whether it is only that values are fewer or later,
# which a busy host does to every stage.
Fault = collections.namedtuple("Fault", "words sure is_slight")

# A connection from a Watch to the in port `port` of a Stage. `joined`: the in port knows of it, too.
Link = collections.namedtuple("Link", "watch stage port joined")


# A component that does not answer, or is bound nowhere: its path, or that of the port `near` it; how many
# connections it is away; why.
Far = collections.namedtuple("Far", "where depth near why")


class Watch:
    """An out port on the way, and what comes out of it."""

    def __init__(self, port):
        self.port = port
        self.name = ports.label(port)
        self.flow = statistics.Flow()
        self.counts = statistics.Counts()
        self.changes = 0  # values that differed from the one before
        self.arrivals = collections.OrderedDict()  # by timestamp in ns: when its value came, ns since 1970
        self.failure = None  # the errors.Error why it could not be measured
        self.seconds = 0.0  # for which it was
        self.until = 0  # when that ended, ns since 1970
        self._is_stamped = clocks.is_stamped(port)
        self._last = None

    def take(self, message):
        """Count a reading.Message."""
        stamp = 0
        data = message.data
        if self._is_stamped and len(data) >= STAMP:
            order = "<" if message.little else ">"
            seconds, nanoseconds = struct.unpack_from(order + "LL", data)
            stamp = seconds * 10**9 + nanoseconds
            data = data[STAMP:]
        before = self.count
        self.flow.add(message.received, bytes(message.data), stamp)
        if self.count > before:  # it is not the same one again
            self.counts.add(message.received)
        if self._last is not None and data != self._last:
            self.changes += 1
        self._last = bytes(data)
        if stamp and len(self.arrivals) < KEPT:
            self.arrivals.setdefault(stamp, message.received)

    @property
    def count(self):
        """How many values came."""
        return self.flow.total.count

    @property
    def rate(self):
        """Values a second, by the gaps between them where there are any."""
        if self.count > 1:
            return 1 / max(self.flow.total.gaps.mean, 1e-9)
        if self.seconds:
            return self.count / self.seconds
        return 0.0

    @property
    def newest(self):
        """Seconds from the arrival of the newest value to the end, None if none came."""
        if self.flow.last is None:
            return None
        return max(0.0, (self.until - self.flow.last) / 1e9)

    def delay_after(self, other):
        """Mean seconds from a value of another Watch to the one of this with the same timestamp, None if
        unknown.
        """
        both = [stamp for stamp in self.arrivals if stamp in other.arrivals]
        if not both:
            return None
        delays = [self.arrivals[stamp] - other.arrivals[stamp] for stamp in both]
        return sum(delays) / len(both) / 1e9


class Stage:
    """A component on the way."""

    def __init__(self, node, depth):
        self.node = node
        self.where = str(node.path)
        self.depth = depth  # connections from where the trace began
        self.error = errors.Silent(self.where, UNANSWERED)  # why it could not be asked
        self.state = None
        self.contexts = []  # component.Contexts; None if unknown, as in a recording
        self.watches = []
        self.services = []  # (port, far end), both as text
        self.delay = None  # seconds that values take from its in ports to its out ports

    @property
    def rate(self):
        """What its running context claims, in Hz; 0 if none runs."""
        rates = [context.rate for context in self.contexts or () if context.running]
        return max(rates, default=0)


class Trace:
    """The stages from a port on, with the data or against it, and what was measured."""

    def __init__(self, against=False):
        self.against = against
        self.stages = collections.OrderedDict()  # by identity of the component
        self.links = []
        self.silent = []  # Far ends that do not answer
        self.gap = None  # the path of the component to which no way leads
        self.is_cut = False  # whether there was no time to follow all connections
        self._following = self._measuring = None  # loop.Groups

    async def follow(self, start, seconds):
        """Follow the connections from a ports.Port and measure, for `seconds` in all; for longer, where a
        busy machine needs most of them to follow.
        """
        now = session.current()
        patience = now.timeout
        now.timeout = min(patience, max(LEAST, seconds / 3))  # to follow, and to find out who is silent
        end = time.monotonic() + seconds
        try:
            async with loop.Group() as self._measuring:
                async with loop.background(self._give_up(LONGEST * seconds)):
                    async with loop.Group() as self._following:
                        self._enter(tree.Node(start.node.path, "component", start.node.ref), 0, start)
                await loop.sleep(max(seconds * SHORTEST, end - time.monotonic()))
                self._measuring.cancel()
        finally:
            now.timeout = patience

    async def _give_up(self, seconds):
        """Follow no further after some seconds."""
        await loop.sleep(seconds)
        self.is_cut = True
        self._following.cancel()

    # ---- following ----

    def _enter(self, node, depth, only=None):
        """The Stage of a component, which is looked at if that is new."""
        identity = orb.identity(node.ref)
        if identity not in self.stages and len(self.stages) < MOST:
            self.stages[identity] = Stage(node, depth)
            self._following.start(self._look(self.stages[identity], only), node.endpoint)
        return self.stages.get(identity)

    async def _look(self, stage, only):
        try:
            found = await snapshot.of(
                stage.node,
                ports=snapshot.FULL,
                owned=snapshot.RUNNING,
                participating=snapshot.RUNNING,
                states=snapshot.FULL,
            )
        except errors.Error as e:
            stage.error = e
            if isinstance(e, errors.Silent):
                await self.find_cause(stage)
            return
        stage.error = None
        stage.state = component.merged(found.states)
        stage.contexts = found.contexts
        listed = ports.in_system(found.ports)
        outs = [port for port in listed if port.type == "DataOutPort"]
        ins = [port for port in listed if port.type == "DataInPort"]
        if only is not None and only.type == "DataOutPort":
            outs = [port for port in outs if port.name == only.name]
        elif self.against:
            outs = []  # those on the way are known where they lead to
        if only is not None and only.type == "DataInPort" and self.against:
            ins = [port for port in ins if port.name == only.name]
        for port in outs:
            self._watch(stage, port)
        await self._show_services(stage, [port for port in listed if port.type == "CorbaPort"])
        if self.against:
            await self._go_on(stage, ins)
        else:
            await self._go_on(stage, outs)

    def _watch(self, stage, port):
        if any(watch.port.name == port.name for watch in stage.watches):
            return
        watch = Watch(port)
        stage.watches.append(watch)
        self._measuring.start(self._measure(watch), orb.endpoint(port.ref))

    async def _measure(self, watch):
        """Take the values of a Watch until this task is cancelled."""
        watch.failure = errors.Silent(watch.name, UNANSWERED)
        try:
            async with reading.Reader(watch.port, watch.take, name="rtshell_lite") as reader:
                begun = time.monotonic()
                watch.failure = None
                try:
                    await loop.Wait()
                finally:
                    watch.seconds = time.monotonic() - begun
                    watch.until = int(time.time() * 1e9)
                    watch.failure = reader.failure
        except errors.Error as e:
            watch.failure = e

    async def _show_services(self, stage, listed):
        connected = [port for port in listed if port.connectors]
        if connected:
            name_of = await places.far_names(connected)
            for port in connected:
                names = {name_of(ref) for one in port.connectors for ref in one.ports} - {None}
                stage.services += [(ports.label(port), name) for name in sorted(names)]

    async def _go_on(self, stage, listed):
        """Go on to what these ports are connected with."""
        ends = await places.far_ends(listed)
        for port in listed:
            for connector in port.connectors:
                for ref in connector.ports:
                    end = ref is not None and ends.get(orb.identity(ref))
                    if end:
                        await self._join(stage, port, connector, end)

    async def _join(self, stage, port, connector, end):
        if end.port is None:
            where = await self._bound_there(end.ref, port.node)
            self.silent.append(
                Far(where or ports.label(port), stage.depth + 1, ports.label(port), end.error.why)
            )
            return
        if end.port.node is None:
            why = f"{places.name(end)} is bound nowhere"
            where = ports.label(port)
            self.silent.append(Far(where, stage.depth + 1, where, why))
            return
        far = self._enter(end.port.node, stage.depth + 1)
        if far is None:
            return
        joined = any(each.id == connector.id for each in end.port.connectors)
        if not self.against:
            watch = next(each for each in stage.watches if each.port.name == port.name)
            self.links.append(Link(watch, far, end.port, joined))
            return
        far_port = end.port._replace(node=far.node)
        self._watch(far, far_port)
        watch = next(each for each in far.watches if each.port.name == far_port.name)
        self.links.append(Link(watch, stage, port, joined))

    async def find_cause(self, stage):
        """Note what a Stage waits for, if it lives: asked for its ports, it asks their far ends."""
        session.current().silent.pop(stage.node.endpoint, None)  # its process may answer smaller questions
        others = []
        for node in await _bound(stage.node):
            if node.endpoint != stage.node.endpoint:
                others.append(node)
        silent = []
        for node in await tree.check_alive(others):
            if node.kind == "silent":
                silent.append(node)
        (itself,) = await tree.check_alive([stage.node])
        if len(silent) == 1 and itself.kind != "silent":
            stage.error = errors.Silent(stage.where, f"it waits for {silent[0].path}, which does not answer")
            self.silent.append(Far(str(silent[0].path), stage.depth, stage.where, "it does not answer"))

    async def _bound_there(self, ref, near):
        """The path, as text, of the only component bound with the address of a reference, or the only one of
        them that does not answer; None if unknown.
        """
        at = orb.endpoint(ref)
        bound = []
        for node in await _bound(near):
            if orb.endpoint(node.ref) == at:
                bound.append(node)
        if len(bound) > 1:
            bound = [node for node in await tree.check_alive(bound) if node.kind == "silent"]
        if len(bound) == 1:
            return str(bound[0].path)
        return None

    def limit(self, to, back):
        """Keep what leads to a Port; `back` is the Trace from there against the data. Where no way leads
        there, what has been found from both ends is kept, and the gap is a fault.
        """
        self.limit_to(str(to.node.path), back)

    def limit_to(self, where, back):
        """`limit`, by the path of the component."""
        ends = [stage for stage in self.stages.values() if stage.where == where]
        if not ends:
            self.gap = min(back.in_order(), key=lambda stage: -stage.depth).where
            return
        kept = set(ends)
        for _ in self.stages:
            kept |= {stage for stage in self.stages.values() if self._leads_to(stage, kept)}
        self.stages = collections.OrderedDict(
            (identity, stage) for identity, stage in self.stages.items() if stage in kept
        )
        self.links = [link for link in self.links if link.stage in kept]

    def _leads_to(self, stage, kept):
        for link in self.links:
            if link.stage in kept and link.watch in stage.watches:
                return True
        return False

    # ---- judging ----

    def in_order(self):
        """The Stages, those where data comes from first."""
        return sorted(self.stages.values(), key=lambda stage: stage.depth, reverse=self.against)

    def feeding(self, stage):
        """The Links that lead to a Stage."""
        return [link for link in self.links if link.stage is stage]

    def culprit(self):
        """(path of a component, Fault) of the first that does not pass values on, or of the first that does
        so slowly; None if all do.

        What hangs or is dead explains why those around it seem to stop values.
        """
        found = []
        for stage, fault in self._faults():
            if fault is not None:
                found.append((stage, fault))
        first = min(found, key=lambda each: each[1].is_slight, default=None)
        if first is None and self.gap is not None:
            sure = CERTAIN
            if self.is_cut:
                sure = PROBABLE
            first = self.in_order()[-1], _fault(f"no connection leads on from it to {self.gap}", sure)
        silent = self._silent()
        if silent is None:
            return first and (first[0].where, first[1])
        if first is None or first[1].sure == PROBABLE or self._is_before(silent.depth, first[0].depth):
            return silent.where, _fault(silent.why, _sure_of(silent))
        return first and (first[0].where, first[1])

    def _faults(self):
        for stage in self.in_order():
            if stage.error is None:
                yield stage, self._fault_at(stage)

    def _silent(self):
        """The Far that data reaches first, None if all answer."""
        found = list(self.silent)
        for stage in self.stages.values():
            if stage.error is not None:
                found.append(Far(stage.where, stage.depth, stage.where, stage.error.why))
        if self.against:
            return max(found, key=lambda far: far.depth, default=None)
        return min(found, key=lambda far: far.depth, default=None)

    def _is_before(self, depth, other):
        if self.against:
            return depth > other
        return depth < other

    def note_delays(self):
        """Set the `delay` of Stages."""
        for stage in self.stages.values():
            delays = [
                watch.delay_after(link.watch) for watch in stage.watches for link in self.feeding(stage)
            ]
            stage.delay = min([delay for delay in delays if delay is not None], default=None)

    def _fault_at(self, stage):
        feeding = self.feeding(stage)
        if stage.contexts is None:
            return self._fault_of_values(stage, feeding)
        if not any(context.running for context in stage.contexts):
            return _fault("its execution context is stopped", CERTAIN)
        if stage.state != "Active":
            return _fault(f"it is {stage.state}", CERTAIN)
        cut = [link for link in feeding if not link.joined]
        if cut:
            return _fault(
                f"{ports.label(cut[0].port)} does not know its connection with {cut[0].watch.name}", CERTAIN
            )
        return self._full_buffer(stage, feeding) or self._fault_of_values(stage, feeding)

    def _fault_of_values(self, stage, feeding):
        for watch in stage.watches:
            fault = _fault_of(watch, [link.watch for link in feeding], self._slower())
            if fault is not None:
                return fault
        if stage.delay is not None and stage.delay > self._latest(stage):
            return _fault(f"values come out {stage.delay:.3g} s after they came in", PROBABLE, is_slight=True)
        return None

    def _latest(self, stage):
        """Seconds that a Stage may take with a value: on a busy host all of them take longer."""
        others = sorted(each.delay for each in self.stages.values() if each.delay is not None)
        usual = others[len(others) // 2]
        rate = stage.rate or max((watch.rate for watch in stage.watches), default=0) or 1
        longest = self._slower() * (LATE + CYCLES / rate)
        if others[1:]:
            return max(longest, BUSY * usual)
        return longest

    def _slower(self):
        """How many times slower all stages are than their contexts claim, as far as the first values tell: 1
        to MOST_SLOWER.
        """
        for stage in self.in_order():
            measured = max([watch.rate for watch in stage.watches] or [0])
            if measured:
                return min(max(stage.rate / measured, 1.0), MOST_SLOWER)
        return 1.0

    def buffer(self, stage):
        """What the buffers of a Stage's in ports on the way do with values that they have no room for: one of
        BUFFERS, FULL where they probably find no room; None if that is unknown.
        """
        feeding = self.feeding(stage)
        if stage.contexts is None or not feeding:
            return None
        if self._full_buffer(stage, feeding) is not None:
            return FULL
        policies = {buffers.refusal(link.port) for link in feeding}
        return next(words for policy, words in BUFFERS if policy in policies)

    def _full_buffer(self, stage, feeding):
        """A Fault if values find the buffer of its in port full."""
        for link in feeding:
            policy = buffers.refusal(link.port)
            if not policy or not stage.rate:
                continue
            if stage.rate < THINNED * max(link.watch.rate, self._written(link)):
                return _fault(
                    f"{ports.label(link.port)} {buffers.POLICIES[policy]} ({policy}): it executes at "
                    f"{stage.rate:g} Hz",
                    PROBABLE,
                )
        return None

    def _written(self, link):
        """The rate, in Hz, at which a Link would be written to if nothing held its writer up."""
        writer = next(stage for stage in self.stages.values() if link.watch in stage.watches)
        if buffers.refusal(link.port) == "block":
            return writer.rate
        return 0


async def _bound(near):
    """Nodes of the components that are bound in the name server of a Node."""
    try:
        server = await tree.resolve(near.path._replace(names=(), port=None))
        walked = await tree.walk(server, managers=False)
    except errors.Error:
        return []
    return [node for node in walked if node.kind == "component" and node.ref is not None]


def _fault(words, sure, is_slight=False):
    return Fault(words, sure, is_slight)


def _sure_of(failure):
    """How sure it is, by an errors.Error or a Far, that something does not answer."""
    if failure.why == UNANSWERED:
        return PROBABLE
    return CERTAIN


def _fault_of(watch, feeding, slower):
    """The Fault that the values of a Watch show beside those of the Watches `feeding` its component, or None;
    `slower`: how busy the host is, see Trace._slower.
    """
    if watch.failure is not None:
        return _fault(f"{watch.name} could not be measured: {watch.failure.why}", _sure_of(watch.failure))
    fed = [each for each in feeding if each.count]
    if not watch.count:
        if not feeding:
            if watch.seconds >= LEAST:
                sure = CERTAIN
            else:
                sure = PROBABLE
            return _fault(f"nothing was written to {watch.name} in {watch.seconds:.2g} s", sure)
        if fed and (watch.seconds >= LEAST or watch.seconds * fed[0].rate >= FEW):
            return _fault(f"values come in ({fed[0].rate:.3g} Hz), none goes out of {watch.name}", PROBABLE)
        return None
    disordered = watch.flow.total.disordered
    if disordered and not any(each.flow.total.disordered for each in fed):
        return _fault(f"{disordered} values of {watch.name} are older than the one before", CERTAIN)
    if watch.count >= FEW and not watch.changes and any(each.changes for each in fed):
        return _fault(f"{watch.name} repeats one value, though those that come in change", PROBABLE)
    rate = min([each.rate for each in fed if each.count >= MANY] or [0])
    if watch.count > 1 and watch.rate < THINNED / min(slower, 2) * rate:
        return _fault(
            f"{rate:.3g} Hz come in, {watch.rate:.3g} Hz go out of {watch.name}", PROBABLE, is_slight=True
        )
    return None


async def of_silent(where, error):
    """The Trace from the component at a Path that does not answer, by an errors.Silent: what it waits for."""
    node = await tree.component(where)
    trace = Trace()
    stage = trace.stages[orb.identity(node.ref)] = Stage(node, 0)
    stage.error = error
    await trace.find_cause(stage)
    return trace


async def between(start, to, against, seconds):
    """The Trace from a ports.Port on, `against` the data or with it, measured for `seconds`; with a Port
    `to`, only the ways that lead there.
    """
    trace = Trace(against)
    if to is None:
        await trace.follow(start, seconds)
    else:
        back = Trace(against=True)
        await loop.each([(trace, start), (back, to)], lambda pair: pair[0].follow(pair[1], seconds))
        trace.limit(to, back)
    trace.note_delays()
    return trace
