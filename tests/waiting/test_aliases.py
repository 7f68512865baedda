"""Directories with several names, where the name server calls itself otherwise than we do: if these fail,
rtdel and rtdoctor take a robot's own directories for those of another name server, or the other way round.
"""
import shutil
import subprocess
import tempfile
import types
import unittest

import processes
import worlds

try:
    import omniORB  # noqa: F401
except ImportError:
    omniORB = None
else:
    from mock_components import naming as mock_naming
    from rtshell_lite import path
    from rtshell_lite.corba import omniorb
    from rtshell_lite.net import loop
    from rtshell_lite.robot import aliases, naming, tree

PUBLISHED = "127.0.0.3"  # Linux answers at all of 127.0.0.0/8


def setUpModule():
    if omniORB is None or not processes.nameserver.binary():
        raise unittest.SkipTest("needs omniORBpy and omniNames")


class PublishedOtherwise(unittest.TestCase):
    """A name server that publishes another address than the one we use, as is usual for localhost."""

    def setUp(self):
        self.directory = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.directory, True)
        self.port = processes.nameserver.free_port()
        command = processes.nameserver.command(self.port, self.directory, PUBLISHED)
        self.process = subprocess.Popen(
            command + ["-ORBendPointNoPublish", "giop:tcp:127.0.0.1:%d" % self.port],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        self.addCleanup(self.process.wait)
        self.addCleanup(self.process.kill)
        worlds.eventually(lambda: processes.nameserver.answers(self.port), "omniNames answers")
        self.mocks = types.SimpleNamespace(reference=omniorb.start().string_to_object)
        self.names = mock_naming.Naming(self.mocks, "127.0.0.1:%d" % self.port)
        self.names.contexts([("own", "cxt"), ("inner", "cxt")])

    def at(self, *names):
        return "/".join(("/127.0.0.1:%d" % self.port,) + names)

    def foreign(self):
        async def found():
            return [
                node.name
                for node in await aliases.within(await tree.walk(await tree.resolve(self.at())))
                if node.foreign
            ]
        return loop.run(found())

    def walked(self):
        """What is below the name server."""
        async def found():
            return (await tree.walk(await tree.resolve(self.at())))[1:]
        return loop.run(found())

    def delete(self, notes):
        """The lines of a deletion of own.cxt."""
        async def deleted():
            return [
                line
                async for line in naming.delete(path.parse(self.at("own.cxt")), notes.append, recursive=True)
            ]
        return loop.run(deleted())

    def test_its_own_directories_are_not_foreign(self):
        self.assertEqual(loop.run(tree.resolve(self.at("own.cxt"))).endpoint[0], PUBLISHED)
        self.assertEqual(self.foreign(), [])

    def test_another_server_at_the_same_port_is_foreign(self):
        self.names.bind_context(
            [("root", "cxt")], mock_naming.root(self.mocks, "127.0.0.9:%d" % self.port)
        )
        self.assertEqual(self.foreign(), ["root.cxt"])

    def test_its_own_directories_can_be_deleted(self):
        notes = []
        lines = self.delete(notes)
        self.assertEqual(
            ([line.rpartition("/")[2] for line in lines], notes),
            (["inner.cxt: deleted", "own.cxt: deleted"], []),
        )
        self.assertEqual(self.walked(), [])

    def test_a_second_name_is_an_alias(self):
        self.names.bind_context([("two", "cxt")], self.names.resolve([("own", "cxt")]))
        walked = [(node.name, node.alias and str(node.alias)) for node in self.walked()]
        self.assertEqual(walked, [("own.cxt", None), ("inner.cxt", None), ("two.cxt", self.at("own.cxt"))])
        notes = []
        self.delete(notes)
        self.assertEqual(
            notes,
            ["%s: another name of %s; only this name is deleted" % (self.at("own.cxt"), self.at("two.cxt"))],
        )
        self.assertEqual([node.name for node in self.walked()], ["two.cxt", "inner.cxt"])


class Hosts(unittest.TestCase):
    def test_names_of_one_host(self):
        for one, other, same in (
            ("a", "a", True),
            ("localhost", "127.0.0.1", True),
            ("127.0.0.1", "127.0.0.2", False),
            ("no-such-host.invalid", "127.0.0.1", False),
            ("", "127.0.0.1", False),
        ):
            self.assertIs(loop.run(aliases.same_host(one, other)), same, (one, other))


if __name__ == "__main__":
    unittest.main()
