"""Our parser of IDL: it must see in a file the types that omniidl sees, and refuse with the place what is
broken.

A file dropped into tests/data/idl/valid is read by both, and both must say the same; one dropped into
tests/data/idl/invalid must be refused, with the message in NAME.error.
"""
import glob
import json
import os
import subprocess
import sys
import tempfile
import time
import unittest

import rtshell_lite
from rtshell_lite import errors
from rtshell_lite.giop import descriptors
from rtshell_lite.data import type_json
from rtshell_lite.data.idl import parser

TESTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DATA = os.path.join(TESTS, "data", "idl")
OMNIIDL = os.path.join(os.path.dirname(sys.executable), "omniidl")
OWN = os.path.join(os.path.dirname(TESTS), "rtshell_lite", "idl_stubs", "idl")


def cases(kind):
    return sorted(glob.glob(os.path.join(glob.escape(DATA), kind, "*.idl")))


def own_files():
    return sorted(glob.glob(os.path.join(glob.escape(OWN), "*", "*.idl")))


def parse(text, include=()):
    """The types of a text, {id: descriptor}."""
    with tempfile.TemporaryDirectory() as directory:
        path = os.path.join(directory, "case.idl")
        with open(path, "wb") as file:
            file.write(text.encode("latin-1"))
        return parser.parse_file(path, include)


def plain(types):
    """Types in a form that can be compared: words of Python without the _ that stubs put before them, no
    label of a default.
    """
    return {type_id: compared(type_json.plain(descriptor)) for type_id, descriptor in types.items()}


def compared(part):
    if isinstance(part, list):
        if part[:1] == ["union"]:
            cases = [[None if index == part[4] else case[0]] + case[1:] for index, case in enumerate(part[5])]
            part = part[:5] + [cases]
        return [compared(each) for each in part]
    return part.lstrip("_") if isinstance(part, str) else part


def by_omniidl(path, directory):
    """The types in the stubs that omniidl makes of a file."""
    subprocess.check_output(
        [OMNIIDL, "-bpython", "-Wbinline", "-I" + OWN, "-I" + os.path.dirname(path), "-C" + directory, path],
        stderr=subprocess.STDOUT,
    )
    root = os.path.dirname(os.path.dirname(rtshell_lite.__file__))
    out = subprocess.check_output(
        [
            sys.executable,
            os.path.join(TESTS, "unit", "stub_types.py"),
            directory,
            os.path.basename(path)[:-4] + "_idl",
        ],
        env=dict(os.environ, PYTHONPATH=root),
    )
    return {type_id: compared(part) for type_id, part in json.loads(out.decode()).items()}


def nested(times):
    """A type in a log file: sequences within sequences."""
    return '["sequence",' * times + '"long"' + ",0]" * times


def union(discriminator, default, label):
    """A type in a log file: a union of one member."""
    return json.dumps(["union", "IDL:U:1.0", "U", discriminator, default, [[label, "a", "long"]]])


def wide(count):
    """A type in a log file: a struct of that many members."""
    return '["struct","IDL:S:1.0","S",[%s]]' % ",".join('["a%x","long"]' % number for number in range(count))


class Valid(unittest.TestCase):
    maxDiff = None

    @unittest.skipUnless(os.path.exists(OMNIIDL), "needs omniidl")
    def test_as_omniidl_reads_them(self):
        paths = cases("valid") + own_files()
        self.assertGreater(len(paths), 20)
        for path in paths:
            with self.subTest(path=os.path.basename(path)), tempfile.TemporaryDirectory() as directory:
                theirs = by_omniidl(path, directory)
                self.assertEqual(plain(parser.parse_file(path, [os.path.dirname(path)])), theirs)
                self.assertTrue(theirs)

    def test_types_in_log_files(self):
        for path in cases("valid") + own_files():
            for type_id, descriptor in parser.parse_file(path, [os.path.dirname(path)]).items():
                with self.subTest(type=type_id):
                    again = type_json.descriptor(json.dumps(type_json.plain(descriptor)).encode())
                    self.assertEqual(type_json.plain(again), type_json.plain(descriptor))

    def test_members_named_as_types(self):
        """omniidl forbids it; other compilers do not, and the meaning is clear."""
        found = parse("struct Point { double x; }; struct Line { Point point; Point POINT2; "
                      "sequence<Point> Points; };")
        self.assertEqual(descriptors.words(found["IDL:Line:1.0"]), "Line")

    def test_files_that_come_along(self):
        for include in ('"BasicDataType.idl"', "<rtm/idl/BasicDataType.idl>", '"idl/ExtendedDataTypes.idl"'):
            found = parse(
                "#include %s\nmodule My { struct Stamped { RTC::Time tm; RTC::TimedLong l; }; };" % include
            )
            self.assertEqual(plain(found)["IDL:My/Stamped:1.0"][3][0][1][1], "IDL:RTC/Time:1.0")

    def test_other_spellings(self):
        self.assertIn(
            "IDL:S:1.0", parse("\ufeff".encode("utf-8").decode("latin-1") + "struct S { long a; };")
        )
        self.assertIn("IDL:S:1.0", parse("struct S\r\n{ long a; // \x95\x5c\r\n long b; };\r\n\x1a"))
        self.assertIn("IDL:S:1.0", parse("#include <orb.idl>\nstruct S { CORBA::TypeCode t; };;"))
        self.assertIn("IDL:x/y:1.0", parse('struct S { long a; }; typeid S "IDL:x/y:1.0"; component C { '
                                           'provides S a; };'))


class Invalid(unittest.TestCase):
    def test_refused_with_the_place(self):
        self.assertGreater(len(cases("invalid")), 20)
        for path in cases("invalid"):
            with self.subTest(path=os.path.basename(path)):
                with open(path + ".error", encoding="utf-8") as file:
                    expected = file.read().strip()
                with self.assertRaises(errors.BadIdl) as caught:
                    parser.parse_file(path)
                self.assertEqual(str(caught.exception).replace(os.path.dirname(path) + os.sep, ""), expected)

    def test_not_there(self):
        with self.assertRaises(errors.Failed):
            parser.parse_file(os.path.join(DATA, "missing.idl"))

    def test_types_in_log_files_that_cannot_be(self):
        for text in (
            '["fixed", Infinity, 1]',
            '["fixed", 5, "2"]',
            '["string", Infinity]',
            '["array", "long", NaN]',
            '["string"]',
            "[]",
            '["union", "IDL:U:1.0", "U", "long", -1, [[1e400, "a", "long"]]]',
            union("long", 1, 1),
            union("long", -2, 1),
            union("long", 0.0, 1),
            union("char", -1, "ab"),
            union("char", -1, 1),
            " " * type_json.LARGEST + '"long"',
            nested(descriptors.DEEPEST + 1),
            wide(descriptors.LARGEST),
        ):
            with self.assertRaises(errors.BadType, msg=text[:80]):
                type_json.descriptor(text.encode())

    def test_types_in_log_files_that_can_just_be(self):
        for text in (
            union("long", 0, 1),
            union("char", -1, "b"),
            " " * (type_json.LARGEST - 6) + '"long"',
            nested(descriptors.DEEPEST),
            wide(descriptors.LARGEST - 1),
        ):
            type_json.descriptor(text.encode())

    def bounded(self, text, reason):
        start = time.process_time()
        with self.assertRaises(errors.BadIdl) as caught:
            parse(text)
        self.assertIn(reason, str(caught.exception))
        self.assertLess(time.process_time() - start, 20)

    def test_large_and_deep(self):
        laughs = "struct S0 { long a; };" + "".join(
            "struct S%d { S%d a, b; };" % (i + 1, i) for i in range(60)
        )
        self.bounded(laughs, "too large")
        self.bounded("typedef " + "sequence<" * 5000 + "long" + ">" * 5000 + " T;", "too deep")
        self.bounded("module A%s" % "".join("{ module A%d " % i for i in range(3000)), "too deep")
        self.bounded("const long A = %s1%s;" % ("(" * 5000, ")" * 5000), "too deep")
        self.bounded("const long A = %s1;" % ("-" * 5000), "too deep")
        self.bounded("typedef long T[100000][100000];", "out of bounds")
        self.bounded("const long A = 1 << 63 << 63 << 63;", "too large")
        self.bounded("#define A B B\n#define B C C C C C C C C C C C C\n#define C D D D D D D D D D D D D "
                     "D D D D D D\n#define D E E E E E E E E E E E E E E\nA", "grows too large")
        self.bounded("#if " + "(" * 1000, "condition")
        self.bounded("#if 1\n" * 1000, "too deep")
        for directive in ("#pragma ", "#if 0\n"):
            self.bounded(directive + "/* " * 100000 + "\n", "a comment without its end")
        self.bounded(
            "union U switch (long) { " + "".join("case %d: " % i for i in range(50000)) + "long a; };",
            "too large",
        )
        self.bounded(
            "\n".join("#define A%d" % i for i in range(10)) + '\n#include "case.idl"\n', "too many files"
        )
        self.bounded("struct S { %s };" % "".join("long a%d; " % i for i in range(100000)), "too long")


if __name__ == "__main__":
    unittest.main()
