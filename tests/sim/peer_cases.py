"""What commands may say and do of broken peers (mock_components/faulty.py), real and simulated ones."""

import re

import invocations

from mock_components import malice

# These answer, and what they answer may be taken for something.
NAMING = {"hostile", "many", "loop", "bottomless", "branching"}
SANE = NAMING | {"elsewhere-refused", "elsewhere-silent"} | set(malice.CHANGES)
ENDLESS = {"many", "endless", "endless-nothing", "endless-long", "branching"}
LISTS = ["many-contexts", "many-organizations", "many-members"]
# these answer as many questions as are asked, or at great length
TALKATIVE = {"many-ports", "many-ends", "many-connectors", "megabytes", *LISTS}
LIST_LIMIT = 60.0  # seconds for 20,000 names, or for ever more, each of which is asked for and then asked
TALK_LIMIT = 10.0  # seconds for talkative ones
# The doctor promises three times the timeout; what asks one after the other may wait as often, such as
# rtcheck --extra, which asks the components of the file, then all bad peers at once, for their ports and then
# for their profiles. rttrace asks the doctor about the culprit.
PATIENCE = {"rtdoctor": 3, "rttrace": 4, "rtsh": 2}
MOST_SAID = 2 << 20  # characters on stdout and stderr
# times MOST_SAID: 20,000 names are 20,000 lines of JSON
LENGTHY = {"megabytes": 64, "many": 2, "branching": 8, "endless-long": 20}
TOLD = re.compile(r"rt\w+: (/|\d+ of \d+ (did not|not asked|cannot be asked))")
BAD = {4}  # the peer is dead, silent or garbled
# What the status may be besides: the answer of those that look is that the peer is bad, what asks only the
# name server does not notice a bad component, and so on.
ALSO = {role: invocations.statuses(role) for role in ("server", "component")}
LOOKING_AT_LISTS = ["rtwatch -t 1 A", "rtcat -l A", "rtls -l A", "rtec A", "rtact A", "rtdoctor A"]


class Case:
    """A command line, and a peer of a mode as name server or as component, at the path `peer` when it has
    been run; `timeout` in seconds.
    """

    peer = None  # type: str

    def __init__(self, command, line, mode, role, timeout=0.8):
        self.command = command
        self.line = line
        self.mode = mode
        self.role = role
        self.timeout = timeout

    def __str__(self):
        return f"{self.command} {self.line}, {self.mode} as {self.role}"

    def limit(self):
        """Seconds that it may take besides what it computes: what the command line asks for, the timeout."""
        if self.mode in ENDLESS and self.role == "server" and re.search("SERVER|--extra", self.line):
            return LIST_LIMIT
        if self.mode in TALKATIVE:
            return TALK_LIMIT
        return self.usual_limit()

    def usual_limit(self):
        """`limit` for peers that do not answer as many questions as are asked."""
        asked = sum(map(float, re.findall(r"(?:-t|--wait|--measure|--limit)[ =]([\d.]+)", self.line)))
        patience = 3 if "--extra" in self.line else PATIENCE.get(self.command, 1)
        return asked + self.timeout * patience

    def judge(self, status, out, err, count):
        """What is wrong with what it did: its status, the `count` characters that it said, or what is kept of
        them.
        """
        if any("Traceback" in said or "internal error" in said for said in (out, err)):
            yield "a bug"
        if status in (70, 141) or status > 128 or status not in self._allowed():
            yield f"status {status}, not of {sorted(self._allowed())}"
        if count > MOST_SAID * LENGTHY.get(self.mode, 1):
            yield f"{count} characters said"
        told = [line for line in err.splitlines() if TOLD.match(line)]
        if len(set(told)) < len(told):
            yield "told twice"
        about = [line for line in told if self.peer in line]
        if self.mode not in SANE and len(about) > self._most_lines():
            yield f"{len(about)} lines"
        if status not in (0, 1) and not told:
            yield "no line"

    def _allowed(self):
        """What the exit status may be."""
        if self.mode in SANE:
            return {0, 1, 3, 4, 5, 6}
        return BAD | ALSO[self.role].get(self.command, set())

    def _most_lines(self):
        """One line, or one of each command of rtsh, of the component and of its connection, of each way to
        ask a name server.
        """
        return 2 if self.command in ("rtsh", "rtteardown") or "--extra" in self.line else 1


def cases(kind, modes):
    """All of them, each a kind(command, line, mode, role)."""
    lines = sorted(invocations.stated("invocation").items())
    return [
        kind(command, line, mode, role)
        for role in ("server", "component")
        for command, some in lines
        for line in some
        for mode in modes
    ]


def long_lists(kind, **more):
    """Those of lists that must not be asked one by one."""
    lines = [line.partition(" ") for line in LOOKING_AT_LISTS]
    return [kind(command, line, mode, "component", **more) for command, _, line in lines for mode in LISTS]
