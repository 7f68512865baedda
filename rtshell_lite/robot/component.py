"""Components: profile, execution contexts, and state (OMG RTC 1.1, 5.2).
What changes states is in `transitions`.
"""


from rtshell_lite import errors, notes
from rtshell_lite.corba import orb
from rtshell_lite.net import loop
from rtshell_lite.records import record
from rtshell_lite.text import from_wire

STATES = ("Created", "Inactive", "Active", "Error")  # RTC::LifeCycleState by number
KINDS = ("Periodic", "Event-driven", "Other")  # RTC::ExecutionKind by number
POLL = 0.2  # seconds between looks at a state: monitors that ask more often have disturbed real-time threads
# of a component; of a context or a composite; more are not taken
MOST_CONTEXTS = 64
MOST_MEMBERS = 1000

# What RTC::ComponentProfile says of a component, in the order of the IDL: its name in JSON and programs, and
# the one that people read.
FACTS = {
    "instance_name": "Instance name",
    "type_name": "Type name",
    "description": "Description",
    "version": "Version",
    "vendor": "Vendor",
    "category": "Category",
}
# RTC::ComponentProfile as text; `properties` is a list of (name, value) in the component's order.
Profile = record("Profile", " ".join(FACTS) + " parent properties")

# RTC::ExecutionContextProfile and more of its interface. `rate` in Hz, `owner` and `participants` are
# references.
Context = record("Context", "handle ref kind rate running owner participants properties")


async def until(reached, seconds):
    """Await reached() until it returns True, at first more often, for at most `seconds`;
    returns whether it did.
    """
    limit = loop.now() + seconds
    pause = POLL / 10
    while not await reached():
        if loop.now() > limit:
            return False
        await loop.sleep(pause)
        pause = min(2 * pause, POLL)
    return True


async def uncertain_if_refused(asked):
    """What `asked`, a coroutine or Call, returns after a change, which may have been made although the answer
    is refused.

    Raises Uncertain then.
    """
    try:
        return await asked
    except errors.Refused as e:
        raise errors.Uncertain(*e.args)


# ---- profile ----


async def profile(node, brief=False, names=False):
    """The Profile of a component. Ask its ports first (`ports.ports`): docs/protocol.md 1.1.

    `brief`: with the first of its properties, if it has any. `names`: without its parent and its properties,
    which come after those of all its ports.
    """
    if names:
        part = 6
    elif brief:
        part = ""
    else:
        part = None
    raw = await once_more(lambda: node.call("get_component_profile", part=part))
    parent = await once_more(lambda: orb.call(node.path, raw.parent, "get_sdo_id")) if raw.parent else ""
    texts = [from_wire(getattr(raw, name)) for name in FACTS]
    if names:
        listed = []
    else:
        listed = raw.properties[:1] if brief else raw.properties
    return Profile(*texts, from_wire(parent), orb.properties(listed))


def facts(texts):
    """[(label, text)] of those FACTS that `texts` {name: text} has, in the order of the labels."""
    return sorted((label, texts[name]) for name, label in FACTS.items() if name in texts)


async def instance_name(node, ref):
    """The instance name of the component `ref`, which `node` knows:
    Unknown if it does not answer, '' for None.
    """
    if ref is None:
        return ""
    try:
        return from_wire(await orb.call(node.path, ref, "get_sdo_id"))
    except errors.Error:
        return "Unknown"


async def once_more(call, failures=None):
    """What call() makes is awaited, a second time after a failure other than silence; that is added to
    `failures`, if given.

    A profile query makes a component check its connections, and the first one after a peer has died passes
    that peer's TRANSIENT on to the caller (C++ and Python 2.1; docs/protocol.md 1.2).
    """
    try:
        return await call()
    except (errors.Unanswered, errors.Refused):
        raise
    except errors.Unreachable as e:
        if failures is not None:
            failures.append(e)
        return await call()


# ---- execution contexts ----


async def context_refs(node):
    """References of the execution contexts that a component owns, and of those that it takes part in:
    two lists.
    """
    return await owned_context_refs(node), await participating_context_refs(node)


async def owned_context_refs(node):
    """References of the execution contexts that a component owns."""
    return await _refs(node, "get_owned_contexts")


async def participating_context_refs(node):
    """References of the execution contexts, of other components, that a component takes part in."""
    return await _refs(node, "get_participating_contexts")


async def _refs(node, operation):
    listed = notes.first(MOST_CONTEXTS, await node.call(operation), node.path, "execution contexts")
    return [orb.narrow(ref, "RTC.ExecutionContextService") for ref in listed if ref is not None]


async def context_ref(node, index):
    """The reference of the execution context number `index`: the owned ones from 0, then the participating
    ones.

    One call for an owned one, the usual case.
    """
    owned = await owned_context_refs(node)
    if -len(owned) <= index < len(owned):
        return owned[index]
    refs = owned + await participating_context_refs(node)
    if not 0 <= index < len(refs):
        raise errors.NoSuch(str(node.path), "execution context", f"{index} (it has {len(refs)})")
    return refs[index]


async def context(node, ref):
    """The Context of an execution context, complete."""
    described = await in_profile(node, ref)
    return described._replace(running=await is_running(node, ref))


async def is_running(node, ref):
    """Whether an execution context runs."""
    return await orb.call(node.path, ref, "is_running")


async def in_profile(node, ref):
    """The Context of an execution context, except for whether it runs."""
    raw = await orb.call(node.path, ref, "get_profile")
    return Context(
        handle=await node.call("get_context_handle", ref),
        ref=ref,
        kind=_by_number(KINDS, raw.kind),
        rate=raw.rate,
        running=None,
        owner=raw.owner,
        participants=notes.first(
            MOST_MEMBERS, raw.participants, node.path, "participants of an execution context"
        ),
        properties=orb.properties(raw.properties),
    )


async def running(node, ref):
    """The Context of an execution context with only its rate and whether it runs."""
    rate = await orb.call(node.path, ref, "get_rate")
    runs = await is_running(node, ref)
    return Context(None, ref, None, rate, bool(runs), None, (), ())


async def or_default(node, ref, asked, otherwise):
    """What `asked`, a coroutine, returns, or `otherwise` if `ref`, a context of another process, does not
    answer.

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


# ---- state ----


async def state(node):
    """The state of a component over all its contexts:
    Error before Active before Inactive before Created, or Unknown.
    """
    owned, participating = await context_refs(node)
    return merged(await states(node, owned + participating))


async def states(node, refs):
    """Its state in each context; Unknown in a context of another process that does not answer."""
    return [await or_default(node, ref, state_in(node, ref), "Unknown") for ref in refs]


def merged(states):
    """One state for a component from those in its contexts."""
    return next((s for s in ("Error", "Active", "Inactive", "Created") if s in states), "Unknown")


async def state_in(node, ref):
    """The state of a component in the execution context `ref` (ExecutionContext::get_component_state)."""
    now = await state_of(node, ref, node.typed)
    if now == "Created":
        reference = await canonical(node)
        if reference is not None:
            return await state_of(node, ref, reference)
    return now


async def state_of(node, ref, reference):
    """The state in the execution context `ref` of the component with this reference:
    `node`, or one that it knows.
    """
    return _by_number(STATES, await orb.call(node.path, ref, "get_component_state", reference))


async def canonical(node):
    """The reference by which its contexts know a component, None if it is the one that we have.

    Contexts do not recognise a component that is bound under a rewritten address, or reached by its key.
    """
    owned = await owned_context_refs(node)
    owner = (await orb.call(node.path, owned[0], "get_profile")).owner if owned else None
    return None if owner is None or orb.same(owner, node.ref) else owner
