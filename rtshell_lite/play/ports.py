"""Ports that others connect with: out ports that send what they are given, in ports that take what comes,
service ports.

The order of calls is that of OpenRTM (docs/protocol.md 2): `connect` has the first port of a connector begin,
each publishes what the others need, calls the next one, and uses what has come back.
"""


from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.data import connection
from rtshell_lite.net import loop
from rtshell_lite.play import carriers
from rtshell_lite.play.component import code, nvlist, wire

MOST_CONNECTORS = 100  # of a port
MOST_ENDS = 16  # of a connector
FLOWS = ("push", "pull")


class Port:
    """A port of a Component: `properties` are {name: value} texts of its profile."""

    interface = "RTC.PortService"
    reference = withdraw = None
    interfaces = ()  # (instance, type, polarity) of a service port

    def __init__(self, component, name, properties):
        self.component = component
        self.name = name
        self.properties = properties
        self.connectors = {}  # by id, as on the wire: its ConnectorProfile
        self.carriers = {}  # by id: what carries its data
        self.coming = set()  # ids of connectors that are being made

    def profile(self):
        """Its RTC::PortProfile."""
        describe = orb.struct("RTC.PortInterfaceProfile")
        provided, required = orb.items("RTC.PortInterfacePolarity")
        polarities = {"Provided": provided, "Required": required}
        interfaces = [
            describe(wire(instance), wire(kind), polarities[polarity])
            for instance, kind, polarity in self.interfaces
        ]
        return orb.struct("RTC.PortProfile")(
            wire(f"{self.component.instance_name}.{self.name}"), interfaces, self.reference,
            list(self.connectors.values()), self.component.reference, nvlist(self.properties.items()),
        )

    def is_busy(self):
        """Whether values wait to be sent."""
        return any(carrier.is_busy() for carrier in self.carriers.values())

    def close(self):
        """End all that is connected here, without a word to others."""
        for carrier in self.carriers.values():
            carrier.close()
        self.carriers = {}
        self.connectors = {}

    def record(self, profile):
        """Show a connector as it was recorded, which carries nothing."""
        self.connectors[profile.connector_id] = profile

    def forget(self, connector_id):
        """Show a connector no more."""
        self.connectors.pop(connector_id, None)
        carrier = self.carriers.pop(connector_id, None)
        if carrier is not None:
            carrier.close()

    # ---- operations ----

    get_port_profile = profile

    def get_connector_profiles(self):
        return list(self.connectors.values())

    def get_connector_profile(self, connector_id):
        profile = self.connectors.get(connector_id)
        return profile or orb.struct("RTC.ConnectorProfile")("", "", [], [])

    async def connect(self, profile):
        profile = _plain(profile)
        if not _is_possible(profile) or not self._own_indexes(profile):
            return code("BAD_PARAMETER"), profile
        if profile.connector_id in self.connectors:
            return code("PRECONDITION_NOT_MET"), profile
        profile = _with_id(profile)
        try:
            result, answered = await _ask(profile.ports[0], "notify_connect", profile)
        except errors.Error:
            result = code("BAD_PARAMETER")
            answered = profile
        if result._n != "RTC_OK" and profile.connector_id in self.connectors:
            await self.disconnect(profile.connector_id)
        return result, answered

    async def notify_connect(self, profile):
        profile = _plain(profile)
        indexes = self._own_indexes(profile) if _is_possible(profile) else []
        if len(indexes) != 1:
            return code("BAD_PARAMETER"), profile
        name = profile.connector_id
        if not name or name in self.connectors or name in self.coming or self._is_double(profile):
            return code("PRECONDITION_NOT_MET"), profile
        if len(self.connectors) + len(self.coming) >= MOST_CONNECTORS:
            return code("OUT_OF_RESOURCES"), profile
        self.coming.add(name)
        try:
            return await self._join(profile, profile.ports[indexes[0] + 1 :])
        finally:
            self.coming.discard(name)

    async def _join(self, profile, following):
        """Publish, pass on to the ports that follow, and use what comes back."""
        carrier = None
        result = code("RTC_OK")
        try:
            carrier = self.begin(profile)
            if following:
                result, profile = await _ask(following[0], "notify_connect", profile)
                profile = _plain(profile)
            if result._n == "RTC_OK" and carrier is not None:
                carrier.join(dict(orb.properties(profile.properties)))
        except _Refusal as e:
            result = code(e.name)
        except errors.Error:
            result = code("BAD_PARAMETER")
        if result._n != "RTC_OK":
            if carrier is not None:
                carrier.close()
            return result, profile
        self.connectors[profile.connector_id] = profile
        if carrier is not None:
            self.carriers[profile.connector_id] = carrier
        return result, profile

    def _own_indexes(self, profile):
        """The numbers of the ports of a ConnectorProfile that are this one."""
        return [number for number, end in enumerate(profile.ports) if orb.same(end, self.reference)]

    def _is_double(self, profile):
        """Whether another connector joins it with one of these ports."""
        given = dict(orb.properties(profile.properties))
        if given.get("dataport.allow_dup_connection", "").upper() == "YES":
            return False
        others = {orb.identity(end) for end in profile.ports if not orb.same(end, self.reference)}
        return any(
            others.intersection(orb.identity(end) for end in other_profile.ports if end)
            for other_profile in self.connectors.values()
        )

    def begin(self, profile):
        """A carrier for a new connector, or None where it carries nothing. Raises _Refusal."""
        return None

    async def disconnect(self, connector_id):
        profile = self.connectors.get(connector_id)
        if profile is None:
            return code("BAD_PARAMETER")
        for end in profile.ports:
            try:
                return await _ask(end, "notify_disconnect", connector_id)
            except errors.Error:
                continue
        self.forget(connector_id)
        return code("RTC_ERROR")

    async def disconnect_all(self):
        for connector_id in list(self.connectors):
            await self.disconnect(connector_id)
        return code("RTC_OK")

    async def notify_disconnect(self, connector_id):
        profile = self.connectors.pop(connector_id, None)
        if profile is None:
            return code("BAD_PARAMETER")
        if connector_id in self.carriers:
            await self.carriers[connector_id].finish()
        self.forget(connector_id)
        index = self._own_indexes(profile)[0]
        following = profile.ports[index + 1 :]
        if not following:
            return code("RTC_OK")
        try:
            return await _ask(following[0], "notify_disconnect", connector_id)
        except errors.Error:
            return code("RTC_ERROR")


class _Refusal(Exception):
    """A connector cannot be made; `name` is that of the return code."""

    def __init__(self, name):
        super().__init__(name)
        self.name = name


class DataPort(Port):
    """What both kinds of data ports share."""

    kinds = {}  # type: dict  # of carriers by data flow

    def begin(self, profile):
        given = dict(orb.properties(profile.properties))
        flow = given.get("dataport.dataflow_type", "").lower()
        interface = given.get("dataport.interface_type", "")
        if flow not in FLOWS or interface not in connection.INTERFACES:
            raise _Refusal("BAD_PARAMETER")
        if given.get("dataport.marshaling_type", "cdr") != "cdr":
            raise _Refusal("RTC_ERROR")
        little = connection.is_little(given)
        if little is None:
            raise _Refusal("UNSUPPORTED")
        if "dataport.serializer.cdr.endian" not in given:
            profile.properties += nvlist([("dataport.serializer.cdr.endian", "little,big")])
        carrier = self.kinds[flow](self, interface, little, given)
        profile.properties += nvlist(carrier.published())
        return carrier


class OutPort(DataPort):
    """A DataOutPort, which sends to all that are connected; `values` counts what it was given."""

    kinds = {"push": carriers.Sender, "pull": carriers.Provider}

    def __init__(self, component, name, properties):
        super().__init__(component, name, properties)
        self.values = 0

    def write(self, data_of):
        """Send a value to all connectors; data_of(little) is its CDR in a byte order."""
        self.values += 1
        for carrier in list(self.carriers.values()):
            carrier.write(data_of(carrier.little))

    def lost(self, carrier):
        """Remove the connector of a carrier whose far end is gone: a coroutine."""
        ids = [name for name, other in self.carriers.items() if other is carrier]  # a peer may answer with ""
        return self.disconnect(ids[0]) if ids else None


class InPort(DataPort):
    """A DataInPort: it takes what comes."""

    kinds = {"push": carriers.Receiver, "pull": carriers.Idle}

    def take(self, data, little):
        """A value has come, as octets; nothing is done with it."""


class ServicePort(Port):
    """A CorbaPort: what its component required can be connected; what it provided cannot be called."""

    def __init__(self, component, name, properties, interfaces=()):
        super().__init__(component, name, properties)
        self.interfaces = interfaces

    def begin(self, profile):
        if any(polarity == "Provided" for _, _, polarity in self.interfaces):
            raise _Refusal("RTC_ERROR")
        return None


async def leave(components):
    """Disconnect all that others have connected with components, as these do when they end."""
    ports = [port for component in components for port in component.ports]
    joined = [(port, connector_id) for port in ports for connector_id in port.carriers]
    await loop.each(joined, lambda pair: pair[0].disconnect(pair[1]))


KINDS = {"DataOutPort": OutPort, "DataInPort": InPort, "CorbaPort": ServicePort}


def _is_possible(profile):
    """Whether the ports of a ConnectorProfile can be connected."""
    return None not in profile.ports and len(profile.ports) <= MOST_ENDS


def _plain(profile):
    """A ConnectorProfile with those of its properties that can be passed on: texts."""
    texts = [(name, value) for name, value in profile.properties if type(value) is bytes]
    return _made(profile.name, profile.connector_id, profile.ports, texts)


def _made(name, connector_id, ends, properties):
    ends = [end and orb.narrow(end, "RTC.PortService") for end in ends]
    return orb.struct("RTC.ConnectorProfile")(name, connector_id, ends, properties)


def _with_id(profile):
    """A ConnectorProfile with an id: its own, or a random UUID (RFC 4122, version 4)."""
    if profile.connector_id:
        return profile
    digits = loop.world().octets(16).hex()
    uuid = f"{digits[:8]}-{digits[8:12]}-4{digits[13:16]}-a{digits[17:20]}-{digits[20:]}"
    return _made(profile.name, uuid, profile.ports, profile.properties)


async def _ask(end, operation, argument):
    """The result of an operation of a port, ours or another."""
    own = orb.own_servant(end)
    if own is not None:
        return await getattr(own, operation)(argument)
    return await orb.call(orb.at_address(end), end, operation, argument)
