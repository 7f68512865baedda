"""Transitions between the states of a component, and in which of its execution contexts they are made."""


from rtshell_lite import errors, notes
from rtshell_lite.corba import orb, session
from rtshell_lite.net import loop
from rtshell_lite.records import record
from rtshell_lite.robot import component, lookup, search, tree
from rtshell_lite.text import printable, shell_word

JITTER = 0.03  # seconds that a cycle of an execution context may come late

# What a transition is called, the operation that asks for it, the state it leads to, the state it starts
# from.
Transition = record("Transition", "name command operation target source")
ACTIVATE = Transition("activate", "rtact", "activate_component", "Active", "Inactive")
DEACTIVATE = Transition("deactivate", "rtdeact", "deactivate_component", "Inactive", "Active")
RESET = Transition("reset", "rtreset", "reset_component", "Inactive", "Error")
ACCEPTED = "accepted"  # what became of a component that has accepted a request, and may not have done it yet

# A component in one of its execution contexts: the number of the context as -e counts, its reference, whether
# it is the component's own, and the component's state there.
ContextState = record("ContextState", "index ref is_own state")


async def asked(args, transition):
    """What `change_all` or, with --all, `change_below` returns for the options of options.transition."""
    change_them = change_below if args.all else change_all
    paths = await lookup.paths(args.paths)
    return await change_them(paths, transition, args.exec_context, args.wait, args.dry_run)


async def change_all(paths, transition, index=None, wait=None, dry_run=False):
    """`change` for the component at each path, in parallel: a line that says what was done, or an
    errors.Error, for each.

    With `dry_run` nothing changes, and the line is the command that would change the component, '' where none
    is needed.
    """

    orb.start()
    nodes = await tree.components(paths)
    named = [lookup.with_components(node, "--all takes the components in it") for node in nodes]
    return await session.each(named, lambda node: _change_one(node, transition, index, wait, dry_run))


async def _change_one(node, transition, index, wait, dry_run):
    """`change` of one component: a line, see `change_all`."""
    if dry_run:
        return await _command(node, transition, index)
    now = await change(node, transition, index, wait)
    return f"{node.path}: {now}"


async def change_below(paths, transition, index=None, wait=None, dry_run=False):
    """`change` for all components at and below the Paths, in parallel: a line or an errors.Error for each;
    '' for those that a reset does not concern, as they are not in Error. Zombies are left out.

    Raises Failed where there is no component.
    """
    nodes, _, failures, _ = await search.components(paths)
    if not nodes and not failures:
        raise errors.Failed(", ".join(map(str, paths)), "no components")

    async def change_one(node):
        if transition is RESET and await component.state(node) != "Error":
            return ""
        return await _change_one(node, transition, index, wait, dry_run)

    changed = []
    results = await session.each(nodes, change_one)
    for node, result in zip(nodes, results):
        if isinstance(result, (errors.Gone, errors.ProcessGone)):
            notes.note(f"{node.path}: zombie, left out")
        else:
            changed.append(result)
    return failures + changed


async def _command(node, transition, index):
    """The command that would take a component through a Transition, '' where none is needed."""
    if index is not None:
        now = await component.state_in(node, await component.context_ref(node, index))
        return "" if now == transition.target else _words(transition, index, node)
    contexts = await context_states(node)
    if transition is ACTIVATE:
        context = await _to_activate(node, contexts)
        if context.state == "Active":
            return ""
        return _words(transition, context.index or None, node)
    leaving = _to_leave(contexts)
    _check_that_one_answers(node, leaving)
    return _words(transition, None, node) if leaving else ""


def _words(transition, index, node):
    option = [] if index is None else ["-e", str(index)]
    return " ".join([transition.command] + option + [shell_word(str(node.path))])


async def context_states(node):
    """A ContextState for each execution context of a component, as -e counts them, but not for those that are
    known to have ended.

    The state is Unknown in a context of another process that does not answer: the component may be Active
    there. Raises NoSuch if it has no context.
    """
    owned = await component.owned_context_refs(node)
    participating = await component.participating_context_refs(node)
    context_states = []
    for index, ref in enumerate(owned + participating):
        try:
            state = await component.state_in(node, ref)
        except errors.Gone:
            if index < len(owned):  # the component itself is ending
                raise
            continue
        except errors.Unreachable as e:
            if orb.endpoint(ref) == node.endpoint:
                raise
            if await _proves_death(e, ref, node):
                continue
            state = "Unknown"
        context_states.append(ContextState(index, ref, index < len(owned), state))
    if not context_states:
        raise errors.NoSuch(str(node.path), "execution context", "0 (it has 0)")
    return context_states


async def _proves_death(failure, ref, node):
    """Whether the failure of a call of the context `ref`, which a Node has given, proves that its process is
    gone: nothing is executed there.
    """
    if not isinstance(failure, errors.ConnectionRefused):
        return False
    from rtshell_lite.corba import refusals  # few need it

    return await refusals.is_gone(orb.endpoint(ref), node.endpoint[0])


async def _members_first(node, ref, wait):
    """Deactivate the members of a composite of C++ 1.1 before it:
    the thread that deactivates it would wait for them in vain.
    """
    if not orb.address(ref).type_id.endswith("/ExtTrigExecutionContextService:1.0"):
        return
    raw = await orb.call(node.path, ref, "get_profile")
    if not orb.same(raw.owner, node.ref) or not raw.participants:
        return
    if not await node.call("get_owned_organizations"):
        return
    for member in raw.participants:
        if await component.state_of(node, ref, member) == "Active":
            await orb.call(node.path, ref, "deactivate_component", member, seconds=wait)


async def change(node, transition, index=None, wait=None):
    """Take a component through a Transition; returns the state in which it is now, or that it has accepted
    the request, and where that is not its own first context.

    `index` is the number of the execution context. Without it, a component becomes Inactive in all contexts
    in which it is not yet, and Active in one: see `_activate`.

    `wait` (seconds) polls until the state is reached, and Active still there a period later. Contexts of 1.1
    answer before the state has changed, later ones answer RTC_ERROR when it takes longer than their own limit
    of 0.5 s but change it nevertheless: so after RTC_ERROR the state is polled for the timeout. Raises
    Refused with the reason, Unreachable when it was not reached.
    """
    if index is not None:
        ref = await component.context_ref(node, index)
        return await _change_in(node, ref, transition, wait, _number(index))
    contexts = await context_states(node)
    if transition is not ACTIVATE:
        return await _leave(node, contexts, transition, wait) or transition.target
    context, now = await _activate(node, contexts, wait)
    done = await _where(node, context, now)
    if context.state == "Active" and context.index:
        done = "already " + done
    silent = _all_in(contexts, "Unknown")
    if silent:
        done += f"; {_silence(silent[0])}"
    return done


def _number(index):
    return f"its execution context {index}"


def _all_in(contexts, state):
    return [context for context in contexts if context.state == state]


def _to_leave(contexts):
    """The contexts in which a component has to become Inactive.
    A context that does not know it (Created) is asked only if none does.
    """
    knowing = [context for context in contexts if context.state != "Created"] or contexts[:1]
    return [context for context in knowing if context.state != "Inactive"]


def _check_that_one_answers(node, contexts):
    """Raise Unreachable if nothing can be done, as none of these contexts answers."""
    if contexts and all(context.state == "Unknown" for context in contexts):
        raise errors.Unreachable(str(node.path), _silence(contexts[0]))


def _silence(context):
    return f"{_number(context.index)}, of another component, does not answer: it may be Active there"


def _ignore(stage):
    """In place of a function that notes how far a change has come."""


async def _leave(node, contexts, transition, wait, stage=_ignore):
    """Make a component Inactive in all contexts in which it is not: what became of it, as `_reach` says; None
    where there was no such context. Raises the first failure, at the end.

    All contexts are asked before one is waited for: where a component stops slowly, or never, it stops
    elsewhere all the same.
    """
    leaving = _to_leave(contexts)
    asked = []
    failures = []
    reached = set()
    start = loop.now()
    for context in leaving:
        try:
            _check_that_one_answers(node, [context])
            called = _number(context.index)
            asked.append((context, await _request(node, context.ref, transition, wait, called, stage)))
        except errors.Error as e:
            failures.append(e)
    for context, code in asked:
        try:
            reached.add(await _reach(node, context.ref, transition, code, context.state, wait, start))
        except errors.Error as e:
            failures.append(e)
    errors.raise_first(failures)
    if ACCEPTED in reached:
        return ACCEPTED
    return max(reached, default=None)


async def _activate(node, contexts, wait, stage=_ignore):
    """Make a component Active in one of its contexts: (that context, in which its state is Active if it was
    so before; what became of it, as `_reach` says).

    Robots of hrpsys and rtcloader run many components in the context of one. A component that is Active in
    two contexts is executed by both, at the same time; so one that is Active anywhere stays as it is.
    """
    context = await _to_activate(node, contexts)
    now = await _change_in(node, context.ref, ACTIVATE, wait, _number(context.index), context.state, stage)
    return context, now


async def _to_activate(node, contexts):
    """The context in which a component is Active, or in Error, or is to become Active: the first that runs.

    Raises Unreachable where none is known to run, and the component may be Active in one that does not
    answer.
    """
    settled = _all_in(contexts, "Active") or _all_in(contexts, "Error")
    if settled or len(contexts) == 1:
        return (settled or contexts)[0]
    for context in [context for context in contexts if context.state != "Unknown"]:
        asked = orb.call(node.path, context.ref, "is_running")
        if await component.or_default(node, context.ref, asked, False):
            return context
    _check_that_one_answers(node, _all_in(contexts, "Unknown"))
    return contexts[0]


async def _where(node, context, now):
    """What a component is `now`, and in which context, if that is not the first of its own."""
    if context.index == 0:
        return now
    if context.is_own:
        return f"{now} in {_number(context.index)}"
    asked = orb.call(node.path, context.ref, "get_profile")
    profile = await component.or_default(node, context.ref, asked, None)
    owner = printable(await component.instance_name(node, profile.owner)) if profile else ""
    return f"{now} in the context of {owner or 'another component'}"


async def change_as_planned(node, transition, index, wait, stage):
    """`change` for a plan that names the execution context number `index`: whether there was something to do.

    A component that is Active in the context of another component is not made Active in its own, nor the
    other way round; if the one that the plan names is stopped, such another one that runs is meant. It
    becomes Inactive in all contexts.

    If the component has to change, stage("asking") is called before it is asked, and stage("accepted") when
    it has accepted.
    """
    contexts = await context_states(node)
    if transition is not ACTIVATE:
        return await _leave(node, contexts, transition, wait, stage) is not None
    named = [context for context in contexts if context.index == index]
    if not named:
        raise errors.NoSuch(str(node.path), "execution context", f"{index}: it has ended")
    others = [context for context in contexts if context.is_own != named[0].is_own]
    context, _ = await _activate(node, named + others, wait, stage)
    return context.state != "Active"


async def _change_in(node, ref, transition, wait, called, before=None, stage=_ignore):
    """`change` in one execution context, which messages call so: what became of it, as `_reach` says.
    `before` is the state there, if that has just been asked.
    """
    before = before or await component.state_in(node, ref)
    if before != transition.target:
        code = await _request(node, ref, transition, wait, called, stage)
        return await _reach(node, ref, transition, code, before, wait, loop.now())
    if wait is not None:
        await check_still_active(node, ref, transition, wait)
    return transition.target


async def _request(node, ref, transition, wait, called, stage):
    """Ask the context `ref` for a Transition: its return code as text."""
    stage("asking")
    if transition is DEACTIVATE:
        await _members_first(node, ref, wait)
    # C++ 1.1 answers a deactivation only after 10 periods, 10 s at 1 Hz: `wait` is for the answer, too
    code = await orb.call(node.path, ref, transition.operation, node.typed, seconds=wait)
    if str(code) == "BAD_PARAMETER":
        reference = await component.canonical(node)
        if reference is None:
            raise errors.Refused(str(node.path), "is not in " + called)
        code = await orb.call(node.path, ref, transition.operation, reference, seconds=wait)
    if str(code) == "RTC_OK":
        stage("accepted")
    return str(code)


async def _reach(node, ref, transition, code, before, wait, start):
    """See that a Transition from the state `before`, answered with `code`, is made: the state. Without
    `wait`, RTC_OK is enough, and the result is ACCEPTED.

    `wait` counts from `start`, by loop.now().
    """
    if code == "RTC_OK" and wait is None:
        return ACCEPTED
    now = await component.uncertain_if_refused(component.state_in(node, ref))
    if code not in ("RTC_OK", "RTC_ERROR") and now != transition.target:
        why = f"cannot {transition.name}: {_reason(code, before, now, transition)}"
        raise errors.Refused(str(node.path), why)
    seconds = session.current().timeout if wait is None else wait
    await _until(node, ref, transition, now, seconds, start)
    if wait is not None:
        await check_still_active(node, ref, transition, start + seconds - loop.now())
    return transition.target


async def state_as_planned(node, transition, wait):
    """The state that shows whether `change_as_planned` has been done: over all its contexts.

    Raises Unreachable where that is not known, Refused where Active does not last for a period.
    """
    contexts = await context_states(node)
    if transition is not ACTIVATE:
        leaving = _to_leave(contexts)
        _check_that_one_answers(node, leaving)
        if leaving:
            return component.merged([context.state for context in leaving])
        return transition.target
    active = _all_in(contexts, "Active")
    if not active:
        return component.merged([context.state for context in contexts])
    await check_still_active(node, active[0].ref, transition, wait)
    return "Active"


def _reason(code, before, now, transition):
    """Why a request was refused: a component that fails in its transition answers as one in a wrong state
    does.
    """
    if code == "PRECONDITION_NOT_MET" and now == "Error":
        return "it is in Error; reset it first" if before == "Error" else "it went to Error"
    if code == "PRECONDITION_NOT_MET" and now != transition.source:
        return f"it is {now}, not {transition.source}"
    return f"{code}, it is {now}"


async def check_still_active(node, ref, transition, seconds):
    """Check that a component is still Active a period of its execution context `ref` later, within `seconds`.

    Where onActivated fails, a component is Active for one period before it is in Error (all of OpenRTM-aist).
    Other states last. Raises Refused, and Unreachable where a period takes longer.
    """
    if transition is not ACTIVATE:
        return
    rate = await component.uncertain_if_refused(orb.call(node.path, ref, "get_rate"))
    start = loop.now()
    end = start + JITTER
    if rate > 0:
        end += 1 / rate
    limit = start + max(seconds, component.POLL)
    while loop.now() < end:
        if loop.now() > limit:
            why = f"Active, but not yet for a period ({1 / rate:g}s) of its execution context"
            raise errors.Late(str(node.path), why)
        await loop.sleep(max(0, min(component.POLL, end - loop.now())))
        now = await component.uncertain_if_refused(component.state_in(node, ref))
        if now != transition.target:
            raise errors.Refused(str(node.path), f"cannot {transition.name}: it went to {now}")


async def _until(node, ref, transition, now, seconds, start):
    """Poll until the state is reached, for `seconds` from `start`, at first more often:
    most need a few periods only.
    """
    limit = start + seconds
    pause = component.POLL / 10
    while now != transition.target:
        if now == "Error" and transition.source != "Error":
            raise errors.Refused(str(node.path), f"cannot {transition.name}: it went to Error")
        if not await orb.call(node.path, ref, "is_running"):
            # OpenRTM-aist 2 remembers the request
            why = "its execution context is stopped; once started, it may still do so"
            raise errors.Refused(str(node.path), f"cannot {transition.name}: {why}")
        if loop.now() > limit:
            raise errors.Late(str(node.path), f"not {transition.target} within {seconds:g}s, still {now}")
        await loop.sleep(pause)
        pause = min(2 * pause, component.POLL)
        now = await component.uncertain_if_refused(component.state_in(node, ref))
