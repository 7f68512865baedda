"""Systems as SVG: if this fails, boxes overlap, or lines do not connect their ports."""
import itertools
import os
import random
import re
import time
import unittest
from xml.etree import ElementTree

import random_profiles
import test_graph
import test_xmlprofile
from rtshell_lite.views import graph, graph_svg, graph_text, layout
from rtshell_lite.xmlprofile import model, rtsprofile

PART = 6  # a short run takes one in PART of its tests
SVG = "{http://www.w3.org/2000/svg}"


class Picture:
    """An SVG as its boxes (left, top, right, bottom), texts (x, y, text), and the two ends of its lines."""

    def __init__(self, found):
        root = ElementTree.fromstring("\n".join(graph_svg.lines(found)))
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
        self.turns = []
        # (x, y); ("x" or "y", where, from, to) of straight lines beside and below the boxes
        self.points = []
        self.tracks = []
        for path in root.findall(SVG + "path"):
            x, y = re.match(r"M(-?\d+),(-?\d+)", path.get("d")).groups()
            around = re.search(r"V(-?\d+) H(-?\d+)\Z", path.get("d"))
            if around:  # it turns beside the boxes
                turns = re.match(
                    r"M(-?\d+),-?\d+ H(-?\d+) V-?\d+ H(-?\d+) V-?\d+ H(-?\d+)\Z", path.get("d")
                ).groups()
                self.turns.append(tuple(map(int, turns)))
                lane = int(re.search(r"V(-?\d+) ", path.get("d")).group(1))
                self.points += [(int(turns[1]), lane), (int(turns[2]), lane)]
                for turn, height in ((turns[1], y), (turns[2], around.group(1))):
                    self.tracks.append(("x", int(turn), int(height), lane))
                self.tracks.append(("y", lane) + tuple(sorted(map(int, turns[1:3]))))
            else:
                self.points += [(int(x), int(y)) for x, y in re.findall(r"(-?\d+),(-?\d+)", path.get("d"))]
            end = (
                (around.group(2), around.group(1))
                if around
                else re.search(r"(-?\d+),(-?\d+)\Z", path.get("d")).groups()
            )
            self.lines.append(((int(x), int(y)), tuple(map(int, end))))


class Svg(unittest.TestCase):
    def check(self, found):
        picture = Picture(found)
        self.assertEqual(len(picture.boxes), len(found.boxes))
        for one, other in itertools.combinations(picture.boxes, 2):
            self.assertTrue(
                one[2] <= other[0] or other[2] <= one[0] or one[3] <= other[1] or other[3] <= one[1],
                (one, other),
            )
        for left, top, right, bottom in picture.boxes:
            self.assertTrue(0 <= left < right <= picture.size[0] and 0 <= top < bottom <= picture.size[1])
        self.assertEqual(len(picture.lines), len(found.edges))
        for (one, out, other, into, _), ends in zip(found.edges, picture.lines):
            for number, port, (x, y) in ((one, out, ends[0]), (other, into, ends[1])):
                right = port in found.boxes[number].right
                self.assertEqual(x, picture.boxes[number][2 if right else 0])
                self.assertIn((x - 6 if right else x + 6, y + 5, graph_svg.printable(port)), picture.texts)
        for left, turn, other_turn, right in picture.turns:
            for end, beside in ((left, turn), (right, other_turn)):
                self.assertTrue(layout.LANE <= abs(end - beside), (end, beside))
        for x, y in picture.points:
            self.assertTrue(0 <= x <= picture.size[0] and 0 <= y <= picture.size[1], (x, y))
        for one, other in itertools.combinations(picture.tracks, 2):
            if one[:2] == other[:2]:
                self.assertTrue(one[3] < other[2] or other[3] < one[2], (one, other))
        self.assertEqual(list(graph_svg.lines(found)), list(graph_svg.lines(found)))
        return picture

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

    def test_random_ones(self):
        for seed in range(100):
            chance = random.Random(seed)
            names = [str(number) for number in range(chance.randint(1, 9))]
            profile = model.RtsProfile(
                components=[test_graph.component(name, chance.sample(names, 1)) for name in names]
            )
            for _ in range(chance.randint(0, 12)):
                ends = [
                    (chance.choice(names), "in%d" % chance.randint(1, 2)) for _ in range(chance.randint(1, 3))
                ]
                profile.data_port_connectors.append(
                    test_graph.data((chance.choice(names + ["gone"]), "out%d" % chance.randint(1, 2)), *ends))
            with self.subTest(seed):
                self.check(graph.of(profile))

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
