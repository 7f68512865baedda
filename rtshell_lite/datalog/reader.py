"""Reading log files of rtlog's own form: nothing in them is trusted, and everything that is whole is read."""

import bisect

from rtshell_lite import errors
from rtshell_lite.datalog import blocks
from rtshell_lite.datalog.index import Index
from rtshell_lite.datalog.records import Channel, Entry, is_moment

MOST = 1000  # channels, and sources of a channel: more are hostile


class Log:
    """An open log, to be used in a `with` statement.

    `channels`; `started` (ns since the epoch), `count`, `first` and `last` (arrival of the first and the last
    record, or None), `counts` (by channel's name), `torn` (octets of half a record at the end), `closed`
    (False: recording was killed, or goes on), and `damaged` (records left out), which may grow while entries
    are read.
    """

    form = "rtlog"

    def __init__(self, file, where, size):
        """Read the header, and the index or, where that is missing or wrong, the file.
        Raises errors.Failed.
        """
        self.where = where
        self.size = size
        self.channels = []
        self.torn = 0
        self.closed = False
        self._damaged = set()
        # offset of a header: our numbers of its channels
        self._file = file
        self._maps = {}
        self._numbers = {}  # our number of a channel, by its name and type
        file.seek(len(blocks.MAGIC))
        try:
            kind, body = blocks.read(file, size - len(blocks.MAGIC))
            if kind != blocks.HEADER:
                raise blocks.Damaged("no header")
            self.started = self._header(len(blocks.MAGIC), body)
        except blocks.Damaged:
            raise errors.Failed(where, "its header is damaged, nothing can be read")
        self.index, self._end = self._indexed() or self._scanned()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._file.close()

    count = property(lambda self: self.index.count)
    first = property(lambda self: self.index.first)
    last = property(lambda self: self.index.last)
    counts = property(lambda self: self.index.counts)
    damaged = property(lambda self: len(self._damaged))

    def entries(self, start=0):
        """The entries from record number `start` on, one by one."""
        point = bisect.bisect_right([number for number, _, _ in self.index.points], start) - 1
        if point >= 0:
            offset = self.index.points[point][1]
        else:
            offset = self._end
        for _, entry in self._records(offset, self._end):
            if entry.number >= start:
                yield entry
        if self._whole < self._end:
            self.torn = self.size - self._whole

    def since(self, moment):
        """The number of the first record that arrived at `moment` (ns) or later, or None."""
        latest = [point[2] for point in self.index.points[1:]]  # the first point has nothing before it
        point = bisect.bisect_left(latest, moment)
        for entry in self.entries(self.index.points[point][0] if self.index.points else 0):
            if entry.received >= moment:
                return entry.number
        return None

    def notes(self):
        """What is wrong with the file, in words."""
        if self.torn:
            yield "the last %d octets are no whole record and are left out" % self.torn
        elif not self.closed:
            yield "recording has not ended regularly, or goes on"
        if self.damaged:
            yield "%d damaged records are left out" % self.damaged

    def scan(self, index):
        """Put all records into `index`, an Index;
        returns the offset after the last whole block but the index.
        """
        end = self._end
        index.headers = sorted(self._maps)
        for offset, entry in self._records(len(blocks.MAGIC), end):
            index.add(offset, entry.number, entry.received, self.channels[entry.channel].name)
        return end

    # ---- blocks ----

    def _header(self, offset, body):
        """Add a header's channels; returns when recording began."""
        header = blocks.parsed(body)
        ours = []
        try:
            for fields in header["channels"]:
                channel = Channel(
                    fields["name"],
                    fields["type"],
                    bytes.fromhex(fields["typecode"] or ""),
                    tuple(fields["sources"]),
                )
                if not all(isinstance(word, str) for word in channel[:2] + channel.sources):
                    raise ValueError("no text")
                ours.append(self._channel(channel))
            created = header["created"]
        except (KeyError, TypeError, ValueError):
            raise blocks.Damaged("no header")
        if not is_moment(created):
            raise blocks.Damaged("no header")
        self._maps[offset] = ours
        return created

    def _channel(self, channel):
        """The number of a channel; a later header may have it again, with the same name and type."""
        number = self._numbers.setdefault(channel[:2], len(self.channels))
        if number < len(self.channels):
            known = self.channels[number]
            more = tuple(source for source in channel.sources if source not in known.sources)
            self.channels[number] = known._replace(sources=(known.sources + more)[:MOST])
            return number
        if len(self.channels) >= MOST or len(channel.sources) >= MOST:
            raise blocks.Damaged("a header that cannot be")
        self.channels.append(channel)
        return number

    def _records(self, offset, end):
        """(offset, Entry) of the whole records between two offsets.
        In the end, self._whole is after the last whole block.
        """
        headers = [header for header in sorted(self._maps) if header <= offset]
        if headers:
            channels = self._maps[headers[-1]]
        else:
            channels = []
        number = -1
        while offset < end:
            self._file.seek(offset)  # between two records the caller may read elsewhere
            try:
                kind, body = blocks.read(self._file, end - offset)
                if kind == blocks.HEADER:
                    self._header(offset, body)
                    channels = self._maps[offset]
                if kind == blocks.RECORD:
                    entry = _entry(body, channels, number)
                    number = entry.number
                    yield offset, entry
            except blocks.Unsound as e:
                if not self._sound(offset + e.args[0], end):
                    break
                self._damaged.add(offset)
                offset += e.args[0]
                continue
            except blocks.Damaged:
                break
            offset += blocks.BLOCK.size + len(body)
        self._whole = offset

    def _sound(self, offset, end):
        """Whether there is a whole block at `offset`: else the length of the one before it may be wrong."""
        if offset >= end:
            return False  # a torn record may have its right length
        self._file.seek(offset)
        try:
            blocks.read(self._file, end - offset)
        except blocks.Damaged:
            return False
        return True

    # ---- the index ----

    def _indexed(self):
        """(the index at the end of the file, its offset);
        None where there is none that agrees with the file.
        """
        position = blocks.index_position(self._file, self.size)
        if position is None:
            return None
        self._file.seek(position)
        try:
            kind, body = blocks.read(self._file, self.size - position)
            if kind != blocks.INDEX or self._file.tell() != self.size:
                return None
            index = self._believed(blocks.parsed(body, footer=True), position)
            self.closed = True
            return index, position
        except (blocks.Damaged, KeyError, TypeError, ValueError, IndexError, AttributeError):
            return None

    def _believed(self, fields, position):
        """The Index of a file, checked. Raises ValueError and whatever wrong types raise."""
        index = Index()
        index.next = fields["next"]
        index.first = fields["first"]
        index.last = fields["last"]
        index.counts = fields["counts"]
        index.headers = fields["headers"]
        index.points = fields["points"]
        _demand(index.headers[0] == len(blocks.MAGIC) and index.headers == sorted(set(index.headers)))
        _demand(bool(index.points) == bool(index.count) and index.count <= index.next)
        numbers = [point[0] for point in index.points]
        offsets = [point[1] for point in index.points]
        latest = [point[2] for point in index.points[1:]]
        counts = list(index.counts.values())
        _demand(
            all(
                isinstance(number, int)
                for number in [index.next] + index.headers + counts + numbers + offsets + latest
            )
        )
        _demand(latest == sorted(latest) and all(a < b for a, b in zip(numbers, numbers[1:])))
        _demand(all(0 <= offset < position for offset in index.headers + offsets))
        for offset in index.headers[1:]:
            self._file.seek(offset)
            kind, body = blocks.read(self._file, position - offset)
            _demand(kind == blocks.HEADER)
            self._header(offset, body)
        if index.count:
            self._compare(index, numbers, offsets, position)
        return index

    def _compare(self, index, numbers, offsets, position):
        """Check that the points are at records of their numbers,
        and that the last record is the one it names.
        """
        for number, offset in zip(numbers, offsets):
            self._file.seek(offset)
            _demand(blocks.read_number(self._file, position - offset) == number)
        last = None
        for _, last in self._records(offsets[-1], position):
            pass
        _demand(
            last is not None
            and last.number == index.next - 1
            and last.received == index.last
            and is_moment(index.first)
        )

    def _scanned(self):
        """(an index made by reading the whole file, the offset after the last whole block)"""
        index = Index()
        start = len(blocks.MAGIC)
        self.channels = []
        self._maps = {}
        self._numbers = {}
        for offset, entry in self._records(start, self.size):
            index.add(offset, entry.number, entry.received, self.channels[entry.channel].name)
        self.torn = self.size - self._whole
        index.headers = sorted(self._maps)
        return index, self._whole


def _entry(body, channels, before):
    number, received, channel, flags = blocks.ENTRY.unpack_from(body)
    if channel >= len(channels) or not before < number < 1 << 62:
        raise blocks.Damaged("a record that cannot be")
    return Entry(
        number, received, channels[channel], bool(flags & blocks.LITTLE), body[blocks.ENTRY.size :], None
    )


def _demand(condition):
    if not condition:
        raise ValueError("an index that does not agree with the file")
