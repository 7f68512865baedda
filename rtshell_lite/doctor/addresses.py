"""Host names, addresses and TCP, checked without CORBA: which step towards a peer fails."""

import errno
import ipaddress
import os
import struct

from rtshell_lite import errors
from rtshell_lite.corba import session
from rtshell_lite.corba.refusals import is_own, is_this_host  # noqa: F401: checks of addresses
from rtshell_lite.net import loop, tcp
from rtshell_lite.robot.aliases import resolve

# octets: LARGE is more than an Ethernet packet holds
SMALL = 4
LARGE = 2000
# seconds
LEAST = 0.2
PAUSE = 0.005
SHORTEST = 0.001


async def connect(addresses, port):
    """Open a TCP connection to the first of the IP addresses that accepts one, and close it: that address.

    Raises Unreachable, Silent.
    """
    where = f"{addresses[0]}:{port}"
    now = session.current()
    end = loop.now() + now.timeout
    failure = None
    for address in addresses:
        try:
            left = max(SHORTEST, end - loop.now())
            (await loop.within(left, _connected((address, port)), TimeoutError())).close()
            return address
        except OSError as e:
            now.note_shortage(e, address)
            failure = failure or e
    raise _error(where, failure, now.timeout)


async def _connected(endpoint):
    """A socket that is connected with the first place of (host, port) that accepts. Raises OSError, that of
    the first.
    """
    host, port = endpoint
    world = loop.world()
    if is_numeric(host):
        ways = world.resolve(host, port)
    else:
        ways = await loop.on_thread(world.resolve, host, port)
    failure = None
    for way in ways:
        try:
            return await tcp.connect(way)
        except OSError as e:
            failure = failure or e
    raise failure


def _error(where, e, timeout):
    if e.errno == errno.ECONNREFUSED:
        return errors.ConnectionRefused(where)
    if isinstance(e, TimeoutError) and not e.errno:
        return errors.Silent(where, session.no_answer(timeout))
    if e.errno:
        return errors.Unreachable(where, os.strerror(e.errno))
    return errors.Unreachable(where, str(e))


async def probe(endpoint):
    """None when TCP reaches (host, port) from here, else the errors.Error."""
    host, port = endpoint
    try:
        await connect(await resolve(host), port)
    except errors.Error as e:
        return e
    return None


async def arrives(endpoint):
    """Whether the host of (host, port) receives what is sent: its process may hang, but the network works.

    A question larger than a packet is sent, and the kernel says whether all of it was acknowledged.
    """
    return await _once(_arrives, endpoint, LARGE)


async def _arrives(connection):
    world = loop.world()
    while world.unacknowledged(connection):
        await loop.sleep(PAUSE)
    return True


async def loses_large(endpoint):
    """Whether answers of (host, port), a process that was asked for something large in vain, may be lost on
    the way.

    Its host is another one, and a small question is answered.
    """
    try:
        return not await is_this_host(endpoint[0]) and await _once(_answers_small, endpoint)
    except errors.Error:
        return False


async def _answers_small(connection):
    return bool(await tcp.receive(connection, 1))


async def speaks_otherwise(endpoint):
    """Whether what listens at (host, port), which does not answer, speaks another protocol:
    servers of HTTP wait for the end of a line.
    """
    return await _once(_speaks_otherwise, endpoint)


async def _speaks_otherwise(connection):
    connection.send(b"\r\n\r\n")
    said = await loop.within(LEAST, tcp.receive(connection, 4), TimeoutError())
    return bool(said) and not b"GIOP".startswith(said)


async def _once(look, endpoint, size=SMALL):
    """What look(socket) returns after a question of a size to an endpoint; False where that fails, or takes
    too long. Asked once for each endpoint in an examination.
    """
    now = session.current()
    if (look, endpoint) not in now.checks:
        patience = LEAST if now.is_over() else max(LEAST, now.timeout / 2)
        try:
            answer = await loop.within(patience, _answer(look, endpoint, size), TimeoutError())
        except (OSError, ValueError):
            answer = False
        now.checks[look, endpoint] = answer
    return now.checks[look, endpoint]


async def _answer(look, endpoint, size):
    """See `_once`; the question is about an object with a key of that size, which nobody has."""
    key = b"\0" * size
    question = b"GIOP\1\0\1\3" + struct.pack("<III", len(key) + 8, 1, len(key)) + key
    connection = await _connected(endpoint)
    try:
        connection.send(question)
        return await look(connection)
    finally:
        connection.close()


def _ip(host):
    """The ipaddress object for an IP address, with or without its interface; None for a name."""
    try:
        return ipaddress.ip_address(host.partition("%")[0])
    except ValueError:
        return None


def is_numeric(host):
    """True for an IP address, not a name."""
    return _ip(host) is not None


def is_incomplete(host):
    """True for an IPv6 address of one link only, fe80::1, without its interface: fe80::1%eth0."""
    return ":" in host and "%" not in host and is_numeric(host) and _ip(host).is_link_local


def is_loopback(address):
    """True for an IP address that means the host that uses it: 127.0.0.0/8, ::1."""
    ip = _ip(address)
    mapped = getattr(ip, "ipv4_mapped", None)  # of ::ffff:127.0.0.1
    return bool(ip and (ip.is_loopback or mapped and mapped.is_loopback))


def why_not_bound(host, port):
    """Why nobody can listen at a host and port of this host now, '' where one can."""
    try:
        loop.world().bind(host, port)
    except (OSError, UnicodeError) as e:
        return getattr(e, "strerror", None) or "not a host name"
    return ""
