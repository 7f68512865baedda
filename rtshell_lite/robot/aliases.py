"""Directories bound by several names: naming contexts and managers, recognised by their references."""

from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.net import loop
from rtshell_lite.text import printable

ROOT_KEY = b"NameService"  # object key of the root of every name server


class Known:
    """The first Path of each naming context and manager that a walk has entered."""

    def __init__(self, nodes=()):
        self._entered = {}  # (TCP port, object key): [(host, Path)]
        for node in nodes:
            self.enter(node)

    async def path(self, node):
        """The Path by which the object of a Node was entered, or None."""
        host, port, key = orb.identity(node.ref)
        for known_host, path in self._entered.get((port, key), ()):
            if await same_host(host, known_host):
                return path
        return None

    def enter(self, node):
        """Remember a Node; a reference without an IIOP address has no identity, and is not remembered."""
        host, port, key = orb.identity(node.ref)
        if key:
            self._entered.setdefault((port, key), []).append((host, node.path))


async def within(nodes):
    """The Nodes of a walk except those below a naming context of another name server;
    such a context is marked `foreign`.
    """
    directories = {}
    away = None
    own_nodes = []
    for node in nodes:
        if away is not None and node.path.server == away.server:
            if node.path.names[: len(away.names)] == away.names:
                continue
        away = None
        if node.kind in ("server", "directory"):
            directories[node.path] = node
            above = directories.get(node.path.parent())
            if above is not None and await is_foreign(above, node):
                node.foreign = True
                away = node.path
        own_nodes.append(node)
    return own_nodes


async def is_foreign(above, node):
    """True when the naming context `node` belongs to another name server than the one `above` in which it is
    bound.

    Costs a call where a server is addressed otherwise than it publishes itself. A root is always foreign.
    """
    host, port, _ = orb.identity(above.ref)
    own_host, own_port, key = orb.identity(node.ref)
    if key == ROOT_KEY or port != own_port:
        return True
    if await same_host(host, own_host):
        return False
    try:  # keys of contexts are made of times and random numbers: only the server that made one knows it
        return not await orb.call(
            node.path, orb.reference_at(node.ref, host, port), "_is_a",
            "IDL:omg.org/CosNaming/NamingContext:1.0",
        )
    except errors.Error:
        return True


async def same_host(host, other):
    """True when two host names or addresses have an IP address in common."""
    if host == other:
        return True
    own = await _addresses(host)
    return not own.isdisjoint(await _addresses(other))


async def _addresses(host):
    try:
        return set(await resolve(host))
    except errors.Error:
        return set()


async def resolve(host):
    """The IP addresses of a host name, as text. Raises Unreachable when it has none, or the look-up takes too
    long.

    The system's resolver has no deadline, and omniORB's own limits do not cover it.
    """

    world = loop.world()

    def look_up():
        try:
            resolved = world.resolve(host)
        except (OSError, UnicodeError) as e:
            raise errors.Unreachable(printable(host), getattr(e, "strerror", None) or "not a host name")
        return list(dict.fromkeys(info[4][0] for info in resolved))

    return await session.on_thread(printable(host), look_up)
