"""Deleting names from name servers (CosNaming::NamingContext):
unbind and destroy, and what must never be deleted by mistake.
"""

from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.path import REFERENCES, Path
from rtshell_lite.robot import aliases, tree
from rtshell_lite.text import counted, printable, shell_word

WHY_LEFT = "refuses: dead, or a firewall closes this port; on that host: rtdoctor, rtdel -z; here: rtdel -zf"
WHY_DOUBTED = (
    "what answers at its address here may be another host than there; where it runs: rtdoctor, rtdel -z; "
    "here: rtdel -zf"
)


async def delete(path, note, recursive=False, dry_run=False):
    """Unbind what `path` names; yields a line (see `cli.report`) for each name, deepest first.

    note       called with a line on each naming context that has another name, and loses only this one
    recursive  delete a naming context with all that is below it; otherwise only an empty one
    Raises what `tree.resolve` raises, WrongKind, Refused.
    """
    node, above = await _named(path)
    if node.kind == "directory":
        deletion = _Deletion(await _Bindings().walk(path), recursive, dry_run, note)
        async for line in deletion.lines(above, node):
            yield line
    else:
        yield await _unbind(node.path, dry_run)


async def _named(path):
    """The Node that a Path names, and that of the directory above it. Raises what `tree.resolve` raises, and
    WrongKind for what has no name in a name server.
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
        kind = "manager; rtmgr deletes its components"
        raise errors.WrongKind(str(path.parent()), "directory with names in it", kind)
    return node, above


async def living(path):
    """The Node of the component or manager at a Path if it answers, so that it would live on without its
    name; else None.
    """
    try:
        (node,) = await tree.check_alive([await tree.resolve(path)])
    except errors.Error:
        return None
    return node if node.kind in ("component", "manager") else None


async def zombies(top):
    """What is or may be a zombie at and below the Node `top`, federated name servers aside:
    (Nodes, Nodes whose listing failed).
    """
    nodes = await aliases.within(await tree.walk(top, managers=False))
    looked_at = await tree.check_alive(nodes)
    dead = [node for node in looked_at if node.kind == "zombie" or isinstance(node.error, errors.MaybeGone)]
    return dead, [node for node in nodes if node.error is not None]


async def delete_zombie(path, dry_run=False, force=False):
    """Unbind the zombie at a Path, after two looks at it: it may have been started again under its name. A
    line, '' where it has gone meanwhile.

    force  what refuses a connection is a zombie, even if a firewall may refuse
    Raises what `tree.resolve` raises, WrongKind, Silent and the like, LeftAlone for what may live on another
    host.
    """
    node, _ = await _named(path)
    await _dead(node, force)
    try:
        node = await tree.resolve(path)
    except errors.NotFound:
        return ""
    return await _unbind((await _dead(node, force)).path, dry_run, zombie=True)


async def _dead(node, force):
    """Look at a node that should be a zombie and return it.
    Raises WrongKind, Silent if it does not answer, LeftAlone.
    """
    (node,) = await tree.check_alive([node])
    refuses = isinstance(node.error, errors.MaybeGone)
    if refuses and force:
        return node
    if (refuses or node.kind == "zombie" and not force) and not await orb.is_near(node.path, node.ref):
        raise errors.LeftAlone(str(node.path), WHY_DOUBTED)
    if refuses:
        raise errors.LeftAlone(str(node.path), WHY_LEFT)
    if node.kind in tree.DOUBTFUL:
        raise node.error
    if node.kind != "zombie":
        raise errors.WrongKind(str(node.path), "zombie", node.what)
    return node


async def _unbind(path, dry_run, zombie=False):
    if dry_run:
        return f"{'rtdel -z' if zombie else 'rtdel'} {shell_word(str(path))}"
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
        known_paths = {}  # type: dict  # Path of a directory: the Path by which it is known
        endless = session.current().endless
        before = set(endless)
        for node in await tree.walk_servers(await tree.known_servers(path.server), managers=False):
            if node.kind not in ("server", "directory"):
                continue
            known_path = await self.known.path(node) or known_paths.get(node.alias)
            if known_path is None:
                self.known.enter(node)
                known_path = node.path
            known_paths[node.path] = known_path
            if node.kind == "server":
                self._roots.add(known_path)
            else:
                above = known_paths[node.path.parent()]
                self._names[above, node.path.names[-1]] = known_path, node.path
        if endless - before or str(Path(path.server, (), None, False)) in endless:
            raise errors.Failed(str(path), "not deleted: its other names are not known, as not all is listed")
        above = await tree.resolve(path.parent())
        self._without((await self.known.path(above), path.names[-1]))
        return self

    def _without(self, gone):
        """Find what can be reached without the name `gone`, a pair (Path of the directory, Name)."""
        todo = [(root, root) for root in self._roots]
        below = {}  # type: dict
        for (above, name), (inner, _) in self._names.items():
            if (above, name) != gone:
                below.setdefault(above, []).append((inner, name))
        while todo:
            path, leads = todo.pop(0)
            if path not in self._left:
                self._left[path] = leads
                todo += [(inner, leads.child(name)) for inner, name in below.get(path, ())]

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
        self._left = tree.MOST_WALKED  # directories that are entered: new ones may come without end

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
        self._left -= 1
        if self._left < 0:
            raise errors.Failed(str(node.path), f"more than {tree.MOST_WALKED} directories are below it")
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
