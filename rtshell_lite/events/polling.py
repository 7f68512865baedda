"""What happens to a component that reports to nobody, as far as asking again and again shows it: states, contexts, configuration.

Only questions are asked that change nothing and that a component answers at once: no profiles, for these make it check all
its connections, and so connections are not watched.
"""
import time

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.events.observer import Event
from rtshell_lite.robot import component
from rtshell_lite.text import from_wire

THOROUGH = 1.0  # seconds between looks at what changes less often than states
SEEN = {"RTC_STATUS", "EC_EVENT", "CONFIG_EVENT"}  # the kinds of events that can be seen


class _Context:
    """What was last seen of an execution context."""

    def __init__(self, node, ref):
        self.ref, self.state, self.rate, self.running = ref, None, None, None
        self.handle = str(node.call("get_context_handle", ref))


class Poll:
    """What was last seen of a component; made with a first look, on a lane. Raises what remote calls raise."""

    def __init__(self, node, kinds):
        self.node, self.where, self.kinds = node, str(node.path), set(kinds)
        self.contexts, self.set, self.configuration = {}, None, None
        self._thorough = None  # when everything was last looked at
        self.look()

    def look(self):
        """The Events since the last look: one call a context, and once a second a few more."""
        first, now = self._thorough is None, time.monotonic()
        found = []
        if first or now - self._thorough >= THOROUGH:
            self._thorough = now
            orb.is_alive(self.where, self.node.ref)
            if self.kinds & {"RTC_STATUS", "EC_EVENT"}:
                found += self._contexts()
            if "CONFIG_EVENT" in self.kinds:
                found += self._configuration()
        if "RTC_STATUS" in self.kinds:
            found += self._states()
        return [] if first else [Event(time.time(), *each) for each in found if each[0] in self.kinds]

    def _contexts(self):
        owned, participating = component.context_refs(self.node)
        refs = {orb.identity(ref): ref for ref in owned + participating}
        for identity in set(self.contexts) - set(refs):
            yield "EC_EVENT", self.contexts.pop(identity).handle, "EC_DETACHED"
        for identity in refs:
            if identity not in self.contexts:
                self.contexts[identity] = _Context(self.node, refs[identity])
                yield "EC_EVENT", self.contexts[identity].handle, "EC_ATTACHED"
        for context in self.contexts.values():
            was = context.running, context.rate
            context.running, context.rate = component.elsewhere(self.node, context.ref, lambda: self._run(context), was)
            if None not in was and was[0] != context.running:
                yield "EC_EVENT", context.handle, "EC_STARTUP" if context.running else "EC_SHUTDOWN"
            if None not in was and was[1] != context.rate:
                yield "EC_EVENT", context.handle, "EC_RATE_CHANGED"

    def _run(self, context):
        if "EC_EVENT" not in self.kinds:
            return None, None
        return bool(orb.ask(self.where, context.ref, "is_running")), orb.ask(self.where, context.ref, "get_rate")

    def _states(self):
        known = list(self.contexts.values())
        for context, state in zip(known, component.states(self.node, [context.ref for context in known])):
            if context.state not in (None, state) and state != "Created":  # so says a context that it has just left
                yield "RTC_STATUS", context.handle, state.upper()
            context.state = state

    def _configuration(self):
        if self.configuration is None:
            self.configuration = self.node.call("get_configuration")
        try:
            active = orb.ask(self.where, self.configuration, "get_active_configuration_set")
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
