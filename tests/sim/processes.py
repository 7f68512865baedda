"""Processes that a simulated rtkeep starts and keeps: its Procfile, the programs that it names, and what
people do beside it.
"""

import functools

import children
import faults
import world as worlds

from rtshell_lite.net import real

FILE = "robot.procs"
KEEPER = f"rtkeep --json --processes {FILE}"
KEPT = 8.0  # seconds, and up to as many more, that it runs
FLAVOURS = ("cpp12", "cpp2", "py2")
KINDS = ("part", "part", "brief", "mute", "talker", "stubborn", "family", "missing")
HAS_READY = ("part", "mute")
STEERED = ("stop", "pause", "resume")
A_PERSON = 0.5  # of the worlds have one who starts a process that is to be kept
DISK = 0.3  # of the worlds with logs have a disk that fails
OFTEN = 1.0  # seconds between what a talker prints
GARBAGE = b"\xff\0\x1b[31m" + b"x" * 5000 + b"\n\r\nhalf a line"
SAID = "as brief as I am"
LONG = 1e6  # seconds: until it is ended


def draw(draw):
    """[(name, words of its command, {key: value}) of each process], as a Procfile has it; `ready` is the name
    of a component.
    """
    made = []
    for number in range(draw.randint(1, 5)):
        kind = draw.choice(KINDS)
        words = [kind, f"k{number}"]
        keys = {}
        if kind == "part":
            words += [draw.choice(FLAVOURS), f"K{number}"]
        elif kind == "brief":
            words += [str(draw.choice((0, 0.01, 0.4, 2))), str(draw.choice((0, 3)))]
        elif kind == "family":
            words.append(str(draw.choice((0.5, 3, 1000))))
        if kind in HAS_READY:
            keys["ready"] = f"K{number}"
        if number and draw.random() < 0.4:
            keys["after"] = " ".join(sorted({f"k{draw.randrange(number)}" for _ in range(2)}))
        for key, values in (
            ("restart", ("always", "on-error", "no")),
            ("burst", ("1/60", "3/60")),
            ("delay", ("0.1-0.1", "0.2-1", "1-4")),
            ("stop", ("INT 1", "TERM 0.5", "TERM 2", "KILL 1")),
        ):
            if draw.random() < 0.5:
                keys[key] = draw.choice(values)
        made.append((f"k{number}", words, keys))
    return made


def draw_keeper(draw):
    """The words of an rtkeep that keeps them."""
    return KEEPER + draw.choice(("", " -v", " --log .", " -v --log ."))


def draw_fault(draw, kept):
    """(name of a fault, the process that it concerns)"""
    name, words, _ = draw.choice(kept)
    if words[0] == "part":
        return draw.choice(("kill", "kill", "hang", "pause", "lag")), name
    return draw.choice(("kill", "kill", "hang")), name


def draw_by_hand(draw, kept):
    """[(name of a fault, what it concerns)] of those who start one themselves, and what becomes of that."""
    parts = [name for name, words, _ in kept if words[0] == "part"]
    if not parts or draw.random() > A_PERSON:
        return []
    name = draw.choice(parts)
    more = draw.choice(((), ("hang",), ("hang", "kill"), ("kill",), ("pause",)))
    return [("start_by_hand", name), *((fault, name + faults.BY_HAND) for fault in more), ("kill", name)]


def draw_steering(draw, kept):
    """The words of somebody who asks or steers it."""
    name, *_ = draw.choice(kept)
    lines = [f"rtkeep {verb} --of {FILE} {name}" for verb in STEERED]
    lines += ["rtkeep status", f"rtkeep reload --of {FILE}", f"rtkeep stop --of {FILE}"]
    return draw.choice(lines)


def write(robot, host, kept):
    """Write the Procfile, and have its programs be there, on this host."""
    with open(FILE, "w") as file:
        for name, words, keys in kept:
            file.write(f"{name}: {' '.join(words)}\n")
            if words[0] == "part":
                robot.kept[name] = host, *words[2:]
            for key, value in keys.items():
                file.write(f"{name}.{key}: {robot.path(value) if key == 'ready' else value}\n")
    install(robot)


def install(robot):
    """Have the programs of Procfiles be there."""
    for kind in set(KINDS) - {"missing"}:
        robot.world.executables[kind] = functools.partial(_start, robot, kind)


def _start(robot, kind, host, name, *more):
    if kind == "part":
        flavour, component = more
        made = robot.start(name, host, flavour, [component])
    else:
        made = robot.programs[name] = Plain(robot, host, name, kind, more)
    note(robot, name, made)
    return made


def note(robot, name, program):
    """A process of this name has begun, as a Program."""
    robot.runs.setdefault(name, []).append(program)
    robot.world.tell(f"{name} begins")


class Plain(worlds.Program):
    """A program that has no components."""

    def __init__(self, robot, host, name, kind, words=()):
        self._robot = robot
        super().__init__(host, name, lambda: getattr(self, "_" + kind)(*words))
        if kind in ("stubborn", "child"):
            self.ignores = (real.SIGTERM, real.SIGINT)

    def _sleep(self, seconds):
        end = self.world.time + seconds
        while self.world.time < end:
            self.wait(end - self.world.time)

    def _brief(self, seconds, status):
        print(SAID, file=self.out)
        self._sleep(float(seconds))
        return int(status)

    def _mute(self):
        self._sleep(LONG)

    _stubborn = _child = _mute

    def _talker(self):
        while True:
            self.out.write(GARBAGE)
            self._sleep(OFTEN)

    def _family(self, seconds):
        child = Plain(self._robot, self.host, f"child of {self.name}", "child")
        children.join(child, self)
        self._robot.families.append((self, child))
        return self._brief(seconds, "0")
