"""Execution contexts: the life cycle of their components, driven by a thread that sleeps when there is no
work.
"""
import math

from . import carrier
from .idl import RTC
from .properties import nvlist

QUICKEST = 0.02         # seconds: no component runs more often, whatever rate its context claims
# Hz that a context keeps at most, whatever it claims: a real one claimed 1,000 on a busy computer, and kept
# 470
FASTEST = 800.0
TRANSITION_TIMEOUT = 0.5
# seconds that a thread of this process is waited for where a real one would have run long before: a busy
# machine may hold up any
HELD_UP = 20.0
ROUNDING = 1e-6         # seconds by which a wait may end too early


class Member:
    """A component in a context: its state there, and the state asked for."""

    def __init__(self, reference, servant, handle):
        self.reference = reference
        self.component = servant or reference
        self.is_local = servant is not None
        self.handle = handle
        self.state = RTC.INACTIVE_STATE
        self.history = [(carrier.now(), self.state)]
        self.left = None                # when
        self.wanted = None
        self.falls = None               # when it goes to Error, by the clock
        self.waiting = 0                # callers that wait for a change of its state
        self.is_held = False            # whether its next change waits for them
        self.is_leaving = False

    @property
    def busy(self):
        """Whether it has something to do in each cycle, as far as is known here."""
        return getattr(self.component, "busy", True)

    @property
    def takes(self):
        """Seconds that its callbacks take with a change of its state, math.inf where that is not known."""
        if not self.is_local or self.component.observers.registered:  # other processes have a say in it
            return math.inf
        return self.component.takes


class Behaviour:
    """An execution context without its type id."""

    def __init__(self, process, flavour, rate, running=True, sync=True):
        self.process = process
        self.flavour = flavour
        self.rate = rate
        self.running = running
        self.sync = sync
        self.owner = None
        self.members = []
        self.everyone = []              # Members that there are and have been
        self.participants = []
        self.changed = carrier.Condition()
        self.thread = None
        self.born = carrier.now()
        self.dead = False
        # 2.x, no component Active: what is asked while it is stopped does not wake it
        self.asleep = False
        self.is_executing = False       # a component, which may take as long as it likes
        self.due = 0.0                  # when its next cycle is
        self.more = []                  # further properties

    # what others see

    def is_running(self):
        return self.running

    def get_rate(self):
        return self.rate

    def get_kind(self):
        return RTC.PERIODIC

    def get_profile(self):
        pairs = [("type", "PeriodicExecutionContext"), ("rate", f"{self.rate:g}")]
        if self.flavour.modern:
            pairs = [("sync_transition", "YES" if self.sync else "NO"),
                     ("transition_timeout", f"{TRANSITION_TIMEOUT:g}")] + pairs
        if self.flavour.context_name:
            pairs.append(("name", ""))
        pairs += self.more
        return RTC.ExecutionContextProfile(
            self.get_kind(), self.rate, self.owner, list(self.participants), nvlist(pairs)
        )

    def get_component_state(self, comp):
        member = self._find(comp)
        if member and member.falls:
            self._fall(member)          # were its thread late
        return member.state if member else RTC.CREATED_STATE

    # what others ask for

    def start(self):
        return self._run(True)

    def stop(self):
        return self._run(False)

    def set_rate(self, rate):
        if rate <= 0 and not self.flavour.any_rate:
            return RTC.BAD_PARAMETER
        self.rate = rate
        for member in list(self.members):
            self._tell(member, "on_rate_changed")
        self._wake()
        return RTC.RTC_OK

    def activate_component(self, comp):
        return self._change(comp, RTC.INACTIVE_STATE, RTC.ACTIVE_STATE)

    def deactivate_component(self, comp):
        return self._change(comp, RTC.ACTIVE_STATE, RTC.INACTIVE_STATE)

    def reset_component(self, comp):
        return self._change(comp, RTC.ERROR_STATE, RTC.INACTIVE_STATE)

    def add_component(self, comp):
        if comp is None:
            return RTC.BAD_PARAMETER
        handle = comp.attach_context(self.reference)
        self.participants.append(comp)
        if self.flavour.modern and self.running:
            self.process.thread(self._add_in_time, comp, handle)
        else:
            self._add(comp, handle)
        return RTC.RTC_OK

    def remove_component(self, comp):
        member = self._find(comp)
        if not member:
            return RTC.BAD_PARAMETER
        member.is_leaving = True
        # its profile no longer lists it, though it is executed until the next cycle
        if self.flavour.modern:
            self._unlist(member)
        self.process.thread(self._remove, member)
        return RTC.RTC_OK

    # how it goes on inside

    def own(self, reference, servant, handle):
        """Set the component that this context belongs to."""
        self.owner = reference
        self._join(Member(reference, servant, handle))

    def cycles(self):
        """How many of its periods an execution represents."""
        return max(1, round(min(self.rate, FASTEST) * QUICKEST))

    def overdue(self, component):
        """How many cycles a component here should have executed since it did so last."""
        member = self._find(component.reference)
        if not self.running or self.dead or member is None or member.state != RTC.ACTIVE_STATE:
            return 0
        since = max(component.executed, member.history[-1][0], self.due)
        return (int((carrier.now() - since) / max(1.0 / self.rate, QUICKEST)) - 1) * self.cycles()

    def close(self):
        """The component has ended."""
        self.dead = True
        self._wake()

    def settle(self, comp):
        """Wait until no change of a component's state is under way."""
        member = self._find(comp)
        with self.changed:
            self.changed.wait_for(lambda: member.wanted is None)

    def wreck(self):
        """The thread has died: states no longer change."""
        self.dead = True
        self._wake()

    def fail(self, comp):
        """Put a component into the Error state."""
        member = self._find(comp)
        self._enter(member, RTC.ERROR_STATE, "on_aborting")

    def _find(self, comp):
        return next((m for m in self.members if comp is not None and m.reference._is_equivalent(comp)), None)

    def _run(self, running):
        if self.running == running:
            return RTC.PRECONDITION_NOT_MET
        self.running = running
        for member in list(self.members):
            self._tell(member, "on_startup" if running else "on_shutdown")
        self._wake()
        return RTC.RTC_OK

    def _wake(self):
        with self.changed:
            if self.thread is None and not self.dead:
                self.thread = self.process.thread(self._loop)
            self.changed.notify_all()

    def _change(self, comp, state, wanted):
        if comp is None and self.flavour.nil_component == "BAD_PARAM":
            raise carrier.failure("BAD_PARAM", 0x41540000, may_be_done=False)
        member = self._find(comp)
        if member is None:
            return RTC.BAD_PARAMETER
        if member.state != state:
            return RTC.PRECONDITION_NOT_MET
        if self.flavour.transition == "at once":
            self._transit(member, wanted)
            self._wake()
            return RTC.RTC_OK
        member.wanted = wanted
        self.asleep = (
            self.flavour.modern
            and not self._may_change()
            and not any(m.state == RTC.ACTIVE_STATE for m in self.members)
        )
        self._wake()
        if self.flavour.transition == "queue":
            return self.poll(member) if state == RTC.ACTIVE_STATE else RTC.RTC_OK
        return self._wait(member, state, wanted) if self.sync else RTC.RTC_OK

    def _wait(self, member, state, wanted):
        """Wait for a change of state: its return code. It is waited for longer where nothing but a busy
        machine can keep it from coming.
        """
        def has_changed():
            return member.state != state

        with self.changed:
            member.waiting += 1
            if not self.changed.wait_for(has_changed, self._limit()):
                self.changed.wait_for(lambda: has_changed() or not self._is_late(), HELD_UP)
            found = member.state
            member.waiting -= 1
            if member.is_held:
                self.changed.notify_all()
        if found == wanted:
            return RTC.RTC_OK
        return RTC.RTC_ERROR if found == state else RTC.PRECONDITION_NOT_MET

    def _is_late(self):
        """Whether nothing but a busy machine keeps its thread from changing the state of a component."""
        if not self._may_change() or self.asleep or self.dead:
            return False
        if self.is_executing or carrier.now() < self.due:
            return False
        return not any(member.takes for member in self.members)

    def _limit(self):
        """How long to wait for a change of state: half a second, and at least a period."""
        period = 1.0 / self.rate
        return TRANSITION_TIMEOUT if TRANSITION_TIMEOUT > period else period * 1.1

    def _let_callers_see(self, member):
        """Wait until those who wait for a change of its state have seen what it is now, with the lock."""
        member.is_held = True
        self.changed.wait_for(lambda: not member.waiting, HELD_UP)
        member.is_held = False

    def poll(self, member):
        """C++ 1.1 looks every ten periods whether the component has stopped, a thousand times."""
        for _ in range(1000):
            carrier.sleep(10.0 / self.rate)
            if member.state != RTC.ACTIVE_STATE:
                return RTC.RTC_OK
        return RTC.RTC_ERROR

    def _add_in_time(self, comp, handle):
        """The context of 2.x knows a component from its next cycle on."""
        carrier.sleep(self._to_cycle())
        self._add(comp, handle)

    def _add(self, comp, handle):
        with self.changed:              # one that leaves has left before it joins again
            self.changed.wait_for(lambda: not getattr(self._find(comp), "is_leaving", False), HELD_UP)
        if not self._find(comp):
            self._join(Member(comp, self.process.local_servant(comp), handle))

    def _join(self, member):
        self.members.append(member)
        self.everyone.append(member)

    def _to_cycle(self):
        return min(1.0 / self.rate, 0.3)

    def _unlist(self, member):
        self.participants = [p for p in self.participants if not p._is_equivalent(member.reference)]

    def _remove(self, member):
        carrier.sleep(self._to_cycle())
        self.members.remove(member)
        member.left = carrier.now()
        self._unlist(member)
        try:
            member.reference.detach_context(member.handle)
        except carrier.SystemException:
            self._stumble()
        self._wake()

    def _stumble(self):
        """A component that should be notified that it has left is dead: if the thread has ever run, C++ ends
        its process.
        """
        if self.flavour.dead_member == "process" and self.thread is not None:
            self.process.die()

    # the thread

    def _loop(self):
        while not self.dead:
            with self.changed:
                self.changed.wait_for(lambda: self.dead or self._asked() or self._active())
            self._sleep_to_cycle()
            for member in list(self.members):
                if member.wanted is not None and self._may_change() and not self.asleep:
                    self._transit(member, member.wanted)
                elif self.running and member.state == RTC.ACTIVE_STATE and member.busy:
                    self._execute(member)

    def _may_change(self):
        return self.running or self.flavour.stopped == "done"

    def _asked(self):
        return self._may_change() and not self.asleep and any(m.wanted is not None for m in self.members)

    def _active(self):
        return self.running and any(m.busy and m.state == RTC.ACTIVE_STATE for m in self.members)

    def _sleep_to_cycle(self):
        period = 1.0 / self.rate
        if period < QUICKEST:
            if self._asked():
                return
            period = QUICKEST
        left = period - (carrier.now() - self.born) % period
        if left < ROUNDING:  # the cycle that begins has just been waited for
            left += period
        self.due = carrier.now() + left
        with self.changed:
            self.changed.wait_for(lambda: self.dead, left)

    def _transit(self, member, wanted):
        name = {
            RTC.ACTIVE_STATE: "on_activated",
            RTC.INACTIVE_STATE: "on_deactivated" if member.state == RTC.ACTIVE_STATE else "on_reset",
        }[wanted]
        done = self._tell(member, name)
        if done == RTC.RTC_OK and self._limit() < member.takes < math.inf:
            with self.changed:          # callers have given up before, even if they are held up
                self._let_callers_see(member)
        if done == RTC.RTC_OK:
            self._enter(member, wanted)
        elif wanted == RTC.ACTIVE_STATE and self.flavour.late_error:
            self._enter(member, wanted)
            member.falls = carrier.now() + 1.0 / self.rate
            self.process.thread(self._fall_in_time, member, 1.0 / self.rate)
        else:
            self._enter(member, RTC.ERROR_STATE, "on_aborting")

    def _fall_in_time(self, member, seconds):
        carrier.sleep(seconds)
        self._fall(member)

    def _fall(self, member):
        """The state machine notices in its next cycle that a component did not become active."""
        with self.changed:
            if member.falls is None or carrier.now() < member.falls:
                return
            self._let_callers_see(member)
            if member.falls is None:
                return
            member.falls = None
        if member.state == RTC.ACTIVE_STATE:
            self._enter(member, RTC.ERROR_STATE, "on_aborting")

    def _execute(self, member):
        self.is_executing = True
        done = self._tell(member, "on_execute")
        self.is_executing = False
        if done != RTC.RTC_OK:
            self._enter(member, RTC.ERROR_STATE, "on_aborting")

    def _enter(self, member, state, callback=None):
        with self.changed:
            member.state = state
            member.history.append((carrier.now(), state))
            member.wanted = None
            self.changed.notify_all()
        if callback:
            self._tell(member, callback)

    def _tell(self, member, callback):
        try:
            return getattr(member.component, callback)(member.handle)
        except carrier.SystemException:
            return RTC.RTC_ERROR


class PeriodicContext(Behaviour, carrier.skeleton("RTC.ExecutionContextService")):
    """An ordinary context."""


class ExtTrigContext(Behaviour, carrier.skeleton("OpenRTM.ExtTrigExecutionContextService")):
    """The type that C++ 1.1 gives to every context."""

    def tick(self):
        self._wake()
