"""RtsProfile 0.1 as 0.2: moves what stands elsewhere there. Works on nodes of xml.py, which a table of fields reads then.

In 0.1 a connection stands inside its source port and names its target alone, and a component holds its own conditions
for starting up; names that differ only in spelling are understood by the fields themselves.
"""
import re

from rtshell_lite.xmlprofile import model, names

RTS = names.NAMESPACES["rts"] + names.SEPARATOR
_SECTIONS = {field.local for field in model.SECTIONS}
_CONNECTORS = {"DataPortConnectors": "sourceDataPort", "ServicePortConnectors": "sourceServicePort"}
_DURATION = re.compile(r"P(?:(\d{1,6})D)?(?:T(?:(\d{1,6})H)?(?:(\d{1,6})M)?(?:(\d{1,9}(?:\.\d{1,9})?)S)?)?\Z", re.ASCII)


def upgrade(root, fail):
    """Change the nodes below `root` in place. fail(node, reason) raises."""
    for node in root.children():
        if node.local in ("Component", "Components"):
            _split_participants(node)
            _hoist_connectors(root, node)
            _hoist_conditions(root, node, fail)
    if root.attributes.get(RTS + "version", "").strip() == "0.1":
        root.attributes[RTS + "version"] = "0.2"


def _value(node, name):
    """An attribute, with or without its namespace."""
    return node.attributes.get(RTS + name, node.attributes.get(name, ""))


def _split_participants(component):
    """0.1 puts all members of a composite component into one element, 0.2 each into its own."""
    content = []
    for node in component.content:
        members = [] if isinstance(node, str) or node.local != "Participants" else \
            [child for child in node.children() if child.local == "Participant"]
        for member in members[1:]:
            node.content.remove(member)
        content.append(node)
        content += [_node(node, "Participants", content=[member]) for member in members[1:]]
    component.content = content


def _node(like, local, attributes=None, content=()):
    """A new node, which stands where the node `like` stood."""
    node = type(like)(RTS + local, attributes or {}, like.line, like.column)
    node.content = list(content)
    return node


def _owner(component):
    return {RTS + name: value for name, value in (("componentId", _value(component, "id")),
                                                  ("instanceName", _value(component, "instanceName")))}


def _hoist_connectors(root, component):
    for port in component.children():
        if port.local not in ("DataPorts", "ServicePorts"):
            continue
        for connector in [node for node in port.children() if node.local in _CONNECTORS]:
            port.content.remove(connector)
            source = dict(_owner(component), **{RTS + "portName": _value(port, "name")})
            connector.content.insert(0, _node(port, _CONNECTORS[connector.local], source))
            root.content.append(connector)


def _hoist_conditions(root, component, fail):
    for section in [node for node in component.children() if node.local in _SECTIONS]:
        component.content.remove(section)
        target = dict(_owner(component), **{RTS + "id": ""})
        conditions = [node for node in section.children() if node.local == "Condition"]
        others = [node for node in section.children() if node.local != "Condition"]
        place = [node for node in root.children() if node.local == section.local] or [_node(section, section.local)]
        if place[0] not in root.content:
            root.content.append(place[0])
        for condition in conditions or [_node(section, "Condition")]:
            for node in condition.children():
                if node.local == "WaitTime":
                    _milliseconds(node, fail)
            place[0].content.append(_node(section, "targets", dict(section.attributes), condition.children() + others + [
                _node(section, "TargetComponent", target)]))


def _milliseconds(wait, fail):
    """0.1 gives a duration such as PT1.5S as the text of the element, 0.2 milliseconds as an attribute."""
    text = "".join(wait.content).strip() if not wait.children() else ""
    if not text:
        return
    found = _DURATION.match(text)
    if not found:
        fail(wait, "WaitTime: not a duration such as PT1.5S")
    days, hours, minutes, seconds = (float(part or 0) for part in found.groups())
    milliseconds = int(round(1000 * (((days * 24 + hours) * 60 + minutes) * 60 + seconds)))
    wait.attributes = dict(wait.attributes, **{RTS + "waitTime": str(milliseconds)})
    wait.content = []
