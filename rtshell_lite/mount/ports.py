"""The files of ports in a mounted RTC Tree, and connections as links."""

import collections
import posixpath
import stat

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.mount.nodes import Absent, Directory, Items, Link, Text, line, link_text, meant, unique
from rtshell_lite.mount.services import InterfacesDirectory
from rtshell_lite.robot import connectors, places, ports

# A connection of a port, as seen from one of its ends: the Connector, and the reference of one of the other
# ends.
Far = collections.namedtuple("Far", "connector ref")


class PortsDirectory(Directory):
    """The ports of a component; `source` gives the Snapshot with them."""

    __slots__ = ()

    def named(self, snapshot):
        """{file name: Port}"""
        for _, error, _ in snapshot.refusing:
            self.mount.complain(str(error))
        instance = snapshot.node.path.names[-1].id
        return dict(
            zip(unique(ports.short_name(port.name, instance) for port in snapshot.ports), snapshot.ports)
        )

    def entries(self, snapshot):
        return {name: (PortDirectory,) for name in self.named(snapshot)}


class PortDirectory(Directory):
    """One port."""

    __slots__ = ("stream",)

    def __init__(self, above, name):
        super().__init__(above, name, above.source)
        self.stream = None

    def port(self, snapshot):
        """Its ports.Port. Raises Absent."""
        return self.own(self.above.named(snapshot))

    async def fresh(self):
        """Its Port as it is now."""
        self.source.expire()
        return self.port(await self.source.get())

    def entries(self, snapshot):
        port = self.port(snapshot)
        entries = {"type": (Text, self.source, lambda snapshot: line(self.port(snapshot).type))}
        if port.type in ports.DATA:
            entries["data_type"] = (
                Text, self.source,
                lambda snapshot: line(self.port(snapshot).properties.get("dataport.data_type", "")),
            )
        else:
            entries["interfaces"] = (InterfacesDirectory, self.source)
        entries["properties"] = (Items, self.source, lambda snapshot: self.port(snapshot).properties.items())
        entries["connections"] = (ConnectionsDirectory,)
        return entries

    def hidden(self, snapshot):
        from rtshell_lite.mount.streams import PortStream, Sending  # with all that sends and receives data

        kind = self.port(snapshot).type
        if kind == "DataInPort":
            return {"value": (Sending,)}
        if kind == "DataOutPort":
            return {"value": (PortStream, 1), "values": (PortStream, None)}
        return {}


class ConnectionsDirectory(Directory):
    """The connections of a port: a link to each other end."""

    __slots__ = ("far",)
    mode = stat.S_IFDIR | 0o755

    def __init__(self, above, name):
        super().__init__(above, name, above.source)
        self.far = self.mount.answer(self.peer, self._far)

    async def _far(self):
        """{file name: text of the link}"""
        snapshot = await self.source.get()
        ends = await places.far_ends([self.above.port(snapshot)])

        def text(far):
            if len(far.connector.ports) == 1:
                return ports.transport(far.connector)
            end = far.ref is not None and ends.get(orb.identity(far.ref))
            return link_text(places.name(end) if end else "Unknown (nil)", self)

        return {name: text(far) for name, far in self.named(snapshot).items()}

    def named(self, snapshot):
        """{file name: Far}"""
        port = self.above.port(snapshot)
        ends = [
            Far(connector, ref)
            for connector in port.connectors
            for ref in connector.ports
            if ref is None or not orb.same(ref, port.ref)
        ]
        ends += [
            Far(connector, None)
            for connector in port.connectors
            if len(connector.ports) == 1 and not ports.is_of_tool(connector)
        ]
        return dict(zip(unique(end.connector.name for end in ends), ends))

    def entries(self, snapshot):
        return {name: (ConnectionLink,) for name in self.named(snapshot)}

    async def make_link(self, name, target):
        where = posixpath.join(self.where, name)
        other = await _walk(self, target, where)
        if not isinstance(other, PortDirectory):
            raise errors.BadValue(
                where,
                f"{line(target).strip()} is not a port of this mount; a link's target starts at the link",
            )
        await connectors.connect([await self.above.fresh(), await other.fresh()], meant(name, where))
        return self.child(name, (ConnectionLink,))

    async def disconnect(self, name):
        """Remove the connection of this file name."""
        port = await self.above.fresh()
        end = self.named(await self.source.get()).get(name)
        if end is None:
            raise Absent(posixpath.join(self.where, name))
        await connectors.disconnect(port, end.connector)


class ConnectionLink(Link):
    """A link to the port at another end of a connection."""

    __slots__ = ()

    def __init__(self, above, name):
        super().__init__(above, name, None)

    def renew(self, *arguments):
        pass

    async def target(self):
        return self.own(await self.above.far.get())

    async def remove(self):
        await self.above.disconnect(self.name)


async def _walk(start, target, where):
    """The node that the target of a link in the directory `start` leads to. Raises Absent."""
    mount = start.mount
    path = posixpath.normpath(posixpath.join(start.where, target))
    if not path.startswith(mount.directory + "/"):
        raise errors.BadValue(where, f"{line(target).strip()} leads out of the mount at {mount.directory}")
    node = start
    while node.above is not None:
        node = node.above
    for name in path[len(mount.directory) + 1 :].split("/"):
        if not isinstance(node, Directory):
            raise Absent(path)
        node = await node.find(name)
    return node
