"""A system drawn in the terminal, or as SVG: boxes below each other, as the data goes, and a lane for each out port beside.

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

from rtshell_lite.graph import COLOURS
from rtshell_lite.text import cells, printable

# A row of the stack of boxes: text between its borders, and the borders.
Row = collections.namedtuple("Row", "left text right")

# What lies between the ports of one connection: the rows it joins, the row where it starts, whether it is a service.
Net = collections.namedtuple("Net", "rows start service")

# Joints by (goes up, goes down, goes on to the right); they all come from the left.
_JOINTS = {(0, 1, 0): "┐╗", (1, 0, 0): "┘╝", (1, 1, 0): "┤╣",
           (0, 1, 1): "┬╦", (1, 0, 1): "┴╩", (1, 1, 1): "┼╬"}
_ASCII = {ord(c): "+" for c in "┌┐└┘├┤┬┴┼╗╝╣╦╩╬╞"}
_ASCII.update({ord("─"): "-", ord("│"): "|", ord("═"): "=", ord("║"): ":"})


def lines(graph, ascii_only=False):
    """The lines of the drawing of a graph.Graph; with `ascii_only` nothing but ASCII."""
    rows, at = _stack(graph)
    nets = _nets(graph, at)
    lanes = _lanes(nets)
    wide = max([cells(row.text) for row in rows] or [0])
    for number, row in enumerate(rows):
        beside, border = _beside(number, nets, lanes)
        fill = "─" if row.left in "┌├└" else " "
        text = row.text + fill * (wide - cells(row.text)) if row.right != ">" else \
            " " * (wide - cells(row.text)) + row.text
        right = "│" if row.right == ">" else row.right
        line = (row.left + text + (border or right) + beside).rstrip()
        yield line.translate(_ASCII).encode("ascii", "backslashreplace").decode() if ascii_only else line


def _stack(graph):
    """(Rows of all boxes, {(box, port): number of its row}). The right border `>` marks text that goes to the right."""
    order, rows, at = _order(graph), [], {}
    parents = {member: box.name for box in graph.boxes for member in box.members}
    for place, number in enumerate(order):
        box = graph.boxes[number]
        rows.append(Row("├", "", "┤") if place else Row("┌", "", "┐"))
        rows.append(Row("│", " %s " % "  ".join(_title(box, parents.get(number))), "│"))
        if box.members:
            rows.append(Row("│", " made of %s " % ", ".join(printable(graph.boxes[m].name) for m in box.members), "│"))
        for side, mark in ((box.left, "│"), (box.right, ">")):
            for port in side:
                at[number, port] = len(rows)
                rows.append(Row("│", " %s " % printable(port), mark))
    return rows + [Row("└", "", "┘")] * bool(rows), at


def _title(box, parent):
    words = [printable(box.name)]
    if box.missing:
        words.append("(not in the profile)")
    if box.state is not None:
        words.append(box.state)
    return words + (["(in %s)" % printable(parent)] if parent is not None else [])


def _order(graph):
    """Numbers of the boxes such that data flows downwards where it can; as they come where it goes round in a circle."""
    waiting, order = collections.OrderedDict.fromkeys(range(len(graph.boxes))), []
    above = {number: set() for number in waiting}
    for one, _, other, _, service in graph.edges:
        if one != other and not service:
            above[other].add(one)
    below = {number: [other for other in above if number in above[other]] for number in waiting}
    left = {number: len(above[number]) for number in waiting}
    ready = collections.deque(number for number in waiting if not left[number])
    while waiting:
        number = ready.popleft() if ready else next(iter(waiting))
        if number not in waiting:
            continue
        del waiting[number]
        order.append(number)
        for other in reversed(below[number]):
            left[other] -= 1
            if not left[other]:
                ready.appendleft(other)
    return order


def _nets(graph, at):
    """The Nets: one for each port that connections start at, and kind."""
    rows = collections.OrderedDict()
    for one, out, other, into, service in graph.edges:
        rows.setdefault((at[one, out], service), set()).update([at[one, out], at[other, into]])
    return [Net(joined, start, service) for (start, service), joined in rows.items() if len(joined) > 1]


def _lanes(nets):
    """The lane of each Net, counted from the boxes: short ones first, no two in one lane beside the same row."""
    taken, lanes = [], [0] * len(nets)
    for number in sorted(range(len(nets)), key=lambda n: (max(nets[n].rows) - min(nets[n].rows), nets[n].start)):
        span = (min(nets[number].rows), max(nets[number].rows))
        lane = next((i for i, spans in enumerate(taken) if all(span[1] < low or high < span[0] for low, high in spans)), None)
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
    far = max(joined) if joined else -1
    service = int(any(net.service for net in joined.values()))
    arrives = any(row != net.start for net in joined.values())
    drawn = []
    for lane in range(max(passing) + 1 if passing else 0):
        drawn.append("<" if lane == 0 and arrives else "─═"[service] if lane <= far else " ")
        if lane in joined:
            net = joined[lane]
            drawn.append(_JOINTS[int(min(net.rows) < row), int(row < max(net.rows)), int(lane < far)][net.service])
        elif lane in passing:
            drawn.append("│║"[passing[lane].service])
        else:
            drawn.append("─═"[service] if lane < far else " ")
    border = "├╞"[service] if joined and not arrives else ""
    return "".join(drawn), border


# ---- SVG ------------------------------------------------------------------------------------------------------

_ROW, _CELL, _LANE = 20, 9, 14  # pixels: height of a row, width of a character, between lanes
_HEAD = ('<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d" font-family="monospace" font-size="14">\n'
         '<defs><marker id="arrow" markerWidth="8" markerHeight="8" refX="7" refY="4" orient="auto">'
         '<path d="M0,0 L8,4 L0,8 z"/></marker></defs>\n<rect width="100%%" height="100%%" fill="white"/>')


def svg(graph):
    """Lines of an SVG file: the same drawing, boxes coloured by their states."""
    rows, at = _stack(graph)
    nets = _nets(graph, at)
    lanes = _lanes(nets)
    wide = max([cells(row.text) for row in rows] or [0]) * _CELL
    yield _HEAD % (wide + (max(lanes or [0]) + 3) * _LANE + _LANE, (len(rows) + 1) * _ROW)
    tops = [number for number, row in enumerate(rows) if not row.text]
    for box, top, bottom in zip(_order(graph), tops, tops[1:]):
        colour = COLOURS.get(graph.boxes[box].state, "white" if graph.boxes[box].state is None else "lightgrey")
        yield '<rect x="%d" y="%d" width="%d" height="%d" rx="5" fill="%s" stroke="black"%s/>' % (
            _LANE, top * _ROW + 14, wide, (bottom - top) * _ROW - 6, colour,
            ' stroke-dasharray="4"' if graph.boxes[box].missing else "")
    for number, row in enumerate(rows):
        if row.text:
            x, anchor = (_LANE + wide - 5, "end") if row.right == ">" else (_LANE + 5, "start")
            yield '<text x="%d" y="%d" text-anchor="%s">%s</text>' % (
                x, number * _ROW + 16, anchor, row.text.strip().replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;"))
    for net, lane in zip(nets, lanes):
        for end in sorted(net.rows - {net.start}):
            yield '<path d="M%d,%d H%d V%d H%d" fill="none" stroke="%s" marker-end="url(#arrow)"/>' % (
                _LANE + wide, net.start * _ROW + 11, wide + (lane + 3) * _LANE, end * _ROW + 11, _LANE + wide,
                'black" stroke-dasharray="5,3' if net.service else "black")
    yield "</svg>"
