"""The components that can be played: what their profiles say, and what they do while active."""
from . import arm, carrier, values
from .composite import Composite
from .fsm import StateMachine
from .idl import RTC
from .rtc import Component
from .sources import Source

SEQUENCE_TYPES = (
    "Octet",
    "Short",
    "Long",
    "Float",
    "Double",
    "OctetSeq",
    "ShortSeq",
    "LongSeq",
    "FloatSeq",
    "DoubleSeq",
)

CONFIG_SAMPLE = {
    "default": {"double_param0": "0.99", "double_param1": "-0.99", "int_param0": "0", "int_param1": "1",
                "str_param0": "default", "str_param1": "default set in conf file",
                "vector_param0": "0.0,0.1,0.2,0.3,0.4,0.5,0.6"},
    "mode0": {"double_param0": "3.141592653589793238462643383279",
              "double_param1": "2.718281828459045235360287471352", "int_param0": "12345",
              "int_param1": "98765", "str_param0": "mode0", "str_param1": "foo",
              "vector_param0": "0.0,0.1,0.2,0.3,0.4"},
    "mode1": {"double_param0": "297992458", "double_param1": "2.97992458e+8", "int_param0": "-999",
              "int_param1": "999", "str_param0": "mode1", "str_param1": "AIST",
              "vector_param0": "1,2,3,4,5,6,7,8,9"},
    "__widget__": {"double_param0": "slider.0.1", "double_param1": "text", "int_param0": "slider.10",
                   "int_param1": "spin", "str_param0": "radio", "str_param1": "text",
                   "vector_param0": "text"},
    "__constraints__": {"double_param0": "0<=x<=100", "double_param1": "", "int_param0": "0<=x<=150",
                        "int_param1": "0<=x<=1000", "str_param0": "(default,mode0,mode1,foo,bar,radio)",
                        "str_param1": "", "vector_param0": ""},
}
CONFIG_SAMPLE_CPP = {"__widget__": {"double_param0": "slider.10"},
                     "__constraints__": {"str_param0": "(default,mode0,mode1)"}}
MOTOR_ID = {"default": {"motor_id": "0"}, "__widget__": {"motor_id": "text"}, "__type__": {"motor_id": "int"}}
SCANNER = {
    "default": {"port_opts": "type=serial,device=/dev/ttyACM0,timeout=1", "start_angle": "-1.57",
                "end_angle": "1.57", "cluster_count": "1", "high_sens": "0"},
    "fast": {"port_opts": "type=serial,device=/dev/ttyACM0,timeout=1", "start_angle": "-0.5",
             "end_angle": "0.5", "cluster_count": "4", "high_sens": "0"},
    "__constraints__": {"cluster_count": "x >= 1", "high_sens": "(0,1)"},
}


class Sender(Component):
    """Counts, and sends the number, stamped with the time, on all OutPorts."""

    busy = reads = True

    def activated(self, handle):
        self.number = 0
        return RTC.RTC_OK

    def on_execute(self, handle):
        self.number += 1
        for port in self.ports:
            if port.port_type == "DataOutPort":
                port.write(values.make(port.type_name, self.number, self.spec.stamps))
        self.read_ports(handle)
        return RTC.RTC_OK


class Reader(Component):
    """Fetches on all InPorts."""

    busy = reads = True

    def on_execute(self, handle):
        self.read_ports(handle)
        return RTC.RTC_OK


class Failing(Component):
    """Goes to the Error state in its first cycle."""

    busy = True

    def on_execute(self, handle):
        return RTC.RTC_ERROR


class Unwilling(Component):
    """Goes to the Error state instead of becoming active."""

    def activated(self, handle):
        return RTC.RTC_ERROR


class Unborn(Component):
    """Fails in its own initialisation: managers answer nil."""

    initialises = False


class Slow(Component):
    """Changes its state later than callers wait."""

    takes = 0.8

    def activated(self, handle):
        carrier.sleep(self.takes)
        return RTC.RTC_OK

    deactivated = reset = activated


class Stuck(Component):
    """Never comes back from a change of state."""

    takes = 3600.0

    def activated(self, handle):
        carrier.sleep(self.takes)
        return RTC.RTC_OK

    deactivated = reset = activated


class Spec:
    """What distinguishes one type of component from another;
    vendor and version, if not given, go with the flavour.
    """

    def __init__(
        self,
        type_name,
        description,
        ports=(),
        sets=None,
        sets_cpp=None,
        active_set="default",
        play=Component,
        category="example",
        implementation_id=None,
        vendor=None,
        version=None,
        activity=None,
        stamps=False,
        config_file="",
        max_instance=10,
    ):
        self.type_name = type_name
        self.description = description
        self.port_list = ports
        self.set_list = sets or {}
        self.sets_cpp = sets_cpp or {}
        self.active_set = active_set
        self.play = play
        self.category = category
        self.implementation_id = implementation_id or type_name
        self.vendor = vendor
        self.version = version
        self.activity = activity
        self.stamps = stamps
        self.config_file = config_file
        self.max_instance = max_instance

    def author(self, flavour):
        """(vendor, version)"""
        vendor, version = flavour.author
        by_language = self.vendor.get(flavour.language) if isinstance(self.vendor, dict) else self.vendor
        return by_language or vendor, self.version or version

    def ports(self, flavour):
        """(kind, name, type name or interfaces) of each port."""
        ports = []
        for kind, name, what in self.port_list:
            ports.append(
                (kind, name, [(what,) + flavour.service] if what in ("provided", "required") else what)
            )
        return ports

    def sets(self, flavour):
        """Configuration sets; the examples of C++ differ in a few values."""
        changes = self.sets_cpp if flavour.language == "C++" else {}
        return {name: dict(values, **changes.get(name, {})) for name, values in self.set_list.items()}

    def identity(self, flavour):
        vendor, version = self.author(flavour)
        return {
            "implementation_id": self.implementation_id,
            "type_name": self.type_name,
            "description": self.description,
            "version": version,
            "vendor": vendor,
            "category": self.category,
        }

    def nature(self, flavour):
        """What profiles say after that, of components as of factories."""
        pairs = [
            ("activity_type", (self.activity or "PERIODIC") if flavour.kind else "DataFlowComponent"),
            ("max_instance", str(self.max_instance)),
            ("language", flavour.language),
            ("lang_type", flavour.lang_type),
        ]
        if flavour.kind and self.activity != "DataFlowComponent":
            pairs.append(("kind", "DataFlowComponent"))
        return pairs


ARM = Spec(
    "Arm",
    "Has ports of a data type of its own",
    [("in", "command", arm.NAME), ("out", "status", arm.NAME)],
    play=Sender,
    category="test",
    stamps=True,
)
_PAIR = {"Python": "Shinji Kurihara, AIST"}

SPECS = {
    spec.type_name: spec
    for spec in (
        Spec("ConsoleIn", "Console input component", [("out", "out", "TimedLong")], play=Sender, stamps=True),
        Spec("ConsoleOut", "Console output component", [("in", "in", "TimedLong")], play=Reader),
        Spec(
            "SequenceOutComponent",
            "Sequence OutPort component",
            [("out", name, "Timed" + name) for name in SEQUENCE_TYPES],
            play=Sender,
            implementation_id="SeqOut",
        ),
        Spec(
            "SequenceInComponent",
            "Sequence InPort component",
            [("in", name, "Timed" + name) for name in SEQUENCE_TYPES],
            play=Reader,
            implementation_id="SeqIn",
        ),
        Spec(
            "ConfigSample",
            "Configuration example component",
            sets=CONFIG_SAMPLE,
            sets_cpp=CONFIG_SAMPLE_CPP,
            active_set="mode1",
            version="1.0",
            vendor={"C++": ("Noriaki Ando, AIST")},
            activity="DataFlowComponent",
            config_file="configsample.conf",
        ),
        Spec(
            "Motor",
            "Motor component",
            [("in", "in", "TimedFloat"), ("out", "out", "TimedLong")],
            sets=MOTOR_ID,
            play=Sender,
            vendor=_PAIR,
            activity="SPORADIC",
        ),
        Spec(
            "Sensor",
            "Sensor component",
            [("in", "in", "TimedLong"), ("out", "out", "TimedFloat")],
            play=Sender,
            vendor=_PAIR,
            activity="SPORADIC",
        ),
        Spec(
            "Controller",
            "Controller component",
            [("in", "in", "TimedFloat"), ("out", "out", "TimedFloat")],
            play=Sender,
            vendor=_PAIR,
            activity="SPORADIC",
        ),
        Spec(
            "MyServiceProvider", "MyService Provider Sample component", [("service", "MyService", "provided")]
        ),
        Spec(
            "MyServiceConsumer", "MyService Consumer Sample component", [("service", "MyService", "required")]
        ),
        Spec(
            "Hokuyo_AIST",
            "Laser scanner",
            [
                ("out", "ranges", "TimedLongSeq"),
                ("out", "errors", "TimedString"),
                ("service", "control", "provided"),
            ],
            sets=SCANNER,
            play=Sender,
            category="Sensor",
            vendor="Geoffrey Biggs, AIST",
            version="1.0",
            stamps=True,
        ),
        Spec(
            "Clusterer",
            "Groups the readings of a laser scanner",
            [("in", "ranges", "TimedLongSeq"), ("out", "clusters", "TimedDoubleSeq")],
            play=Sender,
            category="Perception",
            vendor="Geoffrey Biggs, AIST",
            version="2.1",
        ),
        Spec(
            "PeriodicECSharedComposite",
            "PeriodicECSharedComposite",
            sets={"default": {"members": (""), "exported_ports": ""}},
            play=Composite,
            category="composite.PeriodicECShared",
            vendor="jp.go.aist",
            version="1.0",
            activity="DataFlowComponent",
            max_instance=0,
        ),
        Spec(
            "Microwave",
            "A state machine",
            [("event", "event", "TimedLong")],
            play=StateMachine,
            version="1.0",
        ),
        Spec(
            "Source",
            "Sends fast or much",
            [("out", "number", "TimedLong"), ("out", "block", "TimedOctetSeq")],
            play=Source,
            category="test",
        ),
        Spec(
            "Robot",
            "Provides services of every kind",
            [
                (
                    "service",
                    "svc",
                    [("provided", "arm", "Mock::Robot"), ("provided", "tally", "Mock::Counter")],
                ),
                ("out", "out", "TimedLong"),
            ],
            category="test",
        ),
        Spec(
            "Mock", "Does nothing", [("in", "in", "TimedLong"), ("out", "out", "TimedLong")], category="test"
        ),
        Spec(
            "Err",
            "Goes to Error in its first cycle",
            [("out", "out", "TimedLong")],
            play=Failing,
            category="test",
        ),
        Spec("ErrStart", "Goes to Error instead of Active", play=Unwilling, category="test"),
        Spec("Unborn", "Fails in its own initialisation", play=Unborn, category="test"),
        Spec(
            "Slow", "Changes its state after 0.8 s", [("out", "out", "TimedLong")], play=Slow, category="test"
        ),
        Spec("Stuck", "Never completes a change of state", play=Stuck, category="test"),
    )
}
