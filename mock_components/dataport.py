"""Data ports: what they publish, negotiate and carry."""
from . import buffer, carrier, transport, values
from .idl import RTC
from .port import Port, is_alive
from .properties import get, is_text, put, text

FAN_LIMIT = 100
TOPICS = ("ros", "ros2", "fast-rtps", "opensplice", "ssm")  # transports that connect one port alone


class DataPort(Port):
    """What InPorts and OutPorts share."""

    side = port_type = key = None

    def __init__(self, component, name, type_name):
        self.type_name = type_name
        self.data_type = component.flavour.data_type(type_name)
        self.refusal = None             # the code with which it refuses connections
        super().__init__(component, name)

    def component_keys(self, with_names):
        """The properties that the port leaves in the component's profile."""
        names = ["dataport"] + ([self.short_name] if with_names else [])
        return [f"port.{self.side}.{name}" for name in names]

    def properties(self):
        flavour = self.flavour
        pairs = [("port.port_type", self.port_type), ("dataport.data_type", self.data_type)]
        pairs += self.modes()
        if flavour.marshaling:
            pairs.append(("dataport.marshaling_types", "cdr"))
        pairs += [
            ("dataport.dataflow_type", flavour.dataflow),
            ("dataport.interface_type", flavour.interfaces),
        ]
        if flavour.modern:
            pairs += [("dataport.interface_option." + name, "") for name in flavour.interfaces.split(",")]
            pairs.append(("data_type", self.data_type))
        return pairs

    def moved(self, how):
        """Data has passed; only 2.x reports that."""
        if self.flavour.modern:
            self.component.report("PORT_PROFILE", how + self.name)

    # connecting

    def prepare(self, profile):
        if not get(profile.properties, "dataport.serializer.cdr.endian"):
            put(profile.properties, "dataport.serializer.cdr.endian", "little,big")

    def publish(self, profile):
        if self.refusal:
            return getattr(RTC, self.refusal)
        if len(self.profiles) >= int(get(profile.properties, "dataport." + self.fan, str(FAN_LIMIT))):
            return RTC.PRECONDITION_NOT_MET
        flow, interface = agreed(profile)
        if flow not in self.flavour.dataflow.split(","):
            return RTC.BAD_PARAMETER
        if flow == "duplex":
            self.haunted = True
            return RTC.BAD_PARAMETER
        if interface not in self.flavour.interfaces.split(","):
            return RTC.BAD_PARAMETER
        if values.little_endian(profile) is None:
            return getattr(RTC, self.flavour.bad_endian)
        if interface == "direct":
            return self._direct(profile)
        if interface in TOPICS:
            return RTC.RTC_OK  # a topic carries the data: there is no other port
        self._merge_keys(profile)
        if flow == self.served:
            self._serve(profile, interface)
        if self.flavour.reference == "kept":
            profile.properties.sort(key=lambda item: not is_text(item.value))
        return RTC.RTC_OK

    def subscribe(self, profile):
        flow, interface = agreed(profile)
        if not self._marshaling_known(profile):
            return RTC.RTC_ERROR
        if flow == self.served or interface == "direct" or interface in TOPICS:
            return RTC.RTC_OK
        ior = get(profile.properties, f"dataport.{transport.KEYS[interface]}.{self.other_side}_ior")
        try:
            reference = ior and self.process.reference(ior)
        except carrier.SystemException:
            reference = None
        if not reference:
            return RTC.BAD_PARAMETER
        return self.use(profile, interface, reference)

    def rewrite(self, profile):
        """Spoil or remove object references, as some implementations do when they pass a connector on."""
        fate = self.flavour.reference
        refs = [item for item in profile.properties if carrier.is_of(item.value, carrier.REFERENCE)]
        if fate == "kept":
            return
        for item in refs:
            if fate == "text":
                item.value = text(f"<OpenRTM._objref_{self.interface} object at 0x7f0000000000>")
            else:
                profile.properties.remove(item)

    def _marshaling_known(self, profile):
        asked = get(profile.properties, "dataport.marshaling_type", "cdr")
        return asked == "cdr" or not self.flavour.marshaling or self.side == "inport"

    def _direct(self, profile):
        near = all(self.process.local_servant(port) for port in profile.ports)
        return RTC.RTC_OK if near else getattr(RTC, self.flavour.direct_far)

    def _merge_keys(self, profile):
        if self.flavour.merged_keys == "data_type":
            put(profile.properties, f"dataport.{self.side}.data_type", self.data_type)
        elif self.flavour.merged_keys == "empty":
            put(profile.properties, f"dataport.{self.side}", "")

    def _serve(self, profile, interface):
        """Publish the object that this port offers to the others."""
        made = self.carry(profile, interface)
        self.transports[profile.connector_id] = made
        key = f"dataport.{transport.KEYS[interface]}.{self.side}"
        put(profile.properties, key + "_ior", self.process.text(made.reference))
        if self.flavour.reference != "never":
            put(profile.properties, key + "_ref", transport.reference_any(made.reference))


class OutPort(DataPort):
    """Sends by itself (push) or hands out (pull)."""

    side = "outport"
    other_side = "inport"
    port_type = "DataOutPort"
    served = "pull"
    fan = "fan_out"
    interface = "OutPortCdr"

    def __init__(self, component, name, type_name):
        super().__init__(component, name, type_name)
        self.last = values.make(type_name, 0)
        self.sent = 0

    def modes(self):
        pairs = [("dataport.subscription_type", self.flavour.subscriptions)]
        if self.flavour.modern:
            pairs.append(("dataport.io_mode", self.flavour.subscriptions))
        return pairs

    def properties(self):
        pairs = super().properties()
        if self.flavour.data_value:
            pairs.append(("dataport.data_value", carrier.Any(values.typecode(self.type_name), self.last)))
        return pairs

    def write(self, value):
        """Send a value to all connections, or keep it for those that fetch."""
        self.last = value
        self.sent += 1
        self.moved("SEND:OutPort:")
        for connector_id, one in list(self.transports.items()):
            if not one.write(values.encode(self.type_name, value, one.little)):
                self.process.thread(self.disconnect, connector_id)

    def carry(self, profile, interface):
        return transport.Provider(self, profile, interface)

    def use(self, profile, interface, reference):
        mode = get(profile.properties, "dataport.subscription_type", "flush").lower()
        rate = get(profile.properties, "dataport.publisher.push_rate") or get(
            profile.properties, "dataport.push_rate"
        )
        if mode not in ("flush", "new", "periodic"):
            return RTC.RTC_ERROR
        if mode == "periodic" and not positive(rate) and (rate or self.flavour.periodic_rate):
            return RTC.RTC_ERROR
        pause = 1 / float(rate) if mode == "periodic" and rate else 0
        self.transports[profile.connector_id] = transport.Sender(
            self, profile, interface, reference, mode, pause
        )
        return RTC.RTC_OK


class InPort(DataPort):
    """Keeps values until its component reads them, in a later cycle, and only while there is a connector.

    InPort::isNew of C++ and Python is false without one: what lies in the buffer then is read at somebody
    else's connection.
    """

    side = "inport"
    other_side = "outport"
    port_type = "DataInPort"
    served = "push"
    fan = "fan_in"
    interface = "InPortCdr"

    def __init__(self, component, name, type_name):
        super().__init__(component, name, type_name)
        self.buffer = buffer.RingBuffer()
        self.received = 0               # values that the component has read
        self.last = None
        self.times = set()              # of these values
        self.status = "PORT_OK"         # what it answers to values

    def modes(self):
        return [("dataport.subscription_type", "Any")]

    def carry(self, profile, interface):
        self.buffer.configure(profile.properties, self.side)
        return transport.Receiver(self, profile, interface)

    def use(self, profile, interface, reference):
        self.transports[profile.connector_id] = transport.Fetcher(self, profile, interface, reference)
        return RTC.RTC_OK

    def decode(self, data, little):
        """The value in a payload."""
        return values.decode(self.type_name, data, little)

    def notify_disconnect(self, connector_id):
        profile = self.profiles.get(connector_id)
        if profile and self.buffer.waiting and self.flavour.busy_put == "die":
            if all(is_alive(port) for port in self._others(profile.ports)):
                self.process.die()
        if profile and self.component.reads:
            self._catch_up()
        return super().notify_disconnect(connector_id)

    def _catch_up(self):
        """Read what cycles that are overdue should have read: whoever disconnects has waited for them."""
        for _ in range(self.component.overdue()):
            value = self.buffer.read()
            if value is None:
                break
            self.take(value)

    def put(self, data, little):
        """A payload has come; returns the name of the status for the sender."""
        value = self.decode(data, little)
        self.component.read_between()
        status = self.buffer.write(value)
        self.moved("RECEIVE:InPort:")
        return status

    def read(self):
        """Called in each cycle of the component: read a pushed value, and fetch from pull connections."""
        connections = list(self.transports.values())
        if not connections:
            return
        value = self.buffer.read()
        if value is not None:
            self.take(value)
        for one in connections:
            one.fetch()

    def take(self, value):
        """The component has read a value."""
        self.last = value
        self.times.add((value.tm.sec, value.tm.nsec))
        with self.process.arrived:
            self.received += 1
            self.process.arrived.notify_all()


class EventInPort(InPort):
    """For events of a state machine, of data type `any`; C++ 2.x cannot connect such a port by corba_cdr."""

    def __init__(self, component, name, type_name):
        super().__init__(component, name, type_name)
        self.data_type = "any"

    def properties(self):
        return [pair for pair in super().properties() if pair[0] != "dataport.marshaling_types"]

    def publish(self, profile):
        if self.flavour.language == "C++" and self.flavour.modern:
            return RTC.RTC_ERROR
        return super().publish(profile)


def agreed(profile):
    """Data-flow and interface type of a connector; only the former may be written in any case."""
    return (get(profile.properties, "dataport.dataflow_type").lower(),
            get(profile.properties, "dataport.interface_type"))


def positive(number):
    """Whether a text is a number above zero."""
    try:
        return float(number) > 0
    except ValueError:
        return False
