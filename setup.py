"""What setup.cfg cannot say: every file of bin/ is a command, every file below man/ a manual page, and what a checkout only needs."""
import glob
import os

import setuptools
from setuptools.command.build_py import build_py

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:
    from wheel.bdist_wheel import bdist_wheel

os.chdir(os.path.dirname(os.path.abspath(__file__)))
os.umask(0o022)
TOOLS = ["idl_stubs/generate.py", "idl_stubs/tabulate.py", "shell/documentation.py", "shell/manpages.py"]
PAGES = {}
for path in sorted(glob.glob("man/**/rt*.[17]", recursive=True)):
    PAGES.setdefault("share/" + os.path.dirname(path), []).append(path)


class WithoutTools(build_py):
    """Leaves out of the wheel what writes generated files."""

    def build_module(self, module, module_file, package):
        if module_file not in [os.path.join("rtshell_lite", tool) for tool in TOOLS]:
            return super().build_module(module, module_file, package)


class SameEverywhere(bdist_wheel):
    """Makes the same octets of the same files, whatever modes they have in the checkout; the times are SOURCE_DATE_EPOCH."""

    def egg2dist(self, *args):
        super().egg2dist(*args)
        for where, _, names in os.walk(self.bdist_dir):
            for name in names:
                is_program = os.path.basename(where) == "scripts"
                os.chmod(os.path.join(where, name), 0o755 if is_program else 0o644)


setuptools.setup(scripts=sorted(path for path in glob.glob("bin/rt*") if os.path.basename(path).isalnum()),
                 data_files=sorted(PAGES.items()), cmdclass={"build_py": WithoutTools, "bdist_wheel": SameEverywhere})
