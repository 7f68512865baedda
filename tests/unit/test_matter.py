"""What rtkeep knows of a thing that a file sets. If one of these fails, it undoes what a person has done, or
leaves alone what nobody has.
"""
import unittest

from rtshell_lite.system import matter
from rtshell_lite.system.matter import AGREED, BY_HAND, UNKNOWN


class Knowledge(unittest.TestCase):
    def setUp(self):
        self.matter = matter.Matter()

    def test_only_what_has_agreed_can_be_changed_by_hand(self):
        self.assertFalse(self.matter.is_agreed("5"))
        self.assertEqual(self.matter.agree("5"), UNKNOWN)
        self.assertTrue(self.matter.is_agreed("5"))
        self.assertTrue(self.matter.differ("was changed by hand"))
        self.assertFalse(self.matter.differ("was changed by hand, too"), "that is no news")
        self.assertEqual((self.matter.knowledge, self.matter.words), (BY_HAND, "was changed by hand"))

    def test_another_setting_in_the_file_counts_more_than_a_person(self):
        self.matter.agree("5")
        self.matter.differ("was changed by hand")
        self.assertTrue(self.matter.is_agreed("5"))
        self.assertFalse(self.matter.is_agreed("6"))
        self.assertEqual(self.matter.agree("6"), BY_HAND)
        self.assertEqual(self.matter.knowledge, AGREED)

    def test_nobody_is_blamed_for_an_error_and_a_person_is_not_forgotten(self):
        self.matter.agree()
        self.matter.lose()
        self.assertEqual(self.matter.knowledge, UNKNOWN)
        self.matter.lose()
        self.matter.agree()
        self.matter.differ("was made Inactive by hand")
        self.matter.lose()
        self.assertEqual(self.matter.knowledge, BY_HAND)

    def test_a_complaint_is_over_once_it_agrees(self):
        self.matter.complaint = "it refuses"
        self.matter.agree()
        self.assertIsNone(self.matter.complaint)


if __name__ == "__main__":
    unittest.main()
