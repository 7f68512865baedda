"""Ports of mock components: connecting, disconnecting, data, services and dead peers, as real ones of each
implementation do it.
"""
import threading
import time
import unittest
import uuid

import answers
import flavours
import worlds
from answers import outcome, raised, value
from worlds import connector, eventually, nvlist

OVER = 0.1  # seconds after which a get() of a moment ago is certainly over
ONCE = "mocks are used by the transcripts on every Python"
try:
    import omniORB
    from omniORB import any as omniany
    from mock_components.idl import RTC, OpenRTM, SDOPackage
except ImportError:
    pass        # then setUpModule skips all


def setUpModule():
    worlds.start_name_server()


def tearDownModule():
    worlds.Server.stop()


class Ports(flavours.Flavoured):
    """Two ports in one process, and one in another."""

    def connect(self, *arguments, **changes):
        """The code of one attempt; nothing stays connected."""
        ports = list(arguments) or [self.out, self.inp]
        code, profile = (ports[0] or self.out).connect(connector(ports, **changes))
        for port in filter(None, ports):
            port.notify_disconnect(profile.connector_id)
        return str(code)

    # connecting

    def test_properties_that_connect_adds(self):
        """Names of the properties that come back, in order."""
        asked = ["dataflow_type", "interface_type", "subscription_type", "data_type", "serializer.cdr.endian"]
        for ports, flow in (
            ([self.out, self.inp], "push"),
            ([self.inp, self.out], "push"),
            ([self.out, self.inp], "pull"),
        ):
            code, profile = ports[0].connect(connector(ports, dataflow_type=flow))
            self.assertEqual(str(code), "RTC_OK")
            self.assertEqual([name.replace("dataport.", "") for name in answers.names(profile)],
                             asked + self.added[ports[0] is self.inp, flow])
            self.assertEqual(value(profile.properties, "dataport.serializer.cdr.endian"), "little,big")
            self.assertEqual(
                [p.connector_id for p in self.inp.get_connector_profiles()], [profile.connector_id]
            )
            self.assertEqual(uuid.UUID(profile.connector_id).version, self.uuid)
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
            ("no data flow", (), {"dataflow_type": None}, "BAD_PARAMETER"),
            ("capital", (), {"dataflow_type": "Push"}, "RTC_OK"),
            ("capital subscription", (), {"subscription_type": "New"}, "RTC_OK"),
            ("no subscription", (), {"subscription_type": None}, "RTC_OK"),
            ("periodic", (), {"subscription_type": "periodic"}, self.periodic),
            (
                "periodic with rate",
                (),
                {"subscription_type": ("periodic"), "publisher__push_rate": "10"},
                "RTC_OK",
            ),
            ("unknown endian", (), {"serializer__cdr__endian": "middle"}, self.endian),
            ("big endian", (), {"serializer__cdr__endian": "big"}, "RTC_OK"),
            ("wrong type", (), {"data_type": "IDL:RTC/TimedFloat:1.0"}, "RTC_OK"),
            ("no type", (), {"data_type": None}, "RTC_OK"),
            ("two InPorts, push", ins, {}, "RTC_OK"),
            ("two InPorts, pull", ins, {"dataflow_type": "pull"}, "BAD_PARAMETER"),
            ("two OutPorts, push", outs, {}, "BAD_PARAMETER"),
            ("two OutPorts, pull", outs, {"dataflow_type": "pull"}, "RTC_OK"),
            ("OutPort alone", [self.out], {}, "BAD_PARAMETER"),
            ("InPort alone", [self.inp], {}, "RTC_OK"),
            ("OutPort alone, pull", [self.out], {"dataflow_type": "pull"}, "RTC_OK"),
            ("nil", [self.out, None], {}, "BAD_PARAMETER"),
            (
                "direct, far",
                [self.out, self.far.port("Far0", "in")],
                {"interface_type": ("direct")},
                self.direct,
            ),
            ("unknown subscription", (), {"subscription_type": "bogus"}, "RTC_ERROR"),
            ("unknown marshaling", (), {"marshaling_type": "bogus"}, self.marshaling),
        ):
            with self.subTest(what):
                self.assertEqual(self.connect(*ports, **changes), expected)
        self.assertEqual(
            str(self.out.connect(RTC.ConnectorProfile("n", "", [], nvlist()))[0]), "BAD_PARAMETER"
        )
        self.assertEqual(
            str(self.out.connect(RTC.ConnectorProfile("n", "", [self.out, self.inp], []))[0]), "BAD_PARAMETER"
        )

    def test_doubles(self):
        ports = [self.out, self.inp]
        self.assertEqual(str(self.out.connect(connector(ports, "first"))[0]), "RTC_OK")
        self.assertEqual(str(self.out.connect(connector(ports, "first"))[0]), "PRECONDITION_NOT_MET")
        self.assertEqual(str(self.out.connect(connector(ports, "second"))[0]), self.double)
        self.assertEqual(
            str(self.out.connect(connector(ports, "third", allow_dup_connection="YES"))[0]), "RTC_OK"
        )
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
        """A connector of one InPort gives us an object whose put() takes bare CDR; it goes with the
        connection.
        """
        code, profile = self.inp.connect(connector([self.inp]))
        self.assertEqual(str(code), "RTC_OK")
        sink = worlds.Server.orb.string_to_object(value(profile.properties, "dataport.corba_cdr.inport_ior"))
        sink = sink._narrow(OpenRTM.InPortCdr)
        data = bytes.fromhex("0100000002000000") + (12345).to_bytes(4, "little")
        self.assertEqual(sink.put(data), OpenRTM.PORT_OK)
        self.activate("ConsoleOut0")
        self.assertEqual(self.received(1), "12345")
        self.deactivate("ConsoleOut0")
        self.assertEqual(outcome(sink.put, b"\1"), self.short_put)
        self.inp.disconnect(profile.connector_id)
        self.assertEqual(outcome(sink.put, data), "OBJECT_NOT_EXIST")

    def test_pull_from_the_out_port(self):
        """What get() answers before, with and after data."""
        for policy, before, after in (
            (None, self.empty, self.readback),
            ("do_nothing", self.empty, self.empty),
        ):
            changes = {"dataflow_type": "pull", "buffer__read__empty_policy": policy}
            code, profile = self.out.connect(connector([self.out], **changes))
            source = worlds.Server.orb.string_to_object(
                value(profile.properties, "dataport.corba_cdr.outport_ior")
            )
            source = source._narrow(OpenRTM.OutPortCdr)
            self.assertEqual(outcome(source.get), before)
            self.world.ctl("write", "ConsoleIn0:out", "7")
            status, data = source.get()
            self.assertEqual((status, data[8:]), (OpenRTM.PORT_OK, b"\7\0\0\0"))
            self.assertEqual(outcome(source.get), after)
            time.sleep(OVER)
            self.out.disconnect(profile.connector_id)

    def test_big_endian(self):
        """C++ from 1.2 on sends little endian even where big was agreed."""
        code, profile = self.out.connect(connector([self.out, self.inp], serializer__cdr__endian="big"))
        self.activate("ConsoleOut0")
        self.world.ctl("write", "ConsoleIn0:out", "7")
        self.assertEqual(int(self.received(1)), 7 if self.obeys_big else 7 << 24)
        self.deactivate("ConsoleOut0")

    def test_when_an_in_port_is_read(self):
        """In a cycle of the component's, while it is active and connected; what is not read waits for the
        next connection.
        """
        self.activate("ConsoleOut0")
        self.put(7)
        self.assertEqual(self.received(1), "7")
        self.deactivate("ConsoleOut0")
        self.put(8)
        self.assertEqual(self.waiting(), "1")
        self.activate("ConsoleOut0")
        self.put()
        self.assertEqual(self.received(1), "8")
        self.deactivate("ConsoleOut0")

    def test_the_buffer_of_an_in_port(self):
        """There is one; the length and the policy stay after the connector that asked for them, whose length
        empties it.
        """
        self.put(*range(10))
        self.assertEqual(self.waiting(), "8")
        self.put()
        self.assertEqual(self.waiting(), "8")
        self.assertEqual(self.put(1, 2, 3, buffer__length="2", buffer__write__full_policy="do_nothing"),
                         [OpenRTM.PORT_OK, OpenRTM.PORT_OK, OpenRTM.BUFFER_FULL])
        self.assertEqual(self.put(4), [OpenRTM.BUFFER_FULL])
        self.assertEqual(
            self.put(4, buffer__write__full_policy="block", buffer__write__timeout="0.1"),
            [OpenRTM.BUFFER_TIMEOUT],
        )
        self.assertEqual(
            self.put(4, inport__buffer__length="8", buffer__write__full_policy="overwrite"), [OpenRTM.PORT_OK]
        )
        self.assertEqual(self.waiting(), "1")
        self.put(buffer__length="8")
        self.assertEqual((self.waiting(), self.world.ctl("buffer", "ConsoleOut0:in")), ("0", "8 overwrite\n"))

    def put(self, *numbers, **changes):
        """Connect to the InPort, put numbers, wait until an active component has read them, disconnect; the
        statuses.
        """
        code, profile = self.inp.connect(connector([self.inp], **changes))
        self.assertEqual(str(code), "RTC_OK")
        ior = value(profile.properties, "dataport.corba_cdr.inport_ior")
        sink = worlds.Server.orb.string_to_object(ior)._narrow(OpenRTM.InPortCdr)
        statuses = [sink.put(bytes(8) + number.to_bytes(4, "little")) for number in numbers]
        if self.state() == RTC.ACTIVE_STATE:
            eventually(lambda: self.waiting() == "0", "reading")
        self.inp.disconnect(profile.connector_id)
        return statuses

    def waiting(self):
        return self.world.ctl("waiting", "ConsoleOut0:in").strip()

    def received(self, count):
        """The data of the last value that the component has read, of `count` more than at the last
        `activate`.
        """
        return self.world.ctl("received", "ConsoleOut0:in", str(self.before + count)).split()[1]

    def state(self):
        return self.world.context("ConsoleOut0").get_component_state(self.world.component("ConsoleOut0"))

    def activate(self, name):
        self.before = int(self.world.ctl("received", "ConsoleOut0:in").split()[0])
        self.world.context(name).activate_component(self.world.component(name))
        eventually(lambda: self.state() == RTC.ACTIVE_STATE, "active")

    def deactivate(self, name):
        self.world.context(name).deactivate_component(self.world.component(name))
        eventually(lambda: self.state() == RTC.INACTIVE_STATE, "inactive")

    def test_a_connector_removed_under_a_fetch(self):
        """C++ deletes what is being used, and its process ends."""
        world = worlds.World("these", "ConsoleIn:Lone0", "--flavour", self.flavour)
        self.addCleanup(world.close)
        out = world.port("Lone0", "out")
        waits = {"buffer__read__empty_policy": "block", "buffer__read__timeout": "60"}
        for policy in ({"buffer__read__empty_policy": "do_nothing"}, waits):
            code, profile = out.connect(connector([out], dataflow_type="pull", **policy))
            ior = value(profile.properties, "dataport.corba_cdr.outport_ior")
            source = worlds.Server.orb.string_to_object(ior)._narrow(OpenRTM.OutPortCdr)
            before = world.count("get")
            fetch = threading.Thread(target=outcome, args=[source.get], daemon=True)
            fetch.start()
            eventually(lambda: world.count("get") > before, "fetching")
            if policy is not waits:
                fetch.join()
                time.sleep(OVER)
            dies = policy is waits and self.language[0] == "C++"
            self.assertEqual(raised(out.disconnect, profile.connector_id), "COMM_FAILURE" if dies else None)

    def test_duplex(self):
        """Where a port lists it, it refuses it and keeps a ghost: the next disconnection never ends."""
        world = worlds.World("these", "ConsoleIn:Lone0", "--flavour", self.flavour)
        self.addCleanup(world.close)
        out = world.port("Lone0", "out")
        self.assertEqual(str(out.connect(connector([out], dataflow_type="duplex"))[0]), "BAD_PARAMETER")
        code, profile = out.connect(connector([out], dataflow_type="pull"))
        omniORB.setClientCallTimeout(out, 500)
        haunted = "duplex" in value(out.get_port_profile().properties, "dataport.dataflow_type")
        self.assertEqual(raised(out.disconnect, profile.connector_id), "TIMEOUT" if haunted else None)

    def test_data_flows(self):
        """From a counting component to a reading one, by push of each kind and by pull, in both byte orders.
        """
        component = self.world.component("ConsoleIn0")
        context = self.world.context("ConsoleIn0")
        reader = self.world.component("ConsoleOut0")
        reading = self.world.context("ConsoleOut0")
        for comp, cxt in ((component, context), (reader, reading)):
            cxt.activate_component(comp)
            eventually(lambda: cxt.get_component_state(comp) == RTC.ACTIVE_STATE, "active")
        for changes in ({}, {"subscription_type": (
            "new"
        )}, {"serializer__cdr__endian": "big"}, {"dataflow_type": "pull"},
                        {"subscription_type": "periodic", "publisher__push_rate": "50"}):
            before = int(self.world.ctl("received", "ConsoleOut0:in").split()[0])
            code, profile = self.out.connect(connector([self.out, self.inp], **changes))
            self.assertEqual(str(code), "RTC_OK")
            self.world.ctl("received", "ConsoleOut0:in", str(before + 3))
            self.out.disconnect(profile.connector_id)
        context.deactivate_component(component)
        reading.deactivate_component(reader)

    # services

    def test_services(self):
        """The keys under which a provider publishes its object; calls reach it when it exists."""
        component, context = self.world.component("MyServiceProvider0"), self.world.context(
            "MyServiceProvider0"
        )
        provider = self.world.port("MyServiceProvider0", "MyService")
        consumer = self.world.port("MyServiceConsumer0", "MyService")
        instance, type_name = self.service
        entry, = provider.get_port_profile().interfaces
        self.assertEqual(
            (entry.instance_name, entry.type_name, entry.polarity), self.service + (RTC.PROVIDED,)
        )
        self.assertEqual(consumer.get_port_profile().interfaces[0].polarity, RTC.REQUIRED)
        code, profile = provider.connect(RTC.ConnectorProfile("s", "", [provider, consumer], []))
        self.assertEqual(str(code), "RTC_OK")
        keys = ["MyServiceProvider0.port.MyService.provided.%s.%s", "port.%s.%s"]
        self.assertEqual(answers.names(profile), [key % (type_name, instance) for key in keys])
        service = worlds.Server.orb.string_to_object(profile.properties[0].value.value())
        self.assertEqual(service._non_existent(), self.service_sleeps)
        context.activate_component(component)
        eventually(lambda: not service._non_existent(), "the service")
        self.assertTrue(service._is_a("IDL:SimpleService/MyService:1.0"))
        strict = [SDOPackage.NameValue("port.connection.strictness", omniany.to_any("strict"))]
        provider.disconnect_all()
        context.deactivate_component(component)
        self.assertEqual(str(consumer.connect(RTC.ConnectorProfile("s", "", [consumer], []))[0]), "RTC_OK")
        consumer.disconnect_all()
        self.assertEqual(
            str(consumer.connect(RTC.ConnectorProfile("s", "", [consumer], strict))[0]), "RTC_ERROR"
        )

    # peers that die

    def test_dead_peer(self):
        """The first question to a component whose peer was killed."""
        world = worlds.World("orphan", "--flavour", self.flavour)
        self.addCleanup(world.close)
        port, = world.component("Orphan0").get_ports()
        self.assertEqual(raised(port.get_port_profile), self.dead_port)
        self.assertEqual(port.get_port_profile().connector_profiles, [])
        self.assertEqual(raised(world.component("Orphan0").get_component_profile), None)
        world = worlds.World("orphan", "--flavour", self.flavour)
        self.addCleanup(world.close)
        self.assertEqual(raised(world.component("Orphan0").get_component_profile), self.dead_component)
        if self.dead_component == "COMM_FAILURE":
            self.assertNotEqual(world.process.wait(worlds.LIMIT), 0)


class Cpp11(Ports, flavours.Cpp11, unittest.TestCase):
    pass


class Cpp12(Ports, flavours.Cpp12, unittest.TestCase):
    pass


class Cpp2(Ports, flavours.Cpp2, unittest.TestCase):
    pass


class Py2(Ports, flavours.Py2, unittest.TestCase):
    pass


if __name__ == "__main__":
    unittest.main()
