"""Connectors between a port and this process: made, watched and removed.

    async with connection.Connections([reader, writer]) as opened: …     in parallel
    async with reader: …                                                 raises its failure

However the block ends, the connectors are removed.
"""

import sys

from rtshell_lite import errors, notes
from rtshell_lite.corba import orb, session
from rtshell_lite.net import loop, real
from rtshell_lite.robot import component, connectors, ports
from rtshell_lite.text import printable, shell_word, to_wire

INTERFACES = ("corba_cdr", "data_service")  # usable interface types; the first is preferred
LOOK = 1.0  # seconds between two looks whether silent ports still exist
MOST = 20  # that are looked at at a time, of more by turns: each look is a call that the component answers

# That a connector was not removed, why, and when to try again.
BUSY = (
    "stays, because a call is unanswered and removing it now could end the component; when it answers again"
)
SILENT = "may stay, because the component does not answer; when it does again"
REFUSED = "may stay, because the component refused to remove it; to try again"


class PortConnection:
    """A connector of a port. `failure` is the errors.Error that says what is wrong with it now, or None."""

    kind = side = dataflow = None  # the port's type; the name of its object in properties; push or pull
    flows = ()  # usable data flows
    is_still_silent = False  # whether it is due for nothing but a silence that lasts

    def __init__(self, port, name, properties):
        self.port = port
        self.where = ports.label(port)
        self.name = name
        self.endpoint = orb.endpoint(port.ref)
        self.user = dict(properties or {})  # the properties that the user asks for
        self.connector = self.failure = None
        self.agreed = {}  # the properties of the connector, as the port returned them
        self.left = None  # (a connector that was not removed, what to say of it)
        self.reported = None  # a failure that has been reported as the connection was closed
        self.remark = None  # a note for the user, printed once
        self.little = True  # the byte order agreed upon
        self.is_closing = False
        self.tasks = None  # the loop.Group of its Connections, for tasks that end with them
        check(self.user, self.flows)
        if port.type != self.kind:
            raise errors.WrongKind(self.where, self.kind, port.type)
        self.interface = self._interface()

    async def __aenter__(self):
        self._opened = Connections([self])
        await self._opened.__aenter__()
        if self.failure:
            await self._opened.__aexit__(None, None, None)
            raise self.failure
        return self

    async def __aexit__(self, *exception):
        await self._opened.__aexit__(*exception)

    async def open(self):
        """Make the connector. Raises errors.Error."""
        requested = await self.requested()
        for key in ("dataport.dataflow_type", "dataport.subscription_type"):
            offer = ports.offer_without(self.port, key, requested[key])
            if offer is not None:
                raise errors.Refused(
                    self.where,
                    "has no %s %s (it has: %s)" % (key.split(".")[1], printable(requested[key]), offer),
                )
        await loop.finish(self._connect(requested))
        self.little = is_little(self.agreed) is not False or await self.is_always_little()

    async def _connect(self, requested):
        try:
            self.connector = await connectors.connect_alone(self.port, self.name, requested)
        except errors.Error as e:
            self.failure = e  # here, as the task that opens it may have been cancelled
            raise
        self.agreed = dict(self.connector.properties)

    async def requested(self):
        """The dict of properties to connect with."""
        requested = {
            "dataport.dataflow_type": self.dataflow,
            "dataport.interface_type": self.interface,
            "dataport.data_type": self.port.properties.get("dataport.data_type", ""),
            "dataport.serializer.cdr.endian": "little,big",
        }
        requested.update(await self.defaults())
        requested.update(self.user)
        return requested

    async def close(self):
        """Remove the connector. Sets `failure` and `left` when that fails, unless the port is gone."""
        connector = self.connector
        self.connector = None
        if connector:
            self.left = connector, BUSY
            await self.leave(connector)
        await self.release()

    async def leave(self, connector):
        """Remove a connector, as soon as that does no harm."""
        if await self.is_at_rest():
            await self.remove(connector)

    async def come_back(self):
        """Make the connector again that close() has removed. Raises errors.Error."""
        if self.is_closing or self.connector or self.failure:
            return
        if self.left:
            raise errors.Unreachable(self.where, "a fetch is not answered")
        self.renew()
        await self.open()

    async def remove(self, connector):
        """Remove a connector now."""
        self.left = connector, SILENT
        try:
            await connectors.disconnect(self.port, connector, is_forced=True)  # nothing is on its way
            self.left = None
        except (errors.Gone, errors.ConnectionRefused):
            self.left = None  # the port is gone, and its connectors with it
        except errors.Unreachable as e:
            self.failure = self.failure or e
        except errors.Refused as e:
            self.failure = self.failure or e
            self.left = (connector, REFUSED)

    async def give_up(self):
        """Leave the connector: its process was found silent a moment ago, and not asked again."""
        self.left = (self.connector, self.why_left())
        self.connector = None
        await self.release()

    def why_left(self):
        """Why the connector of a silent process is left, in words."""
        return SILENT

    def report(self, reported, unwound):
        """Report a connector that could not be removed, and the command that removes it.

        If `unwound` by an exception, also report a failure other than the `reported` one (text): nobody else
        may do that.
        """
        if unwound and self.failure and str(self.failure) != reported:
            notes.fail(self.failure)
            self.reported = self.failure
        if self.left:
            connector, what = self.left
            words = ["rtdis", "-i", connector.id, self.where]
            if ports.is_fetched(connector):
                words.insert(1, "--force")
            remedy = " ".join(shell_word(word) for word in words)
            notes.fail(f"{self.where}: connection {printable(connector.id)} {what}: {remedy}")

    def stop(self):
        """Prepare to close: begin what `is_at_rest` waits for."""

    async def is_at_rest(self):
        """Whether the connector can be removed without harm; may wait until it can."""
        return True

    async def check(self):
        """Check that the port exists and has the connector. Raises errors.Error."""
        connector = self.connector
        if connector and not await self.is_there(connector):
            raise errors.Unreachable(self.where, self.lost())

    async def is_there(self, connector):
        """Whether the port has the connector. Raises errors.Error."""
        try:
            profile = await component.once_more(
                lambda: orb.call(self.where, self.port.ref, "get_connector_profile", to_wire(connector.id))
            )
        except (errors.Gone, errors.ConnectionRefused) as e:
            raise self.component_ended(e)
        return bool(profile.connector_id)

    def component_ended(self, e):
        """The error for a component that was Gone or ConnectionRefused."""
        if isinstance(e, errors.Gone):
            return Ended(self.where, "the component has ended")
        return Ended(self.where, "the component is gone, and its process too")

    def lost(self):
        """The message for a connector that someone else has removed."""
        return "the connection has been removed"

    def is_due(self):
        """Whether it is time for a check()."""
        return False

    async def defaults(self):
        """More properties to ask for, where the user does not say otherwise."""
        return {}

    async def release(self):
        """Free what belonged to the connector."""

    def renew(self):
        """Prepare for another connector."""

    async def is_always_little(self):
        """Whether values are little-endian whatever was agreed upon."""
        return False

    def remote(self, kinds):
        """The object that the port published for the connector; `kinds` names its stub class, by interface
        type.

        Raises Refused when the port published no object.
        """
        ior = self.agreed.get(f"dataport.{self.interface}.{self.side}_ior")
        if not ior:
            raise errors.Refused(self.where, f"publishes no provider for {self.dataflow}")
        return orb.narrow(orb.from_text(self.where, ior), kinds[self.interface])

    def _interface(self):
        offered = [
            word.strip() for word in self.port.properties.get("dataport.interface_type", "").split(",")
        ]
        is_any = any(word.lower() in ("any", "") for word in offered)
        if "dataport.interface_type" in self.user:
            usable = [self.user["dataport.interface_type"]]
        else:
            usable = INTERFACES
        for interface in usable:
            if is_any or interface in offered:
                return interface
        raise errors.Refused(
            self.where, f"offers no {' and no '.join(usable)} (it has: {printable(', '.join(offered))})"
        )


class Ended(errors.Unreachable):
    """A component has ended, and its connectors with it."""


def check(user, flows):
    """Refuse properties that our end of a connection does not support, before any component is asked. Raises
    Usage.

    Trying is harmful: some ports list `duplex`, fail to connect, and keep a ghost of the connection for ever.
    """
    for key, usable in (("dataport.dataflow_type", flows), ("dataport.interface_type", INTERFACES)):
        if key in user and user[key].lower() not in usable:
            raise errors.Usage(
                "%s=%s: this command can only take part in connections with %s"
                % (key, printable(user[key]), " or ".join(usable))
            )


def is_little(properties):
    """The byte order in the properties of a connector: both ends take the first word that they know. None
    where none is known.
    """
    words = properties.get("dataport.serializer.cdr.endian", "little").split(",")
    orders = [word.strip() for word in words if word.strip() in ("little", "big")]
    return orders[0] == "little" if orders else None


class Connections:
    """Connections that are opened and closed together; a failure affects no other. Regular looks find dead
    ports.

    Within the block each has a connector or a `failure`; after it none has a connector.
    """

    def __init__(self, connections):
        self.connections = list(connections)
        self._stop = self._tasks = self._watching = None
        self._hears_stop = self._is_open = False
        self.absences = 0  # how often it has stepped aside
        self._ended = set()  # endpoints of processes with which a connection has ended
        self._looks = 0  # at silent ports

    async def __aenter__(self):
        # the Bell rings at Ctrl-Z
        self._stop = loop.Bell()
        self._tasks = loop.Group()
        self._watching = loop.background(self._watch())
        session.current().on_end.append(self._suspect)
        for connection in self.connections:
            connection.tasks = self._tasks
        await self._watching.__aenter__()
        try:
            await self._each("open", self.connections)
        except BaseException as e:  # Ctrl-C, SIGTERM
            await self.__aexit__(type(e), e, e.__traceback__)
            raise
        self._is_open = True
        return self

    async def __aexit__(self, *exception):
        reported = [str(connection.failure) if self._is_open else None for connection in self.connections]
        try:
            await loop.finish(self._close())
        finally:
            is_unwound = sys.exc_info()[0] is not None
            for connection, failure in zip(self.connections, reported):
                connection.report(failure, is_unwound)
            turned_away = session.current().turned_away
            if turned_away:
                notes.left_out(
                    f"{turned_away} connections to this command were turned away, as too many came: values "
                    "may be missing"
                )

    async def _close(self):
        if self._hears_stop:
            loop.current().hear(real.SIGTSTP, None)
        for connection in self.connections:
            connection.stop()
            connection.is_closing = True
        session.current().on_end.remove(self._suspect)
        try:
            await self._watching.__aexit__(None, None, None)
        finally:
            await self._close_all()

    async def _close_all(self):
        for connection in self.connections:
            if connection.failure is None:  # another component of its process may be the one that hangs
                session.current().ask_again(connection.endpoint)
        await self._each("close", self.connections)
        for connection in self.connections:
            if connection.connector:
                await connection.give_up()
        self._tasks.cancel()
        await self._tasks.__aexit__(None, None, None)

    def step_aside_when_stopped(self):
        """Leave when Ctrl-Z (SIGTSTP) comes, before this process stops, and connect again when it goes on
        (SIGCONT).

        A stopped process would stop the components that wait for its answers.
        """
        if real.SIGTSTP is not None and loop.world().handler(real.SIGTSTP) == real.DEFAULT:
            loop.current().hear(real.SIGTSTP, self._stop.ring)
            self._hears_stop = True

    async def add(self, connections):
        """Open further connections within the block; those that fail have a `failure`."""
        for connection in connections:
            connection.tasks = self._tasks
            if connection not in self.connections:
                self.connections.append(connection)
        await self._each("open", connections)

    async def let_go(self, connections):
        """Have the components of these reading.Readers not wait for us any more; those that cannot have a
        `failure`.
        """
        await self._each("let_go", connections)

    def drop(self, connection):
        """Forget a connection whose port is gone."""
        self.connections.remove(connection)

    def live(self):
        """The connections that work, or may work again."""
        return [
            connection
            for connection in self.connections
            if connection.failure is None
            or connection.connector
            and isinstance(connection.failure, errors.Unanswered)
        ]

    async def _each(self, step, connections):
        results = await session.each(
            connections, lambda connection: getattr(connection, step)(),
            lambda connection: (connection.endpoint, connection.where),
        )
        for connection, result in zip(connections, results):
            if isinstance(result, errors.Error):
                connection.failure = connection.failure or result
            elif isinstance(connection.failure, errors.Unanswered) and step == "check":
                connection.failure = None

    async def _watch(self):
        while True:
            if await self._stop.wait(LOOK):
                await self._step_aside()
            else:
                await self._each("check", self._due())

    def _suspect(self, endpoint):
        """A connection with a process has ended: it may be gone."""
        self._ended.add(endpoint)

    def _due(self):
        """The connections to be looked at: those with a process that may have ended, those that have just
        fallen silent or are due for another reason, and of the other silent ones MOST at a time.
        """
        ended = set(self._ended)
        self._ended.clear()
        at_once = []
        silent = []
        for connection in self.live():
            is_due = connection.is_due()
            if is_due and connection.is_still_silent and connection.endpoint not in ended:
                silent.append(connection)
            elif is_due or connection.endpoint in ended:
                at_once.append(connection)
        if len(silent) > MOST:
            first = self._looks % len(silent)
            self._looks += MOST
            silent = (silent + silent)[first : first + MOST]
        return at_once + silent

    async def _step_aside(self):
        self.absences += 1
        await loop.finish(self._each("close", self.connections))
        loop.world().stop_here()
        await loop.finish(self._each("come_back", self.connections))
