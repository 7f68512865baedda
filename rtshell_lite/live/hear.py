"""Observers that are lent, and taken back. rttop lends them to the components of a large system: these report
what changes, and need not be asked for it.

One component of each process sends heartbeats: while these come, the others can report, too. A component of
C++ that sends them answers late when its observer is taken back (docs/protocol.md 5).
"""


from rtshell_lite import errors
from rtshell_lite.corba import session
from rtshell_lite.live import observer, times
from rtshell_lite.net import loop
from rtshell_lite.robot import component

KINDS = ("RTC_STATUS", "EC_EVENT", "PORT_EVENT")
NEVER = float("-inf")


class _Process:
    """What is known of a process that has observers of ours."""

    def __init__(self):
        self.heard = NEVER  # when one of its components last called, by loop.now()
        self.beating = None  # the Subscription of the one that sends heartbeats
        self.asked = NEVER  # when that was asked to send them
        self.is_deaf = False  # whether its components cannot call us


class Hearing:
    """The observers that are lent to model.Entries, `subscription` of each."""

    def __init__(self):
        self._lent = set()
        self._processes = {}  # by endpoint

    def reports(self, entry):
        """Whether a component would have reported what has changed."""
        if entry.subscription is None:
            return False
        return self._processes[entry.node.endpoint].heard > loop.now() - times.LATE

    async def lend(self, entry):
        """Lend a component an observer, if it takes one, or again if it may have lost it. Its ports have just
        been asked (docs/protocol.md 1.1). Raises Unreachable, Refused.
        """
        if entry.takes_none:
            return
        process = self._processes.setdefault(entry.node.endpoint, _Process())
        now = loop.now()
        is_late = max(process.heard, process.asked) < now - times.LATE
        if process.is_deaf or entry.subscription is not None and not is_late and not entry.is_in_doubt:
            return
        entry.is_in_doubt = False
        if is_late and process.beating is not None and process.heard == NEVER:
            process.is_deaf = True
            await self.take_back([lent for lent in self._lent if lent.node.endpoint == entry.node.endpoint])
            return
        if entry.subscription is None:
            await self._make(entry, process)
        if entry.takes_none:
            return
        beat = None
        if is_late:
            beat = times.BEAT
            process.asked = now
            process.beating = entry.subscription
        entry.subscription.properties = observer.requested(
            entry.subscription.interface, KINDS, beat, observer.NO_VALUES
        )
        try:
            await entry.subscription.attach()
        except errors.Refused:
            entry.takes_none = True
            self.forget(entry)

    async def _make(self, entry, process):
        kind = observer.preferred(dict((await component.profile(entry.node)).properties))
        if kind is None:
            entry.takes_none = True
            return

        def hear(event):
            process.heard = loop.now()
            entry.hear(event)

        entry.subscription = observer.Subscription(entry.node, kind, (), hear)
        self._lent.add(entry)

    def forget(self, entry):
        """A component is gone, with its observer."""
        if entry.subscription is None:
            return
        process = self._processes[entry.node.endpoint]
        if process.beating is entry.subscription:
            process.asked = process.heard = NEVER
            process.beating = None
        entry.subscription.forget()
        entry.subscription = None
        self._lent.discard(entry)

    async def take_all_back(self):
        """Take all observers back, for a few seconds at most."""
        await self.take_back(self._lent)

    async def take_back(self, entries):
        """Take the observers of some components back, for a few seconds at most."""
        entries = [entry for entry in entries if entry.subscription is not None]
        beating = {process.beating for process in self._processes.values()}
        quiet = [entry.subscription for entry in entries if entry.subscription not in beating]
        others = [entry.subscription for entry in entries if entry.subscription in beating]
        await take_back(quiet, times.FAREWELL)
        await take_back(others, times.HURRY)
        for entry in entries:
            self.forget(entry)


async def take_back(subscriptions, seconds=None):
    """Have components forget Subscriptions, in `seconds` at most; returns those whose component did not
    answer. Whatever calls them later gets OBJECT_NOT_EXIST.
    """
    left = [subscription for subscription in subscriptions if subscription.reference is not None]

    async def detach(subscription):
        try:
            await subscription.detach()
        except errors.Unanswered:
            raise
        except errors.Error:
            pass  # it is gone, or never had it
        left.remove(subscription)

    everywhere = session.each(list(left), detach)
    try:
        if seconds is None:
            await everywhere
        else:
            await loop.race(everywhere, loop.sleep(seconds))
    finally:
        for subscription in subscriptions:
            subscription.forget()
    return left
