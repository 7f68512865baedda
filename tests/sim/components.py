"""Components of a simulated robot: those with which rtshell_lite/play plays recordings, but alive: they
change as they are asked to, and keep what was true of them.
"""

import struct

from rtshell_lite import errors, path
from rtshell_lite.corba import orb, session
from rtshell_lite.net import loop
from rtshell_lite.play import bindings, nameserver, ports
from rtshell_lite.play import component as parts
from rtshell_lite.play.component import code
from rtshell_lite.robot import tree

PATIENT = 1e9  # seconds that a component waits for others, as it knows no deadline
LATER = 0.01  # seconds until a change of state is made, about two periods of a context
PERIOD = 0.05  # seconds between two values
FOR_EVER = 1e9
BINDING = 0.5  # seconds until it tries to bind its name again


class Context(parts.Context):
    """A context that changes states, a little later than it is asked to, as real ones do."""

    history = None  # type: list  # [(time, state)] of its owner, filled by its Component

    def _ask(self, reference, before, after):
        member, state = self._member(reference)
        if member is None:
            return code("BAD_PARAMETER")
        if state != before:
            return code("PRECONDITION_NOT_MET")
        loop.current().call_later(LATER, lambda: self._change(member, before, after))
        return code("RTC_OK")

    def _change(self, member, before, after):
        _, state = self._member(member.reference)
        if state == before and self.running:
            self.set_state(member, after)

    def set_state(self, component, state):
        super().set_state(component, state)
        component.note_states()

    def activate_component(self, reference):
        return self._ask(reference, "Inactive", "Active")

    def deactivate_component(self, reference):
        return self._ask(reference, "Active", "Inactive")

    def reset_component(self, reference):
        return self._ask(reference, "Error", "Inactive")

    def start(self):
        return self._set_running(True)

    def stop(self):
        return self._set_running(False)

    def _set_running(self, running):
        if self.running == running:
            return code("PRECONDITION_NOT_MET")
        self.running = running
        return code("RTC_OK")

    def set_rate(self, rate):
        if rate <= 0:
            return code("BAD_PARAMETER")
        self.rate = rate
        return code("RTC_OK")


class Configuration(parts.Configuration):
    """A configuration whose values are set."""

    def set_configuration_set_values(self, given):
        known = self.sets.get(given.id)
        if known is None:
            return False
        for name, value in orb.properties(given.configuration_data):
            known[name] = value
        return True

    def activate_configuration_set(self, name):
        if name not in self.sets:
            return False
        self.active = name
        return True


class Asking:
    """What ports of C++ components do when they are asked for their profile: they look whether the far ends
    of their connectors live, and wait for them.
    """

    async def get_port_profile(self):
        await self._prune()
        return self.profile()

    async def _prune(self):
        for connector_id, profile in list(self.connectors.items()):
            for end in profile.ports:
                if orb.own_servant(end) is not None:
                    continue
                try:
                    await orb.is_alive(orb.at_address(end), end)
                except Exception:
                    self.forget(connector_id)


class OutPort(Asking, ports.OutPort):
    """An out port that sends 1, 2, 3 … while its component is Active and a tool is connected with it;
    `numbers` are those that it has sent, each with its time.
    """

    def __init__(self, component, name, properties):
        super().__init__(component, name, properties)
        self.numbers = {}
        self._is_ticking = False

    def begin(self, profile):
        if len(profile.ports) == 1 and not self._is_ticking:
            self._is_ticking = True
            loop.current().call_later(PERIOD, self._tick)
        return super().begin(profile)

    def _tick(self):
        if not self.carriers and not self.coming:
            self._is_ticking = False
            return
        loop.current().call_later(PERIOD, self._tick)
        if self.component.state == "Active" and self.component.contexts[0].running:
            number = self.component.first + len(self.numbers)
            moment = loop.wall()
            self.numbers[number] = self.component.world.time
            self.write(lambda little: struct.pack("<LLl" if little else ">LLl", int(moment), 0, number))


class InPort(Asking, ports.InPort):
    pass


class Component(parts.Component):
    """A living component of a World: `states`: [(time, state in its own context)], what was true and when."""

    def __init__(self, world, name, first=1):
        """`first`: the number that its out port begins with."""
        kind = name.rstrip("0123456789")
        identity = {"type_name": kind, "vendor": "sim", "category": "test", "version": "1"}
        pairs = [("language", "C++"), ("openrtm.version", "2.1.0"), ("implementation_id", kind)]
        configuration = Configuration({"default": {"gain": "1"}, "other": {"gain": "2"}}, "default")
        super().__init__(name, identity, pairs, configuration)
        self.world = world
        self.first = first
        self.states = [(world.time, "Inactive")]
        self.contexts = [Context(self)]
        self.ports = [
            InPort(self, "in", _data("DataInPort")),
            OutPort(self, "out", _data("DataOutPort")),
        ]

    @property
    def state(self):
        return self.contexts[0].members[0][1]

    def note_states(self):
        self.states.append((self.world.time, self.state))

    async def get_component_profile(self):
        for port in self.ports:
            await port._prune()
        return super().get_component_profile()


def _data(kind):
    subscription = "Any" if kind == "DataInPort" else "flush,new,periodic"
    return {
        "port.port_type": kind,
        "dataport.data_type": "IDL:RTC/TimedLong:1.0",
        "dataport.interface_type": "corba_cdr",
        "dataport.dataflow_type": "push,pull",
        "dataport.subscription_type": subscription,
    }


def serve_names(address, port, context):
    """main() of a name server, whose naming contexts are of this class."""

    async def serve():
        orb.listen(address, port)
        nameserver.Names(address, context)
        await loop.sleep(FOR_EVER)

    return lambda: loop.run(serve(), session=session.Session(PATIENT))


async def _bind(bound, names, reference):
    while True:
        try:
            return await bound.bind(names, reference)
        except errors.Error:  # the name server is not there, or a name is not free yet
            await loop.sleep(BINDING)


def serve(components, address, server):
    """main() of a process with these components, which binds them in the name server at `server`,
    HOST:PORT; `components` are functions that make one each, which get what they have made as `found`.
    """

    async def main():
        orb.listen(address, 0)
        tasks = loop.Group()
        bound = bindings.Bindings(tree.name_server(server))
        for each in components:
            each.tasks = tasks
            each.publish(address)
        for each in components:
            names = path.parse(f"/{server}/robot.host_cxt/{each.instance_name}.rtc").names
            await _bind(bound, names, each.reference)
        await loop.sleep(FOR_EVER)

    return lambda: loop.run(main(), session=session.Session(PATIENT))
