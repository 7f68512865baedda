"""Systems as SVG: if this fails, boxes overlap, or lines do not connect their ports."""
import collections
import itertools
import os
import random
import re
import time
import unittest
from xml.etree import ElementTree

import large_robots
import random_profiles
import test_graph
import test_xmlprofile
from rtshell_lite.views import graph, graph_svg, graph_text
from rtshell_lite.views.layered import lines
from rtshell_lite.xmlprofile import model, rtsprofile

ONCE = "where boxes and lines are put is arithmetic"

SVG = "{http://www.w3.org/2000/svg}"


class Picture:
    """An SVG as its boxes (left, top, right, bottom), texts (x, y, text), and its lines: their two ends, all
    points that they lead through or that bend them, straight pieces, and curves with their four points.
    """

    def __init__(self, found):
        self.source = list(graph_svg.lines(found))
        root = ElementTree.fromstring("\n".join(self.source))
        self.size = int(root.get("width")), int(root.get("height"))
        self.boxes = []
        for rect in root.findall(SVG + "rect")[1:]:
            x, y, width, height = [int(rect.get(name)) for name in ("x", "y", "width", "height")]
            self.boxes.append((x, y, x + width, y + height))
        self.colours = [rect.get("fill") for rect in root.findall(SVG + "rect")[1:]]
        self.texts = {
            (int(text.get("x")), int(text.get("y")), text.text or "") for text in root.findall(SVG + "text")
        }
        self.lines = []
        self.points = []
        self.pieces = []  # of each line: [(x, y, x, y)]
        self.curves = []
        self.paths = [path.get("d") for path in root.findall(SVG + "path")]
        for path in root.findall(SVG + "path"):
            corners, straight, curves = parts_of(path.get("d"))
            self.points += corners
            self.lines.append((corners[0], corners[-1]))
            self.pieces.append(straight)
            self.curves += curves


def parts_of(path):
    """([(x, y)] of the ends and the corners of a line, and of what bends it, [(x, y, x, y)] of straight
    pieces, [[(x, y)] of curves]).
    """
    x = y = None
    corners, straight, curves = [], [], []
    for letter, words in re.findall(r"([MHVC])([-\d, ]+)", path):
        numbers = [int(word) for word in re.findall(r"-?\d+", words)]
        if letter == "H":
            numbers = [numbers[0], y]
        elif letter == "V":
            numbers = [x, numbers[0]]
        if letter in "HV":
            straight.append((x, y) + tuple(numbers))
        points = list(zip(numbers[::2], numbers[1::2]))
        if letter == "C":
            curves.append(corners[-1:] + points)
        corners += points
        x, y = corners[-1]
    return corners, straight, curves


def is_in(line, box):
    """Whether a part of a straight line is inside a box."""
    x, y, to_x, to_y = line
    left, top, right, bottom = box
    return min(x, to_x) < right and left < max(x, to_x) and min(y, to_y) < bottom and top < max(y, to_y)


def chain(names):
    """A profile of components that follow one another."""
    pairs = zip(names, names[1:])
    return model.RtsProfile(
        components=[test_graph.component(name) for name in names],
        data_port_connectors=[test_graph.data((one, "out"), (other, "in")) for one, other in pairs],
    )


class Svg(unittest.TestCase):
    def check(self, found, twice=True):
        picture = Picture(found)
        self.assertEqual(len(picture.boxes), len(found.boxes))
        for one, other in itertools.combinations(picture.boxes, 2):
            apart = one[2] <= other[0] or other[2] <= one[0] or one[3] <= other[1] or other[3] <= one[1]
            self.assertTrue(apart, (one, other))
        for left, top, right, bottom in picture.boxes:
            self.assertTrue(0 <= left < right <= picture.size[0] and 0 <= top < bottom <= picture.size[1])
        self.assertEqual(len(picture.lines), len(found.edges))
        for (one, out, other, into, _), ends in zip(found.edges, picture.lines):
            for number, port, (x, y) in ((one, out, ends[0]), (other, into, ends[1])):
                right = port in found.boxes[number].right
                self.assertEqual(x, picture.boxes[number][2 if right else 0])
                self.assertIn((x - 6 if right else x + 6, y + 5, graph_svg.printable(port)), picture.texts)
        for x, y in picture.points:
            self.assertTrue(0 <= x <= picture.size[0] and 0 <= y <= picture.size[1], (x, y))
        self.check_tracks(found, picture)
        if twice:
            self.assertEqual(picture.source, list(graph_svg.lines(found)))
        return picture

    def check_tracks(self, found, picture):
        """No two lines are on one track, but those from one port, beside it; none is behind a box; all leave
        ports level, and far enough to be seen.
        """
        tracks = collections.defaultdict(list)
        for edge, pieces in zip(found.edges, picture.pieces):
            for index, (x, y, to_x, to_y) in enumerate(pieces):
                if x == to_x:
                    tracks["x", x].append(tuple(sorted((y, to_y))) + (None, None))
                    continue
                ports = edge[:2] * (index == 0), edge[2:4] * (index == len(pieces) - 1)
                tracks["y", y].append(tuple(sorted((x, to_x))) + ports)
        for where, spans in tracks.items():
            spans.sort(key=lambda span: span[:2])
            end = -1
            owners = set()  # ports of the lines that overlap
            for start, stop, *ports in spans:
                if start > end:
                    owners = set()
                elif not owners & set(filter(None, ports)):
                    self.fail("two lines on one track: %s %s" % (where, spans))
                owners.update(filter(None, ports))
                end = max(end, stop)
        for line in sum(picture.pieces, []):
            crossed = [box for box in picture.boxes if is_in(line, box)]
            self.assertEqual(crossed, [], line)
        for curve in picture.curves:
            (x, y), (near, near_y), (far, far_y), (to_x, to_y) = curve
            self.assertEqual((y, to_y, near), (near_y, far_y, far), "a curve begins and ends level")
            self.assertLessEqual(lines.BESIDE, abs(x - to_x))
            crossed = [box for box in picture.boxes if is_in((x, y, to_x, to_y), box)]
            self.assertEqual(crossed, [], curve)
        for pieces in picture.pieces:
            for x, y, to_x, to_y in pieces[:1] + pieces[-1:]:
                if len(pieces) > 2:
                    self.assertTrue(y == to_y and abs(x - to_x) >= lines.LANE, pieces)

    def test_nothing(self):
        self.assertEqual(self.check(graph.of(model.RtsProfile())).boxes, [])

    def test_data_flows_to_the_right(self):
        profile = model.RtsProfile(
            components=[test_graph.component(name) for name in "ACBZ"],
            data_port_connectors=[
                test_graph.data(("A", "out"), ("B", "in")),
                test_graph.data(("B", "out"), ("C", "in")),
                test_graph.data(("A", "out"), ("C", "also")),
                test_graph.data(("C", "back"), ("A", "in")),
            ],
        )
        found = self.check(graph.of(profile, {"localhost/A.rtc": "Error"}))
        a, c, b, _ = found.boxes
        self.assertTrue(a[2] < b[0] and b[2] < c[0])
        self.assertEqual(found.colours, ["salmon", "white", "white", "white"])

    def test_colours(self):
        states = ["Inactive", "Active", "Error", "Created", "Unknown", "Strange"]
        profile = model.RtsProfile(components=[test_graph.component(state) for state in states])
        found = self.check(graph.of(profile, {"localhost/%s.rtc" % state: state for state in states}))
        self.assertEqual(
            found.colours, ["lightblue", "palegreen", "salmon", "white", "lightgrey", "lightgrey"]
        )
        self.assertEqual(graph.COLOURS["Unknown"], "lightgrey")

    def test_columns_follow_one_another_in_rows(self):
        """As words on a page do: from left to right, then below."""
        found = self.check(graph.of(chain("abcdefghijklmnopqrst")))
        places = [(top, left) for left, top, _, _ in found.boxes]
        self.assertEqual(places, sorted(places))
        rows = {top for top, _ in places}
        self.assertEqual((len(rows), len(places)), (4, 20))

    def test_proportions_of_a_page(self):
        """From a chain to components that are not connected, large and small."""
        for count in (20, 60, 200):
            names = ["Component%d" % number for number in range(count)]
            one_hub = model.RtsProfile(
                components=[test_graph.component(name) for name in names],
                data_port_connectors=[
                    test_graph.data((name, "out"), (names[-1], "in")) for name in names[:-1]
                ],
            )
            alone = model.RtsProfile(components=one_hub.components)
            for profile in (chain(names), one_hub, alone, large_robots.profile(count)):
                width, height = self.check(graph.of(profile)).size
                self.assertTrue(0.5 <= width / height <= 2.5, (count, width, height))

    def test_a_short_row_is_not_folded(self):
        found = self.check(graph.of(chain("abc")))
        self.assertEqual(len({top for _, top, _, _ in found.boxes}), 1)

    def test_lines_to_other_rows(self):
        """Each has one lane between rows that follow one another, else two, and passes beside all rows: below
        the row where it begins, above that where it ends. So one line back crosses nothing.
        """
        names = "abcdefghijklmnopqrst"
        profile = chain(names)
        profile.data_port_connectors.append(test_graph.data(("a", "out"), ("t", "in")))
        profile.data_port_connectors.append(test_graph.data(("t", "out"), ("b", "in")))
        found = self.check(graph.of(profile))
        right = max(box[2] for box in found.boxes)
        pieces = sum(found.pieces, [])
        outside = [piece for piece in pieces if piece[0] == piece[2] and piece[0] > right + lines.LANE]
        self.assertEqual(len(outside), 2)
        self.assertGreater(max(max(piece[1::2]) for piece in outside), max(box[3] for box in found.boxes))

    def test_a_port_that_is_connected_with_itself_has_a_line(self):
        profile = chain(["a", "b"])
        profile.data_port_connectors.append(test_graph.data(("b", "in"), ("b", "in")))
        found = self.check(graph.of(profile))
        self.assertGreater(len(set(parts_of(found.paths[-1])[0])), 2)

    def test_one_wide_box_alone_is_one_row(self):
        profile = model.RtsProfile(
            components=[test_graph.component("a" * 230)],
            data_port_connectors=[test_graph.data(("a" * 230, "out"), ("a" * 230, "in"))],
        )
        self.check(graph.of(profile))

    def test_random_ones(self):
        for seed in range(500):
            chance = random.Random(seed)
            names = [str(number) for number in range(chance.choice((1, 3, 9, 30)))]
            profile = model.RtsProfile(
                components=[test_graph.component(name, chance.sample(names, 1)) for name in names]
            )
            for _ in range(chance.randint(0, 3 * len(names))):
                ends = [
                    (chance.choice(names), "in%d" % chance.randint(1, 2)) for _ in range(chance.randint(1, 3))
                ]
                profile.data_port_connectors.append(
                    test_graph.data((chance.choice(names + ["gone"]), "out%d" % chance.randint(1, 2)), *ends))
            with self.subTest(seed):
                self.check(graph.of(profile), twice=seed % 10 == 0)

    def test_hostile_and_real_ones(self):
        for seed in range(50):
            with self.subTest(seed):
                self.check(graph.of(random_profiles.Maker(seed).profile()))
        for name in test_xmlprofile.real_files():
            with self.subTest(os.path.basename(name)), open(name, "rb") as file:
                self.check(graph.of(rtsprofile.load(file.read(), name)))

    def test_big_ones(self):
        """Each component is connected to the next two, in a circle."""
        names = [str(number) for number in range(1000)]
        profile = model.RtsProfile(
            components=[test_graph.component(name) for name in names],
            data_port_connectors=[
                test_graph.data((name, "out"), (names[(int(name) + step) % 1000], "in"))
                for name in names
                for step in (1, 2)
            ],
        )
        begun = time.process_time()
        found = graph.of(profile)
        self.assertEqual(sum(line.startswith("<path") for line in graph_svg.lines(found)), 2000)
        self.assertEqual(len(list(graph_text.lines(found))), 4001)
        self.assertLess(time.process_time() - begun, 10)


if __name__ == "__main__":
    unittest.main()
