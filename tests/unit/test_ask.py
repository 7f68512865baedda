"""What followers of components make of the answers to their small questions. If this fails, rtkeep mends
nothing where nobody reports it, and rtwatch and recordings lack events.
"""
import types
import unittest
from unittest import mock

from rtshell_lite.corba import orb, session
from rtshell_lite.live import ask
from rtshell_lite.net import loop
from rtshell_lite.robot import component, ports


class Component:
    """What a component answers: `contexts` {reference: [state, rate, whether it runs]}, `connectors` of its
    ports {reference: [Connector]}.
    """

    def __init__(self):
        self.contexts = {"own": ["Inactive", 100.0, True], "composite's": ["Inactive", 50.0, True]}
        self.connectors = {"in": [], "out": []}
        self.node = types.SimpleNamespace(path="/a:1/x.rtc", ref="x", call=self.call)
        self.seen = ask.Seen(self.node, lambda port: True)

    async def call(self, operation, ref):
        return list(self.contexts).index(ref)

    async def owned(self, node):
        return [ref for ref in self.contexts if ref != "composite's"]

    async def participating(self, node):
        return [ref for ref in self.contexts if ref == "composite's"]

    async def state_in(self, node, ref):
        return self.contexts[ref][0]

    async def runs(self, node, ref):
        return self.contexts[ref][2]

    async def port_refs(self, node):
        return list(self.connectors)

    async def port(self, node, ref):
        return types.SimpleNamespace(ref=ref, name=ref, owner=None, connectors=self.connectors[ref])

    async def called(self, path, ref, operation):
        if operation == "get_rate":
            return self.contexts[ref][1]
        assert operation == "get_connector_profiles"
        return self.connectors[ref]


class Answers(unittest.TestCase):
    def setUp(self):
        self.patch(orb, "identity", lambda ref: ref)
        self.component = asked = Component()
        for module, name, function in (
            (orb, "call", asked.called), (component, "is_running", asked.runs),
            (component, "owned_context_refs", asked.owned), (component, "state_in", asked.state_in),
            (component, "participating_context_refs", asked.participating),
            (component, "or_default", lambda node, ref, it, none: it), (ports, "refs", asked.port_refs),
            (ports, "port", asked.port), (ports, "connector", lambda profile, path: profile),
            (ports, "is_of_tool", lambda connector: connector.id == "tool"),
        ):
            self.patch(module, name, function)
        self.look(ask.contexts, ask.states, ask.which_ports, ask.connections)

    def patch(self, module, name, function):
        patch = mock.patch.object(module, name, function)
        patch.start()
        self.addCleanup(patch.stop)

    def look(self, *kinds):
        """The (kind, subject, event) of the events that the questions of these kinds show."""
        async def put_all():
            found = []
            for kind in kinds:
                for question in kind(self.component.seen):
                    found += await question()
            return [tuple(event)[1:] for event in found]
        return loop.run(put_all(), session=session.Session(1.0))

    def connect(self, port, connector_id, far):
        connector = types.SimpleNamespace(id=connector_id, ports=[port, far], properties=[])
        self.component.connectors[port] = [connector]

    def test_nothing_where_nothing_changes(self):
        self.assertEqual(self.look(ask.contexts, ask.states, ask.which_ports, ask.connections), [])

    def test_a_state_in_any_context(self):
        self.component.contexts["composite's"][0] = "Error"
        self.assertEqual(self.look(ask.states), [("RTC_STATUS", "1", "ERROR")])
        self.assertEqual(self.look(ask.states), [])

    def test_no_state_of_a_context_that_it_has_just_left(self):
        self.component.contexts["own"][0] = "Created"
        self.assertEqual(self.look(ask.states), [])

    def test_rates_and_stops(self):
        self.component.contexts["own"][1:] = [200.0, False]
        self.assertEqual(
            self.look(ask.contexts), [("EC_EVENT", "0", "EC_RATE_CHANGED"), ("EC_EVENT", "0", "EC_SHUTDOWN")]
        )

    def test_contexts_that_come_and_go(self):
        self.component.contexts["new"] = ["Active", 1.0, True]
        self.assertEqual(self.look(ask.contexts), [("EC_EVENT", "2", "EC_ATTACHED")])
        del self.component.contexts["own"]
        self.assertEqual(self.look(ask.contexts), [("EC_EVENT", "0", "EC_DETACHED")])

    def test_connections_that_are_made_and_lost_and_made_again_by_the_same_id(self):
        self.connect("out", "it", "there")
        self.assertEqual(self.look(ask.connections), [("PORT_EVENT", "out", "PORT_CONNECT")])
        self.connect("out", "it", "elsewhere")
        again = [("PORT_EVENT", "out", "PORT_DISCONNECT"), ("PORT_EVENT", "out", "PORT_CONNECT")]
        self.assertEqual(self.look(ask.connections), again)
        self.component.connectors["out"] = []
        self.assertEqual(self.look(ask.connections), [("PORT_EVENT", "out", "PORT_DISCONNECT")])

    def test_connections_of_tools_are_no_events(self):
        self.connect("out", "tool", "there")
        self.assertEqual(self.look(ask.connections), [])

    def test_ports_that_come_and_go(self):
        self.component.connectors["new"] = []
        self.assertEqual(self.look(ask.which_ports), [("PORT_EVENT", "new", "PORT_ADD")])
        del self.component.connectors["in"]
        self.assertEqual(self.look(ask.which_ports), [("PORT_EVENT", "in", "PORT_REMOVE")])


if __name__ == "__main__":
    unittest.main()
