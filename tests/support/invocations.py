"""With which arguments every command is run by tests that run them all: what its transcript,
tests/commands/NAME.t, states.

At the margin of a transcript, as a rule at its end:

  invocation: -ll A       it asks somebody; the first one is that which shows or does most, and which needs no preparation
  local: why              instead of these: it contacts nobody
  looking: -l A           it only looks, and prints the same as long as nothing changes
  lasting: A:out          it goes on until it is ended; it must have someone to ask
  broken component: 0 5   statuses with which it may end besides 4, of a component that is dead, silent or garbled …
  broken server: 1        … and of such a name server
  fatal: why              components that others need may end by it

What is special about its examples is stated there, too: see tests/commands/test_examples.py.

Words stand for things: SERVER a name server (or another directory), A and B components (A:out an out port,
A:in an in port), MGR a manager, FILE an RtsProfile that connects A:out to B:in, OUT a file to write, LOG a
log that was recorded before.
"""  # noqa: E501

import os
import re

import transcripts

COMMANDS = os.path.join(os.path.dirname(os.path.dirname(transcripts.COMMANDS)), "bin")


def all_commands():
    """Names of all commands in bin/."""
    return sorted(name for name in os.listdir(COMMANDS) if re.match(r"rt[a-z]+$", name))


def stated(kind):
    """What transcripts state of one kind: {command: [line]}, without the commands that state nothing of it.
    """
    found = {}
    for command in all_commands():
        path = os.path.join(transcripts.COMMANDS, command + ".t")
        if os.path.exists(path):  # test_packaging fails on one that is missing
            with open(path, encoding="utf-8") as file:
                said = transcripts.directives(transcripts.parse(file.read()))
            found[command] = [words for name, words in said if name == kind]
    return {command: lines for command, lines in found.items() if lines}


def statuses(role):
    """With which statuses commands may end besides 4 when a "server" or "component" is broken: {command:
    {status}}.
    """
    return {
        command: {int(word) for line in lines for word in line.split()}
        for command, lines in stated("broken " + role).items()
    }


def words(line, places):
    """The words of a line of the tables, with what stands for things replaced: places = {"A": path, …}.

    Braces keep words together in which _ stands for a blank.
    """
    def word(w):
        if w.startswith("{") and w.endswith("}") and '"' not in w:
            w = w[1:-1].replace("_", " ")
        return re.sub(r"\b(SERVER|A|B|MGR|FILE|OUT|LOG)\b", lambda found: places[found.group()], w)
    return [word(w) for w in line.split()]
