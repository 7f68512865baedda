"""What a command does before it imports anything else; so this module imports next to nothing."""
import _signal  # which `signal` is made of: that one takes longer to import than all that comes before it


def quietly(name):
    """In the file that is run as a command (`name` is "__main__"): Ctrl-C ends it with no traceback of half an import.

    cli.main() takes Ctrl-C over.
    """
    if name == "__main__" and _signal.getsignal(_signal.SIGINT) == _signal.default_int_handler:
        _signal.signal(_signal.SIGINT, _signal.SIG_DFL)
