"""What commands report while they are connected: failures of connections."""

from rtshell_lite import notes
from rtshell_lite.net import loop

TICK = 0.2  # seconds between two looks
PATIENCE = 1.0  # seconds to wait for a terminal that takes no report


class Watcher:
    """Reports when a connection fails, and when a silent one answers again."""

    def __init__(self, connections):
        # failures, by connection
        self.connections = connections
        self.reported = {}

    async def watch(self):
        """Look again and again."""
        while True:
            await self.report_news()
            await loop.sleep(TICK)

    async def report_news(self):
        """Report what is new."""
        told = self.reported
        changed = [
            connection
            for connection in self.connections
            if connection.remark or connection.failure is not told.get(connection)
        ]
        news = [report for connection in changed for report in self._news(connection)]
        if news:  # on a thread, as a terminal may take nothing while components need our answers
            await loop.finish(loop.race(loop.on_thread(_report, news), loop.sleep(PATIENCE)))

    def _news(self, connection):
        """What is to be reported: (function, its argument)."""
        where = connection.where
        failure = connection.failure
        before = self.reported.get(connection)
        self.reported[connection] = failure
        yield from self._remarks(connection)
        if failure is not None and str(failure) != str(before):
            yield notes.fail, failure
        elif failure is None and before is not None:
            yield notes.note, f"{where}: answers again"

    @staticmethod
    def _remarks(connection):
        if connection.remark:
            yield notes.note, f"{connection.where}: {connection.remark}"
            connection.remark = None

    def skip(self):
        """Do not report present failures: they have been."""
        for connection in self.connections:
            if connection.failure is not None:
                self.reported[connection] = connection.failure

    def count(self, tally, useless=()):
        """Add each connection's failure or success to a Tally; what has been reported is not reported again.

        Those that are `useless` work, but nothing of what came from them could be used: they do not count as
        done.
        """
        for connection in self.connections:
            _report(self._remarks(connection))
            tally.reported.update({str(self.reported.get(connection)), str(connection.reported)})
            if connection.failure or connection not in useless:
                tally.add(connection.failure)


def _report(news):
    for function, what in news:
        function(what)
