"""Starting and stopping a system: a plan carried out on running components, in parallel where nothing orders them."""
import collections
import time

from rtshell_lite import errors
from rtshell_lite.corba import lanes, pool
from rtshell_lite.robot import component, ports, transitions
from rtshell_lite.system import capture, plan, sites, steps
from rtshell_lite.text import printable

TICK = 1.0  # seconds that the main thread sleeps at most

# What became of an action: `outcome` is one of plan.DONE …, `error` an errors.Error that says why, None where all is well.
Result = collections.namedtuple("Result", "action outcome error")

# The execution contexts of a component: their handles in the order in which -e counts, and how many of them it owns.
_Contexts = collections.namedtuple("_Contexts", "handles owned")

# What is asked of a component before anything starts.
_Answer = collections.namedtuple("_Answer", "node profile contexts")


class Run:
    """A plan being carried out."""

    def __init__(self, actions, transition, progress, wait=None):
        """`progress` is called on the caller's thread: starting(action, line), ended(Result), skipped(Result).

        `wait`: how long a component may take to reach its state, in seconds (default: the timeout).
        """
        self.actions, self.transition, self.progress = actions, transition, progress
        self.wait = wait or lanes.session.timeout
        self._found = {}  # for each component of the profile, by its id(): (node, _Contexts or None) or an error
        self._asked = set()  # numbers of the actions whose component may have been asked to change
        self._calls = pool.Calls()
        self._schedule = plan.Schedule(actions, transition.target)

    # ---- before anything is changed ----

    def check(self, profile, tell=lambda line: None):
        """Find the components and their contexts, and check that they are those of the profile.

        Returns the errors of required components: after any of these, nothing is to be started. `tell` is called with a line
        for each of them.
        """
        failures = []
        for wanted, answer in zip(profile.components, self._look(profile, _ask)):
            if wanted.is_required:
                tell("Checking for required component %s with ID \"%s\" and instance name \"%s\"" % (
                    capture.shown_path(wanted), printable(wanted.id), printable(wanted.instance_name)))
            try:
                self._found[id(wanted)] = self._checked(wanted, answer)
            except errors.Error as e:
                self._found[id(wanted)] = e
                failures += [e] if wanted.is_required else []
        return failures

    def refuse(self):
        """Report each action as failed in `check`, or as not tried because a required one has failed."""
        for action in self.actions:
            found = self._found[id(action.component)]
            if isinstance(found, errors.Error):
                self.progress.ended(Result(action, plan.FAILED, found))
            else:
                error = errors.NotTried(action.path, "something that is required failed")
                self.progress.skipped(Result(action, plan.NOT_TRIED, error))

    def _checked(self, wanted, answer):
        """(node, _Contexts) of a component of the profile. Raises WrongKind, NoSuch, or `answer` if that is an error."""
        if isinstance(answer, errors.Error):
            raise answer
        steps.Present(sites.Site(wanted)).is_done([answer])
        for action in self.actions:
            if action.component is wanted:
                _context(answer.node, answer.contexts, action)
        return answer.node, answer.contexts

    def find(self, profile):
        """Find the components; their contexts are asked for when it is their turn."""
        for wanted, answer in zip(profile.components, self._look(profile, lambda node: node)):
            self._found[id(wanted)] = answer if isinstance(answer, errors.Error) else (answer, None)

    def _look(self, profile, function):
        """capture.look; when an exception interrupts it, all actions are reported as not tried."""
        interrupted = True
        try:
            answers = capture.look(profile, function)
            interrupted = False
        except errors.Error:  # nobody can be asked at all
            interrupted = False
            raise
        finally:
            if interrupted:
                self._leave()
        return answers

    # ---- doing it ----

    def carry_out(self):
        """Do all actions. When an exception interrupts it, nothing more begins, and actions that have not ended are reported."""
        try:
            while True:  # see interrupts
                if self._schedule.is_over():
                    break
                now = time.monotonic()
                for action, reason in self._schedule.due(now):
                    if reason is None:
                        self._start(action)
                    else:
                        self.progress.ended(Result(action, plan.NOT_TRIED, errors.NotTried(action.path, reason)))
                self._listen(self._schedule.next_time(now))
        finally:
            self._leave()

    def _start(self, action):
        found = self._found[id(action.component)]
        if isinstance(found, errors.Error):
            self._begin(action)
            self._end(self._failed(action, found))
            return
        node, contexts = found
        self._calls.start(node.endpoint, action.number, lambda: self._change(action, node, contexts))

    def _begin(self, action):
        self.progress.starting(action, plan.plain_line(action, self.transition.name.capitalize()))

    def _listen(self, until):
        """Wait until an action begins or ends, and note it; no longer than `until`."""
        seconds = TICK if until is None else min(TICK, max(0, until - time.monotonic()))
        while not self._schedule.is_over():
            event = self._calls.ended(seconds)
            if event is None:
                return
            number, value = event
            if isinstance(value, Result):
                self._end(value)
            elif value == "begun":
                self._begin(self._schedule.actions[number])
            elif value == "told":
                self._schedule.told(number)
            seconds = 0  # take what else has happened by now

    def _end(self, result):
        self._schedule.end(result.action.number, result.outcome)
        self.progress.ended(result)

    def _leave(self):
        """Report the actions that have not ended."""
        begun = self._calls.close()
        if not self._schedule.is_over():
            self._listen(time.monotonic())
        for action in self.actions:
            if action.number in self._schedule.ended:
                continue
            if action.number in begun & self._asked:
                error = errors.Uncertain(action.path, "interrupted")
                self._end(Result(action, plan.UNCERTAIN, error))
            else:
                self._end(Result(action, plan.NOT_TRIED, errors.NotTried(action.path, "interrupted")))

    # ---- one action, on a thread of pool.Calls ----

    def _change(self, action, node, contexts):
        """Take a component through the transition, and return the Result."""
        def change():
            index = _context(node, contexts or _contexts(node), action)
            has_changed = transitions.change_as_planned(node, self.transition, index, self.wait, stage)
            return plan.DONE if has_changed else plan.ALREADY

        def stage(name):
            self._asked.add(action.number)
            self._calls.post(action.number, name)
        self._calls.post(action.number, "begun")
        try:
            return Result(action, lanes.ask(node.endpoint, str(node.path), change), None)
        except errors.Unreachable as e:
            if action.number in self._asked:
                return self._seen(action, node, e)
            return self._failed(action, e)
        except errors.Error as e:
            return self._failed(action, e)

    def _seen(self, action, node, failure):
        """The Result of an action whose answer was lost: the component may have changed, so look."""
        def state():
            return component.seen(transitions.state_as_planned.task(node, self.transition, self.wait))
        where = failure.where
        why = str(failure)[len(where) + 2:]
        try:
            now = lanes.ask(node.endpoint, str(node.path), state)
        except (errors.Gone, errors.ConnectionRefused, errors.Refused) as e:
            return self._failed(action, e)
        except errors.Error:
            return Result(action, plan.UNCERTAIN, errors.Uncertain(where, why))
        if now == self.transition.target:
            return Result(action, plan.DONE, None)
        if now not in why:
            failure = errors.Unreachable(where, f"{why}; it is {now} now")
        return self._failed(action, failure)

    def _failed(self, action, error):
        gone = self.transition is transitions.DEACTIVATE and sites.is_gone(error)
        return Result(action, plan.GONE if gone else plan.FAILED, error)


# ---- asking ---------------------------------------------------------------------------------------------------

def _ask(node):
    """The _Answer of a component. Its ports are asked before its profile (protocol rule: see `component.once_more`)."""
    ports.ports(node)
    return _Answer(node, component.profile(node), _contexts(node))


def _contexts(node):
    """The _Contexts of a component."""
    owned, participating = component.context_refs(node)
    return _Contexts([node.call("get_context_handle", ref) for ref in owned + participating], len(owned))


def _context(node, contexts, action):
    """The number, as -e counts, of the execution context that an action means. Raises NoSuch."""
    if action.context.isdigit():
        if int(action.context) in contexts.handles:
            return contexts.handles.index(int(action.context))
    elif action.place < contexts.owned:  # some files give names to contexts
        return action.place
    handles = ", ".join(str(handle) for handle in sorted(contexts.handles)) or "none"
    raise errors.NoSuch(str(node.path), "execution context", f"{printable(action.context)} (it has {handles})")
