"""What rtdoctor says of things that no mock of ours does: if one of these fails, it stumbles over a broken robot."""
import unittest

from rtshell_lite import component, path, ports, tree
from rtshell_lite.doctor import components, connections


class Connections(unittest.TestCase):
    def test_an_end_that_is_nil(self):
        node = tree.Node(path.parse("/localhost/In0.rtc"), "component", None)
        connector = ports.Connector("one", "out_in", [None, None], [])
        port = ports.Port(node, "In0.out", "DataOutPort", {}, [], [connector], None, None)
        finding, = connections._troubles(connections.Link(components.Examined([node]), port, connector), {})
        self.assertEqual(finding, ("fail", "connection", "/localhost/In0.rtc:out", "connection out_in has an end that is nothing (nil)",
                                   "rtdis -i one /localhost/In0.rtc:out"))


class Names(unittest.TestCase):
    def test_bound_twice_without_telling_its_names(self):
        """OpenRTM-aist tells the names of a component in a property; others do not."""
        nodes = [tree.Node(path.parse(where), "component", None)
                 for where in ("/one/a.host_cxt/In0.rtc", "/one/b.host_cxt/In0.rtc", "/two/a.host_cxt/In0.rtc")]
        each = components.Examined(nodes)
        each.profile = component.Profile("In0", "In", "", "", "", "", "", properties=[])
        self.assertEqual([(finding.path, finding.message) for finding in components._names(each)],
                         [("/one/b.host_cxt/In0.rtc", "the same component as /one/a.host_cxt/In0.rtc")])


if __name__ == "__main__":
    unittest.main()
