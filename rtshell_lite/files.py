"""Local files: written whole or not at all, `-` for stdin and stdout, safe in directories that others can
write to.

In /tmp, say, somebody else may have put a link, or guess a name that we are about to write. So new files are
created exclusively, under names that cannot be guessed, readable by nobody else until they get the mode of
what they replace; and links that belong neither to us nor to the directory's owner are not followed, a rule
of Linux itself.
"""

import errno
import os
import stat
import sys

from rtshell_lite import errors
from rtshell_lite.net import loop
from rtshell_lite.text import printable

LIMIT = 16 << 20  # octets of a file that is read as a whole
LINKS = 40  # links to links that are followed


# ---- reading ----


def read(name, limit=LIMIT):
    """The text of a file (`-`: stdin), with undecodable bytes as surrogate escapes.
    Raises OSError, errors.Failed when too big.
    """
    if name == "-":
        if sys.stdin is None:
            raise errors.Failed("-", "there is no standard input")
        data = sys.stdin.buffer.read(limit + 1)
    else:
        with opened(name) as source:
            data = source.read(limit + 1)
    if len(data) > limit:
        raise errors.Failed(printable(name), "more than %d MiB" % (limit >> 20))
    return data.decode("utf-8-sig", "surrogateescape")


def opened(name):
    """The file of that name, open for reading bytes.
    Raises OSError, and errors.Failed for what may block or never end.
    """
    _refuse_endless(name, os.stat(name))  # some devices act as soon as they are opened
    file = open(os.open(name, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC), "rb")
    try:
        _refuse_endless(name, os.fstat(file.fileno()))
    except errors.Failed:
        file.close()
        raise
    os.set_blocking(file.fileno(), True)
    return file


def _refuse_endless(name, status):
    if stat.S_ISDIR(status.st_mode):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), name)
    if stat.S_ISREG(status.st_mode) or _is_descriptor(name) or os.path.samestat(status, os.stat(os.devnull)):
        return
    kinds = {stat.S_IFIFO: "FIFO", stat.S_IFSOCK: "socket"}
    what = kinds.get(stat.S_IFMT(status.st_mode), "device")
    raise errors.Failed(printable(name), f"a {what}; only files are read by name")


def _is_descriptor(name):
    """Whether a name is that of an open descriptor, as the shell passes it for `<(command)`: a pipe is fine
    there, for it has a writer.
    """
    directory, _, number = name.rpartition("/")
    is_of_process = directory.startswith("/proc/") and directory.endswith("/fd")
    return name == "/dev/stdin" or number.isdigit() and (is_of_process or directory == "/dev/fd")


# ---- writing ----


def write(name, content):
    """Write text to a file (`-`: stdout), completely or not at all. Raises OSError, errors.Failed.

    Of 60 plain writes that a kill -9 interrupted, 57 left torn files; with a temporary name, fsync and
    rename, none.
    """
    data = content.encode("utf-8", "surrogateescape")
    if name == "-":
        sys.stdout.flush()
        sys.stdout.buffer.write(data)
        return
    try:
        _replace(destination(name), data)
    except OSError as e:
        e.filename = name
        raise


def _replace(target, data):
    if is_special(target):
        with open_special(target) as pipe:
            pipe.write(data)
        return
    with Temporary(target) as temporary, temporary.file as out:
        out.write(data)
        out.flush()
        sync(out)
        temporary.take_place()


def destination(name):
    """The file to write for the `name` that the user gave: links are followed, not replaced.

    Raises OSError, and errors.Failed for a link that somebody else has put into a directory for all.
    """
    for _ in range(LINKS):
        if not os.path.islink(name):
            folder, base = os.path.split(name)
            if base in ("", ".", ".."):
                return os.path.realpath(name)
            return os.path.join(os.path.realpath(folder), base)
        folder = os.path.dirname(name)
        link = os.lstat(name)
        above = os.stat(folder or ".")
        for_all = above.st_mode & stat.S_ISVTX and above.st_mode & stat.S_IWOTH
        own = os.geteuid() if hasattr(os, "geteuid") else link.st_uid
        if for_all and link.st_uid not in (own, above.st_uid):
            why = "a link that somebody else has put there; remove it or write elsewhere"
            raise errors.Failed(printable(name), why)
        following = os.path.join(folder, os.readlink(name))
        if is_special(name) and not os.path.lexists(following):
            return name  # of /proc, as /dev/stdout in a pipeline: there is nothing but the link
        name = following
    raise OSError(errno.ELOOP, os.strerror(errno.ELOOP), name)


def is_special(target):
    """True for something that exists and is not a regular file."""
    return os.path.exists(target) and not stat.S_ISREG(os.stat(target).st_mode)


def open_special(target, buffering=-1):
    """A device or a FIFO, open for writing.
    Raises OSError, and errors.Failed for a disk and for a FIFO without a reader.
    """
    if stat.S_ISBLK(os.stat(target).st_mode):
        raise errors.Failed(printable(target), "a disk; only files are written by name")
    try:
        fd = os.open(target, os.O_WRONLY | os.O_NONBLOCK | os.O_NOCTTY | os.O_CLOEXEC)
    except OSError as e:
        if e.errno == errno.ENXIO:
            raise errors.Failed(printable(target), "a FIFO that nobody reads")
        raise
    os.set_blocking(fd, True)
    return open(fd, "wb", buffering)


class Temporary:
    """A new file beside `target`, open for appending as `file`, that replaces it when complete, or is removed
    at the end of a `with` statement, also after Ctrl-C. Raises OSError.

    Names are unique: of two processes that write to one target at a time, the last one wins, and the file is
    whole.
    """

    def __init__(self, target, buffering=-1):
        self.target = target
        folder, base = os.path.split(target)
        # shortened: names have at most 255 octets
        self.path = os.path.join(folder, f".{base[:50]}.{os.urandom(8).hex()}.tmp")
        self.file = create(self.path, 0o600, buffering)

    def take_place(self):
        """Replace the target, keeping its mode; a new target gets the usual mode of new files."""
        os.fchmod(self.file.fileno(), self._mode())
        replace(self.path, self.target)
        self.path = None

    def _mode(self):
        try:
            old = os.stat(self.target)
            new = os.fstat(self.file.fileno())
        except FileNotFoundError:
            return 0o666 & ~umask()
        mode = stat.S_IMODE(old.st_mode) & 0o777
        if old.st_gid != new.st_gid:
            try:
                os.fchown(self.file.fileno(), -1, old.st_gid)
            except PermissionError:
                mode &= 0o707  # the permissions were for another group
        return mode

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.path:
            try:
                os.remove(self.path)
            except FileNotFoundError:
                pass  # it has replaced the target, and a signal struck before `path` was forgotten
            self.path = None


class Naming:
    """Has an OSError in a `with` block name the file that the user knows, where it names none or a temporary
    one.
    """

    def __init__(self, name):
        self.name = name

    def __enter__(self):
        return self

    def __exit__(self, kind, error, trace):
        if isinstance(error, OSError) and (error.filename is None or str(error.filename).endswith(".tmp")):
            error.filename = self.name


def create(path, mode=0o666, buffering=-1):
    """A new file, open for appending. Raises FileExistsError for whatever has that name,
    even a broken link.
    """
    flags = os.O_WRONLY | os.O_APPEND | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW | os.O_CLOEXEC
    return loop.world().file(os.open(path, flags, mode), "ab", buffering)


def append(path):
    """A regular file, new or old, open for appending bytes.
    Raises OSError, also for a link, which is not followed, and for a FIFO, which is not waited for.
    """
    flags = os.O_WRONLY | os.O_APPEND | os.O_CREAT | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC
    try:
        fd = os.open(path, flags, 0o666)
    except OSError as e:
        if e.errno in (errno.ELOOP, errno.ENXIO):  # a link; a FIFO that nobody reads, or a socket
            raise OSError(e.errno, "not a regular file", path)
        raise
    if not stat.S_ISREG(os.fstat(fd).st_mode):
        os.close(fd)
        raise OSError(errno.EINVAL, "not a regular file", path)
    return loop.world().file(fd, "ab")


def reopened(path):
    """A file that is there, open for reading and writing bytes, without a buffer. Raises OSError."""
    return loop.world().file(os.open(path, os.O_RDWR | os.O_CLOEXEC), "r+b", 0)


def sync(file):
    """Have what is in an open file survive a power failure. Raises OSError."""
    loop.world().sync(file.fileno())


def replace(path, target):
    """Give a file the name of another, which it replaces. Raises OSError."""
    loop.world().replace(path, target)


def umask():
    """The permissions that new files of this process do not get."""
    # it can only be read by setting it; meanwhile other threads create files that are more private
    mask = os.umask(0o077)
    os.umask(mask)
    return mask
