"""What rttop shows, without a network: if this fails, it is silent about what it has not seen."""
import unittest

from rtshell_lite import errors, path
from rtshell_lite.top import model


class GiveUp(unittest.TestCase):
    def test_what_has_not_been_listed_in_time_is_reported(self):
        """A name server that is too slow is no empty one."""
        slow, empty = path.parse("/slow"), path.parse("/empty")
        looking = model.Top([slow, empty], 1.0)
        looking._found[empty] = {}  # as the task that walks there does
        looking._failed[empty] = {}
        looking.give_up()
        (row,) = looking.rows()
        self.assertEqual((row.path, row.kind), ("/slow", "unknown"))
        self.assertIsInstance(row.failure, errors.Silent)


if __name__ == "__main__":
    unittest.main()
