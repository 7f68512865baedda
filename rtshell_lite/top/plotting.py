"""The plot of an out port on the page of rttop, as rtplot draws it."""


from rtshell_lite import errors
from rtshell_lite.data import connection, datatypes, inbox, reading
from rtshell_lite.net import loop
from rtshell_lite.robot import ports
from rtshell_lite.text import printable
from rtshell_lite.views import plot, plot_sources, plot_text

FRAME = 0.2  # seconds between two pictures
WINDOW = 10.0  # seconds that are shown


class Plot:
    """What one out port of a component sends.

    node    Node of the component
    number  of its out ports; after the last one comes the first
    show    function that is called with a function(width, height, whether there is braille): the lines of a
            picture
    task    what follows it: to be cancelled at the end, which removes the connection
    """

    def __init__(self, node, number, show):
        self.node = node
        self.number = number
        self.show = show
        self.task = None  # type: loop.Task

    async def follow(self):
        """Connect to the port, and show what it sends until this is cancelled."""
        try:
            await self._follow()
        except errors.Error as e:
            self._say(str(e))

    def _say(self, line):
        self.show(lambda *_: [line])

    async def _follow(self):
        listed = [port for port in await ports.ports(self.node) if port.type == "DataOutPort"]
        if not listed:
            self._say("it has no out port")
            return
        self.number %= len(listed)
        port = listed[self.number]
        kind = await datatypes.Types().load().of_port(port)
        box = inbox.Inbox()
        reader = reading.Reader(port, box.taker(0), None, {}, "rttop")
        source = plot_sources.Source(ports.label(port), plot.Field(""), "")
        async with connection.Connections([reader]):
            while reader.failure is None:
                for _, message in await box.get(0):
                    source.take(message.received, lambda: kind.decode(message.data, message.little))
                self._draw(source)
                await loop.sleep(FRAME)
        raise reader.failure

    def _draw(self, source):
        old = loop.wall() - WINDOW
        for series in source.panel.series.values():
            series.forget(int(old * 1e9))
        picture = plot.Picture([source.panel])
        picture.fit()
        if picture.is_empty():
            why = source.failure or "nothing has come in the last %g s" % WINDOW
            self._say(f"{printable(source.panel.title)}: {why}")
        else:
            self.show(lambda width, height, braille: plot_text.lines(picture, width, height, braille))
