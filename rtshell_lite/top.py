"""A whole system, looked at again and again: what rttop shows, as plain values that are there without waiting.

At most IN_FLIGHT remote calls are made at one time, to all processes together. Each look asks a component for its state; its
contexts, rates and connections, which change less often and cost more, are asked for now and then.
"""
import collections
import threading
import time

from rtshell_lite import component, describe, errors, orb, path as paths, ports, rpc, text, tree

IN_FLIGHT = 4  # monitors that ask more at a time have disturbed real-time threads
DOUBTFUL = 2  # of these, how many may go to processes that have not answered, or not yet: they must not take all
WALK = 5.0  # seconds between looks at what is bound
CONTEXTS = 5.0  # seconds between looks at execution contexts and their rates
PORTS = 10.0  # seconds between looks at connections: each makes a component see whether the far ends are there
PORTS_SILENT = 60.0  # the same, for one that does not answer that question
REST = 5.0  # seconds for which what is dead or silent is left alone
WINDOW = 2.0  # seconds over which the rate of a port is taken

SORTS = ("name", "state", "rate", "connections")
STATES = ("Error", "?", "-", "Active", "Inactive", "Created", "Unknown")  # the order by state: trouble first

# One line of the page. `name` tells it from the others; `state` is ? for what does not answer and - for a zombie; `rate` in Hz,
# of the first context that runs, else of the first one; `running` whether any does; `ports` and `connections` are counts. What
# is not known (yet) is None. `failure` is an errors.Error; rows of kind component have none, or tell what is odd.
Row = collections.namedtuple("Row", "path name kind state rate running ports connections failure")

# The flow of one port: values and bytes a second, None while not known; `failure` an errors.Error or None.
Rate = collections.namedtuple("Rate", "path values bytes failure")


# ---- one component --------------------------------------------------------------------------------------------

class _Context:
    """An execution context as it was seen last. `deaf` is when it may be asked again, if its process did not answer."""

    def __init__(self, ref):
        self.ref, self.rate, self.running, self.deaf = ref, None, None, 0.0


class _Entry:
    """A component that is looked at, by the thread of its group."""

    def __init__(self, node):
        self.node = node
        self.group = node.endpoint
        self.kind, self.state, self.failure = "component", None, None
        self.ports = self.connections = None
        self.contexts = []
        self.looked = False
        self.silenced = 0.0  # when it was silent last
        self._again = self._contexts_due = self._ports_due = 0.0

    def hurry(self):
        """Something has been done to it: look at everything anew."""
        self._again = self._contexts_due = self._ports_due = 0.0

    def look(self):
        """See how it is; False when it was not asked. Raises Silent."""
        now = time.monotonic()
        if now < self._again:
            return False
        try:
            self._look(now)
        except errors.Silent:
            self._contexts_due = 0.0
            raise
        except errors.Error as e:  # of the component, or of something behind it?
            self._contexts_due, self._again = 0.0, now + REST
            node, = tree.look([self.node])
            if node.kind == "silent" and isinstance(node.error, errors.Silent):
                raise node.error
            self.fail("silent" if node.kind == "component" else node.kind, node.error or e)
        return True

    def _look(self, now):
        if now >= self._contexts_due:
            self._look_at_contexts()
            self._contexts_due = now + CONTEXTS
        state = component.merged([self._of(each, lambda each=each: component.state_in(self.node, each.ref), "Unknown")
                                  for each in self.contexts])
        self.kind, self.state, self.failure = "component", state, None
        if now >= self._ports_due:
            self._look_at_ports()

    def _look_at_contexts(self):
        owned, participating = component.context_refs(self.node)
        known = {orb.identity(each.ref): each for each in self.contexts}
        contexts = [known.get(orb.identity(ref)) or _Context(ref) for ref in owned + participating]
        for each in contexts:
            each.rate, each.running = self._of(each, lambda each=each: self._run(each.ref), (None, None))
        self.contexts = contexts

    def _run(self, ref):
        where = str(self.node.path)
        return orb.ask(where, ref, "get_rate"), bool(orb.ask(where, ref, "is_running"))

    def _of(self, context, ask, otherwise):
        """ask(), or `otherwise` where a context of another process does not answer; that is left alone for a while."""
        if time.monotonic() < context.deaf:
            return otherwise
        try:
            return ask()
        except errors.Unreachable:
            if orb.endpoint(context.ref) == self.node.endpoint:
                raise
            context.deaf = time.monotonic() + REST
            return otherwise

    def _look_at_ports(self):
        pause = PORTS
        try:
            found = ports.ports(self.node)
            self.ports = len(found)
            self.connections = len({connector.id for port in found for connector in port.connectors})
        except errors.Error as e:  # it has just told its state: the ports are what is wrong
            self.ports = self.connections = None
            pause = PORTS_SILENT if isinstance(e, errors.Silent) else PORTS
        self._ports_due = time.monotonic() + pause

    def fail(self, kind, failure):
        """It is dead, or does not answer; what was known of it does not count any more."""
        self.kind, self.state, self.failure = kind, "-" if kind == "zombie" else "?", failure
        self.ports = self.connections = None
        self.contexts = []
        self.looked = True

    def row(self, path, name):
        """Its Row."""
        contexts = list(self.contexts)
        first = next((each for each in contexts if each.running), contexts[0] if contexts else None)
        running = any(each.running for each in contexts) if contexts else None
        return Row(path, name, self.kind, self.state or "?", first and first.rate, running, self.ports, self.connections,
                   self.failure)


# ---- the flow of one port -------------------------------------------------------------------------------------

class Meter:
    """Counts the values of a port; `take` is for a dataport.Reader."""

    def __init__(self, path, failure=None):
        self.path, self.failure = path, failure
        self.reader = None
        self.values = self.bytes = 0
        self._looks = collections.deque()  # (when, values, bytes)

    def take(self, message):
        """Count a dataport.Message, on a thread of the ORB."""
        self.values += 1
        self.bytes += len(message.data)

    def rate(self):
        """The Rate since the last look but a few."""
        now = time.monotonic()
        while len(self._looks) > 1 and now - self._looks[1][0] >= WINDOW:
            self._looks.popleft()
        first = self._looks[0] if self._looks else None
        self._looks.append((now, self.values, self.bytes))
        failure = self.failure or self.reader and self.reader.failure
        if failure or first is None or now - first[0] < component.POLL:
            return Rate(self.path, None, None, failure)
        return Rate(self.path, (self.values - first[1]) / (now - first[0]), (self.bytes - first[2]) / (now - first[0]), None)


# ---- the system -----------------------------------------------------------------------------------------------

class Top:
    """What is below the Paths `tops` (none: all name servers), looked at every `delay` seconds; to be closed."""

    def __init__(self, tops, delay, meters=()):
        orb.start()
        rpc.slots = rpc.Slots(IN_FLIGHT)
        self.delay, self.meters = delay, list(meters)
        self._ended = threading.Event()
        self._lock = threading.Lock()
        self._gate = threading.Semaphore(DOUBTFUL)
        self._calls = rpc.Calls()
        self._places = {}  # by top: {path: identity of a component}, and {path: Node} of what cannot be listed
        self._entries = {}  # by identity
        self._groups = set()
        self._tops = list(collections.OrderedDict.fromkeys(_each_server(tops)))
        self._news = []

    def start(self):
        """Begin to look."""
        for top in self._tops:
            self._calls.start(("walk", top), ("walk", top), lambda top=top: self._follow(top))

    def close(self):
        """Look no more. What is in flight ends by its own deadline."""
        self._ended.set()
        self._calls.close()
        rpc.slots = rpc.Slots()  # what is still to be done, disconnecting say, does not wait for the hung

    # ---- what is bound ----

    def _follow(self, top):
        """Walk through a part of the tree again and again."""
        while True:
            nodes, failed = self._walk(top)
            with self._lock:
                for node in nodes:
                    self._entries.setdefault(orb.identity(node.ref), _Entry(node))
                self._places[top] = {str(node.path): orb.identity(node.ref) for node in nodes}, failed
                wanted = {identity for found, _ in self._places.values() for identity in found.values()}
                self._entries = {identity: each for identity, each in self._entries.items() if identity in wanted}
                self._look_after_all()
            if self._ended.wait(WALK):
                return

    def _walk(self, top):
        """(component nodes below a path, {path: errors.Error} of what cannot be listed)."""
        try:
            walked = list(tree.walk(tree.resolve(top), managers=False))
        except errors.Error as e:
            return [], {str(top): e}
        unsure = [node for node in walked if node.kind == "unsure"]
        sure = dict(zip(unsure, tree.look(unsure)))
        nodes = [sure.get(node, node) for node in walked]
        failed = {str(node.path): node.error for node in nodes if node.kind in tree.DIRECTORIES and node.error}
        return [node for node in nodes if node.kind in ("component", "zombie", "silent") and node.ref is not None], failed

    # ---- looking ----

    def _look_after_all(self):
        """Have a thread for each group of components: those of one process, and any that hangs while its process does not."""
        for each in self._entries.values():
            if each.group not in self._groups:
                self._groups.add(each.group)
                self._calls.start(("look", each.group), ("look", each.group), lambda each=each: self._look_after(
                    each.group, each.node.endpoint))

    def _look_after(self, group, endpoint):
        rpc.become_lane(endpoint)
        trusted = False
        while True:
            with self._lock:
                mine = [each for each in self._entries.values() if each.group == group]
                if not mine:
                    self._groups.discard(group)
                    return
            if trusted:
                trusted = self._look(mine)
            else:
                with self._gate:
                    trusted = self._look(mine)
            if self._ended.wait(self.delay if trusted else REST):
                return

    def _look(self, mine):
        """Look at components of one process, one call at a time; False when it did not answer.

        Two silent ones, or the only one, tell that the process hangs: the rest is not asked.
        """
        heard, silent = False, []
        for each in sorted(mine, key=lambda each: each.silenced):
            if self._ended.is_set():
                break
            try:
                heard = each.look() or heard
                each.looked = True
            except errors.Silent as e:
                each.silenced = time.monotonic()
                each.fail("silent", e)
                silent.append(each)
                if heard or len(silent) == 2:
                    break
        if not silent:
            return True
        if heard:
            with self._lock:
                for each in silent:
                    each.group = orb.identity(each.node.ref)
                self._look_after_all()
            return True
        for each in mine:
            each.fail("silent", silent[-1].failure)
        return False

    # ---- what it looks like ----

    def complete(self):
        """True when everything has been looked at once."""
        with self._lock:
            return len(self._places) == len(self._tops) and all(each.looked for each in self._entries.values())

    def wait(self, seconds):
        """Wait until everything has been looked at, at most for so long."""
        end = time.monotonic() + seconds
        while not self.complete() and time.monotonic() < end:
            self.news()
            self._ended.wait(0.02)

    def rows(self):
        """A Row for each component and each part of the tree that cannot be listed, sorted by name."""
        with self._lock:
            found, failed = {}, {}
            for places, failures in self._places.values():
                for path, identity in sorted(places.items()):
                    found.setdefault(identity, path)
                failed.update(failures)
            entries = [(path, self._entries[identity]) for identity, path in found.items()]
        counts = collections.Counter(each.node.name for _, each in entries)
        rows = [each.row(path, each.node.name if counts[each.node.name] == 1 else path) for path, each in entries]
        rows += [Row(path, path, "unknown", "?", None, None, None, None, failure) for path, failure in failed.items()]
        return sorted(rows, key=lambda row: (row.name, row.path))

    def rates(self):
        """A Rate for each port that is measured."""
        return [meter.rate() for meter in self.meters]

    # ---- acting ----

    def change(self, path, transition):
        """Take the component at a path (text) through a component.Transition; `news` tells how that ended."""
        self._do(path, ("change", path, transition), lambda node: component.change(node, transition))

    def show(self, path):
        """Ask the component at a path for all that rtcat -l shows; `news` has the lines."""
        self._do(path, ("show", path, None), _description)

    def _do(self, path, key, function):
        entry = self._entry(path)
        if entry is None:
            self._news.append((key, errors.NotFound(path)))
            return

        def act():
            try:
                return rpc.ask(entry.node.endpoint, path, lambda: function(entry.node))
            finally:
                entry.hurry()
        self._calls.start(key, key, act)

    def _entry(self, path):
        with self._lock:
            for places, _ in self._places.values():
                if path in places:
                    return self._entries[places[path]]
        return None

    def news(self):
        """What has come of `change` and `show` since the last time: ((what, path, transition), value or errors.Error)."""
        news, self._news = self._news, []
        while True:
            ended = self._calls.ended(0)
            if ended is None:
                return news
            if ended[0][0] in ("change", "show"):
                news.append(ended)


def _each_server(tops):
    """Paths, with the name servers themselves in the place of the root."""
    for top in tops or [paths.ROOT]:
        if top.server is None:
            for address in tree.servers():
                yield paths.parse("/" + address)
        else:
            yield top


def _description(node):
    found = describe.collect(node, 1)
    return list(describe.lines(found, 1, ports.far_ends(node, found.ports), lambda word, role=None: word))


# ---- order and choice -----------------------------------------------------------------------------------------

def arranged(rows, sort="name", wanted=""):
    """The Rows that match all words of `wanted`, in the order of one of SORTS.

    A word matches a path that it is a part of, or a state that it is, in capitals or not.
    """
    words = wanted.lower().split()
    rows = [row for row in rows if all(word in row.path.lower() or word == row.state.lower() for word in words)]
    keys = {"name": lambda row: 0, "state": lambda row: STATES.index(row.state) if row.state in STATES else len(STATES),
            "rate": lambda row: -(row.rate or 0), "connections": lambda row: -(row.connections or 0)}
    return sorted(rows, key=keys[sort])


# ---- plainly --------------------------------------------------------------------------------------------------

HEAD = "STATE         RATE  CONN  COMPONENT"


def cells(row):
    """(state, rate, connections, name and, where there is one, the reason) of a Row: what a line consists of."""
    rate = "-" if row.rate is None else "stopped" if row.running is False else "%g" % row.rate
    mark = {"zombie": "*", "silent": "?"}.get(row.kind, "")
    return (row.state, rate, "-" if row.connections is None else str(row.connections),
            mark + row.name + (": " + reason(row.path, row.failure) if row.failure else ""))


def line(row, paint=lambda word, role=None: word):
    """A Row as a line; `paint` colours it (see text.painter)."""
    state, rate, connections, name = cells(row)
    return "%s  %8s  %4s  %s" % (text.padded(paint(state), 8), rate, connections, paint(name, row.kind))


def rate_line(rate):
    """A Rate as a line."""
    if rate.failure:
        return "%8s Hz  %11s  %s" % ("?", "?", "%s: %s" % (rate.path, reason(rate.path, rate.failure)))
    if rate.values is None:
        return "%8s Hz  %11s  %s" % ("-", "-", rate.path)
    return "%8.1f Hz  %11s  %s" % (rate.values, _size(rate.bytes), rate.path)


def _size(bytes_per_second):
    for factor, unit in ((1e9, "GB/s"), (1e6, "MB/s"), (1e3, "kB/s")):
        if bytes_per_second >= factor:
            return "%.1f %s" % (bytes_per_second / factor, unit)
    return "%.0f B/s" % bytes_per_second


def reason(path, failure):
    """Why something failed, in one line for the terminal, without the path that stands before it."""
    words = text.safe(str(failure))
    return words[len(path) + 2:] if words.startswith(path + ": ") else words


def summary(rows):
    """How many there are, and in which states: 3 components: 1 Error, 2 Active."""
    counts = collections.Counter(row.state for row in rows if row.kind != "unknown")
    total = sum(counts.values())
    states = ", ".join("%d %s" % (counts[state], {"-": "zombie"}.get(state, state)) for state in STATES if counts[state])
    return "%d component%s%s" % (total, "" if total == 1 else "s", ": " + states if states else "")


def as_dict(row):
    """The JSON object of a Row."""
    fields = {"path": row.path, "name": row.name, "kind": row.kind, "state": row.state, "rate": row.rate, "running": row.running,
              "ports": row.ports, "connections": row.connections}
    return dict(fields, error=str(row.failure)) if row.failure else fields


def rate_as_dict(rate):
    """The JSON object of a Rate."""
    fields = {"path": rate.path, "kind": "port", "values_per_second": rate.values and round(rate.values, 3),
              "bytes_per_second": rate.bytes and round(rate.bytes, 1)}
    return dict(fields, error=str(rate.failure)) if rate.failure else fields
