"""Commands with verbs, such as `rtlog play` and `rtlog show`: each verb has a help, options and a function of
its own, as a command has.

A line without a verb means what it meant before the command had verbs: its flags choose one.
"""

import argparse

from rtshell_lite import options
from rtshell_lite.records import record

# `arguments`, `run` and `doc` are as those of a command. `idle`: options that the verb lacks, and that a line
# without a verb may have all the same: they have no effect, and never had.
Verb = record("Verb", "arguments run doc idle")


def declare(parser, by_name, rows):
    """In arguments(parser) of a command: it has these Verbs, {name: Verb}.

    `rows` of (flags, name): a line without a verb means that of the first row of which it has all flags; the
    last row has none. Flags that are no options of verbs are in no help; -p/--play is one with two spellings.
    """
    parser.verbs = Verbs(parser, by_name, rows)


def run(args):
    """The run(args) of a command with verbs."""
    return args.verb.run(args)


class Verbs:
    """The verbs of a command, whose Parser is `top`."""

    def __init__(self, top, by_name, rows):
        self.top = top
        self.by_name = by_name
        self._rows = rows

    def choose(self, argv):
        """(the Parser of the verb that a command line means, the words for it), (None, …) if the help of the
        command is wanted. Raises Usage.
        """
        if argv and argv[0] in self.by_name:
            return self.parser(argv[0]), argv[1:]
        all_options = self._options(self.by_name)
        argv = self._split(argv, all_options)
        given, words = all_options.sort(argv)
        given = {name for word in given if word.startswith("-") for name in all_options.named(word).names}
        flags, name = next(row for row in self._rows if given.issuperset(_spellings(row[0])))
        if not flags and words and words[0] in self.by_name:
            argv.remove(words[0])
            return self.parser(words[0]), argv
        if not flags and "--help" in given:
            return None, argv
        idle = self.by_name[name].idle.split()
        return self.parser(name, [all_options.named(word) for word in idle]), argv

    def parser(self, name, idle=()):
        """The options.Parser of a verb; it also takes the `idle` options."""
        verb = self.by_name[name]
        parser = options.parser(verb.arguments, verb.doc, f"{self.top.prog} {name}")
        self._add_flags(parser, [name])
        for option in idle:
            spellings = [word for word in option.names if word not in parser._option_string_actions]
            value = {"action": "store_true"} if option.nargs == 0 else {"nargs": option.nargs}
            parser.add_argument(*spellings, help=argparse.SUPPRESS, **value)
        parser.set_defaults(verb=verb)
        parser.whose = lambda option: self._whose(option, name)
        return parser

    def summaries(self):
        """The verbs, for the command's help: a line for each, with the first sentence of its own."""
        size = max(map(len, self.by_name)) + 2
        lines = [f"  {name.ljust(size)}{verb.doc.partition('.')[0]}" for name, verb in self.by_name.items()]
        return "\n".join(["verbs:"] + lines)

    def first_words(self):
        """What a command line may begin with, for completion: {verb or flag: what it means}."""
        meanings = {name: verb.doc.partition(".")[0] for name, verb in self.by_name.items()}
        for flags, name in self._rows:
            for word in _spellings(flags):
                meanings.setdefault(word, meanings[name])
        return meanings

    def _whose(self, option, name):
        """Says to which verbs an option belongs that the verb called `name` lacks; None if to none."""
        others = [other for other in self.by_name if self._options([other]).named(option)]
        if not others:
            return None
        verbs = " and ".join(filter(None, (", ".join(others[:-1]), others[-1])))
        return f"{option} is for {self.top.prog} {verbs}, not for {self.top.prog} {name}"

    def _options(self, names):
        """The _Options of these verbs."""
        declared = _Options()
        for name in names:
            self.by_name[name].arguments(declared)
        self._add_flags(declared, names)
        options.common(declared)
        return declared

    def _add_flags(self, parser, names):
        """Declare the flags that mean one of these verbs, and are no options of it."""
        flags = [flag.split("/") for row, name in self._rows if name in names for flag in row.split()]
        for spellings in flags:
            if spellings[0] not in parser._option_string_actions:
                parser.add_argument(*spellings, action="store_true", help=argparse.SUPPRESS)

    def _split(self, argv, all_options):
        """The words of a line, in which --mend=FILE is two: a flag that had a value precedes an argument."""
        flags = [word for row, _ in self._rows for word in _spellings(row)]
        words = []
        for word in argv:
            name, _, value = word.partition("=")
            is_flag = value and name in flags and all_options.named(name).nargs == 0
            words += [name, value] if is_flag else [word]
        return words


def _spellings(flags):
    """The flags of a row, each in all its spellings."""
    return flags.replace("/", " ").split()


class _Option:
    """What is needed of an option to tell which words are its value."""

    def __init__(self, names, nargs, choices, type):
        self.names = names
        self.nargs = nargs
        self.choices = choices
        self.type = type


class _Options(options.Words):
    """Options of several verbs, to sort the words of a line: argparse takes long to make each of them."""

    def __init__(self):
        self._option_string_actions = {}
        self._declared = {}

    def option(self, spelling, help, **more):
        """As that of a Parser; several verbs may have the same."""
        if spelling not in self._declared:
            self._declared[spelling] = super().option(spelling, help, **more)
        return self._declared[spelling]

    def add_argument(self, *names, action=None, nargs=None, choices=None, type=None, **_):
        """As that of argparse; returns an _Option."""
        if action in ("store_true", "store_const", "count", "help"):
            nargs = 0
        option = _Option(names, nargs, choices, type)
        for name in names:
            if name.startswith("-"):
                self._option_string_actions.setdefault(name, option)
        return option

    def set_defaults(self, **_):
        """As that of argparse."""

    def named(self, word):
        """The _Option that a word names, which may have its value, too; None where it names none."""
        name = word.partition("=")[0] if word.startswith("--") else word[:2]
        return self._option_string_actions.get(name)
