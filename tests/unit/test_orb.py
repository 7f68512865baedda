"""What is made of calls that fail: if this fails, who reads the reason looks in the wrong place."""
import sys
import threading
import unittest
from unittest import mock

try:
    import omniORB
except ImportError:
    omniORB = None

from rtshell_lite import errors
from rtshell_lite.corba import omniorb, orb, session
from rtshell_lite.net import loop


class Missing(unittest.TestCase):
    def test_omniorb_that_is_not_installed_has_no_version(self):
        with mock.patch.dict(sys.modules, {"omniORB": None}), mock.patch.dict("os.environ", {"RTSHELL_ORB": (
            "omniorb"
        )}), \
                self.assertRaises(errors.MissingOmniORB):
            orb.version()


class LookUps(unittest.TestCase):
    def test_what_is_looked_up_slowly_is_not_tried_again_at_once(self):
        answered = threading.Event()
        begun = []

        def look_up():
            begun.append(True)
            if len(begun) == 1:
                answered.wait()

        async def main():
            here = session.current()
            with self.assertRaises(errors.Silent):
                await session.on_thread("robot", look_up)
            here.timeout = 1000.0  # a moment, on any machine
            with self.assertRaises(errors.Silent):
                await session.on_thread("robot", look_up)
            self.assertEqual(await session.on_thread("arm", lambda: "10.0.0.2"), "10.0.0.2")
            here.end = loop.now() - 1  # no time is left for others, which nobody has asked about
            with self.assertRaises(errors.NoTime):
                await session.on_thread("desk", lambda: "10.0.0.3")

        self.addCleanup(answered.set)
        loop.run(main(), session=session.Session(0.01))
        self.assertEqual(len(begun), 1)


@unittest.skipUnless(omniORB, "needs omniORBpy")
class Failures(unittest.TestCase):
    def reason(self, failure, seconds=None):
        from omniORB import CORBA
        raised = getattr(CORBA, failure)(0, CORBA.COMPLETED_NO)
        address = mock.Mock(return_value=("IDL:x:1.0", "robot", 1, b"x"))
        with mock.patch.object(omniorb.answers, "invoke", side_effect=raised), mock.patch.object(
            omniORB, "setClientCallTimeout"
        ), mock.patch.object(omniorb, "address", address), mock.patch.object(
            omniorb, "_deadline", 3.0
        ), mock.patch.object(
            orb, "_orb", omniorb
        ), self.assertRaises(
            errors.Error
        ) as caught:
            loop.run(
                orb.call("/robot/a.rtc", mock.Mock(), "get_profile", seconds=seconds),
                session=session.Session(3.0),
            )
        return str(caught.exception)

    def test_silence_is_as_long_as_was_waited(self):
        for seconds, waited in ((None, "3s"), (2, "3s"), (10, "10s")):
            self.assertEqual(self.reason("TIMEOUT", seconds), "/robot/a.rtc: no answer within " + waited)

    def test_nothing_is_asked_of_nothing(self):
        with self.assertRaisesRegex(errors.Garbled, "^/robot/a.rtc: garbled answer .nothing in place of "
                                                    "the object that has get_profile"):
            loop.run(orb.call("/robot/a.rtc", None, "get_profile"))

    def test_kinds(self):
        self.assertEqual(self.reason("OBJECT_NOT_EXIST"), "/robot/a.rtc: zombie (the name is bound, but "
                                                          "its object is gone)")
        self.assertEqual(self.reason("COMM_FAILURE"), "/robot/a.rtc: connection lost")
        self.assertIn("cannot be reached now (CORBA.TRANSIENT", self.reason("TRANSIENT"))
        for failure in ("MARSHAL", "INV_OBJREF"):
            self.assertIn("garbled answer (CORBA." + failure, self.reason(failure))
        self.assertEqual(self.reason("NO_PERMISSION"), "/robot/a.rtc: CORBA.NO_PERMISSION")


if __name__ == "__main__":
    unittest.main()
