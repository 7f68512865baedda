"""Matching and disconnecting ports."""
import unittest
from unittest import mock

from rtshell_lite import errors, path
from rtshell_lite.net import loop
from rtshell_lite.robot import connectors, ports

PY2 = {"dataport.dataflow_type": "push,pull,duplex", "dataport.interface_type": "corba_cdr,direct",
       "dataport.subscription_type": "flush, new ,periodic"}
OLD = {"dataport.dataflow_type": "Push,Pull", "dataport.interface_type": "CORBA_Any",  # OpenRTM 1.0
       "dataport.subscription_type": "Flush,New,Periodic"}
RTORB = {"dataport.dataflow_type": (
    "push"
), "dataport.interface_type": "corba_cdr", "dataport.subscription_type": "flush"}


class Node:
    def __init__(self, name):
        self.path = path.parse("/localhost/%s.rtc" % name)


def port(name, kind, properties=None, interfaces=(), connectors=(), **more):
    """A Port of the component A, B …; its reference is its name."""
    given = dict(properties or {}, **{key.replace("__", "."): value for key, value in more.items()})
    component, _, short = name.partition(".")
    return ports.Port(Node(component), name, kind, given, list(interfaces), list(connectors), name, None)


def out(data_type="IDL:RTC/TimedLong:1.0", offers=PY2, name="A.out"):
    return port(name, "DataOutPort", offers, dataport__data_type=data_type)


def into(data_type="IDL:RTC/TimedLong:1.0", offers=PY2, name="B.in"):
    return port(name, "DataInPort", dict(offers, **{"dataport.subscription_type": (
        "Any"
    )}), dataport__data_type=data_type)


def service(name, *interfaces):
    return port(name, "CorbaPort", interfaces=[ports.Interface(*each) for each in interfaces])


class Tools(unittest.TestCase):
    """Connectors of tools are no part of a system: they are known by their names, others by what carries
    their data.
    """

    def is_of_tool(self, name, interface, ends):
        made = ports.Connector("id", name, ["A.out", "B.in"][:ends], [("dataport.interface_type", interface)])
        return ports.is_of_tool(made)

    def test_ours(self):
        for name in ("rtprint", "rtinject", "rtlog", "rtmount", "rtshell_lite", "rtshell_lite rates"):
            self.assertTrue(self.is_of_tool(name, "fast-rtps", 1), name)

    def test_rtshells(self):
        for name in (
            "rtprint_reader0_out",
            "rtinject_writer12_in",
            "rtlog_recorder0_out",
            "rtlog_player3_in",
        ):
            self.assertTrue(self.is_of_tool(name, "corba_cdr", 2), name)

    def test_other_tools_that_connect_one_port_by_corba(self):
        for interface in ("", "corba_cdr", "CORBA_Any", "data_service"):
            self.assertTrue(self.is_of_tool("viewer", interface, 1), interface)

    def test_parts_of_a_system(self):
        for name, interface, ends in (
            ("chatter", "ros", 1),
            ("", "fast-rtps", 1),
            ("rtlog_out", "ssm", 1),
            ("outin", "corba_cdr", 2),
            ("rtprinter", "corba_cdr", 2),
            ("rtlog_reader", "corba_cdr", 2),
        ):
            self.assertFalse(self.is_of_tool(name, interface, ends), name)


class Case(unittest.TestCase):
    def setUp(self):
        for name, replaced in (("identity", lambda ref: ref), ("same", lambda one, other: one == other)):
            patched = mock.patch("rtshell_lite.corba.orb." + name, replaced)  # references are names here
            patched.start()
            self.addCleanup(patched.stop)

    def reasons(self, *found, **given):
        return ports.mismatches(list(found), {key.replace("__", "."): value for key, value in given.items()})

    def matching(self, *found, **given):
        self.assertEqual(self.reasons(*found, **given), [])

    def chosen(self, *found, **given):
        properties = ports.connection_properties(list(found), given)
        return [
            properties.get("dataport." + key)
            for key in ("dataflow_type", "interface_type", "subscription_type")
        ]


class DataTypes(Case):
    def test_spellings_of_one_type(self):
        for one, other in (
            ("IDL:RTC/TimedLong:1.0", "IDL:RTC/TimedLong:1.0"),
            ("TimedLong", "IDL:RTC/TimedLong:1.0"),
            ("TimedLong", "TimedLong"),
            ("", "IDL:RTC/TimedLong:1.0"),
            ("any", "TimedLong"),
            ("IDL:RTC/TimedLong:1.0", "Any"),
            ("IDL:Img/TimedCameraImage:1.0", "TimedCameraImage"),
        ):
            self.matching(out(one), into(other))
            self.matching(into(one), out(other))

    def test_types_that_differ(self):
        for one, other in (
            ("TimedLong", "TimedShort"),
            ("IDL:RTC/TimedLong:1.0", "TimedULong"),
            ("IDL:RTC/TimedLong:1.0", "IDL:Mine/TimedLong:1.0"),
            ("TimedLongSeq", "TimedLong"),
        ):
            self.assertEqual(len(self.reasons(out(one), into(other))), 1, (one, other))

    def test_the_reason_is_readable(self):
        self.assertEqual(self.reasons(out(), into("TimedDouble")), ["data types differ (RTC/TimedLong, "
                                                                    "TimedDouble)"])
        self.assertEqual(self.reasons(out(), into("\x1b")), ["data types differ (RTC/TimedLong, \\x1b)"])

    def test_any_is_a_word_of_its_own(self):
        """A longer word that begins with `any` is not `any`."""
        self.assertEqual(len(self.reasons(out("IDL:Company/X:1.0"), into("IDL:RTC/TimedLong:1.0"))), 1)


class Polarity(Case):
    def test_in_and_out_in_any_order_and_number(self):
        self.matching(out(), into())
        self.matching(into(), out())
        self.matching(into(), out(), into(name="C.in"))

    def test_one_kind_only(self):
        for found in ([out()], [into()], [out(), out(name="B.out")], [into(), into(name="C.in")]):
            self.assertEqual(len(self.reasons(*found)), 1)
            self.assertIn("needs an in port and an out port", self.reasons(*found)[0])

    def test_a_port_named_twice(self):
        """C++ 2.1 never answers again after that."""
        self.assertEqual(self.reasons(out(), out()), ["a port is named twice"])
        self.assertEqual(self.reasons(out(), into(), into()), ["a port is named twice"])

    def test_data_with_service(self):
        self.assertEqual(len(self.reasons(out(), service("B.s"))), 1)

    def test_other_ports_are_left_to_the_components(self):
        self.matching(port("A.x", "Port"), port("B.y", "Port"))


class Lists(Case):
    def test_given_values_have_to_be_offered(self):
        self.matching(out(), into(), dataport__dataflow_type="pull", dataport__subscription_type="new")
        self.assertEqual(self.reasons(out(), into(), dataport__dataflow_type="Pull"),
                         ["no port has dataflow_type Pull (all have: push, pull, duplex)"])
        self.assertEqual(self.reasons(out(), into(), dataport__subscription_type="x\n"),
                         ["/localhost/A.rtc:out has no subscription_type x\\x0a (it has: flush, new, "
                          "periodic)"])

    def test_unknown_keys_pass(self):
        self.matching(out(), into(), dataport__buffer__length="3", anything="x")

    def test_defaults_are_what_all_offer(self):
        self.assertEqual(self.chosen(out(), into()), ["push", "corba_cdr", "new"])
        self.assertEqual(self.chosen(out(), into(offers=RTORB)), ["push", "corba_cdr", "new"])
        self.assertEqual(self.chosen(out(offers=RTORB), into()), ["push", "corba_cdr", "flush"])
        self.assertEqual(self.chosen(out(offers=OLD), into(offers=OLD)), ["push", "CORBA_Any", "new"])
        self.assertEqual(
            self.chosen(port("A.out", "DataOutPort"), port("B.in", "DataInPort")),
            ["push", "corba_cdr", "new"],
        )

    def test_the_capitals_of_openrtm_1_0(self):
        old = dict(OLD, **{"dataport.interface_type": "corba_cdr"})
        self.matching(out(offers=old), into(), dataport__dataflow_type="push")
        self.assertEqual(self.chosen(out(offers=old), into()), ["push", "corba_cdr", "new"])
        self.assertEqual(len(self.reasons(out(), into(), dataport__interface_type="CORBA_CDR")), 1)

    def test_nothing_in_common(self):
        self.assertEqual(self.reasons(out(), into(offers=dict(PY2, **{"dataport.interface_type": (
            "shared_memory"
        )}))),
                         ["no interface_type in common (corba_cdr,direct; shared_memory)"])

    def test_given_values_stay(self):
        given = {"dataport.dataflow_type": "pull", "x": "y"}
        properties = ports.connection_properties([out(), into()], given)
        self.assertEqual((properties["dataport.dataflow_type"], properties["x"]), ("pull", "y"))
        self.assertEqual(given, {"dataport.dataflow_type": "pull", "x": "y"})


class Services(Case):
    PROVIDER = service("A.s", ("one", "T", "Provided"))

    def test_alone_or_with_the_other_polarity(self):
        self.matching(self.PROVIDER)
        self.matching(self.PROVIDER, service("B.s", ("one", "Other", "Required")))
        self.matching(service("B.s", ("one", "T", "Required")), self.PROVIDER)

    def test_interfaces_that_do_not_match_are_named(self):
        self.assertEqual(self.reasons(self.PROVIDER, service("B.s", ("one", "T", "Provided"))),
                         ["both have interface one provided"])
        self.assertEqual(self.reasons(self.PROVIDER, service("B.s", ("two", "T", "Required"))),
                         ["/localhost/B.rtc:s has no interface one"])

    def test_mapped_by_hand_from_either_side(self):
        other = service("B.s", ("two", "T", "Required"))
        given = {"B.port.s.required.T.two": "A.port.s.provided.T.one"}
        self.matching(self.PROVIDER, other, **given)
        self.matching(other, self.PROVIDER, **given)

    def test_properties(self):
        self.assertEqual(ports.connection_properties([self.PROVIDER], {}), {"port.port_type": "CorbaPort"})


class Duplicates(Case):
    def connected(self, name, kind, connector_id="i", connector_name="n", far="B.in"):
        return port(
            name, kind, PY2, connectors=[ports.Connector(connector_id, connector_name, [name, far], [])]
        )

    def refused(self, found, name="", connector_id=""):
        with self.assertRaises(errors.Failed) as caught:
            connectors.refuse_duplicate(found, name, connector_id)
        return str(caught.exception)

    def test_pair_name_and_id(self):
        first = self.connected("A.out", "DataOutPort")
        self.assertIn("already connected (id i)", self.refused([first, into()]))
        self.assertIn("a connection with id i", self.refused([first, into(name="C.in")], connector_id="i"))
        self.assertIn("a connection with name n", self.refused([first, into(name="C.in")], name="n"))
        connectors.refuse_duplicate([first, into(name="C.in")], "m", "j")

    def test_every_port_is_looked_at(self):
        last = self.connected("C.in", "DataInPort", far="D.out")
        self.assertIn("/localhost/C.rtc:in", self.refused([out(), last], connector_id="i"))


class Disconnecting(Case):
    """A peer may die at any moment: what counts is whether this end still has the connection."""

    def play(self, *answers, ends=()):
        """disconnect() with these answers, in turn: values, or errors to raise. Returns the operations asked
        for; of another port than this with the name of that. `ends` are the references of the connector.
        """
        asked = []
        script = list(answers)

        async def call(where, ref, operation, *args):
            asked.append(operation if ref == "A.out" else f"{operation} {ref}")
            answer = script.pop(0)
            if isinstance(answer, Exception):
                raise answer
            return answer
        with mock.patch("rtshell_lite.corba.orb.call", call):
            loop.run(connectors.disconnect(out(), ports.Connector("id", "n", list(ends), [])))
        self.assertEqual(script, [])
        return asked

    HELD, FREE = [mock.Mock(connector_id="id")], [mock.Mock(connector_id="other")]

    def test_done(self):
        self.assertEqual(self.play("RTC_OK"), ["disconnect"])

    def test_unknown_is_gone(self):
        self.assertEqual(self.play("BAD_PARAMETER", self.FREE), ["disconnect", "get_connector_profiles"])

    def test_refused_and_gone_all_the_same(self):
        """C++ 2.1 with the dead peer listed second."""
        self.assertEqual(self.play("RTC_ERROR", self.FREE), ["disconnect", "get_connector_profiles"])

    def test_refused_and_still_there(self):
        self.assertEqual(self.play("RTC_ERROR", self.HELD, "RTC_OK"),
                         ["disconnect", "get_connector_profiles", "notify_disconnect"])

    def test_the_death_of_the_far_end_is_passed_on(self):
        dead = errors.ConnectionRefused("x")
        self.assertEqual(self.play(dead, self.HELD, dead, dead, self.FREE)[-1], "get_connector_profiles")

    def test_the_other_ends_forget_it_too(self):
        self.assertEqual(
            self.play(
                "RTC_ERROR", self.FREE, "RTC_OK", errors.Gone("x"), ends=["B.in", "A.out", None, "C.in"]
            )[2:],
            ["notify_disconnect B.in", "notify_disconnect C.in"],
        )

    def test_another_end_that_may_not_have_forgotten_it(self):
        with mock.patch("rtshell_lite.corba.orb.endpoint", lambda ref: ("10.0.0.2", 4000)), \
                self.assertRaises(errors.Uncertain) as caught:
            self.play(
                "RTC_ERROR", self.FREE, errors.Silent("x", "no answer within 3s"), ends=["A.out", "B.in"]
            )
        self.assertIn("connection id is removed here, its end at 10.0.0.2:4000 does not answer (no "
                      "answer within 3s)",
                      str(caught.exception))

    def test_never(self):
        with self.assertRaises(errors.Refused):
            self.play("RTC_ERROR", self.HELD, "RTC_ERROR", self.HELD)
        with self.assertRaises(errors.ConnectionRefused):
            self.play(*[errors.ConnectionRefused("x")] * 3)

    def test_silence_is_not_waited_for_twice(self):
        with self.assertRaises(errors.Silent):
            self.play(errors.Silent("x", "no answer"))


if __name__ == "__main__":
    unittest.main()
