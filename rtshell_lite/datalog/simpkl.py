"""Reading the log files that rtshell's rtlog wrote ("simple pickle").

Such a file is a sequence of pickles: (when recording began, list of PortSpec); 256 octets for a CurPos, which
is written when recording ends; then the entries: (number, EntryTS, (port's name, data), own offset, offset of
the one before).
"""

import collections

from rtshell_lite import errors, text
from rtshell_lite.datalog import pickles
from rtshell_lite.datalog.records import Channel, Entry, is_moment

CLOSING = 256  # octets kept free for the CurPos
PART = 1000  # entries between two counts for `work`
DEEP = 100  # levels of a value
_RTSHELL = {("rtshell.port_types", "PortSpec"), ("rtshell.simpkl_log", "CurPos"), ("rtshell.ilog", "EntryTS")}
_STANDARD = {"RTC", "Img"}  # modules of the standard data types
_HOMES = {"RTC", "Img", "rtctree", "OpenRTM_aist"}  # the packages that have them: rtctree.rtc.RTC, say


class PickledLog:
    """An open log, to be used in a `with` statement like reader.Log.

    Its entries have a `value` instead of data: structs as dicts, enumerators by name, octets of Python 2 as
    text.
    """

    form = "simpkl"
    attachments = ()
    gaps = ()

    def __init__(self, file, where, size, modules=()):
        """Read the header; `modules` are names of Python modules whose classes may appear.
        Raises errors.Failed.
        """
        self.where = where
        self.size = size
        self.work = None  # the notes.Work that counts the octets that have been read
        self._file = file
        self._modules = frozenset(modules)
        self.torn = 0
        self.damaged = 0
        self.trouble = None
        self._known_extent = None
        machine = self._machine(0)
        try:
            started, specs = machine.load()
            self.started = _moment(started, started % 1 * 1e9)
            self.channels = [_channel(spec.fields) for spec in specs]
        except pickles.Refused as e:
            raise errors.Failed(where, f"its header cannot be read: {e}")
        except (EOFError, TypeError, ValueError, KeyError, AttributeError, OverflowError):
            raise errors.Failed(where, "its header is not that of a log")
        self._start = machine.position + CLOSING
        self._numbers = {channel.name: number for number, channel in enumerate(self.channels)}
        file.seek(machine.position)
        self.closed = bool(file.read(CLOSING).strip(b" \0"))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._file.close()

    count = property(lambda self: self._extent()[0])
    first = property(lambda self: self._extent()[1])
    last = property(lambda self: self._extent()[2])
    counts = property(lambda self: self._extent()[3])

    def _extent(self):
        """(number of entries, arrival of the first and the last, numbers by channel),
        found by reading the whole file.
        """
        if self._known_extent is None:
            first = last = None
            counts = collections.Counter()
            for entry in self.entries():
                if first is None:
                    first = entry.received
                last = entry.received
                counts[self.channels[entry.channel].name] += 1
            self._known_extent = sum(counts.values()), first, last, dict(counts)
        return self._known_extent

    def entries(self, start=0):
        """The entries from number `start` on, one by one, up to the first damage; see `notes`."""
        machine = self._machine(self._start)
        number = 0
        while machine.position < self.size:
            offset = machine.position
            try:
                entry = self._entry(number, machine.load(), machine.position - offset)
            except (pickles.Refused, TypeError, ValueError, KeyError, AttributeError, OverflowError) as e:
                self.torn = self.size - offset
                self.trouble = str(e) if isinstance(e, pickles.Refused) else "no entry of a log"
                return
            if number >= start:
                yield entry
            number += 1
            if self.work is not None and number % PART == 0:
                self.work.reach(machine.position)

    def since(self, moment):
        """The number of the first entry that arrived at `moment` (ns) or later, or None."""
        return next((entry.number for entry in self.entries() if entry.received >= moment), None)

    def notes(self):
        """What is wrong with the file, in words."""
        if self.torn:
            yield "the last %d octets cannot be read and are left out: %s" % (self.torn, self.trouble)
        elif not self.closed:
            yield "recording has not ended regularly, or goes on"

    def _machine(self, position):
        machine = pickles.PickleMachine(self._file, self.size, self._may_appear)
        machine.position = position
        return machine

    def _may_appear(self, module, name):
        if (module, name) in _RTSHELL or (module, name) == ("omniORB", "EnumItem"):
            return True
        parts = module.split(".")
        # stubs may be in a package
        if any(".".join(parts[start:]) in self._modules for start in range(len(parts))):
            return True
        return parts[0] in _HOMES and parts[-1] in _STANDARD

    def _entry(self, number, loaded, length):
        _, stamp, (name, data), _, _ = loaded
        name = _text(name)
        fields = stamp.fields
        if name not in self._numbers:
            raise ValueError("of no port in the header")
        received = _moment(fields["_sec"], fields["_nsec"])
        # A value may refer to its parts many times, and these to theirs: its size is bounded by what was
        # read.
        return Entry(
            number, received, self._numbers[name], None, None, _Plain(1000 + 16 * length).value(data, DEEP)
        )


def _channel(fields):
    sources = [_text(source) for source in fields.get("_raw_specs") or ()]
    return Channel(_text(fields["_name"]), _text(fields["_type_name"]), b"", tuple(sources), "cdr", None, ())


def _moment(seconds, nanoseconds):
    """A time in ns since the epoch. Raises ValueError, OverflowError, TypeError for anything else."""
    if isinstance(seconds, str) or isinstance(nanoseconds, str):  # int() would read them, however long
        raise TypeError("no number")
    moment = int(seconds) * 10**9 + int(nanoseconds)
    if not is_moment(moment):
        raise ValueError("no time")
    return moment


def _text(value):
    if not isinstance(value, str):
        raise ValueError("no text")
    return text.from_wire(value)


class _Plain:
    """Turns records into dicts, within a limit of values and characters."""

    def __init__(self, most):
        self.left = most

    def value(self, data, depth):
        self.left -= 1
        if self.left < 0 or depth == 0:
            raise pickles.Refused("a value that never ends")
        if isinstance(data, pickles.Record):
            if str(data.type) == "omniORB.EnumItem":
                return _text(data.fields["_n"])
            data = data.fields
        if isinstance(data, dict):
            return {name: self.value(part, depth - 1) for name, part in data.items()}
        if isinstance(data, (list, tuple)):
            self.left -= len(data)
            if not any(isinstance(part, (pickles.Record, dict, list, tuple)) for part in data[:1]):
                return list(map(self._leaf, data))
            return [self.value(part, depth - 1) for part in data]
        return self._leaf(data)

    def _leaf(self, data):
        if isinstance(data, (str, bytes)):
            self.left -= len(data)
            if self.left < 0:
                raise pickles.Refused("a value that never ends")
            return text.from_wire(data) if isinstance(data, str) else data
        if data is None or isinstance(data, (bool, int, float)):
            return data
        raise pickles.Refused("a value that no message has")
