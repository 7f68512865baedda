"""A plot.Picture as SVG: readable on white and on black, in colours and without (lines differ in their
dashes, too).
"""

import math
import sys

from rtshell_lite.text import cells, printable
from rtshell_lite.views import plot

WIDTH = 960
HEIGHT = 240  # of a panel's axes
LEFT = 76
BAND = 24  # height of the states of a series
RIGHT = 24
TOP = 34
ROOM = 10  # above a panel
LINE = 20  # between lines of text
FOOT = 62
WORD = 7  # width of a character of a mark
# of a series: colour on white, colour on black, dashes
STYLES = (
    ("#0b62b8", "#6cb6ff", ""),
    ("#b5480a", "#ffa657", "9 3"),
    ("#1a7f37", "#56d364", "2 3"),
    ("#8250df", "#d2a8ff", "12 3 2 3"),
    ("#b3155e", "#ff7bac", "5 5"),
    ("#5c6670", "#b1bac4", "1 4"),
)
# states of components: colour on white, on black, as on pages (web/page.css)
STATES = {
    "Active": ("#c9f0cf", "#1d4a2a"),
    "Inactive": ("#d3e6fb", "#1f3e5f"),
    "Error": ("#ffc9c2", "#7a231b"),
    "Created": ("#f2f4f6", "#2b3138"),
}
_STYLE = """<style>
svg { background: #fff; color: #1f2328; font: 13px system-ui, "DejaVu Sans", sans-serif; }
text { fill: currentColor; }
.small { font-size: 12px; fill-opacity: .8; }
.grid { stroke: currentColor; stroke-opacity: .14; fill: none; }
.axis { stroke: currentColor; stroke-opacity: .7; fill: none; }
.mark { stroke: #c8102e; stroke-dasharray: 3 2; }
.words { fill: #c8102e; font-size: 12px; }
.series { fill: none; stroke-width: 1.6; stroke-linejoin: round; stroke-linecap: round; }
.wide { stroke-width: 3.2; }
.band { stroke: currentColor; stroke-opacity: .35; }
%s@media (prefers-color-scheme: dark) {
svg { background: #0d1117; color: #e6edf3; }
.mark { stroke: #ff7b72; }
.words { fill: #ff7b72; }
%s}
</style>"""


def lines(picture):
    """The lines of an SVG file."""
    names = _shared_names(picture)
    begin = LINE * _rows(names) + ROOM if names else 0
    heights = [ROOM + _head_height(panel, names) + _axes_height(panel) for panel in picture.panels]
    marks = _kept_apart(picture)
    height = begin + sum(heights) + FOOT + LINE * (marks != [])
    yield (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" '
        f'width="{WIDTH}" height="{height}">'
    )
    yield _STYLE % (_colours(0), _colours(1))
    yield from _legend(names, -LINE)
    y = begin
    for panel, size in zip(picture.panels, heights):
        top = y + size - _axes_height(panel)
        yield from _heading(panel, names, y + ROOM)
        if picture.first is None:
            yield _text(LEFT, top + LINE, "no values")
        else:
            yield from _panel(picture, panel, top)
        y += size
    if picture.first is not None:
        yield from _words_of_marks(marks, y)
        yield from _foot(picture, y)
    yield "</svg>"


def _colours(index):
    words = []
    for number, style in enumerate(STYLES):
        words.append(f".s{number} {{ stroke: {style[index]}; }}")
        words.append(f".b{number} {{ fill: {style[index]}; fill-opacity: .25; }}")
    words += [f".{name} {{ fill: {colours[index]}; }}" for name, colours in STATES.items()]
    return "\n".join(words) + "\n"


def _escaped(words):
    words = printable(words).replace("&", "&amp;").replace("<", "&lt;")
    return words.replace(">", "&gt;").replace('"', "&quot;")


def _text(x, y, words, anchor="start", sort=""):
    name = f' class="{sort}"' * bool(sort)
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{name}>{_escaped(words)}</text>'


def _said(series):
    if series.last is None:
        return f"{series.name or 'value'}: no values"
    words = [series.said(value) for value in (series.least, series.greatest, series.last)]
    return f"{series.name or 'value'}: min %s, max %s, last %s" % tuple(words)


# ---- one panel ----


def _rows(names):
    """Lines of a legend: two names are in each."""
    return (len(names) + 1) // 2


def _shared_names(picture):
    """The names of the series, where all panels have the same ones, and several: one legend is enough."""
    names = [tuple(panel.series) for panel in picture.panels if not panel.is_of_states()]
    if len(names) > 1 and len(names[0]) > 1 and len(set(names)) == 1:
        return names[0]
    return ()


def _head_height(panel, names):
    """How much room is above the axes of a panel."""
    height = TOP
    if not names and not panel.is_of_states():
        height += LINE * _rows(panel.series)
    if _scale(panel)[1]:
        height += LINE
    return height


def _axes_height(panel):
    return BAND * len(panel.series) if panel.is_of_states() else HEIGHT


def _legend(words, y):
    """A line of each series, with what is said of it."""
    for number, said in enumerate(words):
        x = LEFT + number % 2 * (WIDTH - LEFT) // 2
        line = y + TOP + LINE * (number // 2) + 4
        yield _path(f"M{x} {line}h34", number)
        yield _text(x + 42, line + 4, said, sort="small")


def _heading(panel, names, y):
    """The title, and a line of each series with its name and figures."""
    yield _text(LEFT, y + 20, panel.title or "")
    if not names and not panel.is_of_states():
        yield from _legend([_said(series) for series in panel.series.values()], y)


def _panel(picture, panel, top):
    """The axes of a panel, and what is in them."""
    bottom = top + _axes_height(panel)
    for moment, _ in plot.time_ticks(picture.first, picture.last, 10)[0]:
        x = _x(picture, moment)
        yield f'<path class="grid" d="M{x:.1f} {top}V{bottom}"/>'
    if panel.is_of_states():
        yield from _bands(picture, panel, top)
    else:
        yield from _axes(panel, top)
        yield from _curves(picture, panel, top)
    yield f'<path class="axis" d="M{LEFT} {top}V{bottom}H{WIDTH - RIGHT}"/>'
    yield from _lines_of_marks(picture, top, bottom)


def _path(data, number, stretch=1.0):
    """A line in the style of a series; there are as many wide styles. `stretch` makes its dashes longer."""
    turn, index = divmod(number, len(STYLES))
    names = f"series s{index}" + " wide" * (turn % 2)
    more = ""
    if STYLES[index][2]:
        lengths = [f"{float(length) * stretch:.4g}" for length in STYLES[index][2].split()]
        more = ' stroke-dasharray="%s"' % " ".join(lengths)
    return f'<path class="{names}" d="{data}"{more}/>'


def _axes(panel, top):
    low, high = _bounds(panel)
    bottom = top + HEIGHT
    ticks, head = _scale(panel)
    if head:
        yield _text(LEFT - 8 - WORD, top - 6, head, sort="small")
    for value, words in ticks:
        y = bottom - plot.share(value, low, high) * HEIGHT
        yield f'<path class="grid" d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}"/>'
        yield _text(LEFT - 8, y + 4, words, "end", "small")


def _bounds(panel):
    """The least and the greatest value, with some room beyond."""
    low, high = panel.bounds() or (0.0, 1.0)
    room = high * 0.04 - low * 0.04  # so as their difference may be more than a float
    return max(low - room, -sys.float_info.max), min(high + room, sys.float_info.max)


def _scale(panel):
    """(ticks, words at the head) of the axis of values."""
    if panel.is_of_states():
        return [], ""
    low, high = _bounds(panel)
    return plot.scale(low, high, 6)


def _short(name):
    return name if cells(name) < 11 else name[:9] + "…"


def _x(picture, moment):
    return LEFT + (moment - picture.first) / (picture.last - picture.first) * (WIDTH - LEFT - RIGHT)


def _bands(picture, panel, top):
    """For each series a band, with the names of its states."""
    for row, series in enumerate(panel.series.values()):
        y = top + BAND * row
        yield _text(LEFT - 8, y + 16, _short(series.name or "value"), "end", "small")
        for begin, end, value in _spells(picture, series):
            words = series.names.get(value) or ("true" if value else "false")
            sort = _sort(series, value, words)
            x = _x(picture, begin)
            width = max(_x(picture, end) - x, 1.0)
            yield (
                f'<rect class="band {sort}" x="{x:.1f}" y="{y + 2}" width="{width:.1f}" height="{BAND - 4}">'
                f"<title>{_escaped(words)}</title></rect>"
            )
            if WORD * (cells(words) + 1) < width:
                yield _text(x + 5, y + 16, words, sort="small")


def _sort(series, value, words):
    """The class of a band."""
    if words in STATES:
        return words
    if series.names:
        return f"b{sorted(series.names).index(value) % len(STYLES)}"
    return "b0" if value else "grid"  # which is not filled


def _spells(picture, series):
    """(begin, end, value) of each time for which a series kept a value."""
    spells = []
    before = None  # moment of the last point
    for moment, value, is_after_gap in series.points:
        if is_after_gap or not spells:
            if spells:
                spells[-1][1] = before
            spells.append([moment, picture.last, value])
        elif value != spells[-1][2]:
            spells[-1][1] = moment
            spells.append([moment, picture.last, value])
        before = moment
    if spells:
        spells[-1][1] = before
    return spells


def _curves(picture, panel, top):
    low, high = _bounds(panel)
    for number, series in enumerate(panel.series.values()):
        data = []
        end = None
        length = 0.0
        width = 0.0
        for moment, value, is_after_gap in _thinned(picture, series):
            x = _x(picture, moment)
            y = top + HEIGHT - plot.share(value, low, high) * HEIGHT
            if is_after_gap or end is None:
                data.append(f"M{x:.1f} {y:.1f}h0")  # a value between two gaps is a dot
                end = x, y
                continue
            data.append(f"H{x:.1f}V{y:.1f}" if series.is_step else f"L{x:.1f} {y:.1f}")
            length += math.hypot(x - end[0], y - end[1])
            width += x - end[0]
            end = x, y
        if data:
            # the dashes of a noisy line, which is much longer than wide, look as in the legend
            yield _path("".join(data), number, max(1.0, length / max(width, 1.0)))


def _thinned(picture, series):
    """The points of a series: of each pixel the first, the least, the greatest, the last."""
    thin = plot.Series(series.name, (picture.first, picture.last))
    for moment, value, is_after_gap in series.points:
        thin.keep((moment, value, is_after_gap))
    thin.flush()
    return thin.points


# ---- what all panels share ----


def _kept_apart(picture):
    """The marks whose words have room beside each other: (left end of the words, words); a line is drawn for
    all.
    """
    kept = []
    free = 0.0
    for moment, words in sorted(picture.marks):
        if picture.first is None or not picture.first <= moment <= picture.last:
            continue
        size = WORD * cells(words)
        x = min(_x(picture, moment), WIDTH - size)
        if x >= free:
            kept.append((max(x, 0.0), words))
            free = x + size + WORD
    return kept


def _lines_of_marks(picture, top, bottom):
    for moment, _ in picture.marks:
        if picture.first <= moment <= picture.last:
            yield f'<path class="mark" d="M{_x(picture, moment):.1f} {top}V{bottom}"/>'


def _words_of_marks(marks, y):
    for x, words in marks:
        yield _text(x, y + 36, words, sort="words")


def _foot(picture, y):
    marks, unit = plot.time_ticks(picture.first, picture.last, 10)
    after = "" if ":" in unit else f" {unit}"
    for moment, words in marks:
        yield _text(_x(picture, moment), y + 18, words + after, "middle", "small")
    said = f"0 is {plot.date(picture.first)}"
    if not after:
        said += f"; time in {unit}"
    yield _text(WIDTH - RIGHT, y + FOOT - 8, said, "end", "small")
