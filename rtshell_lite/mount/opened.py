"""Open files and directories of a mounted RTC Tree, other than streams."""
from rtshell_lite.mount import wire

LONGEST_LINE = 1 << 22  # bytes of what is written at once, as a line of rtsh


class Opened:
    """An open file of text. What is read is what it was when it was read from its beginning."""

    def __init__(self, node):
        self.node, self.text, self.begun = node, None, b""

    def read(self, server, request, offset, size):
        if self.text is not None and offset:
            return server.reply(request, self.text[offset:offset + size])

        def render(value):
            self.text = make(value).encode("utf-8", "backslashreplace")
            return self.text[offset:offset + size]
        source, make = self.node.content()
        server.when(request, source, render)

    def write(self, server, request, data):
        """Do what a line says; one of more bytes than fit in a request comes in pieces."""
        self.begun += data
        if len(data) == wire.MOST_WRITTEN and not data.endswith(b"\n") and len(self.begun) < LONGEST_LINE:
            return server.reply(request, wire.written(len(data)))
        text, self.begun = self.begun.decode("utf-8", "surrogateescape"), b""
        server.change(request, self.node, lambda: self.node.store(text.rstrip("\n")), wire.written(len(data)))

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
