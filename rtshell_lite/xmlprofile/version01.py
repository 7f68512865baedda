"""Turns nodes of xml.py of an RtsProfile 0.1 into those of 0.2.

In 0.1 a connection is inside its source port and names only its target, and a component holds its own
conditions for starting up. Names that differ only in spelling are handled by the fields.
"""

import re

from rtshell_lite.xmlprofile import model, names

RTS = names.NAMESPACES["rts"] + names.SEPARATOR
_SECTIONS = {field.local for field in model.SECTIONS}
_CONNECTORS = {"DataPortConnectors": "sourceDataPort", "ServicePortConnectors": "sourceServicePort"}
MOST_COPIES = 250000  # values of a section that are copied into its conditions
_DURATION = re.compile(
    r"P(?:(\d{1,6})D)?(?:T(?:(\d{1,6})H)?(?:(\d{1,6})M)?(?:(\d{1,9}(?:\.\d{1,9})?)S)?)?\Z", re.ASCII
)


def upgrade(root, fail):
    """Change the nodes below `root`. fail(node, reason) raises."""
    hoist = _Hoist(root, fail)
    for node in root.children():
        if node.local in ("Component", "Components"):
            _split_participants(node)
            _hoist_connectors(root, node)
            hoist.conditions(node)
    if root.attributes.get(RTS + "version", "").strip() == "0.1":
        root.attributes[RTS + "version"] = "0.2"


def _value(node, name):
    """An attribute, with or without its namespace."""
    return node.attributes.get(RTS + name, node.attributes.get(name, ""))


def _split_participants(component):
    """0.1 has all members of a composite component in one element, 0.2 has an element for each."""
    content = []
    for node in component.content:
        content.append(node)
        if not isinstance(node, str) and node.local == "Participants":
            members = [child for child in node.children() if child.local == "Participant"]
            _remove(node, members[1:])
            content += [_node(node, "Participants", content=[member]) for member in members[1:]]
    component.content = content


def _node(like, local, attributes=None, content=()):
    """A new node at the position of the node `like`."""
    node = type(like)(RTS + local, attributes or {}, like.line, like.column)
    node.content = list(content)
    return node


def _remove(node, children):
    """Remove children of a node, together: there may be 100,000 of them."""
    gone = set(children)
    if gone:
        node.content = [child for child in node.content if child not in gone]


def _owner(component):
    return {
        RTS + "componentId": _value(component, "id"),
        RTS + "instanceName": _value(component, "instanceName"),
    }


def _hoist_connectors(root, component):
    for port in component.children():
        if port.local not in ("DataPorts", "ServicePorts"):
            continue
        connectors = [node for node in port.children() if node.local in _CONNECTORS]
        _remove(port, connectors)
        for connector in connectors:
            source = dict(_owner(component), **{RTS + "portName": _value(port, "name")})
            connector.content.insert(0, _node(port, _CONNECTORS[connector.local], source))
            root.content.append(connector)


class _Hoist:
    """Moves the conditions of components into the sections of the whole system."""

    def __init__(self, root, fail):
        self.root = root
        self.fail = fail
        self.sections = {node.local: node for node in reversed(root.children()) if node.local in _SECTIONS}
        self.copies = 0

    def conditions(self, component):
        sections = [node for node in component.children() if node.local in _SECTIONS]
        _remove(component, sections)
        for section in sections:
            conditions = [node for node in section.children() if node.local == "Condition"] or [
                _node(section, "Condition")
            ]
            others = [node for node in section.children() if node.local != "Condition"]
            self.copies += len(conditions) * (len(others) + len(section.attributes))
            if self.copies > MOST_COPIES:
                self.fail(section, "more than %d values for conditions" % MOST_COPIES)
            target = _node(section, "TargetComponent", dict(_owner(component), **{RTS + "id": ""}))
            for condition in conditions:
                for node in condition.children():
                    if node.local == "WaitTime":
                        _milliseconds(node, self.fail)
                self._system_section(section).content.append(
                    _node(
                        section, "targets", dict(section.attributes), condition.children() + others + [target]
                    )
                )

    def _system_section(self, section):
        """The section of the whole system with the name of a component's section."""
        if section.local not in self.sections:
            self.sections[section.local] = _node(section, section.local)
            self.root.content.append(self.sections[section.local])
        return self.sections[section.local]


def _milliseconds(wait, fail):
    """0.1 has a duration such as PT1.5S as the text of the element, 0.2 has milliseconds in an attribute."""
    text = "" if wait.children() else "".join(wait.content).strip()
    if not text:
        return
    duration = _DURATION.match(text)
    if not duration:
        fail(wait, "WaitTime: not a duration such as PT1.5S")
    days, hours, minutes, seconds = (float(part or 0) for part in duration.groups())
    hours += days * 24
    minutes += hours * 60
    seconds += minutes * 60
    milliseconds = int(round(1000 * seconds))
    wait.attributes = dict(wait.attributes, **{RTS + "waitTime": str(milliseconds)})
    wait.content = []
