"""A robot with nothing but Python and the wheel, for tests of what is installed there.

tests/run gives the built wheel in RTSHELL_WHEEL and omniORBpy's in RTSHELL_OMNIORB_WHEEL; the Python
that runs this needs neither of them installed.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import invocations

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
WHEEL, OMNIORB_WHEEL = (
    os.environ.get(name) and os.path.abspath(os.environ[name])
    for name in ("RTSHELL_WHEEL", "RTSHELL_OMNIORB_WHEEL")
)
REPORTING = {"rtsh", "rtdoctor"}  # that nobody listens is what their commands say, or a finding


def names(directory, suffix=""):
    found = [name for name in os.listdir(os.path.join(ROOT, directory)) if name.endswith(suffix)]
    return sorted(name[: len(name) - len(suffix)] for name in found if name[0] != "." and "_" not in name)


def read(*path):
    with open(os.path.join(ROOT, *path), encoding="utf-8") as file:
        return file.read()


def run(words, **keywords):
    """Status, stdout and stderr of a program, in an environment where neither package can be found by
    accident.
    """
    environment = {"PATH": "/usr/bin:/bin", "HOME": "/nonexistent", "LC_ALL": "C"}
    environment.update(keywords.pop("environment", {}))
    process = subprocess.Popen(
        words,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env=environment,
        universal_newlines=True,
        cwd=keywords.pop("cwd", "/"),
        **keywords,
    )
    out, err = process.communicate(timeout=120)
    return process.returncode, out, err


def files(directory, leave_out=None):
    """Contents of all files below a directory whose path does not match."""
    found = {}
    for where, _, members in os.walk(directory):
        for path in [os.path.join(where, name) for name in members]:
            if not leave_out or not re.search(leave_out, path):
                with open(path, "rb") as file:
                    found[os.path.relpath(path, directory)] = file.read()
    return found


@unittest.skipUnless(WHEEL, "no wheel was given in RTSHELL_WHEEL")
class Robot(unittest.TestCase):
    """Base of the tests that use the wheel on a Python with nothing in it."""

    @classmethod
    def setUpClass(cls):
        cls.top = os.path.realpath(tempfile.mkdtemp(prefix="rt-"))
        subprocess.check_call([sys.executable, "-m", "venv", "--without-pip", os.path.join(cls.top, "bare")])
        cls.python = os.path.join(cls.top, "bare", "bin", "python")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.top)

    def setUp(self):
        self.directory = tempfile.mkdtemp(dir=self.top)

    def from_wheel(self, *words, **keywords):
        return run(
            [self.python, "-m", "rtshell_lite"] + list(words), environment={"PYTHONPATH": WHEEL}, **keywords
        )

    def unpack(self, *wheels):
        place = os.path.join(self.directory, "a place")
        result = self.from_wheel("--unpack", place, *wheels)
        self.assertEqual(result, (0, "export PATH='%s/bin':$PATH\n" % place, ""))
        return place

    def unpacked(self):
        """A copy of what one `unpack` has laid out for all tests, as compiling it takes long."""
        laid_out = os.path.join(self.top, "laid out")
        if not os.path.exists(laid_out):
            shutil.move(self.unpack(), laid_out)
        place = os.path.join(self.directory, "a place")
        shutil.copytree(laid_out, place, symlinks=True)
        return place

    def check_without_omniorb(self, command, chosen=("rtls", "rtpwd", "rtcon")):
        """`command(name)` gives the words that start a command; there is no omniORBpy, and nobody listens."""
        for name in chosen:
            with self.subTest(name):
                start = command(name)
                environment = {"PYTHONPATH": WHEEL} if "-m" in start else {}
                status, out, err = run(start + ["--help"], environment=environment)
                self.assertEqual((status, err), (0, ""))
                self.assertIn("examples:\n  " + name, out)
                self.assertRegex(out, "usage: %s " % name)
                self.assertEqual(run(start + ["--version"], environment=environment)[0], 0)
                asking = start + self.asking(name)
                self.check_line(name, 2, run(asking + ["--nonsense"], environment=environment), "--nonsense")
                if name in invocations.stated("invocation") and name not in REPORTING:
                    status, out, err = run(asking, environment=environment)
                    self.assertIn(status, (1, 4, 5), err)
                    self.assertIn("connection refused", out + err)

    def asking(self, name):
        """Arguments with which a command must contact somebody, if it ever does."""
        places = {
            "SERVER": "/localhost:1/a.cxt",
            "A": "/localhost:1/a.rtc",
            "B": "/localhost:1/b.rtc",
            "MGR": "/localhost:1/a.mgr",
            "FILE": os.path.join(ROOT, "tests", "data", "valid", "as-rtcryo-writes.xml"),
            "OUT": os.path.join(self.directory, "out"),
        }
        return invocations.words(invocations.stated("invocation").get(name, [""])[0], places)

    def check_line(self, prog, status, result, part):
        """One line on stderr, nothing on stdout."""
        self.assertEqual(result[:2], (status, ""), result[2])
        self.assertRegex(result[2], r"\A%s: [^\n]*\n\Z" % prog)
        self.assertIn(part, result[2])
