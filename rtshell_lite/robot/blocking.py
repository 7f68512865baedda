"""Connections whose removal may end a component's process (docs/protocol.md 3.7, 3.9).

A component of C++ 2.1 ends when a connection with full_policy=block is removed while a value waits: the in
port deletes the buffer under it. So it is removed only when nothing has written to it for longer than a value
waits. It also ends when one is removed while it answers a tool that fetches its values: that the tool does
itself, when it has its answer.
"""

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.net import loop
from rtshell_lite.robot import component, places, ports
from rtshell_lite.robot.node import Node
from rtshell_lite.text import printable, shell_word

PREFIXES = ("dataport.inport.buffer.write.", "dataport.buffer.write.")  # of properties: the first counts
USUAL_WAIT = 1.0  # seconds that a value waits, where nobody has said otherwise
MORE = 1.5  # seconds until the writer has noticed that


def may_wait(properties):
    """Whether writers may wait in a connection with these properties, a dict of texts."""
    is_pushed = properties.get("dataport.dataflow_type", "push").lower() == "push"
    return is_pushed and _asked(properties, "full_policy").lower() == "block"


def _asked(properties, name):
    return next((properties[prefix + name] for prefix in PREFIXES if properties.get(prefix + name)), "")


def _longest_wait(properties):
    """Seconds that a value may wait."""
    try:
        seconds = float(_asked(properties, "timeout") or USUAL_WAIT)
    except ValueError:
        return USUAL_WAIT
    return seconds if 0 <= seconds < float("inf") else USUAL_WAIT


async def until_safe(port, connector):
    """Wait until no value waits in a Connector of a Port that is to be removed; returns at once where none
    can. Raises Refused where somebody writes to it, or fetches from it, or may.
    """
    properties = dict(connector.properties)
    if ports.is_fetched(connector):
        why = f"connection {printable(connector.id)} is that of a tool which fetches values"
        danger = f"to remove it while the tool runs may end the process of {_owner(port)}"
        cure = "first: end the tool (if it was killed: rtdis --force)"
        raise errors.Refused(ports.label(port), f"{why}: {danger}; {cure}")
    if len(connector.ports) < 2 or not may_wait(properties):
        return
    readers, writers = await _ends(port, connector)
    if not readers:
        return
    for where, states in writers:
        if isinstance(states, errors.Error):
            reason = f"and whether {where} is Active is not known ({states.why})"
            cure = "mend that"
        elif "Active" in states:
            reason = f"and {where} is Active"
            cure = f"rtdeact {shell_word(where)}"
        else:
            continue
        why = f"connection {printable(connector.id)} makes its writers wait (full_policy=block), {reason}"
        danger = f"to remove it now may end the process of {', '.join(readers)}"
        remedy = f"first: {cure} (rtdis --force removes it all the same)"
        raise errors.Refused(ports.label(port), f"{why}: {danger}; {remedy}")
    await loop.sleep(_longest_wait(properties) + MORE)


async def _ends(port, connector):
    """Who reads from a Connector, and who writes to it: ([path as text], [(path as text, its states, or the
    errors.Error that hides them)]). Ends that are gone, or have lost it, are left out.
    """
    now = await ports.port(port.node, port.ref)
    alone = now._replace(connectors=[other for other in now.connectors if other.id == connector.id])
    ends = [places.End(port.ref, alone, None), *(await places.far_ends([alone])).values()]
    readers = []
    writers = []
    for end in ends:
        if end.port is None:
            if not isinstance(end.error, (errors.Gone, errors.ConnectionRefused)):
                address = orb.at_address(end.ref)
                readers.append(address)
                writers.append((address, end.error))
        elif end.port.connectors and end.port.type == "DataInPort":
            readers.append(_owner(end.port))
        elif end.port.connectors and end.port.type == "DataOutPort":
            writers.append((_owner(end.port), await errors.or_error(_states(end.port))))
    return readers, writers


def _owner(port):
    """The path of a port's component, or its name where it is bound nowhere."""
    return str(port.node.path) if port.node is not None else printable(port.name)


async def _states(port):
    """The states of a port's component in its contexts."""
    node = port.node or Node(_owner(port), "component", port.owner)
    owned, participating = await component.context_refs(node)
    return await component.states(node, owned + participating)
