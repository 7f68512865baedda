#!/usr/bin/env python3
"""Break the product in one place after another, and see whether simulated worlds notice.

  python3 tests/sim/mutants.py [--worlds N] [WORD ...]     those whose file or text has one of these words
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SEED = "700000"


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--worlds", default="1000", metavar="N", help="in which it has to be noticed (1000)")
    parser.add_argument("words", nargs="*", metavar="WORD")
    args = parser.parse_args()
    wanted = [
        mutant for mutant in _read() if not args.words or any(word in " ".join(mutant) for word in args.words)
    ]
    found = 0
    for name, old, new in wanted:
        noticed = _is_noticed(name, old, new, args.worlds)
        found += bool(noticed)
        print(f"{noticed or 'NOT NOTICED':12} {name}")
        print(f"{'':12} {' '.join(old.split())} -> {' '.join(new.split())}", flush=True)
    print(f"{found} of {len(wanted)} noticed")


def _read():
    """[(file, what stands there, what takes its place)] of mutants.txt."""
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "mutants.txt")) as file:
        blocks = file.read().split("\n\n")
    for block in blocks:
        lines = [line for line in block.splitlines() if line and line[0] != "#"]
        if lines:
            yield (lines[0], *["\n".join(_after(sign, lines)) for sign in "-+"])


def _after(sign, lines):
    return [line[2:] for line in lines[1:] if line[0] == sign]


def _is_noticed(name, old, new, worlds):
    """In which words the worlds notice a change, '' where they do not."""
    with tempfile.TemporaryDirectory() as top:
        for part in ("rtshell_lite", "bin", "mock_components", "tests"):
            ignored = shutil.ignore_patterns("__pycache__")
            shutil.copytree(os.path.join(ROOT, part), os.path.join(top, part), ignore=ignored)
        path = os.path.join(top, name)
        with open(path, encoding="utf-8") as file:
            text = file.read()
        if old not in text:
            return "NOT THERE"
        with open(path, "w", encoding="utf-8") as file:
            file.write(text.replace(old, new, 1))
        command = os.path.join(top, "tests", "simulate")
        words = [sys.executable, command, "--seed", SEED, "--worlds", worlds, "-x"]
        done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
    if not done.returncode:
        return ""
    for line in done.stdout.splitlines():
        if line.startswith("  "):
            return line.strip().partition(":")[0]
    return "ends"


if __name__ == "__main__":
    main()
