"""Addresses of managers without a name server: if these fail, rtmgr talks to the wrong process."""
import unittest

try:
    import omniORB
except ImportError:
    omniORB = None

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.robot import manager


@unittest.skipUnless(omniORB, "needs omniORBpy")
class Address(unittest.TestCase):

    def told(self, word):
        ref = manager.reference(word)
        return orb.address(ref)[1:]

    def test_port_and_key_have_defaults(self):
        for word in ("corbaloc::robot", "corbaloc:iiop:robot", "corbaloc:iiop:1.2@robot", "corbaloc::robot:2810/manager"):
            self.assertEqual(self.told(word), ("robot", 2810, b"manager"))

    def test_port_and_key_are_taken(self):
        self.assertEqual(self.told("corbaloc:iiop:1.0@robot:2820/other"), ("robot", 2820, b"other"))
        self.assertEqual(self.told("corbaloc::[::1]:2820"), ("::1", 2820, b"manager"))

    def test_what_is_no_address_is_told_before_it_is_used(self):
        for word in ("corbaloc:", "corbaloc::", "corbaloc:iiop:", "corbaloc::robot:0", "corbaloc::robot:65536",
                     "corbaloc::robot:x", "corbaloc:rir:/NameService", "corbaloc:ssliop:robot:1/manager", "corbaloc::a,:b/manager"):
            with self.subTest(word), self.assertRaises(errors.BadPath):
                manager.check(word)


if __name__ == "__main__":
    unittest.main()
