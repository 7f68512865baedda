"""Writing what out ports send: its channels, and the thread that writes.

What arrives in an inbox.Inbox is written on a thread, so that no sender waits for a disk.
"""

import collections
import json
import os

from rtshell_lite import errors, notes
from rtshell_lite.data import datatypes, inbox, reading
from rtshell_lite.datalog import decode, gaps, mcap
from rtshell_lite.datalog.records import Channel
from rtshell_lite.net import loop
from rtshell_lite.robot import ports
from rtshell_lite.text import printable

VALUES = 200000  # that may wait to be written
# of them: this share of the memory, within bounds
OCTETS = 32 << 20, 256 << 20
SHARE = 16
GATHER = 0.1  # seconds for which values are gathered: what a kill -9 costs
BUSY = 0.01  # seconds between two portions of other work
TICK = 0.1  # seconds between two looks whether recording is over
TIMESTAMP = 8  # octets
SYNC = 1.0  # seconds between two fsyncs: what a power failure costs


class Channels:
    """The channels of a new log; ports with the same NAME share one.

    `found` are the records.Channels, `types` their datatypes.Type; None for what is recorded as bytes.
    """

    def __init__(self, all_types):
        """`all_types` are datatypes.Types."""
        self._all_types = all_types
        self.found = []
        self.types = []

    async def add(self, port, name, about=()):
        """The number of a Port's channel; `about`: what else is to be said of it, (name, text) pairs.
        Raises errors.Failed when a channel of that NAME has another type.
        """
        where = ports.label(port)
        type_id = port.properties.get("dataport.data_type", "")
        for number, channel in enumerate(self.found):
            if channel.name == name:
                _add_source(channel, where, type_id)
                return number
        type = await self._type(port, where, type_id)
        if type is None:
            return self._append(Channel(name, type_id, b"", [where], "cdr", None, about), None)
        return self._append(Channel(name, type.id, type.to_bytes(), [where], "cdr", None, about), type)

    async def add_by_path(self, port, about):
        """The number of the channel of a Port that is called by its path; by its type, too, where that has
        changed.
        """
        label = ports.label(port)
        try:
            return await self.add(port, label, about)
        except errors.Failed:
            type_id = port.properties.get("dataport.data_type", "")
            return await self.add(port, f"{label} ({type_id})", about)

    def add_json(self, name, schema):
        """The number of a channel of JSON; `schema` is its (name, encoding, data)."""
        return self._append(Channel(name, schema[0], b"", [], "json", schema, ()), None)

    async def _type(self, port, where, type_id):
        try:
            return await self._all_types.of_port(port)
        except errors.NoSuch:
            why = f"{printable(type_id)} is not known; {datatypes.SOURCES}"
        except errors.BadType as e:
            why = str(e)
        notes.note(f"{where}: recorded as bytes: {why}")
        return None

    def _append(self, channel, type):
        self.found.append(channel)
        self.types.append(type)
        return len(self.found) - 1


def _add_source(channel, where, type_id):
    """Let another port share a channel. Raises errors.Failed when its type differs."""
    if not ports.same_type(channel.type_id, type_id):
        words = tuple(map(printable, (channel.name, channel.type_id, type_id)))
        raise errors.Failed(where, "%s has another data type (%s, %s)" % words)
    if where not in channel.sources:
        channel.sources.append(where)


def _octets():
    """How many octets may wait to be written: a disk may stop for a while when much is written to it, and a
    busy machine runs the thread that writes late. (At 300 MB a second 32 MiB are full in 0.1 s.)
    """
    least, most = OCTETS
    try:
        memory = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    except (ValueError, OSError, AttributeError):  # this system does not say
        return least
    return min(max(least, memory // SHARE), most)


class Recorder:
    """Writes the Messages that arrive in its `box`, whose keys are numbers of channels, with a `writer` (of
    writer or textlog).

    The Bell `done` rings when `most` messages are written or writing has failed. `count` and `octets` say how
    many were written, `repeated` how many of these came twice in a row, with the same timestamp: OpenRTM-aist
    2.1 repeats a `put` whose answer was lost; `failure` (OSError, errors.Failed or None) why writing failed.
    """

    def __init__(self, channels, most=None, incidents=None):
        """`channels`: Channels, which may grow until a message of theirs comes; `incidents`: the
        incidents.Incidents to be made of what is written, or None.
        """
        self.box = inbox.Inbox(VALUES, _octets(), GATHER, mcap.CHUNK_SIZE)
        self.channels = channels
        self._losses = gaps.Losses()
        self.box.lose = self._losses.add
        self._gaps = []  # gaps.Gaps that wait to be written
        self.gaps = 0  # how many there were, besides those of what was dropped
        self.hear_gap = None  # function(gaps.Gap), or None
        self._added = 0  # how many of them the writer has
        self._most = most
        self._incidents = incidents
        self._attachments = []  # that wait to be written: (moment, name, media type, data)
        self.count = self.octets = self.repeated = 0
        self._last = {}  # by channel: the data of the last value
        self.writer = self.failure = None
        self.done = loop.Bell()
        self._sync_at = loop.now() + SYNC

    async def begin(self, file, begun):
        """Make the writer of a File, recorded since `begun` (ns since the epoch). Raises as File.writer
        does.
        """
        self._added = len(self.channels.found)
        self.writer = await loop.on_thread(file.writer, self.channels, begun)

    async def run(self):
        """Write what comes."""
        while self.count != self._most and self.failure is None:
            batch = await self.box.get(BUSY if self._is_busy() else TICK)
            taken = loop.wall() * 1e9  # the box has nothing that came before
            self._take_losses(taken, self._is_busy())
            if batch or self._incidents or loop.now() >= self._sync_at:
                await loop.finish(self._write(batch, taken))
        self.done.ring()

    def _is_busy(self):
        """Whether something else is to be written than messages."""
        return self._incidents is not None and self._incidents.is_busy()

    async def close(self):
        """Write what is left, and flush it to the disk. Raises OSError, errors.Failed: why writing failed."""
        if self.writer is None:
            return
        if self.failure is None:
            batch = await self.box.get(0)
            self._take_losses(loop.wall() * 1e9, True)
            await self._write(batch, loop.wall() * 1e9)
            if self._incidents is not None:
                await self._try(self._incidents.finish, self.writer)
        await self._try(self.writer.close)
        if self.failure is not None:
            raise self.failure

    async def _write(self, batch, taken):
        """Write what was in the box until `taken` (ns since the epoch)."""
        if self._most is not None:
            batch = batch[: self._most - self.count]
        await self._try(self._append, batch, taken)

    async def _try(self, function, *args):
        """Run what uses the disk on a thread."""
        try:
            await loop.on_thread(function, *args)
        except (OSError, errors.Failed) as e:
            self.failure = self.failure or e

    def attach(self, moment, name, media_type, data):
        """Put a file into the log, with the next messages."""
        self._attachments.append((moment, name, media_type, data))

    def put_gap(self, channel, first, last, count, why):
        """Record that `count` values (None: unknown) of a channel are missing, from `first` to `last` (ns
        since the epoch), and `why`.
        """
        self.gaps += 1
        self._add_gap(gaps.Gap(first, last, {self.channels.found[channel].name: count}, why))

    def _add_gap(self, gap):
        self._gaps.append(gap)
        if self.hear_gap is not None:
            self.hear_gap(gap)

    def _take_losses(self, now, is_end):
        """Have the gap written that what was dropped has made."""
        lost = self._losses.take(now, is_end)
        if lost is None:
            return
        counts = collections.Counter()
        for channel, count in lost[2].items():
            counts[self.channels.found[channel].name] += count
        self._add_gap(gaps.Gap(lost[0], lost[1], dict(counts), gaps.DROPPED))

    def put_json(self, channel, fields):
        """Put a message of JSON, which comes now, into a channel."""
        data = json.dumps(fields, sort_keys=True).encode("ascii")
        self.box.put(channel, reading.Message(int(loop.wall() * 1e9), data, True))

    def _append(self, batch, taken):
        for channel in self.channels.found[self._added :]:
            self.writer.add(channel)
            self._added += 1
        while self._attachments:
            self.writer.attach(*self._attachments.pop(0))
        while self._gaps:
            self.writer.put_gap(self._gaps.pop(0))
        if self._incidents is not None:
            self._incidents.protect(self.writer)
        self.writer.write(
            [(channel, message.received, message.little, message.data) for channel, message in batch]
        )
        self._count(batch)
        if self._incidents is not None:
            self._incidents.step(self.writer, taken)
        if loop.now() >= self._sync_at:
            self.writer.sync()
            self._sync_at = loop.now() + SYNC

    def _count(self, batch):
        """Count what was written, and what is the last value of its channel again. Those without a timestamp
        may be alike.
        """
        self.count += len(batch)
        last = self._last
        for channel, message in batch:
            data = message.data
            self.octets += len(data)
            if last.get(channel) == data and any(data[:TIMESTAMP]) and self._is_stamped(channel):
                self.repeated += 1
            last[channel] = data

    def _is_stamped(self, channel):
        type = self.channels.types[channel]
        return type is not None and decode.place_of_timestamp(type.descriptor) == decode.FIRST
