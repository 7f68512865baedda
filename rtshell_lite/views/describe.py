"""What rtcat shows of a component or a port, as lines or as JSON."""
import collections

from rtshell_lite import errors, text
from rtshell_lite.corba import orb
from rtshell_lite.robot import component, composites, ports
from rtshell_lite.text import from_wire, printable

# All that rtcat knows of one component. `compositions` are those that it owns, as (id, [path text of a member]); `parents`
# those that it belongs to, as (id, name of the composite, its path text). `states` are those in its contexts. The details are
# empty at level 0.
Found = collections.namedtuple("Found", "node profile states contexts ports compositions parents")


def collect(node, level=0):
    """Ask a component for everything that rtcat shows, a Found; the profile comes last (it can end a component of 2.1).

    `level` is how often -l was given: from 1 on, members and composites are asked for their names.
    """
    found = ports.ports(node, brief=not level)
    owned, participating = component.context_refs(node)
    contexts = component.contexts(node, owned) if level else component.known_by_handle(node, owned)
    contexts = [each for each in contexts + component.contexts(node, participating) if each is not None]
    states = component.states(node, [context.ref for context in contexts])
    if level:
        compositions = [(one.id, composites.member_paths(node, one)) for one in composites.owned(node)]
    else:
        compositions = [("", [])] * len(composites.owned_refs(node))
    parents = _parents(node, contexts[len(owned):])
    return Found(node, component.profile(node, brief=not level), states, contexts, found, compositions, parents)


def _parents(node, participating):
    ids = composites.belonging_ids(node)
    known = composites.composites(node, participating) if ids else {}
    return [(one,) + known.get(one, ("Unknown", "Unknown")) for one in ids]


# ---- lines ----------------------------------------------------------------------------------------------------

def lines(found, level, ends, paint):
    """The lines of rtcat for a component.

    level  how often -l was given
    ends   names the far ends of connections (see `places.far_ends`)
    paint  colours words (see `text.painter`)
    """
    profile = found.profile
    yield f"{found.node.name}  {paint(component.merged(found.states))}"
    kind = ("Composite" if found.compositions else "Monolithic") + (" composite member" if found.parents else "")
    yield from _pairs([("Category", profile.category), ("Description", profile.description),
                       ("Instance name", profile.instance_name), ("Type name", profile.type_name),
                       ("Vendor", profile.vendor), ("Version", profile.version), ("Parent", profile.parent),
                       ("Type", kind)], "  ")
    if profile.properties and level < 2:
        yield " +Extra properties"
    elif profile.properties:
        yield "  Extra properties:"
        yield from _pairs(sorted(profile.properties), "    ")
    # with -ll rtshell indents what follows by a blank or two more, and there are scripts that cut by column
    tag, more = (" ", "  ") if level > 1 else ("", "")
    yield from composition_lines(found, level, tag, more, paint)
    for context in found.contexts:
        if _owned(context):
            yield from context_lines(context, found, level, tag, more, paint)
    for port in found.ports:
        yield from port_lines(port, profile.instance_name, level, ends, paint, tag, more)


def _pairs(items, indent):
    return text.pairs([(printable(text.cut(name)), printable(text.cut(value))) for name, value in items], indent)


def _owned(context):
    return context.handle < 1000  # handles of participating contexts start there


def composition_lines(found, level, tag, more, paint):
    """The lines of the compositions that a component owns and of those that it belongs to.

    Here and below, `tag` comes before headings, `more` is the further indentation of what is below them.
    """
    sign = "-" if level else "+"
    for one, members in found.compositions:
        yield f"{tag}{sign}Composition {paint(printable(found.profile.instance_name), 'bold')}"
        yield from text.pairs([("ID", printable(one))] + [("Member", path) for path in members], more + "  ") if level else ()
    for one, name, path in found.parents:
        yield f"{tag}{sign}Parent composition {paint(printable(name), 'bold')}"
        yield from text.pairs([("ID", printable(one)), ("Path", path)], more + "  ") if level else ()


def context_lines(context, found, level, tag, more, paint):
    """The lines of one execution context."""
    sign = "-" if level else "+"
    yield f"{tag}{sign}Execution Context {paint(str(context.handle), 'bold')}"
    if not level:
        return
    items = [("State", "Running" if context.running else "Stopped"), ("Kind", context.kind), ("Rate", str(float(context.rate)))]
    owner = _instance(context.owner, found)
    yield from _pairs(items + ([("Owner", owner)] if owner else []), more + "  ")
    if context.participants:
        yield more + (" +" if level < 2 else " -") + "Participants"
        for participant in context.participants if level > 1 else ():
            yield more + "    " + printable(_instance(participant, found))
    if context.properties:
        yield more + (" +" if level < 2 else " -") + "Extra properties"
        yield from _pairs(sorted(context.properties), more + "    ") if level > 1 else ()


def _instance(ref, found):
    """The instance name of a component that takes part in a context."""
    if ref is None:
        return ""
    if orb.same(ref, found.node.ref):
        return found.profile.instance_name
    try:
        return from_wire(orb.ask(str(found.node.path), ref, "get_sdo_id"))
    except errors.Error:
        return "Unknown"


def port_lines(port, instance, level, ends, paint, tag="", more=""):
    """The lines of one port of the component called `instance`."""
    yield f"{tag}{'-' if level else '+'}{port.type}: {paint(printable(ports.short_name(port.name, instance)), 'bold')}"
    if not level:
        return
    yield from _pairs(sorted(port.properties.items()), more + "  ")
    for interface in port.interfaces:
        yield more + "  Interface:"
        yield from _pairs(zip(("Instance name", "Type name", "Polarity"), interface), more + "    ")
    listed = 0
    for connector in port.connectors:
        far = [end for end in map(ends, connector.ports) if end]
        listed += len(far)
        if not far:
            continue
        yield f"{more} {'-' if level > 1 else '+'}Connected to  {paint(far[0], 'bold')}"
        for end in far[1:]:
            yield more + " " * 16 + paint(end, "bold")
        if level > 1:
            yield from _pairs([("Name", connector.name), ("ID", connector.id)] + _shown(connector), more + "    ")
    others = len(port.connectors) - listed
    if others > 0:
        yield "%s  (%d other connection%s)" % (more, others, "s" if others > 1 else "")


def _shown(connector):
    """Properties without the data ports' references, which mean nothing to a person."""
    return [(name, value) for name, value in connector.properties if not name.endswith(("inport_ref", "inport_ior"))]


# ---- JSON -----------------------------------------------------------------------------------------------------

def as_dict(found, ends):
    """The JSON object of a component."""
    fields = dict(found.profile._asdict(), properties=dict(found.profile.properties), path=str(found.node.path),
                  state=component.merged(found.states), composite=bool(found.compositions), composite_member=bool(found.parents))
    fields["compositions"] = [{"id": one, "members": members} for one, members in found.compositions]
    fields["parent_compositions"] = [{"id": one, "name": name, "path": path} for one, name, path in found.parents]
    fields["execution_contexts"] = [
        {"handle": c.handle, "kind": c.kind, "rate": c.rate, "running": c.running, "owner": _instance(c.owner, found),
         "participants": [_instance(p, found) for p in c.participants], "properties": dict(c.properties),
         "state": state} for c, state in zip(found.contexts, found.states)]
    fields["ports"] = [port_dict(port, ends) for port in found.ports]
    return fields


def port_dict(port, ends):
    """The JSON object of a port."""
    return {"path": ports.label(port), "name": port.name, "type": port.type, "properties": port.properties,
            "interfaces": [dict(i._asdict()) for i in port.interfaces],
            "connectors": [{"id": c.id, "name": c.name, "properties": dict(c.properties),
                            "connected_to": [end for end in map(ends, c.ports) if end]} for c in port.connectors]}
