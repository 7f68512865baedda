"""What commands that stay connected report meanwhile: which connections fail, and that nobody reads the output."""
import errno
import select
import sys

from rtshell_lite import cli


class Watcher:
    """Reports on stderr when a connection fails and, after silence, when it goes on; ends us when nobody reads our output."""

    def __init__(self, connections):
        self.connections, self.told = connections, {}
        self.output = select.poll()
        try:
            self.output.register(sys.stdout.fileno(), 0)
        except OSError:
            pass  # there is none

    def look(self):
        """To be called a few times a second. Raises BrokenPipeError."""
        for each in self.connections:
            if each.remark:
                cli.note(f"{each.where}: {each.remark}")
                each.remark = None
            before = self.told.get(each)
            if each.failure is not None and str(each.failure) != str(before):
                cli.complain(each.failure)
            elif each.failure is None and before is not None:
                cli.note(f"{each.where}: answers again")
            self.told[each] = each.failure
        if any(events & (select.POLLERR | select.POLLHUP) for _, events in self.output.poll(0)):
            cli.ignore_hangup()
            raise BrokenPipeError(errno.EPIPE, "nobody reads the output")

    def skip(self):
        """What is wrong now has been reported already."""
        self.told.update({each: each.failure for each in self.connections if each.failure is not None})

    def count(self, tally, of_no_use=()):
        """Add each connection's failure or success to a Tally; what was reported before is not reported again.

        Those in `of_no_use` are well, but all that came from them has been counted as failed.
        """
        for each in self.connections:
            tally.told.add(str(self.told.get(each)))
            if each.failure or each not in of_no_use:
                tally.add(each.failure)
