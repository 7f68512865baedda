"""What TAB offers of a robot; shells on terminals are tried in tests/commands."""
import os
import unittest
from unittest import mock

import processes
import worlds
from rtshell_lite.corba.session import Session
from rtshell_lite.net import loop
from rtshell_lite.shell import completion


class Patterns(unittest.TestCase):
    """Paths with * and **, and names alone with RTSHELL_FIND."""

    @classmethod
    def setUpClass(cls):
        worlds.start_name_server()
        cls.worlds = [worlds.World("these", "Robot", "Source"),
                      worlds.World("these", "Robot", "ConsoleIn", "--context", "other.host_cxt/%n.rtc"),
                      worlds.World("hung", "1", "--context", "other.host_cxt/%n.rtc")]
        cls.server = "127.0.0.1:%d" % worlds.Server.port

    @classmethod
    def tearDownClass(cls):
        for world in cls.worlds:
            world.close()
        worlds.Server.stop()

    def offered(self, line, **environment):
        environment = dict({"RTCTREE_NAMESERVERS": self.server, "RTCSH_CWD": "/"}, **environment)
        with mock.patch.dict(os.environ, environment), mock.patch.object(completion, "SECONDS", 30):
            return [
                answer.strip()
                for answer in loop.run(completion.answers("bash", line, line.split()[-1]), session=Session(3))
            ]

    def test_directories_are_any(self):
        for words, wanted in (
            ("rtcat /**/So", ["/**/Source0.rtc"]),
            ("rtcat /**/Robot", ["/**/Robot0.rtc"]),
            ("rtcat **/So", ["**/Source0.rtc"]),
            ("rtcat '/**/So", ["'/**/Source0.rtc"]),
            ("rtcat /*/", ["/*/other.host_cxt/", "/*/test.host_cxt/"]),
            ("rtcat /%s/**/Con" % self.server, ["/%s/**/ConsoleIn0.rtc" % self.server]),
            ("rtprint /**/Source0.rtc:num", ["/**/Source0.rtc:number"]),
            ("rtls /*x/So", []),
            ("rtcheck *", []),
        ):
            with self.subTest(words):
                self.assertEqual(self.offered(words), wanted)

    def test_names_alone(self):
        here = {"RTCSH_CWD": "/%s/test.host_cxt" % self.server}
        for words, environment, wanted in (
            ("rtcat Con", {"RTSHELL_FIND": "1"}, ["ConsoleIn0.rtc"]),
            ("rtcat Con", {"RTCSH_CWD": ("/**")}, ["ConsoleIn0.rtc"]),
            ("rtcat Con", {}, []),
            ("rtcat Con", here, []),
            ("rtcat Con", dict(here, RTSHELL_FIND="1"), ["ConsoleIn0.rtc"]),
            ("rtprint Source0.rtc:num", {"RTSHELL_FIND": ("1")}, ["Source0.rtc:number"]),
        ):
            with self.subTest(words, **environment):
                self.assertEqual(self.offered(words, **environment), wanted)


class Operations(unittest.TestCase):
    """What rtcall calls; completion never does."""

    @classmethod
    def setUpClass(cls):
        worlds.start_name_server()
        cls.world = worlds.World("these", "Robot")
        cls.path = "/127.0.0.1:%d/test.host_cxt/Robot0.rtc" % worlds.Server.port

    @classmethod
    def tearDownClass(cls):
        cls.world.close()
        worlds.Server.stop()

    def offered(self, words):
        idl = os.path.join(processes.ROOT, "mock_components", "robot.idl")
        line = f"rtcall --idl {idl} {self.path}{words}"
        answers = list(loop.run(completion.answers("fish", line, line), session=Session(3)))
        return [answer.partition("\t")[0].rpartition(" ")[2] for answer in answers]

    def test_operations_and_arguments(self):
        for words, wanted in (
            (":sv", [self.path + ":svc"]),
            (":svc mo", ["model", "move_to"]),
            (":svc spe", ["speed", "speed="]),
            (":svc turn [1] ", ["back=", "false", "true"]),
            (":svc turn back=f", ["back=false"]),
            (":svc turn back=true j", ["joints="]),
            (":svc none ", []),
            (" get_sdo_i", ["get_sdo_id"]),
        ):
            with self.subTest(words):
                self.assertEqual([answer.strip() for answer in self.offered(words)], wanted)
        calls = self.world.ctl("calls", "Robot0")
        self.assertEqual(
            {line.split()[1] for line in calls.splitlines()},
            {"connect", "disconnect", "get_ports", "get_port_profile"},
        )


if __name__ == "__main__":
    unittest.main()
