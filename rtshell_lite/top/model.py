"""A whole system, polled: what rttop shows, as plain values that can be read without waiting.

At most IN_FLIGHT remote calls are made at a time, to all processes together. Each look asks a component for
its state; its contexts, rates and connections, which change less often and cost more, are asked for less
often. Where there are more than FEW components, those that nobody sees now are looked at SELDOM, and a live
page lends them observers (live/hear.py): what reports its changes is hardly asked.
"""

import collections

from rtshell_lite import errors, path as paths
from rtshell_lite.corba import orb, session
from rtshell_lite.live import ask, follow, hear, observer, times
from rtshell_lite.net import loop
from rtshell_lite.data import rates
from rtshell_lite.robot import component, places, ports, snapshot, transitions, tree
from rtshell_lite.text import safe
from rtshell_lite.top.rows import Row, natural
from rtshell_lite.views import describe

IN_FLIGHT = 4  # monitors that ask more at a time have disturbed real-time threads
DOUBTFUL = 2  # of these, at most this many to processes that have not answered (yet): they must not take all
WALK = 5.0  # seconds between looks at what is bound
CONTEXTS = 5.0  # seconds between looks at execution contexts and their rates
PORTS = 10.0  # seconds between looks at connections: each makes a component check the far ends
PORTS_SILENT = 60.0  # the same, for one that does not answer that
FLOW = 1.0  # seconds for which the flow of ports is measured
FEW = 100  # components that are all looked at as often as the user wants
SELDOM = 5.0  # seconds between two looks at one of more components that is not shown
SLOWER = 6  # times as long between two looks at its contexts, and at its connections
REPORTED = 12  # times SELDOM between two looks at the state of one that reports its changes
SLOWEST = 60  # times as long between two looks at its contexts, and at its connections
KEPT = 60.0  # seconds for which what was measured is shown


# ---- one component ----


NEVER = float("-inf")
_STATES = {"zombie": "-", "unasked": "~"}  # of entries, by kind; ? for what does not answer


class Entry(follow.Followed):
    """A component that the task of its group looks at."""

    observed = ("RTC_STATUS", "EC_EVENT", "PORT_EVENT")
    more = observer.NO_VALUES
    is_bound = True  # whether a name leads to it
    may_report = False  # whether it is to be lent an observer
    takes_none = False  # whether it takes no observers

    def __init__(self, node, leaders, hurried, changed):
        """`leaders`: the hear.Leaders; `hurried`: groups to be looked at now; `changed`: Entries whose rows
        may be others than before.
        """
        super().__init__(node.path)
        self.shown = snapshot.Snapshot(node)
        self.leaders = leaders
        self.name = node.name
        self._hurried = hurried
        self._changed = changed
        self.group = node.endpoint
        self.kind = "component"
        self.state = None
        self.failure = None
        self.ports = self.links = None  # how many ports; ids of its connections
        self.seen = self._unseen()
        self.looked = False  # whether its state, or its failure, is known
        self.silenced = 0.0  # when it was silent last
        self.since = None  # when its state changed last, by loop.now()
        self.event = ""  # the last change, in words
        self.is_shown = True
        self.flow = {}  # {port: values that are written a second}, as measured
        self._flow_until = 0.0
        self.again = 0.0  # when it may be asked again
        # when its state, contexts and connections were asked for
        self.asked = self._contexts_asked = self._ports_asked = NEVER

    def _unseen(self):
        """An ask.Seen in which nothing is known."""
        return ask.Seen(self.node, lambda port: True, has_handles=False)

    def hurry(self):
        """Look at everything again, as something has been done to it."""
        self.again = 0.0
        self.asked = self._contexts_asked = self._ports_asked = NEVER
        self._hurried.add(self.group)

    def measured(self):
        """{port: values that are written a second}, if that was measured a moment ago, else {}."""
        if loop.now() > self._flow_until:
            self.flow = {}
        return self.flow

    @property
    def has_answered(self):
        """Whether it has answered when it was last asked."""
        return self.looked and self.kind == "component"

    def keep_measured(self, flow):
        """Keep what was measured, for a while."""
        self.flow = flow
        self._changed.add(self)
        self._flow_until = loop.now() + KEPT

    @property
    def reports(self):
        return self.subscription is not None and self.leaders.hears(self.endpoint)

    def reported(self, event):
        """It has reported an observer.Event: look at what that is about."""
        self._hurried.add(self.group)
        if event.kind == "RTC_STATUS":
            self.asked = NEVER
        elif event.kind == "EC_EVENT":
            self.asked = self._contexts_asked = NEVER
        elif event.kind == "PORT_EVENT" and event.event not in ("PORT_SEND", "PORT_RECEIVE"):
            self.asked = self._ports_asked = NEVER

    def _pause(self, seconds):
        """How long to wait after a question: `seconds`, or longer while nobody sees the answer, or while it
        reports what changes.
        """
        if self.reports:
            return SLOWEST * seconds
        if self.is_shown:
            return seconds
        return SLOWER * seconds

    def due(self):
        """When it is to be asked, by loop.now()."""
        if self.asked == NEVER:
            return self.again
        pause = 0.0
        if self.reports:
            pause = SELDOM
            if not self.is_shown:
                pause = REPORTED * SELDOM
        elif not self.is_shown:
            pause = SELDOM
        return max(self.again, self.asked + pause)

    async def ask(self):
        """Ask it. Raises Unanswered."""
        now = loop.now()
        try:
            await self._look(now)
        except errors.Unanswered:
            raise
        except errors.Error as e:  # of the component, or passed on by it?
            self.again = now + times.REST
            (node,) = await tree.check_alive([self.node])
            if isinstance(node.error, errors.Unanswered):
                raise node.error
            if node.kind == "component":
                self.fail("silent", node.error or e)
            else:
                self.fail(node.kind, node.error or e)
        finally:
            self._changed.add(self)

    async def _look(self, now):
        was_told = self.asked == NEVER
        before = self.state
        self.asked = now  # before it answers, as it may report something meanwhile
        if now >= self._contexts_asked + self._pause(CONTEXTS):
            self._contexts_asked = now
            await self.seen.look([ask.contexts])
        await self.seen.look([ask.states])
        self._become("component", self.seen.state, None)
        if self.subscription is not None and self.state != before and not was_told:
            self._ports_asked = NEVER
            await self.attach_again()
        if now >= self._ports_asked + self._pause(PORTS):
            self._ports_asked = now
            await self._look_at_ports()
            if self.may_report and self.ports is not None:
                await self._be_heard()
        self.looked = True

    async def _look_at_ports(self):
        seen = self.seen
        seen.wait_no_more()  # those that do not answer are asked as seldom as PORTS_SILENT says
        try:
            if seen.ports:
                await seen.look([ask.which_ports, ask.connections])
            else:  # their profiles show the connections, too
                seen.ports = []
                await seen.look([ask.which_ports])
            self.ports = len(seen.ports)
            self._connect({connector_id for port in seen.ports for connector_id in port.ids})
        except errors.Error as e:  # it has just given its state: the ports are what is wrong
            self.ports = self.links = None
            if isinstance(e, errors.Unanswered):
                self._ports_asked = loop.now() + PORTS_SILENT - PORTS

    async def _be_heard(self):
        """Lend it an observer, if it takes one. Its ports have just been asked (docs/protocol.md 1.1)."""
        if self.subscription is not None or self.takes_none or not self.is_bound:
            return
        try:
            await self.observe(dict((await component.profile(self.node)).properties))
            self.takes_none = self.subscription is None
        except errors.Error:
            self.forget()  # it is asked as others are

    async def attach_again(self):
        takes_it = await super().attach_again()
        if not takes_it:
            self.forget()
        return takes_it

    def give_up(self):
        """Note that it has not been looked at as the time is over."""
        if self.asked == NEVER:
            self.fail("unasked", errors.NoTime(self.where, session.NO_TIME))
        else:
            self.fail("silent", errors.Silent(self.where, "no answer in time"))

    def fail(self, kind, failure):
        """Note that it is dead, does not answer or was not asked, and forget what was known of it."""
        self._become(kind, _STATES.get(kind, "?"), failure)
        self.ports = self.links = None
        if kind == "zombie":
            self.forget()
        self.seen = self._unseen()
        self.asked = self._contexts_asked = self._ports_asked = NEVER
        self.looked = True

    def _become(self, kind, state, failure):
        """Note its state, and whether that is another one than before."""
        if self.looked and state != self.state:
            self.since = loop.now()
            words = {"-": "dead", "?": "silent", "~": "not asked"}
            self.event = f"{words.get(self.state, self.state)} to {words.get(state, state)}"
        self.kind = kind
        if self.is_hung and kind == "component":
            self.lived = loop.now()  # it could not call us meanwhile
        self.is_hung = kind != "component"
        self.state = state
        self.failure = failure
        self._changed.add(self)

    def _connect(self, links):
        if self.links is not None and len(links) != len(self.links):
            self.event = f"{len(self.links)} to {len(links)} connections"
        self.links = links

    def row(self, path, name):
        """Its Row."""
        contexts = [context for context in self.seen.contexts if not context.silent_until]
        running = None
        first = None
        if contexts:
            alive = [context for context in contexts if context.running]
            running = bool(alive)
            first = (alive or contexts)[0]
        links = None
        if self.links is not None:
            links = len(self.links)
        if self.measured():
            self._changed.add(self)  # it will be over
        return Row(
            path, name, self.kind, self.state, first and first.rate, running, self.ports, links, self.failure,
            self.since, self.event, self.flow,
        )


# ---- the system ----


class Slots:
    """At most `most` tasks at a time are within `async with slots:`, first come, first served."""

    def __init__(self, most):
        self._free = most
        self._waiting = collections.deque()

    async def __aenter__(self):
        if self._free:
            self._free -= 1
            return
        turn = loop.Wait()
        self._waiting.append(turn)
        try:
            await turn
        except loop.Cancelled:
            if turn.is_over:
                self._pass_on()
            else:
                self._waiting.remove(turn)
            raise

    async def __aexit__(self, *_):
        self._pass_on()

    def _pass_on(self):
        if self._waiting:
            self._waiting.popleft().done()
        else:
            self._free += 1


class Top:
    """What is below the Paths `tops` (none: all name servers), looked at every `delay` seconds.

    `async with Top(tops, delay) as looking:` has tasks do so. `is_live`: for long; observers are lent then.
    """

    def __init__(self, tops, delay, is_live=False):
        self.delay = delay
        self._is_live = is_live
        self._leaders = hear.Leaders(self._of_process)
        self.bell = loop.Bell()  # rings when there are news
        self._tops = list(collections.OrderedDict.fromkeys(_each_server(tops)))
        self._found = {}  # by top: {path: identity of a component}
        self._failed = {}  # by top: {path: errors.Error} of what cannot be listed
        self._entries = {}  # by identity
        self._unbound = set()  # Entries that no name leads to any more, and that may still have an observer
        self._groups = {}  # {endpoint of a process, or identity of a component that hangs: Entries}
        self._looked_after = set()  # groups that have a task
        self._hurried = set()  # those in which something is to be looked at before it is due
        self._changed = set()  # Entries whose rows may be others than those in `_rows`
        self._listed = None  # (path, name, Entry) of each component, sorted, until another one is found
        self._rows = []  # the Rows of these
        self._doubtful = Slots(DOUBTFUL)
        self._news = []
        self._marks = {}  # by path: what an rtkeep says of a component
        self.shown = None  # paths of the components that are seen now; None: of all
        self._tasks = None

    async def __aenter__(self):
        orb.start()
        session.current().slots = Slots(IN_FLIGHT)
        for told in (session.current().on_end, session.current().on_late):
            told.append(self._suspect)
        self._tasks = loop.Group()
        self._tasks.start(self._follow_keepers())
        self._tasks.start(self._keep_observers())
        for top in self._tops:
            self._tasks.start(self._follow(top))
        return self

    async def __aexit__(self, *exception):
        session.current().slots = None
        for told in (session.current().on_end, session.current().on_late):
            told.remove(self._suspect)
        self._tasks.cancel()
        try:
            await self._tasks.__aexit__(*exception)
        finally:
            await hear.take_all_back([*self._entries.values(), *self._unbound])

    def _suspect(self, endpoint):
        """A connection with a process has ended, or what held it up: look at its components."""
        for entry in self._of_process(endpoint):
            entry.hurry()

    def _of_process(self, endpoint):
        return [entry for entry in self._entries.values() if entry.node.endpoint == endpoint]

    async def _keep_observers(self):
        """See to it that one component of each process sends heartbeats. Where its calls do not reach us,
        nobody there is lent an observer.
        """
        while True:
            await loop.sleep(SELDOM)
            for leader in self._leaders.late(loop.now()):
                here = self._of_process(leader.endpoint)
                # one that is dead says nothing about its process
                if not any(entry.heard or entry.kind in tree.DOUBTFUL for entry in here):
                    for entry in here:
                        entry.takes_none = True
                    await hear.take_all_back(here)
            for entry in self._leaders.look(loop.now()):
                self._tasks.start(entry.attach_again(), entry.endpoint)

    async def _follow_keepers(self):
        """Ask the rtkeeps of this user for their marks, again and again."""
        from rtshell_lite.system import steering

        while True:
            marks = await steering.marks()
            if marks != self._marks:
                self._marks = marks
                self._changed.update(self._entries.values())
            await loop.sleep(WALK)

    # ---- what is bound ----

    async def _follow(self, top):
        """Walk through a part of the tree again and again."""
        number = 0
        while True:
            if number % times.WHOLE == 0 or len(self._entries) <= FEW:
                bound = {}
            else:
                bound = {entry.where: entry.node for entry in self._entries.values() if entry.has_answered}
            number += 1
            spelt = {node: where for where, node in bound.items()}  # to spell many takes time
            nodes, failed = await _walk(top, bound)
            lost = any(isinstance(error, errors.Unreachable) for error in failed.values())
            # without their name server, they may still live
            identities = dict(self._found.get(top, {})) if lost else {}
            for node in nodes:
                identity = orb.identity(node.ref)
                identities[spelt.get(node) or str(node.path)] = identity
                if identity not in self._entries:
                    self._entries[identity] = Entry(node, self._leaders, self._hurried, self._changed)
            self._failed[top] = failed
            if identities != self._found.get(top):
                self._take(top, identities)
            await loop.sleep(WALK)

    def _take(self, top, identities):
        """Take what has been found below a Path, {path: identity}."""
        self._found[top] = identities
        identified = {identity for listed in self._found.values() for identity in listed.values()}
        for identity in set(self._entries) - identified:
            self._unbound.add(self._entries[identity])
            self._entries[identity].is_bound = False
        self._tasks.start(self._take_back_unbound())
        self._entries = {identity: self._entries[identity] for identity in identified}
        self._listed = None
        self._look_after_all()

    async def _take_back_unbound(self):
        """Take back what was lent to components that no name leads to any more; one may just be lent it."""
        await hear.take_all_back(self._unbound)
        recent = loop.now() - KEPT
        self._unbound = {
            entry for entry in self._unbound if entry.subscription is not None or entry.asked > recent
        }

    # ---- looking ----

    def _look_after_all(self):
        """Start a task for each new group of components:
        a process, or one that hangs while its process does not.
        """
        self._groups = collections.defaultdict(list)
        for entry in self._entries.values():
            self._groups[entry.group].append(entry)
        self._hurried.update(self._groups)  # as others may be in them
        for group in set(self._groups) - self._looked_after:
            self._looked_after.add(group)
            self._tasks.start(self._look_after(group), self._groups[group][0].node.endpoint)

    async def _look_after(self, group):
        trusted = False
        shown = None
        until = NEVER
        while group in self._groups:
            now = loop.now()
            # to look through many costs more than to ask those few that are due
            if now >= until or group in self._hurried or self.shown is not shown:
                self._hurried.discard(group)
                shown = self.shown
                until = now + SELDOM
                soon = self._due_until(until, self._groups[group])
            due = [entry for entry, due_at in soon.items() if due_at <= now]
            trusted = await self._look_at_group(due, self._groups[group], trusted)
            if not trusted:
                until = NEVER
            soon.update({entry: entry.due() for entry in due})
            await loop.sleep(self.delay if trusted else times.REST)
        self._looked_after.discard(group)
        self._hurried.discard(group)

    def _due_until(self, until, entries):
        """{Entry: when it is to be asked} of those in a group that are to be asked until then. One of them is
        at least every SELDOM seconds, as the process may hang.
        """
        is_large = len(self._entries) > FEW
        for entry in entries:
            entry.is_shown = self.shown is None or not is_large or entry.where in self.shown
            entry.may_report = self._is_live and is_large
        due_at = {entry: entry.due() for entry in entries}
        soon = {entry: due_at[entry] for entry in entries if due_at[entry] < until}
        look_at = max(entry.asked for entry in entries) + SELDOM
        if look_at < min(soon.values(), default=until):
            soon.update(dict.fromkeys(_rested(entries)[:1], look_at))
        return soon

    async def _look_at_group(self, due, entries, trusted):
        if trusted or not due:
            return await self._look(due, entries)
        async with self._doubtful:
            return await self._look(due, entries)

    async def _look(self, due, entries):
        """Look at those components of one process that are due, one call at a time; False when it did not
        answer.

        If two are silent, or the only one, the process hangs: the rest is not asked.
        """
        heard, silent = await self._ask(sorted(due, key=lambda entry: entry.silenced))
        if len(silent) == 1 and not heard:  # is it the process that hangs?
            others = [entry for entry in _rested(entries) if entry not in silent]
            heard, more = await self._ask(others[:1])
            silent += more
        if heard and silent:
            for entry in silent:
                entry.group = orb.identity(entry.node.ref)
            self._look_after_all()
        elif silent:
            for entry in entries:
                if entry not in silent:
                    entry.fail("unasked", errors.NotAsked(entry.where, "its process did not answer others"))
        return heard or not silent

    async def _ask(self, entries):
        """Ask components of one process until two are silent, or one where others have answered:
        (whether one answered, those that were silent).
        """
        heard = False
        silent = []
        for entry in entries:
            try:
                await entry.ask()
                heard = True
            except errors.Unspoken as e:
                entry.fail("unasked", e)
            except errors.Unanswered as e:
                entry.silenced = loop.now()
                entry.fail("unasked" if isinstance(e, errors.NotAsked) else "silent", e)
                silent.append(entry)
                if heard or len(silent) == 2:
                    break
        return heard, silent

    # ---- what it looks like ----

    async def wait(self, seconds):
        """Wait until everything has been looked at, at most `seconds`."""
        end = loop.now() + seconds
        while not self._is_complete() and loop.now() < end:
            await loop.sleep(0.02)

    def give_up(self):
        """What has not been looked at yet counts as silent, until it answers."""
        for top in self._tops:
            if top not in self._found:
                self._found[top] = {}
                self._failed[top] = {str(top): errors.Silent(str(top), "no answer in time")}
        for entry in self._entries.values():
            if not entry.looked:
                entry.give_up()

    def _is_complete(self):
        return len(self._found) == len(self._tops) and all(entry.looked for entry in self._entries.values())

    def entries(self):
        """(path, Entry) of each component."""
        paths_of = {}
        for top in self._found:
            for path, identity in sorted(self._found[top].items()):
                paths_of.setdefault(identity, path)  # the first, if it is bound twice
        return [(path, self._entries[identity]) for identity, path in paths_of.items()]

    def failures(self):
        """{path: errors.Error} of each part of the tree that cannot be listed."""
        failed = {}
        for top in self._found:
            failed.update(self._failed[top])
        return failed

    def rows(self):
        """A Row for each component, and for each part of the tree that cannot be listed, sorted by name."""
        self._make_rows()
        if not self.failures():
            return self._rows
        unknown = [
            Row(path, path, "unknown", "?", None, None, None, None, failure, None, "", {})
            for path, failure in self.failures().items()
        ]
        return sorted(self._rows + unknown, key=lambda row: (natural(row.name), row.path))

    def _make_rows(self):
        """Make the rows again that may be others now; the list is the same one, as long as no row is."""
        if self._listed is None:
            self._listed = self._list()
            self._rows = [None] * len(self._listed)
            self._changed.update(self._entries.values())
        if not self._changed:
            return
        changed = set(self._changed)
        self._changed.clear()  # those whose rows are about to change come again
        rows = list(self._rows)
        for number, (path, name, entry) in enumerate(self._listed):
            if entry in changed:
                rows[number] = _marked(entry.row(path, name), self._marks.get(path))
        if rows != self._rows:
            self._rows = rows

    def _list(self):
        entries = self.entries()
        are_unique = len({entry.name for _, entry in entries}) == len(entries)
        listed = [(path, entry.name if are_unique else path, entry) for path, entry in entries]
        return sorted(listed, key=lambda item: (natural(item[1]), item[0]))

    # ---- acting ----

    def change(self, path, transition):
        """Take the component at a path (text) through a transitions.Transition;
        `news` returns its state then.
        """
        self._act(path, transition.command, lambda node: transitions.change(node, transition))

    def show(self, path):
        """Ask the component at a path (text) for all that rtcat -l shows; `news` returns the lines."""
        self._act(path, "rtcat", _description)

    def ask(self, path, command, function):
        """Await function(node) for the component at a path (text); `news` returns its result."""
        self._act(path, command, function)

    def show_neighbours(self, path):
        """Ask which components the one at a path (text) is connected with; `news` returns their
        paths, a set.
        """
        self._act(path, "neighbours", _neighbours)

    def measure(self, path, command="measure"):
        """Measure how many values a second the component at a path (text) writes to its out ports: the rows
        show it for a while, and `news` returns lines.
        """

        async def measure(node):
            measured = await _flow(node)
            entry = self._entry(path)
            if entry is not None:
                entry.keep_measured(
                    {name: rate for name, rate in measured if not isinstance(rate, errors.Error)}
                )
            return list(map(_flow_line, measured)) or ["it has no out port"]

        self._act(path, command, measure)

    def run(self, coroutine):
        """The loop.Task of a coroutine that ends with this at the latest."""
        return self._tasks.start(coroutine)

    def node(self, path):
        """The Node of the component at a path (text), or None."""
        entry = self._entry(path)
        return entry and entry.node

    def _entry(self, path):
        identity = next((identities[path] for identities in self._found.values() if path in identities), None)
        return self._entries.get(identity)

    def _act(self, path, command, function):
        entry = self._entry(path)
        if entry is None:
            self._add_news(command, path, errors.NotFound(path))
            return

        async def act():
            try:
                result = await function(entry.node)
            except errors.Error as e:
                result = e
            entry.hurry()
            self._add_news(command, path, result)

        self._tasks.start(act(), entry.node.endpoint)

    def _add_news(self, command, path, result):
        self._news.append(((command, path), result))
        self.bell.ring()

    def news(self):
        """Results of `change`, `show` and the like since the last call: ((command, path), value or
        errors.Error).
        """
        news = self._news
        self._news = []
        return news


def _marked(row, mark):
    """A Row with what rtkeep says of its component before what was seen."""
    if mark is None:
        return row
    return row._replace(event="; ".join(filter(None, ("rtkeep: " + mark, row.event))))


def _rested(entries):
    """Those that may be asked now, those first that were not asked for longest."""
    now = loop.now()
    return sorted((entry for entry in entries if entry.again <= now), key=lambda entry: entry.asked)


async def _walk(top, bound):
    """(component nodes below a path, {path: errors.Error} of what cannot be listed); the name server is not
    asked for those that are `bound`, {path: Node}.
    """
    try:
        start = await tree.resolve(top)
        walked = list(await tree.walk(start, managers=start.kind == "manager", objects=bound))
    except errors.Error as e:
        return [], {str(top): e}
    unsure = [node for node in walked if node.kind == "unsure"]
    sure = dict(zip(unsure, await tree.check_alive(unsure)))
    nodes = [sure.get(node, node) for node in walked]
    failed = {
        str(node.path): node.error
        for node in nodes
        if node.error and (node.kind in tree.DIRECTORIES or node.ref is None)
    }
    return [
        node
        for node in nodes
        if node.kind in ("component", "zombie", *tree.DOUBTFUL) and node.ref is not None
    ], failed


def _each_server(tops):
    """The Paths, with all name servers in the place of the root."""
    for top in tops or [paths.ROOT]:
        if top.server is None:
            for address in tree.servers():
                yield paths.parse("/" + address)
        else:
            yield top


async def _description(node):
    described = await describe.collect(node, 1)
    return list(
        describe.lines(described, 1, await places.far_names(described.ports), lambda word, role=None: word)
    )


async def _neighbours(node):
    """The paths, as text, of the components that one is connected with."""
    ends = await places.far_ends(await ports.ports(node))
    ports_there = [end.port for end in ends.values() if end.port is not None]
    return {str(port.node.path.object()) for port in ports_there if port.node is not None}


async def _flow(node):
    """[(out port of a component, values that are written to it a second or an errors.Error)]"""
    measured = []
    for port in await ports.ports(node):
        if port.type == "DataOutPort":
            measured.append(port)
    return list(zip(map(ports.label, measured), await rates.written(measured, FLOW)))


def _flow_line(measured):
    name, rate = measured
    if isinstance(rate, errors.Error):
        return f"         ?  {name}: {safe(rate.why)}"
    return f"{rate:8.1f} Hz  {name}"
