"""Command lines about components all of whose text is hostile (mock_components/wicked.py), and what none of
them may print.
"""

import json
import re
import shutil

import invocations
from rtshell_lite import path, text

from mock_components import wicked

KEYS = list(wicked.STRINGS)
FATAL = set(invocations.stated("fatal")) | {"rtmgr"}  # after these the world is another
# what these print to what is no terminal has to come as it is, to be given back
AS_IT_IS = ("A getstructure", "A get p", "A get_sdo_id --limit 2")
FITTING = [('-c {"data":1}', '-c {"data":"1"}'), ("-c 1 ", '-c "1" ')]  # these ports take texts
READING = ("-d -f LOG", "-p -f LOG", "--csv -f LOG", "--json -f LOG")  # rtlog without asking anybody
SHELLS = [
    words for words in (["dash"], ["busybox", "ash"], ["bash"], ["zsh"], ["mksh"]) if shutil.which(words[0])
]
NEAR = 20000  # characters of a name that its ports are called by
# what colours, clears and moves, and lets no line wrap; rtlog -p ends its line with a return, long work
# begins with one, so that the next text covers it
OWN = re.compile(
    "\x1b\\[K\r|\r\x1b\\[K|\x1b\\[(?:(?:%s)m|2K|\\d*A|[HJK]|\\?1049[hl]|\\?25[hl]|\\?7[hl])"
    % "|".join(sorted(set(text.COLOURS.values()) | {"00"}))
)
HARMFUL = re.compile(
    "[\x00-\x09\x0b-\x1f\x7f-\x9f\u061c\u200b-\u200f\u2028-\u202e\u2060-\u2069\ufeff\u3164\u115f\uffa0\u2800"
    "\U000e0041\ufe0f\u034f]|[^\x21-\U0010ffff]\u0301|[\u0301\u0332\u20dd]{5}"
)


def lines():
    """[(command, [its lines, as transcripts state them, the first one first])]"""
    stated = sorted(invocations.stated("invocation").items())
    return [(command, lines + list(READING) if command == "rtlog" else lines) for command, lines in stated]


def is_about_one(line):
    """Whether a line is about the component of one string, and not about all of them."""
    return re.search(r"\b[AB]\b", line) is not None


class Place:
    """Where the components are: `home`, the path of their naming context; a profile of them, and a log."""

    def __init__(self, home, profile, log=""):
        self.home = path.parse(home)
        self.profile = profile
        self.log = log

    def component(self, key):
        """The path of the component of that string."""
        return self.home.child(path.Name(text.from_wire(wicked.STRINGS[key]), "rtc"))

    def port(self, key, kind):
        """The path of a port of it, an `out` or `in`."""
        return str(self.component(key).with_port(kind + text.from_wire(wicked.STRINGS[key][:NEAR])))

    def words(self, line, key):
        """The words of a line about the component of that string, and the next one."""
        other = KEYS[(KEYS.index(key) + 1) % len(KEYS)]
        manager = self.home.child(path.Name(wicked.STRINGS["substitution"], "mgr"))
        meant = {"SERVER": str(self.home), "A": str(self.component(key)), "B": str(self.component(other))}
        meant.update(OUT="out", LOG=self.log, MGR=str(manager), FILE=self.profile)
        for number, text_of_it in FITTING:
            line = line.replace(number, text_of_it)
        words = []
        for word in invocations.words(line, {name: name for name in meant}):
            port = re.match("(A|B):(out|in)$", word)
            if port:
                words.append(self.port(key if port.group(1) == "A" else other, port.group(2)))
            elif " " in word:  # for a shell
                quoted = {name: text.shell_word(value) for name, value in meant.items()}
                words.append(" ".join(invocations.words(word, quoted)))
            else:
                words += invocations.words(word, meant)[:1]
        return [word.replace(" ", "\\x20") if word.startswith("/") else word for word in words]


def problems(command, line, on_terminal, status, out, err):
    """What is wrong with what a command line has printed, texts."""
    said = err if line in AS_IT_IS and not on_terminal else out + err
    if on_terminal:
        said = OWN.sub("", said)
    if command == "rtmgr":
        said = said.replace("instance name:\t", "")  # as rtshell writes it
    is_bug = "Traceback" in said or "internal error" in said
    if status in (2, 70) or status > 128 or is_bug:
        yield "status %d" % status
    for harm in list(HARMFUL.finditer(said))[:3]:
        yield "harmful: %r" % said[max(0, harm.start() - 30):harm.end() + 10]
    if "--json" in line:
        for row in out.splitlines():
            if row.startswith("{") or not on_terminal:  # where both streams arrive
                json.loads(row.encode("utf-8").decode("ascii"))
