"""What is in the files that commands have written, and what must be so of it."""

import collections
import glob
import os
import re
import struct

from rtshell_lite import errors
from rtshell_lite.datalog import logfile
from rtshell_lite.xmlprofile import rtsprofile

SYNC = 1.3  # seconds that a power failure costs: between two fsyncs, and while values are gathered
OF_POWER = {"lose_power", "lose_power_in_writing"}
MARGIN = 0.3  # seconds: a value was on its way
PART = re.compile(r"-\d{6}\.mcap$")
NAMED = re.compile(r"-f (\S+)\.mcap")
SAVED = "saved.rtsys"


def is_recorded(play, command):
    """A recording has what was sent, or says what it lacks, and is whole, also after a power failure."""
    named = NAMED.search(command.line)
    if command.name != "rtlog" or named is None:
        return None
    paths = sorted(glob.glob(f"{named.group(1)}*.mcap"))
    if not paths and command.status in (0, 5):
        return f"status {command.status}, and there is no recording"
    parts = [path for path in paths if path == named.group(1) + ".mcap" or PART.search(path)]
    incidents = [path for path in paths if path not in parts]
    for recording in [parts, *([path] for path in incidents)]:
        words = _doubt_recording(play, command, recording, recording is parts)
        if words:
            return f"{recording}: {words}"
    return None


def _doubt_recording(play, command, paths, is_to_the_end):
    """What is not so of some files, one after another; only a trigger's ends before its command."""
    shown = collections.defaultdict(list)
    has_gaps = command.status == 5
    for path in paths:
        try:
            with logfile.load(path) as log:
                words = _doubt_file(command, log)
                if words:
                    return f"{path}: {words}"
                has_gaps = has_gaps or bool(log.gaps)
                for entry in log.entries():
                    for source in log.channels[entry.channel].sources:  # events have none
                        order = "<" if entry.little else ">"
                        name = re.search(r"C\d+", source).group()
                        shown[name].append(struct.unpack(order + "LLl", entry.data[:12])[2])
        except errors.Failed as e:
            return f"{path} cannot be read: {e}"
    for name, numbers in shown.items():
        words = _doubt_numbers(play, command, name, numbers, has_gaps, is_to_the_end)
        if words:
            return f"{name}: {words}"
    return None


def _doubt_file(command, log):
    if log.damaged:
        return f"{log.damaged} damaged records"
    if command.status in (0, 5) and (log.torn or not log.closed):
        return f"status {command.status}, and it is torn"
    return None


def _doubt_numbers(play, command, name, numbers, has_gaps, is_to_the_end):
    """What is not so of the numbers of one component."""
    sent = {}
    firsts = []
    for life in play.robot.lives[name]:
        firsts.append(life.first)
        if life.component is not None:
            sent.update(life.component.numbers)
    for number, before in zip(numbers, [None] + numbers):
        if number not in sent or not command.begun <= sent[number] <= command.ended:
            return f"{number} was not sent then"
        if before is not None and number not in (before + 1, *firsts) and not has_gaps:
            return f"{number} follows {before}, and nobody says so"
    end = command.ended if command.interrupted is None else command.interrupted
    end -= MARGIN
    if command.was_killed:
        end -= SYNC
    others = {fault for _, fault, _ in play.scenario.faults} - OF_POWER
    is_troubled = others or play.scenario.faults and not command.was_killed
    if has_gaps or not numbers or command.status == 1 or is_troubled or not is_to_the_end:
        return None
    missing = [each for each in sent if each > numbers[-1] and sent[each] < end]
    if missing:
        return f"{missing[0]} is missing, though it was sent {command.ended - sent[missing[0]]:.2f} s before"
    return None


def is_whole(play):
    """A file that is saved again and again is one that was saved, whole, whatever has happened."""
    for path in (SAVED,):
        if not os.path.exists(path):
            continue
        try:
            with open(path, encoding="utf-8") as file:
                rtsprofile.load(file.read(), path)
        except (errors.Error, UnicodeError) as e:
            return f"{path}: {e}"
    if any(each.was_killed for each in play.commands):
        return None
    left = glob.glob(".*.tmp")
    return f"{left[0]} is left" if left else None
