"""Launch files of rtmlaunch (rtmros_common): <rtconnect> and <rtactivate> in files of roslaunch, as an
RtsProfile.

Components are bound at the top of one name server; what these files do not have is left empty in the profile:
an id, which then fits every component, and data types. Arguments are replaced as roslaunch does, with
rtmlaunch's addition that the environment has values, too.
"""

import re

from rtshell_lite import errors
from rtshell_lite.text import printable
from rtshell_lite.xmlprofile import model, xml

ARGUMENT = re.compile(r"\$\((arg|env|optenv)\s+([^\s)]+)\s*([^)]*)\)")
MOST_NESTED = 20  # arguments in the values of arguments
NAME_SERVER = "localhost:15005"  # where rtmlaunch looks unless RTCTREE_NAMESERVERS says otherwise
SUBSCRIPTIONS = ("flush", "new", "periodic")
RATE = "50.0"  # Hz of a periodic connection without its own
PATH_ID = "COMPONENT_PATH_ID"


def read(data, name, given, environment):
    """(model.RtsProfile, lines on what is left out) of a launch file, bytes.

    `given` are arguments, {name: value}, as on the command line of roslaunch. Raises BadProfile.
    """
    return _Launch(name, given, environment).profile(xml.nodes(data, name))


class _Launch:
    def __init__(self, name, given, environment):
        self.name = name
        self.values = dict(given)
        self.environment = environment
        self.server = environment.get("RTCTREE_NAMESERVERS", NAME_SERVER).split(";")[0]
        self.components = {}
        self.connections = []
        self.activated = []
        self.left_out = {}

    def profile(self, root):
        self.take(root)
        profile = model.RtsProfile(components=list(self.components.values()))
        for connection in self.connections:
            profile.add_connector(connection)
        targets = [self.condition(number, component) for number, component in enumerate(self.activated, 1)]
        profile.activation = model.MessageSending(targets=targets)
        for path, component in self.components.items():
            if component not in self.activated:
                component.properties.append(model.Property(name="keep.state", value="any"))
        notes = [f"{count} <{kind}> left out" for kind, count in sorted(self.left_out.items())]
        return profile, notes

    @staticmethod
    def condition(number, component):
        target = model.TargetExecutionContext(component_id="", instance_name=component.instance_name, id="0")
        return model.Condition(sequence=number, target=target)

    def fail(self, node, why):
        raise errors.BadProfile(self.name, node.line, node.column, why)

    def take(self, node):
        """Take an element and all below it, unless its `if` or `unless` is against that."""
        for child in node.children():
            if not self.is_wanted(child):
                continue
            kind = child.local
            if kind == "arg":
                self.take_argument(child)
            elif kind == "rtconnect":
                self.take_connection(child)
            elif kind == "rtactivate":
                component = self.component(child, self.value(child, "component"))
                if component not in self.activated:
                    self.activated.append(component)
            elif kind in ("group", "launch"):
                self.take(child)
            elif kind in ("include", "node"):
                self.left_out[kind] = self.left_out.get(kind, 0) + 1

    def is_wanted(self, node):
        for key, expected in (("if", "true"), ("unless", "false")):
            if key in node.attributes:
                value = self.value(node, key).strip().lower()
                value = {"1": "true", "0": "false"}.get(value, value)
                if value not in ("true", "false"):
                    self.fail(node, f"{key}: neither true nor false: {printable(value)}")
                if value != expected:
                    return False
        return True

    def take_argument(self, node):
        name = self.value(node, "name")
        if "value" in node.attributes:
            self.values[name] = self.value(node, "value")
        elif "default" in node.attributes and name not in self.values:
            self.values[name] = self.environment.get(name, node.attributes["default"])

    def value(self, node, key, default=None):
        """The value of an attribute, its arguments replaced."""
        if key not in node.attributes and default is None:
            self.fail(node, f"<{printable(node.local)}> without {key}")
        value = node.attributes.get(key, default)
        for _ in range(MOST_NESTED):
            if not ARGUMENT.search(value):
                return value
            value = ARGUMENT.sub(lambda match: self.replaced(node, *match.groups()), value)
        self.fail(node, f"{key}: arguments that contain themselves")

    def replaced(self, node, kind, name, default):
        if kind == "arg" and name in self.values:
            return self.values[name]
        if name in self.environment:
            return self.environment[name]
        if kind == "optenv":
            return default
        self.fail(node, f"no value for the argument {printable(name)}: give {printable(name)}:=VALUE")

    def component(self, node, path):
        """The model.Component at a path below the name server."""
        path = path.strip("/")
        if not path or ":" in path:
            self.fail(node, f"not the path of a component: {printable(path)}")
        if path not in self.components:
            instance = path.rpartition("/")[2].rpartition(".")[0] or path
            self.components[path] = model.Component(
                id="", path_uri=f"{self.server}/{path}", instance_name=instance, is_required=True,
                location=model.Location(),
            )
        return self.components[path]

    def end(self, node, key):
        """(the model.Component, the name of the port) of an end of a connection."""
        path, colon, port = self.value(node, key).rpartition(":")
        if not colon or not port:
            self.fail(node, f"{key}: not COMPONENT:PORT")
        return self.component(node, path), port

    def take_connection(self, node):
        ends = [self.end(node, "from"), self.end(node, "to")]
        targets = [
            model.TargetPort(
                component_id="", instance_name=component.instance_name, port_name=port,
                properties=[model.Property(name=PATH_ID, value=component.path_uri)],
            )
            for component, port in ends
        ]
        name = "_".join(f"{component.instance_name}.{port}" for component, port in ends)
        if all(port.endswith("Service") for _, port in ends):
            connector = model.ServicePortConnector(connector_id=name, name=name)
        else:
            connector = self.data_connector(node, name)
        connector.ends = targets
        if name not in [connection.connector_id for connection in self.connections]:
            self.connections.append(connector)

    def data_connector(self, node, name):
        kind = self.value(node, "subscription_type", "flush")
        if kind not in SUBSCRIPTIONS:
            self.fail(node, f"subscription_type: not one of {', '.join(SUBSCRIPTIONS)}: {printable(kind)}")
        properties = []
        if kind != "flush":
            properties.append(("dataport.publisher.push_policy", self.value(node, "push_policy", "all")))
        if kind == "periodic":
            properties.append(("dataport.push_rate", self.value(node, "push_rate", RATE)))
        if "buffer_length" in node.attributes:
            properties.append(("dataport.buffer.length", self.value(node, "buffer_length")))
        return model.DataPortConnector(
            connector_id=name, name=name, interface_type="corba_cdr", dataflow_type="push",
            subscription_type=kind,
            properties=[model.Property(name=key, value=value) for key, value in properties],
        )
