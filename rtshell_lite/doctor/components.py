"""Each component that lives: its ports, execution contexts and states, and whether it knows the name it is bound by."""
import collections

from rtshell_lite import errors
from rtshell_lite.corba import lanes, orb
from rtshell_lite.doctor import remedies, started, waiting
from rtshell_lite.doctor.finding import counted, fail, ok, published, reason, warn
from rtshell_lite.robot import component, ports, snapshot
from rtshell_lite.robot.snapshot import FULL
from rtshell_lite.text import printable, shell_word

MOST = 3  # names of one component that are reported one by one


def examined(nodes):
    """The Snapshot of each component among the Nodes, each object once, however often it is bound, sorted by path.

    Where a component fell silent or refused, the rest is missing.
    """
    by_object = collections.OrderedDict()
    for node in sorted(nodes, key=lambda node: str(node.path)):
        if node.kind == "component":
            by_object.setdefault(orb.identity(node.ref), []).append(node)
    components = [snapshot.Snapshot(first, others) for first, *others in by_object.values()]
    snapshot.ask_all(components, ports=snapshot.EACH, owned=FULL, participating=FULL, states=FULL, profile=FULL)
    for each in components:
        each.ports = ports.in_system(each.ports)
    return components


# ---- findings -------------------------------------------------------------------------------------------------

def findings(all_of_them, rates, hung, stated=False):
    """Findings on all components, sorted by path.

    rates  what was measured, see rates.measured
    hung   Nodes that do not answer at all: who is connected to one waits for it, and seems to hang, too
    stated  whether a profile says in which states they are to be
    """
    found = []
    for each in all_of_them:
        troubles = _troubles(each, hung) + rates.get(each.where, [])
        found += troubles
        if not any(finding.level == "fail" for finding in troubles) and each.error is None:
            found.append(ok("component", each.where, _summary(each)))
    found.sort(key=lambda finding: finding.path)
    if not stated and not any(finding.level == "fail" for finding in found):  # a robot does not work, either, when nobody has started it
        found += started.findings(all_of_them)
    return found


def _troubles(each, hung):
    found = _names(each) + _ports(each)
    if each.error is not None:
        return found + [_stopped_answering(each, hung)]
    return found + _contexts(each)


def _summary(each):
    """Active, claims 1000 Hz, 2 ports, 1 connection, at 127.0.0.1:4000."""
    state = component.merged(each.states)
    rate = next((f"claims {context.rate:g} Hz" for context in each.contexts if _is_periodic(context)), "not periodic")
    number = len({connector.id for port in each.ports for connector in port.connectors})
    return ", ".join([state, rate, counted(len(each.ports), "port"), counted(number, "connection"),
                      "at " + published(each.node.ref)])


def _stopped_answering(each, hung):
    e = each.error
    if e.why == lanes.NO_TIME:
        return fail("component", each.where, "slow: " + lanes.NO_TIME, remedies.words("more time", path=shell_word(each.where)))
    if isinstance(e, errors.Silent) and not each.asking:
        message = "not looked at: others of its process hang"
        return warn("component", each.where, message, remedies.words("others first", path=shell_word(each.where)))
    if isinstance(e, errors.Refused) and e.name in ("BAD_OPERATION", "NO_IMPLEMENT"):
        message = "somebody else's: it is registered as a component, and is none"
        return fail("reference", each.where, message, remedies.words("name of another", path=shell_word(each.where)))
    if isinstance(e, errors.Silent):
        message = "hangs when asked for " + each.asking
        paths, known = waiting.culprits(each, hung) if "port" in each.asking else ([], False)
        if paths:  # a port asks the far ends of its connections before it answers
            return fail("component", each.where, "%s, %swaiting for a far end that does not answer" % (
                message, "" if known else "maybe "), remedies.words("hung first", paths=" and ".join(paths)))
        return fail("component", each.where, message, remedies.of_silence(e, each.node.endpoint, each.where))
    return fail("component", each.where, f"does not say {each.asking} ({reason(e)})",
                remedies.of_silence(e, each.node.endpoint, each.where))


def _restart(each):
    return remedies.words("restart", port=each.node.endpoint[1])


# ---- names ----------------------------------------------------------------------------------------------------

def _names(each):
    """Names that a component has been given by others; its own are in its property naming.names, if it says so."""
    if each.profile is None:
        return []
    own = dict(each.profile.properties).get("naming.names", "") or _bound_as(each.node)
    nodes = [each.node, *each.others]
    known = [node for node in nodes if _bound_as(node) in own.split(",")]
    strange = [node for node in nodes if node not in known]
    if known:
        message, cure = "the same component as " + str(known[0].path), "name of another"
    else:
        message = "somebody else's name: this component calls itself " + printable(own)
        cure = "name taken"
    found = [_on_name(node, message, cure) for node in strange[:MOST]]
    if strange[MOST:]:
        found.append(_on_name(strange[MOST], f"and {counted(len(strange) - MOST, 'name')} like it", cure))
    return found


def _on_name(node, message, cure):
    return warn("reference", str(node.path), message, remedies.words(cure, path=shell_word(str(node.path))))


def _bound_as(node):
    """Its path below the name server as OpenRTM writes it: no escapes."""
    return "/".join(name.id + "." + name.kind if name.kind else name.id for name in node.path.names)


# ---- ports ----------------------------------------------------------------------------------------------------

def _ports(each):
    found = [_refusing(each, *port) for port in each.refusing]
    message = "had a connection whose far end is dead, and dropped it when asked"
    return found + [warn("connection", ports.label(port), message, remedies.words("restart far end"))
                    for port in each.dropped]


def _refusing(each, number, e, endpoint):
    if isinstance(e, errors.Refused):
        return fail("port", each.where, "its port %d refuses its profile (%s)" % (number, reason(e)), _restart(each))
    if not isinstance(e, errors.LostMember):
        message = "cannot tell from here about its port %d, at %s:%d (%s)" % (number, printable(endpoint[0]), endpoint[1], reason(e))
        return fail("port", each.where, message, remedies.network(endpoint))
    return fail("port", each.where, "its port %d is out of reach: a member of this composite is dead, perhaps" % number,
                remedies.words("restart composite", port=each.node.endpoint[1]))


# ---- execution contexts ---------------------------------------------------------------------------------------

def _contexts(each):
    """Errors, and what keeps a component from being executed."""
    if not each.contexts:
        return [fail("context", each.where, "has no execution context: nothing executes it", _restart(each))]
    found = []
    for index, (context, state) in enumerate(zip(each.contexts, each.states)):
        if context.handle is None:
            message = "its execution context %d belongs to another component, which does not answer" % index
            found.append(warn("context", each.where, message, remedies.words("look at contexts", path=shell_word(each.where))))
        elif state == "Error":
            found.append(fail("component", each.where, "in Error",
                              remedies.command("reset", option=remedies.option(index), path=each.where)))
    alive = [context for context in each.contexts if context.handle is not None]
    if alive and not any(context.running for context in alive):
        message = "its execution context is stopped: nothing executes it"
        found.append(fail("context", each.where, message, remedies.command("start context", path=each.where)))
    for index, context in enumerate(each.contexts):
        if _is_periodic(context) and not context.rate > 0:
            found.append(fail("context", each.where, f"its execution context has a rate of {context.rate:g} Hz",
                              remedies.command("set rate", option=remedies.option(index), path=each.where, rate=100)))
    return found


def _is_periodic(context):
    """True for a context that answers, runs, and executes its components at a rate."""
    return context.running and context.kind == "Periodic"
