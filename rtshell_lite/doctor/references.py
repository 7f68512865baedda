"""Each name in a name server and its reference:
where it leads, whether it can be reached, whether its object lives.
"""

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.doctor import addresses, limits, local, networks, remedies
from rtshell_lite.doctor.finding import fail, ok, published, reason, warn
from rtshell_lite.robot import tree
from rtshell_lite.text import printable, shell_word


async def findings(visit):
    """Findings on all that is bound in the name server of a servers.Visit, sorted by path."""
    all_findings = []
    for node in visit.nodes:
        if node.kind not in ("root", "server", "directory"):
            all_findings += await _unreachable(visit, node) or await _not_what_it_says(node)
        elif node.alias is not None or node.foreign:
            all_findings.append(alias(node))
    return sorted(all_findings + await _stale_contexts(visit), key=lambda finding: finding.path)


# ---- where it leads ----


async def _unreachable(visit, node):
    """Why an object cannot be used from here, step by step: its address, TCP, its process, itself."""
    where = str(node.path)
    if isinstance(node.error, errors.Garbled):
        return [
            fail(
                "reference", where, f"the name is bound to what must not be used: {reason(node.error)}",
                remedies.words("bad reference"),
            )
        ]
    if node.ref is None:
        return [
            fail(
                "reference", where, "the name is bound to nothing (a nil reference)",
                remedies.command("delete name", path=where),
            )
        ]
    if isinstance(node.error, errors.Unspoken):
        return [warn("reference", where, reason(node.error), remedies.words("unspoken"))]
    offered = orb.addresses(node.ref)
    if not offered:
        return []  # of another transport
    shown = await published(node.ref)
    misled = await networks.misled("reference", where, node.ref, visit.addresses, visit.outside)
    if misled and misled.level == "fail":
        return [misled]
    also = [misled] if misled else []
    if node.kind == "zombie" or isinstance(node.error, errors.MaybeGone) and await _is_own(offered):
        return [await _dead(visit, node, shown)] + also
    if node.kind == "unasked" and not isinstance(node.error, errors.NoTime):
        cure = remedies.words("others first", path=shell_word(where))
        return [warn("reference", where, reason(node.error), cure, node.endpoint)] + also
    if node.kind in tree.DOUBTFUL:
        return [await _silent(visit, node, offered, shown)] + also
    if node.kind == "unknown" and _out_of_reach(visit, offered):
        return [await _silent(visit, node, offered, shown)] + also
    return also or _half_reachable(visit, where, offered)


async def _is_own(offered):
    """Whether an object publishes an address of this host, which refuses, though it may not be this one."""
    for host, _ in offered:
        if await addresses.is_this_host(host):
            return True
    return False


async def _dead(visit, node, shown):
    where = str(node.path)
    names = await networks.names_here(node.ref, visit.addresses)
    if names:
        message = (
            f"cannot tell from here whether it lives: {shown} may mean another host where it runs, and "
            "this one refuses"
        )
        return fail(
            "reference", where, message, remedies.words("name of this host", host=printable(names[0]))
        )
    if not await networks.is_certain(node.ref, visit.addresses):
        message = (
            f"cannot tell from here whether it lives: {shown} is of another network than its name server, "
            "and the host that has that address here refuses"
        )
        return fail("reference", where, message, remedies.network(node.endpoint))
    if isinstance(node.error, errors.Gone):
        message = f"dead (zombie): what listens at {shown} now does not have it"
    else:
        message = f"dead (zombie): nothing listens at {shown}"
    return fail("reference", where, message, remedies.command("delete zombie", path=where))


async def _silent(visit, node, offered, shown):
    """An object that does not answer: because of its host, the network, its process, or itself."""
    where = str(node.path)
    e = node.error
    rule = local.transport_rule()
    if isinstance(e, errors.NoTime):
        return limits.late("reference", where)
    if _out_of_reach(visit, offered):
        return await _unreached(visit, node, offered[0], shown)
    if rule and reason(e) == errors.NO_USABLE_ADDRESS:
        message = f"at {shown}: TCP connects, omniORB does not: {rule.text} forbids it"
        return fail("reference", where, message, rule.remedy)
    port = offered[0][1]
    is_other = reason(e).startswith("garbled")
    if not is_other and isinstance(e, (errors.Silent, errors.ConnectionLost)):
        is_other = await addresses.speaks_otherwise(offered[0])
    if is_other:
        message = f"what listens at {shown} does not speak CORBA ({reason(e)})"
        return fail("reference", where, message, remedies.words("who listens instead", port=port))
    if await remedies.is_of_network(e, offered[0]):
        what = reason(e)
        if isinstance(e, errors.Silent):
            what = "TCP connects, but what is sent is not received"
        message = f"cannot tell from here whether it lives: at {shown}, {what}"
        return fail("reference", where, message, remedies.network(offered[0]))
    if isinstance(e, errors.Refused):
        message = f"at {shown}, answers the question whether it is there with {reason(e)}"
        return fail("reference", where, message, remedies.words("exception", port=port))
    message = f"hung: {shown} accepts TCP, but {reason(e)}"
    return fail("reference", where, message, remedies.words("restart", port=port), node.endpoint)


async def _unreached(visit, node, endpoint, shown):
    """None of its addresses accepts connections."""
    where = str(node.path)
    failure = visit.probes[endpoint]
    if isinstance(failure, errors.ConnectionRefused):
        if await networks.is_certain(node.ref, visit.addresses):
            message = f"{shown} refuses: dead, or a firewall closes this port"
            return fail("reference", where, message, remedies.words("firewall", port=endpoint[1]))
    message = f"cannot tell from here whether it lives: publishes {shown}, "
    if failure.why == errors.NO_USABLE_ADDRESS or not await networks.homes_of(node.ref):
        message += "a host name that is not known here"
        cure = remedies.words("name in reference", host=printable(endpoint[0]))
        return fail("reference", where, message, cure)
    if await networks.is_apart(node.ref, visit.addresses):
        message += "of another network than its name server, "
    message += f"out of reach ({reason(failure)})"
    return fail("reference", where, message, remedies.network(endpoint))


def _out_of_reach(visit, offered):
    return all(isinstance(visit.probes.get(endpoint), errors.Error) for endpoint in offered)


def _half_reachable(visit, where, offered):
    """Some of several addresses may be out of reach;
    each caller tries them in turn and waits for the bad ones.
    """
    probes = [(host, port, visit.probes.get((host, port))) for host, port in offered]
    return [
        warn(
            "reference", where, f"also publishes {printable(host)}:{port}, out of reach ({reason(probe)})",
            remedies.words("only good addresses"),
        )
        for host, port, probe in probes
        if isinstance(probe, errors.Error)
    ]


# ---- what it is ----


async def _not_what_it_says(node):
    """A name of kind rtc or mgr for an object of another kind: somebody else's;
    and objects of unknown kinds.
    """
    if not node.path.names:
        return []
    kind = node.path.names[-1].kind
    expected = {"rtc": "component", "mgr": "manager"}
    what = printable(orb.address(node.ref).type_id) or node.what
    if kind not in expected and node.kind == "unknown":
        shown = await published(node.ref)
        return [ok("reference", str(node.path), f"another CORBA object, {what}, at {shown}")]
    if kind not in expected or node.kind in ("zombie", *tree.DOUBTFUL):
        return []
    if node.kind == expected[kind]:
        return []
    message = f"somebody else's: not a {expected[kind]} but {what}"
    return [
        fail(
            "reference", str(node.path), message,
            remedies.words("name of another", path=shell_word(str(node.path))),
        )
    ]


# ---- contexts ----


def alias(node):
    """The Finding on a naming context that has another name, or belongs to another name server:
    nothing in it is deleted.
    """
    if node.alias is not None:
        return ok("context", str(node.path), "an alias: the same directory as " + str(node.alias))
    address = "%s:%d" % node.endpoint
    return ok(
        "context",
        str(node.path),
        f"an alias: a directory of the name server at {printable(address)}, which is examined by: "
        f"rtdoctor {shell_word(address)}",
    )


async def _stale_contexts(visit):
    """Naming contexts that hold nothing, or only dead names; of those inside each other the outermost.

    One that has several names, or holds one with another name, is in use.
    """
    findings = []
    stale = set()
    content = _content(visit.nodes)
    forsaken = {
        node for node in visit.nodes if node.kind == "directory" and await _is_forsaken(node, visit.shared)
    }
    for node in visit.nodes:
        names = node.path.names
        is_inside = any(names[:i] in stale for i in range(len(names)))
        if is_inside or node not in forsaken:
            continue
        below = content.get(names, [])
        if all(inner.kind == "zombie" or inner in forsaken for inner in below):
            stale.add(names)
            what = "only dead names are in it" if any(inner.kind == "zombie" for inner in below) else "empty"
            findings.append(warn("context", str(node.path), "stale: " + what, _emptied(node, below)))
    return findings


def _emptied(node, below):
    """The Remedy for a stale naming context:
    each name by itself, the deepest first, so that nothing else is deleted.
    """
    if any(inner.kind == "zombie" for inner in below):
        return remedies.words("stale names", path=shell_word(str(node.path)))
    return remedies.command(
        "delete name",
        path=[str(inner.path) for inner in sorted(below + [node], key=lambda inner: -len(inner.path.names))],
    )


async def _is_forsaken(node, shared):
    """True for a naming context that could be listed and has one name only;
    `shared` is an aliases.Known of those with more.
    """
    if node.error is not None or node.foreign:
        return False
    return await shared.path(node) is None


def _content(nodes):
    """All Nodes below each naming context, by the names of its path."""
    content = {}
    for node in nodes:
        for size in range(1, len(node.path.names)):
            content.setdefault(node.path.names[:size], []).append(node)
    return content
