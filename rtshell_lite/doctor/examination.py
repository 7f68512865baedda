"""What rtdoctor does: a system examined from the outside in, without changing it, in bounded time.

Here, the name servers, the references in them, the components, their connections, managers, a profile: each
step reports Findings and passes on to the next what still works. Everything of one step is asked in parallel.
"""

import collections

from rtshell_lite import errors, path
from rtshell_lite.corba import orb, session
from rtshell_lite.doctor import limits, local, remedies
from rtshell_lite.doctor.finding import warn
from rtshell_lite.net import loop
from rtshell_lite.robot import tree

# times the timeout: what takes longer is reported as not looked at; a step waits for silence only once
STEPS = 3
LISTS = 7  # of Findings, that `examine` yields; one more for each of `compare` and `pause`

# What was seen in an examination: servers.Visits, Snapshots of the components, {identity: places.End} of all
# ports that they have or are connected with, what managers have (see managers.asked).
Seen = collections.namedtuple("Seen", "visits snapshots ends managers")


async def examine(tops=(), compare=None, seconds=0, keep=None, pause=None):
    """Yield lists of Findings, step by step. Without Paths `tops`, or with the root, all name servers are
    examined.

    compare  (RtsProfile, its file as it is given to commands, the state of the components): what the system
             should be like
    seconds  how long to measure rates, by connecting to an out port of each active component; 0: do not
    keep     a function that is given the Seen; the components are then asked for everything that rtcat shows
    pause    seconds after which the names are looked at again, or None
    """
    now = session.current()
    now.silent.clear()  # what this command has asked before must not keep anybody from being asked
    now.stalled.clear()
    now.end = loop.now() + STEPS * now.timeout
    starved = limits.starved()
    try:
        async for findings in _steps(tops, compare, seconds, keep, pause):
            before = starved
            starved = limits.starved()
            if session.current().end is not None:  # what was late here is no silence of others
                session.current().end += starved - before
            if session.current().shortage:
                raise session.current().shortage
            yield limits.left_out(findings)
    except errors.Shortage as e:
        yield [limits.lack(e)]
    except MemoryError:
        yield [limits.lack(errors.Shortage("memory", "no more can be had"))]
    finally:
        session.current().shortage = None
        session.current().checks.clear()
        session.current().end = None  # other commands may follow in this process


async def _steps(tops, compare, seconds, keep, pause):
    findings = await local.findings()
    yield findings
    failed = [finding.check for finding in findings if finding.level == "fail"]
    if "ORB" in failed or "limit" in failed:
        return
    everything = not tops or path.ROOT in tops
    if everything:
        tops = await _name_servers()
    async for findings in _robot(tops, seconds, bool(compare), keep, pause):
        yield findings
    if compare:
        from rtshell_lite.doctor import profile

        now = session.current()
        now.end = max(now.end, loop.now() + now.timeout)
        yield await profile.findings(*compare)


async def _name_servers():
    """The Paths of the name servers with valid addresses; the others have been reported."""
    return [path.parse("/" + address) for address in tree.servers() if not await local.fault(address)]


async def _robot(tops, seconds, stated, keep, pause):
    from rtshell_lite.doctor import buffers, components, composites, connections, managers
    from rtshell_lite.doctor import references, restarts, servers, waiting

    visits = await servers.visits(tops)
    yield [finding for visit in visits for finding in visit.findings] + await _same_server(visits)
    yield [finding for visit in visits for finding in await references.findings(visit)]
    nodes = [node for visit in visits for node in visit.nodes]
    examined = await components.examined(nodes)
    other = (errors.ConnectionRefused, errors.Unspoken, errors.Garbled)
    hung = [node for node in nodes if node.kind == "silent" and not isinstance(node.error, other)]
    hung.sort(key=lambda node: str(node.path))
    culprits = await waiting.culprits(examined, hung)
    ends = await connections.all_ends(examined)
    links = await connections.findings(examined, dict(ends), culprits)
    answers = await managers.asked(nodes)
    managed = await managers.findings(answers)
    members = await composites.findings(examined)
    rates = await _rates(examined, seconds) if seconds else {}
    logs = await components.logs(examined, nodes)
    yield await components.findings(examined, rates, culprits, stated, logs)
    yield members
    yield links + buffers.findings(examined)
    yield managed
    if pause is not None:
        yield await restarts.findings(nodes, pause)
    if keep:
        await components.complete(examined)
        keep(Seen(visits, examined, ends, answers))


async def _rates(examined, seconds):
    from rtshell_lite.doctor import rates

    # what is connected must be disconnected, however late it is
    end = session.current().end
    session.current().end = None
    try:
        return await rates.measured(examined, seconds)
    finally:
        session.current().end = end


async def _same_server(visits):
    """Two addresses of one name server: everything in it would be listed twice."""
    findings = []
    seen = {}
    for visit in visits:
        for address in visit.addresses:
            server = await tree.resolve(visit.path)
            first = seen.setdefault((address, orb.endpoint(server.ref)[1]), visit)
            if first is not visit:
                message = "the same name server as " + str(first.path)
                findings.append(warn("name server", str(visit.path), message, remedies.words("one address")))
                break
    return findings
