"""rttrace on chains with one fault each, drawn by seed: if this fails, it blames a stage that passes values
on, or none. On a machine that is too busy to tell, it may say so.
"""
import os
import random
import re
import subprocess
import time
import unittest

import running
import worlds
from worlds import Server, World

FAULTS = ("stopped", "held", "thinned", "delayed", "disordered", "inactive", "halted", "slow", "cut")
ROUNDS = 30 if running.THOROUGH else 3
SECONDS = 3
NOT_SURE = "not sure: this machine is too busy to tell"


def setUpModule():
    worlds.start_name_server()


def tearDownModule():
    Server.stop()


class Chains(unittest.TestCase):
    def trace(self, count, *fault):
        """What rttrace prints of a chain; how many seconds it took."""
        world = World("chain", str(count), *fault)
        try:
            top = "/localhost:%d/test.host_cxt/" % Server.port
            begun = time.monotonic()
            done = subprocess.run(
                [
                    "rttrace",
                    "-t",
                    str(SECONDS),
                    top + "Link0.rtc:out",
                    "--to",
                    top + "Link%d.rtc:in" % (count - 1),
                ],
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                universal_newlines=True,
                env=worlds.ENVIRONMENT,
            )
            return done.stdout, done.returncode, time.monotonic() - begun
        finally:
            world.close()

    def test_the_stage_with_the_fault_is_named(self):
        chance = random.Random(int(os.environ.get("RTSHELL_SEED", 1)))
        took = []
        not_sure = 0
        for number in range(ROUNDS):
            count = chance.randint(3, 30)
            fault = FAULTS[number % len(FAULTS)]
            place = chance.randint(1, count - 2)
            with self.subTest("%s@%d of %d" % (fault, place, count)):
                said, status, seconds = self.trace(count, "%s@%d" % (fault, place))
                took.append(seconds)
                if NOT_SURE in said:
                    not_sure += 1
                    self.assertEqual(status, 4, said)
                    continue
                wanted = place - 1 if fault == "cut" else place
                self.assertRegex(
                    said,
                    r"(?m)^/localhost:\d+/test\.host_cxt/Link%d\.rtc: .*\((certain|probable)\)$" % wanted,
                )
                self.assertEqual(status, 1, said)
        print(
            "figures: %d of %d faults named in %.1f s at most, %.1f s in the mean"
            % (ROUNDS - not_sure, ROUNDS, max(took), sum(took) / len(took))
        )

    def test_nothing_is_named_where_all_is_well(self):
        chance = random.Random(int(os.environ.get("RTSHELL_SEED", 1)) + 1)
        for _ in range(ROUNDS):
            count = chance.randint(2, 30)
            with self.subTest(count):
                said, status, _ = self.trace(count)
                if NOT_SURE in said:
                    self.assertEqual(status, 4, said)
                    continue
                self.assertTrue(re.search("^no stage stops", said, re.MULTILINE), said)
                self.assertEqual((status, said.count(" yes ")), (0, count - 1), said)


if __name__ == "__main__":
    unittest.main()
