"""Connectors between ports: connect, disconnect, and what refuses it."""
from rtshell_lite import errors
from rtshell_lite.corba import orb, stubs
from rtshell_lite.robot import component, ports
from rtshell_lite.text import from_wire, printable, shell_word, to_wire

PROFILE = "component.RTC.ConnectorProfile"


def refuse_duplicate(found, name, connector_id):
    """Raise Refused when the first port is joined with any of the others already, or any has a connection so named."""
    for each, connector in [(each, connector) for each in found for connector in each.connectors]:
        for what, wanted, value in (("id", connector_id, connector.id), ("name", name, connector.name)):
            if wanted and wanted == value:
                raise errors.Refused(ports.label(each), f"has a connection with {what} {printable(value)} already")
    for connector in ports.joining(found):
        raise errors.Refused(ports.between(found), f"already connected (id {printable(connector.id)})")


def command(labels, name, connector_id, given):
    """The rtcon command for a connection of the ports at these paths (texts, see `label`), ready for a shell."""
    words = ["rtcon"] + ["-n", name] * bool(name) + ["-i", connector_id] * bool(connector_id)
    for item in sorted(given.items()):
        words += ["-p", "%s=%s" % item]
    return " ".join(shell_word(word) for word in words + labels)


def connect(found, name="", connector_id="", given=None):
    """Connect the Ports `found` (one or more, in this order) and return the Connector made.

    Raises Refused with the reasons when they do not match or the components refuse, and Unreachable.
    """
    given = given or {}
    ports.check(found, given)
    name = name or ports.short_name(found[0].name, found[0].node.path.names[-1].id) + "_".join(
        ports.short_name(each.name, each.node.path.names[-1].id) for each in found[1:])
    asked = stubs.named(PROFILE)(to_wire(name), to_wire(connector_id), [each.ref for each in found],
                                 orb.nvlist(sorted(ports.connection_properties(found, given).items())))
    code, made = orb.call(ports.between(found), found[0].ref, "connect", asked)
    if str(code) != "RTC_OK":
        _tidy(found)
        raise errors.Refused(ports.between(found), _why_refused(str(code), found, connector_id), name=str(code))
    return ports.connector(made, ports.between(found))


def connect_alone(port, name, properties):
    """A connector of one data port only, as tools use it; nobody else takes part, and the port's side of it is complete.

    Raises Refused, Unreachable.
    """
    for reason in ports.without_rate([port], properties):
        raise errors.Refused(ports.label(port), reason)
    asked = stubs.named(PROFILE)(to_wire(name), "", [port.ref], orb.nvlist(sorted(properties.items())))
    code, made = orb.call(ports.label(port), port.ref, "connect", asked)
    if str(code) != "RTC_OK":
        raise errors.Refused(ports.label(port), f"refused by the component ({code})", name=str(code))
    return ports.connector(made, ports.label(port))


def _why_refused(code, found, connector_id):
    already = ports.joining(found)
    if code == "PRECONDITION_NOT_MET" and already:
        return f"already connected (id {printable(already[0].id)})"
    if code == "PRECONDITION_NOT_MET" and connector_id:
        return f"refused; id {printable(connector_id)} is in use, or the component takes no ids (RtORB)"
    also = f"; it is connected already (id {printable(already[0].id)})" if already else ""
    return f"refused by the component ({code}){also}"


def _tidy(found):
    """Remove what a failed connect left behind: components of Python keep half a connection on the in port."""
    for each in found:
        try:
            now = ports.port(each.node, each.ref)
            for connector in now.connectors:
                if connector.id not in [c.id for c in each.connectors] and ports.joining([now._replace(connectors=[connector])] + [
                        other for other in found if other is not each]):
                    orb.call(ports.label(each), each.ref, "notify_disconnect", to_wire(connector.id))
        except errors.Error:
            pass  # the refusal itself is what the user has to know


def disconnect(port, connector):
    """Remove a Connector of a Port. Done when the port no longer has it, whatever the far end says. Raises Refused."""
    connector_id = to_wire(connector.id)
    for operation in ("disconnect", "notify_disconnect"):  # the second reaches this end alone, for a dead far end
        failure = _forgetting_failed(port, operation, connector_id)
        if failure is None:
            return
        left = component.once_more(lambda: orb.call(ports.label(port), port.ref, "get_connector_profiles"))
        if connector_id not in [c.connector_id for c in left]:
            _forget_elsewhere(port, connector)
            return
    raise failure


def _forget_elsewhere(port, connector):
    """Let the other ends forget a Connector that a Port has removed without reaching all of them; dead ends do not matter.

    Raises Uncertain where one does not answer: it may live, and have half a connection.
    """
    for ref in connector.ports:
        if ref is None or orb.same(ref, port.ref):
            continue
        try:
            orb.call(ports.label(port), ref, "notify_disconnect", to_wire(connector.id))
        except (errors.Gone, errors.ConnectionRefused, errors.Refused):
            pass
        except errors.Unreachable as e:
            why = "connection %s is removed here, its end at %s:%d says nothing (%s)" % (
                (printable(connector.id),) + orb.endpoint(ref) + (e.why,))
            raise errors.Uncertain(ports.label(port), why)


def _forgetting_failed(port, operation, connector_id):
    """Ask a port to forget a connector; the errors.Error that says why it may still have it, or None."""
    try:
        code = str(orb.call(ports.label(port), port.ref, operation, connector_id))
    except errors.Silent:
        raise
    except errors.Unreachable as e:  # may be the far end's death, passed on
        return e
    if code == "RTC_OK":
        return None
    # BAD_PARAMETER: it does not know the connector; or another end does not, which it has asked to inform all the others
    return errors.Refused(ports.label(port), f"cannot remove connection {printable(from_wire(connector_id))} ({code})")


def disconnect_all(pairs, dry_run=False):
    """`disconnect` for each (Port, Connector): a line or an errors.Error for each; a connector of two own ports goes once."""
    results, seen = [], set()  # type: list, set
    for each, connector in pairs:
        if connector.id in seen:
            continue
        seen.add(connector.id)
        if dry_run:
            results.append(f"rtdis -i {shell_word(connector.id)} {shell_word(ports.label(each))}")
            continue
        try:
            disconnect(each, connector)
            results.append(f"{ports.label(each)}: removed connection {printable(connector.id)}")
        except errors.Error as e:
            results.append(e)
    return results
