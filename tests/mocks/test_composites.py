"""Mock composites: whether they take, drive and give back their members as those of each implementation do.

If this fails, the transcripts of rtcomp prove nothing.
"""
import threading
import unittest

import worlds
from answers import outcome, raised, value
from worlds import eventually

ONCE = "mocks are used by the transcripts on every Python"
try:
    import omniORB
    from mock_components.idl import RTC, RTM, SDOPackage
except ImportError:
    pass        # then setUpModule skips all

MEMBERS = ["Sensor0", "Controller0", "Motor0"]


def setUpModule():
    worlds.start_name_server()


def tearDownModule():
    worlds.Server.stop()


def port_names(component):
    return [port.get_port_profile().name for port in component.get_ports()]


class Composites:
    """A composite of three members."""

    flavour = None
    once = True
    sync = []
    answer = "RTC_OK"

    def setUp(self):
        self.world = worlds.World("composite", "--flavour", self.flavour, "--rate", "100")
        self.addCleanup(self.world.close)
        self.composite = self.world.component("composite0")
        self.organization, = self.composite.get_owned_organizations()
        self.context = self.world.context("composite0")
        # which the context of 2.x knows from its next cycle on
        members = [self.world.component(name) for name in MEMBERS]
        eventually(
            lambda: all(self.context.get_component_state(one) != RTC.CREATED_STATE for one in members),
            "members",
        )

    def reached(self, state, *names):
        components = [self.world.component(name) for name in names]
        eventually(
            lambda: all(self.context.get_component_state(one) == state for one in components), str(state)
        )

    def export(self, text):
        configuration = self.composite.get_configuration()
        one = SDOPackage.NameValue("exported_ports", omniORB.any.to_any(text))
        configuration.set_configuration_set_values(SDOPackage.ConfigurationSet("default", "", [one]))
        configuration.activate_configuration_set("default")

    def test_members(self):
        """Their own contexts are stopped; they take part in the composite's, and know its organization."""
        self.assertEqual([one.get_sdo_id() for one in self.organization.get_members()], MEMBERS)
        profile = self.context.get_profile()
        self.assertEqual([one.get_sdo_id() for one in profile.participants], MEMBERS)
        self.assertTrue(profile.owner._is_equivalent(self.composite))
        self.assertEqual(
            [item.name for item in profile.properties if item.name.startswith("sync")], self.sync
        )
        member = self.world.component("Motor0")
        self.assertFalse(self.world.context("Motor0").is_running())
        self.assertEqual(member.get_context_handle(self.context), 1000)
        self.assertTrue(member.get_participating_contexts()[0]._is_equivalent(self.context))
        known, = member.get_organizations()
        self.assertEqual(known.get_organization_id(), self.organization.get_organization_id())
        self.assertEqual((member.get_owned_organizations(), self.composite.get_organizations()), ([], []))
        self.assertIsNone(member.get_component_profile().parent)

    def test_profile(self):
        profile = self.composite.get_component_profile()
        self.assertEqual((profile.type_name, profile.category, profile.vendor, profile.version),
                         ("PeriodicECSharedComposite", "composite.PeriodicECShared", "jp.go.aist", "1.0"))
        self.assertEqual(
            [value(profile.properties, "conf.default." + name) for name in ("members", "exported_ports")],
            ["Sensor0, Controller0, Motor0", "Sensor0.in, Motor0.out"],
        )
        self.assertEqual(
            [value(profile.properties, name) for name in ("max_instance", "port", "exported_ports")],
            ["0", "", ""],
        )

    def test_owner(self):
        """C++ answers that once."""
        self.assertTrue(self.organization.get_owner()._is_equivalent(self.composite))
        self.assertEqual(self.organization.get_owner() is None, self.once)
        self.assertEqual(self.organization.get_dependency(), SDOPackage.OWN)

    def test_exported_ports(self):
        """The members' own; which of them goes by the configuration set, once it is activated."""
        self.assertEqual(port_names(self.composite), ["Sensor0.in", "Motor0.out"])
        port = self.composite.get_ports()[0]
        self.assertTrue(port._is_equivalent(self.world.port("Sensor0", "in")))
        self.assertTrue(port.get_port_profile().owner._is_equivalent(self.world.component("Sensor0")))
        self.assertEqual([port.name for port in self.composite.get_component_profile().port_profiles],
                         ["Sensor0.in", "Motor0.out"])
        self.export("Controller0.out, Nobody0.in")
        self.assertEqual(port_names(self.composite), ["Controller0.out"])
        self.export("")
        self.assertEqual(port_names(self.composite), [])

    def test_remove_and_add(self):
        """A member that leaves gets its context back; the parameters stay as they are."""
        self.assertEqual(self.organization.remove_member("Motor0"), True)
        self.assertTrue(self.world.context("Motor0").is_running())
        self.assertEqual(port_names(self.composite), ["Sensor0.in"])
        self.assertEqual(self.world.component("Motor0").get_organizations(), [])
        eventually(lambda: len(self.context.get_profile().participants) == 2, "left")
        self.assertEqual(self.organization.add_members([self.world.component("Motor0")]), True)
        self.assertEqual(port_names(self.composite), ["Sensor0.in", "Motor0.out"])
        self.assertFalse(self.world.context("Motor0").is_running())
        self.assertEqual(value(self.composite.get_component_profile().properties, "conf.default.members"),
                         "Sensor0, Controller0, Motor0")
        for operation, argument in (("add_members", []), ("remove_member", "Nobody0"), ("remove_member", "")):
            self.assertEqual(raised(getattr(self.organization, operation), argument), "InvalidParameter")

    def test_member_exits(self):
        self.world.component("Motor0").exit()
        self.assertEqual([one.get_sdo_id() for one in self.organization.get_members()], MEMBERS[:2])

    def test_exit(self):
        """Members get themselves back."""
        self.assertEqual(str(self.composite.exit()), "RTC_OK")
        self.assertTrue(self.organization._non_existent())
        for name in MEMBERS:
            self.assertTrue(self.world.context(name).is_running())
            self.assertEqual(self.world.component(name).get_organizations(), [])

    def test_transitions(self):
        """What activation and deactivation answer, and that the members follow."""
        self.assertEqual(str(self.context.activate_component(self.composite)), self.answer)
        self.reached(RTC.ACTIVE_STATE, "composite0", *MEMBERS)
        own = self.world.context("Motor0")
        self.assertEqual(own.get_component_state(self.world.component("Motor0")), RTC.INACTIVE_STATE)
        self.assertEqual(self.world.ctl("state", "Motor0", "1000"), "ACTIVE\n")
        self.deactivate()
        self.reached(RTC.INACTIVE_STATE, "composite0", *MEMBERS)

    def deactivate(self):
        self.assertEqual(str(self.context.deactivate_component(self.composite)), self.answer)


class Cpp11(Composites, unittest.TestCase):
    flavour = "cpp11"

    def deactivate(self):
        """It would block; the members one by one first, and it does not."""
        for name in MEMBERS + ["composite0"]:
            self.assertEqual(str(self.context.deactivate_component(self.world.component(name))), "RTC_OK")

    def test_blocking(self):
        """Deactivated as a whole it waits for its members in the thread that is to move them; exit() hangs,
        too.
        """
        self.context.activate_component(self.composite)
        self.reached(RTC.ACTIVE_STATE, "composite0", *MEMBERS)
        threading.Thread(
            target=raised, args=(self.context.deactivate_component, self.composite), daemon=True
        ).start()
        eventually(lambda: self.world.count("deactivate_component") == 1, "asked for")
        omniORB.setClientCallTimeout(self.composite, 300)
        self.assertEqual(raised(self.composite.exit), "TIMEOUT")
        self.assertEqual(self.context.get_component_state(self.composite), RTC.ACTIVE_STATE)


class Cpp12(Composites, unittest.TestCase):
    """It answers with an error, and does it all the same."""

    flavour = "cpp12"
    answer = "RTC_ERROR"


class Cpp2(Composites, unittest.TestCase):
    flavour = "cpp2"
    sync = ["sync_transition", "sync_activation", "sync_deactivation", "sync_reset"]


class Py2(Composites, unittest.TestCase):
    flavour = "py2"
    once = False
    sync = Cpp2.sync


class Worlds(unittest.TestCase):
    def world(self, *words):
        world = worlds.World(*words)
        self.addCleanup(world.close)
        return world

    def bereaved(self, flavour):
        world = self.world("deadmember", "--flavour", flavour)
        composite = world.component("composite0")
        return world, composite, composite.get_owned_organizations()[0], world.context("composite0")

    def test_dead_member(self):
        """It is listed, its port too; the profile fails because of it, and so does its removal: it stays."""
        _, composite, organization, _ = self.bereaved("rtorb")
        self.assertEqual(
            [outcome(one.get_sdo_id) for one in organization.get_members()], ["ConsoleIn0", "TRANSIENT"]
        )
        self.assertEqual(len(composite.get_ports()), 2)
        self.assertIn(raised(composite.get_component_profile), ("TRANSIENT", "COMM_FAILURE"))
        self.assertIn(raised(organization.remove_member, "Peer0"), ("TRANSIENT", "COMM_FAILURE"))
        self.assertEqual(len(organization.get_members()), 2)
        self.assertEqual(port_names(composite), ["out"])
        self.assertIsNone(raised(composite.get_component_profile))
        self.assertTrue(organization.remove_member("ConsoleIn0"))

    def test_dead_member_of_cpp(self):
        """Its removal ends the process at the next activation, or now, if the composite has ever been active.
        """
        world, composite, organization, context = self.bereaved("cpp2")
        self.assertIn(raised(organization.remove_member, "Peer0"), ("TRANSIENT", "COMM_FAILURE"))
        self.assertEqual(len(organization.get_members()), 2)
        self.assertEqual(str(context.get_component_state(composite)), "INACTIVE_STATE")
        raised(context.activate_component, composite)
        self.assertNotEqual(world.process.wait(worlds.LIMIT), 0)
        world, composite, organization, context = self.bereaved("cpp2")
        raised(context.activate_component, composite)
        eventually(lambda: context.get_component_state(composite) == RTC.ERROR_STATE, "in Error")
        raised(organization.remove_member, "Peer0")
        self.assertNotEqual(world.process.wait(worlds.LIMIT), 0)

    def test_dead_members_end_cpp_otherwise(self):
        """When the composite exits, or is asked for its profile while it shows a port of theirs."""
        for operation in ("exit", "get_component_profile"):
            world, composite, _, _ = self.bereaved("cpp2")
            raised(getattr(composite, operation))
            self.assertNotEqual(world.process.wait(worlds.LIMIT), 0)

    def test_dead_member_of_python(self):
        """Its removal ends the thread of the context: no state changes any more."""
        world, composite, organization, context = self.bereaved("py2")
        self.assertIn(raised(organization.remove_member, "Peer0"), ("TRANSIENT", "COMM_FAILURE"))
        self.assertEqual(str(context.activate_component(composite)), "RTC_OK")
        self.assertEqual(str(composite.exit()), "RTC_ERROR")
        self.assertEqual(context.get_component_state(composite), RTC.INACTIVE_STATE)

    def test_made_by_a_manager(self):
        """As rtcomp asks for it, with a stray &; members in other processes come by add_members."""
        world = self.world("manager", "Motor")
        elsewhere = self.world("these", "Sensor")
        master = world.resolve("manager.mgr")._narrow(RTM.Manager)
        composite = master.create_component(
            "PeriodicECSharedComposite?&instance_name=G&conf.default.members=Motor0,Sensor0&"
            "conf.default.exported_ports=out,Sensor0.in"
        )
        organization, = composite.get_owned_organizations()
        self.assertEqual([one.get_sdo_id() for one in organization.get_members()], ["Motor0"])
        organization.add_members([elsewhere.component("Sensor0")])
        self.assertEqual(port_names(composite), ["Motor0.out", "Sensor0.in"])
        context = composite.get_owned_contexts()[0]
        self.assertEqual(str(context.activate_component(composite)), "RTC_OK")
        eventually(
            lambda: context.get_component_state(elsewhere.component("Sensor0")) == RTC.ACTIVE_STATE,
            "active far away",
        )


if __name__ == "__main__":
    unittest.main()
