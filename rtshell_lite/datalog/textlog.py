"""Logs of text, as rtshell's text logger writes them: a line for each message, for people.

SEC.NSEC<TAB>('PORT', RTC.TimedLong(tm=RTC.Time(sec=1, nsec=2), data=3))
"""

import os
import stat

from rtshell_lite import errors, files
from rtshell_lite.data import values
from rtshell_lite.datalog import gaps, logfile, writer
from rtshell_lite.text import printable


class TextWriter:
    """Writes a log of text, instead of a writer.LogWriter.
    `types` are the datatypes.Type of the channels, or None.
    """

    def __init__(self, name, channels, types, append=False):
        self.name = name
        self._names = [channel.name for channel in channels]
        self._types = types
        self._target = files.destination(name)
        if files.is_special(self._target):
            self._file = files.open_special(self._target)
        else:
            self._file = files.append(self._target)
        try:
            if stat.S_ISREG(os.fstat(self._file.fileno()).st_mode):
                writer.lock(self._file, name)
                self._prepare(append)
        except (errors.Failed, OSError):
            self._file.close()
            raise

    def _prepare(self, append):
        if not append:
            self._file.truncate(0)
            return
        with open(self.name, "rb") as old:
            start = old.read(32)
        if start and not logfile.is_text(start):
            raise errors.Failed(printable(self.name), "not a log of text")

    def write(self, messages):
        """Append messages, each (channel number, received, little, data). Raises OSError."""
        self._put(
            (received, f"({self._names[channel]!r}, {self._spell(channel, little, data)})")
            for channel, received, little, data in messages
        )

    def put_gap(self, gap):
        """Record that values are missing: a gaps.Gap. Raises OSError."""
        seconds = (gap.last - gap.first) / 1e9
        self._put([(gap.first, f"missing in {seconds:.3f} s from here on: {gaps.words(gap)}")])

    def _put(self, timed):
        """Write lines, each (ns since the epoch, text)."""
        try:
            for moment, line in timed:
                seconds, nanoseconds = divmod(moment, 10**9)
                whole = f"{seconds}.{nanoseconds:09d}\t{line}\n"
                self._file.write(whole.encode("utf-8", "backslashreplace"))
            self._file.flush()
        except OSError as e:
            e.filename = self.name
            raise

    def _spell(self, channel, little, data):
        if self._types[channel]:
            try:
                return values.constructor(self._types[channel].decode(data, little))
            except (errors.BadData, errors.BadType, errors.BadValue):
                pass  # write its bytes
        return repr(data)

    def sync(self):
        """Flush to the disk."""
        if stat.S_ISREG(os.fstat(self._file.fileno()).st_mode):
            files.sync(self._file)

    def close(self):
        """Flush to the disk, and close. Raises errors.Failed as writer.LogWriter does."""
        try:
            self._file.flush()
            self.sync()
            writer.check_place(self._file, self._target, self.name)
        finally:
            self._file.close()
