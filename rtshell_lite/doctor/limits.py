"""What this process may use: without enough descriptors, threads or ports here, peers seem to be at fault."""
import os
import threading

from rtshell_lite import errors
from rtshell_lite.corba import lanes
from rtshell_lite.doctor import remedies
from rtshell_lite.doctor.finding import HERE, fail

FILES, THREADS = 64, 8  # what an examination of a small system needs at a time

# How to see or raise what is scarce.
COMMANDS = {"files": "ulimit -n 1024", "threads": "ulimit -u, ulimit -v", "ports": "sysctl net.ipv4.ip_local_port_range",
            "memory": "ulimit -v"}


def findings():
    """A Finding where this process cannot have what it needs, else []."""
    for what, probe in (("files", _files), ("threads", _threads)):
        missing = probe()
        if missing:
            return [lack(errors.Shortage(what, missing))]
    return []


def lack(shortage):
    """The Finding for an errors.Shortage, which ends an examination: nothing that it would find is certain."""
    what, why = shortage.args
    return fail("limit", HERE, f"out of {what} here ({why}): nothing can be judged",
                remedies.words("raise limit", what=what, command=COMMANDS[what]))


def _files():
    taken = []
    try:
        import resource
        most = resource.getrlimit(resource.RLIMIT_NOFILE)[0]
    except ImportError:  # Debian's python3-minimal lacks it, or there is no file left to import it
        most = "their limit"
    try:
        for _ in range(FILES):
            taken.append(os.dup(2))
    except OSError as e:
        return f"{os.strerror(e.errno)}, at {most}"
    finally:
        for descriptor in taken:
            os.close(descriptor)
    return ""


def _threads():
    go_on = threading.Event()
    try:
        for _ in range(THREADS):
            lanes.start(go_on.wait)
    except errors.Shortage as e:
        return e.args[1]
    finally:
        go_on.set()
    return ""
