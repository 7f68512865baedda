"""The rates that execution contexts keep, against those that they claim: measured at an out port."""

from rtshell_lite import errors, notes
from rtshell_lite.corba import session
from rtshell_lite.data import clocks, connection, datatypes, reading
from rtshell_lite.data.rates import next_batch
from rtshell_lite.doctor import buffers, remedies
from rtshell_lite.doctor.finding import ok, reason, warn
from rtshell_lite.net import loop
from rtshell_lite.robot import component, ports
from rtshell_lite.text import printable, shell_word

ENOUGH = 0.9  # of the rate claimed
PIECE = 0.01  # seconds slept at a time, to see how late this process is woken


class Watched:
    """A component that is Active in a running, periodic context."""

    def __init__(self, snapshot, rate, port):
        # Hz claimed, port watched
        self.snapshot = snapshot
        self.where = snapshot.where
        self.rate = rate
        self.port = port
        self.reader = self.failure = None  # reading.Reader; the errors.Error why it could not be measured
        self.count = 0  # values seen
        self.stamp = None  # (when one came, in s, the timestamp in it) where they have any
        self.stamped = clocks.is_stamped(port)

    def deliver(self, message):
        """Take note of the timestamp of a reading.Message."""
        seconds = clocks.seconds(message) if self.stamped else 0
        self.stamp = (message.received / 1e9, seconds) if seconds else None


async def measured(snapshots, seconds):
    """Measure each component that can be, for `seconds`, several at a time: {path: [Finding]}.

    No new batch begins when the timeout is over.
    """
    findings = {}
    waiting = []
    for snapshot in snapshots:
        watched, why_not = _watchable(snapshot)
        if watched:
            waiting.append(watched)
        elif why_not:
            findings[snapshot.where] = [ok("rate", snapshot.where, "rate not measured: " + why_not)]
    begun = loop.now()
    while waiting:
        batch, waiting = next_batch(waiting, lambda watched: watched.snapshot.node.endpoint)
        if findings and loop.now() - begun > session.current().timeout:
            findings.update(
                (watched.where, [_unmeasured(watched.where, errors.NoTime(watched.where, session.NO_TIME))])
                for watched in batch
            )
            continue
        findings.update(
            (watched.where, [finding] + _clock(watched))
            for watched, finding in zip(batch, await _watch(batch, seconds))
        )
    return findings


def _watchable(snapshot):
    """(Watched, '') for a component whose rate can be measured, else (None, why not;
    '' if that is reported elsewhere).
    """
    running = [
        (context, state)
        for context, state in zip(snapshot.contexts, snapshot.states)
        if context.running and context.kind == "Periodic" and context.rate > 0
    ]
    if snapshot.error is not None or not running:
        return None, ""
    active = [context for context, state in running if state == "Active"]
    if not active:
        return None, f"it is {component.merged(snapshot.states)}"
    out_ports = [port for port in snapshot.ports if port.type == "DataOutPort"]
    if not out_ports:
        return None, "it has no out port"
    refused = [port for port in out_ports if buffers.refusal(port)]  # what is written there is of interest
    return Watched(snapshot, active[0].rate, _smallest(refused or out_ports)), ""


def _smallest(out_ports):
    """The out port whose values cost least to fetch, as far as the types show."""
    return next((port for port in out_ports if datatypes.has_fixed_size(port)), out_ports[0])


def _unmeasured(where, e):
    if isinstance(e, errors.Silent):
        return warn(
            "rate", where, "rate not measured: " + reason(e),
            remedies.words("measure again", path=shell_word(where)),
        )
    return ok("rate", where, "rate not measured: " + reason(e))


# ---- one batch ----


async def _watch(batch, seconds):
    """A Finding for each Watched of a batch."""
    for watched in batch:
        try:
            watched.reader = reading.Reader(
                watched.port, watched.deliver, "pull",
                properties={"dataport.buffer.length": str(reading.QUEUE)},
            )
        except errors.Error as e:
            watched.failure = e
    async with connection.Connections([watched.reader for watched in batch if watched.reader]) as opened:
        await loop.sleep(2 * reading.POLL)  # older values may be there
        before = {reader: reader.count for reader in opened.connections}
        spent, missed = await _slept(seconds)
        for watched in batch:
            if watched.reader:
                watched.count = watched.reader.count - before[watched.reader]
                watched.failure = watched.reader.failure
    return [
        _unmeasured(watched.where, watched.failure) if watched.failure else _finding(watched, spent, missed)
        for watched in batch
    ]


async def _slept(seconds):
    """Sleep so long: the time that it took, and how much of that this process was not let run:
    its host has more to do than it can.
    """
    begun = loop.now()
    missed = 0.0
    now = begun
    with notes.Work("s", round(seconds)) as work:
        while now < begun + seconds:
            piece = min(PIECE, begun + seconds - now)
            await loop.sleep(piece)
            before = now
            now = loop.now()
            missed += now - before - piece
            work.reach(int(now - begun))
    return now - begun, missed


def _clock(watched):
    """A Finding if the values of a Watched carry other times than this host's."""
    message = clocks.difference(*watched.stamp) if watched.stamp else ""
    if message:
        return [warn("clock", watched.where, message, remedies.words("clock"))]
    return []


def _finding(watched, spent, missed):
    """What was counted in `spent` seconds,
    in which this host was too busy for `missed` seconds to let us run, and perhaps others.
    """
    where = watched.where
    name = printable(ports.short_name(watched.port.name, watched.snapshot.node.path.instance))
    if watched.count < 2:
        number = "one value was" if watched.count else "nothing was"
        seen = f"{number} written to {name} in {round(spent, 1):g} s"
        return ok("rate", where, f"rate not measured: {seen}" + _tracing(watched))
    kept = watched.count / spent
    watched.snapshot.written = (watched.port, kept)
    watched.snapshot.stamp = watched.stamp
    if watched.count + 1 >= ENOUGH * watched.rate * (spent - missed):  # one more may have been on its way
        return ok("rate", where, f"keeps {kept:.1f} of {watched.rate:g} Hz (writes to {name})")
    return warn(
        "rate", where, f"keeps {kept:.1f} of {watched.rate:g} Hz, or does not write to {name} in each cycle",
        _slow(watched),
    )


def _slow(watched):
    """The Remedy for a component that writes fewer values than it claims cycles."""
    host = printable(watched.snapshot.node.endpoint[0])
    if _is_fed(watched):
        return remedies.words("load or values", host=host, port=shell_word(ports.label(watched.port)))
    return remedies.words("load", host=host)


def _tracing(watched):
    """How to see whether values come to a component that writes none, '' for one that gets none."""
    if _is_fed(watched):
        return f" (rttrace -u {shell_word(ports.label(watched.port))} shows whether values come to it)"
    return ""


def _is_fed(watched):
    """True if other components may send values to this one."""
    return any(port.type == "DataInPort" and port.connectors for port in watched.snapshot.ports)
