"""What the addresses that references publish mean: to the host that looks, and to the one at which they were found."""
import fcntl
import ipaddress
import socket
import struct

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.doctor import addresses, remedies
from rtshell_lite.doctor.finding import fail, published, warn
from rtshell_lite.text import printable

SIOCGIFADDR, SIOCGIFNETMASK = 0x8915, 0x891b  # of Linux


def misled(check, where, ref, homes, elsewhere=""):
    """The Finding on an object that publishes addresses at which others do not find it, None where nothing is known against them.

    homes      IP addresses of who knows the object: the name server that it is bound in, its manager, the near end of a connection
    elsewhere  an address of another host that takes part in the system, '' where all of it is on one
    """
    offered, here = orb.addresses(ref), any(addresses.is_own(each) for each in homes)
    if not offered or not homes:
        return None
    told = published(ref)
    if all(_is_loopback(host) for host, _ in offered):
        if all(addresses.is_loopback(each) for each in homes):
            return elsewhere and warn(check, where, "publishes %s: only this host can reach it, and %s takes part in the system" % (
                told, printable(elsewhere)), _another_address("")) or None
        if here:
            return warn(check, where, f"publishes {told}: only this host can reach it", _another_address(homes[0]))
        return fail(check, where, f"publishes {told}, which means this host, not its own", _another_address(homes[0]))
    if all(addresses.is_loopback(each) for each in homes):
        return None  # it was found by somebody here, and who else knows it cannot be seen
    found = _numeric(offered)
    apart = found and not any(together(home, each) is not False for each in found for home in homes)
    if not apart or here and not all(addresses.is_own(each) for each in found):
        return None
    if here:
        return warn(check, where, "publishes %s, of another network than %s: who knows it from there may not reach it" % (
            told, homes[0]), _another_address(homes[0]))
    if any(addresses.is_own(each) for each in found):
        return fail(check, where, "publishes %s, which means this host, too: it is of another network than %s" % (
            told, homes[0]), _another_address(homes[0]))
    return None


def is_certain(ref, homes):
    """True where who refuses a connection at the addresses of `ref` is the host that published them, not another one of that name.

    Addresses of private networks mean other hosts elsewhere.
    """
    for address in _numeric(orb.addresses(ref)):
        number = ipaddress.ip_address(address.partition("%")[0])
        if number.is_private and not any(together(home, address) or addresses.is_own(home) for home in homes):
            return False
    return True


def is_apart(ref, homes):
    """True where all addresses that `ref` publishes are known to be of other networks than `homes`."""
    found = _numeric(orb.addresses(ref))
    return bool(found) and all(together(home, each) is False for each in found for home in homes)


def homes_of(ref):
    """The IP addresses that a reference publishes."""
    return _numeric(orb.addresses(ref))


def outside(refs):
    """An address of another host among those that references publish, or of this host as others know it; '' where there is none."""
    for ref in refs:
        for host, _ in orb.addresses(ref):
            if host and not _is_loopback(host):
                return host
    return ""


def together(one, other):
    """Whether two IP addresses are in the same network, as far as the networks of this host show; None where they do not."""
    if one == other or addresses.is_loopback(one) and addresses.is_loopback(other):
        return True
    known = False
    for network in _networks():
        inside = [ipaddress.ip_address(each.partition("%")[0]) in network for each in (one, other)]
        if all(inside):
            return True
        known = known or any(inside)
    return False if known else None


def _networks():
    """The IPv4 networks of this host's interfaces."""
    found = []
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
        for _, name in socket.if_nameindex():
            request = struct.pack("256s", name.encode()[:15])
            try:
                address, mask = [socket.inet_ntoa(fcntl.ioctl(any_socket, number, request)[20:24])
                                 for number in (SIOCGIFADDR, SIOCGIFNETMASK)]
            except OSError:  # it has no such address, or this is no Linux
                continue
            found.append(ipaddress.ip_interface(f"{address}/{mask}").network)
    return found


def _numeric(offered):
    """The IP addresses of (host, port)s, where they can be looked up."""
    found = []
    for host in sorted({host for host, _ in offered if host}):
        try:
            found += addresses.resolve(host)
        except errors.Error:
            pass
    return found


def _is_loopback(host):
    return host == "localhost" or addresses.is_loopback(host)


def _another_address(home):
    return remedies.words("another address", host=printable(home) or "ADDRESS")
