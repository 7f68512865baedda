"""A system as a picture: boxes for components, with their connected ports, and lines between them."""

import collections

from rtshell_lite import errors
from rtshell_lite.system import capture
from rtshell_lite.text import printable
from rtshell_lite.xmlprofile import model

# A picture. `edges` are (from box, from port, to box, to port, True for a service) with indexes of boxes, and
# port names; `tops` are indexes of the boxes that are not members of a composite.
Graph = collections.namedtuple("Graph", "boxes edges tops")

# A picture, the RtsProfile that it shows, what was found of each component or failed (errors.Error), lines on
# what is left out.
Drawing = collections.namedtuple("Drawing", "picture profile results notes")

COLOURS = {
    "Inactive": "lightblue",
    "Active": "palegreen",
    "Error": "salmon",
    "Created": "white",
    "Unknown": "lightgrey",
}


class Box:
    """A component: its name, ports in use on either side, indexes of its members.

    state      None if unknown
    missing    it is named by connections, but the profile does not have it
    path       the path.Path where it is bound, None if unknown
    process    (host, port) of its process, None if unknown
    composite  index of the composite whose member it is, None if it is no member
    counts     of a folded group: how many components are in each state ("" if unknown), else None
    labels     {port: words after its name}: rates, numbers of connections
    origin     what it is in the profile: a model.Component; where that is missing the (component id, instance
               name) of ends of connections; of what carries data the name of the transport
    snapshot   the snapshot.Snapshot of a component that was asked for everything, else None
    """

    def __init__(self, name, state=None, missing=False):
        self.name = name
        self.state = state
        self.missing = missing
        self.path = None
        self.process = None
        self.composite = None
        self.counts = None
        self.labels = {}
        self.origin = None
        self.snapshot = None
        self.left = []
        self.right = []
        self.members = []

    def port_words(self, port):
        """The name of a port, and what is known of it."""
        return " ".join(filter(None, (port, self.labels.get(port))))

    def use(self, port, side):
        """Note a port in use, on the first side where it is."""
        if port not in self.left + self.right:
            side.append(port)


# ---- from a profile ----


def of(profile, states=None):
    """The Graph of an RtsProfile. `states` gives those of its components, by path_uri."""
    states = states or {}
    boxes = [_box(component, states) for component in profile.components]
    numbers = {id(component): number for number, component in enumerate(profile.components)}
    locate = capture.locator(profile)
    strangers = {}

    def stranger(key, name, missing):
        if key not in strangers:
            strangers[key] = len(boxes)
            boxes.append(Box(name, missing=missing))
            boxes[-1].origin = key
        return strangers[key]

    def box_of(end):
        component = locate(end)
        if component is not None:
            return numbers[id(component)]
        return stranger((end.component_id, end.instance_name), end.instance_name, True)

    edges = []
    for connector in profile.connectors:
        if len(connector.ends) == 1:
            transport = stranger(connector.interface_type, connector.interface_type, False)
            edges.append(_edge_alone(connector, boxes, box_of, transport))
            continue
        edges += _edges(connector, isinstance(connector, model.ServicePortConnector), boxes, box_of)
    tops = _compose(profile, boxes, numbers, locate)
    return Graph(boxes, list(collections.OrderedDict.fromkeys(edges)), tops)


def _box(component, states):
    box = Box(component.instance_name, states.get(component.path_uri))
    box.origin = component
    try:
        box.path = capture.path_of(component)
    except errors.BadPath:
        pass  # it can be drawn all the same
    return box


def _edges(connector, service, boxes, box_of):
    """Edges from the first end to each other one."""
    ends = [(box_of(end), capture.port_of(end)) for end in connector.ends]
    for number, (box, port) in enumerate(ends):
        boxes[box].use(port, boxes[box].left if number else boxes[box].right)
    return [ends[0] + end + (service,) for end in ends[1:]]


def _edge_alone(connector, boxes, box_of, transport):
    """The Edge between a port that is connected alone and the box of what carries its data."""
    (end,) = connector.ends
    box = box_of(end)
    port = capture.port_of(end)
    if connector.source is None:
        boxes[box].use(port, boxes[box].left)
        boxes[transport].use("", boxes[transport].right)
        return transport, "", box, port, False
    boxes[box].use(port, boxes[box].right)
    boxes[transport].use("", boxes[transport].left)
    return box, port, transport, "", False


def _compose(profile, boxes, numbers, locate):
    """Put members into their composites, each into one and none into itself; returns the boxes outside."""
    parents = {}
    for component in profile.components:
        for participant in component.participants:
            member = locate(participant.component)
            if member is None or id(member) in parents:
                continue
            above = id(component)
            while above in parents and above != id(member):
                above = parents[above]
            if above != id(member):
                parents[id(member)] = id(component)
                boxes[numbers[id(component)]].members.append(numbers[id(member)])
                boxes[numbers[id(member)]].composite = numbers[id(component)]
    inside = {numbers[member] for member in parents}
    return [number for number in range(len(boxes)) if number not in inside]


# ---- what drawings share ----


def count_words(box):
    """[] of a component; of a folded group how many components it has, and in which states."""
    if box.counts is None:
        return []
    total = sum(box.counts.values())
    words = [f"{total} component" + "s" * (total != 1)]
    states = [state for state in COLOURS if box.counts[state]]
    states += sorted(state for state in box.counts if state and state not in COLOURS)
    if states:
        words.append(", ".join(f"{box.counts[state]} {state}" for state in states))
    return words


def heads(graph, number, labels=None):
    """The lines at the top of a box: name, state and composites around it; its members. `labels`, {number:
    label}, tell boxes of the same name apart.
    """
    box = graph.boxes[number]
    words = [name_of(graph, number, labels or {})]
    if box.missing:
        words.append("(not in the profile)")
    if box.state is not None and box.counts is None:
        words.append(box.state)
    if box.composite is not None:
        words.append(f"(in {printable(graph.boxes[box.composite].name)})")
    lines = ["  ".join(words)] + count_words(box)
    if box.members:
        lines.append("made of " + ", ".join(printable(graph.boxes[member].name) for member in box.members))
    return lines


def name_of(graph, number, labels):
    """What a drawing calls a box."""
    return labels.get(number) or printable(graph.boxes[number].name)
