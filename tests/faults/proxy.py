"""A name server that fails at a chosen call: a proxy that forwards GIOP messages to a real one."""
import socket
import threading

from mock_components import giop

KINDS = ("CUT", "LOST", "HANG", "GONE")  # connection lost before, after the call; no answer any more; ended


class Proxy:
    """Listens on its own port and forwards to that of the name server, `target`, which is set before the
    first call.
    """

    def __init__(self):
        self.lock = threading.Lock()
        self.port = 0
        self.target = None
        self.listener = None
        self.open = []
        self.reset()

    def reset(self):
        """Start again without faults, and count calls from 0; listen again if it had stopped."""
        self.calls = 0
        self.nth = None
        self.kind = None
        self.hangs = False
        if self.listener is None:
            self.listener = socket.socket()
            self.listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            self.listener.bind(("127.0.0.1", self.port))
            self.port = self.listener.getsockname()[1]
            self.listener.listen(64)
            threading.Thread(target=self._accept, args=(self.listener,), daemon=True).start()

    def fail(self, nth, kind):
        """Let the nth next call end in one of KINDS."""
        self.calls = 0
        self.nth = nth
        self.kind = kind

    def close(self):
        """Close everything, as a process does when it ends."""
        with self.lock:
            closing = [self.listener] + self.open
            self.open = []
            self.listener = None
        for each in filter(None, closing):
            end(each)

    def _accept(self, listener):
        while True:
            try:
                client = listener.accept()[0]
                server = socket.create_connection(("127.0.0.1", self.target))
            except OSError:
                return
            with self.lock:
                self.open += [client, server]
            link = Link(client, server)
            threading.Thread(target=link.answer, daemon=True).start()
            threading.Thread(target=self._ask, args=(link,), daemon=True).start()

    def _ask(self, link):
        try:
            while True:
                header, payload = giop.read_message(link.client)
                fate = self._fate() if header[7] == giop.REQUEST else None
                if fate == "GONE":
                    self.close()
                if fate == "CUT":
                    break
                link.loses = fate == "LOST"
                if not self.hangs:
                    link.server.sendall(header + payload)
        except (EOFError, OSError):
            pass
        link.end()

    def _fate(self):
        """How this call fails: one of KINDS, or None."""
        with self.lock:
            self.calls += 1
            fate = self.kind if self.calls == self.nth else None
            self.hangs = self.hangs or fate == "HANG"
            return fate


class Link:
    """A connection of a client, and its connection to the name server."""

    def __init__(self, client, server):
        self.client = client
        self.server = server
        self.loses = False

    def answer(self):
        try:
            while True:
                data = self.server.recv(65536)
                if not data or self.loses:
                    break
                self.client.sendall(data)
        except OSError:
            pass
        self.end()

    def end(self):
        end(self.client)
        end(self.server)


def end(opened):
    try:
        opened.shutdown(socket.SHUT_RDWR)  # wakes up the thread that waits for it
    except OSError:
        pass
    opened.close()
