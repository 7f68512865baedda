"""FUSE messages as octets: what the kernel asks, what it is answered. No state, no system calls.

Source: linux/fuse.h, version 7.31, in the machine's own byte order without padding. An `attributes` here is
the packed struct fuse_attr; `seconds` is how long the kernel believes an answer.
"""

import collections
import struct

LOOKUP, FORGET, GETATTR, SETATTR, READLINK, SYMLINK = range(1, 7)
MKNOD, MKDIR, UNLINK, RMDIR, RENAME, LINK, OPEN, READ, WRITE, STATFS = range(8, 18)
RELEASE = 18
FSYNC = 20
FLUSH = 25
INIT = 26
OPENDIR = 27
READDIR = 28
RELEASEDIR = 29
FSYNCDIR = 30
CREATE = 35
INTERRUPT = 36
DESTROY = 38
BATCH_FORGET = 42
READDIRPLUS = 44
RENAME2 = 45
# where names begin, if not at 0
_NAME_AT = {MKNOD: 16, MKDIR: 8, RENAME: 8, RENAME2: 16, LINK: 8, CREATE: 16}
UNANSWERED = (FORGET, BATCH_FORGET, INTERRUPT)

VERSION = 7, 31  # asks for nothing that came later
MOST_WRITTEN = 1 << 17  # bytes in one WRITE, the most that kernels send without further flags
LONGEST = MOST_WRITTEN + 4096  # bytes of a request
DO_READDIRPLUS = 1 << 13  # flags of INIT
PARALLEL_DIROPS = 1 << 18  # FUSE_ATOMIC_O_TRUNC would make the kernel believe a size of 0
LOCK_OWNER = 1 << 1  # flag of READ: it is for one program
DIRECT_IO = 1  # flag of OPEN: the kernel keeps no content and believes no size
NO_FLUSH = 1 << 5  # flag of OPEN: to close it is nothing to ask about; kernels before 5.16 do
# What SETATTR may change: the size, times, and bits that change nothing (a handle, the owner of a lock).
HARMLESS = 1 << 3 | 1 << 4 | 1 << 5 | 1 << 7 | 1 << 8 | 1 << 10 | 1 << 6 | 1 << 9
ROOT = 1  # the node of the mount's own directory
UNKNOWN_INODE = 0xFFFFFFFF

_HEADER = struct.Struct("=IIQQIIIHH")
_REPLY = struct.Struct("=IiQ")
_ATTRIBUTES = struct.Struct("=QQQQQQIIIIIIIIII")
_ENTRY = struct.Struct("=QQQQII")
_VALID = struct.Struct("=QII")
_OPENED = struct.Struct("=QII")
_INIT = struct.Struct("=IIIIHHIIHHI7I")
_STATFS = struct.Struct("=QQQQQIIII6I")
_DIRENT = struct.Struct("=QQII")
_IO = struct.Struct("=QQIIQII")  # of READ and WRITE
_PAIR = struct.Struct("=QQ")
ENTRY_SIZE = _ENTRY.size + _ATTRIBUTES.size  # bytes that READDIRPLUS has before each entry of READDIR

# A request: `node` is what it is about, `body` the bytes that depend on its opcode.
Request = collections.namedtuple("Request", "opcode unique node uid pid body")


# ---- requests ----


def request(data):
    """The Request in what one read from /dev/fuse returned. Raises ValueError for anything else."""
    if len(data) < _HEADER.size:
        raise ValueError(f"a request of {len(data)} bytes")
    length, opcode, unique, node, uid, _, pid, _, _ = _HEADER.unpack_from(data)
    if length != len(data):
        raise ValueError(f"a request of {len(data)} bytes that claims {length}")
    return Request(opcode, unique, node, uid, pid, bytes(data[_HEADER.size :]))


def names(body):
    """The names in the body of LOOKUP, SYMLINK, UNLINK …, as text;
    bytes that are not UTF-8 as surrogate escapes.
    """
    return [name.decode("utf-8", "surrogateescape") for name in body.split(b"\0")[:-1]]


def named(opcode, body):
    """The first name in the body of a request that makes, moves or removes something."""
    return names(body[_NAME_AT.get(opcode, 0) :])[0]


def init(body):
    """((major, minor), flags) that the kernel offers."""
    major, minor, _, flags = struct.unpack_from("=IIII", body)
    return (major, minor), flags


def forgotten(opcode, node, body):
    """[(node, how many of its lookups are forgotten)] of FORGET and BATCH_FORGET."""
    if opcode == FORGET:
        return [(node, struct.unpack_from("=Q", body)[0])]
    count, _ = struct.unpack_from("=II", body)
    return [_PAIR.unpack_from(body, 8 + 16 * i) for i in range(count)]


def interrupted(body):
    """The `unique` of the request that is no longer waited for."""
    return struct.unpack_from("=Q", body)[0]


def opening(body):
    """The flags (os.O_…) of OPEN and OPENDIR."""
    return struct.unpack_from("=I", body)[0]


def handle(body):
    """The handle that FLUSH, RELEASE, RELEASEDIR … are about."""
    return struct.unpack_from("=Q", body)[0]


def reading(body):
    """(handle, offset, size) of READ, READDIR and READDIRPLUS."""
    return _IO.unpack_from(body)[:3]


def is_direct(body):
    """Whether a READ is a program's own. Others are for the kernel's page cache, for sendfile(2) say,
    which believes sizes.
    """
    return _IO.unpack_from(body)[3] & LOCK_OWNER


def writing(body):
    """(handle, data) of WRITE. The offset is left out: what is written to our files has none."""
    opened, _, size = _IO.unpack_from(body)[:3]
    return opened, body[_IO.size : _IO.size + size]


def changed(body):
    """Which attributes SETATTR changes: bits."""
    return struct.unpack_from("=I", body)[0]


# ---- answers ----


def reply(unique, payload=b"", error=0):
    """A whole answer; `error` is an errno."""
    return _REPLY.pack(_REPLY.size + len(payload), -error, unique) + payload


def init_reply(version, flags):
    """The answer to INIT, with those of `flags` that we use.
    Kernels older than 7.31 are answered by their own version.
    """
    flags &= DO_READDIRPLUS | PARALLEL_DIROPS
    major, minor = min(version, VERSION)
    return _INIT.pack(major, minor, 0, flags, 64, 48, MOST_WRITTEN, 1, 0, 0, 0, *[0] * 7)


def attributes(inode, mode, uid, gid, size, time):
    """`mode` with the type of file; times (seconds since 1970) are all the same."""
    return _ATTRIBUTES.pack(
        inode, size, (size + 511) // 512, time, time, time, 0, 0, 0, mode, 1, uid, gid, 0, 4096, 0
    )


def attributes_reply(attributes, seconds):
    """The answer to GETATTR and SETATTR."""
    return _VALID.pack(*_parts(seconds), 0) + attributes


def entry(node, attributes, seconds):
    """The answer to LOOKUP and SYMLINK."""
    whole, nanoseconds = _parts(seconds)
    return _ENTRY.pack(node, 0, whole, whole, nanoseconds, nanoseconds) + attributes


def _parts(seconds):
    return int(seconds), int(seconds % 1 * 1e9)


def opened(handle, flags):
    """The answer to OPEN and OPENDIR."""
    return _OPENED.pack(handle, flags, 0)


def written(size):
    """The answer to WRITE."""
    return struct.pack("=II", size, 0)


def dirent(inode, offset, name, mode):
    """One entry of READDIR: `name` in bytes, `offset` that of the entry after it."""
    raw = _DIRENT.pack(inode, offset, len(name), mode >> 12) + name
    return raw + bytes(-len(raw) % 8)


def dirent_size(name):
    """The bytes of that."""
    return _DIRENT.size + len(name) + -len(name) % 8


def statfs():
    """The answer to STATFS: nothing can be stored here."""
    return _STATFS.pack(0, 0, 0, 0, 0, 4096, 255, 4096, 0, *[0] * 6)
