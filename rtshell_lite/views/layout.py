"""Where the boxes and lines of a picture are, for drawings in pixels.

The layout is the usual one for such graphs (Sugiyama, Tagawa, Toda 1981): a column for each box by the
longest way to it, places within a column by those of its neighbours so that few lines cross, and lanes below
all boxes for lines that go back or far. Each step costs n log n.
"""

import bisect
import collections
import heapq

from rtshell_lite.views import graph

# pixels
BESIDE = 90  # between columns
BELOW = 24  # between boxes in a column
PASSING = 10  # the same for lines that pass
MARGIN = 40
LANE = 10  # between lines beside and below the boxes
_FAR = 8  # columns; lines that cross more of them go below
_SWEEPS = 8  # times that the places are improved, forwards and backwards
_RELAX = 4  # times that columns are moved towards their neighbours


class Item:
    """A box, or a line that passes (`number` is None), in a column. x, y: its upper left corner."""

    def __init__(self, number=None, width=0, height=0):
        self.number = number
        self.width = width
        self.height = height
        self.x = self.y = self.place = self.column = 0
        # (Item in the column to the left or right, where on it, where on this one, from 0 to 1) of each line
        self.before = []
        self.after = []

    @property
    def middle(self):
        return self.y + self.height / 2

    @property
    def space(self):
        """Pixels that stay free below it."""
        if self.number is None:
            return PASSING
        return BELOW


# Where a line goes that passes below the boxes: x beside its source, y of its lane, x beside its target.
Detour = collections.namedtuple("Detour", "x lane to_x")

# boxes: the Item of each box; ways: for each edge the Items that it passes, or its Detour; size of it all
Layout = collections.namedtuple("Layout", "boxes ways width height")


def arrange(picture, sizes, port_of):
    """The Layout of a graph.Graph.

    sizes    (width, height) of each box
    port_of  a function of an Item and a port: (x, y, 1 for the right side and -1 for the left)
    """
    boxes = [Item(number, width, height) for number, (width, height) in enumerate(sizes)]
    columns, ways = _columns(picture, boxes)
    _sort(columns)
    _put_below(columns)
    detours = [place for place, way in enumerate(ways) if way is None]
    edges = _put_beside(columns, _gaps(picture, boxes, detours, port_of, len(columns)))
    bottom = max((item.y + item.height for item in boxes), default=0) + MARGIN // 2
    turns = _turns(picture, boxes, detours, port_of, edges)
    lanes = _lanes(turns)
    for place in detours:
        begin, end = turns[place]
        ways[place] = Detour(begin, bottom + lanes[place] * LANE, end)
    rights = [item.x + item.width for item in boxes]
    for place in detours:
        rights += [ways[place].x, ways[place].to_x]
    height = bottom + len(set(lanes.values())) * LANE + MARGIN // 2
    return Layout(boxes, ways, max(rights, default=0) + MARGIN, height)


# ---- columns -----------------------------------------------------------------------------------------------


def _columns(picture, boxes):
    """(columns, lists of Items; for each edge the Items that it passes, None for one that goes below)."""
    order = graph.in_order(picture)
    rank = {number: place for place, number in enumerate(order)}
    sources = collections.defaultdict(list)
    used = set()
    for source, _, target, _, _ in picture.edges:
        used.update((source, target))
        if rank[source] < rank[target]:
            sources[target].append(source)
    for number in order:
        boxes[number].column = max([boxes[source].column + 1 for source in sources[number]] or [0])
    columns = [[] for _ in range(max([item.column for item in boxes] or [0]) + 1)]
    for number in order:
        if number in used:
            columns[boxes[number].column].append(boxes[number])
    _distribute([boxes[number] for number in order if number not in used], columns)
    return columns, [_way(edge, picture, boxes, rank, columns) for edge in picture.edges]


def _distribute(items, columns):
    """Put what is not connected where there is room: into the shortest column each."""
    heights = [sum(item.height + item.space for item in column) for column in columns]
    for item in items:
        item.column = heights.index(min(heights))
        columns[item.column].append(item)
        heights[item.column] += item.height + item.space


def _way(edge, picture, boxes, rank, columns):
    source, out, target, into, _ = edge
    first, last = boxes[source].column, boxes[target].column
    if rank[source] >= rank[target]:
        return None
    if last - first > _FAR:
        return None
    way = [Item() for _ in range(first + 1, last)]
    for column, passing in enumerate(way, first + 1):
        passing.column = column
        columns[column].append(passing)
    stops = [boxes[source]] + way + [boxes[target]]
    at = (
        [_row(picture.boxes[source].right, out)] + [0.5] * len(way) + [_row(picture.boxes[target].left, into)]
    )
    for place in range(len(stops) - 1):
        stops[place].after.append((stops[place + 1], at[place + 1], at[place]))
        stops[place + 1].before.append((stops[place], at[place], at[place + 1]))
    return way


def _row(ports, port):
    """Where on a box, from 0 to 1, one of its ports is."""
    if port in ports:
        return (ports.index(port) + 1) / (len(ports) + 1)
    return 0.5


# ---- the order within columns ------------------------------------------------------------------------------


def _sort(columns):
    """Order each column by where its neighbours are in theirs; keep the order in which fewest lines cross."""
    for items in columns:
        _number(items)
    best = [list(items) for items in columns]
    fewest = _crossings(columns)
    for _ in range(_SWEEPS):
        for items in columns[1:]:
            items.sort(key=lambda item: _mean([other.place + at for other, at, _ in item.before], item.place))
            _number(items)
        for items in reversed(columns[:-1]):
            items.sort(key=lambda item: _mean([other.place + at for other, at, _ in item.after], item.place))
            _number(items)
        crossings = _crossings(columns)
        if crossings >= fewest:
            break
        fewest = crossings
        best = [list(items) for items in columns]
    for place, items in enumerate(best):
        columns[place][:] = items
        _number(items)


def _number(items):
    for place, item in enumerate(items):
        item.place = place


def _crossings(columns):
    """How many pairs of lines cross between columns."""
    count = 0
    for items in columns:
        ends = sorted(
            (item.place + here, other.place + there) for item in items for other, there, here in item.after
        )
        count += _inversions([there for _, there in ends])
    return count


def _inversions(values):
    """How many pairs of values are in the wrong order (by a Fenwick tree)."""
    ranks = sorted(set(values))
    counts = [0] * (len(ranks) + 1)
    found = 0
    for seen, value in enumerate(values):
        place = bisect.bisect_left(ranks, value) + 1
        at = place
        not_greater = 0
        while at:
            not_greater += counts[at]
            at -= at & -at
        found += seen - not_greater
        while place <= len(ranks):
            counts[place] += 1
            place += place & -place
    return found


def _mean(values, otherwise):
    if values:
        return sum(values) / len(values)
    return otherwise


# ---- y -----------------------------------------------------------------------------------------------------


def _put_below(columns):
    """Set y of all Items: each beside its neighbours, as far as there is room."""
    for items in columns:
        _stack(items, [0] * len(items))
    for _ in range(_RELAX):
        for items in columns[1:]:
            _stack(items, [_wanted(item, item.before) for item in items])
        for items in reversed(columns[:-1]):
            _stack(items, [_wanted(item, item.after) for item in items])
    top = min([item.y for items in columns for item in items] or [0])
    for items in columns:
        for item in items:
            item.y += MARGIN - top


def _wanted(item, lines):
    """The y at which the lines of an item are straight, on the average."""
    wanted = [other.y + at * other.height - here * item.height for other, at, here in lines]
    return _mean(wanted, item.y)


def _stack(items, wanted):
    """Put Items below each other, together as near to their wanted y as possible."""
    free = -float("inf")
    for item, y in zip(items, wanted):
        item.y = max(y, free)
        free = item.y + item.height + item.space
    shift = _mean([y - item.y for item, y in zip(items, wanted)], 0)
    for item in items:
        item.y = int(item.y + shift)


# ---- x -----------------------------------------------------------------------------------------------------


def _gaps(picture, boxes, detours, port_of, columns):
    """How many lines turn down in each gap: before the first column, between columns, after the last."""
    turning = [0] * (columns + 1)
    for place in detours:
        source, out, target, into, _ = picture.edges[place]
        for item, port in ((boxes[source], out), (boxes[target], into)):
            turning[_gap(item, port_of(item, port)[2])] += 1
    return turning


def _gap(item, side):
    """The gap on a side of a box: 1 is the right one, -1 the left one."""
    if side > 0:
        return item.column + 1
    return item.column


def _put_beside(columns, turning):
    """Set x of all Items; gaps are wide enough for the lines that turn in them. Returns (x where it begins, x
    where it ends) of each column.
    """
    x = MARGIN + turning[0] * LANE
    edges = []
    for items, turns in zip(columns, turning[1:]):
        width = max([item.width for item in items] or [0])
        for item in items:
            item.x = x
            if item.number is None:
                item.width = width
        edges.append((x, x + width))
        x += width + BESIDE + turns * LANE
    return edges


def _turns(picture, boxes, detours, port_of, edges):
    """{place of an edge that passes below: (x where it turns beside its source, and beside its target)}: each
    on a track of its own.
    """
    turned = collections.Counter()
    turns = {}
    for place in detours:
        source, out, target, into, _ = picture.edges[place]
        both = []
        for item, port in ((boxes[source], out), (boxes[target], into)):
            side = port_of(item, port)[2]
            turned[item.column, side] += 1
            both.append(edges[item.column][side > 0] + side * turned[item.column, side] * LANE)
        turns[place] = tuple(both)
    return turns


def _lanes(turns):
    """{place: number of its lane below the boxes}; lines that do not overlap may share one."""
    lanes = {}
    free = []  # (x from which it is free, number) of each lane
    for place in sorted(turns, key=lambda place: (min(turns[place]), place)):
        start, end = sorted(turns[place])
        if free and free[0][0] < start:
            lanes[place] = free[0][1]
            heapq.heapreplace(free, (end + LANE, lanes[place]))
        else:
            lanes[place] = len(free)
            heapq.heappush(free, (end + LANE, lanes[place]))
    return lanes
