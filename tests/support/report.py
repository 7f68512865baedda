"""Run the tests of one module, a job: report.py DIRECTORY MODULE PART [PATTERN...]

A test module that needs omniORBpy says so when it is imported:
    try:
        import omniORB
    except ImportError:
        raise unittest.SkipTest("needs omniORBpy")
"""
import fnmatch
import os
import unittest
import zlib

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


def has_turn(name, part, patterns):
    """Does a pattern match the test, and is it one of the `part`, one in N, always the same? A module that
    could not be imported always counts.
    """
    if name.startswith("unittest.loader"):
        return True
    matches = any(pattern in name or fnmatch.fnmatch(name, pattern) for pattern in patterns or [""])
    return matches and zlib.crc32(name.encode()) % part == 0


def main():
    _, (module, part, *patterns) = jobs.begin()
    place, name = os.path.split(os.path.join(TESTS, module))
    found = unittest.defaultTestLoader.discover(place, name + ".py", place)
    outcomes = Outcomes()
    unittest.TestSuite(test for test in flat(found) if has_turn(test.id(), int(part), patterns)).run(outcomes)
    jobs.finish(outcomes.listed())


if __name__ == "__main__":
    main()
