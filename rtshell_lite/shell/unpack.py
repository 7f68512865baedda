"""Install rtshell_lite and other wheels under a directory without pip.

DIR/bin holds the commands, DIR/lib what they import, DIR/share/man the manual pages, where `man` looks for
them. Shared libraries in a wheel are found as in site-packages: beside the module that needs them ($ORIGIN).
"""

import compileall
import os
import re
import sys
import sysconfig
import zipfile
import zlib

from rtshell_lite import compiled, errors
from rtshell_lite.files import create, umask
from rtshell_lite.net import loop, real
from rtshell_lite.shell import installation

LARGEST = 64 << 20  # octets of what is in a wheel

# Relative to the command, so that the whole directory can be moved or copied to the robot.
FIND_LIBRARY = """import os, sys  # these four lines were added by --unpack
sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(os.path.realpath(__file__))), "lib"))
from rtshell_lite import compiled
compiled.find()
"""


def unpack(directory, wheels):
    """Write everything under a directory; returns where the commands are.
    Raises Error; old commands then still work.
    """
    files = Files(os.path.abspath(directory))
    own = installation.wheel()
    if own:
        files.add_wheel(own)
    else:
        files.add_package(installation.PACKAGE)
    beginning = _python() + installation.BEGINNING + FIND_LIBRARY
    files.add("bin/rtshell_lite", (beginning + installation.OVERALL_STARTER).encode("utf-8"), True)
    start = beginning + installation.STARTER
    for name, path in sorted(installation.commands().items()):
        files.add("bin/" + name, start.format(name=name).encode("utf-8"), True)
        module = f"lib/rtshell_lite/commands/{name}.py"
        if module not in files.contents:  # of a checkout
            files.add(module, installation.read(path))
    for name, path in installation.manual_pages().items():
        files.add("share/man/" + name, installation.read(path))
    for path in wheels:
        _check_tags(path)
        files.add_wheel(path)
    files.write()
    lib = os.path.join(files.directory, "lib")
    # else 20 ms a command in a read-only directory
    compileall.compile_dir(lib, quiet=2)
    together = Files(files.directory)
    together.add("lib/" + compiled.NAME, compiled.join(_modules(lib, files.contents)))
    together.write()
    return os.path.join(files.directory, "bin")


def _modules(lib, names):
    """For compiled.join: each of our modules among what was laid out."""
    for name in sorted(names):
        if not (name.startswith("lib/rtshell_lite/") and name.endswith(".py")):
            continue
        file_name = name[len("lib/") :]
        module = file_name[: -len(".py")].replace("/", ".")
        if module.endswith(".__init__"):
            module = module.rpartition(".")[0]
        path = os.path.join(lib, file_name)
        with open(path, "rb") as file:
            code = compile(file.read(), path, "exec", dont_inherit=True)
            yield module, file_name, os.fstat(file.fileno()), code


class Files:
    """Files to write: all are read and checked before the first one is written."""

    def __init__(self, directory):
        self.directory = directory
        self.contents = {}  # path below the directory → (bytes, whether it is a program)

    def add(self, name, content, program=False):
        if name in self.contents:
            raise errors.Error(f"{name}: comes twice in what is to be laid out")
        self.contents[name] = content, program

    def add_package(self, package):
        above = os.path.dirname(package)
        for directory, subdirectories, names in os.walk(package):
            subdirectories[:] = [name for name in subdirectories if name != "__pycache__"]
            for name in [name for name in names if not name.endswith((".pyc", ".tmp"))]:
                with open(os.path.join(directory, name), "rb") as file:
                    parts = os.path.relpath(file.name, above).split(os.sep)
                    self.add("/".join(["lib"] + parts), file.read())

    def add_wheel(self, path):
        """Add what can be imported from a wheel; scripts, headers and data are left out."""
        try:
            with zipfile.ZipFile(path) as wheel:
                # no more of a member is read than it claims
                if sum(member.file_size for member in wheel.infolist()) > LARGEST:
                    raise errors.Error(f"{path}: refused: it unpacks to more than {LARGEST >> 20} MB")
                for member in wheel.infolist():
                    target = _target(path, member.filename)
                    if target:
                        is_program = bool(member.external_attr >> 16 & 0o111)
                        self.add(target, wheel.read(member), is_program)
        except OSError as e:
            raise errors.Error(f"{path}: {e.strerror or e}")
        except (zipfile.BadZipFile, zlib.error, EOFError, NotImplementedError, RuntimeError, ValueError) as e:
            raise errors.Error(f"{path}: not a wheel, or a damaged one ({e})")

    def write(self):
        """Write beside the targets, flush to the disk, then rename;
        the commands last, so that they find what they import.
        """
        for directory in {os.path.dirname(name) for name in self.contents}:
            self._check_links(directory)
            self._check_compiled(directory)
        order = sorted(self.contents, key=lambda name: (name.startswith("bin/"), name))
        temporaries = []
        try:
            for name in order:
                temporaries.append(self._write_temporary(name))
            os.sync()
            for name, temporary in zip(order, temporaries):
                os.rename(temporary, os.path.join(self.directory, *name.split("/")))
        except OSError as e:
            raise errors.Error(f"{self.directory}: {e.strerror}")
        finally:
            for temporary in filter(os.path.lexists, temporaries):
                os.unlink(temporary)

    def _check_links(self, directory):
        """Raise Error if a directory below ours is a link: it may lead anywhere."""
        path = self.directory
        for part in directory.split("/"):
            path = os.path.join(path, part)
            if os.path.islink(path):
                raise errors.Error(f"{path}: refused: it is a link")

    def _check_compiled(self, directory):
        """Raise Error if what Python has compiled, or will compile, is anything but a file in a directory."""
        cache = os.path.join(self.directory, directory, "__pycache__")
        if os.path.islink(cache):
            raise errors.Error(f"{cache}: refused: it is a link")
        if not os.path.isdir(cache):
            return
        for entry in os.scandir(cache):
            if not entry.is_file(follow_symlinks=False):
                raise errors.Error(f"{entry.path}: refused: it is not a file")

    def _write_temporary(self, name):
        content, program = self.contents[name]
        path = os.path.join(self.directory, *name.split("/"))
        directory, last = os.path.split(path)
        os.makedirs(directory, exist_ok=True)
        temporary = os.path.join(directory, f".{last[:50]}.{os.urandom(8).hex()}.tmp")
        file = create(temporary, 0o600)
        try:
            with file:
                file.write(content)
                mode = 0o777 if program else 0o666
                os.fchmod(file.fileno(), mode & ~umask())
        except OSError:
            os.unlink(temporary)
            raise
        return temporary


def _target(wheel, name):
    """Where a wheel's member goes, or None. Raises Error for a name that leads out of the directory."""
    if name.endswith("/"):
        return None
    if re.search(r"[\\:\0]|^/|(^|/)(\.{0,2})(/|$)", name):
        raise errors.Error(f"{wheel}: refused: it holds a file named {name!r}")
    data = re.match(r"[^/]+\.data/([^/]+)/(.*)", name)
    if data is None:
        return "lib/" + name
    return "lib/" + data.group(2) if data.group(1) in ("purelib", "platlib") else None


def _check_tags(path):
    """Refuse a wheel for another Python or machine. Raises Error."""
    match = re.match(r"[^-]+-[^-]+(?:-\d[^-]*)?-([^-]+)-([^-]+)-([^-]+)\.whl$", os.path.basename(path))
    if match is None:
        raise errors.Error(f"{path}: not the name of a wheel")
    pythons, abis, platforms = (tags.split(".") for tags in match.groups())
    minor = sys.version_info[1]
    fitting = {"py3", "py3%d" % minor, "cp3%d" % minor}
    if "abi3" in abis:
        fitting.update("cp3%d" % older for older in range(2, minor))
    if not fitting.intersection(pythons):
        raise errors.Error("%s: made for %s, but this Python is cp3%d" % (path, ".".join(pythons), minor))
    machine = "_" + sysconfig.get_platform().rpartition("-")[2]
    if "any" not in platforms and not any(platform.endswith(machine) for platform in platforms):
        raise errors.Error(f"{path}: made for {'.'.join(platforms)}, but this machine is {machine[1:]}")


def _python():
    """The first line of commands."""
    python = sys.executable
    if not python:
        return "#!/usr/bin/env python3\n"
    if re.search(r"\s", python) or len(os.fsencode(python)) > 120:
        raise errors.Error(f"{python}: cannot be named in the first line of a script (blanks, or too long)")
    option = " -S" if _finds_modules_alone(python) else ""
    return f"#!{python}{option}\n"


def _finds_modules_alone(python):
    """Whether Python finds its own modules with -S, by which commands take a ninth less time; in an old
    virtualenv it does not.
    """
    words = [python, "-S", "-c", "import argparse, struct"]
    try:
        return loop.world().start_process(words, stderr=real.NOTHING).wait() == 0
    except OSError:
        return False
