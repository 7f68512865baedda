"""From an RtsProfile to the steps that bring a running system to it (rtresurrect), or that take its connections away (rtteardown)."""
import collections

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.robot import manager, ports, tree
from rtshell_lite.system import apply, capture, connect_steps, relocate, steps
from rtshell_lite.text import printable

# How a profile is to be restored. `create` whether missing components are to be created, `manager` the path of the manager for
# those that the profile names none for, `strict` is --strict-path.
Options = collections.namedtuple("Options", "create manager strict")


# ---- where components are ---------------------------------------------------------------------------------------

def _sites(profile):
    """{id of a Component: its Site}. Raises Failed for two components at one place."""
    sites, taken = collections.OrderedDict(), {}
    for each in profile.components:
        where = relocate.path_in(each.path_uri)
        site = sites[id(each)] = steps.Site(each, where)
        if not where.names:
            site.where = capture.shown_path(each)
            site.error = errors.Failed(site.where, "not the path of a component")
        if site.error is None and taken.setdefault(where, each) is not each:
            raise errors.Failed(site.where, "the file has two components here")
    return sites


def _site_finder(locate, sites):
    """A function: the Site of the component that an end or a participant in the profile names, or None."""
    def at(target):
        each = locate(target)
        return None if each is None else sites[id(each)]
    return at


def _visit(sites):
    """Ask for each Site what there is; `error` says what is not there, or is another component than it should be."""
    asked = [site for site in sites if site.error is None]
    for site, found in zip(asked, tree.on_components([site.path for site in asked], capture.ask)):
        if isinstance(found, errors.Error):
            site.error = found
            continue
        site.found, site.node = found, found.node
        actual = capture.component_id(found.profile)
        if actual != site.each.id:
            site.error = errors.WrongKind(site.where, printable(site.each.id), printable(actual))
        elif found.profile.instance_name != site.instance:
            site.error = errors.WrongKind(site.where, "component called " + printable(site.instance),
                                          "component called " + printable(found.profile.instance_name))


# ---- restoring --------------------------------------------------------------------------------------------------

def restoring(profile, options):
    """The apply.Outcomes of the steps that restore a profile, all looked at: what is not pending is done already, or cannot be done."""
    sites = _sites(profile)
    _visit(sites.values())
    locate = capture.locator(profile, options.strict)
    outcomes = [_presence(site) for site in sites.values()]
    if options.create:
        outcomes = _creations(profile, outcomes, options, locate)
    at = _site_finder(locate, sites)
    for site in sites.values():
        outcomes += _memberships(site, at)
    for site in sites.values():
        outcomes += _configurations(site) + _rates(site)
    apply.check([each for each in outcomes if each.pending and all(site.found is not None for site in each.step.sites)])
    return outcomes + _connections(profile, at)


def _presence(site):
    status = apply.SO if site.error is None else apply.FAILED
    return apply.Outcome(steps.Present(site), status, site.error)


def _creations(profile, outcomes, options, locate):
    """The outcomes with a Create in the place of each component that is missing."""
    named, holders = _named_managers(profile, options, locate), {}
    made = []
    for outcome in outcomes:
        site = outcome.step.sites[0]
        if not steps.is_gone(site.error):
            made.append(outcome)
            continue
        word = named.get(id(site.each)) or _above(site.path) or options.manager
        try:
            if not word:
                raise errors.Failed(site.where, "is not there, and nothing names a manager to create it (see --manager)")
            if word not in holders:
                holders[word] = Holder(word)
            holder = holders[word]
            outcome = apply.Outcome(steps.Create(site, holder, holder.identity(site.each.id)))
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

def _memberships(site, at):
    """Whether a composite has its members; those that are not there are told apart from the others."""
    members = [at(one.component) for one in site.each.participants]
    members = [each for each in members if each is not None]
    usable = [each for each in members if each.error is None]
    made = []
    if usable:
        made.append(_on(site, steps.Members(site, usable), site.found is not None and all(
            each.node is not None and any(orb.same(ref, each.node.ref) for _, ref in site.found.members) for each in usable)))
    lost = [each for each in members if each.error is not None]
    if lost:
        made.append(apply.Outcome(steps.Members(site, lost), error=lost[0].error))
    return made


def _configurations(site):
    """Whether the parameters of each set have their values, and which set is active."""
    made = []
    now = {one.id: one.values for one in site.found.sets} if site.found else {}
    for one in site.each.configuration_sets:
        wanted = collections.OrderedDict((item.name, item.data or "") for item in one.configuration_data)
        there = now.get(one.id, {})
        known = collections.OrderedDict((n, v) for n, v in wanted.items() if n in there or not site.found or one.id not in now)
        for name in [name for name in wanted if name not in known]:
            step = steps.Values(site, one.id, {name: wanted[name]})
            made.append(apply.Outcome(step, apply.FAILED, errors.NoSuch(
                site.where, "configuration parameter", f"{printable(name)} in set {printable(one.id)}")))
        differing = collections.OrderedDict((n, v) for n, v in known.items() if there.get(n) != v)
        if known:
            made.append(_on(site, steps.Values(site, one.id, differing or known), not differing))
    active = site.each.active_configuration_set
    if active:
        touched = any(each.pending for each in made)  # setting values deactivates, until the set is activated again
        so = site.found is not None and site.found.active == active and not touched
        made.append(_on(site, steps.Active(site, active), so))
    return made


def _on(site, step, so):
    """The Outcome of a step on one Site."""
    if site.error is not None:
        return apply.Outcome(step, error=site.error)
    return apply.Outcome(step, apply.SO if so and site.found else apply.UNTRIED)


def _rates(site):
    """Whether the execution contexts that a component owns have their rates; those that it has not are passed over."""
    made = []
    for index, one in enumerate(site.each.execution_contexts):
        if not one.id.isdigit() or not 0 < one.rate < float("inf") or one.kind.upper()[:8] != "PERIODIC":
            continue
        if site.found is None:
            made.append(_on(site, steps.Rate(site, index, int(one.id), one.rate), False))
            continue
        for index, context in enumerate(site.found.owned):
            if context.handle == int(one.id):
                step = steps.Rate(site, index, context.handle, one.rate)
                made.append(_on(site, step, step.is_done([site.found.owned])))
    return made


# ---- connections ------------------------------------------------------------------------------------------------

def _ends(connector, at):
    """[(Site, port name)] of a connector. Raises Failed where the file does not say which component an end is on."""
    ends = []
    for end in connector.ends:
        site = at(end)
        if site is None:
            raise errors.Failed("connection " + (printable(connector.connector_id) or "without id"),
                                f"the file has no component for its end {printable(end.port_name)}")
        ends.append((site, capture.port_of(end)))
    return ends


class _Unplaced(steps.Step):
    """A connection that the file does not place."""

    kind = "connect"

    def __init__(self, connector, error):
        super().__init__([], error.where, error.where)


def _connections(profile, at):
    """Whether the connections are there; what is left of one that has lost an end is removed first."""
    ids = {each.connector_id for each in profile.connectors}
    made, broken = [], []
    for connector in profile.connectors:
        try:
            step = connect_steps.Connect(connector, _ends(connector, at), ids)
        except errors.Error as e:
            made.append([apply.Outcome(_Unplaced(connector, e), apply.FAILED, e)])
            continue
        error = next((site.error for site in step.sites if site.error is not None), None)
        made.append([apply.Outcome(step, error=error)])
        if error is None:
            broken += _seen(made, step)
    answers = iter(orb.each([ref for _, refs in broken for ref in refs], lambda ref: orb.is_alive("", ref)))
    for outcomes, refs in broken:
        found = [next(answers) for _ in refs]
        _mend(outcomes, any(isinstance(answer, errors.Silent) or not isinstance(answer, errors.Error) for answer in found))
    return [each for outcomes in made for each in outcomes]


def _seen(made, step):
    """Judge a Connect by what was found; [(its outcomes, references of strange ends)] if the connection is broken."""
    outcome = made[-1][0]
    try:
        at = [site.named(site.found.ports, name) if site.found else None for site, name in step.ends]
        if None in at:
            return []
        left = step.leftovers(at)
        if left:
            known = {orb.identity(port.ref) for port in at}
            refs = {orb.identity(ref): ref for _, one in left for ref in one.ports if ref is not None}
            return [(made[-1], [ref for key, ref in sorted(refs.items()) if key not in known])]
        if step.is_done(at):
            outcome.status = apply.SO
    except errors.Error as e:
        outcome.fail(e)
    return []


def _mend(outcomes, in_use):
    """Put the removal of what is left of a connection before it, or let it fail where the rest is in use."""
    step = outcomes[0].step
    if in_use:
        outcomes[0].fail(errors.Refused(step.where, "connection %s joins other ports; rtdis removes it" % (
            printable(step.connector.connector_id))))
        return
    removal = connect_steps.Disconnect(step.connector, step.ends)
    removal.is_done([site.named(site.found.ports, name) for site, name in step.ends])
    outcomes.insert(0, apply.Outcome(removal))


# ---- tearing down -----------------------------------------------------------------------------------------------

def tearing_down(profile, options):
    """(the apply.Outcomes of the steps that remove the connections of a profile, notes on components that are gone).

    Where one end is gone, the others are freed. That no component is there at all is a failure.
    """
    sites = _sites(profile)
    asked = [site for site in sites.values() if site.error is None]
    for site, found in zip(asked, tree.on_components([site.path for site in asked], _ports_only)):
        if isinstance(found, errors.Error):
            site.error = found
        else:
            site.found, site.node = found, found.node
    lost = [site for site in sites.values() if site.error is not None]
    some = len(lost) < len(sites) or not sites
    outcomes = [_presence(site) for site in lost if not (some and steps.is_gone(site.error))]
    notes = [str(site.error) for site in lost if some and steps.is_gone(site.error)]
    at = _site_finder(capture.locator(profile, options.strict), sites)
    for connector in profile.connectors:
        outcomes.append(_removal(connector, at))
    if not some:
        for each in outcomes:
            if each.status == apply.SO:
                each.status, each.error = apply.UNTRIED, lost[0].error
    return outcomes, notes


def _ports_only(node):
    return capture.Found(node, ports.in_system(ports.ports(node)), [], {}, [], "", [], None)


def _removal(connector, at):
    try:
        step = connect_steps.Disconnect(connector, _ends(connector, at))
    except errors.Error as e:
        return apply.Outcome(_Unplaced(connector, e), apply.FAILED, e)
    try:
        there = [site.named(site.found.ports, name) for site, name in step.ends if site.error is None]
        return apply.Outcome(step, apply.SO if step.is_done(there) else apply.UNTRIED)
    except errors.NoSuch as e:
        return apply.Outcome(step, apply.FAILED, e)
    except errors.Error as e:  # an end that does not answer; it is reported itself
        return apply.Outcome(step, error=e)
