"""The Pythons of this machine, and private environments with the built wheel in them.

All is kept below .venv-tests/ and made anew when what it was made from has changed, or when it is broken.
"""
import collections
import configparser
import fcntl
import glob
import hashlib
import os
import re
import shutil
import subprocess
import sys
import tempfile
import threading

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
STORE = os.path.join(ROOT, ".venv-tests")
SOURCES = ["setup.py", "setup.cfg", "pyproject.toml", "README.md", "LICENSE", "CHANGELOG.md"]
SOURCES += ["bin", "man", "rtshell_lite"]


class Failed(Exception):
    """Making an environment failed."""


class Missing(Failed):
    """There is no such Python on this machine."""


def lock():
    """Wait for another run in this tree to end: both would install to the same environment."""
    os.makedirs(STORE, exist_ok=True)
    file = open(os.path.join(STORE, "lock"), "w")
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        print("waiting for another tests/run in this tree", flush=True)
        fcntl.flock(file, fcntl.LOCK_EX)
    return file  # held as long as it is open


def run(words, **keywords):
    process = subprocess.run(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, **keywords)
    if process.returncode:
        raise Failed("%s\n%s" % (" ".join(words), process.stdout.decode("utf-8", "replace").strip()))
    return process.stdout.decode().strip()


def pip(interpreter, command, *words):
    """Run a command of a Python's pip. Raises Failed."""
    run([interpreter, "-m", "pip", command, "--disable-pip-version-check", "-q"] + list(words))


# ---- Pythons ----

class Python:
    """An interpreter: its path, and its version as text such as "3.11"."""

    def __init__(self, path):
        self.path = path
        self.full = run([path, "-c", "import sys; print('%d.%d.%d' % sys.version_info[:3])"])
        self.version = self.full.rpartition(".")[0]


def find_python(asked):
    """The interpreter for a version such as 3.11, or for a path. Raises Missing."""
    for path in _candidates(asked):
        try:
            python = Python(path)
        except (Failed, OSError):  # a pyenv shim of a version that is not switched on, say
            continue
        if asked in (python.version, python.full) or asked == path:
            return python
    raise Missing("Python %s is not here" % asked)


def _candidates(asked):
    if not re.match(r"3\.\d+(\.\d+)?$", asked):
        return [asked]
    versions = os.path.join(os.environ.get("PYENV_ROOT") or os.path.expanduser("~/.pyenv"), "versions")
    found = sorted(glob.glob(os.path.join(glob.escape(versions), "*", "bin", "python3")))
    installed = [path for path in found if (path.split(os.sep)[-3] + ".").startswith(asked + ".")]
    names = ["python" + ".".join(asked.split(".")[:2]), "python3"]
    return [sys.executable] + installed + list(filter(None, map(shutil.which, names)))


# ---- the wheel ----

def build_wheel(python):
    """The wheel built from the checkout as it is now; a copy is built, so that nothing old or foreign gets
    in.
    """
    store = os.path.join(STORE, "dist", _digest(SOURCES))
    for wheel in glob.glob(os.path.join(store, "*.whl")):
        return wheel
    builder = _builder(python)
    with tempfile.TemporaryDirectory(prefix="rt-build-") as directory:
        source = os.path.join(directory, "source")
        out = os.path.join(directory, "out")
        os.mkdir(source)
        for name in SOURCES:
            copy(os.path.join(ROOT, name), os.path.join(source, name))
        pip(builder, "wheel", "--no-build-isolation", "--no-deps", "--no-index", "-w", out, source)
        shutil.rmtree(os.path.dirname(store), ignore_errors=True)
        shutil.copytree(out, store)
    return glob.glob(os.path.join(store, "*.whl"))[0]


def copy(source, target):
    if os.path.isdir(source):
        shutil.copytree(source, target, ignore=shutil.ignore_patterns("__pycache__", "*.pyc", ".*"))
    else:
        shutil.copy2(source, target)


def _digest(names):
    digest = hashlib.sha256()
    for name in names:
        paths = glob.glob(os.path.join(ROOT, name, "**"), recursive=True) + [os.path.join(ROOT, name)]
        for path in sorted(path for path in paths if os.path.isfile(path) and "__pycache__" not in path):
            digest.update(("%s %o\n" % (path, os.stat(path).st_mode)).encode())
            with open(path, "rb") as file:
                digest.update(file.read())
    return digest.hexdigest()[:16]


def _builder(python):
    return _environment(python, "build-" + python.full, "setuptools, wheel", ["setuptools", "wheel"])


# ---- environments ----

def prepare(python, wheel):
    """An environment with the wheel and, where there is one, omniORBpy; returns its interpreter."""
    with _preparing[python.full]:
        return _prepared(python, wheel)


_preparing = collections.defaultdict(threading.Lock)


def _prepared(python, wheel):
    fetched = fetch_omniorb(python)
    words = ["--no-index", wheel]
    if fetched:  # what a user types, so that the extra is tried as well
        words = ["--no-index", "--find-links", os.path.dirname(fetched), wheel + "[omniorb]"]
    imports = "omniORB" if fetched else "rtshell_lite"
    interpreter = _environment(python, python.full, imports, words, str(fetched))
    # The version of the wheel does not change: its content decides whether it is installed.
    words = ["--no-index", "--no-deps", "--force-reinstall", wheel]
    _made_from(wheel, os.path.join(STORE, python.full, "wheel"), lambda: pip(interpreter, "install", *words))
    # The processes of the tests, thousands of them, write no bytecode beside the modules: half
    # their start-up.
    ours = [os.path.join(ROOT, name) for name in ("mock_components", "tests")]
    run([interpreter, "-m", "compileall", "-q"] + ours)
    return interpreter


def prepare_compat(python):
    """An environment with the real libraries for profiles and logs, from the package index; returns its
    interpreter. Raises Failed.
    """
    zstd = "backports.zstd; python_version < '3.14'"
    words = ["PyYAML", "rtsprofile-aist", "mcap", "mcap-ros2-support", zstd]
    return _environment(python, "compat-" + python.full, "yaml, rtsprofile, mcap, mcap_ros2", words)


def prepare_npm():
    """The directory of the packages that read logs in JavaScript; None where npm cannot install them."""
    directory = os.path.join(STORE, "compat-npm")
    modules = os.path.join(directory, "node_modules")
    words = ["@mcap/core", "@foxglove/rosmsg", "@foxglove/rosmsg2-serialization", "@foxglove/omgidl-parser",
             "@foxglove/omgidl-serialization"]
    if not all(os.path.isdir(os.path.join(modules, word)) for word in words):
        os.makedirs(directory, exist_ok=True)
        try:
            run(["npm", "install", "--silent", "--no-audit", "--no-fund", "--prefix", directory] + words,
                timeout=300)
        except (OSError, subprocess.SubprocessError, Failed):
            return None
    return modules


def fetch_omniorb(python):
    """The file of omniORBpy for this Python, from the package index; None where none was ever made. Raises
    Failed.
    """
    if python.version == "3.6":
        return None
    directory = os.path.join(STORE, "omniorb-" + python.full)
    requirements = _extra()

    def download():
        shutil.rmtree(directory, ignore_errors=True)
        pip(python.path, "download", "--no-deps", "-d", directory, *requirements)

    _made_from("\n".join(requirements), os.path.join(directory, "made-from"), download)
    return glob.glob(os.path.join(glob.escape(directory), "*.whl"))[0]


def _extra():
    """What setup.cfg names as omniORBpy, a line for each Python."""
    config = configparser.ConfigParser()
    config.read(os.path.join(ROOT, "setup.cfg"), encoding="utf-8")
    return config["options.extras_require"]["omniorb"].strip().splitlines()


def _environment(python, name, imports, words, requirement=""):
    """Make a virtual environment unless it is there, was made from the same, and works; returns its
    interpreter. `words` are for `pip install`; `requirement` says more of what it is made from.
    """
    directory = os.path.join(STORE, name)
    interpreter = os.path.join(directory, "bin", "python")
    marker = os.path.join(directory, "made-from")
    works = [interpreter, "-c", "import " + imports]

    def make():
        print("making an environment for Python %s" % python.full, flush=True)
        shutil.rmtree(directory, ignore_errors=True)
        run([python.path, "-m", "venv", directory])
        pip(interpreter, "install", *words)
        run(works)

    if os.path.exists(marker) and subprocess.call(works, stderr=subprocess.DEVNULL):
        os.remove(marker)
    _made_from("%s\n%s\n" % (python.path, requirement or " ".join(words)), marker, make)
    return interpreter


def _made_from(source, marker, make):
    """Make something unless it was made from that source, as a file beside it says."""
    if os.path.exists(marker):
        with open(marker) as file:
            if file.read() == source:
                return
    make()
    with open(marker, "w") as file:
        file.write(source)
