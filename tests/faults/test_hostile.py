"""Peers all of whose text is hostile: it reaches no terminal, shell or reader of JSON unescaped.

If one of these fails, anybody who can start a component, or reach a name server, can type into the operator's
terminal.
"""
import glob
import json
import os
import re
import shutil
import subprocess
import sys
import unittest

import invocations
import running
import tools
from rtshell_lite import path, text

try:
    from mock_components import wicked
except ImportError:
    raise unittest.SkipTest("needs omniORBpy")

ONCE = "what is printed does not depend on the Python"
BOTH = "each ORB reads names in its own way"

ON_TERMINAL = [sys.executable, "-I", "-S", tools.__file__, "terminal", "80"]
KEYS = list(wicked.STRINGS)
FATAL = set(invocations.stated("fatal")) | {"rtmgr"}  # after these the world is another
USAGE = {"rtinject": {70}}   # the value does not fit the type of these ports
# what these print to what is no terminal has to come as it is, to be given back
AS_IT_IS = ("A getstructure", "A get p", "A get_sdo_id --limit 2")
READING = ("-d -f LOG", "-p -f LOG", "--csv -f LOG", "--json -f LOG")  # rtlog without asking anybody
EACH = 2                # strings that each command line meets
# what colours, clears and moves, and lets no line wrap; rtlog -p ends its line with a return, long work
# begins with one, so that the next text covers it
OWN = re.compile("\x1b\\[K\r|\r\x1b\\[K|\x1b\\[(?:(?:%s)m|2K|\\d*A|[HJK]|\\?1049[hl]|\\?25[hl]|\\?7[hl])" %
                 "|".join(sorted(set(text.COLOURS.values()) | {"00"})))
HARMFUL = re.compile(
    "[\x00-\x09\x0b-\x1f\x7f-\x9f\u061c\u200b-\u200f\u2028-\u202e\u2060-\u2069\ufeff\u3164\u115f\uffa0\u2800"
    "\U000e0041\ufe0f\u034f]|[^\x21-\U0010ffff]\u0301|[\u0301\u0332\u20dd]{5}"
)
SHELLS = [
    words for words in (["dash"], ["busybox", "ash"], ["bash"], ["zsh"], ["mksh"]) if shutil.which(words[0])
]


def setUpModule():
    global around, server, home, profile, log
    around = running.Surroundings()
    server = around.name_server()
    around.world(server, "wicked")
    home = path.parse(server + "/test.host_cxt")
    profile = os.path.join(around.top, "wicked.yaml")
    log = os.path.join(around.top, "wicked.rtlog")
    around.done(["rtcryo", "-q", "-y", "-o", profile, server])
    around.done(["rtlog", "-q", "-f", log, "-i", "-e", "4", port("lines", "out"), port("c1", "out")])


def tearDownModule():
    around.close()


def component(key):
    """Its path."""
    return home.child(path.Name(text.from_wire(wicked.STRINGS[key]), "rtc"))


def port(key, kind):
    """The path of a port of it."""
    return str(component(key).with_port(kind + text.from_wire(wicked.STRINGS[key][:20000])))


class Case:
    """A command line, and the components that it is about."""

    def __init__(self, number, command, line, key):
        self.number = number
        self.command = command
        self.line = line
        self.key = key
        self.on_terminal = number % 2 == 0

    def __str__(self):
        return "%s %s: %s%s" % (
            self.command,
            self.line,
            self.key,
            " on a terminal" if self.on_terminal else "",
        )

    def words(self):
        other = KEYS[(KEYS.index(self.key) + 1) % len(KEYS)]
        meant = {"SERVER": str(home), "A": str(component(self.key)), "B": str(component(other)), "OUT": (
            "out"
        ), "LOG": log,
                 "MGR": str(home.child(path.Name(wicked.STRINGS["substitution"], "mgr"))), "FILE": profile}
        words = []
        for word in invocations.words(self.line, {name: name for name in meant}):
            found = re.match("(A|B):(out|in)$", word)
            if found:
                words.append(port(self.key if found.group(1) == "A" else other, found.group(2)))
            else:
                words += (
                    invocations.words(word, meant)[:1]
                    if " " not in word
                    else [word.replace("SERVER", str(home))]
                )
        return [word.replace(" ", "\\x20") if word.startswith("/") else word for word in words]

    def run(self):
        where = around.directory("run%d" % self.number)
        inside = ON_TERMINAL if self.on_terminal else ()
        words = [self.command] + self.words()
        self.ran = running.run(words, where, inside, RTCTREE_NAMESERVERS=server[1:])
        return self

    def problems(self):
        ran = self.ran
        is_raw = self.line in AS_IT_IS and not self.on_terminal
        said = (b"" if is_raw else ran.out) + ran.err
        said = said.decode("utf-8", "backslashreplace")
        if self.on_terminal:
            said = OWN.sub("", said.replace("\r\n", "\n"))
        if self.command == "rtmgr":
            said = said.replace("instance name:\t", "")  # as rtshell writes it
        if (
            ran.status in USAGE.get(self.command, {2, 70})
            or ran.status > 128
            or "Traceback" in said
            or "internal error" in said
        ):
            yield "status %d" % ran.status
        for found in list(HARMFUL.finditer(said))[:3]:
            yield "harmful: %r" % said[max(0, found.start() - 30):found.end() + 10]
        if "--json" in self.line:
            for line in ran.out.splitlines():
                if line.startswith(b"{") or not self.on_terminal:  # where both streams arrive
                    json.loads(line.decode("ascii"))


def cases():
    found = [
        (command, line)
        for command, lines in sorted(invocations.stated("invocation").items())
        for line in lines
    ]
    found += [("rtlog", line) for line in READING]
    chosen = [(command, line, key) for number, (command, line) in enumerate(found)
              for key in running.sample(KEYS, EACH, number)]
    return [Case(number, *each) for number, each in enumerate(chosen)]


def canaries():
    return [
        name for name in glob.glob(os.path.join(glob.escape(around.top), "**", "canary*"), recursive=True)
    ]


class Hostile(unittest.TestCase):
    def check(self, done):
        for case in done:
            with self.subTest(str(case)):
                self.assertEqual(list(case.problems()), [], str(case.ran)[:3000].encode("unicode_escape"))
        self.assertEqual(canaries(), [])

    def test_1_paths_that_are_printed_can_be_typed(self):
        listed = running.run(["rtfind", str(home)], around.top)
        found = listed.out.decode().splitlines()
        self.assertGreater(len(found), 2 * len(KEYS))
        ran = running.run(["rtls", "-l"] + found, around.top)
        self.assertEqual((ran.status, ran.err), (0, b""))
        components = [line for line in found if line.endswith(".rtc") and len(line) < 100000]
        self.assertEqual(len(components), 2 * len(KEYS))  # the manager has them, too
        ports = []
        for line in running.run(["rtcat", "--json"] + components, around.top).out.decode().splitlines():
            ports += [each["path"] for each in json.loads(line)["ports"]]
        self.assertEqual(len(ports), 4 * len(components))
        for some in (ports[:len(ports) // 2], ports[len(ports) // 2:]):
            ran = running.run(["rtcat"] + some, around.top)
            self.assertEqual((ran.status, ran.err), (0, b""))

    def test_2_commands_that_are_printed_do_what_they_say(self):
        """Shells in which only stand-ins of our commands exist understand each line, and run nothing else."""
        tools = around.directory("tools")
        os.symlink(shutil.which("printf"), os.path.join(tools, "printf"))  # mksh has none of its own
        for name in invocations.all_commands():
            with open(os.path.join(tools, name), "w") as file:
                file.write("#!/bin/sh\nexit 0\n")
            os.chmod(os.path.join(tools, name), 0o755)

        def dry(command, *words):
            ran = running.run([command, "--dry-run"] + list(words), around.top)
            self.assertIn(ran.status, (0, 5), ran)
            return ran.out
        printed = dry("rtdis", str(component("substitution"))) + dry("rtdis", str(component("quotes")))
        printed += dry("rtcon", port("substitution", "out"), port("path", "in")) + dry(
            "rtcon", port("lines", "out"), port("bidi", "in")
        )
        printed += dry("rtdel", "--recursive", str(home)) + dry("rtteardown", profile)
        running.run(["rtteardown", "-q", profile], around.top)
        printed += dry("rtresurrect", profile)
        running.run(["rtresurrect", "-q", profile], around.top)
        counts = {
            name: len(re.findall(b"(?m)^%s " % name.encode(), printed))
            for name in ("rtcon", "rtdis", "rtdel")
        }
        self.assertTrue(min(counts.values()) >= len(KEYS) - 2, counts)
        for shell in SHELLS:
            ran = subprocess.run(
                shell, input=printed, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env={"PATH": tools},
                cwd=around.directory("shell"), executable=shutil.which(shell[0]))
            # two long names in one word
            said = [line for line in ran.stderr.splitlines() if b"rgument list too long" not in line]
            self.assertEqual((ran.stdout, said), (b"", []), shell)
        self.assertEqual(canaries(), [])

    def test_3_nothing_harmful_is_printed(self):
        chosen = cases()
        gentle = running.together(Case.run, [case for case in chosen if case.command not in FATAL])
        self.check(gentle)
        print("figures: %d command lines about %d kinds of hostile text, %d of them on a terminal"
              % (len(chosen), len(KEYS), sum(case.on_terminal for case in chosen)))

    def test_4_completions_are_single_words(self):
        for line in ("rtcat %s/" % server, "rtcat %s/test.host_cxt/" % server,
                     "rtconf %s set " % text.shell_word(str(component("quotes")))):
            ran = running.run(["rtcwd", "--shell=bash", "--line=" + line, "--word="], around.top)
            answers = [each for each in ran.out.decode().splitlines() if len(each) < 60000]
            self.assertTrue(answers, line)
            for shell in SHELLS:
                for answer in answers:
                    said = subprocess.run(
                        shell + ["-c", "set -- %s; echo $#" % answer],
                        stdout=subprocess.PIPE,
                        stderr=subprocess.PIPE,
                        cwd=around.directory("shell"),
                    )
                    self.assertEqual((said.stdout, said.stderr), (b"1\n", b""), answer)
        self.assertEqual(canaries(), [])

    def test_5_what_changes_the_world(self):
        self.check(running.together(Case.run, [case for case in cases() if case.command in FATAL]))


if __name__ == "__main__":
    unittest.main()
