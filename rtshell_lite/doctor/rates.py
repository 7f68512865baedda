"""The rates that execution contexts keep, and those that they claim: a connection to an out port shows them."""
import collections
import struct
import time

from rtshell_lite import errors
from rtshell_lite.corba import lanes
from rtshell_lite.data import connection, datatypes, reading
from rtshell_lite.doctor import remedies
from rtshell_lite.doctor.finding import ok, reason, warn
from rtshell_lite.robot import component, ports
from rtshell_lite.text import printable, shell_word

TOGETHER = 4  # components of a process measured at a time: fetching their values is work for it
ENOUGH = 0.9  # of the rate claimed
DAY = 86400.0  # seconds


class Watched:
    """A component that is Active in a running, periodic context."""

    def __init__(self, each, rate, port):
        self.each, self.rate, self.port = each, rate, port  # its snapshot.Snapshot, the Hz claimed, the port watched
        self.reader = self.failure = None  # reading.Reader; the errors.Error why it could not be measured
        self.count, self.stamp = 0, None  # values seen; (when one came, in s, the timestamp in it) where they have any
        self.stamped = (datatypes.members(port.properties.get("dataport.data_type", "")) or [None])[0] == ("tm", "Time")

    def deliver(self, message):
        """Take note of the timestamp of a reading.Message; 0 is none."""
        if self.stamped and len(message.data) >= 8:
            seconds, = struct.unpack_from("<L" if message.little else ">L", message.data)
            self.stamp = (message.received / 1e9, seconds) if seconds else None


def measured(all_of_them, seconds):
    """Measure for `seconds` each component that can be: {path: [Finding]}.

    As data/rates.py does, several at a time; no new batch begins when the timeout is over.
    """
    found, waiting = {}, []
    for each in all_of_them:
        watched, why_not = _watchable(each)
        if watched:
            waiting.append(watched)
        elif why_not:
            found[each.where] = [ok("rate", each.where, "rate not measured: " + why_not)]
    begun = time.monotonic()
    while waiting:
        batch, waiting = _batch(waiting)
        if found and time.monotonic() - begun > lanes.session.timeout:
            found.update((one.each.where, [_unmeasured(one.each, errors.Silent(one.each.where, lanes.NO_TIME))]) for one in batch)
            continue
        found.update((one.each.where, [finding] + _clock(one)) for one, finding in zip(batch, _watch(batch, seconds)))
    return found


def _batch(waiting):
    """The next components to be measured at once, and the rest."""
    taken, batch, rest = collections.Counter(), [], []
    for one in waiting:
        (batch if taken[one.each.node.endpoint] < TOGETHER else rest).append(one)
        taken[one.each.node.endpoint] += 1
    return batch, rest


def _watchable(each):
    """(Watched, '') for a component whose rate can be seen from outside, else (None, why not, '' where that is reported)."""
    running = [(context, state) for context, state in zip(each.contexts, each.states)
               if context.running and context.kind == "Periodic" and context.rate > 0]
    if each.error is not None or not running:
        return None, ""
    active = [context for context, state in running if state == "Active"]
    if not active:
        return None, f"it is {component.merged(each.states)}"
    found = [port for port in each.ports if port.type == "DataOutPort"]
    if not found:
        return None, "it has no out port"
    return Watched(each, active[0].rate, _smallest(found)), ""


def _smallest(found):
    """Of out ports, the one whose values cost least to fetch, as far as the types show."""
    return next((port for port in found if datatypes.has_fixed_size(port)), found[0])


def _unmeasured(each, e):
    if isinstance(e, errors.Silent) and e.why != lanes.NO_TIME:
        return warn("rate", each.where, "rate not measured: " + reason(e), remedies.words("measure again", path=shell_word(each.where)))
    return ok("rate", each.where, "rate not measured: " + reason(e))


# ---- one batch ------------------------------------------------------------------------------------------------

def _watch(batch, seconds):
    """A Finding for each Watched of a batch."""
    for one in batch:
        try:
            one.reader = reading.Reader(one.port, one.deliver, "pull", properties={
                "dataport.buffer.length": str(reading.QUEUE)})
        except errors.Error as e:
            one.failure = e
    with connection.Opened([one.reader for one in batch if one.reader]) as opened:
        time.sleep(2 * reading.POLL)  # values from before may be there
        before = {reader: reader.count for reader in opened.connections}
        begun = time.monotonic()
        time.sleep(seconds)
        spent = time.monotonic() - begun
        for one in batch:
            if one.reader:
                one.count, one.failure = one.reader.count - before[one.reader], one.reader.failure
    return [_unmeasured(one.each, one.failure) if one.failure else _finding(one, spent) for one in batch]


def _clock(one):
    """A Finding where the values of a Watched carry times of other days: nobody who compares times takes them for new."""
    away = one.stamp and (one.stamp[1] - one.stamp[0]) / DAY
    if not away or abs(away) < 1:
        return []
    return [warn("clock", one.each.where, "the times in its values are %.1f days %s this host's clock" % (
        abs(away), "behind" if away < 0 else "ahead of"), remedies.words("clock"))]


def _finding(one, spent):
    where, name = one.each.where, printable(ports.short_name(one.port.name, one.each.node.path.names[-1].id))
    if one.count < 2:
        return ok("rate", where, "rate not measured: nothing is written to " + name)
    kept = one.count / spent
    if one.count + 1 >= ENOUGH * one.rate * spent:  # one more may have been on its way
        return ok("rate", where, f"keeps {kept:.1f} of {one.rate:g} Hz (writes to {name})")
    return warn("rate", where, f"keeps {kept:.1f} of {one.rate:g} Hz, or does not write to {name} in each cycle",
                remedies.words("load"))
