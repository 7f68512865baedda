"""A test of a robot program, as you may write it: `python3 docs/example_test.py`, with rtshell_lite
installed, or with its wheel or a checkout on PYTHONPATH.

The program is `supervise`: it starts what is connected to a sensor, and resets what is in Error. The test
runs it on mocks, which need nothing but rtshell_lite.
"""
import unittest
from typing import List

from rtshell_lite import api, mocks


def supervise(home: str) -> List[str]:
    """Reset what is in Error below a directory and activate all; returns the paths of what was reset."""
    reset: List[str] = []
    for component in api.components(home):
        if component.state == "Error":
            component.reset(wait=5)
            reset.append(component.path)
        component.activate(wait=5)
    return reset


class Sensor(mocks.Component):
    outs = {"out": "RTC.TimedLong"}


class Motor(mocks.Component):
    ins = {"in": "RTC.TimedLong"}
    outs = {"doubled": "RTC.TimedLong"}

    def step(self, seconds: float) -> None:
        self.port("doubled").send(2 * self.value("in", 0))


ROBOT = {"Sensor0.rtc": Sensor, "Motor0.rtc": Motor}


class Supervise(unittest.TestCase):
    def test_it_resets_and_activates(self) -> None:
        with mocks.robot(ROBOT, [("Sensor0:out", "Motor0:in")], active=True) as robot:
            robot.fail("Motor0")
            self.assertEqual(supervise(robot.home), [robot.path("Motor0.rtc")])
            self.assertEqual({component.state for component in api.components(robot.home)}, {"Active"})

    def test_a_value_goes_through(self) -> None:
        with mocks.robot(ROBOT) as robot:
            motor = api.component(robot.path("Motor0.rtc"))
            with api.connected(robot.path("Sensor0.rtc:out"), motor.path + ":in"):
                motor.activate(wait=5)
                robot.send("Sensor0:out", 21)
                self.assertEqual(robot.received("Motor0:in"), [21])
                self.assertEqual(api.next_value(motor.path + ":doubled", timeout=5).data, 42)

    def test_a_motor_that_has_died(self) -> None:
        with mocks.robot(ROBOT) as robot:
            robot.kill("Motor0")
            self.assertEqual(api.zombies(robot.home), [robot.path("Motor0.rtc")])
            self.assertEqual(supervise(robot.home), [])

    def test_a_robot_that_is_not_there(self) -> None:
        with mocks.robot(ROBOT) as robot:
            with self.assertRaises(api.Error) as caught:
                api.component(robot.path("Arm0.rtc"))
            self.assertEqual(caught.exception.why, "no such path")


if __name__ == "__main__":
    unittest.main()
