"""Logs and the official readers of MCAP: each value that we write is read by them, and we read what their
writers write.

`tests/run --compat` runs this, in an environment of its own with the packages `mcap` and `mcap-ros2-support`;
those of npm are used where npm can install them.
"""
import glob
import json
import math
import os
import random
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

TESTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path[:0] = [os.path.dirname(TESTS), os.path.join(TESTS, "support")]

try:
    from mcap.reader import make_reader
    from mcap.stream_reader import StreamReader
    from mcap.records import Message
    from mcap.writer import CompressionType, Writer
    from mcap_ros2.decoder import DecoderFactory
    from mcap_ros2.writer import Writer as RosWriter
except ImportError:
    raise unittest.SkipTest("needs mcap and mcap-ros2-support; see tests/run --compat")
if sys.version_info >= (3, 14):
    from compression import zstd
else:
    from backports import zstd  # what Python 3.14 has, for older ones

import random_values  # noqa: E402
from rtshell_lite import errors  # noqa: E402
from rtshell_lite.data import datatypes  # noqa: E402
from rtshell_lite.data.idl import parser  # noqa: E402
from rtshell_lite.datalog import compression, decode, logfile, mend, records, schemas, writer  # noqa: E402
from rtshell_lite.giop import descriptors  # noqa: E402

START = 1700000000 * 10 ** 9
EACH = 20  # values of a type
IDL = sorted(
    glob.glob(
        os.path.join(os.path.dirname(TESTS), "rtshell_lite", "idl_stubs", "idl", "**", "*.idl"),
        recursive=True,
    )
)


def known_types():
    """The datatypes.Types that can be recorded, of the standard IDL and of the tests'."""
    found = {}
    for name in IDL + [
        os.path.join(TESTS, "data", "idl", "valid", name + ".idl") for name in ("unions", "recursive")
    ]:
        found.update(parser.parse_file(name))
    made = []
    for type_id in sorted(found):
        try:
            datatypes.check(found[type_id], type_id)
        except errors.BadType:
            continue
        if descriptors.kind(found[type_id]) in (descriptors.STRUCT, descriptors.UNION):
            made.append(datatypes.Type(found[type_id]))
    return made


def comparable(value, type):
    """A value of ours as everybody has it: enums as numbers, characters as octets, octets as numbers."""
    inner = descriptors.target(type)
    sort = descriptors.kind(inner)
    if sort == descriptors.ENUM:
        return value._v
    if sort == descriptors.CHAR:
        return ord(value)
    if sort in (descriptors.FLOAT, descriptors.DOUBLE):
        return "nan" if math.isnan(value) else value
    if sort in (descriptors.SEQUENCE, descriptors.ARRAY):
        return [
            comparable(each, descriptors.element(inner)) if not isinstance(value, bytes) else each
            for each in value
        ]
    if sort == descriptors.STRUCT:
        return {name: comparable(getattr(value, name), member) for name, member in descriptors.members(inner)}
    return value


def theirs(value):
    """What the Python reader has decoded."""
    if isinstance(value, float):
        return "nan" if math.isnan(value) else value
    if isinstance(value, (bytes, list, tuple)) or type(value).__name__ == "array":
        return [theirs(each) for each in value]
    if hasattr(value, "__slots__") or hasattr(value, "__dict__"):
        names = getattr(value, "__slots__", None) or vars(value)
        return {name: theirs(getattr(value, name)) for name in names}
    return value


def of_javascript(value):
    if isinstance(value, dict):
        if set(value) == {"big"}:
            return int(value["big"])
        if set(value) == {"odd"}:
            return "nan" if value["odd"] == "NaN" else float(value["odd"].replace("Infinity", "inf"))
        return {name: of_javascript(each) for name, each in value.items()}
    if isinstance(value, list):
        return [of_javascript(each) for each in value]
    return value


class Case(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.name = os.path.join(directory.name, "a.mcap")

    def recorded(self, close=True):
        """A log of random values of all types: [(channel's name, Type, value)]."""
        rng = random.Random(1)
        types = known_types()
        channels = [
            records.Channel(type.name, type.id, type.to_bytes(), ("/h/A.rtc:" + type.name,)) for type in types
        ]
        out = writer.LogWriter(self.name, channels, START)
        written = []
        for turn in range(EACH):
            batch = []
            for number, type in enumerate(types):
                value = random_values.value(rng, type.descriptor)
                little = rng.random() < 0.7
                batch.append((number, START + len(written), little, type.encode(value, little)))
                written.append((type.name, type, value))
            out.write(batch)
        if close:
            out.close()
        else:
            out._file.close()
            out._indexes.close()
        return written


class Ours(Case):
    """What we write."""

    def test_python_reads_every_value(self):
        written = self.recorded()
        with open(self.name, "rb") as file:
            reader = make_reader(file, validate_crcs=True, decoder_factories=[DecoderFactory()])
            summary = reader.get_summary()
            self.assertEqual(summary.statistics.message_count, len(written))
            plain = {channel.topic for channel in summary.channels.values()
                     if channel.schema_id and summary.schemas[channel.schema_id].encoding == "ros2msg"}
            self.assertGreater(len(plain), 50)
            found = [
                (each.channel.topic, theirs(each.decoded_message))
                for each in reader.iter_decoded_messages(topics=plain, log_time_order=False)
            ]
        expected = [
            (name, comparable(value, type.descriptor)) for name, type, value in written if name in plain
        ]
        for one, other in zip(found, expected):
            self.assertEqual(one, other)
        self.assertEqual(len(found), len(expected))

    def test_without_an_end_all_is_read(self):
        written = self.recorded(close=False)
        with open(self.name, "rb") as file:
            count = 0
            try:
                for record in StreamReader(file, validate_crcs=True).records:
                    count += isinstance(record, Message)
            except Exception as e:
                self.assertEqual(type(e).__name__, "EndOfFile")
        self.assertEqual(count, len(written))

    def test_we_read_every_value(self):
        written = self.recorded()
        with logfile.load(self.name) as log:
            decoder = decode.Decoder(log, datatypes.Types())
            found = [random_values.plain(decoder.value(entry)) for entry in log.entries()]
        self.assertEqual(found, [random_values.plain(value) for _, _, value in written])

    @unittest.skipUnless(os.environ.get("RTSHELL_NPM"), "npm has not installed @mcap/core")
    def test_javascript_reads_every_value(self):
        """Of the types that omgidl describes, structs: its reader shows unions in its own way, and reads no
        wide text.
        """
        written = self.recorded()
        said = subprocess.run(
            ["node", os.path.join(TESTS, "compat", "read_mcap.js"), self.name],
            stdout=subprocess.PIPE,
            check=True,
            env=dict(os.environ, NODE_PATH=os.environ["RTSHELL_NPM"]),
        ).stdout.decode()
        found = [json.loads(line) for line in said.splitlines()]
        self.assertEqual(len(found), len(written))
        compared = set()
        for line, (name, type, value) in zip(found, written):
            self.assertEqual(line["topic"], name)
            if line["value"] is None or any(
                descriptors.kind(inner) in (descriptors.UNION, descriptors.WCHAR, descriptors.WSTRING)
                for _, inner in descriptors.walk(type.descriptor, "")
            ):
                continue
            compared.add(name)
            self.assertEqual(of_javascript(line["value"]), comparable(value, type.descriptor), name)
        self.assertGreater(len(compared), 60)


class Theirs(Case):
    """What their writers write."""

    def ros(self, **options):
        with open(self.name, "wb") as file:
            out = RosWriter(file, **options)
            schema = out.register_msgdef("rtc/msg/TimedLong", "rtc/Time tm\nint32 data\n" + "=" * 80 +
                                         "\nMSG: rtc/Time\nuint32 sec\nuint32 nsec")
            for number in range(100):
                out.write_message(
                    "/numbers",
                    schema,
                    {"tm": {"sec": 1, "nsec": number}, "data": number},
                    START + number,
                    START,
                    number,
                )
            out.finish()

    def test_ros2(self):
        for options in (
            {"compression": CompressionType.NONE},
            {"compression": CompressionType.NONE, "chunk_size": 300},
        ):
            self.ros(**options)
            with logfile.load(self.name) as log:
                decoder = decode.Decoder(log, datatypes.Types())
                self.assertEqual(log.channels[0].type_id, "IDL:RTC/TimedLong:1.0")
                self.assertEqual((log.count, log.closed), (100, True))
                for entry in log.entries():
                    value = decoder.value(entry)
                    self.assertEqual(
                        (value.tm.nsec, value.data, entry.received),
                        (entry.number, entry.number, START + entry.number),
                    )
                self.assertEqual(next(log.entries(57)).number, 57)
                self.assertEqual(log.since(START + 70), 70)

    def test_compressed(self):
        for packed in (CompressionType.LZ4, CompressionType.ZSTD):
            self.ros(compression=packed)
            with mock.patch.object(compression, "_zstd", lambda: None), self.assertRaisesRegex(
                    errors.Failed, "compressed with .*, which is .*read.*; `mcap decompress FILE -o OUT`"):
                logfile.load(self.name)

    def test_zstd(self):
        """Read where Python has it; what is damaged is counted, as elsewhere; a mended copy is read by
        theirs.
        """
        with mock.patch.object(compression, "_zstd", lambda: zstd):
            self.ros(compression=CompressionType.ZSTD, chunk_size=300)
            with logfile.load(self.name) as log:
                self.assertEqual([entry.number for entry in log.entries()], list(range(100)))
                self.assertEqual(
                    ([entry.number for entry in log.entries(57)][0], log.since(START + 70)), (57, 70)
                )
                offsets = [(stretch.end, stretch.number) for stretch in log._stretches]
            end, count = offsets[len(offsets) // 2]
            with open(self.name, "r+b") as file:
                file.truncate(end - 1)
            with logfile.load(self.name) as log:
                self.assertEqual((len(list(log.entries())), log.damaged, log.closed), (count, 0, False))
            mend.mend(self.name, self.name + "-mended")
        with open(self.name + "-mended", "rb") as file:
            messages = make_reader(
                file, validate_crcs=True, decoder_factories=[DecoderFactory()]
            ).iter_decoded_messages()
            self.assertEqual([each.decoded_message.data for each in messages], list(range(count)))

    def test_zstd_that_is_damaged(self):
        self.ros(compression=CompressionType.ZSTD, chunk_size=300)
        with mock.patch.object(compression, "_zstd", lambda: zstd), open(self.name, "r+b") as file:
            with logfile.load(self.name) as log:
                stretch = log._stretches[1]
            file.seek(stretch.end - 8)
            file.write(b"\xff" * 8)
            file.flush()
            with logfile.load(self.name) as log:
                self.assertEqual(
                    (len(list(log.entries())), log.damaged), (100 - stretch.count, stretch.count)
                )

    def test_json_and_omgidl_in_no_chunk(self):
        for chunking in (True, False):
            with open(self.name, "wb") as file:
                out = Writer(file, compression=CompressionType.NONE, use_chunking=chunking)
                out.start()
                state = out.register_channel(
                    "/state", "json", out.register_schema("State", "jsonschema", b"{}")
                )
                idl = b"module own { enum Colour { red, green }; struct Odd { Colour colour; sequence<double> values; }; };"  # noqa: E501
                odd = out.register_channel("/odd", "cdr", out.register_schema("own::Odd", "omgidl", idl))
                own = datatypes.Type(schemas.to_type(("own::Odd", "omgidl", idl)).descriptor)
                for number in range(5):
                    out.add_message(state, START + number, b'{"a": %d}' % number, START)
                    value = random_values.value(random.Random(number), own.descriptor)
                    out.add_message(odd, START + number, b"\0\1\0\0" + own.encode(value), START)
                out.finish()
            with logfile.load(self.name) as log:
                decoder = decode.Decoder(log, datatypes.Types())
                lines = [decoder.record(entry) for entry in log.entries()]
                self.assertEqual(
                    [line["value"] for line in lines[::2]], [{"a": number} for number in range(5)]
                )
                self.assertIn(lines[1]["value"]["colour"], ("red", "green"))
                self.assertEqual((log.count, log.damaged, lines[1]["type"]), (10, 0, "IDL:own/Odd:1.0"))


if __name__ == "__main__":
    unittest.main()
