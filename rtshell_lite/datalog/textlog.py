"""Logs of text, as rtshell's text logger writes them: a line for each message, for people.

    SEC.NSEC<TAB>('PORT', RTC.TimedLong(tm=RTC.Time(sec=1, nsec=2), data=3))
"""
import os
import stat

from rtshell_lite import errors, values


class Writer:
    """Writes one; takes the place of writer.Writer. `types` are the datatypes.Type of the channels, or None."""

    def __init__(self, name, channels, types, append=False):
        self.name, self._names, self._types = name, [channel.name for channel in channels], types
        self._file = open(name, "ab" if append else "wb")

    def write(self, messages):
        """Append messages, each (channel number, received, little, data). Raises OSError."""
        try:
            for channel, received, little, data in messages:
                said = (self._names[channel], self._spelt(channel, little, data))
                line = "%d.%09d\t(%r, %s)\n" % (divmod(received, 10 ** 9) + said)
                self._file.write(line.encode("utf-8", "backslashreplace"))
            self._file.flush()
        except OSError as e:
            e.filename = self.name
            raise

    def _spelt(self, channel, little, data):
        if self._types[channel]:
            try:
                return values.constructor(self._types[channel].decode(data, little))
            except (errors.BadData, errors.BadType):
                pass  # what it is can only be told by its bytes
        return repr(data)

    def sync(self):
        """Let the disk have what was written."""
        if stat.S_ISREG(os.fstat(self._file.fileno()).st_mode):
            os.fsync(self._file.fileno())

    def close(self):
        """Let the disk have all."""
        try:
            self._file.flush()
            self.sync()
        finally:
            self._file.close()
