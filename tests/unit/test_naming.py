"""What name servers hold, by its references, and what they refuse: if this fails, a command asks the wrong
objects, or none.
"""
import unittest
from unittest import mock

from rtshell_lite import errors, path
from rtshell_lite.giop import ior
from rtshell_lite.net import loop
from rtshell_lite.robot import naming, node, tree


class Server:
    """A name server that refuses; see errors.Refused."""

    def __init__(self, name):
        self.name = name

    async def call(self, operation, *_):
        raise errors.Refused("/localhost", "CosNaming.NamingContext." + self.name, self.name)


class Unbinding(unittest.TestCase):
    def unbound(self, refusal):
        async def resolve(_):
            return Server(refusal)
        with mock.patch.object(tree, "resolve", resolve), mock.patch.object(naming.orb, "naming_name", list):
            return loop.run(naming._unbind(path.parse("/localhost/a.host_cxt/Gone0.rtc"), False))

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
        with mock.patch.object(node.Node, "call", Server(refusal).call), self.assertRaises(
            errors.Error
        ) as caught:
            loop.run(node.bound(server))
        return type(caught.exception)

    def test_a_process_that_is_no_name_server(self):
        for refusal in ("BAD_OPERATION", "NO_IMPLEMENT", "INTF_REPOS"):
            self.assertIs(self.failure(refusal), errors.WrongKind)

    def test_a_name_server_that_refuses(self):
        self.assertIs(self.failure("NO_PERMISSION"), errors.Refused)

    def test_a_component_has_no_names_below_it(self):
        with self.assertRaises(errors.WrongKind) as caught:
            loop.run(tree.children(node.Node(path.parse("/localhost/a.rtc"), "component", None)))
        self.assertEqual(str(caught.exception), "/localhost/a.rtc: not a directory (it is a component)")


class Kinds(unittest.TestCase):
    def kind(self, name, type_id, is_context=False):
        with mock.patch.object(node.orb, "address", lambda ref: ior.Address((type_id, "host", 1, b""))):
            return node.classified(path.parse("/localhost/" + name), "reference", is_context).kind

    def test_by_type(self):
        for type_id, kind in (
            ("omg.org/CosNaming/NamingContext", "directory"),
            ("omg.org/CosNaming/NamingContextExt", "directory"),
            ("openrtm.aist.go.jp/OpenRTM/DataFlowComponent", "component"),
            ("omg.org/RTC/RTObject", "component"),
            ("RTM/Manager", "manager"),
            ("omg.org/CosEventChannelAdmin/EventChannel", "unknown"),
        ):
            self.assertEqual(self.kind("x.y", "IDL:%s:1.0" % type_id), kind)

    def test_by_name_where_the_type_does_not_say(self):
        self.assertEqual(
            [self.kind(name, "IDL:Own:1.0") for name in ("a.rtc", "a.mgr", "a.obj")],
            ["unsure", "unsure", "unknown"],
        )
        self.assertEqual(
            (self.kind("a.obj", ""), self.kind("a.obj", "", is_context=True)), ("unsure", "directory")
        )

    def test_the_names_of_roots(self):
        self.assertEqual(
            [node.Node(path.parse(word), "root").name for word in ("/", "/localhost")], ["/", "localhost"]
        )


if __name__ == "__main__":
    unittest.main()
