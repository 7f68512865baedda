"""Log files: what was written is read again, whatever happens to the file; hostile ones are refused at no
cost.
"""
import os
import random
import resource
import signal
import struct
import subprocess
import sys
import tempfile
import unittest
import warnings
import zlib
from unittest import mock

from rtshell_lite import __version__, errors
from rtshell_lite.data import datatypes
from rtshell_lite.datalog import logfile, mcap, mend, records, textlog, writer

LONG = "IDL:RTC/TimedLong:1.0"
CHANNELS = [records.Channel("a", LONG, datatypes.Types().named("TimedLong").to_bytes(), ("/x:a",)),
            records.Channel("b", "IDL:Own:1.0", b"", ("/x:b", "/y:b"))]
START = 1700000000 * 10 ** 9
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def messages(count, size=12):
    """Messages 1 ms apart, of both channels and both byte orders, each of other data."""
    return [(i % 2, START + i * 10 ** 6, i % 3 == 0, (b"%08d" % i).ljust(size, b".")) for i in range(count)]


def as_read(written):
    return [records.Entry(i, received, channel, little, data, None)
            for i, (channel, received, little, data) in enumerate(written)]


class Case(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        self.name = os.path.join(self.directory.name, "log")

    def write(self, written, close=True, append=False, channels=CHANNELS):
        out = writer.LogWriter(self.name, channels, START, append)
        out.write(written)
        if close:
            out.close()
        else:  # as kill -9 leaves it
            out._file.close()
            out._indexes.close()
        with open(self.name, "rb") as file:
            return file.read()

    def put(self, data):
        with open(self.name, "wb") as file:
            file.write(data)

    def read(self):
        """All of the file: (log, entries); None when it is refused."""
        try:
            with logfile.load(self.name) as log:
                return log, list(log.entries())
        except errors.Failed:
            return None


class Files(Case):
    def test_written_entries_are_read(self):
        written = messages(1000)
        self.write(written)
        log, found = self.read()
        self.assertEqual(found, as_read(written))
        self.assertEqual((log.channels, log.started), (CHANNELS, START))
        self.assertEqual((log.count, log.first, log.last, log.counts, log.closed), (
            1000, written[0][1], written[-1][1], {"a": 500, "b": 500}, True))
        self.assertEqual(list(log.notes()), [])

    def test_the_format_is_that_of_others(self):
        """Numbers are little-endian, without gaps; a message has the head of plain CDR; the footer says where
        the summary is.
        """
        data = self.write(messages(1))
        self.assertEqual((data[:9], data[-8:]), (b"\x89MCAP0\r\n\1", mcap.MAGIC))
        message = (
            struct.pack("<BQHIQQ", 5, 22 + 4 + 12, 0, 0, START, 0x30303030 * 10**9 + 0x30303030)
            + b"\0\1\0\0"
            + b"00000000...."
        )
        self.assertEqual(data.count(message), 1)
        start, _ = mcap.footer(data[-mcap.FOOT.size:])
        self.assertEqual(data[start], mcap.SCHEMA)
        self.assertEqual(data[start - 13], mcap.DATA_END)
        self.assertEqual(zlib.crc32(data[start:-12]), struct.unpack("<I", data[-12:-8])[0])
        self.assertIn(b"rtlog %s" % __version__.encode(), data)

    def test_a_chunk_is_small_and_indexed(self):
        data = self.write(messages(100, 40000))
        with logfile.load(self.name) as log:
            self.assertGreater(len(log._stretches), 3)
            for stretch in log._stretches:
                self.assertEqual(data[stretch.offset], mcap.CHUNK)
                self.assertEqual(data[stretch.end], mcap.MESSAGE_INDEX)

    def test_only_what_is_torn_is_cut_off(self):
        """To go on with a file whose middle is damaged would throw away all behind that; half a large record
        may go.
        """
        data = self.write(messages(100, 40000), close=False)
        with logfile.load(self.name) as log:
            place = log._stretches[1].offset
        damaged = data[:place + 1] + struct.pack("<Q", 7 << 40) + data[place + 9:]
        self.put(damaged)
        with self.assertRaisesRegex(errors.Failed, "record to another file"):
            self.write([], append=True)
        with open(self.name, "rb") as file:
            self.assertEqual(file.read(), damaged)
        for end in (mcap.HEAD.pack(mcap.CHUNK, 9 << 20) + bytes(8 << 20), bytes(2 << 20)):
            self.put(data + end)
            self.write(messages(1), append=True)
            log, _ = self.read()
            self.assertEqual((log.count, log.torn), (101, 0))

    def test_nothing_else_is_gone_on_with(self):
        for data in (b"no log", b"\x80\x04", b"x" + self.write(messages(1))[1:]):
            self.put(data)
            with self.assertRaisesRegex(errors.Failed, "not a log that"):
                self.write([], append=True)
            with self.assertRaisesRegex(errors.Failed, "not a log of text"):
                textlog.TextWriter(self.name, CHANNELS, [None, None], True)
            with open(self.name, "rb") as file:
                self.assertEqual(file.read(), data)

    def test_a_device_takes_several_logs_of_text(self):
        first = textlog.TextWriter(os.devnull, CHANNELS, [None, None])
        textlog.TextWriter(os.devnull, CHANNELS, [None, None]).close()
        first.close()

    def test_a_log_of_text_has_one_writer(self):
        first = textlog.TextWriter(self.name, CHANNELS, [None, None])
        first.write(messages(1))
        for append in (True, False):
            with self.assertRaisesRegex(errors.Failed, "another rtlog"):
                textlog.TextWriter(self.name, CHANNELS, [None, None], append)
        first.close()
        textlog.TextWriter(self.name, CHANNELS, [None, None], True).close()
        with open(self.name, "rb") as file:
            self.assertEqual(len(file.read().splitlines()), 1)
        textlog.TextWriter(self.name, CHANNELS, [None, None]).close()
        self.assertEqual(os.path.getsize(self.name), 0)

    def test_places_are_found(self):
        """-s must find its entry by number and by time, on both sides of every point of the index."""
        written = messages(500, 20000)
        for close in (True, False):
            self.write(written, close)
            with logfile.load(self.name) as log:
                self.assertGreater(len(log._stretches), 5)
                for number in (0, 1, 50, 51, 52, 53, 54, 499):
                    self.assertEqual(next(log.entries(number)).number, number)
                    self.assertEqual(log.since(written[number][1]), number)
                    self.assertEqual(log.since(written[number][1] - 1), number)
                self.assertEqual(list(log.entries(500)), [])
                self.assertIsNone(log.since(written[-1][1] + 1))

    def test_the_index_stays_small(self):
        """What a recording of many days has to remember is on the disk."""
        with mock.patch.object(writer, "INDEXES", 1000):
            out = writer.LogWriter(self.name, CHANNELS, START)
            for number in range(50):
                out.write(messages(2))
            self.assertTrue(out._indexes._rolled)
            out.close()
        log, found = self.read()
        self.assertEqual((len(found), log.count, log.closed), (100, 100, True))

    def test_a_clock_that_was_set_back(self):
        written = [(0, moment, True, b"x" * 600000) for moment in (50, 60, 10, 20, 70, 5)]
        self.write(written)
        with logfile.load(self.name) as log:
            self.assertEqual([log.since(moment) for moment in (1, 55, 60, 65, 70, 71)], [0, 1, 1, 4, 4, None])

    def test_appending(self):
        for close in (True, False):
            first, more = messages(10), messages(3)
            data = self.write(first, close)
            if not close:  # within the message indexes, which costs none
                self.put(data[:-5])
            self.write(more, append=True)
            log, found = self.read()
            self.assertEqual(found, as_read(first + more))
            self.assertEqual(log.channels, CHANNELS)
            self.assertTrue(log.closed)

    def test_appending_other_channels(self):
        other = [records.Channel("c", LONG, b"", ("/z:c",)), CHANNELS[0]]
        self.write(messages(2))
        self.write([(0, 1, True, b"x"), (1, 2, True, b"y")], append=True, channels=other)
        log, found = self.read()
        self.assertEqual([log.channels[entry.channel].name for entry in found], ["a", "b", "c", "a"])
        with self.assertRaisesRegex(errors.Failed, "a is of type"):
            writer.LogWriter(self.name, [CHANNELS[0]._replace(type_id="T")], START, append=True)

    def test_two_at_once(self):
        first = writer.LogWriter(self.name, CHANNELS, START)
        for append in (False, True):
            with self.assertRaisesRegex(errors.Failed, "another rtlog"):
                writer.LogWriter(self.name, CHANNELS, START, append)
        first.close()

    def test_two_begin_at_once(self):
        """The second one must not spoil the header that the first has written and not yet given its name."""
        tried = []

        def second(descriptor):
            tried.append(descriptor)
            if len(tried) == 1:
                with self.assertRaises(errors.Failed):
                    writer.LogWriter(self.name, CHANNELS, START)
        written = messages(5)
        with mock.patch("os.fsync", second):
            self.write(written)
        self.assertEqual(self.read()[1], as_read(written))

    def test_one_begins_and_ends_meanwhile(self):
        """What a second one has opened under its first name is not spoilt when it is a whole log by now."""
        written, locks = messages(5), []

        def meanwhile(file, name):
            locks.append(name)
            if len(locks) == 1:
                self.write(written)
            lock(file, name)
        lock = writer.lock
        with mock.patch.object(writer, "lock", meanwhile), self.assertRaisesRegex(
            errors.Failed, "another rtlog"
        ):
            writer.LogWriter(self.name, CHANNELS, START)
        self.assertEqual(self.read()[1], as_read(written))

    def test_refused_files_are_closed(self):
        self.put(mcap.MAGIC + b"no header")
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always", ResourceWarning)
            with self.assertRaises(errors.Failed):
                writer.LogWriter(self.name, CHANNELS, START, True)
            with mock.patch.object(textlog.TextWriter, "_prepare", side_effect=OSError), self.assertRaises(
                OSError
            ):
                textlog.TextWriter(self.name, CHANNELS, [None, None])
        self.assertEqual([str(each.message) for each in told], [])

    def test_a_replaced_file_keeps_its_mode(self):
        self.put(b"old")
        os.chmod(self.name, 0o600)
        self.write([])
        self.assertEqual(os.stat(self.name).st_mode & 0o777, 0o600)
        self.assertEqual(os.listdir(self.directory.name), ["log"])

    def test_a_full_disk(self):
        """What was written before stays whole, and there is no index of what is not there."""
        soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
        out = writer.LogWriter(self.name, CHANNELS, START)
        out.write(messages(100))
        resource.setrlimit(resource.RLIMIT_FSIZE, (20000, hard))
        try:
            with self.assertRaises(OSError) as caught:
                for _ in range(100):
                    out.write(messages(100))
            out.close()
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
        self.assertEqual(caught.exception.filename, self.name)
        log, found = self.read()
        self.assertEqual((len(found) % 100, log.torn, log.closed), (0, 0, False))


class Damage(Case):
    def test_cut_at_every_octet(self):
        """kill -9, a full disk, a torn copy: all whole chunks are read."""
        written = messages(8)
        out = writer.LogWriter(self.name, CHANNELS, START)
        ends = [(out.end, 0)]
        for at in range(0, 8, 2):
            out.write(written[at:at + 2])
            with open(self.name, "rb") as file:
                octets = file.read()
            # a chunk is whole without its message indexes
            with logfile.load(self.name) as log:
                ends += [(log._stretches[-1].end, at + 2), (len(octets), at + 2)]
        out.close()
        with open(self.name, "rb") as file:
            whole = file.read()
        start = len(mcap.MAGIC) + len(mcap.header("rtlog " + __version__))
        for size in range(len(whole)):
            self.put(whole[:size])
            found = self.read()
            if size < start:
                self.assertIsNone(found, size)
                continue
            count = max([count for end, count in ends if end <= size], default=0)
            self.assertEqual(found[1], as_read(written[:count]), size)
            self.assertEqual((found[0].torn, found[0].closed), (size - found[0].end, False))
            out = os.path.join(self.directory.name, "mended")
            mend.mend(self.name, out)
            with logfile.load(out) as log:
                self.assertEqual((list(log.entries()), log.closed), (as_read(written[:count]), True))

    def test_changed_anywhere(self):
        """No changed octet gives a message that never was, or anything but errors.Failed."""
        chance = random.Random(1)
        written = messages(30)
        data, known = self.write(written), {entry._replace(number=0, channel=0) for entry in as_read(written)}
        for _ in range(1500):
            changed = bytearray(data)
            for _ in range(chance.choice([1, 1, 2, 8])):
                place = chance.randrange(len(changed))
                how = chance.randrange(3)
                if how == 0:
                    changed[place] ^= 1 << chance.randrange(8)
                elif how == 1:
                    del changed[place:place + chance.randrange(1, 30)]
                else:
                    changed[place:place] = bytes(
                        chance.randrange(256) for _ in range(chance.randrange(1, 30))
                    )
            self.put(bytes(changed))
            found = self.read()
            if found:
                self.assertLessEqual({entry._replace(number=0, channel=0) for entry in found[1]}, known)
                if found[0].closed:  # then the summary has a checksum
                    self.assertEqual(found[0].channels, CHANNELS)

    def test_a_damaged_chunk_costs_itself(self):
        written = messages(30)
        out = writer.LogWriter(self.name, CHANNELS, START)
        for at in (0, 10, 20):
            out.write(written[at:at + 10])
        out.close()
        with open(self.name, "rb") as file:
            data = bytearray(file.read())
        data[data.index(b"00000011")] ^= 1
        self.put(bytes(data))
        log, found = self.read()
        self.assertEqual([entry.number for entry in found], [n for n in range(30) if n // 10 != 1])
        self.assertEqual((log.damaged, log.torn), (10, 0))
        with self.assertRaisesRegex(errors.Failed, "damaged in its middle"):
            mend.mend(self.name)
        sound = os.path.join(self.directory.name, "sound")
        self.assertEqual(mend.mend(self.name, sound), ["10 damaged records are left out"])
        with logfile.load(sound) as log:
            self.assertEqual((log.count, log.closed, log.damaged), (20, True, 0))

    def test_mended_in_place(self):
        data = self.write(messages(10), close=False)
        self.put(data + b"\6torn")
        mend.mend(self.name)
        log, found = self.read()
        self.assertEqual((found, log.closed, log.torn), (as_read(messages(10)), True, 0))
        with open(self.name, "rb") as file:
            mended = file.read()
        mend.mend(self.name)
        with open(self.name, "rb") as file:
            self.assertEqual(file.read(), mended)

    def test_killed_while_recording(self):
        """The file holds all that the recorder said it had written, and nothing else."""
        script = ("import sys; sys.path[:0] = [%r, %r]\n"
                  "import test_datalog as t\n"
                  "out = t.writer.LogWriter(sys.argv[1], t.CHANNELS, 1)\n"
                  "for n in range(100000):\n"
                  "    out.write(t.messages(50, 5000))\n"
                  "    print((n + 1) * 50, flush=True)\n" % (ROOT, os.path.join(ROOT, "tests", "unit")))
        for number in range(4):
            process = subprocess.Popen([sys.executable, "-c", script, self.name], stdout=subprocess.PIPE)
            told = [int(process.stdout.readline()) for _ in range(5 + number)][-1]
            process.send_signal(signal.SIGKILL)
            process.wait()
            rest = process.stdout.read().split(b"\n")
            process.stdout.close()
            told = max([told] + [int(line) for line in rest[:-1]])
            log, found = self.read()
            self.assertGreaterEqual(log.count, told)
            self.assertEqual([entry.number for entry in found], list(range(log.count)))
            self.assertFalse(log.closed)


if __name__ == "__main__":
    unittest.main()
