"""Typing commands into rtsh: line editing, a history, and completion, where Python has readline."""
import os

from rtshell_lite import errors, files
from rtshell_lite.path import parse
from rtshell_lite.shell import completion

HISTORY = "~/.rtsh_history"
LENGTH = 1000  # lines that it keeps


def text():
    """What stands before the cursor: the working directory."""
    try:
        return f"rtsh {parse('.')!s}> "
    except errors.BadPath:  # RTCSH_CWD came from elsewhere
        return "rtsh ?> "


class Editor:
    """readline, if there is one: as a context, it reads the history and writes it down afterwards."""

    def __init__(self, interpreter):
        self.interpreter = interpreter
        self._found = []
        try:
            import readline
        except ImportError:
            readline = None
        self.readline = readline

    def __enter__(self):
        if self.readline is None:
            return self
        self.readline.set_completer(self._complete)
        self.readline.set_completer_delims(" \t;")
        self.readline.parse_and_bind("bind ^I rl_complete" if "libedit" in (self.readline.__doc__ or "") else "tab: complete")
        try:
            self.readline.read_history_file(os.path.expanduser(HISTORY))
        except OSError:
            pass  # the first time, or a home that cannot be read
        return self

    def __exit__(self, *_):
        if self.readline is None:
            return
        last = self.readline.get_current_history_length()
        lines = [self.readline.get_history_item(i) or "" for i in range(max(1, last - LENGTH + 1), last + 1)]
        try:
            files.write(os.path.expanduser(HISTORY), "".join(line + "\n" for line in lines))
        except OSError:
            pass  # a robot whose home is read-only

    def _complete(self, typed, number):
        """readline's way to ask: the completions of `typed` one by one, then None."""
        if number == 0:
            line = self.readline.get_line_buffer()[:self.readline.get_endidx()]
            begins = line.rpartition(";")[2].strip() == typed  # the first word of a command
            self._found = self._names(typed) if begins else completion.answers("bash", line, typed, self._meant)
        return self._found[number] if number < len(self._found) else None

    def _meant(self, words):
        try:
            return [self.interpreter.name(words[0])] + words[1:]
        except errors.BadLine:
            return words

    def _names(self, typed):
        """Commands as they are called in rtsh, in full only if they are begun so."""
        full = sorted(self.interpreter.files)
        names = full if typed.startswith("rt") else sorted(["cd", "exit"] + [name[len("rt"):] for name in full])
        return [name + " " for name in names if name.startswith(typed)]
