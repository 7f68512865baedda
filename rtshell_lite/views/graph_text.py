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
    lanes = _lanes(nets)
    wide = max([cells(row.text) for row in rows] or [0])
    for number, row in enumerate(rows):
        beside, border = _beside(number, nets, lanes)
        if row.left in "┌├└":
            fill = "─"
        else:
            fill = " "
        if row.right != ">":
            text = row.text + fill * (wide - cells(row.text))
        else:
            text = " " * (wide - cells(row.text)) + row.text
        if row.right == ">":
            right = "│"
        else:
            right = row.right
        line = (row.left + text + (border or right) + beside).rstrip()
        yield line.translate(_ASCII).encode("ascii", "backslashreplace").decode() if ascii_only else line


def _stack(picture):
    """(Rows of all boxes, {(box, port): number of its row}).
    `>` as the right border marks text that is aligned right.
    """
    rows = []
    row_of = {}
    for place, number in enumerate(in_order(picture)):
        box = picture.boxes[number]
        rows.append(Row("├", "", "┤") if place else Row("┌", "", "┐"))
        rows += [Row("│", f" {head} ", "│") for head in heads(picture, number)]
        for side, mark in ((box.left, "│"), (box.right, ">")):
            for port in side:
                row_of[number, port] = len(rows)
                rows.append(Row("│", f" {printable(port)} ", mark))
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
    """The lane of each Net, counted from the boxes: short ones first, no two that overlap in one lane."""
    taken = []
    lanes = [0] * len(nets)
    for number in sorted(
        range(len(nets)), key=lambda n: (max(nets[n].rows) - min(nets[n].rows), nets[n].start)
    ):
        span = (min(nets[number].rows), max(nets[number].rows))
        lane = next(
            (
                i
                for i, spans in enumerate(taken)
                if all(span[1] < low or high < span[0] for low, high in spans)
            ),
            None,
        )
        if lane is None:
            lane = len(taken)
            taken.append([])
        taken[lane].append(span)
        lanes[number] = lane
    return lanes


def _beside(row, nets, lanes):
    """(what is drawn beside a row, the border of its box where a line starts or '')."""
    passing = {lane: net for net, lane in zip(nets, lanes) if min(net.rows) <= row <= max(net.rows)}
    joined = {lane: net for lane, net in passing.items() if row in net.rows}
    if joined:
        far = max(joined)
    else:
        far = -1
    service = int(any(net.service for net in joined.values()))
    arrives = any(row != net.start for net in joined.values())
    drawn = []
    for lane in range(max(passing) + 1 if passing else 0):
        if lane == 0 and arrives:
            drawn.append("<")
        elif lane <= far:
            drawn.append("─═"[service])
        else:
            drawn.append(" ")
        if lane in joined:
            net = joined[lane]
            drawn.append(
                _JOINTS[int(min(net.rows) < row), int(row < max(net.rows)), int(lane < far)][net.service]
            )
        elif lane in passing:
            drawn.append("│║"[passing[lane].service])
        else:
            drawn.append("─═"[service] if lane < far else " ")
    if joined and not arrives:
        border = "├╞"[service]
    else:
        border = ""
    return "".join(drawn), border
