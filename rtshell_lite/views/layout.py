"""Where the boxes and lines of a picture are, for drawings in pixels.

The layout is the usual one for such graphs (Sugiyama, Tagawa, Toda 1981): a column for each box by the
longest way to it, places within a column by those of its neighbours so that few lines cross. Columns follow
one another in rows, as words do on a page. Lines that go back, far or to another row have lanes between the
rows. Each step costs n log n.
"""

import bisect
import collections
import itertools
import math

from rtshell_lite.views import graph

# pixels
PAGE = (800, 600)  # width, height; a larger picture has the same proportions
BESIDE = 70  # between columns
BELOW = 24  # between boxes in a column
PASSING = 6  # the same for lines that pass
MARGIN = 40
LANE = 10  # between lines beside and below the boxes
_FAR = 8  # columns; lines that cross more of them go below
_SWEEPS = 8  # times that the places are improved, forwards and backwards
_RELAX = 4  # times that columns are moved towards their neighbours


class Item:
    """A box, or a line that passes (`number` is None), in a column. x, y: its upper left corner; row: of the
    column.
    """

    def __init__(self, number=None, width=0, height=0):
        self.number = number
        self.width = width
        self.height = height
        self.x = self.y = self.index = self.column = self.row = 0
        # (Item in the column to the left or right, where on it, where on this one, from 0 to 1) of each line
        self.before = []
        self.after = []

    @property
    def space(self):
        """Pixels that stay free below it."""
        if self.number is None:
            return PASSING
        return BELOW


class Detour:
    """Where a line goes that passes between the rows, or below the last one.

    ends     (Item, y, 1 for the right side and -1 for the left) of its source and its target
    lanes    the row below which it passes, or two of them: that near its source, that near its target
    corners  x and y by turns: beside its source, of a lane (beside all rows, of the other lane), beside its
             target
    """

    def __init__(self, ends):
        self.ends = ends
        (source, _, _), (target, _, _) = ends
        self.lanes = [source.row - (target.row < source.row), target.row - (source.row < target.row)]
        if self.lanes[0] == self.lanes[1]:
            del self.lanes[1]
        self.corners = [0] * (1 + 2 * len(self.lanes))


# boxes: the Item of each box; ways: for each edge the Items that it passes, or its Detour; size of it all
Layout = collections.namedtuple("Layout", "boxes ways width height")


def arrange(picture, sizes, port_of):
    """The Layout of a graph.Graph.

    sizes    (width, height) of each box
    port_of  a function of an Item and a port: (x, y, 1 for the right side and -1 for the left)
    """
    boxes = [Item(number, width, height) for number, (width, height) in enumerate(sizes)]
    rank = {number: index for index, number in enumerate(graph.in_order(picture))}
    scale = _scale(sizes)
    columns = _columns(picture, boxes, rank, PAGE[1] * scale)
    lines = sum(boxes[target].column != boxes[source].column + 1 for source, _, target, _, _ in picture.edges)
    rows = _rows(columns, lines, PAGE[0] * scale)
    ways = [_way(edge, picture, boxes, rank, columns) for edge in picture.edges]
    _sort(columns)
    for row in rows:
        _put_below(row)
    detours = _detours(picture, boxes, ways, port_of)
    right = _put_outside(detours, _put_beside(rows, _turns(detours)))
    return Layout(boxes, ways, right + MARGIN, _put_rows(rows, detours))


def _scale(sizes):
    """How many times larger than PAGE all boxes and the space between them are, in width and in height."""
    area = sum((width + BESIDE) * (height + BELOW) for width, height in sizes)
    return max(1, (area / (PAGE[0] * PAGE[1])) ** 0.5)


# ---- columns and rows ----


def _columns(picture, boxes, rank, tallest):
    """Lists of Items: each after those from which data comes to it, where a column of this height has room.
    What is not connected comes last.
    """
    sources = collections.defaultdict(list)
    used = set()
    for source, _, target, _, _ in picture.edges:
        used.update((source, target))
        if rank[source] < rank[target]:
            sources[target].append(source)
    columns = []
    heights = []
    free = {}  # the column that had room last, by the first one that an item may be in

    def put(item, first):
        column = free.get(first, first)
        while column < len(columns) and heights[column] + item.height > tallest:
            column += 1
        free[first] = column
        if column == len(columns):
            columns.append([])
            heights.append(0)
        columns[column].append(item)
        heights[column] += item.height + item.space
        item.column = column

    for number in rank:
        if number in used:
            put(boxes[number], max([boxes[source].column + 1 for source in sources[number]] or [0]))
    alone = [number for number in rank if number not in used]
    while len(columns) < (len(alone) / 4) ** 0.5:
        columns.append([])
        heights.append(0)
    for index, number in enumerate(alone):  # to all columns by turns
        put(boxes[number], index % len(columns))
    return columns


def _rows(columns, lines, width):
    """Lists of columns that follow one another: as many as give this width, or the proportions of PAGE.

    lines  how many will have a lane below a row, and a track on either side of a column, at most
    """
    if not columns:
        return []
    sizes = []
    for items in columns:
        wide = max(item.width for item in items) + BESIDE
        sizes.append((wide, sum(item.height + item.space for item in items)))
    total = sum(wide for wide, _ in sizes)
    breaks = []
    count = 0
    while count < len(columns):
        count += 1 + count // 10
        # one row may be half a column wider than the others
        starts, height = _breaks(sizes, total / count + total / len(columns) / 2)
        row_width = max(width, (height + lines * LANE) * PAGE[0] / PAGE[1])
        # that it is too wide is worse
        wider = math.log((total + 2 * lines * LANE) / count / row_width)
        breaks.append((max(2 * wider, -wider), count, starts))
    _, _, starts = min(breaks)
    rows = []
    for row, (start, end) in enumerate(zip(starts, starts[1:] + [len(columns)])):
        rows.append(columns[start:end])
        for item in itertools.chain(*rows[row]):
            item.row = row
    return rows


def _breaks(sizes, width):
    """(the first column of each row, if rows are that wide; height of them all)."""
    starts = []
    height = x = tall = 0
    for number, (wide, high) in enumerate(sizes):
        if not starts or x + wide > width:
            starts.append(number)
            height += tall + MARGIN
            x = tall = 0
        x += wide
        tall = max(tall, high)
    return starts, height + tall


def _way(edge, picture, boxes, rank, columns):
    """The Items that a line passes; None if it goes between the rows."""
    source, out, target, into, _ = edge
    first, last = boxes[source].column, boxes[target].column
    if rank[source] >= rank[target] or last - first > _FAR:
        return None
    if boxes[source].row != boxes[target].row:
        return None
    rights, lefts = picture.boxes[source].right, picture.boxes[target].left
    if out not in rights or into not in lefts:
        return None
    way = [Item() for _ in range(first + 1, last)]
    for column, passing in enumerate(way, first + 1):
        passing.column = column
        columns[column].append(passing)
    stops = [boxes[source]] + way + [boxes[target]]
    heights = [_height(rights, out)] + [0.5] * len(way) + [_height(lefts, into)]
    for index in range(len(stops) - 1):
        stops[index].after.append((stops[index + 1], heights[index + 1], heights[index]))
        stops[index + 1].before.append((stops[index], heights[index], heights[index + 1]))
    return way


def _height(ports, port):
    """Where on a box, from 0 to 1, one of its ports is."""
    return (ports.index(port) + 1) / (len(ports) + 1)


# ---- the order within columns ----


def _sort(columns):
    """Order each column by where its neighbours are in theirs; keep the order in which fewest lines cross."""
    for items in columns:
        _number(items)
    best = [list(items) for items in columns]
    fewest = _crossings(columns)
    for _ in range(_SWEEPS):
        for items in columns[1:]:
            items.sort(key=lambda item: _mean([other.index + y for other, y, _ in item.before], item.index))
            _number(items)
        for items in reversed(columns[:-1]):
            items.sort(key=lambda item: _mean([other.index + y for other, y, _ in item.after], item.index))
            _number(items)
        crossings = _crossings(columns)
        if crossings >= fewest:
            break
        fewest = crossings
        best = [list(items) for items in columns]
    for number, items in enumerate(best):
        columns[number][:] = items
        _number(items)


def _number(items):
    for index, item in enumerate(items):
        item.index = index


def _crossings(columns):
    """How many pairs of lines cross between columns."""
    count = 0
    for items in columns:
        ends = sorted(
            (item.index + here, other.index + there) for item in items for other, there, here in item.after
        )
        count += _inversions([there for _, there in ends])
    return count


def _inversions(values):
    """How many pairs of values are in the wrong order."""
    seen = []
    inversions = 0
    for value in values:
        index = bisect.bisect_right(seen, value)
        inversions += len(seen) - index
        seen.insert(index, value)  # to move the rest costs less than a tree, up to some 10,000
    return inversions


def _mean(values, otherwise):
    if values:
        return sum(values) / len(values)
    return otherwise


# ---- y ----


def _put_below(columns):
    """Set y of all Items of a row, from 0 up: each beside its neighbours, as far as there is room."""
    for items in columns:
        _stack(items, [0] * len(items))
    for _ in range(_RELAX):
        for items in columns[1:]:
            _stack(items, [_wanted(item, item.before) for item in items])
        for items in reversed(columns[:-1]):
            _stack(items, [_wanted(item, item.after) for item in items])
    top = min(item.y for items in columns for item in items)
    for items in columns:
        for item in items:
            item.y -= top


def _wanted(item, lines):
    """The y at which the lines of an item are straight, on the average."""
    ys = [other.y + there * other.height - here * item.height for other, there, here in lines]
    return _mean(ys, item.y)


def _stack(items, ys):
    """Put Items below each other, together as near to their wanted y as possible."""
    free = -float("inf")
    for item, y in zip(items, ys):
        item.y = max(y, free)
        free = item.y + item.height + item.space
    shift = _mean([y - item.y for item, y in zip(items, ys)], 0)
    for item in items:
        item.y = int(item.y + shift)


# ---- lines between the rows ----


def _detours(picture, boxes, ways, port_of):
    """The Detours of the edges that pass no Items; they are put into `ways`."""
    detours = []
    for number, (source, out, target, into, _) in enumerate(picture.edges):
        if ways[number] is None:
            ends = []
            for item, port in ((boxes[source], out), (boxes[target], into)):
                _, y, side = port_of(item, port)
                ends.append((item, y, side))
            ways[number] = Detour(ends)
            detours.append(ways[number])
    return detours


def _turns(detours):
    """{(column, side): [(what sorts them, Detour, 0 at its source or 1 at its target)]} of lines that turn
    there; the nearest comes first, so that few cross.
    """
    turns = collections.defaultdict(list)
    for number, detour in enumerate(detours):
        for end, (item, y, side) in enumerate(detour.ends):
            order = (1, y, number, end) if detour.lanes[-end] < item.row else (0, -y, number, end)
            turns[item.column, side].append((order, detour, end))
    return {key: sorted(ends, key=lambda turn: turn[0]) for key, ends in turns.items()}


def _put_beside(rows, turns):
    """Set x of all Items, and where Detours turn, each on a track of its own; returns where all this ends."""
    most = 0
    for number, row in enumerate(rows):
        x = MARGIN + LANE // 2 * (number % 2)  # rows that face each other have no track in common
        for items in row:
            before = turns.get((items[0].column, -1), ())
            after = turns.get((items[0].column, 1), ())
            x += len(before) * LANE
            for track, (_, detour, end) in enumerate(before, 1):
                detour.corners[-end] = x - track * LANE
            width = math.ceil(max(item.width for item in items) / LANE) * LANE
            for item in items:
                item.x = x
                item.width = width
            x += width
            for track, (_, detour, end) in enumerate(after, 1):
                detour.corners[-end] = x + track * LANE
            x += len(after) * LANE
            most = max(most, x)
            x += BESIDE
    return most


def _put_outside(detours, x):
    """Set where Detours with two lanes change from one to the other, right of x; returns where this ends."""
    for detour in sorted(detours, key=lambda detour: abs(detour.lanes[0] - detour.lanes[-1])):
        if len(detour.lanes) > 1:
            x += LANE
            detour.corners[2] = x
    return x


def _put_rows(rows, detours):
    """Set y of all Items, rows below each other, and of lanes between them; returns the height of it all."""
    lanes = [[] for _ in rows]
    for number, detour in enumerate(detours):
        for index, row in enumerate(detour.lanes):
            length = abs(detour.corners[2 * index] - detour.corners[2 * index + 2])
            lanes[row].append((length, number, 2 * index + 1))
    y = MARGIN
    for row, lanes_below in zip(rows, lanes):
        bottom = y
        for item in itertools.chain(*row):
            item.y += y
            bottom = max(bottom, item.y + item.height)
        y = bottom + MARGIN // 2
        for _, number, corner in sorted(lanes_below):  # the shortest first: fewer cross
            detours[number].corners[corner] = y
            y += LANE
        y += MARGIN // 2
    return y
