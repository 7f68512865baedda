"""Composites whose members are dead: such a composite ends, or stands still, as soon as somebody uses it."""
from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.doctor import remedies
from rtshell_lite.doctor.finding import fail, published, reason, warn
from rtshell_lite.robot import composites, tree
from rtshell_lite.text import printable


def findings(all_of_them):
    """Findings on members that do not answer, of the snapshot.Snapshot that are composites, sorted by path."""
    some = [each for each in all_of_them if each.error is None and _may_be_composite(each)]
    answers = tree.on_nodes([each.node for each in some], composites.owned)
    found = []
    for each, answer in zip(some, answers):
        if isinstance(answer, errors.Error):
            message = f"does not say which members it has ({reason(answer)})"
            found.append(warn("composite", each.where, message, remedies.of_silence(answer, each.node.endpoint, each.where)))
            continue
        for one in answer:
            found += [_lost(each, name, ref) for name, ref in one.members if isinstance(name, errors.Error)]
    return sorted(found, key=lambda one: one.path)


def _may_be_composite(each):
    """True for a component in whose own context others take part; who has members executes them."""
    return bool(each.refusing) or any(context.participants and orb.same(context.owner, each.node.ref)
                                      for context in each.contexts)


def _lost(each, error, ref):
    told = printable(published(ref))
    if isinstance(error, (errors.Gone, errors.ConnectionRefused)):
        return fail("composite", each.where, "one of its members is dead: nothing answers at " + told,
                    remedies.words("restart composite", port=each.node.endpoint[1]))
    if remedies.is_of_network(error, orb.endpoint(ref)):
        message = f"cannot tell from here whether its member at {told} lives ({reason(error)})"
        return warn("composite", each.where, message, remedies.network(orb.endpoint(ref)))
    return fail("composite", each.where, f"its member at {told} hangs ({reason(error)})",
                remedies.words("restart", port=orb.endpoint(ref)[1]))
