"""The map beside that of Graphviz: `python3 tests/bench/map.py [--bare] [WORD …]` draws 24 systems with ours and
with `dot`, and prints for each: lines that go back, crossings, area, length of all lines, and the ratio of
ours to dot's. With words, only systems whose names contain one. It needs `dot` of Debian's graphviz.

`dot` gets the boxes as we draw them (ours are widened to their column) and the same lines between the same
ports, in tables of fixed size; with --bare the lines lead to boxes, wherever dot likes. It draws from left to
right, with its own distances. Lines are measured as polylines: 12 pieces of each curve. Crossings within 15
points of a port that both lines share are not counted. Ours may be in rows: a box in a later row comes later.
Areas are of what holds all boxes and lines.
"""  # noqa: E501

import itertools
import json
import math
import os
import random
import statistics
import subprocess
import sys
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path[:0] = [ROOT, os.path.join(ROOT, "tests", "unit"), os.path.join(ROOT, "tests", "support")]
import robot_maps  # noqa: E402: the path first
import test_xmlprofile  # noqa: E402
from rtshell_lite.views import graph, graph_svg  # noqa: E402
from rtshell_lite.views.layered import sheet  # noqa: E402
from rtshell_lite.xmlprofile import rtsprofile  # noqa: E402

PIECES = 12
SHARED = 15  # points around a port
CELL = 60  # points, of the grid in which crossings are looked for
PROFILES = (
    "MasutaniLab__KobukiForChoreonoid__RTSystem-125fbf19.xml",
    "OpenRTM__RTM_Tutorial__share__project__DoubleArmV7-RTSystem.xml",
    "OpenRTM__rtshell__test__rtsystem.xml",
    "OpenRTM__rtsprofile__test__rtsystem-63ab270c.yaml",
    "s-nakaoka__choreonoid-openrtm__sample__QuadcopterSystem.xml",
    "sugarsweetrobotics__simvehicle__system__DefaultSystem.xml",
    "sugarsweetrobotics__vrep_mcl_test__system__MobileRobotSystem-b99e900d.xml",
    "ysuga__leap_vehicle__system__DefaultSystem.xml",
)


class Drawing:
    """boxes: (left, top, right, bottom); lines: lists of points; back: how many lines go back."""

    def __init__(self, boxes, lines, back):
        self.boxes = boxes
        self.lines = lines
        self.back = back

    def area(self):
        xs = [x for box in self.boxes for x in box[::2]] + [x for line in self.lines for x, _ in line]
        ys = [y for box in self.boxes for y in box[1::2]] + [y for line in self.lines for _, y in line]
        return (max(xs) - min(xs)) * (max(ys) - min(ys))

    def length(self):
        return sum(math.dist(*piece) for line in self.lines for piece in zip(line, line[1:]))

    def crossings(self, edges):
        """How often lines cross; `edges` are those of the graph.Graph."""
        pieces = []
        cells = {}
        for number, line in enumerate(self.lines):
            for start, end in zip(line, line[1:]):
                for cell in cells_of(start, end):
                    cells.setdefault(cell, []).append(len(pieces))
                pieces.append((number, start, end))
        crossed = set()
        for inner in cells.values():
            for one, other in itertools.combinations(inner, 2):
                if pieces[one][0] != pieces[other][0] and cross(*pieces[one][1:] + pieces[other][1:]):
                    crossed.add((one, other))
        return sum(not self.is_shared(edges, pieces[one], pieces[other]) for one, other in crossed)

    def is_shared(self, edges, one, other):
        """Whether two pieces cross beside a port that is the end of both lines."""
        for end in (0, -1):
            for other_end in (0, -1):
                ports = [edges[piece[0]][:2] if side == 0 else edges[piece[0]][2:4]
                         for piece, side in ((one, end), (other, other_end))]
                if ports[0] == ports[1] and math.dist(self.lines[one[0]][end], one[1]) < SHARED:
                    return True
        return False


def cells_of(start, end):
    xs = sorted((start[0], end[0]))
    ys = sorted((start[1], end[1]))
    for x in range(int(xs[0] // CELL), int(xs[1] // CELL) + 1):
        for y in range(int(ys[0] // CELL), int(ys[1] // CELL) + 1):
            yield x, y


def side_of(start, end, point):
    return (end[0] - start[0]) * (point[1] - start[1]) - (end[1] - start[1]) * (point[0] - start[0])


def cross(start, end, other_start, other_end):
    return (side_of(start, end, other_start) * side_of(start, end, other_end) < 0
            and side_of(other_start, other_end, start) * side_of(other_start, other_end, end) < 0)


def curve(start, near, far, end):
    """Points of a Bézier curve after its start."""
    for step in range(1, PIECES + 1):
        t = step / PIECES
        weights = (1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3
        yield tuple(sum(weight * point[axis] for weight, point in zip(weights, (start, near, far, end)))
                    for axis in (0, 1))


# ---- ours ----


def ours(picture):
    """(Drawing, seconds of CPU)"""
    heads = [graph.heads(picture, number) for number in range(len(picture.boxes))]
    begun = time.process_time()
    sizes = [graph_svg._size(box, words) for box, words in zip(picture.boxes, heads)]
    layout = graph_svg.arrange(picture, sizes, heads)
    spent = time.process_time() - begun
    boxes = [(x, y, x + width, y + height)
             for (x, y), width, (_, height) in zip(layout.corners, layout.widths, sizes)]
    lines = []
    for way in layout.ways:
        line = way[:1]
        for x, y in way[1:]:
            last_x, last_y = line[-1]
            if x == last_x or y == last_y:
                line.append((x, y))
            else:
                middle = (x + last_x) / 2
                line += curve((last_x, last_y), (middle, last_y), (middle, y), (x, y))
        lines.append(line)
    columns = {}
    for part in sheet.parts(graph_svg.lines_of(picture, heads), sizes)[0]:
        for number, box in part.items.items():
            columns[number] = box.row, box.layer
    return Drawing(boxes, lines, count_back(columns, picture)), spent


def count_back(columns, picture):
    """How many lines lead to no later column."""
    pairs = [(edge[0], edge[2]) for edge in picture.edges if edge[0] != edge[2]]
    return sum(columns[target] <= columns[source] for source, target in pairs)


# ---- dot's ----


def table(box, heads, width):
    """A label of fixed size for dot, with ports where ours are."""
    cell = '<TD FIXEDSIZE="TRUE" WIDTH="%d" HEIGHT="%d"%s></TD>'
    rows = ['<TR>%s</TR>' % (cell % (width, 20 * heads, ' COLSPAN="2"'))]
    for left, right in itertools.zip_longest(box.left, box.right):
        cells = []
        for side, port, ports in (("l", left, box.left), ("r", right, box.right)):
            name = "" if port is None else ' PORT="%s%d"' % (side, ports.index(port))
            cells.append(cell % (width // 2, 20, name))
        rows.append("<TR>%s</TR>" % "".join(cells))
    rows.append("<TR>%s</TR>" % (cell % (width, 10, ' COLSPAN="2"')))
    return '<<TABLE BORDER="0" CELLBORDER="0" CELLSPACING="0" CELLPADDING="0">%s</TABLE>>' % "".join(rows)


def port_of(box, port):
    if port in box.right:
        return '"r%d":e' % box.right.index(port)
    return '"l%d":w' % box.left.index(port)


def dots(picture, widths, is_bare):
    """The Drawing that dot makes."""
    text = ["digraph { rankdir=LR; node [shape=plain];"]
    for number, box in enumerate(picture.boxes):
        label = table(box, len(graph.heads(picture, number)), widths[number])
        text.append("n%d [label=%s];" % (number, label))
    for source, out, target, into, _ in picture.edges:
        ends = source, port_of(picture.boxes[source], out), target, port_of(picture.boxes[target], into)
        if is_bare:
            text.append("n%d -> n%d;" % ends[::2])
        else:
            text.append("n%d:%s -> n%d:%s;" % ends)
    text.append("}")
    source = "\n".join(text).encode()
    said = subprocess.check_output(["dot", "-Tjson0"], input=source, stderr=subprocess.DEVNULL)
    read = json.loads(said.decode())
    boxes = [None] * len(picture.boxes)
    for node in read.get("objects", []):
        x, y = map(float, node["pos"].split(","))
        width, height = float(node["width"]) * 36, float(node["height"]) * 36
        boxes[int(node["name"][1:])] = x - width, y - height, x + width, y + height
    lines = []
    for edge in read.get("edges", []):
        words = [word for word in edge["pos"].split() if not word.startswith("e,")]
        end = [word[2:] for word in edge["pos"].split() if word.startswith("e,")]
        points = [tuple(map(float, word.split(","))) for word in words]
        line = points[:1]
        for start in range(0, len(points) - 1, 3):
            line += curve(*points[start : start + 4])
        lines.append(line + [tuple(map(float, end[0].split(",")))])
    return Drawing(boxes, lines, count_back([box[0] + box[2] for box in boxes], picture))


# ---- the systems ----


def systems():
    """(name, graph.Graph) of each."""
    files = {os.path.basename(name): name for name in test_xmlprofile.real_files()}
    for name in PROFILES:
        with open(files[name], "rb") as file:
            yield "profile " + name[:24], graph.of(rtsprofile.load(file.read(), name))
    for name, make in robot_maps.WORLDS:
        yield name, make()
    for seed in range(8):
        yield "random %d" % seed, robot_maps.random_system(random.Random(seed), 15 * (seed + 1))


def main(words):
    print("%-34s %11s  %15s  %19s  %19s  %6s" % ("system (boxes, lines)", "back", "crossings", "area / 1000",
                                                 "length", "CPU"))
    ratios = []
    is_bare = "--bare" in words
    words = [word for word in words if word != "--bare"]
    for name, picture in systems():
        if words and not any(word in name for word in words):
            continue
        drawn, spent = ours(picture)
        theirs = dots(picture, [int(right - left) for left, _, right, _ in drawn.boxes], is_bare)
        crossings = [each.crossings(picture.edges) for each in (drawn, theirs)]
        areas = [each.area() / 1000 for each in (drawn, theirs)]
        lengths = [each.length() for each in (drawn, theirs)]
        ratio = crossings[0] / crossings[1] if crossings[1] else (1 if not crossings[0] else math.inf)
        ratios.append((drawn.back - theirs.back, ratio, areas[0] / areas[1], lengths[0] / max(lengths[1], 1)))
        title = "%s (%d, %d)" % (name, len(picture.boxes), len(picture.edges))
        print("%-34s %3d %3d %+3d  %4d %4d %5.2f  %6.0f %6.0f %5.2f  %6.0f %6.0f %5.2f  %5.2fs" % (
            title, drawn.back, theirs.back, ratios[-1][0], *crossings, ratio, *areas, ratios[-1][2], *lengths,
            ratios[-1][3], spent), flush=True)
    for index, what in enumerate(("more lines back", "crossings", "area", "length")):
        column = [row[index] for row in ratios]
        print("%-16s median %5.2f, most %5.2f" % (what, statistics.median(column), max(column)))


if __name__ == "__main__":
    main(sys.argv[1:])
