"""Our objects that components call, such as receivers of data. None of them is bound in a name server.

A servant is any object with a method for each operation of its `interface`, named as in giop/idl.py.
"""

import os

from rtshell_lite.corba import orb, session
from rtshell_lite.giop import ior, references
from rtshell_lite.net import loop
from rtshell_lite.text import printable


class InPortCdr:
    """Receives what an out port pushes by corba_cdr: take(nanoseconds since 1970, bytes) is called for each
    value, unless is_full().

    With omniORB, `put` runs on a thread: is_full must only look, and omniorb.py replaces `take` by a function
    that appends to a queue, from which the loop takes the values (`pass_on`: now) until `hurry` is called.
    """

    interface = "OpenRTM.InPortCdr"
    statuses = "OpenRTM.PortStatus"

    def __init__(self, take, is_full):
        self.take = take
        self.is_full = is_full
        self.done, _, self.full = orb.items(self.statuses)[:3]

    def put(self, data):
        if self.is_full():
            return self.full
        self.take(int(loop.wall() * 1e9), data)
        return self.done

    def pass_on(self):
        """Have what waits in the queue taken now."""

    def hurry(self):
        """Have what waits in the queue taken now, and from now on each value before its sender is answered;
        our own ORB always does so.
        """


class DataPushService(InPortCdr):
    """Receives what an out port pushes by data_service, as InPortCdr does."""

    interface = "RTC.DataPushService"
    statuses = "RTC.PortStatus"
    push = InPortCdr.put


RECEIVERS = {"corba_cdr": InPortCdr, "data_service": DataPushService}


class Served:
    """A servant that can be called until `withdraw`, from when on callers get OBJECT_NOT_EXIST."""

    def __init__(self, servant):
        self.servant = servant
        self.reference, self.withdraw = orb.serve(servant)

    async def ior(self, peer):
        """The stringified reference for the process at `peer`, (host, port), with the address of this host
        that it can reach: an ORB does not know which of them that is. Looks up the peer's name. Raises
        Unanswered if that takes too long.
        """
        type_id, host, port, key = ior.address(self.reference)
        if host and _address_given():
            return self.reference
        world = loop.world()
        own = await session.on_thread(printable(peer[0]), lambda: world.own_address(*peer))
        if own is None and host:
            return self.reference
        reference = references.make_reference(own or world.host_name(), port, key, type_id=type_id.encode())
        return reference.text()


def _address_given():
    """True if the user sets what the ORB publishes, for NAT say."""
    is_variable = any(name.startswith("ORBendPoint") for name in os.environ)
    return is_variable or "ORBendPoint" in os.environ.get("RTCTREE_ORB_ARGS", "")
