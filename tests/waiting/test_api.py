"""rtshell_lite.api, as programs use it: if one of these fails, somebody's launch script does."""
import asyncio
import contextlib
import math
import os
import re
import signal
import subprocess
import sys
import tempfile
import threading
import traceback
import unittest

import processes
import tools
import worlds
from rtshell_lite import api, errors
from rtshell_lite.net import loop
from rtshell_lite.robot import contexts, tree

ROOT = processes.ROOT
DOCS = os.path.join(ROOT, "docs")
EXAMPLES = ["example_test.py", "example_launch.py", "example_log.py"]
PUBLIC = [
    "rtshell_lite.api", "rtshell_lite.mocks", "rtshell_lite.xmlprofile.model",
    "rtshell_lite.xmlprofile.fields",
]

# What a host finds after it has used the library: its signals, and its ORB with calls that may take as long
# as they like
HOST = """
import os, signal, sys, time
from omniORB import CORBA
import CosNaming
orb = CORBA.ORB_init(["host", "-ORBtraceLevel", "0"], CORBA.ORB_ID)
before, bell = signal.getsignal(signal.SIGINT), os.pipe()[1]
os.set_blocking(bell, False)
signal.set_wakeup_fd(bell)
signal.setitimer(signal.ITIMER_REAL, 1000)
from rtshell_lite import api
api.set_timeout(2)
assert api.component(sys.argv[1]).state == "Inactive"
from mock_components import asking
assert asking.request(sys.argv[2], ["delay", "_non_existent", "2.6"])[0]
found = orb.string_to_object("corbaname::%s#test.host_cxt/ConsoleIn0.rtc" % sys.argv[1].split("/")[1])
begun = time.monotonic()
assert not found._non_existent() and time.monotonic() - begun > 2.5
assert signal.getsignal(signal.SIGINT) is before and signal.default_int_handler is before
assert signal.set_wakeup_fd(-1) == bell and signal.getitimer(signal.ITIMER_REAL)[0] > 900
print("as before")
"""

# A host that serves a component of its own, as programs with OpenRTM-aist-Python do, and uses the library
# from its threads
SERVING = """
import sys, threading
from mock_components import __main__ as mocks, flavour, naming, process, stage, worlds
here = process.Process(0, "127.0.0.1", None)
options = mocks.Options(context="test.host_cxt/%n.rtc", rate=1000.0, sync=True, contexts=1, running=True, arguments={}, control=None,
                        consumers=None, size=0, fate="")
worlds.WORLDS["these"](stage.Stage(here, naming.Naming(here, sys.argv[2]), flavour.Flavour("py2"), options), "Motor:Own0")
from rtshell_lite import api
own, other = (api.component(sys.argv[1] + name) for name in ("Own0.rtc", "ConsoleIn0.rtc"))
def use(component, said):
    component.activate(wait=20)
    said.append(component.state)
    component.deactivate(wait=20)
said = []
threads = [threading.Thread(target=use, args=(component, said)) for component in (own, other)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
with api.connected(own.path + ":out", sys.argv[1] + "ConsoleOut0.rtc:in"):
    said.append(len(own.ports()[0].connections) + len(own.ports()[1].connections))
print(*said, flush=True)
__import__("os")._exit(0)
"""  # noqa: E501

# Ctrl-C while the library waits for values: Python's own handler, then the host's
INTERRUPTED = """
import os, signal, sys, threading, time
from rtshell_lite import api
def wait(seconds):
    press = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    begun = time.monotonic()
    try:
        press.start()
        api.next_value(sys.argv[1], timeout=seconds)
    except KeyboardInterrupt:
        return "KeyboardInterrupt"
    except api.Error as e:
        return e.why
    finally:
        assert time.monotonic() - begun < 20
        press.join()
print(wait(60), len(api.component(sys.argv[1].partition(":out")[0]).ports()[0].connections))
heard = []
signal.signal(signal.SIGINT, lambda number, frame: heard.append(number))
print(wait(0.6), heard)
"""


class World(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        worlds.start_name_server()
        cls.world = worlds.World("console")
        cls.configured = worlds.World("config")
        cls.home = "/127.0.0.1:%d/test.host_cxt/" % worlds.Server.port

    @classmethod
    def tearDownClass(cls):
        cls.world.close()
        cls.configured.close()
        worlds.Server.stop()

    def test_configuration(self):
        found = api.component(self.home + "ConfigSample0.rtc")
        self.assertEqual(found.configuration("mode0")["int_param0"], "12345")
        found.configure({"int_param0": 7}, "mode0")
        found.activate_set("mode0")
        self.assertEqual(found.configuration(), found.configuration("mode0"))
        self.assertEqual(found.configuration()["int_param0"], "7")
        with self.assertRaises(errors.NoSuch):
            found.configure({"nonsense": "1"})

    def test_states_and_ports(self):
        sink = api.component(self.home + "ConsoleOut0.rtc")
        self.assertEqual(sink.state, "Inactive")
        sink.activate(wait=10)
        self.assertEqual(sink.state, "Active")
        sink.deactivate(wait=10)
        self.assertEqual(
            [(port.path, port.type) for port in sink.ports()], [(sink.path + ":in", "DataInPort")]
        )
        with self.assertRaises(api.Error) as caught:
            sink.activate(context=7)
        self.assertEqual((caught.exception.where, caught.exception.status), (sink.path, 3))

    def test_inactive_is_inactive_in_every_context(self):
        source, sink = (api.component(self.home + name) for name in ("ConsoleIn0.rtc", "ConsoleOut0.rtc"))

        async def move(change):
            await change(await tree.component(source.path), 0, await tree.component(sink.path))
        loop.run(move(contexts.attach))
        self.addCleanup(lambda: loop.run(move(contexts.detach)))
        sink.activate(wait=10, context=1)
        sink.activate(wait=10)
        self.assertEqual(self.world.ctl("state", "ConsoleOut0"), "INACTIVE\n")  # in its own
        self.assertEqual(sink.state, "Active")
        sink.deactivate(wait=10)
        self.assertEqual(sink.state, "Inactive")

    def test_connections_and_values(self):
        source, sink = (api.component(self.home + name) for name in ("ConsoleIn0.rtc", "ConsoleOut0.rtc"))
        one = source.path + ":out"
        other = sink.path + ":in"
        with api.connected(one, other, subscription_type="flush") as made:
            self.assertEqual(source.ports()[0].connections, [made])
        self.assertEqual(source.ports()[0].connections, [])
        made = api.connect(one, other, **{"dataport.subscription_type": "new"})
        self.assertEqual(api.disconnect(one, other), 1)
        self.assertEqual(api.disconnect(one), 0)
        sink.activate(wait=10)
        api.send(other, 42)
        self.assertIn("42", self.world.ctl("received", "ConsoleOut0:in", "1"))
        sink.deactivate(wait=10)
        with self.assertRaises(errors.Failed):
            api.send(other, {"data": 42})

    def test_values_come_until_the_generator_is_closed(self):
        port = self.home + "ConsoleIn0.rtc:out"
        came = []

        def read():
            came.append(api.next_value(port, timeout=worlds.LIMIT).data)
        reader = threading.Thread(target=read)
        reader.start()
        number = 0
        while reader.is_alive():
            number += 1
            self.world.ctl("write", "ConsoleIn0:out", str(number))
        self.assertTrue(1 <= came[0] <= number)
        self.assertEqual(api.component(self.home + "ConsoleIn0.rtc").ports()[0].connections, [])
        with self.assertRaisesRegex(errors.Unreachable, "no value within 0.3s"):
            api.next_value(port, timeout=0.3)

    def test_under_asyncio_values_and_events_are_awaited_while_others_go_on(self):
        source = self.home + "ConsoleIn0.rtc"
        port = source + ":out"

        async def write():
            number = 0
            while True:
                number += 1
                await here.run_in_executor(None, self.world.ctl, "write", "ConsoleIn0:out", str(number))

        async def read():
            writer = asyncio.ensure_future(write())
            stream = api.values(port, timeout=worlds.LIMIT)
            numbers = []
            for _ in range(2):  # it can be awaited again
                coming = stream.__aiter__()
                numbers += [(await coming.__anext__()).data for _ in range(3)]
                await coming.aclose()
            writer.cancel()
            await asyncio.wait([writer])
            self.assertEqual(sorted(numbers), numbers)
            self.assertEqual(await here.run_in_executor(None, api.connections, port), [])
            with self.assertRaisesRegex(errors.Unreachable, "no value within 0.3s"):
                async for _, value in api.values_of([port], timeout=0.3):
                    numbers.append(value)
            with self.assertRaises(errors.NotFound):
                async for value in api.values(self.home + "Nobody0.rtc:out"):
                    numbers.append(value)

        async def watch():
            happened = []
            async for event in api.watch(source, timeout=0.1):
                happened.append(event and event.event)
                if happened == [None]:
                    await here.run_in_executor(None, api.component(source).activate)
                if "ACTIVE" in happened:
                    break
            api.component(source).deactivate(wait=10)

        async def give_up():
            async for value in api.values(port):
                raise AssertionError(value)

        async def main():
            await read()
            await watch()
            given_up = asyncio.ensure_future(give_up())
            await asyncio.wait([given_up], timeout=0.5)
            given_up.cancel()
            await asyncio.wait([given_up], timeout=worlds.LIMIT)
            self.assertTrue(given_up.cancelled())
            self.assertEqual(api.connections(port), [])
        here = asyncio.new_event_loop()
        self.addCleanup(here.close)
        here.run_until_complete(main())
        here.run_until_complete(here.shutdown_asyncgens())

    def test_values_of_several_ports_in_one_loop(self):
        ports = [self.home + "ConsoleIn0.rtc:out", self.home + "SequenceOutComponent0.rtc:Long"]
        numbers = iter(range(1000))
        stop = threading.Event()

        def write():
            while not stop.is_set():
                for port in "ConsoleIn0:out", "SequenceOutComponent0:Long":
                    self.world.ctl("write", port, str(next(numbers)))
        writer = threading.Thread(target=write)
        seen = {}
        with contextlib.closing(api.values_of(ports, timeout=worlds.LIMIT)) as coming:
            writer.start()
            for port, value in coming:
                seen.setdefault(port, []).append(value.data)
                if sorted(seen) == sorted(ports) and min(map(len, seen.values())) > 1:
                    break
        stop.set()
        writer.join()
        for port in ports:
            self.assertEqual(sorted(seen[port]), seen[port])
            self.assertEqual(api.connections(port), [])
        with self.assertRaises(errors.NotFound), contextlib.closing(
            api.values_of([ports[0], self.home + "nosuch.rtc:out"])
        ) as coming:
            next(coming)

    def test_recording_while_a_program_does_something(self):
        ports = [self.home + "ConsoleIn0.rtc:out", self.home + "SequenceOutComponent0.rtc:Long"]
        with tempfile.TemporaryDirectory() as directory:
            name = os.path.join(directory, "run.mcap")
            with api.recording(name, ports):
                for number in range(5):
                    self.world.ctl("write", "ConsoleIn0:out", str(number))
                self.world.ctl("write", "SequenceOutComponent0:Long", "7")
            found = [(entry["port"], entry["value"]["data"]) for entry in api.log(name)]
            self.assertEqual(
                sorted(found), sorted([(ports[0], number) for number in range(5)] + [(ports[1], 7)])
            )
            self.assertEqual([api.connections(port) for port in ports], [[], []])
            with self.assertRaises(ZeroDivisionError), api.recording(name, ports[:1]):
                1 / 0
            self.assertEqual(list(api.log(name)), [])
            with self.assertRaises(errors.NotFound), api.recording(name, [self.home + "nosuch.rtc:out"]):
                self.fail("it began")
            with self.assertRaises(OSError), api.recording(os.path.join(directory, "no", "x"), ports):
                self.fail("it began")
            self.assertEqual([api.connections(port) for port in ports], [[], []])

    def test_a_recording_reports_a_component_that_has_died(self):
        port = "/127.0.0.1:%d/lost.host_cxt/Lost0.rtc:out" % worlds.Server.port
        lost = worlds.World("these", "ConsoleIn:Lost0", "--context", "lost.host_cxt/%n.rtc")
        with tempfile.TemporaryDirectory() as directory:
            name = os.path.join(directory, "run.mcap")
            feed = api._Recording(name, [port], (), {})  # which shows when the death is noticed
            feed.begin()
            lost.ctl("write", "Lost0:out", "42")
            lost.close()
            worlds.eventually(lambda: feed.readers[0].failure, "its death is noticed")
            feed.end()
            with self.assertRaises(errors.Unreachable) as caught:
                feed.check()
            self.assertEqual(caught.exception.where, port)
            self.assertEqual([entry["value"]["data"] for entry in api.log(name)], [42])

    def test_tracebacks_end_where_the_program_called(self):
        """Failures of users show none of the frames below the library's door, and no other failure."""
        def wait():
            return api.next_value(self.home + "ConsoleIn0.rtc:out", timeout=0.1)
        for function in (lambda: api.component(self.home + "nosuch.rtc"), wait):
            try:
                function()
            except api.Error as e:
                said = "".join(traceback.format_exception(type(e), e, e.__traceback__))
            inner = re.findall(r'File ".*/rtshell_lite/(.*)", line', said)
            self.assertEqual(set(inner), {"api.py"}, said)
            self.assertLess(len(inner), 6, said)
            self.assertEqual(said.count("Traceback"), 1, said)

    def test_components_do_not_wait_while_the_program_looks_at_a_value(self):
        coming = api.values(self.home + "ConsoleIn0.rtc:out", timeout=worlds.LIMIT)
        came = threading.Event()

        def write():
            while not came.is_set():
                self.world.ctl("write", "ConsoleIn0:out", "1")
        writer = threading.Thread(target=write)
        writer.start()
        self.assertEqual(next(coming).data, 1)
        came.set()
        writer.join()
        for number in range(2, 5):
            self.world.ctl("write", "ConsoleIn0:out", str(number))
        self.assertEqual(
            [value.data for _, value in zip(range(3), (value for value in coming if value.data > 1))],
            [2, 3, 4],
        )
        coming.close()
        self.assertEqual(api.component(self.home + "ConsoleIn0.rtc").ports()[0].connections, [])

    def test_a_system_is_kept(self):
        one = self.home + "ConsoleIn0.rtc:out"
        other = self.home + "ConsoleOut0.rtc:in"
        api.connect(one, other)
        profile = api.capture(self.home)
        profile.components = [
            each for each in profile.components if each.instance_name in ("ConsoleIn0", "ConsoleOut0")
        ]
        happening = api.keep(profile, timeout=worlds.LIMIT)
        self.addCleanup(happening.close)
        active = set()
        while len(active) < len(profile.components):
            event = next(happening)
            active |= {event.object} if event.done == "Active" else set()
        self.assertEqual(api.disconnect(one, other), 1)
        event = next(happening)
        self.assertEqual(
            (event.object, event.done[:19], event.error), (one[: -len(":out")], "restored connection", None)
        )
        happening.close()
        self.assertEqual(api.disconnect(one, other), 1)
        for each in [
            api.component(port[: -len(":out")] if port == one else port[: -len(":in")])
            for port in (one, other)
        ]:
            self.assertEqual(each.state, "Active")
            each.deactivate(wait=10)

    def test_systems(self):
        with api.connected(self.home + "ConsoleIn0.rtc:out", self.home + "ConsoleOut0.rtc:in"), \
                tempfile.TemporaryDirectory() as directory:
            profile = api.capture(self.home)
            path = os.path.join(directory, "robot.rtsys")
            api.dump_profile(profile, path)
            again = api.load_profile(path)
            self.assertEqual(again, profile)
            self.assertEqual(api.check(again, "Inactive"), [])
            api.disconnect(self.home + "ConsoleIn0.rtc:out")
            self.assertEqual(len(api.check(again, "Inactive")), 1)
            api.restore(path)
            self.assertEqual(api.check(path, "Inactive"), [])
            again.components[0].path_uri += ".gone"
            with self.assertRaises(errors.NotFound):
                api.restore(again)

    def test_absent_objects_raise(self):
        for wait in 0, 0.3:
            with self.assertRaises(errors.NotFound) as caught:
                api.component(self.home + "Nobody0.rtc", wait=wait)
            self.assertEqual(caught.exception.why, "no such path")
        with self.assertRaises(errors.WrongKind):
            api.component(self.home)
        with self.assertRaises(errors.BadPath) as caught:
            api.connect(self.home + "ConsoleIn0.rtc", self.home + "ConsoleOut0.rtc:in")
        self.assertEqual(
            (caught.exception.where, caught.exception.why),
            (self.home + "ConsoleIn0.rtc", "no port specified"),
        )
        for nowhere, kind in ((self.home + "nowhere", errors.NotFound), ("/127.0.0.1:1", errors.Unreachable)):
            with self.assertRaises(kind) as caught:
                api.components(nowhere)
            self.assertEqual(caught.exception.where, nowhere)

    def test_arguments_that_can_never_be_right(self):
        profile = api.capture(self.home)
        with self.assertRaisesRegex(ValueError, "'Inactve'"):
            api.check(profile, "Inactve")
        with tempfile.TemporaryDirectory() as directory, self.assertRaisesRegex(ValueError, "'json'"):
            api.dump_profile(profile, os.path.join(directory, "robot.json"), "json")
        for seconds in -1, 0, math.nan, math.inf:
            with self.assertRaises(ValueError):
                api.set_timeout(seconds)

    def test_where_and_why(self):
        for error, where, why in (
            (errors.Failed("/a.rtc", "broken"), "/a.rtc", "broken"),
            (errors.NotFound("/a.rtc"), "/a.rtc", "no such path"),
            (errors.BadProfile("a.xml", 3, 1, "no text"), "a.xml", "3:1: no text"),
            (errors.Shortage("memory", "none"), "", "out of memory here: none"),
            (errors.Usage("what?"), "", "what? (see --help)"),
        ):
            self.assertEqual((error.where, error.why), (where, why))
        self.assertEqual(errors.MissingOmniORB().where, "")

    def test_several_threads(self):
        states = []

        def ask(name):
            states.append(api.component(self.home + name).state)
        threads = [
            threading.Thread(target=ask, args=(name,)) for name in ("ConsoleIn0.rtc", "ConsoleOut1.rtc") * 4
        ]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(worlds.LIMIT)
        self.assertEqual(states, ["Inactive"] * 8)
        self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)

    def said(self, program, *words):
        """What a program prints, in a process of its own; the library uses its own ORB there, whatever the
        commands use.
        """
        environment = {name: value for name, value in worlds.ENVIRONMENT.items() if name != "RTSHELL_ORB"}
        return subprocess.run(
            [sys.executable, "-c", program] + list(words),
            env=environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            preexec_fn=tools.hear_ctrl_c,
        ).stdout.decode()

    def test_a_host_keeps_its_signals_and_deadlines(self):
        self.addCleanup(self.world.ctl, "reset")
        control = tools.control(self.world.name)
        self.assertEqual(self.said(HOST, self.home + "ConsoleIn0.rtc", control), "as before\n")

    def test_a_host_that_serves_components_itself(self):
        self.assertEqual(
            self.said(SERVING, self.home, "127.0.0.1:%d" % worlds.Server.port), "Active Active 1\n"
        )

    def test_ctrl_c(self):
        """It ends a wait as the host has it, and leaves no connection."""
        self.assertEqual(self.said(INTERRUPTED, self.home + "ConsoleIn0.rtc:out"),
                         "KeyboardInterrupt 0\nno value within 0.6s [2]\n")


class Services(unittest.TestCase):
    """Operations of a service port as functions."""

    IDL = [os.path.join(ROOT, "mock_components", "robot.idl")]

    @classmethod
    def setUpClass(cls):
        worlds.start_name_server()
        cls.world = worlds.World("these", "Robot")
        cls.path = "/127.0.0.1:%d/test.host_cxt/Robot0.rtc" % worlds.Server.port
        api.component(cls.path).activate(wait=10)

    @classmethod
    def tearDownClass(cls):
        cls.world.close()
        worlds.Server.stop()

    def test_call(self):
        port = self.path + ":svc"
        self.assertEqual(api.call(port, "say", "\u65e5\u672c", idl=self.IDL), "\u65e5\u672c")
        where, distance = api.call(port, "move_to", {"x": 3, "y": 4}, 0.0, idl=self.IDL)
        self.assertEqual((where.x, where.y, distance), (3.0, 4.0, 5.0))
        self.assertIsNone(api.call(port, "rest", 0.0, idl=self.IDL))
        self.assertEqual(api.call(self.path, "get_sdo_id"), "Robot0")
        for what, words, kind in (
            ("say", (), errors.BadValue),
            ("say", ("a", "b"), errors.Usage),
            ("sey", ("a",), errors.NoSuch),
            ("rest", ("a",), errors.BadValue),
        ):
            with self.assertRaises(kind):
                api.call(port, what, *words, idl=self.IDL)
        with self.assertRaises(errors.NoSuch):  # its IDL is not known
            api.call(port, "say", "a")
        with self.assertRaises(errors.MayBeDone) as caught:
            api.call(port, "rest", 5.0, idl=self.IDL, limit=0.2)
        self.assertEqual(caught.exception.status, 4)

    def test_service(self):
        arm = api.service(self.path + ":svc.arm", self.IDL)
        arm._set_speed(3.5)
        self.assertEqual(arm._get_speed(), 3.5)
        # what it returns can be given back
        where, _ = arm.move_to(seconds=0, goal=arm.move_to({"x": 1, "y": 2}, 0)[0])
        self.assertEqual(str(arm.turn([where.x], False)[1]), "MOVING")
        self.assertEqual(arm.keep({"_type": "long", "_value": 7}).content, 7)
        with self.assertRaises(errors.Raised) as caught:
            arm.move_to({"x": 30, "y": 4}, 0)
        self.assertEqual((caught.exception.name, caught.exception.value.nearest.x), ("OutOfReach", 10.0))
        self.assertIn("say", dir(arm))
        with self.assertRaises(AttributeError):
            arm.sey
        self.assertEqual(api.component(self.path).ports()[0].connections, [])
        with self.assertRaises(errors.NoSuch):
            api.service(self.path + ":svc", self.IDL)  # it has two interfaces
        with self.assertRaises(errors.NoSuch):
            api.service(self.path + ":svc.arm")


class Robot(unittest.TestCase):
    """Managers, execution contexts, connections, events, plans."""

    @classmethod
    def setUpClass(cls):
        worlds.start_name_server()
        cls.worlds = [
            worlds.World("console"),
            worlds.World("manager", "Motor", "--context", "m.host_cxt/%n.rtc"),
            worlds.World("zombie", "--context", "dead.host_cxt/%n.rtc"),
        ]
        cls.server = "/127.0.0.1:%d" % worlds.Server.port
        cls.home = cls.server + "/test.host_cxt/"

    @classmethod
    def tearDownClass(cls):
        for world in cls.worlds:
            world.close()
        worlds.Server.stop()

    def test_a_manager_creates_and_deletes(self):
        (path,) = api.find("manager.mgr", self.server)
        manager = api.manager(path)
        self.assertIn("Motor", [module["implementation_id"] for module in manager.modules()])
        made = manager.create("Motor", instance_name="left")
        self.assertEqual((made.state, made.profile()["instance_name"]), ("Inactive", "left"))
        self.assertIn(made.path, [component.path for component in manager.components()])
        manager.delete("left")
        self.assertNotIn(made.path, [component.path for component in manager.components()])
        with self.assertRaises(errors.NoSuch):
            manager.delete("left")
        with self.assertRaises(errors.NotFound):
            api.manager(self.home + "nosuch.mgr")

    def test_connections_are_objects(self):
        one = self.home + "ConsoleIn0.rtc:out"
        other = self.home + "ConsoleOut0.rtc:in"
        made = api.connect(one, other, subscription_type="flush")
        (connection,) = api.component(self.home + "ConsoleIn0.rtc").connections()
        self.assertEqual((connection.id, sorted(connection.ports)), (made, [one, other]))
        self.assertEqual(connection.properties["dataport.subscription_type"], "flush")
        self.assertEqual([each.id for each in api.connections(other)], [made])
        connection.remove()
        self.assertEqual(api.connections(one), [])
        with self.assertRaises(errors.NoSuch):
            connection.remove()

    def test_execution_contexts(self):
        source, sink = (api.component(self.home + name) for name in ("ConsoleIn0.rtc", "ConsoleOut0.rtc"))
        source.set_rate(500)
        (context,) = source.contexts()
        self.assertEqual((context.number, context.kind, context.rate, context.running, context.state),
                         (0, "Periodic", 500, True, "Inactive"))
        source.stop()
        self.assertFalse(source.contexts()[0].running)
        source.start()
        source.attach(sink)
        self.assertEqual([context.owner for context in sink.contexts()], ["ConsoleOut0", "ConsoleIn0"])
        source.detach(sink)
        self.assertEqual(len(sink.contexts()), 1)

    def test_events(self):
        path = self.home + "SequenceInComponent0.rtc"
        with contextlib.closing(api.watch(path, timeout=worlds.LIMIT)) as happening:
            event = next(happening)  # a heartbeat: it is being watched
            threading.Thread(target=api.component(path).activate).start()
            while event is not None and "ACTIVE" not in event.event:
                event = next(happening)
        self.assertEqual(event.path, path)
        api.component(path).deactivate(wait=10)
        with self.assertRaises(errors.NotFound), contextlib.closing(
            api.watch(self.home + "nosuch.rtc")
        ) as happening:
            next(happening)

    def test_a_system_is_started_and_stopped(self):
        profile = api.capture(self.home, unconnected=True)
        profile.components = [each for each in profile.components if each.instance_name.startswith("Console")]
        api.start(profile, wait=10)
        self.assertEqual(api.component(self.home + "ConsoleIn0.rtc").state, "Active")
        api.stop(profile, wait=10)
        self.assertEqual(api.component(self.home + "ConsoleIn0.rtc").state, "Inactive")
        profile.components[0].path_uri += ".gone"
        with self.assertRaises(errors.NotFound):
            api.start(profile)

    def test_what_rtdoctor_finds(self):
        found = api.examine(self.home)
        self.assertEqual([each for each in found if each.level == "fail"], [])
        self.assertTrue([each for each in found if each.level == "ok"])
        profile = api.capture(self.home, unconnected=True)
        failed = [each for each in api.examine(self.home, profile=profile) if each.level == "fail"]
        self.assertEqual({each.check for each in failed}, {"profile"})
        (nowhere,) = [each for each in api.examine("/127.0.0.1:1") if each.level == "fail"]
        self.assertEqual((nowhere.check, nowhere.path), ("name server", "/127.0.0.1:1"))
        self.assertTrue(nowhere.remedy)

    def test_the_dead_are_no_components(self):
        (dead,) = api.zombies(self.server)
        listed = [component.path for component in api.components(self.server)]
        self.assertNotIn(dead, listed)
        self.assertIn(self.home + "ConsoleIn0.rtc", listed)
        with self.assertRaises(errors.Unreachable) as caught:
            api.components(self.server + "/dead.host_cxt")
        self.assertEqual(caught.exception.where, dead)

    def test_names(self):
        self.assertEqual(api.find("ConsoleI*.rtc", self.server), [self.home + "ConsoleIn0.rtc"])
        self.assertEqual(len(api.zombies(self.server)), 1)
        self.assertEqual(api.zombies(self.home), [])
        self.assertEqual(api.component(self.server + "/**/ConsoleIn0.rtc").path, self.home + "ConsoleIn0.rtc")

    def test_a_component_exits(self):
        path = self.home + "ConsoleOut1.rtc"
        api.component(path).exit(wait=10)
        with self.assertRaises(errors.NotFound):
            api.component(path)


class Documents(unittest.TestCase):
    def test_the_examples(self):
        worlds.start_name_server()
        worlds.Server.stop()
        for name in EXAMPLES:
            with self.subTest(example=name):
                done = subprocess.run([sys.executable, os.path.join(DOCS, name)], env=worlds.ENVIRONMENT,
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
                self.assertEqual(done.returncode, 0, done.stdout.decode())


if __name__ == "__main__":
    unittest.main()
