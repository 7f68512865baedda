"""Which of some components are there, and what changes about them, with as few questions as that takes.

Components that take observers report what changes; of their ports only to readers that accept that a process
that observes ports must not be killed (docs/protocol.md 5.4). What they do not report, and everything of
others, is asked for (ask.py), a few small questions at a time. A connection that a process drops shows its
end at once. Absent components are looked for by their names.

Whether a component hangs is asked by _non_existent alone: what asks for profiles is held up by its
neighbours.
"""

import collections
import math

from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.live import ask, hear, observer, times
from rtshell_lite.net import loop
from rtshell_lite.robot import snapshot, tree

MOST = 200  # questions of a kind that are put to a process, or a component, at a time
IDLE = 4.0  # seconds between two looks through those that need not be asked

KINDS = ("RTC_STATUS", "EC_EVENT", "CONFIG_EVENT")  # not PORT_EVENT


class Followed:
    """One component that is followed; the methods below are called with what is noticed.

    path   its Path, `where` as text
    shown  its snapshot.Snapshot, None while it is absent; who follows it fills it
    seen   the ask.Seen of what it is asked for, None while that is nothing
    error  why it is absent, or None
    leaders  the hear.Leaders that say who sends heartbeats, or None: each does
    """

    observed = KINDS  # the kinds of Events that its observer reports
    more = ()  # type: tuple  # further properties of that

    # as they are at first, here: an object with few attributes of its own takes a third of the memory
    shown = seen = subscription = error = leaders = None
    is_hung = is_ending = False
    is_sought = True  # where it is absent
    beat = times.BEAT  # seconds between the heartbeats of its observer
    heard = lived = asked = 0.0  # when it last called us, was last known to live, was looked for
    dead = None  # the identity of its object that is gone
    in_vain = None  # a Patience with what else it is asked, since it has left such a question unanswered

    def __init__(self, path):
        self.path = path
        self.where = str(path)
        self.patience = times.Patience()  # about its connections

    @property
    def is_there(self):
        """Whether it has answered, and is not known to be gone."""
        return self.shown is not None

    @property
    def reports(self):
        """Whether it is not asked what an observer of ours would report."""
        return self.subscription is not None

    @property
    def node(self):
        """Its Node. Raises why it is absent, as it may be by the time that a task begins."""
        if self.shown is None:
            raise self.error
        return self.shown.node

    @property
    def endpoint(self):
        """(host, port) of its process; raises as `node` does."""
        return self.node.endpoint

    def appeared(self):
        """It is there, or another object than before has its name."""

    def vanished(self, seen):
        """It is gone; `seen` says how."""

    def hung(self, error):
        """It does not answer."""

    def answered(self):
        """It answers again."""

    def reported(self, event):
        """It reports an observer.Event, no heartbeat; or an answer shows one."""

    def missed(self, kind):
        """Something of a kind of Event may have happened that it could not report, or that it refuses to say.
        """

    def lives(self):
        """It has answered when asked whether it lives."""

    async def observe(self, properties):
        """Lend it an observer, if it takes one, by these properties of its profile. Raises Unreachable."""
        kind = observer.preferred(properties)
        if kind is None:
            return
        if self.subscription is None:
            self.subscription = observer.observer(
                self.node, kind, self.observed, self.hear, self.beat, self.more
            )
        if self.leaders is not None:
            self.leaders.take(self)
        try:
            await self.subscription.attach()
        except errors.Refused:
            self.forget()

    async def attach_again(self):
        """Lend it its observer again, as it may have lost it after a failed call: whether it takes it."""
        if self.subscription is None or self.is_hung:
            return True
        try:
            await self.subscription.attach()
        except errors.Error:
            return False
        return True

    def wait_no_more(self):
        """It has answered about its connections, or what held it up may be over."""
        self.patience.end()

    def asked_in_vain(self, shows):
        """It has not answered such a question, which may hold one of its threads for as long as it hangs."""
        if shows == "PORT_EVENT":
            self.patience.wait()
            return
        if self.in_vain is None:
            self.in_vain = times.Patience()
        self.in_vain.wait()

    def may_be_asked(self, shows, now):
        """Whether a question that shows this kind of Events may be put."""
        patience = self.patience if shows == "PORT_EVENT" else self.in_vain
        return patience is None or now >= patience.until

    @property
    def is_led(self):
        """Whether another one of its process sends heartbeats in its place."""
        return self.subscription is not None and self.subscription.is_led

    def lead(self):
        """It is to send heartbeats from the next `attach` on, in the place of another one."""
        self.subscription.is_led = False
        self.lived = loop.now()

    def forget(self):
        """It has no observer of ours any more."""
        if self.subscription is not None:
            self.subscription.forget()
            self.subscription = None

    @property
    def late_at(self):
        """When it should have called us, or have answered a question: never where it need not."""
        if self.shown is None or self.subscription is None or self.is_led:
            return math.inf
        return max(self.heard, self.lived) + times.BEATS_LATE * self.beat

    def hear(self, event):
        """Take what it reports."""
        self.heard = loop.now()
        if event.event == "FINALIZE":
            self.is_ending = True
        if event.kind != "HEARTBEAT":
            self.reported(event)


class _Queue:
    """What is asked one question after the other, see `Presence.queue_of`.

    asked    {kind of questions: when some were put}
    counts   {kind: how many were put}
    idle     the kinds of which there was none the last time
    last     when some of any kind were put
    due_at   when the next may be, while its `members` are the same: how many, and how many of them report
    is_busy  whether some are being put
    """

    def __init__(self):
        self.asked = {}  # type: dict
        self.counts = collections.Counter()  # type: collections.Counter
        self.idle = set()  # type: set
        self.last = -math.inf
        self.due_at = 0.0
        self.members = 0, 0
        self.is_busy = False

    def is_due(self, some, now):
        """Whether these, its members, may be to be asked something. To look through thousands takes time."""
        members = len(some), sum([entry.reports for entry in some])
        if members == self.members and now < self.due_at:
            return False
        self.members = members
        return True

    def set_due(self, asks, look, now):
        """Set when the next question of some kinds, as in `Presence.asks`, may be due."""
        due = [
            self.asked.get(kind, -math.inf) + max(looks * look, IDLE if kind in self.idle else 0.0)
            for kind, looks in asks.items()
        ]
        self.due_at = max(self.last + look, min(due, default=now + IDLE))


class Presence:
    """Follows components, `followed`: `async with presence:`.

    look   seconds between questions to a process whose components report nothing
    """

    # {kind of questions of ask.py: after how many `look`s some of them are put again}; of one kind at a time,
    # that which is most overdue
    asks = {}  # type: dict

    def __init__(self, followed, look):
        self.followed = followed
        self.look = look
        self._queues = collections.defaultdict(_Queue)  # type: dict  # by `queue_of`
        self._suspected = set()  # endpoints that are being asked whether they live
        self._seek_at = 0.0  # when absent ones are looked for
        self._late_at = 0.0  # when one may be late, at the soonest
        self._alarm = loop.Bell()  # rings when one has become what is looked at more often
        self._group = None

    async def __aenter__(self):
        session.current().on_end.append(self.suspect)
        session.current().on_late.append(self._hurry)
        self._group = loop.Group()
        self.start(self._look_around())
        return self

    async def __aexit__(self, kind, error, traceback):
        session.current().on_end.remove(self.suspect)
        session.current().on_late.remove(self._hurry)
        self._group.cancel()
        try:
            await self._group.__aexit__(kind, error, traceback)
        finally:
            await self._detach_all()

    def start(self, work, place=None):
        """Begin a task that ends with the block."""
        self._group.start(work, place)

    async def _detach_all(self):
        await hear.take_all_back(self.followed)

    async def still_absent(self, absent):
        """These have been looked for, in vain."""

    def look_soon(self):
        """One is about to end, has become absent, hangs, or is to be asked questions from now on."""
        self._alarm.ring()

    # ---- whether they live ----

    def of_process(self, endpoint):
        """Those that are there in a process."""
        return [entry for entry in self.followed if entry.is_there and entry.endpoint == endpoint]

    def suspect(self, endpoint):
        """A connection with a process has ended, or it has been quiet for long: look whether it lives."""
        if endpoint not in self._suspected and self.of_process(endpoint):
            self._suspected.add(endpoint)
            self.start(self._examine(endpoint), endpoint)

    async def _examine(self, endpoint):
        try:
            here = self.of_process(endpoint)
            now = loop.now()
            doubtful = [entry for entry in here if entry.is_hung or entry.is_ending or entry.late_at < now]
            hung = [entry for entry in doubtful if entry.is_hung]
            others = [entry for entry in doubtful or here[:1] if not entry.is_hung]
            await loop.each(others, self.ask)  # of one after the other each would wait for those before it
            for entry in hung:
                await self.ask(entry)
        finally:
            self._suspected.discard(endpoint)

    async def ask(self, entry):
        """Ask a component whether it lives, and act on the answer."""
        shown = entry.shown
        if shown is None:
            return
        try:
            await _alive(entry)
        except errors.Refused:
            pass  # it lives
        except errors.Error as e:
            if entry.shown is shown:  # not another one that has come meanwhile
                self.failed(entry, e)
            return
        if entry.shown is not shown:
            return
        session.current().ask_again(entry.endpoint)
        entry.lived = loop.now() - (times.BEATS_LATE - 1) * entry.beat
        if entry.is_hung:
            entry.is_hung = False
            self._try_connections()
            entry.answered()
        entry.lives()

    def _try_connections(self):
        """A far end that may have held up others does so no more."""
        _ask_again(self.followed)

    def _hurry(self, endpoint):
        """What has held up a process does so no more."""
        _ask_again(self.of_process(endpoint))
        self.look_soon()

    def failed(self, entry, error):
        """A question to a component has failed: it is gone; or its process refuses connections, and all its
        components are gone, or may be; or it hangs.
        """
        if not entry.is_there:
            return
        if isinstance(error, errors.Gone):
            self._try_connections()
            self._lose(entry, error, "has exited")
        elif isinstance(error, errors.ConnectionRefused):
            # also where it may live: its name may lead to another object now
            seen = "its process is gone" if isinstance(error, errors.ProcessGone) else error.why
            self._try_connections()
            for other in self.of_process(entry.endpoint):
                self._lose(other, error, seen)
        elif not entry.is_hung:
            entry.is_hung = True
            self.look_soon()
            entry.hung(error)

    def _lose(self, entry, error, seen):
        if entry.is_ending:
            seen = "has exited"
        entry.forget()
        entry.dead = orb.identity(entry.shown.node.ref)
        entry.shown = entry.seen = None
        entry.error = error
        entry.is_hung = entry.is_ending = False
        self.look_soon()
        entry.vanished(seen)

    # ---- looking around ----

    async def _look_around(self):
        while True:
            now = loop.now()
            missing = [entry for entry in self.followed if entry.shown is None]
            absent = [entry for entry in missing if entry.is_sought]
            if absent and now >= self._seek_at:
                self._seek_at = math.inf
                self.start(self._seek(absent))
            late = self._late(now) if now > self._late_at else []
            doubtful = [entry for entry in self.followed if entry.is_hung or entry.is_ending]
            for endpoint in {entry.endpoint: None for entry in late + doubtful if entry.is_there}:
                self.suspect(endpoint)
            for entry in late:
                self.lend_again(entry)
            pause = times.SEEK if missing else 1.0  # to look through thousands takes some time
            if doubtful:
                pause = min(pause, self.look / 2)
            pause = min(pause, max(min(self.ask_around(now), self._late_at) - now, self.look / 2))
            await self._alarm.wait(pause)

    def _late(self, now):
        """Those that are late. To look through all costs most of what following costs at rest: it is done as
        soon as the next can be late, or is new.
        """
        late_at = {entry: entry.late_at for entry in self.followed}
        self._late_at = min([now + times.BEATS_LATE * times.BEAT_SHOWN, *late_at.values()])
        return [entry for entry in self.followed if late_at[entry] < now]

    async def _seek(self, absent):
        """Look whether absent components have come."""
        nodes = await session.each(
            absent, self._found, lambda entry: (tree.server_endpoint(entry.path), entry.where)
        )
        for entry, node in zip(absent, nodes):
            if isinstance(node, errors.Error):
                entry.error = node
                continue
            entry.error = None
            entry.shown = snapshot.Snapshot(node)
            entry.heard = loop.now()
            entry.appeared()
        await self.still_absent([entry for entry in absent if not entry.is_there])
        self._seek_at = loop.now() + max(times.SEEK, 0.01 * len(absent))

    @staticmethod
    async def _found(entry):
        """The Node of an absent component. Raises what says why it is absent."""
        node = await tree.component(entry.path)
        now = loop.now()
        if orb.identity(node.ref) == entry.dead and now - entry.asked < times.AGAIN:
            raise entry.error
        entry.asked = now
        (node,) = await tree.check_alive([node])
        if node.kind != "component":
            entry.dead = orb.identity(node.ref)
            raise node.error
        return node

    def lend_again(self, entry):
        """A component that is late may have lost its observer after a failed call."""
        entry.lived = loop.now()
        self.start(self._lend_again(entry), entry.endpoint)

    @staticmethod
    async def _lend_again(entry):
        if entry.subscription is None:
            return
        await entry.attach_again()  # whether it lives is asked elsewhere
        entry.missed("RTC_STATUS")
        entry.missed("PORT_EVENT")

    # ---- what nobody reports ----

    def queue_of(self, entry):
        """What is asked one question after the other: a process."""
        return entry.endpoint

    def at_a_time(self, kind, number):
        """How many of `number` questions of a kind are put at a time, MOST at most."""
        return number

    def ask_around(self, now):
        """Ask for what is not reported. Returns when there may be more to ask for."""
        members = collections.defaultdict(list)
        for entry in self.followed:
            if entry.seen is not None and entry.shown is not None and not entry.is_hung:
                members[self.queue_of(entry)].append(entry)
        for name in self._queues.keys() - members.keys():  # a process that is restarted has another port
            if not self._queues[name].is_busy:
                del self._queues[name]
        due_at = math.inf
        for name, some in members.items():
            queue = self._queues[name]
            if not queue.is_busy and queue.is_due(some, now):
                questions = self._due(queue, some, now)
                if questions:
                    queue.is_busy = True
                    self.start(self._put_all(queue, questions), some[0].endpoint)
            due_at = min(due_at, queue.due_at)
        return due_at

    def _due(self, queue, some, now):
        """The questions, (Followed, kind of Event, coroutine function), that these are to be asked."""
        if now - queue.last < self.look:
            queue.due_at = queue.last + self.look
            return []
        asked = queue.asked
        overdue = {kind: (now - asked.get(kind, -math.inf)) / looks for kind, looks in self.asks.items()}
        chosen = []
        for kind in sorted(overdue, key=overdue.get, reverse=True):
            if overdue[kind] < self.look:
                break
            of_kind = [question for entry in some for question in _questions(entry, kind, now)]
            asked[kind] = now
            if not of_kind:
                queue.idle.add(kind)
                continue
            queue.idle.discard(kind)
            queue.last = now
            count = min(self.at_a_time(kind, len(of_kind)), MOST)
            first = queue.counts[kind] % len(of_kind)
            queue.counts[kind] += count
            chosen = (2 * of_kind)[first : first + count]
            break
        queue.set_due(self.asks, self.look, now)
        return chosen

    async def _put_all(self, queue, questions):
        try:
            for question in questions:
                await self._put(*question)
        finally:
            queue.is_busy = False

    async def _put(self, entry, kind, question):
        """Ask a component a question, and report what its answer shows."""
        shown = entry.shown
        if shown is None or entry.is_hung or not entry.may_be_asked(kind, loop.now()):
            return
        try:
            events = await question()
        except errors.Refused:
            entry.missed(kind)
            return
        except errors.Error as e:
            if isinstance(e, errors.Silent):
                entry.asked_in_vain(kind)
            await self.ask(entry)
            return
        if kind == "PORT_EVENT":
            entry.wait_no_more()
        else:
            entry.in_vain = None
        if entry.shown is shown:
            for event in events:
                entry.reported(event)


def _ask_again(held_up):
    """Have these asked as if they had always answered."""
    for entry in held_up:
        entry.wait_no_more()
        entry.in_vain = None
        if entry.seen is not None:
            entry.seen.wait_no_more()


def _questions(entry, kind, now):
    """Those of a kind that a component is asked, see `Presence._due`."""
    shows = ask.SHOWS[kind]
    if not entry.may_be_asked(shows, now):
        return
    if shows != "PORT_EVENT" and entry.reports:
        return
    for question in kind(entry.seen):
        yield entry, shows, question


async def _alive(entry):
    """Raise what shows that a component is gone, or hangs; a process that ends drops its
    connections first.
    """
    ref = entry.shown.node.ref
    for _ in range(times.LOST_ANSWERS):
        try:
            return await orb.is_alive(entry.path, ref)
        except (errors.Unanswered, errors.Gone, errors.ConnectionRefused):
            raise
        except errors.Unreachable:
            await loop.sleep(times.LOST_ANSWER)
    return await orb.is_alive(entry.path, ref)
