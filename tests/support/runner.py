"""Build the wheel, install it with omniORBpy in a private environment, run the tests against it.

Ends with a line "N passed, N failed[, N skipped]"; the exit status is 1 if a test failed or none ran.

  tests/run unit                  what is true or false without waiting, in less than a minute: the modules of
                                  tests/unit/, which ask no other process and wait for no clock
  tests/run                       that, the packaging, and each command's own transcript, under one shell with
                                  one ORB: in 5 minutes; the last lines say what was not run
  tests/run rtls test_path        those whose name holds one of these words: tests/commands/rtls.t,
                                  tests/unit/test_path.py; a word that names a folder is all that is in it
  tests/run 'rtls.t (dash)'       one transcript under one shell
  tests/run --python 3.7 rtls     on another Python
  tests/run --compat              profiles against PyYAML and the real rtsprofile, logs against MCAP's readers
  tests/run --real DIR [--real DIR]  every command, in loops, on real components: DIR holds built examples of
                                  OpenRTM-aist, of C++ or Python; --rounds N of each loop (100), a word of a
                                  test's name for a part; with the ORB that RTSHELL_ORB names
  tests/run --long test_long      the long form of what tests/faults/ and the like try in short: hours in all
  tests/run --seed 7 faults       with other samples, random values and storms than those of every day
  tests/run --accept rtls.t       take what the commands print now as what is expected; then read `git diff`
  tests/run --all                 the matrix: test modules on 3.11, 3.6 and 3.13; all transcripts by our own
                                  ORB, on 3.6 or 3.13; those of commands, and those about what an ORB does, by
                                  omniORB on 3.7 or 3.13; faults by both; the wheel on every Python from 3.6
                                  to 3.13, installed or unpacked
"""

import argparse
import collections
import concurrent.futures
import glob
import math
import os
import re
import signal
import sys
import time
import zlib

import environments
import jobs
import processes
import transcripts

TESTS = os.path.dirname(jobs.HERE)
ALL = ["3.%d" % minor for minor in range(6, 14)]
# The matrix: test modules run on these Pythons, those that say that one is enough on the first.
MODULES = ["3.11", "3.6", "3.13"]
# Shells and ORBs to play transcripts with on each Python, see has_turn; the ORB is None where it is the one
# that the commands choose themselves.
MATRIX = {
    "3.11": [],
    "3.7": [("ash", "omniorb")],
    "3.13": [("dash", "omniorb"), ("dash", None)],
    "3.6": [("dash", None), ("ash", None)],
}
# Our own ORB plays every third transcript on a Python that has omniORBpy, the others on one that has it not;
# omniORB takes turns on two.
PURE = "3.6"
SHARE = 3
TURNS = ["3.7", "3.13"]
UNTRIED = ["packaging/test_packaging", "packaging/test_unpack"]  # by turns, see packaging_jobs
MODULE_LIMIT = 900.0  # seconds for one test module, on a busy machine
LONG_LIMIT = 4 * 3600.0  # the same with --long
PROCESSORS = os.cpu_count() or 1
# What stands in unit/ asks no other process and waits for no clock, which processes.py enforces; what does is
# in waiting/.
PURE_ONES = "unit"
EVERY_DAY = (PURE_ONES, "sim", "packaging")  # all of these without a word
DIRECTORIES = EVERY_DAY + ("waiting", "mocks", "commands", "faults", "fuzz")
OF_OMNIORB = 4  # every fourth transcript is played with omniORB then, the others with our own ORB
USERS_ORB = os.environ.get("RTSHELL_ORB")
SEED = os.environ.get("RTSHELL_SEED", "1")
COMPAT = ["compat/test_rtsprofile", "compat/test_mcap"]
REAL = ["compat/test_real", "compat/test_real_keep"]


# `run` returns outcomes. `at_once` jobs like it may run together, and nothing else; the longest ones, by the
# `size` of their files, begin, so that none is left when all others are done.
Job = collections.namedtuple("Job", "label run at_once size")


# ---- test modules ----


def test_modules():
    """Names of the test modules: unit/test_path …"""
    paths = []
    for directory in DIRECTORIES:
        paths += glob.glob(os.path.join(glob.escape(TESTS), directory, "test_*.py"))
    return sorted(os.path.relpath(path, TESTS)[:-3] for path in paths)


def words_for(folder, args):
    """The words that choose among the tests of a folder: [] if all of them are run, None if none is."""
    words = [word for word in args.pattern if word not in DIRECTORIES]
    if folder in args.pattern or not args.pattern and (not args.daily or folder in EVERY_DAY):
        return []
    return words or None


def source(module):
    return os.path.join(TESTS, module + ".py")


def says(module, word):
    """What a module says of ALONE (it measures times), ONCE (one Python of the matrix is enough), BOTH (each
    ORB has its turn), LONG (it begins first); "" if it does not.
    """
    with open(source(module), encoding="utf-8") as file:
        return next((line[len(word):].split()[1] for line in file if line.startswith(word + " =")), "")


def module_jobs(label, interpreter, modules, args, **more):
    """Jobs that run modules, those of them that are asked for, with more in their environment."""
    environment = dict(os.environ, **more)

    def job(module, patterns):
        def run():
            return run_module(module, interpreter, environment, patterns)

        some = at_once(says(module, "ALONE"))
        size = math.inf if says(module, "LONG") else os.path.getsize(source(module))
        return Job("%s %s" % (label, module), run, some, size)

    chosen = [(module, words_for(os.path.dirname(module), args)) for module in modules]
    return [job(module, patterns) for module, patterns in chosen if patterns is not None]


def wheel_jobs(python, interpreter, wheel, args, modules, orb=None):
    """Jobs that run modules on an interpreter, of a Python, in which the wheel is installed, or not."""
    more = {"RTSHELL_WHEEL": wheel, "PYTHONPATH": mocks_alone()}
    if orb:
        more["RTSHELL_ORB"] = orb
    omniorb = environments.fetch_omniorb(python)
    if omniorb:
        more["RTSHELL_OMNIORB_WHEEL"] = omniorb
    if interpreter != python.path:
        more["PATH"] = os.path.dirname(interpreter) + os.pathsep + os.environ["PATH"]
    return module_jobs(" ".join(filter(None, (python.version, orb))), interpreter, modules, args, **more)


def run_module(module, python, environment, patterns, limit=MODULE_LIMIT):
    """The outcomes of a test module: [[name, "pass", "fail", "skip" or "figures", explanation]]."""
    if os.path.dirname(module) == PURE_ONES:
        environment = dict(environment, RTSHELL_PURE="1")
    if os.environ.get("RTSHELL_FAULTS"):
        limit = LONG_LIMIT
    outcomes, why, said = jobs.run_job(python, "report.py", [module] + patterns, limit, environment)
    if outcomes is None:
        return [(module, "fail", "%s\n%s" % (why, said))]
    if said and outcomes and outcomes[-1][1] == "fail":
        outcomes[-1][2] += "\noutput of %s:\n%s" % (module, said)
    figures = [line for line in said.splitlines() if line.startswith("figures: ")]
    return [(module, "figures", line) for line in figures] + outcomes


def mocks_alone():
    """A directory that holds mock_components and nothing else: rtshell_lite must come from the environment.
    """
    directory = os.path.join(environments.STORE, "mocks")
    os.makedirs(directory, exist_ok=True)
    link = os.path.join(directory, "mock_components")
    if not os.path.islink(link):
        os.symlink(os.path.join(os.pardir, os.pardir, "mock_components"), link)
    return directory


# ---- transcripts ----


def transcript_jobs(python, interpreter, wheel, orb, args, shell=None):
    """Jobs for the transcripts under a shell (None: all) that are asked for, and have their turn. The mocks
    of a Python that has no omniORBpy run on another.
    """
    words = [] if args.daily else words_for("commands", args)
    if words is None:
        return []
    missing = transcripts.missing_shells()
    commands = os.path.dirname(interpreter)
    environment = dict(os.environ, PYTHONPATH=mocks_alone())
    label = " ".join(filter(None, (python.version, orb)))
    lacks_omniorb = not environments.fetch_omniorb(python)
    peers = interpreter
    if lacks_omniorb:
        peers = environments.prepare(environments.find_python(MODULES[0]), wheel)

    def job(path, shell):
        name = transcripts.case_name(path, shell)

        def run():
            if shell in missing:
                return [(name, "skip", "%s is not installed" % transcripts.SHELLS[shell][0])]
            how = peers, commands, orb, args.accept, environment
            return [(name,) + transcripts.run_case(path, shell, *how)]

        some = at_once(transcripts.says(path, "alone"))
        return Job("%s %s" % (label, name), run, some, os.path.getsize(path))

    return [
        job(path, shell)
        for path, shell in transcripts.cases(words, shell and [shell])
        if not (lacks_omniorb and transcripts.says(path, "orb: omniorb"))
        and not (args.daily and not has_its_day(path, shell, orb))
        and not (args.all and not has_turn(python.version, shell, orb, path))
    ]


def is_own(path):
    """Is it a command's own transcript, not one about a side of it?"""
    return "-" not in os.path.basename(path)


def has_its_day(path, shell, orb):
    """Is a transcript played so without a word? A command's own one is, under one shell and with one ORB."""
    number, shell_number = divmod(zlib.crc32(os.path.basename(path).encode()), len(transcripts.SHELLS))
    takes_omniorb = number % OF_OMNIORB == 0 or bool(USERS_ORB)
    return is_own(path) and shell == sorted(transcripts.SHELLS)[shell_number] and bool(orb) == takes_omniorb


def has_turn(version, shell, orb, path):
    """Does the matrix play a transcript with these? Each once with our own ORB, and with omniORB where that
    can differ. What a shell does does not depend on the Python, nor on the ORB.
    """
    number = zlib.crc32(os.path.basename(path).encode())
    if orb is None:
        plays = version == (PURE if number % SHARE else TURNS[-1])
        return plays and (version != PURE or shell == ("dash", "ash")[number % 2])
    differs = is_own(path) or transcripts.says(path, "both") or transcripts.says(path, "orb: omniorb")
    return differs and version == TURNS[number % len(TURNS)]


# ---- running them ----


def at_once(measures):
    """How many jobs run at once, for they wait more than they compute: fewer of those that measure times;
    what these wait for a processor is subtracted.

    With more jobs nothing ends sooner, and a command waits longer for a processor than its peers give it.
    """
    return PROCESSORS if measures else 2 * PROCESSORS


class Score:
    """The outcomes so far, which are printed as they come."""

    def __init__(self):
        self.counts = collections.Counter()
        self.reasons = {}
        self.left = 0
        self.begun = time.monotonic()

    def progress(self):
        """On a terminal, a line that the next one replaces."""
        if sys.stdout.isatty():
            seconds = time.monotonic() - self.begun
            text = "%d jobs left, %d s, %d failed" % (self.left, seconds, self.counts["fail"])
            print("\x1b[K" + text * bool(self.left), end="\r", flush=True)

    def add(self, label, outcomes, seconds=0):
        kinds = [outcome for _, outcome, _ in outcomes if outcome != "figures"]
        self.counts.update(kinds)
        for name, outcome, text in outcomes:
            if outcome == "figures":
                print("     %s: %s" % (label, text[len("figures: "):]), flush=True)
            elif outcome == "fail":
                which = "" if name in label else ": " + name
                print("FAIL %s%s\n%s\n" % (label, which, text.rstrip()), flush=True)
            elif outcome == "skip":
                self.reasons.setdefault(text, []).append("%s: %s" % (label, name))
        if kinds and seconds and "fail" not in kinds:
            what = "ok  " if "pass" in kinds else "skip"
            print("%s %s: %d in %.1f s" % (what, label, len(kinds), seconds), flush=True)

    def close(self, not_run=""):
        """Print the last lines; returns the exit status."""
        if not self.counts:
            print("no test has such a name")
        for reason, names in sorted(self.reasons.items()):
            print("skipped %d: %s" % (len(names), reason))
        if not_run:
            print("not run: %s; tests/run --all runs them" % not_run)
        skipped = ", %(skip)d skipped" % self.counts if self.counts["skip"] else ""
        print("%(pass)d passed, %(fail)d failed" % self.counts + skipped, flush=True)
        return 1 if self.counts["fail"] or not self.counts["pass"] else 0


def run_jobs(some, score):
    """Run jobs, those first of which most may run at once; each once, whatever the outcome."""
    for most in sorted({job.at_once for job in some}, reverse=True):
        pool = concurrent.futures.ThreadPoolExecutor(most)
        now = [job for job in some if job.at_once == most]
        score.left = len(now)
        started = [pool.submit(timed, job) for job in sorted(now, key=lambda job: job.size, reverse=True)]
        for future in concurrent.futures.as_completed(started):
            score.left -= 1
            score.add(*future.result())
            score.progress()


def timed(job):
    """Run a job: its label, its outcomes, and its seconds."""
    begun = time.monotonic()
    try:
        outcomes = job.run()
    except Exception as e:  # a fault of the runner must not be taken for success, nor stop the others
        outcomes = [(job.label, "fail", "%s: %s" % (type(e).__name__, e))]
    return job.label, outcomes, time.monotonic() - begun


# ---- what to run ----


def compat_jobs(args):
    """The tests that need PyYAML, the real rtsprofile, the readers of MCAP; skipped where these cannot be
    installed.
    """
    python = environments.find_python(args.python[0] if args.python else sys.executable)
    try:
        interpreter = environments.prepare_compat(python)
    except environments.Failed as e:
        why = "PyYAML, rtsprofile-aist, mcap cannot be installed: " + str(e).splitlines()[-1]
        return [Job(python.version + " compat", lambda: [(module, "skip", why) for module in COMPAT], 1, 0)]
    more = {"PYTHONPATH": environments.ROOT}
    npm = environments.prepare_npm()
    if npm:
        more["RTSHELL_NPM"] = npm
    return module_jobs(python.version, interpreter, COMPAT, args, **more)


def jobs_for(version, wheel, args):
    """All jobs on one Python."""
    python = environments.find_python(version)
    interpreter = environments.prepare(python, wheel)

    def of_modules(modules, orb=None):
        return wheel_jobs(python, interpreter, wheel, args, modules, orb)

    def of_transcripts(orb, shell=None):
        return transcript_jobs(python, interpreter, wheel, orb, args, shell)

    if args.real:
        return of_modules(REAL)
    if args.accept:
        return of_transcripts(USERS_ORB, "dash")
    found = []
    if not args.all or version in MODULES:
        all_of_them = not args.all or version == MODULES[0]
        found = of_modules([module for module in test_modules() if all_of_them or not says(module, "ONCE")])
    if not args.all:
        orbs = [None, "omniorb"] if args.daily and not USERS_ORB else [USERS_ORB]
        return found + [job for orb in orbs for job in of_transcripts(orb)]
    for shell, orb in MATRIX[version]:
        found += of_transcripts(orb, shell)
        if orb and version == TURNS[-1]:
            found += of_modules([module for module in test_modules() if says(module, "BOTH")], orb)
    return found


def packaging_jobs(version, wheel, args):
    """The packaging tests on a Python as it is, with nothing installed for them. Every second Python tries
    how the wheel is installed, the others how it is unpacked.
    """
    python = environments.find_python(version)
    left_out = UNTRIED[ALL.index(version) % len(UNTRIED)]
    packaging = [
        module
        for module in test_modules()
        if module.startswith("packaging/") and module != left_out and not says(module, "ONCE")
    ]
    return wheel_jobs(python, python.path, wheel, args, packaging)


def gather_jobs(args, wheel, score):
    """The jobs of all requested versions; a Python that is not installed is reported as skipped."""
    if args.compat:
        return compat_jobs(args)
    versions = list(MATRIX) if args.all else args.python or [sys.executable]
    wanted = [(jobs_for, version) for version in versions]
    wanted += [(packaging_jobs, version) for version in ALL if args.all and version not in MODULES]

    def gather(make, version):
        try:
            return make(version, wheel, args)
        except environments.Missing as e:
            score.add(version, [("all tests", "skip" if args.all else "fail", str(e))])
        except environments.Failed as e:
            score.add(version, [("environment", "fail", str(e))])
        return []

    with concurrent.futures.ThreadPoolExecutor(PROCESSORS) as pool:  # environments take their time to make
        return [job for some in pool.map(gather, *zip(*wanted)) for job in some]


def left_out():
    """What a run without a word leaves out, in words."""
    sides = [path for path, _ in transcripts.cases(shells=["dash"]) if "-" in os.path.basename(path)]
    tests = collections.Counter()
    for module in test_modules():
        with open(source(module), encoding="utf-8") as file:
            tests[os.path.dirname(module)] += len(re.findall(r"^ +def test_", file.read(), re.MULTILINE))
    others = ["%d tests of %s/" % (tests[folder], folder) for folder in DIRECTORIES[len(EVERY_DAY):]]
    return "%d transcripts, %s, other Pythons, shells and ORBs" % (len(sides), ", ".join(others))


def builder():
    """The Python that builds the wheel: this one, or the newest here if it is too old to build from
    setup.cfg.
    """
    for version in [sys.executable] * (sys.version_info >= (3, 7)) + ALL[:0:-1]:
        try:
            return environments.find_python(version)
        except environments.Missing:
            pass
    raise environments.Missing("no Python from 3.7 on is here: an older one cannot build the wheel")


def options():
    parser = argparse.ArgumentParser(
        prog="tests/run", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    add = parser.add_argument
    add("pattern", nargs="*", help="part of a test's name")
    add("--python", action="append", metavar="VERSION", help="a version or a path; may be repeated")
    add("--compat", action="store_true", help="compare with PyYAML, the real rtsprofile, the readers of MCAP")
    add("--real", action="append", metavar="DIR", help="try built examples of OpenRTM-aist; may be repeated")
    add("--rounds", type=int, default=100, metavar="N", help="with --real: how often each loop goes round")
    add("--all", action="store_true", help="the matrix")
    add("--seed", type=int, default=int(SEED), metavar="N", help="draw other samples than those of %s" % SEED)
    add("--long", action="store_true", help="all cases of the tests of faults, and long runs of 10 minutes")
    add("--accept", action="store_true", help="rewrite transcripts from what is printed")
    return parser.parse_args()


def hear_signals():
    """Stop ignoring signals that our parent ignored, as `nohup … &` does: the commands under test would
    inherit that.
    """
    for number, handler in ((signal.SIGINT, signal.default_int_handler), (signal.SIGHUP, signal.SIG_DFL)):
        if signal.getsignal(number) == signal.SIG_IGN:
            signal.signal(number, handler)


def main():
    args = options()
    hear_signals()
    if args.long or args.real:
        os.environ["RTSHELL_FAULTS"] = "1"
    if args.real:
        os.environ["RTSHELL_REAL"] = os.pathsep.join(map(os.path.abspath, args.real))
        os.environ["RTSHELL_ROUNDS"] = str(args.rounds)
    os.environ["RTSHELL_SEED"] = str(args.seed)
    args.daily = not (args.pattern or args.all or args.long or args.real or args.compat or args.accept)
    try:
        processes.nameserver.try_loopback()
    except processes.nameserver.Failed as e:
        sys.exit("tests/run: %s" % e)
    marker = jobs.mark()
    score = Score()
    held = environments.lock()
    try:
        wheel = environments.build_wheel(builder())
    except environments.Failed as e:
        score.add("wheel", [("build", "fail", str(e))])
        return score.close()
    print("wheel: %s, %d kB; seed: %d" % (os.path.basename(wheel), os.path.getsize(wheel) // 1000, args.seed))
    run_jobs(gather_jobs(args, wheel, score), score)
    for line in jobs.left_behind(marker):
        score.add("processes", [("left behind", "fail", line)])
    held.close()
    return score.close(left_out() if args.daily else "")


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:  # what still runs ends with its stdin
        os._exit(130)
