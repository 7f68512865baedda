"""Single changes of a system and their way back: if this fails, --rollback leaves behind what it says that it has undone."""
import unittest
from unittest import mock

from rtshell_lite import errors
from rtshell_lite.system import steps


class Site:
    """A component that the steps do not look at."""

    where, required = "/localhost/a.rtc", True


class ActiveSet(unittest.TestCase):
    def setUp(self):
        self.step, self.after = steps.Active(Site(), "fast"), mock.Mock(active="fast")

    def test_the_set_that_was_active_before_is_active_again(self):
        self.step.undo([mock.Mock(active="slow")], [self.after])
        self.after.configuration.activate.assert_called_once_with("slow")

    def test_where_none_was_active_none_can_be(self):
        with self.assertRaises(errors.Refused) as caught:
            self.step.undo([mock.Mock(active="")], [self.after])
        self.assertIn("had no active configuration set before", str(caught.exception))
        self.after.configuration.activate.assert_not_called()


if __name__ == "__main__":
    unittest.main()
