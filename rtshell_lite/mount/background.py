"""Mounting, and serving in the background until the tree is unmounted."""
import os
import sys

from rtshell_lite import cli, errors
from rtshell_lite.corba import orb
from rtshell_lite.mount import kernel


def serve(directory, ttl, read_only=False, foreground=False):
    """Mount the RTC Tree at an absolute path and serve it; returns the exit status. Raises Failed and what `orb.start` raises.

    Without `foreground` this process returns as soon as the tree can be used; its child serves. It is made before there is any
    thread, and before the ORB starts: neither survives a fork.
    """
    kernel.check(directory)
    if foreground:
        return _served(directory, ttl, read_only, lambda: None, cli.complain)
    ours, theirs = os.pipe()
    child = os.fork()
    if child:
        os.close(theirs)
        return 0 if os.read(ours, 1) else os.WEXITSTATUS(os.waitpid(child, 0)[1])
    os.close(ours)
    os.setsid()
    return _served(directory, ttl, read_only, lambda: _leave_terminal(theirs), lambda sentence: None)


def _leave_terminal(pipe):
    """Let the parent return, and keep nothing of its terminal or directory."""
    sys.stdout.flush()
    null = os.open(os.devnull, os.O_RDWR)
    for fd in range(3):
        os.dup2(null, fd)
    os.close(null)
    os.chdir("/")
    os.write(pipe, b"+")
    os.close(pipe)


def _served(directory, ttl, read_only, ready, report):
    orb.start()
    from rtshell_lite.mount import naming, nodes, server
    mount = nodes.Mount(directory, ttl, read_only, report)
    cli.unwind_when_ended()
    fd = kernel.mount(directory, read_only)
    serving = server.Server(mount, naming.Root(mount), fd, ready)
    try:
        serving.serve()
    except cli.Ended:
        return 0
    finally:
        try:
            kernel.unmount(directory)
        except errors.Failed:
            pass  # that is why it ended
        serving.close()
    return 0
