"""Worlds of mock components: what they are for (time, faults, counting, odd names), and how they start and
end.
"""
import os
import signal
import subprocess
import sys
import threading
import time
import types
import unittest

import processes
import worlds
from answers import outcome, raised, value
from worlds import connector, eventually

ONCE = "mocks are used by the transcripts on every Python"
try:
    import CosNaming
    import omniORB
    from mock_components import context
    from mock_components.flavour import Flavour
    from mock_components.idl import RTC, OpenRTM
except ImportError:
    pass        # then setUpModule skips all


def setUpModule():
    worlds.start_name_server()


def tearDownModule():
    worlds.Server.stop()


class Part:
    """A component, its reference and its process; its context has a thread when `begin` is called."""

    busy = False
    takes = 0.0
    executed = 0.0
    observers = types.SimpleNamespace(registered={})

    def __init__(self):
        self.reference = self
        self.begin = None

    def thread(self, target, *args):
        self.begin = threading.Thread(target=target, args=args, daemon=True).start

    def _is_equivalent(self, other):
        return other is self

    def on_activated(self, handle):
        return RTC.RTC_OK


class HeldUp(unittest.TestCase):
    """On a busy machine a thread of a mock may be held up for seconds: what others see is the same."""

    def setUp(self):
        self.part = Part()
        self.context = context.Behaviour(self.part, Flavour("cpp2"), 10.0)
        self.context.own(self.part, self.part, 0)
        self.addCleanup(self.context.close)

    def test_transition(self):
        codes = []
        caller = threading.Thread(
            target=lambda: codes.append(self.context.activate_component(self.part)), daemon=True
        )
        caller.start()
        caller.join(0.8)  # a component that takes so long gets RTC_ERROR
        self.assertEqual(codes, [])
        self.part.begin()
        caller.join(60)
        self.assertEqual(codes, [RTC.RTC_OK])

    def test_cycles(self):
        member = self.context.members[0]
        self.assertEqual(self.context.overdue(self.part), 0)
        member.state = RTC.ACTIVE_STATE
        member.history = [(time.monotonic() - 3.05, member.state)]
        self.assertGreater(self.context.overdue(self.part), 20)
        self.part.executed = time.monotonic()
        self.assertLessEqual(self.context.overdue(self.part), 0)


class Worlds(unittest.TestCase):
    """What worlds are for: time, faults, counting, names."""

    def world(self, *words):
        world = worlds.World(*words)
        self.addCleanup(world.close)
        return world

    def test_slow_transitions(self):
        """RTC_ERROR after half a second, and the change later; a context of 1 Hz takes up to a second."""
        world = self.world("slow")
        component = world.component("Slow0")
        context = world.context("Slow0")
        start = time.monotonic()
        self.assertEqual(str(context.activate_component(component)), "RTC_ERROR")
        self.assertGreater(time.monotonic() - start, 0.45)
        eventually(lambda: context.get_component_state(component) == RTC.ACTIVE_STATE, "active in the end")
        component = world.component("Lazy0")
        context = world.context("Lazy0")
        self.assertEqual(str(context.activate_component(component)), "RTC_OK")

    def test_transitions_that_answer_at_once(self):
        """C++ 1.1, and contexts with sync_transition NO, change later than they answer."""
        for words in (("--flavour", "cpp11"), ("--async",)):
            world = self.world("slow", *words)
            component = world.component("Slow0")
            context = world.context("Slow0")
            self.assertEqual([str(context.activate_component(component)) for _ in range(2)], ["RTC_OK"] * 2)
            self.assertEqual(context.get_component_state(component), RTC.INACTIVE_STATE)
            eventually(
                lambda: context.get_component_state(component) == RTC.ACTIVE_STATE, "active in the end"
            )

    def test_rtorb(self):
        """RtORB's bare names, one connection a port, no ids of others."""
        world = self.world("two", "--flavour", "rtorb")
        out = world.port("ConsoleIn0", "out")
        inp = world.port("ConsoleOut0", "in")
        profile = out.get_port_profile()
        self.assertEqual(
            (profile.name, value(profile.properties, "dataport.data_type")), ("out", "TimedLong")
        )
        self.assertEqual(outcome(out.connect, connector([out, inp], "mine")), "PRECONDITION_NOT_MET")
        self.assertEqual(outcome(out.connect, connector([out, inp], dataflow_type="pull")), "BAD_PARAMETER")
        self.assertEqual(
            [outcome(out.connect, connector([out, inp])) for _ in range(2)], ["RTC_OK", "RTC_ERROR"]
        )
        self.assertEqual(len(inp.get_connector_profiles()), 1)

    def test_java(self):
        """Java asks the other ports for doubles, and shows the last value."""
        world = self.world("two", "--flavour", "java")
        out = world.port("ConsoleIn0", "out")
        inp = world.port("ConsoleOut0", "in")
        codes = [outcome(out.connect, connector([out, inp])) for _ in range(2)]
        self.assertEqual(codes, ["RTC_OK", "PRECONDITION_NOT_MET"])
        world.ctl("write", "ConsoleIn0:out", "5")
        self.assertEqual(value(out.get_port_profile().properties, "dataport.data_value").data, 5)

    def test_port_connected_to_itself(self):
        """It never answers again in C++ 2.x."""
        world = self.world("two", "--flavour", "cpp2")
        port = world.port("ConsoleIn0", "out")
        omniORB.setClientCallTimeout(port, 200)
        self.assertEqual(raised(port.connect, connector([port, port])), "TIMEOUT")
        self.assertEqual(raised(port.get_port_profile), "TIMEOUT")
        self.assertIsNone(raised(world.component("ConsoleOut0").get_ports))

    def test_everything_runs(self):
        """Every type that can be active is, and goes on; the robot's data goes round."""
        world = self.world("robot")
        for name in ("Sensor0", "Controller0", "Motor0", "Hokuyo_AIST0", "Clusterer0"):
            self.assertEqual(str(world.context(name).activate_component(world.component(name))), "RTC_OK")
        for port in ("Sensor0:in", "Controller0:in", "Motor0:in", "Clusterer0:ranges"):
            world.ctl("received", port, "3")
        for name in ("Sensor0", "Hokuyo_AIST0"):
            self.assertEqual(str(world.context(name).deactivate_component(world.component(name))), "RTC_OK")
        self.assertTrue(self.world("all").ready.startswith("ready "))

    def test_errors(self):
        world = self.world("error")
        component = world.component("Err0")
        context = world.context("Err0")
        self.assertEqual(str(context.activate_component(component)), "RTC_OK")
        eventually(lambda: context.get_component_state(component) == RTC.ERROR_STATE, "error")

    def test_active_before_error(self):
        """A component that fails to become active is Active for a period of its context; RtORB knows at once.
        """
        for flavour in ("cpp11", "cpp12", "cpp2", "py2", "java"):
            world = self.world("error", "--flavour", flavour, "--rate", "5")
            component = world.component("ErrStart0")
            context = world.context("ErrStart0")
            self.assertEqual(str(context.activate_component(component)), "RTC_OK")
            eventually(lambda: context.get_component_state(component) == RTC.ACTIVE_STATE, "active")
            eventually(lambda: context.get_component_state(component) == RTC.ERROR_STATE, "error")
        world = self.world("error", "--flavour", "rtorb")
        component = world.component("ErrStart0")
        context = world.context("ErrStart0")
        context.activate_component(component)
        self.assertEqual(context.get_component_state(component), RTC.ERROR_STATE)

    def test_participating(self):
        """A context of another component has handle 1000, and leaves again."""
        world = self.world("contexts")
        multi = world.component("Multi0")
        driver = world.context("Driver0")
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
        component = world.component("ConsoleIn0")
        port = world.port("ConsoleIn0", "out")
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
        calls = world.ctl("calls").split()
        self.assertEqual(calls, ["1", "_is_a", "1", "_non_existent", "1", "get_component_profile"])
        self.assertEqual(world.ctl("calls", "ConsoleOut0"), "")
        self.assertEqual(world.ctl("highwater"), "1\n")
        world.ctl("reset")
        self.assertEqual(world.ctl("calls"), "")

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
        self.assertIsNone(raised(world.component("ConsoleIn0").get_ports))
        world.ctl("delay", "get_ports", "0.3")
        start = time.monotonic()
        component = world.component("ConsoleIn0")
        threads = [threading.Thread(target=component.get_ports) for _ in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertGreaterEqual(time.monotonic() - start, 0.3)
        self.assertEqual(world.ctl("highwater"), "3\n")
        self.assertRaises(processes.Failed, world.ctl, "nonsense")
        self.assertRaises(processes.Failed, world.ctl, "fail", "get_ports", "1", "NOSUCH")

    def test_keys(self):
        """A component of 2.x answers under a key, but its contexts do not know that reference."""
        given = str(processes.nameserver.free_port())
        world = self.world("two", "--port", given)
        port = value(
            world.component("ConsoleIn0").get_component_profile().properties, "corba.endpoints"
        ).split(":")[1]
        self.assertEqual(port, given)
        by_key = worlds.Server.orb.string_to_object(
            "corbaloc:iiop:1.2@127.0.0.1:%s/example.ConsoleIn0" % port
        )
        by_key = by_key._unchecked_narrow(OpenRTM.DataFlowComponent)
        context, = by_key.get_owned_contexts()
        self.assertEqual(str(context.activate_component(by_key)), "BAD_PARAMETER")
        self.assertEqual(context.get_component_state(by_key), RTC.CREATED_STATE)

    def test_hung_and_zombies(self):
        hung = self.world("hung", "2")
        component = hung.component("Mock1")
        omniORB.setClientCallTimeout(component, 200)
        eventually(lambda: raised(component.get_ports) == "TIMEOUT", "stopped")
        zombie = self.world("zombie", "2")
        zombie.process.wait(worlds.LIMIT)
        self.assertEqual(raised(zombie.resolve("Mock1.rtc")._non_existent), "TRANSIENT")

    def test_names(self):
        world = self.world("names")
        home = worlds.Server.root.resolve([CosNaming.NameComponent("test", "host_cxt")])
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
        for end in (lambda world: world.process.send_signal(signal.SIGTERM), lambda world: world.ctl("exit")):
            world = self.world("two")
            world.component("ConsoleIn0")
            end(world)
            self.assertEqual(world.process.wait(worlds.LIMIT), 0)
            self.assertEqual(raised(world.resolve, "ConsoleIn0.rtc"), "NotFound")

    def test_end_of_input(self):
        """A world ends with the process that has started it."""
        words = ["two", "--nameserver", "127.0.0.1:%d" % worlds.Server.port]
        done = subprocess.run(
            [sys.executable, "-m", "mock_components"] + words,
            input=b"",
            env=worlds.ENVIRONMENT,
            stdout=subprocess.PIPE,
            timeout=worlds.LIMIT,
        )
        self.assertEqual(done.stdout, b"ready 2\n")
        self.assertEqual(done.returncode, 0)

    def test_many_start_quickly(self):
        world = self.world("many", "200")
        self.assertEqual(world.ready, "ready 200\n")
        with open("/proc/%d/stat" % world.process.pid) as file:
            ticks = file.read().rpartition(")")[2].split()[11:13]
        self.assertLess(sum(map(int, ticks)) / os.sysconf("SC_CLK_TCK"), 5, "seconds of processor time")

    def test_formats(self):
        """--context takes several formats; missing contexts are made."""
        world = self.world("two", "--context", "test.host_cxt/deep.area_cxt/%n.rtc, test.host_cxt/%t.rtc")
        self.assertTrue(
            world.resolve("deep.area_cxt", "ConsoleIn0.rtc")._is_equivalent(world.resolve("ConsoleIn.rtc"))
        )


if __name__ == "__main__":
    unittest.main()
