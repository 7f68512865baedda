"""Composites with dead members: such a composite ends, or stops, as soon as somebody uses it."""

from rtshell_lite import errors
from rtshell_lite.corba import orb, refusals, session
from rtshell_lite.doctor import limits, remedies
from rtshell_lite.doctor.finding import fail, published, reason, warn
from rtshell_lite.robot import composites
from rtshell_lite.text import printable


async def findings(snapshots):
    """Findings on members that do not answer, of those snapshot.Snapshots that are of composites,
    sorted by path.
    """
    candidates = [
        snapshot for snapshot in snapshots if snapshot.error is None and _may_be_composite(snapshot)
    ]
    answers = await session.each([snapshot.node for snapshot in candidates], composites.owned)
    all_findings = []
    for snapshot, answer in zip(candidates, answers):
        where = snapshot.where
        if isinstance(answer, errors.Error):
            if isinstance(answer, errors.NoTime):
                all_findings.append(limits.late("composite", where))
                continue
            message = f"does not report its members ({reason(answer)})"
            cure = await remedies.of_silence(answer, snapshot.node.endpoint, where)
            all_findings.append(warn("composite", where, message, cure))
            continue
        for organisation in answer:
            all_findings += [
                await _lost(snapshot, name, ref)
                for name, ref in organisation.members
                if isinstance(name, errors.Error)
            ]
    return sorted(all_findings, key=lambda finding: finding.path)


def _may_be_composite(snapshot):
    """True for a component in whose own context others take part: a composite executes its members."""
    return bool(snapshot.refusing) or any(
        context.participants and orb.same(context.owner, snapshot.node.ref) for context in snapshot.contexts
    )


async def _lost(snapshot, error, ref):
    shown = printable(await published(ref))
    if isinstance(error, errors.NoTime):
        return limits.late("composite", snapshot.where)
    if isinstance(error, errors.NotAsked):
        message = f"its member at {shown} was {reason(error)}"
        cure = remedies.not_asked(error, snapshot.where)
        return warn("composite", snapshot.where, message, cure, orb.endpoint(ref))
    if await refusals.shows_death(error, orb.endpoint(ref), snapshot.node.endpoint[0]):
        return fail(
            "composite", snapshot.where, "one of its members is dead: nothing answers at " + shown,
            remedies.words("restart composite", port=snapshot.node.endpoint[1]),
        )
    if await remedies.is_of_network(error, orb.endpoint(ref)):
        message = f"cannot tell from here whether its member at {shown} lives ({reason(error)})"
        return warn("composite", snapshot.where, message, remedies.network(orb.endpoint(ref)))
    return fail(
        "composite", snapshot.where, f"its member at {shown} hangs ({reason(error)})",
        remedies.words("restart", port=orb.endpoint(ref)[1]), orb.endpoint(ref),
    )
