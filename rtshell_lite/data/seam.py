"""Where one connector of a port follows another, and both have brought values meanwhile: each value once."""

import collections

EACH = 200  # bytes that a value takes besides its own
MOST_BYTES = 16 << 20  # of values that came through the old connector, which may come again


class Seam:
    """What comes through two connectors of a port, the old one and the new one, as one sequence.

    Values of the old one are delivered at once. Those of the new one wait until the old one has ended; then
    those that the old one has brought, too, are dropped. Values with a time are told apart by their bytes;
    without one, only those that came after the new connector was made can come twice.
    """

    def __init__(self, deliver, is_stamped, pass_on=lambda: None):
        """deliver(reading.Message); is_stamped(Message): whether it has a time of its own; pass_on(): gives
        take_old() at once what the old connector has brought already.
        """
        self._deliver = deliver
        self._pass_on = pass_on
        self._is_stamped = is_stamped
        self._old = collections.deque()  # (number of a Message, Message) that may come again
        self._old_bytes = 0
        self._held = []
        self.held_bytes = 0
        self._number = 0  # of the old one's next value
        self._sure = 0  # the first number of those that come again for certain
        self._is_checked = False  # whether the first value of the new connector has been compared
        self._last = None  # the last value that was delivered
        self.gap = None  # (first, last) moments (ns) between which values are missing

    def take_old(self, message):
        """A Message has come through the old connector."""
        self._old.append((self._number, message))
        self._number += 1
        self._old_bytes += len(message.data) + EACH
        while self._old_bytes > MOST_BYTES and len(self._old) > 1:
            self._old_bytes -= len(self._old.popleft()[1].data) + EACH
        self._pass(message)

    def connected(self):
        """The new connector is made: from now on the component sends each value through both."""
        self._pass_on()
        self._sure = self._number

    def take_new(self, message):
        """A Message has come through the new connector, while the old one may still bring some."""
        self._held.append(message)
        self.held_bytes += len(message.data) + EACH

    def end(self):
        """The old connector has ended. Returns as `take` does."""
        held = self._held
        self._held = []
        self.held_bytes = 0
        is_open = bool(self._old)
        for message in held:
            is_open = self.take(message)
        return is_open

    def take(self, message):
        """A Message has come through the new connector, and the old one has ended. Returns whether more may
        come that have been delivered.
        """
        number = self._delivered_number(message)
        if number is None:
            self._check(message)
            self._old.clear()
            self._pass(message)
            return False
        while self._old and self._old[0][0] <= number:
            self._old.popleft()
        self._is_checked = True
        return bool(self._old)

    def _delivered_number(self, message):
        """The number of the old connector's value that this one is, or None."""
        first = 0 if self._is_stamped(message) else self._sure
        for number, old in self._old:
            if number >= first and old.data == message.data and old.little == message.little:
                return number
        return None

    def _check(self, message):
        """Notice values that neither connector has brought: the old one has brought some that the new one
        should have, too, but the first of the new one is later. (One of them may have been sent before the
        new connector was made.)
        """
        if not self._is_checked and self._number > self._sure + 1 and self._is_stamped(message):
            self.gap = self._last.received, message.received
        self._is_checked = True

    def _pass(self, message):
        self._last = message
        self._deliver(message)
