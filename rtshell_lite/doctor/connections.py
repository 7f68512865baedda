"""Each connection, seen from all its ends: whether they live, know it and agree on its properties."""

import collections

from rtshell_lite import errors
from rtshell_lite.corba import orb, refusals, session
from rtshell_lite.doctor import limits, networks, remedies, services, waiting
from rtshell_lite.doctor.finding import fail, listed, reason, warn
from rtshell_lite.robot import component, connectors, places, ports
from rtshell_lite.system import capture
from rtshell_lite.text import printable, shell_word

# One connection as its first end has it: the Snapshot of a component, its ports.Port, the ports.Connector.
Link = collections.namedtuple("Link", "snapshot port connector")

SETTLED = [key for key, _ in ports.DEFAULTS]  # what ports agree on when they are connected


async def findings(snapshots, ends, culprits):
    """Findings on all connections of the components, sorted by path.

    `ends` are those of `all_ends`, `culprits` those of waiting.culprits. A connection with trouble is looked
    at twice: it may just be changing.
    """
    links = _links(snapshots)
    all_findings = []
    for link in links:
        troubles = await _troubles(link, ends, culprits)
        if troubles:
            again = await _again(link, ends)
            troubles = await _troubles(again, ends, culprits) if again else []
        all_findings += troubles
    return sorted(
        all_findings + await _forgotten(snapshots) + _unserved(snapshots), key=lambda finding: finding.path
    )


async def _forgotten(snapshots):
    """Findings on connectors of tools that were killed: what they served, as their properties have it, is
    certainly gone.

    Of a tool that serves nothing, as one that sends, nobody can know whether it still runs.
    """
    held = [
        (snapshot, port, connector, ref)
        for snapshot in snapshots
        for port, connector in snapshot.of_tools
        for ref in _served(snapshot, port, connector)
    ]
    findings = []
    for (snapshot, port, connector, ref), answer in zip(
        held, await session.each([ref for *_, ref in held], lambda ref: orb.is_alive("", ref), orb.at_object)
    ):
        is_dead = isinstance(answer, errors.Error) and await refusals.shows_death(answer, orb.endpoint(ref))
        if is_dead and await networks.is_certain(ref, await networks.homes_of(snapshot.node.ref)):
            message = f"connection {_called(connector)} was left by a tool that is gone"
            cure = remedies.command("disconnect", id=connector.id, port=ports.label(port))
            findings.append(warn("connection", ports.label(port), message, cure))
    return findings


def _served(snapshot, port, connector):
    """References in a connector's properties to what is not in the process of the component itself."""
    for _, value in connector.properties:
        try:
            ref = orb.from_text(ports.label(port), value) if value.startswith("IOR:") else None
        except errors.Unreachable:
            continue
        if ref is not None and orb.endpoint(ref) != snapshot.node.endpoint:
            yield ref


def _unserved(snapshots):
    """Findings on consumers without a connection, for which there is a provider that nobody uses: one of them
    was started again.

    Only those that have lost a connection, or whose component is Active: others may be on their way.
    """
    free = [
        (snapshot, port)
        for snapshot in snapshots
        for port in snapshot.ports
        if port.type == "CorbaPort" and not port.connectors
    ]
    findings = []
    for snapshot, port in free:
        if port not in snapshot.dropped and component.merged(snapshot.states) != "Active":
            continue
        required = {interface.type_name for interface in port.interfaces if interface.polarity == "Required"}
        fitting = [
            ports.label(other)
            for _, other in free
            for interface in other.interfaces
            if interface.polarity == "Provided" and interface.type_name in required
        ]
        if fitting:
            message = (
                f"requires {printable(' and '.join(sorted(required)))} and is not connected, though "
                f"{listed(fitting)} provides it to nobody"
            )
            where = ports.label(port)
            ends = {"one": shell_word(where), "other": shell_word(fitting[0])}
            findings.append(warn("connection", where, message, remedies.words("connect provider", **ends)))
    return findings


def _links(snapshots):
    """A Link for each connection, once; composites show ports of their members as their own."""
    links = collections.OrderedDict()
    for snapshot in snapshots:
        for port in snapshot.ports:
            for connector in port.connectors:
                links.setdefault((connector.id, _identities(connector)), Link(snapshot, port, connector))
    return list(links.values())


def _identities(connector):
    return frozenset(_refs(connector))


def _refs(connector):
    """{identity: reference} of the ends of a connection, each once, however often it is listed."""
    return collections.OrderedDict((orb.identity(ref), ref) for ref in connector.ports if ref is not None)


async def all_ends(snapshots):
    """{identity of a port: places.End} of all ports of the components, and of those connected with them,
    which are asked, one call each.
    """
    own = [port for snapshot in snapshots for port in snapshot.ports]
    answering = {snapshot.node.endpoint for snapshot in snapshots if snapshot.answered}
    silent = {
        snapshot.node.endpoint: snapshot.error
        for snapshot in snapshots
        if isinstance(snapshot.error, errors.Unanswered) and snapshot.node.endpoint not in answering
    }
    ends = await places.far_ends(own, silent)
    for port in own:
        ends.setdefault(orb.identity(port.ref), places.End(port.ref, port, None))
    return ends


def _name(end):
    if end.port is not None and end.port.node is not None:
        return ports.label(end.port)
    address = orb.at_address(end.ref)
    if end.port is None:
        return address
    return f"{printable(end.port.name)} at {address}, bound nowhere,"


async def _again(link, ends):
    """The same Link after its ports were asked again, None when it is gone or has other ends now;
    updates `ends`.
    """
    refs = _refs(link.connector)
    own = link.port
    asked = [identity for identity in refs if ends[identity].port is not None]
    joining = dict.fromkeys(asked, {link.connector.id})
    refs_asked = [refs[identity] for identity in asked]
    for identity, answer in zip(asked, await places.ask(refs_asked, joining)):
        before = ends[identity]
        if isinstance(answer, errors.Error):
            ends[identity] = before._replace(port=None, error=answer)
            continue
        ends[identity] = before._replace(port=answer._replace(node=before.port.node))
        if identity == orb.identity(link.port.ref):
            own = ends[identity].port
    now = next((connector for connector in own.connectors if connector.id == link.connector.id), None)
    # gone, or made again with other ends: just changing
    if now is None or _identities(now) != _identities(link.connector):
        return None
    return Link(link.snapshot, own, now)


# ---- what can be wrong ----


async def _troubles(link, ends, culprits):
    where = ports.label(link.port)
    connector = link.connector
    undo = remedies.command("disconnect", id=connector.id, port=where)
    if None in connector.ports:
        return [
            fail(
                "connection", where, f"connection {_called(connector)} has an end that is nothing (nil)", undo
            )
        ]
    others = [
        ends[identity] for identity, ref in _refs(connector).items() if not orb.same(ref, link.port.ref)
    ]
    troubles = []
    for end in others:
        if end.port is None:
            troubles.append(await _lost(link, where, end, undo, culprits))
        elif connector.id not in [connector.id for connector in end.port.connectors]:
            message = f"connection {_called(connector)} is one-sided: {_name(end)} does not know it"
            troubles.append(fail("connection", where, message, _redo(link, others)))
        else:
            troubles += _differences(link, end, _redo(link, others))
            if end.port.node is None:
                far_end = f"{printable(end.port.name)} at {orb.at_address(end.ref)}"
                message = (
                    f"the far end of connection {_called(connector)}, {far_end}, lives, but is bound in no "
                    "name server that is known here"
                )
                cure = remedies.words("unbound", path=shell_word(where))
                troubles.append(warn("connection", where, message, cure))
    if all(end.port is not None for end in others):
        troubles += _mismatches(link, where, [link.port] + [end.port for end in others], undo)
    return troubles


def _called(connector):
    return printable(connector.name or connector.id)


def _redo(link, others):
    """The Remedy that connects all ends again as this one knows it; words where an end has no path."""
    where = ports.label(link.port)
    connector = link.connector
    if any(end.port is None or end.port.node is None for end in others):
        return remedies.reconnect(connector.id, where, None)
    given = {key: value for key, value in connector.properties if key in SETTLED}
    ends = [link.port] + [end.port for end in others]
    labels = [ports.label(port) for port in ends]
    return remedies.reconnect(connector.id, where, connectors.command(labels, connector.name, "", given))


async def _lost(link, where, end, undo, culprits):
    """The far end of a connection does not answer."""
    if isinstance(end.error, errors.NoTime):
        return limits.late("connection", where)
    name = _name(end)
    endpoint = orb.endpoint(end.ref)
    if isinstance(end.error, errors.NotAsked):
        message = f"the far end of a connection, at {name}, was {reason(end.error)}"
        cure = remedies.not_asked(end.error, where)
        return warn("connection", where, message, cure, waiting.blamed(endpoint, culprits))
    homes = await networks.homes_of(link.snapshot.node.ref)
    misled = await networks.misled("connection", where, end.ref, homes)
    if misled and misled.level == "fail":
        return misled._replace(message="the far end of a connection " + misled.message)
    if await refusals.shows_death(end.error, endpoint) and await networks.is_certain(end.ref, homes):
        return fail("connection", where, f"the far end of a connection is dead (at {name})", undo)
    if isinstance(end.error, errors.ConnectionRefused):
        message = f"the far end of a connection, at {name}, refuses: dead, or a firewall closes this port"
        return fail("connection", where, message, remedies.words("firewall", port=endpoint[1]))
    if await remedies.is_of_network(end.error, endpoint):
        message = (
            f"cannot tell from here whether the far end of a connection, at {name}, lives "
            f"({reason(end.error)})"
        )
        return fail("connection", where, message, remedies.network(endpoint))
    message = f"the far end of a connection, at {name}, cannot be asked ({reason(end.error)})"
    cause = None
    if isinstance(end.error, errors.Silent):
        cause = waiting.blamed(endpoint, culprits)
    cure = await remedies.of_silence(
        end.error, endpoint, where, remedies.words("restart its process", port=endpoint[1])
    )
    return fail("connection", where, message, cure, cause)


def _differences(link, end, remedy):
    """Properties on which the two ends of a connection differ."""
    where = ports.label(link.port)
    connector = link.connector
    own = [other for other in end.port.connectors if other.id == connector.id]
    far = dict(own[0].properties)
    near = dict(connector.properties)
    differing = []
    keys = set(near) & set(far)
    keys.update(key for key in SETTLED if key in near or key in far)
    for key in sorted(keys):
        here = near.get(key)
        there = far.get(key)
        if _is_reference(key, here) or _is_reference(key, there) or _plain(key, here) == _plain(key, there):
            continue
        message = f"{printable(key)} is {_shown(here)} here, {_shown(there)} at {_name(end)}"
        differing.append(warn("connection", where, message, remedy))
    return differing


def _is_reference(key, value):
    """Object references differ in spelling,
    and some implementations turn them into the text of a Python object.
    """
    return capture.is_reference(key, value) or (value or "").startswith("<")


def _plain(key, value):
    return value.lower() if value is not None and key in ports.ANY_CASE else value


def _shown(value):
    if value is None:
        return "missing"
    return printable(value) or "empty"


def _mismatches(link, where, joined, undo):
    """Why these ports should not be connected in this way (components themselves connect nearly
    everything).
    """
    if any(port.node is None for port in joined):
        return []
    properties = {key: _plain(key, value) for key, value in link.connector.properties if key in SETTLED}
    if properties.get("dataport.dataflow_type") == "pull":
        properties.pop("dataport.subscription_type", None)  # it has no effect then
    reasons = []
    if any(port.type in ports.DATA for port in joined):
        reasons = ports.mismatches(joined, properties)
    elif link.port.type == "CorbaPort":
        reasons = services.mismatches(joined, dict(link.connector.properties))
    far = ", ".join(ports.label(port) for port in joined[1:])
    return [fail("connection", where, f"connected to {far}: {why}", undo) for why in reasons]
