"""What components are asked that they do not report, by all that follow them: small questions, each about one
context, one set or one port, whose answers are Events.

Only what a component answers at once, and without asking others: no profile of a component or of a known
port, as these make it look after all its connections (docs/protocol.md 1.1). What it was like before is in a
Seen. A reader of this, a follow.Presence, has a table `asks` of the kinds of questions that it puts to each
process, and how often.
"""

import collections
import functools

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.live import times
from rtshell_lite.live.observer import Event
from rtshell_lite.net import loop
from rtshell_lite.robot import component, ports
from rtshell_lite.text import from_wire


class _Context:
    """An execution context as it was last seen; None stands for what is not known."""

    __slots__ = ("ref", "identity", "handle", "state", "rate", "running", "silent_until")

    def __init__(self, ref, handle, state=None, rate=None, running=None):
        self.ref = ref
        self.identity = orb.identity(ref)
        self.handle = handle
        self.state = state
        self.rate = rate
        self.running = running
        self.silent_until = 0.0  # one of another process, which has not answered: when it is asked again


class _Port:
    """A port as it was last seen."""

    __slots__ = ("ref", "identity", "name", "owner", "ids", "connections", "patience")

    def __init__(self, port):
        """`port`: a ports.Port."""
        self.ref = port.ref
        self.identity = orb.identity(port.ref)
        self.name = port.name
        self.owner = port.owner and orb.identity(port.owner)  # of its component, as far as that is known
        self.patience = times.Patience()
        self.take(port.connectors)

    def take(self, connectors):
        """Take its ports.Connectors."""
        self.ids = [connector.id for connector in connectors]  # with those of tools
        self.connections = _connections(connectors)


class Seen:
    """What was last seen of a component.

    node           its Node; `where` its path as text
    asks_port      asks_port(port): whether one of its `ports` is to be asked for its connections
    has_handles    whether the handles of its contexts are asked for, which Events name
    owned          its execution contexts, None where these are not known; `participating`: those of others
                   that it takes part in
    set            (its active configuration set, {parameter: value}), None where that is not known;
                   `has_sets`: whether it may have one
    ports          its ports, None where these are not to be known
    """

    def __init__(self, node, asks_port, has_handles=True):
        self.node = node
        self.where = str(node.path)
        self.asks_port = asks_port
        self.has_handles = has_handles
        self.identity = orb.identity(node.ref)
        self.owned = self.participating = None  # type: list
        self.set = None
        self.has_sets = True
        self.ports = None  # type: list
        self._configuration = None

    @property
    def contexts(self):
        """All, each once: one may be in both lists."""
        return list(collections.OrderedDict.fromkeys([*(self.owned or ()), *(self.participating or ())]))

    @property
    def state(self):
        """Its state over all contexts that have answered, or Unknown."""
        return component.merged([context.state for context in self.contexts if not context.silent_until])

    def take(self, shown, parts):
        """Take what a snapshot.Snapshot has been told of "contexts", "state", "configuration" or "ports"."""
        if "contexts" in parts:
            contexts = {}  # type: dict
            self.owned = [_shown(context, contexts) for context in shown.owned]
            self.participating = [_shown(context, contexts) for context in shown.participating]
        if "contexts" in parts or "state" in parts:
            states = zip(shown.contexts, shown.states)
            state_in = {orb.identity(context.ref): state for context, state in states}
            for context in self.contexts:
                context.state = state_in.get(context.identity, context.state)
        if "configuration" in parts:
            self._take_sets(shown.configuration)
        if "ports" in parts:
            self.take_ports(shown.ports)

    def _take_sets(self, configuration):
        self.has_sets = configuration is not None
        self.set = None
        if not self.has_sets:
            return
        self._configuration = configuration.ref
        if not configuration.active:
            self.set = "", {}
        elif configuration.active in configuration.raw:  # else it has been made since they were listed
            self.set = configuration.active, configuration.set(configuration.active, True).values

    def take_ports(self, listed):
        """Take its ports.Ports."""
        self.ports = [_Port(port) for port in listed]

    def expect(self, state):
        """It was brought to this state: where it is in another one, that is an Event."""
        for context in self.contexts:
            context.state = state

    def wait_no_more(self):
        """What held up its ports may be over."""
        for port in self.ports or ():
            port.patience.end()

    async def look(self, kinds):
        """Put all questions of these kinds, for a first look. Raises what remote calls raise."""
        for kind in kinds:
            for question in kind(self):
                await question()

    # ---- the questions: each returns Events ----

    async def _which_owned(self):
        self.owned, news = await self._which(self.owned, await component.owned_context_refs(self.node))
        return news

    async def _which_participating(self):
        refs = await component.participating_context_refs(self.node)
        self.participating, news = await self._which(self.participating, refs)
        return news

    async def _which(self, before, refs):
        """(the contexts of these references, the Events of those that have come and gone)"""
        contexts = {context.identity: context for context in self.contexts}
        news = []
        now = []
        for ref in refs:
            context = contexts.get(orb.identity(ref))
            if context is None:
                handle = ""
                if self.has_handles:
                    handle = str(await self.node.call("get_context_handle", ref))
                context = _Context(ref, handle)
                news.append(_event("EC_EVENT", context.handle, "EC_ATTACHED"))
            now.append(context)
        if before is None:
            return now, []
        gone = [context for context in before if context not in now]
        return now, [_event("EC_EVENT", context.handle, "EC_DETACHED") for context in gone] + news

    async def _state(self, context):
        before = context.state
        state = await self._of_context(context, component.state_in(self.node, context.ref))
        if state in (None, before) or before and state == "Created":  # one that it has just left answers that
            return []
        context.state = state
        return [_event("RTC_STATUS", context.handle, state.upper())] if before else []

    async def _rate(self, context):
        before = context.rate
        rate = await self._of_context(context, orb.call(self.node.path, context.ref, "get_rate"))
        if rate in (None, before):
            return []
        context.rate = rate
        if before is None:
            return []
        return [_event("EC_EVENT", context.handle, "EC_RATE_CHANGED")]

    async def _runs(self, context):
        before = context.running
        runs = await self._of_context(context, component.is_running(self.node, context.ref))
        if runs in (None, before):
            return []
        context.running = runs
        if before is None:
            return []
        return [_event("EC_EVENT", context.handle, "EC_STARTUP" if runs else "EC_SHUTDOWN")]

    async def _of_context(self, context, asked):
        """The answer of a context, None where it is another process's, which does not answer."""
        answer = await component.or_default(self.node, context.ref, asked, None)
        context.silent_until = 0.0 if answer is not None else loop.now() + times.REST
        return answer

    async def _active_set(self):
        try:
            if self._configuration is None:
                self._configuration = await self.node.call("get_configuration")
            path = self.node.path
            active = await orb.call(path, self._configuration, "get_active_configuration_set")
        except errors.Refused:  # NotAvailable: somebody is about to activate one, or has forgotten to
            if self.set is not None and self.set[0]:
                raise
            return []
        before = self.set
        name, values = self.set = from_wire(active.id), dict(orb.properties(active.configuration_data))
        if before is None:
            return []
        if before[0] != name:
            return [_event("CONFIG_EVENT", name, "CFG_ACTIVATE_SET")]
        changed = [parameter for parameter in values if values[parameter] != before[1].get(parameter)]
        return [_event("CONFIG_EVENT", f"{name}.{parameter}", "CFG_UPDATE_PARAM") for parameter in changed]

    async def _which_ports(self):
        gone = {port.identity: port for port in self.ports}
        news = []
        now = []
        for ref in await ports.refs(self.node):
            port = gone.pop(orb.identity(ref), None)
            if port is None:
                port = _Port(await ports.port(self.node, ref, brief=True))
                news.append(_event("PORT_EVENT", port.name, "PORT_ADD"))
            now.append(port)
        self.ports = now
        return [_event("PORT_EVENT", port.name, "PORT_REMOVE") for port in gone.values()] + news

    async def _connections_of(self, port):
        path = self.node.path
        try:
            profiles = await component.once_more(
                lambda: orb.call(path, port.ref, "get_connector_profiles"), None
            )
        except errors.Silent:
            port.patience.wait()
            raise
        port.patience.end()
        connectors = [ports.connector(profile, path) for profile in profiles[: ports.MOST_PARTS]]
        before = port.connections
        port.take(connectors)
        now = port.connections
        lost = [connector_id for connector_id in before if now.get(connector_id) != before[connector_id]]
        added = [connector_id for connector_id in now if now[connector_id] != before.get(connector_id)]
        words = len(lost) * ["PORT_DISCONNECT"] + len(added) * ["PORT_CONNECT"]
        return [_event("PORT_EVENT", port.name, word) for word in words]


def _shown(context, contexts):
    """The _Context of a component.Context; `contexts`: those of others, by identity, and this one then."""
    identity = orb.identity(context.ref)
    if identity not in contexts:
        contexts[identity] = _Context(context.ref, str(context.handle), None, context.rate, context.running)
    return contexts[identity]


def _event(*words):
    return Event(loop.wall(), *words)


def _connections(connectors):
    """{id of a connector: what differs where it is made again under that id}: its ends, and the references
    of what was made to carry its data. Those of tools are no part of the system.
    """
    seen = {}
    for connector in connectors:
        if not ports.is_of_tool(connector):
            ends = [orb.identity(end) for end in connector.ports if end is not None]
            carriers = [value for _, value in connector.properties if value.startswith("IOR:")]
            seen[connector.id] = ends, carriers
    return seen


def _awake(seen):
    """The contexts of a Seen without those that have just not answered."""
    now = loop.now()
    return [context for context in seen.contexts if context.silent_until <= now]


# ---- the kinds of questions: functions that yield those to a component ----


def states(seen):
    """In which state it is, in each context."""
    for context in _awake(seen):
        yield functools.partial(seen._state, context)


def contexts(seen):
    """In which contexts it is, and how these run."""
    yield seen._which_owned
    yield seen._which_participating
    for context in _awake(seen):
        yield functools.partial(seen._rate, context)
        yield functools.partial(seen._runs, context)


def configuration(seen):
    """Its active configuration set."""
    if seen.has_sets:
        yield seen._active_set


def which_ports(seen):
    """Which ports it has."""
    if seen.ports is not None:
        yield seen._which_ports


def connections(seen):
    """What its ports are connected with."""
    now = loop.now()
    for port in filter(seen.asks_port, seen.ports or ()):
        if now >= port.patience.until:
            yield functools.partial(seen._connections_of, port)


# {kind of question: the kind of the Events that its answers show}
SHOWS = {
    states: "RTC_STATUS", contexts: "EC_EVENT", configuration: "CONFIG_EVENT", which_ports: "PORT_EVENT",
    connections: "PORT_EVENT",
}
