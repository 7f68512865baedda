"""Run the tests of one module, a job: report.py DIRECTORY MODULE [PATTERN...]

A test module that needs omniORBpy says so when it is imported:
    try:
        import omniORB
    except ImportError:
        raise unittest.SkipTest("needs omniORBpy")
"""
import fnmatch
import os
import sys
import unittest

import jobs

TESTS = os.path.dirname(jobs.HERE)


class Outcomes(unittest.TestResult):
    """Keeps the tests that passed, too."""

    def __init__(self):
        super().__init__()
        self.passed = []

    def addSuccess(self, test):
        self.passed.append(test)

    def listed(self):
        """[(name, "pass", "skip" or "fail", explanation)]"""
        passed = [(test, "") for test in self.passed] + self.expectedFailures
        unexpected = [(test, "expected to fail, but passed") for test in self.unexpectedSuccesses]
        kinds = {"pass": passed, "skip": self.skipped, "fail": self.failures + self.errors + unexpected}
        return [(test.id(), outcome, text) for outcome, tests in kinds.items() for test, text in tests]


def flat(suite):
    for test in suite:
        if isinstance(test, unittest.TestSuite):
            yield from flat(test)
        else:
            yield test


def is_meant(name, patterns):
    """Does a pattern match the test? A module that could not be imported always counts."""
    if name.startswith("unittest.loader"):
        return True
    return any(pattern in name or fnmatch.fnmatch(name, pattern) for pattern in patterns or [""])


def main():
    _, (module, *patterns) = jobs.begin()
    sys.path += [os.path.join(TESTS, folder) for folder in ("unit", "sim")]  # whose peers others use, too
    place, name = os.path.split(os.path.join(TESTS, module))
    found = unittest.defaultTestLoader.discover(place, name + ".py", place)
    outcomes = Outcomes()
    unittest.TestSuite(test for test in flat(found) if is_meant(test.id(), patterns)).run(outcomes)
    jobs.finish(outcomes.listed())


if __name__ == "__main__":
    main()
