"""Where the numbers of a plot come from: a log, or ports."""

from rtshell_lite import errors, text
from rtshell_lite.data import datatypes, values
from rtshell_lite.datalog import gaps, records, schemas
from rtshell_lite.text import printable
from rtshell_lite.views import plot

MOST_MEANT = 4  # channels of a component that an error names
PANELS = 8  # of a log without names of channels
WINDOWS = 100  # spans of a log for which rates are counted, at most
FEWEST = 3  # of them
STEPS = 30  # spans in which values are counted that are known only by their number, at most
ENOUGH = 10  # values of such a span, or the rate would seem to jump
PER_SECOND = ", values per second"  # after the name of what has a rate
# what is shown of values: their fields, how many came a second, how old they were
SHOWN = ("", "rate", "delay")


class Source:
    """One channel or port, and the plot.Panel of what is shown of it."""

    def __init__(self, name, field, shown, between=None, width=10**9):
        """`field`: a plot.Field; `between`: (first, last) ns where they are known; `width`: ns of a span for
        the rate.
        """
        self.field = field
        self._between = between
        if shown == "rate":
            self.panel = plot.Panel(name + PER_SECOND)
            self._rate = plot.Rate(self.panel.named("rate", between), width)
        elif shown == "delay":
            self.panel = plot.Panel(name + ", seconds from timestamp to arrival")
        else:
            self.panel = plot.Panel(name + "." * bool(field.path) + field.path)
        self._shown = shown
        self._breaks = []  # moments after which the line begins anew, the latest first
        self.failure = None  # why a value could not be shown

    def break_at(self, moments):
        """Values are missing at these moments."""
        self._breaks = sorted(moments, reverse=True)

    def take(self, moment, value):
        """Take a value that came at a moment. `value` is a function: it is not decoded for its rate."""
        while self._breaks and moment > self._breaks[-1]:
            self._breaks.pop()
            for series in self.panel.series.values():
                series.interrupt()
        if self._shown == "rate":
            self._rate.add(moment)
            return
        try:
            self._take(moment, value)
        except errors.Error as e:
            self.failure = self.failure or e

    def _take(self, moment, value):
        if self._shown == "delay":
            stamp = values.timestamp(value())
            if stamp and any(stamp):
                sent = stamp[0] * 10**9 + stamp[1]
                self.panel.named("delay", self._between).add(moment, (moment - sent) / 1e9)
        else:
            self.panel.add(moment, self.field, value(), self._between)

    def check(self):
        """Raise why nothing can be shown, where that is so."""
        if not self.panel.series and self.failure:
            raise self.failure

    def advance(self, moment):
        """No more values come before `moment`."""
        if self._shown == "rate":
            self._rate.advance(moment)


def of_counts(measured):
    """The plot.Picture of how many values came a second, with equal axes; `measured`: (name,
    statistics.Counts, when counting began and ended in ns since 1970) of each source.
    """
    picture = plot.Picture([_counted(*source) for source in measured])
    most = max([panel.named("rate").greatest or 0 for panel in picture.panels] or [0])
    for panel in picture.panels:
        panel.axis = (0.0, most or 1.0)
    picture.fit()
    return picture


def _counted(name, counts, first, last):
    """The plot.Panel of the rate of one source."""
    panel = plot.Panel(name + PER_SECOND)
    steps = sum(counts.spans.values()) // ENOUGH
    width = (last - first) // max(FEWEST, min(steps, STEPS))
    rate = plot.Rate(panel.named("rate"), max(width, 1))
    rate.add(first, 0)
    for span in sorted(counts.spans):
        rate.add(span * counts.width, counts.spans[span])
    rate.advance(last)
    return panel


# ---- a log ----


def channel(log, word):
    """(number of a channel of a log, plot.Field) for CHANNEL[.FIELD]; a channel may be called as
    records.is_called says. Raises NoSuch, Ambiguous, BadPath.
    """
    names = [channel.name for channel in log.channels]
    for cut in records.cuts(word):
        name = word[:cut]
        numbers = [number for number, known_name in enumerate(names) if known_name == name]
        numbers = numbers or _called(log, name)
        if len(numbers) > 1:
            candidates = text.listed([printable(names[number]) for number in numbers])
            raise errors.Ambiguous(printable(name), f"is one of {len(numbers)} channels: {candidates}")
        if numbers:
            return numbers[0], plot.Field(word[cut:].lstrip("."))
    component = word.partition(".")[0]
    close = [printable(name) for name in names if f"/{component}." in name]
    if 0 < len(close) <= MOST_MEANT:
        meant = f"; did you mean {' or '.join(close)}?"
    else:
        meant = text.candidates(word, names)
    raise errors.NoSuch(log.where, "channel", printable(word) + meant)


def _parts(log, words, shown, since):
    """What each word names: (number, plot.Field) as `channel` has it, or the plot_states.States of a
    component. Raises as `channel` does.
    """
    parts = []
    described = None
    for word in words:
        try:
            parts.append(channel(log, word))
        except errors.NoSuch as e:
            if shown or not log.attachments:
                raise
            from rtshell_lite.play import recording  # imports json, which Debian's python3-minimal lacks

            described = recording.details(log) if described is None else described
            parts.append(_states(log, word, described, since, e))
    return parts


def _states(log, word, described, since, error):
    """The plot_states.States of the component that is called so. Raises `error` where none is, Ambiguous."""
    from rtshell_lite.views import plot_states

    paths = sorted({where for details in described.values() for where in details})
    called = [where for where in paths if records.is_called(word, (where,))]
    if not called:
        raise error
    if len(called) > 1:
        candidates = text.listed(list(map(printable, called)))
        raise errors.Ambiguous(printable(word), f"is one of {len(called)} components: {candidates}")
    return plot_states.States(described, called[0], since)


def _called(log, name):
    """Numbers of the channels that may be called so."""
    return [
        number
        for number, channel in enumerate(log.channels)
        if records.is_called(name, (channel.name, *channel.sources))
    ]


def of_log(decoder, words, shown, entries, since=0):
    """The plot.Picture of some of the `entries` of a log (decode.Decoder), those `since` a moment: of the
    `words` CHANNEL[.FIELD] or COMPONENT, or all. Raises errors.Error.
    """
    log = decoder.log
    between = (log.first or 0, log.last or 0)
    span = between[1] - between[0]
    width = max(span // WINDOWS, min(10**9, span // FEWEST), 1)
    sources_of = {}
    sources = []
    events = {number for number, channel in enumerate(log.channels) if channel.type_id == schemas.EVENT}
    for part in _parts(log, words, shown, max(between[0], since)) or _all(log):
        source, numbers = part, events
        if isinstance(part, tuple):
            number, field = part
            source, numbers = Source(log.channels[number].name, field, shown, between, width), [number]
        sources.append(source)
        for number in numbers:
            sources_of.setdefault(number, []).append(source)
    picture = plot.Picture([source.panel for source in sources])
    _show_gaps(log, sources_of, picture)
    moment = 0
    for entry in entries:
        moment = entry.received
        if entry.channel in events and isinstance(entry.value, dict) and entry.value.get("mark"):
            picture.marks.append((moment, printable(str(entry.value["mark"]))))
        for source in sources_of.get(entry.channel, ()):
            source.take(moment, lambda: _value(decoder, entry))
    for source in sources:
        source.advance(moment)
        source.check()
    picture.fit()
    return picture


def _show_gaps(log, sources_of, picture):
    """Mark what is missing in a log, and have lines begin anew after it. `sources_of`: {number of a channel:
    Sources}.
    """
    breaks = {}
    for gap in log.gaps:
        shown = {number for number in sources_of if log.channels[number].name in gap.counts}
        for number in shown:
            breaks.setdefault(number, []).extend((gap.first, gap.last))
        if shown:
            picture.marks.append((gap.first, "missing: " + gaps.words(gap)))
    for number, moments in breaks.items():
        for source in sources_of[number]:
            source.break_at(moments)


def _value(decoder, entry):
    """The value of an entry. Raises NoSuch, Failed."""
    value = decoder.value(entry)
    if value is not None:
        return value
    if entry.data is None:
        return entry.value
    type_id = decoder.log.channels[entry.channel].type_id
    raise errors.NoSuch(printable(type_id) or "a type without a name", "data type known", datatypes.SOURCES)


def _all(log):
    """All channels with values but those of events, at most PANELS."""
    counts = log.counts
    numbers = [
        number
        for number, channel in enumerate(log.channels)
        if counts.get(channel.name) and (channel.encoding == "cdr" or channel.type_id != schemas.EVENT)
    ]
    return [(number, plot.Field("")) for number in numbers[:PANELS]]


# ---- ports ----


def named_port(path, listed):
    """(Port, plot.Field) for PATH:PORT[.FIELD] among the ports of a component. Raises NoSuch, BadPath."""
    from rtshell_lite.robot import ports

    for cut in records.cuts(path.port):
        port = ports.named(path.with_port(path.port[:cut]), listed)
        if not isinstance(port, errors.Error):
            return port, plot.Field(path.port[cut:].lstrip("."))
    raise ports.named(path, listed)
