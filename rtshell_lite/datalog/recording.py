"""Recording from ports into a file, from beginning to end: which ports, until when, and what is reported."""

import functools
import math

from rtshell_lite import errors, notes
from rtshell_lite.data import connection, port_arguments, reading
from rtshell_lite.data.watcher import Watcher
from rtshell_lite.datalog import decode, flight, gaps, lateness
from rtshell_lite.datalog.recorder import TICK, Channels, Recorder
from rtshell_lite.net import loop


class Limits:
    """When recording ends: after `entries`, at `until` (seconds since the epoch), after `seconds`;
    None is never.
    """

    def __init__(self, end, by_index, seconds):
        """`end` is a number of entries (`by_index`) or seconds since the epoch; None and -1 are never."""
        self.entries = None
        self.until = None
        self.seconds = seconds
        if end is None or end == -1:
            return
        if by_index:
            self.entries = int(end)
        else:
            self.until = end

    def words(self):
        """The line that reports the limits, None without any."""
        if self.seconds < math.inf:
            return f"Recording for {self.seconds}s."
        if self.entries is not None:
            return f"Recording {self.entries} entries."
        if self.until is not None:
            return f"Recording until {decode.date(int(self.until * 1e9))}."
        return None

    def left(self):
        """Seconds that are left; infinite without a limit in time."""
        if self.until is None:
            return self.seconds
        return min(self.seconds, self.until - loop.wall())


class File:
    """The file to record to: its `name`; `form`: mcap, simpkl or text; whether to append. `limits`:
    ring.Limits of several files, or None; `is_in_memory`: they are not written.
    """

    def __init__(self, name, form, append, limits=None, is_in_memory=False):
        self.name = name
        self.limits = limits
        self.is_in_memory = is_in_memory
        self.form = form
        self.append = append

    def writer(self, channels, begun):
        """The LogWriter for these Channels, recorded since `begun` (ns since the epoch).
        Raises OSError, errors.Failed.
        """
        if self.form == "text":
            from rtshell_lite.datalog import textlog

            return textlog.TextWriter(self.name, channels.found, channels.types, self.append)
        if self.form == "simpkl":
            notes.note("simpkl files are only read; recording as MCAP")
        if self.limits is None:
            from rtshell_lite.datalog import writer

            return writer.LogWriter(self.name, channels.found, begun, self.append)
        from rtshell_lite.datalog import ring

        if self.is_in_memory:
            return ring.Memory(channels.found, self.limits.span, self.limits.size)
        return ring.Parts(self.name, channels.found, begun, self.limits, self.append)


def default_name():
    """The name of a log whose user has given none."""
    return "rtlog_%d.mcap" % loop.wall()


class Plan:
    """What is recorded: `wanted` ports (port_arguments.Targets), and those below `tops` (Paths) that a
    flight.Choice takes. `properties` are those of the connections; `pull`: values are fetched. A `journal` of
    events (see system/journal.py), and triggers.Triggers with the incidents.Incidents that they make, or
    None.
    """

    def __init__(self, targets, tops, choice, properties, pull):
        self.targets = targets
        self.tops = tops
        self.choice = choice
        self.properties = properties
        self.pull = pull
        self.journal = None
        self.triggers = None
        self.incidents = None

    def is_endless(self):
        """Whether recording goes on where no port is left."""
        return bool(self.tops or self.incidents)


async def record(plan, types, limits, file):
    """Carry out a Plan, within Limits, to a File; returns the exit status. `types`: datatypes.Types."""
    return await _Recording(plan, types, limits, file).run()


class _Recording:
    """A Plan that is carried out."""

    def __init__(self, plan, types, limits, file):
        self._plan = plan
        self._limits = limits
        self._file = file
        self._channels = Channels(types)
        self._work = Recorder(self._channels, limits.entries, plan.incidents)
        self._work.hear_gap = self._note_gap
        self._tally = notes.Tally()

    async def run(self):
        """Record until a limit is reached, or nothing more can come; returns the exit status."""
        readers = await self._wanted_readers()
        followed = flight.Flight(self._plan.tops, self._plan.choice, self._reader_below, readers)
        seconds = max(0.0, self._limits.left())
        if not await loop.race(_done(followed.find()), _pass_by(seconds)):
            words = f"what is below it could not be listed within {seconds:.3g}s"
            return notes.fail(errors.Silent(", ".join(map(str, self._plan.tops)), words))
        for failure in followed.failures.values():
            self._tally.add(failure)
        if self._tally.statuses and not readers and len(followed.failures) == len(self._plan.tops):
            return self._tally.status()
        watch = Watcher(readers)
        try:
            await self._record(followed, watch)
        finally:
            await loop.finish(self._finish(watch))
        if self._work.failure:
            return 1
        if self._plan.is_endless():
            self._tally.done += 1  # it has recorded what there was
        return self._tally.status()

    async def _record(self, followed, watch):
        begun = int(loop.wall() * 1e9)
        async with connection.Connections(followed.readers) as opened:
            opened.step_aside_when_stopped()
            if not self._goes_on(opened):
                return
            await loop.finish(self._work.begin(self._file, begun))
            if self._plan.is_endless():
                notes.note("Recording %d ports." % len(followed.readers))
            elif self._limits.words():
                notes.note(self._limits.words())
            async with loop.background(watch.watch()), loop.background(self._work.run()):
                async with loop.Group() as others:
                    self._start(others, followed, opened)
                    await self._wait(opened)
                    others.cancel()

    def _start(self, others, followed, opened):
        """Start, in a loop.Group, what goes on beside writing."""
        plan = self._plan
        others.start(lateness.watch(opened, self._note_let_go))
        if plan.tops:
            others.start(followed.follow(opened))
        if plan.triggers is not None:
            others.start(plan.triggers.watch(self._work))
        if plan.journal is not None:
            others.start(plan.journal.run(followed, self._work))

    def _note_let_go(self, reader):
        """Record that a Reader was let go."""
        if self._plan.journal is not None:
            self._plan.journal.put(str(reader.port.node.path), "RECORDER", reader.port.name, "LET_GO")

    def _note_gap(self, gap):
        """Record, among the events, that values are missing."""
        if self._plan.journal is None or not self._plan.journal.is_running():
            return
        for channel in self._channels.found:
            if channel.name in gap.counts:
                for source in channel.sources[: gaps.NAMED]:
                    path, _, port = source.rpartition(":")
                    self._plan.journal.put(path, "RECORDER", port, "MISSING")

    def _goes_on(self, opened):
        return self._plan.is_endless() or opened.live()

    async def _wait(self, opened):
        """Wait for the end of recording, and report what is dropped."""
        end = loop.now() + self._limits.left()
        reported = 0
        due = 0.0
        box = self._work.box
        while self._goes_on(opened) and loop.now() < end:
            if await self._work.done.wait(min(TICK, end - loop.now())):
                return
            dropped = sum(box.dropped.values())
            if dropped > reported and loop.now() >= due:
                reported = dropped
                due = loop.now() + 1
                words = f"{dropped} messages dropped so far: they come faster than they can be written"
                await loop.on_thread(notes.fail, words)

    async def _finish(self, watch):
        """End the recording: write what is left, and report."""
        work = self._work
        try:
            await work.close()
        except (OSError, errors.Failed) as e:
            notes.fail(e)
        watch.count(self._tally)
        dropped = sum(work.box.dropped.values())
        if dropped:
            notes.fail(f"{dropped} of {dropped + work.count} messages dropped")
            self._tally.fail(errors.Partial())
        if work.gaps:
            notes.fail(f"values are missing (intervals: {work.gaps}); rtlog show says when")
            self._tally.fail(errors.Partial())
        if work.repeated:
            notes.note(
                f"{work.repeated} of {work.count} messages came twice: the component repeats a value whose "
                "answer it has not got"
            )
        notes.detail(f"{work.count} messages, {work.octets} octets recorded")

    # ---- ports ----

    async def _wanted_readers(self):
        """Readers of the ports that were named, each for its channel; what fails is counted."""
        readers = []
        for number, target in enumerate(await port_arguments.find(self._plan.targets, "DataOutPort")):
            try:
                if isinstance(target, errors.Error):
                    raise target
                reader = self._reader(target.port, self._plan.properties)
                channel = await self._channels.add(target.port, target.name or f"input{number}")
            except errors.Error as e:
                self._tally.add(e)
            else:
                self._feed(reader, channel, self._taker(channel))
                readers.append(reader)
        return readers

    async def _reader_below(self, port, about, is_fast):
        """The Reader of a Port that a Flight has found. Raises errors.Error."""
        properties = self._plan.properties
        if is_fast:
            properties = dict({reading.SUBSCRIPTION: "new"}, **properties)
        reader = self._reader(port, properties)
        if is_fast:
            reader.room = reading.QUEUE  # 2,000 values a second fill the usual buffer in 0.13 s
        channel = await self._channels.add_by_path(port, about)
        self._feed(reader, channel, self._plan.choice.thin(port, self._taker(channel)))
        return reader

    def _reader(self, port, properties):
        dataflow = "pull" if self._plan.pull else None
        return reading.Reader(port, None, dataflow, properties, "rtlog")

    def _taker(self, number):
        """The function that takes the Messages of a channel, which triggers judge, too."""
        deliver = self._work.box.taker(number)
        if self._plan.triggers is None:
            return deliver
        channel = self._channels.found[number]
        names = (channel.name, *channel.sources)
        return self._plan.triggers.wrap(names, self._channels.types[number], deliver)

    def _feed(self, reader, channel, deliver):
        """Have deliver(Message) called with what a Reader brings for a channel."""
        reader.deliver = deliver
        reader.miss = functools.partial(self._work.put_gap, channel)
        reader.compare_clocks()


async def _done(coroutine):
    await coroutine
    return True


async def _pass_by(seconds):
    await loop.sleep(seconds)
    return False
