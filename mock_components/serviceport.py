"""Service ports: interfaces provided and required, and the service of the stock examples."""
from omniORB import CORBA, PortableServer, tcInternal as tc

from .idl import RTC
from .port import Port
from .properties import get, put

_ECHOES = (tc.tv_alias, "IDL:SimpleService/EchoList:1.0", "EchoList", (tc.tv_sequence, (tc.tv_string, 0), 0))
_VALUES = (tc.tv_alias, "IDL:SimpleService/ValueList:1.0", "ValueList", (tc.tv_sequence, tc.tv_float, 0))
_TEXT = (tc.tv_string, 0)


class MyService(PortableServer.Servant):
    """SimpleService::MyService of the examples: echoes and remembers."""

    _NP_RepositoryId = "IDL:SimpleService/MyService:1.0"
    _omni_op_d = {"echo": ((_TEXT,), (_TEXT,), None),
                  "get_echo_history": ((), (_ECHOES,), None),
                  "set_value": ((tc.tv_float,), (), None),
                  "get_value": ((), (tc.tv_float,), None),
                  "get_value_history": ((), (_VALUES,), None)}

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


MyService._omni_skeleton = MyService    # omniORB aborts the process without it


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
                ior = self.process.orb.object_to_string(self.services[instance])
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
            return self.process.orb.string_to_object(ior)
        except CORBA.SystemException:
            return None

    def release(self, connector_id):
        self.found = {key: value for key, value in self.found.items() if key[0] != connector_id}

    def close(self):
        for servant in self.servants:
            self.process.withdraw(servant)
