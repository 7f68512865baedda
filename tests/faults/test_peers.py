"""Every command against every kind of broken peer, as name server and as component: one calm line, in time,
and no more memory than it needs. If one of these fails, a broken robot takes the tool that is to look after
it along.
"""
import os
import re
import unittest

import invocations
import running
from mock_components import faulty, malice

ONCE = "how long a peer is waited for does not depend on the Python"
BOTH = "each ORB reads answers in its own way"
ALONE = "it measures times"

try:
    import omniORB  # noqa: F401: the commands need it
except ImportError:
    raise unittest.SkipTest("needs omniORBpy")

MODES = sorted(set(faulty.MODES) | set(faulty.UNREACHABLE))
# these answer as a name server does, if strangely
NAMING = {"hostile", "many", "loop", "bottomless", "branching"}
SANE = NAMING | {"elsewhere-refused", "elsewhere-silent"} | set(malice.CHANGES)
# kB at most, where these are more than running.RESIDENT: omniORB takes what the builtin ORB refuses.
HEAVY = {"megabytes": 192 * 1024} if os.environ.get("RTSHELL_ORB") == "omniorb" else {}
ENDLESS = {"many", "endless", "endless-nothing", "endless-long", "branching"}
MOST_SAID = 2 << 20     # octets on stdout and stderr
KEPT = 1 << 20          # octets of each
# times MOST_SAID: 20,000 names are 20,000 lines of JSON
LENGTHY = {"megabytes": 64, "many": 2, "endless-long": 20}
SHORT = 150             # of 4,500 cases; these take 30 s of processor
LISTS = ["many-contexts", "many-organizations", "many-members"]
# these answer as many questions as are asked, or at great length
TALKATIVE = {"many-ports", "many-ends", "many-connectors", *LISTS}
TALK_LIMIT = 10.0       # seconds for them
LIST_TIMEOUT = 3.0      # of commands: such a list is made, and sent, by a machine that may be busy
LIST_LIMIT = 60.0       # seconds for 20,000 names, each of which is asked for and then asked

# The doctor promises three times the timeout; what asks one after the other may wait as often, such as
# rtcheck --extra, which asks the components of the file, then all bad peers at once, for their ports and then
# for their profiles. rttrace asks the doctor about the culprit.
PATIENCE = {"rtdoctor": 3, "rttrace": 4, "rtsh": 2}

BAD = {4}               # the peer is dead, silent or garbled
# What the status may be besides: the answer of those that look is that the peer is bad, what asks only the
# name server does not notice a bad component, and so on.
ALSO = {role: invocations.statuses(role) for role in ("server", "component")}
DELETING = invocations.stated("invocation")["rtdel"]


class Case:
    """One command line and one peer, as name server or as component."""

    def __init__(self, number, command, line, mode, role, timeout=running.TIMEOUT):
        self.timeout = timeout
        self.number = number
        self.command = command
        self.line = line
        self.mode = mode
        self.role = role

    def __str__(self):
        return "%s %s, %s as %s" % (self.command, self.line, self.mode, self.role)

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

    def limit(self):
        """Seconds that it may take: what the command line asks for, and the timeout."""
        if self.mode in ENDLESS and self.role == "server" and re.search("SERVER|--extra", self.line):
            return LIST_LIMIT
        if self.mode in TALKATIVE:
            return TALK_LIMIT
        return self.usual_limit()

    def usual_limit(self):
        """`limit` for peers that do not answer as many questions as are asked."""
        seconds = re.findall(r"(?:-t|--wait|--measure|--limit)[ =]([\d.]+)", self.line)
        asked = sum(map(float, seconds))
        patience = 3 if "--extra" in self.line else PATIENCE.get(self.command, 1)
        # twice: what it has read it also runs, and a slow machine takes as much longer for that (how long a
        # command waits is proven to the tenth of a second in the bottle)
        return asked + self.timeout * patience + running.SLACK + 2 * start_up

    def problems(self):
        """What is wrong with what it did, but how long it took."""
        ran = self.ran
        lines = ran.err.decode("utf-8", "replace").splitlines()
        is_told = b"Traceback" in ran.err or b"Traceback" in ran.out or b"internal error" in ran.err
        if is_told or ran.status in (70, 141) or ran.status > 128:
            yield "a bug"
        if ran.resident > HEAVY.get(self.mode, running.RESIDENT):
            yield "%d kB" % ran.resident
        if ran.said > MOST_SAID * LENGTHY.get(self.mode, 1):
            yield "%d octets said" % ran.said
        if ran.status not in self.allowed():
            yield "status %d, not of %s" % (ran.status, sorted(self.allowed()))
        told = [line for line in lines if re.match(r"rt\w+: (/|\d+ of \d+ (did not|not asked))", line)]
        if len(set(told)) < len(told):
            yield "told twice"
        about = [line for line in told if self.peer in line]
        if self.mode not in SANE and len(about) > self.most_lines():
            yield "%d lines" % len(about)
        if ran.status not in (0, 1) and not told:
            yield "no line"

    def allowed(self):
        """What the exit status may be."""
        if self.mode in SANE:  # these answer, and what they answer may be taken for something
            return {0, 1, 3, 4, 5, 6}
        return BAD | ALSO[self.role].get(self.command, set())

    def most_lines(self):
        """One line, or one of each command of rtsh, of the component and of its connection, of each way to
        ask a name server.
        """
        return 2 if self.command in ("rtsh", "rtteardown") or "--extra" in self.line else 1


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
    found = [
        (command, line)
        for command, lines in sorted(invocations.stated("invocation").items())
        for line in lines
    ]
    return [
        Case(number, command, line, mode, role)
        for number, (command, line, mode, role) in enumerate(
            (command, line, mode, role)
            for role in ("server", "component")
            for command, line in found
            for mode in MODES
        )
    ]


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
        done = run_all(running.sample(cases(), SHORT))
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
                self.assertLessEqual(case.ran.seconds, case.limit(), case.ran)

    def test_long_lists(self):
        """What one component can list, such as 5,000 contexts, is not asked one by one."""
        lines = ["rtwatch -t 1 A", "rtcat -l A", "rtls -l A", "rtec A", "rtact A", "rtdoctor A"]
        chosen = [
            Case(number, line.split()[0], line.partition(" ")[2], mode, "component", LIST_TIMEOUT)
            for number, (line, mode) in enumerate((line, mode) for line in lines for mode in LISTS)
        ]
        for case in run_all(chosen, 2):
            with self.subTest(str(case)):
                self.assertEqual(case.found, [], case.ran)
                # a thousand of them are looked up and shown meanwhile, which takes a processor as long again
                self.assertLessEqual(case.ran.seconds, case.usual_limit() + 2 * start_up, case.ran)
                if case.command == "rtcat":
                    self.assertIn(b"are left out", case.ran.err)


if __name__ == "__main__":
    unittest.main()
