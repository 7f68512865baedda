#!/usr/bin/env python3
"""Play stories: transcripts (tests/support/transcripts.py) in the bottle, where a second costs nothing.

  python3 tests/sim/stories.py [--accept] [WORD …]     those of tests/sim/stories whose name has one of the words

A story begins with what is there, at the margin, and goes on with what people do, and what they see:

    hosts: robot arm desk              (`robot` alone, if it does not say) the first has the name server
    seat: desk                         where commands are typed (on the first host)
    world: many 15 --context a.host_cxt/%n.rtc
                                       a process of mocks, as in transcripts; `--host arm`: on that host

      $ RTSHELL_TIMEOUT=1 rtls -l      a command, what it prints on stdout, then on stderr, then its status and
      ?  -  -  -  -  ?Mock0.rtc        how long it took, in tenths of a second of the world, if it took any time
      ! rtls: 1 of 1 did not answer
      [4] after 1.0 s

A line `…` stands for any lines; one may end in (re) or (glob). Times since 1970 are shown as seconds since the
world began. What else is typed:

    rtwatch Mock0.rtc &         a command that goes on beside what follows; the next one is rtwatch2 until that ends
    show rtwatch                what it has printed since it began, or was shown
    wait rtwatch                the same, until it ends
    strike INT rtwatch          a signal
    stop rtwatch, wake rtwatch  it does nothing until then, as if its host were busy
    interrupt 0.5 rtls -l       a command, and Ctrl-C after 0.5 s; `terminate`: SIGTERM
    busy 0.5 rtls -l            a command that computes for 0.5 s before it asks anybody
    sleep 3
    hang many                   a fault of faults.py, and what it concerns: a process goes by the name of its
                                world (many, many2 …), a host by its own; `wake many` ends this one
    later 0.5 kill many         a fault that comes while what follows goes on
    ctl @many fail get_ports 1 HANG; calls @many Mock0
                                a mock is asked, or told, as in transcripts (one line each)
    mock these Mock:Late0       one more process
    cat FILE, ls a*.mcap
    insert ONE OTHER            write OTHER: what is in ONE, with the lines after `  > ` before its last one
    order ONE OTHER A0 B0 …     write OTHER: what is in ONE, and that each of these components starts after the one before
    extend ONE OTHER A0 KEY VALUE
                                write OTHER: what is in ONE, and an extended property of this component
    write FILE                  write a file: the lines after `  > `. In a Procfile, commands are `mock these Motor NAME`,
                                or programs of processes.py (`brief NAME 0.4 3`); NAME is that of the process
    NAME=VALUE                  in the environment of all that follows

There is no shell: a line has the words that shlex finds in it.
"""  # noqa: E501

import argparse
import contextlib
import gc
import glob
import io
import os
import re
import shlex
import shutil
import signal
import sys
import tempfile
import traceback

HERE = os.path.dirname(os.path.abspath(__file__))
TESTS = os.path.dirname(HERE)
STORIES = os.path.join(HERE, "stories")
SETTINGS = {"PYTHONHASHSEED": "0", "PYTHONIOENCODING": "utf-8", "RTSHELL_ORB": "builtin"}
SETTINGS.update(LC_ALL="C", TZ="UTC")
sys.path[:0] = [os.path.dirname(TESTS), HERE, os.path.join(TESTS, "support")]
if __name__ == "__main__" and os.environ.get("PYTHONHASHSEED") != "0":  # sets of texts have one order then
    os.environ.update(SETTINGS)
    os.execv(sys.executable, [sys.executable] + sys.argv)

import components  # noqa: E402: the path first
import faults  # noqa: E402
import processes  # noqa: E402
import robot as robots  # noqa: E402
import transcripts  # noqa: E402
import users  # noqa: E402
import world as worlds  # noqa: E402

from mock_components import __main__ as mocks, control, stage, worlds as casts  # noqa: E402

from rtshell_lite import cli, notes  # noqa: E402

SEED = 1
LONGEST = 400.0  # seconds of the world that a command may take
SETTING = re.compile(r"(hosts|seat|world): *(.*)$")
UUID = re.compile(r"\b[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}\b")
PORT = re.compile(r"(?<=:)4[0-9]{4}\b")  # which nobody has chosen
STAMP = re.compile(r"\b18000[0-9]{5}\.[0-9]+")  # seconds since 1970
ANYTHING = "…"
STATUS = re.compile(r"\[-?[0-9]+\]( after [0-9.]+ s)?$")
ASSIGNMENT = re.compile(r"[A-Z_]+=")
# of an RtsProfile: a component is started when another one is Active
AFTER = """\
<rts:targets rts:sequence="{number}">
<rts:Preceding rts:sendingTiming="SYNC" rts:timeout="0">
<rts:PrecedingComponents rts:componentId="{first}" rts:instanceName="{first}" rts:id="0"/>
</rts:Preceding>
<rts:TargetComponent rts:componentId="{then}" rts:instanceName="{then}" rts:id="0"/>
</rts:targets>"""


class Failed(Exception):
    """A story cannot go on."""


class Robot(robots.Robot):
    """Processes of mocks that play `worlds` of mock_components. `stages`: {name of a process: its Stage}"""

    def __init__(self, world, home):
        super().__init__(world, home, {})
        self.stages = {}
        processes.install(self)
        world.executables["mock"] = self._start_mock

    def _start_mock(self, home, *words):
        """Start a process of mocks, as rtkeep does: its last word is its name."""
        made = self.start(words[-1], home, mocks.arguments().parse_args(words[:-1]))
        processes.note(self, words[-1], made)
        return made

    def start_names(self):
        """As for other processes, faults know it by its name."""
        self.programs["names"] = started = super().start_names()
        return started

    def start_world(self, words):
        """Start a process that plays `many 15 …`, and wait until all of it is there. Returns its name."""
        given = mocks.arguments().parse_args(words)
        home = self.world.hosts.get(given.host, self.home)
        count = sum(name.startswith(given.world) for name in self.programs)
        name = given.world + (str(count + 1) if count else "")
        self.start(name, home, given)
        self._until_ready(name)
        return name

    def _until_ready(self, name):
        program = self.programs[name]
        self.world.run(self.world.time + LONGEST, lambda: name in self.stages or program.is_over)
        if name not in self.stages:
            raise Failed(f"{name} does not start: {program.failure}")

    def start(self, name, home, given):
        """Start a process with these arguments of mock_components, or start it again."""
        options = mocks.Options(**dict(vars(components.OPTIONS), context=given.context, rate=given.rate))

        def set_up(process):
            made = stage.Stage(
                process,
                components.Naming(process, self.server),
                components.of_bottle(given.flavour),
                options.but(sync=given.sync, robot=self),
            )
            casts.WORLDS[given.world](made, *given.arguments)
            process.ledger.reset()
            self.stages[name] = made

        self.stages.pop(name, None)
        self.programs[name] = worlds.Program(home, name, components.living(home.address, set_up))
        self.processes[name] = home, given
        return self.programs[name]

    def ask(self, name, function):
        """Have function(component) called for the component of that name. Raises Failed."""
        found = [each for each in self.stages.values() if name in each.components]
        if not found:
            raise Failed(f"no component {name}")
        self.do(found[0], function, found[0].components[name])

    def do(self, made, function, *args):
        """What function(*args) returns, called in the process of a Stage. Raises Failed."""
        strand = made.process.thread(lambda: strand.own.update(found=function(*args)))
        made.process.program.wake()
        self.world.run(self.world.time + LONGEST, lambda: strand.is_over)
        if not strand.is_over:
            raise Failed("the process does not answer")
        if strand.error is not None:
            raise Failed(f"it fails: {made.process.program.failure!r}")
        return strand.own.get("found")


class Command:
    """A command that was typed: `program`, what it has printed that was not shown."""

    def __init__(self, host, words, environment, work, output=None):
        name, *more = words
        self.program = worlds.Program(host, name, users.typed(name, more, work), more, environment, output)
        self._shown = [0, 0]

    def told(self):
        """The lines that it has printed since this was asked last: stdout, then stderr."""
        lines = []
        for number, (mark, output) in enumerate([("", self.program.out), ("! ", self.program.error)]):
            text = output.text()
            part = text[self._shown[number] :]
            self._shown[number] = len(text)
            lines += [mark + line for line in part.splitlines()]
        return lines

    def ended(self):
        """The line of its status and time, if there is something to say. Raises Failed."""
        program = self.program
        if program.failure is not None:
            raise program.failure
        took = f"{program.ended - program.begun:.1f}"
        if program.status or took != "0.0":
            yield f"[{program.status}]" + (f" after {took} s" if took != "0.0" else "")


class Player:
    """Plays the lines of one story; each `do_WORD` yields the lines that one of them shows."""

    def __init__(self, settings):
        self.world = world = worlds.World(SEED)
        names = dict(settings).get("hosts", "robot").split()
        for number, name in enumerate(names, 1):
            world.host(name, f"10.0.0.{number}")
        self.seat = world.hosts[dict(settings).get("seat", names[0])]
        self.robot = Robot(world, world.hosts[names[0]])
        self.environment = {
            "RTCTREE_NAMESERVERS": names[0],
            "RTCSH_CWD": f"/{names[0]}/test.host_cxt",
            "RTSHELL_ORB": "builtin",
            "XDG_RUNTIME_DIR": os.getcwd(),
        }
        self.commands = {}  # {name: Command} of those that go on: rtls, rtls2 …
        for words in [words for kind, words in settings if kind == "world"]:
            self.robot.start_world(shlex.split(words))

    def play(self, line, *more_lines):
        """The lines that are seen after a line was typed, and those that it goes on in. Raises Failed."""
        words = shlex.split(line)
        words += more_lines
        environment = dict(self.environment)
        while words and ASSIGNMENT.match(words[0]):
            name, _, value = words.pop(0).partition("=")
            environment[name] = value
        if not words:
            self.environment = environment
            return []
        word, *more = words
        if word.startswith("rt"):
            return list(self._run(words, environment))
        if word in faults.BY_NAME:
            return list(self._break(word, *more))
        do = getattr(self, "do_" + word, None)
        if do is None:
            raise Failed(f"nobody knows how to {word}")
        return list(do(*more))

    # ---- commands ----

    def _run(self, words, environment, struck=None, number=signal.SIGINT, work=0.0):
        """`struck`: the seconds until a signal; `work`: those that it computes at first."""
        goes_on = words[-1] == "&"
        command = Command(self.seat, words[: len(words) - goes_on], environment, work)
        if struck is not None:
            self.world.at(struck, command.program.strike, number)
        if not goes_on:
            return self._end(command)
        name = words[0]
        count = 1
        while name in self.commands:
            count += 1
            name = f"{words[0]}{count}"
        self.commands[name] = command
        return ()

    def do_interrupt(self, seconds, *words):
        return self._run(words, self.environment, float(seconds))

    def do_terminate(self, seconds, *words):
        return self._run(words, self.environment, float(seconds), signal.SIGTERM)

    def do_busy(self, seconds, *words):
        return self._run(words, self.environment, work=float(seconds))

    def do_wait(self, name):
        return self._end(self.commands.pop(name))

    def _end(self, command):
        """Wait for the end of a command."""
        self.world.run(self.world.time + LONGEST, lambda: command.program.is_over)
        yield from command.told()
        if not command.program.is_over:
            raise Failed(f"{command.program.name} has not ended after {LONGEST:.0f} s")
        yield from command.ended()

    def do_show(self, name):
        return self.commands[name].told()

    def do_strike(self, number, name):
        self.commands[name].program.strike(getattr(signal, "SIG" + number))
        return ()

    # ---- the world ----

    def do_sleep(self, seconds):
        self.world.run(self.world.time + float(seconds))
        return ()

    def _break(self, fault, *whom):
        faults.BY_NAME[fault](self.robot, *(whom or [""]))
        return ()

    def do_stop(self, name):
        self.commands[name].program.stop()
        return ()

    def do_wake(self, name):
        program = self.commands[name].program if name in self.commands else self.robot.programs[name]
        program.go_on()
        return ()

    def do_later(self, seconds, *words):
        self.world.at(float(seconds), self.play, " ".join(map(shlex.quote, words)))
        return ()

    def do_mock(self, *words):
        self.robot.start_world(words)
        return ()

    def do_ctl(self, *words):
        made = next(iter(self.robot.stages.values()))
        if words[0].startswith("@"):
            made = self.robot.stages[words[0][1:]]
            words = words[1:]
        return self.robot.do(made, getattr(control.Commands(made), words[0]), *words[1:]) or ()

    def do_calls(self, *words):
        count = bool(words and words[0].startswith("@"))
        return self.do_ctl(*words[:count], "calls", *words[count:])

    def do_cat(self, path):
        with open(path, encoding="utf-8") as file:
            return file.read().splitlines()

    def do_ls(self, pattern):
        return sorted(glob.glob(pattern))

    def do_insert(self, one, other, *lines):
        *before, last = self.do_cat(one)
        with open(other, "w", encoding="utf-8") as file:
            file.writelines(line + "\n" for line in (*before, *lines, last))
        return ()

    def do_order(self, one, other, *names):
        after = [
            AFTER.format(number=number, first=first, then=then)
            for number, (first, then) in enumerate(zip(names, names[1:]), 1)
        ]
        return self.do_insert(one, other, "<rts:Activation>", *after, "</rts:Activation>")

    def do_extend(self, one, other, name, key, value):
        lines = self.do_cat(one)
        begin = [f'rts:instanceName="{name}" rts:compositeType' in line for line in lines].index(True)
        end = lines.index("    </rts:Components>", begin)
        lines.insert(end, f'<rtsExt:Properties rtsExt:name="{key}" rtsExt:value="{value}"/>')
        return self.do_write(other, *lines)

    def do_write(self, path, *lines):
        with open(path, "w", encoding="utf-8") as file:
            file.writelines(line + "\n" for line in lines)
        return ()

    def end(self):
        """End the world. Raises what a process of mocks has failed by."""
        failures = [each.failure for each in self.robot.programs.values() if each.failure]
        self.world.end()
        if failures:
            raise failures[0]


# ---- telling ----


def spell(line):
    """A line as a story shows it."""
    line = PORT.sub("$PORT", UUID.sub("$UUID", line))
    line = STAMP.sub(lambda found: f"{float(found.group()) - worlds.BEGIN:.1f}", line)
    if line.isprintable() and line.rstrip() == line:
        return line
    return transcripts.spell(line.encode("utf-8", "surrogateescape"), [])


def abridge(expected, actual):
    """The actual lines, with `…` for those for which that stands among the expected ones, but the status."""
    (wanted, _), (seen, status) = _parted(expected), _parted(actual)
    return _abridged(wanted, seen) + status


def _parted(lines):
    """(output, [the line of its status, if it has one])"""
    count = len(lines) - bool(lines and STATUS.match(lines[-1]))
    return lines[:count], lines[count:]


def _abridged(wanted, seen):
    """Each `…` stands for as few lines as it can; the last one, at the end, for all."""
    chunks = [[]]
    for line in wanted:
        if line == ANYTHING:
            chunks.append([])
        else:
            chunks[-1].append(line)
    first, *later = chunks
    if not later:
        return transcripts.merge(first, seen)
    found = transcripts.merge(first, seen[: len(first)])
    at = len(first)
    for chunk in later:
        begins = range(at, len(seen) - len(chunk) + 1)
        if chunk is later[-1]:
            begins = begins[-1:]
        fits = [begin for begin in begins if _fits(chunk, seen[begin:])]
        if not fits:
            return found + seen[at:]
        found += [ANYTHING] + chunk
        at = fits[0] + len(chunk)
    return found


def _fits(chunk, seen):
    return all(map(transcripts.matches, chunk, seen))


def play(path, accept=False):
    """What differs from a story, "" if nothing does."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    items = transcripts.parse(text)
    steps = transcripts.steps(items)
    prose = [item for item in items if not isinstance(item, transcripts.Step)]
    settings = [found.groups() for found in map(SETTING.match, prose) if found]
    outputs = []
    problem = None
    place = tempfile.mkdtemp(prefix="story-")
    os.chdir(place)
    try:
        player = Player(settings)
        for step in steps:
            shown = map(spell, player.play(*step.command))
            outputs.append(abridge(step.expected, list(shown)))
        player.end()
    except Exception as e:
        problem = str(e) if isinstance(e, Failed) else traceback.format_exc()
    finally:
        os.chdir(HERE)
        shutil.rmtree(place)
    return transcripts.judge(path, text, items, outputs, problem, accept)[1]


def paths(words=()):
    """The stories whose name has one of the words; all of them if there is none."""
    names = sorted(name for name in os.listdir(STORIES) if name.endswith(".t"))
    return [os.path.join(STORIES, name) for name in names if any(word in name for word in words or [""])]


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--accept", action="store_true", help="take what is seen now as what is expected")
    parser.add_argument("words", nargs="*", metavar="WORD")
    args = parser.parse_args()
    notes.listener = cli._hear
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)  # what commands read that are given no file
    failed = False
    gc.disable()
    for path in paths(args.words):
        difference = play(path, args.accept)
        with contextlib.redirect_stderr(io.StringIO()):  # coroutines of what was killed complain
            gc.collect()
        failed = failed or bool(difference)
        print(difference or f"ok {os.path.basename(path)}")
    sys.stdout.flush()
    os._exit(1 if failed else 0)  # threads of what was killed wait for ever


if __name__ == "__main__":
    main()
