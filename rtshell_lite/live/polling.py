"""Events of a component that takes no observer, as far as polling shows them: states, contexts,
configuration.

Only questions are asked that change nothing and that a component answers at once: no profiles, as these make
it check all its connections; so connections are not watched.
"""


from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.live import times
from rtshell_lite.live.observer import Event
from rtshell_lite.net import loop
from rtshell_lite.robot import snapshot
from rtshell_lite.text import from_wire

SEEN = {"RTC_STATUS", "EC_EVENT", "CONFIG_EVENT"}  # the kinds of events that polling shows


class _Seen:
    """What was last seen of an execution context."""

    def __init__(self, identity, handle):
        self.identity = identity
        self.handle = handle
        self.state = self.rate = self.running = None


async def begin(node, kinds):
    """A Poll of a component, with a first look. Raises what remote calls raise."""
    poll = Poll(node, kinds)
    await poll.changes()
    return poll


class Poll:
    """What was last seen of a component."""

    def __init__(self, node, kinds):
        self.node = node
        self.where = str(node.path)
        self.kinds = set(kinds)
        # of its contexts, and a _Seen of each
        self.snapshot = snapshot.Snapshot(node)
        self.seen = []
        self.set = None
        self.configuration = None
        self._thorough = None  # when everything was last looked at

    async def changes(self):
        """The Events since the last look, none at the first.
        One call a context, and a few more once a second.
        """
        first = self._thorough is None
        now = loop.now()
        news = []
        if first or now - self._thorough >= times.THOROUGH:
            self._thorough = now
            await orb.is_alive(self.node.path, self.node.ref)
            if self.kinds & {"RTC_STATUS", "EC_EVENT"}:
                news += await self._contexts()
            if "CONFIG_EVENT" in self.kinds:
                news += await self._configuration()
        if "RTC_STATUS" in self.kinds:
            news += await self._states()
        if first:
            return []
        return [Event(loop.wall(), *item) for item in news if item[0] in self.kinds]

    async def _contexts(self):
        detail = snapshot.RUNNING if "EC_EVENT" in self.kinds else snapshot.REFERENCES
        await self.snapshot.ask(owned=detail, participating=detail)
        before = {seen.identity: seen for seen in self.seen}
        news = []
        now = []
        for context in self.snapshot.contexts:
            identity = orb.identity(context.ref)
            seen = before.get(identity)
            if seen is None:
                seen = _Seen(identity, str(await self.node.call("get_context_handle", context.ref)))
                news.append(("EC_EVENT", seen.handle, "EC_ATTACHED"))
            news += _run_events(seen, context)
            now.append(seen)
        self.seen = now
        left = set(before) - {seen.identity for seen in now}
        return [("EC_EVENT", before[identity].handle, "EC_DETACHED") for identity in left] + news

    async def _states(self):
        await self.snapshot.ask(states=snapshot.FULL)
        news = []
        for seen, state in zip(self.seen, self.snapshot.states):
            # a context that it has just left answers that
            if seen.state not in (None, state) and state != "Created":
                news.append(("RTC_STATUS", seen.handle, state.upper()))
            seen.state = state
        return news

    async def _configuration(self):
        if self.configuration is None:
            self.configuration = await self.node.call("get_configuration")
        try:
            active = await orb.call(self.where, self.configuration, "get_active_configuration_set")
        except errors.Refused:  # NotAvailable: somebody is about to activate one
            return []
        was = self.set
        self.set = (from_wire(active.id), orb.properties(active.configuration_data))
        if was is None:
            return []
        name, values = self.set
        if was[0] != name:
            return [("CONFIG_EVENT", name, "CFG_ACTIVATE_SET")]
        changed = []
        for parameter, value in values:
            if (parameter, value) not in was[1]:
                changed.append(parameter)
        return [("CONFIG_EVENT", f"{name}.{parameter}", "CFG_UPDATE_PARAM") for parameter in changed]


def _run_events(seen, context):
    """What has changed since a _Seen, which is updated."""
    if context.running is None:  # it does not answer
        return
    before = seen.running, seen.rate
    seen.running = context.running
    seen.rate = context.rate
    if None in before:
        return
    if before[0] != seen.running:
        if seen.running:
            yield "EC_EVENT", seen.handle, "EC_STARTUP"
        else:
            yield "EC_EVENT", seen.handle, "EC_SHUTDOWN"
    if before[1] != seen.rate:
        yield "EC_EVENT", seen.handle, "EC_RATE_CHANGED"
