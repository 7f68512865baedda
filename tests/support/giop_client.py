"""Who calls our own ORB: GIOP by hand, right and wrong, and servants to be called."""
import socket
import struct
import threading
import unittest

from mock_components import giop
from rtshell_lite.corba import session
from rtshell_lite.corba.iiop import server
from rtshell_lite.giop import descriptors, idl, ior, messages, requests
from rtshell_lite.net import loop

LIMIT = 60.0  # seconds that anything may take on a busy machine
PORT_OK = descriptors.items(idl.descriptor("IDL:OpenRTM/PortStatus:1.0"))[0]
CLOSE, ERROR = messages.whole(messages.CLOSE), messages.whole(messages.ERROR)


class Port:
    """A servant that keeps what it is given."""

    interface = "OpenRTM.InPortCdr"

    def __init__(self):
        self.taken = []
        self.came = threading.Semaphore(0)

    def put(self, data):
        if data == b"raise":
            raise LookupError("a fault of ours")
        self.taken.append(data)
        self.came.release()
        return PORT_OK


class Observer:
    """A servant of an interface that inherits, with an operation that is oneway."""

    interface = "OpenRTM.ComponentObserver"

    def __init__(self):
        self.heard = []

    def update_status(self, kind, hint):
        self.heard.append((kind._n, hint))


def request(key, operation, body=b"", number=1, minor=2, order="<", is_answered=True, contexts=b"",
            kind=requests.REQUEST):
    """A Request, or a LocateRequest, as octets. `contexts`: octets of one service context, which is ignored.
    """
    out = bytearray(messages.HEADER)

    def align(size):
        out.extend(b"\xee" * (-len(out) % size))  # padding is what happens to be in memory

    def put(value):
        align(4)
        out.extend(struct.pack(order + "I", value))

    def put_octets(data):
        put(len(data))
        out.extend(data)

    def put_contexts():
        put(bool(contexts))
        if contexts:
            put(7)
            put_octets(contexts)

    asks = kind == requests.REQUEST
    if asks and minor < 2:
        put_contexts()
    put(number)
    if asks:
        out.append(3 * is_answered if minor == 2 else is_answered)
    if minor == 2:
        align(4)
        out.extend(struct.pack(order + "H", 0))
    put_octets(key)
    if asks:
        put_octets(operation.encode() + b"\0")
    if asks and minor < 2:
        put_octets(b"who")
    elif asks:
        put_contexts()
    if body:
        align(4 if minor < 2 or not asks else 8)
    return messages.whole(kind, bytes(out[messages.HEADER:]) + body, minor, order)


def block(data, order="<"):
    return struct.pack(order + "I", len(data)) + data


def text(words, order="<"):
    return block(words.encode() + b"\0", order)


def fragments(message, *cuts):
    """A message as one with fragments, cut at these places."""
    order = "<" if message[6] & 1 else ">"
    minor = message[5]
    number = message[12:16] if minor == 2 else b""
    first, *others = [message[a:b] for a, b in zip((12,) + cuts, cuts + (len(message),))]
    found = [messages.whole(message[7], first, minor, order, bool(others))]
    for left, part in zip(reversed(range(len(others))), others):
        found.append(messages.whole(messages.FRAGMENT, number + part, minor, order, left > 0))
    return found


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


class Serving:
    """A loop on a thread, which serves."""

    def __init__(self):
        self.loop = None
        self._began = threading.Event()
        self._over = loop.Bell()
        self._thread = threading.Thread(
            target=lambda: loop.run(self._run(), session=session.Session(LIMIT)), daemon=True
        )
        self._thread.start()
        self._began.wait()

    async def _run(self):
        self.loop = loop.current()
        self.loop.make_bell()
        self._began.set()
        await self._over.wait()

    def call(self, function, *args):
        """What function(*args) returns, or raises, on that thread."""
        box = []
        done = threading.Event()

        def work():
            try:
                box.append((function(*args), None))
            except Exception as e:
                box.append((None, e))
            done.set()
        self.loop.post(work)
        done.wait()
        (value, error), = box
        if error is not None:
            raise error
        return value

    def close(self):
        self.loop.post(self._over.ring)
        self._thread.join()


class Served(unittest.TestCase):
    """Base of test cases: servants, and clients of them."""

    def setUp(self):
        self.serving = Serving()
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
