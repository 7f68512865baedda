"""What tests/run without arguments runs: some minutes of tests, on other days others. RTSHELL_SEED says which day's."""
import os
import time
import zlib

import transcripts

# One in so many tests of a long module
PARTS = {"commands/test_completion": 5, "commands/test_examples": 8, "commands/test_packaging": 3, "commands/test_remedies": 6,
         "commands/test_restore": 6, "commands/test_rttop": 4, "commands/test_tour": 3, "mocks/test_composites": 4,
         "mocks/test_data_ports": 4, "mocks/test_faulty": 3, "mocks/test_managers": 4, "mocks/test_mocks": 3, "mocks/test_observers": 3,
         "mocks/test_worlds": 4, "unit/test_answers": 3, "unit/test_fuzz": 3, "unit/test_graph": 2, "unit/test_graph_svg": 3,
         "unit/test_idl": 4, "unit/test_profile_limits": 6, "unit/test_run_plan": 6, "unit/test_xmlprofile": 2}
OF_FAULTS = 10
BEGINNING = """Each transcript under one shell and with one ORB, of long test modules a part, chosen by RTSHELL_SEED=%s: some 8 minutes
on two quiet cores. A word runs what has it in its name (tests/run rtls), --all everything; --help says more."""


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


def orbs():
    """What transcripts are played with: each ORB in the run of a day (None: the one that commands choose), else the user's."""
    return [None, "builtin"] if "RTSHELL_SEED" in os.environ and "RTSHELL_ORB" not in os.environ else [os.environ.get("RTSHELL_ORB")]


def has_turn(path, shell, orb):
    """Is a transcript played so? In the run of a day each is under one shell and with one ORB, else under all."""
    if "RTSHELL_SEED" not in os.environ:
        return True
    number = zlib.crc32((os.environ["RTSHELL_SEED"] + os.path.basename(path)).encode())
    known = sorted(transcripts.SHELLS)
    return shell == known[number % len(known)] and orb == orbs()[number // len(known) % len(orbs())]
