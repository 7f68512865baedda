"""Making a log whole that was cut off, so that everybody's tools open it."""

import os

from rtshell_lite import errors, files, notes
from rtshell_lite.datalog import logfile, writer
from rtshell_lite.text import printable


def mend(name, out=None):
    """Write what is whole in a log, and its summary, to a file `out`; None: only add the summary to the log
    itself.

    Returns what was left out, in words. Raises OSError, errors.Failed.
    """
    with logfile.load(name) as log:
        if log.form != "mcap":
            raise errors.Failed(log.where, "a log of rtshell; only MCAP can be mended")
        with notes.Work("octets", log.size) as log.work:
            if out is None:
                _complete(name, log)
            else:
                with files.Naming(out):
                    _copy(log, out)
        return [note for note in log.notes() if log.torn or log.damaged]


def _complete(name, log):
    for _ in log.sound_records():
        pass
    if log.damaged:
        raise errors.Failed(log.where, "damaged in its middle; without --in-place a sound copy is written")
    if not log.closed:
        writer.LogWriter(name, None, 0, append=True).close()


def _copy(log, out):
    with files.Temporary(files.destination(out)) as temporary, temporary.file as file:
        file.writelines(log.sound_records())
        file.flush()
        writer.LogWriter(temporary.path, None, 0, append=True).close()
        temporary.take_place()


def name_beside(name):
    """The name of the mended copy of a log. Raises errors.Failed when there is a file of that name."""
    stem, dot = os.path.splitext(name)
    out = stem + "-mended" + (dot or ".mcap")
    if os.path.lexists(out):
        raise errors.Failed(printable(out), "exists already; -f OUT names another file")
    return out
