"""The ring buffer of a port: values wait in it until they are read. Its length and policies come with
connectors.
"""
import collections

from . import carrier
from .properties import get

LENGTH = 8              # values, where no connector has asked for another length
POLICIES = ("overwrite", "do_nothing", "block")


class RingBuffer:
    """An InPort has one for all its connections, for as long as it lives.

    What a connector asks for stays after it: the next one finds the same length and policies, and the values
    that nobody has read. A connector that asks for a length, even for the same one, empties the buffer
    (RingBuffer::length of C++ and Python).
    """

    def __init__(self):
        self.values = collections.deque()
        self.length = LENGTH
        self.policy = "overwrite"
        self.timeout = 1.0
        self.waiting = 0  # values that wait for room
        self.changed = carrier.Condition()

    def configure(self, properties, side):
        """Apply a connector's properties; those of this side override those of both."""
        def asked(name):
            return get(properties, f"dataport.{side}.buffer.{name}") or get(
                properties, "dataport.buffer." + name
            )

        with self.changed:
            if asked("length").isdigit() and int(asked("length")) > 0:
                self.length = int(asked("length"))
                self.values.clear()
            if asked("write.full_policy") in POLICIES:
                self.policy = asked("write.full_policy")
                self.timeout = float(asked("write.timeout") or self.timeout)

    def write(self, value):
        """Add a value; the name of the status that put() returns."""
        with self.changed:
            if len(self.values) >= self.length and self.policy == "block":
                self.waiting += 1
                self.changed.wait_for(lambda: len(self.values) < self.length, self.timeout)
                self.waiting -= 1
            if len(self.values) >= self.length:
                if self.policy != "overwrite":
                    return "BUFFER_FULL" if self.policy == "do_nothing" else "BUFFER_TIMEOUT"
                self.values.popleft()
            self.values.append(value)
        return "PORT_OK"

    def read(self):
        """The oldest value that has not been read, or None."""
        with self.changed:
            found = self.values.popleft() if self.values else None
            self.changed.notify_all()
        return found
