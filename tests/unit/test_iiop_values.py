"""What our own ORB reads and writes: the types of the IDL, an any as omniORB writes it, and what only hostile peers send."""
import random
import struct
import time
import unittest

import random_values
from rtshell_lite.corba import cdr, descriptors, idl, ior
from rtshell_lite.corba.fixed_size import Fault
from rtshell_lite.corba.iiop import client, marshal, operations, typecodes

try:
    import omniORB
    from omniORB import CORBA
    from rtshell_lite.corba import omni
    from mock_components.idl import RTC
except ImportError:
    omniORB = None

COMPONENT = "IDL:openrtm.aist.go.jp/OpenRTM/DataFlowComponent:1.0"


class Tables(unittest.TestCase):
    """idl_stubs/tables.py, as corba/idl.py reads it."""

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
        for name in ("get_ports", "get_component_profile", "get_owned_contexts", "get_configuration", "_non_existent"):
            operations.operation(COMPONENT, name)
        with self.assertRaises(KeyError):
            operations.operation(COMPONENT, "no_such")


@unittest.skipIf(omniORB is None, "needs omniORBpy")
class Values(unittest.TestCase):
    """An any as omniORB writes it."""

    def setUp(self):
        self.orb = omni.start()

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
        inner = self.orb.create_struct_tc("IDL:T/Inner:1.0", "Inner", [CORBA.StructMember("x", CORBA.TC_double, None)])
        many = self.orb.create_sequence_tc(0, inner)
        color = RTC._tc_LifeCycleState
        other = self.orb.create_alias_tc("IDL:T/Other:1.0", "Other", many)
        whole = self.orb.create_struct_tc("IDL:T/Whole:1.0", "Whole", [
            CORBA.StructMember(name, code, None) for name, code in (("a", other), ("b", color), ("c", inner), ("d", inner))])
        for little in (True, False):
            descriptor = self.read(self.orb.create_sequence_tc(0, whole), [], little).descriptor
            self.assertEqual([words for _, words in [(w, descriptors.words(p)) for w, p in descriptors.walk(descriptor, "")]][:2],
                             ["sequence<Whole>", "Whole"])
            self.assertEqual(descriptors.members(descriptors.element(descriptor))[3][0], "d")

    def test_union(self):
        for switch, labels in ((CORBA.TC_long, (5, -6)), (CORBA.TC_boolean, (1, 0)), (CORBA.TC_char, ("x", "y"))):
            cases = [CORBA.UnionMember(name, CORBA.Any(switch, label), code, None)
                     for name, label, code in (("a", labels[0], CORBA.TC_long), ("b", labels[1], CORBA.TC_string))]
            made = self.orb.create_union_tc("IDL:T/U:1.0", "U", switch, cases)
            descriptor = self.read(self.orb.create_sequence_tc(0, made), []).descriptor
            self.assertEqual([case.member for case in descriptors.cases(descriptors.element(descriptor))], ["a", "b"])

    def test_standard_types(self):
        """A random value of each standard data type, inside an any."""
        rng = random.Random(3)
        for name in sorted(name for name in vars(RTC) if name.startswith("_tc_") and "WChar" not in name and "WString" not in name):
            descriptor, code = idl.known(f"IDL:RTC/{name[4:]}:1.0"), getattr(RTC, name)
            if descriptor is None or descriptors.kind(descriptor) != descriptors.STRUCT:
                continue
            data, again = bytearray(), bytearray()
            cdr.codec(descriptor, True)[1](data, random_values.value(rng, descriptor))
            found = self.read(code, omniORB.cdrUnmarshal(code, bytes(data), 1))
            marshal.Maker("<").writer(found.descriptor)(again, found.content)
            self.assertEqual(again, data, name)


class Hostile(unittest.TestCase):
    """TypeCodes that no honest peer sends: each is refused at once, and takes no memory."""

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
        def capsule(kind, body):
            return struct.pack("<II", kind, len(body) + 4) + b"\1\0\0\0" + body

        name = struct.pack("<I", 2) + b"x\0\0\0"
        self.refuse(struct.pack("<I", 99))
        self.refuse(struct.pack("<Ii", 0xffffffff, -4))
        self.refuse(struct.pack("<II", descriptors.STRUCT, 0xfffffff0))
        self.refuse(capsule(descriptors.STRUCT, name + name + struct.pack("<I", 0x0fffffff)))
        self.refuse(capsule(descriptors.STRUCT, name + name + struct.pack("<I", 0)))
        self.refuse(capsule(descriptors.ENUM, name + name + struct.pack("<I", 0)))
        self.refuse(capsule(descriptors.UNION, name + name + struct.pack("<III", descriptors.DOUBLE, 0, 0)))
        self.refuse(capsule(descriptors.UNION, name + name + struct.pack("<III", descriptors.LONG, 3, 0)))
        self.refuse(capsule(descriptors.ARRAY, struct.pack("<II", descriptors.OCTET, 0xffffffff)))
        self.refuse(capsule(descriptors.UNION, name + name + capsule(descriptors.ENUM, name + name + struct.pack("<I", 1) + name)
                            + struct.pack("<iIIII", -1, 1, 7, 2, 0x78) + struct.pack("<I", descriptors.LONG)))
        deep = struct.pack("<I", descriptors.LONG)
        for _ in range(200):
            deep = capsule(descriptors.SEQUENCE, deep + struct.pack("<I", 0))
        self.refuse(deep)

    def test_a_type_inside_itself_without_a_sequence(self):
        name = struct.pack("<I", 2) + b"x\0\0\0"
        body = name + name + struct.pack("<I", 1) + name
        self.refuse(struct.pack("<II", descriptors.STRUCT, len(body) + 12) + b"\1\0\0\0" + body
                    + struct.pack("<Ii", 0xffffffff, -(len(body) + 16)))

    def test_values(self):
        read = marshal.Maker("<").reader(descriptors.ANY)
        for kind in (13, 25):  # Principal, long double
            with self.assertRaises(Fault):
                read(struct.pack("<I", kind) + bytes(32), 0)
        for data in (struct.pack("<III", 18, 0, 0xffffffff) + b"x", struct.pack("<III", 18, 0, 3) + b"abc", struct.pack("<II", 18, 0)):
            with self.assertRaises((Fault, struct.error)):
                read(data, 0)
        with self.assertRaises(ior.BadReference):
            marshal.Maker("<").reader((descriptors.OBJECT, "", ""))(struct.pack("<II", 0, 1000), 0)
        nested = struct.pack("<I", descriptors.ANY) * 200 + struct.pack("<Ii", descriptors.LONG, 1)
        with self.assertRaises(Fault):
            read(nested, 0)
