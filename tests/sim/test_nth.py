"""The n-th call fails, for every n, of every command that makes several: its report must be true.

If this fails, an operator reads that a connection or a state is there which is not, or the other way round.
"""

import contextlib
import gc
import io
import json
import os
import re
import shutil
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import stories  # noqa: E402: the path first
import world as worlds  # noqa: E402
from test_starting import TARGET  # noqa: E402

from rtshell_lite import cli, notes  # noqa: E402

ONCE = "what is reported does not depend on the Python"
TIMEOUT = 0.8  # seconds
LONGEST = 60.0  # seconds of the world, in which each of them ends
COLLECTED = 50  # cases, of which the garbage is collected at once
# of so many of 2,000 cases one is tried, another one by another seed; with --long all. It has no factor in
# common with the numbers of kinds, as each of these follows the others
EACH = 5
SEED = int(os.environ.get("RTSHELL_SEED", "1"))
IS_THOROUGH = bool(os.environ.get("RTSHELL_FAULTS"))
SETTINGS = [
    ("world", "these ConsoleIn"),
    ("world", "these ConsoleOut ConfigSample"),
    ("world", "manager Motor --flavour cpp2"),
]
IN, OUT, MANAGER, SLAVE = "these", "these2", "manager", "manager.1"
KINDS = ("TRANSIENT", "COMM_FAILURE", "UNKNOWN", "HANG", "LOST", "DIE")
NAMES = "names"  # the process of the name server
# of its calls: the connection is lost before, after the call; no answer any more; the process ends
KINDS_OF_NAMES = ("CUT", "LOST", "HANG", "GONE")
A, B = "/robot/test.host_cxt/ConsoleIn0.rtc", "/robot/test.host_cxt/ConsoleOut0.rtc"
UNSURE = (
    "not known",
    "no answer",
    "connection lost",
    "connection refused",
    "cannot be reached",
    "does not activate",
    "not connected",
)


class NthCall:
    """Counts the calls of commands to a program; the `nth` ends in some way."""

    def __init__(self, program, nth=None, kind=None):
        self.count = 0
        self._program = program
        self._nth = nth
        self._kind = kind
        program.strikes = self.strike

    def strike(self, socket, octets):
        begun = [kind for kind, *_ in worlds.Scan().messages(octets)].count(worlds.REQUEST)
        if not socket.peer.program.name.startswith("rt"):
            return False
        before = self.count
        self.count += begun
        if self._nth is None or not before < self._nth <= self.count:
            return False
        if self._kind == "LOST":
            self._program.spoil = self._lose
        elif self._kind == "HANG":
            self._program.stop()
        elif self._kind == "GONE":
            self._program.kill()
        else:
            socket.close()
        return self._kind in ("CUT", "GONE")

    def _lose(self, octets):
        self._program.spoil = None
        return b""


class Robot:
    """A new robot, the truth about it (None where nobody knows it), and what commands say."""

    def __init__(self):
        self.player = stories.Player(SETTINGS)
        self.programs = self.player.robot.programs
        self.stages = self.player.robot.stages

    def prepare(self, scenario):
        for line in scenario.before:
            self.player.play(line)
        for name in list(self.stages):
            if not self.programs[name].is_over:
                self.player.play(f"ctl @{name} reset")

    def run(self, line):
        """Type a command; it has ended then."""
        words = line.split()
        environment = dict(self.player.environment, RTSHELL_TIMEOUT=str(TIMEOUT))
        command = stories.Command(self.player.seat, words, environment, 0.0)
        here = self.player.world
        here.run(here.time + LONGEST, lambda: command.program.is_over)
        return command.program

    def slaves(self):
        """The Stages of the slaves of the manager that live: it starts another one where the first fails."""
        return [
            stage
            for name, stage in self.stages.items()
            if name.startswith(MANAGER + ".") and not self.programs[name].is_over
        ]

    def component(self, process, name):
        """The mock of a process that lives, or None."""
        return None if self.programs[process].is_over else self.stages[process].components[name]

    def is_connected(self):
        """None, True, False or "half"."""
        ends = [self.component(IN, "ConsoleIn0"), self.component(OUT, "ConsoleOut0")]
        if None in ends:
            return None
        there, here = [set(end.port(name).profiles) for end, name in zip(ends, ("out", "in"))]
        return "half" if there != here else bool(here)

    def is_active(self, process, name):
        if self.programs[process].is_over:
            return None
        return self.player.play(f"ctl @{process} state {name}") == ["ACTIVE"]


class Scenario:
    """A command line; `before` are those that prepare it, and truth(robot) gives {path or what: whether it is
    as the command wants it}.
    """

    def __init__(self, line, truth, before=()):
        self.line = line
        self.truth = truth
        self.before = before


def states(wanted):
    def truth(robot):
        found = {A: robot.is_active(IN, "ConsoleIn0"), B: robot.is_active(OUT, "ConsoleOut0")}
        return {path: None if state is None else state == wanted for path, state in found.items()}

    return truth


def connection(wanted):
    def truth(robot):
        found = robot.is_connected()
        return {"connection": found if found in (None, "half") else found == wanted}

    return truth


def ended(robot):
    return {
        path: robot.programs[process].is_over or name not in robot.stages[process].components
        for path, process, name in ((A, IN, "ConsoleIn0"), (B, OUT, "ConsoleOut0"))
    }


def deleted(robot):
    gone = {name for _, name, _ in robot.player.robot.removed}
    return {path: path.rpartition("/")[2].partition(".")[0] in gone for path in OLD}


def there(name, wanted):
    """Whether the slave has a component, or not."""

    def truth(robot):
        slaves = robot.slaves()
        return {name: any(name in slave.components for slave in slaves) == wanted if slaves else None}

    return truth


def configured(*sets):
    """Whether parameters have their values in some sets of ConfigSample0."""

    def truth(robot):
        component = robot.component(OUT, "ConfigSample0")
        if component is None:
            return {"values": None}
        values = [component.configuration.sets[name] for name in sets]
        return {"values": all((each["int_param0"], each["str_param0"]) == ("77", "x") for each in values)}

    return truth


def composed(*wanted):
    """Whether the composite has these members, and ports of each."""

    def truth(robot):
        slaves = robot.slaves()
        composites = [slave.components["Arm"] for slave in slaves if "Arm" in slave.components]
        # in the place of a slave that has ended, or whose list does not come, the manager starts another one
        if robot.programs[SLAVE].is_over or len(composites) > 1:
            return {"members": None}
        if not composites:
            return {"members": False}
        (composite,) = composites
        members = {member.name for member in composite.organization.members}
        ports = {
            member.name
            for member in composite.organization.members
            for _, port in member.ports
            if port in composite.exported
        }
        return {"members": members == ports == set(wanted)}

    return truth


def rate(robot):
    component = robot.component(IN, "ConsoleIn0")
    return {"rate": None if component is None else component.owned[0].rate == 250.0}


OLD = tuple("/robot/old.host_cxt" + name for name in ("", "/z.rtc", "/sub.host_cxt", "/sub.host_cxt/x.rtc"))
LEFT_BEHIND = [
    "mock these ConsoleIn:x --context old.host_cxt/sub.host_cxt/%n.rtc",
    "mock these ConsoleIn:z --context old.host_cxt/%n.rtc",
    "kill these3",
    "kill these4",
]
PORTS = "ConsoleIn0.rtc:out ConsoleOut0.rtc:in"
PAIR = "ConsoleIn0.rtc ConsoleOut0.rtc"
NEW = "rtmgr -c Sensor?instance_name=New0 manager.mgr"
ARM = "rtcomp -a Motor0.rtc:in manager.mgr:Arm"
ARM_OF_TWO = "rtcomp -a ConsoleOut0.rtc:in manager.mgr:Arm"
MODE = ["rtconf ConfigSample0.rtc act mode1"]
SCENARIOS = [
    Scenario(f"rtcon {PORTS}", connection(True)),
    Scenario(f"rtdis {PORTS}", connection(False), [f"rtcon {PORTS}"]),
    Scenario("rtdis ConsoleIn0.rtc", connection(False), [f"rtcon {PORTS}"]),
    Scenario(f"rtact {PAIR}", states(True)),
    Scenario(f"rtact --wait=0.5 {PAIR}", states(True)),
    Scenario(f"rtdeact {PAIR}", states(False), [f"rtact --wait=3 {PAIR}"]),
    Scenario("rtresurrect --json system.xml", connection(True)),
    Scenario("rtteardown --json system.xml", connection(False), ["rtresurrect system.xml"]),
    Scenario("rtstart --json --wait=0.5 system.xml", states(True)),
    Scenario("rtstop --json --wait=0.5 system.xml", states(False), [f"rtact --wait=3 {PAIR}"]),
    Scenario(NEW, there("New0", True)),
    Scenario("rtmgr -d New0 manager.mgr", there("New0", False), [NEW]),
    Scenario("rtconf ConfigSample0.rtc set int_param0=77 str_param0=x", configured("mode1"), MODE),
    Scenario("rtconf ConfigSample0.rtc load changed", configured("mode0", "mode1"), MODE),
    Scenario(ARM, composed("Motor0")),
    Scenario(ARM_OF_TWO, composed("Motor0", "ConsoleOut0"), [ARM]),
    Scenario("rtcomp -r ConsoleOut0.rtc manager.mgr:Arm", composed("Motor0"), [ARM, ARM_OF_TWO]),
    Scenario(f"rtexit {PAIR}", ended),
    Scenario("rtdel -v --recursive /robot/old.host_cxt", deleted, LEFT_BEHIND),
    Scenario("rtec ConsoleIn0.rtc rate 250", rate),
]


class Case:
    """A scenario in which the `nth` call of an operation to a process ends in some way."""

    def __init__(self, scenario, process, operation, nth, kind):
        self.scenario = scenario
        self.process = process
        self.operation = operation
        self.nth = nth
        self.kind = kind

    def __str__(self):
        what = f"call {self.nth} of {self.operation} to {self.process}: {self.kind}"
        return f"{self.scenario.line}: {what}"

    def problems(self):
        """What is wrong with what the command says."""
        robot = Robot()
        try:
            robot.prepare(self.scenario)
            if self.process == NAMES:
                NthCall(robot.programs[NAMES], self.nth, self.kind)
            else:
                robot.player.play(f"ctl @{self.process} fail {self.operation} {self.nth} {self.kind}")
            program = robot.run(self.scenario.line)
            if not program.is_over:
                return ["it does not end"]
            if program.failure is not None:
                return [repr(program.failure)]
            self.status = program.status
            self.out = program.out.text()
            self.err = program.error.text()
            return list(self._untrue(self.scenario.truth(robot)))
        finally:
            robot.player.end()

    def _untrue(self, truth):
        if "Traceback" in self.err or "internal error" in self.err or self.status in (2, 70):
            yield "a bug"
        for what, is_so in truth.items():
            claimed = self._claimed(what)
            if is_so == "half":
                if claimed is not None:
                    yield "half connected"
            elif is_so is not None and claimed not in (is_so, None):
                yield f"{what}: claimed {claimed}, is {is_so}"
        if self.status == 0 and not self.err and not all(is_so in (True, None) for is_so in truth.values()):
            yield "done, it says"

    def _claimed(self, what):
        """What the command says became of it: True, False, or None where it is not sure."""
        name, *_ = self.scenario.line.split()
        lines = self.err.splitlines()
        if '"result"' in self.out:
            results = [
                json.loads(line)["result"]
                for line in self.out.splitlines()
                if what == "connection" and 'connect"' in line or f'"path": "{what}"' in line
            ]
            if "uncertain" in results or not results:
                return None
            return set(results) <= {"done", "already"}
        if name in ("rtstart", "rtstop") and "Executing" not in self.err:
            return False  # nothing is tried where not all can be asked before
        if name == "rtdel" and f"rtdel: {what}: deleted" in lines:
            return True
        if any(line.startswith(f"{name}: /robot: ") for line in lines):
            return None  # the name server: what it would have named is not known
        if name == "rtdel":
            return False
        about = [line for line in lines if what in line] if what[0] == "/" else lines if self.status else []
        if any(word in line for line in about for word in UNSURE):
            return None
        return not about


def counts(scenario):
    """[(process, operation, how many)] of the calls of a scenario where nothing fails."""
    robot = Robot()
    try:
        robot.prepare(scenario)
        names = NthCall(robot.programs[NAMES])
        program = robot.run(scenario.line)
        truth = scenario.truth(robot)
        assert program.status == 0 and all(truth.values()), (scenario.line, program.error.text(), truth)
        found = [(NAMES, "any", names.count)]
        for name in (IN, OUT, MANAGER, SLAVE):
            for line in robot.player.play(f"ctl @{name} calls"):
                count, operation = line.split()
                found.append((name, operation, int(count)))
        return found
    finally:
        robot.player.end()


def cases():
    for scenario in SCENARIOS:
        for process, operation, count in counts(scenario):
            for nth in range(1, count + 1):
                for kind in KINDS_OF_NAMES if process == NAMES else KINDS:
                    yield Case(scenario, process, operation, nth, kind)


def collect():
    """Collect the garbage of worlds that have ended, their files with it."""
    with contextlib.redirect_stderr(io.StringIO()):  # coroutines of what was killed complain
        gc.collect()


class Nth(unittest.TestCase):
    def setUp(self):
        notes.listener = cli._hear
        gc.disable()  # see `collect`
        self.addCleanup(gc.enable)
        self.addCleanup(os.chdir, os.getcwd())
        place = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, place)
        os.chdir(place)
        self.write_files()

    def write_files(self):
        """What commands are given: a system, and a changed configuration."""
        robot = Robot()
        try:
            for line in (f"rtcon -i straight {PORTS}", "rtcryo -o connected.xml /robot", *MODE):
                self.assertEqual([line for line in robot.player.play(line) if line[0] == "["], [])
            names = enumerate(("ConsoleIn0", "ConsoleOut0"))
            plan = [TARGET.format(number, name, name) for number, name in names]
            lines = []
            for kind in ("Activation", "Deactivation"):
                lines += [f"<rts:{kind}>", *plan, f"</rts:{kind}>"]
            robot.player.play("insert connected.xml system.xml", *lines)
            text = "\n".join(robot.player.play("rtconf ConfigSample0.rtc dump")) + "\n"
        finally:
            robot.player.end()
        for name, value in (("int_param0", "77"), ("str_param0", "x")):
            text = re.sub(f"(?m)^{name}=.*", f"{name}={value}", text)
        with open("changed", "w", encoding="utf-8") as file:
            file.write(text)

    def test_every_call_fails_once(self):
        everything = list(cases())
        tried = everything if IS_THOROUGH else everything[SEED % EACH :: EACH]
        print(f"figures: {len(tried)} of {len(everything)} faults in the middle of {len(SCENARIOS)} commands")
        for number, case in enumerate(tried):
            with self.subTest(str(case)):
                self.assertEqual(case.problems(), [], getattr(case, "err", ""))
            if not number % COLLECTED:
                collect()


if __name__ == "__main__":
    unittest.main()
