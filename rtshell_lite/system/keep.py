"""Keeping a system as its RtsProfile says: look, compare, mend, wait until something happens.

What has changed is noticed by events/presence.py. Only that is looked at again, by the steps of restore.py, and
started by the plan of the file.

What hangs is left alone: its neighbours look hung, too, and a second process of a name makes things worse
(docs/protocol.md 5a). So is what a person has done: a component that went from Active to Inactive without an
Error, a value, a set or a rate that was as the file has it, a connection that differs in its id alone.
"""

import collections
import time

from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.events import presence
from rtshell_lite.net import loop
from rtshell_lite.robot import component, ports, snapshot, transitions
from rtshell_lite.system import apply, capture, connect_steps, plan, policy, restore, run_plan, sites, steps
from rtshell_lite.text import shell_word

PAUSE = 0.15  # seconds between a change and the look at it: who disconnects does it port by port
TICK = 0.1  # seconds between looks whether all is done
WAIT = 1.0  # seconds until what a neighbour holds up is asked again
FAREWELL = 2.0  # seconds until a component that has exited is created again: its end takes its name along
MINUTE = 60.0

# What is looked at again, by the part of a component that has changed; WHOLE is everything.
PARTS = collections.OrderedDict(
    [
        ("ports", {"ports": snapshot.FULL}),
        (
            "contexts",
            {
                "owned": snapshot.FULL,
                "participating": snapshot.BRIEF,
                "states": snapshot.FULL,
                "organisations": snapshot.FULL,
            },
        ),
        ("configuration", {"configuration": snapshot.FULL}),
        ("state", {"states": snapshot.FULL}),
    ]
)
WHOLE = "whole"
PART_OF = {
    "EC_EVENT": "contexts",
    "PORT_EVENT": "ports",
    "CONFIG_EVENT": "configuration",
    "RTC_STATUS": "state",
}
# The part that shows whether a step of a kind is done.
SHOWN_BY = {
    "connect": "ports",
    "disconnect": "ports",
    "configuration": "configuration",
    "active set": "configuration",
    "rate": "contexts",
    "participants": "contexts",
    "members": "contexts",
}
BY_HAND = ("configuration", "active set", "rate")  # steps whose opposite a person may want
STATE = "state"  # in place of the key of a step

# `create`, `manager` and `strict_path` as in restore.Options. `strict`: undo what a person did, too; `look`:
# see presence.Presence; `watch`: whether changes are to be noticed later; `policy` for components without
# their own.
Options = collections.namedtuple("Options", "create manager strict_path strict look watch policy")


class Happening(collections.namedtuple("Happening", "time object seen done seconds error")):
    """What has happened: when (seconds since 1970), to which object, what was seen, what was done about it (""
    for nothing), how many seconds that took, and the errors.Error that says why it failed, or None.
    """

    __slots__ = ()

    def as_dict(self):
        """For JSON."""
        return dict(self._asdict(), error=str(self.error) if self.error else None)

    def line(self):
        """For people."""
        clock = time.strftime("%H:%M:%S", time.localtime(self.time))
        return f"[{clock}] {self.object}: " + ": ".join(filter(None, (self.seen, self.done)))


class Kept(presence.Followed):
    """One component that is kept.

    site      its sites.Site; `site.error` says why nothing can be done with it
    changed   parts that are to be looked at again: of PARTS, or WHOLE; not before `due`, by time.monotonic()
    settled   keys of steps, and STATE, that were as in the file when last looked at
    hands     {key: what a person has done}
    said      {key: the errors.Error that was reported}
    state     its state, absent, or hung; since `since`, seconds since 1970
    trial     the policy.Trial of its state, `repairs` that of everything else
    last      the last Happening of it in words, `restarts` how often it has come back
    """

    def __init__(self, site, keeper):
        super().__init__(site.path)
        self.where = site.where
        self.site = site
        self.keeper = keeper
        self.policy = policy.of(site.component, keeper.options.policy)
        self.trial = policy.Trial(self.policy)
        self.repairs = policy.Trial(self.policy)
        self.changed = set()
        self.settled = set()
        self.hands = {}
        self.said = {}
        self.state = "absent"
        self.since = time.time()
        self.restarts = 0
        self.last = ""
        self.is_busy = self.is_paused = self.has_failed = self.has_exited = self.has_been_there = False
        self.is_counted = False  # whether its present Error is among the failures of its trial
        self.waits_for = None  # why its activation was not tried
        # False for one whose state is nobody's business here
        self.is_started = site.component.property(policy.PREFIX + "state") != "any"
        self.due = 0.0

    @property
    def is_usable(self):
        """Whether something can be done with it."""
        return self.is_there and self.site.error is None and self.site.found is not None

    def become(self, state):
        """Note its state."""
        if state != self.state:
            self.state = state
            self.since = time.time()

    def change(self, *parts):
        """Have parts of it looked at again."""
        self.changed.update(parts)
        self.due = max(self.due, time.monotonic() + PAUSE)
        self.keeper.bell.ring()

    def as_dict(self):
        """For `rtkeep status`."""
        return {
            "kind": "component",
            "object": self.where,
            "wanted": self._wanted(),
            "state": self.state,
            "since": self.since,
            "restarts": self.restarts,
            "last": self.last,
            "by_hand": sorted(self.hands.values()),
            "given_up": self.trial.given_up or self.repairs.given_up,
        }

    def _wanted(self):
        if self.is_paused:
            return "paused"
        return "Active" if self.is_started else "any"

    def take_back(self):
        """Let it be kept again, whatever a person has done."""
        self.is_paused = False
        self.settled.clear()
        self.hands.clear()
        self.said.clear()
        self.trial.begin_again()
        self.repairs.begin_again()
        if self.is_there:
            self.change(WHOLE)

    def begin_again(self):
        """Something about it has changed: what was given up is tried again."""
        for trial in (self.trial, self.repairs):
            if trial.given_up and not self.is_busy:
                trial.begin_again()
                self.change(*PARTS)

    # ---- what is noticed ----

    def appeared(self):
        if self.has_been_there:
            self.restarts += 1
        self.has_been_there = True
        self.site.node = self.shown.node
        self.site.error = self.site.found = None
        for notes in (self.settled, self.hands, self.said):
            notes.clear()
        self.trial.begin_again()
        self.repairs.begin_again()
        if self._may_come_back():
            self.has_failed = False
            self.change(WHOLE)
        else:
            self.site.error = errors.Failed(self.where, f"is back; its policy is {self.policy.restart}")
            self.keeper.complain(self, WHOLE, self.site.error)

    def _may_come_back(self):
        """Whether its policy lets it be restored after a restart."""
        if self.restarts == 0 or self.policy.restart == "always":
            return True
        return self.policy.restart == "on-error" and not self.has_exited

    def vanished(self, seen):
        self.site.node = self.site.found = None
        self.site.error = self.error
        self.changed.clear()
        self.has_exited = seen == "has exited"
        self.become("absent")
        self.keeper.happened(self, seen)
        self.keeper.stop_driving(self)

    def hung(self, error):
        self.become("hung")
        self.keeper.happened(self, error.why, "left alone")

    def answered(self):
        self.become("unknown")
        self.keeper.happened(self, "answers again")
        self.change(WHOLE)

    def reported(self, event):
        if event.event == "FINALIZE":
            self.keeper.suspect(self.endpoint)
            return
        if event.event == "ERROR":
            self.has_failed = True
            self.settled.discard(STATE)
        elif event.kind != "RTC_STATUS":
            self.begin_again()
        if event.kind == "EC_EVENT":  # a composite does not report that it has lost a member
            self.keeper.look_at_drivers(self)
        self.change(PART_OF.get(event.kind, WHOLE))

    def seen(self, part):
        self.begin_again()
        self.change(part)


class Keeper(presence.Presence):
    """Keeps a system: `async with Keeper(…) as keeper: await keeper.follow()`.

    tell  called with each Happening
    """

    def __init__(self, profile, planned, options, tell):
        self.profile = profile
        self.options = options
        self.tell = tell
        self.bell = loop.Bell()
        self.actions = planned.actions
        self._locate = capture.locator(profile, options.strict_path)
        listed = restore.places(profile)
        self._site_of = sites.finder(self._locate, listed)
        super().__init__([Kept(site, self) for site in listed], options.look)
        self._kept_of = {id(kept.site): kept for kept in self.followed}
        self._making = {}  # {id of a connector that a task works on: Kepts to be looked at afterwards}
        self._is_ending = False
        self._halves = set()  # ids of connectors of which one end was seen alone

    async def __aenter__(self):
        await super().__aenter__()
        self.start(self._work())
        return self

    async def follow(self):
        """Keep it until the task is cancelled."""
        while True:
            await loop.sleep(MINUTE)
            session.current().sweep()

    async def stop(self, planned, has_teardown):
        """Deactivate the components by a plan, then, with `has_teardown`, remove the connections of the file."""
        self._is_ending = True
        while any(kept.is_busy for kept in self.followed):
            await loop.sleep(TICK)
        kept_here = [kept for kept in self.followed if kept.is_usable and kept.is_started]
        nodes = {id(kept.site.component): kept.shown.node for kept in kept_here}
        gone = [action.number for action in planned.actions if id(action.component) not in nodes]
        results = _Results()
        run = run_plan.Run(planned.actions, transitions.DEACTIVATE, results)
        run.take(nodes, dict.fromkeys(gone, plan.GONE))
        await run.carry_out()
        for result in results.all:
            kept = self._kept_of_component(result.action.component)
            if result.error is None:
                self.happened(kept, "", "Inactive")
            else:
                self.complain(kept, STATE, result.error)
        if has_teardown:
            how = restore.Options(False, None, self.options.strict_path)
            outcomes, _ = await restore.tearing_down(self.profile, how)
            await apply.carry_out(outcomes)

    def named(self, name):
        """The Kept of a path or an instance name, or None."""
        return next((kept for kept in self.followed if name in (kept.where, kept.site.instance)), None)

    async def until_settled(self, seconds):
        """Wait until all is as the file says, for at most `seconds`: whether it is."""
        end = time.monotonic() + seconds
        while not self.is_settled() and time.monotonic() < end:
            await loop.sleep(TICK)
        return self.is_settled()

    def is_settled(self):
        """Whether all is as the file says, as far as is known."""
        return not any(kept.changed or kept.is_busy for kept in self.followed) and not list(self.unsettled())

    def unsettled(self):
        """The errors.Errors that say what is not as the file says; components that are not required count only
        while they are there.
        """
        for kept in self.followed:
            if not kept.is_there and kept.site.required:
                yield kept.error or errors.NotFound(kept.where)
            elif kept.is_there:
                yield from kept.said.values()
                if STATE not in kept.settled and not kept.said:
                    yield errors.Late(kept.where, f"it is {kept.state}")

    def happened(self, kept, seen, done="", begun=None, error=None):
        """Report a Happening of a Kept; `begun` by time.monotonic()."""
        kept.last = ": ".join(filter(None, (seen, done)))
        seconds = 0.0
        if begun is not None:
            seconds = time.monotonic() - begun
        self.tell(Happening(time.time(), kept.where, seen, done, seconds, error))

    def complain(self, kept, key, error):
        """Report a failure, once."""
        if str(kept.said.get(key)) != str(error):
            kept.said[key] = error
            self.happened(kept, error.why, "", None, error)

    # ---- one round of mending ----

    async def _work(self):
        while not self._is_ending:
            waiting = [kept for kept in self.followed if kept.changed and kept.is_there and not kept.is_busy]
            waiting = [kept for kept in waiting if not kept.is_paused]
            now = time.monotonic()
            batch = [kept for kept in waiting if kept.due <= now]
            for kept in batch:
                kept.is_busy = True
            if batch:
                self.start(self._mend(batch))
            due = min([kept.due for kept in waiting if kept.due > now], default=None)
            await self.bell.wait(None if due is None else due - now)

    async def _mend(self, batch):
        """Look at components again, where they have changed, and bring them to what the file says."""
        changed = {id(kept): kept.changed for kept in batch}
        for kept in batch:
            kept.changed = set()
        try:
            answers = await session.each(
                batch, lambda kept: self._look(kept, changed[id(kept)]), lambda kept: kept.place
            )
            for kept, answer in zip(batch, answers):
                if isinstance(answer, errors.Error):
                    await self._not_shown(kept, answer, changed[id(kept)])
            await self._restore([kept for kept in batch if kept.is_usable], changed)
            if not self._is_ending:
                await self._start([kept for kept in batch if kept.is_usable])
        finally:
            for kept in batch:
                kept.is_busy = False
            self.bell.ring()

    async def _look(self, kept, parts):
        shown = kept.shown
        is_whole = WHOLE in parts
        if is_whole:
            await shown.ask(ports=snapshot.BRIEF, profile=snapshot.FULL)
            if self.options.watch:
                await kept.observe()
            shown.profile = shown.profile._replace(properties=[])
        for part, wanted in PARTS.items():
            if is_whole or part in parts:
                await shown.ask(**wanted)
        if kept.shown is not shown:  # it has ended
            return
        kept.site.error = None
        kept.site.found = capture.found_in(shown)
        await restore.presence(kept.site)
        if kept.site.error is not None:
            self.complain(kept, WHOLE, kept.site.error)
            return
        kept.said.pop(WHOLE, None)
        kept.become(component.merged(shown.states))
        if kept.state == "Error":
            kept.has_failed = True
            kept.settled.discard(STATE)

    async def _not_shown(self, kept, error, parts):
        """A look has failed: by whose fault?"""
        kept.changed |= parts
        kept.due = time.monotonic() + WAIT
        if not kept.is_there:
            return
        kept.site.error = error
        session.current().silent.pop(kept.endpoint, None)
        near = [other for _, ends in self._connectors([kept]) for other in ends if other is not kept]
        for other in [kept] + near:
            await self.ask(other)
        hung = sorted({other.where for other in near if other.is_hung})
        if hung:
            error = errors.Unreachable(kept.where, "waits for " + ", ".join(hung))
        if kept.is_there and not kept.is_hung:
            self.complain(kept, WHOLE, error)

    async def _restore(self, batch, changed):
        """Do the steps of rtresurrect that concern what has changed of some Kepts."""
        outcomes = await self._parts(batch, changed)
        begun = time.monotonic()
        connectors = await self._take_connectors(
            [kept for kept in batch if changed[id(kept)] & {WHOLE, "ports"}]
        )
        try:
            connecting = connect_steps.connecting(self.profile, self._site_of, connectors)
            outcomes += self._without_doubt(await restore.connections(connecting))
            outcomes = [outcome for outcome in outcomes if not self._is_by_hand(outcome)]
            await apply.carry_out(outcomes)
        finally:
            self._release(connectors)
        for outcome in outcomes:
            self._judge(outcome, begun)
        for kept in batch:
            if kept.is_there and sites.is_gone(kept.site.error):
                self.suspect(kept.endpoint)

    def _judge(self, outcome, begun):
        """Report what has become of a step."""
        step = outcome.step
        kept = self._kept_of[id(step.sites[0])]
        if outcome.status in (apply.DONE, apply.ALREADY):
            kept.settled.add(_key(step))
            kept.said.pop(_key(step), None)
        if outcome.status == apply.DONE:
            self.happened(kept, "", "restored " + _title(step), begun)
            for other in [self._kept_of[id(site)] for site in step.sites]:
                if other.is_there and other.subscription is None:  # it does not report that
                    other.change(SHOWN_BY[step.kind])
        elif outcome.failed:
            kept.settled.discard(_key(step))
            self.complain(kept, _key(step), outcome.error)
            kept.repairs.fail()
            self._try_later(kept, kept.repairs, SHOWN_BY.get(step.kind, WHOLE))

    @staticmethod
    def _try_later(kept, trial, part):
        if kept.is_there and not trial.given_up:
            kept.change(part)
            kept.due = max(kept.due, trial.until)

    # ---- parts of components ----

    async def _parts(self, batch, changed):
        """The outcomes of steps other than connections."""
        own = [kept for kept in batch if changed[id(kept)] - {"ports", "state"}]
        back = [kept for kept in batch if WHOLE in changed[id(kept)]]
        for kept in self.followed:  # composites have lost a member that is back
            if kept.is_usable and kept not in own and any(self._drives(kept, other) for other in back):
                own.append(kept)
        outcomes = await restore.parts([kept.site for kept in own], self._site_of)
        return [outcome for outcome in outcomes if outcome.step.sites]

    def _drives(self, kept, other):
        """Whether a component executes another one, by the file."""
        of_file = kept.site.component
        targets = [one.component for one in of_file.participants]
        targets += [target for context in of_file.execution_contexts for target in context.participants]
        return any(self._locate(target) is other.site.component for target in targets)

    def look_at_drivers(self, kept):
        """Look again at those that execute a component."""
        for other in self.followed:
            if other.is_there and self._drives(other, kept):
                other.change("contexts")

    def stop_driving(self, kept):
        """A component is gone: those that take part in its contexts stop, and nobody has done that."""
        for other in self.followed:
            if self._drives(kept, other):
                other.settled.discard(STATE)

    def _is_by_hand(self, outcome):
        """Whether a step would undo what a person did; notes what is as in the file."""
        step = outcome.step
        if step.kind not in BY_HAND:
            return False
        key = _key(step)
        kept = self._kept_of[id(step.sites[0])]
        if outcome.status == apply.ALREADY and kept.hands.pop(key, None):
            self.happened(kept, f"{_title(step)} is again as in the file")
        if not outcome.pending or key not in kept.settled or self.options.strict:
            return False
        if key not in kept.hands and not outcome.likely:
            kept.hands[key] = _title(step) + " was changed by hand"
            self.happened(kept, kept.hands[key], "left alone")
        return True

    # ---- connections ----

    def _connectors(self, batch):
        """(connector, the Kepts of its ends) of those of the file with an end on one of some Kepts."""
        for connector in self.profile.connectors:
            listed = [self._site_of(end) for end in connector.ends]
            ends = [self._kept_of[id(site)] for site in listed if site is not None]
            if len(ends) == len(listed) and any(kept in batch for kept in ends):
                yield connector, ends

    async def _take_connectors(self, batch):
        """The connectors of some Kepts whose ports have changed that these do not show as the file has them. No
        other task works on them until `_release`; all of their ends have been asked since.
        """
        taken = []
        for connector, ends in self._connectors(batch):
            if not all(kept.is_usable for kept in ends):
                continue
            if _is_shown(connector, ends, batch):
                ends[0].said.pop(_key_of(connector), None)
            elif id(connector) in self._making:
                self._making[id(connector)] += [kept for kept in ends if kept in batch]
            else:
                self._making[id(connector)] = []
                taken.append((connector, ends))
        asked = list({id(kept): kept for _, ends in taken for kept in ends}.values())
        answers = await session.each(asked, _look_at_ports, lambda kept: kept.place)
        failed = [kept for kept, answer in zip(asked, answers) if isinstance(answer, errors.Error)]
        for kept in failed:
            kept.change("ports")
        self._release([connector for connector, ends in taken if any(kept in failed for kept in ends)])
        return [connector for connector, _ in taken if id(connector) in self._making]

    def _release(self, connectors):
        """Let other tasks work on connectors, and look again at what they wanted to."""
        for connector in connectors:
            for kept in self._making.pop(id(connector)):
                kept.change("ports")

    def _without_doubt(self, outcomes):
        """The outcomes without those of a connection that has just lost an end: somebody may be about to
        connect, or to disconnect. What is half there at the next look, too, is removed.
        """
        removed = {id(outcome.step.connector) for outcome in outcomes if outcome.step.kind == "disconnect"}
        doubtful = removed - self._halves
        self._halves = doubtful
        kept = [outcome for outcome in outcomes if id(outcome.step.connector) not in doubtful]
        for outcome in outcomes:
            if outcome not in kept and outcome.step.sites:
                self._kept_of[id(outcome.step.sites[0])].change("ports")
        return kept

    # ---- components that managers create ----

    async def still_absent(self, absent):
        if not self.options.create:
            return
        now = time.monotonic()
        due = [kept for kept in absent if sites.is_gone(kept.error) and kept.repairs.until <= now]
        due = [kept for kept in due if not kept.repairs.given_up and not kept.is_paused]
        due = [kept for kept in due if time.time() - kept.since > FAREWELL]
        how = restore.Options(True, self.options.manager, self.options.strict_path)
        for kept in due:
            kept.site.error = kept.error
        outcomes = [apply.Outcome(steps.Present(kept.site)) for kept in due]
        outcomes = await restore.creations(self.profile, outcomes, how, self._locate)
        await apply.carry_out(outcomes)
        for kept, outcome in zip(due, outcomes):
            if outcome.status == apply.DONE:
                self.happened(kept, "was not there", "created", now)
            elif outcome.error is not None:
                kept.repairs.fail()
                self.complain(kept, "create", outcome.error)

    # ---- states ----

    async def _start(self, batch):
        """Activate what is not Active, in the order of the plan."""
        todo = []
        for kept in batch:
            if kept.state == "Active" or not kept.is_started:
                self._is_active(kept)
            elif self._may_start(kept):
                todo.append(kept)
        broken = [kept for kept in todo if kept.state == "Error"]
        await session.each(broken, self._reset, lambda kept: kept.place)
        todo = [kept for kept in todo if kept.state != "Error" and kept.is_usable]
        if todo:
            await self._activate(todo)

    def _is_active(self, kept):
        is_new = STATE not in kept.settled
        kept.settled.add(STATE)
        kept.said.pop(STATE, None)
        kept.waits_for = None
        kept.has_failed = kept.is_counted = False
        if kept.hands.pop(STATE, None):
            self.happened(kept, "is Active again")
        for other in self.followed if is_new else ():
            if other.waits_for is not None:
                other.change("state")

    def _may_start(self, kept):
        """Whether a component that is not Active is to be made so now."""
        if STATE in kept.settled and not self.options.strict:
            if STATE not in kept.hands:
                kept.hands[STATE] = f"was made {kept.state} by hand"
                self.happened(kept, kept.hands[STATE], "left alone")
            return False
        if kept.has_failed and kept.policy.restart == "no":
            why = f"is in {kept.state}; its policy is {kept.policy.restart}"
            self.complain(kept, STATE, errors.Failed(kept.where, why))
            return False
        if kept.trial.until > time.monotonic():
            self._try_later(kept, kept.trial, "state")
            return False
        return not kept.trial.given_up

    def _has_failed(self, kept, error):
        """Count a failure of its state; whether that was one too many: then it is given up, and those stop that
        depend on it.
        """
        kept.has_failed = True
        kept.trial.fail()
        if not kept.trial.given_up:
            return False
        self.complain(kept, STATE, errors.Failed(kept.where, f"{error.why}; {kept.trial.why_given_up()}"))
        if kept.site.required:
            self.start(self._stop_dependents(kept))
        return True

    async def _reset(self, kept):
        """Take a component out of Error; how often that is needed is counted."""
        begun = time.monotonic()
        if not kept.is_counted and self._has_failed(kept, errors.Failed(kept.where, "in Error")):
            return
        kept.is_counted = False
        try:
            await self._change(kept, transitions.RESET)
            self.happened(kept, "in Error", "reset", begun)
        except errors.Error as e:
            self.complain(kept, STATE, e)
            self._try_later(kept, kept.trial, "state")

    @staticmethod
    async def _change(kept, transition):
        node = kept.shown.node
        await transitions.change(node, transition, None, session.current().timeout)
        kept.become(transition.target)

    async def _activate(self, todo):
        """Activate components by the actions of the plan; those of the others have ended."""
        ended = {}
        for action in self.actions:
            other = self._kept_of_component(action.component)
            if other not in todo:
                is_reached = other.state == "Active" or other.is_usable and not other.is_started
                ended[action.number] = plan.ALREADY if is_reached else plan.FAILED
        results = _Results()
        run = run_plan.Run(self.actions, transitions.ACTIVATE, results)
        run.take({id(kept.site.component): kept.shown.node for kept in todo}, ended)
        begun = time.monotonic()
        await run.carry_out()
        for kept in todo:
            failed = [one.error for one in results.of(kept.site.component) if one.error is not None]
            self._started(kept, failed, begun)

    def _kept_of_component(self, of_file):
        return next(kept for kept in self.followed if kept.site.component is of_file)

    def _started(self, kept, failed, begun):
        """Judge the actions of one component by the errors.Errors of those that failed."""
        if not kept.is_there:
            return
        if not failed:
            kept.become("Active")
            kept.shown.states = ["Active"]
            self._is_active(kept)
            self.happened(kept, "", "Active", begun)
        elif isinstance(failed[0], errors.NotTried):
            kept.waits_for = failed[0].why
            self.complain(kept, STATE, failed[0])
        elif not self._has_failed(kept, failed[0]):
            kept.is_counted = True
            self.complain(kept, STATE, failed[0])
            self._try_later(kept, kept.trial, "state")

    async def deactivate(self, kept):
        """Deactivate one component, on request."""
        try:
            if kept.is_usable:
                await self._change(kept, transitions.DEACTIVATE)
                self.happened(kept, "", "deactivated on request")
        except errors.Error as e:
            self.complain(kept, STATE, e)

    async def _stop_dependents(self, kept):
        """A required component is given up: deactivate what the plan starts after it, the last first."""
        numbers = {action.number for action in self.actions if action.component is kept.site.component}
        for action in reversed(plan.dependents(self.actions, numbers)):
            other = self._kept_of_component(action.component)
            if not other.is_usable or other.state != "Active":
                continue
            other.settled.discard(STATE)
            begun = time.monotonic()
            try:
                await self._change(other, transitions.DEACTIVATE)
                self.happened(other, f"{kept.where} is given up", "deactivated", begun)
            except errors.Error as e:
                self.complain(other, STATE, e)


class _Results:
    """Collects the Results of a plan."""

    def __init__(self):
        self.all = []

    def of(self, of_file):
        """Those of a model.Component."""
        return [result for result in self.all if result.action.component is of_file]

    def starting(self, action, line):
        """Nothing: the end is reported."""

    def ended(self, result):
        """Keep a Result."""
        self.all.append(result)

    skipped = ended


def _is_shown(connector, ends, batch):
    """Whether those of the ends of a connector that are in the batch show it as the file has it: with its id,
    between the ports that the others had when they were last asked.
    """
    found = [kept.site.port(capture.port_of(end)) for kept, end in zip(ends, connector.ends)]
    if any(isinstance(port, errors.Error) for port in found):
        return False
    wanted = {orb.identity(port.ref) for port in found}
    for kept, port in zip(ends, found):
        same = [one for one in port.connectors if one.id and one.id == connector.connector_id]
        joined = {orb.identity(ref) for one in same for ref in one.ports if ref is not None}
        if kept in batch and joined != wanted:
            return False
    return True


async def _look_at_ports(kept):
    """Have the present ports of a component in what was found of it."""
    now = await ports.ports(kept.shown.node)
    kept.site.found = kept.site.found._replace(ports=ports.in_system(now))


def _key(step):
    """What tells a step from others of its component."""
    if step.kind in ("connect", "disconnect"):
        return _key_of(step.connector)
    return step.kind, getattr(step, "set_id", None) or getattr(step, "handle", None)


def _key_of(connector):
    return "connect", id(connector)


def _title(step):
    """What a step is about, without its component."""
    return step.title.replace(" of " + step.where, "")


async def commands(profile, planned, options):
    """The commands that would bring the system to what the file says now."""
    how = restore.Options(options.create, options.manager, options.strict_path)
    outcomes = await restore.restoring(profile, how)
    found = [outcome.step.command for outcome in outcomes if outcome.pending and not outcome.likely]
    states = dict(zip(map(id, profile.components), await capture.states(profile)))
    for action in plan.in_order(planned.actions):
        state = states.pop(id(action.component), "Active")
        path = shell_word(action.path)
        if state == "Error":
            found += ["rtreset --wait " + path]
        if state in ("Error", "Inactive"):
            found += ["rtact --wait " + path]
    return found
