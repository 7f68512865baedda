"""What must be so of a mounted tree: of rtmount, and of what people read and write in it."""

import errno
import re
import stat

import faults
import mounted
from users import TIMEOUT

from rtshell_lite.mount import components, liveness, streams, wire

PROMPT = 0.1  # seconds until one who gives up is free
MARGIN = 0.1  # seconds: an answer was on its way
TTL = re.compile(r"--ttl (\S+)")
SLUGGISH = {"halt", "slow_down"}
STORING = (wire.WRITE, wire.FLUSH)
LISTING = (wire.READDIR, wire.READDIRPLUS)
OF_NAMES = {"no_names", "empty_names"}
ENDING_NAMES = OF_NAMES | {"lose_power", "reboot"}
STATES = {"Active": "Active", "Inactive": "Inactive", "reset": "Inactive"}
# what files say where nobody has changed anything
UNCHANGED = {
    "configuration/active": "default\n",
    "configuration/default/gain": "1\n",
    "contexts/0/state": "Running\n",
    "contexts/0/rate": "20\n",
    "ports/in/data_type": "IDL:RTC/TimedLong:1.0\n",
}
GONE = (errno.ENXIO, errno.ECONNREFUSED)
SILENT = (errno.ETIMEDOUT, errno.EHOSTUNREACH)
BROKEN = {"garble", "tear", "break_off"}
# of what cannot be had; of what is not to be done; of an rtmount that has ended meanwhile
UNHEARD = GONE + SILENT + (errno.EIO, errno.ENOENT)
REFUSED = (errno.EPERM, errno.EINVAL)
ENDED = errno.ENOTCONN


def stays(play, command):
    """rtmount serves until a signal ends it, and leaves nothing mounted."""
    if command.name != "rtmount" or command.was_killed or not command.is_over:
        return None
    if command.interrupted is None:
        return f"ends by itself, status {command.status}"
    left = command.program.host.mounts
    return f"{list(left)} is left mounted" if left else None


def answers_in_time(play, command):
    """Each request of a program is answered in time, whatever hangs, and one who gives up is free at once."""
    if not command.is_over:
        return "does not end"
    mounts = [each for each in play.commands if each.name == "rtmount" and each.interrupted is not None]
    is_mount_ending = any(mount.interrupted < command.ended for mount in mounts)  # and all that waits with it
    is_slow = command.interrupted is not None and command.ended - command.interrupted > PROMPT
    if is_slow and not is_mount_ending:
        return f"waits for {command.ended - command.interrupted:.2f} s after a signal"
    for request in command.program.requests:
        limit = _limit(play, command, request)
        if request.ended - request.begun > limit:
            took = request.ended - request.begun
            return f"opcode {request.opcode} at {request.begun:.3f} takes {took:.2f} s of {limit:.2f}"
    return None


def _limit(play, command, request):
    """Seconds that the answer to a request may take."""
    troubles = {fault for _, fault, _ in play.scenario.faults}
    slow = 10 * faults.SLOW if "slow_network" in troubles else 0.0
    is_of_context = request.path == mounted.TREE and request.opcode in LISTING
    if is_of_context and not troubles & (OF_NAMES | faults.OF_NETWORK):
        return liveness.PATIENCE + MARGIN
    if request.opcode in STORING:
        others = [each for each in play.commands if each.name == "echo" and each.begun < request.ended]
        return len(others) * (components.WAIT + 2 * TIMEOUT) + MARGIN + slow
    if command.line.endswith(mounted.STREAMS):  # nothing may ever come
        return command.ended - command.begun
    return 2 * TIMEOUT + MARGIN + slow


def reads_the_truth(play, command):
    """What a file says, and who is listed, was so at a moment between; a failure has a reason."""
    if command.name not in mounted.TOOLS or not command.program.seen:  # nothing was mounted
        return None
    ttl = _ttl(play, command)
    for names, found, begun, ended in command.program.seen:
        words = _doubt(play, command, names, found, begun - MARGIN, ended, ttl)
        if words:
            return f"{'/'.join(names) or mounted.TREE} at {begun:.3f}: {words}"
    return None


def _ttl(play, command):
    """How long its rtmount believes answers, seconds."""
    lines = [each.line for each in play.commands if each.name == "rtmount"]
    given = TTL.search(lines[0])
    return float(given.group(1)) if given else 1.0


def _doubt(play, command, names, found, begun, ended, ttl):
    name = names[0].partition(".")[0] if names else ""
    if isinstance(found, OSError):
        return _doubt_failure(play, command, name, found.errno, begun - ttl, ended)
    if not names:
        return _doubt_list(play, found, begun - ttl, ended)
    if command.name != "cat" or name not in play.robot.lives:
        return None
    text = found.decode()
    file = "/".join(names[1:])
    if file == "state":
        return _doubt_state(play, name, text, begun, ended, ttl)
    if file == mounted.VALUE:
        return _doubt_value(play, name, text, begun, ended)
    is_member = any(name in members for _, members in play.scenario.special.values())
    if is_member and file == "contexts/0/state":  # that of its composite runs
        return None
    if file in UNCHANGED and text != UNCHANGED[file] and _is_unchanged(play):
        return f"is {text!r}"
    return None


def _doubt_state(play, name, text, begun, ended, ttl):
    if {"take", "leave"} & {fault for _, fault, _ in play.scenario.faults}:
        begun -= ttl  # who executes it is asked again then
    states = play.robot.states(name, begun, ended)
    if text not in [state + "\n" for state in states]:
        return f"is {text!r}, and was {sorted(states)}"
    return None


def _doubt_value(play, name, text, begun, ended):
    sent = {}
    for life in play.robot.lives[name]:
        if life.component is not None:
            sent.update(life.component.numbers)
    number = int(text.split()[-1])
    return None if begun <= sent.get(number, -1) <= ended else f"{number} was not sent then"


def _is_unchanged(play):
    changing = {"waver", "halt", "slow_down"}
    if changing & {fault for _, fault, _ in play.scenario.faults}:
        return False
    return not any(each.name in ("rtconf", "echo", "rtkeep", "rtresurrect") for each in play.commands)


def _doubt_failure(play, command, name, code, begun, ended):
    refusing = {whom for _, fault, whom in play.scenario.faults if fault == "refuse"}
    may_refuse = command.name == "echo" or command.line.endswith("log")  # it may be of an old OpenRTM
    if code in REFUSED and (may_refuse or name in refusing):
        return None
    servers = [each for each in play.commands if each.name == "rtmount"]
    if code == ENDED and all(each.ended is not None and each.ended <= ended for each in servers):
        return None
    if command.name == "echo" and SLUGGISH & {fault for _, fault, _ in play.scenario.faults}:
        return None  # the state is not reached in time
    words = errno.errorcode.get(code, str(code))
    if code not in UNHEARD:
        return words
    if not name:
        return None if _is_far(play, ended) else words
    asked = list(play.robot.lives)  # ports may ask other ends
    if "state" in command.line:  # a process in which one hangs may be taken to hang
        asked = [each for each in asked if _process(play, each) is _process(play, name)]
    if name in play.robot.lives and all(_is_plain(play, each, begun, ended) for each in asked):
        return f"{words}: it could be asked"
    may_be_names = ENDING_NAMES & {fault for _, fault, _ in play.scenario.faults}
    if code in GONE and not (may_be_names or _is_refused(play) or play.robot.was_gone(name, begun, ended)):
        return f"{words}: it lives"
    if code == errno.EIO and not BROKEN & {fault for _, fault, _ in play.scenario.faults}:
        if not play.robot.was_gone(name, begun, ended):
            return f"{words}: nothing was broken"
    return None


def _doubt_list(play, found, begun, ended):
    """Who is listed without ever having been bound, or in a wrong way, and who is not."""
    gone = {name for _, name, _ in play.robot.removed}
    for file, mode in found.items():
        name = file.partition(".")[0]
        if name not in play.robot.bound:
            return f"{file} was never bound"
        if name not in play.robot.lives:
            continue
        if stat.S_ISLNK(mode) and not (_is_refused(play) or play.robot.was_gone(name, begun, ended)):
            return f"{file} lives"
        if stat.S_ISDIR(mode) and _is_surely_dead(play, name, begun):
            return f"{file} is gone"
    if _is_far(play, ended):
        return None
    for name in play.robot.lives:
        if name not in gone and _is_plain(play, name, begun, ended) and f"{name}.rtc" not in found:
            return f"{name} is not listed"
    return None


def _is_far(play, ended):
    """Whether the network, or the name server, may have been in the way."""
    for when, fault, _ in play.scenario.faults:
        if fault in OF_NAMES | faults.OF_NETWORK and play.begin + when < ended:
            return True
    return False


def _process(play, name):
    return play.robot.lives[name][-1].program if name in play.robot.lives else None


def _is_plain(play, name, begun, ended):
    return not _is_far(play, ended) and play.robot.was_well(name, begun, ended)


def _is_surely_dead(play, name, begun):
    """Whether its process had ended, on the host of the mount, before a listing."""
    program = play.robot.lives[name][-1].program
    is_over = program.ended is not None and program.ended < begun
    # the name of its host may mean another one
    is_near = program.host.name == play.scenario.seat and program.host.name not in play.scenario.named
    return is_over and is_near and not _is_far(play, float("inf"))


def _is_refused(play):
    return any(fault == "close_port" for _, fault, _ in play.scenario.faults)


def lets_go(play, command):
    """Nothing is left in a component of a reader who waited for what it sends, and is gone."""
    others = {each.name for each in play.commands} - {"rtmount", *mounted.TOOLS}
    if play.scenario.faults or not command.line.endswith(mounted.STREAMS):
        return None
    name = re.search(r"C\d+", command.line).group()
    until = command.ended + mounted.LEFT
    for each in play.commands:
        if each is not command and name in each.line and each.begun < until and each.ended > command.ended:
            return None
    left = [each for each in command.left.get(name, ()) if each == streams.NAME or not others]
    return f"{name} still has {left} after {mounted.LEFT} s" if left else None


def writes_what_it_says(play, command):
    """What was written, and answered with success, has happened."""
    if command.name != "echo" or command.status != 0 or not command.program.seen:
        return None
    ((names, _, begun, ended),) = command.program.seen
    word = command.line.split()[1]
    name = names[0].partition(".")[0]
    if names[1:] == ["state"] and STATES[word] not in play.robot.states(name, begun, ended):
        return f"done, and {name} was {sorted(play.robot.states(name, begun, ended))}"
    if names[-1] == "gain" and command.gains.get(name, word) != word:
        others = [each for each in play.commands if each.name in ("rtconf", "rtkeep", "rtresurrect")]
        return None if others else f"done, and gain is {command.gains[name]}"
    return None
