"""Components that only show: profile, contexts, states and configuration are what they have been given, and
change when the player of the recording sets them. Requests to change them are refused with RTC_ERROR.
"""

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.giop.requests import Thrown
from rtshell_lite.net import loop  # noqa: F401: in a type comment
from rtshell_lite.robot.component import FACTS
from rtshell_lite.text import printable, to_wire

STATES = ("Created", "Inactive", "Active", "Error")  # RTC::LifeCycleState by number
KINDS = ("PERIODIC", "EVENT_DRIVEN", "OTHER")
FIRST_PARTICIPATING = 1000  # handle of the first context of another component
_SDO = "SDOPackage."


def wire(text):
    """A text of a file as a string that can be sent, whatever is in it."""
    try:
        return to_wire(text.replace("\0", ""))
    except errors.Usage:  # a lone surrogate
        return to_wire(printable(text))


def nvlist(pairs):
    """(name, value) texts as an NVList of strings."""
    return [(wire(name).encode("latin-1"), wire(value).encode("latin-1")) for name, value in pairs]


def code(name):
    """An RTC::ReturnCode_t: RTC_OK, RTC_ERROR, BAD_PARAMETER, PRECONDITION_NOT_MET."""
    return orb.enumerator("RTC.ReturnCode_t", name)


def _no(*_):
    return False


class Context:
    """An execution context; `states` are those of components, by name (Active), each with its reference."""

    interface = "RTC.ExecutionContextService"
    reference = withdraw = None

    def __init__(self, owner, kind="PERIODIC", rate=1000.0, properties=()):
        self.owner = owner
        self.kind = kind
        self.rate = rate
        self.running = True
        self.properties = list(properties)
        self.members = [[owner, "Inactive"]]  # [Component, its state], the owner first

    def set_state(self, component, state):
        """What state a component is in from now on."""
        for member in self.members:
            if member[0] is component:
                member[1] = state

    def state_of(self, component):
        """What state a component is in, by name."""
        return next(state for member, state in self.members if member is component)

    def _member(self, reference):
        for component, state in self.members:
            if orb.same(reference, component.reference):
                return component, state
        return None, "Created"

    # ---- operations ----

    def is_running(self):
        return self.running

    def get_rate(self):
        return self.rate

    def get_kind(self):
        return orb.items("RTC.ExecutionKind")[KINDS.index(self.kind)]

    def get_component_state(self, reference):
        _, state = self._member(reference)
        return orb.items("RTC.LifeCycleState")[STATES.index(state)]

    def get_profile(self):
        participants = [component.reference for component, _ in self.members[1:]]
        return orb.struct("RTC.ExecutionContextProfile")(
            self.get_kind(), self.rate, self.owner.reference, participants, nvlist(self.properties)
        )

    def activate_component(self, reference):
        return self._refuse(reference, "Inactive")

    def deactivate_component(self, reference):
        return self._refuse(reference, "Active")

    def reset_component(self, reference):
        return self._refuse(reference, "Error")

    def _refuse(self, reference, before):
        component, state = self._member(reference)
        if component is None:
            return code("BAD_PARAMETER")
        if state != before:
            return code("PRECONDITION_NOT_MET")
        return code("RTC_ERROR")

    def start(self):
        return code("PRECONDITION_NOT_MET" if self.running else "RTC_ERROR")

    def stop(self):
        return code("RTC_ERROR" if self.running else "PRECONDITION_NOT_MET")

    def set_rate(self, rate):
        return code("RTC_ERROR" if rate > 0 else "BAD_PARAMETER")

    def add_component(self, reference):
        return code("RTC_ERROR" if reference is not None else "BAD_PARAMETER")

    def remove_component(self, reference):
        component, _ = self._member(reference)
        return code("RTC_ERROR" if component is not None else "BAD_PARAMETER")


class Configuration:
    """The configuration of a component: `sets` {id: {name: value}}, the id of the `active` one."""

    interface = "SDOPackage.Configuration"
    reference = withdraw = None

    def __init__(self, sets, active):
        self.sets = sets
        self.active = active

    def pairs(self):
        """What a component's profile says of it."""
        for name, values in self.sets.items():
            for key, value in values.items():
                yield f"conf.{name}.{key}", value

    def _as_set(self, name):
        return orb.struct("SDOPackage.ConfigurationSet")(wire(name), "", nvlist(self.sets[name].items()))

    # ---- operations ----

    def get_configuration_sets(self):
        return [self._as_set(name) for name in self.sets]

    def get_configuration_set(self, set_id):
        for name in self.sets:
            if wire(name) == set_id:
                return self._as_set(name)
        raise Thrown(
            _SDO + "InternalError" if set_id else _SDO + "InvalidParameter", "No such ConfigurationSet"
        )

    def get_active_configuration_set(self):
        if self.active not in self.sets:
            raise Thrown(_SDO + "NotAvailable", "no set is active")
        return self._as_set(self.active)

    def get_configuration_parameters(self):
        return []

    def get_configuration_parameter_values(self):
        return []

    def get_configuration_parameter_value(self, name):
        raise Thrown(_SDO + "InvalidParameter", "no such parameter")

    set_configuration_parameter = set_configuration_set_values = add_configuration_set = _no
    remove_configuration_set = activate_configuration_set = set_device_profile = _no
    add_service_profile = remove_service_profile = add_organization = remove_organization = _no


class Organisation:
    """What makes a component a composite: its `members`, Components."""

    interface = "SDOPackage.Organization"
    reference = withdraw = None

    def __init__(self, owner):
        self.owner = owner
        self.members = []

    # ---- operations ----

    def get_organization_id(self):
        return wire(self.owner.instance_name)

    def get_members(self):
        return [member.reference for member in self.members]

    def get_owner(self):
        return self.owner.reference

    def get_dependency(self):
        return orb.items("SDOPackage.DependencyType")[0]

    def get_organization_property(self):
        return orb.struct("SDOPackage.OrganizationProperty")([])

    def get_organization_property_value(self, name):
        raise Thrown(_SDO + "InvalidParameter", "no such property")

    add_members = set_members = remove_member = set_owner = set_dependency = _no
    add_organization_property = set_organization_property_value = remove_organization_property = _no


class Component:
    """A component: `identity` {name: text} of FACTS, `properties` [(name, value)] of its profile, `ports` (of
    ports.py), `contexts` that it owns, `participating` in others', its `configuration`.
    """

    interface = "OpenRTM.DataFlowComponent"
    reference = withdraw = None

    def __init__(self, instance_name, identity, properties, configuration):
        self.instance_name = instance_name
        self.identity = identity
        self.properties = list(properties)
        self.configuration = configuration
        self.ports = []
        self.contexts = []
        self.participating = []
        self.organisation = None  # type: Organisation  # of a composite
        self.organisations = []  # that it is a member of
        self.tasks = None  # type: loop.Group  # in which its ports send

    @property
    def is_there(self):
        """Whether others can call it."""
        return self.withdraw is not None

    def publish(self, host):
        """Let others call it and what belongs to it, at this address of ours."""
        for part in self.parts():
            if part.withdraw is None:
                part.withdraw = orb.publish(part, host)

    def close(self):
        """End: nothing of it exists any more, unless it is published again."""
        for port in self.ports:
            if port.component is self:
                port.close()
        for part in self.parts():
            if part.withdraw is not None:
                part.withdraw()
                part.withdraw = None

    def parts(self):
        """What of it others can call."""
        parts = [self, self.configuration] + self.contexts
        if self.organisation is not None:
            parts.append(self.organisation)
        return parts + [port for port in self.ports if port.component is self]

    # ---- operations of RTObject ----

    def get_component_profile(self):
        texts = dict(self.identity, instance_name=self.instance_name)
        return orb.struct("RTC.ComponentProfile")(
            *[wire(texts.get(name, "")) for name in FACTS], [port.profile() for port in self.ports], None,
            nvlist(self.properties + list(self.configuration.pairs())),
        )

    def get_ports(self):
        return [port.reference for port in self.ports]

    def get_owned_contexts(self):
        return [context.reference for context in self.contexts]

    def get_participating_contexts(self):
        return [context.reference for context in self.participating]

    def get_context(self, handle):
        contexts = self.contexts
        if handle >= FIRST_PARTICIPATING:
            contexts = self.participating
            handle -= FIRST_PARTICIPATING
        return contexts[handle].reference if 0 <= handle < len(contexts) else None

    def get_context_handle(self, reference):
        for first, contexts in ((0, self.contexts), (FIRST_PARTICIPATING, self.participating)):
            for number, context in enumerate(contexts, first):
                if orb.same(reference, context.reference):
                    return number
        return -1

    def is_alive(self, reference):
        return self.get_context_handle(reference) >= 0

    def attach_context(self, reference):
        return -1

    def detach_context(self, handle):
        return code("RTC_ERROR")

    def _refuse(self, *_):
        return code("RTC_ERROR")

    initialize = finalize = exit = _refuse
    on_initialize = on_finalize = on_startup = on_shutdown = on_activated = on_deactivated = _refuse
    on_aborting = on_error = on_reset = on_execute = on_state_update = on_rate_changed = _refuse

    # ---- operations of SDO ----

    def get_sdo_id(self):
        return wire(self.instance_name)

    def get_sdo_type(self):
        return wire(self.identity.get("description", ""))

    def get_device_profile(self):
        return orb.struct("SDOPackage.DeviceProfile")("", "", "", "", [])

    def get_service_profiles(self):
        return []

    def get_service_profile(self, service):
        raise Thrown(_SDO + "InvalidParameter", "no such service")

    get_sdo_service = get_service_profile

    def get_configuration(self):
        return self.configuration.reference

    def get_monitoring(self):
        raise Thrown(_SDO + "InterfaceNotImplemented", "a recording has none")

    def get_owned_organizations(self):
        return [] if self.organisation is None else [self.organisation.reference]

    def get_organizations(self):
        return [organisation.reference for organisation in self.organisations]

    def get_status_list(self):
        return []

    def get_status(self, name):
        raise Thrown(_SDO + "InvalidParameter", "no such status")
