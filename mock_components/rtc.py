"""An RT Component: profile, contexts, ports and configuration behind one CORBA object."""
from . import carrier, configuration, context, dataport, naming, observers, serviceport
from .counting import FOR_EVER
from .idl import RTC, SDOPackage
from .properties import nvlist

LINGER = 0.7            # seconds that the name of an ended component stays bound
KINDS = {
    "in": dataport.InPort,
    "out": dataport.OutPort,
    "event": dataport.EventInPort,
    "service": serviceport.ServicePort,
}


class Component(carrier.skeleton("OpenRTM.DataFlowComponent")):
    """A component without behaviour; others derive from it."""

    busy = False        # whether an active one has work in every cycle
    reads = False       # whether this work is to read its InPorts
    takes = 0.0         # seconds that it takes with a change of its state
    initialises = True  # whether a manager that makes one gets it
    providers = ()      # interface types of SDO services that it offers
    FIRST_PARTICIPATING = 1000

    def __init__(self, process, spec, instance_name, flavour, options):
        self.process = process
        self.spec = spec
        self.instance_name = instance_name
        self.flavour = flavour
        self.options = options
        self.type_name = spec.type_name
        self.names = naming.expand(options.context, instance_name, self.identity())
        self.reference = process.serve(self, instance_name)
        self.owned = []
        self.participating = []         # None where a context has left
        self.ended = None               # called when the component has ended
        # the last execution: when, for how many cycles; cycles since then
        self.executed = 0.0
        self.cycles = 1
        self.between = 0
        for _ in range(options.contexts):
            self.own_context()
        self.configuration = configuration.Configuration(self, spec.sets(flavour), spec.active_set)
        self.configuration.preset(options.arguments)
        self.configuration_ref = process.serve(self.configuration, instance_name)
        self.ports = [self._port(port) for port in spec.ports(flavour)]
        consumers = options.consumers
        if consumers is None:
            consumers = (observers.OBSERVER,) if flavour.observer else ()
        self.observers = observers.Observers(self, consumers)
        self.key = flavour.component_key and flavour.component_key.format(spec.category, instance_name)
        if self.key and process.serve_key(self, self.key, instance_name) is None:
            self.key = None

    def own_context(self):
        kind = context.ExtTrigContext if self.flavour.ext_trig else context.PeriodicContext
        cxt = kind(self.process, self.flavour, self.options.rate, self.options.running, self.options.sync)
        cxt.reference = self.process.serve(cxt, self.instance_name)
        cxt.own(self.reference, self, len(self.owned))
        self.owned.append(cxt)

    def _port(self, port):
        return KINDS[port[0]](self, *port[1:])

    def port(self, name):
        """The port of that short name."""
        return next(port for port in self.ports if port.short_name == name)

    # profiles

    def identity(self):
        return self.spec.identity(self.flavour)

    def properties(self):
        """The properties of the component profile, roughly in the order of real ones."""
        flavour = self.flavour
        options = self.options
        endpoint = self.process.endpoint
        pairs = list(self.identity().items())
        pairs += self.spec.nature(flavour)
        pairs += self.configuration.profile()
        pairs += [("instance_name", self.instance_name), ("openrtm.name", "OpenRTM-aist-" + flavour.version),
                  ("openrtm.version", flavour.version), ("os.name", "Linux"), ("os.release", "6.1.0"),
                  ("os.version", "#1 SMP"), ("os.arch", "x86_64"), ("os.hostname", "test"),
                  ("corba." + flavour.endpoint_key, endpoint), ("corba.id", "omniORB")]
        if flavour.modern:
            pairs += [("corba.endpoints_ipv4", endpoint), ("corba.endpoints_ipv6", ""),
                      ("exec_cxt.sync_transition", "YES" if options.sync else "NO"),
                      ("exec_cxt.transition_timeout", "0.5"), ("manager.instance_name", "manager")]
        pairs += [
            ("exec_cxt.periodic.type", "PeriodicExecutionContext"),
            ("exec_cxt.periodic.rate", f"{options.rate:g}"),
            ("naming.enable", "YES"),
            ("naming.type", "corba"),
            ("naming.formats", options.context),
            ("naming.names", ",".join(self.names)),
            ("logger.enable", "YES"),
            ("logger.log_level", "INFO"),
            ("config.version", flavour.version),
            ("config_file", self.spec.config_file),
        ]
        pairs += self._port_properties()
        pairs += [("sdo.service.provider.available_services", ",".join(self.providers)),
                  ("sdo.service.provider.enabled_services", "ALL"),
                  ("sdo.service.consumer.available_services", ",".join(self.observers.available)),
                  ("sdo.service.consumer.enabled_services", "ALL")]
        if self.spec.active_set != "default":
            pairs.append(("configuration.active_config", self.spec.active_set))
        return self._with_arguments(pairs)

    def _with_arguments(self, pairs):
        """The properties, replaced and extended by those given to create_component."""
        given = self.options.arguments
        known = {name for name, _ in pairs}
        return ([(name, given.get(name, value)) for name, value in pairs] +
                [(name, value) for name, value in given.items()
                 if name not in known and not configuration.of_a_set(name)])

    def _port_properties(self):
        names = []
        for port in self.ports:
            names += port.component_keys(self.flavour.port_keys == "name")
        return [(name, "") for name in dict.fromkeys(names)] or [("port", "")]

    def get_component_profile(self):
        for port in self.ports:
            port.prune_for_component()
        profile = self.identity()
        return RTC.ComponentProfile(
            self.instance_name,
            profile["type_name"],
            profile["description"],
            profile["version"],
            profile["vendor"],
            profile["category"],
            [port.profile() for port in self.ports],
            None,
            nvlist(self.properties()),
        )

    def get_ports(self):
        return [port.reference for port in self.ports]

    # contexts

    def get_owned_contexts(self):
        return [cxt.reference for cxt in self.owned]

    def get_participating_contexts(self):
        return [cxt for cxt in self.participating if cxt is not None]

    def _context(self, handle):
        contexts = [cxt.reference for cxt in self.owned]
        index = handle
        if handle >= self.FIRST_PARTICIPATING:
            contexts = self.participating
            index = handle - self.FIRST_PARTICIPATING
        return contexts[index] if 0 <= index < len(contexts) else None

    def get_context(self, handle):
        return self._context(handle)

    def get_context_handle(self, cxt):
        for handle, own in enumerate(self.owned):
            if own.reference._is_equivalent(cxt):
                return handle
        for index, other in enumerate(self.participating):
            if other is not None and other._is_equivalent(cxt):
                return self.FIRST_PARTICIPATING + index
        return -1

    def is_alive(self, cxt):
        return cxt is not None and self.get_context_handle(cxt) != -1

    def attach_context(self, cxt):
        self.participating.append(cxt)
        handle = self.FIRST_PARTICIPATING + len(self.participating) - 1
        self.report("EC_STATUS", "ATTACHED:%d" % handle)
        return handle

    def detach_context(self, handle):
        index = handle - self.FIRST_PARTICIPATING
        if not 0 <= index < len(self.participating) or self.participating[index] is None:
            return RTC.BAD_PARAMETER
        self.participating[index] = None
        self.report("EC_STATUS", "DETACHED:%d" % handle)
        return RTC.RTC_OK

    def read_ports(self, handle):
        """Read all InPorts, once for each cycle that this execution represents, but for those of
        `read_between`.
        """
        driving = self.process.local_servant(self._context(handle))
        cycles = driving.cycles() if driving else 1
        for _ in range(max(1, cycles - self.between)):
            self._read()
        self.executed = carrier.now()
        self.cycles = cycles
        self.between = 0

    def read_between(self):
        """Read what the cycles since the last execution have to read: a short buffer would be full for most
        of the time.
        """
        due = min(self.cycles - 1, int((carrier.now() - self.executed) / context.QUICKEST * self.cycles))
        while self.between < due:
            self.between += 1
            self._read()

    def overdue(self):
        """How many cycles it would have executed since the last one, were the thread of its context not held
        up on a busy machine.
        """
        others = map(self.process.local_servant, self.get_participating_contexts())
        return max((cxt.overdue(self) for cxt in [*self.owned, *filter(None, others)]), default=0)

    def _read(self):
        for port in self.ports:
            if port.port_type == "DataInPort":
                port.read()

    # life cycle

    def initialize(self):
        """Build the contexts once more, as real components do. No tool should call this."""
        self.own_context()
        return RTC.RTC_OK

    def finalize(self):
        return RTC.PRECONDITION_NOT_MET

    def exit(self):
        """The objects are gone at once; the name stays for a while."""
        self._leave_organizations()
        self.report("RTC_STATUS", "FINALIZE:0")
        self.observers.close()
        for port in self.ports:
            port.disconnect_all()
            port.close()
        for cxt in self.owned:
            cxt.close()
        for servant in [self, self.configuration] + self.ports + self.owned:
            self.process.withdraw(servant)
        if self.key:
            self.process.withdraw_key(self.key)
        if self.ended:
            self.ended(self, LINGER)
        return RTC.RTC_OK

    def _leave_organizations(self):
        for organization in self.get_organizations():
            try:
                organization.remove_member(self.instance_name)
            except carrier.Raised:
                pass                    # the composite has died, or has just let it go

    def configured(self, config_id):
        """A configuration set has been activated."""

    def active(self):
        """Whether it is active, in its own contexts or in others'."""
        contexts = self.owned + self.get_participating_contexts()
        return any(cxt.get_component_state(self.reference) == RTC.ACTIVE_STATE for cxt in contexts)

    def report(self, kind, hint):
        """Report to the observers."""
        self.observers.report(kind, hint)

    def hang(self):
        """Answer no more."""
        self.process.ledger.hang(self.instance_name, FOR_EVER)
        carrier.sleep(FOR_EVER)

    # callbacks: what contexts call, and the part of it that components have their own way of doing

    def _fine(self, handle):
        return RTC.RTC_OK

    activated = deactivated = reset = on_execute = on_error = on_state_update = _fine
    on_initialize = on_finalize = lambda self: RTC.RTC_OK

    def on_activated(self, handle):
        self.configuration.update()
        return self._report_done(self.activated(handle), "RTC_STATUS", "ACTIVE", handle)

    def on_deactivated(self, handle):
        return self._report_done(self.deactivated(handle), "RTC_STATUS", "INACTIVE", handle)

    def on_reset(self, handle):
        return self._report_done(self.reset(handle), "RTC_STATUS", "INACTIVE", handle)

    def on_aborting(self, handle):
        return self._report_done(RTC.RTC_OK, "RTC_STATUS", "ERROR", handle)

    def on_startup(self, handle):
        return self._report_done(RTC.RTC_OK, "EC_STATUS", "STARTUP", handle)

    def on_shutdown(self, handle):
        return self._report_done(RTC.RTC_OK, "EC_STATUS", "SHUTDOWN", handle)

    def on_rate_changed(self, handle):
        return self._report_done(RTC.RTC_OK, "EC_STATUS", "RATE_CHANGED", handle)

    def _report_done(self, code, kind, what, handle):
        if code == RTC.RTC_OK:
            self.report(kind, "%s:%d" % (what, handle))
        return code

    # SDO

    def get_owned_organizations(self):
        return []

    def get_sdo_id(self):
        return self.instance_name

    def get_sdo_type(self):
        return self.spec.description

    def get_device_profile(self):
        return SDOPackage.DeviceProfile("", "", "", "", [])

    def get_service_profiles(self):
        return []

    def get_service_profile(self, service_id):
        raise configuration.error(self.flavour.no_service_profile, "get_service_profile(): Not found")

    def get_sdo_service(self, service_id):
        raise configuration.error(self.flavour.no_sdo_service, "get_sdo_service(): Not found")

    def get_configuration(self):
        return self.configuration_ref

    def get_monitoring(self):
        raise SDOPackage.InterfaceNotImplemented("Exception: get_monitoring")

    def get_organizations(self):
        return list(self.configuration.organizations)

    def get_status_list(self):
        return []

    def get_status(self, name):
        raise SDOPackage.InvalidParameter("get_status(): Not found")
