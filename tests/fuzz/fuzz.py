"""Spoilt input of every kind: it is read, or refused with a declared error, soon and in little memory; and
what is read comes back the same after it was written.

    python3 tests/fuzz/fuzz.py [--seconds N | --cases N] [--seed N] [TARGET ...]

A case is a file of bytes, made from the seed and its number. One that fails is written to
tests/data/fuzz/TARGET/, where tests/fuzz/test_fuzz.py tries it ever after (rename it to what it shows).
fuzz_replies.py has the targets `replies` and `builtin`, whole commands with either ORB; fuzz_giop.py those of
single messages, the others are in fuzz_targets.py.
"""
import argparse
import contextlib
import os
import random
import re
import resource
import signal
import sys
import time
import traceback

HERE = os.path.dirname(os.path.abspath(__file__))
TESTS = os.path.dirname(HERE)
ROOT = os.path.dirname(TESTS)
DATA = os.path.join(TESTS, "data")
sys.path.append(os.path.join(TESTS, "support"))
sys.path.append(ROOT)  # behind what is installed
SECONDS = 5.0  # of processor time for one case
MEMORY = 256 << 20  # bytes on top of what the process has
LARGEST = 1 << 16  # bytes of a case


class Crash(Exception):
    """A case has shown a bug."""


class Refused(Exception):
    """The input was refused with a declared error."""


# ---- spoiling ----

NUMBERS = [
    b"0",
    b"-1",
    b"1",
    b"255",
    b"65536",
    b"2147483648",
    b"-2147483649",
    b"4294967295",
    b"18446744073709551616",
    b"1e999",
    b"9" * 500,
]
BYTES = [
    b"\0",
    b"\xff",
    b"\x80",
    b"\x7f",
    b"\n",
    b"\x1b",
    b"\xc2\x85",
    b"\xe2\x80\xae",
    b"\xed\xa0\x80",
    b"\0\0\0\0",
    b"\xff\xff\xff\xff",
    b"\x7f\xff\xff\xff",
    b"\xff\xff\xff\x7f",
    b"\0\0\0\1",
    b"\1\0\0\0",
]


def spoilt(rng, data, words, others):
    """`data` with a few changes; `words` are meaningful pieces of such data, `others` are similar documents
    to copy from.
    """
    for _ in range(rng.choice((1, 1, 2, 3, 6))):
        data = _changed(rng, data, words, others)[:LARGEST]
    return data


def _changed(rng, data, words, others):
    at = rng.randint(0, len(data))
    end = min(at + rng.choice((0, 1, 1, 3, 20, 200)), len(data))
    chance = rng.random()
    if chance < 0.3:
        return data[:at] + rng.choice(words) + data[end:]
    if chance < 0.4:
        return data[:at] + rng.choice(BYTES) + data[end:]
    if chance < 0.55:
        return data[:at] + data[end:]
    if chance < 0.65:
        return data[:at] + data[at:end] * rng.choice((2, 3, 100)) + data[end:]
    if chance < 0.67:
        return data[:at] + rng.choice(words) * rng.choice((10, 100, 3000)) + data[end:]
    if chance < 0.69:
        return data[:at]
    if chance < 0.79:
        numbers = list(re.finditer(rb"-?\d+", data))
        if numbers:
            found = rng.choice(numbers)
            return data[:found.start()] + rng.choice(NUMBERS) + data[found.end():]
    if chance < 0.9:
        other = rng.choice(others)
        start = rng.randint(0, len(other))
        return data[:at] + other[start:start + rng.choice((5, 40, 400))] + data[end:]
    return data[:at] + bytes([rng.randrange(256)]) + data[at + 1:]


# ---- targets ----

class Target:
    """What is fuzzed. `prepare` is called once before `make` and `check`; `done` once in the end."""

    name = ""
    words = []
    alone = True  # limits of time and memory are those of this process
    remark = ""  # on the figures, in the end

    def prepare(self):
        """Read `self.seeds`."""

    def make(self, rng):
        """One case, as bytes."""
        return spoilt(rng, rng.choice(self.seeds), self.words, self.seeds)

    def check(self, data):
        """Try a case. Raises Refused, and anything else where something is wrong."""
        raise NotImplementedError

    def done(self):
        pass


def same(one, other, what):
    """Raise Crash if two things differ."""
    if one != other:
        raise Crash("%s: %.300r is not %.300r" % (what, one, other))


# ---- running ----

@contextlib.contextmanager
def limits():
    """A context in which this process may use at most MEMORY more."""
    before = resource.getrlimit(resource.RLIMIT_AS)
    with open("/proc/self/statm") as file:
        now = int(file.read().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (now + MEMORY, before[1]))
    old = signal.signal(signal.SIGPROF, _too_slow)
    try:
        yield
    finally:
        signal.signal(signal.SIGPROF, old)
        resource.setrlimit(resource.RLIMIT_AS, before)


def _too_slow(*_):
    raise Crash("no end after %g s" % SECONDS)


def tried(target, data):
    """Try a case: None when it was read, "refused", or a text that says what is wrong."""
    signal.setitimer(signal.ITIMER_PROF, SECONDS if target.alone else 0)
    try:
        target.check(data)
    except Refused:
        return "refused"
    except Exception:  # whatever it is, it is what we look for
        return traceback.format_exc()
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
    return None


def case(target, seed, number):
    """The case of a seed and a number."""
    return target.make(random.Random("%s %s %d" % (target.name, seed, number)))


def fuzz(target, seed, seconds=None, cases=None, report=print):
    """Try cases up to a time or number: (number of cases, number of those read, [(number, data, what is
    wrong)]).
    """
    end = time.monotonic() + seconds if seconds else None
    number = 0
    read = 0
    wrong = []
    slowest = 0.0
    target.prepare()
    try:
        with limits() if target.alone else contextlib.suppress():
            while number < cases if cases else time.monotonic() < end:
                data = case(target, seed, number)
                begun = time.process_time()
                outcome = tried(target, data)
                slowest = max(slowest, time.process_time() - begun)
                read += outcome is None
                if outcome not in (None, "refused"):
                    wrong.append((number, data, outcome))
                number += 1
    finally:
        target.done()
    report("%-8s seed %s: %d cases, %d read, %d wrong, slowest %.2f s%s" % (
        target.name, seed, number, read, len(wrong), slowest, target.remark))
    return number, read, wrong


def targets():
    """All targets by name."""
    import fuzz_giop
    import fuzz_replies
    import fuzz_targets
    return {
        cls.name: cls
        for cls in fuzz_targets.TARGETS + fuzz_giop.TARGETS + [fuzz_replies.Replies, fuzz_replies.Builtin]
    }


def saved(name):
    """The paths of cases that once failed."""
    directory = os.path.join(DATA, "fuzz", name)
    return (
        [os.path.join(directory, file) for file in sorted(os.listdir(directory))]
        if os.path.isdir(directory)
        else []
    )


def _keep(name, seed, number, data):
    directory = os.path.join(DATA, "fuzz", name)
    os.makedirs(directory, exist_ok=True)
    path = os.path.join(directory, "seed-%s-case-%d" % (seed, number))
    with open(path, "wb") as file:
        file.write(data)
    return path


def options(known):
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("target", nargs="*", help="of %s (default: all)" % ", ".join(known))
    parser.add_argument("--seconds", type=float, default=10, help="for each target (10)")
    parser.add_argument("--cases", type=int, help="how many for each target")
    parser.add_argument("--seed", default="1")
    args = parser.parse_args()
    for name in args.target:
        if name not in known:
            parser.error("no such target: " + name)
    return args


def main():
    known = targets()
    args = options(known)
    status = 0
    for name in args.target or known:
        seen = set()
        for number, data, why in fuzz(known[name](), args.seed, args.seconds, args.cases)[2]:
            status = 1
            last = why.strip().splitlines()[-2:]
            if tuple(last) not in seen:  # one case of each kind
                seen.add(tuple(last))
                print("%s\n%s" % (_keep(name, args.seed, number, data), why))
    return status


if __name__ == "__main__":
    sys.modules["fuzz"] = sys.modules["__main__"]
    sys.exit(main())
