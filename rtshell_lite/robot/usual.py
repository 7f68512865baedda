"""Name servers and managers at the usual TCP ports of this host, for people who do not know what theirs is
called.
"""

import os

from rtshell_lite import errors
from rtshell_lite.net import loop
from rtshell_lite.path import DEFAULT_PORT, MANAGER_PORT, parse
from rtshell_lite.robot import tree

HOST = "localhost"
PORTS = (DEFAULT_PORT, 9876, 15005)  # of omniNames, of OpenRTM-aist 1.0 and before, of hrpsys
MANAGERS = (MANAGER_PORT,)


async def advice():
    """A line that names what is found where no name server is named and the usual one does not answer, or
    None.
    """
    if os.environ.get("RTCTREE_NAMESERVERS", "").strip():
        return None
    usual, *others = ["%s:%d" % (HOST, port) for port in PORTS]
    if await _answering([usual]):
        return None
    answering = await _answering(others + ["corbaloc:iiop:%s:%d/manager" % (HOST, port) for port in MANAGERS])
    where = f"no name server answers at {usual}"
    if answering:
        names = ", ".join(answering)
        return f"{where}; found on this host: {names}; try: export RTCTREE_NAMESERVERS={answering[0]}"
    ports = ", ".join(str(port) for port in PORTS[1:] + MANAGERS)
    return f"{where}, nor at TCP ports {ports} of this host; on another host: rtls HOST"


async def _answering(addresses):
    """Those of some addresses at which a name server or a manager answers."""
    answers = await loop.each(addresses, _answers)
    return [address for address, answer in zip(addresses, answers) if answer is True]


async def _answers(address):
    """Whether a name server or a manager answers at an address."""
    if address.startswith("corbaloc:"):
        return (await tree.resolve(parse(address))).kind == "manager"
    try:
        return not await tree.name_server(address).call("_non_existent")
    except errors.Unanswered:
        return True  # there is one, which hangs
