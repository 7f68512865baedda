"""Commands against every kind of broken peer, with real processes: one calm line, in time, and no more memory
than it needs; every command against each is tried in tests/sim/test_peers.py. If one of these fails, a broken
robot takes the tool that is to look after it along.
"""
import os
import unittest

import invocations
import peer_cases
import running
from mock_components import faulty

ONCE = "how long a peer is waited for does not depend on the Python"
BOTH = "each ORB reads answers in its own way"
ALONE = "it measures times"

try:
    import omniORB  # noqa: F401: the commands need it
except ImportError:
    raise unittest.SkipTest("needs omniORBpy")

MODES = sorted(set(faulty.MODES) | set(faulty.UNREACHABLE))
# kB at most, where these are more than running.RESIDENT: omniORB takes what the builtin ORB refuses.
HEAVY = {"megabytes": 192 * 1024} if os.environ.get("RTSHELL_ORB") == "omniorb" else {}
KEPT = 1 << 20          # octets of each of stdout and stderr
LIST_TIMEOUT = 3.0      # of commands: such a list is made, and sent, by a machine that may be busy
DELETING = invocations.stated("invocation")["rtdel"]


class Case(peer_cases.Case):
    """One with real processes."""

    number = 0  # of its files

    def meant(self):
        """The meaning of the words of the tables."""
        top = "/127.0.0.1:%d" % ports[self.mode]
        if self.role == "server":
            names = {"SERVER": top, "A": top + "/a.rtc", "B": top + "/b.rtc", "MGR": top + "/m.mgr"}
        else:
            name = self.mode
            if self.command == "rtdel":  # after which it is gone
                name += "-%d" % DELETING.index(self.line)
            top = server + "/%s.host_cxt" % name
            a = "%s/%s.rtc" % (top, self.mode)
            names = {"SERVER": top, "A": a, "B": server + "/test.host_cxt/ConsoleOut0.rtc", "MGR": a}
        return dict(names, OUT="out", LOG=log,
                    FILE=around.profile(text, "%d.yaml" % self.number, server, names["A"], names["B"]))

    def run(self):
        meant = self.meant()
        self.peer = meant["SERVER" if self.role == "server" else "A"]
        self.ran = running.run(
            [self.command] + invocations.words(self.line, meant),
            around.directory("run%d" % self.number),
            most=KEPT,
            RTCTREE_NAMESERVERS=self.peer[1:].partition("/")[0],
            RTSHELL_TIMEOUT=str(self.timeout),
        )
        self.found = list(self.problems())
        self.ran = self.ran._replace(out=self.ran.out[-2000:], err=self.ran.err[-2000:])
        return self

    def problems(self):
        """What is wrong with what it did, but how long it took."""
        ran = self.ran
        out, err = [octets.decode("utf-8", "replace") for octets in (ran.out, ran.err)]
        yield from self.judge(ran.status, out, err, ran.said)
        if ran.resident > HEAVY.get(self.mode, running.RESIDENT):
            yield "%d kB" % ran.resident

    @staticmethod
    def computing():
        """Seconds that it may compute: what it has read it also runs, and a slow machine takes as much longer
        for that (how long a command waits is proven to the tenth of a second in the bottle).
        """
        return running.SLACK + 2 * start_up


def setUpModule():
    global around, server, text, log, ports, healthy
    around = running.Surroundings()
    server = around.name_server()
    around.world(server, "linked")
    text, log = around.files(server)
    here = server + "/test.host_cxt/"
    healthy = around.profile(text, "healthy.yaml", server, here + "ConsoleIn0.rtc", here + "ConsoleOut0.rtc")
    ports = around.faulty(*MODES)
    for mode in MODES:
        for name in [mode] + ["%s-%d" % (mode, number) for number, _ in enumerate(DELETING)]:
            faulty.bind("%s/%s.host_cxt" % (server[1:], name), {mode: ports[mode]})


def tearDownModule():
    around.close()


def cases():
    """A command line for each kind of peer, others by another seed; with --long all of them."""
    found = peer_cases.cases(Case, MODES)
    for number, case in enumerate(found):
        case.number = number
    if running.THOROUGH:
        return found
    return [case for mode in MODES for case in running.sample([c for c in found if c.mode == mode], 1)]


def control(_):
    """Seconds that a command takes in the same crowd without any fault: the one that reads most before."""
    return running.run(["rtteardown", "--dry-run", healthy], around.top).seconds


def run_all(chosen, parallel=running.PARALLEL):
    """Run Cases, and the control after every fifth of them; `start_up` is the longest that it took."""
    global start_up
    jobs = [
        job for number, case in enumerate(chosen) for job in ([case, None] if number % 5 == 0 else [case])
    ]
    done = running.together(lambda case: case.run() if case else control(case), jobs, parallel)
    start_up = max(each for each in done if isinstance(each, float))
    return [each for each in done if isinstance(each, Case)]


class Peers(unittest.TestCase):
    def test_every_command_against_every_peer(self):
        done = run_all(cases())
        ran = [case.ran for case in done]
        print(
            "figures: %d runs against %d kinds of peers; longest %.2f s with a timeout of %g s (start-up "
            "%.2f s), most memory %d kB"
            % (
                len(ran),
                len(MODES),
                max(each.seconds for each in ran),
                running.TIMEOUT,
                start_up,
                max(each.resident for each in ran),
            )
        )
        for case in done:
            with self.subTest(str(case)):
                self.assertEqual(case.found, [], case.ran)
                self.assertLessEqual(case.ran.seconds, case.limit() + case.computing(), case.ran)

    @unittest.skipIf(os.environ.get("RTSHELL_ORB") != "omniorb", "our own ORB is tried in the bottle")
    def test_long_lists(self):
        """What one component can list, such as 5,000 contexts, is not asked one by one."""
        chosen = peer_cases.long_lists(Case, timeout=LIST_TIMEOUT)
        for number, case in enumerate(chosen):
            case.number = number
        for case in run_all(chosen, 2):
            with self.subTest(str(case)):
                self.assertEqual(case.found, [], case.ran)
                # a thousand of them are looked up and shown meanwhile, which takes a processor as long again
                limit = case.usual_limit() + case.computing() + 2 * start_up
                self.assertLessEqual(case.ran.seconds, limit, case.ran)
                if case.command == "rtcat":
                    self.assertIn(b"are left out", case.ran.err)


if __name__ == "__main__":
    unittest.main()
