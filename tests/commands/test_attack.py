"""A command that receives values, while others keep its port busy: all values come, and what was turned away
is reported.
"""
import glob
import os
import re
import socket
import subprocess
import threading
import time
import unittest

import giop_client
import running
import worlds

try:
    import omniORB  # noqa: F401: the mocks need it
except ImportError:
    raise unittest.SkipTest("needs omniORBpy")

ONCE = "it is about the kernel's connections"
CROWD, VALUES = 600, 6
THREADS = 6
TARGET = "/test.host_cxt/ConsoleIn0.rtc"
QUESTION = giop_client.request(b"x", "_non_existent")


def listening_port(pid):
    """The port at which a process listens, or None."""
    found = [
        re.match(r"socket:\[(\d+)\]", os.readlink(path))
        for path in glob.glob("/proc/%d/fd/*" % pid)
        if os.path.islink(path)
    ]
    inodes = {match.group(1) for match in found if match}
    for table in ("tcp", "tcp6"):
        with open("/proc/net/" + table) as file:
            for fields in [line.split() for line in file][1:]:
                if fields[3] == "0A" and fields[9] in inodes:
                    return int(fields[1].rpartition(":")[2], 16)
    return None


@unittest.skipUnless(os.path.exists("/proc/net/tcp"), "needs Linux")
class Attack(unittest.TestCase):
    def setUp(self):
        self.around = running.Surroundings()
        self.addCleanup(self.around.close)
        self.server = self.around.name_server()
        self.was_refused = threading.Event()

    def start(self, *words):
        """Start a command, whose ORB is to be attacked."""
        self.command = running.start(list(words), self.around.top, {"RTSHELL_ORB": "builtin"},
                                     stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        worlds.eventually(lambda: listening_port(self.command.pid), "listening")
        self.at = listening_port(self.command.pid)

    def attack(self, talk, crowd):
        """Have `crowd` connections talk, until the end of the test. None of them reads an answer."""
        ended = threading.Event()
        self.addCleanup(ended.set)

        def keep_on():
            clients = []
            while not ended.is_set():
                try:
                    if len(clients) < crowd // THREADS:
                        clients.append(socket.create_connection(("127.0.0.1", self.at), 1))
                    for client in clients:
                        talk(client)
                except OSError as e:
                    if isinstance(e, ConnectionError):
                        self.was_refused.set()
                    for client in clients[:1]:
                        client.close()
                    del clients[:1]
            for client in clients:
                client.close()
        for _ in range(THREADS):
            threading.Thread(target=keep_on, daemon=True).start()
        time.sleep(1)

    # ---- rtprint ----

    def printing(self):
        """Have rtprint wait for VALUES, the first of which comes before any attack."""
        self.world = self.around.world(self.server, "two")
        self.start("rtprint", "-n", str(VALUES), "-t", "100", self.server + TARGET + ":out")
        worlds.eventually(lambda: self.around.ctl(self.world, "connectors", "ConsoleIn0:out"), "connected")
        self.around.ctl(self.world, "write", "ConsoleIn0:out", "0")

    def values_come(self):
        """Send the other values; what rtprint printed, and its errors."""
        for value in range(1, VALUES):
            self.around.ctl(self.world, "write", "ConsoleIn0:out", str(value))
            time.sleep(0.2)
        out, err = self.command.communicate(timeout=worlds.LIMIT)
        printed = [line.split()[-1] for line in out.decode().splitlines()]
        self.assertEqual(printed, [str(value) for value in range(VALUES)], err)
        return err.decode()

    def test_many_that_ask(self):
        self.printing()
        self.attack(lambda client: client.sendall(QUESTION), CROWD)
        self.assertTrue(self.was_refused.wait(worlds.LIMIT))
        self.assertIn("were turned away", self.values_come())
        self.assertEqual(self.command.returncode, 5)

    def test_some_that_ask_and_never_read(self):
        """Their answers have nowhere to go: that is their loss."""
        def ask(client):
            client.setblocking(False)
            try:
                client.send(QUESTION * 100)
            except BlockingIOError:
                time.sleep(0.001)
        self.printing()
        self.attack(ask, 50)
        self.values_come()
        self.assertIn(self.command.returncode, (0, 5))

    # ---- rtwatch ----

    def test_heartbeats_among_many_that_ask(self):
        """They come once a second; after 3 seconds without one rtwatch would report NO_HEARTBEAT."""
        self.around.world(self.server, "observed")
        self.start("rtwatch", "-t", "8", "-f", "HEARTBEAT", "-f", "LIFE_EVENT", self.server + TARGET)
        self.assertIn(b"HEARTBEAT", self.command.stdout.readline())
        self.attack(lambda client: client.sendall(QUESTION), CROWD)
        out, err = self.command.communicate(timeout=worlds.LIMIT)
        self.assertNotIn(b"NO_HEARTBEAT", out)
        self.assertGreaterEqual(out.count(b" HEARTBEAT"), 4, err)


if __name__ == "__main__":
    unittest.main()
