"""Watching components: what they report, whether they live, when they come back."""

import collections

from rtshell_lite import errors, notes
from rtshell_lite.corba import orb, session
from rtshell_lite.live import ask, follow, hear, observer, times
from rtshell_lite.live.observer import Event
from rtshell_lite.net import loop
from rtshell_lite.robot import component, snapshot, tree

RATE = 1 / component.POLL  # Hz
# items that may wait to be printed, and characters in them
MOST = 100000
MOST_CHARACTERS = 16 << 20
# items that are printed at a time, and about how many characters in them: each may be printed as ten
BATCH = 1000
BATCH_CHARACTERS = 1 << 18

LIFE = "LIFE_EVENT"  # the kind of our own Events: DIED EXITED BACK NO_HEARTBEAT NO_ANSWER ANSWERS
KINDS = list(observer.KINDS) + [LIFE]


# {kind of questions: every how many looks they are asked}, of those that take no observer; and about ports
_POLLED = {ask.contexts: 5, ask.states: 1, ask.configuration: 5}
_ASKED_PORTS = {ask.which_ports: 10, ask.connections: 10}
MOST_PORTS = 30  # that are asked for their connections in a second


class Events:
    """Watch for events of some of KINDS; `more` are further (property, value) for observers. `asks_ports`:
    ports are asked what happens to them, those that `Watched.follow_ports` is given.
    """

    def __init__(self, kinds, more=(), asks_ports=False):
        self.kinds = set(kinds)
        self.more = more
        self._observed = self.kinds - {LIFE}
        self._polled = {
            kind: looks
            for kind, looks in _POLLED.items()
            if kind is ask.contexts or ask.SHOWS[kind] in self.kinds
        }
        self.asks = dict(self._polled)
        self.asks_ports = asks_ports
        if asks_ports:
            self._observed.discard("PORT_EVENT")
            self.asks.update(_ASKED_PORTS)

    async def subscription(self, node, heard):
        """The observer to attach to a component, of the first kind that it takes, or None."""
        kinds = [observer.OBSERVER, observer.FSM_OBSERVER]
        if self.kinds - {LIFE, "HEARTBEAT"} == {
            "FSM_EVENT"
        }:  # else OpenRTM's own, which more components were built for
            kinds.reverse()
        offered = observer.taken(await observer.properties(node))
        for interface in kinds:
            if interface in offered:
                return observer.observer(node, interface, self._observed, heard, more=self.more)
        return None

    async def poll(self, seen):
        """Have a first look at a component that is to be polled, into its ask.Seen. Raises Refused if polling
        shows none of the wanted events.
        """
        if not self.kinds & ({ask.SHOWS[kind] for kind in _POLLED} | {LIFE}):
            kinds = ", ".join(sorted(self.kinds))
            raise errors.Refused(seen.where, f"offers no observer, and polling does not show {kinds}")
        await seen.look(self._polled)


class Records:
    """Watch for log records."""

    kinds = set()
    asks = {}  # type: dict
    asks_ports = False

    def __init__(self, level, names):
        self.level = level
        self.names = names

    def wants(self, record):
        """Whether a Record of a component that was not asked for these is one of them."""
        if self.names and record.logger not in self.names:
            return False
        levels = list(observer.ALL_LEVELS)
        if record.level not in levels:
            return True
        return levels.index(record.level) <= levels.index(self.level)

    async def subscription(self, node, heard):
        """The logger to attach to a component. Raises Refused for one that takes none."""
        properties = await observer.properties(node)
        if observer.LOGGER not in observer.taken(properties):
            raise errors.Refused(str(node.path), "takes no loggers")
        subscription = observer.logger(node, self.level, self.names, heard)
        if properties.get("language") == "C++":  # LoggerConsumer of 2.1 lacks the code
            subscription.remark = "takes a logger, but components of C++ (up to 2.1) write nothing to it"
        return subscription


class Watched(follow.Followed):
    """One component that is being watched."""

    beat = times.BEAT_SHOWN
    since = 0.0  # when it was given an observer, or last found to live without having called us
    is_begun = False  # whether it is watched: not as long as it does not take our observer
    is_attached_again = False
    is_sought = False  # not by two tasks at a time
    is_refusing = False  # to be watched: its ports alone are followed
    reported_silence = None  # NO_ANSWER or NO_HEARTBEAT

    def __init__(self, watch, node):
        super().__init__(node.path)
        self.watch = watch
        self.shown = snapshot.Snapshot(node)
        self.name = str(self.path)  # in lines; its path if two have the same
        if self.path.names:
            self.name = str(self.path.names[-1])

    @property
    def reports(self):
        return self.subscription is not None or not self.is_begun

    async def begin(self):
        """Start to watch. Raises Refused, Unreachable."""
        self.heard = 0.0
        self.is_attached_again = False
        self.reported_silence = None
        subscription = self.subscription = await self._lendable()
        if subscription is None:
            await self._poll()
            self.note(f"offers no observer; it is polled ({RATE:g} Hz), which shows no connections")
        else:
            self.since = self.lived = loop.now()
            await subscription.attach()
            if subscription.remark:
                self.note(subscription.remark)
        self.since = self.lived = loop.now()
        self.is_hung = False
        self.is_begun = self.is_sought = self.node is not None

    async def _lendable(self):
        """The Subscription to attach, None if it takes none: the last one again, if this object may have it.
        Two would report each event twice.
        """
        subscription = await self.watch.what.subscription(self.node, self.hear)
        if subscription is None:
            return None
        identity = orb.identity(self.node.ref)
        for earlier in self.watch.left:
            if earlier.reference is not None and orb.identity(earlier.node.ref) == identity:
                self.watch.left.remove(earlier)
                return earlier
        return subscription

    def hear(self, item):
        self.heard = loop.now()
        if isinstance(item, Event) and item.event == "FINALIZE":
            self.is_ending = True
            self.watch.look_soon()
        self.reported(item)
        if self.reported_silence == "NO_HEARTBEAT":
            self.answered()

    async def _poll(self):
        shown = self.shown
        seen = self.seen or ask.Seen(self.node, self._asks_port)
        await self.watch.what.poll(seen)
        if self.shown is shown:  # not another one that has come meanwhile
            self.seen = seen
            self.watch.look_soon()

    def follow_ports(self, listed):
        """Ask its ports.Ports for their connections from now on."""
        if self.seen is None:
            self.seen = ask.Seen(self.node, self._asks_port)
            self.watch.look_soon()
        self.seen.take_ports(listed)

    def _asks_port(self, port):
        """Whether a port is asked for its connections: a composite shows those of its members, which may be
        watched, too.
        """
        if port.owner in (None, self.seen.identity):
            return True
        others = [other.seen for other in self.watch.followed if other is not self and other.seen is not None]
        return not any(seen.identity == port.owner for seen in others)

    def is_heard(self):
        """Whether it has called us recently, or recently got an observer."""
        is_late = loop.now() - max(self.heard, self.since) > times.BEATS_LATE * self.beat
        return self.reported_silence is None and not is_late

    # ---- what is noticed ----

    def reported(self, event):
        self.watch.put(self, event)

    def appeared(self):
        self.is_sought = False
        self.watch.start(self._come_back(), self.endpoint)

    async def _come_back(self):
        try:
            await self.begin()
            self.report("BACK")
        except errors.Refused as e:
            self.leave(e)
            self.note(f"is back, but {e.why}")
        except errors.Error as e:
            self.leave(e)  # not yet
            self.is_sought = True

    def leave(self, error):
        """It cannot be watched; it may have our observer all the same."""
        self.error = error
        if self.subscription is not None and self.subscription.reference is not None:
            self.watch.left.append(self.subscription)
        self.subscription = None
        self.is_refusing = self.watch.what.asks_ports and isinstance(error, errors.Refused)
        if not self.is_refusing:
            self.shown = self.seen = None

    def vanished(self, seen):
        if self.is_begun:
            self.is_begun = self.is_sought = False
            self.watch.start(self._report_end(seen))
        elif self.is_refusing:
            self.is_refusing = False
            self.is_sought = True

    async def _report_end(self, seen):
        """Those that exit take their names with them; the others are dead, or cannot be reached."""
        has_exited = seen == "has exited"
        if not has_exited:
            try:
                await tree.resolve(self.path)
            except errors.NotFound:
                has_exited = True
            except errors.Error:
                pass
        if has_exited:
            self.report("EXITED")
        elif isinstance(self.error, errors.MaybeGone):
            self._fall_silent("NO_ANSWER", self.error.why)
        else:
            self.report("DIED")
        self.is_sought = True

    def hung(self, error):
        if self.is_begun:
            self._fall_silent("NO_ANSWER", error.why)

    def answered(self):
        if self.reported_silence is not None:
            self.reported_silence = None
            self.since = loop.now()
            self.report("ANSWERS")

    def lives(self):
        if not self.is_begun:  # it may be slow to take our observer
            return
        lost = times.BEATS_LOST * self.beat
        beats = self.subscription is not None and self.subscription.interface != observer.LOGGER
        if beats and loop.now() - max(self.heard, self.since) >= lost:
            self._fall_silent("NO_HEARTBEAT", f"no heartbeat for {lost:g} s")
            self.since = loop.now()
            self.watch.start(self._have_heard(), self.endpoint)

    async def _have_heard(self):
        """Attach the observer again, as a live component may have lost it after a failed call;
        poll where that does not help.
        """
        subscription = self.subscription
        if subscription is None:  # it has ended since this task was begun
            return
        try:
            if self.heard and not self.is_attached_again:
                self.is_attached_again = True
                await subscription.attach()
                return
            await self._poll()
            if self.subscription is not subscription:  # it has ended meanwhile
                return
            self.reported_silence = self.subscription = None
            self.note(f"cannot call us at {subscription.address}; it is polled from now on")
            self.watch.left.append(subscription)
            await subscription.detach()  # its calls to where it cannot reach us would only hold it up
        except errors.Error:
            pass  # whether it lives is asked elsewhere

    def _fall_silent(self, word, why):
        if self.reported_silence != word:
            self.reported_silence = word
            self.report(word)
            self.note(why)

    def report(self, word):
        """Put an Event of its life."""
        self.watch.put(self, Event(loop.wall(), LIFE, "", word))

    def note(self, line):
        """Say something about it beside events."""
        self.watch.note(self, line)


def _size(item):
    """Characters of the texts in an Event or a Record."""
    return sum(len(part) for part in item if isinstance(part, str))


class Watch(follow.Presence):
    """Several components that are being watched: `async with Watch(Events(kinds)) as watching: …`."""

    def __init__(self, what, note=notes.note):
        """`what`: Events or Records. `note` is called with lines about anything but events."""
        super().__init__([], component.POLL)
        self.what = what
        self.asks = dict(what.asks)
        self._note = note
        self._doors = []
        self.dropped = 0
        # what waits to be printed, and how many characters that has
        self._items = collections.deque()
        self._size = 0
        # rings when items have come
        self._bell = loop.Bell()
        self._is_hurried = False
        self.left = []  # observers of those that are not watched

    async def __aexit__(self, kind, error, traceback):
        self._is_hurried = error is not None and not isinstance(error, (Exception, loop.Cancelled))
        await super().__aexit__(kind, error, traceback)

    async def add(self, paths):
        """Watch the component at each path, too; an errors.Error or a Watched for each. One that asks ports
        follows those that cannot be watched yet, all the same.
        """

        async def begin(node):
            watched = Watched(self, node)
            self.followed.append(watched)
            try:
                await watched.begin()
            except errors.Error as e:
                watched.leave(e)
                watched.is_sought = self.what.asks_ports and not watched.is_refusing
                if not self.what.asks_ports:
                    self.followed.remove(watched)
                raise
            return watched

        results = await tree.on_components(paths, begin)
        names = [watched.name for watched in self.followed]
        for watched in results:
            if isinstance(watched, Watched) and names.count(watched.name) > 1:
                watched.name = watched.where
        return results

    def queue_of(self, entry):
        """Each alone: one that is slow to answer does not delay what others show."""
        return entry.where

    def ask_around(self, now):
        count = sum(len(entry.seen.ports or ()) for entry in self.followed if entry.seen is not None)
        for kind in _ASKED_PORTS.keys() & self.asks.keys():
            self.asks[kind] = max(_ASKED_PORTS[kind], count / MOST_PORTS / self.look)
        return super().ask_around(now)

    def lend_again(self, entry):
        """Nothing: see Watched.lives."""

    def listen(self, door):
        """Take what comes at a forward.Door, too, until the end."""
        self._doors.append(door)
        self.start(door.serve(self._put_wanted, self._has_room))

    def _has_room(self):
        """Whether those who send to a forward.Door are read; what components send has more room."""
        return len(self._items) < MOST / 2 and self._size < MOST_CHARACTERS / 2

    def _put_wanted(self, source, record):
        if self.what.wants(record):
            self.put(source, record)

    def put(self, watched, item):
        """Add an Event or a Record: what nobody reads is dropped and counted."""
        if isinstance(item, Event) and item.kind not in self.what.kinds and not self._unknown(item):
            if item.kind == LIFE and item.event in ("DIED", "EXITED", "BACK", "ANSWERS"):
                self.note(
                    watched,
                    {
                        "DIED": "its process is gone",
                        "BACK": "is back",
                        "EXITED": "has exited",
                        "ANSWERS": "answers again",
                    }[item.event],
                )
            return
        size = _size(item)
        if len(self._items) >= MOST or self._size + size > MOST_CHARACTERS:
            self.dropped += 1
            return
        self._items.append((watched, item))
        self._size += size
        self._bell.ring()

    def _unknown(self, item):
        return item.kind not in KINDS and len(self.what.kinds) == len(KINDS)

    def note(self, watched, line):
        self._note(f"{watched.where}: {line}")

    async def follow(self, number, seconds):
        """Yield lists of (Watched, Event or Record): `number` of these in all (below 0: without end), for
        `seconds`.

        Raises Failed when fewer came in time.
        """
        end = loop.now() + seconds
        left = number
        while left and (self.followed or self._doors) and loop.now() < end:
            batch = self._take(min(left, BATCH)) if left > 0 else self._take(BATCH)
            if batch:
                left -= len(batch)
                yield batch
            else:
                await self._bell.wait(end - loop.now())
        if self.dropped:
            self._note(f"{self.dropped} lines dropped: they came faster than they could be printed")
        if left > 0 and (self.followed or self._doors):
            raise errors.Failed(
                ", ".join([watched.where for watched in self.followed] + ["--listen"] * len(self._doors)),
                f"{number - left} of {number} within {seconds:g}s",
            )

    def taken(self):
        """What has come: [(Watched, Event or Record)]."""
        return self._take(BATCH)

    def _take(self, most):
        batch = []
        size = 0
        while self._items and len(batch) < most and size < BATCH_CHARACTERS:
            batch.append(self._items.popleft())
            size += _size(batch[-1][1])
        self._size -= size
        return batch

    async def _detach_all(self):
        """Detach all that was attached, and report components that do not answer; those that were heard
        recently will do it even where their answers are not waited for.
        """
        lent = [watched.subscription for watched in self.followed if watched.subscription is not None]
        stuck = await hear.take_back(lent + self.left, times.HURRY_SHOWN if self._is_hurried else None)
        turned_away = session.current().turned_away
        if turned_away:
            notes.left_out(
                f"{turned_away} connections to this command were turned away, as too many came: "
                "events may be missing"
            )
        unheard = [watched.subscription for watched in self.followed if not watched.is_heard()]
        for subscription in stuck:
            if subscription in unheard or not self._is_hurried:
                self._note(
                    f"{subscription.where}: does not answer; it still has our observer, and drops it when "
                    "a call to it fails"
                )
