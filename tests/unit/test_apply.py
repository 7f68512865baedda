"""How steps are carried out: if this fails, a big system takes long to restore, steps overtake those they
need, or the report is not what there is.
"""
import itertools
import random
import unittest

from rtshell_lite import errors
from rtshell_lite.net import loop
from rtshell_lite.system import apply, placements, steps
from rtshell_lite.system.outcomes import DONE, FAILED, NOT_UNDONE, UNCERTAIN, UNDONE


class Step(steps.Step):
    def __init__(self, placements, free):
        steps.Step.__init__(self, placements, "", "")
        self.free = free


class Placement:
    required = True


def levels(wanted):
    """The levels of steps, each (placements, free), as lists of numbers."""
    outcomes = [apply.Outcome(Step(*one)) for one in wanted]
    return [[outcomes.index(each) for each in level] for level in apply._levels(outcomes)]


class Levels(unittest.TestCase):
    def test_a_long_chain_of_connections_takes_few(self):
        placements = [Placement() for _ in range(200)]
        ring = [
            ([placements[number], placements[(number + step) % 200]], True)
            for number in range(200)
            for step in (1, 2)
        ]
        self.assertLessEqual(len(levels(ring)), 8)

    def test_none_shares_a_site_and_order_is_kept_where_it_matters(self):
        for seed in range(200):
            chance = random.Random(seed)
            placements = [Placement() for _ in range(chance.randint(1, 6))]
            wanted = [
                (chance.sample(placements, chance.randint(1, min(3, len(placements)))), chance.random() < 0.6)
                for _ in range(12)
            ]
            found = levels(wanted)
            at = {number: place for place, level in enumerate(found) for number in level}
            self.assertEqual(sorted(at), list(range(12)))
            for one, other in itertools.combinations(range(12), 2):
                if set(map(id, wanted[one][0])) & set(map(id, wanted[other][0])):
                    self.assertNotEqual(at[one], at[other])
                    if not (wanted[one][1] and wanted[other][1]):
                        self.assertLess(at[one], at[other])
                    # the removal of what is left of a connection, and the connection
                    if wanted[one] == wanted[other]:
                        self.assertLess(at[one], at[other])


class Switch(steps.Step):
    """A step that turns something on. `found`: what one look after the other finds, if not whether it is on:
    an error, or the exception that ends the command, or a text that says why it cannot be turned on.
    """

    endpoint = "switch"

    def __init__(self, where, *found, undoes=True):
        super().__init__([], where, where)
        self.on = False
        self.undoes = undoes
        self.coming = list(found)

    def questions(self):
        return [placements.Question(self.endpoint, self.where, self.position)]

    async def position(self):
        return self.coming.pop(0) if self.coming else self.on

    def differences(self, answers):
        if answers[0] is KeyboardInterrupt:
            raise KeyboardInterrupt
        if answers[0] is not True:
            obstacle = errors.Failed(self.where, answers[0]) if answers[0] else None
            yield steps.Difference("switch", None, True, answers[0], obstacle)

    async def act(self, answers):
        self.on = True

    async def undo(self, before, after):
        self.on = not self.undoes


class Reports(unittest.TestCase):
    """What is reported of steps, by what was found after them."""

    def check(self, switches, expected, all_or_nothing=False):
        outcomes = [apply.Outcome(switch) for switch in switches]
        try:
            loop.run(apply.carry_out(outcomes, all_or_nothing))
        except KeyboardInterrupt:
            pass
        self.assertEqual(
            [(outcome.status, outcome.error and str(outcome.error)) for outcome in outcomes], expected
        )

    def test_failed_undoing_is_reported(self):
        self.check([Switch("a", undoes=False), Switch("b", False, False), Switch("c")],
                   [(NOT_UNDONE, "a: is still there"), (FAILED, "b: reported success, but nothing changed"),
                    (UNDONE, None)], True)

    def test_an_interruption_while_it_was_undone(self):
        self.check([Switch("a"), Switch("b", False, True, KeyboardInterrupt), Switch("c", False, False)],
                   [(DONE, None), (NOT_UNDONE, "b: interrupted while it was undone"),
                    (FAILED, "c: reported success, but nothing changed")], True)

    def test_a_look_that_fails_twice_leaves_it_uncertain(self):
        lost = errors.Refused("a", "no answer to that")
        self.check(
            [Switch("a", False, lost, lost), Switch("b", False, lost)],
            [(UNCERTAIN, "a: no answer to that; whether it was done is not known"), (DONE, None)],
        )

    def test_a_step_that_its_look_rules_out_has_failed(self):
        self.check([Switch("a", False, "is no switch"), Switch("b", "is no switch")],
                   [(FAILED, "a: is no switch"), (FAILED, "b: is no switch")])


if __name__ == "__main__":
    unittest.main()
