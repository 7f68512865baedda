"""What setup.cfg cannot say: every file of bin/ is a command, every file below man/ a manual page."""
import glob
import gzip
import os
import sys
import tarfile
import time
import zlib

import setuptools
from distutils.command.build_scripts import build_scripts  # that of setuptools
from setuptools.command.build_py import build_py
from setuptools.command.sdist import sdist

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:  # before setuptools 70.1; pyproject.toml asks for `wheel`, to build only
    from wheel.bdist_wheel import bdist_wheel

os.chdir(os.path.dirname(os.path.abspath(__file__)))
os.umask(0o022)
zlib.Z_DEFAULT_COMPRESSION = zlib.Z_BEST_COMPRESSION  # what zipfile uses where no level is given
sys.path.insert(0, os.getcwd())
from rtshell_lite.shell import installation  # noqa: E402: the path first
COMMANDS = sorted(path for path in glob.glob("bin/rt*") if os.path.basename(path).isalnum())
PAGES = {}
for path in sorted(glob.glob("man/**/rt*.[17]", recursive=True)):
    PAGES.setdefault("share/" + os.path.dirname(path), []).append(path)


def overview():
    """The beginning of README.md, for the page of a package index: without the table of commands and what
    follows, as links into the repository, and pictures in it, would lead nowhere there.
    """
    with open("README.md", encoding="utf-8") as file:
        beginning = file.read().partition("\n## Commands")[0]
    return "".join(line for line in beginning.splitlines(True) if not line.startswith("!["))


class Modules(build_py):
    """Makes commands modules, whose bytecode Python keeps."""

    def run(self):
        super().run()
        if getattr(self, "editable_mode", False):  # the files of bin/ are run themselves, see Starters
            return
        for path in COMMANDS:
            target = os.path.join(self.build_lib, "rtshell_lite", "commands", os.path.basename(path) + ".py")
            self.copy_file(path, target, preserve_mode=False)


class Starters(build_scripts):
    """Runs those modules; in a checkout that is installed as it is, the files themselves. rtshell_lite runs
    each of them.
    """

    def run(self):
        if "develop" in self.distribution.command_obj:
            return super().run()
        is_checkout = "editable_wheel" in self.distribution.command_obj
        self.mkpath(self.build_dir)
        self.write("rtshell_lite", installation.OVERALL_STARTER)
        for path in COMMANDS:
            name = os.path.basename(path)
            starter = installation.STARTER.format(name=name)
            if is_checkout:
                starter = "import runpy\n\nrunpy.run_path(%r, run_name='__main__')\n" % os.path.abspath(path)
            self.write(name, starter)

    def write(self, name, starter):
        made = os.path.join(self.build_dir, name)
        with open(made, "w", newline="\n") as file:
            file.write("#!%s\n%s%s" % (self.executable, installation.BEGINNING, starter))
        os.chmod(made, 0o755)


class SameEverywhere(bdist_wheel):
    """Makes the same octets of the same files, whatever modes they have in the checkout; the times are
    SOURCE_DATE_EPOCH.
    """

    def egg2dist(self, *args):
        super().egg2dist(*args)
        for where, _, names in os.walk(self.bdist_dir):
            for name in names:
                is_program = os.path.basename(where) == "scripts"
                os.chmod(os.path.join(where, name), 0o755 if is_program else 0o644)


class SameSources(sdist):
    """The same for the archive of the sources."""

    def make_archive(self, base_name, format, root_dir=None, base_dir=None, owner=None, group=None):
        if format != "gztar":
            return super().make_archive(base_name, format, root_dir, base_dir, owner, group)
        moment = int(os.environ.get("SOURCE_DATE_EPOCH", time.time()))

        def without_traces(member):
            member.uid = member.gid = 0
            member.uname = member.gname = ""
            member.mtime = moment
            member.mode = 0o755 if member.isdir() or member.mode & 0o100 else 0o644
            return member

        name = base_name + ".tar.gz"
        with open(name, "wb") as file, gzip.GzipFile("", "wb", 9, file, moment) as packed:
            with tarfile.open(fileobj=packed, mode="w", format=tarfile.PAX_FORMAT) as archive:
                paths = [base_dir]
                for where, directories, names in os.walk(base_dir):
                    paths += [os.path.join(where, name) for name in directories + names]
                for path in sorted(paths):
                    archive.add(path, recursive=False, filter=without_traces)
        return name


setuptools.setup(long_description=overview(), long_description_content_type="text/markdown",
                 scripts=COMMANDS, data_files=sorted(PAGES.items()),
                 cmdclass={"build_py": Modules, "build_scripts": Starters, "bdist_wheel": SameEverywhere,
                           "sdist": SameSources})
