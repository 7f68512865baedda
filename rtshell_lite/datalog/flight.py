"""Recording a whole robot: every out port below some paths, now and later, and which of their values.

Name servers are asked again and again which components there are; a component is asked for its ports once,
when it appears, or another object has its name. No port gets more than one connector.
"""


from rtshell_lite import errors, notes
from rtshell_lite.corba import orb, session
from rtshell_lite.data import reading
from rtshell_lite.giop import descriptors
from rtshell_lite.live import times
from rtshell_lite.net import loop
from rtshell_lite.robot import component, composites, ports, search, tree

SEEK = 1.0  # seconds between two looks for components; more where there are many
SEEK_EACH = 0.004  # seconds for each of those that are there
AGAIN = 10.0  # seconds until one that did not answer is asked again
# values a second that a component may send, beyond which it does not call us in its own cycle: each would
# cost it 0.1 ms
FAST = 1000


class Choice:
    """Which ports are recorded or played, and how many of their values are recorded.

    `only` and `without` are shell patterns for ports and types; `every` and `at_most`: {pattern: number}, of
    which the first that fits counts.
    """

    def __init__(self, only=(), without=(), every=None, at_most=None):
        self._only = search.patterns(only, ())
        self._without = search.patterns(without, ())
        self._every = [(search.patterns([glob], ())[0], number) for glob, number in (every or {}).items()]
        self._at_most = [(search.patterns([glob], ())[0], hertz) for glob, hertz in (at_most or {}).items()]

    def takes(self, port):
        """Whether a Port is recorded."""
        return port.type == "DataOutPort" and self.allows(_names(port))

    def allows(self, names):
        """Whether what has these names (see `names_of`) is wanted."""
        if self._only and not _fits(self._only, names):
            return False
        return not _fits(self._without, names)

    def thin(self, port, deliver):
        """A function that delivers some of the Messages of a Port."""
        names = _names(port)
        for numbers, thinned in ((self._every, _every), (self._at_most, _at_most)):
            number = next((number for pattern, number in numbers if _fits([pattern], names)), None)
            if number is not None:
                deliver = thinned(number, deliver)
        return deliver


def _names(port):
    return names_of(ports.label(port), port.properties.get("dataport.data_type", ""))


def names_of(label, type_id):
    """What patterns may fit: the path of a port, the end of it, its name; its type, in all spellings."""
    dotted = descriptors.dotted(type_id)
    return [label, label.rpartition("/")[2], label.rpartition(":")[2], dotted, dotted.rpartition(".")[2]]


def _fits(patterns, names):
    return any(match(name) for match in patterns for name in names)


def _every(number, deliver):
    count = -1

    def take(message):
        nonlocal count
        count += 1
        if count % number == 0:
            deliver(message)

    return take


def _at_most(hertz, deliver):
    due = 0
    period = int(1e9 / hertz)

    def take(message):
        nonlocal due
        if message.received >= due:
            due = max(due + period, message.received + period // 2)  # they come a little early or late
            deliver(message)

    return take


class Flight:
    """Follows the components below `tops` (Paths), and reads their ports.

    make(port, about, is_fast): an awaitable for the reading.Reader of a Port; `about`: what else is known of
    it; `is_fast`: its component must not call us in its own cycle; raises errors.Error. `readers` is the list
    of Readers, which grows and shrinks; `components` are all that were seen, with their ports.
    """

    def __init__(self, tops, choice, make, readers):
        self._tops = tops
        self._choice = choice
        self._make = make
        self.readers = readers
        self.components = {}  # {path as text: (Node, its Ports)}, the newest object of that name
        self.failures = {}  # by path: why it could not be listed
        self._due = {}  # by identity of a component: when it is asked again; None: not
        self._gone = set()  # identities of ports that are gone
        self._walks = 0
        self._read = {orb.identity(reader.port.ref): reader for reader in readers}  # by identity of a port

    async def follow(self, opened):
        """Look for components again and again, and connect to their ports, in connection.Connections."""
        while True:
            await loop.sleep(max(SEEK, SEEK_EACH * len(self.components)))
            self._drop_dead(opened)
            readers = await self.find()
            if readers:
                await opened.add(readers)

    async def find(self):
        """Readers for the ports of components that have come."""
        new = self._not_asked_yet(await self._list())
        readers = []
        for node, answer in zip(new, await session.each(new, _ports)):
            if isinstance(answer, errors.Error):
                continue
            self._due[orb.identity(node.ref)] = None
            listed, about = answer
            self.components[str(node.path)] = node, listed
            for port in listed:
                reader = await self._reader(port, about, _is_fast(listed, about))
                if reader is not None:
                    readers.append(reader)
        self.readers += readers
        return readers

    async def _list(self):
        """The Nodes of all components below the paths; which could not be listed is in `failures`."""
        self.failures = {}
        nodes = []
        answering = self._answering() if self._walks % times.WHOLE else {}
        self._walks += 1
        answers = await session.each(self._tops, lambda top: _components(top, answering), tree.at_server)
        for top, listed in zip(self._tops, answers):
            if isinstance(listed, errors.Error):
                self.failures[str(top)] = listed
            else:
                nodes += listed
        return nodes

    def _answering(self):
        """{path as text: Node} of the components whose ports are read: their names lead to them."""
        read = {id(reader.port.node) for reader in self.readers if reader.failure is None}
        return {where: node for where, (node, _) in self.components.items() if id(node) in read}

    def _not_asked_yet(self, nodes):
        """Those of the Nodes that are to be asked for their ports now."""
        now = loop.now()
        new = []
        for node in nodes:
            identity = orb.identity(node.ref)
            due = self._due.get(identity, 0.0)
            if due is not None and now >= due:
                self._due[identity] = now + AGAIN
                new.append(node)
        return new

    async def _reader(self, port, about, is_fast):
        """The Reader for a Port; None where it is not wanted, or read already."""
        identity = orb.identity(port.ref)
        if identity in self._read or not self._choice.takes(port):
            return None
        is_fast = is_fast and not ports.offer_without(port, reading.SUBSCRIPTION, "new")
        try:
            reader = await self._make(port, about, is_fast)
        except errors.Error as e:
            notes.fail(e)
            return None
        self._read[identity] = reader
        return reader

    def _drop_dead(self, opened):
        """Forget the Readers of ports that were gone at the last look, and are reported: they may
        come back.
        """
        failed = [entry for entry in self._read.items() if isinstance(entry[1].failure, errors.Unreachable)]
        live = opened.live() if failed else []
        gone = {identity for identity, reader in failed if reader not in live}
        for identity in gone & self._gone:
            reader = self._read.pop(identity)
            self._due.pop(orb.identity(reader.port.node.ref), None)
            self.readers.remove(reader)
            opened.drop(reader)
        self._gone = gone


def _is_fast(listed, about):
    """Whether a component with these Ports may send many values."""
    count = sum(port.type == "DataOutPort" for port in listed)
    return count * float(dict(about).get("rate", 0)) > FAST


async def _ports(node):
    """(Ports of a component, what its own execution context says of the rate of its values)"""
    listed = await ports.ports(node)
    if not any(port.type == "DataOutPort" for port in listed):
        return listed, ()
    try:
        owned = await component.owned_context_refs(node)
        context = await component.context(node, owned[0])
    except (errors.Error, IndexError):
        return listed, ()
    return listed, (("context", context.kind), ("rate", f"{context.rate:g}"))


async def _components(top, with_nodes):
    """The components at and below a Path, whose last name may be a pattern; members of a composite, too. The
    name server is not asked for those `with_nodes`, {path as text: Node}.
    """
    names = top.names
    if names and any(mark in str(names[-1]) for mark in "*?"):
        parent = await tree.resolve(top.parent())
        match = search.patterns([str(names[-1])], ())[0]
        below = [node for node in await tree.children(parent) if match(node.name)]
        nodes = [
            inner for node in below for inner in await tree.walk(node, managers=node.kind == "manager")
        ]
    else:
        node = await tree.resolve(top)
        nodes = await tree.walk(node, managers=node.kind == "manager", objects=with_nodes)
        if node.kind == "component":
            nodes += await _members(node, {orb.identity(node.ref)})
    if nodes and nodes[0].error is not None:
        raise nodes[0].error
    return [node for node in nodes if node.kind == "component" and node.alias is None]


async def _members(node, refs):
    """The Nodes of the members of a composite, as far as they have names, and are not among those of `refs`,
    identities: a composite may claim to be a member of itself.
    """
    from rtshell_lite import path as paths

    members = []
    for organisation in await composites.owned(node):
        for text in await composites.member_paths(node, organisation):
            if not text.startswith("/"):
                continue
            member = await tree.component(paths.parse(text))
            if orb.identity(member.ref) not in refs:
                refs.add(orb.identity(member.ref))
                members += [member] + await _members(member, refs)
    return members
