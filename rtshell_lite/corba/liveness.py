"""What a refused connection proves.

On this host, that nothing listens there: the process is gone. Another host may refuse because of a firewall,
which answers with a reset, or with an ICMP message that the port is unreachable. There, the process counts as
gone only while another process of that host answers at another port above 1023. A name server does not count:
firewalls often let its port alone through.
"""

import time

from rtshell_lite import errors
from rtshell_lite.corba import hosts, session

PRIVILEGED = 1023  # the highest port that only root may listen at
AT_THE_SAME_TIME = 3  # times the timeout


async def is_gone(endpoint):
    """Whether the process at `endpoint`, (host, port), which has refused a connection,
    is known to be gone.
    """
    return await is_this_host(endpoint[0]) or bool(_witnesses(endpoint))


async def shows_death(e, endpoint):
    """Whether an errors.Error of a call to an object at `endpoint` shows that the object is gone."""
    return isinstance(e, errors.Gone) or isinstance(e, errors.ConnectionRefused) and await is_gone(endpoint)


async def refusal(where, endpoint):
    """The errors.ConnectionRefused for an object at `endpoint` that says what is known."""
    if await is_gone(endpoint):
        return errors.ProcessGone(str(where))
    return errors.MaybeGone(str(where))


def _witnesses(endpoint):
    """The endpoints of other processes of its host that have answered."""
    host, port = endpoint
    now = session.current()
    since = time.monotonic() - AT_THE_SAME_TIME * now.timeout
    return [
        other
        for other, when in now.answered.items()
        if other[0] == host
        and other[1] not in (port, None)
        and other[1] > PRIVILEGED
        and other not in now.name_servers
        and when >= since
    ]


async def is_this_host(host):
    """Whether a host, a name or an IP address, is this one."""
    if host == "localhost":
        return True
    found = await session.on_thread(host, lambda: hosts.places(host))
    return any(is_own(place[0]) for *_, place in found)


def is_own(address):
    """Whether an IP address is one of this host: a UDP socket can be bound there."""
    import socket  # takes long, and few need it

    if ":" in address:
        family = socket.AF_INET6
    else:
        family = socket.AF_INET
    try:
        with socket.socket(family, socket.SOCK_DGRAM) as own:
            own.bind((address.partition("%")[0], 0))
    except OSError:
        return False
    return True
