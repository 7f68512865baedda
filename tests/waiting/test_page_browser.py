"""Pages of systems in a real browser, a headless Chromium: if one of these fails, a person sees or does
something wrong there.
"""
import base64
import functools
import os
import re
import shlex
import shutil
import tempfile
import unittest
from unittest import mock

import browser
import large_robots
import robot_maps
from rtshell_lite import path
from rtshell_lite.doctor import report
from rtshell_lite.doctor.finding import Finding
from rtshell_lite.system import page_file
from rtshell_lite.views import graph, page, part

ONCE = "a browser is the same for every Python"

LIST = "[...document.querySelectorAll('#list button')].map(each => each.textContent)"
NAMES = "[...document.querySelectorAll('.box .name')].map(each => each.textContent)"
DETAILS = "document.getElementById('details').textContent"
# tries what a picture may not do
SVG = (
    b'<svg xmlns="http://www.w3.org/2000/svg" width="40" height="20" onload="parent.owned=1"><script>parent.owned=1</script>'  # noqa: E501
    b'<rect width="40" height="20"/></svg>'
)


def setUpModule():
    if not browser.program():
        raise unittest.SkipTest("needs Chromium (Debian's package chromium)")
    Pages.directory = tempfile.mkdtemp()
    Pages.browser = browser.Browser()
    Pages.small = large_robots.profile(5)
    Pages.middle = large_robots.profile(120)
    Pages.large = large_robots.profile(1000)
    write("small", Pages.small, large_robots.picture(Pages.small, {2}))
    write("middle", Pages.middle, large_robots.picture(Pages.middle, {5, 60, 117}))
    write("large", Pages.large, large_robots.picture(Pages.large, {5, 500, 997}))


def tearDownModule():
    Pages.browser.close()
    shutil.rmtree(Pages.directory)


def write(name, profile, picture, remarks=None):
    if remarks is None:
        remarks = [page.Remark("fail", "", str(picture.boxes[3].path), "does not answer", "rtdoctor -q"),
                   page.Remark("note", "", "elsewhere", "something that is left out", "")]
    with open(os.path.join(Pages.directory, name + ".html"), "w", encoding="utf-8") as file:
        file.write(page.html(page.fields(picture, profile, "A robot", "made by a test", remarks)))


class Pages(unittest.TestCase):
    def open(self, name, **view):
        """The page of that name; at the end of the test it must have complained of nothing and asked nobody.
        """
        address = os.path.join(self.directory, name + ".html")
        shown = self.browser.open(address, **view)
        self.addCleanup(
            lambda: self.assertEqual((shown.complaints(), shown.requests()), ([], ["file://" + address]))
        )
        return shown

    def click(self, shown, words, within="#details"):
        """Click on the button with these words with the mouse."""
        find = "[...document.querySelectorAll('%s button')].find(each => each.textContent.trim() === %s)"
        find %= within, page_file.as_json(words)
        self.point(shown, find)

    def point(self, shown, find):
        """Click into the middle of an element that an expression gives."""
        shown.run("window.found = %s; found.scrollIntoView({block: 'center', inline: 'center'})" % find)
        x, y = shown.run("(({left, top, width, height}) => [left + width / 2, top + height / "
                         "2])(found.getBoundingClientRect())")
        shown.click(x, y)

    def box(self, name):
        """An expression for the box of that name on the map."""
        return ("[...document.querySelectorAll('.box')].find(each => "
                "each.querySelector('.name').textContent === %s)"
                % page_file.as_json(name))

    def choose(self, shown, name, value):
        shown.run("{const chosen = document.getElementById('%s'); chosen.value = '%s'; "
                  "chosen.dispatchEvent(new Event('change'))}"
                  % (name, value))

    def names(self, numbers, profile):
        return sorted(profile.components[number].instance_name for number in numbers)


class Map(Pages):
    def test_small_systems_are_shown_completely(self):
        shown = self.open("small")
        self.assertEqual(sorted(shown.run(NAMES)), self.names(range(5), self.small))
        lines = graph.of(self.small).edges
        self.assertEqual(shown.run("document.querySelectorAll('.line').length"), len(lines))

    def test_large_ones_are_folded(self):
        for name, components in (("middle", 120), ("large", 1000)):
            shown = self.open(name)
            self.assertLessEqual(shown.run("document.querySelectorAll('.box').length"), part.MOST)
            words = shown.run("[...document.querySelectorAll('.box')].map(each => "
                              "each.getAttribute('aria-label'))")
            sizes = [re.search(r", (\d+) components", each) for each in words]
            self.assertEqual(sum(int(size.group(1)) if size else 1 for size in sizes), components)

    def test_boxes_do_not_overlap(self):
        """Nor is anything outside of the page."""
        for name, kind in (("small", "auto"), ("middle", "auto"), ("middle", "none"), ("large", "process")):
            shown = self.open(name)
            self.choose(shown, "kind", kind)
            self.assertEqual(
                shown.run("""(() => {
                const boxes = [...document.querySelectorAll('.box rect')].map((each) => each.getBBox());
                const {width, height} = document.querySelector('svg').viewBox.baseVal;
                const shapes = [...document.querySelectorAll('.box, .line')].map((each) => each.getBBox());
                const isOutside = (each) => each.x < 0 || each.y < 0 ||
                    each.x + each.width > width || each.y + each.height > height;
                const touch = (one, other) => one.x < other.x + other.width && other.x < one.x + one.width &&
                    one.y < other.y + other.height && other.y < one.y + one.height;
                const over = boxes.filter((one, place) =>
                    boxes.slice(place + 1).some((other) => touch(one, other)));
                const paths = [...document.querySelectorAll('.line')].map((each) => each.getAttribute('d'));
                const detours = paths.filter((each) => each.includes('V'));
                const corners = detours.map((each) => each.split(' ').slice(1, -2));
                const lanes = [].concat(...corners).filter((part) => part[0] === 'V');
                return shapes.filter(isOutside).length + over.length + lanes.length - new Set(lanes).size;
                })()"""),
                0,
                (name, kind),
            )

    def test_loops_and_what_is_not_connected(self):
        """A loop of control comes back by one line; what is not connected is a strip below, by name."""
        lines = list(robot_maps.limb("Arm")) + list(robot_maps.limb("Leg"))
        profile = robot_maps.profile(lines, ["Z10", "Z9"])
        write("loops", profile, graph.of(profile))
        shown = self.open("loops")
        self.choose(shown, "kind", "none")
        back = "picture.edges.filter((each) => each.shape.getAttribute('d').includes('V'))"
        back += ".map((each) => boxName(picture.boxes[each.source]))"
        self.assertEqual(sorted(shown.run(back)), ["ArmEstimator", "LegEstimator"])
        strip = "picture.items.map(({x, y}, place) => [y, x, boxName(picture.boxes[place])])"
        strip += ".sort((a, b) => a[0] - b[0] || a[1] - b[1])"
        self.assertEqual([name for _, _, name in shown.run(strip)[-2:]], ["Z9", "Z10"])

    def test_an_error_is_seen_where_it_is_selected(self):
        shown = self.open("small")
        frame = "getComputedStyle([...document.querySelectorAll('.box rect')][2]).stroke"
        before = shown.run(frame)
        self.point(shown, self.box("Filter2"))
        self.assertEqual(shown.run("document.querySelector('.box.selected .name').textContent"), "Filter2")
        self.assertEqual(shown.run(frame), before)
        halo = "getComputedStyle(document.querySelector('.box%s .halo')).stroke"
        self.assertNotEqual(shown.run(halo % ".selected"), shown.run(halo % ":not(.selected)"))

    def test_first_view(self):
        """All of a small system, or what is broken; in the proportions of the window."""
        for name, phone in (("small", False), ("small", True), ("middle", False), ("large", False)):
            width, height = (390, 760) if phone else (1200, 800)
            shown = self.open(name, width=width, height=height)
            wide, high, seen, broken = shown.run("""(() => {
                const [map, svg] = [element("map"), picture.svg].map((each) => each.getBoundingClientRect());
                const isIn = (each) => {
                    const {left, top, right, bottom} = each.getBoundingClientRect();
                    return left >= map.left && top >= map.top && right <= map.right && bottom <= map.bottom;
                };
                const boxes = [...document.querySelectorAll(".box rect")];
                const broken = isIn(document.querySelector(".box.broken rect"));
                return [svg.width / map.width, svg.height / map.height, boxes.every(isIn), broken];
                })()""")
            self.assertTrue(broken, (name, width))
            self.assertTrue(seen or name == "middle" and 0.4 < wide / high < 2.5, (name, width, wide, high))

    def test_a_sheet_has_its_own_layout(self):
        """It is as wide as the sheet, and the screen's is there again afterwards."""
        shown = self.open("middle")
        before = shown.run("[picture.width, picture.height]")
        shown.run("window.sheets = []; addEventListener('beforeprint', "
                  "() => sheets.push(picture.width / picture.height))")
        shown.printed()
        (proportion,) = shown.run("sheets")
        self.assertTrue(1.2 < proportion < 2.4, proportion)
        self.assertEqual(shown.run("[picture.width, picture.height]"), before)

    def test_open_and_fold(self):
        shown = self.open("middle")
        group = shown.run(NAMES)[0]
        members = {each.instance_name for each in self.middle.components[:7]}
        self.point(shown, self.box(group))
        self.assertIn("7 components", shown.run(DETAILS))
        self.click(shown, "Open")
        self.assertLessEqual(members, set(shown.run(NAMES)))
        self.assertNotIn(group, shown.run(NAMES))
        self.point(shown, self.box("Camera0"))
        self.click(shown, "Fold " + group)
        self.assertIn(group, shown.run(NAMES))
        self.assertFalse(members & set(shown.run(NAMES)))

    def test_only_broken(self):
        """Those in Error, that with a finding, and their neighbours."""
        shown = self.open("large")
        shown.run("document.getElementById('broken').click()")
        self.choose(shown, "kind", "none")
        picture = graph.of(self.large)
        self.assertEqual(
            sorted(shown.run(NAMES)), self.names(part.neighbours(picture, {3, 5, 500, 997}), self.large)
        )
        broken = shown.run("[...document.querySelectorAll('.box.broken .name')].map(each => "
                           "each.textContent)")
        self.assertEqual(sorted(broken), self.names({3, 5, 500, 997}, self.large))

    def test_around(self):
        shown = self.open("large")
        shown.run("select(500)")
        self.click(shown, "Around this")
        self.choose(shown, "kind", "none")
        picture = graph.of(self.large)
        for hops, way in ((1, "both"), (2, "upstream"), (3, "downstream")):
            self.choose(shown, "hops", hops)
            self.choose(shown, "way", way)
            wanted = part.neighbours(picture, {500}, hops, way != "downstream", way != "upstream")
            self.assertEqual(sorted(shown.run(NAMES)), self.names(wanted, self.large))
        self.click(shown, "Show all", "header")
        self.assertEqual(shown.run("document.querySelectorAll('.box').length"), 1000)

    def test_zoom(self):
        shown = self.open("small")
        width = "document.querySelector('svg').getBoundingClientRect().width"
        before = shown.run(width)
        self.click(shown, "+", "header")
        self.assertAlmostEqual(shown.run(width), 1.25 * before, delta=2)
        self.click(shown, "Fit", "header")
        self.assertLessEqual(shown.run(width), shown.run("document.getElementById('map').clientWidth"))

    def test_drag(self):
        """The mouse moves the map, and selects no text: drawing that took most of the time of a picture."""
        shown = self.open("large")
        self.choose(shown, "kind", "none")
        for scale in 1, 0.03:
            shown.run("zoom(%s); element('map').scrollTo(1000, 1000)" % scale)
            x, y = shown.run("""(() => {
                const {left, top, width, height} = element("map").getBoundingClientRect();
                const [x, y] = [left + width / 4, top + height / 2];
                const isFree = ([x, y]) => !document.elementFromPoint(x, y).closest(".box");
                return Array.from({length: 300}, (_, place) => [x + place, y]).find(isFree);
                })()""")
            mouse = functools.partial(shown.call, "Input.dispatchMouseEvent", button="left", buttons=1)
            mouse(type="mousePressed", x=x, y=y, clickCount=1)
            for step in range(1, 11):
                mouse(type="mouseMoved", x=x + 20 * step, y=y + 10 * step)
            mouse(type="mouseReleased", x=x + 200, y=y + 100, clickCount=1)
            self.assertEqual(shown.run("getSelection().type"), "None")
            if scale == 1:
                place = shown.run("[element('map').scrollLeft, element('map').scrollTop]")
                self.assertEqual(place, [800, 900])


class Search(Pages):
    def test_as_one_types(self):
        shown = self.open("large")
        shown.press("/")
        shown.type("motor99")
        self.assertEqual(
            sorted(each.split()[1] for each in shown.run(LIST)),
            sorted(each.instance_name for each in self.large.components if "Motor99" in each.instance_name),
        )
        dim = shown.run("document.querySelectorAll('.box.dim').length")
        self.assertTrue(0 < dim < shown.run("document.querySelectorAll('.box').length"))
        shown.press("Enter", "\r")
        self.assertIn("Motor990", shown.run("document.querySelector('.box.selected .name').textContent"))
        self.assertIn("Motor990", shown.run(DETAILS))

    def test_values_and_states(self):
        shown = self.open("middle")
        for words, count in (
            ("error", 3),
            ("192.0.2.1:40001", 7),
            ("group16", 7),
            ("gain perception", 30),
            ("nothing of this", 0),
        ):
            shown.run("document.getElementById('search').value = ''; "
                      "document.getElementById('search').focus()")
            shown.type(words)
            self.assertEqual(len(shown.run(LIST)), count, words)

    def test_broken_components_come_first(self):
        """Those in Error before others; then by name, in natural order."""
        listed = [each.split()[1] for each in self.open("middle").run(LIST)]
        self.assertEqual(sorted(listed[:3]), self.names({5, 60, 117}, self.middle))
        self.assertEqual(listed[3:7], ["Tracker3", "Camera0", "Camera8", "Camera16"])


class Faults(Pages):
    """300 components in 40 processes, three faults: what a person sees who knows nothing of them."""

    def setUp(self):
        self.profile = large_robots.profile(300, each=8)
        self.picture = large_robots.picture(self.profile, {101}, each=8)
        self.picture.boxes[150].state = "Unknown"
        silent, lost = [str(self.picture.boxes[number].path) for number in (150, 235)]
        remarks = [
            page.Remark("fail", "answer", silent, "does not answer within 3 s", ""),
            page.Remark("warn", "connection", lost + ":out", "is unknown to its peer", ""),
        ]
        write("faults", self.profile, self.picture, remarks)
        self.shown = self.open("faults")

    def neighbours(self, number):
        return self.names(part.neighbours(self.picture, {number}) - {number}, self.profile)

    def test_all_are_seen_with_what_they_are_connected_to(self):
        """By one click."""
        self.point(self.shown, "document.getElementById('broken')")
        names = self.names(part.neighbours(self.picture, {101, 150, 235}), self.profile)
        self.assertEqual(sorted(self.shown.run(NAMES)), names)
        inside = """[...document.querySelectorAll('.box rect')].every((each) => {
            const [box, map] = [each, element('map')].map((one) => one.getBoundingClientRect());
            return box.left >= map.left && box.right <= map.right &&
                box.top >= map.top && box.bottom <= map.bottom;
            })"""
        self.assertTrue(self.shown.run(inside), "all of it is on the screen")

    def test_each_is_told_apart(self):
        """By one click each: the list begins with them; what is wrong, and what is connected."""
        words = {101: "Error", 150: "does not answer within 3 s", 235: "is unknown to its peer"}
        listed = self.shown.run(LIST)[:4]
        self.assertEqual([each.split()[1] for each in listed[:3]], self.names(words, self.profile))
        self.assertEqual([each.split()[2:] for each in listed], [[], ["⚠"], ["⚠"], []])
        for entry, number in zip(listed, words):
            self.click(self.shown, entry, "#list")
            self.assertIn(words[number], self.shown.run(DETAILS))
            self.assertEqual(self.shown.run("document.querySelector('.box.selected .name').textContent"),
                             self.profile.components[number].instance_name)
            far = self.shown.run("[...document.querySelectorAll('.connection > button')].map(each => "
                                 "each.textContent.split(':')[0])")
            self.assertEqual(sorted(set(far)), self.neighbours(number))


class Details(Pages):
    def test_component(self):
        shown = self.open("small")
        self.point(shown, self.box("Filter2"))
        found = shown.run(DETAILS)
        for words in (
            "/localhost/robot2.host_cxt/group0/Filter2.rtc",
            "Error",
            "perception",
            "gain",
            "Configuration set fast",
        ):
            self.assertIn(words, found)
        connector = next(each for each in self.small.connectors if "Filter2" in each.name)
        for words in (connector.connector_id, "dataport.buffer.length"):
            self.assertIn(words, found)

    def test_commands_can_be_pasted(self):
        shown = self.open("small")
        self.point(shown, self.box("Filter2"))
        lines = shown.run("[...document.querySelectorAll('#details code')].map(each => each.textContent)")
        self.assertIn("rtreset /localhost/robot2.host_cxt/group0/Filter2.rtc", lines)
        for line in lines:
            command, *words = shlex.split(line)
            self.assertTrue(command.startswith("rt"), line)
            self.assertTrue(all(path.parse(word) for word in words if word.startswith("/")))

    def test_copy(self):
        shown = self.open("small")
        self.point(shown, self.box("Camera0"))
        self.click(shown, "Copy", "#details > details")
        self.assertEqual(shown.run("document.getElementById('status').textContent"), "copied")

    def test_far_end(self):
        """A click on the other end of a connection leads there."""
        shown = self.open("small")
        connector = self.small.connectors[0]
        near, far = [end.instance_name for end in connector.ends]
        self.point(shown, self.box(near))
        self.click(shown, "%s:%s" % (far, connector.ends[1].port_name.split(".")[1]))
        self.assertEqual(shown.run("document.querySelector('#details h2').textContent"), far)

    def test_findings(self):
        shown = self.open("small")
        self.assertIn("does not answer", shown.run(DETAILS))
        self.click(shown, "/localhost/robot3.host_cxt/group0/Tracker3.rtc")
        self.assertIn("does not answer", shown.run(DETAILS))
        self.assertNotIn("something that is left out", shown.run(DETAILS))
        shown.press("Escape")
        self.assertIn("something that is left out", shown.run(DETAILS))


class Everybody(Pages):
    """By keyboard, by ear, on paper, on a phone, in the dark."""

    def test_keyboard(self):
        shown = self.open("small")
        shown.run("document.querySelector('.box').focus()")
        first, second = shown.run(NAMES)[:2]
        shown.press("Enter", "\r")
        self.assertEqual(shown.run("document.querySelector('#details h2').textContent"), first)
        shown.run("document.querySelector('.box').focus()")
        shown.press("ArrowRight")
        shown.press(" ", " ")
        self.assertEqual(shown.run("document.querySelector('#details h2').textContent"), second)

    def test_names_of_controls(self):
        shown = self.open("middle")
        shown.run("select(5)")
        nodes = shown.call("Accessibility.getFullAXTree")["nodes"]
        controls = [
            node
            for node in nodes
            if node["role"]["value"] in ("button", "textbox", "searchbox", "checkbox", "combobox")
        ]
        self.assertGreater(len(controls), 50)
        self.assertEqual([node for node in controls if not node["name"].get("value", "").strip()], [])

    def test_print(self):
        """One sheet."""
        for name in "small", "middle":
            shown = self.open(name)
            shown.run("select(5 % data.boxes.length)")
            self.assertEqual(len(re.findall(rb"/Type\s*/Page\b", shown.printed())), 1)

    def test_phone(self):
        shown = self.open("middle", width=390, height=760)
        self.assertLessEqual(shown.run("document.documentElement.scrollWidth"), 390)
        self.assertEqual(shown.run("getComputedStyle(document.querySelector('nav')).display"), "none")
        self.click(shown, "Names", "header")
        self.click(shown, "✖ Controller5", "nav")
        self.assertIn("Controller5", shown.run(DETAILS))

    def test_dark(self):
        colours = {
            self.open("small", dark=dark).run("getComputedStyle(document.body).backgroundColor")
            for dark in (False, True)
        }
        self.assertEqual(len(colours), 2)


class Hostile(Pages):
    """Whatever a system says stays text."""

    def test_markup_in_every_field(self):
        profile = large_robots.hostile(large_robots.profile(6))
        picture = large_robots.picture(profile)
        for box in picture.boxes:
            box.state = large_robots.MARKUP
        write("hostile", profile, picture)
        shown = self.open("hostile")
        for number in range(6):
            shown.run("select(%d)" % number)
            self.assertIn("<script>window.owned=1</script>", shown.run(DETAILS))
        shown.run("clear()")
        self.assertEqual(shown.run("[typeof window.owned, document.querySelectorAll('script').length, "
                                   "document.images.length]"),
                         ["undefined", 2, 0])
        self.assertEqual(shown.run("document.querySelectorAll('b').length"), 1)  # our own, in the header

    def test_report(self):
        """Of rtdoctor: with a plot, sections, and a hostile log's name."""
        found = [
            Finding("fail", "reference", *2 * [large_robots.MARKUP], "rtdel " + large_robots.MARKUP, ""),
            Finding("ok", "host name", "here", "all is well", "", ""),
        ]
        log = os.path.join(self.directory, "a<b>.csv")
        with mock.patch.object(report, "_plot", return_value=base64.b64encode(SVG).decode()):
            html = report.html(None, found, large_robots.MARKUP, log)
        with open(os.path.join(self.directory, "report.html"), "w", encoding="utf-8") as file:
            file.write(html)
        address = "file://" + os.path.join(self.directory, "report.html")
        shown = self.browser.open(os.path.join(self.directory, "report.html"))
        for words in ("It contains the findings", "Routes", "Max open files", "<script>window.owned=1"):
            self.assertIn(words, shown.run(DETAILS))
        self.assertNotIn("all is well", shown.run(DETAILS))
        self.assertEqual(
            shown.run("document.images[0].decode().then(() => document.images[0].naturalWidth)"), 40
        )
        width = "document.images[0].getBoundingClientRect().width"
        self.assertLess(shown.run(width), 400)
        shown.run("document.images[0].focus()")  # as a click does
        self.assertGreater(shown.run(width), 1000, "a plot that is clicked is large")
        self.assertEqual(
            shown.run("[typeof window.owned, document.querySelectorAll('script').length]"), ["undefined", 2]
        )
        self.assertEqual(shown.complaints(), [])
        self.assertEqual(
            [each for each in shown.requests() if not each.startswith("data:image/svg")], [address]
        )


if __name__ == "__main__":
    unittest.main()
