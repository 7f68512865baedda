"""Whether the system has been started: all of it, or all but what was reset."""
from rtshell_lite.corba import orb
from rtshell_lite.doctor import remedies
from rtshell_lite.doctor.finding import counted, warn
from rtshell_lite.robot import component

MANY = 10  # components that one command activates


def findings(snapshots):
    """Findings on Inactive components, given their Snapshots, in order."""
    answered = [(snapshot, component.merged(snapshot.states)) for snapshot in snapshots if snapshot.states]
    if answered and all(state == "Inactive" for _, state in answered):
        return [_nothing_moves([snapshot for snapshot, _ in answered])]
    found = []
    for snapshot, others in _systems(answered):
        active = sum(state == "Active" for state in others)
        if active:
            message = f"Inactive, while {counted(active, 'component')} of its system {'is' if active == 1 else 'are'} Active; it may " \
                      "have been reset"
            found.append(warn("component", snapshot.where, message, remedies.command("activate", option=[], path=snapshot.where)))
    return found


def _nothing_moves(snapshots):
    cure = remedies.words("activate many") if len(snapshots) > MANY else remedies.command(
        "activate", option=[], path=[snapshot.where for snapshot in snapshots])
    return warn("component", "/", "all components are Inactive: nothing has been started", cure)


def _systems(answered):
    """(Snapshot, states of the others in its system) for each that is Inactive.

    Its system is what is connected with it; without connections, what is bound in the same directory.
    """
    groups = _connected([snapshot for snapshot, _ in answered])
    for snapshot, state in answered:
        if state != "Inactive":
            continue
        group = groups[id(snapshot)]
        if len(group) == 1:
            group = [other for other, _ in answered if other.node.path.parent() == snapshot.node.path.parent()]
        members = {id(other) for other in group}
        yield snapshot, [state for other, state in answered if id(other) in members and other is not snapshot]


def _connected(snapshots):
    """{id of a Snapshot: all that are connected with it, directly or through others}."""
    owners = {orb.identity(port.ref): snapshot for snapshot in snapshots for port in snapshot.ports}
    groups = {id(snapshot): [snapshot] for snapshot in snapshots}
    for snapshot in snapshots:
        for ref in [ref for port in snapshot.ports for connector in port.connectors for ref in connector.ports if ref is not None]:
            group, other = groups[id(snapshot)], owners.get(orb.identity(ref))
            if other is None or groups[id(other)] is group:
                continue
            group += groups[id(other)]
            for member in groups[id(other)]:
                groups[id(member)] = group
    return groups
