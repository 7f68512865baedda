"""Service connections: whether each consumer in them finds a provider.
Components connect anything, and return RTC_OK.
"""

from rtshell_lite.robot import ports
from rtshell_lite.text import printable

NOBODY = ("null", "nil")  # maps a consumer to no provider, on purpose


def mismatches(ends, properties):
    """Why a connection of the service Ports `ends` is of no use: a list of reasons, empty when each consumer
    is served.

    `properties` are those of the connection, a dict: in them the consumers look for what providers have
    published (protocol.md 10). Another connection of its port may serve a consumer. Nothing is known of ports
    that list no interfaces, nor of who is at the other side of one that is connected alone.
    """
    if len(ends) == 1 or not all(port.interfaces for port in ends):
        return []
    wanting = [
        (port, interface)
        for port in ends
        for interface in port.interfaces
        if interface.polarity == "Required"
    ]
    if not wanting:
        return ["each end provides something, and none requires anything"]
    lines = []
    for port, interface in wanting:
        candidates = [properties] + [dict(connector.properties) for connector in port.connectors]
        if not any(_served(interface, candidate) for candidate in candidates):
            lines.append(
                f"nobody in it provides interface {printable(interface.instance_name)} "
                f"({printable(interface.type_name)}), which {ports.label(port)} requires"
            )
    return lines


def _served(interface, properties):
    """True when the properties of a connection name a provider for a required interface."""
    name = f"{interface.type_name}.{interface.instance_name}"
    mapped = [value for key, value in properties.items() if key.endswith(".required." + name)]
    if mapped:
        return mapped[0] in NOBODY or mapped[0] in properties
    return "port." + name in properties
