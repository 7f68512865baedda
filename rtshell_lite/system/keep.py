"""Keeping a system as its RtsProfile says: look, compare, mend, wait until something happens.

What changes is noticed by events where components take observers; of others, one small question a process is
asked every few seconds. A lost connection to a process shows its death at once. Only what has changed is looked
at again, by the steps of restore.py, and started by the plan of the file.

What hangs is left alone: its neighbours look hung, too, and a second process of a name makes things worse
(docs/protocol.md). So is what a person has changed: a component that went from Active to Inactive without an
Error, a value or a set that was as the file has it, a connection that is equal in all but its id.
"""

import collections
import random
import time

from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.events import observer
from rtshell_lite.net import loop
from rtshell_lite.robot import component, ports, snapshot, transitions, tree
from rtshell_lite.system import apply, capture, connect_steps, plan, restore, run_plan, sites
from rtshell_lite.text import shell_word

SEEK = 0.3  # seconds between looks for the name of a component that is absent; more where many are
BEAT = 10.0  # seconds between heartbeats of an observed component
LATE = 2.5 * BEAT  # after so many seconds without one it is asked whether it lives
PAUSE = 0.15  # seconds between a change and the look at it: who disconnects does it port by port
HEALTH = 60.0  # seconds without a failure after which earlier ones are forgotten
AGAIN = 2.0  # seconds between questions to a dead object whose name is still bound
TRIES = 5  # of a question whose connection is lost: to a process that ends, as a rule
NEVER = 86400  # seconds between reports of single values that are sent and received
DAY = 86400

KINDS = ("RTC_STATUS", "EC_EVENT", "PORT_EVENT", "CONFIG_EVENT")
# What is looked at again, by the part of a component that has changed; `whole` is everything.
PARTS = {
    "state": {"states": snapshot.FULL},
    "contexts": {
        "owned": snapshot.FULL,
        "participating": snapshot.BRIEF,
        "states": snapshot.FULL,
        "organisations": snapshot.FULL,
    },
    "configuration": {"configuration": snapshot.FULL},
    "ports": {"ports": snapshot.FULL},
}
WHOLE = "whole"
PART_OF = {
    "EC_EVENT": "contexts",
    "PORT_EVENT": "ports",
    "CONFIG_EVENT": "configuration",
    "RTC_STATUS": "state",
}
# The part of a component that shows whether a step is done, by the kind of the step.
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
STATE = ("state", None)  # in place of the key of a step

# How a component is restarted: `restart` always, on-error or no; given up after `burst` failures in `within`
# seconds; `first` and `most` seconds between attempts; when given up and `required`, dependents are stopped.
Policy = collections.namedtuple("Policy", "restart burst within first most")
DEFAULT_POLICY = Policy("always", 5, 60.0, 0.5, 30.0)
RESTARTS = ("always", "on-error", "no")


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


# create, manager, strict_path as restore.Options; `strict`: undo what a person did; `look`: seconds between
# questions to a process whose components take no observers; `watch` False: nothing is to be noticed later.
Options = collections.namedtuple("Options", "create manager strict_path strict look watch policy")


def policy_of(component, default):
    """The Policy of a model.Component: its extended properties keep.restart (a word), keep.burst (5/60) and
    keep.delay (0.5-30), or what `default` has. Raises Failed for other values.
    """
    words = {name: component.property("keep." + name) for name in ("restart", "burst", "delay")}
    try:
        return policy(words["restart"], words["burst"], words["delay"], default)
    except ValueError as e:
        raise errors.Failed(capture.shown_path(component), f"its property keep.{e}")


def policy(restart=None, burst=None, delay=None, default=DEFAULT_POLICY):
    """The Policy of three words, None for what `default` has. Raises ValueError with the name of the bad one."""
    made = default
    if restart:
        if restart not in RESTARTS:
            raise ValueError("restart: not one of " + ", ".join(RESTARTS))
        made = made._replace(restart=restart)
    if burst:
        number, within = _two_numbers(burst, "/", "burst: not NUMBER/SECONDS")
        made = made._replace(burst=int(number), within=within)
    if delay:
        first, most = _two_numbers(delay, "-", "delay: not FIRST-MOST")
        made = made._replace(first=first, most=most)
    return made


def _two_numbers(text, between, complaint):
    try:
        one, other = [float(word) for word in text.split(between)]
    except ValueError:
        raise ValueError(complaint)
    if not 0 < one <= DAY or not 0 < other <= DAY:
        raise ValueError(complaint)
    return one, other


class Trial:
    """How often something has failed of late, and when it may be tried again."""

    def __init__(self, of):
        self.policy = of
        self.begin_again()

    def fail(self):
        """Note a failure: the next attempt comes later, or never."""
        now = time.monotonic()
        if self.failures and now - self.failures[-1] > HEALTH:
            self.failures = []
        self.failures.append(now)
        recent = [when for when in self.failures if now - when < self.policy.within]
        self.given_up = len(recent) > self.policy.burst
        if len(self.failures) > 1:
            delay = min(self.policy.most, self.policy.first * 2 ** (len(self.failures) - 2))
        else:
            delay = 0  # the first time, at once
        self.until = now + delay * random.uniform(1, 1.25)

    def begin_again(self):
        """Something about it has changed."""
        self.failures = []
        self.until = 0.0  # by time.monotonic()
        self.given_up = False


class Kept:
    """One component that is kept.

    site     its sites.Site; `site.error` says why nothing can be done with it
    shown    its snapshot.Snapshot, None while it is absent
    changed  parts that are to be looked at again: keys of PARTS, WHOLE
    settled  keys of steps, and STATE, that were done when it was last looked at
    hands    {key: what a person has done}
    state    its state, absent, or hung
    since    when it came to be in that state, seconds since 1970
    """

    def __init__(self, site, keeper):
        self.site = site
        self.keeper = keeper
        self.policy = policy_of(site.component, keeper.options.policy)
        self.trial = Trial(self.policy)  # of its state
        self.repairs = Trial(self.policy)  # of the rest
        self.shown = self.subscription = None
        self.changed = set()
        self.settled = set()
        self.hands = {}
        self.said = {}  # {key: the last failure that was reported}
        self.state = "absent"
        self.since = time.time()
        self.restarts = 0
        self.last = ""
        self.is_busy = self.is_paused = self.is_ending = self.has_failed = False
        self.waits_for = None  # path of the component for which its activation waits
        self.heard = self.due = self.asked = 0.0
        self.dead = None  # the identity of its object that is gone
        self.number = 0  # of the next question, where it is polled

    @property
    def where(self):
        """Its path."""
        return self.site.where

    @property
    def is_there(self):
        """Whether it has answered, and its process is not known to be gone."""
        return self.shown is not None

    @property
    def place(self):
        """(endpoint of its process, its path)."""
        return self.shown.node.endpoint, self.where

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

    def hear(self, event):
        """Take what it reports."""
        self.heard = time.monotonic()
        if event.kind == "HEARTBEAT" or event.event in ("PORT_SEND", "PORT_RECEIVE"):
            return
        if event.event == "FINALIZE":
            self.is_ending = True
            self.keeper.suspect(self.place[0])
            return
        if event.event == "ERROR":
            self.has_failed = True
            self.settled.discard(STATE)
        elif event.kind != "RTC_STATUS":
            self.begin_again()
        self.change(PART_OF.get(event.kind, WHOLE))

    def begin_again(self):
        """Something about it has changed: what was given up is tried again."""
        for trial in (self.trial, self.repairs):
            if trial.given_up and not self.is_busy:
                trial.begin_again()
                self.change(*PARTS)

    def appear(self, node):
        """It is there, as this Node."""
        if self.dead is not None:
            self.restarts += 1
        self.shown = snapshot.Snapshot(node)
        self.site.node = node
        self.site.error = None
        self.settled.clear()
        self.hands.clear()
        self.said.clear()
        self.trial.begin_again()
        self.is_ending = self.has_failed = False
        self.heard = time.monotonic()
        self.change(WHOLE)

    def vanish(self, error):
        """Its object is gone."""
        if self.subscription is not None:
            self.subscription.forget()
        self.dead = orb.identity(self.shown.node.ref)
        self.shown = self.subscription = self.site.node = self.site.found = None
        self.site.error = error
        self.changed.clear()
        self.become("absent")


class Keeper:
    """Keeps a system: `async with Keeper(…) as keeper: await keeper.follow()`.

    tell  called with each Happening
    """

    def __init__(self, profile, planned, options, tell):
        self.profile = profile
        self.options = options
        self.tell = tell
        self.bell = loop.Bell()
        self.is_over = False
        listed = restore.places(profile)
        locate = capture.locator(profile, options.strict_path)
        self.site_of = sites.finder(locate, listed)
        self.actions = planned.actions
        self.kept = [Kept(site, self) for site in listed]
        self.kept_of = {id(kept.site): kept for kept in self.kept}
        self.by_component = {id(kept.site.component): kept for kept in self.kept}
        self._locate = locate
        self._making = {}  # {id of a connector that is worked on: Kepts to be looked at afterwards}
        self._looked = {}  # {endpoint: when one of its components was last asked}
        self._suspected = set()
        self._halves = set()  # ids of connectors of which one end was seen alone
        self._group = None

    async def __aenter__(self):
        session.current().on_end = self.suspect
        self._group = loop.Group()
        self._group.start(self._look_around())
        self._group.start(self._work())
        return self

    async def __aexit__(self, kind, error, traceback):
        session.current().on_end = None
        self._group.cancel()
        try:
            await self._group.__aexit__(kind, error, traceback)
        finally:
            await self._detach_all()

    async def _detach_all(self):
        """Take the observers back. Components of C++ answer only at their next heartbeat: that is not waited
        for.
        """
        lent = [kept for kept in self.kept if kept.subscription is not None]

        async def detach(kept):
            await kept.subscription.detach()

        await loop.race(session.each(lent, detach, lambda kept: kept.place), loop.sleep(0.3))
        for kept in lent:
            kept.subscription.forget()

    def happened(self, kept, seen, done="", begun=None, error=None):
        """Report a Happening of a Kept, or of an object by its path."""
        if isinstance(kept, Kept):
            where = kept.where
            kept.last = ": ".join(filter(None, (seen, done)))
        else:
            where = kept
        if begun is None:
            seconds = 0.0
        else:
            seconds = time.monotonic() - begun
        self.tell(Happening(time.time(), where, seen, done, seconds, error))

    async def follow(self):
        """Keep it until the task is cancelled."""
        while True:
            await loop.sleep(loop.FOREVER)
            session.current().sweep()

    async def until_settled(self, seconds):
        """Wait until all is as the file says, for at most `seconds`: whether it is."""
        end = time.monotonic() + seconds
        while not self.is_settled():
            if time.monotonic() > end:
                return False
            await loop.sleep(0.05)
        return True

    def is_settled(self):
        """Whether all is as the file says, as far as is known."""
        return not any(kept.changed or kept.is_busy for kept in self.kept) and not list(self.unsettled())

    def unsettled(self):
        """The errors.Errors that say what is not as the file says; of components that are not required only
        those that are there are looked at.
        """
        for kept in self.kept:
            if not kept.is_there:
                if kept.site.required:
                    yield kept.site.error or errors.NotFound(kept.where)
                continue
            yield from kept.said.values()
            if STATE not in kept.settled and not kept.said:
                yield errors.Late(kept.where, f"it is {kept.state}")

    # ---- noticing ----

    def suspect(self, endpoint):
        """A connection with a process has ended: look whether it lives."""
        if endpoint in self._suspected or not any(self._at(endpoint)):
            return
        self._suspected.add(endpoint)
        self._group.start(self._examine(endpoint), endpoint)

    def _at(self, endpoint):
        """The Kepts that are there in a process."""
        return [kept for kept in self.kept if kept.is_there and kept.place[0] == endpoint]

    async def _examine(self, endpoint):
        """Ask the components of a process whether they live; all are gone with it."""
        try:
            here = self._at(endpoint)
            for kept in [kept for kept in here if kept.is_ending or kept.state == "hung"] or here[:1]:
                await self._ask(kept)
        finally:
            self._suspected.discard(endpoint)

    async def _ask(self, kept):
        """Ask a component whether it lives."""
        try:
            await self._alive(kept)
        except errors.Error as e:
            self._fails(kept, e)
            return
        session.current().silent.pop(kept.place[0], None)
        if kept.is_ending:
            await loop.sleep(SEEK)
            self._group.start(self._examine(kept.place[0]), kept.place[0])
        elif kept.state == "hung":
            self.happened(kept, "answers again")
            kept.become("unknown")
            kept.change(WHOLE)

    async def _alive(self, kept):
        """Raise what shows that a component is gone, or hangs; a process that ends drops its connections first."""
        ref = kept.shown.node.ref
        for _ in range(TRIES):
            try:
                return await orb.is_alive(kept.where, ref)
            except (errors.Silent, errors.Gone, errors.ConnectionRefused):
                raise
            except errors.Unreachable:
                await loop.sleep(PAUSE)
        return await orb.is_alive(kept.where, ref)

    def _fails(self, kept, error):
        """A component could not be asked."""
        if not kept.is_there:
            return
        if isinstance(error, (errors.Gone, errors.ProcessGone)):
            endpoint = kept.place[0]
            if isinstance(error, errors.Gone):
                lost = [kept]
            else:
                lost = self._at(endpoint)
            for each in lost:
                self._lose(each, error)
        elif kept.state != "hung":
            kept.become("hung")
            self.happened(kept, error.why, "left alone")

    def _lose(self, kept, error):
        if kept.is_ending or isinstance(error, errors.Gone):
            seen = "has exited"
        else:
            seen = "its process is gone"
        kept.vanish(error)
        for other in self.kept:  # that take part in its contexts stop with it
            if other.is_there and self._drives(kept, other):
                other.settled.discard(STATE)
        self.happened(kept, seen)
        self.bell.ring()

    def _drives(self, kept, other):
        """Whether a component executes another one, by the file."""
        component_of = kept.site.component
        targets = [one.component for one in component_of.participants]
        targets += [target for context in component_of.execution_contexts for target in context.participants]
        return any(self._locate(target) is other.site.component for target in targets)

    async def _look_around(self):
        """Look for what is absent, and ask those who report nothing themselves."""
        while True:
            absent = [kept for kept in self.kept if not kept.is_there and not kept.is_paused]
            if absent:
                await self._seek(absent)
            self._ask_late()
            for endpoint in {kept.place[0] for kept in self.kept if self._is_polled(kept)}:
                self._poll(endpoint)
            if absent:
                await loop.sleep(max(SEEK, 0.01 * len(absent)))
            else:
                await loop.sleep(min(1.0, self.options.look / 2))

    async def _seek(self, absent):
        """Look whether absent components have come."""
        found = await session.each(absent, self._found, lambda kept: (tree.lane(kept.site.path), kept.where))
        for kept, node in zip(absent, found):
            if isinstance(node, errors.Error):
                kept.site.error = node
            elif node is not None:
                kept.appear(node)
        if self.options.create:
            await self._create([kept for kept in absent if sites.is_gone(kept.site.error)])

    async def _found(self, kept):
        """The Node of an absent component. Raises what says why it is absent."""
        node = await tree.component(kept.site.path)
        now = time.monotonic()
        if orb.identity(node.ref) == kept.dead and now - kept.asked < AGAIN:
            raise kept.site.error
        kept.asked = now
        (node,) = await tree.check_alive([node])
        if node.kind != "component":
            kept.dead = orb.identity(node.ref)
            raise node.error
        return node

    async def _create(self, absent):
        """Let managers create components that are gone."""
        due = [
            kept for kept in absent if kept.repairs.until <= time.monotonic() and not kept.repairs.given_up
        ]
        if not due:
            return
        options = restore.Options(True, self.options.manager, self.options.strict_path)
        outcomes = []
        for kept in due:
            outcome = apply.Outcome(None)
            outcome.step = restore.steps.Present(kept.site)
            outcomes.append(outcome)
        outcomes = await restore.creations(self.profile, outcomes, options, self._locate)
        begun = time.monotonic()
        await apply.carry_out(outcomes)
        for kept, outcome in zip(due, outcomes):
            if outcome.status == apply.DONE:
                self.happened(kept, "was not there", "created", begun)
            elif outcome.error is not None:
                kept.site.error = outcome.error
                kept.repairs.fail()
                self._complain(kept, "create", outcome.error)

    def _ask_late(self):
        """Ask those whose heartbeats have not come, and those that hang."""
        now = time.monotonic()
        for kept in self.kept:
            beats = kept.subscription is not None and now - kept.heard < LATE
            if kept.is_there and (kept.state == "hung" or kept.subscription is not None and not beats):
                if kept.state != "hung":
                    kept.heard = now - LATE + BEAT
                    self._group.start(self._lend_again(kept), kept.place[0])
                self.suspect(kept.place[0])

    async def _lend_again(self, kept):
        """A component that lives may have lost its observer after a failed call."""
        try:
            await kept.subscription.attach()
        except errors.Error:
            pass  # whether it lives is asked elsewhere
        kept.change(*PARTS)

    # ---- where there are no observers ----

    def _is_polled(self, kept):
        is_ready = kept.is_there and kept.site.found is not None and kept.state != "hung"
        return is_ready and kept.subscription is None and self.options.watch

    def _poll(self, endpoint):
        """Ask a process one question, if it is time."""
        now = time.monotonic()
        if now - self._looked.get(endpoint, 0) < self.options.look:
            return
        self._looked[endpoint] = now
        polled = [kept for kept in self._at(endpoint) if self._is_polled(kept)]
        questions = [(kept, question) for kept in polled for question in self._questions(kept)]
        if questions:
            first = polled[0]
            first.number += 1
            self._group.start(self._put(*questions[first.number % len(questions)]), endpoint)

    def _questions(self, kept):
        """What a component is asked in turn: its state in its context, and whether each connection is there."""
        found = [("state", context.ref, None) for context in kept.shown.contexts[:1]]
        for port in kept.site.found.ports:
            found += [("ports", port.ref, connector.id) for connector in port.connectors]
        return found

    async def _put(self, kept, question):
        part, ref, connector_id = question
        try:
            if part == "state":
                now = await component.state_in(kept.shown.node, ref)
                is_changed = now not in kept.shown.states
            else:
                profile = await orb.call(kept.where, ref, "get_connector_profile", connector_id)
                is_changed = not profile.connector_id
        except errors.Refused:
            is_changed = True
        except errors.Error as e:
            self._fails(kept, e)
            return
        if is_changed and kept.is_there:
            kept.begin_again()
            kept.change(part)

    # ---- mending ----

    async def _work(self):
        while True:
            await self.bell.wait(self._patience())
            now = time.monotonic()
            batch = [kept for kept in self.kept if self._is_ready(kept, now)]
            if batch:
                for kept in batch:
                    kept.is_busy = True
                self._group.start(self._mend(batch))

    def _is_ready(self, kept, now):
        return kept.changed and kept.is_there and not kept.is_busy and not kept.is_paused and kept.due <= now

    def _patience(self):
        """Seconds until a component is due that has changed, or None."""
        times = [kept.due for kept in self.kept if kept.changed and kept.is_there and not kept.is_busy]
        if not times:
            return None
        return max(0.001, min(times) - time.monotonic())

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
            there = [kept for kept in batch if kept.is_there and kept.site.error is None]
            await self._restore(there, changed)
            await self._start([kept for kept in there if kept.is_there and kept.site.error is None])
        finally:
            for kept in batch:
                kept.is_busy = False
            self.bell.ring()

    async def _look(self, kept, parts):
        shown = kept.shown
        if WHOLE in parts:
            await shown.ask(ports=snapshot.BRIEF, profile=snapshot.FULL)
            await self._observe(kept)
            parts = PARTS
        wanted = {}
        for part in ("ports", "contexts", "configuration", "state"):
            if part in parts:
                wanted.update(PARTS[part])
        await shown.ask(**wanted)
        if kept.shown is not shown:
            return
        kept.site.found = capture.found_in(shown)
        if kept.site.error is not None or parts is PARTS:
            kept.site.error = None
            await restore.presence(kept.site)
            if kept.site.error is not None:
                self._complain(kept, WHOLE, kept.site.error)
                return
        state = component.merged(shown.states)
        if state == "Error":
            kept.has_failed = True
            kept.settled.discard(STATE)
        kept.become(state)
        kept.said.pop(WHOLE, None)

    async def _observe(self, kept):
        """Lend a component an observer, if it takes one."""
        properties = dict(kept.shown.profile.properties)
        kept.shown.profile = kept.shown.profile._replace(properties=[])
        offered = observer.taken(properties)
        known = [kind for kind in (observer.OBSERVER, observer.FSM_OBSERVER) if kind in offered]
        if not known or not self.options.watch:
            return
        quiet = [(f"port_profile.{word}_event.min_interval", str(NEVER)) for word in ("send", "receive")]
        if kept.subscription is None:
            kept.subscription = observer.observer(kept.shown.node, known[0], KINDS, kept.hear, BEAT, quiet)
        try:
            await kept.subscription.attach()
        except errors.Refused:
            kept.subscription.forget()
            kept.subscription = None

    async def _not_shown(self, kept, error, parts):
        """A look has failed: by whose fault?"""
        kept.changed |= parts
        if not kept.is_there:
            return
        session.current().silent.pop(kept.place[0], None)
        try:
            await self._alive(kept)
        except errors.Error as e:
            self._fails(kept, e)
            return
        kept.site.error = error
        kept.due = time.monotonic() + 1
        near = [other for other in self.kept if other.is_there and self._touches(kept, other)]
        for other in near:
            await self._ask(other)
        hung = [other.where for other in near if other.state == "hung"]
        if hung:
            self._complain(kept, WHOLE, errors.Unreachable(kept.where, f"waits for {', '.join(hung)}"))
        else:
            self._complain(kept, WHOLE, error)

    def _connectors(self, batch):
        """The connectors of the file with an end on one of some Kepts, and their Kepts."""
        wanted = {id(kept.site) for kept in batch}
        for connector in self.profile.connectors:
            ends = [self.site_of(end) for end in connector.ends]
            if any(id(site) in wanted for site in ends):
                yield connector, [self.kept_of[id(site)] for site in ends if site is not None]

    def _touches(self, kept, other):
        return kept is not other and any(other in ends for _, ends in self._connectors([kept]))

    async def _restore(self, batch, changed):
        """Do the steps of rtresurrect that concern what has changed of some Kepts."""
        outcomes = await self._parts(batch, changed)
        connectors = await self._take_connectors(
            [kept for kept in batch if changed[id(kept)] & {WHOLE, "ports"}]
        )
        try:
            making = connect_steps.connecting(self.profile, self.site_of, connectors)
            outcomes += self._without_doubt(await restore.connections(making))
            outcomes = [outcome for outcome in outcomes if not self._is_by_hand(outcome)]
            begun = time.monotonic()
            pending = [outcome for outcome in outcomes if outcome.pending]
            await apply.carry_out(pending)
            for outcome in outcomes:
                self._judge(outcome, begun, outcome in pending)
        finally:
            self._release(connectors)
        for kept in self.kept:
            if kept.is_there and kept.site.error is not None and sites.is_gone(kept.site.error):
                self.suspect(kept.place[0])

    async def _parts(self, batch, changed):
        """The outcomes of steps other than connections."""
        own = [kept.site for kept in batch if changed[id(kept)] - {"ports", "state"}]
        back = [kept for kept in batch if WHOLE in changed[id(kept)]]
        outcomes = await restore.parts(own, self.site_of)
        for kept in self.kept:  # composites that have lost a member which is back
            is_whole = kept.is_there and kept.site.found is not None and kept.site not in own
            if is_whole and any(self._drives(kept, other) for other in back):
                outcomes += await restore.parts([kept.site], self.site_of)
        return outcomes

    async def _take_connectors(self, batch):
        """The connectors of some Kepts whose ports have changed that are not as the file has them, as far as
        these show. No other task works on them until `_release`; all of their ends have been asked since.
        """
        taken = []
        for connector, ends in self._connectors(batch):
            if not all(kept.is_there and kept.site.error is None and kept.site.found for kept in ends):
                continue
            if self._shows(connector, ends, batch):
                ends[0].said.pop(_key_of(connector), None)
            elif id(connector) in self._making:
                self._making[id(connector)] += [kept for kept in ends if kept in batch]
            else:
                self._making[id(connector)] = []
                taken.append((connector, ends))
        asked = list({id(kept): kept for _, ends in taken for kept in ends}.values())
        answers = await session.each(asked, self._look_at_ports, lambda kept: kept.place)
        failed = [kept for kept, answer in zip(asked, answers) if isinstance(answer, errors.Error)]
        for kept in failed:
            kept.change("ports")
        self._release([connector for connector, ends in taken if any(kept in failed for kept in ends)])
        return [connector for connector, ends in taken if id(connector) in self._making]

    def _release(self, connectors):
        """Let other tasks work on connectors, and those that wanted to look again."""
        for connector in connectors:
            for kept in self._making.pop(id(connector)):
                kept.change("ports")

    def _shows(self, connector, ends, batch):
        """Whether those of the ends of a connector that are in the batch show it as the file has it: with its
        id, between the ports that the others had when they were last asked.
        """
        found = [
            kept.site.port(capture.port_of(end))
            for kept, end in zip(ends, connector.ends)
            if kept is not None
        ]
        if len(found) < len(connector.ends) or any(isinstance(port, errors.Error) for port in found):
            return False
        wanted = {orb.identity(port.ref) for port in found}
        for kept, port in zip(ends, found):
            same = [one for one in port.connectors if one.id and one.id == connector.connector_id]
            joined = {orb.identity(ref) for one in same for ref in one.ports if ref is not None}
            if kept in batch and joined != wanted:
                return False
        return True

    async def _look_at_ports(self, kept):
        """Have the present ports of a component in what was found of it."""
        now = await ports.ports(kept.shown.node)
        kept.site.found = kept.site.found._replace(ports=ports.in_system(now))

    def _without_doubt(self, outcomes):
        """The outcomes without those of a connection that has just lost an end: somebody may be about to
        connect or disconnect. What is half there at the next look, too, is removed.
        """
        removals = [outcome for outcome in outcomes if outcome.step.kind == "disconnect"]
        doubtful = set()
        for outcome in removals:
            key = id(outcome.step.connector)
            if key not in self._halves:
                doubtful.add(key)
                self.kept_of[id(outcome.step.sites[0])].change("ports")
        self._halves = doubtful
        return [
            outcome for outcome in outcomes if id(getattr(outcome.step, "connector", None)) not in doubtful
        ]

    def _is_by_hand(self, outcome):
        """Whether a step would undo what a person did; what is as the file has it is noted."""
        key = _key(outcome.step)
        kept = self.kept_of[id(outcome.step.sites[0])] if outcome.step.sites else None
        if kept is None or outcome.step.kind not in BY_HAND:
            return False
        if outcome.status == apply.ALREADY:
            kept.settled.add(key)
            if kept.hands.pop(key, None):
                self.happened(kept, f"{_title(outcome.step)} is again as in the file")
        if not outcome.pending or key not in kept.settled or self.options.strict:
            return False
        if key not in kept.hands and not outcome.likely:
            kept.hands[key] = outcome.step.title
            self.happened(kept, f"{_title(outcome.step)} was changed by hand", "left alone")
        return True

    def _judge(self, outcome, begun, was_pending):
        """Report what has become of a step."""
        step = outcome.step
        if not step.sites:
            return
        kept = self.kept_of[id(step.sites[0])]
        key = _key(step)
        if outcome.status in (apply.DONE, apply.ALREADY):
            kept.settled.add(key)
            kept.said.pop(key, None)
            if outcome.status == apply.DONE:
                self.happened(kept, "", "restored " + _title(step), begun)
        elif outcome.failed:
            kept.settled.discard(key)
            kept.repairs.fail()
            self._complain(kept, key, outcome.error)
            self._try_later(kept, kept.repairs, SHOWN_BY.get(step.kind, WHOLE))

    def _try_later(self, kept, trial, part):
        if trial.given_up:
            return
        kept.due = max(kept.due, trial.until)
        kept.change(part)

    def _complain(self, kept, key, error):
        """Report a failure, once."""
        if str(kept.said.get(key)) != str(error):
            kept.said[key] = error
            self.happened(kept, error.why, "", None, error)

    # ---- states ----

    async def _start(self, batch):
        """Activate what is not Active, in the order of the plan."""
        todo = []
        for kept in batch:
            if kept.state == "Active":
                self._is_active(kept)
            elif self._may_start(kept):
                todo.append(kept)
        await session.each(
            [kept for kept in todo if kept.state == "Error"], self._reset, lambda kept: kept.place
        )
        todo = [kept for kept in todo if kept.state != "Error"]
        if todo:
            await self._carry_out(todo)

    def _is_active(self, kept):
        is_new = STATE not in kept.settled
        kept.settled.add(STATE)
        kept.said.pop(STATE, None)
        kept.has_failed = False
        kept.waits_for = None
        if kept.hands.pop(STATE, None):
            self.happened(kept, "is Active again")
        for other in self.kept if is_new else ():
            if other.waits_for is not None:
                other.change("state")

    def _may_start(self, kept):
        """Whether a component that is not Active is to be made so now."""
        if STATE in kept.settled and not self.options.strict:
            if STATE not in kept.hands:
                kept.hands[STATE] = f"it is {kept.state}"
                self.happened(kept, f"was made {kept.state} by hand", "left alone")
            return False
        if kept.has_failed and kept.policy.restart == "no":
            self._complain(
                kept, STATE, errors.Failed(kept.where, f"is {kept.state}; its policy is not to restart")
            )
            return False
        if kept.trial.given_up:
            return False
        if kept.trial.until > time.monotonic():
            self._try_later(kept, kept.trial, "state")
            return False
        return True

    async def _reset(self, kept):
        """Take a component out of Error."""
        begun = time.monotonic()
        try:
            self._count(kept)
            await transitions.change(kept.shown.node, transitions.RESET, None, session.current().timeout)
            kept.become("Inactive")
            self.happened(kept, "in Error", "reset", begun)
        except errors.Error as e:
            self._complain(kept, STATE, e)
            self._try_later(kept, kept.trial, "state")

    def _count(self, kept):
        """Count an Error, and give the component up after too many."""
        kept.trial.fail()
        if kept.trial.given_up:
            policy = kept.policy
            error = errors.Failed(
                kept.where,
                f"given up after {policy.burst} failures in {policy.within:g}s; it is {kept.state}",
            )
            self._complain(kept, STATE, error)
            if kept.site.required:
                self._group.start(self._stop_dependents(kept))
            raise error

    async def _carry_out(self, todo):
        """Activate components by the actions of the plan; those of the others have ended."""
        nodes = {id(kept.site.component): kept.shown.node for kept in todo}
        ended = {}
        for action in self.actions:
            other = self.by_component[id(action.component)]
            if other in todo:
                continue
            is_active = other.state == "Active"
            ended[action.number] = plan.ALREADY if is_active else plan.FAILED
        progress = _Progress()
        run = run_plan.Run(self.actions, transitions.ACTIVATE, progress)
        run.take(nodes, ended)
        begun = time.monotonic()
        await run.carry_out()
        for kept in todo:
            results = [
                result for result in progress.results if result.action.component is kept.site.component
            ]
            await self._started(kept, results, begun)

    async def _started(self, kept, results, begun):
        """Judge the Results of the actions of one component."""
        bad = [result for result in results if result.error is not None]
        if not bad:
            kept.become("Active")
            if kept.is_there:
                kept.shown.states = ["Active"] * len(kept.shown.states)
            self._is_active(kept)
            self.happened(kept, "", "Active", begun)
            return
        error = bad[0].error
        self._complain(kept, STATE, error)
        if isinstance(error, errors.NotTried):
            kept.waits_for = error.why
            return
        if not kept.is_there:
            return
        kept.trial.fail()
        kept.has_failed = True
        self._try_later(kept, kept.trial, "state")

    async def _stop_dependents(self, kept):
        """A required component is given up: deactivate what the plan starts after it, the last first."""
        for action in reversed(plan.dependents(self.actions, self._numbers(kept))):
            other = self.by_component[id(action.component)]
            if not other.is_there or other.state != "Active":
                continue
            other.settled.discard(STATE)
            other.waits_for = kept.where
            begun = time.monotonic()
            try:
                await transitions.change(
                    other.shown.node, transitions.DEACTIVATE, None, session.current().timeout
                )
                other.become("Inactive")
                self.happened(other, f"{kept.where} is given up", "deactivated", begun)
            except errors.Error as e:
                self._complain(other, STATE, e)

    def _numbers(self, kept):
        return {action.number for action in self.actions if action.component is kept.site.component}


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


class _Progress:
    """Collects the Results of a plan."""

    def __init__(self):
        self.results = []

    def starting(self, action, line):
        """Nothing: the end is reported."""

    def ended(self, result):
        """Keep a Result."""
        self.results.append(result)

    skipped = ended


def _key_of(connector):
    return "connect", id(connector)


def _title(step):
    """What a step is about, without its component."""
    return step.title.replace(" of " + step.where, "")


def _key(step):
    """What tells a step from others of its component."""
    if step.kind in ("connect", "disconnect"):
        return _key_of(step.connector)
    return step.kind, getattr(step, "set_id", None) or getattr(step, "handle", None)
