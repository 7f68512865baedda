"""Our own ORB at its limits: time that is over, files that are used up, names that nobody resolves,
connections that are stale.
"""
import _socket
import errno
import socket
import struct
import threading
import time
import unittest
from unittest import mock

from giop_client import answer
from giop_peers import Calls, Peer, Script
import tools
from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.giop import cdr, descriptors
from rtshell_lite.net import hosts, real
from rtshell_lite.corba.iiop import client, connections
from rtshell_lite.giop import marshal, messages, operations


class Slowly(Script):
    """Answers one request each tenth of a second."""

    def talk(self, connection):
        data = b""
        pending = []
        connection.settimeout(0.1)
        while True:
            try:
                piece = connection.recv(65536)
                if not piece:
                    return
                data += piece
            except socket.timeout:
                if pending:
                    connection.sendall(self.play(pending.pop(0)))
            while len(data) >= messages.HEADER and len(data) >= messages.HEADER + messages.size(data):
                pending.append(messages.number(data))
                data = data[messages.HEADER + messages.size(data):]


class Time(Calls):
    def test_no_call_begins_after_the_end_of_the_session(self):
        """However quickly those before were answered."""
        peer = self.script_of(answer)
        asked = []

        async def ask():
            for number in range(10):
                if number == 3:
                    self.session.end = time.monotonic() - 1
                try:
                    asked.append(await orb.call("w", peer.ref, "_non_existent"))
                except errors.NoTime as e:
                    asked.append(e.why)
        self.run_tasks((peer.ref, ask))
        self.assertEqual(asked, [False] * 3 + [session.NO_TIME] * 7)

    def test_one_late_forward_is_none_too_many(self):
        """A name server gets many questions at once, and each of its answers restarts the clock of all."""
        self.session.timeout = 0.5
        body = bytearray(24)
        marshal.Maker("<").writer((descriptors.OBJECT, "", ""))(
            body, self.script_of(lambda number: answer(number)).ref
        )
        names = Slowly(lambda number: answer(number, bytes(body[24:]), messages.FORWARD))
        self.addCleanup(names.close)
        begun = time.monotonic()
        self.assertEqual(
            self.run_tasks(*[self.asking(client.narrow(names.ref, "CosNaming.NamingContext"))] * 12),
            [False] * 12,
        )
        self.assertGreater(time.monotonic() - begun, 2 * self.session.timeout)

    def test_forwards_take_no_longer_than_three_answers(self):
        self.session.timeout = 0.6
        body = bytearray(24)

        def play(pending):
            if not pending:
                return None
            time.sleep(0.4)
            found = b"".join(answer(number, bytes(body[24:]), messages.FORWARD) for number, _ in pending)
            pending.clear()
            return found
        peer = self.script(play)
        marshal.Maker("<").writer((descriptors.OBJECT, "", ""))(body, peer.ref)
        watch = tools.Stopwatch()
        with self.assertRaisesRegex(errors.Unreachable, "forwarded again and again|no answer"):
            self.wait_for(orb.call("w", peer.ref, "_non_existent"))
        self.assertLess(watch.seconds(), 2.4)  # eight forwards took 3.2


async def connection_to(endpoint):
    """A Connection of the session of this loop."""
    return connections.TcpConnection(endpoint)


class Connections(Calls):
    def setUp(self):
        super().setUp()
        self.idle = self.session.memory.idle
        self.addCleanup(lambda: connections.forget(self.session.memory, *list(self.idle)))

    def test_stale_ones_are_forgotten_together(self):
        """A host that was switched off and on knows none of them, and it lives."""
        peer = Peer(*[answer(1)] * 3)
        self.addCleanup(peer.close)
        ref = client.from_url("w", f"corbaloc::127.0.0.1:{peer.port}/x")
        endpoint = ref.address[1:3]
        stale = []
        for _ in range(3):
            one = self.wait_for(connection_to(endpoint))
            one.waits_for = None
            one.has_answered = True
            one._candidates = None
            one._socket, far = _socket.socketpair()
            stale.append((one, far))
        self.idle[endpoint] = [one for one, _ in stale]
        with mock.patch.object(connections.TcpConnection, "is_idle", lambda self: True):  # nobody has told us
            for _, far in stale:
                far.close()
            self.assertIs(self.wait_for(orb.call("w", ref, "_non_existent")), False)
        self.assertEqual(peer.asked, 1)

    def test_files_that_idle_ones_use(self):
        first, second = [self.script_of(lambda number: answer(number)) for _ in range(2)]
        self.wait_for(orb.call("w", first.ref, "_non_existent"))

        stream = real.stream

        def scarce(*args):
            if self.idle.get(first.ref.address[1:3]):
                raise OSError(errno.EMFILE, "Too many open files")
            return stream(*args)
        with mock.patch.object(real, "stream", scarce):
            self.assertIs(self.wait_for(orb.call("w", second.ref, "_non_existent")), False)
        self.assertIsNone(self.session.shortage)


class Names(Calls):
    def setUp(self):
        super().setUp()
        patch = mock.patch.object(real, "looking_up", {})
        patch.start()
        self.addCleanup(patch.stop)

    def test_few_are_looked_up_at_a_time(self):
        """Each takes a thread, and a hostile name server gives thousands."""
        self.session.timeout = 0.5
        free = threading.Event()
        most = []

        def hanging(host, port=None, family=0, flags=0):
            if not flags:
                most.append(threading.active_count())
                free.wait(30)
            raise _socket.gaierror(-2, "unknown")
        refs = [client.from_url("w", f"corbaloc::robot{number}.example:1/x") for number in range(200)]
        before = threading.active_count()
        with mock.patch.object(real, "resolve", hanging):
            found = self.run_tasks(*map(self.asking, refs))
            free.set()
            while real.looking_up:
                time.sleep(0.01)
        self.assertEqual({error.why for error in found}, {session.no_answer(0.5)})
        self.assertLessEqual(max(most) - before, hosts.MOST)

    def test_a_dead_host_with_many_processes(self):
        """Its name is looked up once, and others are looked up beside it."""
        self.session.timeout = 1.0
        free = threading.Event()
        asked = []
        self.addCleanup(free.set)
        peer = self.script_of(lambda number: answer(number))
        _, host, port, _ = peer.ref.address
        resolve = real.resolve

        def found(name, port=None, family=0, flags=0):
            if flags:
                raise _socket.gaierror(-2, "unknown")
            asked.append(name)
            if name == b"off.example":
                free.wait(30)
                raise _socket.gaierror(-2, "unknown")
            return resolve(host, port, family, flags)
        refs = [client.from_url("w", f"corbaloc::off.example:{number}/x") for number in range(1, 101)]
        refs.append(client.from_url("w", f"corbaloc::on.example:{port}/x"))
        with mock.patch.object(real, "resolve", found):
            values = self.run_tasks(*map(self.asking, refs))
        self.assertIs(values.pop(), False)
        self.assertEqual({error.why for error in values}, {session.no_answer(1.0)})
        self.assertEqual(sorted(asked), [b"off.example", b"on.example"])

    def test_out_of_threads(self):
        """It costs the name, not all that is asked."""
        peer = self.script_of(lambda number: answer(number))
        ref = client.from_url("w", "corbaloc::robot.example:1/x")
        with mock.patch.object(real, "start_thread", side_effect=errors.Shortage("threads", "no more")):
            lost, found = self.run_tasks(self.asking(ref), self.asking(peer.ref))
        self.assertIs(found, False)
        self.assertIn("out of threads here: no more", lost.why)


class Readers(unittest.TestCase):
    def test_one_that_was_half_made_when_a_signal_struck(self):
        """It is made again: in rtsh others are to use it."""
        nvlist = orb.idl.descriptor("IDL:org.omg/SDOPackage/NVList:1.0")
        for nth in range(1, 8):
            maker = marshal.Maker("<")
            made = []

            def struck(descriptor):
                made.append(descriptor)
                if len(made) == nth:
                    raise KeyboardInterrupt
                return real(descriptor)
            real = cdr.fixed
            with mock.patch.object(cdr, "fixed", struck):
                try:
                    maker.reader(nvlist)
                except KeyboardInterrupt:
                    pass
            self.assertEqual(maker.reader(nvlist)(struct.pack("<I", 0), 0), ([], 4))
        self.assertIs(operations.reader(nvlist, 1), operations.reader(nvlist, 1))


if __name__ == "__main__":
    unittest.main()
