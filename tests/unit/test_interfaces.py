"""Interfaces of IDL files: operations and attributes, how IDL spells them, and why one cannot be called."""
import os
import tempfile
import unittest

from rtshell_lite import errors
from rtshell_lite.giop import descriptors
from rtshell_lite.data import build_value, defaults
from rtshell_lite.data.idl import parser

SERVICE = """
module M {
  valuetype Value { public long a; };
  native Cookie;
  exception Broken { string why; long code; };
  exception Empty {};
  interface Later;
  abstract interface Abstracted { void op(); };
  local interface Localised { void op(); };
  interface Base {
    typedef sequence<double, 3> Few;
    const long LIMIT = 2;
    readonly attribute long current;
    attribute long a, b;
    attribute string s getraises (Empty) setraises (Broken, Empty);
    readonly attribute Few few raises (Broken);
    Few get(in long which, out string<4> why, inout Few values) raises (Broken);
    oneway void stop();
  };
  interface Left : Base { Later take(in any x, in Object o, in ::CORBA::TypeCode t, in sequence<string> q); };
  interface Right : Base {
    void value(in Value v);
    void cookie(out Cookie c);
    void abstracted(in Abstracted a);
    void localised(in Localised l);
    void undeclared(in long a, in Nowhere x);
    void asked(in long a) context ("A", "b*");
    attribute Nothing gone;
    readonly attribute sequence<Nothing, 3> lost, _in raises (Empty);
    fixed<4, 2> price(in Base::Few f);
  };
  interface Bottom : Left, Right { void own(); };
  interface Later { Bottom find(); };
  typedef Later Alias;
  interface Named : Alias {};
};
module M { interface Reopened : ::M::Base { Base::Few again(in Broken::Nothing x); }; };
#pragma ID M::Bottom "IDL:other/Bottom:2.3"
"""


def read(text):
    """The Contents of a text."""
    with tempfile.TemporaryDirectory() as directory:
        path = os.path.join(directory, "case.idl")
        with open(path, "w") as file:
            file.write(text)
        return parser.read_file(path)


# of M::Base, as operations
ATTRIBUTES = ["_get_a", "_set_a", "_get_b", "_set_b", "_get_s", "_set_s", "_get_few"]


class Interfaces(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.contents = read(SERVICE)
        cls.by_name = {each.name: each for each in cls.contents.interfaces.values()}

    def lines(self, name):
        interface = self.by_name[name]
        return [each.idl() for each in interface.operations + interface.attributes]

    def reason(self, name):
        return self.by_name["M::Bottom"].all_operations()[name].why_not_callable()

    def test_names(self):
        self.assertEqual(
            sorted(self.by_name),
            [
                "M::Abstracted",
                "M::Base",
                "M::Bottom",
                "M::Later",
                "M::Left",
                "M::Localised",
                "M::Named",
                "M::Reopened",
                "M::Right",
            ],
        )
        self.assertEqual(
            [self.by_name[name].kind for name in ("M::Abstracted", "M::Base", "M::Localised")],
            ["abstract", "", "local"],
        )
        self.assertEqual(self.by_name["M::Base"].repository_id, "IDL:M/Base:1.0")
        self.assertEqual(self.by_name["M::Bottom"].repository_id, "IDL:other/Bottom:2.3")
        self.assertIs(self.contents.interfaces["IDL:other/Bottom:2.3"], self.by_name["M::Bottom"])

    def test_as_idl_spells_them(self):
        self.assertEqual(
            self.lines("M::Base"),
            [
                "M::Base::Few get(in long which, out string<4> why, inout M::Base::Few values) raises "
                "(M::Broken);",
                "oneway void stop();",
                "readonly attribute long current;",
                "attribute long a;",
                "attribute long b;",
                "attribute string s getraises (M::Empty) setraises (M::Broken, M::Empty);",
                "readonly attribute M::Base::Few few raises (M::Broken);",
            ],
        )
        self.assertEqual(self.lines("M::Left"), ["M::Later take(in any x, in Object o, in TypeCode t, "
                                                 "in sequence<string> q);"])
        self.assertIn('void asked(in long a) context ("A", "b*");', self.lines("M::Right"))
        self.assertIn("fixed<4, 2> price(in M::Base::Few f);", self.lines("M::Right"))

    def test_inherited_once(self):
        bottom = self.by_name["M::Bottom"]
        self.assertEqual(
            [each.name for each in bottom.ancestry()], ["M::Bottom", "M::Left", "M::Right", "M::Base"]
        )
        self.assertEqual(
            list(bottom.all_operations()),
            "own take value cookie abstracted localised undeclared asked price get stop".split()
            + "_get_gone _set_gone _get_lost _get_in _get_current".split()
            + ATTRIBUTES,
        )
        operations = bottom.all_operations()
        self.assertEqual(
            [descriptors.words(each) for each in operations["_set_s"].raises], ["Broken", "Empty"]
        )
        self.assertEqual(operations["_get_few"].idl(), "M::Base::Few _get_few() raises (M::Broken);")

    def test_inherited_by_another_name(self):
        self.assertEqual(list(self.by_name["M::Named"].all_operations()), ["find"])

    def test_why_not_callable(self):
        self.assertEqual(self.reason("value"), "v is M::Value, which cannot be sent")
        self.assertEqual(self.reason("cookie"), "c is M::Cookie, which cannot be sent")
        self.assertEqual(self.reason("abstracted"), "a is M::Abstracted, which cannot be sent")
        self.assertEqual(self.reason("localised"), "l is M::Localised, which cannot be sent")
        self.assertEqual(self.reason("asked"), "it has a context clause")
        self.assertRegex(
            self.reason("undeclared"), r"cannot be read: .*case.idl:\d+:\d+: not declared: Nowhere"
        )
        self.assertRegex(self.reason("_get_gone"), "not declared: Nothing")
        self.assertEqual(
            [name for name in self.by_name["M::Bottom"].all_operations() if not self.reason(name)],
            ["own", "take", "price", "get", "stop", "_get_current"] + ATTRIBUTES,
        )
        with self.assertRaisesRegex(errors.BadType, "value: v is M::Value, which cannot be sent"):
            self.by_name["M::Right"].all_operations()["value"].schema()

    def test_as_an_orb_calls_them(self):
        operations = self.by_name["M::Bottom"].all_operations()
        get = operations["get"].schema()
        self.assertEqual(list(map(descriptors.words, get.given)), ["long", "Few"])
        self.assertEqual(list(map(descriptors.words, get.returned)), ["Few", "string<4>", "Few"])
        self.assertEqual(list(get.raised), ["IDL:M/Broken:1.0"])
        self.assertTrue(operations["stop"].schema().is_oneway)
        self.assertFalse(operations["own"].schema().is_oneway)


class Templates(unittest.TestCase):
    def template(self, parameters, types=""):
        contents = read("module M { %s interface I { void op(%s); }; };" % (types, parameters))
        return defaults.template(contents.interfaces["IDL:M/I:1.0"].operations[0].inputs())

    def test_of_arguments(self):
        types = """enum C { RED, GREEN }; struct S { C c; string name; sequence<S> more; octet raw[3]; double m[2][2]; char code[2]; };
            union U switch (C) { case GREEN: long a; default: S s; }; union D switch (long) { default: string s; case 0: S t; };"""  # noqa: E501
        self.assertEqual(
            self.template("in S s, out long gone, inout sequence<double> d, in U u, in D d2", types),
            {
                "s": {
                    "c": ("RED"),
                    "name": "",
                    "more": [],
                    "raw": "AAAA",
                    "m": [[0.0, 0.0], [0.0, 0.0]],
                    "code": "  ",
                },
                "d": [],
                "u": {"_d": "GREEN", "a": 0},
                "d2": {
                    "_d": 0,
                    "t": {
                        "c": ("RED"),
                        "name": "",
                        "more": [],
                        "raw": "AAAA",
                        "m": [[0.0, 0.0], [0.0, 0.0]],
                        "code": "  ",
                    },
                },
            },
        )
        self.assertEqual(self.template("in boolean b, in wchar w, in fixed<4,2> f, in long double l, in "
                                       "unsigned long long u"),
                         {"b": False, "w": " ", "f": "0.00", "l": 0.0, "u": 0})
        self.assertEqual(self.template(""), {})

    def test_decimal_numbers(self):
        price = (descriptors.FIXED, 5, 2)
        for written, expected in (
            ("-1.5", "-1.50"),
            (12, "12.00"),
            (0.25, "0.25"),
            ("-0", "0.00"),
            ("0999.990", "999.99"),
        ):
            self.assertEqual(build_value.build(price, written, "price"), expected)
        for written in ("1000", "0.001", "x", "", 1e-9, float("nan"), True, None, [1]):
            with self.assertRaises(errors.BadValue, msg=written):
                build_value.build(price, written, "price")
        self.assertEqual(build_value.build(descriptors.LONGDOUBLE, 1, "x"), 1.0)

    def test_too_large(self):
        for array in ("long", "octet", "S"):
            with self.assertRaisesRegex(errors.BadType, "too large to be written down"):
                self.template("in T t", "struct S { long a; }; typedef %s T[1000][1000];" % array)


if __name__ == "__main__":
    unittest.main()
