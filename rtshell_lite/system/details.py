"""What a recording keeps of components beside the profile of their system: all that is needed to show them
again.

A list of objects in JSON, one a component: path, instance_name, type_name, description, version, vendor,
category, properties [[name, value]]; ports: name type properties interfaces [[instance, type, polarity]];
contexts: handle kind rate running properties; states {handle: state}.
"""

import json

from rtshell_lite.robot import component, ports
from rtshell_lite.system import capture


def dump(answers):
    """The octets for capture.ComponentStates that were asked for everything."""
    listed = [_component(answer) for answer in answers]
    return json.dumps(listed, sort_keys=True, ensure_ascii=True).encode("ascii")


def _component(answer):
    fields = {"path": "/" + capture.path_uri(answer.node)}
    fields.update((name, getattr(answer.profile, name)) for name in component.FACTS)
    fields["properties"] = [list(pair) for pair in answer.profile.properties]
    fields["ports"] = [_port(port, answer.profile.instance_name) for port in answer.ports]
    fields["contexts"] = [
        {
            "handle": context.handle,
            "kind": context.kind,
            "rate": context.rate,
            "running": bool(context.running),
            "properties": [list(pair) for pair in context.properties],
        }
        for context in answer.owned
    ]
    fields["states"] = {str(handle): state for handle, state in answer.states.items()}
    return fields


def _port(port, instance):
    return {
        "name": ports.short_name(port.name, instance),
        "type": port.type,
        "properties": [list(pair) for pair in port.properties.items()],
        "interfaces": [list(interface) for interface in port.interfaces],
    }
