"""How a recording finds components. If one of these fails, it asks the name server for each name each second,
or records nothing of what has come back.
"""
import types
import unittest
from unittest import mock

from rtshell_lite import path
from rtshell_lite.corba import orb, session
from rtshell_lite.datalog import flight
from rtshell_lite.live import times
from rtshell_lite.net import loop

TOP = path.parse("/a/b.host_cxt")


class Names(unittest.TestCase):
    def setUp(self):
        self.known = []
        self.nodes = [self.node(name) for name in ("live", "silent", "other")]
        self.readers = []
        for module, name, function in (
            (orb, "identity", lambda ref: ref), (flight, "_components", self.components),
            (flight, "_ports", self.ports),
        ):
            patch = mock.patch.object(module, name, function)
            patch.start()
            self.addCleanup(patch.stop)
        self.flight = flight.Flight([TOP], flight.Choice(), self.make, [])

    @staticmethod
    def node(name):
        return types.SimpleNamespace(path="/a/b.host_cxt/" + name, ref=name, endpoint=("a", 1), where=name)

    async def components(self, top, known):
        self.known.append(sorted(known))
        return self.nodes

    async def ports(self, node):
        kind = "CorbaPort" if node.ref == "other" else "DataOutPort"
        return [types.SimpleNamespace(
            node=node, ref=node.ref, name="out", type=kind, properties={}, owner=None)], ()

    async def make(self, port, about, is_fast):
        return types.SimpleNamespace(port=port, failure="it is" if port.ref == "silent" else None)

    def find(self, count):
        async def find_all():
            for _ in range(count):
                await self.flight.find()
        with mock.patch.object(flight.ports, "label", lambda port: port.ref), mock.patch.object(
            flight.ports, "offer_without", lambda *_: None
        ):
            loop.run(find_all(), session=session.Session(1.0))

    def test_those_that_are_read_are_not_looked_up_but_now_and_then(self):
        self.find(times.WHOLE + 2)
        self.assertEqual(self.known[0], [])
        self.assertEqual(self.known[1 : times.WHOLE], (times.WHOLE - 1) * [["/a/b.host_cxt/live"]])
        self.assertEqual(self.known[times.WHOLE :], [[], ["/a/b.host_cxt/live"]])

    def test_one_that_fails_is_looked_up(self):
        self.find(1)
        self.flight.readers[0].failure = "gone"
        self.find(1)
        self.assertEqual(self.known[1], [])


if __name__ == "__main__":
    unittest.main()
