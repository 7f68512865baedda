"""The commands and files of this rtshell_lite, which is in a checkout, installed, or in a wheel file."""

import importlib.util
import os
import sys

import rtshell_lite
from rtshell_lite import bytecode, errors, text

# in the order in which somebody meets them; a command that is in none is listed last
SUBJECTS = {
    "looking around": "rtls rtcat rtcwd rtpwd rtfind rtdoc rtstodot rttop",
    "states, configuration, execution contexts": "rtact rtdeact rtreset rtexit rtconf rtec rtfsm",
    "connections and names": "rtcon rtdis rtdel",
    "managers and composites": "rtmgr rtcomp",
    "values, logs and services": "rtprint rtinject rtlog rtplot rtcall",
    "whole systems": "rtcryo rtcheck rtresurrect rtteardown rtstart rtstop rtkeep",
    "what is wrong, what happens": "rtdoctor rttrace rtwatch rtvlog",
    "shells and files": "rtsh rtmount",
}
PACKAGE = os.path.dirname(os.path.abspath(rtshell_lite.__file__))
COMMANDS = os.path.join(PACKAGE, "commands")  # but for a checkout
_MEMBERS = "rtshell_lite/commands/"  # of a wheel file
_PAGES = "data/share/man/"
# the files in bin/ of an installation: how all begin, what runs a command, and what is in rtshell_lite
BEGINNING = """\
import _signal

if _signal.getsignal(_signal.SIGINT) == _signal.default_int_handler:  # as start.quietly does, but at once
    _signal.signal(_signal.SIGINT, _signal.SIG_DFL)

"""
STARTER = """\
from rtshell_lite import start

start.quietly(__name__)

from rtshell_lite import cli

cli.installed("{name}")
"""
OVERALL_STARTER = """\
from rtshell_lite import start

start.quietly(__name__)

from rtshell_lite import __main__, anywhere

anywhere.main(__main__.__doc__ or "")
"""


def wheel():
    """The wheel file that we run from, or None."""
    return getattr(rtshell_lite.__spec__.loader, "archive", None)


def command(name):
    """The path of a command, which may lead into the wheel file; None if no command has that name.
    Raises Error.
    """
    if not wheel():
        return commands().get(name)
    path = os.path.join(COMMANDS, name + ".py")
    try:
        read(path)
    except OSError:
        return None
    return path


def commands():
    """The commands, {name: path}; a path may lead into the wheel file. Raises Error if there are none."""
    archive = wheel()
    if archive:
        files = [name[len(_MEMBERS) :] for name in _members(archive) if name.startswith(_MEMBERS)]
    else:
        files = os.listdir(COMMANDS)
    paths = {name[: -len(".py")]: os.path.join(COMMANDS, name) for name in files if _is_command(name, ".py")}
    paths = paths or _of_checkout()
    if not paths:
        raise errors.Error(f"the commands are missing: they are not in {PACKAGE}")
    return paths


def _of_checkout():
    directory = os.path.join(os.path.dirname(PACKAGE), "bin")
    try:
        names = os.listdir(directory)
    except OSError:
        return {}
    return {name: os.path.join(directory, name) for name in names if _is_command(name, "")}


def _is_command(name, end):
    return name.startswith("rt") and name.endswith(end) and name[: len(name) - len(end)].isalnum()


def manual_pages():
    """The manual pages, {path below share/man: path}; a path may lead into the wheel file.
    {} if there are none.
    """
    import glob

    archive = wheel()
    if archive:
        pages = [name for name in _members(archive) if _PAGES in name]
        return {name.partition(_PAGES)[2]: os.path.join(archive, *name.split("/")) for name in pages}
    for top in _manuals():
        paths = glob.glob(os.path.join(glob.escape(top), "**", "rt*.[17]"), recursive=True)
        by_name = {os.path.relpath(path, top).replace(os.sep, "/"): path for path in paths}
        if "man7/rtshell_lite.7" in by_name:
            return by_name
    return {}


def _manuals():
    """Directories where the manual pages may be."""
    import glob

    beside = os.path.dirname(PACKAGE)
    yield os.path.join(beside, "man")  # a checkout
    yield os.path.join(os.path.dirname(beside), "share", "man")  # --unpack
    for record in glob.glob(os.path.join(glob.escape(beside), "rtshell_lite-*.dist-info", "RECORD")):
        with open(record, encoding="utf-8") as lines:
            pages = [line.partition(",")[0] for line in lines if "share/man/man7/rtshell_lite.7," in line]
        for page in pages:  # wherever pip has put them
            yield os.path.normpath(os.path.join(beside, page, "..", ".."))


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


def by_subject():
    """The commands by subject: {subject: {name: the first line of its help}}."""
    paths = commands()
    subjects = {subject: names.split() for subject, names in SUBJECTS.items()}
    placed = {name for names in subjects.values() for name in names}
    subjects["others"] = sorted(set(paths) - placed)
    firsts = {
        subject: {name: summary(read(paths[name])) for name in names if name in paths}
        for subject, names in subjects.items()
    }
    return {subject: lines for subject, lines in firsts.items() if lines}


def summaries():
    """A line for each command, its name and the first line of its help, below lines with their subjects."""
    import textwrap

    subjects = by_subject()
    size = max(len(name) for firsts in subjects.values() for name in firsts) + 4
    lines = []
    for subject, firsts in subjects.items():
        lines.append(subject)
        for name, first in firsts.items():
            lines += textwrap.wrap(
                first, text.width() - 2, initial_indent=f"  {name}".ljust(size), subsequent_indent=" " * size
            )
    return lines


def _members(archive):
    """The names of the files in the wheel file.
    (zipfile takes long to import; Debian's python3-minimal has none.)
    """
    name = f"rtshell_lite-{rtshell_lite.__version__}.dist-info"
    record = read(os.path.join(archive, name, "RECORD")).decode()
    return [line.partition(",")[0] for line in record.splitlines()]
