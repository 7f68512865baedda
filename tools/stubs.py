"""Write the tables of IDL: `python3 -m tools.stubs [FILE]`, in a checkout.

FILE is by default rtshell_lite/idl_stubs/tables.py, which says what the .idl files beside it say. To add an
interface, edit or drop in an .idl file, run this command and commit everything; tests/unit/test_tables.py
fails until then.

It needs omniORBpy, and omniidl with its back end for Python (pip install jeteve-omniorb).
"""

import functools
import glob
import os
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
STUBS = os.path.join(ROOT, "rtshell_lite", "idl_stubs")
IDL = os.path.join(STUBS, "idl")


class NoOmniidl(Exception):
    """omniidl with its back end for Python is missing: pip install jeteve-omniorb"""

    def __str__(self):
        return self.__doc__


@functools.lru_cache(maxsize=None)
def omniidl():
    """The path of an omniidl that writes Python: beside this interpreter, whose environment need not be
    active, or on PATH.

    Debian's omniidl has no back end for Python.
    """
    path = os.environ.get("PATH", os.defpath)
    for directory in [os.path.dirname(sys.executable)] + path.split(os.pathsep):
        found = shutil.which("omniidl", path=directory)
        if found and _writes_python(found):
            return found
    raise NoOmniidl()


def _writes_python(command):
    return not subprocess.call(
        [command, "-bpython", "-u"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )


def tables():
    """The text of tables.py."""
    found = glob.glob(os.path.join(glob.escape(IDL), "*", "*.idl"))
    files = sorted(os.path.relpath(path, IDL) for path in found)
    with tempfile.TemporaryDirectory() as directory:
        subprocess.check_call([omniidl(), "-I.", "-bpython", "-C" + directory] + files, cwd=IDL)
        return subprocess.check_output(
            [sys.executable, "-m", "tools.tabulate", directory], cwd=ROOT, universal_newlines=True
        )


def main(arguments):
    if len(arguments) > 1 or arguments[:1] in (["-h"], ["--help"]):
        print(__doc__)
        sys.exit(len(arguments) > 1 and 2)
    try:
        text = tables()
    except (NoOmniidl, subprocess.CalledProcessError) as error:
        sys.exit(f"stubs: {error}")
    path = arguments[0] if arguments else os.path.join(STUBS, "tables.py")
    with open(path, "w", newline="\n") as stream:
        stream.write(text)


if __name__ == "__main__":
    main(sys.argv[1:])
