"""rtmount without a kernel: messages as octets, names of files, questions that are shared."""
import os
import signal
import struct
import threading
import time
import unittest
from unittest import mock

from rtshell_lite import errors
from rtshell_lite.corba import lanes
from rtshell_lite.mount import asking, kernel, nodes, server, streams, wire
from rtshell_lite.path import Name


def packed(opcode, body=b"", unique=7, node=1):
    return struct.pack("=IIQQIIIHH", 40 + len(body), opcode, unique, node, 1000, 1000, 4711, 0, 0) + body


class Systems(unittest.TestCase):
    def test_those_that_are_not_linux(self):
        with mock.patch("sys.platform", "darwin"), self.assertRaises(errors.Failed) as caught:
            kernel.check("/")
        self.assertEqual(str(caught.exception), "rtmount: works on Linux only")


class Ended(Exception):
    pass


class Signals(unittest.TestCase):
    """A server that waits for a request ends at once, also if the signal reaches another of its threads, or comes just before."""

    def setUp(self):
        before = signal.signal(signal.SIGUSR1, self.end)
        self.addCleanup(signal.signal, signal.SIGUSR1, before)
        self.ours, self.theirs = os.pipe()
        self.addCleanup(os.close, self.ours)
        self.addCleanup(os.close, self.theirs)

    def end(self, number, frame):
        raise Ended()

    def test_one_that_reaches_another_thread(self):
        def strike():
            time.sleep(0.05)  # usually the main thread waits by then; if not, nothing changes
            signal.pthread_kill(threading.get_ident(), signal.SIGUSR1)
        safety = threading.Timer(20, os.write, (self.theirs, b"!"))
        safety.start()
        thread = threading.Thread(target=strike)
        begun = time.monotonic()
        with self.assertRaises(Ended), server.Waiting(self.ours) as waiting:
            thread.start()
            waiting.wait()
        thread.join()
        safety.cancel()
        self.assertLess(time.monotonic() - begun, 10)

    def test_requests_and_signals_that_mean_nothing(self):
        signal.signal(signal.SIGUSR1, lambda number, frame: None)
        with server.Waiting(self.ours) as waiting:
            for _ in range(3):
                os.kill(os.getpid(), signal.SIGUSR1)
                waiting.wait()
            os.write(self.theirs, b"!")
            waiting.wait()
        self.assertEqual(os.read(self.ours, 1), b"!")
        self.assertEqual(signal.set_wakeup_fd(-1), -1)


class Wire(unittest.TestCase):
    """Layouts of linux/fuse.h: if one is wrong, every file system call fails or hangs."""

    def test_sizes(self):
        attributes = wire.attributes(1, 0o100644, 0, 0, 0, 0)
        for reply, size in ((attributes, 88), (wire.entry(1, attributes, 1), 128), (wire.attributes_reply(attributes, 1), 104),
                            (wire.opened(1, 0), 16), (wire.written(1), 8), (wire.statfs(), 80), (wire.init_reply((7, 45), 0), 64)):
            self.assertEqual(len(reply), size)
        self.assertEqual(wire.ENTRY_SIZE, 128)

    def test_request(self):
        asked = wire.request(packed(wire.LOOKUP, b"a.rtc\0"))
        self.assertEqual((asked.opcode, asked.unique, asked.node, asked.pid), (wire.LOOKUP, 7, 1, 4711))
        self.assertEqual(wire.names(asked.body), ["a.rtc"])

    def test_what_is_no_request(self):
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
        self.assertEqual(wire.forgotten(wire.BATCH_FORGET, 0, struct.pack("=IIQQQQ", 2, 0, 5, 1, 6, 3)), [(5, 1), (6, 3)])

    def test_entries_are_padded(self):
        for name in (b"a", b"12345678", "日".encode()):
            self.assertEqual(len(wire.dirent(1, 1, name, 0o040755)) % 8, 0)
        self.assertEqual(struct.unpack_from("=QQII", wire.dirent(5, 6, b"abc", 0o120777)), (5, 6, 3, 10))

    def test_fractions_of_a_second(self):
        self.assertEqual(struct.unpack_from("=QQQQII", wire.entry(1, b"", 0.25)), (1, 0, 0, 0, 250000000, 250000000))

    def test_older_kernels_are_answered_by_their_own_version(self):
        self.assertEqual(struct.unpack_from("=II", wire.init_reply((7, 23), 0)), (7, 23))
        self.assertEqual(struct.unpack_from("=II", wire.init_reply((7, 45), 0)), (7, 31))


class Names(unittest.TestCase):
    """Any name of a robot is one of a file, and different ones stay different."""

    def test_spelling(self):
        for name, spelt in (("", "\\e"), (".", "\\."), ("..", "\\.\\."), ("a/b", "a\\x2fb"), ("a\\/b", "a\\\\\\x2fb"),
                            ("a\nb", "a\\x0ab"), ("日本", "日本"), (Name("a.b", "rtc"), "a.b.rtc"), (Name("a/b", "r/c"), "a\\x2fb.r\\x2fc"),
                            (Name("", ""), "\\e"), (Name(".", ""), "\\.")):
            with self.subTest(name):
                self.assertEqual(nodes.file_name(name), spelt)

    def test_long_names(self):
        one, other = nodes.file_name("日" * 100), nodes.file_name("日" * 100 + "!")
        self.assertNotEqual(one, other)
        for name in (one, other, nodes.file_name("x" * 100000)):
            self.assertLessEqual(len(name.encode()), nodes.NAME_MAX)
            self.assertIn("\\~", name)

    def test_the_same_name_twice(self):
        self.assertEqual(list(nodes.unique(["a", "a", "b", "a", "a~2"])), ["a", "a~2", "b", "a~3", "a~2~2"])


class Feeds(unittest.TestCase):
    """Lines that come from a component, given to those who read at the moment."""

    def setUp(self):
        self.todo, self.served = [], []
        changes = mock.Mock(start=lambda key, function, most: self.todo.append(function))
        self.feed = streams.Feed(mock.Mock(changes=changes, streams=set()), "values", self.begin)

    def begin(self, publish):
        """A connection, which gives a last line as it is closed."""
        publish(lambda: "first")
        return mock.Mock(close=lambda: publish(lambda: "last"))

    def reader(self):
        reader = mock.Mock(put=self.served.append)
        self.feed.attach(reader)
        return reader

    def settle(self):
        self.todo.pop(0)()

    def test_who_comes_as_a_connection_ends_gets_the_lines_of_the_next(self):
        first = self.reader()
        self.settle()
        self.feed.detach(first)
        with mock.patch.object(self.feed, "close", lambda close=self.feed.close: (self.reader(), close())):
            self.settle()
        self.assertEqual(self.served, ["first"])
        self.settle()
        self.assertEqual(self.served, ["first", "first"])

    def test_who_comes_before_that_shares_the_connection(self):
        first = self.reader()
        self.settle()
        self.feed.detach(first)
        self.reader()
        self.settle()
        self.settle()
        self.feed.close()
        self.assertEqual(self.served, ["first", "last"])


class Asking(unittest.TestCase):
    """Thousands of requests need few threads and few questions."""

    def setUp(self):
        self.failures = []
        self.crew, self.kept = asking.Crew(self.failures.append), asking.Kept()
        self.gate, self.calls = threading.Event(), []

    def source(self, seconds, endpoint="peer"):
        def ask():
            self.calls.append(endpoint)
            self.gate.wait(60)
            return len(self.calls)
        return asking.Source(self.crew, self.kept, lambda: (endpoint, endpoint), ask, seconds)

    def answers(self, source, count):
        """Want the value `count` times, then let the peer answer; the values."""
        values, came = [], threading.Semaphore(0)

        def take(value):
            values.append(value)
            came.release()
        for _ in range(count):
            source.want(take)
        self.gate.set()
        for _ in range(count):
            self.assertTrue(came.acquire(timeout=60))
        return values

    def test_those_who_wait_share_the_answer(self):
        self.assertEqual(set(self.answers(self.source(60), 1000)), {1})

    def test_what_is_not_believed_is_asked_after_the_request_came(self):
        values = self.answers(self.source(0), 1000)
        self.assertLessEqual(len(self.calls), lanes.LANES + 1)
        self.assertGreater(max(values), 1)

    def test_nothing_is_believed_that_was_asked_before_a_change(self):
        source = self.source(60)
        came = threading.Event()
        source.want(lambda value: came.set())
        while not self.calls:
            pass
        self.kept.expire()
        self.gate.set()
        came.wait(60)
        self.assertFalse(source.is_fresh())
        self.assertEqual(self.answers(source, 1), [2])
        self.assertTrue(source.is_fresh())

    def test_values_are_freed(self):
        source = self.source(0.05)
        self.assertEqual(self.answers(source, 1), [1])
        while source.value is not None:
            self.kept.sweep()
        self.assertFalse(source.is_fresh())

    def test_a_bug_leaves_nobody_waiting(self):
        source = asking.Source(self.crew, self.kept, lambda: ("peer", "peer"), lambda: 1 / 0, 0)
        self.assertIsInstance(self.answers(source, 1)[0], ZeroDivisionError)

    def test_jobs_of_one_key_are_few_and_in_order(self):
        running, most, done, lock = [0], [0], [], threading.Lock()
        finished = threading.Event()

        def job(number):
            with lock:
                running[0] += 1
                most[0] = max(most[0], running[0])
            done.append(number)
            with lock:
                running[0] -= 1
            if len(done) == 500:
                finished.set()
        for number in range(500):
            self.crew.start("key", lambda number=number: job(number), most=1)
        self.assertTrue(finished.wait(60))
        self.assertEqual((most[0], done), (1, list(range(500))))

    def test_every_job_is_done_whatever_their_order(self):
        done = threading.Semaphore(0)

        def start(base):
            for number in range(1000):
                self.crew.start((base + number) % 7, done.release)
        starting = [threading.Thread(target=start, args=(base,)) for base in range(4)]
        for thread in starting:
            thread.start()
        for _ in range(4000):
            self.assertTrue(done.acquire(timeout=60))
        self.assertEqual(self.failures, [])

    def test_a_job_that_fails_ends_no_thread(self):
        done = threading.Event()
        for _ in range(10):
            self.crew.start("key", lambda: 1 / 0)
        self.crew.start("key", done.set)
        self.assertTrue(done.wait(60))
        while len(self.failures) < 10:
            time.sleep(0.001)

    def test_threads_are_bounded(self):
        before = threading.active_count()
        for number in range(2000):
            self.crew.start(number, lambda: self.gate.wait(60), most=1)
        self.assertLessEqual(threading.active_count() - before, asking.MOST)
        self.gate.set()

    def test_lanes(self):
        for _ in range(100):
            self.crew.start("peer", lambda: self.gate.wait(60))
        self.assertLessEqual(self.crew._threads, lanes.LANES)
        self.gate.set()


if __name__ == "__main__":
    unittest.main()
