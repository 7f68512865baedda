"""Composite components: the organisations that they own and that their members belong to
(SDOPackage::Organization).

Organization::get_owner is never called: a C++ component answers it once, and has no owner from then on.
"""

from rtshell_lite import errors, notes
from rtshell_lite.corba import orb, refusals, session
from rtshell_lite.records import record
from rtshell_lite.robot import component, configuration, manager, ports, tree
from rtshell_lite.robot.places import Places
from rtshell_lite.text import from_wire, printable, shell_word, to_wire

DEFAULT_NAME = "CompositeRTC"  # of a composite

# One organisation: `members` are (instance name, reference), an errors.Error in the place of a name that is
# not known.
Organisation = record("Organisation", "id ref members")
COMPOSITE = "PeriodicECSharedComposite"
# parameter of a composite's set `default`: a comma-separated list of INSTANCE.port
EXPORTED = "exported_ports"

JOINING = 2.0  # seconds within which a context knows a new member: few are slower than 0.5 Hz


# ---- asking ----


async def owned(node, with_members=True):
    """The Organisations that a component owns, a composite if there are any;
    each of their members is asked for its name.
    """
    refs = await _refs(node, "get_owned_organizations")
    if not with_members:
        return [Organisation("", ref, []) for ref in refs]
    return [await _organisation(node, ref) for ref in refs]


async def belonging(node, contexts):
    """(id, name of the composite, its path as text) of each organisation that a component is a member of.

    The composites are among the owners of `contexts`, the component.Contexts that it takes part in; Unknown
    where one does not answer.
    """
    ids = [
        from_wire(await orb.call(node.path, ref, "get_organization_id"))
        for ref in await _refs(node, "get_organizations")
    ]
    composites = await _composites(node, contexts) if ids else {}
    return [(own_id, *composites.get(own_id, ("Unknown", "Unknown"))) for own_id in ids]


async def _composites(node, contexts):
    """{id of its organisation: (instance name, path as text)} of the owners of these contexts."""
    places = Places()
    by_id = {}
    for owner in [context.owner for context in contexts if context.owner is not None]:
        above = tree.Node(node.path, "component", owner)
        try:
            name = from_wire(await above.call("get_sdo_id"))
            for ref in await _refs(above, "get_owned_organizations"):
                organisation_id = from_wire(await orb.call(node.path, ref, "get_organization_id"))
                by_id[organisation_id] = (name, await _path_text(places, name, owner, node))
        except errors.Unreachable:
            continue
    return by_id


async def _refs(node, operation):
    try:
        listed = notes.first(component.MOST_CONTEXTS, await node.call(operation), node.path, "organizations")
        return [ref for ref in listed if ref is not None]
    except errors.Refused as e:
        if e.name in ("NO_IMPLEMENT", "BAD_OPERATION"):  # small implementations lack compositions
            return []
        raise


async def _organisation(node, ref):
    listed = notes.first(
        component.MOST_MEMBERS, await orb.call(node.path, ref, "get_members"), node.path, "members"
    )
    members = [member for member in listed if member is not None]

    async def name_of(member):
        return from_wire(await orb.call(node.path, member, "get_sdo_id"))

    names = await session.each(members, name_of, lambda member: (orb.endpoint(member), node.path))
    organisation_id = from_wire(await orb.call(node.path, ref, "get_organization_id"))
    return Organisation(organisation_id, ref, list(zip(names, members)))


async def member_paths(node, organisation):
    """Paths of the members of an Organisation, as text;
    `Unknown (…)` for those that are dead or bound nowhere.
    """
    places = Places()
    return [await _path_text(places, name, ref, node) for name, ref in organisation.members]


async def _path_text(places, name, ref, node):
    if isinstance(name, errors.Error):
        is_gone = await refusals.shows_death(name, orb.endpoint(ref), node.endpoint[0])
        return "Unknown (it is gone)" if is_gone else f"Unknown ({name.why})"
    path = await places.path(name, ref, node)
    return str(path) if path else f"Unknown ({printable(name)})"


# ---- changing ----

# A member to add or to remove, and its ports to export or to hide; `node` is None for one that is gone.
Member = record("Member", "instance node ports")


async def member(path, must_live=True):
    """The Member that PATH[:PORT,PORT…] names. Raises NoSuch for ports that it lacks, and what
    `tree.component` raises.

    With `must_live` False a component that is gone is named by its path alone.
    """
    port_names = [name for name in (path.port or "").split(",") if name]
    try:
        node = await tree.component(path.object())
        instance = from_wire(await node.call("get_sdo_id"))
    except (errors.NotFound, errors.Unreachable):
        if must_live or not path.names:
            raise
        return Member(path.instance, None, port_names)
    if must_live and port_names:
        names = [ports.short_name(port.name, instance) for port in await ports.ports(node)]
        for name in port_names:
            if name not in names:
                raise errors.NoSuch(str(path.object()), "port", printable(name))
    return Member(instance, node, port_names)


async def together(members):
    """Live Members, each once with all the ports wanted of it.
    Raises Failed for two that a composite could not distinguish.
    """
    merged = {}  # type: dict
    for m in members:
        first = merged.setdefault(m.instance, m)
        if not await _is(m, first.node.ref):
            why = f"has the same name as {first.node.path!s}; a composite cannot have both"
            raise errors.Failed(str(m.node.path), why)
        merged[m.instance] = first._replace(ports=list(dict.fromkeys(first.ports + m.ports)))
    return list(merged.values())


async def first_organisation(node):
    """The first Organisation of a composite. Raises WrongKind for other components."""
    organisations = await owned(node)
    if not organisations:
        raise errors.WrongKind(str(node.path), "composite component", "component")
    return organisations[0]


async def check(node, organisation, joining, leaving):
    """Raise Failed or NoSuch for Members that cannot join an Organisation of a composite, or leave it.

    A dead member cannot leave: the composite calls it, and does not survive that (C++ 2.1: its process ends,
    at once or when it is activated; Python: its execution context stops for good). Its ports can be hidden.
    """
    members = {name: ref for name, ref in organisation.members if not isinstance(name, errors.Error)}
    for m in joining:
        if orb.same(m.node.ref, node.ref):
            raise errors.Failed(str(node.path), "cannot be a member of itself")
        if m.instance in members and not await _is(m, members[m.instance]):
            raise errors.Failed(str(node.path), f"has another member called {printable(m.instance)}")
    for m in leaving:
        is_member = m.instance in members if m.node is None else await _is(m, members.get(m.instance))
        lost = None if m.ports else _lost(organisation, m.instance)
        if lost:
            raise _stays(node, m, lost)
        if not (m.ports or is_member):
            raise errors.NoSuch(str(node.path), "member", printable(m.instance))


def _lost(organisation, instance):
    """The error of a member of an Organisation that may be the one called `instance`, or None.

    A composite takes the first one of the name; a dead one cannot give its own.
    """
    for name, _ in organisation.members:
        if isinstance(name, errors.Error) or name == instance:
            return name if isinstance(name, errors.Error) else None
    return None


def _stays(node, m, error):
    """The error for a Member that cannot be removed, as it, or one that may have its name,
    has failed with `error`.
    """
    why = "a member that does not answer" if isinstance(error, errors.Unanswered) else "a dead member"
    return errors.Failed(
        str(node.path),
        f"cannot remove {printable(m.instance)}: letting go of {why} would end this composite's "
        "process or stop its execution context; restart that process",
    )


async def _is(m, ref):
    if orb.same(ref, m.node.ref):
        return True
    return orb.same(ref, await component.canonical(m.node))


async def add(node, organisation, members):
    """Make Members part of a composite and export their ports; yields lines that say what was done.
    Raises Refused.
    """
    shown = [f"{m.instance}.{port}" for m in members for port in m.ports]
    for line in await _export(node, add_ports=shown):
        yield line
    present = [name for name, _ in organisation.members]
    new = [m for m in members if m.instance not in present]
    if new:  # an empty list is refused
        refs = [m.node.typed for m in new]
        if not await orb.call(node.path, organisation.ref, "add_members", refs):
            raise errors.Refused(str(node.path), "does not take members")
        await _be_known(node, new)
    for m in new:
        yield f"added component {m.node.path!s}"
    for m in members:
        if m not in new:
            yield f"component {m.node.path!s} is a member already"


async def _be_known(node, members):
    """Wait until the contexts of a composite know its new Members, JOINING seconds at most. One of C++ 2.x
    takes them in its next cycle (docs/protocol.md 2.6); activated before that, it leaves them Inactive.
    """

    async def are_known():
        for context in contexts:
            for m in members:
                if await component.state_in(m.node, context) == "Created":
                    return False
        return True

    try:
        contexts = await component.owned_context_refs(node)
        await component.until(are_known, JOINING)
    except errors.Error:
        return  # they have been taken


async def remove(node, organisation, members):
    """Remove Members, or hide their ports where they name some; yields lines that say what was done.

    Raises what `_remove` raises, and Failed for one that has died since `check`.
    """
    if not members:
        return
    going = [m for m in members if not m.ports]
    hidden = [f"{m.instance}.{port}" for m in members for port in m.ports]
    for line in await _export(node, hide=hidden, hide_all_of=[m.instance for m in going]):
        yield line
    for m in going:
        await _must_live(node, organisation, m)
        await _remove(node, organisation, m)
        yield f"removed component {printable(m.instance)}"


async def _remove(node, organisation, m):
    """Remove one Member. Raises Refused, and Failed where the composite lets it go, calls it, and fails."""
    try:
        is_removed = await orb.call(node.path, organisation.ref, "remove_member", to_wire(m.instance))
    except errors.Refused as e:
        now = await component.uncertain_if_refused(first_organisation(node))
        if m.instance in [name for name, _ in now.members] or _lost(now, m.instance):
            raise
        why = f"has let {printable(m.instance)} go, and then failed ({e.why}); whether that runs is not known"
        raise errors.Failed(str(node.path), why)
    if not is_removed:
        raise errors.Refused(str(node.path), f"does not remove member {printable(m.instance)}")


async def _must_live(node, organisation, m):
    for name, ref in organisation.members:
        if name == m.instance:
            try:
                await orb.is_alive(node.path, ref)
            except errors.Unreachable as e:
                raise _stays(node, m, e)


async def _export(node, add_ports=(), hide=(), hide_all_of=()):
    """Change the list of exported ports and activate it; lines that say what was done."""
    sets = await configuration.of(node)
    within = sets.set("default")
    now = [name.strip() for name in within.values.get(EXPORTED, "").split(",") if name.strip()]
    kept = [name for name in now if name not in hide and name.rpartition(".")[0] not in hide_all_of]
    exported = kept + [name for name in add_ports if name not in kept]
    if exported != now:
        await sets.store({EXPORTED: ",".join(exported)}, within)
        await sets.activate("default")
    lines = ["exported port " + printable(name) for name in exported if name not in now]
    lines += [f"port {printable(name)} is exported already" for name in add_ports if name in kept]
    lines += ["hid port " + printable(name) for name in now if name not in exported]
    lines += [f"port {printable(name)} is hidden already" for name in hide if name not in now]
    return lines


# ---- rtcomp: find or make a composite on a manager, then change its members ----


async def compose(target, adding, removing, type_name=COMPOSITE, options="", dry_run=False):
    """Make or change the composite at `target` (a Path); yields lines that say what was done, or with
    `dry_run` would do it.

    `adding` and `removing` are Paths whose port part is a comma-separated list. Everything is checked before
    the first change. Raises WrongKind, NoSuch, Refused, and what `tree.component` raises.
    """
    name = target.port or DEFAULT_NAME
    argument = f"{type_name}?instance_name={name}"
    if options:
        manager.check_pairs(options)
        argument += "&" + options
    if any(c in name for c in "?&="):
        raise errors.Usage(f"a composite cannot be called {printable(name)}")
    manager.check_argument(argument)
    members = await together([await member(path) for path in adding])
    leaving = [await member(path, must_live=False) for path in dict.fromkeys(removing)]
    holder = await tree.component(target.object(), or_manager=True)
    if holder.kind == "component" and target.port is not None:
        raise errors.WrongKind(str(target), "component or manager", "port")
    if holder.kind == "component" and not (adding or removing):
        await first_organisation(holder)
        raise errors.Usage(f"{target!s}: nothing to do: name members to add (-a) or to remove (-r)")
    composite = holder if holder.kind == "component" else await _of_manager(holder, name)
    is_asked_for = target.port or adding or removing or options
    if composite is None and not is_asked_for:
        raise errors.Usage(f"{target!s}: nothing to do: name a composite (MANAGER:NAME), or its members (-a)")
    if composite is None and leaving:
        raise errors.Failed(str(holder.path), "cannot remove components or ports from a new composite")
    if composite is not None:
        await check(composite, await first_organisation(composite), members, leaving)
    if dry_run:
        yield _command(target, composite, adding, removing, type_name, options)
        return
    if composite is None:
        created = "created composite " + await manager.create(holder, argument, wait=manager.SETTLE_TIME)
        try:
            composite = await _new(holder, name)
        except errors.WrongKind:
            raise  # it is gone again
        except errors.Error:
            yield created
            raise
        yield created
    organisation = await first_organisation(composite)
    async for line in add(composite, organisation, members):
        yield line
    async for line in remove(composite, organisation, leaving):
        yield line


async def _new(holder, name):
    """The composite just created; deleted again if its type makes it a component of another kind."""
    composite = await _of_manager(holder, name)
    if composite is None:
        why = f"does not list {printable(name)}, which it has just created: whether it is there is not known"
        raise errors.Failed(str(holder.path), why)
    try:
        await first_organisation(composite)
    except errors.WrongKind:
        await manager.delete(holder, name)
        raise
    return composite


async def _of_manager(holder, name):
    return dict(await manager.components(holder)).get(name)


def _command(target, composite, adding, removing, type_name, options):
    words = ["rtcomp"]
    if composite is None:
        words += ["-t", type_name]
    if options:
        words += ["-o", options]
    for option, paths in (("-a", adding), ("-r", removing)):
        words += [word for path in paths for word in (option, str(path))]
    return " ".join(map(shell_word, words + [str(target)]))
