"""The ends of a data connection: four classes, for push and pull."""
import collections

from . import carrier, values
from .idl import RTC, OpenRTM
from .properties import get

# interface type -> the word in the property names; shared memory borrows that of corba_cdr
KEYS = {"corba_cdr": "corba_cdr", "shared_memory": "corba_cdr", "data_service": "data_service",
        "csp_channel": "csp_channel"}
_GHOSTS = {"shared_memory": "IDL:OpenRTM/PortSharedMemory:1.0",
           "csp_channel": "IDL:openrtm.aist.go.jp/CSP/InPortCsp:1.0"}

_PUSH = {"corba_cdr": (OpenRTM.InPortCdr, "put"), "data_service": (RTC.DataPushService, "push")}
_PULL = {"corba_cdr": (OpenRTM.OutPortCdr, "get"), "data_service": (RTC.DataPullService, "pull")}


def operation(interface, reference, kinds):
    """The operation of the far end that carries data; None for interfaces that are not simulated."""
    if interface not in kinds:
        return None
    kind, name = kinds[interface]
    return getattr(reference._unchecked_narrow(kind), name)


def reference_any(reference):
    """An any with a reference, for properties of connectors."""
    return carrier.Any(carrier.REFERENCE, reference)


class Transport:
    """One connection of one port."""

    def __init__(self, port, profile, interface):
        self.port = port
        self.process = port.process
        self.interface = interface
        self.little = values.little_endian(profile)
        self.servant = None

    def serve(self, servants):
        """Make the object that the far end calls; for interfaces that are not simulated, only a reference."""
        if self.interface in _GHOSTS:
            self.reference = self.process.ghost(_GHOSTS[self.interface])
            return
        self.servant = servants[self.interface](self)
        self.reference = self.process.serve(self.servant, self.port.component.instance_name)

    def close(self):
        if self.servant:
            self.process.withdraw(self.servant)

    def write(self, data):
        return True

    def fetch(self):
        pass


class Receiver(Transport):
    """An InPort's end of push: an object with put()."""

    def __init__(self, port, profile, interface):
        super().__init__(port, profile, interface)
        self.serve({"corba_cdr": InPortCdr, "data_service": DataPushService})

    def answer(self, data):
        """Take a value; the name of the status to return."""
        if self.port.status != "PORT_OK":
            return self.port.status
        try:
            return self.port.put(data, self.little)
        except carrier.Garbled:
            if self.port.flavour.short_put == "MARSHAL":
                raise
        return "PORT_OK"


class InPortCdr(carrier.skeleton("OpenRTM.InPortCdr")):
    def __init__(self, receiver):
        self.receiver = receiver

    def put(self, data):
        return getattr(OpenRTM, self.receiver.answer(data))


class DataPushService(carrier.skeleton("RTC.DataPushService")):
    def __init__(self, receiver):
        self.receiver = receiver

    def push(self, data):
        return getattr(RTC, self.receiver.answer(data))


HOLDS = 0.001  # seconds before a call for which a publisher has its far end's reference in use


class Sender(Transport):
    """An OutPort's end of push: calls put() at once, or in a thread of its own upon news or at a rate.

    That thread (PublisherNew of C++) uses the reference of the far end from HOLDS seconds before it calls
    until it has sent all. Deleting the connector meanwhile releases the reference: a near miss. Of some
    hundred, a process has ended of one (SIGSEGV in omniObjRef::_invoke); a component of Python goes to Error
    (PublisherNew._buffer is None).
    """

    def __init__(self, port, profile, interface, reference, mode, pause):
        super().__init__(port, profile, interface)
        self.little = self.little or not port.flavour.obeys_big
        self.put = operation(interface, reference, _PUSH)
        self.mode = mode
        self.policy = get(profile.properties, "dataport.publisher.push_policy", "new")
        self.news = carrier.Condition()
        self.waiting = collections.deque(maxlen=int(get(profile.properties, "dataport.buffer.length", "8")))
        self.lost = self.closed = self.in_use = False
        if mode != "flush":
            self.process.thread(self._publish, pause)

    def write(self, data):
        if self.lost:
            return False
        if self.mode == "flush":
            return self._send(data)
        with self.news:
            self.waiting.append(data)
            self.news.notify_all()
        return True

    def close(self):
        if self.in_use:
            self.process.near_misses += 1
        with self.news:
            self.closed = True
            self.news.notify_all()

    def _send(self, data):
        try:
            if self.put:
                self.put(data)
        except carrier.SystemException:
            self.lost = True
        return not self.lost

    def _publish(self, pause):
        """Send what is waiting (by default only the newest of it), then pause."""
        while True:
            with self.news:
                self.news.wait_for(lambda: self.waiting or self.closed)
                if self.closed:
                    return
                batch = list(self.waiting) if self.policy in ("all", "fifo") else [self.waiting.pop()]
                self.waiting.clear()
            self.in_use = True
            carrier.sleep(HOLDS)
            sent = all(self._send(data) for data in batch)
            self.in_use = False
            if not sent:
                return
            carrier.sleep(pause)


ANSWERING = 0.02  # seconds after its answer for which a get() counts as still being served


class Provider(Transport):
    """An OutPort's end of pull: an object with get(), and a ring buffer.

    C++ deletes the object with the connector, even while it serves a caller; omniORB then ends the process.
    The InPort of a component has been disconnected before, and fetches no more; only a tool, alone at its
    connector, can do that.
    """

    def __init__(self, port, profile, interface):
        super().__init__(port, profile, interface)
        self.buffer = collections.deque(maxlen=int(get(profile.properties, "dataport.buffer.length", "8")))
        self.policy = get(profile.properties, "dataport.buffer.read.empty_policy", "readback")
        self.limit = float(get(profile.properties, "dataport.buffer.read.timeout", "1.0"))
        self.news = carrier.Condition()
        self.last = None
        self.serving = 0
        self.answered = -ANSWERING
        self.fragile = port.flavour.busy_get == "die" and len(profile.ports) == 1
        self.serve({"corba_cdr": OutPortCdr, "data_service": DataPullService})

    def write(self, data):
        with self.news:
            self.buffer.append(data)
            self.news.notify_all()
        return True

    def get(self):
        """(status name, data)"""
        self.serving += 1
        try:
            return self._get()
        finally:
            self.serving -= 1
            self.answered = carrier.now()

    def close(self):
        if self.fragile and (self.serving or carrier.now() < self.answered + ANSWERING):
            self.process.die()
        super().close()

    def _get(self):
        with self.news:
            if not self.buffer and self.policy == "block" and self.port.flavour.empty_get != "BAD_PARAM":
                if not self.news.wait_for(lambda: self.buffer, self.limit):
                    return "BUFFER_TIMEOUT", b""
            if self.buffer:
                self.last = self.buffer.popleft()
                return "PORT_OK", self.last
        if self.port.flavour.empty_get == "BAD_PARAM":
            raise carrier.failure("BAD_PARAM", 0x41540000)
        if self.last is None or self.policy == "do_nothing":
            return "BUFFER_EMPTY", b""
        return "PORT_OK", self.last


class OutPortCdr(carrier.skeleton("OpenRTM.OutPortCdr")):
    def __init__(self, provider):
        self.provider = provider

    def get(self):
        status, data = self.provider.get()
        return getattr(OpenRTM, status), data


class DataPullService(carrier.skeleton("RTC.DataPullService")):
    def __init__(self, provider):
        self.provider = provider

    def pull(self):
        status, data = self.provider.get()
        return getattr(RTC, status), data


class Fetcher(Transport):
    """An InPort's end of pull: calls get() whenever the component reads."""

    def __init__(self, port, profile, interface, reference):
        super().__init__(port, profile, interface)
        self.get = operation(interface, reference, _PULL)

    def fetch(self):
        if not self.get:
            return
        try:
            status, data = self.get()
        except carrier.SystemException:
            return
        if str(status) == "PORT_OK":
            self.port.take(self.port.decode(data, self.little))
