"""What rttop shows of each component: if this fails, trouble is not sorted to the top, or figures are printed
wrongly.
"""
import unittest

from rtshell_lite import errors
from rtshell_lite.data.statistics import Rate
from rtshell_lite.net import loop
from rtshell_lite.top import rows


def row(name, **changes):
    return rows.Row(
        "/robot/" + name, name, "component", None, None, None, None, None, None, None, "", {}
    )._replace(**changes)


class Arranged(unittest.TestCase):
    def names(self, given, *sort):
        return [each.name for each in rows.arranged(given, *sort)]

    def test_by_state_trouble_comes_first(self):
        states = [None, "Unknown", "Created", "Inactive", "Active", "-", "?", "Error"]
        self.assertEqual(self.names([row(str(state), state=state) for state in states], "state"),
                         [str(state) for state in reversed(states)])

    def test_by_figures_the_most_comes_first(self):
        given = [
            row("unknown"),
            row("few", rate=1.0, connections=1),
            row("many", rate=1000.0, connections=12),
        ]
        for sort in ("rate", "connections"):
            self.assertEqual(self.names(given, sort), ["many", "few", "unknown"])

    def test_the_order_stays_where_nothing_differs(self):
        self.assertEqual(self.names([row("b"), row("a"), row("C")]), ["b", "a", "C"])

    def test_trouble_first_then_by_name(self):
        given = [
            row("a", state="Inactive"),
            row("b", state="Active"),
            row("c", state="-"),
            row("d", state="Error"),
            row("e"),
        ]
        self.assertEqual(self.names(given, "trouble"), ["d", "c", "a", "b", "e"])

    def test_numbers_in_names(self):
        names = ["Filter10", "Filter2", "Filter02", "Filter", "A1B2", "A1B10", "Ä" + "9" * 5000]
        self.assertEqual(
            sorted(names, key=rows.natural),
            ["A1B2", "A1B10", "Filter", "Filter2", "Filter02", "Filter10", "Ä" + "9" * 5000],
        )

    def test_groups(self):
        given = [
            row("x")._replace(path=path)
            for path in ("/h/a.host_cxt/X.rtc", "/h/b.host_cxt/c.cxt/X.rtc", "/h/a.host_cxt/Y.rtc")
        ]
        self.assertEqual(rows.grouped(given, "none"), given)
        for kind, first, second in (
            ("directory", "/h/a.host_cxt", "/h/b.host_cxt/c.cxt"),
            ("host", "a", "b"),
        ):
            found = rows.grouped(given, kind)
            self.assertEqual(found, [first + ": 2 components: 2 not asked yet", given[0], given[2],
                                     second + ": 1 component: 1 not asked yet", given[1]])

    def test_words(self):
        """All of them match: a part of a path, a whole state."""
        given = [
            row("Arm0.rtc", state="Active"),
            row("Arm1.rtc", state="Inactive"),
            row("active.rtc", state="Error"),
            row("new.rtc"),
        ]
        for words, expected in (
            ("", 4),
            ("ROBOT", 4),
            ("arm", 2),
            ("active", 2),
            ("arm active", 1),
            ("arm error", 0),
        ):
            self.assertEqual(len(rows.arranged(given, "name", words)), expected, words)


class Shown(unittest.TestCase):
    def test_summary(self):
        given = [
            row(str(number), state=state)
            for number, state in enumerate(["Active", "Error", "Active", "?", "-", None])
        ]
        self.assertEqual(rows.summary(given + [row("part", kind="unknown", state="?")]),
                         "6 components: 1 Error, 1 silent, 1 zombie, 2 Active, 1 not asked yet")
        self.assertEqual(
            [rows.summary([]), rows.summary(given[:1])], ["0 components", "1 component: 1 Active"]
        )

    def test_line(self):
        for given, expected in (
            (row("a.rtc"), "                 -     -  a.rtc"),
            (
                row("a.rtc", state="Active", rate=1000.0, running=True, connections=0),
                "Active        1000     0  a.rtc",
            ),
            (
                row("a.rtc", state="Inactive", rate=0.5, running=False, connections=12),
                "Inactive   stopped    12  a.rtc",
            ),
            (row("a.rtc", kind="zombie", state="-"), "-                -     -  *a.rtc"),
            (
                row(
                    "a.rtc",
                    kind="silent",
                    state="?",
                    failure=errors.Silent("/robot/a.rtc", "no answer within 3 s"),
                ),
                "?                -     -  ?a.rtc: no answer within 3 s",
            ),
            (
                row("a.rtc", failure=errors.Failed("/robot", "bad \x1b")),
                "                 -     -  a.rtc: /robot: bad \\x1b",
            ),
        ):
            self.assertEqual(rows.line(given), expected)

    def test_what_all_paths_begin_with_is_left_out(self):
        paths = ["/h/a.host_cxt/X.rtc", "/h/a.host_cxt/c.cxt/X.rtc", "/h/a.host_cxt/Y.rtc"]
        given = [row(path, path=path) for path in paths]
        short, common = rows.shortened(given)
        self.assertEqual(common, "/h/a.host_cxt/")
        self.assertEqual([each.name for each in short], ["X.rtc", "c.cxt/X.rtc", "Y.rtc"])
        self.assertEqual([each.path for each in short], paths)
        elsewhere = row("/g/a.host_cxt/X.rtc", path="/g/a.host_cxt/X.rtc")
        for others in [elsewhere] + given, given[:1] + [row("Z.rtc")], [row("Z.rtc"), row("Y.rtc")], []:
            self.assertEqual(rows.shortened(others), (others, ""))
        self.assertEqual(rows.shortened([row("Z.rtc")] + given)[0][0].name, "Z.rtc")

    def test_wide_lines(self):
        given = [
            row(
                "A.rtc",
                path="/h/a.host_cxt/A.rtc",
                state="Active",
                rate=50.0,
                connections=2,
                since=loop.now() - 75.0,
                event="Inactive to Active",
                flow={"a:out": 49.96, "a:other": 10.0},
            ),
            row(
                "B.rtc",
                path="/h/B.rtc",
                state="?",
                kind="silent",
                failure=errors.Silent("/h/B.rtc", "no answer"),
            ),
        ]
        self.assertEqual(
            [line.rstrip() for line in [rows.wide_head(given)] + list(rows.wide_lines(given, given))],
            [
                "STATE         RATE  MEASURED  VALUES/S  CONN  COMPONENT  DIRECTORY   SINCE "
                "   LAST EVENT",
                "Active          50      50.0      60.0     2  A.rtc      a.host_cxt     1m "
                "   Inactive to Active",
                "?                -         -         -     -  ?B.rtc     .               "
                "-    no answer",
            ],
        )

    def test_wide_lines_have_no_common_directory(self):
        """It is said once, above them."""
        given = [row(name[-5:], path=name) for name in ("/h/a/X.rtc", "/h/a/Y.rtc", "/h/b/Z.rtc")]
        self.assertEqual(rows.common_directory(given), "/h/")
        self.assertEqual(rows.common_directory(given[:2]), "/h/a/")
        self.assertEqual(rows.common_directory(given[:1]), "")
        self.assertEqual(rows.common_directory([row("X.rtc", path="/g/X.rtc")] + given), "")
        shown = list(rows.wide_lines(given, given))
        self.assertEqual([line.split()[5] for line in shown], ["a", "a", "b"])

    def test_rates(self):
        for given, expected in (
            (Rate("a:out", 12.34, 999.4, None), "    12.3 Hz      999 B/s  a:out"),
            (Rate("a:out", 0.0, 1000.0, None), "     0.0 Hz     1.0 kB/s  a:out"),
            (Rate("a:out", 1000.0, 1e6, None), "  1000.0 Hz     1.0 MB/s  a:out"),
            (Rate("a:out", 1000.0, 2.55e9, None), "  1000.0 Hz     2.5 GB/s  a:out"),
            (Rate("a:out", None, None, None), "       - Hz            -  a:out"),
            (
                Rate("a:out", None, None, errors.Failed("a:out", "gone \x1b")),
                "       ? Hz            ?  a:out: gone \\x1b",
            ),
        ):
            self.assertEqual(rows.rate_line(given), expected)

    def test_json(self):
        self.assertEqual(rows.rate_as_dict(Rate("a", 1.23456, 9.87, None), 5.0), {
            "time": 5.0, "path": "a", "kind": "port", "values_per_second": 1.235, "bytes_per_second": 9.9})
        failed = errors.Failed("a", "gone")
        self.assertEqual(rows.rate_as_dict(Rate("a", None, None, failed), 5.0), {
            "time": 5.0, "path": (
                "a"
            ), "kind": "port", "values_per_second": None, "bytes_per_second": None, "error": "a: gone"})
        self.assertEqual(rows.as_dict(row("a"), 5.0), {
            "time": 5.0, "path": (
                "/robot/a"
            ), "name": "a", "kind": "component", "state": None, "rate": None, "running": None,
            "ports": None, "connections": None})
        self.assertEqual(rows.as_dict(row("a", failure=failed), 5.0)["error"], "a: gone")


if __name__ == "__main__":
    unittest.main()
