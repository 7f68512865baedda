"""The wheel as installed on a robot: if this fails, the commands may work only here."""

import glob
import os
import re
import subprocess
import sys
import unittest
import zipfile

from robots import ROOT, WHEEL, Robot, names, read, run

LARGEST = 1 << 20  # octets


def manual_pages(top):
    """Paths of all files below a share/man."""
    return sorted(
        os.path.relpath(path, top)
        for path in glob.glob(os.path.join(glob.escape(top), "**", "*.*"), recursive=True)
    )


@unittest.skipUnless(WHEEL, "no wheel was given in RTSHELL_WHEEL")
class Wheel(unittest.TestCase):
    """What is in the wheel, and what is not."""

    def members(self):
        with zipfile.ZipFile(WHEEL) as wheel:
            return wheel.namelist()

    def test_name_and_size(self):
        self.assertRegex(os.path.basename(WHEEL), r"^rtshell_lite-\d+\.\d+\.\d+-py3-none-any\.whl$")
        self.assertLess(os.path.getsize(WHEEL), LARGEST)

    def test_modules_are_the_source(self):
        """What is installed on a robot without network is what people read there."""
        with zipfile.ZipFile(WHEEL) as wheel:
            for name in self.members():
                if re.match(r"rtshell_lite/.*\.py$", name):
                    source = read(re.sub(r"rtshell_lite/commands/(rt\w+)\.py", r"bin/\1", name))
                    self.assertTrue(wheel.read(name).decode() == source, name)

    def test_only_the_package_its_commands_and_its_papers(self):
        for name in self.members():
            self.assertRegex(
                name, r"^rtshell_lite/|^rtshell_lite-[^/]+\.(dist-info|data/scripts|data/data/share/man)/"
            )
        self.assertFalse(
            [name for name in self.members() if re.search(r"(^|/)(mock_components|tests?)(/|$)|\.pyc$", name)]
        )

    def test_all_commands_and_modules(self):
        scripts = sorted(name.rpartition("/")[2] for name in self.members() if ".data/scripts/" in name)
        self.assertEqual(scripts, sorted(names("bin") + ["rtshell_lite"]))
        modules = [name for name in self.members() if name.startswith("rtshell_lite/commands/rt")]
        self.assertEqual(sorted(modules), ["rtshell_lite/commands/%s.py" % name for name in names("bin")])
        for where, directories, files in os.walk(os.path.join(ROOT, "rtshell_lite")):
            directories[:] = [name for name in directories if name != "__pycache__"]
            for name in files:
                if name.endswith((".py", ".js", ".css", ".html")):
                    path = os.path.relpath(os.path.join(where, name), ROOT).replace(os.sep, "/")
                    self.assertIn(path, self.members())

    def test_all_manual_pages(self):
        pages = [name.partition("/share/man/")[2] for name in self.members() if ".data/data/" in name]
        self.assertEqual(sorted(pages), manual_pages(os.path.join(ROOT, "man")))

    def test_metadata(self):
        with zipfile.ZipFile(WHEEL) as wheel:
            metadata = wheel.read(
                [name for name in wheel.namelist() if name.endswith("/METADATA")][0]
            ).decode()
        self.assertIn("Requires-Python: >=3.6\n", metadata)
        self.assertIn("Author: rtshell_lite developers\n", metadata)
        for minor in range(6, 14):
            self.assertIn("Classifier: Programming Language :: Python :: 3.%d\n" % minor, metadata)
        self.assertIn("Description-Content-Type: text/markdown", metadata)
        self.assertIn("\n# rtshell_lite\n\nShell commands for robots", metadata)
        self.assertNotIn("](docs/", metadata, "such a link leads nowhere on an index page")
        requirements = re.findall("^Requires-Dist: (.*)$", metadata, re.MULTILINE)
        self.assertEqual(len(requirements), 2)
        for requirement in requirements:
            self.assertIn("extra == ", requirement)
        self.assertTrue([name for name in self.members() if name.endswith("LICENSE")])


class Installed(Robot):
    """pip install --no-index in a clean environment."""

    def test_install_and_run_without_omniorb(self):
        environment = os.path.join(self.directory, "venv")
        subprocess.check_call([sys.executable, "-m", "venv", environment])
        programs = os.path.join(environment, "bin")
        pip = [os.path.join(programs, "python"), "-m", "pip", "--disable-pip-version-check", "-q"]
        self.assertEqual(run(pip + ["install", "--no-index", WHEEL])[0], 0)
        self.check_without_omniorb(lambda name: [os.path.join(programs, name)], names("bin"))
        self.assertEqual(
            manual_pages(os.path.join(environment, "share", "man")), manual_pages(os.path.join(ROOT, "man"))
        )
        out = run([os.path.join(programs, "python"), "-m", "rtshell_lite"])[1]
        self.assertEqual(sorted(re.findall(r"^  (rt\w+)  +[A-Z]", out, re.MULTILINE)), names("bin"))
        self.assertNotIn("\nothers\n", out, "each command has a subject in shell/installation.py")
        script = os.path.join(programs, "rtshell_lite")
        self.assertEqual(run([script]), (0, out, ""))
        self.assertEqual(run([script, "rtpwd"]), (0, "/\n", ""))
        self.assertEqual(run([script, "rtpwd", "--nosuch"])[0], 2)
        self.assertIn("--unpack DIR", run([script, "--help"])[1])
        unpacked = os.path.join(self.directory, "unpacked")
        self.assertEqual(
            run([os.path.join(programs, "python"), "-m", "rtshell_lite", "--unpack", unpacked])[0], 0
        )
        self.assertEqual(
            sorted(os.listdir(os.path.join(unpacked, "bin"))), sorted(names("bin") + ["rtshell_lite"])
        )
        self.assertEqual(
            manual_pages(os.path.join(unpacked, "share", "man")), manual_pages(os.path.join(ROOT, "man"))
        )


class WheelFile(Robot):
    """Straight from the wheel file, nothing installed."""

    def test_commands_run_without_omniorb(self):
        self.check_without_omniorb(lambda name: [self.python, "-m", "rtshell_lite", name])

    def test_list_of_commands(self):
        for options, words in ([], []), ([], ["--help"]), (["-OO"], ["--help"]):
            line = [self.python] + options + ["-m", "rtshell_lite"] + words
            status, out, err = run(line, environment={"PYTHONPATH": WHEEL})
            self.assertEqual((status, err), (0, ""))
            self.assertEqual(sorted(re.findall(r"^  (rt\w+)  +[A-Z]", out, re.MULTILINE)), names("bin"))

    def test_authors_of_components_can_test_with_it(self):
        example = os.path.join(ROOT, "docs", "example_test.py")
        status, _, err = run([self.python, example], environment={"PYTHONPATH": WHEEL})
        self.assertEqual(status, 0, err)

    def test_own_usage_errors(self):
        for words, part in [
            (["rtpw"], "did you mean rtpwd?"),
            (["--nonsense"], "--nonsense"),
            (["--unpack"], "--unpack"),
            (["--unpack", ""], "the name is empty"),
            (["--unpack", "/a:b"], "PATH"),
        ]:
            self.check_line("rtshell_lite", 2, self.from_wheel(*words), part)

    def test_arguments_and_environment_reach_the_command(self):
        result = run(
            [self.python, "-m", "rtshell_lite", "rtpwd", "--json"],
            environment={"PYTHONPATH": WHEEL, "RTCSH_CWD": "/robot"},
        )
        self.assertEqual(result, (0, '{"path": "/robot"}\n', ""))
