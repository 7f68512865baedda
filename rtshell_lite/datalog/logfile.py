"""Opening a log file, whatever its form."""

import os
import stat

from rtshell_lite import errors, files, text
from rtshell_lite.datalog import mcap


SIMPKL = b"(F", b"(G"  # how the logs of rtshell begin, beside those with the mark of a newer pickle


def is_text(start):
    """True for the first bytes of a log of text."""
    return start.split(b".")[0].isdigit()


def is_log(name):
    """Whether there is a file of that name that begins as a log does."""
    try:
        if not stat.S_ISREG(os.stat(name).st_mode) or not os.path.getsize(name):
            return False
        with files.opened(name) as file:
            start = file.read(32)
    except (OSError, errors.Failed):
        return False
    return start.startswith(mcap.MAGIC) or start[:1] == b"\x80" or start[:2] in SIMPKL


def load(name, modules=()):
    """Open a log file, MCAP or simpkl by its content, for a `with` statement.

    `modules` are Python modules whose classes a simpkl file may mention. Raises OSError, errors.Failed.
    """
    where = text.printable(name)
    try:
        mode = os.stat(name).st_mode
    except FileNotFoundError:
        _check_parts(name)
        raise
    if stat.S_ISFIFO(mode):
        raise errors.Failed(where, "a pipe; logs are read from files")
    file = files.opened(name)
    try:
        with files.Naming(name):
            size = os.fstat(file.fileno()).st_size
            start = file.read(32)
        if start.startswith(mcap.MAGIC):
            from rtshell_lite.datalog import reader

            return reader.Log(file, where, size)
        if start[:1] == b"\x80" or start[:2] in SIMPKL:
            from rtshell_lite.datalog import simpkl

            return simpkl.PickledLog(file, where, size, modules)
        if is_text(start):
            raise errors.Failed(
                where, "a log of text; it is for people, and can be neither played nor inspected"
            )
        raise errors.Failed(where, "not a log file" + ("" if size else " (it is empty)"))
    except (errors.Error, OSError):
        file.close()
        raise


def _check_parts(name):
    """Raise errors.Failed for a log that is not there, but was recorded as several files."""
    import glob

    stem, dot = os.path.splitext(name)
    parts = sorted(glob.glob(glob.escape(stem) + "-" + "[0-9]" * 6 + glob.escape(dot or ".mcap")))
    if parts:
        names = " … ".join(text.printable(part) for part in dict.fromkeys((parts[0], parts[-1])))
        raise errors.Failed(text.printable(name), f"no such file; it was recorded as {names}")
