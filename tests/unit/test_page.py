"""Pages of systems, without a browser: if this fails, a page says what is not so, or lets a system's texts
become markup.
"""
import base64
import hashlib
import json
import os
import re
import unittest

import large_robots
import robot_maps
import random_profiles
from rtshell_lite.system import page_file
from rtshell_lite.views import graph, page, part

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
WEB = os.path.join(ROOT, "rtshell_lite", "views", "web")
LONGEST = 700  # lines of the scripts
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
        self.assertEqual([data["names"][name] for name in box["groups"] if name is not None],
                         ["192.0.2.2:40000", "/localhost/robot2.host_cxt/group0", "robot2"])
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

    def test_layers(self):
        """Of groups, of what is in each, and of what is in none: a loop of control flows to the right."""
        lines = list(robot_maps.limb("Arm")) + list(robot_maps.limb("Leg")) + ["Arm0.out LegPlanner.goal"]
        profile = robot_maps.profile(lines + ["ArmEstimator.pose Arm0.pose"])
        picture = large_robots.picture(profile)
        for box in picture.boxes:
            box.process = ("h", 1 if box.name.startswith("Arm") else 2)
        data = data_of(page_of(profile, picture))
        names = [box["name"] for box in data["boxes"]]
        layers = [[data["places"][number] for number in numbers] for numbers in data["layers"]]
        found = [dict(zip(names, places)) for places in layers]
        loop = ["LegPlanner", "LegController", "LegMotor0", "LegEncoder0", "LegEstimator"]
        flat = [found[0][name] for name in loop]
        self.assertEqual(flat, sorted(flat))
        self.assertEqual(len({layer for (layer,) in flat}), 5)
        process = found[part.KINDS.index("process")]
        self.assertEqual([process[name] for name in loop], [[1, 0], [1, 1], [1, 2], [1, 3], [1, 4]])
        self.assertEqual({place[0] for name, place in process.items() if name.startswith("Arm")}, {0})

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
        script = read("layout.js") + read("page.js")
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
