"""Typing commands into rtsh: line editing, a history, and completion, where Python has readline."""

import contextlib
import os

from rtshell_lite import errors, files
from rtshell_lite.corba import session
from rtshell_lite.net import loop
from rtshell_lite.path import parse
from rtshell_lite.shell import completion

HISTORY = "~/.rtsh_history"
LENGTH = 1000  # lines


def text():
    """The prompt: the working directory."""
    try:
        return f"rtsh {parse('.')!s}> "
    except errors.BadPath:  # RTCSH_CWD came from elsewhere
        return "rtsh ?> "


class Editor:
    """readline, if Python has it; a context that reads the history, and writes it in the end."""

    def __init__(self, interpreter):
        self.interpreter = interpreter
        self._found = []
        self._session = session.Session()  # of all completions
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
        is_libedit = "libedit" in (self.readline.__doc__ or "")
        self.readline.parse_and_bind("bind ^I rl_complete" if is_libedit else "tab: complete")
        with contextlib.suppress(OSError):  # it does not exist yet, or it cannot be read
            self.readline.read_history_file(os.path.expanduser(HISTORY))
        return self

    def __exit__(self, *_):
        if self.readline is None:
            return
        last = self.readline.get_current_history_length()
        numbers = range(max(1, last - LENGTH + 1), last + 1)
        lines = [self.readline.get_history_item(number) or "" for number in numbers]
        with contextlib.suppress(OSError):  # the home directory is read-only, say
            files.write(os.path.expanduser(HISTORY), "".join(line + "\n" for line in lines))

    def _complete(self, typed, number):
        """Called by readline with 0, 1, …: the completions of `typed`, then None."""
        if number == 0:
            line = self.readline.get_line_buffer()[: self.readline.get_endidx()]
            begins = line.rpartition(";")[2].strip() == typed  # the first word of a command
            if begins:
                self._found = self._names(typed)
            else:
                answers = completion.answers("bash", line, typed, self._meant)
                self._found = loop.run(answers, session=self._session)
        return self._found[number] if number < len(self._found) else None

    def _meant(self, words):
        try:
            return [self.interpreter.name(words[0])] + words[1:]
        except errors.BadLine:
            return words

    def _names(self, typed):
        """Names of commands without rt, or with it if `typed` has it."""
        full = sorted(self.interpreter.files)
        short = sorted(["cd", "exit", "help"] + [name[len("rt") :] for name in full])
        names = full if typed.startswith("rt") else short
        return [name + " " for name in names if name.startswith(typed)]
