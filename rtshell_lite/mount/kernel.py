"""Mounting and unmounting: mount(2) for root, fusermount3 or fusermount for others; what is mounted where.
Linux only.
"""

import errno
import os
import re
import sys

from rtshell_lite import errors
from rtshell_lite.corba import session
from rtshell_lite.net import loop, real
from rtshell_lite.text import printable

NAME = "rtmount"
TYPE = "fuse." + NAME
HELPERS = ("fusermount3", "fusermount")  # set-uid root; of FUSE 3 and 2
LOOK = 0.02  # seconds between looks at whether a server has ended
# MS_… and MNT_DETACH of <sys/mount.h>
RDONLY = 1
NOSUID = 2
NODEV = 4
DETACH = 2


# ---- what is mounted ----


def mounted():
    """{directory, absolute: number of its device} where RTC Trees are mounted. Asks no server."""
    try:
        with loop.world().mounts() as file:
            lines = [line.split(" ") for line in file]
    except OSError:
        return {}
    return {_unescaped(fields[4]): fields[2] for fields in lines if TYPE in fields[6:]}


def located(directory):
    """The absolute path of a directory, without asking the server of a tree that is mounted there:
    it may be stopped.
    """
    parent, name = os.path.split(directory.rstrip("/"))
    path = os.path.join(os.path.realpath(parent), name)
    return path if path in mounted() else os.path.realpath(directory)


def _unescaped(word):
    """`word` with the octets that mountinfo writes as \\040 and the like."""
    raw = word.encode("utf-8", "surrogateescape")
    return os.fsdecode(re.sub(rb"\\([0-7]{3})", lambda match: bytes([int(match.group(1), 8)]), raw))


def is_stale(directory):
    """Whether a mount has lost its server. Asks that, which may be stopped."""
    try:
        os.statvfs(directory)
    except OSError as e:
        return e.errno == errno.ENOTCONN
    return False


async def _is_stale_for_certain(directory):
    """`is_stale`, False if there is no answer within the timeout."""
    try:
        return await session.on_thread(directory, lambda: is_stale(directory))
    except errors.Unanswered:
        return False


# ---- mounting ----


async def check(directory, over=False):
    """Raise Failed unless a tree can be mounted on this system, at this absolute path; a stale mount there is
    detached.

    `over`: also where that hides files.
    """
    if not sys.platform.startswith("linux"):
        raise errors.Failed(NAME, "works on Linux only")
    if directory in mounted():
        if not await _is_stale_for_certain(directory):
            raise errors.Failed(printable(directory), "an RTC Tree is mounted there already")
        unmount(directory)
    if not os.path.isdir(directory):
        raise errors.Failed(printable(directory), "no such directory")
    if not over and _is_filled(directory):
        raise errors.Failed(
            printable(directory), "not empty; a mount hides what is there (--over mounts all the same)"
        )
    world = loop.world()
    if not os.path.exists(world.FUSE):
        raise errors.Failed(world.FUSE, "not there: this kernel or container has no FUSE (modprobe fuse)")
    if world.own_user() and not _helper():
        raise errors.Failed(" and ".join(HELPERS), "not found: without them only root can mount")


def _is_filled(directory):
    try:
        with os.scandir(directory) as entries:
            return next(entries, None) is not None
    except OSError:  # it can be mounted on, but not read
        return False


def _helper():
    paths = [os.path.join(directory, name) for name in HELPERS for directory in os.get_exec_path()]
    return next((path for path in paths if os.access(path, os.X_OK)), None)


def mount(directory, read_only=False):
    """Mount at a directory; returns the file descriptor on which the kernel asks.
    Raises Failed with the reason.
    """
    world = loop.world()
    if world.own_user():
        return _by_helper(directory, read_only)
    try:
        fd = world.open_fuse()
    except OSError as e:
        raise errors.Failed(world.FUSE, e.strerror)
    options = (
        f"fd={fd},rootmode=40000,user_id={os.getuid()},group_id={os.getgid()},allow_other,default_permissions"
    )
    try:
        world.system_call(
            "mount", NAME.encode(), os.fsencode(directory), TYPE.encode(),
            NOSUID | NODEV | read_only * RDONLY, options.encode(),
        )
    except OSError as e:
        os.close(fd)
        raise errors.Failed(printable(directory), f"cannot mount: {e.strerror}")
    return fd


def _by_helper(directory, read_only):
    """Have fusermount3 mount: it sends the descriptor over a socket whose number is in _FUSE_COMMFD."""
    world = loop.world()
    options = f"default_permissions,subtype={NAME},fsname={NAME}{',ro' if read_only else ''}"
    for more in (",allow_other", ""):  # which /etc/fuse.conf may forbid
        ours, theirs = world.pair()
        with ours, theirs:
            done = world.start_process(
                [_helper(), "-o", options + more, "--", directory], pass_fds=[theirs.fileno()],
                env=dict(os.environ, _FUSE_COMMFD=str(theirs.fileno())), stderr=real.PIPE,
            )
            theirs.close()
            fd = world.received(ours)
            said = done.communicate()[1].decode("utf-8", "replace").strip()
        if fd is not None:
            return fd
    raise errors.Failed(
        printable(directory), "cannot mount: " + printable(said or "fusermount gave no reason")
    )


def hold(directory):
    """Let `is_released` wait for the end of this process; to be called before it mounts at a directory."""
    try:
        loop.world().lock(directory)
    except OSError:  # no right to read it; a file system without locks
        pass


async def is_released(directory, seconds):
    """Whether all processes that have mounted at a directory, where nothing is mounted now,
    end within that many seconds.
    """
    import fcntl  # which rtdoctor, that reads what is mounted, does without

    try:
        fd = os.open(directory, os.O_RDONLY)
    except OSError:
        return True
    end = loop.now() + seconds
    try:
        while True:
            try:
                fcntl.flock(fd, fcntl.LOCK_EX | fcntl.LOCK_NB)
                return True
            except BlockingIOError:
                if loop.now() > end:
                    return False
                await loop.sleep(LOOK)
            except OSError:  # a file system without locks
                return True
    finally:
        os.close(fd)


def unmount(directory):
    """Take a mount away, also one in use: its open files work on until they are closed. Raises Failed."""
    world = loop.world()
    try:
        if world.own_user():
            words = [_helper() or HELPERS[0], "-u", "-z", "--", directory]
            done = world.start_process(words, stderr=real.PIPE)
            said = done.communicate()[1].decode("utf-8", "replace").strip()
            if done.returncode:
                raise OSError(errno.EPERM, said)
        else:
            world.system_call("umount2", os.fsencode(directory), DETACH)
    except OSError as e:
        raise errors.Failed(printable(directory), f"cannot unmount: {printable(e.strerror)}")
