"""rtmount without a kernel: messages as octets, names of files, questions that are shared."""
import errno
import struct
import time
import unittest
from unittest import mock

from rtshell_lite import errors, notes
from rtshell_lite.corba import session
from rtshell_lite.mount import cache, kernel, liveness, nodes, openfile, server, streams, wire
from rtshell_lite.net import loop
from rtshell_lite.path import Name
from rtshell_lite.robot import tree


def packed(opcode, body=b"", unique=7, node=1):
    return struct.pack("=IIQQIIIHH", 40 + len(body), opcode, unique, node, 1000, 1000, 4711, 0, 0) + body


class Systems(unittest.TestCase):
    def test_those_that_are_not_linux(self):
        with mock.patch("sys.platform", "darwin"), self.assertRaises(errors.Failed) as caught:
            loop.run(kernel.check("/"))
        self.assertEqual(str(caught.exception), "rtmount: works on Linux only")


class Wire(unittest.TestCase):
    """Layouts of linux/fuse.h: if one is wrong, every file system call fails or hangs."""

    def test_sizes(self):
        attributes = wire.attributes(1, 0o100644, 0, 0, 0, 0)
        for reply, size in (
            (attributes, 88),
            (wire.entry(1, attributes, 1), 128),
            (wire.attributes_reply(attributes, 1), 104),
            (wire.opened(1, 0), 16),
            (wire.written(1), 8),
            (wire.statfs(), 80),
            (wire.init_reply((7, 45), 0), 64),
        ):
            self.assertEqual(len(reply), size)
        self.assertEqual(wire.ENTRY_SIZE, 128)

    def test_request(self):
        asked = wire.request(packed(wire.LOOKUP, b"a.rtc\0"))
        self.assertEqual((asked.opcode, asked.unique, asked.node, asked.pid), (wire.LOOKUP, 7, 1, 4711))
        self.assertEqual(wire.names(asked.body), ["a.rtc"])

    def test_other_octets_are_no_request(self):
        for data in (b"", b"x" * 39, packed(wire.LOOKUP) + b"x"):
            self.assertRaises(ValueError, wire.request, data)

    def test_names(self):
        self.assertEqual(wire.names("日本\0../x\0".encode()), ["日本", "../x"])
        self.assertEqual(wire.names(b"\xff\0"), ["\udcff"])
        self.assertEqual(wire.named(wire.MKDIR, struct.pack("=II", 0o755, 0) + b"new\0"), "new")
        self.assertEqual(wire.named(wire.RENAME2, struct.pack("=QII", 1, 0, 0) + b"old\0new\0"), "old")

    def test_reply(self):
        self.assertEqual(wire.reply(7, b"abc"), struct.pack("=IiQ", 19, 0, 7) + b"abc")
        self.assertEqual(wire.reply(7, error=2), struct.pack("=IiQ", 16, -2, 7))

    def test_reading_and_writing(self):
        body = struct.pack("=QQIIQII", 3, 4096, 5, wire.LOCK_OWNER, 0, 0, 0)
        self.assertEqual(wire.reading(body), (3, 4096, 5))
        self.assertTrue(wire.is_direct(body))
        self.assertFalse(wire.is_direct(struct.pack("=QQIIQII", 3, 0, 5, 0, 0, 0, 0)))
        self.assertEqual(wire.writing(body + b"hello and more"), (3, b"hello"))

    def test_forgetting(self):
        self.assertEqual(wire.forgotten(wire.FORGET, 9, struct.pack("=Q", 2)), [(9, 2)])
        self.assertEqual(
            wire.forgotten(wire.BATCH_FORGET, 0, struct.pack("=IIQQQQ", 2, 0, 5, 1, 6, 3)), [(5, 1), (6, 3)]
        )

    def test_entries_are_padded(self):
        for name in (b"a", b"12345678", "日".encode()):
            self.assertEqual(len(wire.dirent(1, 1, name, 0o040755)) % 8, 0)
        self.assertEqual(struct.unpack_from("=QQII", wire.dirent(5, 6, b"abc", 0o120777)), (5, 6, 3, 10))

    def test_fractions_of_a_second(self):
        self.assertEqual(
            struct.unpack_from("=QQQQII", wire.entry(1, b"", 0.25)), (1, 0, 0, 0, 250000000, 250000000)
        )

    def test_older_kernels_are_answered_by_their_own_version(self):
        self.assertEqual(struct.unpack_from("=II", wire.init_reply((7, 23), 0)), (7, 23))
        self.assertEqual(struct.unpack_from("=II", wire.init_reply((7, 45), 0)), (7, 31))


class Names(unittest.TestCase):
    """Any name of a robot is one of a file, and different ones stay different."""

    def test_spelling(self):
        for name, spelt in (
            ("", "\\e"),
            (".", "\\."),
            ("..", "\\.\\."),
            ("a/b", "a\\x2fb"),
            ("a\\/b", "a\\\\\\x2fb"),
            ("a\nb", "a\\x0ab"),
            ("日本", "日本"),
            (Name("a.b", "rtc"), "a.b.rtc"),
            (Name("a/b", "r/c"), "a\\x2fb.r\\x2fc"),
            (Name("", ""), "\\e"),
            (Name(".", ""), "\\."),
        ):
            with self.subTest(name):
                self.assertEqual(nodes.file_name(name), spelt)

    def test_long_names(self):
        one = nodes.file_name("日" * 100)
        other = nodes.file_name("日" * 100 + "!")
        self.assertNotEqual(one, other)
        for name in (one, other, nodes.file_name("x" * 100000)):
            self.assertLessEqual(len(name.encode()), nodes.NAME_MAX)
            self.assertIn("\\~", name)

    def test_the_same_name_twice(self):
        self.assertEqual(list(nodes.unique(["a", "a", "b", "a", "a~2"])), ["a", "a~2", "b", "a~3", "a~2~2"])


class Case(unittest.TestCase):
    """What runs on a loop, in a Group `self.tasks`."""

    def run_in_group(self, function):
        """The result of function(), a coroutine function; what it has begun is cancelled then."""
        async def run():
            self.tasks = loop.Group()
            async with self.tasks:
                try:
                    return await function()
                finally:
                    self.tasks.cancel()
        return loop.run(run(), session=session.Session(60))


async def settle():
    """Let all other tasks go on until they wait."""
    for _ in range(10):
        await loop.sleep(0.002)


class Listings(Case):
    """A listing waits a moment for what hangs, and shows what the others have answered."""

    def test_answers_are_shown_that_come_before_those_that_hang(self):
        """Also where an answer is believed for less than that moment."""
        async def check():
            listing = liveness.Liveness(self.tasks, 0.01, self.fail)
            found = await listing.check([node("hangs"), node("dead"), node("hangs too")])
            self.assertEqual([each.kind for each in found], ["component", "zombie", "component"])

        async def answer(nodes):
            if nodes[0].ref != "dead":
                await loop.sleep(60)
            return [tree.Node(nodes[0].path, "zombie", nodes[0].ref, None)]

        def node(name):
            return mock.Mock(path=name, ref=name, endpoint=name, kind="component", error=None)

        with mock.patch.object(liveness.tree, "check_alive", answer):
            with mock.patch.object(liveness.orb, "identity", str):
                self.run_in_group(check)


class Feeds(Case):
    """Lines that come from a component, given to those who read at the moment."""

    async def follow(self, publish):
        """A connection, which gives a last line as it is closed."""
        self.connections += 1
        publish(lambda: "first")
        try:
            await self.end.wait()
        finally:
            publish(lambda: "last")
            await self.closed
        raise errors.Failed("connection", "lost")

    def prepare(self):
        self.connections = 0
        self.served = []
        self.errors = []
        self.end = loop.Bell()
        self.closed = loop.Wait()
        self.feed = streams.Feed(mock.Mock(tasks=self.tasks), self.follow)

    def reader(self):
        reader = mock.Mock(put=self.served.append, end=self.errors.append)
        self.feed.attach(reader)
        return reader

    def test_a_reader_that_comes_as_a_connection_ends_gets_the_lines_of_the_next(self):
        async def check():
            self.prepare()
            first = self.reader()
            await settle()
            self.feed.detach(first)
            await settle()
            self.reader()
            await settle()
            self.assertEqual((self.served, self.connections), (["first"], 1))
            self.closed.done()
            await settle()
            self.assertEqual((self.served, self.connections), (["first", "first"], 2))
        self.run_in_group(check)

    def test_a_reader_that_comes_before_that_shares_the_connection(self):
        async def check():
            self.prepare()
            self.closed.done()
            first = self.reader()
            await settle()
            self.feed.detach(first)
            second = self.reader()
            await settle()
            self.feed.detach(second)
            await settle()
            self.assertEqual((self.served, self.connections), (["first"], 1))
        self.run_in_group(check)

    def test_its_failure_is_that_of_its_readers_and_the_next_one_connects(self):
        async def check():
            self.prepare()
            self.closed.done()
            self.reader()
            await settle()
            self.end.ring()
            await settle()
            self.assertEqual(list(map(str, self.errors)), ["connection: lost"])
            self.reader()
            await settle()
            self.assertEqual((self.connections, len(self.errors)), (2, 1))
        self.run_in_group(check)


class Streams(Case):
    """Lines wait for a reader, or the reader for a line."""

    def prepare(self, limit=None):
        self.mount = mock.Mock(tasks=self.tasks)
        return streams.StreamFile(self.mount, mock.Mock(), "values", limit)

    def test_pieces_of_lines(self):
        async def check():
            stream = self.prepare()
            stream.put("1234567")
            stream.put("8")
            self.assertEqual([await stream.read(0, 4) for _ in range(3)], [b"1234", b"567\n", b"8\n"])
        self.run_in_group(check)

    def test_readers_wait(self):
        async def check():
            stream = self.prepare()
            came = []

            async def read():
                came.append(await stream.read(0, 100))
            for _ in range(3):
                self.tasks.start(read())
            await settle()
            stream.put("a")
            await settle()
            self.assertEqual(came, [b"a\n"])
            stream.put("b")
            stream.put("c")
            await settle()
            self.assertEqual(sorted(came), [b"a\n", b"b\n", b"c\n"])
        self.run_in_group(check)

    def test_a_limit(self):
        async def check():
            stream = self.prepare(1)
            stream.put("a")
            self.assertFalse(stream.wants_more())
            self.assertEqual([await stream.read(0, 100) for _ in range(2)], [b"a\n", b""])
        self.run_in_group(check)

    def test_a_failure_comes_after_the_lines(self):
        async def check():
            stream = self.prepare()
            stream.put("a")
            stream.end(errors.Failed("port", "gone"))
            self.assertEqual(await stream.read(0, 100), b"a\n")
            with self.assertRaises(errors.Failed):
                await stream.read(0, 100)
        self.run_in_group(check)

    def test_lines_for_a_slow_reader_are_bounded(self):
        async def check():
            stream = self.prepare()
            for number in range(10):
                stream.put(str(number) * (streams.ROOM // 4))
            self.assertEqual((await stream.read(0, 2)), b"77")
            self.mount.complain.assert_called_once_with("values: lines are dropped: they come faster "
                                                        "than they are read")
        self.run_in_group(check)


class Answers(Case):
    """Thousands of requests need few questions."""

    def prepare(self, seconds, ask=None):
        """A CachedAnswer: how often it has been asked; it is answered when `self.gate` is open."""
        self.cache = cache.Cache(self.tasks)
        self.gate = loop.Wait()
        self.calls = 0
        return cache.CachedAnswer(self.cache, lambda: ("peer", "peer"), ask or self.ask, seconds)

    async def ask(self):
        self.calls += 1
        number = self.calls
        while not self.gate.is_over:
            await loop.sleep(0.001)
        return number

    async def answers(self, answer, count):
        """The values that `count` readers get who want it at the same time."""
        values = []

        async def get():
            try:
                values.append(await answer.get())
            except Exception as e:
                values.append(e)
        for _ in range(count):
            self.tasks.start(get())
        await settle()
        self.gate.done()
        while len(values) < count:
            await loop.sleep(0.001)
        return values

    def test_those_who_wait_share_the_answer(self):
        async def check():
            self.assertEqual(set(await self.answers(self.prepare(60), 1000)), {1})
        self.run_in_group(check)

    def test_one_that_is_not_believed_is_asked_after_the_request_came(self):
        async def check():
            values = await self.answers(self.prepare(0), 1000)
            self.assertEqual([values.count(1), values.count(2)], [1, 999])
        self.run_in_group(check)

    def test_nothing_is_believed_that_was_asked_before_a_change(self):
        async def check():
            answer = self.prepare(60)
            self.tasks.start(answer.get())
            await settle()
            self.cache.expire()
            self.assertEqual(await self.answers(answer, 10), [2] * 10)
            self.assertTrue(answer.is_fresh())
            self.cache.expire()
            self.assertFalse(answer.is_fresh())
            answer.expire()
            self.assertEqual(await self.answers(answer, 1), [3])
        self.run_in_group(check)

    def test_nothing_is_believed_that_expired_as_it_was_asked(self):
        async def check():
            answer = self.prepare(60)
            self.tasks.start(answer.get())
            await settle()
            answer.expire()
            self.gate.done()
            await loop.sleep(0.01)
            self.assertFalse(answer.is_fresh())
        self.run_in_group(check)

    def test_values_are_freed(self):
        async def check():
            answer = self.prepare(0.05)
            self.assertEqual(await self.answers(answer, 1), [1])
            self.cache.sweep()
            self.assertEqual(answer._value, 1)
            while answer._value is not None:
                await loop.sleep(0.01)
                self.cache.sweep()
            self.assertFalse(answer.is_fresh())
            self.assertEqual(self.cache._kept, [])
        self.run_in_group(check)

    def test_a_bug_leaves_nobody_waiting(self):
        async def fail():
            return 1 / 0

        async def check():
            for value in await self.answers(self.prepare(0, fail), 3):
                self.assertIsInstance(value, ZeroDivisionError)
        self.run_in_group(check)

    def test_a_silent_process_is_not_asked_again_at_once(self):
        async def check():
            answer = self.prepare(0)
            session.current().fall_silent("peer", "no answer", 0)
            value, = await self.answers(answer, 1)
            self.assertEqual((str(value), self.calls), ("peer: not asked: its process gave no answer", 0))
        self.run_in_group(check)

    def test_a_reader_that_goes_away_takes_no_answer_from_others(self):
        async def check():
            answer = self.prepare(60)
            first = self.tasks.start(answer.get())
            await settle()
            first.cancel()
            self.assertEqual(await self.answers(answer, 2), [1, 1])
        self.run_in_group(check)


class Sessions(unittest.TestCase):
    """A mount of a week meets thousands of processes."""

    def test_old_ones_are_forgotten(self):
        now = session.Session(0.01)
        with mock.patch.object(session, "MOST_ANSWERED", 10):
            for port in range(100):
                now.fall_silent(("host", port), "no answer", time.monotonic())
                now.memory.answered["host", port] = port
            self.assertEqual(len(now.silent), 100)
            time.sleep(0.02)
            now.sweep()
            self.assertEqual(
                (now.silent, sorted(now.memory.answered)), ({}, [("host", port) for port in range(90, 100)])
            )


class Served(Case):
    """A Server whose kernel is a pair of pipes: the requests are given to it, the replies kept in
    `self.replies`.
    """

    def prepare(self):
        self.mount = nodes.Mount("/m", 1.0)
        self.tasks = self.mount.tasks
        self.replies = []
        self.server = None
        self.root = Top(self.mount)
        self.server = server.Server(self.mount, self.root, None, lambda: None)
        patch = mock.patch(
            "os.write",
            lambda fd, data: self.replies.append(struct.unpack_from("=IiQ", data)[1:] + (data[16:],)),
        )
        patch.start()
        self.addCleanup(patch.stop)

    def ask(self, unique, opcode, body=b"", node=1):
        self.server._handle(wire.request(packed(opcode, body, unique, node)))

    def run_in_group(self, function):
        async def run():
            self.prepare()
            async with self.tasks:
                await function()
                self.tasks.cancel()
        return loop.run(run(), session=session.Session(60))

    def opened(self, unique=1):
        """The number of a handle of the file `slow`."""
        handle = self.server._handles.setdefault(unique, openfile.OpenFile(self.root.file))
        self.assertIs(self.server._handles[unique], handle)
        return unique

    def read(self, unique, handle):
        self.ask(unique, wire.READ, struct.pack("=QQIIQII", handle, 0, 100, wire.LOCK_OWNER, 0, 0, 0))

    def write(self, unique, handle, data):
        self.ask(unique, wire.WRITE, struct.pack("=QQIIQII", handle, 0, len(data), 0, 0, 0, 0) + data)

    def test_a_reader_waits_while_others_are_answered(self):
        async def check():
            self.read(7, self.opened())
            await settle()
            self.ask(8, wire.GETATTR)
            self.assertEqual([(error, unique) for error, unique, _ in self.replies], [(0, 8)])
            self.root.file.gate.done()
            await settle()
            self.assertEqual(self.replies[1:], [(0, 7, b"text")])
            self.assertEqual(self.server._pending, {})
        self.run_in_group(check)

    def test_an_interrupted_reader_is_free_at_once_and_only_it(self):
        async def check():
            self.read(7, self.opened(1))
            self.read(8, self.opened(2))
            await settle()
            before = len(self.tasks.tasks)
            self.ask(9, wire.INTERRUPT, struct.pack("=Q", 7))
            self.assertEqual(self.replies, [(-errno.EINTR, 7, b"")])
            await settle()
            self.assertEqual(len(self.tasks.tasks), before - 1)
            self.root.file.gate.done()
            await settle()
            self.assertEqual(self.replies[1:], [(0, 8, b"text")])
        self.run_in_group(check)

    def test_changes_are_made_one_at_a_time_in_order_and_to_their_end(self):
        async def check():
            handle = self.opened()
            for unique in range(10, 15):
                self.write(unique, handle, b"%d\n" % unique)
            await settle()
            self.assertEqual(self.root.file.stored, ["begin 10"])
            self.ask(9, wire.INTERRUPT, struct.pack("=Q", 10))
            self.root.file.gate.done()
            await settle()
            self.assertEqual(
                self.root.file.stored,
                [f"{what} {number}" for number in range(10, 15) for what in ("begin", "end")],
            )
            self.assertEqual(
                self.replies,
                [(-errno.EINTR, 10, b"")] + [(0, number, wire.written(3)) for number in range(11, 15)],
            )
            self.assertEqual(self.mount._changes, {})
        self.run_in_group(check)

    def test_a_bug_ends_one_request_only(self):
        async def check():
            self.root.file.text = None
            self.root.file.gate.done()
            self.read(7, self.opened())
            self.ask(8, wire.OPEN, b"", 4711)
            self.ask(9, 1000)
            await settle()
            self.assertEqual([(error, unique) for error, unique, _ in self.replies],
                             [(-errno.ENOENT, 8), (-errno.ENOSYS, 9), (-errno.EIO, 7)])
            self.assertIn("internal error: AttributeError", self.mount.errors[0])
        self.run_in_group(check)

    def test_nodes_that_nobody_heard_of_are_forgotten(self):
        async def check():
            self.ask(7, wire.LOOKUP, b"slow\0")
            await settle()
            self.assertEqual(len(self.server.nodes), 2)
            self.ask(0, wire.FORGET, struct.pack("=Q", 1), self.root.file.id)
            self.assertEqual(list(self.server.nodes), [wire.ROOT])
            with mock.patch("os.write", side_effect=OSError(errno.ENOENT, "")):
                self.ask(8, wire.LOOKUP, b"slow\0")
                await settle()
            self.assertEqual((list(self.server.nodes), self.root.known), ([wire.ROOT], {}))
        self.run_in_group(check)


class Slow(nodes.File):
    """A file that is read and written when `gate` is open."""

    def __init__(self, above, name):
        super().__init__(above, name)
        self.gate = loop.Wait()
        self.text = "text"
        self.stored = []

    async def content(self):
        while not self.gate.is_over:
            await loop.sleep(0.001)
        return self.text

    async def store(self, text):
        self.stored.append("begin " + text)
        while not self.gate.is_over:
            await loop.sleep(0.001)
        self.stored.append("end " + text)


class Top(nodes.Directory):
    path = ""
    where = "/m"

    def __init__(self, mount):
        super().__init__(None, "")
        self.mount = mount
        self.file = Slow(self, "slow")

    async def find(self, name):
        return self.file


class Failures(unittest.TestCase):
    """What libraries remark is kept for DIR/errors; in the foreground it is reported, too."""

    def test_remarks(self):
        async def check():
            heard = []
            mount = nodes.Mount("/m", 1.0, listener=lambda kind, what: heard.append((kind, what)))
            mount.hear(notes.DETAIL, "deleted")
            mount.hear(notes.NOTE, "polled")
            mount.hear(notes.FAILURE, errors.Failed("port", "gone\n"))
            mount.fail(ValueError("a bug"))
            self.assertEqual(
                list(mount.errors), ["polled\n", "port: gone\\x0a\n", "internal error: ValueError: a bug\n"]
            )
            self.assertEqual(
                heard,
                [
                    (notes.DETAIL, "deleted"),
                    (notes.NOTE, "polled"),
                    (notes.FAILURE, "port: gone\\x0a"),
                    (notes.FAILURE, "internal error: ValueError: a bug"),
                ],
            )
        loop.run(check())


if __name__ == "__main__":
    unittest.main()
