"""Steps that make connections and remove them; see steps.py."""

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.robot import connectors, ports
from rtshell_lite.system import capture, placements, steps
from rtshell_lite.system.steps import Difference
from rtshell_lite.text import printable


class Incomplete(errors.Refused):
    message = "{}: {}"  # of a connection that some ends lack, or that joins other ports than it should


def connecting(profile, placement_of, only=None):
    """A Connect, or Unplaced, for each connector of a profile, or of those in the list `only`;
    `placement_of` as placements.finder makes it.
    """
    return _placed(profile, placement_of, Connect, only)


def disconnecting(profile, placement_of):
    """A Disconnect, or Unplaced, for each connector of a profile; `placement_of` as placements.finder makes
    it.
    """
    return _placed(profile, placement_of, Disconnect)


def _placed(profile, placement_of, kind, only=None):
    ids = {connector.connector_id for connector in profile.connectors}
    if only is None:
        only = profile.connectors
    steps_of_all = []
    for connector in only:
        ends = [(placement_of(end), capture.port_of(end)) for end in connector.ends]
        if any(placement is None for placement, _ in ends):
            steps_of_all.append(Unplaced(connector, ends))
        else:
            steps_of_all.append(kind(connector, ends, ids))
    return steps_of_all


class Unplaced(steps.Step):
    """A connection with an end on a component that the file does not have."""

    kind = "connect"

    def __init__(self, connector, ends):
        where = f"connection {printable(connector.connector_id) or 'without id'}"
        super().__init__([], where, where)
        self.connector = connector
        self.ends = ends

    def known_answers(self):
        return []

    def differences(self, answers):
        lost = next(end for end, (placement, _) in zip(self.connector.ends, self.ends) if placement is None)
        why = f"the file has no component for its end {printable(lost.port_name)}"
        yield Difference(
            "unplaced", self.connector.connector_id, None, None, errors.Failed(self.where, why)
        )


class ConnectionStep(steps.Step):
    """What connecting and disconnecting share: a connector of the profile, and its `ends` as (Placement, port
    name).

    `ids` are those of all connectors in the profile.
    """

    free = True
    part = "ports"
    is_forced = False  # see connectors.disconnect

    def __init__(self, connector, ends, ids):
        paths = [str(placement.path.with_port(name)) for placement, name in ends]
        concerned = dict.fromkeys(placement for placement, _ in ends)
        label = printable(connector.connector_id) or "without id"
        where = " to ".join(paths)
        super().__init__(concerned, where, f"connection {label} of {where}")
        self.connector = connector
        self.ends = ends
        self.paths = paths
        self.ids = ids
        self.wanted = wanted_properties(connector)

    def questions(self):
        return [placement.port_question(name) for placement, name in self._live_ends()]

    def known_answers(self):
        return [placement.port(name) for placement, name in self._live_ends()]

    def _live_ends(self):
        """The ends that are looked at."""
        return self.ends

    @property
    def endpoint(self):
        placement, name = self._live_ends()[0]
        return placement.port_question(name).endpoint

    def connections_between(self, joined):
        """[(Port, its ports.Connector)] of the Ports `joined`, which the connection is to join: of those that
        have it.

        The connection is the one with the id in the profile; else one that differs in its id alone, see
        `equal_connections`; where the profile has no id, any that joins the same ports.
        """
        wanted_id = self.connector.connector_id
        identities = {orb.identity(port.ref) for port in joined}
        if wanted_id:
            return _with_id(joined, wanted_id) or self.equal_connections(joined)

        def is_meant(connector):
            if len(identities) == 1:
                return identities == _joined(connector)
            return identities <= _joined(connector)

        firsts = [(port, next(filter(is_meant, port.connectors), None)) for port in joined]
        return [(port, connector) for port, connector in firsts if connector is not None]

    def equal_connections(self, joined):
        """As `connections_between`, for one with the same ports and properties under an id that the profile
        does not have.

        Somebody has made it again by hand, or the component itself at its start.
        """
        if len(joined) < len(self.ends):
            return []
        for connector in self.others(joined):
            connections = _with_id(joined, connector.id)
            if len(connections) == len(joined) and not _differing(self.wanted, connector):
                return connections
        return []

    def others(self, joined):
        """The connectors of the first of the Ports `joined` that join as many, others of them too,
        under ids that the profile has not.
        """
        if len(joined) > 1:
            joining = ports.joining(joined)
        else:
            joining = [connector for port in ports.in_system(joined) for connector in port.connectors]
        return [
            connector
            for connector in joining
            if connector.id not in self.ids and len(connector.ports) == len(joined)
        ]

    async def disconnect(self, connections):
        """Remove what `connections_between` returned; returns the errors of the ports that fail."""
        results = [
            await errors.or_error(connectors.disconnect(port, connector, self.is_forced))
            for port, connector in connections
        ]
        return errors.split(results)[1]


def _with_id(joined, connector_id):
    """[(Port, its ports.Connector)] of those of the Ports `joined` that have a connector with this id."""
    connections = [(port, connector) for port in joined for connector in port.connectors]
    return [(port, connector) for port, connector in connections if connector.id == connector_id]


def _differing(given, connector):
    """(name, expected, actual) of the properties, a dict, that a ports.Connector lacks or has otherwise."""
    properties = dict(connector.properties)
    return [
        (name, expected, properties.get(name))
        for name, expected in sorted(given.items())
        if not _agree(name, expected, properties.get(name))
    ]


def _joined(connector):
    """The identities of the ports that a ports.Connector joins."""
    return {orb.identity(ref) for ref in connector.ports if ref is not None}


# ---- connecting ----


class Connect(ConnectionStep):
    """Make a connection with the id, name and properties that the profile gives it."""

    kind = "connect"

    def __init__(self, connector, ends, ids):
        super().__init__(connector, ends, ids)
        self.requested = dict(self.wanted)
        # a short name: the ports know the long one
        if not self.requested.get("dataport.data_type", "").startswith("IDL:"):
            self.requested.pop("dataport.data_type", None)
        self.command = connectors.command(self.paths, connector.name, connector.connector_id, self.requested)

    def leftovers(self, joined):
        """What `connections_between` returns if not all ends have the connection; [] if all have, or none."""
        connections = self.connections_between(joined)
        if len(connections) != len(joined):
            return connections
        identities = {orb.identity(port.ref) for port in joined}
        if all(_joined(connector) == identities for _, connector in connections):
            return []
        return connections

    def differences(self, answers):
        connections = self.connections_between(answers)
        obstacle = self._incomplete(answers)
        is_absent = len(connections) < len(answers)
        if obstacle and not is_absent:
            is_absent = len(connections[0][1].ports) == len(answers)
        if is_absent:
            yield self._absence(answers, obstacle)
            return
        if obstacle:
            yield Difference("ends", None, len(answers), len(connections[0][1].ports), obstacle)
        for name, expected, actual in _differing(self.wanted, connections[0][1]):
            has = f"{printable(name)}={printable(actual or '')}"
            why = f"is connected with {has}, not {printable(expected)}; rtdis removes that"
            yield Difference("property", name, expected, actual, errors.Refused(self.where, why))

    def _incomplete(self, joined):
        """The Incomplete of a connection that some of the Ports `joined` lack, or with other ends."""
        if not self.leftovers(joined):
            return None
        connection = printable(self.connector.connector_id)
        return Incomplete(self.where, f"connection {connection} is there, but not complete")

    def _absence(self, joined, obstacle):
        """The Difference of a connection that is not there, or not as a whole."""
        obstacle = obstacle or self._obstacle(joined)
        wanted_id = self.connector.connector_id or None
        if len(joined) == 1:
            return Difference("one-port connection", self.connector.interface_type, wanted_id, None, obstacle)
        for other in self.others(joined):
            return Difference("other connection", None, wanted_id, other.id, obstacle)
        actual = next((connector.id for connector in ports.joining(joined)), None)
        return Difference("connection", None, wanted_id, actual, obstacle)

    def _obstacle(self, joined):
        """The error that says why the Ports `joined` cannot be connected, or None.
        A port alone may have several connections.
        """
        try:
            ports.check(joined, self.requested)
        except errors.Error as e:
            return e
        if len(joined) == 1:
            return None
        for other in self.others(joined):
            why = f"already connected with another id ({printable(other.id)}); rtdis removes that"
            return errors.Refused(self.where, why)
        return None

    def other_id(self, joined):
        """The id of a connection in the place of this one that is like it in all but the id; or None."""
        connections = self.connections_between(joined)
        own_id = self.connector.connector_id
        is_other = connections and own_id and connections[0][1].id != own_id
        return connections[0][1].id if is_other else None

    async def act(self, answers):
        await connectors.connect(answers, self.connector.name, self.connector.connector_id, self.requested)

    async def tidy(self, answers):
        await self.disconnect(self.connections_between(errors.split(answers)[0]))

    async def undo(self, before, after):
        await self.tidy(after)


def wanted_properties(connector):
    """{name: value} of the properties that the profile gives, without references to where ports once were."""
    properties = {
        item.name: item.value or ""
        for item in connector.properties
        if item.name and not capture.is_reference(item.name, item.value)
    }
    properties.update(
        ("dataport." + name, getattr(connector, name))
        for name in capture.DATA_FIELDS
        if getattr(connector, name, "")
    )
    return properties


def _agree(name, expected, actual):
    if actual is None:
        return False
    if name == "dataport.data_type":
        return ports.same_type(expected, actual)
    if name in ports.ANY_CASE:
        return expected.lower() == actual.lower()
    return expected == actual


# ---- disconnecting ----


class Disconnect(ConnectionStep):
    """Remove a connection from all of its ends that live."""

    kind = "disconnect"
    tolerant = True
    command = ""  # once it has been seen that it is there

    def _live_ends(self):
        there = [(placement, name) for placement, name in self.ends if placement.error is None]
        return [end for end in there if not isinstance(end[0].port(end[1]), errors.Error)]

    def lost_ports(self):
        """The errors.NoSuch of ends whose component is there without that port."""
        answers = [placement.port(name) for placement, name in self.ends if placement.error is None]
        return errors.split(answers)[1]

    async def is_done(self, answers):
        living, failures = errors.split(answers)
        self.last = self.connections_between(living)
        for port, connector in self.last[:1]:
            self.command = connectors.removal(port, connector, self.is_forced)
        for e in failures + [placement.error for placement in self.placements if placement.error is not None]:
            if not self.last and not placements.is_gone(e):
                raise e
        return not self.last

    async def act(self, answers):
        errors.raise_first(await self.disconnect(self.last))

    async def undo(self, before, after):
        living = errors.split(after)[0]
        removed = self.connections_between(errors.split(before)[0])[0][1]
        properties = {
            name: value for name, value in removed.properties if not capture.is_reference(name, value)
        }
        await connectors.connect(living, removed.name, removed.id, properties)
