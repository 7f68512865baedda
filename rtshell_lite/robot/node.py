"""The objects of the RTC Tree: what each is, by its reference, and whether it lives, by asking it."""


from rtshell_lite import errors, notes
from rtshell_lite.corba import orb, session
from rtshell_lite.net import loop
from rtshell_lite.path import Name
from rtshell_lite.text import LONGEST, from_wire

# names in one context, and octets of them all: an iterator may have no end
MOST = 50000
MOST_OCTETS = 16 << 20
PATIENCE = 3  # times the timeout, in which all names of a context have to come
DIRECTORIES = ("root", "server", "directory", "manager")
# kinds in words, where these differ
WORDS = {
    "root": "root directory",
    "server": "name server",
    "silent": "component that does not answer",
    "unasked": "component that was not asked",
}
DOUBTFUL = ("silent", "unasked")  # kinds of objects that may live, though nothing has come from them

_COMPONENTS = (
    "IDL:openrtm.aist.go.jp/OpenRTM/DataFlowComponent:1.0", "IDL:omg.org/RTC/RTObject:1.0",
    "IDL:openrtm.aist.go.jp/OpenRTM/FiniteStateMachineComponent:1.0",
)
_RTOBJECT = "IDL:omg.org/RTC/RTObject:1.0"
_MANAGER = "IDL:RTM/Manager:1.0"
_CONTEXTS = ("IDL:omg.org/CosNaming/NamingContext:1.0", "IDL:omg.org/CosNaming/NamingContextExt:1.0")


class Node:
    """One object of the tree.

    path   its Path
    kind   root, server, directory, component, manager; zombie, whose object is gone; silent, a component or
           manager that does not answer, or cannot be reached; unasked, one that was not asked, as its process
           did not answer others; unknown, any other object; unsure, one that must be asked (`check_alive`),
           as its reference does not say
    ref    its object reference; None at the root and for a nil reference
    error  for kind `silent`, `unasked` and `zombie`: the errors.Error that says why; for others: why what is
           below could not be listed
    alias  the Path of the same directory where a walk entered it before; such a Node is not entered again;
           else None
    foreign  True for a naming context of another name server than that where it is bound; see
             `aliases.within`
    """

    # there may be 20,000
    __slots__ = ("path", "kind", "ref", "error", "alias", "foreign", "_endpoint", "_is_typed", "__weakref__")

    def __init__(self, path, kind, ref=None, error=None):
        self.path = path
        self.kind = kind
        self.ref = ref
        self.error = error
        self.alias = None
        self.foreign = False
        self._endpoint = None
        self._is_typed = False

    @property
    def name(self):
        """The last name of its path, spelt for the terminal."""
        if self.path.names:
            return str(self.path.names[-1])
        return str(self.path).lstrip("/") or "/"

    @property
    def endpoint(self):
        """(host, port) of its process, None where nothing usable is bound to its name."""
        if self._endpoint is None and self.ref is not None:
            self._endpoint = orb.endpoint(self.ref)
        return self._endpoint

    @property
    def where(self):
        """What errors about it name."""
        return self.path

    @property
    def what(self):
        """Its kind in words, for errors."""
        if self.kind in ("unknown", "unsure"):
            return "nil reference" if self.ref is None else "CORBA object of unknown kind"
        return WORDS.get(self.kind, self.kind)

    @property
    def typed(self):
        """`ref` as a reference of the interface that its kind implies."""
        if not self._is_typed:
            # only this one is kept: a reference takes 800 bytes
            self.ref = self._narrowed()
            self._is_typed = True
        return self.ref

    def _narrowed(self):
        if self.kind in ("server", "directory"):
            return orb.context(self.ref)
        interface = "RTM.Manager" if self.kind == "manager" else "OpenRTM.DataFlowComponent"
        return orb.narrow(self.ref, interface)

    async def call(self, operation, *args, **more):
        """Call an operation of its object; errors name its path."""
        try:
            return await orb.call(self.path, self.typed, operation, *args, **more)
        except errors.ConnectionRefused as e:
            if self.kind in ("server", "directory"):
                raise errors.NoNameServer(*e.args)
            raise await _refusal(self)
        except errors.Gone:
            if self.kind == "server":
                raise no_name_server(self)
            raise

    def __repr__(self):
        return f"<{self.kind} {self.path}>"


def no_name_server(node):
    """The error for an object that answers at the address of a name server, but is not a name server."""
    return errors.WrongKind(str(node.path), "name server", "CORBA process of another kind")


def classified(path, ref, is_context=False):
    """The Node for a reference found under `path`, by the type in its IOR: no remote call.

    `is_context`: it is bound as a naming context. The root of another name server, bound by federation, has
    no type.
    """
    if ref is None:
        return Node(path, "unknown")
    address = orb.address(ref)
    if is_context and not address.type_id:
        kind = "directory"
    else:
        kind = kind_of(address.type_id, path.names[-1].kind)
    node = Node(path, kind, ref)
    node._endpoint = address[1:3]
    return node


def unusable(path, error):
    """The Node for a name that is bound to a reference which must not be used,
    given the Garbled that says why.
    """
    return Node(path, "silent", None, errors.Garbled(str(path), error.args[1]))


def kind_of(type_id, name_kind=""):
    """What an object is, by the type in its reference and the kind of the Name that it is bound with."""
    if type_id in _CONTEXTS:
        return "directory"
    if type_id in _COMPONENTS:
        return "component"
    if type_id == _MANAGER:
        return "manager"
    if name_kind in ("rtc", "mgr") or not type_id:
        return "unsure"
    return "unknown"


# ---- liveness ----


async def check_alive(nodes):
    """Find out which of `nodes` live, in parallel, one call each; returns new nodes in the same order.

    A component or manager that is gone becomes `zombie`, one that does not answer `silent`, one that was not
    asked `unasked`. They are asked `_non_existent`: a profile query can end a component whose connection has
    died (docs/protocol.md 1.1, 1.3).
    """
    # a manager with an error has answered, though not to every question
    objects = [
        node for node in nodes if node.kind in ("component", "manager", "unsure") and node.error is None
    ]
    answers = dict(zip(objects, await session.each(objects, _living)))
    return [await classify_answer(node, answers[node]) if node in answers else node for node in nodes]


async def classify_answer(node, answer):
    """The Node that `node` turns out to be, given what it answered:
    itself, or zombie, silent or unasked after an errors.Error.
    """
    if not isinstance(answer, errors.Error):
        return answer
    if isinstance(answer, errors.ConnectionRefused):
        answer = await _refusal(node)  # by now, others of its host may have answered
    if isinstance(answer, (errors.Gone, errors.ProcessGone)):
        return Node(node.path, "zombie", node.ref, answer)
    if isinstance(answer, errors.NotAsked):
        return Node(node.path, "unasked", node.ref, answer)
    return Node(node.path, "silent", node.ref, answer)


async def _refusal(node):
    return await orb.refusal(node.path, node.endpoint)


async def _living(node):
    await orb.is_alive(node.path, node.ref)
    if node.kind == "unsure":
        return await _sure(node)
    return node


async def _sure(node):
    """Ask an object whose reference does not say what it is; a refusal makes it unknown."""
    try:
        for kind, type_id in (("component", _RTOBJECT), ("manager", _MANAGER), ("directory", _CONTEXTS[0])):
            if await orb.call(node.path, node.ref, "_is_a", type_id):
                return Node(node.path, kind, node.ref)
    except errors.Refused:
        pass
    return Node(node.path, "unknown", node.ref)


# ---- what a naming context holds ----


def name_server_error(node, e):
    """The error for a Refused from what should be a name server or a naming context."""
    if e.name in ("BAD_OPERATION", "NO_IMPLEMENT", "INTF_REPOS"):
        return no_name_server(node)
    return e


async def bound(node):
    """The bindings of a naming context, however many there are: (Name, whether it is a naming context).

    One call for all but the largest contexts; [] for other directories. Names above MOST, those not received
    in PATIENCE, and those too long for a command line are left out, which is reported. A name that is listed
    again is the same name: an iterator that does not end may repeat itself.
    """
    if node.kind not in ("server", "directory"):
        return []
    received = too_long = 0
    entries = {}  # type: dict  # of names that may come again and again, each is kept once
    async for bindings in _batches(node):
        for binding in [binding for binding in bindings if binding.binding_name]:
            name = binding.binding_name[0]
            received = received + 1
            if len(name.id) + len(name.kind) >= LONGEST:
                too_long += 1
                continue
            # 1: ncontext
            entries[Name(from_wire(name.id), from_wire(name.kind)), binding.binding_type._v == 1] = None
    if too_long:
        notes.left_out(
            f"{node.path}: {too_long} of {received} names are left out: they are longer than {LONGEST} "
            "characters"
        )
    return list(entries)


async def _batches(node, size=10000):
    """The bindings of a naming context in lists, MOST of them at most, and few more than MOST_OCTETS."""
    try:
        bindings, iterator = await node.call("list", size)
    except errors.Refused as e:
        raise name_server_error(node, e)
    yield bindings[:MOST]
    if iterator is None:
        return
    received = len(bindings)
    octets = 0
    more = True
    end = loop.now() + PATIENCE * session.current().timeout
    try:
        while more and received < MOST and octets < MOST_OCTETS and loop.now() < end:
            more, bindings = await orb.call(str(node.path), iterator, "next_n", size)
            yield bindings[: MOST - received]
            received += len(bindings)
            octets += sum(
                len(name.id) + len(name.kind) for binding in bindings for name in binding.binding_name
            )
    finally:
        await orb.call(str(node.path), iterator, "destroy")
    if more:
        notes.left_out(
            f"{node.path}: only its first {min(received, MOST)} names are taken; its list of them does not "
            "end"
        )
