"""What rtdoctor says of robots that are broken in ways that the mocks do not have."""
import unittest
from unittest import mock

from rtshell_lite import errors, path
from rtshell_lite.corba import orb
from rtshell_lite.doctor import components, connections, here, profile, remedies, servers
from rtshell_lite.robot import component, places, ports, snapshot, tree
from rtshell_lite.xmlprofile import model


class Connections(unittest.TestCase):
    def test_an_end_that_is_nil(self):
        node = tree.Node(path.parse("/localhost/In0.rtc"), "component", None)
        connector = ports.Connector("one", "out_in", [None, None], [])
        port = ports.Port(node, "In0.out", "DataOutPort", {}, [], [connector], None, None)
        finding, = connections._troubles(connections.Link(snapshot.Snapshot(node), port, connector), {})
        self.assertEqual(finding, ("fail", "connection", "/localhost/In0.rtc:out", "connection out_in has an end that is nothing (nil)",
                                   "rtdis -i one /localhost/In0.rtc:out"))

    def test_what_one_end_does_not_have(self):
        there = ports.Connector("one", "c", [], [("x", "1")])
        here = ports.Connector("one", "c", [], [("x", "1"), ("dataport.dataflow_type", "push")])
        port = ports.Port(tree.Node(path.parse("/localhost/In0.rtc"), "component", None), "In0.out", "DataOutPort", {}, [], [here],
                          None, None)
        far = tree.Node(path.parse("/localhost/far.rtc"), "component", None)
        found = connections._differences(connections.Link(None, port, here),
                                         places.End(None, port._replace(node=far, name="far.in", connectors=[there]), None),
                                         remedies.words("restart far end"))
        self.assertEqual([finding.message for finding in found], ["dataport.dataflow_type is push here, missing at /localhost/far.rtc:in"])


class Profile(unittest.TestCase):
    def test_a_rate_that_a_context_has_rounded(self):
        context = model.ExecutionContext(id="0", kind="PERIODIC", rate=30.0)
        listed = model.Component(id="", path_uri="localhost/In0.rtc", instance_name="In0", execution_contexts=[context])
        for rate, number in ((30.0003, 0), (29.99, 0), (31.0, 1)):
            owned = [component.Context(0, None, "Periodic", rate, True, None, (), ())]
            with self.subTest(rate=rate), mock.patch("rtshell_lite.system.capture.look", return_value=[owned]):
                self.assertEqual(len(profile._rates(mock.Mock(components=[listed]))), number)


class Here(unittest.TestCase):
    def test_an_old_omniorb(self):
        with mock.patch.object(orb, "version", lambda: "omniORBpy 3.7.1"), mock.patch.object(orb, "start"):
            finding, = here._programs()
        self.assertEqual(finding.level, "warn")
        self.assertIn("omniORBpy 3.7.1: older than 4.0, untried", finding.message)


class NameServers(unittest.TestCase):
    """Faults that omniNames does not have."""

    def stopped(self, check, answer):
        def call(*_):
            if isinstance(answer, Exception):
                raise answer
            return answer
        with mock.patch.object(orb, "call", call), mock.patch.object(orb, "endpoint", lambda ref: ("robot1", 2809)):
            with self.assertRaises(servers._Stop) as caught:
                check("/robot1", None)
        return caught.exception.finding.message

    def test_what_it_may_answer(self):
        refused = errors.Refused("/robot1", "CORBA.NO_PERMISSION")
        self.assertEqual(self.stopped(servers._is_there, refused), "answers with CORBA.NO_PERMISSION")
        self.assertEqual(self.stopped(servers._is_context, refused), "is there, but does not report what it is (CORBA.NO_PERMISSION)")
        self.assertEqual(self.stopped(servers._is_context, False), "its object NameService is no naming context")


class Names(unittest.TestCase):
    def test_bound_twice_without_telling_its_names(self):
        """OpenRTM-aist has the names of a component in a property; others do not."""
        nodes = [tree.Node(path.parse(where), "component", None)
                 for where in ("/one/a.host_cxt/In0.rtc", "/one/b.host_cxt/In0.rtc", "/two/a.host_cxt/In0.rtc")]
        each = snapshot.Snapshot(nodes[0], nodes[1:])
        each.profile = component.Profile("In0", "In", "", "", "", "", "", properties=[])
        self.assertEqual([(finding.path, finding.message) for finding in components._names(each)],
                         [("/one/b.host_cxt/In0.rtc", "the same component as /one/a.host_cxt/In0.rtc")])


if __name__ == "__main__":
    unittest.main()
