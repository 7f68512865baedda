"""Connectors between ports: connect, disconnect, and what refuses it."""

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.robot import blocking, component, ports
from rtshell_lite.text import from_wire, printable, shell_word, to_wire

PROFILE = "RTC.ConnectorProfile"


def refuse_duplicate(ends, name, connector_id):
    """Raise Failed if the first port is connected with any of the others,
    or any has a connection of this name or id.
    """
    for port, connector in [(port, connector) for port in ends for connector in port.connectors]:
        for what, expected, value in (("id", connector_id, connector.id), ("name", name, connector.name)):
            if expected and expected == value:
                why = f"has a connection with {what} {printable(value)} already"
                raise errors.Failed(ports.label(port), why)
    for connector in ports.joining(ends):
        raise errors.Failed(ports.between(ends), f"already connected (id {printable(connector.id)})")


def existing(ends, name="", connector_id="", given=None):
    """The Connector that joins just the Ports `ends`, None if they are not joined.

    Raises Failed where there are only others than the one that is asked for: of another name or id, or with
    other properties.
    """
    identities = {orb.identity(port.ref) for port in ends}
    others = []
    for connector in ends[0].connectors:
        if {orb.identity(ref) for ref in connector.ports if ref is not None} != identities:
            continue
        differing = _differing(connector, name, connector_id, given or {})
        if not differing:
            return connector
        others.append((connector, f"id {printable(connector.id)}: {', '.join(differing)}"))
    if not others:
        return None
    why = f"connected otherwise ({'; '.join(differences for _, differences in others)})"
    if len(others) == 1:
        why += f"; to change that, first: {_removal(ends, others[0][0])}"
    raise errors.Failed(ports.between(ends), why)


def _differing(connector, name, connector_id, given):
    """What a Connector has, each as text, where something else is asked for."""
    properties = dict(connector.properties)
    has = [("id", connector.id, connector_id), ("name", connector.name, name)]
    has += [(key, properties.get(key, ""), value) for key, value in sorted(given.items())]
    return [
        f"its {key} is {printable(now) or 'empty'}" for key, now, asked in has if asked and asked != now
    ]


def command(labels, name, connector_id, given):
    """The rtcon command for a connection of the ports at these paths (texts, see `ports.label`),
    ready for a shell.
    """
    words = ["rtcon"]
    if name:
        words += ["-n", name]
    if connector_id:
        words += ["-i", connector_id]
    for item in sorted(given.items()):
        words += ["-p", "=".join(item)]
    return " ".join(shell_word(word) for word in words + labels)


async def connect(ends, name="", connector_id="", given=None):
    """Connect the Ports `ends` (one or more) and return the Connector made, named after them in this order.

    Out ports come first in its profile, as the ports disconnect in that order: an in port that does so first
    waits for the out port while values are on their way. An active source of C++ 2.1 at 100 Hz died of that
    in one of 230 disconnects, in one of 1,300 otherwise. Raises Refused with the reasons when they do not
    match or the components refuse, and Unreachable.
    """
    given = given or {}
    ports.check(ends, given)
    name = name or ports.short_name(ends[0].name, ends[0].node.path.instance) + "_".join(
        ports.short_name(port.name, port.node.path.instance) for port in ends[1:]
    )
    refs = [port.ref for port in sorted(ends, key=lambda port: port.type == "DataInPort")]
    asked = orb.struct(PROFILE)(
        to_wire(name), to_wire(connector_id), refs,
        orb.nvlist(sorted(ports.connection_properties(ends, given).items())),
    )
    code, raw = await orb.call(ports.between(ends), refs[0], "connect", asked)
    if str(code) != "RTC_OK":
        await _tidy(ends)
        why = _why_refused(str(code), ends, connector_id, given)
        raise errors.Refused(ports.between(ends), why, name=str(code))
    return ports.connector(raw, ports.between(ends))


async def connect_alone(port, name, properties):
    """Connect one data port with no other, as tools do, and return the Connector.
    Raises Refused, Unreachable.
    """
    for reason in ports.without_rate([port], properties):
        raise errors.Mismatch(ports.label(port), reason)
    values = orb.nvlist(sorted(properties.items()))
    asked = orb.struct(PROFILE)(to_wire(name), "", [port.ref], values)
    code, raw = await orb.call(ports.label(port), port.ref, "connect", asked)
    if str(code) != "RTC_OK":
        raise errors.Refused(ports.label(port), f"refused by the component ({code})", name=str(code))
    return ports.connector(raw, ports.label(port))


def _why_refused(code, ends, connector_id, given):
    already = ports.joining(ends)
    if code == "PRECONDITION_NOT_MET" and already:
        return _already_connected(ends, already[0], given)
    if code == "PRECONDITION_NOT_MET" and connector_id:
        return f"refused; id {printable(connector_id)} is in use, or the component takes no ids (RtORB)"
    also = f"; it is connected already (id {printable(already[0].id)})" if already else ""
    return f"refused by the component ({code}){also}"


def _already_connected(ends, connector, given):
    """What to say of the Connector that joins the Ports, and what to do where another was asked for."""
    connector_id = printable(connector.id)
    differing = _differing(connector, "", "", given)
    if not differing:
        return f"already connected (id {connector_id})"
    why = f"already connected (id {connector_id}: {', '.join(differing)})"
    return f"{why}; to change that, first: {_removal(ends, connector)}"


def _removal(ends, connector):
    """The command that removes the Connector from the Ports."""
    return " ".join(map(shell_word, ("rtdis", "-i", connector.id, ports.label(ends[0]))))


async def _tidy(ends):
    """Remove what a failed connect left: components of Python keep half a connection on the in port."""
    for port in ends:
        try:
            now = await ports.port(port.node, port.ref)
            for connector in now.connectors:
                if connector.id not in [c.id for c in port.connectors] and ports.joining(
                    [now._replace(connectors=[connector])] + [end for end in ends if end is not port]
                ):
                    await orb.call(ports.label(port), port.ref, "notify_disconnect", to_wire(connector.id))
        except errors.Error:
            pass  # the refusal itself is what the user has to know


async def disconnect(port, connector, is_forced=False):
    """Remove a Connector of a Port. Done when the port no longer has it, whatever the far end answers.

    `is_forced`: also where that may end the process of an in port, see blocking.py. Raises Refused.
    """
    if not is_forced:
        await blocking.until_safe(port, connector)
    connector_id = to_wire(connector.id)
    # the second reaches this end alone, for a dead far end
    for operation in ("disconnect", "notify_disconnect"):
        failure = await _forgetting_failed(port, operation, connector_id)
        if failure is None:
            return
        left = await component.once_more(
            lambda: orb.call(ports.label(port), port.ref, "get_connector_profiles")
        )
        if connector_id not in [c.connector_id for c in left]:
            await _forget_elsewhere(port, connector)
            return
    raise failure


async def _forget_elsewhere(port, connector):
    """Make the other ends forget a Connector that a Port has removed without reaching all of them; dead ends
    do not matter.

    Raises Uncertain where one does not answer: it may live, and have half a connection.
    """
    for ref in connector.ports:
        if ref is None or orb.same(ref, port.ref):
            continue
        try:
            await orb.call(ports.label(port), ref, "notify_disconnect", to_wire(connector.id))
        except (errors.Gone, errors.ConnectionRefused, errors.Refused):
            pass
        except errors.Unreachable as e:
            host, tcp_port = orb.endpoint(ref)
            end = f"its end at {host}:{tcp_port} does not answer ({e.why})"
            why = f"connection {printable(connector.id)} is removed here, {end}"
            raise errors.Uncertain(ports.label(port), why)


async def _forgetting_failed(port, operation, connector_id):
    """Ask a port to forget a connector; the errors.Error that says why it may still have it, or None."""
    try:
        code = str(await orb.call(ports.label(port), port.ref, operation, connector_id))
    except errors.Unanswered:
        raise
    except errors.Unreachable as e:  # may be the far end's death, passed on
        return e
    if code == "RTC_OK":
        return None
    # BAD_PARAMETER: it does not know the connector; or another end, which it has asked to inform the others,
    # does not
    why = f"cannot remove connection {printable(from_wire(connector_id))} ({code})"
    return errors.Refused(ports.label(port), why)


def removal(port, connector, is_forced=False):
    """The rtdis command that removes a Connector of a Port, ready for a shell."""
    words = ["rtdis", "-i", connector.id, ports.label(port)]
    if is_forced:
        words.insert(1, "--force")
    return " ".join(shell_word(word) for word in words)


async def disconnect_all(pairs, dry_run=False, is_forced=False):
    """`disconnect` each (Port, Connector): a line or an errors.Error for each;
    a connector of two of the ports is removed once.
    """
    results = []  # type: list
    seen = set()  # type: set
    for port, connector in pairs:
        if connector.id in seen:
            continue
        seen.add(connector.id)
        if dry_run:
            results.append(removal(port, connector, is_forced))
            continue
        failure = await errors.or_error(disconnect(port, connector, is_forced))
        removed = f"{ports.label(port)}: removed connection {printable(connector.id)}"
        results.append(failure or removed)
    return results
