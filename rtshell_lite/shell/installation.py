"""The commands and files of this rtshell_lite, which is in a checkout, installed, or in a wheel file."""

import importlib.util
import os
import sys

import rtshell_lite
from rtshell_lite import bytecode, errors, text

PACKAGE = os.path.dirname(os.path.abspath(rtshell_lite.__file__))
_NAME = "rtshell_lite-" + rtshell_lite.__version__
# in a wheel file
_SCRIPTS = os.path.join(_NAME + ".data", "scripts")
_PAGES = os.path.join(_NAME + ".data", "data", "share", "man")


def wheel():
    """The wheel file that we run from, or None."""
    return getattr(rtshell_lite.__spec__.loader, "archive", None)


def command(name):
    """The path of a command, which may lead into the wheel file; None if there is none. Raises Error."""
    archive = wheel()
    if not archive:
        return commands().get(name)
    path = os.path.join(archive, _SCRIPTS, name)
    try:
        read(path)
    except OSError:
        return None
    return path


def commands():
    """The commands, {name: path}; a path may lead into the wheel file. Raises Error if there are none."""
    archive = wheel()
    if archive:
        paths = _in_wheel(archive)
    else:
        paths = next(filter(None, map(_in_directory, _places())), {})
    if not paths:
        raise errors.Error(f"the commands are missing: they are not beside {PACKAGE}")
    return paths


def manual_pages():
    """The manual pages, {path below share/man: path}; a path may lead into the wheel file.
    {} if there are none.
    """
    import glob

    archive = wheel()
    if archive:
        found = [name.partition(".data/data/share/man/")[2] for name in _members(archive)]
        return {below: os.path.join(archive, _PAGES, *below.split("/")) for below in found if below}
    above = os.path.dirname(os.path.dirname(next(iter(commands().values()))))
    for top in os.path.join(above, "man"), os.path.join(above, "share", "man"):  # a checkout, an installation
        paths = glob.glob(os.path.join(glob.escape(top), "**", "rt*.[17]"), recursive=True)
        found = {os.path.relpath(path, top).replace(os.sep, "/"): path for path in paths}
        if "man7/rtshell_lite.7" in found:
            return found
    return {}


def read(path):
    """The bytes of a file of ours, which may be in the wheel file."""
    return rtshell_lite.__spec__.loader.get_data(path)


def load(path, name):
    """The command's file as a module; called `__main__`, it runs."""
    spec = importlib.util.spec_from_loader(name, bytecode.Loader(name, path))
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


def summary(source):
    """The first line of a command's help."""
    import ast

    return (ast.get_docstring(ast.parse(source)) or "").partition("\n")[0]


def summaries():
    """A line for each command: its name and the first line of its help."""
    import textwrap

    known = commands()
    size = max(map(len, known)) + 4
    return [
        line
        for name, path in sorted(known.items())
        for line in textwrap.wrap(
            summary(read(path)),
            text.width() - 2,
            initial_indent=f"  {name}".ljust(size),
            subsequent_indent=" " * size,
        )
    ]


def _members(archive):
    """The names of the files in the wheel file.
    (zipfile takes long to import; Debian's python3-minimal has none.)
    """
    record = read(os.path.join(archive, _NAME + ".dist-info", "RECORD")).decode()
    return [line.partition(",")[0] for line in record.splitlines()]


def _in_wheel(archive):
    paths = [os.path.join(archive, *name.split("/")) for name in _members(archive)]
    return {os.path.basename(path): path for path in paths if os.path.dirname(path).endswith(_SCRIPTS)}


def _places():
    """Directories where an installation may have put the commands, the most likely first."""
    import glob
    import re
    import sysconfig

    beside = os.path.dirname(PACKAGE)
    yield os.path.join(beside, "bin")  # a checkout; also pip install --target
    yield os.path.join(os.path.dirname(beside), "bin")  # --unpack
    for record in glob.glob(os.path.join(glob.escape(beside), "rtshell_lite-*.dist-info", "RECORD")):
        with open(record, encoding="utf-8") as lines:
            for line in lines:
                if re.match(r"(\.\./|/).*/rt\w+,", line):
                    yield os.path.normpath(os.path.join(beside, os.path.dirname(line.partition(",")[0])))
    yield sysconfig.get_path("scripts")
    yield os.path.join(sys.prefix, "bin")  # where packages of an operating system put them


def _in_directory(directory):
    import re

    try:
        names = sorted(name for name in os.listdir(directory) if re.match(r"rt\w+$", name))
    except OSError:
        return {}
    paths = {name: os.path.join(directory, name) for name in names}
    return {name: path for name, path in paths.items() if os.path.isfile(path) and _is_ours(path)}


def _is_ours(path):
    try:
        with open(path, "rb") as file:
            return file.read(2) == b"#!" and b"\nfrom rtshell_lite import " in file.read()
    except OSError:
        return False
