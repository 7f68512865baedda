"""Starting and stopping with a fault at every call: if this fails, reports of rtstart or rtstop are wrong."""
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
from rtshell_lite.system.outcomes import ALREADY, DONE, UNCERTAIN  # noqa: E402
from rtshell_lite.xmlprofile import model  # noqa: E402

ONCE = "plans are the same for every Python"
NAMES = ["Clusterer0", "Controller0", "Hokuyo_AIST0", "Motor0", "Sensor0"]
ASKED = ["get_ports", "get_component_profile", "get_owned_contexts", "get_context_handle",
         "get_component_state"]
TIMEOUT = 0.4


def setUpModule():
    worlds.start_name_server()


def tearDownModule():
    worlds.Server.stop()


class Reported:
    """What a Run reports."""

    def __init__(self):
        self.outcomes = {}

    def starting(self, action, line):
        pass

    def ended(self, result):
        self.outcomes[result.action.component.instance_name] = result.status


class Sweep(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.world = worlds.World("robot")
        cls.profile = loop.run(capture.capture([tree.parse("/127.0.0.1:%d" % worlds.Server.port)])).profile
        assert [each.instance_name for each in cls.profile.components] == NAMES
        targets = [model.Condition(sequence=number, target=model.TargetExecutionContext(
            component_id=each.id, instance_name=each.instance_name, id="0"))
            for number, each in enumerate(cls.profile.components[:3])]
        cls.profile.activation = cls.profile.deactivation = model.MessageSending(targets=targets)

    @classmethod
    def tearDownClass(cls):
        cls.world.close()

    def ctl(self, *words):
        return self.world.ctl(*words).strip()

    def states(self):
        return {name: self.ctl("state", name) for name in NAMES}

    def start(self):
        """{name: outcome}; None where the checks found a failure, and nothing was to be changed."""
        async def start():
            run = run_plan.Run(
                plan.make(self.profile, "activation", "a.xml").actions, transitions.ACTIVATE, reported
            )
            if await run.check(self.profile):
                return None
            await run.carry_out()
            return reported.outcomes
        reported = Reported()
        return loop.run(start(), session=session.Session(TIMEOUT))

    def stop(self):
        async def stop():
            actions = plan.make(self.profile, "deactivation", "a.xml", False).actions
            run = run_plan.Run(actions, transitions.DEACTIVATE, reported)
            await run.find(self.profile)
            await run.carry_out()
        reported = Reported()
        loop.run(stop(), session=session.Session(TIMEOUT))
        return reported.outcomes

    def compare(self, outcomes, reached, before):
        """Check that every outcome agrees with the state of the mock."""
        states = self.states()
        if outcomes is None:
            self.assertEqual(states, dict.fromkeys(NAMES, before))
            return
        self.assertEqual(sorted(outcomes), NAMES)
        for name, outcome in outcomes.items():
            if outcome != UNCERTAIN:
                self.assertEqual(
                    states[name],
                    reached if outcome in (DONE, ALREADY) else before,
                    (name, outcomes),
                )

    def forget(self):
        self.ctl("reset")

    def sweep(self, operation, kind):
        for nth in range(1, 20):
            with self.subTest(operation=operation, kind=kind, nth=nth):
                self.forget()
                self.ctl("fail", operation, str(nth), kind)
                outcomes = self.start()
                self.compare(outcomes, "ACTIVE", "INACTIVE")
                self.forget()
                self.assertLessEqual(set(self.start().values()), {DONE, ALREADY})
                self.assertEqual(set(self.states().values()), {"ACTIVE"})
                changing = operation.replace("activate", "deactivate")
                self.ctl("fail", changing, str(nth), kind)
                stopped = self.stop()
                self.compare(stopped, "INACTIVE", "ACTIVE")
                self.forget()
                self.assertLessEqual(set(self.stop().values()), {DONE, ALREADY})
                self.assertEqual(set(self.states().values()), {"INACTIVE"})
                through = {DONE, ALREADY}
                if outcomes is not None and set(outcomes.values()) | set(stopped.values()) <= through:
                    return
        self.fail("%s: it never came through" % operation)

    def test_changing(self):
        for kind in ("TRANSIENT", "COMM_FAILURE", "HANG", "NO_IMPLEMENT"):
            self.sweep("activate_component", kind)

    def test_asking(self):
        for operation in ASKED:
            self.sweep(operation, "TRANSIENT")

    def test_silence(self):
        for operation in ("get_component_profile", "get_component_state"):
            self.sweep(operation, "HANG")

    def test_a_bug_is_no_outcome(self):
        class Broken(Reported):
            def ended(self, result):
                Reported.ended(self, result)
                raise errors.Usage("as a bug would")

        async def start():
            run = run_plan.Run(
                plan.make(self.profile, "activation", "a.xml").actions, transitions.ACTIVATE, Broken()
            )
            await run.check(self.profile)
            await run.carry_out()
        with self.assertRaises(errors.Usage):
            loop.run(start(), session=session.Session(TIMEOUT))
        self.forget()
        self.stop()


if __name__ == "__main__":
    unittest.main()
