"""Components that do as they are told: they are activated, configured and connected as real ones are, and
work at a rate meanwhile. All that they know is in memory.
"""

import math

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.data import build_value
from rtshell_lite.net import loop
from rtshell_lite.play import component, ports
from rtshell_lite.play.component import code, nvlist
from rtshell_lite.robot.component import FACTS
from rtshell_lite.text import from_wire

FASTEST = 100.0  # Hz: a context has no higher rate
BREATH = 0.001  # seconds that others have between two executions, at least


class Fault(Exception):
    """What a component raises that goes to Error."""


def finite(number):
    """A number that a component can go on with. Raises Fault."""
    if not math.isfinite(number):
        raise Fault
    return number


class Context(component.Context):
    """An execution context that can be started and stopped, and whose components change their states at
    once. Those of a composite follow it.
    """

    def activate_component(self, reference):
        return self._change(reference, "Inactive", "Active")

    def deactivate_component(self, reference):
        return self._change(reference, "Active", "Inactive")

    def reset_component(self, reference):
        return self._change(reference, "Error", "Inactive")

    def _change(self, reference, before, after):
        changed, state = self._member(reference)
        if changed is None:
            return code("BAD_PARAMETER")
        if state != before or not self.running:
            return code("PRECONDITION_NOT_MET")
        for part, state in list(self.members):
            if part is changed or changed.organisation and state == before:
                self.set_state(part, after)
        return code("RTC_OK")

    def start(self):
        return self._run(True)

    def stop(self):
        return self._run(False)

    def _run(self, is_running):
        if self.running == is_running:
            return code("PRECONDITION_NOT_MET")
        self.running = is_running
        return code("RTC_OK")

    def set_rate(self, rate):
        if not 0 < rate <= FASTEST:
            return code("BAD_PARAMETER")
        self.rate = rate
        for member, _ in self.members:
            member.paced.ring()
        return code("RTC_OK")


class Configuration(component.Configuration):
    """A configuration whose sets others change, and activate."""

    def add_configuration_set(self, given):
        name = from_wire(given.id)
        if not name or name in self.sets:
            return False
        self.sets[name] = dict(orb.properties(given.configuration_data))
        return True

    def set_configuration_set_values(self, given):
        name = from_wire(given.id)
        if name not in self.sets:
            return False
        self.sets[name].update(orb.properties(given.configuration_data))
        return True

    def remove_configuration_set(self, name):
        name = from_wire(name)
        if name not in self.sets or name in ("default", self.active):
            return False
        del self.sets[name]
        return True

    def activate_configuration_set(self, name):
        name = from_wire(name)
        if name not in self.sets:
            return False
        self.active = name
        return True


class InPort(ports.InPort):
    """A DataInPort that keeps the last value that has come: its `value`, None before the first, of the timed
    types what they have as `data`. on_value(value), where it is set, is called for each.
    """

    def __init__(self, owner, name, data_type):
        super().__init__(owner, name, _properties("DataInPort", "Any", data_type.id))
        self._type = data_type
        self.value = None
        self.on_value = None

    def take(self, data, little):
        try:
            value = self._type.decode(data, little)
        except errors.BadData:
            return  # a peer may send anything
        self.value = getattr(value, "data", value)
        if self.on_value is not None:
            self.on_value(self.value)


class OutPort(ports.OutPort):
    """A DataOutPort that sends values of a type."""

    def __init__(self, owner, name, data_type):
        super().__init__(owner, name, _properties("DataOutPort", "flush,new,periodic", data_type.id))
        self._type = data_type

    def send(self, value):
        """Send a value of its type, a dict of its members, or what its member `data` is to be; a timestamp
        that is left out is the present. Raises BadValue.
        """
        now = divmod(int(loop.wall() * 1e9), 10**9)
        built = build_value.build(self._type.descriptor, value, self._type.name, now=now)
        self.write(lambda little: self._type.encode(built, little))


class ServicePort(ports.ServicePort):
    """A CorbaPort whose services can be called: `servants` {instance name: servant}."""

    def __init__(self, owner, name, servants):
        self._services = [
            (instance, servant.interface.rpartition(".")[2], servant)
            for instance, servant in servants.items()
        ]
        interfaces = [(instance, type_name, "Provided") for instance, type_name, _ in self._services]
        super().__init__(owner, name, {"port.port_type": "CorbaPort"}, interfaces)

    def begin(self, profile):
        profile.properties += nvlist(
            (f"port.{type_name}.{instance}", servant.reference.text())
            for instance, type_name, servant in self._services
        )


def _properties(kind, subscriptions, type_id):
    return {
        "port.port_type": kind,
        "dataport.data_type": type_id,
        "dataport.interface_type": "corba_cdr",
        "dataport.dataflow_type": "push,pull",
        "dataport.subscription_type": subscriptions,
    }


class Worker(component.Component):
    """A component that works, `step`, while it is Active in a context that runs.

    A subclass says what it is made of:
      category, description, vendor, version    texts of its profile
      ins, outs               {name of a data port: its data type}
      services                {name of a service port: {instance name: class of its servant, called with the
                              component}}
      settings                {name of a configuration set: {name: value}}, `default` first
      rate                    Hz
    """

    category = description = ""
    vendor, version = "rtshell_lite", "1.0"
    ins = {}  # type: dict
    outs = {}  # type: dict
    services = {}  # type: dict
    settings = {}  # type: dict
    rate = 10.0

    def __init__(self, instance_name, types, tasks):
        """`types`: a datatypes.Types; `tasks`: a loop.Group in which it works and its ports send."""
        identity = {fact: getattr(self, fact, "") for fact in FACTS}
        identity["type_name"] = type(self).__name__
        sets = {set_name: dict(values) for set_name, values in self.settings.items()}
        configuration = Configuration(sets, next(iter(sets), ""))
        super().__init__(instance_name, identity, [("language", "Python")], configuration)
        self.tasks = tasks
        self.paced = loop.Bell()  # rings when the rate has changed
        self.contexts = [Context(self, rate=self.rate)]
        for kind, given in ((InPort, self.ins), (OutPort, self.outs)):
            self.ports += [kind(self, port, types.named(data_type)) for port, data_type in given.items()]
        self._servants = []
        for port, classes in self.services.items():
            servants = {instance: servant(self) for instance, servant in classes.items()}
            self.ports.append(ServicePort(self, port, servants))
            self._servants += servants.values()

    def parts(self):
        return super().parts() + self._servants

    def port(self, name):
        """Its port of that name."""
        return next(port for port in self.ports if port.name == name)

    def value(self, name, default=0.0):
        """The last value that has come to an in port, `default` before the first. Raises Fault for a number
        that is infinite or none.
        """
        value = self.port(name).value
        if isinstance(value, float):
            return finite(value)
        return default if value is None else value

    def setting(self, name):
        """A number of the active configuration set; that of the class where its text is not a number."""
        try:
            return finite(float(self.configuration.sets[self.configuration.active][name]))
        except (KeyError, ValueError, Fault):
            return float(self.settings["default"][name])

    def step(self, seconds):
        """Work; `seconds` have passed since the last time. Raises Fault to go to Error, as it does where it
        computes what cannot be.
        """

    def rest(self, seconds):
        """So many seconds have passed in which it did not work."""

    async def work(self):
        """Be executed, until that is cancelled."""
        before = due = loop.now()
        while True:
            due = max(due, loop.now() - 1) + 1 / self._pace()  # it makes up for a second at most
            if await self.paced.wait(max(BREATH, due - loop.now())):
                due = loop.now()
            now = loop.now()
            self._execute(now - before)
            before = now

    def _pace(self):
        """The rate (Hz) of the context that executes it: the own one of a composite's member is stopped."""
        running = [context for context in self.contexts + self.participating if context.running]
        return (running or self.contexts)[0].rate

    def _execute(self, seconds):
        active = [context for context in self.contexts + self.participating if self._is_executed_by(context)]
        if not active:
            return self.rest(seconds)
        try:
            self.step(seconds)
        except (Fault, ArithmeticError, ValueError):  # others may send and set any number
            for context in active:
                context.set_state(self, "Error")

    def _is_executed_by(self, context):
        return context.running and context.state_of(self) == "Active"
