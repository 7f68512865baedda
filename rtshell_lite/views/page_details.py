"""What a page shows of one component: all that rtcat -ll and the file have, as headings and rows of (name,
value).
"""

from rtshell_lite.robot import component, ports
from rtshell_lite.system import capture
from rtshell_lite.text import printable
from rtshell_lite.views import describe

LONGEST = 4000  # characters of a text that are shown


class Table:
    """Values by number, each once: most components say the same as others of their kind."""

    def __init__(self):
        self.values = []
        self._numbers = {}

    def number(self, value):
        """The number of a value, which can be hashed."""
        if value not in self._numbers:
            self._numbers[value] = len(self.values)
            self.values.append(value)
        return self._numbers[value]


class Rows:
    """Lists of (name, value) by number: `lists` of numbers of `pairs`, each once."""

    def __init__(self):
        self.lists = Table()
        self.pairs = Table()
        self._pair_numbers = {}  # by what is not escaped yet

    def number(self, pairs):
        """The number of these (name, value)."""
        return self.lists.number(tuple([self._pair_number(name, value or "") for name, value in pairs]))

    def _pair_number(self, name, value):
        number = self._pair_numbers.get((name, value))
        if number is None:
            number = self._pair_numbers[name, value] = self.pairs.number((shown(name), shown(value)))
        return number


def shown(text):
    """A text as a page shows it: what is invisible, or turns other text around, is escaped."""
    if len(text) > LONGEST:
        return shown(text[:LONGEST]) + f"… ({len(text) - LONGEST} more characters)"
    return "\n".join(map(printable, text.split("\n")))


def parts(box):
    """(heading, rows) of a component, a graph.Box."""
    parts_of_box = _of_file(box.origin) if box.snapshot is None else _of_snapshot(box.snapshot)
    for one_set in box.origin.configuration_sets:
        heading = f"Configuration set {one_set.id}"
        if one_set.id == box.origin.active_configuration_set:
            heading += " (active)"
        rows = [(item.name, item.data) for item in one_set.configuration_data]
        parts_of_box.append((heading, rows))
    return [(shown(heading), rows) for heading, rows in parts_of_box if rows]


def port_parts(box):
    """(name, type, rows) of the ports of a component, a graph.Box."""
    if box.snapshot is not None:
        instance = box.snapshot.profile.instance_name
        return [
            (ports.short_name(port.name, instance), port.type, _port_rows(port))
            for port in box.snapshot.ports
        ]
    rows_of_ports = []
    for port in box.origin.data_ports:
        name = ports.short_name(port.name, box.name)
        rows_of_ports.append((name, _data_type(box, name), _file_rows(port)))
    for port in box.origin.service_ports:
        rows_of_ports.append((ports.short_name(port.name, box.name), "CorbaPort", _file_rows(port)))
    return rows_of_ports


# ---- what is running ----


def _of_snapshot(snapshot):
    profile = snapshot.profile
    process = "%s:%s" % tuple(snapshot.node.endpoint)
    tables = [_component(profile._asdict(), [("Parent", profile.parent), ("Process", process)])]
    for organisation in snapshot.organisations:
        members = [("Member", path) for path in snapshot.members.get(organisation.id, ())]
        tables.append(("Composition", [("ID", organisation.id)] + members))
    for organisation_id, name, path in snapshot.composites:
        tables.append((f"Parent composition {name}", [("ID", organisation_id), ("Path", path)]))
    tables += [_context(*pair, snapshot) for pair in zip(snapshot.contexts, snapshot.states)]
    return tables + [("Extra properties", sorted(profile.properties))]


def _component(texts, others):
    """The first part: component.FACTS, those first that are names, then other rows, without empty ones."""
    rows = sorted(component.facts(texts), key=lambda row: not row[0].endswith("name")) + others
    return "Component", [(name, value) for name, value in rows if value]


def _context(context, state, snapshot):
    if context.handle is None:
        return "Execution context of another component, which does not answer", [("State here", state)]
    runs = "Running" if context.running else "Stopped"
    rows = [
        ("State here", state),
        ("Runs", runs),
        ("Kind", context.kind),
        ("Rate", f"{float(context.rate)} Hz"),
        ("Owner", describe.instance(context.owner, snapshot)),
    ]
    rows += [("Participant", describe.instance(ref, snapshot)) for ref in context.participants]
    return f"Execution context {context.handle}", rows + sorted(context.properties)


def _port_rows(port):
    return sorted(port.properties.items()) + [
        (f"interface {interface.instance_name}", f"{interface.type_name}, {interface.polarity}")
        for interface in port.interfaces
    ]


# ---- what a file has ----


def _of_file(described):
    texts = dict(capture.identity(described.id), instance_name=described.instance_name)
    required = "yes" if described.is_required else "no"
    others = [("Id", described.id), ("Required", required), ("Comment", described.comment)]
    tables = [_component(texts, others)]
    members = [("Member", member.component.instance_name) for member in described.participants]
    if members:
        tables.append(("Composition", [("Type", described.composite_type)] + members))
    for context in described.execution_contexts:
        rows = [("Kind", context.kind), ("Rate", f"{context.rate:g} Hz")]
        rows += [("Participant", participant.instance_name) for participant in context.participants]
        tables.append((f"Execution context {context.id}", rows + _properties(context)))
    tables.append(("Properties", _properties(described)))
    return tables


def _data_type(box, port):
    """What kind of data port it is, by the connections in the file, which does not say it."""
    if port in box.left:
        return "DataInPort"
    if port in box.right:
        return "DataOutPort"
    return "Data port"


def _file_rows(port):
    rows = _properties(port)
    if port.comment:
        rows.insert(0, ("Comment", port.comment))
    return rows


def _properties(element):
    return [(item.name, item.value) for item in element.properties]


def connection_rows(connector):
    """Rows of a connection, a model.Connector."""
    return [
        (item.name, item.value)
        for item in connector.properties
        if not capture.is_reference(item.name, item.value)
    ]
