"""The wheel as installed on a robot: if this fails, the commands may work only here.

tests/run gives the built wheel in RTSHELL_WHEEL and omniORBpy's in RTSHELL_OMNIORB_WHEEL; the Python that runs this
needs neither of them installed.
"""
import ast
import glob
import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile
import zlib

import invocations

PART = 3  # a short run takes one in PART of its tests
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
WHEEL, OMNIORB_WHEEL = (os.environ.get(name) and os.path.abspath(os.environ[name])
                        for name in ("RTSHELL_WHEEL", "RTSHELL_OMNIORB_WHEEL"))
LARGEST = 900 * 1000  # octets
TOOLS = {"rtshell_lite/idl_stubs/generate.py", "rtshell_lite/idl_stubs/tabulate.py", "rtshell_lite/shell/documentation.py",
         "rtshell_lite/shell/manpages.py"}  # they write generated files
REPORTING = {"rtsh", "rtdoctor"}  # that nobody listens is what their commands say, or a finding


def names(directory, suffix=""):
    found = [name for name in os.listdir(os.path.join(ROOT, directory)) if name.endswith(suffix)]
    return sorted(name[:len(name) - len(suffix)] for name in found if not name.startswith("."))


def read(*path):
    with open(os.path.join(ROOT, *path), encoding="utf-8") as file:
        return file.read()


def chosen(commands):
    """All; in a short run (see tests/support/short.py) one in four."""
    return commands[::4] if "RTSHELL_SHORT" in os.environ else commands


def manual_pages(top):
    """Paths of all files below a share/man."""
    return sorted(os.path.relpath(path, top) for path in glob.glob(os.path.join(glob.escape(top), "**", "*.*"), recursive=True))


def run(words, **keywords):
    """Status, stdout and stderr of a program, in an environment where neither package can be found by accident."""
    environment = {"PATH": "/usr/bin:/bin", "HOME": "/nonexistent", "LC_ALL": "C"}
    environment.update(keywords.pop("environment", {}))
    process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               env=environment, universal_newlines=True, cwd=keywords.pop("cwd", "/"), **keywords)
    out, err = process.communicate(timeout=120)
    return process.returncode, out, err


class Checkout(unittest.TestCase):
    """bin/ and tests/commands/ have the same commands; each command has the required parts."""

    def test_every_command_has_a_transcript(self):
        """rtls.t, and rtls-names.t for a topic of its own."""
        self.assertEqual(sorted({name.partition("-")[0] for name in names("tests/commands", ".t")}), names("bin"),
                         "a command NAME has a transcript tests/commands/NAME.t")

    def test_every_command_says_how_it_is_run(self):
        """By the tests that run all commands."""
        stated = set(invocations.stated("invocation")) | set(invocations.stated("local"))
        self.assertEqual(sorted(set(names("bin")) - stated), [], "to be stated in tests/commands/NAME.t by a line such as "
                         "'invocation: A' or 'local: it contacts nobody': see tests/support/invocations.py")

    def test_commands_can_be_read_and_run(self):
        for name in names("bin"):
            with self.subTest(name):
                text = read("bin", name)
                self.assertTrue(text.startswith("#!/usr/bin/env python3\n"))
                self.assertTrue(os.access(os.path.join(ROOT, "bin", name), os.X_OK))
                tree = ast.parse(text)
                summary, _, details = ast.get_docstring(tree).partition("\n\n")
                self.assertRegex(summary, r"^[A-Z].*\.$")
                self.assertIn("examples:\n  " + name, details)
                self.assertTrue(text.endswith('\n\nif __name__ == "__main__":\n    cli.main(arguments, run, __doc__)\n'))
                self.assertEqual([f.name for f in tree.body if isinstance(f, ast.FunctionDef)][:1], ["arguments"])


@unittest.skipUnless(WHEEL, "no wheel was given in RTSHELL_WHEEL")
class Wheel(unittest.TestCase):
    """What is in the wheel, and what is not."""

    def members(self):
        with zipfile.ZipFile(WHEEL) as wheel:
            return wheel.namelist()

    def test_name_and_size(self):
        self.assertRegex(os.path.basename(WHEEL), r"^rtshell_lite-\d+\.\d+\.\d+-py3-none-any\.whl$")
        self.assertLess(os.path.getsize(WHEEL), LARGEST)

    def test_only_the_package_its_commands_and_its_papers(self):
        for name in self.members():
            self.assertRegex(name, r"^rtshell_lite/|^rtshell_lite-[^/]+\.(dist-info|data/scripts|data/data/share/man)/")
        self.assertFalse([name for name in self.members() if re.search(r"(^|/)(mock_components|tests?)(/|$)|\.pyc$", name)])

    def test_all_commands_and_modules(self):
        scripts = sorted(name.rpartition("/")[2] for name in self.members() if ".data/scripts/" in name)
        self.assertEqual(scripts, names("bin"))
        modules = [name for name in self.members() if name.startswith("rtshell_lite/commands/rt")]
        self.assertEqual(sorted(modules), ["rtshell_lite/commands/%s.py" % name for name in names("bin")])
        for where, directories, files in os.walk(os.path.join(ROOT, "rtshell_lite")):
            directories[:] = [name for name in directories if name != "__pycache__"]
            for name in files:
                if name.endswith((".py", ".js", ".css", ".html")):
                    path = os.path.relpath(os.path.join(where, name), ROOT).replace(os.sep, "/")
                    self.assertEqual(path in self.members(), path not in TOOLS, path)

    def test_all_manual_pages(self):
        pages = [name.partition("/share/man/")[2] for name in self.members() if ".data/data/" in name]
        self.assertEqual(sorted(pages), manual_pages(os.path.join(ROOT, "man")))

    def test_metadata(self):
        with zipfile.ZipFile(WHEEL) as wheel:
            metadata = wheel.read([name for name in wheel.namelist() if name.endswith("/METADATA")][0]).decode()
        self.assertIn("Requires-Python: >=3.6\n", metadata)
        requirements = re.findall("^Requires-Dist: (.*)$", metadata, re.MULTILINE)
        self.assertEqual(len(requirements), 2)
        for requirement in requirements:
            self.assertIn("extra == ", requirement)
        self.assertTrue([name for name in self.members() if name.endswith("LICENSE")])


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
        return run([self.python, "-m", "rtshell_lite"] + list(words), environment={"PYTHONPATH": WHEEL}, **keywords)

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
        places = {"SERVER": "/localhost:1/a.cxt", "A": "/localhost:1/a.rtc", "B": "/localhost:1/b.rtc", "MGR": "/localhost:1/a.mgr",
                  "FILE": os.path.join(ROOT, "tests", "data", "valid", "as-rtcryo-writes.xml"),
                  "OUT": os.path.join(self.directory, "out")}
        return invocations.words(invocations.stated("invocation").get(name, [""])[0], places)

    def check_line(self, prog, status, result, part):
        """One line on stderr, nothing on stdout."""
        self.assertEqual(result[:2], (status, ""), result[2])
        self.assertRegex(result[2], r"\A%s: [^\n]*\n\Z" % prog)
        self.assertIn(part, result[2])


class Installed(Robot):
    """pip install --no-index in a clean environment."""

    def test_install_and_run_without_omniorb(self):
        environment = os.path.join(self.directory, "venv")
        subprocess.check_call([sys.executable, "-m", "venv", environment])
        programs = os.path.join(environment, "bin")
        pip = [os.path.join(programs, "python"), "-m", "pip", "--disable-pip-version-check", "-q"]
        self.assertEqual(run(pip + ["install", "--no-index", WHEEL])[0], 0)
        self.check_without_omniorb(lambda name: [os.path.join(programs, name)], chosen(names("bin")))
        self.assertEqual(manual_pages(os.path.join(environment, "share", "man")), manual_pages(os.path.join(ROOT, "man")))
        status, out, _ = run([os.path.join(programs, "python"), "-m", "rtshell_lite"])
        self.assertEqual(re.findall(r"^  (rt\w+)  +[A-Z]", out, re.MULTILINE), names("bin"))
        unpacked = os.path.join(self.directory, "unpacked")
        self.assertEqual(run([os.path.join(programs, "python"), "-m", "rtshell_lite", "--unpack", unpacked])[0], 0)
        self.assertEqual(sorted(os.listdir(os.path.join(unpacked, "bin"))), names("bin"))
        self.assertEqual(manual_pages(os.path.join(unpacked, "share", "man")), manual_pages(os.path.join(ROOT, "man")))

    def test_commands_are_found_wherever_pip_puts_them(self):
        for option in "--target", "--prefix", "--user":
            with self.subTest(option):
                place = os.path.join(self.directory, option)
                if sys.prefix != sys.base_prefix and option == "--user":
                    continue  # pip refuses it in a virtual environment
                environment = {"PYTHONUSERBASE": place}
                words = [option] + ([place] if option != "--user" else [])
                pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "install", "-q", "--no-index"]
                status, _, err = run(pip + ["--ignore-installed", "--no-warn-script-location"] + words + [WHEEL],
                                     environment=environment)
                self.assertEqual(status, 0, err)
                package = [where for where, _, _ in os.walk(place) if where.endswith("/rtshell_lite")][0]
                result = run([self.python, "-m", "rtshell_lite", "rtpwd"],
                             environment={"PYTHONPATH": os.path.dirname(package)})
                self.assertEqual(result, (0, "/\n", ""))


class WheelFile(Robot):
    """Straight from the wheel file, nothing installed."""

    def test_commands_run_without_omniorb(self):
        self.check_without_omniorb(lambda name: [self.python, "-m", "rtshell_lite", name])

    def test_list_of_commands(self):
        for words in [], ["--help"]:
            status, out, err = self.from_wheel(*words)
            self.assertEqual((status, err), (0, ""))
            self.assertEqual(re.findall(r"^  (rt\w+)  +[A-Z]", out, re.MULTILINE), names("bin"))

    def test_own_usage_errors(self):
        for words, part in [(["rtpw"], "did you mean rtpwd?"), (["--nonsense"], "--nonsense"), (["--unpack"], "--unpack"),
                            (["--unpack", ""], "PATH"), (["--unpack", "/a:b"], "PATH")]:
            self.check_line("rtshell_lite", 2, self.from_wheel(*words), part)

    def test_arguments_and_environment_reach_the_command(self):
        result = run([self.python, "-m", "rtshell_lite", "rtpwd", "--json"],
                     environment={"PYTHONPATH": WHEEL, "RTCSH_CWD": "/robot"})
        self.assertEqual(result, (0, '{"path": "/robot"}\n', ""))


class KeptBytecode(Robot):
    """What is run from the wheel file is compiled once, where that is safe."""

    def setUp(self):
        super().setUp()
        self.cache = os.path.join(self.directory, "cache")
        os.mkdir(self.cache)
        self.kept = os.path.join(self.cache, "rtshell_lite")

    def rtpwd(self, *words, **environment):
        known = dict({"PYTHONPATH": WHEEL, "XDG_CACHE_HOME": self.cache}, **environment)
        return run([self.python, "-m", "rtshell_lite", "rtpwd"] + list(words), environment=known)

    def check_rtpwd(self, **environment):
        self.assertEqual(self.rtpwd(**environment), (0, "/\n", ""))

    def file(self, part):
        """The kept file that has this in its name."""
        name, = [name for name in os.listdir(self.kept) if part in name]
        return os.path.join(self.kept, name)

    def forge(self):
        """Change the kept code of rtpwd so that it can be told from that in the wheel, as only its owner can."""
        path = self.file("commands.rtpwd")
        with open(path, "rb") as file:
            data = file.read()
        start = next(at for at in range(len(data)) if zlib.crc32(data[at + 4:]).to_bytes(4, "little") == data[at:at + 4])
        code = data[start + 4:].replace(b"working directory", b"WORKING DIRECTORY")
        with open(path, "wb") as file:
            file.write(data[:start] + zlib.crc32(code).to_bytes(4, "little") + code)
        return path

    def check_used(self, is_used, **environment):
        status, out, err = self.rtpwd("--help", **environment)
        self.assertEqual((status, err, "WORKING DIRECTORY" in out), (0, "", is_used))

    def test_it_is_private_used_and_written_once(self):
        self.check_rtpwd()
        self.assertEqual(os.stat(self.kept).st_mode & 0o777, 0o700)
        paths = [os.path.join(self.kept, name) for name in os.listdir(self.kept)]
        self.assertEqual({os.stat(path).st_mode & 0o777 for path in paths}, {0o600})
        self.assertFalse([path for path in paths if path.endswith(".tmp")])
        self.forge()
        before = files(self.kept)
        self.check_used(True)
        self.assertEqual({name: found for name, found in files(self.kept).items() if name in before}, before)

    def test_in_the_home_directory(self):
        os.rename(self.cache, os.path.join(self.directory, ".cache"))
        self.check_rtpwd(XDG_CACHE_HOME="", HOME=self.directory)
        self.assertIn("rtshell_lite", os.listdir(os.path.join(self.directory, ".cache")))

    def test_of_others_or_for_others_it_is_not_used(self):
        self.check_rtpwd()
        self.forge()
        self.check_used(True)
        os.chmod(self.kept, 0o770)
        self.check_used(False)
        os.chmod(self.kept, 0o700)
        moved = os.path.join(self.directory, "moved")
        os.rename(self.kept, moved)
        os.symlink(moved, self.kept)
        self.check_used(False)
        os.unlink(self.kept)
        os.rename(moved, self.kept)
        self.check_used(True)
        if os.geteuid() == 0:
            os.chown(self.kept, 1, 1)
            self.check_used(False)

    def test_a_file_of_others_or_for_others_is_written_again(self):
        self.check_rtpwd()
        path = self.forge()
        os.chmod(path, 0o622)
        self.check_used(False)
        self.assertEqual(os.stat(path).st_mode & 0o777, 0o600)
        outside = os.path.join(self.directory, "outside")
        os.rename(self.forge(), outside)
        os.symlink(outside, path)
        self.check_used(False)
        self.assertFalse(os.path.islink(path))
        os.unlink(path)
        os.mkfifo(path, 0o600)
        self.check_used(False)

    def test_a_damaged_file_is_written_again(self):
        self.check_rtpwd()
        path = self.file("rtshell_lite.path")
        with open(path, "rb") as file:
            whole = file.read()
        for damaged in whole[:-1], whole[:10], b"", whole[:-9] + b"\xff" + whole[-8:], whole.replace(b"rtshell", b"rtsHell"):
            with open(path, "wb") as file:
                file.write(damaged)
            self.check_rtpwd()
            with open(path, "rb") as file:
                self.assertEqual(file.read(), whole)

    def test_another_wheel_at_the_same_place(self):
        wheel = os.path.join(self.directory, os.path.basename(WHEEL))
        shutil.copy(WHEEL, wheel)
        self.check_rtpwd(PYTHONPATH=wheel)
        self.forge()
        self.check_used(True, PYTHONPATH=wheel)
        os.utime(wheel, (1, 1))
        self.check_used(False, PYTHONPATH=wheel)

    def test_where_nothing_can_be_kept(self):
        for place in "/nonexistent", "/dev/null", "cache":
            self.check_rtpwd(XDG_CACHE_HOME=place)
        self.check_rtpwd(PYTHONDONTWRITEBYTECODE="1")
        self.assertEqual(files(self.kept), {})

    def test_a_full_disk(self):
        def small_files_only():
            resource.setrlimit(resource.RLIMIT_FSIZE, (600, 600))

        result = run([self.python, "-m", "rtshell_lite", "rtpwd"], preexec_fn=small_files_only,
                     environment={"PYTHONPATH": WHEEL, "XDG_CACHE_HOME": self.cache})
        self.assertEqual(result, (0, "/\n", ""))
        self.assertTrue(all(len(content) <= 600 for content in files(self.kept).values()))


class Unpacked(Robot):
    """--unpack, for robots without pip."""

    def unpack(self, *wheels):
        place = os.path.join(self.directory, "a place")
        result = self.from_wheel("--unpack", place, *wheels)
        self.assertEqual(result, (0, "export PATH='%s/bin':$PATH\n" % place, ""))
        return place

    def test_commands_run_without_omniorb(self):
        place = self.unpack()
        self.assertEqual(sorted(os.listdir(os.path.join(place, "bin"))), names("bin"))
        self.check_without_omniorb(lambda name: [os.path.join(place, "bin", name)])

    def test_they_start_without_what_is_installed_beside_python_and_find_it_when_it_is_asked_for(self):
        command = os.path.join(self.unpack(), "bin", "rtls")
        with open(command, encoding="utf-8") as file:
            self.assertEqual(file.readline(), "#!%s -S\n" % self.python)
        beside = subprocess.check_output([self.python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"],
                                         universal_newlines=True).strip()
        fake = os.path.join(beside, "omniORB.py")
        with open(fake, "w") as file:
            file.write("raise OSError('this is omniORB')\n")
        self.addCleanup(os.unlink, fake)
        self.check_line("rtls", 1, run([command, "/localhost:1/"], environment={"RTSHELL_ORB": "omniorb"}), "this is omniORB")
        self.check_line("rtls", 4, run([command, "/localhost:1/"]), "connection refused")

    def test_can_be_moved_linked_and_unpacked_again(self):
        moved = os.path.join(self.directory, "moved")
        os.rename(self.unpack(), moved)
        link = os.path.join(self.directory, "rtpwd")
        os.symlink(os.path.join(moved, "bin", "rtpwd"), link)
        self.assertEqual(run([link]), (0, "/\n", ""))
        before = files(moved, r"\.pyc$")
        again = run([self.python, "-m", "rtshell_lite", "--unpack", moved],
                    environment={"PYTHONPATH": os.path.join(moved, "lib")})
        self.assertEqual(again, (0, "export PATH=%s/bin:$PATH\n" % moved, ""))
        self.assertEqual(files(moved, r"\.pyc$"), before)

    def test_checkout_and_wheel_lay_out_the_same_but_for_tools(self):
        place = self.unpack()
        other = os.path.join(self.directory, "other")
        self.assertEqual(run([self.python, "-m", "rtshell_lite", "--unpack", other], environment={"PYTHONPATH": ROOT})[0], 0)
        tools = "|".join(map(re.escape, TOOLS))
        self.assertEqual(files(place, r"dist-info|\.pyc$"), files(other, r"\.pyc$|\.idl$|" + tools))

    @unittest.skipUnless(OMNIORB_WHEEL, "no omniORBpy wheel was given: there is none for this Python, or no index")
    def test_omniorbpy_with_its_shared_libraries(self):
        place = self.unpack(OMNIORB_WHEEL)
        program = ("import os, sys; sys.path.insert(0, sys.argv[1]); from omniORB import CORBA; CORBA.ORB_init(); "
                   "print('up', flush=True); os._exit(0)")  # as our commands end: the ORB's own end crashes now and then
        self.assertEqual(run([self.python, "-c", program, os.path.join(place, "lib")]), (0, "up\n", ""))
        if "rtls" in names("bin"):
            result = run([os.path.join(place, "bin", "rtls"), "--timeout", "2", "/localhost:1/"])
            self.check_line("rtls", 4, result, "connection refused")

    def test_wheels_that_are_refused(self):
        for number, member in enumerate(["../evil", "/evil", "a/../../evil", "a\\..\\evil", "x-1.data/purelib/../../evil",
                                         "C:evil", "./evil", "rtshell_lite/cli.py"]):
            wheel = self.wheel("hostile%d-1-py3-none-any.whl" % number, member)
            self.check_refused(wheel, "comes twice" if "cli" in member else "refused: it holds a file named")
        self.check_refused(os.path.join(self.directory, "none-1-py3-none-any.whl"), "No such file")
        self.check_refused(self.wheel("other-1-cp32-cp32m-any.whl", "x"), "made for cp32")
        self.check_refused(self.wheel("other-1-py3-none-linux_pdp11.whl", "x"), "made for linux_pdp11")
        self.check_refused(self.wheel("other.zip", "x"), "not the name of a wheel")
        torn = self.wheel("torn-1-py3-none-any.whl", "x")
        with open(torn, "r+b") as file:
            file.truncate(30)
        self.check_refused(torn, "not a wheel")

    def test_a_wheel_that_grows_without_measure(self):
        self.check_refused(self.wheel("bomb-1-py3-none-any.whl", "x", bytes(65 << 20)), "refused: it unpacks to more than 64 MB")

    def test_links_in_the_place(self):
        """They may lead anywhere."""
        place, outside = os.path.join(self.directory, "place"), os.path.join(self.directory, "outside")
        os.mkdir(place)
        os.mkdir(outside)
        os.symlink(outside, os.path.join(place, "lib"))
        self.check_line("rtshell_lite", 1, self.from_wheel("--unpack", place), "refused: it is a link")
        self.assertEqual((os.listdir(place), os.listdir(outside)), (["lib"], []))

    def wheel(self, name, member, content="evil"):
        path = os.path.join(self.directory, name)
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as wheel:
            wheel.writestr(member, content)
        return path

    def check_refused(self, wheel, part):
        """One line of output, and no files."""
        place = os.path.join(self.directory, "place")
        before = files(self.top, "bare")
        self.check_line("rtshell_lite", 1, self.from_wheel("--unpack", place, wheel), part)
        self.assertEqual(files(self.top, "bare"), before)

    def test_full_disk_leaves_the_old_commands_whole(self):
        place = self.unpack()
        before = files(place)

        def small_files_only():
            resource.setrlimit(resource.RLIMIT_FSIZE, (600, 600))

        result = self.from_wheel("--unpack", place, preexec_fn=small_files_only)
        self.check_line("rtshell_lite", 1, result, place)
        self.assertEqual(files(place), before)
        self.assertEqual(run([os.path.join(place, "bin", "rtpwd")]), (0, "/\n", ""))

    def test_places_that_cannot_be_written(self):
        for place in "/proc/nowhere", "/dev/null":
            self.check_line("rtshell_lite", 1, self.from_wheel("--unpack", place), place)


def files(directory, leave_out=None):
    """Contents of all files below a directory whose path does not match."""
    found = {}
    for where, _, members in os.walk(directory):
        for path in [os.path.join(where, name) for name in members]:
            if not leave_out or not re.search(leave_out, path):
                with open(path, "rb") as file:
                    found[os.path.relpath(path, directory)] = file.read()
    return found
