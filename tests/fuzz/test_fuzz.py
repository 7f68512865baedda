"""A few corrupted inputs of every kind (see fuzz.py), and all that have ever failed,
tests/data/fuzz/TARGET/*.
"""
import importlib.util
import unittest

import fuzz

ONCE = True  # one Python of the matrix is enough
CASES = {
    "paths": 3000,
    "xml": 400,
    "yaml": 400,
    "logs": 400,
    "idl": 250,
    "values": 1500,
    "cdr": 500,
    "requests": 1000,
    "answers": 500,
    "results": 1000,
    "replies": 60,
    "builtin": 60,
}


class Fuzz(unittest.TestCase):
    def setUp(self):
        self.targets = fuzz.targets()
        if importlib.util.find_spec("omniORB") is None:
            del self.targets["replies"]

    def test_inputs_that_once_failed_pass(self):
        count = 0
        for name, target in sorted(self.targets.items()):
            each = target()
            each.prepare()
            self.addCleanup(each.done)
            for path in fuzz.saved(name):
                with self.subTest(path=path), open(path, "rb") as file:
                    self.assertIn(fuzz.tried(each, file.read()), (None, "refused"))
                count += 1
        self.assertGreater(count, 3)

    def test_new_cases(self):
        """Each is read or refused, soon, in little memory; and what is read can be written and read again."""
        for name, target in sorted(self.targets.items()):
            with self.subTest(target=name):
                number, read, wrong = fuzz.fuzz(target(), "ci", cases=CASES[name], report=lambda line: None)
                self.assertEqual([(case, data, why) for case, data, why in wrong], [])
                self.assertGreater(read, 0, "nothing was read: the cases are too spoilt to find anything")


if __name__ == "__main__":
    unittest.main()
