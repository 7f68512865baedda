"""What commands report while they are connected: failures of connections. They end when nobody reads their output."""
import errno
import select
import sys

from rtshell_lite import cli


class Watcher:
    """Reports on stderr when a connection fails, and when a silent one answers again."""

    def __init__(self, connections):
        self.connections, self.reported = connections, {}  # failures, by connection
        self.output = select.poll()
        try:
            self.output.register(sys.stdout.fileno(), 0)
        except OSError:
            pass  # there is none

    def look(self):
        """To be called a few times a second. Raises BrokenPipeError when nobody reads the output."""
        for connection in self.connections:
            where, failure, before = connection.where, connection.failure, self.reported.get(connection)
            self._remark(connection)
            if failure is not None and str(failure) != str(before):
                cli.complain(failure)
            elif failure is None and before is not None:
                cli.note(f"{where}: answers again")
            self.reported[connection] = failure
        if any(events & (select.POLLERR | select.POLLHUP) for _, events in self.output.poll(0)):
            cli.ignore_hangup()
            raise BrokenPipeError(errno.EPIPE, "nobody reads the output")

    def _remark(self, connection):
        if connection.remark:
            cli.note(f"{connection.where}: {connection.remark}")
            connection.remark = None

    def skip(self):
        """Do not report present failures: they have been."""
        self.reported.update({connection: connection.failure for connection in self.connections if connection.failure is not None})

    def count(self, tally, of_no_use=()):
        """Add each connection's failure or success to a Tally; what has been reported is not reported again.

        Those in `of_no_use` work, but nothing of what came from them could be used: they do not count as done.
        """
        for connection in self.connections:
            self._remark(connection)
            tally.reported.update({str(self.reported.get(connection)), str(connection.told)})
            if connection.failure or connection not in of_no_use:
                tally.add(connection.failure)
