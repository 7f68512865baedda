"""The CORBA stubs: they are what the .idl files say, carry the ids and bytes of the wire, and load only what is asked for."""
import importlib
import os
import subprocess
import sys
import tempfile
import unittest

try:
    import omniORB
except ImportError:
    omniORB = None

import rtshell_lite
from rtshell_lite.corba import stubs
from rtshell_lite.idl_stubs import generate

STUBS = os.path.dirname(os.path.abspath(generate.__file__))

# Who answers to another id than this does not speak to OpenRTM-aist.
IDS = """
component SDOPackage NameValue             IDL:org.omg/SDOPackage/NameValue:1.0
component SDOPackage NVList                IDL:org.omg/SDOPackage/NVList:1.0
component SDOPackage SDO                   IDL:org.omg/SDOPackage/SDO:1.0
component SDOPackage SDOService            IDL:org.omg/SDOPackage/SDOService:1.0
component SDOPackage Configuration         IDL:org.omg/SDOPackage/Configuration:1.0
component SDOPackage Organization          IDL:org.omg/SDOPackage/Organization:1.0
component SDOPackage NotAvailable          IDL:org.omg/SDOPackage/NotAvailable:1.0
component SDOPackage InternalError         IDL:org.omg/SDOPackage/InternalError:1.0
component RTC ReturnCode_t                 IDL:omg.org/RTC/ReturnCode_t:1.0
component RTC LightweightRTObject          IDL:omg.org/RTC/LightweightRTObject:1.0
component RTC DataFlowComponent            IDL:omg.org/RTC/DataFlowComponent:1.0
component RTC ConnectorProfile             IDL:omg.org/RTC/ConnectorProfile:1.0
component RTC PortService                  IDL:omg.org/RTC/PortService:1.0
component RTC ExecutionContextService      IDL:omg.org/RTC/ExecutionContextService:1.0
component RTC RTObject                     IDL:omg.org/RTC/RTObject:1.0
component RTC FsmParticipant               IDL:omg.org/RTC/FsmParticipant:1.0
component OpenRTM DataFlowComponent        IDL:openrtm.aist.go.jp/OpenRTM/DataFlowComponent:1.0
component OpenRTM FiniteStateMachineComponent IDL:openrtm.aist.go.jp/OpenRTM/FiniteStateMachineComponent:1.0
component OpenRTM ExtTrigExecutionContextService IDL:openrtm.aist.go.jp/OpenRTM/ExtTrigExecutionContextService:1.0
manager RTM Manager                        IDL:RTM/Manager:1.0
manager RTM ModuleProfile                  IDL:RTM/ModuleProfile:1.0
manager RTM NVList                         IDL:RTM/NVList:1.0
dataport OpenRTM InPortCdr                 IDL:OpenRTM/InPortCdr:1.0
dataport OpenRTM OutPortCdr                IDL:OpenRTM/OutPortCdr:1.0
dataport OpenRTM PortStatus                IDL:OpenRTM/PortStatus:1.0
dataport RTC PortStatus                    IDL:omg.org/RTC/PortStatus:1.0
dataport RTC DataPushService               IDL:omg.org/RTC/DataPushService:1.0
dataport RTC DataPullService               IDL:omg.org/RTC/DataPullService:1.0
observer OpenRTM ComponentObserver         IDL:OpenRTM/ComponentObserver:1.0
observer OpenRTM StatusKind                IDL:OpenRTM/StatusKind:1.0
observer OpenRTM Logger                    IDL:OpenRTM/Logger:1.0
observer OpenRTM LogRecord                 IDL:OpenRTM/LogRecord:1.0
observer RTC ComponentObserver             IDL:omg.org/RTC/ComponentObserver:1.0
observer RTC StatusKind                    IDL:omg.org/RTC/StatusKind:1.0
fsm RTC ExtendedFsmService                 IDL:omg.org/RTC/ExtendedFsmService:1.0
fsm RTC FsmStructure                       IDL:omg.org/RTC/FsmStructure:1.0
data RTC Time                              IDL:RTC/Time:1.0
data RTC TimedWStringSeq                   IDL:RTC/TimedWStringSeq:1.0
data RTC TimedQuaternion                   IDL:RTC/TimedQuaternion:1.0
data RTC CameraImage                       IDL:RTC/CameraImage:1.0
data RTC Waypoint3D                        IDL:RTC/Waypoint3D:1.0
data RTC IntensityData                     IDL:RTC/IntensityData:1.0
data Img CameraImage                       IDL:Img/CameraImage:1.0
data Img NVList                            IDL:Img/NVList:1.0
data Img CameraCaptureService              IDL:Img/CameraCaptureService:1.0
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
    pairs = [pattern[i:i + 2] for i in range(0, len(pattern), 2)]
    found = ["%02x" % byte for byte in data]
    return "".join("??" if pair == "??" else byte for byte, pair in zip(found, pairs + found[len(pairs):]))


def modules_after(statement):
    """The names in sys.modules of a fresh interpreter after a statement."""
    code = "import sys; sys.path[:0] = sys.argv[1:]; {}; print('\\n'.join(sys.modules))".format(statement)
    checkout = os.path.dirname(os.path.dirname(os.path.abspath(rtshell_lite.__file__)))
    return subprocess.check_output([sys.executable, "-c", code, checkout], universal_newlines=True).split()


class GeneratedTest(unittest.TestCase):
    """Stubs edited by hand, or .idl edited without regenerating."""

    def test_committed_stubs_are_what_omniidl_writes(self):
        try:
            generate.omniidl()
        except generate.NoOmniidl as error:
            self.skipTest(str(error))
        with tempfile.TemporaryDirectory() as directory:
            generate.generate(directory)
            fresh = python_files(directory)
            for name in sorted(fresh):
                with open(os.path.join(directory, name)) as new, open(os.path.join(STUBS, name)) as old:
                    self.assertTrue(new.read() == old.read(), name + " differs: run rtshell_lite.idl_stubs.generate")
        self.assertEqual(python_files(STUBS) - fresh, {"__init__.py", "generate.py", "tabulate.py"}, "stubs without an .idl file")

    def test_stubs_name_no_path_of_the_machine_that_made_them(self):
        for name in sorted(python_files(STUBS) - {"generate.py"}):
            with open(os.path.join(STUBS, name)) as stream:
                self.assertNotRegex(stream.read(), r"[\s\"']/\w", name)


def python_files(directory):
    return {os.path.relpath(os.path.join(where, name), directory)
            for where, _, names in os.walk(directory) for name in names if name.endswith(".py")}


@unittest.skipUnless(omniORB, "omniORBpy is not installed")
class WireTest(unittest.TestCase):
    """What real components see."""

    @classmethod
    def setUpClass(cls):
        from omniORB import CORBA
        CORBA.ORB_init([])

    def test_repository_ids(self):
        for package, module, name, expected in map(str.split, IDS.strip().splitlines()):
            with self.subTest(id=expected):
                stub = importlib.import_module("rtshell_lite.idl_stubs.{}.{}".format(package, module))
                found = getattr(stub, name)
                self.assertEqual(getattr(found, "_NP_RepositoryId", None) or found[1], expected)

    def test_bytes(self):
        from rtshell_lite.idl_stubs.data import RTC
        for name, value, data in BYTES:
            with self.subTest(type=name, value=value):
                self.check(name, getattr(RTC, name)(RTC.Time(1, 2), value), data)
        pose = RTC.Pose2D(RTC.Point2D(1.0, 2.0), 3.0)
        self.check("TimedPose2D", RTC.TimedPose2D(RTC.Time(1, 2), pose),
                   "000000000000f03f 0000000000000040 0000000000000840")

    def check(self, name, value, data):
        from rtshell_lite.idl_stubs.data import RTC
        pattern = (STAMP + data).replace(" ", "")
        marshalled = omniORB.cdrMarshal(getattr(RTC, "_tc_" + name), value, True)
        self.assertEqual(masked(marshalled, pattern), pattern)
        back = omniORB.cdrUnmarshal(getattr(RTC, "_tc_" + name), marshalled, True)
        self.assertEqual(repr(back), repr(value))

    def test_observer_kinds_differ_from_number_five_on(self):
        from rtshell_lite.idl_stubs.observer import RTC, OpenRTM
        self.assertEqual([kind._v for kind in (OpenRTM.RTC_STATUS, OpenRTM.HEARTBEAT, OpenRTM.STATUS_KIND_NUM)],
                         [1, 5, 6])
        self.assertEqual([kind._v for kind in (RTC.RTC_STATUS, RTC.EC_HEARTBEAT, RTC.STATUS_KIND_NUM)], [1, 6, 11])


@unittest.skipUnless(omniORB, "omniORBpy is not installed")
class ImportTest(unittest.TestCase):
    """Start-up time, and clashes with the stubs of OpenRTM-aist itself."""

    def test_component_loads_nothing_else(self):
        loaded = modules_after("from rtshell_lite.idl_stubs.component import SDOPackage, RTC, OpenRTM")
        prefix = "rtshell_lite.idl_stubs."
        ours = [name[len(prefix):] for name in loaded if name.startswith(prefix)]
        self.assertEqual([name for name in ours if name.split(".")[0] != "component"], [])

    def test_no_top_level_module(self):
        for package, modules in [("component", "SDOPackage, RTC, OpenRTM"), ("manager", "RTM"), ("dataport", "OpenRTM, RTC"),
                                 ("observer", "OpenRTM, RTC"), ("fsm", "RTC"), ("data", "RTC, Img")]:
            with self.subTest(package=package):
                loaded = modules_after("from rtshell_lite.idl_stubs.{} import {}".format(package, modules))
                self.assertFalse({"SDOPackage", "RTC", "OpenRTM", "RTM", "Img"} & set(loaded))

    def test_skeletons_inherit_as_their_interfaces_do(self):
        """omniORB tells by that which interfaces a servant has."""
        component = stubs.skeleton("component.OpenRTM.DataFlowComponent")
        for type_id in ("IDL:openrtm.aist.go.jp/OpenRTM/DataFlowComponent:1.0", "IDL:omg.org/RTC/RTObject:1.0",
                        "IDL:omg.org/RTC/ComponentAction:1.0", "IDL:org.omg/SDOPackage/SDO:1.0"):
            self.assertTrue(omniORB.static_is_a(component, type_id), type_id)
        self.assertFalse(omniORB.static_is_a(component, "IDL:omg.org/RTC/PortService:1.0"))
        operations = component._omni_op_d
        self.assertLessEqual({"on_execute", "exit", "get_ports", "get_sdo_id"}, set(operations))
        self.assertIs(component, stubs.skeleton("component.OpenRTM.DataFlowComponent"))

    def test_observers_load_the_time_stamp_but_no_data_types(self):
        loaded = modules_after("from rtshell_lite.idl_stubs.observer import OpenRTM, RTC")
        self.assertIn("rtshell_lite.idl_stubs.data.Time_idl", loaded)
        self.assertNotIn("rtshell_lite.idl_stubs.data.BasicDataType_idl", loaded)


if __name__ == "__main__":
    unittest.main()
