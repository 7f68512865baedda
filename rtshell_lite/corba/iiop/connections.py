"""Connections to processes, used by one thread: every step has a deadline, and what comes is bounded."""
import socket
import time

from rtshell_lite.corba.iiop import giop


class Closed(Exception):
    """The peer has closed the connection; `untouched`: it says that it has begun nothing of what it was asked."""

    untouched = False


class Connection:
    """A connection with the process at `endpoint`. `end` is a time.monotonic(), after which socket.timeout is raised.

    Raises OSError, Closed, giop.Garbled.
    """

    def __init__(self, endpoint, end):
        self.number, self.data = 0, bytearray()
        try:
            self.socket = socket.create_connection(endpoint, max(0.001, end - time.monotonic()))
        except UnicodeError as e:  # no name of a host
            raise socket.gaierror(0, str(e))
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)

    def send(self, data, end):
        """Send octets, all of them."""
        self._limit(end)
        self.socket.sendall(data)

    def reply(self, end):
        """The reply to the last request, whole: its fragments together."""
        whole = None
        while True:
            message = self._message(end)
            kind = message[7]
            if kind == giop.CLOSE:
                closed = Closed()
                closed.untouched = whole is None
                raise closed
            if kind == giop.ERROR:
                raise giop.Garbled("the peer did not understand us")
            if kind == giop.FRAGMENT and whole is not None:
                whole += message[giop.HEADER + (4 if message[5] == 2 else 0):]
            elif kind == giop.REPLY and whole is None:
                whole = message
            else:
                raise giop.Garbled(f"a message of kind {kind}")
            if len(whole) > giop.LARGEST:
                raise giop.Garbled("more than %d octets" % giop.LARGEST)
            if not message[6] & giop.MORE:
                data = bytes(whole)
                if giop.reply(data)[0] != self.number:
                    raise giop.Garbled("a reply to another request")
                return data

    def _message(self, end):
        self._fill(giop.HEADER, end)
        size = giop.HEADER + giop.size(self.data)
        self._fill(size, end)
        message = self.data[:size]
        del self.data[:size]
        return message

    def _fill(self, size, end):
        while len(self.data) < size:
            self._limit(end)
            piece = self.socket.recv(min(65536, max(4096, size - len(self.data))))
            if not piece:
                raise Closed()
            self.data += piece

    def _limit(self, end):
        left = end - time.monotonic()
        if left <= 0:
            raise socket.timeout()
        self.socket.settimeout(left)

    def close(self):
        """Close it."""
        self.socket.close()
