"""Host names, addresses and TCP, looked at without CORBA: which step towards a peer fails."""
import errno
import ipaddress
import os
import socket
import time

from rtshell_lite import errors, rpc
from rtshell_lite.text import printable


def resolve(host):
    """The IP addresses of a host name, as text. Raises Unreachable when it has none, or the look-up takes too long.

    The system's resolver has no deadline, and omniORB's own limits do not cover it.
    """
    def look_up():
        try:
            return _unique(found[4][0] for found in socket.getaddrinfo(host, None, 0, socket.SOCK_STREAM))
        except (OSError, UnicodeError) as e:
            raise errors.Unreachable(printable(host), getattr(e, "strerror", None) or "not a host name")
    return rpc.ask(("name of", host), printable(host), look_up)


def _unique(addresses):
    found = []
    for address in addresses:
        if address not in found:
            found.append(address)
    return found


def connect(addresses, port):
    """Open a TCP connection to the first of the IP addresses that takes one, and close it. Raises Unreachable, Silent."""
    def attempt():
        end, failure = time.monotonic() + rpc.timeout, None
        for address in addresses:
            try:
                socket.create_connection((address, port), max(0.001, end - time.monotonic())).close()
                return
            except OSError as e:
                failure = failure or e
        raise _error("%s:%d" % (addresses[0], port), failure)
    rpc.ask(("TCP", tuple(addresses), port), "%s:%d" % (addresses[0], port), attempt)


def _error(where, e):
    if e.errno == errno.ECONNREFUSED:
        return errors.ConnectionRefused(where)
    if isinstance(e, socket.timeout):
        return errors.Silent(where, rpc.no_answer(rpc.timeout))
    return errors.Unreachable(where, os.strerror(e.errno) if e.errno else str(e))


def probe(endpoint):
    """None when TCP reaches (host, port) from here, else the errors.Error that tells why not."""
    host, port = endpoint
    try:
        connect(resolve(host), port)
    except errors.Error as e:
        return e
    return None


def is_loopback(address):
    """True for an IP address that means the host that uses it: 127.0.0.0/8, ::1."""
    try:
        found = ipaddress.ip_address(address.partition("%")[0])
    except ValueError:
        return False
    mapped = getattr(found, "ipv4_mapped", None)  # of ::ffff:127.0.0.1
    return found.is_loopback or bool(mapped and mapped.is_loopback)


def is_own(address):
    """True for an IP address of this host, found out by taking a UDP socket there."""
    family = socket.AF_INET6 if ":" in address else socket.AF_INET
    try:
        with socket.socket(family, socket.SOCK_DGRAM) as own:
            own.bind((address.partition("%")[0], 0))
    except OSError:
        return False
    return True
