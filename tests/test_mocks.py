"""The mock components: whether they answer, call by call, what real components of each implementation answer.

If this fails, the transcripts prove nothing. The tables are those measured on OpenRTM-aist C++ 1.1, 1.2, 2.1 and
Python 2.1; what was only read in the source of other implementations is not tested here.
"""
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
if ROOT not in sys.path:
    sys.path.insert(0, ROOT)

try:
    import omniORB
    from omniORB import CORBA, any as omniany
    import CosNaming
except ImportError:
    omniORB = None
else:
    from rtshell_lite.idl_stubs.component import OpenRTM, RTC, SDOPackage
    from rtshell_lite.idl_stubs.dataport import OpenRTM as Cdr

LIMIT = 10.0            # seconds that anything may take
LONG = "IDL:RTC/TimedLong:1.0"


def omninames():
    """The name server's program: that of the Python package, else one on PATH."""
    for name in ("jeteve_omniorb/bin/omniNames", "omniORB/bin/omniNames"):
        for directory in sys.path:
            if os.access(os.path.join(directory, name), os.X_OK):
                return os.path.join(directory, name)
    return shutil.which("omniNames")


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def eventually(condition, what):
    """Wait until a condition holds."""
    end = time.monotonic() + LIMIT
    while not condition():
        if time.monotonic() > end:
            raise AssertionError("not within %g s: %s" % (LIMIT, what))
        time.sleep(0.01)


def answers(port):
    try:
        socket.create_connection(("127.0.0.1", port), 1).close()
        return True
    except OSError:
        return False


class Server:
    """omniNames for the whole module, and this process's ORB."""

    @classmethod
    def start(cls):
        cls.directory = tempfile.mkdtemp()
        cls.port = free_port()
        cls.process = subprocess.Popen(
            [omninames(), "-start", str(cls.port), "-always", "-datadir", cls.directory,
             "-ORBendPoint", "giop:tcp:127.0.0.1:%d" % cls.port], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        eventually(lambda: answers(cls.port), "omniNames")
        cls.orb = CORBA.ORB_init(["test", "-ORBclientCallTimeOutPeriod", "8000", "-ORBtraceLevel", "0"], CORBA.ORB_ID)
        cls.root = cls.orb.string_to_object(
            "corbaloc:iiop:1.2@127.0.0.1:%d/NameService" % cls.port)._narrow(CosNaming.NamingContext)

    @classmethod
    def stop(cls):
        cls.process.kill()
        cls.process.wait()
        shutil.rmtree(cls.directory, ignore_errors=True)


def setUpModule():
    if omniORB is None or not omninames():
        raise unittest.SkipTest("needs omniORBpy and omniNames")
    Server.start()


def tearDownModule():
    Server.stop()


class World:
    """A world in a process of its own, and the objects bound by it."""

    def __init__(self, *words):
        self.control = os.path.join(Server.directory, "control%d" % free_port())
        self.process = subprocess.Popen(
            [sys.executable, "-m", "mock_components"] + list(words) +
            ["--nameserver", "127.0.0.1:%d" % Server.port, "--control", self.control],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, cwd=ROOT)
        self.ready = self.process.stdout.readline().decode()
        if not self.ready.startswith("ready"):
            self.close()
            raise AssertionError("the world did not start: " + " ".join(words))

    def close(self):
        self.process.kill()
        self.process.wait()
        self.process.stdin.close()
        self.process.stdout.close()

    def resolve(self, *names):
        parts = [CosNaming.NameComponent("test", "host_cxt")]
        for name in names:
            parts.append(CosNaming.NameComponent(*name.rsplit(".", 1)))
        return Server.root.resolve(parts)

    def component(self, name):
        return self.resolve(name + ".rtc")._narrow(OpenRTM.DataFlowComponent)

    def port(self, component, name):
        for port in self.component(component).get_ports():
            if port.get_port_profile().name.split(".")[-1] == name:
                return port
        raise AssertionError("no port " + name)

    def context(self, component):
        return self.component(component).get_owned_contexts()[0]

    def ctl(self, *words):
        done = subprocess.run([sys.executable, "-m", "mock_components", "ctl", self.control] + list(words), cwd=ROOT,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        return done.returncode, done.stdout.decode()

    def count(self, operation):
        lines = [line.split() for line in self.ctl("calls")[1].splitlines()]
        return {name: int(count) for count, name in lines}.get(operation, 0)


def nvlist(**changes):
    """Connector properties, written with _ for dots after `dataport`; None leaves one out."""
    values = {"dataflow_type": "push", "interface_type": "corba_cdr", "subscription_type": "flush", "data_type": LONG}
    values.update(changes)
    return [SDOPackage.NameValue("dataport." + name.replace("__", "."), omniany.to_any(value))
            for name, value in values.items() if value is not None]


def connector(ports, connector_id="", **changes):
    return RTC.ConnectorProfile("n", connector_id, ports, nvlist(**changes))


def names(profile):
    return [item.name for item in profile.properties]


def value(items, name):
    return next(item.value.value() for item in items if item.name == name)


def raised(function, *arguments):
    """The name of the exception that a call raises, or None."""
    try:
        function(*arguments)
    except (CORBA.UserException, CORBA.SystemException) as e:
        return e._NP_RepositoryId.split("/")[-1].split(":")[0]
    return None


def outcome(function, *arguments):
    """The name of what a call raises or, of its results, returns first."""
    results = []
    failure = raised(lambda: results.append(function(*arguments)))
    return failure or str(results[0][0] if isinstance(results[0], tuple) else results[0])


class Measured:
    """Tests shared by the implementations that were measured; each gives its own answers."""

    types = "these ConsoleIn ConsoleOut ConsoleOut:Other0 SequenceOutComponent ConfigSample MyServiceProvider MyServiceConsumer"

    @classmethod
    def setUpClass(cls):
        cls.world = World(*(cls.types.split() + ["--flavour", cls.flavour, "--rate", "100"]))
        cls.far = World("these", "ConsoleOut:Far0", "--flavour", cls.flavour)
        cls.out, cls.inp = cls.world.port("ConsoleIn0", "out"), cls.world.port("ConsoleOut0", "in")

    @classmethod
    def tearDownClass(cls):
        cls.world.close()
        cls.far.close()

    def tearDown(self):
        for port in (self.out, self.inp):
            for profile in port.get_connector_profiles():
                port.notify_disconnect(profile.connector_id)

    def connect(self, *arguments, **changes):
        """The code of one attempt; nothing stays connected."""
        ports = list(arguments) or [self.out, self.inp]
        code, profile = (ports[0] or self.out).connect(connector(ports, **changes))
        for port in filter(None, ports):
            port.notify_disconnect(profile.connector_id)
        return str(code)

    # life cycle

    def test_life_cycle(self):
        """Return codes of activate, deactivate and reset in every state."""
        component, context = self.world.component("ConsoleIn0"), self.world.context("ConsoleIn0")
        inactive, active, error = RTC.INACTIVE_STATE, RTC.ACTIVE_STATE, RTC.ERROR_STATE
        for state, operation, expected, after in (
                (inactive, "deactivate", "PRECONDITION_NOT_MET", inactive),
                (inactive, "reset", "PRECONDITION_NOT_MET", inactive), (inactive, "activate", "RTC_OK", active),
                (active, "activate", "PRECONDITION_NOT_MET", active), (active, "reset", "PRECONDITION_NOT_MET", active),
                (active, "deactivate", "RTC_OK", inactive), (inactive, "fail", None, error),
                (error, "activate", "PRECONDITION_NOT_MET", error), (error, "deactivate", "PRECONDITION_NOT_MET", error),
                (error, "reset", "RTC_OK", inactive)):
            with self.subTest(state=str(state), operation=operation):
                self.assertEqual(context.get_component_state(component), state)
                if operation == "fail":
                    self.assertEqual(self.world.ctl("error", "ConsoleIn0")[0], 0)
                else:
                    self.assertEqual(str(getattr(context, operation + "_component")(component)), expected)
                eventually(lambda: context.get_component_state(component) == after, "%s %s" % (operation, after))

    def test_strangers_in_a_context(self):
        """Components that are not in the context, and nil."""
        context, stranger = self.world.context("ConsoleIn0"), self.world.component("ConsoleOut0")
        self.assertEqual(str(context.activate_component(stranger)), "BAD_PARAMETER")
        self.assertEqual(str(context.get_component_state(stranger)), "CREATED_STATE")
        self.assertEqual(outcome(context.activate_component, None), self.nil_component)
        self.assertEqual(str(context.remove_component(stranger)), "BAD_PARAMETER")

    def test_start_stop_rate(self):
        component, context = self.world.component("ConsoleOut0"), self.world.context("ConsoleOut0")
        self.assertEqual(str(context.start()), "PRECONDITION_NOT_MET")
        self.assertEqual(str(context.stop()), "RTC_OK")
        self.assertEqual(str(context.stop()), "PRECONDITION_NOT_MET")
        self.assertEqual(str(context.activate_component(component)), self.activate_stopped[0])
        self.assertEqual(str(context.get_component_state(component)), self.activate_stopped[1])
        self.assertEqual(str(context.start()), "RTC_OK")
        eventually(lambda: context.get_component_state(component) == RTC.ACTIVE_STATE, "active after start")
        self.assertEqual(str(context.deactivate_component(component)), "RTC_OK")
        self.assertEqual([str(context.set_rate(rate)) for rate in (0, -1, 50)], ["BAD_PARAMETER", "BAD_PARAMETER", "RTC_OK"])
        self.assertEqual(context.get_rate(), 50)
        context.set_rate(100)

    def test_contexts_and_handles(self):
        component, context = self.world.component("ConsoleIn0"), self.world.context("ConsoleIn0")
        self.assertEqual(component.get_context_handle(context), 0)
        self.assertEqual(component.get_context_handle(self.world.context("ConsoleOut0")), -1)
        self.assertTrue(component.get_context(0)._is_equivalent(context))
        self.assertEqual([component.get_context(handle) for handle in (5, 99, 1000)], [None] * 3)
        self.assertTrue(component.is_alive(context))
        profile = context.get_profile()
        self.assertEqual((profile.kind, profile.rate, profile.participants), (RTC.PERIODIC, 100.0, []))
        self.assertTrue(profile.owner._is_equivalent(component))
        self.assertEqual(names(profile), self.context_properties)
        self.assertEqual(context._is_a(OpenRTM.ExtTrigExecutionContextService._NP_RepositoryId), self.ext_trig)
        self.assertEqual(str(component.finalize()), "PRECONDITION_NOT_MET")

    # profiles

    def test_component_profile(self):
        profile = self.world.component("ConsoleOut0").get_component_profile()
        self.assertEqual((profile.instance_name, profile.type_name, profile.vendor, profile.version, profile.category),
                         ("ConsoleOut0", "ConsoleOut") + self.author + ("example",))
        self.assertIsNone(profile.parent)
        self.assertEqual([port.name for port in profile.port_profiles], ["ConsoleOut0.in"])
        properties = {item.name: item.value.value() for item in profile.properties}
        self.assertEqual(properties["language"], self.language)
        self.assertEqual(properties["naming.names"], "test.host_cxt/ConsoleOut0.rtc")
        if self.property_count:
            self.assertEqual(len(profile.properties), self.property_count)

    def test_port_profiles(self):
        """All properties of both data ports, in order."""
        for port, expected in ((self.out, self.out_properties), (self.inp, self.in_properties)):
            profile = port.get_port_profile()
            found = ["%s=%s" % (item.name, item.value.value()) if item.value.typecode().kind() == CORBA.tk_string
                     else item.name for item in profile.properties]
            self.assertEqual(found, expected)
            self.assertTrue(profile.port_ref._is_equivalent(port))

    def test_sdo(self):
        component = self.world.component("ConsoleIn0")
        self.assertEqual(component.get_sdo_id(), "ConsoleIn0")
        self.assertEqual(component.get_sdo_type(), "Console input component")
        self.assertEqual((component.get_organizations(), component.get_owned_organizations(), component.get_status_list(),
                          component.get_service_profiles()), ([], [], [], []))
        self.assertEqual(raised(component.get_status, "x"), "InvalidParameter")
        self.assertEqual(raised(component.get_monitoring), "InterfaceNotImplemented")
        self.assertEqual(raised(component.get_service_profile, "x"), self.no_service_profile)
        self.assertEqual(raised(component.get_sdo_service, "x"), self.no_sdo_service)
        for type_id, expected in (("IDL:omg.org/RTC/DataFlowComponent:1.0", True), ("IDL:omg.org/RTC/RTObject:1.0", True),
                                  ("IDL:omg.org/RTC/FsmParticipant:1.0", False)):
            self.assertEqual(component._is_a(type_id), expected, type_id)

    # connecting

    def test_what_connect_adds(self):
        """Names of the properties that come back, in order."""
        asked = ["dataflow_type", "interface_type", "subscription_type", "data_type", "serializer.cdr.endian"]
        for ports, flow in (([self.out, self.inp], "push"), ([self.inp, self.out], "push"), ([self.out, self.inp], "pull")):
            code, profile = ports[0].connect(connector(ports, dataflow_type=flow))
            self.assertEqual(str(code), "RTC_OK")
            self.assertEqual([name.replace("dataport.", "") for name in names(profile)],
                             asked + self.added[ports[0] is self.inp, flow])
            self.assertEqual(value(profile.properties, "dataport.serializer.cdr.endian"), "little,big")
            self.assertEqual([p.connector_id for p in self.inp.get_connector_profiles()], [profile.connector_id])
            self.assertEqual(str(ports[0].disconnect(profile.connector_id)), "RTC_OK")
            self.assertEqual(self.inp.get_connector_profiles() + self.out.get_connector_profiles(), [])

    def test_connect_refuses(self):
        """Return codes for wrong input."""
        other = self.world.port("Other0", "in")
        outs = [self.out, self.world.port("SequenceOutComponent0", "Long")]
        ins = [self.inp, other]
        for what, ports, changes, expected in (
                ("unknown interface", (), {"interface_type": "bogus"}, "BAD_PARAMETER"),
                ("upper-case interface", (), {"interface_type": "CORBA_CDR"}, "BAD_PARAMETER"),
                ("two interfaces", (), {"interface_type": "corba_cdr,data_service"}, "BAD_PARAMETER"),
                ("no interface", (), {"interface_type": None}, "BAD_PARAMETER"),
                ("unknown data flow", (), {"dataflow_type": "bogus"}, "BAD_PARAMETER"),
                ("duplex", (), {"dataflow_type": "duplex"}, "BAD_PARAMETER"),
                ("no data flow", (), {"dataflow_type": None}, "BAD_PARAMETER"),
                ("capital", (), {"dataflow_type": "Push"}, "RTC_OK"),
                ("capital subscription", (), {"subscription_type": "New"}, "RTC_OK"),
                ("no subscription", (), {"subscription_type": None}, "RTC_OK"),
                ("periodic", (), {"subscription_type": "periodic"}, self.periodic),
                ("periodic with rate", (), {"subscription_type": "periodic", "publisher__push_rate": "10"}, "RTC_OK"),
                ("unknown endian", (), {"serializer__cdr__endian": "middle"}, self.endian),
                ("big endian", (), {"serializer__cdr__endian": "big"}, "RTC_OK"),
                ("wrong type", (), {"data_type": "IDL:RTC/TimedFloat:1.0"}, "RTC_OK"),
                ("no type", (), {"data_type": None}, "RTC_OK"),
                ("two InPorts, push", ins, {}, "RTC_OK"),
                ("two InPorts, pull", ins, {"dataflow_type": "pull"}, "BAD_PARAMETER"),
                ("two OutPorts, push", outs, {}, "BAD_PARAMETER"),
                ("two OutPorts, pull", outs, {"dataflow_type": "pull"}, "RTC_OK"),
                ("OutPort alone", [self.out], {}, "BAD_PARAMETER"), ("InPort alone", [self.inp], {}, "RTC_OK"),
                ("OutPort alone, pull", [self.out], {"dataflow_type": "pull"}, "RTC_OK"),
                ("nil", [self.out, None], {}, "BAD_PARAMETER"),
                ("direct, far", [self.out, self.far.port("Far0", "in")], {"interface_type": "direct"}, self.direct),
                ("unknown subscription", (), {"subscription_type": "bogus"}, "RTC_ERROR"),
                ("unknown marshaling", (), {"marshaling_type": "bogus"}, self.marshaling)):
            with self.subTest(what):
                self.assertEqual(self.connect(*ports, **changes), expected)
        self.assertEqual(str(self.out.connect(RTC.ConnectorProfile("n", "", [], nvlist()))[0]), "BAD_PARAMETER")
        self.assertEqual(str(self.out.connect(RTC.ConnectorProfile("n", "", [self.out, self.inp], []))[0]), "BAD_PARAMETER")

    def test_doubles(self):
        ports = [self.out, self.inp]
        self.assertEqual(str(self.out.connect(connector(ports, "first"))[0]), "RTC_OK")
        self.assertEqual(str(self.out.connect(connector(ports, "first"))[0]), "PRECONDITION_NOT_MET")
        self.assertEqual(str(self.out.connect(connector(ports, "second"))[0]), self.double)
        self.assertEqual(str(self.out.connect(connector(ports, "third", allow_dup_connection="YES"))[0]), "RTC_OK")
        self.assertIn("third", [p.connector_id for p in self.inp.get_connector_profiles()])
        self.assertEqual(self.out.get_connector_profile("nosuch").connector_id, "")
        self.assertEqual(str(self.out.disconnect("nosuch")), "BAD_PARAMETER")
        self.assertEqual(str(self.inp.disconnect("first")), "RTC_OK")
        self.assertEqual([str(self.out.disconnect_all()) for _ in range(2)], ["RTC_OK"] * 2)
        self.assertEqual(self.inp.get_connector_profiles(), [])

    def test_half_connections(self):
        """Python's InPort keeps a connection that its OutPort has refused."""
        code, profile = self.out.connect(connector([self.out, self.inp], "half", subscription_type="bogus"))
        self.assertEqual((str(code), self.out.get_connector_profiles()), ("RTC_ERROR", []))
        self.assertEqual([p.connector_id for p in self.inp.get_connector_profiles()], self.half)

    # data

    def test_push_to_the_in_port(self):
        """A connector of one InPort gives us an object whose put() takes bare CDR; it goes with the connection."""
        code, profile = self.inp.connect(connector([self.inp]))
        self.assertEqual(str(code), "RTC_OK")
        sink = Server.orb.string_to_object(value(profile.properties, "dataport.corba_cdr.inport_ior"))
        sink = sink._narrow(Cdr.InPortCdr)
        data = bytes.fromhex("0100000002000000") + (12345).to_bytes(4, "little")
        self.assertEqual(sink.put(data), Cdr.PORT_OK)
        self.assertEqual(self.world.ctl("received", "ConsoleOut0:in", "1")[1].split()[-1], "12345")
        self.assertEqual(outcome(sink.put, b"\1"), self.short_put)
        self.inp.disconnect(profile.connector_id)
        self.assertEqual(outcome(sink.put, data), "OBJECT_NOT_EXIST")

    def test_pull_from_the_out_port(self):
        """What get() answers before, with and after data."""
        for policy, before, after in ((None, self.empty, self.readback), ("do_nothing", self.empty, self.empty)):
            changes = {"dataflow_type": "pull", "buffer__read__empty_policy": policy}
            code, profile = self.out.connect(connector([self.out], **changes))
            source = Server.orb.string_to_object(value(profile.properties, "dataport.corba_cdr.outport_ior"))
            source = source._narrow(Cdr.OutPortCdr)
            self.assertEqual(outcome(source.get), before)
            self.world.ctl("write", "ConsoleIn0:out", "7")
            status, data = source.get()
            self.assertEqual((status, data[8:]), (Cdr.PORT_OK, b"\7\0\0\0"))
            self.assertEqual(outcome(source.get), after)
            self.out.disconnect(profile.connector_id)

    def test_data_flows(self):
        """From a counting component to a reading one, by push of each kind and by pull, in both byte orders."""
        component, context = self.world.component("ConsoleIn0"), self.world.context("ConsoleIn0")
        reader, reading = self.world.component("ConsoleOut0"), self.world.context("ConsoleOut0")
        for comp, cxt in ((component, context), (reader, reading)):
            cxt.activate_component(comp)
            eventually(lambda: cxt.get_component_state(comp) == RTC.ACTIVE_STATE, "active")
        for changes in ({}, {"subscription_type": "new"}, {"serializer__cdr__endian": "big"}, {"dataflow_type": "pull"},
                        {"subscription_type": "periodic", "publisher__push_rate": "50"}):
            before = int(self.world.ctl("received", "ConsoleOut0:in")[1].split()[0])
            code, profile = self.out.connect(connector([self.out, self.inp], **changes))
            self.assertEqual(str(code), "RTC_OK")
            self.assertEqual(self.world.ctl("received", "ConsoleOut0:in", str(before + 3))[0], 0, changes)
            self.out.disconnect(profile.connector_id)
        context.deactivate_component(component)
        reading.deactivate_component(reader)

    # configuration

    def test_configuration(self):
        world = World("config", "--flavour", self.flavour)
        self.addCleanup(world.close)
        config = world.component("ConfigSample0").get_configuration()
        self.assertEqual([s.id for s in config.get_configuration_sets()],
                         ["default", "mode0", "mode1", "__widget__", "__constraints__"])
        self.assertEqual(config.get_active_configuration_set().id, "mode1")
        for function, argument, expected in (
                (config.get_configuration_set, "nosuch", "InternalError"), (config.get_configuration_set, "", self.empty_id),
                (config.activate_configuration_set, "nosuch", self.bad_activate),
                (config.activate_configuration_set, "__widget__", self.bad_activate),
                (config.activate_configuration_set, "", "InvalidParameter")):
            self.assertEqual(raised(function, argument), expected, argument)
        self.assertEqual((config.get_configuration_parameters(), config.get_configuration_parameter_values()), ([], []))
        self.assertEqual(config.get_active_configuration_set().id, "mode1", "asking changed something")

        new = SDOPackage.ConfigurationSet("mode0", "", [SDOPackage.NameValue("int_param0", omniany.to_any("1")),
                                                        SDOPackage.NameValue("int_param1", omniany.to_any(5))])
        self.assertTrue(config.set_configuration_set_values(new))
        self.assertEqual(raised(config.get_active_configuration_set), "NotAvailable")
        mode0 = config.get_configuration_set("mode0").configuration_data
        self.assertEqual((value(mode0, "int_param0"), value(mode0, "int_param1"), value(mode0, "str_param0")),
                         ("1", self.number, "mode0"))
        self.assertTrue(config.activate_configuration_set("mode1"))
        unknown = SDOPackage.ConfigurationSet("unknown", "", [])
        self.assertEqual(config.set_configuration_set_values(unknown), self.set_creates)
        added = SDOPackage.ConfigurationSet("added", "", [])
        self.assertEqual([config.add_configuration_set(added) for _ in range(2)], [True, False])
        config.activate_configuration_set("added")
        self.assertEqual([config.remove_configuration_set(s) for s in ("default", "added", "nosuch", "mode0")], [False] * 4)
        config.activate_configuration_set("default")
        self.assertTrue(config.remove_configuration_set("added"))

    # services

    def test_services(self):
        """The keys under which a provider publishes its object; calls reach it when it exists."""
        component, context = self.world.component("MyServiceProvider0"), self.world.context("MyServiceProvider0")
        provider = self.world.port("MyServiceProvider0", "MyService")
        consumer = self.world.port("MyServiceConsumer0", "MyService")
        instance, type_name = self.service
        entry, = provider.get_port_profile().interfaces
        self.assertEqual((entry.instance_name, entry.type_name, entry.polarity), self.service + (RTC.PROVIDED,))
        self.assertEqual(consumer.get_port_profile().interfaces[0].polarity, RTC.REQUIRED)
        code, profile = provider.connect(RTC.ConnectorProfile("s", "", [provider, consumer], []))
        self.assertEqual(str(code), "RTC_OK")
        self.assertEqual(names(profile), ["MyServiceProvider0.port.MyService.provided.%s.%s" % (type_name, instance),
                                          "port.%s.%s" % (type_name, instance)])
        service = Server.orb.string_to_object(profile.properties[0].value.value())
        self.assertEqual(service._non_existent(), self.service_sleeps)
        context.activate_component(component)
        eventually(lambda: not service._non_existent(), "the service")
        self.assertTrue(service._is_a("IDL:SimpleService/MyService:1.0"))
        strict = [SDOPackage.NameValue("port.connection.strictness", omniany.to_any("strict"))]
        provider.disconnect_all()
        context.deactivate_component(component)
        self.assertEqual(str(consumer.connect(RTC.ConnectorProfile("s", "", [consumer], []))[0]), "RTC_OK")
        consumer.disconnect_all()
        self.assertEqual(str(consumer.connect(RTC.ConnectorProfile("s", "", [consumer], strict))[0]), "RTC_ERROR")

    # peers that die

    def test_dead_peer(self):
        """The first question to a component whose peer was killed."""
        world = World("orphan", "--flavour", self.flavour)
        self.addCleanup(world.close)
        port, = world.component("Orphan0").get_ports()
        self.assertEqual(raised(port.get_port_profile), self.dead_port)
        self.assertEqual(port.get_port_profile().connector_profiles, [])
        self.assertEqual(raised(world.component("Orphan0").get_component_profile), None)
        world = World("orphan", "--flavour", self.flavour)
        self.addCleanup(world.close)
        self.assertEqual(raised(world.component("Orphan0").get_component_profile), self.dead_component)
        if self.dead_component == "COMM_FAILURE":
            self.assertNotEqual(world.process.wait(LIMIT), 0)


OUT = ["port.port_type=DataOutPort", "dataport.data_type=" + LONG]
IN = ["port.port_type=DataInPort", "dataport.data_type=" + LONG, "dataport.subscription_type=Any"]
MODES = "block,flush,new,nonblock,periodic"


def modern(start, flows, interfaces):
    """The rest of the properties of a 2.x port."""
    return (start + ["dataport.marshaling_types=cdr", "dataport.dataflow_type=" + flows,
                     "dataport.interface_type=" + interfaces] +
            ["dataport.interface_option.%s=" % name for name in interfaces.split(",")] + ["data_type=" + LONG])


def plain(start, interfaces):
    """Those of a 1.x port."""
    return start + ["dataport.dataflow_type=push,pull", "dataport.interface_type=" + interfaces]


class Cpp11(Measured, unittest.TestCase):
    flavour, language, author, property_count = "cpp11", "C++", ("Noriaki Ando, AIST", "1.0"), None
    nil_component, activate_stopped = "BAD_PARAMETER", ("RTC_OK", "INACTIVE_STATE")
    context_properties, ext_trig = ["type", "rate"], True
    out_properties = plain(OUT + ["dataport.subscription_type=flush,new,periodic"], "corba_cdr") + ["dataport.data_value"]
    in_properties = plain(IN, "corba_cdr")
    no_service_profile, no_sdo_service = "InternalError", "InternalError"
    added = {(False, "push"): ["corba_cdr.inport_ior", "corba_cdr.inport_ref"], (True, "push"): ["corba_cdr.inport_ior"],
             (False, "pull"): ["corba_cdr.outport_ior"]}
    periodic, endian, marshaling, direct, double, half = "RTC_ERROR", "UNSUPPORTED", "RTC_OK", "BAD_PARAMETER", "RTC_OK", []
    short_put, empty, readback = "MARSHAL", "BUFFER_EMPTY", "PORT_OK"
    empty_id, bad_activate, number, set_creates = "InternalError", "InvalidParameter", "98765", True
    service, service_sleeps = ("myservice0", "MyService"), True
    dead_port, dead_component = None, None


class Cpp12(Cpp11):
    flavour = "cpp12"
    activate_stopped = ("RTC_OK", "ACTIVE_STATE")
    ext_trig = False
    out_properties = plain(OUT + ["dataport.subscription_type=flush,new,periodic"], "corba_cdr,direct,shared_memory")
    in_properties = plain(IN, "corba_cdr,direct,shared_memory")
    no_service_profile, no_sdo_service = "InvalidParameter", "InvalidParameter"
    direct, double = "RTC_ERROR", "PRECONDITION_NOT_MET"


class Cpp2(Cpp12):
    flavour, author, property_count = "cpp2", ("AIST", "2.0.0"), 43
    activate_stopped = ("RTC_ERROR", "INACTIVE_STATE")
    context_properties = ["sync_transition", "transition_timeout", "type", "rate", "name"]
    out_properties = modern(OUT + ["dataport.subscription_type=" + MODES, "dataport.io_mode=" + MODES], "push,pull",
                            "corba_cdr,data_service,direct,shared_memory")
    in_properties = modern(IN, "push,pull", "corba_cdr,data_service,direct,shared_memory")
    added = {(False, "push"): ["outport", "inport", "corba_cdr.inport_ior", "corba_cdr.inport_ref"],
             (True, "push"): ["inport", "corba_cdr.inport_ior", "outport", "corba_cdr.inport_ref"],
             (False, "pull"): ["outport", "corba_cdr.outport_ior", "inport", "corba_cdr.outport_ref"]}
    marshaling, short_put = "RTC_ERROR", "PORT_OK"
    service = ("myservice", "SimpleService::MyService")
    dead_port, dead_component = "TRANSIENT", "COMM_FAILURE"


class Py2(Measured, unittest.TestCase):
    flavour, language, author, property_count = "py2", "Python", ("Shinji Kurihara", "1.0"), 41
    nil_component, activate_stopped = "BAD_PARAM", ("RTC_OK", "ACTIVE_STATE")
    context_properties, ext_trig = ["sync_transition", "transition_timeout", "type", "rate"], False
    out_properties = modern(OUT + ["dataport.subscription_type=" + MODES, "dataport.io_mode=" + MODES], "push,pull,duplex",
                            "corba_cdr,csp_channel,data_service,direct,shared_memory")
    in_properties = modern(IN, "push,pull,duplex", "corba_cdr,csp_channel,data_service,direct,shared_memory")
    no_service_profile, no_sdo_service = "InternalError", "InvalidParameter"
    added = {(False, "push"): ["outport.data_type", "inport.data_type", "corba_cdr.inport_ior", "corba_cdr.inport_ref"],
             (True, "push"): ["inport.data_type", "corba_cdr.inport_ior", "corba_cdr.inport_ref", "outport.data_type"],
             (False, "pull"): ["outport.data_type", "corba_cdr.outport_ior", "corba_cdr.outport_ref", "inport.data_type"]}
    periodic, endian, marshaling, direct = "RTC_OK", "RTC_ERROR", "RTC_ERROR", "RTC_ERROR"
    double, half = "PRECONDITION_NOT_MET", ["half"]
    short_put, empty, readback = "PORT_OK", "BAD_PARAM", "BAD_PARAM"
    empty_id, bad_activate, number, set_creates = "UNKNOWN", "InternalError", "5", False
    service, service_sleeps = ("myservice0", "MyService"), False
    dead_port, dead_component = "TRANSIENT", "TRANSIENT"


class Worlds(unittest.TestCase):
    """What worlds are for: time, faults, counting, names."""

    def world(self, *words):
        world = World(*words)
        self.addCleanup(world.close)
        return world

    def test_slow_transitions(self):
        """RTC_ERROR after half a second, and the change later; a context of 1 Hz takes up to a second."""
        world = self.world("slow")
        component, context = world.component("Slow0"), world.context("Slow0")
        start = time.monotonic()
        self.assertEqual(str(context.activate_component(component)), "RTC_ERROR")
        self.assertTrue(0.45 < time.monotonic() - start < 0.75)
        self.assertEqual(context.get_component_state(component), RTC.INACTIVE_STATE)
        eventually(lambda: context.get_component_state(component) == RTC.ACTIVE_STATE, "active in the end")
        component, context = world.component("Lazy0"), world.context("Lazy0")
        start = time.monotonic()
        self.assertEqual(str(context.activate_component(component)), "RTC_OK")
        self.assertTrue(time.monotonic() - start < 1.2)

    def test_errors(self):
        world = self.world("error")
        component, context = world.component("Err0"), world.context("Err0")
        self.assertEqual(str(context.activate_component(component)), "RTC_OK")
        eventually(lambda: context.get_component_state(component) == RTC.ERROR_STATE, "error")
        component, context = world.component("ErrStart0"), world.context("ErrStart0")
        self.assertEqual(str(context.activate_component(component)), "PRECONDITION_NOT_MET")
        self.assertEqual(context.get_component_state(component), RTC.ERROR_STATE)

    def test_participating(self):
        """A context of another component has handle 1000, and leaves again."""
        world = self.world("contexts")
        multi, driver = world.component("Multi0"), world.context("Driver0")
        self.assertEqual(len(multi.get_owned_contexts()), 2)
        self.assertEqual(multi.get_context_handle(driver), 1000)
        self.assertTrue(multi.get_context(1000)._is_equivalent(driver))
        self.assertTrue(driver.get_profile().participants[0]._is_equivalent(multi))
        self.assertEqual(str(driver.activate_component(multi)), "RTC_OK")
        self.assertEqual(multi.get_owned_contexts()[0].get_component_state(multi), RTC.INACTIVE_STATE)
        self.assertEqual(str(driver.remove_component(multi)), "RTC_OK")
        eventually(lambda: not multi.get_participating_contexts(), "left")

    def test_exit(self):
        """The object is gone at once, its name a little later."""
        world = self.world("linked")
        component, port = world.component("ConsoleIn0"), world.port("ConsoleIn0", "out")
        self.assertEqual(str(component.exit()), "RTC_OK")
        self.assertTrue(component._non_existent() and port._non_existent())
        self.assertEqual(outcome(component.exit), "OBJECT_NOT_EXIST")
        world.resolve("ConsoleIn0.rtc")
        self.assertEqual(world.port("ConsoleOut0", "in").get_connector_profiles(), [])
        eventually(lambda: raised(world.resolve, "ConsoleIn0.rtc") == "NotFound", "unbound")

    def test_counting(self):
        """Every call counts, `_non_existent` and `_is_a` too; what the world does by itself does not."""
        world = self.world("linked")
        component = world.component("ConsoleIn0")
        component._non_existent()
        component._is_a("IDL:x:1.0")
        component.get_component_profile()
        calls = world.ctl("calls")[1].split()
        self.assertEqual(calls, ["1", "_is_a", "1", "_non_existent", "1", "get_component_profile"])
        self.assertEqual(world.ctl("calls", "ConsoleOut0"), (0, ""))
        self.assertEqual(world.ctl("highwater"), (0, "1\n"))
        world.ctl("reset")
        self.assertEqual(world.ctl("calls"), (0, ""))

    def test_faults(self):
        world = self.world("two")
        component = world.component("ConsoleIn0")
        world.ctl("fail", "get_ports", "2", "COMM_FAILURE")
        self.assertEqual([raised(component.get_ports) for _ in range(3)], [None, "COMM_FAILURE", None])
        world.ctl("hang", "ConsoleIn0", "60")
        omniORB.setClientCallTimeout(component, 200)
        self.assertEqual(raised(component.get_ports), "TIMEOUT")
        self.assertIsNone(raised(world.component("ConsoleOut0").get_ports))
        world.ctl("hang", "ConsoleIn0", "0")
        self.assertIsNone(raised(component.get_ports))
        self.assertEqual(world.ctl("nonsense")[0], 1)
        self.assertEqual(world.ctl("fail", "get_ports", "1", "NOSUCH")[0], 1)

    def test_keys(self):
        """A component of 2.x answers under a key, but its contexts do not know that reference."""
        given = str(free_port())
        world = self.world("two", "--port", given)
        port = value(world.component("ConsoleIn0").get_component_profile().properties, "corba.endpoints").split(":")[1]
        self.assertEqual(port, given)
        by_key = Server.orb.string_to_object("corbaloc:iiop:1.2@127.0.0.1:%s/example.ConsoleIn0" % port)
        by_key = by_key._unchecked_narrow(OpenRTM.DataFlowComponent)
        context, = by_key.get_owned_contexts()
        self.assertEqual(str(context.activate_component(by_key)), "BAD_PARAMETER")
        self.assertEqual(context.get_component_state(by_key), RTC.CREATED_STATE)

    def test_hung_and_zombies(self):
        hung = self.world("hung", "2")
        component = hung.component("Mock1")
        omniORB.setClientCallTimeout(component, 200)
        self.assertEqual(raised(component.get_ports), "TIMEOUT")
        zombie = self.world("zombie", "2")
        zombie.process.wait(LIMIT)
        self.assertEqual(raised(zombie.resolve("Mock1.rtc")._non_existent), "TRANSIENT")

    def test_names(self):
        world = self.world("names")
        home = Server.root.resolve([CosNaming.NameComponent("test", "host_cxt")])
        self.assertTrue(world.resolve("loop.cxt")._is_equivalent(home))
        self.assertIsNone(world.resolve("Nil0.rtc"))
        self.assertTrue(world.resolve("Gone0.rtc")._non_existent())
        self.assertFalse(world.resolve("NotAComponent0.rtc")._is_a("IDL:omg.org/RTC/RTObject:1.0"))
        self.assertTrue(world.resolve("Twin0.rtc")._is_equivalent(world.resolve("Twin0again.rtc")))
        self.assertEqual(len(world.resolve("many.cxt").list(1000)[0]), 300)
        self.assertEqual(world.resolve("empty.cxt").list(1000)[0], [])
        world.resolve("a.cxt", "b.cxt", "c.cxt", "Deep0.rtc")

    def test_hostile(self):
        """A hostile component answers everything."""
        world = self.world("hostile")
        component = world.component("Hostile0")
        self.assertIn("\x1b", component.get_component_profile().type_name)
        for port in component.get_ports():
            port.get_port_profile()
        component.get_configuration().get_configuration_sets()

    def test_end(self):
        """Names go with an orderly end, by end of input, by SIGTERM and by ctl."""
        for end in (lambda w: w.process.stdin.close(), lambda w: w.process.send_signal(signal.SIGTERM),
                    lambda w: w.ctl("exit")):
            world = World("two")
            world.component("ConsoleIn0")
            end(world)
            self.assertEqual(world.process.wait(LIMIT), 0)
            world.close()
            self.assertEqual(raised(world.resolve, "ConsoleIn0.rtc"), "NotFound")

    def test_many_start_quickly(self):
        start = time.monotonic()
        self.assertEqual(self.world("many", "200").ready, "ready 200\n")
        self.assertLess(time.monotonic() - start, 5)

    def test_formats(self):
        """--context takes several formats; missing contexts are made."""
        world = self.world("two", "--context", "test.host_cxt/deep.area_cxt/%n.rtc, test.host_cxt/%t.rtc")
        self.assertTrue(world.resolve("deep.area_cxt", "ConsoleIn0.rtc")._is_equivalent(world.resolve("ConsoleIn.rtc")))


if __name__ == "__main__":
    unittest.main()
