"""What must be so of commands that look again and again."""

import json
import re

import faults

STATES = {"INACTIVE": "Inactive", "ACTIVE": "Active", "ERROR": "Error"}
SEEN = 0.7  # seconds that a state lasts that rtwatch, which looks five times a second, has seen
UNKNOWN = ("Unknown", None)  # in a table, in JSON
ROW = re.compile(r"(Inactive|Active|Error|Created) .*?([*?~]?)(C\d+)\.rtc$")
RATE = re.compile(r"([\d.]+) Hz .*/(C\d+)\.rtc:out$")
HERTZ = 17, 23  # of an out port that sends every 50 ms
MARGIN = 0.05
CATCHES_UP = 7.0  # seconds after which what was silent has been asked again
EVENT = re.compile(r"^\[(?:(C\d+)\.rtc )?[\d.]+\] \S+ (\w+)$", re.M)  # one of a single component names none


def pages_are_true(play, command):
    """What rttop shows was so at a moment while it ran."""
    if command.name != "rttop":
        return None
    for name, state, kind in _rows(command):
        states = play.robot.states(name, command.begun - MARGIN, command.ended)
        is_in_reach = play.robot.was_well(name, command.begun, command.ended) and not _is_far(play)
        if state in UNKNOWN and not is_in_reach:  # there was no answer in time
            continue
        if kind == "component" and state not in states:
            return f"{name} is shown as {state}, and was {sorted(states)}"
        if kind == "zombie" and not play.robot.was_gone(name, command.begun, command.ended):
            return f"{name} lives"
    for name, state in {name: state for name, state, _ in _rows(command)}.items():  # as seen last
        is_well = play.robot.was_well(name, command.ended - CATCHES_UP, command.ended)
        if state in UNKNOWN and is_well and not _is_far(play):
            return f"{name} is still unknown"
    is_calm = not play.scenario.faults and len(play.commands) == 1 and play.scenario.active
    for rate, name in RATE.findall(command.out):
        if is_calm and command.interrupted is None and not HERTZ[0] <= float(rate) <= HERTZ[1]:
            return f"{name} sends at {rate} Hz"
    return None


def _rows(command):
    """(name, state, kind) of the components that are shown."""
    for line in command.out.splitlines():
        found = ROW.match(line)
        if found:
            yield found.group(3), found.group(1), "zombie" if found.group(2) == "*" else "component"
        elif line.startswith("{"):
            row = json.loads(line)
            if re.match(r"C\d+", row.get("name") or ""):
                yield row["name"].partition(".")[0], row["state"], row["kind"]


def events_are_true(play, command):
    """What rtwatch reports has happened, and what has lasted is reported."""
    if command.name != "rtwatch":
        return None
    watched = re.findall(r"C\d+", command.line)
    told = {(name or watched[0], STATES.get(word)) for name, word in EVENT.findall(command.out)}
    for name, state in told:
        # it reports a state just before it is in it
        if state and state not in play.robot.states(name, command.begun - MARGIN, command.ended + MARGIN):
            return f"{name} has not been {state}"
    if command.interrupted is not None or command.status != 0 or "-n" in command.line:
        return None
    for name in watched:
        if not play.robot.was_well(name, command.begun, command.ended) or _is_far(play):
            continue
        last = play.robot.lives[name][-1]
        states = last.component.states if last.component is not None else []
        # Created, it is in a context that it has just been taken into; what it was before is no news then
        history = [(since, state) for since, state in states if state != "Created"]
        befores = [""] + [state for _, state in history]
        for before, (since, state), (until, _) in zip(befores, history, history[1:] + [(command.ended, "")]):
            if before != state and command.begun + SEEN < since and min(until, command.ended) - since > SEEN:
                if (name, state) not in told:
                    return f"{name} has become {state} at {since:.3f}, and nobody is told"
    return None


def _is_far(play):
    """Whether the network may have held questions up."""
    return any(fault in faults.OF_NETWORK for _, fault, _ in play.scenario.faults)
