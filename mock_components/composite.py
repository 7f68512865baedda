"""Composite components: one execution context and one face for several components, through an Organization.
"""
import math

from . import carrier
from .context import TRANSITION_TIMEOUT
from .idl import RTC, OpenRTM, SDOPackage
from .port import is_alive
from .rtc import Component

LATE = 1.0              # seconds: C++ 1.2 waits no longer than that for all members


class Member:
    """A member of an organization; its name and port names are kept when it dies."""

    def __init__(self, reference):
        self.reference = reference
        self.name = reference.get_sdo_id()
        self.ports = []                 # (name with the component's before it, reference)
        for port in reference.get_ports():
            name = port.get_port_profile().name
            self.ports.append((name if name.startswith(self.name + ".") else self.name + "." + name, port))

    def is_dead(self):
        return not is_alive(self.reference)


class Organization(carrier.skeleton("SDOPackage.Organization")):
    """The members of a composite; adding one stops its own contexts, removing it starts them."""

    def __init__(self, composite):
        self.composite = composite
        self.id = carrier.unique_id(by_time=False)
        self.members = []
        self.properties = []
        self.owner_told = False

    def get_organization_id(self):
        return self.id

    def get_owner(self):
        """C++ answers only the first call."""
        if self.owner_told and self.composite.flavour.language == "C++":
            return None
        self.owner_told = True
        return self.composite.reference

    def set_owner(self, owner):
        return True

    def get_dependency(self):
        return SDOPackage.OWN

    def set_dependency(self, dependency):
        return True

    # members

    def get_members(self):
        return [member.reference for member in self.members]

    def add_members(self, references):
        if not references:
            raise SDOPackage.InvalidParameter("add_members(): SDOList is empty.")
        for reference in references:
            component = reference._narrow(OpenRTM.DataFlowComponent)
            if component is not None and not any(component._is_equivalent(m.reference) for m in self.members):
                self._take(component)
        self.composite.export()
        return True

    def set_members(self, references):
        if not references:
            raise SDOPackage.InvalidParameter("set_members(): SDOList is empty.")
        self.dissolve()
        return self.add_members(references)

    def remove_member(self, name):
        if not name:
            raise SDOPackage.InvalidParameter("remove_member(): Empty name.")
        member = next((member for member in self.members if member.name == name), None)
        if member is None:
            raise SDOPackage.InvalidParameter("remove_member(): Not found.")
        self._release(member)
        self.composite.export()
        return True

    def dissolve(self):
        """Release all members. Raises what dead ones raise."""
        for member in list(self.members):
            self._release(member)

    def has_dead_members(self):
        return any(member.is_dead() for member in self.members)

    def _take(self, component):
        member = Member(component)
        for context in component.get_owned_contexts():
            context.stop()
        component.get_configuration().add_organization(self.reference)
        self.composite.owned[0].add_component(component)
        self.members.append(member)

    def _release(self, member):
        if member.is_dead():            # it stays: its ports are hidden, then the first call to it fails
            self.composite.export(hidden=member)
            self.composite.stumble()
            member.reference.get_owned_organizations()
        self.members.remove(member)
        self.composite.owned[0].remove_component(member.reference)
        member.reference.get_configuration().remove_organization(self.id)
        for context in member.reference.get_owned_contexts():
            context.start()

    # properties

    def get_organization_property(self):
        return SDOPackage.OrganizationProperty(self.properties)

    def get_organization_property_value(self, name):
        return next(item.value for item in self._named(name))

    def add_organization_property(self, added):
        self.properties = list(added.properties)
        return True

    def set_organization_property_value(self, name, value):
        if any(item.name == name for item in self.properties):
            self.remove_organization_property(name)
        self.properties.append(SDOPackage.NameValue(name, value))
        return True

    def remove_organization_property(self, name):
        found = self._named(name)
        self.properties = [item for item in self.properties if item not in found]
        return True

    def _named(self, name):
        found = [item for item in self.properties if item.name == name]
        if not found:
            raise SDOPackage.InvalidParameter("Not found.")
        return found


class Composite(Component):
    """PeriodicECSharedComposite: its context drives its members, and it exports chosen ports of theirs."""

    def __init__(self, *arguments):
        self.exported = []              # references
        # whether it has been active: the thread of its context runs ever after
        self.awake = False
        self.doomed = False             # whether that thread will end its process
        super().__init__(*arguments)
        self.organization = Organization(self)
        self.organization.reference = self.process.serve(self.organization, self.instance_name)
        named = [self.process.components.get(name) for name in words(self._parameters()["members"])]
        members = [component.reference for component in named if component]
        if members:
            self.organization.add_members(members)

    def own_context(self):
        super().own_context()
        context = self.owned[-1]
        if self.flavour.composite == "async":
            context.sync = False
            context.more = [(name, "NO") for name in ("sync_activation", "sync_deactivation", "sync_reset")]

    def _parameters(self):
        return self.configuration.sets["default"]

    # ports

    def export(self, hidden=None):
        """Show the ports that `exported_ports` names, but for those of the member `hidden`; a name without
        its component gets one.
        """
        ports = [
            pair for member in self.organization.members if member is not hidden for pair in member.ports
        ]
        full = {name.partition(".")[2]: name for name, _ in ports}
        parameters = self._parameters()
        wanted = words(parameters["exported_ports"])
        if any("." not in name and name in full for name in wanted):
            wanted = [full.get(name, name) for name in wanted]
            parameters["exported_ports"] = ",".join(wanted)
        self.exported = [reference for name, reference in ports if name in wanted]

    def configured(self, config_id):
        if config_id == "default":
            self.export()

    def get_ports(self):
        return super().get_ports() + self.exported

    def get_component_profile(self):
        if self.flavour.dead_peer == "die" and not all(map(is_alive, self.exported)):
            self.process.die()
        profile = super().get_component_profile()
        profile.port_profiles += [port.get_port_profile() for port in self.exported]
        return profile

    def properties(self):
        pairs = super().properties()
        if self.flavour.composite == "async":
            pairs += [("exec_cxt.periodic." + name, "NO")
                      for name in ("sync_transition", "sync_activation", "sync_deactivation", "sync_reset")]
        return pairs + [("exported_ports", "")]

    def get_owned_organizations(self):
        return [self.organization.reference]

    # life cycle

    @property
    def takes(self):
        if self.flavour.composite == "blocks":
            return math.inf
        if self.flavour.composite == "late":
            return min(TRANSITION_TIMEOUT * len(self.organization.members), LATE)
        return 0.0

    def stumble(self):
        """A member that is to leave has died: the thread of the context meets an exception that nobody
        catches, at once where it runs, else when the composite is activated.
        """
        self.doomed = self.flavour.dead_member == "process"
        if self.doomed and self.awake:
            self.process.later(1.0 / self.owned[0].rate, self.process.die)
        if self.flavour.dead_member == "thread":
            self.owned[0].wreck()

    def activated(self, handle):
        self.awake = True
        if self.doomed:
            self.process.die()
        if self.organization.has_dead_members():
            return RTC.RTC_ERROR
        return self._move(RTC.INACTIVE_STATE, RTC.ACTIVE_STATE)

    def deactivated(self, handle):
        return self._move(RTC.ACTIVE_STATE, RTC.INACTIVE_STATE)

    def reset(self, handle):
        return self._move(RTC.ERROR_STATE, RTC.INACTIVE_STATE)

    def _move(self, before, after):
        """Called by the thread of the context, which is to move the members, too: waiting for them is in
        vain.
        """
        context = self.owned[0]
        members = [
            member for member in context.members if member.state == before and member.component is not self
        ]
        for member in members:
            member.wanted = after
        if self.flavour.composite == "late":
            carrier.sleep(min(TRANSITION_TIMEOUT * len(members), LATE))
        if self.flavour.composite == "blocks" and before == RTC.ACTIVE_STATE:
            for member in members:
                context.poll(member)
        return RTC.RTC_OK

    def exit(self):
        if self.flavour.composite == "blocks":
            self.owned[0].settle(self.reference)
        if self.organization.has_dead_members():
            return self._exit_stumbling()
        self.organization.dissolve()
        self.process.withdraw(self.organization)
        return super().exit()

    def _exit_stumbling(self):
        """Dead members cannot be released: C++ answers and ends with its process, others do not change."""
        if self.flavour.dead_member == "process":
            self.process.later(0.1, self.process.die)
            return RTC.RTC_OK
        self.stumble()
        return RTC.RTC_ERROR


def words(text):
    """The words of a comma-separated list."""
    return [word.strip() for word in text.split(",") if word.strip()]
