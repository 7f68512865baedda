#!/usr/bin/env python3
"""Break the product in one place after another, and see whether simulated worlds notice.

  python3 tests/sim/mutants.py [--worlds N] [WORD ...]     those whose file or text has one of these words

First as it is, where they must notice nothing. Status 1 if they do, or if one cannot be played: what is to
be broken is not there, and the list is stale, or simulate fails.
"""

import argparse
import concurrent.futures
import os
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SEED = "700000"
AT_ONCE = 2
HANGS = 1800  # seconds until a mutant is killed: a world does not end, or a program in it never waits
NO_WORLD = "NO WORLD"  # could be played


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--worlds", default="1000", metavar="N", help="in which it has to be noticed (1000)")
    parser.add_argument("words", nargs="*", metavar="WORD")
    args = parser.parse_args()
    wanted = [
        mutant for mutant in read() if not args.words or any(word in " ".join(mutant) for word in args.words)
    ]
    noticed = _notice((os.path.join("bin", "rtls"), "", ""), args.worlds)
    if noticed:
        sys.exit(f"worlds find something in the product as it is: {noticed}")
    found = []
    with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
        for mutant, noticed in zip(wanted, pool.map(lambda each: _notice(each, args.worlds), wanted)):
            name, *texts = mutant
            found.append(noticed)
            print(f"{noticed or 'NOT NOTICED':28} {name}")
            print(f"{'':28} {' -> '.join(' '.join(text.split()) for text in texts)}", flush=True)
    missing = sum(words.startswith(NO_WORLD) for words in found)
    print(f"{sum(map(bool, found)) - missing} of {len(wanted)} noticed, {missing} not played")
    sys.exit(1 if missing else 0)


def read():
    """[(file, what stands there, what takes its place)] of mutants.txt."""
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "mutants.txt")) as file:
        blocks = file.read().split("\n\n")
    for block in blocks:
        lines = [line for line in block.splitlines() if line and line[0] != "#"]
        if lines:
            yield (lines[0], *["\n".join(_after(sign, lines)) for sign in "-+"])


def _after(sign, lines):
    return [line[2:] for line in lines[1:] if line[0] == sign]


def _notice(mutant, worlds):
    """By which oracle the worlds notice a mutant, and in how many, '' where they do not; or NO_WORLD."""
    name, old, new = mutant
    with tempfile.TemporaryDirectory() as top:
        for part in ("rtshell_lite", "bin", "mock_components", "tests"):
            ignored = shutil.ignore_patterns("__pycache__")
            shutil.copytree(os.path.join(ROOT, part), os.path.join(top, part), ignore=ignored)
        path = os.path.join(top, name)
        with open(path, encoding="utf-8") as file:
            text = file.read()
        if old not in text:
            return f"{NO_WORLD}: what is to be broken is not there"
        with open(path, "w", encoding="utf-8") as file:
            file.write(text.replace(old, new, 1))
        command = os.path.join(top, "tests", "simulate")
        words = [sys.executable, command, "--seed", SEED, "--worlds", worlds, "-x"]
        pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "universal_newlines": True}
        try:
            done = subprocess.run(words, env=dict(os.environ, TMPDIR=top), timeout=HANGS, **pipes)
        except subprocess.TimeoutExpired:  # it has been killed
            return "ends"
    if not done.returncode:
        return ""
    told = re.search(r"^FAIL seed (\d+).*\n  ([\w ]+):", done.stdout, re.M)
    if told is None:
        return f"{NO_WORLD}: {done.stderr}"
    return f"{told.group(2)}, {int(told.group(1)) - int(SEED) + 1} worlds"


if __name__ == "__main__":
    main()
