"""What carries the data of a connector: out ports send or hand out, in ports take. Nobody who is slow or
hangs delays others.
"""

import collections

from rtshell_lite import errors, notes
from rtshell_lite.corba import orb, servants
from rtshell_lite.net import loop

MOST = 10000  # values that wait for a slow reader
MOST_OCTETS = 64 << 20
LENGTH = 8  # of a buffer, unless the connector says otherwise
BLOCK = 1.0  # seconds that a fetch waits by default
_PUSH = {"corba_cdr": ("OpenRTM.InPortCdr", "put"), "data_service": ("RTC.DataPushService", "push")}


class Carrier:
    """One connector of a data port; `given` are its properties as they come."""

    def __init__(self, port, interface, little, given):
        self.port = port
        self.interface = interface
        self.little = little
        self.given = given
        self.served = None

    def published(self):
        """(name, value) pairs that the other end needs."""
        return ()

    def join(self, properties):
        """Use what the other end has published. Raises errors.Error."""

    def write(self, data):
        """Send a value."""

    async def finish(self):
        """Send no more values, and wait until the far end has taken the one under way: a C++ component whose
        connector goes meanwhile ends.
        """

    def is_busy(self):
        """Whether values wait to be sent."""
        return False

    def close(self):
        if self.served is not None:
            self.served.withdraw()

    def _publish(self, servant, side):
        """Serve an object for the other end: the pair of properties with its reference."""
        servant.withdraw = orb.publish(servant, self.port.reference.address.host)
        self.served = servant
        return [(f"dataport.{self.interface}.{side}_ior", servant.reference.text())]

    def _of_side(self, name, default):
        """A property of the buffer of this side, or of both."""
        side = self.given.get(f"dataport.outport.{name}")
        return side or self.given.get(f"dataport.{name}") or default


class Receiver(Carrier):
    """An in port's end of push: it takes all that comes, and hands it to the port."""

    def published(self):
        servant = servants.RECEIVERS[self.interface](
            lambda received, data: self.port.take(data, self.little), lambda: False
        )
        return self._publish(servant, "inport")


class Idle(Carrier):
    """An in port's end of pull: it fetches nothing."""


class Sender(Carrier):
    """An out port's end of push. Values wait for a reader that is slower, all of them with `flush` and the
    policies `all` and `fifo`; else the newest. One that does not answer is disconnected, as real out ports
    do.
    """

    def __init__(self, port, interface, little, given):
        super().__init__(port, interface, little, given)
        kind = given.get("dataport.subscription_type", "flush").lower()
        policy = self._of_side("publisher.push_policy", "new")
        self.is_newest = kind != "flush" and policy == "new"
        self.pause = _period(given) if kind == "periodic" else 0.0
        self.every = 1
        if policy == "skip":
            self.every += _number(self._of_side("publisher.skip_count", "0"), 0)
        self.waiting = collections.deque()
        self.octets = 0
        self.dropped = 0
        self.count = 0
        self.bell = loop.Bell()
        self.task = None
        self.far = self.operation = None
        self.is_sending = False
        self.is_ending = False
        self.under_way = loop.Wait()  # over while the far end has no value to take
        self.under_way.done()

    def join(self, properties):
        interface, self.operation = _PUSH[self.interface]
        where = self.port.name
        ior = properties.get(f"dataport.{self.interface}.inport_ior", "")
        self.far = orb.narrow(orb.from_text(where, ior), interface)
        self.task = self.port.component.tasks.start(self._send())

    def write(self, data):
        self.count += 1
        if self.is_ending or self.count % self.every:
            return
        if self.is_newest:
            self.waiting.clear()
            self.octets = 0
        self.waiting.append(data)
        self.octets += len(data)
        if len(self.waiting) > MOST or self.octets > MOST_OCTETS and len(self.waiting) > 1:
            self.octets -= len(self.waiting.popleft())
            self.dropped += 1
        self.bell.ring()

    def close(self):
        if self.dropped:
            notes.fail(f"{self.port.name}: {self.dropped} values dropped: a reader was too slow")
            self.dropped = 0
        if self.task is not None:
            self.task.cancel()

    async def finish(self):
        self.is_ending = True
        self.waiting.clear()
        await self.under_way

    def is_busy(self):
        return bool(self.waiting) or self.is_sending

    async def _send(self):
        while True:
            self.is_sending = False
            await self.bell.wait()
            while self.waiting:
                self.is_sending = True
                data = self.waiting.popleft()
                self.octets -= len(data)
                if not await self._put(data):
                    return
                if self.pause:
                    await loop.sleep(self.pause)

    async def _put(self, data):
        """Send a value; False where the far end is gone, which ends the connector."""
        self.under_way = loop.Wait()
        try:
            await orb.call(self.port.name, self.far, self.operation, data)
            return True
        except errors.Refused:
            return True
        except errors.Error:
            pass
        finally:
            self.under_way.done()
        self.waiting.clear()
        leaving = self.port.lost(self)
        if leaving is not None:
            await loop.finish(leaving)
        return False


class Provider(Carrier):
    """An out port's end of pull: a buffer from which others fetch."""

    def __init__(self, port, interface, little, given):
        super().__init__(port, interface, little, given)
        self.buffer = collections.deque(maxlen=max(1, _number(self._of_side("buffer.length", ""), LENGTH)))
        self.policy = self._of_side("buffer.read.empty_policy", "readback")
        self.last = None
        self.news = []  # Waits of those who wait for a value

    def published(self):
        return self._publish(_PROVIDERS[self.interface](self), "outport")

    def write(self, data):
        self.buffer.append(data)
        for wait in self.news:
            wait.done()
        self.news = []

    async def fetch(self):
        """(name of the status, data)"""
        if not self.buffer and self.policy == "block":
            await self._news()
        if self.buffer:
            self.last = self.buffer.popleft()
        elif self.policy == "block":
            return "BUFFER_TIMEOUT", b""
        elif self.last is None or self.policy == "do_nothing":
            return "BUFFER_EMPTY", b""
        return "PORT_OK", self.last

    async def _news(self):
        """Wait for a value, or for as long as the connector says."""
        wait = loop.Wait()
        self.news.append(wait)
        timer = loop.current().call_later(_seconds(self._of_side("buffer.read.timeout", "")), wait.done)
        try:
            await wait
        finally:
            timer.cancel()
            if wait in self.news:  # no value has come
                self.news.remove(wait)


class OutPortCdr:
    """What in ports fetch from by corba_cdr."""

    interface = "OpenRTM.OutPortCdr"
    reference = withdraw = None

    def __init__(self, provider):
        self._provider = provider

    async def get(self):
        status, data = await self._provider.fetch()
        return orb.enumerator("OpenRTM.PortStatus", status), data


class DataPullService:
    """The same by data_service."""

    interface = "RTC.DataPullService"
    reference = withdraw = None

    def __init__(self, provider):
        self._provider = provider

    async def pull(self):
        status, data = await self._provider.fetch()
        return orb.enumerator("RTC.PortStatus", status), data


_PROVIDERS = {"corba_cdr": OutPortCdr, "data_service": DataPullService}


def _number(text, default):
    return int(text) if text.isdecimal() and len(text) < 7 else default


def _seconds(text):
    try:
        return min(max(float(text), 0.0), 60.0)
    except ValueError:
        return BLOCK


def _period(given):
    """Seconds between two values of a periodic connector; 0 where it names no rate."""
    rate = given.get("dataport.publisher.push_rate") or given.get("dataport.push_rate", "")
    try:
        return 1 / float(rate)
    except (ValueError, ZeroDivisionError):
        return 0.0
