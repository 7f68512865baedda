"""What rtdoctor says of robots that are broken in ways that the mocks do not have."""
import glob
import os
import re
import threading
import unittest
from unittest import mock

import worlds
from rtshell_lite import errors, path
from loops import asynchronous, wait_for
from rtshell_lite.corba import orb, session
from rtshell_lite.doctor import (
    components,
    connections,
    finding,
    host,
    limits,
    local,
    profile,
    rates,
    references,
    remedies,
    report,
    servers,
    started,
    waiting,
)
from rtshell_lite.robot import component, places, ports, snapshot, tree
from rtshell_lite.xmlprofile import model


class Mounts(unittest.TestCase):
    def test_a_stopped_rtmount_does_not_hold_the_loop(self):
        """Nothing interrupts the kernel's question."""
        stopped = threading.Event()
        self.addCleanup(stopped.set)
        with mock.patch.object(local.kernel, "mounted", lambda: ["/robot"]), \
                mock.patch.object(local.kernel, "is_stale", lambda place: stopped.wait(worlds.LIMIT)):
            self.assertEqual(wait_for(local._mounts(), 0.2), [])


class Secrets(unittest.TestCase):
    """A report is given to others."""

    def test_variables(self):
        given = {
            "RTC_TOKEN": "abc", "PYTHON_KEYRING_PASS": "abc", "ORB_KEY": "abc", "RT_PASSWORD": "abc",
            "OMNI_SECRET": "abc", "ORBsslPassword": "abc", "RTSHELL_TOKEN": "abc", "LANG_KEY": "abc",
            "RTCTREE_ORB_ARGS": "-ORBsslPassword;abc;-ORBendPoint;giop:tcp::2809", "LC_ALL": "C",
            "RTCTREE_NAMESERVERS": "robot1", "PYTHONPATH": "/opt/x",
        }
        with mock.patch.dict(os.environ, given, clear=True):
            shown = list(host._environment())
        self.assertEqual(
            shown,
            [
                "LC_ALL=C",
                "PYTHONPATH=/opt/x",
                "RTCTREE_NAMESERVERS=robot1",
                "RTCTREE_ORB_ARGS='-ORBsslPassword;(hidden);-ORBendPoint;giop:tcp::2809'",
            ],
        )

    def test_command_lines(self):
        for given, wanted in (
            ("comp -ORBsslPassword abc -f rtc.conf", "comp -ORBsslPassword (hidden) -f rtc.conf"),
            ("comp --password=abc --token abc", "comp --password=(hidden) --token (hidden)"),
            ("comp --api-key abc -key abc", "comp --api-key (hidden) -key (hidden)"),
            ("comp -o corba.ssl.passphrase=abc x", "comp -o corba.ssl.passphrase=(hidden) x"),
            ("comp http://user:abc@host/x", "comp http://user:(hidden)@host/x"),
            ("comp --password --password abc", "comp --password (hidden) abc"),
            ("comp --keys abc -p 2809 MA.rtc:in", "comp --keys abc -p 2809 MA.rtc:in"),
        ):
            self.assertEqual(" ".join(host.without_secrets(given.split())), wanted)


class Connections(unittest.TestCase):
    def test_an_end_that_is_nil(self):
        node = tree.Node(path.parse("/localhost/In0.rtc"), "component", None)
        connector = ports.Connector("one", "out_in", [None, None], [])
        port = ports.Port(node, "In0.out", "DataOutPort", {}, [], [connector], None, None)
        (finding,) = wait_for(
            connections._troubles(connections.Link(snapshot.Snapshot(node), port, connector), {}, {})
        )
        self.assertEqual(
            finding,
            (
                "fail",
                "connection",
                "/localhost/In0.rtc:out",
                "connection out_in has an end that is nothing (nil)",
                "rtdis -i one /localhost/In0.rtc:out",
                "",
            ),
        )

    def test_an_end_that_is_listed_twice(self):
        """It is asked again only once, and reported once: two answers could differ."""
        node = tree.Node(path.parse("/localhost/In0.rtc"), "component", "component")
        connector = ports.Connector("one", "c", ["near", "far", "far"], [])
        port = ports.Port(node, "In0.out", "Port", {}, [], [connector], "near", None)
        link = connections.Link(snapshot.Snapshot(node), port, connector)
        ends = {ref: places.End(ref, port._replace(ref=ref, connectors=[]), None) for ref in ("near", "far")}
        asked = []
        with mock.patch.multiple(connections.orb, identity=str, same=str.__eq__), mock.patch.object(
                connections.places, "ask", asynchronous(
                    lambda refs, joining: asked.extend(refs) or [port, errors.Silent("far", "no answer")])):
            self.assertEqual(len(wait_for(connections._troubles(link, ends, {}))), 1)
            self.assertEqual(wait_for(connections._again(link, ends)), link)
        self.assertEqual((asked, ends["far"].port), (["near", "far"], None))

    def test_a_connection_that_is_made_again_with_another_end(self):
        """At the second look it has an end that nobody has asked about: it is just changing."""
        node = tree.Node(path.parse("/localhost/In0.rtc"), "component", "component")
        before, after = [ports.Connector("one", "c", ["near", far], []) for far in ("far1", "far2")]
        port = ports.Port(node, "In0.out", "Port", {}, [], [before], "near", None)
        ends = {
            "near": places.End("near", port, None),
            "far1": places.End("far1", None, errors.Silent("far1", "no answer")),
        }
        with mock.patch.multiple(connections.orb, identity=str, same=str.__eq__), mock.patch.object(
            connections.places,
            "ask",
            asynchronous(lambda refs, joining: [port._replace(connectors=[after]) for _ in refs]),
        ):
            self.assertIsNone(
                wait_for(connections._again(connections.Link(snapshot.Snapshot(node), port, before), ends))
            )

    def test_connectors_that_one_end_lacks(self):
        there = ports.Connector("one", "c", [], [("x", "1")])
        here = ports.Connector("one", "c", [], [("x", "1"), ("dataport.dataflow_type", "push")])
        port = ports.Port(
            tree.Node(path.parse("/localhost/In0.rtc"), "component", None),
            "In0.out",
            "DataOutPort",
            {},
            [],
            [here],
            None,
            None,
        )
        far = tree.Node(path.parse("/localhost/far.rtc"), "component", None)
        found = connections._differences(
            connections.Link(None, port, here),
            places.End(None, port._replace(node=far, name="far.in", connectors=[there]), None),
            remedies.words("restart far end"),
        )
        self.assertEqual([finding.message for finding in found], ["dataport.dataflow_type is push here, "
                                                                  "missing at /localhost/far.rtc:in"])

    def test_references_differ_in_spelling(self):
        """Some implementations give the text of a Python object for one."""
        node = tree.Node(path.parse("/localhost/In0.rtc"), "component", None)
        for one, other in (("<object>", "IOR:0"), ("<object>", ""), ("", "IOR:0")):
            here, there = [ports.Connector("one", "c", [], [("x", value)]) for value in (one, other)]
            port = ports.Port(node, "In0.out", "DataOutPort", {}, [], [here], None, None)
            end = places.End(None, port._replace(connectors=[there]), None)
            self.assertEqual(connections._differences(connections.Link(None, port, here), end, None), [])


class Started(unittest.TestCase):
    def messages(self, connected=(), **states):
        """What is said of components in these states; some of them are connected with each other."""
        connector = ports.Connector("one", "c", list(connected), [])
        snapshots = [
            mock.Mock(
                states=state,
                where="/d/" + name,
                node=mock.Mock(path=path.parse("/d/" + name)),
                ports=[
                    ports.Port(
                        None, "p", "DataOutPort", {}, [], [connector] if name in connected else [], name, None
                    )
                ],
            )
            for name, state in sorted(states.items())
        ]
        with mock.patch.object(started.component, "merged", lambda states: states), \
                mock.patch.object(started.orb, "identity", lambda ref: ref):
            return [(finding.path, finding.message) for finding in started.findings(
                snapshots, {"/d/" + name for name, state in states.items() if state == "Error"})]

    def test_it(self):
        self.assertEqual(self.messages(A="Inactive", B="Inactive"),
                         [("/", "all components examined are Inactive: none has been started")])
        self.assertEqual(self.messages(A="Active", B="Active"), [])
        self.assertEqual(self.messages(A="Error", B="Inactive"), [])
        reset = "Inactive, while 1 component of its system is Active; it may have been reset"
        self.assertEqual(self.messages(A="Active", B="Inactive"), [])  # nobody is connected to it
        for others in ({"C": "Active"}, {"C": "Active", "D": "Error"}):
            self.assertEqual(self.messages(("A", "B"), A="Inactive", B="Inactive", **others), [])
            self.assertEqual(self.messages(("A", "B"), A="Active", B="Inactive", **others), [("/d/B", reset)])
        self.assertEqual(self.messages(("A", "B", "C"), A="Active", B="Inactive", C="Error"), [])


class Waiting(unittest.TestCase):
    """A, of process 1, hangs when it is asked for its ports."""

    def culprits(self, *hung):
        def node(name, number):
            return mock.Mock(path=path.parse("/d/" + name), endpoint=("198.51.100.1", number))
        a = mock.Mock(node=node("A", 1), answered=True, error=errors.Silent("/d/A", "no answer within 1s"))
        with mock.patch.object(waiting, "_sockets", asynchronous(lambda endpoint: set())):
            (found,) = wait_for(waiting.culprits([a], [node(*each) for each in hung])).values()
        return found.paths, found.is_certain, found.endpoint[1]

    def test_what_hangs_elsewhere_comes_before_its_own_process(self):
        self.assertEqual(self.culprits(("B", 1), ("C", 2), ("D", 2)), (["/d/C"], False, 1))

    def test_what_hangs_beside_it(self):
        self.assertEqual(self.culprits(("B", 1)), (["/d/B"], False, 1))

    def test_nothing_else_hangs(self):
        self.assertEqual(self.culprits(), ([], False, 1))


class Explained(unittest.TestCase):
    def test_the_effects_of_one_process_are_folded(self):
        words = remedies.words("slow", host="robot")
        hung = ("robot", 4000)
        other = finding.fail("component", "/robot/E0.rtc", "in Error", words)
        few = [finding.fail("reference", f"/robot/F{i}.rtc", "hung", words, ("robot", 1)) for i in range(2)]
        many = [finding.warn("component", f"/robot/W{i}.rtc", "not asked", words, hung) for i in range(3)]
        cause = finding.fail("reference", "/robot/H0.rtc", "hung", words, hung)
        shown, number = finding.explained([other, *many, cause, *few])
        more = "hung; this explains 3 more findings (-v shows them)"
        self.assertEqual(shown, [cause._replace(message=more), other, *few])
        self.assertEqual(number, 3)


class Timestamps(unittest.TestCase):
    def test_which_types_have_one(self):
        for data_type, has_one in (
            ("IDL:RTC/TimedLong:1.0", True),
            ("IDL:RTC/Point2D:1.0", False),
            ("", False),
        ):
            port = mock.Mock(properties={"dataport.data_type": data_type})
            self.assertIs(rates.Watched(mock.Mock(), 100.0, port).stamped, has_one, data_type)


class Remedies(unittest.TestCase):
    def test_all_that_are_named_are_there(self):
        for file in glob.glob(os.path.join(glob.escape(os.path.dirname(remedies.__file__)), "*.py")):
            with open(file, encoding="utf-8") as source:
                named = re.findall(r'remedies\.(command|words)\(\s*"([^"]+)"', source.read())
            for function, name in named:
                self.assertIn(name, remedies.COMMANDS if function == "command" else remedies.WORDS, file)


class Profile(unittest.TestCase):
    def test_a_rate_that_a_context_has_rounded(self):
        context = model.ExecutionContext(id="0", kind="PERIODIC", rate=30.0)
        listed = model.Component(
            id="", path_uri="localhost/In0.rtc", instance_name="In0", execution_contexts=[context]
        )
        for rate, number in ((30.0003, 0), (29.99, 0), (31.0, 1)):
            owned = [component.Context(0, None, "Periodic", rate, True, None, (), ())]
            with self.subTest(rate=rate), mock.patch(
                    "rtshell_lite.system.capture.ask_each", asynchronous(lambda *_: [owned])):
                self.assertEqual(len(wait_for(profile._rates(mock.Mock(components=[listed])))), number)


class Here(unittest.TestCase):
    def test_an_old_omniorb(self):
        with mock.patch.object(orb, "version", lambda: "omniORBpy 3.7.1"), mock.patch.object(orb, "start"):
            finding, = local._programs()
        self.assertEqual(finding.level, "warn")
        self.assertIn("omniORBpy 3.7.1: older than 4.0, untried", finding.message)

    def test_no_omniorb(self):
        with mock.patch.object(orb, "version", side_effect=errors.MissingOmniORB):
            finding, = local._programs()
        self.assertEqual((finding.level, finding.check), ("fail", "ORB"))

    def test_addresses_of_name_servers(self):
        self.assertEqual(
            [wait_for(local.fault(address)) for address in ("robot1:2810", "robot1,robot2", "a b")],
            [""] + 2 * ["several are separated by semicolons"],
        )


class NameServers(unittest.TestCase):
    """Faults that omniNames does not have."""

    def stopped(self, check, answer):
        async def call(*_):
            if isinstance(answer, Exception):
                raise answer
            return answer
        with mock.patch.object(orb, "call", call), mock.patch.object(
            orb, "endpoint", lambda ref: ("robot1", 2809)
        ):
            with self.assertRaises(servers._Stop) as caught:
                wait_for(check("/robot1", None))
        return caught.exception.finding.message

    def test_answers_that_prove_a_name_server(self):
        refused = errors.Refused("/robot1", "CORBA.NO_PERMISSION")
        self.assertEqual(self.stopped(servers._is_there, refused), "answers with CORBA.NO_PERMISSION")
        self.assertEqual(self.stopped(servers._is_context, refused), "is there, but does not report what "
                                                                     "it is (CORBA.NO_PERMISSION)")
        self.assertEqual(self.stopped(servers._is_context, False), "its object NameService is not a naming "
                                                                   "context")


class Names(unittest.TestCase):
    def test_bound_twice_without_telling_its_names(self):
        """OpenRTM-aist has the names of a component in a property; others do not."""
        nodes = [
            tree.Node(path.parse(where), "component", None)
            for where in ("/one/a.host_cxt/In0.rtc", "/one/b.host_cxt/In0.rtc", "/two/a.host_cxt/In0.rtc")
        ]
        each = snapshot.Snapshot(nodes[0], nodes[1:])
        each.profile = component.Profile("In0", "In", "", "", "", "", "", properties=[])
        self.assertEqual([(finding.path, finding.message) for finding in components._names(each)],
                         [("/one/b.host_cxt/In0.rtc", "the same component as /one/a.host_cxt/In0.rtc")])


class ManyFindings(unittest.TestCase):
    def late(self, number):
        return [limits.late("component", "/robot/A%d.rtc" % i) for i in range(number)]

    def test_all_that_there_was_no_time_for_is_one_failure(self):
        self.assertEqual(limits.left_out(self.late(2)), self.late(2))
        other = finding.ok("component", "/robot/B0.rtc", "Active")
        first, joined = limits.left_out(self.late(3000) + [other])
        self.assertEqual((first, joined.level), (other, "fail"))
        self.assertEqual(joined.message, "3000 components not looked at, as there was no time left: "
                                         "/robot/A0.rtc, /robot/A1.rtc, /robot/A2.rtc and 2997 more")

    def test_a_process_that_was_not_asked_does_not_hang(self):
        node = tree.Node(
            path.parse("/robot/A0.rtc"), "unasked", None, errors.NoTime("/robot/A0.rtc", session.NO_TIME)
        )
        visit = servers.Visit(None, [], [], [], {("robot", 4000): None}, None, "")
        self.assertEqual(
            wait_for(references._silent(visit, node, [("robot", 4000)], "robot:4000")).message,
            "slow: " + session.NO_TIME,
        )

    def test_failures_come_first_and_like_warnings_are_one(self):
        words = remedies.words("slow", host="robot")
        warnings = [
            finding.warn("reference", "/robot/A%d.rtc" % i, "publishes 127.0.0.1:%d" % (4000 + i), words)
            for i in range(3)
        ]
        pasted = [
            finding.warn(
                "reference", "/robot/C%d.rtc" % i, "to be pasted", remedies.command("delete name", path="/c")
            )
            for i in range(3)
        ]
        failure = finding.fail("component", "/robot/B0.rtc", "in Error", words)
        found = list(finding.grouped(warnings + pasted + [failure]))
        self.assertEqual(
            [each.path for each in found], ["/robot/B0.rtc", "/robot/A0.rtc"] + [each.path for each in pasted]
        )
        self.assertEqual(found[1].message, "publishes 127.0.0.1:4000; the same with /robot/A1.rtc and "
                                           "/robot/A2.rtc")


class Rates(unittest.TestCase):
    """What is measured while this host is too busy to let us run says less of others."""

    def found(self, count, missed):
        node = tree.Node(path.parse("/robot/A0.rtc"), "component")
        node._endpoint = ("robot", 4000)
        port = ports.Port(node, "A0.out", "DataOutPort", {}, [], [], None, None)
        watched = rates.Watched(snapshot.Snapshot(node), 100.0, port)
        watched.count = count
        return rates._finding(watched, 1.0, missed).level

    def test_a_starved_machine(self):
        self.assertEqual(
            [self.found(50, 0.0), self.found(50, 0.5), self.found(20, 0.5)], ["warn", "ok", "warn"]
        )

    def test_clocks_that_differ_by_minutes(self):
        watched = mock.Mock(stamp=(1000.0, 700.0), where="/robot/A0.rtc")
        self.assertIn("5 minutes behind", rates._clock(watched)[0].message)
        watched.stamp = (1000.0, 950.0)
        self.assertEqual(rates._clock(watched), [])

    def test_clocks_in_reports(self):
        node = tree.Node(path.parse("/robot/100%s.rtc"), "component")
        node._endpoint = ("robot%d", 4000)
        seen = snapshot.Snapshot(node)
        self.assertEqual(list(report._clocks([seen])), [])
        seen.written = (ports.Port(node, "100%s.out", "DataOutPort", {}, [], [], None, None), 50.0)
        for stamp, words in ((999.5, "0.500 s before it came here"), (1002.25, "2.250 s after it came here")):
            seen.stamp = (1000.0, stamp)
            self.assertEqual(list(report._clocks([seen])),
                             ["/robot/100%s.rtc  at robot%d:4000: a value of out was stamped " + words])


if __name__ == "__main__":
    unittest.main()
