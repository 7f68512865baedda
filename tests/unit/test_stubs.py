"""The library's documents and type stubs say what is there; what it does is in tests/waiting/test_api.py."""
import os
import re
import subprocess
import sys
import tempfile
import unittest

from rtshell_lite import api

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DOCS = os.path.join(ROOT, "docs")
EXAMPLES = ["example_test.py", "example_launch.py", "example_log.py"]
PUBLIC = [
    "rtshell_lite.api", "rtshell_lite.mocks", "rtshell_lite.xmlprofile.model",
    "rtshell_lite.xmlprofile.fields",
]


class Documents(unittest.TestCase):
    def test_the_table_names_what_there_is(self):
        with open(os.path.join(DOCS, "library.md"), encoding="utf-8") as file:
            named = set(re.findall(r"\bapi\.(\w+)", file.read()))
        self.assertEqual(named - set(api.__all__), set())
        self.assertEqual(
            set(api.__all__)
            - named
            - {"Component", "Connection", "Context", "Event", "Finding", "Manager", "Port", "Service"},
            set(),
        )


class Types(unittest.TestCase):
    """The stubs are true, and a program that is annotated can use them. (mypy is a developer's tool: .ci/run
    installs it.)
    """

    def mypy(self, *words):
        tools = os.path.join(ROOT, ".venv-tools", "bin", "python")
        for python in tools, sys.executable:
            if os.path.exists(python) and not subprocess.call(
                [python, "-c", "import mypy"], stderr=subprocess.DEVNULL
            ):
                with tempfile.TemporaryDirectory() as cache:
                    done = subprocess.run(
                        [python, "-m"] + list(words),
                        cwd=ROOT,
                        stdout=subprocess.PIPE,
                        stderr=subprocess.STDOUT,
                        env=dict(os.environ, MYPYPATH=ROOT, PYTHONPATH=ROOT, MYPY_CACHE_DIR=cache),
                    )
                self.assertEqual(done.returncode, 0, done.stdout.decode())
                return
        self.skipTest("needs mypy")

    def test_stubs_are_true(self):
        self.mypy("mypy.stubtest", "--ignore-missing-stub", "--concise", *PUBLIC)

    def test_api_and_examples_are_well_typed(self):
        self.mypy("mypy", "--strict", "--config-file", os.devnull, os.path.join("rtshell_lite", "api.pyi"),
                  *[os.path.join(DOCS, name) for name in EXAMPLES])


if __name__ == "__main__":
    unittest.main()
