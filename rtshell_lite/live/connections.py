"""The ports and connections of components as events, asked for again and again, for who records what they
send.

Observers of ports would report them, but the process of such an observer must not end before the component
has let it go: C++ 2.1 hangs for good if it drops connections then, and those that a recorder reads by are
dropped as soon as it is killed. Protocol rule 5.4.
"""


from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.live import times
from rtshell_lite.net import loop
from rtshell_lite.robot import ports

MOST = 100  # ports that are asked in a second


async def follow(components, put):
    """Look again and again, until it is cancelled. `components`: a dict that grows and changes, {path as
    text: (Node, its Ports)}. put(path as text, subject, event) is called for what has changed: the name of a
    port, and PORT_CONNECT, PORT_DISCONNECT, PORT_ADD or PORT_REMOVE.
    """
    followed = {}  # type: dict
    while True:
        count = sum(len(each.ports) for each in followed.values())
        await loop.sleep(max(times.PORTS, count / MOST))
        for where, (node, listed) in components.items():
            if where not in followed or followed[where].identity != orb.identity(node.ref):
                followed[where] = _Followed(node, listed)
        owners = {each.identity for each in followed.values()}

        async def report(each):
            await each.report_changes(owners, put)

        await session.each(list(followed.values()), report)


class _Followed:
    """One component."""

    def __init__(self, node, listed):
        self.node = node
        self.where = str(node.path)
        self.identity = orb.identity(node.ref)
        self.endpoint = node.endpoint
        self.ports = []
        for port in listed:
            self.ports.append(_Port(port.ref))
            self.ports[-1].describe(port)

    async def report_changes(self, owners, put):
        """Call put, as in `follow`, for what has changed since the last look. `owners`: identities of the
        components that are followed; a composite shows ports of its members, too. Raises what calls raise.
        """
        await self._list_ports(put)
        for port in self.ports:
            is_of_member = port.owner != self.identity and port.owner in owners
            if is_of_member or loop.now() < port.patience.until:
                continue
            if session.current().silence(self.node.endpoint):
                return
            try:
                events = await port.changes(self.node)
            except errors.Unanswered:
                port.patience.wait()
                continue
            except errors.Error:
                continue  # it may be gone: the next list shows that
            for event in events:
                put(self.where, port.name, event)

    async def _list_ports(self, put):
        known = {port.identity: port for port in self.ports}
        listed = []
        for ref in await ports.refs(self.node):
            port = known.pop(orb.identity(ref), None)
            listed.append(port or _Port(ref))
        for port in known.values():
            if port.name is not None:
                put(self.where, port.name, "PORT_REMOVE")
        self.ports = listed


class _Port:
    """One port, and its connections as they were last seen."""

    def __init__(self, ref):
        self.identity = orb.identity(ref)
        self.name = None  # until it is described
        self.owner = None  # the identity of its component, where that is known
        self.patience = times.Patience()
        self._ref = ref
        self._seen = {}  # type: dict

    def describe(self, port):
        """Take what a ports.Port says."""
        self.name = port.name
        if port.owner is not None:
            self.owner = orb.identity(port.owner)
        self._seen = _seen(port.connectors)

    async def changes(self, node):
        """The events since the last look; `node`: its component. Raises what calls raise."""
        if self.name is None:
            self.describe(await ports.port(node, self._ref))
            return ["PORT_ADD"]
        profiles = await orb.call(node.path, self._ref, "get_connector_profiles")
        now = _seen([ports.connector(profile, node.path) for profile in profiles[: ports.MOST_PARTS]])
        before = self._seen
        self._seen = now
        self.patience.end()
        lost = [connector_id for connector_id in before if now.get(connector_id) != before[connector_id]]
        made = [connector_id for connector_id in now if now[connector_id] != before.get(connector_id)]
        return len(lost) * ["PORT_DISCONNECT"] + len(made) * ["PORT_CONNECT"]


def _seen(connectors):
    """{id of a connector: what differs where it is made again under that id}: its ends, and the references
    of what was made to carry its data. Those of tools are no part of the system.
    """
    seen = {}
    for connector in connectors:
        if not ports.is_of_tool(connector):
            ends = [orb.identity(end) for end in connector.ports if end is not None]
            carriers = [value for _, value in connector.properties if value.startswith("IOR:")]
            seen[connector.id] = ends, carriers
    return seen
