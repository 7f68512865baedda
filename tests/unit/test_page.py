"""Pages of systems, without a browser: if this fails, a page says what is not so, or lets a system's texts
become markup.
"""
import base64
import hashlib
import json
import os
import random
import re
import unittest
from unittest import mock

import large_robots
import robot_maps
import random_profiles
import test_graph
from rtshell_lite import path
from rtshell_lite.system import page_file
from rtshell_lite.views import graph, page, page_groups, part
from rtshell_lite.xmlprofile import model

ONCE = "what a page holds is arithmetic and text"

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
WEB = os.path.join(ROOT, "rtshell_lite", "views", "web")
LONGEST = 1000  # lines of the scripts
# What would read text as markup or as a script, or ask for something from elsewhere.
DANGEROUS = (
    r"innerHTML|outerHTML|insertAdjacentHTML|document\.write|\beval\b|Function\(|fetch|XMLHttp|import|WebSocket|href|"  # noqa: E501
    r"src\b(?!: `data:)"
)
# of after 2018
YOUNG = r"\?\.\w|\?\?|replaceAll|replaceChildren|Object\.fromEntries|\.flat\b|structuredClone|#\w+ ?="


def read(name):
    with open(os.path.join(WEB, name), encoding="utf-8") as file:
        return file.read()


def data_of(html):
    """The JSON in a page."""
    data = json.loads(
        re.search(r'<script type="application/json" id="system">([^<]*)</script>', html).group(1)
    )
    data["rows"] = [[data["pairs"][pair] for pair in rows] for rows in data["rows"]]
    return data


def keys_around(data, kind, number):
    """The keys of the groups of a kind that a box is in, the outermost first."""
    def inside(group):
        children = [child for row in data["groups"][group][3] for column in row for child in column[::2]]
        if number in children:
            return []
        for child in [child for child in children if child < 0]:
            keys = inside(-1 - child)
            if keys is not None:
                return [data["groups"][-1 - child][1]] + keys
        return None

    return inside(data["trees"][part.KINDS.index(kind)])


def page_of(profile, picture=None):
    return page.html(page.fields(picture or graph.of(profile), profile, "A robot", "made by a test"))


class Data(unittest.TestCase):
    def test_json_has_no_markup(self):
        value = {"<!--": "</script>", "&amp;": "\u2028\u2029]]>", "\ud800": "日本\x00"}
        text = page_file.as_json(value)
        self.assertFalse(re.search("[<>&\u2028\u2029]", text))
        self.assertTrue(text.isprintable())
        self.assertEqual(json.loads(text), value)

    def test_page_holds_states_groups_and_paths(self):
        profile = large_robots.profile(8)
        data = data_of(page_of(profile, large_robots.picture(profile, {2})))
        self.assertEqual(
            [box["name"] for box in data["boxes"]], [each.instance_name for each in profile.components]
        )
        self.assertEqual([box["state"] for box in data["boxes"]].count("Error"), 1)
        box = data["boxes"][2]
        self.assertEqual(box["path"], "/localhost/robot2.host_cxt/group0/Filter2.rtc")
        self.assertEqual(box["process"], "192.0.2.2:40000")
        self.assertEqual(keys_around(data, "process", 2), ["192.0.2.2:40000"])
        self.assertEqual(keys_around(data, "directory", 2), ["/localhost/robot2.host_cxt/group0"])
        self.assertEqual(keys_around(data, "host", 2), ["robot2"])
        parts = {heading: dict(data["rows"][rows]) for heading, rows in box["parts"]}
        self.assertEqual(parts["Component"]["Type name"], "Filter")
        self.assertEqual(parts["Configuration set default (active)"]["gain"], "1.0")
        self.assertEqual(parts["Execution context 0"], {"Kind": "PERIODIC", "Rate": "100 Hz"})
        self.assertEqual(len(data["connections"]), len(profile.connectors))
        for made, connector in zip(data["connections"], profile.connectors):
            self.assertEqual([data["boxes"][number]["name"] for number, _ in made["ends"]],
                             [end.instance_name for end in connector.ends])
            self.assertEqual(
                [port for _, port in made["ends"]], [end.port_name.split(".")[1] for end in connector.ends]
            )
            self.assertIn(["dataport.buffer.length", "8"], data["rows"][made["rows"]])

    def test_members_of_the_first_box(self):
        """Its number is 0, which is no default that the script adds."""
        profile = model.RtsProfile(
            components=[test_graph.component("Arm", ["Joint"]), test_graph.component("Joint")]
        )
        self.assertEqual([box.get("composite") for box in data_of(page_of(profile))["boxes"]], [None, 0])

    def test_order(self):
        """Of groups, of what is in each, and of what is in none: a loop of control flows to the right."""
        lines = list(robot_maps.limb("Arm")) + list(robot_maps.limb("Leg")) + ["Arm0.out LegPlanner.goal"]
        profile = robot_maps.profile(lines + ["ArmEstimator.pose Arm0.pose"], ["Z10", "Z9"])
        picture = large_robots.picture(profile)
        for box in picture.boxes:
            box.process = ("h", 1 if box.name.startswith("Arm") else 2 if box.name[0] == "L" else 3)
        data = data_of(page_of(profile, picture))
        names = [box["name"] for box in data["boxes"]]

        def columns(group):
            """The column of each box of a group, in one of its rows."""
            rows = data["groups"][group][3]
            return {names[child]: (row, number) for row, columns in enumerate(rows)
                    for number, column in enumerate(columns) for child in column[::2] if child >= 0}

        loop = ["LegPlanner", "LegController", "LegMotor0", "LegEncoder0", "LegEstimator"]
        flat = columns(data["trees"][0])
        self.assertEqual([flat[name] for name in loop], sorted({flat[name] for name in loop}))
        self.assertGreater(flat["Z10"], flat["Z9"], "what is not connected comes last, by name")
        self.assertEqual(max(flat.values()), flat["Z10"])
        processes = data["groups"][data["trees"][part.KINDS.index("process")]][3]
        labels = [[data["groups"][-1 - child][2] for child in column[::2]] for column in processes[0]]
        self.assertEqual(labels, [["Arm"], ["Leg"]])
        self.assertEqual([columns(-1 - processes[0][1][0])[name] for name in loop],
                         [(0, number) for number in range(5)])

    def test_groups_are_in_groups(self):
        """Of random directories, processes and composites: each component is once in each tree, no group has
        one member, lower boxes are below upper ones.
        """
        for seed in range(60):
            chance = random.Random(seed)
            picture = robot_maps.random_system(chance, chance.randint(1, 90))
            for box in picture.boxes:
                words = ["robot", *["d%d.cxt" % chance.randrange(3) for _ in range(chance.randrange(4))]]
                box.path = path.parse("/%s/%s.rtc" % ("/".join(words), box.name))
                box.process = chance.choice([None, ("h", chance.randrange(6))])
            groups, trees = page_groups.of(picture)

            def members(child):
                if child >= 0:
                    return [child]
                inner = []
                for column in [column for row in groups[-1 - child][3] for column in row]:
                    self.assertEqual(list(column[1::2]), sorted(column[1::2]))
                    for place in column[::2]:
                        inner += members(place)
                self.assertTrue(-1 - child in trees or len(inner) > 1, groups[-1 - child])
                return inner

            self.assertEqual(len(trees), len(part.KINDS))
            for root in trees:
                self.assertEqual(sorted(members(-1 - root)), list(range(len(picture.boxes))))

    def test_deep_directories_cost_no_more(self):
        """Components in 300 nested directories, one in each; only the outermost ones are groups."""
        profile = robot_maps.profile([], ["C%d" % depth for depth in range(300)])
        for depth, component in enumerate(profile.components):
            words = ["localhost"] + depth * ["d.cxt"] + [component.instance_name + ".rtc"]
            component.path_uri = "/".join(words)
        groups, _ = page_groups.of(graph.of(profile))
        self.assertLess(len(groups), 50)

    def test_the_same_system_keeps_its_groups(self):
        """They are not computed again for a live page."""
        profile = large_robots.profile(9)
        first = page.fields(large_robots.picture(profile), profile, "A robot", "")
        with mock.patch.object(page_groups, "of", side_effect=AssertionError):
            again = page.fields(large_robots.picture(profile), profile, "A robot", "", last=first)
        self.assertEqual(again, first)

    def test_a_part_has_what_connects_it(self):
        profile = large_robots.profile(40)
        picture = part.keep(graph.of(profile), {3, 4, 5})
        data = data_of(page_of(profile, picture))
        self.assertEqual(len(data["boxes"]), 3)
        self.assertEqual({tuple(end[0] for end in each["ends"]) for each in data["connections"]},
                         {(edge[0], edge[2]) for edge in picture.edges})

    def test_random_ones(self):
        """Of any profile: numbers lead to what is there, no text can end the data."""
        for seed in range(60):
            profile = random_profiles.Maker(seed).profile()
            with self.subTest(seed):
                data = data_of(page_of(profile))
                for box in data["boxes"]:
                    self.assertTrue(all(rows < len(data["rows"]) for _, rows in box.get("parts", ())))
                for made in data["connections"]:
                    self.assertTrue(all(number < len(data["boxes"]) for number, _ in made["ends"]))

    def test_markup_stays_data(self):
        html = page_of(large_robots.hostile(large_robots.profile(4)))
        self.assertEqual(html.count("<script"), 2)
        self.assertEqual(html.count("</script"), 2)
        self.assertNotIn("<img", html)

    def test_invisible_text_is_escaped(self):
        profile = large_robots.profile(1)
        profile.components[0].instance_name = "a\u202eb\x1b[31m"
        self.assertEqual(data_of(page_of(profile))["boxes"][0]["name"], "a\\u202eb\\x1b[31m")

    def test_size(self):
        """1,000 components with 3,000 connections: less than 1 MB."""
        profile = large_robots.profile(1000)
        self.assertLess(len(page_of(profile, large_robots.picture(profile))), 1000 * 1000)


class Files(unittest.TestCase):
    """The script and the style."""

    def test_policy(self):
        """It names the one script and the one style, and nothing else."""
        html = page_of(large_robots.profile(1))
        policy = re.search(r'Content-Security-Policy" content="([^"]*)"', html).group(1)
        for tag in "script", "style":
            (inside,) = re.findall("<%s>(.*?)</%s>" % (tag, tag), html, re.DOTALL)
            digest = base64.b64encode(hashlib.sha256(inside.encode()).digest()).decode()
            self.assertIn("%s-src 'sha256-%s'" % (tag, digest), policy)
        self.assertTrue(policy.startswith("default-src 'none';"))

    def test_script(self):
        script = "".join(map(read, page._SCRIPTS))
        self.assertLessEqual(script.count("\n"), LONGEST)
        code = re.sub(r"//.*", "", script)
        self.assertEqual(re.findall(DANGEROUS, code), [])
        self.assertEqual(re.findall(YOUNG, code), [])
        self.assertEqual(re.findall(r"\w+://[^\"]*", script), ["http://www.w3.org/2000/svg"])
        self.assertNotIn("</", script)

    def test_script_of_live_pages(self):
        """It hears what its server sends, and nothing else."""
        script = read("live.js")
        self.assertEqual(re.findall(DANGEROUS + r"|\w+://", re.sub(r"//.*", "", script)), [])
        self.assertEqual(re.findall(YOUNG, script), [])
        self.assertEqual(re.findall(r"new EventSource\((.*)\)", script), ["`events?${data.version}`"])
        self.assertNotIn("</", script)

    def test_style(self):
        style = read("page.css")
        self.assertEqual(re.findall(r"url|@import|</", style), [])

    def test_only_reports_and_sites_load_the_page(self):
        for folder, _, names in os.walk(os.path.join(ROOT, "rtshell_lite")):
            for name in [name for name in names if name.endswith(".py")]:
                with open(os.path.join(folder, name), encoding="utf-8") as file:
                    text = file.read()
                loaded = re.findall(r"^(?:from|import) .*\b(page|report)\b", text, re.MULTILINE)
                self.assertEqual(loaded, ["page"] if name in ("report.py", "site.py") else [], name)


if __name__ == "__main__":
    unittest.main()
