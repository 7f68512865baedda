"""What happens to a robot, as channels of JSON in a log: events, the components' logs, and the profile of the
whole system.

Events come as in rtwatch, but ports are asked for their connections. Observers of ports would report these;
but C++ 2.1 hangs for good if it drops connections while the process of such an observer is gone, and those
that a recorder reads by are dropped as soon as it is killed (docs/protocol.md 5.4). Logs come as in rtvlog.
The profile is an attachment, as rtcryo writes it, with another one for what details.py keeps: at the start,
and after changes.
"""


from rtshell_lite import errors, notes
from rtshell_lite.corba import orb
from rtshell_lite.datalog import schemas
from rtshell_lite.live import watch
from rtshell_lite.net import calendar, loop
from rtshell_lite.xmlprofile import rtsprofile

RECORD = "rtlog.Record"
TICK = 0.1  # seconds between two looks at what has been reported
QUIET = 2.0  # seconds without a change, after which the system is looked at
RARELY = 10.0  # seconds between two looks at the whole system
CHANGES = ("PORT_CONNECT", "PORT_DISCONNECT", "DIED", "EXITED", "BACK", "APPEARED")
SERIOUS = {"ERROR": "Error", "DIED": "died", "NO_ANSWER": "does not answer", "LET_GO": "rtlog was late"}

_RECORDS = schemas.of_json(
    RECORD, dict(dict.fromkeys(("path", "logger", "level", "message", "mark"), "string"), time="number")
)


class Journal:
    """Events and logs of the components of a datalog.flight.Flight. `listener`, if any, is called with each
    event's fields.
    """

    def __init__(self, tops, listener=None, door=None):
        """`tops`: the Paths below which the system is that is described. `door`: a forward.Door for more
        logs, or None.
        """
        self._tops = tops
        self._listener = listener
        self._door = door
        self._changed = 0.0  # when something changed that the profile shows; 0: nothing
        self._looked = 0.0
        self._number = 0
        self._work = None
        self._events = self._logs = None  # numbers of their channels

    async def run(self, flight, work):
        """Watch all components that come, until it is cancelled. `work`: a recorder.Recorder."""
        self._work = work
        self._events = work.channels.add_json("/events", schemas.of_events())
        self._logs = work.channels.add_json("/logs", _RECORDS)
        kinds = watch.Events(set(watch.KINDS) - {"HEARTBEAT"}, asks_ports=True)
        records = watch.Records("NORMAL", ())
        async with watch.Watch(kinds, _ignore) as events, watch.Watch(records, _ignore) as logs:
            try:
                await self._follow(flight, events, logs)
            finally:
                _report_dropped(events.dropped + logs.dropped)

    async def _follow(self, flight, events, logs):
        paths = set()
        if self._door is not None:
            logs.listen(self._door)
        while True:
            if len(flight.components) > len(paths):
                new = [node.path for text, (node, _) in flight.components.items() if text not in paths]
                paths |= {str(path) for path in new}
                await self._begin(new, events, logs)
            _follow_ports(flight, events)
            self._take(events, logs)
            await self._describe()
            await loop.sleep(TICK)

    async def _begin(self, paths, events, logs):
        for path in paths:
            self.put(str(path), "LIFE_EVENT", "", "APPEARED")
        await events.add(paths)
        await logs.add(paths)  # few components take loggers: the others say so

    def is_running(self):
        """Whether events can be put into the log."""
        return self._events is not None

    def _take(self, events, logs):
        for watched, event in events.taken():
            self.put(watched.where, event.kind, event.subject, event.event)
        for watched, record in logs.taken():
            fields = dict(record._asdict(), path=watched.where)
            if record.level in ("ERROR", "FATAL"):
                fields["mark"] = f"{watched.name}: {record.message[:80]}"
            self._work.put_json(self._logs, fields)

    def put(self, where, kind, subject, event):
        """Record an event of a component."""
        fields = {"path": where, "kind": kind, "subject": subject, "event": event}
        if event in SERIOUS:
            fields["mark"] = "%s: %s" % (where.rpartition("/")[2], SERIOUS[event])
        if event in CHANGES or kind == "CONFIG_EVENT":
            self._changed = loop.now()
        self._work.put_json(self._events, fields)
        if self._listener is not None:
            self._listener(fields)

    async def _describe(self):
        """Attach the profile of the system: at the start, and when it has changed and is quiet. Where it
        cannot be described, this is tried again.
        """
        now = loop.now()
        if not self._changed:
            return
        is_busy = now - self._changed < QUIET or now - self._looked < RARELY
        if self._looked and is_busy:
            return
        changed, self._changed = self._changed, 0.0
        self._looked = now
        try:
            profile, more = await describe(self._tops)
        except errors.Error:
            self._changed = self._changed or changed
            return
        self._number += 1
        moment = int(loop.wall() * 1e9)
        self._work.attach(moment, "system-%d.rtsys" % self._number, "application/xml", profile)
        self._work.attach(moment, "components-%d.json" % self._number, "application/json", more)


def _follow_ports(flight, events):
    """Have the ports that a flight has found followed, as those of the components that are there."""
    there = [watched for watched in events.followed if watched.shown is not None]
    for watched in [entry for entry in there if entry.seen is None or entry.seen.ports is None]:
        node, listed = flight.components[watched.where]
        if orb.identity(node.ref) == orb.identity(watched.node.ref):
            watched.follow_ports(listed)


def _report_dropped(number):
    if number:
        words = "events and log records dropped: they came faster than they could be written"
        notes.left_out(f"{number} {words}")


def _ignore(line):
    """Take no notice of a line that is said of a component beside events, and about loggers."""


async def describe(tops):
    """(the RtsProfile of the system below some Paths, as octets of XML; its details.dump). Raises
    errors.Error.
    """
    from rtshell_lite.system import capture, details

    system = await capture.capture(tops, True, with_states=True, with_snapshots=True)
    profile = system.profile
    profile.id = "RTSystem:rtlog:recorded:0"
    profile.creation_date = profile.update_date = calendar.local("%Y-%m-%dT%H:%M:%S")
    written = rtsprofile.dump(profile, rtsprofile.XML).encode("utf-8", "surrogateescape")
    return written, details.dump(system.found)
