"""The command line: its parser, and the options that commands share."""

import argparse
import os
import sys

from rtshell_lite import __version__, errors, text

FOREVER = float("inf")  # s
DAY = 86400  # s
SCREEN = 24  # lines that the short form of a help has at most
REST = 6  # of them after the options: those that all commands have, an example, where more is said
NARROWEST = 10  # columns that its words have at least, on however narrow a terminal
ENDING = ("--version", "--help", "-h")  # options that end the program
DIGITS = frozenset("0123456789.")
# words of a help for a value that is no option, and not empty: few want a file called -q
FILES = ("FILE", "OUT", "PROCFILE", "LOG", "REPORT", "DIR")
# how many words an option or argument takes at least and at most, by its `nargs`
COUNTS = {None: (1, 1), "?": (0, 1), "*": (0, FOREVER), "+": (1, FOREVER)}
# `nargs` by whether a value may be left out, and repeated
NARGS = {(False, False): None, (True, False): "?", (False, True): "+", (True, True): "*"}

EXIT_STATUSES = """exit status:
  0 done, 1 the answer is no or local work failed, 2 wrong usage,
  3 no such path or not that kind of object, 4 the peer is dead, silent or
  garbled, 5 some succeeded and some failed, 6 the peer refused,
  70 a bug in the tool, 130 Ctrl-C, 141 the reader of the output went away,
  129 SIGHUP, 143 SIGTERM (rtkeep and rtmount -f: 0)"""


# ---- reading it ----


class Words:
    """The words of a command line: its options, which may be anywhere, and the others.

    A subclass has `add_argument` and `_option_string_actions` as of argparse.
    """

    # {a word of another tool: the option that is meant}
    synonyms = {}  # type: dict
    # {an option of rtshell up to 3.0, which later ones do not have: what is written instead}
    former = {}  # type: dict
    # a function that says of an option that is not ours to which verbs it belongs, see verbs.py
    whose = None

    def option(self, spelling, help, **more):
        """Declare an option or an argument, spelt as in a manual. `more` is for add_argument.

        -d --dry-run              a flag
        -i --id ID                an option with a value
        --measure [SECONDS]       whose value may be left out: it is `const` then
        --property KEY=VALUE ...  may be repeated: a list, empty where it is not given
        PATH                      an argument, args.path unless `dest` says otherwise
        [COMMAND]                 may be left out
        PATH ..., [ARG ...]       any number of them, at least one or none

        Returns the Action.
        """
        words = spelling.split(" ")
        names = [word for word in words if word.startswith("-")]
        value = " ".join(words[len(names) :])
        if not value:
            return self.add_argument(*names, action="store_true", help=help, **more)
        is_optional = value.startswith("[") and value.endswith("]")
        if is_optional:
            value = value[1:-1]
        is_list = value.endswith(" ...")
        if is_list:
            value = value[: -len(" ...")]
        if names and value in FILES:
            more.setdefault("type", _file_name)
        if names and is_list:
            more.update(action="append", default=[])
        else:
            more["nargs"] = NARGS[is_optional, is_list]
        if not names:
            names = [more.pop("dest", value.lower())]
        return self.add_argument(*names, metavar=value, help=help, **more)

    def error(self, message):
        message = message.replace("invalid int value", "not a whole number")
        message = message.replace("invalid float value", "not a number")
        raise errors.Usage(message.replace(": -- ", ": "))

    def unfinished(self, words):
        """Where the first words of a command line lead, for completion.

        Returns the words that are not options, the option whose value comes next (or None), and whether `--`
        ended the options. Raises Usage for an unknown option.
        """
        positional = []
        rest = list(words)
        while rest:
            word = self.synonyms.get(rest[0], rest[0])
            del rest[0]
            if word == "--":
                return positional + rest, None, True
            if not self._is_option(word):
                positional.append(word)
                continue
            last = not rest
            # None when its value is in the same word
            action = self._option_string_actions.get(self._option(word, rest)[-1])
            if last and action and action.nargs != 0:
                return positional, action, False
        return positional, None, False

    def sort(self, argv):
        """Separate options with their values from the other words;
        argparse itself cannot mix them on all Pythons.
        """
        options = []
        words = []
        rest = list(argv)
        while rest:
            word = self.synonyms.get(rest[0], rest[0])
            del rest[0]
            if word == "--":
                words += rest
                break
            if self._is_option(word):
                self._check_last(word, rest, words)
                options += self._option(word, rest)
            else:
                words.append(word)
        return options, words

    def _check_last(self, option, rest, words):
        """Refuse `PATH --wait soon` and `--wait -1 PATH`: the word is meant to be the option's value, and
        does not look like a path.
        """
        action = self._option_string_actions.get(option)
        is_optional = action is not None and action.nargs == "?" and action.type is seconds
        if not is_optional or not rest:
            return
        is_last = words and len(rest) == 1
        is_negative = _begins_as_number(rest[0]) and not self._is_option(rest[0])
        if is_negative or is_last and _is_word(rest[0]):
            shown = text.printable(rest[0])
            self.error(f"argument {option}: not a number of seconds above 0: {shown}")

    def _is_option(self, word):
        if _begins_as_number(word):  # -5 is a number, -0 and -0R are options where there is a -0
            return word[:2] in self._option_string_actions and not DIGITS.intersection(word[2:])
        return word.startswith("-") and word != "-"

    def _option(self, word, rest):
        """One option, with its value, which may be taken from `rest`,
        as words that every Python's argparse reads; -lR is split.
        """
        if word.startswith("--"):
            name, equals, _ = word.partition("=")
            action = self._known(name, word)
            return [word] if equals else self._with_value(word, action, rest, "=")
        action = self._known(word[:2], word)
        if len(word) == 2:
            return self._with_value(word, action, rest, "")
        if action.nargs == 0:
            return [word[:2]] + self._option("-" + word[2:], rest)
        return [word]

    def _known(self, name, word):
        # argparse takes abbreviations, and allow_abbrev=False breaks -n5 before Python 3.8
        if name in self.former:
            self.error(f"{name} is an option of old versions; now: {self.former[name]}")
        if name not in self._option_string_actions:
            why = self.whose and self.whose(name)
            self.error(why or "unrecognized arguments: " + text.printable(word))
        return self._option_string_actions[name]

    def _with_value(self, word, action, rest, glue):
        if not rest or action.nargs == 0:
            return [word]
        if getattr(action, "metavar", None) in FILES and rest[0] in self._option_string_actions:
            if rest[0] in ENDING:
                return []
            self.error(f"argument {word}: a file is expected before {rest[0]} (./{rest[0]} is one)")
        # --wait PATH, --shell PATH: a word that cannot be the option's value is left alone
        if action.nargs == "?":
            if action.choices:
                fits = rest[0] in action.choices
            else:
                # an action may have a function of its own for what its value looks like
                fits = getattr(action, "value_like", _is_number)(rest[0])
            if not fits:
                return [word]
        value = rest.pop(0)
        # argparse takes -n -5 for two options
        return [word + glue + value] if value.startswith("-") else [word, value]


class Parser(Words, argparse.ArgumentParser):
    """argparse with options anywhere, negative numbers as arguments, no abbreviations, and our errors."""

    verbs = None  # a verbs.Verbs

    def parse_args(self, argv):  # type: ignore[override]
        if self.verbs is not None:
            parser, argv = self.verbs.choose(argv)
            if parser is None:
                self.print_help()
                self.exit()
            return parser.parse_args(argv)
        options, words = self.sort(argv)
        options.sort(key=lambda word: word in ENDING)  # -v adds to them
        return super().parse_args(options + ["--"] + words if words else options)

    def format_help(self):
        if self.verbs is None:
            return super().format_help()
        formatter = self._get_formatter()
        formatter.add_usage("%(prog)s VERB ...", (), ())
        for words in self.description, self.verbs.summaries(), self.epilog:
            formatter.add_text(words)
        return formatter.format_help()

    def short_help(self):
        """The help in SCREEN lines of a terminal where that can be: each option is one line, and there are
        as many examples as fit.
        """
        import textwrap

        dests = [action.dest for action in parser(lambda parser: None, "", "")._actions]
        common = [action for action in self._actions if action.dest in dests]
        arguments = [_synopsis(action) for action in self._actions if not action.option_strings]
        lines = [" ".join([f"usage: {self.prog} [OPTION ...]"] + arguments), ""]
        lines += textwrap.wrap(self.description, max(text.width() - 2, NARROWEST)) + [""]
        options = [action for action in self._actions if action not in common]
        lines += self._option_lines(options, SCREEN - len(lines) - REST)
        names = [f"{action.option_strings[0]} {action.metavar or ''}".strip() for action in common]
        lines += [f"  {', '.join(names)}: as all commands have them", ""]
        verbose = names[0]  # -v, but for rtcryo
        last = f"`{self.prog} --help {verbose}` says more, as does `man {self.prog.partition(' ')[0]}`."
        return "\n".join(lines + self._some_examples(SCREEN - len(lines) - 1) + [last, ""])

    def _option_lines(self, actions, room):
        """A line for each argument and option, with as many of the words of its help as fit; where they take
        more than `room` lines, the last ones have their names only.
        """
        import textwrap

        shown = [action for action in actions if action.help is not argparse.SUPPRESS]
        shown.sort(key=lambda action: bool(action.option_strings))
        names = [_synopsis(action) for action in shown]
        size = max([len(name) for name in names if len(name) < 24], default=0)
        lines = []
        for name, action in zip(names, shown):
            name = f"  {name.ljust(size)}  "
            meaning = self._get_formatter()._expand_help(action) if action.help else ""
            columns = max(text.width() - 1 - len(name), NARROWEST)
            lines.append(name + textwrap.shorten(meaning, columns, placeholder=" …"))
        for count in range(len(lines), 0, -1):
            last = [name for action in shown[count:] for name in action.option_strings]
            more = textwrap.wrap(", ".join(last) + " …", max(text.width() - 4, NARROWEST)) if last else []
            if count + len(more) <= room:
                return lines[:count] + ["  " + line for line in more]
        return lines

    def _some_examples(self, room):
        """The first examples of the help, and an empty line: as many as `room` lines hold, one at least."""
        formatter = self._get_formatter()
        columns = max(text.width() - 2, NARROWEST)
        lines = ["examples:"]
        for example in self.epilog.partition("examples:\n")[2].partition("\n\n")[0].split("\n"):
            more = formatter._fill_text(example, columns, "").split("\n")
            if len(lines) > 1 and len(lines) + len(more) + 1 > room:
                break
            lines += more
        return lines + [""]

    # argparse counts words with regular expressions, which take an eighth of the time of a command to import.
    # `pattern` has an A for each word that is no option, - for `--` and O for an option. What does not fit is
    # still its own affair.

    def _match_argument(self, action, pattern):
        """How many words an option takes."""
        there = len(pattern) - len(pattern.lstrip("A"))
        least, most = _counts(action)
        if not action.option_strings or there < least:
            return super()._match_argument(action, pattern)
        return min(there, most)

    def _match_arguments_partial(self, actions, pattern):
        """How many words each positional argument takes, as many as there are for the first ones."""
        there = len(pattern.lstrip("-"))
        counts = [_counts(action) for action in actions]
        spare = there - sum(least for least, _ in counts)
        if spare < 0 or "A" * there != pattern[-there:] and there:
            return super()._match_arguments_partial(actions, pattern)
        taken = []
        for least, most in counts:
            more = min(spare, most - least)
            spare -= more
            taken.append(least + more)
        if taken:
            taken[0] += len(pattern) - there  # the `--` before them
        return taken


def _synopsis(action):
    """An argument or an option as the short help has it: PATH ..., -m, --map OLD=NEW."""
    value = action.metavar or action.dest.upper()
    names = ", ".join(action.option_strings)
    if action.nargs == 0:
        return names
    least, most = _counts(action)
    if most == FOREVER:
        value += " ..."
    if not least:
        value = f"[{value}]"
    return f"{names} {value}".strip()


def _counts(action):
    """(least, most) words that an option or argument takes."""
    if isinstance(action.nargs, int):
        return action.nargs, action.nargs
    return COUNTS[action.nargs]


def _is_word(word):
    return word.isalpha() and text.is_ascii(word)


def _is_number(word):
    return word.replace(".", "", 1).isdecimal()


def _begins_as_number(word):
    """Whether a word begins as -5 or -.5 do."""
    return word.startswith("-") and word[1:].replace(".", "", 1)[:1].isdecimal()


def parser(arguments, doc, prog):
    """The parser of the command called `prog`, whose file has these `arguments` and this docstring, or None
    under PYTHONOPTIMIZE=2.
    """
    summary, _, details = (doc or "").strip().partition("\n\n")
    parser = Parser(
        prog=prog, description=summary, add_help=False, epilog=details, formatter_class=_formatter
    )
    arguments(parser)
    if parser.verbs is None:  # else each verb has them
        parser.epilog = "\n\n".join(filter(None, [details, EXIT_STATUSES]))
        common(parser)
    return parser


def common(parser):
    """The options of all commands, for an instance of Words."""
    taken = parser._option_string_actions  # rtcryo has a -v of its own
    parser.add_argument(
        *[o for o in ("-v", "--verbose") if o not in taken], action="store_true", dest="verbose",
        help="report on stderr what is done",
    )
    parser.option("-q --quiet", "no notes on stderr, errors only")
    if "--timeout" in taken:  # how long rtprint, rtinject and rtlog run
        parser.set_defaults(timeout=_default_timeout())
    else:
        parser.option(
            "--timeout SECONDS", "give up after SECONDS without an answer (default: $RTSHELL_TIMEOUT or 3)",
            type=seconds, default=_default_timeout(),
        )
    parser.add_argument(
        "--version", action=_Version, nargs=0,
        help="show the version, with -v also those of Python and the ORB, and exit",
    )
    parser.add_argument(
        "-h", "--help", action=_ShowHelp, nargs=0, help="show a short help, with -v all of it, and exit"
    )


class _Version(argparse.Action):
    def __call__(self, parser, namespace, *_):
        print(__version__)
        if namespace.verbose:
            from rtshell_lite.corba import orb

            print("Python %d.%d.%d, %s" % (*sys.version_info[:3], orb.version()))
        parser.exit()


class _ShowHelp(argparse.Action):
    def __call__(self, parser, namespace, *_):
        is_long = namespace.verbose or "examples:\n" not in (parser.epilog or "")
        print(parser.format_help() if is_long else parser.short_help(), end="")
        parser.exit()


class _Help(argparse.RawDescriptionHelpFormatter):
    """Wraps the paragraphs of docstrings, and entries with remarks beside them."""

    def _fill_text(self, text, width, indent):
        import re
        import textwrap

        lines = []
        for paragraph in text.split("\n\n"):
            block = paragraph.split("\n")
            if not any(line.startswith(" ") for line in block):
                block = [" ".join(block)]
            for line in _entries(block):
                further = " " * (len(line) - len(line.lstrip()) + 2) if line.startswith(" ") else ""
                if len(line) > width and re.search(r"\S {2,}\S", line):  # the remark goes below
                    above, line = re.split(r"(?<=\S) {2,}", line, 1)
                    further = " " * 8
                    lines.append(above)
                    line = further + line
                lines += textwrap.wrap(
                    line, width, subsequent_indent=further, break_on_hyphens=False, break_long_words=False
                )
            lines.append("")
        return "\n".join(lines[:-1])


def _entries(block):
    """The lines of a block, each with the lines that continue the remark beside it."""
    import re

    entries = []  # type: list
    for line in block:
        beside = entries and re.search(r"\S {2,}(?=\S)", entries[-1])
        if beside and len(line) - len(line.lstrip()) >= max(beside.end(), 12):
            entries[-1] += " " + line.lstrip()
        else:
            entries.append(line)
    return entries


def _formatter(prog):
    # argparse makes a formatter for every option; without a width that imports shutil, 2 ms
    return _Help(prog, width=text.width() - 2)


def _default_timeout():
    value = os.environ.get("RTSHELL_TIMEOUT") or "3"
    try:
        return seconds(value)
    except argparse.ArgumentTypeError as e:
        raise errors.Usage(f"RTSHELL_TIMEOUT: {e}")


def seconds(value):
    """An option type: a positive number of seconds, at most a day."""
    number = _positive(value, "a number of seconds above 0")
    if number > DAY:
        raise argparse.ArgumentTypeError(f"more than a day, {DAY} s: {text.printable(value)}")
    return number


def one_of(*words):
    """An option type that accepts these words; argparse's own message differs from one Python to the next."""

    def check(word):
        if word not in words:
            raise argparse.ArgumentTypeError(f"not one of {', '.join(words)}: {text.printable(word)}")
        return word

    check.words = words  # for completion
    return check


def state(word):
    """An option type: a state of a component, in any case."""
    if word.lower() not in state.words:
        candidates = text.candidates(word, state.words)
        raise argparse.ArgumentTypeError(f"no such state: {text.printable(word)}{candidates}")
    return word


state.words = [name.lower() for name in text.STATES]  # for completion


# ---- options that commands share ----


def paths(parser, nargs="+", metavar="PATH", help="path in the RTC Tree"):
    """The positional arguments `paths`; completion.py reads from `metavar` what they are."""
    return parser.add_argument("paths", nargs=nargs, metavar=metavar, help=help)


def command(args, words):
    """Check that args.command, which follows args.path, is one of these words. Raises Usage."""
    if args.command in words:
        return
    if args.path in words:
        raise errors.Usage(f"the path comes first: {text.shell_word(args.command)} {args.path} …")
    candidates = text.candidates(args.command, words)
    raise errors.Usage(f"no such command: {text.printable(args.command)}{candidates}")


def execution_context(parser):
    """-e: which execution context."""
    parser.option(
        "-e --exec-context --exec_context N",
        "only in execution context N, as rtec numbers them: from 0, the component's own first",
        type=int,
    )


def wait(parser, what):
    """--wait[=SECONDS]: args.wait is None, or how long to wait."""
    parser.option(
        "--wait [SECONDS]", f"wait until {what}, at most SECONDS (default: 5)", type=seconds, const=5.0
    )


def transition(parser, verb, state):
    """Which components change their state, where, and whether to wait for that: for transitions.asked."""
    paths(parser)
    execution_context(parser)
    wait(parser, f"the components are {state}")
    parser.option(
        "--all", f"{verb} all components at and below each PATH, in parallel, and print what became of each"
    )
    dry_run(parser)


def dry_run(parser):
    """--dry-run."""
    parser.option("--dry-run", "print what would be done, as commands, and change nothing")


def force_disconnect(parser):
    """--force, of commands that remove connections."""
    parser.option("--force", "remove connections at once, even where that may end a process")


def json_output(parser):
    """--json."""
    parser.option("--json", "print JSON, one object a line")


def null(parser):
    """-0."""
    parser.option("-0 --null", "print full paths, each followed by a NUL byte (for xargs -0)")


def profile_file(parser):
    """The RtsProfile that a command works with:
    args.file, - for stdin, args.form (see `profile_form`), args.map.
    """
    parser.option("[FILE]", "an RtsProfile in XML or YAML (default: stdin)", default="-")
    profile_options(parser)


def profile_options(parser):
    """How a profile is read: args.form, see `profile_form`, and args.map."""
    moves(parser, "-m", "--map")
    profile_form(parser, "the file is")


def moves(parser, *names):
    """args.map: words for relocate.Map."""
    parser.add_argument(
        *names, action="append", default=[], metavar="OLD=NEW",
        help="read OLD in the paths of the file as NEW, as rtresurrect --help -v explains; may be repeated",
    )


def strict_path(parser):
    """--strict-path: args.strict_path."""
    parser.option(
        "--strict-path", "an end of a connection is a component only if path, id and instance name agree"
    )


def profile_form(parser, verb):
    """-x and -y: args.form is xml, yaml or None; the last option counts."""
    parser.add_argument("-x", "--xml", action="store_const", dest="form", const="xml", help=f"{verb} XML")
    parser.add_argument("-y", "--yaml", action="store_const", dest="form", const="yaml", help=f"{verb} YAML")


# ---- options of commands that send or receive data ----


def duration(parser, help):
    """-t/--timeout SECONDS as in rtshell: args.duration, infinite where not given or negative.

    Only RTSHELL_TIMEOUT then says how long a peer may stay silent.
    """
    parser.option("-t --timeout SECONDS", help, dest="duration", type=_duration, default=FOREVER)


def limits(parser, what):
    """-n and -t: args.number, below 0 where not given, and args.duration, infinite where not given."""
    parser.option("-n --number N", f"end after N {what} (default: never)", type=int, default=-1)
    parser.option(
        "-t SECONDS", f"end after SECONDS; status 1 when there were fewer than N {what}",
        dest="duration", type=_duration, default=FOREVER,
    )


FLUENTD = 24224  # the TCP port of fluentd
HERE = "127.0.0.1"  # where a command listens unless an address is given: only this host can connect


def listen(parser):
    """--listen [[HOST:]PORT] and --from: args.listen is None or (host, TCP port), args.senders a list of
    addresses; `check_listen` checks them.
    """
    parser.option(
        "--listen [[HOST:]PORT]",
        "receive logs that OpenRTM 2 sends through Fluent Bit, at this TCP port (default: "
        f"{FLUENTD}; 0: any) of {HERE}, where only this host can send, or of the address HOST: "
        f"0.0.0.0:{FLUENTD} lets anybody send who reaches it",
        type=listen_address, const=(HERE, FLUENTD),
    ).value_like = is_listen_address
    parser.option(
        "--from ADDRESS ...",
        "with --listen: only from this IP address; may be repeated (default: from anybody)",
        dest="senders", type=_address,
    )


def check_listen(args):
    """Raises Usage for senders that cannot reach where --listen listens."""
    if args.senders and args.listen is None:
        raise errors.Usage("--from is for --listen")
    far = [sender for sender in args.senders if not is_loopback(sender)]
    if far and is_loopback(args.listen[0]):
        raise errors.Usage(
            f"--from {far[0]}: only this host reaches {args.listen[0]}; listen at an address of this host, "
            f"or at all: --listen 0.0.0.0:{args.listen[1]}"
        )


def is_loopback(address):
    """Whether only this host can reach an address, or a name for it."""
    return address in ("::1", "localhost") or address.startswith("127.")


def listen_address(word):
    """An option type: (host, TCP port) of [HOST:]PORT, [::1]:2809 with IPv6; HERE without a host."""
    host, _, number = word.rpartition(":")
    is_host = ":" not in host or host.startswith("[") and host.endswith("]")
    if not is_host or not number.isdecimal() or len(number) > 5 or int(number) > 65535:
        raise argparse.ArgumentTypeError(f"not [HOST:]PORT: {text.printable(word)}")
    return host.strip("[]") or HERE, int(number)


def is_listen_address(word):
    """Whether a word looks like a `listen_address`, not like a path in the RTC Tree."""
    host, _, number = word.rpartition(":")
    return number.isdecimal() and "/" not in word and (":" not in host or host.startswith("["))


def _address(value):
    import ipaddress

    try:
        return str(ipaddress.ip_address(value.strip("[]")))
    except ValueError:
        raise argparse.ArgumentTypeError(f"not an IP address: {text.printable(value)}")


def _file_name(value):
    """An option type: the name of a file. A shell makes an empty one of a variable that is not set."""
    if not value:
        raise argparse.ArgumentTypeError("the name is empty")
    return value


def count(value):
    """An option type: a whole number above 0."""
    if not value.isdecimal() or len(value) > 9 or not int(value):
        raise argparse.ArgumentTypeError(f"not a whole number above 0: {text.printable(value)}")
    return int(value)


def _duration(value):
    try:
        if float(value) < 0:
            return FOREVER
    except ValueError:
        pass
    return seconds(value)


def hertz(value):
    """An option type: a positive rate in Hz."""
    return _positive(value, "a number of Hz above 0")


def factor(value):
    """An option type: a positive number."""
    return _positive(value, "a number above 0")


def _positive(value, expected):
    try:
        number = float(value)
    except ValueError:
        number = 0.0
    if not 0 < number <= sys.float_info.max:
        raise argparse.ArgumentTypeError(f"not {expected}: {text.printable(value)}")
    return number


def types(parser, *path_options):
    """Where data types come from: args.modules, args.python_path, args.idl, args.include; all lists."""
    parser.option(
        "-m --mod MODULE ...", "Python module with data types, made by omniidl; may be repeated",
        dest="modules",
    )
    parser.add_argument(
        *path_options, action="append", default=[], dest="python_path", metavar="DIR",
        help="directory with Python modules; may be repeated",
    )
    idl(parser, "data types")


def idl(parser, what):
    """--idl and -I: args.idl and args.include, lists."""
    parser.option("--idl FILE ...", f"IDL file with {what}; may be repeated")
    parser.option("-I --include DIR ...", "directory for #include in IDL files; may be repeated")


def properties(parser):
    """--property KEY=VALUE: args.properties, a list of words for `pairs`."""
    parser.option(
        "--property KEY=VALUE ...", "a property of the connection, as with rtcon -p; may be repeated",
        dest="properties",
    )


def delivery(parser):
    """--linger and --anyway: args.linger, seconds or None, and args.anyway."""
    parser.option(
        "--linger SECONDS",
        "stay connected at most SECONDS after the last value (default: until all can have been read)",
        type=_linger,
    )
    parser.option("--anyway", "send even to a component that will not read the values now")


def _linger(value):
    return 0.0 if value == "0" else seconds(value)


def pairs(words):
    """KEY=VALUE words as a dict. Raises Usage."""
    for word in words:
        if not word.partition("=")[0] or "=" not in word:
            raise errors.Usage(f"not KEY=VALUE: {text.printable(word)}")
    return dict(word.split("=", 1) for word in words)
