"""Service ports: interfaces provided and required, and the service of the stock examples."""
from rtshell_lite.giop import descriptors

from . import carrier
from .idl import RTC
from .port import Port
from .properties import get, put

_TEXT = (descriptors.STRING, 0)
_ECHOES = (descriptors.SEQUENCE, _TEXT, 0)
_ECHOES = (descriptors.ALIAS, "IDL:SimpleService/EchoList:1.0", "EchoList", _ECHOES)
_VALUES = (descriptors.SEQUENCE, descriptors.FLOAT, 0)
_VALUES = (descriptors.ALIAS, "IDL:SimpleService/ValueList:1.0", "ValueList", _VALUES)
_OPERATIONS = {
    "echo": ((_TEXT,), (_TEXT,)),
    "get_echo_history": ((), (_ECHOES,)),
    "set_value": ((descriptors.FLOAT,), ()),
    "get_value": ((), (descriptors.FLOAT,)),
    "get_value_history": ((), (_VALUES,)),
}


class MyService(carrier.servant("IDL:SimpleService/MyService:1.0", _OPERATIONS)):
    """SimpleService::MyService of the examples: echoes and remembers."""

    def __init__(self):
        self.echoes = []
        self.values = []

    def echo(self, message):
        self.echoes.append(message)
        return message

    def get_echo_history(self):
        return self.echoes

    def set_value(self, value):
        self.values.append(value)

    def get_value(self):
        return self.values[-1] if self.values else 0.0

    def get_value_history(self):
        return self.values


def _servant(type_name):
    if not type_name.startswith("Mock::"):
        return MyService()
    from . import robotservice          # few need it
    return robotservice.SERVANTS[type_name]()


class ServicePort(Port):
    """`interfaces` are (polarity, instance name, type name), the polarity `provided` or `required`."""

    port_type = "CorbaPort"

    def __init__(self, component, name, interfaces):
        super().__init__(component, name)
        self.entries = interfaces
        self.services = {}              # instance name -> reference of a provided interface
        self.found = {}                 # (connector id, instance name) -> reference for a required one
        self.servants = []
        for polarity, instance, type_name in interfaces:
            if polarity == "provided":
                servant = _servant(type_name)
                self.servants.append(servant)
                servant.reference = self.process.serve(servant, component.instance_name, self._awake)
                self.services[instance] = servant.reference

    def _awake(self):
        """Objects of C++ and Python providers exist only while their component is active."""
        return not self.flavour.service_sleeps or self.component.active()

    def component_keys(self, with_names):
        return ["port.corba", "port.corbaport." + (self.short_name if with_names else "")]

    def properties(self):
        return [("port.port_type", self.port_type)]

    def interfaces(self):
        polarities = {"provided": RTC.PROVIDED, "required": RTC.REQUIRED}
        return [RTC.PortInterfaceProfile(instance, type_name, polarities[polarity])
                for polarity, instance, type_name in self.entries]

    def _key(self, polarity, instance, type_name):
        return f"{self.component.instance_name}.port.{self.short_name}.{polarity}.{type_name}.{instance}"

    def publish(self, profile):
        for polarity, instance, type_name in self.entries:
            if polarity == "provided":
                ior = self.process.text(self.services[instance])
                put(profile.properties, self._key(polarity, instance, type_name), ior)
                put(profile.properties, f"port.{type_name}.{instance}", ior)
        return RTC.RTC_OK

    def subscribe(self, profile):
        strict = get(profile.properties, "port.connection.strictness") == "strict"
        for polarity, instance, type_name in self.entries:
            if polarity == "provided":
                continue
            own = f"port.{type_name}.{instance}"
            key = get(profile.properties, self._key(polarity, instance, type_name), own)
            reference = self._object(get(profile.properties, key)) if key not in ("null", "nil") else None
            if reference is None and strict and key not in ("null", "nil"):
                return RTC.RTC_ERROR
            self.found[profile.connector_id, instance] = reference
        return RTC.RTC_OK

    def _object(self, ior):
        try:
            return self.process.reference(ior)
        except carrier.SystemException:
            return None

    def release(self, connector_id):
        self.found = {key: value for key, value in self.found.items() if key[0] != connector_id}

    def close(self):
        for servant in self.servants:
            self.process.withdraw(servant)
