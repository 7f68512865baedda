"""The server of a mounted RTC Tree: answers the kernel's requests, on one thread where it can, on those of a Crew where peers
have to be asked. What waits is a record, not a thread.
"""
import errno
import itertools
import os
import posixpath
import select
import signal
import stat
import sys
import threading

from rtshell_lite import errors
from rtshell_lite.mount import kernel, wire
from rtshell_lite.mount.nodes import Absent, Directory, Link, Node
from rtshell_lite.mount.opened import Listing, Opened
from rtshell_lite.text import printable

SWITCH = 0.0005  # seconds between switches of Python's threads: with the default, 0.005, requests wait for those that ask
SWEEP = 1.0  # seconds between two looks for what is not needed any more

# The errno of a failure: that of the first class that it is of.
ERRNOS = (
    (errors.NotFound, errno.ENOENT), (errors.NoSuch, errno.ENOENT), (errors.WrongKind, errno.ENOENT),
    (errors.Silent, errno.ETIMEDOUT), (errors.Late, errno.ETIMEDOUT), (errors.Unread, errno.EIO),
    (errors.ConnectionRefused, errno.ECONNREFUSED), (errors.Gone, errno.ENXIO), (errors.Garbled, errno.EIO),
    (errors.Unreachable, errno.EHOSTUNREACH), (errors.Unsupported, errno.EOPNOTSUPP), (errors.BadType, errno.EOPNOTSUPP),
    (errors.BadValue, errno.EINVAL), (errors.BadPath, errno.EINVAL), (errors.Usage, errno.EINVAL),
    (errors.Refused, errno.EPERM), (errors.Failed, errno.EPERM))
# Of these a name that is not there is no failure worth keeping.
QUIET = wire.LOOKUP, wire.READDIR, wire.READDIRPLUS, wire.READ, wire.READLINK


def errno_of(error):
    """The errno for an exception."""
    if isinstance(error, OSError):
        return error.errno or errno.EIO
    return next((number for kind, number in ERRNOS if isinstance(error, kind)), errno.EIO)


class Waiting:
    """In a `with` statement on the main thread: wait() until there is something to read from a descriptor, or mounts have changed.

    A signal ends it, too, if it comes just before, or if the kernel hands it to another thread: a blocking read would go on, and
    nobody would hear the signal before the next request.
    """

    def __init__(self, fd):
        self._poll = select.poll()
        self._mounts = open(kernel.MOUNTS)
        self._bell, self._rope = os.pipe()
        for each in (fd, self._bell, self._rope):
            os.set_blocking(each, False)
        self._poll.register(fd, select.POLLIN)
        self._poll.register(self._bell, select.POLLIN)
        self._poll.register(self._mounts, select.POLLPRI)

    def __enter__(self):
        self._before = signal.set_wakeup_fd(self._rope)
        return self

    def __exit__(self, *_):
        signal.set_wakeup_fd(self._before)
        os.close(self._bell)
        os.close(self._rope)
        self._mounts.close()

    def wait(self):
        """Returns whether something has been mounted or unmounted."""
        ready = [fd for fd, _ in self._poll.poll()]
        if self._bell in ready:
            os.read(self._bell, 64)
        return self._mounts.fileno() in ready


class Server:
    """Serves a Mount on the descriptor `fd` of /dev/fuse; `ready()` is called when the kernel has begun to ask."""

    def __init__(self, mount, root, fd, ready):
        self.mount, self.fd, self._ready = mount, fd, ready
        root.id, root.lookups = wire.ROOT, 1
        self.nodes, self._numbers = {wire.ROOT: root}, itertools.count(wire.ROOT + 1)
        self._handles, self._handle_numbers = {}, itertools.count(1)
        self._pending = {}  # requests that are not answered yet, by `unique`: their handle or None
        self._guard = threading.Lock()
        self._owner = os.getuid(), os.getgid()
        self._ended = threading.Event()

    # ---- the loop ---------------------------------------------------------------------------------------------

    def serve(self):
        """Answer until the tree is unmounted."""
        sys.setswitchinterval(SWITCH)
        threading.Thread(target=self._tidy, daemon=True).start()
        with Waiting(self.fd) as waiting:
            self._serve(waiting, bytearray(wire.LONGEST))

    def _serve(self, waiting, buffer):
        view, device, is_mounted = memoryview(buffer), kernel.mounted().get(self.mount.directory), True
        while is_mounted or self._handles:  # another mount namespace, as of a container, may keep a copy
            if waiting.wait():
                is_mounted = kernel.mounted().get(self.mount.directory) == device
            try:
                size = os.readv(self.fd, [buffer])
            except OSError as e:
                if e.errno in (errno.ENOENT, errno.EAGAIN, errno.EINTR):  # interrupted before it was read
                    continue
                if e.errno == errno.ENODEV:
                    return
                raise
            request = wire.request(view[:size])
            if request.opcode not in wire.UNANSWERED:
                self._pending[request.unique] = None
            self._answer(request)
            if request.opcode == wire.DESTROY:
                return

    def _answer(self, request):
        handler = HANDLERS.get(request.opcode)
        try:
            if handler is None:
                raise OSError(errno.ENOSYS, "")
            handler(self, request)
        except Exception as e:  # one request must not end all others
            self.fail(request, e)

    def _tidy(self):
        while not self._ended.wait(SWEEP):
            self.mount.kept.sweep()
            self.mount.census.sweep()
            for stream in list(self.mount.streams):
                stream.look()

    # ---- answers ----------------------------------------------------------------------------------------------

    def reply(self, request, payload=b"", error=0):
        """Answer a request; False if it is waited for no longer."""
        with self._guard:
            if self._pending.pop(request.unique, self) is self:
                return False
        try:
            os.write(self.fd, wire.reply(request.unique, payload, error))
        except OSError as e:
            if e.errno not in (errno.ENOENT, errno.ENODEV):
                raise
            return False
        return True

    def fail(self, request, error):
        """Answer a request by the errno of a failure, and keep the words; not of a look at a name that is not there."""
        if not isinstance(error, OSError) and not (isinstance(error, Absent) and request.opcode in QUIET):
            self.mount.fail(error)
        self.reply(request, error=errno_of(error))

    def when(self, request, source, function):
        """Reply function(value of the Source), bytes, as soon as it is there."""
        value = source.now()
        if value is not None:
            self.reply(request, function(value))
        else:
            source.want(lambda value: self._arrived(request, function, value))

    def _arrived(self, request, function, value):
        try:
            if isinstance(value, Exception):
                raise value
            payload = function(value)
        except Exception as e:  # on a thread that others need
            self.fail(request, e)
        else:
            self.reply(request, payload)

    def change(self, request, node, function, payload=b""):
        """Call function() on a thread that may ask, one at a time for a peer's node, and reply `payload` or what it returns."""
        def changed(_):
            try:
                return function() or payload
            finally:
                if node.is_part:
                    self.mount.kept.expire()

        def run():
            self._arrived(request, changed, None)
        self.mount.changes.start(("change", node.where), run, most=1)

    # ---- nodes that the kernel knows --------------------------------------------------------------------------

    def _entered(self, request, source, find):
        """Reply the entry of the node that find(value) gives; from then on the kernel knows it."""
        def reply(value):
            with self.mount.lock:
                node = find(value)
                payload = self._entry(node)
                if not self.reply(request, payload):
                    self._forget(node, 1)
            return None
        value = source.now()
        if value is not None:
            reply(value)
        else:
            source.want(lambda value: self._arrived_entry(request, reply, value))

    def _arrived_entry(self, request, function, value):
        try:
            if isinstance(value, Exception):
                raise value
            function(value)
        except Exception as e:  # on a thread that others need
            self.fail(request, e)

    def _entry(self, node):
        """The entry of a node, which counts as a look-up; the lock is held."""
        if not node.id:
            node.id = next(self._numbers)
            self.nodes[node.id] = node
        node.above.known[node.name] = node
        node.lookups += 1
        return wire.entry(node.id, self._attributes(node), node.seconds)

    def _forget(self, node, count):
        """Forget a node when the kernel has; the lock is held."""
        node.lookups -= count
        if node.lookups <= 0 and node.id != wire.ROOT:
            self.nodes.pop(node.id, None)
            if node.above.known.get(node.name) is node:
                del node.above.known[node.name]

    def _attributes(self, node):
        mode = node.mode & ~0o222 if self.mount.read_only else node.mode
        return wire.attributes(node.id, mode, *self._owner, node.size, self.mount.began)

    def _node(self, request, kind):
        node = self.nodes.get(request.node)
        if not isinstance(node, kind):
            raise OSError(errno.ENOENT, "")
        return node

    # ---- requests ---------------------------------------------------------------------------------------------

    def init(self, request):
        version, flags = wire.init(request.body)
        self.reply(request, wire.init_reply(version, flags))
        self._ready()

    def lookup(self, request):
        directory = self._node(request, Directory)
        name, = wire.names(request.body)
        self._entered(request, *directory.find(name))

    def forget(self, request):
        with self.mount.lock:
            for number, count in wire.forgotten(request.opcode, request.node, request.body):
                if number in self.nodes:
                    self._forget(self.nodes[number], count)

    def getattr(self, request):
        node = self._node(request, Node)
        self.reply(request, wire.attributes_reply(self._attributes(node), node.seconds))

    def setattr(self, request):
        if wire.changed(request.body) & ~wire.HARMLESS:
            raise errors.Refused(self._node(request, Node).where, "modes and owners cannot be changed")
        self.getattr(request)

    def readlink(self, request):
        source, render = self._node(request, Link).target()
        self.when(request, source, lambda value: render(value).encode("utf-8", "surrogateescape"))

    def symlink(self, request):
        directory = self._node(request, Directory)
        name, target = wire.names(request.body)

        def make():
            node = directory.make_link(name, target)
            self.mount.kept.expire()
            with self.mount.lock:
                if not self.reply(request, self._entry(node)):
                    self._forget(node, 1)
        self.change(request, directory, make)

    def unlink(self, request):
        name, = wire.names(request.body)
        node = self._node(request, Directory).known.get(name)
        if not isinstance(node, Link):
            self.refuse(request)
        self.change(request, node, node.remove)

    def open(self, request):
        node = self._node(request, Node)
        flags = wire.opening(request.body)
        is_read = flags & os.O_ACCMODE == os.O_RDONLY
        if not is_read and not node.mode & stat.S_IWUSR:  # root is not stopped by modes
            raise OSError(errno.EACCES, "")
        handle = node.open() or Opened(node)
        self._reply_handle(request, handle, wire.DIRECT_IO | is_read * wire.NO_FLUSH)

    def _reply_handle(self, request, handle, flags=0):
        number = next(self._handle_numbers)
        self._handles[number] = handle
        if not self.reply(request, wire.opened(number, flags)):
            self._handles.pop(number)
            handle.close()

    def read(self, request):
        number, offset, size = wire.reading(request.body)
        if not wire.is_direct(request.body):  # sendfile would take our sizes for true; programs then read as they do elsewhere
            raise OSError(errno.EINVAL, "")
        handle = self._handles[number]
        self._pending[request.unique] = handle
        handle.read(self, request, offset, size)

    def write(self, request):
        number, data = wire.writing(request.body)
        self._handles[number].write(self, request, data)

    def flush(self, request):
        handle = self._handles[wire.handle(request.body)]
        if not isinstance(handle, Opened):
            return self.reply(request)
        handle.flush(self, request)

    def release(self, request):
        handle = self._handles.pop(wire.handle(request.body), None)
        self.reply(request)
        if handle is not None:
            handle.close()

    def interrupt(self, request):
        unique = wire.interrupted(request.body)
        if unique in self._pending:
            handle = self._pending[unique]
            self.reply(request._replace(unique=unique), error=errno.EINTR)
            if handle is not None:
                handle.interrupt(unique)

    def statfs(self, request):
        self.reply(request, wire.statfs())

    def done(self, request):
        self.reply(request)

    def refuse(self, request):
        where = posixpath.join(self._node(request, Node).where, printable(wire.named(request.opcode, request.body)))
        raise errors.Refused(where, "nothing can be made, moved or removed here but connections and zombies")

    # ---- directories ------------------------------------------------------------------------------------------

    def opendir(self, request):
        self._node(request, Directory)
        self._reply_handle(request, Listing())

    def readdir(self, request):
        directory = self._node(request, Directory)
        number, offset, size = wire.reading(request.body)
        listing = self._handles[number]
        if offset and listing.nodes is not None:
            return self._reply_entries(request, listing, offset, size)
        source, make = directory.list()

        def entries(value):
            with self.mount.lock:
                listing.nodes = make(value)
            self._reply_entries(request, listing, offset, size)
        value = source.now()
        if value is not None:
            entries(value)
        else:
            source.want(lambda value: self._arrived_entry(request, entries, value))

    def _reply_entries(self, request, listing, offset, size):
        plus, parts, length = request.opcode == wire.READDIRPLUS, [], 0
        nodes = []
        with self.mount.lock:
            for i, node in enumerate(itertools.islice(listing.nodes, offset, None), offset + 1):
                name = node.name.encode("utf-8")
                part = wire.dirent(node.id or wire.UNKNOWN_INODE, i, name, node.mode)
                if length + len(part) + plus * wire.ENTRY_SIZE > size:
                    break
                if plus:
                    parts.append(self._entry(node))
                    nodes.append(node)
                    part = wire.dirent(node.id, i, name, node.mode)
                parts.append(part)
                length += len(part) + plus * wire.ENTRY_SIZE
            if not self.reply(request, b"".join(parts)):
                for node in nodes:
                    self._forget(node, 1)

    def close(self):
        """Disconnect everything, after the end of `serve`."""
        self._ended.set()
        closing = [threading.Thread(target=stream.close, daemon=True) for stream in list(self.mount.streams)]
        for thread in closing:
            thread.start()
        for thread in closing:
            thread.join()


HANDLERS = {
    wire.INIT: Server.init, wire.LOOKUP: Server.lookup, wire.FORGET: Server.forget, wire.BATCH_FORGET: Server.forget,
    wire.GETATTR: Server.getattr, wire.SETATTR: Server.setattr, wire.READLINK: Server.readlink, wire.SYMLINK: Server.symlink,
    wire.UNLINK: Server.unlink, wire.OPEN: Server.open, wire.READ: Server.read, wire.WRITE: Server.write,
    wire.RELEASE: Server.release, wire.RELEASEDIR: Server.release, wire.INTERRUPT: Server.interrupt, wire.STATFS: Server.statfs,
    wire.OPENDIR: Server.opendir, wire.READDIR: Server.readdir, wire.READDIRPLUS: Server.readdir, wire.FSYNC: Server.done,
    wire.FSYNCDIR: Server.done, wire.FLUSH: Server.flush, wire.DESTROY: Server.done}
HANDLERS.update(dict.fromkeys((wire.MKNOD, wire.MKDIR, wire.RMDIR, wire.RENAME, wire.RENAME2, wire.LINK, wire.CREATE),
                              Server.refuse))
