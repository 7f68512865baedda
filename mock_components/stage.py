"""Setting up a world: its process, its name server, its components."""
from . import carrier, children, components, naming
from .idl import RTC
from .properties import nvlist

PUSH = [("dataport.dataflow_type", "push"), ("dataport.interface_type", "corba_cdr"),
        ("dataport.subscription_type", "flush")]


class Stage:
    """The argument of the functions in worlds.py."""

    def __init__(self, process, names, flavour, options):
        self.process = process
        self.names = names
        self.flavour = flavour
        self.options = options
        self.components = process.components
        # instance name -> component that a manager lists: the first of that name
        self.listed = {}
        # name that two components have had at a time -> how many of them are gone
        self.twins = {}
        self.manager = None             # the manager of this process, if it has one
        self.misname = None             # what that calls all that it makes, whatever is asked for
        self.children = []              # further processes, to be ended with this one
        self.controls = []              # their control sockets
        self.ready = []                 # what is said after `ready` and the number of components
        self.after_ready = None         # called once `ready` has been printed
        self.finish = carrier.Event()     # set: the process is to end in good order

    def add(self, type_name, instance_name=None, names=None, **changes):
        """Start a component and bind it: under `names`, lists of (id, kind), or as its naming.formats say.

        `type_name` may be a Spec; `flavour` and the fields of the options can be given by name.
        """
        spec = components.SPECS[type_name] if isinstance(type_name, str) else type_name
        flavour = changes.pop("flavour", self.flavour)
        instance_name = instance_name or type_name + "0"
        component = spec.play(self.process, spec, instance_name, flavour, self.options.but(**changes))
        component.ended = self._ended
        if instance_name in self.components:
            self.twins.setdefault(instance_name, 0)
        self.components[instance_name] = component
        if self.gone(self.listed.get(instance_name)):
            self.listed[instance_name] = component
        component.bound = [naming.parse(name) for name in component.names] if names is None else names
        for name in component.bound:
            self.names.bind(name, component.reference)
        return component

    def stray(self, spec, instance_name):
        """A component whose name is taken, as made by Python: it is bound nowhere, and no manager lists it.
        """
        return spec.play(self.process, spec, instance_name, self.flavour, self.options)

    def gone(self, component):
        """Whether a component has existed and ended."""
        return component is None or self.process.local_servant(component.reference) is None

    def home(self):
        """The context in which components are bound."""
        return naming.parse(self.options.context.split(",")[0])[:-1]

    def port(self, text):
        """The port written `Instance:port`."""
        instance_name, _, port = text.rpartition(":")
        return self.components[instance_name].port(port)

    def connect(self, one, other, *more):
        """Connect two ports, written `Instance:port`; `more` are further properties, pairs."""
        ports = [self.port(one), self.port(other)]
        pairs = PUSH + [("dataport.data_type", ports[0].data_type)] + list(more)
        name = "_".join(port.short_name for port in ports)
        profile = RTC.ConnectorProfile(name, "", [port.reference for port in ports], nvlist(pairs))
        code, _ = ports[0].connect(profile)
        assert code == RTC.RTC_OK, (one, other, code)

    def forsake(self, instance_name):
        """End a component, but never take it from the manager's list."""
        component = self.components.pop(instance_name)
        component.ended = None
        component.exit()
        for name in component.bound:
            self.names.unbind(name)

    def end(self):
        """Clean up: other processes first, then other managers, then the name server."""
        children.end(self)
        if self.manager:
            self.manager.leave()
        self.names.unbind_all()

    def _ended(self, component, linger):
        name = component.instance_name
        if self.components.get(name) is component:
            del self.components[name]
        self.process.later(linger, self._forget, component)

    def _forget(self, component):
        """Unbind it and remove it from the manager; with two components of one name, a process of C++ 1.x
        ends.
        """
        self.process.ledger.own_thread()
        name = component.instance_name
        for bound in component.bound:
            self.names.unbind(bound)
        if self.listed.get(name) is component:
            del self.listed[name]
        if name in self.twins:
            self.twins[name] += 1
            if self.twins[name] == 2 and self.flavour.twins == "crash":
                self.process.die()
