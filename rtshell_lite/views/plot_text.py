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
        self.is_braille = is_braille
        self._across, self._down = (2, 4) if is_braille else (1, 1)  # dots of a character
        self.right = width * self._across - 1  # the places of the last dots
        self.top = height * self._down - 1
        self._cells = {}  # (column, row): [dots, number of the series]

    def dot(self, x, y, number):
        """Set a dot, counted from the lower left."""
        if not (0 <= x <= self.right and 0 <= y <= self.top):
            return
        column, column_of_dot = divmod(x, self._across)
        row, row_of_dot = divmod(self.top - y, self._down)
        cell = self._cells.setdefault((column, row), [0, number])
        cell[0] |= DOTS[column_of_dot][row_of_dot]
        cell[1] = number

    def line(self, x, y, to_x, to_y, number):
        right = to_x - x
        up = to_y - y
        count = max(abs(right), abs(up), 1)
        for step in range(count + 1):
            self.dot(round(x + right * step / count), round(y + up * step / count), number)

    def rows(self, paint):
        """The lines; `paint` gives characters the colour of a series."""
        for row in range(self.height):
            drawn = [self._cells.get((column, row)) for column in range(self.width)]
            line = ""
            for number, run in itertools.groupby(drawn, lambda cell: cell and cell[1]):
                line += self._run(list(run), number, paint)
            yield line

    def _run(self, run, number, paint):
        if number is None:
            return " " * len(run)
        if self.is_braille:
            words = "".join(chr(0x2800 + dots) for dots, _ in run)
        else:
            words = _letter(number) * len(run)
        return paint(words, number)


def _letter(number):
    """The letter of a series in ASCII."""
    return LETTERS[number % len(LETTERS)]


def painter(is_coloured):
    """A function that gives text the colour of a series."""
    if not is_coloured:
        return lambda words, number: words
    return lambda words, number: f"\x1b[{COLOURS['series %d' % (number % SERIES)]}m{words}\x1b[00m"


def on_stdout(picture, height, is_ascii=False):
    """The lines of a picture as stdout shows them: as wide as the terminal, in braille if it has UTF-8."""
    encoding = (sys.stdout.encoding or "").lower()
    is_braille = not is_ascii and encoding in ("utf-8", "utf8")
    return lines(picture, text.width(), height, is_braille, text.colour_wanted())


def lines(picture, width, height, is_braille=True, is_coloured=False):
    """The lines of a picture, `width` columns wide and at most about `height` high."""
    if picture.first is None:
        return ["no values"]
    panels = _apart(picture.panels, is_braille and not is_coloured)
    picture_lines = []
    height -= sum(len(panel.series) + bool(panel.title) for panel in panels)
    rows = (height - 2) // max(len(panels), 1)
    rows = max(FEWEST, min(rows, ROWS))
    axes = [_axis(panel, rows) for panel in panels]
    margin = 1 + max([1] + [cells(words) for _, labels, _ in axes for words in labels.values()])
    paint = painter(is_coloured)
    for panel, axis in zip(panels, axes):
        canvas = Canvas(max(width - margin - 1, 10), rows, is_braille)
        picture_lines += _panel(picture, panel, axis, margin, canvas, paint)
    picture_lines += _time_axis(picture, width, margin)
    marks = [f"{plot.elapsed(picture, moment)}  {printable(words)}" for moment, words in picture.marks]
    return picture_lines + marks


def _apart(panels, is_apart):
    """The panels; one for each series where several in one could not be told apart."""
    if not is_apart:
        return panels
    panels_apart = []
    for panel in panels:
        for series in panel.series.values():
            alone = plot.Panel(panel.title, panel.axis)
            alone.series = {series.name: series}
            panels_apart.append(alone)
    return panels_apart


def _axis(panel, rows):
    """((least, greatest), {row, counted from above: words}, words at the head) of a panel's axis."""
    bounds = panel.bounds() or (0.0, 1.0)
    low, high = bounds
    bottom = rows - 1
    head = ""
    marks = _names(panel, low, high)
    if marks is None:
        marks, head = plot.scale(low, high, max(2, rows // 3))
    labels = {bottom - round(plot.share(value, low, high) * bottom): words for value, words in marks}
    return bounds, labels, head


def _names(panel, low, high):
    """[(value, name)] between two bounds where all series have names of enumerators, else None."""
    names = []
    for series in panel.series.values():
        if not series.names:
            return None
        names += series.names.items()
    if not names:
        return None
    return [(value, printable(name)) for value, name in sorted(names) if low <= value <= high]


def _panel(picture, panel, axis, margin, canvas, paint):
    bounds, labels, head = axis
    width = margin + canvas.width + 1
    if panel.title:
        head = f"  ({head})" * bool(head)
        yield _cut(printable(panel.title), width - cells(head)) + head
    for number, series in enumerate(panel.series.values()):
        yield _caption(series, number, paint, canvas.is_braille, width)
        _draw(canvas, picture, series, bounds, number)
    for row, line in enumerate(canvas.rows(paint)):
        label = labels.get(row, "")
        blanks = " " * (margin - 1 - cells(label))
        yield f"{blanks}{label} |{line}".rstrip()


def _cut(words, width):
    """Text of at most `width` columns; its end says most."""
    while cells(words) > width:
        words = "…" + words[max(2, cells(words) - width + 1) :]
    return words


def _caption(series, number, paint, is_braille, width):
    """`name  min 1  max 3  last 2`"""
    sample = "⠤⠤" if is_braille else _letter(number)
    if series.last is None:
        said = "  no values"
    else:
        figures = tuple(map(series.said, (series.least, series.greatest, series.last)))
        said = "  min %s  max %s  last %s" % figures
    room = width - cells(sample) - 1 - cells(said)
    name = _cut(printable(series.name) or "value", max(room, 5))
    return f"{paint(sample, number)} {name}{said}"


def _draw(canvas, picture, series, bounds, number):
    low, high = bounds
    span = picture.last - picture.first
    from_x = from_y = None
    for moment, value, is_after_gap in series.points:
        x = round((moment - picture.first) / span * canvas.right)
        y = round(plot.share(value, low, high) * canvas.top)
        if from_x is None or is_after_gap:
            canvas.dot(x, y, number)
        elif series.is_step:
            canvas.line(max(from_x, 0), from_y, x, from_y, number)
            canvas.line(x, from_y, x, y, number)
        elif x >= 0:
            canvas.line(from_x, from_y, x, y, number)
        from_x = x
        from_y = y


def _time_axis(picture, width, margin):
    marks, unit = plot.time_ticks(picture.first, picture.last, max(2, (width - margin) // 12))
    left = margin + 1
    right = width - margin - 2
    span = picture.last - picture.first

    def place_of(moment):
        return left + round((moment - picture.first) / span * right)

    axis = list(" " * margin + "+" + "-" * (right + 1))
    below = ""
    for moment, words in marks:
        column = place_of(moment)
        axis[column] = "+"
        begin = max(0, column - len(words) // 2)
        end = begin + len(words) + 1 + len(unit)
        room = len(below) + bool(below)
        if begin >= room and end <= width:
            below = padded(below, begin) + words
    for moment, _ in picture.marks:
        column = place_of(moment)
        if left <= column < len(axis):
            axis[column] = "!"
    yield "".join(axis)
    yield f"{below} {unit}"
    yield f"0 is {plot.date(picture.first)}"
