"""Which components send heartbeats to the observers that they are lent, and how these are taken back.

A component of C++ that sends heartbeats answers late when its observer is taken back (docs/protocol.md 5).
"""

from rtshell_lite import errors
from rtshell_lite.corba import session
from rtshell_lite.live import times
from rtshell_lite.net import loop


class Leaders:
    """Which component sends heartbeats in the place of the others of its process: these show whether the
    process runs, and whether its calls reach us. A policy for who follows many follow.Followed, and shows
    nobody their heartbeats.

    An observer that a component drops after a failed call, though those of its neighbours succeed, is lent
    again in its turn: one of each process every BEAT.
    """

    def __init__(self, of_process):
        """`of_process(endpoint)`: those that are there in a process."""
        self._of_process = of_process
        self._leaders = {}  # {endpoint: the follow.Followed that sends heartbeats}
        self._turn = 0  # how many of each process were lent their observers again
        self._turn_at = 0.0  # when the next are

    def take(self, entry):
        """One is about to be lent its `subscription`."""
        leader = self._leaders.setdefault(entry.endpoint, entry)
        entry.subscription.is_led = leader is not entry
        entry.lived = loop.now()

    def led(self, endpoint):
        """Those of a process that are led."""
        return [entry for entry in self._of_process(endpoint) if entry.is_led]

    def hears(self, endpoint):
        """Whether a process sends us heartbeats."""
        leader = self._leaders.get(endpoint)
        return leader is not None and leader.heard > max(0.0, loop.now() - times.LATE)

    def late(self, now):
        """The leaders that should have called us."""
        return [leader for leader in self._leaders.values() if leader.late_at < now]

    def look(self, now):
        """Have another one lead where a leader has ended, hangs or is late; returns those that are to be lent
        their observers again.
        """
        again = []
        is_turn = now >= self._turn_at
        if is_turn:
            self._turn += 1
            self._turn_at = now + times.BEAT
        for endpoint, leader in list(self._leaders.items()):
            is_there = leader.subscription is not None and leader.endpoint == endpoint
            leads = is_there and not leader.is_hung and leader.late_at >= now
            if leads and not is_turn:
                continue
            led = [entry for entry in self.led(endpoint) if not entry.is_hung]
            if not leads and not led and is_there and not leader.is_hung:
                led = [leader]
            if not leads and is_there and led:
                leader.subscription.is_led = True
            elif not is_there:
                del self._leaders[endpoint]
            if led:
                following = led[self._turn % len(led)]
                again.append(following)
                if not leads:
                    self._leaders[endpoint] = following
                    following.lead()
        return again


async def take_all_back(lent):
    """Have follow.Followed forget the observers that they have been lent, in a few seconds at most: first
    those that send no heartbeats.
    """
    lent = [entry for entry in lent if entry.subscription is not None]
    for is_led, seconds in ((True, times.FAREWELL), (False, times.HURRY)):
        await take_back([entry.subscription for entry in lent if entry.is_led is is_led], seconds)
    for entry in lent:
        entry.forget()


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
