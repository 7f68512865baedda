"""Ports that forward GIOP to others, and change what passes: references in answers lead to such ports, too,
and those in questions back to what is behind them.
"""
import re
import socket
import struct
import threading

import listening
from mock_components import giop
from rtshell_lite.giop import messages

HOST = re.compile(rb"127\.0\.0\.1\0(..)", re.DOTALL)  # of a reference; the port follows


class Front(listening.Listener):
    """The port of a relay in front of another port."""

    def __init__(self, relay, behind):
        self.relay = relay
        self.behind = behind
        super().__init__()

    def talk(self, client):
        with socket.create_connection(("127.0.0.1", self.behind)) as server:
            while self.relay.pass_on(client, server):
                pass


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
                self.fronts[port] = Front(self, port).port
                self._real[self.fronts[port]] = port
            return self.fronts[port]

    def refused(self, message):
        """What is answered to a message in place of its receiver, or None."""

    def asked(self, message):
        """What is sent for a message of a client."""
        return message

    def passed(self, request, reply):
        """The octets that are sent for a reply, given whole."""
        raise NotImplementedError

    def pass_on(self, client, server):
        """Pass on a message of a client, and the answer to it; returns whether more may follow."""
        header, payload = giop.read_message(client)
        refused = self.refused(header + payload)
        if refused:
            client.sendall(refused)
            return True
        server.sendall(self.asked(HOST.sub(self._behind, header + payload)))
        if header[7] != giop.REQUEST:
            client.sendall(b"".join(giop.read_message(server)))
            return True
        request = giop.parse_request(header + payload)
        if not request.expects_reply:
            return True
        client.sendall(self.passed(request, HOST.sub(self._to_front, _whole(server))))
        return not self.closes

    def _to_front(self, host):
        port, = struct.unpack("<H", host.group(1))
        return b"127.0.0.1\0" + struct.pack("<H", self.front(port))

    def _behind(self, host):
        port, = struct.unpack("<H", host.group(1))
        return b"127.0.0.1\0" + struct.pack("<H", self._real.get(port, port))


def _whole(server):
    """The next message, put together from its fragments."""
    parts = messages.Fragments()
    data = None
    while data is None:
        data = parts.joined(b"".join(giop.read_message(server)), lambda number: messages.LARGEST)
    order = "<" if data[6] & messages.LITTLE else ">"
    return messages.whole(data[7], data[messages.HEADER:], data[5], order)
