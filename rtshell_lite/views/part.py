"""Which part of a large system is drawn: some of its boxes, the neighbourhood of one, groups folded into a
box each.
"""

import collections
import fnmatch

from rtshell_lite.text import printable
from rtshell_lite.views import graph

KINDS = ("none", "composite", "process", "directory", "host")  # of groups, the finest first
MOST = 30  # boxes that a person can overlook


# ---- some of the boxes ----


def keep(picture, numbers):
    """The graph.Graph of these boxes and of what connects them."""
    kept = [number for number in range(len(picture.boxes)) if number in numbers]
    new_numbers = {number: new_number for new_number, number in enumerate(kept)}
    boxes = [_copy(picture.boxes[number], new_numbers) for number in kept]
    return _connected(picture, boxes, new_numbers)


def below(picture, paths):
    """Numbers of the boxes at or below these Paths."""
    tops = [(top.server, top.names) for top in paths]
    return {
        number
        for number, box in enumerate(picture.boxes)
        if any(_is_below(box.path, server, names) for server, names in tops)
    }


def _is_below(where, server, names):
    if where is None:
        return False
    return server in (None, where.server) and where.names[: len(names)] == names


def at(picture, paths):
    """Numbers of the boxes of the components at these Paths."""
    objects = {(path.server, path.names) for path in paths}
    return {
        number
        for number, box in enumerate(picture.boxes)
        if box.path and (box.path.server, box.path.names) in objects
    }


def matching(picture, pattern):
    """Numbers of the boxes whose name, or whose path, a GLOB matches."""
    return {
        number
        for number, box in enumerate(picture.boxes)
        if fnmatch.fnmatchcase(box.name, pattern) or fnmatch.fnmatchcase(str(box.path), pattern)
    }


def neighbours(picture, numbers, hops=1, upstream=True, downstream=True):
    """These boxes and those that connections lead to from them, over as many as `hops` of them, against
    the data (upstream), with it, or both ways.
    """
    ways = collections.defaultdict(set)
    for source, _, target, _, _ in picture.edges:
        if downstream:
            ways[source].add(target)
        if upstream:
            ways[target].add(source)
    reached = set(numbers)
    front = reached
    for _ in range(hops):
        front = {other for number in front for other in ways[number]} - reached
        if not front:
            break
        reached = reached | front
    return reached


# ---- groups ----


def fold(picture, kind, opened=(), alone=(), labels=None):
    """The graph.Graph with groups of this kind (of KINDS) as one box each, but for those named in `opened`;
    the boxes with numbers in `alone` are in none. `labels`: {name of a group: what its box is called}, where
    that is not its name.

    A group of one component is that component. Parallel connections are one, labelled with their number.
    """
    groups = members(picture, kind, alone)
    boxes = []
    new_numbers = {}
    singles = {}
    folded = set()
    for number in range(len(picture.boxes)):
        if number in new_numbers:
            continue
        name = group_name(picture, number, kind)
        inside = groups.get(name, ())
        if len(inside) < 2 or name in opened or number in alone:
            new_numbers[number] = singles[number] = len(boxes)
            boxes.append(picture.boxes[number])
            continue
        for member in inside:
            new_numbers[member] = len(boxes)
        folded.add(len(boxes))
        label = (labels or {}).get(name, name)
        boxes.append(_folded(label, [picture.boxes[member] for member in inside]))
    for number, box in enumerate(boxes):
        if number not in folded:
            boxes[number] = _copy(box, singles)
    return _connected(picture, boxes, new_numbers, folded)


def choose_kind(picture, most=MOST):
    """The first kind in `preference` that leaves at most `most` boxes; the last if every kind leaves more."""
    kinds = preference(picture)
    for kind in kinds:
        if len(fold(picture, kind).boxes) <= most:
            return kind
    return kinds[-1]


def preference(picture):
    """KINDS in the order in which they are tried: directories, which have names, before processes if they
    divide a system about as well.
    """
    directory_count = len(members(picture, "directory"))
    if directory_count < 2 or 2 * directory_count < len(members(picture, "process")):
        return KINDS
    return ("none", "directory", "composite", "process", "host")


def groups(picture, kind, alone=()):
    """Names of the groups of this kind that are folded, sorted; see `fold`."""
    return sorted(name for name, members in members(picture, kind, alone).items() if len(members) > 1)


def members(picture, kind, alone=()):
    """{name of a group of this kind: numbers of its boxes}, without those in `alone`."""
    groups = collections.defaultdict(list)
    for number in range(len(picture.boxes)):
        name = group_name(picture, number, kind)
        if name is not None and number not in alone:
            groups[name].append(number)
    return groups


def group_name(picture, number, kind):
    """The name of the group that a box is in, spelt for the terminal; None if it is in none."""
    box = picture.boxes[number]
    if kind == "composite":
        return _composite(picture, number)
    if kind == "process" and box.process:
        return "%s:%d" % (printable(box.process[0]), box.process[1])
    if kind == "directory" and box.path:
        return str(box.path.parent())
    if kind == "host":
        return _host(box)
    return None


def directories(box):
    """The directories that a box is in, the outermost first, spelt for the terminal."""
    if box.path is None:
        return []
    where = box.path.parent()
    above = [str(where)]
    while where.names:
        where = where.parent()
        above.append(str(where))
    return above[::-1]


def _composite(picture, number):
    """The name of the outermost composite around a box."""
    inside = number
    while picture.boxes[inside].composite is not None:
        inside = picture.boxes[inside].composite
    if inside == number and not picture.boxes[number].members:
        return None
    return printable(picture.boxes[inside].name)


def _host(box):
    """The host of a component, by the naming context that is named after it, else by its process or name
    server.
    """
    if box.path is None:
        return None
    for name in box.path.names:
        if name.kind == "host_cxt":
            return printable(name.id)
    if box.process:
        return printable(box.process[0])
    return box.path.server and printable(box.path.server)


def _folded(name, boxes):
    folded = graph.Box(name)
    folded.counts = collections.Counter(box.state or "" for box in boxes)
    states = set(folded.counts)
    if "Error" in states:
        folded.state = "Error"
    elif len(states) == 1:
        folded.state = boxes[0].state
    return folded


# ---- a new picture out of an old one ----


def _copy(box, new_numbers):
    """A box without its ports, whose members and composite get these `new_numbers`."""
    copy = graph.Box(box.name, box.state, box.missing)
    copy.path = box.path
    copy.process = box.process
    copy.origin = box.origin
    copy.snapshot = box.snapshot
    copy.counts = box.counts
    copy.labels = dict(box.labels)
    copy.members = [new_numbers[member] for member in box.members if member in new_numbers]
    copy.composite = new_numbers.get(box.composite)
    return copy


def _connected(picture, boxes, new_numbers, folded=()):
    """The Graph of boxes that hold those of a picture, by `new_numbers`; of those in `folded`, ports are not
    shown.
    """
    edges = []
    parallel = collections.OrderedDict()
    for source, out, target, into, service in picture.edges:
        if source not in new_numbers or target not in new_numbers:
            continue
        start, end = new_numbers[source], new_numbers[target]
        if start not in folded and end not in folded:
            edges.append((start, out, end, into, service))
        elif start != end:
            parallel.setdefault((start, end, service), []).append((out, into))
    for (start, end, service), both in parallel.items():
        edges.append(_joined(boxes, folded, start, end, service, both))
    for start, out, end, into, _ in edges:
        boxes[start].use(out, boxes[start].right)
        boxes[end].use(into, boxes[end].left)
    tops = [number for number, box in enumerate(boxes) if box.composite is None]
    return graph.Graph(boxes, edges, tops)


def _joined(boxes, folded, start, end, service, both):
    """The edge for parallel ones; its number is a label of where it ends."""
    if start in folded:
        out = "services" if service else "data"
    else:
        out = _one([out for out, _ in both])
    into = "from " + boxes[start].name if end in folded else _one([into for _, into in both])
    if service and end in folded:
        into += " (services)"
    if len(both) > 1:
        label = f"×{len(both)}"
        before = boxes[end].labels.get(into)
        boxes[end].labels[into] = f"{before}, {label}" if before else label
    return start, out, end, into, service


def _one(ports):
    """The name of the only port, or how many there are."""
    distinct = set(ports)
    return ports[0] if len(distinct) == 1 else f"{len(distinct)} ports"
