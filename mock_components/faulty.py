"""Peers that misbehave on purpose, to see that commands stay bounded, quiet and calm.

python3 -m mock_components.faulty [--bind HOST:PORT[/CONTEXT...]] [NAME=]MODE...

One port on 127.0.0.1 for each MODE; one line of JSON, {"NAME": port, ...}, says that all are ready. NAME is
MODE unless given. The end of stdin, SIGTERM, or an hour ends it. Every port can be taken for a naming context
(corbaloc:iiop: 1.2@127.0.0.1:PORT/NameService) and for a component: object keys are not looked at.

--bind enters each peer in a live name server, below CONTEXT, which is made if need be, as the component
NAME.rtc; a NAME with another kind, such as evil.host_cxt=hostile, is entered as a naming context.

Sockets alone: no ORB can be talked into most of this.
"""
import json
import os
import random
import signal
import socket
import struct
import sys
import threading
import time

from rtshell_lite.giop import messages

from . import malice
from .giop import (COMPONENT, CONTEXT, FRAGMENT, MANAGER, REPLY, bad_operation, bindings, cdr,
                   component_profile, harmless_answer, read_request, reference, reply, stringified)

LIFETIME = 3600

HOSTILE_NAMES = [
    (b"\x1b]0;pwned\x07\x1b[2Jescape", b"rtc"),
    (b"\x1b]52;c;cm0gLXJmIH4=\x07clipboard", b"host_cxt"),
    (b"line\nfeed\rreturn\ttab", b"rtc"),
    (b"c1\x9b31m\xc2\x9b32m", b"rtc"),
    ("bidi\u202ecba\u200b".encode(), b"rtc"),
    (b"\xff\xfe\x80invalid", b"rtc"),
    ("\u65e5\u672c\u8a9e".encode(), b"rtc"),
    ("\u65e5\u672c\u8a9e".encode("euc-jp"), b"rtc"),
    (b"$(touch canary);`touch canary`", b"rtc"),
    (b"quote'\"space ", b"rtc"),
    (b"-rf", b"rtc"),
    (b"..", b""),
    (b".", b""),
    (b"..", b"host_cxt"),
    (b"../../etc/passwd", b"rtc"),
    (b"a.b\\/c:d", b"k.k"),
    (b"", b"rtc"),
    (b"", b""),
    (b"L" * 65536, b"rtc"),
]
TYPES = {b"rtc": COMPONENT, b"mgr": MANAGER}  # of what a name of that kind leads to
MANY = [(b"n%06d" % number, b"rtc") for number in range(20000)]


def silent(peer, connection, request):
    """Accepts, reads, never answers."""


def half_header(peer, connection, request):
    """Sends five bytes of a GIOP header, then nothing."""
    connection.sendall(b"GIOP\1")


def drip(peer, connection, request):
    """Sends a reply of 100 kB, one byte each 0.2 s."""
    connection.sendall(b"GIOP\1\2\1\1" + struct.pack("<I", 100000))
    while True:
        connection.sendall(b"\0")
        peer.sleep(0.2)


def reset(peer, connection, request):
    """Resets the connection (RST)."""
    connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
    raise EOFError


def close(peer, connection, request):
    """Closes the connection after the request."""
    raise EOFError


def garbage(peer, connection, request):
    """Sends 4 kB of random bytes."""
    numbers = random.Random(1)
    connection.sendall(bytes(numbers.randrange(256) for _ in range(4096)))


def announce(peer, connection, request):
    """Announces a reply of 2 GB and sends none of it."""
    connection.sendall(b"GIOP\1\2\1\1" + struct.pack("<I", 0x7ffffff0))


def sequence_bomb(peer, connection, request):
    """Replies with a sequence of 268 million elements, of which there are none."""
    connection.sendall(reply(request, cdr(0x10000000)))


def string_bomb(peer, connection, request):
    """Replies with a string of 2 GB, of which there are three bytes."""
    before = (1, 1) if request.operation == "list" else ()
    connection.sendall(reply(request, cdr(*before + (0x7fffffff,)) + b"abc"))


def wrong_id(peer, connection, request):
    """Replies to a request that nobody made."""
    connection.sendall(reply(request, bindings([]), wrong_id=0x55))


def crumbs(peer, connection, request):
    """Sends a reply in fragments of two bytes, without end."""
    connection.sendall(begun(request.id))
    some = messages.whole(FRAGMENT, struct.pack("<I", request.id) + b"ab", more=True) * 1000
    while True:
        connection.sendall(some)


def strangers(peer, connection, request):
    """Begins replies to requests that nobody made, without end."""
    number = request.id
    while True:
        connection.sendall(b"".join(map(begun, range(number + 1000, number + 2000))))
        number = (number + 1000) % (1 << 31)


def begun(number):
    """A reply to this request of which more is to come."""
    return messages.whole(REPLY, struct.pack("<III", number, 0, 0), more=True)


def hostile(peer, connection, request):
    """Lists names with escape sequences, newlines, invalid UTF-8, shell code, `..`, nothing, 64 kB."""
    if request.operation == "get_component_profile":
        connection.sendall(reply(request, component_profile(HOSTILE_NAMES[0][0])))
    else:
        name_server(peer, connection, request, HOSTILE_NAMES)


def many(peer, connection, request):
    """Lists 20,000 components in one reply of 1 MB."""
    name_server(peer, connection, request, peer.many)


def loop(peer, connection, request):
    """A context that is bound within itself."""
    name_server(peer, connection, request, [(b"again", b"host_cxt"), (b"leaf", b"rtc")])


def bottomless(peer, connection, request):
    """A context within a context within a context ..., each with an object key of its own."""
    depth = int(request.key) if request.key.isdigit() else 0
    name_server(peer, connection, request, [(b"deeper", b"host_cxt")], key=b"%d" % (depth + 1))


def branching(peer, connection, request):
    """Three contexts in a context, three in each of these ..., or the same one by new references."""
    names = [(name, b"host_cxt") for name in (b"a", b"b", b"c")]
    name_server(peer, connection, request, names, key=b"%d" % random.randrange(1 << 60))


def other_port(peer, connection, request):
    """A context whose references lead to another port, which is silent or closed."""
    name_server(peer, connection, request, [(b"lost", b"rtc"), (b"lost", b"host_cxt")], port=peer.other)


def name_server(peer, connection, request, names, port=None, key=b"faulty"):
    """Answer as a naming context with these names, all of which lead to one object: this very one, unless
    given.
    """
    if request.operation == "list":
        answer = reply(request, peer.listing(names))
    elif request.operation == "resolve":
        arguments = request.arguments
        kinds = [(arguments.string(), arguments.string())[1] for _ in range(arguments.number())]
        type_id = TYPES.get(kinds[-1] if kinds else b"", CONTEXT)
        answer = reply(request, reference(port or peer.port, type_id, key))
    else:
        answer = bad_operation(request)
    connection.sendall(answer)


# These never get as far as a request.
UNREACHABLE = {"refused": (
    "The port is closed."
), "dead-host": "Drops SYNs, as a host does that is switched off."}
RUDE = [silent, half_header, drip, reset, close, garbage, announce]
POLITE = [sequence_bomb, string_bomb, wrong_id, crumbs, strangers, hostile, many, loop, bottomless, branching]
ELSEWHERE = ["elsewhere-silent", "elsewhere-refused"]


def mode_name(function):
    """half-header for half_header()."""
    return function.__name__.replace("_", "-")


# Name of a mode -> (what it does with a request, whether harmless questions are answered first).
MODES = {mode_name(function): (function, function in POLITE) for function in RUDE + POLITE}
MODES.update({"late-" + mode_name(function): (function, True) for function in RUDE})
MODES.update({name: (other_port, True) for name in ELSEWHERE})
MODES.update({name: (malice.respond, True) for name in malice.CHANGES})


class Behaviour:
    """What a peer of a mode does that listens at a port of 127.0.0.1; `other`: a port where another one does,
    of those of ELSEWHERE; `many`: the names that the mode of that name lists.
    """

    def __init__(self, mode, port, other=None, many=MANY):
        self.mode = mode
        self.port = port
        self.other = other
        self.many = many
        self.sleep = time.sleep
        self._respond, self._polite = MODES[mode]
        self._listed = None
        if mode == "many":
            self.listing(many)
        self.answers = malice.answers(self) if mode in malice.CHANGES else None

    def listing(self, names):
        """What list() returns for them, made once: 20,000 take longer than some clients wait."""
        if self._listed is None:
            self._listed = bindings(names)
        return self._listed

    def converse(self, connection):
        """Answer what comes from a client, until it, or the mode, has had enough: EOFError, OSError."""
        while True:
            request = read_request(connection)
            answer = harmless_answer(request) if self._polite else None
            if not request.expects_reply:
                continue
            if answer:
                connection.sendall(answer)
            else:
                self._respond(self, connection, request)


class Peer:
    """A port on 127.0.0.1 that misbehaves in one way until it is closed."""

    def __init__(self, mode):
        self.sockets = []
        self.other = Peer(mode[len("elsewhere-"):]) if mode in ELSEWHERE else None
        self.listener = self.keep(socket.socket())
        self.listener.bind(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]
        if mode == "dead-host":
            self.fill_backlog()
        elif mode != "refused":             # a port that is bound but not listened to refuses, and stays ours
            self.behaviour = Behaviour(mode, self.port, self.other and self.other.port)
            self.listener.listen(64)
            threading.Thread(target=self.accept, daemon=True).start()

    def keep(self, opened):
        self.sockets.append(opened)
        return opened

    def fill_backlog(self):
        """The kernel drops SYNs to a full backlog."""
        self.listener.listen(0)
        for _ in range(4):
            client = self.keep(socket.socket())
            client.setblocking(False)
            client.connect_ex(("127.0.0.1", self.port))

    def accept(self):
        while True:
            try:
                connection = self.keep(self.listener.accept()[0])
            except OSError:                 # closed
                return
            threading.Thread(target=self.converse, args=(connection,), daemon=True).start()

    def converse(self, connection):
        with connection:
            try:
                self.behaviour.converse(connection)
            except (EOFError, OSError):
                pass

    def close(self):
        for opened in self.sockets:
            try:
                opened.shutdown(socket.SHUT_RDWR)       # wakes up accept() and recv(), which close() does not
            except OSError:
                pass
            opened.close()
        if self.other:
            self.other.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


def bind(place, ports):
    """Enter peers in a live name server: place is HOST:PORT[/CONTEXT...], ports maps names to ports."""
    import CosNaming
    import omniORB
    from omniORB import CORBA
    omniORB.setClientCallTimeout(5000)
    orb = CORBA.ORB_init(["faulty"])
    address, _, path = place.partition("/")
    root = orb.string_to_object(f"corbaloc:iiop:1.2@{address}/NameService")._unchecked_narrow(
        CosNaming.NamingContext
    )
    place = []
    for part in filter(None, path.split("/")):
        place += name_of(part)
        try:
            root.bind_new_context(place)
        except CosNaming.NamingContext.AlreadyBound:
            pass
    for name, port in ports.items():
        if name.endswith(".rtc") or "." not in name:
            component = orb.string_to_object(stringified(port))
            root.rebind(place + name_of(name if "." in name else name + ".rtc"), component)
        else:
            other = orb.string_to_object(stringified(port, CONTEXT))
            root.rebind_context(place + name_of(name), other._unchecked_narrow(CosNaming.NamingContext))


def name_of(text):
    """ID.KIND as a CosNaming name of one component."""
    import CosNaming
    id_, _, kind = text.rpartition(".")
    return [CosNaming.NameComponent(id_, kind) if id_ else CosNaming.NameComponent(kind, "")]


def usage():
    """The help, with what each mode does."""
    modes = list(UNREACHABLE.items()) + [
        (mode_name(function), function.__doc__) for function in RUDE + POLITE
    ]
    modes += [(name, other_port.__doc__) for name in ELSEWHERE]
    modes += [(name, malice.respond.__doc__) for name in malice.CHANGES]
    lines = [f"  {name:<20}{text}" for name, text in modes]
    return """{}
modes:
{}

late-MODE answers harmless questions (_is_a, _non_existent) before it turns nasty; it exists for
{}. From sequence-bomb on, all modes do so.""".format(
        __doc__, "\n".join(lines), ", ".join(map(mode_name, RUDE)))


def parse(arguments):
    """(place to bind in or None, {name: mode}) of a command line."""
    place = None
    if arguments[:1] == ["--bind"]:
        place = arguments[1]
        arguments = arguments[2:]
    modes = {}
    for argument in arguments:
        name, _, mode = argument.partition("=")
        modes[name] = mode or name
        if modes[name] not in MODES and modes[name] not in UNREACHABLE:
            sys.exit(f"faulty: no such mode: {modes[name]} (see --help)")
    return place, modes


def end_on_sigterm():
    signal.sigwait([signal.SIGTERM])
    os._exit(0)


def main(arguments):
    """Play the peers that the arguments name, print their ports as JSON, and end with standard input."""
    if not arguments or {"-h", "--help"} & set(arguments):
        print(usage())
        return
    place, modes = parse(arguments)
    # a thread waits for it: a handler is not called if the signal comes just before a read
    signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGTERM])
    threading.Thread(target=end_on_sigterm, daemon=True).start()
    peers = {name: Peer(mode) for name, mode in modes.items()}
    ports = {name: peer.port for name, peer in peers.items()}
    if place:
        bind(place, ports)
    timer = threading.Timer(LIFETIME, os._exit, [0])
    timer.daemon = True
    timer.start()
    print(json.dumps(ports, sort_keys=True), flush=True)
    sys.stdin.buffer.read()
    os._exit(0)


if __name__ == "__main__":
    main(sys.argv[1:])
