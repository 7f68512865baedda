"""The live page of rttop. curses draws it, and so sends to a terminal only the cells that have changed."""

import contextlib
import curses
import locale
import os
import sys

from rtshell_lite import text
from rtshell_lite.net import loop, real
from rtshell_lite.robot import transitions
from rtshell_lite.top import rows

TICK = 0.1  # seconds after Esc without a character after which it counts as the key of that name
PAUSE = 1.0  # seconds without a character after which a paste counts as complete
ESCAPE = "\x1b"
# around what is pasted, once a terminal has got BRACKETS (mode 2004 of xterm)
PASTE = "\x1b[200~"
PASTE_END = "\x1b[201~"
BRACKETS = b"\x1b[?2004h"
NO_BRACKETS = b"\x1b[?2004l"
ENTER = ("\n", "\r", curses.KEY_ENTER)
BACKSPACE = ("\x08", "\x7f", curses.KEY_BACKSPACE)
HINTS = "? keys  q end  / filter  s sort  g group  n neighbours  d doctor  p plot  c cat"
MEASURE_ALL = "measure what is seen"

HELP = f"""up down j k   select a component; also PgUp PgDn Home End
a y           activate the selected component, as rtact does
i y           deactivate it, as rtdeact
r y           reset it, as rtreset
c Enter       show all about it, as rtcat -l
d             show what rtdoctor finds wrong with it
m             measure for a second what it writes to its out ports; M: the same
              of all components that are seen here
p             plot what its out port sends; again: its next out port
n             show only it and what it is connected with; Esc drops that
s             sort by the next of: {', '.join(rows.SORTS)}
g             group by the next of: {', '.join(rows.GROUPS)}
/             filter: words of paths, or states, all of which must match;
              Enter keeps it, Esc drops it
h ?           these keys
Ctrl-L        draw everything again
q             end; here, and in what c shows: go back

STATE is ? for a component that does not answer, - for a zombie. RATE is
the execution context's, in Hz. CONN counts connections. From {rows.WIDE} columns
on there are also SINCE, how long ago its state changed while this page was
looking; what changed last; and for a minute after measuring MEASURED, the
rate at which it writes, and VALUES/S of all its out ports. Measuring and
plotting connect to these ports."""

# curses colours of states: (number of the pair, foreground, background, attributes); -1 is the terminal's own
COLOURS = {
    "Active": (1, curses.COLOR_GREEN, -1, curses.A_BOLD),
    "Inactive": (2, curses.COLOR_BLUE, -1, curses.A_BOLD),
    "Error": (3, curses.COLOR_WHITE, curses.COLOR_RED, curses.A_BOLD),
    "?": (4, curses.COLOR_RED, -1, curses.A_BOLD),
}


# ---- the terminal ----


def impossible():
    """Why there can be no page on this terminal; '' if there can."""
    try:
        curses.setupterm(os.environ.get("TERM") or "unknown", sys.stdout.fileno())
    except curses.error:
        return (
            f"the terminal {text.printable(os.environ.get('TERM') or '(TERM is not set)')} is not known here"
        )
    if curses.tigetstr("cup"):
        return ""
    return f"the terminal {text.printable(os.environ['TERM'])} has no pages"


@contextlib.contextmanager
def screen():
    """The terminal as a curses window; restored afterwards."""
    locale.setlocale(locale.LC_CTYPE, "")
    # ms that Esc waits for the rest of a key; the default is a second
    os.environ.setdefault("ESCDELAY", "200")
    for name in "LINES", "COLUMNS":  # readline sets them in rtsh; the terminal knows better
        os.unsetenv(name)
    try:
        window = curses.initscr()
        curses.noecho()
        curses.cbreak()
        window.keypad(True)
        window.nodelay(True)
        curses.putp(BRACKETS)
        with contextlib.suppress(curses.error):  # some terminals cannot
            curses.curs_set(0)
        yield window
    finally:
        with contextlib.suppress(curses.error):  # the terminal is gone
            curses.putp(NO_BRACKETS)
            curses.endwin()


def _attributes():
    """curses attributes of states."""
    if not text.colour_wanted() or not _has_colours():
        return {"Error": curses.A_BOLD, "?": curses.A_BOLD}
    for number, foreground, background, _ in COLOURS.values():
        curses.init_pair(number, foreground, background)
    return {
        state: curses.color_pair(number) | attributes for state, (number, _, _, attributes) in COLOURS.items()
    }


def _has_colours():
    try:
        curses.start_color()
        curses.use_default_colors()
    except curses.error:
        return False
    return curses.has_colors()


def _clipped(line, columns):
    """As much of a line as fits."""
    if len(line) > columns:  # a long line would take long
        line = line[: 4 * columns]
    while text.cells(line) > columns:
        line = line[:-1]
    return line


def _wrapped(line, columns):
    """A line as lines that fit, broken at blanks unless that makes one too short."""
    lines = []
    while line or not lines:
        part = _clipped(line, columns) or line[:1]
        blank = part.rfind(" ") + 1
        if part != line and blank > len(part) / 2:
            part = part[:blank]
        lines.append(part)
        line = line[len(part) :]
    return lines


# ---- the page ----


class Page:
    """Shows a top.Top on a curses window until the user has seen enough."""

    def __init__(self, window, looking, meters, sort, pattern, doctor):
        """`meters`: statistics.Meters; `sort` one of rows.SORTS, and `pattern` the filter, to begin with;
        `doctor` gives lines on a Node.
        """
        self.window = window
        self.looking = looking
        self.meters = meters
        self.sort = sort
        self.pattern = pattern
        self.doctor = doctor
        self.group = "none"  # one of rows.GROUPS
        self.only = None  # paths, if only these are shown
        self.lines = []  # what is shown of `rows`, with lines for groups
        self.attributes = _attributes()
        self.drawn = None  # what was shown last, see `_now`
        self.rows = []  # that match the filter
        self.common = ""  # the directory that their names leave out
        self.selected = None  # the path of a Row
        # index of the selected Row, of the first one shown; how many can be shown
        self.number = self.first = self.room = 0
        self.message = ""
        self.typing = False  # whether the user types the filter
        self.asked = None  # the transitions.Transition and the Row that wait for a y
        self.overlay = None  # lines shown instead of the rows: of rtcat, the keys
        self.plot = None  # the plotting.Plot whose lines these are
        self.overlay_first = 0
        self.ended = False
        self.typed = loop.Bell()  # rings while there is something to be read from the terminal

    async def follow(self):
        """Show the page and handle keys until q."""
        here = loop.current()
        terminal = sys.stdin.fileno()
        here.watch(terminal, loop.READ, self.typed.ring)
        if "readline" not in sys.modules:  # in rtsh the signal is readline's, which would not get it back
            here.hear(real.SIGWINCH, self.looking.bell.ring)
        try:
            async with loop.background(self._keep_drawing()):
                while not self.ended:
                    self._obey(await self._key())
                    self._draw()
        finally:
            here.unwatch(terminal)

    async def _keep_drawing(self):
        while True:
            self._fit()
            self._take_news()
            if self._is_stale():
                self._draw()
            await self.looking.bell.wait(self.looking.delay)

    async def _key(self):
        """A character, or a number for other keys; Esc with all that comes at once with it: a paste, say."""
        key = await self._character(None)
        if key == ESCAPE:
            more = await self._character(0)
        else:
            more = None
        while more is not None:
            key += str(more)
            if key.startswith(PASTE) and key.endswith(PASTE_END):
                break
            more = await self._character(PAUSE if key.startswith(PASTE) else TICK)
        return key

    async def _character(self, seconds):
        """The next one; None if none comes within `seconds`."""
        while True:
            with contextlib.suppress(curses.error):
                return self.window.get_wch()
            if not await self.typed.wait(seconds):
                return None

    def _fit(self):
        """Adopt the size of the terminal."""
        with contextlib.suppress(OSError):
            width, height = os.get_terminal_size(sys.stdout.fileno())
            if min(width, height) > 0 and curses.is_term_resized(height, width):
                curses.resizeterm(height, width)

    def _take_news(self):
        """Take the results of actions."""
        for (command, path), value in self.looking.news():
            if isinstance(value, Exception):
                self.message = f"{command}: {value}"
            elif command == "neighbours":
                self.message = f"{len(value)} connected with {path}; Esc shows all"
                self.only = value | {path}
                self.pattern = ""
            elif command == MEASURE_ALL:
                self.message = ""
            elif isinstance(value, list):
                self.message = ""
                self.overlay = value
                self.overlay_first = 0
            else:
                self.message = f"{command}: {path}: {value}"

    # ---- keys ----

    def _obey(self, key):
        if key == curses.KEY_RESIZE:
            return
        if key == "\x0c":
            self.window.redrawwin()
        elif self.asked:
            self._confirm(key)
        elif self.typing:
            self._type(key)
        elif self.overlay is not None:
            self._obey_overlay(key)
        else:
            self.message = ""
            self._obey_rows(key)

    def _type(self, key):
        if key in ENTER:
            self.typing = False
        elif key == ESCAPE:
            self.typing = False
            self.pattern = ""
        elif key in BACKSPACE:
            self.pattern = self.pattern[:-1]
        elif isinstance(key, str):
            pasted = key.replace(PASTE, "").replace(PASTE_END, "")
            if pasted.startswith(ESCAPE):
                self.pattern += ""
            else:
                self.pattern += "".join(filter(str.isprintable, pasted))

    def _obey_overlay(self, key):
        step = self._step(key)
        if step is not None:
            self.overlay_first += step
        elif key == "p" and self.plot is not None:
            self._plot(self.plot.number + 1)
        elif key in ("q", "c", "d", "m", "h", "?", ESCAPE) + ENTER:
            self.overlay = None
            self._end_plot()

    def _plot(self, number):
        """Plot what the out port of this number of the selected component sends."""
        from rtshell_lite.top import plotting

        self._end_plot()
        node = self.looking.node(self.selected)
        if node is None:
            return
        self.plot = plotting.Plot(node, number, self._take_plot)
        self.overlay = [f"plotting {self.selected} …"]
        self.overlay_first = 0
        self.plot.task = self.looking.run(self.plot.follow())

    def _take_plot(self, picture):
        """Show the picture of a plot, lines for a width and a height."""
        height, width = self.window.getmaxyx()
        self.overlay = picture(width, max(height - 3, 1), self.window.encoding.lower().startswith("utf"))
        self.looking.bell.ring()

    def _end_plot(self):
        if self.plot is not None:
            self.plot.task.cancel()
            self.plot = None

    def _obey_rows(self, key):
        step = self._step(key)
        if step is not None:
            self._select(self.number + step)
        elif key == "q":
            self.ended = True
        elif key in ("h", "?"):
            self.overlay = HELP.split("\n")
            self.overlay_first = 0
        elif key == "s":
            self.sort = rows.SORTS[(rows.SORTS.index(self.sort) + 1) % len(rows.SORTS)]
            self.message = "sorted by " + self.sort
        elif key == "g":
            self.group = rows.GROUPS[(rows.GROUPS.index(self.group) + 1) % len(rows.GROUPS)]
            self.message = "grouped by " + self.group
        elif key == "/":
            self.typing = True
        elif key == ESCAPE:
            self.pattern = ""
            self.only = None
        elif str(key).startswith(PASTE):
            self.message = "pasted text is not read as keys"
        else:
            self._act(key)

    def _step(self, key):
        """How many lines a key goes down; None for one that does not."""
        page = max(self.room - 1, 1)
        all_of_them = 10**9
        return {
            curses.KEY_DOWN: 1,
            "j": 1,
            curses.KEY_UP: -1,
            "k": -1,
            curses.KEY_NPAGE: page,
            curses.KEY_PPAGE: -page,
            curses.KEY_HOME: -all_of_them,
            curses.KEY_END: all_of_them,
        }.get(key)

    def _select(self, number):
        self.number = max(0, min(number, len(self.rows) - 1))
        self.selected = self.rows[self.number].path if self.rows else None

    def _act(self, key):
        if self.selected is None:
            return
        transition = {"a": transitions.ACTIVATE, "i": transitions.DEACTIVATE, "r": transitions.RESET}.get(key)
        if transition:
            self.asked = transition, self.rows[self.number]
        elif key == "c" or key in ENTER:
            self.message = f"rtcat: {self.selected} …"
            self.looking.show(self.selected)
        elif key == "d":
            self.message = f"rtdoctor: {self.selected} …"
            self.looking.ask(self.selected, "rtdoctor", self.doctor)
        elif key == "m":
            self.message = f"measuring {self.selected} …"
            self.looking.measure(self.selected)
        elif key == "M":
            self.message = "measuring what is seen here …"
            for path in self.looking.shown:
                self.looking.measure(path, MEASURE_ALL)
        elif key == "p":
            self._plot(0)
        elif key == "n":
            self.message = f"neighbours of {self.selected} …"
            self.looking.show_neighbours(self.selected)

    def _confirm(self, key):
        (transition, row), self.asked = self.asked, None
        if key in ("y", "Y"):
            self.message = f"{transition.command}: {row.path} …"
            self.looking.change(row.path, transition)

    # ---- drawing ----

    def _is_stale(self):
        """Whether the page may not be what was drawn last: it has clocks, or something has changed."""
        has_clocks = self.meters or self.overlay is not None or self.window.getmaxyx()[1] >= rows.WIDE
        return has_clocks or self.drawn != self._now()

    def _now(self):
        """All that a page without clocks shows, but for what keys change: these have it drawn."""
        return self.looking.rows(), self.message, self.only, self.window.getmaxyx()

    def _draw(self):
        height, width = self.window.getmaxyx()
        self.drawn = self._now()
        components = self.drawn[0]
        shown = rows.arranged(components, self.sort, self.pattern)
        if self.only is not None:
            shown = [row for row in shown if row.path in self.only]
        shown, self.common = rows.shortened(shown)
        self.lines = rows.grouped(shown, self.group)
        self.rows = [line for line in self.lines if isinstance(line, rows.Row)]
        paths = [row.path for row in self.rows]
        number = self.number
        if self.selected in paths:
            number = paths.index(self.selected)
        self._select(number)
        self.window.erase()
        top = self._draw_head(components, height, width)
        foot = self._foot(width)[: max(height - top - 1, 1)]
        self.room = max(height - top - len(foot), 0)
        if self.overlay is None:
            self._draw_rows(top, width)
        else:
            self._draw_overlay(top, width)
        for i, line in enumerate(foot):
            self._put(height - len(foot) + i, line)
        self.window.refresh()

    def _draw_head(self, components, height, width):
        """The summary, the flow of ports, the head of the columns; returns the number of lines."""
        matching = f"; {len(self.rows)} with: {self.pattern}" if self.pattern else ""
        common = self.common
        if width >= rows.WIDE:
            common = rows.common_directory(self.rows)
        below = f"; below {common}" if common else ""
        self._put(0, f"{rows.summary(components)}{matching}{below}", curses.A_BOLD)
        rates = [rows.rate_line(meter.rate()) for meter in self.meters]
        most = max(height // 3, 1)
        if len(rates) > most:
            rates[most - 1 :] = [f"{len(rates) - most + 1} more ports"]
        for i, line in enumerate(rates, 1):
            self._put(i, line)
        if self.overlay is not None:
            head = ""
        elif width >= rows.WIDE:
            head = rows.wide_head(self.rows)
        else:
            head = rows.HEAD
        self._put(1 + len(rates), text.padded(head, max(width, len(head))), curses.A_REVERSE)
        return 2 + len(rates)

    def _draw_rows(self, top, width):
        """The lines around the selected one, as many as there is room for."""
        chosen = self.lines.index(self.rows[self.number]) if self.rows else 0
        last = min(self.first, chosen, max(len(self.lines) - self.room, 0))
        self.first = max(last, chosen - self.room + 1)
        if chosen == self.first == 1:
            self.first = 0  # the line of its group
        shown = self.lines[self.first : self.first + self.room]
        self.looking.shown = {line.path for line in shown if isinstance(line, rows.Row)}
        for y, (line, words) in enumerate(zip(shown, self._spelt_lines(shown, width)), top):
            if not isinstance(line, rows.Row):
                self._put(y, words, curses.A_UNDERLINE)
            elif line.path == self.selected:
                self._put(y, words, curses.A_REVERSE)
            else:
                self._put(y, words)
                self._put(y, line.state or "", self.attributes.get(line.state, 0))

    def _spelt_lines(self, shown, width):
        """What is drawn for Rows and lines of groups."""
        if width < rows.WIDE:
            return [rows.line(line) if isinstance(line, rows.Row) else line for line in shown]
        wide = rows.wide_lines([line for line in shown if isinstance(line, rows.Row)], self.rows)
        return [next(wide) if isinstance(line, rows.Row) else line for line in shown]

    def _draw_overlay(self, top, width):
        lines = [part for line in self.overlay for part in _wrapped(self._spelt(line), max(width, 1))]
        self.overlay_first = max(0, min(self.overlay_first, len(lines) - self.room))
        for y, line in enumerate(lines[self.overlay_first : self.overlay_first + self.room], top):
            self._put(y, line)

    def _foot(self, width):
        """The last lines: what is typed, what was done, what is wrong with the selected component,
        or the keys.
        """
        row = self.rows[self.number] if self.rows else None
        if self.asked:
            line = f"{self.asked[0].name} {self.asked[1].name}? y/N"
        elif self.typing:
            line = "/" + self.pattern + "_"
        elif self.message:
            line = text.safe(self.message)
        elif self.plot is not None:
            line = "q back  p next port"
        elif self.overlay is not None:
            line = "q back  up down PgUp PgDn"
        elif row and row.failure:
            line = f"{row.path}: {rows.reason(row.path, row.failure)}"
        else:
            line = HINTS
        return _wrapped(self._spelt(line), max(width, 1))

    def _put(self, y, line, attributes=0):
        height, width = self.window.getmaxyx()
        if y >= height:
            return
        # the cursor cannot go after the last cell; it is written all the same
        with contextlib.suppress(curses.error):
            self.window.addstr(y, 0, _clipped(self._spelt(line), width), attributes)

    def _spelt(self, line):
        """A line with characters escaped that the terminal's character set lacks."""
        coding = self.window.encoding
        return text.safe(line).encode(coding, "backslashreplace").decode(coding)


async def show(looking, meters, sort, pattern, doctor):
    """Show the page until the user ends it; the terminal is always restored."""
    with screen() as window:
        await Page(window, looking, meters, sort, pattern, doctor).follow()
