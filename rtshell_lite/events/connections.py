"""The connections of components as events, asked for again and again, for who records what they send.

Observers of ports would report them, but the process of such an observer must not end before the component
has let it go: C++ 2.1 hangs for good if it drops connections then, and those that a recorder reads by are
dropped as soon as it is killed. Protocol rule 5.4.
"""

import time

from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.net import loop
from rtshell_lite.robot import ports
from rtshell_lite.text import from_wire

LOOK = 2.0  # seconds between two looks; more where there are many ports
MOST = 100  # ports that are asked in a second


async def follow(components, put):
    """Look again and again, until it is cancelled. `components`: a dict that grows and changes, {path as
    text: (Node, its Ports)}. put(path as text, subject, event) is called with what has changed: the name
    of a port, and PORT_CONNECT or PORT_DISCONNECT.
    """
    followed = {}  # type: dict
    shown = {}  # type: dict  # {identity of a port: where}: a composite shows those of its members, too
    while True:
        await loop.sleep(max(LOOK, sum(len(each.ports) for each in followed.values()) / MOST))
        for where, (node, listed) in components.items():
            if where not in followed or followed[where].node is not node:
                own = [port for port in listed if shown.setdefault(orb.identity(port.ref), where) == where]
                followed[where] = _Followed(node, own)
        now = time.monotonic()
        due = [each for each in followed.values() if now >= each.due]

        async def look(each):
            await each.look(put)

        for each, failure in zip(due, await session.each(due, look, lambda each: each.place)):
            each.note(failure)


class _Followed:
    """The ports of one component, and their connections as they were last seen; in ports are not asked, as
    the far ends have the same.
    """

    def __init__(self, node, listed):
        self.node = node
        self.where = str(node.path)
        self.place = node.endpoint, self.where
        self.due = 0.0  # when it may be asked again
        self._pause = LOOK
        self.ports = [port for port in listed if port.type != "DataInPort"]
        # for each port {id of a connector: whether it is a tool's, which are no part of the system}
        self._seen = [_known(port.connectors) for port in self.ports]

    def note(self, failure):
        """Take what ended a look. What did not answer has more and more time: a question may wait there as
        long as a far end hangs, and hold a thread.
        """
        if isinstance(failure, errors.Silent):
            self._pause *= 2
            self.due = time.monotonic() + self._pause
        else:
            self._pause = LOOK

    async def look(self, put):
        """Call put, as in `follow`, for what has changed since the last look. Raises what calls raise."""
        for place, port in enumerate(self.ports):
            before = self._seen[place]
            profiles = await orb.call(self.where, port.ref, "get_connector_profiles")
            self._seen[place] = now = {}
            for profile in profiles[: ports.MOST_PARTS]:
                connector_id = from_wire(profile.connector_id)
                if connector_id in before:
                    now[connector_id] = before[connector_id]
                else:
                    now.update(_known([ports.connector(profile, self.node.path)]))
            for _ in _system(before) - _system(now):
                put(self.where, port.name, "PORT_DISCONNECT")
            for _ in _system(now) - _system(before):
                put(self.where, port.name, "PORT_CONNECT")


def _known(connectors):
    return {connector.id: ports.is_of_tool(connector) for connector in connectors}


def _system(seen):
    return {connector_id for connector_id, of_tool in seen.items() if not of_tool}
