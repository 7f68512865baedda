"""What followers of components make of the answers to their small questions. If this fails, rtkeep mends
nothing where nobody reports it, and rtwatch and recordings lack events.
"""
import types
import unittest
from unittest import mock

from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.live import ask, follow, times, watch
from rtshell_lite.net import loop
from rtshell_lite.robot import component, configuration, ports


class Component:
    """What a component answers: `contexts` {reference: [state, rate, whether it runs]}, `connectors` of its
    ports {reference: [Connector]}.
    """

    def __init__(self):
        self.contexts = {"own": ["Inactive", 100.0, True], "composite's": ["Inactive", 50.0, True]}
        self.connectors = {"in": [], "out": []}
        self.also_in = []
        self.node = types.SimpleNamespace(path="/a:1/x.rtc", ref="x", call=self.call)
        self.seen = ask.Seen(self.node, lambda port: True)

    async def call(self, operation, ref):
        return list(self.contexts).index(ref)

    async def owned(self, node):
        return [ref for ref in self.contexts if ref != "composite's"]

    async def participating(self, node):
        return [ref for ref in self.contexts if ref == "composite's"] + self.also_in

    async def state_in(self, node, ref):
        return self.contexts[ref][0]

    async def runs(self, node, ref):
        return self.contexts[ref][2]

    async def port_refs(self, node):
        return list(self.connectors)

    async def port(self, node, ref, brief):
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
        self.component.seen.take_ports([])
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

    def test_a_state_that_it_has_again_after_it_was_brought_to_another(self):
        self.component.contexts["own"][0] = "Error"
        self.look(ask.states)
        self.component.seen.expect("Active")
        self.component.contexts["composite's"][0] = "Active"
        self.assertEqual(self.look(ask.states), [("RTC_STATUS", "0", "ERROR")])

    def test_one_state_over_all_contexts(self):
        self.component.contexts["composite's"][0] = "Active"
        self.look(ask.states)
        self.assertEqual(self.component.seen.state, "Active")

    def test_a_context_of_another_process_that_is_silent_hides_nothing_and_rests(self):
        async def silent_one(node, ref, asked, none):
            answer = await asked
            return none if ref == "composite's" else answer
        with mock.patch.object(component, "or_default", silent_one):
            self.component.contexts["composite's"][0] = "Active"
            self.assertEqual(self.look(ask.states), [])
        seen = self.component.seen
        self.assertEqual(seen.state, "Inactive", "what was last known of a silent one is not so any more")
        self.assertEqual([context.handle for context in self.asked_for_states()], ["0"])
        with mock.patch.object(times, "REST", 0.0), mock.patch.object(component, "or_default", silent_one):
            seen.contexts[1].silent_until = 0.0
            self.look(ask.states)
            self.assertEqual([context.handle for context in self.asked_for_states()], ["0", "1"])
        self.assertEqual(self.look(ask.states), [("RTC_STATUS", "1", "ACTIVE")])
        self.assertEqual(seen.state, "Active")

    def asked_for_states(self):
        async def asked():
            return [question.args[0] for question in ask.states(self.component.seen)]
        return loop.run(asked(), session=session.Session(1.0))

    def test_handles_are_asked_for_where_somebody_wants_them(self):
        self.component.node.call = None
        self.component.seen = ask.Seen(self.component.node, lambda port: True, has_handles=False)
        self.look(ask.contexts, ask.states)
        self.assertEqual(self.component.seen.state, "Inactive")

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

    def test_a_context_that_is_both_its_own_and_not(self):
        self.component.also_in = ["own"]
        self.assertEqual(self.look(ask.contexts), [])
        self.assertEqual(self.look(ask.contexts), [])

    def test_it_refuses_to_say_that_no_set_is_active_any_more(self):
        def refuse(*words):
            raise errors.Refused("x", "NotAvailable")
        seen = self.component.seen
        found = configuration.Configuration(self.component.node, "c", [], "")
        seen.take(types.SimpleNamespace(configuration=found), {"configuration"})
        with mock.patch.object(orb, "call", refuse):
            self.assertEqual(self.look(ask.configuration), [])
            seen.set = "mode1", {}
            with self.assertRaises(errors.Refused):
                self.look(ask.configuration)

    def test_a_set_that_was_made_after_they_were_listed(self):
        found = configuration.Configuration(self.component.node, "c", [], "new")
        self.component.seen.take(types.SimpleNamespace(configuration=found), {"configuration"})
        self.assertIsNone(self.component.seen.set)

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

    def test_a_port_that_passes_the_failure_of_a_dead_far_end_on_is_asked_once_more(self):
        failures = [errors.Unreachable("x", "TRANSIENT")]

        async def call(path, ref, operation):
            if failures:
                raise failures.pop()
            return []
        with mock.patch.object(orb, "call", call):
            self.assertEqual(self.look(ask.connections), [])

    def test_all_connections_of_a_port_are_counted_with_those_of_tools(self):
        self.connect("out", "tool", "there")
        self.look(ask.connections)
        self.assertEqual([port.ids for port in self.component.seen.ports], [[], ["tool"]])

    def test_a_port_that_does_not_answer_is_asked_ever_later_and_hides_no_other(self):
        async def silent(path, ref, operation):
            raise errors.Silent("x", "no answer")
        seen = self.component.seen
        (asked,) = [question for question in ask.connections(seen) if question.args[0].name == "in"]
        with mock.patch.object(orb, "call", silent), self.assertRaises(errors.Silent):
            loop.run(asked(), session=session.Session(1.0))
        self.assertEqual([question.args[0].name for question in ask.connections(seen)], ["out"])
        seen.wait_no_more()
        self.assertEqual(len(list(ask.connections(seen))), 2)

    def test_what_was_not_known_before_is_no_event(self):
        self.component.seen = ask.Seen(self.component.node, lambda port: True)
        self.assertEqual(self.look(ask.contexts, ask.states, ask.which_ports, ask.connections), [])
        self.assertIsNone(self.component.seen.ports)

    def test_all_ports_may_go(self):
        self.component.connectors.clear()
        self.assertEqual(len(self.look(ask.which_ports)), 2)
        self.assertEqual(self.component.seen.ports, [])

    def test_ports_that_come_and_go(self):
        self.component.connectors["new"] = []
        self.assertEqual(self.look(ask.which_ports), [("PORT_EVENT", "new", "PORT_ADD")])
        del self.component.connectors["in"]
        self.assertEqual(self.look(ask.which_ports), [("PORT_EVENT", "in", "PORT_REMOVE")])


class Queues(unittest.TestCase):
    """Whom a Watch asks at a time."""

    def setUp(self):
        self.watch = watch.Watch(watch.Events(watch.KINDS, asks_ports=True))
        self.begun = []
        self.watch.start = lambda work, place=None: self.begun.append(work)

    def tearDown(self):
        for work in self.begun:
            work.close()

    def follow(self, number, count):
        """Follow components of one process, with `count` ports each."""
        self.watch.followed = [
            types.SimpleNamespace(
                is_hung=False, endpoint=("a", 1), where=str(each), reports=False, shown="it",
                may_be_asked=lambda shows, now: True, seen=types.SimpleNamespace(
                    contexts=(), has_sets=False, ports=count * [None], _which_owned=None,
                    _which_participating=None, _which_ports=None, asks_port=lambda port: False,
                ),
            )
            for each in range(number)
        ]

    def test_one_that_is_slow_delays_no_other_of_its_process(self):
        self.follow(3, 0)
        self.watch.ask_around(0.0)
        self.assertEqual(len(self.begun), 3)
        self.watch.ask_around(10.0)  # none has answered
        self.assertEqual(len(self.begun), 3)

    def test_those_that_report_are_looked_through_now_and_then(self):
        self.follow(1, 0)
        self.watch.asks = {ask.states: 1}
        (entry,) = self.watch.followed
        entry.reports = True
        looked = []
        entry.may_be_asked = lambda shows, now: looked.append(now) or True
        for tenth in range(int(20 * follow.IDLE) + 1):
            self.watch.ask_around(tenth / 10)
        self.assertEqual(looked, [0.0, follow.IDLE, 2 * follow.IDLE])
        entry.reports = False  # it has lost our observer
        self.watch.ask_around(2 * follow.IDLE + 0.3)
        self.assertEqual(len(looked), 4)

    def test_when_there_is_more_to_ask_for(self):
        self.follow(1, 0)
        self.watch.asks = {ask.contexts: 3}
        self.assertAlmostEqual(self.watch.ask_around(7.0), 7.0 + 3 * self.watch.look)
        self.assertAlmostEqual(self.watch.ask_around(7.1), 7.0 + 3 * self.watch.look)

    def test_what_was_not_there_is_looked_for_as_often_as_the_rest(self):
        self.follow(1, 0)
        self.watch.asks = {ask.states: 27}  # every 5.4 s; it has no context
        self.assertAlmostEqual(self.watch.ask_around(1.0), 1.0 + 27 * self.watch.look)
        self.watch.asks = {ask.states: 1}
        self.assertAlmostEqual(self.watch.ask_around(10.0), 10.0 + follow.IDLE)

    def test_none_is_asked_twice_at_a_time_that_hung_meanwhile(self):
        self.follow(1, 0)
        (entry,) = self.watch.followed
        for now, entry.is_hung in ((0.0, False), (1.0, True), (2.0, False)):
            self.watch.ask_around(now)
        self.assertEqual(len(self.begun), 1)

    def test_nothing_stays_of_those_that_are_gone(self):
        self.follow(3, 1)
        self.watch.ask_around(0.0)
        for queue in self.watch._queues.values():
            queue.is_busy = False
        self.watch.followed = []
        self.watch.ask_around(10.0)
        self.assertFalse(self.watch._queues)

    def test_many_ports_are_asked_more_rarely(self):
        for count, seconds in ((5, 2), (30, 10)):
            self.follow(10, count)
            self.watch.ask_around(0.0)
            self.assertEqual(self.watch.asks[ask.connections] * self.watch.look, seconds)


if __name__ == "__main__":
    unittest.main()
