"""Processes, in threads of this one, that answer in GIOP what a test of our own ORB has given them."""
import unittest
from unittest import mock

import listening
from rtshell_lite.corba import orb, session
from rtshell_lite.corba.iiop import client
from rtshell_lite.giop import messages
from rtshell_lite.net import loop

CLOSE = messages.whole(messages.CLOSE)


class Peer(listening.Listener):
    """A process that answers each message with the next of some octets; what is None closes the connection.
    `last` came last.
    """

    def __init__(self, *answers):
        self.answers = list(answers)
        self.asked = 0
        super().__init__()

    def talk(self, connection):
        for self.last in iter(lambda: connection.recv(65536), b""):
            self.asked += 1
            answer = self.answers.pop(0) if self.answers else b""
            connection.sendall(answer or b"")
            if answer is None or answer.endswith(CLOSE):
                break


class Script(listening.Listener):
    """A process that reads the requests of its connections, and answers them as a function says.

    `play(requests)` gets the (number, operation) pairs that have come so far and returns octets to send, or
    None to wait for more.
    """

    def __init__(self, play):
        self.play = play
        self.most = 0
        super().__init__()
        self.ref = client.from_url("w", "corbaloc::127.0.0.1:%d/x" % self.port)

    def talk(self, connection):
        data = b""
        pending = []
        while True:
            piece = connection.recv(65536)
            if not piece:
                return
            data += piece
            while len(data) >= 12 and len(data) >= 12 + messages.size(data):
                size = 12 + messages.size(data)
                pending.append(
                    (messages.number(data), b"_is_a" if b"_is_a" in data[:size] else b"_non_existent")
                )
                data = data[size:]
            self.most = max(self.most, len(pending))
            reply = self.play(pending)
            if reply:
                connection.sendall(reply)
            if reply == b"":
                return


class Calls(unittest.TestCase):
    """Tests of many calls at once on this thread, which have 2 s, to processes that follow scripts."""

    def setUp(self):
        self.session = session.Session(2)
        patched = mock.patch.object(orb, "_orb", client)
        patched.start()
        self.addCleanup(patched.stop)

    def wait_for(self, coroutine):
        """The result of a coroutine, or what it raises."""
        return loop.run(coroutine, session=self.session)

    def script(self, play):
        """A process that answers what has come as `play` says."""
        made = Script(play)
        self.addCleanup(made.close)
        return made

    def run_tasks(self, *jobs):
        """The values of coroutine functions, each a job of the process of a reference."""
        async def main():
            return await session.each(jobs, lambda job: job[1](), lambda job: (job[0].address[1:3], "job"))

        return self.wait_for(main())

    def script_of(self, replies):
        """A process that answers all that has come with replies(number) each."""
        def play(pending):
            octets = b"".join(replies(number) for number, _ in pending)
            pending.clear()
            return octets or None
        return self.script(play)

    def asking(self, ref, operation="_non_existent"):
        """A job of the process of a reference that asks one question."""
        async def ask():
            return await orb.call("w", ref, operation)
        return ref, ask
