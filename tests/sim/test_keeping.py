"""rtkeep that is killed at any moment: run again, it ends the same way, with nothing twice and nothing half.
If this fails, a robot that is kept is not as its file says after that.
"""

import gc
import os
import shutil
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import stories  # noqa: E402: the path first

from rtshell_lite import cli, notes  # noqa: E402

ONCE = "what rtkeep does does not depend on the Python"
SETTINGS = [("world", "these ConsoleIn ConfigSample"), ("world", "these ConsoleOut --flavour cpp2")]
STEP = 8e-3  # seconds of the world between two moments, in which there are some calls
BROKEN = (
    "rtdeact --wait 3 ConsoleIn0.rtc ConsoleOut0.rtc ConfigSample0.rtc",
    "rtdis --ensure ConsoleIn0.rtc:out ConsoleOut0.rtc:in",
    "rtconf ConfigSample0.rtc -s mode1 set int_param0=77",
    "rtec ConsoleIn0.rtc rate 500",
)


class Killed(unittest.TestCase):
    def setUp(self):
        notes.listener = cli._hear
        gc.disable()  # coroutines of what was killed complain
        self.addCleanup(gc.enable)
        self.addCleanup(os.chdir, os.getcwd())
        place = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, place)
        os.chdir(place)
        self.player = stories.Player(SETTINGS)
        self.addCleanup(self.player.end)

    def well(self, line):
        lines = self.player.play(line)
        self.assertFalse([each for each in lines if each[0] == "!"], (line, lines))
        return lines

    def test_at_any_moment(self):
        self.well("rtcon -i straight ConsoleIn0.rtc:out ConsoleOut0.rtc:in")
        self.well("rtact --wait 3 ConsoleIn0.rtc ConsoleOut0.rtc ConfigSample0.rtc")
        self.well("rtcryo --all -o robot.rtsys")
        number = 0
        while self.is_killed_at(number * STEP):
            number += 1
        self.assertGreater(number, 30, "it takes some calls")

    def is_killed_at(self, seconds):
        """Break all, run an rtkeep that is killed after some time, then another one.

        Returns whether the first ran for so long.
        """
        for line in BROKEN:
            self.well(line)
        self.player.play("rtkeep --once robot.rtsys &")
        program = self.player.commands.pop("rtkeep").program
        self.player.play(f"sleep {seconds}")
        is_over = program.is_over
        program.kill()
        with self.subTest(seconds=seconds):
            self.well("rtkeep --once robot.rtsys")
            self.well("rtcheck robot.rtsys")
            for where in ("@these ConsoleIn0:out", "@these2 ConsoleOut0:in"):
                process, port = where.split()
                found = self.player.play(f"ctl {process} connectors {port}")
                self.assertEqual(len(found), 1, (seconds, found))
        return not is_over


if __name__ == "__main__":
    unittest.main()
