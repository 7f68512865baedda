"""A component that sends at a rate of its own, faster than contexts of mocks run."""
from . import carrier, values
from .idl import RTC
from .rtc import Component

PATIENCE = 1.0              # seconds that it may be late before it gives up catching up


class Source(Component):
    """While active it sends, at the rate of its context: on `number` 1, 2, 3 …, on `block` as many octets as
    its option `size` says.
    """

    def activated(self, handle):
        self.halt = carrier.Event()
        self.process.thread(self._send, self.halt)
        return RTC.RTC_OK

    def deactivated(self, handle):
        self.halt.set()
        return RTC.RTC_OK

    def _send(self, halt):
        number = 0
        due = carrier.now()
        while not halt.wait(max(0, due - carrier.now())):
            number += 1
            stamped = values.make("TimedLong", number, True)
            self.port("number").write(stamped)
            self.port("block").write(RTC.TimedOctetSeq(stamped.tm, self._octets(number)))
            due = max(due + 1.0 / self.owned[0].rate, carrier.now() - PATIENCE)

    def _octets(self, number):
        """The number, least significant octet first, then zeros."""
        return number.to_bytes(8, "little")[:self.options.size].ljust(self.options.size, b"\0")
