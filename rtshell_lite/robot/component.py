"""Components: profile, execution contexts, state, and the transitions between states (OMG RTC 1.1, 5.2)."""
import collections
import time

from rtshell_lite import errors
from rtshell_lite.corba import lanes, orb, tasks
from rtshell_lite.robot import tree
from rtshell_lite.text import from_wire, printable, shell_word

STATES = ("Created", "Inactive", "Active", "Error")  # RTC::LifeCycleState by number
KINDS = ("Periodic", "Event-driven", "Other")  # RTC::ExecutionKind by number
POLL = 0.2  # seconds between looks at a state: monitors that ask more often have disturbed real-time threads
JITTER = 0.03  # seconds that a cycle of an execution context may come late

# What a transition is called, the operation that asks for it, the state it leads to, the state it starts from.
Transition = collections.namedtuple("Transition", "name command operation target source")
ACTIVATE = Transition("activate", "rtact", "activate_component", "Active", "Inactive")
DEACTIVATE = Transition("deactivate", "rtdeact", "deactivate_component", "Inactive", "Active")
RESET = Transition("reset", "rtreset", "reset_component", "Inactive", "Error")

# A component in one of its execution contexts: the number of the context as -e counts, its reference, whether it is the
# component's own, and the component's state there.
Placement = collections.namedtuple("Placement", "index ref is_own state")

# RTC::ComponentProfile as text; `properties` is a list of (name, value) in the component's order.
Profile = collections.namedtuple("Profile", "instance_name type_name description version vendor category parent properties")

# RTC::ExecutionContextProfile and more of its interface. `rate` in Hz, `owner` and `participants` are references.
Context = collections.namedtuple("Context", "handle ref kind rate running owner participants properties")


def until(reached, seconds):
    """Call reached() until it returns True, at first more often, for at most `seconds`; returns whether it did."""
    limit, pause = time.monotonic() + seconds, POLL / 10
    while not reached():
        if time.monotonic() > limit:
            return False
        time.sleep(pause)
        pause = min(2 * pause, POLL)
    return True


# ---- profile --------------------------------------------------------------------------------------------------

@tasks.task
async def profile(node, brief=False):
    """The Profile of a component. Ask its ports first (`ports.ports`): protocol rule, see `once_more`.

    `brief`: with one of its properties, which shows that there are any.
    """
    raw = await once_more.task(lambda: node.ask("get_component_profile"))
    parent = await once_more.task(lambda: orb.Call(node.path, raw.parent, "get_sdo_id")) if raw.parent else ""
    texts = [from_wire(s) for s in (raw.instance_name, raw.type_name, raw.description, raw.version, raw.vendor,
                                    raw.category, parent)]
    return Profile._make(texts + [orb.properties(raw.properties[:1] if brief else raw.properties)])


def instance_name(node, ref):
    """The instance name of the component `ref`, which `node` knows: Unknown if it does not answer, '' for None."""
    if ref is None:
        return ""
    try:
        return from_wire(orb.call(node.path, ref, "get_sdo_id"))
    except errors.Error:
        return "Unknown"


@tasks.task
async def once_more(call, failures=None):
    """What call() makes is awaited, a second time after a failure other than silence; that is added to `failures`, if given.

    A profile query makes a component check its connections, and the first one after a peer has died passes that peer's
    TRANSIENT on to the caller (C++ and Python 2.1).
    """
    try:
        return await call()
    except (errors.Silent, errors.Refused):
        raise
    except errors.Unreachable as e:
        if failures is not None:
            failures.append(e)
        return await call()


# ---- execution contexts ---------------------------------------------------------------------------------------

def context_refs(node):
    """References of the execution contexts that a component owns, and of those that it takes part in: two lists."""
    return owned_context_refs(node), participating_context_refs(node)


@tasks.task
async def owned_context_refs(node):
    """References of the execution contexts that a component owns."""
    return await _refs(node, "get_owned_contexts")


@tasks.task
async def participating_context_refs(node):
    """References of the execution contexts, of other components, that a component takes part in."""
    return await _refs(node, "get_participating_contexts")


async def _refs(node, operation):
    return [orb.narrow(ref, "RTC.ExecutionContextService") for ref in await node.ask(operation) if ref is not None]


@tasks.task
async def context_ref(node, index):
    """The reference of the execution context number `index`: the owned ones from 0, then the participating ones.

    One call for an owned one, the usual case.
    """
    owned = await owned_context_refs.task(node)
    if -len(owned) <= index < len(owned):
        return owned[index]
    refs = owned + await participating_context_refs.task(node)
    if not 0 <= index < len(refs):
        raise errors.NoSuch(str(node.path), "execution context", f"{index} (it has {len(refs)})")
    return refs[index]


@tasks.task
async def context(node, ref):
    """The Context of an execution context, complete."""
    raw = await orb.Call(node.path, ref, "get_profile")
    return Context(handle=await node.ask("get_context_handle", ref), ref=ref, kind=_by_number(KINDS, raw.kind), rate=raw.rate,
                   running=await orb.Call(node.path, ref, "is_running"), owner=raw.owner, participants=raw.participants,
                   properties=orb.properties(raw.properties))


@tasks.task
async def running(node, ref):
    """The Context of an execution context with only its rate and whether it runs."""
    rate, runs = await orb.Call(node.path, ref, "get_rate"), await orb.Call(node.path, ref, "is_running")
    return Context(None, ref, None, rate, bool(runs), None, (), ())


@tasks.task
async def elsewhere(node, ref, asked, otherwise):
    """What `asked`, a coroutine, returns, or `otherwise` if `ref`, a context of another process, does not answer, or has ended.

    So a hung composite does not hide its members.
    """
    try:
        return await asked
    except errors.Gone:
        return otherwise
    except errors.Unreachable:
        if orb.endpoint(ref) == node.endpoint:
            raise
        return otherwise


def _by_number(names, enumerator):
    return names[enumerator._v] if enumerator._v < len(names) else "Unknown"


# ---- state ----------------------------------------------------------------------------------------------------

def state(node):
    """The state of a component over all its contexts: Error before Active before Inactive before Created, or Unknown."""
    owned, participating = context_refs(node)
    return merged(states(node, owned + participating))


@tasks.task
async def states(node, refs):
    """Its state in each context; Unknown in a context of another process that does not answer."""
    return [await elsewhere.task(node, ref, state_in.task(node, ref), "Unknown") for ref in refs]


def merged(states):
    """One state for a component from those in its contexts."""
    return next((s for s in ("Error", "Active", "Inactive", "Created") if s in states), "Unknown")


@tasks.task
async def state_in(node, ref):
    """The state of a component in the execution context `ref` (ExecutionContext::get_component_state)."""
    now = _by_number(STATES, await orb.Call(node.path, ref, "get_component_state", node.typed))
    if now == "Created":
        known = await canonical.task(node)
        if known is not None:
            return _by_number(STATES, await orb.Call(node.path, ref, "get_component_state", known))
    return now


@tasks.task
async def canonical(node):
    """The reference by which its contexts know a component, None if it is the one that we have.

    Contexts do not recognise a component that is bound under a rewritten address, or reached by its key.
    """
    owned = await owned_context_refs.task(node)
    owner = (await orb.Call(node.path, owned[0], "get_profile")).owner if owned else None
    return None if owner is None or orb.same(owner, node.ref) else owner


# ---- transitions ----------------------------------------------------------------------------------------------

def change_all(paths, transition, index=None, wait=None, dry_run=False):
    """`change` for the component at each path, in parallel: a line that says what was done, or an errors.Error, for each.

    If one is something else than a component, none is changed, and only the WrongKinds are returned.
    With `dry_run` nothing changes, and the line is the command that would change the component, '' where none is needed.
    """
    @tasks.task
    async def change_one(node):
        if dry_run:
            return await _command(node, transition, index)
        now = await change.task(node, transition, index, wait)
        return f"{node.path}: {now}"
    orb.start()
    nodes = tree.at_each(paths, tree.component)
    return [node for node in nodes if isinstance(node, errors.WrongKind)] or tree.on_nodes(nodes, change_one)


async def _command(node, transition, index):
    """The command that would take a component through a Transition, '' where none is needed."""
    if index is not None:
        now = await state_in.task(node, await context_ref.task(node, index))
        return "" if now == transition.target else _words(transition, index, node)
    places = await placements(node)
    if transition is ACTIVATE:
        place = await _to_activate(node, places)
        return "" if place.state == "Active" else _words(transition, place.index or None, node)
    wanted = _to_leave(places)
    _check_that_one_answers(node, wanted)
    return _words(transition, None, node) if wanted else ""


def _words(transition, index, node):
    option = [] if index is None else ["-e", str(index)]
    return " ".join([transition.command] + option + [shell_word(str(node.path))])


async def placements(node):
    """A Placement for each execution context of a component, as -e counts them, but not for those that are known to have ended.

    The state is Unknown in a context of another process that does not answer: the component may be Active there. Raises NoSuch if
    it has no context.
    """
    owned, participating = await owned_context_refs.task(node), await participating_context_refs.task(node)
    found = []
    for index, ref in enumerate(owned + participating):
        try:
            state = await state_in.task(node, ref)
        except errors.Gone:
            continue
        except errors.Unreachable as e:
            if orb.endpoint(ref) == node.endpoint:
                raise
            if _proves_death(e, ref):
                continue
            state = "Unknown"
        found.append(Placement(index, ref, index < len(owned), state))
    if not found:
        raise errors.NoSuch(str(node.path), "execution context", "0 (it has 0)")
    return found


def _proves_death(failure, ref):
    """Whether the failure of a call of the context `ref` proves that its process is gone: nothing is executed there."""
    if not isinstance(failure, errors.ConnectionRefused):
        return False
    from rtshell_lite.corba import liveness  # few need it
    return liveness.is_gone(orb.endpoint(ref))


async def _members_first(node, ref, wait):
    """Deactivate the members of a composite of C++ 1.1 before it: the thread that deactivates it would wait for them in vain."""
    if not orb.address(ref).type_id.endswith("/ExtTrigExecutionContextService:1.0"):
        return
    raw = await orb.Call(node.path, ref, "get_profile")
    if not orb.same(raw.owner, node.ref) or not raw.participants or not await node.ask("get_owned_organizations"):
        return
    for member in raw.participants:
        if _by_number(STATES, await orb.Call(node.path, ref, "get_component_state", member)) == "Active":
            await orb.Call(node.path, ref, "deactivate_component", member, seconds=wait)


@tasks.task
async def change(node, transition, index=None, wait=None):
    """Take a component through a Transition; returns the state reached or asked for, and where that is not its own first context.

    `index` is the number of the execution context. Without it, a component becomes Inactive in all contexts in which it is not yet,
    and Active in one: see `_activate`.

    `wait` (seconds) polls until the state is reached, and Active still there a period later. Contexts of 1.1 answer before the
    state has changed, later ones answer RTC_ERROR when it takes longer than their own limit of 0.5 s but change it nevertheless:
    so after RTC_ERROR the state is polled for the timeout. Raises Refused with the reason, Unreachable when it was not reached.
    """
    if index is not None:
        await _change_in(node, await context_ref.task(node, index), transition, wait, _number(index))
        return transition.target
    places = await placements(node)
    if transition is not ACTIVATE:
        await _leave(node, places, transition, wait)
        return transition.target
    place = await _activate(node, places, wait)
    already = "already " if place.state == "Active" and place.index else ""
    silent = _all_in(places, "Unknown")
    return already + await _where(node, place) + (f"; {_silence(silent[0])}" if silent else "")


def _number(index):
    return f"its execution context {index}"


def _all_in(places, state):
    return [place for place in places if place.state == state]


def _to_leave(places):
    """The Placements in which a component has to become Inactive. A context that does not know it (Created) is asked only if none does."""
    known = [place for place in places if place.state != "Created"] or places[:1]
    return [place for place in known if place.state != "Inactive"]


def _check_that_one_answers(node, places):
    """Raise Unreachable if nothing can be done, as none of the contexts of these Placements answers."""
    if places and all(place.state == "Unknown" for place in places):
        raise errors.Unreachable(str(node.path), _silence(places[0]))


def _silence(place):
    return f"{_number(place.index)}, of another component, does not answer: it may be Active there"


def _ignore(stage):
    """In the place of a function that notes how far a change has come."""


async def _leave(node, places, transition, wait, stage=_ignore):
    """Make a component Inactive in all Placements in which it is not: whether there was one. Raises the first failure, at the end.

    All contexts are asked before one is waited for: where a component stops slowly, or never, it stops elsewhere all the same.
    """
    wanted, asked, failures, start = _to_leave(places), [], [], time.monotonic()
    for place in wanted:
        try:
            _check_that_one_answers(node, [place])
            asked.append((place, await _request(node, place.ref, transition, wait, _number(place.index), stage)))
        except errors.Error as e:
            failures.append(e)
    for place, code in asked:
        try:
            await _reach(node, place.ref, transition, code, place.state, wait, start)
        except errors.Error as e:
            failures.append(e)
    if failures:
        raise failures[0]
    return bool(wanted)


async def _activate(node, places, wait, stage=_ignore):
    """Make a component Active in one of its Placements, and return that: its state there is Active if it was so before.

    Robots of hrpsys and rtcloader run many components in the context of one. A component that is Active in two contexts is
    executed by both, at the same time; so one that is Active anywhere stays as it is.
    """
    place = await _to_activate(node, places)
    await _change_in(node, place.ref, ACTIVATE, wait, _number(place.index), place.state, stage)
    return place


async def _to_activate(node, places):
    """The Placement in which a component is Active, or in Error, or is to become Active: the first one whose context runs.

    Raises Unreachable where none is known to run, and the component may be Active in one that does not answer.
    """
    settled = _all_in(places, "Active") or _all_in(places, "Error")
    if settled or len(places) == 1:
        return (settled or places)[0]
    known = [place for place in places if place.state != "Unknown"]
    for place in known:
        if await elsewhere.task(node, place.ref, orb.Call(node.path, place.ref, "is_running"), False):
            return place
    _check_that_one_answers(node, _all_in(places, "Unknown"))
    return places[0]


async def _where(node, place):
    """Active, and in which context, if that is not the first of its own."""
    if place.index == 0:
        return "Active"
    if place.is_own:
        return f"Active in {_number(place.index)}"
    profile = await elsewhere.task(node, place.ref, orb.Call(node.path, place.ref, "get_profile"), None)
    owner = "another component" if profile is None or profile.owner is None else await _name(node, profile.owner)
    return f"Active in the context of {owner}"


async def _name(node, ref):
    """The instance name of another component, printable."""
    try:
        return printable(from_wire(await orb.Call(node.path, ref, "get_sdo_id")))
    except errors.Error:
        return "another component"


@tasks.task
async def change_as_planned(node, transition, index, wait, stage):
    """`change` for a plan that names the execution context number `index`: whether there was something to do.

    A component that is Active in the context of another component is not made Active in its own, nor the other way round; if the
    one that the plan names is stopped, such another one that runs is meant. It becomes Inactive in all contexts.

    If the component has to change, stage("asking") is called before it is asked, and stage("told") when it has accepted.
    """
    places = await placements(node)
    if transition is not ACTIVATE:
        return await _leave(node, places, transition, wait, stage)
    named = [place for place in places if place.index == index]
    if not named:
        raise errors.NoSuch(str(node.path), "execution context", f"{index}: it has ended")
    others = [place for place in places if place.is_own != named[0].is_own]
    place = await _activate(node, named + others, wait, stage)
    return place.state != "Active"


async def _change_in(node, ref, transition, wait, called, before=None, stage=_ignore):
    """`change` in one execution context, which messages call so; `before` is the state there, if that has just been asked."""
    before = before or await state_in.task(node, ref)
    if before != transition.target:
        code = await _request(node, ref, transition, wait, called, stage)
        await _reach(node, ref, transition, code, before, wait, time.monotonic())
    elif wait is not None:
        await stay.task(node, ref, transition, wait)


async def _request(node, ref, transition, wait, called, stage):
    """Ask the context `ref` for a Transition: its return code as text."""
    stage("asking")
    if transition is DEACTIVATE:
        await _members_first(node, ref, wait)
    # C++ 1.1 answers a deactivation only after 10 periods, 10 s at 1 Hz: `wait` is for the answer, too
    code = await orb.Call(node.path, ref, transition.operation, node.typed, seconds=wait)
    if str(code) == "BAD_PARAMETER":
        known = await canonical.task(node)
        if known is None:
            raise errors.Refused(str(node.path), "is not in " + called)
        code = await orb.Call(node.path, ref, transition.operation, known, seconds=wait)
    if str(code) == "RTC_OK":
        stage("told")
    return str(code)


async def _reach(node, ref, transition, code, before, wait, start):
    """See that a Transition from the state `before`, answered with `code`, is made; without `wait`, RTC_OK is enough.

    `wait` counts from `start`, by time.monotonic().
    """
    if code == "RTC_OK" and wait is None:
        return
    now = await seen.task(state_in.task(node, ref))
    if code not in ("RTC_OK", "RTC_ERROR") and now != transition.target:
        raise errors.Refused(str(node.path), f"cannot {transition.name}: {_reason(code, before, now, transition)}")
    seconds = lanes.session.timeout if wait is None else wait
    await _until(node, ref, transition, now, seconds, start)
    if wait is not None:
        await stay.task(node, ref, transition, start + seconds - time.monotonic())


@tasks.task
async def state_as_planned(node, transition, wait):
    """The state that shows whether `change_as_planned` has been done: over all its contexts.

    Raises Unreachable where that is not known, Refused where Active does not last for a period.
    """
    places = await placements(node)
    if transition is not ACTIVATE:
        wanted = _to_leave(places)
        _check_that_one_answers(node, wanted)
        return merged([place.state for place in wanted]) if wanted else transition.target
    active = _all_in(places, "Active")
    if not active:
        return merged([place.state for place in places])
    await stay.task(node, active[0].ref, transition, wait)
    return "Active"


@tasks.task
async def seen(asked):
    """What `asked`, a coroutine or Call, returns after a change, which may have been made although the answer is refused.

    Raises Uncertain then.
    """
    try:
        return await asked
    except errors.Refused as e:
        raise errors.Uncertain(*e.args)


def _reason(code, before, now, transition):
    """Why a request was refused: a component that fails in its transition answers as one in a wrong state does."""
    if code == "PRECONDITION_NOT_MET" and now == "Error":
        return "it is in Error; reset it first" if before == "Error" else "it went to Error"
    if code == "PRECONDITION_NOT_MET" and now != transition.source:
        return f"it is {now}, not {transition.source}"
    return f"{code}, it is {now}"


@tasks.task
async def stay(node, ref, transition, seconds):
    """Check that a component is still Active a period of its execution context `ref` later, within so many seconds.

    Where onActivated fails, a component is Active for one period before it is in Error (all of OpenRTM-aist). Other states
    last. Raises Refused, and Unreachable where a period takes longer.
    """
    if transition is not ACTIVATE:
        return
    rate, start = await seen.task(orb.Call(node.path, ref, "get_rate")), time.monotonic()
    end = start + (1 / rate if rate > 0 else 0) + JITTER
    limit = start + max(seconds, POLL)
    while time.monotonic() < end:
        if time.monotonic() > limit:
            raise errors.Late(str(node.path), f"Active, but not yet for a period ({1 / rate:g}s) of its execution context")
        await tasks.Sleep(max(0, min(POLL, end - time.monotonic())))
        now = await seen.task(state_in.task(node, ref))
        if now != transition.target:
            raise errors.Refused(str(node.path), f"cannot {transition.name}: it went to {now}")


async def _until(node, ref, transition, now, seconds, start):
    """Poll until the state is reached, for `seconds` from `start`, at first more often: most need a few periods only."""
    limit, pause = start + seconds, POLL / 10
    while now != transition.target:
        if now == "Error" and transition.source != "Error":
            raise errors.Refused(str(node.path), f"cannot {transition.name}: it went to Error")
        if not await orb.Call(node.path, ref, "is_running"):
            why = "its execution context is stopped; once started, it may still do so"  # OpenRTM-aist 2 remembers the request
            raise errors.Refused(str(node.path), f"cannot {transition.name}: {why}")
        if time.monotonic() > limit:
            raise errors.Late(str(node.path), f"not {transition.target} within {seconds:g}s, still {now}")
        await tasks.Sleep(pause)
        pause = min(2 * pause, POLL)
        now = await seen.task(state_in.task(node, ref))
