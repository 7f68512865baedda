"""Completion of an unfinished command line: commands, options, paths, ports, sets, parameters, files.

An argument is completed by its choices or by its metavar (KINDS below); an attribute `completion` overrides
the metavar. Words
such as rtconf's `get` come from the lines of a docstring that show their use, `  rtconf PATH get PARAM`. So a
new command needs nothing here.
"""

import argparse
import collections
import os
import re

from rtshell_lite import errors, options
from rtshell_lite.corba import session
from rtshell_lite.net import loop
from rtshell_lite.path import ROOT, parse
from rtshell_lite.robot import lookup, tree
from rtshell_lite.shell import installation, setup
from rtshell_lite.text import is_plain, printable

# `text` replaces the whole last word; a `final` word is complete, others may be continued (a directory, an
# optional port).
Candidate = collections.namedtuple("Candidate", "text final help")

SECONDS = 0.7  # for everything: with the start of Python, an answer takes at most a second


async def candidates(words, redirected=False):
    """The Candidates for the last of `words`, a command line whose other words are complete; [] in case of
    any failure.

    The text of a candidate begins with what was typed. With `redirected`, the last word is the file after a <
    or >. Asks at most one name server and one component.
    """
    try:
        if redirected:
            offered = await _files(words[-1], [])
        elif words[1:]:
            offered = await _arguments(os.path.basename(words[0]), words[1:-1], words[-1])
        else:
            offered = [Candidate(name, True, "") for name in installation.commands()]
    except (errors.Error, OSError):
        return []
    fitting = [candidate for candidate in offered if candidate.text.startswith(words[-1])]
    return sorted({candidate.text: candidate for candidate in fitting}.values())


async def answers(which, line, typed, meant=lambda words: words):
    """The lines with completions of `line` for the shell `which`; none if they take longer than SECONDS.

    `typed` is the end of the line that the shell replaces by one of them; `meant` turns the words of the
    line, as typed in rtsh, into those of a command.
    """
    line = setup.split(line, which == "fish")
    if line.open or not line.words[0]:
        return []
    session.current().timeout = min(session.current().timeout, SECONDS)
    offered = await loop.race(candidates(meant(line.words), line.redirected), loop.sleep(SECONDS))
    return setup.answers(which, line, offered or [], typed)


async def _arguments(command, before, word):
    commands = installation.commands()
    if command not in commands:
        return []
    module = installation.load(commands[command], "rtshell_lite command")
    parser = options.parser(module.arguments, module.__doc__, command)
    if parser.verbs is None:
        return await _words(parser, module.__doc__, before, word)
    first = parser.verbs.first_words() if not before else {}
    offered = [
        Candidate(name, True, help) for name, help in first.items() if word or not name.startswith("-")
    ]
    parser, before = parser.verbs.choose(before)
    return offered + (await _words(parser, "", before, word) if parser else [])


async def _words(parser, doc, before, word):
    """What may follow the words `before` of a command, or of a verb of it, whose Parser this is."""
    positional, option, ended = parser.unfinished(before)
    positional = Positional(positional)
    positional.line = before
    if option:
        offered = await _for_action(option, word, positional)
        if offered or option.nargs != "?":
            return offered
    elif word.startswith("-") and not ended:
        return await _options(parser, word, positional)
    return await _positional(parser, doc, positional, word)


class Positional(list):
    """The words before the last that are no options; `line` are all."""

    line = ()


async def _options(parser, word, positional):
    """Options, or the value of one after its equals sign."""
    name, equals, value = word.partition("=")
    options = {
        text: action
        for action in parser._actions
        for text in action.option_strings
        if action.help is not argparse.SUPPRESS
    }
    if not equals:
        formatter = parser._get_formatter()
        return [Candidate(text, True, formatter._expand_help(action)) for text, action in options.items()]
    offered = await _for_action(options[name], value, positional) if name in options else []
    return [candidate._replace(text=f"{name}={candidate.text}") for candidate in offered]


async def _positional(parser, doc, positional, word):
    actions = [action for action in parser._actions if not action.option_strings]
    if not actions:
        return []
    many = [i for i, action in enumerate(actions) if action.nargs in ("*", "+")]
    number = min([len(positional)] + many)
    if number >= len(actions):
        return []
    uses = _uses(doc, parser.prog)
    action = actions[number]
    if action.metavar == "COMMAND" and uses:
        return [Candidate(use, True, "") for use in uses]
    if action.metavar == "ARG" and uses:
        chosen = uses.get(positional[number - 1], [])
        kinds = chosen[len(positional) - number :]
        if not kinds and chosen[-1:] == ["PATH"]:
            kinds = ["PATH"]
        return await _of_kind(kinds[0], word, positional) if kinds else []
    return await _for_action(action, word, positional)


def _uses(doc, prog):
    """{command word: metavars after it} from lines such as `  rtconf PATH get PARAM` and `  rtec PATH start |
    stop   …`.
    """
    uses = {}
    for line in (doc or "").partition("\nexamples:")[0].split("\n"):
        words = re.split(r" {2,}", line.strip())[0].replace(" ...", "").split(" ")
        if line.startswith(f"  {prog} PATH "):
            bare = [word.strip("[]") for word in words[2:]]
            metavars = [word for word in bare if word.isupper()]
            uses.update((name, metavars) for name in bare if name.islower())
    return uses


async def _for_action(action, word, positional):
    choices = action.choices or getattr(action.type, "words", None)
    if choices:
        return [Candidate(choice, True, "") for choice in choices]
    return await _of_kind(getattr(action, "completion", action.metavar), word, positional)


async def _of_kind(kind, word, positional):
    complete = KINDS.get(kind)
    return await complete(word, positional) if complete and word is not None else []


# ---- the RTC Tree ----

# A printable name in a directory; directory, manager, component (of kind rtc) or another object
_Entry = collections.namedtuple("_Entry", "name kind")


def _paths(kinds, port_types=(), port_needed=False):
    """A function that completes paths to _Entries of these `kinds`, and to ports of some types."""

    async def complete(word, _):
        above, last = _split(word)
        component, colon, _ = _cut_at_colon(last)
        is_port = colon and (parse(above or ".") != ROOT or lookup.is_path(component))
        if is_port:
            return await _ports(above + component, port_types) if port_types else []
        offered = []
        for entry in await _all_entries(above):
            path = _no_option(above + entry.name)
            if entry.kind == "directory" or entry.kind == "manager" and "manager" not in kinds:
                offered.append(Candidate(path + "/", False, ""))
            elif entry.kind == "component" and port_types and port_needed:
                offered.append(Candidate(path + ":", False, ""))
            elif entry.kind == "component" and port_types:
                offered.append(Candidate(path, False, ""))
            elif entry.kind in kinds and not port_needed:
                offered.append(Candidate(path, True, ""))
        return offered

    return complete


def _no_option(word):
    return "./" + word if word.startswith("-") else word


def _split(word):
    """Split a path after its last unescaped slash."""
    last = re.search(r"(?:\\.|[^\\/])*\\?\Z", word, re.DOTALL).start()
    return word[:last], word[last:]


def _cut_at_colon(name):
    match = re.match(r"((?:\\.|[^\\:])*)(:?)(.*)\Z", name, re.DOTALL)
    return match.groups() if match else (name, "", "")


async def _all_entries(above):
    """The _Entries of the directory, or of the directories, that the beginning of a path may mean."""
    if lookup.has_pattern(above):
        return await _entries_below(parse(above))
    (path,) = await lookup.paths([above or "."])
    entries = await _entries(path)
    if not above and lookup.is_found_by_name():
        entries += [entry for entry in await _entries_below(lookup.EVERYWHERE) if entry.kind != "directory"]
    return entries


async def _entries_below(path):
    """The _Entries of all directories that a Path with * or ** fits; no component is asked."""
    entries = []
    for node in await lookup.below(path):
        kind = "directory" if node.kind == "server" else _BY_NAME.get(node.path.names[-1].kind, node.kind)
        entries.append(_Entry(node.name, kind))
    return entries


async def _entries(path):
    """The _Entries of a directory, by one call: bindings and kinds of names say well enough what they are."""
    node = await tree.resolve(path)
    if node.kind == "unsure":
        (node,) = await tree.check_alive([node])
    if node.kind in ("server", "directory"):
        return [
            _Entry(str(name), "directory" if is_context else _BY_NAME.get(name.kind, "object"))
            for name, is_context in await tree.bound(node)
        ]
    if node.kind not in tree.DIRECTORIES:
        return []
    children = [(child.name, child.kind) for child in await tree.children(node)]
    return [_Entry(name, "directory" if kind == "server" else kind) for name, kind in children]


_BY_NAME = {"mgr": "manager", "rtc": "component"}  # kinds in names


async def _ports(component, types):
    from rtshell_lite.robot import ports

    (path,) = await lookup.paths([component])
    node = await tree.component(path)
    size = len(str(node.path))
    offered = [port for port in await ports.ports(node) if port.type in types]
    return [
        Candidate(component + ports.label(port)[size:], True, port.properties.get("dataport.data_type", ""))
        for port in offered
    ]


# ---- configuration ----


async def _configuration(path):
    from rtshell_lite.robot import configuration

    (component_path,) = await lookup.paths([path])
    return await configuration.of(await tree.component(component_path))


async def _sets(_, positional):
    sets = (await _configuration(positional[0])).sets() if positional else []
    return [Candidate(printable(one_set.id), True, "") for one_set in sets]


async def _parameters(_, positional):
    values = (await _configuration(positional[0])).set().values if positional else {}
    return [Candidate(printable(name), True, printable(value)) for name, value in values.items()]


# ---- services ----

_services = _paths(("component", "object", "manager"), ("CorbaPort",))


async def _calls(word, positional):
    """Of rtcall: a service port or a component, an operation, arguments."""
    if not positional or "-l" in positional.line:
        return await _services(word, positional)
    from rtshell_lite.shell import calls

    idl = [value for option, value in zip(positional.line, positional.line[1:]) if option == "--idl"]
    return [Candidate(*fields) for fields in await calls.offered(word, positional, idl)]


# ---- local files ----


async def _files(word, _):
    return await loop.on_thread(_listed, word)  # a file server may hang: it must not stop the loop


def _listed(word):
    above = word[: word.rfind("/") + 1]
    begun = word[len(above) :]
    directory = os.path.expanduser(above)
    offered = []
    for name in os.listdir(directory or "."):
        is_hidden = name.startswith(".") and not begun.startswith(".")
        if is_hidden or not is_plain(name):
            continue
        path = _no_option(above + name)
        is_directory = os.path.isdir(os.path.join(directory, name))
        offered.append(Candidate(path + "/", False, "") if is_directory else Candidate(path, True, ""))
    return offered


async def _logs(word, positional):
    """LOG of rtlog; with -f, what follows it."""
    is_named = any(name in positional.line for name in ("-f", "--filename"))
    return await (KINDS["PATH[:PORT]"] if is_named else _files)(word, positional)


async def _directories(word, positional):
    return [candidate for candidate in await _files(word, positional) if not candidate.final]


_DATA = ("DataInPort", "DataOutPort")
_ALL = ("DataInPort", "DataOutPort", "CorbaPort", "Port")
_OBJECTS = ("component", "object")


async def _properties(_, __):
    """Properties of connections that OpenRTM knows."""
    from rtshell_lite.robot import ports

    return [Candidate(name + "=", False, "") for name in ports.PROPERTIES]


KINDS = {
    "PATH": _paths(_OBJECTS),
    "OTHER": _paths(_OBJECTS),
    "PATH|SERVER": _paths(_OBJECTS),
    "MANAGER[:NAME] | COMPOSITE": _paths(_OBJECTS),
    "DIRECTORY": _paths(()),
    "SERVER": _paths(()),
    "MANAGER": _paths(("manager",)),
    "PATH:PORT": _paths(_OBJECTS, _ALL, True),
    "PATH:PORT[.NAME]": _paths(_OBJECTS, _DATA, True),
    "PATH[:PORT]": _paths(_OBJECTS, _ALL),
    "PATH[:PORT,…]": _paths(_OBJECTS, _ALL),
    "PATH:SVC": _calls,
    "PATH:OUT": _paths(_OBJECTS, _DATA[1:], True),
    "PATH:IN": _paths(_OBJECTS, _DATA[:1], True),
    "SET": _sets,
    "PARAM": _parameters,
    "FILE": _files,
    "LOG": _logs,
    "DIR": _directories,
    "KEY=VALUE": _properties,
}
