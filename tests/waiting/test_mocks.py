"""rtshell_lite.mocks, as tests of robot programs use it: if one of these fails, a component's author cannot
test with what is on the robot.
"""
import contextlib
import threading
import unittest

from rtshell_lite import api, errors, mocks


class Sensor(mocks.Component):
    outs = {"out": "RTC.TimedLong", "pose": "RTC.TimedPose2D"}


class Motor(mocks.Component):
    ins = {"in": "RTC.TimedLong", "pose": "RTC.TimedPose2D"}
    settings = {"default": {"gain": "2"}}

    def step(self, seconds):
        if self.value("in", 0) < 0:
            raise mocks.Fault


class Broken(mocks.Component):
    def step(self, seconds):
        raise TypeError("a mistake of the test")


ROBOT = {"base.host_cxt/Sensor0.rtc": Sensor, "base.host_cxt/Motor0.rtc": Motor}
CONNECTED = [("Sensor0:out", "Motor0:in"), ("Sensor0:pose", "Motor0:pose")]


class Robots(unittest.TestCase):
    def test_values_go_through_connections(self):
        with mocks.robot(ROBOT, CONNECTED) as robot:
            for number in 1, 2:
                robot.send("Sensor0:out", number)
                self.assertEqual(robot.received("Motor0:in"), [number])
            robot.send("Sensor0:pose", {"data": {"position": {"x": 1, "y": 2}, "heading": 0}})
            (pose,) = robot.received("Motor0:pose")
            self.assertEqual((pose.position.x, pose.position.y), (1.0, 2.0))
            with self.assertRaisesRegex(errors.Unreachable, r"Motor0:in: 0 of 1 values within 0\.1s"):
                robot.received("Motor0:in", timeout=0.1)
            with self.assertRaises(errors.BadValue):
                robot.send("Sensor0:out", "many")

    def test_states(self):
        with mocks.robot(ROBOT, CONNECTED, active=True) as robot:
            motor = api.component(robot.path("base.host_cxt/Motor0.rtc"))
            self.assertEqual(motor.state, "Active")
            robot.fail("Motor0")
            self.assertEqual(motor.state, "Error")
            motor.reset(wait=5)
            self.assertEqual(robot.component("Motor0").setting("gain"), 2)
            motor.configure({"gain": 3})
            self.assertEqual(robot.component("Motor0").setting("gain"), 3)

    def test_two_robots_at_once_and_nothing_left(self):
        before = threading.enumerate()
        with mocks.robot(ROBOT) as one, mocks.robot(ROBOT) as other:
            self.assertNotEqual(one.address, other.address)
            for robot in one, other:
                self.assertEqual(len(api.components(robot.home)), 2)
        with self.assertRaises(errors.Unreachable):
            api.components(one.home)
        for thread in set(threading.enumerate()) - set(before):
            thread.join(10.0)
            self.assertFalse(thread.is_alive(), thread)

    def test_a_component_that_is_killed(self):
        with mocks.robot(ROBOT, CONNECTED) as robot:
            robot.kill("Motor0")
            self.assertEqual(api.zombies(robot.home), [robot.path("base.host_cxt/Motor0.rtc")])

    def test_a_composite(self):
        robot = {"Arm0.rtc": mocks.Component, "Motor0.rtc": Motor}
        with mocks.robot(robot, members={"Arm0": ["Motor0"]}) as robot:
            api.component(robot.path("Arm0.rtc")).activate(wait=5)
            self.assertEqual(api.component(robot.path("Motor0.rtc")).state, "Active")

    def test_mistakes_end_the_test_that_makes_them(self):
        with self.assertRaisesRegex(TypeError, "a mistake of the test"):
            with mocks.robot({"Broken0.rtc": Broken}) as robot:
                broken = api.component(robot.path("Broken0.rtc"))
                with contextlib.suppress(api.Error):
                    broken.activate()
                    while broken.state:
                        pass
        with self.assertRaises(errors.Error):
            with mocks.robot({"Bad0.rtc": type("Bad", (mocks.Component,), {"ins": {"in": "No.SuchType"}})}):
                pass
        with mocks.robot(ROBOT) as robot:
            for act in (
                lambda: robot.fail("Motor1"), lambda: robot.send("Motor0", 1),
                lambda: robot.received("Motor0:none"),
            ):
                self.assertRaises(errors.NoSuch, act)
        with self.assertRaises(errors.NoSuch):
            with mocks.robot(ROBOT, [("Sensor0:out", "Motor1:in")]):
                pass
        with self.assertRaisesRegex(ValueError, "Motor0"):
            with mocks.robot({"a.host_cxt/Motor0.rtc": Motor, "b.host_cxt/Motor0.rtc": Motor}):
                pass


if __name__ == "__main__":
    unittest.main()
