"""Where a name server is, for people who do not know: `rtls` says so where none is named."""
import os
import socket
import unittest
from unittest import mock

import worlds
from rtshell_lite.corba.session import Session
from rtshell_lite.net import loop
from rtshell_lite.robot import usual


class Advice(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        worlds.start_name_server()
        cls.port = worlds.Server.port
        cls.world = worlds.World("manager")
        cls.manager = int(cls.world.ready.split()[-1])
        cls.reserved = socket.socket()  # so that nobody comes to listen there
        cls.reserved.bind(("127.0.0.1", 0))
        cls.nobody = cls.reserved.getsockname()[1]

    @classmethod
    def tearDownClass(cls):
        cls.reserved.close()
        cls.world.close()
        worlds.Server.stop()

    def advice(self, ports, managers=(), **environment):
        environment = dict({"RTCTREE_NAMESERVERS": ""}, **environment)
        with mock.patch.dict(os.environ, environment), mock.patch.multiple(
            usual, PORTS=ports, MANAGERS=managers
        ):
            return loop.run(usual.advice(), session=Session(worlds.LIMIT))

    def test_the_usual_one_is_there(self):
        self.assertIsNone(self.advice((self.port, self.nobody)))

    def test_another_one_is_named(self):
        self.assertIsNone(self.advice((self.nobody,), RTCTREE_NAMESERVERS="robot1"))

    def test_it_is_at_another_port(self):
        self.assertEqual(
            self.advice((self.nobody, self.port)),
            "no name server answers at localhost:%d; "
            "found on this host: "
            "localhost:%d; try: export RTCTREE_NAMESERVERS=localhost:%d"
            % (self.nobody, self.port, self.port),
        )

    def test_there_is_a_manager_only(self):
        address = "corbaloc:iiop:localhost:%d/manager" % self.manager
        self.assertEqual(
            self.advice((self.nobody, self.manager), (self.manager,)),
            "no name server answers at localhost:%d; found on "
            "this host: %s; try: export RTCTREE_NAMESERVERS=%s" % (self.nobody, address, address),
        )

    def test_there_is_none(self):
        self.assertEqual(self.advice((self.nobody, self.nobody)), "no name server answers at "
                                                                  "localhost:%d, nor at TCP ports %d of "
                                                                  "this "
                         "host; on another host: rtls HOST" % (self.nobody, self.nobody))


if __name__ == "__main__":
    unittest.main()
