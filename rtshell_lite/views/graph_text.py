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
from rtshell_lite.views import group_names
from rtshell_lite.views.graph import heads
from rtshell_lite.views.layered import sheet

# A row of the stack of boxes: text between its borders, and the borders.
Row = collections.namedtuple("Row", "left text right")

# The lines from one port: the first and the last of the rows they join, these rows, the row where they start,
# whether they are of a service.
Net = collections.namedtuple("Net", "first last rows start service")

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
    wide = max([cells(row.text) for row in rows], default=0)
    passing = _passing(len(rows), nets)
    for number, row in enumerate(rows):
        beside, border = _beside(number, next(passing))
        line = (_box_row(row, wide, border) + beside).rstrip()
        if ascii_only:
            line = line.translate(_ASCII).encode("ascii", "backslashreplace").decode()
        yield line


def _box_row(row, wide, border):
    """A Row in its box, `border` where a line starts."""
    left, text, right = row
    rest = wide - cells(text)
    if right == ">":
        text = " " * rest + text
        right = "│"
    elif left in "┌├└":
        text += "─" * rest
    else:
        text += " " * rest
    return left + text + (border or right)


def _stack(picture):
    """(Rows of all boxes, {(box, port): number of its row}).
    `>` as the right border marks text that is aligned right.
    """
    rows = []
    row_of = {}
    names = [box.name for box in picture.boxes]
    labels = group_names.of_boxes(picture)
    lines = [
        sheet.Line(source, target, (0, 1), (0, 0), service) for source, _, target, _, service in picture.edges
    ]
    for index, number in enumerate(sheet.put_in_order(lines, names)):
        box = picture.boxes[number]
        rows.append(Row("├", "", "┤") if index else Row("┌", "", "┐"))
        rows += [Row("│", f" {head} ", "│") for head in heads(picture, number, labels)]
        for side, mark in ((box.left, "│"), (box.right, ">")):
            for port in side:
                row_of[number, port] = len(rows)
                rows.append(Row("│", f" {printable(box.port_words(port))} ", mark))
    if rows:
        rows.append(Row("└", "", "┘"))
    return rows, row_of


def _nets(picture, row_of):
    """The Nets: one for each port where connections start, and kind."""
    joined = collections.OrderedDict()
    for source, out, target, into, service in picture.edges:
        start = row_of[source, out]
        end = row_of[target, into]
        joined.setdefault((start, service), {start}).add(end)
    return [
        Net(min(rows), max(rows), rows, start, service)
        for (start, service), rows in joined.items()
        if len(rows) > 1
    ]


def _passing(count, nets):
    """For each row the {lane: Net} of those that touch it. Lanes are counted from the boxes; no two Nets that
    overlap are in one, and there are as few as can be.
    """
    to_come = collections.deque(sorted(nets, key=lambda net: (net.first, net.last)))
    free = []  # numbers of lanes, a heap
    passing = {}
    for row in range(count):
        while to_come and to_come[0].first == row:
            lane = heapq.heappop(free) if free else len(passing)
            passing[lane] = to_come.popleft()
        yield passing
        for lane, net in list(passing.items()):
            if net.last == row:
                del passing[lane]
                heapq.heappush(free, lane)


def _beside(row, passing):
    """(what is drawn beside a row that these {lane: Net} touch, the border of its box where a line starts or
    '').
    """
    joined = {lane: net for lane, net in passing.items() if row in net.rows}
    far = max(joined, default=-1)
    service = any(net.service for net in joined.values())
    arrives = any(row != net.start for net in joined.values())
    drawn = ""
    for lane in range(max(passing, default=-1) + 1):
        drawn += _before_lane(lane, far, service, arrives)
        if lane in joined:
            net = joined[lane]
            joint = _JOINTS[net.first < row, row < net.last, lane < far]
            drawn += joint[net.service]
        elif lane in passing:
            drawn += "│║"[passing[lane].service]
        elif lane < far:
            drawn += "─═"[service]
        else:
            drawn += " "
    if joined and not arrives:
        return drawn, "├╞"[service]
    return drawn, ""


def _before_lane(lane, far, service, arrives):
    """The cell before a lane: part of a line to a lane as far as `far`, of an arrow at the box."""
    if lane == 0 and arrives:
        return "<"
    if lane <= far:
        return "─═"[service]
    return " "
