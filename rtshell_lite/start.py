"""What a command does before it imports anything else; so this module imports next to nothing."""

import _signal  # which `signal` is made of: that one takes longer to import than all that comes before it
import gc
import sys

# new objects after which Python looks for cycles: with its default, 700, that took 4 % of a command's time
GARBAGE = 20000


def quietly(name):
    """In the file that is run as a command (`name` is "__main__"): Ctrl-C ends it with no traceback of half
    an import.

    cli.main() takes Ctrl-C over. And argparse does not look for translations, which takes a sixth of the time
    to start.
    """
    if name != "__main__":
        return
    gc.set_threshold(GARBAGE)
    if _signal.getsignal(_signal.SIGINT) == _signal.default_int_handler:
        _signal.signal(_signal.SIGINT, _signal.SIG_DFL)
    _import_argparse()


def _import_argparse():
    before = sys.modules.get("gettext")
    stand_in = type(sys)("gettext")
    stand_in.gettext, stand_in.ngettext = str, lambda one, more, number: one if number == 1 else more
    sys.modules["gettext"] = stand_in
    import argparse  # noqa: F401

    del sys.modules["gettext"]
    if before:
        sys.modules["gettext"] = before
