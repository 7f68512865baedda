"""Mounting, and serving in the background until the tree is unmounted."""

import os

from rtshell_lite import errors, notes
from rtshell_lite.corba import orb
from rtshell_lite.mount import kernel


def fork():
    """Make the process that serves. Returns (its id, a pipe to wait at), or in that process (0, `leave` for
    `serve`).

    To be called before there is any thread, and before the ORB starts: neither survives a fork.
    """
    ours, theirs = os.pipe()
    child = os.fork()
    os.close(theirs if child else ours)
    return child, ours if child else lambda: _leave_terminal(theirs)


def wait_for(child, pipe):
    """Wait until the tree that the process `child` serves can be used; returns the exit status."""
    if os.read(pipe, 1):
        return 0
    _, status = os.waitpid(child, 0)
    return os.WEXITSTATUS(status)


def _leave_terminal(pipe):
    """Let the parent return, and keep nothing of its terminal or directory."""
    os.setsid()
    null = os.open(os.devnull, os.O_RDWR)
    for fd in range(3):
        os.dup2(null, fd)
    os.close(null)
    os.chdir("/")
    os.write(pipe, b"+")
    os.close(pipe)


async def serve(directory, ttl, read_only=False, over=False, leave=None):
    """Mount the RTC Tree at an absolute path, and serve it until it is unmounted.

    Raises Failed and what `orb.start` raises.

    over   mount also where that hides files
    leave  called when the tree can be used; None to stay in the foreground, where failures are reported, too
    """
    await kernel.check(directory, over)
    orb.start()
    from rtshell_lite.mount import naming, nodes, server

    before = notes.listener
    mount = nodes.Mount(directory, ttl, read_only, None if leave else before)

    def ready():
        if leave:
            leave()
        notes.listener = mount.hear

    kernel.hold(directory)
    fd = kernel.mount(directory, read_only)
    device = kernel.mounted().get(directory)
    async with mount.tasks:
        try:
            await server.Server(mount, naming.Root(mount), fd, ready).serve()
            # unmounted: what is mounted there now is another tree, even if it has the same number
            device = None
        finally:
            if device and kernel.mounted().get(directory) == device:
                _unmount(directory)
            notes.listener = before
            mount.tasks.cancel()


def _unmount(directory):
    try:
        kernel.unmount(directory)
    except errors.Failed:
        pass  # that is why it ended
