"""What a process writes: its last lines, and a log with one older file beside it."""

import collections
import os

from rtshell_lite import files, notes
from rtshell_lite.net import calendar, loop

LINES = 200  # that are kept of each process
LONGEST = 4096  # characters of a line
LOG = 4 << 20  # octets of a log file, after which it becomes NAME.log.1


class Output:
    """What the process `name` writes; survives that one, for the next process of that name.

    lines   the last ones
    wrote   called with the name and each line
    log     the directory of the log, or None
    """

    def __init__(self, name, wrote, log):
        self.name = name
        self.lines = collections.deque(maxlen=LINES)
        self._wrote = wrote
        self._log = log

    def follow(self, pipe):
        """Take what comes from a pipe, as children.output_of returns it, until its end."""
        rest = [b""]  # the beginning of a line
        loop.current().watch(pipe.fileno(), loop.READ, lambda: self._read(pipe, rest))

    def _read(self, pipe, rest):
        data = pipe.read(1 << 16)
        if data is None:  # nothing has come
            return
        lines = (rest[0] + data).split(b"\n")
        rest[0] = lines.pop() if data and len(lines[-1]) < LONGEST else b""
        if not data:
            lines = list(filter(None, lines))
        for line in lines:
            text = line[:LONGEST].decode("utf-8", "replace").rstrip("\r")
            self.lines.append(text)
            self._wrote(self.name, text)
            self._write_log(text)
        if not data:
            loop.current().unwatch(pipe.fileno())
            pipe.close()

    def _write_log(self, line):
        if self._log is None:
            return
        target = os.path.join(self._log, self.name + ".log")
        try:
            with files.append(target) as file:
                file.write((calendar.local("%Y-%m-%dT%H:%M:%S ") + line + "\n").encode("utf-8"))
                is_full = file.tell() > LOG
            if is_full:
                files.replace(target, target + ".1")
        except OSError as e:  # a full disk is no reason to leave a robot alone
            self._log = None
            notes.fail(f"nothing more goes to the log of {self.name}: {e.strerror}")
