"""Transcripts as they are played: if it fails, a command may be broken and its transcript still pass."""
import os
import signal
import subprocess
import sys
import tempfile
import unittest

import processes
import transcripts
import worlds


def run(text, shell="dash", accept=False, time_limit=20, pure=True):
    with tempfile.TemporaryDirectory() as directory:
        path = os.path.join(directory, "case.t")
        with open(path, "w", encoding="utf-8") as file:
            file.write(("python: pure\n\n" if pure else "\n\n") + text)
        outcome, explanation = transcripts.run_case(path, shell, accept=accept, time_limit=time_limit)
        with open(path, encoding="utf-8") as file:
            return outcome, explanation, file.read().partition("\n\n")[2]


class Running(unittest.TestCase):
    def test_pass_under_each_shell(self):
        for shell in transcripts.SHELLS:
            if shell not in transcripts.missing_shells():
                text = "  $ printf 'a\\n\\nb'; echo c >&2; (exit 3)\n  a\n\n  bc\n  [3]\n\n  $ echo $?\n  3\n"
                self.assertEqual(run(text, shell)[:2], ("pass", ""))

    def test_wrong_output_fails(self):
        outcome, explanation, _ = run("  $ echo b\n  a\n")
        self.assertEqual(outcome, "fail")
        self.assertIn("-  a\n+  b", explanation)

    def test_missing_extra_and_unended_output_fails(self):
        for text in "  $ true\n  a\n", "  $ echo a\n", "  $ printf a\n  a\n", "  $ echo\n":
            self.assertEqual(run(text)[0], "fail", text)

    def test_wrong_status_fails(self):
        for text in "  $ (exit 3)\n", "  $ true\n  [3]\n", "  $ (exit 4)\n  [3]\n":
            self.assertEqual(run(text)[0], "fail", text)

    def test_session_that_ends_early_fails(self):
        outcome, explanation, _ = run("  $ exit 0\n\n  $ echo a\n  a\n")
        self.assertEqual(outcome, "fail")
        self.assertIn("the shell ended (0) in: exit 0", explanation)

    def test_syntax_error_fails(self):
        self.assertEqual(run("  $ echo 'a\n  a\n")[0], "fail")

    def test_time_limit(self):
        outcome, explanation, _ = run("  $ echo a\n  a\n\n  $ echo b; sleep 600\n  b\n", time_limit=0.5)
        self.assertEqual(outcome, "fail")
        self.assertIn("no end after 0.5 s in: echo b; sleep 600\nb", explanation)

    def test_accept(self):
        text = "Prose.\n\n  $ echo 12; echo; echo '[2]'; printf 'x '\n  [0-9]+ (re)\n  old\n\n  $ false\n"
        wanted = "Prose.\n\n  $ echo 12; echo; echo '[2]'; printf 'x '\n  [0-9]+ (re)\n\n  \\x5b2] (esc)\n" \
                 "  x\\x20 (esc) (no-eol)\n\n  $ false\n  [1]\n"
        self.assertEqual(run(text, accept=True), ("pass", "", wanted))
        self.assertEqual(run(wanted)[:2], ("pass", ""))

    def test_the_developers_own_environment_stays_out(self):
        os.environ["NO_COLOR"] = "1"
        self.addCleanup(os.environ.pop, "NO_COLOR")
        text = "  $ echo ${NO_COLOR-unset} $LC_ALL $PORT; cd; pwd; echo $TMPDIR $HOME\n" \
               "  unset C $PORT\n  $TMP\n  $TMP $TMP\n"
        self.assertEqual(run(text)[:2], ("pass", ""))

    def test_deadline_ctrl_c_and_terminal(self):
        text = "  $ within 0-9 true\n\n  $ within 5-9 true\n  took 0* s (*), not 5-9 (glob)\n  [99]\n\n" \
               "  $ interrupt 0.1 sleep 600\n  [130]\n\n" \
               "  $ terminal 50 sh -c 'stty size; test -t 1'\n  24 50\n"
        self.assertEqual(run(text)[:2], ("pass", ""))


@unittest.skipUnless(processes.nameserver.binary(), "omniORBpy is not installed")
class Peers(unittest.TestCase):
    def test_worlds_and_servers(self):
        outcome, explanation, _ = run(PEERS, pure=False)
        self.assertEqual((outcome, explanation), ("pass", ""))

    def test_a_world_that_does_not_start_fails(self):
        outcome, explanation, _ = run("world: nonsense\n\n  $ true\n", pure=False)
        self.assertEqual(outcome, "fail")
        self.assertIn("nonsense is not ready", explanation)


PEERS = """world: two
server: another
world: linked --nameserver localhost:$PORT2
faulty: silent half-header

Each server has a port, each world a control socket:

  $ echo $PORT $PORT2 $MOCK_CONTROL $MOCK_CONTROL2 $SILENT $HALF_HEADER
  $PORT $PORT2 $SESSION/two.control $SESSION/linked.control $SILENT $HALF_HEADER
  $ ctl components; calls; ctl @linked components
  ConsoleIn0
  ConsoleOut0
  ConsoleIn0
  ConsoleOut0

Worlds come and go:

  $ mock two --context b/%n.rtc && ctl @two2 pid | sed 's/[0-9]*/a number/'
  a number
  $ hang two two2; wake two; end-mock two; kill-mock two2; kill-mock three
  kill-mock: no world named three
  [99]

So do name servers:

  $ hang names names2; kill-mock names names2
"""


class Leaving(unittest.TestCase):
    def test_nothing_outlives_a_session(self):
        marker = "%d.25" % (os.getpid() + 100000)
        self.assertEqual(run("  $ sleep %s &\n" % marker)[0], "pass")
        worlds.eventually(lambda: not survivors(marker), "all have ended")

    def test_nothing_outlives_a_killed_runner(self):
        marker = "%d.75" % (os.getpid() + 100000)
        program = "import test_sessions; test_sessions.run('  $ sleep %s\\n')" % marker
        runner = subprocess.Popen(
            [sys.executable, "-c", program],
            cwd=os.path.dirname(os.path.abspath(__file__)),
            env=dict(os.environ, PYTHONPATH=transcripts.jobs.HERE),
        )
        self.addCleanup(runner.wait)
        worlds.eventually(lambda: survivors(marker), "the session has begun")
        runner.send_signal(signal.SIGKILL)
        worlds.eventually(lambda: not survivors(marker), "all have ended")


def survivors(marker):
    """Processes whose command line holds the marker."""
    found = []
    for number in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open("/proc/%s/cmdline" % number, "rb") as file:
                words = file.read().split(b"\0")
        except OSError:
            continue
        if marker.encode() in words:
            found.append(number)
    return found


if __name__ == "__main__":
    unittest.main()
