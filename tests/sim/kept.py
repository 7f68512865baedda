"""What must be so of an rtkeep that keeps processes: what it says of them, and that it starts and ends them
as its Procfile says.
"""

import collections
import json
import os
import re

import faults
import processes
import world as worlds
from users import TIMEOUT

from rtshell_lite.net import real
from rtshell_lite.system import policy
from rtshell_lite.system.processes import UNKNOWN

SLACK = 0.3  # seconds
TICK = 1e-3  # seconds by which a time since 1970 is rounded, or more
LEFT = 0.1  # seconds after its end in which the kernel ends what is left
LOOKING_UP = 3 * TIMEOUT  # seconds in which it sees whether somebody else has started one
AN_END = 0.5  # seconds of an rtkeep that has nothing to wait for
CLEANING = 6.0
UNSEEN = faults.OF_NETWORK | {"no_names", "empty_names"}  # with which one may not be seen that is there
STOP = f"rtkeep stop --of {processes.FILE}"
WORDS = {real.SIGKILL: "SIGKILL", real.SIGTERM: "SIGTERM", real.SIGINT: "SIGINT"}

ROW = re.compile(r"^  (k\d+) .* pid (\d+)$", re.M)
LOGGED = re.compile(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d ")
DISKS = {"fill_disk", "break_disk", "lose_power", "lose_power_in_writing", "wrong_clock"}

Event = collections.namedtuple("Event", "when name seen done")


def keeps(command):
    """Whether a command is an rtkeep that keeps processes."""
    return command.line.startswith(processes.KEEPER)


def ends_in_time(play, command):
    """When it was told, in the time that its processes may take."""
    if not command.is_over:
        return "does not end"
    told = _told(play, command)
    if told is None:
        return None if command.was_killed else f"ends by itself, status {command.status}: {command.error}"
    limit = AN_END + _longest_end(play)
    if play.scenario.faults:
        limit += CLEANING
    took = command.ended - told
    return f"ends {took:.2f} s after it was told, of {limit:.2f}" if took > limit else None


def _told(play, command):
    """When it was told to end, or None."""
    times = [command.interrupted]
    times += [each.begun for each in play.commands if each.line == STOP and each.status == 0]
    return min(filter(None, times), default=None)


def _longest_end(play):
    """Seconds that all may take to end, one after the other at the worst."""
    total = 0.0
    for name, (kind, *_), keys in play.scenario.kept:
        if kind == "stubborn" or any(whom == name for _, _, whom in play.scenario.faults):
            total += _stop(keys)[1]
    return total


def _stop(keys):
    word, seconds = keys.get("stop", "TERM 5").split()
    return getattr(real, "SIG" + word), float(seconds)


def _events(command):
    """What it has told, in order."""
    for line in command.out.splitlines():
        row = json.loads(line)
        if "done" in row:
            yield Event(row["time"] - worlds.BEGIN, row["object"], row["seen"], row["done"])


def tells_the_truth(play, command):
    """What it says of a process was so then."""
    if not keeps(command) or _is_clock_wrong(play):
        return None
    current = {}  # {name: the Program that it has started last}
    components = {name: keys.get("ready") for name, _, keys in play.scenario.kept}
    for event in _events(command):
        words = _doubt(play, event, current, components[event.name])
        if words:
            return f"{event.name}: {event.seen}: {event.done} at {event.when:.3f}: {words}"
    return _doubt_silence(play, command)


def _doubt(play, event, current, component):
    run = current.get(event.name)
    runs = play.robot.runs.get(event.name, [])
    if event.done.startswith("started"):
        pid = int(event.done.split()[-1])
        run = current[event.name] = next((each for each in runs if each.pid == pid), None)
        if run is None or not event.when - SLACK <= run.begun <= event.when + TICK:
            return "it was not"
    elif event.seen.startswith("ended"):
        if run is None:
            return "it was not started"
        if run.ended is None or run.ended > event.when + TICK or event.seen != _how(run):
            return f"it was not: {_how(run)} at {run.ended}"
        del current[event.name]
    elif event.seen.startswith("does not end"):
        if not runs or runs[-1].killed_by != real.SIGKILL:
            return "it was not killed"
    elif event.seen.endswith(UNKNOWN):
        if not faults.OF_NETWORK & {fault for _, fault, _ in play.scenario.faults}:
            return "it does"
    elif event.done in ("ready", "not started"):
        if not play.robot.was_alive(component, event.when - LOOKING_UP, event.when):
            return "nobody is there"
    elif event.seen.startswith("cannot be started") and runs:
        return "it was"
    return None


def _how(run):
    """How a process has ended, in words."""
    if run.ended is None:
        return "it runs"
    if run.status is not None:
        return f"ended with status {run.status}"
    return f"ended by {WORDS[run.killed_by]}"


def _doubt_silence(play, command):
    """What it has not told, or told twice."""
    if _was_hurried(play, command):
        return None
    events = list(_events(command))
    for name, runs in play.robot.runs.items():
        begun = sum(event.name == name and event.done.startswith("started") for event in events)
        if begun != len(runs):
            return f"{name} was started {len(runs)} times, and that is told {begun} times"
        ended = sum(event.name == name and event.seen.startswith("ended") for event in events)
        if ended != sum(run.ended is not None for run in runs):
            return f"{name} has ended {len(runs)} times, and that is told {ended} times"
    return None


def starts_as_it_should(play, command):
    """Each when it should, and no two of one name."""
    if not keeps(command):
        return None
    for name, _, keys in play.scenario.kept:
        runs = play.robot.runs.get(name, [])
        for one, other in zip(runs, runs[1:]):
            if one.ended is None or one.ended > other.begun:
                return f"two of {name} run at {other.begun:.3f}"
        for run in runs:
            found = _doubt_begin(play, run, keys)
            if found:
                return f"{name} is started at {run.begun:.3f}, and {found}"
        steering = _steering(play, name)
        found = _doubt_steered(play, command, runs, steering, keys) if steering else None
        found = found or not steering and _doubt_policy(play, command, name, keys, runs)
        if found:
            return f"{name}: {found}"
    return None


def _doubt_begin(play, run, keys):
    since = run.begun - (LOOKING_UP if "ready" in keys else SLACK)
    for other in keys.get("after", "").split():
        component = next(keys.get("ready") for name, _, keys in play.scenario.kept if name == other)
        if component is not None:
            was_there = play.robot.was_alive(component, since, run.begun)
        else:
            was_there = any(
                each.begun <= run.begun and (each.ended is None or each.ended >= since)
                for each in play.robot.runs.get(other, [])
            )
        if not was_there:
            return f"{other} is not there"
    if not UNSEEN.isdisjoint(fault for _, fault, _ in play.scenario.faults):
        return None
    own = [each.begun for each in play.robot.runs[run.name] if each is not run]
    for life in play.robot.lives.get(keys.get("ready"), ()):
        if life.program.group is not None or life.program.lag:
            continue
        has_name = not any(life.begun - LOOKING_UP < begun < run.begun for begun in own)
        if has_name and life.begun < run.begun - LOOKING_UP and not life.ended_by(run.begun):
            return f"{keys['ready']} is there already"
    return None


def _steering(play, name):
    """[(begun, ended, the verb, or `perhaps` where it may have failed)] of those who have steered a process.
    """
    found = []
    for command in play.commands:
        words = command.line.split()
        if words[:1] == ["rtkeep"] and words[1] in processes.STEERED and words[-1] == name:
            if command.status == 0 and command.interrupted is None:
                found.append((command.begun, command.ended, words[1]))
            else:
                found.append((command.begun, command.ended, "perhaps"))
    return sorted(found)


def _doubt_steered(play, command, runs, steering, keys):
    """What a person has ended stays so until it is resumed."""
    until = [begun for begun, _, _ in steering[1:]] + [_told(play, command) or command.ended]
    for (_, done, verb), end in zip(steering, until):
        if verb in ("stop", "pause"):
            for run in runs:
                if done + SLACK < run.begun < end:
                    return f"it is started {run.begun - done:.2f} s after {verb}"
        latest = done + _stop(keys)[1] + SLACK
        if verb == "stop" and latest < end:
            for run in runs:
                if run.begun < done and (run.ended is None or run.ended > latest):
                    return f"it still runs {latest - done:.2f} s after {verb}"
    return None


def _doubt_policy(play, command, name, keys, runs):
    """Whether it is started again as its policy says."""
    wanted = policy.parse(keys.get("restart"), keys.get("burst"), keys.get("delay"))
    end = _told(play, command) or command.ended
    can_be_late = "after" in keys or any(
        event.name == name and event.done == "not started" for event in _events(command)
    )
    slack = SLACK
    if "ready" in keys and play.scenario.faults:
        slack += LOOKING_UP
    if not runs and not can_be_late and name not in _missing(play) and end - command.begun > slack:
        return "it is not started"
    for number, (run, following) in enumerate(zip(runs, runs[1:] + [None]), 1):
        if run.ended is None or run.ended > end:
            return None
        is_to_start = wanted.restart == "always" or wanted.restart == "on-error" and run.status != 0
        if number > wanted.burst or not is_to_start:
            return following and f"it is started again at {following.begun:.3f}"
        pause = 0 if number == 1 else min(wanted.most, wanted.first * 2 ** (number - 2))
        earliest = run.ended + pause
        latest = run.ended + pause * 1.25 + slack
        if following and following.begun < earliest - TICK:
            return f"it is started again {earliest - following.begun:.2f} s too early"
        if not can_be_late and latest < end and (following is None or following.begun > latest):
            return f"it ended at {run.ended:.3f}, and is not started again at {latest:.3f}"
    return None


def _missing(play):
    return [name for name, (kind, *_), _ in play.scenario.kept if kind == "missing"]


def ends_all(play, command):
    """Nothing outlives it, or the first of its group; those that others need end last."""
    if not keeps(command) or not command.is_over:
        return None
    for leader, child in play.robot.families:
        if child.ended is None or child.ended > leader.ended + LEFT:
            return f"a child of {leader.name} outlives it"
    last = {}
    for name, runs in play.robot.runs.items():
        last[name] = runs[-1]
        if any(run.ended is None or run.ended > command.ended + LEFT for run in runs):
            return f"{name} outlives it"
    for name, _, keys in play.scenario.kept:
        for other in keys.get("after", "").split():
            ended = [last[each].ended for each in (name, other) if each in last]
            if len(ended) < 2 or _was_hurried(play, command):
                continue
            number, _ = _stop(keys_of(play, other))
            was_told = last[other].killed_by == number != real.SIGKILL
            if was_told and ended[0] > ended[1] > (_told(play, command) or command.ended):
                return f"{other} ends before {name}"
    return None


def keys_of(play, name):
    """What its Procfile says of a process."""
    return next(keys for each, _, keys in play.scenario.kept if each == name)


def _was_hurried(play, command):
    """Whether it was killed, or told again to end."""
    return command.was_killed or command.interrupted not in (None, _told(play, command))


def lists_the_truth(play, command):
    """A process that `rtkeep status` shows as running runs."""
    if command.line != "rtkeep status":
        return None
    for name, pid in ROW.findall(command.out):
        run = next((each for each in play.robot.runs[name] if each.pid == int(pid)), None)
        is_over = run is None or run.ended is not None and run.ended < command.begun - TICK
        if is_over or run.begun > command.ended:
            return f"{name} has another pid than {pid}"
    return None


def logs_all(play, command):
    """What processes print is in their logs, whole, but for what a disk does not take."""
    if not keeps(command) or "--log" not in command.line:
        return None
    can_fail = command.was_killed or not DISKS.isdisjoint(fault for _, fault, _ in play.scenario.faults)
    for name, (kind, *_), _ in play.scenario.kept:
        lines = []
        if os.path.exists(name + ".log"):
            with open(name + ".log", encoding="utf-8", newline="\n") as file:
                lines = file.read().split("\n")
        wrong = [line for line in lines[:-1] if not LOGGED.match(line)]
        if wrong:
            return f"{name}.log: {wrong[0]!r}"
        said = sum(processes.SAID in line for line in lines)
        if not can_fail and kind in ("brief", "family") and said != len(play.robot.runs.get(name, ())):
            return f"{name} was started {len(play.robot.runs[name])} times, and its log has {said} lines"
    return None


def _is_clock_wrong(play):
    return any(fault == "wrong_clock" for _, fault, _ in play.scenario.faults)
