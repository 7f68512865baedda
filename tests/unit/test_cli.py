"""What every command shares, tested with a command of our own: options anywhere, a line for each failure,
exit statuses.
"""
import io
import os
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

from rtshell_lite import cli, notes, options

COMMAND = '''\
"""Do something for a test.

examples:
  rtfoo a
"""
from rtshell_lite import start
start.quietly(__name__)

from rtshell_lite import cli, errors, options


def arguments(parser):
    options.paths(parser, nargs="*")
    parser.add_argument("-l", action="count", default=0)
    parser.add_argument("-n", type=int)
    parser.add_argument("--shell", nargs="?", const="sh", choices=["sh", "fish"])
    options.wait(parser, "it is done")


def run(args):
    if args.paths[:1] == ["bug"]:
        raise KeyError("x")
    if args.paths[:1] == ["lacking"]:
        import json_of_some_python
    if args.paths[:1] == ["io"]:
        open("/does/not/exist")
    if args.paths[:1] == ["fail"]:
        tally = cli.Tally()
        for word in args.paths[1:]:
            tally.add({"3": errors.NotFound("a"), "4": errors.Unreachable("b", "gone"), "0": "fine"}[word])
        return tally.status()
    cli.note("a note")
    cli.detail("a detail")
    print(args.paths, args.l, args.n, args.shell, args.wait, args.timeout)


cli.main(arguments, run, __doc__)
'''

# Imports all that there is, and prints what of the process has changed. (omniORB itself adds a directory to
# sys.path.)
IMPORTING = """
import importlib, os, pkgutil, signal, sys, threading, warnings
import rtshell_lite

def process():
    numbers = set(range(1, signal.NSIG)) - {signal.SIGKILL, signal.SIGSTOP}
    return {"signals": [signal.getsignal(number) for number in sorted(numbers)],
            "path": [path for path in sys.path if "omniORB" not in path], "warnings": list(warnings.filters),
            "streams": [sys.stdin, sys.stdout, sys.stderr], "hooks": [sys.excepthook, getattr(sys, "unraisablehook", None)],
            "arguments": list(sys.argv), "environment": dict(os.environ), "directory": os.getcwd(),
            "threads": threading.enumerate(), "finders": sys.meta_path + sys.path_hooks}

for module in pkgutil.walk_packages(rtshell_lite.__path__, "rtshell_lite."):
    before = process()
    try:
        importlib.import_module(module.name)
    except ImportError as e:
        assert "omniORB" in str(e), e
    print("".join(module.name + ": " + what for what, value in process().items() if value != before[what]), end="")
"""  # noqa: E501


def environment(**more):
    return dict(os.environ, PYTHONPATH=os.pathsep.join(p for p in sys.path if p), **more)


class Import(unittest.TestCase):
    def test_changes_nothing_in_the_process(self):
        """If this fails, a program that uses us as a library loses its own Ctrl-C, path or streams."""
        ran = subprocess.run([sys.executable, "-c", IMPORTING], env=environment(), cwd="/",
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertEqual((ran.returncode, ran.stdout, ran.stderr), (0, b"", b""))


class Command(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.file = os.path.join(cls.folder.name, "rtfoo")
        with open(cls.file, "w") as out:
            out.write(COMMAND)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def foo(self, *words, **variables):
        ran = subprocess.run(
            [sys.executable, self.file] + list(words),
            env=environment(**variables),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            stdin=subprocess.DEVNULL,
        )
        return ran.returncode, ran.stdout.decode("utf-8"), ran.stderr.decode("utf-8")

    def said(self, *words, **variables):
        return self.foo(*words, **variables)[1].strip()

    def test_where_the_first_words_of_a_line_lead(self):
        """For completion: the words, the option whose value comes next, whether options have ended."""
        parser = options.Parser()
        parser.add_argument("-l", action="count")
        parser.add_argument("-n", type=int)
        for words, expected in (
            (["a", "-l", "b"], (["a", "b"], None, False)),
            (["a", "-n"], (["a"], "n", False)),
            (["-n", "5"], ([], None, False)),
            (["-n", "5", "a"], (["a"], None, False)),
            (["-n5", "a"], (["a"], None, False)),
            (["a", "-l"], (["a"], None, False)),
            (["a", "--", "-n"], (["a", "-n"], None, True)),
        ):
            found, option, is_ended = parser.unfinished(words)
            self.assertEqual((found, option and option.dest, is_ended), expected, words)

    def test_options_stand_anywhere(self):
        expected = "['a', 'b'] 2 5 None None 3.0"
        for words in (["-ll", "-n5", "a", "b"], ["a", "-l", "b", "-n", "5", "-l"], ["a", "b", "-lln", "5"],
                      ["-l", "-n=5"[:2] + "5", "-l", "--", "a", "b"]):
            self.assertEqual(self.said(*words), expected)

    def test_numbers_below_zero_and_a_dash_are_arguments(self):
        self.assertEqual(self.said("a", "-5", "-", "-.5"), "['a', '-5', '-', '-.5'] 0 None None None 3.0")
        self.assertEqual(self.said("--", "-l"), "['-l'] 0 None None None 3.0")

    def test_an_optional_value_is_not_taken_from_the_paths(self):
        self.assertEqual(self.said("--wait", "a"), "['a'] 0 None None 5.0 3.0")
        self.assertEqual(self.said("--wait", "2", "a"), "['a'] 0 None None 2.0 3.0")
        self.assertEqual(self.said("--wait=2", "a"), "['a'] 0 None None 2.0 3.0")
        self.assertEqual(self.said("--shell", "x"), "['x'] 0 None sh None 3.0")
        self.assertEqual(self.said("--shell", "fish"), "[] 0 None fish None 3.0")

    def test_wrong_usage_is_one_line_and_2(self):
        for words in (["--nope"], ["--tim", "3"], ["-n", "x"], ["-n"], ["--timeout", "0"], ["--timeout=nan"],
                      ["--timeout", "-1"], ["-z"], ["-lz"]):
            status, out, err = self.foo(*words)
            self.assertEqual((status, out, err.count("\n")), (2, "", 1), (words, err))
            self.assertTrue(err.startswith("rtfoo: ") and "--help" in err, err)

    def test_the_timeout_comes_from_the_environment_and_the_option_wins(self):
        self.assertTrue(self.said("a", RTSHELL_TIMEOUT="7").endswith("7.0"))
        self.assertTrue(self.said("a", "--timeout", "1", RTSHELL_TIMEOUT="7").endswith("1.0"))
        self.assertEqual(self.foo("a", RTSHELL_TIMEOUT="soon")[0], 2)

    def test_notes_and_details(self):
        self.assertEqual(self.foo("a")[2], "rtfoo: a note\n")
        self.assertEqual(self.foo("a", "-q")[2], "")
        self.assertEqual(self.foo("a", "-v")[2], "rtfoo: a note\nrtfoo: a detail\n")

    def test_statuses_of_several_objects(self):
        for words, expected in (["0", "0"], 0), (["3", "3"], 3), (["3", "4"], 5), (["0", "3"], 5), (["4"], 4):
            self.assertEqual(self.foo("fail", *words)[0], expected, words)

    def test_a_bug_is_70_and_shows_where_on_demand(self):
        status, _, err = self.foo("bug")
        self.assertEqual((status, err.count("\n")), (70, 1))
        self.assertIn("Traceback", self.foo("bug", RTSHELL_DEBUG="1")[2])

    def test_a_python_without_a_standard_module(self):
        """Debian's python3-minimal lacks json and a dozen others."""
        self.assertEqual(self.foo("lacking")[0::2], (1, (
            "rtfoo: this Python lacks its module json_of_some_python, which is needed for that; a whole "
            "one has it (Debian: python3, not python3-minimal)\n")))

    def test_a_local_failure_is_1(self):
        self.assertEqual(self.foo("io")[0::2], (1, "rtfoo: /does/not/exist: No such file or directory\n"))

    def test_a_failure_that_only_has_words(self):
        said = io.StringIO()
        with mock.patch("sys.stderr", said):
            cli.complain(OSError("timed out"))
        self.assertTrue(said.getvalue().endswith(": timed out\n"), said.getvalue())

    def test_help_and_version(self):
        status, out, err = self.foo("--help")
        self.assertEqual((status, err), (0, ""))
        self.assertIn("Do something for a test.", out)
        self.assertIn("rtfoo a", out)
        self.assertEqual(self.foo("--version")[0], 0)

    def test_streams_that_are_missing_or_full(self):
        for redirection, expected in (">&-", 1), (">/dev/full", 1), ("2>&-", 0), ("<&-", 0):
            ran = subprocess.run(["sh", "-c", '"$0" "$1" a ' + redirection, sys.executable, self.file],
                                 env=environment(),
                                 stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            self.assertEqual(ran.returncode, expected, (redirection, ran.stderr))

    def test_a_reader_that_went_away_is_141_in_silence(self):
        ran = subprocess.Popen([sys.executable, self.file, "-q"] + ["x" * 100] * 1000, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE,
                               env=environment())
        ran.stdout.close()
        self.assertEqual((ran.wait(20), ran.stderr.read()), (141, b""))
        ran.stderr.close()


class Reading(unittest.TestCase):
    def test_a_command_that_waits_for_the_terminal_says_so(self):
        for name, on_terminal, wanted in ("-", True, "Ctrl-D"), ("-", False, ""), ("file", True, ""):
            stdin = mock.Mock(isatty=lambda: on_terminal)
            with mock.patch.object(sys, "stdin", stdin), mock.patch.object(
                sys, "stderr", io.StringIO()
            ) as said, mock.patch.object(notes, "listener", cli._hear):
                notes.reading(name, "an RtsProfile")
            self.assertEqual(
                "reading an RtsProfile from standard input; Ctrl-D ends it" in said.getvalue(), bool(wanted)
            )


class Files(unittest.TestCase):
    def test_two_that_write_to_one_file(self):
        """The file is the one that either of them wrote, and there are no others."""
        program = ("import sys; from rtshell_lite import files\n"
                   "for _ in range(30): files.write(sys.argv[1], sys.argv[2] * 1000000)")
        with tempfile.TemporaryDirectory() as directory:
            target = os.path.join(directory, "robot.rtsys")
            writers = [subprocess.Popen([sys.executable, "-c", program, target, letter]) for letter in "ab"]
            self.assertEqual([writer.wait() for writer in writers], [0, 0])
            self.assertEqual(os.listdir(directory), ["robot.rtsys"])
            with open(target) as file:
                self.assertIn(file.read(), ("a" * 1000000, "b" * 1000000))

    def test_the_longest_names(self):
        """As long as the file system allows: 255 octets."""
        names = ["a" * 255, "b" * 250, "\u00e9" * 127, "\u3042" * 85]
        program = (
            "import sys; from rtshell_lite import files\nfor name in sys.argv[1:]: files.write(name, name)"
        )
        with tempfile.TemporaryDirectory() as directory:
            subprocess.check_call(
                [sys.executable, "-c", program] + [os.path.join(directory, name) for name in names]
            )
            self.assertEqual(set(os.listdir(directory)), set(names))


if __name__ == "__main__":
    unittest.main()
