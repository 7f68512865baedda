"""A mock's end of CORBA: one ORB, and one object adapter through which every call to every object passes."""
import itertools
import struct
import sys
import threading

from omniORB import CORBA, PortableServer, PortableServer__POA

from . import carrier
from .counting import MINORS, Ledger


class Locator(PortableServer__POA.ServantLocator):
    """Finds the servant for each call, `_non_existent` and `_is_a` included, and has the ledger note it."""

    def __init__(self, ledger):
        self.ledger = ledger
        self.objects = {}                       # object id -> (servant, owner, whether it exists just now)

    def preinvoke(self, oid, poa, operation):
        entry = self.objects.get(oid)
        if entry is None or not entry[2]():
            raise CORBA.OBJECT_NOT_EXIST(MINORS["OBJECT_NOT_EXIST"], CORBA.COMPLETED_NO)
        suffer = self.ledger.begin(entry[1], operation)
        if suffer is None:
            return entry[0], None
        if not operation.startswith("_"):
            return suffering(entry[0], suffer), None
        try:
            suffer()
        except Exception:
            self.ledger.end()
            raise
        return entry[0], None

    def postinvoke(self, oid, poa, operation, cookie, servant):
        self.ledger.end()


class Process:
    """The ORB of this process and the objects that it serves."""

    def __init__(self, port=0, host="127.0.0.1", publish=None):
        """`publish` is the address in references, if it is not the one on which the process listens."""
        published = ["-ORBendPointPublish", f"giop:tcp:{publish}:{port}"] if publish else []
        self.orb = CORBA.ORB_init(
            [sys.argv[0], "-ORBendPoint", f"giop:tcp:{host}:{port or ''}"]
            + published
            + [
                "-ORBtraceLevel",
                "0",
                # as components that send images need it
                "-ORBgiopMaxMsgSize",
                str(32 << 20),
            ],
            CORBA.ORB_ID,
        )
        self.ledger = Ledger()
        self.near_misses = 0            # see transport.Sender
        self.locator = Locator(self.ledger)
        self.arrived = threading.Condition()    # notified when an InPort has received something
        self.components = {}                    # instance name -> component that lives here
        self.ids = itertools.count(1)
        root = self.orb.resolve_initial_references("RootPOA")
        root._get_the_POAManager().activate()
        self.poa = root.create_POA("mocks", root._get_the_POAManager(), [
            root.create_servant_retention_policy(PortableServer.NON_RETAIN),
            root.create_request_processing_policy(PortableServer.USE_SERVANT_MANAGER),
            root.create_id_assignment_policy(PortableServer.USER_ID)])
        self.poa.set_servant_manager(self.locator._this())
        self.keys = self.orb.resolve_initial_references("omniINSPOA")
        self.keys._get_the_POAManager().activate()
        self.endpoint = self.address(self.ghost("IDL:omg.org/CORBA/Object:1.0"))

    def serve(self, servant, owner, exists=lambda: True):
        """Make a servant callable; its reference, with the type id of the servant's class."""
        oid = b"%d" % next(self.ids)
        self.locator.objects[oid] = (servant, owner, exists)
        servant.oid = oid
        return self.poa.create_reference_with_id(oid, servant._NP_RepositoryId)

    def withdraw(self, servant):
        """The object is gone: calls get OBJECT_NOT_EXIST."""
        self.locator.objects.pop(servant.oid, None)

    def ghost(self, type_id):
        """A reference of that type to nothing."""
        return self.poa.create_reference_with_id(b"%d" % next(self.ids), type_id)

    def serve_key(self, servant, key, owner):
        """Make a servant callable under a readable key too; of these calls, `_non_existent` and `_is_a` are
        not counted.
        """
        oid = key.encode("latin-1")
        try:
            self.keys.activate_object_with_id(oid, stand_in(servant, self.ledger, owner))
        except PortableServer.POA.ObjectAlreadyActive:
            return None                 # it stays with the first
        return self.keys.id_to_reference(oid)

    def withdraw_key(self, key):
        self.keys.deactivate_object(key.encode("latin-1"))

    def local_servant(self, reference):
        """The servant behind a reference of this process, or None."""
        try:
            return self.locator.objects.get(self.poa.reference_to_id(reference), (None,))[0]
        except (PortableServer.POA.WrongAdapter, PortableServer.POA.WrongPolicy, CORBA.SystemException):
            return None

    def thread(self, target, *args):
        """Start a daemon thread whose calls are the mock's own."""
        def run():
            self.ledger.own_thread()
            target(*args)
        started = threading.Thread(target=run, daemon=True)
        started.start()
        return started

    def later(self, seconds, function, *arguments):
        """Call a function from a thread of its own, in a while."""
        timer = threading.Timer(seconds, function, arguments)
        timer.daemon = True
        timer.start()

    def die(self):
        """End at once, all names left bound, as a crash does."""
        carrier.die()

    def text(self, reference):
        """A reference as a stringified IOR."""
        return self.orb.object_to_string(reference)

    def reference(self, text):
        """The reference in a stringified IOR or a corbaloc. Raises SystemException."""
        return self.orb.string_to_object(text)

    def address(self, reference):
        """HOST:PORT of an object."""
        return "%s:%d" % address(self.text(reference))


def address(ior):
    """Host and port out of a stringified reference: type id, number of profiles, tag, then the IIOP profile.
    """
    data = bytes.fromhex(ior[4:])
    order = "<" if data[0] else ">"

    def at(offset, boundary=4):
        return (offset + boundary - 1) // boundary * boundary

    length = struct.unpack_from(order + "I", data, 4)[0]
    profile = at(8 + length) + 12                    # past the number of profiles, the tag and the length
    size = struct.unpack_from(order + "I", data, profile + 4)[0]
    host = data[profile + 8:profile + 8 + size - 1].decode()
    return host, struct.unpack_from(order + "H", data, at(profile + 8 + size, 2))[0]


def stand_in(servant, ledger, owner):
    """A servant that notes each call and passes it on, for object adapters that know nothing of the ledger.
    """
    def passed_on(operation):
        def call(self, *args):
            suffer = ledger.begin(owner, operation)
            try:
                if suffer:
                    suffer()
                return getattr(servant, operation)(*args)
            finally:
                ledger.end()
        return call
    return _like(servant, passed_on)


def suffering(servant, suffer):
    """A servant that passes calls on after `suffer`.

    A locator that waited would keep omniORB from reading the next call on the connection; a servant that
    waits does not.
    """
    def passed_on(operation):
        def call(self, *args):
            suffer()
            return getattr(servant, operation)(*args)
        return call
    return _like(servant, passed_on)


def _like(servant, passed_on):
    lineage = type(servant).__mro__
    skeleton = next(kind for kind in lineage if "_omni_op_d" in vars(kind))
    operations = {name for kind in lineage for name in vars(kind).get("_omni_op_d", ())}
    return type("StandIn", (skeleton,), {name: passed_on(name) for name in operations})()
