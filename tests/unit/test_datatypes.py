"""Data types by name, from stubs, IDL files and components, and our CDR beside omniORB's own."""
import os
import random
import subprocess
import sys
import tempfile
import unittest

import random_values
from rtshell_lite import errors
from rtshell_lite.corba import omniorb, orb
from rtshell_lite.giop import descriptors, fixed_size, idl
from rtshell_lite.data import datatypes, values
from rtshell_lite.net import loop
from rtshell_lite.robot import ports

try:
    import omniORB
    from omniORB import CORBA
    from mock_components.idl import RTC, Img
except ImportError:
    omniORB = None

TESTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DATA = os.path.join(TESTS, "data", "idl", "valid")
OWN = os.path.join(os.path.dirname(TESTS), "rtshell_lite", "idl_stubs", "idl")
USER = """
#include "data/ExtendedDataTypes.idl"
#include "data/InterfaceDataTypes.idl"
#include "data/CameraCommonInterface.idl"
module User {
  typedef RTC::Pose2D Place;
  typedef RTC::GripperStatus Grip;
  typedef sequence<Img::Vec3> Vectors;
  union Held switch (RTC::GripperStatus) { case RTC::GRIPPER_STATE_CLOSED: double width; default: octet none; };
  struct All { RTC::Time tm; RTC::TimedPoint2D at; Place place_; Grip state; Vectors axes; Held it; Img::ColorFormat color; };
};
"""  # noqa: E501
OMNIIDL = os.path.join(os.path.dirname(sys.executable), "omniidl")
MINE = (
    "module Mine { struct Reading { long a; sequence<string> from; }; interface I { enum Mode { ON, OFF "
    "}; }; };"
)


def a_port(type_id, **properties):
    """A Port of a component that says this about its type."""
    return ports.Port(
        None, "a", "DataOutPort", dict(properties, **{"dataport.data_type": type_id}), [], [], None, None
    )


@unittest.skipIf(omniORB is None, "needs omniORBpy")
class Standard(unittest.TestCase):
    def test_names(self):
        types = datatypes.Types()
        for name in (
            "TimedLong",
            "RTC.TimedLong",
            "RTC::TimedLong",
            "::RTC::TimedLong",
            "IDL:RTC/TimedLong:1.0",
            "RTC/TimedLong",
        ):
            found = types.named(name)
            self.assertEqual((found.id, found.name), ("IDL:RTC/TimedLong:1.0", "RTC.TimedLong"), name)
        self.assertEqual(descriptors.members(found.descriptor)[1][0], "data")
        self.assertEqual(types.named("CameraImage").name, "RTC.CameraImage")
        self.assertEqual(types.named("TimedCameraImage").name, "Img.TimedCameraImage")
        for name in (
            "",
            "any",
            "Timed",
            "RTC.Missing",
            "__class__",
            "IDL:omg.org/RTC/TimedLong:1.0",
            "a.b.c",
            "IDL:",
            "\x1b[2J",
        ):
            with self.assertRaises(errors.NoSuch, msg=name) as caught:
                types.named(name)
            self.assertIn("--idl", str(caught.exception))
            self.assertTrue(str(caught.exception).isprintable())

    def every(self):
        """(name, TypeCode) of each standard struct."""
        for module, contents in (("RTC", RTC), ("Img", Img)):
            for type_id in idl.TYPES:
                if (
                    type_id.startswith(f"IDL:{module}/")
                    and descriptors.kind(idl.known(type_id)) == descriptors.STRUCT
                ):
                    yield f"{module}.{idl.name(type_id)}", getattr(contents, "_tc_" + idl.name(type_id))

    def test_beside_omniorb(self):
        """The same bytes, except padding, and the same values, in both byte orders."""
        omniorb.start()
        rng = random.Random(1)
        count = 0
        for name, typecode in self.every():
            if "WChar" in name:
                continue  # omniORB cannot read them
            one = datatypes.Types().named(name)
            for little in (True, False, True, False):
                count += 1
                value = random_values.value(rng, one.descriptor)
                data = one.encode(value, little)
                theirs = omniORB.cdrUnmarshal(typecode, data, little)
                with self.subTest(type=one.name):
                    self.assertEqual(len(omniORB.cdrMarshal(typecode, theirs, little)), len(data))
                    self.assertEqual(random_values.plain(text_as_ours(theirs)), random_values.plain(value))
        self.assertGreater(count, 400)

    def test_wide_characters_as_omniorb_writes_them(self):
        omniorb.start()
        for name, data in (("TimedWChar", "日"), ("TimedWCharSeq", ["日", "x"])):
            value = getattr(RTC, name)(RTC.Time(1, 2), data)
            for little in (True, False):
                one = datatypes.Types().named(name)
                theirs = omniORB.cdrMarshal(getattr(RTC, "_tc_" + name), value, little)
                self.assertEqual(one.encode(value, little), theirs)
                self.assertEqual(one.decode(theirs, little).data, data)

    def test_checked_bytes(self):
        """Bytes that a real component sent."""
        for name, data, expected in (
            ("TimedLong", 3, "010000000200000003000000"),
            ("TimedShort", -3, "0100000002000000fdff"),
            ("TimedDouble", 1.5, "0100000002000000000000000000f83f"),
            ("TimedString", "abc", "01000000020000000400000061626300"),
            ("TimedBoolean", True, "010000000200000001"),
            ("TimedOctetSeq", b"\1\2", "0100000002000000020000000102"),
        ):
            value = getattr(RTC, name)(RTC.Time(1, 2), data)
            self.assertEqual(datatypes.Types().named(name).encode(value).hex(), expected)


def text_as_ours(value):
    """A value as omniORB reads it, with Latin-1 text decoded as UTF-8."""
    if isinstance(value, str):
        try:
            return value.encode("latin-1").decode("utf-8", "surrogateescape") if len(value) > 1 else value
        except UnicodeEncodeError:
            return value  # wide text
    if isinstance(value, list):
        return [text_as_ours(each) for each in value]
    if hasattr(value, "__dict__") and not hasattr(value, "_n"):
        for name, inner in vars(value).items():
            if type(value).__name__ not in ("TimedCharSeq", "TimedChar", "TimedWString", "TimedWStringSeq"):
                setattr(value, name, text_as_ours(inner))
    return value


class Named(unittest.TestCase):
    """Types that the user names."""

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = directory.name

    def file(self, name, text):
        path = os.path.join(self.directory, name)
        with open(path, "w") as file:
            file.write(text)
        return path

    @unittest.skipIf(omniORB is None, "needs omniORBpy")
    def test_idl_files(self):
        types = datatypes.Types(idl=[self.file("mine.idl", MINE), os.path.join(DATA, "unions.idl")])
        self.assertEqual(types.named("Mine.Reading").id, "IDL:Mine/Reading:1.0")
        self.assertEqual(types.named("Reading").name, "Mine.Reading")
        self.assertEqual(types.named("Mine::I::Mode").name, "Mine.I.Mode")
        self.assertEqual(loop.run(types.of_port(a_port("Reading"))).name, "Mine.Reading")
        self.assertEqual(types.named("RTC.TimedLong").id, "IDL:RTC/TimedLong:1.0")
        found = values.Expression('Mine.Reading(5, ["x"])', types).value()
        self.assertEqual(values.text(found), "(a=5, from=['x'])")
        self.assertEqual(
            values.text(values.Expression("Mine.Reading(a=5, _from=[])", types).value()), "(a=5, from=[])"
        )
        with self.assertRaises(errors.NoSuch):
            types.named("Mine.Other")

    @unittest.skipIf(omniORB is None, "needs omniORBpy")
    def test_two_of_a_name(self):
        types = datatypes.Types(idl=[self.file("a.idl", "module A { struct S { long a; }; }; module B "
                                                        "{ struct S { long b; }; };")])
        self.assertEqual(types.named("B.S").name, "B.S")
        with self.assertRaises(errors.NoSuch) as caught:
            types.named("S")
        self.assertIn("it may be IDL:A/S:1.0 or IDL:B/S:1.0", str(caught.exception))

    def test_a_type_of_the_user_counts_before_the_standard_one(self):
        mine = self.file("own.idl", "module RTC { struct Time { long s; }; struct TimedLong { Time tm; "
                                    "double mine; }; };")
        types = datatypes.Types(idl=[mine])
        for name in "TimedLong", "RTC.TimedLong", "IDL:RTC/TimedLong:1.0":
            self.assertEqual(
                [name for name, _ in descriptors.members(types.named(name).descriptor)], ["tm", "mine"]
            )
        self.assertEqual(types.named("RTC.TimedShort").id, "IDL:RTC/TimedShort:1.0")

    def test_a_type_that_an_include_defines_too_names_both_files(self):
        mine = self.file("own.idl", '#include "BasicDataType.idl"\nmodule RTC {\nstruct TimedLong { long '
                                    'mine; };\n};')
        with self.assertRaises(errors.BadIdl) as caught:
            datatypes.Types(idl=[mine]).load()
        self.assertRegex(
            str(caught.exception),
            r"own.idl:3:8: TimedLong is declared already, in OpenRTM's BasicDataType.idl; "
            "leave one of the two out$",
        )

    def test_faults_show_at_once(self):
        with self.assertRaises(errors.BadIdl):
            datatypes.Types(idl=[self.file("broken.idl", "struct {")]).load()
        with self.assertRaises(errors.Failed):
            datatypes.Types(idl=["/nowhere/x.idl"]).load()

    @unittest.skipUnless(omniORB and os.path.exists(OMNIIDL), "needs omniidl")
    def test_compiled_stubs(self):
        path = self.file("mine.idl", MINE.replace("Mine", "MineToo") + " module Tree2 { struct Node; "
                                                                       "typedef sequence<Node> Nodes;"
                         " struct Node { long a; Nodes more; }; };")
        subprocess.check_call([OMNIIDL, "-bpython", "-C" + self.directory, path])
        before = list(sys.path)
        types = datatypes.Types(modules=["MineToo", "Tree2"], path=[self.directory])
        one = types.named("MineToo.Reading")
        self.assertEqual(sys.path, before)
        value = values.Expression("MineToo.Reading(a=5, _from=['x'])", types).value()
        self.assertEqual(values.text(one.decode(one.encode(value))), "(a=5, _from=['x'])")
        self.assertEqual(types.named("MineToo.I.Mode").id, "IDL:MineToo/I/Mode:1.0")
        nodes = types.named("Tree2.Node")
        tree = values.Expression("Tree2.Node(1, [Tree2.Node(2, [])])", types).value()
        self.assertEqual(values.text(nodes.decode(nodes.encode(tree))), "(a=1, more=[(a=2, more=[])])")
        with self.assertRaises(errors.NoSuch) as caught:
            datatypes.Types(modules=["Missing"], path=[self.directory]).load()
        self.assertIn("Missing: no such module", str(caught.exception))

    @unittest.skipUnless(omniORB and os.path.exists(OMNIIDL), "needs omniidl")
    def test_compiled_stubs_that_use_the_standard_types(self):
        path = self.file("user.idl", USER)
        subprocess.check_call([OMNIIDL, "-bpython", "-C" + self.directory, "-I" + OWN, path])
        types = datatypes.Types(modules=["User"], path=[self.directory])
        kind = types.named("User.All")
        made = values.Expression("User.All({time}, RTC.TimedPoint2D({time}, RTC.Point2D(1, 2)), "
                                 "RTC.Pose2D(RTC.Point2D(1, 2), 3), GRIPPER_STATE_OPEN, [[1, 2, 3]], "
                                 "{'_d': 'GRIPPER_STATE_CLOSED', '_v': 5}, CF_RGB)", types)
        data = kind.encode(made.value())
        self.assertEqual(
            values.text(kind.decode(data)).partition(" place_=")[2],
            "(position=(x=1.0, y=2.0), heading=3.0)"
            " state=GRIPPER_STATE_OPEN axes=[[1.0, 2.0, 3.0]] it=(width=5.0) color=CF_RGB",
        )
        loop.run(start_omniorb())
        theirs = omniORB.cdrMarshal(sys.modules["User"]._tc_All, kind.decode(data), True)
        self.assertEqual(len(theirs), len(data))  # octets between values may be anything
        self.assertEqual(values.text(kind.decode(theirs)), values.text(kind.decode(data)))

    @unittest.skipIf(omniORB is None, "needs omniORBpy")
    def test_ports_of_no_known_type(self):
        for type_id in ("any", "", "IDL:Their/Type:1.0"):
            one = a_port(type_id)
            with self.assertRaises(errors.NoSuch) as caught:
                loop.run(datatypes.Types().of_port(one._replace(node=Node)))
            self.assertIn("--raw", str(caught.exception))


async def start_omniorb():
    omniorb.start()


class Node:
    """Replaces the node of a port, for error messages."""

    class path:
        instance = "x"

        @staticmethod
        def with_port(name):
            return "/x:" + name


@unittest.skipIf(omniORB is None, "needs omniORBpy")
class Offered(unittest.TestCase):
    """TypeCodes of components may be hostile."""

    def taken(self, typecode):
        return datatypes.Type(descriptors.adopted(typecode._d, orb.descriptor))

    def test_typecodes(self):
        the_orb = omniorb.start()
        inner = the_orb.create_struct_tc(
            "IDL:T/Inner:1.0", "Inner", [CORBA.StructMember("x", CORBA.TC_double, None)]
        )
        outer = the_orb.create_struct_tc(
            "IDL:T/Outer:1.0",
            "Outer",
            [
                CORBA.StructMember("tm", RTC._tc_Time, None),
                CORBA.StructMember("data", the_orb.create_sequence_tc(0, inner), None),
            ],
        )
        through = omniORB.cdrUnmarshal(CORBA.TC_TypeCode, omniORB.cdrMarshal(CORBA.TC_TypeCode, outer))
        for typecode in (outer, through):
            one = self.taken(typecode)
            value = values.Expression("T.Outer({time}, [{'x': 1}])", None, one).value(2)
            self.assertEqual(values.text(one.decode(one.encode(value))), "[2.000000000] [(x=1.0)]")

    def test_hostile_typecodes(self):
        the_orb = omniorb.start()
        for typecode, reason in (
            (
                the_orb.create_struct_tc(
                    "IDL:T/S:1.0", "S", [CORBA.StructMember("__class__", CORBA.TC_long, None)]
                ),
                "identifier",
            ),
            (the_orb.create_struct_tc("IDL:T/S:1.0", "S", []), "needs members"),
            (the_orb.create_array_tc(1 << 30, CORBA.TC_octet), "out of bounds"),
            (
                the_orb.create_struct_tc("IDL:T/S:1.0", "S", [CORBA.StructMember("a", CORBA.TC_any, None)]),
                "values of any",
            ),
        ):
            with self.assertRaisesRegex(errors.BadType, reason):
                self.taken(typecode).decode(bytes(100))


class Cdr(unittest.TestCase):
    def test_least(self):
        self.assertEqual(fixed_size.least((descriptors.SEQUENCE, descriptors.LONG, 0)), 4)
        self.assertEqual(
            fixed_size.least((descriptors.ARRAY, (descriptors.ARRAY, descriptors.DOUBLE, 3), 2)), 48
        )


if __name__ == "__main__":
    unittest.main()
