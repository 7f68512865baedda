"""Components: profile, execution contexts, state, and the transitions between states (OMG RTC 1.1, 5.2)."""
import collections
import time

from rtshell_lite import errors
from rtshell_lite.corba import lanes, orb, tasks
from rtshell_lite.robot import tree
from rtshell_lite.text import from_wire, shell_word

STATES = ("Created", "Inactive", "Active", "Error")  # RTC::LifeCycleState by number
KINDS = ("Periodic", "Event-driven", "Other")  # RTC::ExecutionKind by number
POLL = 0.2  # seconds between looks at a state: monitors that ask more often have disturbed real-time threads
JITTER = 0.03  # seconds that a cycle of an execution context may come late

# What a transition is called, the operation that asks for it, the state it leads to, the state it starts from.
Transition = collections.namedtuple("Transition", "name command operation target source")
ACTIVATE = Transition("activate", "rtact", "activate_component", "Active", "Inactive")
DEACTIVATE = Transition("deactivate", "rtdeact", "deactivate_component", "Inactive", "Active")
RESET = Transition("reset", "rtreset", "reset_component", "Inactive", "Error")

# RTC::ComponentProfile as text; `properties` is a list of (name, value) in the component's order.
Profile = collections.namedtuple("Profile", "instance_name type_name description version vendor category parent properties")

# RTC::ExecutionContextProfile and more of its interface. `rate` in Hz, `owner` and `participants` are references.
Context = collections.namedtuple("Context", "handle ref kind rate running owner participants properties")


def until(reached, seconds):
    """Call reached() until it returns True, for at most so many seconds; returns whether it did."""
    limit = time.monotonic() + seconds
    while not reached():
        if time.monotonic() > limit:
            return False
        time.sleep(POLL)
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
    """What `asked`, a coroutine, returns, or `otherwise` if `ref`, a context of another process, does not answer.

    So a hung composite does not hide its members.
    """
    try:
        return await asked
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

def change_all(paths, transition, index=0, wait=None, dry_run=False):
    """`change` for the component at each path, in parallel: a line that says what was done, or an errors.Error, for each.

    If one is something else than a component, none is changed, and only the WrongKinds are returned.
    With `dry_run` nothing changes, and the line is the command that would change the component, '' where none is needed.
    """
    @tasks.task
    async def change_one(node):
        if dry_run:
            now = await state_in.task(node, await context_ref.task(node, index))
            words = [transition.command] + ["-e", str(index)] * bool(index) + [shell_word(str(node.path))]
            return "" if now == transition.target else " ".join(words)
        now = await change.task(node, transition, index, wait)
        return f"{node.path}: {now}"
    orb.start()
    nodes = tree.at_each(paths, tree.component)
    return [node for node in nodes if isinstance(node, errors.WrongKind)] or tree.on_nodes(nodes, change_one)


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
async def change(node, transition, index=0, wait=None):
    """Take a component through a Transition in its execution context number `index`; returns the state reached or asked for.

    `wait` (seconds) polls until the state is reached, and Active still there a period later. Contexts of 1.1 answer before the
    state has changed, later ones answer RTC_ERROR when it takes longer than their own limit of 0.5 s but change it nevertheless:
    so after RTC_ERROR the state is polled for the timeout. Raises Refused with the reason, Unreachable when it was not reached.
    """
    await change_in.task(node, await context_ref.task(node, index), transition, wait, f"its execution context {index}")
    return transition.target


@tasks.task
async def change_in(node, ref, transition, wait=None, called="this execution context", stage=lambda name: None):
    """`change` in the execution context `ref`; returns the state that the component was in before.

    `called` is the context in messages. If the component has to change, stage("asking") is called before it is asked, and
    stage("told") when it has accepted.
    """
    before = await state_in.task(node, ref)
    if before == transition.target:
        if wait is not None:
            await stay.task(node, ref, transition, wait)
        return before
    stage("asking")
    if transition is DEACTIVATE:
        await _members_first(node, ref, wait)
    code = await _request(node, ref, transition, node.typed, wait)
    if code == "BAD_PARAMETER":
        known = await canonical.task(node)
        if known is None:
            raise errors.Refused(str(node.path), "is not in " + called)
        code = await _request(node, ref, transition, known, wait)
    if code == "RTC_OK":
        stage("told")
    if code == "RTC_OK" and wait is None:
        return before
    now = await seen.task(state_in.task(node, ref))
    if code not in ("RTC_OK", "RTC_ERROR") and now != transition.target:
        raise errors.Refused(str(node.path), f"cannot {transition.name}: {_reason(code, before, now, transition)}")
    seconds, start = lanes.session.timeout if wait is None else wait, time.monotonic()
    await _until(node, ref, transition, now, seconds)
    if wait is not None:
        await stay.task(node, ref, transition, start + seconds - time.monotonic())
    return before


@tasks.task
async def seen(asked):
    """What `asked`, a coroutine or Call, returns after a change, which may have been made although the answer is refused.

    Raises Uncertain then.
    """
    try:
        return await asked
    except errors.Refused as e:
        raise errors.Uncertain(*e.args)


async def _request(node, ref, transition, target, wait):
    # C++ 1.1 answers a deactivation only after 10 periods, 10 s at 1 Hz: `wait` is for the answer, too
    return str(await orb.Call(node.path, ref, transition.operation, target, seconds=wait))


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


async def _until(node, ref, transition, now, seconds):
    """Poll until the state is reached, at first more often: most components need a few periods only."""
    limit, pause = time.monotonic() + seconds, POLL / 10
    while now != transition.target:
        if now == "Error" and transition.source != "Error":
            raise errors.Refused(str(node.path), f"cannot {transition.name}: it went to Error")
        if not await orb.Call(node.path, ref, "is_running"):
            others = "; the component takes part in others, named with -e (see rtec)" if await participating_context_refs.task(node) else ""
            why = f"its execution context is stopped; once started, it may still do so{others}"  # OpenRTM-aist 2 remembers the request
            raise errors.Refused(str(node.path), f"cannot {transition.name}: {why}")
        if time.monotonic() > limit:
            raise errors.Late(str(node.path), f"not {transition.target} within {seconds:g}s, still {now}")
        await tasks.Sleep(pause)
        pause = min(2 * pause, POLL)
        now = await seen.task(state_in.task(node, ref))
