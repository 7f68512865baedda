"""Our own ORB beside omniORB: the same answers of the same components."""
import unittest
from unittest import mock

import worlds
from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.corba.iiop import client
from rtshell_lite.giop import idl, references
from rtshell_lite.net import loop

try:
    import omniORB
    from rtshell_lite.corba import omniorb
except ImportError:
    omniORB = None


@unittest.skipIf(omniORB is None, "needs omniORBpy")
class Beside(unittest.TestCase):
    """The same answers of mocks by both ORBs."""

    @classmethod
    def setUpClass(cls):
        worlds.start_name_server()

    @classmethod
    def tearDownClass(cls):
        worlds.Server.stop()

    def setUp(self):
        patched = mock.patch.object(orb, "_orb", client)
        patched.start()
        self.addCleanup(patched.stop)

    def call(self, ref, operation, *args):
        return loop.run(orb.call("w", ref, operation, *args), session=session.Session())

    def test_profiles(self):
        world = worlds.World("two")
        self.addCleanup(world.close)
        ref = references.from_text(worlds.Server.orb.object_to_string(world.component("ConsoleIn0")))
        component = client.narrow(ref, "OpenRTM.DataFlowComponent")
        ours = self.call(component, "get_component_profile")
        theirs = world.component("ConsoleIn0").get_component_profile()
        for name in ("instance_name", "type_name", "vendor", "category"):
            self.assertEqual(getattr(ours, name), getattr(theirs, name))
        self.assertEqual(client.properties(ours.properties), omniorb.properties(theirs.properties))
        port = ours.port_profiles[0]
        self.assertEqual(
            client.properties(port.properties), omniorb.properties(theirs.port_profiles[0].properties)
        )
        self.assertEqual(client.address(port.port_ref), omniorb.address(theirs.port_profiles[0].port_ref))

    def test_user_exceptions(self):
        world = worlds.World("two")
        self.addCleanup(world.close)
        root = client.narrow(
            client.from_url("w", "corbaloc::127.0.0.1:%d/NameService" % worlds.Server.port),
            "CosNaming.NamingContext",
        )
        name = [idl.struct("CosNaming.NameComponent")("nobody", "")]
        with self.assertRaises(errors.Refused) as caught:
            self.call(root, "resolve", name)
        self.assertEqual(caught.exception.name, "NotFound")


if __name__ == "__main__":
    unittest.main()
