"""Pages of systems in a real browser, a headless Chromium: if one of these fails, a person sees or does
something wrong there.
"""
import base64
import collections
import functools
import os
import random
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

LIST = "[...document.querySelectorAll('#list .link')].map(each => each.textContent)"
FOUND = "[...new Set([...document.querySelectorAll('#list .link')].map(each => each.number))]"
NAMES = "[...document.querySelectorAll('.box .name')].map(each => each.textContent)"
DETAILS = "document.getElementById('details').textContent"
# What is wrong with where boxes, frames and lines are.
OVERLAPS = """(() => {
    const wrong = [];
    const named = (node) => (node.group ? node.group.name : boxName(node));
    const {width, height} = picture;
    const nodes = picture.boxes.concat(picture.frames);
    const isIn = (one, other) => one.x >= other.x && one.y >= other.y &&
        one.x + one.width <= other.x + other.width && one.y + one.height <= other.y + other.height;
    const touch = (one, other) => one.x < other.x + other.width && other.x < one.x + one.width &&
        one.y < other.y + other.height && other.y < one.y + one.height;
    const isAbove = (frame, node) =>
        node.parent && (node.parent === frame || isAbove(frame, node.parent));
    for (const one of nodes) {
        if (!isIn(one, {x: 0, y: 0, width, height})) wrong.push(["outside", named(one)]);
        for (const other of nodes) {
            if (one === other || isAbove(one, other) || isAbove(other, one)) continue;
            if (touch(one, other)) wrong.push(["over", named(one), named(other)]);
        }
        const isRoot = one.parent === picture.root;
        if (!isRoot && !isIn(one, one.parent)) wrong.push(["not in its frame", named(one)]);
    }
    // straight pieces of each line, and where its ports are
    const pieces = [];
    for (const edge of picture.edges) {
        let [x, y] = [0, 0];
        for (const word of edge.shape.getAttribute("d").match(/[MHVC][^MHVC]*/g)) {
            const numbers = word.slice(1).split(/[ ,]+/).filter(Boolean).map(Number);
            const ends = {M: numbers, H: [numbers[0], y], V: [x, numbers[0]], C: numbers.slice(-2)};
            const [toX, toY] = ends[word[0]];
            const [left, top] = [Math.min(x, toX), Math.min(y, toY)];
            if (word[0] !== "M") pieces.push({edge, x: left, y: top, width: Math.max(x, toX) - left,
                                              height: Math.max(y, toY) - top, kind: word[0]});
            [x, y] = [toX, toY];
        }
    }
    for (const piece of pieces) {
        const name = named(piece.edge.source);
        if (!isIn(piece, {x: 0, y: 0, width, height})) wrong.push(["line outside", name]);
        for (const box of picture.boxes) {
            if (touch(piece, box)) wrong.push(["through", named(box), name, piece.kind]);
        }
    }
    const upright = pieces.filter(({kind, height}) => kind === "V" && height > 0);
    upright.sort((a, b) => a.x - b.x || a.y - b.y).slice(1).forEach((piece, place) => {
        const before = upright[place];
        const isBeside = Math.abs(before.x - piece.x) >= 1 || before.y + before.height <= piece.y + 1;
        if (before.edge !== piece.edge && !isBeside) {
            wrong.push(["one track", named(piece.edge.source), named(before.edge.source)]);
        }
    });
    return wrong.slice(0, 9).map((words) => words.join(": "));
    })()"""
# What is wrong with a system, in groups of each kind, of which ever others are opened and closed.
EVERY_KIND = """
    Object.assign(view, {around: null, broken: false, selected: null, group: null, opened: new Map()});
    return [].concat(...data.kinds.map((kind) => {
        view.kind = kind;
        draw();
        return [0, 1, 2].map(() => {
            const wrong = %s;
            const groups = picture.boxes.concat(picture.frames).filter((each) => each.group);
            groups.forEach(({group}, number) => {
                const chance = Math.abs(Math.sin(seed + 7 * number + groups.length));
                if (chance < 0.5) view.opened.set(group.key, chance < 0.35);
            });
            draw();
            return wrong.map((words) => `${kind}: ${words}`);
        });
    })).flat();
    """
SYSTEMS = int(os.environ.get("RTSHELL_SYSTEMS", 16))  # random ones; some hundred take minutes
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


def random_groups(chance):
    """(a graph.Graph, its profile) of a random system whose components are anywhere."""
    count = chance.randint(1, 70)
    lines = collections.OrderedDict()
    for _ in range(count):
        ends = chance.randrange(count), chance.randrange(count)
        lines["C%d.out%d C%d.in%d" % (ends[0], chance.randrange(2), ends[1], chance.randrange(2))] = True
    profile = robot_maps.profile(lines, ["Z%d" % number for number in range(chance.randrange(9))])
    for component in profile.components:
        words = ["d%d.cxt" % chance.randrange(3) for _ in range(chance.randrange(4))]
        component.path_uri = "/".join(["localhost", *words, component.instance_name + ".rtc"])
    picture = graph.of(profile)
    for box in picture.boxes:
        box.process = chance.choice([None, ("h", chance.randrange(6))])
    return picture, profile


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
        self.assertEqual(shown.run("document.querySelectorAll('#map .line').length"), len(lines))

    def test_large_ones_are_folded(self):
        for name, components in (("middle", 120), ("large", 1000)):
            shown = self.open(name)
            self.assertLessEqual(shown.run("document.querySelectorAll('.box').length"), part.MOST)
            words = shown.run("[...document.querySelectorAll('.box')].map(each => "
                              "each.getAttribute('aria-label'))")
            sizes = [re.search(r", (\d+) components", each) for each in words]
            self.assertEqual(sum(int(size.group(1)) if size else 1 for size in sizes), components)

    def test_nothing_overlaps(self):
        """Nor is anything outside; frames are in frames, no line leads over a box or along another line."""
        for name, kind in (("small", "auto"), ("middle", "auto"), ("middle", "none"), ("large", "process")):
            shown = self.open(name)
            self.choose(shown, "kind", kind)
            self.assertEqual(shown.run(OVERLAPS), [], (name, kind))

    def test_nothing_overlaps_in_random_systems(self):
        """With groups of random directories, processes and composites, open and closed at random. One page
        shows one system after the other: to open a page takes longer than all that.
        """
        shown = self.open("small")
        shown.run("window.wrong = (seed) => {" + EVERY_KIND % OVERLAPS + "}")
        for seed in range(SYSTEMS):
            picture, profile = random_groups(random.Random(seed))
            fields = page.fields(picture, profile, "A robot", "made by a test", [])
            shown.run("load(%s)" % page_file.as_json(fields))
            self.assertEqual(shown.run("wrong(%d)" % seed), [], seed)

    def test_loops_and_what_is_not_connected(self):
        """A loop of control comes back by one line; what is not connected is a strip below, by name."""
        lines = list(robot_maps.limb("Arm")) + list(robot_maps.limb("Leg"))
        profile = robot_maps.profile(lines, ["Z10", "Z9"])
        write("loops", profile, graph.of(profile))
        shown = self.open("loops")
        self.choose(shown, "kind", "none")
        back = "picture.edges.filter((each) => each.shape.getAttribute('d').includes('V'))"
        back += ".map((each) => boxName(each.source))"
        self.assertEqual(sorted(shown.run(back)), ["ArmEstimator", "LegEstimator"])
        strip = "picture.boxes.map((box) => [box.y, box.x, boxName(box)])"
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

    def test_open_and_close(self):
        shown = self.open("middle")
        group = shown.run(NAMES)[0]
        members = {each.instance_name for each in self.middle.components[:7]}
        self.point(shown, self.box(group))
        self.assertIn("7 components", shown.run(DETAILS))
        self.click(shown, "Open")
        self.assertLessEqual(members, set(shown.run(NAMES)))
        self.assertNotIn(group, shown.run(NAMES))
        self.point(shown, self.box("Camera0"))
        self.click(shown, "Close " + group)
        self.assertIn(group, shown.run(NAMES))
        self.assertFalse(members & set(shown.run(NAMES)))

    def test_what_is_opened_stays_where_it_is(self):
        """The corner of a group is where it was on the screen when it is opened and closed. What is above it,
        and in columns before it, does not move as long as lines have room; so it is in a robot.
        """
        lines = [line for limb in ("Arm", "Leg", "Neck") for line in robot_maps.limb(limb)]
        lines += ["Head.%s %sPlanner.goal" % (limb, limb) for limb in ("Arm", "Leg", "Neck")]
        profile = robot_maps.profile(lines + ["ArmEstimator.pose Head.pose", "Head.state Eye.state"])
        picture = graph.of(profile)
        for box in picture.boxes:
            box.process = ("h", "ALNHE".index(box.name[0]))
        write("limbs", profile, picture, [])
        self.stays("middle", "directory", False)
        self.stays("limbs", "process", True)

    def stays(self, name, kind, are_all):
        shown = self.open(name)
        self.choose(shown, "kind", kind)
        shown.run("""window.where = () => picture.boxes.concat(picture.frames).map((node) => {
            const {left, top} = node.shape.querySelector("rect").getBoundingClientRect();
            const key = node.group ? node.group.key : node.members[0];
            return [key, [left, top].map(Math.round), node.parent.group.key, node.row.number, node.column];
            })""")
        for key in shown.run("picture.boxes.filter((box) => box.group).map((box) => box.group.key)")[:9]:
            for is_open in "true", "false":
                shown.run("(({x, y}) => lookAt(x, y))(nodeOf(%s))" % page_file.as_json(key))
                before = {str(each[0]): each for each in shown.run("where()")}
                shown.run("setOpen(%s, %s)" % (page_file.as_json(key), is_open))
                after = {str(each[0]): each for each in shown.run("where()")}
                _, corner, parent, row, column = before[key]
                for side in 0, 1:
                    self.assertAlmostEqual(after[key][1][side], corner[side], delta=1)
                for other, (_, place, around, other_row, other_column) in before.items():
                    is_before = around == parent and (other_row, other_column) < (row, column)
                    if are_all and other in after and is_before:
                        for side in 0, 1:
                            self.assertAlmostEqual(after[other][1][side], place[side], delta=1)

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
        self.choose(shown, "kind", "process")
        dim = shown.run("document.querySelectorAll('.box.dim').length")
        self.assertTrue(0 < dim < shown.run("document.querySelectorAll('.box').length"))
        # what is found, and what is around it, is as always
        self.assertTrue(shown.run("""picture.edges.every(({source, target}) => {
            const have = (word) => [source, target].some(({shape}) => shape.classList.contains(word));
            return !have("hit") || !have("dim");
            })"""))
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
            self.assertEqual(len(shown.run(FOUND)), count, words)

    def test_broken_components_come_first(self):
        """Those in Error before others; then all, by directory, with counts. Arrows open folders."""
        shown = self.open("middle")
        listed = [each.split()[1] for each in shown.run(LIST)]
        self.assertEqual(sorted(listed[:3]), self.names({5, 60, 117}, self.middle))
        self.assertEqual(listed[3:], ["Tracker3"])
        folders = "[...document.querySelectorAll('#list .folder')].map(each => each.textContent)"
        self.assertEqual(shown.run(folders), ["▾ ⚠ Broken 4 ✖3 ●1", "▸ robot1 30 ✖1 ●29", "▸ robot2 30 ●30",
                                              "▸ robot3 30 ✖1 ●29", "▸ robot4 30 ✖1 ●29"])
        focused = "document.activeElement.textContent"
        shown.run("document.querySelector('#list button').focus()")
        shown.press("End")
        self.assertEqual(shown.run(focused), "▸ robot4 30 ✖1 ●29")
        shown.press("ArrowRight")
        shown.press("ArrowDown")
        self.assertEqual(shown.run(focused), "▸ group13 7 ●7")
        shown.press("ArrowLeft")
        self.assertEqual(shown.run(focused), "▾ robot4 30 ✖1 ●29")
        shown.press("ArrowLeft")
        self.assertEqual(shown.run(focused), "▸ robot4 30 ✖1 ●29")
        shown.press("ArrowUp")
        self.assertEqual(shown.run(focused), "▸ robot3 30 ✖1 ●29")

    def test_all_are_listed(self):
        shown = self.open("large")
        shown.run("""(() => {
            const closed = () => document.querySelector('#list [aria-expanded="false"]');
            while (closed()) closed().click();
            })()""")
        self.assertEqual(sorted(shown.run(FOUND)), list(range(1000)))


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
        self.assertEqual([each.split()[1] for each in listed], self.names(words, self.profile))
        self.assertEqual([each.split()[2:] for each in listed], [[], ["⚠"], ["⚠"]])
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
        """One sheet if it can be read; else an overview, then each group on a sheet, by 6 points."""
        profile = robot_maps.profile(line for limb in ("Arm", "Leg") for line in robot_maps.limb(limb))
        write("two", profile, graph.of(profile), [])
        for name, paper in (("small", "A4"), ("two", "A4"), ("middle", "A3"), ("middle", "A4")):
            shown = self.open(name)
            shown.run("select(5 % data.boxes.length)")
            self.choose(shown, "paper", paper)
            shown.run("""addEventListener('beforeprint', () => {
                const maps = [...document.querySelectorAll(".sheet > svg")];
                const size = (svg) => svg.getAttribute("width") / svg.viewBox.baseVal.width;
                window.letters = maps.map((svg) => 14 * 0.75 * size(svg));
                const names = [...document.querySelectorAll(".sheet .box .name")];
                window.names = names.map((each) => each.textContent);
                })""")
            before = shown.run("[picture.width, picture.height]")
            printed = shown.printed()
            pages = len(re.findall(rb"/Type\s*/Page\b", printed))
            self.assertEqual(pages, len(shown.run("letters")))
            self.assertGreaterEqual(min(shown.run("letters")), 5.9, (name, paper))
            media = re.search(rb"/MediaBox[^/]*", printed).group(0)
            self.assertIn({"A4": b"0 0 841", "A3": b"0 0 119"}[paper], media)
            self.assertEqual(pages == 1, name != "middle")
            components = shown.run("data.boxes.map((box) => box.name)")
            self.assertLessEqual(set(components), set(shown.run("names")))
            self.assertEqual(shown.run("[picture.width, picture.height]"), before)

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
        plots = [("The last 30 s of " + log, base64.b64encode(SVG).decode())]
        with mock.patch.object(report, "_of_log", return_value=(plots, [])):
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
        tops = "['details', 'map'].map((id) => element(id).getBoundingClientRect().top)"
        self.assertEqual(*shown.run(tops), "beside each other on a desk")
        self.assertEqual(shown.complaints(), [])
        self.assertEqual(
            [each for each in shown.requests() if not each.startswith("data:image/svg")], [address]
        )
        phone = self.browser.open(os.path.join(self.directory, "report.html"), width=390, height=760)
        self.assertLess(*phone.run(tops), "what is wrong comes first on a phone")


if __name__ == "__main__":
    unittest.main()
