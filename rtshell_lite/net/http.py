"""A small HTTP/1.1 server on the loop, for a page that a few people look at: it answers GET, one request a
connection.

Who connects may send anything, slowly, or nothing. So the head of a request has a largest size and a time in
which it must come, there is no body, an answer has a time in which it must leave, and the number of
connections has a limit. Of more, one that gets nothing is closed, else the oldest one of the address that has
most; a browser whose stream ends so connects again.
"""

import collections
import re

from rtshell_lite.net import loop, real, tcp

MOST = 64  # connections
LONGEST = 8192  # octets of the head of a request; those of browsers have 500 to 2,000
PATIENCE = 10.0  # seconds in which the head must come
STALLED = 20.0  # seconds for which nothing may leave while somebody waits for an answer
SLOWEST = 120.0  # seconds in which an answer must have left that is no stream
FAREWELL = 1.0  # seconds for which what a client still sends is read, so that it can read the answer
PAUSE = 1.0  # seconds until connections are accepted again, where there are no files left

WORDS = {
    200: "OK",
    400: "Bad Request",
    403: "Forbidden",
    404: "Not Found",
    405: "Method Not Allowed",
    408: "Request Timeout",
    431: "Request Header Fields Too Large",
    505: "HTTP Version Not Supported",
}
ALWAYS = (
    ("Cache-Control", "no-store"),
    ("Connection", "close"),
    ("Cross-Origin-Resource-Policy", "same-origin"),
    ("Referrer-Policy", "no-referrer"),
    ("X-Content-Type-Options", "nosniff"),
    ("X-Frame-Options", "DENY"),
)
# headers that a request has once at most: of two, others might believe the other one
ONCE = ("host", "origin", "content-length", "transfer-encoding", "last-event-id")
_REQUEST = re.compile(rb"([A-Z]{1,20}) (/[!-~]*) HTTP/(\d)\.(\d)\Z")
_HEADER = re.compile(rb"([!#$%&'*+.^_`|~0-9A-Za-z-]+):[ \t]*([ \t!-~\x80-\xff]*)\Z")

# What a client asks for: the target as it was sent; {name in small letters: value} of the headers; the IP
# address of this host that it has connected with.
Request = collections.namedtuple("Request", "method target headers here")

# What it gets: status; type of the content; the content, octets, or for a stream that lasts a coroutine
# function that is called with the HttpConnection; further headers, (name, value).
Answer = collections.namedtuple("Answer", "status kind content headers")


class Refused(Exception):
    """A request that is answered by nothing but a status."""

    def __init__(self, status):
        super().__init__(status)
        self.status = status


class Gone(Exception):
    """The client has left, or takes nothing any more."""


def refusal(status):
    """An Answer with no more than a status."""
    return Answer(status, "text/plain; charset=utf-8", WORDS[status].encode() + b"\n", ())


async def serve(listener, answer):
    """Accept connections at a listening socket for ever, and answer each as the function answer(Request)
    says, which returns an Answer. No failure of a connection ends it.
    """
    open_ones = []  # HttpConnections, the oldest first
    async with loop.Group() as group:
        while True:
            await loop.ready(listener.fileno(), loop.READ)
            try:
                accepted, (address, *_) = listener.accept()
            except (BlockingIOError, ConnectionError):
                continue  # gone already
            except OSError:  # out of files
                if not _make_room(open_ones):
                    await loop.sleep(PAUSE)
                continue
            if len(open_ones) >= MOST:
                _make_room(open_ones)
            connection = HttpConnection(accepted, address)
            open_ones.append(connection)
            connection.task = group.start(_attend(connection, answer, open_ones))


def _make_room(open_ones):
    """Close the oldest HttpConnection that gets nothing, or of the address that has most; False if nobody is
    connected.
    """
    if not open_ones:
        return False
    counts = collections.Counter(connection.address for connection in open_ones)
    leaving = min(open_ones, key=lambda connection: (connection.is_welcome, -counts[connection.address]))
    open_ones.remove(leaving)
    leaving.task.cancel()  # which closes it
    return True


async def _attend(connection, answer, open_ones):
    """Answer one HttpConnection, whatever it does, and close it."""
    try:
        connection.socket.setblocking(False)
        await _answer(connection, answer)
    except (Gone, OSError):
        pass
    finally:
        if connection in open_ones:
            open_ones.remove(connection)
        connection.socket.close()


async def _answer(connection, answer):
    method = "GET"
    try:
        request = await loop.within(PATIENCE, connection.request(), Refused(408))
        method = request.method
        response = answer(request)
    except Refused as e:
        response = refusal(e.status)
    connection.is_welcome = response.status == 200
    is_stream = callable(response.content)
    headers = [("Content-Type", response.kind)] + list(ALWAYS) + list(response.headers)
    if not is_stream:
        headers.append(("Content-Length", len(response.content)))
    lines = [f"HTTP/1.1 {response.status} {WORDS[response.status]}"]
    lines += [f"{name}: {value}" for name, value in headers]
    head = "\r\n".join(lines + ["", ""]).encode()
    if is_stream and method == "GET":
        await connection.send(head)
        await response.content(connection)
    elif method == "HEAD" or is_stream:
        await connection.send(head)
    else:
        await loop.within(SLOWEST, connection.send(head, response.content), Gone())
    connection.is_welcome = False
    connection.socket.shutdown(real.SENDING)
    await loop.within(FAREWELL, connection.read_all(), Gone())


class HttpConnection:
    """One client, from an address.

    is_welcome  whether it gets what it has asked for
    task        what attends to it
    """

    def __init__(self, accepted, address):
        self.socket = accepted
        self.address = address
        self.is_welcome = False
        self.task = None  # type: loop.Task

    async def request(self):
        """The Request that it sends. Raises Refused, Gone, OSError."""
        head = bytearray()
        while b"\r\n\r\n" not in head:
            if len(head) > LONGEST:
                raise Refused(431)
            head += await self._some()
        lines = bytes(head).partition(b"\r\n\r\n")[0].split(b"\r\n")
        method, target = _parsed_line(lines[0])
        return Request(method, target, _parsed_headers(lines[1:]), self.socket.getsockname()[0])

    async def _some(self):
        """The next octets that come. Raises Gone, OSError."""
        some = await tcp.receive(self.socket, 4096)
        if not some:
            raise Gone
        return some

    async def read_all(self):
        """Read, and forget, what comes until the end. Raises Gone, then, OSError."""
        while True:
            await self._some()

    async def send(self, *parts):
        """Send octets: returns when all have left. Raises Gone, OSError."""
        for part in parts:
            rest = memoryview(part)
            while rest:
                try:
                    rest = rest[self.socket.send(rest) :]
                except BlockingIOError:
                    await loop.within(STALLED, loop.ready(self.socket.fileno(), loop.WRITE), Gone())

    def check(self):
        """Raises Gone where a client has left that had no more to send, OSError."""
        try:
            if not self.socket.recv(4096):
                raise Gone
        except BlockingIOError:
            pass


def _parsed_line(line):
    """(method, target) of the first line of a request. Raises Refused."""
    match = _REQUEST.match(line)
    if match is None:
        raise Refused(400)
    method, target, major, minor = match.groups()
    if (major, minor) not in ((b"1", b"0"), (b"1", b"1")):
        raise Refused(505)
    if method not in (b"GET", b"HEAD"):
        raise Refused(405)
    return method.decode(), target.decode()


def _parsed_headers(lines):
    """{name in small letters: value}. Raises Refused: for what names are twice, and for a body, too."""
    headers = {}
    for line in lines:
        match = _HEADER.match(line)
        if match is None:
            raise Refused(400)
        name, value = [part.decode("latin-1") for part in match.groups()]
        if name.lower() in headers and name.lower() in ONCE:
            raise Refused(400)
        headers[name.lower()] = value.strip()
    if "transfer-encoding" in headers or headers.get("content-length", "0") != "0":
        raise Refused(400)
    return headers
