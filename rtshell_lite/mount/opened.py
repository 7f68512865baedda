"""Open files and directories of a mounted RTC Tree, other than streams."""
from rtshell_lite import errors
from rtshell_lite.mount import wire

LONGEST_LINE = 1 << 22  # bytes of what is written at once, as a line of rtsh
BLOCK = 512  # bytes: programs write what is long in pieces of a multiple of this: bash of 4096, dd of 512
PAGE = 4096  # bytes: the kernel divides what is longer than MOST_WRITTEN, and where it is not aligned, by a page earlier


class Opened:
    """An open file of text. What is read is what it was when it was read from its beginning."""

    def __init__(self, node):
        self.node, self.text = node, None
        self._begun, self._size = b"", 0  # what has been written and not been done; bytes since the last end of a text
        self._is_too_long = False

    def read(self, server, request, offset, size):
        if self.text is not None and offset:
            return server.reply(request, self.text[offset:offset + size])

        def render(value):
            self.text = make(value).encode("utf-8", "backslashreplace")
            return self.text[offset:offset + size]
        source, make = self.node.content()
        server.when(request, source, render)

    def write(self, server, request, data):
        """Do what a text says. What may be a piece of one waits for the next, or for the file to be closed."""
        if self._is_too_long or len(self._begun) + len(data) > LONGEST_LINE:
            self._begun, self._is_too_long = b"", True  # for the rest, too, which some programs write all the same
            raise errors.BadValue(self.node.where, f"more than {LONGEST_LINE} bytes in one line")
        self._begun += data
        self._size += len(data)
        if not data.endswith(b"\n") and (self._size % BLOCK == 0 or len(data) > wire.MOST_WRITTEN - PAGE):
            text, self._begun = self.parted(self._begun)
        else:
            text, self._begun, self._size = self._begun, b"", 0
        self._store(server, request, text, wire.written(len(data)))

    def parted(self, begun):
        """(what can be done now, what the next piece belongs to)"""
        return b"", begun

    def _store(self, server, request, text, payload):
        if not text:
            return server.reply(request, payload)
        text = text.decode("utf-8", "surrogateescape").rstrip("\n")
        server.change(request, self.node, lambda: self.node.store(text), payload)

    def flush(self, server, request):
        """A descriptor is closed: there are no more pieces."""
        text, self._begun, self._size = self._begun, b"", 0
        self._store(server, request, text, b"")

    def interrupt(self, unique):
        """The request is waited for no longer."""

    def close(self):
        """The last descriptor is closed."""


class Listing:
    """An open directory: its nodes as they were when it was read from its beginning."""

    nodes = None

    def close(self):
        pass

    def interrupt(self, unique):
        pass
