"""Mock components: whether they answer, call by call, what real ones of each implementation answer.

If this fails, the transcripts prove nothing. The tables are those measured on OpenRTM-aist C++ 1.1, 1.2, 2.1
and Python 2.1.
"""
import unittest

import answers
import flavours
import worlds
from answers import outcome, raised, value
from worlds import eventually

ONCE = "mocks are used by the transcripts on every Python"
try:
    from omniORB import CORBA, any as omniany
    from mock_components.idl import RTC, OpenRTM, SDOPackage
except ImportError:
    pass        # then setUpModule skips all


def setUpModule():
    worlds.start_name_server()


def tearDownModule():
    worlds.Server.stop()


class Components(flavours.Flavoured):
    """Life cycle, profiles, configuration."""

    # life cycle

    def test_life_cycle(self):
        """Return codes of activate, deactivate and reset in every state."""
        component = self.world.component("ConsoleIn0")
        context = self.world.context("ConsoleIn0")
        inactive = RTC.INACTIVE_STATE
        active = RTC.ACTIVE_STATE
        error = RTC.ERROR_STATE
        for state, operation, expected, after in (
            (inactive, "deactivate", "PRECONDITION_NOT_MET", inactive),
            (inactive, "reset", "PRECONDITION_NOT_MET", inactive),
            (inactive, "activate", "RTC_OK", active),
            (active, "activate", "PRECONDITION_NOT_MET", active),
            (active, "reset", "PRECONDITION_NOT_MET", active),
            (active, "deactivate", "RTC_OK", inactive),
            (inactive, "fail", None, error),
            (error, "activate", "PRECONDITION_NOT_MET", error),
            (error, "deactivate", "PRECONDITION_NOT_MET", error),
            (error, "reset", "RTC_OK", inactive),
        ):
            with self.subTest(state=str(state), operation=operation):
                self.assertEqual(context.get_component_state(component), state)
                if operation == "fail":
                    self.world.ctl("error", "ConsoleIn0")
                else:
                    self.assertEqual(str(getattr(context, operation + "_component")(component)), expected)
                    if self.waits:
                        self.assertEqual(context.get_component_state(component), after)
                eventually(
                    lambda: context.get_component_state(component) == after, "%s %s" % (operation, after)
                )

    def test_strangers_in_a_context(self):
        """Components that are not in the context, and nil."""
        context = self.world.context("ConsoleIn0")
        stranger = self.world.component("ConsoleOut0")
        self.assertEqual(str(context.activate_component(stranger)), "BAD_PARAMETER")
        self.assertEqual(str(context.get_component_state(stranger)), "CREATED_STATE")
        self.assertEqual(outcome(context.activate_component, None), self.nil_component)
        self.assertEqual(str(context.remove_component(stranger)), "BAD_PARAMETER")

    def test_start_stop_rate(self):
        component = self.world.component("ConsoleOut0")
        context = self.world.context("ConsoleOut0")
        self.assertEqual(str(context.start()), "PRECONDITION_NOT_MET")
        self.assertEqual(str(context.stop()), "RTC_OK")
        self.assertEqual(str(context.stop()), "PRECONDITION_NOT_MET")
        self.assertEqual(str(context.activate_component(component)), self.activate_stopped[0])
        self.assertEqual(str(context.get_component_state(component)), self.activate_stopped[1])
        self.assertEqual(str(context.start()), "RTC_OK")
        if self.sleeps:  # until it is asked again
            self.assertEqual(str(context.get_component_state(component)), "INACTIVE_STATE")
            self.assertEqual(str(context.activate_component(component)), "RTC_OK")
        eventually(lambda: context.get_component_state(component) == RTC.ACTIVE_STATE, "active after start")
        self.assertEqual(str(context.deactivate_component(component)), "RTC_OK")
        self.assertEqual(
            [str(context.set_rate(rate)) for rate in (0, -1, 50)],
            ["BAD_PARAMETER", "BAD_PARAMETER", "RTC_OK"],
        )
        self.assertEqual(context.get_rate(), 50)
        context.set_rate(100)

    def test_contexts_and_handles(self):
        component = self.world.component("ConsoleIn0")
        context = self.world.context("ConsoleIn0")
        self.assertEqual(component.get_context_handle(context), 0)
        self.assertEqual(component.get_context_handle(self.world.context("ConsoleOut0")), -1)
        self.assertTrue(component.get_context(0)._is_equivalent(context))
        self.assertEqual([component.get_context(handle) for handle in (5, 99, 1000)], [None] * 3)
        self.assertTrue(component.is_alive(context))
        profile = context.get_profile()
        self.assertEqual((profile.kind, profile.rate, profile.participants), (RTC.PERIODIC, 100.0, []))
        self.assertTrue(profile.owner._is_equivalent(component))
        self.assertEqual(answers.names(profile), self.context_properties)
        self.assertEqual(
            context._is_a(OpenRTM.ExtTrigExecutionContextService._NP_RepositoryId), self.ext_trig
        )
        self.assertEqual(str(component.finalize()), "PRECONDITION_NOT_MET")

    # profiles

    def test_component_profile(self):
        profile = self.world.component("ConsoleOut0").get_component_profile()
        self.assertEqual(
            (profile.instance_name, profile.type_name, profile.vendor, profile.version, profile.category),
            ("ConsoleOut0", "ConsoleOut") + self.author + ("example",),
        )
        self.assertIsNone(profile.parent)
        self.assertEqual([port.name for port in profile.port_profiles], ["ConsoleOut0.in"])
        properties = {item.name: item.value.value() for item in profile.properties}
        self.assertEqual((properties["language"], properties["lang_type"], properties["openrtm.version"],
                          properties["sdo.service.consumer.available_services"]), self.language)
        self.assertTrue(properties[self.endpoint].startswith("127.0.0.1:"))
        self.assertEqual(properties["naming.names"], "test.host_cxt/ConsoleOut0.rtc")
        if self.property_count:
            self.assertEqual(len(profile.properties), self.property_count)

    def test_port_profiles(self):
        """All properties of both data ports, in order."""
        for port, expected in ((self.out, self.out_properties), (self.inp, self.in_properties)):
            profile = port.get_port_profile()
            found = [
                (
                    "%s=%s" % (item.name, item.value.value())
                    if item.value.typecode().kind() == CORBA.tk_string
                    else item.name
                )
                for item in profile.properties
            ]
            self.assertEqual(found, expected)
            self.assertTrue(profile.port_ref._is_equivalent(port))

    def test_sdo(self):
        component = self.world.component("ConsoleIn0")
        self.assertEqual(component.get_sdo_id(), "ConsoleIn0")
        self.assertEqual(component.get_sdo_type(), "Console input component")
        self.assertEqual(
            (
                component.get_organizations(),
                component.get_owned_organizations(),
                component.get_status_list(),
                component.get_service_profiles(),
            ),
            ([], [], [], []),
        )
        self.assertEqual(raised(component.get_status, "x"), "InvalidParameter")
        self.assertEqual(raised(component.get_monitoring), "InterfaceNotImplemented")
        self.assertEqual(raised(component.get_service_profile, "x"), self.no_service_profile)
        self.assertEqual(raised(component.get_sdo_service, "x"), self.no_sdo_service)
        for type_id, expected in (
            ("IDL:omg.org/RTC/DataFlowComponent:1.0", True),
            ("IDL:omg.org/RTC/RTObject:1.0", True),
            ("IDL:omg.org/RTC/FsmParticipant:1.0", False),
        ):
            self.assertEqual(component._is_a(type_id), expected, type_id)

    # configuration

    def test_configuration(self):
        world = worlds.World("config", "--flavour", self.flavour)
        self.addCleanup(world.close)
        config = world.component("ConfigSample0").get_configuration()
        self.assertEqual([s.id for s in config.get_configuration_sets()],
                         ["default", "mode0", "mode1", "__widget__", "__constraints__"])
        self.assertEqual(config.get_active_configuration_set().id, "mode1")
        for function, argument, expected in (
            (config.get_configuration_set, "nosuch", "InternalError"),
            (config.get_configuration_set, "", self.empty_id),
            (config.activate_configuration_set, "nosuch", self.bad_activate),
            (config.activate_configuration_set, "__widget__", self.bad_activate),
            (config.activate_configuration_set, "", "InvalidParameter"),
        ):
            self.assertEqual(raised(function, argument), expected, argument)
        self.assertEqual(raised(config.get_configuration_parameter_value, "x"), self.parameter)
        for function, expected in ((config.get_configuration_set, self.no_set),
                                   (config.activate_configuration_set, self.cannot_activate)):
            with self.assertRaises(CORBA.UserException) as caught:
                function("nosuch")
            self.assertEqual(caught.exception.description, expected)
        self.assertEqual(
            (config.get_configuration_parameters(), config.get_configuration_parameter_values()), ([], [])
        )
        self.assertEqual(config.get_active_configuration_set().id, "mode1", "asking changed something")

        new = SDOPackage.ConfigurationSet(
            "mode0",
            "",
            [
                SDOPackage.NameValue("int_param0", omniany.to_any("1")),
                SDOPackage.NameValue("int_param1", omniany.to_any(5)),
            ],
        )
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
        self.assertEqual(
            [config.remove_configuration_set(s) for s in ("default", "added", "nosuch", "mode0")], [False] * 4
        )
        config.activate_configuration_set("default")
        self.assertTrue(config.remove_configuration_set("added"))


class Cpp11(Components, flavours.Cpp11, unittest.TestCase):
    pass


class Cpp12(Components, flavours.Cpp12, unittest.TestCase):
    pass


class Cpp2(Components, flavours.Cpp2, unittest.TestCase):
    pass


class Py2(Components, flavours.Py2, unittest.TestCase):
    pass


if __name__ == "__main__":
    unittest.main()
