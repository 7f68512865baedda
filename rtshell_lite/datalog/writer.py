"""Writing log files."""

import os
import stat

from rtshell_lite import __version__, errors, files, text
from rtshell_lite.datalog import blocks
from rtshell_lite.datalog.index import Index

CHUNK = 1 << 20  # octets given to the operating system at once
LARGE = 1 << 16  # octets of a part that is written without being copied


class Writer:
    """A log file that is being written. All its methods raise OSError, and leave a file of whole records."""

    def __init__(self, name, channels, begun, append=False):
        """Create the file with its header, or prepare it for appending. Raises errors.Failed, too.

        `begun` is when recording began, ns since the epoch. An old file of that name is replaced when the
        header of the new one is on the disk.
        """
        self.name = name
        self.channels = channels
        self._synced = True
        self._failed = False
        # end: offset after the last whole block
        self.index = Index()
        self.end = 0
        header = blocks.text(
            blocks.HEADER,
            {
                "created": begun,
                "program": "rtlog " + __version__,
                "channels": [
                    {
                        "name": channel.name,
                        "type": channel.type_id,
                        "sources": list(channel.sources),
                        "typecode": channel.typecode.hex() if channel.typecode else None,
                    }
                    for channel in channels
                ],
            },
        )
        self._file = None
        try:
            self._target = files.destination(name)
            if append and os.path.exists(name) and os.path.getsize(name):
                self._go_on(header)
            else:
                self._create(header)
        except (errors.Failed, OSError) as e:
            if self._file:
                self._file.close()
            if isinstance(e, OSError) and str(e.filename).endswith(".tmp"):
                e.filename = name  # the one that the user knows
            raise

    def _create(self, header):
        if files.is_special(self._target):
            self._file = files.open_special(self._target, 0)
            self._start(header)
        elif os.path.exists(self._target):
            self._replace(header)
        else:
            self._create_first(header)

    def _create_first(self, header):
        try:
            self._file = files.create(self._target, buffering=0)
        except FileExistsError:  # since the last look
            raise errors.Failed(text.printable(self.name), "another rtlog is recording to it")
        begun = False
        try:
            self._begin(header, self._target)
            begun = True
        finally:  # also after Ctrl-C
            if not begun and _is_still(self._file, self._target):
                os.remove(self._target)

    def _replace(self, header):
        with open(self._target, "rb") as old:
            self._lock(old, self._target)
            temporary = files.Temporary(self._target, 0)
            try:
                self._file = temporary.file
                self._begin(header, temporary.path)
                temporary.take_place()
            finally:
                temporary.remove()

    def _lock(self, file, path):
        """Lock a file against other recorders.
        Raises errors.Failed, also when one of them has just replaced it.
        """
        lock(file, self.name)
        if not _is_still(file, path):
            raise errors.Failed(text.printable(self.name), "another rtlog is recording to it")

    def _begin(self, header, path):
        """Write the header of a new file to the disk."""
        self._lock(self._file, path)
        self._start(header)
        os.fsync(self._file.fileno())

    def _start(self, header):
        self._put([blocks.MAGIC])
        self.index.headers.append(self.end)
        self._put([header])

    def _go_on(self, header):
        from rtshell_lite.datalog import reader

        self._file = open(self._target, "r+b", 0)
        lock(self._file, self.name)
        if self._file.read(len(blocks.MAGIC)) != blocks.MAGIC:
            raise errors.Failed(text.printable(self.name), "not a log that can be appended to")
        size = os.fstat(self._file.fileno()).st_size
        with open(self._target, "rb") as file:
            old = reader.Log(file, text.printable(self.name), size)
            self._check(old.channels)
            self.end = old.scan(self.index)
            if not self._is_torn(old.torn):
                raise errors.Failed(
                    text.printable(self.name),
                    "it is damaged %d octets before its end, which would be lost; "
                    "record to another file" % old.torn,
                )
        os.ftruncate(self._file.fileno(), self.end)
        self._file.seek(self.end)
        self.index.headers.append(self.end)
        self._put([header])

    def _is_torn(self, size):
        """Whether the last `size` octets are what a sudden end leaves, not records after a damaged one."""
        self._file.seek(self.end)
        head = self._file.read(blocks.BLOCK.size)
        if size <= CHUNK or not head.strip(b"\0"):  # file systems leave zeros after a power failure
            return True
        kind, length, _ = blocks.BLOCK.unpack(head)
        return (
            kind == blocks.RECORD and size - blocks.BLOCK.size <= length <= blocks.ENTRY.size + blocks.LARGEST
        )

    def _check(self, old):
        types = {channel.name: channel.type_id for channel in old}
        for channel in self.channels:
            if types.get(channel.name, channel.type_id) != channel.type_id:
                raise errors.Failed(
                    text.printable(self.name),
                    "%s is of type %s in it, not %s"
                    % (
                        text.printable(channel.name),
                        text.printable(types[channel.name]),
                        text.printable(channel.type_id),
                    ),
                )

    def write(self, messages):
        """Append messages, each (channel number, received, little, data),
        and pass them to the operating system.
        """
        parts = []
        size = 0
        for channel, received, little, data in messages:
            block = blocks.entry(self.index.next, received, channel, little, data)
            self.index.add(self.end + size, self.index.next, received, self.channels[channel].name)
            parts += block
            size += sum(map(len, block))
            if size >= CHUNK:
                self._put(parts)
                parts = []
                size = 0
        self._put(parts)

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
        os.fsync(self._file.fileno())
        self._synced = True

    def close(self):
        """Write the index, flush to the disk, and close."""
        try:
            if not self._failed:
                self._put([self.index.block(self.end)])
            self.sync()
        finally:
            self._file.close()


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


def _is_still(file, name):
    """Whether an open file still has that name."""
    return os.path.exists(name) and os.path.samestat(os.fstat(file.fileno()), os.stat(name))


def lock(file, name):
    """Lock a file against other recorders, if its file system has locks. Raises errors.Failed."""
    import fcntl

    try:
        fcntl.flock(file.fileno(), fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise errors.Failed(text.printable(name), "another rtlog is recording to it")
    except OSError:
        pass
