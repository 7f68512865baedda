"""What the addresses that references publish mean:
to this host, and to the one where the references are bound.
"""

from rtshell_lite import errors
from rtshell_lite.corba import orb, refusals
from rtshell_lite.net import hosts
from rtshell_lite.doctor import addresses, remedies
from rtshell_lite.doctor.finding import fail, published, warn
from rtshell_lite.text import printable


async def misled(check, where, ref, homes, elsewhere=""):
    """The Finding on an object that publishes addresses at which others do not find it, or None.

    After a failure nothing else can be found out about the object from here; after a warning, its callers go
    on, as they may find worse.

    homes      IP addresses of what knows the object: the name server that it is bound in, its manager, the
               near end of a connection
    elsewhere  an address of another host that takes part in the system, '' if all of it is on one
    """
    offered = orb.addresses(ref)
    here = any(addresses.is_own(home) for home in homes)
    if not offered or not homes:
        return None
    shown = await published(ref)
    if all(addresses.is_incomplete(host) for host, _ in offered):
        message = f"publishes {shown}, of one link only (IPv6), which means nothing without an interface"
        return fail(check, where, message, _another_address(homes[0]))
    if all(_is_loopback(host) for host, _ in offered):
        if all(addresses.is_loopback(home) for home in homes):
            message = (
                f"publishes {shown}: only this host can reach it, and {printable(elsewhere)} takes part in "
                "the system"
            )
            if elsewhere:
                return warn(check, where, message, _another_address(""))
            return None
        if here:
            return warn(
                check, where, f"publishes {shown}: only this host can reach it", _another_address(homes[0])
            )
        return fail(
            check, where, f"publishes {shown}, which means this host, not its own", _another_address(homes[0])
        )
    if all(addresses.is_loopback(home) for home in homes):
        return None  # it is known on this host; whether others know it cannot be seen
    numeric = await _numeric(offered)
    if not await is_apart(ref, homes):
        return None
    if here:  # an address of another interface is one of this host
        if not elsewhere or not all(addresses.is_own(address) for address in numeric):
            return None
        message = (
            f"publishes {shown}, of another network than {homes[0]}: what finds it there may not reach it"
        )
        return warn(check, where, message, _another_address(homes[0]))
    if any(addresses.is_own(address) for address in numeric):
        message = f"publishes {shown}, which means this host, too: it is of another network than {homes[0]}"
        return fail(check, where, message, _another_address(homes[0]))
    return None


async def is_certain(ref, homes):
    """True if the addresses of `ref` mean the same host here as to what published them."""
    for host, _ in orb.addresses(ref):
        if host and not await refusals.means_the_same(host, homes):
            return False
    return True


async def names_here(ref, homes):
    """The host names in `ref` that mean this host here, and may mean another to `homes`: its process may run
    there.
    """
    own = []
    for host, _ in orb.addresses(ref):
        if not host or host == "localhost" or addresses.is_numeric(host):
            continue
        try:
            if await refusals.means_the_same(host, homes):
                continue
        except errors.Unanswered:  # nobody says what the name means
            continue
        if any(addresses.is_own(address) for address in await _numeric([(host, 0)])):
            own.append(host)
    return own


async def is_apart(ref, homes):
    """True if all addresses that `ref` publishes are known to be of other networks than `homes`."""
    own = await _numeric(orb.addresses(ref))
    return bool(own) and all(hosts.together(home, address) is False for address in own for home in homes)


async def homes_of(ref):
    """The IP addresses that a reference publishes."""
    return await _numeric(orb.addresses(ref))


async def outside(refs):
    """The first address that references publish which is not of this host; '' if all are."""
    for host in dict.fromkeys(host for ref in refs for host, _ in orb.addresses(ref)):
        if host and not await _is_here(host):
            return host
    return ""


async def _is_here(host):
    return _is_loopback(host) or any(addresses.is_own(address) for address in await _numeric([(host, 0)]))


async def _numeric(offered):
    """The IP addresses of (host, port)s that can be looked up."""
    numeric = []
    for host in sorted({host for host, _ in offered if host}):
        try:
            numeric += await addresses.resolve(host)
        except errors.Error:
            pass
    return numeric


def _is_loopback(host):
    return host == "localhost" or addresses.is_loopback(host)


def _another_address(home):
    return remedies.words("another address", host=printable(home) or "ADDRESS")
