"""Recording from ports into a file: connections, limits, reports.

A thread writes what arrives in an inbox.Inbox, so that no sender waits for a disk.
"""
import math
import threading
import time

from rtshell_lite import cli, errors, interrupts
from rtshell_lite.data import connection, datatypes, inbox, port_words, reading
from rtshell_lite.data.watcher import Watcher
from rtshell_lite.datalog import blocks, meaning
from rtshell_lite.datalog.records import Channel
from rtshell_lite.robot import ports
from rtshell_lite.text import printable

VALUES = 200000  # that may wait to be written
TICK = 0.1  # seconds between two looks whether recording is over
TIMESTAMP = 8  # octets
SYNC = 5.0  # seconds between two fsyncs: what a power failure costs


class Channels:
    """The channels of a new log; ports with the same NAME share one.

    `found` are the records.Channels, `types` their datatypes.Type or None; `notes` say why None.
    """

    def __init__(self, known):
        """`known` are datatypes.Types."""
        self._known, self.found, self.types, self.notes = known, [], [], []

    def add(self, port, name):
        """The number of a Port's channel. Raises errors.Failed when a channel of that NAME has another type."""
        where, type_id = ports.label(port), port.properties.get("dataport.data_type", "")
        for number, channel in enumerate(self.found):
            if channel.name == name:
                if not ports.same_type(channel.type_id, type_id):
                    raise errors.Failed(where, "%s has another data type (%s, %s)" % (
                        printable(name), printable(channel.type_id), printable(type_id)))
                channel.sources.append(where)
                return number
        try:
            type = self._known.of_port(port)
        except errors.NoSuch:
            type = None
            self.notes.append(f"{where}: recorded as bytes: {printable(type_id)} is not known; {datatypes.SOURCES}")
        except errors.BadType as e:
            type = None
            self.notes.append(f"{where}: recorded as bytes: {e}")
        self.types.append(type)
        self.found.append(Channel(name, type.id if type else type_id, type.to_bytes() if type else b"", [where]))
        return len(self.found) - 1


class Recorder:
    """Writes the Messages that arrive in its `box`, whose keys are numbers of channels.

    The Flag `done` is set when `most` messages are written or writing fails. `count` and `octets` say how many were written,
    `repeated` how many of these came twice in a row, with the same timestamp: OpenRTM-aist 2.1 repeats a `put` whose answer was lost;
    `failure` (OSError or None) why writing failed.
    """

    def __init__(self, most=None, types=()):
        """`types`: the datatypes.Type of each channel or None, a list that may grow until `start`."""
        self.box, self._most, self._types = inbox.Inbox(VALUES), most, types
        self.count = self.octets = self.repeated = 0
        self._last = {}  # by channel: the data of the last value
        self.failure = self._thread = None
        self.done, self._stopped = interrupts.Flag(), threading.Event()

    def start(self, writer):
        """Start writing with a Writer (of writer or textlog)."""
        with interrupts.held():  # `close` waits for a thread that has started
            self._thread = threading.Thread(target=self._run, args=(writer,), daemon=True)
            self._thread.start()

    def close(self):
        """Wait until all messages are on the disk. Raises OSError, the reason why writing failed; RuntimeError for a bug."""
        self._stopped.set()
        if self._thread:
            self._thread.join()
        if self.failure:
            raise self.failure

    def _run(self, writer):
        self.failure = RuntimeError("the thread that writes has ended")  # if a bug raises
        try:
            self.failure = self._written(writer)
        finally:
            self.done.set()

    def _written(self, writer):
        """Write until the end, and close; returns the OSError that prevented it, or None."""
        failure = None
        for step in (lambda: self._write(writer), writer.close):
            try:
                step()
            except OSError as e:
                failure = failure or e
        return failure

    def _fits(self, channel, message):
        if len(message.data) <= blocks.LARGEST:
            return True
        self.box.dropped[channel] += 1
        return False

    def _is_repeated(self, channel, data):
        """Whether a value is the last one of its channel again. Those without a timestamp may be alike."""
        last, self._last[channel] = self._last.get(channel), data
        if data != last or not any(data[:TIMESTAMP]):
            return False
        type = self._types[channel] if channel < len(self._types) else None
        return type is not None and meaning.place_of_timestamp(type.descriptor) == meaning.FIRST

    def _write(self, writer):
        due, last = time.monotonic() + SYNC, False
        while not (last or self.done.is_set()):
            last = self._stopped.is_set()
            batch = [message for message in self.box.get(0 if last else TICK) if self._fits(*message)]
            if self._most is not None:
                batch = batch[:self._most - self.count]
            writer.write([(channel, message.received, message.little, message.data) for channel, message in batch])
            self.count += len(batch)
            self.repeated += sum(self._is_repeated(channel, message.data) for channel, message in batch)
            self.octets += sum(len(message.data) for _, message in batch)
            if self.count == self._most:
                self.done.set()
            if time.monotonic() >= due:
                writer.sync()
                due = time.monotonic() + SYNC


# ---- a recording from beginning to end ------------------------------------------------------------------------

class Limits:
    """When recording ends: after `entries`, at `until` (seconds since the epoch), after `seconds`; None is never."""

    def __init__(self, end, by_index, seconds):
        """`end` is a number of entries (`by_index`) or seconds since the epoch; None and -1 are never."""
        end = None if end == -1 else end
        self.entries = int(end) if by_index and end is not None else None
        self.until = None if by_index else end
        self.seconds = seconds

    def words(self):
        """The line that reports the limits, None without any."""
        if self.seconds < math.inf:
            return f"Recording for {self.seconds}s."
        if self.entries is not None:
            return f"Recording {self.entries} entries."
        return self.until and f"Recording until {meaning.date(int(self.until * 1e9))}."

    def left(self):
        """Seconds that are left; infinite without a limit in time."""
        return min(self.seconds, math.inf if self.until is None else self.until - time.time())


class File:
    """The file to record to: `name`, None for one made from the time; `form`: rtlog, simpkl or text; whether to append."""

    def __init__(self, name, form, append):
        self.name, self.form, self.append = name, form, append

    def writer(self, channels, begun):
        """The Writer for these Channels, recorded since `begun` (ns since the epoch). Raises OSError, errors.Failed."""
        name = self.name
        if name is None:
            name = "rtlog_%d.rtlog" % time.time()
            cli.note(f"recording to {name}")
        if self.form == "text":
            from rtshell_lite.datalog import textlog
            return textlog.Writer(name, channels.found, channels.types, self.append)
        if self.form == "simpkl":
            cli.note("simpkl files are only read; recording in rtlog's own form")
        from rtshell_lite.datalog import writer
        return writer.Writer(name, channels.found, begun, self.append)


def record(wanted, types, properties, pull, limits, file):
    """Record until a limit is reached or no port is left; returns the exit status.

    `wanted` are port_words.Targets, `types` datatypes.Types, `properties` those of the connections; `pull`: values are fetched.
    """
    tally, channels = cli.Tally(), Channels(types)
    work = Recorder(limits.entries, channels.types)
    readers = list(_readers(wanted, properties, pull, channels, work.box, tally))
    for note in channels.notes:
        cli.note(note)
    watcher, begun = Watcher(readers), int(time.time() * 1e9)
    try:
        with connection.Opened(readers) as opened:
            opened.step_aside_when_stopped()
            if opened.live():
                work.start(file.writer(channels, begun))
                if limits.words():
                    cli.note(limits.words())
                _wait(limits, work, opened, watcher)
    finally:
        _finish(work, watcher, tally)
    return 1 if work.failure else tally.status()


def _readers(wanted, properties, pull, channels, box, tally):
    for number, target in enumerate(port_words.find(wanted)):
        try:
            if isinstance(target, errors.Error):
                raise target
            reader = reading.Reader(target.port, None, "pull" if pull else None, properties, "rtlog")
            reader.deliver = box.taker(channels.add(target.port, target.name or f"input{number}"))
            reader.compare_clocks()
            yield reader
        except errors.Error as e:
            tally.add(e)


def _wait(limits, work, opened, watcher):
    """Wait for the end of recording, and report what goes wrong."""
    end = time.monotonic() + limits.left()
    reported, due = 0, 0.0
    while opened.live() and time.monotonic() < end and not work.done.wait(min(TICK, max(0, end - time.monotonic()))):
        watcher.look()
        dropped = sum(work.box.dropped.values())
        if dropped > reported and time.monotonic() >= due:
            reported, due = dropped, time.monotonic() + 1
            cli.complain(f"{dropped} messages dropped so far: they come faster than they can be written")


def _finish(work, watcher, tally):
    try:
        work.close()
    except OSError as e:
        cli.complain(e)
    watcher.count(tally)
    dropped = sum(work.box.dropped.values())
    if dropped:
        cli.complain(f"{dropped} of {dropped + work.count} messages dropped")
        tally.fail(errors.Partial())
    if work.repeated:
        cli.note(f"{work.repeated} of {work.count} messages came twice: the component repeats a value whose answer it has not got")
    cli.detail(f"{work.count} messages, {work.octets} octets recorded")
