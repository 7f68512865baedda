"""Parts and groups of pictures: if this fails, rtstodot draws another part of a system than it was asked for.
"""
import random
import unittest

import test_graph
from rtshell_lite import path
from rtshell_lite.views import graph, graph_dot, graph_svg, graph_text, part
from rtshell_lite.xmlprofile import model


def picture(names, *edges, states=None):
    """A picture of components, named by their paths below /h, and of (source, target) by index."""
    components = [test_graph.component(name.rpartition("/")[2]) for name in names]
    for component, name in zip(components, names):
        component.path_uri = "h/%s.rtc" % name
    ends = [(each.instance_name, "p") for each in components]
    connectors = [test_graph.data((ends[source][0], "out%d" % number), (ends[target][0], "in%d" % number))
                  for number, (source, target) in enumerate(edges)]
    states = {"h/%s.rtc" % name: state for name, state in zip(names, states or ())}
    return graph.of(model.RtsProfile(components=components, data_port_connectors=connectors), states)


def names(found):
    return [box.name for box in found.boxes]


def ends(found):
    return [(found.boxes[edge[0]].name, found.boxes[edge[2]].name) for edge in found.edges]


class Parts(unittest.TestCase):
    def test_neighbourhood(self):
        """As many hops as asked for, with the data, against it, or both ways."""
        chain = picture("ABCDE", (0, 1), (1, 2), (2, 3), (3, 4))
        for hops, ways, wanted in ((0, (True, True), "C"), (1, (True, True), "BCD"), (1, (True, False), "BC"),
                                   (2, (False, True), "CDE"), (9, (True, True), "ABCDE")):
            numbers = part.neighbours(chain, {2}, hops, *ways)
            found = part.keep(chain, numbers)
            self.assertEqual("".join(names(found)), wanted)
            self.assertEqual(ends(found), list(zip(wanted, wanted[1:])))

    def test_below_a_path(self):
        found = picture(["a.host_cxt/X", "a.host_cxt/b.cxt/Y", "ab.host_cxt/Z"])
        for word, wanted in (
            ("/h", {0, 1, 2}),
            ("/h/a.host_cxt", {0, 1}),
            ("/h/a.host_cxt/b.cxt/Y.rtc", {1}),
            ("/h2", set()),
        ):
            self.assertEqual(part.below(found, [path.parse(word)]), wanted, word)

    def test_by_name_or_path(self):
        found = picture(["a.host_cxt/X0", "b.host_cxt/X1"])
        self.assertEqual(part.matching(found, "X*"), {0, 1})
        self.assertEqual(part.matching(found, "/h/b.*"), {1})

    def test_composites_keep_the_members_that_are_drawn(self):
        profile = model.RtsProfile(components=[test_graph.component("M0"), test_graph.component("M1"),
                                               test_graph.component("Comp", ["M0", "M1"])])
        found = part.keep(graph.of(profile), {1, 2})
        self.assertEqual(
            [(box.name, box.members, box.composite) for box in found.boxes],
            [("M1", [], 1), ("Comp", [0], None)],
        )
        self.assertEqual(found.tops, [1])


class Groups(unittest.TestCase):
    def setUp(self):
        self.found = picture(
            ["a.host_cxt/X0", "a.host_cxt/X1", "b.host_cxt/Y0", "b.host_cxt/Y1", "c.host_cxt/Z0"],
            (0, 1),
            (0, 2),
            (1, 2),
            (0, 3),
            (2, 4),
            (3, 4),
            (4, 0),
            states=["Active", "Active", "Error", "Active", "Inactive"],
        )

    def test_a_group_is_one_box_and_parallel_connections_one_line(self):
        folded = part.fold(self.found, "directory")
        self.assertEqual(names(folded), ["/h/a.host_cxt", "/h/b.host_cxt", "Z0"])
        self.assertEqual(
            sorted(ends(folded)),
            [("/h/a.host_cxt", "/h/b.host_cxt"), ("/h/b.host_cxt", "Z0"), ("Z0", "/h/a.host_cxt")],
        )
        self.assertEqual([box.state for box in folded.boxes], ["Active", "Error", "Inactive"])
        self.assertEqual(graph.heads(folded, 1), ["/h/b.host_cxt", "2 components", "1 Active, 1 Error"])
        self.assertIn(" from /h/a.host_cxt ×3 ", "\n".join(graph_text.lines(folded)))
        self.assertIn("×2", "\n".join(graph_dot.lines(folded)))

    def test_an_opened_group_shows_its_components(self):
        folded = part.fold(self.found, "directory", ["/h/b.host_cxt"])
        self.assertEqual(names(folded), ["/h/a.host_cxt", "Y0", "Y1", "Z0"])
        self.assertEqual(len(folded.edges), 5)

    def test_what_is_asked_for_by_name_is_in_no_group(self):
        folded = part.fold(self.found, "directory", alone={2})
        self.assertEqual(names(folded), ["/h/a.host_cxt", "Y0", "Y1", "Z0"])
        self.assertEqual(part.groups(self.found, "directory", {2}), ["/h/a.host_cxt"])
        self.assertEqual(names(part.fold(self.found, "host", alone={0, 3})), ["X0", "X1", "Y0", "Y1", "Z0"])
        self.assertEqual(part.at(self.found, [self.found.boxes[3].path]), {3})

    def test_kinds(self):
        self.assertEqual(names(part.fold(self.found, "none")), names(self.found))
        self.assertEqual(names(part.fold(self.found, "host")), ["a", "b", "Z0"])
        for box, process in zip(self.found.boxes, (("h", 1), ("h", 2), ("h", 2), ("h", 2), None)):
            box.process = process
        self.assertEqual(names(part.fold(self.found, "process")), ["X0", "h:2", "Z0"])
        self.assertEqual(part.groups(self.found, "process"), ["h:2"])
        profile = model.RtsProfile(
            components=[
                test_graph.component("M0"),
                test_graph.component("In", ["M0"]),
                test_graph.component("Out", ["In"]),
                test_graph.component("Else"),
            ]
        )
        self.assertEqual(names(part.fold(graph.of(profile), "composite")), ["Out", "Else"])

    def test_the_finest_kind_that_can_be_overlooked(self):
        self.assertEqual(part.choose_kind(self.found), "none")
        self.assertEqual(part.choose_kind(self.found, 3), "directory")
        self.assertEqual(part.choose_kind(self.found, 1), "host")

    def test_nothing_is_lost(self):
        """Whatever is folded, each component is in one box, and each connection between boxes in one line."""
        chance = random.Random(5)
        for _ in range(60):
            count = chance.randint(1, 30)
            places = ["d%d.host_cxt/C%d" % (chance.randrange(4), number) for number in range(count)]
            found = picture(
                places,
                *[(chance.randrange(count), chance.randrange(count)) for _ in range(chance.randrange(40))]
            )
            folded = part.fold(found, chance.choice(part.KINDS))
            self.assertEqual(
                sum(sum(box.counts.values()) if box.counts else 1 for box in folded.boxes), count
            )
            self.assertEqual(len(set(names(folded))), len(folded.boxes))
            for edge in folded.edges:
                self.assertIn(edge[1], folded.boxes[edge[0]].right + folded.boxes[edge[0]].left)
                self.assertIn(edge[3], folded.boxes[edge[2]].right + folded.boxes[edge[2]].left)
            for draw in graph_svg.lines, graph_text.lines, graph_dot.lines:
                self.assertTrue(list(draw(folded)))


if __name__ == "__main__":
    unittest.main()
