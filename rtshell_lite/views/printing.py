"""What rtprint shows of the values that come from ports: lines, JSON, bytes, or figures on their flow.

Values are formatted and written on a thread, a batch at a time: however long that takes, components get their
answers.
"""

import importlib
import math
import os
import sys

from rtshell_lite import errors, start, text
from rtshell_lite.data import clocks, statistics, values
from rtshell_lite.net import loop

TICK = 0.2  # seconds between two looks at anything but values: dead ports, the end of the time
SHOW = 1.0  # seconds between two lines of figures
PORTION = 1 << 16  # characters that are written at once
LONG = 8  # elements of a sequence that are shown on a terminal
# what a formatter may raise
USER_ERRORS = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError)


# ---- channels ----


class Channel:
    """One port that is read, and how its values are shown; `type` is None when they are shown as bytes."""

    def __init__(self, target, type, formatter=None, field=None):
        self.label = target.label
        self.type = type
        self.formatter = formatter
        self.field = field
        self.path = str(target.port.node.path.with_port(target.port.name.rpartition(".")[2]))
        self.type_id = target.port.properties.get("dataport.data_type", "")
        self.stamped = type is not None and clocks.is_stamped(target.port)
        self.flow = statistics.Flow()
        self.shown = self.failed = False  # whether any of its values could be shown, or could not

    def value(self, message):
        """The Python value of a Message, or its member `field`. Raises errors.Error."""
        try:
            value = self.type.decode(message.data, message.little)
        except errors.BadData as e:
            raise errors.BadData(self.path, "%s: %s" % e.args)
        return values.field(value, self.field) if self.field else value

    def line(self, message):
        """A Message as a line for people; its bytes are several lines."""
        if self.type is None:
            limit = 4 * LONG if sys.stdout.isatty() else None
            return "\n".join(text.safe(line) for line in values.raw(message.data, message.little, limit))
        value = self.value(message)
        if self.formatter is None:
            return values.text(value, LONG if sys.stdout.isatty() else None)
        try:
            return str(self.formatter(value))
        except USER_ERRORS as e:
            raise errors.Failed(self.label, f"the formatter fails ({type(e).__name__}: {e})")

    def record(self, message):
        """A Message as a dict for JSON."""
        fields = {"path": self.path, "received": message.received / 1e9, "type": self.type_id}
        if self.type is None:
            return dict(fields, size=len(message.data), little_endian=message.little, hex=message.data.hex())
        return dict(fields, value=values.json(self.value(message)))

    def count(self, message):
        """Count a Message for the figures."""
        self.flow.add(message.received, message.data, self.stamp(message))

    def stamp(self, message):
        """The time in a Message's value, in ns since 1970, or None."""
        if self.stamped:  # big values need not be decoded for that
            return clocks.moment(message.data, message.little)
        stamp = values.timestamp(self.type.decode(message.data, message.little)) if self.type else None
        return stamp and stamp[0] * 10**9 + stamp[1]


def formatter(name, directories=()):
    """The function called `module.function`, which formats a value; `directories` are searched first. Raises
    NoSuch, Failed.

    `rtshell.rawpy`, as with rtshell, is repr.
    """
    if name == "rtshell.rawpy":
        return repr
    module, _, attribute = name.rpartition(".")
    start.find_installed()
    before = list(sys.path)
    sys.path[:0] = [os.path.abspath(directory) for directory in directories]
    try:
        function = getattr(importlib.import_module(module), attribute, None) if module else None
    except (ImportError, SyntaxError) as e:
        raise errors.Failed("#" + name, f"cannot import {module} ({e})")
    finally:
        sys.path[:] = before
    if not callable(function):
        raise errors.NoSuch("#" + name, "formatter", "module.function is wanted, with one argument")
    return function


# ---- as they come ----


async def batches(box, opened, seconds=math.inf, rate=None):
    """Yield lists of (key, Message) from an Inbox, as they come; until `seconds` are over or no connection of
    `opened` is left.

    With a rate, that many times a second, and only the newest of each key. At least every TICK a list, maybe
    empty, is yielded.
    """
    end = loop.now() + seconds
    is_last = False
    while not is_last:
        left = end - loop.now()
        is_last = left <= 0 or not opened.live()
        if is_last:
            left = 0
        if rate:
            await loop.sleep(min(left, 1 / rate))
            yield sorted(dict(await box.get(0)).items())
        else:
            yield await box.get(min(left, TICK))


def portions(lines):
    """Lines joined to strings of about PORTION: many small writes cost time, a large one memory."""
    pending = []
    size = 0
    for line in lines:
        pending.append(line)
        size += len(line)
        if size >= PORTION:
            yield "".join(pending)
            pending = []
            size = 0
    yield "".join(pending)


# ---- figures ----


class Board:
    """Figures for each Channel, written by write(text):
    in place on a terminal, else a line each time, or JSON; totals at the end.
    """

    def __init__(self, channels, box, json, write):
        self.channels = channels
        self.box = box
        self.json = json
        self.write = write
        self.dropped = [0] * len(channels)
        self.in_place = not json and sys.stdout.isatty()
        self.lines = 0
        self.begun = self.shown = self.ended = loop.now()

    def add(self, batch):
        """Count (key, Message) pairs, and show the figures since the last time, when it is time."""
        for key, message in batch:
            self.channels[key].count(message)
        if not self.is_due():
            return
        now = loop.now()
        figures = []
        for key, channel in enumerate(self.channels):
            dropped, self.dropped[key] = self.box.dropped[key] - self.dropped[key], self.box.dropped[key]
            figures.append(channel.flow.take_recent().summary(now - self.shown, dropped))
        self.shown = now
        self._write(figures, "")

    def is_due(self):
        """Whether it is time to show figures."""
        return loop.now() - self.shown >= SHOW

    def end(self):
        """Show the figures from the beginning until `ended`."""
        seconds = self.ended - self.begun
        figures = [
            channel.flow.total.summary(seconds, self.box.dropped[key])
            for key, channel in enumerate(self.channels)
        ]
        self._write(figures, "all in all: ")

    def _write(self, figures, prefix):
        if self.json:
            lines = [
                text.json_line(dict(of_port, path=channel.path, total=bool(prefix)))
                for channel, of_port in zip(self.channels, figures)
            ]
        else:
            lines = [
                prefix + (channel.label + ": " if len(figures) > 1 else "") + text.safe(figure_line(of_port))
                for channel, of_port in zip(self.channels, figures)
            ]
        home = ""
        if self.in_place:
            width = text.width() - 1
            if self.lines:
                home = "\x1b[%dA" % self.lines
            lines = ["\x1b[2K" + line[:width] for line in lines]
            self.lines = len(lines)
        self.write(home + "".join(line + "\n" for line in lines))


def figure_line(figures):
    """One port's figures in words; what is not known is left out."""
    if not figures["values"]:
        return "no values"
    words = [f"{figures['values']} values"]
    if figures["rate"] is not None:
        words += [
            f"{figures['rate']:.1f} Hz",
            "gap %s/%s/%s ms" % tuple(_ms(figures[k]) for k in ("gap_min", "gap_mean", "gap_max")),
            f"jitter {_ms(figures['jitter'])} ms",
        ]
    if figures["bytes_per_second"] is not None:
        words.append(_bytes(figures["bytes_per_second"]) + "/s")
    if figures["age_mean"] is not None:
        words.append(f"age {_ms(figures['age_mean'])} ms")
    if figures["absent"]:
        words.append(f"{figures['absent']} cycle{'' if figures['absent'] == 1 else 's'} did not come")
    words += [f"{what} {figures[what]}" for what in ("disordered", "repeated", "dropped") if figures[what]]
    return ", ".join(words)


def _ms(seconds):
    return f"{seconds * 1000:.3g}" if abs(seconds) < 1 else f"{seconds * 1000:.0f}"


def _bytes(number):
    for unit in ("B", "kB", "MB"):
        if number < 1000:
            return f"{number:.3g} {unit}"
        number /= 1000.0
    return f"{number:.3g} GB"
