"""What the commands cost, beside the floor under each (floors.py): medians and ratios of one run. Nothing is
asserted.

    python3 -m tests.bench [--sizes 1,10,100,1000] [--rounds N] [--only WORD] [--rtshell] [SECTION ...]

sections: commands   CPU, wall, peak memory and remote calls of every command, for 1, 10, 100 and 1,000 components, with omniORBpy;
                     then the same with the builtin ORB, as ratios to that
          instructions  of the same commands, counted by valgrind, where that is: no load changes them
          hung       how long a listing takes beside processes that hang
          sessions   many commands from a pipe to rtsh, beside as many processes
          profiles   loading and saving a large RtsProfile, restoring and checking a system of 200 components
          logs       rtlog: rates, CPU, memory            ports   rtprint, rtinject: rates
          mount      rtmount: CPU of reads and listings, beside commands
          idl        what 500 IDL files in RTSHELL_IDL cost

Both of a pair run by turns, so that another load on the machine hits both. --rtshell also runs the real
rtshell, where pip can install it (into a directory of its own); a status in place of its figures: it does not
do this, or not so.
"""  # noqa: E501

import argparse
import json
import os
import shutil
import signal
import statistics
import subprocess
import sys
import sysconfig
import tempfile
import venv

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path[:0] = [ROOT, os.path.join(ROOT, "tests", "support")]
import worlds  # noqa: E402: the path first

COMMANDS = os.path.join(ROOT, "bin")
SECTIONS = ("commands", "instructions", "hung", "sessions", "profiles", "logs", "ports", "mount", "idl")
ROUNDS = {1: 15, 10: 15, 100: 7, 1000: 3}
SIZES = sorted(ROUNDS)

# A command, its floor, the objects that the floor is given, and what puts things back, not measured. {dir} is
# the directory, {all} all components in it, {one} the first, {other} the second, {file} an RtsProfile of
# them.
GROWING = [
    ("rtls {dir}", "listed", "", ""),
    ("rtls -l {dir}", "figures", "", ""),
    ("rtcat {all}", "shown", "{all}", ""),
    ("rtact {all}", "activate", "{all}", "rtdeact {all}"),
    ("rtcryo --all -o {file} {dir}", "system", "{all}", ""),
    ("rtcheck -s inactive {file}", "compared", "{file} {all}", ""),
    ("rtfind {dir} -t c", "listed", "", ""),
]
SINGLE = [
    ("rtpwd", "nothing", "", ""),
    ("rtcwd {dir}", "listed", "", ""),
    ("rtcon {one}:out {other}:in", "connect", "{one} {other}", "rtdis {one}"),
    ("rtdis {one}:out {other}:in", "disconnect", "{one} {other}", "rtcon {one}:out {other}:in"),
    ("rtcat -ll {one}", "profiles", "{one}", ""),
    ("rtconf {one}", "configurations", "{one}", ""),
    ("rtec {one}", "contexts", "{one}", ""),
    ("rtdoc {one}", "profiles", "{one}", ""),
    ("rtdeact {all}", "deactivate", "{all}", "rtact {all}"),
    ("rtreset --dry-run {all}", "listed", "", ""),
    ("rtexit --dry-run {all}", "listed", "", ""),
    ("rtdel --dry-run {all}", "listed", "", ""),
    ("rtsh -c {session}", "profiles", "{one}", ""),
    ("rtmgr --loaded {beside}/manager.mgr", "manager", "", ""),
    ("rtcomp --dry-run {beside}/manager.mgr:all -a {one}", "manager", "", ""),
    ("rtfsm {beside}/Microwave0.rtc getstate", "contexts", "{one}", ""),
    ("rtteardown --dry-run {file}", "system", "{all}", ""),
    ("rtresurrect --dry-run {file}", "system", "{all}", ""),
    ("rtstart --dry-run {file}", "nothing", "", ""),
    ("rtstop --dry-run {file}", "nothing", "", ""),
    ("rtstodot {file}", "nothing", "", ""),
    ("rtdoctor {dir}", "system", "{all}", ""),
    ("rtprint -n 1 {one}:out -t 0.2", "profiles", "{one}", ""),
    ("rtinject -n 1 {other}:in -c 42", "profiles", "{other}", ""),
    ("rtlog -f {log} -e 1 -i -t 0.2 {one}:out", "profiles", "{one}", ""),
    ("rtwatch -t 0.2 {one}", "profiles", "{one}", ""),
    ("rtvlog -t 0.2 {beside}/Motor0.rtc", "profiles", "{one}", ""),
    ("rttop -n 1", "figures", "", ""),
]
# worlds of which commands of the second list need something, in a directory apart
BESIDE = [["manager"], ["fsm"], ["observed"]]


class Meter:
    """The process that measures."""

    def __init__(self):
        self.process = subprocess.Popen(
            [sys.executable, "-I", os.path.join(HERE, "measure.py")],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
        )

    def run(self, words, environment, out=None):
        """(seconds of CPU, seconds, MiB, exit status)"""
        self.process.stdin.write(
            json.dumps({"words": words, "environment": environment, "out": out}).encode() + b"\n"
        )
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline().decode())

    def close(self):
        self.process.stdin.close()
        self.process.stdout.close()
        self.process.wait()


class Bench:
    """A name server and what runs against it."""

    def __init__(self, rounds, only, peer):
        self.rounds = rounds
        self.only = only
        self.peer = peer
        worlds.start_name_server()
        self.meter = Meter()
        self.directory = tempfile.TemporaryDirectory()
        self.place = "127.0.0.1:%d" % worlds.Server.port
        known = {name: value for name, value in worlds.ENVIRONMENT.items() if name not in (
            "PYTHONDONTWRITEBYTECODE", "PYTHONUNBUFFERED")}  # nobody's robot compiles at every start
        self.environment = dict(
            known,
            RTSHELL_ORB="omniorb",
            RTCTREE_NAMESERVERS=self.place,
            RTCSH_CWD="/%s/test.host_cxt" % self.place,
        )

    def close(self):
        self.meter.close()
        self.directory.cleanup()
        worlds.Server.stop()

    def words(self, text, size, bare=False):
        """The words of a command or, `bare`, of a floor."""
        names = ["Mock%d" % number + ("" if bare else ".rtc") for number in range(size)]
        found = {
            "{dir}": ["."],
            "{all}": names,
            "{file}": [os.path.join(self.directory.name, "system.xml")],
            "{log}": [os.path.join(self.directory.name, "log")],
            "{session}": ["rtls; rtcat %s; rtec %s" % (names[0], names[0])],
        }
        one = {"{one}": names[0], "{other}": names[1 % size], "{beside}": "../beside.host_cxt"}
        words = []
        for word in text.split():
            for mark, name in one.items():
                word = word.replace(mark, name)
            words += found.get(word, [word])
        return words

    def ours(self, words, orb="omniorb"):
        command = [sys.executable, os.path.join(COMMANDS, words[0])]
        return self.meter.run(command + words[1:], dict(self.environment, RTSHELL_ORB=orb))

    def theirs(self, words):
        environment = dict(self.environment, PYTHONPATH=sysconfig.get_path("platlib"))  # our omniORBpy
        return self.meter.run([os.path.join(self.peer, words[0])] + words[1:], environment)

    def floor(self, name, words):
        program = [sys.executable, os.path.join(HERE, "floors.py"), name, str(worlds.Server.port)]
        return self.meter.run(program + words, self.environment)

    def compare(self, world, size, command, floor, told, undo):
        """One line of the table."""
        words = self.words(command, size)
        told = self.words(told, size, True)
        ways = {"floor": lambda: self.floor(floor, told), "ours": lambda: self.ours(words),
                "builtin": lambda: self.ours(words, "builtin"), "peer": lambda: self.theirs(words)}
        if not self.peer:
            del ways["peer"]
        back = self.words(undo, size)
        calls = {}
        for orb in ("ours", "builtin"):
            world.ctl("reset")
            ways[orb]()
            calls[orb] = sum(int(line.split()[0]) for line in world.ctl("calls").splitlines())
            if back:
                self.ours(back)
        measured = {kind: [] for kind in ways}
        for _ in range(self.rounds or ROUNDS.get(size, 3)):
            for kind in ways:
                if back:
                    self.ours(back)
                measured[kind].append(ways[kind]())
        if back:
            self.ours(back)
        return self.line(command, size, measured, calls)

    def line(self, command, size, measured, calls):
        medians = {
            kind: [statistics.median(column) for column in zip(*found)] for kind, found in measured.items()
        }
        said = {
            kind: ",".join(str(status) for status in sorted({int(one[3]) for one in found}))
            for kind, found in measured.items()
        }
        own = medians["ours"]
        floor = medians["floor"]
        text = "%-50s %5d  %6.0f %6.0f %5.2f  %6.0f %6.0f  %5.1f %5.1f %5.2f  %6d  %s" % (
            command,
            size,
            own[0] * 1000,
            floor[0] * 1000,
            own[0] / floor[0],
            own[1] * 1000,
            floor[1] * 1000,
            own[2],
            floor[2],
            own[2] / floor[2],
            calls["ours"],
            said["ours"],
        )
        text += "  %5.2f %5.2f %5.2f  %6d  %s" % (tuple(medians["builtin"][i] / own[i] for i in range(3)) + (
            calls["builtin"], said["builtin"]))
        if said.get("peer") == "0":
            text += "   %6.0f %6.0f %5.1f" % (
                medians["peer"][0] * 1000,
                medians["peer"][1] * 1000,
                medians["peer"][2],
            )
        elif "peer" in said:
            text += "   status %s" % said["peer"]
        print(text, flush=True)
        return own[0], floor[0]

    def commands(self, sizes):
        print(
            "%-50s %5s  %6s %6s %5s  %6s %6s  %5s %5s %5s  %6s  %s"
            % (
                "command",
                "size",
                "CPU",
                "floor",
                "ratio",
                "wall",
                "floor",
                "MiB",
                "floor",
                "ratio",
                "calls",
                "status",
            )
            + "  builtin: CPU, wall, MiB, calls, status"
            + ("   %6s %6s %5s" % ("rtshell", "wall", "MiB") if self.peer else "")
            + "   (ms)"
        )
        costs = {}
        for size in sizes:
            rows = GROWING + (SINGLE if size == 10 or sizes == [size] else [])
            rows = [row for row in rows if not self.only or row[0].split()[0] in self.only]
            world = worlds.World("many", str(size))
            beside = [
                worlds.World(*words + ["--context", "beside.host_cxt/%n.rtc"])
                for words in BESIDE
                if "beside" in str(rows)
            ]
            try:
                self.ours(self.words("rtcryo --all -o {file} {dir}", size))
                for row in rows:
                    if os.path.exists(os.path.join(COMMANDS, row[0].split()[0])):
                        costs[row[0], size] = self.compare(world, size, *row)
            finally:
                for each in [world] + beside:
                    each.close()
                self.ours(["rtdel", "-q", "-z"])
        if len(sizes) > 1:
            self.growth(costs, sizes[0], sizes[-1])

    def growth(self, costs, least, most):
        """How steep each line is."""
        for command in sorted({command for command, _ in costs}):
            if (command, least) in costs and (command, most) in costs:
                own, floor = [
                    (costs[command, most][i] - costs[command, least][i]) / (most - least) * 1000
                    for i in (0, 1)
                ]
                print(
                    "%-50s each component more: %.2f ms, floor %.2f ms, ratio %.2f"
                    % (command, own, floor, own / floor)
                )

    def instructions(self, sizes):
        """Millions of instructions of a command with our own ORB, and of each component more."""
        if shutil.which("valgrind") is None:
            print("valgrind is not there: no instructions are counted")
            return
        print("%-50s %6.1f million instructions" % ("Python alone", self.counted(["-c", "pass"])), flush=True)
        found = {}
        for size in sizes:
            world = worlds.World("many", str(size))
            try:
                self.ours(self.words("rtcryo --all -o {file} {dir}", size), "builtin")
                for command, _, _, undo in GROWING:
                    if undo or self.only and command.split()[0] not in self.only:
                        continue
                    words = self.words(command, size)
                    found[command, size] = self.counted([os.path.join(COMMANDS, words[0])] + words[1:])
                    more = ""
                    if size > sizes[0]:
                        each = (found[command, size] - found[command, sizes[0]]) / (size - sizes[0])
                        more = ", %.2f for each component more" % each
                    print("%-50s %5d %6.1f%s" % (command, size, found[command, size], more), flush=True)
            finally:
                world.close()
                self.ours(["rtdel", "-q", "-z"])

    def counted(self, words):
        """Millions of instructions of a run of Python."""
        with tempfile.NamedTemporaryFile("r", suffix=".counted") as file:
            command = ["valgrind", "--tool=cachegrind", "--cache-sim=no"]
            command += ["--cachegrind-out-file=" + file.name, sys.executable]
            environment = dict(self.environment, RTSHELL_ORB="builtin")
            status = self.meter.run(command + words, environment)[3]
            if status:
                raise SystemExit("%s: status %d" % (" ".join(words), status))
            return int(file.read().rpartition("summary:")[2].split()[0]) / 1e6

    def hung(self):
        live = worlds.World("two")
        for count in (0, 1, 4, 16):
            stopped = [worlds.World("these", "ConsoleIn:Hung%d" % number) for number in range(count)]
            for world in stopped:
                world.process.send_signal(signal.SIGSTOP)
            for words in (["rtls", "--timeout", "1", "."], ["rtls", "-l", "--timeout", "1", "."],
                          ["rtcat", "--timeout", "1", "ConsoleIn0.rtc"]):
                one = self.ours(words)
                print(
                    "%2d hung processes: %-24s %.2f s, status %d" % (count, " ".join(words), one[1], one[3]),
                    flush=True,
                )
            for world in stopped:
                world.close()
            self.ours(["rtdel", "-q", "-z"])
        live.close()

    def sessions(self, count=100):
        """`ls -l`, `count` times, and ten times as many, in one rtsh, beside a process each."""
        world = worlds.World("two")
        shell = dict(self.environment, PATH=COMMANDS + os.pathsep + self.environment["PATH"])
        apart = self.meter.run(["sh", "-c", "for i in $(seq %d); do rtls -l; done" % count], shell)[0] / count
        print("rtls -l, a process each:        %6.2f ms of CPU" % (apart * 1000), flush=True)
        for many in (count, 10 * count):
            once = self.meter.run(["sh", "-c", "yes 'ls -l' | head -n %d | rtsh" % many], shell)[0] / many
            print(
                "ls -l, %4d times in one rtsh:   %6.2f ms of CPU, 1/%.0f" % (many, once * 1000, apart / once),
                flush=True,
            )
        world.close()


def script(name, *words):
    """Run one of the scripts beside this file."""
    if os.path.exists(os.path.join(HERE, name)):
        subprocess.run([sys.executable, os.path.join(HERE, name)] + list(words), check=False)
    else:
        print("%s is not there" % name)


def real_rtshell(directory):
    """Where the commands of the real rtshell are; None when pip cannot install it."""
    venv.create(directory, with_pip=True)
    done = subprocess.run(
        [os.path.join(directory, "bin", "python"), "-m", "pip", "install", "-q", "rtshell-aist"],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        universal_newlines=True,
    )
    if done.returncode or not os.path.exists(os.path.join(directory, "bin", "rtls")):
        print(
            "the real rtshell cannot be installed: %s" % (done.stdout.strip().splitlines() or ["no rtls"])[-1]
        )
        return None
    return os.path.join(directory, "bin")


def options():
    parser = argparse.ArgumentParser(prog="python3 -m tests.bench", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("section", nargs="*", help="default: all")
    parser.add_argument("--sizes", default=",".join(map(str, SIZES)))
    parser.add_argument("--rounds", type=int, help="default: 15 of small systems, 3 of large ones")
    parser.add_argument("--only", action="append", metavar="COMMAND", help="may be repeated")
    parser.add_argument("--rtshell", action="store_true")
    args = parser.parse_args()
    for section in args.section:
        if section not in SECTIONS:
            parser.error("no such section: " + section)
    return args


def main():
    args = options()
    wanted = args.section or SECTIONS
    with tempfile.TemporaryDirectory() as directory:
        peer = real_rtshell(directory) if args.rtshell else None
        if {"commands", "instructions", "hung", "sessions"}.intersection(wanted):
            bench = Bench(args.rounds, args.only, peer)
            try:
                if "commands" in wanted:
                    bench.commands([int(size) for size in args.sizes.split(",")])
                if "instructions" in wanted:
                    bench.instructions([int(size) for size in args.sizes.split(",") if int(size) < 1000])
                if "hung" in wanted:
                    bench.hung()
                if "sessions" in wanted:
                    bench.sessions()
            finally:
                bench.close()
    for section, name in (
        ("profiles", "restore.py"),
        ("logs", "rtlog.py"),
        ("ports", "ports.py"),
        ("mount", "mount.py"),
        ("idl", "idl.py"),
    ):
        if section in wanted:
            script(name)


if __name__ == "__main__":
    main()
