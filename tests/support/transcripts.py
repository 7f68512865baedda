"""Run shell transcripts: prose at the margin, an indented session whose output must come out again.

    A command, what it prints (stdout and stderr as they come), and its exit status if not 0:

      $ rtpwd --nonsense
      rtpwd: unrecognized arguments: --nonsense (see --help)
      [2]

A line may end in ` (re)` or ` (glob)`; one that cannot be shown as it is ends in ` (esc)`, one without
a newline in ` (no-eol)`. Lines such as `world: two` at the margin ask for peers: see session.py.
"""
import ast
import difflib
import json
import os
import re
import shutil
import sys

import jobs

COMMANDS = os.path.join(os.path.dirname(jobs.HERE), "commands")
SHELLS = {"dash": ["dash"], "ash": ["busybox", "ash"]}
# what recorders say of the machine on which tests run; stories show it (tests/sim/stories/rtlog-robot.t)
BUSY = re.compile(rb"^rt\w+: this machine has too much to do: ")
TIME_LIMIT = 400.0  # seconds for one file under one shell, on a busy machine
# see session.py; for tests of faults, see invocations.py:
DIRECTIVE = re.compile(
    r"(world|server|faulty|needs|python|orb|alone|both|"
    r"invocation|local|looking|lasting|broken server|broken component|fatal|examples?|prepared): *(.*)$"
)
AMBIGUOUS = re.compile(r"[$>]( |$)|\[\d+\]$")  # output that would be read as a command or a status
SUFFIX = re.compile(r" \((re|glob|esc|no-eol)\)$")


class Malformed(Exception):
    pass


class Step:
    """One command of a session, and the lines expected of it."""

    def __init__(self, number, command):
        self.number = number
        self.command = [command]
        self.expected = []

    def lines(self, output):
        """The text of the step in a file, with this output."""
        marks = ["  $ "] + ["  > "] * (len(self.command) - 1)
        command = [(mark + line).rstrip() for mark, line in zip(marks, self.command)]
        return command + ["  " + line if line else "" for line in output]


# ---- reading ----

def parse(text):
    """Split a transcript into lines of prose and Steps, in their order."""
    items = []
    blanks = []
    step = None
    for number, line in enumerate(text.splitlines(), 1):
        if not line.strip():
            blanks.append("")
        elif line.startswith("  $ "):
            step = Step(number, line[4:])
            items += blanks + [step]
            blanks = []
        elif line.startswith("  "):
            if step is None:
                raise Malformed("line %d: output that belongs to no command" % number)
            if (line + " ").startswith("  > ") and not step.expected and not blanks:
                step.command.append(line[4:])
            else:  # an empty line between lines of output is output
                step.expected += blanks + [line[2:]]
                blanks = []
        else:
            items += blanks + [line]
            blanks = []
            step = None
    return items + blanks


def steps(items):
    return [item for item in items if isinstance(item, Step)]


def directives(items):
    """What the prose asks for: pairs such as ("world", "many 200")."""
    matches = [DIRECTIVE.match(item) for item in items if not isinstance(item, Step)]
    return [match.groups() for match in matches if match]


def render(items, outputs):
    """The transcript's text, given the output of each step."""
    outputs = iter(outputs)
    lines = []
    for item in items:
        lines += item.lines(next(outputs)) if isinstance(item, Step) else [item]
    return "\n".join(lines) + "\n"


def helps(source):
    """What the file of a command has as its help: its docstring, and the texts of its verbs."""
    texts = [node.value for node in ast.walk(ast.parse(source)) if isinstance(node, (ast.Expr, ast.Assign))]
    texts = [getattr(text, "value", None) or getattr(text, "s", None) for text in texts]
    return [text for text in texts if isinstance(text, str) and "\nexamples:\n" in text]


# ---- spelling and comparing ----

def spell(raw, substitutions):
    """A line of output as a transcript shows it: names for what varies, controls escaped."""
    text = raw.decode("utf-8", "surrogateescape")
    for pattern, name in substitutions:
        text = re.sub(pattern, lambda match: name, text)
    body = text.rstrip(" ")
    ambiguous = AMBIGUOUS.match(text)
    if text.isprintable() and body == text and not ambiguous and not SUFFIX.search(text):
        return text
    shown = "".join(_escape(c) for c in body) + "\\x20" * (len(text) - len(body))
    if ambiguous:
        shown = "\\x%02x" % ord(text[0]) + shown[1:]
    return shown + " (esc)"


def _escape(character):
    code = ord(character)
    if character == "\\":
        return "\\\\"
    if character.isprintable():
        return character
    if 0xDC80 <= code <= 0xDCFF:  # a byte that is not UTF-8
        return "\\x%02x" % (code - 0xDC00)
    return {9: "\\t", 13: "\\r"}.get(code) or ("\\x%02x" if code < 0x80 else "\\u%04x") % code


def matches(expected, actual):
    if expected == actual:
        return True
    suffix = SUFFIX.search(expected)
    kind = suffix and suffix.group(1)
    if kind == "re":
        return re.match("(?:%s)\\Z" % expected[:suffix.start()], actual) is not None
    if kind == "glob":
        return re.match(_glob(expected[:suffix.start()]) + "\\Z", actual) is not None
    return False


def _glob(pattern):
    parts = re.findall(r"\\[*?\\]|.", pattern)
    return "".join({"*": ".*", "?": "."}.get(part, re.escape(part[-1:])) for part in parts)


def merge(expected, actual):
    """The actual lines, each replaced by the expected line that it matches.

    The result equals `expected` exactly if the step passes.
    """
    head = 0
    while head < min(len(expected), len(actual)) and matches(expected[head], actual[head]):
        head += 1
    return expected[:head] + _align(expected[head:], actual[head:])


def _align(expected, actual):
    """The actual lines, where patterns survive an --accept around them."""
    if len(expected) * len(actual) > 250000:
        return actual
    merged = list(actual)
    spelt = [next((line for line in expected if matches(line, each)), each) for each in actual]
    for block in difflib.SequenceMatcher(None, expected, spelt, autojunk=False).get_matching_blocks():
        merged[block.b:block.b + block.size] = expected[block.a:block.a + block.size]
    return merged


# ---- running ----

def run_case(path, shell, python=sys.executable, commands=None, orb=os.environ.get("RTSHELL_ORB"),
             accept=False, environment=None, time_limit=TIME_LIMIT):
    """Have session.py run a transcript under a shell: ("pass" or "fail" or "skip", explanation).

    `python` has omniORBpy; `commands` is their directory (None: the checkout's), `orb` theirs (None: the one
    that they choose themselves), unless the transcript demands another. The mocks have the environment.
    """
    request = json.dumps([path, SHELLS[shell], commands, orb, accept, time_limit])
    result, why, printed = jobs.run_job(python, "session.py", [request], time_limit + 60, environment)
    return tuple(result or ("fail", "the session broke down: %s\n%s" % (why, printed)))


def compare(path, text, items, results, problem, substitutions, accept):
    """What the results of the first steps of a transcript, and the problem that ended it, make of it."""
    outputs = [spell_step(*result, substitutions) for result in results]
    outputs = [merge(step.expected, actual) for step, actual in zip(steps(items), outputs)]
    return judge(path, text, items, outputs, problem, accept)


def judge(path, text, items, outputs, problem, accept):
    """The same of lines as they would stand in it."""
    outputs += [["… not reached"]] * (len(steps(items)) - len(outputs))
    actual = render(items, outputs)
    if accept and not problem:
        replace(path, actual)
        return "pass", ""
    if actual == render(items, [step.expected for step in steps(items)]) and not problem:
        return "pass", ""
    name = os.path.basename(path)
    difference = difflib.unified_diff(
        text.splitlines(), actual.splitlines(), name, name + " (actual)", lineterm=""
    )
    return "fail", "\n".join(list(difference) + [problem or ""])


def spell_step(raw, status, substitutions):
    """The lines of a step's output and status."""
    lines = [spell(line, substitutions) for line in raw.split(b"\n") if not BUSY.search(line)]
    if raw.endswith(b"\n") or not raw:
        lines.pop()
    else:
        lines[-1] += " (no-eol)"
    if status:
        lines.append("[%d]" % status)
    elif lines and not lines[-1]:
        lines[-1] = " (esc)"  # an empty line would not be seen at the end
    return lines


def replace(path, text):
    temporary = os.path.join(os.path.dirname(path), ".%s.tmp" % os.path.basename(path))
    with open(temporary, "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(temporary, path)


# ---- choosing ----

def cases(patterns=(), shells=None, directory=COMMANDS):
    """Pairs (path, shell) whose name, such as "rtls.t (dash)", holds one of the patterns."""
    paths = [os.path.join(directory, name) for name in sorted(os.listdir(directory)) if name.endswith(".t")]
    chosen = [(path, shell) for path in paths for shell in shells or SHELLS]
    return [case for case in chosen if not patterns or any(word in case_name(*case) for word in patterns)]


def case_name(path, shell):
    return "%s (%s)" % (os.path.basename(path), shell)


def missing_shells():
    return [shell for shell, words in sorted(SHELLS.items()) if not shutil.which(words[0])]


def says(path, word):
    """Does this transcript hold a directive, or the start of one: `alone` (it measures times), `orb: omniorb`
    …?
    """
    with open(path, encoding="utf-8") as file:
        return any(line.startswith(word if ":" in word else word + ":") for line in file)
