"""Writing log files: MCAP whose chunks are written whole, so that the file can be read at any time."""

import json
import os
import stat
import tempfile

from rtshell_lite import __version__, errors, files, text
from rtshell_lite.data import clocks, datatypes
from rtshell_lite.datalog import decode, gaps, mcap, schemas
from rtshell_lite.datalog.mcap import CHUNK_SIZE

LARGE = 1 << 16  # octets of a part that is written without being copied
INDEXES = 4 << 20  # octets of ChunkIndex records that are kept in memory; more are in a temporary file


class Stream:
    """What a LogWriter knows of a channel: its `id` in the file, how many messages it has (`count`), and
    whether they begin with a timestamp.
    """

    def __init__(self, channel, number):
        self.channel = channel
        self.id = number
        self.count = 0
        self.is_plain = channel.encoding != "cdr"
        self.is_stamped = False

    def published(self, moment, little, data):
        """When a message says that it was made, ns since the epoch; else when it arrived."""
        stamp = clocks.moment(data, little) if self.is_stamped else 0
        return stamp or moment


class LogWriter:
    """A log file that is being written. All its methods raise OSError, and leave a file of whole records."""

    def __init__(self, name, channels, begun, append=False):
        """Create the file with its header, or prepare it for appending. Raises errors.Failed, too.

        `begun` is when recording began, ns since the epoch; `channels` are those of which messages come: None
        to only complete an old file. An old file of that name is replaced when the header of the new one is
        on the disk.
        """
        self.name = name
        self.streams = []
        self._begun = begun
        self._synced = True
        self._failed = False
        self.end = 0  # offset after the last whole record
        self.contents = mcap.Contents()
        self._indexes = tempfile.SpooledTemporaryFile(INDEXES)
        self._schemas = {}  # (name, encoding, data): id
        self._known = {}  # (topic, schema, encoding, metadata): id of a channel
        self._file = None
        try:
            self._target = files.destination(name)
            if append and os.path.exists(name) and os.path.getsize(name):
                self._go_on(channels)
            else:
                self._create(channels)
        except (errors.Failed, OSError) as e:
            self._indexes.close()
            if self._file:
                self._file.close()
            if isinstance(e, OSError) and str(e.filename).endswith(".tmp"):
                e.filename = name  # the one that the user knows
            raise

    channels = property(lambda self: [stream.channel for stream in self.streams])

    def _create(self, channels):
        if files.is_special(self._target):
            self._file = files.open_special(self._target, 0)
            self._start(channels)
        elif os.path.exists(self._target):
            self._replace(channels)
        else:
            self._create_first(channels)

    def _create_first(self, channels):
        try:
            self._file = files.create(self._target, buffering=0)
        except FileExistsError:  # since the last look
            raise errors.Failed(text.printable(self.name), "another rtlog is recording to it")
        begun = False
        try:
            self._begin(channels, self._target)
            begun = True
        finally:  # also after Ctrl-C
            if not begun and _is_still(self._file, self._target):
                os.remove(self._target)

    def _replace(self, channels):
        with open(self._target, "rb") as old:
            self._lock(old, self._target)
            with files.Temporary(self._target, 0) as temporary:
                self._file = temporary.file
                self._begin(channels, temporary.path)
                temporary.take_place()

    def _lock(self, file, path):
        """Lock a file against other recorders.
        Raises errors.Failed, also when one of them has just replaced it.
        """
        lock(file, self.name)
        if not _is_still(file, path):
            raise errors.Failed(text.printable(self.name), "another rtlog is recording to it")

    def _begin(self, channels, path):
        """Write the header of a new file to the disk."""
        self._lock(self._file, path)
        self._start(channels)
        files.sync(self._file)

    def _start(self, channels):
        self._put([mcap.MAGIC + mcap.header("rtlog " + __version__)])
        self._begin_part(channels)

    def _begin_part(self, channels):
        """Say when this part of the recording began, and describe its channels."""
        self.describe("rtlog", {"created": str(self._begun)})
        for channel in channels:
            self.add(channel)

    def describe(self, name, texts):
        """Write a Metadata record; `texts` is a dict."""
        described = mcap.metadata_record(name, texts)
        self.contents.add_metadata(self.end, len(described), name)
        self._put([described])

    def put_gap(self, gap):
        """Record that values are missing: a gaps.Gap."""
        self.describe(gaps.NAME, gaps.to_texts(gap))

    def _go_on(self, channels):
        from rtshell_lite.datalog import logfile

        self._file = files.reopened(self._target)
        lock(self._file, self.name)
        if self._file.read(len(mcap.MAGIC)) != mcap.MAGIC:
            raise errors.Failed(text.printable(self.name), "not a log that can be appended to")
        with logfile.load(self._target) as old:
            _check(self.name, channels or [], old.channels)
            self.end = old.end
            if not self._is_torn(old.torn):
                raise errors.Failed(
                    text.printable(self.name),
                    "it is damaged %d octets before its end, which would be lost; "
                    "record to another file" % old.torn,
                )
            lacking = b""
            if not old.closed:
                self.end, lacking = old.lacking() or (old.end, b"")
            self._cut()
            self._file.seek(self.end)
            self._put([lacking])
            self.contents, self._schemas, self._known, indexes = old.contents()
        for index in indexes:
            self._indexes.write(index)
        if channels is not None:
            self._begin_part(channels)

    def _is_torn(self, size):
        """Whether the last `size` octets are what a sudden end leaves, not records after a damaged one."""
        self._file.seek(self.end)
        head = self._file.read(mcap.HEAD.size)
        if size <= CHUNK_SIZE or not head.strip(b"\0"):  # file systems leave zeros after a power failure
            return True
        kind, length = mcap.HEAD.unpack(head)
        is_cut = size - mcap.HEAD.size <= length <= mcap.LARGEST + CHUNK_SIZE
        return kind in (mcap.CHUNK, mcap.ATTACHMENT, mcap.DATA_END) and is_cut

    def add(self, channel):
        """Add a records.Channel, of which messages will come; returns its number, counted from 0."""
        type = _described(channel)
        schema = channel.schema or type and schemas.of_type(type)
        about = dict(channel.about)
        if channel.sources:
            about["sources"] = json.dumps(list(channel.sources))
        if channel.schema is None:
            about.update(type=channel.type_id, description=channel.typecode.decode("ascii", "replace"))
        stream = Stream(channel, self._channel_id(channel, schema, about))
        if type and channel.encoding == "cdr":
            stream.is_stamped = decode.place_of_timestamp(type.descriptor) == decode.FIRST
        self.streams.append(stream)
        return len(self.streams) - 1

    def _channel_id(self, channel, schema, about):
        """The id of a channel, which is written unless the file has it."""
        key = (channel.name, schema, channel.encoding, tuple(sorted(about.items())))
        if key not in self._known:
            number = max(self._known.values(), default=-1) + 1
            schema_number = self._schema_id(schema) if schema else 0
            record = mcap.channel_record(number, schema_number, channel.name, channel.encoding, about)
            self._put([record])
            self.contents.records[mcap.CHANNEL].append(record)
            self._known[key] = number
        return self._known[key]

    def _schema_id(self, schema):
        if schema not in self._schemas:
            number = max(self._schemas.values(), default=0) + 1
            record = mcap.schema_record(number, *schema)
            self._put([record])
            self.contents.records[mcap.SCHEMA].append(record)
            self._schemas[schema] = number
        return self._schemas[schema]

    def write(self, messages):
        """Append messages, each (channel number, received, little, data),
        and pass them to the operating system.
        """
        packer = mcap.Packer()
        for channel, received, little, data in messages:
            stream = self.streams[channel]
            moment = max(received, 0)
            prefix = b"" if stream.is_plain else mcap.PREFIXES[little]
            packer.add(stream.id, stream.count, moment, stream.published(moment, little, data), prefix, data)
            stream.count += 1
            if packer.size >= CHUNK_SIZE:
                self._write(packer)
                packer = mcap.Packer()
        if packer.size:
            self._write(packer)

    def _write(self, packer):
        octets, index = packer.records(list(_pieces(packer.parts)), self.end)
        self._put(octets)
        self.contents.add_chunk(packer.first, packer.last, mcap.counts(packer.times))
        self._indexes.write(index)

    def attach(self, moment, name, media_type, data):
        """Put a file into the log: `data` are its octets, `moment` is ns since the epoch."""
        record = mcap.attachment_record(moment, name, media_type, data)
        index = mcap.attachment_index(moment, name, media_type, len(data), self.end, len(record))
        self._put([record])
        self.contents.records[mcap.ATTACHMENT_INDEX].append(index)

    def _put(self, parts):
        size = 0
        self._synced = self._synced and not parts
        try:
            for piece in _pieces(parts):
                size += len(piece)
                rest = memoryview(piece)
                while rest:
                    rest = rest[self._file.write(rest) :]
        except OSError as e:
            self._failed = True  # an index would be wrong
            self._cut()
            e.filename = self.name
            raise
        self.end += size

    def _cut(self):
        """Remove the part of a chunk that was written to a full disk:
        the file must end with a whole record.
        """
        try:
            os.ftruncate(self._file.fileno(), self.end)
        except OSError:
            pass  # a pipe; a reader leaves out the torn end

    def sync(self):
        """Flush to the disk: what was written survives a power failure."""
        if self._synced or not stat.S_ISREG(os.fstat(self._file.fileno()).st_mode):
            return
        files.sync(self._file)
        self._synced = True

    def close(self):
        """Write the summary, flush to the disk, and close. Raises errors.Failed where the file has no name
        any more.
        """
        if self._file.closed:
            return
        try:
            if not self._failed:
                self._close()
            self.sync()
            check_place(self._file, self._target, self.name)
        finally:
            self._file.close()
            self._indexes.close()

    def _close(self):
        closing = mcap.Closing(self.contents, self.end)
        data_end = self.end
        self._put([closing.begin])
        self._indexes.seek(0)
        for portion in iter(lambda: self._indexes.read(CHUNK_SIZE), b""):
            self._put([closing.chunk_indexes(portion)])
        self._put([closing.end()])
        self.end = data_end


def _pieces(parts):
    """The parts, with small ones joined: a system call costs more than a copy of them."""
    small = []
    for part in parts:
        if len(part) < LARGE:
            small.append(part)
            continue
        yield b"".join(small)
        yield part
        small = []
    yield b"".join(small)


def _described(channel):
    """The datatypes.Type that a channel comes with, or None."""
    if not channel.typecode:
        return None
    try:
        return datatypes.from_bytes(channel.typecode)
    except errors.BadType:
        return None


def _check(name, channels, old):
    """Raise errors.Failed when one of the channels is in the file already, with another type."""
    types = {channel.name: channel.type_id for channel in old}
    for channel in channels:
        if types.get(channel.name, channel.type_id) != channel.type_id:
            words = (channel.name, types[channel.name], channel.type_id)
            raise errors.Failed(
                text.printable(name), "%s is of type %s in it, not %s" % tuple(map(text.printable, words))
            )


def _is_still(file, name):
    """Whether an open file still has that name."""
    return os.path.exists(name) and os.path.samestat(os.fstat(file.fileno()), os.stat(name))


def check_place(file, path, name):
    """Raise errors.Failed where a file that was written is not at its path any more; pipes and devices are
    not looked at.
    """
    if stat.S_ISREG(os.fstat(file.fileno()).st_mode) and not _is_still(file, path):
        raise errors.Failed(text.printable(name), "was moved or removed while it was recorded")


def lock(file, name):
    """Lock a file against other recorders, if its file system, and this Python, has locks. Raises
    errors.Failed.
    """
    try:
        import fcntl

        fcntl.flock(file.fileno(), fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise errors.Failed(text.printable(name), "another rtlog is recording to it")
    except (OSError, ImportError):
        pass
