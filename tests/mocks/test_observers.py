"""What mock components report to observers, loggers and askers for their state machine; and senders.

If this fails, the transcripts of rtwatch, rtvlog and rtfsm prove nothing.
"""
import queue
import unittest

import processes
import worlds
from answers import outcome, raised, value
from worlds import connector, eventually

ONCE = "mocks are used by the transcripts on every Python"
try:
    import omniORB
    from rtshell_lite.corba import stubs
    from mock_components.idl import RTC, OpenRTM, SDOPackage
except ImportError:
    pass        # then setUpModule skips all
else:
    class Gathering:
        """Keeps what a component says."""

        def __init__(self):
            self.said = queue.Queue()

        def update_status(self, kind, hint):
            self.said.put((str(kind), hint))

        def next(self, count):
            """What was said, in any order: oneway calls may overtake each other."""
            return sorted(self.said.get(timeout=worlds.LIMIT) for _ in range(count))

    class Observer(Gathering, stubs.skeleton("OpenRTM.ComponentObserver")):
        type_id = "IDL:OpenRTM/ComponentObserver:1.0"

    class FsmObserver(Gathering, stubs.skeleton("RTC.ComponentObserver")):
        type_id = "IDL:omg.org/RTC/ComponentObserver:1.0"

    class Logger(Gathering, stubs.skeleton("OpenRTM.Logger")):
        type_id = "IDL:OpenRTM/Logger:1.0"

        def publish(self, record):
            self.said.put((record.loggername, str(record.level), record.message))

    class Receiver(Gathering, stubs.skeleton("OpenRTM.InPortCdr")):
        def put(self, data):
            self.said.put(data)
            return OpenRTM.PORT_OK

SERVICE = "IDL:omg.org/RTC/ExtendedFsmService:1.0"


def setUpModule():
    worlds.start_name_server()
    root = worlds.Server.orb.resolve_initial_references("RootPOA")
    root._get_the_POAManager().activate()


def tearDownModule():
    worlds.Server.stop()


def service(servant, service_id="me", **properties):
    pairs = [
        SDOPackage.NameValue(name.replace("__", "."), omniORB.any.to_any(text))
        for name, text in properties.items()
    ]
    return SDOPackage.ServiceProfile(service_id, servant.type_id, pairs, servant._this())


class Case(unittest.TestCase):
    def start(self, *words):
        self.world = worlds.World(*words)
        self.addCleanup(self.world.close)

    def observe(self, name, servant, **properties):
        self.configuration = self.world.component(name).get_configuration()
        self.assertIs(self.configuration.add_service_profile(service(servant, **properties)), True)
        return servant


class Observers(Case):
    def setUp(self):
        self.start("observed")

    def test_life_cycle(self):
        """The configuration is taken over first; a failing callback is not reported, the error is."""
        observer = self.observe("ConsoleIn0", Observer(), observed_status="RTC_STATUS,CONFIGURATION")
        component = self.world.component("ConsoleIn0")
        context = self.world.context("ConsoleIn0")
        context.activate_component(component)
        self.world.ctl("error", "ConsoleIn0")
        context.reset_component(component)
        self.assertEqual(
            observer.next(4),
            [
                ("CONFIGURATION", "UPDATE_CONFIG_SET: default"),
                ("RTC_STATUS", "ACTIVE:0"),
                ("RTC_STATUS", "ERROR:0"),
                ("RTC_STATUS", "INACTIVE:0"),
            ],
        )
        component.exit()
        self.assertEqual(observer.next(1), [("RTC_STATUS", "FINALIZE:0")])

    def test_contexts(self):
        observer = self.observe("Motor0", Observer(), observed_status="EC_STATUS")
        component = self.world.component("Motor0")
        context = self.world.context("Motor0")
        context.stop()
        context.start()
        context.set_rate(5)
        other = self.world.context("Mock0")
        other.add_component(component)
        eventually(
            lambda: other.get_component_state(component) != RTC.CREATED_STATE,
            "in the context, from its next cycle on",
        )
        other.remove_component(component)
        self.assertEqual(observer.next(5), [("EC_STATUS", hint) for hint in (
            "ATTACHED:1000", "DETACHED:1000", "RATE_CHANGED:0", "SHUTDOWN:0", "STARTUP:0")])

    def test_ports(self):
        """Connections, and data as often as was asked for."""
        observer = self.observe("ConsoleOut0", FsmObserver(), observed_status="PORT_PROFILE",
                                port_profile__receive_event__min_interval="0")
        out = self.world.port("ConsoleIn0", "out")
        inp = self.world.port("ConsoleOut0", "in")
        _, profile = out.connect(connector([out, inp]))
        self.world.ctl("write", "ConsoleIn0:out", "1")
        self.world.ctl("write", "ConsoleIn0:out", "2")
        out.disconnect(profile.connector_id)
        received = ("PORT_PROFILE", "RECEIVE:InPort:ConsoleOut0.in")
        self.assertEqual(
            observer.next(4),
            [
                ("PORT_PROFILE", "CONNECT:ConsoleOut0.in"),
                ("PORT_PROFILE", "DISCONNECT:ConsoleOut0.in"),
                received,
                received,
            ],
        )

    def test_configuration(self):
        """With a blank after the colon."""
        observer = self.observe("Motor0", Observer())
        configuration = self.configuration
        component = self.world.component("Motor0")
        self.world.context("Motor0").activate_component(component)
        self.assertEqual(observer.next(2)[1], ("RTC_STATUS", "ACTIVE:0"))
        eventually(
            lambda: self.world.context("Motor0").get_component_state(component) == RTC.ACTIVE_STATE, "active"
        )
        one = SDOPackage.NameValue("motor_id", omniORB.any.to_any("3"))
        configuration.set_configuration_set_values(SDOPackage.ConfigurationSet("default", "", [one]))
        configuration.activate_configuration_set("default")
        configuration.add_configuration_set(SDOPackage.ConfigurationSet("more", "", [one]))
        configuration.remove_configuration_set("more")
        hints = [
            "SET_CONFIG_SET: default",
            "ACTIVATE_CONFIG_SET: default",
            "UPDATE_CONFIG_PARAM: default.motor_id",
            "UPDATE_CONFIG_SET: default",
            "ADD_CONFIG_SET: more",
            "REMOVE_CONFIG_SET: more",
        ]
        found = []
        while len(found) < len(hints):
            kind, hint = observer.next(1)[0]
            if kind == "CONFIGURATION":
                found.append(hint)
        self.assertEqual(sorted(found), sorted(hints))

    def test_heartbeats(self):
        """One of OpenRTM, two of FSM4RTC; the same id again changes them."""
        observer = self.observe("ConsoleIn0", Observer(), heartbeat__enable="YES", heartbeat__interval="0.05")
        self.assertEqual(observer.next(2), [("HEARTBEAT", "")] * 2)
        again = Observer()
        again.said = observer.said
        self.assertTrue(self.configuration.add_service_profile(service(again)))
        self.assertEqual([self.configuration.remove_service_profile("me") for _ in range(2)], [True, False])
        observer = self.observe(
            "ConsoleOut0",
            FsmObserver(),
            rtc_heartbeat__enable="YES",
            rtc_heartbeat__interval="0.05",
            ec_heartbeat__enable="YES",
            ec_heartbeat__interval="0.05",
        )
        self.assertEqual(set(observer.next(6)), {("RTC_HEARTBEAT", ""), ("EC_HEARTBEAT", "HEARTBEAT:0")})

    def test_refused(self):
        """What is not among sdo.service.consumer.available_services, and an empty id."""
        for name, servant in (
            ("ConsoleIn0", FsmObserver()),
            ("ConsoleOut0", Observer()),
            ("Mock0", Observer()),
            ("ConsoleIn0", Logger()),
        ):
            component = self.world.component(name)
            known = value(
                component.get_component_profile().properties, "sdo.service.consumer.available_services"
            )
            self.assertNotIn(servant.type_id, known)
            self.assertFalse(component.get_configuration().add_service_profile(service(servant)))
        configuration = self.world.component("ConsoleIn0").get_configuration()
        self.assertFalse(configuration.add_service_profile(service(Observer(), "")))

    def test_lost_observer(self):
        """It is forgotten with the first event that does not get through."""
        gone = worlds.World("these", "ConsoleIn:Gone0")
        self.addCleanup(gone.close)
        ghost = gone.component("Gone0")
        configuration = self.world.component("ConsoleIn0").get_configuration()
        profile = SDOPackage.ServiceProfile(
            "lost", Observer.type_id, [], ghost._narrow(RTC.RTObject).get_ports()[0]
        )
        self.assertTrue(configuration.add_service_profile(profile))
        gone.close()
        context = self.world.context("ConsoleIn0")

        def forgotten():
            context.stop()
            context.start()
            return (
                not configuration.remove_service_profile("lost")
                or configuration.add_service_profile(profile) is None
            )

        eventually(forgotten, "forgotten")

    def test_loggers(self):
        """Real components accept them; only ctl makes them speak, as far as their level and filter go."""
        logger = self.observe("Motor0", Logger(), logger__log_level="INFO", logger__filter="motor,arm")
        self.world.ctl("log", "Motor0", "DEBUG", "motor", "too much")
        self.world.ctl("log", "Motor0", "ERROR", "other", "not asked for")
        self.world.ctl("log", "Motor0", "ERROR", "motor", "it is hot")
        self.assertEqual(logger.next(1), [("motor", "RTM_ERROR", "it is hot")])
        self.assertRaises(processes.Failed, self.world.ctl, "log", "Motor0", "LOUD", "motor", "x")


class StateMachines(Case):
    def test_service(self):
        """Found in the list of service profiles and by id; what is set is reported again."""
        self.start("fsm")
        component = self.world.component("Microwave0")
        found, = component.get_service_profiles()
        self.assertEqual((found.id, found.interface_type), (SERVICE, SERVICE))
        machine = found.service._narrow(RTC.ExtendedFsmService)
        self.assertTrue(machine._is_equivalent(component.get_sdo_service(SERVICE)))
        self.assertTrue(machine._is_equivalent(component.get_service_profile(SERVICE).service))
        self.assertEqual(machine.get_current_state(), "closed")
        self.world.ctl("fsm", "Microwave0", "opened")
        self.assertEqual(machine.get_current_state(), "opened")
        code, structure = machine.get_fsm_structure()
        self.assertEqual((str(code), structure.name), ("RTC_OK", "Microwave"))
        self.assertIn("<scxml", structure.structure)
        structure.event_profiles = [RTC.FsmEventProfile("toggle", "TimedShort")]
        self.assertEqual(str(machine.set_fsm_structure(structure)), "RTC_OK")
        self.assertEqual([one.name for one in machine.get_fsm_structure()[1].event_profiles], ["toggle"])
        self.assertEqual(
            value(component.get_component_profile().properties, "sdo.service.provider.available_services"),
            SERVICE,
        )

    def test_fragile(self):
        """The one of C++ that ends when it is asked for its service by id, but not when its profile is read.
        """
        self.start("fsm", "dies", "--flavour", "cpp2")
        component = self.world.component("Microwave0")
        self.assertEqual(component.get_service_profiles()[0].id, SERVICE)
        self.assertEqual(raised(component.get_sdo_service, SERVICE), "COMM_FAILURE")
        self.assertNotEqual(self.world.process.wait(worlds.LIMIT), 0)

    def test_event_port(self):
        """Of type any; C++ 2.x cannot connect it."""
        for flavour, answer in (("cpp2", "RTC_ERROR"), ("py2", "RTC_OK")):
            self.start("fsm", "--flavour", flavour)
            port = self.world.port("Microwave0", "event")
            self.assertEqual(value(port.get_port_profile().properties, "dataport.data_type"), "any")
            self.assertEqual(outcome(port.connect, connector([port])), answer)

    def test_observed(self):
        """Steps of a change, with the misspelling."""
        self.start("observed")
        observer = self.observe("Microwave0", FsmObserver(), observed_status="FSM_STATUS")
        self.world.ctl("fsm", "Microwave0", "cooking")
        hints = [hint for _, hint in observer.next(8)]
        self.assertTrue({"closed PRE_ON_STATE_CHANGE", "closed PRE_ON_EXIT", "cooking PRE_ONENTRY",
                         "cooking POST_ON_STATE_CHNAGE"} < set(hints))


class Senders(Case):
    def test_rate_and_size(self):
        """As many a second and as large as asked for, with the byte order that each implementation really
        sends.
        """
        for flavour, order in (("py2", "big"), ("cpp2", "little")):
            self.start("senders", "200", "5000", "--flavour", flavour)
            receiver = Receiver()
            ior = worlds.Server.orb.object_to_string(receiver._this())
            changes = {"corba_cdr__inport_ior": ior, "serializer__cdr__endian": "big,little"}
            port = self.world.port("Source0", "block")
            self.assertEqual(outcome(port.connect, connector([port], **changes)), "RTC_OK")
            blocks = receiver.next(101)
            self.assertEqual((len(blocks[0]), int.from_bytes(blocks[0][8:12], order)), (12 + 5000, 5000))
            numbers = sorted(int.from_bytes(data[12:20], "little") for data in blocks)
            self.assertEqual(numbers, list(range(numbers[0], numbers[0] + 101)))
            times = sorted(
                int.from_bytes(data[:4], order) + int.from_bytes(data[4:8], order) / 1e9 for data in blocks
            )
            self.assertTrue(0.25 < times[-1] - times[0] < 3, times[-1] - times[0])


if __name__ == "__main__":
    unittest.main()
