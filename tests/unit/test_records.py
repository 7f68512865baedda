"""Tuples with names, results that are kept, and what a command imports before it does anything."""
import argparse
import contextlib
import io
import itertools
import pickle
import subprocess
import sys
import unittest

import processes
from rtshell_lite import errors, options, records

SLOW = "re enum collections functools gettext shutil textwrap warnings".split()
STARTS = """
import sys
for name in %r:
    sys.modules.pop(name, None)
from rtshell_lite import start
start.quietly("__main__")
from rtshell_lite import cli, options
parser = options.parser(lambda parser: (options.paths(parser), options.null(parser), options.wait(parser, "it is")), "words", "rtls")
print(parser.parse_args(["-0q", "--wait=5", "one", "two"]).paths)
from rtshell_lite.robot import lookup
from rtshell_lite.views import listing
from rtshell_lite.corba.iiop import client
print(sorted(name for name in %r if name in sys.modules and sys.modules[name].__spec__))
import argparse, re
assert re.search("b+", "abbc").end() == 3
argparse.ArgumentParser(description="words").format_help()
""" % (SLOW, SLOW)  # noqa: E501


class Records(unittest.TestCase):
    Point = records.record("Point", "x y")

    def test_items_have_names(self):
        made = self.Point(1, y=2)
        self.assertEqual((made.x, made.y, made), (1, 2, (1, 2)))
        self.assertEqual(made._replace(y=3), self.Point(1, 3))
        self.assertEqual(made._asdict(), {"x": 1, "y": 2})
        self.assertEqual(repr(made), "Point(x=1, y=2)")

    def test_their_number_is_checked(self):
        for given, named in (
            ((1,), {}),
            ((1, 2, 3), {}),
            ((1, 2), {"x": 1}),
            ((1,), {"z": 1}),
            ((1, 2), {"z": 1}),
        ):
            with self.assertRaises(TypeError):
                self.Point(*given, **named)
        with self.assertRaises(TypeError):
            self.Point(1, 2)._replace(z=3)

    def test_paths_survive_pickle(self):
        from rtshell_lite.path import parse
        path = parse("/localhost/a.host_cxt/b.rtc:out")
        self.assertEqual(pickle.loads(pickle.dumps(path)), path)
        self.assertIs(type(pickle.loads(pickle.dumps(path))), type(path))


class Cached(unittest.TestCase):
    def test_results_are_kept_and_bounded(self):
        calls = []

        @records.cached(2)
        def double(number):
            calls.append(number)
            return 2 * number
        self.assertEqual([double(1), double(1), double(2), double(3), double(1)], [2, 2, 4, 6, 2])
        self.assertEqual(calls, [1, 2, 3, 1], "the third result makes it forget the first two")


class Starting(unittest.TestCase):
    def test_a_command_imports_little(self):
        done = subprocess.run(
            [sys.executable, "-S", "-c", "import sys; sys.path.insert(0, %r)\n" % processes.ROOT + STARTS],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            universal_newlines=True,
        )
        needed = ["collections", "functools"] if sys.version_info < (3, 7) else []  # by its own modules
        self.assertEqual((done.stdout, done.stderr), ("['one', 'two']\n%s\n" % needed, ""))


class Counting(unittest.TestCase):
    """Our parser gives words to arguments as argparse does."""

    def parsed(self, kind, kinds, words):
        parser = kind(prog="x", add_help=False)
        parser.add_argument("-o", nargs=kinds[0] or None)
        for number, nargs in enumerate(kinds[1:]):
            parser.add_argument("p%d" % number, nargs=nargs or None)
        try:
            with contextlib.redirect_stderr(io.StringIO()):
                return vars(parser.parse_args(words))
        except (SystemExit, errors.Usage):
            return None

    def test_as_argparse_does(self):
        class Own(options.Parser):  # without the sorting of words
            parse_args = argparse.ArgumentParser.parse_args
        kinds = ("", "?", "*", "+", 2)
        lines = [
            before + ["--"] * dashes + ["w%d" % i for i in range(size)]
            for before in ([], ["-o"], ["-o", "a"], ["-o", "a", "b"])
            for dashes in (0, 1)
            for size in range(4)
        ]
        for number, chosen in enumerate(itertools.product(kinds, kinds)):
            chosen = (kinds[number % 4],) + chosen
            for words in lines:
                with self.subTest(kinds=chosen, words=words):
                    self.assertEqual(
                        self.parsed(Own, chosen, words), self.parsed(argparse.ArgumentParser, chosen, words)
                    )


if __name__ == "__main__":
    unittest.main()
