"""Which connections of kept components are not as their file has them, so that one task at a time
mends each.
"""

from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.robot import ports
from rtshell_lite.system import capture, connect_steps, restore


class Connections:
    """The connectors of a profile and who mends them; `kept_at(end)` gives the kept.KeptComponent of an end,
    or None.
    """

    def __init__(self, profile, placement_of, kept_at):
        self._profile = profile
        self._placement_of = placement_of
        self._kept_at = kept_at
        self._making = set()  # ids of the connectors that a task works on
        self._halves = set()  # ids of connectors of which one end was seen alone

    def of(self, batch):
        """(connector, the KeptComponents of its ends) of those with an end on one of some of these."""
        for connector in self._profile.connectors:
            ends = [self._kept_at(end) for end in connector.ends]
            if None not in ends and any(kept in batch for kept in ends):
                yield connector, ends

    async def take(self, batch):
        """The connectors of some KeptComponents whose ports have changed that these do not show as the file
        has them. No other task works on them until they are released; all their ends have been asked since.
        """
        taken = []
        for connector, ends in self.of(batch):
            if not all(kept.is_usable for kept in ends):
                continue
            if _is_shown(connector, ends, batch):
                ends[0].of_steps[key_of(connector)].complaint = None
            elif id(connector) in self._making:
                for kept in ends:
                    kept.change("ports")
            else:
                self._making.add(id(connector))
                taken.append((connector, ends))
        asked = list({kept for _, ends in taken for kept in ends})
        answers = await session.each(asked, _look_at_ports)
        failed = {kept for kept, answer in zip(asked, answers) if isinstance(answer, errors.Error)}
        for kept in failed:
            kept.change("ports")
        self.release([connector for connector, ends in taken if failed.intersection(ends)])
        return [connector for connector, _ in taken if id(connector) in self._making]

    def release(self, connectors):
        """Let other tasks work on connectors."""
        self._making.difference_update(map(id, connectors))

    async def outcomes(self, connectors):
        """The apply.Outcomes of the steps that make connectors, without those of a connection that has just
        lost an end: somebody may be about to connect, or to disconnect. What is half there at the next look,
        too, is removed.
        """
        connecting = connect_steps.connecting(self._profile, self._placement_of, connectors)
        outcomes = await restore.connections(connecting)
        removed = {id(outcome.step.connector) for outcome in outcomes if outcome.step.kind == "disconnect"}
        doubtful = removed - self._halves
        self._halves = doubtful
        for outcome in outcomes:
            if id(outcome.step.connector) in doubtful:
                for kept in map(self._kept_at, outcome.step.connector.ends):
                    if kept.is_there:  # only one of them does not show it
                        kept.change("ports")
        return [outcome for outcome in outcomes if id(outcome.step.connector) not in doubtful]


def key_of(connector):
    """What distinguishes the steps of a connector from others."""
    return "connect", id(connector)


def _is_shown(connector, ends, batch):
    """Whether those of the ends of a connector that are in the batch show it as the file has it: with its id,
    between the ports that the others had when they were last asked.
    """
    answers = [kept.placement.port(capture.port_of(end)) for kept, end in zip(ends, connector.ends)]
    if any(isinstance(port, errors.Error) for port in answers):
        return False
    identities = {orb.identity(port.ref) for port in answers}
    for kept, port in zip(ends, answers):
        same = [other for other in port.connectors if other.id and other.id == connector.connector_id]
        joined = {orb.identity(ref) for other in same for ref in other.ports if ref is not None}
        if kept in batch and joined != identities:
            return False
    return True


async def _look_at_ports(kept):
    """Have the present ports of a component in what was found of it."""
    now = await ports.ports(kept.node)
    kept.placement.found = kept.placement.found._replace(ports=ports.in_system(now))
