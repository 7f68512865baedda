"""Which stage rttrace names, of what was measured, on a machine that is idle or busy."""
import struct
import unittest

from rtshell_lite import errors, path
from rtshell_lite.data import reading
from rtshell_lite.doctor import trace
from rtshell_lite.robot import component, ports, tree

BEGUN = 1700000000 * 10**9  # ns since 1970
SECONDS = 3.0
CONTEXT = component.Context(0, None, None, 50.0, True, None, (), ())


def chain(count, slower=1.0):
    """A Trace of Link0, Link1 …, active at 50 Hz, which have been found."""
    made = trace.Trace()
    made.slower = slower
    made.patience = 1.0
    for number in range(count):
        node = tree.Node(path.parse("/h/Link%d.rtc" % number), "component")
        stage = made.stages[number] = trace.Stage(node, number)
        stage.error = None
        stage.state = "Active"
        stage.contexts = [CONTEXT]
        stage.answer = 0.001
        about = {"dataport.data_type": "IDL:RTC/TimedLong:1.0"}
        watch = trace.Watch(ports.Port(node, "out", "DataOutPort", about, [], [], None, None))
        watch.begun = BEGUN
        watch.until = BEGUN + int(SECONDS * 1e9)
        watch.seconds = SECONDS
        stage.watches.append(watch)
        if number:
            fed = made.stages[number - 1].watches[0]
            into = ports.Port(node, "in", "DataInPort", {}, [], [], None, None)
            made.links.append(trace.Link(fed, stage, into, True))
    return made


def send(made, number, delay=0.0, every=1):
    """Values of 50 Hz come out of a stage, or one of some."""
    for at in range(0, int(SECONDS * 50), every):
        sent = BEGUN + at * 20 * 10**6
        data = struct.pack("<LLl", sent // 10**9, sent % 10**9, at)
        received = sent + int(delay * 1e9)
        if received < BEGUN + SECONDS * 1e9:
            made.stages[number].watches[0].take(reading.Message(received, data, True))


class Verdicts(unittest.TestCase):
    def verdict(self, made):
        """The number of the stage that is named, "none", or "not sure"."""
        made.note_delays()
        culprit = made.culprit()
        if culprit is None:
            return "none"
        where, fault = culprit
        if where is None:
            self.assertEqual(fault.sure, trace.DOUBTFUL)
            return "not sure"
        self.assertNotEqual(fault.sure, trace.DOUBTFUL)
        return int(where[len("/h/Link") : -len(".rtc")])

    def test_fewer_values_are_a_fault_unless_the_machine_explains_them(self):
        for every, slower, expected in (
            (1, 1.0, "none"),
            (2, 1.0, 1),
            (2, 20.0, "not sure"),
            (10, 1.0, 1),
            (10, 20.0, 1),
        ):
            made = chain(3, slower)
            send(made, 0)
            send(made, 1, every=every)
            send(made, 2, every=every)
            self.assertEqual(self.verdict(made), expected, (every, slower))

    def test_a_stage_is_late_if_others_are_not(self):
        for delays, slower, expected in (
            ((0, 0.8), 1.0, 1),
            ((0, 0.8), 2.5, 1),
            ((0, 0.8), 20.0, "not sure"),
            ((0, 0.8, 0.85, 0.9), 20.0, 1),
            ((0, 0.3, 0.6, 0.9), 20.0, "not sure"),
            ((0, 0.01, 0.02, 0.03), 20.0, "none"),
        ):
            made = chain(len(delays), slower)
            for number, delay in enumerate(delays):
                send(made, number, delay)
            self.assertEqual(self.verdict(made), expected, (delays, slower))

    def test_values_that_went_in_a_moment_ago_need_not_have_come_out(self):
        for slower, shown, expected in ((1.0, 3.0, 1), (1.0, 0.1, "none"), (20.0, 3.0, "not sure")):
            made = chain(3, slower)
            send(made, 0)
            made.stages[1].watches[0].begun = made.stages[1].watches[0].until - int(shown * 1e9)
            self.assertEqual(self.verdict(made), expected, (slower, shown))

    def test_a_source_has_time_to_write(self):
        for slower, expected in ((1.0, 0), (2.5, 0), (20.0, "not sure")):
            self.assertEqual(self.verdict(chain(2, slower)), expected, slower)

    def test_silence_means_something_if_others_answer_soon(self):
        silent = errors.Silent("/h/Link1.rtc", "no answer within 1s")
        gone = errors.Unreachable("/h/Link1.rtc", "the process is gone")
        late = errors.Silent("/h/Link1.rtc", trace.UNANSWERED)
        for error, answer, slower, expected in (
            (silent, 0.001, 1.0, 1),
            (silent, 0.001, 20.0, 1),
            (silent, 0.3, 20.0, "not sure"),
            (silent, 0.3, 1.0, "not sure"),  # others are as slow, though not for this machine
            (gone, 0.3, 20.0, 1),
            (late, 0.001, 1.0, "not sure"),
        ):
            made = chain(2, slower)
            send(made, 0)
            made.stages[0].answer = answer
            made.stages[1].answer = 0.0
            made.stages[1].error = error
            self.assertEqual(self.verdict(made), expected, (str(error), answer, slower))

    def test_a_way_that_was_not_followed_to_its_end_is_no_way_that_passes(self):
        made = chain(2)
        send(made, 0)
        send(made, 1)
        made.is_cut = True
        self.assertEqual(self.verdict(made), "not sure")

    def test_a_context_of_others_that_hangs_is_not_said_to_be_stopped(self):
        made = chain(2)
        send(made, 0)
        made.stages[1].contexts = [CONTEXT._replace(rate=None, running=None)]
        _, fault = made.culprit()
        self.assertEqual(fault.words, "its execution context does not answer")


if __name__ == "__main__":
    unittest.main()
