"""A system drawn in the terminal: boxes below each other, as the data flows, and beside them a lane for each
out port.

    ┌────────────┐
    │ ConsoleIn0 │
    │        out ├─┐
    ├────────────┤ │
    │ ConsoleOut0│ │
    │ in         │<┘
    └────────────┘

Where lines meet they are joined; a line that only passes is drawn over the other.
"""

import collections
import heapq

from rtshell_lite.text import cells, printable
from rtshell_lite.views.graph import heads, in_order

# A row of the stack of boxes: text between its borders, and the borders.
Row = collections.namedtuple("Row", "left text right")

# The lines from one port: the rows they join, the row where they start, whether they are of a service.
Net = collections.namedtuple("Net", "rows start service")

# Joints by (goes up, goes down, goes right); all come from the left.
_JOINTS = {
    (0, 1, 0): "┐╗",
    (1, 0, 0): "┘╝",
    (1, 1, 0): "┤╣",
    (0, 1, 1): "┬╦",
    (1, 0, 1): "┴╩",
    (1, 1, 1): "┼╬",
}
_ASCII = {ord(c): "+" for c in "┌┐└┘├┤┬┴┼╗╝╣╦╩╬╞"}
_ASCII.update({ord("─"): "-", ord("│"): "|", ord("═"): "=", ord("║"): ":"})


def lines(picture, ascii_only=False):
    """The lines of the drawing of a graph.Graph; with `ascii_only` nothing but ASCII."""
    rows, row_of = _stack(picture)
    nets = _nets(picture, row_of)
    wide = max([cells(row.text) for row in rows] or [0])
    for (number, row), passing in zip(enumerate(rows), _passing(len(rows), nets, _lanes(nets))):
        beside, border = _beside(number, passing)
        line = (_box_row(row, wide, border) + beside).rstrip()
        if ascii_only:
            line = line.translate(_ASCII).encode("ascii", "backslashreplace").decode()
        yield line


def _box_row(row, wide, border):
    """A Row in its box, `border` where a line starts."""
    if row.right == ">":
        return row.left + " " * (wide - cells(row.text)) + row.text + (border or "│")
    if row.left in "┌├└":
        fill = "─"
    else:
        fill = " "
    return row.left + row.text + fill * (wide - cells(row.text)) + (border or row.right)


def _stack(picture):
    """(Rows of all boxes, {(box, port): number of its row}).
    `>` as the right border marks text that is aligned right.
    """
    rows = []
    row_of = {}
    for place, number in enumerate(in_order(picture)):
        box = picture.boxes[number]
        if place:
            rows.append(Row("├", "", "┤"))
        else:
            rows.append(Row("┌", "", "┐"))
        rows += [Row("│", f" {head} ", "│") for head in heads(picture, number)]
        for side, mark in ((box.left, "│"), (box.right, ">")):
            for port in side:
                row_of[number, port] = len(rows)
                rows.append(Row("│", f" {printable(box.port_words(port))} ", mark))
    return rows + [Row("└", "", "┘")] * bool(rows), row_of


def _nets(picture, row_of):
    """The Nets: one for each port where connections start, and kind."""
    rows = collections.OrderedDict()
    for source, out, target, into, service in picture.edges:
        rows.setdefault((row_of[source, out], service), set()).update(
            [row_of[source, out], row_of[target, into]]
        )
    return [Net(joined, start, service) for (start, service), joined in rows.items() if len(joined) > 1]


def _lanes(nets):
    """The lane of each Net, counted from the boxes; no two that overlap are in one, and there are as few as
    can be.
    """
    lanes = [0] * len(nets)
    free = []  # numbers of lanes
    taken = []  # (row where it ends, lane)
    for number in sorted(
        range(len(nets)), key=lambda number: (min(nets[number].rows), max(nets[number].rows))
    ):
        first = min(nets[number].rows)
        while taken and taken[0][0] < first:
            heapq.heappush(free, heapq.heappop(taken)[1])
        if free:
            lanes[number] = heapq.heappop(free)
        else:
            lanes[number] = len(taken)
        heapq.heappush(taken, (max(nets[number].rows), lanes[number]))
    return lanes


def _passing(rows, nets, lanes):
    """For each row the {lane: Net} of those that touch it."""
    begin = [[] for _ in range(rows)]
    end = [[] for _ in range(rows)]
    for net, lane in zip(nets, lanes):
        begin[min(net.rows)].append((lane, net))
        end[max(net.rows)].append(lane)
    passing = {}
    for row in range(rows):
        passing.update(begin[row])
        yield passing
        for lane in end[row]:
            del passing[lane]


def _beside(row, passing):
    """(what is drawn beside a row that these {lane: Net} touch, the border of its box where a line starts or
    '').
    """
    joined = {lane: net for lane, net in passing.items() if row in net.rows}
    far = max(joined, default=-1)
    service = int(any(net.service for net in joined.values()))
    arrives = any(row != net.start for net in joined.values())
    drawn = []
    for lane in range(max(passing, default=-1) + 1):
        drawn.append(_before_lane(lane, far, service, arrives))
        if lane in joined:
            net = joined[lane]
            drawn.append(
                _JOINTS[int(min(net.rows) < row), int(row < max(net.rows)), int(lane < far)][net.service]
            )
        elif lane in passing:
            drawn.append("│║"[passing[lane].service])
        elif lane < far:
            drawn.append("─═"[service])
        else:
            drawn.append(" ")
    if joined and not arrives:
        return "".join(drawn), "├╞"[service]
    return "".join(drawn), ""


def _before_lane(lane, far, service, arrives):
    """The cell before a lane: part of a line to a lane as far as `far`, of an arrow at the box."""
    if lane == 0 and arrives:
        return "<"
    if lane <= far:
        return "─═"[service]
    return " "
