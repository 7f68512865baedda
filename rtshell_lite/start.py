"""What a command does before it imports anything else; so this module imports hardly anything."""

import _signal  # which `signal` is made of: that one takes longer to import than all that comes before it
import sys

# new objects after which Python looks for cycles: with its default, 700, that took 4 % of a command's time
GARBAGE = 20000
# what argparse imports, on one Python or another, and needs for messages and --help only
SELDOM = ("collections", "copy", "shutil", "textwrap", "warnings")


def quietly(name):
    """In the file that is run as a command (`name` is "__main__"): Ctrl-C ends it with no traceback of half
    an import.

    cli.main() takes Ctrl-C over. And argparse looks for no translations and imports hardly anything, which
    takes a third of the time to start.
    """
    if name != "__main__":
        return
    if _signal.getsignal(_signal.SIGINT) == _signal.default_int_handler:
        _signal.signal(_signal.SIGINT, _signal.SIG_DFL)
    import gc

    gc.set_threshold(GARBAGE)
    _import_argparse()


def find_installed():
    """Have what is installed beside Python found: commands that --unpack lays out start without (python -S),
    which takes a ninth off the time of rtls.
    """
    if sys.flags.no_site and "site" not in sys.modules:
        import site

        site.main()


class _Later:
    """In place of a module: it is imported as soon as something in it is used."""

    __spec__ = None  # which `import` looks at

    def __init__(self, name):
        self._name = name

    def __getattr__(self, attribute):
        if sys.modules.get(self._name) is self:  # argparse is not imported yet
            del sys.modules[self._name]
        return getattr(__import__(self._name), attribute)


class _Expressions(_Later):
    """In place of the module `re`, in which each parser makes the same expression anew."""

    ASCII = 256  # of the expressions for --help

    def compile(self, pattern, flags=0):
        if pattern.startswith("^-"):
            return _NegativeNumber()
        return _Expression(pattern, flags)


class _Expression:
    """A compiled expression, as soon as it is used."""

    def __init__(self, pattern, flags):
        self._given = pattern, flags

    def __getattr__(self, attribute):
        import re

        return getattr(re.compile(*self._given), attribute)


class _NegativeNumber:
    """In place of the expression for negative numbers, with which argparse looks at each option."""

    def match(self, word):
        return word[:1] == "-" and word[-1:].isdecimal() and word[1:].replace(".", "", 1).isdecimal()


def _import_argparse():
    gettext = type(sys)("gettext")
    gettext.gettext = str
    gettext.ngettext = lambda one, more, number: one if number == 1 else more
    stand_ins = {name: _Later(name) for name in SELDOM}  # type: dict
    stand_ins.update(gettext=gettext, re=_Expressions("re"))
    before = {name: sys.modules[name] for name in stand_ins if name in sys.modules}
    sys.modules.update(stand_ins)
    sys.modules.update((name, module) for name, module in before.items() if name != "gettext")
    try:
        import argparse  # noqa: F401
    finally:
        for name, stand_in in stand_ins.items():
            if sys.modules.get(name) is stand_in:
                del sys.modules[name]
        sys.modules.update(before)
