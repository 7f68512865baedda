"""Watching components: what they report, whether they live, when they come back."""
import collections
import threading
import time

from rtshell_lite import cli, errors, interrupts
from rtshell_lite.corba import lanes, orb
from rtshell_lite.events import observer, polling
from rtshell_lite.events.observer import BEAT, Event
from rtshell_lite.robot import component, tree

LATE = 1.5 * BEAT  # after so many seconds without a heartbeat a component is asked whether it lives
LOST = 3 * BEAT  # after these a missing heartbeat is reported
LOOK = 1.0  # seconds between questions whether a component lives, or is back
RATE = 1 / component.POLL  # Hz
TICK = 0.1
MOST, MOST_CHARACTERS = 100000, 16 << 20  # items that may wait to be printed, and characters in them
STARTING = 1.0  # seconds for threads to start in after Ctrl-C
HURRY = 0.1  # seconds to wait for answers after Ctrl-C: C++ 2.1 removes an observer at once, but answers after a heartbeat, 1 s

LIFE = "LIFE_EVENT"  # the kind of our own Events: DIED EXITED BACK NO_HEARTBEAT NO_ANSWER ANSWERS
KINDS = list(observer.KINDS) + [LIFE]


class Events:
    """Watch for events of some of KINDS."""

    def __init__(self, kinds):
        self.kinds = set(kinds)

    def subscription(self, node, heard):
        """The observer to attach to a component, of the first kind that it takes, or None."""
        kinds = [observer.OBSERVER, observer.FSM_OBSERVER]
        if self.kinds - {LIFE, "HEARTBEAT"} == {"FSM_EVENT"}:  # else OpenRTM's own, which more components were built for
            kinds.reverse()
        offered = observer.taken(observer.properties(node))
        for interface in kinds:
            if interface in offered:
                return observer.observer(node, interface, self.kinds - {LIFE}, heard)
        return None

    def poll(self, node):
        """Begin to poll a component. Raises Refused if that shows none of the wanted events."""
        if not self.kinds & (polling.SEEN | {LIFE}):
            wanted = ", ".join(sorted(self.kinds))
            raise errors.Refused(str(node.path), f"offers no observer, and polling does not show {wanted}")
        return polling.Poll(node, self.kinds)


class Records:
    """Watch for log records."""

    kinds = set()

    def __init__(self, level, names):
        self.level, self.names = level, names

    def subscription(self, node, heard):
        """The logger to attach to a component. Raises Refused for one that takes none."""
        properties = observer.properties(node)
        if observer.LOGGER not in observer.taken(properties):
            raise errors.Refused(str(node.path), "takes no loggers")
        subscription = observer.logger(node, self.level, self.names, heard)
        if properties.get("language") == "C++":  # LoggerConsumer of 2.1 lacks the code
            subscription.remark = "takes a logger, but components of C++ (up to 2.1) write nothing to it"
        return subscription


class Watched:
    """One component that is being watched; `node` is None while it is gone."""

    def __init__(self, watch, path):
        self.watch, self.path, self.where = watch, path, str(path)
        self.name = str(path.names[-1])  # in lines; its path if two have the same
        self.node = self.subscription = self.poll = self.heard = None
        self.since = self.looked = time.monotonic()
        self.ending = False  # it has announced that it will exit
        self.attached_again = False
        self.reported_silence = None  # NO_ANSWER or NO_HEARTBEAT
        self.doubtful = False  # its last answer was lost
        self.given_up = False

    def begin(self, node):
        """Start to watch, on a lane. Raises Refused, Unreachable; the watch detaches it when it ends."""
        self.heard, self.ending, self.attached_again, self.reported_silence, self.poll = None, False, False, None, None
        self.subscription = self.watch.what.subscription(node, self.hear)
        if self.subscription is not None and self.watch.remember(self.subscription):
            self.subscription.attach()
            if self.subscription.remark:
                self.watch.note(self, self.subscription.remark)
        if self.subscription is None:
            self.poll = self.watch.what.poll(node)
            self.watch.note(self, f"offers no observer; it is polled ({RATE:g} Hz), which shows no connections")
        self.since = self.looked = time.monotonic()
        self.node = node

    def hear(self, item):
        """Take what it reports, on a thread of the ORB."""
        self.heard = time.monotonic()
        if isinstance(item, Event) and item.event == "FINALIZE":
            self.ending = True
        self.watch.put(self, item)

    # ---- a look at it, five times a second, on the thread of its process ----

    def look(self):
        """Look for what it does not report itself."""
        now = time.monotonic()
        try:
            if self.node is None:
                if now - self.looked >= LOOK:
                    self.looked = now
                    self._return()
                return
            if self.poll is not None:
                for item in self.poll.look():
                    self.watch.put(self, item)
            elif self._in_doubt(now):
                self.looked = now
                orb.is_alive(self.where, self.node.ref)
            self._answers(now)
        except (errors.Gone, errors.ConnectionRefused) as e:
            self._gone(e)
        except errors.Unreachable as e:
            if isinstance(e, errors.Silent) or self.doubtful:  # a process that ends drops its connections first
                self._silent("NO_ANSWER", e.why)
            self.doubtful = True
        except errors.Refused:
            pass  # it lives; there will be another look

    def _in_doubt(self, now):
        """Whether it is time to ask if it lives: not while it sends heartbeats, which only observers get."""
        if self.ending:
            return True
        beats = self.subscription.interface != observer.LOGGER and now - max(self.heard or 0, self.since) < LATE
        return not beats and now - self.looked >= LOOK

    def is_heard(self):
        """Whether it has called us recently, or recently got an observer."""
        return self.reported_silence is None and time.monotonic() - max(self.heard or 0, self.since) < LATE

    def _answers(self, now):
        """Note that it lives, and see whether it calls us, too."""
        self.doubtful = False
        if self.reported_silence == "NO_ANSWER" or self.reported_silence and now - (self.heard or 0) < LATE:
            self._report("ANSWERS")
            self.since, self.reported_silence = now, None
        beats = self.subscription is not None and self.subscription.interface != observer.LOGGER
        if beats and now - max(self.heard or 0, self.since) >= LOST:
            self._silent("NO_HEARTBEAT", f"no heartbeat for {LOST:g} s")
            self._unheard()

    def _unheard(self):
        """Attach the observer again, as a live component may have lost it after a failed call; poll where that does not help."""
        if self.heard is not None and not self.attached_again:
            self.attached_again, self.since = True, time.monotonic()
            self.subscription.attach()
            return
        self.poll = polling.Poll(self.node, self.watch.what.kinds)
        subscription, self.subscription, self.reported_silence = self.subscription, None, None
        self.watch.note(self, f"cannot call us at {subscription.address}; it is polled from now on")
        subscription.detach()  # its calls to an address that it cannot reach would only hold it up

    def _silent(self, word, why):
        if self.reported_silence != word:
            self.reported_silence = word
            self._report(word)
            self.watch.note(self, why)

    def _gone(self, error):
        exited = self.ending or isinstance(error, errors.Gone)
        if not exited:
            try:
                tree.resolve(self.path)
            except errors.NotFound:
                exited = True
            except errors.Error:
                pass
        if self.subscription is not None:
            self.subscription.forget()
        self.node = self.subscription = self.poll = None
        self._report("EXITED" if exited else "DIED")

    def _return(self):
        """Check whether it is back."""
        try:
            node, = tree.look([tree.component(self.path)])
            if node.kind == "component":
                self.begin(node)
                self._report("BACK")
        except errors.Refused as e:
            self.given_up = True
            self.watch.note(self, f"is back, but {e.why}")
        except errors.Error:
            pass  # not yet

    def _report(self, word):
        self.watch.put(self, Event(time.time(), LIFE, "", word))


def _size(item):
    """Characters of the texts in an Event or a Record."""
    return sum(len(part) for part in item if isinstance(part, str))


class Watch:
    """Several components that are being watched; to be closed, whatever happens."""

    def __init__(self, what, note):
        """`what`: Events or Records. `note` is called with lines about anything but events, on any thread."""
        self.what, self._note = what, note
        self.watched, self._subscriptions = [], []
        self._items = interrupts.Mailbox(MOST)
        self.dropped = self._came = self._gone = 0  # the latter: characters of the texts that came, and of those given out
        self._ended = threading.Event()
        self._guard = threading.Lock()

    def start(self, paths):
        """Begin to watch the component at each path; an errors.Error or a Watched for each."""
        def begin(node):
            watched = Watched(self, node.path)
            watched.begin(node)
            return watched
        results = tree.on_components(paths, begin)
        self.watched = [watched for watched in results if isinstance(watched, Watched)]
        names = [watched.name for watched in self.watched]
        for watched in self.watched:
            if names.count(watched.name) > 1:
                watched.name = watched.where
        processes = collections.OrderedDict()
        for watched in self.watched:
            processes.setdefault(watched.node.endpoint, []).append(watched)
        for endpoint, group in processes.items():
            lanes.start(self._look_after, endpoint, group)
        return results

    def _look_after(self, endpoint, group):
        """Look at the components of one process, one call at a time, until the watch ends."""
        lanes.become_lane(endpoint)
        while not self._ended.wait(component.POLL):
            for watched in group:
                if not watched.given_up:
                    watched.look()

    def remember(self, subscription):
        """Remember what has to be detached; False when it is too late to attach anything."""
        with interrupts.held(), self._guard:  # on the main thread, too, with our own ORB
            if not self._ended.is_set():
                self._subscriptions.append(subscription)
            return not self._ended.is_set()

    def put(self, watched, item):
        """Add an Event or a Record, from any thread. Never waits: what nobody reads is dropped and counted."""
        if isinstance(item, Event) and item.kind not in self.what.kinds and not self._unknown(item):
            if item.kind == LIFE and item.event in ("DIED", "EXITED", "BACK", "ANSWERS"):
                self.note(watched, {"DIED": "its process is gone", "BACK": "is back", "EXITED": "has exited",
                                    "ANSWERS": "answers again"}[item.event])
            return
        with self._guard:
            size = _size(item)
            if self._came - self._gone + size > MOST_CHARACTERS or not self._items.put((watched, item)):
                self.dropped += 1
            else:
                self._came += size

    def _unknown(self, item):
        return item.kind not in KINDS and len(self.what.kinds) == len(KINDS)

    def note(self, watched, line):
        self._note(f"{watched.where}: {line}")

    def follow(self, number, seconds, idle):
        """Yield (Watched, Event or Record) as they come: `number` of them (below 0: without end), for so many seconds.

        `idle` is called a few times a second. Raises Failed when fewer came in time.
        """
        end, wanted = time.monotonic() + seconds, number
        while number and self.watched:
            left = min(TICK, end - time.monotonic())
            if left <= 0:
                break
            idle()
            item = self._items.get(left)
            if item is not None:
                self._gone += _size(item[1])  # no lock: before Python 3.9, a signal may strike within `with`, and leave it locked
                yield item
                number -= 1
        if self.dropped:
            self._note(f"{self.dropped} lines dropped: they came faster than they could be printed")
        if number > 0 and self.watched:
            raise errors.Failed(", ".join(watched.where for watched in self.watched),
                                f"{wanted - number} of {wanted} within {seconds:g}s")

    def __enter__(self):
        return self

    def __exit__(self, kind, *_):
        self.close(hurried=kind is not None and not issubclass(kind, Exception))  # a signal

    def close(self, hurried=False):
        """Detach all that was attached, within the timeout, and report components that do not answer.

        `hurried`: all processes are asked, but their answers are not waited for; those that were heard recently will do it.
        """
        session, unasked = lanes.session, set()

        def detach(subscription):
            with self._guard:
                if subscription.node.endpoint in unasked:
                    unasked.discard(subscription.node.endpoint)
                    if hurried and not unasked:  # not earlier: on a busy computer, a thread waits long for a processor
                        session.end = time.monotonic() + HURRY
            subscription.detach()
        with interrupts.held():
            with self._guard:
                self._ended.set()
                endpoints = {subscription.node.endpoint for subscription in self._subscriptions}
                unasked.update(endpoint for endpoint in endpoints if not lanes.Peer(endpoint).silence)
                session.end = time.monotonic() + STARTING if hurried else None
            try:
                values = lanes.each(self._subscriptions, detach,
                                    lambda subscription: (subscription.node.endpoint, subscription.where))
            finally:
                with self._guard:
                    unasked.clear()  # who is late changes nothing
                    session.end = None
        if session.turned_away:
            cli.left_out(f"{session.turned_away} connections to this command were turned away, as too many came: events may be "
                         "missing")
        unheard = [watched.subscription for watched in self.watched if not watched.is_heard()]
        for subscription, value in zip(self._subscriptions, values):
            if isinstance(value, errors.Silent) and (subscription in unheard or not hurried):
                self._note(f"{subscription.where}: does not answer; it still has our observer, and drops it when a call to it fails")
