"""What rtprint shows of the values that come from ports: lines, JSON, bytes, or figures on their flow."""
import importlib
import math
import os
import struct
import sys
import time

from rtshell_lite import errors, text
from rtshell_lite.data import datatypes, statistics, values

TICK = 0.2  # seconds between two looks at anything but values: dead ports, the end of the time
PORTION = 1 << 16  # characters that are written at once
LONG = 8  # elements of a sequence that are shown on a terminal
USER_ERRORS = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError)  # what a formatter may raise


# ---- channels -------------------------------------------------------------------------------------------------

class Channel:
    """One port that is read, and how its values are shown; `type` is None when they are shown as bytes."""

    def __init__(self, target, type, formatter=None, field=None):
        self.label, self.type, self.formatter, self.field = target.label, type, formatter, field
        self.path = str(target.port.node.path.with_port(target.port.name.rpartition(".")[2]))
        self.type_id = target.port.properties.get("dataport.data_type", "")
        members = datatypes.members(self.type_id) if type else None
        self.stamped = bool(members) and members[0] == ("tm", "Time")
        self.flow = statistics.Flow()
        self.shown = self.failed = False  # whether any of its values could be shown, and whether any could not

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
            if len(message.data) < 8:
                return None
            sec, nsec = struct.unpack_from("<LL" if message.little else ">LL", message.data)
            return sec * 10**9 + nsec
        stamp = values.timestamp(self.type.decode(message.data, message.little)) if self.type else None
        return stamp and stamp[0] * 10**9 + stamp[1]


def formatter(name, directories=()):
    """The function called `module.function`, which formats a value; `directories` are searched first. Raises NoSuch, Failed.

    `rtshell.rawpy`, as with rtshell, is repr.
    """
    if name == "rtshell.rawpy":
        return repr
    module, _, attribute = name.rpartition(".")
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


# ---- as they come ---------------------------------------------------------------------------------------------

def batches(box, opened, look, seconds=math.inf, rate=None):
    """Yield lists of (key, Message) from an Inbox, as they come; until `seconds` are over or no connection of `opened` is left.

    With a rate, so many times a second, and only the newest of each key. At least every TICK a list, maybe empty, is yielded and
    look() is called.
    """
    end, looked = time.monotonic() + seconds, 0.0
    while True:
        now = time.monotonic()
        if now - looked >= TICK:
            look()
            looked = now
        last = now >= end or not opened.live()
        left = 0 if last else min(end - now, 1 / rate if rate else TICK)
        if rate:
            time.sleep(left)
        batch = box.get(0 if rate else left)
        yield sorted(dict(batch).items()) if rate else batch
        if last:
            return


def portions(lines):
    """Lines joined to strings of about PORTION: many small writes cost time, a large one memory."""
    pending, size = [], 0
    for line in lines:
        pending.append(line)
        size += len(line)
        if size >= PORTION:
            yield "".join(pending)
            pending, size = [], 0
    yield "".join(pending)


# ---- figures --------------------------------------------------------------------------------------------------

class Board:
    """Figures for each Channel: in place on a terminal, else a line each time, or JSON; and totals at the end."""

    def __init__(self, channels, box, json):
        self.channels, self.box, self.json = channels, box, json
        self.dropped = [0] * len(channels)
        self.in_place = not json and sys.stdout.isatty()
        self.lines = 0

    def show(self, seconds):
        """The figures since the last time, which was `seconds` ago."""
        figures = []
        for key, channel in enumerate(self.channels):
            dropped, self.dropped[key] = self.box.dropped[key] - self.dropped[key], self.box.dropped[key]
            figures.append(channel.flow.look().summary(seconds, dropped))
        self._write(figures, "")

    def end(self, seconds):
        """The figures since the beginning."""
        self._write([channel.flow.total.summary(seconds, self.box.dropped[key]) for key, channel in enumerate(self.channels)],
                    "all in all: ")

    def _write(self, figures, prefix):
        if self.json:
            lines = [text.json_line(dict(of_port, path=channel.path, total=bool(prefix)))
                     for channel, of_port in zip(self.channels, figures)]
        else:
            lines = [prefix + (channel.label + ": " if len(figures) > 1 else "") + text.safe(figure_line(of_port))
                     for channel, of_port in zip(self.channels, figures)]
        if self.in_place:
            width = text.width() - 1
            sys.stdout.write("\x1b[%dA" % self.lines if self.lines else "")
            lines = ["\x1b[2K" + line[:width] for line in lines]
            self.lines = len(lines)
        sys.stdout.write("".join(line + "\n" for line in lines))
        sys.stdout.flush()


def figure_line(figures):
    """One port's figures in words; what is not known is left out."""
    if not figures["values"]:
        return "no values"
    words = [f"{figures['values']} values"]
    if figures["rate"] is not None:
        words += [f"{figures['rate']:.1f} Hz", "gap %s/%s/%s ms" % tuple(_ms(figures[k]) for k in ("gap_min", "gap_mean", "gap_max")),
                  f"jitter {_ms(figures['jitter'])} ms"]
    if figures["bytes_per_second"] is not None:
        words.append(_bytes(figures["bytes_per_second"]) + "/s")
    if figures["age_mean"] is not None:
        words.append(f"age {_ms(figures['age_mean'])} ms")
    if figures["absent"]:
        words.append(f"{figures['absent']} cycle{'' if figures['absent'] == 1 else 's'} did not come")
    for what in ("disordered", "repeated", "dropped"):
        if figures[what]:
            words.append(f"{what} {figures[what]}")
    return ", ".join(words)


def _ms(seconds):
    return f"{seconds * 1000:.3g}" if abs(seconds) < 1 else f"{seconds * 1000:.0f}"


def _bytes(number):
    for unit in ("B", "kB", "MB"):
        if number < 1000:
            return f"{number:.3g} {unit}"
        number /= 1000.0
    return f"{number:.3g} GB"
