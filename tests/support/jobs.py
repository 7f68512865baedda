"""Jobs in process groups of their own, and what tests leave behind: processes, found by a mark in their
environment, and mounts, which only they themselves see.
"""
import contextlib
import faulthandler
import functools
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import uuid

import mounts

TURN = 10.0  # seconds between two looks at the machine's load
LEAST_SHARE = 0.2  # of a processor, which a job is thought to get on however busy a machine
HERE = os.path.dirname(os.path.abspath(__file__))


@functools.lru_cache(maxsize=None)
def apart():
    """How the command line of a job begins: root's jobs get a mount namespace each, as rtdoctor looks at all
    mounts.
    """
    command = ["unshare", "--mount"]
    if os.geteuid() or not shutil.which("unshare"):
        return []
    return [] if subprocess.call(command + ["true"], stderr=subprocess.DEVNULL) else command


def run_job(python, program, words, limit, environment=None):
    """Run a program of ours, with a directory of its own as its first word: (what it gives to `finish`, or
    None; how it ended; what it printed). Its process group is killed then, or after `limit` seconds.
    """
    directory = tempfile.mkdtemp(prefix="rt-")
    try:
        # Output goes to a file: a process that a test forgot would hold a pipe open.
        with open(os.path.join(directory, "said"), "w+", encoding="utf-8", errors="replace") as said:
            command = apart() + [python, os.path.join(HERE, program), directory] + words
            process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=said, stderr=said,
                                       env=environment, cwd=directory, start_new_session=True)
            why = _end(process, limit)
            said.seek(0)
            printed = said.read()
        try:
            with open(os.path.join(directory, "result")) as file:
                return json.load(file), why, printed
        except (OSError, ValueError):
            return None, why, printed
    finally:
        _remove(directory)


def _end(process, limit):
    """Wait for a job, and kill what is left of its group; returns how it ended."""
    left = limit
    try:
        while left > 0:
            # on a busy machine it gets a part of the time
            share = max(os.cpu_count() / max(os.getloadavg()[0], os.cpu_count()), LEAST_SHARE)
            with contextlib.suppress(subprocess.TimeoutExpired):
                return "ended with status %d" % process.wait(min(left, TURN) / share)
            left -= TURN
        process.send_signal(signal.SIGABRT)  # it prints where it stands (see begin)
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(TURN)
        return "no end after %g s of a quiet machine" % limit
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        process.stdin.close()
        _wait_for_group(process.pid)


def _wait_for_group(group):
    """Wait until the processes of a group, which have been killed, have ended: a busy machine lets each do
    that when it is its turn.
    """
    end = time.monotonic() + TURN
    while any(map(functools.partial(_belongs, group), _processes())) and time.monotonic() < end:
        time.sleep(0.01)


def _belongs(group, number):
    """Whether a process is of a group, and has not ended."""
    try:
        with open("/proc/%d/stat" % number, "rb") as file:
            state, _, of = file.read().rpartition(b") ")[2].split()[:3]
    except OSError:
        return False
    return int(of) == group and state not in (b"Z", b"X")


def _processes():
    """The numbers of all processes."""
    return map(int, filter(str.isdigit, os.listdir("/proc")))


def _remove(directory):
    mounts.take_away(directory)
    shutil.rmtree(directory, ignore_errors=True)


def begin():
    """For a job: end, with its group, when the process that has started it ends, which closes its stdin;
    returns its directory and its other words.
    """
    def watch():
        sys.stdin.read()
        _remove(sys.argv[1])
        os.killpg(0, signal.SIGKILL)
    threading.Thread(target=watch, daemon=True).start()
    faulthandler.enable()
    return sys.argv[1], sys.argv[2:]


def finish(result):
    """For a job: hand over its result, and end; no thread holds the process."""
    with open(os.path.join(sys.argv[1], "result"), "w") as file:
        json.dump(result, file)
    sys.stdout.flush()
    os._exit(0)


def mark():
    """Put a mark into the environment that every process of this run inherits."""
    os.environ["RTSHELL_TESTS"] = uuid.uuid4().hex
    return ("RTSHELL_TESTS=" + os.environ["RTSHELL_TESTS"]).encode()


def left_behind(marker):
    """Kill the processes that have the mark, except this one; returns their command lines."""
    found = []
    for number in _processes():
        with contextlib.suppress(OSError):
            with open("/proc/%d/environ" % number, "rb") as file:
                if number == os.getpid() or marker not in file.read():
                    continue
            with open("/proc/%d/cmdline" % number, "rb") as file:
                found.append(file.read().replace(b"\0", b" ").decode("utf-8", "replace"))
            os.kill(number, signal.SIGKILL)
    return found
