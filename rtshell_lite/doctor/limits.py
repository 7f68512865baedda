"""What this process may use: without enough descriptors, threads or ports here, peers seem to be at fault."""

import os
from _thread import allocate_lock

from rtshell_lite import errors
from rtshell_lite.corba import session
from rtshell_lite.doctor import remedies
from rtshell_lite.doctor.finding import HERE, MANY, fail, listed
from rtshell_lite.net import loop
from rtshell_lite.text import counted, shell_word

LATE = "slow: " + session.NO_TIME
# what an examination of a small system needs at a time
FILES = 64
THREADS = 8

# How to see or raise what is scarce.
COMMANDS = {
    "files": "ulimit -n 1024",
    "threads": "ulimit -u, ulimit -v",
    "ports": "sysctl net.ipv4.ip_local_port_range",
    "memory": "ulimit -v",
}


def findings():
    """A Finding where this process cannot have what it needs, else []."""
    for what, probe in (("files", _files), ("threads", _threads)):
        missing = probe()
        if missing:
            return [lack(errors.Shortage(what, missing))]
    return []


def lack(shortage):
    """The Finding for an errors.Shortage, which ends an examination:
    nothing that it would find is certain.
    """
    what, why = shortage.args
    return fail(
        "limit", HERE, f"out of {what} here ({why}): nothing can be judged",
        remedies.words("raise limit", what=what, command=COMMANDS[what]),
    )


def starved():
    """Seconds for which this thread could have run, but its host was too busy to let it;
    0.0 if the kernel does not report that.
    """
    return loop.world().scheduled()[1]


def slowdown():
    """How many times longer than on an idle host this thread has taken so far, 1.0 if the kernel does not
    report that.
    """
    ran, waited = loop.world().scheduled()
    return 1 + waited / ran if ran else 1.0


def late(check, where):
    """The Finding on what could not be asked in the time that an examination has, which is `where`,
    as text.
    """
    return fail(check, where, LATE, remedies.words("more time", path=shell_word(where)))


def left_out(findings):
    """The Findings, with one in the place of all, if there are many, on what there was no time for."""
    missed = [finding for finding in findings if finding.message == LATE]
    if len(missed) < MANY:
        return findings
    what = "name" if missed[0].check == "reference" else missed[0].check
    paths = listed(finding.path for finding in missed)
    message = f"{counted(len(missed), what)} not looked at, as there was no time left: {paths}"
    return [finding for finding in findings if finding.message != LATE] + [
        fail("limit", HERE, message, remedies.words("in parts"))
    ]


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
    gate = allocate_lock()
    gate.acquire()
    try:
        for _ in range(THREADS):
            loop.world().start_thread(_pass, gate)
    except errors.Shortage as e:
        return e.args[1]
    finally:
        gate.release()
    return ""


def _pass(gate):
    """Wait until a gate is open, and leave it open."""
    with gate:
        pass
