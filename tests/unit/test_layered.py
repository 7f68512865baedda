"""Layered drawing: if this fails, loops of control are torn, lines go back or cross without need, or a
picture differs from run to run.
"""
import hashlib
import itertools
import os
import random
import subprocess
import sys
import unittest

import robot_maps
from rtshell_lite.views import graph, graph_svg, graph_text
from rtshell_lite.views.layered import crossings, cycles, heights, item, layers, lines, sheet


def weights_of(text):
    """{(source, target): 1} of "0>1 1>2"."""
    return {tuple(map(int, line.split(">"))): 1 for line in text.split()}


def layout_of(picture):
    """(sizes, sheet.Layout) of a graph.Graph, as its SVG has it."""
    heads = [graph.heads(picture, number) for number in range(len(picture.boxes))]
    sizes = [graph_svg._size(box, words) for box, words in zip(picture.boxes, heads)]
    return sizes, graph_svg.arrange(picture, sizes, heads)


def parts_of(picture):
    """The sheet.Parts of a graph.Graph, as its SVG has them."""
    sizes, _ = layout_of(picture)
    heads = [graph.heads(picture, number) for number in range(len(picture.boxes))]
    return sheet.parts(graph_svg.lines_of(picture, heads), sizes)[0]


def random_robot(seed):
    """One of those that tests/bench/map.py compares with Graphviz's."""
    return robot_maps.random_system(random.Random(seed), 15 * (seed + 1))


def names_back(picture):
    """"Source Target" of the lines that go back, by the layers of the boxes."""
    boxes = [entry for part in parts_of(picture) for entry in part.items.items()]
    column = {number: (box.row, box.layer) for number, box in boxes}
    names = [box.name for box in picture.boxes]
    return [
        "%s %s" % (names[source], names[target])
        for source, _, target, _, _ in picture.edges
        if column[target] <= column[source]
    ]


class Cycles(unittest.TestCase):
    def back(self, ordered, weights):
        rank = {number: index for index, number in enumerate(ordered)}
        return [pair for pair in weights if rank[pair[0]] > rank[pair[1]]]

    def test_nothing_goes_back_without_a_circle(self):
        for seed in range(100):
            chance = random.Random(seed)
            numbers = list(range(20))
            chance.shuffle(numbers)
            pairs = [sorted(chance.sample(range(20), 2)) for _ in range(40)]
            weights = {(numbers[one], numbers[other]): 1 for one, other in pairs}
            ordered = cycles.order(weights, 20)
            self.assertEqual((sorted(ordered), self.back(ordered, weights)), (list(range(20)), []))

    def test_few_go_back(self):
        """Compared with the least of all orders."""
        more = 0
        orders = list(itertools.permutations(range(6)))
        for seed in range(20):
            chance = random.Random(seed)
            weights = {}
            while len(weights) < 10:
                weights[tuple(chance.sample(range(6), 2))] = chance.choice((1, 2))
            ordered = cycles.order(weights, 6)
            counts = [sum(weights[pair] for pair in self.back(each, weights)) for each in orders]
            more += sum(weights[pair] for pair in self.back(ordered, weights)) - min(counts)
        self.assertLessEqual(more, 1)

    def test_a_loop_is_broken_where_it_is_fed(self):
        """4 feeds 2, of the circle 0 1 2 3."""
        weights = weights_of("0>1 1>2 2>3 3>0 4>2")
        self.assertEqual(self.back(cycles.order(weights, 5), weights), [(1, 2)])

    def test_loops_are_broken_before_what_they_have_in_common(self):
        """0 feeds 1 and 4; from each there are three ways to one box, which feeds 0."""
        text = "0>1 1>2 2>10 2>11 2>12 10>3 11>3 12>3 3>0 0>4 4>5 5>13 5>14 5>15 13>6 14>6 15>6 6>0"
        weights = weights_of(text)
        self.assertEqual(sorted(self.back(cycles.order(weights, 16), weights)), [(3, 0), (6, 0)])

    def test_data_goes_ahead_of_services(self):
        for weights in ({(0, 1): 2, (1, 0): 1}, {(0, 1): 1, (1, 0): 2}):
            ordered = cycles.order(weights, 2)
            self.assertEqual(self.back(ordered, weights), [min(weights, key=weights.get)])


class Layers(unittest.TestCase):
    def assign(self, text, count):
        weights = weights_of(text)
        return layers.assign(cycles.order(weights, count), weights)

    def test_sources_stand_beside_what_they_feed(self):
        """4 and 5 feed 6, which feeds 3, the last of a chain."""
        self.assertEqual(self.assign("0>1 1>2 2>3 4>6 5>6 6>3", 7), [0, 1, 2, 3, 1, 1, 2])

    def test_nothing_goes_back_that_need_not(self):
        for seed in range(100):
            chance = random.Random(seed)
            weights = {tuple(chance.sample(range(15), 2)): 1 for _ in range(30)}
            layer = layers.assign(cycles.order(weights, 15), weights)
            self.assertEqual(sorted(set(layer)), list(range(max(layer) + 1)))
            ahead = {pair for pair in weights if layer[pair[0]] < layer[pair[1]]}
            for source, target in set(weights) - ahead:
                self.assertGreaterEqual(layer[source], layer[target])
            same = {pair for pair in weights if layer[pair[0]] == layer[pair[1]]}
            self.assertEqual(same, set(), "a line within a layer goes back, and need not")

    def test_a_tall_layer_is_divided(self):
        self.assertEqual(layers.columns([0] * 6 + [1], [10] * 7, 25), [[0, 3], [1, 4], [2, 5], [6]])
        self.assertEqual(layers.columns([0] * 6 + [1] * 5, [10] * 11, 25),
                         [list(range(6)), list(range(6, 11))])
        self.assertEqual(layers.columns([0] * 3 + [1], [10] * 4, 25), [[0, 1, 2], [3]])


def between(chance, size):
    """Two layers of Items with lines at random, some of which turn around."""
    columns = [[item.Item(number, 10, 50) for number in range(size)] for _ in range(2)]
    for _ in range(3 * size):
        ends = []
        for _ in range(2):
            side = chance.randrange(2)
            ends.append((chance.choice(columns[side]), 1 - side, chance.randrange(50)))
        if ends[0] != ends[1]:
            item.join(ends[0], ends[1], 1)
    for items in columns:
        crossings.stack(items)
    return columns


class Crossings(unittest.TestCase):
    def test_are_counted(self):
        """As pairs of chords of a circle, one by one."""
        for seed in range(50):
            columns = between(random.Random(seed), 6)
            points = {}
            for side, items in ((1, columns[0]), (0, columns[1][::-1])):
                for box in items:
                    ys = range(50) if side else range(49, -1, -1)
                    points.update({(box, side, y): len(points) + index for index, y in enumerate(ys)})
            chords = [
                (points[box, side, here], points[other, other_side, there])
                for side, items in ((1, columns[0]), (0, columns[1]))
                for box in items
                for here, other, other_side, there, _ in box.ends[side]
            ]
            chords = [chord for chord in chords if chord[0] < chord[1]]
            count = sum(one[0] < other[0] < one[1] < other[1] for one in chords for other in chords)
            self.assertEqual(crossings.crossings(columns), count)

    def test_what_an_exchange_gains(self):
        """Neighbours exchanged, and counted again."""
        for seed in range(50):
            columns = between(random.Random(seed), 6)
            for items in columns:
                for rank in range(5):
                    before = crossings.crossings(columns)
                    levels = {box: [crossings._opposite(box, side) for side in (0, 1)] for box in items}
                    gain = crossings._gain(items[rank], items[rank + 1], levels)
                    items[rank : rank + 2] = reversed(items[rank : rank + 2])
                    crossings.stack(items)
                    self.assertEqual(crossings.crossings(columns), before - gain)

    def test_a_tree_has_none(self):
        text = [f"C{(number - 1) // 2}.out{number % 2} C{number}.in" for number in range(1, 31)]
        picture = robot_maps.system(random.Random(1).sample(text, len(text)))
        names = [box.name for box in picture.boxes]
        parts, _ = sheet.parts([sheet.Line(source, target, (int(out[3:]), 1), (0, 0), False)
                                for source, out, target, _, _ in picture.edges], [(9, 9)] * len(names))
        self.assertEqual(crossings.crossings(parts[0].rows[0].layers), 0)

    def test_few_of_random_systems(self):
        """There were 800 of them when this was written."""
        parts = [part for seed in range(8) for part in parts_of(random_robot(seed))]
        self.assertLess(sum(crossings.crossings(row.layers) for part in parts for row in part.rows), 850)


class Rows(unittest.TestCase):
    def test_a_ring_is_broken_but_not_where_many_lines_would_be_cut(self):
        """They would cross many others on their way from one row to the other."""
        for picture, is_one in ((robot_maps.ring(), False), (random_robot(7), True)):
            largest = max(parts_of(picture), key=lambda part: len(part.items))
            self.assertEqual(len(largest.rows) == 1, is_one)


class Lines(unittest.TestCase):
    def test_tracks(self):
        for seed in range(50):
            chance = random.Random(seed)
            spans = [tuple(sorted(chance.sample(range(100), 2))) for _ in range(40)]
            numbers = lines.pack(spans)
            for (one, track), (other, other_track) in itertools.combinations(zip(spans, numbers), 2):
                if track == other_track:
                    self.assertTrue(one[1] < other[0] or other[1] < one[0])

    def test_a_long_line_is_level(self):
        """It passes three layers, and bends beside its ends alone."""
        picture = robot_maps.system(["A.a B.in", "B.out C.in", "C.out D.in", "D.out E.in", "A.b E.far"])
        _, layout = layout_of(picture)
        self.assertLessEqual(len({y for _, y in layout.ways[4]}), 3)
        for way in layout.ways[1:3]:
            self.assertEqual(len({y for _, y in way}), 1, "and a chain is level")


class Pictures(unittest.TestCase):
    def test_a_humanoid(self):
        """Six loops, each with one line back into its controller, and one of the whole robot."""
        limbs = ("LeftArm", "RightArm", "LeftLeg", "RightLeg", "Head", "Waist")
        picture = robot_maps.humanoid()
        loops = ["%sEstimator %sController" % (each, each) for each in limbs]
        self.assertEqual(sorted(names_back(picture)), sorted(loops + ["Balancer Commander"]))
        _, layout = layout_of(picture)
        self.assertLess(layout.width * layout.height, 2.4e6)
        # limbs are not torn: the motors of one are next to each other
        motors = sorted((layout.corners[number][1], box.name[:4])
                        for number, box in enumerate(picture.boxes) if "Motor" in box.name)
        self.assertEqual(len([name for name, _ in itertools.groupby(name for _, name in motors)]), 6)

    def test_the_terminal_has_the_same_order(self):
        """A loop flows down and comes back by one line."""
        picture = robot_maps.system(reversed(list(robot_maps.limb("Arm"))))
        drawn = "\n".join(graph_text.lines(picture))
        order = [drawn.index(each) for each in (
            "ArmPlanner ", "ArmController ", "ArmMotor0 ", "ArmEncoder0 ", "ArmEstimator ")]
        self.assertEqual(order, sorted(order))

    def test_what_is_not_connected_comes_last_by_name(self):
        picture = robot_maps.system(["B.out A.in"], ["Spare10", "Spare9", "Another"])
        drawn = "\n".join(graph_text.lines(picture))
        order = [drawn.index(each) for each in ("B ", "A ", "Another ", "Spare9 ", "Spare10 ")]
        self.assertEqual(order, sorted(order))
        _, layout = layout_of(picture)
        corners = dict(zip([box.name for box in picture.boxes], layout.corners))
        self.assertLess(max(corners[name][1] for name in "AB"), corners["Another"][1])
        places = [(corners[name][1], corners[name][0]) for name in ("Another", "Spare9", "Spare10")]
        self.assertEqual(places, sorted(places))

    def test_the_same_with_every_order_of_hashes(self):
        program = ("import hashlib, random, robot_maps\nfrom rtshell_lite.views import graph_svg\n"
                   "text = '\\n'.join(graph_svg.lines(robot_maps.random_system(random.Random(3), 60)))\n"
                   "print(hashlib.sha256(text.encode()).hexdigest())")
        here = "\n".join(graph_svg.lines(robot_maps.random_system(random.Random(3), 60)))
        for seed in "12":
            environment = dict(os.environ, PYTHONHASHSEED=seed, PYTHONPATH=os.pathsep.join(sys.path))
            command = [sys.executable, "-c", program]
            said = subprocess.check_output(command, env=environment).decode().strip()
            self.assertEqual(said, hashlib.sha256(here.encode()).hexdigest())

    def test_the_same_with_every_python(self):
        """To be changed where drawings change, for all versions at once."""
        layouts = [layout_of(robot_maps.random_system(random.Random(seed), 50))[1] for seed in range(3)]
        sums = [sum(x * y for way in layout.ways for x, y in way) for layout in layouts]
        self.assertEqual(sums, [75514970, 73353750, 62744980])

    def test_heights(self):
        """Boxes that want the same place are beside it, as near as can be."""
        left = [item.Item(0, 10, 30)]
        right = [item.Item(number, 10, 30) for number in range(1, 4)]
        for box in right:
            item.join((left[0], 1, 10), (box, 0, 10), 1)
        columns = [left, right]
        heights.settle(columns, [])
        self.assertEqual([box.y for box in right], [0, 48, 96])
        self.assertEqual(left[0].y, 48)

    def test_a_box_that_no_line_holds_stays_beside_the_next(self):
        """Even if that is far below, or has come back from there."""
        for place in (0, 1):
            column = [item.Item(number, 10, 30) for number in range(2)]
            others = [item.Item(number, 10, 30) for number in range(2, 12)]
            item.join((column[place], 1, 10), (others[9], 0, 10), 1)
            heights.settle([column, others], [])
            self.assertEqual(column[1].y - column[0].y, 48)


if __name__ == "__main__":
    unittest.main()
