"""Events of a component that takes no observer, as far as polling shows them: states, contexts, configuration.

Only questions are asked that change nothing and that a component answers at once: no profiles, as these make it check all its
connections; so connections are not watched.
"""
import time

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.events.observer import Event
from rtshell_lite.robot import snapshot
from rtshell_lite.text import from_wire

THOROUGH = 1.0  # seconds between looks at what changes less often than states
SEEN = {"RTC_STATUS", "EC_EVENT", "CONFIG_EVENT"}  # the kinds of events that polling shows


class _Seen:
    """What was last seen of an execution context."""

    def __init__(self, node, ref):
        self.identity, self.handle = orb.identity(ref), str(node.call("get_context_handle", ref))
        self.state = self.rate = self.running = None


class Poll:
    """What was last seen of a component; created on a lane, with a first look. Raises what remote calls raise."""

    def __init__(self, node, kinds):
        self.node, self.where, self.kinds = node, str(node.path), set(kinds)
        self.snapshot, self.seen = snapshot.Snapshot(node), []  # of its contexts, and a _Seen of each
        self.set, self.configuration = None, None
        self._thorough = None  # when everything was last looked at
        self.look()

    def look(self):
        """The Events since the last look: one call a context, and once a second a few more."""
        first, now = self._thorough is None, time.monotonic()
        news = []
        if first or now - self._thorough >= THOROUGH:
            self._thorough = now
            orb.is_alive(self.where, self.node.ref)
            if self.kinds & {"RTC_STATUS", "EC_EVENT"}:
                news += self._contexts()
            if "CONFIG_EVENT" in self.kinds:
                news += self._configuration()
        if "RTC_STATUS" in self.kinds:
            news += self._states()
        return [] if first else [Event(time.time(), *item) for item in news if item[0] in self.kinds]

    def _contexts(self):
        detail = snapshot.RUNNING if "EC_EVENT" in self.kinds else snapshot.REFERENCES
        self.snapshot.ask(owned=detail, participating=detail)
        before = {seen.identity: seen for seen in self.seen}
        now = [(orb.identity(context.ref), context) for context in self.snapshot.contexts]
        self.seen = [before.get(identity) or _Seen(self.node, context.ref) for identity, context in now]
        for identity in set(before) - {identity for identity, _ in now}:
            yield "EC_EVENT", before[identity].handle, "EC_DETACHED"
        for seen in self.seen:
            if seen.identity not in before:
                yield "EC_EVENT", seen.handle, "EC_ATTACHED"
        for seen, (_, context) in zip(self.seen, now):
            yield from _run_events(seen, context)

    def _states(self):
        self.snapshot.ask(states=snapshot.FULL)
        for seen, state in zip(self.seen, self.snapshot.states):
            if seen.state not in (None, state) and state != "Created":  # a context that it has just left answers that
                yield "RTC_STATUS", seen.handle, state.upper()
            seen.state = state

    def _configuration(self):
        if self.configuration is None:
            self.configuration = self.node.call("get_configuration")
        try:
            active = orb.call(self.where, self.configuration, "get_active_configuration_set")
        except errors.Refused:  # NotAvailable: somebody is about to activate one
            return
        was, self.set = self.set, (from_wire(active.id), orb.properties(active.configuration_data))
        if was is None:
            return
        if was[0] != self.set[0]:
            yield "CONFIG_EVENT", self.set[0], "CFG_ACTIVATE_SET"
        else:
            for name, value in self.set[1]:
                if (name, value) not in was[1]:
                    yield "CONFIG_EVENT", f"{self.set[0]}.{name}", "CFG_UPDATE_PARAM"


def _run_events(seen, context):
    """What has changed since a _Seen, which is updated."""
    if context.running is None:  # it does not answer
        return
    before, (seen.running, seen.rate) = (seen.running, seen.rate), (context.running, context.rate)
    if None in before:
        return
    if before[0] != seen.running:
        yield "EC_EVENT", seen.handle, "EC_STARTUP" if seen.running else "EC_SHUTDOWN"
    if before[1] != seen.rate:
        yield "EC_EVENT", seen.handle, "EC_RATE_CHANGED"
