"""Connectors between a port and this process: made, watched and removed.

    with connection.Opened([reader, writer]) as opened: …     in parallel

However the `with` statement ends, the connectors are removed. Commands call cli.unwind_when_ended() before it.
"""
import _signal  # see start.py
import os
import sys
import threading
import time

from rtshell_lite import cli, errors, interrupts
from rtshell_lite.corba import lanes, orb
from rtshell_lite.robot import component, connectors, ports
from rtshell_lite.text import printable, shell_word, to_wire

INTERFACES = ("corba_cdr", "data_service")  # usable interface types; the first is preferred
LOOK = 1.0  # seconds between two looks whether a silent port still exists
GRACE = 0.2  # seconds beyond the timeout that an interrupted command waits for connectors that are being made

# That a connector was not removed, why, and when to try again.
BUSY = "stays, because a call is unanswered and to remove it now could end the component; when it answers again"
SILENT = "may stay, because the component does not answer; when it does again"
REFUSED = "may stay, because the component refused to remove it; to try again"


class Connection:
    """A connector of a port. `failure` is the errors.Error that says what is wrong with it now, or None."""

    kind = side = dataflow = None  # the port's type; the name of its object in properties; push or pull
    flows = ()  # usable data flows

    def __init__(self, port, name, properties):
        self.port, self.where, self.name = port, ports.label(port), name
        self.endpoint = orb.endpoint(port.ref)
        self.given = dict(properties or {})
        self.connector = self.failure = None
        self.agreed = {}  # the properties of the connector, as the port returned them
        self.left = None  # (a connector that was not removed, what to say of it)
        self.told = None  # a failure that has been reported as the connection was closed
        self.remark = None  # a note for the user, printed once
        self.little = True  # the byte order agreed upon
        self.begun = False
        self.settled, self.closing = threading.Event(), threading.Event()
        self.lock, self.changing = threading.Lock(), threading.Lock()  # `changing`: the connector is being removed or replaced
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

    def __exit__(self, *exception):
        self.opened.__exit__(*exception)

    def open(self):
        """Make the connector. Raises errors.Error."""
        self.begun = True
        try:
            if not self.closing.is_set():
                self._open()
        except errors.Error as e:
            self.failure = e  # here, as nobody may be waiting for it any more
            raise
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
        """The dict of properties to connect with."""
        asked = {"dataport.dataflow_type": self.dataflow, "dataport.interface_type": self.interface,
                 "dataport.data_type": self.port.properties.get("dataport.data_type", ""),
                 "dataport.serializer.cdr.endian": "little,big"}
        asked.update(self.wishes())
        asked.update(self.given)
        return asked

    def close(self):
        """Remove the connector. Sets `failure` and `left` when that fails, unless the port is gone."""
        self.closing.set()
        with self.changing:
            self._close()

    def _close(self):
        with self.lock:
            connector, self.connector = self.connector, None
        if connector:
            self.left = connector, BUSY
            self.leave(connector)
        self.release()

    def leave(self, connector):
        """Remove the connector, as soon as that does no harm."""
        if self.is_at_rest():
            self._remove(connector)

    def step_aside(self):
        """Remove the connector for a while."""
        with self.changing:
            if self.closing.is_set() or not self.connector:
                return
            with self.lock:
                connector, self.connector = self.connector, None
            self.left = connector, BUSY
            self.leave(connector)
            self.release()

    def come_back(self):
        """Make the connector again that step_aside() has removed. Raises errors.Error."""
        with self.changing:
            if self.closing.is_set() or self.connector or self.failure:
                return
            if self.left:
                raise errors.Unreachable(self.where, "a fetch is not answered")
            self.renew()
            self._open()

    def _remove(self, connector):
        self.left = connector, SILENT
        try:
            connectors.disconnect(self.port, connector)
            self.left = None
        except (errors.Gone, errors.ConnectionRefused):
            self.left = None  # the port is gone, and its connectors with it
        except errors.Unreachable as e:
            self.failure = self.failure or e
        except errors.Refused as e:
            self.failure, self.left = self.failure or e, (connector, REFUSED)

    def give_up(self):
        """Leave the connector: its process was found silent a moment ago, and not asked again."""
        self.closing.set()
        self.left, self.connector = (self.connector, SILENT), None
        self.release()

    def report(self, known, unwound):
        """Report a connector that could not be removed, and the command that removes it.

        If `unwound` by an exception, also report a failure other than the `known` one (text): nobody else may do that.
        """
        if unwound and self.failure and str(self.failure) != known:
            cli.complain(self.failure)
            self.told = self.failure
        if self.left:
            connector, what = self.left
            cli.complain("%s: connection %s %s: rtdis -i %s %s" % (
                self.where, printable(connector.id), what, shell_word(connector.id), shell_word(self.where)))

    def stop(self):
        """Prepare to close: begin what `is_at_rest` waits for."""

    def is_at_rest(self):
        """Whether the connector can be removed without harm; may wait until it can."""
        return True

    def look(self):
        """Check that the port exists and has the connector. Raises errors.Error."""
        connector = self.connector
        if connector and not self.is_there(connector) and not self.closing.is_set():
            raise errors.Unreachable(self.where, self.lost())

    def is_there(self, connector):
        """Whether the port has the connector. Raises errors.Error."""
        try:
            profile = component.once_more(lambda: orb.Call(
                self.where, self.port.ref, "get_connector_profile", to_wire(connector.id)))
        except (errors.Gone, errors.ConnectionRefused) as e:
            raise self.component_ended(e)
        return bool(profile.connector_id)

    def component_ended(self, e):
        """The error for a component that was Gone or ConnectionRefused."""
        return errors.Unreachable(self.where, "the component %s" % (
            "has ended" if isinstance(e, errors.Gone) else "is gone, and its process too"))

    def lost(self):
        """The message for a connector that someone else has removed."""
        return "the connection has been removed"

    def due(self):
        """Whether it is time for a look()."""
        return False

    def wishes(self):
        """More properties to ask for."""
        return {}

    def release(self):
        """Free what belonged to the connector."""

    def renew(self):
        """Prepare for another connector."""

    def always_little(self):
        """Whether values are little-endian whatever was agreed upon."""
        return False

    def remote(self, kinds):
        """The object that the port published for the connector; `kinds` names its stub class, by interface type.

        Raises Refused when there is none.
        """
        ior = self.agreed.get(f"dataport.{self.interface}.{self.side}_ior")
        if not ior:
            raise errors.Refused(self.where, f"publishes no provider for {self.dataflow}")
        return orb.narrow(orb.from_text(self.where, ior), kinds[self.interface])

    def _interface(self):
        offered = [word.strip() for word in self.port.properties.get("dataport.interface_type", "").split(",")]
        usable = [self.given["dataport.interface_type"]] if "dataport.interface_type" in self.given else INTERFACES
        for interface in usable:
            if interface in offered or {"any", ""} & {word.lower() for word in offered}:
                return interface
        raise errors.Refused(self.where, f"offers no {' and no '.join(usable)} (it has: {printable(', '.join(offered))})")


def check(given, flows):
    """Refuse properties that our end of a connection does not support, before any component is asked. Raises Usage.

    Trying is harmful: some ports list `duplex`, fail to connect, and keep a ghost of the connection for ever.
    """
    for key, usable in (("dataport.dataflow_type", flows), ("dataport.interface_type", INTERFACES)):
        if key in given and given[key].lower() not in usable:
            raise errors.Usage("%s=%s: this command can only take part in connections with %s" % (
                key, printable(given[key]), " or ".join(usable)))


def _little(properties):
    """The byte order in the properties of a connector: both ends take the first word that they know."""
    words = [word.strip() for word in properties.get("dataport.serializer.cdr.endian", "").split(",")]
    return next((word == "little" for word in words if word in ("little", "big")), True)


class Opened:
    """Connections that are opened and closed together; a failure affects no other. Regular looks find dead ports.

    After `__enter__` each has a connector or a `failure`; after `__exit__` none has a connector.
    """

    def __init__(self, connections):
        self.connections = list(connections)
        self.ended, self.closed = threading.Event(), False
        self.stopping, self.hears_stop = threading.Lock(), False  # for Ctrl-Z

    def __enter__(self):
        complete = False
        try:
            self._in_lanes("open")
            lanes.start(self._watch)
            complete = True
            return self
        finally:
            if not complete:  # Ctrl-C, SIGTERM
                self._abandon()

    def __exit__(self, *_):
        known = [str(connection.failure) for connection in self.connections]
        try:
            self._close()
        finally:
            if not self.closed:  # a signal came before held()
                self._close()
            self._report(known)

    def step_aside_when_stopped(self):
        """Leave when Ctrl-Z (SIGTSTP) comes, before this process stops, and connect again when it goes on (SIGCONT).

        A stopped process would stop the components that wait for its answers.
        """
        if _signal.getsignal(_signal.SIGTSTP) == _signal.SIG_DFL:
            _signal.signal(_signal.SIGTSTP, lambda number, frame: lanes.start(self._stop_here))
            self.hears_stop = True

    def _stop_here(self):
        if not self.stopping.acquire(False):
            return
        try:
            self._in_lanes("step_aside")
            os.kill(os.getpid(), _signal.SIGSTOP)
            self._in_lanes("come_back")
        finally:
            self.stopping.release()

    def _close(self):
        with interrupts.held():
            self.ended.set()
            if self.hears_stop:
                _signal.signal(_signal.SIGTSTP, _signal.SIG_DFL)
            for connection in self.connections:
                connection.stop()
            self._remove(self.connections)
            self.closed = True

    def _remove(self, connections):
        for connection in connections:
            if connection.failure is None:  # another component of its process may be the one that hangs
                lanes.session.silent.pop(connection.endpoint, None)
        self._in_lanes("close", connections)
        for connection in connections:
            if connection.connector:
                connection.give_up()

    def _report(self, known):
        """Not while signals are held: nobody may be reading stderr."""
        unwound = sys.exc_info()[0] is not None
        for connection, failure in zip(self.connections, known):
            connection.report(failure, unwound)
        if lanes.session.turned_away:
            cli.left_out(f"{lanes.session.turned_away} connections to this command were turned away, as too many came: values may be "
                         "missing")

    def live(self):
        """The connections that work, or may work again."""
        return [connection for connection in self.connections if connection.failure is None or
                connection.connector and isinstance(connection.failure, errors.Silent)]

    def _in_lanes(self, step, connections=None):
        connections = self.connections if connections is None else connections
        results = lanes.each(connections, lambda connection: getattr(connection, step)(), apart=True)  # see _abandon
        for connection, result in zip(connections, results):
            if step == "look" and connection.closing.is_set():
                continue  # we have removed its connector ourselves
            if isinstance(result, errors.Error):
                connection.failure = connection.failure or result
            elif isinstance(connection.failure, errors.Silent) and step == "look":
                connection.failure = None

    def _abandon(self):
        """Wait for connectors that are being made, at most the timeout, and remove them."""
        known = [str(connection.failure) for connection in self.connections]
        try:
            with interrupts.held():
                self.ended.set()
                for connection in self.connections:
                    connection.closing.set()
                end = time.monotonic() + lanes.session.timeout + GRACE
                for connection in self.connections:
                    if connection.begun and not connection.settled.wait(max(0, end - time.monotonic())):
                        connection.failure = connection.failure or errors.Silent(
                            connection.where, lanes.no_answer(lanes.session.timeout))
                self._remove([connection for connection in self.connections if connection.connector])
        finally:
            self._report(known)

    def _watch(self):
        while not self.ended.wait(LOOK):
            self._in_lanes("look", [connection for connection in self.live() if connection.due()])
