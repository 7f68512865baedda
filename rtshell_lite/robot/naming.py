"""Deleting names from name servers (CosNaming::NamingContext):
unbind and destroy, and what must never be deleted by mistake.
"""

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.path import REFERENCES, Path
from rtshell_lite.robot import aliases, tree
from rtshell_lite.text import counted, printable, shell_word

MOST_WITNESSES = 8  # objects that are asked to find out whether a host lives
WHY_LEFT = (
    "its host refuses the connection, as a firewall would, and no other process there answers; "
    "netstat -ltnp | grep :%d there shows whether its process runs; -f deletes the name all the same"
)


async def delete(path, note, zombie_only=False, recursive=False, dry_run=False, force=False):
    """Unbind what `path` names; yields a line (see `cli.report`) for each name, deepest first.

    note         called with a line on each naming context that has another name, and loses only this one
    zombie_only  refuse all but zombies, each verified twice
    recursive    delete a naming context with all that is below it; otherwise only an empty one
    force        with zombie_only: what refuses a connection is a zombie, even if a firewall may refuse
    Raises what `tree.resolve` raises, WrongKind, Refused, LeftAlone for what may live behind a firewall.
    """
    if path.port is not None or not path.names:
        if path.port is not None:
            kind = "port"
        elif path.server and path.server.startswith(REFERENCES):
            kind = "reference, which has no name"
        elif path.server:
            kind = "name server"
        else:
            kind = "root directory"
        raise errors.WrongKind(str(path), "name that can be deleted", kind)
    node = await tree.resolve(path)
    above = await tree.resolve(path.parent())
    if above.kind == "manager":
        raise errors.WrongKind(
            str(path.parent()), "directory with names in it", "manager; rtmgr deletes its components"
        )
    if zombie_only:
        yield await _delete_zombie(await _dead(node, force), dry_run, force)
    elif node.kind == "directory":
        deletion = _Deletion(await _Bindings().walk(path), recursive, dry_run, note)
        async for line in deletion.lines(above, node):
            yield line
    else:
        yield await _unbind(node.path, dry_run)


async def living(path):
    """The Node of the component or manager at a Path if it answers, so that it would live on without its
    name; else None.
    """
    try:
        (node,) = await tree.check_alive([await tree.resolve(path)])
    except errors.Error:
        return None
    if node.kind in ("component", "manager"):
        return node
    return None


async def zombies(top):
    """What is or may be a zombie at and below the Node `top`, federated name servers aside:
    (Nodes, Nodes whose listing failed).
    """
    nodes = await aliases.within(await tree.walk(top, managers=False))
    found = [
        node
        for node in await tree.check_alive(nodes)
        if node.kind == "zombie" or isinstance(node.error, errors.MaybeGone)
    ]
    return found, [node for node in nodes if node.error is not None]


async def delete_zombies(nodes, dry_run=False, force=False):
    """Delete each of these zombies: a line, '' for one that lives after all, or an errors.Error;
    for `force` see `delete`.
    """
    results = []
    for node in nodes:
        try:
            results.append(await _delete_zombie(node, dry_run, force))
        except errors.WrongKind:
            results.append("")
        except errors.Error as e:
            results.append(e)
    return results


async def _delete_zombie(node, dry_run, force):
    """Delete a zombie after a second look: the component may have been started again under its name."""
    try:
        again = await tree.resolve(node.path)
    except errors.NotFound:
        return ""
    return await _unbind((await _dead(again, force)).path, dry_run, zombie=True)


async def _dead(node, force):
    """Look at a node that should be a zombie and return it.
    Raises WrongKind, Silent if it does not answer, LeftAlone.
    """
    (node,) = await tree.check_alive([node])
    if isinstance(node.error, errors.MaybeGone) and not force:
        node = await _with_witnesses(node)
    if isinstance(node.error, errors.MaybeGone):
        if force:
            return node
        raise errors.LeftAlone(str(node.path), WHY_LEFT % node.endpoint[1])
    if node.kind == "silent":
        raise node.error
    if node.kind != "zombie":
        raise errors.WrongKind(str(node.path), "zombie", node.what)
    return node


async def _with_witnesses(node):
    """Look at a Node again after others of its host that are bound beside it:
    if one of them answers, it is known to be gone.
    """
    beside = [
        other
        for other in await tree.children(await tree.resolve(node.path.parent()))
        if other.ref is not None and other.endpoint[0] == node.endpoint[0] and other.endpoint != node.endpoint
    ]
    await tree.check_alive(beside[:MOST_WITNESSES])
    (node,) = await tree.check_alive([await tree.resolve(node.path)])
    return node


async def _unbind(path, dry_run, zombie=False):
    if dry_run and zombie:
        return f"rtdel -z {shell_word(str(path))}"
    if dry_run:
        return f"rtdel {shell_word(str(path))}"
    server = await tree.resolve(Path(path.server, (), None, False))
    try:
        await server.call("unbind", orb.naming_name(path.names))
    except errors.Refused as e:
        if e.name == "NotFound":
            raise errors.NotFound(str(path))
        raise
    return str(path) + ": deleted"


# ---- naming contexts ----


class _Bindings:
    """The names by which the naming contexts of all name servers can be reached,
    and which can without one of the names.
    """

    def __init__(self):
        self.known = aliases.Known()
        self._names = {}
        self._roots = set()
        self._left = {}  # {Path of a directory: a path that leads there} without one of the names

    async def walk(self, path):
        """Walk the name server of `path`, the naming context to delete, and those of RTCTREE_NAMESERVERS;
        returns self.
        """
        places = {}  # type: dict  # Path of a directory: the Path by which it is known
        for node in await tree.walk_servers(await tree.known_servers(path.server), managers=False):
            if node.kind not in ("server", "directory"):
                continue
            place = await self.known.path(node) or places.get(node.alias)
            if place is None:
                self.known.enter(node)
                place = node.path
            places[node.path] = place
            if node.kind == "server":
                self._roots.add(place)
            else:
                self._bind(places, node, place)
        above = await tree.resolve(path.parent())
        self._without((await self.known.path(above), path.names[-1]))
        return self

    def _bind(self, places, node, place):
        above = places[node.path.parent()]
        self._names[above, node.path.names[-1]] = place, node.path

    def _without(self, gone):
        """Find what can be reached without the name `gone`, a pair (Path of the directory, Name)."""
        todo = [(root, root) for root in self._roots]
        below = {}  # type: dict
        for (above, name), (place, _) in self._names.items():
            if (above, name) != gone:
                below.setdefault(above, []).append((place, name))
        while todo:
            place, leads = todo.pop(0)
            if place not in self._left:
                self._left[place] = leads
                todo += [(inner, leads.child(name)) for inner, name in below.get(place, ())]

    async def other_path(self, node):
        """A Path by which a naming context can still be reached, or None."""
        return self._left.get(await self.known.path(node))


class _Deletion:
    """The deletion of a naming context; for `note` see `delete`."""

    def __init__(self, bindings, recursive, dry_run, note):
        self.recursive = recursive
        self.dry_run = dry_run
        self.note = note
        self.bindings = bindings
        self._entered = aliases.Known()

    async def lines(self, above, node):
        """Delete the naming context `node`, bound in `above`, after what is below it; yields a line for each
        name.

        One that has another name, belongs to another name server or is bound inside itself loses only this
        name.
        """
        if len(node.path.names) > tree.DEPTH:
            raise errors.Failed(str(node.path), f"more than {tree.DEPTH} directories deep")
        if await self._is_alias(above, node) or await self._entered.path(node):
            yield await _unbind(node.path, self.dry_run)
            return
        below = await tree.children(node)
        if below and not self.recursive:
            names = counted(len(below), "name")
            raise errors.Failed(str(node.path), f"not empty ({names}); delete it with --recursive")
        self._entered.enter(node)
        for child in below:
            if child.kind == "directory":
                async for line in self.lines(node, child):
                    yield line
            else:
                yield await _unbind(child.path, self.dry_run)
        if not self.dry_run:
            await _destroy(node)
        yield await _unbind(node.path, self.dry_run)

    async def _is_alias(self, above, node):
        another = await self.bindings.other_path(node)
        if another is None and not await aliases.is_foreign(above, node):
            return False
        if another:
            what = "another name of " + str(another)
        else:
            what = "a directory of the name server at %s:%d" % node.endpoint
        self.note(f"{node.path}: {printable(what)}; only this name is deleted")
        return True


async def _destroy(node):
    """Destroy an empty context. The server refuses when a name has been bound in it since,
    which stops the deletion.
    """
    try:
        await node.call("destroy")
    except errors.Refused as e:
        if e.name == "NotEmpty":
            raise errors.Refused(str(node.path), "not empty any more")
        raise
