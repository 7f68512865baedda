"""How rtsh reads commands and runs them in its own process, with one ORB and open connections."""

import contextlib
import io
import os
import re
import sys

from rtshell_lite import errors, notes
from rtshell_lite.shell import installation
from rtshell_lite.text import near, printable, quoted

# A word of sh, an operator or a comment, after blanks.
_TOKEN = re.compile(
    r"""\s*(?: (?P<word> (?: [^\s;&|<>()'"\\\#] | \\. | '[^']*' | "(?:[^"\\]|\\.)*" )
                                        (?: [^\s;&|<>()'"\\] | \\. | '[^']*' | "(?:[^"\\]|\\.)*" )* )
                        | (?P<end> ; | \Z | \#.* ) | (?P<operator> &&? | \|\|? | <<? | >>? | [()] ) )""",
    re.VERBOSE | re.DOTALL,
)


LONGEST = 4 << 20  # characters of a line
OWN = (  # in the help: what no other shell has
    "  cd  changes the working directory, as rtcwd does",
    "  wait FILE  waits until all is as an RtsProfile says, as rtkeep --once does",
    "  exit [STATUS]  ends rtsh",
)


class Left(Exception):
    """The end of rtsh, by `exit` for example; its argument is the exit status."""


def split(line):
    """The commands of a line, each a list of words, quoted as in sh.
    Raises BadLine for what only a real shell can do.
    """
    if "\0" in line:  # commands do not expect it, for shells cannot pass it
        raise errors.BadLine("a NUL character: " + printable(line.strip()))
    commands = []
    words = []
    position = 0
    while position < len(line):
        token = _TOKEN.match(line, position)
        if not token:
            rest = printable(line[position:].strip())
            raise errors.BadLine(f"a quote or a backslash without its other half: {rest}")
        if token.group("operator"):
            why = "only a real shell has that; quote it if it belongs to a word"
            raise errors.BadLine(f"{token.group('operator')}: {why}")
        if token.group("word"):
            words.append(_unquoted(token.group("word")))
        elif words:
            commands.append(words)
            words = []
        position = token.end() if token.end() > position else len(line)
    return commands + [words] if words else commands


def _unquoted(word):
    """A word without its quotes and backslashes. (shlex.split needs half a minute for a word of 1 MB.)"""
    pieces = re.findall(r"""'([^']*)'|"((?:[^"\\]|\\.)*)"|\\(.)|([^'"\\]+)""", word, re.DOTALL)
    return "".join(
        single + re.sub(r'\\([$`"\\])', r"\1", double) + escaped + plain
        for single, double, escaped, plain in pieces
    )


def lines(read):
    """(number of its first line, text) for each line of read(), which returns '' at the end;
    a final backslash joins two.
    """
    number = 0
    first = 1
    text = ""
    while True:
        line = read()
        number += 1
        if not line and not text:
            return
        part = line.lstrip("\ufeff").rstrip("\r\n")
        backslashes = len(part) - len(part.rstrip("\\"))
        if line and backslashes % 2 and len(text) <= LONGEST:
            text += part[:-1]
            continue
        yield first, text + part
        first = number + 1
        text = ""


class Interpreter:
    """Runs commands; `status` is the exit status of the last one, `stop`: a failure ends rtsh.

    command(arguments, run, doc, words)  runs one and returns its exit status, see cli.command
    show(text)  prints help
    """

    def __init__(self, command, stop=False, show=None):
        self._command = command
        self.stop = stop
        self.status = 0
        self.show = show
        self.files = {name: path for name, path in installation.commands().items() if name != "rtsh"}
        self._modules = {}

    def name(self, word):
        """The command that a word means, with or without its `rt`. Raises BadLine."""
        for name in ({"cd": "rtcwd", "wait": "rtkeep"}.get(word, word), "rt" + word):
            if name in self.files:
                return name
        shown = printable(word) or "''"
        raise errors.BadLine(f"{shown}: no such command{near(word, self._names())}")

    def _names(self):
        """The names of commands, with and without their `rt`."""
        return sorted(set(self.files) | {name[2:] for name in self.files})

    def run_line(self, line):
        """Run the commands of a line. Raises BadLine, Left."""
        for words in split(line):
            notes.detail(" ".join(map(quoted, words)))
            if words[0] == "exit":
                raise Left(self._asked_status(words[1:]))
            if words[0] == "help":
                self.status = self._help(words[1:])
                continue
            self.status = self.run(words)
            if self.status and self.stop or self.status == 141:
                raise Left(self.status)

    def run(self, words):
        """Run a command, a list of words, and return its exit status."""
        try:
            name = self.name(words[0])
        except errors.BadLine as e:
            return notes.fail(e)
        if name == "rtkeep" and words[0] == "wait":
            return self._run(name, ["--once"] + words[1:])
        if name == "rtcwd" and not re.match("-h$|--help$|--version$|--shell", " ".join(words[1:2])):
            return self._change_directory(name, words[1:])
        return self._run(name, words[1:])

    def _asked_status(self, words):
        """The exit status that `exit WORDS` asks for; 2 if WORDS are no exit status. rtsh ends anyway."""
        if not words:
            return self.status
        if len(words) > 1 or not re.match(r"\d{1,3}$", words[0]) or int(words[0]) > 255:
            return notes.fail(errors.BadLine(f"exit: not a status: {printable(' '.join(words))}"))
        return int(words[0])

    def _help(self, words):
        if words:
            return self.run(words + ["--help"])
        lines = ["commands, with or without rt; help COMMAND says more:", *installation.summaries(), *OWN]
        self.show("\n".join(lines))
        return 0

    def _run(self, name, words):
        if name not in self._modules:
            self._modules[name] = installation.load(self.files[name], "rtshell_lite " + name)
        module = self._modules[name]
        before = sys.argv
        sys.argv = [name] + words
        try:
            status = self._command(module.arguments, module.run, module.__doc__, words)
            sys.stdout.flush()
            return status
        finally:
            sys.argv = before

    def _change_directory(self, name, words):
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            status = self._run(name, words)
        if not status:
            os.environ["RTCSH_CWD"] = printed.getvalue().rstrip("\n")
        return status
