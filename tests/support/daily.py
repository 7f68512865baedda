"""What tests/run without arguments runs: some minutes of tests, on other days others. RTSHELL_SEED says which day's."""
import os
import time
import zlib

import transcripts

# One in so many tests of a long module
PARTS = {"commands/test_completion": 8, "commands/test_examples": 16, "commands/test_packaging": 3, "commands/test_remedies": 10,
         "commands/test_restore": 12, "commands/test_rtsh": 3, "commands/test_rttop": 8, "commands/test_tour": 3,
         "mocks/test_composites": 5, "mocks/test_data_ports": 8, "mocks/test_faulty": 5, "mocks/test_managers": 5,
         "mocks/test_mocks": 5, "mocks/test_observers": 5, "mocks/test_worlds": 8, "unit/test_answers": 6, "unit/test_api": 3,
         "unit/test_cli": 3, "unit/test_datalog": 6, "unit/test_documentation": 3, "unit/test_files": 3, "unit/test_fuzz": 3,
         "unit/test_graph": 4, "unit/test_graph_svg": 6, "unit/test_idl": 12, "unit/test_iiop_callers": 3,
         "unit/test_iiop_loop": 3, "unit/test_iiop_silence": 3, "unit/test_lanes": 2, "unit/test_layers": 5, "unit/test_plan": 2,
         "unit/test_profile_limits": 12, "unit/test_run_plan": 8, "unit/test_simpkl": 3, "unit/test_tables": 3,
         "unit/test_transcripts": 3, "unit/test_values": 8, "unit/test_xmlprofile": 4}
OF_FAULTS = 12  # the same of the other modules in faults/
OF_FAILURES = 3  # one in so many of the transcripts about failures
BEGINNING = """Transcripts under one shell and with one ORB, of those about failures and of long test modules a part, chosen by
RTSHELL_SEED=%s: 3 minutes on two quiet cores, 5 on slow ones. A word runs what has it in its name (tests/run rtls), --all
everything; --help says more."""


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
    """What transcripts are played with: each ORB in the run of a day (None: the one that commands choose), else the user's.

    The quicker one has three turns of four.
    """
    return [None, "builtin"] if "RTSHELL_SEED" in os.environ and "RTSHELL_ORB" not in os.environ else [os.environ.get("RTSHELL_ORB")]


def at_once(processors, measures=False):
    """How many jobs run at once, for they wait more than they compute: half as many of those that measure times.

    The parts of a day are short; whole modules, for which there is a limit of time, hinder each other.
    """
    number = (4 if "RTSHELL_SEED" in os.environ else 2) * processors
    return number // 2 if measures else number


def has_turn(path, shell, orb):
    """Is a transcript played so? In the run of a day each is played under one shell and with one ORB, some of those about failures."""
    if "RTSHELL_SEED" not in os.environ:
        return True
    number = zlib.crc32((os.environ["RTSHELL_SEED"] + os.path.basename(path)).encode())
    known, turns = sorted(transcripts.SHELLS), orbs()[:1] + 3 * orbs()[-1:]
    number, chosen_shell = divmod(number, len(known))
    number, chosen_orb = divmod(number, len(turns))
    is_meant = number % OF_FAILURES == 0 or not path.endswith(("-faults.t", "-failures.t"))
    return is_meant and shell == known[chosen_shell] and orb == turns[chosen_orb]
