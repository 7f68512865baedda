"""The one door to an ORB: references, calls with a deadline, failures as errors, lists of properties.

RTSHELL_ORB chooses the ORB behind it: builtin (iiop/) or omniorb (omniorb.py). Unset: our own, but for what
only omniORB can do.
"""

import os
from _functools import partial  # as in net/loop.py
import types  # noqa: F401  in a type comment

from rtshell_lite import errors
from rtshell_lite.corba import failures, session
from rtshell_lite.giop import idl, ior
from rtshell_lite.net import loop
from rtshell_lite.path import DEFAULT_PORT, PROTOCOLS, REFERENCES, SCHEMES, split_address
from rtshell_lite.text import printable, to_wire

_orb = None  # type: types.ModuleType  # the module of the ORB, omniorb or iiop.client


def start():
    """Start the ORB of this process, if it has not been.

    Raises Usage (bad RTCTREE_ORB_ARGS, RTSHELL_ORB), MissingOmniORB where the user has chosen that,
    OnlyOmniORB where only omniORB can do what is asked, and is not installed.
    """
    global _orb
    if _orb is None:
        _orb = _chosen()
    _orb.start()


def _chosen():
    name = os.environ.get("RTSHELL_ORB", "")
    if name not in ("", "omniorb", "builtin"):
        raise errors.Usage(f"RTSHELL_ORB: {printable(name)}: neither omniorb nor builtin")
    from rtshell_lite.corba.iiop import client

    needs_it = "" if name else _setting_unknown_to(client)
    if name != "omniorb" and not needs_it:
        return client
    from rtshell_lite.corba import omniorb

    if needs_it and not omniorb.is_installed():
        raise errors.OnlyOmniORB(needs_it)
    return omniorb


def _setting_unknown_to(client):
    """The first setting in RTCTREE_ORB_ARGS that our own ORB does not obey; '' if it obeys all."""
    words = [word for word in os.environ.get("RTCTREE_ORB_ARGS", "").split(";") if word]
    heeded = ["-ORB" + option for option in client.HEEDED]
    unknown = [word for word in words[::2] if word not in heeded]
    return "RTCTREE_ORB_ARGS: " + printable(unknown[0]) if unknown else ""


def version():
    """The name and version of the ORB. Raises MissingOmniORB, Usage (bad RTSHELL_ORB)."""
    return (_orb or _chosen()).version()


def obeys(option):
    """Whether the ORB, if there is one, obeys a setting of omniORB, by its name without ORB:
    clientTransportRule.
    """
    return not _orb or _orb.HEEDED is None or option in _orb.HEEDED


def answers_at_once():
    """Whether a servant's answer is sent before anything else happens;
    with omniORB a thread sends it a moment later.
    """
    return (_orb or _chosen()).ANSWERS_AT_ONCE


# ---- references ----


def corbaloc(where, address, key, default_port):
    """The reference of the object `key` at `address` (host, host:port, iiop:rest); contacts nobody. Raises
    BadPath for other protocols.
    """
    protocol, _, rest = address.partition(":")
    if address.startswith(SCHEMES) or protocol in PROTOCOLS and protocol != "iiop":
        raise errors.BadPath(where, "these commands speak IIOP with TCP only")
    if protocol == "iiop":
        address = rest
    host, port = split_address(address)
    if ":" not in address:
        port = default_port
    start()
    # without 1.2@ omniORB speaks GIOP 1.0, which loses code sets and big replies
    return _orb.from_url(where, "corbaloc:iiop:1.2@%s:%d/%s" % (host, port, key))


def from_text(where, text):
    """The reference in a stringified IOR that a peer has sent.
    Raises Unreachable where the text is no reference.
    """
    start()
    return _orb.from_text(where, text)


def narrow(ref, interface):
    """`ref` as a reference of an interface (RTC.PortService), on trust: no remote call."""
    return _orb.narrow(ref, interface)


def context(ref):
    """`ref` as a CosNaming::NamingContext, on trust."""
    return _orb.narrow(ref, "CosNaming.NamingContext")


def naming_name(names):
    """A CosNaming::Name for an iterable of (id, kind) texts."""
    component = struct("CosNaming.NameComponent")
    return [component(to_wire(name), to_wire(kind)) for name, kind in names]


def same(ref, other):
    """True if two references denote one object, as far as can be known without a remote call."""
    return ref is not None and other is not None and _orb.same(ref, other)


def one_of(ref, kept):
    """`kept` if it denotes the same object as `ref`, else `ref`: keeping both takes 800 bytes more."""
    return kept if same(ref, kept) else ref


def address(ref):
    """What the IOR of `ref` says, an ior.Address; without an IIOP profile, host is '' and port 0."""
    return _orb.address(ref)


def addresses(ref):
    """Every (host, port) that the IOR of `ref` offers, in its order:
    IIOP profiles and the alternatives named in them.
    """
    return ior.addresses(_orb.to_text(ref))


def endpoint(ref):
    """(host, port) of the process that answers for `ref`."""
    return _orb.address(ref)[1:3]


def at_address(ref):
    """HOST:PORT of the process that answers for `ref`, printable."""
    host, port = endpoint(ref)
    return "%s:%d" % (printable(host), port)


def identity(ref):
    """A hashable that is equal for references to one object: (host, port, object key)."""
    return address(ref)[1:]


def reference_at(ref, host, port):
    """A reference to the object with the key of `ref` in the process at another endpoint; contacts nobody."""
    return _orb.from_url(host, _corbaloc(host, port, address(ref).key))


def as_corbaloc(ref):
    """The address and key of a reference, as corbaloc:iiop:HOST:PORT/KEY."""
    host, port, key = identity(ref)
    return _corbaloc(host, port, key).replace("1.2@", "")


def _corbaloc(host, port, key):
    if ":" in host:
        host = f"[{host}]"
    octets = "".join(chr(octet) if octet < 128 and chr(octet).isalnum() else f"%{octet:02x}" for octet in key)
    return "corbaloc:iiop:1.2@%s:%d/%s" % (printable(host), port, octets)


# ---- calls ----


class Call:
    """A call of `operation` of `ref`; `where`, a Path or text, names the object in errors,
    `seconds` may be a longer deadline, `part` what of its result is needed. Its `endpoint` is that of the
    process that is asked.
    """

    __slots__ = ("where", "ref", "operation", "args", "seconds", "part", "endpoint")

    def __init__(self, where, ref, operation, args, seconds, part=None):
        self.where = where
        self.ref = ref
        self.operation = operation
        self.args = args
        self.seconds = seconds
        self.part = part
        self.endpoint = _orb.address(ref)[1:3]


async def call(where, ref, operation, *args, seconds=None, part=None):
    """The result of `operation` of `ref`; `where`, a Path or text, names the object in errors.

    `operation` is the name of one of the IDL, or an operations.Schema, which is asked once, whatever happens.
    `seconds` is a longer deadline for an operation that may take its time; of a Schema it is the deadline.
    `part`: what is needed of the structure that it returns: a number N, its first N members (the
    others may be None); a name, the property of that name in the list that is its last member (the others
    may be left out); "", the first property in that list.
    Raises Silent, NotAsked, Gone, Unreachable or Refused; made with a nil reference, Garbled: a peer has
    sent that in place of an object.

    In a task that asks one process, see session.each, the silence of another is raised as Unreachable: it
    says nothing about the first.
    """
    if ref is None:
        raise errors.Garbled(str(where), f"nothing in place of the object that has {operation}")
    asked = Call(where, ref, operation, args, seconds, part)
    here = loop.current()
    now = here.session or session.current()
    endpoint = here.running.place
    is_elsewhere = endpoint is not None and asked.endpoint != endpoint
    try:
        if now.silent or now.stalled or now.end is not None:  # seldom
            asks_others = failures.asks_others(operation)
            # a task that asks this process may look what has become of a call that was not answered
            insists = asked.endpoint == endpoint
            failure = now.why_not_asked(where, asked.endpoint, asks_others, insists=insists)
            if failure:
                raise failure
        if now.slots is None:
            return await _orb.invoke(asked)
        async with now.slots:
            return await _orb.invoke(asked)
    except errors.Unanswered as e:
        if is_elsewhere and not isinstance(e, errors.NoTime):
            raise errors.Unreachable(str(where), e.why)
        raise


def repeated(where, ref, schema, *args, seconds=None):
    """A coroutine function that calls an operation of a Schema again each time, see `call`."""
    call_again = partial(call, where, ref, schema, *args, seconds=seconds)
    if ref is None or session.current().slots is not None:
        return call_again
    return _orb.repeated(Call(where, ref, schema, args, seconds), call_again)


def at_object(ref):
    """Whom a reference leads to, for session.each."""
    return endpoint(ref), at_address(ref)


async def is_alive(where, ref):
    """True if the object of `ref` exists. Raises Gone if it does not or nobody listens there, Silent,
    Unreachable.
    """
    try:
        gone = await call(where, ref, "_non_existent")
    except errors.ConnectionRefused:
        raise await refusal(where, endpoint(ref))
    if gone:
        raise errors.Gone(str(where))
    return True


async def refusal(where, process):
    """The errors.ConnectionRefused for an object whose `process`, (host, port), refuses; a Path `where` gives
    the name server that has given its reference.
    """
    from rtshell_lite.corba import refusals  # few need it

    return await refusals.refusal(where, process, _home(where))


async def is_near(where, ref):
    """Whether the address of a reference means the same host here as to the name server of a Path."""
    from rtshell_lite.corba import refusals

    home = _home(where)
    return home is None or await refusals.means_the_same_to(endpoint(ref)[0], home)


def _home(where):
    """The host of the name server of a Path; None for others, and for a reference that the user has given."""
    server = getattr(where, "server", None)
    if server is None or server.startswith(REFERENCES):
        return None
    return endpoint(corbaloc(str(where), server, "NameService", DEFAULT_PORT))[0]


def serve(servant):
    """Let others call a servant (see servants.py): the stringified reference to it, and a function that ends
    that.

    Raises what `start` raises, and Usage where nobody can listen as the settings demand.
    """
    start()
    return _orb.serve(servant)


# ---- objects that others know by a name, which our own ORB serves ----


def listen(host=None, port=0):
    """Serve at this address, "" for all of this host and 0 for any port, before anything is served; returns
    the port. Without a host, settings say where. Raises Usage where RTSHELL_ORB asks for another ORB, Failed
    where the port is taken.
    """
    start()
    from rtshell_lite.corba.iiop import client, server

    if _orb is not client:
        raise errors.Usage("only the builtin ORB serves components; unset RTSHELL_ORB, and RTCTREE_ORB_ARGS")
    if host is None:
        return None
    try:
        return server.listen(host, port)
    except errors.Usage:
        raise errors.Failed(f"{printable(host)}:{port}", "cannot listen there; does another program?")


def publish(servant, host, key=None):
    """Let others call a servant, after `listen`, by its `reference`, which has this host in it; returns a
    function that ends that. `key`: octets that others know it by. A coroutine of a servant is awaited for its
    answer.
    """
    from rtshell_lite.corba.iiop import server

    servant.reference, withdraw = server.serve(servant, host, key)
    return withdraw


def own_servant(ref):
    """The servant that `publish` made a reference to, or None where it is of another process, or
    withdrawn.
    """
    from rtshell_lite.corba.iiop import server

    return server.servant(ref)


# ---- values ----

struct = idl.struct
items = idl.items
enumerator = idl.enumerator


def properties(nvlist, only=None):
    """An SDOPackage::NVList as a list of (name, value) texts in its order; other values are converted to
    text.

    `only`: those of this name.
    """
    return _orb.properties(nvlist, only)


def descriptor(type_id):
    """The descriptor of a type of the IDL by its repository id, or None."""
    start()
    return _orb.descriptor(type_id)


def descriptor_in(nvlist, name):
    """The descriptor of the type of the value with this name in an SDOPackage::NVList, or None."""
    return _orb.descriptor_in(nvlist, name)


def nvlist(pairs):
    """(name, value) texts as an SDOPackage::NVList of strings,
    the one type that every implementation accepts.
    """
    start()
    return _orb.nvlist(pairs)
