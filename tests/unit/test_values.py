"""Values in every form: bytes in both byte orders, JSON, constructors, text; and messages about those that do
not fit.

Needs no omniORB: the types are those of our own IDL files, read by our own parser. Spoilt ones are fuzz.py's.
"""
import glob
import json
import os
import random
import struct
import tempfile
import time
import unittest
from unittest import mock

import random_values
from rtshell_lite import errors
from rtshell_lite.data import call_values, datatypes, values

TESTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
OWN = os.path.join(os.path.dirname(TESTS), "rtshell_lite", "idl_stubs", "idl")
TRICKY = os.path.join(TESTS, "data", "idl", "valid")
FILES = sorted(glob.glob(os.path.join(glob.escape(OWN), "data", "*.idl")))


class Own(datatypes.Types):
    """Types from IDL files only: the standard ones too, so that no stubs are needed."""

    def __init__(self, paths):
        datatypes.Types.__init__(self, idl=paths)
        self.load()

    def _find(self, name):
        found = datatypes._best(self._users, name)
        return found and datatypes.Type(found)

    def all(self):
        """Those of them whose values can be read."""
        for type_id in sorted(self._users):
            try:
                datatypes.check(self._users[type_id], type_id)
            except errors.BadType:
                continue
            yield datatypes.Type(self._users[type_id])


TYPES = Own(FILES)
EVERYTHING = Own(
    FILES + [os.path.join(TRICKY, name + ".idl") for name in ("unions", "recursive", "constants", "scopes")]
)


def made(text, name=None):
    """The value of an expression, at 1.5 s."""
    return values.Expression(text, TYPES, name and TYPES.named(name)).value(1.5)


class Infinite(unittest.TestCase):
    """A number that no double holds is refused; only who writes Infinity means it."""

    def test_numbers_beyond_all_numbers(self):
        for text in ("1e400", '{"data": -1e400}', "RTC.TimedDouble({time}, 1e999)"):
            with self.assertRaisesRegex(errors.BadValue, "larger than any number; write Infinity"):
                made(text, "TimedDouble")
        with self.assertRaisesRegex(errors.BadValue, "larger than any number"):
            call_values.of_json(mock.Mock(shown="go"), '{"speed": 1e400}', None)

    def test_infinity(self):
        for text in ("Infinity", '{"data": Infinity}', "RTC.TimedDouble({time}, inf)"):
            self.assertEqual(made(text, "TimedDouble").data, float("inf"))
        self.assertEqual(made("-1.5e300", "TimedDouble").data, -1.5e300)


class RoundTrips(unittest.TestCase):
    def setUp(self):
        self.rng = random.Random(7)

    def test_every_type_through_every_form(self):
        count = 0
        for one in EVERYTHING.all():
            for _ in range(6):
                count += 1
                value = random_values.value(self.rng, one.descriptor)
                expected = random_values.plain(value)
                with self.subTest(type=one.id, value=expected):
                    for little in (True, False):
                        data = one.encode(value, little)
                        again, size = one.decode_part(data + b"rest", little)
                        self.assertEqual((random_values.plain(again), size), (expected, len(data)))
                    by_json = values.Expression(
                        json.dumps(values.json(value), allow_nan=False), EVERYTHING, one
                    ).value(0)
                    self.assertEqual(random_values.plain(by_json), expected)
                    written = values.constructor(value)
                    self.assertEqual(
                        random_values.plain(values.Expression(written, EVERYTHING, one).value(0)),
                        expected,
                        written,
                    )
                    copied = datatypes.from_bytes(one.to_bytes())
                    self.assertEqual(random_values.plain(copied.decode(data, False)), expected)
                    self.assertTrue(values.text(value).isprintable(), values.text(value))
                    self.assertTrue(
                        all(
                            cell is None or isinstance(cell, (str, int, float))
                            for _, cell in values.flat(value)
                        )
                    )
        self.assertGreater(count, 1000)

    def test_announced_but_not_there(self):
        for name, tail in (
            ("TimedDoubleSeq", b""),
            ("TimedOctetSeq", b"x"),
            ("TimedStringSeq", b""),
            ("TimedString", b"abc"),
            ("TimedWString", b"ab"),
            ("PointCloud", b""),
            ("TimedCharSeq", b""),
        ):
            for count in (b"\xff\xff\xff\xff", b"\0\0\0\x80", b"\x10\0\0\0"):
                with self.assertRaises(errors.BadData, msg=name) as caught:
                    TYPES.named(name).decode(bytes(8) + count + tail, True)
            self.assertRegex(
                str(caught.exception), r"^RTC\.\w+: 16 elements are announced, but \d bytes are left$"
            )
        with self.assertRaisesRegex(errors.BadData, "end too early, after 11 bytes"):
            TYPES.named("TimedLong").decode(bytes(11), True)
        with self.assertRaisesRegex(errors.BadData, "enum item number 9 of 4"):
            TYPES.named("GripperState").decode(bytes(8) + b"\x09\0\0\0", True)

    def test_nested_deep(self):
        node = EVERYTHING.named("Tree.Anonymous")
        with self.assertRaisesRegex(errors.BadData, "nested too deep"):
            node.decode(b"\1\0\0\0" * 200000, True)

    def test_leniency(self):
        text = TYPES.named("TimedString")
        # a string of length 0, as some ORBs send it
        self.assertEqual(text.decode(bytes(8) + bytes(4), True).data, "")
        self.assertEqual(text.decode(bytes(8) + b"\3\0\0\0\xe9x\0", True).data, "\udce9x")
        wide = TYPES.named("TimedWString")
        for units, expected in (
            (b"\xff\xfea\0", "a"),
            (b"\xfe\xff\0a", "a"),
            (b"\0a", "a"),
            (b"\xff\xfe\0\xd8", "\ud800"),
            (b"\xfe\xff\xd8\0", "\ud800"),
            (b"\xd8\0", "\ud800"),
        ):
            self.assertEqual(
                wide.decode(bytes(8) + bytes([len(units), 0, 0, 0]) + units, True).data, expected, units
            )


class Text(unittest.TestCase):
    def shown(self, text, expected, limit=None):
        self.assertEqual(values.text(made(text), limit), expected)

    def test_text(self):
        self.shown("RTC.TimedLong({time}, 42)", "[1.500000000] 42")
        self.shown("RTC.TimedString({time}, 'a\\x1b[1m日本')", "[1.500000000] a\\x1b[1m日本")
        self.shown("RTC.TimedBoolean({time}, True)", "[1.500000000] True")
        self.shown("RTC.TimedStringSeq({time}, ['a', \"it's\"])", "[1.500000000] ['a', 'it\\'s']")
        self.shown("RTC.TimedPoint2D({time}, RTC.Point2D(1, 2.5))", "[1.500000000] (x=1.0, y=2.5)")
        self.shown("RTC.TimedOctetSeq({time}, b'\\x00\\xff')", "[1.500000000] <00 ff>")
        self.shown("RTC.GripperState({time}, GRIPPER_STATE_OPEN)", "[1.500000000] status=GRIPPER_STATE_OPEN")
        self.shown("RTC.Point2D(1, 2)", "(x=1.0, y=2.0)")
        self.shown("RTC.Time(1, 2)", "(sec=1, nsec=2)")

    def test_cut(self):
        self.shown("RTC.TimedLongSeq({time}, [1,2,3,4,5])", "[1.500000000] [1, 2, … 3 more]", 2)
        self.shown("RTC.TimedLongSeq({time}, [1,2])", "[1.500000000] [1, 2]", 2)
        self.shown("RTC.TimedLongSeq({time}, [])", "[1.500000000] []", 2)
        self.shown("RTC.TimedOctetSeq({time}, [1,2,3])", "[1.500000000] <01 02 … 1 more>", 2)

    def test_fields(self):
        value = made("RTC.TimedPose2D({time}, RTC.Pose2D(RTC.Point2D(1, 2), 3))")
        self.assertEqual(values.field(value, "data.position.y"), 2.0)
        self.assertEqual(values.text(values.field(value, "data")), "(position=(x=1.0, y=2.0), heading=3.0)")
        self.assertEqual(values.field(made("RTC.TimedLongSeq({time}, [1,2,3])"), "data[2]"), 3)
        for path, reason in (("data.z", "data.z: no such field: z (there are position, heading)"),
                             ("data[0]", "data[0]: no such field: [0] (it is not a sequence)"),
                             ("tm.sec.x", "tm.sec.x: no such field: x (a plain value has no fields)"),
                             ("data..x", "data..x: not a field; one is written data.points[0].x")):
            with self.assertRaises(errors.Error) as caught:
                values.field(value, path)
            self.assertEqual(str(caught.exception), reason)

    def test_times(self):
        value = made("RTC.TimedLong({time}, 42)")
        self.assertEqual(values.timestamp(value), (1, 500000000))
        later = values.with_timestamp(value, 5, 1500000000)
        self.assertEqual((values.text(later), values.text(value)), ("[6.500000000] 42", "[1.500000000] 42"))
        point = made("RTC.Point2D(1, 2)")
        self.assertEqual((values.timestamp(point), values.with_timestamp(point, 1, 1)), (None, point))

    def test_flat(self):
        self.assertEqual(values.flat(made("RTC.TimedPoint2D({time}, {'x': 1, 'y': 2})")),
                         [("tm.sec", 1), ("tm.nsec", 500000000), ("data.x", 1.0), ("data.y", 2.0)])
        self.assertEqual(
            values.flat(made("RTC.TimedLongSeq(data=[7, 8])"))[2:], [("data[0]", 7), ("data[1]", 8)]
        )
        self.assertEqual(values.flat(made("RTC.TimedOctetSeq(data=[7, 8])"))[2:], [("data", "0708")])

    def test_odd_types(self):
        """Types that only look like those of OpenRTM; values that are nested too deep to show."""
        odd = ("struct Stamp { string sec; string nsec; }; struct Odd { Stamp tm; long data; };"
               "struct Stamp2 { long sec; long nsec; long zone; }; struct Odd2 { Stamp2 tm; long data; };")
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, "odd.idl")
            with open(path, "w") as file:
                file.write(odd)
            types = Own([path])
        for text in ("Odd({'sec': 'a', 'nsec': 'b'}, 1)", "Odd2([], 1)", "Odd2({'sec': 1, 'nsec': 2, "
                                                                         "'zone': 3}, 1)"):
            try:
                value = values.Expression(text, types).value(0)
            except errors.BadValue:
                continue
            self.assertEqual((values.timestamp(value), values.with_timestamp(value, 1, 2)), (None, value))
            self.assertRegex(values.text(value), r"^\(tm=\(sec=.*\), data=1\)$")
        node = EVERYTHING.named("Tree.Anonymous")
        deep = None
        for _ in range(2000):
            deep = node.descriptor[1](1, [deep] if deep else [])
        for show in (values.text, values.json, values.flat, values.constructor):
            with self.assertRaisesRegex(errors.BadValue, "nested too deep"):
                show(deep)
        with self.assertRaisesRegex(errors.BadValue, "nested too deep"):
            node.encode(deep)

    def test_raw(self):
        lines = values.raw(
            TYPES.named("TimedLong").encode(
                values.with_timestamp(made("RTC.TimedLong(data=42)"), 1795272302, 5)
            )
        )
        self.assertEqual(lines[0], "12 bytes")
        self.assertEqual(lines[1], "00000000  6e ae 01 6b 05 00 00 00 2a 00 00 00              n..k....*...")
        self.assertIn("maybe: time 1795272302.000000005", lines)
        self.assertEqual(lines[3:], ["maybe: long 42"])
        self.assertEqual(values.raw(b""), ["0 bytes"])
        self.assertEqual(values.raw(bytes(40), limit=16)[2], "… 24 more")

    def test_guesses_at_raw_bytes(self):
        for data, guesses in (
            (b"\2\0\0\0\xff\0", ["string '\\xff'", "sequence of 2 octets"]),
            (b"\2\0\0\0\xff\1", ["sequence of 2 octets"]),
            (b"\1\0\0\0\xff\0", ["sequence of 1 shorts"]),
            (struct.pack("<f", 1.5), ["long 1069547520", "float 1.5"]),
            (bytes(4), ["long 0", "float 0.0"]),
            (struct.pack("<f", 1e30), ["long 1900671690"]),
            (struct.pack("<f", 1e-30), ["long 228737632"]),
        ):
            with self.subTest(data=data):
                self.assertEqual(
                    [line for line in values.raw(data) if "maybe" in line],
                    ["maybe: " + guess for guess in guesses],
                )


# what is written for a value, and why it is none
MISFITS = (
    ("RTC.TimedLong({time}, 'x')", "RTC.TimedLong: data: not a long: 'x'"),
    ("RTC.TimedLong({time}, True)", "RTC.TimedLong: data: not a long: True"),
    ("RTC.TimedLong({time}, 1.0)", "RTC.TimedLong: data: not a long: 1.0"),
    (
        "RTC.TimedShort({time}, 40000)",
        "RTC.TimedShort: data: out of range for a short (-32768 to 32767): 40000",
    ),
    (
        "RTC.TimedULong({time}, -1)",
        "RTC.TimedULong: data: out of range for an unsigned long (0 to 4294967295): -1",
    ),
    ("RTC.TimedFloat({time}, 1e39)", "RTC.TimedFloat: data: out of range for a float: 1e+39"),
    ("RTC.TimedChar({time}, 'ab')", "RTC.TimedChar: data: not a char: 'ab'"),
    ("RTC.TimedString({time}, 'a\\0b')", "RTC.TimedString: data: a string holds no NUL"),
    ("RTC.TimedString({time}, 5)", "RTC.TimedString: data: not a string: 5"),
    ("RTC.TimedLong({time}, null)", "RTC.TimedLong: data: not a long: None"),
    ("RTC.TimedLongSeq({time}, 5)", "RTC.TimedLongSeq: data: not a sequence<long>: 5"),
    ("RTC.TimedOctet({time}, b'xy')", "RTC.TimedOctet: data: not an octet: b'xy'"),
    ("RTC.TimedOctet({time}, b'')", "RTC.TimedOctet: data: not an octet: b''"),
    (
        "RTC.TimedOctetSeq({time}, [1, 256])",
        "RTC.TimedOctetSeq: data[1]: out of range for an octet (0 to 255): 256",
    ),
    (
        "RTC.TimedPose2D({time}, RTC.Pose2D(RTC.Point2D(1, 'x'), 0))",
        "RTC.TimedPose2D: data.position.y: not a double: 'x'",
    ),
    (
        "RTC.TimedPose2D({time}, RTC.Point2D(1, 2))",
        "RTC.TimedPose2D: data: not a Pose2D: RTC.Point2D",
    ),
    (
        "RTC.TimedPose2D({time}, RTC.Pose2D(RTC.Point2D(1, 2)))",
        "RTC.TimedPose2D: data: heading is missing",
    ),
    ("RTC.TimedLong({time}, 1, 2)", "RTC.TimedLong: takes 2 values (tm, data), not 3"),
    ("RTC.TimedLong({time}, tm={time})", "RTC.TimedLong: tm is given twice"),
    ("RTC.TimedLong(dat=1)", "RTC.TimedLong: no member dat (its members: tm, data)"),
    ("RTC.TimedLong(5, 1)", "RTC.TimedLong: tm: not a Time: 5; {time} is the present"),
    (
        "RTC.TimedPose2D({time}, 1)",
        "RTC.TimedPose2D: data: not a Pose2D: 1 (its members: position, heading)",
    ),
    ("RTC.TimedLong({time}, {time})", "RTC.TimedLong: data: not a long: {time}"),
    ("RTC.TimedLong({time}, os.getpid())", "RTC.TimedLong: data: not a long: os.getpid"),
    (
        "RTC.LimbState({time}, 1, LIMB)",
        "RTC.LimbState: oapMatrix: not an OAP: 1 (its members: orientation, approach, position)",
    ),
    (
        "RTC.GripperState({time}, OPEN)",
        "RTC.GripperState: status: no GripperStatus: OPEN "
        "(they are GRIPPER_STATE_OPEN, GRIPPER_STATE_CLOSED, GRIPPER_STATE_MOVING, GRIPPER_STATE_UNKNOWN)",
    ),
)


class Written(unittest.TestCase):
    def test_forms(self):
        for text in (
            "RTC.TimedLong({time}, 42)",
            "TimedLong({time}, 42)",
            "RTC::TimedLong({time},42,)",
            "RTC.TimedLong(data=42)",
            "RTC.TimedLong(RTC.Time(1, 500000000), data=0x2a)",
            '{"data": 42}',
            "42",
            ' {"tm": {"sec": 1, "nsec":' ' 500000000}, "data": 42}',
            "RTC.TimedLong({{'sec': 1, 'nsec': 500000000}}, 42)",
            "RTC.TimedLong({time}, + 42)",
        ):
            with self.subTest(text=text):
                self.assertEqual(values.text(made(text, "TimedLong")), "[1.500000000] 42")
        self.assertEqual(made("RTC.TimedOctetSeq({time}, 'é')").data, b"\xc3\xa9")
        self.assertEqual(made('{"data": "w6k="}', "TimedOctetSeq").data, b"\xc3\xa9")
        self.assertEqual(made("RTC.TimedOctet({time}, b'x')").data, 0x78)
        self.assertEqual(made("[1, 2.5]", "TimedDoubleSeq").data, [1.0, 2.5])
        self.assertEqual(made("True", "TimedBoolean").data, True)
        self.assertEqual(made("RTC.TimedString({time}, 'a' \"b\")").data, "ab")
        self.assertEqual(made("RTC.TimedDouble({time}, -inf)").data, float("-inf"))
        self.assertEqual(made("RTC.GripperState({time}, RTC.GRIPPER_STATE_CLOSED)").status._v, 1)
        self.assertEqual(made('{"status": "GRIPPER_STATE_CLOSED"}', "GripperState").status._v, 1)
        self.assertEqual(made('{"status": 2}', "GripperState").status._n, "GRIPPER_STATE_MOVING")

    def test_time_is_fresh(self):
        expression = values.Expression("RTC.TimedLong({time}, 42)", TYPES)
        self.assertEqual(
            [values.timestamp(expression.value(now)) for now in (2, 3.25)], [(2, 0), (3, 250000000)]
        )

    def refused(self, text, reason, name=None):
        with self.assertRaises(errors.Error, msg=text) as caught:
            made(text, name)
        self.assertEqual(str(caught.exception), reason)

    def test_misfits_are_reported(self):
        for text, reason in MISFITS:
            with self.subTest(text=text):
                self.refused(text, reason)
        self.refused("RTC.TimedDouble({time}, 1)", "RTC.TimedDouble: not the type that is "
                                                   "wanted, RTC.TimedLong", "TimedLong")
        self.refused('{"data": "no base64!"}',
                     "RTC.TimedOctetSeq: data: octets are written as a list of numbers "
                     "or in base64: 'no base64!'", "TimedOctetSeq")

    def test_bounded_text(self):
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, "bounded.idl")
            with open(path, "w") as file:
                file.write("struct Bounded { string<3> a; wstring<3> b; };")
            types = Own([path])
        value = values.Expression("Bounded('abc', '日本語')", types).value(0)
        self.assertEqual((value.a, value.b), ("abc", "日本語"))
        for text, reason in (("Bounded('abcd', '')", "Bounded: a: longer than 3 bytes of UTF-8"),
                             ("Bounded('日本', '')", "Bounded: a: longer than 3 bytes of UTF-8"),
                             ("Bounded('', 'abcd')", "Bounded: b: longer than 3 characters")):
            with self.assertRaises(errors.BadValue) as caught:
                values.Expression(text, types).value(0)
            self.assertEqual(str(caught.exception), reason)

    def test_unreadable_values_are_refused(self):
        for text, reason in (
                ("RTC.TimedLong({time}, 42", "RTC.TimedLong({time}, 42: column 25: expected ,: the end"),
                ("RTC.TimedLong({time}; 42)", "RTC.TimedLong({time}; 42): column 21: cannot be read: ; 42)"),
                ("RTC.TimedLong({time}, 42) + 1", "RTC.TimedLong({time}, 42) + 1: column 27: expected "
                                                  "the end: + 1"),
                ("RTC.TimedLong(data=1, 2)", "RTC.TimedLong(data=1, 2): column 23: a value without a "
                                             "name after one with a name: 2)"),
                ("RTC.TimedLong({time}, 4 2)", "RTC.TimedLong({time}, 4 2): column 25: expected ,: 2)"),
                ("RTC.TimedLong({time}, '\\q')", "RTC.TimedLong({time}, '\\\\q'): column 23: bad "
                                                 "escape: '\\\\q')"),
                ("", "'': column 1: expected a value: the end"),
                ("\x1b[2J", "\\x1b[2J: column 1: cannot be read: \\x1b[2J"),
                ('{"data": }', '{"data": }: not JSON (Expecting value: line 1 column 10 (char 9))')):
            with self.subTest(text=text):
                self.refused(text, reason, "TimedLong")
        self.refused("42", "42: its type is not known; write it as RTC.TimedLong({time}, 42)")

    def test_hostile(self):
        for text in (
            "(" * 100000,
            "[" * 100000,
            "a(" * 100000,
            "{'a':" * 100000,
            "-" * 100000 + "1",
            "a." * 100000 + "b(",
            "[" * 100000 + "]" * 100000,
            '{"a":' * 100000,
            "9" * 100000,
            "1" + "+1" * 100000,
            "'" * 99999,
            "__import__('os').system('true')",
            "RTC.TimedLong({time}, (lambda: 1)())",
            "{0.__class__}",
            "RTC.TimedLong({time.__class__}, 1)",
            "f'{1}'",
            "RTC.TimedLong(__class__=1)",
        ):
            start = time.process_time()
            with self.assertRaises(errors.Error, msg=text[:40]) as caught:
                made(text, "TimedLong")
            self.assertLess(len(str(caught.exception)), 400, text[:40])
            self.assertLess(time.process_time() - start, 20, text[:40])


class Encoding(unittest.TestCase):
    def test_values_of_other_types(self):
        one = TYPES.named("TimedLong")
        other = made("RTC.TimedString({time}, 'x')")
        with self.assertRaises(errors.BadValue) as caught:
            one.encode(other)
        self.assertEqual(str(caught.exception), "RTC.TimedLong: data: not a long: 'x'")
        for wrong in (5, None, "x", [], made("RTC.Point2D(1, 2)")):
            with self.assertRaises(errors.BadValue):
                one.encode(wrong)

    def test_hostile_types(self):
        laughs = '["struct","S0","S0",[["a","long"]]]'
        for number in range(1, 40):
            laughs = '["struct","S%d","S%d",[["a",%s],["b",["see","S%d"]]]]' % (
                number,
                number,
                laughs,
                number - 1,
            )
        for data in (
            laughs,
            "[" * 100000,
            '["array","long",99999999999]',
            '["array",["array","long",65536],65536]',
            '["struct","I","S",[]]',
            '["see","X"]',
            '["take",1]',
            "{}",
            "5",
            '["struct","I","S",[["__class__","long"]]]',
            '["struct","I","S",[["_n","long"]]]',
            '["struct","I","S",[["a",["see","I"]]]]',
            '["plain","x"]',
            '["union","I","U","double",-1,[[1,"a","long"]]]',
        ):
            with self.assertRaises(errors.BadType, msg=data[:60]):
                datatypes.from_bytes(data.encode())


if __name__ == "__main__":
    unittest.main()
