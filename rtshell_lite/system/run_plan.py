"""Starting and stopping a system: a plan carried out on running components,
in parallel where nothing orders them.
"""

import collections

from rtshell_lite import errors
from rtshell_lite.corba import session
from rtshell_lite.net import loop
from rtshell_lite.robot import component, ports, transitions
from rtshell_lite.system import capture, outcomes, plan, placements, steps
from rtshell_lite.text import printable

AT_ONCE = 4  # components of one process that are changed at a time: each is asked often until it has changed

# What became of an action: `status` is one of outcomes.DONE …, `error` an errors.Error that says why, None
# where all is well.
Result = collections.namedtuple("Result", "action status error")

# The execution contexts of a component: their handles in the order in which -e counts, and how many of them
# it owns.
_Contexts = collections.namedtuple("_Contexts", "handles owned")

# What is asked of a component before anything starts.
_Answer = collections.namedtuple("_Answer", "node profile contexts")


class Progress:
    """Keeps the `results` of the actions of a plan that have ended; a subclass shows how they proceed."""

    def __init__(self):
        self.results = []

    def starting(self, action, line):
        """An action begins, described by `line`."""

    def ended(self, result):
        """An action has ended, or will not be tried."""
        self.results.append(result)

    def skipped(self, result):
        """An action will not be tried, for a reason that has been reported."""


class Run:
    """A plan being carried out."""

    def __init__(self, actions, transition, progress, wait=None):
        """`progress`: a Progress, or what has its methods.

        `wait`: how long a component may take to reach its state, in seconds (default: the timeout).
        """
        self.actions = actions
        self.transition = transition
        self.progress = progress
        self.wait = wait or session.current().timeout
        # for each component of the profile, by its id(): (node, _Contexts or None) or an error
        self._found = {}
        self._asked = set()  # numbers of the actions whose component may have been asked to change
        # by endpoint: (action, node, contexts) that are due
        self._waiting = collections.defaultdict(collections.deque)
        self._busy = collections.Counter()  # by endpoint: how many are being changed
        self._changed = loop.Bell()  # rings when something may be due
        self._schedule = plan.Schedule(actions, transition.target)
        self._is_wanted = lambda action: True

    # ---- before anything is changed ----

    async def check(self, profile, on_required=lambda line: None):
        """Find the components and their contexts, and check that they are those of the profile.

        Returns the errors of required components: after any of these, nothing is to be started. `on_required`
        is called with a line for each of them.
        """
        failures = []
        for described, answer in zip(profile.components, await self._look(profile, _ask)):
            if described.is_required:
                where = capture.shown_path(described)
                on_required(
                    'Checking for required component %s with ID "%s" and instance name "%s"'
                    % (where, printable(described.id), printable(described.instance_name))
                )
            try:
                self._found[id(described)] = await self._checked(described, answer)
            except errors.Error as e:
                self._found[id(described)] = e
                if described.is_required:
                    failures += [e]
        return failures

    def refuse(self):
        """Report each action as failed in `check`, or as not tried because a required one has failed."""
        for action in self.actions:
            answer = self._found[id(action.component)]
            if isinstance(answer, errors.Error):
                self.progress.ended(Result(action, outcomes.FAILED, answer))
            else:
                error = errors.NotTried(action.path, "something that is required failed")
                self.progress.skipped(Result(action, outcomes.NOT_TRIED, error))

    async def _checked(self, described, answer):
        """(node, _Contexts) of a component of the profile.
        Raises WrongKind, NoSuch, or `answer` if that is an error.
        """
        if isinstance(answer, errors.Error):
            raise answer
        await steps.Present(placements.Placement(described)).is_done([answer])
        for action in self.actions:
            if action.component is described:
                _context(answer.node, answer.contexts, action)
        return answer.node, answer.contexts

    async def find(self, profile):
        """Find the components; their contexts are asked for when it is their turn."""
        for described, answer in zip(profile.components, await self._look(profile, _unasked)):
            self._found[id(described)] = answer if isinstance(answer, errors.Error) else (answer, None)

    def take(self, nodes, ended, is_wanted):
        """Have only the actions done whose components are in `nodes`, {id of a model.Component: Node};
        `ended` is {number: status} of all others. is_wanted(action) says of one that is about to begin
        whether it still is to.
        """
        self._is_wanted = is_wanted
        for number, status in ended.items():
            self._schedule.end(number, status)
        self._found = {key: (node, None) for key, node in nodes.items()}

    async def _look(self, profile, function):
        """capture.ask_each; when an exception interrupts it, all actions are reported as not tried."""
        interrupted = True
        try:
            answers = await capture.ask_each(profile, function)
            interrupted = False
        except errors.Error:  # nobody can be asked at all
            interrupted = False
            raise
        finally:
            if interrupted:
                self._leave()
        return answers

    # ---- doing it ----

    async def carry_out(self):
        """Do all actions. When an exception interrupts it, nothing more begins,
        and actions that have not ended are reported.
        """
        try:
            async with loop.Group() as group:
                while not self._schedule.is_over():
                    now = loop.now()
                    for action, reason in self._schedule.due(now):
                        if reason is None:
                            self._start(action, group)
                        else:
                            error = errors.NotTried(action.path, reason)
                            self.progress.ended(Result(action, outcomes.NOT_TRIED, error))
                    await self._wait(self._schedule.next_time(now))
        finally:
            self._leave()

    async def _wait(self, until):
        """Wait until an action begins or ends; no longer than `until`, by loop.now(), or None."""
        if self._schedule.is_over():
            return
        seconds = None if until is None else max(0, until - loop.now())
        await self._changed.wait(seconds)

    def _start(self, action, group):
        answer = self._found[id(action.component)]
        if isinstance(answer, errors.Error):
            self._begin(action)
            self._end(self._failed(action, answer))
            return
        node, contexts = answer
        self._waiting[node.endpoint].append((action, node, contexts))
        if self._busy[node.endpoint] < AT_ONCE:
            self._busy[node.endpoint] += 1
            group.start(self._work(node.endpoint), node.endpoint)

    async def _work(self, endpoint):
        """Change components of a process, one after the other, while any is due."""
        waiting = self._waiting[endpoint]
        while waiting:
            action, node, contexts = waiting.popleft()
            if self._is_wanted(action):
                self._begin(action)
                self._end(await self._change(action, node, contexts))
            else:
                self._end(Result(action, outcomes.NOT_TRIED, errors.NotTried(action.path, "it is paused")))
        self._busy[endpoint] -= 1

    def _begin(self, action):
        self.progress.starting(action, plan.plain_line(action, self.transition.name.capitalize()))

    def _end(self, result):
        self._schedule.end(result.action.number, result.status)
        self._changed.ring()
        self.progress.ended(result)

    def _leave(self):
        """Report the actions that have not ended."""
        for action in self.actions:
            if action.number in self._schedule.ended:
                continue
            if action.number in self._asked:
                error = errors.Uncertain(action.path, "interrupted")
                self._end(Result(action, outcomes.UNCERTAIN, error))
            else:
                self._end(Result(action, outcomes.NOT_TRIED, errors.NotTried(action.path, "interrupted")))

    # ---- one action ----

    async def _change(self, action, node, contexts):
        """Take a component through the transition, and return the Result."""

        def stage(name):
            self._asked.add(action.number)
            if name == "accepted":
                self._schedule.accepted(action.number)
                self._changed.ring()

        try:
            index = _context(node, contexts or await _contexts(node), action)
            has_changed = await transitions.change_as_planned(node, self.transition, index, self.wait, stage)
            return Result(action, outcomes.DONE if has_changed else outcomes.ALREADY, None)
        except errors.Unreachable as e:
            if action.number in self._asked:
                return await self._seen(action, node, e)
            return self._failed(action, e)
        except errors.Error as e:
            return self._failed(action, e)

    async def _seen(self, action, node, failure):
        """The Result of an action whose answer was lost: the component may have changed, so look."""
        where = failure.where
        why = failure.why
        if session.current().silence(node.endpoint):
            return Result(action, outcomes.UNCERTAIN, errors.Uncertain(where, why))
        asked = transitions.state_as_planned(node, self.transition, self.wait)
        try:
            now = await component.uncertain_if_refused(asked)
        except (errors.Gone, errors.ConnectionRefused, errors.Refused) as e:
            return self._failed(action, e)
        except errors.Error:
            return Result(action, outcomes.UNCERTAIN, errors.Uncertain(where, why))
        if now == self.transition.target:
            return Result(action, outcomes.DONE, None)
        if now not in why:
            failure = errors.Unreachable(where, f"{why}; it is {now} now")
        return self._failed(action, failure)

    def _failed(self, action, error):
        is_stopped = self.transition is transitions.DEACTIVATE and placements.is_gone(error)
        return Result(action, outcomes.GONE if is_stopped else outcomes.FAILED, error)


# ---- asking ----


async def _unasked(node):
    return node


async def _ask(node):
    """The _Answer of a component. Its ports are asked before its profile (docs/protocol.md 1.1)."""
    await ports.ports(node)
    return _Answer(node, await component.profile(node), await _contexts(node))


async def _contexts(node):
    owned, participating = await component.context_refs(node)
    handles = [await node.call("get_context_handle", ref) for ref in owned + participating]
    return _Contexts(handles, len(owned))


def _context(node, contexts, action):
    """The number, as -e counts, of the execution context that an action means. Raises NoSuch."""
    if action.context.isdigit():
        if int(action.context) in contexts.handles:
            return contexts.handles.index(int(action.context))
    elif action.context_index < contexts.owned:  # some files give names to contexts
        return action.context_index
    handles = ", ".join(map(str, sorted(contexts.handles))) or "none"
    why = f"{printable(action.context)} (it has {handles})"
    raise errors.NoSuch(str(node.path), "execution context", why)
