"""The groups of a page: for each kind of groups a tree, and what each group of it is made of in the order in
which the page stacks it: rows of columns, from the left and from above.
"""

import collections
import math

from rtshell_lite.views import group_names, part
from rtshell_lite.views.layered import sheet
from rtshell_lite.views.page_details import Table, shown

# pixels, as in web/layout.js
_CELL = 8.5
_ROW = 20
_GAP = 24  # between boxes

_FAR = 6  # layers that lines pass that count for the order; of _MANY boxes in a group only one
_MANY = 200
_DEEPEST = 20  # directories in directories that are told apart

# A group of a tree: its kind (a number in part.KINDS), what --open calls it, numbers of all its boxes, what
# it is made of: Groups and numbers of boxes
Group = collections.namedtuple("Group", "kind key numbers children")


def of(picture):
    """(groups, trees) of a graph.Graph: for each group [kind, key, label, rows]; for each kind the number of
    the group of all.

    A row is a list of columns, a column [child, y, child, y …] from above: a child is the number of a box, or
    -1 less the number of a group; y in pixels below the upper end of the row if all groups are closed.
    """
    groups = Table()
    rows = {}
    trees = []
    for kind in range(len(part.KINDS)):
        paths = [_path(picture, number, kind) for number in range(len(picture.boxes))]
        numbers = list(range(len(picture.boxes)))
        root = Group(kind, "", numbers, _children(numbers, 0, kind, paths))
        trees.append(_number(picture, root, "", picture.edges, groups, rows))
    return groups.values, trees


# ---- which groups ----


def _path(picture, number, kind):
    """((kind, key) of each group that a box may be in, the outermost first)."""
    steps = []
    directory, host = part.KINDS.index("directory"), part.KINDS.index("host")
    if kind == host:
        steps.append((host, part.group_name(picture, number, "host")))
    if kind >= directory:
        steps += [(directory, name) for name in part.directories(picture.boxes[number])[:_DEEPEST]]
    if kind > 1:
        steps.append((2, part.group_name(picture, number, "process")))
    if kind:
        steps.append((1, part.group_name(picture, number, "composite")))
    return [step for step in steps if step[1] is not None]


def _children(numbers, depth, kind, paths):
    """Groups, and numbers of boxes that are in none: of one box, there is no group."""
    while True:
        members = collections.OrderedDict()
        for number in numbers:
            step = paths[number][depth] if depth < len(paths[number]) else None
            if step is None or step[0] < min(kind, 3) and len(numbers) <= part.MOST:
                step = number  # directories divide what is in a host; else groups of another kind only many
            members.setdefault(step, []).append(number)
        if len(members) > 1 or members and isinstance(next(iter(members)), int):
            break
        if not members:
            return []
        depth += 1  # this group is all that there is
    children = []
    for step, inner in members.items():
        if len(inner) == 1:
            children.append(inner[0])
        else:
            own_kind, key = _deepest(step, inner, depth, paths)
            children.append(Group(own_kind, key, inner, _children(inner, depth + 1, kind, paths)))
    return children


def _deepest(step, numbers, depth, paths):
    """(kind, key) of a group: of a directory with nothing but a directory, that one."""
    for deeper in zip(*(paths[number][depth + 1 :] for number in numbers)):
        if deeper[0][0] != step[0] or len(set(deeper)) > 1:
            break
        step = deeper[0]
    return step


def _number(picture, group, label, edges, groups, known_rows):
    """The number of a Group in the Table `groups`; `known_rows` by what groups consist of."""
    child_of = {}
    for index, child in enumerate(group.children):
        for number in _numbers(child):
            child_of[number] = index
    inner = [[] for _ in group.children]
    between = []
    for edge in edges:
        source, target = child_of[edge[0]], child_of[edge[2]]
        if source == target and isinstance(group.children[source], Group):
            inner[source].append(edge)
        else:
            between.append((source, target, edge))
    labels = iter(group_names.of_groups(
        picture, [child for child in group.children if isinstance(child, Group)], group.numbers
    ))
    places = []
    for child, edges_inside in zip(group.children, inner):
        if isinstance(child, Group):
            places.append(-1 - _number(picture, child, next(labels), edges_inside, groups, known_rows))
        else:
            places.append(child)
    key = tuple(tuple(_numbers(child)) for child in group.children)
    if key not in known_rows:
        known_rows[key] = _rows(picture, group.children, between)
    rows = tuple(
        tuple(tuple(value for index, y in column for value in (places[index], y)) for column in row)
        for row in known_rows[key]
    )
    return groups.number((group.kind, shown(group.key), shown(label), rows))


def _numbers(child):
    return child.numbers if isinstance(child, Group) else (child,)


# ---- in which order ----


def _rows(picture, children, between):
    """Rows of columns, [(index of a child, y)], of what lines join, (index of the source, that of the target,
    edge); the unconnected come last.
    """
    sizes = [_size(picture, child) for child in children]
    lines = list(collections.OrderedDict.fromkeys(
        sheet.Line(source, target, _port(picture, children[source], edge[1], 1, sizes[source]),
                   _port(picture, children[target], edge[3], 0, sizes[target]), edge[4])
        for source, target, edge in between
    ))
    parts, alone = sheet.parts(lines, sizes, _FAR if len(sizes) < _MANY else 1)
    blocks = [(block.settle(), block) for block in parts]
    blocks.sort(key=lambda block: -block[0][1])
    area = sum((width + sheet.APART) * (height + sheet.APART) for (width, height), _ in blocks)
    area += sum((sizes[index][0] + _GAP) * (sizes[index][1] + _GAP) for index in alone)
    widest = max([math.sqrt(area * sheet.PAGE[0] / sheet.PAGE[1])] + [size[0] for size, _ in blocks])
    rows = []
    room = 0
    for (width, _), block in blocks:
        inner = [_columns(row) for row in block.rows]
        if len(inner) == 1 and width < room:
            rows[-1] += inner[0]
            room -= width + sheet.APART
        else:
            rows += inner
            room = widest - width - sheet.APART if len(inner) == 1 else 0
    if alone:
        rows.append(_strip(picture, children, alone, sizes, widest))
    return rows


def _columns(row):
    """The columns of a lines.Row: [(index of a child, y)]."""
    boxes = [[item for item in items if item.number is not None] for items in row.layers]
    top = min(item.y for items in boxes for item in items)
    return [[(item.number, item.y - top) for item in items] for items in boxes if items]


def _strip(picture, children, alone, sizes, widest):
    """Columns of what is not connected, by name from left to right and then below."""
    names = [child.key if isinstance(child, Group) else picture.boxes[child].name for child in children]
    alone = sheet.by_name(alone, names)
    across = max(1, int(widest // (max(sizes[index][0] for index in alone) + _GAP)))
    columns = []
    for start in range(min(across, len(alone))):
        column = []
        y = 0
        for index in alone[start::across]:
            column.append((index, y))
            y += sizes[index][1] + _GAP
        columns.append(column)
    return columns


def _size(picture, child):
    """(width, height) of the box of a child, about: names are of any width."""
    if isinstance(child, Group):
        return 240, 4 * _ROW
    box = picture.boxes[child]
    ports = max(len(box.left), len(box.right))
    words = max(map(len, box.left), default=0) + max(map(len, box.right), default=0) + 3
    return int((max(words, len(box.name)) + 2) * _CELL), int((2 + ports) * _ROW + _ROW / 2)


def _port(picture, child, port, side, size):
    """(y, side) of a line on a child."""
    if isinstance(child, Group):
        return size[1] // 2, side
    box = picture.boxes[child]
    ports = box.right if port in box.right else box.left
    return (2 + ports.index(port)) * _ROW + 15, int(ports is box.right)
