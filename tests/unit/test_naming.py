"""Name servers that refuse: what comes between the look at a name and its end, and processes that are no name servers."""
import unittest
from unittest import mock

from rtshell_lite import errors, path
from rtshell_lite.robot import naming, node, tree


class Server:
    """A name server that refuses; see errors.Refused."""

    def __init__(self, name):
        self.name = name

    def call(self, operation, *_):
        raise errors.Refused("/localhost", "CosNaming.NamingContext." + self.name, self.name)


class Unbinding(unittest.TestCase):
    def unbound(self, refusal):
        with mock.patch.object(tree, "resolve", lambda _: Server(refusal)), mock.patch.object(naming.orb, "naming_name", list):
            return naming._unbind(path.parse("/localhost/a.host_cxt/Gone0.rtc"), False)

    def test_a_name_that_has_gone_since_it_was_looked_at(self):
        with self.assertRaises(errors.NotFound) as caught:
            self.unbound("NotFound")
        self.assertEqual(str(caught.exception), "/localhost/a.host_cxt/Gone0.rtc: no such path")

    def test_any_other_refusal_is_one(self):
        with self.assertRaises(errors.Refused) as caught:
            self.unbound("CannotProceed")
        self.assertNotIsInstance(caught.exception, errors.NotFound)


class Listing(unittest.TestCase):
    def failure(self, refusal):
        server = node.Node(path.parse("/localhost"), "server", None)
        with mock.patch.object(node.Node, "call", Server(refusal).call), self.assertRaises(errors.Error) as caught:
            node.bound(server)
        return type(caught.exception)

    def test_a_process_that_is_no_name_server(self):
        for refusal in ("BAD_OPERATION", "NO_IMPLEMENT", "INTF_REPOS"):
            self.assertIs(self.failure(refusal), errors.WrongKind)

    def test_a_name_server_that_refuses(self):
        self.assertIs(self.failure("NO_PERMISSION"), errors.Refused)


if __name__ == "__main__":
    unittest.main()
