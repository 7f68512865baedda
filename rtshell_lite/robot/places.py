"""Where in the RTC Tree a reference is bound, and so whose the far ends of connections are:
found by comparing references.
"""


from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.net import loop
from rtshell_lite.path import Name
from rtshell_lite.records import record
from rtshell_lite.robot import ports, tree
from rtshell_lite.text import printable

PATIENCE = 2  # times the timeout, in which all far ends have to answer


class Places:
    """Finds the paths of components: beside a known one, else in its name server, else in all others."""

    def __init__(self):
        self._everywhere = None  # by identity: the Paths where that component is bound, once all are known

    async def path(self, instance, ref, near):
        """The Path where the component `ref` with this instance name is bound, or None;
        `near` is the Node of one that knows it.
        """
        beside = near.path.parent().child(Name(instance, "rtc"))
        if self._everywhere is None:
            if await self._is_bound(beside, ref):
                return beside
            self._everywhere = await self._walk(beside.server)
        paths = self._everywhere.get(orb.identity(ref), [None])
        return beside if beside in paths else paths[0]

    async def _is_bound(self, path, ref):
        try:
            return orb.same((await tree.resolve(path)).ref, ref)
        except errors.Error:
            return False

    async def _walk(self, server):
        paths = {}  # type: dict
        for node in await tree.walk_servers(await tree.known_servers(server), managers=False):
            if node.kind == "component" and node.ref is not None:
                paths.setdefault(orb.identity(node.ref), []).append(node.path)
        return paths


# ---- the far ends of connections ----

# The port at an end of a connection: its reference; its ports.Port, whose `node` is None if its component is
# bound nowhere, or None and the errors.Error `error`.
End = record("End", "ref port error")


async def far_ends(near, silent=None):
    """{identity of a port: End} of all ports that the Ports `near` are connected with, except these
    themselves.

    They are asked, one call each (see `ask`), unless their processes are `silent` ({endpoint: errors.Error}).
    Whose they are is found by comparing their owners with what is bound in the name servers.
    """
    own = {orb.identity(port.ref) for port in near}
    silent = silent or {}
    # by identity: its reference, and the Node of a component that is connected with it
    far = {}  # type: dict
    joining = {}  # type: dict  # by identity: ids of the connectors that lead there
    for port in near:
        for connector in port.connectors:
            for ref in connector.ports:
                if ref is None:
                    continue
                identity = orb.identity(ref)
                if identity not in own:
                    far.setdefault(identity, (ref, port.node))
                    joining.setdefault(identity, set()).add(connector.id)
    asked = [ref for ref, _ in far.values() if orb.endpoint(ref) not in silent]
    answers = await ask(asked, joining)
    places = Places()
    ends = {}
    for identity, (ref, node) in far.items():
        answer = silent.get(orb.endpoint(ref)) or next(answers)
        if isinstance(answer, errors.Error):
            ends[identity] = End(ref, None, answer)
        else:
            ends[identity] = End(ref, await _placed(answer, places, node), None)
    return ends


async def ask(refs, joining):
    """An iterator of the Port of each reference, or an errors.Error; the Node of a Port has an address as its
    path.

    A Port has no other connectors than those whose ids are in joining[its identity], as thousands of ports
    may each have a thousand. Those that cannot be asked in PATIENCE are Late.
    """
    end = loop.now() + PATIENCE * session.current().timeout

    async def one_port(ref):
        if loop.now() > end:
            raise errors.NoTime(orb.at_address(ref), session.NO_TIME)
        port = await ports.port(tree.Node(orb.at_address(ref), "component", ref), ref)
        ids = joining[orb.identity(ref)]
        joined = {connector.id: connector for connector in reversed(port.connectors) if connector.id in ids}
        return port._replace(connectors=list(joined.values()))

    return iter(await session.each(refs, one_port, orb.at_object))


async def _placed(port, places, near):
    path = port.owner and await places.path(port.name.rpartition(".")[0], port.owner, near)
    return port._replace(node=path and tree.Node(path, "component", port.owner))


async def far_names(near):
    """A function reference → `name` of that end of a connection of the Ports `near`;
    None for one of these.
    """
    ends = await far_ends(near)

    def name_of(ref):
        if ref is None:
            return "Unknown (nil)"
        end = ends.get(orb.identity(ref))
        return end and name(end)

    return name_of


def name(end):
    """The path of the port at an End, as text;
    `Unknown (…)` for one that does not answer or is bound nowhere.
    """
    if end.port is None:
        return f"Unknown ({end.error})"
    if end.port.node is not None:
        return ports.label(end.port)
    if end.port.owner is not None:
        return f"Unknown ({printable(end.port.name)})"
    return printable(end.port.name)
