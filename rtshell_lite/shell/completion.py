"""What could stand at the end of an unfinished command line: commands, options, paths, ports, sets, parameters, files.

An argument's metavar says what completes it (KINDS below), or its choices do; an attribute `completion` on it counts before
the metavar, where what help shows is not precise enough. Words such as rtconf's `get` are taken from the lines of a docstring
that show their use, `  rtconf PATH get PARAM`. So a new command is completed without a word here.
"""
import argparse
import collections
import os
import re
import threading

from rtshell_lite import errors, options
from rtshell_lite.corba import lanes
from rtshell_lite.path import ROOT, parse
from rtshell_lite.robot import tree
from rtshell_lite.shell import installation, setup
from rtshell_lite.text import is_plain, printable

# `text` stands for the whole last word; a `final` word is complete, others go on (a directory, an optional port).
Candidate = collections.namedtuple("Candidate", "text final help")

SECONDS = 0.7  # for everything: with the start of Python, the answer is there within a second


def candidates(words, redirected=False):
    """The Candidates for the last of `words`, a command line whose other words are complete; [] in case of any failure.

    The text of a candidate begins with what was typed. With `redirected`, the last word is the file behind a < or >. Asks at
    most one name server and one component, changes nothing.
    """
    try:
        if redirected:
            found = _files(words[-1], [])
        else:
            found = _arguments(os.path.basename(words[0]), words[1:-1], words[-1]) if words[1:] else _command_names()
    except (errors.Error, OSError):
        return []
    return sorted({each.text: each for each in found if each.text.startswith(words[-1])}.values())


def answers(which, line, typed, meant=lambda words: words):
    """The lines that the shell `which` is to take for completions of `line`; none if they cannot be had in SECONDS.

    `typed` is that end of the line which the shell replaces by one of them; `meant` gives the words that it understands
    for those on the line.
    """
    line = setup.split(line, which == "fish")
    if line.open or not line.words[0]:
        return []
    found, before = [], lanes.session.timeout
    thread = threading.Thread(target=lambda: found.extend(candidates(meant(line.words), line.redirected)), daemon=True)
    lanes.session.timeout = min(lanes.session.timeout, SECONDS)
    thread.start()
    thread.join(SECONDS)
    lanes.session.timeout = before  # in rtsh there is an after
    return setup.answers(which, line, list(found), typed)


def _command_names():
    return [Candidate(name, True, "") for name in installation.commands()]


def _arguments(command, before, word):
    known = installation.commands()
    if command not in known:
        return []
    module = installation.load(known[command], "rtshell_lite command")
    parser = options.parser(module.arguments, module.__doc__, command)
    others, option, ended = parser.unfinished(before)
    if option:
        found = _for_action(option, word, others)
        return found if found or option.nargs != "?" else _positional(parser, module.__doc__, others, word)
    if word.startswith("-") and not ended:
        return _options(parser, word, others)
    return _positional(parser, module.__doc__, others, word)


def _options(parser, word, others):
    """Options, or the value of one after its equals sign."""
    name, equals, value = word.partition("=")
    options = {text: action for action in parser._actions for text in action.option_strings
               if action.help is not argparse.SUPPRESS}
    if not equals:
        formatter = parser._get_formatter()
        return [Candidate(text, True, formatter._expand_help(action)) for text, action in options.items()]
    found = _for_action(options[name], value, others) if name in options else []
    return [each._replace(text=name + "=" + each.text) for each in found]


def _positional(parser, doc, others, word):
    actions = [action for action in parser._actions if not action.option_strings]
    if not actions:
        return []
    many = [i for i, action in enumerate(actions) if action.nargs in ("*", "+")]
    number = min([len(others)] + many)
    if number >= len(actions):
        return []
    uses = _uses(doc, parser.prog)
    action = actions[number]
    if action.metavar == "COMMAND" and uses:
        return [Candidate(use, True, "") for use in uses]
    if action.metavar == "ARG" and uses:
        chosen = uses.get(others[number - 1], [])
        kinds = chosen[len(others) - number:] or [each for each in chosen[-1:] if each == "PATH"]
        return _of_kind(kinds[0], word, others) if kinds else []
    return _for_action(action, word, others)


def _uses(doc, prog):
    """{command word: metavars behind it} from lines such as `  rtconf PATH get PARAM` and `  rtec PATH start | stop   …`."""
    uses = {}
    for line in doc.partition("\nexamples:")[0].split("\n"):
        words = re.split(r" {2,}", line.strip())[0].replace(" ...", "").split(" ")
        if line.startswith(f"  {prog} PATH "):
            names = [word.strip("[]") for word in words[2:] if word.strip("[]").islower()]
            uses.update((name, [word.strip("[]") for word in words[2:] if word.strip("[]").isupper()]) for name in names)
    return uses


def _for_action(action, word, others):
    choices = action.choices or getattr(action.type, "words", None)
    if choices:
        return [Candidate(choice, True, "") for choice in choices]
    return _of_kind(getattr(action, "completion", action.metavar), word, others)


def _of_kind(kind, word, others):
    complete = KINDS.get(kind)
    return complete(word, others) if complete and word is not None else []


# ---- the RTC Tree ---------------------------------------------------------------------------------------------

_Entry = collections.namedtuple("_Entry", "name kind")  # what a directory holds, as spelt; directory, manager or object


def _paths(wanted, port_types=(), port_needed=False):
    """A function that completes paths to what is `wanted`: kinds of _Entry, and ports of some types."""
    def complete(word, others):
        above, last = _split(word)
        component, colon, _ = _cut_at_colon(last)
        if colon and parse(above or ".") != ROOT:
            return _ports(above + component, port_types) if port_types else []
        found = []
        for entry in _entries(parse(above or ".")):
            descend = entry.kind == "directory" or entry.kind == "manager" and "manager" not in wanted
            if descend:
                found.append(Candidate(_no_option(above + entry.name) + "/", False, ""))
            elif entry.kind in wanted or entry.kind == "object" and port_types:
                found.append(Candidate(_no_option(above + entry.name) + (":" if port_needed else ""), not port_types, ""))
        return found
    return complete


def _no_option(word):
    return "./" + word if word.startswith("-") else word


def _split(word):
    """A path at its last slash that no backslash protects."""
    last = re.search(r"(?:\\.|[^\\/])*\\?\Z", word, re.DOTALL).start()
    return word[:last], word[last:]


def _cut_at_colon(name):
    found = re.match(r"((?:\\.|[^\\:])*)(:?)(.*)\Z", name, re.DOTALL)
    return found.groups() if found else (name, "", "")


def _entries(path):
    """The _Entries of a directory, by one call for all names: what each is, its binding and its kind tell well enough."""
    node = tree.resolve(path)
    if node.kind == "unsure":
        node, = tree.look([node])
    if node.kind in ("server", "directory"):
        return [_Entry(str(name), "directory" if context else "manager" if name.kind == "mgr" else "object")
                for name, context in tree.bound(node)]
    if node.kind not in tree.DIRECTORIES:
        return []
    kinds = {"component": "object", "server": "directory"}
    return [_Entry(child.name, kinds.get(child.kind, child.kind)) for child in tree.children(node)]


def _ports(component, types):
    """Paths of the ports of a component. They alone are asked, as `ports` tells why."""
    from rtshell_lite.robot import ports
    node = tree.component(parse(component))
    found = []
    for each in ports.ports(node):
        if each.type in types:
            name = ports.label(each)[len(str(node.path)):]
            found.append(Candidate(component + name, True, each.properties.get("dataport.data_type", "")))
    return found


# ---- configuration --------------------------------------------------------------------------------------------

def _configuration(others):
    from rtshell_lite.robot import configuration
    return configuration.Configuration(tree.component(parse(others[0]))) if others else None


def _sets(word, others):
    found = _configuration(others)
    return [Candidate(printable(each.id), True, "") for each in found.sets()] if found else []


def _parameters(word, others):
    found = _configuration(others)
    return [Candidate(printable(name), True, printable(value)) for name, value in found.set().values.items()] if found else []


# ---- local files ----------------------------------------------------------------------------------------------

def _files(word, others):
    above = word[:word.rfind("/") + 1]
    found = []
    for name in os.listdir(os.path.expanduser(above) or "."):
        directory = os.path.isdir(os.path.join(os.path.expanduser(above), name))
        hidden = name.startswith(".") and not word[len(above):].startswith(".")
        if is_plain(name) and not hidden:
            found.append(Candidate(_no_option(above + name) + ("/" if directory else ""), not directory, ""))
    return found


def _directories(word, others):
    return [each for each in _files(word, others) if not each.final]


_DATA, _ALL = ("DataInPort", "DataOutPort"), ("DataInPort", "DataOutPort", "CorbaPort", "Port")
_OBJECTS = ("object",)

KINDS = {
    "PATH": _paths(_OBJECTS), "OTHER": _paths(_OBJECTS), "PATH|SERVER": _paths(_OBJECTS),
    "MANAGER[:NAME] | COMPOSITE": _paths(_OBJECTS),
    "DIRECTORY": _paths(()), "SERVER": _paths(()), "MANAGER": _paths(("manager",)),
    "PATH:PORT": _paths(_OBJECTS, _ALL, True), "PATH:PORT[.NAME]": _paths(_OBJECTS, _DATA, True),
    "PATH[:PORT]": _paths(_OBJECTS, _ALL), "PATH[:PORT,…]": _paths(_OBJECTS, _ALL),
    "PATH:OUT": _paths(_OBJECTS, _DATA[1:], True), "PATH:IN": _paths(_OBJECTS, _DATA[:1], True),
    "SET": _sets, "PARAM": _parameters, "FILE": _files, "DIR": _directories,
}
