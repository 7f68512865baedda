"""A system as SVG: boxes in columns as the data flows, from left to right, and lines between their ports."""

from rtshell_lite.text import cells, printable
from rtshell_lite.views import graph, group_names
from rtshell_lite.views.layered import sheet

# pixels: width of a character, height of a line of text
_CELL = 9
_ROW = 20

_HEAD = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d" font-family="monospace" font-size="14">\n'
    "<style>@media (prefers-color-scheme: dark) { .page { fill: #1c1c1c } text { fill: #eee } "
    "rect, path { stroke: #ccc } marker path { fill: #ccc } .none { fill: #1c1c1c } "
    ".Inactive { fill: #2a4a6a } .Active { fill: #1f4d2b } .Error { fill: #8a2a22 } "
    ".Created, .Unknown { fill: #444 } }</style>\n"
    '<defs><marker id="arrow" markerWidth="8" markerHeight="8" refX="7" refY="4" orient="auto">'
    '<path d="M0,0 L8,4 L0,8 z" stroke="none"/></marker><marker id="dot" markerWidth="9" markerHeight="9" '
    'refX="7" refY="4"><circle cx="4" cy="4" r="3" fill="white" stroke="black"/></marker></defs>\n<rect '
    'class="page" width="100%%" height="100%%" fill="white"/>'
)


def lines(picture):
    """The lines of an SVG file that shows a graph.Graph; boxes are coloured by their states."""
    labels = group_names.of_boxes(picture)
    heads = [graph.heads(picture, number, labels) for number in range(len(picture.boxes))]
    sizes = [_size(box, words) for box, words in zip(picture.boxes, heads)]
    arranged = arrange(picture, sizes, heads)
    yield _HEAD % (arranged.width, arranged.height)
    boxes = zip(picture.boxes, heads, arranged.corners, arranged.widths, sizes)
    for box, words, corner, width, (_, height) in boxes:
        yield from _drawn(box, words, corner, (width, height))
    for edge, way in zip(picture.edges, arranged.ways):
        yield _line(_path(way), edge[4], _name(picture, edge, labels))
    yield "</svg>"


def arrange(picture, sizes, heads):
    """The sheet.Layout of a graph.Graph with boxes of these sizes and lines of text."""
    return sheet.arrange(lines_of(picture, heads), sizes, [box.name for box in picture.boxes])


def lines_of(picture, heads):
    """The sheet.Lines of a graph.Graph with boxes of these lines of text."""

    def port(number, name):
        return _port(picture.boxes[number], len(heads[number]), name)

    return [
        sheet.Line(source, target, port(source, out), port(target, into), service)
        for source, out, target, into, service in picture.edges
    ]


def _size(box, heads):
    """(width, height) of a box."""
    lefts = [cells(printable(box.port_words(port))) for port in box.left]
    rights = [cells(printable(box.port_words(port))) for port in box.right]
    widths = [cells(head) for head in heads]
    widths.append(max(lefts, default=0) + max(rights, default=0) + 3)
    height = (len(heads) + max(len(lefts), len(rights))) * _ROW + _ROW // 2
    return (max(widths) + 1) * _CELL, height


def _port(box, heads, name):
    """(y on its box, 1 for the right side or 0 for the left) of a port."""
    side = int(name in box.right)
    ports = box.right if side else box.left
    return (heads + ports.index(name)) * _ROW + 15, side


def _drawn(box, heads, corner, size):
    x, y = corner
    width, height = size
    more = ""
    if box.missing:
        more = ' stroke-dasharray="4"'
    elif box.counts is not None:
        more = ' stroke-width="3"'
    yield '<rect class="%s" x="%d" y="%d" width="%d" height="%d" rx="5" fill="%s" stroke="black"%s/>' % (
        _kind(box.state), x, y, width, height, _colour(box.state), more,
    )
    for row, head in enumerate(heads):
        yield _text(x + width // 2, y + row * _ROW + 19, "middle", head)
    for port in box.left + box.right:
        port_y, side = _port(box, len(heads), port)
        words = printable(box.port_words(port))
        if side:
            yield _text(x + width - 6, y + port_y + 5, "end", words)
        else:
            yield _text(x + 6, y + port_y + 5, "start", words)


def _kind(state):
    """The class of a box, for its colour in the dark."""
    if state is None:
        return "none"
    if state in graph.COLOURS:
        return state
    return "Unknown"


def _colour(state):
    return "white" if state is None else graph.COLOURS.get(state, "lightgrey")


def _text(x, y, anchor, text):
    return '<text x="%d" y="%d" text-anchor="%s">%s</text>' % (x, y, anchor, _escaped(text))


def _escaped(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def _name(picture, edge, labels):
    """What a line connects; a browser shows it when the mouse points at the line."""
    source, out, target, into, _ = edge
    names = [graph.name_of(picture, number, labels) for number in (source, target)]
    return f"{names[0]}:{printable(out)} to {names[1]}:{printable(into)}"


def _path(points):
    """The path of a line through points: straight, or a curve that begins and ends level."""
    x, y = points[0]
    path = f"M{x},{y}"
    for to_x, to_y in points[1:]:
        if to_y == y:
            path += f" H{to_x}"
        elif to_x == x:
            path += f" V{to_y}"
        else:
            middle = (x + to_x) // 2
            path += f" C{middle},{y} {middle},{to_y} {to_x},{to_y}"
        x, y = to_x, to_y
    return path


def _line(path, service, name):
    looks = 'stroke-dasharray="5,3" marker-end="url(#dot)"' if service else 'marker-end="url(#arrow)"'
    return f'<path d="{path}" fill="none" stroke="black" {looks}><title>{_escaped(name)}</title></path>'
