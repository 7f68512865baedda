"""Logs that somebody has made to do harm: they are refused, or read, within bounds."""
import json
import struct
import time
import tracemalloc
import unittest
import zlib
from unittest import mock

from rtshell_lite import errors
from rtshell_lite.datalog import compression, logfile, mcap, mend, schemas
from rtshell_lite.views import plot
from test_datalog import Case, LONG, messages, as_read

HEADER = mcap.MAGIC + mcap.header("x")


def channel(number=0, **about):
    return mcap.channel_record(number, 0, "a", "cdr", dict(dict(type=LONG), **about))


def chunk(body, crc=None, compression="", size=None, within=None):
    """A chunk of these octets, and what it says of them."""
    if size is None:
        size = len(body)
    if crc is None:
        crc = zlib.crc32(body)
    if within is None:
        within = len(body)
    head = mcap.CHUNK_HEAD.pack(1, 2, size, crc)
    return mcap.record(mcap.CHUNK, head, mcap.string(compression), struct.pack("<Q", within), body)


def message(number=0, moment=1, data=b"\0\1\0\0x"):
    return mcap.record(mcap.MESSAGE, struct.pack("<HIQQ", number, 0, moment, 0), data)


class Hostile(Case):
    def all(self, data):
        """What is read of these octets, at little cost: None, or (log, entries)."""
        self.put(data)
        tracemalloc.start()
        try:
            return self.read()
        finally:
            peak = tracemalloc.get_traced_memory()[1]
            tracemalloc.stop()
            self.assertLess(peak, 20 << 20)

    def test_files_that_are_not_logs_are_refused(self):
        for data in [
            b"",
            b"text",
            mcap.MAGIC,
            mcap.MAGIC + channel(),
            mcap.MAGIC + HEADER[8:-1],
            mcap.MAGIC * 2,
        ]:
            self.assertIsNone(self.all(data), data[:80])
        self.assertEqual(self.all(HEADER)[0].count, 0)

    def test_channels(self):
        """Whatever a channel says of itself, others are read."""
        bad = [
            channel(7, description="[" * 100000),
            channel(7, sources="[" * 100000),
            channel(7, sources="1"),
            channel(7, sources="[[1]]"),
            mcap.record(mcap.CHANNEL, b"x"),
            mcap.record(mcap.SCHEMA, b"\1\0\xff\xff\xff\xff"),
            channel(0, type="other"),
            mcap.metadata_record("rtlog", {"created": "9" * 400}),
            mcap.metadata_record("rtlog", {"created": ("x")}),
            mcap.metadata_record("rtlog", {"created": ("²")}),
            mcap.record(mcap.METADATA, b"\xff" * 9),
            mcap.record(mcap.ATTACHMENT, bytes(16) + b"\xff" * 30),
            mcap.record(mcap.ATTACHMENT, bytes(24) + struct.pack("<Q", 1 << 62)),
            mcap.record(0x99, b"x"),
        ]
        for record in bad:
            log, found = self.all(HEADER + channel() + record + chunk(message()))
            self.assertEqual(
                [(entry.data, log.channels[entry.channel].name) for entry in found],
                [(b"x", "a")],
                record[:80],
            )
        many = b"".join(channel(n) for n in range(3000))
        self.assertEqual(self.all(HEADER + many + chunk(message()))[0].count, 1)

    def test_lengths(self):
        """A length is not believed: nothing is allocated for it."""
        for length in (1 << 20, 1 << 40, (1 << 64) - 1):
            for kind in range(1, 16):
                self.all(HEADER + mcap.HEAD.pack(kind, length) + b"x")
        for odd in (
            chunk(b"x", size=1 << 60),
            chunk(b"x", within=1 << 60),
            chunk(mcap.HEAD.pack(5, 1 << 60)),
            chunk(b""),
        ):
            self.assertEqual(self.all(HEADER + channel() + odd + chunk(message()))[1][0].data, b"x")

    def test_messages(self):
        good = chunk(message())
        for body, damaged in (
            (message(9), 1),
            (mcap.record(mcap.MESSAGE, b"x"), 1),
            (message(moment=1 << 63), 1),
            (message(data=b"\0\7\0\0x"), 0),
            (message(data=b""), 0),
            (mcap.record(0x80, b"y"), 0),
        ):
            log, found = self.all(HEADER + channel() + good + chunk(body) + good)
            self.assertEqual(([entry.data for entry in found], log.damaged), ([b"x", b"x"], damaged), body)
        log, found = self.all(HEADER + channel() + good + chunk(message(), crc=7) + good)
        self.assertEqual((len(found), log.damaged), (2, 1))

    def test_broken_json_is_skipped(self):
        named = mcap.channel_record(0, 0, "a", "json", {})
        for data in (b"{", b"[" * 100000, b"\xff", b"1e", b""):
            log, found = self.all(HEADER + named + chunk(message(data=data) + message(data=b'{"a": [1]}')))
            self.assertEqual([entry.value for entry in found], [{"a": [1]}])
            self.assertEqual(log.damaged, 1)

    def test_compression(self):
        for name in ("lz4", "\x1b[2J", "zstd"):
            data = HEADER + channel() + chunk(b"xyz", compression=name)
            self.put(data)
            with mock.patch.object(compression, "_zstd", lambda: None), self.assertRaisesRegex(
                errors.Failed, "compressed with .*mcap decomp"
            ):
                logfile.load(self.name)

    def test_zstd_of_python_is_used(self):
        """As Python 3.14 and later; here another module is in its place."""
        class Decompressor:
            decompress = staticmethod(lambda octets, most: zlib.decompressobj().decompress(octets, most))

        module = mock.Mock(ZstdDecompressor=Decompressor, ZstdError=zlib.error)
        packed = zlib.compress(message())
        good = chunk(packed, zlib.crc32(message()), "zstd", len(message()))
        with mock.patch.object(compression, "_zstd", lambda: module):
            log, found = self.all(HEADER + channel() + good + chunk(b"odd", 1, "zstd") + good)
            self.assertEqual(([entry.data for entry in found], log.damaged), ([b"x", b"x"], 1))
            self.assertEqual(
                self.all(HEADER + channel() + chunk(zlib.compress(bytes(1 << 25)), 1, "zstd", 5) + good)[
                    0
                ].damaged,
                1,
            )

    def test_summaries(self):
        """A summary that does not agree with the file is not used."""
        written = messages(5)
        whole = self.write(written)
        start, _ = mcap.footer(whole[-mcap.FOOT.size:])
        data = whole[:start]
        index = mcap.record(
            mcap.CHUNK_INDEX,
            struct.pack("<QQQQ", 0, 0, 1 << 63, 5),
            mcap.blob(b""),
            bytes(8),
            mcap.string(""),
            bytes(16),
        )
        counts = mcap.record(
            mcap.STATISTICS,
            struct.pack("<QHIIIIQQ", 77, 1, 1, 0, 0, 1, 0, 0),
            mcap.blob(struct.pack("<HQ", 0, 77)),
        )
        for summary in (
            index,
            counts,
            index + counts,
            mcap.record(mcap.CHUNK_INDEX, b"x"),
            mcap.HEAD.pack(8, 1 << 50),
            b"x" * 8,
        ):
            for at in (len(data), 0, 8, len(data) + 7, 1 << 62):
                end = mcap.HEAD.pack(mcap.FOOTER, 20) + struct.pack("<QQI", at, 0, 0) + mcap.MAGIC
                self.assertEqual(self.all(data + summary + end)[1], as_read(written), (summary, at))

    def test_indexes_of_chunks(self):
        """One that leads past the end of the file was an internal error; so was, when a log was mended, what
        lies after a chunk where its indexes should be.
        """
        sound = HEADER + channel() + chunk(message())
        place = len(HEADER + channel())
        for size, between in (
            (1 << 63, b""),
            ((1 << 64) - 1, b""),
            (35, b"\x99" * 35),
            (51, b"\x99" * 51),
            (10**6, b""),
            (41, b""),
        ):
            count = (size - 19) // 16
            data = sound + between + mcap.record(mcap.DATA_END, bytes(4))
            index = mcap.record(
                mcap.CHUNK_INDEX,
                struct.pack("<QQQQ", 1, 2, place, len(sound) - place),
                mcap.blob(struct.pack("<HQ", 0, 0)),
                struct.pack("<Q", size),
                mcap.string(""),
                bytes(16),
            )
            counts = mcap.record(
                mcap.STATISTICS,
                struct.pack("<QHIIIIQQ", count, 1, 1, 0, 0, 1, 0, 0),
                mcap.blob(struct.pack("<HQ", 0, count)),
            )
            end = mcap.HEAD.pack(mcap.FOOTER, 20) + struct.pack("<QQI", len(data), 0, 0) + mcap.MAGIC
            with self.subTest(size):
                _, found = self.all(data + channel() + index + counts + end)
                self.assertEqual([entry.data for entry in found], [b"x"])
                out = self.name + "-mended"
                mend.mend(self.name, out)
                with logfile.load(out) as log:
                    self.assertEqual([entry.data for entry in log.entries()], [b"x"])
                    self.assertTrue(log.closed)

    def test_mending(self):
        odd = (
            mcap.record(mcap.CHUNK, b"xx"),
            b"".join(mcap.schema_record(n, "s", "ros2msg", b"int32 x") for n in range(65536)),
        )
        for record in odd:
            self.put(HEADER + channel() + record + chunk(message()))
            mend.mend(self.name, self.name + "-mended")
            with logfile.load(self.name + "-mended") as log:
                self.assertEqual([entry.data for entry in log.entries()], [b"x"])

    def test_many_channels(self):
        """Each was compared with all before it: 65,535 took minutes; and so was each of their sources."""
        begun = time.process_time()
        self.read_channels([{} for _ in range(20000)], "c%d")
        sources = [[f"{number}-{other}" for other in range(1000)] for number in range(300)]
        log = self.read_channels([{"sources": json.dumps(each)} for each in sources], "c")
        self.assertEqual(len(log.channels[0].sources), 1000)
        self.assertLess(time.process_time() - begun, 3)

    def read_channels(self, described, name):
        records = []
        for number, about in enumerate(described):
            called = name.replace("%d", str(number))
            records.append(mcap.channel_record(number, 0, called, "cdr", dict(about, type=LONG)))
        self.put(HEADER + b"".join(records) + chunk(message()))
        return self.read()[0]

    def test_integers_of_thousands_of_digits(self):
        """Reading one takes long, and plotting it was an internal error."""
        named = mcap.channel_record(0, 0, "a", "json", {})
        data = b'{"a": %s}'
        texts = [data % (b"1" * 4000), data % (b"1" * 300), data % b"7"]
        log, found = self.all(HEADER + named + chunk(b"".join(message(data=each) for each in texts)))
        self.assertEqual(([entry.value["a"] for entry in found][1], len(found), log.damaged), (7, 2, 1))
        series = plot.Series("a")
        for value in (10**400, 1, -(10**400), 2):
            series.add(0, value)
        self.assertEqual((series.least, series.greatest), (1, 2))

    def test_schemas(self):
        """Each is a type, or refused."""
        good = (
            "Time stamp\nfloat64[3] x  # y\nuint8 A=1\nstring[] names\n"
            + "=" * 80
            + "\nMSG: p/Time\nint32 sec\nuint32 nsec\n"
        )
        made = schemas.to_type(("p/Odd", "ros2msg", good.encode()))
        self.assertEqual(made.name, "p.Odd")
        bad = [
            "Nothing x",
            "int32",
            "int8 x",
            "p/Odd x",
            "float64[999999999] x",
            "wstring x",
            "",
            "x\0y z",
            "int32 x\nint32 x",
            "int32 _d",
            "$ x",
        ]
        for words in bad:
            with self.assertRaises(errors.Error, msg=words):
                schemas.to_type(("p/Odd", "ros2msg", words.encode()))
        for words in (
            '#include "/etc/passwd"\n',
            "module p {",
            "",
            "struct Other { long x; };",
            "typedef long Odd;" * 40000,
        ):
            with self.assertRaises(errors.Error, msg=words[:40]):
                schemas.to_type(("p::Odd", "omgidl", words.encode()))
        with self.assertRaises(errors.BadType):
            schemas.to_type(("p/Odd", "protobuf", b""))

    def test_names_of_standard_types(self):
        for name, expected in (
            ("rtc/TimedLong", "IDL:RTC/TimedLong:1.0"),
            ("rtc/msg/TimedLong", "IDL:RTC/TimedLong:1.0"),
            ("std_msgs/msg/Header", "IDL:std_msgs/Header:1.0"),
            ("RTC::TimedLong", "IDL:RTC/TimedLong:1.0"),
            ("x", "IDL:x:1.0"),
        ):
            self.assertEqual(schemas.type_id(name), expected)


if __name__ == "__main__":
    unittest.main()
