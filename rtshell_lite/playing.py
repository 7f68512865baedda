"""Playing a log to ports: which port gets which channel, and what becomes of each entry."""
import time

from rtshell_lite import cli, connection, delivery, errors, streams, targets
from rtshell_lite.datalog import play


class Playing:
    """A log that is played to ports; those that cannot be played to are counted in `tally`, and told."""

    def __init__(self, wanted, properties, channels, anyway):
        """`wanted` are targets.Targets, `properties` go into the connections, `channels` are the log's meaning.Channels.

        `anyway`: to components that are not going to read the values, too.
        """
        self.channels, self.tally = channels, cli.Tally()
        self.sinks = list(self._sinks(wanted, properties, anyway))

    def _sinks(self, wanted, properties, anyway):
        for place, each in enumerate(targets.find(wanted)):
            try:
                if isinstance(each, errors.Error):
                    raise each
                number = play.channel(self.channels.log, each.port, each.name, place)
                writer = delivery.Writer(each.port, properties, "rtlog", anyway)
                log = self.channels.log
                coming = log.counts.get(log.channels[number].name, 0)
                writer.expect(coming, log.size // max(1, coming))
                yield number, writer
            except errors.Error as e:
                self.tally.add(e)

    def play(self, entries, absolute, linger):
        """Send the entries as they come; with `absolute` the times within them stay, else they are moved to now.

        Then wait until they can have been read, for `linger` seconds at most (None: as long as it takes). Returns True when all
        were sent, False when no port was left before. Disconnects however it ends.
        """
        watcher = streams.Watcher([writer for _, writer in self.sinks])
        with connection.Opened(watcher.connections) as opened:
            complete = self._send(entries, absolute, opened, watcher)
            delivery.linger(opened.live(), linger, watcher.look)
        watcher.count(self.tally)
        return complete

    def _send(self, entries, absolute, opened, watcher):
        """Give each entry to the ports of its channel; a port that is gone gets no more."""
        for entry in entries:
            live = opened.live()
            if not live:
                return False
            able = [writer for writer in live if writer.failure is None] or live  # who is silent holds up all
            for _, writer in [sink for sink in self.sinks if sink[0] == entry.channel and sink[1] in able]:
                try:
                    moment = None if absolute else int(time.time() * 1e9)
                    writer.put(self.channels.data(entry, writer.little, moment), writer.little)
                    writer.failure = None
                except (errors.Refused, errors.No) as e:
                    self.tally.add(e)
                except errors.Error as e:
                    writer.failure = e
                    watcher.look()
        return True
