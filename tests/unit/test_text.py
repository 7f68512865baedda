"""Text off the wire and onto a terminal: nothing is lost, nothing reaches the terminal raw."""
import random
import unittest

from rtshell_lite import errors, text

HOSTILE = (
    "a./:\\ "
    "\u3164\u0301\u0e49\ufe0f\u2764\U000e0041\x00\x07\x1b\n\r\t\x7f\x9b\u202e\u2028\u200b\udc80\udcff日é\U0001f600'\"$`*"  # noqa: E501
)


def hostile(rng, most=12):
    return "".join(rng.choice(HOSTILE) for _ in range(rng.randint(0, most)))


class Wire(unittest.TestCase):
    def test_bytes_of_a_command_line_are_utf_8(self):
        """Python 3.6 leaves them undecoded in the C locale."""
        self.assertEqual(text.typed("\udce6\udc97\udca5.rtc"), "日.rtc")
        self.assertEqual(
            [text.typed(s) for s in ("a", "日", "bad\udcff", "\ud800")], ["a", "日", "bad\udcff", "\ud800"]
        )

    def test_every_byte_string_comes_back_as_it_was(self):
        rng = random.Random(1)
        for _ in range(5000):
            wire = bytes(rng.randrange(256) for _ in range(rng.randint(0, 20))).decode("latin-1")
            self.assertEqual(text.to_wire(text.from_wire(wire)), wire)

    def test_utf8_that_was_called_latin1_is_read(self):
        self.assertEqual(text.from_wire("日本".encode("utf-8").decode("latin-1")), "日本")

    def test_text_that_the_orb_decoded_is_left_alone(self):
        self.assertEqual(text.from_wire("日本"), "日本")

    def test_bytes_that_are_no_utf8_survive(self):
        self.assertEqual(text.from_wire("\xff\xfe"), "\udcff\udcfe")

    def test_a_lone_surrogate_cannot_be_sent(self):
        with self.assertRaises(errors.Usage):
            text.to_wire("\ud800")


class Terminal(unittest.TestCase):
    def test_no_control_character_gets_through_and_all_come_back(self):
        rng = random.Random(2)
        for _ in range(20000):
            name = hostile(rng)
            shown = text.printable(name)
            self.assertTrue(shown.isprintable(), ascii(shown))
            self.assertEqual(text.unescaped(shown), name)

    def test_invisible_characters_are_escaped(self):
        for (
            c
        ) in "\u115f\u1160\u3164\uffa0\u2800\u034f\u17b4\u180b\ufe00\ufe0f\U000e0041\U000e0100\U000e01ef\U0001d159":  # noqa: E501
            for said in (c, "a" + c, "\u65e5" + c + "b", c * 3):
                with self.subTest(ascii(said)):
                    self.assertNotIn(c, text.printable(said))
                    self.assertNotIn(c, text.safe(said))
                    self.assertNotIn(c, text.shell_word(said))
                    self.assertEqual(text.unescaped(text.printable(said)), said)

    def test_stacks_of_marks_do_not_take_over_a_line(self):
        self.assertEqual(text.printable("e" + "\u0301" * 6 + "z"), "e" + "\u0301" * 4 + "\\u0301\\u0301z")
        for said in ("\u0301a", "a \u0301", "a\x1b\u0301", "\\u0e49" * 3, "\u0e49" * 50):
            with self.subTest(ascii(said)):
                self.assertNotIn("\u0301", text.printable(said))
                self.assertEqual(text.unescaped(text.printable(said)), said)

    def test_ordinary_text_of_all_languages_stays_readable(self):
        import unicodedata
        words = [
            "\u65e5\u672c\u8a9e",
            "\ud55c\uad6d\uc5b4",
            "\u0915\u094d\u0937\u0924\u094d\u0930\u093f\u092f",
            "\u0e17\u0e35\u0e48\u0e19\u0e35\u0e48",
            "\u0f67\u0f71\u0f74\u0f83",
            "\u05e9\u05c1\u05b8\u05dc\u05d5\u05b9\u05dd",
            "\u0639\u064e\u0631\u064e\u0628\u0650\u064a\u0651",
            "\u2764\ufe0f",
            "\U0001f44d\U0001f3fd",
            "Ti\u1ebfng Vi\u1ec7t",
            "\u1100\u1161\u11a8",
        ]
        for word in words + [unicodedata.normalize("NFD", word) for word in words]:
            with self.subTest(ascii(word)):
                self.assertEqual((text.printable(word), text.safe(word)), (word, word))

    def test_a_selector_stays_behind_symbols_only(self):
        self.assertEqual(
            text.printable("\u2764\ufe0f\ufe0f a\ufe0f 1\ufe0f"), "\u2764\ufe0f\\ufe0f a\\ufe0f 1\\ufe0f"
        )

    def test_safe_keeps_backslashes(self):
        self.assertEqual(text.safe("a\\x1b \x1b"), "a\\x1b \\x1b")

    def test_malformed_escapes_are_errors(self):
        for spelling in ("\\", "\\q", "\\x1", "\\u12", "\\U00110000", "\\7"):
            with self.assertRaises(ValueError, msg=spelling):
                text.unescaped(spelling)

    def test_a_backslash_keeps_punctuation(self):
        self.assertEqual(text.unescaped("a\\/b\\:\\.\\ \\$"), "a/b:. $")

    def test_shell_words_are_one_word_of_the_same_text(self):
        import subprocess
        words = [
            "plain/a.rtc:in",
            "it's",
            "$(touch canary)",
            "a b",
            "",
            "-rf",
            "`x`",
            "日本",
            "\\x1b",
            "\x1b[2Jred",
            "\x1b",
            "\x017",
            "tab\there",
            "bell\x07\x7f it's",
            "two\nlines\n",
            "\n",
            "\x1b\n",
            "bad\udcff\udc80",
            "\u202e\u2028",
            "\r",
        ]
        line = "printf '%s\\0' " + " ".join(text.shell_word(word) for word in words)
        self.assertTrue(all(c.isprintable() or c == "\n" for c in line), ascii(line))
        said = subprocess.run(["sh", "-c", line], stdout=subprocess.PIPE, check=True).stdout.decode(
            "utf-8", "surrogateescape"
        )
        self.assertEqual(said.split("\0")[:-1], words)


class Layout(unittest.TestCase):
    def test_columns_fit_the_width_and_keep_the_order(self):
        rng = random.Random(3)
        for _ in range(300):
            words = ["w" * rng.randint(1, 12) for _ in range(rng.randint(0, 40))]
            total = rng.randint(1, 100)
            lines = text.columns(words, total)
            self.assertEqual(" ".join(lines).split(), words)
            if max(map(len, words), default=0) <= total:
                self.assertLessEqual(max(map(len, lines), default=0), total)

    def test_a_word_wider_than_the_terminal_stands_alone(self):
        self.assertEqual(text.columns(["x" * 100, "b"], 80), ["x" * 100, "b"])

    def test_wide_characters_take_two_columns(self):
        self.assertEqual(text.cells("日本x"), 5)
        self.assertEqual(text.cells("e\u0300"), 1)  # the first of the combining ones
        self.assertEqual(list(text.table([["日本", "1"], ["abcd", "2"]])), ["日本  1", "abcd  2"])

    def test_colour_takes_no_columns(self):
        self.assertEqual(text.cells("\x1b[01;34mab\x1b[00m"), 2)

    def test_table_of_nothing(self):
        self.assertEqual(list(text.table([])), [])

    def test_json_is_ascii_and_sorted(self):
        self.assertEqual(text.json_line({"b": "日", "a": "\udcff"}), '{"a": "\\udcff", "b": "\\u65e5"}')

    def test_json_stays_json_when_a_number_is_none(self):
        self.assertEqual(text.json_line({"b": [float("nan"), float("-inf"), 1.5], "a": "\udcffNaN"}),
                         '{"a": "\\udcffNaN", "b": [null, null, 1.5]}')


if __name__ == "__main__":
    unittest.main()
