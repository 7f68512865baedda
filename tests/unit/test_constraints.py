"""Constraints of configuration parameters: if these fail, rtconf set warns of good values, or of none."""
import unittest

from rtshell_lite.robot import constraints

FITS = [  # constraint, values that fit it, values that do not
    ("", ["", "abc", "1"], []),
    ("0<=x<=150", ["0", "150", "1.5", " 7 ", "1e2"], ["-1", "150.1", "abc", "", "nan", "0x10", "1_0"]),
    ("0<x<150", ["0.1", "149"], ["0", "150"]),
    ("0 < x <= 1", ["1"], ["0", "2"]),
    ("x<100", ["-5", "99.9"], ["100"]),
    ("x <= 100", ["100"], ["100.5"]),
    ("x>=-1.5", ["-1.5", "7"], ["-2"]),
    ("x > 0", ["1"], ["0"]),
    ("(red,green, blue)", ["red", "blue", "red,green"], ["", "yellow", "red,yellow"]),
    ("5", ["5", "5.0"], ["6", "five"]),
    ("x>0,x<10", ["1,2", "1", "1,2,99"], ["0,2", "1,10"]),
    ("x>0", ["1,2,3"], ["1,0,3"]),
    ("{a: x>0, b: , c: 1<=x<=2}", ["{a: 1, b: z, c: 2}", "a: 1", "d: 9"], ["{a: 0}", "{a: 1, c: 3}"]),
    ("anything", ["1", "abc"], []),
    ("a<x<b", ["7", "abc"], []),
    ("0<=x<=", ["7", "-9"], []),
    ("x", ["1", "abc"], []),
]


class Fits(unittest.TestCase):
    def test_each_form(self):
        for constraint, good, bad in FITS:
            for value in good + bad:
                with self.subTest(constraint=constraint, value=value):
                    self.assertIs(constraints.fits(constraint, value), value in good)


class Doubts(unittest.TestCase):
    def check(self, present, value, expected, **sets):
        found = constraints.doubts(
            {"p": present}, {"p": value}, {name: {"p": text} for name, text in sets.items()}
        )
        self.assertEqual([reason for _, reason in found], expected)

    def test_numbers(self):
        self.check("0", "abc", ["abc is not a number, unlike the old value (0)"])
        self.check("0,1.5", "2,b", ["2,b is not a number, unlike the old value (0,1.5)"])
        self.check("0", "", ["'' is not a number, unlike the old value (0)"])
        for present, value in (
            ("0", "-1e-3"),
            ("abc", "def"),
            ("abc", "1"),
            ("", "x"),
            ("0,1", "2"),
            ("1", "2,3"),
        ):
            self.check(present, value, [])

    def test_constraints(self):
        for name in ("__constraints__", "__constraint__"):
            self.check("5", "200", ["200 does not fit the component's constraint 0<=x<=150"], **{name: (
                "0<=x<=150"
            )})
        doubts = ["abc is not a number, unlike the old value (5)"]
        self.check("5", "abc", doubts, __constraints__="0<=x<=150")
        self.check(
            "red",
            "pink",
            ["pink does not fit the component's constraint (red,blue)"],
            __constraints__="(red,blue)",
        )
        self.check("5", "7", [], __constraints__="0<=x<=150", __constraint__="x>100")
        self.check("5", "700", [], default="0<=x<=150")


if __name__ == "__main__":
    unittest.main()
