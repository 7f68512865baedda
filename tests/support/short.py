"""What tests/run without arguments runs: the same every time, in about 5 minutes on two quiet cores.

Each command's own transcript, every fourth of the transcripts about one side of a command, and one in N tests
of a module that says PART = N. A transcript is played under one shell and with one ORB.
"""
import os
import zlib

import transcripts

OF_SIDES = 4  # every fourth of the transcripts about one side of a command, such as rtls-aliases.t
OF_OMNIORB = 4  # every fourth transcript is played with omniORB, the others with our own ORB
BEGINNING = """Each command's transcript, some of the others, a part of the long test modules: about 5 minutes on two quiet cores.
A word runs what has it in its name (tests/run rtls), --all everything; --help says more."""  # noqa: E501


def choose(wanted):
    """Choose the short run and say so, unless the user has chosen (`wanted`)."""
    os.environ.pop("RTSHELL_SHORT", None)
    if not wanted:
        os.environ["RTSHELL_SHORT"] = "1"
        print(BEGINNING, flush=True)


def is_chosen():
    """Whether this is the short run."""
    return "RTSHELL_SHORT" in os.environ


def orbs():
    """What transcripts are played with: each ORB in a short run (None: the one that commands choose), else
    the user's.
    """
    return (
        [None, "omniorb"]
        if is_chosen() and "RTSHELL_ORB" not in os.environ
        else [os.environ.get("RTSHELL_ORB")]
    )


def at_once(processors, measures=False):
    """How many jobs run at once, for they wait more than they compute: half as many of those that measure
    times.

    Parts are short; whole modules, for which there is a limit of time, hinder each other. With more jobs
    everything takes longer, as many of them wait in busy loops.
    """
    number = (3 if is_chosen() else 2) * processors
    return number // 2 if measures else number


def has_turn(path, shell, orb):
    """Is a transcript played so?"""
    if not is_chosen():
        return True
    number = zlib.crc32(os.path.basename(path).encode())
    known = sorted(transcripts.SHELLS)
    turns = orbs()[-1:] + (OF_OMNIORB - 1) * orbs()[:1]
    number, chosen_shell = divmod(number, len(known))
    number, chosen_orb = divmod(number, len(turns))
    is_meant = number % OF_SIDES == 0 or "-" not in os.path.basename(path)
    return is_meant and shell == known[chosen_shell] and orb == turns[chosen_orb]
