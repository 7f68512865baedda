"""Our own ORB, peers that do not answer: who hangs costs what was asked of him, once, and nobody else is
taken for him.
"""
import struct
import unittest

from giop_client import answer
from peers import MOST, Calls, Listener, compute, forward, send, tasks
from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.net import loop, tcp

SOON = 0.2  # seconds that messages take, and to see that nothing came while we were busy


class Endless(Listener):
    """Begins to answer, and goes on and on."""

    def __init__(self, host, first, more):
        self.first = first
        self.more = more
        super().__init__(host)

    async def talk(self, connection):
        await tcp.receive(connection, MOST)
        await send(connection, self.first)
        while True:
            await send(connection, self.more)
            await loop.sleep(0.005)


class Silence(Calls):
    """Many calls at once, of which some stay without an answer."""

    def test_a_silent_process_that_another_forwards_to(self):
        """It is the one that is not asked again; who forwarded lives."""
        silent = self.script(lambda pending: None)
        forwarding = self.script_of(lambda number: forward(silent.ref, number))
        for number in (3, 1):
            for value in self.run_tasks(*[self.asking(forwarding.ref)] * number):
                self.assertIs(type(value), errors.Unreachable)
                self.assertRegex(value.why, "no answer within 2s$")
        with self.assertRaises(errors.Unreachable) as caught:
            self.wait_for(orb.call("w", forwarding.ref, "_non_existent"))
        self.assertNotIsInstance(caught.exception, errors.Silent)
        self.assertEqual(list(self.session.silent), [silent.ref.address[1:3]])
        self.assertLess(self.world.time, 2 + SOON)

    def test_questions_that_were_never_sent_show_no_silence(self):
        """Those that wait for their turn behind a hung process fail, and do not take with them what was sent
        since.
        """

        def play(pending):
            if self.world.time < 2.2:
                pending.clear()  # hung
                return None
            compute(0.4)
            octets = b"".join(answer(number) for number, _ in pending)
            pending.clear()
            return octets or None

        peer = self.script(play)

        async def late():
            await loop.sleep(2.25)
            return await orb.call("w", peer.ref, "_non_existent")

        values = self.run_tasks(*[self.asking(peer.ref)] * 4 + [(peer.ref, late)] * 8)
        self.assertEqual([type(value) for value in values[:4]], [errors.Silent] * 4)
        self.assertEqual(sum(value is False for value in values[4:]), 4)

    def test_answers_that_came_while_we_were_stopped(self):
        """More than is taken in one round."""
        peer = self.script_of(lambda number: answer(number, b"\0" + bytes(9000)))
        values = self.run_tasks(*[self.asking(peer.ref)] * 4, self.blocking(1e-4, 3))
        self.assertEqual(values, [False] * 4 + ["blocked"])

    def blocking(self, before, seconds):
        """A job that blocks the thread for so long, as a stop of the process does."""
        async def block():
            await loop.sleep(before)
            compute(seconds)
            return "blocked"
        return self.script_of(answer).ref, block

    def test_answers_that_come_while_a_task_blocks(self):
        """They are taken before anybody is given up."""

        def at_once(pending):
            replies = b"".join(answer(number) for number, _ in pending)
            pending.clear()
            return replies or None

        def meanwhile(pending):
            while not is_blocking:
                compute(0.1)
            return at_once(pending)

        is_blocking = []
        one = self.script(at_once)
        third = self.script(at_once)
        other = self.script(meanwhile)
        refs = iter([one.ref, third.ref])

        async def block():
            await orb.call("w", next(refs), "_non_existent")
            is_blocking.append(True)
            compute(3)
            return "blocked"

        async def ask():
            return await orb.call("w", other.ref, "_non_existent")

        values = self.run_tasks((one.ref, block), (third.ref, block), (other.ref, ask))
        self.assertEqual(values, ["blocked", "blocked", False])

    def test_one_hung_object_costs_itself(self):

        def play(pending):
            replies = b"".join(
                answer(number) for number, operation in pending if operation == b"_non_existent"
            )
            pending.clear()
            return replies or None

        peer = self.script(play)

        async def hang():
            await orb.call("w", peer.ref, "_is_a", "x")

        async def ask():
            for _ in range(20):
                await loop.sleep(0.2)
                await orb.call("w", peer.ref, "_non_existent")
            return "answered"

        hung, *others = self.run_tasks((peer.ref, hang), *[(peer.ref, ask)] * 8)
        self.assertIsInstance(hung, errors.Silent)
        self.assertEqual(others, ["answered"] * 8)
        self.assertEqual(self.session.silent, {})

    def test_an_object_that_waits_for_others_owes_three_answers_at_most(self):
        late = []
        self.session.on_late.append(late.append)
        is_over = []

        def play(pending):
            now = [each for each in pending if is_over or each[1] == b"_is_a"]
            pending[:] = [each for each in pending if each not in now]
            return b"".join(answer(number, struct.pack("<I", 0)) for number, _ in now) or None

        peer = self.script(play)
        port = peer.ref.narrowed("IDL:omg.org/RTC/PortService:1.0")

        async def ask():
            self.session.ask_again(peer.ref.address[1:3])
            try:
                return await orb.call("w", port, "get_connector_profiles")
            except errors.Silent as e:
                await orb.call("w", port, "_is_a", "")  # which needs no others, and shows nothing
                return e.why

        async def ask_often():
            whys = [await ask() for _ in range(5)]
            is_over.append(True)
            try:
                await orb.call("w", peer.ref, "_non_existent")  # which has the others answered, too
            except errors.Error:
                pass
            return whys, await ask()

        whys, value = self.wait_for(ask_often())
        self.assertEqual(whys, ["no answer within 2s"] * 3 + ["no answer to 3 earlier questions"] * 2)
        self.assertEqual((late, value, peer.most), ([peer.ref.address[1:3]], [], 4))

    def test_a_hung_process_costs_one_timeout(self):
        silent, lively = self.script(lambda pending: None), self.script(
            lambda pending: answer(pending[-1][0]) if pending else None
        )

        async def ask_silent():
            await orb.call("w", silent.ref, "_non_existent")

        async def ask():
            return await orb.call("w", lively.ref, "_non_existent")

        async def ask_both():
            try:
                await orb.call("w", silent.ref, "_non_existent")
            except errors.Unreachable as e:
                return type(e), await orb.call("w", lively.ref, "_non_existent")

        spent, values = self.seconds(
            tasks(*[(silent.ref, ask_silent)] * 50, (lively.ref, ask), (lively.ref, ask_both))
        )
        self.assertLess(spent, 2 + SOON)
        kinds = [type(value) for value in values[:50]]
        self.assertEqual([kinds.count(errors.Silent), kinds.count(errors.NotAsked)], [4, 46])
        self.assertEqual(values[50:], [False, (errors.Unreachable, False)])
        self.assertIn(silent.ref.address[1:3], self.session.silent)
        # not asked again so soon
        self.assertIsInstance(self.run_tasks((silent.ref, ask_silent))[0], errors.NotAsked)

    def test_a_process_that_hangs_after_some_answers_costs_one_timeout(self):
        """Answers that came while a request waited for its turn are no sign of life after it was sent."""
        hung = [False]

        def play(pending):
            if not pending or hung[0]:
                return None
            hung[0] = True
            compute(0.4)  # so that the next request is sent later than the others
            return answer(pending[0][0])

        peer = self.script(play)

        async def ask():
            return await orb.call("w", peer.ref, "_non_existent")

        spent, values = self.seconds(tasks(*[(peer.ref, ask)] * 100))
        self.assertLess(spent, 2.4 + SOON)  # 4.4 if what was sent last had a timeout of its own
        kinds = [type(value) for value in values]
        self.assertEqual(kinds, [bool] + [errors.Silent] * 4 + [errors.NotAsked] * 95)

    def test_the_end_of_the_session(self):
        peer = self.script(lambda pending: None)

        async def ask():
            self.session.end = self.session.end or loop.now() + 0.2
            await orb.call("w", peer.ref, "_non_existent")

        self.assertEqual(
            [value.why for value in self.run_tasks((peer.ref, ask), (peer.ref, ask))], [session.NO_TIME] * 2
        )
        self.assertEqual(self.session.silent, {})

    def test_fragments_without_end(self):
        """They do not keep us from others, nor from giving up."""
        whole = answer(1)
        crumb = b"GIOP\1\2\3\7" + struct.pack("<II", 6, 1) + b"ab"
        endless = self.serve(Endless(self.host, whole[:6] + b"\3" + whole[7:], 100 * crumb))
        other = self.script_of(answer)
        values = self.run_tasks(self.asking(endless.ref), self.asking(other.ref))
        self.assertIsInstance(values[0], errors.Silent)
        self.assertIs(values[1], False)


if __name__ == "__main__":
    unittest.main()
