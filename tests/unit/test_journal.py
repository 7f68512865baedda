"""When the profile of a system gets into a log."""
import unittest
from unittest import mock

from loops import wait_for

from rtshell_lite import errors
from rtshell_lite.net import loop
from rtshell_lite.system import journal


class Profiles(unittest.TestCase):
    def setUp(self):
        self.attached = []
        self.journal = journal.Journal([])
        self.journal._work = mock.Mock(attach=lambda moment, name, *data: self.attached.append(name))

    def look(self, now, describe):
        """What is attached when a system is described so, at `now` seconds."""
        with mock.patch.object(loop, "now", lambda: now), mock.patch.object(journal, "describe", describe):
            wait_for(self.journal._describe())
        return self.attached

    def change(self, now):
        with mock.patch.object(loop, "now", lambda: now):
            self.journal.put("/localhost/A0.rtc", "LIFE_EVENT", "", "APPEARED")

    def test_one_that_could_not_be_made_is_tried_again(self):
        self.change(50.0)
        self.assertEqual(self.look(50.0, self.refuse), [])
        self.assertEqual(self.look(55.0, self.describe), [])
        self.assertEqual(self.look(61.0, self.describe), ["system-1.rtsys", "components-1.json"])
        self.assertEqual(len(self.look(99.0, self.describe)), 2)

    def test_at_the_start_and_when_a_change_is_over(self):
        self.change(50.0)
        self.assertEqual(self.look(50.0, self.describe), ["system-1.rtsys", "components-1.json"])
        self.change(70.0)
        self.assertEqual(len(self.look(71.0, self.describe)), 2)
        self.assertEqual(self.look(72.5, self.describe)[2:], ["system-2.rtsys", "components-2.json"])

    async def describe(self, tops):
        return b"", b""

    async def refuse(self, tops):
        raise errors.Failed("/localhost", "no answer")


if __name__ == "__main__":
    unittest.main()
