"""Recording: a bounded queue between the threads that receive messages and the one that writes them.

A sender waits for its `put` to return: nothing here makes it wait for a disk. What the queue cannot hold is dropped and
counted.
"""
import threading
import time

from rtshell_lite.datalog import blocks

ROOM = 64 << 20  # octets that may wait
COUNT = 200000  # messages that may wait: small ones cost more than their octets
SYNC = 5.0  # seconds between two fsyncs: a power failure costs so much


class Recorder:
    """Takes messages and lets a Writer write them on a thread of its own, from `start` on.

    `done` is an Event that is set when `most` messages are in, or nothing more can be written. `count` and `octets` are
    what was accepted, `dropped` what was not.
    """

    def __init__(self, most=None):
        self._writer, self._most = None, most
        self._queue, self._octets, self._closing = [], 0, False
        self._change = threading.Condition()
        self.done = threading.Event()
        self.count = self.octets = self.dropped = 0
        self.failure = self._thread = None

    def start(self, writer):
        """Write what has come and what will come."""
        self._writer = writer
        self._thread = threading.Thread(target=self._write, daemon=True)
        self._thread.start()

    def taker(self, channel):
        """A function for messages of a channel (its number), to be called by any thread."""
        return lambda message: self._accept(channel, message)

    def _accept(self, channel, message):
        """Put one dataport.Message into the queue, or drop it; never waits."""
        size = len(message.data)
        with self._change:
            if self.done.is_set() or self._closing:
                return
            if self._octets + size > ROOM or len(self._queue) >= COUNT or size > blocks.LARGEST:
                self.dropped += 1
                return
            self._queue.append((channel, message.received, message.little, message.data))
            self._octets += size
            self.count += 1
            self.octets += size
            if self.count == self._most:
                self.done.set()
            if len(self._queue) == 1:
                self._change.notify()

    def stop(self):
        """Take no more."""
        with self._change:
            self._closing = True
            self._change.notify()

    def close(self):
        """Take no more, and wait until all is written and on the disk. Raises OSError: why writing failed."""
        self.stop()
        if self._thread:
            self._thread.join()
        if self.failure:
            raise self.failure

    def _write(self):
        due, closing = time.monotonic() + SYNC, False
        try:
            while not closing:
                batch, closing = self._next(due - time.monotonic())
                self._writer.write(batch)
                if time.monotonic() >= due:
                    self._writer.sync()
                    due = time.monotonic() + SYNC
        except OSError as e:
            self.failure = e
        try:
            self._writer.close()
        except OSError as e:
            self.failure = self.failure or e
        self.done.set()

    def _next(self, seconds):
        """All that waits (at most so many seconds until there is something), and whether it is the last."""
        with self._change:
            if not self._queue and not self._closing:
                self._change.wait(max(seconds, 0))
            batch, self._queue, self._octets = self._queue, [], 0
            return batch, self._closing
