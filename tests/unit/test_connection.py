"""Connections of data ports: if this fails, Ctrl-C takes longer the more ports there are, or commands report the wrong status."""
import collections
import threading
import time
import unittest
from unittest import mock

from rtshell_lite import cli, errors, path
from rtshell_lite.corba import servants
from rtshell_lite.data import port_words, rates, reading, sender, watcher
from rtshell_lite.robot import ports


def idle_reader():
    """The part of a push Reader that closes it, for a port that sends nothing."""
    reader = reading.Reader.__new__(reading.Reader)
    reader.dataflow, reader.agreed = "push", {"dataport.subscription_type": "new"}
    reader.first = reader.last = 0.0
    reader.ended, reader.came = threading.Event(), threading.Event()
    return reader


class Closing(unittest.TestCase):
    def test_ports_that_send_nothing_are_waited_for_together(self):
        readers = [idle_reader() for _ in range(100)]
        begun = time.monotonic()
        for reader in readers:
            reader.stop()
        self.assertTrue(all(reader.is_at_rest() for reader in readers))
        self.assertLess(time.monotonic() - begun, 100 * reading.QUIET / 2)

    def test_a_value_that_came_long_ago_is_no_sign(self):
        """A value that came while others were closed does not count; the next one is waited for, up to a limit."""
        reader = idle_reader()
        reader.stop()
        reader.came.set()
        begun = time.monotonic()
        self.assertTrue(reader.is_at_rest())
        self.assertGreater(time.monotonic() - begun, reading.QUIET)

    def test_a_connector_is_removed_right_after_a_value(self):
        """While its answer is on its way the publisher does not use the connector; a moment later it may again."""
        reader, slept = idle_reader(), []
        reader.stop()
        reader.came = mock.Mock(wait=lambda seconds: True, is_set=lambda: False)
        with mock.patch.object(reading.time, "sleep", slept.append):
            self.assertTrue(reader.is_at_rest())
        self.assertEqual(slept, [])


class Early(unittest.TestCase):
    def test_values_that_come_before_the_connection_is_made(self):
        """They wait in memory, so there is a limit: a component that goes on is told that the buffer is full."""
        for receiver in servants.RECEIVERS.values():
            reader = idle_reader()
            reader.early, reader.early_bytes, reader.lock, reader.count, reader.heaviest = [], 0, threading.Lock(), 0, 0
            servant = receiver(reader._take)
            put = getattr(servant, "put", None) or servant.push
            with mock.patch.object(reading, "BUFFER_BYTES", 1000):
                self.assertEqual([str(put(b"x" * 400)) for _ in range(3)], ["PORT_OK", "PORT_OK", "BUFFER_FULL"])
            self.assertEqual((reader.count, len(reader.early)), (2, 2))


class Live(unittest.TestCase):
    def test_whom_values_are_sent_to(self):
        """Silent ones only if there is nobody else; those whose connection failed otherwise never."""
        silent, refused = errors.Silent("a", "no answer"), errors.Refused("a", "no")
        for failures, expected in (((None, silent, refused), [0]), ((silent, refused, silent), [0, 2]), ((refused,), [])):
            writers = [mock.Mock(failure=failure) for failure in failures]
            self.assertEqual([number for _, number in sender.Injection.live(mock.Mock(writers=writers))], expected)


class Status(unittest.TestCase):
    """The exit status of commands that stay connected: that of the failures, or 5 where another connection was of use."""

    def status(self, *failures, **more):
        connections = [mock.Mock(failure=failure) for failure in failures]
        tally = cli.Tally()
        with mock.patch.object(cli, "complain"):
            watcher.Watcher(connections).count(tally, [connections[number] for number in more.get("of_no_use", ())])
        return tally.done, tally.status()

    def test_it(self):
        failure = errors.Silent("a", "no answer")
        self.assertEqual(self.status(None, None), (2, 0))
        self.assertEqual(self.status(None, failure), (1, 5))
        self.assertEqual(self.status(None, failure, of_no_use=[0]), (0, 4))
        self.assertEqual(self.status(failure, of_no_use=[0]), (0, 4))


class Words(unittest.TestCase):
    """Which port PATH:PORT.NAME means."""

    def found(self, word, *names):
        known = [ports.Port(None, name, "DataOutPort", {}, [], [], name, None) for name in names]
        found = port_words._named(port_words.parse([word])[0], known)
        return str(found) if isinstance(found, errors.Error) else (found.port.name, found.name)

    def test_it(self):
        self.assertEqual(self.found("/h/A.rtc:out", "A.out"), ("A.out", None))
        self.assertEqual(self.found("/h/A.rtc:out.one", "A.out"), ("A.out", "one"))
        self.assertEqual(self.found("/h/A.rtc:out.one", "A.out", "A.out.one"), ("A.out.one", None))
        for word in ("out.o-ne", "in.one", "one"):
            self.assertEqual(self.found("/h/A.rtc:" + word, "A.out"), "/h/A.rtc: no such port: %s (its ports: out)" % word)


class Rates(unittest.TestCase):
    """The rate of a component, by what it writes."""

    def measured(self, *counts, **more):
        node = collections.namedtuple("Node", "path")(path.parse("/h/A.rtc"))
        kinds = [("A.in", "DataInPort")] + [("A.out%d" % number, "DataOutPort") for number in range(len(counts))]
        known = [ports.Port(node, name, kind, {}, [], [], name, None) for name, kind in kinds]
        with mock.patch("rtshell_lite.robot.component.state", return_value=more.get("state", "Active")), \
                mock.patch("rtshell_lite.robot.ports.ports", return_value=known), \
                mock.patch("rtshell_lite.data.reading.count_writes", side_effect=[(count, 2.0) for count in counts]):
            return rates.measured(node, 2.0)

    def test_the_first_port_that_is_written_to(self):
        self.assertEqual(self.measured(20, 90), (10.0, "writes to out0"))
        self.assertEqual(self.measured(0, 1, 2), (1.0, "writes to out2"))

    def test_why_not(self):
        self.assertEqual(self.measured(), (None, "no out port is written to"))
        self.assertEqual(self.measured(1), (None, "no out port is written to"))
        self.assertEqual(self.measured(state="Inactive"), (None, "the component is not Active"))


if __name__ == "__main__":
    unittest.main()
