"""The disk of a simulated host: real files, of which it is known what would survive the loss of power."""

import errno
import io
import os
import stat


class Killed(BaseException):
    """Raised in a program that is no more."""


class Disk:
    """room      octets that may still be written, None without a limit
    is_failing  whether all that is written fails
    steps       after how many writes, and the like, the host loses its power; None: it does not
    """

    def __init__(self, host):
        self.host = host
        self.room = None
        self.is_failing = False
        self.steps = None
        self._safe = {}  # {inode: octets of it that are on the disk}
        self._paths = {}  # {inode: path} of the files that were written

    def file(self, descriptor, mode, buffering):
        """A file that is written, as open() makes one."""
        status = os.fstat(descriptor)
        if not stat.S_ISREG(status.st_mode):
            return open(descriptor, mode, buffering)
        raw = File(descriptor, mode.replace("b", ""))
        raw.disk = self
        if not status.st_size:  # it may be another file than the one that had this number
            self._safe[status.st_ino] = 0
        self._safe.setdefault(status.st_ino, status.st_size)
        self._paths[status.st_ino] = os.readlink(f"/proc/self/fd/{descriptor}")
        return raw if buffering == 0 else io.BufferedWriter(raw)

    def take(self, size):
        """How many octets of this many can be written. Raises OSError."""
        self._step()
        if self.is_failing:
            raise OSError(errno.EIO, os.strerror(errno.EIO))
        if self.room is None:
            return size
        taken = min(size, self.room)
        if size and not taken:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        self.room -= taken
        return taken

    def _step(self):
        if self.steps is None:
            return
        self.steps -= 1
        if self.steps == 0:
            self.host.world.tell(f"{self.host.name} loses its power")
            self.host.world.at(0, self.host.lose_power)
        if self.steps <= 0:
            raise Killed

    def sync(self, descriptor):
        self._step()
        if self.is_failing:
            raise OSError(errno.EIO, os.strerror(errno.EIO))
        status = os.fstat(descriptor)
        self._safe[status.st_ino] = status.st_size

    def replace(self, path, target):
        self._step()
        inode = os.stat(path).st_ino
        os.replace(path, target)
        self._paths[inode] = os.path.abspath(target)
        self._step()  # the new name may be on the disk before the data is

    def lose_power(self):
        """Of each file, what was written since it was last synchronised is lost, or a part of it, or is
        there as zeros.
        """
        for inode, path in self._paths.items():
            if not os.path.exists(path) or os.stat(path).st_ino != inode:
                continue
            size = os.path.getsize(path)
            safe = self._safe[inode]
            if size <= safe:
                continue
            left = self.host.world.random.randrange(safe, size + 1)
            os.truncate(path, left)
            if self.host.world.random.random() < 0.3:
                os.truncate(path, size)  # zeros


class File(io.FileIO):
    """A file on a Disk."""

    disk = None  # type: Disk

    def write(self, data):
        data = memoryview(data).cast("B")
        try:
            return super().write(data[: self.disk.take(len(data))])
        except Killed:
            super().write(data[: len(data) // 2])
            raise
