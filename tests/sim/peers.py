"""Processes of a simulated world that answer in GIOP what a test of our own ORB has given them, and one that
asks them.
"""

import unittest
from unittest import mock

import world
from giop_client import answer

from rtshell_lite.corba import orb, session
from rtshell_lite.corba.iiop import client
from rtshell_lite.giop import descriptors, marshal, messages
from rtshell_lite.net import loop, tcp

CLOSE = messages.whole(messages.CLOSE)
MOST = 65536  # octets that are read at a time
SECONDS = 1000.0  # of the world, after which whatever is under way counts as endless
ABSENT = 9.0e9  # seconds for which nobody is woken by the time


def compute(seconds):
    """Keep the process that calls this from doing anything else for a time."""
    loop.world().compute(seconds)


class Listener:
    """A process that gives each connection to `talk`, a coroutine function, which may raise OSError.

    program      its world.Program
    connections  all that it has accepted
    ref          an object in it
    """

    def __init__(self, host, port=None):
        self.port = port or host.free_port()
        self.connections = []
        self.ref = client.from_url("w", f"corbaloc::127.0.0.1:{self.port}/x")
        self._end = loop.Bell()
        self.program = world.Program(host, f"peer at {self.port}", self._main)

    async def talk(self, connection):
        raise NotImplementedError

    def _main(self):
        loop.run(self._serve())

    def close(self):
        """Have it end."""
        self._end.ring()
        self.program.wake()

    async def _serve(self):
        async with loop.background(self._accept(tcp.listen("", self.port))):
            await self._end.wait()

    async def _accept(self, listener):
        async with loop.Group() as group:
            while True:
                await loop.ready(listener.fileno(), loop.READ)
                connection, _ = listener.accept()
                self.connections.append(connection)
                group.start(self._attend(connection))

    async def _attend(self, connection):
        try:
            await self.talk(connection)
        except OSError:
            pass
        finally:
            connection.close()


def forward(ref, number):
    """An answer that forwards to another object."""
    body = bytearray(24)
    marshal.Maker("<").writer((descriptors.OBJECT, "", ""))(body, ref)
    return answer(number, bytes(body[24:]), messages.FORWARD)


async def send(connection, octets):
    """Send all of it."""
    left = memoryview(octets)
    while left:
        await loop.ready(connection.fileno(), loop.WRITE)
        left = left[connection.send(left) :]


class Peer(Listener):
    """Answers each message with the next of some octets; what is None closes the connection.

    asked  how many messages have come, of which `last` is the last
    """

    def __init__(self, host, *answers, port=None):
        self.answers = list(answers)
        self.asked = 0
        self.last = None
        super().__init__(host, port)

    async def talk(self, connection):
        while True:
            octets = await tcp.receive(connection, MOST)
            if not octets:
                return
            self.last = octets
            self.asked += 1
            reply = self.answers.pop(0) if self.answers else b""
            await send(connection, reply or b"")
            if reply is None or reply.endswith(CLOSE):
                return


class Script(Listener):
    """Reads the requests of its connections, and answers them as a function says.

    `play(requests)` gets the (number, operation) pairs that have come so far and returns octets to send, None
    to wait for more, or b"" to close the connection. `most` of them have waited at a time.
    """

    def __init__(self, host, play):
        self.play = play
        self.most = 0
        super().__init__(host)

    async def talk(self, connection):
        data = b""
        pending = []
        while True:
            octets = await tcp.receive(connection, MOST)
            if not octets:
                return
            data += octets
            while len(data) >= messages.HEADER and len(data) >= messages.HEADER + messages.size(data):
                size = messages.HEADER + messages.size(data)
                operation = b"_is_a" if b"_is_a" in data[:size] else b"_non_existent"
                pending.append((messages.number(data), operation))
                data = data[size:]
            self.most = max(self.most, len(pending))
            reply = self.play(pending)
            if reply == b"":
                return
            await send(connection, reply or b"")


class Caller:
    """A process that runs coroutines of a test, one after the other, by a `session` that it keeps."""

    def __init__(self, host, timeout):
        self.session = None
        self._timeout = timeout
        self._jobs = []
        self._outcome = None
        self._program = world.Program(host, "caller", self._main)

    def _main(self):
        self.session = session.Session(self._timeout)
        while True:
            while not self._jobs:
                self._program.wait(ABSENT)
            job = self._jobs.pop()
            if job is None:
                return
            try:
                self._outcome = loop.run(*job, self.session), None
            except (Exception, KeyboardInterrupt) as e:
                self._outcome = None, e

    def close(self):
        """Have it end."""
        self._jobs.append(None)
        self._program.wake()

    def run(self, coroutine, signals=None):
        """Its result, or what it raises; `signals` as of loop.run."""
        self._jobs.append((coroutine, signals))
        self._outcome = None
        self._program.wake()
        here = self._program.world
        here.run(here.time + SECONDS, lambda: self._outcome is not None)
        if self._outcome is None:
            raise AssertionError(f"it does not end within {SECONDS} s")
        result, error = self._outcome
        if error is not None:
            raise error
        return result


class Calls(unittest.TestCase):
    """Tests of calls, which have 2 s, to processes of the same host."""

    def setUp(self):
        patched = mock.patch.object(orb, "_orb", client)
        patched.start()
        self.addCleanup(patched.stop)
        self.world = world.World(1)
        self.addCleanup(self.world.end)
        self.host = self.world.host("here", "10.0.0.1")
        self._caller = Caller(self.host, 2.0)
        self._processes = [self._caller]
        self.addCleanup(self.end)
        self.world.run(0.0)  # it has begun
        self.session = self._caller.session

    def end(self):
        """Have all processes end, as far as they do."""
        for process in self._processes:
            process.close()
        self.world.run(self.world.time + 1)

    def serve(self, process):
        """Have a process end with the test; returns it."""
        self._processes.append(process)
        return process

    def wait_for(self, coroutine, signals=None):
        """The result of a coroutine, or what it raises; `signals` as of loop.run."""
        return self._caller.run(coroutine, signals)

    def seconds(self, coroutine):
        """How long it takes, and its result."""
        begun = self.world.time
        result = self.wait_for(coroutine)
        return self.world.time - begun, result

    def peer(self, *answers):
        return self.serve(Peer(self.host, *answers))

    def script(self, play):
        return self.serve(Script(self.host, play))

    def script_of(self, replies):
        """A process that answers all that has come with replies(number) each."""

        def play(pending):
            octets = b"".join(replies(number) for number, _ in pending)
            pending.clear()
            return octets or None

        return self.script(play)

    def run_tasks(self, *jobs):
        """The values of coroutine functions, each a job of the process of a reference."""
        return self.wait_for(tasks(*jobs))

    def asking(self, ref, operation="_non_existent"):
        """A job of the process of a reference that asks one question."""
        return ref, lambda: orb.call("w", ref, operation)


async def tasks(*jobs):
    """The values of coroutine functions, each a job of the process of a reference."""
    return await session.each(jobs, lambda job: job[1](), lambda job: (job[0].address[1:3], "job"))
