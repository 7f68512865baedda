"""Ports: profiles, connecting and disconnecting. No lock is held during a call to another port."""
from . import carrier
from .idl import RTC
from .properties import get, nvlist

TRANSIENT_CONNECT_FAILED = 0x41540002


class Port(carrier.skeleton("RTC.PortService")):
    """What data ports and service ports share."""

    def __init__(self, component, name):
        self.component = component
        self.process = component.process
        self.flavour = component.flavour
        self.short_name = name
        self.name = component.instance_name + "." + name if self.flavour.port_prefix else name
        self.reference = self.process.serve(self, component.instance_name)
        self.lock = carrier.Lock()
        self.profiles = {}              # connector id -> connector profile, in order of connecting
        self.transports = {}            # connector id -> what carries its data
        # by a connector that no profile shows: the next disconnection never ends
        self.haunted = False
        self.is_blind = False  # its profile shows nil in the place of the other ports of connectors

    # to be given by the kinds of port

    def properties(self):
        """Name-value pairs of the port profile."""
        raise NotImplementedError

    def interfaces(self):
        return []

    def prepare(self, profile):
        """Before a connection is made: add the properties of the port that got `connect`."""

    def publish(self, profile):
        """Add to the connector what the other ports need; returns a code."""
        raise NotImplementedError

    def subscribe(self, profile):
        """Use what the other ports have added; returns a code."""
        raise NotImplementedError

    def release(self, connector_id):
        """The connection has ended: free what carried its data."""
        transport = self.transports.pop(connector_id, None)
        if transport:
            transport.close()

    def close(self):
        """The component has ended."""

    # profiles

    def profile(self):
        return RTC.PortProfile(self.name, self.interfaces(), self.reference, self._connectors(),
                               self.component.reference, nvlist(self.properties()))

    def _connectors(self):
        """The connector profiles that it shows."""
        if not self.is_blind:
            return list(self.profiles.values())
        return [
            RTC.ConnectorProfile(
                each.name,
                each.connector_id,
                [port if self.reference._is_equivalent(port) else None for port in each.ports],
                each.properties,
            )
            for each in list(self.profiles.values())
        ]

    def get_port_profile(self):
        self._prune()
        return self.profile()

    def get_connector_profiles(self):
        self._prune()
        return self._connectors()

    def get_connector_profile(self, connector_id):
        return self.profiles.get(connector_id) or RTC.ConnectorProfile("", "", [], [])

    def _dead_connections(self):
        return [p.connector_id for p in list(self.profiles.values())
                if not all(port._is_equivalent(self.reference) or is_alive(port) for port in p.ports)]

    def _prune(self):
        """Drop connections with a dead peer; some implementations tell the caller about it, once.

        One of several ends stays where the first port that lives has dropped it already: it is the one that
        is asked.
        """
        dead = self._dead_connections()
        for connector_id in dead:
            self.disconnect(connector_id)
        if (
            any(connector_id not in self.profiles for connector_id in dead)
            and self.flavour.dead_peer != "clean"
        ):
            raise carrier.failure("TRANSIENT", TRANSIENT_CONNECT_FAILED)

    def prune_for_component(self):
        """The same for the component's profile, where C++ 2.1 ends its process."""
        if self.flavour.dead_peer == "die" and self._dead_connections():
            self.process.die()
        self._prune()

    # connecting

    def connect(self, profile):
        refusal = self._refuse_connect(profile)
        if refusal:
            return refusal, profile
        if not profile.connector_id:
            profile.connector_id = carrier.unique_id(self.flavour.uuid == "time")
        self.prepare(profile)
        try:
            code, profile = profile.ports[0].notify_connect(profile)
        except carrier.SystemException:
            code = RTC.BAD_PARAMETER
        if code != RTC.RTC_OK:
            self.disconnect(profile.connector_id)
        return code, profile

    def _refuse_connect(self, profile):
        if not profile.ports or None in profile.ports:
            return RTC.BAD_PARAMETER
        if profile.connector_id and (profile.connector_id in self.profiles or not self.flavour.own_ids):
            return RTC.PRECONDITION_NOT_MET
        if self.flavour.duplicates == "ask peers" and not self._doubles_allowed(profile):
            if any(self._connected(p.ports) for port in self._others(profile.ports)
                   for p in port.get_connector_profiles()):
                return RTC.PRECONDITION_NOT_MET
        return None

    def notify_connect(self, profile):
        mine = [i for i, port in enumerate(profile.ports) if self.reference._is_equivalent(port)]
        if not mine:
            return RTC.BAD_PARAMETER, profile
        if len(mine) > 1:
            if self.flavour.self_deadlock:
                self.component.hang()
            return RTC.BAD_PARAMETER, profile
        code = self._refuse_double(profile) or self.publish(profile)
        following = profile.ports[mine[0] + 1:]
        if code == RTC.RTC_OK and following:
            code, profile = self._pass_on(profile, following[0])
        if code == RTC.RTC_OK:
            code = self.subscribe(profile)
            if code != RTC.RTC_OK and following and not self.flavour.leaves_half:
                forward_disconnect(following[0], profile.connector_id)
        if code != RTC.RTC_OK:
            self.release(profile.connector_id)
            return code, profile
        with self.lock:
            self.profiles[profile.connector_id] = profile
        self.component.report("PORT_PROFILE", "CONNECT:" + self.name)
        return code, profile

    def _pass_on(self, profile, port):
        self.rewrite(profile)
        try:
            return port.notify_connect(profile)
        except carrier.SystemException:
            return RTC.BAD_PARAMETER, profile

    def rewrite(self, profile):
        """Change a connector's profile before it is passed to the next port."""

    def _others(self, ports):
        return [port for port in ports if not self.reference._is_equivalent(port)]

    def _connected(self, ports):
        return any(port is not None and self.reference._is_equivalent(port) for port in ports)

    def _doubles_allowed(self, profile):
        return get(profile.properties, "dataport.allow_dup_connection").upper() == "YES"

    def _refuse_double(self, profile):
        if self.flavour.duplicates == "one" and self.profiles:
            return RTC.RTC_ERROR
        if self.flavour.duplicates != "refuse" or self._doubles_allowed(profile):
            return None
        others = self._others(profile.ports)
        known = [port for p in list(self.profiles.values()) for port in self._others(p.ports)]
        if any(one._is_equivalent(other) for one in others for other in known):
            return RTC.PRECONDITION_NOT_MET
        return None

    # disconnecting

    def disconnect(self, connector_id):
        profile = self.profiles.get(connector_id)
        if profile is None:
            return RTC.BAD_PARAMETER
        for port in profile.ports:
            try:
                return port.notify_disconnect(connector_id)
            except carrier.SystemException:
                continue
        return RTC.RTC_ERROR

    def disconnect_all(self):
        for connector_id in list(self.profiles):
            self.disconnect(connector_id)
        return RTC.RTC_OK

    def notify_disconnect(self, connector_id):
        with self.lock:
            profile = self.profiles.pop(connector_id, None)
        if profile is None:
            return RTC.BAD_PARAMETER
        if self.haunted:
            self.component.hang()
        index = next(i for i, port in enumerate(profile.ports) if self.reference._is_equivalent(port))
        code = RTC.RTC_OK
        if profile.ports[index + 1:]:
            code = forward_disconnect(profile.ports[index + 1], connector_id)
        self.release(connector_id)
        self.component.report("PORT_PROFILE", "DISCONNECT:" + self.name)
        return code


def forward_disconnect(port, connector_id):
    """Remove a connection from its next port, too; returns that port's code."""
    try:
        return port.notify_disconnect(connector_id)
    except carrier.SystemException:
        return RTC.RTC_ERROR


def is_alive(port):
    """Whether the object answers: its process lives, and it has not been removed."""
    try:
        return not port._non_existent()
    except carrier.SystemException:
        return False
