"""The whole command line as one text, docs/command-line.txt: every option of every command, its default and
one sentence. A change of it is seen in review.
"""

import argparse

from rtshell_lite import options
from rtshell_lite.shell import installation

HEAD = """Every option of every command, its default and one sentence.
Written by python3 -m tools.documentation; the tests compare it with the commands.
"""


def text():
    """The text of docs/command-line.txt."""
    common = options.parser(lambda parser: None, "", "")
    known = {(action.dest, action.help) for action in common._actions}
    parts = [HEAD, _part("every command", common, common._actions)]
    for name, path in sorted(installation.commands().items()):
        module = installation.load(path, "rtshell_lite command")
        for parser in parsers(options.parser(module.arguments, module.__doc__, name)):
            own = [action for action in parser._actions if (action.dest, action.help) not in known]
            parts.append(_part(parser.prog, parser, own))
    return "\n".join(parts)


def parsers(parser):
    """The Parsers of the verbs of a command; without verbs, its own."""
    if parser.verbs is None:
        return [parser]
    return [parser.verbs.parser(name) for name in parser.verbs.by_name]


def _part(title, parser, actions):
    shown = [action for action in actions if action.help is not argparse.SUPPRESS]
    shown.sort(key=lambda action: bool(action.option_strings))
    lines = [title]
    for action in shown:
        sentence = " ".join(parser._get_formatter()._expand_help(action).split())
        lines.append(f"  {_usage(action)}: {sentence}{_default(action, sentence)}")
    return "\n".join(lines) + "\n"


def _usage(action):
    """-e, --exec-context N"""
    value = action.metavar or action.dest.upper()
    if action.option_strings:
        return option(action, ", ".join(action.option_strings), value)
    return positional(action, value, "…")


def option(action, names, value):
    """An option as a synopsis shows it: its names, and its value in brackets where that may be left out."""
    if action.nargs == 0:
        return names
    if action.nargs == "?":
        return f"{names} [{value}]"
    return f"{names} {value}"


def positional(action, value, more):
    """A positional argument as a synopsis shows it; `more` follows what may be repeated."""
    if action.nargs == "?":
        return f"[{value}]"
    if action.nargs == "*":
        return f"[{value} {more}]"
    if action.nargs == "+":
        return f"{value} {more}"
    return value


def _default(action, sentence):
    """What is taken where the option is not given, unless its sentence says so, or that is nothing."""
    is_nothing = (
        action.default in (None, False, "", 0, argparse.SUPPRESS, options.FOREVER) or action.default == []
    )
    if not action.option_strings or is_nothing or "default" in sentence:
        return ""
    return f" (default: {action.default})"
