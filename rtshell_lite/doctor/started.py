"""Whether the system has been started: all of it, or all but what was reset."""

import collections

from rtshell_lite.corba import orb
from rtshell_lite.doctor import remedies
from rtshell_lite.doctor.finding import warn
from rtshell_lite.robot import component
from rtshell_lite.text import counted, shell_word

MANY = 10  # components that one command activates


def findings(snapshots, failed):
    """Findings on Inactive components, given their Snapshots, in order; `failed` are the paths of components
    with a failure.

    A system is what is connected. One with a failure is not judged: what is Inactive there may wait for it.
    """
    answered = [(snapshot, component.merged(snapshot.states)) for snapshot in snapshots if snapshot.states]
    are_all_inactive = all(state == "Inactive" for _, state in answered)
    if not failed and answered and are_all_inactive:
        return [_nothing_moves([snapshot for snapshot, _ in answered])]
    groups = _connected(snapshots)
    states = {id(snapshot): state for snapshot, state in answered}
    all_findings = []
    for snapshot, state in answered:
        group = groups[id(snapshot)]
        if state != "Inactive" or any(other.where in failed for other in group):
            continue
        active = collections.Counter(states.get(id(other)) for other in group)["Active"]
        are = "is" if active == 1 else "are"
        if active:
            of_system = f"{counted(active, 'component')} of its system {are} Active"
            message = f"Inactive, while {of_system}; it may have been reset"
            cure = remedies.words("activate", path=shell_word(snapshot.where))
            all_findings.append(warn("component", snapshot.where, message, cure))
    return all_findings


def _nothing_moves(snapshots):
    if len(snapshots) > MANY:
        cure = remedies.words("activate many")
    else:
        cure = remedies.command("activate", option=[], path=[snapshot.where for snapshot in snapshots])
    return warn("component", "/", "all components examined are Inactive: none has been started", cure)


def _connected(snapshots):
    """{id of a Snapshot: all that are connected with it, directly or through others}."""
    owners = {orb.identity(port.ref): snapshot for snapshot in snapshots for port in snapshot.ports}
    groups = {id(snapshot): [snapshot] for snapshot in snapshots}
    for snapshot in snapshots:
        for ref in [
            ref
            for port in snapshot.ports
            for connector in port.connectors
            for ref in connector.ports
            if ref is not None
        ]:
            group = groups[id(snapshot)]
            other = owners.get(orb.identity(ref))
            if other is None or groups[id(other)] is group:
                continue
            group += groups[id(other)]
            for member in groups[id(other)]:
                groups[id(member)] = group
    return groups
