"""The manual that rtdoc prints: what a component's author adds, in the author's order, safe in every format.
"""
import collections
import types
import unittest
import xml.etree.ElementTree

from rtshell_lite.views import manual, manual_formats

HOSTILE = "<b>&\"'</b> \\end{document} {x_y} $1 100% #~^ `` \x1b[31m\u202e"


class Sets:
    """What Configuration offers of its sets."""

    def __init__(self, **values):
        self.raw = {"default": {}}
        self.raw.update(
            ("__%s__" % name if name != "default" else name, dict(value)) for name, value in values.items()
        )

    def set(self, set_id, with_hidden=False):
        return types.SimpleNamespace(values=collections.OrderedDict(self.raw[set_id]))


class Order(unittest.TestCase):
    def test_without_a_word_from_the_author(self):
        self.assertEqual(
            manual._order({}), ["intro", "reqs", "install", "usage", "ports", "config", "misc", "changelog"]
        )

    def test_sections_of_the_authors_own_follow(self):
        self.assertEqual(manual._order({"history": (
            "x"
        ), "intro": "y", "__url__": "z"})[-2:], ["changelog", "history"])

    def test_the_authors_order(self):
        said = {"__order__": "usage, intro,nothing", "intro": "a", "usage": "b", "extra": "c"}
        self.assertEqual(manual._order(said), ["usage", "intro", "nothing", "ports", "config", "extra"])

    def test_an_empty_order_is_none(self):
        for empty in "", " ", ",":
            self.assertEqual(manual._order({"__order__": empty}), list(manual.TITLES))


class Configuration(unittest.TestCase):
    def test_names_and_descriptions_alone_as_rtshell_has_them(self):
        table, = manual._configuration_section(Sets(default={"gain": "1"}, description={"gain": "how much"}))
        self.assertEqual((table.header, table.rows), (("Name", "Description"), [("gain", "how much")]))

    def test_types_constraints_and_widgets_get_columns(self):
        table, = manual._configuration_section(Sets(
            default={"gain": (
                "1"
            ), "mode": "a"}, type={"gain": "int"}, constraints={"gain": "x>0"}, widget={"mode": "radio"}))
        self.assertEqual(table.header, ("Name", "Default", "Type", "Constraint", "Widget", "Description"))
        self.assertEqual(
            table.rows, [("gain", "1", "int", "x>0", "", ""), ("mode", "a", "", "", "radio", "")]
        )

    def test_nothing_to_configure(self):
        self.assertEqual(manual._configuration_section(Sets()), [])


class Formats(unittest.TestCase):
    def setUp(self):
        self.manual = manual.Manual(
            HOSTILE,
            HOSTILE,
            [("Vendor", HOSTILE)],
            [
                manual.Section("intro", HOSTILE, ["One paragraph.\n\nAnother: " + HOSTILE]),
                manual.Section(
                    "ports",
                    "Ports",
                    [
                        manual.Table("Ports", ("A", "B"), (8, 8), [(HOSTILE, "two\nlines")]),
                        manual.Graph(['x [label="%s"];' % manual._quoted(HOSTILE)]),
                    ],
                ),
            ],
            [],
        )

    def test_nothing_harms_a_terminal(self):
        for name, write in manual_formats.FORMATS.items():
            for line in write(self.manual):
                for part in line.split("\n"):
                    self.assertTrue(part.isprintable(), (name, ascii(part)))

    def test_html_is_well_formed_and_text_stays_text(self):
        page = (
            "\n".join(manual_formats.html(self.manual))
            .replace('<meta charset="utf-8">', "")
            .replace("<!DOCTYPE html>\n", "")
        )
        root = xml.etree.ElementTree.fromstring(page)
        self.assertEqual(list(root.iter("b")), [])
        self.assertEqual(len([p for p in root.iter("p") if "paragraph" in p.text or "Another" in p.text]), 2)

    def test_latex_commands_in_text_are_no_commands(self):
        lines = manual_formats.latex(self.manual)
        self.assertEqual([line for line in lines if line.startswith(r"\end{document}")], [lines[-1]])
        self.assertNotIn(r"\end{document} {x", "\n".join(lines[:-1]).split(r"\begin{verbatim}")[0])

    def test_documents_are_complete(self):
        short = manual.Manual(
            "Arm", "Moves", [("Vendor", "us")], [manual.Section("usage", "Usage", ["Start it."])], []
        )
        self.assertEqual(
            manual_formats.rst(short),
            ["Arm", "===", "Moves", "", ":Vendor: us", "", "Usage", "-----", "Start it.", ""],
        )
        self.assertEqual(
            manual_formats.latex(short),
            [
                r"\documentclass{article}",
                r"\usepackage[utf8]{inputenc}",
                r"\usepackage[T1]{fontenc}",
                r"\usepackage{longtable}",
                r"\begin{document}",
                r"\section*{Arm}",
                "Moves",
                "",
                r"\begin{description}",
                r"\item[Vendor] us",
                r"\end{description}",
                r"\subsection*{Usage}",
                "Start it.",
                r"\end{document}",
            ],
        )

    def test_rst_cells_stay_in_their_rows(self):
        row = [line for line in manual_formats.rst(self.manual) if "two lines" in line]
        self.assertEqual(len(row), 1)


if __name__ == "__main__":
    unittest.main()
