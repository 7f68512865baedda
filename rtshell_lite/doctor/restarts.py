"""Components that something starts again and again: each look finds them alive."""


from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.doctor import remedies
from rtshell_lite.doctor.finding import warn
from rtshell_lite.net import loop
from rtshell_lite.robot import tree


async def findings(nodes, seconds):
    """Findings on the names among the Nodes to which another object is bound after some seconds, sorted by
    path. Only name servers are asked.
    """
    bound = [node for node in nodes if node.kind in ("component", "zombie") and node.ref is not None]
    bound.sort(key=lambda node: str(node.path))
    await loop.pass_by(seconds)
    now = session.current()
    now.end = max(now.end, loop.now() + now.timeout)
    all_findings = []
    answers = await session.each([node.path for node in bound], tree.resolve, tree.at_server)
    for node, again in zip(bound, answers):
        where = str(node.path)
        if isinstance(again, errors.NotFound):
            message = f"its name was deleted within {seconds:g} s"
        elif isinstance(again, errors.Error) or again.ref is None:
            continue
        elif orb.identity(again.ref) == orb.identity(node.ref):
            continue
        else:
            change = f"it was at {orb.at_address(node.ref)}, and is at {orb.at_address(again.ref)} now"
            message = f"started again within {seconds:g} s: {change}"
        all_findings.append(warn("component", where, message, remedies.words("crash loop")))
    return all_findings
