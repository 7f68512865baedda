"""A system as SVG: boxes in columns as the data flows, from left to right, and lines between their ports."""

from rtshell_lite.text import cells, printable
from rtshell_lite.views import graph, layout

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
    heads = [graph.heads(picture, number) for number in range(len(picture.boxes))]
    sizes = [_size(box, words) for box, words in zip(picture.boxes, heads)]

    def port_of(item, port):
        return _port(item, picture.boxes[item.number], len(heads[item.number]), port)

    arranged = layout.arrange(picture, sizes, port_of)
    yield _HEAD % (arranged.width, arranged.height)
    for item, box, words in zip(arranged.boxes, picture.boxes, heads):
        yield from _drawn(item, box, words, port_of)
    for edge, way in zip(picture.edges, arranged.ways):
        source, out, target, into, service = edge
        start = port_of(arranged.boxes[source], out)
        end = port_of(arranged.boxes[target], into)
        yield _line(_path(start, end, way), service, _name(picture, edge))
    yield "</svg>"


def _size(box, heads):
    """(width, height) of a box."""
    lefts = [cells(printable(box.port_words(port))) for port in box.left]
    rights = [cells(printable(box.port_words(port))) for port in box.right]
    widths = [cells(head) for head in heads]
    widths.append(max(lefts, default=0) + max(rights, default=0) + 3)
    height = (len(heads) + max(len(lefts), len(rights))) * _ROW + _ROW // 2
    return (max(widths) + 1) * _CELL, height


def _port(item, box, heads, name):
    """(x, y, 1 on the right side and -1 on the left) of a port."""
    if name in box.right:
        row = heads + box.right.index(name)
        return item.x + item.width, item.y + row * _ROW + 15, 1
    row = heads + box.left.index(name)
    return item.x, item.y + row * _ROW + 15, -1


def _drawn(item, box, heads, port_of):
    more = ""
    if box.missing:
        more = ' stroke-dasharray="4"'
    elif box.counts is not None:
        more = ' stroke-width="3"'
    yield '<rect class="%s" x="%d" y="%d" width="%d" height="%d" rx="5" fill="%s" stroke="black"%s/>' % (
        _kind(box.state),
        item.x,
        item.y,
        item.width,
        item.height,
        _colour(box.state),
        more,
    )
    for row, head in enumerate(heads):
        yield _text(item.x + item.width // 2, item.y + row * _ROW + 19, "middle", head)
    for port in box.left + box.right:
        x, y, side = port_of(item, port)
        anchor = {1: "end", -1: "start"}[side]
        yield _text(x - 6 * side, y + 5, anchor, printable(box.port_words(port)))


def _kind(state):
    """The class of a box, for its colour in the dark."""
    if state is None:
        return "none"
    if state in graph.COLOURS:
        return state
    return "Unknown"


def _colour(state):
    if state is None:
        return "white"
    return graph.COLOURS.get(state, "lightgrey")


def _text(x, y, anchor, text):
    return '<text x="%d" y="%d" text-anchor="%s">%s</text>' % (x, y, anchor, _escaped(text))


def _escaped(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def _name(picture, edge):
    """What a line connects; a browser shows it when the mouse points at the line."""
    source, out, target, into, _ = edge
    ends = picture.boxes[source].name, out, picture.boxes[target].name, into
    return "%s:%s to %s:%s" % tuple(map(printable, ends))


def _path(start, end, way):
    """The path of a line from one port to another, by its way in a layout.Layout."""
    x, y, _ = start
    to_x, to_y, _ = end
    path = "M%d,%d" % (x, y)
    if isinstance(way, layout.Detour):
        for index, corner in enumerate(way.corners):
            path += " %s%d" % ("HV"[index % 2], corner)
        return path + " V%d H%d" % (to_y, to_x)
    for item in way:
        path += _curve(x, y, item.x, item.y) + " H%d" % (item.x + item.width)
        x = item.x + item.width
        y = item.y
    return path + _curve(x, y, to_x, to_y)


def _line(path, service, name):
    looks = 'stroke-dasharray="5,3" marker-end="url(#dot)"' if service else 'marker-end="url(#arrow)"'
    return f'<path d="{path}" fill="none" stroke="black" {looks}><title>{_escaped(name)}</title></path>'


def _curve(x, y, to_x, to_y):
    """A curve to the right that leaves and arrives horizontally."""
    middle = (x + to_x) // 2
    return " C%d,%d %d,%d %d,%d" % (middle, y, middle, to_y, to_x, to_y)
