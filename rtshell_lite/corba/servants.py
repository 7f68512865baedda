"""Our objects that components call, such as receivers of data. None of them is bound in a name server."""
import os
import socket
import struct
import time

from omniORB import CORBA
from rtshell_lite import errors
from rtshell_lite.corba import omni, orb
from rtshell_lite.idl_stubs.dataport import RTC, RTC__POA, OpenRTM, OpenRTM__POA


class InPortCdr(OpenRTM__POA.InPortCdr):
    """Receives what an out port pushes by corba_cdr, and passes (nanoseconds since 1970, bytes) to a function."""

    def __init__(self, take):
        self.take = take

    def put(self, data):
        self.take(int(time.time() * 1e9), data)
        return OpenRTM.PORT_OK


class DataPushService(RTC__POA.DataPushService):
    """Receives what an out port pushes by data_service, likewise."""

    def __init__(self, take):
        self.take = take

    def push(self, data):
        self.take(int(time.time() * 1e9), data)
        return RTC.PORT_OK


RECEIVERS = {"corba_cdr": InPortCdr, "data_service": DataPushService}


class Served:
    """A servant that can be called until `withdraw`."""

    def __init__(self, servant):
        try:
            self.poa = omni.start().resolve_initial_references("RootPOA")
        except CORBA.INITIALIZE:  # only now omniORB begins to listen
            raise errors.Usage("this machine cannot be reached at the address that ORBendPoint tells")
        self.id = self.poa.activate_object(servant)
        self.reference = self.poa.id_to_reference(self.id)
        self.type_id = servant._NP_RepositoryId
        self.poa._get_the_POAManager().activate()

    def withdraw(self):
        """From now on callers get OBJECT_NOT_EXIST."""
        self.poa.deactivate_object(self.id)

    def ior(self, peer):
        """The stringified reference for the process at `peer`, (host, port), with the address of this host that it can reach:
        omniORB itself puts the first address that it finds into all references. Looks up the peer's name.
        """
        own = None if _endpoint_given() else own_address(*peer)
        if own is None:
            return omni.start().object_to_string(self.reference)
        _, _, port, key = orb.address(self.reference)
        return make_ior(self.type_id, own, port, key)


def _endpoint_given():
    """True if the user sets what omniORB publishes, for NAT say."""
    return "ORBendPoint" in os.environ.get("RTCTREE_ORB_ARGS", "") or any(name.startswith("ORBendPoint") for name in os.environ)


def own_address(host, port):
    """The address of this machine that faces `host`, None if there is no route. Sends nothing."""
    try:
        found = socket.getaddrinfo(host, port, 0, socket.SOCK_DGRAM)
    except (OSError, UnicodeError):
        return None
    for family, kind, protocol, _, place in found:
        try:
            with socket.socket(family, kind, protocol) as probe:
                probe.connect(place)
                return probe.getsockname()[0]
        except OSError:
            continue
    return None


def make_ior(type_id, host, port, key):
    """A stringified reference with one IIOP 1.2 profile (CORBA 3.0, 13.6)."""
    def octets(data):
        return struct.pack(">L", len(data)) + data

    def aligned(data, size):
        return data + b"\0" * (-len(data) % size)

    profile = aligned(b"\0\1\2\0" + octets(host.encode() + b"\0"), 2) + struct.pack(">H", port)
    profile = aligned(aligned(profile, 4) + octets(key), 4) + struct.pack(">L", 0)
    head = aligned(b"\0\0\0\0" + octets(type_id.encode() + b"\0"), 4)
    return "IOR:" + (head + struct.pack(">LL", 1, 0) + octets(profile)).hex()
