"""A system as a value: components, connections and configuration, asked of what is running,
in the shape of an RtsProfile.
"""

import collections
import functools
import re

from rtshell_lite import errors, path
from rtshell_lite.corba import orb, session
from rtshell_lite.notes import Work  # `notes` are lines here
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
    parts = {"ports": FULL, "owned": PROFILE, "configuration": FULL, "organisations": FULL, "profile": FULL}
    if brief:
        parts.update(ports=BRIEF, profile=NAMES)
    if states:
        parts.update(participating=BRIEF, states=FULL)
    if everything:
        parts.update(owned=FULL, participating=FULL, composites=FULL, members=FULL, names=FULL)
    shown = await snapshot.of(node, **parts)
    if states and not everything and len(shown.contexts) > 1:  # one context counts, whether it runs or not
        shown.owned = [await _with_running(shown, context) for context in shown.owned]
    answer = found_in(shown, brief)
    return answer._replace(snapshot=shown) if everything else answer


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
    configuration = shown.configuration
    sets = configuration.sets(with_hidden=True) if configuration else []
    active = configuration.active if configuration else ""
    return ComponentState(
        node=node,
        ports=ports.in_system(shown.ports),
        owned=contexts,
        states={context.handle: state for context, state in zip(shown.contexts, shown.states)},
        sets=sets,
        active=active,
        members=[member for organisation in shown.organisations for member in organisation.members],
        profile=shown.profile,
        snapshot=None,
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
    address = orb.at_address(ref)
    if isinstance(e, errors.ConnectionRefused):
        if isinstance(await orb.refusal(where, orb.endpoint(ref)), errors.ProcessGone):
            return ""
        return f"{address}, where it was, refuses: dead, or a firewall closes this port"
    if isinstance(e, errors.NotAsked):
        return f"{address}, where it was, could not be asked ({e.why})"
    if isinstance(e, errors.Silent):
        return f"{address}, where it was, does not answer ({e.why}): it hangs, or is out of reach"
    return f"{address}, where it was, is out of reach ({e.why})"


def is_reference(name, value):
    """True for a property of a connection that holds an object reference."""
    return bool(_REFERENCE.match(name) or (value or "").startswith("IOR:"))


# ---- capturing ----


async def capture(
    tops=(), all_components=False, with_states=False, with_managers=False, with_snapshots=False, shows=False
):
    """The System below the Paths `tops` (none: all name servers), sorted; only what is connected, or a
    composite of it.

    `with_managers`: which manager lists a component goes into the profile; `with_snapshots`: ask each
    component for everything, see `ask`; `shows`: how far it is, see notes.Work.
    """
    nodes, managers, failures, notes = await search.components(tops)
    if not with_managers:
        managers = []
    answers = []
    silent = {}
    lost = {}
    question = functools.partial(ask, brief=not with_snapshots, states=with_states, everything=with_snapshots)
    if shows:
        with Work("components", len(nodes)) as work:
            asked = await _ask_all(nodes, managers, work.counting(question))
    else:
        asked = await _ask_all(nodes, managers, question)
    holders = _holders(zip(managers, asked[len(nodes) :]), notes)
    for node, answer in zip(nodes, asked):
        if not isinstance(answer, errors.Error):
            answers.append(answer)
        elif await _is_zombie(node, answer):
            notes.append(f"{node.path!s}: zombie, left out")
        else:
            failures.append(answer)
            silent[node.endpoint] = answer
            lost[str(node.path)] = node.endpoint
    outside = await places.far_ends([port for answer in answers for port in answer.ports], silent)
    connectors, loose = _connectors(answers, outside, silent, notes)
    unused = []
    if not all_components:
        answers, unused = _in_use(answers)
    profile = _profile(answers, connectors, holders, notes)
    # each note once: a hostile composite names one member a thousand times
    return System(profile, answers, unused, failures, list(dict.fromkeys(notes)), lost, loose)


def of_snapshots(shown, ends):
    """The System of components that have been asked for everything, by their snapshot.Snapshots.

    `ends`: {identity of a port: places.End} of all that their ports are connected with.
    """
    notes = []
    answers = [found_in(snapshot)._replace(snapshot=snapshot) for snapshot in shown]
    connectors, loose = _connectors(answers, ends, {}, notes)
    profile = _profile(answers, connectors, {}, notes)
    return System(profile, answers, [], [], list(dict.fromkeys(notes)), {}, loose)


def _profile(answers, connectors, holders, notes):
    """The model.RtsProfile of Founds, which are sorted for it, and the connectors between them."""
    answers.sort(key=lambda answer: path_uri(answer.node))
    profile = model.RtsProfile(components=[_component(answer, answers, notes) for answer in answers])
    for answer, described in zip(answers, profile.components):
        holder = holders.get(orb.identity(answer.node.ref))
        if holder:
            described.properties += [model.Property(name=MANAGER, value=holder)]
        if answer.node.endpoint[1]:
            described.properties += [model.Property(name=REFERENCE, value=orb.as_corbaloc(answer.node.ref))]
    for connector in connectors:
        profile.add_connector(connector)
    return profile


async def _ask_all(nodes, managers, question):
    """The answers of component nodes to `question`, and what manager nodes list; at once, so that one that is
    late does not take its time after the others.
    """

    async def ask_one(node):
        if node.kind == "manager":
            return await node.call("get_components")
        return await question(node)

    return await session.each(nodes + managers, ask_one)


def _holders(answers, notes):
    """{identity of a component: path of the manager that lists it, as an RtsProfile has it}, from the
    (node, answer) of managers; one that is dead lists none.
    """
    holders = {}
    for node, answer in answers:
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


def _in_use(answers):
    """Those of the ComponentState that have a connection, that are composites of such, or their members;
    and the others.
    """
    used = {id(answer) for answer in answers if any(port.connectors for port in answer.ports)}
    for answer in answers:
        members = [_member(ref, answers) for _, ref in answer.members]
        family = [answer] + [member for member in members if member is not None]
        if len(family) > 1 and any(id(relative) in used for relative in family):
            used |= {id(relative) for relative in family}
    unused = [answer for answer in answers if id(answer) not in used]
    return [answer for answer in answers if id(answer) in used], unused


def _member(ref, answers):
    return next((answer for answer in answers if orb.same(answer.node.ref, ref)), None)


# ---- one component ----


def _component(answer, answers, notes):
    instance = answer.profile.instance_name
    described = model.Component(
        id=component_id(answer.profile),
        path_uri=path_uri(answer.node),
        active_configuration_set=answer.active,
        instance_name=instance,
        is_required=True,
        location=model.Location(),
    )
    names = collections.defaultdict(list)  # by type of port
    for port in answer.ports:
        names[port.type].append(ports.short_name(port.name, instance))
    in_and_out = sorted(names["DataInPort"]) + sorted(names["DataOutPort"])
    described.data_ports = [model.DataPort(name=name) for name in in_and_out]
    described.service_ports = [model.ServicePort(name=name) for name in sorted(names["CorbaPort"])]
    for one_set in answer.sets:
        data = [model.ConfigurationData(name=name, data=value) for name, value in one_set.values.items()]
        described.configuration_sets.append(model.ConfigurationSet(id=one_set.id, configuration_data=data))
    described.execution_contexts = [_context(answer, context, answers, notes) for context in answer.owned]
    if answer.members:
        kind = answer.profile.category.rpartition("composite.")[2]
        described.composite_type = model.COMPOSITE_TYPES.get(kind.lower(), "PeriodicECShared")
    for name, ref in answer.members:
        member = _member(ref, answers)
        if member is not None:
            described.participants.append(model.Participant(component=_target(model.TargetComponent, member)))
            continue
        name = "that does not answer" if isinstance(name, errors.Error) else printable(name)
        notes.append(f"{answer.node.path}: its member {name} is not in the system, left out")
    described.participants.sort(key=lambda participant: participant.component.instance_name)
    return described


def _context(answer, context, answers, notes):
    """The model.ExecutionContext of a component.Context, with those of other components that take part in it.

    RTSystemEditor writes the same. The members of a composite are listed by the composite itself.
    """
    described = model.ExecutionContext(id=str(context.handle), kind=context.kind.upper(), rate=context.rate)
    if answer.members:
        return described
    for ref in context.participants:
        other = _member(ref, answers)
        if other is None:
            who = f"a component that takes part in its execution context {context.handle}"
            notes.append(f"{answer.node.path}: {who} is not in the system, left out")
        elif other is not answer:
            described.participants.append(_target(model.TargetComponent, other))
    described.participants.sort(key=lambda participant: participant.instance_name)
    return described


def _target(kind, answer, **more):
    """A reference to a component inside a profile."""
    return kind(
        component_id=component_id(answer.profile), instance_name=answer.profile.instance_name,
        properties=[model.Property(name=PATH_ID, value=path_uri(answer.node))], **more,
    )


# ---- connections ----


def _connectors(answers, outside, silent, notes):
    """(the model's connectors, each once, with all its ends; Looses); what ends outside the system is
    reported in `notes`.

    `outside` are places.Ends by identity;
    `silent` are the processes that did not answer, {endpoint: errors.Error}.
    """
    ends = {}  # identity of a port: its ComponentState and Port
    for answer in answers:
        for port in answer.ports:
            key = orb.identity(port.ref)
            if key not in ends or _owns(answer, port):  # a composite shows ports of its members as its own
                ends[key] = (answer, port)
    connectors = collections.OrderedDict()
    for answer in answers:
        for port in answer.ports:
            for connector in port.connectors:
                refs = [ref for ref in connector.ports if ref is not None]
                key = connector.id, frozenset(map(orb.identity, refs))
                connectors.setdefault(key, (port, connector, refs))
    inner = []
    loose = []
    for port, connector, refs in connectors.values():
        where = f"connection {printable(connector.id)} of {ports.label(port)}"
        if None in connector.ports:
            if _is_shown_whole(connector, refs, connectors):
                continue
            notes.append(f"{where}: an end of it is nothing (nil), left out")
        inside = [ends[orb.identity(ref)] for ref in refs if orb.identity(ref) in ends]
        unknown = [ref for ref in refs if orb.identity(ref) not in ends]
        for ref in unknown:
            name = _name(outside[orb.identity(ref)], ref, silent)
            notes.append(f"{where}: its end {name} is not in the system, left out")
        if len(inside) > 1 or inside and len(connector.ports) == 1:
            inner.append(_connector(connector, inside))
        elif unknown and outside[orb.identity(unknown[0])].port is None:
            loose.append(Loose(_connector(connector, inside), orb.endpoint(unknown[0]), notes[-1]))
    loose.sort(key=lambda connection: _connector_key(connection.connector))
    return sorted(inner, key=_connector_key), loose


def _is_shown_whole(connector, refs, connectors):
    """Whether another port shows all ends of a connector, some of which are nil here."""
    ends = set(map(orb.identity, refs))
    return any(
        number == connector.id and ends < identities and None not in other.ports
        for (number, identities), (_, other, _) in connectors.items()
    )


def _connector_key(connector):
    ends = [(end.property(PATH_ID), end.port_name) for end in connector.ends]
    return ends, connector.connector_id, connector.name


def _owns(answer, port):
    is_of_it = port.owner is not None and orb.same(port.owner, answer.node.ref)
    return is_of_it or port.name.startswith(answer.profile.instance_name + ".")


def _name(end, ref, silent):
    if orb.endpoint(ref) in silent:
        return "in the process at %s:%d, which does not answer," % orb.endpoint(ref)
    return places.name(end)


def _connector(connector, pairs):
    """The model's connector of a ports.Connector with (ComponentState, Port) as ends,
    an out port and an in port first.
    """
    # where a port is connected alone, of whatever kind, the properties name the transport
    is_data = len(pairs) == 1 or any(port.type in ports.DATA for _, port in pairs)
    if is_data:
        first = [
            next((end for end in pairs if end[1].type == kind), None)
            for kind in ("DataOutPort", "DataInPort")
        ]
        first = [end for end in first if end is not None]
        pairs = first + [end for end in pairs if end not in first]
    ends = []
    for answer, port in pairs:
        instance = answer.profile.instance_name
        name = f"{instance}.{ports.short_name(port.name, instance)}"
        ends.append(_target(model.TargetPort, answer, port_name=name))
    properties = [
        (name, value) for name, value in sorted(connector.properties) if not is_reference(name, value)
    ]
    if is_data:
        given = dict(properties)
        described = model.DataPortConnector(**{key: given.get("dataport." + key, "") for key in DATA_FIELDS})
    else:
        described = model.ServicePortConnector()
    described.connector_id = connector.id
    described.name = connector.name
    described.ends = ends
    if len(pairs) == 1 and pairs[0][1].type == "DataInPort":
        described.source, described.target = None, described.source
    described.properties = [model.Property(name=name, value=value) for name, value in properties]
    return described


# ---- files ----


def path_of(described):
    """The Path of a component of a profile. Raises BadPath."""
    return path.parse("/" + described.path_uri.lstrip("/"))


def shown_path(described):
    """Where the file says that a component is bound, as commands take it, or, where that is no path,
    spelt for the terminal.
    """
    try:
        return str(path_of(described))
    except errors.BadPath:
        return "/" + printable(described.path_uri.lstrip("/"))


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
    by_path = {described.path_uri.lstrip("/"): described for described in profile.components}
    by_both = {}
    by_instance = {}
    for described in profile.components:
        by_both.setdefault((described.id, described.instance_name), described)
        by_instance.setdefault(described.instance_name, []).append(described)

    def locate(target):
        named = by_path.get((target.property(PATH_ID) or "").lstrip("/"))
        if strict:
            key = (target.component_id, target.instance_name)
            return named if named is not None and (named.id, named.instance_name) == key else None
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
    for described in profile.components:
        try:
            paths.append(path_of(described))
        except errors.BadPath as e:
            paths.append(errors.Failed("/" + printable(described.path_uri), e))
    valid = [where for where in paths if not isinstance(where, errors.Error)]
    with Work("components", len(valid)) as work:
        coming = iter(await tree.on_components(valid, work.counting(function)))
    return [where if isinstance(where, errors.Error) else next(coming) for where in paths]


async def states(profile):
    """The state of each component of a profile, as `look` gives it."""
    return await ask_each(profile, component.state)


def state(answer):
    """One state of a ComponentState over all its contexts."""
    return component.merged(answer.states.values())
