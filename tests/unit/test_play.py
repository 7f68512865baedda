"""Name server and components of recordings, as others call them, in one loop with who calls."""
import json
import os
import signal
import termios
import types
import unittest
from unittest import mock

from loops import wait_for
from rtshell_lite import errors, path
from rtshell_lite.corba import orb, session
from rtshell_lite.giop.requests import Thrown
from rtshell_lite.net import loop
from rtshell_lite.play import bindings, component, nameserver, ports, recording, stage
from rtshell_lite.robot import tree
from rtshell_lite.views import playing
from rtshell_lite.xmlprofile import model, rtsprofile

HOST = "127.0.0.1"
PUSH = [
    ("dataport.dataflow_type", "push"),
    ("dataport.interface_type", "corba_cdr"),
    ("dataport.subscription_type", "flush"),
]
PULL = [("dataport.dataflow_type", "pull"), ("dataport.interface_type", "corba_cdr")]


def name(*words):
    return orb.naming_name(tuple(word.partition(".")[::2]) for word in words)


class Names(unittest.TestCase):
    def run_with_server(self, work):
        """Run work(ask), ask(operation, …) being a call of the root context of a name server."""
        async def main():
            port = orb.listen(HOST, 0)
            nameserver.Names(HOST)
            root = orb.context(orb.corbaloc("w", f"{HOST}:{port}", "NameService", 0))

            async def ask(operation, *args, of=root):
                return await orb.call("w", of, operation, *args)

            await work(ask, root)
        wait_for(main(), timeout=30)

    def refused(self, why):
        return self.assertRaisesRegex(errors.Refused, why)

    def test_names(self):
        async def work(ask, root):
            await ask("bind_new_context", name("a.cxt"))
            await ask("bind", name("a.cxt", "x.rtc"), root)
            with self.refused("AlreadyBound"):
                await ask("bind", name("a.cxt", "x.rtc"), root)
            await ask("rebind", name("a.cxt", "x.rtc"), root)
            found = await ask("resolve", name("a.cxt", "x.rtc"))
            self.assertTrue(orb.same(found, root))
            inner = orb.context(await ask("resolve", name("a.cxt")))
            listed, more = await ask("list", 10, of=inner)
            self.assertEqual(
                [(one.binding_name[0].id, one.binding_name[0].kind, one.binding_type._n) for one in listed],
                [("x", "rtc", "nobject")],
            )
            self.assertIsNone(more)
            for operation, names, why in (
                ("resolve", ("b",), "NotFound"),
                ("resolve", ("a.cxt", "y"), "NotFound"),
                ("resolve", ("a.cxt", "x.rtc", "z"), "NotFound"),
                ("resolve", (), "InvalidName"),
                ("unbind", ("q",), "NotFound"),
                ("bind_new_context", ("a.cxt",), "AlreadyBound"),
            ):
                with self.refused(why):
                    await ask(operation, name(*names))
            with self.refused("NotFound"):  # a context is no object
                await ask("rebind", name("a.cxt"), root)
            with self.refused("NotEmpty"):
                await ask("destroy", of=inner)
            await ask("unbind", name("a.cxt", "x.rtc"))
            await ask("destroy", of=inner)
            with self.assertRaises(errors.Gone):
                await ask("list", 1, of=inner)
        self.run_with_server(work)

    def test_many_names(self):
        async def work(ask, root):
            for number in range(25):
                await ask("bind", name("n%d" % number), root)
            listed, more = await ask("list", 10)
            more = orb.narrow(more, "CosNaming.BindingIterator")
            found = [one.binding_name[0].id for one in listed]
            while True:
                are_there, listed = await ask("next_n", 7, of=more)
                if not are_there:
                    break
                found += [one.binding_name[0].id for one in listed]
            self.assertEqual(found, ["n%d" % number for number in range(25)])
            self.assertEqual((await ask("next_one", of=more))[0], 0)
            await ask("destroy", of=more)
            for _ in range(nameserver.MOST_ITERATORS + 5):
                _, last = await ask("list", 0)
            self.assertEqual(len(await ask("next_n", 1, of=orb.narrow(last, "CosNaming.BindingIterator"))), 2)
        self.run_with_server(work)

    def test_a_name_that_is_refused_keeps_no_other(self):
        async def work(ask, root):
            server = tree.Node(path.parse(f"/{HOST}:1"), "manager", root)
            made = bindings.Bindings(server)
            for word in "abc":
                await made.bind((path.Name("m", "cxt"), path.Name(word, "rtc")), root)
            refuse = nameserver.Context.unbind

            def unbind(context, name):
                if name[-1].id == "b":
                    raise Thrown("NO_PERMISSION")
                refuse(context, name)

            with mock.patch.object(nameserver.Context, "unbind", unbind), mock.patch("sys.stderr"):
                await made.clear()
            listed, _ = await ask("list", 10, of=orb.context(await ask("resolve", name("m.cxt"))))
            self.assertEqual([one.binding_name[0].id for one in listed], ["b"])
        self.run_with_server(work)

    def test_names_are_counted_in_octets(self):
        """60 names of 2 MB made every list of them fail."""
        async def work(ask, root):
            long = "x" * nameserver.LONGEST
            for operation, *more in (
                ("bind", root), ("rebind", root), ("bind_context", root), ("bind_new_context",), ("resolve",),
            ):
                with self.refused("InvalidName"):
                    await ask(operation, name(long + ".y"), *more)
            with self.assertRaises(Thrown):
                nameserver.parsed("x" * (nameserver.LONGEST_TEXT + 1))
            with mock.patch.object(nameserver, "MOST_OCTETS", 5000):
                bound = 0
                with self.refused("NO_RESOURCES"):
                    for bound in range(10):
                        await ask("rebind", name("%s%d" % (long[:900], bound)), root)
                self.assertLess(bound, 6)
                for number in range(bound):
                    await ask("rebind", name("%s%d" % (long[:900], number)), root)
                    await ask("unbind", name("%s%d" % (long[:900], number)))
                await ask("bind", name(long), root)
        self.run_with_server(work)

    def test_contexts_are_counted(self):
        async def work(ask, root):
            with mock.patch.object(nameserver, "MOST_CONTEXTS", 3):
                first = orb.context(await ask("bind_new_context", name("a.cxt")))
                with self.refused("AlreadyBound"):
                    await ask("bind_new_context", name("a.cxt"))
                await ask("new_context")
                await ask("new_context")
                with self.refused("NO_RESOURCES"):
                    await ask("new_context")
                await ask("destroy", of=first)
                await ask("new_context")
        self.run_with_server(work)

    def test_of_another_server(self):
        """The caller may go on there."""
        async def work(ask, root):
            far = orb.corbaloc("w", f"{HOST}:1", "NameService", 0)
            await ask("bind_context", name("far"), orb.context(far))
            with self.refused("CannotProceed"):
                await ask("resolve", name("far", "x"))
        self.run_with_server(work)

    def test_spelling(self):
        for text, pairs in (
            ("a.b/c", [("a", "b"), ("c", "")]),
            (r"a\.b", [("a.b", "")]),
            (".b", [("", "b")]),
            (".", [("", "")]),
            (r"x\/y.z\\", [("x/y", "z\\")]),
        ):
            self.assertEqual(nameserver.parsed(text), pairs)
        for text in ("", "a/", "/a", "a.b.c", "a\\", "a.", "\\x"):
            with self.assertRaises(Thrown, msg=text):
                nameserver.parsed(text)


class Connecting(unittest.TestCase):
    """Ports of two components, one of which is called as another process would."""

    def run_with_components(self, work):
        async def main():
            orb.listen(HOST, 0)
            async with loop.Group() as tasks:
                made = []
                for kind, instance in ((ports.OutPort, "a"), (ports.InPort, "b")):
                    owner = component.Component(instance, {}, [], component.Configuration({}, ""))
                    owner.tasks = tasks
                    owner.contexts.append(component.Context(owner))
                    owner.ports.append(kind(owner, "p", {"port.port_type": "Data" + kind.__name__}))
                    owner.publish(HOST)
                    made.append(owner.ports[0])
                await work(*made)
                tasks.cancel()
        wait_for(main(), timeout=30)

    @staticmethod
    def profile(ends, properties, connector_id="i"):
        return orb.struct("RTC.ConnectorProfile")(
            "n", connector_id, [port.reference for port in ends], orb.nvlist(properties)
        )

    @staticmethod
    async def ask(port, operation, *args):
        ref = orb.narrow(port.reference, "RTC.PortService")
        return await orb.call("w", ref, operation, *args)

    def test_push_and_leave(self):
        async def work(out, into):
            for ends in ((out, into), (into, out)):
                result, made = await self.ask(ends[0], "connect", self.profile(ends, PUSH, ""))
                self.assertEqual(result._n, "RTC_OK")
                taken = []
                into.carriers[made.connector_id].served.take = lambda _, data: taken.append(data) or True
                for number in range(200):
                    out.write(lambda little, number=number: b"%d" % number)
                while len(taken) < 200:
                    await loop.sleep(0.01)
                self.assertEqual(taken, [b"%d" % number for number in range(200)])
                result, _ = await self.ask(out, "connect", self.profile(ends, PUSH))
                self.assertEqual(result._n, "PRECONDITION_NOT_MET")  # a double
                self.assertEqual((await self.ask(ends[1], "disconnect", made.connector_id))._n, "RTC_OK")
                self.assertEqual(
                    (out.connectors, into.connectors, out.carriers, into.carriers), ({}, {}, {}, {})
                )
        self.run_with_components(work)

    def test_a_connector_without_an_id_is_left(self):
        """A peer may answer with any id."""
        async def work(out, into):
            await self.ask(out, "connect", self.profile((out, into), PUSH))
            for by_id in (out.connectors, out.carriers):
                by_id[""] = by_id.pop("i")
            await out.lost(out.carriers[""])
            self.assertEqual((out.connectors, out.carriers), ({}, {}))
        self.run_with_components(work)

    def test_pull(self):
        async def work(out, into):
            result, made = await self.ask(out, "connect", self.profile([out], PULL))
            far = orb.from_text("w", dict(orb.properties(made.properties))["dataport.corba_cdr.outport_ior"])
            far = orb.narrow(far, "OpenRTM.OutPortCdr")
            self.assertEqual((await orb.call("w", far, "get"))[0]._n, "BUFFER_EMPTY")
            out.write(lambda little: b"1")
            for _ in range(2):  # the last is read back
                status, data = await orb.call("w", far, "get")
                self.assertEqual((status._n, bytes(data)), ("PORT_OK", b"1"))
        self.run_with_components(work)

    def test_impossible_connections_are_refused(self):
        async def work(out, into):
            for ends, properties, result in (
                ([], PUSH, "BAD_PARAMETER"),
                ([out, out], PUSH, "BAD_PARAMETER"),
                ([into], PUSH, "BAD_PARAMETER"),
                ([out], PUSH, "BAD_PARAMETER"),
                ([out, into], [], "BAD_PARAMETER"),
                ([out, into], PUSH[:1] + [("dataport.interface_type", "shared_memory")], "BAD_PARAMETER"),
                ([out, into], PUSH + [("dataport.serializer.cdr.endian", "middle")], "UNSUPPORTED"),
                ([out, into], PUSH + [("dataport.marshaling_type", "x")], "RTC_ERROR"),
            ):
                found, _ = await self.ask(out, "connect", self.profile(ends, properties))
                self.assertEqual(found._n, result, properties)
            nothing = self.profile([out], PUSH)
            nothing.ports = [out.reference, None]
            for operation in ("connect", "notify_connect"):
                self.assertEqual((await self.ask(out, operation, nothing))[0]._n, "BAD_PARAMETER")
            for operation in ("disconnect", "notify_disconnect"):
                self.assertEqual((await self.ask(out, operation, "x"))._n, "BAD_PARAMETER")
            self.assertEqual((out.connectors, into.connectors, out.coming), ({}, {}, set()))
        self.run_with_components(work)

    def test_one_that_hangs_is_left(self):
        """It delays nobody else."""
        async def work(out, into):
            session.current().timeout = 0.5
            wait = loop.Wait()
            hung = component.Component("h", {}, [], component.Configuration({}, ""))
            hung.get = None

            class Hung:
                interface = "OpenRTM.InPortCdr"

                async def put(self, data):
                    await wait

            servant = Hung()
            orb.publish(servant, HOST)
            more = [("dataport.corba_cdr.inport_ior", servant.reference.text())]
            result, _ = await self.ask(out, "connect", self.profile([out], PUSH + more, "h"))
            self.assertEqual(result._n, "RTC_OK")
            out.write(lambda little: b"1")
            while out.connectors:
                await loop.sleep(0.01)
            wait.done()
        self.run_with_components(work)

    def test_it_leaves_when_its_last_value_has_been_taken(self):
        """A C++ component whose connector goes meanwhile ends."""
        async def work(out, into):
            wait = loop.Wait()
            events = []

            class Slow:
                interface = "OpenRTM.InPortCdr"

                async def put(self, data):
                    events.append("put")
                    await wait
                    events.append("taken")
                    return orb.items("OpenRTM.PortStatus")[0]

            async def leave():
                events.append((await self.ask(out, "disconnect", "s"))._n)

            servant = Slow()
            orb.publish(servant, HOST)
            more = [("dataport.corba_cdr.inport_ior", servant.reference.text())]
            await self.ask(out, "connect", self.profile([out], PUSH + more, "s"))
            for _ in range(3):
                out.write(lambda little: b"1")
            while not events:
                await loop.sleep(0.01)
            async with loop.background(leave()):
                while out.connectors:
                    await loop.sleep(0.01)
                self.assertEqual(events, ["put"])
                wait.done()
                while len(events) < 3:
                    await loop.sleep(0.01)
            self.assertEqual(events, ["put", "taken", "RTC_OK"])
        self.run_with_components(work)

    def test_states(self):
        async def work(out, into):
            owner = out.component
            context = orb.narrow(owner.contexts[0].reference, "RTC.ExecutionContextService")
            other = into.component.reference

            async def ask(operation, *args):
                return (await orb.call("w", context, operation, *args))._n

            for state, answers in (("Inactive", ["RTC_ERROR"] + ["PRECONDITION_NOT_MET"] * 2),
                                   ("Active", ["PRECONDITION_NOT_MET", "RTC_ERROR", "PRECONDITION_NOT_MET"]),
                                   ("Error", ["PRECONDITION_NOT_MET"] * 2 + ["RTC_ERROR"])):
                owner.contexts[0].set_state(owner, state)
                self.assertEqual(await ask("get_component_state", owner.reference), state.upper() + "_STATE")
                found = [
                    await ask(word + "_component", owner.reference)
                    for word in ("activate", "deactivate", "reset")
                ]
                self.assertEqual(found, answers)
            self.assertEqual(await ask("get_component_state", other), "CREATED_STATE")
            self.assertEqual(await ask("activate_component", other), "BAD_PARAMETER")
            node = orb.narrow(owner.reference, "OpenRTM.DataFlowComponent")
            with self.assertRaisesRegex(errors.Refused, "NotAvailable"):
                configuration = await orb.call("w", node, "get_configuration")
                await orb.call(
                    "w", orb.narrow(configuration, "SDOPackage.Configuration"), "get_active_configuration_set"
                )
            for operation in ("get_status", "get_service_profile"):
                with self.assertRaisesRegex(errors.Refused, "InvalidParameter"):
                    await orb.call("w", node, operation, "x")
        self.run_with_components(work)


class Hostile(unittest.TestCase):
    def test_details_of_any_form(self):
        """What is not of the form is left out."""
        junk = (
            None,
            1,
            "x",
            [],
            {},
            [1],
            [[1, 2]],
            [[1, 2, "Provided"]],
            [{"name": 1}],
            [None],
            [["a", "b", "c"]],
        )
        profile = model.RtsProfile(
            components=[
                model.Component(
                    id="a",
                    path_uri="h/a.rtc",
                    instance_name="a",
                    data_ports=[model.DataPort(name="d")],
                    service_ports=[model.ServicePort(name="s")],
                    execution_contexts=[model.ExecutionContext(id="0", kind="?", rate=1.0)],
                )
            ]
        )

        async def main():
            orb.listen(HOST, 0)
            async with loop.Group() as tasks:
                for value in junk:
                    port = {"name": "s", "type": value, "properties": value, "interfaces": value}
                    for details in (
                        {
                            "ports": value,
                            "contexts": value,
                            "properties": value,
                            "states": value,
                            "type_name": value,
                        },
                        {
                            "ports": [port],
                            "contexts": [{"handle": 0, "kind": value, "running": value, "properties": value}],
                            "states": {"0": value},
                        },
                    ):
                        scene = recording.Scene(0, profile, {"/h/a.rtc": details})
                        shown = stage.Stage(
                            mock.Mock(scenes=[scene], channels={}, log=mock.Mock(where="f")), HOST, tasks
                        )
                        shown.show(scene)
                        owner = orb.narrow(
                            shown.components["/h/a.rtc"].reference, "OpenRTM.DataFlowComponent"
                        )
                        found = await orb.call("w", owner, "get_component_profile")
                        self.assertEqual([each.name for each in found.port_profiles], ["a.d", "a.s"])
                        shown.close()
        wait_for(main(), timeout=30)


class Coming(unittest.TestCase):
    def test_ended_components_are_gone_until_they_were_back(self):
        """Its object, and its connections at the other end; what comes later is not there before."""
        def described(name):
            context = model.ExecutionContext(id="0", kind="PERIODIC", rate=1.0)
            return model.Component(
                id="a",
                path_uri=f"h/{name}.rtc",
                instance_name=name,
                data_ports=[model.DataPort(name=f"{name}.p")],
                execution_contexts=[context],
            )

        both, all_three = [
            model.RtsProfile(components=list(map(described, names))) for names in ("ab", "abc")
        ]
        scenes = [recording.Scene(0, both, {}), recording.Scene(9, all_three, {})]

        async def is_there(shown, where):
            owner = orb.narrow(shown.components[where].reference, "OpenRTM.DataFlowComponent")
            try:
                return await orb.call("w", owner, "get_sdo_id") == where[3]
            except errors.Gone:
                return False

        async def main():
            orb.listen(HOST, 0)
            async with loop.Group() as tasks:
                shown = stage.Stage(
                    mock.Mock(scenes=scenes, channels={}, log=mock.Mock(where="f")), HOST, tasks
                )
                shown.show(scenes[0], is_jump=True)
                ends = [shown.components[f"/h/{one}.rtc"].ports[0] for one in "ab"]
                connector = model.DataPortConnector(connector_id="i", name="n")
                shown._join("i", connector, ends)
                self.assertEqual(
                    [await is_there(shown, f"/h/{one}.rtc") for one in "abc"], [True, True, False]
                )
                shown.changed.clear()
                for event, expected in (
                    ("DIED", False),
                    ("BACK", True),
                    ("EXITED", False),
                    ("APPEARED", True),
                ):
                    shown.take(recording.Report("/h/a.rtc", "LIFE_EVENT", "", event), None)
                    self.assertEqual(
                        (shown.changed, await is_there(shown, "/h/a.rtc")), ({"/h/a.rtc"}, expected), event
                    )
                    self.assertEqual(ends[1].connectors, {})
                    shown.changed.clear()
                shown.show(scenes[1])
                self.assertEqual((shown.changed, await is_there(shown, "/h/c.rtc")), ({"/h/c.rtc"}, True))
                shown.show(scenes[0])  # a component that has not answered is left as it was
                self.assertTrue(await is_there(shown, "/h/c.rtc"))
                shown.show(scenes[0], is_jump=True)
                self.assertFalse(await is_there(shown, "/h/c.rtc"))
                shown.close()
        wait_for(main(), timeout=30)


class Scenes(unittest.TestCase):
    """Of a log."""

    def test_recordings_in_one_file_begin_with_number_1_again(self):
        contents = {}
        attachments = []
        for moment, state in ((5, "Active"), (9, "Inactive")):
            described = json.dumps([{"path": "/h/a.rtc", "states": {"0": state}}])
            profile = rtsprofile.dump(model.RtsProfile(), rtsprofile.XML)
            for filename, text in (("system-1.rtsys", profile), ("components-1.json", described)):
                attachments.append((moment, filename, "", 0, len(text)))
                contents[moment, filename] = text.encode()
        log = types.SimpleNamespace(
            where="a.mcap", attachments=attachments, attached=lambda entry: contents[entry[:2]],
        )
        states = [scene.details["/h/a.rtc"]["states"] for scene in recording._scenes(log)]
        self.assertEqual(states, [{"0": "Active"}, {"0": "Inactive"}])


class Keys(unittest.TestCase):
    def test_keys_and_the_line(self):
        """The terminal is as before in the end."""
        keyboard, terminal = os.openpty()
        self.addCleanup(os.close, keyboard)
        self.addCleanup(os.close, terminal)
        before = termios.tcgetattr(terminal)
        done, written = [], []
        pace = mock.Mock(position=1700000000 * 10 ** 9, count=7, rate=2.0, is_paused=True)
        pace.pause.side_effect = lambda: done.append("pause")
        pace.step.side_effect = lambda: done.append("step")
        pace.jump.side_effect = done.append
        pace.resume.side_effect = lambda: done.append("resume")

        async def main():
            async with loop.background(playing.attend(pace, written.append)):
                while not written:
                    await loop.sleep(0.01)
                self.assertFalse(termios.tcgetattr(terminal)[3] & termios.ICANON)
                os.write(keyboard, b" .<x>")
                while len(done) < 4:
                    await loop.sleep(0.01)
                os.kill(os.getpid(), signal.SIGCONT)  # as after Ctrl-Z
                while len(done) < 5:
                    await loop.sleep(0.01)

        with mock.patch.object(playing, "_is_ours", lambda: True), mock.patch(
            "sys.stdin", mock.Mock(fileno=lambda: terminal)
        ):
            wait_for(main(), timeout=30)
        self.assertEqual(done, ["pause", "step", -5.0, 5.0, "resume"])
        self.assertRegex(written[0], r"\(1700000000\.000000000\)  7 entries  x2  paused\x1b\[K\r\Z")
        self.assertEqual((written[-1], termios.tcgetattr(terminal)), ("\n", before))


if __name__ == "__main__":
    unittest.main()
