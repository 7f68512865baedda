"""Every command against every kind of broken peer, as name server and as component: one calm line, in time.

If one of these fails, a broken robot takes the tool that is to look after it along. Memory, and omniORB, are
tried in tests/faults/test_peers.py.
"""

import gc
import os
import shutil
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import stories  # noqa: E402: the path first
import bad_peers  # noqa: E402: after the carrier of the bottle
import invocations  # noqa: E402
import peer_cases  # noqa: E402
import test_nth  # noqa: E402

from mock_components import giop  # noqa: E402

from rtshell_lite import cli, notes  # noqa: E402

ONCE = "how long a peer is waited for does not depend on the Python"
SETTINGS = [("world", "linked")]
LEFT = 0.01  # seconds of the world, in which a peer ends that is closed
LONGEST = 200.0  # seconds of the world, after which it counts as endless
# of so many cases one is tried, another one by another seed; with --long all. It has no factor in common with
# the number of kinds, as each of these follows the others
EACH = 97
SEED = int(os.environ.get("RTSHELL_SEED", "1"))
IS_THOROUGH = bool(os.environ.get("RTSHELL_FAULTS"))
COLLECTED = 50  # cases, of which the garbage is collected at once
HOME = "/robot/test.host_cxt/"
SLACK = 0.3  # seconds
# lines that need not ask a component whose name they were given: all others have to reach it
UNASKED = {
    "rtcall -l A",
    "rtcwd SERVER/x.host_cxt",
    "rtdel -f A",
    "rtdel --dry-run --recursive SERVER/x.host_cxt",
    "rtfind SERVER",
    "rtfind SERVER -n none --wait 0.5",
}


class Case(peer_cases.Case):
    """One in a world."""

    def problems(self):
        """What is wrong with what it does."""
        player = stories.Player(SETTINGS)
        peer = bad_peers.Peer(player.world.hosts["robot"], self.mode)
        try:
            found = list(self._judge(self._run(player, peer)))
            needs_none = self.role == "component" and f"{self.command} {self.line}" in UNASKED
            return found + ["the peer is not reached"] * (not peer.is_reached() and not needs_none)
        finally:
            peer.close()
            player.world.run(player.world.time + LEFT)
            player.end()

    def _judge(self, program):
        if not program.is_over:
            yield "it does not end"
            return
        if program.failure is not None:
            yield repr(program.failure)
            return
        out = program.out.text()
        self.err = program.error.text()
        self.seconds = program.ended - program.begun
        yield from self.judge(program.status, out, self.err, len(out) + len(self.err))
        if self.seconds > self.limit() + SLACK:
            yield f"{self.seconds:.1f} s, more than {self.limit() + SLACK:.1f}"

    def _run(self, player, peer):
        """Run the command; its Program."""
        environment = dict(player.environment, RTSHELL_TIMEOUT=str(self.timeout))
        if self.role == "server":
            server = f"/127.0.0.1:{peer.port}"
            names = {"A": "/a.rtc", "B": "/b.rtc", "MGR": "/m.mgr"}
            meant = {word: server + name for word, name in names.items()}
            meant["SERVER"] = self.peer = server
            environment["RTCTREE_NAMESERVERS"] = server[1:]
        else:
            kind, type_id = ("mgr", giop.MANAGER) if "MGR" in self.line else ("rtc", giop.COMPONENT)
            name = [("bad", "host_cxt"), (self.mode, kind)]
            made = player.robot.stages["linked"]
            player.robot.do(made, lambda: made.names.bind(name, peer.reference(type_id)))
            self.peer = path = f"/robot/bad.host_cxt/{self.mode}.{kind}"
            meant = {"SERVER": "/robot/bad.host_cxt", "A": path, "B": HOME + "ConsoleOut0.rtc", "MGR": path}
        meant.update(OUT="out", LOG="log", FILE="file.yaml")
        with open("system.yaml", encoding="utf-8") as file:
            text = file.read()
        for part, name in (("ConsoleIn0", "A"), ("ConsoleOut0", "B")):
            text = text.replace(f"{HOME[1:]}{part}.rtc", meant[name][1:])
        with open("file.yaml", "w", encoding="utf-8") as file:
            file.write(text)
        words = [self.command] + invocations.words(self.line, meant)
        command = stories.Command(player.seat, words, environment, 0.0)
        player.world.run(player.world.time + LONGEST, lambda: command.program.is_over)
        return command.program


class Peers(unittest.TestCase):
    def setUp(self):
        notes.listener = cli._hear
        gc.disable()  # see test_nth.collect
        self.addCleanup(gc.enable)
        self.addCleanup(os.chdir, os.getcwd())
        place = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, place)
        os.chdir(place)
        player = stories.Player(SETTINGS)
        try:
            player.play(f"rtlog -f log -i -e 1 {HOME}ConsoleIn0.rtc:out &")
            for line in ("sleep 2", "ctl write ConsoleIn0:out 42", "wait rtlog"):
                player.play(line)
            player.play("rtcryo -y -o system.yaml /robot")
        finally:
            player.end()
        self.assertTrue(os.path.exists("log") and os.path.exists("system.yaml"))

    def test_every_command_against_every_peer(self):
        everything = peer_cases.cases(Case, bad_peers.MODES)
        tried = everything if IS_THOROUGH else everything[SEED % EACH :: EACH]
        kinds = len(bad_peers.MODES)
        print(f"figures: {len(tried)} of {len(everything)} runs against {kinds} kinds of peers")
        for number, case in enumerate(tried):
            with self.subTest(str(case)):
                self.assertEqual(case.problems(), [], getattr(case, "err", "")[-2000:])
            if not number % COLLECTED:
                test_nth.collect()

    def test_long_lists(self):
        """What one component can list, such as 5,000 contexts, is not asked one by one."""
        for case in peer_cases.long_lists(Case):
            with self.subTest(str(case)):
                self.assertEqual(case.problems(), [], getattr(case, "err", "")[-2000:])
                self.assertLessEqual(case.seconds, case.usual_limit() + SLACK)
                if case.command == "rtcat":
                    self.assertIn("are left out", case.err)


if __name__ == "__main__":
    unittest.main()
