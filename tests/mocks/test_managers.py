"""Mock managers: whether they answer as the managers of each implementation do, slaves and their death
included.

If this fails, the transcripts of rtmgr prove nothing.
"""
import unittest

import processes
import worlds
from answers import outcome, raised, value
from worlds import eventually

ONCE = "mocks are used by the transcripts on every Python"
try:
    from mock_components.idl import RTC, RTM
except ImportError:
    pass        # then setUpModule skips all

CREATED = ["Motor", "Sensor", "Controller"]      # what managers have loaded from the start


def setUpModule():
    worlds.start_name_server()


def tearDownModule():
    worlds.Server.stop()


def manager_of(world):
    return world.resolve("manager.mgr")._narrow(RTM.Manager)


def ids(components):
    return [component.get_sdo_id() for component in components]


def made(manager, line):
    """The instance name of what create_component gives; None for nil."""
    component = manager.create_component(line)
    return component and component.get_sdo_id()


def values(profiles, name):
    """That property of each profile; None where it lacks."""
    return [
        next((item.value.value() for item in profile.properties if item.name == name), None)
        for profile in profiles
    ]


class Flavoured:
    """A world with a master, and what its implementation does."""

    words = ()
    starts = True
    sticky = False
    twins = 2
    tries_elsewhere = 0             # slaves that are started for what no slave can make, and stay
    unknown = "BAD_PARAMETER"
    pid = str
    copies = 2                      # of a module that master and slave have, in the master's list
    long_form = "RTC:::Controller::"
    other_form = "RTC:::Controller:"
    suffix = ".so"
    missing = []

    @classmethod
    def setUpClass(cls):
        cls.world = worlds.World("manager", *cls.words)
        cls.master = manager_of(cls.world)
        cls.maker = cls.hosting()

    @classmethod
    def hosting(cls):
        """The manager in whose process components live."""
        return cls.master.get_slave_managers()[0]

    @classmethod
    def tearDownClass(cls):
        cls.world.close()

    # roles

    def test_addresses(self):
        """The master is bound, and is the same object under its key on the port that the world names."""
        port = self.world.ctl("port").strip()
        self.assertEqual(self.world.ready.split()[-1], port)
        by_key = worlds.Server.orb.string_to_object("corbaloc:iiop:1.2@127.0.0.1:%s/manager" % port)
        self.assertTrue(by_key._is_equivalent(self.master))
        self.assertTrue(self.master.is_master())
        self.assertEqual(self.master.get_master_managers(), [])

    def test_profile(self):
        profile = self.master.get_profile()
        self.assertEqual((value(profile.properties, "name"), value(profile.properties, "instance_name"),
                          value(profile.properties, "is_master")), ("manager", "manager", "YES"))
        self.assertIsInstance(value(profile.properties, "pid"), self.pid)
        known = [item.name for item in profile.properties]
        self.assertEqual([name for name in ("refstring_path", "components.precreate", "modules.config_path")
                          if name not in known], self.missing)
        names = [item.name for item in self.master.get_configuration()]
        self.assertEqual(names[:3], ["config.version", "openrtm.name", "openrtm.version"])
        self.assertTrue(set("manager." + name for name in known) < set(names))

    def test_configuration(self):
        """Always RTC_OK, though what is read at the start stays."""
        for name, after in (("foo.bar", "1"), ("manager.name", "manager")):
            self.assertEqual(str(self.master.set_configuration(name, "1")), "RTC_OK")
            self.assertEqual(value(self.master.get_configuration(), name), after)

    # modules

    def test_modules(self):
        """load_module never says no; unload_module wants the very path."""
        path = value(self.maker.get_loaded_modules()[0].properties, "file_path")
        self.assertTrue(path.startswith("/") and path.endswith("/Motor" + self.suffix), path)
        before = values(self.maker.get_loaded_modules(), "file_path")
        self.assertEqual(str(self.maker.load_module("/nowhere/x.so", "xInit")), "RTC_OK")
        self.assertEqual(values(self.maker.get_loaded_modules(), "file_path"), before)
        self.assertEqual(str(self.maker.load_module("SeqIn" + self.suffix, "SeqInInit")), "RTC_OK")
        loaded = values(self.maker.get_loaded_modules(), "file_path")
        self.assertEqual(len(loaded), len(before) + 1)
        self.assertEqual(outcome(self.maker.unload_module, "SeqIn" + self.suffix), "UNKNOWN")
        self.assertEqual(outcome(self.maker.unload_module, loaded[-1]), "RTC_OK")
        self.assertEqual(values(self.maker.get_loaded_modules(), "file_path"), before)

    def test_factories(self):
        """The composite first; then by implementation id, which need not be the type."""
        self.maker.load_module("SeqOut" + self.suffix, "SeqOutInit")
        profiles = self.maker.get_factory_profiles()
        self.assertEqual(values(profiles, "implementation_id")[:4], ["PeriodicECSharedComposite"] + CREATED)
        at = values(profiles, "implementation_id").index("SeqOut")
        self.assertEqual(values(profiles, "type_name")[at], "SequenceOutComponent")
        self.assertEqual(values(profiles, "max_instance")[:2], ["0", "10"])
        self.assertIsNone(made(self.maker, "SequenceOutComponent"))
        self.assertEqual(made(self.maker, "SeqOut"), "SequenceOutComponent0")

    def test_loadable(self):
        """One per file, with its path; Python's lack one vendor."""
        profiles = self.master.get_loadable_modules()
        names = values(profiles, "module_file_name")
        self.assertIn("ConsoleIn" + self.suffix, names)
        self.assertEqual(values(profiles, "module_file_path")[0].rpartition("/")[2], names[0])
        self.assertEqual([name for name, vendor in zip(names, values(profiles, "vendor")) if vendor is None],
                         ["Sensor.py"] if self.suffix == ".py" else [])

    # creating and deleting

    def test_identifiers(self):
        """The long form has five fields or six; fields may be empty, but not wrong."""
        self.assertEqual(made(self.master, self.long_form), "Controller0")
        for line in (
            self.other_form,
            self.long_form.replace(":::", "::nocategory:"),
            self.long_form + "?a=b?c=d",
            "",
            "Nope",
        ):
            self.assertIsNone(made(self.master, line), line)
        slaves = self.master.get_slave_managers()
        new = [slave for slave in slaves if not slave.get_components()]
        self.assertEqual(len(new), self.tries_elsewhere)
        for slave in new:
            slave.shutdown()
            worlds.eventually(lambda: len(self.master.get_slave_managers()) < len(slaves), "one less")

    def test_arguments(self):
        """Blanks are trimmed, what is no pair is dropped, keys are properties of the component."""
        name = made(self.master, "Motor?& instance_name = arm &nonsense&a=b=c&conf.default.motor_id=7&"
                                 "exec_cxt.periodic.rate=5&naming.formats=elsewhere.cxt/%n.rtc&x.y=z")
        self.assertEqual(name, "arm")
        component = next(one for one in self.master.get_components() if one.get_sdo_id() == "arm")
        properties = component.get_component_profile().properties
        self.assertEqual([value(properties, key) for key in ("conf.default.motor_id", "naming.names", "x.y")],
                         ["7", "elsewhere.cxt/arm.rtc", "z"])
        context = component.get_owned_contexts()[0]
        self.assertEqual(
            (context.get_rate(), context.get_component_state(component)), (5, RTC.INACTIVE_STATE)
        )

    def test_names(self):
        """Numbered by type; Python keeps a name that it was given, and others do not refuse a taken one."""
        self.assertEqual([made(self.master, "Sensor"), made(self.master, "Sensor")], ["Sensor0", "Sensor1"])
        self.assertEqual(made(self.master, "Sensor?instance_name=nose"), "nose")
        after = "nose" if self.sticky else "Sensor2"
        self.assertEqual(made(self.master, "Sensor"), after)
        one, other = [self.master.create_component("Sensor?instance_name=eye") for _ in range(2)]
        self.assertEqual(one._is_equivalent(other), self.twins == 1)
        self.assertEqual(ids(self.maker.get_components()).count("eye"), 1)
        self.assertTrue(self.world.component("eye")._is_equivalent(other))

    def test_a_name_that_the_factory_kept(self):
        """Python makes another one of that name, which it does not list."""
        self.maker.load_module("Clusterer" + self.suffix, "ClustererInit")
        made(self.master, "Clusterer?instance_name=kept")
        component = self.master.create_component("Clusterer")
        self.assertEqual(component.get_sdo_id() == "kept", self.sticky)
        listed = [one for one in self.maker.get_components() if one._is_equivalent(component)]
        self.assertEqual(len(listed), 0 if self.sticky else 1)

    def test_failing_initialisation(self):
        """Nil, as for a wrong argument and for max_instance."""
        self.maker.load_module("Unborn" + self.suffix, "UnbornInit")
        self.assertIsNone(made(self.master, "Unborn"))

    def test_limit(self):
        """max_instance."""
        self.maker.load_module("Mock" + self.suffix, "MockInit")
        names = [made(self.master, "Mock") for _ in range(11)]
        self.assertEqual(names, ["Mock%d" % number for number in range(10)] + [None])

    def test_delete(self):
        """The object is gone at once, lists and name server follow; a master answers for its own only."""
        self.assertEqual(str(self.master.delete_component("Nope0")), self.unknown)
        if self.maker is not self.master:
            self.assertEqual(str(self.master.delete_component("ConsoleIn0")), "BAD_PARAMETER")
        self.maker.load_module("Err" + self.suffix, "ErrInit")
        component = self.master.create_component("Err")
        self.assertEqual(str(self.maker.delete_component("Err0")), "RTC_OK")
        self.assertTrue(component._non_existent())
        self.assertTrue(any(one._non_existent() for one in self.master.get_components()))
        self.assertEqual(str(self.maker.delete_component("Err0")), self.unknown)
        eventually(
            lambda: not any(one._non_existent() for one in self.master.get_components()), "off the list"
        )
        eventually(lambda: raised(self.world.resolve, "Err0.rtc") == "NotFound", "unbound")

    def test_no_effect(self):
        self.assertEqual([str(self.master.fork()), str(self.master.restart()), self.master.get_service("x")],
                         ["RTC_OK", "RTC_OK", None])
        for operation in ("add_slave_manager", "remove_slave_manager", "remove_master_manager"):
            self.assertEqual(str(getattr(self.master, operation)(None)), "BAD_PARAMETER")

    def test_by_name(self):
        for pattern in ("ConsoleIn0", "*/ConsoleIn0", "example/ConsoleIn0"):
            self.assertEqual(ids(self.maker.get_components_by_name(pattern)), ["ConsoleIn0"])
        for manager, pattern in (
            (self.maker, "other/ConsoleIn0"),
            (self.maker, "*"),
            (self.master, "ConsoleIn0"),
        ):
            self.assertEqual(manager.get_components_by_name(pattern), [])


class Slaves(Flavoured):
    """Managers from 1.2 on, which create in slaves."""

    def test_slave(self):
        """It is bound nowhere, listens under its key, and what it has shows at the master."""
        self.assertFalse(self.maker.is_master())
        self.assertEqual(ids(self.maker.get_components()), ids(self.master.get_components()))
        self.assertEqual(
            [p.instance_name for p in self.master.get_component_profiles()], ids(self.master.get_components())
        )
        self.assertTrue(self.maker.get_master_managers()[0]._is_equivalent(self.master))
        self.assertEqual(self.maker.get_slave_managers(), [])
        self.assertEqual(
            values(self.master.get_factory_profiles(), "implementation_id").count("Motor"), self.copies
        )
        port = self.world.ctl("slave", "1", "port").strip()
        by_key = worlds.Server.orb.string_to_object("corbaloc:iiop:1.2@127.0.0.1:%s/manager" % port)
        self.assertTrue(by_key._is_equivalent(self.maker))
        self.assertEqual(str(self.master.add_slave_manager(self.maker)), "BAD_PARAMETER")

    def test_manager_name(self):
        """Of a slave that is there, behind ? as behind &; C++ starts one that is not."""
        self.assertEqual(made(self.master, "Slow?manager_name=manager&instance_name=s1"), "s1")
        self.assertIsNotNone(made(self.master, "Slow&manager_name=manager"))
        self.assertEqual(
            made(self.master, "Motor?manager_name=fresh&instance_name=m2"), "m2" if self.starts else None
        )
        if self.starts:
            (slave,) = [
                slave for slave in self.master.get_slave_managers() if not slave._is_equivalent(self.maker)
            ]
            self.assertEqual(
                (value(slave.get_profile().properties, "instance_name"), ids(slave.get_components())),
                ("fresh", ["m2"]),
            )
            port = "127.0.0.1:" + self.world.ctl("slave", str(2 + self.tries_elsewhere), "port").strip()
            self.assertIsNone(made(self.master, "Motor?manager_address=" + port))
            self.assertEqual(str(slave.shutdown()), "RTC_OK")
            eventually(lambda: len(self.master.get_slave_managers()) == 1, "deregistered")


class Cpp2(Slaves, unittest.TestCase):
    words = ("--flavour", "cpp2")
    tries_elsewhere = 1  # for the unknown name
    missing = ["refstring_path"]
    copies = 1


class Cpp12(Slaves, unittest.TestCase):
    words = ("--flavour", "cpp12")


class Py2(Slaves, unittest.TestCase):
    sticky = True
    twins = 1
    pid = int
    starts = False
    suffix = ".py"
    missing = ["refstring_path", "components.precreate", "modules.config_path"]


class Cpp11(Flavoured, unittest.TestCase):
    """C++ 1.1: the master creates itself, and does not look for modules."""

    words = ("--flavour", "cpp11")
    unknown = "RTC_OK"
    long_form = "RTC:::Controller:"
    other_form = "RTC:::Controller::"

    @classmethod
    def hosting(cls):
        return cls.master

    def test_loadable(self):
        self.assertEqual(self.master.get_loadable_modules(), [])
        self.assertIsNone(made(self.master, "SeqIn"))

    def test_by_name(self):
        self.assertEqual(raised(self.master.get_components_by_name, "ConsoleIn0"), "BAD_OPERATION")


class Worlds(unittest.TestCase):
    """Several slaves, dead ones, and how managers end."""

    def world(self, *words):
        world = worlds.World(*words)
        self.addCleanup(world.close)
        return world, manager_of(world)

    def test_two_slaves(self):
        """Of one name, and in processes of their own."""
        _, master = self.world("managers")
        slaves = master.get_slave_managers()
        profiles = [slave.get_profile() for slave in slaves]
        self.assertEqual(values(profiles, "name"), ["manager"] * 2)
        self.assertEqual(len(set(values(profiles, "pid"))), 2)
        self.assertEqual([ids(slave.get_components()) for slave in slaves], [["ConsoleIn0"], ["ConsoleOut0"]])
        self.assertEqual(ids(master.get_components()), ["ConsoleIn0", "ConsoleOut0"])

    def test_dead_slave(self):
        """It stays listed until the master asks it something."""
        world, master = self.world("deadslave")
        self.assertEqual(
            [outcome(slave.is_master) for slave in master.get_slave_managers()], ["False", "TRANSIENT"]
        )
        self.assertEqual(ids(master.get_components()), ["ConsoleIn0"])
        self.assertEqual(len(master.get_slave_managers()), 1)
        self.assertEqual(raised(world.resolve("ConsoleOut0.rtc")._non_existent), "TRANSIENT")

    def test_dead_component(self):
        """It is listed for ever, and its profile told, though it is gone."""
        _, master = self.world("deadchild")
        self.assertEqual([one._non_existent() for one in master.get_components()], [False, True])
        self.assertEqual(
            [p.instance_name for p in master.get_component_profiles()], ["ConsoleIn0", "ConsoleOut0"]
        )

    def test_shutdown_of_a_slave(self):
        """It reports to its master at once, and ends a little later, names unbound."""
        world, master = self.world("manager")
        slave, = master.get_slave_managers()
        self.assertEqual(str(slave.shutdown()), "RTC_OK")
        self.assertEqual(raised(slave.is_master), None)
        eventually(lambda: master.get_slave_managers() == [], "deregistered")
        eventually(lambda: raised(slave.is_master) in ("TRANSIENT", "COMM_FAILURE"), "ended")
        self.assertEqual(raised(world.resolve, "ConsoleIn0.rtc"), "NotFound")
        self.assertIsNone(made(master, "Motor"))

    def test_shutdown_of_a_master(self):
        """Its slaves live on without it."""
        world, master = self.world("manager")
        slave, = master.get_slave_managers()
        self.assertEqual(str(master.shutdown()), "RTC_OK")
        world.process.wait(worlds.LIMIT)
        self.assertEqual(raised(world.resolve, "manager.mgr"), "NotFound")
        self.assertEqual(
            (ids(slave.get_components()), slave.get_master_managers()), (["ConsoleIn0", "ConsoleOut0"], [])
        )

    def test_twins(self):
        """Two components of one name take C++ 1.x with them, when both have ended."""
        world, master = self.world("manager11")
        self.assertEqual(ids(master.get_components()), ["ConsoleIn0", "ConsoleOut0"])
        self.assertEqual(master.get_slave_managers(), [])
        one, other = [master.create_component("Motor?instance_name=twin") for _ in range(2)]
        self.assertEqual(str(one.exit()), "RTC_OK")
        self.assertFalse(other._non_existent())
        self.assertEqual(str(other.exit()), "RTC_OK")
        self.assertNotEqual(world.process.wait(worlds.LIMIT), 0)

    def test_counting(self):
        """Calls are counted at the manager that gets them, and can be made to fail."""
        world, master = self.world("manager")
        master.get_components()
        self.assertEqual(world.ctl("calls"), "1 get_components\n")
        self.assertEqual(world.ctl("slave", "1", "calls"), "1 get_components\n")
        world.ctl("fail", "get_profile", "1", "COMM_FAILURE")
        self.assertEqual([raised(master.get_profile) for _ in range(2)], ["COMM_FAILURE", None])
        self.assertRaises(processes.Failed, world.ctl, "slave", "2", "calls")


if __name__ == "__main__":
    unittest.main()
