"""A component at one time: the parts of it that a command wants, and what failed.

A new part is an attribute of Snapshot, and a line in PARTS with the function that asks for it.
"""


from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.robot import component, ports

# How much of a part is wanted. Ports and profile have BRIEF and FULL (see `ports.port`, `component.profile`,
# which has NAMES, too), organisations have BRIEF, without their members, and FULL; execution contexts have
# REFERENCES (no call each), BRIEF, with handles (one call), RUNNING, with rates and whether they run (two),
# PROFILE, all but whether they run (two), and FULL (three). All others have FULL.
REFERENCES = "references"
BRIEF = "brief"
RUNNING = "running"
PROFILE = "profile"
NAMES = "names"
FULL = "full"
# of ports: FULL, and those that fail are noted in `refusing`; otherwise the first failure ends the questions
EACH = "each"


class Snapshot:
    """A component, and what has been asked of it so far.

    node           its Node; `others` further Nodes by which it is bound
    asking         what it was asked for last, in words; '' before
    answered       whether it has answered anything itself; what fails later may be something that it calls
    known          names of the parts that it has answered
    error          the errors.Error that ended the questions of `ask_all`, or None

    The parts:

    ports          its ports.Ports; `refusing` (number from 1, errors.Error, endpoint) of those that failed,
                   see EACH; `dropped` those Ports that have just dropped a connection whose far end is dead;
                   `of_tools` (Port, Connector) of the connectors that are a tool's, where these were set
                   apart
    written        (Port, values that it writes a second) of the out port that was measured, or None
    stamp          (when a value came, the time in it), in s since 1970, of that port, or None
    owned          component.Contexts of its own
    participating  component.Contexts of other components that execute it, too. A context of another process
                   that does not answer has only its reference
    states         its states in `contexts`
    configuration  its configuration.Configuration, None where it has none
    organisations  composites.Organisations that it owns
    composites     (id, name, path as text) of those that it is a member of; needs `participating`
    members        {id of an Organisation: paths of its members, as text}; needs `organisations`
    names          {identity: instance name} of components that own its contexts, with FULL also of those that
                   take part; needs these
    profile        its component.Profile, None where a port has failed
    """

    asking = ""
    answered = False
    error = None
    ports = refusing = dropped = of_tools = owned = participating = states = organisations = composites = ()
    configuration = profile = written = stamp = None
    members = {}  # type: dict
    names = {}  # type: dict

    def __init__(self, node, others=()):
        self.node = node
        self.others = others
        self.known = set()

    @property
    def where(self):
        """Its path, spelt for the terminal."""
        return str(self.node.path)

    @property
    def contexts(self):
        """The contexts that it owns, then those that it takes part in: in the order in which -e counts."""
        return [*self.owned, *self.participating]

    async def ask(self, **parts):
        """Ask for the parts {name: how much}, in the order of PARTS. Raises the first errors.Error.

        States come first: they are answered at once, where ports may wait for what they are connected with.
        The profile comes right after the ports: it can end a component that has a connection with a dead far
        end, which its ports notice before (docs/protocol.md 1.1).
        """
        for name in sorted(parts, key=_ORDER.index):
            self.asking, function = PARTS[name]
            setattr(self, name, await function(self, parts[name]))
            self.answered = True
            self.known.add(name)
        return self


async def of(node, **parts):
    """The Snapshot of one component with these parts. Raises what remote calls raise."""
    return await Snapshot(node).ask(**parts)


async def ask_all(snapshots, **parts):
    """`ask` in parallel by the process that answers;
    what ended the questions becomes the `error` of a Snapshot.
    """

    answers = await session.each(
        snapshots, lambda snapshot: snapshot.ask(**parts),
        lambda snapshot: (snapshot.node.endpoint, snapshot.where),
    )
    for snapshot, answer in zip(snapshots, answers):
        snapshot.error = answer if isinstance(answer, errors.Error) else None


# ---- how each part is asked for ----


async def _ports(snapshot, how):
    refs = await ports.refs(snapshot.node)
    snapshot.answered = True
    # those from before a failure are of use
    snapshot.ports = []
    snapshot.refusing = []
    snapshot.dropped = []
    for number, ref in enumerate(refs, 1):
        snapshot.asking = f"the profile of its port {number}"
        failed_once = []  # type: list  # shows that the port had a connection with a dead far end
        try:
            port = await ports.port(snapshot.node, ref, failed_once, brief=how == BRIEF)
        except errors.Error as e:
            if how != EACH or isinstance(e, errors.Unanswered):  # its process hangs, or there is no time
                raise
            snapshot.refusing.append((number, e, orb.endpoint(ref)))
            continue
        snapshot.ports.append(port)
        snapshot.dropped += [port] * len(failed_once)
    return snapshot.ports


async def _owned(snapshot, how):
    return await _contexts(snapshot, await component.owned_context_refs(snapshot.node), how)


async def _participating(snapshot, how):
    return await _contexts(snapshot, await component.participating_context_refs(snapshot.node), how)


async def _contexts(snapshot, refs, how):
    bare = [component.Context(None, ref, None, None, None, None, (), ()) for ref in refs]
    if how == REFERENCES:
        return bare
    if how == BRIEF:
        return [
            context._replace(handle=await snapshot.node.call("get_context_handle", context.ref))
            for context in bare
        ]
    if how == FULL:
        ask = component.context
    elif how == PROFILE:
        ask = component.in_profile
    else:
        ask = component.running
    node = snapshot.node
    return [
        await component.or_default(node, context.ref, ask(node, context.ref), context) for context in bare
    ]


async def _states(snapshot, _):
    return await component.states(snapshot.node, [context.ref for context in snapshot.contexts])


async def _configuration(snapshot, _):
    # not needed, and not loaded, for a listing; nor are composites
    from rtshell_lite.robot import configuration

    try:
        return await configuration.of(snapshot.node)
    except errors.Refused:  # small implementations have none
        return None


async def _organisations(snapshot, how):
    from rtshell_lite.robot import composites

    return await composites.owned(snapshot.node, with_members=how == FULL)


async def _composites(snapshot, _):
    from rtshell_lite.robot import composites

    return await composites.belonging(snapshot.node, snapshot.participating)


async def _members(snapshot, _):
    from rtshell_lite.robot import composites

    return {
        organisation.id: await composites.member_paths(snapshot.node, organisation)
        for organisation in snapshot.organisations
    }


async def _names(snapshot, how):
    refs = {}
    for context in snapshot.contexts:
        if context.owner is not None:
            refs[orb.identity(context.owner)] = context.owner
        if how == FULL:
            for ref in context.participants:
                refs[orb.identity(ref)] = ref
    own = orb.identity(snapshot.node.ref)
    others = [identity for identity in refs if identity != own]

    async def name_of(identity):
        return await component.instance_name(snapshot.node, refs[identity])

    answers = await session.each(others, name_of, lambda identity: (identity[:2], snapshot.where))
    return {
        identity: "Unknown" if isinstance(name, errors.Error) else name
        for identity, name in zip(others, answers)
    }


async def _profile(snapshot, how):
    if snapshot.refusing:
        return None
    return await component.profile(snapshot.node, brief=how == BRIEF, names=how == NAMES)


# The parts by attribute: what is asked for in words, coroutine function(snapshot, how much).
PARTS = {
    "owned": ("its execution contexts", _owned),
    "participating": ("its execution contexts", _participating),
    "states": ("its execution contexts", _states),
    "ports": ("its ports", _ports),
    "profile": ("its profile", _profile),
    "configuration": ("its configuration", _configuration),
    "organisations": ("its members", _organisations),
    "composites": ("its composites", _composites),
    "members": ("its members", _members),
    "names": ("the names of components in its execution contexts", _names),
}
_ORDER = list(PARTS)
