"""Whether ports that send nothing still exist. If one of these fails, a recorder of a large robot at rest
asks each of its ports every second, or nobody hears that a process has ended.
"""
import types
import unittest

from rtshell_lite.data import connection


class Looks(unittest.TestCase):
    def setUp(self):
        self.due = set(range(1000))
        self.opened = connection.Connections(
            [
                types.SimpleNamespace(
                    number=number, failure=None, endpoint=("a", number // 10), is_still_silent=True,
                    is_due=lambda number=number: number in self.due,
                )
                for number in range(1000)
            ]
        )

    def look(self):
        return [each.number for each in self.opened._due()]

    def test_of_many_silent_ports_some_are_looked_at_at_a_time_and_all_by_turns(self):
        looks = [self.look() for _ in range(1000 // connection.MOST)]
        self.assertEqual({len(numbers) for numbers in looks}, {connection.MOST})
        self.assertEqual({number for numbers in looks for number in numbers}, self.due)

    def test_few_are_looked_at_each_time(self):
        self.due = {3, 5, 7}
        self.assertEqual([self.look() for _ in range(3)], 3 * [[3, 5, 7]])

    def test_one_that_has_just_fallen_silent_is_looked_at_at_once(self):
        self.opened.connections[500].is_still_silent = False
        self.assertEqual(self.look()[0], 500)
        self.assertEqual(self.look()[0], 500)

    def test_those_with_a_process_that_may_have_ended_are_looked_at_at_once(self):
        self.due = {3, 5}
        self.opened._suspect(("a", 90))
        self.assertEqual(self.look(), [*range(900, 910), 3, 5])
        self.assertEqual(self.look(), [3, 5])


if __name__ == "__main__":
    unittest.main()
