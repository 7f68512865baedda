"""A scenario: what is in a world, what goes wrong, and what people do, drawn from a seed as plain lists, so
that parts can be left out to find the smallest that fails.
"""

import json
import os
import random
import re
import shutil
import tempfile

import components
import faults
import kept
import mounted
import oracles
import processes
import robot as robots
import users
import world as worlds

from rtshell_lite import errors
from rtshell_lite.net import real

PATIENCE = 20.0  # virtual seconds for all to be started
A_KEEPER = 0.1  # of the worlds have an rtkeep that stays
PROCESSES = 0.1  # of the worlds have an rtkeep that keeps processes, and people who steer it
A_MOUNT = 0.1  # of the worlds have an rtmount, and people who use the tree
BY_HAND = 0.5  # of those have one person who changes one thing, and no fault
ANSWERED = 0.4  # of the faults are answered by somebody
WRITING = ("rtlog", "rtcryo")
OF_DISKS = ("fill_disk", "break_disk", "lose_power", "lose_power_in_writing")
SPECIAL = ("composite", "provider", "machine")
A_SPECIAL = 0.15  # of the worlds have one of each
WITH_NAMES = 0.3  # of the worlds have hosts that are called by their names
AMBIGUOUS = 0.5  # of those names lead to an address, too, at which nobody listens
LAST = 400.0  # virtual seconds until all commands must have ended, whatever they promise


class Scenario:
    """hosts      names of hosts; the first has the name server
    seat       the host on which commands are typed
    processes  [(name, host, flavour, [components])]
    special    {name of a component: (which of components.SPECS, its members)}
    named      {host whose processes give its name: whether that leads to another address, too}
    connections, active
    faults     [(when, name of the fault, what it concerns)], seconds from the set-up's end
    commands   [(when, words, seconds until a signal, or None, the number of that)]
    kept       processes of a Procfile, as processes.draw returns them
    """

    special = {}  # type: dict
    named = {}  # type: dict
    kept = []  # type: list

    def __init__(self, seed, only=()):
        draw = random.Random(seed)
        self.seed = seed
        self.hosts = ["robot", "arm", "base"][: draw.choice((1, 1, 2, 3))]
        self.seat = draw.choice(self.hosts + ["desk", "desk"])
        self.processes = []
        names = []
        for number in range(draw.choice((1, 2, 2, 3, 4, 6))):
            members = []
            for _ in range(draw.choice((1, 1, 2, 3, 5))):
                members.append(f"C{len(names)}")
                names.append(members[-1])
            place = draw.choice(self.hosts), draw.choice(sorted(components.FLAVOURS))
            self.processes.append((f"p{number}", *place, members))
        targets = draw.choice([names, names, draw.choice(self.processes)[-1]])  # all of one process, perhaps
        pairs = {(draw.choice(names), draw.choice(targets)) for _ in range(draw.randrange(2 * len(names)))}
        self.connections = sorted(pair for pair in pairs if pair[0] != pair[1])
        self._draw_special(random.Random(f"{seed} special"), len(names))
        self._draw_names(random.Random(f"{seed} names"))
        self.active = sorted(draw.choice(([], names + list(self.special))))
        managers = {
            name: members
            for name, _, flavour, members in self.processes
            if components.FLAVOURS[flavour].creates_here
        }
        self.faults = []
        self.commands = []
        for _ in range(draw.choice((0, 1, 1, 1, 2, 3))):
            self._draw_fault(draw, names, only)
        for _ in range(draw.choice((1, 2, 3, 5))):
            interrupted = draw.random() * 2 if draw.random() < 0.15 else None
            words = users.draw(draw, names, managers, self.special, only)
            number = draw.choice(sorted(users.SIGNALS))
            when = round(draw.random() * 6, 3)
            if words:
                self.commands.append((when, words, interrupted, number))
        if draw.random() < A_KEEPER and (not only or "rtkeep" in only):
            self._draw_keeper(draw, names)
        if "rtmount" in only:
            self._draw_mount(random.Random(f"{seed} mount"), names)
        elif not only:
            self._draw_mount(random.Random(f"{seed} mount"), names, A_MOUNT)
        if "processes" in only:
            self._draw_processes(random.Random(f"{seed} processes"))
        elif not only:
            self._draw_processes(random.Random(f"{seed} processes"), PROCESSES)
        writing = [when for when, words, *_ in self.commands if words.split()[0] in WRITING]
        if writing and draw.random() < 0.4:
            when = round(draw.choice(writing) + draw.random() * 2.5, 3)
            self.faults.append((when, draw.choice(OF_DISKS), self.seat))
        self.faults.sort()
        self.commands.sort(key=lambda each: each[0])

    def _draw_special(self, draw, count):
        """Components of other kinds, each in a process that there is."""
        self.special = {}
        for kind in SPECIAL:
            if draw.random() < A_SPECIAL:
                *_, members = draw.choice(self.processes)
                name = f"C{count + len(self.special)}"
                taken = {each for _, those in self.special.values() for each in those}
                free = [each for each in members if each not in taken and each not in self.special]
                self.special[name] = kind, free[:2] if kind == "composite" else []
                members.append(name)

    def _draw_names(self, draw):
        """Hosts that are called by their names."""
        self.named = {}
        if draw.random() < WITH_NAMES:
            wanted = draw.sample(self.hosts, draw.randint(1, len(self.hosts)))
            self.named = {name: draw.random() < AMBIGUOUS for name in sorted(wanted)}

    def _draw_fault(self, draw, names, only):
        """A fault, and perhaps what somebody types who sees it."""
        name = draw.choice(sorted(faults.BY_NAME))
        fault = faults.BY_NAME[name]
        kind, _ = faults.FAULTS[fault]
        whom = draw.choice(
            {
                "process": [process for process, *_ in self.processes],
                "component": names,
                "host": self.hosts,
                "names": [""],
                "seat": [self.seat],
            }[kind]
        )
        when = round(draw.random() * 3, 3)
        self.faults.append((when, name, whom))
        if fault in faults.ANSWERS and draw.random() < ANSWERED:
            words = draw.choice(faults.ANSWERS[fault])
            if not only or words.split()[0] in only:
                later = round(when + 0.1 + draw.random() * 2, 3)
                concerned = {name: members for name, *_, members in self.processes}.get(whom, [whom])
                self.commands.append((later, words.format(draw.choice(concerned)), None, None))

    def _draw_keeper(self, draw, names):
        """An rtkeep that stays, and perhaps a person beside it."""
        words = users.draw_keeper(draw)
        number = draw.choice(sorted(users.SIGNALS))
        if draw.random() < BY_HAND:
            self.faults = []
            self.commands = [each for each in self.commands if each[1].split()[0] in oracles.LOOKING]
            when = round(3 + oracles.QUICK + draw.random() * 5, 3)
            self.commands.append((when, users.draw_by_hand(draw, names), None, None))
        self.commands.append((round(draw.random() * 3, 3), words, users.KEPT, number))

    def _draw_mount(self, draw, names, share=1.0):
        """An rtmount in a share of the worlds, and people who use the tree."""
        if draw.random() > share:
            return
        only_reads = any(words.startswith("rtkeep") for _, words, *_ in self.commands)
        begin = round(draw.random() * 2, 3)
        end = mounted.KEPT * (1 + draw.random() / 2)
        self.commands.append((begin, mounted.draw_server(draw), end, draw.choice(sorted(users.SIGNALS))))
        for _ in range(draw.randrange(2, 9)):
            when = round(begin + draw.random() * mounted.KEPT, 3)
            words, interrupted, times = mounted.draw(draw, names, self.special, only_reads)
            for number in range(times):
                self.commands.append((when + number * mounted.PAUSE, words, interrupted, real.SIGINT))
        for when, fault, whom in self.faults:
            if draw.random() < mounted.ANSWERED:
                members = {name: members for name, *_, members in self.processes}.get(whom, [])
                words = mounted.draw_answer(draw, members or [whom] * (whom in names))
                self.commands.append((max(when, begin) + draw.random() * 3, words, None, None))

    def _draw_processes(self, draw, share=1.0):
        """Processes that an rtkeep starts, in a share of the worlds, and people who steer it."""
        if draw.random() > share:
            return
        self.kept = processes.draw(draw)
        begin = round(draw.random() * 2, 3)
        seconds = round(processes.KEPT * (1 + draw.random()), 3)
        words = processes.draw_keeper(draw)
        number = draw.choice((real.SIGINT, real.SIGTERM, real.SIGTERM, real.SIGKILL))
        self.commands.append((begin, words, seconds, number))
        for _ in range(draw.choice((0, 1, 2, 4))):
            when = round(begin + draw.random() * seconds, 3)
            self.faults.append((when, *processes.draw_fault(draw, self.kept)))
        for fault in processes.draw_by_hand(draw, self.kept):
            self.faults.append((round(draw.random() * (begin + seconds), 3), *fault))
        for _ in range(draw.choice((0, 0, 1, 2, 4))):
            when = round(begin + draw.random() * seconds, 3)
            self.commands.append((when, processes.draw_steering(draw, self.kept), None, None))
        if "--log" in words and draw.random() < processes.DISK:
            self.faults.append((begin + 1, draw.choice(("fill_disk", "break_disk")), self.seat))

    def play(self):
        """Let it happen. Returns the Play."""
        return Play(self)

    # ---- to keep it ----

    def text(self):
        """It as one line, which means the same when seeds mean something else."""
        return json.dumps(vars(self), sort_keys=True)

    @classmethod
    def read(cls, text):
        """The Scenario of such a line."""
        made = cls.__new__(cls)
        vars(made).update(json.loads(text))
        return made

    # ---- to make it smaller ----

    def smaller(self):
        """Scenarios with one part less."""
        for part in ("commands", "faults", "connections", "active", "processes", "kept"):
            whole = getattr(self, part)
            for number in range(len(whole)):
                less = self._with(part, whole[:number] + whole[number + 1 :])
                if less.processes and less.commands:
                    yield less

    def _with(self, part, value):
        made = self.read(self.text())
        setattr(made, part, value)
        names = {each for *_, members in made.processes for each in members}
        processes = {each for each, *_ in made.processes}
        made.special = {name: made.special[name] for name in made.special if name in names}
        for _, members in made.special.values():
            members[:] = [each for each in members if each in names]
        made.kept = _without_lost(made.kept)
        made.connections = [pair for pair in made.connections if names.issuperset(pair)]
        made.active = [name for name in made.active if name in names]
        known = names | processes | set(made.hosts) | {"", made.seat}
        made.faults = [each for each in made.faults if each[2] in known or _is_of(each[2], made.kept)]
        lost = {each for *_, members in self.processes for each in members} - names
        lost |= {each for each, *_ in self.kept} - {each for each, *_ in made.kept}
        made.commands = [
            each for each in made.commands if lost.isdisjoint(re.findall(r"\b[Ck]\d+", each[1]))
        ]
        return made


def _is_of(whom, kept):
    """Whether a fault concerns one of these processes, or what a person has started in its place."""
    return whom.partition(" ")[0] in {name for name, *_ in kept}


def _without_lost(kept):
    """Kept processes, each after those alone that are there."""
    made = []
    for name, words, keys in kept:
        after = [each for each in keys.get("after", "").split() if each in {other for other, *_ in made}]
        keys = {key: value for key, value in keys.items() if key != "after"}
        made.append((name, words, dict(keys, after=" ".join(after)) if after else keys))
    return made


class Play:
    """A Scenario that is played: its `world`, `robot`, `commands` (users.Command), `failures` [(name of the
    oracle, words)].
    """

    def __init__(self, scenario):
        self.scenario = scenario
        self.world = world = worlds.World(scenario.seed)
        self.commands = []
        self.failures = []
        for number, name in enumerate(scenario.hosts + ["desk"], 1):
            host = world.host(name, f"10.0.0.{number}")
            if scenario.named.get(name):
                host.other_address = f"10.0.1.{number}"
        place = tempfile.mkdtemp(dir=os.curdir)
        os.chdir(place)
        try:
            self.robot = robots.Robot(world, world.hosts[scenario.hosts[0]], scenario.special, scenario.named)
            for name, host, flavour, members in scenario.processes:
                self.robot.start(name, world.hosts[host], flavour, members)
            count = sum(len(members) for *_, members in scenario.processes)
            world.run(PATIENCE, lambda: self.robot.count_bound() >= count)
            if self.robot.count_bound() < count:
                self.failures.append(("ends", "the robot does not start"))
                return
            self.robot.set_up(scenario.connections, scenario.active)
            self._save()
            if scenario.kept:
                processes.write(self.robot, world.hosts[scenario.seat], scenario.kept)
            os.mkdir(mounted.TREE)
            with open("service.idl", "w") as file:
                file.write(users.IDL)
            self._act()
            oracles.judge(self)
        except (worlds.Stuck, errors.Error) as e:
            self.failures.append(("ends", str(e)))
        finally:
            world.end()
            os.chdir(os.pardir)
            shutil.rmtree(place)

    def _save(self):
        saved = users.Command(self.robot, self.robot.home, f"rtcryo -y --all -o {users.FILE}")
        self.world.run(self.world.time + PATIENCE, lambda: saved.is_over)
        if saved.status != 0:
            self.failures.append(("stable", f"the robot is not saved: {saved.error}"))

    def _act(self):
        world = self.world
        seat = world.hosts[self.scenario.seat]
        self.before = self.robot.connectors()
        begin = self.begin = world.time
        for when, name, whom in self.scenario.faults:
            world.at(when, self._break, name, whom)
        for when, *typed in self.scenario.commands:
            world.at(when, self._type, seat, *typed)
        total = len(self.scenario.commands)
        world.run(begin + LAST, lambda: len(self.commands) == total and self._are_over())
        if self.scenario.kept:  # the kernel ends what is left
            world.run(world.time + kept.LEFT)

    def _are_over(self):
        return all(command.is_over for command in self.commands)

    def _break(self, name, whom):
        if name in faults.BY_NAME and _is_of(whom, self.scenario.kept) and whom not in self.robot.programs:
            return  # it has not been started
        if name in faults.HARMLESS:
            self.world.tell(f"{name} {whom}")
        else:
            self.robot.trouble(f"{name} {whom}")
        faults.named(name)(self.robot, whom)

    def _type(self, seat, *typed):
        self.commands.append(users.Command(self.robot, seat, *typed))
