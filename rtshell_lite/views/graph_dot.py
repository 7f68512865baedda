"""A system in the language of Graphviz."""

import re

from rtshell_lite.text import printable
from rtshell_lite.views import graph, group_names

INDENTED = 50  # levels: nobody reads more
_KEYWORDS = {"node", "edge", "graph", "digraph", "subgraph", "strict"}
_COMPASS = {"n", "ne", "e", "se", "s", "sw", "w", "nw", "c", "_"}
_STYLES = {False: "", True: ' [arrowhead="odot"]'}  # by whether it is a service


def lines(picture):
    """Lines of DOT for a graph.Graph."""
    names = _distinct([_word(box.name) for box in picture.boxes])
    yield "digraph rtsprofile {"
    yield "  rankdir=LR;"
    yield "  node [shape=Mrecord];"
    ports = []
    labels = group_names.of_boxes(picture)
    for number, (name, box) in enumerate(zip(names, picture.boxes)):
        ids = _port_ids(box)
        ports.append(ids)
        if not box.members or box.left or box.right:
            attributes = _attributes(box, ids, graph.name_of(picture, number, labels))
            yield f"  {_node_id(name)} [{', '.join(attributes)}];"
    yield from _clusters(picture, names, labels)
    for service in (False, True):
        for source, out, target, into, is_service in picture.edges:
            if is_service == service:
                ends = (
                    f"{_node_id(names[source])}:{ports[source][out]} -> "
                    f"{_node_id(names[target])}:{ports[target][into]}"
                )
                yield f"  {ends}{_STYLES[service]};"
    yield "}"


def _attributes(box, ids, box_name):
    cells = [
        "|".join(f"<{ids[port]}>{_quoted(printable(box.port_words(port)))}" for port in side)
        for side in (box.left, box.right)
    ]
    name = _quoted("  ".join([box_name] + graph.count_words(box)))
    attributes = ['label="{{%s}|%s|{%s}}"' % (cells[0], name, cells[1])]
    if box.missing:
        attributes.append("style=dashed")
    elif box.state is not None:
        attributes.append(f"style=filled, fillcolor={graph.COLOURS.get(box.state, 'lightgrey')}")
    return attributes


def _clusters(picture, names, labels):
    """Composites around their members, however deep; one with ports of its own is inside, too."""
    levels = [(None, iter(picture.tops))]  # composites around this place, and the rest of each
    while levels:
        composite, rest = levels[-1]
        number = next(rest, None)
        if number is None:
            levels.pop()
            if levels:
                yield _indent(levels) + "}"
        elif number == composite or not picture.boxes[number].members:
            if composite is not None:
                yield f"{_indent(levels)}{_node_id(names[number])};"
        else:
            box = picture.boxes[number]
            yield "%ssubgraph %s {" % (_indent(levels), _node_id("cluster_" + names[number]))
            levels.append((number, iter([number] * bool(box.left or box.right) + box.members)))
            yield f'{_indent(levels)}label="{_quoted(graph.name_of(picture, number, labels))}";'
            if box.state is not None:
                yield f"{_indent(levels)}bgcolor={graph.COLOURS.get(box.state, 'lightgrey')};"


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
        new_name = name
        while new_name in seen:
            number += 1
            new_name = f"{name}_{number}"
        seen.add(new_name)
        distinct.append(new_name)
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
        plain = _node_id(short) == short and short not in _COMPASS
        ids[port] = short if plain and short not in ids.values() else f"port{number}"
    return ids


def _quoted(words):
    """What can be printed, for a record label, where brackets, bars, blanks and entities have a meaning."""
    spelt = words.replace("\\", "\\\\").replace("&", "&amp;").replace('"', '\\"')
    return re.sub(r"([{}|<> ])", r"\\\1", spelt)
