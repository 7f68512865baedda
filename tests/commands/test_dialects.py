"""Robots whose ORB speaks an older GIOP, the other byte order, or in fragments: commands print what they
print of others.
"""
import os
import re
import unittest
from unittest import mock

import dialects
import relay
import running

try:
    import omniORB  # noqa: F401: the mocks need it
except ImportError:
    raise unittest.SkipTest("needs omniORBpy")

BOTH = "each ORB reads answers in its own way"
WORLDS = ["linked"], ["config"], ["manager"]
HERE = "test.host_cxt/"
COMMANDS = [
    ["rtls", "-lR"],
    ["rtls", "-l", HERE],
    ["rtcat", "-ll", HERE + "ConsoleIn0.rtc"],
    ["rtcat", HERE + "manager.mgr"],
    ["rtcat", "--json", HERE + "ConsoleOut0.rtc:in"],
    ["rtcat", HERE + "nobody.rtc"],
    ["rtfind", ".", "-t", "c"],
    ["rtconf", "-l", HERE + "ConfigSample0.rtc", "list"],
    ["rtconf", HERE + "ConfigSample0.rtc", "set", "int_param0", "7"],
    ["rtec", HERE + "ConsoleIn0.rtc"],
    ["rtact", HERE + "ConsoleIn0.rtc"],
    ["rtreset", HERE + "ConsoleIn0.rtc"],
    ["rtdis", "--dry-run", HERE + "ConsoleIn0.rtc"],
    ["rtcryo", "."],
    ["rtdoc", HERE + "ConfigSample0.rtc"],
    ["rtmgr", "--loaded", HERE + "manager.mgr"],
    ["rtdel", "--dry-run", "-z"],
]
FAIL = ["rtcat", "rtreset"]  # the component does not exist; it is not in Error
VARIES = re.compile(rb"127\.0\.0\.1:\d+|Date=\"[^\"]*\"|IOR:[0-9a-f]*")  # ports, when rtcryo wrote a file
IS_BUILTIN = os.environ.get("RTSHELL_ORB") != "omniorb"
# omniORB takes multiples of 8
PIECES = (40, 104, 1000) + ((4, 5, 7, 8, 12, 16, 20, 24, 25, 39) if IS_BUILTIN else ())
# GIOP 1.x, byte order, octets of a fragment; omniORB takes no references for GIOP 1.0 that have components
DIALECTS = [
    (2, ">", None),
    (1, "<", None),
    (1, ">", None),
    *((0, order, None) for order in "<>" if IS_BUILTIN),
    *((minor, order, piece) for minor in (1, 2) for order in "<>" for piece in PIECES),
]


class Dialects(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.around = running.Surroundings()
        server = cls.around.name_server()
        for words in WORLDS:
            cls.around.world(server, *words)
        cls.port = int(server.rpartition(":")[2])
        for words in COMMANDS:  # those that change something have done so
            cls.run_at(cls.port, words)
        cls.expected = [cls.run_at(cls.port, words) for words in COMMANDS]

    @classmethod
    def tearDownClass(cls):
        cls.around.close()

    @classmethod
    def run_at(cls, port, words):
        """(status, stdout, stderr) of a command that is given a name server, but for what differs each
        time.
        """
        place = "127.0.0.1:%d" % port
        ran = running.run(words, cls.around.top, RTCTREE_NAMESERVERS=place, RTCSH_CWD="/" + place)
        return ran.status, VARIES.sub(b"", ran.out), VARIES.sub(b"", ran.err)

    def test_all_print_the_same(self):
        """Old name servers that refuse a later GIOP are asked again in theirs, but not by omniORB."""
        self.assertEqual(
            [words[0] for words, (status, _, _) in zip(COMMANDS, self.expected) if status],
            FAIL,
            self.expected,
        )
        robots = {each: dialects.Dialect(*each, strict=IS_BUILTIN) for each in DIALECTS}
        cases = [(each, number) for each in DIALECTS for number in range(len(COMMANDS))]
        for (each, number) in running.sample(cases, 60):
            with self.subTest(dialect=each, words=COMMANDS[number]):
                self.assertEqual(
                    self.run_at(robots[each].front(self.port), COMMANDS[number]), self.expected[number]
                )
        for (_, order, _), robot in robots.items():
            # of a manager: one of its properties is a boolean
            self.assertLessEqual(robot.untranslated, {"get_profile"})
            self.assertEqual(bool(robot.translated), order == ">" and bool(robot.fronts))

    def test_connections_of_one_reply(self):
        """A peer that closes the connection after each reply."""
        robot = OneReply()
        for number, words in enumerate(COMMANDS):
            with self.subTest(words=words):
                self.assertEqual(self.run_at(robot.front(self.port), words), self.expected[number])


class OneReply(relay.Relay):
    closes = True

    def passed(self, request, reply):
        return reply


class OldServers(unittest.TestCase):
    """omniNames that speaks GIOP 1.0 or 1.1 only: the one says so, the other just closes the connection."""

    def test_all_commands(self):
        for version in ("1.0", "1.1"):
            around = running.Surroundings()
            self.addCleanup(around.close)
            server = around.name_server(options=["-ORBmaxGIOPVersion", version])
            ran = running.run(["rtls", server], around.top)
            if not IS_BUILTIN:
                self.assertEqual((ran.status, ran.err.decode()),
                                 (4, f"rtls: {server}: speaks GIOP {version} only, which omniORB does "
                                 "not try; set RTSHELL_ORB=builtin\n"))
                continue
            self.assertEqual((ran.status, ran.out, ran.err), (0, b"", b""))
            # or it could not reach its name server
            with mock.patch.dict(os.environ, ORBmaxGIOPVersion=version):
                around.world(server, "linked")
            for words in (
                ["rtls", "-lR", server],
                ["rtcat", "-l", server + "/test.host_cxt/ConsoleIn0.rtc"],
                ["rtact", server + "/test.host_cxt/ConsoleIn0.rtc"],
                ["rtdel", "-f", server + "/test.host_cxt/ConsoleIn0.rtc"],
            ):
                with self.subTest(version=version, words=words):
                    ran = running.run(words, around.top)
                    self.assertEqual((ran.status, ran.err), (0, b""), ran)


if __name__ == "__main__":
    unittest.main()
