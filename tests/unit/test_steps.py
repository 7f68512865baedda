"""Single changes of a system and their way back: if this fails, --rollback leaves behind what it says that it has undone."""
import unittest
from unittest import mock

from rtshell_lite import errors
from rtshell_lite.robot import configuration
from rtshell_lite.system import steps


class Site:
    """A component that the steps do not look at."""

    where, required, found = "/localhost/a.rtc", True, None


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

    def test_files_name_a_default_set_of_components_that_have_none(self):
        step = steps.Active(Site(), "default")
        for sets in ([], [configuration.Set("__widget__", "", {}, False)]):
            self.assertTrue(step.is_done([steps.Configured(sets, "", None)]))
        with self.assertRaises(errors.NoSuch):
            self.step.is_done([steps.Configured([], "", None)])


class Values(unittest.TestCase):
    def differences(self, values, active="fast", active_before=None):
        step = steps.Values(Site(), "fast", values)
        step.active_before = active_before
        sets = [configuration.Set("fast", "", {"a": "1", "b": "2"}, True)]
        return [(each.what, each.name, each.actual, each.obstacle is None)
                for each in step.differences([steps.Configured(sets, active, None)])]

    def test_differ(self):
        self.assertEqual(self.differences({"a": "1"}), [])
        self.assertEqual(self.differences({"b": "3", "c": "1", "a": "1"}),
                         [("value", "b", "2", True), ("parameter", "c", None, False)])

    def test_the_set_that_was_active_has_to_be_again(self):
        self.assertEqual(self.differences({"a": "1"}, "", "fast"), [("active set", None, "", True)])
        self.assertEqual(self.differences({"a": "1"}, "fast", "fast"), [])


if __name__ == "__main__":
    unittest.main()
