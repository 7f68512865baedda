"""How components exit: out of the execution contexts of others first, and it is seen that they are gone."""


from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.net import loop
from rtshell_lite.robot import component, tree
from rtshell_lite.text import shell_word

ENDING = 1.0  # seconds that a process may take to end
# seconds that an execution context gets, at least, to release a component: it does so in its next cycle
LEAVING = 2.0
LEAVING_MOST = 60.0  # at most, whatever rate it claims


async def exit_all(paths, wait=None, dry_run=False):
    """LightweightRTObject::exit of the component at each path: a line or an errors.Error for each.

    With `wait` (seconds) also wait until the name is unbound, which a component's manager does up to a second
    later.
    """

    async def exit_one(node):
        if dry_run:
            return "rtexit " + shell_word(str(node.path))
        await leave(node)
        await _exit(node)
        if wait is not None and not await component.until(lambda: _is_unbound(node), wait):
            why = f"has exited, but its name is still bound after {wait:g}s"
            raise errors.Unreachable(str(node.path), why)
        return f"{node.path}: exited"

    return await tree.on_components(paths, exit_one)


async def leave(node):
    """Take a component that is to exit out of the execution contexts of others, such as composites, and wait
    until it has left.

    A context informs a component in its next cycle that it has left. If that has exited by then, the
    context's process ends, too (C++ 2.1). Raises Refused if a context keeps it.
    """
    asked = []
    seconds = LEAVING
    for ref in await component.participating_context_refs(node):
        try:
            rate = await orb.call(node.path, ref, "get_rate")
            await orb.call(node.path, ref, "remove_component", node.typed)
        except errors.Error:
            continue  # it is gone, hangs or refuses
        asked.append(ref)
        if rate > 0:
            seconds = max(seconds, min(3 / rate, LEAVING_MOST))

    async def has_left():
        present = await component.participating_context_refs(node) if asked else []
        return not any(orb.same(other, ref) for other in present for ref in asked)

    if not await component.until(has_left, seconds):
        raise errors.Refused(
            str(node.path),
            "an execution context that it takes part in does not let go of it (see rtec); its "
            "process could end if this one did",
        )


async def _exit(node):
    await orb.is_alive(node.path, node.ref)  # if it is dead afterwards, this call has ended it
    try:
        code = str(await node.call("exit"))
    except (errors.Unanswered, errors.Refused):
        raise
    except errors.Unreachable:
        if not await _has_ended(node):
            raise
        return
    if code != "RTC_OK":
        raise errors.Refused(str(node.path), f"does not exit ({code})")


async def _has_ended(node):
    """Whether a component whose answer was lost is gone: the last one of a process ends the process.

    A process that ends may still accept a connection, and drop it, before it refuses the next.
    """
    limit = loop.now() + ENDING
    while True:
        (now,) = await tree.check_alive([node])
        if now.kind == "zombie":
            return True
        if isinstance(now.error, errors.Unanswered) or loop.now() > limit:
            return False
        await loop.sleep(component.POLL)


async def _is_unbound(node):
    try:
        await tree.resolve(node.path)
    except errors.NotFound:
        return True
    return False
