"""A recorder that is late holds up components: with the subscription "flush" they wait for its answer to each
value. With others, their values exceed the buffers of their ports.

It answers at once while the loop runs. Where the loop does not, because the machine has too much to do, or
has stopped this process, components are let go; values that are missing then are reported.
"""


from rtshell_lite import notes
from rtshell_lite.data import reading
from rtshell_lite.net import loop

SPAN = 5.0  # seconds over which is measured
LOOK = 0.05  # seconds between two looks at the clock
MOST = 0.25  # of a span, for which a component that always calls may have waited
STILL = 0.05  # seconds by which it is late when it has stood still
SETTLE = 1.0  # seconds in which ports send what has waited in their buffers; then for as long it is counted
SURE = 0.5  # share of the values that a buffer could not hold: if less is missing, nothing is reported
STOOD = "rtlog stood still, and they exceeded the port's buffer"  # why values are missing


async def watch(opened, report):
    """Measure again and again how late this process is, and let the Readers of connection.Connections go
    where that is too much. report(reader): called for each of them. Until it is cancelled.
    """
    while True:
        buffered = [_Buffered(reader) for reader in opened.live() if not reader.holds_up()]
        share, pauses = await _measure(opened)
        if pauses:
            await _report_missing(buffered, pauses)
        if share <= MOST:
            continue
        waiting = [reader for reader in opened.live() if reader.holds_up()]
        if not waiting:
            continue
        notes.note(
            f"this machine has too much to do: for {share:.0%} of {SPAN:g} s components would have waited "
            f"for rtlog; {len(waiting)} ports do not call it in their own cycle any more"
        )
        await loop.finish(opened.let_go(waiting))
        for reader in waiting:
            report(reader)


async def _measure(opened):
    """(for which part of a span this process has answered nobody, the pauses in which it stood still:
    [(first, last)] ns since the epoch); (0, []) where it was disconnected meanwhile.
    """
    begun = loop.now()
    absences = opened.absences
    late = 0.0
    pauses = []
    while loop.now() < begun + SPAN:
        due = loop.now() + LOOK
        await loop.sleep(LOOK)
        behind = loop.now() - due
        late += behind
        if behind > STILL:
            now = int(loop.wall() * 1e9)
            pauses.append((now - int(behind * 1e9), now))
    if opened.absences != absences:
        return 0.0, []
    return late / (loop.now() - begun), pauses


class _Buffered:
    """A Reader whose values wait in a buffer of its port, at the beginning of a span."""

    def __init__(self, reader):
        self.reader = reader
        self.connector = reader.connector
        self._begun = loop.now()
        self._count = reader.count
        self._rate = reader.rate()

    def is_full_after(self, seconds):
        """Whether its buffer may have been too short for so long a pause."""
        rate = self._rate or self.reader.rate()
        return rate is not None and rate * seconds > self.reader.room

    def missing(self, rate, pause):
        """About how many values have not come; `rate`: how many come a second now; `pause` (seconds): the
        longest.
        """
        rate = min(rate, self._rate or rate)
        excess = rate * pause - self.reader.room
        lacking = rate * (loop.now() - self._begun) - (self.reader.count - self._count)
        if excess > 0 and lacking > max(reading.FEWEST, SURE * excess):
            return round(lacking)
        return 0


async def _report_missing(buffered, pauses):
    """Report the values that these _Buffered have lost in pauses."""
    longest = max(last - first for first, last in pauses) / 1e9
    doubtful = [buffer for buffer in buffered if buffer.is_full_after(longest)]
    if not doubtful:
        return
    await loop.sleep(SETTLE)
    counts = [buffer.reader.count for buffer in doubtful]
    begun = loop.now()
    await loop.sleep(SETTLE)
    passed = loop.now() - begun
    for buffer, before in zip(doubtful, counts):
        reader = buffer.reader
        count = buffer.missing((reader.count - before) / passed, longest)
        if count and reader.connector is buffer.connector and reader.miss is not None:
            reader.miss(pauses[0][0], pauses[-1][1], count, STOOD)
