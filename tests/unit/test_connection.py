"""Connections of data ports: if this fails, Ctrl-C takes longer the more ports there are, or commands report
the wrong status.
"""
import collections
import signal
import unittest
from unittest import mock

from peers import Calls
from rtshell_lite import cli, errors, path
from rtshell_lite.corba import servants
from rtshell_lite.data import port_arguments, rates, reading, sender, watcher, writing
from rtshell_lite.data.connection import Connections
from rtshell_lite.data.inbox import EACH, Inbox
from rtshell_lite.net import loop
from rtshell_lite.robot import ports

LIMIT = 10.0  # seconds that anything may take
ENDS = {signal.SIGINT: KeyboardInterrupt}


def idle_reader():
    """The part of a push Reader that closes it, for a port that sends nothing."""
    reader = reading.Reader.__new__(reading.Reader)
    reader.dataflow = "push"
    reader.agreed = {"dataport.subscription_type": "periodic"}
    reader.served = None
    reader.first = 0.0
    reader.last = 0.0
    reader.count = 0
    reader.heaviest = 0
    reader.renew()
    return reader


class Connection:
    """Replaces a connection.PortConnection; signals come while it is opened or closed."""

    def __init__(self, strikes=()):
        self.strikes = strikes
        self.endpoint = ("here", 1)
        self.where = "/a.rtc:out"
        self.failure = self.connector = None
        self.is_still_silent = False
        self.is_closing = False
        self.is_looking = loop.Bell()

    async def strike(self, step):
        if step in self.strikes:
            loop.current().strike(signal.SIGINT)
        await loop.sleep(0.05)

    async def open(self):
        await self.strike("open")
        await loop.finish(self.connect())

    async def connect(self):
        await self.strike("connect")
        self.connector = "made"
        await self.strike("connected")

    async def close(self):
        await self.strike("close")
        await self.strike("close again")
        self.connector = None

    async def check(self):
        self.is_looking.ring()
        while not self.is_closing:
            await loop.sleep(0.01)
        raise errors.Unreachable(self.where, "the connection has been removed")

    def is_due(self):
        return True

    def stop(self):
        """It does nothing that had to end before."""

    def report(self, known, unwound):
        """It never stays."""


class Struck(Calls):
    """Signals at the worst of moments leave no connection in a robot."""

    def test_none_is_left_whenever_ctrl_c_comes(self):
        for strikes in (
            ["open"],
            ["connect"],
            ["connected"],
            ["close"],
            ["connect", "close"],
            ["close", "close again"],
        ):
            for others in (0, 6):  # more than calls are made at a time
                with self.subTest(strikes=strikes, others=others), mock.patch.object(loop, "BOUNCE", 0):
                    every = [Connection() for _ in range(others)] + [Connection(strikes)]

                    async def main():
                        async with Connections(every):
                            await loop.sleep(0 if strikes[0].startswith("close") else LIMIT)
                    begun = self.world.time
                    with self.assertRaises(KeyboardInterrupt):
                        self.wait_for(main(), ENDS)
                    self.assertEqual([each.connector for each in every], [None] * len(every))
                    self.assertLess(self.world.time - begun, LIMIT / 10)

    def test_a_connector_that_we_removed_is_no_failure(self):
        connection = Connection()

        async def main():
            with mock.patch("rtshell_lite.data.connection.LOOK", 0.01):
                async with Connections([connection]):
                    await connection.is_looking.wait(LIMIT)
        self.wait_for(main())
        self.assertEqual((connection.failure, connection.connector), (None, None))

    def test_one_that_was_silent_when_it_was_to_connect_is_not_connected(self):
        connection = Connection()
        connection.failure = errors.Silent(connection.where, "no answer")
        self.assertEqual(Connections([connection]).live(), [])
        connection.connector = "made"
        self.assertEqual(Connections([connection]).live(), [connection])

    def test_a_value_that_is_on_its_way_is_waited_for(self):
        """Else nobody knows whether the component is taking it, and the connection stays."""
        writer = writing.Writer.__new__(writing.Writer)
        taken = []
        writer.little = True
        writer.unanswered = False

        async def put(data):
            loop.current().strike(signal.SIGINT)
            await loop.sleep(0.05)
            taken.append(data)
        with mock.patch.object(writer, "_put", put), self.assertRaises(KeyboardInterrupt):
            self.wait_for(writer.put(b"data"), ENDS)
        self.assertEqual(taken, [b"data"])


class Bounded(unittest.TestCase):
    def test_values_being_written_count_as_memory(self):
        """rtlog at full flood held 144 MiB, though 64 may wait: what it was writing did not count."""
        box = Inbox(most_bytes=2 * (400 + EACH) + 200)

        def get():
            return loop.run(box.get(0))
        for _ in range(2):
            box.put(0, reading.Message(0, b"x" * 400, True))
        self.assertEqual(len(get()), 2)
        for _ in range(3):
            box.put(0, reading.Message(0, b"x" * 400, True))
        self.assertEqual((len(box.waiting), box.dropped[0]), (1, 2))
        get()
        get()
        box.put(0, reading.Message(0, b"x" * 400, True))
        self.assertEqual(len(box.waiting), 1)


class Closing(Calls):
    def rest(self, count, take=lambda reader: None):
        """How long so many readers that are stopped wait, together, until their connectors can be removed;
        `take` is called with each before.
        """
        async def main():
            readers = [idle_reader() for _ in range(count)]
            for reader in readers:
                reader.early = []
                reader.stop()
                take(reader)
            self.assertEqual(await loop.each(readers, reading.Reader.is_at_rest), [True] * count)
        with mock.patch.object(reading.orb, "answers_at_once", lambda: True):
            spent, _ = self.seconds(main())
            return spent

    def test_ports_that_send_nothing_are_waited_for_together(self):
        self.assertLess(self.rest(100), 1.5 * reading.QUIET)

    def test_a_value_that_came_long_ago_is_no_sign(self):
        """A value that came while others were closed does not count; the next one is waited for, up to a
        limit.
        """
        self.assertGreater(self.rest(1, lambda reader: reader._take(0, b"")), reading.QUIET)

    def test_a_connector_is_removed_right_after_a_value(self):
        """While its answer is on its way the publisher does not use the connector; a moment later it may
        again.
        """
        turns = []

        async def main():
            def take():
                reader._take(0, b"")
                loop.current().before_waiting.append(lambda: turns.append("another turn of the loop"))

            reader = idle_reader()
            reader.stop()
            loop.current().call_later(0.02, take)
            await reader.is_at_rest()
        with mock.patch.object(reading, "QUIET", LIMIT), mock.patch.object(
            reading.orb, "answers_at_once", lambda: True
        ):
            self.wait_for(main())
        self.assertEqual(turns, [])


class Early(unittest.TestCase):
    def test_values_that_come_before_the_connection_is_made(self):
        """They wait in memory, so there is a limit: a component that goes on gets BUFFER_FULL.
        """
        for receiver in servants.RECEIVERS.values():
            reader = idle_reader()
            servant = receiver(reader._take, reader._is_full)
            put = getattr(servant, "put", None) or servant.push
            with mock.patch.object(reading, "BUFFER_BYTES", 1000):
                self.assertEqual(
                    [str(put(b"x" * 400)) for _ in range(3)], ["PORT_OK", "PORT_OK", "BUFFER_FULL"]
                )
            self.assertEqual((reader.count, len(reader.early)), (2, 2))


class Live(unittest.TestCase):
    def test_values_are_sent_to_ends_that_answer(self):
        """Silent ones only if there is nobody else; those whose connection failed otherwise never."""
        silent = errors.Silent("a", "no answer")
        refused = errors.Refused("a", "no")
        for failures, expected in (
            ((None, silent, refused), [0]),
            ((silent, refused, silent), [0, 2]),
            ((refused,), []),
        ):
            writers = [mock.Mock(failure=failure) for failure in failures]
            self.assertEqual(
                [number for _, number in sender.Injection.live(mock.Mock(writers=writers))], expected
            )


class Status(unittest.TestCase):
    """The exit status of commands that stay connected: that of the failures, or 5 where another connection
    was of use.
    """

    def status(self, *failures, **more):
        connections = [mock.Mock(failure=failure) for failure in failures]
        tally = cli.Tally()
        with mock.patch.object(cli, "complain"):
            watcher.Watcher(connections).count(
                tally, [connections[number] for number in more.get("useless", ())]
            )
        return tally.done, tally.status()

    def test_it(self):
        failure = errors.Silent("a", "no answer")
        self.assertEqual(self.status(None, None), (2, 0))
        self.assertEqual(self.status(None, failure), (1, 5))
        self.assertEqual(self.status(None, failure, useless=[0]), (0, 4))
        self.assertEqual(self.status(failure, useless=[0]), (0, 4))


class Arguments(unittest.TestCase):
    """Which port PATH:PORT.NAME means."""

    def found(self, word, *names):
        known = [ports.Port(None, name, "DataOutPort", {}, [], [], name, None) for name in names]
        found = port_arguments._named(port_arguments.parse([word])[0], known)
        return str(found) if isinstance(found, errors.Error) else (found.port.name, found.name)

    def test_it(self):
        self.assertEqual(self.found("/h/A.rtc:out", "A.out"), ("A.out", None))
        self.assertEqual(self.found("/h/A.rtc:out.one", "A.out"), ("A.out", "one"))
        self.assertEqual(self.found("/h/A.rtc:out.one", "A.out", "A.out.one"), ("A.out.one", None))
        for word in ("out.o-ne", "in.one", "one"):
            self.assertEqual(
                self.found("/h/A.rtc:" + word, "A.out"), "/h/A.rtc: no such port: %s (its ports: out)" % word
            )


def answer(*answers):
    """A coroutine function that returns these, one after the other."""
    waiting = list(answers)

    async def asked(*args):
        return waiting.pop(0)
    return asked


class Rates(unittest.TestCase):
    """The rate of a component, by what it writes."""

    def measured(self, *counts, **more):
        node = collections.namedtuple("Node", "path")(path.parse("/h/A.rtc"))
        kinds = [("A.in", "DataInPort")] + [
            ("A.out%d" % number, "DataOutPort") for number in range(len(counts))
        ]
        known = [ports.Port(node, name, kind, {}, [], [], name, None) for name, kind in kinds]
        with mock.patch(
            "rtshell_lite.robot.component.state", answer(more.get("state", "Active"))
        ), mock.patch("rtshell_lite.robot.ports.ports", answer(known)), mock.patch(
            "rtshell_lite.data.reading.count_writes", answer(*[(count, 2.0) for count in counts])
        ):
            return loop.run(rates.measured(node, 2.0))

    def test_the_first_port_that_is_written_to(self):
        self.assertEqual(self.measured(20, 90), (10.0, "writes to out0"))
        self.assertEqual(self.measured(0, 1, 2), (1.0, "writes to out2"))

    def test_why_not(self):
        self.assertEqual(self.measured(), (None, "no out port is written to"))
        self.assertEqual(self.measured(1), (None, "no out port is written to"))
        self.assertEqual(self.measured(state="Inactive"), (None, "the component is not Active"))


if __name__ == "__main__":
    unittest.main()
