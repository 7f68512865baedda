"""Service connections: whether each consumer in them finds a provider. Components connect anything, and say RTC_OK."""
from rtshell_lite.robot import ports
from rtshell_lite.text import printable

NOBODY = ("null", "nil")  # what a mapping says that leaves a consumer without a provider on purpose


def mismatches(found, properties):
    """Why a connection of the service Ports `found` is of no use: a list of reasons, empty when each consumer is served.

    `properties` are those of the connection, a dict: in them the consumers look for what providers have published
    (protocol.md 10). A consumer that another connection of its port serves is well. Ports that list no interfaces say nothing.
    """
    if not all(each.interfaces for each in found):
        return []
    wanting = [(each, one) for each in found for one in each.interfaces if one.polarity == "Required"]
    if not wanting:
        return ["each end provides something, and none requires anything"]
    return ["nobody in it provides interface %s (%s), which %s requires" % (
        printable(one.instance_name), printable(one.type_name), ports.label(each)) for each, one in wanting
        if not _served(one, properties) and not any(_served(one, dict(other.properties)) for other in each.connectors)]


def _served(interface, properties):
    """True when the properties of a connection name a provider for a required interface."""
    name = f"{interface.type_name}.{interface.instance_name}"
    mapped = [value for key, value in properties.items() if key.endswith(".required." + name)]
    if mapped:
        return mapped[0] in NOBODY or mapped[0] in properties
    return "port." + name in properties
