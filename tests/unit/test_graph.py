"""Pictures of systems: if this fails, rtstodot prints what Graphviz refuses, or leaves out something."""
import os
import random
import re
import unittest

import random_profiles
import test_xmlprofile
from rtshell_lite.views import graph, graph_dot, graph_svg, graph_text
from rtshell_lite.xmlprofile import model, rtsprofile

# The grammar of DOT, as far as we write it.

ID = r'(?:[A-Za-z_][A-Za-z_0-9]*|"(?:[^"\\]|\\.)*")'
VALUE = r'(?:[a-z]+|"(?:[^"\\]|\\.)*")'
STATEMENT = re.compile(
    r"\s*(?:{id} \[[a-z]+={value}(?:, [a-z]+={value})*\];"
    r"|{id}:{id} -> {id}:{id}(?: \[arrowhead=\"odot\"\])?;"
    r"|subgraph {id} \{{|\}}|(?:label|bgcolor)={value};|{id};)\Z".format(id=ID, value=VALUE)
)
LABEL = re.compile(r'label="((?:[^"\\]|\\.)*)"')


def target(name, port, kind=model.TargetPort):
    return kind(component_id="RTC:" + name, instance_name=name, port_name=port)


def component(name, members=(), path=None):
    return model.Component(
        id="RTC:" + name,
        path_uri=path or "localhost/%s.rtc" % name,
        instance_name=name,
        participants=[
            model.Participant(component=model.TargetComponent(component_id="RTC:" + each, instance_name=each))
            for each in members
        ],
    )


def data(*ends):
    made = model.DataPortConnector(connector_id="x")
    made.ends = [target(*end) for end in ends]
    return made


def lines(profile, states=None):
    return list(graph_dot.lines(graph.of(profile, states)))


class Deep(unittest.TestCase):
    def test_composites_in_composites(self):
        """A chain that is longer than Python's stack is drawn."""
        count = 3000
        profile = model.RtsProfile(
            components=[component("C%d" % i, ["C%d" % (i + 1)] * (i + 1 < count)) for i in range(count)]
        )
        picture = graph.of(profile)
        found = list(graph_dot.lines(picture))
        self.assertEqual(sum(line.endswith("  }") for line in found), count - 1)
        self.assertLess(sum(map(len, found)), 1 << 20)
        for draw in (graph_svg.lines, graph_text.lines):
            self.assertGreater(len(list(draw(picture))), count)


class Dot(unittest.TestCase):
    def check(self, profile):
        """Check that every line is valid, braces and records are balanced, and names in connections are
        declared.
        """
        found = lines(profile)
        self.assertEqual(found[:3], ["digraph rtsprofile {", "  rankdir=LR;", "  node [shape=Mrecord];"])
        self.assertEqual(found[-1], "}")
        depth = 1
        for line in found[3:-1]:
            self.assertTrue(STATEMENT.match(line), line)
            depth += line.endswith("{") - (line.strip() == "}")
            self.assertGreaterEqual(depth, 1)
        self.assertEqual(depth, 1)
        declared = {}
        for line in found:
            node = re.match(r"  (%s) \[label" % ID, line)
            if node:
                self.assertNotIn(node.group(1), declared)
                declared[node.group(1)] = self.record(LABEL.search(line).group(1))
        for line in found:
            for node, port in (
                re.findall(r"(%s):(%s)(?= ->|;| \[)" % (ID, ID), line) if " -> " in line else ()
            ):
                self.assertIn(port, declared[node])
        return found

    def record(self, label):
        """The ports of a record label, whose brackets must be in order."""
        bare = re.sub(r"\\.", "", label)
        self.assertEqual(bare.count("{"), bare.count("}"), label)
        ports = re.findall(r"<(\w+)>", bare)
        self.assertEqual(len(ports), bare.count("<"), label)
        self.assertEqual(len(ports), len(set(ports)), label)
        return ports

    def test_as_rtshell_draws(self):
        profile = model.RtsProfile(components=[component("Snk0"), component("Src0")],
                                   data_port_connectors=[data(("Src0", "Src0.out"), ("Snk0", "Snk0.in"))])
        self.assertEqual(
            self.check(profile)[3:-1],
            [
                '  Snk0 [label="{{<in>in}|Snk0|{}}"];',
                '  Src0 [label="{{}|Src0|{<out>out}}"];',
                "  Src0:out -> Snk0:in;",
            ],
        )

    def test_names_that_mean_something_in_dot(self):
        names = [
            "node",
            "n",
            "a b",
            'q"',
            "back\\",
            "{x|<y>}",
            "\x1b[31m",
            "",
            "日本",
            "&amp;",
            "1",
            "a.b/(c)",
            "digraph",
        ]
        ends = [(name, port) for name in names for port in names]
        profile = model.RtsProfile(
            components=[component(name, path="h/x%d" % i) for i, name in enumerate(names)]
        )
        profile.data_port_connectors = [data(one, other) for one, other in zip(ends, ends[1:])]
        self.check(profile)

    def test_components_of_one_name(self):
        profile = model.RtsProfile(
            components=[component("A", path="h1/A.rtc"), component("A", path="h2/A.rtc")]
        )
        drawn = self.check(profile)
        self.assertEqual(drawn[3:5], ['  A [label="{{}|h1/A|{}}"];', '  A_2 [label="{{}|h2/A|{}}"];'])
        picture = graph.of(profile)
        self.assertEqual([line[2:-2] for line in graph_text.lines(picture) if "A" in line], ["h1/A", "h2/A"])
        heads = [line for line in graph_svg.lines(picture) if line.endswith("/A</text>")]
        self.assertEqual([re.sub("<[^>]*>", "", line) for line in heads], ["h1/A", "h2/A"])

    def test_more_than_two_ends(self):
        profile = model.RtsProfile(components=[component(name) for name in "ABC"],
                                   data_port_connectors=[data(("A", "A.out"), ("B", "B.in"), ("C", "C.in"))])
        self.assertEqual(self.check(profile)[-3:-1], ["  A:out -> B:in;", "  A:out -> C:in;"])

    def test_a_connection_of_one_port_is_a_tools(self):
        profile = model.RtsProfile(components=[component("A")], data_port_connectors=[data(("A", "A.out"))])
        self.assertEqual(self.check(profile)[3:-1], ['  A [label="{{}|A|{}}"];'])

    def test_a_component_that_the_profile_lacks(self):
        profile = model.RtsProfile(
            components=[component("A")], data_port_connectors=[data(("A", "A.out"), ("Gone", "in"))]
        )
        self.assertIn('  Gone [label="{{<in>in}|Gone|{}}", style=dashed];', self.check(profile))

    def test_composites_of_composites_and_of_themselves(self):
        family = [component("A", "BCA"), component("B", "DA"), component("C"), component("D", "AC")]
        profile = model.RtsProfile(components=family)
        found = self.check(profile)
        self.assertEqual(
            [line.strip() for line in found if "subgraph" in line or line.strip() in ("C;", "D;")],
            ["subgraph cluster_A {", "subgraph cluster_B {", "D;", "C;"],
        )

    def test_states(self):
        profile = model.RtsProfile(components=[component("A"), component("B")])
        self.assertEqual(lines(profile, {"localhost/A.rtc": "Active", "localhost/B.rtc": "?"})[3:5], [
            '  A [label="{{}|A|{}}", style=filled, fillcolor=palegreen];',
            '  B [label="{{}|B|{}}", style=filled, fillcolor=lightgrey];'])

    def test_random_profiles(self):
        for seed in range(200):
            self.check(random_profiles.Maker(seed).profile())

    def test_real_files(self):
        names = test_xmlprofile.real_files()
        if not names:
            self.skipTest("no real profiles: RTSHELL_PROFILES is not set and no shared/data/profiles is near")
        for name in names:
            with self.subTest(os.path.basename(name)):
                with open(name, "rb") as file:
                    self.check(rtsprofile.load(file.read(), name))


ARMS = {
    "─": "lr", "═": "lr", "<": "lr", "│": "ud", "║": "ud",
    "┐": "ld", "╗": "ld", "┘": "lu", "╝": "lu",
    "┤": "lud", "╣": "lud", "┬": "lrd", "╦": "lrd", "┴": "lru", "╩": "lru", "┼": "lrud", "╬": "lrud",
}
STEPS = {"l": (0, -1, "r"), "r": (0, 1, "l"), "u": (-1, 0, "d"), "d": (1, 0, "u")}


def reached(lines, row, column):
    """Rows where the line that starts at this border ends: out to its lane, up and down there, back to the
    left.
    """
    todo = [(row, column, "r")]
    rows = set()
    while todo:
        row, column, way = todo.pop()
        step, aside, back = STEPS[way]
        row = row + step
        column = column + aside
        sign = lines[row][column]
        if sign == "<":
            rows.add(row)
        elif way == "l" or back not in ARMS[sign]:  # what only passes is stepped over
            todo.append((row, column, way))
        else:
            turns = "l" if way in "ud" else "ud"
            todo += [(row, column, arm) for arm in ARMS[sign] if arm in way + turns]
    return rows


class Text(unittest.TestCase):
    def draw(self, graph):
        lines = list(graph_text.lines(graph))
        for line in graph_text.lines(graph, ascii_only=True):
            line.encode("ascii")
        return lines

    def check(self, graph):
        """Each line, followed from its start, leads only to the ports that it connects."""
        lines = self.draw(graph)
        border = lines[0].index("┐")
        rows, at = graph_text._stack(graph)
        self.assertEqual(len(rows), len(lines))
        wide = [line + " " * (max(map(len, lines)) - len(line) + 1) for line in lines]
        for start in {edge[:2] for edge in graph.edges}:
            ends = {at[edge[2:4]] for edge in graph.edges if edge[:2] == start} - {at[start]}
            if ends and wide[at[start]][border] == "├":
                self.assertEqual(reached(wide, at[start], border), ends)

    def test_data_flows_down(self):
        profile = model.RtsProfile(components=[component("Snk"), component("Src")],
                                   data_port_connectors=[data(("Src", "Src.out"), ("Snk", "Snk.in"))])
        self.assertEqual(self.draw(graph.of(profile)), [
            "┌─────┐", "│ Src │", "│ out ├─┐", "├─────┤ │", "│ Snk │ │", "│ in  │<┘", "└─────┘"])

    def test_nothing(self):
        self.assertEqual(self.draw(graph.of(model.RtsProfile())), [])

    def test_lines_lead_where_they_should(self):
        for seed in range(300):
            chance = random.Random(seed)
            names = "ABCDEF"[:chance.randint(1, 6)]
            profile = model.RtsProfile(components=[component(name) for name in names])
            for _ in range(chance.randint(0, 9)):
                ends = [
                    (chance.choice(names), "in%d" % chance.randint(1, 2)) for _ in range(chance.randint(1, 3))
                ]
                profile.data_port_connectors.append(
                    data((chance.choice(names), "out%d" % chance.randint(1, 2)), *ends)
                )
            with self.subTest(seed):
                self.check(graph.of(profile))

    def test_real_files_and_random_ones(self):
        for seed in range(50):
            self.draw(graph.of(random_profiles.Maker(seed).profile()))
        for name in test_xmlprofile.real_files():
            with self.subTest(os.path.basename(name)), open(name, "rb") as file:
                self.draw(graph.of(rtsprofile.load(file.read(), name)))


if __name__ == "__main__":
    unittest.main()
