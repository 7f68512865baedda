"""A plot.Picture as lines for a terminal: of braille dots, or of ASCII."""

import itertools
import sys

from rtshell_lite import text
from rtshell_lite.text import COLOURS, cells, padded, printable
from rtshell_lite.views import plot

DOTS = ((0x01, 0x02, 0x04, 0x40), (0x08, 0x10, 0x20, 0x80))  # of a braille character, by column and row
LETTERS = "*+xo#@%&"  # of ASCII, for one series each
SERIES = 6  # series with colours of their own
ROWS = 10  # of a panel, at most
FEWEST = 3


class Canvas:
    """Dots in a rectangle of characters, each of one series."""

    def __init__(self, width, height, is_braille):
        self.width = width
        self.height = height
        if is_braille:
            self.across, self.down = 2, 4
        else:
            self.across, self.down = 1, 1
        self._cells = {}  # (column, row): [dots, number of the series]

    def dot(self, x, y, number):
        """Set a dot, counted from the lower left."""
        if not (0 <= x < self.width * self.across and 0 <= y < self.height * self.down):
            return
        y = self.height * self.down - 1 - y
        cell = self._cells.setdefault((x // self.across, y // self.down), [0, number])
        cell[0] |= DOTS[x % self.across][y % self.down]
        cell[1] = number

    def line(self, x, y, to_x, to_y, number):
        count = max(abs(to_x - x), abs(to_y - y), 1)
        for step in range(count + 1):
            self.dot(round(x + (to_x - x) * step / count), round(y + (to_y - y) * step / count), number)

    def rows(self, paint):
        """The lines; `paint` gives characters the colour of a series."""
        for row in range(self.height):
            drawn = [self._cells.get((column, row)) for column in range(self.width)]
            runs = itertools.groupby(drawn, lambda cell: cell and cell[1])
            yield "".join(self._run(list(run), number, paint) for number, run in runs)

    def _run(self, run, number, paint):
        if number is None:
            return " " * len(run)
        if self.across == 2:
            return paint("".join(chr(0x2800 + dots) for dots, _ in run), number)
        return paint(LETTERS[number % len(LETTERS)] * len(run), number)


def painter(is_coloured):
    """A function that gives text the colour of a series."""
    if not is_coloured:
        return lambda words, number: words
    return lambda words, number: f"\x1b[{COLOURS['series %d' % (number % SERIES)]}m{words}\x1b[00m"


def on_stdout(picture, height, is_ascii=False):
    """The lines of a picture as stdout shows them: as wide as the terminal, in braille if it has UTF-8."""
    is_braille = not is_ascii and (sys.stdout.encoding or "").lower().replace("-", "") == "utf8"
    return lines(picture, text.width(), height, is_braille, text.colour_wanted())


def lines(picture, width, height, is_braille=True, is_coloured=False):
    """The lines of a picture, `width` columns wide and at most about `height` high."""
    if picture.first is None:
        return ["no values"]
    panels = _apart(picture.panels, is_braille and not is_coloured)
    found = []
    captions = sum(len(panel.series) + bool(panel.title) for panel in panels)
    rows = (height - captions - 2) // max(len(panels), 1)
    rows = max(FEWEST, min(rows, ROWS))
    labels = [_labels(panel, rows) for panel in panels]
    margin = max([cells(words) for _, row_labels in labels for words in row_labels.values()] + [1]) + 1
    paint = painter(is_coloured)
    for panel, (bounds, row_labels) in zip(panels, labels):
        canvas = Canvas(max(width - margin - 1, 10), rows, is_braille)
        found += _panel(picture, panel, bounds, row_labels, margin, canvas, paint)
    found += _time_axis(picture, width, margin)
    found += ["%s  %s" % (plot.elapsed(picture, moment), printable(words)) for moment, words in picture.marks]
    return found


def _apart(panels, is_apart):
    """The panels; one for each series where several in one could not be told apart."""
    if not is_apart:
        return panels
    found = []
    for panel in panels:
        for series in panel.series.values():
            alone = plot.Panel(panel.title, panel.axis)
            alone.series = {series.name: series}
            found.append(alone)
    return found


def _labels(panel, rows):
    """((least, greatest), {row, counted from above: words}) of a panel's axis."""
    bounds = panel.bounds() or (0.0, 1.0)
    low, high = bounds
    series = list(panel.series.values())
    found = {}
    if series and all(each.names for each in series):
        known = sorted((value, name) for each in series for value, name in each.names.items())
        marks = []
        for value, name in known:
            if low <= value <= high:
                marks.append((value, printable(name)))
    else:
        marks = plot.ticks(low, high, max(2, rows // 3))
    for value, words in marks:
        found[rows - 1 - round((value - low) / (high - low) * (rows - 1))] = words
    return bounds, found


def _panel(picture, panel, bounds, labels, margin, canvas, paint):
    width = margin + canvas.width + 1
    if panel.title:
        yield _cut(printable(panel.title), width)
    for number, series in enumerate(panel.series.values()):
        yield _caption(series, number, paint, canvas.across == 2, width)
        _draw(canvas, picture, series, bounds, number)
    for row, line in enumerate(canvas.rows(paint)):
        yield (_right(labels.get(row, ""), margin) + "|" + line).rstrip()


def _right(words, margin):
    return " " * (margin - 1 - cells(words)) + words + " "


def _cut(words, width):
    """Text of at most `width` columns; its end says most."""
    while cells(words) > width:
        words = "…" + words[max(2, cells(words) - width + 1) :]
    return words


def _caption(series, number, paint, is_braille, width):
    """`name  min 1  max 3  last 2`"""
    sample = "⠤⠤"
    if not is_braille:
        sample = LETTERS[number % len(LETTERS)]
    said = "  no values"
    if series.last is not None:
        words = [series.said(value) for value in (series.least, series.greatest, series.last)]
        said = "  min %s  max %s  last %s" % tuple(words)
    name = _cut(printable(series.name) or "value", max(width - cells(sample) - 1 - cells(said), 5))
    return f"{paint(sample, number)} {name}{said}"


def _draw(canvas, picture, series, bounds, number):
    low, high = bounds
    right = canvas.width * canvas.across - 1
    top = canvas.height * canvas.down - 1
    span = picture.last - picture.first
    before = None
    for moment, value, is_after_gap in series.points:
        x = round((moment - picture.first) / span * right)
        y = round((value - low) / (high - low) * top)
        if before is None or is_after_gap:
            canvas.dot(x, y, number)
        elif series.is_step:
            canvas.line(max(before[0], 0), before[1], x, before[1], number)
            canvas.line(x, before[1], x, y, number)
        elif x >= 0:
            canvas.line(before[0], before[1], x, y, number)
        before = x, y


def _time_axis(picture, width, margin):
    marks, unit = plot.time_ticks(picture.first, picture.last, max(2, (width - margin) // 12))
    right = width - margin - 2
    axis = [" "] * (margin + right + 2)
    words_below = ""
    axis[margin] = "+"
    for place in range(margin + 1, margin + right + 2):
        axis[place] = "-"
    for moment, words in marks:
        place = margin + 1 + round((moment - picture.first) / (picture.last - picture.first) * right)
        axis[place] = "+"
        begin = max(0, place - len(words) // 2)
        room = len(words_below)
        if words_below:
            room += 1
        if begin >= room and begin + len(words) + 1 + len(unit) <= width:
            words_below = padded(words_below, begin) + words
    for moment, _ in picture.marks:
        place = margin + 1 + round((moment - picture.first) / (picture.last - picture.first) * right)
        if margin < place < len(axis):
            axis[place] = "!"
    yield "".join(axis)
    yield padded(words_below, 0) + f" {unit}"
    yield f"0 is {plot.date(picture.first)}"
