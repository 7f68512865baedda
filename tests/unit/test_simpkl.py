"""rtshell's log files: those of every Python are read, and hostile pickles do nothing, construct nothing,
cost nothing.
"""
import io
import os
import pickle
import random
import struct
import tempfile
import tracemalloc
import unittest

import simpkl_files as files
from rtshell_lite import errors
from rtshell_lite.datalog import logfile, pickles, records

FIRST = 1795247464750000000


def machine(data):
    return pickles.PickleMachine(
        io.BytesIO(data), len(data), lambda module, name: (module, name) == ("known", "Known")
    )


def load(data):
    return machine(data).load()


class Case(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        self.name = os.path.join(self.directory.name, "log")

    def read(self, data, modules=()):
        with open(self.name, "wb") as file:
            file.write(data)
        with logfile.load(self.name, modules) as log:
            return log, list(log.entries())


class Files(Case):
    def check(self, data, closed, seconds=1000):
        log, found = self.read(data)
        self.assertEqual([entry.value for entry in found],
                         [{"tm": {"sec": seconds + i, "nsec": 5}, "data": i * 7} for i in range(3)])
        self.assertEqual([entry.received for entry in found], [FIRST + i * 10 ** 7 for i in range(3)])
        with logfile.load(self.name) as log:
            self.assertEqual((log.started, log.count, log.first, log.last, log.closed), (
                FIRST, 3, FIRST, FIRST + 2 * 10 ** 7, closed))
            self.assertEqual(log.channels, [records.Channel("numbers", files.TEXT, b"",
                                                            ("/localhost/Src0.rtc:out.numbers",))])
            self.assertEqual(log.since(FIRST + 1), 1)
            self.assertEqual([entry.number for entry in log.entries(2)], [2])

    def test_every_protocol(self):
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            for closed in (True, False):
                self.check(files.log(files.values(3), protocol, closed), closed)

    def test_python_2(self):
        for old_style in (False, True):
            self.check(files.python2_log(files.values(3), old_style), False, 0)

    def test_text_and_enumerators(self):
        item = files._class("omniORB", "EnumItem")
        found = self.read(
            files.log(
                [
                    files.make(
                        files.TimedLong,
                        text="\xe6\x97\xa5",
                        octets=b"\0\xff",
                        one=files.make(item, _n="RED", _v=1),
                        many=[files.make(files.Time, sec=1, nsec=2)] * 3,
                    )
                ],
                classes=files.CLASSES + (item,),
            )
        )[1]
        self.assertEqual(found[0].value, {"text": "\u65e5", "octets": b"\0\xff", "one": "RED",
                                          "many": [{"sec": 1, "nsec": 2}] * 3})

    def test_own_types_must_be_named(self):
        own = files._class("mine", "Own")
        specs = [files.spec("a", "IDL:mine/Own:1.0", own)]
        data = files.log([files.make(own, x=1)], specs=specs, classes=files.CLASSES + (own,))
        with self.assertRaisesRegex(errors.Failed, "mine.Own is not a class"):
            self.read(data)
        self.assertEqual(self.read(data, ["mine"])[1][0].value, {"x": 1})

    def test_standard_types_need_no_name(self):
        """Wherever rtshell took them from."""
        for module in ("RTC", "Img", "rtctree.rtc.RTC", "OpenRTM_aist.RTM_IDL.Img"):
            standard = files._class(module, "Own")
            data = files.log([files.make(standard, x=True, y=False)], classes=files.CLASSES + (standard,))
            self.assertEqual(self.read(data)[1][0].value, {"x": True, "y": False}, module)

    def test_cut_at_every_octet(self):
        data = files.log(files.values(4))
        whole = [entry.value for entry in self.read(data)[1]]
        counts = set()
        for size in range(1, len(data)):
            try:
                log, found = self.read(data[:size])
            except errors.Failed:
                continue
            self.assertEqual([entry.value for entry in found], whole[:len(found)])
            counts.add(len(found))
        self.assertEqual(counts, {0, 1, 2, 3})

    def test_changed_anywhere(self):
        """Only errors.Failed, or values of plain types."""
        chance = random.Random(2)
        for data in (
            files.log(files.values(4)),
            files.python2_log(files.values(4)),
            files.log(files.values(4), 0),
        ):
            for _ in range(500):
                changed = bytearray(data)
                for _ in range(chance.choice([1, 1, 3, 10])):
                    changed[chance.randrange(len(changed))] = chance.randrange(256)
                try:
                    log, found = self.read(bytes(changed))
                    list(log.notes())
                except errors.Failed:
                    continue
                for entry in found:
                    self.plain(entry.value)

    def plain(self, value):
        if isinstance(value, dict):
            self.assertLessEqual({type(key) for key in value}, {str})
            value = list(value.values())
        if isinstance(value, list):
            for part in value:
                self.plain(part)
        else:
            self.assertIn(type(value), (type(None), bool, int, float, str, bytes))


class Hostile(Case):
    """Every trick by which a pickle runs code, and those by which it eats memory or time."""

    CALLS = [
        b"cos\nsystem\n(S'touch %s'\ntR.",
        b"\x80\x04\x8c\x02os\x8c\x06system\x93\x8c\x01x\x85R.",
        b"(S'touch %s'\nios\nsystem\n.",
        b"(cos\nsystem\nS'touch %s'\no.",
        b"\x80\x02cos\nsystem\nU\x01x\x85\x81.",
        b"\x80\x04\x8c\x02os\x8c\x06system\x93)}\x92.",  # NEWOBJ_EX
        b"cknown\nKnown\n)R.",
        b"\x80\x02cknown\nKnown\nU\x01x\x85\x81.",
        b"(S'x'\niknown\nKnown\n.",
        b"(cknown\nKnown\nS'x'\no.",
        b"\x80\x02cknown\nKnown\n)}\x92.",
        b"\x80\x02cbuiltins\neval\nU\x011\x85R.",
        b"\x80\x02c__builtin__\nobject\n)\x81.",
        b"cbuiltins\nobject\n)R.",
        b"\x80\x02ccopyreg\n_reconstructor\nccopyreg\n_reconstructor\ncbuiltins\nobject\nN\x87R.",
        b"\x80\x02ccopyreg\n_reconstructor\ncos\nsystem\ncbuiltins\nobject\nN\x87R.",
        b"\x80\x02ccopyreg\n_reconstructor\ncknown\nKnown\ncknown\nKnown\nN\x87R.",
        b"\x80\x02ccopyreg\n_reconstructor\ncknown\nKnown\ncbuiltins\nobject\nU\x01x\x87R.",
        b"\x80\x04\x8c\x05known\x8c\x0cKnown.__init__\x93.",
        b"\x80\x04\x8c\x0eknown.__dict__\x8c\x05Known\x93.",
        # __setstate__, slots
        b"\x80\x02cknown\nKnown\n)\x81U\x01xb.",
        b"\x80\x02cknown\nKnown\n)\x81N}\x86b.",
        b"\x80\x02]}b.",
        b"\x80\x02}]b.",
        b"\x80\x02cknown\nKnown\n}b.",
        b"\x80\x02K\x01}b.",
        b"\x80\x02\x82\x01.",
        b"\x80\x02\x83\x01\x00.",
        b"\x80\x02\x84\x01\x00\x00\x00.",  # extensions
        # persistent, buffers, sets
        b"Pid\n.",
        b"U\x02idQ.",
        b"\x97.",
        b"\x98.",
        b"\x80\x04\x8f.",
        b"\x80\x04(\x91.",
    ]

    FAULTS = [
        b"",
        b".",
        b"0.",
        b"1.",
        b"2.",
        b"(.",
        b"((.",
        b"K\x01K\x02.",
        b"a.",
        b"]a.",
        b"e.",
        b"K\x01(e.",
        b"s.",
        b"u.",
        b"}(K\x01u.",
        b"}K\x01K\x02s.",
        b"}]K\x02s.",
        b"t.",
        b"\x85.",
        b"\x87.",
        b"\x94.",
        b"g5\n.",
        b"gx\n.",
        b"h\x05.",
        b"j\x05\0\0\0.",
        b"p-\n.",
        b"Ix\n.",
        b"Fx\n.",
        b"S'x\n.",
        b"Sx\n.",
        b"S'\\xZ'\n.",
        b"V\\u12\n.",
        b"I1",
        b"\x80\x06.",
        b"\x80",
        b"\x95" + b"\xff" * 8 + b".",
        b"\xff.",
        b"\x93.",
        b"K\x01K\x02\x93.",
        b"o.",
        b"(o.",
        b"cos\n.",
        b"b.",
        b"R.",
        b"X\x01\0\0\0\xff.",
        b"L" + b"9" * 5000 + b"L\n.",
    ]

    def test_calls(self):
        for data in self.CALLS:
            with self.assertRaises(pickles.Refused, msg=data):
                load(data)

    def test_faults(self):
        for data in self.FAULTS:
            with self.assertRaises((pickles.Refused, EOFError), msg=data):
                load(data)

    def test_within_a_log(self):
        """As an entry after good ones, which are read; the rest is reported and left out."""
        data = files.log(files.values(2))
        for hostile in self.CALLS + self.FAULTS[1:]:
            log, found = self.read(data + hostile)
            self.assertEqual((len(found), log.torn), (2, len(hostile)), hostile)
        with self.assertRaisesRegex(errors.Failed, "os.system is not a class"):
            self.read(b"\x80\x04" + self.CALLS[1])

    def test_attributes_are_inert(self):
        """Even names that are special for Python become keys of a dictionary."""
        found = load(b"\x80\x02cknown\nKnown\n)\x81}(U\x09__class__U\x01xU\x0c__setstate__U\x01yub.")
        self.assertEqual(found.fields, {"__class__": "x", "__setstate__": "y"})
        self.assertEqual(type(found), pickles.Record)

    def test_lengths_are_not_believed(self):
        for opcode, size in [
            (b"T", "<i"),
            (b"X", "<I"),
            (b"B", "<I"),
            (b"\x8d", "<Q"),
            (b"\x8e", "<Q"),
            (b"\x96", "<Q"),
            (b"\x8b", "<i"),
        ]:
            for length in (-1, 1 << 30, (1 << 31) - 1, (1 << 62)):
                try:
                    self.refused_cheaply(opcode + struct.pack(size, length) + b"xx.")
                except struct.error:
                    pass  # a length that does not fit in the opcode

    def test_the_memo_is_no_array(self):
        tracemalloc.start()
        self.assertEqual(load(b"K\x01r\xff\xff\xff\x7f."), 1)
        self.assertLess(tracemalloc.get_traced_memory()[1], 1 << 20)
        tracemalloc.stop()

    def refused_cheaply(self, data):
        tracemalloc.start()
        try:
            with self.assertRaises(pickles.Refused):
                load(data)
            self.assertLess(tracemalloc.get_traced_memory()[1], 1 << 20)
        finally:
            tracemalloc.stop()

    def test_bombs(self):
        """Values of few octets that expand to gigabytes, nest too deep, or contain themselves, are errors."""
        with files.importable():
            stamp = pickle.dumps(files.make(files.EntryTS, _sec=1, _nsec=0), 2)[2:-1]
        laughs = b"](K\x01K\x01K\x01K\x01e" + b"".join(
            b"q%c0](" % i + b"h%c" % i * 9 + b"e" for i in range(20)
        )
        deep = b"]" * 50000 + b"a" * 49999
        tuples = b")" + b"\x85" * 50000
        inside = b"]q\x00h\x00a"
        words = (
            b"}q\x000" + b"".join(b"}(U\x01ah%cU\x01bh%cuq%c0" % (i, i, i + 1) for i in range(18)) + b"h\x12"
        )
        inside_words = b"}q\0U\x01ah\0s"
        for value in (laughs, deep, tuples, inside, words, inside_words):
            entry = b"\x80\x02(K\x00" + stamp + b"X\x07\0\0\0numbers" + value + b"\x86K\x00K\x00t."
            tracemalloc.start()
            log, found = self.read(files.log([]) + entry)
            self.assertLess(tracemalloc.get_traced_memory()[1], 30 << 20)
            tracemalloc.stop()
            self.assertEqual(
                (found, list(log.notes())[0].rpartition(": ")[2]), ([], "a value that never ends")
            )

    def test_objects_of_one_octet(self):
        """3 MB took 250 MB."""
        for pickled in (
            b"N" + b"\x94" * 600000 + b".",
            b"(" + b"}" * 600000 + b"t.",
            b"(" + b"]\x94" * 600000,
            b"(cknown\nKnown\nq\0" + b"h\0)\x81" * 150000 + b"t.",
            b"N" + b"2" * 600000,
        ):
            tracemalloc.start()
            try:
                load(pickled)
            except pickles.Refused:
                pass
            self.assertLess(tracemalloc.get_traced_memory()[1], 40 * len(pickled))
            tracemalloc.stop()

    def test_many_small_structures(self):
        """As in a cloud of points: each has few octets, and all are read."""
        for protocol in 0, 2, 4:
            log, found = self.read(files.log([files.values(20000)], protocol))
            self.assertEqual((len(found[0].value), log.torn), (20000, 0))

    def test_values_are_recalled_by_any_number(self):
        for pickled, wanted in (
            (b"K\1q\0K\2q\1h\0h\1\x87.", None),
            (b"(K\1q\5K\2q\0K\3q\5h\5h\0t.", (1, 2, 3, 3, 2)),
            (b"(K\1\x94K\2\x94K\3q\0h\0h\1t.", (1, 2, 3, 3, 2)),
        ):
            if wanted is None:
                with self.assertRaises(pickles.Refused):
                    load(pickled)
            else:
                self.assertEqual(load(pickled), wanted)
        for pickled in b"K\1q\0g-1\n.", b"K\1p-1\n0h\0.", b"h\0.":
            with self.assertRaises(pickles.Refused):
                load(pickled)

    def test_long_text_many_times(self):
        """A text counts with its length at every place where it is used."""
        for text, protocol in (("\xe9" * 100000, 2), (b"\xe9" * 100000, 4)):
            log, found = self.read(files.log([[text] * 300], protocol))
            self.assertEqual(
                (found, list(log.notes())[0].rpartition(": ")[2]), ([], "a value that never ends")
            )
        self.assertEqual(len(self.read(files.log([["\xe9" * 1000 + str(i) for i in range(300)]]))[1]), 1)

    def test_times_that_cannot_be(self):
        """Every time fits into 64 bits of nanoseconds, as in logs of our own form."""
        for seconds in (1 << 2040, "9" * 4000, 1e300, -1e300, float("nan"), None):
            stamp = files.make(files.EntryTS, _sec=seconds, _nsec=0)
            with files.importable():
                entry = pickle.dumps((0, stamp, ("numbers", files.values(1)[0]), 0, 0), 2)
            log, found = self.read(files.log([]) + entry)
            self.assertEqual((found, log.torn), ([], len(entry)), seconds)

    def test_header_of_strange_values(self):
        for header in (
            1,
            (1,),
            (1.0, 2),
            (1.0, [2]),
            ("x", []),
            (float("nan"), []),
            (1e300, []),
            (1.0, [None]),
            (1.0, {}),
        ):
            try:
                log, found = self.read(pickle.dumps(header, 2) + b" " * 256)
            except errors.Failed:
                continue
            self.assertEqual(found, [])


if __name__ == "__main__":
    unittest.main()
