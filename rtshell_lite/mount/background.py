"""Mounting, and serving in the background until the tree is unmounted."""
import io
import os
import sys

from rtshell_lite import cli, errors, interrupts
from rtshell_lite.corba import orb
from rtshell_lite.mount import kernel


def serve(directory, ttl, read_only=False, foreground=False, over=False):
    """Mount the RTC Tree at an absolute path and serve it; returns the exit status. Raises Failed and what `orb.start` raises.

    Without `foreground` this process returns as soon as the tree can be used; its child serves. It is made before there is any
    thread, and before the ORB starts: neither survives a fork. `over`: mount also where that hides files.
    """
    kernel.check(directory, over)
    if foreground:
        return _served(directory, ttl, read_only, None)
    ours, theirs = os.pipe()
    child = os.fork()
    if child:
        os.close(theirs)
        return 0 if os.read(ours, 1) else os.WEXITSTATUS(os.waitpid(child, 0)[1])
    os.close(ours)
    os.setsid()
    return _served(directory, ttl, read_only, lambda: _leave_terminal(theirs))


def _unmount(directory):
    try:
        kernel.unmount(directory)
    except errors.Failed:
        pass  # that is why it ended


def _leave_terminal(pipe):
    """Let the parent return, and keep nothing of its terminal or directory."""
    null = os.open(os.devnull, os.O_RDWR)
    for fd in range(3):
        os.dup2(null, fd)
    os.close(null)
    os.chdir("/")
    os.write(pipe, b"+")
    os.close(pipe)


class Sentences(io.TextIOBase):
    """In the place of stderr: what is said there belongs to the failures of the Mount."""

    def __init__(self, mount):
        self._mount = mount

    def write(self, text):
        for line in text.splitlines():
            self._mount.complain(line.partition(": ")[2] or line)  # without the command's name
        return len(text)


def _served(directory, ttl, read_only, leave):
    """Serve to the end; `leave` is called when the tree can be used, None in the foreground."""
    orb.start()
    from rtshell_lite.mount import naming, nodes, server
    stderr = sys.stderr
    mount = nodes.Mount(directory, ttl, read_only, lambda sentence: leave or not stderr or stderr.write(f"{kernel.NAME}: {sentence}\n"))

    def ready():
        if leave:
            leave()
        sys.stderr = Sentences(mount)
    cli.unwind_when_ended()
    kernel.share_heap()
    kernel.hold(directory)
    fd = kernel.mount(directory, read_only)
    device = kernel.mounted().get(directory)
    serving = server.Server(mount, naming.Root(mount), fd, ready)
    try:
        serving.serve()
        device = None  # it has been unmounted: what is mounted there now is another, even if it has the same number
    except cli.Ended:
        interrupts.arrived()
    finally:
        if device and kernel.mounted().get(directory) == device:
            _unmount(directory)
        serving.close()
        sys.stderr = stderr
    return 0
