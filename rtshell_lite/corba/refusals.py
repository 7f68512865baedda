"""What a refused connection proves.

On this host, that nothing listens there: the process is gone. Another host may refuse because of a firewall,
for this one port: that proves nothing. Nor does an address that means this host here, but may mean another
one where the reference was published: a loopback address, or one of a private network that is not that of
the name server.
"""

from rtshell_lite import errors
from rtshell_lite.corba import session
from rtshell_lite.net import hosts, loop


async def is_gone(endpoint, home=None):
    """Whether the process at `endpoint`, (host, port), which has refused a connection, is known to be gone.

    home  the host of the name server, or process, that has given the endpoint; None for this one
    """
    try:
        if not await is_this_host(endpoint[0]):
            return False
        return home is None or await means_the_same_to(endpoint[0], home)
    except errors.Unanswered:  # nobody says what the name of a host means: that proves nothing
        return False


async def shows_death(e, endpoint, home=None):
    """Whether an errors.Error of a call to an object at `endpoint` shows that the object is gone; for `home`
    see `is_gone`.
    """
    if isinstance(e, errors.ConnectionRefused):
        return await is_gone(endpoint, home)
    return isinstance(e, errors.Gone)


async def refusal(where, endpoint, home=None):
    """The errors.ConnectionRefused for an object at `endpoint` that says what is known."""
    if await is_gone(endpoint, home):
        return errors.ProcessGone(str(where))
    return errors.MaybeGone(str(where))


async def means_the_same_to(host, home):
    """`means_the_same` to another host, a name or an IP address."""
    return await means_the_same(host, await _addresses(home))


async def means_the_same(host, homes):
    """Whether a host means the same one here as at `homes`, the IP addresses of another host, or of this one.

    Addresses of private networks may not, nor may a name that means this host here, and is not its own.
    """
    is_here = any(is_own(home) for home in homes)
    if is_here and (_is_address(host) or _is_own_name(host)):
        return True
    import ipaddress  # takes long, and few need it

    numbers = await _addresses(host)
    if not _is_address(host) and any(is_own(address) for address in numbers):
        return False
    if is_here:
        return True
    for address in numbers:
        is_private = ipaddress.ip_address(address.partition("%")[0]).is_private
        if is_private and not any(hosts.together(home, address) for home in homes):
            return False
    return True


async def is_this_host(host):
    """Whether a host, a name or an IP address, is this one."""
    return host == "localhost" or any(is_own(address) for address in await _addresses(host))


async def _addresses(host):
    """The IP addresses of a host, [] for one that is not known. Raises Unanswered."""
    resolved = await session.on_thread(host, lambda: hosts.resolve(host))
    return [address[0] for *_, address in resolved]


def _is_own_name(host):
    """Whether a host is called as this one calls itself, with or without its domain."""
    own = loop.world().host_name()
    return host == "localhost" or host.partition(".")[0].lower() == own.partition(".")[0].lower()


def _is_address(host):
    """Whether a host is an IP address, and not a name."""
    return ":" in host or not host.strip("0123456789.")


def is_own(address):
    """Whether an IP address is one of this host."""
    return loop.world().is_own(address)
