"""Descriptors from peers and users' stubs, which may be broken or hostile."""
import unittest
from unittest import mock

from rtshell_lite import errors
from rtshell_lite.corba import schemas
from rtshell_lite.giop import cdr, descriptors, marshal
from rtshell_lite.giop.descriptors import ALIAS, CHAR, ENUM, INDIRECT, SEQUENCE, STRUCT
from rtshell_lite.data import type_json

LONG = next(kind for kind, words in descriptors.NAMES.items() if words == "long")


def struct(*members):
    """A descriptor in omniORB's form, IDL:Node:1.0, of (name, descriptor) pairs."""
    return (STRUCT, object, "IDL:Node:1.0", "Node") + tuple(part for member in members for part in member)


def itself():
    """omniORB's reference to an enclosing type."""
    return (INDIRECT, ["IDL:Node:1.0"])


class Adopted(unittest.TestCase):
    def test_a_type_within_a_sequence_of_itself(self):
        found = descriptors.adopted(struct(("value", LONG), ("children", (SEQUENCE, itself(), 0))))
        self.assertIs(dict(descriptors.members(found))["children"][1][1][0], found)

    def test_a_type_that_contains_itself_has_no_end(self):
        inner = (SEQUENCE, struct(("value", LONG), ("self", itself())), 0)
        for members in ([("self", itself())], [("value", LONG), ("children", inner)]):
            with self.assertRaises(errors.BadType) as caught:
                descriptors.adopted(struct(*members))
            self.assertEqual(str(caught.exception), "Node: contains itself")

    def test_one_of_the_same_id_around(self):
        inner = struct(("value", LONG))
        found = descriptors.adopted(
            struct(("children", (SEQUENCE, inner, 0)), ("more", (SEQUENCE, itself(), 0)))
        )
        self.assertIs(dict(descriptors.members(found))["more"][1][1][0], found)

    def test_an_indirection_that_leads_to_a_type_or_to_nothing(self):
        found = descriptors.adopted((SEQUENCE, (INDIRECT, [struct(("value", LONG))]), 0))
        self.assertEqual([name for name, _ in descriptors.members(found[1])], ["value"])
        for nothing in (None, "IDL:Other:1.0", (INDIRECT, ["IDL:Other:1.0"], "x")):
            with self.subTest(nothing), self.assertRaisesRegex(
                errors.BadType, "is used, but nowhere defined"
            ):
                descriptors.adopted((SEQUENCE, (INDIRECT, [nothing]), 0))

    def test_an_indirection_too_deep_is_named(self):
        nested = itself()
        for _ in range(descriptors.DEEPEST):
            nested = (SEQUENCE, nested, 0)
        with self.assertRaisesRegex(errors.BadType, "too deep"):
            descriptors.adopted(struct(("value", nested)))


class FromFiles(unittest.TestCase):
    def test_a_later_definition_of_an_id_is_not_the_earlier_one(self):
        found = type_json.descriptor(b'["struct", "A", "a", [["x", ["struct", "B", "b", [["k", "long"]]]],'
                                     b' ["y", ["struct", "B", "c", [["m", "short"]]]], ["z", ["see", "B"]]]]')
        names = [[name for name, _ in descriptors.members(inner)] for _, inner in descriptors.members(found)]
        self.assertEqual(names, [["k"], ["m"], ["m"]])

    def test_later_definitions_cannot_be_seen(self):
        with self.assertRaisesRegex(errors.BadType, "a type in a file: is used, but nowhere defined"):
            type_json.descriptor(b'["struct", "A", "a", [["x", ["sequence", ["see", "B"], 0]],'
                                 b' ["y", ["struct", "B", "b", [["k", "long"]]]]]]')


class Forms(unittest.TestCase):
    def test_each_kind_has_one(self):
        kinds = set(range(2, 30)) | {descriptors.INDIRECT}
        self.assertEqual(set(descriptors.FORMS), kinds)

    def test_a_kind_that_is_new_is_a_row(self):
        class Words(descriptors.Visitor):
            def other(self, descriptor, *around):
                return ("?",) + around

            def complex(self, descriptor, *around):
                return ("complex",) + around

            def sequence(self, descriptor, *around):
                return self.visit(descriptors.element(descriptor), "sequence", *around)

        new = 99
        alias = (ALIAS, "IDL:X:1.0", "X", (new, 64))
        there = [None]
        there[0] = (SEQUENCE, (INDIRECT, [alias]), 0)
        with mock.patch.dict(descriptors.FORMS, {new: "complex"}):
            self.assertEqual(Words().visit((INDIRECT, there), "end"), ("complex", "sequence", "end"))
        self.assertEqual(Words().visit(alias), ("?",))

    def test_what_has_no_values_is_not_read(self):
        for kind in (1, 99, descriptors.VALUE, INDIRECT + 100):
            for maker in (cdr.Maker, marshal.Maker, marshal.ValueMaker):
                with self.subTest(kind=kind, maker=maker), self.assertRaisesRegex(
                    ValueError, "a value of kind %d" % kind
                ):
                    maker("<").reader((kind, "IDL:X:1.0", "X"))
        for kind in (descriptors.ANY, descriptors.TYPECODE, descriptors.PRINCIPAL, descriptors.LONGDOUBLE):
            with self.assertRaises(ValueError):
                cdr.Maker("<").reader(kind)
            marshal.Maker("<").reader(kind)


class OfOmniorb(unittest.TestCase):
    def test_values_of_an_alias_are_converted(self):
        value = mock.Mock(**{"typecode.return_value": mock.Mock(_d=LONG), "value.return_value": 42})
        listed = (SEQUENCE, (ALIAS, "IDL:Value:1.0", "Value", descriptors.ANY), 0)
        (found,) = schemas._Received(None).visit(listed, [value])
        self.assertEqual((found.descriptor, found.content), (LONG, 42))


class Labels(unittest.TestCase):
    def test_a_label_is_one_character(self):
        self.assertEqual(descriptors.label(CHAR, "a"), "a")
        for wrong in ("ab", "", 5, None, b"a", ["a"]):
            with self.assertRaises(errors.BadType, msg=wrong):
                descriptors.label(CHAR, wrong)


class Items(unittest.TestCase):
    def test_items_are_equal_by_their_enum_and_number(self):
        one, same, other = (descriptors.enum(identifier, "Colour", ["RED", "GREEN"]) for identifier in
                            ("IDL:Colour:1.0", "IDL:Colour:1.0", "IDL:Other:1.0"))
        self.assertEqual(descriptors.kind(one), ENUM)
        self.assertEqual(list(one[3]), list(same[3]))
        self.assertEqual(len(set(one[3]) | set(same[3])), 2)
        for wrong in (one[3][1], other[3][0], 0, "RED", None):
            self.assertNotEqual(one[3][0], wrong)


if __name__ == "__main__":
    unittest.main()
