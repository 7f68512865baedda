"""The misbehaving peers: each fails a client in its own way, and none holds it longer than its deadline."""
import json
import os
import resource
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.append(ROOT)

from mock_components import faulty, giop, malice, nameserver    # noqa: E402: the path first

try:
    import omniORB
    import CosNaming
    from omniORB import CORBA
except ImportError:
    omniORB = None

TIMEOUT = 2.0
SILENCE = "TIMEOUT_CallTimedOutOnClient"
BROKEN = "COMM_FAILURE_WaitingForReply"

# What _is_a, list, and resolve and _non_existent of the first name end with: the call that fails, and how.
EXPECTED = {
    "refused": ("_is_a", "TRANSIENT_ConnectFailed"),
    "dead-host": ("_is_a", SILENCE),
    "silent": ("_is_a", SILENCE),
    "half-header": ("_is_a", SILENCE),
    "drip": ("_is_a", SILENCE),
    "announce": ("_is_a", SILENCE),
    "reset": ("_is_a", BROKEN),
    "close": ("_is_a", BROKEN),
    "garbage": ("_is_a", BROKEN),
    "late-silent": ("list", SILENCE),
    "late-half-header": ("list", SILENCE),
    "late-drip": ("list", SILENCE),
    "late-announce": ("list", SILENCE),
    "late-reset": ("list", BROKEN),
    "late-close": ("list", BROKEN),
    "late-garbage": ("list", BROKEN),
    "wrong-id": ("list", SILENCE),
    "crumbs": ("list", "COMM_FAILURE_UnMarshalResults"),
    "strangers": ("list", SILENCE),
    "sequence-bomb": ("list", "MARSHAL_PassEndOfMessage"),
    "string-bomb": ("list", "MARSHAL_PassEndOfMessage"),
    "elsewhere-silent": ("_non_existent", SILENCE),
    "elsewhere-refused": ("_non_existent", "TRANSIENT_ConnectFailed"),
    "hostile": ("", ""),
    "many": ("", ""),
    "loop": ("", ""),
    "bottomless": ("", ""),
    "branching": ("", ""),
}


def start(*arguments):
    """A process of faulty.py, and the ports that it prints."""
    process = subprocess.Popen([sys.executable, "-m", "mock_components.faulty"] + list(arguments), cwd=ROOT,
                               stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    return process, json.loads(process.stdout.readline().decode())


def stop(process):
    """Close its stdin; the exit status."""
    process.stdin.close()
    process.stdout.close()
    return process.wait(60)


def context_at(port):
    """The naming context behind a port, nothing asked yet."""
    reference = CORBA.ORB_init([]).string_to_object("corbaloc:iiop:1.2@127.0.0.1:{}/NameService".format(port))
    return reference._unchecked_narrow(CosNaming.NamingContext)


def ask(port):
    """The first call that fails and how, in words, and the seconds until then."""
    begin = time.monotonic()
    step = "_is_a"
    try:
        context = context_at(port)
        context._is_a(giop.CONTEXT)
        step = "list"
        bindings, _ = context.list(10000)
        step = "resolve"
        found = context.resolve(bindings[0].binding_name)
        step = "_non_existent"
        found._non_existent()
    except CORBA.SystemException as error:
        return step, omniORB.minorCodeToString(error), time.monotonic() - begin
    return "", "", time.monotonic() - begin


class WithDeadline(unittest.TestCase):
    """Calls of this process end after TIMEOUT."""

    @classmethod
    def setUpClass(cls):
        if omniORB is None:
            raise unittest.SkipTest("omniORBpy is not installed")
        CORBA.ORB_init([])
        omniORB.setClientCallTimeout(int(TIMEOUT * 1000))

    @classmethod
    def tearDownClass(cls):
        omniORB.setClientCallTimeout(0)


class ModesTest(WithDeadline):
    """omniORB's own conduct with each peer: all that the commands build on."""

    def test_every_mode_has_an_expectation(self):
        """But those that omniORB itself does not survive: see tests/waiting/test_answers.py."""
        self.assertEqual(set(EXPECTED) | set(malice.CHANGES), set(faulty.MODES) | set(faulty.UNREACHABLE))

    def test_failures_and_their_times(self):
        process, ports = start(*sorted(EXPECTED))
        self.addCleanup(stop, process)
        memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        answers = {}
        threads = [threading.Thread(target=lambda mode=mode: answers.update({mode: ask(ports[mode])}))
                   for mode in EXPECTED]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for mode, expected in sorted(EXPECTED.items()):
            with self.subTest(mode=mode):
                step, failure, seconds = answers[mode]
                self.assertEqual((step, failure), expected)
                # in timeouts: a slow machine adds less than one more
                waits = 1 if failure == SILENCE else 0
                self.assertTrue(
                    waits * TIMEOUT - 0.05 <= seconds < (waits + 1) * TIMEOUT, "{:.2f} s".format(seconds)
                )
        grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - memory
        self.assertLess(grown, 64 * 1024, "kB more resident: an announced size was allocated")


class NamesTest(WithDeadline):
    """What the peers that do answer say."""

    def listed(self, mode):
        peer = faulty.Peer(mode)
        self.addCleanup(peer.close)
        context = context_at(peer.port)
        return context, context.list(10000)[0]

    def test_hostile_names_arrive_byte_for_byte(self):
        context, bindings = self.listed("hostile")
        names = [(name.id.encode("latin-1"), name.kind.encode("latin-1"))
                 for binding in bindings for name in binding.binding_name]
        self.assertEqual(names, faulty.HOSTILE_NAMES)
        for binding in bindings:
            again = context.resolve(binding.binding_name)
            self.assertFalse(again._non_existent())
            self.assertTrue(again._is_a(giop.COMPONENT))

    def test_hostile_component_profile(self):
        from mock_components.idl import OpenRTM
        context, bindings = self.listed("hostile")
        component = context.resolve(bindings[0].binding_name)
        self.assertIsNotNone(component._narrow(OpenRTM.DataFlowComponent))
        profile = component._narrow(OpenRTM.DataFlowComponent).get_component_profile()
        self.assertEqual(profile.instance_name.encode("latin-1"), faulty.HOSTILE_NAMES[0][0])
        self.assertEqual((profile.port_profiles, profile.parent, profile.properties), ([], None, []))
        with self.assertRaises(CORBA.BAD_OPERATION):
            component._narrow(OpenRTM.DataFlowComponent).get_ports()

    def test_many_bindings(self):
        self.assertEqual(len(self.listed("many")[1]), 20000)

    def test_loop_leads_back_to_the_same_object(self):
        context, bindings = self.listed("loop")
        inner = context.resolve(bindings[0].binding_name)
        self.assertTrue(inner._is_equivalent(inner.resolve(bindings[0].binding_name)))

    def test_bottomless_leads_to_another_object_each_time(self):
        context, bindings = self.listed("bottomless")
        inner = context.resolve(bindings[0].binding_name)
        self.assertFalse(inner._is_equivalent(inner.resolve(bindings[0].binding_name)))

    def test_giop_1_0(self):
        with faulty.Peer("loop") as peer:
            context = CORBA.ORB_init([]).string_to_object(
                "corbaloc::127.0.0.1:{}/NameService".format(peer.port)
            )
            self.assertEqual(len(context._narrow(CosNaming.NamingContext).list(10)[0]), 2)


class ProcessTest(unittest.TestCase):
    """No test may leave a peer behind."""

    def test_ends_with_stdin(self):
        process, ports = start("silent", "second=silent")
        self.assertEqual(sorted(ports), ["second", "silent"])
        self.assertEqual(stop(process), 0)

    def test_ends_on_sigterm(self):
        process, _ = start("refused")
        process.terminate()
        self.assertEqual(process.wait(60), 0)
        stop(process)

    def test_closed_peer_refuses(self):
        with faulty.Peer("silent") as peer:
            socket.create_connection(("127.0.0.1", peer.port), 2).close()
        with self.assertRaises(ConnectionRefusedError):
            socket.create_connection(("127.0.0.1", peer.port), 2)

    def test_unknown_mode(self):
        done = subprocess.run([sys.executable, "-m", "mock_components.faulty", "polite"], cwd=ROOT,
                              stderr=subprocess.PIPE, stdin=subprocess.DEVNULL)
        self.assertEqual((done.returncode, done.stderr), (1, b"faulty: no such mode: polite (see --help)\n"))


class BindTest(WithDeadline):
    """A faulty component beside live ones."""

    def setUp(self):
        if not nameserver.binary():
            self.skipTest("omniNames is not installed")
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        server, self.port = nameserver.start(directory.name)
        self.addCleanup(server.wait)
        self.addCleanup(server.kill)

    def test_bind(self):
        place = "127.0.0.1:{}/robot.host_cxt".format(self.port)
        process, _ = start("--bind", place, "silent", "Arm0.rtc=late-silent", "evil.host_cxt=hostile")
        self.addCleanup(stop, process)
        context = context_at(self.port).resolve([CosNaming.NameComponent("robot", "host_cxt")])
        kinds = {name.id + "." + name.kind: str(binding.binding_type)
                 for binding in context.list(100)[0] for name in binding.binding_name}
        self.assertEqual(kinds, {"silent.rtc": "nobject", "Arm0.rtc": "nobject", "evil.host_cxt": "ncontext"})
        component = context.resolve([CosNaming.NameComponent("Arm0", "rtc")])
        self.assertTrue(component._is_a(giop.COMPONENT))
        with self.assertRaises(CORBA.TIMEOUT):
            context.resolve([CosNaming.NameComponent("silent", "rtc")])._non_existent()


if __name__ == "__main__":
    unittest.main()
