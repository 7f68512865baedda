"""Each manager: whether it answers, and whether what it lists lives."""

from rtshell_lite import errors
from rtshell_lite.corba import session
from rtshell_lite.doctor import limits, networks, remedies
from rtshell_lite.doctor.finding import fail, ok, published, reason, warn
from rtshell_lite.robot import component, tree
from rtshell_lite.text import counted, shell_word


async def asked(nodes):
    """[(Node, what it has, see `_ask`, or errors.Error)] of the managers among the Nodes, sorted by path."""
    managers = [node for node in nodes if node.kind == "manager"]
    managers.sort(key=lambda node: str(node.path))
    return list(zip(managers, await session.each(managers, _ask)))


async def findings(answers):
    """Findings on managers, given what `asked` gives."""
    return [finding for node, answer in answers for finding in await _troubles(node, answer)]


async def _ask(node):
    """(slaves, components, whether it was asked twice): a master whose slave has died fails once."""
    failed_once = []
    slaves = await component.once_more(lambda: tree.slaves(node), failed_once)
    managed = await component.once_more(lambda: tree.managed(node), failed_once)
    return slaves, managed, bool(failed_once)


async def _is_of_network(node, homes):
    return await remedies.is_of_network(node.error, node.endpoint) or not await networks.is_certain(
        node.ref, homes
    )


async def _troubles(node, answer):
    where = str(node.path)
    word = shell_word(where)
    if isinstance(answer, errors.Error):
        return [await _no_answer(node, where, answer)]
    slaves, components, twice = answer
    findings = []
    if twice:
        message = "one of its slaves has died, and its components with it"
        findings = [fail("manager", where, message, remedies.words("restart slave"))]
    homes = await networks.homes_of(node.ref)
    for child in slaves + components:
        what = "lists a slave that " if child in slaves else "lists a component that "
        misled = await networks.misled("manager", where, child.ref, homes)
        if misled:
            findings.append(misled._replace(message=what + misled.message))
        if misled and misled.level == "fail":
            continue
        if child.kind == "unasked":
            message = what + "was " + reason(child.error)
            cure = remedies.not_asked(child.error, where)
            findings.append(warn("manager", where, message, cure, child.endpoint))
        elif child.kind in ("zombie", "silent") and await _is_of_network(child, homes):
            message = what + f"cannot be reached from here ({reason(child.error)})"
            findings.append(fail("manager", where, message, remedies.network(child.endpoint)))
        elif child.kind == "zombie":
            cure = remedies.words("restart manager", path=word)
            findings.append(fail("manager", where, what + "is gone", cure))
        elif child.kind == "silent":
            message = what + f"does not answer ({reason(child.error)})"
            cure = remedies.words("hung below", path=word)
            findings.append(fail("manager", where, message, cure, child.endpoint))
    has = f"{counted(len(components), 'component')}, {counted(len(slaves), 'slave')}"
    shown = await published(node.ref)
    return findings or [ok("manager", where, f"manager of {has}, at {shown}")]


async def _no_answer(node, where, e):
    if isinstance(e, errors.NoTime):
        return limits.late("manager", where)
    if isinstance(e, errors.NotAsked):
        cure = remedies.not_asked(e, where)
        return warn("manager", where, reason(e), cure, node.endpoint)
    name = "restart manager or slave" if isinstance(e, errors.Silent) else "restart"
    cure = await remedies.of_silence(e, node.endpoint, where, remedies.words(name, port=node.endpoint[1]))
    return fail("manager", where, f"does not report what it has ({reason(e)})", cure)
