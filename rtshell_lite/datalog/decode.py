"""The entries of a log, decoded: the data types of its channels, their values, and their bytes for a port."""

import struct

from rtshell_lite import errors
from rtshell_lite.giop import descriptors
from rtshell_lite.data import build_value, datatypes, values
from rtshell_lite.datalog import gaps, schemas
from rtshell_lite.net import calendar
from rtshell_lite.text import printable, safe

# where a type's timestamp is
FIRST = "first"
INSIDE = "inside"


class Decoder:
    """Decodes the entries of a log, with the types in the file, else those of `types`, a datatypes.Types.

    `unreadable` counts the entries that were shown as bytes because they do not fit their type, or are nested
    too deep.
    """

    def __init__(self, log, types):
        self.log = log
        self._types = types
        self._known = {}
        self._stamped = {}
        self.unreadable = 0

    def type(self, number):
        """The datatypes.Type of a channel, None when it is not known.
        Raises BadIdl and the like for the user's files.
        """
        if number not in self._known:
            self._known[number] = type = self._type(self.log.channels[number])
            self._stamped[number] = type and place_of_timestamp(type.descriptor)
        return self._known[number]

    def _type(self, channel):
        if channel.typecode:
            try:
                return datatypes.from_bytes(channel.typecode)
            except errors.BadType:
                pass  # damaged: look up its name
        if channel.schema and channel.encoding == "cdr":
            try:
                return schemas.to_type(channel.schema)
            except (errors.BadType, errors.BadIdl):
                pass
        try:
            return self._types.named(channel.type_id)
        except errors.NoSuch:
            return None

    def notes(self):
        """What is wrong with the log, in words."""
        yield from notes(self.log)
        if self.log.gaps:
            yield "values are missing in it (intervals: %d); rtlog show says when" % len(self.log.gaps)
        if self.unreadable:
            yield "%d entries are not what their type says, and shown as bytes" % self.unreadable

    def value(self, entry):
        """The value of an entry; None when its type is not known.
        Raises errors.Failed when it does not fit its type.
        """
        type = self.type(entry.channel)
        if type is None:
            return None
        try:
            if entry.data is None:
                return values.build(type.descriptor, entry.value, type.name)
            return type.decode(entry.data, entry.little)
        except (errors.BadData, errors.BadValue, errors.BadType) as e:
            raise errors.Failed(self.log.where, "entry %d: %s" % (entry.number, e))

    def data(self, entry, little, moment=None):
        """The CDR of an entry in a byte order. With `moment` (ns), its timestamp moves by the time since it
        arrived.

        A timestamp of 0 stays: many components never set theirs. Raises errors.Failed when the entry does not
        fit its type, or when the type is needed and not known.
        """
        type = self.type(entry.channel)
        stamped = moment is not None and self._stamped[entry.channel]
        shift = moment - entry.received if stamped else 0
        if entry.data is not None and entry.little == little:
            if not stamped:
                return entry.data
            if stamped == FIRST:
                return _shift_stamp(entry.data, little, shift)
        value = self.value(entry)
        if value is None:
            channel = self.log.channels[entry.channel]
            raise errors.Failed(
                self.log.where,
                "%s: its type %s is not known; %s"
                % (printable(channel.name), printable(channel.type_id), datatypes.SOURCES),
            )
        stamp = values.timestamp(value)
        if stamped and any(stamp):
            value = values.with_timestamp(value, *_move_stamp(stamp, shift))
        return type.encode(value, little)

    # ---- for people and programs ----

    def form_value(self, entry, form):
        """form(value of an entry); None when its type is not known, or the entry does not fit it or is nested
        too deep.
        """
        try:
            value = self.value(entry)
            return None if value is None else form(value)
        except (errors.Failed, errors.BadValue):
            self.unreadable += 1
            return None

    def line(self, entry, limit=None):
        """An entry as a line for people, `[SEC.NSEC] DATA`, after its channel's name where there are several;
        at most `limit` elements of a sequence.
        """
        name = ""
        if len(self.log.channels) > 1:
            name = printable(self.log.channels[entry.channel].name) + ": "
        words = self.form_value(entry, lambda value: values.text(value, limit))
        if words is not None:
            return name + words
        if entry.data is None:
            return name + safe(repr(entry.value))
        return name + f"{len(entry.data)} bytes: {entry.data.hex()}"

    def record(self, entry):
        """An entry as fields for JSON."""
        channel = self.log.channels[entry.channel]
        fields = {
            "number": entry.number,
            "received": entry.received / 1e9,
            "port": channel.name,
            "type": channel.type_id,
        }
        value = self.form_value(entry, values.json)
        if value is not None:
            fields["value"] = value
        elif entry.data is None:
            fields["value"] = _tame(entry.value)
        else:
            fields.update(size=len(entry.data), little_endian=entry.little, hex=entry.data.hex())
        return fields


def place_of_timestamp(descriptor):
    """Whether values of a type have a timestamp: FIRST, INSIDE or None."""
    if descriptors.kind(descriptor) != descriptors.STRUCT:
        return None
    for index, (name, type) in enumerate(descriptors.members(descriptor)):
        if name == "tm" and build_value.is_time(type):
            return INSIDE if index else FIRST
    return None


def _shift_stamp(data, little, shift):
    """CDR that begins with a timestamp, moved; the rest, which may be an image, is not decoded."""
    order = "<II" if little else ">II"
    if len(data) < 8:
        return data
    stamp = struct.unpack_from(order, data)
    if any(stamp):
        return struct.pack(order, *_move_stamp(stamp, shift)) + data[8:]
    return data


def _move_stamp(stamp, shift):
    """(seconds, nanoseconds) moved by `shift` ns, with the carry that rtshell forgot,
    within what RTC::Time can hold.
    """
    moment = stamp[0] * 10**9 + stamp[1] + shift
    return divmod(min(max(moment, 0), (1 << 32) * 10**9 - 1), 10**9)


# ---- what is in a log ----


def notes(log):
    """What is wrong with a log, in words, and what helps."""
    yield from log.notes()
    if not log.closed and log.form == "mcap":
        yield "other readers may refuse it; rtlog mend makes a copy that they open"


def summary(log):
    """What is known of a log, as lines in rtshell's layout."""
    yield f"Name: {log.where}"
    yield f"Size: {_size(log.size)}"
    yield f"Start time: {date(log.started)}"
    yield f"First entry time: {date(log.first)}"
    yield f"End time: {date(log.last)}"
    yield "Number of entries: %d" % log.count
    if not log.closed:
        yield "State: INCOMPLETE, whole up to octet %d" % (log.size - log.torn)
    for gap in log.gaps:
        yield f"Missing: {date(gap.first)} until {date(gap.last)}: {gaps.words(gap)}"
    for attachment in log.attachments:
        yield f"Attachment: {printable(attachment[1])}, {date(attachment[0])}"
    for number, channel in enumerate(log.channels, 1):
        yield "Channel %d" % number
        yield f"  Name: {printable(channel.name)}"
        yield f"  Data type: {printable(channel.type_id)}"
        yield "  Number of entries: %d" % log.counts.get(channel.name, 0)
        yield "  Sources:"
        for source in channel.sources:
            yield f"    {printable(source)}"


def as_dict(log):
    """The same as fields; times are seconds since the epoch."""
    channels = [
        {
            "name": channel.name,
            "type": channel.type_id,
            "sources": list(channel.sources),
            "typecode": bool(channel.typecode),
            "entries": log.counts.get(channel.name, 0),
        }
        for channel in log.channels
    ]
    return {
        "file": log.where,
        "form": log.form,
        "size": log.size,
        "started": _seconds(log.started),
        "first": _seconds(log.first),
        "last": _seconds(log.last),
        "entries": log.count,
        "channels": channels,
        "attachments": [attachment[1] for attachment in log.attachments],
        "gaps": [gaps.as_dict(gap) for gap in log.gaps],
        "closed": log.closed,
        "torn": log.torn,
        "damaged": log.damaged,
    }


def _seconds(moment):
    return None if moment is None else moment / 1e9


def date(moment):
    """A time (ns since the epoch) in local time, and as it is; the file may say anything."""
    if moment is None:
        return "none"
    seconds, rest = divmod(moment, 10**9)
    try:
        local = calendar.local("%Y-%m-%d %H:%M:%S", seconds)
    except (OverflowError, ValueError, OSError):
        local = "?"
    return "%s (%d.%09d)" % (local, seconds, rest)


def _size(size):
    if size <= 1024:
        return "%dB" % size
    for unit, factor in (("KiB", 1 << 10), ("MiB", 1 << 20), ("GiB", 1 << 30)):
        if size < factor * 1024:
            break
    return "%.2f%s (%dB)" % (size / factor, unit, size)


# ---- values of unknown types ----


def _tame(value):
    """A value of an unknown type, made of dicts and lists, for JSON."""
    if isinstance(value, dict):
        return {name: _tame(part) for name, part in value.items()}
    if isinstance(value, list):
        return [_tame(part) for part in value]
    return values.json(value)
