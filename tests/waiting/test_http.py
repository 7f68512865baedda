"""The small HTTP server of rttop --serve: if one of these fails, a client that is slow or hostile costs
others the page.
"""
import socket
import time
import unittest
from unittest import mock

import loops
from rtshell_lite.net import http, loop, tcp

LIMIT = 30.0  # seconds that anything may take on a busy machine
PAGE = b"x" * 300000
LARGE = b"x" * 30000000  # more than sockets hold


class Serving(loops.Serving):
    """The server on a thread: /page, /stream which sends three parts and goes on until the client leaves,
    else 404.
    """

    def __init__(self):
        self.listener = tcp.listen("127.0.0.1", 0)
        self.port = self.listener.getsockname()[1]
        self.ended = []  # streams that have ended
        self.asked = []
        super().__init__(LIMIT)

    async def serve(self):
        async with loop.background(http.serve(self.listener, self.answer)):
            await super().serve()

    def answer(self, request):
        self.asked.append(request)
        if request.target == "/page":
            return http.Answer(200, "text/plain", PAGE, (("X-More", "yes"),))
        if request.target == "/large":
            return http.Answer(200, "text/plain", LARGE, ())
        if request.target == "/endless":
            return http.Answer(200, "text/event-stream", self.endless, ())
        if request.target == "/stream":
            return http.Answer(200, "text/event-stream", self.stream, ())
        raise http.Refused(404)

    async def stream(self, connection):
        try:
            for number in range(3):
                await connection.send(b"data: %d\n\n" % number)
            while True:
                connection.check()
                await loop.sleep(0.02)
        finally:
            self.ended.append(connection)

    async def endless(self, connection):
        try:
            while True:
                await connection.send(PAGE)
        finally:
            self.ended.append(connection)

    def close(self):
        super().close()
        self.listener.close()


class Answers(unittest.TestCase):
    def setUp(self):
        self.serving = Serving()
        self.addCleanup(self.serving.close)

    def connect(self, octets=b""):
        made = socket.create_connection(("127.0.0.1", self.serving.port), LIMIT)
        self.addCleanup(made.close)
        made.sendall(octets)
        return made

    def ask(self, octets):
        """The (status, headers, content) of the answer to some octets."""
        made = self.connect(octets)
        return self.read(made)

    def read(self, made):
        with made.makefile("rb") as file:
            head, _, content = file.read().partition(b"\r\n\r\n")
        first, *lines = head.decode().split("\r\n")
        return int(first.split()[1]), dict(line.split(": ", 1) for line in lines), content

    def status(self, octets):
        return self.ask(octets)[0]

    def still_served(self):
        self.assertEqual(self.status(b"GET /page HTTP/1.1\r\nHost: here\r\n\r\n"), 200)


class Requests(Answers):
    def test_a_page(self):
        status, headers, content = self.ask(b"GET /page HTTP/1.1\r\nHost: here:80\r\nX-One:  a b \r\n\r\n")
        self.assertEqual((status, headers["Content-Length"], headers["X-More"]), (200, str(len(PAGE)), "yes"))
        self.assertEqual((headers["Connection"], headers["X-Content-Type-Options"]), ("close", "nosniff"))
        self.assertEqual(content, PAGE)
        self.assertEqual(self.serving.asked[0],
                         http.Request("GET", "/page", {"host": "here:80", "x-one": "a b"}, "127.0.0.1"))

    def test_octet_by_octet(self):
        made = self.connect()
        for octet in b"GET /page HTTP/1.0\r\n\r\n":
            made.sendall(bytes([octet]))
        self.assertEqual(self.read(made)[0], 200)

    def test_head(self):
        status, headers, content = self.ask(b"HEAD /page HTTP/1.1\r\n\r\n")
        self.assertEqual((status, headers["Content-Length"], content), (200, str(len(PAGE)), b""))
        self.assertEqual(self.ask(b"HEAD /stream HTTP/1.1\r\n\r\n")[::2], (200, b""))

    def test_a_stream_until_the_client_leaves(self):
        made = self.connect(b"GET /stream HTTP/1.1\r\n\r\n")
        with made.makefile("rb") as file:
            lines = list(iter(file.readline, b"data: 2\n"))
            self.assertIn(b"Content-Type: text/event-stream\r\n", lines)
            self.assertFalse([line for line in lines if line.startswith(b"Content-Length")])
            self.assertFalse(self.serving.ended)
        made.close()
        while not self.serving.ended:
            self.still_served()

    def test_refused(self):
        for octets, status in (
            (b"GET /other HTTP/1.1\r\n\r\n", 404),
            (b"POST /page HTTP/1.1\r\n\r\n", 405),
            (b"PUT /page HTTP/1.1\r\n\r\n", 405),
            (b"GET /page HTTP/2.0\r\n\r\n", 505),
            (b"GET /page\r\n\r\n", 400),
            (b"GET page HTTP/1.1\r\n\r\n", 400),
            (b"\r\n\r\n", 400),
            (b"GET http://here/page HTTP/1.1\r\n\r\n", 400),
            (b"GET /pa ge HTTP/1.1\r\n\r\n", 400),
            (b"GET /page HTTP/1.1\r\nHost: a\r\nHOST: b\r\n\r\n", 400),
            (b"GET /page HTTP/1.1\r\nOrigin: a\r\nOrigin: a\r\n\r\n", 400),
            (b"GET /page HTTP/1.1\r\nfolded: a\r\n b\r\n\r\n", 400),
            (b"GET /page HTTP/1.1\r\nno colon\r\n\r\n", 400),
            (b"GET /page HTTP/1.1\r\na: \0\r\n\r\n", 400),
            (b"GET /page HTTP/1.1\nHost: a\r\n\r\n", 400),
            (b"GET /\xe9 HTTP/1.1\r\n\r\n", 400),
            (b"GET /page HTTP/1.1\r\nContent-Length: 3\r\n\r\nabc", 400),
            (b"GET /page HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n", 400),
        ):
            self.assertEqual(self.status(octets), status, octets)
        self.still_served()


class Hostile(Answers):
    def test_endless_heads(self):
        self.assertEqual(self.status(b"GET /page HTTP/1.1\r\n" + b"a: b\r\n" * 5000), 431)
        self.assertEqual(self.status(b"x" * 100000), 431)
        self.still_served()

    def test_silence(self):
        with mock.patch.object(http, "PATIENCE", 0.2):
            quiet = self.connect()
            half = self.connect(b"GET /page HT")
            self.assertEqual([self.read(made)[0] for made in (quiet, half)], [408, 408])
        self.still_served()

    def test_a_reader_that_takes_nothing_is_dropped(self):
        with mock.patch.object(http, "STALLED", 0.2):
            self.connect(b"GET /endless HTTP/1.1\r\n\r\n")
            while not self.serving.ended:
                self.still_served()

    def test_a_slow_reader_is_dropped(self):
        with mock.patch.object(http, "SLOWEST", 0.2), mock.patch.object(http, "FAREWELL", 0.2):
            made = self.connect(b"GET /large HTTP/1.1\r\n\r\n")
            self.assertLess(self.taken_from(made), len(LARGE))

    def taken_from(self, made):
        """How many octets come until the end of a connection, from which little is taken until it is dropped.
        """
        count = 0
        try:
            while True:
                is_slow = not self.serving.ended
                some = made.recv(1000 if is_slow else 1000000)
                if not some:
                    return count
                count += len(some)
                if is_slow:
                    self.still_served()
        except ConnectionError:
            return count

    def test_readers_that_leave_at_once_do_no_harm(self):
        for _ in range(200):
            made = socket.create_connection(("127.0.0.1", self.serving.port), LIMIT)
            made.sendall(b"GET /page HTTP/1.1\r\n\r\n")
            made.close()
        self.still_served()

    def test_a_crowd_gives_its_place(self):
        """Those who have asked for nothing; those who look at a page keep theirs."""
        looking = self.connect(b"GET /stream HTTP/1.1\r\n\r\n")
        with looking.makefile("rb") as file:
            file.readline()
            crowd = [self.connect() for _ in range(3 * http.MOST)]
            self.still_served()
            self.assertFalse(self.serving.ended)
        crowd[-1].sendall(b"GET /page HTTP/1.1\r\n\r\n")
        self.assertEqual(self.read(crowd[-1])[0], 200)

    def test_a_crowd_that_looks(self):
        """The oldest of the address that has most gives its place: idle streams took all, for ever."""
        with socket.socket() as other:
            other.bind(("127.0.0.2", 0))
            other.settimeout(LIMIT)
            other.connect(("127.0.0.1", self.serving.port))
            other.sendall(b"GET /stream HTTP/1.1\r\n\r\n")
            self.assertEqual(other.recv(8), b"HTTP/1.1")
            crowd = [self.connect(b"GET /stream HTTP/1.1\r\n\r\n") for _ in range(http.MOST - 1)]
            for each in crowd:
                self.assertEqual(each.recv(8), b"HTTP/1.1")
            self.assertFalse(self.serving.ended)
            self.assertEqual(self.status(b"GET /page HTTP/1.1\r\n\r\n"), 200)
            while not self.serving.ended:
                time.sleep(0.01)
            (left,) = self.serving.ended
            self.assertEqual(left.address, "127.0.0.1")
            with crowd[0].makefile("rb") as file:
                file.read()  # which ends

    def test_headers_that_are_there_twice(self):
        for header in "Content-Length: 0", "Host: a", "Origin: a", "Last-Event-ID: 1":
            self.assertEqual(
                self.status(f"GET /page HTTP/1.1\r\n{header}\r\n{header}\r\n\r\n".encode()), 400
            )
        self.assertEqual(self.status(b"GET /page HTTP/1.1\r\nContent-Length: 0\r\n\r\n"), 200)


if __name__ == "__main__":
    unittest.main()
