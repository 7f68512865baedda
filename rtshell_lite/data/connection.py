"""One connector of a port of ours, which nobody sees: made, watched and removed (protocol.md 6.6).

    with connection.Opened([reader, writer]) as opened: …     several at once, in parallel

The connector is removed however the `with` statement ends. Commands call cli.unwind_when_ended() before.
"""
import threading
import time

from rtshell_lite import cli, errors, interrupts
from rtshell_lite.corba import lanes, orb, stubs
from rtshell_lite.robot import component, connectors, ports
from rtshell_lite.text import printable, shell_word, to_wire

INTERFACES = ("corba_cdr", "data_service")  # what can be used, the first preferred
LOOK = 1.0  # seconds between two looks whether a port that sends nothing is still there
GRACE = 0.2  # seconds, besides the timeout, that an interrupted command waits for connectors that are just being made


class Connection:
    """A connector of one port. `failure` is None, or the errors.Error that says what is wrong with it now."""

    kind = side = dataflow = None  # the port's type; the word for its object in properties; push or pull
    flows = ()  # the data flows that can be used

    def __init__(self, port, name, properties):
        self.port, self.where, self.name = port, ports.label(port), name
        self.endpoint = orb.endpoint(port.ref)
        self.given = dict(properties or {})
        self.connector = self.failure = self.left = None  # left: a connector that could not be removed
        self.remark = None  # what the user is to know, once, though nothing fails
        self.little = True  # the byte order agreed upon
        self.begun = False
        self.settled, self.closing = threading.Event(), threading.Event()
        self.lock, self.changing = threading.Lock(), threading.Lock()  # the second while the connector is removed or replaced
        check(self.given, self.flows)
        if port.type != self.kind:
            raise errors.WrongKind(self.where, self.kind, port.type)
        self.interface = self._interface()

    def __enter__(self):
        self.opened = Opened([self])
        self.opened.__enter__()
        if self.failure:
            self.opened.__exit__()
            raise self.failure
        return self

    def __exit__(self, *_):
        self.opened.__exit__()

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
        asked = self.asked()
        for key in ("dataport.dataflow_type", "dataport.subscription_type"):
            offer = ports.offer_without(self.port, key, asked[key])
            if offer is not None:
                raise errors.Refused(self.where, "has no %s %s (it has: %s)" % (
                    key.split(".")[1], printable(asked[key]), offer))
        self.connector = connectors.connect_alone(self.port, self.name, asked)
        self.agreed = dict(self.connector.properties)
        self.little = _little(self.agreed) or self.always_little()

    def asked(self):
        """The properties to connect with, a dict."""
        asked = {"dataport.dataflow_type": self.dataflow, "dataport.interface_type": self.interface,
                 "dataport.data_type": self.port.properties.get("dataport.data_type", ""),
                 "dataport.serializer.cdr.endian": "little,big"}
        asked.update(self.wishes())
        asked.update(self.given)
        return asked

    def close(self):
        """Remove the connector; runs in a lane. What goes wrong is the `failure`, except that the port is gone anyway."""
        self.closing.set()
        with self.changing:
            self._close()

    def _close(self):
        with self.lock:
            connector, self.connector = self.connector, None
        try:
            if connector and not self.is_at_rest():
                self.left = connector
            elif connector:
                connectors.disconnect(self.port, connector)
        except (errors.Silent, errors.Refused) as e:
            self.failure = self.failure or e
        except errors.Unreachable:
            pass  # and its connectors with it
        self.release()

    def report_left(self):
        """Print that the connector is still there, if it is, and what removes it."""
        if self.left:
            cli.complain("%s: connection %s stays, because a call is unanswered and to remove it now could end the component; "
                         "when it answers again: rtdis -i %s %s" % (
                             self.where, printable(self.left.id), shell_word(self.left.id), shell_word(self.where)))

    def stop(self):
        """The end is near: begin what `is_at_rest` waits for."""

    def is_at_rest(self):
        """Whether the connector can be removed without harm; may wait until it can."""
        return True

    def look(self):
        """See whether the port is there and has the connector; runs in a lane. Raises errors.Error."""
        connector = self.connector
        if not connector:
            return
        try:
            found = component.once_more(lambda: orb.call(
                self.where, self.port.ref, "get_connector_profile", to_wire(connector.id)))
        except (errors.Gone, errors.ConnectionRefused) as e:
            raise self.component_ended(e)
        if not found.connector_id and not self.closing.is_set():
            raise errors.Unreachable(self.where, self.lost())

    def component_ended(self, e):
        """The error for a component that is found to be Gone, or ConnectionRefused."""
        return errors.Unreachable(self.where, "the component %s" % (
            "has ended" if isinstance(e, errors.Gone) else "is gone, and its process too"))

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
        """The object that the port has published for the connector; `kinds`: the name of its stub class, by interface type.

        Raises Refused when it has published none.
        """
        ior = self.agreed.get(f"dataport.{self.interface}.{self.side}_ior")
        if not ior:
            raise errors.Refused(self.where, f"publishes no provider for {self.dataflow}")
        return orb.narrow(orb.from_text(self.where, ior), stubs.named(kinds[self.interface]))

    def _interface(self):
        offered = [word.strip() for word in self.port.properties.get("dataport.interface_type", "").split(",")]
        usable = [self.given["dataport.interface_type"]] if "dataport.interface_type" in self.given else INTERFACES
        for interface in usable:
            if interface in offered or {"any", ""} & {word.lower() for word in offered}:
                return interface
        raise errors.Refused(self.where, f"offers no {' and no '.join(usable)} (it has: {printable(', '.join(offered))})")


def check(given, flows):
    """Refuse properties of a connection in which no port of ours can take part, before any component is asked. Raises Usage.

    Real ports are offered nothing that is not known to work: some list `duplex` and keep a ghost of a connection for ever.
    """
    for key, usable in (("dataport.dataflow_type", flows), ("dataport.interface_type", INTERFACES)):
        if key in given and given[key].lower() not in usable:
            raise errors.Usage("%s=%s: this command can only take part in connections with %s" % (
                key, printable(given[key]), " or ".join(usable)))


def _little(properties):
    """The byte order in the properties of a connector: the first usable word decides (protocol.md 7.2)."""
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
            lanes.start(self._watch)
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
            for each in self.connections:
                each.stop()
            self._in_lanes("close")
            self.closed = True
            for each in self.connections:
                each.report_left()

    def live(self):
        """The connections that may still bring or take something."""
        return [each for each in self.connections
                if each.failure is None or each.connector and isinstance(each.failure, errors.Silent)]

    def _in_lanes(self, step, connections=None):
        connections = self.connections if connections is None else connections
        results = lanes.each(connections, lambda each: getattr(each, step)())
        for each, result in zip(connections, results):
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
        end = time.monotonic() + lanes.session.timeout + GRACE
        for each in [each for each in self.connections if each.begun]:
            each.settled.wait(max(0, end - time.monotonic()))
        self._in_lanes("close", [each for each in self.connections if each.connector])
        for each in self.connections:
            each.report_left()

    def _watch(self):
        while not self.ended.wait(LOOK):
            self._in_lanes("look", [each for each in self.live() if each.due()])
