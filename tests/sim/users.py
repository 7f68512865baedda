"""People at a simulated robot: what they type, and the commands that run then, as on a robot."""

import os

import mounted
import recordings
import world as worlds

from rtshell_lite import cli
from rtshell_lite.net import loop, real
from rtshell_lite.shell import installation

TIMEOUT = 1.0  # seconds, of all commands
MADE = 100  # components that people may make in a process, which are C100, C101 … in the first one
KEPT = 30.0  # seconds that rtkeep keeps a system
FILE = "robot.rtsys"  # in which the robot was saved when all was well
# what can be done with components that are no ordinary parts: the name of one, of a member, of any component
OF_SPECIAL = {
    "composite": (
        "rtcat -l {}",
        "rtact --wait 3 {}",
        "rtdeact --wait 3 {}",
        "rtdeact --wait 3 {1}",
        "rtcomp -r {1} {0}",
        "rtcomp -a {2} {0}",
    ),
    "provider": (
        "rtcall {}",
        "rtcall --idl service.idl --limit 2 {}:svc echo hello",
        "rtcall --idl service.idl --limit 2 {}:svc get_value -r 10 -n 5",
        "rtcall --limit 2 {} get_sdo_id",
    ),
    "machine": ("rtfsm {} getstate", "rtfsm {} getstructure", "rtfsm {} geteventprofiles"),
}
IDL = """module SimpleService {
  typedef sequence<string> EchoList;
  typedef sequence<float> ValueList;
  interface MyService {
    string echo(in string msg);
    EchoList get_echo_history();
    void set_value(in float value);
    float get_value();
    ValueList get_value_history();
  };
};
"""
SIGNALS = {real.SIGINT: "Ctrl-C", real.SIGTERM: "SIGTERM"}
# with the names of components; `more`: another port; `number` of a file
LINES = (
    "rtls",
    "rtls -l",
    "rtls -R /",
    "rtls -lR",
    "rtcat {one}",
    "rtcat -l {one}",
    "rtfind . --type c",
    "rtdoctor -q",
    "rtact --wait 3 {one}",
    "rtdeact --wait 3 {one}",
    "rtreset --wait 3 {one}",
    "rtact {one} {other}",
    "rtdel -z .",
    "rtcon {one}:out {other}:in",
    "rtdis {one}:out",
    "rtdis {one}",
    "rtconf {one} list",
    "rtconf {one} set gain 5",
    "rtcryo -y .",
    "rtec {one}",
    "rtprint -n 3 -t 4 {one}:out",
    "rtprint --json -t 1 {one}:out{more}",
    "rtprint --pull -n 3 -t 3 {one}:out",
    f"rtcheck {FILE}",
    f"rtresurrect {FILE}",
    f"rtresurrect --rollback {FILE}",
    f"rtteardown {FILE}",
    f"rtstart {FILE}",
    f"rtstop {FILE}",
    f"rtdoctor -q --profile {FILE}",
    f"rtkeep --once --within 5 {FILE}",
    f"rtkeep --dry-run {FILE}",
    "rtkeep status",
    "rtwatch -t 3 {one}",
    "rtwatch -n 1 -t 4 -f RTC_STATUS {one} {other}",
    "rttop -n 2 -r 1",
    "rttop --json -n 2 -r 1",
    "rttop -n 1 -p {one}:out",
    f"rtcheck -s Inactive {FILE}",
    f"rtcheck --extra {FILE}",
    "rtcat -ll {one}",
    "rtcon -i made {one}:out {other}:in",
    f"rtstodot {FILE}",
    f"rtcryo -y -o {recordings.SAVED} .",
    "rtlog -t 1 -f run{number}.mcap {one}:out",
    "rtlog -t 1 -f run{number}.mcap .",
    "rtlog --pull -t 1 -f run{number}.mcap {one}:out",
    "rtlog -l text -t 1 -f run{number}.txt {one}:out",
    "rtdel -z {one}",
    f"rtkeep --create --once --within 5 {FILE}",
    "rtlog --ring 1 --after 0.5 --trigger error -t 2 -f run{number}.mcap .",
)
_modules = {}  # type: dict


def draw(draw, names, managers, special, only=()):
    """The words of a command line, drawn at random, or None where `only` forbids all; `managers`: {name:
    components in its process}; `special` as a Scenario has it.
    """
    one, other = draw.choice(names), draw.choice(names)
    more = f" {other}:out" if other != one else ""
    lines = [_filled(draw, line, one=one, other=other, more=more) for line in LINES]
    for manager, members in managers.items():
        made = f"C{MADE * (1 + int(manager[1:])) + draw.randrange(3)}"  # of two with one name, one loses it
        lines.append(f"rtmgr {manager}.mgr -c C?instance_name={made}")
        lines.append(f"rtmgr {manager}.mgr -d {draw.choice([made, *members])}")
        lines.append(f"rtcat {manager}.mgr")
    for name, (kind, members) in special.items():
        for line in OF_SPECIAL[kind]:
            lines.append(line.format(name, (members or [one])[0], one))
    wanted = [line for line in lines if not only or line.split()[0] in only]
    return draw.choice(wanted) if wanted else None


def _filled(draw, line, **words):
    """One of LINES with these words, and a number of its own where it has one."""
    if "{number}" in line:
        words["number"] = draw.randrange(10**6)
    return line.format(**words)


def draw_keeper(draw):
    """The words of an rtkeep that stays."""
    options = draw.choice(("--look 0.3", "--look 0.3 --strict", "--look 0.5", "--look 0.3 --create"))
    return f"rtkeep {options} {FILE}"


def draw_by_hand(draw, names):
    """The words of a command line of somebody who changes what an rtkeep keeps."""
    name = draw.choice(names)
    return draw.choice((f"rtdeact {name}", f"rtconf {name} set gain 5"))


class Command:
    """A command that somebody has typed on a host: `words`, as a line."""

    def __init__(self, robot, host, line, interrupted=None, number=real.SIGINT):
        """`interrupted`: seconds until a signal of this number, or None."""
        self.line = line
        self.name, *words = line.split()
        names = set(robot.lives)
        if self.name != "rtmgr":  # which knows components by their names alone
            words = [_spelt(word, names) for word in words]
        self.world = robot.world
        environment = {
            "RTCTREE_NAMESERVERS": robot.server,
            "RTCSH_CWD": f"/{robot.server}/robot.host_cxt",
            "RTSHELL_ORB": "builtin",
            "RTSHELL_TIMEOUT": str(TIMEOUT),
            "XDG_RUNTIME_DIR": os.getcwd(),
        }

        self._place = os.getcwd() + "/"  # another one each time
        self.begun = robot.world.time
        self.interrupted = None  # when
        robot.world.tell(f"$ {line}")
        self._out = self._error = None
        self.before = robot.connectors()
        self.connectors = {}  # of the robot, when it ends
        self.left = {}  # {name: its connectors with tools, and observers}, a little later, after a reader
        self.gains = {}  # and the values of a parameter
        if self.name in mounted.TOOLS:
            below = [robot.server, "robot.host_cxt"]
            self.program = mounted.Tool(host, self.name, words, environment, below)
        else:
            self.program = worlds.Program(host, self.name, typed(self.name, words), words, environment)
        self.program.at_end = lambda: self._note(robot)
        if interrupted is not None:
            robot.world.at(interrupted, self._interrupt, number)

    def _note_left(self, robot):
        for name in robot.lives:
            component = robot.living(name)
            if component is not None:
                joined = [profile for port in component.ports for profile in port.profiles.values()]
                tools = [profile.name for profile in joined if len(profile.ports) == 1]
                self.left[name] = tools + list(component.observers.registered)

    def _note(self, robot):
        if self.name in mounted.TOOLS:
            robot.world.at(mounted.LEFT, self._note_left, robot)
        self.connectors = robot.connectors()
        for name in robot.lives:
            component = robot.living(name)
            if component is not None:
                self.gains[name] = component.configuration.sets["default"]["gain"]

    def _interrupt(self, number):
        if not self.program.is_over:
            self.interrupted = self.world.time
            self.world.tell(f"{SIGNALS.get(number, 'SIGKILL')} to {self.line}")
            if number == real.SIGKILL:
                self.program.kill()
            else:
                self.program.strike(number)

    @property
    def is_over(self):
        return self.program.is_over

    @property
    def was_killed(self):
        """Whether its host has lost its power meanwhile."""
        return self.is_over and self.status is None and self.program.failure is None

    @property
    def ended(self):
        return self.program.ended

    @property
    def status(self):
        return self.program.status

    @property
    def out(self):
        if self._out is None:
            self._out = self.program.out.text()
        return self._out

    @property
    def error(self):
        if self._error is None:
            self._error = self.program.error.text().replace(self._place, "")
        return self._error


def _spelt(word, names):
    """A word with .rtc after the name of a component."""
    name, colon, port = word.partition(":")
    if name in names:
        return f"{name}.rtc{colon}{port}"
    return word


def typed(name, words, work=0.0):
    """main() of a command with these words, which computes for `work` seconds before it asks anybody."""
    module = _module(name)

    async def run(*args):
        loop.world().compute(work)
        return await module.run(*args)

    def main():
        try:
            return cli.command(module.arguments, run if work else module.run, module.__doc__, words)
        except KeyboardInterrupt:
            return 130
        except cli.Ended as e:
            return e.args[0]

    return main


def _module(name):
    if name not in _modules:
        _modules[name] = installation.load(installation.commands()[name], "sim_" + name)
    return _modules[name]
