"""What is reported of a component that others know nothing of: if this fails, an operator looks for the fault
in the wrong place.
"""
import unittest
from unittest import mock

from rtshell_lite import errors, path
from rtshell_lite.corba import orb
from rtshell_lite.net import loop
from rtshell_lite.robot import component, composites, fsm, transitions, tree
from rtshell_lite.system import capture

NODE = tree.Node(path.parse("/localhost/a.rtc"), "component", None)


class Facts(unittest.TestCase):
    def test_an_id_says_four_of_them(self):
        texts = dict(zip(component.FACTS, ("Arm0", "Arm", "moves", "1.2", "Me", "robots")))
        profile = component.Profile(*texts.values(), "", [])
        self.assertEqual(capture.component_id(profile), "RTC:Me:robots:Arm:1.2")
        identity = {name: texts[name] for name in ("vendor", "category", "type_name", "version")}
        self.assertEqual(capture.identity("RTC:Me:robots:Arm:1.2"), identity)
        self.assertEqual(capture.identity("RTC:Me:robots:Arm:1.2:more"), identity)

    def test_an_id_may_be_too_short(self):
        nothing = dict.fromkeys(("vendor", "category", "type_name", "version"), "")
        for short in ("", "RTC", "RTC:", "RTC:::"):
            self.assertEqual(capture.identity(short), nothing)

    def test_they_have_labels(self):
        self.assertEqual(
            component.facts({"vendor": "Me", "category": "robots", "parent": "A"}),
            [("Category", "robots"), ("Vendor", "Me")],
        )


class Asked:
    """Answers calls, by operation; names a Node."""

    path = NODE.path
    typed = None

    def __init__(self, **answers):
        self.answers = answers

    async def call(self, operation, *args):
        return self.answers[operation]

    def patched(self):
        async def call(where, ref, operation, *args, seconds=None):
            return self.answers[operation]
        return mock.patch.object(orb, "call", call)


class Contexts(unittest.TestCase):
    def change(self, code):
        """Why it is not activated where its context answers `code`, and has no other reference of it."""
        node = Asked(
            get_component_state=mock.Mock(_v=1),
            activate_component=code,
            get_owned_contexts=["context"],
            get_profile=mock.Mock(owner=None),
        )
        with node.patched(), mock.patch.object(orb, "narrow", lambda ref, name: ref), self.assertRaises(
            errors.Refused
        ) as caught:
            loop.run(transitions.change(node, transitions.ACTIVATE, index=0, wait=0))
        return str(caught.exception)

    def test_one_that_does_not_know_it(self):
        self.assertEqual(self.change("BAD_PARAMETER"), "/localhost/a.rtc: is not in its execution context 0")

    def test_one_that_refuses(self):
        self.assertEqual(self.change("UNSUPPORTED"), "/localhost/a.rtc: cannot activate: UNSUPPORTED, it "
                                                     "is Inactive")


class Machines(unittest.TestCase):
    def found(self, *services):
        """The reference of the machine of a component with these SDO services, pairs (type, reference)."""
        profiles = [mock.Mock(interface_type=kind, id="1", service=ref) for kind, ref in services]
        with mock.patch.object(fsm.orb, "narrow", lambda ref, name: ref):
            return loop.run(fsm.of(Asked(get_service_profiles=profiles))).ref

    def test_a_service_without_a_reference_is_none(self):
        self.assertEqual(
            self.found(("Other", "other"), (fsm.SERVICE, None), (fsm.SERVICE, "machine")), "machine"
        )
        for services in ((), (("Other", "other"),), ((fsm.SERVICE, None),)):
            with self.assertRaises(errors.NoSuch):
                self.found(*services)


class Composites(unittest.TestCase):
    def test_one_that_does_not_answer_is_unknown(self):
        async def known(node, contexts):
            return {"hand": ("hand0", "/localhost/hand0.rtc")}

        async def call(where, ref, operation):
            return ref

        node = Asked(get_organizations=["arm", "hand"])
        with mock.patch.object(composites, "_composites", known), mock.patch.object(orb, "call", call):
            self.assertEqual(loop.run(composites.belonging(node, [])),
                             [("arm", "Unknown", "Unknown"), ("hand", "hand0", "/localhost/hand0.rtc")])


if __name__ == "__main__":
    unittest.main()
