"""Robots of many components, as profiles and pictures, and broken on purpose."""
import random

from rtshell_lite.views import graph
from rtshell_lite.xmlprofile import model

TYPES = [
    ("Camera", "sensing"), ("Lidar", "sensing"), ("Filter", "perception"), ("Tracker", "perception"),
    ("Planner", "planning"), ("Controller", "control"), ("Motor", "control"), ("Logger", "support"),
]
SETTINGS = {
    "default": [("gain", "1.0"), ("offset", "0"), ("frame", "base_link")],
    "fast": [("gain", "2.5"), ("offset", "0.1")],
}


def profile(components, seed=1, connections=3, each=7):
    """An RtsProfile with about `connections` of each component; `each` components are in a process."""
    chance = random.Random(seed)
    made = model.RtsProfile(id="RTSystem:Tests:large:1.0", version="0.2")
    for number in range(components):
        kind, category = TYPES[number % len(TYPES)]
        name = "%s%d" % (kind, number)
        host = "robot%d" % (1 + number * 4 // components)
        where = "%s.host_cxt/group%d/%s.rtc" % (host, number // each, name)
        made.components.append(component(name, kind, category, where))
    for number in range(components * connections):
        source = chance.randrange(components)
        step = chance.choice([1, 1, 2, 3, 5, each, -2, chance.randrange(components) - source])
        near = min(components - 1, max(0, source + step))
        if near != source:
            ends = made.components[source], made.components[near]
            made.data_port_connectors.append(connector(*ends, number))
    return made


def component(name, kind, category, where):
    context = model.ExecutionContext(id="0", kind="PERIODIC", rate=100.0)
    sets = []
    for id_, pairs in SETTINGS.items():
        data = [model.ConfigurationData(name=key, data=value) for key, value in pairs]
        sets.append(model.ConfigurationSet(id=id_, configuration_data=data))
    return model.Component(
        id="RTC:Acme:%s:%s:1.0" % (category, kind),
        path_uri="localhost/" + where,
        instance_name=name,
        active_configuration_set="default",
        is_required=True,
        configuration_sets=sets,
        execution_contexts=[context],
        data_ports=[model.DataPort(name=port) for port in ("in", "in2", "out")],
    )


def connector(source, target, number):
    ends = []
    for each, port in ((source, "out"), (target, ("in", "in2")[number % 2])):
        where = model.Property(name="COMPONENT_PATH_ID", value=each.path_uri)
        ends.append(model.TargetPort(component_id=each.id, instance_name=each.instance_name,
                                     port_name="%s.%s" % (each.instance_name, port), properties=[where]))
    pairs = [
        ("dataport.interface_type", "corba_cdr"), ("dataport.dataflow_type", "push"),
        ("dataport.subscription_type", "new"), ("dataport.data_type", "IDL:RTC/TimedLong:1.0"),
        ("dataport.serializer.cdr.endian", "little,big"), ("dataport.publisher.push_policy", "new"),
        ("dataport.buffer.length", "8"),
    ]
    made = model.DataPortConnector(
        connector_id="6f1d7c3e-0000-4000-8000-%012d" % number,
        data_type="TimedLong",
        name="%s.out_%s.in" % (source.instance_name, target.instance_name),
        interface_type="corba_cdr",
        dataflow_type="push",
        subscription_type="new",
        properties=[model.Property(name=name, value=value) for name, value in pairs],
    )
    made.ends = ends
    return made


def picture(made, broken=(), each=7):
    """The graph.Graph of a profile whose components are Active, but for those in Error."""
    states = {}
    for number, one in enumerate(made.components):
        states[one.path_uri] = "Error" if number in broken else "Active"
    found = graph.of(made, states)
    for number, box in enumerate(found.boxes):
        box.process = ("192.0.2.%d" % (1 + number * 4 // len(found.boxes)), 40000 + number // each)
    return found


# Begins every text of a hostile profile: what would end a script or a comment, and run a script, in a page.
MARKUP = (
    "</script><script>window.owned=1</script><img src=x "
    "onerror=window.owned=1><!--<b>&lt;\u2028-->javascript:owned "
)


def hostile(element):
    """The element of a profile, with MARKUP before every text in it."""
    for name, value in list(vars(element).items()):
        if isinstance(value, str) and value != "COMPONENT_PATH_ID":
            setattr(element, name, MARKUP + value)
        for inner in value if isinstance(value, list) else [value]:
            if isinstance(inner, model.Element):
                hostile(inner)
    return element
