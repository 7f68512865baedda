"""Ports of components and their connectors, and why ports do not match. connectors.py changes them."""

from rtshell_lite import errors, notes
from rtshell_lite.corba import orb
from rtshell_lite.records import record
from rtshell_lite.robot import component, tree
from rtshell_lite.text import cut, from_wire, printable

# One port. `name` is the full name (ConsoleIn0.out), `type` DataInPort, DataOutPort, CorbaPort or Port,
# `properties` a dict, `owner` the reference of its component or None, `node` the Node it was found on.
Port = record("Port", "node name type properties interfaces connectors ref owner")
# polarity: Provided or Required
Interface = record("Interface", "instance_name type_name polarity")
# ports: references; properties: pairs
Connector = record("Connector", "id name ports properties")

DATA = ("DataInPort", "DataOutPort")
# Properties of connections unless the user gives others; the data type is the first port's.
DEFAULTS = (
    ("dataport.dataflow_type", "push"),
    ("dataport.interface_type", "corba_cdr"),
    ("dataport.subscription_type", "new"),
)

# where components look for the rate of a periodic connection
RATES = (
    "dataport.publisher.push_rate", "dataport.push_rate", "dataport.outport.publisher.push_rate",
    "dataport.outport.push_rate",
)
# Properties of a connection that OpenRTM-aist reads (InPortConnector, OutPortConnector, PublisherNew,
# CdrRingBuffer)
PROPERTIES = [
    "dataport." + name
    for name in (
        "buffer.length", "buffer.read.empty_policy", "buffer.read.timeout", "buffer.write.full_policy",
        "buffer.write.timeout", "data_type", "dataflow_type", "interface_type", "publisher.push_policy",
        "publisher.push_rate", "publisher.skip_count", "serializer.cdr.endian", "subscription_type",
    )
]
# of a component, of a port, of a connector; more are not taken
MOST_PORTS = 1000
MOST_PARTS = 1000
MOST_ENDS = 16
KIND = "port.port_type"  # the property that says which kind of port it is
MOST_CHOICES = 5  # in a message

ANY_CASE = ("dataport.dataflow_type", "dataport.subscription_type")  # OpenRTM 1.0 says Push and takes push


# ---- asking ----


async def ports(node, brief=False):
    """The Ports of a component in its own order: one call for the list and one a port;
    for `brief` see `port`.
    """
    return [await port(node, ref, brief=brief) for ref in await refs(node)]


# How the connectors of tools are called: ours, and those of rtshell, whose components are named like their
# connectors
TOOLS = ("rtprint", "rtinject", "rtlog", "rtmount")
NUMBERED_TOOLS = ("rtprint_reader", "rtinject_writer", "rtlog_recorder", "rtlog_player")  # those of rtshell
# these join two ports
CORBA_INTERFACES = ("", "corba_cdr", "corba_any", "data_service", "direct", "shared_memory", "csp_channel")


def is_of_tool(connector):
    """Whether a Connector was made by a tool that looks or sends, and is no part of a system.

    Its name shows that. A connector of one port alone is a tool's, too, if a CORBA interface carries its
    data: only other transports, such as ROS and DDS, connect one port alone.
    """
    name = connector.name
    if name.startswith("rtshell_lite") or name in TOOLS:
        return True
    if any(name.startswith(tool) and name[len(tool) :][:1].isdecimal() for tool in NUMBERED_TOOLS):
        return True
    return len(connector.ports) == 1 and transport(connector) == ""


def is_fetched(connector):
    """Whether values are fetched through a Connector by a tool: by one that still runs, or was killed."""
    flow = dict(connector.properties).get("dataport.dataflow_type", "")
    return len(connector.ports) == 1 and flow.lower() == "pull" and not transport(connector)


def transport(connector):
    """What carries the data of a Connector instead of CORBA, as its interface type has it (ros, fast-rtps,
    ssm); '' for CORBA.
    """
    interface = dict(connector.properties).get("dataport.interface_type", "")
    return "" if interface.lower() in CORBA_INTERFACES else interface


def in_system(listed):
    """The Ports without the connectors of tools, see `is_of_tool`."""
    return [
        port._replace(connectors=[connector for connector in port.connectors if not is_of_tool(connector)])
        for port in listed
    ]


async def refs(node):
    """References of the ports of a component."""
    listed = notes.first(MOST_PORTS, await node.call("get_ports"), node.path, "ports")
    return [orb.narrow(ref, "RTC.PortService") for ref in listed if ref is not None]


async def port(node, ref, failures=None, brief=False):
    """The Port of a reference (PortService::get_port_profile); for `failures` see `component.once_more`.

    `brief`: without interfaces, and with no property but its type: they take most of the memory.
    """
    part = KIND if brief else None
    try:
        profile = await component.once_more(
            lambda: orb.call(node.path, ref, "get_port_profile", part=part), failures
        )
    except (errors.Gone, errors.ConnectionRefused):
        if orb.endpoint(ref) == node.endpoint:
            raise
        why = (
            "the process of one of its ports is gone; if that is a member's, restart this composite's "
            "process (until then, rtcomp -r MEMBER:PORT hides the port)"
        )
        raise errors.LostMember(str(node.path), why)
    if brief:
        properties = dict(orb.properties(profile.properties, KIND))
        interfaces = []
    else:
        properties = dict(orb.properties(profile.properties))
        interfaces = notes.first(MOST_PARTS, profile.interfaces, node.path, "interfaces of a port")
    connectors = notes.first(MOST_PARTS, profile.connector_profiles, node.path, "connectors of a port")
    kind = properties.get(KIND)
    if kind not in DATA + ("CorbaPort",):
        kind = "Port"
    return Port(
        node, cut(from_wire(profile.name)), kind, properties, [_interface(i) for i in interfaces],
        [connector(c, node.path) for c in connectors], ref, orb.one_of(profile.owner, node.ref),
    )


def _interface(profile):
    polarity = ("Provided", "Required")[profile.polarity._v]
    return Interface(cut(from_wire(profile.instance_name)), cut(from_wire(profile.type_name)), polarity)


def connector(profile, where):
    """The Connector that a ConnectorProfile describes."""
    ends = notes.first(MOST_ENDS, profile.ports, where, "ends of a connector")
    return Connector(
        from_wire(profile.connector_id), cut(from_wire(profile.name)), ends,
        orb.properties(profile.properties),
    )


def short_name(name, instance):
    """A port's name without the `INSTANCE.` that components put before it."""
    if instance and name.startswith(instance + "."):
        return name[len(instance) + 1 :]
    return name


def label(port):
    """The path of a port as a user would type it, spelt for the terminal."""
    return str(port.node.path.with_port(short_name(port.name, port.node.path.instance)))


async def find(paths):
    """The Port that each path names, found in parallel, one call a port of its component.

    An errors.Error takes the place of what failed: NoSuch with what there is, and what `tree.component`
    raises.
    """
    listed = await tree.on_components([path.object() for path in paths], ports)
    return [
        answer if isinstance(answer, errors.Error) else named(path, answer)
        for path, answer in zip(paths, listed)
    ]


def named(path, listed):
    """The one of these Ports that `path` names, or the error NoSuch."""
    instance = path.instance
    exact = [port for port in listed if port.name in (path.port, instance + "." + path.port)]
    # the instance name may differ from the bound one
    same_end = [port for port in listed if port.name.endswith("." + path.port)]
    if exact or len(same_end) == 1:  # several: of members of a composite
        return (exact or same_end)[0]
    there = ", ".join(printable(short_name(port.name, instance)) for port in listed) or "none"
    return errors.NoSuch(str(path.object()), "port", f"{printable(path.port)} (its ports: {there})")


async def offered(path):
    """The Ports of the component at a Path, or the one that it names, for what a message lists; [] where they
    cannot be had.
    """
    try:
        (listed,) = await tree.on_components([path.object()], ports)
    except errors.Error:
        return []
    if isinstance(listed, errors.Error):
        return []
    if path.port is not None:
        listed = [named(path, listed)]
    return [port for port in listed if isinstance(port, Port)]


def choices(lead, labels):
    """What a message says of ports that were meant, perhaps: '; it has a.rtc:out', '' for none."""
    if not labels:
        return ""
    more = ", …" * (len(labels) > MOST_CHOICES)
    return f"; {lead} {', '.join(labels[:MOST_CHOICES])}{more}"


async def meant(paths):
    """What a message says of the ports that two Paths mean, perhaps: those that can be connected, otherwise
    those of the first Path without a port.
    """
    offers = [await offered(path) for path in paths]
    if len(paths) == 2:
        fitting = [
            f"{label(port)} {label(far)}"
            for port in offers[0]
            for far in offers[1]
            if not mismatches([port, far], {})
        ]
        if fitting:
            return choices("these fit:", fitting)
    for path, there in zip(paths, offers):
        if path.port is None:
            return choices("it has", [label(port) for port in there])
    return ""


# ---- matching ----


def between(ends):
    """What an error about several ports names: `a.rtc:out to b.rtc:in`."""
    return " to ".join(label(port) for port in ends)


def mismatches(ends, properties):
    """Why the Ports `ends` cannot be connected with these properties (a dict): a list of reasons, empty when
    they can.

    Components check hardly any of this themselves (they connect a TimedLong with a TimedDouble and
    return RTC_OK).
    """
    if len({orb.identity(port.ref) for port in ends}) < len(ends):
        return ["a port is named twice"]  # C++ 2.1 deadlocks for good on it: docs/protocol.md 3.1
    types = [port.type for port in ends]
    if all(t == "CorbaPort" for t in types):
        return _service_mismatches(ends, properties)
    if all(t in DATA for t in types):
        return _data_mismatches(ends, types, properties)
    if any(t in DATA for t in types) and "CorbaPort" in types:
        return ["a data port and a service port do not go together"]
    return []


def _data_mismatches(ends, types, properties):
    interface = properties.get("dataport.interface_type", "")
    if len(ends) == 1 and interface.lower() not in CORBA_INTERFACES:
        return _not_offered(ends, "dataport.interface_type", interface)
    if len(set(types)) == 1:
        each_is = "it is" if len(ends) == 1 else "each is"
        return [f"{each_is} a {types[0]}; a connection needs an in port and an out port"]
    reasons = []
    data_types = [port.properties.get("dataport.data_type", "") for port in ends]
    if not all(same_type(data_types[0], data_type) for data_type in data_types[1:]):
        shown = ", ".join(printable(_short_type(data_type)) for data_type in data_types)
        reasons.append(f"data types differ ({shown})")
    for key, value in sorted(properties.items()):
        reasons += _not_offered(ends, key, value)
    for key, _ in DEFAULTS:
        if key not in properties and _chosen(ends, key, None) == "":
            offers = "; ".join(_offer(port, key) for port in ends)
            reasons.append(f"no {_short_key(key)} in common ({offers})")
    return reasons


def _offer(port, key):
    """The values that a port offers for a property, for a message."""
    return printable(",".join(_choices(port, key) or ["any"]))


def _not_offered(ends, key, value):
    """Why some of the ports do not take this value of a property."""
    offers_without = [(port, offer_without(port, key, value)) for port in ends]
    lacking = [(port, offer) for port, offer in offers_without if offer is not None]
    what = f"{_short_key(key)} {printable(value)}"
    offers = {offer for _, offer in lacking}
    if len(lacking) == len(ends) > 1 and len(offers) == 1:
        return [f"no port has {what} (all have: {lacking[0][1]})"]
    return [f"{label(port)} has no {what} (it has: {offer})" for port, offer in lacking]


def offer_without(port, key, value):
    """The values that a port offers for a property, spelt for the terminal; None if `value` is one of
    them.
    """
    offer = _choices(port, key)
    if offer is None or value in offer:
        return None
    return printable(", ".join(offer))


def _short_key(key):
    return key[len("dataport.") :] if key.startswith("dataport.") else key


def _short_type(type_id):
    """RTC/TimedLong of IDL:RTC/TimedLong:1.0."""
    name = type_id[4:] if type_id.startswith("IDL:") else type_id
    return name.rpartition(":")[0] or name


def same_type(type_id, other):
    """Repository ids name one type when their last parts agree and, where both have modules,
    the modules too.
    """
    type_id = _short_type(type_id).split("/")
    other = _short_type(other).split("/")
    if "any" in (type_id[-1].lower(), other[-1].lower()) or [""] in (type_id, other):
        return True
    if len(type_id) > 1 and len(other) > 1:
        return type_id == other
    return type_id[-1] == other[-1]


def _choices(port, key):
    """The values that a port allows for a property, None if it allows any or lists none."""
    listed = port.properties.get(key)
    if listed is None or key == "dataport.data_type":
        return None
    values = [value.strip() for value in listed.split(",")]
    if key in ANY_CASE:
        values = [value.lower() for value in values]
    if any(value.lower() == "any" for value in values):
        return None
    return values


def _chosen(ends, key, preferred):
    """The preferred value when all ports allow it, else the first that they have in common, else ''."""
    lists = [choices for choices in (_choices(port, key) for port in ends) if choices is not None]
    if not lists or all(preferred in choices for choices in lists):
        return preferred
    return next((value for value in lists[0] if all(value in choices for choices in lists)), "")


def _service_mismatches(ends, properties):
    reasons = []
    first, *others = ends
    for interface in first.interfaces:
        for port in others:
            if any(
                word.endswith("." + interface.instance_name) for item in properties.items() for word in item
            ):
                continue  # mapped by hand to an interface of another name
            named = [i for i in port.interfaces if i.instance_name == interface.instance_name]
            if not named:
                reasons.append(f"{label(port)} has no interface {printable(interface.instance_name)}")
            elif all(i.polarity == interface.polarity for i in named):
                reasons.append(
                    f"both have interface {printable(interface.instance_name)} {interface.polarity.lower()}"
                )
    return reasons


def connection_properties(ends, given):
    """The properties to connect with: those given (a dict), and defaults that all of the ports allow."""
    properties = dict(given)
    if ends[0].type == "CorbaPort":
        properties.setdefault(KIND, "CorbaPort")
    elif ends[0].type in DATA:
        for key, preferred in DEFAULTS:
            properties.setdefault(key, _chosen(ends, key, preferred))
        properties.setdefault("dataport.data_type", ends[0].properties.get("dataport.data_type", ""))
    return properties


def joining(ends):
    """The connectors of the first port that join it with any of the others."""
    own, *others = [orb.identity(port.ref) for port in ends]
    connectors = []
    for connector in ends[0].connectors:
        joined = [orb.identity(ref) for ref in connector.ports if ref is not None]
        if own in joined:  # once is the first port itself, which may be named again
            joined.remove(own)
        if any(port in others for port in joined):
            connectors.append(connector)
    return connectors


def check(ends, given):
    """Raise Mismatch with the reasons when the Ports `ends` do not match, with these properties (a dict)."""
    reasons = mismatches(ends, given) or without_rate(ends, connection_properties(ends, given))
    if reasons:
        raise errors.Mismatch(between(ends), "; ".join(reasons))


def without_rate(ends, properties):
    """Why a connection with these properties lacks a rate that it needs: a list of one reason, or [].

    C++ only returns RTC_ERROR then. The rate may be a property of the port, too.
    """
    subscription = properties.get("dataport.subscription_type", "").lower()
    flow = properties.get("dataport.dataflow_type", "").lower()
    has_writer = any(port.type == "DataOutPort" for port in ends)
    if subscription != "periodic" or flow == "pull" or not has_writer:
        return []
    rates = []
    for given in [properties] + [port.properties for port in ends]:
        rates += [given[key] for key in RATES if key in given]
    if not rates:
        return [f"a periodic connection needs a rate: {RATES[0]}=HZ"]
    try:
        positive = 0 < float(rates[0]) < float("inf")
    except ValueError:
        positive = False
    if positive:
        return []
    return [f"a periodic connection needs a rate in Hz above 0, not {printable(rates[0])}"]
