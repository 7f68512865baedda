"""A bug in what reports of rtstart or rtstop: if this fails, it is taken for an outcome.

That the reports are true with a fault at every call is in tests/sim/test_starting.py.
"""
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))

import worlds  # noqa: E402
from rtshell_lite import errors  # noqa: E402
from rtshell_lite.corba import session  # noqa: E402
from rtshell_lite.net import loop  # noqa: E402
from rtshell_lite.robot import transitions, tree  # noqa: E402
from rtshell_lite.system import capture, plan, run_plan  # noqa: E402
from rtshell_lite.xmlprofile import model  # noqa: E402

ONCE = "plans are the same for every Python"
TIMEOUT = 0.4


class Broken:
    """Has a bug."""

    def starting(self, action, line):
        pass

    def ended(self, result):
        raise errors.Usage("as a bug would")


class Bugs(unittest.TestCase):
    def test_a_bug_is_no_outcome(self):
        worlds.start_name_server()
        self.addCleanup(worlds.Server.stop)
        world = worlds.World("linked")
        self.addCleanup(world.close)
        server = tree.parse("/127.0.0.1:%d" % worlds.Server.port)
        profile = loop.run(capture.capture([server])).profile
        first = profile.components[0]
        target = model.TargetExecutionContext(
            component_id=first.id, instance_name=first.instance_name, id="0"
        )
        condition = model.Condition(sequence=1, target=target)
        profile.activation = model.MessageSending(targets=[condition])

        async def start():
            actions = plan.make(profile, "activation", "a.xml").actions
            run = run_plan.Run(actions, transitions.ACTIVATE, Broken())
            await run.check(profile)
            await run.carry_out()
        with self.assertRaises(errors.Usage):
            loop.run(start(), session=session.Session(TIMEOUT))


if __name__ == "__main__":
    unittest.main()
