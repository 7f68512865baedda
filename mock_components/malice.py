"""Modes of faulty.py in which a peer answers in time and in form, and every answer is made to harm who reads
it.

Each is a name server with one component, Evil0.rtc, and that component, too; what an operation answers is in
ANSWERS, what a mode changes of it in CHANGES.
"""
import struct

from .giop import (COMPONENT, Raw, bad_operation, bindings, cdr, reference, reply, sequence)

USER_EXCEPTION = 1
CONTEXT_SERVICE = "IDL:openrtm.aist.go.jp/OpenRTM/ExtTrigExecutionContextService:1.0"
ORGANIZATION = "IDL:org.omg/SDOPackage/Organization:1.0"
PORT, ITERATOR = "IDL:omg.org/RTC/PortService:1.0", "IDL:omg.org/CosNaming/BindingIterator:1.0"
CANNOT_PROCEED = b"IDL:omg.org/CosNaming/NamingContext/CannotProceed:1.0"
NO_TEXT = b"IDL:\xff\xfe\x80:1.0"
MANY = 20000
MEGABYTES = b"M" * (3 << 20)
TK_LONG, TK_ANY, TK_STRING, TK_SEQUENCE = 3, 11, 18, 19
DEEP = 5000             # from 100,000 levels on omniORB's own reader overflows its stack


def _strange(port, type_id=COMPONENT.encode(), profiles=1, body=None):
    """A reference whose parts are given as octets."""
    body = body or b"\1\1\2\0" + cdr(b"127.0.0.1") + struct.pack("<H", port) + cdr(sequence(b"evil"), 0)
    return Raw(cdr(type_id, profiles, *[0, sequence(body)] * profiles))


def _strings(*words):
    """Values of properties, as `any`."""
    return [Raw(cdr(TK_STRING, 0, word)) for word in words]


def _properties(pairs):
    return Raw(cdr(len(pairs), *[part for pair in pairs for part in pair]))


def _port(peer, name=b"Evil0.out", ends=0, more=()):
    """A PortProfile, of an out port with one connector with that many ends."""
    here = Raw(reference(peer.port, PORT))
    kinds = _strings(b"DataOutPort", b"IDL:RTC/TimedLong:1.0")
    given = list(zip((b"port.port_type", b"dataport.data_type"), kinds)) + list(more)
    connector = [b"connector", b"id", ends] + [here] * ends + [0]
    return Raw(cdr(name, 0, here, int(ends > 0), *(connector if ends else []) + [
        Raw(reference(peer.port)), _properties(given)]))


def _ports(peer, count=1):
    return Raw(cdr(count, *[Raw(reference(peer.port, PORT, b"port%d" % number)) for number in range(count)]))


def _connectors(peer, count=300, ends=2):
    """A PortProfile with `count` connectors, each with other ports of this very peer, which answer with as
    many.
    """
    connectors = []
    for number in range(count):
        far = [Raw(reference(peer.port, PORT, b"port%d_%d" % (number, end))) for end in range(ends)]
        connectors += [b"connector%d" % number, b"id%d" % number, ends, *far, 0]
    kinds = _strings(b"DataOutPort", b"IDL:RTC/TimedLong:1.0")
    given = list(zip((b"port.port_type", b"dataport.data_type"), kinds))
    return Raw(
        cdr(
            b"Evil0.out",
            0,
            Raw(reference(peer.port, PORT)),
            count,
            *connectors,
            Raw(reference(peer.port)),
            _properties(given)
        )
    )


def _references(peer, type_id, count=5000):
    """`count` different objects of this very peer."""
    return Raw(
        cdr(count, *[Raw(reference(peer.port, type_id, b"object%d" % number)) for number in range(count)])
    )


def _component(peer, port=None, more=(), texts=b"evil"):
    """A ComponentProfile."""
    return Raw(
        cdr(
            b"Evil0",
            texts,
            texts,
            texts,
            texts,
            texts,
            1,
            port or _port(peer),
            b"",
            0,
            _properties(list(more)),
        )
    )


def _names(*names):
    return bindings([(name, b"rtc") for name in names])


# What each operation answers, of an honest one.
ANSWERS = {
    "list": lambda peer: _names(b"Evil0"),
    "resolve": lambda peer: reference(peer.port),
    "get_owned_contexts": lambda peer: cdr(1, Raw(reference(peer.port, CONTEXT_SERVICE))),
    "get_participating_contexts": lambda peer: cdr(0),
    "get_context_handle": lambda peer: cdr(0),
    "is_running": lambda peer: b"\1",
    "get_rate": lambda peer: struct.pack("<d", 100),
    "get_kind": lambda peer: cdr(0),
    "get_profile": lambda peer: struct.pack("<IId", 0, 0, 100) + cdr(Raw(reference(peer.port)), 0, 0),
    "get_component_state": lambda peer: cdr(2),     # Active
    "get_sdo_id": lambda peer: cdr(b"Evil0"),
    "get_ports": _ports,
    "get_port_profile": _port,
    "get_component_profile": _component,
    "get_connector_profiles": lambda peer: cdr(0),
    "get_organization_id": lambda peer: cdr(b"organization"),
    "get_members": lambda peer: cdr(0),
    "get_organizations": lambda peer: cdr(0),
    "get_owned_organizations": lambda peer: cdr(0),
}


def _nested_any():
    return Raw(struct.pack("<%dI" % DEEP, *[TK_ANY] * DEEP) + struct.pack("<Ii", TK_LONG, 42))


def _nested_sequences(levels=200):
    """A sequence in a sequence in a sequence …, with its TypeCode."""
    code = struct.pack("<I", TK_LONG)
    for _ in range(levels):
        body = b"\1\0\0\0" + code + struct.pack("<I", 0)
        code = struct.pack("<II", TK_SEQUENCE, len(body)) + body
    return Raw(code + struct.pack("<%dI" % levels, *[1] * levels) + struct.pack("<i", 42))


def _endless(names, length=7):
    """Bindings that never end: names of each batch, always the same, and that there are more."""
    listed = _names(*[b"n%06d" % number + b"N" * (length - 7) for number in range(names)])
    # without the iterator of list(): a string of one octet, and no profile
    batch = b"\1\0\0\0" + listed[:-12]
    return {
        "list": lambda peer: Raw(_names(b"Evil0")[:-12] + reference(peer.port, ITERATOR)),
        "next_n": lambda peer: batch,
        "destroy": lambda peer: b"",
    }


# What each mode answers instead; a pair is an exception of a user, and what is in it.
CHANGES = {
    "bad-type": {"resolve": lambda peer: _strange(peer.port, NO_TEXT)},
    "bad-profiles": {"resolve": lambda peer: _strange(peer.port, profiles=10000)},
    "bad-body": {"resolve": lambda peer: _strange(peer.port, body=b"\1\1\2\0\xff\xff\xff\x7fabc")},
    "bad-address": {"resolve": lambda peer: _strange(peer.port, body=b"")},
    "no-address": {
        "resolve": lambda peer: Raw(cdr(COMPONENT.encode(), 1, 7, sequence(b"of another protocol")))
    },
    "long-type": {"resolve": lambda peer: _strange(peer.port, b"IDL:" + MEGABYTES + b":1.0")},
    "bad-exception": {"resolve": lambda peer: (CANNOT_PROCEED, _strange(peer.port, NO_TEXT), 0)},
    "bad-iterator": {"list": lambda peer: Raw(_names(b"Evil0")[:-12] + _strange(peer.port, NO_TEXT))},
    "bad-ports": {"get_ports": lambda peer: Raw(cdr(1, _strange(peer.port, NO_TEXT)))},
    "bad-owner": {
        "get_port_profile": lambda peer: Raw(
            cdr(b"Evil0.out", 0, Raw(reference(peer.port, PORT)), 0, _strange(peer.port, NO_TEXT), 0)
        )
    },
    "any-in-any": {
        "get_port_profile": lambda peer: _port(peer, more=[(b"deep", _nested_any())]),
        "get_component_profile": lambda peer: _component(peer, more=[(b"deep", _nested_any())]),
    },
    "deep-value": {
        "get_port_profile": lambda peer: _port(peer, more=[(b"deep", _nested_sequences())]),
        "get_component_profile": lambda peer: _component(peer, more=[(b"deep", _nested_sequences())]),
    },
    "endless": _endless(1000),
    "endless-nothing": _endless(0),
    "endless-long": _endless(30, 131000),
    "many-ports": {"get_ports": lambda peer: _ports(peer, MANY)},
    "many-ends": {"get_port_profile": lambda peer: _port(peer, ends=MANY)},
    "many-contexts": {"get_owned_contexts": lambda peer: _references(peer, CONTEXT_SERVICE)},
    "many-organizations": {
        operation: lambda peer: _references(peer, ORGANIZATION)
        for operation in ("get_owned_organizations", "get_organizations")
    },
    "many-members": {
        "get_owned_organizations": lambda peer: _references(peer, ORGANIZATION, 1),
        "get_members": lambda peer: _references(peer, COMPONENT),
        "get_profile": lambda peer: struct.pack("<IId", 0, 0, 100)
        + cdr(Raw(reference(peer.port)), _references(peer, COMPONENT), 0),
    },
    "many-connectors": {"get_port_profile": _connectors},
    "megabytes": {
        "get_port_profile": lambda peer: _port(peer, name=b"Evil0." + MEGABYTES),
        "get_component_profile": lambda peer: _component(peer, texts=MEGABYTES),
        "list": lambda peer: _names(b"Evil0", MEGABYTES),
    },
}


def answers(peer):
    """What a peer of such a mode answers, by operation: made before anybody waits for it, as some take long.
    """
    return {operation: made(peer) for operation, made in dict(ANSWERS, **CHANGES[peer.mode]).items()}


def respond(peer, connection, request):
    """Answers all that it is asked, with something that harms who reads it."""
    answer = peer.answers.get(request.operation)
    if answer is None:
        connection.sendall(bad_operation(request))
    elif isinstance(answer, tuple):
        connection.sendall(reply(request, cdr(*answer), USER_EXCEPTION))
    else:
        connection.sendall(reply(request, answer))
