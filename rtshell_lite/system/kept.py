"""One component of a system that is kept: what is known of it, what has changed, and what a person has done.

keep.py decides what is done about it.
"""


import collections

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.live import follow, times
from rtshell_lite.net import loop
from rtshell_lite.robot import snapshot
from rtshell_lite.system import policy
from rtshell_lite.system.matter import BY_HAND, Matter

PAUSE = 0.15  # seconds between a change and the look at it: who disconnects does it port by port
WAIT = 1.0  # seconds until a look that failed is taken again; where nothing was answered, ever more

WHOLE = "whole"  # every part, and whether it is the component that is meant
STATE = "state"  # a part
FULL, BRIEF = snapshot.FULL, snapshot.BRIEF
# What is looked at again, by the part of a component that has changed.
PARTS = {
    "ports": {"ports": FULL},
    "contexts": {"owned": FULL, "participating": BRIEF, "states": FULL, "organisations": FULL},
    "configuration": {"configuration": FULL},
    STATE: {"states": FULL},
}
PART_OF = {
    "EC_EVENT": "contexts",
    "PORT_EVENT": "ports",
    "CONFIG_EVENT": "configuration",
    "RTC_STATUS": STATE,
}


class KeptComponent(follow.Followed):
    """One component that is kept.

    placement      its placements.Placement; `placement.error` says why nothing can be done with it
    changed   parts that are to be looked at again: of PARTS, or WHOLE; not before `due`, by loop.now()
    later     {part in which something has failed: loop.now() at which it is tried again}
    looking   those that are being looked at
    life      the Matter of its state; `whole` of what hinders all; `of_steps` {key of a step: its Matter}
    state     its state, absent, hung, or unknown: not looked at yet, or left alone by its policy; since
              `since`, seconds since 1970
    trial     the policy.Trial of its state, `repairs` that of everything else
    last      the last Happening of it in words, `restarts` how often it has come back
    drives    KeptComponents that it executes, by the file; `drivers` those that execute it
    """

    changed = looking = frozenset()  # type: frozenset
    state = "absent"
    restarts = 0
    last = ""
    is_busy = is_paused = has_exited = has_been_there = False
    is_stopping = False  # being deactivated, as one that the plan starts before it was given up
    is_refused = False  # it has come back, and its policy leaves it alone
    has_failed = False  # since the last attempt to activate it; among the failures of `trial`
    known = None  # the identity of the object that it was before the file was read again, or it refused
    due = _changed_since = 0.0

    def __init__(self, placement, keeper):
        super().__init__(placement.path)
        self.where = placement.where
        self.placement = placement
        self.keeper = keeper
        chosen = policy.of(placement.component, keeper.options.policy)
        self.trial = policy.Trial(chosen)
        self.repairs = policy.Trial(chosen)
        self._know_nothing()
        self.since = loop.wall()
        self.held_up = times.Patience()  # with looks that fail because it or a neighbour hangs
        self.later = {}  # type: dict
        self.drives = []
        self.drivers = []
        # False for one whose state is nobody's business here
        self.is_started = placement.component.property(policy.PREFIX + STATE) != "any"

    def _know_nothing(self):
        self.life = Matter()
        self.whole = Matter()
        self.of_steps = collections.defaultdict(Matter)

    @property
    def matters(self):
        """All its Matters."""
        return [self.whole, self.life, *self.of_steps.values()]

    @property
    def is_usable(self):
        """Whether something can be done with it."""
        return self.is_there and self.placement.error is None and self.placement.found is not None

    @property
    def is_startable(self):
        """Whether its state may be changed to what the file says."""
        return self.is_usable and not (self.is_hung or self.is_paused or self.is_stopping)

    @property
    def is_up(self):
        """Whether what comes after it may start."""
        return self.state == "Active" or self.is_usable and not self.is_started

    @property
    def is_given_up(self):
        """Whether something about it was given up."""
        return self.trial.given_up or self.repairs.given_up

    @property
    def is_waiting(self):
        """Whether it is to be looked at."""
        return self.is_there and bool(self.changed or self.later) and not self.is_busy

    @property
    def next_look(self):
        """When it is to be looked at, by loop.now(), if it is."""
        return self.due if self.changed else max(self.due, min(self.later.values()))

    @property
    def is_coming(self):
        """Whether it is about to be looked at, and then to be made Active."""
        if not self.is_there or self.is_hung or self.is_paused or self.state == "Active":
            return False
        is_by_hand = self.life.knowledge == BY_HAND and not self.keeper.options.strict
        if is_by_hand or self.whole.complaint is not None or self.life.complaint is not None:
            return False
        soon = loop.now() + WAIT
        return self.trial.until <= soon and (self.is_busy or self.is_waiting and self.next_look <= soon)

    @property
    def is_left_for_good(self):
        """Whether it was there, and its policy leaves it alone when it is back."""
        return self.has_been_there and self._is_to_be_left()

    @property
    def takers(self):
        """Those of the composites and contexts that are to take it again, if it is one that is back."""
        if WHOLE not in self.changed or self.is_paused:
            return []
        return [other for other in self.drivers if other.is_usable and not other.is_paused]

    def hold_up(self, pause):
        """It hangs, or waits for one that does. Each look holds a thread of it: they come ever later, the
        first after a pause (seconds).
        """
        self.held_up.wait(pause)
        self.due = self.held_up.until

    def release(self):
        """What has held it up may be over: look at it at once."""
        if self.held_up.is_on:
            self.held_up.end()
            self.due = loop.now()
            self.keeper.bell.ring()

    def wait_no_more(self):
        super().wait_no_more()
        self.release()

    def become(self, state):
        """Note its state."""
        if state != self.state:
            self.state = state
            self.since = loop.wall()

    def reach(self, state):
        """Note the state that it was brought to."""
        self.become(state)
        if self.seen is not None:
            self.seen.expect(state)

    def change(self, *parts):
        """Have parts of it looked at again, if it is there, and not to be left alone. A part in which
        something is tried again later waits for that.
        """
        new = {part for part in parts if part not in self.later or part == STATE}
        if not self.is_there or self.is_refused or not new:
            return
        if not self.changed:
            self._changed_since = loop.now()
        self.changed = self.changed | new
        self.due = max(self.due, min(loop.now() + PAUSE, self._changed_since + WAIT))
        self.keeper.bell.ring()

    def try_later(self, part, trial):
        """Have a part looked at again when something in it may be tried again, if it is not given up."""
        if self.is_there and not trial.given_up:
            self.later[part] = trial.until

    def begin_look(self):
        """Note that what is to be looked at by now is being looked at."""
        now = loop.now()
        self.looking = self.changed.union(part for part, when in self.later.items() if when <= now)
        self.changed = frozenset()
        self.later = {part: when for part, when in self.later.items() if when > now}

    def as_dict(self):
        """For `rtkeep status`."""
        goal = "Active" if self.is_started else "any"
        return {
            "kind": "component",
            "object": self.where,
            "wanted": "paused" if self.is_paused else goal,
            "state": self.state,
            "since": self.since,
            "restarts": self.restarts,
            "last": self.last,
            "by_hand": sorted(matter.words for matter in self.matters if matter.knowledge == BY_HAND),
            "given_up": self.is_given_up,
        }

    def fail(self, why):
        """Note a failure of its state."""
        self.life.lose()
        if not self.has_failed:
            self.has_failed = True
            self.trial.fail(why)

    def forget_all(self):
        """Begin as with a component that was never seen."""
        self.due = 0.0
        self.later.clear()
        self._know_nothing()
        self.trial.begin_again()
        self.repairs.begin_again()

    def take_back(self):
        """Let it be kept again, whatever a person has done."""
        self.is_paused = self.is_refused = False
        self.forget_all()
        self.release()
        if self.is_there:
            self.change(WHOLE)

    def go_on_from(self, old):
        """The file was read again: what a person has done is kept where the file wants what
        it wanted before.
        """
        self.is_paused = old.is_paused
        self.restarts = old.restarts
        self.last = old.last
        self.has_exited = old.has_exited
        self.has_been_there = old.has_been_there
        self.state = old.state  # until it is looked for
        self.since = old.since
        self.known = orb.identity(old.shown.node.ref) if old.is_there else old.known
        self.is_refused = old.is_refused and self._is_to_be_left()
        if self.known is not None:
            if old.is_started and self.is_started:
                self.life = old.life
            self.of_steps = old.of_steps
        for matter in self.matters:
            matter.complaint = None

    def begin_again(self):
        """Something about it has changed: what was given up is tried again."""
        for trial in (self.trial, self.repairs):
            if trial.given_up and not self.is_busy:
                trial.begin_again()
                self.later.clear()
                self.change(*PARTS)

    # ---- what is noticed ----

    def appeared(self):
        self.release()
        is_other = orb.identity(self.shown.node.ref) != self.known
        self.known = None
        if is_other:
            self.restarts += self.has_been_there
            self.forget_all()
            self.is_refused = self.is_left_for_good
        self.has_been_there = True
        self.placement.node = self.shown.node
        self.placement.error = self.placement.found = None
        if is_other or self.is_refused or self.state == "absent":
            self.become("unknown")
        if not self.is_refused:
            self.has_failed = False
            self.change(WHOLE)
            return
        self.changed = frozenset()
        why = f"is back; its policy is {self.trial.policy.restart}"
        self.placement.error = errors.Failed(self.where, why)
        self.keeper.complain(self, self.whole, self.placement.error)

    def _is_to_be_left(self):
        """Whether its policy leaves it alone when it is back."""
        restart = self.trial.policy.restart
        return restart == "no" or restart == "on-error" and self.has_exited

    def vanished(self, seen):
        self.placement.error = self.error  # tasks that are at work go on with what they have, and fail
        self.changed = frozenset()
        self.later.clear()
        self.has_exited = seen == "has exited"
        if isinstance(self.error, errors.MaybeGone):  # it may be the same one that answers again
            self.known = self.dead
        self.become("absent")
        self.keeper.happened(self, seen)
        for other in self.drives:  # its contexts stop, and nobody has done that
            other.life.lose()

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
        if event.event == "PORT_CONNECT" and not self.is_given_up:  # somebody's, or made by us
            return
        if event.event == "ERROR":
            self.fail("in Error")
        elif event.kind != "RTC_STATUS":
            self.begin_again()
        if event.kind == "EC_EVENT":  # a composite does not report that it has lost a member
            for other in self.drivers:
                if other.is_usable:
                    other.change("contexts")
        self.change(PART_OF.get(event.kind, WHOLE))

    def missed(self, kind):
        self.change(PART_OF[kind])

    def asks_port(self, port):
        """Whether a port of its `seen` is asked for its connections: where it has some, one of its ends may
        lose them alone; where something was given up, all may change that.
        """
        return bool(port.connections) or self.is_given_up
