"""Run the tests of one module and write what became of each: report.py FILE MODULE [PATTERN...]

A test module that needs omniORBpy says so when it is imported:
    try:
        import omniORB
    except ImportError:
        raise unittest.SkipTest("needs omniORBpy")
"""
import fnmatch
import json
import os
import signal
import sys
import threading
import unittest
import zlib

TESTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


class Outcomes(unittest.TestResult):
    def __init__(self):
        unittest.TestResult.__init__(self)
        self.outcomes = []

    def note(self, test, outcome, text=""):
        self.outcomes.append((test.id(), outcome, text))

    def addSuccess(self, test):
        self.note(test, "pass")

    def addError(self, test, err):
        unittest.TestResult.addError(self, test, err)
        self.note(test, "fail", self.errors[-1][1])

    def addFailure(self, test, err):
        unittest.TestResult.addFailure(self, test, err)
        self.note(test, "fail", self.failures[-1][1])

    def addSubTest(self, test, subtest, err):
        unittest.TestResult.addSubTest(self, test, subtest, err)
        if err is not None:
            kept = self.failures if issubclass(err[0], test.failureException) else self.errors
            self.note(subtest, "fail", kept[-1][1])

    def addSkip(self, test, reason):
        self.note(test, "skip", reason)

    def addExpectedFailure(self, test, err):
        self.note(test, "pass")

    def addUnexpectedSuccess(self, test):
        self.note(test, "fail", "expected to fail, but passed")


def flat(suite):
    for test in suite:
        if isinstance(test, unittest.TestSuite):
            yield from flat(test)
        else:
            yield test


def meant(test, patterns):
    """Does a pattern match the test? A module that could not be imported always counts."""
    name = test.id()
    return not patterns or name.startswith("unittest.loader") or \
        any(pattern in name or fnmatch.fnmatch(name, pattern) for pattern in patterns)


def has_turn(test, part):
    """Is the test one of the `part`, one in N, always the same; "" is all."""
    return zlib.crc32(test.id().encode()) % int(part or 1) == 0 or test.id().startswith("unittest.loader")


def die_with_parent():
    sys.stdin.read()
    os.killpg(0, signal.SIGKILL)


def main():
    path = sys.argv[1]
    module = sys.argv[2]
    patterns = sys.argv[3:]
    threading.Thread(target=die_with_parent, daemon=True).start()
    here = os.path.dirname(os.path.join(TESTS, module))
    found = unittest.defaultTestLoader.discover(here, os.path.basename(module) + ".py", here)
    outcomes = Outcomes()
    part = os.environ.get("RTSHELL_PART", "")
    unittest.TestSuite(test for test in flat(found) if meant(test, patterns) and has_turn(test, part)).run(
        outcomes
    )
    with open(path, "w") as file:
        json.dump(outcomes.outcomes, file)
    sys.stdout.flush()
    os._exit(0)  # no thread of a test holds the process


if __name__ == "__main__":
    main()
