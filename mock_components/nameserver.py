"""A real omniNames for tests and for the tour, on a port of its own: `python3 -m mock_components.nameserver`.

Prints `ready PORT` when it answers, keeps its data in a temporary directory, and ends with its standard input
or at SIGTERM.
"""
import os
import random
import shutil
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time

DEADLINE = 20.0  # seconds; omniNames starts in 0.05
PORTS = 15005  # of hrpsys, where tools look, too; ours are higher, numbers that transcripts print are lower
ATTEMPTS = 5  # another process may have taken a port since it was found free


class Failed(Exception):
    """There is no omniNames, or it does not start."""


def binary():
    """The omniNames program or None; not the script of that name on PATH, whose child survives when the
    script is killed.
    """
    for entry in sys.path:
        for package in ("jeteve_omniorb", "omniORB"):
            path = os.path.join(entry, package, "bin", "omniNames")
            if os.path.exists(path):
                return path
    try:
        import omniORB  # noqa: F401  an operating system's package brings its own omniNames
    except ImportError:
        return None
    return shutil.which("omniNames")


def free_port(above=PORTS):
    """A free port below the kernel's ephemeral range, which outgoing connections do not use."""
    for _ in range(200):
        port = random.randrange(above + 1, (above + 32000) // 2)
        with socket.socket() as probe:
            try:
                probe.bind(("127.0.0.1", port))
                return port
            except OSError:
                pass
    raise Failed("no free port")


def try_loopback():
    """Raise Failed in a network namespace in which nothing can run."""
    with socket.socket() as probe:
        try:
            probe.bind(("127.0.0.1", 0))
            probe.listen(1)
            socket.create_connection(probe.getsockname(), DEADLINE).close()
        except OSError as e:
            raise Failed(f"127.0.0.1 does not work here ({e.strerror}); in a new network namespace: ip "
                         "link set lo up")


def command(port, directory, host="127.0.0.1"):
    """The command line of an omniNames on a port, with its data in `directory`. Raises Failed."""
    program = binary()
    if program is None:
        raise Failed("omniNames is not here; it comes with omniORBpy (jeteve-omniorb, salome-omniorb, "
                     "omniorb-nameserver)")
    return [
        program,
        "-start",
        str(port),
        "-always",
        "-datadir",
        directory,
        "-ORBendPoint",
        "giop:tcp:%s:%d" % (host, port),
    ]


def start(directory):
    """Start omniNames on 127.0.0.1 with its data in `directory`, and wait until it answers: (process, port).
    Raises Failed.
    """
    try_loopback()
    for _ in range(ATTEMPTS):
        port = free_port()
        process = subprocess.Popen(
            command(port, directory),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        end = time.monotonic() + DEADLINE
        while process.poll() is None and time.monotonic() < end:
            if answers(port):
                return process, port
            time.sleep(0.01)
        process.kill()
        process.wait()
    raise Failed("omniNames does not start")


def answers(port):
    """Whether the name server on a port has its root context: it listens a little earlier."""
    body = struct.pack("<II", 1, len(b"NameService")) + b"NameService"
    try:
        with socket.create_connection(("127.0.0.1", port), DEADLINE) as connection:
            connection.sendall(b"GIOP\1\0\1\3" + struct.pack("<I", len(body)) + body)  # a LocateRequest
            reply = connection.makefile("rb").read(20)
    except OSError:
        return False
    return reply[7:8] == b"\4" and reply[-4:] == b"\1\0\0\0"  # a LocateReply: OBJECT_HERE


def main():
    """Serve names until standard input ends."""
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(0))
    with tempfile.TemporaryDirectory() as directory:
        try:
            process, port = start(directory)
        except Failed as e:
            sys.exit(f"nameserver: {e}")
        try:
            print("ready %d" % port, flush=True)
            sys.stdin.read()
        finally:
            process.kill()
            process.wait()


if __name__ == "__main__":
    main()
