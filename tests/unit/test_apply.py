"""The order of steps: if this fails, restoring a big system takes long, or steps come before those that they need."""
import itertools
import random
import unittest

from rtshell_lite.system import apply, steps


class Step(steps.Step):
    def __init__(self, sites, free):
        steps.Step.__init__(self, sites, "", "")
        self.free = free


class Site:
    required = True


def levels(wanted):
    """The levels of steps, each (sites, free), as lists of numbers."""
    outcomes = [apply.Outcome(Step(*one)) for one in wanted]
    return [[outcomes.index(each) for each in level] for level in apply._levels(outcomes)]


class Levels(unittest.TestCase):
    def test_a_long_chain_of_connections_takes_few(self):
        sites = [Site() for _ in range(200)]
        ring = [([sites[number], sites[(number + step) % 200]], True) for number in range(200) for step in (1, 2)]
        self.assertLessEqual(len(levels(ring)), 8)

    def test_none_shares_a_site_and_order_is_kept_where_it_matters(self):
        for seed in range(200):
            chance = random.Random(seed)
            sites = [Site() for _ in range(chance.randint(1, 6))]
            wanted = [(chance.sample(sites, chance.randint(1, min(3, len(sites)))), chance.random() < 0.6) for _ in range(12)]
            found = levels(wanted)
            at = {number: place for place, level in enumerate(found) for number in level}
            self.assertEqual(sorted(at), list(range(12)))
            for one, other in itertools.combinations(range(12), 2):
                if set(map(id, wanted[one][0])) & set(map(id, wanted[other][0])):
                    self.assertNotEqual(at[one], at[other])
                    if not (wanted[one][1] and wanted[other][1]):
                        self.assertLess(at[one], at[other])
                    if wanted[one] == wanted[other]:  # the removal of what is left of a connection, and the connection
                        self.assertLess(at[one], at[other])


if __name__ == "__main__":
    unittest.main()
