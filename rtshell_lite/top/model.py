"""A whole system, polled: what rttop shows, as plain values that can be read without waiting.

At most IN_FLIGHT remote calls are made at a time, to all processes together. Each look asks a component for its state; its
contexts, rates and connections, which change less often and cost more, are asked for less often.
"""
import collections
import threading
import time

from rtshell_lite import errors, path as paths
from rtshell_lite.corba import lanes, orb, pool
from rtshell_lite.robot import component, places, snapshot, transitions, tree
from rtshell_lite.top.rows import Row
from rtshell_lite.views import describe

IN_FLIGHT = 4  # monitors that ask more at a time have disturbed real-time threads
DOUBTFUL = 2  # of these, at most so many to processes that have not answered (yet): they must not take all
WALK = 5.0  # seconds between looks at what is bound
CONTEXTS = 5.0  # seconds between looks at execution contexts and their rates
PORTS = 10.0  # seconds between looks at connections: each makes a component check the far ends
PORTS_SILENT = 60.0  # the same, for one that does not answer that
REST = 5.0  # seconds before what is dead or silent is asked again


# ---- one component --------------------------------------------------------------------------------------------

class _Entry:
    """A component that the thread of its group looks at."""

    def __init__(self, node):
        self.node = node
        self.group = node.endpoint
        self.kind, self.state, self.failure = "component", None, None
        self.ports = self.connections = None
        self.snapshot = snapshot.Snapshot(node, rest=REST)  # of its contexts; its ports would take much memory
        self.looked = False  # whether its state, or its failure, is known
        self.silenced = 0.0  # when it was silent last
        self._again = self._contexts_due = self._ports_due = 0.0

    def hurry(self):
        """Look at everything again, as something has been done to it."""
        self._again = self._contexts_due = self._ports_due = 0.0

    def look(self):
        """Ask it; False when it was not its time. Raises Silent."""
        now = time.monotonic()
        if now < self._again:
            return False
        try:
            self._look(now)
        except errors.Silent:
            raise
        except errors.Error as e:  # of the component, or passed on by it?
            self._again = now + REST
            node, = tree.look([self.node])
            if node.kind == "silent" and isinstance(node.error, errors.Silent):
                raise node.error
            self.fail("silent" if node.kind == "component" else node.kind, node.error or e)
        return True

    def _look(self, now):
        if now >= self._contexts_due:
            self.snapshot.ask(owned=snapshot.RUNNING, participating=snapshot.RUNNING)
            self._contexts_due = now + CONTEXTS
        self.snapshot.ask(states=snapshot.FULL)
        self.kind, self.state, self.failure = "component", component.merged(self.snapshot.states), None
        if now >= self._ports_due:
            self._look_at_ports()
        self.looked = True

    def _look_at_ports(self):
        pause = PORTS
        try:
            listed = snapshot.of(self.node, ports=snapshot.BRIEF).ports
            self.ports = len(listed)
            self.connections = len({connector.id for port in listed for connector in port.connectors})
        except errors.Error as e:  # it has just given its state: the ports are what is wrong
            self.ports = self.connections = None
            pause = PORTS_SILENT if isinstance(e, errors.Silent) else PORTS
        self._ports_due = time.monotonic() + pause

    def fail(self, kind, failure):
        """Note that it is dead, or does not answer, and forget what was known of it."""
        self.kind, self.state, self.failure = kind, "-" if kind == "zombie" else "?", failure
        self.ports = self.connections = None
        self.snapshot = snapshot.Snapshot(self.node, rest=REST)
        self._contexts_due = self._ports_due = 0.0
        self.looked = True

    def row(self, path, name):
        """Its Row."""
        contexts = self.snapshot.contexts
        first = next((context for context in contexts if context.running), contexts[0] if contexts else None)
        running = any(context.running for context in contexts) if contexts else None
        return Row(path, name, self.kind, self.state, first and first.rate, running, self.ports, self.connections,
                   self.failure)


# ---- the system -----------------------------------------------------------------------------------------------

class Top:
    """What is below the Paths `tops` (none: all name servers), looked at every `delay` seconds; to be closed."""

    def __init__(self, tops, delay):
        orb.start()
        lanes.session.slots = lanes.Slots(IN_FLIGHT)
        self.delay = delay
        self._ended = threading.Event()
        self._lock = threading.Lock()
        self._gate = threading.Semaphore(DOUBTFUL)
        self._calls = pool.Calls()
        self._tops = list(collections.OrderedDict.fromkeys(_each_server(tops)))
        self._found = {}  # by top: {path: identity of a component}
        self._failed = {}  # by top: {path: errors.Error} of what cannot be listed
        self._entries = {}  # by identity
        self._groups = set()
        for top in self._tops:
            self._calls.start(("walk", top), ("walk", top), lambda top=top: self._follow(top))

    def close(self):
        """Stop looking. Calls in flight end by their own deadlines."""
        self._ended.set()
        self._calls.close()
        lanes.session.slots = lanes.Slots()  # later calls, such as disconnecting, need not wait for hung ones

    # ---- what is bound ----

    def _follow(self, top):
        """Walk through a part of the tree until the end."""
        while True:
            nodes, failed = _walk(top)
            with self._lock:
                lost = any(isinstance(error, errors.Unreachable) for error in failed.values())
                identities = dict(self._found.get(top, {})) if lost else {}  # without their name server, they may still live
                for node in nodes:
                    identities[str(node.path)] = orb.identity(node.ref)
                    self._entries.setdefault(orb.identity(node.ref), _Entry(node))
                self._found[top], self._failed[top] = identities, failed
                wanted = {identity for places in self._found.values() for identity in places.values()}
                self._entries = {identity: entry for identity, entry in self._entries.items() if identity in wanted}
                self._look_after_all()
            if self._ended.wait(WALK):
                return

    # ---- looking ----

    def _look_after_all(self):
        """Start a thread for each new group of components: those of one process, and any that hangs while its process does not."""
        for entry in self._entries.values():
            if entry.group not in self._groups:
                self._groups.add(entry.group)
                self._calls.start(("look", entry.group), ("look", entry.group),
                                  lambda group=entry.group, endpoint=entry.node.endpoint: self._look_after(group, endpoint))

    def _look_after(self, group, endpoint):
        lanes.become_lane(endpoint)
        trusted = False
        while True:
            with self._lock:
                entries = [entry for entry in self._entries.values() if entry.group == group]
                if not entries:
                    self._groups.discard(group)
                    return
            if trusted:
                trusted = self._look(entries)
            else:
                with self._gate:
                    trusted = self._look(entries)
            if self._ended.wait(self.delay if trusted else REST):
                return

    def _look(self, entries):
        """Look at components of one process, one call at a time; False when it did not answer.

        If two are silent, or the only one, the process hangs: the rest is not asked.
        """
        heard, silent = False, []
        for entry in sorted(entries, key=lambda entry: entry.silenced):
            if self._ended.is_set():
                return True
            try:
                heard = entry.look() or heard
            except errors.Silent as e:
                entry.silenced = time.monotonic()
                entry.fail("silent", e)
                silent.append(entry)
                if heard or len(silent) == 2:
                    break
        if heard and silent:
            with self._lock:
                for entry in silent:
                    entry.group = orb.identity(entry.node.ref)
                self._look_after_all()
        elif silent:
            for entry in entries:
                entry.fail("silent", errors.Silent(str(entry.node.path), silent[-1].failure.why))
        return heard or not silent

    # ---- what it looks like ----

    def wait(self, seconds):
        """Wait until everything has been looked at, at most so many seconds."""
        end = time.monotonic() + seconds
        while not self._complete() and time.monotonic() < end:
            time.sleep(0.02)  # waits for events are not for the main thread, see interrupts.py

    def _complete(self):
        with self._lock:
            return len(self._found) == len(self._tops) and all(entry.looked for entry in self._entries.values())

    def rows(self):
        """A Row for each component, and for each part of the tree that cannot be listed, sorted by name."""
        with self._lock:
            paths_of, failed = {}, {}
            for top in self._found:
                for path, identity in sorted(self._found[top].items()):
                    paths_of.setdefault(identity, path)  # the first, if it is bound twice
                failed.update(self._failed[top])
            entries = [(path, self._entries[identity]) for identity, path in paths_of.items()]
        unique = len({entry.node.name for _, entry in entries}) == len(entries)
        rows = [entry.row(path, entry.node.name if unique else path) for path, entry in entries]
        rows += [Row(path, path, "unknown", "?", None, None, None, None, failure) for path, failure in failed.items()]
        return sorted(rows, key=lambda row: (row.name, row.path))

    # ---- acting ----

    def change(self, path, transition):
        """Take the component at a path (text) through a component.Transition; `news` returns its state then."""
        self._on(path, transition.command, lambda node: transitions.change(node, transition))

    def show(self, path):
        """Ask the component at a path (text) for all that rtcat -l shows; `news` returns the lines."""
        self._on(path, "rtcat", _description)

    def _on(self, path, command, function):
        with self._lock:
            entry = next((self._entries[places[path]] for places in self._found.values() if path in places), None)
        if entry is None:
            self._calls.post((command, path), errors.NotFound(path))
            return

        def act():
            try:
                return lanes.ask(entry.node.endpoint, path, lambda: function(entry.node))
            finally:
                entry.hurry()
        self._calls.start((command, path), (command, path), act)

    def news(self):
        """Results of `change` and `show` since the last call: ((command, path), value or errors.Error)."""
        news = []
        while True:
            ended = self._calls.ended(0)
            if ended is None:
                return news
            if ended[0][0] not in ("walk", "look"):
                news.append(ended)


def _walk(top):
    """(component nodes below a path, {path: errors.Error} of what cannot be listed)."""
    try:
        start = tree.resolve(top)
        walked = list(tree.walk(start, managers=start.kind == "manager"))
    except errors.Error as e:
        return [], {str(top): e}
    unsure = [node for node in walked if node.kind == "unsure"]
    sure = dict(zip(unsure, tree.look(unsure)))
    nodes = [sure.get(node, node) for node in walked]
    failed = {str(node.path): node.error for node in nodes
              if node.error and (node.kind in tree.DIRECTORIES or node.ref is None)}
    return [node for node in nodes if node.kind in ("component", "zombie", "silent") and node.ref is not None], failed


def _each_server(tops):
    """The Paths, with all name servers in the place of the root."""
    for top in tops or [paths.ROOT]:
        if top.server is None:
            for address in tree.servers():
                yield paths.parse("/" + address)
        else:
            yield top


def _description(node):
    described = describe.collect(node, 1)
    return list(describe.lines(described, 1, places.far_names(described.ports), lambda word, role=None: word))
