"""Ports that forward GIOP to others, and change what passes: references in answers lead to such ports, too,
and those in questions back to what is behind them.
"""
import re
import socket
import struct
import threading

from mock_components import giop

HOST = re.compile(rb"127\.0\.0\.1\0(..)", re.DOTALL)  # of a reference; the port follows


class Relay:
    """Subclasses say what they make of what passes. `closes`: the connection is closed after each reply."""

    closes = False

    def __init__(self):
        # ports: of ours by those behind, and the reverse
        self.fronts = {}
        self._real = {}
        self._lock = threading.Lock()

    def front(self, port):
        """The port in front of another one."""
        with self._lock:
            if port not in self.fronts:
                listener = socket.socket()
                listener.bind(("127.0.0.1", 0))
                listener.listen(64)
                self.fronts[port] = listener.getsockname()[1]
                self._real[self.fronts[port]] = port
                threading.Thread(target=self._accept, args=(listener, port), daemon=True).start()
            return self.fronts[port]

    def refused(self, message):
        """What is answered to a message in place of its receiver, or None."""

    def asked(self, message):
        """What is sent for a message of a client."""
        return message

    def passed(self, request, reply):
        """The octets that are sent for a reply, given whole."""
        raise NotImplementedError

    def _accept(self, listener, port):
        while True:
            threading.Thread(target=self._pass_on, args=(listener.accept()[0], port), daemon=True).start()

    def _pass_on(self, client, port):
        server = socket.create_connection(("127.0.0.1", port))
        try:
            while True:
                header, payload = giop.read_message(client)
                refused = self.refused(header + payload)
                if refused:
                    client.sendall(refused)
                    continue
                server.sendall(self.asked(HOST.sub(self._behind, header + payload)))
                if header[7] != giop.REQUEST:
                    client.sendall(b"".join(giop.read_message(server)))
                    continue
                request = giop.parse_request(header + payload)
                if request.expects_reply:
                    client.sendall(self.passed(request, HOST.sub(self._to_front, _whole(server))))
                    if self.closes:
                        return
        except (EOFError, OSError):
            pass
        finally:
            client.close()
            server.close()

    def _to_front(self, host):
        port, = struct.unpack("<H", host.group(1))
        return b"127.0.0.1\0" + struct.pack("<H", self.front(port))

    def _behind(self, host):
        port, = struct.unpack("<H", host.group(1))
        return b"127.0.0.1\0" + struct.pack("<H", self._real.get(port, port))


def _whole(server):
    """The next message, put together from its fragments."""
    header, payload = giop.read_message(server)
    more = header[6] & 2
    while more:
        following, piece = giop.read_message(server)
        more = following[6] & 2
        payload += piece[4 if following[5] == 2 else 0:]  # in GIOP 1.2, each begins with the request's number
    return header[:6] + bytes([header[6] & 1]) + header[7:8] + struct.pack("<I", len(payload)) + payload
