"""What must be so, whatever happens: judged by the truth of the world after a Play."""

import re

import faults
import kept
import mounted
import recordings
import served
import watching
from users import FILE, KEPT, TIMEOUT

from rtshell_lite.robot import manager

# seconds that a command may take, in timeouts: what rtdoctor's manual promises, and what others take; all of
# them end, whatever hangs
# timeouts; those that change whole systems do it, look again, ask who lives, and look at what comes next
LIMITS = {"rtls": 2, "rtfind": 2, "rtteardown": 4, "rtresurrect": 4}
OTHERS = 3
AT_THE_SAME_TIME = {"rtls", "rtfind", "rtdoctor"}  # the others ask one question after another
ROUND_TRIPS = 5  # whose answers come late, but come
A_PAGE = 1  # s between two of rttop
A_PROFILE = 1  # more for rtdoctor --profile
WAITING = re.compile(r"(?:--wait|--within|-t|--limit) (\d+)")  # seconds more that somebody has asked for
SLACK = 1.0
CLEANING = 6.0  # seconds after a signal
AT_ONCE = 0.5
STATUSES = {0, 1, 3, 4, 5, 6}  # none is typed wrongly
STRUCK = STATUSES | {130, 143}  # by a signal
SOON = 0.3  # seconds after a change, with a period in which it has to last
# what has those in it whose process is called silent
BLAMED = re.compile(r".*its process gave no answer.*|as the process did not answer others \(.*?\)")
PAGES = re.compile(r"-n (\d+)")
NOT_REACHED = re.compile("not (Active|Inactive) within")
STATES = ("Inactive", "Active", "Error", "Created")
LOOKING = {"rtls", "rtcat", "rtfind", "rtdoctor", "rtcryo", "rtec", "rtcheck"}
LOOKING |= {"rtprint", "rtlog", "rtwatch", "rttop", "rtstodot", "rtcall", "rtfsm"}
LOOKING |= {"rtmount", "cat", "ls"}
# commands on a file, and the state that they promise
OF_FILES = {"rtresurrect": "", "rtteardown": "", "rtcheck": "Active", "rtstart": "Active"}
OF_FILES["rtstop"] = "Inactive"
NETWORK = faults.OF_NETWORK | {"no_names", "empty_names"}
# also those who wait for such a process
SILENCING = NETWORK | {"hang", "pause", "lag", "tear", "garble", "seize"}
# after these rtkeep cannot reach all that lives, or the file is about something else
UNKEPT = NETWORK - {"unplug"} | {"halt", "slow_down", "refuse"}
FILE_ALONE = {"rtteardown", "rtstop", "rtresurrect", "rtstart"}  # change whole systems
# seconds in which rtkeep has seen all: 10 turns of three kinds of questions, and pauses until it tries again
SETTLING = {True: 20.0, False: 60.0}
QUICK = 2.5  # seconds in which it has mended a robot that is well
WITHOUT_CONNECTORS = {"rtdel", "rtconf", "rtact", "rtdeact", "rtreset"}
IN_FLIGHT = 4
WAITING_FOR_OTHERS = 2  # of them
BETWEEN = 0.02  # seconds between the questions to the ports of a component and the one for its profile
PROBES = 2  # a second: four of a process that has hung since before it was seen, each time they are given up
# give questions up as they end, and ask others
STAYING = {"rtkeep", "rtlog", "rtprint", "rtwatch", "rttop", "rtmount"}
ROUNDS = 4  # how often a process that does not answer is asked again, by commands that give it the time
VALUE = re.compile(r'(?:\] |"data": )(\d+)')  # as rtprint shows it
SHORT = 2.9  # seconds, in which rtprint -t has not ended
# "status line" of commands that end so where all is well: what is asked for is not so, or was done before
NO_IS_AN_ANSWER = r"1 (rtcheck -s|rtkeep status|rtwatch -n)|3 (rtmgr \S+ -d|rtdel -z C)|6 (rtreset|rtcon) "
NO_IS_AN_ANSWER += r"|1 (echo reset|cat \S+log)"
NO_WHERE_IDLE = NO_IS_AN_ANSWER + "|1 (rtcheck|rtdoctor|rtprint) |6 rtcall "
FETCHED = "is that of a tool which fetches values"  # rtdis leaves it
PULLING = re.compile("--pull|rtdoctor|rttrace|rttop")
IDLE = "none has been started"  # true of a world in which nothing is Active
MARGIN = 0.05  # seconds: an answer was on its way


def judge(play):
    """Add to `failures` what is not as it must be: (name of the oracle, words)."""
    for command in play.commands:
        for name, oracle in ORACLES.items():
            words = oracle(play, command)
            if words:
                play.failures.append((name, f"{command.line}: {words}"))
    for name, oracle in OF_WORLDS.items():
        words = oracle(play)
        if words:
            play.failures.append((name, words))


# ---- of a command ----


def ends(play, command):
    """In the time that is promised."""
    if command.was_killed:
        return None
    if command.name in mounted.TOOLS:
        return served.answers_in_time(play, command)
    if kept.keeps(command):
        return kept.ends_in_time(play, command)
    limit = LIMITS.get(command.name, OTHERS) * TIMEOUT + SLACK
    for seconds in WAITING.findall(command.line):
        limit += int(seconds)
    is_slow = any(name == "slow_network" for _, name, _ in play.scenario.faults)
    if is_slow and command.name not in AT_THE_SAME_TIME:
        limit += ROUND_TRIPS * 2 * faults.SLOW
    if "--profile" in command.line:
        limit += A_PROFILE * TIMEOUT
    if command.name == "rttop":
        limit += A_PAGE * int(PAGES.search(command.line).group(1))
    if command.name == "rtmgr":  # a component is made, and deleted, in its manager's time
        limit += manager.CREATE_TIME
    if not command.is_over:
        return "does not end"
    if command.interrupted is not None:
        limit = CLEANING * (1 + is_slow) if play.scenario.faults else AT_ONCE
        if command.ended - command.interrupted > limit:
            return f"ends {command.ended - command.interrupted:.2f} s after a signal"
    elif command.ended - command.begun > limit:
        return f"takes {command.ended - command.begun:.2f} s of {limit}"
    return None


def is_stable(play, command):
    """No bug of ours shows."""
    if command.program.failure is not None:
        return f"raises {command.program.failure!r}"
    if any(words in command.error for words in ("internal error", "Traceback", "lacks its module")):
        return command.error.strip()
    is_documented = command.status in (STATUSES if command.interrupted is None else STRUCK)
    if command.is_over and not command.was_killed and not is_documented:
        return f"status {command.status}"
    said = re.sub(r"(rtlog: (trigger:|kept)|rtkeep: nothing more goes to the log) .*\n", "", command.error)
    if command.status == 0 and f"{command.name}: " in said and "error" in said:
        return f"status 0, and {command.error.strip()}"
    return None


def waits_before_it_says_so(play, command):
    """Nobody is called silent who has not been given the time."""
    if command.line == "rtkeep status":  # which tells what another one has seen
        return None
    if f"no answer within {TIMEOUT:g}s" in command.error + command.out and command.is_over:
        if command.ended - command.begun < TIMEOUT:
            return f"said after {command.ended - command.begun:.3f} s"
    return None


def is_polite(play, command):
    """A process has few questions to answer at a time, and few more that were given up."""
    for name, most in command.program.most_asked.items():
        troubles = {fault for _, fault, _ in play.scenario.faults}
        do_answer = not SILENCING & troubles
        do_answer = do_answer and "no answer" not in command.error + command.out
        limit = IN_FLIGHT if do_answer else ROUNDS * IN_FLIGHT
        is_in_doubt = NETWORK & troubles or not _was_well(play, name, command)
        if command.name in STAYING and command.status and command.interrupted is None:
            limit += IN_FLIGHT  # it has failed, gives its questions up, and takes back what it has lent
        if command.name in ("rtkeep", "rtmount") and is_in_doubt and command.is_over:
            limit += PROBES * (command.ended - command.begun)  # it asks whether it answers again
        if most > limit and name != "omniNames":
            return f"{most} requests to {name} at a time"
        waiting = command.program.most_waiting.get(name, 0)
        if do_answer and waiting > WAITING_FOR_OTHERS and command.name not in STAYING:
            return f"{waiting} requests that may wait for others to {name} at a time"
    return None


def _was_well(play, process, command):
    """Whether a process, if it has components, has run, and was not stopped, while a command ran."""
    if process not in play.robot.processes:
        return True
    *_, members = play.robot.processes[process]
    return command.is_over and play.robot.was_well(members[0], command.begun, command.ended)


def lists_the_truth(play, command):
    """What rtls shows, and marks, was so at a moment while it ran."""
    if command.name != "rtls" or not command.is_over:
        return None
    is_long = "l" in command.line.partition("-")[2]
    form = r"(\S+)\s.*?([*?~]?)(C\d+)\.rtc$" if is_long else r"()([*?~]?)(C\d+)\.rtc$"
    for line in command.out.splitlines():
        found = re.match(form, line)
        if not found:
            continue
        state, mark, name = found.groups()
        words = _doubt_state(play, command, state, mark, name, is_long)
        if words:
            return f"{line.strip()!r}: {words}"
    return None


def _doubt_state(play, command, state, mark, name, is_long):
    begun = command.begun - MARGIN
    if mark == "*" and not (play.robot.was_gone(name, begun, command.ended) or _is_refused(play)):
        return "it lives"
    if not mark and not play.robot.was_alive(name, begun, command.ended):
        return "it is gone"
    if (mark in ("?", "~") or is_long and state not in STATES) and _is_plain(play, command, name):
        return "it could be asked"
    if mark != "*" and _is_surely_dead(play, command, name):
        return "it is gone"
    if mark == "?" and command.status == 0:
        return "status 0"
    if state in STATES and state not in play.robot.states(name, begun, command.ended):
        return f"it was {sorted(play.robot.states(name, begun, command.ended))}"
    return None


def _is_plain(play, command, name):
    """Whether nothing was between a command and a component."""
    if NETWORK & {fault for when, fault, _ in play.scenario.faults if play.begin + when < command.ended}:
        return False
    return command.interrupted is None and play.robot.was_well(name, command.begun, command.ended)


def _is_surely_dead(play, command, name):
    """Whether its process has ended on the host where a command was typed later, and has given its address:
    a name may mean another host.
    """
    program = play.robot.lives[name][-1].program
    is_over = program.ended is not None and program.ended < command.begun
    if not is_over or program.host.name != play.scenario.seat or command.interrupted is not None:
        return False
    if program.host.name in play.scenario.named:
        return False
    return not NETWORK & {fault for _, fault, _ in play.scenario.faults}


def _is_refused(play):
    return _was_there(play, "close_port")


def _was_there(play, fault):
    return any(name == fault for _, name, _ in play.scenario.faults)


def _was_troubled(play, until):
    is_well = not any(run.begun <= until for runs in play.robot.runs.values() for run in runs)
    return not is_well or any(when <= until for when, _ in play.robot.troubles)


def doctor_is_right(play, command):
    """Nothing alive is called dead; nothing is found in a healthy world; a fault alone is found."""
    if command.name != "rtdoctor" or not command.is_over or command.interrupted is not None:
        return None
    for line in command.out.splitlines():
        found = re.search(r"/(C\d+)\.rtc: dead", line)
        if found and not play.robot.was_gone(found.group(1), command.begun, command.ended):
            return f"{line}: it lives"
    was_changed = any(each.name not in LOOKING for each in play.commands)
    if not was_changed and not _was_troubled(play, command.ended):
        if "--profile" in command.line and not play.scenario.active:
            return None  # they should be Active
        wrong = [line for line in command.out.splitlines() if IDLE not in line]
        if wrong or command.out and play.scenario.active:
            return f"nothing is wrong: {command.out}"
    if len(play.scenario.faults) != 1 or was_changed:
        return None
    when, name, whom = play.scenario.faults[0]
    if whom in play.robot.runs or name in faults.OF_PROCESSES:  # of a process that an rtkeep keeps
        return None
    _, must_be_found = faults.FAULTS[faults.BY_NAME[name]]
    if must_be_found and play.begin + when < command.begun and not command.out:
        return f"{name} {whom} is not found: {command.error}"
    return None


def deletes_the_dead(play, command):
    """rtdel -z deletes each name of a process that has ended on its host."""
    if command.line != "rtdel -z ." or command.status != 0:
        return None
    gone = {name for _, name, _ in play.robot.removed}
    for name in play.robot.lives:
        if name in play.robot.bound - gone and _is_surely_dead(play, command, name):
            return f"status 0, and the name of {name} is left"
    return None


def blames_the_silent(play, command):
    """A process is called silent, and not asked, which has not answered for so long, not one that has only
    been asked what it cannot answer, or by an object that hangs, and has answered others meanwhile.
    """
    if command.interrupted is not None or command.line == "rtkeep status":
        return None
    said = "\n".join(BLAMED.findall(command.error + command.out))
    for name in re.findall(r"C\d+", said):
        if name not in play.robot.lives or not _is_plain(play, command, name):
            continue
        process = play.robot.lives[name][-1].program.name
        silence = command.program.silences.get(process, 0)
        if silence < TIMEOUT - MARGIN:
            return f"{process} has answered {name} within {silence:.3f} s: {said}"
    return None


def calls_the_dead_dead(play, command):
    """Nobody says that it may be a firewall where a process has ended on the same host."""
    for name in re.findall(r"(C\d+)\.rtc[^\n]*dead, or a firewall", command.error + command.out):
        if _is_surely_dead(play, command, name):
            return f"{name} is dead: {command.error}{command.out}"
    return None


def waits_no_longer(play, command):
    """What has been waited for is soon seen."""
    wanted = {"rtact": "Active", "rtreset": "Inactive"}.get(command.name)
    if wanted is None or "--wait" not in command.line or command.status != 0 or not _is_alone(play, command):
        return None
    component = play.robot.lives[command.line.split()[-1]][-1].component
    if _was_troubled(play, command.ended) or component is None:
        return None
    reached = [when for when, state in component.states if state == wanted and when <= command.ended]
    took = command.ended - max([command.begun] + reached)
    return f"ends {took:.3f} s after it was {wanted}" if took > SOON else None


def says_what_is_done(play, command):
    """Active is said of what is Active in its context."""
    wanted = {"rtact": "Active", "rtdeact": "Inactive", "rtreset": "Inactive"}.get(command.name)
    if wanted is None or "--wait" not in command.line or command.status != 0:
        return None
    name = command.line.split()[-1]
    if wanted not in play.robot.states(name, command.begun, command.ended):
        return f"status 0, but it was {sorted(play.robot.states(name, command.begun, command.ended))}"
    return None


def says_why_not(play, command):
    """Where a context is stopped, nobody waits for it, and that is said."""
    if "--wait" not in command.line or not NOT_REACHED.search(command.error):
        return None
    for when, fault, whom in play.scenario.faults:
        if fault != "halt" or whom not in command.line.split() or play.begin + when > command.begun:
            continue
        component = play.robot.living(whom)
        if component is not None and not component.shared and not component.owned[0].running:
            return f"its context is stopped: {command.error}"
    return None


def does_what_can_be_done(play, command):
    """Where nothing has gone wrong, and nobody else changes anything, all can be done."""
    is_calm = command.is_over and command.interrupted is None and not _was_troubled(play, command.ended)
    if not is_calm or command.status == 0:
        return None
    if any(each is not command and each.name not in LOOKING for each in play.commands):
        return None
    answers = NO_IS_AN_ANSWER if play.scenario.active else NO_WHERE_IDLE
    if re.match(answers, f"{command.status} {command.line} "):
        return None
    if FETCHED in command.error and any(PULLING.search(each.line) for each in play.commands):
        return None
    return f"status {command.status}: {command.out}{command.error}"


def ends_what_it_says(play, command):
    """A component is gone, or there, where rtexit or rtmgr ends with status 0."""
    if command.name not in ("rtexit", "rtmgr") or command.status != 0:
        return None
    name = re.search(r"C\d+", command.line).group()
    if "-c" in command.line:
        return None if play.robot.was_alive(name, command.begun, command.ended) else "status 0, and it is not"
    if not play.robot.was_gone(name, command.begun, command.ended):
        return "status 0, and it lives"
    return None


def _parts(play):
    """The names of the components that were there when all was saved."""
    return [name for *_, members in play.scenario.processes for name in members]


def _is_alone(play, command):
    """Whether no other command that changes something ran at the same time."""
    return not any(
        each is not command
        and each.name not in LOOKING
        and each.begun < command.ended
        and each.is_over
        and each.ended > command.begun
        for each in play.commands
    )


def changes_what_it_says(play, command):
    """A connector is there, or gone, and a value is set, where the status is 0."""
    if command.status != 0 or not command.is_over or not _is_alone(play, command):
        return None
    _, *ends = command.line.split()
    names = [word.partition(":")[0] for word in ends if re.match(r"C\d", word)]
    if command.name in OF_FILES:
        names = _parts(play)
    if not all(_is_plain(play, command, name) for name in names):
        return None
    joined = [command.connectors.get(end, set()) for end in ends if end[0] == "C"]
    if command.name == "rtcon" and not joined[0] & joined[1]:
        return "status 0, and no connector"
    if command.name == "rtdis":
        return _doubt_parting(play, command, ends)
    if command.name in OF_FILES:
        return _doubt_system(play, command)
    # of a component that wavers, another set may have been the active one
    if command.name == "rtconf" and "set" in ends and not _was_there(play, "waver"):
        if command.gains.get(names[0]) != ends[-1]:
            return f"status 0, and gain is {command.gains.get(names[0])}"
    return None


def _doubt_parting(play, command, ends):
    """What is left though rtdis of a component, or of a port of it, has ended with status 0."""
    own = [end for end in command.connectors if end == ends[0] or end.startswith(ends[0] + ":")]
    if any(command.connectors[end] for end in own):
        return "status 0, and a connector is left"
    lost = {each for end in own for each in command.before.get(end, ())}
    refusing = {whom for _, fault, whom in play.scenario.faults if fault == "refuse"}
    for end, connectors in command.connectors.items():
        name, _, _ = end.partition(":")
        if connectors & lost and name not in refusing and _is_plain(play, command, name):
            return f"status 0, and {end} still has a connector"
    return None


def _doubt_system(play, command):
    """What is not so though a command on the file of the robot has ended with status 0."""
    joined = []
    for source, target in play.scenario.connections:
        both = command.connectors.get(f"{source}:out", set()) & command.connectors.get(f"{target}:in", set())
        joined.append(bool(both))
    if command.name in ("rtresurrect", "rtcheck") and not all(joined):
        return "status 0, and a connection is missing"
    if command.name == "rtteardown" and any(joined):
        return "status 0, and a connection is left"
    wanted = "Inactive" if "-s Inactive" in command.line else OF_FILES[command.name]
    for name in _parts(play):
        if wanted and wanted not in play.robot.states(name, command.begun, command.ended):
            return f"status 0, and {name} was not {wanted}"
    return None


def is_kept(play, command):
    """rtkeep has brought all that can be mended to what the file says, in the time that its manual promises,
    and has undone nothing that a person has done.
    """
    if command.name != "rtkeep" or not _has_stayed(command):
        return None
    if command.status != 0:
        return f"status {command.status} after {command.ended - command.begun:.0f} s"
    troubles = {fault for _, fault, _ in play.scenario.faults}
    if troubles & UNKEPT or not FILE_ALONE.isdisjoint(each.name for each in play.commands):
        return None
    begun = command.ended - SETTLING[("--look" in command.line)]
    well = {name for name in _parts(play) if play.robot.was_well(name, begun, command.ended)}
    for pair in play.scenario.connections:
        if not well.issuperset(pair):  # ports that ask far ends wait for those that hang
            well -= set(pair)
    changing = [each for each in play.commands if each.name not in LOOKING | {"rtkeep"}]
    touched = {}
    if "--strict" not in command.line:
        is_early = any(each.begun < command.begun + QUICK for each in changing)
        if play.scenario.faults or len(changing) > 1 or is_early:
            well -= _named(play, changing)
        else:
            touched = _by_hand(play, command)
            well -= _named(play, [each for each in changing if each.status != 0])  # done in part, perhaps
    for name in sorted(well):
        states = play.robot.states(name, command.ended, command.ended)
        if states != {touched.get(name, {}).get("state", "Active")}:
            return f"{name} is {sorted(states)}"
        gain = touched.get(name, {}).get("gain", "1")
        # what is set is looked for in one turn of seven
        is_sought = not any(each.line.startswith(f"rtconf {name} set") for each in changing)
        if command.gains[name] != gain and (touched or is_sought):
            return f"gain of {name} is {command.gains[name]}"
    for source, target in play.scenario.connections:
        if source in well and target in well:
            ends = command.connectors.get(f"{source}:out"), command.connectors.get(f"{target}:in")
            if not ends[0] & ends[1]:
                return f"{source} is not connected with {target}"
    return None


def blames_people_alone(play, command):
    """rtkeep calls only that the work of a person which a person has done."""
    if command.name != "rtkeep":
        return None
    changing = [each for each in play.commands if each.name not in LOOKING]
    if not FILE_ALONE.isdisjoint(each.name for each in changing):
        return None
    touched = _named(play, changing)
    looking_so = ("waver", "slow_down")  # faults that look like that
    touched |= {name for _, fault, name in play.scenario.faults if fault in looking_so}
    for name, what in re.findall(r"(C\d+)\.rtc: (.* by hand)", command.out):
        if name not in touched:
            return f"{name}: {what}"
    return None


def _has_stayed(command):
    """Whether an rtkeep has kept a system until a signal ended it."""
    if command.line.split()[-1] != FILE or "--once" in command.line or "--dry-run" in command.line:
        return False
    return command.interrupted is not None and command.interrupted - command.begun >= KEPT


def _named(play, commands):
    """The names of the components that commands name, and of those that these execute."""
    return _with_members(play, {name for each in commands for name in re.findall(r"C\d+", each.line)})


def _with_members(play, names):
    """Names, and those of the members of composites among them, who go to the states of these."""
    members = [play.scenario.special[name][1] for name in names if _is_composite(play, name)]
    return set(names).union(*members)


def _is_composite(play, name):
    return play.scenario.special.get(name, [None])[0] == "composite"


def _by_hand(play, keeper):
    """{name: {"state" or "gain": what it is to be}} of what people have done while an rtkeep kept all."""
    done = {}
    for command in play.commands:
        words = command.line.split()
        if command.status == 0:
            if command.name == "rtdeact":
                for name in _with_members(play, words[-1:]):
                    done.setdefault(name, {})["state"] = "Inactive"
            elif command.name == "rtconf" and "set" in words:
                done.setdefault(words[1], {})["gain"] = words[-1]
    return done


def agrees(play, command):
    """rtcheck finds nothing where nothing has changed."""
    is_unchanged = not play.scenario.faults and all(each.name in LOOKING for each in play.commands)
    if command.name != "rtcheck" or "-s" in command.line or command.interrupted is not None:
        return None
    if is_unchanged and play.scenario.active:
        if command.status != 0 or command.out:
            return f"status {command.status}: {command.out}{command.error}"
    return None


def prints_what_was_sent(play, command):
    """Each value that rtprint shows was sent, in this order, and none is left out."""
    if command.name != "rtprint":
        return None
    shown = {}
    for line in command.out.splitlines():
        found = VALUE.search(line)
        if not found:
            return f"{line!r} is no value"
        name = re.search(r"C\d+", line) or re.search(r"C\d+", command.line)
        shown.setdefault(name.group(), []).append(int(found.group(1)))
    for name, numbers in shown.items():
        sent = {}
        for life in play.robot.lives[name]:
            if life.component is not None:
                sent.update(life.component.numbers)
        for number, before in zip(numbers, [None] + numbers):
            if number not in sent or not command.begun <= sent[number] <= command.ended:
                return f"{number} was not sent then"
            if before is not None and number not in (before + 1, *_firsts(play, name)):
                return f"{number} follows {before}"
    if "-n" in command.line and command.status == 0 and command.interrupted is None:
        if command.ended - command.begun < SHORT and len(command.out.splitlines()) != 3:
            return f"{len(command.out.splitlines())} values of 3"
    return None


def answers_what_was_answered(play, command):
    """What a service or a state machine is shown to answer, it has answered; it was asked once."""
    if command.name == "rtfsm" and "getstate" in command.line and command.status == 0:
        return None if command.out == "closed\n" else f"it is closed, not {command.out.strip()}"
    if command.name != "rtcall" or "echo" not in command.line:
        return None
    if command.status == 0 and command.out != "hello\n":
        return f"it said hello, not {command.out.strip()}"
    name = re.search(r"C\d+", command.line).group()
    calls = [each for each in play.commands if each.line == command.line]
    said = 0
    for life in play.robot.lives[name]:
        if life.component is not None:
            said += sum(len(each.echoes) for each in life.component.ports[0].servants)
    done = sum(each.status == 0 for each in calls)
    return None if done <= said <= len(calls) else f"it was called {said} times by {len(calls)}"


def _firsts(play, name):
    return [life.first for life in play.robot.lives[name]]


# ---- of a world ----


def no_live_name_goes(play):
    """rtdel -z removes names of the dead."""
    for when, name, reference in play.robot.removed:
        for life in play.robot.lives.get(name, ()):
            if life.component is not None and _is_same(life.component.reference, reference):
                if life.is_alive(when):
                    return f"{name} was unbound at {when:.3f} s, and lived"
    return None


def _is_same(one, other):
    return one.address[1:] == other.address[1:]


def _far_end_died(play, name, when):
    """Whether the process of one with which a component is connected was killed just before."""
    far_names = {other for ends in play.scenario.connections if name in ends for other in ends}
    programs = [life.program for far in far_names for life in play.robot.lives[far]]
    return any(
        program.is_over and not program.has_crashed and 0 <= when - program.ended < BETWEEN
        for program in programs
    )


def nothing_crashes(play):
    """No process ends by what it is asked, and no mock has a bug.

    Except where a far end dies after the question to a port, and before the one for the profile: no tool can
    prevent that (docs/protocol.md 1.1).
    """
    for name, lives in play.robot.lives.items():
        for program in [life.program for life in lives]:
            if program.has_crashed and not _far_end_died(play, name, program.ended):
                return f"the process of {name} ended at {program.ended:.3f} s by what it was asked"
            if program.failure is not None:
                return f"a mock raises {program.failure!r}"
    return None


def looking_changes_nothing(play):
    """No connector is there that was not, where nobody has connected anything."""
    if not LOOKING | WITHOUT_CONNECTORS >= {each.name for each in play.commands}:
        return None
    after = play.robot.connectors()
    for end, connectors in after.items():
        more = connectors - play.before.get(end, set())
        was_killed = any(each.was_killed for each in play.commands)
        is_out_of_reach = was_killed or _is_refused(play)  # it counts as gone
        if not is_out_of_reach and not all(_is_told(play, each) for each in more):
            return f"{end} has another connector, of which nobody is told"
        if not play.scenario.faults and play.before[end] - connectors:
            return f"{end} has lost a connector"
    return None


def looking_leaves_nothing(play):
    """Where people have only looked at a robot that is well, no observer is left, and nothing is set."""
    was_killed = any(each.was_killed for each in play.commands)
    if play.scenario.faults or was_killed or not LOOKING >= {each.name for each in play.commands}:
        return None
    for name in play.robot.lives:
        component = play.robot.living(name)
        if component is None:  # of a process that rtkeep has ended
            continue
        if component.observers.registered:
            return f"{name} still has {list(component.observers.registered)}"
        settings = component.configuration
        if settings.active != "default" or settings.sets["default"]["gain"] != "1":
            return f"{name} has other settings: {settings.active}, {settings.sets}"
    return None


def _is_told(play, connector_id):
    """Whether a command has said that a connector may stay."""
    return any(connector_id in command.error for command in play.commands)


ORACLES = {
    "ends": ends,
    "stable": is_stable,
    "patient": waits_before_it_says_so,
    "polite": is_polite,
    "true list": lists_the_truth,
    "true finding": doctor_is_right,
    "gone is gone": deletes_the_dead,
    "silent is silent": blames_the_silent,
    "dead is dead": calls_the_dead_dead,
    "soon": waits_no_longer,
    "done is done": says_what_is_done,
    "said why": says_why_not,
    "possible is done": does_what_can_be_done,
    "ended is ended": ends_what_it_says,
    "changed is changed": changes_what_it_says,
    "agrees": agrees,
    "kept": is_kept,
    "not by hand": blames_people_alone,
    "true processes": kept.tells_the_truth,
    "one at a time": kept.starts_as_it_should,
    "nothing outlives": kept.ends_all,
    "true status": kept.lists_the_truth,
    "logged": kept.logs_all,
    "recorded": recordings.is_recorded,
    "true pages": watching.pages_are_true,
    "true events": watching.events_are_true,
    "answers": answers_what_was_answered,
    "values": prints_what_was_sent,
    "stays": served.stays,
    "true files": served.reads_the_truth,
    "lets go": served.lets_go,
    "written": served.writes_what_it_says,
}
OF_WORLDS = {
    "live names": no_live_name_goes,
    "no trace": looking_changes_nothing,
    "nothing left": looking_leaves_nothing,
    "no crash": nothing_crashes,
    "whole files": recordings.is_whole,
}
