"""A system as a picture: boxes for components, with their connected ports, and lines between them;
as DOT for Graphviz.
"""

import collections
import re

from rtshell_lite.system import capture
from rtshell_lite.text import printable
from rtshell_lite.xmlprofile import model

# A picture. `edges` are (from box, from port, to box, to port, True for a service) with indexes of boxes, and
# port names; `tops` are indexes of the boxes that are not members of a composite.
Graph = collections.namedtuple("Graph", "boxes edges tops")

COLOURS = {
    "Inactive": "lightblue",
    "Active": "palegreen",
    "Error": "salmon",
    "Created": "white",
    "Unknown": "lightgrey",
}
INDENTED = 50  # levels: nobody reads more
_KEYWORDS = {"node", "edge", "graph", "digraph", "subgraph", "strict"}
_COMPASS = {"n", "ne", "e", "se", "s", "sw", "w", "nw", "c", "_"}


class Box:
    """A component: its name, ports in use on either side, indexes of its members.

    `state` is None if unknown. `missing` marks one that connections name, but that the profile does not have.
    """

    def __init__(self, name, state=None, missing=False):
        self.name = name
        self.state = state
        self.missing = missing
        self.left = []
        self.right = []
        self.members = []

    def use(self, port, side):
        """Note a port in use, on the first side where it is."""
        if port not in self.left + self.right:
            side.append(port)


# ---- from a profile ----------------------------------------------------------------------------------------


def of(profile, states=None):
    """The Graph of an RtsProfile. `states` gives those of its components, by path_uri."""
    states = states or {}
    boxes = [Box(component.instance_name, states.get(component.path_uri)) for component in profile.components]
    numbers = {id(component): number for number, component in enumerate(profile.components)}
    locate = capture.locator(profile)
    strangers = {}

    def box_of(end):
        component = locate(end)
        if component is not None:
            return numbers[id(component)]
        key = (end.component_id, end.instance_name)
        if key not in strangers:
            strangers[key] = len(boxes)
            boxes.append(Box(end.instance_name, missing=True))
        return strangers[key]

    def box_of_transport(connector):
        key = connector.interface_type
        if key not in strangers:
            strangers[key] = len(boxes)
            boxes.append(Box(key))
        return strangers[key]

    edges = []
    for connector in profile.connectors:
        if len(connector.ends) == 1:
            edges.append(_edge_alone(connector, boxes, box_of, box_of_transport(connector)))
            continue
        edges += _edges(connector, isinstance(connector, model.ServicePortConnector), boxes, box_of)
    tops = _compose(profile, boxes, numbers, locate)
    return Graph(boxes, list(collections.OrderedDict.fromkeys(edges)), tops)


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
    inside = {numbers[member] for member in parents}
    return [number for number in range(len(boxes)) if number not in inside]


# ---- what drawings share -----------------------------------------------------------------------------------


def heads(graph, number):
    """The lines at the top of a box: name, state and composites around it; its members."""
    box = graph.boxes[number]
    words = [printable(box.name)]
    if box.missing:
        words.append("(not in the profile)")
    if box.state is not None:
        words.append(box.state)
    words += [f"(in {printable(composite.name)})" for composite in graph.boxes if number in composite.members]
    if box.members:
        members = ["made of " + ", ".join(printable(graph.boxes[member].name) for member in box.members)]
    else:
        members = []
    return ["  ".join(words)] + members


def in_order(graph):
    """Numbers of the boxes, so that data flows downwards where it can;
    circles in the order of the profile.
    """
    waiting = collections.OrderedDict.fromkeys(range(len(graph.boxes)))
    order = []
    above = {number: set() for number in waiting}
    for source, _, target, _, service in graph.edges:
        if source != target and not service:
            above[target].add(source)
    below = {number: [target for target in above if number in above[target]] for number in waiting}
    left = {number: len(above[number]) for number in waiting}
    ready = collections.deque(number for number in waiting if not left[number])
    while waiting:
        if ready:
            number = ready.popleft()
        else:
            number = next(iter(waiting))
        if number not in waiting:
            continue
        del waiting[number]
        order.append(number)
        for target in reversed(below[number]):
            left[target] -= 1
            if not left[target]:
                ready.appendleft(target)
    return order


# ---- DOT ---------------------------------------------------------------------------------------------------


def dot(graph):
    """Lines of DOT."""
    names = _distinct([_word(box.name) for box in graph.boxes])
    yield "digraph rtsprofile {"
    yield "  rankdir=LR;"
    yield "  node [shape=Mrecord];"
    ports = []
    for name, box in zip(names, graph.boxes):
        ids = _port_ids(box)
        ports.append(ids)
        if not box.members or box.left or box.right:
            yield f"  {_node_id(name)} [{', '.join(_attributes(box, ids))}];"
    yield from _clusters(graph, names)
    for service in (False, True):
        if service:
            style = ' [arrowhead="odot"]'
        else:
            style = ""
        for source, out, target, into, is_service in graph.edges:
            if is_service == service:
                ends = f"{_node_id(names[source])}:{ports[source][out]} -> {_node_id(names[target])}:{ports[target][into]}"
                yield f"  {ends}{style};"
    yield "}"


def _attributes(box, ids):
    cells = ["|".join(f"<{ids[port]}>{_label(port)}" for port in side) for side in (box.left, box.right)]
    attributes = ['label="{{%s}|%s|{%s}}"' % (cells[0], _label(box.name), cells[1])]
    if box.missing:
        attributes.append("style=dashed")
    elif box.state is not None:
        attributes.append(f"style=filled, fillcolor={COLOURS.get(box.state, 'lightgrey')}")
    return attributes


def _clusters(graph, names):
    """Composites around their members, however deep; one with ports of its own is inside, too."""
    levels = [(None, iter(graph.tops))]  # composites around this place, and the rest of each
    while levels:
        composite, rest = levels[-1]
        number = next(rest, None)
        if number is None:
            levels.pop()
            if levels:
                yield _indent(levels) + "}"
        elif number == composite or not graph.boxes[number].members:
            if composite is not None:
                yield f"{_indent(levels)}{_node_id(names[number])};"
        else:
            box = graph.boxes[number]
            yield "%ssubgraph %s {" % (_indent(levels), _node_id("cluster_" + names[number]))
            levels.append((number, iter([number] * bool(box.left or box.right) + box.members)))
            yield f'{_indent(levels)}label="{_label(box.name)}";'
            if box.state is not None:
                yield f"{_indent(levels)}bgcolor={COLOURS.get(box.state, 'lightgrey')};"


def _indent(levels):
    return "  " * min(len(levels), INDENTED)


def _word(name):
    """A component's name as rtshell spells it in DOT."""
    for character, word in ((".", "_dot_"), ("/", "_slash_"), ("(", "_lpar_"), (")", "_rpar_")):
        name = name.replace(character, word)
    return printable(name) or "_"


def _distinct(names):
    """The names, with numbers added to those that were used before."""
    seen = set()
    distinct = []
    for name in names:
        number = 1
        wanted = name
        while wanted in seen:
            number, wanted = number + 1, f"{name}_{number + 1}"
        seen.add(wanted)
        distinct.append(wanted)
    return distinct


def node_id(name):
    """A component's name as an identifier in DOT, as rtshell spells it."""
    return _node_id(_word(name))


def _node_id(name):
    if re.match(r"[A-Za-z_][A-Za-z_0-9]*\Z", name) and name.lower() not in _KEYWORDS:
        return name
    return '"%s"' % name.replace("\\", "\\\\").replace('"', '\\"')


def _port_ids(box):
    """An identifier for each port of a box: the part of its name after the last dot, or a number."""
    ids = {}
    for number, port in enumerate(box.left + box.right, 1):
        short = port.rpartition(".")[2]
        plain = (
            re.match(r"[A-Za-z_][A-Za-z_0-9]*\Z", short)
            and short.lower() not in _KEYWORDS
            and short not in _COMPASS
        )
        if plain and short not in ids.values():
            ids[port] = short
        else:
            ids[port] = f"port{number}"
    return ids


def _label(name):
    """`name` for a record label, where brackets, bars, blanks and entities have a meaning."""
    spelt = printable(name).replace("\\", "\\\\").replace("&", "&amp;").replace('"', '\\"')
    return re.sub(r"([{}|<> ])", r"\\\1", spelt)
