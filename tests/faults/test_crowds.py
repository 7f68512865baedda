"""Many at once: commands side by side, components by the thousand, name servers by the dozen, half of them
dead.

If one of these fails, what a command prints depends on who else looks, or a big robot is too big.
"""
import re
import unittest

import invocations
import running

ONCE = "what is asked of whom does not depend on the Python"
BOTH = "each ORB has crowds of its own"
ALONE = "it measures times"

try:
    import omniORB  # noqa: F401: the commands need it
except ImportError:
    raise unittest.SkipTest("needs omniORBpy")

CROWD = 8
ROUNDS = 100 if running.THOROUGH else 1
COMPONENTS = 1000
SERVERS = 20
LONG = 20.0             # seconds that anything may take with a thousand components
SLOW = re.compile(rb"(?m)^warn  \S+: slow .*\n")  # a finding of rtdoctor on a busy machine


def setUpModule():
    global around
    around = running.Surroundings()


def tearDownModule():
    around.close()


class SideBySide(unittest.TestCase):
    def test_all_see_the_same(self):
        """Eight of each command that only reads, all on the same world, in which nothing changes."""
        server = around.name_server("crowd")
        around.world(server, "linked")
        around.world(server, "config")
        around.world(server, "manager", "Motor")
        around.world(server, "fsm")
        text, log = around.files(server)
        home = server + "/test.host_cxt"
        meant = {
            "SERVER": home,
            "A": home + "/ConsoleIn0.rtc",
            "B": home + "/ConsoleOut0.rtc",
            "MGR": home + "/manager.mgr",
            "OUT": "out",
            "LOG": log,
        }
        meant["FILE"] = around.profile(text, "crowd.yaml", server, meant["A"], meant["B"])
        lines = [
            "%s %s" % (command, line)
            for command, lines in sorted(invocations.stated("looking").items())
            for line in lines
        ]
        lines += ["rtfsm %s/Microwave0.rtc getstructure" % home, "rtconf -l %s/ConfigSample0.rtc" % home]

        def run(line):
            ran = running.run(invocations.words(line, meant), around.top, RTCTREE_NAMESERVERS=server[1:])
            return ran.status, SLOW.sub(b"", ran.out), ran.err
        runs = 0
        for _ in range(ROUNDS):
            answers = running.together(run, [line for line in lines for _ in range(CROWD)], CROWD)
            runs += len(answers)
            for number, line in enumerate(lines):
                with self.subTest(line):
                    same = answers[number * CROWD:(number + 1) * CROWD]
                    self.assertEqual(len(set(same)), 1, sorted(set(same)))
                    self.assertNotIn(same[0][0], (2, 4, 5, 70), same[0])
        print(
            "figures: %d runs, %d of each of %d commands at a time, all outputs alike"
            % (runs, CROWD, len(lines))
        )


class ManyComponents(unittest.TestCase):
    def test_a_thousand_on_one_server(self):
        server = around.name_server("big")
        around.world(server, "many", str(COMPONENTS))
        figures = []
        for line, count in (
            ("rtls SERVER", COMPONENTS),
            ("rtls -l SERVER", COMPONENTS),
            ("rtls --json -lR SERVER", COMPONENTS + 1),
            ("rtfind --state inactive SERVER", COMPONENTS),
            ("rtcat SERVER/Mock999.rtc", 1),
            ("rtcryo -y --all SERVER", COMPONENTS),
        ):
            words = line.replace("SERVER", server + "/test.host_cxt").split()
            ran = running.run(words, around.top, RTCTREE_NAMESERVERS=server[1:])
            with self.subTest(line):
                self.assertEqual((ran.status, ran.err), (0, b""), ran)
                self.assertGreaterEqual(ran.out.count(b"Mock"), count)
                self.assertLess(ran.seconds, LONG)
                self.assertLess(ran.resident, running.RESIDENT)
            figures.append("%s %.1f s %d MB" % (" ".join(words[:-1]), ran.seconds, ran.resident // 1024))
        print("figures: %d components: %s" % (COMPONENTS, ", ".join(figures)))


class ManyServers(unittest.TestCase):
    def test_half_of_them_dead(self):
        """Living ones are shown in full, each dead one costs a line, all of them together one timeout."""
        alive = [around.name_server("server%d" % number) for number in range(SERVERS // 2)]
        for server in alive[:3]:
            around.world(server, "two")
        ports = around.faulty(
            *[
                "%s%d=%s" % (mode, number, mode)
                for mode in ("refused", "silent", "dead-host", "drip", "garbage")
                for number in range(SERVERS // 10)
            ]
        )
        dead = ["/127.0.0.1:%d" % port for port in ports.values()]
        servers = ";".join(server[1:] for pair in zip(alive, dead) for server in pair)
        start_up = running.run(["rtls", "-R", alive[-1]], around.top).seconds
        for words, patience in (
            (["rtls", "-R", "/"], 1),
            (["rtfind", "/", "-t", "c"], 1),
            (["rtdel", "-z", "--dry-run"], 1),
            (["rtdoctor", "-q"], 3),
            (["rtls", "-l"] + alive + dead, 1),
        ):
            ran = running.run(
                words, around.top, RTCTREE_NAMESERVERS=servers, RTSHELL_TIMEOUT=str(running.TIMEOUT)
            )
            with self.subTest(" ".join(words[:2])):
                self.assertNotIn(ran.status, (0, 2, 70), ran)
                said = ran.out + ran.err
                if words[0] in ("rtls", "rtfind"):
                    self.assertEqual(said.count(b"ConsoleIn0.rtc"), 3 if words[1] != "-l" else 0)
                for server in dead:
                    self.assertIn(server.encode(), said)
                self.assertLess(ran.seconds, patience * running.TIMEOUT + running.SLACK + start_up, ran)
                self.assertLess(ran.resident, running.RESIDENT)
        print(
            "figures: %d name servers, %d of them bad: rtls -R / in %.2f s"
            % (SERVERS, len(dead), ran.seconds)
        )


if __name__ == "__main__":
    unittest.main()
