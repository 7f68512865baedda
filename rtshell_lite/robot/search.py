"""Finding objects in the RTC Tree: by name, kind and state."""

from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.path import ROOT
from rtshell_lite.records import record
from rtshell_lite.robot import component, tree

POLL = 0.5  # seconds between two searches of --wait

# What to find: `names` a list of functions name → bool (any of them; empty: all names), `kinds` a set (empty:
# all), `states` a set (empty: all), `depth` levels or None.
Wanted = record("Wanted", "names kinds states depth")

# What a node of a kind may turn out to be.
CAN_BE = {kind: {kind, "zombie", *tree.DOUBTFUL} for kind in ("component", "manager")}


def patterns(exact, any_case):
    """Functions for shell patterns, in which `*` is any text and `?` any character,
    on the whole of a name.
    """
    import re

    flags = [(pattern, re.DOTALL) for pattern in exact]
    flags += [(pattern, re.DOTALL | re.IGNORECASE) for pattern in any_case]
    return [re.compile(_expression(pattern), flag).match for pattern, flag in flags]


def _expression(pattern):
    import re

    parts = {"*": ".*", "?": "."}
    return "".join(parts.get(c) or re.escape(c) for c in pattern) + r"\Z"


async def find(paths, criteria):
    """The Nodes at and below `paths` that are Wanted, in the order of the tree, a list of the errors met, and
    near misses.

    These are nodes whose names would match without their kinds, if no name does.
    """
    answers = await session.each(paths, lambda path: _below(path, criteria), tree.at_server)
    parts, failures = errors.split(answers)
    nodes = [node for part in parts for node in part]
    failures += [node.error for node in nodes if node.error is not None and node.kind != "zombie"]
    named = [node for node in nodes if not criteria.names or _matches(node.name, criteria.names)]
    last_names = [(node, node.path.names[-1].id) for node in nodes if node.path.names and not named]
    close = [node for node, name in last_names if _matches(name, criteria.names)]
    nodes = named
    if criteria.kinds:
        may_be = [(node, CAN_BE.get(node.kind, {node.kind})) for node in nodes]
        nodes = [node for node, kinds in may_be if node.kind == "unsure" or criteria.kinds & kinds]
    if criteria.kinds or criteria.states:  # only then it matters what lives
        nodes = await tree.check_alive(nodes)
    if criteria.kinds:
        nodes = [node for node in nodes if node.kind in criteria.kinds]
    if criteria.states:
        nodes, more = await _in_states(nodes, criteria.states)
        failures += more
    return nodes, failures + [node.error for node in nodes if node.kind in tree.DOUBTFUL], close


def _matches(name, patterns):
    return any(match(name) for match in patterns)


async def components(tops=()):
    """(component nodes, each object once, by its first path; manager nodes; errors; notes) below the Paths
    (none: all name servers).

    Components below managers are skipped: they are bound in a name server, too.
    """
    orb.start()
    parts, failures = errors.split(await session.each(tops or [ROOT], _walk_top, tree.at_server))
    walked = [node for part in parts for node in part]
    failures += [
        node.error for node in walked if node.kind in ("server", "directory") and node.error is not None
    ]
    unsure = [node for node in walked if node.kind == "unsure"]
    sure = dict(zip(unsure, await tree.check_alive(unsure)))
    walked = [sure.get(node, node) for node in walked]
    walked.sort(key=lambda node: str(node.path))
    managers = [node for node in walked if node.kind == "manager" and node.alias is None]
    nodes = []
    notes = []
    seen = {}
    for node in walked:
        if node.kind in tree.DOUBTFUL:
            failures.append(node.error)
        if node.kind != "component":
            continue
        before = seen.setdefault(orb.identity(node.ref), node)
        if before is node:
            nodes.append(node)
        elif before.path != node.path:
            notes.append(f"{node.path}: the same component as {before.path}")
    return nodes, managers, failures, notes


async def _walk_top(top):
    return await tree.walk(await tree.resolve(top), managers=False)


async def _below(path, criteria):
    if path.port is not None:
        raise errors.WrongKind(str(path), "directory", "port")
    top = await tree.resolve(path)
    if path.directory and top.kind not in tree.DIRECTORIES:
        raise errors.WrongKind(str(path), "directory", top.what)
    nodes = list(await tree.walk(top, criteria.depth))
    if top.error is not None:
        raise top.error
    return nodes


async def _in_states(nodes, states):
    silent = [node.error for node in nodes if node.kind in tree.DOUBTFUL]
    components = [node for node in nodes if node.kind == "component"]
    answers = await session.each(components, component.state)
    in_states = [node for node, answer in zip(components, answers) if answer in states]
    failures = [answer for answer in answers if isinstance(answer, errors.Error)]
    return in_states, silent + failures
