"""The components of `rtshell_lite demo`, where others send and set what no component can work with."""

import math
import random
import unittest

from loops import wait_for
from rtshell_lite.corba import orb
from rtshell_lite.data import datatypes
from rtshell_lite.net import loop
from rtshell_lite.play import carriers, demo, live

NUMBERS = [math.inf, -math.inf, math.nan, 1e308, -1e308, 1e200, 0.0, -1.0]
SETTINGS = [repr(number) for number in NUMBERS] + ["", "x"]


class Components(unittest.TestCase):
    def run_with(self, work):
        async def main():
            async with loop.Group() as tasks:
                await work(demo.make(tasks).by_name, tasks)
                tasks.cancel()

        wait_for(main(), timeout=30)

    def test_goes_to_error_at_numbers_that_are_none_and_can_be_reset(self):
        drawn = random.Random(7)

        async def work(by_name, tasks):
            for name, part in by_name.items():
                sets = {key: dict(values) for key, values in part.configuration.sets.items()}
                context = part.contexts[0]
                context.running = True
                context.set_state(part, "Active")
                for _ in range(300):
                    self.disturb(part, drawn)
                    part._execute(0.1)
                    context.set_state(part, "Active")
                part.configuration.sets = sets
                for port in part.ports:
                    port.value = None
                part._execute(0.1)
                self.assertEqual(context.state_of(part), "Active", name)
                for attribute in ("angle", "charge", "temperature"):
                    self.assertTrue(math.isfinite(getattr(part, attribute, 0.0)), f"{name}.{attribute}")

        self.run_with(work)

    def disturb(self, part, drawn):
        """Have any number in its in ports, and its settings."""
        for port in part.ports:
            if isinstance(port, live.InPort):
                port.value = self.value(port.properties["dataport.data_type"], drawn)
        for values in part.configuration.sets.values():
            for key in values:
                values[key] = drawn.choice(SETTINGS)

    def value(self, type_id, drawn):
        if "Seq" in type_id:
            return drawn.sample(NUMBERS, 2)
        if "Pose2D" in type_id:
            return orb.struct("RTC.Pose2D")(orb.struct("RTC.Point2D")(*drawn.sample(NUMBERS, 2)), 0.0)
        return drawn.choice(NUMBERS)

    def test_has_a_new_rate_at_once(self):
        async def work(by_name, tasks):
            part = by_name["Battery0"]
            executed = loop.Bell()
            part._execute = lambda seconds: executed.ring()
            (context,) = part.contexts
            context.set_rate(1e-320)
            tasks.start(part.work())
            await loop.sleep(0)
            for _ in range(2):
                context.set_rate(100.0)
                self.assertTrue(await executed.wait(10))
                context.set_rate(1e-320)
                await executed.wait(0.1)  # one more, as the rate has changed

        self.run_with(work)


class Gripper(unittest.TestCase):
    def setUp(self):
        self.hand = demo.Gripper("Gripper0", datatypes.Types(), None)
        self.context = self.hand.contexts[0]
        self.context.set_state(self.hand, "Error")

    def rest(self, limit):
        self.hand.configuration.sets["default"]["limit"] = limit
        self.hand.rest(0.1)
        return self.context.state_of(self.hand)

    def test_it_goes_on_when_it_is_cool(self):
        self.hand.temperature = self.hand.COOL + 1
        self.assertEqual(self.rest("60"), "Error")
        self.hand.temperature = self.hand.COOL
        self.assertEqual(self.rest("60"), "Active")

    def test_a_limit_that_it_never_gets_below(self):
        """It stays in Error: it would be in Error again at once, and so on."""
        self.assertEqual(self.rest(str(self.hand.COOL)), "Error")
        with self.assertRaises(live.Fault):
            self.hand.step(0.1)
        self.assertEqual(self.rest("60"), "Active")


class Properties(unittest.TestCase):
    def test_takes_no_digits_that_are_no_numbers(self):
        self.assertEqual(carriers._number("12", 8), 12)
        self.assertEqual(carriers._number("\u00b2", 8), 8)  # a superscript: isdigit() says it is one
