"""A recorder that is late holds up components: with the subscription "flush" they wait for its answer to each
value.

It answers at once while the loop runs. Where the loop does not, because the machine has too much to do, or
has stopped this process, components are let go.
"""

import time

from rtshell_lite import notes
from rtshell_lite.net import loop

SPAN = 5.0  # seconds over which is measured
LOOK = 0.05  # seconds between two looks at the clock
MOST = 0.25  # of a span, for which a component that always calls may have waited


async def watch(opened, report):
    """Measure again and again how late this process is, and let the Readers of connection.Connections go
    where that is too much. report(reader): called for each of them. Until it is cancelled.
    """
    while True:
        share = await _measure(opened)
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
    """For which part of a span this process has answered nobody; 0 where it was disconnected meanwhile."""
    begun = time.monotonic()
    absences = opened.absences
    late = 0.0
    while time.monotonic() < begun + SPAN:
        due = time.monotonic() + LOOK
        await loop.sleep(LOOK)
        late += time.monotonic() - due
    if opened.absences != absences:
        return 0.0
    return late / (time.monotonic() - begun)
