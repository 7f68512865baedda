"""The tables of interfaces and types: they say what the .idl files say, with the ids and bytes of the wire,
and what omniORB is given is made of them.
"""

import glob
import os
import subprocess
import sys
import tempfile
import unittest

try:
    import omniORB
except ImportError:
    omniORB = None

from rtshell_lite.corba import stubs
from rtshell_lite.giop import descriptors, idl
from rtshell_lite.data import type_json
from rtshell_lite.data.idl import parser, standard

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
STUBS = os.path.join(ROOT, "rtshell_lite", "idl_stubs")
OWN = os.path.join(STUBS, "idl")
OMNIIDL = os.path.join(os.path.dirname(sys.executable), "omniidl")

# Who answers to another id than this does not speak to OpenRTM-aist.
IDS = """
SDOPackage NameValue                       IDL:org.omg/SDOPackage/NameValue:1.0
SDOPackage NVList                          IDL:org.omg/SDOPackage/NVList:1.0
SDOPackage SDO                             IDL:org.omg/SDOPackage/SDO:1.0
SDOPackage SDOService                      IDL:org.omg/SDOPackage/SDOService:1.0
SDOPackage Configuration                   IDL:org.omg/SDOPackage/Configuration:1.0
SDOPackage Organization                    IDL:org.omg/SDOPackage/Organization:1.0
SDOPackage NotAvailable                    IDL:org.omg/SDOPackage/NotAvailable:1.0
SDOPackage InternalError                   IDL:org.omg/SDOPackage/InternalError:1.0
RTC        ReturnCode_t                    IDL:omg.org/RTC/ReturnCode_t:1.0
RTC        LightweightRTObject             IDL:omg.org/RTC/LightweightRTObject:1.0
RTC        DataFlowComponent               IDL:omg.org/RTC/DataFlowComponent:1.0
RTC        ConnectorProfile                IDL:omg.org/RTC/ConnectorProfile:1.0
RTC        PortService                     IDL:omg.org/RTC/PortService:1.0
RTC        ExecutionContextService         IDL:omg.org/RTC/ExecutionContextService:1.0
RTC        RTObject                        IDL:omg.org/RTC/RTObject:1.0
RTC        FsmParticipant                  IDL:omg.org/RTC/FsmParticipant:1.0
OpenRTM    DataFlowComponent               IDL:openrtm.aist.go.jp/OpenRTM/DataFlowComponent:1.0
OpenRTM    FiniteStateMachineComponent     IDL:openrtm.aist.go.jp/OpenRTM/FiniteStateMachineComponent:1.0
OpenRTM    ExtTrigExecutionContextService  IDL:openrtm.aist.go.jp/OpenRTM/ExtTrigExecutionContextService:1.0
RTM        Manager                         IDL:RTM/Manager:1.0
RTM        ModuleProfile                   IDL:RTM/ModuleProfile:1.0
RTM        NVList                          IDL:RTM/NVList:1.0
OpenRTM    InPortCdr                       IDL:OpenRTM/InPortCdr:1.0
OpenRTM    OutPortCdr                      IDL:OpenRTM/OutPortCdr:1.0
OpenRTM    PortStatus                      IDL:OpenRTM/PortStatus:1.0
RTC        PortStatus                      IDL:omg.org/RTC/PortStatus:1.0
RTC        DataPushService                 IDL:omg.org/RTC/DataPushService:1.0
RTC        DataPullService                 IDL:omg.org/RTC/DataPullService:1.0
OpenRTM    ComponentObserver               IDL:OpenRTM/ComponentObserver:1.0
OpenRTM    StatusKind                      IDL:OpenRTM/StatusKind:1.0
OpenRTM    Logger                          IDL:OpenRTM/Logger:1.0
OpenRTM    LogRecord                       IDL:OpenRTM/LogRecord:1.0
RTC        ComponentObserver               IDL:omg.org/RTC/ComponentObserver:1.0
RTC        StatusKind                      IDL:omg.org/RTC/StatusKind:1.0
RTC        ExtendedFsmService              IDL:omg.org/RTC/ExtendedFsmService:1.0
RTC        FsmStructure                    IDL:omg.org/RTC/FsmStructure:1.0
RTC        Time                            IDL:RTC/Time:1.0
RTC        TimedWStringSeq                 IDL:RTC/TimedWStringSeq:1.0
RTC        TimedQuaternion                 IDL:RTC/TimedQuaternion:1.0
RTC        CameraImage                     IDL:RTC/CameraImage:1.0
RTC        Waypoint3D                      IDL:RTC/Waypoint3D:1.0
RTC        IntensityData                   IDL:RTC/IntensityData:1.0
Img        CameraImage                     IDL:Img/CameraImage:1.0
Img        NVList                          IDL:Img/NVList:1.0
Img        CameraCaptureService            IDL:Img/CameraCaptureService:1.0
"""

# Little endian bytes of values at 1 s 2 ns, taken from live components; ?? is a gap, which may hold anything.
STAMP = "01000000 02000000 "
BYTES = [
    ("TimedLong", 3, "03000000"),
    ("TimedShort", -3, "fdff"),
    ("TimedDouble", 1.5, "000000000000f83f"),
    ("TimedString", "abc", "04000000 61626300"),
    ("TimedString", "", "01000000 00"),
    ("TimedBoolean", True, "01"),
    ("TimedOctet", 7, "07"),
    ("TimedChar", "a", "61"),
    ("TimedDoubleSeq", [1.0, 2.0], "02000000 ???????? 000000000000f03f 0000000000000040"),
    ("TimedStringSeq", ["a", "bc"], "02000000 02000000 6100 ???? 03000000 626300"),
    ("TimedOctetSeq", b"\x01\x02", "02000000 0102"),
]


def masked(data, pattern):
    """The hexadecimal form of data with ?? wherever the pattern has it."""
    pairs = [pattern[i : i + 2] for i in range(0, len(pattern), 2)]
    found = ["%02x" % byte for byte in data]
    return "".join("??" if pair == "??" else byte for byte, pair in zip(found, pairs + found[len(pairs) :]))


plain = type_json.plain


class Tables(unittest.TestCase):
    """Tables edited by hand, or .idl edited without generating them again."""

    @unittest.skipUnless(os.path.exists(OMNIIDL), "needs omniidl")
    def test_committed_tables_are_what_omniidl_reads(self):
        with tempfile.TemporaryDirectory() as directory:
            fresh = os.path.join(directory, "tables.py")
            subprocess.check_call(
                [sys.executable, "-m", "tools.stubs", fresh],
                cwd=ROOT,
                env=dict(os.environ, PYTHONPATH=ROOT),
            )
            with open(fresh) as new, open(os.path.join(STUBS, "tables.py")) as old:
                self.assertTrue(new.read() == old.read(), "run python3 -m tools.stubs")

    def files(self):
        return sorted(glob.glob(os.path.join(glob.escape(OWN), "*", "*.idl")))

    def test_types_are_what_our_parser_reads(self):
        compared = set()
        for path in self.files():
            for type_id, descriptor in parser.parse_file(path, [OWN]).items():
                compared.add(type_id)
                self.assertEqual(plain(idl.known(type_id)), plain(descriptor), type_id)
        self.assertEqual(
            {type_id for type_id, row in idl.TYPES.items() if row[0] != descriptors.EXCEPTION} - compared,
            set(),
        )

    def test_interfaces_are_what_our_parser_reads(self):
        for path in self.files():
            for type_id, expected in parser.read_file(path, [OWN]).interfaces.items():
                found = standard.interface(type_id)
                with self.subTest(interface=type_id):
                    self.assertEqual(
                        [each.idl() for each in found.operations],
                        [each.idl() for each in expected.operations],
                    )
                    self.assertEqual(
                        [each.name for each in found.ancestry()], [each.name for each in expected.ancestry()]
                    )
                    for one, other in zip(found.operations, expected.operations):
                        self.same_schema(one.schema(), other.schema())

    def same_schema(self, one, other):
        self.assertEqual(list(map(plain, one.given)), list(map(plain, other.given)))
        self.assertEqual(
            one.returned and list(map(plain, one.returned)),
            other.returned and list(map(plain, other.returned)),
        )
        self.assertEqual(set(one.raised), set(other.raised))

    def test_an_include_declares_what_the_file_does(self):
        """Types, exceptions, interfaces, items of enums, by their names, with what they include."""
        for path in self.files():
            with tempfile.TemporaryDirectory() as directory, self.subTest(path=path):
                case = os.path.join(directory, "case.idl")
                with open(case, "w") as file:
                    file.write('#include "%s"\n' % os.path.basename(path))
                found = parser.read_file(case)
                expected = parser.read_file(path, [OWN])
                self.assertEqual(
                    {type_id: plain(each) for type_id, each in found.types.items()},
                    {type_id: plain(each) for type_id, each in expected.types.items()},
                )
                self.assertEqual(set(found.interfaces), set(expected.interfaces))

    def test_included_declarations_can_be_used(self):
        with tempfile.TemporaryDirectory() as directory:
            case = os.path.join(directory, "case.idl")
            with open(case, "w") as file:
                file.write("""
                    #include <rtm/idl/RTC.idl>
                    #include "CosNaming.idl"
                    #include "RTC.idl"
                    module RTC { interface PortService; struct PortProfile;
                      struct More { ReturnCode_t code; SDOPackage::NVList list; }; };
                    module Mine {
                      interface Port : RTC::PortService {
                        RTC::PortProfile mine(in RTC::PortServiceList ports)
                          raises (CosNaming::NamingContext::NotFound);
                      };
                    };""")
            found = parser.read_file(case)
            port = found.interfaces["IDL:Mine/Port:1.0"]
            self.assertIn("get_port_profile", port.all_operations())
            self.assertEqual(
                list(port.operations[0].schema().raised), ["IDL:omg.org/CosNaming/NamingContext/NotFound:1.0"]
            )
            self.assertEqual(
                plain(found.types["IDL:RTC/More:1.0"])[3][0][1],
                plain(idl.known(idl.id_of("RTC.ReturnCode_t"))),
            )

    def test_repository_ids(self):
        for module, name, expected in map(str.split, IDS.strip().splitlines()):
            self.assertEqual(idl.id_of(module + "." + name), expected)

    def test_no_two_have_one_name(self):
        names = [
            type_id.split(":")[1].split("/")[-2:]
            for table in (idl.TYPES, idl.INTERFACES)
            for type_id in table
        ]
        self.assertEqual(len(set(map(tuple, names))), len(names))

    def test_observer_kinds_differ_from_number_five_on(self):
        kinds = [
            {str(item): item._v for item in idl.items(module + ".StatusKind")}
            for module in ("OpenRTM", "RTC")
        ]
        self.assertEqual(
            [kinds[0][name] for name in ("RTC_STATUS", "HEARTBEAT", "STATUS_KIND_NUM")], [1, 5, 6]
        )
        self.assertEqual(
            [kinds[1][name] for name in ("RTC_STATUS", "EC_HEARTBEAT", "STATUS_KIND_NUM")], [1, 6, 11]
        )


@unittest.skipUnless(omniORB, "omniORBpy is not installed")
class OmniOrb(unittest.TestCase):
    """What omniORB makes of them."""

    @classmethod
    def setUpClass(cls):
        from omniORB import CORBA

        CORBA.ORB_init([])

    def test_bytes(self):
        from mock_components.idl import RTC

        for name, value, data in BYTES:
            with self.subTest(type=name, value=value):
                self.check(name, getattr(RTC, name)(RTC.Time(1, 2), value), data)
        pose = RTC.Pose2D(RTC.Point2D(1.0, 2.0), 3.0)
        self.check(
            "TimedPose2D",
            RTC.TimedPose2D(RTC.Time(1, 2), pose),
            "000000000000f03f 0000000000000040 0000000000000840",
        )

    def check(self, name, value, data):
        from mock_components.idl import RTC

        pattern = (STAMP + data).replace(" ", "")
        marshalled = omniORB.cdrMarshal(getattr(RTC, "_tc_" + name), value, True)
        self.assertEqual(masked(marshalled, pattern), pattern)
        back = omniORB.cdrUnmarshal(getattr(RTC, "_tc_" + name), marshalled, True)
        self.assertEqual(repr(back), repr(value))

    def test_skeletons_inherit_as_their_interfaces_do(self):
        """omniORB knows by that which interfaces a servant has."""
        component = stubs.skeleton("OpenRTM.DataFlowComponent")
        for type_id in (
            "IDL:openrtm.aist.go.jp/OpenRTM/DataFlowComponent:1.0",
            "IDL:omg.org/RTC/RTObject:1.0",
            "IDL:omg.org/RTC/ComponentAction:1.0",
            "IDL:org.omg/SDOPackage/SDO:1.0",
        ):
            self.assertTrue(omniORB.static_is_a(component, type_id), type_id)
        self.assertFalse(omniORB.static_is_a(component, "IDL:omg.org/RTC/PortService:1.0"))
        self.assertLessEqual({"on_execute", "exit", "get_ports", "get_sdo_id"}, set(component._omni_op_d))
        self.assertIs(component, stubs.skeleton("OpenRTM.DataFlowComponent"))

    def test_exceptions(self):
        """A servant raises them, a caller catches them by their CORBA base."""
        from omniORB import CORBA

        _, _, raised = stubs.operation(idl.id_of("SDOPackage.Configuration"), "get_configuration_sets")
        made = raised[idl.id_of("SDOPackage.NotAvailable")][1]("why")
        self.assertIsInstance(made, CORBA.UserException)
        self.assertEqual((made.description, type(made).__name__), ("why", "NotAvailable"))


if __name__ == "__main__":
    unittest.main()
