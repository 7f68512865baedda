"""Each name server, step by step: name, TCP, CORBA, naming context;
then the names in it and whether their objects live.
"""

import collections

from rtshell_lite import errors, path
from rtshell_lite.corba import orb, session
from rtshell_lite.doctor import addresses, limits, local, networks, references, remedies
from rtshell_lite.doctor.finding import fail, listed, ok, reason, warn
from rtshell_lite.net import loop
from rtshell_lite.robot import aliases, manager, tree, usual
from rtshell_lite.text import counted, printable, shell_word

SLOW = 1.0  # seconds: a step that takes longer makes every command slow

_NAMING_CONTEXT = "IDL:omg.org/CosNaming/NamingContext:1.0"

# What was found of one name server: `path` its Path, `addresses` where it is ([] if not known), `findings`,
# `nodes` what is bound in it (looked at), `probes` a dict: endpoint to None, or to the errors.Error why TCP
# does not reach it; `shared` an aliases.Known of the naming contexts that have several names in it, `outside`
# see `networks.outside`.
Visit = collections.namedtuple("Visit", "path addresses findings nodes probes shared outside")


async def visits(tops):
    """A Visit for each name server that the Paths `tops` lead to, all at once,
    with what is at and below them.
    """
    by_server = collections.OrderedDict()
    for top in sorted(tops, key=str):
        by_server.setdefault(top.server, []).append(top)
    paths = [path.Path(server, (), None, False) for server in by_server]
    used = await _ports(paths)
    answers = await session.each(
        paths, lambda server_path: _visit(server_path, by_server[server_path.server], used), tree.at_server
    )
    return [
        _too_late(server_path, visit) if isinstance(visit, errors.Error) else visit
        for server_path, visit in zip(paths, answers)
    ]


async def _ports(paths):
    """The TCP ports of the name servers at some Paths."""
    numbers = set()
    for server_path in paths:
        try:
            numbers.add((await tree.resolve(server_path)).endpoint[1])
        except errors.Error:  # which a visit reports
            continue
    return numbers - {None}


def _too_late(server_path, e, findings=()):
    """The Visit to a name server for which, or for whose names, there was not enough time."""
    where = str(server_path)
    late = fail("name server", where, reason(e), remedies.words("more time", path=shell_word(where)))
    return Visit(server_path, [], list(findings) + [late], [], {}, aliases.Known(), "")


async def _visit(server_path, tops, used):
    """The Visit to one name server; `used` are the ports of all."""
    visit = Visit(server_path, [], [], [], {}, aliases.Known(), "")
    server = await tree.resolve(server_path)
    if server.kind == "server" and not await _reach(visit, server, used):
        return visit
    for top in tops:
        paths = {node.path for node in visit.nodes}
        visit.nodes.extend([node for node in await _below(visit, top) if node.path not in paths])
    await _share(visit, tops)
    looked, probes = await session.each(
        [tree.check_alive, _probes], lambda ask: ask(visit.nodes),
        lambda ask: ((ask.__name__, server_path), str(server_path)),
    )
    for failure in (looked, probes):
        if isinstance(failure, errors.Error):
            return _too_late(server_path, failure, visit.findings)
    visit.nodes[:] = looked
    if not any(node.kind not in ("root", "server", "directory") for node in looked) and any(
        not top.names for top in tops
    ):
        visit.findings.extend(await _unbound(visit))
    visit.probes.update(probes)
    return visit._replace(
        outside=await networks.outside([node.ref for node in looked if node.kind in ("component", "manager")])
    )


# ---- the name server itself ----


async def _unbound(visit):
    """Findings on a name server that has nothing: it may have been started again, and components that live
    were not.
    """
    host = orb.endpoint((await tree.resolve(visit.path)).ref)[0]
    where = str(visit.path)
    if ":" in host:
        host = f"[{host}]"
    word = "corbaloc::%s:%d/manager" % (host, path.MANAGER_PORT)
    try:
        living = await manager.components(await manager.find(word))
    except errors.Error:
        living = []
    if not living and all(node.kind == "server" and node.error is None for node in visit.nodes):
        message = "nothing is bound in it: nothing was started, or it was restarted"
        return [warn("name server", where, message, remedies.words("nothing bound"))]
    if not living:
        return []
    message = (
        f"has no names, though a manager at port {path.MANAGER_PORT} of its host has "
        f"{counted(len(living), 'component')} ({listed(printable(name) for name, _ in living)}): "
        "perhaps it was started again, and they were not"
    )
    return [warn("name server", where, message, remedies.words("bind again"))]


async def _reach(visit, server, used):
    """Reach a name server step by step; False when a step fails. Adds its findings."""
    where = str(server.path)
    times = []
    try:
        await _transport(visit, server.endpoint, times, used)
        await _timed(times, "CORBA", _is_there(where, server.ref))
        await _timed(times, "naming", _is_context(where, server.ref))
    except _Stop as stop:
        visit.findings.append(stop.finding)
        return False
    shown = ", ".join(f"{name} {1000 * seconds:.1f} ms" for name, seconds in times)
    slow = [name for name, seconds in times if seconds > SLOW]
    if slow:
        name = "host file" if slow == ["name"] else "slow"
        cure = remedies.words(name, host=printable(server.endpoint[0]))
        visit.findings.append(warn("name server", where, f"slow ({shown})", cure))
    else:
        visit.findings.append(
            ok("name server", where, f"answers ({shown}){_used(visit, server.endpoint[0])}")
        )
    return True


def _used(visit, host):
    """The address at which a name server that is given by a host name was reached,
    and what else that name means.
    """
    if host == "localhost" or not visit.addresses or addresses.is_numeric(host):
        return ""
    used, *others = visit.addresses
    here = ", this host" if addresses.is_own(used) else ""
    if others:
        here += f"; {printable(host)} also means {', '.join(others)}"
    return f" at {used}{here}"


class _Stop(Exception):
    """A step failed, with this finding."""

    def __init__(self, where, message, remedy):
        super().__init__()
        self.finding = fail("name server", where, message, remedy)


async def _timed(times, name, step):
    begun = loop.now()
    starved = limits.starved()
    value = await step
    # what this host had no time for is not the server's
    times.append((name, max(0.0, loop.now() - begun - (limits.starved() - starved))))
    return value


async def _transport(visit, endpoint, times, used):
    """Name and TCP."""
    host, port = endpoint
    where = str(visit.path)
    shown = printable(host)
    if addresses.is_incomplete(host):
        message = f"{shown} is an address of one link only, which means nothing without an interface"
        raise _Stop(where, message, remedies.words("scope", host=shown))
    try:
        visit.addresses.extend(await _timed(times, "name", addresses.resolve(host)))
    except errors.Error as e:
        raise _Stop(where, f"host name {shown} not known here ({reason(e)})", remedies.words("host name"))
    try:
        address = await _timed(times, "TCP", addresses.connect(visit.addresses, port))
        visit.addresses.sort(key=address.__ne__)  # the one that was used first
    except errors.ConnectionRefused:
        other = await _other_port(visit, port, used)
        if other:
            raise _Stop(
                where,
                f"connection refused: nothing listens on port {port}, but something does on port {other} "
                "of that host",
                remedies.words("other port", server=shell_word("/%s:%d" % (host, other)), port=port),
            )
        own = [address for address in visit.addresses if addresses.is_own(address)]
        if own and host != "localhost" and not addresses.is_numeric(host):
            raise _Stop(
                where,
                f"connection refused: nothing listens on port {port} here; {shown} means {own[0]}, this host",
                remedies.words("start name server or correct host", port=port, host=shown),
            )
        if own:
            raise _Stop(
                where, f"connection refused: nothing listens on port {port} here",
                remedies.words("start name server", port=port),
            )
        raise _Stop(
            where,
            f"connection refused: {shown} runs, but nothing listens on port {port}, or a firewall refuses",
            remedies.words("start name server there", port=port),
        )
    except errors.Error as e:
        raise _Stop(
            where, f"no TCP connection to {visit.addresses[0]} port {port} ({reason(e)})",
            remedies.network(endpoint),
        )


async def _other_port(visit, port, used):
    """Another port of name servers at which the host accepts connections: one of those given before, on this
    host, one of the usual; None if no other port accepts them.
    """
    ports = sorted(used)
    if any(addresses.is_own(address) for address in visit.addresses):
        ports += usual.PORTS
    for other in ports:
        if other == port:
            continue
        try:
            await addresses.connect(visit.addresses, other)
        except errors.Error:
            continue
        return other
    return None


async def _is_there(where, ref):
    endpoint = orb.endpoint(ref)
    port = endpoint[1]
    rule = local.transport_rule()
    try:
        gone = await orb.call(where, ref, "_non_existent")
    except errors.Gone:
        gone = True
    except errors.Unanswered as e:
        if await remedies.is_of_network(e, endpoint):
            raise _Stop(
                where, "cannot tell from here: TCP connects, but what is sent is not received",
                remedies.network(endpoint),
            )
        if await addresses.speaks_otherwise(endpoint):
            raise _Stop(
                where, "what listens there does not speak CORBA", remedies.words("who listens", port=port)
            )
        raise _Stop(where, f"hung: accepts TCP, but {reason(e)}", _restart(e, where, port))
    except errors.Unreachable as e:
        if rule and reason(e) == errors.NO_USABLE_ADDRESS:
            raise _Stop(where, f"TCP connects, omniORB does not: {rule.text} forbids it", rule.remedy)
        if reason(e).startswith("garbled") or await addresses.speaks_otherwise(endpoint):
            raise _Stop(
                where, f"what listens there does not speak CORBA ({reason(e)})",
                remedies.words("who listens", port=port),
            )
        raise _Stop(
            where,
            f"cannot tell from here: TCP connects, then {reason(e)}; what listens there does not speak "
            "CORBA, or the network is broken",
            remedies.network(endpoint),
        )
    except errors.Refused as e:
        raise _Stop(where, f"answers with {reason(e)}", remedies.words("restart", port=port))
    if gone:
        raise _Stop(
            where, "a CORBA process, but not a name server: perhaps a component or manager",
            remedies.words("correct port"),
        )


def _restart(e, where, port):
    if isinstance(e, errors.NoTime):
        return remedies.words("more time", path=shell_word(where))
    return remedies.words("restart", port=port)


async def _is_context(where, ref):
    try:
        is_context = await orb.call(where, ref, "_is_a", _NAMING_CONTEXT)
    except errors.Error as e:
        raise _Stop(
            where, f"is there, but does not report what it is ({reason(e)})",
            _restart(e, where, orb.endpoint(ref)[1]),
        )
    if not is_context:
        raise _Stop(
            where, "its object NameService is not a naming context", remedies.words("correct or restart")
        )


# ---- what is bound in it ----


async def _below(visit, top):
    """The Nodes at and below a Path; what cannot be listed becomes a finding."""
    try:
        away = await _leads_away(top)
        if away is not None:
            visit.findings.append(references.alias(away))
            return []
        nodes = await aliases.within(await tree.walk(await tree.resolve(top), managers=False))
    except errors.Error as e:
        cure = remedies.words("no such path", path=shell_word(str(top.parent())))
        visit.findings.append(fail("path", str(top), reason(e), cure))
        return []
    for node in nodes:
        if node.kind in ("server", "directory") and node.error is not None:
            where = str(node.path)
            restart = remedies.words("restart name server")
            cure = await remedies.of_silence(node.error, node.endpoint, where, restart)
            message = f"its names cannot be listed ({reason(node.error)})"
            visit.findings.append(fail("context", where, message, cure))
    return nodes


async def _share(visit, tops):
    """Note the naming contexts with several names,
    which may be outside the part of the name server that is examined.
    """
    nodes = visit.nodes
    is_partial = any(top.names for top in tops)
    if is_partial and any(node.kind == "directory" for node in nodes):
        nodes = await tree.walk(await tree.resolve(visit.path), managers=False)
    for node in nodes:
        if node.alias is not None:
            visit.shared.enter(node)


async def _leads_away(top):
    """The first naming context on the way of a Path that belongs to another name server, or None."""
    above = await tree.resolve(path.Path(top.server, (), None, False))
    for size in range(1, len(top.names) + 1):
        node = await tree.resolve(top._replace(names=top.names[:size]))
        if node.kind != "directory":
            return None
        if await aliases.is_foreign(above, node):
            return node
        above = node
    return None


async def _probes(nodes):
    """{(host, port): None, or the errors.Error} of a TCP connection to each address that references
    publish.
    """
    refs = [node.ref for node in nodes if node.ref is not None and node.kind not in ("server", "directory")]
    pairs = sorted({(host, port) for ref in refs for host, port in orb.addresses(ref) if host and port})
    answers = await session.each(
        pairs, addresses.probe, lambda address: (("probe",) + address, "%s:%d" % address)
    )
    return dict(zip(pairs, answers))
