"""Addresses of managers without a name server, and what managers are asked for: if these fail, rtmgr talks to
the wrong process, or a manager ignores what it does not understand.
"""
import unittest
from unittest import mock

try:
    import omniORB
except ImportError:
    omniORB = None

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.net import loop
from rtshell_lite.robot import manager


@unittest.skipUnless(omniORB, "needs omniORBpy")
class Address(unittest.TestCase):

    def address(self, word):
        ref = manager.reference(word)
        return orb.address(ref)[1:]

    def test_port_and_key_have_defaults(self):
        for word in (
            "corbaloc::robot",
            "corbaloc:iiop:robot",
            "corbaloc:iiop:1.2@robot",
            "corbaloc::robot:2810/manager",
        ):
            self.assertEqual(self.address(word), ("robot", 2810, b"manager"))

    def test_port_and_key_are_taken(self):
        self.assertEqual(self.address("corbaloc:iiop:1.0@robot:2820/other"), ("robot", 2820, b"other"))
        self.assertEqual(self.address("corbaloc::[::1]:2820"), ("::1", 2820, b"manager"))

    def test_bad_addresses_are_reported_before_use(self):
        for word in (
            "corbaloc:",
            "corbaloc::",
            "corbaloc:iiop:",
            "corbaloc::robot:0",
            "corbaloc::robot:65536",
            "corbaloc::robot:x",
            "corbaloc:rir:/NameService",
            "corbaloc:ssliop:robot:1/manager",
            "corbaloc::a,:b/manager",
        ):
            with self.subTest(word), self.assertRaises(errors.BadPath):
                manager.check(word)


class Argument(unittest.TestCase):
    def test_arguments_that_managers_accept(self):
        for argument in (
            "Motor",
            "Motor?",
            "Motor?a=1",
            "Motor?a=1&b=",
            "RTC:AIST:example:Motor:1.0?a=1&&b=2",
        ):
            manager.check_argument(argument)

    def test_arguments_that_managers_would_misread_are_refused(self):
        for argument in ("", "?a=1", "Motor?a", "Motor?a=1&b", "Motor?a=1?b=2", "Motor?a=b=c"):
            with self.subTest(argument), self.assertRaisesRegex(errors.Usage, "^not MODULE"):
                manager.check_argument(argument)

    def test_why_they_made_nothing(self):
        for most, reason in (("0", "a wrong argument, or its own initialisation failed"),
                             ("10", "a wrong argument, its max_instance of 10 is reached, or its own "
                                    "initialisation failed")):
            factories = [{"implementation_id": (
                "Motor"
            ), "max_instance": most}, {"implementation_id": "Sensor"}]

            async def modules(node, operation):
                return factories
            with mock.patch.object(manager, "modules", modules):
                self.assertEqual(loop.run(manager._why_not(None, "Motor?a=1")), reason)
                self.assertEqual(loop.run(manager._why_not(None, "Arm")), "no factory Arm; there are: "
                                                                          "Motor, Sensor")


if __name__ == "__main__":
    unittest.main()
