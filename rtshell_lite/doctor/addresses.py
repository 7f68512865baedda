"""Host names, addresses and TCP, checked without CORBA: which step towards a peer fails."""

import contextlib
import errno
import ipaddress
import os
import select
import socket
import struct
import time

from rtshell_lite import errors
from rtshell_lite.corba import session
from rtshell_lite.corba.liveness import is_own, is_this_host  # noqa: F401: checks of addresses
from rtshell_lite.net import loop
from rtshell_lite.robot.aliases import resolve

# octets: LARGE is more than an Ethernet packet holds
SMALL = 4
LARGE = 2000
# seconds
LEAST = 0.2
PAUSE = 0.005


async def connect(addresses, port):
    """Open a TCP connection to the first of the IP addresses that accepts one, and close it: that address.

    Raises Unreachable, Silent.
    """
    where = f"{addresses[0]}:{port}"
    now = session.current()

    def attempt():
        end = time.monotonic() + now.timeout
        failure = None
        for address in addresses:
            try:
                socket.create_connection((address, port), max(0.001, end - time.monotonic())).close()
                return address
            except OSError as e:
                now.note_shortage(e, address)
                failure = failure or e
        raise _error(where, failure, now.timeout)

    return await session.on_thread(where, attempt)


def _error(where, e, timeout):
    if e.errno == errno.ECONNREFUSED:
        return errors.ConnectionRefused(where)
    if isinstance(e, socket.timeout):
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
    return await _once(_arrives, endpoint)


def _arrives(endpoint, patience):
    try:
        with _asked(endpoint, LARGE, patience) as (connection, end):
            while _unacknowledged(connection):
                if time.monotonic() > end:
                    return False
                select.select([], [], [], PAUSE)
    except (OSError, ValueError):
        return False
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


def _answers_small(endpoint, patience):
    try:
        with _asked(endpoint, SMALL, patience) as (connection, _):
            return bool(connection.recv(1))
    except (OSError, ValueError):
        return False


async def speaks_otherwise(endpoint):
    """Whether what listens at (host, port), which does not answer, speaks another protocol:
    servers of HTTP wait for the end of a line.
    """
    return await _once(_speaks_otherwise, endpoint)


def _speaks_otherwise(endpoint, patience):
    try:
        with _asked(endpoint, SMALL, patience) as (connection, _):
            connection.settimeout(min(LEAST, patience))  # of a process that hangs: the others need the time
            connection.sendall(b"\r\n\r\n")
            said = connection.recv(4)
    except (OSError, ValueError):
        return False
    return bool(said) and not b"GIOP".startswith(said)


_known = {}  # type: dict  # {(function, endpoint): its answer}


async def _once(function, endpoint):
    """What function(endpoint, seconds that it may wait) returns, on a thread;
    asked once for each endpoint, until `forget`.
    """
    if (function, endpoint) not in _known:
        now = session.current()
        if now.is_over():
            patience = LEAST
        else:
            patience = max(LEAST, now.timeout / 2)
        _known[function, endpoint] = await loop.on_thread(function, endpoint, patience)
    return _known[function, endpoint]


def forget():
    """Forget what was found of endpoints, for the next examination."""
    _known.clear()


@contextlib.contextmanager
def _asked(endpoint, size, patience):
    """(connection, when to give up): a GIOP question about an object with a key of that size,
    which nobody has, has been sent.
    """
    key = b"\0" * size
    question = b"GIOP\1\0\1\3" + struct.pack("<III", len(key) + 8, 1, len(key)) + key
    end = time.monotonic() + patience
    with socket.create_connection(endpoint, patience) as connection:
        connection.sendall(question)
        yield connection, end


def _unacknowledged(connection):
    """How many octets sent have not been acknowledged; 0 if the kernel does not report it."""
    try:
        import fcntl
        import termios  # which Debian's python3-minimal lacks

        return struct.unpack("i", fcntl.ioctl(connection, termios.TIOCOUTQ, b"\0" * 4))[0]
    except (OSError, ImportError):
        return 0


def is_numeric(host):
    """True for an IP address, not a name."""
    try:
        ipaddress.ip_address(host.partition("%")[0])
    except ValueError:
        return False
    return True


def is_incomplete(host):
    """True for an IPv6 address of one link only, fe80::1, without its interface: fe80::1%eth0."""
    if ":" not in host or "%" in host:
        return False
    return is_numeric(host) and ipaddress.ip_address(host).is_link_local


def is_loopback(address):
    """True for an IP address that means the host that uses it: 127.0.0.0/8, ::1."""
    try:
        ip = ipaddress.ip_address(address.partition("%")[0])
    except ValueError:
        return False
    mapped = getattr(ip, "ipv4_mapped", None)  # of ::ffff:127.0.0.1
    return ip.is_loopback or bool(mapped and mapped.is_loopback)


def why_not_bound(host, port):
    """Why nobody can listen at a host and port of this host now, '' where one can."""
    try:
        family, kind, protocol, _, address = socket.getaddrinfo(
            host or None, port, socket.AF_UNSPEC, socket.SOCK_STREAM, 0, socket.AI_PASSIVE
        )[0]
        with socket.socket(family, kind, protocol) as own:
            own.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            own.bind(address)
    except (OSError, UnicodeError) as e:
        return getattr(e, "strerror", None) or "not a host name"
    return ""
