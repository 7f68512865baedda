"""What a command does before it imports anything else; so this module imports hardly anything."""

import _signal  # which `signal` is made of: that one takes longer to import than all that comes before it
import sys

# new objects after which Python looks for cycles: with its default, 700, that took 4 % of a command's time
GARBAGE = 20000
# what argparse imports, on one Python or another, and needs for messages and --help only
SELDOM = ("collections", "copy", "re", "shutil", "textwrap", "warnings")


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
    """Stands for a module, or for what a function makes, until something of it is used."""

    __spec__ = None  # which `import` looks at

    def __init__(self, make):
        self._make = make

    def __getattr__(self, attribute):
        return getattr(self._make(), attribute)


class _NegativeNumber:
    """Stands for the expression with which argparse looks at the name of each option."""

    def match(self, word):
        return word[:1] == "-" and word[-1:].isdecimal() and word[1:].replace(".", "", 1).isdecimal()


def _import_argparse():
    """Import argparse, and what it needs for messages and --help alone (SELDOM) only when it does. It looks
    for no translations.

    That takes 29.7 of 82.8 million instructions off the start of a command (Python 3.11).
    """

    def imported(name):
        if sys.modules.get(name) is stand_ins[name]:  # argparse is not imported yet
            del sys.modules[name]
        return __import__(name)

    def compiled(pattern, flags=0):
        if pattern.startswith("^-"):
            return _NegativeNumber()
        return _Later(lambda: __import__("re").compile(pattern, flags))

    gettext = type(sys)("gettext")
    gettext.gettext = str
    gettext.ngettext = lambda single, more, number: single if number == 1 else more
    stand_ins = {name: _Later(lambda name=name: imported(name)) for name in SELDOM}  # type: dict
    stand_ins["re"].ASCII = 256  # of an expression for --help
    stand_ins["re"].compile = compiled
    stand_ins["gettext"] = gettext
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
