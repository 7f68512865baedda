"""In ports that refuse values: their full buffers do, where a connection asks for that.

OpenRTM counts nowhere what an in port has refused (BUFFER_FULL, BUFFER_TIMEOUT): only listeners in the two
components get to know. No value may be sent to find out. So it is concluded from policies, states and rates.
A component may read several values in a cycle: what is concluded from rates is only probable.
"""

from rtshell_lite.corba import orb
from rtshell_lite.doctor import remedies
from rtshell_lite.doctor.finding import warn
from rtshell_lite.robot import blocking, component, ports
from rtshell_lite.text import printable, shell_word

# What a full buffer does by its policy; by others it overwrites
POLICIES = {"do_nothing": "refuses what it has no room for", "block": "makes its writers wait"}
KEYS = ("dataport.inport.buffer.write.full_policy", "dataport.buffer.write.full_policy")  # the first counts
ENOUGH = 0.9  # of what is written: rates are measured for a second


def findings(snapshots):
    """Findings on in ports that refuse values, given the Snapshots of all components.

    Only what Active components push is of interest.
    """
    writers = {
        orb.identity(port.ref): (snapshot, port)
        for snapshot in snapshots
        for port in snapshot.ports
        if port.type == "DataOutPort"
    }
    all_findings = []
    for snapshot in snapshots:
        for port in snapshot.ports:
            policy = refusal(port) if port.type == "DataInPort" and snapshot.states else ""
            if policy:
                message, cure = _trouble(snapshot, policy, _writers(port, writers))
            else:
                message = ""
                cure = None
            if message:
                all_findings.append(warn("buffer", ports.label(port), f"{message} ({policy})", cure))
            if port.type == "DataInPort":
                all_findings += _removals(port, writers)
    return all_findings


def _removals(port, writers):
    """Findings on connections of an in port that must not be removed while a value may wait in them."""
    for connector in port.connectors:
        if not blocking.may_wait(dict(connector.properties)):
            continue
        sources = [writers[orb.identity(ref)] for ref in connector.ports if _known(ref, writers)]
        if not sources:
            continue
        message = (
            f"connection {printable(connector.id)} makes its writers wait (full_policy=block): "
            "to remove it while one of them is Active may end this process"
        )
        paths = " ".join(shell_word(snapshot.where) for snapshot, _ in sources)
        yield warn("removal", ports.label(port), message, remedies.words("before removal", paths=paths))


def _known(ref, writers):
    return ref is not None and orb.identity(ref) in writers


def refusal(port):
    """The policy in POLICIES that the port's last connection asks for, or ''."""
    asked = ""
    for connector in port.connectors:
        properties = dict(connector.properties)
        asked = next((properties[key] for key in KEYS if properties.get(key)), asked)
    return asked if asked in POLICIES else ""


def _writers(port, writers):
    """(Snapshot, Port) of the Active components that push values to an in port."""
    pushed = [
        ref
        for connector in port.connectors
        for ref in connector.ports
        if ref is not None
        and dict(connector.properties).get("dataport.dataflow_type", "push").lower() == "push"
    ]
    owners = [writers[orb.identity(ref)] for ref in pushed if orb.identity(ref) in writers]
    return [(snapshot, port) for snapshot, port in owners if component.merged(snapshot.states) == "Active"]


def _trouble(snapshot, policy, writers):
    """(why values are refused, the Remedy), or ('', None)."""
    where = shell_word(snapshot.where)
    rates = _rates(snapshot)
    for writer, port in writers:
        name = ports.label(port)
        if not rates:
            message = f"nothing reads the values of {name}: its buffer {POLICIES[policy]}, once it is full"
            return message, remedies.words("activate", path=where)
        measured, written = writer.written or (None, 0)
        if measured is not port or not all(rates):  # 0 Hz: a context that is triggered
            continue
        if policy == "block":
            written = max(_rates(writer))  # it would be, if it did not wait
        if max(rates) < ENOUGH * written:
            message = (
                f"the values of {name} probably find its buffer full ({written:.4g} Hz are written, "
                f"it executes at {max(rates):g} Hz), which {POLICIES[policy]}"
            )
            return message, remedies.words("full buffer", path=where)
    return "", None


def _rates(snapshot):
    """The rates of the running contexts in which a component is Active."""
    contexts = zip(snapshot.contexts, snapshot.states)
    return [context.rate for context, state in contexts if state == "Active" and context.running]
