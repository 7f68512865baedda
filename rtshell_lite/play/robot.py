"""Components of live.py as a robot: with a name server, names, connections and composites, in this process
and in memory alone.
"""

from rtshell_lite import errors, path
from rtshell_lite.corba import orb
from rtshell_lite.play import bindings, component, nameserver, ports
from rtshell_lite.robot import tree
from rtshell_lite.text import printable

HERE = "127.0.0.1"


class Robot:
    """The components of a robot, `by_name` of the instance; they work in `tasks`, a loop.Group.

    components   {what it is bound as, base.host_cxt/Motor0.rtc: its class, a live.Worker}
    connections  pairs of ports, Motor0:out
    members      {instance name of a composite: those of its members}
    """

    def __init__(self, tasks, types, components, connections=(), members=None):
        self.tasks = tasks
        self.by_name = {}
        self._bound = list(components)
        self._connections = connections
        self._server = None
        for bound, kind in components.items():
            instance = bound.rpartition("/")[2].partition(".")[0]
            if instance in self.by_name:
                raise ValueError(f"two components are named {instance}")
            self.by_name[instance] = kind(instance, types, tasks)
        for name, parts in (members or {}).items():
            self._compose(self.by_name[name], [self.by_name[part] for part in parts])

    @staticmethod
    def _compose(composite, members):
        composite.organisation = component.Organisation(composite)
        composite.organisation.members = members
        (context,) = composite.contexts
        for member in members:
            member.organisations = [composite.organisation]
            member.participating = [context]
            member.contexts[0].running = False
            context.members.append([member, "Inactive"])

    async def listen(self, port=0):
        """Begin a name server at this TCP port, 0 for a free one: its address. Raises Failed where the port
        is taken.
        """
        address = f"{HERE}:{orb.listen(HERE, port)}"
        nameserver.Names(HERE)
        self._server = tree.name_server(address)
        return address

    async def begin(self, is_active=True):
        """Bind and connect all, activate them, and have them work."""
        names = bindings.Bindings(self._server)
        for bound, part in zip(self._bound, self.by_name.values()):
            part.publish(HERE)
            await names.bind(path.parse(f"/{HERE}/{bound}").names, part.reference)
        for ends in self._connections:
            await self._connect(ends)
        for part in self.by_name.values():
            for context in part.contexts:
                if is_active and context.running:
                    context.activate_component(part.reference)
            self.tasks.start(part.work())

    def port(self, name):
        """The port with a name like Motor0:out. Raises NoSuch."""
        owner, _, word = name.partition(":")
        if owner in self.by_name:
            for port in self.by_name[owner].ports:
                if port.name == word:
                    return port
        raise errors.NoSuch("the robot", "port", printable(name))

    async def _connect(self, ends):
        joined = [self.port(end) for end in ends]
        properties = {
            "dataport.dataflow_type": "push", "dataport.interface_type": "corba_cdr",
            "dataport.subscription_type": "new", "dataport.serializer.cdr.endian": "little,big",
            "dataport.data_type": joined[0].properties["dataport.data_type"],
        }
        profile = orb.struct("RTC.ConnectorProfile")(
            "_".join(port.name for port in joined), "", [port.reference for port in joined],
            component.nvlist(properties.items()),
        )
        await joined[0].connect(profile)

    async def end(self):
        await ports.leave(self.by_name.values())
        for part in self.by_name.values():
            part.close()
