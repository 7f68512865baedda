"""Where a signal stops: follows the connections of data ports through components, measures every out port on
the way at the same time, and finds the first stage that stops, holds, thins, delays or disorders the values.

Harmless as rtprint is: one connector a port, made and left by its rules.
"""

import collections

from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.data import clocks, reading, statistics
from rtshell_lite.doctor import buffers, limits
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
# of the seconds asked for, in which all ports are found; in the rest the last ones are measured
FOLLOWED = 0.8
LONGEST = 2  # times those seconds, for which a wait for a processor is added to them
UNANSWERED = "it has not answered in this time"
BUSY = 4  # times what other stages take, before it is the one that is late
SILENT = 0.4  # of the time to find ports in, after which a component that does not answer is silent
ANSWERS = 10  # times what others take for an answer, after which silence means something
MOST_SLOWER = 3  # times what their contexts claim, which stages may take with a value
MOMENT = 0.001  # seconds that are waited at least: what is left may be too little for the clock to move
SLOWED = 2  # times what this process would take on an idle machine, from which on the machine is busy
MOST_THINNED = 5  # times as few values as usual are no fault on a busy machine, at most

# (policy, what a buffer that is full does by it), the one that matters most first
BUFFERS = (("block", "blocks"), ("do_nothing", "refuses"), ("", "replaces"))
FULL = "full"

CERTAIN = "certain"
PROBABLE = "probable"
DOUBTFUL = "doubtful"  # a stage that does well would look the same, as this machine or others are slow

# What is wrong at a Stage: in words; CERTAIN, PROBABLE or DOUBTFUL; whether it is only that values are fewer
# or later.
Fault = collections.namedtuple("Fault", "words sure is_slight")

# A connection from a Watch to the in port `port` of a Stage. `joined`: the in port knows of it, too.
Link = collections.namedtuple("Link", "watch stage port joined")


# A component that does not answer, or is bound nowhere: its path, or that of the port `near` it; how many
# connections it is away; the errors.Error.
Far = collections.namedtuple("Far", "where depth near error")


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
        self.begun = self.until = 0  # when that began and ended, ns since 1970
        self._is_stamped = clocks.is_stamped(port)
        self._last = None

    def take(self, message):
        """Count a reading.Message."""
        stamp = 0
        data = message.data
        if self._is_stamped and len(data) >= STAMP:
            stamp = clocks.moment(data, message.little)
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

    def came(self, begin, end):
        """How many values came between two moments, in ns since 1970."""
        width = self.counts.width
        return sum(count for span, count in self.counts.spans.items() if begin <= span * width < end)

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
        self.contexts = None  # component.Contexts; None if unknown, as in a recording
        self.answer = 0.0  # seconds that it took for an answer, in the mean
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
        self.slower = 1.0  # times that all takes longer than on an idle machine; 1 where it is not busy
        self.patience = 0.0  # seconds that an answer is waited for
        self._following = self._measuring = None  # loop.Groups

    async def follow(self, start, to, seconds):
        """Follow the connections from a ports.Port and measure, for `seconds` in all; with a Port `to`, keep
        what leads there. A wait for a processor is added to the seconds.
        """
        now = session.current()
        patience = now.timeout
        clock = _Clock(seconds)
        following = max(FOLLOWED * seconds, 2 * LEAST)
        # who is silent, and what that one waits for, is to be found out in the seconds
        self.patience = now.timeout = min(patience, SILENT * following)
        try:
            async with loop.Group() as self._measuring:
                await self._find(start, clock, following)
                if to is not None:
                    await self._limit(to, clock, following)
                await clock.reach(max(seconds, clock.passed() + (1 - FOLLOWED) * seconds))
                self._measuring.cancel()
        finally:
            now.timeout = patience
            self.slower = _slowdown()

    async def _find(self, start, clock, seconds):
        """Follow all connections from a ports.Port, to the end or until `seconds` are over."""
        async with loop.background(self._give_up(clock, seconds)):
            async with loop.Group() as self._following:
                self._enter(tree.Node(start.node.path, "component", start.node.ref), 0, start)

    async def _give_up(self, clock, seconds):
        """Follow no further after some seconds."""
        await clock.reach(seconds)
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
        begun = loop.now()
        try:
            listed = await _ports_of(stage.node)
        except errors.Error as e:
            self._fail(stage, e)
            return
        stage.error = None
        stage.answer = (loop.now() - begun) / (1 + len(listed))
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
        if self._measuring is not None:
            services = [port for port in listed if port.type == "CorbaPort"]
            self._following.start(self._look_closer(stage, services), stage.node.endpoint)
        await self._go_on(stage, ins if self.against else outs)

    async def _look_closer(self, stage, services):
        """Learn what is not needed to go on."""
        running = snapshot.RUNNING
        try:
            shown = await snapshot.of(stage.node, owned=running, participating=running, states=snapshot.FULL)
            stage.state = component.merged(shown.states)
            stage.contexts = shown.contexts
            await self._show_services(stage, services)
        except errors.Error as e:
            self._fail(stage, e)

    def _fail(self, stage, error):
        stage.error = error
        if isinstance(error, errors.Silent) and self._measuring is not None:
            self._measuring.start(self.find_cause(stage))

    def _watch(self, stage, port):
        if any(watch.port.name == port.name for watch in stage.watches):
            return
        watch = Watch(port)
        stage.watches.append(watch)
        if self._measuring is not None:
            self._measuring.start(self._measure(watch), orb.endpoint(port.ref))

    async def _measure(self, watch):
        """Take the values of a Watch until this task is cancelled."""
        watch.failure = errors.Silent(watch.name, UNANSWERED)
        try:
            async with reading.Reader(watch.port, watch.take, name="rtshell_lite") as reader:
                begun = loop.now()
                watch.begun = int(loop.wall() * 1e9)
                watch.failure = None
                try:
                    await loop.Wait()
                finally:
                    watch.seconds = loop.now() - begun
                    watch.until = int(loop.wall() * 1e9)
                    watch.failure = reader.failure
        except errors.Error as e:
            watch.failure = e

    async def _show_services(self, stage, listed):
        connected = [port for port in listed if port.connectors]
        if connected:
            name_of = await places.far_names(connected)
            for port in connected:
                names = {name_of(ref) for connector in port.connectors for ref in connector.ports} - {None}
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
            self.silent.append(Far(where or ports.label(port), stage.depth + 1, ports.label(port), end.error))
            return
        if end.port.node is None:
            where = ports.label(port)
            error = errors.Failed(where, f"{places.name(end)} is bound nowhere")
            self.silent.append(Far(where, stage.depth + 1, where, error))
            return
        far = self._enter(end.port.node, stage.depth + 1)
        if far is None:
            return
        joined = any(other.id == connector.id for other in end.port.connectors)
        if not self.against:
            watch = next(watch for watch in stage.watches if watch.port.name == port.name)
            self.links.append(Link(watch, far, end.port, joined))
            return
        far_port = end.port._replace(node=far.node)
        self._watch(far, far_port)
        watch = next(watch for watch in far.watches if watch.port.name == far_port.name)
        self.links.append(Link(watch, stage, port, joined))

    async def find_cause(self, stage):
        """Note what a Stage waits for, if it lives: asked for its ports, it asks their far ends."""
        session.current().ask_again(stage.node.endpoint)  # its process may answer smaller questions
        others = [node for node in await _bound(stage.node) if node.endpoint != stage.node.endpoint]
        *others, itself = await tree.check_alive(others + [stage.node])
        silent = [node for node in others if isinstance(node.error, errors.Silent)]
        if len({node.endpoint for node in silent}) == 1 and itself.kind != "silent":
            stage.error = errors.Silent(stage.where, f"it waits for {silent[0].path}, which does not answer")
            error = errors.Silent(str(silent[0].path), "it does not answer")
            self.silent.append(Far(str(silent[0].path), stage.depth, stage.where, error))

    async def _bound_there(self, ref, near):
        """The path, as text, of the only component bound with the address of a reference, or the only one of
        them that does not answer; None if unknown.
        """
        endpoint = orb.endpoint(ref)
        bound = [node for node in await _bound(near) if orb.endpoint(node.ref) == endpoint]
        if len(bound) > 1:
            bound = [node for node in await tree.check_alive(bound) if isinstance(node.error, errors.Silent)]
        return str(bound[0].path) if len(bound) == 1 else None

    async def _limit(self, to, clock, seconds):
        """`limit` to a Port; where no way leads there, the one from there is followed against the data."""
        where = str(to.node.path)
        back = Trace(against=True)
        if not self.is_cut and not any(stage.where == where for stage in self.stages.values()):
            await back._find(to, clock, seconds)
        self.limit(where, back)

    def limit(self, where, back):
        """Keep what leads to the component with a path. Where no way leads there, all that has been found is
        kept, and the gap to what `back` has found, the Trace from there against the data, is a fault.
        """
        ends = [stage for stage in self.stages.values() if stage.where == where]
        if not ends:
            if back.stages:
                self.gap = max(back.stages.values(), key=lambda stage: stage.depth).where
            return
        kept = set(ends)
        for _ in self.stages:
            kept |= {stage for stage in self.stages.values() if self._leads_to(stage, kept)}
        self.stages = collections.OrderedDict(
            (identity, stage) for identity, stage in self.stages.items() if stage in kept
        )
        self.links = [link for link in self.links if link.stage in kept]

    def _leads_to(self, stage, kept):
        return any(link.stage in kept and link.watch in stage.watches for link in self.links)

    # ---- judging ----

    def in_order(self):
        """The Stages, those where data comes from first."""
        return sorted(self.stages.values(), key=lambda stage: stage.depth, reverse=self.against)

    def feeding(self, stage):
        """The Links that lead to a Stage."""
        return [link for link in self.links if link.stage is stage]

    def culprit(self):
        """(path of a component, Fault) of the first that does not pass values on, or of the first that does
        so slowly; None if all do; (None, Fault) where that is DOUBTFUL.

        What hangs or is dead explains why those around it seem to stop values.
        """
        faults = [(stage.where, fault, stage.depth) for stage, fault in self._faults() if fault is not None]
        if not faults and self.gap is not None:
            last = self.in_order()[-1]
            fault = _fault(f"no connection leads on from it to {self.gap}", CERTAIN)
            faults.append((last.where, fault, last.depth))
        silences = list(self._silences())
        first = min(_sure(faults), key=lambda fault: fault[1].is_slight, default=None)
        silent = min(_sure(silences), key=self._depth, default=None)
        if silent is not None:
            if first is None or first[1].sure == PROBABLE or self._depth(silent) < self._depth(first):
                first = silent
        if first is not None:
            return first[:2]
        if faults or silences or self.is_cut:
            return None, _fault(self._why_doubtful(), DOUBTFUL)
        return None

    def _why_doubtful(self):
        if self.slower > 1:
            return f"this machine is too busy to tell: everything takes {self.slower:.0f} times as long"
        return "not all components answered in this time"

    def _depth(self, fault):
        """Where data comes first, as a number."""
        return -fault[2] if self.against else fault[2]

    def _faults(self):
        for stage in self.in_order():
            if stage.error is None:
                yield stage, self._fault_at(stage)

    def _silences(self):
        """(path, Fault, depth) of each component that does not answer."""
        for far in self.silent:
            if isinstance(far.error, errors.Unreachable):  # one that is bound nowhere may do well
                yield far.where, _fault(far.error.why, self._how_sure(far.error)), far.depth
        for stage in self.stages.values():
            if stage.error is not None:
                yield stage.where, _fault(stage.error.why, self._how_sure(stage.error)), stage.depth

    def _how_sure(self, error):
        """How sure an errors.Error shows that something does not answer."""
        if not isinstance(error, errors.Silent):
            return CERTAIN
        others = max((stage.answer for stage in self.stages.values()), default=0)
        needed = ANSWERS * others if others else LEAST * self.slower
        if error.why == UNANSWERED or self.patience < needed:
            return DOUBTFUL
        return CERTAIN

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
            if any(context.running is None for context in stage.contexts):
                return _fault("its execution context does not answer", PROBABLE)
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
            fault = self._fault_of(watch, [link.watch for link in feeding], stage)
            if fault is not None:
                return fault
        if stage.delay is None:
            return None
        late = _fault(f"values come out {stage.delay:.3g} s after they came in", PROBABLE, is_slight=True)
        if stage.delay > self._latest(stage):
            return late
        if stage.delay > self._usual(stage):
            return self._doubt(late)
        return None

    def _fault_of(self, watch, feeding, stage):
        """The Fault that the values of a Watch show beside those of the Watches `feeding` its Stage, or
        None.
        """
        if watch.failure is not None:
            fault = f"{watch.name} could not be measured: {watch.failure.why}"
            return _fault(fault, self._how_sure(watch.failure))
        fed = [source for source in feeding if source.count]
        if not watch.count:
            return self._silence_of(watch, feeding, stage)
        disordered = watch.flow.total.disordered
        if disordered and not any(source.flow.total.disordered for source in fed):
            return _fault(f"{disordered} values of {watch.name} are older than the one before", CERTAIN)
        if watch.count >= FEW and not watch.changes and any(source.changes for source in fed):
            return _fault(f"{watch.name} repeats one value, though those that come in change", PROBABLE)
        return self._thinned(watch, fed)

    def _silence_of(self, watch, feeding, stage):
        """A Fault if values should have come from a Watch."""
        if not feeding:
            nothing = _fault(f"nothing was written to {watch.name} in {watch.seconds:.2g} s", CERTAIN)
            if watch.seconds >= LEAST * self.slower:
                return nothing
            return self._doubt(nothing) or nothing._replace(sure=PROBABLE)
        for source in feeding:
            fault = _fault(f"values come in ({source.rate:.3g} Hz), none goes out of {watch.name}", PROBABLE)
            if source.came(watch.begun, watch.until - int(self._latest(stage) * 1e9)):
                return fault
            if source.came(watch.begun, watch.until - int(self._usual(stage) * 1e9)):
                return self._doubt(fault)
        return None

    def _thinned(self, watch, fed):
        """A Fault if fewer values come from a Watch than from each of those that feed its Stage."""
        shares = []
        for source in fed:
            begin = max(watch.begun, source.begun)
            came = source.came(begin, source.until)
            if came >= MANY:
                shares.append((watch.came(begin, watch.until) / came, source.rate))
        share, rate = max(shares, default=(1, 0))
        if share >= THINNED:
            return None
        fault = _fault(
            f"{rate:.3g} Hz come in, {watch.rate:.3g} Hz go out of {watch.name}", PROBABLE, is_slight=True
        )
        if share < THINNED / min(self.slower, MOST_THINNED):
            return fault
        return self._doubt(fault)

    def _doubt(self, fault):
        """A Fault that a busy machine may explain; None where it is not busy."""
        return fault._replace(sure=DOUBTFUL) if self.slower > 1 else None

    def _usual(self, stage):
        """Seconds that a Stage may take with a value."""
        rate = stage.rate or max((watch.rate for watch in stage.watches), default=0) or 1
        return self._claimed() * (LATE + CYCLES / rate)

    def _latest(self, stage):
        """`_usual`, but on this machine now: where it is busy all of them take longer."""
        usual = self._usual(stage)
        others = [
            other.delay for other in self.stages.values() if other is not stage and other.delay is not None
        ]
        if others[1:]:
            return max(usual, BUSY * sorted(others)[len(others) // 2])
        return usual * self.slower

    def _claimed(self):
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
        return writer.rate if buffers.refusal(link.port) == "block" else 0


async def _ports_of(node):
    """The Ports of a component, without connectors of tools. Raises the first errors.Error."""

    async def ask(ref):
        return await ports.port(node, ref)

    listed = await loop.each(await ports.refs(node), ask)
    for port in listed:
        if isinstance(port, errors.Error):
            raise port
    return ports.in_system(listed)


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


def _sure(faults):
    """Those of some (path, Fault, depth) that are not DOUBTFUL."""
    return [fault for fault in faults if fault[1].sure != DOUBTFUL]


def _slowdown():
    """How many times longer all takes than on an idle machine, 1 where this one is not busy."""
    slower = limits.slowdown()
    return 1.0 if slower < SLOWED else slower


class _Clock:
    """Seconds from now on, without those for which this process waits for a processor: at most LONGEST times
    the `seconds` of a trace.
    """

    def __init__(self, seconds):
        self._begun = loop.now()
        self._starved = limits.starved()
        self._longest = LONGEST * seconds

    def passed(self):
        """The seconds that have passed."""
        waited = min(limits.starved() - self._starved, self._longest)
        return loop.now() - self._begun - waited

    async def reach(self, seconds):
        """Wait until these seconds have passed."""
        while self.passed() < seconds:
            await loop.pass_by(max(seconds - self.passed(), MOMENT))


async def of_silent(where, error):
    """The Trace from the component at a Path that does not answer, by an errors.Silent: what it waits for."""
    node = await tree.component(where)
    trace = Trace()
    trace.patience = session.current().timeout
    stage = trace.stages[orb.identity(node.ref)] = Stage(node, 0)
    stage.error = error
    await trace.find_cause(stage)
    trace.slower = _slowdown()
    return trace


async def between(start, to, against, seconds):
    """The Trace from a ports.Port on, `against` the data or with it, measured for `seconds`; with a Port
    `to`, only the ways that lead there.
    """
    trace = Trace(against)
    await trace.follow(start, to, seconds)
    trace.note_delays()
    return trace
