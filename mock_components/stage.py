"""Setting up a world: its process, its name server, its components."""
import threading

from rtshell_lite.idl_stubs.component import RTC

from . import components, naming
from .properties import nvlist

PUSH = [("dataport.dataflow_type", "push"), ("dataport.interface_type", "corba_cdr"),
        ("dataport.subscription_type", "flush")]


class Stage:
    """What the functions of worlds.py are given."""

    def __init__(self, process, names, flavour, options):
        self.process = process
        self.names = names
        self.flavour = flavour
        self.options = options
        self.components = {}
        self.after_ready = None         # called once `ready` has been printed

    def add(self, type_name, instance_name=None, names=None, **changes):
        """Start a component and bind it: under `names`, lists of (id, kind), or as its naming.formats say.

        `type_name` may be a Spec; `flavour` and the fields of the options can be given by name.
        """
        spec = components.SPECS[type_name] if isinstance(type_name, str) else type_name
        flavour = changes.pop("flavour", self.flavour)
        instance_name = instance_name or type_name + "0"
        component = spec.play(self.process, spec, instance_name, flavour, self.options.but(**changes))
        component.ended = self._ended
        self.components[instance_name] = component
        component.bound = [naming.parse(name) for name in component.names] if names is None else names
        for name in component.bound:
            self.names.bind(name, component.reference)
        return component

    def home(self):
        """The context in which components are bound."""
        return naming.parse(self.options.context.split(",")[0])[:-1]

    def port(self, text):
        """The port written `Instance:port`."""
        instance_name, _, port = text.rpartition(":")
        return self.components[instance_name].port(port)

    def connect(self, one, other):
        """Connect two ports, written `Instance:port`."""
        ports = [self.port(one), self.port(other)]
        pairs = PUSH + [("dataport.data_type", ports[0].data_type)]
        name = "_".join(port.short_name for port in ports)
        profile = RTC.ConnectorProfile(name, "", [port.reference for port in ports], nvlist(pairs))
        code, _ = ports[0].connect(profile)
        assert code == RTC.RTC_OK, (one, other, code)

    def _ended(self, component, linger):
        self.components.pop(component.instance_name, None)
        unbind = threading.Timer(linger, lambda: [self.names.unbind(name) for name in component.bound])
        unbind.daemon = True
        unbind.start()
