"""A test of a robot program, as you may write it: `PYTHONPATH=. python3 docs/example_test.py` runs it in a
checkout.

The program is `supervise`: it starts what is connected to a sensor, and resets what is in Error. The test
runs it on mock components, real CORBA objects in a process of their own, beside a name server of their own.
"""
import unittest
from typing import List

from mock_components import world

from rtshell_lite import api


def supervise(home: str) -> List[str]:
    """Reset what is in Error below a directory and activate all; returns the paths of what was reset."""
    reset: List[str] = []
    for component in api.components(home):
        if component.state == "Error":
            component.reset(wait=5)
            reset.append(component.path)
        component.activate(wait=5)
    return reset


class Supervise(unittest.TestCase):
    def test_it_resets_and_activates(self) -> None:
        with world("linked") as robot:
            robot.ctl("error", "ConsoleOut0")
            self.assertEqual(supervise(robot.home), [robot.path("ConsoleOut0.rtc")])
            self.assertEqual({component.state for component in api.components(robot.home)}, {"Active"})

    def test_a_value_goes_through(self) -> None:
        with world("two") as robot:
            out = robot.path("ConsoleIn0.rtc:out")
            into = robot.path("ConsoleOut0.rtc:in")
            with api.connected(out, into, subscription_type="flush"):
                api.component(robot.path("ConsoleOut0.rtc")).activate(wait=5)
                robot.ctl("write", "ConsoleIn0:out", 42)
                self.assertIn("42", robot.ctl("received", "ConsoleOut0:in", 1))

    def test_a_robot_that_is_not_there(self) -> None:
        with world("two") as robot:
            with self.assertRaises(api.Error) as caught:
                api.component(robot.path("Motor0.rtc"))
            self.assertEqual(caught.exception.why, "no such path")


if __name__ == "__main__":
    unittest.main()
