"""Values of every type of IDL, in and out, through both ORBs to a provider with stubs of omniORBpy and back.
"""
import json
import os
import random
import subprocess
import sys
import tempfile
import unittest

import loops
import random_values
from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.giop import descriptors
from rtshell_lite.data import call_values, datatypes, defaults, values

TESTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
IDL = os.path.join(TESTS, "data", "idl", "valid", "echoes.idl")
OMNIIDL = os.path.join(os.path.dirname(sys.executable), "omniidl")
SAMPLES = 6
DEEP = '{"name": "é日", "phrases": [[], ["a", ""]], "c": "GREEN", "more": [], "flats": [%s, %s]}' % (
    ('{"a": -1, "b": 255, "c": 0.5, "d": "é", "e": true, "f": -9}',) * 2)


@unittest.skipUnless(os.path.exists(OMNIIDL), "needs omniidl and omniORBpy")
class Echoes(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.TemporaryDirectory()
        subprocess.check_call(
            [OMNIIDL, "-bpython", "-Wbinline", "-I" + os.path.dirname(IDL), "-C" + cls.directory.name, IDL]
        )
        cls.provider = subprocess.Popen(
            [sys.executable, os.path.join(TESTS, "unit", "echo_provider.py"), cls.directory.name],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
        )
        cls.reference = cls.provider.stdout.readline().decode().strip()
        cls.types = datatypes.Types(idl=[IDL]).load()
        cls.operations = cls.types.interface("IDL:Echoes/All:1.0").all_operations()

    @classmethod
    def tearDownClass(cls):
        cls.provider.communicate()
        cls.directory.cleanup()

    def setUp(self):
        self.rng = random.Random(7)
        before = orb._orb, os.environ.get("RTSHELL_ORB")
        self.addCleanup(self.restore, *before)

    @staticmethod
    def restore(module, name):
        orb._orb = module
        os.environ.pop("RTSHELL_ORB", None)
        if name is not None:
            os.environ["RTSHELL_ORB"] = name

    def find(self, name):
        return self.types.named(name).descriptor

    def both(self):
        """Let both ORBs have their turn."""
        for name in ("builtin", "omniorb"):
            orb._orb = None
            os.environ["RTSHELL_ORB"] = name
            yield name

    async def call(self, name, given):
        """What an operation returns as JSON, for its arguments as JSON."""
        operation = self.operations[name]
        arguments = call_values.of_json(operation, json.dumps(given), self.find)
        value = await orb.call(
            "w", orb.from_text("w", self.reference), operation.schema(), *arguments, seconds=60
        )
        return call_values.as_dict(operation, value)

    def called(self, name, **given):
        return loops.wait_for(self.call(name, given), 60)

    def test_every_type(self):
        echoing = [
            operation
            for operation in self.operations.values()
            if [each.name for each in operation.parameters] == ["a", "b", "c"]
        ]
        self.assertGreater(len(echoing), 30)
        for name in self.both():
            for operation in echoing:
                self.assertEqual(operation.why_not_callable(), "")
                for one, other in self.samples(operation):
                    with self.subTest(orb=name, operation=operation.idl(), one=one, other=other):
                        self.assertEqual(
                            self.called(operation.name, a=one, b=other), {"result": one, "b": other, "c": one}
                        )

    def samples(self, operation):
        """Pairs of values as JSON: those of the template, and random ones."""
        template = defaults.template(operation.inputs())
        yield template["a"], template["b"]
        for _ in range(SAMPLES):
            yield tuple(values.json(random_values.value(self.rng, operation.result, 3)) for _ in range(2))

    def test_attributes(self):
        for _ in self.both():
            self.assertEqual(self.called("_set_state", state=json.loads(DEEP)), {})
            self.assertEqual(self.called("_get_state"), {"result": json.loads(DEEP)})
            self.assertEqual(self.called("_get_paint"), {"result": "BLUE"})
            self.assertNotIn("_set_paint", self.operations)

    def test_exceptions(self):
        for _ in self.both():
            with self.assertRaises(errors.Raised) as caught:
                self.called("plainly")
            self.assertEqual((caught.exception.name, values.json(caught.exception.value)), ("Plain", {}))
            members = {"what": json.loads(DEEP), "choice": {"_d": (
                "BLUE"
            ), "words": "é"}, "value": {"_type": "wstring", "_value": "日"}}
            with self.assertRaises(errors.Raised) as caught:
                self.called("fully", **members)
            self.assertEqual(
                (caught.exception.name, values.json(caught.exception.value)),
                ("Full", dict(members, **{"class": 7})),
            )

    def test_types_by_name(self):
        for name in (
            "sequence<sequence<IDL:Echoes/Deep:1.0>, 3>",
            "string<4>",
            "wstring<4>",
            "fixed<4, 2>",
            "Object",
            "TypeCode",
            "any",
            "IDL:Echoes/Matrix:1.0",
            "IDL:Echoes/ByChar:1.0",
            "IDL:Echoes/Nodes:1.0",
            "sequence<Object>",
        ):
            for _ in self.both():
                self.assertEqual(self.called("echo_type", a=name, b="long"), {"result": name, "b": (
                    "long"
                ), "c": name})
        with self.assertRaises(errors.NoSuch):
            self.called("echo_type", a="Nothing", b="long")

    def test_a_value_of_a_type_that_contains_itself(self):
        node = {"_type": "IDL:Echoes/Node:1.0", "_value": {"value": 1, "below": [{"value": 2, "below": []}]}}
        deep = {"_type": "IDL:Echoes/Deep:1.0", "_value": dict(json.loads(DEEP), more=[json.loads(DEEP)])}
        choice = {"_type": "IDL:Echoes/ByChar:1.0", "_value": {"_d": "a", "tree": [node["_value"]]}}
        inner = {"_type": "any", "_value": node}
        for _ in self.both():
            for one in (node, deep, choice, inner):
                self.assertEqual(
                    self.called("echo_anything", a=one, b=inner), {"result": one, "b": inner, "c": one}
                )

    def test_numbers_that_omniorbpy_does_not_send(self):
        """In sequences and arrays, it sends 2**64 - 1 for each number above 2**63 - 1, or ends with an
        internal error.
        """
        for name in self.both():
            self.assertEqual(self.called("take_larger", a=[0, 2**63 - 1]), {})
            if name == "builtin":
                self.assertEqual(self.called("take_larger", a=[0, 2**63]), {})
                continue
            with self.assertRaisesRegex(errors.Refused, "set RTSHELL_ORB=builtin"):
                self.called("take_larger", a=[0, 2**63])

    def test_a_wchar(self):
        """omniORBpy sends them, but reads none: our own octets are what it sends."""
        import omniORB
        from omniORB import CORBA
        CORBA.ORB_init(["test"], CORBA.ORB_ID)
        from rtshell_lite.giop import marshal
        for character in "aé日":
            out = bytearray()
            marshal.ValueMaker("<").writer(descriptors.WCHAR)(out, character)
            self.assertEqual(bytes(out), omniORB.cdrMarshal(CORBA.TC_wchar, character, True)[:3])


if __name__ == "__main__":
    unittest.main()
