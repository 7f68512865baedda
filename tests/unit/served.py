"""Servants of our own ORB, and those that call them."""
import socket
import struct
import unittest

import loops
from giop_client import Observer, Port, request
from mock_components import giop
from rtshell_lite.corba.iiop import server
from rtshell_lite.giop import ior, messages

LIMIT = 60.0  # seconds that anything may take on a busy machine
CLOSE, ERROR = messages.whole(messages.CLOSE), messages.whole(messages.ERROR)


class Client:
    """A connection to our server."""

    def __init__(self, port):
        self.socket = socket.create_connection(("127.0.0.1", port), LIMIT)

    def send(self, *messages):
        self.socket.sendall(b"".join(messages))

    def answer(self):
        """The next message, or b"" at the end."""
        try:
            return b"".join(giop.read_message(self.socket))
        except EOFError:
            return b""

    def ask(self, *messages):
        self.send(*messages)
        return self.answer()

    def last_words(self):
        """All that still comes until the connection is closed."""
        found = b""
        while True:
            try:
                piece = self.socket.recv(65536)
            except ConnectionResetError:  # closed while we were sending
                return found
            if not piece:
                return found
            found += piece

    def close(self):
        self.socket.close()


def result(message):
    """What a reply says: the octets of its results, or the name of the system exception and whether it was
    completed.
    """
    number, status, little, at = messages.reply(message)
    if status == messages.NO_EXCEPTION:
        return message[at:]
    assert status == messages.SYSTEM_EXCEPTION, message
    size, = struct.unpack_from("<I", message, at)
    name = message[at + 4:at + 3 + size].decode()
    completed = struct.unpack_from("<I", message, len(message) - 4)[0]
    return name[len("IDL:omg.org/CORBA/"):-len(":1.0")], completed


class Served(unittest.TestCase):
    """Base of test cases: servants, and clients of them."""

    def setUp(self):
        self.serving = loops.Serving(LIMIT)
        self.addCleanup(self.serving.close)
        self.port = Port()
        self.observer = Observer()
        self.key, self.withdraw = self.serve(self.port)
        self.observed, _ = self.serve(self.observer)

    @property
    def server(self):
        """The server.Server."""
        return self.serving.loop.server

    def serve(self, servant):
        found, withdraw = self.serving.call(server.serve, servant)
        address = ior.address(found.text())
        self.at = address.port
        return address.key, withdraw

    def client(self):
        made = Client(self.at)
        self.addCleanup(made.close)
        return made

    def ask(self, *arguments, **keywords):
        return result(self.client().ask(request(*arguments, **keywords)))

    def still_served(self):
        self.assertEqual(self.ask(self.key, "_non_existent"), b"\0")
