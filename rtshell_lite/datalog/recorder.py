"""Recording: what waits in an inbox.Inbox is written by a thread of its own, so that no sender waits for a disk."""
import threading
import time

from rtshell_lite import datatypes, errors, inbox, interrupts, ports
from rtshell_lite.datalog import Channel, blocks
from rtshell_lite.text import printable

VALUES = 200000  # that may wait
TICK = 0.1  # seconds between two looks whether recording is over
SYNC = 5.0  # seconds between two fsyncs: what a power failure costs


class Channels:
    """The channels of a log to be: ports of one NAME share one.

    `found` are the datalog.Channels, `types` their datatypes.Type or None; `notes` say why None.
    """

    def __init__(self, known):
        """`known` are datatypes.Types."""
        self._known, self.found, self.types, self.notes = known, [], [], []

    def add(self, port, name):
        """The number of a Port's channel. Raises errors.No when its NAME is taken by one of another type."""
        where, type_id = ports.label(port), port.properties.get("dataport.data_type", "")
        for number, channel in enumerate(self.found):
            if channel.name == name:
                if not ports.same_type(channel.type_id, type_id):
                    raise errors.No(where, "%s has another data type (%s, %s)" % (
                        printable(name), printable(channel.type_id), printable(type_id)))
                channel.sources.append(where)
                return number
        try:
            type = self._known.of_port(port)
        except errors.NoSuch:
            type = None
            self.notes.append("%s: recorded as bytes: %s is not known; %s" % (where, printable(type_id), datatypes.SOURCES))
        except errors.BadType as e:
            type = None
            self.notes.append("%s: recorded as bytes: %s" % (where, e))
        self.types.append(type)
        self.found.append(Channel(name, type.id if type else type_id, type.to_bytes() if type else b"", [where]))
        return len(self.found) - 1


class Recorder:
    """Writes the Messages that come into its `box`, whose keys are numbers of channels.

    `done` is an Event that is set when `most` messages are written, or no more can be. `count` and `octets` tell how many
    were written, `failure` (OSError or None) why no more could be.
    """

    def __init__(self, most=None):
        self.box, self._most = inbox.Inbox(VALUES), most
        self.count = self.octets = 0
        self.failure = self._thread = None
        self.done, self._stopped = threading.Event(), threading.Event()

    def start(self, writer):
        """Write what has come and what will come with a Writer (of writer or textlog)."""
        with interrupts.held():  # `close` waits for a thread that has started
            self._thread = threading.Thread(target=self._run, args=(writer,), daemon=True)
            self._thread.start()

    def close(self):
        """Wait until all that has come is written and on the disk. Raises OSError: why writing failed; a bug's RuntimeError."""
        self._stopped.set()
        if self._thread:
            self._thread.join()
        if self.failure:
            raise self.failure

    def _run(self, writer):
        self.failure = RuntimeError("the thread that writes has ended")  # until it is known better: a bug is no success
        try:
            self.failure = self._written(writer)
        finally:
            self.done.set()

    def _written(self, writer):
        """Write until the end, and close; the OSError that prevented it, or None."""
        failure = None
        for step in (lambda: self._write(writer), writer.close):
            try:
                step()
            except OSError as e:
                failure = failure or e
        return failure

    def _fits(self, channel, message):
        if len(message.data) <= blocks.LARGEST:
            return True
        self.box.dropped[channel] += 1
        return False

    def _write(self, writer):
        due, last = time.monotonic() + SYNC, False
        while not (last or self.done.is_set()):
            last = self._stopped.is_set()
            batch = self.box.get(0 if last else TICK)
            batch = [each for each in batch if self._fits(*each)]
            if self._most is not None:
                batch = batch[:self._most - self.count]
            writer.write([(channel, message.received, message.little, message.data) for channel, message in batch])
            self.count += len(batch)
            self.octets += sum(len(message.data) for _, message in batch)
            if self.count == self._most:
                self.done.set()
            if time.monotonic() >= due:
                writer.sync()
                due = time.monotonic() + SYNC
