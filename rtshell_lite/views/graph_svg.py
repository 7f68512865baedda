"""A system as SVG: boxes in columns as the data flows, from left to right, and lines between their ports.

The layout is the usual one for such graphs, in its simplest form (Sugiyama, Tagawa, Toda 1981): a column for
each box by the longest way to it, places within a column by those of its neighbours, and lines below all
boxes for what goes back or far.
"""

import collections

from rtshell_lite.text import cells, printable
from rtshell_lite.views import graph

# pixels: width of a character, height of a line of text
_CELL = 9
_ROW = 20
# pixels between columns, and between boxes in one
_BESIDE = 90
_BELOW = 24
_MARGIN = 40
_LANE = 10  # pixels between lines below the boxes
_FAR = 8  # columns; lines that cross more of them go below
_SWEEPS = 4  # times that the places are improved, forwards and backwards

_HEAD = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d" font-family="monospace" font-size="14">\n'
    '<defs><marker id="arrow" markerWidth="8" markerHeight="8" refX="7" refY="4" orient="auto">'
    '<path d="M0,0 L8,4 L0,8 z"/></marker><marker id="dot" markerWidth="9" markerHeight="9" refX="7" refY="4">'
    '<circle cx="4" cy="4" r="3" fill="white" stroke="black"/></marker></defs>\n'
    '<rect width="100%%" height="100%%" fill="white"/>'
)


class _Item:
    """A box, or a line that passes (`box` is None), in a column. x, y: its upper left corner."""

    def __init__(self, box=None, heads=()):
        self.box = box
        self.heads = heads
        self.x = self.y = self.place = 0
        # Items in the columns to the left and right that lines lead to
        self.before = []
        self.after = []
        self.width = self.height = 0
        if box is not None:
            sides = [max([cells(printable(port)) for port in side] or [0]) for side in (box.left, box.right)]
            self.width = (max([sum(sides) + 3] + [cells(head) for head in heads]) + 1) * _CELL
            self.height = (len(heads) + max(len(box.left), len(box.right))) * _ROW + _ROW // 2

    @property
    def middle(self):
        return self.y + self.height / 2

    def port(self, name):
        """(x, y, 1 on the right side and -1 on the left) of a port."""
        right = name in self.box.right
        row = len(self.heads) + (self.box.right if right else self.box.left).index(name)
        return self.x + self.width * right, self.y + row * _ROW + 15, 1 if right else -1


def lines(picture):
    """The lines of an SVG file that shows a graph.Graph; boxes are coloured by their states."""
    boxes = [_Item(box, graph.heads(picture, number)) for number, box in enumerate(picture.boxes)]
    columns, ways = _columns(picture, boxes)
    _sort(columns)
    _place(columns)
    around = [edge for edge, way in zip(picture.edges, ways) if way is None]
    bottom = max([item.y + item.height for item in boxes] or [0]) + _MARGIN
    width = max([item.x + item.width for item in boxes] or [0]) + _MARGIN + (_LANE * 4 if around else 0)
    yield _HEAD % (width, bottom + len(around) * _LANE)
    for item in boxes:
        yield from _drawn(item)
    lane = bottom - _MARGIN // 2
    for edge, way in zip(picture.edges, ways):
        yield _line(edge, boxes, way, lane)
        lane += _LANE * (way is None)
    yield "</svg>"


# ---- where things are --------------------------------------------------------------------------------------


def _columns(picture, boxes):
    """(columns, lists of Items; for each edge the Items that it passes, None for one that goes below)."""
    order = graph.in_order(picture)
    rank = {number: place for place, number in enumerate(order)}
    sources = collections.defaultdict(list)
    for source, _, target, _, _ in picture.edges:
        if rank[source] < rank[target]:
            sources[target].append(source)
    column = {}
    for number in order:
        column[number] = max([column[source] + 1 for source in sources[number]] or [0])
    columns = [[] for _ in range(max(list(column.values()) or [0]) + 1)]
    used = {number for edge in picture.edges for number in (edge[0], edge[2])}
    for number in order:
        if number in used:
            columns[column[number]].append(boxes[number])
    for number in order:
        if number not in used:  # anywhere will do
            min(columns, key=lambda items: sum(item.height + _BELOW for item in items)).append(boxes[number])
    ways = []
    for source, _, target, _, _ in picture.edges:
        if rank[source] >= rank[target] or column[target] - column[source] > _FAR:
            ways.append(None)
            continue
        ways.append([_Item() for _ in range(column[source] + 1, column[target])])
        stops = [boxes[source]] + ways[-1] + [boxes[target]]
        for place, passing in enumerate(ways[-1], column[source] + 1):
            columns[place].append(passing)
        for left, right in zip(stops, stops[1:]):
            left.after.append(right)
            right.before.append(left)
    return columns, ways


def _sort(columns):
    """Order each column by where its neighbours are in theirs, so that few lines cross."""
    for items in columns:
        _number(items)
    for _ in range(_SWEEPS):
        for items in columns[1:]:
            items.sort(key=lambda item: _mean([other.place for other in item.before], item.place))
            _number(items)
        for items in reversed(columns[:-1]):
            items.sort(key=lambda item: _mean([other.place for other in item.after], item.place))
            _number(items)


def _number(items):
    for place, item in enumerate(items):
        item.place = place


def _mean(values, otherwise):
    if values:
        return sum(values) / len(values)
    return otherwise


def _place(columns):
    """Set x and y of all Items: each beside its neighbours, as far as there is room."""
    x = _MARGIN
    for items in columns:
        width = max([item.width for item in items] or [0])
        for item in items:
            item.x = x
            if item.box is not None:
                item.width = item.width
            else:
                item.width = width
        x += width + _BESIDE
        _stack(items, [0] * len(items))
    for _ in range(_SWEEPS):
        for items in columns[1:]:
            _stack(items, [_wanted(item, item.before) for item in items])
        for items in reversed(columns[:-1]):
            _stack(items, [_wanted(item, item.after) for item in items])
    top = min([item.y for items in columns for item in items] or [0])
    for item in (item for items in columns for item in items):
        item.y += _MARGIN - top


def _wanted(item, others):
    return _mean([other.middle for other in others], item.middle) - item.height / 2


def _stack(items, wanted):
    """Put Items below each other, together as near to their wanted y as possible."""
    free = -float("inf")
    for item, y in zip(items, wanted):
        item.y = max(y, free)
        free = item.y + item.height + _BELOW
    shift = _mean([y - item.y for item, y in zip(items, wanted)], 0)
    for item in items:
        item.y = int(item.y + shift)


# ---- drawing -----------------------------------------------------------------------------------------------


def _drawn(item):
    """The lines for a box."""
    box = item.box
    colour = graph.COLOURS.get(box.state, "white" if box.state is None else "lightgrey")
    yield '<rect x="%d" y="%d" width="%d" height="%d" rx="5" fill="%s" stroke="black"%s/>' % (
        item.x,
        item.y,
        item.width,
        item.height,
        colour,
        ' stroke-dasharray="4"' if box.missing else "",
    )
    for row, head in enumerate(item.heads):
        yield _text(item.x + item.width // 2, item.y + row * _ROW + 19, "middle", head)
    for port in box.left + box.right:
        x, y, side = item.port(port)
        yield _text(x - 6 * side, y + 5, "end" if side > 0 else "start", printable(port))


def _text(x, y, anchor, text):
    return '<text x="%d" y="%d" text-anchor="%s">%s</text>' % (x, y, anchor, _escaped(text))


def _escaped(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def _line(edge, boxes, way, lane):
    """The line for an edge; a browser shows what it connects when the mouse points at it.
    `lane`: y of one that goes below.
    """
    source, out, target, into, service = edge
    (x, y, side), (to_x, to_y, to_side) = boxes[source].port(out), boxes[target].port(into)
    if way is None:
        beside = _LANE + lane % (4 * _LANE)
        path = "M%d,%d H%d V%d H%d V%d H%d" % (
            x,
            y,
            x + side * beside,
            lane,
            to_x + to_side * beside,
            to_y,
            to_x,
        )
    else:
        path = "M%d,%d" % (x, y)
        for item in way:
            path += _curve(x, y, side, item.x, item.middle, -1) + " H%d" % (item.x + item.width)
            x = item.x + item.width
            y = item.middle
            side = 1
        path += _curve(x, y, side, to_x, to_y, to_side)
    if service:
        looks = 'stroke-dasharray="5,3" marker-end="url(#dot)"'
    else:
        looks = 'marker-end="url(#arrow)"'
    name = "%s:%s to %s:%s" % tuple(
        map(printable, (boxes[source].box.name, out, boxes[target].box.name, into))
    )
    return f'<path d="{path}" fill="none" stroke="black" {looks}><title>{_escaped(name)}</title></path>'


def _curve(x, y, side, to_x, to_y, to_side):
    """A curve to a port that leaves and arrives horizontally."""
    bend = max(_BESIDE // 2, abs(to_x - x) // 2)
    return " C%d,%d %d,%d %d,%d" % (x + side * bend, y, to_x + to_side * bend, to_y, to_x, to_y)
