"""Execution contexts: rate, start and stop, participants (OMG RTC 1.1, 5.2.2.5)."""

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.records import record
from rtshell_lite.robot import component
from rtshell_lite.text import shell_word

SETTLE_TIME = 2.0  # seconds: a component joins and leaves at the context's next cycle, in 0.3 s as a rule

# One line of rtec: `index` as -e counts, a component.Context, the component's state in it, names of owner and
# participants.
Entry = record("Entry", "index context state owner participants")


async def entries(node, only=None):
    """An Entry for each execution context of a component, the owned ones first; `only`: for the context
    number `only`.

    The Context of an Entry is None if it belongs to another component that does not answer.
    """
    if only is not None:
        return [await _entry(node, only, await component.context_ref(node, only))]
    owned, participating = await component.context_refs(node)
    return [await _entry(node, index, ref) for index, ref in enumerate(owned + participating)]


async def _entry(node, index, ref):
    context = await component.or_default(node, ref, component.context(node, ref), None)
    if context is None:
        return Entry(index, None, "Unknown", "", [])
    (state,) = await component.states(node, [ref])
    owner = await component.instance_name(node, context.owner)
    participants = [await component.instance_name(node, ref) for ref in context.participants]
    return Entry(index, context, state, owner, participants)


# ---- changing ----


async def set_rate(node, index, rate):
    """Set the rate (Hz) of a context and check it. Raises Refused."""
    ref = await component.context_ref(node, index)
    where = str(node.path)
    code = str(await orb.call(where, ref, "set_rate", rate))
    now = await component.uncertain_if_refused(orb.call(where, ref, "get_rate"))
    if code != "RTC_OK" or not same_rate(now, rate):
        raise errors.Refused(where, f"does not take a rate of {rate:g} Hz ({code}; it is {now:g} Hz)")
    return f"{node.path}: {now:g} Hz"


async def is_idle(node, index):
    """Whether a context is stopped, and its component takes part in others, as members of composites do."""
    try:
        ref = await component.context_ref(node, index)
        if await orb.call(str(node.path), ref, "is_running"):
            return False
        _, participating = await component.context_refs(node)
        return bool(participating)
    except errors.Error:
        return False


def same_rate(now, expected):
    """Whether a context has the rate that was asked of it: implementations round its period."""
    return abs(now - expected) <= 0.01 * expected


async def start(node, index):
    """Start a context. Raises Refused."""
    return await _run(node, index, "start", True)


async def stop(node, index):
    """Stop a context: its components keep their states, and none of them is executed. Raises Refused."""
    return await _run(node, index, "stop", False)


async def _run(node, index, operation, is_started):
    ref = await component.context_ref(node, index)
    where = str(node.path)
    code = str(await orb.call(where, ref, operation))  # PRECONDITION_NOT_MET if it already is
    running = await component.uncertain_if_refused(orb.call(where, ref, "is_running"))
    if bool(running) != is_started:
        raise errors.Refused(where, f"its execution context does not {operation} ({code})")
    return f"{where}: {'running' if is_started else 'stopped'}"


async def one_by_one(change, node, index, participants):
    """`attach` or `detach` the components, in their order; an errors.Error in the place of what failed."""
    results = []
    for participant in participants:
        if not isinstance(participant, errors.Error):
            participant = await errors.or_error(change(node, index, participant))
        results.append(participant)
    return results


async def attach(node, index, participant):
    """Let the component `participant` take part in a context. Raises Failed, Refused, and Unreachable if that
    is dead.

    OpenRTM-aist 2 lists it at once, and knows its state, and takes commands for it, from the context's next
    cycle on.
    """
    ref = await component.context_ref(node, index)
    where = str(node.path)
    await orb.is_alive(participant.path, participant.ref)
    profile = await orb.call(where, ref, "get_profile")
    if orb.same(profile.owner, participant.ref):
        raise errors.Failed(where, f"{participant.path!s} owns this execution context")
    if not _takes_part(profile, participant):
        code = str(await orb.call(where, ref, "add_component", participant.typed))
        if code == "RTC_OK":
            profile = await component.uncertain_if_refused(orb.call(where, ref, "get_profile"))
        if not _takes_part(profile, participant):
            raise errors.Refused(where, f"its execution context does not take {participant.path!s} ({code})")

    async def is_executed():
        return await component.state_in(participant, ref) != "Created"

    if await component.until(is_executed, SETTLE_TIME):
        return f"{node.path}: {participant.path} takes part"
    return f"{node.path}: {participant.path} takes part from its next cycle on"


async def detach(node, index, participant):
    """Let the component `participant` leave a context, which happens at its next cycle.
    Raises NoSuch, Refused.
    """
    ref = await component.context_ref(node, index)
    where = str(node.path)
    profile = await orb.call(where, ref, "get_profile")
    if not _takes_part(profile, participant):
        raise errors.NoSuch(where, "participant", str(participant.path))
    code = str(await orb.call(where, ref, "remove_component", participant.typed))
    seconds = max(SETTLE_TIME, 3 / profile.rate) if profile.rate > 0 else SETTLE_TIME
    if not await component.until(lambda: _has_left(where, ref, participant), seconds):
        raise errors.Refused(where, f"its execution context does not let go of {participant.path!s} ({code})")
    return f"{node.path}: {participant.path} left"


async def _has_left(where, ref, participant):
    """Whether neither the context lists the component, nor the component the context,
    which may execute it until then.
    """
    profile = await component.uncertain_if_refused(orb.call(where, ref, "get_profile"))
    if _takes_part(profile, participant):
        return False
    others = await component.participating_context_refs(participant)
    return not any(orb.same(ref, other) for other in others)


def _takes_part(profile, participant):
    return any(orb.same(ref, participant.ref) for ref in profile.participants)


async def command(node, index, *words):
    """An rtec command for a context of a component, ready for a shell. Raises NoSuch."""
    await component.context_ref(node, index)
    option = ["-e", str(index)] if index else []
    return " ".join(["rtec"] + option + [shell_word(word) for word in (str(node.path),) + words])
