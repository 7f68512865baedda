"""What our own ORB reads and writes: the types of the IDL, an any as omniORB writes it, and what only hostile
peers send.
"""
import random
import struct
import time
import tracemalloc
import unittest

import random_values
from rtshell_lite.giop import cdr, descriptors, idl, ior
from rtshell_lite.giop.fixed_size import Fault
from rtshell_lite.corba.iiop import client
from rtshell_lite.giop import allowance, marshal, operations, typecodes

try:
    import omniORB
    from omniORB import CORBA
    from rtshell_lite.corba import omniorb
    from mock_components.idl import RTC
except ImportError:
    omniORB = None

COMPONENT = "IDL:openrtm.aist.go.jp/OpenRTM/DataFlowComponent:1.0"


class Tables(unittest.TestCase):
    """idl_stubs/tables.py, as giop/idl.py reads it."""

    def test_all_types(self):
        for type_id in idl.TYPES:
            self.assertEqual(descriptors.type_id(idl.known(type_id)) or idl.known(type_id)[2], type_id)
        self.assertIsNone(idl.known("IDL:RTC/Missing:1.0"))

    def test_names(self):
        for name, type_id in (("RTC.PortService", "IDL:omg.org/RTC/PortService:1.0"),
                              ("RTM.Manager", "IDL:RTM/Manager:1.0"),
                              ("OpenRTM.DataFlowComponent", COMPONENT),
                              ("CosNaming.NameComponent", "IDL:omg.org/CosNaming/NameComponent:1.0"),
                              ("SDOPackage.NameValue", "IDL:org.omg/SDOPackage/NameValue:1.0")):
            self.assertEqual(idl.id_of(name), type_id)

    def test_inherited_operations(self):
        for name in (
            "get_ports",
            "get_component_profile",
            "get_owned_contexts",
            "get_configuration",
            "_non_existent",
        ):
            operations.operation(COMPONENT, name)
        with self.assertRaises(KeyError):
            operations.operation(COMPONENT, "no_such")


@unittest.skipIf(omniORB is None, "needs omniORBpy")
class Values(unittest.TestCase):
    """An any as omniORB writes it."""

    def setUp(self):
        self.orb = omniorb.start()

    def read(self, typecode, value, little=True):
        data = omniORB.cdrMarshal(CORBA.TC_any, CORBA.Any(typecode, value), little)
        found, at = marshal.Maker("<" if little else ">").reader(descriptors.ANY)(data, 0)
        self.assertEqual(at, len(data))
        return found

    def test_plain(self):
        for little in (True, False):
            self.assertEqual(self.read(CORBA.TC_string, "gr\xfc\xdfe", little).content, "gr\xfc\xdfe")
            self.assertEqual(self.read(CORBA.TC_double, 1.5, little).content, 1.5)
            self.assertEqual(self.read(CORBA.TC_octet, 7, little).content, 7)
            self.assertIsNone(self.read(CORBA.TC_null, None, little).content)
            self.assertEqual(self.read(CORBA.TC_any, CORBA.Any(CORBA.TC_long, 3), little).content.content, 3)

    def test_structures(self):
        inner = self.orb.create_struct_tc(
            "IDL:T/Inner:1.0", "Inner", [CORBA.StructMember("x", CORBA.TC_double, None)]
        )
        many = self.orb.create_sequence_tc(0, inner)
        color = RTC._tc_LifeCycleState
        other = self.orb.create_alias_tc("IDL:T/Other:1.0", "Other", many)
        whole = self.orb.create_struct_tc(
            "IDL:T/Whole:1.0",
            "Whole",
            [
                CORBA.StructMember(name, code, None)
                for name, code in (("a", other), ("b", color), ("c", inner), ("d", inner))
            ],
        )
        for little in (True, False):
            descriptor = self.read(self.orb.create_sequence_tc(0, whole), [], little).descriptor
            self.assertEqual(
                [
                    words
                    for _, words in [(w, descriptors.words(p)) for w, p in descriptors.walk(descriptor, "")]
                ][:2],
                ["sequence<Whole>", "Whole"],
            )
            self.assertEqual(descriptors.members(descriptors.element(descriptor))[3][0], "d")

    def test_union(self):
        for switch, labels in (
            (CORBA.TC_long, (5, -6)),
            (CORBA.TC_boolean, (1, 0)),
            (CORBA.TC_char, ("x", "y")),
        ):
            cases = [
                CORBA.UnionMember(name, CORBA.Any(switch, label), code, None)
                for name, label, code in (("a", labels[0], CORBA.TC_long), ("b", labels[1], CORBA.TC_string))
            ]
            made = self.orb.create_union_tc("IDL:T/U:1.0", "U", switch, cases)
            descriptor = self.read(self.orb.create_sequence_tc(0, made), []).descriptor
            self.assertEqual(
                [case.member for case in descriptors.cases(descriptors.element(descriptor))], ["a", "b"]
            )

    def test_standard_types(self):
        """A random value of each standard data type, inside an any."""
        rng = random.Random(3)
        for name in sorted(
            name
            for name in vars(RTC)
            if name.startswith("_tc_") and "WChar" not in name and "WString" not in name
        ):
            descriptor = idl.known(f"IDL:RTC/{name[4:]}:1.0")
            code = getattr(RTC, name)
            if descriptor is None or descriptors.kind(descriptor) != descriptors.STRUCT:
                continue
            data = bytearray()
            again = bytearray()
            cdr.codec(descriptor, True)[1](data, random_values.value(rng, descriptor))
            found = self.read(code, omniORB.cdrUnmarshal(code, bytes(data), 1))
            marshal.Maker("<").writer(found.descriptor)(again, found.content)
            self.assertEqual(again, data, name)


def capsule(kind, body):
    """A TypeCode with an encapsulation."""
    return struct.pack("<II", kind, len(body) + 4) + b"\1\0\0\0" + body


NAME = struct.pack("<I", 2) + b"x\0\0\0"


class Rare(unittest.TestCase):
    """Types that omniORBpy reads, or not, and robots hardly use: they must not cost the properties around
    them.
    """

    def setUp(self):
        allowance.begin()

    def text(self, data, order="<"):
        """What a property shows whose value is this any."""
        found, end = marshal.Maker(order).reader(descriptors.ANY)(data, 0)
        self.assertEqual(end, len(data))
        return client.properties([(b"name", found)])[0][1]

    def test_fixed(self):
        for digits, scale, octets, expected in (
            (5, 2, b"\x12\x34\x5c", "123.45"),
            (4, 4, b"\x00\x01\x2d", "-0.0012"),
            (1, 0, b"\x7c", "7"),
            (2, -3, b"\x04\x2d", "-42000"),
        ):
            self.assertEqual(
                self.text(struct.pack("<IHh", descriptors.FIXED, digits, scale) + octets), expected
            )
        for digits, octets in ((32, bytes(17)), (0, b"\x0c"), (1, b"\x7a"), (1, b"\xac"), (3, b"\x12")):
            with self.assertRaises(Fault):
                self.text(struct.pack("<IHh", descriptors.FIXED, digits, 0) + octets)

    def test_long_double(self):
        for order in "<>":
            for high, low, expected in (
                (0x3FFF << 48 | 1 << 47, 0, "1.5"),
                (0xC000 << 48, 0, "-2.0"),
                (0, 0, "0.0"),
                (0, 1, "0.0"),
                (0x7FFF << 48, 0, "inf"),
                (0x7FFF << 48, 1, "nan"),
                (0x7FFE << 48, 0, "inf"),
            ):
                words = (low, high) if order == "<" else (high, low)
                data = struct.pack(order + "IIQQ", descriptors.LONGDOUBLE, 0, *words)
                self.assertEqual(self.text(data, order), expected)

    def test_principal(self):
        self.assertEqual(self.text(struct.pack("<II", descriptors.PRINCIPAL, 2) + b"me"), "b'me'")

    def test_exceptions(self):
        code = capsule(
            descriptors.EXCEPTION,
            NAME + NAME + struct.pack("<I", 1) + NAME + struct.pack("<I", descriptors.LONG),
        )
        self.assertEqual(self.text(code + NAME + struct.pack("<i", -5)), "<x>")

    def test_a_union_switched_by_another_name_of_char(self):
        char = capsule(descriptors.ALIAS, NAME + NAME + struct.pack("<I", descriptors.CHAR))
        code = capsule(descriptors.UNION, NAME + NAME + char + struct.pack("<iI", 0, 1) + b"a\0\0\0" + NAME
                       + struct.pack("<I", descriptors.LONG))
        self.assertEqual(self.text(code + b"z\0\0\0" + struct.pack("<i", 3)), "<x>")

    def test_values_of_a_type_inside_itself(self):
        """However deep, they are a text, or cost the answer."""
        members = NAME + NAME + struct.pack("<I", 1) + NAME
        back = -(12 + len(members) + 16)  # from the indirection to the struct around it
        inner = struct.pack("<II4sIiI", descriptors.SEQUENCE, 16, b"\1\0\0\0", 0xffffffff, back, 0)
        code = capsule(
            descriptors.SEQUENCE, capsule(descriptors.STRUCT, members + inner) + struct.pack("<I", 0)
        )
        shown = set()
        for depth in range(0, 500, 5):
            try:
                shown.add(self.text(code + struct.pack("<I", 1) * depth + struct.pack("<I", 0))[:7])
            except RecursionError:  # which is an answer that cannot be read
                shown.add("refused")
        self.assertEqual(shown, {"<sequen", "refused"})

    def test_sequences_of_structures(self):
        """Their texts name each type and member again: 94 kB became 360 MB."""
        octet = capsule(
            descriptors.STRUCT,
            NAME + NAME + struct.pack("<I", 1) + NAME + struct.pack("<I", descriptors.OCTET),
        )
        code = capsule(descriptors.SEQUENCE, octet + struct.pack("<I", 0))
        self.assertEqual(self.text(code + struct.pack("<I", 3) + b"abc"), "<sequence<x>>")
        code = capsule(descriptors.SEQUENCE, struct.pack("<II", descriptors.LONG, 0))
        self.assertEqual(self.text(code + struct.pack("<Iii", 2, 5, 6)), "[5, 6]")

    def test_many_properties_that_are_no_texts(self):
        enum = capsule(descriptors.ENUM, NAME + NAME + struct.pack("<I", 2) + NAME + b"\2\0\0\0y\0\0\0")
        for code, value in (
            (struct.pack("<I", descriptors.LONG), struct.pack("<i", 7)),
            (enum, struct.pack("<I", 1)),
        ):
            data = struct.pack("<I", 10000) + (NAME + code + value) * 10000
            allowance.begin()
            found, _ = operations.reader(idl.descriptor("IDL:org.omg/SDOPackage/NVList:1.0"), 1)(data, 0)
            self.assertEqual(client.properties(found)[-1], ("x", "7" if value[0] == 7 else "y"))


class Hostile(unittest.TestCase):
    """TypeCodes that no honest peer sends: each is refused at once, and takes no memory."""

    def setUp(self):
        allowance.begin()

    def refuse(self, data):
        start = time.process_time()
        with self.assertRaises((Fault, struct.error, IndexError)):
            typecodes.read(data, 0, "<")
        self.assertLess(time.process_time() - start, 1)

    def test_a_property_that_is_an_any_in_an_any(self):
        """Its text is the same each time, or comparing finds differences."""
        data = struct.pack("<II4sIII", 1, 3, b"ab\0\0", descriptors.ANY, descriptors.LONG, 7)
        nvlist, _ = marshal.Maker("<").reader(idl.known("IDL:org.omg/SDOPackage/NVList:1.0"))(data, 0)
        self.assertEqual(client.properties(nvlist), [("ab", "7")])

    def test_typecodes(self):
        name = NAME
        self.refuse(struct.pack("<I", 99))
        self.refuse(struct.pack("<Ii", 0xffffffff, -4))
        self.refuse(struct.pack("<II", descriptors.STRUCT, 0xfffffff0))
        self.refuse(capsule(descriptors.STRUCT, name + name + struct.pack("<I", 0x0fffffff)))
        self.refuse(capsule(descriptors.STRUCT, name + name + struct.pack("<I", 0)))
        self.refuse(capsule(descriptors.ENUM, name + name + struct.pack("<I", 0)))
        self.refuse(capsule(descriptors.UNION, name + name + struct.pack("<III", descriptors.DOUBLE, 0, 0)))
        self.refuse(capsule(descriptors.UNION, name + name + struct.pack("<III", descriptors.LONG, 3, 0)))
        self.refuse(capsule(descriptors.ARRAY, struct.pack("<II", descriptors.OCTET, 0xffffffff)))
        self.refuse(
            capsule(
                descriptors.UNION,
                name
                + name
                + capsule(descriptors.ENUM, name + name + struct.pack("<I", 1) + name)
                + struct.pack("<iIIII", -1, 1, 7, 2, 0x78)
                + struct.pack("<I", descriptors.LONG),
            )
        )
        deep = struct.pack("<I", descriptors.LONG)
        for _ in range(200):
            deep = capsule(descriptors.SEQUENCE, deep + struct.pack("<I", 0))
        self.refuse(deep)

    def test_small_answers_of_many_types_or_elements(self):
        """Each took megabytes and seconds."""
        def doubled(levels):
            """A struct of two members of a struct of two members …, of which the second are the first once
            more.
            """
            code = struct.pack("<I", descriptors.LONG)
            for level in range(levels):
                again = struct.pack("<Ii", 0xffffffff, -(len(code) + 12)) if level else code
                code = capsule(
                    descriptors.STRUCT,
                    NAME + NAME + struct.pack("<I", 2) + NAME + code + b"\2\0\0\0y\0\0\0" + again,
                )
            return code

        def empty(code):
            """An empty sequence of values of this type."""
            return capsule(descriptors.SEQUENCE, code + struct.pack("<I", 0)) + struct.pack("<I", 0)

        items = capsule(descriptors.ENUM, NAME + NAME + struct.pack("<I", 200000) + NAME * 200000)
        octet = capsule(
            descriptors.STRUCT,
            NAME + NAME + struct.pack("<I", 1) + NAME + struct.pack("<I", descriptors.OCTET),
        )
        octets = (
            capsule(descriptors.SEQUENCE, octet + struct.pack("<I", 0))
            + struct.pack("<I", 4 << 20)
            + bytes(4 << 20)
        )
        nothing = struct.pack("<I", 400000) + bytes(12 * 400000)
        for word, data in (
            (descriptors.ANY, empty(doubled(13))),
            (descriptors.ANY, empty(items)),
            (descriptors.ANY, octets),
            ("IDL:omg.org/CosNaming/BindingList:1.0", nothing),
            ("IDL:org.omg/SDOPackage/NVList:1.0", nothing),
        ):
            allowance.begin()
            tracemalloc.start()
            with self.assertRaisesRegex(Fault, "parts|too deep or too large"):
                operations.reader(idl.descriptor(word), 1)(data, 0)
            self.assertLess(tracemalloc.get_traced_memory()[1], 40 << 20)
            tracemalloc.stop()
        allowance.begin()
        found, _ = operations.reader(descriptors.ANY, 1)(empty(doubled(6)), 0)  # what is not too much is read
        self.assertEqual(found.content, [])
        with self.assertRaises(Fault):  # but not again and again in one answer
            for _ in range(200):
                operations.reader(descriptors.ANY, 1)(empty(doubled(6)), 0)

    def test_a_type_inside_itself_without_a_sequence(self):
        name = struct.pack("<I", 2) + b"x\0\0\0"
        body = name + name + struct.pack("<I", 1) + name
        self.refuse(struct.pack("<II", descriptors.STRUCT, len(body) + 12) + b"\1\0\0\0" + body
                    + struct.pack("<Ii", 0xffffffff, -(len(body) + 16)))

    def test_values(self):
        read = marshal.Maker("<").reader(descriptors.ANY)
        for data in (
            struct.pack("<III", 18, 0, 0xFFFFFFFF) + b"x",
            struct.pack("<III", 18, 0, 3) + b"abc",
            struct.pack("<II", 18, 0),
        ):
            with self.assertRaises((Fault, struct.error)):
                read(data, 0)
        with self.assertRaises(ior.BadReference):
            marshal.Maker("<").reader((descriptors.OBJECT, "", ""))(struct.pack("<II", 0, 1000), 0)
        nested = struct.pack("<I", descriptors.ANY) * 200 + struct.pack("<Ii", descriptors.LONG, 1)
        with self.assertRaises(Fault):
            read(nested, 0)
