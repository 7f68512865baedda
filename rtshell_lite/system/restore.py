"""From an RtsProfile to the steps that bring a running system to it (rtresurrect),
or that take its connections away (rtteardown).
"""

import collections

from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.robot import manager, ports, tree
from rtshell_lite.system import apply, capture, connect_steps, plan, relocate, placements, steps
from rtshell_lite.system.outcomes import ALREADY, NOT_TRIED
from rtshell_lite.text import printable, shell_word

# How a profile is to be restored. `create` whether missing components are to be created, `manager` the path
# of the manager for those that the profile names none for, `strict` is --strict-path.
Options = collections.namedtuple("Options", "create manager strict")


def places(profile):
    """placements.of a profile. Raises Failed for two components at one place."""
    listed = placements.of(profile)
    taken = {}
    for placement in listed:
        if placement.error is None and taken.setdefault(placement.path, placement) is not placement:
            raise errors.Failed(placement.where, "the file has two components here")
    return listed


# ---- restoring ----


async def restoring(profile, options):
    """The apply.Outcomes of the steps that restore a profile:
    pending, done already, or known not to be possible.
    """
    listed = places(profile)
    await placements.find(listed)
    locate = capture.locator(profile, options.strict)
    outcomes = [await presence(placement) for placement in listed]
    if options.create:
        outcomes = await creations(profile, outcomes, options, locate)
    placement_of = placements.finder(locate, listed)
    outcomes += await parts(listed, placement_of)
    return outcomes + await connections(connect_steps.connecting(profile, placement_of))


async def commands(profile, planned, options):
    """The commands that would bring the system to what a profile says now, its states by its Plan."""
    outcomes = await restoring(profile, options)
    lines = [outcome.step.command for outcome in outcomes if outcome.pending and not outcome.likely]
    states = dict(zip(map(id, profile.components), await capture.states(profile)))
    for action in plan.in_order(planned.actions):
        state = states.pop(id(action.component), "Active")
        path = shell_word(action.path)
        if state == "Error":
            lines += ["rtreset --wait " + path]
        if state in ("Error", "Inactive"):
            lines += ["rtact --wait " + path]
    return lines


async def parts(listed, placement_of):
    """The outcomes of the steps that restore components, Placements, without their connections:
    members of composites first.
    """
    outcomes = []
    for placement in listed:
        outcomes += await memberships(placement, placement_of)
    for placement in listed:
        outcomes += await _configurations(placement)
        outcomes += await _rates(placement)
        outcomes += await _participations(placement, placement_of)
    return outcomes


async def presence(placement):
    """Whether a component is there, and the one that is meant; nothing can be done with any other."""
    outcome = await apply.assess(steps.Present(placement))
    if outcome.error is not None:
        placement.error = outcome.error
        outcome.fail(placement.error)
    return outcome


async def creations(profile, outcomes, options, locate):
    """The outcomes of `presence`, with a Create in the place of each component that is missing."""
    named = _named_managers(profile, locate)
    creators = {}
    result = []
    for outcome in outcomes:
        placement = outcome.step.placement
        if placements.is_gone(placement.error) or isinstance(placement.error, errors.MaybeGone):
            own_manager = named.get(id(placement.component)) or _above(placement.path)
            manager_path = own_manager or options.manager
            try:
                if not own_manager and isinstance(placement.error, errors.MaybeGone):
                    raise placement.error
                if not manager_path:
                    why = "is not there, and nothing names a manager to create it (see --manager)"
                    raise errors.Failed(placement.where, why)
                if manager_path not in creators:
                    manager.check(manager_path)
                    creators[manager_path] = Creator(await manager.find(manager_path))
                creator = creators[manager_path]
                await creator.check_gone(placement, bool(own_manager))
                identity = await creator.identity(placement.component.id)
                outcome = apply.Outcome(steps.Create(placement, creator, identity))
                placement.error = None
            except errors.Error as e:
                placement.error = e
                outcome.fail(e)
        result.append(outcome)
    return result


class Creator:
    """A manager that is to create components; a Create lists it among its Placements."""

    required = True
    error = None
    found = None

    def __init__(self, node):
        self.node = node
        self.where = str(node.path)
        self._identities = {}
        self._names = None  # instance names of the components that it has

    async def identity(self, component_id):
        """The id by which it creates a component:
        profiles have the type's name in their ids and no language.
        """
        if component_id not in self._identities:
            self._identities[component_id] = await manager.whole_id(self.node, component_id)
        return self._identities[component_id]

    async def check_gone(self, placement, is_own):
        """Raise what shows that a component that is missing may live: it must not run twice. Where its name
        is gone, or another host refuses, the manager has to know nothing of it, and its object, at the
        address in the profile, must not answer, nor hang. A refusal there proves nothing, unless this is its
        own manager (`is_own`: the profile names it), which knows whether it has the component.
        """
        if isinstance(placement.error, (errors.Gone, errors.ProcessGone)):
            return
        if self._names is None:
            managed = await tree.managed(self.node)
            self._names = {child.path.names[-1].id for child in managed if child.kind != "zombie"}
        if placement.instance in self._names:
            if isinstance(placement.error, errors.MaybeGone):
                raise placement.error
            why = f"{self.where} has it, though its name is not bound"
            raise errors.Failed(placement.where, f"not created: {why}: restart it, or delete it there")
        why = await _life_at_saved_address(placement, is_own)
        if why:
            raise errors.Failed(placement.where, f"not created: {why}")


async def _life_at_saved_address(placement, is_own):
    """Why what a profile has the address of may live, '' where it is gone; for `is_own` see
    Creator.check_gone.
    """
    ref = capture.saved_reference(placement.component)
    if ref is None:
        return ""
    address = orb.at_address(ref)
    try:
        if await capture.living_reference(placement.component) is None:
            return ""
    except errors.Unreachable as e:
        if is_own and isinstance(e, errors.ConnectionRefused):
            return ""
        why = await capture.doubt(placement.component, placement.path, e)
        return why and why + " (REFERENCE in the file)"
    words = "restart it, or end its process; if that is another robot, take REFERENCE out of the file"
    return f"it lives at {address}, though its name is not bound: {words}"


def _named_managers(profile, locate):
    """{id of a Component: path of the manager that the profile names for it}."""
    managers = {}
    targets = [end for connector in profile.connectors for end in connector.ends]
    targets += [
        participant.component for component in profile.components for participant in component.participants
    ]
    for target in targets:
        component = locate(target)
        uri = target.property(capture.PATH_ID)
        if component is not None and uri:
            managers.setdefault(id(component), _above(relocate.path_in(uri)))
    for component in profile.components:
        own = component.property(capture.MANAGER)
        if own:
            managers[id(component)] = own if own.startswith("corbaloc:") else "/" + own.lstrip("/")
    return managers


def _above(where):
    """The path of the manager above the Path of a component, or None."""
    above = where.parent()
    if above.names and above.names[-1].kind == "mgr":
        return str(above)
    return None


# ---- components ----


async def memberships(placement, placement_of):
    """Whether a composite has its members."""
    parts = _absent_apart(steps.members(placement, placement_of))
    return [await apply.assess(steps.Members(placement, part)) for part in parts]


def _absent_apart(listed):
    """Placements in one or two lists: what is not there is reported apart from the others."""
    present = [placement for placement in listed if placement.error is None]
    absent = [placement for placement in listed if placement.error is not None]
    return [part for part in (present, absent) if part]


async def _configurations(placement):
    """Whether the parameters of each set have their values, and which set is active."""
    outcomes = []
    for one_set in placement.component.configuration_sets:
        expected = steps.wanted_values(one_set)
        # do not keep the others from their values
        unknown = steps.Values(placement, one_set.id, expected).unknown()
        existing = {name: value for name, value in expected.items() if name not in unknown}
        for part in [{name: expected[name]} for name in unknown] + [existing]:
            if part:
                outcomes.append(await apply.assess(steps.Values(placement, one_set.id, part)))
    if placement.component.active_configuration_set:
        active = await apply.assess(steps.Active(placement, placement.component.active_configuration_set))
        if active.status == ALREADY and any(outcome.pending for outcome in outcomes):
            # setting values deactivates, until the set is activated again
            active.status = NOT_TRIED
            active.likely = True
        outcomes.append(active)
    return outcomes


async def _rates(placement):
    """Whether the execution contexts that a component owns have their rates."""
    return [
        await apply.assess(steps.Rate(placement, index, handle, described.rate))
        for index, handle, described in steps.own_contexts(placement)
        if 0 < described.rate < float("inf") and described.kind.upper()[:8] == "PERIODIC"
    ]


async def _participations(placement, placement_of):
    """Whether other components take part in its contexts, as on robots that run many in one."""
    return [
        await apply.assess(steps.Participants(placement, index, handle, part))
        for index, handle, described in steps.own_contexts(placement)
        for part in _absent_apart(steps.participants(placement, described, placement_of))
    ]


# ---- connections ----


async def connections(connecting):
    """Whether the connections of Connect steps are there; what is left of one that has lost an end is removed
    first.
    """
    outcomes = [await apply.assess(step) for step in connecting]
    broken = [outcome for outcome in outcomes if isinstance(outcome.error, connect_steps.Incomplete)]
    strange = [_strange_ends(outcome.step) for outcome in broken]
    asked = [ref for refs in strange for ref in refs]
    answers = iter(await session.each(asked, lambda ref: orb.is_alive("", ref), orb.at_object))
    for outcome, refs in zip(broken, strange):
        step = outcome.step
        ends = [next(answers) for _ in refs]
        are_gone = [isinstance(end, errors.Error) and not isinstance(end, errors.Unanswered) for end in ends]
        if all(are_gone):
            outcome.status = NOT_TRIED
            outcome.error = None
            removal = await apply.assess(connect_steps.Disconnect(step.connector, step.ends, step.ids))
            outcomes.insert(outcomes.index(outcome), removal)
        else:
            connection = printable(step.connector.connector_id)
            why = f"connection {connection} joins other ports; rtdis removes it"
            outcome.fail(errors.Refused(step.where, why))
    return outcomes


def _strange_ends(step):
    """References of the ports that the rest of a connection joins, and that are not those of the profile."""
    answers = step.known_answers()
    own = {orb.identity(port.ref) for port in answers}
    refs = {
        orb.identity(ref): ref
        for _, connector in step.leftovers(answers)
        for ref in connector.ports
        if ref is not None
    }
    return [ref for key, ref in sorted(refs.items()) if key not in own]


# ---- tearing down ----


async def tearing_down(profile, options, is_forced=False):
    """(the apply.Outcomes of the steps that remove the connections of a profile, notes on components and
    ports that are gone).

    `is_forced`: see connectors.disconnect. Where one end is gone, the others are freed. That not even the
    directories of components are there is a failure.
    """
    listed = places(profile)
    await placements.find(listed, _ports_only)
    lost = [placement for placement in listed if placement.error is not None]
    some = not listed or any(
        placement.error is None or placement.error.where == placement.where for placement in listed
    )
    outcomes = [
        await presence(placement) for placement in lost if not (some and placements.is_gone(placement.error))
    ]
    notes = [str(placement.error) for placement in lost if some and placements.is_gone(placement.error)]
    placement_of = placements.finder(capture.locator(profile, options.strict), listed)
    removals = connect_steps.disconnecting(profile, placement_of)
    for step in removals:
        step.is_forced = is_forced
        if step.kind == "disconnect":
            notes += map(str, step.lost_ports())
    outcomes += [await apply.assess(step) for step in removals]
    if not some:
        for outcome in outcomes:
            if outcome.status == ALREADY:
                outcome.status = NOT_TRIED
                outcome.error = lost[0].error
    return outcomes, notes


async def tear_down(profile, options):
    """Remove the connections of a profile, as far as that can be done."""
    outcomes, _ = await tearing_down(profile, options)
    await apply.carry_out(outcomes)


async def _ports_only(node):
    listed = ports.in_system(await ports.ports(node))
    return capture.ComponentState(node, listed, [], {}, [], "", [], None, None)
