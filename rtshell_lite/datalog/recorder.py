"""Recording from ports into a file: connections, limits, reports.

What arrives in an inbox.Inbox is written on a thread, so that no sender waits for a disk.
"""

import math
import time

from rtshell_lite import errors, notes
from rtshell_lite.data import connection, datatypes, inbox, port_arguments, reading
from rtshell_lite.data.watcher import Watcher
from rtshell_lite.datalog import decode, lateness, mcap
from rtshell_lite.datalog.records import Channel
from rtshell_lite.net import loop
from rtshell_lite.robot import ports
from rtshell_lite.text import printable

VALUES = 200000  # that may wait to be written
OCTETS = 32 << 20  # of them
GATHER = 0.1  # seconds for which values are gathered: what a kill -9 costs
BUSY = 0.01  # seconds between two portions of other work
TICK = 0.1  # seconds between two looks whether recording is over
TIMESTAMP = 8  # octets
SYNC = 1.0  # seconds between two fsyncs: what a power failure costs


class Channels:
    """The channels of a new log; ports with the same NAME share one.

    `found` are the records.Channels, `types` their datatypes.Type or None; `notes` say why None.
    """

    def __init__(self, known):
        """`known` are datatypes.Types."""
        self._known = known
        self.found = []
        self.types = []
        self.notes = []

    async def add(self, port, name, about=()):
        """The number of a Port's channel; `about`: what else is to be said of it, (name, text) pairs.
        Raises errors.Failed when a channel of that NAME has another type.
        """
        where = ports.label(port)
        type_id = port.properties.get("dataport.data_type", "")
        for number, channel in enumerate(self.found):
            if channel.name == name:
                if not ports.same_type(channel.type_id, type_id):
                    raise errors.Failed(
                        where,
                        "%s has another data type (%s, %s)"
                        % (printable(name), printable(channel.type_id), printable(type_id)),
                    )
                if where not in channel.sources:
                    channel.sources.append(where)
                return number
        try:
            type = await self._known.of_port(port)
        except errors.NoSuch:
            type = None
            self.notes.append(
                f"{where}: recorded as bytes: {printable(type_id)} is not known; {datatypes.SOURCES}"
            )
        except errors.BadType as e:
            type = None
            self.notes.append(f"{where}: recorded as bytes: {e}")
        self._append(name, type, type_id, where, about)
        return len(self.found) - 1

    def add_json(self, name, schema):
        """The number of a channel of JSON; `schema` is its (name, encoding, data)."""
        self.types.append(None)
        self.found.append(Channel(name, schema[0], b"", [], "json", schema, ()))
        return len(self.found) - 1

    def _append(self, name, type, type_id, where, about):
        self.types.append(type)
        if type:
            self.found.append(Channel(name, type.id, type.to_bytes(), [where], "cdr", None, about))
        else:
            self.found.append(Channel(name, type_id, b"", [where], "cdr", None, about))


class Recorder:
    """Writes the Messages that arrive in its `box`, whose keys are numbers of channels, with a `writer` (of
    writer or textlog).

    The Bell `done` rings when `most` messages are written or writing has failed. `count` and `octets` say how
    many were written, `repeated` how many of these came twice in a row, with the same timestamp: OpenRTM-aist
    2.1 repeats a `put` whose answer was lost; `failure` (OSError or None) why writing failed.
    """

    def __init__(self, most=None, types=(), channels=()):
        """`types`: the datatypes.Type of each channel or None; `channels`: the records.Channels. Both lists
        may grow until a message of theirs comes.
        """
        self.box = inbox.Inbox(VALUES, OCTETS, GATHER, mcap.CHUNK_SIZE)
        self._most = most
        self._types = types
        self._channels = channels
        self.incidents = None  # ring.Incidents, to be made of what is written
        self._added = 0  # how many of them the writer has
        self._attachments = []  # that wait to be written: (moment, name, media type, data)
        self.count = self.octets = self.repeated = 0
        self._last = {}  # by channel: the data of the last value
        self.writer = self.failure = None
        self.done = loop.Bell()
        self._sync_at = time.monotonic() + SYNC

    async def begin(self, file, channels, begun):
        """Make the writer: that of a File for Channels, recorded since `begun` (ns since the epoch).
        Raises as File.writer does.
        """
        self._added = len(self._channels)
        self.writer = await loop.on_thread(file.writer, channels, begun)

    async def run(self):
        """Write what comes."""
        while self.count != self._most and self.failure is None:
            batch = await self.box.get(self._patience())
            taken = time.time() * 1e9  # the box has nothing that came before
            if batch or self.incidents or time.monotonic() >= self._sync_at:
                await loop.finish(self._write(batch, taken))
        self.done.ring()

    def _patience(self):
        """Seconds to wait for messages: few while something else is to be written."""
        if self.incidents is not None and self.incidents.is_busy():
            return BUSY
        return TICK

    async def close(self):
        """Write what is left, and flush it to the disk. Raises OSError, the reason why writing failed."""
        if self.writer is None:
            return
        if self.failure is None:
            await self._write(await self.box.get(0), time.time() * 1e9)
            if self.incidents is not None:
                await self._try(self.incidents.finish, self.writer, self._channels)
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
        except OSError as e:
            self.failure = self.failure or e

    def attach(self, moment, name, media_type, data):
        """Put a file into the log, with the next messages."""
        self._attachments.append((moment, name, media_type, data))

    def _append(self, batch, taken):
        for channel in self._channels[self._added :]:
            self.writer.add(channel)
            self._added += 1
        while self._attachments:
            attachment = self._attachments.pop(0)
            self.writer.attach(*attachment)
            if self.incidents is not None:
                self.incidents.attached[attachment[2]] = attachment
        if self.incidents is not None:
            self.incidents.protect(self.writer)
        self.writer.write(
            [(channel, message.received, message.little, message.data) for channel, message in batch]
        )
        self._count(batch)
        if self.incidents is not None:
            self.incidents.step(self.writer, self._channels, taken)
        if time.monotonic() >= self._sync_at:
            self.writer.sync()
            self._sync_at = time.monotonic() + SYNC

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
        type = None
        if channel < len(self._types):
            type = self._types[channel]
        return type is not None and decode.place_of_timestamp(type.descriptor) == decode.FIRST


# ---- a recording from beginning to end ---------------------------------------------------------------------


class Limits:
    """When recording ends: after `entries`, at `until` (seconds since the epoch), after `seconds`;
    None is never.
    """

    def __init__(self, end, by_index, seconds):
        """`end` is a number of entries (`by_index`) or seconds since the epoch; None and -1 are never."""
        if end == -1:
            end = None
        if by_index and end is not None:
            self.entries = int(end)
        else:
            self.entries = None
        if by_index:
            self.until = None
        else:
            self.until = end
        self.seconds = seconds

    def words(self):
        """The line that reports the limits, None without any."""
        if self.seconds < math.inf:
            return f"Recording for {self.seconds}s."
        if self.entries is not None:
            return f"Recording {self.entries} entries."
        return self.until and f"Recording until {decode.date(int(self.until * 1e9))}."

    def left(self):
        """Seconds that are left; infinite without a limit in time."""
        return min(self.seconds, math.inf if self.until is None else self.until - time.time())


class File:
    """The file to record to: `name`, None for one made from the time; `form`: mcap, simpkl or text;
    whether to append. `limits`: ring.Limits of several files, or None; `is_in_memory`: they are not written.
    """

    def __init__(self, name, form, append, limits=None, is_in_memory=False):
        self.name = name
        self.limits = limits
        self.is_in_memory = is_in_memory
        self.form = form
        self.append = append

    def writer(self, channels, begun):
        """The Writer for these Channels, recorded since `begun` (ns since the epoch).
        Raises OSError, errors.Failed.
        """
        name = self.name
        if name is None:
            name = default_name()
            notes.note(f"recording to {name}")
        if self.form == "text":
            from rtshell_lite.datalog import textlog

            return textlog.Writer(name, channels.found, channels.types, self.append)
        if self.form == "simpkl":
            notes.note("simpkl files are only read; recording as MCAP")
        if self.is_in_memory:
            from rtshell_lite.datalog import ring

            return ring.Memory(channels.found, self.limits.span, self.limits.size)
        if self.limits is not None:
            from rtshell_lite.datalog import ring

            return ring.Parts(name, channels.found, begun, self.limits, self.append)
        from rtshell_lite.datalog import writer

        return writer.Writer(name, channels.found, begun, self.append)


def default_name():
    """The name of a log whose user has given none."""
    return "rtlog_%d.mcap" % time.time()


async def record(wanted, types, properties, pull, limits, file):
    """Record until a limit is reached or no port is left; returns the exit status.

    `wanted` are port_arguments.Targets, `types` datatypes.Types, `properties` those of the connections;
    `pull`: values are fetched.
    """
    tally = notes.Tally()
    channels = Channels(types)
    work = Recorder(limits.entries, channels.types)
    readers = await find_readers(wanted, properties, pull, channels, work.box, tally)
    for note in channels.notes:
        notes.note(note)
    watch = Watcher(readers)
    begun = int(time.time() * 1e9)
    try:
        async with connection.Connections(readers) as opened:
            opened.step_aside_when_stopped()
            if opened.live():
                await loop.finish(work.begin(file, channels, begun))
                if limits.words():
                    notes.note(limits.words())
                async with loop.background(watch.watch()), loop.background(work.run()):
                    async with loop.background(lateness.watch(opened)):
                        await wait(limits, work, opened)
    finally:
        await loop.finish(finish(work, watch, tally))
    if work.failure:
        return 1
    return tally.status()


def taker(box, channels, number, triggers):
    """The function that takes the Messages of a channel; triggers.Triggers judge them, too, if
    there are any.
    """
    deliver = box.taker(number)
    if triggers is None:
        return deliver
    channel = channels.found[number]
    return triggers.wrapped((channel.name, *channel.sources), channels.types[number], deliver)


async def find_readers(wanted, properties, pull, channels, box, tally, triggers=None):
    """Readers of the ports that Targets name, each for its channel; what fails is counted in a Tally."""
    readers = []
    for number, target in enumerate(await port_arguments.find(wanted, "DataOutPort")):
        try:
            if isinstance(target, errors.Error):
                raise target
            reader = reading.Reader(target.port, None, "pull" if pull else None, properties, "rtlog")
            channel = await channels.add(target.port, target.name or f"input{number}")
            reader.deliver = taker(box, channels, channel, triggers)
            reader.compare_clocks()
            readers.append(reader)
        except errors.Error as e:
            tally.add(e)
    return readers


async def wait(limits, work, opened=None):
    """Wait for the end of recording, and report what is dropped. It ends when none of the Connections
    `opened` lives, too.
    """
    end = time.monotonic() + limits.left()
    reported = 0
    due = 0.0
    while (
        (opened is None or opened.live())
        and time.monotonic() < end
        and not await work.done.wait(min(TICK, end - time.monotonic()))
    ):
        dropped = sum(work.box.dropped.values())
        if dropped > reported and time.monotonic() >= due:
            reported = dropped
            due = time.monotonic() + 1
            await loop.on_thread(
                notes.fail, f"{dropped} messages dropped so far: they come faster than they can be written"
            )


async def finish(work, watch, tally):
    """End a recording: write what is left, and report."""
    try:
        await work.close()
    except OSError as e:
        notes.fail(e)
    watch.count(tally)
    dropped = sum(work.box.dropped.values())
    if dropped:
        notes.fail(f"{dropped} of {dropped + work.count} messages dropped")
        tally.fail(errors.Partial())
    if work.repeated:
        notes.note(
            f"{work.repeated} of {work.count} messages came twice: the component repeats a value whose "
            "answer it has not got"
        )
    notes.detail(f"{work.count} messages, {work.octets} octets recorded")
