"""Plots: what is thinned out, where lines end, which numbers are at axes, and that nothing hostile is
drawn.
"""
import math
import os
import random
import re
import subprocess
import sys
import types
import unittest
import xml.dom.minidom
from unittest import mock

from rtshell_lite import errors
from rtshell_lite.data import statistics
from rtshell_lite.datalog import gaps, records
from rtshell_lite.views import plot, plot_sources, plot_states, plot_svg, plot_text

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
START = 1700000000 * 10 ** 9
SECOND = 10 ** 9


def value(**members):
    return types.SimpleNamespace(**members)


def picture(count=100, step=SECOND, name="a", function=float):
    panel = plot.Panel("title")
    for number in range(count):
        panel.named(name).add(START + number * step, function(number))
    made = plot.Picture([panel])
    made.fit()
    return made


class Fields(unittest.TestCase):
    def numbers(self, path, of):
        return [number for _, number, _ in plot.Field(path).numbers(of)]

    def test_parts_of_values(self):
        item = value(_n="RED", _v=1)
        of = value(
            tm=value(sec=1, nsec=2),
            data=[1.5, 2.5, 3.5],
            inner=[value(x=True), value(x=False)],
            octets=b"\1\2",
            word="no",
            colour=item,
        )
        for path, expected in (
            ("data", [1.5, 2.5, 3.5]),
            ("data[1]", [2.5]),
            ("data[1:3]", [2.5, 3.5]),
            ("data[2:9]", [3.5]),
            ("data[7]", []),
            ("inner[0:2].x", [True, False]),
            ("octets[0:1]", [1]),
            ("tm.sec", [1]),
            ("word", []),
            ("colour", [1]),
            ("", [1.5, 2.5, 3.5, True, False, 1, 2, 1]),
        ):
            self.assertEqual(self.numbers(path, of), expected, path)
        self.assertEqual(plot.Field("colour").numbers(of), [("colour", 1, "RED")])
        self.assertEqual(self.numbers("a.b[0]", {"a": {"b": [7, "x"]}}), [7])

    def test_a_union_may_hold_another_member(self):
        class Union:
            _d_to_m = {1: "pose", 2: "code"}

            def __init__(self, case, held):
                self._d = case
                self._v = held

        for path in "u.pose.x", "u.pose[0]", "u.pose":
            self.assertEqual(self.numbers(path, value(u=Union(2, 7))), [], path)
        self.assertEqual(self.numbers("u.pose.x", value(u=Union(1, value(x=1.5)))), [1.5])
        with self.assertRaisesRegex(errors.NoSuch, r"pos \(there are: code, pose\)"):
            self.numbers("u.pos.x", value(u=Union(2, 7)))

    def test_wrong_ones(self):
        for path in ("data[", "[x]", "a b", "data[1:]", "é"):
            with self.assertRaises(errors.BadPath):
                plot.Field(path)
        for path in ("nothing", "data[0]", "data.x"):
            with self.assertRaises(errors.NoSuch):
                plot.Field(path).numbers(value(data=1))

    def test_many_numbers_are_cut(self):
        self.assertEqual(len(self.numbers("", value(a=[[0] * 64] * 64))), plot.MOST)


class Series(unittest.TestCase):
    def test_peaks_survive_thinning(self):
        count = 100000
        series = plot.Series("a", (START, START + count))
        peaks = {3: -100.0, 77777: 100.0}
        for number in range(count):
            series.add(START + number, peaks.get(number, math.sin(number)))
        series.flush()
        self.assertLessEqual(len(series.points), 4 * plot.COLUMNS + 4)
        found = [number for _, number, _ in series.points]
        self.assertEqual((min(found), max(found), series.least, series.greatest), (-100, 100, -100, 100))
        self.assertEqual(series.points, sorted(series.points))

    def test_a_pause_is_a_gap(self):
        series = plot.Series("a")
        for second in list(range(10)) + [20, 21, 22]:
            series.add(START + second * SECOND, second)
        self.assertEqual([point[1] for point in series.points if point[2]], [0, 20])
        thin = plot.Series("a", (START, START + 10 ** 15))
        for second in list(range(10)) + [20, 21, 22]:
            thin.add(START + second * SECOND, second)
        thin.flush()
        self.assertEqual([point[1] for point in thin.points if point[2]], [0, 20])

    def test_what_is_missing_in_a_log_is_a_gap_and_a_mark(self):
        channel = records.Channel("a", "rtlog.Number", b"", ("/x:a",), "json")
        entries = [records.Entry(n, START + n * SECOND, 0, None, None, {"data": n}) for n in range(20)]
        gap = gaps.Gap(START + 4 * SECOND + 1, START + 7 * SECOND + 1, {"a": 12}, "lost")
        log = types.SimpleNamespace(
            channels=[channel], counts={"a": 20}, first=START, last=entries[-1].received, gaps=[gap]
        )
        decoder = mock.Mock(log=log, value=lambda entry: None)
        made = plot_sources.of_log(decoder, ["a"], "", entries)
        points = made.panels[0].series["data"].points
        self.assertEqual([point[1] for point in points if point[2]], [0, 5, 8])
        self.assertEqual(made.marks, [(gap.first, "missing: 12 values of a: lost")])

    def test_nan_and_infinity_are_gaps(self):
        series = plot.Series("a")
        for number in (1, float("nan"), 2, float("inf"), 3):
            series.add(START, number)
        self.assertEqual([point[1:] for point in series.points], [(1, True), (2, True), (3, True)])

    def test_old_points_are_forgotten(self):
        series = picture().panels[0].series["a"]
        series.forget(START + 50 * SECOND)
        self.assertEqual(series.points[0][1], 49)

    def test_rates(self):
        series = plot.Series("rate")
        rate = plot.Rate(series)
        for number in range(30):
            rate.add(START + number * SECOND // 10)
        rate.advance(START + 6 * SECOND)
        self.assertEqual([point[1] for point in series.points], [10, 10, 10, 0, 0, 0])

    def test_rates_of_counts_cover_the_time_and_have_equal_axes(self):
        fast = statistics.Counts()
        slow = statistics.Counts()
        for number in range(1000):
            fast.add(START + number * SECOND // 100)
        for number in range(50):  # half of the time
            slow.add(START + number * SECOND // 10)
        measured = [("fast", fast, START, START + 10 * SECOND), ("slow", slow, START, START + 10 * SECOND)]
        drawn = plot_sources.of_counts(measured + [("none", statistics.Counts(), START, START + 10 * SECOND)])
        rates = [[round(point[1]) for point in panel.series["rate"].points] for panel in drawn.panels]
        # 33 or 34 values in a third of a second
        self.assertEqual((len(rates[0]), set(rates[0])), (30, {99, 102}))
        self.assertEqual(rates[1:], [[10, 10, 5, 0, 0], [0, 0, 0]])
        self.assertEqual(
            [panel.axis for panel in drawn.panels], [(0, drawn.panels[0].series["rate"].greatest)] * 3
        )
        self.assertEqual(drawn.last, START + 10 * SECOND)


class States(unittest.TestCase):
    """Of a component in a log."""

    WHERE = "/a/b.rtc"

    def points(self, described, *events):
        """[(moment, state, whether a gap is before it)] shown since 100 ns: described: (moment, states)s; of
        events: (moment, kind, subject, event)s.
        """
        details = {(moment, str(n)): {self.WHERE: {"states": s}} for n, (moment, s) in enumerate(described)}
        shown = plot_states.States(details, self.WHERE, 100)
        for moment, *words in events:
            shown.take(moment, lambda: dict(zip(("kind", "subject", "event"), words), path=self.WHERE))
        shown.take(900, lambda: {"path": "/a/other.rtc", "kind": "RTC_STATUS", "event": "ERROR"})
        shown.take(901, lambda: None)
        shown.take(902, lambda: {"path": self.WHERE, "kind": "RTC_STATUS", "event": []})
        shown.take(903, mock.Mock(side_effect=errors.Failed("a.mcap", "no JSON")))
        shown.advance(1000)
        (series,) = shown.panel.series.values()
        return [(moment, series.names[value], is_after_gap) for moment, value, is_after_gap in series.points]

    def test_what_it_was_at_first_and_what_is_reported_of_it(self):
        events = (400, "RTC_STATUS", "0", "ERROR"), (990, "RTC_STATUS", "0", "INACTIVE")
        expected = [
            (110, "Active", True), (400, "Error", False), (990, "Inactive", False), (1000, "Inactive", False),
        ]
        self.assertEqual(self.points([(110, {"0": "Active"})], *events), expected)

    def test_what_was_described_before_may_have_changed_since(self):
        event = 400, "RTC_STATUS", "0", "ERROR"
        expected = [(400, "Error", True), (1000, "Error", False)]
        self.assertEqual(self.points([(50, {"0": "Active"})], event), expected)

    def test_one_that_ends_and_comes_back(self):
        described = (100, {"0": "Active"}), (600, {"0": "Inactive"})
        events = (300, "LIFE_EVENT", "", "DIED"), (500, "LIFE_EVENT", "", "BACK")
        expected = [
            (100, "Active", True), (300, "Active", False), (600, "Inactive", True), (1000, "Inactive", False),
        ]
        self.assertEqual(self.points(described, *events), expected)

    def test_a_second_recording_in_a_file(self):
        described = (100, {"0": "Active"}), (600, {"0": "Inactive"})
        events = (200, "RTC_STATUS", "0", "ERROR"), (500, "LIFE_EVENT", "", "APPEARED")
        expected = [
            (100, "Active", True), (200, "Error", False), (600, "Inactive", True), (1000, "Inactive", False),
        ]
        self.assertEqual(self.points(described, *events), expected)

    def test_several_contexts(self):
        described = [(100, {"0": "Active", "1000": "Inactive"})]
        events = (200, "RTC_STATUS", "1000", "ERROR"), (300, "RTC_STATUS", "1000", "INACTIVE")
        others = (400, "RTC_STATUS", "1001", "INACTIVE"), (500, "RTC_STATUS", "", "INACTIVE")
        expected = [
            (100, "Active", True), (200, "Error", False), (300, "Active", False), (400, "Active", False),
            (500, "Inactive", False), (1000, "Inactive", False),
        ]
        self.assertEqual(self.points(described, *events, *others), expected)

    def test_details_of_any_form(self):
        for states in (None, [], {"0": "Unknown"}, {"0": 7}, {"0": []}):
            self.assertEqual(self.points([(100, states)]), [])


class Axes(unittest.TestCase):
    def test_values_are_round(self):
        self.assertEqual(
            [words for _, words in plot.ticks(0, 1, 5)], ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]
        )
        self.assertEqual([words for _, words in plot.ticks(-3.2, 7.9, 5)], ["0", "5"])
        for low, high in ((0.0, 5e-324), (5e-324, 1e-323)):  # no power of ten is as small
            self.assertEqual([value for value, _ in plot.scale(low, high, 5)[0]], [low])
        for low, high in ((0, 1e-9), (1e9, 1e9 + 1), (-1e30, 1e30), (5, 5), (float("-inf"), 1)):
            found = plot.ticks(low, high, 5)
            self.assertTrue(1 <= len(found) < 12, found)
            self.assertEqual(len({words for _, words in found}), len(found))

    def test_many_digits_are_at_the_head(self):
        """What all numbers at an axis share is written once, as on oscilloscopes."""
        for low, high, words, head in (
            (742105012, 742105087, ["20", "40", "60", "80"], "742 105 000 +"),
            (-742105087, -742105012, ["20", "40", "60", "80"], "-742 105 100 +"),
            (1e9, 1e9 + 1, ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"], "1 000 000 000 +"),
            (12345678.25, 12345678.46, ["0.25", "0.30", "0.35", "0.40", "0.45"], "12 345 678 +"),
            (0.1234561, 0.1234564, ["1e-07", "2e-07", "3e-07", "4e-07"], "0.123456 +"),
            (0, 1e12, ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"], "x 1e12"),
            (200000, 400000, ["200000", "250000", "300000", "350000", "400000"], ""),
        ):
            marks, said = plot.scale(low, high, 5)
            self.assertEqual(([words for _, words in marks], said), (words, head))
            for value, _ in marks:
                self.assertTrue(low * (1 - 1e-9) - 1e-9 <= value <= high * (1 + 1e-9) + 1e-9 or low < 0)
        drawn = random.Random(3)
        for _ in range(2000):
            low = drawn.uniform(-1, 1) * 10 ** drawn.uniform(-9, 15)
            marks, _ = plot.scale(low, low + abs(low) * 10 ** drawn.uniform(-6, 3), 6)
            self.assertLessEqual(max(len(words) for _, words in marks), 9)

    def test_times_are_round(self):
        for span, unit, words in (
            (10**6, "µs", "200"),
            (SECOND, "ms", "200"),
            (10 * SECOND, "s", "2"),
            (600 * SECOND, "min:s", "2:00"),
            (86400 * SECOND, "h:min", "6:00"),
        ):
            found, known = plot.time_ticks(START, START + span, 6)
            self.assertEqual((known, found[1][1]), (unit, words))
            self.assertLess(len(found), 9)


class Drawn(unittest.TestCase):
    def test_lines_have_their_width(self):
        for width in (20, 60, 200):
            for is_braille in (True, False):
                made = picture(name="name" * 20)
                made.panels[0].title = "title" * 50
                for line in plot_text.lines(made, width, 12, is_braille):
                    self.assertTrue(len(line) <= max(width, 30) + 10 * (width < 60), line)

    def test_words_at_the_right_end_have_room(self):
        """The last time, and its unit: a line that is too long takes two on a terminal, where each picture
        has to cover the one before.
        """
        for width in range(40, 140):
            for count in range(2, 40):
                for line in plot_text.lines(picture(count, SECOND // 7), width, 12):
                    self.assertLessEqual(len(line), width, line)

    def test_nothing_hostile_is_drawn(self):
        hostile = picture(name='\x1b[2J<script>"&\u202e')
        hostile.panels[0].title = "\x1b]0;x\x07</svg>"
        hostile.marks = [(START + SECOND, "<b>&\x1b")]
        for line in plot_text.lines(hostile, 80, 12):
            self.assertTrue(line.isprintable(), line)
        made = "\n".join(plot_svg.lines(hostile))
        self.assertTrue(all(line.isprintable() for line in made.splitlines()))
        document = xml.dom.minidom.parseString(made.encode())
        self.assertEqual([len(document.getElementsByTagName(name)) for name in ("script", "svg")], [0, 1])

    def test_states_are_bands(self):
        """With their names, in the colours that pages have for them; a pause is a gap."""
        panel = plot.Panel("Motor0.rtc:status")
        names = {0: "Inactive", 1: "Active", 2: "Error"}
        for number, state in enumerate([1] * 10 + [2] * 5 + [0] * 10 + [1] * 10):
            pause = 20 * (number >= 30)
            panel.named("state").add(START + (number + pause) * SECOND, state, names[state])
            panel.named("brake").add(START + (number + pause) * SECOND, state == 0)
        made = plot.Picture([panel])
        made.fit()
        drawn = "\n".join(plot_svg.lines(made))
        band = r'class="band (\w+)" x="([\d.]+)" y="\d+" width="([\d.]+)".*?<title>(\w+)'
        bands = re.findall(band, drawn)
        self.assertEqual(
            [(sort, words) for sort, _, _, words in bands],
            [(words, words) for words in ("Active", "Error", "Inactive", "Active", "Active")]
            + [("grid", "false"), ("b0", "true"), ("grid", "false"), ("grid", "false")],
        )
        widths = [float(width) for _, _, width, _ in bands]
        self.assertAlmostEqual(widths[0] / widths[1], 2, 1)
        self.assertNotIn('class="series', drawn)
        with open(os.path.join(os.path.dirname(plot_svg.__file__), "web", "page.css")) as file:
            style = file.read()
        for name, colours in plot_svg.STATES.items():
            self.assertEqual(tuple(re.findall(f"--{name}: (#[0-9a-f]+)", style)[:2]), colours)

    def test_one_legend_for_panels_with_the_same_series(self):
        arms = []
        for side in ("Left", "Right"):
            panel = plot.Panel(side)
            for joint in range(3):
                for number in range(10):
                    panel.named(f"data[{joint}]").add(START + number * SECOND, joint + number)
            arms.append(panel)
        made = plot.Picture(arms)
        made.fit()
        drawn = "\n".join(plot_svg.lines(made))
        self.assertEqual(drawn.count(">data[1]<"), 1)
        self.assertEqual(drawn.count("h34"), 3)
        self.assertIn("data[0]: min", "\n".join(plot_svg.lines(plot.Picture(arms[:1]))))

    def test_the_axis_of_time_has_units(self):
        for span, words in (
            (SECOND // 1000, "200 µs"), (SECOND, "200 ms"), (20 * SECOND, "2 s"), (900 * SECOND, "2:00"),
        ):
            drawn = "\n".join(plot_svg.lines(picture(2, span)))
            self.assertIn(f">{words}<", drawn)
            self.assertRegex(drawn, r">0 is 20\d\d-[\d:. -]+(; time in min:s)?<")

    def test_nothing_is_drawn_of_nothing(self):
        empty = plot.Picture([plot.Panel("a")])
        empty.fit()
        self.assertEqual(plot_text.lines(empty, 80, 12), ["no values"])
        self.assertIn("no values", "\n".join(plot_svg.lines(empty)))

    def test_the_greatest_numbers_are_drawn(self):
        """Their difference is no float."""
        for low, high in ((-1e308, 1e308), (1.0, 1.79e308), (sys.float_info.max, sys.float_info.max)):
            drawn = picture(2, function=[low, high].__getitem__)
            self.assertIn("*", "\n".join(plot_text.lines(drawn, 80, 12, False)[2:]))
            self.assertNotRegex("\n".join(plot_svg.lines(drawn)), r"[^a-z](nan|inf)[^a-z]")

    def test_one_value_is_drawn(self):
        self.assertIn("*", "\n".join(plot_text.lines(picture(1), 80, 12, False)[2:]))

    def test_an_svg_has_few_points(self):
        made = "\n".join(plot_svg.lines(picture(50000, function=math.sin)))
        self.assertLess(len(made), 200000)

    def test_lines_differ_without_colours(self):
        """As many as an arm has joints and more, also where noise makes a line much longer than it is wide.
        """
        panel = plot.Panel("joints")
        for joint in range(12):
            for number in range(2000):
                panel.named(str(joint)).add(START + number * SECOND, joint + number % 2 * 5)
        made = plot.Picture([panel])
        made.fit()
        drawn = re.findall(
            r'<path class="series s\d( wide)?" d="(M[^"]*)"( stroke-dasharray="[^"]*")?',
            "\n".join(plot_svg.lines(made)),
        )
        legend = [(wide, dashes) for wide, data, dashes in drawn if "h34" in data]
        curves = [dashes for _, data, dashes in drawn if "h34" not in data]
        self.assertEqual((len(set(legend)), len(curves)), (12, 12))
        self.assertEqual(legend[1][1], ' stroke-dasharray="9 3"')
        self.assertGreater(float(re.findall(r'"([\d.]+) ', curves[1])[0]), 90)

    def test_words_of_marks_do_not_overlap(self):
        made = picture(100)
        made.marks = [
            (START + number * SECOND, "a word of some length %d" % number)
            for number in (0, 50, 60, 97, 98, 99)
        ]
        found = re.findall(
            r'<text x="([\d.]+)"[^>]*class="words">a word of some length (\d+)',
            "\n".join(plot_svg.lines(made)),
        )
        self.assertEqual([number for _, number in found], ["0", "50", "97"])
        places = [float(x) for x, _ in found] + [plot_svg.WIDTH + plot_svg.WORD]
        for this, following in zip(places, places[1:]):
            self.assertGreaterEqual(following - this, 24 * plot_svg.WORD)

    def test_live_plots_need_no_json(self):
        """Debian's python3-minimal lacks it."""
        code = "import sys; sys.modules['json'] = None; from rtshell_lite.views import plot_sources, plot"
        subprocess.check_call([sys.executable, "-c", code], env=dict(os.environ, PYTHONPATH=ROOT))


if __name__ == "__main__":
    unittest.main()
