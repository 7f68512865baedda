"""What rtdoctor says of things that no mock of ours does: if one of these fails, it stumbles over a broken robot."""
import unittest

from rtshell_lite import path, ports, tree
from rtshell_lite.doctor import components, connections


class Connections(unittest.TestCase):
    def test_an_end_that_is_nil(self):
        node = tree.Node(path.parse("/localhost/In0.rtc"), "component", None)
        connector = ports.Connector("one", "out_in", [None, None], [])
        port = ports.Port(node, "In0.out", "DataOutPort", {}, [], [connector], None, None)
        finding, = connections._troubles(connections.Link(components.Examined([node]), port, connector), {})
        self.assertEqual(finding, ("fail", "connection", "/localhost/In0.rtc:out", "connection out_in has an end that is nothing (nil)",
                                   "rtdis -i one /localhost/In0.rtc:out"))


if __name__ == "__main__":
    unittest.main()
