"""What a recording keeps of components beside the profile of their system: all that is needed to show them
again.

A list of objects in JSON, one a component: path, instance_name, type_name, description, version, vendor,
category, properties [[name, value]]; ports: name type properties interfaces [[instance, type, polarity]];
contexts: handle kind rate running properties; states {handle: state}.
"""

import json

from rtshell_lite.robot import component, ports
from rtshell_lite.system import capture


def dump(found):
    """The octets for capture.ComponentStates that were asked for everything."""
    listed = [_component(each) for each in found]
    return json.dumps(listed, sort_keys=True, ensure_ascii=True).encode("ascii")


def _component(each):
    made = {"path": "/" + capture.path_uri(each.node)}
    made.update((name, getattr(each.profile, name)) for name in component.FACTS)
    made["properties"] = [list(pair) for pair in each.profile.properties]
    made["ports"] = [_port(port, each.profile.instance_name) for port in each.ports]
    made["contexts"] = [
        {
            "handle": context.handle,
            "kind": context.kind,
            "rate": context.rate,
            "running": bool(context.running),
            "properties": [list(pair) for pair in context.properties],
        }
        for context in each.owned
    ]
    made["states"] = {str(handle): state for handle, state in each.states.items()}
    return made


def _port(port, instance):
    return {
        "name": ports.short_name(port.name, instance),
        "type": port.type,
        "properties": [list(pair) for pair in port.properties.items()],
        "interfaces": [list(interface) for interface in port.interfaces],
    }
