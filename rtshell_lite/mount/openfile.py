"""Open files and directories of a mounted RTC Tree, other than streams.

A method that the server calls returns the payload of its reply, or a coroutine that does.
"""

from rtshell_lite import errors
from rtshell_lite.mount import wire

LONGEST_LINE = 1 << 22  # bytes of what is written at once, as a line of rtsh
BLOCK = 512  # bytes: programs write what is long in pieces of a multiple of this: bash of 4096, dd of 512
# bytes: the kernel splits what is longer than MOST_WRITTEN, a page earlier where it is not aligned
PAGE = 4096


class OpenFile:
    """An open file of text. What is read is what it was when it was read from its beginning."""

    def __init__(self, node):
        self.node = node
        self._text = None
        self._begun = b""  # what is written but not stored
        self._size = 0  # bytes since the last end of a text
        self._is_too_long = False

    def read(self, offset, size):
        """At most `size` bytes from an offset on."""
        if self._text is not None and offset:
            return self._text[offset : offset + size]
        return self._read(offset, size)

    async def _read(self, offset, size):
        text = await self.node.content()
        self._text = text.encode("utf-8", "backslashreplace")
        return self._text[offset : offset + size]

    def written(self, data):
        """The text to store now that this is written; None while more of it may come."""
        if self._is_too_long or len(self._begun) + len(data) > LONGEST_LINE:
            # some programs write the rest all the same
            self._begun = b""
            self._is_too_long = True
            raise errors.BadValue(self.node.where, f"more than {LONGEST_LINE} bytes in one line")
        self._begun += data
        self._size += len(data)
        if not data.endswith(b"\n") and (self._size % BLOCK == 0 or len(data) > wire.MOST_WRITTEN - PAGE):
            whole, self._begun = self.split(self._begun)
            return _text(whole)
        return self.flushed()

    def flushed(self):
        """The text to store now that a descriptor is closed; None if nothing was written."""
        whole = self._begun
        self._begun = b""
        self._size = 0
        return _text(whole)

    async def store(self, text):
        """Do what is written. Raises errors.Error."""
        await self.node.store(text)

    def split(self, begun):
        """(what can be stored now, what the next piece belongs to)"""
        return b"", begun

    def close(self):
        """The last descriptor is closed."""


def _text(data):
    return data.decode("utf-8", "surrogateescape").rstrip("\n") if data else None


class Listing:
    """An open directory: its nodes as they were when it was read from its beginning."""

    nodes = None

    def close(self):
        """Do nothing."""
