"""From an RtsProfile to the steps that bring a running system to it (rtresurrect), or that take its connections away (rtteardown)."""
import collections

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.robot import manager, ports
from rtshell_lite.system import apply, capture, connect_steps, relocate, sites, steps
from rtshell_lite.text import printable

# How a profile is to be restored. `create` whether missing components are to be created, `manager` the path of the manager for
# those that the profile names none for, `strict` is --strict-path.
Options = collections.namedtuple("Options", "create manager strict")


def _sites(profile):
    """sites.of a profile. Raises Failed for two components at one place."""
    listed, taken = sites.of(profile), {}
    for site in listed:
        if site.error is None and taken.setdefault(site.path, site) is not site:
            raise errors.Failed(site.where, "the file has two components here")
    return listed


# ---- restoring --------------------------------------------------------------------------------------------------

def restoring(profile, options):
    """The apply.Outcomes of the steps that restore a profile, all looked at: what is not pending is done already, or cannot be done."""
    listed = _sites(profile)
    sites.look(listed)
    locate = capture.locator(profile, options.strict)
    outcomes = [_presence(site) for site in listed]
    if options.create:
        outcomes = _creations(profile, outcomes, options, locate)
    site_of = sites.finder(locate, listed)
    for site in listed:
        outcomes += _memberships(site, site_of)
    for site in listed:
        outcomes += _configurations(site) + _rates(site)
    return outcomes + _connections(profile, site_of)


def _presence(site):
    """Whether a component is there, and the one that is meant; nothing can be done with any other."""
    outcome = apply.judged(steps.Present(site))
    site.error = outcome.error
    if site.error is not None:
        outcome.fail(site.error)
    return outcome


def _creations(profile, outcomes, options, locate):
    """The outcomes with a Create in the place of each component that is missing."""
    named, holders = _named_managers(profile, options, locate), {}
    made = []
    for outcome in outcomes:
        site = outcome.step.sites[0]
        if not sites.is_gone(site.error):
            made.append(outcome)
            continue
        word = named.get(id(site.component)) or _above(site.path) or options.manager
        try:
            if not word:
                raise errors.Failed(site.where, "is not there, and nothing names a manager to create it (see --manager)")
            if word not in holders:
                holders[word] = Holder(word)
            holder = holders[word]
            outcome = apply.Outcome(steps.Create(site, holder, holder.identity(site.component.id)))
            site.error = None
        except errors.Error as e:
            outcome = apply.Outcome(outcome.step, apply.FAILED, e)
            site.error = e
        made.append(outcome)
    return made


class Holder:
    """A manager that is to create components; in Create it is beside their Sites. Raises what `manager.find` raises."""

    required, error, found = True, None, None

    def __init__(self, word):
        manager.check(word)
        self.node = manager.find(word)
        self.where = str(self.node.path)
        self.factories = manager.modules(self.node, "get_factory_profiles")

    def identity(self, component_id):
        """What it knows a component by: profiles have the type's name in their ids, factories the implementation's."""
        for each in self.factories:
            if component_id == ":".join(["RTC"] + [each.get(key, "") for key in ("vendor", "category", "type_name", "version")]):
                return manager.component_id(each)
        return component_id


def _named_managers(profile, options, locate):
    """{id of a Component: path of the manager that the profile names for it}."""
    found = {}
    targets = [end for each in profile.connectors for end in each.ends]
    for target in targets + [one.component for each in profile.components for one in each.participants]:
        each, uri = locate(target), target.property(capture.PATH_ID)
        if each is not None and uri:
            found.setdefault(id(each), _above(relocate.path_in(uri)))
    for each in profile.components:
        own = each.property(relocate.MANAGER)
        if own:
            found[id(each)] = own if own.startswith("corbaloc:") else "/" + own.lstrip("/")
    return found


def _above(where):
    """The path of the manager below which a Path says that its component is, or None."""
    above = where.parent()
    return str(above) if above.names and above.names[-1].kind == "mgr" else None


# ---- components -------------------------------------------------------------------------------------------------

def _memberships(site, site_of):
    """Whether a composite has its members; those that are not there are reported apart from the others."""
    members = steps.members(site, site_of)
    parts = [member for member in members if member.error is None], [member for member in members if member.error is not None]
    return [apply.judged(steps.Members(site, part)) for part in parts if part]


def _configurations(site):
    """Whether the parameters of each set have their values, and which set is active."""
    outcomes = []
    for one in site.component.configuration_sets:
        wanted = steps.wanted_values(one)
        unknown = steps.Values(site, one.id, wanted).unknown()  # do not keep the others from their values
        known = collections.OrderedDict((name, value) for name, value in wanted.items() if name not in unknown)
        for part in [{name: wanted[name]} for name in unknown] + [known] * bool(known):
            outcomes.append(apply.judged(steps.Values(site, one.id, part)))
    if site.component.active_configuration_set:
        active = apply.judged(steps.Active(site, site.component.active_configuration_set))
        if active.status == apply.ALREADY and any(outcome.pending for outcome in outcomes):
            active.status, active.likely = apply.UNTRIED, True  # setting values deactivates, until the set is activated again
        outcomes.append(active)
    return outcomes


def _rates(site):
    """Whether the execution contexts that a component owns have their rates; those that it has not are passed over."""
    owned = [context.handle for context in site.found.owned] if site.found else None
    outcomes = []
    for index, wanted in enumerate(site.component.execution_contexts):
        if not wanted.id.isdigit() or not 0 < wanted.rate < float("inf") or wanted.kind.upper()[:8] != "PERIODIC":
            continue
        handle = int(wanted.id)
        if owned is None or handle in owned:
            index = index if owned is None else owned.index(handle)
            outcomes.append(apply.judged(steps.Rate(site, index, handle, wanted.rate)))
    return outcomes


# ---- connections ------------------------------------------------------------------------------------------------

def _connections(profile, site_of):
    """Whether the connections are there; what is left of one that has lost an end is removed first."""
    ids = {connector.connector_id for connector in profile.connectors}
    made = [[apply.judged(connect_steps.placed(connect_steps.Connect, connector, site_of, ids))]
            for connector in profile.connectors]
    broken = [(outcomes, _strange_ends(outcomes[0].step)) for outcomes in made
              if isinstance(outcomes[0].error, connect_steps.Incomplete)]
    answers = iter(orb.each([ref for _, refs in broken for ref in refs], lambda ref: orb.is_alive("", ref)))
    for outcomes, refs in broken:
        found = [next(answers) for _ in refs]
        _mend(outcomes, any(isinstance(answer, errors.Silent) or not isinstance(answer, errors.Error) for answer in found))
    return [outcome for outcomes in made for outcome in outcomes]


def _strange_ends(step):
    """References of the ports that the rest of a connection joins, and that are not those of the profile."""
    at = step.found()
    known = {orb.identity(port.ref) for port in at}
    refs = {orb.identity(ref): ref for _, connector in step.leftovers(at) for ref in connector.ports if ref is not None}
    return [ref for key, ref in sorted(refs.items()) if key not in known]


def _mend(outcomes, in_use):
    """Put the removal of what is left of a connection before it, or let it fail where the rest is in use."""
    step = outcomes[0].step
    if in_use:
        outcomes[0].fail(errors.Refused(step.where, "connection %s joins other ports; rtdis removes it" % (
            printable(step.connector.connector_id))))
        return
    outcomes[0].status, outcomes[0].error = apply.UNTRIED, None
    outcomes.insert(0, apply.judged(connect_steps.Disconnect(step.connector, step.ends)))


# ---- tearing down -----------------------------------------------------------------------------------------------

def tearing_down(profile, options):
    """(the apply.Outcomes of the steps that remove the connections of a profile, notes on components that are gone).

    Where one end is gone, the others are freed. That no component is there at all is a failure.
    """
    listed = _sites(profile)
    sites.look(listed, _ports_only)
    lost = [site for site in listed if site.error is not None]
    some = len(lost) < len(listed) or not listed
    outcomes = [_presence(site) for site in lost if not (some and sites.is_gone(site.error))]
    notes = [str(site.error) for site in lost if some and sites.is_gone(site.error)]
    site_of = sites.finder(capture.locator(profile, options.strict), listed)
    for connector in profile.connectors:
        outcomes.append(apply.judged(connect_steps.placed(connect_steps.Disconnect, connector, site_of)))
    if not some:
        for outcome in outcomes:
            if outcome.status == apply.ALREADY:
                outcome.status, outcome.error = apply.UNTRIED, lost[0].error
    return outcomes, notes


def _ports_only(node):
    return capture.Found(node, ports.in_system(ports.ports(node)), [], {}, [], "", [], None)
