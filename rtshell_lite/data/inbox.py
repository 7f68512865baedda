"""A queue of values that have arrived: adding one never blocks; what does not fit is dropped and counted."""

import collections
import functools

from rtshell_lite.net import loop

MOST = 100000  # values
MOST_BYTES = 64 << 20  # robots have little memory
EACH = 150  # octets that a value takes besides its own
GATHER = 0.005  # seconds in which more values may come: handing over each one costs more than the value


class Inbox:
    """A bounded queue of (key, Message); `dropped` counts by key what did not fit."""

    def __init__(self, most=MOST, most_bytes=MOST_BYTES, gather=GATHER, enough=MOST_BYTES):
        """get() waits `gather` seconds for more values after the first one, or until there are `enough`
        octets.
        """
        self.most = most
        self.most_bytes = most_bytes
        self.gather = gather
        self.enough = enough
        self.is_enough = loop.Bell()
        self.waiting = []
        self.bytes = 0
        self.in_hand = 0  # bytes that get() has given out last: they take memory, too
        self.dropped = collections.Counter()
        self.lose = None  # function(key, when it arrived), called for each value that is dropped, or None
        self.arrived = loop.Bell()

    def put(self, key, message):
        """Add a value. One always fits, however big."""
        size = len(message.data) + EACH
        if self.waiting and (
            len(self.waiting) >= self.most or self.in_hand + self.bytes + size > self.most_bytes
        ):
            self.dropped[key] += 1
            if self.lose is not None:
                self.lose(key, message.received)
            return
        self.waiting.append((key, message))
        self.bytes += size
        if len(self.waiting) == 1:
            self.arrived.ring()
        if self.bytes >= self.enough:
            self.is_enough.ring()

    def taker(self, key):
        """The function that takes the values of `key`."""
        return functools.partial(self.put, key)

    async def get(self, seconds):
        """All values so far, as a list in their order;
        waits up to `seconds` for the first one, then for more.
        """
        if seconds:
            if not self.waiting:
                await self.arrived.wait(seconds)
            await self.is_enough.wait(min(seconds, self.gather))
        taken = self.waiting
        self.waiting = []
        self.arrived = loop.Bell()
        self.is_enough = loop.Bell()
        self.in_hand = self.bytes
        self.bytes = 0
        return taken
