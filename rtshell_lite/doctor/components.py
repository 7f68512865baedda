"""Each live component: its ports, execution contexts and states,
and whether it knows the name that it is bound by.
"""

import collections

from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.doctor import limits, remedies, started, waiting
from rtshell_lite.doctor.finding import fail, ok, published, reason, warn
from rtshell_lite.robot import component, manager, ports, tree
from rtshell_lite.robot.snapshot import EACH, FULL, Snapshot, ask_all
from rtshell_lite.text import counted, printable, shell_word

PATIENT = 3.0  # seconds: what answers later hangs; with a shorter timeout it may be slow
MOST = 3  # names of one component that are reported one by one


async def logs(snapshots, nodes):
    """{path: log file, as its manager has it in logger.file_name} of the components in Error.

    Their managers are among the Nodes, or are slaves of those.
    """
    broken = [snapshot for snapshot in snapshots if "Error" in snapshot.states]
    bound = [node for node in nodes if node.kind == "manager"]
    if not broken or not bound:
        return {}
    slaves = [
        slave
        for answer in await session.each(bound, tree.slaves)
        if not isinstance(answer, errors.Error)
        for slave in answer
    ]
    ends = {snapshot.node.endpoint for snapshot in broken}
    asked = [node for node in bound + slaves if node.kind == "manager" and node.endpoint in ends]
    files = {}
    for node, settings in zip(asked, await session.each(asked, manager.configuration)):
        settings = {} if isinstance(settings, errors.Error) else dict(settings)
        if settings.get("logger.enable", "YES").upper() == "YES" and settings.get("logger.file_name"):
            files[node.endpoint] = printable(settings["logger.file_name"])
    return {
        snapshot.where: files[snapshot.node.endpoint]
        for snapshot in broken
        if snapshot.node.endpoint in files
    }


async def examined(nodes):
    """The Snapshot of each component among the Nodes, each object once, however often it is bound, sorted by
    path.

    If a component fell silent or refused, the rest is missing.
    """
    by_object = collections.OrderedDict()
    for node in sorted(nodes, key=lambda node: str(node.path)):
        if node.kind == "component":
            by_object.setdefault(orb.identity(node.ref), []).append(node)
    snapshots = [Snapshot(first, others) for first, *others in by_object.values()]
    await ask_all(snapshots, ports=EACH, owned=FULL, participating=FULL, states=FULL, profile=FULL)
    for snapshot in snapshots:
        snapshot.of_tools = [
            (port, connector)
            for port in snapshot.ports
            for connector in port.connectors
            if ports.is_of_tool(connector)
        ]
        snapshot.ports = ports.in_system(snapshot.ports)
    return snapshots


async def complete(snapshots):
    """Ask the components that have answered for what else rtcat shows; what fails is missing."""
    answering = [snapshot for snapshot in snapshots if snapshot.error is None]
    await ask_all(
        answering, configuration=FULL, organisations=FULL, composites=FULL, members=FULL, names=FULL
    )
    for snapshot in answering:
        snapshot.error = None


# ---- findings ----


async def findings(snapshots, rates, culprits, stated=False, logs=None):
    """Findings on all components, sorted by path.

    rates     what was measured, see rates.measured
    culprits  see waiting.culprits
    logs      see `logs`
    stated    whether a profile says which states they should have
    """
    all_findings = []
    reporting = {snapshot.node.endpoint for snapshot in snapshots if "ports" in snapshot.known}
    for snapshot in snapshots:
        troubles = await _troubles(snapshot, (logs or {}).get(snapshot.where, ""))
        if snapshot.error is not None:
            troubles.append(await _stopped_answering(snapshot, culprits, reporting))
        troubles += rates.get(snapshot.where, [])
        all_findings += troubles
        has_failed = any(finding.level == "fail" for finding in troubles)
        if not has_failed and snapshot.error is None:
            all_findings.append(ok("component", snapshot.where, await _summary(snapshot)))
    all_findings.sort(key=lambda finding: finding.path)
    failed = {finding.path for finding in all_findings if finding.level == "fail"}
    if stated:
        return all_findings
    return all_findings + started.findings(snapshots, failed)


async def _troubles(snapshot, log):
    """Findings on what a component has reported."""
    troubles = _names(snapshot) + _ports(snapshot)
    if "states" in snapshot.known:
        troubles += _contexts(snapshot, log)
    return troubles


async def _summary(snapshot):
    """Active, claims 1000 Hz, 2 ports, 1 connection, at 127.0.0.1:4000."""
    rates = [f"claims {context.rate:g} Hz" for context in snapshot.contexts if _is_periodic(context)]
    rate = rates[0] if rates else "not periodic"
    number = len({connector.id for port in snapshot.ports for connector in port.connectors})
    ports_and_connections = f"{counted(len(snapshot.ports), 'port')}, {counted(number, 'connection')}"
    address = await published(snapshot.node.ref)
    return f"{component.merged(snapshot.states)}, {rate}, {ports_and_connections}, at {address}"


async def _stopped_answering(snapshot, culprits, reporting):
    """The Finding on a component that has not reported everything. `reporting`: endpoints of processes of
    which one has reported its ports.
    """
    e = snapshot.error
    where = snapshot.where
    word = shell_word(where)
    if isinstance(e, errors.NoTime):
        return limits.late("component", where)
    if isinstance(e, errors.NotAsked):
        cause = waiting.blamed(snapshot.node.endpoint, culprits)
        cure = remedies.not_asked(e, where)
        return warn("component", where, _not_asked(snapshot), cure, cause)
    if isinstance(e, errors.Refused) and e.name in ("BAD_OPERATION", "NO_IMPLEMENT"):
        message = "somebody else's: it is registered as a component, but is not one"
        return fail("reference", where, message, remedies.words("name of another", path=word))
    if isinstance(e, errors.Silent):
        return await _hangs(snapshot, culprits.get(snapshot.node.endpoint), reporting)
    cure = await remedies.of_silence(e, snapshot.node.endpoint, where)
    return fail("component", where, f"does not report {snapshot.asking} ({reason(e)})", cure)


def _not_asked(snapshot):
    if not snapshot.asking:
        return "not looked at: others of its process hang"
    return f"not asked for {snapshot.asking}: others of its process hang when asked"


async def _hangs(snapshot, culprits, reporting):
    """It is silent when asked for one of its parts."""
    e = snapshot.error
    where = snapshot.where
    endpoint = snapshot.node.endpoint
    message = "hangs when asked for " + snapshot.asking
    if culprits and culprits.paths and "port" in snapshot.asking:
        # a port asks the far ends of its connections before it answers
        maybe = "" if culprits.is_certain else "maybe "
        message += f", {maybe}waiting for a far end that does not answer"
        cure = remedies.words("hung first", paths=" and ".join(culprits.paths))
        return fail("component", where, message, cure, culprits.endpoint)
    if endpoint in reporting:  # large answers of its process arrive
        return fail("component", where, message, remedies.words("restart", port=endpoint[1]), endpoint)
    if await remedies.may_be_lost(e, endpoint):
        message = f"answers small questions, but not when asked for {snapshot.asking}: "
        message += "perhaps large packets are lost on the way"
    elif session.current().timeout < PATIENT:
        message = f"{reason(e)} when asked for {snapshot.asking}"
        patience = remedies.words("more time", path=shell_word(where))
        return fail("component", where, message, await remedies.of_silence(e, endpoint, where, patience))
    return fail("component", where, message, await remedies.of_silence(e, endpoint, where), endpoint)


def _restart(snapshot):
    return remedies.words("restart", port=snapshot.node.endpoint[1])


# ---- names ----


def _names(snapshot):
    """Names that others have bound a component by; its own are in its property naming.names, if it has that.
    Where only a manager lists it, it has none.
    """
    nodes = [node for node in (snapshot.node, *snapshot.others) if node.path.is_bound]
    if snapshot.profile is None or not nodes:
        return []
    own = dict(snapshot.profile.properties).get("naming.names", "") or _bound_as(nodes[0])
    near = [node for node in nodes if _bound_as(node) in own.split(",")]
    strange = [node for node in nodes if node not in near]
    if near:
        message = "the same component as " + str(near[0].path)
        cure = "name of another"
    else:
        message = "somebody else's name: this component calls itself " + printable(own)
        cure = "renamed" if len(nodes) == 1 else "name taken"
    findings = [_on_name(node, message, cure) for node in strange[:MOST]]
    if strange[MOST:]:
        more = f"and {counted(len(strange) - MOST, 'name')} like it"
        findings.append(_on_name(strange[MOST], more, cure))
    return findings


def _on_name(node, message, cure):
    where = str(node.path)
    return warn("reference", where, message, remedies.words(cure, path=shell_word(where)))


def _spelt(name):
    return name.id + "." + name.kind if name.kind else name.id


def _bound_as(node):
    """Its path below the name server as OpenRTM writes it: no escapes."""
    return "/".join(_spelt(name) for name in node.path.names)


# ---- ports ----


def _ports(snapshot):
    findings = [_refusing(snapshot, *port) for port in snapshot.refusing]
    message = "had a connection whose far end is dead, and dropped it when asked"
    return findings + [
        warn("connection", ports.label(port), message, remedies.words("restart far end"))
        for port in snapshot.dropped
    ]


def _refusing(snapshot, number, e, endpoint):
    if isinstance(e, errors.Refused):
        return fail(
            "port", snapshot.where, f"its port {number} refuses its profile ({reason(e)})", _restart(snapshot)
        )
    if not isinstance(e, errors.LostMember):
        address = f"{printable(endpoint[0])}:{endpoint[1]}"
        message = f"cannot tell from here about its port {number}, at {address} ({reason(e)})"
        return fail("port", snapshot.where, message, remedies.network(endpoint))
    return fail(
        "port", snapshot.where,
        f"its port {number} is out of reach: perhaps a member of this composite is dead",
        remedies.words("restart composite", port=snapshot.node.endpoint[1]),
    )


# ---- execution contexts ----


def _contexts(snapshot, log):
    """Errors, and what keeps a component from being executed."""
    where = snapshot.where
    if not snapshot.contexts:
        return [fail("context", where, "has no execution context: nothing executes it", _restart(snapshot))]
    findings = []
    for index, (context, state) in enumerate(zip(snapshot.contexts, snapshot.states)):
        if context.handle is None:
            message = f"its execution context {index} belongs to another component, which does not answer"
            cure = remedies.words("look at contexts", path=shell_word(where))
            findings.append(warn("context", where, message, cure))
        elif state == "Error":
            findings.append(_in_error(where, index, log))
    active = [str(index) for index, state in enumerate(snapshot.states) if state == "Active"]
    if len(active) > 1:
        listed = " and ".join(active)
        message = f"Active in its execution contexts {listed} at once: each that runs executes it"
        cure = remedies.words("active once", path=shell_word(where))
        findings.append(warn("context", where, message, cure))
    alive = [context for context in snapshot.contexts if context.handle is not None]
    if alive and not any(context.running for context in alive):
        message = "its execution context is stopped: nothing executes it"
        findings.append(fail("context", where, message, remedies.command("start context", path=where)))
    for index, context in enumerate(snapshot.contexts):
        if _is_periodic(context) and not context.rate > 0:
            message = f"its execution context has a rate of {context.rate:g} Hz"
            option = remedies.option(index)
            cure = remedies.command("set rate", option=option, path=where, rate=100)
            findings.append(fail("context", where, message, cure))
    return findings


def _in_error(where, index, log):
    message = "in Error"
    if log:
        message += f"; its process writes its log to {log}"
    cure = remedies.command("reset", option=remedies.option(index), path=where)
    return fail("component", where, message, cure)


def _is_periodic(context):
    """True for a context that answers, runs, and executes its components at a rate."""
    return context.running and context.kind == "Periodic"
