"""Paths of the RTC Tree: what is typed, what is printed, and that each can be turned into the other."""
import os
import random
import unittest

from rtshell_lite import errors
from rtshell_lite.path import ROOT, Name, Path, parse, split_address

PIECES = "ab./:\\e x\x1b\udcff日\n*\u3164\u0301\ufe0f"


class Parsing(unittest.TestCase):
    def setUp(self):
        self.addCleanup(
            os.environ.update, {name: os.environ.pop(name) for name in ["RTCSH_CWD"] if name in os.environ}
        )

    def check(self, typed, expected, cwd="/"):
        self.assertEqual(str(parse(typed, cwd)), expected)

    def test_absolute_relative_and_dots(self):
        self.check("/localhost/a.host_cxt/C0.rtc", "/localhost/a.host_cxt/C0.rtc")
        self.check("C0.rtc", "/localhost/a.host_cxt/C0.rtc", "/localhost/a.host_cxt")
        self.check("../b.host_cxt/./C0.rtc", "/localhost/b.host_cxt/C0.rtc", "/localhost/a.host_cxt")
        self.check("..", "/", "/")
        self.check("", "/localhost/a.host_cxt", "/localhost/a.host_cxt")
        self.check("../../../..", "/", "/localhost/a")
        self.check("a//b", "/localhost/a/b", "/localhost")
        self.check("//localhost///a", "/localhost/a")

    def test_the_working_directory_comes_from_the_environment(self):
        before = os.environ.get("RTCSH_CWD")
        try:
            os.environ["RTCSH_CWD"] = "/robot/x.host_cxt"
            self.assertEqual(str(parse("C0.rtc")), "/robot/x.host_cxt/C0.rtc")
            os.environ["RTCSH_CWD"] = ""
            self.assertEqual(str(parse("robot")), "/robot")
            os.environ["RTCSH_CWD"] = "robot"
            with self.assertRaises(errors.BadPath):
                parse("C0.rtc")
            os.environ["RTCSH_CWD"] = "/robot/C0.rtc:out"
            with self.assertRaisesRegex(errors.BadPath, "^/robot/C0.rtc:out: .*working directory, RTCSH_CWD"):
                parse("..")
            self.assertEqual(str(parse("/robot/x")), "/robot/x")
            os.environ["RTCSH_CWD"] = "corbaloc:iiop:robot:1/C0.rtc:out"
            with self.assertRaisesRegex(errors.BadPath, "working directory, RTCSH_CWD"):
                parse(".")
        finally:
            os.environ.pop("RTCSH_CWD", None)
            if before is not None:
                os.environ["RTCSH_CWD"] = before

    def test_the_first_colon_is_a_tcp_port_and_the_last_a_component_port(self):
        self.assertEqual(parse("/robot:15005").server, "robot:15005")
        found = parse("/robot:15005/C0.rtc:in")
        self.assertEqual((found.server, found.names, found.port), ("robot:15005", (Name("C0", "rtc"),), "in"))
        self.assertIsNone(parse("/robot/C0.rtc").port)

    def test_ipv6_and_protocols(self):
        self.assertEqual(parse("/[::1]:2810/x").server, "[::1]:2810")
        self.assertEqual(split_address("[::1]"), ("[::1]", 2809))
        self.assertEqual(parse("/ssliop:robot:2811/x").server, "ssliop:robot:2811")
        found = parse("http://robot:80/ns#a.cxt/C0.rtc")
        self.assertEqual((found.server, len(found.names)), ("http://robot:80/ns", 2))
        self.assertEqual((str(found), parse(str(found))), ("/http://robot:80/ns#/a.cxt/C0.rtc", found))

    def test_names_split_at_the_last_dot(self):
        self.assertEqual(parse("/h/foo.example.org.host_cxt").names[0], Name("foo.example.org", "host_cxt"))
        self.assertEqual(parse("/h/plain").names[0], Name("plain", ""))
        self.assertEqual(parse("/h/.rtc").names[0], Name("", "rtc"))
        self.assertEqual(parse("/h/a\\.b").names[0], Name("a.b", ""))
        self.assertEqual(parse("/h/\\e").names[0], Name("", ""))

    def test_a_final_slash_asks_for_a_directory(self):
        self.assertTrue(parse("/h/a/").directory)
        self.assertTrue(parse("/h/a/.").directory)
        self.assertFalse(parse("/h/a").directory)

    def test_malformed_paths_are_refused_before_any_network(self):
        for typed in (
            "/h/a:b:c",
            "/h/a:",
            "/h/a.rtc:in/",
            "/h:x/a",
            "/:1/a",
            "/h:0",
            "/h:65536",
            "/h/\\q",
            "/h/a\\",
        ):
            with self.assertRaises(errors.BadPath, msg=typed) as caught:
                parse(typed, "/")
            self.assertEqual(caught.exception.status, 2)

    def test_absolute_paths_need_no_working_directory(self):
        self.check("/h/a.cxt/b.rtc", "/h/a.cxt/b.rtc", "/other/c.cxt")

    def test_a_host_is_no_dots(self):
        for typed in ("/\\.\\./a.rtc", "/\\./a.rtc", "/\\.\\.:2809/a.rtc"):
            with self.assertRaises(errors.BadPath, msg=typed):
                parse(typed)

    def test_parents_and_children_are_not_written_with_a_slash(self):
        below = parse("/h/a.cxt/")
        self.assertFalse(below.child(Name("b", "rtc")).directory)
        self.assertFalse(parse("/h/a.cxt/b.cxt/").parent().directory)

    def test_parents_and_children(self):
        path = parse("/h/a.cxt/C0.rtc:in")
        self.assertEqual(str(path.object()), "/h/a.cxt/C0.rtc")
        self.assertEqual(str(path.parent()), "/h/a.cxt")
        self.assertEqual(parse("/h").parent(), ROOT)
        self.assertEqual(str(parse("/h").child(Name("x/y", "rtc"))), "/h/x\\/y.rtc")


class RoundTrip(unittest.TestCase):
    def test_printed_paths_can_be_typed(self):
        rng = random.Random(5)

        def some():
            return "".join(rng.choice(PIECES) for _ in range(rng.randint(0, 5)))
        for _ in range(2000):
            names = tuple(Name(some(), some()) for _ in range(rng.randint(1, 3)))
            path = Path("h", names, rng.choice([None, some() or "p"]), False)
            self.assertTrue(str(path).isprintable())
            self.assertEqual(parse(str(path), "/"), path)

    def test_any_text_is_a_path_or_refused(self):
        rng = random.Random(6)
        for _ in range(2000):
            typed = "".join(rng.choice(PIECES + "\ud800:[]#") for _ in range(rng.randint(0, 12)))
            try:
                path = parse(typed, "/localhost/x")
            except errors.BadPath:
                continue
            self.assertEqual(parse(str(path), "/"), path._replace(directory=False))


if __name__ == "__main__":
    unittest.main()
