"""One rtkeep for a file, and the door by which others ask and steer it: a UNIX socket beside a lock.

A request and each line of its answer are JSON. The first line of an answer has `error`, a text or null.
"""

import contextlib
import fcntl
import json
import os
import stat
import zlib

from rtshell_lite import errors
from rtshell_lite.net import loop, tcp
from rtshell_lite.text import json_line, printable

PATIENCE = 3.0  # seconds that either side waits for the other
LONGEST = 1 << 20  # octets of a request


def _directory():
    runtime = os.environ.get("XDG_RUNTIME_DIR")
    if runtime and os.path.isdir(runtime):
        return os.path.join(runtime, "rtkeep")
    return "/tmp/rtkeep-%d" % os.geteuid()


def directory():
    """The private directory of this user for locks and sockets.
    Raises OSError, Failed where it is not ours.
    """
    path = _directory()
    with contextlib.suppress(FileExistsError):
        os.mkdir(path, 0o700)
    status = os.lstat(path)
    is_ours = stat.S_ISDIR(status.st_mode) and status.st_uid == os.geteuid()
    if not is_ours or status.st_mode & 0o077:
        raise errors.Failed(path, "not a directory of ours that nobody else can write to")
    return path


def stem(name):
    """The path, without its ending, of the lock and the socket for a file."""
    real = os.path.realpath(name)
    base = os.path.basename(real).encode("utf-8", "surrogateescape")[:40].decode("utf-8", "ignore")
    return os.path.join(directory(), "%s-%08x" % (base, zlib.crc32(os.fsencode(real))))


class Lock:
    """Held by the one rtkeep of a file until its process ends. Raises Failed, which names the other one."""

    def __init__(self, name):
        self.path = stem(name) + ".lock"
        while not self._take(name):
            pass
        os.ftruncate(self.fd, 0)
        os.write(self.fd, b"%d\n" % loop.world().own_pid())

    def _take(self, name):
        """Whether we hold the lock, and not that of a file that its holder has just removed."""
        flags = os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW | os.O_CLOEXEC
        self.fd = os.open(self.path, flags, 0o600)
        try:
            fcntl.flock(self.fd, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            other = os.read(self.fd, 20).decode("ascii", "replace").strip()
            os.close(self.fd)
            raise errors.Failed(printable(name), f"is kept already, by process {printable(other)}")
        try:
            is_there = os.path.samestat(os.stat(self.path), os.fstat(self.fd))
        except FileNotFoundError:
            is_there = False
        if not is_there:
            os.close(self.fd)
        return is_there

    def release(self):
        """Let another one have it, and leave no file."""
        with contextlib.suppress(OSError):  # /tmp may have been cleaned
            os.unlink(self.path)
        os.close(self.fd)


class Door:
    """Answers requests: `async with Door(name, answer):`; answer(request) returns the lines, dicts, of an
    answer.

    It may raise errors.Error.
    """

    def __init__(self, name, answer):
        self.path = stem(name) + ".socket"
        self.answer = answer
        self._listener = None
        self._group = None

    async def __aenter__(self):
        self._remove()  # that of one that was killed: we hold the lock
        self._listener = loop.world().local()
        self._listener.setblocking(False)
        before = os.umask(0o177)
        try:
            self._listener.bind(self.path)
        except OSError as e:  # the path may be too long, which has no strerror
            raise errors.Failed(printable(self.path), e.strerror or str(e))
        finally:
            os.umask(before)
        self._listener.listen(8)
        self._group = loop.Group()
        self._group.start(self._open())
        return self

    async def __aexit__(self, kind, error, traceback):
        self._group.cancel()
        try:
            return await self._group.__aexit__(kind, error, traceback)
        finally:
            self._listener.close()
            self._remove()

    def _remove(self):
        with contextlib.suppress(FileNotFoundError):  # /tmp may have been cleaned
            os.unlink(self.path)

    async def _open(self):
        while True:
            await loop.ready(self._listener.fileno(), loop.READ)
            try:
                connection, _ = self._listener.accept()
            except OSError:
                continue
            self._group.start(self._serve(connection))

    async def _serve(self, connection):
        with connection:
            connection.setblocking(False)
            await loop.race(self._exchange(connection), loop.sleep(PATIENCE))

    async def _exchange(self, connection):
        try:
            request = await _received(connection, b"\n")
        except OSError:
            return
        try:
            lines = [dict(error=None)] + self.answer(json.loads(request))
        except errors.Error as e:
            lines = [dict(error=str(e))]
        except OSError as e:  # of a file that is to be read again
            lines = [dict(error=f"{e.filename}: {e.strerror}")]
        except (ValueError, KeyError, TypeError, RecursionError):
            lines = [dict(error="not understood")]
        await _send(connection, "".join(json_line(line) + "\n" for line in lines))


async def _received(connection, end=None):
    """What comes, as text, up to this end of a line, and LONGEST; else all until the other side closes."""
    data = b""
    while end is None or not data.endswith(end) and len(data) < LONGEST:
        piece = await tcp.receive(connection, 1 << 16)
        if not piece:
            break
        data += piece
    return data.decode("utf-8", "replace")


async def _send(connection, text):
    data = text.encode("utf-8", "surrogateescape")
    while data:
        await loop.ready(connection.fileno(), loop.WRITE)
        try:
            data = data[connection.send(data) :]
        except OSError:
            return


# ---- asking ----


def running():
    """The paths of the sockets of all rtkeeps of this user, sorted. Raises as `directory` does; makes
    nothing.
    """
    if not os.path.isdir(_directory()):
        return []
    where = directory()
    names = [name for name in os.listdir(where) if name.endswith(".socket")]
    return sorted(os.path.join(where, name) for name in names)


async def ask(door, request):
    """The lines, dicts, that the rtkeep at the socket `door` answers. Raises its errors.Error, Silent;
    ConnectionRefused where none is.
    """
    name = printable(os.path.basename(door))
    with loop.world().local() as connection:
        connection.setblocking(False)
        try:
            connection.connect(door)
        except BlockingIOError:  # its process is stopped, and many wait for it
            raise errors.Silent(name, "too many wait for it")
        except OSError:
            raise errors.ConnectionRefused(name)
        lines = []

        async def exchange():
            await _send(connection, json_line(request) + "\n")
            answer = await _received(connection)
            lines.extend([json.loads(line) for line in answer.splitlines()])  # of a part of one: nothing

        silence = errors.Silent(name, f"no answer within {PATIENCE:g}s")
        try:
            await loop.within(PATIENCE, exchange(), silence)
        except (OSError, ValueError):  # it has ended meanwhile; a part of a line
            pass
    if not lines:
        raise errors.ConnectionRefused(name)
    if lines[0]["error"]:
        raise errors.Error(printable(lines[0]["error"]))
    return lines[1:]


async def marks():
    """{path of a component: what its rtkeep says of it, in a word or two}, of all rtkeeps of this user."""
    words = {}  # type: dict
    try:
        doors = running()
    except (OSError, errors.Error):
        return words
    for door in doors:
        try:
            lines = await ask(door, {"command": "status", "names": []})
        except errors.Error:
            continue
        for line in lines:
            if line["kind"] == "component":
                words[line["object"]] = _mark(line)
    return words


def _mark(line):
    if line["wanted"] == "paused":
        return "paused"
    if line["given_up"]:
        return "given up"
    if line["by_hand"]:
        return "left alone"
    return "kept"


# ---- the service manager of the system ----


def notify(**said):
    """Tell systemd, or who speaks its protocol, how it is: READY=1, STATUS=…, WATCHDOG=1 (sd_notify(3)).
    False if its socket is full, as it does not read: rtkeep goes on without it.
    """
    where = os.environ.get("NOTIFY_SOCKET")
    if not where:
        return True
    if where[0] == "@":
        where = "\0" + where[1:]
    message = "\n".join(f"{name}={value}" for name, value in said.items())
    try:
        loop.world().tell(where, message.encode("utf-8", "replace"))
    except BlockingIOError:
        return False
    except OSError:
        pass
    return True


def watchdog():
    """Seconds between the signs of life that the service manager wants, or None."""
    # it is meant for another process
    if os.environ.get("WATCHDOG_PID", str(os.getpid())) != str(os.getpid()):
        return None
    try:
        return int(os.environ.get("WATCHDOG_USEC", "")) / 2e6
    except ValueError:
        return None
