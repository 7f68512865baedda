"""Starting and stopping with a fault at every call: if this fails, reports of rtstart or rtstop are wrong."""

import json
import os
import shutil
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import stories  # noqa: E402: the path first

from rtshell_lite import cli, notes  # noqa: E402

ONCE = "plans are the same for every Python"
NAMES = ["Clusterer0", "Controller0", "Hokuyo_AIST0", "Motor0", "Sensor0"]
ASKED = [
    "get_ports",
    "get_component_profile",
    "get_owned_contexts",
    "get_context_handle",
    "get_component_state",
]
TARGET = (
    '<rts:targets rts:sequence="{}"><rts:TargetComponent rts:componentId="{}" rts:instanceName="{}" '
    'rts:id="0"/></rts:targets>'
)
SETTINGS = [("world", "robot")]
KNOWN = {"done": True, "already": True, "failed": False, "not tried": False}  # whether it is as was wanted
THROUGH = {"done", "already"}


class Sweep(unittest.TestCase):
    def setUp(self):
        notes.listener = cli._hear
        self.addCleanup(os.chdir, os.getcwd())
        place = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, place)
        os.chdir(place)
        self.player = stories.Player(SETTINGS)
        self.addCleanup(self.player.end)
        self.play("rtcryo --all -o a.xml /robot")
        plan = [TARGET.format(number, name, name) for number, name in enumerate(NAMES[:3])]
        lines = []
        for kind in ("Activation", "Deactivation"):
            lines += [f"<rts:{kind}>", *plan, f"</rts:{kind}>"]
        self.play("insert a.xml b.xml", *lines)

    def play(self, *lines):
        return self.player.play(*lines)

    def states(self):
        return {name: self.play(f"ctl state {name}")[0] for name in NAMES}

    def run_plan(self, command):
        """{name: what the command says that has become of it}"""
        lines = [line for line in self.play(f"{command} -q --json --timeout 0.4 b.xml") if line[0] == "{"]
        rows = map(json.loads, lines)
        return {row["path"].rpartition("/")[2][: -len(".rtc")]: row["result"] for row in rows}

    def compare(self, outcomes, reached, before):
        """Check that every outcome agrees with the state of the mock."""
        self.assertEqual(sorted(outcomes), NAMES)
        for name, state in self.states().items():
            is_so = KNOWN.get(outcomes[name])
            if is_so is not None:
                self.assertEqual(state, reached if is_so else before, (name, outcomes))

    def through(self, command, state):
        """Without a fault all of it is done."""
        self.play("ctl reset")
        self.assertLessEqual(set(self.run_plan(command).values()), THROUGH)
        self.assertEqual(set(self.states().values()), {state})

    def sweep(self, operation, kind):
        for nth in range(1, 20):
            with self.subTest(operation=operation, kind=kind, nth=nth):
                self.play(f"ctl fail {operation} {nth} {kind}")
                started = self.run_plan("rtstart")
                self.compare(started, "ACTIVE", "INACTIVE")
                self.through("rtstart", "ACTIVE")
                self.play(f"ctl fail {operation.replace('activate', 'deactivate')} {nth} {kind}")
                stopped = self.run_plan("rtstop")
                self.compare(stopped, "INACTIVE", "ACTIVE")
                self.through("rtstop", "INACTIVE")
                if {*started.values(), *stopped.values()} <= THROUGH:
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


if __name__ == "__main__":
    unittest.main()
