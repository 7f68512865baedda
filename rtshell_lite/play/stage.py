"""The components of a recording, as they were at a moment of it."""

from rtshell_lite.corba import orb
from rtshell_lite.data import connection
from rtshell_lite.net import loop
from rtshell_lite.play import component as parts
from rtshell_lite.play import ports as port_kinds
from rtshell_lite.play import recording as recordings
from rtshell_lite.play.component import wire
from rtshell_lite.robot import ports
from rtshell_lite.robot.component import FACTS
from rtshell_lite.system import capture
from rtshell_lite.xmlprofile import model

OBSERVERS = "sdo.service.consumer.available_services"  # of which a recording has none
LOOK = 0.01  # seconds between two looks whether values have been sent
RATE = 1000.0  # Hz of contexts of which nothing is known
CONFIGURATION = "conf."  # how properties begin that say what the configuration is
_DATA = "dataport."


class Stage:
    """Components by their paths, as text, and the out ports of channels: {number: OutPort}. `changed` are
    paths of components that have come or gone since somebody looked.
    """

    def __init__(self, recording, host, tasks):
        """`host`: our address in references; `tasks`: a loop.Group in which ports send."""
        self._recording = recording
        self._host = host
        self._tasks = tasks
        self._scene = None
        self.components = {}
        self.changed = set()
        self.outs = {}
        self._recorded = {}  # by id, as on the wire: the Ports of a connector of the recording
        for scene in recording.scenes:
            there = recordings.by_path(scene)
            for where, described in there.items():
                if where not in self.components:
                    self.components[where] = self._component(scene, where, described)
            for where, described in there.items():
                self._add_members(scene, self.components[where], described)
        self._described = set(self.components)  # those that a Scene shows
        self._add_outs()
        for where in self.components:
            self._come(where)

    # ---- building ----

    def _component(self, scene, where, described):
        details = scene.details.get(where, {})
        if details:
            identity = {key: recordings.text_in(details, key) for key in FACTS}
        else:
            identity = capture.identity(described.id)
        pairs = _profile_properties(details)
        pairs.append(("rtlog.recording", self._recording.log.where))
        component = parts.Component(described.instance_name, identity, pairs, parts.Configuration({}, ""))
        component.tasks = self._tasks
        component.contexts = _contexts(component, details, described)
        self._add_ports(component, details, described, _data_types(scene.profile, where))
        return component

    def _add_ports(self, owner, details, described, types):
        about = {recordings.text_in(port, "name"): port for port in recordings.dicts_in(details, "ports")}
        for port in described.data_ports:
            name = ports.short_name(port.name, described.instance_name)
            kind, type_id = types.get(name, ("DataInPort", ""))
            owner.ports.append(_data_port(owner, name, about.get(name, {}), kind, type_id))
        for port in described.service_ports:
            name = ports.short_name(port.name, described.instance_name)
            owner.ports.append(_service_port(owner, name, about.get(name, {})))

    def _add_members(self, scene, composite, described):
        """Make a component a composite, if it has members."""
        locate = capture.locator(scene.profile)
        members = self._others(
            locate, composite, [participant.component for participant in described.participants]
        )
        if members and composite.organisation is None:
            composite.organisation = parts.Organisation(composite)
        for member in members:
            if member in composite.organisation.members:
                continue
            composite.organisation.members.append(member)
            member.organisations.append(composite.organisation)
            if composite.contexts:
                _take_part(composite.contexts[0], member)
        _share_ports(composite, members)
        for context, described_context in zip(composite.contexts, described.execution_contexts):
            for other in self._others(locate, composite, described_context.participants):
                _take_part(context, other)

    def _others(self, locate, component, targets):
        """The components here that `targets` mean, without `component` itself."""
        located = [self._located(locate, target) for target in targets]
        return [other for other in located if other is not None and other is not component]

    def _located(self, locate, target):
        described = locate(target)
        if described is None:
            return None
        return self.components.get(capture.shown_path(described))

    def _add_outs(self):
        """Find the out ports of the channels, or make those that no profile has."""
        for number, source in self._recording.channels.items():
            where = str(source.object())
            type_id = self._recording.log.channels[number].type_id
            if where not in self.components:
                component = self._component(self._recording.scenes[0], where, _unknown(source))
                self.components[where] = component
            self.outs[number] = _out_port(self.components[where], source.port, type_id)

    # ---- what changes ----

    def show(self, scene, is_jump=False):
        """Have everything be as a Scene says: connections, contexts, configuration, states; at a jump to it,
        also which components there are.
        """
        self._scene = scene
        there = recordings.by_path(scene)
        if is_jump:
            for where in self._described - set(there):
                self._go(where)
        for where, described in there.items():
            self._come(where)
            self._set(self.components[where], scene.details.get(where, {}), described)
        connectors = self._connectors(scene)
        for connector_id in set(self._recorded) - set(connectors):
            self._drop(connector_id)
        for connector_id, (connector, ends) in connectors.items():
            if connector_id not in self._recorded:
                self._join(connector_id, connector, ends)
        if not scene.profile.components:
            for port in self.outs.values():
                port.component.contexts[0].set_state(port.component, "Active")

    def _set(self, owner, details, described):
        sets = {}
        for one_set in described.configuration_sets:
            values = sets.setdefault(one_set.id, {})
            for item in one_set.configuration_data:
                values[item.name] = item.data
        owner.configuration.sets = sets
        owner.configuration.active = described.active_configuration_set
        about = _known_contexts(details)
        for number, (context, described_context) in enumerate(
            zip(owner.contexts, described.execution_contexts)
        ):
            context.rate = described_context.rate
            of_context = about.get(str(number), {})
            context.running = of_context.get("running") is not False
        self._set_states(owner, details.get("states"))

    def _set_states(self, owner, states):
        if not isinstance(states, dict):
            states = {}
        sends = any(port in self.outs.values() for port in owner.ports)
        for handle, context in _handles(owner):
            state = states.get(str(handle))
            if state not in parts.STATES:  # not known
                state = "Active" if sends else "Inactive"
            context.set_state(owner, state)

    def _connectors(self, scene):
        """{id as on the wire: (model's connector, its Ports)} of a Scene, as far as its ports are here."""
        locate = capture.locator(scene.profile)
        connectors = {}
        for connector in scene.profile.connectors:
            ends = [self._end(locate, end) for end in connector.ends]
            if ends and None not in ends:
                connectors[wire(connector.connector_id)] = connector, ends
        return connectors

    def _end(self, locate, end):
        owner = self._located(locate, end)
        if owner is None:
            return None
        name = capture.port_of(end)
        return next((port for port in owner.ports if port.name == name), None)

    def _join(self, connector_id, connector, ends):
        properties = [(item.name, item.value or "") for item in connector.properties]
        references = [port.reference for port in ends]
        profile = orb.struct("RTC.ConnectorProfile")(
            wire(connector.name), connector_id, references, parts.nvlist(properties)
        )
        for port in ends:
            port.record(profile)
        self._recorded[connector_id] = ends

    def _drop(self, connector_id):
        for port in self._recorded.pop(connector_id):
            port.forget(connector_id)

    def take(self, report, following):
        """Take a recordings.Report; `following`: the next Scene, which shows what has been connected, or
        None.
        """
        owner = self.components.get(report.path)
        if owner is None:
            return
        state = recordings.STATES.get(report.event)
        if report.event in ("DIED", "EXITED"):
            self._go(report.path)
        elif report.event in ("APPEARED", "BACK"):
            self._come(report.path)
        elif report.kind == "RTC_STATUS" and state:
            for context in _contexts_of(owner, report.subject):
                context.set_state(owner, state)
        elif report.event in ("EC_STARTUP", "EC_SHUTDOWN"):
            for context in _contexts_of(owner, report.subject):
                context.running = report.event == "EC_STARTUP"
        elif report.event == "CFG_ACTIVATE_SET" and report.subject in owner.configuration.sets:
            owner.configuration.active = report.subject
        elif report.event in ("PORT_CONNECT", "PORT_DISCONNECT") and following is not None:
            self._connect_as(following, owner, report.event == "PORT_CONNECT")

    def _connect_as(self, following, owner, is_new):
        """Connect, or disconnect, the ports of a component as the next Scene has them."""
        connectors = self._connectors(following)
        if not is_new:
            self._drop_of(owner, connectors)
            return
        for connector_id, (connector, ends) in connectors.items():
            owners = [port.component for port in ends]
            if connector_id in self._recorded or owner not in owners:
                continue
            if all(owner.is_there for owner in owners):
                self._join(connector_id, connector, ends)

    def _drop_of(self, owner, kept=()):
        """Drop the connectors of a component but those that are kept."""
        for connector_id, ends in list(self._recorded.items()):
            is_its = any(port.component is owner for port in ends)
            if is_its and connector_id not in kept:
                self._drop(connector_id)

    # ---- coming and going ----

    def _come(self, where):
        """A component is there, from now on."""
        if not self.components[where].is_there:
            self.components[where].publish(self._host)
            self.changed.add(where)

    def _go(self, where):
        """A component is gone, with what it was connected with, until it comes back."""
        owner = self.components[where]
        if not owner.is_there:
            return
        self._drop_of(owner)
        owner.close()
        self.changed.add(where)

    # ---- the end ----

    async def sent(self):
        """Wait until all values have been sent, or who should get them is gone."""
        while any(port.is_busy() for port in self.outs.values()):
            await loop.sleep(LOOK)

    async def leave(self):
        """Disconnect all that others have connected, as components do when they end."""
        await port_kinds.leave(self.components.values())

    def close(self):
        for component in self.components.values():
            component.close()


def _out_port(owner, name, type_id):
    """The out port of a component with that name, made where it has none."""
    added = port_kinds.OutPort(owner, name, _properties("DataOutPort", {}, type_id))
    for index, port in enumerate(owner.ports):
        if port.name == name:
            if not isinstance(port, port_kinds.OutPort):
                owner.ports[index] = added
            return owner.ports[index]
    owner.ports.append(added)
    return added


def _unknown(source):
    """A model.Component of which only a path with an out port is known."""
    context = model.ExecutionContext(id="0", kind="PERIODIC", rate=RATE)
    return model.Component(
        id="RTC::::", path_uri=str(source.object()).lstrip("/"), instance_name=source.instance,
        execution_contexts=[context],
    )


def _profile_properties(details):
    """The (name, value) pairs that a component's profile has of itself, as its details say."""
    return [
        (name, "" if name == OBSERVERS else value)
        for name, value in recordings.pairs_in(details, "properties")
        if not name.startswith(CONFIGURATION)
    ]


def _data_port(owner, name, details, kind, type_id):
    """A data port; its kind and its data type are as connections show them, where its details name none."""
    properties = dict(recordings.pairs_in(details, "properties"))
    said = recordings.text_in(details, "type")
    if said in ports.DATA:
        kind = said
    return port_kinds.KINDS[kind](owner, name, _properties(kind, properties, type_id))


def _service_port(owner, name, details):
    properties = dict(recordings.pairs_in(details, "properties"))
    if not properties:
        properties = {"port.port_type": "CorbaPort"}
    return port_kinds.ServicePort(owner, name, properties, recordings.interfaces_in(details))


def _share_ports(composite, members):
    """Have a composite show the ports of its members that it exports, MEMBER.port."""
    shown = {f"{member.instance_name}.{port.name}": port for member in members for port in member.ports}
    composite.ports = [shown.get(port.name, port) for port in composite.ports]


def _known_contexts(details):
    """{handle, as text: what the details of a component say of that context}"""
    return {str(context.get("handle")): context for context in recordings.dicts_in(details, "contexts")}


def _contexts(owner, details, described):
    about = _known_contexts(details)
    contexts = []
    for number, described_context in enumerate(described.execution_contexts):
        kind = described_context.kind.upper().replace("-", "_")
        if kind not in parts.KINDS:
            kind = "OTHER"
        properties = recordings.pairs_in(about.get(str(number), {}), "properties")
        contexts.append(parts.Context(owner, kind, described_context.rate, properties))
    return contexts


def _handles(owner):
    """(handle, Context) of all contexts of a component."""
    yield from enumerate(owner.contexts)
    yield from enumerate(owner.participating, parts.FIRST_PARTICIPATING)


def _contexts_of(owner, handle):
    """The Contexts of a component that have this handle, a text: one, or none."""
    return [context for number, context in _handles(owner) if str(number) == handle]


def _take_part(context, member):
    if context not in member.participating:
        member.participating.append(context)
        context.members.append([member, "Inactive"])


def _data_types(profile, where):
    """{short name of a port: (its kind, its data type)} as the connections of a profile show them."""
    locate = capture.locator(profile)
    types = {}
    for connector in profile.data_port_connectors:
        for kind, end in (("DataOutPort", connector.source), ("DataInPort", connector.target)):
            described = end and locate(end)
            if described is not None and capture.shown_path(described) == where:
                types[capture.port_of(end)] = kind, connector.data_type
    return types


def _properties(kind, recorded, type_id):
    """The properties of a data port: those that are known, without ways of transport that a
    recording lacks.
    """
    properties = dict(recorded)
    properties.setdefault("port.port_type", kind)
    properties.setdefault("dataport.data_type", type_id)
    subscriptions = "flush,new,periodic" if kind == "DataOutPort" else "Any"
    properties.setdefault("dataport.subscription_type", subscriptions)
    offered = [word.strip() for word in properties.get("dataport.interface_type", "").split(",")]
    usable = [word for word in offered if word in connection.INTERFACES]
    properties["dataport.interface_type"] = ",".join(usable or ["corba_cdr"])
    properties["dataport.dataflow_type"] = "push,pull"
    for name in [name for name in properties if name.startswith(_DATA + "interface_option.")]:
        if name[len(_DATA + "interface_option.") :] not in usable:
            del properties[name]
    return properties
