"""What tests/run without arguments runs: some minutes of tests, on other days others. RTSHELL_SEED says which day's."""
import os
import time
import zlib

import transcripts

# One in so many tests of a long module
PARTS = {"commands/test_examples": 4, "commands/test_completion": 3, "commands/test_packaging": 3, "commands/test_rttop": 2,
         "unit/test_fuzz": 3, "unit/test_profile_limits": 2}
OF_FAULTS = 3
BEGINNING = """Each transcript under one shell, of long test modules a part, chosen by RTSHELL_SEED=%s: some 5 minutes on two quiet
cores. A word runs what has it in its name (tests/run rtls), --all everything; --help says more."""


def choose(wanted):
    """Choose the tests of the day and say so, unless the user has chosen (`wanted`)."""
    if wanted:
        os.environ.pop("RTSHELL_SEED", None)
    else:
        os.environ.setdefault("RTSHELL_SEED", time.strftime("%Y%m%d"))
        print(BEGINNING % os.environ["RTSHELL_SEED"], flush=True)


def part(module):
    """Which tests of a module have their turn, as report.py takes it; "" for all."""
    number, seed = PARTS.get(module, OF_FAULTS if module.startswith("faults/") else 1), os.environ.get("RTSHELL_SEED")
    return "%d %s" % (number, seed) if seed and number > 1 else ""


def shells(path):
    """The shells under which a transcript runs: one in the run of a day, else all."""
    known, seed = sorted(transcripts.SHELLS), os.environ.get("RTSHELL_SEED")
    return [known[zlib.crc32((seed + os.path.basename(path)).encode()) % len(known)]] if seed else known
