"""The RTC Tree: name servers as a file system of directories, components, managers and ports.

Resolution is lazy: only what a path names is asked. As a library:

    from rtshell_lite.robot import tree
    async def main():
        for node in await tree.walk(await tree.resolve("/localhost")):
            print(node.path, node.kind)
    loop.run(main())
"""

import os

from rtshell_lite import errors, notes
from rtshell_lite.corba import orb, session
from rtshell_lite.net import loop
from rtshell_lite.robot import aliases
from rtshell_lite.path import DEFAULT_PORT, MANAGER_PORT, REFERENCES, ROOT, Name, Path, parse

# other modules use these as tree.check_alive, tree.Node …
from rtshell_lite.robot.node import (
    DIRECTORIES, DOUBTFUL, Node, bound, check_alive, classified, classify_answer, kind_of, name_server_error,
    unusable,
)
from rtshell_lite.records import cached
from rtshell_lite.text import closest, from_wire, printable, shell_word

AT_ONCE = 1000  # names whose objects are asked for at a time: a pending call takes memory
DEPTH = 64  # contexts can be bound inside themselves by another name
# What is taken in one walk: a name server can make three contexts in each of its contexts, for ever.
MOST_WALKED = 50000  # names
MOST_WRITTEN = 8 << 20  # characters of all their paths
WALK = 20  # times the timeout
# of a walk of what did not end before, in a command that looks again and again
FEW_WALKED = 1000
SHORT_WALK = 2
# where a name that is missing is looked for, so that an error names the path that was meant
MOST_SEARCHED = 16  # directories
MOST_MEANT = 3  # paths that an error names
MOST_LOOKED_FOR = 20  # names a command: it may look for one again and again


# ---- name servers ----


def servers():
    """Addresses of the name servers of RTCTREE_NAMESERVERS (separated by semicolons), else localhost."""
    listed = [address for address in os.environ.get("RTCTREE_NAMESERVERS", "").split(";") if address.strip()]
    return list(dict.fromkeys(address.strip() for address in listed or ["localhost"]))


async def known_servers(first):
    """Nodes of the name server at the address `first`, and of those of `servers` whose addresses are valid;
    contacts nobody.
    """
    nodes = []
    if first is None:  # of a component that has no name
        first = servers()[0]
    for address in [first] + [address for address in servers() if address != first]:
        try:
            nodes.append(name_server(address))
        except errors.BadPath:
            pass
    return nodes


def _server(path):
    """The node of the name server, or of the object, that `path` begins with; contacts nobody."""
    if path.server.startswith(REFERENCES):
        return _object(path.server)
    return Node(Path(path.server, (), None, False), "server", _reference(path.server))


def name_server(address):
    """The node of the name server at an address of `servers`; contacts nobody. Raises BadPath.

    It may be a manager, too, that is reached without a name server: corbaloc:iiop:HOST:PORT/manager.
    """
    if "," in address or len(address.split()) > 1:
        raise errors.BadPath(printable(address), "several name servers are separated by semicolons")
    if not address.startswith(REFERENCES):
        address = "/" + address
    return _server(parse(address))


def _object(reference):
    """The Node of an object that is reached without a name server: corbaloc:… or IOR:…"""
    path = Path(reference, (), None, False)
    if reference.startswith("IOR:"):
        ref = orb.from_text(str(path), reference)
    else:
        address, _, key = reference.partition("iiop:")[2].partition("/")
        ref = orb.corbaloc(str(path), address, key, MANAGER_PORT)
    return Node(path, kind_of(orb.address(ref).type_id), ref)


@cached(64)
def _reference(server):
    where = str(Path(server, (), None, False))
    return orb.context(orb.corbaloc(where, server, "NameService", DEFAULT_PORT))


def server_endpoint(path):
    """The endpoint of the name server that `path` begins with; None at the root."""
    if path.server is None:
        return None
    if path.server.startswith(REFERENCES):
        return _object(path.server).endpoint
    return orb.endpoint(_reference(path.server))


# ---- from a path to a node ----


async def resolve(path):
    """The Node at `path` (a Path or text; its port is left out). One call to the name server, none to a
    component.

    A component or manager comes back unasked: `check_alive` finds out whether it lives; a corbaloc is asked
    what it is. Raises NotFound, Misspelt, WrongKind, and Unreachable or Silent when the name server does not
    answer.
    """
    if isinstance(path, str):
        path = parse(path)
    path = path.object()
    if path.server is None:
        return Node(ROOT, "root")
    return await _resolved(_server(path), path)


async def _resolved(server, path):
    if path.server.startswith(REFERENCES):
        server = await _identified(server)
    if not path.names:
        return server
    if server.kind == "manager":
        return await _descend(server, path.names)
    await _directory(server)
    for size, name in enumerate(path.names[:-1], 1):
        # otherwise the name server asks this object whether it is a naming context
        if name.kind in ("rtc", "mgr"):
            above = await _directory(await _resolved(server, path._replace(names=path.names[:size])))
            if above.kind == "manager":
                return await _descend(above, path.names[size:])
    try:
        ref = await server.call("resolve", orb.naming_name(path.names))
    except errors.Garbled as e:
        return unusable(path, e)
    except errors.Refused as e:
        if e.name in ("NotFound", "CannotProceed", "InvalidName"):
            raise await _why_not_found(path)
        raise name_server_error(server, e)
    except errors.Unreachable as e:
        if isinstance(e, errors.Unanswered):
            raise e
        raise await _broken_off(server, path, e)
    if ref is None or orb.address(ref).type_id:
        return classified(path, ref)
    entries = await bound(await _resolved(server, path.parent()))  # how it is bound shows more
    return classified(path, ref, (path.names[-1], True) in entries)


async def _identified(node):
    """The Node of an object that is reached without a name server, asked what it is."""
    if node.kind != "unsure":
        return node
    (node,) = await check_alive([node])
    key = node.path.server.rpartition("/")[2]
    if isinstance(node.error, errors.Gone):
        raise errors.NoSuch(str(node.path), "object", printable(key))
    if isinstance(node.error, errors.ConnectionRefused) and key == "manager":
        raise errors.NoManager(str(node.path))
    if node.error:
        raise node.error
    return node


async def _broken_off(server, path, failure):
    """The error for a path through several name servers, of which one cannot be reached;
    it names that one.
    """
    node = server
    try:
        for size, name in enumerate(path.names[:-1], 1):
            ref = await node.call("resolve", orb.naming_name([name]))
            node = classified(path._replace(names=path.names[:size]), ref, True)
            if node.kind != "directory":
                return failure
        await node.call("resolve", orb.naming_name(path.names[-1:]))
    except errors.Unreachable as e:
        return e
    except errors.Refused:
        pass
    return failure


async def _descend(node, names):
    """The Node below a manager that `names` lead to."""
    for name in names:
        below = await children(await _directory(node))
        matching = [child for child in below if child.path.names[-1] == name]
        if len(matching) > 1:  # of several slaves
            why = f"{node.path} has {len(matching)} of that name"
            raise errors.Ambiguous(str(node.path.child(name)), why)
        if not matching:
            names = _by_id(child.path.names[-1] for child in below)
            raise _near_miss(node.path.child(name), names)
        node = matching[0]
    return node


async def _directory(node):
    if node.kind == "unsure":
        (node,) = await check_alive([node])
    if node.kind not in DIRECTORIES:
        raise errors.WrongKind(str(node.path), "directory", node.what)
    return node


async def _why_not_found(path):
    """The error for a path that does not resolve, with a similar name if its directory has one."""
    try:
        above = await _directory(await resolve(path.parent()))
        entries = await bound(above)
    except (errors.NotFound, errors.WrongKind) as e:
        return e
    deeper = await _deeper(above, path.names[-1], [name for name, is_context in entries if is_context])
    if deeper:
        return errors.Misspelt(str(path), " or ".join(deeper))
    return _near_miss(path, _by_id(name for name, _ in entries))


async def _deeper(above, name, directories):
    """Paths from a directory to the nearest objects of a name below it, as far as its own name server has
    them: a component is often called by its name alone.
    """
    here = session.current()
    if here.looked_for >= MOST_LOOKED_FOR:
        return []
    here.looked_for += 1
    sought = name if name.kind else Name(name.id, "rtc")
    searched = 0
    level = [(above, directory) for directory in directories]
    while level and searched + len(level) <= MOST_SEARCHED:
        searched += len(level)
        nodes = await _own_directories(level)
        objects = await _of_directories(nodes, lambda node: _leads_to(node, sought))
        if objects:
            depth = len(above.path.names)
            meant = sorted("/".join(str(step) for step in path.names[depth:]) for path in objects)
            return meant if len(meant) <= MOST_MEANT else []
        level = await _of_directories(nodes, _directories_in)
    return []


async def _own_directories(entries):
    """Those of (Node, name of a directory in it) that are directories of the same name server, as Nodes."""

    async def look(entry):
        above, directory = entry
        node = await _child((above.typed, above.path.child(directory), True))
        is_own = node.kind == "directory" and not await aliases.is_foreign(above, node)
        return node if is_own else None

    answers = await session.each(
        entries, look, lambda entry: (entry[0].endpoint, entry[0].path.child(entry[1]))
    )
    return [answer for answer in answers if isinstance(answer, Node)]


async def _of_directories(nodes, function):
    """All that `function` lists for directories; nothing for one that cannot be asked."""
    answers = await session.each(nodes, function, lambda node: (node.endpoint, node.path))
    return [item for answer in answers if isinstance(answer, list) for item in answer]


async def _leads_to(node, name):
    await node.call("resolve", orb.naming_name([name]))
    return [node.path.child(name)]


async def _directories_in(node):
    return [(node, name) for name, is_context in await bound(node) if is_context]


def _by_id(names):
    return {name.id: name for name in names}


def _near_miss(path, names):
    last = path.names[-1]
    close = closest(last.id, names)  # the kinds, all .rtc, would make any two names alike
    if close is None:
        return nothing_at(path, path.parent())
    return errors.Misspelt(str(path), str(names[close]))


def nothing_at(path, above):
    """The error for a Path that leads to nothing; where it ends with a pattern, names the command that looks
    for that below the Path `above`.
    """
    last = path.names[-1]
    if "*" in last.id or "?" in last.id:
        pattern = shell_word(str(last))
        return errors.NoPattern(str(path), f"rtfind {shell_word(str(above))} -n {pattern}")
    return errors.NotFound(str(path))


async def component(path, or_manager=False):
    """The component (`or_manager`: or the manager) at `path` (a Path or text). Asks it nothing.

    Raises as `resolve` does, WrongKind (for a port, too), Gone for a zombie.
    """
    if isinstance(path, str):
        path = parse(path)
    if path.port is not None:
        raise errors.WrongKind(str(path), "component", "port")
    node = await resolve(path)
    if node.kind == "unsure":
        (node,) = await check_alive([node])
    if node.kind == "zombie":
        raise errors.Gone(str(node.path))
    if node.kind in DOUBTFUL:
        raise node.error
    if node.kind == "manager" and or_manager:
        return node
    if node.kind != "component":
        expected = "component or manager" if or_manager else "component"
        raise errors.WrongKind(str(node.path), expected, node.what)
    if path.directory:
        raise errors.WrongKind(str(path), "directory", "component")
    return node


async def on_components(paths, function, or_managers=False):
    """What function(node) returns for the component at each path, in parallel; in order, an errors.Error for
    what failed.

    With `or_managers`, managers are taken as well.
    """
    return await session.each(await components(paths, or_managers), function)


async def components(paths, or_managers=False):
    """The Node of the component at each path, an errors.Error where there is no component; `or_managers` as
    above.
    """
    orb.start()  # its failures are not the failure of a path
    return await session.each(paths, lambda path: component(path, or_managers), at_server)


def at_server(path):
    """Whom a path asks first, its name server, for session.each."""
    return server_endpoint(path), path


# ---- listing ----


async def children(node, objects=()):
    """The nodes in a directory, sorted by name: one call for the names, one to the name server for each
    object, but for those in `objects`, {path as text: Node}.

    Nobody but the name server is asked (use `check_alive` on the result). At the root: the name servers. In a
    manager: its slaves and components, which have to be asked for their names. Raises WrongKind for what is
    no directory, and Unreachable.
    """
    if node.kind == "root":
        return _sorted(name_server(address) for address in servers())
    if node.kind == "manager":
        return _sorted(await slaves(node) + await managed(node))
    if node.kind not in ("server", "directory"):
        raise errors.WrongKind(str(node.path), "directory", node.what)
    context = node.typed
    server = node.endpoint
    names = await bound(node)
    nodes = []
    if objects:
        above = str(node.path)
        known_nodes = {entry: objects.get(f"{above}/{entry[0]}") for entry in names}
        nodes = [node for node in known_nodes.values() if node is not None]
        names = [entry for entry in names if known_nodes[entry] is None]
    while names:
        batch = [(context, node.path.child(name), is_context) for name, is_context in names[-AT_ONCE:]]
        names = names[:-AT_ONCE]
        for child in await session.each(batch, _child, lambda item: (server, item[1])):
            if isinstance(child, Node):
                nodes.append(child)
            elif not isinstance(child, errors.Refused):  # unbound since the list was made
                raise child
    return sorted(nodes, key=lambda node: str(node.path.names[-1]))  # what is above is the same


async def _child(entry):
    """The Node that an entry of a naming context, (context, path, whether it is a context itself),
    is bound to.
    """
    context, path, is_context = entry
    try:
        ref = await orb.call(path, context, "resolve", orb.naming_name(path.names[-1:]))
        return classified(path, ref, is_context)
    except errors.Garbled as e:  # the others are listed all the same
        return unusable(path, e)


def _sorted(nodes):
    return sorted(nodes, key=lambda node: str(node.path))


# ---- below a manager ----


async def slaves(node):
    """Nodes of a manager's slaves. Those of one name get their instance names, or process ids:
    manager_4711.
    """
    try:
        refs = [ref for ref in await node.call("get_slave_managers") if ref is not None]
    except errors.Refused as e:
        if e.name == "BAD_OPERATION":  # managers of RtORB have no slaves
            return []
        raise
    asked = [Node(node.path.child(Name(f"slave{i}", "")), "manager", ref) for i, ref in enumerate(refs)]
    answers = await session.each(asked, _manager_profile)
    nodes = []
    for slave, answer, name in zip(asked, answers, _distinct_names(answers)):
        if isinstance(answer, errors.Error):
            nodes.append(await classify_answer(slave, answer))
        else:
            nodes.append(Node(node.path.child(Name(name, "")), "manager", slave.ref))
    return nodes


async def _manager_profile(node):
    return dict(orb.properties((await node.call("get_profile")).properties))


def _distinct_names(profiles):
    """A name for each slave. A dead one has none of its own."""
    profiles = [{} if isinstance(profile, errors.Error) else profile for profile in profiles]
    names = [profile.get("name") or f"slave{i}" for i, profile in enumerate(profiles)]
    for key, form in (("instance_name", "{1}"), ("pid", "{0}_{1}")):
        distinct = []
        for name, profile in zip(names, profiles):
            if names.count(name) > 1 and profile.get(key):
                name = form.format(name, profile[key])
            distinct.append(name)
        names = distinct
    return [f"{name}_{i}" if name in names[:i] else name for i, name in enumerate(names)]


async def managed(node):
    """Nodes of a manager's components; a master lists those of its slaves, too."""
    refs = [ref for ref in await node.call("get_components") if ref is not None]
    names = [Name(f"unknown{i}", "rtc") for i in range(len(refs))]
    asked = [Node(node.path.child(name), "component", ref) for name, ref in zip(names, refs)]
    names = await session.each(asked, _instance_name)
    nodes = []
    for child, name in zip(asked, names):
        if isinstance(name, errors.Error):  # dead or silent: it cannot give its name
            nodes.append(await classify_answer(child, name))
        else:
            nodes.append(Node(node.path.child(Name(name, "rtc")), "component", child.ref))
    return nodes


async def _instance_name(node):
    return from_wire(await node.call("get_sdo_id"))


# ---- walking ----


async def walk(node, depth=None, managers=True, objects=()):
    """A list of `node` and everything below it, depth first, sorted.

    A naming context or manager that is bound by several names is entered by the first of them in this order;
    by the others it is listed with that Path as its `alias`. At most `depth` levels (None: DEPTH) are
    entered, managers unless `managers` is False, and the contexts of other name servers where they are bound.
    A directory that cannot be listed has its `error` set, a manager that does not answer is `zombie` or
    `silent`. Components are not asked whether they live. `objects` as in `children`, below one name server.
    What exceeds a _Limit is left out, which is reported.
    """
    depth = DEPTH if depth is None else min(depth, DEPTH)
    if node.kind != "root":
        return await _walk(node, depth, managers, aliases.Known(), objects)
    below = await walk_servers(await children(node), depth - 1, managers) if depth else []
    return [node] + below


async def walk_servers(servers, depth=DEPTH, managers=True):
    """`walk` several name servers, Nodes, in parallel, as some may be silent;
    what two of them share is an alias in the second.
    """
    parts = await session.each(
        servers, lambda server: _walk(server, depth, managers, aliases.Known(servers)),
        lambda server: (server.endpoint, str(server.path)),
    )
    entered = aliases.Known(servers)
    nodes = []
    for server, part in zip(servers, parts):
        if isinstance(part, errors.Error):
            server.error = part
            part = [server]
        hidden = None
        for node in part:
            if hidden is not None and node.path.names[: len(hidden)] == hidden:
                continue
            hidden = None
            if node.kind in ("directory", "manager") and node.path.names:
                node.alias = await entered.path(node) or node.alias
                if node.alias:
                    hidden = node.path.names
                elif len(node.path.names) < depth:
                    entered.enter(node)
            nodes.append(node)
    return nodes


class _Limit:
    """What is taken in a walk below the Node `top`."""

    def __init__(self, top):
        here = session.current()
        self._where = str(top.path)
        self._places = here.endless
        self._seconds = WALK * here.timeout
        is_endless = self._where in here.endless
        self._names = FEW_WALKED if is_endless else MOST_WALKED
        self._until = SHORT_WALK * here.timeout if is_endless else self._seconds
        self._characters = MOST_WRITTEN

    def takes(self, node):
        """Count a Node; False where it exceeds the limit."""
        self._names -= 1
        # not spelt: that takes most of the time of a walk
        self._characters -= sum([len(name.id) + len(name.kind) + 2 for name in node.path.names])
        return self._names >= 0 and self._characters >= 0

    async def pass_by(self):
        """Return False when there is no time left."""
        await loop.sleep(self._until)
        return False

    def report(self):
        """Report that it was reached."""
        self._places.add(self._where)
        notes.left_out(
            f"{self._where}: more is below it than is taken ({MOST_WALKED} names, {MOST_WRITTEN >> 20} MB of "
            f"paths, {self._seconds:g} s); the rest is left out"
        )


async def _walk(node, depth, managers, entered, objects=()):
    limit = _Limit(node)
    nodes = []
    entering = _enter(node, depth, managers, entered, objects, limit, nodes, {})
    if not await loop.race(entering, limit.pass_by()):
        limit.report()
    return nodes or [node]


async def _enter(node, depth, managers, entered, objects, limit, nodes, listed):
    """Append a Node, and all below it, to the list `nodes`; False where the limit was reached. `listed`:
    {Node of a manager: its children}, as far as they have been asked for.
    """
    if not limit.takes(node):
        return False
    if node.kind == "unsure" and not node.path.names:
        (node,) = await check_alive([node])
    if node.kind in ("directory", "manager") and node.path.names:
        node.alias = await entered.path(node)
    nodes.append(node)
    if node.kind not in DIRECTORIES or node.alias is not None or depth <= 0:
        return True
    entered.enter(node)
    below = []
    if managers or not node.path.names or node.kind != "manager":
        below = listed[node] if node in listed else await _below(node, objects)
    listed = await _below_managers(below, entered) if managers and depth > 1 else {}
    for child in below:
        if not await _enter(child, depth - 1, managers, entered, objects, limit, nodes, listed):
            return False
    return True


async def _below(node, objects):
    """The children of a directory; if it cannot be listed, [], and its `error` is set."""
    if node.kind == "manager":
        return await _below_manager(node)
    try:
        return await children(node, objects)
    except errors.Error as e:
        node.error = e
        return []


async def _below_managers(nodes, entered):
    """{Node: its children} of the managers among Nodes that have not been entered. All are asked at the same
    time: one after the other, each that hangs would cost a timeout.
    """
    asked = {}
    for node in nodes:
        if node.kind == "manager" and await entered.path(node) is None:
            asked.setdefault(orb.identity(node.ref), node)
    listed = await loop.each(asked.values(), _below_manager, lambda node: node.endpoint)
    return dict(zip(asked.values(), listed))


async def _below_manager(node):
    """The children of a manager; a live master whose slave does not answer may not answer this."""
    below = None
    try:
        below = await slaves(node)
        return _sorted(below + await managed(node))
    except errors.Error as e:
        node.error = e
        if below is None and not isinstance(e, errors.Refused):
            node.kind = (await classify_answer(node, e)).kind
    return _sorted(below or [])
