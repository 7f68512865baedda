"""Ports of this process, for peers that a test makes up."""
import socket
import threading


class Listener:
    """A port of 127.0.0.1; each connection is given to `talk`, on a thread of its own."""

    def __init__(self):
        self.listening = socket.socket()
        self.listening.bind(("127.0.0.1", 0))
        self.listening.listen(64)
        self.port = self.listening.getsockname()[1]
        self.connections = []
        threading.Thread(target=self._accept, daemon=True).start()

    def talk(self, connection):
        """What becomes of a connection; it may raise OSError and EOFError."""
        raise NotImplementedError

    def _accept(self):
        while True:
            try:
                connection, _ = self.listening.accept()
            except OSError:  # closed
                return
            self.connections.append(connection)
            threading.Thread(target=self._talk, args=(connection,), daemon=True).start()

    def _talk(self, connection):
        try:
            self.talk(connection)
        except (EOFError, OSError):
            pass
        finally:
            connection.close()

    def close(self):
        """Close the port and its connections."""
        for each in [self.listening] + self.connections:
            try:
                each.shutdown(socket.SHUT_RDWR)  # wakes up the thread that waits
            except OSError:
                pass
            each.close()
