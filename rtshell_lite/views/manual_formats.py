"""A Manual in reStructuredText, HTML and LaTeX, as lines. The component's text is escaped in each of them."""

from rtshell_lite.text import cells, safe
from rtshell_lite.views.manual import Graph, Table


def _lines_of(text):
    """The lines of the author's text, safe for a terminal."""
    return [safe(line) for line in text.expandtabs().replace("\r\n", "\n").split("\n")]


# ---- reStructuredText ----


def rst(manual):
    """reStructuredText, as rtshell lays it out."""
    lines = _underlined(manual.title, "=") + _lines_of(manual.description) + [""]
    lines += [f":{name}: {' '.join(_lines_of(value))}" for name, value in manual.fields]
    for section in manual.sections:
        lines += [""] + _underlined(section.title, "-")
        for number, part in enumerate(section.parts):
            lines += [""] * bool(number) + _rst_part(part)
    return lines + [""]


def _underlined(title, mark):
    title = " ".join(_lines_of(title))
    return [title, mark * cells(title)]


def _rst_part(part):
    if isinstance(part, Table):
        lines = [
            ".. csv-table:: " + part.title, "   :header: " + _csv(part.header),
            "   :widths: " + ", ".join(str(width) for width in part.widths), "   ",
        ]
        return lines + ["   " + _csv(row) for row in part.rows]
    if isinstance(part, Graph):
        return [".. digraph:: comp", ""] + ["   " + line for line in part.lines]
    return _lines_of(part)


def _csv(row):
    return ", ".join('"%s"' % " ".join(_lines_of(cell)).replace('"', "'") for cell in row)


# ---- HTML ----

_STYLE = """\
body { font-family: sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em }
table { border-collapse: collapse; margin: 1em 0 }
caption { text-align: left; font-weight: bold; padding: .3em 0 }
th, td { border: 1px solid #999; padding: .3em .6em; text-align: left; vertical-align: top }
dt { font-weight: bold; float: left; clear: left; width: 8em }
dd { margin-left: 8em }
pre { background: #eee; padding: .6em }"""


def html(manual):
    """One self-contained HTML page."""
    title = _html(manual.title)
    lines = [
        "<!DOCTYPE html>", '<html lang="en">', "<head>", '<meta charset="utf-8">', f"<title>{title}</title>",
        "<style>", _STYLE, "</style>", "</head>", "<body>", f"<h1>{title}</h1>",
        f"<p>{_html(manual.description)}</p>",
    ]
    lines += ["<dl>"] + [f"<dt>{_html(n)}</dt><dd>{_html(v)}</dd>" for n, v in manual.fields] + ["</dl>"]
    for section in manual.sections:
        lines.append(f"<h2>{_html(section.title)}</h2>")
        for part in section.parts:
            lines += _html_part(part)
    return lines + ["</body>", "</html>"]


def _html(text):
    from html import escape

    return escape("\n".join(_lines_of(text)))


def _html_part(part):
    if isinstance(part, Table):
        lines = ["<table>", f"<caption>{_html(part.title)}</caption>"]
        for tag, row in [("th", part.header)] + [("td", row) for row in part.rows]:
            lines.append("<tr>%s</tr>" % "".join(f"<{tag}>{_html(cell)}</{tag}>" for cell in row))
        return lines + ["</table>"]
    if isinstance(part, Graph):
        return ["<pre>digraph comp {"] + ["  " + _html(line) for line in part.lines] + ["}</pre>"]
    return [
        "<p>%s</p>" % _html(paragraph.strip("\n")) for paragraph in part.split("\n\n") if paragraph.strip()
    ]


# ---- LaTeX ----

_LATEX = {
    "\\": r"\textbackslash{}",
    "{": r"\{",
    "}": r"\}",
    "#": r"\#",
    "$": r"\$",
    "%": r"\%",
    "&": r"\&",
    "_": r"\_",
    "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}",
}


def latex(manual):
    """A LaTeX document."""
    lines = [
        r"\documentclass{article}",
        r"\usepackage[utf8]{inputenc}",
        r"\usepackage[T1]{fontenc}",
        r"\usepackage{longtable}",
        r"\begin{document}",
        r"\section*{%s}" % _latex(manual.title),
        _latex(manual.description),
        "",
        r"\begin{description}",
    ]
    lines += [rf"\item[{_latex(n)}] {_latex(v)}" for n, v in manual.fields] + [r"\end{description}"]
    for section in manual.sections:
        lines.append(r"\subsection*{%s}" % _latex(section.title))
        for part in section.parts:
            lines += _latex_part(part)
    return lines + [r"\end{document}"]


def _latex(text):
    return "".join(_LATEX.get(c, c) for c in "\n".join(_lines_of(text)))


def _latex_part(part):
    if isinstance(part, Table):
        total = float(sum(part.widths))
        columns = "|" + "".join(r"p{%.2f\textwidth}|" % (0.9 * width / total) for width in part.widths)
        rows = [
            " & ".join(_latex(cell).replace("\n", " ") for cell in row) + r" \\ \hline"
            for row in [part.header] + part.rows
        ]
        return [r"\begin{longtable}{%s}" % columns, r"\hline"] + rows + [r"\end{longtable}"]
    if isinstance(part, Graph):
        return (
            [r"\begin{verbatim}", "digraph comp {"]
            + ["  " + line for line in part.lines]
            + ["}", r"\end{verbatim}"]
        )
    return [_latex(part)]


FORMATS = {"rst": rst, "html": html, "latex": latex}
