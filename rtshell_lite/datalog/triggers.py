"""Conditions upon which a flight recorder keeps what has happened.

error, death, disconnect      what components report
silent PATH:PORT SECONDS      no value has come for so long, after one had come
PATH:PORT.FIELD OP VALUE      a value is <, <=, >, >=, ==, != a number or a word, which those before were not
"""

import operator
import re

from rtshell_lite import errors, notes
from rtshell_lite.data import values
from rtshell_lite.datalog import records, schemas
from rtshell_lite.net import loop, real
from rtshell_lite.text import printable

LOOK = 0.05  # seconds between two looks
UNNOTICED = 1.5  # seconds, at most, for which a component is usually dead before that is noticed
NO_PORT = "no port has this name yet"
# {word: (events as in `system/journal.py`, the `delay` of a Condition)}
EVENTS = {
    "error": (("ERROR",), 0.0), "death": (("DIED",), UNNOTICED), "disconnect": (("PORT_DISCONNECT",), 0.0),
}
_OPERATORS = {
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
    "==": operator.eq,
    "!=": operator.ne,
}
_COMPARISON = re.compile(r"(\S.*?)\s*(<=|>=|==|!=|<|>)\s*(\S.*?)\s*\Z")
_SILENCE = re.compile(r"silent\s+(\S.*\S)\s+(\d+\.?\d*|\.\d+)\s*\Z")


class Condition:
    """What may happen, in `words`.

    delay         seconds by which it may have happened earlier than it is noticed
    remark        why it may never happen, None if nothing is known to prevent it
    hears_events  whether it is about what components report
    """

    delay = 0.0
    remark = None  # type: str
    hears_events = False

    def __init__(self, words):
        self.words = words
        self._happened = []

    def wrap(self, names, type, deliver):
        """`deliver`, or what takes the Messages of a channel in its place, and hands them on."""
        return deliver

    def hear(self, fields):
        """Take the fields of an event of a component."""

    def causes(self):
        """What has happened, in words, since it was asked last."""
        happened = self._happened
        self._happened = []
        return happened


class Silence(Condition):
    """No value of a channel has come for some time."""

    remark = NO_PORT

    def __init__(self, words, port, seconds):
        super().__init__(words)
        self._port = port
        self._seconds = seconds
        self._last = {}  # by names of a channel: when a value came last; None: its silence has been noticed

    def wrap(self, names, type, deliver):
        if not records.is_called(self._port, names):
            return deliver
        self.remark = None

        def take(message):
            self._last[names] = loop.now()
            deliver(message)

        return take

    def causes(self):
        now = loop.now()
        for name, last in self._last.items():
            if last is not None and now - last > self._seconds:
                self._last[name] = None
                yield self.words


class Comparison(Condition):
    """A part of the values of a channel is more, less, or what."""

    remark = NO_PORT

    def __init__(self, words, part, compare, limit):
        super().__init__(words)
        self._part = part
        self._compare = compare
        self._limit = limit
        self._was = {}

    def wrap(self, names, type, deliver):
        field = self._field(names)
        if field is None:
            return deliver
        if type is None:
            self.remark = "the data type of this port is not known"
            return deliver
        self.remark = None

        def take(message):
            deliver(message)
            self._judge(names, type, field, message)

        return take

    def _field(self, names):
        for cut in records.cuts(self._part):
            if records.is_called(self._part[:cut], names):
                return self._part[cut:].lstrip(".")
        return None

    def _judge(self, names, type, field, message):
        try:
            value = values.field(type.decode(message.data, message.little), field)
        except errors.Error as e:
            if names not in self._was:
                self._was[names] = False
                self.remark = str(e)
            return
        value = getattr(value, "_n", value)
        try:
            is_so = self._compare(value, self._limit)
        except TypeError:
            return  # a word and a number
        if is_so and not self._was.get(names):
            self._happened.append(self.words)
        self._was[names] = is_so


class Report(Condition):
    """Components report an event."""

    hears_events = True

    def __init__(self, word):
        super().__init__(word)
        self._events, self.delay = EVENTS[word]

    def hear(self, fields):
        if fields["event"] in self._events:
            self._happened.append("%s %s" % (self.words, fields["path"].rpartition("/")[2]))


def parse(words):
    """The conditions that words on the command line say. Raises Usage."""
    return [_condition(text.strip()) for text in words]


def _condition(words):
    if words in EVENTS:
        return Report(words)
    silence = _SILENCE.match(words)
    if silence:
        return Silence(words, silence.group(1), float(silence.group(2)))
    comparison = _COMPARISON.match(words)
    if comparison and ":" in comparison.group(1):
        part, word, limit = comparison.groups()
        return Comparison(words, part, _OPERATORS[word], _number(limit))
    names = ", ".join(EVENTS)
    raise errors.Usage(
        f"--trigger {printable(words)}: not {names}, silent PATH:PORT SECONDS, or PATH:PORT.FIELD OP VALUE"
    )


def _number(word):
    """A number, a boolean or a word of a comparison."""
    if word in ("true", "false"):
        return word == "true"
    try:
        return float(word)
    except ValueError:
        return word.strip("'\"")


SIGNAL = real.SIGUSR1


class Triggers:
    """The conditions of a recording, which have incidents.Incidents made of what comes, and of SIGUSR1, until
    `close`.
    """

    def __init__(self, conditions, incidents, mailbox):
        self._conditions = conditions
        self._incidents = incidents
        self._mailbox = mailbox
        self._signals = 0
        if SIGNAL is not None:
            loop.current().hear(SIGNAL, self._note_signal)

    def wrap(self, names, type, deliver):
        """A function that takes the Messages of a channel, which are judged, too; `names`: a tuple, as of
        is_called.
        """
        for condition in self._conditions:
            deliver = condition.wrap(names, type, deliver)
        return deliver

    def hear(self, fields):
        """Take the fields of an event of a component."""
        for condition in self._conditions:
            condition.hear(fields)

    def needs_events(self):
        return any(condition.hears_events for condition in self._conditions)

    async def watch(self, work):
        """Look whether something has happened, until it is cancelled. `work`: a recorder.Recorder."""
        channel = work.channels.add_json("/triggers", schemas.of_events())
        while True:
            self._report_remarks()
            for words, delay in self._causes():
                self._incidents.trigger(words, delay=delay)
                notes.note(f"trigger: {printable(words)}")
                fields = dict(path="", kind="TRIGGER", subject="", event=words, mark="trigger: " + words)
                work.put_json(channel, fields)
            await loop.sleep(LOOK)

    def close(self):
        if SIGNAL is not None:
            loop.current().hear(SIGNAL, None)
        self._mailbox.close()

    def _report_remarks(self):
        """Report why a condition may never be true."""
        for condition in self._conditions:
            if condition.remark is not None:
                notes.note(f"--trigger {printable(condition.words)}: {condition.remark}")
                condition.remark = None

    def _note_signal(self):
        self._signals += 1

    def _causes(self):
        """What has happened: (in words, seconds by which it may have happened earlier)."""
        for condition in self._conditions:
            for words in condition.causes():
                yield words, condition.delay
        if self._signals:
            self._signals = 0
            yield "SIGUSR1", 0.0
        if self._mailbox.take():
            yield "now", 0.0
