"""What published addresses mean: if one of these fails, rtdoctor takes a robot out of reach for a dead one.
"""
import errno
import ipaddress
import socket
import threading
import unittest
from unittest import mock

from rtshell_lite import errors, path
from loops import asynchronous, wait_for
from rtshell_lite.corba import refusals, session
from rtshell_lite.doctor import addresses, limits, managers, networks, references, remedies, waiting
from rtshell_lite.net import hosts, loop, real
from rtshell_lite.robot import tree

ONCE = "it asks nobody"
LAN = [("eth0", ipaddress.ip_interface("10.77.0.1/24")), ("docker0", ipaddress.ip_interface("172.17.0.1/16"))]


class Published(unittest.TestCase):
    """This host is 10.77.0.1; it has a bridge of containers as many hosts have: 172.17.0.1."""

    def setUp(self):
        own = {"10.77.0.1", "172.17.0.1", "127.0.0.1"}
        for patch in (
            mock.patch.object(hosts, "interfaces", lambda: LAN),
            mock.patch.object(addresses, "is_own", own.__contains__),
            mock.patch.object(refusals, "is_own", own.__contains__),
            mock.patch.object(refusals, "_addresses", asynchronous(lambda host: [host])),
            mock.patch.object(addresses, "resolve", asynchronous(lambda host: [host])),
        ):
            patch.start()
            self.addCleanup(patch.stop)

    def misled(self, published, homes, elsewhere=""):
        with mock.patch.object(networks.orb, "addresses", lambda ref: [(published, 4000)]):
            found = wait_for(networks.misled("reference", "/robot/A0.rtc", None, homes, elsewhere))
        return found and (found.level, found.message)

    def certain(self, published, homes):
        with mock.patch.object(networks.orb, "addresses", lambda ref: [(published, 4000)]):
            return wait_for(networks.is_certain(None, homes))

    def test_nothing_against_it(self):
        for published, homes in (
            ("127.0.0.1", ["127.0.0.1"]),
            ("10.77.0.2", ["10.77.0.2"]),
            ("10.77.0.3", ["10.77.0.2"]),
            ("10.77.0.1", ["10.77.0.1"]),
            ("10.77.0.1", ["127.0.0.1"]),
        ):
            self.assertFalse(self.misled(published, homes), (published, homes))

    def test_loopback(self):
        self.assertEqual(self.misled("127.0.0.1", ["10.77.0.2"]),
                         ("fail", "publishes 127.0.0.1:4000, which means this host, not its own"))
        self.assertEqual(
            self.misled("127.0.0.1", ["10.77.0.1"]),
            ("warn", "publishes 127.0.0.1:4000: only this host can reach it"),
        )
        self.assertIn("10.77.0.9 takes part", self.misled("localhost", ["127.0.0.1"], "10.77.0.9")[1])

    def test_no_home_is_known(self):
        self.assertIsNone(self.misled("127.0.0.1", [], "10.77.0.9"))

    def test_references_to_other_hosts_are_outside(self):
        with mock.patch.object(networks.orb, "addresses", lambda ref: [(ref, 4000)]):
            asked = ["", "127.0.0.1", "10.77.0.9"], ["", "localhost", "172.17.0.1"]
            self.assertEqual([wait_for(networks.outside(refs)) for refs in asked],
                             ["10.77.0.9", ""])

    def test_another_network(self):
        self.assertEqual(self.misled("172.17.0.1", ["10.77.0.1"], "10.77.0.9")[0], "warn")
        self.assertIsNone(self.misled("172.17.0.1", ["10.77.0.1"]))  # all of the system is on this host
        self.assertEqual(self.misled("172.17.0.1", ["10.77.0.2"])[0], "fail")

    def test_an_address_of_one_link(self):
        level, message = self.misled("fe80::1", ["10.77.0.2"])
        self.assertEqual(level, "fail")
        self.assertIn("means nothing without an interface", message)
        self.assertIsNone(self.misled("fe80::1%eth0", ["10.77.0.2"]))

    def test_a_name_that_means_this_host(self):
        """Of names in /etc/hosts that mean this host here, only its own is known to mean it elsewhere."""
        with mock.patch.object(
            refusals, "_addresses", asynchronous(lambda host: [host] if host[0].isdigit() else ["10.77.0.1"])
        ), mock.patch.object(real, "host_name", lambda: "Desk.example.org"):
            self.assertFalse(self.certain("desk", ["10.77.0.2"]))
            for host, is_certain in (("desk", True), ("localhost", True), ("arm", False)):
                self.assertIs(self.certain(host, ["10.77.0.1"]), is_certain, host)

    def test_refusals_that_prove_death(self):
        self.assertTrue(self.certain("127.0.0.1", ["127.0.0.1"]))
        self.assertTrue(self.certain("10.77.0.2", ["10.77.0.2"]))
        self.assertTrue(self.certain("8.8.8.8", ["10.77.0.2"]))
        self.assertFalse(self.certain("192.168.0.7", ["10.77.0.2"]))
        self.assertFalse(self.certain("172.17.0.1", ["10.77.0.2"]))

    def test_a_refusal_elsewhere_proves_nothing(self):
        """Whoever else answers there: a firewall may close one port. Here it does, but not at an address that
        means another host to the name server.
        """
        for host, home, is_gone in (
            ("10.77.0.3", None, False),
            ("10.77.0.3", "10.77.0.3", False),
            ("10.77.0.1", None, True),
            ("10.77.0.1", "10.77.0.2", True),
            ("127.0.0.1", "127.0.0.1", True),
            ("127.0.0.1", "10.77.0.1", True),
            ("127.0.0.1", "10.77.0.2", False),
            ("172.17.0.1", "10.77.0.2", False),
        ):
            self.assertIs(wait_for(refusals.is_gone((host, 4000), home)), is_gone, (host, home))

    def test_addresses_apart_from_their_host(self):
        for published, apart in (("172.17.0.1", True), ("10.77.0.3", False), ("8.8.8.8", True), ("", False)):
            with mock.patch.object(
                networks.orb, "addresses", lambda ref: [(published, 4000)] if published else []
            ):
                self.assertEqual(wait_for(networks.is_apart(None, ["10.77.0.2"])), apart, published)

    def silent(self, published, failure):
        """What is said of an object that publishes an address, bound at 10.77.0.2, when a connection ends so;
        whether to delete it.
        """
        node = tree.Node(
            path.parse("/robot/A0.rtc"), "silent", None, errors.Silent("/robot/A0.rtc", "no answer within 1s")
        )
        visit = mock.Mock(probes={(published, 4000): failure}, addresses=["10.77.0.2"])
        with mock.patch.object(networks.orb, "addresses", lambda ref: [(published, 4000)]), mock.patch.object(
            networks.orb, "endpoint", lambda ref: (published, 4000)
        ), mock.patch.object(addresses, "arrives", asynchronous(lambda where: True)), mock.patch.object(
            addresses, "speaks_otherwise", asynchronous(lambda where: False)
        ):
            found = wait_for(
                references._silent(visit, node, [(published, 4000)], published + ":4000")
            )
        return found.message, found.remedy.startswith("rtdel")

    def test_why_an_object_is_silent(self):
        refused, lost = errors.ConnectionRefused("10.77.0.3:4000"), errors.Unreachable(
            "10.77.0.3:4000", "no route to host"
        )
        self.assertEqual(
            self.silent("10.77.0.3", refused),
            ("10.77.0.3:4000 refuses: dead, or a firewall closes this port", False),
        )
        self.assertEqual(self.silent("10.77.0.3", lost), (
            "cannot tell from here whether it lives: publishes 10.77.0.3:4000, out of reach (no "
            "route to host)", False))
        for failure, why in ((refused, "connection refused"), (lost, "no route to host")):
            self.assertEqual(self.silent("172.17.0.1", failure), (
                "cannot tell from here whether it lives: publishes 172.17.0.1:4000, of another network "
                "than its name server, out of reach (%s)" % why, False))
        self.assertEqual(self.silent("10.77.0.3", None)[0], "hung: 10.77.0.3:4000 accepts TCP, but no "
                                                            "answer within 1s")


class BelowManagers(unittest.TestCase):
    def test_a_slave_that_misleads(self):
        """It is not called gone because nobody listens at its port here."""
        manager = tree.Node(path.parse("/robot/manager.mgr"), "manager", None)
        slave = tree.Node(
            path.parse("/robot/manager.mgr/slave0"), "zombie", None, errors.ConnectionRefused("/a")
        )
        with mock.patch.object(networks.orb, "addresses", lambda ref: [("127.0.0.1", 4000)]), \
                mock.patch.object(networks, "homes_of", asynchronous(lambda ref: ["10.77.0.2"])), \
                mock.patch.object(addresses, "is_own", lambda address: False):
            finding, = wait_for(managers._troubles(manager, ([slave], [], False)))
        self.assertEqual(finding.message, "lists a slave that publishes 127.0.0.1:4000, which means this "
                                          "host, not its own")
        self.assertNotIn("restart", finding.remedy)


class Arrival(unittest.TestCase):
    def test_a_connection_has_a_deadline(self):
        """All addresses of a host share one."""
        given = []

        async def within(seconds, coroutine, late):
            coroutine.close()
            given.append(seconds)
            raise ConnectionRefusedError(errno.ECONNREFUSED, "refused")
        with mock.patch.object(loop, "within", within), self.assertRaises(errors.ConnectionRefused):
            wait_for(addresses.connect(["198.51.100.1", "198.51.100.2"], 4000), 3.0)
        self.assertTrue(0 < given[1] <= given[0] <= 3.0, given)

    def test_nobody_listens(self):
        with socket.socket() as bound:
            bound.bind(("127.0.0.1", 0))
            self.assertFalse(wait_for(addresses.arrives(bound.getsockname())))

    def test_a_process_that_hangs_takes_what_is_sent(self):
        with socket.socket() as listening:
            listening.bind(("127.0.0.1", 0))
            listening.listen(1)
            self.assertTrue(wait_for(addresses.arrives(listening.getsockname())))

    def test_a_host_has_several_addresses(self):
        def resolve(host, port=None, family=0, flags=0):
            return [
                (socket.AF_INET, socket.SOCK_STREAM, 6, "", (address, port))
                for address in ("127.0.0.2", "127.0.0.1")
            ]

        with socket.socket() as listening, mock.patch.object(real, "resolve", resolve):
            listening.bind(("127.0.0.1", 0))
            listening.listen(1)
            self.assertTrue(wait_for(addresses.arrives(("robot.example", listening.getsockname()[1]))))

    def test_another_protocol(self):
        """A server that waits for the end of a line is no hung process; one that hangs says nothing to that,
        either.
        """
        for line, found in ((b"HTTP/1.0 400 Bad request\r\n", True), (b"GIOP\1\2\1\4", False), (b"", False)):
            with socket.socket() as listening:
                listening.bind(("127.0.0.1", 0))
                listening.listen(1)
                serving = threading.Thread(target=self.answer_a_line, args=(listening, line))
                serving.start()
                self.assertIs(wait_for(addresses.speaks_otherwise(listening.getsockname()), 0.6), found, line)
                serving.join()

    def answer_a_line(self, listening, line):
        with listening.accept()[0] as connection:
            data = b""
            while not data.endswith(b"\r\n\r\n"):
                data += connection.recv(100)
            connection.sendall(line)
            if not line:
                connection.recv(1)  # until the other end has given up

    def test_large_packets_lost(self):
        with mock.patch.object(real, "unacknowledged", lambda connection: 1), socket.socket() as listening:
            listening.bind(("127.0.0.1", 0))
            listening.listen(1)
            where = listening.getsockname()
            silent = errors.Silent("/a", "no answer within 1s")
            self.assertTrue(wait_for(remedies.is_of_network(silent, where), 0.1))
            self.assertEqual(wait_for(remedies.of_silence(silent, where, "/a"), 0.1).name, "network")

    def test_blame(self):
        for e, name in (
            (errors.Unreachable("/a", "connection lost"), "network"),
            (errors.ConnectionRefused("/a"), "restart"),
            (errors.Refused("/a", "CORBA.UNKNOWN"), "restart"),
            (errors.NoTime("/a", session.NO_TIME), "more time"),
        ):
            self.assertEqual(wait_for(remedies.of_silence(e, ("198.51.100.1", 4000), "/a")).name, name, e)


class Shortages(unittest.TestCase):
    def test_threads(self):
        with mock.patch.object(threading.Thread, "start", side_effect=RuntimeError("can't start new thread")):
            finding, = limits.findings()
        self.assertIn("out of threads here (can't start new thread)", finding.message)

    def test_a_connection_that_fails_here(self):
        for number, what in (
            (errno.EMFILE, "files"),
            (errno.EADDRNOTAVAIL, "ports"),
            (errno.ENOBUFS, "memory"),
        ):
            now = session.Session()
            now.note_shortage(OSError(number, ""), "10.77.0.2")
            self.assertEqual(now.shortage.args[0], what)
        now = session.Session()
        now.note_shortage(OSError(errno.ECONNREFUSED, ""), "10.77.0.2")
        now.note_shortage(OSError(errno.EADDRNOTAVAIL, ""), "::1")
        self.assertIsNone(now.shortage)


class Waiting(unittest.TestCase):
    def test_the_process_that_is_called(self):
        with socket.socket() as calling, socket.socket() as called, socket.socket() as other:
            for each in (calling, called, other):
                each.bind(("127.0.0.1", 0))
                each.listen(1)
            with socket.create_connection(called.getsockname()):
                ends = {
                    one[1] for one in waiting._called_by(wait_for(waiting._sockets(calling.getsockname())))
                }
            self.assertIn(called.getsockname()[1], ends)
            self.assertNotIn(other.getsockname()[1], ends)


if __name__ == "__main__":
    unittest.main()
