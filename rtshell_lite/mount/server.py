"""The server of a mounted RTC Tree: answers the kernel's requests.
One that needs an answer of a peer is a task.
"""

import errno
import itertools
import os
import posixpath
import stat

from rtshell_lite import errors
from rtshell_lite.mount import kernel, wire
from rtshell_lite.mount.nodes import Absent, Directory, Link, FileNode
from rtshell_lite.mount.openfile import Listing, OpenFile
from rtshell_lite.net import loop
from rtshell_lite.text import printable

# The errno of a failure: that of the first class that it is of.
ERRNOS = (
    (errors.NotFound, errno.ENOENT),
    (errors.NoSuch, errno.ENOENT),
    (errors.WrongKind, errno.ENOENT),
    (errors.Unanswered, errno.ETIMEDOUT),
    (errors.Late, errno.ETIMEDOUT),
    (errors.Unread, errno.EIO),
    (errors.ConnectionRefused, errno.ECONNREFUSED),
    (errors.Gone, errno.ENXIO),
    (errors.Garbled, errno.EIO),
    (errors.Unreachable, errno.EHOSTUNREACH),
    (errors.Unsupported, errno.EOPNOTSUPP),
    (errors.BadType, errno.EOPNOTSUPP),
    (errors.BadValue, errno.EINVAL),
    (errors.BadPath, errno.EINVAL),
    (errors.Usage, errno.EINVAL),
    (errors.Refused, errno.EPERM),
    (errors.Raised, errno.EPERM),
    (errors.Failed, errno.EPERM),
)
# Of these a name that is not there is no failure worth keeping.
QUIET = wire.LOOKUP, wire.READDIR, wire.READDIRPLUS, wire.READ, wire.READLINK


def errno_of(error):
    """The errno for an exception."""
    if isinstance(error, OSError):
        return error.errno or errno.EIO
    return next((number for kind, number in ERRNOS if isinstance(error, kind)), errno.EIO)


class Server:
    """Serves a Mount on the descriptor `fd` of /dev/fuse; `ready()` is called when the kernel has begun to
    ask.

    Each request is handled by a method. It returns the payload of the reply, or a coroutine that does; None
    if it replies itself.
    """

    def __init__(self, mount, root, fd, ready):
        self.mount = mount
        self.fd = fd
        self._world = loop.world()
        self._ready = ready
        root.id = wire.ROOT
        root.lookups = 1
        self.nodes = {wire.ROOT: root}
        self._numbers = itertools.count(wire.ROOT + 1)
        self._handles = {}
        self._handle_numbers = itertools.count(1)
        # by `unique` of each request without a reply: the Task to cancel at an interrupt, or None
        self._pending = {}
        self._owner = os.getuid(), os.getgid()
        self._buffer = bytearray(wire.LONGEST)
        self._device = kernel.mounted().get(mount.directory)
        self._is_mounted = True
        self._over = loop.Wait()

    # ---- the loop ----

    async def serve(self):
        """Answer until the tree is unmounted."""
        here = loop.current()
        with self._world.mounts() as mounts:
            here.watch(self.fd, loop.READ, self._take)
            here.watch(mounts.fileno(), loop.URGENT, self._look_at_mounts)
            self.mount.tasks.start(self.mount.tidy())
            try:
                await self._over
            finally:
                here.unwatch(self.fd)
                here.unwatch(mounts.fileno())

    def _look_at_mounts(self):
        self._is_mounted = kernel.mounted().get(self.mount.directory) == self._device
        self._end_if_unused()

    def _end_if_unused(self):
        """End when it is unmounted and nothing is open;
        another mount namespace, as of a container, may keep a copy.
        """
        if not self._is_mounted and not self._handles:
            self._over.done()

    def _take(self):
        try:
            size = self._world.read_into(self.fd, self._buffer)
            self._handle(wire.request(memoryview(self._buffer)[:size]))
        except OSError as e:
            if e.errno == errno.ENODEV:
                self._over.done()
            elif e.errno not in (errno.ENOENT, errno.EAGAIN, errno.EINTR):  # interrupted before it was read
                self._over.failed(e)
        except Exception as e:
            self._over.failed(e)

    def _handle(self, request):
        if request.opcode not in wire.UNANSWERED:
            self._pending[request.unique] = None
        try:
            if request.opcode not in HANDLERS:
                raise OSError(errno.ENOSYS, "")
            answer = HANDLERS[request.opcode](self, request)
        except Exception as e:  # one request must not end all others
            self.fail(request, e)
            return
        if type(answer) is bytes:
            self.reply(request, answer)
        elif answer is not None:
            self._pending[request.unique] = self.mount.tasks.start(self._finish(request, answer))

    async def _finish(self, request, answer):
        """Reply what a coroutine returns."""
        try:
            payload = await answer
        except Exception as e:  # one request must not end all others
            self.fail(request, e)
        else:
            if payload is not None:
                self.reply(request, payload)

    # ---- answers ----

    def reply(self, request, payload=b"", error=0):
        """Answer a request; False if it is waited for no longer."""
        if self._pending.pop(request.unique, self) is self:
            return False
        try:
            self._world.write_to(self.fd, wire.reply(request.unique, payload, error))
        except OSError as e:
            if e.errno not in (errno.ENOENT, errno.ENODEV):
                raise
            return False
        return True

    def fail(self, request, error):
        """Answer a request by the errno of a failure, and keep the words;
        not of a look at a name that is not there.
        """
        if not isinstance(error, OSError) and not (isinstance(error, Absent) and request.opcode in QUIET):
            self.mount.fail(error)
        self.reply(request, error=errno_of(error))
        loop.drop_traceback(error)  # it may be raised for others, too

    def _change(self, request, node, function):
        """Make a change by function(), a coroutine function, one at a time for a node, and reply what that
        returns.

        An interrupt does not cancel it: half a change is worse than one that nobody waits for.
        """

        async def change():
            try:
                return await function()
            finally:
                if node.is_part:
                    self.mount.cache.expire()

        self.mount.change(node.where, lambda: self._finish(request, change()))

    # ---- nodes that the kernel knows ----

    def _enter(self, request, node):
        """Reply the entry of a node; from then on the kernel knows it."""
        if not self.reply(request, self._entry(node)):
            self._forget(node, 1)

    def _entry(self, node):
        """The entry of a node, which counts as a look-up."""
        if not node.id:
            node.id = next(self._numbers)
            self.nodes[node.id] = node
        node.above.known[node.name] = node
        node.lookups += 1
        return wire.entry(node.id, self._attributes(node), node.seconds)

    def _forget(self, node, count):
        """Forget a node when the kernel has."""
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

    # ---- requests ----

    def init(self, request):
        version, flags = wire.init(request.body)
        self.reply(request, wire.init_reply(version, flags))
        self._ready()

    async def lookup(self, request):
        directory = self._node(request, Directory)
        (name,) = wire.names(request.body)
        self._enter(request, await directory.find(name))

    def forget(self, request):
        for number, count in wire.forgotten(request.opcode, request.node, request.body):
            if number in self.nodes:
                self._forget(self.nodes[number], count)

    def getattr(self, request):
        node = self._node(request, FileNode)
        return wire.attributes_reply(self._attributes(node), node.seconds)

    def setattr(self, request):
        if wire.changed(request.body) & ~wire.HARMLESS:
            raise errors.Refused(self._node(request, FileNode).where, "modes and owners cannot be changed")
        return self.getattr(request)

    async def readlink(self, request):
        text = await self._node(request, Link).target()
        return text.encode("utf-8", "surrogateescape")

    def symlink(self, request):
        directory = self._node(request, Directory)
        name, target = wire.names(request.body)

        async def make():
            node = await directory.make_link(name, target)
            self.mount.cache.expire()  # before anybody hears of it
            self._enter(request, node)

        self._change(request, directory, make)

    def unlink(self, request):
        (name,) = wire.names(request.body)
        node = self._node(request, Directory).known.get(name)
        if not isinstance(node, Link):
            self.refuse(request)

        async def remove():
            await node.remove()
            return b""

        self._change(request, node, remove)

    def open(self, request):
        node = self._node(request, FileNode)
        flags = wire.opening(request.body)
        is_read = flags & os.O_ACCMODE == os.O_RDONLY
        if not is_read and not node.mode & stat.S_IWUSR:  # root is not stopped by modes
            raise OSError(errno.EACCES, "")
        handle = node.open() or OpenFile(node)
        self._reply_handle(request, handle, wire.DIRECT_IO | is_read * wire.NO_FLUSH)

    def _reply_handle(self, request, handle, flags=0):
        number = next(self._handle_numbers)
        self._handles[number] = handle
        if not self.reply(request, wire.opened(number, flags)):
            self._handles.pop(number)
            handle.close()

    def read(self, request):
        number, offset, size = wire.reading(request.body)
        if not wire.is_direct(request.body):  # sendfile would believe our sizes; programs fall back to read
            raise OSError(errno.EINVAL, "")
        return self._handles[number].read(offset, size)

    def write(self, request):
        number, data = wire.writing(request.body)
        handle = self._handles[number]
        return self._store(request, handle, handle.written(data), wire.written(len(data)))

    def flush(self, request):
        handle = self._handles[wire.handle(request.body)]
        if isinstance(handle, OpenFile):
            return self._store(request, handle, handle.flushed(), b"")
        return b""

    def _store(self, request, handle, text, payload):
        """Store what has been written, unless that is None."""
        if text is None:
            return payload

        async def store():
            await handle.store(text)
            return payload

        self._change(request, handle.node, store)
        return None

    def release(self, request):
        handle = self._handles.pop(wire.handle(request.body), None)
        self.reply(request)
        if handle is not None:
            handle.close()
        self._end_if_unused()

    def interrupt(self, request):
        unique = wire.interrupted(request.body)
        if unique in self._pending:
            task = self._pending[unique]
            self.reply(request._replace(unique=unique), error=errno.EINTR)
            if task is not None:
                task.cancel()

    def statfs(self, request):
        return wire.statfs()

    def accept(self, request):
        return b""

    def destroy(self, request):
        self.reply(request)
        self._over.done()

    def refuse(self, request):
        where = posixpath.join(
            self._node(request, FileNode).where, printable(wire.named(request.opcode, request.body))
        )
        raise errors.Refused(where, "nothing can be made, moved or removed here but connections and zombies")

    # ---- directories ----

    def opendir(self, request):
        self._node(request, Directory)
        self._reply_handle(request, Listing())

    def readdir(self, request):
        directory = self._node(request, Directory)
        number, offset, size = wire.reading(request.body)
        listing = self._handles[number]
        if not offset or listing.nodes is None:
            return self._list(request, directory, listing, offset, size)
        self._reply_entries(request, listing, offset, size)

    async def _list(self, request, directory, listing, offset, size):
        listing.nodes = await directory.list()
        self._reply_entries(request, listing, offset, size)

    def _reply_entries(self, request, listing, offset, size):
        is_plus = request.opcode == wire.READDIRPLUS
        parts = []
        entered = []
        left = size
        for i, node in enumerate(itertools.islice(listing.nodes, offset, None), offset + 1):
            name = node.name.encode("utf-8")
            left -= wire.dirent_size(name) + is_plus * wire.ENTRY_SIZE
            if left < 0:
                break
            if is_plus:
                parts.append(self._entry(node))
                entered.append(node)
            parts.append(wire.dirent(node.id or wire.UNKNOWN_INODE, i, name, node.mode))
        if not self.reply(request, b"".join(parts)):
            for node in entered:
                self._forget(node, 1)


HANDLERS = {
    wire.INIT: Server.init,
    wire.LOOKUP: Server.lookup,
    wire.FORGET: Server.forget,
    wire.BATCH_FORGET: Server.forget,
    wire.GETATTR: Server.getattr,
    wire.SETATTR: Server.setattr,
    wire.READLINK: Server.readlink,
    wire.SYMLINK: Server.symlink,
    wire.UNLINK: Server.unlink,
    wire.OPEN: Server.open,
    wire.READ: Server.read,
    wire.WRITE: Server.write,
    wire.RELEASE: Server.release,
    wire.RELEASEDIR: Server.release,
    wire.INTERRUPT: Server.interrupt,
    wire.STATFS: Server.statfs,
    wire.OPENDIR: Server.opendir,
    wire.READDIR: Server.readdir,
    wire.READDIRPLUS: Server.readdir,
    wire.FSYNC: Server.accept,
    wire.FSYNCDIR: Server.accept,
    wire.FLUSH: Server.flush,
    wire.DESTROY: Server.destroy,
}
HANDLERS.update(
    dict.fromkeys(
        (wire.MKNOD, wire.MKDIR, wire.RMDIR, wire.RENAME, wire.RENAME2, wire.LINK, wire.CREATE), Server.refuse
    )
)
