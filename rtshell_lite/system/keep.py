"""Keeping a system as its RtsProfile says: look, compare, mend, wait until something happens.

What has changed is noticed by live/follow.py. Only that is looked at again, by the steps of restore.py,
and started by the plan of the file.

What hangs is left alone: its neighbours look hung, too, and a second process of a name makes things worse
(docs/protocol.md 5a). So is what a person has done: a component that went from Active to Inactive without an
Error, a value, a set or a rate that was as the file has it, a connection that differs in its id alone.
"""

import collections

from rtshell_lite import errors
from rtshell_lite.corba import session
from rtshell_lite.live import ask, follow, times
from rtshell_lite.net import loop
from rtshell_lite.robot import component, transitions
from rtshell_lite.system import apply, capture, happening, plan, reconnect, restore, run_plan
from rtshell_lite.system import placements, steps
from rtshell_lite.system.kept import BRIEF, FULL, PARTS, STATE, WAIT, WHOLE, KeptComponent
from rtshell_lite.system.matter import AGREED, BY_HAND, UNKNOWN
from rtshell_lite.system.outcomes import ALREADY, DONE, FAILED, GONE

TICK = 0.1  # seconds between looks whether all is done
FAREWELL = 2.0  # seconds until a component that has exited is created again: its end takes its name along
MINUTE = 60.0
ROUND = 10  # turns, at most, until a process has been asked all questions of a kind
STATES = 5  # that a process is asked for at a time: what a person does is to be seen before an Error hides it

# `create`, `manager` and `strict_path` as in restore.Options. `strict`: undo what a person did, too; `look`:
# see follow.Presence; `watch`: whether changes are to be noticed later; `policy` for components without
# their own.
Options = collections.namedtuple("Options", "create manager strict_path strict look watch policy")


class Keeper(follow.Presence):
    """Keeps a system: `async with Keeper(…) as keeper: await keeper.follow()`.

    on_event    called with each happening.Happening
    before  the Keeper of an earlier reading of the same file, which has ended, or None
    """

    # states soonest, for Error
    asks = {ask.states: 1, ask.connections: 1, ask.contexts: 10, ask.configuration: 10}

    def __init__(self, profile, planned, options, on_event, before=None):
        self.profile = profile
        self.options = options
        self.on_event = on_event
        self.bell = loop.Bell()
        self.actions = planned.actions
        self._locate = capture.locator(profile, options.strict_path)
        listed = restore.places(profile)
        self._placement_of = placements.finder(self._locate, listed)
        super().__init__([KeptComponent(placement, self) for placement in listed], options.look)
        # by the ids of their Placements and model.Components
        self._kept_of = {}
        for kept in self.followed:
            self._kept_of[id(kept.placement)] = kept
            self._kept_of[id(kept.placement.component)] = kept
        self._connections = reconnect.Connections(profile, self._placement_of, self._kept_at)
        self._is_ending = False
        earlier = {kept.where: kept for kept in before.followed} if before else {}
        for kept in self.followed:
            kept.drives = list(filter(None, map(self._kept_at, _executed(kept.placement.component))))
            for other in kept.drives:
                other.drivers.append(kept)
            if kept.where in earlier:
                kept.go_on_from(earlier[kept.where])

    def at_a_time(self, kind, number):
        return max(-(-number // ROUND), min(number, STATES if kind is ask.states else 1))

    async def __aenter__(self):
        await super().__aenter__()
        self.start(self._work())
        return self

    def _kept_at(self, target):
        """The KeptComponent that a target in the profile means, or None."""
        return self._kept_of.get(id(self._placement_of(target)))

    async def follow(self):
        """Keep it until the task is cancelled."""
        while True:
            await loop.sleep(MINUTE)
            session.current().sweep()

    async def stop(self, planned, is_meant):
        """Deactivate the components for which is_meant(kept) by a plan."""
        self._is_ending = True
        while any(kept.is_busy for kept in self.followed):
            await loop.sleep(TICK)
        meant = [kept for kept in self.followed if kept.is_there and kept.is_started and is_meant(kept)]
        await self._look_to_stop(meant)
        here = [kept for kept in meant if kept.is_usable]
        for result in await self._carry_out(planned.actions, transitions.DEACTIVATE, here, lambda kept: GONE):
            kept = self._kept_of[id(result.action.component)]
            if result.error is None:
                self.happened(kept, "", "Inactive")
            else:
                self.complain(kept, kept.life, result.error)

    async def _look_to_stop(self, some):
        """Look at those of some KeptComponents with which nothing could be done, before they are deactivated.
        """
        unseen = [kept for kept in some if kept.is_there and not kept.is_usable]
        for kept in unseen:
            kept.looking = {WHOLE}
        for kept, answer in zip(unseen, await session.each(unseen, self._look)):
            if isinstance(answer, errors.Error):
                self.complain(kept, kept.life, errors.Failed(kept.where, f"cannot deactivate: {answer.why}"))

    def named(self, name):
        """The KeptComponents of a path, the end of one, or an instance name."""
        return [
            kept
            for kept in self.followed
            if name in (kept.where, str(kept.path.names[-1]), kept.placement.instance)
        ]

    async def until_settled(self, seconds):
        """Wait until all is as the file says, for at most `seconds`: whether it is."""
        end = loop.now() + seconds
        while not self.is_settled() and loop.now() < end:
            await loop.sleep(TICK)
        return self.is_settled()

    def is_settled(self):
        """Whether all is as the file says, as far as is known."""
        if any(kept.is_waiting or kept.is_busy for kept in self.followed):
            return False
        return not list(self.unsettled())

    def unsettled(self):
        """The errors.Errors that say what is not as the file says; components that are not required count
        only while they are there.
        """
        for kept in self.followed:
            if not kept.is_there and kept.placement.required:
                yield kept.error or errors.NotFound(kept.where)
            elif kept.is_there:
                complaints = [matter.complaint for matter in kept.matters if matter.complaint is not None]
                yield from complaints
                if not complaints and (kept.life.knowledge == UNKNOWN or kept.is_hung):
                    yield errors.Late(kept.where, f"it is {kept.state}")
                elif not complaints and (kept.is_waiting or kept.is_busy):
                    yield errors.Late(kept.where, "it is looked at again")

    def happened(self, kept, seen, done="", begun=None, error=None):
        """Report a Happening of a KeptComponent; `begun` by loop.now()."""
        event = happening.now(kept.where, seen, done, begun, error)
        kept.last = event.words()
        self.on_event(event)

    def complain(self, kept, matter, error):
        """Report a failure about a Matter of a KeptComponent, once: whether it is news."""
        is_new = str(matter.complaint) != str(error)
        if is_new:
            matter.complaint = error
            self.happened(kept, error.why, "", None, error)
        return is_new

    def _leave_alone(self, kept, matter, what):
        """Report what a person has done, once."""
        if matter.differ(what):
            self.happened(kept, what, "left alone")

    # ---- one round of mending ----

    async def _work(self):
        while not self._is_ending:
            now = loop.now()
            waiting = [kept for kept in self.followed if kept.is_waiting]
            batch = self._mendable([kept for kept in waiting if kept.next_look <= now])
            for kept in batch:
                kept.is_busy = True
            if batch:
                self.start(self._mend(batch))
            later = [kept.next_look - now for kept in waiting if kept.next_look > now]
            await self.bell.wait(min(later, default=None))

    def _mendable(self, waiting):
        """Those that can be mended now. One task mends a component that is back, and the composites that have
        lost it: of two tasks each would take what the other does for the work of a person.
        """
        batch = set()
        for kept in waiting:
            takers = kept.takers
            if any(other.is_busy for other in takers):
                continue
            for other in takers:
                other.changed = other.changed | {"contexts"}
            batch.update(takers, [kept])
        return [kept for kept in self.followed if kept in batch]

    async def _mend(self, batch):
        """Look at components again, where they have changed, and bring them to what the file says."""
        for kept in batch:
            kept.begin_look()
        try:
            there = [(kept, kept.shown) for kept in batch if kept.is_there]
            answers = await session.each([kept for kept, _ in there], self._look)
            for (kept, shown), answer in zip(there, answers):
                if isinstance(answer, errors.Error) and kept.shown is shown:  # not another one by now
                    await self._not_shown(kept, answer)
            await self._restore([kept for kept in batch if kept.is_usable and not kept.is_paused])
            if not self._is_ending:
                await self._start([kept for kept in batch if kept.is_startable])
        finally:
            for kept in batch:
                kept.is_busy = False
            self.bell.ring()

    async def _look(self, kept):
        shown = kept.node and kept.shown
        parts = kept.looking
        if WHOLE in parts:
            await shown.ask(ports=BRIEF, profile=FULL)
            if self.options.watch and kept.shown is shown:
                await kept.observe(dict(shown.profile.properties))
            shown.profile = shown.profile._replace(properties=[])
            parts = PARTS
        for part, how in PARTS.items():
            if part in parts:
                await shown.ask(**how)
        if kept.shown is not shown:  # it has ended
            return
        kept.held_up.end()
        if kept.seen is None:
            kept.seen = ask.Seen(shown.node, kept.asks_port)
        kept.seen.take(shown, parts)
        was_up = kept.is_up
        kept.placement.error = None
        kept.placement.found = capture.found_in(shown)
        await restore.presence(kept.placement)
        if kept.placement.error is not None:
            self.complain(kept, kept.whole, kept.placement.error)
            return
        kept.whole.complaint = None
        if STATE in parts or "contexts" in parts:  # else it may have changed since its states were asked for
            before = kept.state
            kept.become(component.merged(shown.states))
            if kept.state == "Error":
                kept.fail("in Error")
            elif kept.trial.given_up and kept.state != before:  # somebody has done that
                kept.trial.begin_again()
        if kept.is_up and not was_up:
            self._try_others()

    async def _not_shown(self, kept, error):
        """A look has failed: by whose fault?"""
        shown = kept.shown
        kept.changed = kept.changed | kept.looking
        kept.due = loop.now() + WAIT
        kept.placement.error = error
        session.current().ask_again(kept.endpoint)
        near = {other for _, ends in self._connections.of([kept]) for other in ends}
        await loop.each(near | {kept}, self.ask)
        if kept.shown is not shown:
            return
        hung = sorted(other.where for other in near if other.is_hung)
        if hung:
            error = errors.Unreachable(kept.where, "waits for " + ", ".join(hung))
        if hung or kept.is_hung:
            kept.hold_up(times.FIRST_PAUSE)
        elif isinstance(error, errors.Silent):  # it may wait for one that answers us, but not it
            kept.hold_up(WAIT)
        if not kept.is_hung:
            self.complain(kept, kept.whole, error)

    async def _restore(self, batch):
        """Do the steps of rtresurrect that concern what has changed of some KeptComponents."""
        outcomes = await self._parts(batch)
        begun = loop.now()
        changed = [kept for kept in batch if kept.looking & {WHOLE, "ports"}]
        connectors = await self._connections.take(changed)
        try:
            outcomes += await self._connections.outcomes(connectors)
            outcomes = [outcome for outcome in outcomes if not self._is_by_hand(outcome)]
            agreed = self._unsettle(outcomes)
            await apply.carry_out(outcomes)
        finally:
            self._connections.release(connectors)
        for outcome in outcomes:
            self._judge(outcome, begun)
            if outcome.status == FAILED:
                self._settle(outcome.step.joining, agreed)
        for kept in batch:
            if kept.is_there and placements.is_gone(kept.placement.error):
                self.suspect(kept.endpoint)

    def _unsettle(self, outcomes):
        """Components are to join contexts: where they are Inactive then, no person has done that. Returns
        those that were as the file says.
        """
        steps_to_do = [outcome.step for outcome in outcomes if outcome.pending]
        joining = [self._kept_of[id(placement)] for step in steps_to_do for placement in step.joining]
        agreed = [kept for kept in joining if kept.life.knowledge == AGREED]
        for kept in joining:
            kept.life.lose()
        return agreed

    def _settle(self, joining, agreed):
        """These have not joined. Those that were as the file says, and of which nothing else was heard, still
        are: who makes one Inactive from now on is a person.
        """
        for kept in [self._kept_of[id(placement)] for placement in joining]:
            is_as_before = kept.state == "Active" and not kept.has_failed and STATE not in kept.changed
            if kept in agreed and is_as_before:
                kept.life.agree()

    def _judge(self, outcome, begun):
        """Report what has become of a step."""
        step = outcome.step
        kept = self._kept_of[id(step.placements[0])]
        if kept.placement.found is None:  # another object has come meanwhile
            return
        matter = kept.of_steps[_key(step)]
        if outcome.status in (DONE, ALREADY):
            matter.agree(step.setting)
        if outcome.status == DONE:
            self.happened(kept, "", "restored " + _title(step), begun)
            for other in [self._kept_of[id(placement)] for placement in step.placements]:
                if other.is_there and (other.subscription is None or step.part == "ports"):
                    other.change(step.part)  # it does not report that
        elif outcome.failed:
            self.complain(kept, matter, outcome.error)
            was_given_up = kept.repairs.given_up
            kept.repairs.fail(outcome.error.why)
            kept.try_later(step.part, kept.repairs)
            if kept.repairs.given_up and not was_given_up:
                why = f"{outcome.error.why}; {kept.repairs.why_given_up()}"
                self.happened(kept, why, "", None, outcome.error)

    # ---- parts of components ----

    async def _parts(self, batch):
        """The outcomes of steps other than connections."""
        listed = [kept.placement for kept in batch if kept.looking - {"ports", STATE}]
        outcomes = await restore.parts(listed, self._placement_of)
        return [outcome for outcome in outcomes if outcome.step.placements]

    def _is_by_hand(self, outcome):
        """Whether a step would undo what a person did; notes what is as in the file."""
        step = outcome.step
        if step.setting is None:
            return False
        kept = self._kept_of[id(step.placements[0])]
        matter = kept.of_steps[_key(step)]
        if outcome.status == ALREADY and matter.agree(step.setting) == BY_HAND:
            self.happened(kept, f"{_title(step)} is again as in the file")
        if not outcome.pending or not matter.is_agreed(step.setting) or self.options.strict:
            return False
        if not outcome.likely:
            self._leave_alone(kept, matter, _title(step) + " was changed by hand")
        return True

    # ---- components that managers create ----

    async def still_absent(self, absent):
        for kept in absent:
            kept.become("absent")
        if not self.options.create:
            return
        now = loop.now()
        due = []
        for kept in absent:
            is_to_wait = kept.repairs.until > now or kept.repairs.given_up or kept.is_paused or kept.is_busy
            if is_to_wait or kept.is_left_for_good:
                continue
            if placements.is_gone(kept.error) and loop.wall() - kept.since > FAREWELL:
                due.append(kept)
        for kept in due:
            kept.is_busy = True
        if due:
            self.start(self._create(due, now))

    async def _create(self, due, begun):
        how = restore.Options(True, self.options.manager, self.options.strict_path)
        for kept in due:
            kept.placement.error = kept.error
        try:
            outcomes = [apply.Outcome(steps.Present(kept.placement)) for kept in due]
            outcomes = await restore.creations(self.profile, outcomes, how, self._locate)
            await apply.carry_out(outcomes)
        finally:
            for kept in due:
                kept.is_busy = False
            self.bell.ring()  # some may have been seen meanwhile
        for kept, outcome in zip(due, outcomes):
            if outcome.status == DONE:
                self.happened(kept, "was not there", "created", begun)
            elif outcome.error is not None:
                kept.repairs.fail(outcome.error.why)
                self.complain(kept, kept.whole, outcome.error)

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
        await session.each(broken, self._reset)
        todo = [kept for kept in todo if kept.state != "Error" and kept.is_usable]
        if not self.options.strict:
            todo = [kept for kept in todo if kept.life.knowledge != BY_HAND]
        if todo:
            await self._activate(todo)

    def _is_active(self, kept, is_our_work=False):
        before = kept.life.agree()
        kept.has_failed = kept.has_failed and STATE in kept.changed  # since it was seen so
        if before == BY_HAND and not is_our_work:
            self.happened(kept, "is Active again")

    def _try_others(self):
        """A component is up: those that were not tried may have waited for that."""
        for other in self.followed:
            if isinstance(other.life.complaint, errors.NotTried) and other.is_usable:
                other.change(STATE)

    def _may_start(self, kept):
        """Whether a component that is not Active is to be reset, or made Active, now."""
        trial = kept.trial
        life = kept.life.knowledge
        is_by_hand = life == AGREED or life == BY_HAND and kept.state != "Error"
        if is_by_hand and not self.options.strict:
            self._leave_alone(kept, kept.life, f"was made {kept.state} by hand")
        elif kept.has_failed and trial.policy.restart == "no":
            why = f"is in {kept.state}; its policy is {trial.policy.restart}"
            self.complain(kept, kept.life, errors.Failed(kept.where, why))
        elif trial.given_up:
            error = errors.Failed(kept.where, f"{trial.why}; {trial.why_given_up()}")
            if self.complain(kept, kept.life, error) and kept.placement.required:
                self.start(self._stop_dependents(kept))
        elif trial.until > loop.now():
            kept.try_later(STATE, trial)
        else:
            return True
        return False

    async def _reset(self, kept):
        """Take a component out of Error."""
        begun = loop.now()
        try:
            await self._change(kept, transitions.RESET)
            kept.has_failed = False
            self.happened(kept, "in Error", "reset", begun)
        except errors.Error as e:
            kept.trial.fail(e.why)
            self._has_failed(kept, e)

    def _has_failed(self, kept, error):
        """Report a failure of its state, and have it tried again."""
        kept.trial.why = error.why
        self.complain(kept, kept.life, error)
        kept.change(STATE)

    @staticmethod
    async def _change(kept, transition):
        await transitions.change(kept.node, transition, None, session.current().timeout)
        kept.reach(transition.target)

    async def _activate(self, todo):
        """Activate components by the actions of the plan."""
        for kept in todo:
            kept.has_failed = False

        begun = loop.now()
        lacking = [other for other in self.followed if other not in todo and not other.is_up]
        results = await self._carry_out(
            self.actions, transitions.ACTIVATE, todo, lambda other: ALREADY if other.is_up else FAILED
        )
        is_any_left_out = any(isinstance(result.error, errors.NotTried) for result in results)
        late = [other for other in lacking if other.is_coming or other.is_up]
        early = self._started_after(late) if is_any_left_out else []
        for kept in todo:
            own = [result.error for result in results if result.action.component is kept.placement.component]
            failed = list(filter(None, own))
            if kept in early and failed and isinstance(failed[0], errors.NotTried):
                self._wait_for_turn(kept)
            else:
                self._started(kept, failed, begun)

    def _started_after(self, some):
        """The KeptComponents that the plan starts after some, in its order; without those whose state is left
        alone, and what comes after these alone.
        """
        of_actions = [(action, self._kept_of[id(action.component)]) for action in self.actions]
        numbers = {action.number for action, kept in of_actions if kept in some}
        actions = [
            action for action, kept in of_actions if kept in some or kept.is_started and not kept.is_paused
        ]
        return [self._kept_of[id(action.component)] for action in plan.dependents(actions, numbers)]

    @staticmethod
    def _wait_for_turn(kept):
        """What it comes after has not failed: it had not been looked at yet, or is up by now."""
        kept.change(STATE)
        kept.due = loop.now() + WAIT

    async def _carry_out(self, actions, transition, some, outcome_of):
        """The Results of the actions of a plan for some KeptComponents; those of the others have ended, each
        with the outcome that `outcome_of` gives.
        """
        progress = run_plan.Progress()
        run = run_plan.Run(actions, transition, progress)

        def is_wanted(action):
            is_to_start = transition is transitions.ACTIVATE
            return not (is_to_start and self._kept_of[id(action.component)].is_paused)

        of_actions = [(action, self._kept_of[id(action.component)]) for action in actions]
        ended = {action.number: outcome_of(kept) for action, kept in of_actions if kept not in some}
        run.take({id(kept.placement.component): kept.node for kept in some}, ended, is_wanted)
        await run.carry_out()
        return progress.results

    def _started(self, kept, failed, begun):
        """Judge the actions of one component by the errors.Errors of those that failed."""
        if not kept.is_usable:
            return
        if not failed:
            kept.reach("Active")
            self._is_active(kept, is_our_work=True)
            self.happened(kept, "", "Active", begun)
            self._try_others()
        elif isinstance(failed[0], errors.NotTried):
            self.complain(kept, kept.life, failed[0])
        else:
            kept.fail(failed[0].why)
            self._has_failed(kept, failed[0])

    async def deactivate(self, kept, seen, done):
        """Deactivate one component; `seen` and `done` for the report."""
        begun = loop.now()
        try:
            if kept.is_usable:
                await self._change(kept, transitions.DEACTIVATE)
                self.happened(kept, seen, done, begun)
        except errors.Error as e:
            self.complain(kept, kept.life, e)

    async def stop_one(self, kept):
        """Deactivate a component on request; again if it was about to become Active, or to be looked at."""
        await self.deactivate(kept, "", "deactivated on request")
        while kept.is_busy:
            await loop.sleep(TICK)
        await self._look_to_stop([kept])
        if kept.is_paused and kept.state == "Active":
            await self.deactivate(kept, "", "deactivated on request")

    async def _stop_dependents(self, kept):
        """A required component is given up: deactivate what the plan starts after it, the last first."""
        for other in reversed(self._started_after([kept])):
            if other.state == "Active":
                other.life.lose()
                other.is_stopping = True
                try:
                    await self.deactivate(other, f"{kept.where} is given up", "deactivated")
                finally:
                    other.is_stopping = False
                other.change(STATE)  # it says what it waits for now


def _executed(of_file):
    """What a component executes, by the file: the members of a composite, and who takes part in its
    contexts.
    """
    targets = [participant.component for participant in of_file.participants]
    return targets + [target for context in of_file.execution_contexts for target in context.participants]


def _key(step):
    """What distinguishes a step from others of its component."""
    if step.kind in ("connect", "disconnect"):
        return reconnect.key_of(step.connector)
    what = getattr(step, "set_id", None) or getattr(step, "handle", None)
    return step.kind, what, tuple(getattr(step, "values", ()))


def _title(step):
    """What a step is about, without its component."""
    return step.title.replace(" of " + step.where, "")
