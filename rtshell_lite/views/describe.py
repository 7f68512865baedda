"""What rtcat shows of a component or a port, as lines or as JSON."""

from rtshell_lite import text
from rtshell_lite.corba import orb
from rtshell_lite.robot import component, ports
from rtshell_lite.robot.snapshot import BRIEF, FULL, Snapshot
from rtshell_lite.text import printable


async def collect(node, level=0):
    """The Snapshot of a component with everything that rtcat shows.

    `level` is how often -l was given: from 1 on, all parts are full.
    """
    parts = {
        "ports": BRIEF,
        "owned": BRIEF,
        "participating": FULL,
        "states": FULL,
        "organisations": BRIEF,
        "composites": FULL,
        "names": BRIEF,
    }
    if not level:
        return await Snapshot(node).ask(**parts, profile=BRIEF)
    parts.update(ports=FULL, owned=FULL, organisations=FULL, members=FULL)
    if level > 1:
        parts["names"] = FULL
    return await Snapshot(node).ask(**parts, profile=FULL)


# ---- lines ----


def lines(snapshot, level, ends, paint):
    """The lines of rtcat for a component, given its Snapshot.

    level  how often -l was given
    ends   names the far ends of connections (see `places.far_names`)
    paint  colours words (see `text.painter`)
    """
    profile = snapshot.profile
    yield f"{snapshot.node.name}  {paint(component.merged(snapshot.states))}"
    kind = "Composite" if snapshot.organisations else "Monolithic"
    if snapshot.composites:
        kind += " composite member"
    others = [("Parent", profile.parent), ("Type", kind)]
    yield from _pairs(component.facts(profile._asdict()) + others, "  ")
    if profile.properties and level < 2:
        yield " +Extra properties"
    elif profile.properties:
        yield "  Extra properties:"
        yield from _pairs(sorted(profile.properties), "    ")
    # with -ll rtshell indents the following by a blank or two more, and there are scripts that cut by column
    tag, more = (" ", "  ") if level > 1 else ("", "")
    yield from composition_lines(snapshot, level, tag, more, paint)
    for context, state in zip(snapshot.contexts, snapshot.states):
        yield from context_lines(context, state, snapshot, level, tag, more, paint)
    for port in snapshot.ports:
        yield from port_lines(port, profile.instance_name, level, ends, paint, tag, more)


def _pairs(items, indent):
    return text.pairs(
        [(printable(text.cut(name)), printable(text.cut(value))) for name, value in items], indent
    )


def composition_lines(snapshot, level, tag, more, paint):
    """The lines of the compositions that a component owns and of those that it belongs to.

    Here and below, `tag` comes before headings, `more` before what is below them.
    """
    sign = "-" if level else "+"
    for organisation in snapshot.organisations:
        yield f"{tag}{sign}Composition {paint(printable(snapshot.profile.instance_name), 'bold')}"
        if level:
            members = [("Member", path) for path in snapshot.members[organisation.id]]
            yield from text.pairs([("ID", printable(organisation.id))] + members, more + "  ")
    for organisation_id, name, path in snapshot.composites:
        yield f"{tag}{sign}Parent composition {paint(printable(name), 'bold')}"
        if level:
            yield from text.pairs([("ID", printable(organisation_id)), ("Path", path)], more + "  ")


def context_lines(context, state, snapshot, level, tag, more, paint):
    """The lines of one execution context; with the state of the component there if it is in several,
    and the owner if that is another.
    """
    sign = "-" if level else "+"
    if context.handle is None:
        yield f"{tag}+Execution Context of another component, which does not answer  {paint(state)}"
        return
    words = f"{tag}{sign}Execution Context {paint(str(context.handle), 'bold')}"
    if not any(context is own for own in snapshot.owned):
        words += f" of {printable(instance(context.owner, snapshot))}"
    if len(snapshot.contexts) > 1:
        words += f"  {paint(state)}"
    yield words
    if not level:
        return
    runs = "Running" if context.running else "Stopped"
    items = [("State", runs), ("Kind", context.kind), ("Rate", str(float(context.rate)))]
    owner = instance(context.owner, snapshot)
    if owner:
        items.append(("Owner", owner))
    yield from _pairs(items, more + "  ")
    if level < 2:
        if context.participants:
            yield more + " +Participants"
        if context.properties:
            yield more + " +Extra properties"
        return
    if context.participants:
        yield more + " -Participants"
        for participant in context.participants:
            yield more + "    " + printable(instance(participant, snapshot))
    if context.properties:
        yield more + " -Extra properties"
        yield from _pairs(sorted(context.properties), more + "    ")


def instance(ref, snapshot):
    """The instance name of a component that owns a context, or takes part in it."""
    if ref is None:
        return ""
    if orb.same(ref, snapshot.node.ref):
        return snapshot.profile.instance_name
    return snapshot.names.get(orb.identity(ref), "Unknown")


def port_lines(port, instance, level, ends, paint, tag="", more=""):
    """The lines of one port of the component called `instance`."""
    name = paint(printable(ports.short_name(port.name, instance)), "bold")
    if not level:
        yield f"{tag}+{port.type}: {name}"
        return
    yield f"{tag}-{port.type}: {name}"
    yield from _pairs(sorted(port.properties.items()), more + "  ")
    for interface in port.interfaces:
        yield more + "  Interface:"
        yield from _pairs(zip(("Instance name", "Type name", "Polarity"), interface), more + "    ")
    listed = 0
    for connector in port.connectors:
        far = [end for end in map(ends, connector.ports) if end]
        how = "Connected to"
        if not far and len(connector.ports) == 1:
            how = "Connected by"
            far = [carrier for carrier in [printable(ports.transport(connector))] if carrier]
        if not far:
            continue
        listed += len(far)
        sign = "-" if level > 1 else "+"
        yield f"{more} {sign}{how}  {paint(far[0], 'bold')}"
        for end in far[1:]:
            yield more + " " * 16 + paint(end, "bold")
        if level > 1:
            yield from _pairs(
                [("Name", connector.name), ("ID", connector.id)] + _shown(connector), more + "    "
            )
    others = len(port.connectors) - listed
    if others > 0:
        yield f"{more}  ({text.counted(others, 'other connection')})"


def _shown(connector):
    """Properties except references of data ports, which mean nothing to a person."""
    return [
        (name, value)
        for name, value in connector.properties
        if not name.endswith(("inport_ref", "inport_ior"))
    ]


# ---- JSON ----


def as_dict(snapshot, ends):
    """The JSON object of a component."""
    fields = dict(
        snapshot.profile._asdict(), properties=dict(snapshot.profile.properties),
        path=str(snapshot.node.path), state=component.merged(snapshot.states),
        composite=bool(snapshot.organisations), composite_member=bool(snapshot.composites),
    )
    fields["compositions"] = [
        {"id": organisation.id, "members": snapshot.members[organisation.id]}
        for organisation in snapshot.organisations
    ]
    fields["parent_compositions"] = [
        {"id": organisation_id, "name": name, "path": path}
        for organisation_id, name, path in snapshot.composites
    ]
    fields["execution_contexts"] = [
        {
            "handle": c.handle,
            "kind": c.kind,
            "rate": c.rate,
            "running": c.running,
            "owner": instance(c.owner, snapshot),
            "participants": [instance(p, snapshot) for p in c.participants],
            "properties": dict(c.properties),
            "state": state,
        }
        for c, state in zip(snapshot.contexts, snapshot.states)
        if c.handle is not None
    ]
    fields["ports"] = [port_dict(port, ends) for port in snapshot.ports]
    return fields


def port_dict(port, ends):
    """The JSON object of a port."""
    return {
        "path": ports.label(port),
        "name": port.name,
        "type": port.type,
        "properties": port.properties,
        "interfaces": [dict(i._asdict()) for i in port.interfaces],
        "connectors": [
            {
                "id": c.id,
                "name": c.name,
                "properties": dict(c.properties),
                "connected_to": [end for end in map(ends, c.ports) if end],
            }
            for c in port.connectors
        ],
    }
