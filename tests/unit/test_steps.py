"""Single changes of a system and their way back: if this fails, --rollback leaves behind what it says that it
has undone.
"""
import unittest
from unittest import mock

from rtshell_lite import errors
from rtshell_lite.net import loop
from rtshell_lite.robot import configuration, ports
from rtshell_lite.system import compare, connect_steps, restore, steps
from rtshell_lite.system.outcomes import ALREADY, NOT_TRIED
from rtshell_lite.xmlprofile import model


class Placement:
    """A component that the steps do not look at."""

    where = "/localhost/a.rtc"
    required = True
    found = None


class Configuration:
    """Counts what it is asked to do."""

    def __init__(self):
        self.activated = []
        self.stored = []

    def set(self, set_id, with_hidden=False):
        return set_id, with_hidden

    async def activate(self, set_id):
        self.activated.append(set_id)

    async def store(self, values, within):
        self.stored.append((values, within))


class ActiveSet(unittest.TestCase):
    def setUp(self):
        self.step, self.after = steps.Active(Placement(), "fast"), mock.Mock(
            active="fast", configuration=Configuration()
        )

    def test_the_set_that_was_active_before_is_active_again(self):
        loop.run(self.step.undo([mock.Mock(active="slow")], [self.after]))
        self.assertEqual(self.after.configuration.activated, ["slow"])

    def test_where_none_was_active_none_can_be(self):
        with self.assertRaises(errors.Refused) as caught:
            loop.run(self.step.undo([mock.Mock(active="")], [self.after]))
        self.assertIn("had no active configuration set before", str(caught.exception))
        self.assertEqual(self.after.configuration.activated, [])

    def test_files_name_a_default_set_of_components_that_have_none(self):
        step = steps.Active(Placement(), "default")
        for sets in ([], [configuration.Set("__widget__", "", {}, False)]):
            self.assertTrue(loop.run(step.is_done([steps.Configured(sets, "", None)])))
        with self.assertRaises(errors.NoSuch):
            loop.run(self.step.is_done([steps.Configured([], "", None)]))


class Values(unittest.TestCase):
    def differences(self, values, active="fast", active_before=None):
        step = steps.Values(Placement(), "fast", values)
        step.active_before = active_before
        sets = [configuration.Set("fast", "", {"a": "1", "b": "2"}, True)]
        return [(each.what, each.name, each.actual, each.obstacle is None)
                for each in step.differences([steps.Configured(sets, active, None)])]

    def test_differ(self):
        self.assertEqual(self.differences({"a": "1"}), [])
        self.assertEqual(self.differences({"b": "3", "c": "1", "a": "1"}),
                         [("value", "b", "2", True), ("parameter", "c", None, False)])

    def test_the_set_that_was_active_has_to_be_again(self):
        self.assertEqual(self.differences({"a": "1"}, "", "fast"), [("active set", None, "", True)])
        self.assertEqual(self.differences({"a": "1"}, "fast", "fast"), [])

    def test_hidden_ones_are_set_back_too(self):
        now = mock.Mock(configuration=Configuration())
        before = steps.Configured([configuration.Set("__widget__", "", {"a": (
            "1"
        ), "b": "2"}, False)], "", None)
        loop.run(steps.Values(Placement(), "__widget__", {"a": "3"}).undo([before], [now]))
        self.assertEqual(now.configuration.stored, [({"a": "1"}, ("__widget__", True))])


class Connections(unittest.TestCase):
    def test_mismatches_are_found_before_connecting(self):
        differ = errors.Refused("/localhost/a.rtc:out to /localhost/b.rtc:in", "data types differ")
        with mock.patch.object(ports, "check", side_effect=differ):
            self.assertIs(connect_steps.Connect._obstacle(mock.Mock(), ["a:out", "b:in"]), differ)

    def test_one_that_was_removed_is_made_again_between_the_ends_that_live(self):
        ends = [(mock.Mock(), "out"), (mock.Mock(), "in")]
        step = connect_steps.Disconnect(model.DataPortConnector(connector_id="id"), ends, {"id"})
        removed = ports.Connector(
            "id",
            "name",
            [],
            [("dataport.dataflow_type", "push"), ("dataport.corba_cdr.inport_ior", "IOR:00")],
        )
        connected = []

        async def connect(*args):
            connected.append(args)
        with mock.patch.object(connect_steps.connectors, "connect", connect):
            step.connections_between = lambda at: [(at[0], removed)] if at == ["a:out", "b:in"] else []
            loop.run(step.undo(["a:out", "b:in", errors.Gone("c:in")], ["a:out", "b:in"]))
        self.assertEqual(connected, [(["a:out", "b:in"], "name", "id", {"dataport.dataflow_type": "push"})])


class Rates(unittest.TestCase):
    """Files name contexts of every kind; only the rate of a periodic one that is the component's own can be
    set.
    """

    def rates(self, *wanted):
        """(handle, index, status) of the steps for these contexts (id, kind, rate) of a component whose own
        has the handle 5.
        """
        contexts = [model.ExecutionContext(id=number, kind=kind, rate=rate) for number, kind, rate in wanted]
        placement = mock.Mock(
            where="/localhost/a.rtc",
            required=True,
            error=None,
            component=mock.Mock(execution_contexts=contexts),
            found=mock.Mock(owned=[mock.Mock(handle=5, rate=1000.0)]),
        )
        return [
            (outcome.step.handle, outcome.step.index, outcome.status)
            for outcome in loop.run(restore._rates(placement))
        ]

    def test_its_own(self):
        self.assertEqual(self.rates(("5", "PERIODIC", 1000.0)), [(5, 0, ALREADY)])
        self.assertEqual(self.rates(("5", "periodic_execution", 500.0)), [(5, 0, NOT_TRIED)])

    def test_others(self):
        self.assertEqual(
            self.rates(("6", "PERIODIC", 500.0), ("five", "PERIODIC", 500.0), ("5", "EVENT_DRIVEN", 500.0)),
            [],
        )
        self.assertEqual(
            self.rates(*[("5", "PERIODIC", rate) for rate in (0.0, -1.0, float("inf"), float("nan"))]), []
        )


class States(unittest.TestCase):
    def actual(self, states, *running):
        """What is compared with Active in the context 0; `running` for each of its own contexts, 0 …"""
        owned = [mock.Mock(handle=handle, running=is_running) for handle, is_running in enumerate(running)]
        placement = mock.Mock(where="/localhost/a.rtc", required=True)
        found = mock.Mock(states=states, owned=owned)
        differences = compare._State(placement, "Active", "0").differences([found])
        return [difference.actual for difference in differences]

    def test_each_context_of_its_own_counts_for_itself(self):
        self.assertEqual(self.actual({0: "Inactive", 1: "Active"}, False, True), ["Inactive"])
        self.assertEqual(self.actual({0: "Inactive", 1: "Active"}, True, True), ["Inactive"])

    def test_of_a_member_the_context_of_the_composite_counts(self):
        self.assertEqual(self.actual({0: "Inactive", 1000: "Active"}, False), [])

    def test_one_that_is_active_in_the_context_of_another_is_active(self):
        """It is not to be Active in its own, too."""
        self.assertEqual(self.actual({0: "Inactive", 1000: "Active"}, True), [])
        self.assertEqual(self.actual({0: "Inactive", 1000: "Inactive"}, True), ["Inactive"])


if __name__ == "__main__":
    unittest.main()
