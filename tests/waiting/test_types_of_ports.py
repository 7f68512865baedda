"""The data types that ports of several flavours name or publish."""
import unittest

import processes
import worlds
from rtshell_lite import errors, path
from rtshell_lite.data import datatypes, values
from rtshell_lite.net import loop
from rtshell_lite.robot import ports

try:
    import omniORB
except ImportError:
    omniORB = None


@unittest.skipUnless(omniORB and processes.nameserver.binary(), "needs omniNames")
class OfPorts(unittest.TestCase):
    """C++ 1.1 and Java publish a value of a port's type; others only its name."""

    @classmethod
    def setUpClass(cls):
        worlds.start_name_server()

    @classmethod
    def tearDownClass(cls):
        worlds.Server.stop()

    def port(self, flavour):
        world = worlds.World("linked", "--flavour", flavour)
        self.addCleanup(world.close)
        where = path.parse("/127.0.0.1:%d/test.host_cxt/ConsoleIn0.rtc:out" % worlds.Server.port)
        return loop.run(ports.find([where]))[0]

    def renamed(self, port):
        return port._replace(properties=dict(port.properties, **{"dataport.data_type": "IDL:Their/Own:1.0"}))

    def test_types(self):
        for flavour in ("cpp11", "java"):
            port = self.port(flavour)
            self.assertEqual(loop.run(datatypes.Types().of_port(port)).name, "RTC.TimedLong")
            found = loop.run(datatypes.Types().of_port(self.renamed(port)))
            self.assertEqual(values.text(found.decode(b"\1\0\0\0\2\0\0\0\3\0\0\0")), "[1.000000002] 3")
        port = self.port("cpp2")
        with self.assertRaises(errors.NoSuch) as caught:
            loop.run(datatypes.Types().of_port(self.renamed(port)))
        self.assertRegex(
            str(caught.exception),
            r"ConsoleIn0.rtc:out: no such data type known: IDL:Their/Own:1.0; name its IDL",
        )


if __name__ == "__main__":
    unittest.main()
