"""What tests leave behind: processes, found by a mark in their environment, and mounts, which only they
themselves see.
"""
import functools
import os
import signal
import subprocess
import uuid


@functools.lru_cache(maxsize=None)
def apart():
    """How the command line of a job begins: root's jobs get a mount namespace each, as rtdoctor looks at all
    mounts.
    """
    command = ["unshare", "--mount"]
    try:
        works = os.geteuid() == 0 and subprocess.call(command + ["true"], stderr=subprocess.DEVNULL) == 0
    except FileNotFoundError:
        works = False
    return command if works else []


def mark():
    """Put a mark into the environment that every process of this run inherits."""
    os.environ["RTSHELL_TESTS"] = uuid.uuid4().hex
    return ("RTSHELL_TESTS=" + os.environ["RTSHELL_TESTS"]).encode()


def left_behind(marker):
    """Kill the processes that have the mark, except this one; returns their command lines."""
    found = []
    for number in (
        (int(name) for name in os.listdir("/proc") if name.isdigit()) if os.path.isdir("/proc") else ()
    ):
        try:
            with open("/proc/%d/environ" % number, "rb") as file:
                if number == os.getpid() or marker not in file.read():
                    continue
            with open("/proc/%d/cmdline" % number, "rb") as file:
                found.append(file.read().replace(b"\0", b" ").decode("utf-8", "replace"))
            os.kill(number, signal.SIGKILL)
        except OSError:
            pass
    return found
