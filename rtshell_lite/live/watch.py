"""Watching components: what they report, whether they live, when they come back."""

import collections

from rtshell_lite import errors, notes
from rtshell_lite.corba import orb, session
from rtshell_lite.live import hear, observer, polling, times
from rtshell_lite.live.observer import Event
from rtshell_lite.net import loop
from rtshell_lite.robot import component, tree

RATE = 1 / component.POLL  # Hz
# items that may wait to be printed, and characters in them
MOST = 100000
MOST_CHARACTERS = 16 << 20
# items that are printed at a time, and about how many characters in them: each may be printed as ten
BATCH = 1000
BATCH_CHARACTERS = 1 << 18

LATE = times.BEATS_LATE * times.BEAT_SHOWN
LOST = times.BEATS_LOST * times.BEAT_SHOWN

LIFE = "LIFE_EVENT"  # the kind of our own Events: DIED EXITED BACK NO_HEARTBEAT NO_ANSWER ANSWERS
KINDS = list(observer.KINDS) + [LIFE]


class Events:
    """Watch for events of some of KINDS; `more` are further (property, value) for observers."""

    def __init__(self, kinds, more=()):
        self.kinds = set(kinds)
        self.more = more

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
                return observer.observer(node, interface, self.kinds - {LIFE}, heard, more=self.more)
        return None

    async def poll(self, node):
        """Begin to poll a component. Raises Refused if that shows none of the wanted events."""
        if not self.kinds & (polling.SEEN | {LIFE}):
            wanted = ", ".join(sorted(self.kinds))
            raise errors.Refused(str(node.path), f"offers no observer, and polling does not show {wanted}")
        return await polling.begin(node, self.kinds)


class Records:
    """Watch for log records."""

    kinds = set()

    def __init__(self, level, names):
        self.level = level
        self.names = names

    def wants(self, record):
        """Whether a Record of a component that was not asked for these is one of them."""
        if self.names and record.logger not in self.names:
            return False
        known = list(observer.ALL_LEVELS)
        if record.level not in known:
            return True
        return known.index(record.level) <= known.index(self.level)

    async def subscription(self, node, heard):
        """The logger to attach to a component. Raises Refused for one that takes none."""
        properties = await observer.properties(node)
        if observer.LOGGER not in observer.taken(properties):
            raise errors.Refused(str(node.path), "takes no loggers")
        subscription = observer.logger(node, self.level, self.names, heard)
        if properties.get("language") == "C++":  # LoggerConsumer of 2.1 lacks the code
            subscription.remark = "takes a logger, but components of C++ (up to 2.1) write nothing to it"
        return subscription


class Watched:
    """One component that is being watched; `node` is None while it is gone."""

    def __init__(self, watch, path):
        self.watch = watch
        self.path = path
        self.where = str(path)
        self.name = str(path)  # in lines; its path if two have the same
        if path.names:
            self.name = str(path.names[-1])
        self.node = self.subscription = self.poll = self.heard = None
        self.since = self.looked = loop.now()
        self.ending = False  # it has announced that it will exit
        self.attached_again = False
        self.reported_silence = None  # NO_ANSWER or NO_HEARTBEAT
        self.doubtful = False  # its last answer was lost
        self.given_up = False

    async def begin(self, node):
        """Start to watch. Raises Refused, Unreachable; the watch detaches it when it ends."""
        self.heard = None
        self.ending = False
        self.attached_again = False
        self.reported_silence = None
        self.poll = None
        self.subscription = await self.watch.what.subscription(node, self.hear)
        if self.subscription is not None:
            self.watch.subscriptions.append(self.subscription)
            await self.subscription.attach()
            if self.subscription.remark:
                self.watch.note(self, self.subscription.remark)
        else:
            self.poll = await self.watch.what.poll(node)
            self.watch.note(
                self, f"offers no observer; it is polled ({RATE:g} Hz), which shows no connections"
            )
        self.since = self.looked = loop.now()
        self.node = node

    def hear(self, item):
        """Take what it reports."""
        self.heard = loop.now()
        if isinstance(item, Event) and item.event == "FINALIZE":
            self.ending = True
        self.watch.put(self, item)

    async def follow(self):
        """Look at it five times a second, until it refuses to be watched."""
        while not self.given_up:
            await loop.sleep(component.POLL)
            await self.look_for_changes()

    async def look_for_changes(self):
        """Look for what it does not report itself."""
        now = loop.now()
        try:
            if self.node is None:
                if now - self.looked >= times.RETURN:
                    self.looked = now
                    await self._return()
                return
            if self.poll is not None:
                for item in await self.poll.changes():
                    self.watch.put(self, item)
            elif self._in_doubt(now):
                self.looked = now
                await orb.is_alive(self.node.path, self.node.ref)
            await self._answers(now)
        except (errors.Gone, errors.ConnectionRefused) as e:
            await self._gone(e)
        except errors.Unreachable as e:
            # a process that ends drops its connections first
            if isinstance(e, errors.Unanswered) or self.doubtful:
                self._silent("NO_ANSWER", e.why)
            self.doubtful = True
        except errors.Refused:
            pass  # it lives; there will be another look

    def _in_doubt(self, now):
        """Whether it is time to ask if it lives: not while it sends heartbeats, which only observers get."""
        if self.ending:
            return True
        beats = (
            self.subscription.interface != observer.LOGGER and now - max(self.heard or 0, self.since) < LATE
        )
        return not beats and now - self.looked >= times.LOOK

    def is_heard(self):
        """Whether it has called us recently, or recently got an observer."""
        if self.reported_silence is not None:
            return False
        return loop.now() - max(self.heard or 0, self.since) < LATE

    async def _answers(self, now):
        """Note that it lives, and see whether it calls us, too."""
        self.doubtful = False
        if self.reported_silence == "NO_ANSWER" or self.reported_silence and now - (self.heard or 0) < LATE:
            self._report("ANSWERS")
            self.since = now
            self.reported_silence = None
        beats = self.subscription is not None and self.subscription.interface != observer.LOGGER
        if beats and now - max(self.heard or 0, self.since) >= LOST:
            self._silent("NO_HEARTBEAT", f"no heartbeat for {LOST:g} s")
            await self._unheard()

    async def _unheard(self):
        """Attach the observer again, as a live component may have lost it after a failed call;
        poll where that does not help.
        """
        if self.heard is not None and not self.attached_again:
            self.attached_again = True
            self.since = loop.now()
            await self.subscription.attach()
            return
        self.poll = await polling.begin(self.node, self.watch.what.kinds)
        subscription = self.subscription
        self.subscription = None
        self.reported_silence = None
        self.watch.note(self, f"cannot call us at {subscription.address}; it is polled from now on")
        await subscription.detach()  # its calls to an address that it cannot reach would only hold it up

    def _silent(self, word, why):
        if self.reported_silence != word:
            self.reported_silence = word
            self._report(word)
            self.watch.note(self, why)

    async def _gone(self, error):
        exited = self.ending or isinstance(error, errors.Gone)
        if not exited:
            try:
                await tree.resolve(self.path)
            except errors.NotFound:
                exited = True
            except errors.Error:
                pass
        if self.subscription is not None:
            self.subscription.forget()
            self.watch.subscriptions.remove(self.subscription)
        self.node = self.subscription = self.poll = None
        if exited:
            self._report("EXITED")
        elif isinstance(error, errors.MaybeGone):
            self._silent("NO_ANSWER", error.why)
        else:
            self._report("DIED")

    async def _return(self):
        """Check whether it is back."""
        try:
            (node,) = await tree.check_alive([await tree.component(self.path)])
            if node.kind == "component":
                # its silence is that of this component from now on
                loop.current().running.place = node.endpoint
                await self.begin(node)
                self._report("BACK")
        except errors.Refused as e:
            self.given_up = True
            self.watch.note(self, f"is back, but {e.why}")
        except errors.Error:
            pass  # not yet

    def _report(self, word):
        self.watch.put(self, Event(loop.wall(), LIFE, "", word))


def _size(item):
    """Characters of the texts in an Event or a Record."""
    return sum(len(part) for part in item if isinstance(part, str))


class Watch:
    """Several components that are being watched: `async with Watch(Events(kinds)) as watching: …`."""

    def __init__(self, what, note=notes.note):
        """`what`: Events or Records. `note` is called with lines about anything but events."""
        self.what = what
        self._note = note
        self.watched = []
        self._doors = []
        self.subscriptions = []
        self.dropped = 0
        # what waits to be printed, and how many characters that has
        self._items = collections.deque()
        self._size = 0
        # rings when items have come
        self._bell = loop.Bell()
        self._group = None

    async def __aenter__(self):
        self._group = loop.Group()
        return self

    async def __aexit__(self, kind, error, traceback):
        self._group.cancel()
        is_signal = error is not None and not isinstance(error, (Exception, loop.Cancelled))
        try:
            await self._group.__aexit__(kind, error, traceback)
        finally:
            await self._detach_all(hurried=is_signal)

    async def start(self, paths):
        """Begin to watch the component at each path, too; an errors.Error or a Watched for each."""

        async def begin(node):
            watched = Watched(self, node.path)
            await watched.begin(node)
            return watched

        results = await tree.on_components(paths, begin)
        begun = [watched for watched in results if isinstance(watched, Watched)]
        self.watched += begun
        names = [watched.name for watched in self.watched]
        for watched in begun:
            if names.count(watched.name) > 1:
                watched.name = watched.where
            self._group.start(watched.follow(), watched.node.endpoint)
        return results

    def listen(self, door):
        """Take what comes at a forward.Door, too, until the end."""
        self._doors.append(door)
        self._group.start(door.serve(self._put_wanted, self._has_room))

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
        while left and (self.watched or self._doors) and loop.now() < end:
            batch = self._take(min(left, BATCH)) if left > 0 else self._take(BATCH)
            if batch:
                left -= len(batch)
                yield batch
            else:
                await self._bell.wait(end - loop.now())
        if self.dropped:
            self._note(f"{self.dropped} lines dropped: they came faster than they could be printed")
        if left > 0 and (self.watched or self._doors):
            raise errors.Failed(
                ", ".join([watched.where for watched in self.watched] + ["--listen"] * len(self._doors)),
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

    async def _detach_all(self, hurried):
        """Detach all that was attached, and report components that do not answer.

        `hurried`: all processes are asked, but their answers are not waited for; those that were heard
        recently will do it.
        """
        stuck = await hear.take_back(self.subscriptions, times.HURRY_SHOWN if hurried else None)
        turned_away = session.current().turned_away
        if turned_away:
            notes.left_out(
                f"{turned_away} connections to this command were turned away, as too many came: "
                "events may be missing"
            )
        unheard = [watched.subscription for watched in self.watched if not watched.is_heard()]
        for subscription in stuck:
            if subscription in unheard or not hurried:
                self._note(
                    f"{subscription.where}: does not answer; it still has our observer, and drops it when "
                    "a call to it fails"
                )
