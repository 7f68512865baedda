"""The order in which a system starts and stops: a section of an RtsProfile as a plan, and who may go when.

The conditions mean what they mean in rtshell (rtshell 4.2, plan.py). Components without a condition come
first, all at once. Those with a sequence number alone follow in its order, each number when the one before
has ended. Then the clock starts for all others: they wait for their time (Wait), until another component is
in its state (Sync), or until another one has accepted the command (After), at most as long as the condition's
timeout. Nothing here calls a component or reads a clock.
"""

import collections

from rtshell_lite import errors
from rtshell_lite.system import capture
from rtshell_lite.system.outcomes import NOT_TRIED, REACHED
from rtshell_lite.text import printable

# One component to be taken through a transition in one of its contexts. `context` is the context's id in the
# file, and `context_index` its index there; `path` the component's, spelt for the terminal. Of its
# conditions: `order`, the smallest sequence number (None: it has no condition), `wait` (milliseconds, None:
# it has none), `after` (Afters), `texts` as they are shown.
Action = collections.namedtuple(
    "Action", "number component context context_index path required order wait after texts"
)

# That an action waits for the action `number`: with `sync` until that one has reached its state, else until
# its component has accepted the command. `timeout` in milliseconds, 0: as long as it takes.
After = collections.namedtuple("After", "number sync timeout text")

# `actions` in the order of their numbers, from 1; `notes` are lines on what is odd in the file, and harmless.
Plan = collections.namedtuple("Plan", "actions notes")


# ---- from a profile to a plan ----


def make(profile, section, name, start=True):
    """The Plan of the `section` (activation, deactivation) of a profile; `name` is its file in messages.

    In a plan that is to `start` a system, required components come first, and what waits for one depends on
    it. Raises errors.Failed with all that is wrong: circles, names that the file does not have,
    contradictions.
    """
    actions = _actions(profile, start)
    targets = _Targets(profile, actions)
    conditions = {action.number: [] for action in actions}
    sending = getattr(profile, section)
    if sending is not None:
        for condition in sending.targets:
            for number in targets.of(condition.target):
                conditions[number].append(condition)
    notes = []
    planned = [_with_conditions(action, conditions[action.number], targets, notes) for action in actions]
    contradictions = [
        line for action in planned for line in _contradictions(action, conditions[action.number])
    ]
    problems = targets.problems + contradictions + list(_circles(planned))
    if problems:
        why = "; ".join(dict.fromkeys(problems))
        raise errors.Failed(printable(name), f"{section.capitalize()}: {why}")
    if start:
        notes += _optional_before_required(planned)
    return Plan(planned, list(dict.fromkeys(notes)))


def _actions(profile, start):
    """An Action without conditions for each context of each component;
    a component that lists none has one.
    """
    components = sorted(profile.components, key=lambda component: start and not component.is_required)
    actions = []
    for component in components:
        ids = [context.id or str(index) for index, context in enumerate(component.execution_contexts)]
        path = capture.shown_path(component)
        required = start and component.is_required
        for index, context in enumerate(ids or ["0"]):
            number = len(actions) + 1
            actions += [Action(number, component, context, index, path, required, None, None, (), ())]
    return actions


class _Targets:
    """Finds the actions that a condition names; `problems` are lines on those that could not be found."""

    def __init__(self, profile, actions):
        self.problems = []
        self._locate = capture.locator(profile)
        self._actions = {}
        self._alike = {}
        for action in actions:
            self._actions.setdefault(id(action.component), []).append(action)
        for component in profile.components:
            self._alike.setdefault((component.id, component.instance_name), []).append(component)

    def of(self, target):
        """Numbers of the actions: one, or all of a component whose context is not named;
        [] after a problem.
        """
        component = self._locate(target)
        called = f"{printable(target.instance_name)} ({printable(target.component_id)})"
        if component is None:
            self.problems.append(f"{called} is not in the file")
            return []
        alike = self._alike.get((target.component_id, target.instance_name), [])
        if len(alike) > 1 and not target.property(capture.PATH_ID):
            paths = " or ".join(capture.shown_path(component) for component in alike)
            self.problems.append(f"{called} may be {paths} (the property {capture.PATH_ID} decides)")
            return []
        actions = self._actions[id(component)]
        numbers = [action.number for action in actions if target.id in ("", action.context)]
        if not numbers:
            context = printable(target.id)
            self.problems.append(f"{actions[0].path} has no execution context {context} in the file")
        return numbers


def _with_conditions(action, conditions, targets, notes):
    """An Action with what the conditions aimed at it say."""
    waits = []
    after = []
    texts = []
    for condition in conditions:
        order = "Order %d" % condition.sequence
        said = []
        if condition.wait_time is not None:
            waits.append(condition.wait_time.wait_time)
            said.append("%s/Wait %dms" % (order, condition.wait_time.wait_time))
        if condition.preceding is not None:
            sync = condition.preceding.sending_timing.upper() == "SYNC"
            for target in condition.preceding.preceding_components:
                name = printable(target.instance_name)
                text = f"Sync to {name}" if sync else f"After {name}'s action"
                timeout = condition.preceding.timeout
                after += [After(number, sync, timeout, text) for number in targets.of(target)]
                said.append(f"{order}/{text}")
        texts += said or [order]
    for text in dict.fromkeys(text for text in texts if texts.count(text) > 1):
        where = f"{action.path} in execution context {printable(action.context)}"
        notes.append(f"{where} has a condition twice: {text}")
    return action._replace(
        order=min([condition.sequence for condition in conditions], default=None),
        wait=max(waits, default=None), after=tuple(dict.fromkeys(after)), texts=tuple(dict.fromkeys(texts)),
    )


def _contradictions(action, conditions):
    """Lines on conditions of one action that cannot be meant together."""
    where = f"{action.path} in execution context {printable(action.context)}: "
    plain = {
        condition.sequence
        for condition in conditions
        if condition.wait_time is None
        and (condition.preceding is None or not condition.preceding.preceding_components)
    }
    waits = {condition.wait_time.wait_time for condition in conditions if condition.wait_time is not None}
    times = waits | {after.timeout for after in action.after}
    twice = collections.OrderedDict()
    for after in action.after:
        twice.setdefault(after.number, []).append("%s within %dms" % (after.text, after.timeout))
    orders = ["Order %d" % number for number in sorted(plain)]
    for texts in [orders, ["Wait %dms" % number for number in sorted(waits)], *twice.values()]:
        if len(texts) > 1:
            yield where + " contradicts ".join(texts)
    for time in sorted(time for time in times if time < 0):
        yield where + "%dms is not a time" % time


def _circles(actions):
    """A line for each circle of actions that wait for each other."""
    waiting = {action.number: {after.number for after in action.after} for action in actions}
    while True:
        _remove_free(waiting)
        if not waiting:
            return
        way = [min(waiting)]
        while way[-1] not in way[:-1]:
            following = [number for number in waiting[way[-1]] if number in waiting]
            way.append(min(following))
        circle = way[way.index(way[-1]) :]
        yield "these wait for each other: " + " for ".join(actions[number - 1].path for number in circle)
        for number in circle[1:]:
            del waiting[number]


def _remove_free(waiting):
    """Take out, again and again, what waits for nothing in `waiting`, {number: numbers that it waits for}."""
    waited_for = {}
    for number, others in waiting.items():
        for other in others:
            waited_for.setdefault(other, []).append(number)
    free = [number for number in waiting if not any(other in waiting for other in waiting[number])]
    while free:
        gone = free.pop()
        del waiting[gone]
        for number in waited_for.get(gone, []):
            if number in waiting and not any(other in waiting for other in waiting[number]):
                free.append(number)


def _optional_before_required(actions):
    return [
        'action {%d} depends on an optional action: "%s"' % (action.number, after.text)
        for action in actions
        if action.required
        for after in action.after
        if not actions[after.number - 1].required
    ]


def dependents(actions, numbers):
    """The actions that are not tried where those with these numbers fail, in the order to expect."""
    lost = more = set(numbers)
    by_number = {action.number: action for action in actions}
    while more:
        more = {
            action.number
            for action in actions
            if action.number not in lost and any(_depends(action, by_number[number]) for number in more)
        }
        lost = lost | more
    return [action for action in in_order(actions) if action.number in lost - set(numbers)]


def _depends(action, other):
    """Whether an action is not tried where another one fails."""
    is_step = other.required and other.order is not None and not _waits(other)
    if is_step and action.order is not None and other.order < action.order:
        return True
    return any(after.number == other.number and (after.sync or other.required) for after in action.after)


# ---- showing a plan ----


def checks(profile):
    """What is checked before a system starts: a line for each required component."""
    return [
        'Check for required component "%s", "%s" at path %s (Required)'
        % (printable(component.id), printable(component.instance_name), capture.shown_path(component))
        for component in profile.components
        if component.is_required
    ]


def lines(actions, verb):
    """The actions as rtshell shows a plan; `verb` is Activate or Deactivate.
    An empty plan is an empty line.
    """
    lines = []
    for action in in_order(actions):
        conditions = f"[{', '.join(action.texts)}] " if action.texts else ""
        lines.append("{%d} %s%s" % (action.number, conditions, plain_line(action, verb)))
    return lines or [""]


def plain_line(action, verb):
    """An action without its number and its conditions."""
    line = f"{verb} {action.path} in execution context {printable(action.context)}"
    if action.required:
        line += " (Required)"
    return line


def in_order(actions):
    """The actions in the order to expect: in their steps, then those that wait."""
    in_steps = [action for step in _steps(actions) for action in step]
    waiting = [action for action in actions if _waits(action)]
    return in_steps + sorted(waiting, key=lambda action: action.order)


def _waits(action):
    return action.wait is not None or bool(action.after)


def _steps(actions):
    """Lists of actions, each to begin when the one before has ended;
    a composite before its members, which change with it.
    """
    members = {
        (participant.component.component_id, participant.component.instance_name)
        for action in actions
        for participant in action.component.participants
    }
    steps = {}
    for action in actions:
        if not _waits(action):
            is_member = (action.component.id, action.component.instance_name) in members
            order = -1 if action.order is None else action.order
            steps.setdefault((order, is_member), []).append(action)
    return [steps[key] for key in sorted(steps)]


# ---- carrying it out, without doing anything ----


class Schedule:
    """Decides when each action may begin. The caller reports what happens and the time (seconds, of any
    clock).

    ended    {number: status, one of outcomes.DONE …}
    """

    def __init__(self, actions, target):
        """`target` is the state that the actions lead to, for reasons."""
        self.actions = {action.number: action for action in actions}
        self.ended = collections.OrderedDict()
        self.target = target
        self.armed = None  # when the clock of those that wait was started
        self._steps = collections.deque(_steps(actions))
        self._step = []
        self._waiting = [action for action in in_order(actions) if _waits(action)]
        self._accepted = set()
        self._failed = []  # required actions in steps that failed, with an order

    def accepted(self, number):
        """The component of an action has accepted the command."""
        self._accepted.add(number)

    def end(self, number, status):
        """An action has ended."""
        action = self.actions[number]
        self.ended[number] = status
        if status not in REACHED and action.required and action.order is not None and not _waits(action):
            self._failed.append(action)

    def is_over(self):
        """True when every action has ended, or will not be tried."""
        return len(self.ended) == len(self.actions)

    def due(self, now):
        """What is to be done at the time `now`:
        (Action, None) to start it, (Action, reason) when it will not be tried.
        """
        judged_actions = []
        while self._step is not None and all(action.number in self.ended for action in self._step):
            if not self._steps:
                self._step = None
                self.armed = now
                break
            self._step = self._steps.popleft()
            fresh = [action for action in self._step if action.number not in self.ended]
            judged_actions += [self._judged(action, self._obstacle(action)) for action in fresh]
        while self.armed is not None:
            fresh = [action for action in self._waiting if action.number not in self.ended]
            judged = [(action, self._verdict(action, now)) for action in fresh]
            self._waiting = [action for action, verdict in judged if verdict == "wait"]
            new = [self._judged(action, verdict) for action, verdict in judged if verdict != "wait"]
            judged_actions += new
            if all(reason is None for _, reason in new):  # what will not be tried stops others
                break
        return judged_actions

    def _judged(self, action, reason):
        if reason is not None:
            self.end(action.number, NOT_TRIED)
        return action, reason

    def _verdict(self, action, now):
        """None when an action that waits may go, "wait", or the reason why it will never go."""
        reason = self._obstacle(action)
        if reason is not None:
            return reason
        open_ones = [after for after in action.after if not self._holds(after)]
        for after in open_ones:
            if after.timeout and now >= self.armed + after.timeout / 1000:
                goal = self.target if after.sync else "accepted"
                return "%s: not %s within %dms" % (after.text, goal, after.timeout)
        is_early = now < self.armed + (action.wait or 0) / 1000
        return "wait" if open_ones or is_early else None

    def _holds(self, after):
        status = self.ended.get(after.number)
        if after.sync:
            return status in REACHED
        # an action that failed has taken place, too
        return after.number in self._accepted or status is not None

    def _obstacle(self, action):
        """Why an action cannot go: the failure of one that it depends on."""
        for other in self._failed:
            if action.order is not None and other.order < action.order:
                return self._reason("comes after", other)
        for after in action.after:
            other = self.actions[after.number]
            status = self.ended.get(after.number)
            stops = after.sync or other.required or status == NOT_TRIED
            if status is not None and status not in REACHED and stops:
                return self._reason("waits for", other)
        return None

    def _reason(self, how, other):
        failed = "was not tried" if self.ended[other.number] == NOT_TRIED else "failed"
        return f"it {how} {other.path}, which {failed}"

    def next_time(self, now):
        """The next time after `now` at which something may be due by itself, None if nothing may."""
        if self.armed is None:
            return None
        afters = [after for action in self._waiting for after in action.after]
        delays = [action.wait or 0 for action in self._waiting]
        delays += [after.timeout for after in afters if after.timeout and not self._holds(after)]
        times = [self.armed + delay / 1000 for delay in delays]
        return min([time for time in times if time > now], default=None)
