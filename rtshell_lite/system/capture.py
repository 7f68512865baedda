"""A system as a value: components, connections and configuration, asked of what is running,
in the shape of an RtsProfile.
"""

import collections
import functools
import re

from rtshell_lite import errors, path
from rtshell_lite.corba import orb, session
from rtshell_lite.robot import component, places, ports, search, snapshot, tree
from rtshell_lite.robot.snapshot import BRIEF, FULL, NAMES, PROFILE
from rtshell_lite.text import from_wire, printable
from rtshell_lite.xmlprofile import model, rtsprofile

# the property by which rtshell and RTSystemEditor say where the component of an end is bound
PATH_ID = "COMPONENT_PATH_ID"
# an extended property of a component: path of the manager that lists it, and can create it
MANAGER = "MANAGER"
# An extended property of a component: corbaloc of its object, when it was saved. It shows whether it lives
# where its name is lost.
REFERENCE = "REFERENCE"
# what of component.FACTS the id of a component says, in its order
IN_ID = ("vendor", "category", "type_name", "version")
# Fields of a model.DataPortConnector that mean properties `dataport.…` of the connection.
DATA_FIELDS = ("data_type", "interface_type", "dataflow_type", "subscription_type")

# What is asked of one component. `owned` are Contexts, `states` {handle: state} over all of its contexts,
# empty if not asked, `sets` configuration.Sets, hidden ones too, `members` (name, reference) of those that it
# is composed of.
ComponentState = collections.namedtuple(
    "ComponentState", "node ports owned states sets active members profile snapshot"
)

# `found` has the ComponentState of each component of the RtsProfile `profile`, `unused` those that were left
# out because nothing is connected to them, `failures` are errors, `notes` lines on what else is left out.
# `lost` are the paths, as text, of components that did not answer, with (host, port) of their processes,
# `loose` the Looses.
System = collections.namedtuple("System", "profile found unused failures notes lost loose")

# A connection of which all ends but one do not answer, so that nobody knows whether it is there: the model's
# connector with this one; (host, port) of the process of another; the line of the notes on it.
Loose = collections.namedtuple("Loose", "connector endpoint note")

# Object references, some of them in the names of 1.1 to 2.1: they say where a port is today, and mislead
# tomorrow.
_REFERENCE = re.compile(r"dataport\.corba_cdr\.(?:in|out)port_(?:ior|ref)\Z")


# ---- asking ----


async def ask(node, brief=False, states=True, everything=False):
    """The ComponentState of a component. Its ports come before its profile (docs/protocol.md 1.1).

    brief       of properties and references only those that go into a file or are compared with one:
                a quarter of the memory
    everything  all that rtcat shows, too, which stays in a snapshot.Snapshot
    """
    if brief:
        of_ports = BRIEF
        of_profile = NAMES
    else:
        of_ports = of_profile = FULL
    of_contexts = FULL if everything else PROFILE
    in_contexts = {"participating": BRIEF, "states": FULL} if states else {}
    if everything:
        in_contexts.update(participating=FULL, composites=FULL, members=FULL, names=FULL)
    shown = await snapshot.of(
        node, ports=of_ports, owned=of_contexts, **in_contexts, configuration=FULL, organisations=FULL,
        profile=of_profile,
    )
    if states and not everything and len(shown.contexts) > 1:  # one context counts, whether it runs or not
        shown.owned = [await _with_running(shown, context) for context in shown.owned]
    found = found_in(shown, brief)
    if everything:
        return found._replace(snapshot=shown)
    return found


async def _with_running(shown, context):
    return context._replace(running=await component.is_running(shown.node, context.ref))


def found_in(shown, brief=False):
    """The ComponentState of a component by a snapshot.Snapshot of it.
    Raises Unreachable where a context of its own does not answer.
    """
    node = shown.node
    contexts = shown.owned
    if any(context.handle is None for context in contexts):
        raise errors.Unreachable(str(node.path), "one of its execution contexts does not answer")
    if brief:
        contexts = [context._replace(ref=None, owner=None, properties=()) for context in contexts]
    if shown.configuration:
        sets = shown.configuration.sets(with_hidden=True)
        active = shown.configuration.active
    else:
        sets = []
        active = ""
    return ComponentState(
        node, ports.in_system(shown.ports), contexts,
        {context.handle: state for context, state in zip(shown.contexts, shown.states)}, sets, active,
        [member for each in shown.organisations for member in each.members], shown.profile, None,
    )


def component_id(profile):
    """The id of a component in an RtsProfile, from its Profile."""
    return ":".join(["RTC"] + [getattr(profile, name) for name in IN_ID])


def identity(component_id):
    """{name: text} of component.FACTS that the id of a component in an RtsProfile says."""
    return dict(zip(IN_ID, component_id.split(":")[1:] + [""] * len(IN_ID)))


def path_uri(node):
    """Where a component is bound, as an RtsProfile has it: its path without the first slash."""
    return str(node.path).lstrip("/")


def saved_reference(component):
    """The reference in a model.Component, None where it has none; nobody is asked."""
    text = component.property(REFERENCE) or ""
    address, _, key = text.partition("corbaloc:iiop:")[2].partition("/")
    if not key:
        return None
    try:
        return orb.corbaloc(component.path_uri, address, key, path.DEFAULT_PORT)
    except errors.Error:
        return None


async def living_reference(component):
    """The reference in a model.Component, if what it refers to answers, by the name of the component; else
    None: a file may have been changed by hand. Raises Unreachable, also where it may live: see `doubt`.
    """
    ref = saved_reference(component)
    if ref is None:
        return None
    try:
        name = await orb.call(component.path_uri, orb.narrow(ref, "OpenRTM.DataFlowComponent"), "get_sdo_id")
    except (errors.Gone, errors.Garbled):
        return None
    except errors.Unreachable as e:
        if e.why.startswith("garbled answer"):  # something else listens there now
            return None
        raise
    except errors.Error:
        return None
    return ref if from_wire(name) == component.instance_name else None


async def doubt(component, where, e):
    """Why a model.Component may live whose reference raised the errors.Unreachable `e`, in words; '' where
    that shows that it is gone. `where` is its Path.
    """
    ref = saved_reference(component)
    place = orb.at_address(ref)
    if isinstance(e, errors.ConnectionRefused):
        if isinstance(await orb.refusal(where, orb.endpoint(ref)), errors.ProcessGone):
            return ""
        return f"{place}, where it was, refuses: dead, or a firewall closes this port"
    if isinstance(e, errors.NotAsked):
        return f"{place}, where it was, could not be asked ({e.why})"
    if isinstance(e, errors.Silent):
        return f"{place}, where it was, does not answer ({e.why}): it hangs, or is out of reach"
    return f"{place}, where it was, is out of reach ({e.why})"


def is_reference(name, value):
    """True for a property of a connection that holds an object reference."""
    return bool(_REFERENCE.match(name) or (value or "").startswith("IOR:"))


# ---- capturing ----


async def capture(
    tops=(), all_components=False, with_states=False, with_managers=False, with_snapshots=False
):
    """The System below the Paths `tops` (none: all name servers), sorted; only what is connected, or a
    composite of it.

    `with_managers`: which manager lists a component goes into the profile; `with_snapshots`: ask each
    component for everything, see `ask`.
    """
    nodes, managers, failures, notes = await search.components(tops)
    if with_managers:
        holders = await _holders(managers, notes)
    else:
        holders = {}
    found = []
    silent = {}
    lost = {}
    question = functools.partial(ask, brief=not with_snapshots, states=with_states, everything=with_snapshots)
    for node, answer in zip(nodes, await session.each(nodes, question)):
        if not isinstance(answer, errors.Error):
            found.append(answer)
        elif await _is_zombie(node, answer):
            notes.append(f"{node.path!s}: zombie, left out")
        else:
            failures.append(answer)
            silent[node.endpoint] = answer
            lost[str(node.path)] = node.endpoint
    outside = await places.far_ends([port for each in found for port in each.ports], silent)
    connectors, loose = _connectors(found, outside, silent, notes)
    unused = []
    if not all_components:
        found, unused = _in_use(found)
    profile = _profile(found, connectors, holders, notes)
    return System(profile, found, unused, failures, _once(notes), lost, loose)


def of_snapshots(shown, ends):
    """The System of components that have been asked for everything, by their snapshot.Snapshots.

    `ends`: {identity of a port: places.End} of all that their ports are connected with.
    """
    notes = []
    found = [found_in(each)._replace(snapshot=each) for each in shown]
    connectors, loose = _connectors(found, ends, {}, notes)
    profile = _profile(found, connectors, {}, notes)
    return System(profile, found, [], [], _once(notes), {}, loose)


def _once(notes):
    """A hostile composite names one member a thousand times."""
    return list(dict.fromkeys(notes))


def _profile(found, connectors, holders, notes):
    """The model.RtsProfile of Founds, which are sorted for it, and the connectors between them."""
    found.sort(key=lambda each: path_uri(each.node))
    profile = model.RtsProfile(components=[_component(each, found, notes) for each in found])
    for each, made in zip(found, profile.components):
        holder = holders.get(orb.identity(each.node.ref))
        if holder:
            made.properties += [model.Property(name=MANAGER, value=holder)]
        if each.node.endpoint[1]:
            made.properties += [model.Property(name=REFERENCE, value=orb.as_corbaloc(each.node.ref))]
    for connector in connectors:
        if len(connector.ends) == 1:
            profile.one_port_connectors.append(connector)
        elif isinstance(connector, model.DataPortConnector):
            profile.data_port_connectors.append(connector)
        else:
            profile.service_port_connectors.append(connector)
    return profile


async def _holders(managers, notes):
    """{identity of a component: path of the manager that lists it, as an RtsProfile has it};
    one that is dead lists none.
    """
    holders = {}
    for node, answer in zip(
        managers, await session.each(managers, lambda node: node.call("get_components"))
    ):
        if isinstance(answer, (errors.Gone, errors.ConnectionRefused)):
            continue
        if isinstance(answer, errors.Error):
            notes.append(f"{answer}; which components it has made is not saved")
            continue
        for ref in answer:
            if ref is not None:
                holders.setdefault(orb.identity(ref), path_uri(node))
    return holders


async def _is_zombie(node, failure):
    """Look whether a component that failed with `failure` is gone itself, and not something behind it."""
    if not isinstance(failure, (errors.Gone, errors.ConnectionRefused)):
        return False
    (now,) = await tree.check_alive([node])
    return now.kind == "zombie"


def _in_use(found):
    """Those of the ComponentState that have a connection, that are composites of such, or their members;
    and the others.
    """
    used = set()
    for each in found:
        if any(port.connectors for port in each.ports):
            used.add(id(each))
    for each in found:
        members = [_member(ref, found) for _, ref in each.members]
        family = [each] + [member for member in members if member is not None]
        if len(family) > 1 and any(id(one) in used for one in family):
            used |= {id(one) for one in family}
    return [each for each in found if id(each) in used], [each for each in found if id(each) not in used]


def _member(ref, found):
    for each in found:
        if orb.same(each.node.ref, ref):
            return each
    return None


# ---- one component ----


def _component(each, found, notes):
    instance = each.profile.instance_name
    made = model.Component(
        id=component_id(each.profile), path_uri=path_uri(each.node), active_configuration_set=each.active,
        instance_name=instance, is_required=True, location=model.Location(),
    )
    for kind in ("DataInPort", "DataOutPort"):
        names = sorted(ports.short_name(port.name, instance) for port in each.ports if port.type == kind)
        made.data_ports += [model.DataPort(name=name) for name in names]
    names = sorted(ports.short_name(port.name, instance) for port in each.ports if port.type == "CorbaPort")
    made.service_ports = [model.ServicePort(name=name) for name in names]
    made.configuration_sets = [
        model.ConfigurationSet(
            id=one.id,
            configuration_data=[
                model.ConfigurationData(name=name, data=value) for name, value in one.values.items()
            ],
        )
        for one in each.sets
    ]
    made.execution_contexts = [_context(each, one, found, notes) for one in each.owned]
    if each.members:
        kind = each.profile.category.rpartition("composite.")[2]
        made.composite_type = model.COMPOSITE_TYPES.get(kind.lower(), "PeriodicECShared")
    for name, ref in each.members:
        member = _member(ref, found)
        if member is not None:
            made.participants.append(model.Participant(component=_target(model.TargetComponent, member)))
            continue
        name = "that does not answer" if isinstance(name, errors.Error) else printable(name)
        notes.append(f"{each.node.path}: its member {name} is not in the system, left out")
    made.participants.sort(key=lambda one: one.component.instance_name)
    return made


def _context(each, context, found, notes):
    """The model.ExecutionContext of a component.Context, with those of other components that take part in it.

    RTSystemEditor writes the same. The members of a composite are listed by the composite itself.
    """
    made = model.ExecutionContext(id=str(context.handle), kind=context.kind.upper(), rate=context.rate)
    if each.members:
        return made
    for ref in context.participants:
        other = _member(ref, found)
        if other is None:
            notes.append(
                f"{each.node.path}: a component that takes part in its execution context {context.handle} "
                "is not in the system, left out"
            )
        elif other is not each:
            made.participants.append(_target(model.TargetComponent, other))
    made.participants.sort(key=lambda one: one.instance_name)
    return made


def _target(kind, each, **more):
    """A reference to a component inside a profile."""
    return kind(
        component_id=component_id(each.profile), instance_name=each.profile.instance_name,
        properties=[model.Property(name=PATH_ID, value=path_uri(each.node))], **more,
    )


# ---- connections ----


def _connectors(found, outside, silent, notes):
    """(the model's connectors, each once, with all its ends; Looses); what ends outside the system is
    reported in `notes`.

    `outside` are places.Ends by identity;
    `silent` are the processes that did not answer, {endpoint: errors.Error}.
    """
    ends = {}  # identity of a port: its ComponentState and Port
    for each in found:
        for port in each.ports:
            key = orb.identity(port.ref)
            if key not in ends or _owns(each, port):  # a composite shows ports of its members as its own
                ends[key] = (each, port)
    connectors = collections.OrderedDict()
    for each in found:
        for port in each.ports:
            for one in port.connectors:
                refs = [ref for ref in one.ports if ref is not None]
                connectors.setdefault(
                    (one.id, frozenset(orb.identity(ref) for ref in refs)), (port, one, refs)
                )
    made = []
    loose = []
    for port, one, refs in connectors.values():
        known = []
        for ref in refs:
            if orb.identity(ref) in ends:
                known.append(ends[orb.identity(ref)])
        unknown = [ref for ref in refs if orb.identity(ref) not in ends]
        for ref in unknown:
            name = _name(outside[orb.identity(ref)], ref, silent)
            where = f"connection {printable(one.id)} of {ports.label(port)}"
            notes.append(f"{where}: its end {name} is not in the system, left out")
        if len(known) > 1 or len(refs) == 1:
            made.append(_connector(one, known))
        elif unknown and outside[orb.identity(unknown[0])].port is None:
            loose.append(Loose(_connector(one, known), orb.endpoint(unknown[0]), notes[-1]))
    return sorted(made, key=_connector_key), sorted(loose, key=lambda each: _connector_key(each.connector))


def _connector_key(one):
    return [_end_key(end) for end in one.ends], one.connector_id, one.name


def _owns(each, port):
    return (
        port.owner is not None
        and orb.same(port.owner, each.node.ref)
        or port.name.startswith(each.profile.instance_name + ".")
    )


def _end_key(end):
    return (end.property(PATH_ID), end.port_name)


def _name(end, ref, silent):
    if orb.endpoint(ref) in silent:
        return "in the process at %s:%d, which does not answer," % orb.endpoint(ref)
    return places.name(end)


def _connector(one, known):
    """The model's connector of a ports.Connector with (ComponentState, Port) as ends,
    an out port and an in port first.
    """
    data = any(port.type in ports.DATA for _, port in known)
    if data:
        first = [
            next((end for end in known if end[1].type == kind), None)
            for kind in ("DataOutPort", "DataInPort")
        ]
        first = [end for end in first if end is not None]
        known = first + [end for end in known if end not in first]
    ends = [
        _target(
            model.TargetPort,
            each,
            port_name="%s.%s"
            % (each.profile.instance_name, ports.short_name(port.name, each.profile.instance_name)),
        )
        for each, port in known
    ]
    properties = []
    for name, value in sorted(one.properties):
        if not is_reference(name, value):
            properties.append((name, value))
    if data:
        given = dict(properties)
        made = model.DataPortConnector(**{key: given.get("dataport." + key, "") for key in DATA_FIELDS})
    else:
        made = model.ServicePortConnector()
    made.connector_id = one.id
    made.name = one.name
    made.ends = ends
    if len(known) == 1 and known[0][1].type == "DataInPort":
        made.source, made.target = None, made.source
    made.properties = [model.Property(name=name, value=value) for name, value in properties]
    return made


# ---- files ----


def path_of(each):
    """The Path of a component of a profile. Raises BadPath."""
    return path.parse("/" + each.path_uri.lstrip("/"))


def shown_path(each):
    """Where the file says that a component is bound, as commands take it, or, where that is no path,
    spelt for the terminal.
    """
    try:
        return str(path_of(each))
    except errors.BadPath:
        return "/" + printable(each.path_uri.lstrip("/"))


def read(name, form=None):
    """The profile in a file (`-`: stdin), which may be a report of rtdoctor. Raises OSError, BadProfile."""
    from rtshell_lite import files, notes
    from rtshell_lite.system import page_file

    notes.reading(name, "an RtsProfile")
    text = files.read(name)
    if page_file.is_page(text):
        return rtsprofile.load(page_file.profile(text, printable(name)), name, rtsprofile.YAML)
    return rtsprofile.load(text, name, form)


def locator(profile, strict=False):
    """A function: the Component of a profile that an end, a participant or a target of an action names, or
    None.

    `strict`: by id, instance name and path together; else files may disagree with themselves where it is
    clear what is meant.
    """
    by_path = {each.path_uri.lstrip("/"): each for each in profile.components}
    by_both = {}
    by_instance = {}
    for each in profile.components:
        by_both.setdefault((each.id, each.instance_name), each)
        by_instance.setdefault(each.instance_name, []).append(each)

    def locate(target):
        named = by_path.get((target.property(PATH_ID) or "").lstrip("/"))
        if strict:
            wanted = (target.component_id, target.instance_name)
            if named is not None and (named.id, named.instance_name) == wanted:
                return named
            return None
        both = by_both.get((target.component_id, target.instance_name))
        if named is not None and (both is None or named.instance_name == target.instance_name):
            return named
        alike = by_instance.get(target.instance_name, [])
        if both is None and len(alike) == 1:
            return alike[0]
        return both

    return locate


def port_of(end):
    """The name of the port that an end means, without the instance name before it."""
    return ports.short_name(end.port_name, end.instance_name)


def port_path(end, component):
    """The Path of the port that an end means, which is one of a component of the profile; None without a
    component, or where its path is not valid.
    """
    if component is None:
        return None
    try:
        return path_of(component).with_port(port_of(end))
    except errors.BadPath:
        return None


# ---- what is running of a profile ----


async def ask_each(profile, function=ask):
    """function(node) for each component of a profile;
    an errors.Error in the place of one that is not there or fails.
    """
    paths = []
    for each in profile.components:
        try:
            paths.append(path_of(each))
        except errors.BadPath as e:
            paths.append(errors.Failed("/" + printable(each.path_uri), e))
    valid = [one for one in paths if not isinstance(one, errors.Error)]
    coming = iter(await tree.on_components(valid, function))
    answers = []
    for one in paths:
        if isinstance(one, errors.Error):
            answers.append(one)
        else:
            answers.append(next(coming))
    return answers


async def states(profile):
    """The state of each component of a profile, as `look` gives it."""
    return await ask_each(profile, component.state)


def state(found):
    """One state of a ComponentState over all its contexts."""
    return component.merged(found.states.values())
