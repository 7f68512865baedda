"""Whether somebody has started the system: all of it, or all but what was reset."""
from rtshell_lite.corba import orb
from rtshell_lite.doctor import remedies
from rtshell_lite.doctor.finding import counted, warn
from rtshell_lite.robot import component

MANY = 10  # components that one command activates


def findings(all_of_them):
    """Findings on snapshot.Snapshot that are Inactive, in order."""
    told = [(each, component.merged(each.states)) for each in all_of_them if each.states]
    if told and all(state == "Inactive" for _, state in told):
        return [_nothing_moves([each for each, _ in told])]
    found = []
    for each, others in _systems(told):
        active = sum(state == "Active" for state in others)
        if active:
            message = "Inactive, while %s of its system %s Active; it may have been reset" % (
                counted(active, "component"), "is" if active == 1 else "are")
            found.append(warn("component", each.where, message, remedies.command("activate", option=[], path=each.where)))
    return found


def _nothing_moves(some):
    cure = remedies.words("activate many") if len(some) > MANY else remedies.command(
        "activate", option=[], path=[each.where for each in some])
    return warn("component", "/", "all components are Inactive: nothing has been started", cure)


def _systems(told):
    """(Snapshot, states of the others in its system) for each that is Inactive.

    What is connected with it is its system; for one without connections, what is bound in the same directory.
    """
    groups = _connected([each for each, _ in told])
    for each, state in told:
        if state != "Inactive":
            continue
        group = groups[id(each)]
        if len(group) == 1:
            group = [other for other, _ in told if other.node.path.parent() == each.node.path.parent()]
        members = {id(other) for other in group}
        yield each, [state for other, state in told if id(other) in members and other is not each]


def _connected(some):
    """{id of a Snapshot: all that are connected with it, directly or through others}."""
    owners, groups = {orb.identity(port.ref): each for each in some for port in each.ports}, {id(each): [each] for each in some}
    for each in some:
        for ref in [ref for port in each.ports for one in port.connectors for ref in one.ports if ref is not None]:
            group, other = groups[id(each)], owners.get(orb.identity(ref))
            if other is None or groups[id(other)] is group:
                continue
            group += groups[id(other)]
            for one in groups[id(other)]:
                groups[id(one)] = group
    return groups
