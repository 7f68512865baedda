"""When the entries of a log are due, while somebody pauses, steps, jumps, or has it begin again."""

import math

from rtshell_lite.net import loop

JUMP = 5.0  # seconds
ROUND = 0.1  # seconds that a log takes at least that is played again and again: it may have one moment only
RUN = 16  # entries that are late, after which others go on
GRACE = 0.5  # seconds after the end in which what was due before it is still played
SET_BACK = 1e9  # ns by which an entry is earlier than the one before where the clock was set back


class Pace:
    """Plays the entries of a play.Range of a Log, `rate` times as fast as they came, the first at once.

    cycle      seconds, at multiples of which entries are due, or None
    seconds    after which there are no more, not even late ones
    is_looped  again and again

    `position` is when the last entry came (ns since the epoch), `count` how many entries were due,
    `is_elsewhere` whether the last one does not follow the one before, `behind` by how many seconds it was
    late in the end, with entries that were due and left out. Raises errors.Failed where there is no entry in
    the range.
    """

    def __init__(self, log, chosen, rate=1.0, cycle=None, seconds=math.inf, is_looped=False):
        chosen.entries(log)
        self._log = log
        self._chosen = chosen
        self.rate = rate
        self._cycle = cycle
        self._seconds = seconds
        self._is_looped = is_looped
        self.position = None
        self.count = 0
        self.is_elsewhere = True
        self.behind = 0.0
        self.is_paused = False
        self._steps = 0
        self._target = None  # ns since the epoch, to jump to
        self._bell = loop.Bell()
        self._origin = None  # (loop.now(), ns since the epoch) that belong together
        self._due = 0.0  # when the last entry was due, by loop.now()
        self._begun = 0.0  # when the first entry was due
        self._late = 0
        self._is_over = False

    # ---- what somebody does ----

    def pause(self):
        """Pause, or go on."""
        self.is_paused = not self.is_paused
        self.resume()

    def resume(self):
        """Go on from the next entry: this process was stopped, or paused."""
        self._origin = None
        self._bell.ring()

    def step(self):
        """Play one entry, and pause."""
        self.is_paused = True
        self._steps += 1
        self._bell.ring()

    def jump(self, seconds):
        """Go on so much later, or earlier if it is negative."""
        if self.position is not None:
            self._target = self.position + int(seconds * 1e9)
            self._bell.ring()

    # ---- what is due ----

    async def entries(self):
        """Each entry when it is due."""
        end = loop.now() + self._seconds
        first = None
        while not self._is_over:
            self.is_elsewhere = True
            is_empty = True
            async for entry in self._from(first, end):
                is_empty = False
                yield entry
                self.is_elsewhere = False
            first = None
            if self._target is not None:
                self._origin = None
                first = self._number_at(self._target)
                self._target = None
            elif is_empty or not self._is_looped:
                return

    def _number_at(self, moment):
        number = self._log.since(moment)
        return max(self._log.count - 1, 0) if number is None else number

    async def _from(self, first, end):
        is_begin = True
        for entry in self._chosen.entries(self._log, first):
            if is_begin:
                self._begin_with(entry, first is not None)
            is_begin = False
            if not await self._wait_until_due(entry, end):
                return
            self.position = entry.received
            self.count += 1
            yield entry

    def _begin_with(self, entry, is_jump):
        if self._origin is not None:  # once more from the beginning
            self._begun = max(self._due, self._begun + ROUND)
            self._origin = self._begun, entry.received
        if is_jump:  # it is seen, and jumped from, while paused
            self.position = entry.received

    async def _wait_until_due(self, entry, end):
        """Wait until an entry is due; False where somebody wants another one, or the end comes before."""
        while self._target is None:
            now = loop.now()
            if self._steps:
                self._steps -= 1
                self._origin = None
                return True
            if self.is_paused and now < end:
                await self._bell.wait(min(end - now, loop.FOREVER))
                continue
            self._schedule(entry, now)
            if self._due <= end and now > end + GRACE:
                self.behind = now - self._due
                self._is_over = True
                return False
            if self._due <= min(now, end):
                await self._let_others()
                return True
            if now >= end:
                self._is_over = True
                return False
            await self._bell.wait(min(self._due, end) - now)
        return False

    async def _let_others(self):
        """Let others go on where entry after entry is late."""
        self._late += 1
        if self._late % RUN == 0:
            await loop.sleep(0)

    def _schedule(self, entry, now):
        """Find out when an entry is due."""
        if self._origin is None:
            self._begun = now
        if self._origin is None or self.position and entry.received < self.position - SET_BACK:
            self._origin = now, entry.received
        begun, first = self._origin
        elapsed = (entry.received - first) / 1e9 / self.rate
        if self._cycle:
            elapsed = math.ceil(elapsed / self._cycle) * self._cycle
        self._due = begun + elapsed
