"""Host names, addresses and TCP, checked without CORBA: which step towards a peer fails."""
import contextlib
import errno
import fcntl
import functools
import ipaddress
import os
import socket
import struct
import time

from rtshell_lite import errors
from rtshell_lite.corba import lanes
from rtshell_lite.corba.liveness import is_own, is_this_host  # noqa: F401: checks of addresses
from rtshell_lite.robot.aliases import resolve

SMALL, LARGE = 4, 2000  # octets: LARGE is more than an Ethernet packet holds
LEAST, PAUSE = 0.2, 0.005  # seconds


def connect(addresses, port):
    """Open a TCP connection to the first of the IP addresses that accepts one, and close it: that address.

    Raises Unreachable, Silent.
    """
    where = f"{addresses[0]}:{port}"

    def attempt():
        end, failure = time.monotonic() + lanes.session.timeout, None
        for address in addresses:
            try:
                socket.create_connection((address, port), max(0.001, end - time.monotonic())).close()
                return address
            except OSError as e:
                lanes.note_shortage(e, address)
                failure = failure or e
        raise _error(where, failure)
    return lanes.aside(("TCP", tuple(addresses), port), where, attempt)


def _error(where, e):
    if e.errno == errno.ECONNREFUSED:
        return errors.ConnectionRefused(where)
    if isinstance(e, socket.timeout):
        return errors.Silent(where, lanes.no_answer(lanes.session.timeout))
    return errors.Unreachable(where, os.strerror(e.errno) if e.errno else str(e))


def probe(endpoint):
    """None when TCP reaches (host, port) from here, else the errors.Error."""
    host, port = endpoint
    try:
        connect(resolve(host), port)
    except errors.Error as e:
        return e
    return None


@functools.lru_cache(maxsize=None)
def arrives(endpoint):
    """Whether the host of (host, port) receives what is sent: its process may hang, but the network works.

    A question larger than a packet is sent, and the kernel says whether all of it was acknowledged. Asked once for each endpoint;
    `forget` forgets the answers.
    """
    try:
        with _asked(endpoint, LARGE) as (connection, end):
            while _unacknowledged(connection):
                if time.monotonic() > end:
                    return False
                time.sleep(PAUSE)
    except (OSError, ValueError):
        return False
    return True


@functools.lru_cache(maxsize=None)
def loses_large(endpoint):
    """Whether answers of (host, port), a process that was asked for something large in vain, may be lost on the way.

    Its host is another one, and a small question is answered. Asked once for each endpoint.
    """
    try:
        if is_this_host(endpoint[0]):
            return False
        with _asked(endpoint, SMALL) as (connection, _):
            return bool(connection.recv(1))
    except (errors.Error, OSError, ValueError):
        return False


@functools.lru_cache(maxsize=None)
def speaks_otherwise(endpoint):
    """Whether what listens at (host, port), which does not answer, speaks another protocol: servers of HTTP wait for the end of a line.

    Asked once for each endpoint.
    """
    try:
        with _asked(endpoint, SMALL) as (connection, _):
            connection.settimeout(min(LEAST, lanes.session.timeout))  # of a process that hangs: the others need the time
            connection.sendall(b"\r\n\r\n")
            said = connection.recv(4)
    except (OSError, ValueError):
        return False
    return bool(said) and not b"GIOP".startswith(said)


def forget():
    """Forget which hosts received what, for the next examination."""
    arrives.cache_clear()
    speaks_otherwise.cache_clear()
    loses_large.cache_clear()


@contextlib.contextmanager
def _asked(endpoint, size):
    """(connection, when to give up): a GIOP question about an object with a key of that size, which nobody has, has been sent."""
    key = b"\0" * size
    question = b"GIOP\1\0\1\3" + struct.pack("<III", len(key) + 8, 1, len(key)) + key
    patience = LEAST if lanes.is_over() else max(LEAST, lanes.session.timeout / 2)
    end = time.monotonic() + patience
    lanes.alive()  # this is no silence of the peer
    with socket.create_connection(endpoint, patience) as connection:
        connection.sendall(question)
        yield connection, end


def _unacknowledged(connection):
    """How many octets sent have not been acknowledged; 0 if the kernel does not report it."""
    try:
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
    return "%" not in host and is_numeric(host) and ipaddress.ip_address(host).is_link_local and ":" in host


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
        family, kind, protocol, _, address = socket.getaddrinfo(host or None, port, socket.AF_UNSPEC, socket.SOCK_STREAM, 0,
                                                                socket.AI_PASSIVE)[0]
        with socket.socket(family, kind, protocol) as own:
            own.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            own.bind(address)
    except (OSError, UnicodeError) as e:
        return getattr(e, "strerror", None) or "not a host name"
    return ""
