"""Playing a log to ports: which entries, when each is due, and which port gets which channel."""

import itertools
import math

from rtshell_lite import errors, notes
from rtshell_lite.data import connection, port_arguments, writing
from rtshell_lite.data.watcher import Watcher
from rtshell_lite.datalog import decode, pace
from rtshell_lite.net import loop
from rtshell_lite.robot import ports, tree
from rtshell_lite.text import printable


def asked_range(start, end, by_index):
    """The Range of -s and -e. Raises Usage."""
    if start and end is not None and 0 <= end < start:
        raise errors.Usage("the end is before the start")
    if not (_is_bound(start) and (end == -1 or _is_bound(end))):
        raise errors.Usage("start or end out of bounds")
    return Range(start, end, by_index)


def _is_bound(value):
    return value is None or 0 <= value < 1 << 53


class Range:
    """Which entries of a log are played: from `start` to `end`, both either numbers (`by_index`) or seconds
    since the epoch.

    None is no limit, and so is an end of -1. As in rtshell, an end by index is a number of entries without a
    start (or with 0), and the last entry with one.
    """

    def __init__(self, start, end, by_index):
        self.start = start or None
        self.by_index = by_index
        self.end = None if end == -1 else end

    def entries(self, log, first=None):
        """The entries, from number `first` on if that is given. Raises errors.Failed where there are none."""
        entries = log.entries(max(self._first(log), first or 0))
        if self.end is None:
            return entries
        if self.by_index:
            last = int(self.end) if self.start else int(self.end) - 1
            return itertools.takewhile(lambda entry: entry.number <= last, entries)
        limit = int(self.end * 1e9)
        if log.first is not None and limit < log.first:
            raise errors.Failed(log.where, "the end is before the first entry")
        return itertools.takewhile(lambda entry: entry.received <= limit, entries)

    def words(self, seconds):
        """Lines that report the range and a limit in seconds."""
        if seconds < math.inf:
            yield f"Playing for {seconds}s."
        limits = self.start, self.end
        if self.by_index:
            forms = "from entry %d to entry %d", "from entry %d", "%d entries"
        else:
            limits = [limit and decode.date(int(limit * 1e9)) for limit in limits]
            forms = "from %s until %s", "from %s", "until %s"
        given = tuple(limit for limit in limits if limit is not None)
        if given:
            both, since, until = forms
            if len(given) == 2:
                form = both
            elif self.start is not None:
                form = since
            else:
                form = until
            yield f"Playing {form % given}."

    def _first(self, log):
        if self.start is None:
            return 0
        if not self.by_index:
            number = log.since(int(self.start * 1e9))
        elif next(log.entries(int(self.start)), None):
            number = int(self.start)
        else:
            number = None
        if number is None:
            raise errors.Failed(log.where, "the start is after the last entry")
        return number


def _channel_for(log, port, name, index):
    """The number of the channel that is played to a Port: the one called `name`, or the one with that `index`
    without a name.

    Raises errors.NoSuch; errors.Failed when the types differ.
    """
    where = ports.label(port)
    names = [channel.name for channel in log.channels]
    if name in names:
        number = names.index(name)
    elif name is None and index < len(names):
        number = index
    else:
        called = printable(name or "number %d" % (index + 1))
        there = ", ".join(map(printable, names)) or "none"
        raise errors.NoSuch(where, f"channel in {log.where}", f"{called} (there are: {there})")
    _check_types(log, number, port)
    return number


def _check_types(log, number, port):
    """Raise errors.Failed where the type of a channel is not that of a Port."""
    recorded = log.channels[number].type_id
    expected = port.properties.get("dataport.data_type", "")
    if not ports.same_type(recorded, expected):
        raise errors.Failed(
            ports.label(port),
            f"data types differ: {printable(recorded)} in the log, {printable(expected)} here",
        )


async def portions(entries, count, cycle, seconds=math.inf):
    """The entries, `count` of them every `cycle` seconds, for `seconds`."""
    begun = loop.now()
    for number, entry in enumerate(entries):
        if number % count == 0 and not await _wait_until(begun, number // count * cycle, seconds):
            return
        yield entry


async def _wait_until(begun, moment, seconds):
    """Wait until `moment` seconds after `begun`; False when the limit of `seconds` comes first."""
    left = begun + min(moment, seconds) - loop.now()
    if left > 0:
        await loop.sleep(left)
    return moment <= seconds and loop.now() <= begun + seconds + pace.GRACE


class Playing:
    """A log that is played to ports. Ports that fail are reported and counted in `tally`."""

    def __init__(self, decoder, anyway):
        """`decoder`: the log's decode.Decoder; `anyway`: even to components that will not read the values."""
        self.decoder = decoder
        self.anyway = anyway
        self.tally = notes.Tally()
        self.sinks = []  # (number of a channel, the writing.Writer of a port that it is played to)

    async def find_sinks(self, targets, properties):
        """Find the ports; `targets` are port_arguments.Targets, `properties` those of the connections."""
        for index, target in enumerate(await port_arguments.find(targets, "DataInPort")):
            try:
                if isinstance(target, errors.Error):
                    raise target
                self._add(
                    _channel_for(self.decoder.log, target.port, target.name, index), target.port, properties
                )
            except errors.Error as e:
                self.tally.add(e)

    async def find_ends(self, ends, properties):
        """Find the in ports that channels lead to: `ends` are (number of a channel, Path of a port)."""
        owners = list(dict.fromkeys(path.object() for _, path in ends))
        listed = dict(zip(owners, await tree.on_components(owners, ports.ports)))
        for number, path in ends:
            try:
                answer = listed[path.object()]
                port = answer if isinstance(answer, errors.Error) else ports.named(path, answer)
                if isinstance(port, errors.Error):
                    raise port
                _check_types(self.decoder.log, number, port)
                self._add(number, port, properties)
            except errors.Error as e:
                self.tally.add(e)

    def _add(self, number, port, properties):
        log = self.decoder.log
        coming = log.counts.get(log.channels[number].name, 0)
        self.sinks.append(
            (number, writing.Writer(port, properties, "rtlog", self.anyway, several=coming != 1))
        )

    async def play(self, entries, absolute, linger):
        """Send the entries as they come; with `absolute` their timestamps stay, else they are moved to now.

        Then wait until they can have been read, for `linger` seconds at most (None: as long as it takes).
        Returns False when all ports had failed before the end.
        """
        watch = Watcher([writer for _, writer in self.sinks])
        async with connection.Connections(watch.connections) as opened:
            async with loop.background(watch.watch()):
                is_complete = await self._send(entries, absolute, opened)
                await writing.linger(opened.live(), linger)
            await watch.report_news()
        watch.count(self.tally)
        return is_complete

    async def _send(self, entries, absolute, opened):
        """Send each entry to the ports of its channel that have not failed."""
        spare = writing.LATE  # seconds by which it may still fall behind
        ended = loop.now()  # when it began to wait
        async for entry in entries:
            live = opened.live()
            if not live:
                return False
            able = [writer for writer in live if writer.failure is None]
            if not able:
                able = live  # beside others, silent ones would delay them
            begun = loop.now()
            spare = min(writing.LATE, spare + begun - ended)
            writers = [
                writer for channel, writer in self.sinks if channel == entry.channel and writer in able
            ]
            await self._offer(entry, writers, absolute, begun + spare)
            ended = loop.now()
            spare -= ended - begun
        return True

    async def _offer(self, entry, writers, absolute, until):
        """Send an entry to these Writers."""
        moment = None if absolute else int(loop.wall() * 1e9)
        values = []
        for writer in writers:
            try:
                values.append((writer, self.decoder.data(entry, writer.little, moment)))
            except errors.Failed as e:
                self.tally.add(e)
        failed = dict(await writing.offer(values, until))
        for writer, _ in values:
            failure = failed.get(writer)
            if isinstance(failure, errors.Refused):
                self.tally.add(failure)
            elif failure or isinstance(writer.failure, errors.Unanswered):
                writer.failure = failure
