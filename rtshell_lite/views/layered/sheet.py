"""A whole picture: its connected parts, each in layers, and what is not connected in a strip of its own.

Layers that are too many for one row follow one another in rows, as words do on a page. Lines to another row
have lanes between the rows. Each step costs n log n.
"""

import collections
import itertools
import math

from rtshell_lite.text import natural
from rtshell_lite.views.layered import crossings, cycles, heights, layers
from rtshell_lite.views.layered.item import BELOW, PASSING, Item
from rtshell_lite.views.layered.lines import BESIDE, BETWEEN, LANE, Chain, Detour, Row, pack

# pixels
PAGE = (800, 600)  # width, height; a larger picture has the same proportions
MARGIN = 20
APART = 40  # between connected parts
_FAR = 12  # layers; lines that pass more of them have a lane
_WIDEST = 3  # times its height, before a part becomes several rows
# times more at most, up to this width, by _CUT lines that would lead from one row to another, and cross many
_WIDER = 2
_WIDE = 6 * PAGE[0]
_CUT = 4

# A line: numbers of boxes, (y, 0 for the left side or 1 for the right one) of its ports on them, whether it
# is of a service.
Line = collections.namedtuple("Line", "source target out into service")

# corners: (x, y) of each box; widths of boxes; ways: points of each line, see lines.py; size of it all
Layout = collections.namedtuple("Layout", "corners widths ways width height")


class Part:
    """Connected boxes: their Items by number, lines.Chains and lines.Detours by number, lists of layers in
    rows.
    """

    def __init__(self, numbers, line_numbers, lines, sizes, far):
        self._far = far
        index = {number: index for index, number in enumerate(numbers)}
        weights = collections.OrderedDict()
        for number in line_numbers:
            source, target = index[lines[number].source], index[lines[number].target]
            if source != target:
                weight = 1 if lines[number].service else 2
                weights[source, target] = weights.get((source, target), 0) + weight
        layer = layers.assign(cycles.order(weights, len(numbers)), weights)
        sizes = [sizes[number] for number in numbers]
        area = sum((width + BESIDE) * (height + BELOW) for width, height in sizes)
        tall = max(PAGE[1], math.sqrt(area * PAGE[1] / PAGE[0]))
        columns = layers.columns(layer, [height + BELOW for _, height in sizes], tall)
        self.items = collections.OrderedDict()
        self.rows = []
        for row in _rows(columns, sizes, _between(columns, weights)):
            self.rows.append(Row([]))
            for column in row:
                self.rows[-1].layers.append([])
                for inner in column:
                    self._add(Item(numbers[inner], *sizes[inner]))
        self.ways = collections.OrderedDict()
        uses = collections.Counter()
        for number in line_numbers:
            line = lines[number]
            uses.update([(line.source, line.out), (line.target, line.into)])
        for number in line_numbers:
            self.ways[number] = self._way(lines[number], uses)
        for row in self.rows:
            crossings.sort(row.layers)

    def _add(self, box):
        """Put the Item of a box into the last layer."""
        box.row = len(self.rows) - 1
        box.layer = len(self.rows[-1].layers) - 1
        self.rows[-1].layers[-1].append(box)
        self.items[box.number] = box

    def _way(self, line, uses):
        """The way of a line; `uses` is the number of lines at each (number of a box, port)."""
        source, target = self.items[line.source], self.items[line.target]
        ends = (source, line.out[1], line.out[0]), (target, line.into[1], line.into[0])
        if source.row != target.row or abs(source.layer - target.layer) > self._far:
            return Detour(*ends)
        is_alone = uses[line.source, line.out] == uses[line.target, line.into] == 1
        return Chain(*ends, self.rows[source.row].layers, 1 + is_alone)

    def settle(self):
        """Set x and y of all; returns (width, height)."""
        chains = list(self.ways.values())
        passed = [[] for _ in self.rows]
        for items in [chain.passed for chain in chains]:
            if items:
                passed[items[0].row].append(items)
        for row, inner in zip(self.rows, passed):
            heights.settle(row.layers, inner)
        turns = [[] for _ in self.rows]
        for chain in chains:
            for turn in chain.turn():
                turns[turn.end[0].row].append(turn)
        right = 0
        for number, row in enumerate(self.rows):
            # rows that face each other have no track in common
            right = max(right, row.put_beside(LANE // 2 * (number % 2), turns[number]))
        detours = [chain for chain in chains if isinstance(chain, Detour)]
        right = _put_outside(detours, right)
        return right, _put_rows(self.rows, detours)


def _between(columns, pairs):
    """How many lines between these pairs of boxes lead from columns before each one to it or those after."""
    column_of = {number: index for index, column in enumerate(columns) for number in column}
    changes = [0] * (len(columns) + 1)
    for pair in pairs:
        first, last = sorted(column_of[number] for number in pair)
        changes[first + 1] += 1
        changes[last + 1] -= 1
    return list(itertools.accumulate(changes[:-1]))


def _rows(columns, sizes, between):
    """Lists of columns, lists of numbers of boxes, that follow one another in rows: one, or as many as give
    the proportions of PAGE. `between`: see above.
    """
    widths = [max(sizes[number][0] for number in column) + BESIDE for column in columns]
    tall = [
        sum(sizes[number][1] + BELOW for number in column) + min(counts) * PASSING
        for column, counts in zip(columns, zip(between, between[1:] + [0]))
    ]
    total = sum(widths)
    if len(columns) == 1 or total <= max(2.3 * PAGE[0], _WIDEST * max(tall)):
        return [columns]
    best = None
    count = 1
    while count < len(columns):
        count += 1 + count // 10
        # one row may be half a column wider than the others
        starts, height = _breaks(widths, tall, between, total / count + total / len(columns) / 2)
        wider = math.log(total / count / height * PAGE[1] / PAGE[0])
        difference = max(2 * wider, -wider)  # that it is too wide is worse
        if best is None or difference < best[0]:
            best = difference, starts
    cut = max(between[start] for start in best[1][1:])
    if total <= min(_WIDE, (_WIDEST + min(cut / _CUT, _WIDER)) * max(tall)):
        return [columns]
    return [columns[start:end] for start, end in zip(best[1], best[1][1:] + [len(columns)])]


def _breaks(widths, tall, between, width):
    """(the first column of each row, if rows are that wide or a little less, where fewest lines are cut;
    height of them all).
    """
    starts = [0]
    height = x = 0
    number = 0
    while number < len(widths):
        if x + widths[number] > width and number > starts[-1]:
            least = max(starts[-1], number - 3)
            number = min(range(number, least, -1), key=between.__getitem__)
            starts.append(number)
            x = 0
        x += widths[number]
        number += 1
    for start, end in zip(starts, starts[1:] + [len(widths)]):
        height += max(tall[start:end]) + 2 * BETWEEN
    return starts, height


def _put_outside(detours, right):
    """Set where Detours change from one lane to another, right of all rows; returns where this ends."""
    far = [detour for detour in detours if len(detour.lanes) > 1]
    far.sort(key=lambda detour: abs(detour.lanes[0] - detour.lanes[1]))
    numbers = pack([tuple(sorted(detour.lanes)) for detour in far])
    for detour, number in zip(far, numbers):
        detour.x = right + LANE * (number + 1)
    return right + LANE * (max(numbers, default=-1) + 1)


def _put_rows(rows, detours):
    """Put rows below each other, and lanes between them; returns the height of it all."""
    lanes = [[] for _ in range(len(rows) + 1)]
    for detour in detours:
        for index, (lane, span) in enumerate(zip(detour.lanes, detour.spans())):
            lanes[lane].append((span, detour, index))
    y = 0
    for number, row in enumerate(rows):
        y = _put_lanes(lanes[number], y, -1 if number == 0 else 1)
        bottom = y
        for items in row.layers:
            for box in items:
                box.y += y
                bottom = max(bottom, box.y + box.height)
        y = bottom
        if number < len(rows) - 1:
            y += BETWEEN
    return _put_lanes(lanes[-1], y + BETWEEN, 1) - BETWEEN


def _put_lanes(lanes, y, way):
    """Set y of the lanes of Detours, [(span, Detour, index of its lane)], from y down, the shortest first or
    last (`way` is 1 or -1); returns where the row below them begins.
    """
    lanes.sort(key=lambda lane: lane[0][1] - lane[0][0])
    numbers = pack([span for span, _, _ in lanes])
    if not lanes:
        return y
    for (_, detour, index), number in zip(lanes, numbers):
        if way < 0:
            number = max(numbers) - number
        detour.ys[index] = y + number * LANE
    return y + max(numbers) * LANE + BETWEEN


# ---- connected parts ----


def parts(lines, sizes, far=_FAR):
    """([Part] in the order of their first boxes, numbers of boxes with no line). Lines that pass more than
    `far` layers do not count for the order within these.
    """
    neighbours = [[] for _ in sizes]
    for line in lines:
        neighbours[line.source].append(line.target)
        neighbours[line.target].append(line.source)
    part_of = {}
    members = []
    for root in range(len(sizes)):
        if root in part_of or not neighbours[root]:
            continue
        part_of[root] = len(members)
        members.append([root])
        for number in members[-1]:
            for other in neighbours[number]:
                if other not in part_of:
                    part_of[other] = part_of[root]
                    members[-1].append(other)
    line_numbers = [[] for _ in members]
    for number, line in enumerate(lines):
        line_numbers[part_of[line.source]].append(number)
    connected = [
        Part(sorted(numbers), inner, lines, sizes, far) for numbers, inner in zip(members, line_numbers)
    ]
    return connected, [number for number in range(len(sizes)) if number not in part_of]


def by_name(numbers, names):
    return sorted(numbers, key=lambda number: (natural(names[number]), number))


def put_in_order(lines, names):
    """The numbers of all boxes: parts one after the other, as data flows; then the unconnected, by name."""
    connected, alone = parts(lines, [(1, 1)] * len(names))
    items = [item for part in connected for row in part.rows for layer in row.layers for item in layer]
    return [item.number for item in items if item.number is not None] + by_name(alone, names)


def arrange(lines, sizes, names):
    """The Layout of Lines between boxes of these sizes, (width, height), and names."""
    connected, alone = parts(lines, sizes)
    blocks = [(part.settle(), part) for part in connected]
    blocks.sort(key=lambda block: -block[0][1])  # the tallest first
    area = sum((width + APART) * (height + APART) for (width, height), _ in blocks)
    area += sum((sizes[number][0] + BELOW) * (sizes[number][1] + BELOW) for number in alone)
    widest = max([size[0] for size, _ in blocks], default=0)
    widest = max(widest, math.sqrt(area * PAGE[0] / PAGE[1]))
    layout = Layout([None] * len(sizes), [None] * len(sizes), [None] * len(lines), 0, 0)
    x, y, bottom, right = MARGIN, MARGIN, MARGIN, MARGIN
    for (width, height), part in blocks:
        if x + width > MARGIN + widest:
            x, y = MARGIN, bottom + APART
        _put_part(part, x, y, layout)
        bottom = max(bottom, y + height)
        right = max(right, x + width)
        x += width + APART
    if alone:
        top = bottom + APART if blocks else MARGIN
        across = max(widest, right - MARGIN)
        right, bottom = _put_alone(by_name(alone, names), sizes, top, across, right, layout)
    return layout._replace(width=right + MARGIN, height=bottom + MARGIN)


def _put_part(part, x, y, layout):
    for number, box in part.items.items():
        layout.corners[number] = box.x + x, box.y + y
        layout.widths[number] = box.width
    for number, chain in part.ways.items():
        layout.ways[number] = [(point_x + x, point_y + y) for point_x, point_y in chain.way(part.rows)]


def _put_alone(numbers, sizes, y, widest, right, layout):
    """Put boxes beside each other into rows; returns (right, bottom) of it all."""
    width = max(sizes[number][0] for number in numbers)
    across = max(1, int((widest + BELOW) // (width + BELOW)))
    for start in range(0, len(numbers), across):
        row = numbers[start : start + across]
        for column, number in enumerate(row):
            layout.corners[number] = MARGIN + column * (width + BELOW), y
            layout.widths[number] = width
        right = max(right, MARGIN + len(row) * (width + BELOW) - BELOW)
        y += max(sizes[number][1] for number in row) + BELOW
    return right, y - BELOW
