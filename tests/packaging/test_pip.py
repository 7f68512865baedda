"""What pip makes of the wheel and of a checkout, wherever it puts them."""

import os
import platform
import subprocess
import sys
import unittest

import environments
from robots import ROOT, WHEEL, Robot, run

ONCE = "each Python tries to install the wheel in test_packaging"


@unittest.skipUnless(WHEEL, "no wheel was given in RTSHELL_WHEEL")
class Elsewhere(Robot):
    """pip install with the options that put things elsewhere."""

    def test_commands_are_found_wherever_pip_puts_them(self):
        for option in "--target", "--prefix", "--user":
            with self.subTest(option):
                place = os.path.join(self.directory, option)
                if sys.prefix != sys.base_prefix and option == "--user":
                    continue  # pip refuses it in a virtual environment
                environment = {"PYTHONUSERBASE": place}
                words = [option] + ([place] if option != "--user" else [])
                pip = [
                    sys.executable,
                    "-m",
                    "pip",
                    "--disable-pip-version-check",
                    "install",
                    "-q",
                    "--no-index",
                ]
                status, _, err = run(
                    pip + ["--ignore-installed", "--no-warn-script-location"] + words + [WHEEL],
                    environment=environment,
                )
                self.assertEqual(status, 0, err)
                package = [where for where, _, _ in os.walk(place) if where.endswith("/rtshell_lite")][0]
                result = run(
                    [self.python, "-m", "rtshell_lite", "rtpwd"],
                    environment={"PYTHONPATH": os.path.dirname(package)},
                )
                self.assertEqual(result, (0, "/\n", ""))


def build_tools():
    """The directory of setuptools and wheel that can install a checkout with this Python as it is, or None:
    those with which tests/run has built the wheel, or this Python's own.
    """
    words = (
        "import setuptools, sys, wheel; "
        "print(setuptools.__path__[0]); sys.exit(int(setuptools.__version__.split('.')[0]) < 64)"
    )
    builder = os.path.join(ROOT, ".venv-tests", "build-" + platform.python_version(), "bin", "python")
    for python in builder, sys.executable:
        if os.path.exists(python):
            status, out, _ = run([python, "-c", words])
            if status == 0:
                return os.path.dirname(out.strip())
    return None


class Editable(Robot):
    """pip install -e, without a network: what is changed in the checkout is seen at once."""

    def test_commands_and_modules_are_those_of_the_checkout(self):
        tools = build_tools()
        if tools is None:
            self.skipTest("needs setuptools 64 and wheel for this Python")
        checkout = os.path.join(self.directory, "it's {a} checkout")
        os.mkdir(checkout)
        for name in environments.SOURCES:
            environments.copy(os.path.join(ROOT, name), os.path.join(checkout, name))
        programs = os.path.join(self.directory, "venv", "bin")
        subprocess.check_call([sys.executable, "-m", "venv", os.path.dirname(programs)])
        python = os.path.join(programs, "python")
        offline = ["--no-index", "--no-deps", "--no-build-isolation", "--disable-pip-version-check"]
        installed = run([python, "-m", "pip", "install", "-q"] + offline + ["-e", checkout],
                        environment={"PYTHONPATH": tools})
        self.assertEqual(installed[0], 0, installed)
        self.check_without_omniorb(lambda name: [os.path.join(programs, name)])
        for path, old, new in (
            ("bin/rtpwd", '"""Print the working directory', '"""Say the working directory'),
            ("rtshell_lite/__init__.py", '__version__ = "', '__version__ = "7.'),
        ):
            path = os.path.join(checkout, path)
            with open(path, encoding="utf-8") as file:
                text = file.read()
            self.assertIn(old, text)
            with open(path, "w", encoding="utf-8") as file:
                file.write(text.replace(old, new))
        _, out, _ = run([os.path.join(programs, "rtpwd"), "--help"])
        self.assertIn("Say the working directory", out)
        _, out, _ = run([os.path.join(programs, "rtpwd"), "--version"])
        self.assertEqual(out[:2], "7.")
