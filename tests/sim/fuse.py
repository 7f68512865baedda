"""The kernel of a simulated host where rtmount has mounted a tree: as Linux does, it asks the server for what
programs want of files, and believes what it was told for as long as it was told.
"""

import collections
import errno
import itertools
import os
import stat
import struct

from rtshell_lite.mount import wire
from rtshell_lite.net import loop

ROOT = 1
SIZE = 1 << 17  # octets that programs read at once
PAGE = 4096  # octets that they read of a directory
LONG = 1e6  # seconds: until it is answered
MOST_LINKS = 40
LOCK_OWNER = 2  # flag of READ: a program's own
OF_SIZE = 8  # of SETATTR: > empties a file first
FLAGS = 1 << 13 | 1 << 18  # of INIT: READDIRPLUS, and several requests for a directory at once
# of fuse.h, version 7.31
_REQUEST = struct.Struct("=IIQQIIIHH")
_REPLY = struct.Struct("=IiQ")
_ENTRY = struct.Struct("=QQQQIIQQQQQQIIIIIIIIII")
_ATTRIBUTES = struct.Struct("=QIIQQQQQQIIIIIIIIII")
_DIRENT = struct.Struct("=QQII")
_IO = struct.Struct("=QQIIQII")


class Descriptor:
    """What a program polls, other than a socket of TCP."""

    address = None

    def __init__(self, program):
        self.program = program
        self.host = program.host
        self.fd = next(program.world.fds)
        program.sockets[self.fd] = self

    def fileno(self):
        return self.fd

    def close(self):
        self.program.sockets.pop(self.fd, None)

    def say_no_more(self):
        """There is nobody at the other end of a network."""


class Table(Descriptor):
    """What is mounted on a host, as an open file of lines."""

    def __init__(self, program):
        super().__init__(program)
        self._seen = self.host.mount_changes

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __iter__(self):
        for directory, mount in self.host.mounts.items():
            yield f"{mount.number} 1 0:{mount.number} / {directory} rw - fuse.rtmount rtmount rw\n"

    def events(self, wanted):
        is_new = self._seen != self.host.mount_changes
        self._seen = self.host.mount_changes
        return loop.URGENT if is_new and wanted & loop.URGENT else 0


class Device(Descriptor):
    """An open /dev/fuse: the `queue` of Requests for the server, those `asked` that are not answered."""

    def __init__(self, program):
        super().__init__(program)
        self.queue = collections.deque()
        self.asked = {}  # {number: Request}
        self.is_over = False

    def events(self, wanted):
        return loop.READ if wanted & loop.READ and (self.queue or self.is_over) else 0

    def send(self, request):
        if self.is_over:
            return request.end(errno.ENOTCONN)
        self.asked[request.number] = request
        self.queue.append(request)
        self.program.wake()

    def read_into(self, buffer):
        self.program.vain = 0
        if self.is_over:
            raise OSError(errno.ENODEV, os.strerror(errno.ENODEV))
        if not self.queue:
            raise BlockingIOError(errno.EAGAIN, "nothing")
        request = self.queue.popleft()
        if request.opcode in wire.UNANSWERED:
            del self.asked[request.number]
        data = request.octets()
        buffer[: len(data)] = data
        return len(data)

    def write_to(self, data):
        size, error, number = _REPLY.unpack_from(data)
        if size != len(data) or not -512 < error <= 0 or error and size != _REPLY.size:
            raise OSError(errno.EINVAL, os.strerror(errno.EINVAL))
        if number not in self.asked:
            raise OSError(errno.ENOENT, os.strerror(errno.ENOENT))
        self.asked.pop(number).end(-error, bytes(data[_REPLY.size :]))

    def finish(self):
        """Nobody can ask any more."""
        self.is_over = True
        for request in self.asked.values():
            request.end(errno.ENOTCONN)
        self.asked.clear()
        self.queue.clear()
        self.program.wake()

    def close(self):
        super().close()
        self.finish()


class Request:
    """What the kernel asks, for a mounted.Tool that waits for it and the `path` that it uses then, or for
    itself: `begun`, `ended` (world's time), `error` as an errno, and the `payload` of the answer.
    """

    def __init__(self, mount, tool, opcode, node, body):
        self._world = mount.host.world
        self.number = next(mount.numbers)
        self.tool = tool
        self.path = tool and tool.path
        self.opcode = opcode
        self.body = body
        self._node = node
        self.begun = self._world.time
        self.ended = None
        self.error = 0
        self.payload = b""

    def octets(self):
        size = _REQUEST.size + len(self.body)
        return _REQUEST.pack(size, self.opcode, self.number, self._node, 0, 0, 4711, 0, 0) + self.body

    def end(self, error, payload=b""):
        self.ended = self._world.time
        self.error = error
        self.payload = payload
        if self.tool is not None:
            self.tool.wake()


class Inode:
    """A node that the kernel knows: how often it was told, and how many programs use it."""

    def __init__(self, number):
        self.number = number
        self.told = 0
        self.used = 0
        self.mode = 0
        self.until = 0.0  # when it asks again for mode and size


class Mount:
    """A mounted tree, at a directory of a host."""

    def __init__(self, host, device, directory):
        self.host = host
        self.device = device
        self.directory = directory
        self.number = 40 + next(host.world.fds) % 1000
        self.numbers = itertools.count(2, 2)
        self.inodes = {ROOT: Inode(ROOT)}
        self.names = {}  # {(number of a directory, name): (Inode, until when that is believed)}
        self.opened = 0
        self.is_used = True  # not unmounted
        offered = struct.pack("=IIII", 7, 31, 1 << 17, FLAGS) + bytes(48)
        self._begin = Request(self, None, wire.INIT, 0, offered)
        device.send(self._begin)

    def is_ready(self):
        return self._begin.ended is not None

    def unmount(self):
        """Nobody comes by its name any more; what is open works on."""
        self.is_used = False
        self.end_if_unused()

    def end_if_unused(self):
        if not self.is_used and not self.opened:
            self.device.finish()

    # ---- what is asked ----

    def ask(self, tool, opcode, node, body=b""):
        """The payload of an answer. Raises OSError, Struck."""
        if tool.struck and opcode != wire.FLUSH:  # which the kernel does as a program ends
            raise Struck
        request = Request(self, tool, opcode, node, body)
        tool.requests.append(request)
        self.device.send(request)
        is_interrupted = False
        while request.ended is None:
            tool.wait(LONG)
            if tool.struck and request.ended is None and not is_interrupted:
                is_interrupted = True
                self._interrupt(request)
        if request.error == errno.EINTR and is_interrupted:
            raise Struck
        if request.error:
            raise OSError(request.error, os.strerror(request.error))
        return request.payload

    def _interrupt(self, request):
        if request in self.device.queue:
            self.device.queue.remove(request)
            del self.device.asked[request.number]
            return request.end(errno.EINTR)
        self.tell(wire.INTERRUPT, 0, struct.pack("=Q", request.number))

    def tell(self, opcode, node, body):
        """What nobody waits for."""
        self.device.send(Request(self, None, opcode, node, body))

    # ---- nodes ----

    def _enter(self, directory, name, entry):
        """The Inode of an entry that the server has told, by the first octets of its payload."""
        number, _, seconds, valid, nanoseconds, more = _ENTRY.unpack_from(entry)[:6]
        inode = self.inodes.setdefault(number, Inode(number))
        inode.told += 1
        now = self.host.world.time
        inode.mode = _ENTRY.unpack_from(entry)[15]
        inode.until = now + valid + more / 1e9
        known, _ = self.names.get((directory.number, name), (None, 0))
        self.names[directory.number, name] = inode, now + seconds + nanoseconds / 1e9
        if known is not None and known is not inode:
            self._forget_unused([known])
        return inode

    def look_up(self, tool, directory, name):
        """The Inode of a name. Raises OSError."""
        known, until = self.names.get((directory.number, name), (None, 0))
        if known is not None and until > self.host.world.time:
            return known
        try:
            entry = self.ask(tool, wire.LOOKUP, directory.number, name.encode() + b"\0")
        except OSError:
            self._drop(directory, name)
            raise
        return self._enter(directory, name, entry)

    def _drop(self, directory, name):
        known, _ = self.names.pop((directory.number, name), (None, 0))
        if known is not None:
            self._forget_unused([known])

    def forget_all(self):
        """Memory is short: forget what nobody uses."""
        self._forget_unused(list(self.inodes.values()))

    def _forget_unused(self, inodes):
        for inode in inodes:
            below = [key for key in self.names if key[0] == inode.number]
            if inode.used or inode.number == ROOT or any(self.names[key][0].used for key in below):
                continue
            for key in below:
                self._forget_unused([self.names.pop(key)[0]])
            for key in [key for key, (known, _) in self.names.items() if known is inode]:
                del self.names[key]
            if self.inodes.pop(inode.number, None) is inode:
                self.tell(wire.FORGET, inode.number, struct.pack("=Q", inode.told))

    def walk(self, tool, names):
        """The Inode that names lead to from the root, links followed. Raises OSError."""
        way = [self.inodes[ROOT]]
        left = collections.deque(names)
        links = 0
        while left:
            name = left.popleft()
            if name == "..":
                way = way[:-1] or way
                continue
            found = tool.use(self.look_up(tool, way[-1], name))
            if not stat.S_ISLNK(found.mode):
                way.append(found)
                continue
            links += 1
            if links > MOST_LINKS:
                raise OSError(errno.ELOOP, os.strerror(errno.ELOOP))
            target = self.ask(tool, wire.READLINK, found.number).decode()
            left.extendleft(reversed(target.split("/")))
        return way[-1]

    # ---- system calls ----

    def attributes(self, tool, inode):
        """The mode of an Inode."""
        if inode.until <= self.host.world.time:
            found = _ATTRIBUTES.unpack(self.ask(tool, wire.GETATTR, inode.number, bytes(16)))
            inode.until = self.host.world.time + found[0] + found[1] / 1e9
            inode.mode = found[12]
        return inode.mode

    def open(self, tool, inode, opcode, flags=os.O_RDONLY):
        """The number of an open file or directory."""
        opened = self.ask(tool, opcode, inode.number, struct.pack("=II", flags, 0))
        self.opened += 1
        number, _, _ = struct.unpack("=QII", opened)
        return number

    def close(self, inode, opcode, handle):
        self.opened -= 1
        self.tell(opcode, inode.number, struct.pack("=QIIQ", handle, 0, 0, 0))
        self.end_if_unused()

    def read(self, tool, inode):
        """All that is in a file."""
        handle = self.open(tool, inode, wire.OPEN)
        try:
            data = b""
            while True:
                body = _IO.pack(handle, len(data), SIZE, LOCK_OWNER, 1, 0, 0)
                more = self.ask(tool, wire.READ, inode.number, body)
                if not more:
                    return data
                data += more
        finally:
            self.close(inode, wire.RELEASE, handle)

    def write(self, tool, inode, data):
        """What a shell does for echo and >; how many octets are written."""
        handle = self.open(tool, inode, wire.OPEN, os.O_WRONLY)
        try:
            self.ask(tool, wire.SETATTR, inode.number, struct.pack("=I", OF_SIZE) + bytes(84))
            body = _IO.pack(handle, 0, len(data), 0, 0, os.O_WRONLY, 0) + data
            self.ask(tool, wire.WRITE, inode.number, body)
            return len(data)
        finally:
            try:
                self.ask(tool, wire.FLUSH, inode.number, struct.pack("=QIIQ", handle, 0, 0, 0))
            finally:
                self.close(inode, wire.RELEASE, handle)

    def list(self, tool, inode):
        """[(name, Inode)] of a directory."""
        handle = self.open(tool, inode, wire.OPENDIR)
        found = []
        try:
            offset = 0
            while True:
                body = _IO.pack(handle, offset, PAGE, 0, 0, 0, 0)
                page = self.ask(tool, wire.READDIRPLUS, inode.number, body)
                if not page:
                    return found
                for offset, name, entry in _entries(page):
                    found.append((name, tool.use(self._enter(inode, name, entry))))
        finally:
            self.close(inode, wire.RELEASEDIR, handle)


def _entries(page):
    """(offset of the next one, name, entry) in a reply to READDIRPLUS."""
    at = 0
    while at < len(page):
        entry = page[at : at + _ENTRY.size]
        at += _ENTRY.size
        _, offset, size, _ = _DIRENT.unpack_from(page, at)
        at += _DIRENT.size
        yield offset, page[at : at + size].decode(), entry
        at += size + -size % 8


class Struck(Exception):
    """A signal ends a program that waits for the server."""


def mount(host, source, directory, kind, flags, options):
    """mount(2)"""
    number = int(options.decode().partition("fd=")[2].partition(",")[0])
    devices = [program.sockets[number] for program in host.world.programs if number in program.sockets]
    directory = os.fsdecode(directory)
    host.mounts[directory] = Mount(host, devices[0], directory)
    _tell_change(host)


def umount2(host, directory, flags):
    """umount2(2)"""
    host.mounts.pop(os.fsdecode(directory)).unmount()
    _tell_change(host)


def _tell_change(host):
    host.mount_changes += 1
    for program in host.world.programs:
        if program.host is host:
            program.wake()


CALLS = {"mount": mount, "umount2": umount2}
