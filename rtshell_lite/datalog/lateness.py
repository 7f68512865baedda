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

    def is_full_after(self, pauses):
        """Whether its buffer may have been too short for the longest pause."""
        rate = self._rate
        if rate is None:  # the span began when few had come; in pauses none does
            reading_for = loop.now() - self._begun - sum(map(_seconds, pauses))
            rate = (self.reader.count - self._count) / max(reading_for, LOOK)
        return rate * _longest(pauses) > self.reader.room

    def report(self, rate, pauses):
        """Report what has not come; `rate`: how many values come a second now."""
        reader = self.reader
        rate = min(rate, self._rate or rate)
        excess = rate * _longest(pauses) - reader.room
        lacking = rate * (loop.now() - self._begun) - (reader.count - self._count)
        is_lost = excess > 0 and lacking > max(reading.FEWEST, SURE * excess)
        if is_lost and reader.connector is self.connector and reader.miss is not None:
            reader.miss(pauses[0][0], pauses[-1][1], round(lacking), STOOD)


async def _report_missing(buffered, pauses):
    """Report the values that these _Buffered have lost in pauses."""
    doubtful = [buffer for buffer in buffered if buffer.is_full_after(pauses)]
    if not doubtful:
        return
    await loop.sleep(SETTLE)
    counts = [buffer.reader.count for buffer in doubtful]
    begun = loop.now()
    await loop.sleep(SETTLE)
    passed = loop.now() - begun
    for buffer, before in zip(doubtful, counts):
        buffer.report((buffer.reader.count - before) / passed, pauses)


def _seconds(pause):
    first, last = pause
    return (last - first) / 1e9


def _longest(pauses):
    """The seconds of the longest one."""
    return max(map(_seconds, pauses))
