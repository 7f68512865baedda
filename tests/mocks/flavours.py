"""The answers in which components of the four implementations differ, as measured.

`added` is what a connector gains, by whether the InPort comes first and by data flow; the rest speaks for
itself where it is used.
"""
import worlds

LONG = worlds.LONG
OUT = ["port.port_type=DataOutPort", "dataport.data_type=" + LONG]
IN = ["port.port_type=DataInPort", "dataport.data_type=" + LONG, "dataport.subscription_type=Any"]
MODES = "block,flush,new,nonblock,periodic"


def modern(start, flows, interfaces):
    """The rest of the properties of a 2.x port."""
    options = ["dataport.interface_option.%s=" % name for name in interfaces.split(",")]
    return start + ["dataport.marshaling_types=cdr", "dataport.dataflow_type=" + flows,
                    "dataport.interface_type=" + interfaces] + options + ["data_type=" + LONG]


def plain(start, interfaces):
    """Those of a 1.x port."""
    return start + ["dataport.dataflow_type=push,pull", "dataport.interface_type=" + interfaces]


class Cpp11:
    """OpenRTM-aist 1.1.2."""

    flavour = "cpp11"
    author = ("Noriaki Ando, AIST", "1.0")
    property_count = None
    language = ("C++", "compile", "1.1.2", "")
    endpoint = "corba.endpoint"
    uuid = 4
    waits = False
    nil_component = "BAD_PARAMETER"
    activate_stopped = ("RTC_OK", "INACTIVE_STATE")
    sleeps = False
    context_properties = ["type", "rate"]
    ext_trig = True
    out_properties = plain(OUT + ["dataport.subscription_type=flush,new,periodic"], "corba_cdr") + [
        "dataport.data_value"
    ]
    in_properties = plain(IN, "corba_cdr")
    no_service_profile = "InternalError"
    no_sdo_service = "InternalError"
    added = {
        (False, "push"): ["corba_cdr.inport_ior", "corba_cdr.inport_ref"],
        (True, "push"): ["corba_cdr.inport_ior"],
        (False, "pull"): ["corba_cdr.outport_ior"],
    }
    periodic = "RTC_ERROR"
    endian = "UNSUPPORTED"
    marshaling = "RTC_OK"
    direct = "BAD_PARAMETER"
    double = "RTC_OK"
    half = []
    short_put = "MARSHAL"
    empty = "BUFFER_EMPTY"
    readback = "PORT_OK"
    obeys_big = True
    empty_id = "InternalError"
    bad_activate = "InvalidParameter"
    number = "98765"
    set_creates = True
    no_set = "Unknown exception"
    cannot_activate = "Configuration::activate_configuration_set()"
    parameter = None
    service = ("myservice0", "MyService")
    service_sleeps = True
    dead_port = None
    dead_component = None


class Cpp12(Cpp11):
    """OpenRTM-aist 1.2.2."""

    flavour = "cpp12"
    language = ("C++", "compile", "1.2.2", "")
    endpoint = "corba.endpoints"
    waits = True
    activate_stopped = ("RTC_OK", "ACTIVE_STATE")
    ext_trig = False
    out_properties = plain(
        OUT + ["dataport.subscription_type=flush,new,periodic"], "corba_cdr,direct,shared_memory"
    )
    in_properties = plain(IN, "corba_cdr,direct,shared_memory")
    no_service_profile = "InvalidParameter"
    no_sdo_service = "InvalidParameter"
    direct = "RTC_ERROR"
    double = "PRECONDITION_NOT_MET"
    obeys_big = False


class Cpp2(Cpp12):
    """OpenRTM-aist 2.1."""

    flavour = "cpp2"
    author = ("AIST", "2.0.0")
    property_count = 43
    language = ("C++", "compile", "2.1.0", "")
    activate_stopped = ("RTC_ERROR", "INACTIVE_STATE")
    sleeps = True
    context_properties = ["sync_transition", "transition_timeout", "type", "rate", "name"]
    out_properties = modern(
        OUT + ["dataport.subscription_type=" + MODES, "dataport.io_mode=" + MODES],
        "push,pull",
        "corba_cdr,data_service,direct,shared_memory",
    )
    in_properties = modern(IN, "push,pull", "corba_cdr,data_service,direct,shared_memory")
    added = {(False, "push"): ["outport", "inport", "corba_cdr.inport_ior", "corba_cdr.inport_ref"],
             (True, "push"): ["inport", "corba_cdr.inport_ior", "outport", "corba_cdr.inport_ref"],
             (False, "pull"): ["outport", "corba_cdr.outport_ior", "inport", "corba_cdr.outport_ref"]}
    marshaling = "RTC_ERROR"
    short_put = "PORT_OK"
    service = ("myservice", "SimpleService::MyService")
    dead_port = "TRANSIENT"
    dead_component = "COMM_FAILURE"


class Py2(Cpp2):
    """OpenRTM-aist-Python 2.1: as C++ 2.1 where nothing else stands here."""

    flavour = "py2"
    author = ("Shinji Kurihara", "1.0")
    property_count = 41
    language = ("Python", "script", "2.1.0", "IDL:OpenRTM/ComponentObserver:1.0")
    uuid = 1
    nil_component = "BAD_PARAM"
    context_properties = ["sync_transition", "transition_timeout", "type", "rate"]
    out_properties = modern(
        OUT + ["dataport.subscription_type=" + MODES, "dataport.io_mode=" + MODES],
        "push,pull,duplex",
        "corba_cdr,csp_channel,data_service,direct,shared_memory",
    )
    in_properties = modern(IN, "push,pull,duplex", "corba_cdr,csp_channel,data_service,direct,shared_memory")
    no_service_profile = "InternalError"
    added = {
        (False, "push"): ["outport.data_type", "inport.data_type", "corba_cdr.inport_ior",
                          "corba_cdr.inport_ref"],
        (True, "push"): ["inport.data_type", "corba_cdr.inport_ior", "corba_cdr.inport_ref",
                         "outport.data_type"],
        (False, "pull"): ["outport.data_type", "corba_cdr.outport_ior", "corba_cdr.outport_ref",
                          "inport.data_type"],
    }
    periodic = "RTC_OK"
    endian = "RTC_ERROR"
    half = ["half"]
    empty = "BAD_PARAM"
    readback = "BAD_PARAM"
    obeys_big = True
    empty_id = "UNKNOWN"
    bad_activate = "InternalError"
    number = "5"
    set_creates = False
    no_set = "No such ConfigurationSet"
    cannot_activate = "Configuration.activate_configuration_set()"
    parameter = "BAD_PARAM"
    service = ("myservice0", "MyService")
    dead_component = "TRANSIENT"


class Flavoured:
    """For test cases: one world of the flavour, and an InPort in another process."""

    types = ("these ConsoleIn ConsoleOut ConsoleOut:Other0 SequenceOutComponent ConfigSample "
             "MyServiceProvider MyServiceConsumer")

    @classmethod
    def setUpClass(cls):
        cls.world = worlds.World(*(cls.types.split() + ["--flavour", cls.flavour, "--rate", "100"]))
        cls.far = worlds.World("these", "ConsoleOut:Far0", "--flavour", cls.flavour)
        cls.out = cls.world.port("ConsoleIn0", "out")
        cls.inp = cls.world.port("ConsoleOut0", "in")

    @classmethod
    def tearDownClass(cls):
        cls.world.close()
        cls.far.close()

    def tearDown(self):
        for port in (self.out, self.inp):
            for profile in port.get_connector_profiles():
                port.notify_disconnect(profile.connector_id)
