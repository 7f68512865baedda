"""Our own ORB at its limits: time that is over, files that are used up, names that nobody resolves,
connections that are stale.
"""
import errno
import struct
import unittest
from unittest import mock

import world
from giop_client import answer
from peers import MOST, Calls, Listener, Peer, compute, forward, send, tasks
from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.corba.iiop import client, connections
from rtshell_lite.giop import cdr, marshal, messages, operations
from rtshell_lite.net import hosts, loop, tcp


class Slowly(Listener):
    """Forwards one request each half second to another object."""

    def __init__(self, host, to):
        self.to = to
        super().__init__(host)

    async def talk(self, connection):
        data = b""
        while True:
            while len(data) < messages.HEADER or len(data) < messages.HEADER + messages.size(data):
                octets = await tcp.receive(connection, MOST)
                if not octets:
                    return
                data += octets
            await loop.sleep(0.5)
            await send(connection, forward(self.to, messages.number(data)))
            data = data[messages.HEADER + messages.size(data):]


class Time(Calls):
    def test_no_call_begins_after_the_end_of_the_session(self):
        """However quickly those before were answered."""
        peer = self.script_of(answer)
        asked = []

        async def ask():
            for number in range(10):
                if number == 3:
                    self.session.end = loop.now() - 1
                try:
                    asked.append(await orb.call("w", peer.ref, "_non_existent"))
                except errors.NoTime as e:
                    asked.append(e.why)
        self.run_tasks((peer.ref, ask))
        self.assertEqual(asked, [False] * 3 + [session.NO_TIME] * 7)

    def test_one_late_forward_is_none_too_many(self):
        """A name server gets many questions at once, and each of its answers restarts the clock of all."""
        names = self.serve(Slowly(self.host, self.script_of(answer).ref))
        ref = client.narrow(names.ref, "CosNaming.NamingContext")
        spent, values = self.seconds(tasks(*[self.asking(ref)] * 12))
        self.assertEqual(values, [False] * 12)
        self.assertGreater(spent, 2 * self.session.timeout)

    def test_forwards_take_no_longer_than_three_answers(self):
        def play(pending):
            if not pending:
                return None
            compute(1.4)
            found = b"".join(forward(peer.ref, number) for number, _ in pending)
            pending.clear()
            return found

        peer = self.script(play)

        async def ask():
            with self.assertRaisesRegex(errors.Unreachable, "forwarded again and again|no answer"):
                await orb.call("w", peer.ref, "_non_existent")

        spent, _ = self.seconds(ask())
        self.assertLess(spent, 8)  # eight forwards took 11


class Connections(Calls):
    def test_stale_ones_are_forgotten_together(self):
        """A host that was switched off and on knows none of them, and it lives."""
        robot = self.world.host("robot", "10.0.0.2")
        port = Peer(robot).port
        endpoint = "10.0.0.2", port
        ref = client.from_url("w", f"corbaloc::10.0.0.2:{port}/x")

        async def connect():
            """Three connections that have answered, and are idle."""
            several = [connections.TcpConnection(endpoint) for _ in range(3)]
            for connection in several:
                while connection.waits_for:
                    await loop.sleep(0.01)
                    connection.go_on()
                connection.has_answered = True
            loop.current().session.memory.idle[endpoint] = several

        self.wait_for(connect())
        robot.lose_power()
        robot.is_on = True
        again = self.serve(Peer(robot, *[answer(1)] * 3, port=port))
        self.assertIs(self.wait_for(orb.call("w", ref, "_non_existent")), False)
        self.assertEqual(again.asked, 1)

    def test_files_that_idle_ones_use(self):
        first, second = [self.script_of(lambda number: answer(number)) for _ in range(2)]
        self.wait_for(orb.call("w", first.ref, "_non_existent"))
        stream = world.Program.stream

        def scarce(*args):
            if self.session.memory.idle.get(first.ref.address[1:3]):
                raise OSError(errno.EMFILE, "Too many open files")
            return stream(*args)
        with mock.patch.object(world.Program, "stream", scarce):
            self.assertIs(self.wait_for(orb.call("w", second.ref, "_non_existent")), False)
        self.assertIsNone(self.session.shortage)


class Names(Calls):
    def look_up(self, name):
        """Names of hosts that are switched off are looked up for long."""
        self.looked_up.append(name)
        self.most = max(self.most, len(loop.world().looking_up))
        if name.startswith("off"):
            raise world.Blocked
        return ["10.0.0.1"]

    def setUp(self):
        super().setUp()
        self.looked_up = []
        self.most = 0
        self.host.look_up = self.look_up

    def test_few_are_looked_up_at_a_time(self):
        """Each takes a thread, and a hostile name server gives thousands."""
        refs = []
        for number in range(200):
            self.world.host(f"off{number}", None)
            refs.append(client.from_url("w", f"corbaloc::off{number}:1/x"))
        found = self.run_tasks(*map(self.asking, refs))
        self.assertEqual({error.why for error in found}, {session.no_answer(2.0)})
        self.assertTrue(1 < self.most <= hosts.MOST, self.most)

    def test_a_dead_host_with_many_processes(self):
        """Its name is looked up once, and others are looked up beside it."""
        for name in ("off", "on"):
            self.world.host(name, None)
        peer = self.script_of(lambda number: answer(number))
        refs = [client.from_url("w", f"corbaloc::off:{number}/x") for number in range(1, 101)]
        refs.append(client.from_url("w", f"corbaloc::on:{peer.port}/x"))
        values = self.run_tasks(*map(self.asking, refs))
        self.assertIs(values.pop(), False)
        self.assertEqual({error.why for error in values}, {session.no_answer(2.0)})
        self.assertEqual(sorted(self.looked_up), ["off", "on"])

    def test_out_of_threads(self):
        """It costs the name, not all that is asked."""
        self.world.host("robot", None)
        peer = self.script_of(lambda number: answer(number))
        ref = client.from_url("w", "corbaloc::robot:1/x")
        with mock.patch.object(
            world.Program, "start_thread", side_effect=errors.Shortage("threads", "no more")
        ):
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
