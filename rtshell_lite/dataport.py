"""Data from and to ports of components, through connectors of one port (protocol.md 6.6: no port of ours is seen by anyone).

    with dataport.Reader(port, deliver) as reader: …       `deliver(Message)` for each value, from a thread of the ORB
    with dataport.Writer(port) as writer: writer.put(data, writer.little)
    with dataport.Opened([reader, other]) as opened: …     several at once, in parallel

The connector is removed however the `with` statement ends. Commands call cli.unwind_when_ended() before.
"""
import collections
import sys
import threading
import time

from rtshell_lite import component, datatypes, errors, interrupts, orb, ports, rpc
from rtshell_lite.text import printable, to_wire

# One value: when it came, in nanoseconds since 1970; CDR bytes without any header (protocol.md 7.1); their byte order.
Message = collections.namedtuple("Message", "received data little")

INTERFACES = ("corba_cdr", "data_service")  # what can be used, the first preferred
QUEUE = 4096  # values the port may queue between two looks while writes are counted
SMALL_BUFFER, LARGE_BUFFER = 256, 16  # values the port may queue for a reader: of fixed size, of any size
POLL = 0.02  # seconds between two looks at a queue
LOOK = 1.0  # seconds between two looks whether a port that sends nothing is still there
SWITCH = 0.0005  # seconds that a component may have to wait for Python's lock; with Python's own 0.005, 290 MB/s came, not 430
GRACE = 0.2  # seconds, besides the timeout, that an interrupted command waits for connectors that are just being made


# ---- one connector --------------------------------------------------------------------------------------------

class Connection:
    """A connector of one port. `failure` is None, or the errors.Error that tells what is wrong with it now."""

    kind = side = dataflow = None  # the port's type; the word for its object in properties; push or pull

    def __init__(self, port, name, properties):
        self.port, self.where, self.name = port, ports.label(port), name
        self.endpoint = orb.endpoint(port.ref)
        self.given = dict(properties or {})
        self.connector = self.failure = None
        self.little = True  # the byte order agreed upon
        self.begun = False
        self.settled, self.closing = threading.Event(), threading.Event()
        self.lock = threading.Lock()
        if port.type != self.kind:
            raise errors.WrongKind(self.where, self.kind, port.type)
        self.interface = self._interface()

    def __enter__(self):
        self.alone = Opened([self])
        self.alone.__enter__()
        if self.failure:
            self.alone.__exit__()
            raise self.failure
        return self

    def __exit__(self, *_):
        self.alone.__exit__()

    def open(self):
        """Make the connector; runs in a lane of the port's process. Raises errors.Error."""
        self.begun = True
        try:
            if not self.closing.is_set():
                self._open()
        finally:
            if self.closing.is_set():  # interrupted meanwhile
                self.close()
            self.settled.set()

    def _open(self):
        asked = {"dataport.dataflow_type": self.dataflow, "dataport.interface_type": self.interface,
                 "dataport.data_type": self.port.properties.get("dataport.data_type", ""),
                 "dataport.serializer.cdr.endian": "little,big"}
        asked.update(self.wishes())
        asked.update(self.given)
        for key in ("dataport.dataflow_type", "dataport.subscription_type"):
            offer = ports.offer_without(self.port, key, asked[key])
            if offer is not None:
                raise errors.Refused(self.where, "has no %s %s (it has: %s)" % (
                    key.split(".")[1], printable(asked[key]), offer))
        self.connector = ports.connect_alone(self.port, self.name, asked)
        self.agreed = dict(self.connector.properties)
        self.little = _little(self.agreed) or self.always_little()

    def close(self):
        """Remove the connector; runs in a lane. What goes wrong is the `failure`, except that the port is gone anyway."""
        self.closing.set()
        with self.lock:
            connector, self.connector = self.connector, None
        try:
            if connector:
                ports.disconnect(self.port, connector)
        except (errors.Silent, errors.Refused) as e:
            self.failure = self.failure or e
        except errors.Unreachable:
            pass  # and its connectors with it
        self.release()

    def look(self):
        """See whether the port is there and has the connector; runs in a lane. Raises errors.Error."""
        connector = self.connector
        if not connector:
            return
        try:
            found = component.once_more(lambda: orb.ask(
                self.where, self.port.ref, "get_connector_profile", to_wire(connector.id)))
        except (errors.Gone, errors.ConnectionRefused) as e:
            raise errors.Unreachable(self.where, "the component %s" % (
                "has ended" if isinstance(e, errors.Gone) else "is gone, and its process too"))
        if not found.connector_id and not self.closing.is_set():
            raise errors.Unreachable(self.where, self.lost())

    def lost(self):
        """The words for a connector that someone else has removed."""
        return "the connection has been removed"

    def due(self):
        """Whether it is time to look at a connection on which nothing happens."""
        return False

    def wishes(self):
        """Properties to ask for, besides the usual ones."""
        return {}

    def release(self):
        """Give up what belongs to the connector."""

    def always_little(self):
        """Whether the byte order agreed upon is not kept: the values are little-endian all the same."""
        return False

    def remote(self, kinds):
        """The object that the port has published for the connector. Raises Refused when it has not."""
        ior = self.agreed.get("dataport.%s.%s_ior" % (self.interface, self.side))
        if not ior:
            raise errors.Refused(self.where, "tells no provider for %s" % self.dataflow)
        return orb.narrow(orb.from_text(self.where, ior), kinds[self.interface])

    def _interface(self):
        offered = [word.strip() for word in self.port.properties.get("dataport.interface_type", "").split(",")]
        usable = [self.given["dataport.interface_type"]] if "dataport.interface_type" in self.given else INTERFACES
        for interface in usable:
            if interface in INTERFACES and (interface in offered or {"any", ""} & {word.lower() for word in offered}):
                return interface
        raise errors.Refused(self.where, "offers no %s (it has: %s)" % (" and no ".join(usable), printable(", ".join(offered))))


def _little(properties):
    """The byte order that the properties of a connector tell: the first usable word decides (protocol.md 7.2)."""
    words = [word.strip() for word in properties.get("dataport.serializer.cdr.endian", "").split(",")]
    return next((word == "little" for word in words if word in ("little", "big")), True)


class Opened:
    """Connections, opened and closed together; those that fail spoil no others. A look now and then finds dead ports.

    After `__enter__` each has its connector or its `failure`, which `live` leaves out; after `__exit__`, none has one.
    """

    def __init__(self, connections):
        self.connections = list(connections)
        self.ended, self.closed = threading.Event(), False

    def __enter__(self):
        complete = False
        try:
            self._in_lanes("open")
            rpc.start(self._watch)
            complete = True
            return self
        finally:
            if not complete:  # Ctrl-C, SIGTERM
                with interrupts.held():
                    self._abandon()

    def __exit__(self, *_):
        try:
            self._close()
        finally:
            if not self.closed:  # a signal has struck before anything was held
                self._close()

    def _close(self):
        with interrupts.held():
            self.ended.set()
            self._in_lanes("close")
            self.closed = True

    def live(self):
        """The connections that may still bring or take something."""
        return [each for each in self.connections
                if each.failure is None or each.connector and isinstance(each.failure, errors.Silent)]

    def _in_lanes(self, step, connections=None):
        connections = self.connections if connections is None else connections
        jobs = [rpc.Job(each.endpoint, each.where, getattr(each, step)) for each in connections]
        for each, result in zip(connections, rpc.gather(jobs)):
            if step == "look" and each.closing.is_set():
                continue  # what it was asked is gone by our own doing
            if isinstance(result, errors.Error):
                each.failure = each.failure or result
            elif isinstance(each.failure, errors.Silent) and step == "look":
                each.failure = None

    def _abandon(self):
        """Connectors that are just being made are waited for, as long as they may take, and removed."""
        self.ended.set()
        for each in self.connections:
            each.closing.set()
        end = time.monotonic() + rpc.timeout + GRACE
        for each in [each for each in self.connections if each.begun]:
            each.settled.wait(max(0, end - time.monotonic()))
        self._in_lanes("close", [each for each in self.connections if each.connector])

    def _watch(self):
        while not self.ended.wait(LOOK):
            self._in_lanes("look", [each for each in self.live() if each.due()])


# ---- reading --------------------------------------------------------------------------------------------------

class Reader(Connection):
    """A connector from a DataOutPort that calls deliver(Message) for each value, from a thread of its own.

    dataflow: "push" (the component calls us), "pull" (we ask, POLL seconds apart when there was nothing; for peers that
    cannot reach us), None for push where the port offers it. subscription, of push: new, flush or periodic; None takes new,
    in which values wait in the port's buffer and no slow reader delays the component. `properties`, a dict, goes into the
    connector and wins. `name` is the connector's.
    """

    kind, side = "DataOutPort", "outport"

    def __init__(self, port, deliver, dataflow=None, subscription=None, properties=None, name="rtshell_lite"):
        Connection.__init__(self, port, name, properties)
        self.deliver = deliver
        offer = ports.offer_without(port, "dataport.dataflow_type", "push")
        self.dataflow = self.given.get("dataport.dataflow_type") or dataflow or ("pull" if offer else "push")
        self.subscription = subscription
        self.count = self.seen = 0  # values so far, and at the last look
        self.served = None
        self.early = []  # values that come before the byte order is known for certain

    def wishes(self):
        common = {"dataport.buffer.length": str(self._buffer())}
        if self.dataflow == "pull":
            return dict(common, **{"dataport.subscription_type": "new", "dataport.buffer.read.empty_policy": "do_nothing"})
        from rtshell_lite import servants
        sys.setswitchinterval(SWITCH)
        self.served = servants.Served(servants.RECEIVERS[self.interface](self._take))
        subscription = self.subscription or ports.connection_properties([self.port], {})["dataport.subscription_type"]
        return dict(common, **{
            "dataport.subscription_type": subscription or "new", "dataport.publisher.push_policy": "all",
            "dataport.%s.inport_ior" % self.interface: self.served.ior(self.endpoint)})

    def _buffer(self):
        """A port keeps as many values as its buffer is long, so only small ones may wait in great number."""
        return SMALL_BUFFER if datatypes.has_fixed_size(self.port) else LARGE_BUFFER

    def _open(self):
        try:
            Connection._open(self)
        except errors.Error:
            self.release()
            raise
        with self.lock:
            for received, data in self.early:
                self.deliver(Message(received, data, self.little))
            self.early = None
        if self.dataflow == "pull":
            self.get = fetcher(self)
            rpc.start(self._poll)

    def _take(self, received, data):
        self.count += 1
        if self.early is not None:
            with self.lock:
                if self.early is not None:
                    self.early.append((received, data))
                    return
        if not self.closing.is_set():
            self.deliver(Message(received, data, self.little))

    def _poll(self):
        rpc.become_lane(self.endpoint)
        while not self.closing.is_set():
            try:
                data = self.get()
            except errors.Silent as e:
                self.failure = e
                continue
            except errors.Error as e:
                self.failure = None if self.closing.is_set() else e
                return
            self.failure = None
            if data is None:
                self.closing.wait(POLL)
            else:
                self._take(int(time.time() * 1e9), data)

    def due(self):
        seen, self.seen = self.seen, self.count
        if seen != self.count:
            self.failure = None  # it was silent, but values have come
        return self.dataflow != "pull" and seen == self.count

    def lost(self):
        if self.dataflow == "push" and not self.count:
            return ("the connection has been removed; if the component did that, it cannot reach this machine (pull may do), "
                    "or its values exceed its ORB's giopMaxMsgSize")
        return Connection.lost(self)

    def release(self):
        with self.lock:  # who opens and who closes may both do it
            served, self.served = self.served, None
        if served:
            served.withdraw()

    def always_little(self):
        """C++ from 1.2 on, and RtORB, push little-endian whatever was agreed upon (protocol.md 7.2 and 19)."""
        if self.dataflow == "pull":
            return False
        properties = dict(component.profile(self.port.node).properties)
        old = properties.get("openrtm.version", "").startswith(("1.0", "1.1"))
        return properties.get("language", "").startswith("C") and not old


def fetcher(reader):
    """A function that fetches the oldest value of a pull connection as bytes, None when there is none now."""
    from rtshell_lite.idl_stubs.dataport import OpenRTM, RTC
    source = reader.remote({"corba_cdr": OpenRTM.OutPortCdr, "data_service": RTC.DataPullService})
    operation = "get" if reader.interface == "corba_cdr" else "pull"

    def get():
        try:
            status, data = orb.ask(reader.where, source, operation)
        except errors.Gone:
            raise errors.Unreachable(reader.where, reader.lost())
        except errors.Refused as e:
            if e.name == "BAD_PARAM":  # what Python components answer when nothing was written
                return None
            raise
        if str(status) in ("UNKNOWN_ERROR", "PORT_ERROR"):
            raise errors.Unreachable(reader.where, reader.lost())
        return data if str(status) == "PORT_OK" else None
    return get


def count_writes(port, seconds):
    """How many values a DataOutPort is given within `seconds`: (count, seconds between the first and the last look)."""
    with Reader(port, lambda message: None, "pull", properties={"dataport.buffer.length": str(QUEUE)}) as reader:
        time.sleep(2 * POLL)  # values from before may be there
        before, start = reader.count, time.monotonic()
        time.sleep(seconds)
        if reader.failure:
            raise reader.failure
        return reader.count - before, time.monotonic() - start


# ---- writing --------------------------------------------------------------------------------------------------

REFUSALS = {"BUFFER_FULL": "its buffer is full", "BUFFER_TIMEOUT": "its buffer stayed full",
            "PORT_ERROR": "it reports an error of the port", "UNKNOWN_ERROR": "it reports an unknown error"}


class Writer(Connection):
    """A connector to a DataInPort; `put` gives it values. `little` is the byte order that it expects."""

    kind, side, dataflow = "DataInPort", "inport", "push"

    def __init__(self, port, properties=None, name="rtshell_lite"):
        Connection.__init__(self, port, name, properties)

    def wishes(self):
        return {"dataport.subscription_type": "flush"}

    def _open(self):
        Connection._open(self)
        from rtshell_lite.idl_stubs.dataport import OpenRTM, RTC
        self.sink = self.remote({"corba_cdr": OpenRTM.InPortCdr, "data_service": RTC.DataPushService})
        self.operation = "put" if self.interface == "corba_cdr" else "push"

    def due(self):
        return isinstance(self.failure, errors.Silent)

    def put(self, data, little=True):
        """Send CDR bytes. Raises Refused (buffer full, bad data, wrong byte order), Unreachable, Silent."""
        if little != self.little:
            raise errors.Refused(self.where, "wants %s-endian data" % ("little" if self.little else "big"))
        try:
            status = orb.ask(self.where, self.sink, self.operation, data)
        except errors.Gone:
            raise errors.Unreachable(self.where, self.lost())
        if str(status) != "PORT_OK":
            raise errors.Refused(self.where, "%s (%s)" % (REFUSALS.get(str(status), "it did not take the value"), status),
                                 name=str(status))
