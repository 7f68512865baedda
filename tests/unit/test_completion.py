"""What TAB offers before anything is asked of a robot; shells on terminals are tried in tests/commands."""
import os
import unittest

import processes
import worlds
from rtshell_lite.corba.session import Session
from rtshell_lite.net import loop
from rtshell_lite.shell import completion


class Commands(unittest.TestCase):
    def offered(self, line):
        return list(loop.run(completion.answers("bash", line, line)))

    def test_names_of_commands(self):
        self.assertEqual(self.offered("rtpw"), ["rtpwd "])
        self.assertEqual(self.offered("nothing"), [])

    def test_nothing_is_offered_on_an_empty_line(self):
        for line in ("", "  ", "'", "''"):
            self.assertEqual(self.offered(line), [], line)

    def test_options(self):
        self.assertEqual(self.offered("rtpwd --vers"), ["rtpwd --version "])


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
        for words, wanted in ((":sv", [self.path + ":svc"]), (":svc mo", ["model", "move_to"]), (":svc spe", ["speed", "speed="]),
                              (":svc turn [1] ", ["back=", "false", "true"]), (":svc turn back=f", ["back=false"]),
                              (":svc turn back=true j", ["joints="]), (":svc none ", []), (" get_sdo_i", ["get_sdo_id"])):
            with self.subTest(words):
                self.assertEqual([answer.strip() for answer in self.offered(words)], wanted)
        _, calls = self.world.ctl("calls", "Robot0")
        self.assertEqual({line.split()[1] for line in calls.splitlines()}, {"connect", "disconnect", "get_ports", "get_port_profile"})


if __name__ == "__main__":
    unittest.main()
