"""Recording and playing without any port: which entries, when, with which times, and what a slow disk costs.
"""
import csv
import errno
import json
import os
import struct
import threading
import unittest
from unittest import mock

import simpkl_files
from test_datalog import CHANNELS, START, Case, messages
from rtshell_lite import errors
from rtshell_lite.data import datatypes, values
from rtshell_lite.datalog import (
    decode,
    gaps,
    logfile,
    pace,
    play,
    recorder,
    records,
    tables,
    textlog,
    writer,
)
from rtshell_lite.net import loop
try:
    import omniORB
except ImportError:
    omniORB = None


class Playing(Case):
    def numbers(self, start, end, by_index=True):
        with logfile.load(self.name) as log:
            return [entry.number for entry in play.Range(start, end, by_index).entries(log)]

    def test_ranges(self):
        """As rtshell: an end without a start is a number of entries, with one it is the last."""
        self.write(messages(10))
        for start, end, numbers in [
            (None, None, range(10)),
            (None, 3, range(3)),
            (0, 3, range(3)),
            (2, 4, range(2, 5)),
            (9, None, [9]),
            (None, -1, range(10)),
            (3, -1, range(3, 10)),
            (None, 99, range(10)),
            (None, 0, []),
        ]:
            self.assertEqual(self.numbers(start, end), list(numbers), (start, end))
        self.assertEqual(self.numbers(1700000000.0025, 1700000000.0055, False), [3, 4, 5])
        for start, end, by_index in [(10, None, True), (1800000000, None, False), (None, 1600000000, False)]:
            with self.assertRaises(errors.Failed):
                self.numbers(start, end, by_index)

    def test_a_line_of_text(self):
        out = textlog.TextWriter(self.name, CHANNELS, [None, None])
        out.write([(0, START + 5, True, b"\1"), (1, START - 1, True, b"")])
        out.close()
        with open(self.name) as file:
            self.assertEqual(file.read(), "1700000000.000000005\t('a', "
                                          "b'\\x01')\n1699999999.999999999\t('b', b'')\n")

    def test_moments(self):
        for value, can_be in (
            (0, True),
            ((1 << 63) - 1, True),
            (1 << 63, False),
            (-1 << 63, True),
            ((-1 << 63) - 1, False),
            (True, False),
            (1.0, False),
            (None, False),
        ):
            self.assertIs(records.is_moment(value), can_be, value)

    def test_a_log_without_entries_is_reported(self):
        self.write([])
        with logfile.load(self.name) as log:
            said = decode.as_dict(log)
        self.assertEqual([said["entries"], [channel["entries"] for channel in said["channels"]]], [0, [0, 0]])

    def test_pausing_stepping_jumping(self):
        """The caller chooses what comes next."""
        self.write([(0, START + i * 10 ** 9, True, b"") for i in range(40)])

        async def play_it(log):
            paced = pace.Pace(log, play.Range(None, None, True), 1000)
            came = []
            async for entry in paced.entries():
                came.append((entry.number, paced.is_elsewhere))
                if len(came) == 1:
                    paced.step()
                    paced.step()
                elif len(came) == 3:
                    paced.jump(pace.JUMP)
                    paced.pause()
                elif entry.number == 20 and len(came) < 30:
                    paced.jump(-pace.JUMP)
            return came

        with logfile.load(self.name) as log:
            came = loop.run(play_it(log))
        expected = (
            list(range(3))
            + list(range(7, 21))
            + list(range(15, 21))
            + list(range(15, 21))
            + list(range(15, 40))
        )
        numbers = [number for number, _ in came]
        self.assertEqual(numbers, expected)
        self.assertEqual([number for number, is_elsewhere in came if is_elsewhere], [0, 7, 15, 15, 15])

    def test_jumping_while_paused(self):
        """Each jump begins where the one before has led to, and the line shows that."""
        self.write([(0, START + i * 10 ** 9, True, b"") for i in range(40)])

        async def play_it(log):
            paced = pace.Pace(log, play.Range(None, None, True), 1000)
            positions = []

            async def press():
                while not paced.is_paused:
                    await loop.sleep(0)
                for seconds in (pace.JUMP, pace.JUMP, -3 * pace.JUMP):
                    paced.jump(seconds)
                    before = paced.position
                    while paced.position == before:
                        await loop.sleep(0)
                    positions.append((paced.position - START) // 10 ** 9)
                paced.pause()

            numbers = []
            async with loop.background(press()):
                async for entry in paced.entries():
                    numbers.append(entry.number)
                    if len(numbers) == 3:
                        paced.pause()
            return positions, numbers

        with logfile.load(self.name) as log:
            positions, numbers = loop.run(play_it(log))
        self.assertEqual(positions, [7, 12, 0])
        self.assertEqual(numbers, [0, 1, 2] + list(range(40)))


@unittest.skipUnless(omniORB, "omniORBpy is not installed")
class Timestamps(Case):
    """rtshell never moved them, and would have forgotten the carry."""

    def setUp(self):
        Case.setUp(self)
        self.write(
            [
                (0, START, True, struct.pack("<IIi", 1600000000, 900000000, 7)),
                (0, START, False, struct.pack(">IIi", 1600000000, 1, 7)),
                (0, START, True, struct.pack("<IIi", 0, 0, 7)),
                (0, START, True, b"xyz"),
            ],
            channels=[CHANNELS[0]._replace(typecode=b"")],
        )
        self.log = logfile.load(self.name)
        self.addCleanup(self.log.__exit__)
        self.decoder, self.entries = decode.Decoder(self.log, datatypes.Types()), list(self.log.entries())

    def data(self, number, little, moment=None):
        data = self.decoder.data(self.entries[number], little, moment)
        return struct.unpack("<IIi" if little else ">IIi", data)

    def test_left_alone(self):
        self.assertEqual(self.data(0, True), (1600000000, 900000000, 7))
        self.assertEqual(self.data(0, False), (1600000000, 900000000, 7))
        self.assertEqual(self.data(1, False), (1600000000, 1, 7))

    def test_moved_with_carry_in_both_byte_orders(self):
        later = START + 10 * 10 ** 9 + 200000000
        for little in (True, False):
            self.assertEqual(self.data(0, little, later), (1600000011, 100000000, 7))
            self.assertEqual(self.data(1, little, later), (1600000010, 200000001, 7))
        self.assertEqual(self.data(0, True, START - 10 ** 9), (1599999999, 900000000, 7))

    def test_one_that_was_never_set_stays(self):
        self.assertEqual(self.data(2, True, START + 10 ** 9), (0, 0, 7))

    def test_within_what_it_can_hold(self):
        self.assertEqual(self.data(0, True, 0), (0, 0, 7))
        self.assertEqual(self.data(0, True, START * 9), ((1 << 32) - 1, 999999999, 7))

    def test_data_that_is_none(self):
        self.assertEqual(self.decoder.data(self.entries[3], True, START + 1), b"xyz")
        with self.assertRaisesRegex(errors.Failed, "entry 3: RTC.TimedLong: the data end"):
            self.decoder.data(self.entries[3], False, START + 1)
        self.assertEqual(self.decoder.line(self.entries[3]), "3 bytes: 78797a")
        self.assertEqual(self.decoder.unreadable, 1)


class Types(Case):
    def open(self, type_id, typecode):
        self.write(
            [(0, START, True, struct.pack("<IIi", 1, 2, 7))],
            channels=[records.Channel("a", type_id, typecode, ())],
        )
        log = logfile.load(self.name)
        self.addCleanup(log.__exit__)
        return decode.Decoder(log, datatypes.Types()), next(log.entries())

    @unittest.skipUnless(omniORB, "omniORBpy is not installed")
    def test_described_in_the_file(self):
        """No IDL is needed for a type that nobody else knows."""
        code = datatypes.Types().named("TimedLong").to_bytes()
        decoder, entry = self.open("IDL:Own/Type:1.0", code)
        self.assertEqual(decoder.line(entry), "[1.000000002] 7")
        self.assertEqual(decoder.record(entry)["value"], {"tm": {"sec": 1, "nsec": 2}, "data": 7})

    def test_not_known(self):
        """The bytes are shown and played; only the other byte order needs the type."""
        for code in (b"", b"garbled", b"[" * 5000):
            decoder, entry = self.open("IDL:Own/Type:1.0", code)
            self.assertEqual(decoder.line(entry), "12 bytes: 010000000200000007000000")
            fields = decoder.record(entry)
            self.assertEqual((fields["hex"], fields["little_endian"]), ("010000000200000007000000", True))
            self.assertEqual(decoder.data(entry, True, START + 5), entry.data)
            with self.assertRaisesRegex(errors.Failed, "type IDL:Own/Type:1.0 is not known; name its "
                                                       "IDL file"):
                decoder.data(entry, False)


class Exporting(Case):
    def test_no_harm_to_a_terminal(self):
        """A table is looked at, too: nothing in a log reaches a terminal but what can be printed."""
        value = simpkl_files.make(
            simpkl_files.TimedLong,
            tm=simpkl_files.make(simpkl_files.Time, sec=1, nsec=2),
            **{"data": "\x1b[2J\u202e\r\n\\x", "a\x9b": 1}
        )
        self.put(simpkl_files.log([value], 2, specs=[simpkl_files.spec("n\x07", "IDL:Own/Type:1.0")]))
        with logfile.load(self.name) as log:
            lines = list(tables.lines(decode.Decoder(log, datatypes.Types()), log.entries()))
        self.assertEqual(lines, ["number,time,port,tm.sec,tm.nsec,data,a\\u009b",
                                 "0,1795247464.750000000,n\\x07,1,2,\\x1b[2J\\u202e\\x0d\\x0a\\\\x,1"])

    def test_columns(self):
        """Those that come later are in all lines; a cell with a comma or a quote is quoted; the timestamp is
        one column.
        """
        known = datatypes.Types()
        chosen = [
            ("TimedString", '"a,\\"b"'),
            ("TimedDoubleSeq", "[1.5]"),
            ("TimedDoubleSeq", "[2.5, 3.5]"),
            ("TimedPose2D", None),
        ]
        types = [known.named(name) for name in ("TimedString", "TimedDoubleSeq", "TimedPose2D")]
        channels = [records.Channel(type.name, type.id, type.to_bytes(), ()) for type in types]
        messages = []
        for name, words in chosen:
            (place,) = [place for place, type in enumerate(types) if type.name == "RTC." + name]
            spelt = (
                words
                or "RTC.TimedPose2D(tm=RTC.Time(sec=1, nsec=2), data=RTC.Pose2D(position=RTC.Point2D(x=1, "
                   "y=2), heading=3))"
            )
            value = values.Expression(spelt, None, types[place]).value(1.5)
            messages.append((place, START + len(messages), True, types[place].encode(value)))
        self.write(messages, channels=channels)
        with logfile.load(self.name) as log:
            lines = list(tables.lines(decode.Decoder(log, known), log.entries()))
            self.assertEqual({len(row) for row in csv.reader(lines)}, {10})
            self.assertEqual(
                lines[0],
                "number,time,port,tm,data,data[0],data[1],data.position.x,data.position.y,data.heading",
            )
            self.assertEqual(lines[1], '0,1700000000.000000000,RTC.TimedString,1.500000000,"a,""b",,,,,')
            self.assertEqual(lines[3:], ["2,1700000000.000000002,RTC.TimedDoubleSeq,1.500000000,,2.5,3.5,,,",
                                         "3,1700000000.000000003,RTC.TimedPose2D,1.000000002,,,,1.0,2.0,3.0"])
            directory = os.path.join(self.directory.name, "tables")
            names = tables.write(decode.Decoder(log, known), log.entries(), directory, True)
        self.assertEqual([os.path.basename(name) for name in names], [type.name + ".csv" for type in types])
        with open(names[1]) as file:
            self.assertEqual(
                file.read(),
                "number,time,port,tm,data[0],data[1]\n1,1700000000000000001,RTC.TimedDoubleSeq,1500000000,1.5,\n"  # noqa: E501
                "2,1700000000000000002,RTC.TimedDoubleSeq,1500000000,2.5,3.5\n",
            )

    def test_numbers(self):
        """A struct of numbers and times is shown without its value being made: in either byte order, and not
        where it is cut.
        """
        time = ["struct", "IDL:RTC/Time:1.0", "Time", [["sec", "unsigned long"], ["nsec", "unsigned long"]]]
        members = [
            ["tm", time],
            ["small", "short"],
            ["at", time],
            ["large", "double"],
            ["is_so", "boolean"],
            ["octet", "octet"],
        ]
        type = datatypes.from_bytes(
            json.dumps(["struct", "IDL:Own/Numbers:1.0", "Numbers", members]).encode()
        )
        words = (
            "Own.Numbers(tm=RTC.Time(1, 2), small=-3, at=RTC.Time(4, 1999999999), large=1e300, "
            "is_so=True, octet=255)"
        )
        value = values.Expression(words, None, type).value(None)
        messages = [(0, START, little, type.encode(value, little)) for little in (True, False)]
        self.write(messages + [(0, START, True, messages[0][3][:-1])],
                   channels=[records.Channel("n", type.id, type.to_bytes(), ())])
        with logfile.load(self.name) as log:
            decoder = decode.Decoder(log, datatypes.Types())
            lines = list(tables.lines(decoder, log.entries()))
        self.assertEqual(lines[0], "number,time,port,tm,small,at,large,is_so,octet,hex")
        self.assertEqual(lines[1], "0,1700000000.000000000,n,1.000000002,-3,5.999999999,1e+300,True,255,")
        self.assertEqual(lines[2], "1" + lines[1][1:])
        self.assertEqual(lines[3], "2,1700000000.000000000,n,,,,,,," + messages[0][3][:-1].hex())
        self.assertEqual(decoder.unreadable, 1)


class Deep(Case):
    """Values nested so deep that they can be read, but not be written as text: what comes behind them is not
    lost.
    """

    def setUp(self):
        Case.setUp(self)
        words = [
            "struct",
            "IDL:Own/Node:1.0",
            "Node",
            [["inner", ["sequence", ["see", "IDL:Own/Node:1.0"], 0]]],
        ]
        self.type = datatypes.from_bytes(json.dumps(words).encode())
        self.channel = records.Channel("deep", self.type.id, self.type.to_bytes(), ())
        self.messages = [
            (0, START + depth, True, b"\1\0\0\0" * depth + bytes(4))
            for depth in list(range(100, 300, 5)) + [0]
        ]

    def test_shown(self):
        self.write(self.messages, channels=[self.channel])
        with logfile.load(self.name) as log:
            decoder = decode.Decoder(log, datatypes.Types())
            for line_of in (decoder.line, decoder.record):
                self.assertEqual(len(list(map(line_of, log.entries()))), len(self.messages))
            self.assertEqual(len(list(tables.lines(decoder, log.entries()))), 1 + len(self.messages))

    def test_recorded_as_text(self):
        out = textlog.TextWriter(self.name, [self.channel], [self.type])
        out.write(self.messages)
        out.close()
        with open(self.name) as file:
            self.assertEqual(len(file.readlines()), len(self.messages))


class Recording(Case):
    def test_ports_with_one_name_share_a_channel(self):
        async def of_port(port):
            raise errors.BadType("x", "y")
        channels = recorder.Channels(mock.Mock(of_port=of_port))
        properties = {"dataport.data_type": "IDL:RTC/TimedLong:1.0"}
        found = []
        for label, name in (("/h/A.rtc:out", "one"), ("/h/B.rtc:out", "other"), ("/h/C.rtc:out", "one")):
            with mock.patch.object(recorder.ports, "label", lambda port: label):
                found.append(loop.run(channels.add(mock.Mock(properties=properties), name)))
        self.assertEqual((found, [channel.sources for channel in channels.found]),
                         ([0, 1, 0], [["/h/A.rtc:out", "/h/C.rtc:out"], ["/h/B.rtc:out"]]))
        with mock.patch.object(recorder.ports, "label", lambda port: "/h/D.rtc:out"), self.assertRaises(
            errors.Failed
        ):
            loop.run(channels.add(mock.Mock(properties={"dataport.data_type": (
                "IDL:RTC/TimedDouble:1.0"
            )}), "one"))

    def record(self, work, out, feed=None):
        """Have a Recorder write to a Writer until feed(), a coroutine, ends, or it is done."""
        async def main():
            work.writer = out
            async with loop.background(work.run()):
                await (feed() if feed else work.done.wait(60))
            await work.close()
        loop.run(main())

    def test_a_slow_disk_costs_messages_not_time(self):
        """The sender never waits, not even for a disk that writes nothing until all is sent; what does not
        fit is counted.
        """
        message, sent = message_of(b"x" * 1000000), threading.Event()

        class Slow(writer.LogWriter):
            def write(self, messages):
                if messages:
                    sent.wait()
                writer.LogWriter.write(self, messages)

        work = recorder_of([None, None])

        async def feed():
            take = work.box.taker(0)
            for _ in range(400):
                take(message)
                await loop.sleep(0)
            sent.set()
        self.record(work, Slow(self.name, CHANNELS, START), feed)
        self.assertEqual(work.count + sum(work.box.dropped.values()), 400)
        self.assertGreater(work.box.dropped[0], 0)
        self.assertEqual(len(self.read()[1]), work.count)
        with logfile.load(self.name) as log:  # months later
            (gap,) = decode.as_dict(log)["gaps"]
            self.assertEqual((gap["counts"], gap["why"]), ({"a": work.box.dropped[0]}, gaps.DROPPED))
            said = f"Missing: {decode.date(START)} until {decode.date(START)}: "
            self.assertIn(said, "\n".join(decode.summary(log)))
            note = "values are missing in it (intervals: 1); rtlog show says when"
            self.assertEqual(list(decode.Decoder(log, None).notes()), [note])

    def test_more_may_wait_where_there_is_much_memory(self):
        """300 values of 1 MB a second fill 32 MiB in 0.1 s, for which disks and threads do stop."""
        for pages, expected in ((1 << 15, 32), (1 << 18, 64), (1 << 22, 256)):
            with mock.patch.object(os, "sysconf", {"SC_PHYS_PAGES": pages, "SC_PAGE_SIZE": 4096}.get):
                self.assertEqual(recorder_of([None]).box.most_bytes >> 20, expected)
        with mock.patch.object(os, "sysconf", side_effect=ValueError):
            self.assertEqual(recorder_of([None]).box.most_bytes >> 20, 32)

    def test_the_end(self):
        """After `most` messages it is done, and the file has no more."""
        work = recorder_of([None, None], 3)
        for _ in range(5):
            work.box.put(1, message_of(b"abc"))
        self.record(work, writer.LogWriter(self.name, CHANNELS, START))
        self.assertEqual([entry.channel for entry in self.read()[1]], [1, 1, 1])

    def test_the_same_value_twice(self):
        """OpenRTM-aist 2.1 repeats a value whose answer was lost; values without a timestamp may be alike."""
        stamped = datatypes.Types().named("IDL:RTC/TimedLong:1.0")
        plain = datatypes.Types().named("IDL:RTC/Time:1.0")
        work = recorder_of([stamped, plain])
        for channel in range(2):
            for second in (0, 0, 1, 1, 1, 2):
                work.box.put(channel, message_of(struct.pack("<III", second, 0, 7)))
        self.record(work, writer.LogWriter(self.name, CHANNELS, START), lambda: loop.sleep(0.01))
        self.assertEqual((work.count, work.repeated), (12, 2))

    def test_a_disk_that_is_full(self):
        """It is done at once, and closing says why."""
        class Full(writer.LogWriter):
            def write(self, messages):
                raise OSError(errno.ENOSPC, "No space left on device")

        work = recorder_of([None, None])
        work.box.put(0, message_of(b"abc"))
        with self.assertRaisesRegex(OSError, "No space left"):
            self.record(work, Full(self.name, CHANNELS, START))
        self.assertEqual(work.count, 0)

    def test_a_bug_is_no_success(self):
        """Whatever ends what writes, the recording ends with an error."""
        class Broken(writer.LogWriter):
            def write(self, messages):
                raise LookupError("broken")

        work = recorder_of([None, None])
        work.box.put(0, message_of(b"abc"))
        with self.assertRaises(LookupError):
            self.record(work, Broken(self.name, CHANNELS, START))


def recorder_of(types, most=None):
    """A Recorder of channels of these types, which somebody else has told its writer of."""
    channels = recorder.Channels(None)
    channels.types += types
    channels.found += CHANNELS[: len(types)]
    made = recorder.Recorder(channels, most)
    made._added = len(types)
    return made


def message_of(data):
    from rtshell_lite.data.reading import Message
    return Message(START, data, True)


if __name__ == "__main__":
    unittest.main()
