"""Recording from ports into a file: the connections, the limits, and what is told meanwhile."""
import math
import time

from rtshell_lite import cli, connection, dataport, errors, streams, targets
from rtshell_lite.datalog import meaning, recorder

TICK = 0.1  # seconds between two looks at what is not a message: the end, dead ports, drops


class Limits:
    """When recording ends: after `entries` or at `until` (seconds since the epoch), None is never; after `seconds`."""

    def __init__(self, end, by_index, seconds):
        """`end` is a number of entries (`by_index`) or seconds since the epoch; None and -1 are never."""
        end = None if end == -1 else end
        self.entries = int(end) if by_index and end is not None else None
        self.until = None if by_index else end
        self.seconds = seconds

    def words(self):
        """What is told of it, None when nothing limits."""
        if self.seconds < math.inf:
            return "Recording for %ss." % self.seconds
        if self.entries is not None:
            return "Recording %d entries." % self.entries
        return self.until and "Recording until %s." % meaning.date(int(self.until * 1e9))

    def left(self):
        """Seconds from now to the end, as far as it is one of time."""
        return min(self.seconds, math.inf if self.until is None else self.until - time.time())


class File:
    """Where it is recorded to: `name`, None for one made of the time; `form` rtlog, simpkl or text; whether to go on with it."""

    def __init__(self, name, form, append):
        self.name, self.form, self.append = name, form, append

    def writer(self, channels, begun):
        """What writes recorder.Channels, recorded since `begun` (ns since the epoch). Raises OSError, errors.No."""
        name = self.name
        if name is None:
            name = "rtlog_%d.rtlog" % time.time()
            cli.note("recording to %s" % name)
        if self.form == "text":
            from rtshell_lite.datalog import textlog
            return textlog.Writer(name, channels.found, channels.types, self.append)
        if self.form == "simpkl":
            cli.note("simpkl files are only read; recording in rtlog's own form")
        from rtshell_lite.datalog import writer
        return writer.Writer(name, channels.found, begun, self.append)


def record(wanted, types, properties, pull, limits, file):
    """Record until a limit is reached or no port is left; returns the exit status, and disconnects however it ends.

    `wanted` are targets.Targets, `types` datatypes.Types, `properties` go into the connections; `pull`: values are fetched.
    """
    tally, channels, work = cli.Tally(), recorder.Channels(types), recorder.Recorder(limits.entries)
    readers = list(_readers(wanted, properties, pull, channels, work.box, tally))
    for note in channels.notes:
        cli.note(note)
    watcher, begun = streams.Watcher(readers), int(time.time() * 1e9)
    try:
        with connection.Opened(readers) as opened:
            if opened.live():
                work.start(file.writer(channels, begun))
                if limits.words():
                    cli.note(limits.words())
                _wait(limits, work, opened, watcher)
    finally:
        _finish(work, watcher, tally)
    return 1 if work.failure else tally.status()


def _readers(wanted, properties, pull, channels, box, tally):
    for number, each in enumerate(targets.find(wanted)):
        try:
            if isinstance(each, errors.Error):
                raise each
            reader = dataport.Reader(each.port, None, "pull" if pull else None, None, properties, "rtlog")
            reader.deliver = box.taker(channels.add(each.port, each.name or "input%d" % number))
            yield reader
        except errors.Error as e:
            tally.add(e)


def _wait(limits, work, opened, watcher):
    """Wait for the end of recording; tell meanwhile what goes wrong."""
    end = time.monotonic() + limits.left()
    told, due = 0, 0.0
    while opened.live() and time.monotonic() < end and not work.done.wait(min(TICK, max(0, end - time.monotonic()))):
        watcher.look()
        dropped = sum(work.box.dropped.values())
        if dropped > told and time.monotonic() >= due:
            told, due = dropped, time.monotonic() + 1
            cli.complain("%d messages dropped so far: they come faster than they can be written" % dropped)


def _finish(work, watcher, tally):
    try:
        work.close()
    except OSError as e:
        cli.complain(e)
    watcher.count(tally)
    dropped = sum(work.box.dropped.values())
    if dropped:
        cli.complain("%d of %d messages dropped" % (dropped, dropped + work.count))
        tally.fail(errors.Partial())
    cli.detail("%d messages, %d octets recorded" % (work.count, work.octets))
