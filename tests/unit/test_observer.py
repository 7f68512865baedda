"""What components tell observers, and what we make of it: if this fails, rtwatch shows words of the wire, or the wrong ones."""
import threading
import time
import unittest
from unittest import mock

from rtshell_lite import errors, path
from rtshell_lite.corba import lanes
from rtshell_lite.events import watch
from rtshell_lite.events.observer import Record, event


class Hints(unittest.TestCase):
    """As C++ and Python 2.x send them (protocol of observers)."""

    def check(self, status, hint, *expected):
        self.assertEqual(tuple(event(1.0, status, hint)), (1.0,) + expected)

    def test_status(self):
        self.check("RTC_STATUS", "ACTIVE:0", "RTC_STATUS", "0", "ACTIVE")
        self.check("RTC_STATUS", "FINALIZE:1000", "RTC_STATUS", "1000", "FINALIZE")
        self.check("EC_STATUS", "RATE_CHANGED:0", "EC_EVENT", "0", "EC_RATE_CHANGED")

    def test_ports(self):
        """A port's name may hold colons."""
        self.check("PORT_PROFILE", "CONNECT:a:b.out", "PORT_EVENT", "a:b.out", "PORT_CONNECT")
        self.check("PORT_PROFILE", "SEND:OutPort:ConsoleIn0.out", "PORT_EVENT", "ConsoleIn0.out", "PORT_SEND")
        self.check("PORT_PROFILE", "RECEIVE:InPort:A.in", "PORT_EVENT", "A.in", "PORT_RECEIVE")

    def test_configuration(self):
        """With a blank, and words of its own."""
        for word, ours in (("UPDATE_CONFIG_SET", "UPDATE_SET"), ("UPDATE_CONFIG_PARAM", "UPDATE_PARAM"),
                           ("SET_CONFIG_SET", "SET_SET"), ("ADD_CONFIG_SET", "ADD_SET"), ("REMOVE_CONFIG_SET", "REMOVE_SET"),
                           ("ACTIVATE_CONFIG_SET", "ACTIVATE_SET")):
            self.check("CONFIGURATION", word + ": default", "CONFIG_EVENT", "default", "CFG_" + ours)
        self.check("CONFIGURATION", "NEWS: x", "CONFIG_EVENT", "x", "NEWS")

    def test_others(self):
        self.check("COMPONENT_PROFILE", "a,b", "COMPONENT_PROFILE", "", "a,b")
        self.check("HEARTBEAT", "", "HEARTBEAT", "", "HEARTBEAT")
        self.check("EC_HEARTBEAT", "HEARTBEAT:0", "HEARTBEAT", "", "EC_HEARTBEAT")
        self.check("FSM_STATUS", "closed PRE_ON_EXIT", "FSM_EVENT", "FSM_STATUS", "closed PRE_ON_EXIT")
        self.check("RTC_STATUS", "", "RTC_STATUS", "", "")
        self.check("STATUS_KIND_NUM", "?", "STATUS_KIND_NUM", "", "?")


class Names(unittest.TestCase):
    def names(self, *paths):
        """What lines of these components begin with; None for one that is not there."""
        def on_components(wanted, begin):
            return [begin(mock.Mock(path=each, endpoint=("h", 1))) if each.names else errors.NotFound(str(each)) for each in wanted]

        def begin(watched, node):
            watched.node = node
        with mock.patch.object(watch.tree, "on_components", on_components), mock.patch.object(watch.lanes, "start"), \
                mock.patch.object(watch.Watched, "begin", begin):
            results = watch.Watch(watch.Event, None).start([path.parse(each) for each in paths])
        return [getattr(result, "name", None) for result in results]

    def test_those_that_share_one_are_called_by_their_paths(self):
        self.assertEqual(self.names("/h/a.cxt/Arm0.rtc", "/h", "/h/b.cxt/Arm0.rtc", "/h/b.cxt/Hand0.rtc"),
                         ["/h/a.cxt/Arm0.rtc", None, "/h/b.cxt/Arm0.rtc", "Hand0.rtc"])


class Waiting(unittest.TestCase):
    def test_what_waits_to_be_printed_has_few_megabytes(self):
        """Who reads may have stopped, and records may be long."""
        said = []
        watching = watch.Watch(watch.Records("NORMAL", []), said.append)
        watching.watched = [mock.Mock()]
        with mock.patch.object(watch, "MOST_CHARACTERS", 3000):
            for _ in range(3):
                watching.put(watching.watched[0], Record(1.0, "arm", "INFO", "x" * 1000))
            self.assertEqual(len(list(watching.follow(2, 5, mock.Mock()))), 2)
            watching.put(watching.watched[0], Record(2.0, "arm", "INFO", "x" * 2000))
            (_, record), = watching.follow(1, 5, mock.Mock())
        self.assertEqual(record.time, 2.0)
        self.assertIn("1 lines dropped", said[0])


class Ending(unittest.TestCase):
    def test_each_component_is_asked_to_forget_us_however_late_a_processor_is_free(self):
        watching, asked = watch.Watch(watch.Events(watch.KINDS), self.fail), [threading.Event() for _ in range(3)]
        for number, event_of_it in enumerate(asked):
            watching.remember(mock.Mock(node=mock.Mock(endpoint=("h", number)), where="/h", detach=event_of_it.set))
        with mock.patch.object(watch, "HURRY", 0), mock.patch.object(watch, "STARTING", 60):
            watching.close(hurried=True)
        for event_of_it in asked:
            self.assertTrue(event_of_it.wait(60))

    def test_one_that_is_slow_is_not_waited_for(self):
        """Nor are those of a process that is silent, which are not asked."""
        watching, free, notes = watch.Watch(watch.Events(watch.KINDS), lambda line: notes.append(line)), threading.Event(), []
        self.addCleanup(free.set)
        before = lanes.session
        lanes.session = lanes.Session(60)
        self.addCleanup(setattr, lanes, "session", before)
        lanes.session.silent["silent"] = time.monotonic(), "no answer within 60s"
        for endpoint in ("slow", "silent") + ("slow",) * 20:
            watching.remember(mock.Mock(node=mock.Mock(endpoint=endpoint), where="/h", detach=lambda: free.wait(40)))
        begun = time.monotonic()
        with mock.patch.object(watch, "STARTING", 60):
            watching.close(hurried=True)
        self.assertLess(time.monotonic() - begun, 30)
        self.assertIsNone(lanes.session.end)


if __name__ == "__main__":
    unittest.main()
